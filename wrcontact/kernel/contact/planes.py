"""Planes of their own for regions of a rigid contact whose normal differs from the contact point's: a flange
beside a tread.

One contact plane serves all regions whose normals differ little.  A region whose normal differs by more than
SPLIT has its own frame, in the pair of points where it would touch (:mod:`touching`): its gap is measured
along its own normal, its stations run in its own plane, and of the wheel's approach it gets the share that
comes along its normal,

    level_i = cos(angle_i - angle_0) penetration - gap_i

In the outputs its stations follow those of the contact point, by the length of the rail between the two.
"""

from math import fabs
from typing import Final

from ..layout import FRAME_SIZE, RAIL, REGION_LIMIT, Frame, KeptFrames, Region, Regions, State, Tables
from ..surface.locus import outline_x
from ..surface.profile_table import height_slope
from .arc_length import rail_length
from .contact_plane import normal_gap, open_frame
from .regions import BEYOND, PLACE_TRACE, incline_region
from .touching import touching_pair
from .traces import start_traces

#: Sine of the angle between the normals from which on a region has its own plane: 15 deg.  S1002 on UIC60 has
#: 9 deg between tread and flange root, which one plane serves within a few per mille, and 30 ... 65 deg to
#: the flange.
SPLIT: Final[float] = 0.2588190451025207


def keep_frame(frame: Frame, frames: KeptFrames, slot: int):
    """Keep the open frame for region ``slot``; REGION_LIMIT is the contact point's."""
    kept = frames[slot]
    for i in range(FRAME_SIZE):
        kept[i] = frame[i]
    return 0


def use_frame(frame: Frame, frames: KeptFrames, slot: int):
    """Open the frame that was kept for ``slot``."""
    kept = frames[slot]
    for i in range(FRAME_SIZE):
        frame[i] = kept[i]
    return 0


def bound_abscissa(tables: Tables, frame: Frame, region: Region, state: State, bound: float):
    """Rail abscissa [m] of a region's ``bound``, a station in the contact point's plane; BEYOND if it has
    none."""
    abscissa = bound
    if fabs(bound) < BEYOND:
        start_traces(frame, region.station, region.rail, region.wheel)
        gap, rate, bend, curvature = normal_gap(tables, frame, state, bound, PLACE_TRACE)
        abscissa = frame.traces[RAIL].abscissa
    return abscissa


def bound_station(tables: Tables, frame: Frame, abscissa: float):
    """Station [m] in the open frame of the rail's point at ``abscissa``; BEYOND stays BEYOND."""
    station = abscissa
    if fabs(abscissa) < BEYOND:
        height, slope = height_slope(tables.rail, abscissa)
        station = ((abscissa - frame.rail.y) * frame.plane.cos + (height - frame.rail.z) * frame.plane.sin)
    return station


def needs_own_plane(frame: Frame, region: Region):
    """1 if the region's normal differs from the open frame's by more than SPLIT, else 0."""
    difference = region.sin * frame.plane.cos - region.cos * frame.plane.sin
    needed = 0
    if fabs(difference) > SPLIT:
        needed = 1
    return needed


def own_plane(tables: Tables, frame: Frame, frames: KeptFrames, region: Region, slot: int, state: State):
    """Give a region its own frame, kept in ``slot``; the contact point's frame stays open.  1 if it has one,
    else 0."""
    y, abscissa, depth, aside, shift, found = touching_pair(tables, frame.place, region.wheel, region.rail,
                                                            frame.shift)
    if found == 1:
        low = bound_abscissa(tables, frame, region, state, region.low)
        high = bound_abscissa(tables, frame, region, state, region.high)
        keep_frame(frame, frames, REGION_LIMIT)
        cosine = frame.plane.cos
        sine = frame.plane.sin
        region.station = 0.0
        region.rail = abscissa
        region.wheel = y
        height, slope = height_slope(tables.rail, abscissa)
        incline_region(tables, region, slope)
        region.own = True
        region.offset = rail_length(tables, frame.rail.y, abscissa)
        region.alignment = region.cos * cosine + region.sin * sine
        region.gap = -depth
        z, slope, y_track, rail_slope, mismatch = open_frame(tables, frame, frame.place, y, aside, shift)
        frame.raised = region.gap
        gap, rate, bend, curvature = normal_gap(tables, frame, state, 0.0, PLACE_TRACE)
        region.bend = bend
        region.curvature = curvature
        region.low = bound_station(tables, frame, low)
        region.high = bound_station(tables, frame, high)
        keep_frame(frame, frames, slot)
        use_frame(frame, frames, REGION_LIMIT)
    return found


def give_planes(tables: Tables, frame: Frame, frames: KeptFrames, regions: Regions, state: State, count: int):
    """Give every region that needs one its own plane."""
    own = 0
    for index in range(count):
        region = regions[index]
        if needs_own_plane(frame, region) == 1:
            own += own_plane(tables, frame, frames, region, index, state)
    if own > 0:
        locate_along_track(tables, frame, regions, count)
    return 0


def locate_along_track(tables: Tables, frame: Frame, regions: Regions, count: int):
    """Note where along the track every region lies: of a yawed wheel, a flange is some 20 mm ahead of the
    flange root."""
    for index in range(count):
        region = regions[index]
        region.x_track = outline_x(tables, frame.place, region.wheel)
    return 0


def enter_plane(frame: Frame, frames: KeptFrames, region: Region, slot: int):
    """Open the frame of a region with its own plane, kept in ``slot``."""
    if region.own:
        use_frame(frame, frames, slot)
    return 0


def leave_plane(frame: Frame, frames: KeptFrames, region: Region):
    """Open the contact point's frame again."""
    if region.own:
        use_frame(frame, frames, REGION_LIMIT)
    return 0
