"""What is read from a pressure field: the edge of a patch within its cells, its area, length
and width, and the peak."""

import math

import numpy as np
from scipy import ndimage

EDGE_LAYERS = 3  # cells by which a patch's p^2 is continued to find its edge
EDGE_PAD = EDGE_LAYERS + 1  # cells by which an edge field is larger than its pressure field, on each side
#: The edge of a grid's patch lies this far outside [cells]: Hertz's ellipses, 0.02 (1:10) ... 0.06
#: (circle), 40 to 140 cells.
EDGE_BIAS = 0.04
DIRECTIONS = [(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1) if (i, j) != (0, 0)]


def edge_field(pressure):
    """A field (n + 2 EDGE_PAD, m + 2 EDGE_PAD) [Pa^2] whose zero line is the edge of the loaded
    cells, found within the cells.

    Towards the edge of a patch p^2 falls linearly (Hertz). The outermost cells are loaded in part
    only and do not know; so p^2 of the cells behind them is continued along rows, columns and
    diagonals, and where several reach a cell their mean is taken. (H6) A patch without inner cells is
    left as it is, with half its p^2 outside.
    """
    loaded = np.pad(pressure > 0.0, EDGE_PAD + 1)
    square = np.pad(pressure**2, EDGE_PAD + 1)
    known = ndimage.binary_erosion(loaded, np.ones((3, 3)))
    square = np.where(known, square, 0.0)
    for _ in range(EDGE_LAYERS):
        square, known = _continued(square, known)
    near = ndimage.binary_dilation(loaded, np.ones((3, 3)))
    square[~near] = np.minimum(square[~near], 0.0)
    lost = loaded & ~known
    inner = (slice(EDGE_PAD + 1, -EDGE_PAD - 1),) * 2
    square[lost] = (pressure**2)[lost[inner]]
    border = ~loaded & ndimage.binary_dilation(lost, np.ones((3, 3))) & ~known
    square[border] = -ndimage.maximum_filter(np.where(lost, square, 0.0), 3)[border]
    return square[1:-1, 1:-1]


def _continued(square, known):
    """``square`` continued by one cell around the ``known`` ones, and which are known then: by parabolas
    through three cells in line, which are exact for Hertz's p^2, or straight where only two are known."""
    places = np.nonzero(ndimage.binary_dilation(known, np.ones((3, 3))) & ~known)
    total, count = np.zeros(len(places[0])), np.zeros(len(places[0]))
    for step in DIRECTIONS:
        lines = [tuple(place - k * away for place, away in zip(places, step)) for k in (1, 2, 3)]
        one, two, three = (square[line] for line in lines)
        straight = known[lines[0]] & known[lines[1]]
        curved = straight & known[lines[2]]
        total += np.where(curved, 3.0 * (one - two) + three, np.where(straight, 2.0 * one - two, 0.0))
        count += straight
    reached = tuple(place[count > 0.0] for place in places)
    square[reached] = total[count > 0.0] / count[count > 0.0]
    known = known.copy()
    known[reached] = True
    return square, known


def loaded_area(pressure):
    """Loaded area in cells: inside the zero line of :func:`edge_field`, less EDGE_BIAS along it."""
    return edge_area(edge_field(pressure))


def edge_area(values):
    """Area in cells where ``values`` (n, m), linear on the four triangles of each square of centres, are
    positive, less EDGE_BIAS along its edge."""
    corners = np.stack([values[:-1, :-1], values[1:, :-1], values[1:, 1:], values[:-1, 1:]])
    positive = (corners > 0.0).sum(axis=0)
    cut = corners[:, (positive > 0) & (positive < 4)]
    middle = cut.mean(axis=0)
    triangles = np.concatenate([np.stack([cut[k], cut[(k + 1) % 4], middle]) for k in range(4)], axis=1)
    inside = np.count_nonzero(positive == 4) + 0.25 * _positive_share(triangles).sum()
    # of the edge: a closed line meets 4/pi squares per unit of its length
    length = math.pi / 4 * cut.shape[1]
    return float(inside - EDGE_BIAS * length)


def _positive_share(corners):
    """Share of triangles on which linear functions with ``corners`` (3, n) are positive."""
    low, middle, high = np.sort(corners, axis=0)
    share = np.where(low > 0.0, 1.0, 0.0)
    one = (high > 0.0) & (middle <= 0.0)
    two = (middle > 0.0) & (low <= 0.0)
    share[one] = (high[one] / (high[one] - low[one])) * (high[one] / (high[one] - middle[one]))
    share[two] = 1.0 - (low[two] / (low[two] - middle[two])) * (low[two] / (low[two] - high[two]))
    return share


def peak_pressure(pressure):
    """The highest pressure [Pa]: parabolas along x and s through the highest cell and
    its loaded neighbours."""
    i, j = np.unravel_index(np.argmax(pressure), pressure.shape)
    return float(pressure[i, j] + _rise(pressure[:, j], i) + _rise(pressure[i], j))


def _rise(row, k):
    """Height of the vertex of the parabola through k - 1, k, k + 1 over ``row[k]``; 0 at an end."""
    if not 0 < k < len(row) - 1 or row[k - 1] == 0.0 or row[k + 1] == 0.0:
        return 0.0
    bend = 2.0 * row[k] - row[k - 1] - row[k + 1]
    return (row[k + 1] - row[k - 1]) ** 2 / (8.0 * bend) if bend > 0.0 else 0.0


def chords(edge):
    """Length of the positive part along x of each column of an edge field [cells],
    (m,): the sum over its runs."""
    low, high = edge[:-1], edge[1:]
    larger, smaller = np.maximum(low, high), np.minimum(low, high)
    spread = np.where(larger > smaller, larger - smaller, 1.0)
    share = np.where(smaller > 0.0, 1.0, np.where(larger > 0.0, larger / spread, 0.0))
    ends = np.count_nonzero((larger > 0.0) & (smaller <= 0.0), axis=0)
    return np.maximum(share.sum(axis=0) - EDGE_BIAS * ends, 0.0)[EDGE_PAD:-EDGE_PAD]


def extent(edge):
    """First and last place along s where an edge field is positive [cells], from the
    centre of the first cell."""
    start = _first_positive(edge) - EDGE_PAD
    stop = edge.shape[1] - 1 - _first_positive(edge[:, ::-1]) - EDGE_PAD
    return start + EDGE_BIAS, stop - EDGE_BIAS


def _first_positive(edge):
    """The lowest place along s where a row of ``edge`` becomes positive [cells]."""
    first = np.argmax(edge > 0.0, axis=1)
    rows = np.flatnonzero(first > 0)
    inside, outside = edge[rows, first[rows]], edge[rows, first[rows] - 1]
    return float(np.min(first[rows] - inside / (inside - outside)))
