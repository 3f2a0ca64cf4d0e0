"""One section of a rail as a curve over its length, from its gauge-side end.

A curve returns, at lengths along it, lateral place and height [m], slope [-] and second derivative [1/m] of the height
over the lateral place.
"""

import math

import numpy as np

from ..conventions import MILLIMETRE as MM

#: Steepest place of a section [-], 88.9 degrees.
STEEPEST = 50.0
#: Points closer together than this are one [m].
SAME = 1e-9
LEAST_POINTS = 5
#: Between two points the slope is looked at in this many places; a profile's length is summed up in such steps [m].
LOOKED, STEP = 8, 5e-5
#: Places and weights of Gauss's rule with five points on 0 ... 1.
GAUSS = tuple(
    part / 2.0
    for part in (np.polynomial.legendre.leggauss(5)[0] + 1.0, np.polynomial.legendre.leggauss(5)[1])
)


class PointCurve:
    """A cubic spline through ``points`` (n, 2) [m] over their chord length."""

    #: How closely the surface follows it [m].
    error = 1e-8
    joints = np.zeros(0)

    def __init__(self, points):
        from scipy.interpolate import CubicSpline  # not needed before there are sections

        points = np.array(points, dtype=float)
        if points.ndim != 2 or points.shape[1:] != (2,) or len(points) < LEAST_POINTS:
            raise ValueError(
                f"is an array of shape {points.shape}; permitted are {LEAST_POINTS} or more points (y, z), one in a row"
            )
        if not np.isfinite(points).all():
            bad = int(np.flatnonzero(~np.isfinite(points).all(axis=1))[0])
            raise ValueError(f"has a point {bad + 1} that is not finite; permitted are numbers in m")
        chords = np.hypot(*np.diff(points, axis=0).T)
        points = points[np.r_[True, chords > SAME]]
        self.length_at = np.r_[0.0, np.cumsum(np.hypot(*np.diff(points, axis=0).T))]
        self.length = float(self.length_at[-1])
        self._curve = CubicSpline(self.length_at, points)
        between = (
            self.length_at[:-1, None] + np.diff(self.length_at)[:, None] * np.arange(LOOKED) / LOOKED
        ).ravel()
        forward, down = self._curve(between, 1).T
        steep = ~(forward * STEEPEST > np.abs(down))
        if steep.any():
            y, z = self._curve(between[steep][0]) / MM
            raise ValueError(
                f"folds back or is steeper than {math.degrees(math.atan(STEEPEST)):.3g} deg at y = {y:.4g} mm, "
                f"z = {z:.4g} mm; permitted are sections whose y rises from the gauge side to the field side, so cut "
                "it where a wheel cannot reach"
            )

    def at(self, lengths):
        """Place, height, slope, and second derivative before and behind, at ``lengths`` (n,) [m]: (n, 5)."""
        y, z = self._curve(lengths).T
        forward, down = self._curve(lengths, 1).T
        turn, bend = self._curve(lengths, 2).T
        second = (bend * forward - turn * down) / forward**3
        return np.column_stack([y, z, down / forward, second, second])


class ProfileCurve:
    """A :class:`~wrcontact.Profile`, with its origin moved to ``place`` (y, z) [m]."""

    error = 1e-12

    def __init__(self, profile, place=(0.0, 0.0)):
        self.profile, self.place = profile, place
        zones = profile.zones
        ends = [(zone.start, zone.stop) for zone in zones]
        steps = [np.linspace(a, b, max(2, math.ceil((b - a) * MM / STEP) + 1)) for a, b in ends]
        self._y = np.concatenate([steps[0], *(part[1:] for part in steps[1:])])
        middles = self._y[:-1, None] + np.diff(self._y)[:, None] * GAUSS[0]
        slope = profile.evaluate(middles * MM)[1]
        if not (np.abs(slope) < STEEPEST).all():
            y = middles[~(np.abs(slope) < STEEPEST)][0]
            raise ValueError(
                f"is steeper than {math.degrees(math.atan(STEEPEST)):.3g} deg at y = {y:.4g} mm; permitted are profiles "
                "that are less steep"
            )
        self._along = np.r_[0.0, np.cumsum(np.diff(self._y) * (np.sqrt(1.0 + slope**2) @ GAUSS[1]))] * MM
        self.length = float(self._along[-1])
        joints = np.cumsum([len(part) - 1 for part in steps[:-1]]).astype(int)
        self.joints = self._along[joints]

    def at(self, lengths):
        """As :meth:`PointCurve.at`; at a joint of the profile the second derivative before it and behind it differ."""
        y = np.interp(lengths, self._along, self._y)
        zones, found = self.profile.zones, np.empty((len(y), 5))
        starts = np.array([zone.start for zone in zones])
        after = np.clip(np.searchsorted(starts, y, side="right") - 1, 0, len(zones) - 1)
        joined = np.flatnonzero(np.isin(lengths, self.joints))
        before = after.copy()
        for k in joined:
            after[k] = 1 + int(np.flatnonzero(self.joints == lengths[k])[0])
            before[k] = after[k] - 1
            y[k] = zones[after[k]].start
        for zone in sorted({*before, *after}):
            here = np.flatnonzero((before == zone) | (after == zone))
            values = np.array(zones[zone](y[here]))
            for mine, column in ((after[here] == zone, 4), (before[here] == zone, 3)):
                found[here[mine], column] = values[2][mine] / MM
            mine = before[here] == zone
            found[here[mine], 1], found[here[mine], 2] = values[0][mine] * MM, values[1][mine]
        found[:, 0] = y * MM
        return found + [*self.place, 0.0, 0.0, 0.0]
