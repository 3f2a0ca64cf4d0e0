"""ANALYN on the nodes of up to four regions: from local penetrations to loads, and from a
force to penetrations.

Sichani, Enblom & Berg (2014).  In a region with local penetration D the strip at s is loaded where

    d(s) = D - (1 + beta) g > 0,   half-length a = sqrt(d / ((1 + alpha) A)),   p0 = (2 E*/pi) d / (n r a)

(the source's eq. 2.25 prints E*/(2 pi), which integrates to a quarter of the force), so the line load
(pi/2) a p0 = E* d / (n r) and the region's load is an integral without a root.

Regions press on each other: the local penetration of region i is the total penetration minus its smallest gap
minus its displacement by the loads of the others, sum_j N_j / (pi E* distance_ij) (Boussinesq;
docs/theory, (8.4)).  Where regions have planes of their own (:mod:`frame`), the penetration
counts by its share along each normal, and a displacement by the cosine of the angle between the two.
"""

from math import fabs, pi, sqrt
from typing import Final

from ..elementary.powers import cube_root
from ..layout import Nodes, NodesOfRegions, Region, Regions, Tables
from ..patch.quadrature import cell_part, full_cell, quadratic_integral

#: Share of the squares of two regions' half-lengths that counts as distance between them.
ELONGATED: Final[float] = 0.3
#: Cosine of the angle between two planes, 15 degrees.  Below it the lead of one region over the other counts
#: as distance.
INCLINED: Final[float] = 0.9659258262890683
FORCE_ITERATIONS: Final[int] = 60
#: The force is satisfied to this, relative; rounding of the sums is 1e-14.
FORCE_SHARP: Final[float] = 1e-12
#: Change of the load, relative, that tells the slope; and how far that may be from the slope's own estimate.
LOAD_ROUNDING: Final[float] = 1e-10
SLOPE_ERROR: Final[float] = 0.1
#: Missed by less, relative, the force is satisfied by one more move, Newton's method squaring what is missed.
NEARLY_SHARP: Final[float] = 1e-9
#: Missed by more, relative, the power 2/3 of the load is taken for linear in the penetration.
NEARLY: Final[float] = 1e-3
#: The total load says on which side the penetration lies only when the residuals are below this, relative.
CLOSED: Final[float] = 1e-10
#: The penetration is sought up to this multiple of the first value.
HIGHEST: Final[float] = 1e3


def region_influence(tables: Tables, one: Region, other: Region):
    """Displacement of region ``one`` under one newton on region ``other`` [m/N].

    Boussinesq's 1 / (pi E* distance).  The distance includes the lengths of the patches along the track and
    the lead of one region over the other.  The displacement counts by the cosine of the angle between the
    planes.
    """
    distance = one.offset + one.middle - other.offset - other.middle
    lead = region_lead(one, other)
    squares = one.square + other.square
    apart = sqrt(distance * distance + lead * lead + ELONGATED * squares)
    result = 1.0 / (pi * tables.contact_modulus * apart)
    result *= planes_cosine(one, other)
    return result


def region_lead(one: Region, other: Region):
    """How far region ``one`` of a yawed wheel lies ahead of region ``other`` along the track [m]; 0 if their
    planes form an angle of less than 15 degrees.

    A flange is 17 ... 31 mm ahead of the flange root and 7 mm beside it.  Between tread and flange root, 1
    ... 3 mm in 10, the lead is left out: the upright patches (docs/theory/strips.md) do without
    it, and the half-space agrees better.
    """
    lead = 0.0
    if planes_cosine(one, other) < INCLINED:
        lead = one.x_track - other.x_track
    return lead


def planes_cosine(one: Region, other: Region):
    """Cosine of the angle between the planes of two regions [-]; 1 in one plane, not below 0."""
    cosine = 1.0
    if one.own or other.own:
        cosine = max(one.cos * other.cos + one.sin * other.sin, 0.0)
    return cosine


def clip_to_bound(region: Region, k: int, outward: int, stop: float):
    """``stop`` of the cell outward of node ``k``, cut where the region's bound (a hump) crosses the cell."""
    reach = (region.high - region.station) / region.spacing - float(k)
    if outward < 0:
        reach = (region.station - region.low) / region.spacing + float(k)
    stop = max(min(stop, reach), 0.0)
    return stop


def region_load(region: Region, nodes: Nodes, local_penetration: float):
    """Load [N] of a region at a local penetration [m], and its derivative [N/m] to a few per mille."""
    load = 0.0
    stiffness = 0.0
    if local_penetration > 0.0:
        for outward in range(-1, 2, 2):
            last = region.last
            if outward < 0:
                last = -region.first
            d_before = local_penetration - nodes.rise[-outward]
            f_before = nodes.line[-outward] * d_before
            d_low = local_penetration - nodes.rise[0]
            c_low = nodes.line[0]
            f_low = c_low * d_low
            for k in range(last):
                at = outward * (k + 1)
                d_high = local_penetration - nodes.rise[at]
                c_high = nodes.line[at]
                f_high = c_high * d_high
                if d_low > 0.0 and d_high > 0.0 and k < last - 1:
                    load += full_cell(f_before, f_low, f_high)
                    stiffness += 0.5 * (c_low + c_high)
                elif d_low > 0.0 or d_high > 0.0:
                    start, stop = cell_part(d_before, d_low, d_high)
                    if k == last - 1:
                        stop = clip_to_bound(region, outward * k, outward, stop)
                    if stop > start:
                        load += quadratic_integral(f_before, f_low, f_high, stop) - quadratic_integral(
                            f_before, f_low, f_high, start
                        )
                        stiffness += (stop - start) * (c_low + 0.5 * (stop + start) * (c_high - c_low))
                d_before = d_low
                f_before = f_low
                d_low = d_high
                c_low = c_high
                f_low = f_high
    return load * region.spacing, stiffness * region.spacing


