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

Where the stick zone (coupled_strips.py) has the weight c < 1, the rest of the traction is that of a strip
which slips all over.  The first point behind the stick zone takes over in proportion to the way from its
edge.

All strips march side by side, with places over a and tractions over m a, so that bounds and steps are those
of all of them, and compilers do several strips at once.
"""

from math import pi, sqrt
from typing import Final

from ..layout import (
    POINT_LIMIT,
    ROLLING_STRIP_LIMIT,
    FallingFriction,
    RollingMarch,
    RollingMarches,
    RollingTable,
    clear,
)
from .falling import find_shares, restore_slips, weigh_slips
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
#: Stick zones of a smaller weight leave the second march more and more as it is without them.
FAINT: Final[float] = 1e-3
#: The sum of the squares of all sines.
WHOLE: Final[float] = 0.5 * float(POINT_LIMIT + 1)
#: In place of no slip at all.
NOTHING: Final[float] = 1e-300


def open_marches(marches: RollingMarches, ratio: float):
    """Nothing is pushed and nothing counts yet in any strip; ``ratio`` is the patch's a/b."""
    clear(marches)
    for q in range(POINT_LIMIT):
        marches.at_point[q] = -1.0
    square = ratio / SHARE_RATIO * (ratio / SHARE_RATIO)
    marches.share = SHARE / (1.0 + square * square)


def set_pushes(
    march: RollingMarch, marches: RollingMarches, number: int, plane: float, spinning: float, ratio: float
):
    """What both marches of strip ``number`` lose per way, eqs. (M1) to (M4); ``plane`` = i1/K1 = i2/K2 and
    ``spinning`` = i3/K3 [1/m] of the patch, ``ratio`` its a/b."""
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
    marches.lag[number] = lag / (1.0 + scale * fills / (LAG_FILLS * LAG_FILLS))
    along = march.slip / march.rate
    across = march.lateral / march.rate
    turning = march.spin * march.half_length / march.rate
    marches.push_x[number] = along * i1
    marches.push_y[number] = across * i2
    marches.push_turn[number] = turning * i3
    marches.centre_x[number] = along * centre
    marches.centre_y[number] = across * centre
    marches.centre_turn[number] = turning * centre


def set_stick(table: RollingTable, march: RollingMarch, marches: RollingMarches, number: int):
    """Begin the sums of strip ``number`` with its stick zone: eqs. (T1), (T2) without what slips, and the
    points before the edge; the first point behind the edge takes note of the strip."""
    weight = march.weight
    marches.slips[number] = 1.0 - weight
    marches.noted[number] = (1.0 - weight) * (1.0 - weight)
    if weight > 0.0:
        depth = march.depth / march.half_length
        edge = 2.0 * depth - 1.0
        q = POINT_LIMIT
        behind = 0.0
        turning = 0.0
        while q > 0 and table.cosines[q - 1] < edge:
            q -= 1
            behind += table.sines[q] * table.sines[q]
            turning += table.sines[q] * table.sines[q] * table.cosines[q]
        marches.sticks[number] = weight
        marches.stick_x[number] = march.stick_x
        marches.stick_y[number] = march.stick_y
        marches.edge[number] = edge
        lead_x = march.lead_x / march.half_length * WHOLE
        lead_y = march.lead_y / march.half_length * WHOLE
        inner = (1.0 - depth) * (1.0 - depth)
        marches.sum_x[number] = weight * (lead_x * (2.0 - depth) - march.stick_x * behind)
        marches.sum_y[number] = weight * (
            lead_y * (2.0 - depth) + march.twist * WHOLE - march.stick_y * behind
        )
        marches.sum_moment[number] = -weight * (lead_y * inner + march.stick_y * turning)
        if march.twist * march.twist > 1.0:
            add_beyond(table, march, marches, number, q)
        if q < POINT_LIMIT:
            marches.next[number] = marches.at_point[q]
            marches.at_point[q] = float(number)


