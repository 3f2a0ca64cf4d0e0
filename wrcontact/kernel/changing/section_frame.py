"""The frame along the ruling direction of a changing rail, in which the wheel stands over a constant one.

The ruling direction at the place where the wheel is nearest is t = (1, q, p), with the lateral rate q of the line of
equal share there and p = z_u + q z_y (A1).  The frame's x is along t, its y level to the field side, its z = x times y.
The axle has another yaw and roll in it, and angles around the wheel are counted from another place.
"""

from math import sqrt

from ..elementary.circle import atan2
from ..layout import Pair, Place, SectionFrame, SectionTouch
from ..surface.locus import set_roll


def open_section_frame(pair: Pair, touch: SectionTouch, height: float, q: float):
    """Lay the frame at the place where a wheel is nearest, along the direction with the lateral rate ``q`` [-], and the wheelset's
    centre in it, which stands at the vertical shift ``height`` [m]."""
    frame = pair.sections.frame
    frame.x = touch.rail_x
    frame.y = touch.rail_y
    frame.z = touch.rail_z
    p = touch.along + q * touch.slope
    level = sqrt(1.0 + q * q)
    size = sqrt(1.0 + q * q + p * p)
    frame.along[0] = 1.0 / size
    frame.along[1] = q / size
    frame.along[2] = p / size
    frame.aside[0] = -q / level
    frame.aside[1] = 1.0 / level
    frame.aside[2] = 0.0
    frame.down[0] = -p / (level * size)
    frame.down[1] = -p * q / (level * size)
    frame.down[2] = level / size
    x = -frame.x
    y = touch.place.shift - frame.y
    z = height - touch.place.height - frame.z
    frame.centre[0] = frame.along[0] * x + frame.along[1] * y + frame.along[2] * z
    frame.centre[1] = frame.aside[0] * x + frame.aside[1] * y
    frame.centre[2] = frame.down[0] * x + frame.down[1] * y + frame.down[2] * z


def place_in_frame(frame: SectionFrame, at: Place, place: Place):
    """Write the wheel that is placed at ``at`` in the track to ``place``, over a rail in the frame whose highest point is at
    its origin."""
    forward = -at.sin_yaw * at.cos_roll
    level = at.cos_yaw * at.cos_roll
    along = frame.along[0] * forward + frame.along[1] * level + frame.along[2] * at.sin_roll
    across = frame.aside[0] * forward + frame.aside[1] * level
    sine = frame.down[0] * forward + frame.down[1] * level + frame.down[2] * at.sin_roll
    cosine = sqrt(along * along + across * across)
    place.shift = frame.centre[1]
    place.height = -frame.centre[2]
    place.radius = at.radius
    place.arm = at.arm
    place.sin_yaw = -along / cosine
    place.cos_yaw = across / cosine
    place.yawed = along != 0.0
    place.rail_lateral = 0.0
    place.rail_vertical = 0.0
    place.leaning = False
    place.rail_roll = 0.0
    place.rail_sin = 0.0
    place.rail_cos = 1.0
    place.reference = 0.0
    set_roll(place, sine, cosine)


def wheel_turn(frame: SectionFrame, at: Place, place: Place):
    """By how much the angle around a wheel that is placed at ``at`` in the track is larger than in the frame, where it is at
    ``place`` [rad].

    At a right angle in the frame the wheel points level in it, across the axle.
    """
    x = frame.along[0] * place.cos_yaw + frame.aside[0] * place.sin_yaw
    y = frame.along[1] * place.cos_yaw + frame.aside[1] * place.sin_yaw
    z = frame.along[2] * place.cos_yaw + frame.aside[2] * place.sin_yaw
    ahead = x * at.cos_yaw + y * at.sin_yaw
    down = (x * at.sin_yaw - y * at.cos_yaw) * at.sin_roll + z * at.cos_roll
    return atan2(-down, ahead)


def into_frame(frame: SectionFrame, x: float, y: float, z: float):
    """A vector of the track in the frame."""
    return (
        frame.along[0] * x + frame.along[1] * y + frame.along[2] * z,
        frame.aside[0] * x + frame.aside[1] * y,
        frame.down[0] * x + frame.down[1] * y + frame.down[2] * z,
    )


def into_track(frame: SectionFrame, x: float, y: float, z: float):
    """A vector of the frame in the track."""
    return (
        frame.along[0] * x + frame.aside[0] * y + frame.down[0] * z,
        frame.along[1] * x + frame.aside[1] * y + frame.down[1] * z,
        frame.along[2] * x + frame.down[2] * z,
    )


def point_in_track(frame: SectionFrame, x: float, y: float, z: float):
    """The place in the track, from the wheelset's middle, of a place in the frame [m]."""
    along, aside, down = into_track(frame, x, y, z)
    return frame.x + along, frame.y + aside, frame.z + down
