"""What pictures need and a simulation does not: outlines of wheel and rail on the track, and where contacts jump."""

from dataclasses import dataclass

import numpy as np

from ..conventions import MIRROR, SIDES
from ..kernel.locus import PLACE_SIZE, outline_point, place_wheelset
from ..profiles.placement import place_rail, readable_wheel

#: Parts of the wheel S1002 by their lateral position [m]; the limits are joints of its defining zones (B/C and D/E).
WHEEL_ZONES = {"flange": (-70e-3, -38.426669071e-3), "flange root": (-38.426669071e-3, -26e-3), "tread": (-26e-3, 60e-3)}

POINTS = 1200  # of a drawn outline
FAR = 0.2e-3  # [m] a larger move of the contact in one step is looked into
RESOLUTION = 1e-9  # [m] a jump is located to this


def wheel_outline(system, state, side):
    """The wheel's outline at a pose as seen along the track: track coordinates y, z (down) [m], two arrays (n,).

    It is the curve of the points that can touch the rail (wrcontact/kernel/locus.py); without yaw, the profile.
    """
    profile = readable_wheel(system.wheel)
    y = np.linspace(profile.start, profile.stop, POINTS)[1:-1]
    z, slope, _ = profile.evaluate(y)
    pose = np.array([state.inputs[0], state.inputs[1], state.roll])
    sign = 1.0 if side == "right" else MIRROR[0]
    place = [0.0] * PLACE_SIZE
    chosen = system.parameters
    place_wheelset(place, 0, *(sign * pose), chosen["nominal_radius"], chosen["running_circle_distance"] / 2)
    points = np.array([outline_point(place, 0, *point)[:2] for point in zip(y.tolist(), z.tolist(), slope.tolist())])
    return sign * points[:, 0], points[:, 1] + state.vertical_shift


def rail_outline(system, side):
    """The inclined rail head with its sides on the track: track coordinates y, z (down) [m], two arrays (n,)."""
    chosen = system.parameters
    placed = place_rail(system.rail, inclination=chosen["rail_inclination"], gauge=chosen["gauge"],
                        gauge_depth=chosen["gauge_depth"])
    angle = -np.arctan(chosen["rail_inclination"])
    coarse = np.linspace(system.rail.start, system.rail.stop, POINTS)
    top = np.argmin(_turned(system.rail, coarse, angle)[1])
    fine = np.linspace(coarse[max(top - 1, 0)], coarse[min(top + 1, POINTS - 1)], POINTS)
    highest = min(_turned(system.rail, fine, angle).T, key=lambda point: point[1])
    y, z = _turned(system.rail, coarse, angle) - highest[:, None]
    return (1.0 if side == "right" else MIRROR[0]) * (y + placed.y_track), z


def _turned(profile, y, angle):
    """Points (2, n) of a profile turned by ``angle`` [rad] from y to z."""
    z = profile.height(y)
    return np.array([np.cos(angle) * y - np.sin(angle) * z, np.sin(angle) * y + np.cos(angle) * z])


def wheel_zone(y_wheel):
    """Name of the part of the wheel S1002 at lateral position ``y_wheel`` [m]."""
    return next(name for name, (low, high) in WHEEL_ZONES.items() if low <= y_wheel <= high)


@dataclass(frozen=True)
class Jump:
    """A lateral shift [m] at which the contact of one wheel leaps from one place on the wheel to another [m]."""

    side: str
    lateral_shift: float
    before: float
    after: float


def find_jumps(system, lateral_shift, yaw=0.0):
    """Jumps of both contacts between neighbouring values of ``lateral_shift`` [m], rising (n,).

    Where a contact moves far in one step the step is halved until the move is plainly continuous or the jump is known
    to a nanometre.
    """
    places = contact_places(system, lateral_shift, yaw)
    return [jump for side in SIDES
            for step in zip(lateral_shift, lateral_shift[1:], places[side], places[side][1:])
            for jump in _jumps_inside(system, yaw, side, *map(float, step))]


def contact_places(system, lateral_shift, yaw=0.0):
    """Lateral positions of the contacts on the wheels [m] by side, for ``lateral_shift`` (n,); NaN without contact."""
    table = system.evaluate_many(lateral_shift=lateral_shift, yaw=yaw, normal_force=0.0)
    return {side: getattr(table, side).contact.y_wheel for side in SIDES}


def _jumps_inside(system, yaw, side, low, high, before, after):
    """Jumps of one contact between two shifts with its places there."""
    if not abs(after - before) > FAR:
        return []
    middle = 0.5 * (low + high)
    if high - low < RESOLUTION:
        return [Jump(side, middle, before, after)]
    between = float(contact_places(system, [middle], yaw)[side][0])
    return (_jumps_inside(system, yaw, side, low, middle, before, between)
            + _jumps_inside(system, yaw, side, middle, high, between, after))
