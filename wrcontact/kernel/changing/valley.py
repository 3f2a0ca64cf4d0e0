"""The constant rail that a changing one is for a wheel at a pose, at the lines of the changing one.

In the frame along the ruling direction a line of equal share k crosses, somewhere along it, the places at which the wheel
is nearest along x: there both surfaces have the same slope along x.  With the heights W of the wheel and R of the rail
there, over x and y of the frame, and the wheel's outline O(y), the constant rail has there

    z = O + R - W,  z' = O' + R_y - W_y,
    z'' = R_yy + [c^2 R_xx / k + 2 c R_xy - R_xy^2] / (R_xx + k),   c = k x_O',

with the curvature k = -W_xx of the wheel along x and the rate x_O' of its outline; by the envelope theorem, and for
z'' with the wheel's second derivatives at its outline.  A rail that is the same along the frame has R_xx = R_xy = 0: then
the nearest places are those of the outline, and the rail is its own section.
"""

from math import fabs, sqrt
from typing import Final

from ..elementary.circle import atan2, sine_cosine
from ..layout import Pair, Place, SectionFrame, Sections, SectionTouch, ValleyNode
from ..sections.section_surface import break_below, clamped_position, cubic_jet, line_below
from ..surface.curvature import effective_curvature
from ..surface.locus import around_wheel, outline_jet
from ..sections.wheel_radius import radius_jet, wheel_bends
from ..surface.tables import height_slope, height_slope_bend
from .section_frame import into_frame

#: Places along the line and on the wheel are found to this [m, rad].
LINE_SHARP: Final[float] = 1e-12
WHEEL_SHARP: Final[float] = 1e-13
LINE_ITERATIONS: Final[int] = 60
#: From this step on, every other one halves the part of the line that holds the place, as at the edge of a flat; and the length of
#: a part whose ends are not both known [m].
SLOW: Final[int] = 8
OPEN: Final[float] = 1e6
WHEEL_ITERATIONS: Final[int] = 20
#: Longest move along the line in one step [m].
LONGEST_MOVE: Final[float] = 0.02
#: Least distance of two nodes [m].
APART: Final[float] = 1e-7
#: Least share of the outline's way across in that of the wheel's abscissa [-]: farther on it folds back.
LEAST_STRETCH: Final[float] = 0.02
#: Least share of the wheel's curvature that is left to the gap along the frame [-]; less is a second contact along it.
LEAST_LEFT: Final[float] = 0.05


def point_on_wheel(pair: Pair, place: Place, y: float, angle: float):
    """Place x and y [m] of the placed wheel at ``y`` [m] and ``angle`` [rad], their derivatives by both, its height [m], and
    its slopes along x and y [-]; x is that from the wheelset's centre."""
    sine, cosine = sine_cosine(angle)
    r, r_y, r_yy, r_f, r_fy, r_ff = radius_jet(pair, place, pair.sections.frame.turn, y, angle)
    arm = place.arm + y
    lead = r_f / r
    ahead = sine - lead * cosine
    down = cosine + lead * sine
    ahead_f = r_f * sine + r * cosine
    level = arm * place.cos_roll - r * cosine * place.sin_roll
    level_y = place.cos_roll - place.sin_roll * r_y * cosine
    level_f = place.sin_roll * (r * sine - r_f * cosine)
    beside = -r_y * place.cos_roll - down * place.sin_roll
    normal_z = down * place.cos_roll - r_y * place.sin_roll
    normal_x = place.cos_yaw * ahead - place.sin_yaw * beside
    normal_y = place.sin_yaw * ahead + place.cos_yaw * beside
    return (
        place.cos_yaw * r * sine - place.sin_yaw * level,
        place.shift + place.sin_yaw * r * sine + place.cos_yaw * level,
        place.cos_yaw * r_y * sine - place.sin_yaw * level_y,
        place.sin_yaw * r_y * sine + place.cos_yaw * level_y,
        place.cos_yaw * ahead_f - place.sin_yaw * level_f,
        place.sin_yaw * ahead_f + place.cos_yaw * level_f,
        arm * place.sin_roll + r * cosine * place.cos_roll - place.height,
        normal_x,
        normal_y,
        normal_z,
    )


