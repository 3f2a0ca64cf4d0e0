"""Tractions of a strip from its leading edge to its trailing one.

In the slip zone the traction is the bound; two marches tell its direction.  Both lose traction to the slip,
over steps D = x_{q-1} - x_q, and are cut to the bound g = m sqrt(a^2 - x^2):

    p_A <- p_A - D (w_x i1, w_y i2 + phi x_m i3)   from zero at the leading edge,                (M1)
    p_B <- p_B - D i_c (w_x, w_y + phi x_m)        from the edge of the stick zone,              (M2)
    i1 = (pi/2) K1 sum(a h)/sum(a^2 h),  i2 the same with K2,
    i3 = (3 pi/4) K3 sum(a^2 h)/sum(a^3 h),   s = 3 pi a phi / 32,
    i_c = (w_x^2 i1 + w_y^2 i2 + s^2 i3) / (w_x^2 + w_y^2 + s^2)                                  (M3)

x_m = x_q + L D.  A describes long patches, B has the direction of the rigid slip where that is large.  With
t = 2 sqrt(w_x^2 i1^2 + w_y^2 i2^2 + s^2 i3^2)/m, how often the creepage fills the bound, A becomes B:

    i_j <- i_c + (i_j - i_c) / (1 + (t/6)^2),   L = (0.4 + 0.1 r/(r + 3)) / (1 + (t'/20)^2)       (M4)

with t' = t for the new i_j.  The direction is that of c = (1 - W) p_A + W p_B, W = 0.65/(1 + (r/1.2)^4),

    n = c g / sqrt(|c|^2 + 0.05^2 (g^2 - |c|^2))                                                 (M5)

Where the stick zone (stick_zone.py) has the weight c < 1, the rest of the traction is that of a strip which
slips all over.  The first point behind the stick zone takes over in proportion to the way from its edge.
"""

from math import pi, sqrt
from typing import Final

from ..layout import POINT_LIMIT, RollingMarch, RollingTable
from .tractions import cut_to

#: Where a step's spin is taken, in short patches, and how much later in long ones; eq. (M4).
LAG: Final[float] = 0.4
LONG_LAG: Final[float] = 0.1
LAG_RATIO: Final[float] = 3.0
LAG_FILLS: Final[float] = 20.0
#: Fills of the bound at which march A is half way to B; eq. (M4).
FILLS: Final[float] = 6.0
#: W in short patches, and the a/b at which it is half of that; eq. (M5).
SHARE: Final[float] = 0.65
SHARE_RATIO: Final[float] = 1.2
#: Directions of tractions below this share of the bound fade; eq. (M5).
SOFT: Final[float] = 0.05
NOTHING: Final[float] = 1e-300


def set_pushes(march: RollingMarch, plane: float, spinning: float, ratio: float):
    """What both marches lose per way, eqs. (M1) to (M4); ``plane`` = i1/K1 = i2/K2 and ``spinning`` = i3/K3
    [1/m] of the patch, ``ratio`` its a/b."""
    i1 = march.along * plane
    i2 = march.across * plane
    i3 = march.turning * spinning
    s = 3.0 * pi / 32.0 * march.half_length * march.spin
    x = march.slip * march.slip
    y = march.lateral * march.lateral
    z = s * s
    centre = (x * i1 + y * i2 + z * i3 + NOTHING * i1) / (x + y + z + NOTHING)
    fills = x * i1 * i1 + y * i2 * i2 + z * i3 * i3
    scale = 4.0 / (march.rate * march.rate)
    near = 1.0 / (1.0 + scale * fills / (FILLS * FILLS))
    i1 = centre + (i1 - centre) * near
    i2 = centre + (i2 - centre) * near
    i3 = centre + (i3 - centre) * near
    fills = x * i1 * i1 + y * i2 * i2 + z * i3 * i3
    lag = LAG + LONG_LAG * ratio / (ratio + LAG_RATIO)
    march.lag = lag / (1.0 + scale * fills / (LAG_FILLS * LAG_FILLS))
    march.push_x[0] = march.slip * i1
    march.push_y[0] = march.lateral * i2
    march.push_turn[0] = march.spin * i3
    march.push_x[1] = march.slip * centre
    march.push_y[1] = march.lateral * centre
    march.push_turn[1] = march.spin * centre
    square = ratio / SHARE_RATIO * (ratio / SHARE_RATIO)
    march.share = SHARE / (1.0 + square * square)
    return 0


