"""The search's raster over the wheel by numpy, with the bounds that certify it, as a witness of
kernel/prepare/scan.py."""

import numpy as np

from wrcontact.kernel.layout import EXPONENTS, SCAN_LIMIT, Profile, RailCell, Scan, ScanNode, size
from wrcontact.kernel.search.bounds import STEEP, WIDEST
from wrcontact.profiles.compiled import evaluate_table, table_pieces

COARSE_STEP = 1.0e-3  # [m]
FINE_STEP = 0.5e-3    # [m]
#: Where the wheel's second derivative stays below this the coarse step does [1/m]: 20 (1e-3)^2 / 8 = 2.5 um.
STRAIGHT = 20.0
TOO_STEEP = 1e9       # [1/m]
SAMPLES = 17          # of the second derivative in a piece, a cubic there


def scan_table(wheel, rail, radius, arm):
    """Scan nodes on the wheel and raster of the rail, each with bounds of the second derivative over
    stretches of 1, 2, 4 ... cells, from both compiled profile tables; ``radius`` is the nominal one, ``arm``
    half the distance of the running circles [m].

    Raises
    ------
    ValueError
        when the wheel is wider than the raster.
    """
    wheel_bends, rail_bends = BendRange(wheel), BendRange(rail)
    y, first = _raster(wheel_bends)
    if len(y) > SCAN_LIMIT:
        raise ValueError(f"the wheel profile is {wheel_bends.stop - wheel_bends.start:.4g} m wide; "
                         f"permitted are at most "
                         f"{SCAN_LIMIT * FINE_STEP:.4g} m")
    nodes, bounds = _wheel_rows(wheel, wheel_bends, y), _rail_rows(rail_bends)
    nodes["lever"] = _levers(wheel, y, radius, arm)
    steepest = wheel_bends.between(np.array([wheel_bends.start]), np.array([wheel_bends.stop]))[2][0]
    head = Scan.nodes.offset // 8
    cells = head + len(nodes) * size(ScanNode)
    bins = cells + len(bounds) * size(RailCell)
    return np.concatenate([[len(nodes), len(bounds), rail_bends.start, 1.0 / FINE_STEP, cells, bins,
                            len(first), len(first) / (wheel_bends.stop - wheel_bends.start), steepest],
                           nodes.view(float), bounds.view(float), first.astype(float)])


class BendRange:
    """Range of the second derivative and the slope of a compiled profile between two abscissae.

    Every piece is sampled with both its ends, so that a jump of curvature counts with both its sides.
    """

    def __init__(self, table):
        self.table = table
        self.start, self.stop = Profile.at(table).start, Profile.at(table).stop
        pieces = table_pieces(table)[:-1]
        widths = np.diff(np.append(pieces[:, 0], self.stop))[:, None]
        u = widths * np.linspace(0.0, 1.0, SAMPLES)
        c1, c2, c3, c4, c5 = (column[:, None] for column in pieces[:, 2:].T)
        self._y = (pieces[:, :1] + u).ravel()
        self._slopes = (c1 + u * (2 * c2 + u * (3 * c3 + u * (4 * c4 + u * 5 * c5)))).ravel()
        self._bends = (2 * c2 + u * (6 * c3 + u * (12 * c4 + u * 20 * c5))).ravel()

    def between(self, low, high):
        """Smallest and largest second derivative [1/m] and largest absolute slope [-], three arrays (n,),
        between ``low`` and ``high`` (n,), clipped to the profile."""
        low, high = np.clip(low, self.start, self.stop), np.clip(high, self.start, self.stop)
        _, slopes, bends = evaluate_table(self.table, np.stack([low, high]))
        samples = np.searchsorted(self._y, low), np.searchsorted(self._y, high, side="right")
        return (np.minimum(bends.min(axis=0), _over(np.minimum, self._bends, *samples, np.inf)),
                np.maximum(bends.max(axis=0), _over(np.maximum, self._bends, *samples, -np.inf)),
                np.maximum(np.abs(slopes).max(axis=0),
                           _over(np.maximum, np.abs(self._slopes), *samples, 0.0)))


def _over(extreme, values, first, last, nothing):
    """``extreme`` (n,) of values[first:last] for arrays (n,) of indices, and ``nothing``
    where these are empty."""
    ends = np.stack([first, last], axis=1).ravel()
    return np.where(last > first, extreme.reduceat(np.append(values, nothing), ends)[::2], nothing)


def _wheel_rows(wheel, bends, y):
    """The records ScanNode of the nodes ``y`` (n,), without levers; stretches end with the table.

    Stretches that are steeper than the search's bounds allow get a second derivative with
    which they are not skipped.
    """
    nodes = np.zeros(len(y), ScanNode)
    nodes["y"] = y
    nodes["height"], nodes["slope"], _ = evaluate_table(wheel, y)
    last = len(y) - 1
    for exponent in range(EXPONENTS):
        least, most, steepest = bends.between(y, y[np.minimum(np.arange(len(y)) + 2**exponent, last)])
        nodes["most_bends"][:, exponent] = np.where(steepest < STEEP, most, TOO_STEEP)
        nodes["steepest_bends"][:, exponent] = np.maximum(np.abs(least), np.abs(most))
        if exponent == 0:
            nodes["least_bend"] = least
    return nodes


def _levers(wheel, y, radius, arm):
    """The largest lever of each node ``y`` (n,) and all beyond it [m]: how the gap of a wheelset at zero roll
    changes with the roll."""
    widths = np.append(np.diff(y), 0.0)[:, None]
    places = y[:, None] + widths * np.linspace(0.0, 1.0, SAMPLES)[:-1]
    z, slope, _ = evaluate_table(wheel, places)
    levers = np.max(-slope * (radius + z) - (arm + places), axis=1)
    return np.maximum.accumulate(levers[::-1])[::-1]


def _rail_rows(bends):
    """The records RailCell of the rail's raster.

    A stretch starts in a raster cell and is as long as 1, 2, 4 ... FINE_STEPs of the
    wheel, stretched by WIDEST.
    """
    count = int(np.ceil((bends.stop - bends.start) / FINE_STEP))
    edges = bends.start + FINE_STEP * np.arange(count)
    rows = np.zeros(count, RailCell)
    # a wheel cell starts in a raster cell and is COARSE_STEP long, a quarter more when yawed
    rows["least_bend"], rows["most_bend"] = bends.between(edges - FINE_STEP,
                                                          edges + FINE_STEP + 1.5 * COARSE_STEP)[:2]
    for exponent in range(EXPONENTS + 1):
        length = FINE_STEP * (1.01 + (1.0 + WIDEST) * 1.01 * 2**exponent)
        rows["least_bends"][:, exponent] = bends.between(edges - 0.01 * FINE_STEP, edges + length)[0]
    return rows


def _raster(bends):
    """Abscissae (n,) of the scan nodes, no more than COARSE_STEP apart from one end of the
    wheel to the other, half as much where it is not nearly straight; and the number of the
    first node in each coarse step."""
    count = int(np.ceil((bends.stop - bends.start) / COARSE_STEP))
    step = (bends.stop - bends.start) / count
    edges = np.append(bends.start + step * np.arange(count), bends.stop)
    least, most, _ = bends.between(edges[:-1], edges[1:])
    halved = np.maximum(np.abs(least), np.abs(most)) > STRAIGHT
    y = np.sort(np.concatenate([edges, edges[:-1][halved] + 0.5 * step]))
    return y, np.arange(count) + np.concatenate([[0], np.cumsum(halved)[:-1]])