def load_regions(regions: Regions, nodes: NodesOfRegions, count: int):
    """Loads and stiffnesses of all regions at their local penetrations; the total of what counts for the
    prescribed force [N]."""
    total = 0.0
    for i in range(count):
        region = regions[i]
        load, stiffness = region_load(region, nodes[i], region.local_penetration)
        region.load = load
        region.stiffness = stiffness
        total += region.share * load
    return total


def solve_penetrations(
    tables: Tables,
    regions: Regions,
    nodes: NodesOfRegions,
    count: int,
    force: float,
    penetration: float,
    prescribed: bool,
):
    """Penetration [m] at which the regions carry ``force`` [N] (or the given one where ``prescribed``), by
    Newton's method on all local penetrations together; these and the loads stay in the regions.  Second
    value: whether the force is satisfied.
    """
    for i in range(count):
        region = regions[i]
        region.local_penetration = region.alignment * penetration - region.gap
    low = 0.0
    high = HIGHEST * penetration
    total_before = 0.0
    slope_before = 0.0
    move = 0.0
    for iteration in range(FORCE_ITERATIONS):
        regions[0].solve_count += 1.0
        total = load_regions(regions, nodes, count)
        residual, slope, rest = penetration_residuals(tables, regions, count, penetration)
        if count == 1 and iteration > 0 and fabs(total - total_before) > LOAD_ROUNDING * force:
            # the change of the load that the slopes of both ends predict for the last move, against the real
            # one
            share = (total - total_before) / (0.5 * (slope_before + slope) * move)
            if fabs(share - 1.0) < SLOPE_ERROR:
                slope *= share
        total_before = total
        slope_before = slope
        move = 0.0
        missed = 0.0
        if not prescribed:
            missed = fabs(force - total)
            if residual <= CLOSED * penetration and missed > 10.0 * CLOSED * force:
                if total < force:
                    low = penetration
                else:
                    high = penetration
            move = penetration_move(force, total, slope, rest, penetration, low, high)
        if missed <= FORCE_SHARP * force and residual <= FORCE_SHARP * penetration:
            return penetration, True
        penetration += move
        apply_moves(regions, count, move)
        if missed <= NEARLY_SHARP * force and residual <= NEARLY_SHARP * penetration:
            return penetration, True
    return penetration, False


def penetration_move(
    force: float, total: float, slope: float, rest: float, penetration: float, low: float, high: float
):
    """Move of the penetration [m] towards the ``force`` [N], from the ``total`` load that the regions carry
    now [N].

    slope : rate of the total load [N/m], once the local penetrations have closed their residuals.
    rest : load that closing them adds [N].
    low, high : bracket of the penetration [m], halved where Newton's method leaves it.

    The power 2/3 of the load is nearly linear in the penetration.
    """
    following = 0.5 * (low + high)
    if slope > 0.0:
        newton = penetration + (force - total - rest) / slope
        if fabs(force - total) > NEARLY * force and total > 0.0:
            root = cube_root(force / total)
            newton = penetration + (1.5 * total * (root * root - 1.0) - rest) / slope
        if newton > low and newton < high:
            following = newton
    return following - penetration


def penetration_residuals(tables: Tables, regions: Regions, count: int, penetration: float):
    """Linearise the local penetrations D_i: for each region its change per unit of penetration (region.slope)
    and the change that closes D_i = turn_i penetration - gap_i - sum_j c_ij N_j (region.move).

    Returns the largest residual [m], d(total load)/d(penetration) [N/m], and the load that the closing moves
    add [N]. Solved by Gauss-Seidel: the coupling of the regions is weak (c N / D < 0.2), three of them at
    most.
    """
    largest = 0.0
    for i in range(count):
        region = regions[i]
        pushed = 0.0
        for j in range(count):
            if j != i:
                pushed += region_influence(tables, region, regions[j]) * regions[j].load
        turn = region.alignment
        residual = turn * penetration - region.gap - pushed - region.local_penetration
        region.residual = residual
        region.slope = turn
        region.move = residual
        largest = max(largest, fabs(residual))
    sweeps = 12
    if count == 1:
        sweeps = 0
    for sweep in range(sweeps):
        for i in range(count):
            region = regions[i]
            slope = region.alignment
            move = region.residual
            for j in range(count):
                if j != i:
                    other = regions[j]
                    coupling = region_influence(tables, region, other) * other.stiffness
                    slope -= coupling * other.slope
                    move -= coupling * other.move
            region.slope = slope
            region.move = move
    slope = 0.0
    rest = 0.0
    for i in range(count):
        region = regions[i]
        counted = region.share * region.stiffness
        slope += counted * region.slope
        rest += counted * region.move
    return largest, slope, rest


def apply_moves(regions: Regions, count: int, move: float):
    """Move the local penetrations with the penetration, by ``move`` [m], and close their residuals."""
    for i in range(count):
        region = regions[i]
        region.local_penetration += region.move + region.slope * move
