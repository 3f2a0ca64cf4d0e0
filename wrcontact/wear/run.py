"""Wear to a mileage: simulate, wear the profiles by a step, simulate with the worn ones, and so on."""

from collections.abc import Callable
from copy import copy
from typing import Any, NamedTuple

import numpy as np

from ..conventions import SIDES
from ..methods.numbers import check_choice
from ..progress import working
from ..system import ContactSystem
from ..wheel import WheelContact
from .accumulate import Wear
from .laws import law_of
from .rows import whole_of
from .shape import WheelShape, rolling_conicity, wheel_shape
from .steps import WearRun, WearStep
from .store import Store
from .update import moved_places, worn_profile

#: Steps of a run at most, and share of the mileage below which a last step is not worth a simulation.
MOST_STEPS, LEAST = 10_000, 1e-9
OPTIONS = ("method", "mirrored", "bin_width", "store")
#: Ways to go a step: with the wear of the profiles half-way, or with that of those at its beginning.
METHODS = ("midpoint", "euler")


def wear_run(
    simulate: Callable[[Any], Any],
    system: ContactSystem | WheelContact,
    law: Any,
    mileage: float,
    depth_step: float = 1e-4,
    *,
    part: str = "wheel",
    smoothing: float = 1e-3,
    **options: Any,
) -> WearRun:
    """Wear the wheels, or the rails, of a ``system`` to a ``mileage``: a :class:`WearRun`.

    The system is a :class:`~wrcontact.ContactSystem`, or a :class:`~wrcontact.WheelContact` for one wheel.

    Parameters
    ----------
    simulate : function of a system, called with the worn one at every step.  It returns a table of states;
        or (table, distance), the distance [m] that each row stands for; or a list of such pairs, the sections
        of a route; or a :class:`~wrcontact.Wear` to which it has added its results, as a file of an FMU.
    law : as for :class:`~wrcontact.Wear`.
    mileage : [m]; of rails the number of passages.
    depth_step : largest depth of a step before it is smoothed [m], 1e-6 ... 1e-3.
    part : "wheel" or "rail".
    smoothing : of the depth over arc [m], see :meth:`wrcontact.Wear.worn`.
    options : ``method``, "midpoint", which simulates a step twice, at its beginning and with profiles worn by
        half of it, whose wear then counts; or "euler", once, with an error of first order.  ``mirrored`` and
        ``bin_width`` of :class:`~wrcontact.Wear`.  ``store``, a folder in which a run is kept, so that it
        continues after an interruption, or to a larger mileage.

    Raises
    ------
    ValueError
        in one sentence, if an argument is not permitted or the store is of another run.
    """
    if not callable(simulate):
        raise ValueError(
            f"simulate is {simulate!r}; permitted is a function of a system that returns a table"
        )
    check_choice("part", part, ("wheel", "rail"))
    if not (np.isfinite(mileage) and mileage > 0.0):
        raise ValueError(f"mileage is {mileage!r}; permitted is mileage > 0")
    if not 1e-6 <= depth_step <= 1e-3:
        raise ValueError(f"depth_step is {depth_step!r} m; permitted is 1e-06 ... 0.001 m")
    for name in options:
        check_choice("a keyword of wear_run", name, OPTIONS)
    check_choice("method", options.get("method", METHODS[0]), METHODS)
    plan = Plan(
        simulate, law_of(law), part, profiles_of(system, part), mileage, depth_step, smoothing, options
    )
    return WearRun(tuple(_steps(plan, Store(options.pop("store", None), plan, system), system)), part)


def _steps(plan, store, system):
    """All steps to the mileage, those that the ``store`` has already first."""
    steps, worn = store.read()
    system = with_profiles(system, plan.part, worn) if worn else system
    with working("wear", round(plan.mileage)) as advance:
        advance(round(_reached(steps)))
        while not steps or steps[-1].length > 0.0:
            step, worn = plan.step(system, steps)
            steps.append(step)
            store.write(step, worn, len(steps) - 1)
            advance(round(step.length))
            if worn:
                system = with_profiles(system, plan.part, worn)
            if len(steps) > MOST_STEPS:
                raise ValueError(
                    f"mileage is {plan.mileage:g}, which needs more than {MOST_STEPS} steps of "
                    f"{plan.depth_step:g} m; permitted are larger steps, or less mileage"
                )
    return steps


def _reached(steps):
    """Distance behind the last of the steps."""
    return steps[-1].distance + steps[-1].length if steps else 0.0


