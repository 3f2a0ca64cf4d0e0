"""What holds over a box of places on the wheel: ranges of its profile and angles, where it lies over the rail, and bounds
of the gap's second derivatives, by arithmetic with intervals.
"""

from math import fabs, sqrt
from typing import Final

from ..elementary.circle import atan, atan2, sine_cosine
from ..layout import EXPONENTS, Pair, Place, SectionBounds, SectionBox, SectionSearch, SectionSpread
from ..search.bounds import node_below
from ..surface.tables import height_slope
from .section_bounds import section_bounds
from .section_surface import section_jet

#: Angles are looked at this much farther [rad]: rounding.
ANGLE_ROUNDING: Final[float] = 1e-9


def scaled(factor: float, low: float, high: float):
    """A factor times an interval."""
    return min(factor * low, factor * high), max(factor * low, factor * high)


def product(low: float, high: float, other_low: float, other_high: float):
    """The product of two intervals."""
    a = low * other_low
    b = low * other_high
    c = high * other_low
    d = high * other_high
    return min(min(a, b), min(c, d)), max(max(a, b), max(c, d))


def square(low: float, high: float):
    """The square of an interval."""
    most = max(low * low, high * high)
    least = 0.0
    if low > 0.0 or high < 0.0:
        least = min(low * low, high * high)
    return least, most


def spread_wheel(pair: Pair, spread: SectionSpread, low: float, high: float):
    """Ranges of the wheel's profile between the abscissae ``low`` and ``high`` [m], which lie within 2^(EXPONENTS - 1)
    cells of its raster."""
    scan = pair.scan
    node = node_below(scan, low)
    exponent = 0
    cells = 1
    while exponent + 1 < EXPONENTS and node + cells < scan.count - 1 and scan.nodes[node + cells].y < high:
        exponent += 1
        cells = 2 * cells
    if node + cells > scan.count - 1:
        node = max(scan.count - 1 - cells, 0)
    steepest = scan.nodes[node].steepest_bends[exponent]
    half = 0.5 * (high - low)
    z, slope = height_slope(pair.wheel, 0.5 * (low + high))
    spread.least_bend = -steepest
    spread.most_bend = scan.nodes[node].most_bends[exponent]
    spread.least_slope = slope - steepest * half
    spread.most_slope = slope + steepest * half
    away = half * max(fabs(spread.least_slope), fabs(spread.most_slope))
    spread.least_radius = pair.radius + z - away
    spread.most_radius = pair.radius + z + away
    spread.out_of_round = False
    spread.least_lead = 0.0
    spread.most_lead = 0.0
    spread.least_lead_cosine = 1.0


def spread_deviation(pair: Pair, search: SectionSearch, box: SectionBox):
    """Widen these ranges by how far a wheel is out of round in a box, and write how fast its radius changes around it."""
    if not pair.out_of_round:
        return
    spread = search.spread
    spread.out_of_round = True
    bounds = search.deviation
    back = search.rotation + box.back
    ahead = search.rotation + box.ahead
    section_bounds(pair.deviation, bounds, back, ahead, box.low, box.high)
    d, d_f, d_y, d_ff, d_fy, d_yy = section_jet(
        pair.deviation, 0.5 * (back + ahead), 0.5 * (box.low + box.high)
    )
    away = 0.5 * (ahead - back) * max(fabs(bounds.least_along), fabs(bounds.most_along))
    away += 0.5 * (box.high - box.low) * max(fabs(bounds.least_across), fabs(bounds.most_across))
    spread.least_radius += d - away
    spread.most_radius += d + away
    spread.least_slope += bounds.least_across
    spread.most_slope += bounds.most_across
    spread.least_bend += bounds.least_bend_across
    spread.most_bend += bounds.most_bend_across
    spread.least_rate = bounds.least_along
    spread.most_rate = bounds.most_along
    spread.least_rate_bend = bounds.least_bend_along
    spread.most_rate_bend = bounds.most_bend_along
    spread.most_rate_twist = max(fabs(bounds.least_twist), fabs(bounds.most_twist))
    low, high = product(
        bounds.least_along, bounds.most_along, 1.0 / spread.most_radius, 1.0 / spread.least_radius
    )
    spread.least_lead = atan(low)
    spread.most_lead = atan(high)
    largest = max(low * low, high * high)
    spread.least_lead_cosine = 1.0 / sqrt(1.0 + largest)


