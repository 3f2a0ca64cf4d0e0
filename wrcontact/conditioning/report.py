"""The check of a pair of profiles: a wheelset is moved across the track, and its contacts are examined."""

import math
import warnings
from dataclasses import dataclass, replace

import numpy as np

from ..conventions import MIRROR, SIDES
from ..interface.inputs import LATERAL_LIMIT
from ..interface.parameters import GEOMETRY, LEFT, SIDED
from ..profiles.changing import refuse_changing
from ..results.convert import needed
from ..results.words import ShortText
from ..status import Status
from ..system import ContactSystem
from .conformal import conformal_zones, near_stretches
from .conicity import AMPLITUDES, Conicity, conicities
from .curves import (
    RESOLUTION,
    Curves,
    SideCurves,
    find_jumps,
    free_curvature,
    geometry,
    jump_distance,
    radius_difference,
    rates,
)
from .quality import ProfileQuality, profile_quality
from .remarks import FLANGE, LEAST_RANGE, sentences
from .table import table_columns

STEP = 0.05e-3  # [m] step of the lateral shift in the curves
FINE = 0.01e-3  # [m] step of the lateral shift for the conicity, which is then accurate to 1e-5
END = 1e-6  # [m] to which the ends of the usable shifts are located
HOLE = 0.2e-3  # [m] the conicity bridges shorter ranges without contact; a longer one ends the profiles


@dataclass(frozen=True, repr=False)
class Conditioning(ShortText):
    """The results of :func:`check` on a pair of profiles.

    Attributes
    ----------
    system : the ContactSystem that was checked; its parameters are the track and the wheelset.
    usable : whether there is contact at every shift up to the smallest amplitude of the conicity, 1 mm.
    usable_shifts : (first, last) lateral shift [m] with contact, without interruption, around the centred
        position; at most +-15 mm, the kernel's limit; NaN without contact in the centred position.
    jumps : tuple of :class:`~wrcontact.conditioning.Jump`, left ones first.
    nearest_jump : lateral shift [m] from the centred position to the nearest jump of either
    contact; infinite without one.
    flange_shift : lateral shift [m] beyond which the right contact, or to the left the left one, is steeper
        than 45 deg, the smaller of both; infinite if neither ever is.
    curves : :class:`~wrcontact.conditioning.Curves` over the lateral shift, every 0.05 mm within +-15 mm.
    conformal : tuple of :class:`~wrcontact.conditioning.ConformalZone`, left ones first.
    conicity : :class:`~wrcontact.conditioning.Conicity` at amplitudes of 1 ... 8 mm.
    conicity_curves : dict with "level" and "rolled": (lateral shift (n,), rolling radius difference (n,))
        [m], the data of the conicity, with both values at every jump; None without contact.
    wheel, rail, left_wheel, left_rail : :class:`~wrcontact.conditioning.ProfileQuality` of the right and of
        the left side's profiles; those of equal sides are the same, visited by both contacts.
    remarks : tuple of sentences on what to know about the pair; empty if there is nothing special.
    """

    system: ContactSystem
    usable: bool
    usable_shifts: tuple
    jumps: tuple
    nearest_jump: float
    flange_shift: float
    curves: Curves
    conformal: tuple
    conicity: Conicity
    conicity_curves: dict
    wheel: ProfileQuality
    rail: ProfileQuality
    left_wheel: ProfileQuality
    left_rail: ProfileQuality
    remarks: tuple

    def to_pandas(self):
        """The curves as a pandas.DataFrame in SI, a row for each shift with contact: lateral_shift, roll, for
        each side contact.y_wheel, contact.y_rail, contact_angle and rolling_radius, their radius_difference,
        level_radius_difference (at zero roll), and the equivalent conicity at an amplitude of |lateral_shift|,
        ``conicity`` at zero roll (EN 15302) and ``rolled_conicity``.

        Raises
        ------
        ImportError
            in one sentence, if pandas is not installed.
        """
        columns = {name: values for name, (values, _) in table_columns(self).items()}
        return needed("pandas", "to_pandas").DataFrame(columns)