def wheel_over(pair: Pair, place: Place, x: float, across: float, y: float, angle: float):
    """The wheel's abscissa [m] and angle [rad] over a place x, y of the frame, from ``y`` and ``angle`` on, its height there
    [m] and slopes along x and y [-]; and whether it is found."""
    height = 0.0
    along = 0.0
    aside = 0.0
    found = False
    for i in range(WHEEL_ITERATIONS):
        at_x, at_y, x_y, y_y, x_f, y_f, height, normal_x, normal_y, normal_z = point_on_wheel(
            pair, place, y, angle
        )
        determinant = x_y * y_f - y_y * x_f
        if not (normal_z > 0.0 and determinant * determinant > 0.0):
            return y, angle, height, along, aside, False
        along = -normal_x / normal_z
        aside = -normal_y / normal_z
        left_x = x - at_x
        left_y = across - at_y
        move = (left_x * y_f - left_y * x_f) / determinant
        turn = (x_y * left_y - y_y * left_x) / determinant
        # the rest of the height by its slopes
        height += along * left_x + aside * left_y
        y += move
        angle += turn
        if not (y >= pair.wheel.start and y <= pair.wheel.stop):
            return y, angle, height, along, aside, False
        if fabs(move) < WHEEL_SHARP and fabs(turn) < WHEEL_SHARP:
            found = True
            break
    return y, angle, height, along, aside, found


def outline_at(pair: Pair, place: Place, across: float, y: float):
    """The abscissa [m] at which the outline has the place ``across`` [m], from ``y`` on; and whether it is found."""
    found = False
    for i in range(WHEEL_ITERATIONS):
        z, slope, bend = height_slope_bend(pair.wheel, y)
        y_track, z_track, outline_slope, stretch, rate = outline_jet(place, y, z, slope, bend)
        if not stretch > LEAST_STRETCH:
            return y, False
        move = (across - y_track) / stretch
        y += move
        if not (y >= pair.wheel.start and y <= pair.wheel.stop):
            return y, False
        if fabs(move) < WHEEL_SHARP:
            found = True
            break
    return y, found


def curvature_of_outline(pair: Pair, place: Place, y: float):
    """The wheel's curvature -W_xx along the frame [1/m] at its outline, and the rate of the outline's x over its y [-]."""
    z, slope, bend = height_slope_bend(pair.wheel, y)
    y_track, z_track, outline_slope, stretch, rate = outline_jet(place, y, z, slope, bend)
    curvature = effective_curvature(place, z, slope, bend) * sqrt(1.0 + outline_slope * outline_slope)
    moved = 0.0
    if place.yawed:
        sine, cosine = around_wheel(place, slope)
        w = place.w_per_slope * slope
        root = sqrt(max(1.0 - w * w, 1e-12))
        turn = -place.w_per_slope * bend / root
        r = place.radius + z
        level = place.cos_roll - place.sin_roll * (slope * cosine - r * sine * turn)
        moved = (place.cos_yaw * (slope * sine + r * cosine * turn) - place.sin_yaw * level) / stretch
    return curvature, moved


def line_point(pair: Pair, frame: SectionFrame, position: float, line: int, u: float):
    """A line of the changing rail at the position ``u`` [m], in the frame: x, y, z [m]; the rail's slopes along the frame's x
    and y there [-], and by how much x grows with u [-]."""
    sections = pair.sections
    at = clamped_position(sections, u)
    interval = break_below(sections.breaks, sections.interval_count, at)
    knot = sections.knots[interval * sections.knot_count + line]
    t = at - sections.breaks[interval]
    place, place_u, place_uu = cubic_jet(knot.place, t)
    height, height_u, height_uu = cubic_jet(knot.height, t)
    slope, slope_u, slope_uu = cubic_jet(knot.slope, t)
    if at != u:
        place_u = 0.0
        height_u = 0.0
    z_u = height_u - slope * place_u
    x, y, z = into_frame(
        frame, u - position - frame.x, pair.sections.lateral + place - frame.y, height - frame.z
    )
    normal_x, normal_y, normal_z = into_frame(frame, z_u, slope, -1.0)
    x_u, y_u, rise = into_frame(frame, 1.0, place_u, height_u)
    return x, y, z, -normal_x / normal_z, -normal_y / normal_z, x_u


