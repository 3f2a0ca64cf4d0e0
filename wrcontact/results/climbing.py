"""Flange climb and track shift: limits, margins to them, and the report of a run.

>>> import math, wrcontact
>>> round(float(wrcontact.nadal_limit(math.radians(70.0), 0.36)), 2)
1.2
>>> round(float(wrcontact.track_shift_limit(157e3)) / 1e3, 1)     # [kN]
62.3
"""

from __future__ import annotations

import csv
import math
from dataclasses import dataclass
from os import PathLike
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..conventions import SIDES
from ..methods.numbers import is_plain
from ..storage.atomic import open_atomically
from .guiding import _finite, _positive, low_pass, sliding_mean
from .runs import Run

#: Patches of a wheel that results have.
PATCHES = (1, 2, 3)
#: Shares of the values of a run below its reported values, EN 14363.
LOW, MIDDLE, HIGH = 0.0015, 0.5, 0.9985
FOOT, INCH = 0.3048, 0.0254  # [m]
#: Flanges for which the formula of TCRP Report 71 has a sense: angles [rad] and lengths [m].
FLANGE_ANGLES, FLANGE_LENGTHS = (math.radians(60.0 - 1e-9), math.radians(75.0 + 1e-9)), (10e-3, 26e-3)


def nadal_limit(contact_angle: ArrayLike, friction: ArrayLike) -> Any:
    """Nadal's limit of Y/Q [1], below which a flange slides down its rail.

    ``(tan(d) - mu) / (1 + mu tan(d)) = tan(d - atan(mu))``, Nadal, Locomotives a vapeur (1908).  The flange
    climbs with all its friction along the slope, as at a large angle of attack.  Below 0 a contact angle can
    hold no lateral force against friction.

    Parameters
    ----------
    contact_angle : d [rad], positive towards the flange.
    friction : mu [1].
    """
    return np.tan(np.asarray(contact_angle) - np.arctan(friction))[()]


def weinstock_limit(contact_angle: ArrayLike, friction: ArrayLike, other_friction: ArrayLike) -> Any:
    """Weinstock's limit of the sum of |Y/Q| of both wheels [1]: Nadal's of the wheel on its flange, and the
    friction of the other one.

    Weinstock, Wheel climb derailment criteria for evaluation of rail vehicle safety, ASME 84-WA/RT-1 (1984).
    The other wheel pushes the flange against the rail with its friction at most, so that a wheelset with little
    load on its flange, whose Y/Q exceeds Nadal's limit, is not said to climb.

    Parameters
    ----------
    contact_angle, friction : of the wheel on its flange [rad], [1].
    other_friction : of the other wheel [1].
    """
    return nadal_limit(contact_angle, friction) + np.asarray(other_friction)


class FlangeClimb(NamedTuple):
    """How near the wheels are to climbing, of one pose or (n,) of a table or a run [1].

    left_quotient, right_quotient : Y/Q of each wheel.
    left_limit, right_limit : Nadal's limit.  NaN where the wheel has no contact steeper than its friction holds, and so
        none that could climb.
    left_margin, right_margin : limit less Y/Q; climbs below 0.
    quotient_sum : |Y/Q| of both wheels together.
    sum_limit : Weinstock's limit, of the wheel that has the larger Y/Q; NaN as above.
    sum_margin : limit less sum.
    """

    left_quotient: Any
    right_quotient: Any
    left_limit: Any
    right_limit: Any
    left_margin: Any
    right_margin: Any
    quotient_sum: Any
    sum_limit: Any
    sum_margin: Any


