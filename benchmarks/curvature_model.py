"""ANALYN on dense gap curves, for any lateral curvature; used by the curvature study.

The recipe is that of wrcontact/kernel/normal/analyn_contact.py (docs/theory/analyn.md)::

    force -> estimated penetration -> regions, their half-widths -> curvatures (the scheme) -> levels -> patch

Here it stands on 800 stations per region and takes three curvatures: B_edge in 1 + beta, B_length in 1 +
alpha and B_load in n r.  Sichani et al. (2014) use one for all.
"""

from dataclasses import dataclass
from math import pi, sqrt

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

from data import halfspace_reference
from wrcontact.study.sections import NR, ONE_ALPHA, RANGE

MODULUS = halfspace_reference.CONTACT_MODULUS  # E* [Pa]
FLOOR = 0.02  # smallest B as a share of A
STATIONS = 800  # of a region
COVER = 1.35  # half-widths that they reach


def one_alpha(A, B):
    return ONE_ALPHA(np.clip(np.log(B / A), -RANGE, RANGE))


def one_beta(A, B):
    return one_alpha(B, A)


def nr(A, B):
    return NR(np.clip(np.log(B / A), -RANGE, RANGE))


class Curve:
    """g(s) and A(s) of a case as splines, with the stations where g has a minimum or a hump."""

    def __init__(self, case):
        self.start, self.stop = case.s[0], case.s[-1]
        self.gap, self.A = CubicSpline(case.s, case.g), CubicSpline(case.s, case.A)
        turns = self.gap.derivative().roots(extrapolate=False)
        bend = self.gap.derivative(2)(turns)
        self.minima, self.humps = turns[bend > 0], turns[bend < 0]

    def hump_between(self, low, high):
        """Station and gap of the highest hump between two minima."""
        inside = self.humps[(self.humps > low) & (self.humps < high)]
        top = inside[np.argmax(self.gap(inside))]
        return top, float(self.gap(top))

    def width(self, origin, direction, level, bound):
        """Distance from ``origin`` to where the gap has first risen by ``level``, or to the ``bound`` [m]."""
        end = min(
            (bound - origin) * direction, ((self.stop if direction > 0 else self.start) - origin) * direction
        )

        def rise(t):
            return float(self.gap(origin + direction * t) - self.gap(origin)) - level

        t = np.linspace(0, end, 400)
        above = np.flatnonzero(self.gap(origin + direction * t) - self.gap(origin) > level)
        return brentq(rise, t[above[0] - 1], t[above[0]]) if len(above) else end


@dataclass
class Region:
    """A region with its origin; ``rise(t)`` is the gap over its minimum, t (n,) counts from the origin
    [m]."""

    curve: Curve
    origin: float
    low: float = -np.inf
    high: float = np.inf

    def measure(self, level, share):
        """Half-widths of the interpenetration at ``share`` times the estimated ``level``, stations, gap and A
        there."""
        self.level, curve = level, self.curve
        self.gap = float(curve.gap(self.origin))
        self.left = curve.width(self.origin, -1, share * level, self.low)
        self.right = curve.width(self.origin, 1, share * level, self.high)
        self.width = (self.left + self.right) / 2
        low = max(-COVER * self.left / sqrt(share), self.low - self.origin, curve.start - self.origin)
        high = min(COVER * self.right / sqrt(share), self.high - self.origin, curve.stop - self.origin)
        self.t = np.linspace(low, high, STATIONS)
        self.g, self.A = self.rise(self.t), curve.A(self.origin + self.t)
        self.middle = self.origin + (self.right - self.left) / 2

    def rise(self, t):
        return self.curve.gap(np.clip(self.origin + t, self.curve.start, self.curve.stop)) - self.gap

    def weigh(self, B_edge, B_length, B_load):
        """ANALYN's coefficients at the stations, eqs. (7.1) and (7.2)."""
        B_edge, B_length, B_load = (np.maximum(B, FLOOR * self.A) for B in (B_edge, B_length, B_load))
        self.one_beta = one_beta(self.A, B_edge)
        self.line = MODULUS / nr(self.A, B_load)
        self.length = one_alpha(self.A, B_length) * self.A
        self.square = self.level / self.length[np.argmin(np.abs(self.t))]  # of its half-length, estimated
        self.pushed = 0.0  # what other regions' loads add to the gap at the stations, over that at the origin

    def excess(self, level):
        return np.maximum(level - self.one_beta * (self.g + self.pushed), 0.0)

    def load(self, level):
        return integral(self.line * self.excess(level), self.t)


def integral(values, t):
    return float(np.sum((values[1:] + values[:-1]) * np.diff(t)) / 2)


