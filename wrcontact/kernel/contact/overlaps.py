"""Where a pressed wheel overlaps its rail: the deepest point of every region, and the saddles between them.

Between two samples (:mod:`overlap_samples`) where the overlap changes from rising to falling lies a deepest
point, which is located along the rail's normals (:mod:`pressed`, :mod:`touching`).  Two with a low saddle
between them are one region (deep_points.MERGE).
"""

from math import fabs
from typing import Final

from ..layout import OVERLAP_LIMIT, Frame, Overlap, Place, Samples, SideSearch, State, Tables
from ..search.bounds import bend_bounds, only_rises_or_falls
from ..search.raster import node_below
from ..surface.locus import outline_point
from ..surface.profile_table import height_slope
from .deep_points import append_point, deepest_entry, is_listed, merge_points, sort_last
from .overlap_samples import walk_overlap
from .pressed import LINE_SHARP, normal_line
from .touching import turning_point

#: Between two samples the overlap is examined in this many parts.
OVERLAP_PARTS: Final[int] = 4
#: The same where the samples do not show whether it turns.
HIDDEN_PARTS: Final[int] = 8
#: Bounds of the bend along the rail's normals are wider than those straight down by this share of the wheel's
#: bend: an overlap of 100 micrometres over a rail of 13 mm radius, and more.
NORMAL_SHARE: Final[float] = 0.01
#: The deepest point beside the smallest gap is sought in steps that double from the first one on, up to the
#: other [m].
FIRST_STEP: Final[float] = 1e-7
FAR_STEP: Final[float] = 1e-3
#: Steps that a deepest point is sought beyond its two samples.
WIDENINGS: Final[int] = 6


def find_overlaps(tables: Tables, frame: Frame, overlap: Overlap, side: SideSearch, state: State,
                  height: float):
    """List the regions in which the wheel of ``side``, moved down by ``height`` [m], overlaps its rail; their
    number."""
    place = side.place
    samples = overlap.samples
    node = node_below(tables.scan, side.best_y)
    overlap.count = 0
    overlap.height = height
    start = walk_overlap(tables, samples, place, state, node, -1, height, OVERLAP_LIMIT - 1) + 1
    stop = walk_overlap(tables, samples, place, state, node + 1, 1, height, OVERLAP_LIMIT)
    for entry in range(start, stop - 1):
        if samples.adjacent[entry + 1] == 1.0:
            list_in_cell(tables, frame, overlap, place, entry)
    list_beside_smallest_gap(tables, frame, overlap, side)
    if overlap.count > 0:
        find_saddles(tables, frame, overlap, place)
        merge_points(overlap)
    return overlap.count


def list_in_cell(tables: Tables, frame: Frame, overlap: Overlap, place: Place, entry: int):
    """List the deepest points between the sample ``entry`` and the next one."""
    samples = overlap.samples
    first = samples.rise[entry]
    last = samples.rise[entry + 1]
    hidden = may_turn(tables, samples, place, entry)
    if hidden == 0 and not (first > 0.0 and last <= 0.0):
        return 0
    low = samples.rail[entry]
    high = samples.rail[entry + 1]
    y = 0.5 * (samples.wheel[entry] + samples.wheel[entry + 1])
    least, most = bend_bounds(tables.scan, place, node_below(tables.scan, samples.wheel[entry]), low)
    if hidden == 1:
        # the samples are straight down: what counts is the rise along the normal
        first = normal_rise(tables, frame, overlap, place, low, samples.wheel[entry])
        last = normal_rise(tables, frame, overlap, place, high, samples.wheel[entry + 1])
        least, most = wider_bounds(tables, samples, place, entry, least, most)
        width = samples.wheel[entry + 1] - samples.wheel[entry]
        if only_rises_or_falls(least, most, width, -first, -last) == 1:
            return 0
    listed = 0
    if least > 0.0:
        # it has one largest value at most
        if first <= 0.0 or last > 0.0:
            return 0
        listed = list_turning_point(tables, frame, overlap, place, low, high, y)
    if listed == 0:
        parts = HIDDEN_PARTS
        if hidden == 0 or (first > 0.0 and last <= 0.0):
            parts = OVERLAP_PARTS
        if hidden == 0:
            step = high - low
            low = bracket_end(tables, frame, overlap, place, low, -step, y)
            high = bracket_end(tables, frame, overlap, place, high, step, y)
        list_between(tables, frame, overlap, place, low, high, y, parts)
    return 0


def normal_rise(tables: Tables, frame: Frame, overlap: Overlap, place: Place, x: float, y: float):
    """Rise of the overlap along the normal at rail abscissa ``x`` [m], sought from the wheel's ``y`` [m]; 0
    where there is none."""
    y, depth, rise, bend, curvature, found = normal_line(tables, frame, place, x, y, overlap.height,
                                                         LINE_SHARP)
    if found == 0:
        rise = 0.0
    return rise


def wider_bounds(tables: Tables, samples: Samples, place: Place, entry: int, least: float, most: float):
    """The bounds [1/m] of the bend of the gap straight down between the sample ``entry`` and the next one,
    widened to those of the bend along the normals.

    A normal meets the wheel aside of the sample, in the next cell at most, and by a share of NORMAL_SHARE
    sooner or later.
    """
    scan = tables.scan
    node = node_below(scan, samples.wheel[entry])
    if node > 0:
        low, high = bend_bounds(scan, place, node - 1, samples.rail[entry])
        least = min(least, low)
        most = max(most, high)
    if node + 2 < scan.count:
        low, high = bend_bounds(scan, place, node + 1, samples.rail[entry])
        least = min(least, low)
        most = max(most, high)
    share = NORMAL_SHARE * scan.nodes[node].steepest_bends[0]
    return least - share, most + share


