"""ANALYN on the nodes of up to three regions: from levels to loads, and from a force to levels.

Sichani, Enblom & Berg (2014).  In a region with local penetration D (its level) the strip at s is loaded where

    d(s) = D - (1 + beta) g > 0,   half-length a = sqrt(d / ((1 + alpha) A)),   p0 = (2 E*/pi) d / (n r a)

(the source's eq. 2.25 prints E*/(2 pi), which integrates to a quarter of the force), so the line load
(pi/2) a p0 = E* d / (n r) and the region's load is an integral without a root.

Regions press on each other: the level of region i is the total penetration minus its smallest gap minus what the loads
of the others push the half-space down there, sum_j N_j / (pi E* distance_ij) (Boussinesq; docs/method.md).  Where regions
have planes of their own (:mod:`planes`), the penetration counts by its share along each normal, and a push by the cosine of
the angle between the two.
"""

from math import fabs, sqrt
from typing import Final

from ..layout import Region, State, Tables, Work
from ..patch.quadrature import bend_of, cell_part, quadratic_integral
from .interaction import region_influence
from .nodes import NODE_LINE, NODE_RISE, node_field

FORCE_ITERATIONS: Final[int] = 60
#: The force is met to this, relative; rounding of the sums is 1e-14.
FORCE_SHARP: Final[float] = 1e-12
#: Change of the load, relative, that tells the slope; and how far that may be from the slope's own estimate.
ROUNDING: Final[float] = 1e-10
SLOPE_ERROR: Final[float] = 0.1
#: Missed by less, relative, the force is met by one more move, Newton's method squaring what is missed.
NEARLY_SHARP: Final[float] = 1e-9
#: Missed by more, relative, the power 2/3 of the load is taken for linear in the penetration.
NEARLY: Final[float] = 1e-3
#: The total load tells on which side the penetration lies only when the levels are closed to this, relative.
CLOSED: Final[float] = 1e-10
#: The penetration is sought up to this multiple of the first value.
HIGHEST: Final[float] = 1e3


def clip_to_bound(block: Region, k: int, outward: int, stop: float):
    """``stop`` of the cell outward of node ``k``, cut where the region's bound (a hump) crosses the cell."""
    spacing = block.spacing
    reach = (block.high - block.station) / spacing - float(k)
    if outward < 0:
        reach = (block.station - block.low) / spacing + float(k)
    if reach < stop:
        stop = reach
    if stop < 0.0:
        stop = 0.0
    return stop


def region_load(work: Work, region: int, level: float):
    """Load [N] of ``region`` at local penetration ``level`` [m], and its derivative [N/m] to a few per mille."""
    block = work.regions[region]
    spacing = block.spacing
    rises = node_field(region, NODE_RISE)
    lines = node_field(region, NODE_LINE)
    load = 0.0
    stiffness = 0.0
    if level > 0.0:
        for outward in range(-1, 2, 2):
            last = block.last
            if outward < 0:
                last = -block.first
            d_before = level - work[rises - outward]
            c_before = work[lines - outward]
            d_low = level - work[rises]
            c_low = work[lines]
            for k in range(last):
                at = outward * (k + 1)
                d_high = level - work[rises + at]
                c_high = work[lines + at]
                f_low = c_low * d_low
                f_high = c_high * d_high
                if d_low > 0.0 and d_high > 0.0 and k < last - 1:
                    # a fully loaded cell: quadratic_integral from 0 to 1
                    load += 0.5 * (f_low + f_high) - bend_of(c_before * d_before, f_low, f_high) / 6.0
                    stiffness += 0.5 * (c_low + c_high)
                elif d_low > 0.0 or d_high > 0.0:
                    start, stop = cell_part(d_before, d_low, d_high)
                    if k == last - 1:
                        stop = clip_to_bound(block, outward * k, outward, stop)
                    if stop > start:
                        load += quadratic_integral(c_before * d_before, f_low, f_high, start, stop)
                        stiffness += (stop - start) * (c_low + 0.5 * (stop + start) * (c_high - c_low))
                d_before = d_low
                c_before = c_low
                d_low = d_high
                c_low = c_high
    return load * spacing, stiffness * spacing


