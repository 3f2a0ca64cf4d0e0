"""Nodes across a region: gap, longitudinal and lateral curvature, and from them ANALYN's coefficients.

Nodes are anchored at the region's minimum, station + k h, with h a fixed share of the half-width of the
interpenetration; so a result depends on the pose alone and moves smoothly with it.

Lateral curvature.  Second differences over a window w (the curvature averaged with a triangle of half-width w) are
smooth but blind to what lies beyond; the secant g/s^2 knows how far the surfaces have parted but lags behind.  With
B_t and B_s these two,

    B = sqrt(B_t max(B_t, B_s)),   B_t, B_s >= FLOOR A

follows a sharp joint (B_t) and keeps a patch from growing where B_t falls to zero or below (B_s).

That is the lateral curvature "adaptive".  "smooth" and "rough" are the source's, prepared for each profile
(:mod:`lateral_curvature`), one B in all three places; where it is below FLOOR A it counts as that.
"""

from math import fabs, log, sqrt
from typing import Final

from ..contact.contact_plane import NO_GAP, is_yawed, start_tracer
from ..contact.separation import open_origin, separation
from ..layout import (
    LATERAL_ADAPTIVE,
    MODEL_ANALYN_STRIP,
    NODE_FIELDS,
    NODE_LIMIT,
    NODE_MIDDLE,
    WORK_NODES,
    Region,
    State,
    Tables,
    Work,
)
from ..surface.lateral_curvature import relative_curvature
from .hertz import hertz_coefficients, skewed_coefficients, table_value, upright_coefficients

# node fields
NODE_GAP: Final[int] = 0             # rise of the gap over the region's minimum [m]
NODE_A: Final[int] = 1               # longitudinal A = 1/(2 R_x) [1/m]
NODE_RISE: Final[int] = 2            # (1 + beta) times the gap's rise [m]
NODE_LINE: Final[int] = 3            # E* / (n r): line load per local penetration [N/m^2]
NODE_LENGTH: Final[int] = 4          # (1 + alpha) A [1/m]
NODE_B: Final[int] = 5               # lateral curvature B [1/m]

#: Smallest lateral curvature as a share of the longitudinal one; B <= 0 inside the patch is the normal case on treads.
FLOOR: Final[float] = 0.02
#: Smallest windowed curvature as a share of the secant's, and how much of what it exceeds that by is taken at the edge.
WINDOW_FLOOR: Final[float] = 0.05
GROWTH: Final[float] = 0.12
TRACE_SHARE: Final[float] = 1e-3     # of the spacing: tolerance of the abscissae
FINEST_TRACE: Final[float] = 5e-8    # [m]; the residual is removed to second order


def node_field(region: int, field: int):
    """Offset of node 0 of a region's ``field`` in the workspace."""
    return WORK_NODES + (region * NODE_FIELDS + field) * NODE_LIMIT + NODE_MIDDLE