def march_strip(table: RollingTable, march: RollingMarch):
    """Sums of the tractions over the points of a strip, and the largest of them."""
    march.x = march.half_length
    march.first_x = 0.0
    march.first_y = 0.0
    march.second_x = 0.0
    march.second_y = 0.0
    march.sum_x = 0.0
    march.sum_y = 0.0
    march.sum_moment = 0.0
    first = 0
    if march.weight > 0.0:
        if march.weight < 1.0 or march.twist * march.twist > 1.0:
            first = march_stick(table, march)
        else:
            first = march_held(table, march)
        if first < POINT_LIMIT:
            cross_edge(table, march, first)
            first += 1
    march_slip(table, march, first)
    return 0


def stepped(march: RollingMarch, index: int, p_x: float, p_y: float, x: float, step: float, bound: float):
    """The traction of march ``index`` at ``x``, a ``step`` further, eq. (M1) or (M2)."""
    across = march.push_y[index] + march.push_turn[index] * (x + march.lag * step)
    return cut_to(p_x - step * march.push_x[index], p_y - step * across, bound)


def step_first(march: RollingMarch, x: float, step: float, bound: float):
    """Let the first march come to ``x``, a ``step`` further."""
    p_x, p_y = stepped(march, 0, march.first_x, march.first_y, x, step, bound)
    march.first_x = p_x
    march.first_y = p_y
    return 0


def step_second(march: RollingMarch, from_x: float, from_y: float, x: float, step: float, bound: float):
    """Let the second march come to ``x``, a ``step`` further, from this traction."""
    p_x, p_y = stepped(march, 1, from_x, from_y, x, step, bound)
    march.second_x = p_x
    march.second_y = p_y
    return 0


def slip_traction(march: RollingMarch, bound: float):
    """The traction of eq. (M5)."""
    along = march.first_x + march.share * (march.second_x - march.first_x)
    across = march.first_y + march.share * (march.second_y - march.first_y)
    square = along * along + across * across
    scale = bound / sqrt(square + SOFT * SOFT * (bound * bound - square) + NOTHING)
    return along * scale, across * scale


def add_point(march: RollingMarch, x: float, weight: float, p_x: float, p_y: float):
    """Add the traction of a point to the sums."""
    march.sum_x += weight * p_x
    march.sum_y += weight * p_y
    march.sum_moment += weight * x * p_y
    march.x = x
    return 0


def note_largest(march: RollingMarch, p_x: float, p_y: float):
    """Keep the largest traction."""
    square = p_x * p_x + p_y * p_y
    if square > march.largest:
        march.largest = square
    return 0


def march_held(table: RollingTable, march: RollingMarch):
    """Add the points of a stick zone that counts as a whole and stays within the bound, without the second
    root of eq. (Z1); the first point behind."""
    a = march.half_length
    top = march.rate * a
    lag = march.lag
    before = march.x
    first_x = 0.0
    first_y = 0.0
    sum_x = 0.0
    sum_moment = 0.0
    q = 0
    while q < POINT_LIMIT and a * table.cosines[q] >= march.edge:
        x = a * table.cosines[q]
        bound = top * table.sines[q]
        step = before - x
        before = x
        first_x, first_y = cut_to(first_x - step * march.push_x[0],
                                  first_y - step * (march.push_y[0] + march.push_turn[0] * (x + lag * step)),
                                  bound)
        sum_x += table.sines[q] * bound
        sum_moment += table.sines[q] * bound * x
        q += 1
    march.x = before
    march.first_x = first_x
    march.first_y = first_y
    march.sum_x = march.stick_x * sum_x
    march.sum_y = march.stick_y * sum_x
    march.sum_moment = march.stick_y * sum_moment
    return q


def march_stick(table: RollingTable, march: RollingMarch):
    """Add the points of the stick zone, without the second root of eq. (Z1) but for what cuts it to the
    bound; the first point behind."""
    a = march.half_length
    weight = march.weight
    q = 0
    while q < POINT_LIMIT and a * table.cosines[q] >= march.edge:
        x = a * table.cosines[q]
        step = march.x - x
        bound = march.rate * a * table.sines[q]
        step_first(march, x, step, bound)
        p_x = march.stick_x * bound
        p_y = march.stick_y * bound
        if march.twist * march.twist > 1.0:
            over_x, over_y = beyond_bound(march, x, bound)
            p_x += over_x
            p_y += over_y
        if weight < 1.0:
            step_second(march, march.second_x, march.second_y, x, step, bound)
            slip_x, slip_y = slip_traction(march, bound)
            note_largest(march, (1.0 - weight) * slip_x, (1.0 - weight) * slip_y)
            p_x = slip_x + weight * (p_x - slip_x)
            p_y = slip_y + weight * (p_y - slip_y)
        add_point(march, x, table.sines[q], p_x, p_y)
        q += 1
    return q


