"""A profile as the kernel reads it: quintic pieces found through uniform bins.

Table at ``base``: start, stop, bins per metre, bin count, offset of the pieces, then for each bin the offset of the first
piece that reaches into it, then per piece its start and six coefficients; the piece after the last starts at not-a-number, which no
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
    at = base + int(tables[base + BINS + int(u)])
    while y >= tables[at + PIECE_SIZE]:
        at += PIECE_SIZE
    return at


def height_slope(tables: 'float[:]', base: int, y: float):
    """Height [m] and slope [-] of the profile at ``y`` [m]."""
    at = find_piece(tables, base, y)
    u = y - tables[at]
    # Horner's scheme, and again on the quotient that it leaves
    c5 = tables[at + 6]
    p4 = tables[at + 5] + u * c5
    p3 = tables[at + 4] + u * p4
    p2 = tables[at + 3] + u * p3
    p1 = tables[at + 2] + u * p2
    slope = p1 + u * (p2 + u * (p3 + u * (p4 + u * c5)))
    return tables[at + 1] + u * p1, slope


def height_slope_bend(tables: 'float[:]', base: int, y: float):
    """Height [m], slope [-] and second derivative [1/m] of the profile at ``y`` [m]."""
    at = find_piece(tables, base, y)
    u = y - tables[at]
    # Horner's scheme, and twice again on the quotient that it leaves
    c5 = tables[at + 6]
    p4 = tables[at + 5] + u * c5
    p3 = tables[at + 4] + u * p4
    p2 = tables[at + 3] + u * p3
    p1 = tables[at + 2] + u * p2
    q4 = p4 + u * c5
    q3 = p3 + u * q4
    q2 = p2 + u * q3
    half_bend = q2 + u * (q3 + u * (q4 + u * c5))
    return tables[at + 1] + u * p1, p1 + u * q2, 2.0 * half_bend
