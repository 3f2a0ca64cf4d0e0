"""Nodes across a region: gap, longitudinal and lateral curvature, and from them ANALYN's coefficients.

Nodes are anchored at the region's minimum, station + k h, with h a fixed share of the half-width of the
interpenetration; so a result depends on the pose alone and moves smoothly with it.

Lateral curvature.  Second differences over a window w (the curvature averaged with a triangle of half-width w) are
smooth but blind to what lies beyond; the secant g/s^2 knows how far the surfaces have parted but lags behind.  With
B_t and B_s these two,

    B = sqrt(B_t max(B_t, B_s)),   B_t, B_s >= FLOOR A

follows a sharp joint (B_t) and keeps a patch from growing where B_t falls to zero or below (B_s).
"""

from math import fabs, sqrt
from typing import Final

from .contact_plane import NO_GAP, normal_gap, start_tracer
from .hertz import hertz_coefficients
from .layout import NODE_FIELDS, NODE_LIMIT, NODE_MIDDLE, SET_CONTACT_MODULUS, SET_HERTZ, WORK_NODES
from .regions import (REGION_FIRST, REGION_GAP, REGION_HIGH, REGION_LAST, REGION_LOW, REGION_RAIL, REGION_SPACING,
                      REGION_STATION, REGION_WHEEL, region_block)

# node fields
NODE_GAP: Final[int] = 0             # rise of the gap over the region's minimum [m]
NODE_A: Final[int] = 1               # longitudinal A = 1/(2 R_x) [1/m]
NODE_RISE: Final[int] = 2            # (1 + beta) times the gap's rise [m]
NODE_LINE: Final[int] = 3            # E* / (n r): line load per local penetration [N/m^2]
NODE_LENGTH: Final[int] = 4          # (1 + alpha) A [1/m]
NODE_LOAD: Final[int] = 5            # line load [N/m] at the solved level; negative where unloaded, likewise
NODE_SQUARE: Final[int] = 6          # square of the half-length [m^2] and
NODE_PRESSURE: Final[int] = 7        # square of the pressure on x = 0 [Pa^2]
NODE_B: Final[int] = 8               # lateral curvature B [1/m]

#: Smallest lateral curvature as a share of the longitudinal one; B <= 0 inside the patch is the normal case on treads.
FLOOR: Final[float] = 0.02
#: Nodes are evaluated until the gap exceeds the level by this factor.
COVER: Final[float] = 1.1
TRACE_SHARE: Final[float] = 1e-3     # of the spacing: tolerance of the abscissae
FINEST_TRACE: Final[float] = 5e-8    # [m]; leaves 1e-13 m in the gap, the residual being removed to first order


def node_field(region: int, field: int):
    """Offset of node 0 of a region's ``field`` in the workspace."""
    return WORK_NODES + (region * NODE_FIELDS + field) * NODE_LIMIT + NODE_MIDDLE


def lay_nodes(tables: 'float[:]', work: 'float[:]', state: 'float[:]', region: int, level: float, spacing: float,
              window: int, stride: int):
    """Gap and A at the region's nodes, until the gap has risen above COVER ``level`` or the bound is passed, and
    ``window`` nodes further.

    Every ``stride``-th node is traced on the profiles; those between are read off the cubic through gap and slope there.
    """
    block = region_block(region)
    work[block + REGION_SPACING] = spacing
    gaps = node_field(region, NODE_GAP)
    longitudinal = node_field(region, NODE_A)
    tolerance = TRACE_SHARE * spacing
    if tolerance > FINEST_TRACE:
        tolerance = FINEST_TRACE
    origin = work[block + REGION_STATION]
    start_tracer(work, origin, work[block + REGION_RAIL], work[block + REGION_WHEEL])
    gap, first_rate, bend, curvature = normal_gap(tables, work, state, origin, tolerance)
    work[gaps] = 0.0
    work[longitudinal] = 0.5 * curvature
    for direction in range(-1, 2, 2):
        start_tracer(work, origin, work[block + REGION_RAIL], work[block + REGION_WHEEL])
        rate = first_rate
        k = 0
        traced = 0
        step = stride
        left = window
        passed = 0
        ended = 0
        while left > 0 and k < NODE_LIMIT - NODE_MIDDLE - 2 - stride:
            if k == traced and ended == 0:
                at = direction * (traced + step)
                gap, next_rate, bend, curvature = normal_gap(tables, work, state, origin + spacing * float(at), tolerance)
                if gap >= NO_GAP and step > 1:
                    # a profile ends within this stretch: node by node from here
                    step = 1
                    start_tracer(work, origin, work[block + REGION_RAIL], work[block + REGION_WHEEL])
                    at = direction * (traced + step)
                    gap, next_rate, bend, curvature = normal_gap(tables, work, state, origin + spacing * float(at),
                                                                 tolerance)
                if gap >= NO_GAP:
                    ended = 1
                    end_region(work, block, direction, origin + spacing * float(direction * k))
                else:
                    work[gaps + at] = gap - work[block + REGION_GAP]
                    work[longitudinal + at] = 0.5 * curvature
                    fill_between(work, gaps, longitudinal, direction * traced, at, step, spacing, rate, next_rate)
                    rate = next_rate
                    traced += step
            k += 1
            at = direction * k
            station = origin + spacing * float(at)
            if ended == 1:
                extrapolate_node(work, gaps, longitudinal, at, direction)
            if passed > 0:
                left -= 1
            elif ended == 1 or work[gaps + at] > COVER * level:
                passed = k
            elif station > work[block + REGION_HIGH] or station < work[block + REGION_LOW]:
                passed = k
        if passed == 0:
            passed = k - window
        if direction < 0:
            work[block + REGION_FIRST] = float(-passed)
        else:
            work[block + REGION_LAST] = float(passed)
    return 0


