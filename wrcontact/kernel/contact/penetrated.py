"""The overlap of a wheel that is pressed into its rail, along the rail's own normals.

A wheel that comes down meets every part of the rail along another normal.  Where a patch reaches around a
corner one plane cannot hold that; so the overlap o of a pressed wheel is measured along the normal of each
rail point x, to where that line meets the wheel's outline (Y, Z) as it stands,

    Y - x + (Z - z_rail(x)) m = 0,   o = (Z - z_rail - m (Y - x)) / sqrt(1 + m^2),   m = z_rail'(x)

and stations run along the rail, by its arc length.  With slope m_w of the outline there and kappa of the rail

    do/ds = (m_w - m) / (1 + m m_w)

but for a factor 1 - kappa o, below 1 % and left out: kappa jumps where profiles are joined, and a slope must
not.  The deepest point of a region is a pair of points with one normal, and o does not depend on where
stations begin.

Where the overlap is largest, or smallest between two largest ones, a pair of points has a common normal.
Such pairs are found by a bracket on the rail, with Newton's method inside it, also where curvatures jump.  In
a pair the outline and the rail have one slope m and the line between both points is normal to them,

    m_wheel(y) = m_rail(x),   X - x + (Z - z_rail(x)) m = 0,
    depth = (Z - z_rail - m (X - x)) / sqrt(1 + m^2)

with (X, Z) the wheel's point at abscissa y in its present pose.
"""

from math import fabs, sqrt
from typing import Final

from ..layout import RAIL, WHEEL, Frame, Pair, Place, inlined, seldom
from ..surface.curvature import longitudinal_curvature
from ..surface.locus import outline_jet
from ..surface.tables import height_slope, height_slope_bend
from .curves import rail_abscissa
from .frame import NO_GAP

#: The wheel's abscissa is found when Newton's last move is no longer than this [m], for deepest points and
#: for nodes. The move is still made, and the overlap follows it to second order: what is left is rounding,
#: or 4e-11 m at a node where the curvature jumps within the move.
LINE_SHARP: Final[float] = 1e-8
NODE_SHARP: Final[float] = 1e-6
#: And this after the last iteration: at a joint of the profile Newton's method can alternate between both
#: sides [m].
LINE_JOINT: Final[float] = 1e-7
LINE_ITERATIONS: Final[int] = 20
#: Longest move of the wheel's abscissa in one step of Newton's method [m].
LINE_STEP: Final[float] = 4e-3
#: Points of wheel and rail farther apart than this do not face each other [m].
FARTHEST: Final[float] = 5e-3
#: Over a longer way the wheel's abscissa per station is noted for the next estimate [m].
LEAST_WAY: Final[float] = 1e-5
#: A deepest point is located to this on the rail [m], so that differences of its place between poses are its
#: derivatives; its depth, being second order, asks for less.
DEEP_SHARP: Final[float] = 1e-13
DEEP_ITERATIONS: Final[int] = 60
#: In place of the wheel's 1/R_x where a pressed wheel is not met [1/m].
NOT_MET: Final[float] = 1.0
#: Slope of the overlap below which it has changed sign there [-]: standard profiles are joined with slopes
#: that differ by up to 1e-5.
LEVEL_RISE: Final[float] = 1e-4
#: And below which it is zero but for rounding: a bracket of which one end never moved holds a turning point
#: only then.
ZERO_RISE: Final[float] = 1e-9


@inlined
def meet_wheel(pair: Pair, place: Place, abscissa: float, y: float, height: float, tolerance: float) -> bool:
    """Whether the rail's normal at ``abscissa`` meets the wheel placed at ``place`` and moved down by
    ``height``, sought from ``y`` to ``tolerance`` [m]; where is the place's ``meeting``."""
    meeting = place.meeting
    meeting.overlap = 0.0
    wheel = pair.wheel
    z_rail, m, rail_bend = height_slope_bend(pair.rail, abscissa)
    cosine = 1.0 / sqrt(1.0 + m * m)
    kappa = rail_bend * cosine * cosine * cosine
    for i in range(LINE_ITERATIONS):
        z, slope, bend = height_slope_bend(wheel, y)
        y_track, z_track, outline_slope, stretch, rate = outline_jet(place, y, z, slope, bend)
        across = y_track - pair.rail_y - abscissa
        down = z_track + height - z_rail
        residual = across + down * m
        along = stretch * (1.0 + m * outline_slope)
        if not (along > 0.0 and stretch > 0.0):
            return False
        move = -residual / along
        sharp = tolerance
        if i == LINE_ITERATIONS - 1 and sharp < LINE_JOINT:
            sharp = LINE_JOINT
        if fabs(move) < sharp:
            overlap = (down - m * across) * cosine
            if not (fabs(overlap) < FARTHEST and y >= wheel.start and y <= wheel.stop):
                return False
            rise = (outline_slope - m) / (1.0 + m * outline_slope)
            # the angle between both curves changes by the wheel's curvature over its own arc less the rail's
            wheel_cos = 1.0 / sqrt(1.0 + outline_slope * outline_slope)
            wheel_kappa = rate / stretch * wheel_cos * wheel_cos * wheel_cos
            steep = 1.0 + rise * rise
            # from the wheel's point to the rail's normal: over the rail's tangent the overlap is a curve
            rest = -residual * cosine
            turn = wheel_kappa * steep * sqrt(steep) * rest
            meeting.wheel = y + move
            meeting.overlap = overlap + rest * (rise + 0.5 * turn)
            meeting.rise = rise + turn
            meeting.rate = steep * (wheel_kappa * sqrt(steep) - kappa)
            meeting.z = z + slope * move
            meeting.slope = slope + bend * move
            meeting.bend = bend
            meeting.rail_slope = m
            return True
        move = max(min(move, LINE_STEP), -LINE_STEP)
        y += move
        if not (y >= wheel.start and y <= wheel.stop):
            return False
    return False


