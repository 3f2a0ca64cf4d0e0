"""The contact of one side, described: where it is on wheel, rail and track, its angle, radius and curvatures."""

from math import atan, fabs
from typing import Final

from .contact_plane import FRAME_ABSCISSA, FRAME_HEIGHT, open_frame
from ..surface.lateral_curvature import relative_curvature
from ..layout import (LATERAL_ADAPTIVE, OUT_LEFT, OUT_RIGHT, PLACE_BLOCK, SET_LATERAL, SET_RADIUS, SET_RAIL, SET_WHEEL,
                     SIDE_CONTACT_ANGLE, SIDE_CURVATURE_X, SIDE_CURVATURE_Y, SIDE_ROLLING_RADIUS, SIDE_X_TRACK,
                     SIDE_X_WHEEL, SIDE_Y_RAIL, SIDE_Y_TRACK, SIDE_Y_WHEEL, SIDE_Z_RAIL, SIDE_Z_TRACK, SIDE_Z_WHEEL,
                     WORK_OUTPUTS, WORK_PLACE)
from ..surface.locus import PLACE_ARM, PLACE_COS_ROLL, PLACE_COS_YAW, PLACE_SIN_ROLL, PLACE_SIN_YAW, around_wheel
from ..surface.profile_table import START, STOP
from .regions import REGION_BEND, REGION_CURVATURE, open_contact_region, region_block

#: At the end of a profile the slopes of wheel and rail agree to this at a contact [-]; more means that it is none.  Within
#: a profile they may differ by CORNER, as at the last digits of printed joints.
PARALLEL: Final[float] = 1e-6
CORNER: Final[float] = 1e-3
#: A place this close to a profile's end is there [m]; the rail's is located to 1e-9 m.
AT_END: Final[float] = 1e-8


def describe_contact(tables: 'float[:]', work: 'float[:]', state: 'float[:]', index: int, y: float, aside: float,
                     shift: float):
    """Positions, angle, radius and curvatures of side ``index`` (0 left, 1 right) where its wheel touches with abscissa
    ``y`` when moved by ``aside`` and ``shift`` [m]; opens its contact plane.

    1 if this is a contact, else 0: the smallest gap at the end of a profile, or where a yawed outline is folded.
    """
    at = WORK_PLACE + PLACE_BLOCK * index
    out = WORK_OUTPUTS + OUT_LEFT + (OUT_RIGHT - OUT_LEFT) * index
    z, slope, y_track, rail_slope, mismatch = open_frame(tables, work, at, y, aside, shift)
    sin_phi, cos_phi = around_wheel(work, at, slope)
    r = tables[SET_RADIUS] + z
    lateral = (work[at + PLACE_ARM] + y) * work[at + PLACE_COS_ROLL] - r * cos_phi * work[at + PLACE_SIN_ROLL]
    work[out + SIDE_X_WHEEL] = r * sin_phi
    work[out + SIDE_Y_WHEEL] = y
    work[out + SIDE_Z_WHEEL] = r * cos_phi - tables[SET_RADIUS]
    work[out + SIDE_Y_RAIL] = work[FRAME_ABSCISSA]
    work[out + SIDE_Z_RAIL] = work[FRAME_HEIGHT]
    work[out + SIDE_X_TRACK] = work[at + PLACE_COS_YAW] * r * sin_phi - work[at + PLACE_SIN_YAW] * lateral
    work[out + SIDE_Y_TRACK] = y_track
    if index == 0:
        work[out + SIDE_Y_TRACK] = -y_track
    work[out + SIDE_Z_TRACK] = work[FRAME_HEIGHT]
    work[out + SIDE_CONTACT_ANGLE] = -atan(rail_slope)
    work[out + SIDE_ROLLING_RADIUS] = r
    open_contact_region(tables, work, state)
    work[out + SIDE_CURVATURE_X] = work[region_block(0) + REGION_CURVATURE]
    work[out + SIDE_CURVATURE_Y] = work[region_block(0) + REGION_BEND]
    if int(tables[SET_LATERAL]) != LATERAL_ADAPTIVE:
        work[out + SIDE_CURVATURE_Y] = 2.0 * relative_curvature(tables, y, work[FRAME_ABSCISSA])
    touches = 1
    if fabs(mismatch) >= PARALLEL:
        if fabs(mismatch) > CORNER or is_end(tables, int(tables[SET_WHEEL]), y) == 1:
            touches = 0
        if is_end(tables, int(tables[SET_RAIL]), work[FRAME_ABSCISSA]) == 1:
            touches = 0
    return touches


def is_end(tables: 'float[:]', base: int, y: float):
    """1 if ``y`` [m] is at an end of the profile, else 0."""
    end = 0
    if y < tables[base + START] + AT_END or y > tables[base + STOP] - AT_END:
        end = 1
    return end
