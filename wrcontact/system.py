"""A wheelset on its track: what is fixed, prepared once; poses are evaluated against it.

>>> import wrcontact
>>> system = wrcontact.ContactSystem(wheel="S1002", rail="UIC60", rail_inclination=1/40)
>>> state = system.evaluate(lateral_shift=1e-3, yaw=0.0, normal_force=78.5e3)
>>> state.status, round(state.right.contact.y_wheel, 6)
(<Status.VALID: 0>, -0.009357)
"""

from __future__ import annotations

import math
import threading
from collections.abc import Iterable, Iterator
from copy import deepcopy
from functools import partial
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .interface.calls import (
    check_count,
    describe_inputs,
    describe_parameters,
    given_inputs,
    input_values,
    unknown_parameter,
    warn_of_inputs,
    write_inputs,
    wrong_input,
)
from .interface.friction import Friction
from .interface.inputs import INPUTS
from .interface.parameters import (
    PARAMETERS,
    RIGID_RAILS,
    Material,
    Track,
    Wheelset,
    checked_parameters,
    on_the_left,
    warn_of_parameters,
)
from .kernel import layout
from .kernel.binding.library import bind_changing
from .kernel.binding.own_models import OwnKernel
from .kernel.binding.setup import prepare_sides, profile_tables
from .kernel.prepare.tables import equal_sides
from .methods import Halfspace, HalfspaceRolling
from .methods.own import functions_in
from .motion.reaction import rail_reaction
from .motion.standing import stand_at
from .profiles.catalogue import find_profiles
from .profiles.changing import check_unplaced, has_changing, is_sections, refuse_changing
from .profiles.corners import remark_corners
from .profiles.plausible import remark_profiles
from .results.columns import selected
from .results.inputs import Rows
from .results.names import listed
from .state import Equilibrium, WheelsetState
from .status import Status
from .stepper import DEPTHS, Stepper, thread_count, threaded_parts

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .keywords import Depth, OneRail, OneWheel, PoseInputs, Sides, SystemKeywords, TableInputs, Wanted
    from .linear.record import Linearization
    from .profiles import Profile
    from .sections import RailSections, WheelSections
    from .sections.placing import PlacedSections

#: By number; making one from its number takes ten times as long.
STATUSES = tuple(Status)
#: The equilibrium's numbers as an FMU names them, and those of the elastic wheelset that stands there.
EQUILIBRIUM = {f"equilibrium.{name}": name for name in ("vertical_shift", "roll")}