def load_regions(tables: 'float[:]', work: Work, count: int):
    """Loads and stiffnesses of all regions at their levels; the total of what counts for the prescribed force [N]."""
    total = 0.0
    for i in range(count):
        block = work.regions[i]
        load, stiffness = region_load(work, i, block.level)
        block.load = load
        block.stiffness = stiffness
        total += block.share * load
    return total


def solve_levels(tables: Tables, work: Work, state: State, count: int, force: float, penetration: float,
                 prescribed: int, sharp: float):
    """Penetration [m] at which the regions carry ``force`` [N] (or the given one where ``prescribed``), by Newton on
    all levels together, to ``sharp``, relative; levels and loads stay in the regions.  Second value: 1 when met, else 0.
    """
    for i in range(count):
        work.regions[i].level = (work.regions[i].turn * penetration
                                                - work.regions[i].gap)
    low = 0.0
    high = HIGHEST * penetration
    total_before = 0.0
    slope_before = 0.0
    move = 0.0
    for iteration in range(FORCE_ITERATIONS):
        state.solve_count += 1.0
        total = load_regions(tables.raw, work, count)
        residual, slope, rest = level_residuals(tables, work, count, penetration)
        if count == 1 and iteration > 0 and fabs(total - total_before) > ROUNDING * force:
            # what the slopes of both ends made of the last move, against what came of it
            share = (total - total_before) / (0.5 * (slope_before + slope) * move)
            if fabs(share - 1.0) < SLOPE_ERROR:
                slope *= share
        total_before = total
        slope_before = slope
        move = 0.0
        missed = 0.0
        if prescribed == 0:
            missed = fabs(force - total)
            if residual <= CLOSED * penetration and missed > 10.0 * CLOSED * force:
                if total < force:
                    low = penetration
                else:
                    high = penetration
            following = 0.5 * (low + high)
            # the levels follow the penetration by their slopes, after closing their own residuals; the load's power 2/3
            # is nearly linear
            if slope > 0.0:
                newton = penetration + (force - total - rest) / slope
                if missed > NEARLY * force and total > 0.0:
                    newton = penetration + (1.5 * total * ((force / total) ** (2.0 / 3.0) - 1.0) - rest) / slope
                if newton > low and newton < high:
                    following = newton
            move = following - penetration
        if missed <= sharp * force and residual <= sharp * penetration:
            return penetration, 1
        penetration += move
        apply_moves(work, count, move)
        if missed <= NEARLY_SHARP * force and residual <= NEARLY_SHARP * penetration:
            return penetration, 1
    return penetration, 0


def level_residuals(tables: Tables, work: Work, count: int, penetration: float):
    """Linearised levels: for each region the move per unit of penetration (REGION_SLOPE) and the move that closes
    level_i = turn_i penetration - gap_i - sum_j c_ij N_j (REGION_MOVE).

    Returns the largest residual [m], d(total load)/d(penetration) [N/m], and the load that the closing moves add [N].
    Solved by Gauss-Seidel: the regions' coupling is weak (c N/level < 0.2), three of them at most.
    """
    largest = 0.0
    for i in range(count):
        block = work.regions[i]
        pushed = 0.0
        for j in range(count):
            if j != i:
                pushed += region_influence(tables, block, work.regions[j]) * work.regions[j].load
        turn = block.turn
        residual = turn * penetration - block.gap - pushed - block.level
        block.residual = residual
        block.slope = turn
        block.move = residual
        if fabs(residual) > largest:
            largest = fabs(residual)
    sweeps = 12
    if count == 1:
        sweeps = 0
    for sweep in range(sweeps):
        for i in range(count):
            block = work.regions[i]
            slope = block.turn
            move = block.residual
            for j in range(count):
                if j != i:
                    other = work.regions[j]
                    coupling = region_influence(tables, block, other) * other.stiffness
                    slope -= coupling * other.slope
                    move -= coupling * other.move
            block.slope = slope
            block.move = move
    slope = 0.0
    rest = 0.0
    for i in range(count):
        block = work.regions[i]
        counted = block.share * block.stiffness
        slope += counted * block.slope
        rest += counted * block.move
    return largest, slope, rest


def apply_moves(work: Work, count: int, move: float):
    """Move the levels with the penetration by ``move`` [m] and close their residuals."""
    for i in range(count):
        block = work.regions[i]
        block.level += block.move + block.slope * move
    return 0