def add_beyond(table: RollingTable, march: RollingMarch, marches: RollingMarches, number: int, last: int):
    """Add what eq. (Z1) has to be changed by to stay within the bound, at the points before ``last``."""
    depth = march.depth / march.half_length
    for q in range(last):
        bound = table.sines[q]
        away = table.cosines[q] - depth
        inner = (1.0 - depth) * (1.0 - depth) - away * away
        if inner > 0.0:
            root = sqrt(inner)
            p_x = march.stick_x * (bound - root)
            p_y = march.stick_y * (bound - root) + march.twist * root
            cut_x, cut_y = cut_to(p_x, p_y, bound)
            weight = march.weight * bound
            marches.sum_x[number] += weight * (cut_x - p_x)
            marches.sum_y[number] += weight * (cut_y - p_y)
            marches.sum_moment[number] += weight * table.cosines[q] * (cut_y - p_y)


def march_strips(table: RollingTable, marches: RollingMarches, falling: FallingFriction, falls: bool):
    """Add the points of all strips, from the leading edge on, to their sums; ``falls``: whether friction
    does, with the slip of each point (falling.py)."""
    before = 1.0
    slipping = has_slip(marches)
    for q in range(POINT_LIMIT):
        x = table.cosines[q]
        bound = table.sines[q]
        first = int(marches.at_point[q])
        strip = first
        while strip >= 0:
            reach_edge(marches, strip, before, x, bound)
            strip = int(marches.next[strip])
        march_first(marches, x, bound, before - x)
        if falls:
            find_shares(falling, x)
        if slipping:
            if falls:
                weigh_slips(marches, falling, bound)
            march_second(marches, x, bound, before - x)
            if falls:
                restore_slips(marches, falling)
        strip = first
        while strip >= 0:
            friction = 1.0
            if falls:
                friction = falling.share[strip]
                falling.lost[strip] += bound * bound * marches.edge_share[strip] * (1.0 - friction)
            leave_edge(marches, strip, x, bound, friction)
            slipping = True
            strip = int(marches.next[strip])
        before = x


def has_slip(marches: RollingMarches) -> bool:
    """Whether slip counts in some strip at its leading edge."""
    found = False
    for i in range(ROLLING_STRIP_LIMIT):
        if marches.slips[i] > 0.0:
            found = True
    return found


def march_first(marches: RollingMarches, x: float, bound: float, step: float):
    """Let march A of all strips come to ``x``, a ``step`` further, eq. (M1)."""
    limit = bound * bound
    for i in range(ROLLING_STRIP_LIMIT):
        at = x + marches.lag[i] * step
        along = marches.first_x[i] - step * marches.push_x[i]
        across = marches.first_y[i] - step * (marches.push_y[i] + marches.push_turn[i] * at)
        square = max(along * along + across * across, limit)
        cut = bound / sqrt(square)
        marches.first_x[i] = cut * along
        marches.first_y[i] = cut * across


def march_second(marches: RollingMarches, x: float, bound: float, step: float):
    """The same for march B, and add what slips there: eqs. (M2), (M5), most of all time that the model
    takes."""
    share = marches.share
    limit = bound * bound
    soft = SOFT * SOFT * limit
    for i in range(ROLLING_STRIP_LIMIT):
        at = x + marches.lag[i] * step
        second_x = marches.second_x[i] - step * marches.centre_x[i]
        second_y = marches.second_y[i] - step * (marches.centre_y[i] + marches.centre_turn[i] * at)
        square = max(second_x * second_x + second_y * second_y, limit)
        cut = bound / sqrt(square)
        second_x *= cut
        second_y *= cut
        marches.second_x[i] = second_x
        marches.second_y[i] = second_y
        along = marches.first_x[i] + share * (second_x - marches.first_x[i])
        across = marches.first_y[i] + share * (second_y - marches.first_y[i])
        square = along * along + across * across
        scale = bound / sqrt((1.0 - SOFT * SOFT) * square + soft)
        largest = max(marches.noted[i] * (square * scale * scale), marches.largest[i])
        marches.largest[i] = largest
        scale *= bound * marches.slips[i]
        marches.sum_x[i] += scale * along
        across *= scale
        marches.sum_y[i] += across
        marches.sum_moment[i] += x * across


