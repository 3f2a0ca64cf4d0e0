"""The regions of a pressed wheel, from its overlaps: each has a frame of its own at its deepest point."""

from ..layout import (
    REGION_LIMIT,
    DeepPoint,
    Frame,
    KeptFrames,
    Overlap,
    Pair,
    Place,
    Region,
    Regions,
    SideSearch,
    copy,
    seldom,
)
from ..surface.locus import outline_point
from ..surface.tables import height_slope
from .curves import rail_length, rail_way
from .frame import BEYOND, NO_GAP, incline_region, locate_along_track, open_frame
from .penetration_maxima import deepest_entry
from .overlaps import find_overlaps
from .penetrated import NOT_MET, met_curvature, penetrated_gap
from .traces import start_traces


@seldom
def touching_shift(pair: Pair, place: Place, point: DeepPoint):
    """Lateral and vertical shift [m] that let the wheel just touch at a deepest point."""
    z, slope = height_slope(pair.wheel, point.wheel)
    y_track, z_track, outline_slope = outline_point(place, point.wheel, z, slope)
    z_rail, m = height_slope(pair.rail, point.rail)
    return point.rail + pair.rail_y - y_track, z_rail - z_track


@seldom
def lower_frame(frame: Frame, height: float, depth: float, gap: float):
    """Let the open frame be that of a wheel pressed ``depth`` deep at vertical shift ``height``, whose own
    gap is ``gap`` [m]."""
    frame.height = height
    frame.depth = depth
    frame.pressed = True
    frame.raised = gap


@seldom
def sink_wheel(pair: Pair, frame: Frame, overlap: Overlap, side: SideSearch, penetration: float):
    """Press the wheel of the open frame, which just touches, straight down until its contact point is
    ``penetration`` [m] deep along the normal; the number of regions in which it overlaps its rail."""
    height = frame.shift + penetration / frame.plane.cos
    count = find_overlaps(pair, overlap, side, height)
    lower_frame(frame, height, penetration, 0.0)
    frame.sunk = True
    return count


@seldom
def raise_wheel(frame: Frame, sunk: bool):
    """Let the open frame be as it was opened, or pressed, before regions were laid for it: of a wheel that
    was ``sunk`` that of a wheel that just touches."""
    frame.blur = 0.0
    if sunk:
        frame.raised = 0.0
        frame.pressed = False
        frame.sunk = False
        frame.height = frame.shift
        frame.depth = 0.0


@seldom
def open_penetrated_region(pair: Pair, frame: Frame, region: Region, point: DeepPoint):
    """Start a region at a deepest point, inclined as the rail there."""
    region.station = 0.0
    region.gap = 0.0
    region.rail = point.rail
    region.wheel = point.wheel
    z_rail, m = height_slope(pair.rail, point.rail)
    incline_region(pair.tables, frame, region, m)


@seldom
def give_own_frame(pair: Pair, frame: Frame, region: Region, point: DeepPoint):
    """Open the frame of a region beside the contact point's, whose frame is open; what it gets of the
    approach follows from both inclinations."""
    cosine = frame.plane.cos
    abscissa = frame.rail.y
    height = frame.height
    depth = frame.depth
    sunk = frame.sunk
    aside, shift = touching_shift(pair, frame.place, point)
    open_frame(pair, frame, frame.place, point.wheel, aside, shift)
    frame.way = rail_way(pair, point.rail)
    region.own = True
    region.alignment = region.cos / cosine
    region.gap = region.alignment * depth - point.depth
    region.offset = frame.way - rail_way(pair, abscissa)
    lower_frame(frame, height, point.depth, region.gap)
    frame.sunk = sunk


@seldom
def gather_overlaps(pair: Pair, frame: Frame, frames: KeptFrames, regions: Regions, overlap: Overlap):
    """Open a region for every deepest point on the list, each with its own frame; their number.  The open
    frame is that of the deepest, whose share of the approach counts as one, or of a sunk wheel that of the
    point where it just touched."""
    count = overlap.count
    contact = deepest_entry(overlap)
    copy(frame, frames[REGION_LIMIT])
    for index in range(count):
        region = regions[index]
        point = overlap.points[index]
        open_penetrated_region(pair, frame, region, point)
        if index != contact or frame.sunk:
            give_own_frame(pair, frame, region, point)
        start_traces(frame, 0.0, point.rail, point.wheel)
        gap, rate, bend = penetrated_gap(pair, frame, 0.0)
        region.bend = bend
        region.curvature = NOT_MET
        if gap < NO_GAP:
            region.curvature = met_curvature(pair, frame)
        region.low = -BEYOND
        region.high = BEYOND
        if index > 0:
            region.low = rail_length(pair, point.rail, overlap.points[index - 1].saddle)
        if index < count - 1:
            region.high = rail_length(pair, point.rail, point.saddle)
        copy(frame, frames[index])
        copy(frames[REGION_LIMIT], frame)
    if count > 1:
        locate_along_track(pair, frame, regions, count)
    return count