class ContactSystem:
    """Wheel and rail profiles, track, material and methods of one wheelset.

    The numbers of track, wheelset, material and friction are keywords, or come together in a
    :class:`~wrcontact.Track`, :class:`~wrcontact.Wheelset`, :class:`~wrcontact.Material` or
    :class:`~wrcontact.Friction`.  A method is a string, with its numbers as keywords, or an object that holds
    them: ``normal_model=Analyn(tolerance=0.004)`` is ``normal_model="analyn", tolerance=0.004``.
    ``normal_model`` and ``tangential_model`` may also be functions of Python, which the uncompiled kernel calls,
    some hundred times slower (docs/guides/own_model.md).

    Parameters
    ----------
    wheel, rail : name of a standard profile in any case, path of a profile file,
        :class:`~wrcontact.ProfileFile` (a path with what the file does not say), or
        :class:`~wrcontact.Profile`.  These two, ``nominal_radius`` and ``rail_inclination`` may also be
        pairs (left, right), which is short for the keywords that begin with ``left_``.  A ``rail`` may also be
        :class:`~wrcontact.RailSections`, or the path of a file of sections, .slcs or .toml (docs/guides/sections.md); a
        ``wheel`` :class:`~wrcontact.WheelSections` (docs/guides/wheels.md).
    track, wheelset, material, friction : records of the keywords that follow, or None.
    {parameters}

    Attributes
    ----------
    parameters : the value of every keyword but the groups; methods are strings, or functions.
    methods : the object of every method, by its keyword.
    wheel, rail, left_wheel, left_rail : the profiles of the right and of the left side.

    Raises
    ------
    ValueError
        in one sentence with name, value, unit and permitted range or choices.
    """

    parameters: dict[str, Any]
    methods: dict[str, Any]
    resolution: Any
    wheel: Profile | WheelSections
    rail: Profile | RailSections
    left_wheel: Profile | WheelSections
    left_rail: Profile | RailSections

    def __init__(
        self,
        wheel: OneWheel | tuple[OneWheel, OneWheel] = "S1002",
        rail: OneRail | tuple[OneRail, OneRail] = "UIC60",
        *,
        track: Track | None = None,
        wheelset: Wheelset | None = None,
        material: Material | None = None,
        friction: Friction | None = None,
        **parameters: Unpack[SystemKeywords],
    ) -> None:
        for name in parameters.keys() - PARAMETERS.keys():
            raise unknown_parameter(name)
        groups = {"track": track, "wheelset": wheelset, "material": material, "friction": friction}
        given = {"wheel": wheel, "rail": rail, **parameters}
        checked, methods = checked_parameters(given, groups)
        warn_of_parameters(checked)
        if has_changing(checked):
            from .sections.placing import find_all_profiles  # not part of an FMU

            profiles = find_all_profiles(checked)
        else:
            profiles = find_profiles(checked)
        self._set_up(checked, methods, profiles)
        remark_profiles(self)
        remark_corners(self)

    def _set_up(self, parameters, methods, profiles):
        """Prepare for checked ``parameters`` and the ``profiles`` that they name."""
        check_unplaced(profiles, parameters)
        self.parameters, self.methods = parameters, methods
        self.resolution = methods["normal_model"].resolution
        self.wheel, self.rail, self.left_wheel, self.left_rail = profiles
        self._placed = None  # the left and the right rail, if one of them changes along the track
        if has_changing(parameters):
            from .sections.placing import prepare_changing  # not part of an FMU

            self._tables, self._placed = prepare_changing(profiles, parameters, methods)
        else:
            self._tables = prepare_sides(profiles[:2], profiles[2:], parameters=parameters, methods=methods)
        layout.Tables.at(self._tables).stations = parameters["stations"]
        self._own = threading.local()
        self._warned = set()  # names of inputs of which the user has been warned
        self._elastic = None  # the same wheelset in elastic contact, once it is needed
        # what finds the equilibrium of a state
        self._balancing = self if parameters["contact_mode"] == "compliant" else None

    @property
    def equal_sides(self) -> bool:
        """Whether the left side is the mirror image of the right one."""
        if self._placed and self._placed[0] is not self._placed[1]:
            return False
        if self.wheel is not self.left_wheel and (is_sections(self.wheel) or is_sections(self.left_wheel)):
            return False
        return equal_sides(layout.Tables.at(self._tables))

    @property
    def changing(self) -> bool:
        """Whether the section of a rail changes along the track."""
        return self._placed is not None

    @property
    def placed_rails(self) -> tuple[PlacedSections, PlacedSections]:
        """The left and the right rail as they lie in the track, each with ``surface`` and ``lateral``; ValueError if none
        changes along the track."""
        if self._placed is None:
            raise ValueError(
                "no rail changes along the track; permitted for placed_rails is a system with RailSections"
            )
        return self._placed

    @property
    def centre_height(self) -> float:
        """Height of the wheelset's centre above the running circles [m]: the mean of both nominal radii."""
        return layout.Tables.at(self._tables).height

    @property
    def title(self) -> str:
        """The names of the profiles, "S1002 on UIC60", for headlines; of both sides where they differ."""
        names = [
            f"{wheel.name} on {rail.name}"
            for wheel, rail in ((self.left_wheel, self.left_rail), (self.wheel, self.rail))
        ]
        return names[1] if names[0] == names[1] else f"{names[0]} (left) and {names[1]} (right)"

    def side_parameters(self, side: Literal["left", "right"]) -> dict[str, Any]:
        """The value of every keyword as ``side``, "left" or "right", has it."""
        return on_the_left(self.parameters) if side == "left" else self.parameters

    def profile_tables(
        self, side: Literal["left", "right"] = "right"
    ) -> tuple[NDArray[Any], NDArray[Any], float]:
        """The profiles as the kernel reads them, for ``wrcontact.profiles.compiled.evaluate_table``: the
        wheel's table, that of the rail as it leans, and the track coordinate of the rail's highest point [m],
        each as those of a right side; ValueError if a rail changes along the track."""
        refuse_changing(self, "profile_tables")
        return profile_tables(self._tables, 0 if side == "left" else 1)

    def __reduce__(self):
        return _rebuilt, (
            type(self),
            self.parameters,
            (self.wheel, self.rail, self.left_wheel, self.left_rail),
        )

    def __repr__(self) -> str:
        changed = [
            f"{name}={value!r}"
            for name, value in self.parameters.items()
            if value != PARAMETERS[name].default
        ]
        return f"ContactSystem({', '.join(changed)})"

    def stepper(self, side: Sides = "both", outputs: Depth = "all") -> Stepper:
        """A new :class:`Stepper`: one wheelset that is moved in time, with its own memory.

        What is not wanted is not computed, and is NaN in its outputs.

        Parameters
        ----------
        side : "both", "left" or "right"; roll and vertical shift are there in any case.
        outputs : "all", "patches" (no outline), or "geometry" (contact point, angle, rolling radius,
            curvatures).
        """
        stepper = self._new_stepper()
        stepper.want(side, outputs)
        return stepper

    @property
    def _halfspace(self):
        """The tolerance of the half-space, and Poisson's ratio if creep forces follow by the complete theory,
        else None."""
        complete = isinstance(self.methods["tangential_model"], HalfspaceRolling)
        return self.parameters["tolerance"], self.parameters["poisson_ratio"] if complete else None

    def _new_stepper(self):
        if isinstance(self.methods["normal_model"], Halfspace):
            from .halfspace.stepping import halfspace_solver  # scipy is not needed before

            return Stepper(self._tables, halfspace_solver(*self._halfspace))
        if isinstance(self.methods["tangential_model"], HalfspaceRolling):
            from .halfspace.rolling_step import RollingSolver

            return Stepper(self._tables, partial(RollingSolver, self.parameters["poisson_ratio"]))
        if self.changing:
            return Stepper(self._tables, bind_changing)
        functions = functions_in(self.parameters)
        return Stepper(self._tables, OwnKernel(functions).bind if functions else None)

    def evaluate(
        self,
        *arguments: float,
        penetration: float | tuple[float, float] | None = None,
        side: Sides = "both",
        outputs: Wanted = "all",
        **inputs: Unpack[PoseInputs],
    ) -> WheelsetState:
        """The contact of both wheels at one pose.

        Parameters
        ----------
        {inputs}
        penetration : prescribe the penetration [m] instead of the force: one value, or (left, right); rigid
            contact only.
        side, outputs : what is wanted, as for :meth:`stepper`, or names of outputs as for
            :meth:`evaluate_many`; the rest is NaN.

        Returns
        -------
        WheelsetState
            with its :class:`~wrcontact.status.Status`.  With status 2, 3 or 4 all values are NaN; only a
            :class:`Stepper` and an FMU hold those of their last valid step.

        Warns
        -----
        UnusualValueWarning
            if a value is permitted but far outside what is usual: a force of 78500 kN.
        """
        if type(outputs) is not str or outputs not in DEPTHS:
            return self._evaluate_some(arguments, penetration, side, outputs, inputs)
        stepper = self._stepper_at(penetration, side, outputs, arguments, inputs)
        status = stepper.step()
        found = stepper.outputs.copy()
        if status > layout.UNLOADED:
            found[:] = math.nan
        return WheelsetState.of_pose(
            found, STATUSES[status], stepper.numbers.tobytes(), stepper.layout, self._balancing
        )

    def _stepper_at(self, penetration, side, outputs, arguments, inputs):
        """This thread's stepper with the inputs of a call, not stepped."""
        try:
            stepper = self._own.stepper
        except AttributeError:
            stepper = self._own.stepper = self.stepper()
        stepper.prescribe(penetration)
        stepper.want(side, outputs)
        write_inputs(stepper.numbers, arguments, inputs, self._warned)
        return stepper

    def derivatives(
        self,
        of: Iterable[str],
        by: Iterable[str],
        *,
        penetration: float | tuple[float, float] | None = None,
        **inputs: Unpack[PoseInputs],
    ) -> NDArray[Any]:
        """How outputs follow inputs at one pose, as the directional derivatives of an FMU.

        Parameters
        ----------
        of : names of outputs, such as ``["force.y", "right.area", "equilibrium.roll"]``.
        by : names of inputs, such as ``["lateral_shift", "left.friction"]``.
        penetration : as for :meth:`evaluate`.
        inputs : those of :meth:`evaluate`, by keyword.

        Returns
        -------
        array (len(of), len(by))
            SI; NaN where the step has status 2, 3 or 4.  With a rail that changes along the track, a wheel that is not round
            or a roller they are differences, within 1e-6, and NaN where a derivative jumps.

        Raises
        ------
        ValueError
            if there is no such output or input.
        RuntimeError
            if the kernel is not compiled, or a model works outside it.
        """
        names = listed("of", of)
        own = [name for name in names if name not in EQUILIBRIUM]
        stepper = self._stepper_at(penetration, "both", "all", (), inputs)
        rows = dict(zip(own, stepper.derivatives(own, by)))
        balanced = [name for name in names if name in EQUILIBRIUM]
        if balanced:
            stands = self._elastic_twin() if self._balancing else self
            rows |= zip(balanced, stands.derivatives([EQUILIBRIUM[name] for name in balanced], by, **inputs))
        return np.array([rows[name] for name in names])

    def stand_at(self, roll: float, **inputs: Unpack[PoseInputs]) -> Equilibrium:
        """The height at which a compliant wheelset stands at a given ``roll`` [rad], an
        :class:`~wrcontact.state.Equilibrium`: both wheels together carry the load.

        The ``equilibrium`` of a state has the roll too, at which each wheel carries its own.

        Parameters
        ----------
        inputs : those of :meth:`evaluate` by keyword: lateral_shift, yaw, normal_force, rails,
            track_position, wheel_rotation.

        Raises
        ------
        ValueError
            if the contact_mode is not compliant, or a roller runs beside a rail that changes along the track.
        """
        if self._balancing is None:
            raise ValueError(
                f"the contact_mode is {self.parameters['contact_mode']!r}; a roll can be given "
                "with 'compliant'"
            )
        return stand_at(self, roll, inputs)

    def linearize(
        self,
        *,
        amplitude: float = 0.0,
        yaw_amplitude: float = 0.0,
        frequency: float = 0.0,
        phases: int = 64,
        **inputs: Unpack[PoseInputs],
    ) -> Linearization:
        """The wheelset near a steady motion as matrices: a :class:`~wrcontact.linear.Linearization`.

        Its coordinates are lateral shift, vertical shift, roll and yaw; ``condensed()`` has the two of the
        classical wheelset, lateral shift and yaw.  The matrices are exact derivatives of the forces of compliant
        contact, which other contact modes are given for this.  Both rails carry twice the ``normal_force``, and its
        share ``load_transfer`` as a roll moment over the running circles; from these follow height and roll.

        With an ``amplitude`` the matrices are quasi-linear, for limit cycles: those of the two coordinates over the
        motion

            lateral shift = lateral_shift + amplitude sin(p),  yaw = yaw + yaw_amplitude cos(p),  p = frequency t

        each derivative weighted by twice the square of the cosine of its own coordinate's phase.  For a force
        that depends on one coordinate this is its describing function, the first harmonic over the amplitude
        (docs/theory/linear.md).

        Parameters
        ----------
        inputs : those of :meth:`evaluate` by keyword: lateral_shift, yaw, speed, normal_force, friction, rails.
        amplitude, yaw_amplitude : of the motion [m], [rad].
        frequency : of the motion [rad/s]; with 0 the geometry swings and the creepages do not.
        phases : number of places of the motion.

        Raises
        ------
        ValueError
            if an argument is not permitted.
        RuntimeError
            if there is no such steady motion, or the kernel is not compiled, or a model works outside it.
        """
        from .linear.point import linearize  # not part of an FMU

        refuse_changing(self, "linearize")
        compliant = self if self._balancing else self._twin("compliant")
        return linearize(
            compliant,
            amplitude=amplitude,
            yaw_amplitude=yaw_amplitude,
            frequency=frequency,
            phases=phases,
            **inputs,
        )

    def rail_reaction(
        self, state: WheelsetState, side: Literal["left", "right"]
    ) -> tuple[NDArray[Any], NDArray[Any]]:
        """As :meth:`Stepper.rail_reaction` of the ``state`` of one pose."""
        refuse_changing(self, "rail_reaction")
        return rail_reaction(self._tables, state.inputs, state.values, side)

    def _evaluate_some(self, arguments, penetration, side, outputs, inputs):
        """:meth:`evaluate` for outputs by name: the row of a table."""
        values = input_values(given_inputs(arguments, inputs))
        if any(np.ndim(value) for value in values):
            raise wrong_input(values, array=False)
        given = {row.keyword: value for row, value in zip(INPUTS, values)}
        return self.evaluate_many(penetration=penetration, side=side, outputs=outputs, **given)[0]

    def evaluate_many(
        self,
        *arguments: ArrayLike,
        penetration: float | tuple[float, float] | None = None,
        side: Sides = "both",
        outputs: Wanted = "all",
        processes: int = 1,
        threads: int | None = None,
        **inputs: Unpack[TableInputs],
    ) -> WheelsetState[NDArray[Any], NDArray[Any], NDArray[Any]]:
        """As :meth:`evaluate` for arrays (n,) that broadcast against each other; the same names hold arrays
        (n, ...).

        Rows with status 2, 3 or 4 are NaN.  ``penetration`` is one value, or (left, right), for all rows.
        ``outputs`` may also be a list of names, ``["roll", "right.patch", "left.area"]``, or "status" for
        the status of the whole contact alone.  A row has 8 B for each output that is wanted, for each input
        that is given as an array, and for the status.

        ``threads`` share the rows of a long table, with the same bits; None are as many as this process has
        cores.  The half-space, which needs much time, is shared by ``processes`` instead, with the same
        results; a script makes such a call below ``if __name__ == "__main__":``.

        Raises
        ------
        ValueError
            if an argument is not permitted, in one sentence.
        RuntimeError
            if the processes cannot start.
        """
        from .progress import working  # not part of an FMU

        check_count("processes", processes)
        if threads is not None:
            check_count("threads", threads)
        rows, wanted, stepper = self._many(arguments, penetration, side, outputs, inputs)
        size = stepper.layout.size if wanted.places is None else len(wanted.places)
        values = np.empty((len(rows), size))
        status = np.empty(len(rows), dtype=int)
        with working("evaluating poses", len(rows)) as advance:
            for part, found, outcome in self._parts(stepper, rows, wanted.places, processes, threads):
                values[part], status[part] = found, outcome
                advance(len(found))
        return WheelsetState(values, status, rows, stepper.layout, wanted.places, self._balancing)

    def evaluate_parts(
        self,
        *arguments: ArrayLike,
        penetration: float | tuple[float, float] | None = None,
        side: Sides = "both",
        outputs: Wanted = "all",
        processes: int = 1,
        **inputs: Unpack[TableInputs],
    ) -> Iterator[WheelsetState[NDArray[Any], NDArray[Any], NDArray[Any]]]:
        """As :meth:`evaluate_many`, but yields the table in parts of up to 512 rows, one after the other:
        the memory does not grow with the number of rows."""
        check_count("processes", processes)
        rows, wanted, stepper = self._many(arguments, penetration, side, outputs, inputs)
        parts = self._parts(stepper, rows, wanted.places, processes)
        return (
            WheelsetState(
                found.copy(), outcome, rows.part(part), stepper.layout, wanted.places, self._balancing
            )
            for part, found, outcome in parts
        )

    def find_equilibrium(self, inputs: NDArray[Any]) -> Equilibrium:
        """Where both wheels carry the load of the ``inputs`` of a state, or of a table's (n, ...): an
        :class:`~wrcontact.state.Equilibrium`."""
        rows = np.atleast_2d(inputs)
        found = self._elastic_twin().evaluate_many(
            outputs=["vertical_shift", "roll"], **{row.keyword: rows[:, k] for k, row in enumerate(INPUTS)}
        )
        if np.ndim(inputs) > 1:
            return Equilibrium(found.vertical_shift, found.roll, found.status)
        return Equilibrium(float(found.vertical_shift[0]), float(found.roll[0]), Status(int(found.status[0])))

    def _elastic_twin(self):
        """The same wheelset in elastic contact, on rigid rails."""
        if self._elastic is None:
            self._elastic = self._twin("elastic", **RIGID_RAILS)
        return self._elastic

    def _twin(self, contact_mode, **changed):
        """The same wheelset in another ``contact_mode``."""
        kind, parameters, profiles = self.__reduce__()[1]
        return _rebuilt(kind, {**parameters, **changed, "contact_mode": contact_mode}, profiles)

    def _parts(self, stepper, rows, places, processes, threads=1):
        """The parts of :meth:`Stepper.parts`; several processes share the half-space's rows, several threads
        those of the compiled kernel, in no order."""
        if not isinstance(self.methods["normal_model"], Halfspace):
            shared = thread_count(threads, len(rows)) if stepper.compiled else 1
            if shared > 1:
                others = (deepcopy(stepper) for _ in range(shared - 1))
                return threaded_parts([stepper, *others], rows, places)
            return stepper.parts(rows, places)
        if processes == 1 or len(rows) < 2:
            return stepper.parts(rows, places)
        from .halfspace.stepping import shared_parts

        return shared_parts(stepper.tables, self._halfspace, rows, places, processes)

    def _many(self, arguments, penetration, side, outputs, inputs):
        """What evaluate_many needs: rows of inputs (n, inputs), the selection of outputs, and a stepper for
        them."""
        given = given_inputs(arguments, inputs)
        values = input_values(given)
        try:
            columns = [np.asarray(column, dtype=float) for column in values]
            shape = np.broadcast_shapes((1,), *(column.shape for column in columns))
        except (TypeError, ValueError):
            raise wrong_input(values, array=True) from None
        if len(shape) != 1:
            raise wrong_input(values, array=True)
        warn_of_inputs(given, self._warned)
        stepper = self._new_stepper()
        wanted = selected(side, outputs, stepper.layout)
        stepper.want(wanted.side, wanted.depth)
        stepper.prescribe(penetration)
        return Rows.of(columns, shape[0], wanted.named), wanted, stepper


def _rebuilt(kind, parameters, profiles):
    """A system of these ``parameters`` with profiles that have been read already."""
    system = kind.__new__(kind)
    system._set_up(*checked_parameters(parameters, {}), profiles)
    return system


describe_inputs(ContactSystem.evaluate)
describe_inputs(ContactSystem.evaluate_many)
describe_inputs(ContactSystem.evaluate_parts)
describe_parameters(ContactSystem)
