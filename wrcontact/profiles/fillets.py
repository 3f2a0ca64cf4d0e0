"""Corners of a profile rounded by arcs of a stated radius, which are tangential to both sides: fillets."""

import math
from dataclasses import replace

import numpy as np

from ..conventions import MILLIMETRE as MM
from .remarks import counted, stretch
from .zones import Arc, Moved

#: A joint that turns by less than this is none [rad]: that of the numbers of a standard.
LEAST_TURN = 3e-5
#: Newton's steps, and how well both centres meet [mm].
STEPS, MET = 60, 1e-12


def rounded_zones(profile, radius):
    """The zones of ``profile`` with its corners rounded to ``radius`` [mm], and what was moved: a list of (y of the
    corner [mm], its turn [rad], distance between the corner and the arc [mm]).

    Raises
    ------
    ValueError
        where an arc does not fit between its neighbours.
    """
    if any(isinstance(zone, Moved) for zone in profile.zones):
        raise ValueError(
            f"profile {profile.name} has been turned; permitted is that after its corners are rounded"
        )
    zones, moved = list(profile.zones), []
    corners = [joint.y / MM for joint in profile.joints if abs(_turn_of(joint, profile.zones)) > LEAST_TURN]
    for corner in corners:
        zones, distance, turn = _with_arc(profile.name, zones, corner, radius, corners)
        moved.append((corner, turn, distance))
    return tuple(zones), moved


def _turn_of(joint, zones):
    """By how much the profile turns at a joint [rad]."""
    before = next(zone for zone in zones if abs(zone.stop - joint.y / MM) < 1e-9)
    slope = float(before(joint.y / MM)[1])
    return math.atan(slope + joint.slope_step) - math.atan(slope)


def _with_arc(name, zones, corner, radius, corners):
    """The ``zones`` with an arc at a ``corner``, the distance between both, and the turn."""
    i = next(k for k, zone in enumerate(zones) if abs(zone.stop - corner) < 1e-9)
    j = i + 1
    ends = [math.atan(float(zone(corner)[1])) for zone in (zones[i], zones[j])]
    side = 1 if ends[1] < ends[0] else -1  # the centre is above a ridge, and below the bottom of a groove
    while True:
        found = _touching(zones[i], zones[j], corner, radius, side)
        if found is None:
            raise ValueError(_too_large(name, corner, radius))
        first, last, centre = found
        if first < zones[i].start and _may_go(zones, i, -1, corners):
            i -= 1
        elif last > zones[j].stop and _may_go(zones, j, 1, corners):
            j += 1
        elif first < zones[i].start or last > zones[j].stop or not first < corner < last:
            raise ValueError(_too_large(name, corner, radius))
        else:
            break
    arc = Arc(first, last, radius, *centre, side)
    height = float(zones[i](corner)[0]) if zones[i].stop >= corner - 1e-9 else float(zones[j](corner)[0])
    distance = abs(math.hypot(corner - centre[0], height - centre[1]) - radius)
    kept = [*zones[:i], replace(zones[i], stop=first), arc, replace(zones[j], start=last), *zones[j + 1 :]]
    return kept, distance, abs(ends[1] - ends[0])


def _may_go(zones, k, way, corners):
    """Whether the arc may reach beyond a zone: there is another one, not an arc of another corner nor behind one."""
    joint = zones[k].start if way < 0 else zones[k].stop
    return 0 <= k + way < len(zones) and not any(abs(joint - other) < 1e-9 for other in corners)


def _touching(before, after, corner, radius, side):
    """Abscissae where a circle touches both curves, and its centre [mm]; None if it is not found.

    The centre is ``radius`` away from both along their normals: two equations for two abscissae, by Newton's method.
    """

    def centre(zone, y):
        z, slope, bend = (float(value) for value in zone(float(y)))
        length = math.sqrt(1.0 + slope * slope)
        out = radius * side / length
        turned = radius * side * bend / length**3
        return np.array([y + out * slope, z - out]), np.array([1.0 + turned, slope + slope * turned])

    slopes = [float(zone(float(corner))[1]) for zone in (before, after)]
    half = 0.5 * abs(math.atan(slopes[1]) - math.atan(slopes[0]))
    at = np.array(
        [
            corner - radius * math.tan(half) / math.hypot(1.0, slopes[0]),
            corner + radius * math.tan(half) / math.hypot(1.0, slopes[1]),
        ]
    )
    for _ in range(STEPS):
        with np.errstate(all="ignore"):
            (one, along), (other, back) = centre(before, at[0]), centre(after, at[1])
        missing, slope = one - other, np.column_stack([along, -back])
        if not (np.isfinite(missing).all() and np.isfinite(slope).all()) or abs(np.linalg.det(slope)) < 1e-14:
            return None
        if abs(missing).max() <= MET * (1.0 + radius):
            return float(at[0]), float(at[1]), tuple(float(value) for value in one)
        at = at - np.linalg.solve(slope, missing)
    return None


def _too_large(name, corner, radius):
    return (
        f"profile {name}: an arc of {radius:g} mm does not fit into the corner at y = {corner:.6g} mm; permitted are "
        "smaller radii"
    )


def fillet_remarks(moved, radius):
    """The sentence of a ProfileWarning on rounded corners."""
    if not moved:
        return ()
    where, turns, distances = zip(*moved)
    return (
        f"{counted(len(moved), 'corner')} of up to {math.degrees(max(turns)):.3g} deg rounded to a radius of "
        f"{radius:g} mm ({stretch(where)}), which moves the profile by up to {1e3 * max(distances):.2g} um",
    )
