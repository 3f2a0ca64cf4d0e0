"""The undeformed distance over a region's stations, measured in one of four ways.

normal        along the normal of the contact plane, :mod:`contact_plane`; of a pressed wheel, along the rail's, :mod:`pressed`;
vertical      at common lateral track coordinate: station s stands for y = y_0 + s cos(plane's angle);
equidistant   between the points at arc length s from the region's minimum on both curves, along the mean of their normals;
chord         likewise, with points that a circle of radius h around the one before cuts out of the curve (the source).

Except for the first, the wheel is moved so that its point at the region's minimum lies on the rail's, and the smallest gap
is added again: each region is a contact of its own, and only differences of coordinates count, not where the wheelset is.
The wheel's curve is its outline (:mod:`locus`); without yaw that is the profile, turned by the roll.
"""

from math import fabs, sqrt
from typing import Final

from ..layout import (
    PIECE_SIZE,
    SEPARATION_EQUIDISTANT_CHORD,
    SEPARATION_NORMAL,
    SEPARATION_VERTICAL,
    WORK_SEPARATION,
    Piece,
    Place,
    Profile,
    State,
    Tables,
    Work,
)
from ..surface.locus import outline_jet
from ..surface.profile_table import find_piece, height_slope, height_slope_bend
from .contact_plane import NO_GAP, TRACER_RAIL, TRACER_WHEEL, longitudinal_curvature, normal_gap
from .pressed import mean_bend, pressed_gap

# the origin of the region at work, at WORK_SEPARATION
AT_RAIL_ORIGIN: Final[int] = WORK_SEPARATION + 2
AT_WHEEL_ORIGIN: Final[int] = WORK_SEPARATION + 4

#: Lengths and lateral coordinates are met to this [m]; coordinates of a metre are rounded to 1e-16.
SHARP: Final[float] = 1e-13
ITERATIONS: Final[int] = 40
#: Gauss's abscissae and weights for six points on -1 ... 1; the kernel's pieces are shorter than their own radii.
GAUSS_1: Final[float] = 0.2386191860831969
GAUSS_2: Final[float] = 0.6612093864662645
GAUSS_3: Final[float] = 0.9324695142031521
WEIGHT_1: Final[float] = 0.4679139345726910
WEIGHT_2: Final[float] = 0.3607615730481386
WEIGHT_3: Final[float] = 0.1713244923791704


def curve_profile(tables: Tables, tracer: int) -> Profile:
    """The profile that ``tracer``, TRACER_RAIL or TRACER_WHEEL, moves on."""
    profile = tables.wheel
    if tracer == TRACER_RAIL:
        profile = tables.rail
    return profile


def curve_jet(tables: Tables, work: Work, tracer: int, u: float):
    """Point of a curve from its origin, across and down [m], its slope [-], and along the profile abscissa ``u`` the
    derivatives of the lateral coordinate [-] and of the slope [1/m].  ``tracer``: TRACER_RAIL or TRACER_WHEEL."""
    z, slope, bend = height_slope_bend(curve_profile(tables, tracer), u)
    across = u - work.origin.rail[0]
    down = z - work.origin.rail[1]
    stretch = 1.0
    if tracer == TRACER_WHEEL:
        y_track, z_track, slope, stretch, bend = outline_jet(Place.at(work, int(work.frame.place)), u, z, slope, bend)
        across = y_track - work.origin.wheel[0]
        down = z_track - work.origin.wheel[1]
    return across, down, slope, stretch, bend


def curve_speed(tables: Tables, work: Work, tracer: int, u: float):
    """Arc length per profile abscissa [-]; of an outline that folds back it is negative.  A roll does not change it."""
    speed = 1.0
    at = Place.at(work, int(work.frame.place))
    if tracer == TRACER_RAIL or not at.yawed:
        z, slope = height_slope(curve_profile(tables, tracer), u)
        speed = sqrt(1.0 + slope * slope)
    else:
        across, down, slope, stretch, bend = curve_jet(tables, work, tracer, u)
        speed = stretch * sqrt(1.0 + slope * slope)
    return speed


def panel_length(tables: Tables, work: Work, tracer: int, low: float, high: float):
    """Arc length [m] between abscissae within one piece of the profile; Gauss with six points."""
    middle = 0.5 * (low + high)
    half = 0.5 * (high - low)
    total = 0.0
    for i in range(-1, 2, 2):
        side = half * float(i)
        for k in range(3):
            away = GAUSS_1
            weight = WEIGHT_1
            if k == 1:
                away = GAUSS_2
                weight = WEIGHT_2
            if k == 2:
                away = GAUSS_3
                weight = WEIGHT_3
            total += weight * curve_speed(tables, work, tracer, middle + side * away)
    return half * total


def arc_length(tables: Tables, work: Work, tracer: int, start: float, stop: float):
    """Arc length [m] of a curve from abscissa ``start`` to ``stop``, negative where that is the smaller one.

    Piece by piece: within one the curve has all derivatives, at the ends its curvature may jump.
    """
    low = start
    high = stop
    if stop < start:
        low = stop
        high = start
    total = 0.0
    piece = find_piece(curve_profile(tables, tracer), low)
    while low < high:
        end = high
        piece = Piece.at(piece, PIECE_SIZE)
        if piece.start < high:
            end = piece.start
        total += panel_length(tables, work, tracer, low, end)
        low = end
    if stop < start:
        total = -total
    return total


