"""Surfaces whose normals are parallel, given by their distance as a function."""

import numpy as np

from .boxes import centres
from .window import LOOK, LOOK_SLACK, Ridge, dip, find_window


class FlatGap:
    """The distance of two surfaces over a plane, by a function of x (n,) and s (m,) [m] that returns (n, m)
    [m].

    Attributes
    ----------
    gap : the function: undeformed distance at no penetration, infinite where there is no surface.
    """

    def __init__(self, gap):
        self.gap = gap

    def angle(self, s):
        """Angles of the normals at stations (m,) [rad]: of a plane all are zero."""
        return np.zeros(len(s))

    def share(self, s):
        """How much a penetration takes from the gap at stations (m,), per length: of a plane, all of it."""
        return np.ones(len(s))

    def near(self, penetration):
        """The surfaces with gaps that are exact at this penetration: of a plane they are at any."""
        return self

    def window(self, problem):
        """Box (x_low, x_high, s_low, s_high) [m] of what the load's penetration reaches, all patches
        together."""
        return find_window(self.gap, problem)

    def ridge(self, domain):
        """The :class:`Ridge` by samples.

        Along x a wheel's gap is smooth and has one minimum: the parabola through the three lowest of few
        samples finds it. Across, samples are dense.
        """
        x, s = centres(domain, LOOK)
        gap = np.asarray(self.gap(x, s), dtype=float)
        columns = np.arange(len(s))
        k = np.clip(gap.argmin(axis=0), 1, len(x) - 2)
        before, here, after = (gap[k + step, columns] for step in (-1, 0, 1))
        with np.errstate(invalid="ignore", divide="ignore"):
            bend = before - 2.0 * here + after
            turn = np.clip(np.where(bend > 0.0, 0.5 * (before - after) / bend, 0.0), -1.0, 1.0)
            fall = np.where(bend > 0.0, 0.5 * bend * turn**2, 0.0)
        turn, fall = np.nan_to_num(turn), np.nan_to_num(fall, posinf=0.0)
        low = np.minimum(here - fall, gap.min(axis=0))
        step = x[1] - x[0]
        return Ridge(s, x[k] + turn * step, low, LOOK_SLACK * fall + dip(low[None])[0], step)
