"""Profiles placed on the track and compiled to the kernel's table by numpy, from the exact zones: the witness
of kernel/prepare/zones.py and kernel/prepare/pieces.py."""

import math

import numpy as np

from wrcontact.conventions import MILLIMETRE as MM
from wrcontact.kernel.layout import PIECE_SIZE, PROFILE_HEAD
from wrcontact.kernel.layout import Profile as Table
from wrcontact.profiles.placement import PlacedRail
from wrcontact.profiles.profile import Profile
from wrcontact.profiles.zones import Arc, Moved, move_zone

#: The head is read as a function of y; it ends where it is steeper than this [rad].  Wheels are less steep
#: (75 deg at most on flanges in use), so no contact lies beyond.
STEEPEST = math.radians(80.0)
#: Permitted height error of a piece between its ends [mm]; it is small against the 1e-9 rad
#: required of the roll.
PIECE_ERROR = 1e-9
#: Permitted error of the second derivative between the ends [1/mm]; 1e-6 of a curvature of 1/10 mm.
PIECE_BEND_ERROR = 1e-7
LONGEST_PIECE = 1.0  # [mm]
SHORTEST_PIECE = 1e-3  # [mm]; measured profiles have knots this close
#: Distance from a joint over which a height step of the published coefficients is smoothed [mm]. On UIC60
#: 1:40 the step at y = -35 mm would hold the contact for 1 um of lateral shift. Half a millimetre changes the
#: curvature by at most 2 %.
REPAIR_WIDTH = 0.5
#: Smaller height steps are not repaired [mm].
REPAIRED_STEP = 1e-6
BIN_WIDTH = 0.03125  # [mm]


def place_rail(rail, *, inclination, gauge, gauge_depth):
    """The right rail on the track, as wrcontact.profiles.placement.place_rail."""
    angle = -math.atan(inclination)
    y_top, z_top = _highest_point(rail, angle)
    y_gauge = _inner_face(rail, angle, z_top + gauge_depth / MM)
    kept = [part for part in (_readable(zone, angle, -y_top, -z_top) for zone in rail.zones)
            if part is not None]
    return PlacedRail(Profile(rail.name, "rail", _around_top(kept), rail.smooth),
                      gauge / 2 + (y_top - y_gauge) * MM)


def readable_wheel(wheel):
    """``wheel`` without the parts steeper than :data:`STEEPEST` at its ends (the flange back's vertical
    start)."""
    kept = [part for part in (_readable(zone, 0.0, 0.0, 0.0) for zone in wheel.zones) if part is not None]
    return Profile(wheel.name, "wheel", _around_top(kept), wheel.smooth)


def _highest_point(rail, angle):
    """Point (y, z) [mm] of ``rail`` turned by ``angle`` where it is horizontal and highest."""
    best = None
    for zone in rail.zones:
        def slope(t, zone=zone):
            return math.sin(angle) + math.cos(angle) * float(zone(t)[1])

        inside = slope(zone.start) < 0.0 <= slope(zone.stop)
        t = _bisect(slope, zone.start, zone.stop) if inside else zone.start
        point = Moved(zone, angle).place(t)
        best = point if best is None or point[1] < best[1] else best
    return best


def _inner_face(rail, angle, depth):
    """Lateral coordinate [mm] of the turned head's inner side at the height ``depth`` [mm]."""
    deepest = -math.inf
    for zone in reversed([zone for zone in rail.zones if zone.start < 0.0]):
        moved = Moved(zone, angle)
        start_depth = moved.place(zone.start)[1]
        if start_depth >= depth:
            return moved.place(_bisect(lambda t: depth - moved.place(t)[1], zone.start,
                                       min(zone.stop, 0.0)))[0]
        deepest = max(deepest, start_depth)
    raise ValueError(f"gauge_depth reaches {depth * MM:.6g} m, but the inner side of the rail profile "
                     f"{rail.name} ends "
                     f"at {deepest * MM:.6g} m; permitted are smaller depths")


def _bisect(function, low, high):
    """Root of a rising ``function`` between ``low`` and ``high`` to the last bit."""
    while True:
        middle = 0.5 * (low + high)
        if not low < middle < high:
            return middle
        low, high = (middle, high) if function(middle) < 0.0 else (low, middle)


def _readable(zone, angle, y_shift, z_shift):
    """``zone`` turned and shifted, without what is steeper than STEEPEST; None if nothing is left."""
    if angle == y_shift == z_shift == 0.0 and not isinstance(zone, Arc):
        return zone
    if isinstance(zone, Arc):
        tilt = -zone.side * angle
        low = zone.y_centre - zone.radius * math.sin(STEEPEST + tilt)
        high = zone.y_centre + zone.radius * math.sin(STEEPEST - tilt)
        start, stop = max(zone.start, low), min(zone.stop, high)
        if stop - start <= 1e-6:
            return None
        return move_zone(Arc(start, stop, zone.radius, zone.y_centre, zone.z_centre, zone.side), angle,
                         y_shift, z_shift)
    steepness = [math.atan(float(zone(t)[1])) + angle for t in (zone.start, zone.stop)]
    return move_zone(zone, angle, y_shift, z_shift) if max(map(abs, steepness)) <= STEEPEST else None


def _around_top(zones):
    """The run of connected ``zones`` that contains y = 0."""
    top = next(index for index, zone in enumerate(zones) if zone.start <= 0.0 <= zone.stop)
    first = last = top
    while first > 0 and abs(zones[first - 1].stop - zones[first].start) < 1e-9:
        first -= 1
    while last + 1 < len(zones) and abs(zones[last].stop - zones[last + 1].start) < 1e-9:
        last += 1
    return tuple(zones[first:last + 1])


def compile_profile(profile):
    """The kernel's table (n,) of ``profile``; lengths in metres."""
    pieces = []
    for index, zone in enumerate(profile.zones):
        before = profile.zones[index - 1] if index > 0 else None
        after = profile.zones[index + 1] if index + 1 < len(profile.zones) else None
        pieces += _zone_pieces(zone, before, after)
    return _table(pieces, profile.zones[-1].stop)


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
    """Pieces between ``low`` and ``high`` [mm], halved until they follow ``zone``
    within the permitted errors."""
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
    """The quintic with given height, slope and second derivative at both ends, as (low,
    coefficients in y - low)."""
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
    """Pack ``pieces`` [mm] into the kernel's record Profile [m]."""
    start = pieces[0][0]
    bin_count = math.ceil((stop - start) / BIN_WIDTH)
    starts = np.array([piece[0] for piece in pieces])
    left = start + BIN_WIDTH * np.arange(bin_count)
    first = np.maximum(np.searchsorted(starts, left, side="right") - 1, 0)
    body = np.full((len(pieces) + 1, PIECE_SIZE), np.nan)
    scale = MM ** (1.0 - np.arange(6))
    for row, (low, coefficients) in zip(body, pieces):
        row[0] = low * MM
        row[1:] = np.asarray(coefficients) * scale
    head = PROFILE_HEAD
    table = np.concatenate([np.zeros(head), head + bin_count + PIECE_SIZE * first, body.ravel()])
    profile = Table.at(table)
    profile.start, profile.stop = start * MM, stop * MM
    profile.bins_per_metre, profile.bin_count = 1.0 / (BIN_WIDTH * MM), bin_count
    profile.pieces = head + bin_count
    return table