def within(tables: Tables, tracer: int, u: float):
    """``u``, or the end of the profile that it lies beyond."""
    profile = curve_profile(tables, tracer)
    if u < profile.start:
        u = profile.start
    if u > profile.stop:
        u = profile.stop
    return u


def open_origin(tables: Tables, work: Work, station: float, gap: float, abscissa: float, y: float, spacing: float):
    """Measure from the minimum at ``station`` with rail abscissa ``abscissa`` and wheel abscissa ``y`` [m]; chords, if any,
    are as long as ``spacing`` [m], or arcs where that is 0."""
    if int(tables.separation) != SEPARATION_NORMAL:
        work.origin.station = station
        work.origin.gap = gap
        work.origin.spacing = 0.0
        if int(tables.separation) == SEPARATION_EQUIDISTANT_CHORD:
            work.origin.spacing = spacing
        open_curve(tables, work, TRACER_RAIL, AT_RAIL_ORIGIN, abscissa)
        open_curve(tables, work, TRACER_WHEEL, AT_WHEEL_ORIGIN, y)
    return 0


def open_curve(tables: Tables, work: Work, tracer: int, origin: int, u: float):
    """Let the curve's origin, at ``origin`` in the workspace, be its point at abscissa ``u`` [m]."""
    work[origin] = 0.0
    work[origin + 1] = 0.0
    across, down, slope, stretch, bend = curve_jet(tables, work, tracer, u)
    work[origin] = across
    work[origin + 1] = down
    return 0


def move_arc(tables: Tables, work: Work, tracer: int, length: float):
    """Move a curve's abscissa by ``length`` [m] of arc, by Newton's method; 1 if the curve is that long, else 0."""
    u = work[tracer]
    rest = length
    for i in range(ITERATIONS):
        if fabs(rest) < SHARP:
            work[tracer] = u
            return 1
        speed = curve_speed(tables, work, tracer, u)
        if not speed > 0.0:
            return 0
        following = within(tables, tracer, u + rest / speed)
        if following == u:
            return 0
        rest -= arc_length(tables, work, tracer, u, following)
        u = following
    return 0


def move_chord(tables: Tables, work: Work, tracer: int, chord: float):
    """Move a curve's abscissa to where a circle of radius abs(``chord``) [m] around the point cuts the curve, forward where
    ``chord`` is positive; 1 if it does, else 0."""
    from_across, from_down, slope, stretch, bend = curve_jet(tables, work, tracer, work[tracer])
    if not stretch > 0.0:
        return 0
    u = within(tables, tracer, work[tracer] + chord / (stretch * sqrt(1.0 + slope * slope)))
    for i in range(ITERATIONS):
        across, down, slope, stretch, bend = curve_jet(tables, work, tracer, u)
        across -= from_across
        down -= from_down
        length = sqrt(across * across + down * down)
        if fabs(length - fabs(chord)) < SHARP:
            work[tracer] = u
            return 1
        along = (across + slope * down) * stretch
        if not along * chord > 0.0:
            return 0
        following = within(tables, tracer, u - (length - fabs(chord)) * length / along)
        if following == u:
            return 0
        u = following
    return 0


def move_station(tables: Tables, work: Work, tracer: int, station: float):
    """Move a curve's abscissa from the tracer's station to ``station`` [m], by arc or by chords; 1 if there is one."""
    way = station - work.frame.tracer_station
    spacing = work.origin.spacing
    exists = 1
    if spacing == 0.0:
        exists = move_arc(tables, work, tracer, way)
    else:
        chord = spacing
        if way < 0.0:
            chord = -spacing
        for i in range(int(fabs(way) / spacing + 0.5)):
            if exists == 1:
                exists = move_chord(tables, work, tracer, chord)
    return exists


def move_across(tables: Tables, work: Work, lateral: float):
    """Move the wheel's abscissa to where its outline is ``lateral`` [m] from the origin, by Newton's method; 1 if there is
    such a place, else 0."""
    u = within(tables, TRACER_WHEEL, work.frame.tracer_wheel)
    for i in range(ITERATIONS):
        across, down, slope, stretch, bend = curve_jet(tables, work, TRACER_WHEEL, u)
        if not stretch > 0.0:
            return 0
        if fabs(across - lateral) < SHARP:
            work.frame.tracer_wheel = u
            return 1
        following = within(tables, TRACER_WHEEL, u - (across - lateral) / stretch)
        if following == u:
            return 0
        u = following
    return 0


