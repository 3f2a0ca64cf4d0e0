"""The undeformed distance over a region's stations, measured in one of four ways.

normal        along the normal of the contact plane, :mod:`frame`; of a pressed wheel, along the
              rail's, :mod:`penetrated`;
vertical      at common lateral track coordinate: station s stands for y = y_0 + s cos(plane's angle);
equidistant   between the points at arc length s from the region's minimum on both curves, along the mean of
              their normals;
chord         likewise, with points that a circle of radius h around the one before cuts out of the curve (the
              source).

Except for the first, the wheel is moved so that its point at the region's minimum lies on the rail's, and the
smallest gap is added again: each region is a contact of its own, and only differences of coordinates count,
not where the wheelset is.
"""

from math import sqrt

from ..layout import RAIL, SEPARATION_NORMAL, SEPARATION_VERTICAL, WHEEL, Frame, Origin, Pair, seldom
from ..surface.tables import height_slope_bend
from .frame import NO_GAP, normal_gap
from .curves import curve_jet, move_across, move_to_station, within
from .penetrated import NOT_MET, met_curvature, penetrated_gap
from .traces import note_point


@seldom
def vertical_rise(pair: Pair, frame: Frame, origin: Origin, station: float):
    """Vertical distance at ``station`` [m], its rate [-] and bend [1/m] over the stations, and whether it
    exists."""
    per_station = frame.plane.cos
    lateral = (station - origin.station) * per_station
    exists = move_across(pair, frame, origin, lateral)
    frame.traces[RAIL].abscissa = origin.points[RAIL].y + lateral
    if within(pair, RAIL, frame.traces[RAIL].abscissa) != frame.traces[RAIL].abscissa:
        exists = False
    across, rail_down, rail_slope, along, rail_bend = curve_jet(
        pair, frame, origin, RAIL, frame.traces[RAIL].abscissa
    )
    across, down, slope, stretch, bend = curve_jet(pair, frame, origin, WHEEL, frame.traces[WHEEL].abscissa)
    bend = rail_bend - bend / stretch
    return rail_down - down, (rail_slope - slope) * per_station, bend * per_station * per_station, exists


@seldom
def equidistant_rise(pair: Pair, frame: Frame, origin: Origin, station: float):
    """Distance along the mean of the normals between the points at ``station`` [m] on both curves, signed,
    its rate [-] and bend [1/m] over the stations, and whether it exists.

    With angles theta of the tangents and n = (sin, -cos) of their mean, d = (p_w - p_r) n and

        dd/ds = (t_w - t_r) n + (p_w - p_r) t (theta_w' + theta_r') / 2

    of which the last term is of third order in s.
    """
    on_rail = move_to_station(pair, frame, origin, RAIL, station)
    on_wheel = move_to_station(pair, frame, origin, WHEEL, station)
    across, down, slope, stretch, bend = curve_jet(pair, frame, origin, RAIL, frame.traces[RAIL].abscissa)
    rail_cos = 1.0 / sqrt(1.0 + slope * slope)
    rail_sin = slope * rail_cos
    rail_curvature = bend * rail_cos * rail_cos * rail_cos
    wheel_across, wheel_down, slope, stretch, bend = curve_jet(
        pair, frame, origin, WHEEL, frame.traces[WHEEL].abscissa
    )
    wheel_cos = 1.0 / sqrt(1.0 + slope * slope)
    wheel_sin = slope * wheel_cos
    wheel_curvature = bend / stretch * wheel_cos * wheel_cos * wheel_cos
    across = wheel_across - across
    down = wheel_down - down
    cosine = wheel_cos + rail_cos
    sine = wheel_sin + rail_sin
    size = sqrt(cosine * cosine + sine * sine)
    cosine /= size
    sine /= size
    exists = on_rail and on_wheel and stretch > 0.0
    rate = (wheel_cos - rail_cos) * sine - (wheel_sin - rail_sin) * cosine
    rate += 0.5 * (across * cosine + down * sine) * (wheel_curvature + rail_curvature)
    return across * sine - down * cosine, rate, rail_curvature - wheel_curvature, exists


@seldom
def depth_lost(pair: Pair, frame: Frame):
    """How much less deep a pressed wheel is at the rail's trace than at the contact point, since it is
    pressed along the region's normal: depth (1 - cos(angle between the normals)) [m]; and its rate [-]."""
    height, slope, bend = height_slope_bend(pair.rail, frame.traces[RAIL].abscissa)
    cosine = 1.0 / sqrt(1.0 + slope * slope)
    along = cosine * (frame.plane.cos + slope * frame.plane.sin)
    across = cosine * (slope * frame.plane.cos - frame.plane.sin)
    return frame.depth * (1.0 - along), frame.depth * across * bend * cosine * cosine * cosine


@seldom
def moved_separation(pair: Pair, frame: Frame, origin: Origin, station: float, kind: int):
    """``separation`` of any other kind than along the normal: with the wheel moved onto the rail at the
    region's minimum."""
    frame.place.node_count += 1.0
    if kind == SEPARATION_VERTICAL:
        gap, rate, bend, exists = vertical_rise(pair, frame, origin, station)
    else:
        gap, rate, bend, exists = equidistant_rise(pair, frame, origin, station)
    frame.station = station
    gap += origin.gap
    if frame.pressed and kind != SEPARATION_VERTICAL:
        lost, more = depth_lost(pair, frame)
        gap += lost
        rate += more
    if not exists:
        gap = NO_GAP
    y = frame.traces[WHEEL].abscissa
    z, slope, second = height_slope_bend(pair.wheel, y)
    note_point(frame.place.meeting, y, z, slope, second)
    return gap, rate, bend


def separation_jet(pair: Pair, frame: Frame, origin: Origin, station: float, tolerance: float):
    """Undeformed distance g [m], dg/ds [-] and d2g/ds2 [1/m] at ``station`` [m], measured as chosen; NO_GAP
    where a profile has ended.

    ``tolerance`` is that of :func:`normal_gap`; all else is satisfied to MOVE_SHARP.
    """
    kind = pair.tables.separation
    if kind == SEPARATION_NORMAL and not frame.pressed:
        gap, rate, bend = normal_gap(pair, frame, station, tolerance)
    elif kind == SEPARATION_NORMAL:
        gap, rate, bend = penetrated_gap(pair, frame, station)
    else:
        gap, rate, bend = moved_separation(pair, frame, origin, station, kind)
    return gap, rate, bend


def separation(pair: Pair, frame: Frame, origin: Origin, station: float, tolerance: float):
    """:func:`separation_jet`, and the wheel's 1/R_x [1/m], NOT_MET where a pressed wheel is not met."""
    gap, rate, bend = separation_jet(pair, frame, origin, station, tolerance)
    curvature = NOT_MET
    if gap < NO_GAP or not frame.pressed or pair.tables.separation != SEPARATION_NORMAL:
        curvature = met_curvature(pair, frame)
    return gap, rate, bend, curvature
