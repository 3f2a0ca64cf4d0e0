"""Equivalent conicity (EN 15302): the cone on which a free wheelset would oscillate with the same wavelength.

A massless wheelset that rolls without slip follows, over the distance x,

    y'' + delta_r(y) / (e r0) = 0

with delta_r the right minus the left rolling radius, e the distance of the running circles and r0 the nominal
radius.  For a cone delta_r = 2 y tan(gamma), and the wavelength L is Klingel's.  Any other pair has an L at
each amplitude, and its equivalent conicity is tan(gamma) = (pi / L)^2 2 e r0.  The product e r0 cancels, so
it is 1 here.  With S(y), the integral of delta_r, the motion conserves E = y'^2 / 2 + S(y), and L / 2 is the
integral of dy / sqrt(2 (E - S)) between the two turning points.
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from ..results.words import ShortText

#: Amplitudes of the report [m].
AMPLITUDES = np.arange(1.0, 9.0) * 1e-3
#: Points of the sum over half an oscillation; its error is proportional to 1 / POINTS^2, 1e-6 of the
#: conicity.
POINTS = 2000
#: Rolling radii that differ by less [m] over the whole amplitude count as equal: profiles are printed to 1
#: nm.
LEVEL = 1e-9
#: Closer to a turning point than this share of the oscillation's width, S equals its value there to rounding.
ROUNDING = 1e-7

OFF_PROFILE = "the contact leaves the profiles"
NO_RETURN = "the rolling radius difference does not turn the wheelset back"


@dataclass(frozen=True, repr=False)
class Conicity(ShortText):
    """Equivalent conicity tan(gamma) at several amplitudes; arrays (m,), NaN where there is no oscillation.

    Attributes
    ----------
    amplitude : [m].
    level : conicity at zero roll, each wheel in contact where its own vertical gap is smallest, as
    for EN 15302's references.
    rolled : conicity with the roll of the wheelset in contact on both sides.
    middle, wavelength : middle of the oscillation [m] and its wavelength [m], at zero roll.
    level_reason, rolled_reason : "" or the reason why there is no oscillation.
    nonlinearity : change of ``level`` from 2 to 4 mm, per metre [1/m] (Polach, Vehicle System
    Dynamics 48 S1 (2010) 19-36).
    regressed : conicity at zero roll by linear regression of the rolling radius difference,
    :func:`regressed_conicity`.
    """

    amplitude: np.ndarray
    level: np.ndarray
    rolled: np.ndarray
    middle: np.ndarray
    wavelength: np.ndarray
    level_reason: tuple
    rolled_reason: tuple
    nonlinearity: float
    regressed: np.ndarray


class Swing:
    """Oscillation of a free wheelset: rolling radius differences ``difference`` (n,) [m] at rising lateral
    shifts ``shift`` (n,) [m], linear in between."""

    def __init__(self, shift, difference):
        self.shift, self.difference = shift, difference
        width = np.diff(shift)
        self.steepness = np.diff(difference) / width
        self.sums = np.concatenate([[0.0], np.cumsum(0.5 * (difference[1:] + difference[:-1]) * width)])

    def energy(self, y):
        """S at ``y`` [m], any shape [m^2]."""
        piece = np.clip(np.searchsorted(self.shift, y, side="right") - 1, 0, len(self.shift) - 2)
        u = y - self.shift[piece]
        return self.sums[piece] + u * (self.difference[piece] + 0.5 * self.steepness[piece] * u)

    def difference_at(self, y):
        """The rolling radius difference at ``y`` [m]."""
        return np.interp(y, self.shift, self.difference)

    def first_turns(self, amplitude):
        """Left turning points [m] of all oscillations with this amplitude [m]: S is equal at both turning
        points and smaller in between, and the rolling radius difference leads back from both."""
        last = self.shift[-1] - 2 * amplitude
        ends = np.unique(np.concatenate([self.shift, self.shift - 2 * amplitude, [last]]))
        ends = ends[(ends >= self.shift[0]) & (ends <= last)]

        def rise(y):
            return self.energy(y + 2 * amplitude) - self.energy(y)

        rises = rise(ends)
        up = np.flatnonzero((rises[:-1] < 0.0) & (rises[1:] >= 0.0))
        turns = [brentq(rise, ends[i], ends[i + 1], xtol=1e-16, rtol=1e-15) for i in up]
        return [turn for turn in turns if self._swings(turn, turn + 2 * amplitude)]

    def _swings(self, first, last):
        edge = ROUNDING * (last - first)
        inside = self.sums[(self.shift > first + edge) & (self.shift < last - edge)]
        return self.difference_at(first) < 0.0 < self.difference_at(last) and np.max(
            inside, initial=-math.inf
        ) < self.energy(first)

    def half_wave(self, first, last):
        """Distance x from the turning point ``first`` to ``last`` for e r0 = 1; the substitution y = middle +
        amplitude sin(phi) removes the singularities at both ends."""
        phi = math.pi * ((np.arange(POINTS) + 0.5) / POINTS - 0.5)
        middle, amplitude = 0.5 * (first + last), 0.5 * (last - first)
        y = middle + amplitude * np.sin(phi)
        # equal but for the rounding of the turn
        level = np.where(phi < 0.0, self.energy(first), self.energy(last))
        speed = np.sqrt(2.0 * np.maximum(level - self.energy(y), np.finfo(float).tiny))
        return np.sum(amplitude * np.cos(phi) / speed) * math.pi / POINTS

    def conicity(self, amplitude):
        """tan(gamma) [1], middle of the oscillation [m], and "" or the reason why there is none.  Of several
        oscillations, the one nearest to the middle of the track counts."""
        turns = self.first_turns(amplitude) if self.shift[-1] - self.shift[0] > 2 * amplitude else []
        if turns:
            first = min(turns, key=lambda turn: abs(turn + amplitude))
            return 0.5 * (math.pi / self.half_wave(first, first + 2 * amplitude)) ** 2, first + amplitude, ""
        if self.shift[0] > -amplitude or self.shift[-1] < amplitude:
            return math.nan, math.nan, OFF_PROFILE
        within = np.abs(self.shift) <= amplitude
        if np.max(np.abs(self.difference[within]), initial=0.0) < LEVEL:
            return 0.0, 0.0, ""
        return math.nan, math.nan, NO_RETURN


def equivalent_conicity(lateral_shift, radius_difference, amplitude):
    """Equivalent conicity tan(gamma) [1] at each ``amplitude`` (m,) [m]; an array (m,), NaN where there is no
    oscillation.

    It follows EN 15302:2021, by integration of the equation of motion, and accepts any rolling radius
    difference: with jumps, with different wheels left and right, or with an equilibrium beside the middle of
    the track.  The amplitude is half the distance between the two turning points.

    Parameters
    ----------
    lateral_shift : (n,) [m], rising; a jump is given as two values close to each other.
    radius_difference : (n,) right minus left rolling radius [m] at these shifts.
    amplitude : (m,) or one number [m].

    Raises
    ------
    ValueError
        if the arrays differ in length, are shorter than 2, not finite or not rising, or an
        amplitude is not positive.
    """
    shift, difference, amplitudes = _checked_curve(lateral_shift, radius_difference, amplitude)
    swing = Swing(shift, difference)
    return np.array([swing.conicity(value)[0] for value in amplitudes])


def _checked_curve(lateral_shift, radius_difference, amplitude):
    """Both columns of a curve (n,) and amplitudes (m,) as arrays; ValueError if they cannot be used."""
    shift, difference = np.asarray(lateral_shift, dtype=float), np.asarray(radius_difference, dtype=float)
    if shift.ndim != 1 or shift.shape != difference.shape or len(shift) < 2:
        raise ValueError(
            f"lateral_shift has shape {shift.shape} and radius_difference {difference.shape}; "
            "permitted are arrays of the same length, 2 or more"
        )
    if not (np.all(np.isfinite(shift)) and np.all(np.isfinite(difference)) and np.all(np.diff(shift) > 0.0)):
        raise ValueError(
            "lateral_shift does not rise all along, or there are values that are not finite; "
            "permitted are finite numbers [m], lateral_shift rising"
        )
    amplitudes = np.atleast_1d(np.asarray(amplitude, dtype=float))
    if not np.all(amplitudes > 0.0):
        raise ValueError(f"amplitude is {amplitude!r}; permitted is amplitude > 0 m")
    return shift, difference, amplitudes


def conicities(level, rolled, *, running_circle_distance, nominal_radius):
    """The :class:`Conicity` of two curves (lateral shift, rolling radius difference), each (n,) [m] or None
    without contact."""
    values, middles, reasons = _at_amplitudes(level)
    rolled_values, _, rolled_reasons = _at_amplitudes(rolled)
    with np.errstate(divide="ignore"):
        wavelength = 2 * math.pi * np.sqrt(running_circle_distance * nominal_radius / (2 * values))
    at = {round(value * 1e3): k for k, value in enumerate(AMPLITUDES)}
    return Conicity(
        AMPLITUDES,
        values,
        rolled_values,
        middles,
        wavelength,
        reasons,
        rolled_reasons,
        float(values[at[4]] - values[at[2]]) / 2e-3,
        np.full(len(AMPLITUDES), math.nan) if level is None else regressed_conicity(*level, AMPLITUDES),
    )


def regressed_conicity(lateral_shift, radius_difference, amplitude):
    """Equivalent conicity [1] at each ``amplitude`` (m,) [m] by linear regression: half the slope of the straight
    line through the rolling radius difference between -amplitude and +amplitude with the least mean square distance;
    an array (m,), NaN where the curve does not reach so far.

    The method of linear regression of EN 15302. The curve is straight between its points, and both integrals are
    exact: tan(gamma) = 3 / (4 A^3) times the integral of y delta_r(y). Parameters and errors are those of
    :func:`equivalent_conicity`.
    """
    shift, difference, amplitudes = _checked_curve(lateral_shift, radius_difference, amplitude)
    found = np.full(len(amplitudes), math.nan)
    for k, end in enumerate(amplitudes):
        if shift[0] <= -end and end <= shift[-1]:
            y = np.concatenate([[-end], shift[(-end < shift) & (shift < end)], [end]])
            d, middle = np.interp(y, shift, difference), 0.5 * (y[1:] + y[:-1])
            # Simpson's rule is exact for the product of two straight lines
            inner = 4.0 * middle * 0.5 * (d[1:] + d[:-1])
            moment = np.sum(np.diff(y) * (y[:-1] * d[:-1] + inner + y[1:] * d[1:])) / 6.0
            found[k] = 0.75 * moment / end**3
    return found


def _at_amplitudes(curve):
    """Conicities (m,), middles (m,) [m] and reasons at AMPLITUDES for one curve, or for None."""
    if curve is None:
        nothing = np.full(len(AMPLITUDES), math.nan)
        return nothing, nothing, (OFF_PROFILE,) * len(AMPLITUDES)
    swing = Swing(*curve)
    values, middles, reasons = zip(*map(swing.conicity, AMPLITUDES))
    return np.array(values), np.array(middles), reasons
