"""The overlap of a wheel that is pressed into its rail, along the rail's own normals.

A wheel that comes down meets every part of the rail along another normal.  Where a patch reaches around a corner one plane
cannot hold that; so the overlap o of a pressed wheel is measured along the normal of each rail point x, to where that line
meets the wheel's outline (Y, Z) as it stands,

    Y - x + (Z - z_rail(x)) m = 0,   o = (Z - z_rail - m (Y - x)) / sqrt(1 + m^2),   m = z_rail'(x)

and stations run along the rail, by its arc length.  With slope m_w of the outline there and kappa of the rail

    do/ds = (m_w - m) / (1 + m m_w)

but for a factor 1 - kappa o, below 1 % and left out: kappa jumps where profiles are joined, and a slope must not.  The
deepest point of a region is a pair of points with one normal, and o does not ask where stations begin.
"""

from math import fabs, sqrt
from typing import Final

from ..layout import Place, State, Tables, Work
from ..surface.locus import outline_jet
from ..surface.profile_table import height_slope, height_slope_bend
from .contact_plane import NO_GAP, longitudinal_curvature

#: The wheel's abscissa is met to this [m],
LINE_SHARP: Final[float] = 1e-12
#: and the rail's arc length, where Newton's last move is no longer, to the square of it.
ARC_SHARP: Final[float] = 1e-9
#: Over a longer way the wheel's abscissa per station is noted for the next guess [m].
LEAST_WAY: Final[float] = 1e-5
LINE_ITERATIONS: Final[int] = 20
LINE_JOINT: Final[float] = 1e-7
#: Arc lengths are added up by Simpson's rule over stretches of no more than this [m].
ARC_STEP: Final[float] = 1e-3
#: Points of wheel and rail farther apart than this do not face each other [m].
FARTHEST: Final[float] = 5e-3
#: Longest move of the wheel's abscissa in one step of Newton's method [m].
LINE_STEP: Final[float] = 4e-3


def normal_line(tables: Tables, work: Work, at: Place, abscissa: float, y: float, height: float):
    """Wheel abscissa [m] where the rail's normal at ``abscissa`` meets the wheel placed at ``at`` and moved down by
    ``height``, looked for from ``y``; the overlap [m], its derivatives [-, 1/m] along the rail's arc, the wheel's 1/R_x [1/m];
    and 1 if there is such a point, else 0."""
    rail = tables.rail
    wheel = tables.wheel
    z_rail, m, rail_bend = height_slope_bend(rail, abscissa)
    cosine = 1.0 / sqrt(1.0 + m * m)
    kappa = rail_bend * cosine * cosine * cosine
    for i in range(LINE_ITERATIONS):
        z, slope, bend = height_slope_bend(wheel, y)
        y_track, z_track, outline_slope, stretch, rate = outline_jet(at, y, z, slope, bend)
        across = y_track - tables.rail_y - abscissa
        down = z_track + height - z_rail
        rest = across + down * m
        along = stretch * (1.0 + m * outline_slope)
        if not (along > 0.0 and stretch > 0.0):
            return y, 0.0, 0.0, 0.0, 0.0, 0
        move = -rest / along
        sharp = LINE_SHARP
        if i == LINE_ITERATIONS - 1:
            # at a joint of the profile Newton's method can go to and fro between both sides
            sharp = LINE_JOINT
        if fabs(move) < sharp:
            overlap = (down - m * across) * cosine
            if not fabs(overlap) < FARTHEST:
                return y, 0.0, 0.0, 0.0, 0.0, 0
            tangent = (outline_slope - m) / (1.0 + m * outline_slope)
            # the angle between both curves turns by the wheel's curvature over its own arc less the rail's
            wheel_cos = 1.0 / sqrt(1.0 + outline_slope * outline_slope)
            wheel_kappa = rate / stretch * wheel_cos * wheel_cos * wheel_cos
            steep = 1.0 + tangent * tangent
            turn = wheel_kappa * sqrt(steep) - kappa
            curvature = longitudinal_curvature(tables, work, at, z, slope, mean_bend(tables, work, y, bend))
            return y, overlap, tangent, steep * turn, curvature, 1
        if move > LINE_STEP:
            move = LINE_STEP
        if move < -LINE_STEP:
            move = -LINE_STEP
        y += move
        if not (y >= wheel.start and y <= wheel.stop):
            return y, 0.0, 0.0, 0.0, 0.0, 0
    return y, 0.0, 0.0, 0.0, 0.0, 0