def check(system):
    """Check the pair of profiles of ``system``, without yaw, and return a :class:`Conditioning`.

    Contacts are rigid, so only the profiles and the geometry matter (rail_inclination, gauge, gauge_depth,
    running_circle_distance, nominal_radius).  The check takes less than a second.  A pair without contact
    raises no error; it is reported in ``usable`` and ``remarks``.  The equivalent conicity follows EN 15302.

    >>> import wrcontact
    >>> wrcontact.check(wrcontact.ContactSystem()).conformal[-1].side
    'right'
    """
    if not isinstance(system, ContactSystem):
        raise ValueError(f"system is {system!r}; permitted is a ContactSystem")
    refuse_changing(system, "check")
    rolling, level = _wheelset(system, "rigid"), _wheelset(system, "compliant")
    shifts = _shifts(STEP)
    table = geometry(rolling, shifts)
    jumps = tuple(find_jumps(rolling, shifts))
    curves = _curves(rolling, level, shifts, table, jumps)
    swings = {"level": _swing_curve(level, find_jumps(level, shifts)), "rolled": _swing_curve(rolling, jumps)}
    found = {
        "usable_shifts": _usable_shifts(rolling, shifts, np.asarray(table.status)),
        "jumps": jumps,
        "nearest_jump": float(np.min(jump_distance(jumps, np.zeros(1)))),
        "flange_shift": min(
            _flange_shift(rolling, curves, side) for side in (("right",) if system.equal_sides else SIDES)
        ),
        "curves": curves,
        "conformal": conformal_zones(shifts, {side: getattr(curves, side) for side in SIDES}),
        "conicity": conicities(
            *swings.values(),
            nominal_radius=system.centre_height,
            running_circle_distance=system.parameters["running_circle_distance"],
        ),
        "conicity_curves": swings,
        **_profiles(rolling, curves),
    }
    first, last = found["usable_shifts"]
    usable = bool(first <= -LEAST_RANGE and last >= LEAST_RANGE)
    silent = Conditioning(system=system, usable=usable, **found, remarks=())
    return replace(silent, remarks=sentences(silent))


def _wheelset(system, contact_mode):
    """The same wheelset and track with Hertz contact and this contact mode; a compliant one is evaluated at
    zero roll."""
    chosen = {name: system.parameters[name] for name in (*GEOMETRY, *(LEFT + name for name in SIDED[2:]))}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the user has been warned
        return ContactSystem(
            (system.left_wheel, system.wheel),
            (system.left_rail, system.rail),
            **chosen,
            contact_mode=contact_mode,
            normal_model="hertz",
        )


def _shifts(step):
    """Lateral shifts (n,) [m] over the kernel's whole range, symmetric about zero, zero included."""
    half = np.linspace(0.0, LATERAL_LIMIT, round(LATERAL_LIMIT / step) + 1)
    return np.concatenate([-half[:0:-1], half])


def _run_around(shifts, fine):
    """Slice of the run of True in ``fine`` (n,) around the shift 0; empty if ``fine`` is False there."""
    middle = int(np.argmin(np.abs(shifts)))
    if not fine[middle]:
        return slice(0, 0)
    gaps = np.flatnonzero(~fine)
    return slice(
        int(np.max(gaps[gaps < middle], initial=-1)) + 1, int(np.min(gaps[gaps > middle], initial=len(fine)))
    )


def _usable_shifts(system, shifts, status):
    """First and last lateral shift [m] with contact, without interruption, around zero; accurate to END."""
    run = _run_around(shifts, status <= Status.UNLOADED)
    if run.stop == 0:
        return math.nan, math.nan

    def touches(shift):
        return geometry(system, [shift]).status[0] <= Status.UNLOADED

    first = shifts[0] if run.start == 0 else _boundary(touches, shifts[run.start], shifts[run.start - 1])
    last = (
        shifts[-1] if run.stop == len(shifts) else _boundary(touches, shifts[run.stop - 1], shifts[run.stop])
    )
    return float(first), float(last)


def _boundary(holds, inside, outside):
    """The last shift, between ``inside`` and ``outside``, at which ``holds(shift)`` is true; by bisection to
    END [m]."""
    while abs(outside - inside) > END:
        middle = 0.5 * (inside + outside)
        inside, outside = (middle, outside) if holds(middle) else (inside, middle)
    return inside


