"""Geometry that only pictures need: outlines of wheel and rail on the track, and names of the parts of a
wheel."""

import numpy as np

from ..conventions import MIRROR
from ..kernel.layout import PLACE_SIZE, Place
from ..kernel.surface.locus import around_wheel, outline_point, place_wheelset
from ..profiles.changing import refuse_changing
from ..profiles.placement import place_rail, readable_wheel

#: Parts of the wheel S1002 by their lateral position [m]; the limits are joints of its defining zones (B/C
#: and D/E).
WHEEL_ZONES = {
    "flange": (-70e-3, -38.426669071e-3),
    "flange root": (-38.426669071e-3, -26e-3),
    "tread": (-26e-3, 60e-3),
}

POINTS = 1200  # of a drawn outline


def wheel_outline(system, state, side):
    """The wheel's outline at a pose as seen along the track: track coordinates y, z (down) [m], two arrays
    (n,).

    It is the curve of the points that can touch the rail (wrcontact/kernel/surface/locus.py); without yaw,
    the profile.
    """
    return wheel_locus(system, state, side)[1:]


def wheel_locus(system, state, side):
    """Track coordinates x, y, z [m] of the same curve, three arrays (n,)."""
    profile = readable_wheel(system.wheel if side == "right" else system.left_wheel)
    y = np.linspace(profile.start, profile.stop, POINTS)[1:-1]
    z, slope, _ = profile.evaluate(y)
    pose = np.array([state.inputs.lateral_shift, state.inputs.yaw, state.roll])
    sign = mirrored(side)
    place = Place.at(np.zeros(PLACE_SIZE))
    chosen = system.side_parameters(side)
    place_wheelset(
        place,
        *(sign * pose),
        chosen["nominal_radius"],
        system.centre_height,
        chosen["running_circle_distance"] / 2,
    )
    points = np.array(
        [
            (_along(place, *point), *outline_point(place, *point)[:2])
            for point in zip(y.tolist(), z.tolist(), slope.tolist())
        ]
    )
    return points[:, 0], sign * points[:, 1], points[:, 2] + state.vertical_shift


def _along(place, y, z, slope):
    """Track coordinate x [m] of the outline at wheel profile point (y, z), as ``outline_x`` of the kernel."""
    sin_phi, cos_phi = around_wheel(place, slope)
    radius = place.radius + z
    lateral = (place.arm + y) * place.cos_roll - radius * cos_phi * place.sin_roll
    return place.cos_yaw * radius * sin_phi - place.sin_yaw * lateral


def stations_along(system, state, side, station):
    """Track coordinate x [m] of the wheel's locus at the stations of an outline (n,), from the contact point
    on; zero without yaw."""
    if state.inputs.yaw == 0.0:
        return np.zeros_like(station)
    contact = getattr(state, side).contact
    y_rail, _, length = rail_lengths(system, side, state)
    x, y, _ = wheel_locus(system, state, side)
    y = mirrored(side) * y
    order = np.argsort(y)
    return np.interp(np.interp(station, length, y_rail), y[order], x[order]) - contact.x_track


def mirrored(side):
    """1 for the right side, -1 for the left one."""
    return 1.0 if side == "right" else MIRROR[0]


def rail_lengths(system, side, state):
    """The rail head from its inner end on: y to the field side, z (down), and the arc length from the contact
    point of the ``state`` [m], three arrays (n,)."""
    y, z = rail_outline(system, side, state)
    y = mirrored(side) * y
    length = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y), np.diff(z)))])
    return y, z, length - np.interp(mirrored(side) * getattr(state, side).contact.y_track, y, length)


def rail_outline(system, side, state=None):
    """The inclined rail head with its sides on the track: track coordinates y, z (down) [m], two arrays
    (n,); of a rail that is moved as the inputs of ``state`` say."""
    refuse_changing(system, "this picture")
    chosen, rail = system.side_parameters(side), system.rail if side == "right" else system.left_rail
    placed = place_rail(
        rail, inclination=chosen["rail_inclination"], gauge=chosen["gauge"], gauge_depth=chosen["gauge_depth"]
    )
    angle = -np.arctan(chosen["rail_inclination"])
    coarse = np.linspace(rail.start, rail.stop, POINTS)
    top = np.argmin(_turned(rail, coarse, angle)[1])
    fine = np.linspace(coarse[max(top - 1, 0)], coarse[min(top + 1, POINTS - 1)], POINTS)
    highest = min(_turned(rail, fine, angle).T, key=lambda point: point[1])
    y, z = _turned(rail, coarse, angle) - highest[:, None]
    y *= mirrored(side)
    top = placed.y_track if side == "right" else -placed.y_track
    lateral, vertical, roll = (0.0, 0.0, 0.0) if state is None else _moved(state, side)
    return (
        top + lateral + np.cos(roll) * y - np.sin(roll) * z,
        vertical + np.sin(roll) * y + np.cos(roll) * z,
    )


def _moved(state, side):
    """How the rail of a side is moved: to the right, down [m], and its roll [rad]."""
    return [state[f"{side}.{name}"] for name in ("rail_lateral", "rail_vertical", "rail_roll")]


def _turned(profile, y, angle):
    """Points (2, n) of a profile rotated by ``angle`` [rad] from y to z."""
    z = profile.height(y)
    return np.array([np.cos(angle) * y - np.sin(angle) * z, np.sin(angle) * y + np.cos(angle) * z])


def wheel_zone(y_wheel):
    """Name of the part of the wheel S1002 at lateral position ``y_wheel`` [m]."""
    return next(name for name, (low, high) in WHEEL_ZONES.items() if low <= y_wheel <= high)
