"""From exact profiles to the kernel's table of quintic pieces.

Each piece has the height, slope and second derivative of the exact definition at both ends.  Joints of zones are ends of
pieces, so a jump of the curvature stays where the standard has it.  Where the printed coefficients leave a step in height
(S1002: 3.7e-5 mm at y = -26 mm and 1.2e-4 mm at y = -35 mm), both sides are led to their mean over :data:`REPAIR_WIDTH`.
Otherwise the contact would stay at an edge that no real wheel has.
"""

import math

import numpy as np

from ..conventions import MILLIMETRE as MM
from ..kernel.surface import profile_table as layout

#: Permitted height error of a piece between its ends [mm]; it is small against the 1e-9 rad required of the roll.
PIECE_ERROR = 1e-9
#: Permitted error of the second derivative between the ends [1/mm]; 1e-6 of a curvature of 1/10 mm.
PIECE_BEND_ERROR = 1e-7
LONGEST_PIECE = 1.0  # [mm]
SHORTEST_PIECE = 1e-3  # [mm]; measured profiles have knots this close
#: Distance from a joint over which a height step of the published coefficients is smoothed [mm].  On UIC60 1:40 the step at
#: y = -35 mm would hold the contact for 1 um of lateral shift.  Half a millimetre changes the curvature by at most 2 %.
REPAIR_WIDTH = 0.5
#: Smaller height steps are not repaired [mm].
REPAIRED_STEP = 1e-6
BIN_WIDTH = 0.25  # [mm]


def compile_profile(profile):
    """The kernel's table (n,) of ``profile``; lengths in metres."""
    pieces = []
    for index, zone in enumerate(profile.zones):
        before = profile.zones[index - 1] if index > 0 else None
        after = profile.zones[index + 1] if index + 1 < len(profile.zones) else None
        pieces += _zone_pieces(zone, before, after)
    return _table(pieces, profile.zones[-1].stop)


def evaluate_table(table, y):
    """Height, slope and second derivative [m, 1, 1/m] that the kernel reads from ``table`` at ``y`` [m], three arrays.

    Valid between start and stop; only the kernel extends the end pieces.
    """
    pieces = table[int(table[layout.PIECE_OFFSET]):].reshape(-1, layout.PIECE_SIZE)
    y = np.asarray(y, dtype=float)
    index = np.clip(np.searchsorted(pieces[:-1, 0], y, side="right") - 1, 0, len(pieces) - 2)
    u = y - pieces[index, 0]
    c0, c1, c2, c3, c4, c5 = np.moveaxis(pieces[index, 1:], -1, 0)
    p4 = c4 + u * c5            # the same bits as profile_table.height_slope_bend
    p3 = c3 + u * p4
    p2 = c2 + u * p3
    p1 = c1 + u * p2
    q4 = p4 + u * c5
    q3 = p3 + u * q4
    q2 = p2 + u * q3
    return c0 + u * p1, p1 + u * q2, 2 * (q2 + u * (q3 + u * (q4 + u * c5)))


def places(table, step):
    """Evenly spaced abscissae (n,) over the whole ``table``, both ends included, at most ``step`` apart [m]."""
    start, stop = table[layout.START], table[layout.STOP]
    return np.linspace(start, stop, int((stop - start) / step) + 2)


def _zone_pieces(zone, before, after):
    """Quintic pieces (start, coefficients) [mm] of one zone."""
    start, stop, pieces, tail = zone.start, zone.stop, [], []
    if before is not None and _steps(before, zone):
        inner = min(start + REPAIR_WIDTH, 0.5 * (start + stop))
        pieces.append(_quintic(start, inner, _mean_jet(before, zone, start), _jet(zone, inner)))
        start = inner
    if after is not None and _steps(zone, after):
        inner = max(stop - REPAIR_WIDTH, 0.5 * (zone.start + stop))
        tail.append(_quintic(inner, stop, _jet(zone, inner), _mean_jet(zone, after, stop)))
        stop = inner
    if stop > start:
        count = math.ceil((stop - start) / LONGEST_PIECE)
        ends = np.linspace(start, stop, count + 1)
        for low, high in zip(ends[:-1], ends[1:]):
            pieces += _refined(zone, float(low), float(high))
    return pieces + tail


def _refined(zone, low, high):
    """Pieces between ``low`` and ``high`` [mm], halved until they follow ``zone`` within the permitted errors."""
    piece = _quintic(low, high, _jet(zone, low), _jet(zone, high))
    y = np.linspace(low, high, 11)[1:-1]
    z, _, bend = zone(y)
    coefficients = np.asarray(piece[1])
    bends = coefficients[2:] * np.array([2.0, 6.0, 12.0, 20.0])
    error = np.max(np.abs(np.polyval(coefficients[::-1], y - low) - z))
    bend_error = np.max(np.abs(np.polyval(bends[::-1], y - low) - bend) / (1.0 + np.abs(bend)))
    if (error <= PIECE_ERROR and bend_error <= PIECE_BEND_ERROR) or high - low < 2 * SHORTEST_PIECE:
        return [piece]
    middle = 0.5 * (low + high)
    return _refined(zone, low, middle) + _refined(zone, middle, high)


def _steps(before, after):
    return abs(_jet(before, after.start)[0] - _jet(after, after.start)[0]) > REPAIRED_STEP


def _jet(zone, y):
    return tuple(float(part) for part in zone(y))


def _mean_jet(before, after, y):
    return tuple(0.5 * (a + b) for a, b in zip(_jet(before, y), _jet(after, y)))


def _quintic(low, high, at_low, at_high):
    """The quintic with given height, slope and second derivative at both ends, as (low, coefficients in y - low)."""
    h = high - low
    c0, c1, c2 = at_low[0], at_low[1], 0.5 * at_low[2]
    rest = at_high[0] - (c0 + h * (c1 + h * c2))
    slope = (at_high[1] - (c1 + 2 * h * c2)) * h
    bend = (at_high[2] - 2 * c2) * h * h
    cube = h * h * h
    c3 = (10 * rest - 4 * slope + 0.5 * bend) / cube
    c4 = (-15 * rest + 7 * slope - bend) / (cube * h)
    c5 = (6 * rest - 3 * slope + 0.5 * bend) / (cube * h * h)
    return low, (c0, c1, c2, c3, c4, c5)


def _table(pieces, stop):
    """Pack ``pieces`` [mm] into the layout of wrcontact/kernel/surface/profile_table.py [m]."""
    start = pieces[0][0]
    bin_count = math.ceil((stop - start) / BIN_WIDTH)
    starts = np.array([piece[0] for piece in pieces])
    left = start + BIN_WIDTH * np.arange(bin_count)
    first = np.maximum(np.searchsorted(starts, left, side="right") - 1, 0)
    head = np.zeros(layout.BINS)
    head[layout.START] = start * MM
    head[layout.STOP] = stop * MM
    head[layout.BINS_PER_METRE] = 1.0 / (BIN_WIDTH * MM)
    head[layout.BIN_COUNT] = bin_count
    head[layout.PIECE_OFFSET] = layout.BINS + bin_count
    body = np.full((len(pieces) + 1, layout.PIECE_SIZE), np.nan)
    scale = MM ** (1.0 - np.arange(6))
    for row, (low, coefficients) in zip(body, pieces):
        row[0] = low * MM
        row[1:] = np.asarray(coefficients) * scale
    return np.concatenate([head, head[layout.PIECE_OFFSET] + layout.PIECE_SIZE * first, body.ravel()])
