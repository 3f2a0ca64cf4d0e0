"""The contact of one side, described: where it is on wheel, rail and track, its angle, radius and
curvatures."""

from math import atan, fabs
from typing import Final

from ..contact.contact_plane import open_frame
from ..contact.regions import measure_contact, open_contact_region
from ..layout import LATERAL_ADAPTIVE, Profile, State, Tables, Work
from ..surface.lateral_curvature import relative_curvature
from ..surface.locus import around_wheel
from ..surface.rails import on_track, pitch_of_frame

#: At the end of a profile the slopes of wheel and rail agree to this at a contact [-]; more means that it is
#: none.  Within a profile they may differ by CORNER, as at the last digits of printed joints.
PARALLEL: Final[float] = 1e-6
CORNER: Final[float] = 1e-3
#: A place this close to a profile's end is there [m]; the rail's is located to 1e-9 m.
AT_END: Final[float] = 1e-8


def describe_contact(tables: Tables, work: Work, state: State, index: int, y: float, aside: float,
                     shift: float) -> bool:
    """Positions, angle, radius and curvatures of side ``index`` (0 left, 1 right) where its wheel touches
    with abscissa ``y`` when moved by ``aside`` and ``shift`` [m]; opens its contact plane.

    Whether this is a contact: the smallest gap at the end of a profile, or where a yawed outline is
    folded.
    """
    place = work.sides[index].place
    frame = work.contact.frame
    region = work.contact.regions[0]
    point = work.sides[index].point
    z, slope, y_track, rail_slope, mismatch = open_frame(tables, frame, place, y, aside, shift)
    sin_phi, cos_phi = around_wheel(place, slope)
    r = tables.radius + z
    lateral = (place.arm + y) * place.cos_roll - r * cos_phi * place.sin_roll
    x_track = place.cos_yaw * r * sin_phi - place.sin_yaw * lateral
    if place.leaning:
        pitch_sin, pitch_cos = pitch_of_frame(place)
        ahead = sin_phi * pitch_cos - cos_phi * pitch_sin
        cos_phi = sin_phi * pitch_sin + cos_phi * pitch_cos
        sin_phi = ahead
    point.x_wheel = r * sin_phi
    point.y_wheel = y
    point.z_wheel = r * cos_phi - tables.radius
    point.y_rail = frame.rail.y
    point.z_rail = frame.rail.z
    y_track, z_track = on_track(place, tables.rail_y, y_track, frame.rail.z)
    point.x_track = x_track
    point.y_track = y_track
    point.z_track = z_track
    point.contact_angle = -atan(rail_slope)
    if place.leaning:
        point.contact_angle = -atan(rail_slope) - place.rail_roll
    point.rolling_radius = r
    measure_contact(tables, frame, state)
    open_contact_region(tables, frame, region)
    point.curvature_x = region.curvature
    point.curvature_y = region.bend
    if tables.lateral != LATERAL_ADAPTIVE:
        point.curvature_y = 2.0 * relative_curvature(tables, y, frame.rail.y)
    touches = True
    if fabs(mismatch) >= PARALLEL:
        if fabs(mismatch) > CORNER or is_end(tables.wheel, y):
            touches = False
        if is_end(tables.rail, frame.rail.y):
            touches = False
    return touches


def is_end(profile: Profile, y: float) -> bool:
    """Whether ``y`` [m] is at an end of the profile."""
    return y < profile.start + AT_END or y > profile.stop - AT_END
