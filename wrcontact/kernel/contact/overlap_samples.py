"""Samples of the overlap of a pressed wheel at the scan nodes where the wheel is below the rail.

The overlap is taken straight down there and converted to the rail's normal.
"""

from math import fabs
from typing import Final

from ..layout import EXPONENTS, OVERLAP_LIMIT, Pair, Place, Samples, Scan, inlined, seldom
from ..search.bounds import (
    WIDEST,
    bend_shares,
    clear_exponent,
    largest_fall,
    rail_place,
    stretch_bounds,
)
from ..surface.gap import above_rail
from ..surface.locus import outline_jet, outline_point
from ..surface.tables import height_slope_bend

#: In place of how far aside the foot is [m].
FAR_ASIDE: Final[float] = 1.0
#: A wheel that is deeper in its rail than this [m] is sampled at every node: feet lie farther aside than
#: ``turns`` reach.
DEEPEST: Final[float] = 3e-4
#: What a turning normal takes from the slope counts so many times: its foot is found to first order [-].
TURNED: Final[float] = 1.5
#: Steps of the slope with which standard profiles are joined, a few in a stretch [-].
SLOPE_STEPS: Final[float] = 1e-4


@inlined
def sample_overlap(pair: Pair, samples: Samples, place: Place, node: int, height: float, entry: int):
    """Write scan node ``node`` to sample ``entry``; its vertical gap [m], slope difference [-] and rail
    abscissa [m]."""
    point = pair.scan.nodes[node]
    y = point.y
    y_track, z_track, outline_slope = outline_point(place, y, point.height, point.slope)
    abscissa = y_track - pair.rail_y
    z_rail, m, bend = height_slope_bend(pair.rail, abscissa)
    gap = z_rail - z_track
    square = 1.0 / (1.0 + m * m)
    samples.rail[entry] = abscissa
    samples.wheel[entry] = y
    # the slope of (height - gap) cos, divided by cos; where wheel and rail are apart, and the rail's normals
    # mean little, that of height - gap
    turn = 0.0
    if height > gap:
        turn = (height - gap) * m * bend * square
    samples.node[entry] = float(node)
    samples.gap[entry] = gap
    samples.aside[entry] = (height - gap) * m * square
    samples.rail_slope[entry] = m
    samples.rail_bend[entry] = bend
    samples.turn[entry] = turn
    samples.rise[entry] = outline_slope - m - turn
    return gap, m - outline_slope, abscissa


@seldom
def sample_end(pair: Pair, samples: Samples, direction: int, entry: int):
    """Let sample ``entry``, beyond the rail, stand for its end, with a slope that lets the last stretch be
    searched.

    Its foot is nowhere near.  It keeps its own wheel abscissa, less than a cell away: it may be the first
    one, whose neighbour is not sampled yet.
    """
    samples.rail[entry] = pair.rail.start
    samples.rise[entry] = 1.0
    samples.aside[entry] = FAR_ASIDE
    if direction > 0:
        samples.rail[entry] = pair.rail.stop
        samples.rise[entry] = -1.0


@seldom
def walk_overlap(
    pair: Pair, samples: Samples, place: Place, node: int, direction: int, height: float, first: int
):
    """Sample from scan node ``node`` on in ``direction`` (1 or -1), leaving out stretches where the wheel is
    above the rail, or where the overlap only falls; the entry after the last one.  Entries begin with
    ``first`` and run in ``direction``."""
    count = pair.scan.count
    entry = first
    exponent = EXPONENTS - 1
    falling = 1
    adjacent = 1.0
    while node >= 0 and node < count and entry > 0 and entry < 2 * OVERLAP_LIMIT - 1:
        gap, mismatch, abscissa = sample_overlap(pair, samples, place, node, height, entry)
        place.gap_count += 1.0
        on_rail = above_rail(pair, abscissa)
        if not on_rail:
            sample_end(pair, samples, direction, entry)
        if direction > 0:
            samples.adjacent[entry] = adjacent
        else:
            samples.adjacent[entry + 1] = adjacent
        entry += direction
        if not on_rail:
            return entry
        adjacent = 1.0
        step = 1
        if gap > height:
            exponent = clear_exponent(
                pair.scan,
                place,
                node,
                direction,
                abscissa,
                gap - height,
                float(direction) * mismatch,
                exponent,
            )
            if exponent < 0:
                exponent = 0
            elif exponent > 0:
                step = 1 << exponent
                adjacent = 0.0
            if exponent < EXPONENTS - 1:
                exponent += 1
        elif float(direction) * mismatch > 0.0 and height - gap < DEEPEST:
            falling = falling_exponent(
                pair.scan,
                place,
                node,
                direction,
                abscissa,
                height - gap,
                float(direction) * mismatch,
                falling,
            )
            if falling > 0:
                step = 1 << falling
                adjacent = 0.0
            falling = min(max(falling, 0) + 1, EXPONENTS - 1)
        node += direction * step
    return entry


@inlined
def falling_exponent(
    scan: Scan,
    at: Place,
    node: int,
    direction: int,
    abscissa: float,
    depth: float,
    slope: float,
    exponent: int,
):
    """The largest exponent, from ``exponent`` downwards, for which the overlap along the rail's normals only
    falls over the 2^exponent cells from ``node`` on, as long as there is one; -1 if there is none.

    depth : of the wheel below the rail at the node [m].
    slope : of rail minus outline at the node, seen in ``direction`` (1 or -1).

    The overlap along the normals falls with the slope of the gap straight down, but for what the turning
    normal takes from it: depth times ``turns`` at most, and depth falls.  What is left, s, stays above zero
    over a length L where (1 - stretch) s >= -(1 + stretch) bend L: where a gap whose slope begins with s / 2
    does not fall.
    """
    u = rail_place(scan, abscissa)
    least_stretch, stretch_per_bend, share = bend_shares(at)
    while exponent >= 0:
        length, stretch, bend, cell, reach = stretch_bounds(
            scan, node, direction, u, exponent, least_stretch, stretch_per_bend, share
        )
        if stretch < WIDEST:
            left = slope - TURNED * depth * scan.rail[cell].turns[reach] - SLOPE_STEPS
            if left > 0.0 and largest_fall(0.5 * left, bend, length, stretch) <= 0.0:
                return exponent
        exponent -= 1
    return exponent
