"""Tractions of a strip from its leading edge to its trailing one.

In the slip zone the traction is the bound; two integrations tell its direction.  Both lose traction to the slip,
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

All strips are integrated side by side, with places over a and tractions over m a, so that bounds and steps are those
of all of them, and compilers do several strips at once.
"""

from math import pi, sqrt
from typing import Final

from ..layout import (
    POINT_LIMIT,
    ROLLING_STRIP_LIMIT,
    FallingFriction,
    StripIntegration,
    StripIntegrations,
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
#: Fills of the bound at which integration A is half way to B; eq. (M4).
FILLS: Final[float] = 6.0
#: W in short patches, and the a/b at which it is half of that; eq. (M5).
SHARE: Final[float] = 0.65
SHARE_RATIO: Final[float] = 1.2
#: Directions of tractions below this share of the bound fade; eq. (M5).
SOFT: Final[float] = 0.05
#: Stick zones of a smaller weight leave the second integration more and more as it is without them.
FAINT: Final[float] = 1e-3
#: The sum of the squares of all sines.
WHOLE: Final[float] = 0.5 * float(POINT_LIMIT + 1)
#: In place of no slip at all.
NOTHING: Final[float] = 1e-300


def open_integrations(integrations: StripIntegrations, ratio: float):
    """Nothing is pushed and nothing counts yet in any strip; ``ratio`` is the patch's a/b."""
    clear(integrations)
    for q in range(POINT_LIMIT):
        integrations.at_point[q] = -1.0
    square = ratio / SHARE_RATIO * (ratio / SHARE_RATIO)
    integrations.share = SHARE / (1.0 + square * square)


def set_pushes(
    integration: StripIntegration,
    integrations: StripIntegrations,
    number: int,
    plane: float,
    spinning: float,
    ratio: float,
):
    """What both marches of strip ``number`` lose per way, eqs. (M1) to (M4); ``plane`` = i1/K1 = i2/K2 and
    ``spinning`` = i3/K3 [1/m] of the patch, ``ratio`` its a/b."""
    i1 = integration.along * plane
    i2 = integration.across * plane
    i3 = integration.turning * spinning
    s = 3.0 * pi / 32.0 * integration.half_length * integration.spin
    x = integration.slip * integration.slip
    y = integration.lateral * integration.lateral
    z = s * s
    centre = (x * i1 + y * i2 + z * i3 + NOTHING * i1) / (x + y + z + NOTHING)
    fills = x * i1 * i1 + y * i2 * i2 + z * i3 * i3
    scale = 4.0 / (integration.rate * integration.rate)
    near = 1.0 / (1.0 + scale * fills / (FILLS * FILLS))
    i1 = centre + (i1 - centre) * near
    i2 = centre + (i2 - centre) * near
    i3 = centre + (i3 - centre) * near
    fills = x * i1 * i1 + y * i2 * i2 + z * i3 * i3
    lag = LAG + LONG_LAG * ratio / (ratio + LAG_RATIO)
    integrations.lag[number] = lag / (1.0 + scale * fills / (LAG_FILLS * LAG_FILLS))
    along = integration.slip / integration.rate
    across = integration.lateral / integration.rate
    turning = integration.spin * integration.half_length / integration.rate
    integrations.push_x[number] = along * i1
    integrations.push_y[number] = across * i2
    integrations.push_turn[number] = turning * i3
    integrations.centre_x[number] = along * centre
    integrations.centre_y[number] = across * centre
    integrations.centre_turn[number] = turning * centre


def set_stick(
    table: RollingTable, integration: StripIntegration, integrations: StripIntegrations, number: int
):
    """Begin the sums of strip ``number`` with its stick zone: eqs. (T1), (T2) without what slips, and the
    points before the edge; the first point behind the edge takes note of the strip."""
    weight = integration.weight
    integrations.slips[number] = 1.0 - weight
    integrations.noted[number] = (1.0 - weight) * (1.0 - weight)
    if weight > 0.0:
        depth = integration.depth / integration.half_length
        edge = 2.0 * depth - 1.0
        q = POINT_LIMIT
        behind = 0.0
        turning = 0.0
        while q > 0 and table.cosines[q - 1] < edge:
            q -= 1
            behind += table.sines[q] * table.sines[q]
            turning += table.sines[q] * table.sines[q] * table.cosines[q]
        integrations.sticks[number] = weight
        integrations.stick_x[number] = integration.stick_x
        integrations.stick_y[number] = integration.stick_y
        integrations.edge[number] = edge
        lead_x = integration.lead_x / integration.half_length * WHOLE
        lead_y = integration.lead_y / integration.half_length * WHOLE
        inner = (1.0 - depth) * (1.0 - depth)
        integrations.sum_x[number] = weight * (lead_x * (2.0 - depth) - integration.stick_x * behind)
        integrations.sum_y[number] = weight * (
            lead_y * (2.0 - depth) + integration.twist * WHOLE - integration.stick_y * behind
        )
        integrations.sum_moment[number] = -weight * (lead_y * inner + integration.stick_y * turning)
        if integration.twist * integration.twist > 1.0:
            add_beyond(table, integration, integrations, number, q)
        if q < POINT_LIMIT:
            integrations.next[number] = integrations.at_point[q]
            integrations.at_point[q] = float(number)


def add_beyond(
    table: RollingTable,
    integration: StripIntegration,
    integrations: StripIntegrations,
    number: int,
    last: int,
):
    """Add what eq. (Z1) has to be changed by to stay within the bound, at the points before ``last``."""
    depth = integration.depth / integration.half_length
    for q in range(last):
        bound = table.sines[q]
        away = table.cosines[q] - depth
        inner = (1.0 - depth) * (1.0 - depth) - away * away
        if inner > 0.0:
            root = sqrt(inner)
            p_x = integration.stick_x * (bound - root)
            p_y = integration.stick_y * (bound - root) + integration.twist * root
            cut_x, cut_y = cut_to(p_x, p_y, bound)
            weight = integration.weight * bound
            integrations.sum_x[number] += weight * (cut_x - p_x)
            integrations.sum_y[number] += weight * (cut_y - p_y)
            integrations.sum_moment[number] += weight * table.cosines[q] * (cut_y - p_y)


def integrate_strips(
    table: RollingTable, integrations: StripIntegrations, falling: FallingFriction, falls: bool
):
    """Add the points of all strips, from the leading edge on, to their sums; ``falls``: whether friction
    does, with the slip of each point (falling.py)."""
    before = 1.0
    slipping = has_slip(integrations)
    for q in range(POINT_LIMIT):
        x = table.cosines[q]
        bound = table.sines[q]
        first = int(integrations.at_point[q])
        strip = first
        while strip >= 0:
            reach_edge(integrations, strip, before, x, bound)
            strip = int(integrations.next[strip])
        integrate_first(integrations, x, bound, before - x)
        if falls:
            find_shares(falling, x)
        if slipping:
            if falls:
                weigh_slips(integrations, falling, bound)
            integrate_second(integrations, x, bound, before - x)
            if falls:
                restore_slips(integrations, falling)
        strip = first
        while strip >= 0:
            friction = 1.0
            if falls:
                friction = falling.share[strip]
                falling.lost[strip] += bound * bound * integrations.edge_share[strip] * (1.0 - friction)
            leave_edge(integrations, strip, x, bound, friction)
            slipping = True
            strip = int(integrations.next[strip])
        before = x


def has_slip(integrations: StripIntegrations) -> bool:
    """Whether slip counts in some strip at its leading edge."""
    found = False
    for i in range(ROLLING_STRIP_LIMIT):
        if integrations.slips[i] > 0.0:
            found = True
    return found


def integrate_first(integrations: StripIntegrations, x: float, bound: float, step: float):
    """Let integration A of all strips come to ``x``, a ``step`` further, eq. (M1)."""
    limit = bound * bound
    for i in range(ROLLING_STRIP_LIMIT):
        at = x + integrations.lag[i] * step
        along = integrations.first_x[i] - step * integrations.push_x[i]
        across = integrations.first_y[i] - step * (integrations.push_y[i] + integrations.push_turn[i] * at)
        square = max(along * along + across * across, limit)
        cut = bound / sqrt(square)
        integrations.first_x[i] = cut * along
        integrations.first_y[i] = cut * across


def integrate_second(integrations: StripIntegrations, x: float, bound: float, step: float):
    """The same for integration B, and add what slips there: eqs. (M2), (M5), most of all time that the model
    takes."""
    share = integrations.share
    limit = bound * bound
    soft = SOFT * SOFT * limit
    for i in range(ROLLING_STRIP_LIMIT):
        at = x + integrations.lag[i] * step
        second_x = integrations.second_x[i] - step * integrations.centre_x[i]
        second_y = integrations.second_y[i] - step * (
            integrations.centre_y[i] + integrations.centre_turn[i] * at
        )
        square = max(second_x * second_x + second_y * second_y, limit)
        cut = bound / sqrt(square)
        second_x *= cut
        second_y *= cut
        integrations.second_x[i] = second_x
        integrations.second_y[i] = second_y
        along = integrations.first_x[i] + share * (second_x - integrations.first_x[i])
        across = integrations.first_y[i] + share * (second_y - integrations.first_y[i])
        square = along * along + across * across
        scale = bound / sqrt((1.0 - SOFT * SOFT) * square + soft)
        largest = max(integrations.noted[i] * (square * scale * scale), integrations.largest[i])
        integrations.largest[i] = largest
        scale *= bound * integrations.slips[i]
        integrations.sum_x[i] += scale * along
        across *= scale
        integrations.sum_y[i] += across
        integrations.sum_moment[i] += x * across


def reach_edge(integrations: StripIntegrations, i: int, before: float, x: float, bound: float):
    """The traction of strip ``i`` at the edge of its stick zone, between ``before`` and the point ``x``, and
    how much slip counts at that point."""
    edge = integrations.edge[i]
    weight = integrations.sticks[i]
    edge_bound = sqrt_of(1.0 - edge * edge)
    start_x = weight * integrations.stick_x[i] * edge_bound
    start_y = weight * integrations.stick_y[i] * edge_bound
    if weight < 1.0:
        to_x, to_y = stepped(
            integrations, i, integrations.second_x[i], integrations.second_y[i], edge, before - edge
        )
        to_x, to_y = cut_to(to_x, to_y, edge_bound)
        start_x += (1.0 - weight) * to_x
        start_y += (1.0 - weight) * to_y
    note_largest(integrations, i, start_x, start_y)
    integrations.edge_x[i] = start_x
    integrations.edge_y[i] = start_y
    integrations.edge_share[i] = (edge - x) / (before - x)
    near = 1.0 - integrations.edge_share[i]
    integrations.slips[i] = near * (1.0 - weight)
    integrations.noted[i] = 0.0
    weight *= near * bound * bound
    integrations.sum_x[i] += weight * integrations.stick_x[i]
    integrations.sum_y[i] += weight * integrations.stick_y[i]
    integrations.sum_moment[i] += weight * x * integrations.stick_y[i]


def leave_edge(integrations: StripIntegrations, i: int, x: float, bound: float, friction: float):
    """Let the second integration of strip ``i`` begin at the edge of its stick zone, and add the rest of its
    traction at ``x``, the first point behind; ``friction`` is that there over that of rest."""
    weight = integrations.sticks[i]
    near = integrations.slips[i]
    p_x = 0.0
    p_y = 0.0
    if weight < 1.0:
        slip_x, slip_y = slip_traction(integrations, i, bound)
        p_x = near * friction * slip_x
        p_y = near * friction * slip_y
    step = integrations.edge[i] - x
    to_x, to_y = stepped(integrations, i, integrations.edge_x[i], integrations.edge_y[i], x, step)
    to_x, to_y = cut_to(to_x, to_y, bound)
    if weight < FAINT:
        # as if there was no stick zone, of which nothing is left
        kept = weight / FAINT
        to_x = integrations.second_x[i] + kept * (to_x - integrations.second_x[i])
        to_y = integrations.second_y[i] + kept * (to_y - integrations.second_y[i])
    integrations.second_x[i] = to_x
    integrations.second_y[i] = to_y
    slip_x, slip_y = slip_traction(integrations, i, bound)
    share = integrations.edge_share[i]
    slip_x *= share * friction
    slip_y *= share * friction
    integrations.sum_x[i] += bound * slip_x
    integrations.sum_y[i] += bound * slip_y
    integrations.sum_moment[i] += bound * x * slip_y
    weight *= (1.0 - share) * bound
    note_largest(
        integrations,
        i,
        p_x + weight * integrations.stick_x[i] + slip_x,
        p_y + weight * integrations.stick_y[i] + slip_y,
    )
    integrations.slips[i] = 1.0
    integrations.noted[i] = 1.0


def stepped(integrations: StripIntegrations, i: int, p_x: float, p_y: float, x: float, step: float):
    """The traction of the second integration of strip ``i`` at ``x``, a ``step`` further, not yet cut; eq. (M2)."""
    across = integrations.centre_y[i] + integrations.centre_turn[i] * (x + integrations.lag[i] * step)
    return p_x - step * integrations.centre_x[i], p_y - step * across


def slip_traction(integrations: StripIntegrations, i: int, bound: float):
    """The traction of strip ``i`` of eq. (M5)."""
    along = integrations.first_x[i] + integrations.share * (
        integrations.second_x[i] - integrations.first_x[i]
    )
    across = integrations.first_y[i] + integrations.share * (
        integrations.second_y[i] - integrations.first_y[i]
    )
    square = along * along + across * across
    scale = bound / sqrt(square + SOFT * SOFT * (bound * bound - square))
    return along * scale, across * scale


def note_largest(integrations: StripIntegrations, i: int, p_x: float, p_y: float):
    """Keep the largest traction of strip ``i``."""
    square = p_x * p_x + p_y * p_y
    integrations.largest[i] = max(integrations.largest[i], square)


def sqrt_of(value: float):
    """Square root, of nothing below zero."""
    root = 0.0
    if value > 0.0:
        root = sqrt(value)
    return root