def flange_climb(run: Any, flange_angle: float | None = None) -> FlangeClimb:
    """Nadal's and Weinstock's limits and the margins to them: a :class:`FlangeClimb`.

    Parameters
    ----------
    run : a state, a table, or arrays by FMU name with ``left.derailment_quotient``, ``left.friction``,
        ``left.patch[1].contact_angle`` and so on.
    flange_angle : of the limits [rad]; None is the steepest contact of the wheel at each instant, which a new contact
        on a steeper part may follow.  EN 14363 and 49 CFR 213.333 take the angle of the flange itself:
        :func:`steepest_angle` of the wheel's profile.

    Raises
    ------
    ValueError
        if a quantity is missing, or the angle is not one of a flange.
    """
    if flange_angle is not None and not 0.0 < flange_angle < 0.5 * math.pi:
        raise ValueError(
            f"flange_angle is {flange_angle!r}; permitted are numbers between 0 and pi/2, in rad"
        )
    run, quotients, limits, angles, frictions = Run.of(run), {}, {}, {}, {}
    for side in SIDES:
        quotients[side] = run[f"{side}.derailment_quotient"]
        frictions[side] = run[f"{side}.friction"]
        angles[side] = contact_angle(run, side) if flange_angle is None else flange_angle
        limits[side] = _above(nadal_limit(angles[side], frictions[side]))
    rights = quotients["right"] >= quotients["left"]
    both = np.where(rights, limits["right"] + frictions["left"], limits["left"] + frictions["right"])[()]
    total = abs(quotients["left"]) + abs(quotients["right"])
    return FlangeClimb(
        quotients["left"],
        quotients["right"],
        limits["left"],
        limits["right"],
        limits["left"] - quotients["left"],
        limits["right"] - quotients["right"],
        total,
        both,
        both - total,
    )


def _above(limit):
    """A limit, NaN where it is not above 0."""
    return np.where(np.asarray(limit) > 0.0, limit, np.nan)[()]


def contact_angle(run: Run, side: str) -> Any:
    """Angle of the steepest loaded patch of a wheel [rad]; NaN without one."""
    steepest = np.nan
    for number in PATCHES:
        angle, load = (f"{side}.patch[{number}].{name}" for name in ("contact_angle", "normal_force"))
        if number == 1 or angle in run and load in run:
            steepest = np.fmax(steepest, np.where(run[load] > 0.0, run[angle], np.nan)[()])
    return steepest


def steepest_angle(profile: Any) -> float:
    """The largest angle of a wheel profile's flange [rad], between the running circle and the flange's tip.

    Raises
    ------
    ValueError
        if the profile is that of a rail.
    """
    if profile.kind != "wheel":
        raise ValueError(f"profile is {profile.name!r}, a rail; permitted is a wheel")
    y = np.linspace(1e-3 * profile.zones[0].start, 0.0, 20001)
    height = np.asarray(profile.height(y))
    inner = y >= y[np.argmax(height)]
    return float(np.arctan(np.max(-np.asarray(profile.slope(y[inner])))))


def wheel_lift(run: Any, side: str, running_circle_distance: float = 1.5) -> Any:
    """How far the running circle of a wheel is above the height of the rails' heads [m].

    ``-(vertical_shift +- 0.5 running_circle_distance sin(roll))``, the right wheel with +.  In the middle of the track
    it is nearly 0; where the flange climbs it grows to the flange's height.  Rails that move are not subtracted.

    Parameters
    ----------
    run : a state, a table, or arrays by FMU name with ``vertical_shift`` and ``roll``.
    side : "left" or "right".
    """
    if side not in SIDES:
        raise ValueError(f"side is {side!r}; permitted are 'left' and 'right'")
    arm = (0.5 if side == "right" else -0.5) * running_circle_distance
    run = Run.of(run)
    return -(run["vertical_shift"] + arm * np.sin(run["roll"]))


def climb_distances(
    quotient: ArrayLike, limit: ArrayLike, distance: ArrayLike
) -> tuple[NDArray[Any], NDArray[Any]]:
    """Stretches over which Y/Q exceeds its limit: (places where they begin (k,), lengths (k,)) [m].

    Between rows both follow straight lines.  How long a stretch may be: :func:`climb_distance_limit`.  49 CFR 213.333
    permits none of 5 feet (1.524 m) beyond Nadal's limit at a friction of 0.5, without a second source for these numbers.

    Parameters
    ----------
    quotient, limit : of each row (n,) [1]; a limit of NaN is not exceeded.
    distance : of each row (n,) [m], rising.

    Raises
    ------
    ValueError
        if ``quotient`` or ``distance`` are not finite, or do not fit.
    """
    given, along = _finite("quotient", quotient), _finite("distance", distance)
    if along.shape != given.shape or given.ndim != 1 or not (np.diff(along) > 0.0).all():
        raise ValueError(
            f"distance has the shape {along.shape}; permitted are as many rising numbers as quotient has, in m"
        )
    bound = np.broadcast_to(np.asarray(limit, dtype=float), given.shape)
    excess = np.where(np.isnan(bound), -1.0, given - np.nan_to_num(bound))
    over = excess > 0.0
    starts, ends = [], []
    for k in range(len(over)):
        if over[k] and (k == 0 or not over[k - 1]):
            starts.append(along[0] if k == 0 else _crossing(along, excess, k))
        if over[k] and (k == len(over) - 1 or not over[k + 1]):
            ends.append(along[-1] if k == len(over) - 1 else _crossing(along, excess, k + 1))
    starts, ends = np.array(starts), np.array(ends)
    return starts, ends - starts


