"""The arc of a profile in equal bins, and amounts that are shared among them without loss."""

import math

import numpy as np

from ..conventions import MILLIMETRE as MM
from ..profiles.zones import Polynomial

#: Spacing of the points that stand for the arc [m].
RASTER = 0.01e-3


class Arc:
    """The curve of a ``profile`` by its arc length, as a contact sees it.

    Contacts name places on a rail in the frame of the inclined head (docs/reference/conventions.md), on a
    wheel in that of the profile; ``abscissa`` is that coordinate.

    Attributes
    ----------
    profile; inclination of a rail, as a slope; gauge_depth, at which its gauge is measured [m].
    y : (n,) of the profile itself [m]; abscissa : (n,) of the same points as contacts name them [m].
    s : (n,) arc length from the first point [m]; edges : (bins + 1,) of equal bins [m].
    """

    def __init__(self, profile, inclination=0.0, bin_width=0.25e-3, gauge_depth=14e-3):
        self.profile, self.inclination, self.gauge_depth = profile, inclination, gauge_depth
        room = 1e-9 + 1e-7 * (profile.stop - profile.start)  # an end may be vertical
        count = math.ceil((profile.stop - profile.start) / RASTER)
        self.y = np.linspace(profile.start + room, profile.stop - room, count + 1)
        self.height = evaluate(profile, self.y)[0]
        chords = np.hypot(np.diff(self.y), np.diff(self.height))
        self.s = np.concatenate([[0.0], np.cumsum(chords)])
        self.edges = np.linspace(0.0, self.s[-1], math.ceil(self.s[-1] / bin_width) + 1)
        self.abscissa = self.y if profile.kind == "wheel" else self._inclined(math.atan(inclination))

    def _inclined(self, angle):
        """Abscissae (n,) of the head that leans by ``angle`` [rad], from its highest point."""
        across = math.cos(angle) * self.y + math.sin(angle) * self.height
        down = math.cos(angle) * self.height - math.sin(angle) * self.y
        k = int(np.clip(np.argmin(down), 1, len(down) - 2))
        before, here, after = down[k - 1 : k + 2]  # the lowest point of a parabola
        bend = before - 2.0 * here + after
        aside = 0.5 * (before - after) / bend if bend > 0.0 else 0.0
        top = across[k] + np.clip(aside, -1.0, 1.0) * 0.5 * (across[k + 1] - across[k - 1])
        return np.maximum.accumulate(across) - top

    @property
    def middles(self):
        """Arc lengths (bins,) of the middles of the bins [m]."""
        return 0.5 * (self.edges[1:] + self.edges[:-1])

    @property
    def places(self):
        """Abscissae (bins,) of the middles [m]."""
        return np.interp(self.middles, self.s, self.abscissa)

    @property
    def own_places(self):
        """The same in the frame of the profile itself, also of an inclined rail [m]."""
        return np.interp(self.middles, self.s, self.y)

    def interpolated(self, values, y):
        """``values`` (bins,) at places ``y`` [m] of the profile itself."""
        return np.interp(y, self.own_places, values)

    @property
    def width(self):
        """Arc length of a bin [m]."""
        return self.edges[1]

    def at(self, abscissa):
        """Arc lengths of places [m]; the ends for places beyond them."""
        return np.interp(abscissa, self.abscissa, self.s)


def evaluate(profile, y):
    """Height and slope of a profile as its own ``evaluate``, in a tenth of the time where it has many zones;
    ``y`` (n,) [m] lies in it."""
    zones, y = profile.zones, np.asarray(y, dtype=float) / MM
    of = np.searchsorted([zone.stop for zone in zones[:-1]], y)
    terms = max((len(zone.coefficients) for zone in zones if isinstance(zone, Polynomial)), default=0)
    table = np.zeros((len(zones), terms + 1))  # origin, coefficients
    for row, zone in zip(table, zones):
        if isinstance(zone, Polynomial):
            row[0], row[1 : 1 + len(zone.coefficients)] = zone.origin, zone.coefficients
    u, height, slope = y - table[of, 0], np.zeros(len(y)), np.zeros(len(y))
    for column in range(terms, 0, -1):
        slope = slope * u + height
        height = height * u + table[of, column]
    for k, zone in enumerate(zones):
        if not isinstance(zone, Polynomial):
            inside = of == k
            height[inside], slope[inside], _ = zone(np.clip(y[inside], zone.start, zone.stop))
    return height * MM, slope


def deposit(arc, start, stop, amount, rows, count):
    """Sums (count, bins) of amounts that are spread evenly from ``start`` to ``stop``.

    Parameters
    ----------
    arc : :class:`Arc`; what lies beyond its ends goes to the first and the last bin.
    start, stop : (m,) arc lengths [m].
    amount : (m,) of each stretch.
    rows : (m,) to which of the ``count`` sums it goes.

    The shares of a stretch add up to the whole of it.

    >>> from ..profiles.catalogue import standard_profile
    >>> arc = Arc(standard_profile("S1002"))
    >>> sums = deposit(arc, np.array([0.03]), np.array([0.031]), np.array([2.0]), np.array([0]), 1)
    >>> float(sums.sum()), int((sums > 0.0).sum()) in (4, 5)
    (2.0, True)
    """
    bins = len(arc.edges) - 1
    start, stop = np.clip(start, 0.0, arc.edges[-1]), np.clip(stop, 0.0, arc.edges[-1])
    length = stop - start
    first = np.clip((start / arc.width).astype(int), 0, bins - 1)
    last = np.clip((stop / arc.width).astype(int), first, bins - 1)
    sums = np.zeros(count * bins)
    left = np.array(amount, dtype=float)
    for step in range(int((last - first).max(initial=0)) + 1):
        there = np.flatnonzero(first + step <= last)
        k = first[there] + step
        inside = np.minimum(stop[there], arc.edges[k + 1]) - np.maximum(start[there], arc.edges[k])
        share = amount[there] * np.maximum(inside, 0.0) / np.where(length[there] > 0.0, length[there], 1.0)
        share = np.where(k == last[there], left[there], np.minimum(share, left[there]))  # the rest
        left[there] -= share
        sums += np.bincount(rows[there] * bins + k, share, count * bins)
    return sums.reshape(count, bins)
