"""Rails that are moved from their nominal place.

Seen from its rail the wheelset moves the other way. Search and contact therefore work in the frame that moves
with the rail, in which the rail is in its nominal place; only what is reported is taken back to the track.

A rail rolls about its highest point in its nominal place, after it was displaced. In its frame the wheelset's
axle has another yaw and roll, its centre is elsewhere, and down is not the frame's vertical: how far the
wheelset has come down moves it sideways too. A place therefore holds for one vertical shift, its
``reference``; the frame's vertical gap is the way down from there to first order only, and where the gap is
sought, the reference follows it (wheelset/rolled_rails.py).
"""

from math import sqrt

from ..elementary.circle import sine_cosine
from ..layout import MODE_COMPLIANT, Deflection, Place, Tables
from .locus import set_roll


def move_rail(place: Place, lateral: float, vertical: float):
    """Let the rail below a placed wheel be displaced to the field side by ``lateral`` and down by
    ``vertical`` [m]."""
    place.shift -= lateral
    place.height += vertical
    place.rail_lateral = lateral
    place.rail_vertical = vertical


def is_sprung(tables: Tables, index: int) -> bool:
    """Whether the rail of side ``index`` stands on springs."""
    spring = tables.springs[index]
    return spring.lateral_stiffness > 0.0 or spring.vertical_stiffness > 0.0


def on_springs(tables: Tables) -> bool:
    """Whether a rail stands on springs in this contact mode; only then deflections are known."""
    return tables.sprung and tables.mode == MODE_COMPLIANT


def deflect_rail(place: Place, deflection: Deflection):
    """Let the springs of a rail below a placed wheel have this deflection, on top of its displacement."""
    place.shift -= deflection.lateral
    place.height += deflection.vertical
    place.rail_lateral += deflection.lateral
    place.rail_vertical += deflection.vertical


def roll_rail(place: Place, rail_y: float, angle: float):
    """Let the rail below a placed wheel roll by ``angle`` [rad], field side down, about its highest point,
    whose nominal place is ``rail_y`` [m]; turn_rolled_rail has to follow."""
    sine, cosine = sine_cosine(angle)
    across = place.shift - rail_y
    down = place.reference - place.height
    place.shift = rail_y + cosine * across + sine * down
    place.height = place.reference - (cosine * down - sine * across)
    place.rail_roll = angle
    place.rail_sin = sine
    place.rail_cos = cosine
    place.track_sin_yaw = place.sin_yaw
    place.track_cos_yaw = place.cos_yaw
    place.leaning = True


def turn_rolled_rail(place: Place):
    """Yaw and roll that a placed wheelset has in the frame of its rolled rail: those of its axle, since a
    wheel is round."""
    sin_roll = place.sin_roll
    cos_roll = place.cos_roll
    along = -place.track_sin_yaw * cos_roll
    level = place.track_cos_yaw * cos_roll
    across = place.rail_cos * level + place.rail_sin * sin_roll
    sine = place.rail_cos * sin_roll - place.rail_sin * level
    cosine = sqrt(along * along + across * across)
    place.sin_yaw = -along / cosine
    place.cos_yaw = across / cosine
    set_roll(place, sine, cosine)


def pitch_of_frame(place: Place):
    """Sine and cosine of the angle about the axle by which the wheelset's axes lie before those that yaw and
    roll in the rail's frame give it."""
    forward = place.rail_cos * place.track_sin_yaw
    down = -place.rail_sin * place.track_sin_yaw
    sine = -(
        (place.track_cos_yaw * place.sin_yaw - forward * place.cos_yaw) * place.sin_roll
        + down * place.cos_roll
    )
    cosine = place.track_cos_yaw * place.cos_yaw + forward * place.sin_yaw
    return sine, cosine


def upright_share(place: Place, cosine: float, sine: float):
    """The vertical share, in the track, of a force along a normal with this cosine and sine in the rail's
    frame."""
    share = cosine
    if place.leaning:
        share = place.rail_cos * cosine - place.rail_sin * sine
    return share


def on_track(place: Place, rail_y: float, y: float, z: float):
    """Coordinates to the field side and down [m], in the track, of a point at ``y``, ``z`` in the frame of
    the moved rail whose nominal place is ``rail_y``."""
    if place.leaning:
        across = y - rail_y
        y = rail_y + place.rail_cos * across - place.rail_sin * z
        z = place.rail_sin * across + place.rail_cos * z
    return y + place.rail_lateral, z + place.rail_vertical
