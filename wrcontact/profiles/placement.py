"""The rail on the track: inclination about the head, and the gauge.

The rail is inclined towards the track centre, so its field side rises and its highest point moves to the
field side.  The inclined profile is expressed in axes parallel to the track's, with the origin at its highest
point.
"""

import math
from dataclasses import dataclass

from ..conventions import MILLIMETRE as MM
from .profile import Profile
from .zones import Arc, Moved, move_zone

#: The head is read as a function of y; it ends where it is steeper than this [rad].  Wheels are less steep
#: (75 deg at most on flanges in use), so no contact lies beyond.
STEEPEST = math.radians(80.0)


@dataclass(frozen=True)
class PlacedRail:
    """The right rail on the track: its inclined profile and the track coordinate of its highest point [m]."""

    profile: Profile
    y_track: float


def place_rail(rail, *, inclination, gauge, gauge_depth):
    """The right rail on the track.

    Parameters
    ----------
    rail : Profile of an upright rail.
    inclination : tangent of its inclination towards the track centre (1/40 = 0.025).
    gauge : distance of the two inner faces [m], measured ``gauge_depth`` [m] below the highest point.

    Raises
    ------
    ValueError
        if the profile does not reach down to ``gauge_depth`` on its inner side.
    """
    angle = -math.atan(inclination)
    y_top, z_top = _highest_point(rail, angle)
    y_gauge = _inner_face(rail, angle, z_top + gauge_depth / MM)
    kept = [part for part in (_readable(zone, angle, -y_top, -z_top) for zone in rail.zones) if part is not None]
    return PlacedRail(Profile(rail.name, "rail", _around_top(kept), rail.smooth), gauge / 2 + (y_top - y_gauge) * MM)


def readable_wheel(wheel):
    """``wheel`` without the parts steeper than :data:`STEEPEST` at its ends (the flange back's vertical
    start)."""
    kept = [part for part in (_readable(zone, 0.0, 0.0, 0.0) for zone in wheel.zones) if part is not None]
    return Profile(wheel.name, "wheel", _around_top(kept), wheel.smooth)


def _highest_point(rail, angle):
    """Point (y, z) [mm] of ``rail`` turned by ``angle`` where it is horizontal and highest."""
    best = None
    for zone in rail.zones:
        def slope(t):
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
            return moved.place(_bisect(lambda t: depth - moved.place(t)[1], zone.start, min(zone.stop, 0.0)))[0]
        deepest = max(deepest, start_depth)
    raise ValueError(f"gauge_depth reaches {depth * MM:.6g} m, but the inner side of the rail profile {rail.name} ends "
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
        return move_zone(Arc(start, stop, zone.radius, zone.y_centre, zone.z_centre, zone.side), angle, y_shift, z_shift)
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