def list_turning_point(tables: Tables, frame: Frame, overlap: Overlap, place: Place, low: float,
                       high: float, y: float):
    """List the deepest point between two rail abscissae [m], sought from the wheel's ``y`` [m], if there is
    an overlap and it is not listed yet; 1 if there is a turning point, else 0."""
    rail, wheel, depth, turned = turning_point(tables, frame, place, low, high, y, overlap.height, 1.0)
    if turned == 1 and depth > 0.0 and is_listed(overlap, rail) == 0:
        append_point(overlap, rail, wheel, depth)
    return turned


def may_turn(tables: Tables, samples: Samples, place: Place, entry: int):
    """1 if between the sample ``entry`` and the next one the overlap may turn unseen by both, else 0."""
    rise = samples.rise[entry]
    following = samples.rise[entry + 1]
    answer = 0
    if min(fabs(rise), fabs(following)) < fabs(samples.turn[entry]) + fabs(samples.turn[entry + 1]):
        # the bounds are those of the overlap straight down
        answer = 1
    elif rise * following > 0.0:
        node = node_below(tables.scan, samples.wheel[entry])
        least, most = bend_bounds(tables.scan, place, node, samples.rail[entry])
        if least < 0.0:
            width = samples.wheel[entry + 1] - samples.wheel[entry]
            answer = 1 - only_rises_or_falls(least, most, width, -rise, -following)
    return answer


def bracket_end(tables: Tables, frame: Frame, overlap: Overlap, place: Place, x: float, step: float,
                y: float):
    """``x``, or the first place some ``step`` [m] further, from where the overlap rises towards the other
    side: the samples are straight down, and their slope may change its sign a little before the overlap along
    the normal has its maximum."""
    rail = tables.rail
    for i in range(WIDENINGS):
        if x <= rail.start:
            return rail.start
        if x >= rail.stop:
            return rail.stop
        y, depth, rise, bend, curvature, found = normal_line(tables, frame, place, x, y, overlap.height,
                                                             LINE_SHARP)
        if found == 0 or rise * step < 0.0:
            break
        x += step
    return x


def list_between(tables: Tables, frame: Frame, overlap: Overlap, place: Place, low: float, high: float,
                 y: float, parts: int):
    """List the deepest points between two rail abscissae, which are examined in ``parts``: on nearly
    conformal profiles the joints of their arcs leave several, of which a bracket by itself would end at
    either.  Where it is examined in OVERLAP_PARTS, the overlap rises at one end and falls at the other."""
    step = (high - low) / float(parts)
    start = low
    estimate = y
    rising = 1
    if parts == HIDDEN_PARTS and normal_rise(tables, frame, overlap, place, low, y) <= 0.0:
        rising = 0
    for i in range(1, parts + 1):
        stop = low + step * float(i)
        falls = 1
        if i < parts or parts == HIDDEN_PARTS:
            near, depth, rise, bend, curvature, found = normal_line(tables, frame, place, stop, estimate,
                                                                    overlap.height, LINE_SHARP)
            if found == 1:
                estimate = near
            if found == 1 and rise > 0.0:
                falls = 0
        if rising == 1 and falls == 1:
            list_turning_point(tables, frame, overlap, place, start, stop, estimate)
        rising = 1 - falls
        start = stop
    return 0


def list_beside_smallest_gap(tables: Tables, frame: Frame, overlap: Overlap, side: SideSearch):
    """List the deepest point beside the smallest gap where none on the list is as deep as the overlap there:
    between two scan nodes on nearly conformal profiles the slope of the overlap can change its sign three
    times."""
    place = side.place
    z, slope = height_slope(tables.wheel, side.best_y)
    y_track, z_track, outline_slope = outline_point(place, side.best_y, z, slope)
    x = y_track - tables.rail_y
    y, depth, rise, bend, curvature, found = normal_line(tables, frame, place, x, side.best_y, overlap.height,
                                                         LINE_SHARP)
    deepest = 0.0
    if overlap.count > 0:
        deepest = overlap.points[deepest_entry(overlap)].depth
    if found == 1 and depth > deepest:
        step = FIRST_STEP
        if rise < 0.0:
            step = -FIRST_STEP
        far = x
        while rise * step > 0.0 and fabs(far - x) < FAR_STEP and found == 1:
            far += step
            y, depth, rise, bend, curvature, found = normal_line(tables, frame, place, far, y, overlap.height,
                                                                 LINE_SHARP)
            step *= 2.0
        low = x
        high = far
        if far < x:
            low = far
            high = x
        rail, wheel, depth, turned = turning_point(tables, frame, place, low, high, side.best_y,
                                                  overlap.height, 1.0)
        if turned == 1 and depth > deepest:
            append_point(overlap, rail, wheel, depth)
            sort_last(overlap)
    return 0


def find_saddles(tables: Tables, frame: Frame, overlap: Overlap, place: Place):
    """The smallest overlap between neighbouring deepest points."""
    for entry in range(overlap.count - 1):
        point = overlap.points[entry]
        following = overlap.points[entry + 1]
        x, y, depth, turned = turning_point(tables, frame, place, point.rail, following.rail,
                                            0.5 * (point.wheel + following.wheel), overlap.height, -1.0)
        point.saddle = x
        point.between = depth
    return 0
