"""A profile as the kernel reads it: quintic pieces found through uniform bins.

Table at ``base``: start, stop, bins per metre, bin count, offset of the pieces, then for each bin the first piece that
reaches into it, then per piece its start and six coefficients; the piece after the last starts at not-a-number, which no
abscissa reaches.  An abscissa that is not a number, infinite or far outside reads an end piece: nothing leaves the table.
"""

from typing import Final

START: Final[int] = 0
STOP: Final[int] = 1
BINS_PER_METRE: Final[int] = 2
BIN_COUNT: Final[int] = 3
PIECE_OFFSET: Final[int] = 4
BINS: Final[int] = 5
PIECE_SIZE: Final[int] = 7


def find_piece(tables: 'float[:]', base: int, y: float):
    """Offset in ``tables`` of the piece that holds ``y`` [m]."""
    u = (y - tables[base + START]) * tables[base + BINS_PER_METRE]
    last = tables[base + BIN_COUNT] - 1.0
    if not u > 0.0:
        u = 0.0
    if u > last:
        u = last
    piece = int(tables[base + BINS + int(u)])
    at = base + int(tables[base + PIECE_OFFSET]) + PIECE_SIZE * piece
    while y >= tables[at + PIECE_SIZE]:
        at += PIECE_SIZE
    return at


def height_slope(tables: 'float[:]', base: int, y: float):
    """Height [m] and slope [-] of the profile at ``y`` [m]."""
    at = find_piece(tables, base, y)
    u = y - tables[at]
    c1 = tables[at + 2]
    c2 = tables[at + 3]
    c3 = tables[at + 4]
    c4 = tables[at + 5]
    c5 = tables[at + 6]
    z = tables[at + 1] + u * (c1 + u * (c2 + u * (c3 + u * (c4 + u * c5))))
    slope = c1 + u * (2.0 * c2 + u * (3.0 * c3 + u * (4.0 * c4 + u * (5.0 * c5))))
    return z, slope


def height_slope_bend(tables: 'float[:]', base: int, y: float):
    """Height [m], slope [-] and second derivative [1/m] of the profile at ``y`` [m]."""
    at = find_piece(tables, base, y)
    u = y - tables[at]
    c1 = tables[at + 2]
    c2 = tables[at + 3]
    c3 = tables[at + 4]
    c4 = tables[at + 5]
    c5 = tables[at + 6]
    z = tables[at + 1] + u * (c1 + u * (c2 + u * (c3 + u * (c4 + u * c5))))
    slope = c1 + u * (2.0 * c2 + u * (3.0 * c3 + u * (4.0 * c4 + u * (5.0 * c5))))
    bend = 2.0 * c2 + u * (6.0 * c3 + u * (12.0 * c4 + u * (20.0 * c5)))
    return z, slope, bend