def _crossing(along, excess, k):
    """Where the straight line between rows k - 1 and k passes 0 [m]."""
    share = excess[k - 1] / (excess[k - 1] - excess[k])
    return along[k - 1] + share * (along[k] - along[k - 1])


def climb_distance_limit(angle_of_attack: ArrayLike, flange_angle: float, flange_length: float) -> Any:
    """How long Y/Q of a wheel may exceed Nadal's limit before its flange climbs the rail [m].

    ``D = A B L / (a + B L)`` in feet, with the angle of attack a in mrad, the length L of the flange in inches and its
    angle d in degrees, and

        A = (100 / (146.56 - 1.9128 d) + 3.1) L - 1 / (-0.0092 d^2 + 1.2152 d - 39.031) + 1.23
        B = (10 / (2.1052 - 21.157 L) + 0.05) d + 10 / (0.2688 L - 0.0266) - 5

    TCRP Report 71, volume 5 (2005), eq. (2.4): a fit to simulations of wheels of transit vehicles.

    Parameters
    ----------
    angle_of_attack : a, any shape [rad], positive where the wheel rolls towards its rail: the yaw at a right wheel, -yaw
        at a left one, in a curve less the rail's own direction.  Below 0 it counts as 0.
    flange_angle : d, 60 ... 75 deg [rad]; the fit has poles beyond.
    flange_length : L, of the flange's steepest part together with its tip, as the report measures it, 10 ... 26 mm [m].

    Raises
    ------
    ValueError
        if a number is outside its range or not finite.
    """
    attack = np.asarray(angle_of_attack, dtype=float)
    if not np.isfinite(attack).all():
        raise ValueError(f"angle_of_attack is {angle_of_attack!r}; permitted are finite numbers, in rad")
    attack = 1e3 * np.maximum(attack, 0.0)
    for name, value, (low, high) in (
        ("flange_angle", flange_angle, FLANGE_ANGLES),
        ("flange_length", flange_length, FLANGE_LENGTHS),
    ):
        if not (is_plain(value) and low <= value <= high):
            unit = "rad" if name == "flange_angle" else "m"
            raise ValueError(
                f"{name} is {value!r}; permitted are numbers of {low:.4g} ... {high:.4g}, in {unit}"
            )
    d, length = math.degrees(flange_angle), flange_length / INCH
    a = (100.0 / (146.56 - 1.9128 * d) + 3.1) * length - 1.0 / (-0.0092 * d**2 + 1.2152 * d - 39.031) + 1.23
    b = (10.0 / (2.1052 - 21.157 * length) + 0.05) * d + 10.0 / (0.2688 * length - 0.0266) - 5.0
    return (FOOT * a * b * length / (attack + b * length))[()]


def track_shift_limit(axle_load: ArrayLike, factor: float = 1.0) -> Any:
    """Limit of the sum of Y of a wheelset [N], over 2 m of track: ``factor (10 kN + 2 Q0 / 3)``.

    Prud'homme (1967); EN 14363 and UIC 518 have the factor k1 = 1.0, for freight wagons 0.85.  No public text with these
    numbers was found: compare them with your edition of the standard.

    Parameters
    ----------
    axle_load : static load 2 Q0 of the wheelset [N].
    factor : k1 [1].

    Raises
    ------
    ValueError
        if one is not above 0.
    """
    load = np.asarray(axle_load, dtype=float)
    if not (load > 0.0).all():
        raise ValueError(f"axle_load is {axle_load!r}; permitted are numbers above 0, in N")
    _positive("factor", factor, "1")
    return (factor * (10e3 + load / 3.0))[()]