class Plan(NamedTuple):
    """What all steps of a run have in common; ``new`` are the profiles at its beginning, by side."""

    simulate: object
    law: object
    part: str
    new: dict
    mileage: float
    depth_step: float
    smoothing: float
    options: dict

    @property
    def names(self):
        """What wears, by side, in the words of :class:`~wrcontact.Wear`; one wheel has the name alone."""
        return {side: self.part if len(self.new) == 1 else f"{side}.{self.part}" for side in self.new}

    def step(self, system, steps):
        """The next :class:`WearStep`, and the worn profiles behind it by side; None at the end."""
        done, profiles = _reached(steps), profiles_of(system, self.part)
        shapes = {side: self.shape(profile, side, steps) for side, profile in profiles.items()}
        rolls = self.part == "wheel" and isinstance(system, ContactSystem)
        conicity = rolling_conicity(system) if rolls else np.nan
        left = self.mileage - done
        if not left > LEAST * self.mileage:
            nothing = {side: (np.array([0.0, 1e-9]), np.zeros(2)) for side in self.new}
            return WearStep(
                done, 0.0, profiles, nothing, dict.fromkeys(self.new, 0.0), shapes, conicity, {}, 0
            ), None
        wear = self.filled(self.simulate(system), system)
        names = self.names
        arcs = {side: wear.arc(name) for side, name in names.items()}
        deepest = max(np.max(wear.depth(name)[1]) for name in names.values())  # before it is smoothed
        length = min(left, self.depth_step / deepest) if deepest > 0.0 else left
        depth = {side: wear.smooth_depth(name, self.smoothing) * length for side, name in names.items()}
        if self.options.get("method", METHODS[0]) == "midpoint":
            wear, depth = self.halfway(system, arcs, depth, length)
        worn = {side: worn_profile(arcs[side], depth[side]) for side in names}
        # places in the profile's own frame, also of an inclined rail
        where = {side: (arc.own_places, depth[side]) for side, arc in arcs.items()}
        taken = {side: float(np.sum(depth[side]) * arcs[side].width) for side in names}
        shares = {side: wear.shares(name) for side, name in names.items()}
        return WearStep(
            done, float(length), profiles, where, taken, shapes, conicity, shares, wear.left_out
        ), worn

    def halfway(self, system, arcs, depth, length):
        """Wear of the profiles after half of a step, and the depth of the whole one by it, at the same points
        of the material."""
        worn = {side: worn_profile(arcs[side], 0.5 * depth[side]) for side in arcs}
        middle = with_profiles(system, self.part, worn)
        wear, found = self.filled(self.simulate(middle), middle), {}
        for side, name in self.names.items():
            places = moved_places(arcs[side], 0.5 * depth[side], worn[side])
            found[side] = (
                wear.arc(name).interpolated(wear.smooth_depth(name, self.smoothing), places) * length
            )
        return wear, found

    def shape(self, profile, side, steps):
        """The :class:`~wrcontact.wear.WheelShape` after these steps; of rails only the worn area."""
        area = sum(step.taken[side] for step in steps)
        if self.part == "wheel":
            return wheel_shape(profile, self.new[side], area)
        return WheelShape(*[np.nan] * (len(WheelShape.__dataclass_fields__) - 1), area)

    def filled(self, found, system):
        """What ``simulate`` has returned, as a :class:`~wrcontact.Wear`."""
        if isinstance(found, Wear):
            return found
        wear = Wear(
            system, self.law, **{name: value for name, value in self.options.items() if name != "method"}
        )
        for section in found if isinstance(found, list) else [found]:
            wear.add(*(section if isinstance(section, tuple) else (section,)))
        return wear


def profiles_of(system, part):
    """Wheels or rails of a system by side."""
    whole, side = whole_of(system)
    both = (whole.left_wheel, whole.wheel) if part == "wheel" else (whole.left_rail, whole.rail)
    return dict(zip(SIDES, both)) if side is None else {side: both[1]}


def with_profiles(system, part, profiles):
    """The same system with other wheels or rails by side; as a copy is made, without the remarks that the
    user has read."""
    if isinstance(system, WheelContact):
        (profile,) = profiles.values()
        wheel = copy(system)
        wheel.system = with_profiles(system.system, part, dict.fromkeys(SIDES, profile))
        return wheel
    rebuilt, (kind, parameters, (wheel, rail, left_wheel, left_rail)) = system.__reduce__()
    left, right = (profiles[side] for side in SIDES)
    left = right if left == right else left
    if part == "wheel":
        wheel, left_wheel = right, left
    else:
        rail, left_rail = right, left
    parameters = {
        **parameters,
        "wheel": wheel,
        "rail": rail,
        "left_wheel": left_wheel,
        "left_rail": left_rail,
    }
    return rebuilt(kind, parameters, (wheel, rail, left_wheel, left_rail))
