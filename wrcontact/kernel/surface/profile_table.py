"""Heights, slopes and bends of a profile, from its table of quintic pieces (the record Profile).

An abscissa that is not a number, infinite or far outside is read from a piece at an end: nothing outside the
table is read.
"""

from ..layout import PIECE_SIZE, Piece, Profile


def find_piece(profile: Profile, y: float) -> Piece:
    """The piece that holds ``y`` [m]."""
    u = (y - profile.start) * profile.bins_per_metre
    last = profile.bin_count - 1.0
    if not u > 0.0:
        u = 0.0
    if u > last:
        u = last
    piece = Piece.at(profile, int(profile.bins[int(u)]))
    while y >= Piece.at(piece, PIECE_SIZE).start:
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
