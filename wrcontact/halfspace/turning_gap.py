"""The gap of wheel and rail along the normals of the curve between them, which turn with it."""

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from .boxes import hull
from .middle_curve import MiddleCurve, middle_curve
from .ridge import Ridge
from .wheel_on_rail import WheelOnRail

#: Half the length of the domain along the track [m]: with 4 deg of yaw a flange is 80 mm ahead.
REACH_X = 0.15
BEYOND = 5e-3            # [m] by which the domain is longer than the rail at both ends
WINDOW_MARGIN = 1.3      # on the estimated penetration that the window is made for
CURVE_DOUBT = 1e-6       # [m]; the points' straight lines are off by less
RIDGE_STEP = 1e-3        # [m]; the places x of a ridge are known better


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
        return hull([(x - size - step, x + size + step, s - step, s + step)
                     for x, s, size in zip(ridge.x[k], ridge.s[k], reach)])

    def place(self, x, s):
        """The place (3,) of x, s [m] on the curve in the track frame."""
        return np.array([x, float(self.curve.at("y", s)), float(self.curve.at("z", s))])


def turning_gap(pair, penetration):
    """The :class:`TurningGap` of a wheel that just touches, with its curve for a ``penetration`` [m].
    Stations count from the inner end of the rail."""
    return TurningGap(pair, middle_curve(pair.lowered(penetration)), penetration, penetration)