# --- report -------------------------------------------------------------------------------------------------


class ReportRow(NamedTuple):
    """A quantity of a run: its values below which 0.15, 50 and 99.85 % of the run are, and its limit.

    share : the larger of |low| and |high| over the limit [1]; NaN without a limit.
    """

    name: str
    unit: str
    low: float
    median: float
    high: float
    limit: float
    share: float


@dataclass(frozen=True)
class GuidingReport:
    """What EN 14363 asks of a run of one wheelset: ``rows`` of :class:`ReportRow`; ``print`` shows them."""

    rows: tuple[ReportRow, ...]

    def __getitem__(self, name: str) -> ReportRow:
        found = {row.name: row for row in self.rows}
        if name not in found:
            raise KeyError(f"{name!r}; permitted are {', '.join(found)}")
        return found[name]

    def __str__(self) -> str:
        head = f"{'':22}{'0.15 %':>12}{'50 %':>12}{'99.85 %':>12}{'limit':>12}{'share':>8}"
        lines = [head]
        for row in self.rows:
            scale, unit = (1e3, "kN") if row.unit == "N" else (1.0, "-")
            limit, share = (
                ("-", "-")
                if math.isnan(row.limit)
                else (f"{row.limit / scale:.2f}", f"{100 * row.share:.0f} %")
            )
            values = "".join(f"{value / scale:12.2f}" for value in (row.low, row.median, row.high))
            lines.append(f"{f'{row.name} [{unit}]':22}{values}{limit:>12}{share:>8}")
        return "\n".join(lines)

    def save(self, path: str | PathLike[str]) -> None:
        """Write the rows as CSV, in SI."""
        with open_atomically(path, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(ReportRow._fields)
            writer.writerows(self.rows)


def guiding_report(
    run: Any,
    step: float,
    distance: ArrayLike,
    *,
    axle_load: float | None = None,
    factor: float = 1.0,
    quotient_limit: float = 0.8,
) -> GuidingReport:
    """The values of Y, Q, Y/Q and the sum of Y of a run that EN 14363 compares with limits.

    All are filtered at 20 Hz (:func:`low_pass`); Y/Q and the sum of Y also as means over 2 m every 0.5 m
    (:func:`sliding_mean`).  The values are those below which 0.15, 50 and 99.85 % of a run are, a straight line
    between neighbours in the order of size.  The standard then takes sections of track together; that is not done here.

    Parameters
    ----------
    run : a table, or arrays (n,) by FMU name with ``left.force.y``, ``left.force.z`` and so on.
    step : time between rows [s].
    distance : of each row along the track (n,) [m].
    axle_load, factor : for the limit of the sum of Y, as for :func:`track_shift_limit`; None states none.
    quotient_limit : of Y/Q [1]; EN 14363 has 0.8, for which no public text was found.

    Raises
    ------
    ValueError
        if the rows are not finite, too few, or do not rise.
    """
    run = Run.of(run)
    y = {"left": run["left.force.y"], "right": -run["right.force.y"]}
    q = {side: -run[f"{side}.force.z"] for side in SIDES}
    shift = math.nan if axle_load is None else float(track_shift_limit(axle_load, factor))
    rows = []
    for side in SIDES:
        rows.append(_row(f"{side}.y", "N", low_pass(y[side], step), math.nan))
        rows.append(_row(f"{side}.q", "N", low_pass(q[side], step), math.nan))
    for side in SIDES:
        with np.errstate(divide="ignore", invalid="ignore"):
            ratio = np.where(q[side] > 0.0, y[side] / q[side], 0.0)
        means = sliding_mean(low_pass(ratio, step), distance)[1]
        rows.append(_row(f"{side}.quotient", "1", means, quotient_limit))
    means = sliding_mean(low_pass(y["right"] - y["left"], step), distance)[1]
    rows.append(_row("sum_y", "N", means, shift))
    return GuidingReport(tuple(rows))


def _row(name, unit, values, limit):
    low, median, high = (float(value) for value in np.quantile(values, [LOW, MIDDLE, HIGH]))
    return ReportRow(name, unit, low, median, high, limit, max(abs(low), abs(high)) / limit)