def lay_nodes(tables: Tables, work: Work, state: State, region: int, low_reach: float, high_reach: float,
              spacing: float, window: int, stride: int):
    """Gap and A at the region's nodes, until the gap has risen above ``low_reach`` or ``high_reach`` on that side or the
    bound is passed, and ``window`` nodes further.

    Every ``stride``-th node is traced on the profiles; those between are read off the cubic through gap and slope there.
    Where the lateral curvature is a prepared one, it is kept in NODE_B for :func:`weigh_nodes`.
    """
    block = work.regions[region]
    block.spacing = spacing
    gaps = node_field(region, NODE_GAP)
    longitudinal = node_field(region, NODE_A)
    tolerance = TRACE_SHARE * spacing
    if tolerance > FINEST_TRACE:
        tolerance = FINEST_TRACE
    prepared = 0
    if int(tables.lateral) != LATERAL_ADAPTIVE:
        prepared = 1
    origin = block.station
    start_tracer(work, origin, block.rail, block.wheel)
    open_origin(tables, work, origin, block.gap, block.rail, block.wheel,
                spacing)
    gap, first_rate, bend, curvature = separation(tables, work, state, origin, tolerance)
    work[gaps] = 0.0
    work[longitudinal] = 0.5 * curvature
    if prepared == 1:
        work[node_field(region, NODE_B)] = relative_curvature(tables, work.frame.tracer_wheel, work.frame.tracer_rail)
    for direction in range(-1, 2, 2):
        start_tracer(work, origin, block.rail, block.wheel)
        rate = first_rate
        reach = high_reach
        if direction < 0:
            reach = low_reach
        k = 0
        traced = 0
        step = stride
        left = window
        passed = 0
        ended = 0
        while left > 0 and k < NODE_LIMIT - NODE_MIDDLE - 2 - stride:
            if k == traced and ended == 0:
                at = direction * (traced + step)
                gap, next_rate, bend, curvature = separation(tables, work, state, origin + spacing * float(at), tolerance)
                if gap >= NO_GAP and step > 1:
                    # a profile ends within this stretch: node by node from here
                    step = 1
                    start_tracer(work, origin, block.rail, block.wheel)
                    at = direction * (traced + step)
                    gap, next_rate, bend, curvature = separation(tables, work, state, origin + spacing * float(at),
                                                                 tolerance)
                if gap >= NO_GAP:
                    ended = 1
                    end_region(work, block, direction, origin + spacing * float(direction * k))
                else:
                    work[gaps + at] = gap - block.gap
                    work[longitudinal + at] = 0.5 * curvature
                    if prepared == 1:
                        work[node_field(region, NODE_B) + at] = relative_curvature(tables, work.frame.tracer_wheel,
                                                                                   work.frame.tracer_rail)
                    fill_between(work.raw, gaps, longitudinal, direction * traced, at, step, spacing, rate, next_rate)
                    rate = next_rate
                    traced += step
            k += 1
            at = direction * k
            station = origin + spacing * float(at)
            if ended == 1:
                extrapolate_node(work.raw, gaps, longitudinal, at, direction)
                if prepared == 1:
                    work[node_field(region, NODE_B) + at] = work[node_field(region, NODE_B) + at - direction]
            if passed > 0:
                left -= 1
            elif ended == 1 or work[gaps + at] > reach:
                passed = k
            elif station > block.high or station < block.low:
                passed = k
        if passed == 0:
            passed = k - window
        if direction < 0:
            block.first = float(-passed)
        else:
            block.last = float(passed)
    return 0


def fill_straight(work: 'float[:]', field: int, start: int, stop: int, count: int):
    """``field`` at the ``count`` - 1 nodes between two, on a straight line."""
    inward = 1
    if stop < start:
        inward = -1
    rise = (work[field + stop] - work[field + start]) / float(count)
    for i in range(1, count):
        work[field + start + inward * i] = work[field + start] + rise * float(i)
    return 0


def fill_between(work: 'float[:]', gaps: int, longitudinal: int, start: int, stop: int, count: int, spacing: float,
                 start_rate: float, stop_rate: float):
    """Gap (cubic of Hermite) and A (linear) at the ``count`` - 1 nodes between two traced ones with their slopes.

    Behind a conformal stretch the gap can rise so suddenly that the cubic falls below zero before; no gap of a region is smaller
    than that at its minimum.
    """
    low = work[gaps + start]
    rise = work[gaps + stop] - low
    width = spacing * float(stop - start)
    forward = start_rate * width - rise
    backward = stop_rate * width - rise
    inward = 1
    if stop < start:
        inward = -1
    for i in range(1, count):
        x = float(i) / float(count)
        rest = 1.0 - x
        gap = low + x * (rise + rest * (rest * forward - x * backward))
        if gap < 0.0:
            gap = 0.0
        work[gaps + start + inward * i] = gap
    fill_straight(work, longitudinal, start, stop, count)
    return 0


def end_region(work: Work, block: Region, direction: int, station: float):
    """Bound the region at ``station``: beyond it a profile ends, or the outline of a strongly yawed wheel folds back.  A bound
    that is known to lie before the next node stays."""
    if direction > 0:
        if station + block.spacing < block.high:
            block.high = station
    elif station - block.spacing > block.low:
        block.low = station
    return 0


def extrapolate_node(work: 'float[:]', gaps: int, longitudinal: int, at: int, direction: int):
    """Continue gap and A past an end, so that windows over it see the curvature before it."""
    one = gaps + at - direction
    if at * direction > 2:
        work[gaps + at] = 3.0 * work[one] - 3.0 * work[one - direction] + work[one - 2 * direction]
    else:
        # next to the minimum: take the other side's, or nothing if that is not known yet
        work[gaps + at] = work[one]
    work[longitudinal + at] = work[longitudinal + at - direction]
    return 0


def second_difference(work: 'float[:]', at: int, spacing: float, window: int):
    """Half the second derivative [1/m] of the field at ``at``, averaged with a triangle of half-width window h."""
    width = spacing * float(window)
    return (work[at + window] - 2.0 * work[at] + work[at - window]) / (2.0 * width * width)


