"""Rail and wheel as two curves across the track, each over its profile's abscissa, for separations measured
along them.

The wheel's curve is its outline (:mod:`locus`); without yaw that is the profile, turned by the roll.
``curve`` is RAIL or WHEEL, and its present abscissa is that of the frame's trace.  Coordinates are those from
the origin of the region.

Arc lengths of the curves are found in two ways, for two purposes.

Gauss     exact to rounding, piece by piece of the profile: the arcs of the equidistant separation, which are
          compared on wheel and rail to 1e-13 m and must not depend on where a piece ends.
a table   prepared with the profiles: the stations of a pressed wheel along its rail; any coordinate is
          suitable for them that is smooth, the same at every use, and cheap.  That is the way for which the
          table of abscissae holds, within 1e-8 m of the arc length.

Moves along the curves are by arc length, by chords, or to a lateral coordinate.  A move leaves the new
abscissa in the frame's trace, and returns whether the curve reaches that far.
"""

from math import fabs, sqrt
from typing import Final

from ..layout import (
    PIECE_SIZE,
    RAIL,
    SEPARATION_EQUIDISTANT_CHORD,
    SEPARATION_NORMAL,
    WHEEL,
    Frame,
    Origin,
    Pair,
    Piece,
    Profile,
    Region,
    seldom,
)
from ..surface.locus import outline_jet
from ..surface.tables import find_piece, height_slope, height_slope_bend, read_cubic, read_cubic_jet

#: Gauss's abscissae and weights for six points on -1 ... 1; the kernel's pieces are shorter than their
#: own radii.
GAUSS_1: Final[float] = 0.2386191860831969
GAUSS_2: Final[float] = 0.6612093864662645
GAUSS_3: Final[float] = 0.9324695142031521
WEIGHT_1: Final[float] = 0.4679139345726910
WEIGHT_2: Final[float] = 0.3607615730481386
WEIGHT_3: Final[float] = 0.1713244923791704
#: Lengths and lateral coordinates are satisfied to this [m]; coordinates of a metre are rounded to 1e-16.
MOVE_SHARP: Final[float] = 1e-13
MOVE_ITERATIONS: Final[int] = 40


@seldom
def curve_profile(pair: Pair, curve: int) -> Profile:
    """The profile of a curve."""
    profile = pair.wheel
    if curve == RAIL:
        profile = pair.rail
    return profile


@seldom
def curve_jet(pair: Pair, frame: Frame, origin: Origin, curve: int, u: float):
    """Point of a curve from its origin, across and down [m], its slope [-], and along the profile abscissa
    ``u`` the derivatives of the lateral coordinate [-] and of the slope [1/m]."""
    z, slope, bend = height_slope_bend(curve_profile(pair, curve), u)
    across = u - origin.points[RAIL].y
    down = z - origin.points[RAIL].z
    stretch = 1.0
    if curve == WHEEL:
        y_track, z_track, slope, stretch, bend = outline_jet(frame.place, u, z, slope, bend)
        across = y_track - origin.points[WHEEL].y
        down = z_track - origin.points[WHEEL].z
    return across, down, slope, stretch, bend


@seldom
def curve_speed(pair: Pair, frame: Frame, origin: Origin, curve: int, u: float):
    """Arc length per profile abscissa [-]; of an outline that folds back it is negative.  A roll does not
    change it."""
    speed = 1.0
    if curve == RAIL or not frame.place.yawed:
        z, slope = height_slope(curve_profile(pair, curve), u)
        speed = sqrt(1.0 + slope * slope)
    else:
        across, down, slope, stretch, bend = curve_jet(pair, frame, origin, curve, u)
        speed = stretch * sqrt(1.0 + slope * slope)
    return speed


@seldom
def within(pair: Pair, curve: int, u: float):
    """``u``, or the end of the profile that it lies beyond [m]."""
    profile = curve_profile(pair, curve)
    u = min(max(u, profile.start), profile.stop)
    return u


@seldom
def open_origin(pair: Pair, frame: Frame, origin: Origin, region: Region, spacing: float):
    """Measure from the minimum of ``region``; chords, if any, are as long as ``spacing`` [m], or arcs where
    that is 0."""
    if pair.tables.separation != SEPARATION_NORMAL:
        origin.station = region.station
        origin.gap = region.gap
        origin.spacing = 0.0
        if pair.tables.separation == SEPARATION_EQUIDISTANT_CHORD:
            origin.spacing = spacing
        open_curve(pair, frame, origin, RAIL, region.rail)
        open_curve(pair, frame, origin, WHEEL, region.wheel)


@seldom
def open_curve(pair: Pair, frame: Frame, origin: Origin, curve: int, u: float):
    """Let the origin of a curve be its point at abscissa ``u`` [m]."""
    point = origin.points[curve]
    point.y = 0.0
    point.z = 0.0
    across, down, slope, stretch, bend = curve_jet(pair, frame, origin, curve, u)
    point.y = across
    point.z = down


@seldom
def panel_length(pair: Pair, frame: Frame, origin: Origin, curve: int, low: float, high: float):
    """Arc length [m] between abscissae within one piece of the profile, by Gauss's
    formula with six points."""
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
            total += weight * curve_speed(pair, frame, origin, curve, middle + side * away)
    return half * total