def beyond_bound(march: RollingMarch, x: float, bound: float):
    """What eq. (Z1) has to be changed by to stay within the bound."""
    reach = march.half_length - march.depth
    inner = reach * reach - (x - march.depth) * (x - march.depth)
    change_x = 0.0
    change_y = 0.0
    if inner > 0.0:
        root = march.rate * sqrt(inner)
        p_x = march.stick_x * (bound - root)
        p_y = march.stick_y * (bound - root) + march.twist * root
        cut_x, cut_y = cut_to(p_x, p_y, bound)
        change_x = cut_x - p_x
        change_y = cut_y - p_y
    return change_x, change_y


def cross_edge(table: RollingTable, march: RollingMarch, q: int):
    """Add point ``q``, the first one behind the stick zone, and let the second march begin at its edge."""
    a = march.half_length
    x = a * table.cosines[q]
    step = march.x - x
    bound = march.rate * a * table.sines[q]
    weight = march.weight
    step_first(march, x, step, bound)
    edge_bound = march.rate * sqrt_of(a * a - march.edge * march.edge)
    start_x = weight * march.stick_x * edge_bound
    start_y = weight * march.stick_y * edge_bound
    near_x = weight * march.stick_x * bound
    near_y = weight * march.stick_y * bound
    if weight < 1.0:
        second_x = march.second_x
        second_y = march.second_y
        step_second(march, second_x, second_y, x, step, bound)
        slip_x, slip_y = slip_traction(march, bound)
        near_x += (1.0 - weight) * slip_x
        near_y += (1.0 - weight) * slip_y
        to_x, to_y = stepped(march, 1, second_x, second_y, march.edge, march.x - march.edge, edge_bound)
        start_x += (1.0 - weight) * to_x
        start_y += (1.0 - weight) * to_y
    note_largest(march, start_x, start_y)
    step_second(march, start_x, start_y, x, march.edge - x, bound)
    p_x, p_y = slip_traction(march, bound)
    share = (march.edge - x) / step
    p_x = near_x + share * (p_x - near_x)
    p_y = near_y + share * (p_y - near_y)
    note_largest(march, p_x, p_y)
    add_point(march, x, table.sines[q], p_x, p_y)
    return 0


def sqrt_of(value: float):
    """Square root, of nothing below zero."""
    root = 0.0
    if value > 0.0:
        root = sqrt(value)
    return root


def march_slip(table: RollingTable, march: RollingMarch, first: int):
    """Add the points of the slip zone from ``first`` on: eqs. (M1), (M2), (M5), most of all time that the
    model takes, so that nothing is kept in the record meanwhile."""
    a = march.half_length
    top = march.rate * a
    lag = march.lag
    share = march.share
    before = march.x
    first_x = march.first_x
    first_y = march.first_y
    second_x = march.second_x
    second_y = march.second_y
    sum_x = march.sum_x
    sum_y = march.sum_y
    sum_moment = march.sum_moment
    largest = march.largest
    for q in range(first, POINT_LIMIT):
        x = a * table.cosines[q]
        weight = table.sines[q]
        bound = top * weight
        step = before - x
        before = x
        at = x + lag * step
        first_x, first_y = cut_to(first_x - step * march.push_x[0],
                                  first_y - step * (march.push_y[0] + march.push_turn[0] * at), bound)
        second_x, second_y = cut_to(second_x - step * march.push_x[1],
                                    second_y - step * (march.push_y[1] + march.push_turn[1] * at), bound)
        along = first_x + share * (second_x - first_x)
        across = first_y + share * (second_y - first_y)
        square = along * along + across * across
        scale = bound / sqrt(square + SOFT * SOFT * (bound * bound - square) + NOTHING)
        along *= scale
        across *= scale
        square = along * along + across * across
        if square > largest:
            largest = square
        sum_x += weight * along
        sum_y += weight * across
        sum_moment += weight * x * across
    march.sum_x = sum_x
    march.sum_y = sum_y
    march.sum_moment = sum_moment
    march.largest = largest
    return 0
