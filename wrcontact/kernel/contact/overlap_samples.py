"""Samples of the overlap of a pressed wheel at the scan nodes where the wheel is below the rail.

The overlap is taken straight down there and converted to the rail's normal.
"""

from typing import Final

from ..layout import EXPONENTS, OVERLAP_LIMIT, Pair, Place, Samples, inlined, seldom
from ..search.bounds import clear_exponent
from ..surface.gap import above_rail
from ..surface.locus import outline_jet, outline_point
from ..surface.tables import height_slope_bend

#: In place of how far aside the foot is [m].
FAR_ASIDE: Final[float] = 1.0


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
    above the rail; the entry after the last one.  Entries begin with ``first`` and run in ``direction``."""
    count = pair.scan.count
    entry = first
    exponent = EXPONENTS - 1
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
        node += direction * step
    return entry