def fill_between(work: 'float[:]', gaps: int, longitudinal: int, start: int, stop: int, count: int, spacing: float,
                 start_rate: float, stop_rate: float):
    """Gap (cubic of Hermite) and A (linear) at the ``count`` - 1 nodes between two traced ones with their slopes."""
    low = work[gaps + start]
    high = work[gaps + stop]
    width = spacing * float(stop - start)
    rise = high - low
    forward = start_rate * width
    backward = stop_rate * width
    inward = 1
    if stop < start:
        inward = -1
    for i in range(1, count):
        x = float(i) / float(count)
        at = start + inward * i
        rest = 1.0 - x
        work[gaps + at] = low + x * (rise + rest * (rest * (forward - rise) - x * (backward - rise)))
        work[longitudinal + at] = rest * work[longitudinal + start] + x * work[longitudinal + stop]
    return 0


def end_region(work: 'float[:]', block: int, direction: int, station: float):
    """Bound the region at ``station``: beyond it a profile ends, or the outline of a strongly yawed wheel folds back."""
    if direction > 0:
        if station < work[block + REGION_HIGH]:
            work[block + REGION_HIGH] = station
    elif station > work[block + REGION_LOW]:
        work[block + REGION_LOW] = station
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


def lateral_curvature(work: 'float[:]', region: int, k: int, window: int):
    """B [1/m] at node ``k``: see the head of this file."""
    gaps = node_field(region, NODE_GAP)
    spacing = work[region_block(region) + REGION_SPACING]
    least = FLOOR * work[node_field(region, NODE_A) + k]
    averaged = second_difference(work, gaps + k, spacing, window)
    if not averaged > least:
        averaged = least
    secant = 0.0
    if k >= window or k <= -window:
        s = spacing * float(k)
        secant = work[gaps + k] / (s * s)
    else:
        width = spacing * float(window)
        middle = second_difference(work, gaps, spacing, window)
        if middle < 0.0:
            middle = 0.0
        edge = work[gaps + window] / (width * width)
        if k < 0:
            edge = work[gaps - window] / (width * width)
        share = fabs(float(k)) / float(window)
        secant = middle + (edge - middle) * share
    if not secant > averaged:
        secant = averaged
    return sqrt(averaged * secant)


def weigh_nodes(tables: 'float[:]', work: 'float[:]', region: int, window: int):
    """ANALYN's coefficients at the region's nodes: (1 + beta) g, E*/(n r) and (1 + alpha) A."""
    block = region_block(region)
    gaps = node_field(region, NODE_GAP)
    longitudinal = node_field(region, NODE_A)
    rises = node_field(region, NODE_RISE)
    lines = node_field(region, NODE_LINE)
    lengths = node_field(region, NODE_LENGTH)
    curvatures = node_field(region, NODE_B)
    base = int(tables[SET_HERTZ])
    for k in range(int(work[block + REGION_FIRST]), int(work[block + REGION_LAST]) + 1):
        A = work[longitudinal + k]
        B = lateral_curvature(work, region, k, window)
        work[curvatures + k] = B
        one_alpha, one_beta, nr = hertz_coefficients(tables, base, A, B)
        work[rises + k] = one_beta * work[gaps + k]
        work[lines + k] = tables[SET_CONTACT_MODULUS] / nr
        work[lengths + k] = one_alpha * A
    return 0