def secant_curvature(work: Work, region: int, k: int, window: int, middle: float):
    """g / s^2 [1/m] at node ``k``; within the window a blend from ``middle`` to the secant at its end."""
    gaps = node_field(region, NODE_GAP)
    spacing = work.regions[region].spacing
    if k >= window or k <= -window:
        s = spacing * float(k)
        return work[gaps + k] / (s * s)
    width = spacing * float(window)
    edge = work[gaps + window] / (width * width)
    if k < 0:
        edge = work[gaps - window] / (width * width)
    return middle + (edge - middle) * fabs(float(k)) / float(window)


def windowed_curvature(averaged: float, secant: float, share: float):
    """sqrt(B_w (B_s + GROWTH share max(B_w - B_s, 0))) [1/m], with B_w not below WINDOW_FLOOR B_s."""
    if averaged < WINDOW_FLOOR * secant:
        averaged = WINDOW_FLOOR * secant
    grown = secant
    if averaged > secant:
        grown += GROWTH * share * (averaged - secant)
    return sqrt(averaged * grown)


def adaptive_curvatures(work: Work, region: int, k: int, window: int, middle: float, mean: float, least: float):
    """The three lateral curvatures [1/m] at node ``k``, for 1 + alpha, 1 + beta and n r: secant, side and window; none
    below ``least``."""
    block = work.regions[region]
    spacing = block.spacing
    secant = secant_curvature(work, region, k, window, middle)
    if secant < least:
        secant = least
    share = fabs(float(k)) * spacing / mean
    if share > 1.0:
        share = 1.0
    B = windowed_curvature(second_difference(work.raw, node_field(region, NODE_GAP) + k, spacing, window), secant, share)
    if B < least:
        B = least
    side = block.side_high
    if k < 0:
        side = block.side_low
    if side < least:
        side = least
    return secant, side, B


def weigh_nodes(tables: Tables, work: Work, region: int, window: int):
    """ANALYN's coefficients at the region's nodes: (1 + beta) g, E*/(n r) and (1 + alpha) A, each with its own B, or all
    with the prepared one."""
    block = work.regions[region]
    gaps = node_field(region, NODE_GAP)
    longitudinal = node_field(region, NODE_A)
    base = int(tables.hertz)
    yawed = is_yawed(work)
    prepared = 0
    if int(tables.lateral) != LATERAL_ADAPTIVE:
        prepared = 1
    alpha_turn = 1.0
    beta_turn = 1.0
    nr_turn = 1.0
    if yawed == 1:
        alpha_turn, beta_turn, nr_turn = turn_region(tables, work, region)
    spacing = block.spacing
    mean = 0.5 * (block.width_low + block.width_high)
    middle = second_difference(work.raw, gaps, spacing, window)
    if middle < 0.0:
        middle = 0.0
    for k in range(block.first, block.last + 1):
        A = work[longitudinal + k]
        least = FLOOR * A
        if prepared == 1:
            B = work[node_field(region, NODE_B) + k]
            if B < least:
                B = least
            secant = B
            side = B
        else:
            secant, side, B = adaptive_curvatures(work, region, k, window, middle, mean, least)
        alpha = table_value(tables.raw, base, 0, log(secant / A))
        beta = table_value(tables.raw, base, 0, log(A / side))
        nr = table_value(tables.raw, base, 6, log(B / A))
        if yawed == 1:
            alpha *= alpha_turn
            beta *= beta_turn
            nr *= nr_turn
        work[node_field(region, NODE_B) + k] = B
        work[node_field(region, NODE_RISE) + k] = beta * work[gaps + k]
        work[node_field(region, NODE_LINE) + k] = tables.contact_modulus / nr
        work[node_field(region, NODE_LENGTH) + k] = alpha * A
    return 0


def turn_region(tables: Tables, work: Work, region: int):
    """What the slant of a yawed wheel's ridge makes of 1 + alpha, 1 + beta and n r: factors for all nodes of the region,
    from its mean slant and curvature; and for the strips the upright ellipse that cuts into the same ones."""
    block = work.regions[region]
    base = int(tables.hertz)
    A = work[node_field(region, NODE_A)]
    B = 0.5 * (block.side_low + block.side_high)
    if B < FLOOR * A:
        B = FLOOR * A
    alpha, beta, nr = hertz_coefficients(tables.raw, base, A, B)
    turned_alpha, turned_beta, turned_nr = skewed_coefficients(tables.raw, base, A, B, block.slant)
    if int(tables.normal_model) == MODEL_ANALYN_STRIP:
        upright_A, upright_B, share = upright_coefficients(tables.raw, base, turned_alpha * A, turned_beta * B, turned_nr)
        block.upright_a = upright_A / A
        block.upright_b = upright_B / B
        block.upright_share = share
    return turned_alpha / alpha, turned_beta / beta, turned_nr / nr
