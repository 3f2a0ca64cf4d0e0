"""The gap of wheel and rail along the normals of the curve between them, which turn with it.

A rail point r is joined with the wheel's outline along the mean of both bodies' normals there; the middle of
the joint is a point of the curve, and the curve's arc length is the station sigma (H8 of
docs/theory). Seen along the track the patch lies on this curve.
"""

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from scipy.spatial import cKDTree

from .boxes import hull
from .wheel_on_rail import WheelOnRail
from .window import WINDOW_MARGIN, Ridge

RAIL_STEP = 4e-5  # [m] of the rail's abscissa between two points of the curve
#: Where the bodies are farther apart than FAR [m] the curve is the rail's, with the rail's normals; up to
#: NEAR they count half each, and in between the change is gradual.
NEAR, FAR = 0.3e-3, 1e-3
ROUNDS = 6  # of the joint's direction, which is the mean of the normals at its ends
LONGEST = 20  # points of the outline passed in one round
ASIDE = 1e-6  # [m]; a joint that ends farther from its normal has found nothing
#: Half the length of the domain along the track [m]: with 4 deg of yaw a flange is 80 mm ahead.
REACH_X = 0.15
BEYOND = 5e-3  # [m] by which the domain is longer than the rail at both ends
CURVE_DOUBT = 1e-6  # [m]; the points' straight lines are off by less
RIDGE_STEP = 1e-3  # [m]; the places x of a ridge are known better


@dataclass(frozen=True)
class MiddleCurve:
    """Points (k,) of the curve, in the track frame of a right wheel.

    Attributes
    ----------
    s : stations [m], rising from the rail's inner side to its field side.
    y, z : places [m].
    angle : of the normals (0, -sin, -cos) [rad].
    x : where along the track the wheel is closest to each normal [m].
    ridge : distance [m] from the point to the wheel there, along the normal; inf where they are not close.
    rail : distance [m] from the point to the rail along the normal.
    rail_y : abscissa of the rail point that it belongs to [m], in the track frame.
    """

    s: np.ndarray
    y: np.ndarray
    z: np.ndarray
    angle: np.ndarray
    x: np.ndarray
    ridge: np.ndarray
    rail: np.ndarray
    rail_y: np.ndarray

    def at(self, name, s):
        """The attribute ``name`` at stations s [m], straight between the points."""
        return np.interp(s, self.s, getattr(self, name))

    def shifted(self, station):
        """The same with stations counted from ``station`` [m]."""
        return MiddleCurve(**{**vars(self), "s": self.s - station})

    def station_of(self, rail_y):
        """Station [m] of the point that belongs to the rail's abscissa ``rail_y`` [m]."""
        return float(np.interp(rail_y, self.rail_y, self.s))


def middle_curve(pair):
    """The curve of a placed wheel and its rail, over the whole rail; stations from its inner end on."""
    rail_y, rail_z, rail_angle = pair.rail_points(RAIL_STEP)
    joint, angle, x = _join(pair.outline, rail_y, rail_z, rail_angle)
    near = np.clip((FAR - np.where(np.isfinite(joint), joint, FAR)) / (FAR - NEAR), 0.0, 1.0)
    share = near**2 * (3.0 - 2.0 * near)
    angle = rail_angle + share * (angle - rail_angle)
    half = 0.5 * share * np.where(np.isfinite(joint), joint, 0.0)
    y, z = rail_y - half * np.sin(angle), rail_z - half * np.cos(angle)
    s = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y), np.diff(z)))])
    return MiddleCurve(s, y, z, angle, x, np.where(share > 0.0, joint - half, np.inf), -half, rail_y)


def _join(outline, y, z, angle):
    """From rail points (k,) with normals at ``angle`` along the mean normals to the outline: distance [m],
    negative in an overlap and NaN where the outline is not met; mean angle [rad]; the outline's x [m]."""
    place = cKDTree(np.stack([outline.y, outline.z], axis=-1)).query(np.stack([y, z], axis=-1))[1]
    count = np.arange(len(outline.y))
    for _ in range(ROUNDS):
        k = np.clip(place.astype(int), 0, len(count) - 2)
        at_y, at_z, facing = (np.interp(place, count, each) for each in (outline.y, outline.z, outline.angle))
        mean = 0.5 * (angle + facing)
        # zero where the outline's point lies on the normal
        aside = (at_y - y) * np.cos(mean) - (at_z - z) * np.sin(mean)
        rate = (outline.y[k + 1] - outline.y[k]) * np.cos(mean) - (outline.z[k + 1] - outline.z[k]) * np.sin(
            mean
        )
        with np.errstate(divide="ignore", invalid="ignore"):
            step = np.nan_to_num(aside / rate)
        place = np.clip(place - np.clip(step, -LONGEST, LONGEST), 0, len(count) - 1)
    t = -(at_y - y) * np.sin(mean) - (at_z - z) * np.cos(mean)
    return np.where(np.abs(aside) < ASIDE, t, np.nan), mean, np.interp(place, count, outline.x)


