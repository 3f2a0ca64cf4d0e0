"""What is read from tables: a function from cubics over even cells (the record CubicTable); heights, slopes
and bends of a profile from its quintic pieces (the record Profile).

An abscissa that is not a number, infinite or far outside is read from a piece at an end: nothing outside the
table is read.
"""

from ..elementary.binary import counted
from ..layout import PIECE_SIZE, CubicTable, Piece, Profile, inlined


def table_cell(u: float, last: float):
    """The cell that holds ``u`` [cells], and where in it, 0 ... 1.

    ``u`` is clamped to 0 ... ``last``, and is 0 if it is not a number.  At an end it still moves.
    """
    place = 0.0
    if u >= 0.0:
        place = min(u, last)
    cell = int(place)
    if cell > int(last) - 1:
        cell = int(last) - 1
    return cell, place - float(cell)


def read_cubic(table: CubicTable, at: float):
    """Value of the function; outside the table, that at its end."""
    cell, x = table_cell((at - table.start) * table.cells_per_unit, table.count)
    cubic = table.cells[cell]
    return cubic.value + x * (cubic.slope + x * (cubic.bend + x * cubic.third))


def read_cubic_jet(table: CubicTable, at: float):
    """Value of the function and its derivative; outside the table, those at its end."""
    cell, x = table_cell((at - table.start) * table.cells_per_unit, table.count)
    cubic = table.cells[cell]
    q2 = cubic.bend + x * cubic.third
    q1 = cubic.slope + x * q2
    return cubic.value + x * q1, (q1 + x * (q2 + x * cubic.third)) * table.cells_per_unit


def find_piece(profile: Profile, y: float) -> Piece:
    """The piece that holds ``y`` [m]."""
    u = (y - profile.start) * profile.bins_per_metre
    last = profile.bin_count - 1.0
    u = min(max(0.0, u), last)
    piece = Piece.at(profile, counted(profile.bins[int(u)]))
    while y >= piece.stop:
        piece = Piece.at(piece, PIECE_SIZE)
    return piece


def height_slope(profile: Profile, y: float):
    """Height [m] and slope [-] of the profile at ``y`` [m]."""
    piece = find_piece(profile, y)
    u = y - piece.start
    # Horner's scheme, and again on the quotient that it leaves
    p4 = piece.c4 + u * piece.c5
    p3 = piece.c3 + u * p4
    p2 = piece.c2 + u * p3
    p1 = piece.c1 + u * p2
    slope = p1 + u * (p2 + u * (p3 + u * (p4 + u * piece.c5)))
    return piece.c0 + u * p1, slope


@inlined
def height_slope_bend(profile: Profile, y: float):
    """Height [m], slope [-] and second derivative [1/m] of the profile at ``y`` [m]."""
    piece = find_piece(profile, y)
    u = y - piece.start
    # Horner's scheme as in height_slope, which is called most, and twice again on the quotient that it leaves
    p4 = piece.c4 + u * piece.c5
    p3 = piece.c3 + u * p4
    p2 = piece.c2 + u * p3
    p1 = piece.c1 + u * p2
    q4 = p4 + u * piece.c5
    q3 = p3 + u * q4
    q2 = p2 + u * q3
    half_bend = q2 + u * (q3 + u * (q4 + u * piece.c5))
    return piece.c0 + u * p1, p1 + u * q2, 2.0 * half_bend