@seldom
def arc_length(pair: Pair, frame: Frame, origin: Origin, curve: int, start: float, stop: float):
    """Arc length [m] of a curve from abscissa ``start`` to ``stop``, negative where
    ``stop`` is the smaller one.

    Piece by piece: within one the curve has all derivatives, at the ends its curvature may jump.
    """
    low = start
    high = stop
    if stop < start:
        low = stop
        high = start
    total = 0.0
    piece = find_piece(curve_profile(pair, curve), low)
    while low < high:
        end = high
        piece = Piece.at(piece, PIECE_SIZE)
        if piece.start < high:
            end = piece.start
        total += panel_length(pair, frame, origin, curve, low, end)
        low = end
    if stop < start:
        total = -total
    return total


@seldom
def rail_way(pair: Pair, abscissa: float):
    """Way along the rail [m] from its start to an ``abscissa`` [m], for which the table of abscissae gives just
    this one: the table of arcs is within 1e-8 m of it, and a step of Newton's method leaves rounding."""
    way = read_cubic(pair.rail_arc, abscissa)
    found, rate = read_cubic_jet(pair.rail_at_arc, way)
    return way + (abscissa - found) / rate


@seldom
def rail_length(pair: Pair, start: float, stop: float):
    """Way along the rail between two abscissae [m], negative where ``stop`` is the smaller one."""
    return rail_way(pair, stop) - rail_way(pair, start)


def abscissa_after(pair: Pair, way: float):
    """Abscissa [m] of the rail after a ``way`` [m] from its start; beyond an end, by what is missing."""
    abscissae = pair.rail_at_arc
    if way < 0.0:
        x = pair.rail.start + way
    elif way * abscissae.cells_per_unit > abscissae.count:
        x = pair.rail.stop + (way - abscissae.count / abscissae.cells_per_unit)
    else:
        x = read_cubic(abscissae, way)
    return x


@seldom
def move_arc(pair: Pair, frame: Frame, origin: Origin, curve: int, length: float) -> bool:
    """Move a curve's abscissa by ``length`` [m] of arc, by Newton's method; whether the curve is
    that long."""
    u = frame.traces[curve].abscissa
    remainder = length
    for i in range(MOVE_ITERATIONS):
        if fabs(remainder) < MOVE_SHARP:
            frame.traces[curve].abscissa = u
            return True
        speed = curve_speed(pair, frame, origin, curve, u)
        if not speed > 0.0:
            return False
        following = within(pair, curve, u + remainder / speed)
        if following == u:
            return False
        remainder -= arc_length(pair, frame, origin, curve, u, following)
        u = following
    return False


@seldom
def move_chord(pair: Pair, frame: Frame, origin: Origin, curve: int, chord: float) -> bool:
    """Move a curve's abscissa to where a circle of radius abs(``chord``) [m] around the point cuts the curve,
    forward where ``chord`` is positive; whether it does."""
    start = frame.traces[curve].abscissa
    from_across, from_down, slope, stretch, bend = curve_jet(pair, frame, origin, curve, start)
    if not stretch > 0.0:
        return False
    u = within(pair, curve, start + chord / (stretch * sqrt(1.0 + slope * slope)))
    for i in range(MOVE_ITERATIONS):
        across, down, slope, stretch, bend = curve_jet(pair, frame, origin, curve, u)
        across -= from_across
        down -= from_down
        length = sqrt(across * across + down * down)
        if fabs(length - fabs(chord)) < MOVE_SHARP:
            frame.traces[curve].abscissa = u
            return True
        along = (across + slope * down) * stretch
        if not along * chord > 0.0:
            return False
        following = within(pair, curve, u - (length - fabs(chord)) * length / along)
        if following == u:
            return False
        u = following
    return False


@seldom
def move_to_station(pair: Pair, frame: Frame, origin: Origin, curve: int, station: float) -> bool:
    """Move a curve's abscissa from the station of the traces to ``station`` [m], by arc or by chords; whether
    there is one."""
    way = station - frame.station
    spacing = origin.spacing
    exists = True
    if spacing == 0.0:
        exists = move_arc(pair, frame, origin, curve, way)
    else:
        chord = spacing
        if way < 0.0:
            chord = -spacing
        for i in range(int(fabs(way) / spacing + 0.5)):
            if exists:
                exists = move_chord(pair, frame, origin, curve, chord)
    return exists


@seldom
def move_across(pair: Pair, frame: Frame, origin: Origin, lateral: float) -> bool:
    """Move the wheel's abscissa to where its outline is ``lateral`` [m] from the origin, by Newton's method;
    whether there is such a place."""
    u = within(pair, WHEEL, frame.traces[WHEEL].abscissa)
    for i in range(MOVE_ITERATIONS):
        across, down, slope, stretch, bend = curve_jet(pair, frame, origin, WHEEL, u)
        if not stretch > 0.0:
            return False
        if fabs(across - lateral) < MOVE_SHARP:
            frame.traces[WHEEL].abscissa = u
            return True
        following = within(pair, WHEEL, u - (across - lateral) / stretch)
        if following == u:
            return False
        u = following
    return False