def vertical_rise(tables: Tables, work: Work, station: float):
    """Vertical distance at ``station`` [m], its rate [-] and bend [1/m] over the stations, and 1 if it exists."""
    per_station = work.frame.cos
    lateral = (station - work.origin.station) * per_station
    exists = move_across(tables, work, lateral)
    work.frame.tracer_rail = work.origin.rail[0] + lateral
    if within(tables, TRACER_RAIL, work.frame.tracer_rail) != work.frame.tracer_rail:
        exists = 0
    across, rail_down, rail_slope, along, rail_bend = curve_jet(tables, work, TRACER_RAIL, work.frame.tracer_rail)
    across, down, slope, stretch, bend = curve_jet(tables, work, TRACER_WHEEL, work.frame.tracer_wheel)
    bend = rail_bend - bend / stretch
    return rail_down - down, (rail_slope - slope) * per_station, bend * per_station * per_station, exists


def equidistant_rise(tables: Tables, work: Work, station: float):
    """Distance along the mean of the normals between the points at ``station`` [m] on both curves, signed, its rate [-] and
    bend [1/m] over the stations, and 1 if it exists.

    With angles theta of the tangents and n = (sin, -cos) of their mean, d = (p_w - p_r) n and

        dd/ds = (t_w - t_r) n + (p_w - p_r) t (theta_w' + theta_r') / 2

    of which the last term is of third order in s.
    """
    on_rail = move_station(tables, work, TRACER_RAIL, station)
    on_wheel = move_station(tables, work, TRACER_WHEEL, station)
    across, down, slope, stretch, bend = curve_jet(tables, work, TRACER_RAIL, work.frame.tracer_rail)
    rail_cos = 1.0 / sqrt(1.0 + slope * slope)
    rail_sin = slope * rail_cos
    rail_turn = bend * rail_cos * rail_cos * rail_cos
    wheel_across, wheel_down, slope, stretch, bend = curve_jet(tables, work, TRACER_WHEEL, work.frame.tracer_wheel)
    wheel_cos = 1.0 / sqrt(1.0 + slope * slope)
    wheel_sin = slope * wheel_cos
    wheel_turn = bend / stretch * wheel_cos * wheel_cos * wheel_cos
    across = wheel_across - across
    down = wheel_down - down
    cosine = wheel_cos + rail_cos
    sine = wheel_sin + rail_sin
    size = sqrt(cosine * cosine + sine * sine)
    cosine /= size
    sine /= size
    exists = 0
    if on_rail == 1 and on_wheel == 1 and stretch > 0.0:
        exists = 1
    rate = (wheel_cos - rail_cos) * sine - (wheel_sin - rail_sin) * cosine
    rate += 0.5 * (across * cosine + down * sine) * (wheel_turn + rail_turn)
    return across * sine - down * cosine, rate, rail_turn - wheel_turn, exists


def lean_away(tables: Tables, work: Work):
    """What a pressed wheel's depth lacks at the tracer's point, depth (1 - cos(angle between the normals)) [m], since it is
    pressed along the region's normal; and its rate [-]."""
    height, slope, bend = height_slope_bend(tables.rail, work.frame.tracer_rail)
    cosine = 1.0 / sqrt(1.0 + slope * slope)
    along = cosine * (work.frame.cos + slope * work.frame.sin)
    across = cosine * (slope * work.frame.cos - work.frame.sin)
    return work.frame.depth * (1.0 - along), work.frame.depth * across * bend * cosine * cosine * cosine


def moved_separation(tables: Tables, work: Work, state: State, station: float, kind: int):
    """``separation`` of any other kind than along the normal: with the wheel moved onto the rail at the region's minimum."""
    state.node_count += 1.0
    if kind == SEPARATION_VERTICAL:
        gap, rate, bend, exists = vertical_rise(tables, work, station)
    else:
        gap, rate, bend, exists = equidistant_rise(tables, work, station)
    work.frame.tracer_station = station
    gap += work.origin.gap
    if work.frame.pressed and kind != SEPARATION_VERTICAL:
        lack, more = lean_away(tables, work)
        gap += lack
        rate += more
    if exists == 0:
        gap = NO_GAP
    z, slope, wheel_bend = height_slope_bend(tables.wheel, work.frame.tracer_wheel)
    wheel_bend = mean_bend(tables, work, work.frame.tracer_wheel, wheel_bend)
    curvature = longitudinal_curvature(tables, work, Place.at(work, int(work.frame.place)), z, slope, wheel_bend)
    return gap, rate, bend, curvature


def separation(tables: Tables, work: Work, state: State, station: float, tolerance: float):
    """Undeformed distance g [m], dg/ds [-], d2g/ds2 [1/m] and the wheel's 1/R_x [1/m] at ``station`` [m], measured as chosen;
    NO_GAP where a profile has ended.

    ``tolerance`` is that of :func:`normal_gap`; all else is met to SHARP.
    """
    kind = int(tables.separation)
    if kind == SEPARATION_NORMAL and not work.frame.pressed:
        gap, rate, bend, curvature = normal_gap(tables, work, state, station, tolerance)
    elif kind == SEPARATION_NORMAL:
        gap, rate, bend, curvature = pressed_gap(tables, work, state, station)
    else:
        gap, rate, bend, curvature = moved_separation(tables, work, state, station, kind)
    return gap, rate, bend, curvature
