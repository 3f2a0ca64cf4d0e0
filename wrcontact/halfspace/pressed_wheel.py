"""A wheel pressed into its rail, and the roll at which both wheels of an elastic wheelset carry their loads
at one height.

At a given roll each side has one height H at which it carries its load: the one at which it just touches,
plus its penetration.  In equilibrium both are equal.  Where the roll changes under a constant load, a wheel
turns about its force's line of action (docs/theory/halfspace.md):

    dH / droll = -M_x / F_z                                                                     (H16)
"""

import math
from dataclasses import dataclass, replace

import numpy as np

from .contact import RESIDUAL_SHARE, solve_problem
from .outputs import resultant
from .problem import HalfspaceContact, Problem
from .turning_gap import TurningGap, turning_gap

#: A first answer on coarse grids tells how deep the wheel comes; its error.
FIRST_TOLERANCE = 0.1
#: The curve between the bodies is made anew where the penetration differs from the one that it is made for by
#: more than this share of it: 20 % change the load by 0.02 % and the peak by 0.1 %.
LAID_SHARE = 0.03
LAYINGS = 8
TRIALS = 25
FLATTEST = 0.05  # a slope between two trials is at least this share of the levers' difference
# the right side's height less the left one's falls where the roll grows
LONGEST = 2e-4  # [m]; longest move of a wheel from one trial to the next
COARSE = 0.03  # tolerance of the first trials
#: Heights that differ by this share of the penetration are equal; the grids' own error is 2e-4.
EQUAL = 2e-4
TOUCHINGS = 3  # steps in which a wheel is brought to its rail


@dataclass(frozen=True)
class Settings:
    """What is the same for all wheels: E* [Pa], the coupling of the materials
    (:func:`~wrcontact.halfspace.deflection.coupling_of`), whether forces are vertical ones, and the permitted
    relative error."""

    contact_modulus: float
    coupling: float
    vertical: bool
    tolerance: float

    def at(self, tolerance):
        """The same with another tolerance."""
        return replace(self, tolerance=tolerance)


@dataclass(frozen=True)
class PressedWheel:
    """A wheel in its rail: ``surfaces``, with gaps that are exact for the ``contact``, which lies on them."""

    surfaces: TurningGap
    contact: HalfspaceContact

    def counted_from(self, rail_y):
        """The same with stations counted from the rail's abscissa ``rail_y`` [m] of the track frame."""
        start = self.surfaces.curve.station_of(rail_y)
        return PressedWheel(
            replace(self.surfaces, curve=self.surfaces.curve.shifted(start)),
            replace(self.contact, s=self.contact.s - start),
        )


def press(pair, settings, *, force=None, penetration=None, estimate=None, sure=False):
    """The :class:`PressedWheel` of a ``pair`` that just touches.

    Parameters
    ----------
    pair : the wheel above its rail, :class:`~wrcontact.halfspace.wheel_on_rail.WheelOnRail`.
    settings : :class:`Settings`.
    force : of the contact [N], with an ``estimate`` of the penetration [m], which may be ``sure``; or
    penetration : how far the wheel moves down [m].

    Raises
    ------
    ArithmeticError
        where the solution or the curve below it is not found.
    """
    laid = estimate if penetration is None else penetration
    known = force is None or sure
    tolerance = settings.tolerance if known else max(settings.tolerance, FIRST_TOLERANCE)
    for _ in range(LAYINGS):
        surfaces = turning_gap(pair, laid)
        found = solve_problem(
            Problem(
                surfaces,
                surfaces.domain,
                settings.contact_modulus,
                force,
                penetration,
                RESIDUAL_SHARE * tolerance,
                settings.coupling,
                settings.vertical,
            ),
            tolerance,
        )
        final, tolerance = tolerance == settings.tolerance, settings.tolerance
        if final and abs(found.penetration - laid) <= LAID_SHARE * abs(laid):
            return PressedWheel(surfaces.near(found.penetration), found)
        laid = found.penetration
    raise ArithmeticError(
        f"the penetration still changes from {laid:g} m after {LAYINGS} curves between wheel and rail"
    )