def angles_of_normals(place: Place, spread: SectionSpread, least_lean: float, most_lean: float):
    """The angles [rad] at which the normals of the wheel can have an x component of ``least_lean`` ... ``most_lean``, by
    (A1).

    Where the wheel is not round its normal is that of a round one at the angle less its lead, atan(r_phi / r), with the slope
    times the lead's cosine.
    """
    slope_low, slope_high = product(spread.least_slope, spread.most_slope, spread.least_lead_cosine, 1.0)
    least, most = square(slope_low, slope_high)
    low, high = product(least_lean, most_lean, sqrt(1.0 + least), sqrt(1.0 + most))
    yawed_low, yawed_high = scaled(-place.sin_yaw * place.cos_roll, slope_low, slope_high)
    tilt = place.sin_yaw * place.sin_roll
    size = sqrt(place.cos_yaw * place.cos_yaw + tilt * tilt)
    low = min(max((low + yawed_low) / size, -1.0), 1.0)
    high = min(max((high + yawed_high) / size, -1.0), 1.0)
    away = atan(tilt / place.cos_yaw)
    return (
        atan2(low, sqrt(1.0 - low * low)) - away + spread.least_lead - ANGLE_ROUNDING,
        atan2(high, sqrt(1.0 - high * high)) - away + spread.most_lead + ANGLE_ROUNDING,
    )


def lowest_angle(place: Place, spread: SectionSpread, top: float, best: float, low: float, high: float):
    """The largest absolute angle [rad] at which a gap can be smaller than ``best``, above a rail that is nowhere higher
    than ``top`` [m], for abscissae ``low`` ... ``high``; negative where none is.

    The wheel reaches down to arm sin(roll) + r cos(phi) cos(roll) - height.
    """
    lever = max((place.arm + low) * place.sin_roll, (place.arm + high) * place.sin_roll)
    cosine = (top - best + place.height - lever) / (spread.most_radius * place.cos_roll)
    if cosine > 1.0:
        return -1.0
    cosine = max(cosine, 0.0)
    return atan2(sqrt(1.0 - cosine * cosine), cosine) + ANGLE_ROUNDING


def spread_angles(spread: SectionSpread, back: float, ahead: float):
    """Ranges of sine and cosine of angles between ``back`` and ``ahead`` [rad], which are no right angles."""
    sine, cosine = sine_cosine(back)
    other_sine, other_cosine = sine_cosine(ahead)
    spread.least_sine = sine
    spread.most_sine = other_sine
    spread.least_cosine = min(cosine, other_cosine)
    spread.most_cosine = max(cosine, other_cosine)
    if back < 0.0 and ahead > 0.0:
        spread.most_cosine = 1.0


def spread_reach(place: Place, spread: SectionSpread, half: float, angle: float):
    """How far the places of a box lie from its middle at most, in x and y [m], for half-widths of ``half`` [m] and
    ``angle`` [rad]."""
    slope = max(fabs(spread.least_slope), fabs(spread.most_slope))
    sine = max(fabs(spread.least_sine), fabs(spread.most_sine))
    yaw = fabs(place.sin_yaw)
    roll = fabs(place.sin_roll)
    turn = spread.most_radius * angle
    if spread.out_of_round:
        turn += max(fabs(spread.least_rate), fabs(spread.most_rate)) * angle
    return (
        half * (slope * sine + yaw * (1.0 + roll * slope)) + turn * (1.0 + yaw * roll * sine),
        half * (yaw * slope * sine + 1.0 + roll * slope) + turn * (yaw + roll * sine),
    )


def form(bounds: SectionBounds, x_low: float, x_high: float, y_low: float, y_high: float):
    """Range of the quadratic form of the rail's second derivatives for tangents in these ranges."""
    least, most = square(x_low, x_high)
    along, most_along = product(bounds.least_bend_along, bounds.most_bend_along, least, most)
    least, most = square(y_low, y_high)
    across, most_across = product(bounds.least_bend_across, bounds.most_bend_across, least, most)
    least, most = product(x_low, x_high, y_low, y_high)
    twist, most_twist = product(bounds.least_twist, bounds.most_twist, least, most)
    return along + 2.0 * twist + across, most_along + 2.0 * most_twist + most_across


def spread_slopes(place: Place, spread: SectionSpread, bounds: SectionBounds):
    """Ranges of the gap's first derivatives over a box, from those of wheel and rail."""
    # components of G: ahead, to the side, down
    low, high = scaled(place.cos_yaw, bounds.least_along, bounds.most_along)
    least, most = scaled(place.sin_yaw, bounds.least_across, bounds.most_across)
    g1_low = low + least
    g1_high = high + most
    low, high = scaled(-place.sin_yaw, bounds.least_along, bounds.most_along)
    least, most = scaled(place.cos_yaw, bounds.least_across, bounds.most_across)
    level = low + least
    most_level = high + most
    g2_low, g2_high = scaled(place.cos_roll, level, most_level)
    low, high = scaled(-place.sin_roll, level, most_level)
    g3_low = low - place.cos_roll
    g3_high = high - place.cos_roll
    low, high = product(g1_low, g1_high, spread.least_sine, spread.most_sine)
    least, most = product(g3_low, g3_high, spread.least_cosine, spread.most_cosine)
    spread.least_outward = low + least
    spread.most_outward = high + most
    low, high = product(g1_low, g1_high, spread.least_cosine, spread.most_cosine)
    least, most = product(g3_low, g3_high, spread.least_sine, spread.most_sine)
    spread.least_aside = low - most
    spread.most_aside = high - least
    low, high = product(spread.least_slope, spread.most_slope, spread.least_outward, spread.most_outward)
    spread.least_rise = low + g2_low - place.sin_roll
    spread.most_rise = high + g2_high - place.sin_roll
    spread.least_turn, spread.most_turn = product(
        spread.least_radius, spread.most_radius, spread.least_aside, spread.most_aside
    )
    if spread.out_of_round:
        low, high = product(spread.least_rate, spread.most_rate, spread.least_outward, spread.most_outward)
        spread.least_turn += low
        spread.most_turn += high