def line_rate(sections: Sections, line: int, u: float):
    """How the lateral place of a line follows the position along the track at ``u`` [m], [-]."""
    at = clamped_position(sections, u)
    interval = break_below(sections.breaks, sections.interval_count, at)
    knot = sections.knots[interval * sections.knot_count + line]
    place, place_u, place_uu = cubic_jet(knot.place, at - sections.breaks[interval])
    if at != u:
        place_u = 0.0
    return place_u


def line_bends(pair: Pair, frame: SectionFrame, line: int, u: float, behind: bool):
    """The rail's second derivatives along the frame's x, x and y, and y [1/m], at a line, before or ``behind`` it."""
    sections = pair.sections
    at = clamped_position(sections, u)
    interval = break_below(sections.breaks, sections.interval_count, at)
    knot = sections.knots[interval * sections.knot_count + line]
    t = at - sections.breaks[interval]
    place, place_u, place_uu = cubic_jet(knot.place, t)
    height, height_u, height_uu = cubic_jet(knot.height, t)
    slope, slope_u, slope_uu = cubic_jet(knot.slope, t)
    z_yy, bend_u, bend_uu = cubic_jet(knot.before, t)
    if behind:
        z_yy, bend_u, bend_uu = cubic_jet(knot.behind, t)
    if at != u:
        place_u = 0.0
        place_uu = 0.0
        height_u = 0.0
        height_uu = 0.0
        slope_u = 0.0
    z_u = height_u - slope * place_u
    z_uy = slope_u - z_yy * place_u
    z_uu = height_uu - 2.0 * z_uy * place_u - z_yy * place_u * place_u - slope * place_uu
    normal_x, normal_y, normal_z = into_frame(frame, z_u, slope, -1.0)
    rise_x = -normal_x / normal_z
    rise_y = -normal_y / normal_z
    # tangents along the frame's x and y, level parts in the track
    a_u = frame.along[0] + rise_x * frame.down[0]
    a_y = frame.along[1] + rise_x * frame.down[1]
    b_u = frame.aside[0] + rise_y * frame.down[0]
    b_y = frame.aside[1] + rise_y * frame.down[1]
    return (
        -(z_uu * a_u * a_u + 2.0 * z_uy * a_u * a_y + z_yy * a_y * a_y) / normal_z,
        -(z_uu * a_u * b_u + z_uy * (a_u * b_y + a_y * b_u) + z_yy * a_y * b_y) / normal_z,
        -(z_uu * b_u * b_u + 2.0 * z_uy * b_u * b_y + z_yy * b_y * b_y) / normal_z,
    )


def constant_bend(along: float, twist: float, across: float, curvature: float, rate: float):
    """z'' of the constant rail [1/m], from the rail's second derivatives along x, x and y, and y, the wheel's ``curvature``
    and the ``rate`` of its outline."""
    c = curvature * rate
    return across + (c * c * along / curvature + 2.0 * c * twist - twist * twist) / (along + curvature)


def deviation_bends(pair: Pair, place: Place, y: float, angle: float):
    """What a wheel that is not round has beyond a round one, at the abscissa ``y`` [m] and the ``angle`` [rad], in the second
    derivatives of its height along the frame's x, x and y, and y [1/m]: the rail then has that much less."""
    if not pair.out_of_round:
        return 0.0, 0.0, 0.0
    sine, cosine = sine_cosine(angle)
    r, r_y, r_yy, r_f, r_fy, r_ff = radius_jet(pair, place, pair.sections.frame.turn, y, angle)
    along, twist, bend = wheel_bends(place, sine, cosine, r, r_y, r_yy, r_f, r_fy, r_ff)
    z, slope, slope_rate = height_slope_bend(pair.wheel, y)
    other, other_twist, other_bend = wheel_bends(
        place, sine, cosine, place.radius + z, slope, slope_rate, 0.0, 0.0, 0.0
    )
    return along - other, twist - other_twist, bend - other_bend


