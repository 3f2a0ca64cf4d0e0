"""The plane of a contact, and the gap of wheel and rail along its normal."""

from math import sqrt
from typing import Final

from ..layout import Frame, Place, State, Tables
from ..surface.gap import FOLDED
from ..surface.locus import outline_jet
from ..surface.profile_table import height_slope_bend
from .traces import start_traces, trace_rail, trace_wheel

#: Where no wheel or rail is left at a station, the gap counts as this [m].
NO_GAP: Final[float] = 1.0


def open_frame(tables: Tables, frame: Frame, place: Place, y: float, aside: float, shift: float):
    """Place the contact plane at wheel abscissa ``y`` [m]; the slope is the rail's, which is the outline's
    there.

    aside, shift : lateral and vertical shift that let the wheel touch the rail there [m].

    Returns what describes the point: wheel height [m] and slope [-], lateral track coordinate [m], rail slope
    [-], and how much the slopes of rail and outline differ [-], FOLDED as in :mod:`gap`.
    """
    z, slope, bend = height_slope_bend(tables.wheel, y)
    y_track, z_track, outline_slope, stretch, outline_rate = outline_jet(place, y, z, slope, bend)
    y_track += aside
    abscissa = y_track - tables.rail_y
    height, rail_slope, rail_bend = height_slope_bend(tables.rail, abscissa)
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
    mismatch = rail_slope - outline_slope
    if not stretch > 0.0:
        mismatch = FOLDED
    return z, slope, y_track, rail_slope, mismatch


def normal_gap(tables: Tables, frame: Frame, state: State, station: float, tolerance: float):
    """Gap g along the contact normal [m], dg/ds [-], d2g/ds2 [1/m] and the wheel's 1/R_x [1/m] at ``station``
    [m].

    NO_GAP where a profile has ended.  ``tolerance`` [m] is that of the stations of wheel and rail.
    """
    state.node_count += 1.0
    rail_height, rail_rate, rail_bend, on_rail = trace_rail(tables, frame, station, tolerance)
    wheel_height, wheel_rate, wheel_bend, curvature, on_wheel = trace_wheel(tables, frame, station, tolerance)
    frame.station = station
    gap = wheel_height - rail_height + frame.raised
    if not on_rail or not on_wheel:
        gap = NO_GAP
    return gap, wheel_rate - rail_rate, wheel_bend - rail_bend, curvature


def is_yawed(frame: Frame) -> bool:
    """Whether the wheel of the open frame is yawed."""
    return frame.place.yawed