def mean_bend(tables: Tables, work: Work, y: float, bend: float):
    """Second derivative of the wheel profile [1/m] at ``y``, averaged over FRAME_BLUR to either side where that is set.

    With yaw it is part of the longitudinal curvature; taken at a point, it would jump when a profile's joint passes a node.
    """
    blur = work.frame.blur
    if blur > 0.0:
        wheel = tables.wheel
        low = y - blur
        high = y + blur
        if low < wheel.start:
            low = wheel.start
        if high > wheel.stop:
            high = wheel.stop
        z, low_slope = height_slope(wheel, low)
        z, high_slope = height_slope(wheel, high)
        bend = (high_slope - low_slope) / (high - low)
    return bend


def rail_speed(tables: Tables, abscissa: float):
    """Arc length per abscissa of the rail [-]."""
    height, slope = height_slope(tables.rail, abscissa)
    return sqrt(1.0 + slope * slope)


def rail_length(tables: Tables, start: float, stop: float):
    """Length of the rail profile between two abscissae [m], negative where ``stop`` is the smaller."""
    cells = int(fabs(stop - start) / ARC_STEP) + 1
    step = (stop - start) / float(cells)
    total = 0.0
    low = rail_speed(tables, start)
    for i in range(cells):
        begin = start + step * float(i)
        middle = rail_speed(tables, begin + 0.5 * step)
        high = rail_speed(tables, begin + step)
        total += low + 4.0 * middle + high
        low = high
    return total * step / 6.0


def rail_abscissa(tables: Tables, start: float, length: float):
    """Abscissa [m] of the rail at ``length`` [m] of arc from ``start``: in steps of no more than ARC_STEP, each a parabola's
    guess put right by Newton's method on Simpson's rule."""
    steps = int(fabs(length) / ARC_STEP) + 1
    way = length / float(steps)
    x = start
    for step in range(steps):
        height, slope, bend = height_slope_bend(tables.rail, x)
        before = sqrt(1.0 + slope * slope)
        cosine = 1.0 / before
        following = x + way * cosine * (1.0 - 0.5 * way * slope * bend * cosine * cosine * cosine)
        for i in range(LINE_ITERATIONS):
            middle = rail_speed(tables, 0.5 * (x + following))
            after = rail_speed(tables, following)
            move = (way - (following - x) * (before + 4.0 * middle + after) / 6.0) / after
            following += move
            if fabs(move) < ARC_SHARP:
                break
        x = following
    return x


def pressed_gap(tables: Tables, work: Work, state: State, station: float):
    """What the overlap lacks of the region's depth at ``station`` [m], raised by the region's own gap, with its derivatives
    [-, 1/m] and the wheel's 1/R_x [1/m]: as ``normal_gap``, for the open frame of a pressed wheel."""
    state.node_count += 1.0
    rail = tables.rail
    way = station - work.frame.tracer_station
    abscissa = rail_abscissa(tables, work.frame.tracer_rail, way)
    gap = NO_GAP
    rate = 0.0
    bend = 0.0
    curvature = 1.0
    if abscissa >= rail.start and abscissa <= rail.stop:
        y, overlap, rise, turn, found_curvature, found = normal_line(tables, work, Place.at(work, int(work.frame.place)), abscissa,
                                                                     work.frame.tracer_wheel + way * work.frame.tracer_wheel_rate,
                                                                     work.frame.pose)
        if found == 1:
            gap = work.frame.raised + work.frame.depth - overlap
            rate = -rise
            bend = -turn
            curvature = found_curvature
            if fabs(way) > LEAST_WAY:
                work.frame.tracer_wheel_rate = (y - work.frame.tracer_wheel) / way
            work.frame.tracer_wheel = y
            work.frame.tracer_rail = abscissa
            work.frame.tracer_station = station
    return gap, rate, bend, curvature