def follow_line(
    pair: Pair, place: Place, position: float, line: int, u: float, y: float, angle: float, node: ValleyNode
):
    """Write the node of a line, sought from the position ``u``, the wheel abscissa ``y`` [m] and the ``angle`` [rad] on;
    whether it is found, and these three where it is.

    Along the line the slope of the gap along x, which rises where there is one valley, is brought to zero by secants, the first one
    with the wheel's curvature, between places where it has both signs.

    Long because what a node holds follows from all the numbers of its place.
    """
    frame = pair.sections.frame
    before = 0.0
    miss_before = 0.0
    x = 0.0
    across = 0.0
    z = 0.0
    rise = 0.0
    lean = 0.0
    height = 0.0
    aside = 0.0
    curvature, rate = curvature_of_outline(pair, place, y)
    low = -OPEN
    high = OPEN
    found = False
    for i in range(LINE_ITERATIONS):
        x, across, z, slope, rise, x_u = line_point(pair, frame, position, line, u)
        y, angle, height, along, aside, over = wheel_over(pair, place, x - frame.centre[0], across, y, angle)
        if not over:
            return False, u, y, angle
        lean = slope
        miss = slope - along
        gain = curvature * x_u
        if i > 0 and u != before:
            secant = (miss - miss_before) / (u - before)
            if secant > LEAST_LEFT * gain:
                gain = secant
        if miss > 0.0:
            high = min(high, u)
        else:
            low = max(low, u)
        move = max(min(-miss / gain, LONGEST_MOVE), -LONGEST_MOVE)
        if high - low < OPEN and (not (u + move >= low and u + move <= high) or (i >= SLOW and i % 2 == 0)):
            move = 0.5 * (low + high) - u
        if fabs(move) < LINE_SHARP:
            found = True
            break
        before = u
        miss_before = miss
        u += move
    if not found:
        return False, u, y, angle
    outline, over = outline_at(pair, place, across, y)
    if not over:
        return False, u, y, angle
    curvature, rate = curvature_of_outline(pair, place, outline)
    more_along, more_twist, more_bend = deviation_bends(pair, place, y, angle)
    along, twist, bend = line_bends(pair, frame, line, u, False)
    along -= more_along
    twist -= more_twist
    node.before = constant_bend(along, twist, bend - more_bend, curvature, rate)
    along, twist, bend = line_bends(pair, frame, line, u, True)
    along -= more_along
    twist -= more_twist
    node.behind = constant_bend(along, twist, bend - more_bend, curvature, rate)
    if not along > (LEAST_LEFT - 1.0) * curvature:
        return False, u, y, angle
    wheel_z, wheel_slope, wheel_bend = height_slope_bend(pair.wheel, outline)
    y_track, z_track, outline_slope, stretch, slope_rate = outline_jet(
        place, outline, wheel_z, wheel_slope, wheel_bend
    )
    sine, cosine = around_wheel(place, wheel_slope)
    r = place.radius + wheel_z
    level = (place.arm + outline) * place.cos_roll - r * cosine * place.sin_roll
    node.y = across
    node.gap = z - height
    node.z = z + (z_track - height)
    node.slope = rise + (outline_slope - aside)
    node.wheel = outline
    node.move = x - frame.centre[0] - (place.cos_yaw * r * sine - place.sin_yaw * level)
    node.lift = height - z_track
    node.rise = lean
    node.bend = along / sqrt(1.0 + rise * rise)
    node.rate = line_rate(pair.sections, line, u)
    oblique = twist * twist / (along + curvature)
    node.skew = oblique / (max(node.behind - slope_rate / stretch, 0.0) + oblique + curvature)
    node.bridge = False
    return True, u, y, angle