@dataclass(frozen=True)
class TurningGap:
    """Wheel and rail over the curve between them: what :class:`~wrcontact.halfspace.flat_gap.FlatGap` is for
    a plane.

    A penetration is here how far the wheel has moved straight down since it just touched.

    Attributes
    ----------
    pair : the wheel where it just touches its rail.
    curve : for the wheel lowered by ``laid``.
    laid, at : penetrations [m] for which the curve is made, and at which gaps are exact.
    """

    pair: WheelOnRail
    curve: MiddleCurve
    laid: float
    at: float

    def near(self, penetration):
        """The surfaces with gaps that are exact at this penetration [m]."""
        return replace(self, at=float(penetration))

    def angle(self, s):
        """Angles of the normals at stations (m,) [rad]."""
        return self.curve.at("angle", s)

    def share(self, s):
        """How much a penetration takes from the gap at stations (m,), per length."""
        return np.cos(self.angle(s))

    @cached_property
    def _lowered(self):
        return self.pair.lowered(self.at)

    def gap(self, x, s):
        """Distance of the surfaces at x (n,) or (n, m), s (m,) [m] along the normals: (n, m) [m], infinite
        without surfaces or far from each other. (H8)

        It is that at no penetration, as far as it changes with the penetration as it does ``at`` this one.
        """
        curve = self.curve
        close = curve.at("ridge", s)
        there = np.isfinite(close) & (s >= curve.s[0]) & (s <= curve.s[-1])
        gap = np.full((len(x), len(s)), math.inf)
        x, at = np.broadcast_to(x[:, None] if x.ndim == 1 else x, gap.shape)[:, there], s[there]
        y, z, angle = (curve.at(name, at) for name in ("y", "z", "angle"))
        share = np.cos(angle)
        bow = 0.5 * (x - curve.at("x", at)) ** 2 * share / self.pair.radius
        wheel = self._lowered.wheel_along(x, y, z, angle, close[there] - (self.at - self.laid) * share + bow)
        rail = self._lowered.rail_along(y, z, angle, curve.at("rail", at))
        gap[:, there] = wheel - rail + self.at * share
        return gap

    def overlap(self, s):
        """How far the surfaces overlap ``at`` its penetration at stations (m,), where along the track they do
        most [m]."""
        return self.at * self.share(s) - self.gap(self.curve.at("x", s)[None, :], s)[0]

    def ridge(self, domain=None):
        """The :class:`Ridge`, from the curve itself."""
        curve, close = self.curve, np.isfinite(self.curve.ridge)
        low = np.where(close, curve.ridge - curve.rail + self.laid * np.cos(curve.angle), math.inf)
        return Ridge(curve.s, curve.x, low, np.full(len(low), CURVE_DOUBT), RIDGE_STEP)

    @property
    def domain(self):
        """(x_low, x_high, s_low, s_high) [m], within which all patches lie."""
        return -REACH_X, REACH_X, self.curve.s[0] - BEYOND, self.curve.s[-1] + BEYOND

    def window(self, problem):
        """Box (x_low, x_high, s_low, s_high) [m] of what the penetration reaches, all patches together: the
        one that is prescribed, or with a margin the one that the curve is made for."""
        level = WINDOW_MARGIN * self.laid if problem.penetration is None else problem.penetration
        ridge = self.ridge()
        overlap = level * np.cos(self.curve.angle) - ridge.low
        k = np.flatnonzero(overlap > 0.0)
        if not len(k):
            k = np.array([np.argmin(ridge.low)])
        reach = np.sqrt(2.0 * self.pair.radius * np.maximum(overlap[k], 0.0) / np.cos(self.curve.angle[k]))
        step = self.curve.s[1] - self.curve.s[0]
        return hull(
            [
                (x - size - step, x + size + step, s - step, s + step)
                for x, s, size in zip(ridge.x[k], ridge.s[k], reach)
            ]
        )

    def place(self, x, s):
        """The place (3,) of x, s [m] on the curve in the track frame."""
        return np.array([x, float(self.curve.at("y", s)), float(self.curve.at("z", s))])


def turning_gap(pair, penetration):
    """The :class:`TurningGap` of a wheel that just touches, with its curve for a ``penetration`` [m].
    Stations count from the inner end of the rail."""
    return TurningGap(pair, middle_curve(pair.lowered(penetration)), penetration, penetration)