def _curves(rolling, level, shifts, table, jumps):
    """The :class:`Curves` of the states ``table`` at ``shifts``."""
    roll_rate, moves = rates(rolling, shifts)
    near, sides = near_stretches(rolling, shifts, table), {}
    for name in SIDES:
        side = getattr(table, name)
        sides[name] = SideCurves(
            side.contact.y_wheel,
            side.contact.y_rail,
            *moves[name],
            side.contact_angle,
            side.curvature_y,
            side.rolling_radius,
            *near[name],
        )
    return Curves(
        shifts,
        table.roll,
        roll_rate,
        jump_distance(jumps, shifts),
        table.right.rolling_radius - table.left.rolling_radius,
        radius_difference(level, shifts),
        np.tan(table.right.contact_angle) - np.tan(table.left.contact_angle),
        free_curvature(table),
        **sides,
    )


def _swing_curve(system, jumps):
    """Lateral shifts and rolling radius differences (n,) [m] around the centred position, with both values at
    every jump; None without contact in the centred position."""
    beside = [jump.lateral_shift + step for jump in jumps for step in (-RESOLUTION, RESOLUTION)]
    shifts = np.unique(np.concatenate([_shifts(FINE), np.clip(beside, -LATERAL_LIMIT, LATERAL_LIMIT)]))
    difference = radius_difference(system, shifts)
    known = np.isfinite(difference)
    shifts, difference = shifts[known], difference[known]
    if not len(shifts) or np.min(np.abs(shifts)) > HOLE:
        return None
    holes = np.concatenate([np.diff(shifts) <= HOLE, [False]])
    first = np.flatnonzero(~holes & (shifts < 0.0))
    run = slice(int(first[-1]) + 1 if len(first) else 0, int(np.flatnonzero(~holes & (shifts >= 0.0))[0]) + 1)
    return (shifts[run], difference[run]) if run.stop - run.start > 1 else None


def _flange_shift(system, curves, side):
    """Lateral shift [m], counted towards the ``side``, beyond which its contact is steeper than FLANGE;
    infinite if it never is."""
    sign = 1.0 if side == "right" else MIRROR[0]
    order = slice(None, None, int(sign))
    shifts, angle = sign * curves.lateral_shift[order], getattr(curves, side).contact_angle[order]
    steep = np.flatnonzero(np.isfinite(angle) & ~(angle < FLANGE))
    if not len(steep):
        return math.inf
    at = shifts[steep[0]]
    if steep[0] == 0 or not math.isfinite(angle[steep[0] - 1]):
        return float(at)

    def touches(shift):
        return getattr(geometry(system, [sign * shift]), side).contact_angle[0] >= FLANGE

    return float(_boundary(touches, at, shifts[steep[0] - 1]))


def _profiles(system, curves):
    """:class:`ProfileQuality` of both profiles, for contacts at shifts up to the largest amplitude."""
    near = np.abs(curves.lateral_shift) <= AMPLITUDES[-1]
    found = {}
    for side, prefix in (("right", ""), ("left", LEFT)):
        wheel, rail, _ = system.profile_tables(side)
        inclination = system.side_parameters(side)["rail_inclination"]
        sides = SIDES if system.equal_sides else (side,)
        wheel_profile, rail_profile = (getattr(system, prefix + kind) for kind in ("wheel", "rail"))
        found |= {
            prefix + "wheel": profile_quality(wheel_profile, wheel, _visited("y_wheel", curves, near, sides)),
            prefix + "rail": profile_quality(
                rail_profile, rail, _visited("y_rail", curves, near, sides), inclination
            ),
        }
        if system.equal_sides:
            return found | {LEFT + kind: quality for kind, quality in found.items()}
    return found


def _visited(name, curves, near, sides):
    """Smallest and largest ``name`` [m] of the contacts of ``sides`` at the shifts ``near`` (a mask (n,));
    NaN without contact."""
    found = np.concatenate([getattr(getattr(curves, side), name)[near] for side in sides])
    found = found[np.isfinite(found)]
    return (float(np.min(found)), float(np.max(found))) if len(found) else (math.nan, math.nan)