@dataclass(frozen=True)
class Model:
    """Everything that the study varies besides the curvature.

    merge : two minima are one region while the hump between them is below this share of the penetration; inf:
        always one.
    push : displacement by another region's load: None, "point", "extended" or "station" (extended, felt at
        each station).
    share : of the estimated level at which half-widths are measured.
    """

    curvature: object
    merge: float = 0.2
    push: str | None = "extended"
    share: float = 0.9

    def solve(self, case):
        """(penetration, area, peak pressure) and the solved regions."""
        curve, force = Curve(case), case.force
        estimate = estimate_penetration(curve, force)
        for _ in range(4):
            regions = find_regions(curve, estimate, self.merge)
            for region in regions:
                region.measure(max(estimate - float(curve.gap(region.origin)), 0.1 * estimate), self.share)
                region.weigh(*self.curvature(region))
            penetration = self.meet(force, regions, estimate)
            if 1 / 1.5 < penetration / estimate < 1.5:
                break
            estimate = penetration
        self.loads(regions, penetration)
        return (penetration, *patch(regions)), regions

    def meet(self, force, regions, estimate):
        """Penetration [m] at which the regions carry ``force``."""

        def missing(penetration):
            return sum(self.loads(regions, penetration)) - force

        high = estimate
        while missing(high) < 0:
            high *= 1.3
        low = high / 1.3
        while missing(low) > 0:
            low /= 1.3
        return brentq(missing, low, high, xtol=1e-13, rtol=1e-9)

    def loads(self, regions, penetration):
        """Loads of the regions at a penetration; level_i = penetration - g_i - sum_j push_ij N_j, by damped
        repetition."""
        for region in regions:
            region.solved, region.pushed = penetration - region.gap, 0.0
        loads = np.array([region.load(region.solved) for region in regions])
        for _ in range(60 if len(regions) > 1 and self.push else 0):
            change = 0.0
            for i, region in enumerate(regions):
                others = [(loads[j], other) for j, other in enumerate(regions) if j != i]
                pushed = sum(N * self.influence(region, other, region.middle) for N, other in others)
                if self.push == "station":
                    pushed = sum(N * self.influence(region, other, region.origin) for N, other in others)
                    region.pushed = (
                        sum(
                            N * self.influence(region, other, region.origin + region.t) for N, other in others
                        )
                        - pushed
                    )
                following = (region.solved + penetration - region.gap - pushed) / 2
                change = max(change, abs(following - region.solved))
                region.solved = following
            loads = np.array([region.load(region.solved) for region in regions])
            if change < 1e-9 * penetration:
                break
        return loads

    def influence(self, region, other, station):
        """What one newton on ``other`` pushes ``region`` down at ``station`` [m/N].

        1 / (pi E* distance) for points.  Patches are long along the track, and x^2 is a^2/5 in the mean over
        each of them, which stretches the distance: distance^2 + k (a_i^2 + a_j^2) with k = 0.2 near the point
        limit; 0.3 was measured.
        """
        square = (station - other.middle) ** 2
        if self.push != "point":
            square = square + 0.3 * (region.square + other.square)
        return 1 / (pi * MODULUS * np.sqrt(square))


def patch(regions):
    """Area and peak pressure of solved regions; their half-length, pressure and line load stay with them."""
    area = peak = 0.0
    for region in regions:
        d = region.excess(region.solved)
        region.half_length, region.line_load = np.sqrt(d / region.length), region.line * d
        region.pressure = 2 / pi * region.line * np.sqrt(d * region.length)
        area += 2 * integral(region.half_length, region.t)
        peak = max(peak, region.pressure.max())
    return area, peak


def estimate_penetration(curve, force):
    """Hertz's penetration for the width of the interpenetration at a guess, as the kernel does."""
    origin = curve.minima[np.argmin(curve.gap(curve.minima))]
    A = float(curve.A(origin))
    guess = (3 * A * (0.75 * force / MODULUS) ** 2) ** (1 / 3)
    width = (curve.width(origin, 1, guess, np.inf) + curve.width(origin, -1, guess, -np.inf)) / 2
    B = np.clip(guess / width**2, FLOOR * A, 1e3 * A)
    stiffness = 4 / 3 * MODULUS / (nr(A, B) * np.sqrt(one_beta(A, B) * B))
    return float((force / stiffness) ** (2 / 3))


def find_regions(curve, penetration, merge):
    """The minima that ``penetration`` reaches, joined where the hump between them is low, bounded by it
    elsewhere."""
    lowest = curve.minima[np.argmin(curve.gap(curve.minima))]
    reached = [at for at in curve.minima if curve.gap(at) < penetration or at == lowest]
    regions = [Region(curve, at) for at in reached]
    i = 0
    while i < len(regions) - 1:
        first, second = regions[i], regions[i + 1]
        hump, gap = curve.hump_between(first.origin, second.origin)
        if gap < merge * penetration:
            deeper = min(first, second, key=lambda region: float(curve.gap(region.origin)))
            deeper.low, deeper.high = first.low, second.high
            regions[i : i + 2] = [deeper]
        else:
            first.high = second.low = hump
            i += 1
    return regions
