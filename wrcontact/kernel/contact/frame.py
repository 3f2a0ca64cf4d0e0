"""The frame of a contact: its plane, the gap of wheel and rail along the plane's normal, and the region
around its contact point or deepest point.

Frames are set aside where a wheel is pressed: every region beside the contact point's has its own, at its
deepest point.
"""

from math import sqrt
from typing import Final

from ..layout import (
    LOAD_VERTICAL,
    REGION_LIMIT,
    Frame,
    KeptFrames,
    Pair,
    Place,
    Region,
    Regions,
    Tables,
    copy,
    seldom,
)
from ..surface.curvature import longitudinal_curvature
from ..surface.gap import FOLDED
from ..surface.locus import outline_jet, outline_x
from ..surface.rails import upright_share
from ..surface.tables import height_slope_bend
from .traces import start_traces, trace_rail, trace_wheel

#: Where no wheel or rail is left at a station, the gap counts as this [m].
NO_GAP: Final[float] = 1.0
#: Station of a bound that is none [m]; longer than any profile.
BEYOND: Final[float] = 1.0


def open_frame(pair: Pair, frame: Frame, place: Place, y: float, aside: float, shift: float):
    """Place the contact plane at wheel abscissa ``y`` [m], and note how the gap bends there and the wheel's
    1/R_x; the slope is the rail's, which is the outline's there.

    aside, shift : lateral and vertical shift that let the wheel touch the rail there [m].

    Returns what describes the point: wheel height [m] and slope [-], lateral track coordinate [m], rail slope
    [-], and how much the slopes of rail and outline differ [-], FOLDED as in :mod:`gap`.
    """
    z, slope, bend = height_slope_bend(pair.wheel, y)
    y_track, z_track, outline_slope, stretch, outline_rate = outline_jet(place, y, z, slope, bend)
    y_track += aside
    abscissa = y_track - pair.rail_y
    height, rail_slope, rail_bend = height_slope_bend(pair.rail, abscissa)
    cosine = 1.0 / sqrt(1.0 + rail_slope * rail_slope)
    sine = rail_slope * cosine
    frame.rail.y = abscissa
    frame.rail.z = height
    frame.wheel.y = y
    frame.wheel.z = z
    frame.plane.cos = cosine
    frame.plane.sin = sine
    frame.wheel_plane.cos = place.cos_roll * cosine + place.sin_roll * sine
    frame.wheel_plane.sin = place.cos_roll * sine - place.sin_roll * cosine
    frame.place = place
    frame.aside = aside
    frame.shift = shift
    frame.lift = z_track + shift - height
    frame.raised = 0.0
    frame.pressed = False
    frame.sunk = False
    frame.height = shift
    frame.depth = 0.0
    frame.blur = 0.0
    start_traces(frame, 0.0, abscissa, y)
    along = cosine + outline_slope * sine
    frame.bend = rail_bend * cosine * cosine * cosine - outline_rate / (stretch * along * along * along)
    frame.curvature = longitudinal_curvature(pair.tables, place, y, z, slope, bend)
    mismatch = rail_slope - outline_slope
    if not stretch > 0.0:
        mismatch = FOLDED
    return z, slope, y_track, rail_slope, mismatch


def normal_gap(pair: Pair, frame: Frame, station: float, tolerance: float):
    """Gap g along the contact normal [m], dg/ds [-] and d2g/ds2 [1/m] at ``station`` [m].

    NO_GAP where a profile has ended.  ``tolerance`` [m] is that of the stations of wheel and rail.
    """
    frame.place.node_count += 1.0
    rail_height, rail_rate, rail_bend, on_rail = trace_rail(pair, frame, station, tolerance)
    wheel_height, wheel_rate, wheel_bend, on_wheel = trace_wheel(pair, frame, station, tolerance)
    frame.station = station
    gap = wheel_height - rail_height + frame.raised
    if not on_rail or not on_wheel:
        gap = NO_GAP
    return gap, wheel_rate - rail_rate, wheel_bend - rail_bend


def is_yawed(frame: Frame) -> bool:
    """Whether the wheel of the open frame is yawed."""
    return frame.place.yawed


@seldom
def locate_along_track(pair: Pair, frame: Frame, regions: Regions, count: int):
    """Note where along the track every region lies: of a yawed wheel, a flange is some 20 mm ahead of the
    flange root."""
    for index in range(count):
        region = regions[index]
        region.x_track = outline_x(pair, frame.place, region.wheel)


@seldom
def enter_plane(frame: Frame, frames: KeptFrames, region: Region, slot: int):
    """Open the frame of a region with its own plane, kept in ``slot``."""
    if region.own:
        copy(frames[slot], frame)


@seldom
def leave_plane(frame: Frame, frames: KeptFrames, region: Region):
    """Open the contact point's frame again."""
    if region.own:
        copy(frames[REGION_LIMIT], frame)


def incline_region(tables: Tables, frame: Frame, region: Region, slope: float):
    """Give a region in the contact point's plane its inclination, the rail's ``slope`` there, and what
    follows from it."""
    cosine = 1.0 / sqrt(1.0 + slope * slope)
    region.inclination = slope
    region.own = False
    region.alignment = 1.0
    region.offset = 0.0
    region.cos = cosine
    region.sin = slope * cosine
    region.share = 1.0
    if tables.load == LOAD_VERTICAL:
        region.share = upright_share(frame.place, cosine, region.sin)


def open_contact_region(tables: Tables, frame: Frame, region: Region):
    """The region of the rigid contact point itself, station and gap zero."""
    region.station = 0.0
    region.gap = 0.0
    region.rail = frame.rail.y
    region.wheel = frame.wheel.y
    region.bend = frame.bend
    region.curvature = frame.curvature
    region.low = -BEYOND
    region.high = BEYOND
    incline_region(tables, frame, region, frame.plane.sin / frame.plane.cos)
