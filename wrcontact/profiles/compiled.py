"""A profile as the kernel reads it: a table of quintic pieces, which kernel/prepare/pieces.py makes
from the exact zones."""

import numpy as np

from ..kernel.layout import PIECE_SIZE, Profile, offset


def table_pieces(table):
    """Pieces (n + 1, 8) in a compiled profile's ``table``: start [m], coefficients, and where the next one
    starts [m]; the last row is after the end."""
    profile = Profile.at(table)
    return table[offset(profile.pieces, profile) :].reshape(-1, PIECE_SIZE)


def evaluate_table(table, y):
    """Height, slope and second derivative [m, 1, 1/m] that the kernel reads from ``table`` at
    ``y`` [m], three arrays.

    Valid between start and stop; only the kernel extends the end pieces.
    """
    pieces = table_pieces(table)
    y = np.asarray(y, dtype=float)
    index = np.clip(np.searchsorted(pieces[:-1, 0], y, side="right") - 1, 0, len(pieces) - 2)
    u = y - pieces[index, 0]
    c0, c1, c2, c3, c4, c5 = np.moveaxis(pieces[index, 1:7], -1, 0)
    p4 = c4 + u * c5  # the same bits as profile_table.height_slope_bend
    p3 = c3 + u * p4
    p2 = c2 + u * p3
    p1 = c1 + u * p2
    q4 = p4 + u * c5
    q3 = p3 + u * q4
    q2 = p2 + u * q3
    return c0 + u * p1, p1 + u * q2, 2 * (q2 + u * (q3 + u * (q4 + u * c5)))


def ends(table):
    """First and last abscissa (2,) of ``table`` [m]."""
    profile = Profile.at(table)
    return profile.start, profile.stop


def places(table, step):
    """Evenly spaced abscissae (n,) over the whole ``table``, both ends included, at
    most ``step`` apart [m]."""
    start, stop = ends(table)
    return np.linspace(start, stop, int((stop - start) / step) + 2)
