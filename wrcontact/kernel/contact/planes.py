"""Planes of their own for regions of a rigid contact that lean away from the contact point's: a flange beside a tread.

One contact plane serves all regions whose normals differ little.  A region that leans by more than SPLIT has its own frame,
in the pair of points where it would touch (:mod:`touching`): its gap is measured along its own normal, its stations run in
its own plane, and of the wheel's approach it gets the share that comes along its normal,

    level_i = cos(angle_i - angle_0) penetration - gap_i

In the outputs its stations follow those of the contact point, by the length of the rail between the two.
"""

from math import fabs
from typing import Final

from ..layout import (
    CONTACT_BLOCK,
    REGION_LIMIT,
    WORK_CONTACT,
    WORK_FRAMES,
    Place,
    Region,
    State,
    Tables,
    Work,
)
from ..surface.profile_table import height_slope
from .contact_plane import normal_gap, open_frame, ridge_place, start_tracer
from .pressed import rail_length
from .regions import FAR, TRACE, lean_region
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


def bound_abscissa(tables: Tables, work: Work, state: State, block: Region, bound: float):
    """Rail abscissa [m] of a region's ``bound``, a station in the contact point's plane; FAR beyond any rail if it has none."""
    abscissa = bound
    if fabs(bound) < FAR:
        start_tracer(work, block.station, block.rail, block.wheel)
        gap, rate, bend, curvature = normal_gap(tables, work, state, bound, TRACE)
        abscissa = work.frame.tracer_rail
    return abscissa


def bound_station(tables: Tables, work: Work, abscissa: float):
    """Station [m] in the open frame of the rail's point at ``abscissa``; FAR stays FAR."""
    station = abscissa
    if fabs(abscissa) < FAR:
        height, slope = height_slope(tables.rail, abscissa)
        station = ((abscissa - work.frame.abscissa) * work.frame.cos + (height - work.frame.height) * work.frame.sin)
    return station


def leans_away(work: Work, region: int):
    """1 if the region's normal differs from the open frame's by more than SPLIT, else 0."""
    block = work.regions[region]
    away = block.sin * work.frame.cos - block.cos * work.frame.sin
    leans = 0
    if fabs(away) > SPLIT:
        leans = 1
    return leans


def own_plane(tables: Tables, work: Work, state: State, region: int):
    """Give ``region`` its own frame, kept in its slot; the contact point's frame stays open."""
    block = work.regions[region]
    at = Place.at(work, int(work.frame.place))
    y, abscissa, depth, aside, shift, found = touching_pair(tables, work, at, block.wheel,
                                                            block.rail, work.frame.shift)
    if found == 1:
        low = bound_abscissa(tables, work, state, block, block.low)
        high = bound_abscissa(tables, work, state, block, block.high)
        keep_frame(work.raw, REGION_LIMIT)
        cosine = work.frame.cos
        sine = work.frame.sin
        block.station = 0.0
        block.rail = abscissa
        block.wheel = y
        height, slope = height_slope(tables.rail, abscissa)
        lean_region(tables, work, block, slope)
        block.own = True
        block.offset = rail_length(tables, work.frame.abscissa, abscissa)
        turn = block.cos * cosine + block.sin * sine
        block.turn = turn
        block.gap = -depth
        z, slope, y_track, rail_slope, mismatch = open_frame(tables, work, at, y, aside, shift)
        work.frame.raised = block.gap
        gap, rate, bend, curvature = normal_gap(tables, work, state, 0.0, TRACE)
        block.bend = bend
        block.curvature = curvature
        block.low = bound_station(tables, work, low)
        block.high = bound_station(tables, work, high)
        keep_frame(work.raw, region)
        use_frame(work.raw, REGION_LIMIT)
    return found


def give_planes(tables: Tables, work: Work, state: State, count: int):
    """Give every region that leans away its own plane."""
    own = 0
    for region in range(count):
        if leans_away(work, region) == 1:
            own += own_plane(tables, work, state, region)
    if own > 0:
        line_up(tables, work, count)
    return 0


def line_up(tables: Tables, work: Work, count: int):
    """Note how far ahead every region lies: of a yawed wheel, a flange is some 20 mm ahead of the flange root."""
    for region in range(count):
        block = work.regions[region]
        block.along = ridge_place(tables, work, block.wheel)
    return 0


def enter_plane(work: Work, region: int):
    """Open the frame of a region with its own plane."""
    if work.regions[region].own:
        use_frame(work.raw, region)
    return 0


def leave_plane(work: Work, region: int):
    """Open the contact point's frame again."""
    if work.regions[region].own:
        use_frame(work.raw, REGION_LIMIT)
    return 0