def spread_bends(place: Place, spread: SectionSpread, bounds: SectionBounds):
    """Bounds of the gap's second derivatives over a box, from those of wheel and rail, where its first ones are known."""
    # tangents by y and by the angle
    low, high = product(spread.least_slope, spread.most_slope, spread.least_sine, spread.most_sine)
    least, most = product(spread.least_slope, spread.most_slope, spread.least_cosine, spread.most_cosine)
    least, most = scaled(-place.sin_roll, least, most)
    xy_low, xy_high, yy_low, yy_high = tangent(
        place, low, high, place.cos_roll + least, place.cos_roll + most
    )
    low, high = product(spread.least_radius, spread.most_radius, spread.least_cosine, spread.most_cosine)
    least, most = product(spread.least_radius, spread.most_radius, spread.least_sine, spread.most_sine)
    least, most = scaled(place.sin_roll, least, most)
    if spread.out_of_round:
        first, last = product(spread.least_rate, spread.most_rate, spread.least_sine, spread.most_sine)
        low += first
        high += last
        first, last = product(spread.least_rate, spread.most_rate, spread.least_cosine, spread.most_cosine)
        first, last = scaled(-place.sin_roll, first, last)
        least += first
        most += last
    xf_low, xf_high, yf_low, yf_high = tangent(place, low, high, least, most)
    low, high = product(spread.least_bend, spread.most_bend, spread.least_outward, spread.most_outward)
    least, most = form(bounds, xy_low, xy_high, yy_low, yy_high)
    spread.bend_across = least + low
    spread.most_across = max(fabs(least + low), fabs(most + high))
    low, high = product(spread.least_radius, spread.most_radius, spread.least_outward, spread.most_outward)
    least, most = form(bounds, xf_low, xf_high, yf_low, yf_high)
    spread.bend_around = least - high
    spread.most_around = max(fabs(least - high), fabs(most - low))
    spread.twist = mixed(bounds, xy_low, xy_high, xf_low, xf_high, yy_low, yy_high, yf_low, yf_high)
    low, high = product(spread.least_slope, spread.most_slope, spread.least_aside, spread.most_aside)
    spread.twist += max(fabs(low), fabs(high))
    if spread.out_of_round:
        add_deviation(spread)


def add_deviation(spread: SectionSpread):
    """Add what a wheel that is not round has in these bounds: (r_phiphi) O + 2 r_phi A, and r_phiy O."""
    low, high = product(
        spread.least_rate_bend, spread.most_rate_bend, spread.least_outward, spread.most_outward
    )
    least, most = product(spread.least_rate, spread.most_rate, spread.least_aside, spread.most_aside)
    low += 2.0 * least
    high += 2.0 * most
    spread.bend_around += low
    spread.most_around += max(fabs(low), fabs(high))
    spread.twist += spread.most_rate_twist * max(fabs(spread.least_outward), fabs(spread.most_outward))


def tangent(place: Place, low: float, high: float, level_low: float, level_high: float):
    """x and y, as intervals, of a vector with these parts along the wheelset and to its side."""
    ahead, most_ahead = scaled(place.cos_yaw, low, high)
    back, most_back = scaled(-place.sin_yaw, level_low, level_high)
    side, most_side = scaled(place.sin_yaw, low, high)
    level, most_level = scaled(place.cos_yaw, level_low, level_high)
    return ahead + back, most_ahead + most_back, side + level, most_side + most_level


def mixed(
    bounds: SectionBounds,
    xy_low: float,
    xy_high: float,
    xf_low: float,
    xf_high: float,
    yy_low: float,
    yy_high: float,
    yf_low: float,
    yf_high: float,
):
    """The largest absolute value of the form of the rail's second derivatives between both tangents.

    Many arguments because two tangents with two components are eight ends of intervals.
    """
    least, most = product(xy_low, xy_high, xf_low, xf_high)
    low, high = product(bounds.least_bend_along, bounds.most_bend_along, least, most)
    largest = max(fabs(low), fabs(high))
    least, most = product(xy_low, xy_high, yf_low, yf_high)
    first, last = product(yy_low, yy_high, xf_low, xf_high)
    low, high = product(bounds.least_twist, bounds.most_twist, least + first, most + last)
    largest += max(fabs(low), fabs(high))
    least, most = product(yy_low, yy_high, yf_low, yf_high)
    low, high = product(bounds.least_bend_across, bounds.most_bend_across, least, most)
    return largest + max(fabs(low), fabs(high))