@dataclass(frozen=True)
class Stand:
    """How one side carries its load at a roll.

    Attributes
    ----------
    height : vertical shift of the wheelset at which it does [m].
    lever : how this height follows the wheelset's roll [m].
    penetration : since the wheel just touched, straight down [m].
    wheel : the :class:`PressedWheel`, None without load.
    """

    height: float
    lever: float
    penetration: float
    wheel: PressedWheel | None


def find_equilibrium(stand, roll, arm, tolerance):
    """Roll [rad] and both :class:`Stand` in equilibrium.

    Parameters
    ----------
    stand : called with index (0 left, 1 right), roll [rad], tolerance and the last :class:`Stand` of this
        side, or None; returns a :class:`Stand`.
    roll : to start from [rad].
    arm : half the distance of the running circles [m].
    tolerance : permitted relative error.

    Raises
    ------
    ArithmeticError
        where there is none within TRIALS trials.
    """
    kept, stands, low, high, last = max(tolerance, COARSE), (None, None), -math.inf, math.inf, None
    for _ in range(TRIALS):
        stands = tuple(stand(index, roll, kept, stands[index]) for index in (0, 1))
        left, right = stands
        apart, depth = right.height - left.height, max(each.penetration for each in stands)
        if abs(apart) <= EQUAL * depth and kept == tolerance:
            return roll, stands
        slope = right.lever - left.lever
        if last is not None:
            seen = (apart - last[1]) / (roll - last[0])
            slope = seen if FLATTEST * slope > seen else FLATTEST * slope
        # a quarter of the last difference, or the bracket is halved
        slow = last is not None and abs(apart) > 0.25 * abs(last[1])
        last = roll, apart
        if abs(apart) <= COARSE * depth and kept > tolerance:
            # the roll may lie a little outside of what coarse grids have shown
            kept, low, high, last = tolerance, -math.inf, math.inf, None
        elif apart > 0.0:
            low = max(low, roll)
        else:
            high = min(high, roll)
        roll += float(np.clip(-apart / slope, -LONGEST / arm, LONGEST / arm))
        if math.isfinite(high - low) and (slow or not low < roll < high):
            roll = 0.5 * (low + high)
    raise ArithmeticError(
        f"both wheels' heights still differ by {apart:g} m after {TRIALS} rolls; permitted "
        f"is {EQUAL * depth:g} m"
    )


def stand_of(pair, index, settings, force, last=None):
    """The :class:`Stand` of a side (0 left, 1 right) under a ``force`` [N].

    ``pair`` is near the place where it carries the force, within a millimetre; ``last`` is its stand at
    another roll.
    """
    given = pair.centre[2]
    touching, place, angle = just_touching(pair)
    if force > 0.0:
        sunk = given - touching.centre[2] if last is None else last.penetration
        wheel = press(touching, settings, force=force, estimate=sunk, sure=last is not None)
        push, penetration = resultant(wheel, touching.centre), wheel.contact.penetration
        lever = -push[3] / push[2]
    else:
        wheel, penetration = None, 0.0
        y, z = place - touching.centre[1:]
        lever = -(y * math.cos(angle) - z * math.sin(angle)) / math.cos(angle)
    height = touching.centre[2] + touching.height + penetration
    return Stand(height, (2 * index - 1) * lever, penetration, wheel)


def just_touching(pair):
    """A wheel moved up or down until it touches its rail, the place (y, z) [m] where it does, and the angle
    of the normal there [rad]."""
    for _ in range(TOUCHINGS):
        surfaces = turning_gap(pair, 0.0)
        ridge = surfaces.ridge()
        k = int(np.argmin(ridge.low))
        if not math.isfinite(ridge.low[k]):
            raise ArithmeticError("the wheel is not near its rail")
        place, angle = surfaces.place(0.0, ridge.s[k])[1:], float(surfaces.angle(ridge.s[k : k + 1])[0])
        pair = pair.lowered(ridge.low[k] / math.cos(angle))
    return pair, place, angle