def reach_edge(marches: RollingMarches, i: int, before: float, x: float, bound: float):
    """The traction of strip ``i`` at the edge of its stick zone, between ``before`` and the point ``x``, and
    how much slip counts at that point."""
    edge = marches.edge[i]
    weight = marches.sticks[i]
    edge_bound = sqrt_of(1.0 - edge * edge)
    start_x = weight * marches.stick_x[i] * edge_bound
    start_y = weight * marches.stick_y[i] * edge_bound
    if weight < 1.0:
        to_x, to_y = stepped(marches, i, marches.second_x[i], marches.second_y[i], edge, before - edge)
        to_x, to_y = cut_to(to_x, to_y, edge_bound)
        start_x += (1.0 - weight) * to_x
        start_y += (1.0 - weight) * to_y
    note_largest(marches, i, start_x, start_y)
    marches.edge_x[i] = start_x
    marches.edge_y[i] = start_y
    marches.edge_share[i] = (edge - x) / (before - x)
    near = 1.0 - marches.edge_share[i]
    marches.slips[i] = near * (1.0 - weight)
    marches.noted[i] = 0.0
    weight *= near * bound * bound
    marches.sum_x[i] += weight * marches.stick_x[i]
    marches.sum_y[i] += weight * marches.stick_y[i]
    marches.sum_moment[i] += weight * x * marches.stick_y[i]


def leave_edge(marches: RollingMarches, i: int, x: float, bound: float, friction: float):
    """Let the second march of strip ``i`` begin at the edge of its stick zone, and add the rest of its
    traction at ``x``, the first point behind; ``friction`` is that there over that of rest."""
    weight = marches.sticks[i]
    near = marches.slips[i]
    p_x = 0.0
    p_y = 0.0
    if weight < 1.0:
        slip_x, slip_y = slip_traction(marches, i, bound)
        p_x = near * friction * slip_x
        p_y = near * friction * slip_y
    step = marches.edge[i] - x
    to_x, to_y = stepped(marches, i, marches.edge_x[i], marches.edge_y[i], x, step)
    to_x, to_y = cut_to(to_x, to_y, bound)
    if weight < FAINT:
        # as if there was no stick zone, of which nothing is left
        kept = weight / FAINT
        to_x = marches.second_x[i] + kept * (to_x - marches.second_x[i])
        to_y = marches.second_y[i] + kept * (to_y - marches.second_y[i])
    marches.second_x[i] = to_x
    marches.second_y[i] = to_y
    slip_x, slip_y = slip_traction(marches, i, bound)
    share = marches.edge_share[i]
    slip_x *= share * friction
    slip_y *= share * friction
    marches.sum_x[i] += bound * slip_x
    marches.sum_y[i] += bound * slip_y
    marches.sum_moment[i] += bound * x * slip_y
    weight *= (1.0 - share) * bound
    note_largest(
        marches, i, p_x + weight * marches.stick_x[i] + slip_x, p_y + weight * marches.stick_y[i] + slip_y
    )
    marches.slips[i] = 1.0
    marches.noted[i] = 1.0


def stepped(marches: RollingMarches, i: int, p_x: float, p_y: float, x: float, step: float):
    """The traction of the second march of strip ``i`` at ``x``, a ``step`` further, not yet cut; eq. (M2)."""
    across = marches.centre_y[i] + marches.centre_turn[i] * (x + marches.lag[i] * step)
    return p_x - step * marches.centre_x[i], p_y - step * across


def slip_traction(marches: RollingMarches, i: int, bound: float):
    """The traction of strip ``i`` of eq. (M5)."""
    along = marches.first_x[i] + marches.share * (marches.second_x[i] - marches.first_x[i])
    across = marches.first_y[i] + marches.share * (marches.second_y[i] - marches.first_y[i])
    square = along * along + across * across
    scale = bound / sqrt(square + SOFT * SOFT * (bound * bound - square))
    return along * scale, across * scale


def note_largest(marches: RollingMarches, i: int, p_x: float, p_y: float):
    """Keep the largest traction of strip ``i``."""
    square = p_x * p_x + p_y * p_y
    marches.largest[i] = max(marches.largest[i], square)


def sqrt_of(value: float):
    """Square root, of nothing below zero."""
    root = 0.0
    if value > 0.0:
        root = sqrt(value)
    return root
