"""Planes of their own for regions of a rigid contact that lean away from the contact point's: a flange beside a tread.

One contact plane serves all regions whose normals differ little.  A region that leans by more than SPLIT has its own frame,
in the pair of points where it would touch (:mod:`touching`): its gap is measured along its own normal, its stations run in
its own plane, and of the wheel's approach it gets the share that comes along its normal,

    level_i = cos(angle_i - angle_0) penetration - gap_i

In the outputs its stations follow those of the contact point, by the length of the rail between the two.
"""

from math import fabs
from typing import Final

from .contact_plane import (FRAME_ABSCISSA, FRAME_COS, FRAME_HEIGHT, FRAME_PLACE, FRAME_RAISE, FRAME_SHIFT, FRAME_SIN,
                            TRACER_RAIL, normal_gap, open_frame, ridge_place, start_tracer)
from ..layout import CONTACT_BLOCK, REGION_LIMIT, SET_RAIL, WORK_CONTACT, WORK_FRAMES
from .pressed import rail_length
from ..surface.profile_table import height_slope
from .regions import (FAR, REGION_ALONG, REGION_BEND, REGION_COS, REGION_CURVATURE, REGION_GAP, REGION_HIGH, REGION_LOW,
                      REGION_OFFSET, REGION_OWN, REGION_RAIL, REGION_SIN, REGION_STATION, REGION_TURN, REGION_WHEEL,
                      TRACE, lean_region, region_block)
from .touching import touching_pair

#: Sine of the angle between the normals from which on a region has its own plane: 15 deg.  S1002 on UIC60 has 9 deg between
#: tread and flange root, which one plane serves within a few per mille, and 30 ... 65 deg to the flange.
SPLIT: Final[float] = 0.2588190451025207


def keep_frame(work: 'float[:]', slot: int):
    """Keep the open frame for region ``slot``; REGION_LIMIT is the contact point's."""
    for i in range(CONTACT_BLOCK):
        work[WORK_FRAMES + CONTACT_BLOCK * slot + i] = work[WORK_CONTACT + i]
    return 0


def use_frame(work: 'float[:]', slot: int):
    """Open the frame that was kept for ``slot``."""
    for i in range(CONTACT_BLOCK):
        work[WORK_CONTACT + i] = work[WORK_FRAMES + CONTACT_BLOCK * slot + i]
    return 0


def bound_abscissa(tables: 'float[:]', work: 'float[:]', state: 'float[:]', block: int, bound: float):
    """Rail abscissa [m] of a region's ``bound``, a station in the contact point's plane; FAR beyond any rail if it has none."""
    abscissa = bound
    if fabs(bound) < FAR:
        start_tracer(work, work[block + REGION_STATION], work[block + REGION_RAIL], work[block + REGION_WHEEL])
        gap, rate, bend, curvature = normal_gap(tables, work, state, bound, TRACE)
        abscissa = work[TRACER_RAIL]
    return abscissa


def bound_station(tables: 'float[:]', work: 'float[:]', abscissa: float):
    """Station [m] in the open frame of the rail's point at ``abscissa``; FAR stays FAR."""
    station = abscissa
    if fabs(abscissa) < FAR:
        height, slope = height_slope(tables, int(tables[SET_RAIL]), abscissa)
        station = ((abscissa - work[FRAME_ABSCISSA]) * work[FRAME_COS] + (height - work[FRAME_HEIGHT]) * work[FRAME_SIN])
    return station


def leans_away(work: 'float[:]', region: int):
    """1 if the region's normal differs from the open frame's by more than SPLIT, else 0."""
    block = region_block(region)
    away = work[block + REGION_SIN] * work[FRAME_COS] - work[block + REGION_COS] * work[FRAME_SIN]
    leans = 0
    if fabs(away) > SPLIT:
        leans = 1
    return leans


def own_plane(tables: 'float[:]', work: 'float[:]', state: 'float[:]', region: int):
    """Give ``region`` its own frame, kept in its slot; the contact point's frame stays open."""
    block = region_block(region)
    at = int(work[FRAME_PLACE])
    y, abscissa, depth, aside, shift, found = touching_pair(tables, work, at, work[block + REGION_WHEEL],
                                                            work[block + REGION_RAIL], work[FRAME_SHIFT])
    if found == 1:
        low = bound_abscissa(tables, work, state, block, work[block + REGION_LOW])
        high = bound_abscissa(tables, work, state, block, work[block + REGION_HIGH])
        keep_frame(work, REGION_LIMIT)
        cosine = work[FRAME_COS]
        sine = work[FRAME_SIN]
        work[block + REGION_STATION] = 0.0
        work[block + REGION_RAIL] = abscissa
        work[block + REGION_WHEEL] = y
        height, slope = height_slope(tables, int(tables[SET_RAIL]), abscissa)
        lean_region(tables, work, block, slope)
        work[block + REGION_OWN] = 1.0
        work[block + REGION_OFFSET] = rail_length(tables, work[FRAME_ABSCISSA], abscissa)
        turn = work[block + REGION_COS] * cosine + work[block + REGION_SIN] * sine
        work[block + REGION_TURN] = turn
        work[block + REGION_GAP] = -depth
        z, slope, y_track, rail_slope, mismatch = open_frame(tables, work, at, y, aside, shift)
        work[FRAME_RAISE] = work[block + REGION_GAP]
        gap, rate, bend, curvature = normal_gap(tables, work, state, 0.0, TRACE)
        work[block + REGION_BEND] = bend
        work[block + REGION_CURVATURE] = curvature
        work[block + REGION_LOW] = bound_station(tables, work, low)
        work[block + REGION_HIGH] = bound_station(tables, work, high)
        keep_frame(work, region)
        use_frame(work, REGION_LIMIT)
    return found


def give_planes(tables: 'float[:]', work: 'float[:]', state: 'float[:]', count: int):
    """Give every region that leans away its own plane."""
    own = 0
    for region in range(count):
        if leans_away(work, region) == 1:
            own += own_plane(tables, work, state, region)
    if own > 0:
        line_up(tables, work, count)
    return 0


def line_up(tables: 'float[:]', work: 'float[:]', count: int):
    """Note how far ahead every region lies: of a yawed wheel, a flange is some 20 mm ahead of the flange root."""
    for region in range(count):
        block = region_block(region)
        work[block + REGION_ALONG] = ridge_place(tables, work, work[block + REGION_WHEEL])
    return 0


def enter_plane(work: 'float[:]', region: int):
    """Open the frame of a region with its own plane."""
    if work[region_block(region) + REGION_OWN] == 1.0:
        use_frame(work, region)
    return 0


def leave_plane(work: 'float[:]', region: int):
    """Open the contact point's frame again."""
    if work[region_block(region) + REGION_OWN] == 1.0:
        use_frame(work, REGION_LIMIT)
    return 0