@seldom
def mean_bend(pair: Pair, frame: Frame, y: float, bend: float):
    """Second derivative of the wheel profile [1/m] at ``y``, averaged over the frame's blur to either side
    where that is set.

    With yaw it is part of the longitudinal curvature; taken at a point, it would jump when a profile's joint
    passes a node.
    """
    blur = frame.blur
    if blur > 0.0:
        wheel = pair.wheel
        low = y - blur
        high = y + blur
        low = max(low, wheel.start)
        high = min(high, wheel.stop)
        z, low_slope = height_slope(wheel, low)
        z, high_slope = height_slope(wheel, high)
        bend = (high_slope - low_slope) / (high - low)
    return bend


@seldom
def penetrated_gap(pair: Pair, frame: Frame, station: float):
    """How much smaller the overlap is at ``station`` [m] than the region's depth, plus the region's own gap
    [m], with its derivatives [-, 1/m]: as ``normal_gap``, for the open frame of a pressed wheel."""
    frame.place.node_count += 1.0
    rail = pair.rail
    way = station - frame.station
    abscissa = rail_abscissa(pair, frame.traces[RAIL].abscissa, way)
    gap = NO_GAP
    rate = 0.0
    bend = 0.0
    if abscissa >= rail.start and abscissa <= rail.stop:
        trace = frame.traces[WHEEL]
        estimate = trace.abscissa + way * trace.rate
        if meet_wheel(pair, frame.place, abscissa, estimate, frame.height, NODE_SHARP):
            meeting = frame.place.meeting
            gap = frame.raised + frame.depth - meeting.overlap
            rate = -meeting.rise
            bend = -meeting.rate
            if fabs(way) > LEAST_WAY:
                trace.rate = (meeting.wheel - trace.abscissa) / way
            trace.abscissa = meeting.wheel
            frame.traces[RAIL].abscissa = abscissa
            frame.station = station
    return gap, rate, bend


def met_curvature(pair: Pair, frame: Frame):
    """The wheel's 1/R_x [1/m] at the point that a separation was last measured to."""
    meeting = frame.place.meeting
    return longitudinal_curvature(
        pair.tables,
        frame.place,
        meeting.wheel,
        meeting.z,
        meeting.slope,
        mean_bend(pair, frame, meeting.wheel, meeting.bend),
    )


@seldom
def limited(step: float, limit: float):
    """``step``, no longer than ``limit`` either way."""
    step = max(min(step, limit), -limit)
    return step


@seldom
def turning_point(
    pair: Pair, place: Place, low: float, high: float, x: float, y: float, height: float, sign: float
):
    """Rail abscissa [m] of the largest overlap (``sign`` = 1) or the smallest (-1) between two rail
    abscissae: Newton's method on its slope, bracketed, from ``x`` and ``y`` on; and whether the slope changes
    its sign there: it may do so a little beyond the bracket.  The rest is the place's ``meeting``.

    Where curvatures jump Newton's method can alternate between two places.  Where a step has not halved the
    slope, the bracket is halved.  After a step of some millimetres the wheel may not be met from where it was
    before; half of the step is tried then.
    """
    meeting = place.meeting
    before = 0.0
    moved_low = False
    moved_high = False
    met = x
    for i in range(DEEP_ITERATIONS):
        following = 0.5 * (x + met)
        if meet_wheel(pair, place, x, y, height, LINE_SHARP):
            y = meeting.wheel
            met = x
            if sign * meeting.rise > 0.0:
                low = x
                moved_low = True
            else:
                high = x
                moved_high = True
            following = 0.5 * (low + high)
            z_rail, slope, rail_bend = height_slope_bend(pair.rail, x)
            stretch = sqrt(1.0 + slope * slope)
            kappa = rail_bend / (stretch * stretch * stretch)
            # with what the rate leaves out: the normals converge into the rail, and meet less of the wheel
            rate = meeting.rate - (meeting.rate + kappa) * kappa * max(meeting.overlap, 0.0)
            if sign * rate < 0.0:
                move = -meeting.rise / (rate * stretch)
                if fabs(move) < DEEP_SHARP:
                    break
                if x + move > low and x + move < high and (i == 0 or fabs(meeting.rise) < 0.5 * before):
                    following = x + move
            if fabs(following - x) < DEEP_SHARP:
                break
            before = fabs(meeting.rise)
        elif fabs(x - met) < DEEP_SHARP:
            return x, False
        x = following
    rise = fabs(meeting.rise)
    return x, rise < ZERO_RISE or (rise < LEVEL_RISE and moved_low and moved_high)
