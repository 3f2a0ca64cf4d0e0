"""Where a pressed wheel overlaps its rail: the deepest point of every region, and the saddles between them.

Between two samples (:mod:`overlap_samples`) where the overlap changes from rising to falling lies a deepest
point, which is located along the rail's normals (:mod:`penetrated`).  Where more than one may lie between them,
both samples say how many there are (:mod:`turning_cells`), or the stretch is searched.  Two with a low saddle
between them are one region (penetration_maxima.MERGE).
"""

from math import fabs, sqrt
from typing import Final

from ..layout import (
    OVERLAP_LIMIT,
    Overlap,
    Pair,
    Place,
    RisePoint,
    Samples,
    SideSearch,
    Stretch,
    copy,
    inlined,
    seldom,
)
from ..search.bounds import bend_bounds, node_below, only_rises_or_falls
from ..surface.locus import outline_point
from ..surface.tables import height_slope
from .penetration_maxima import append_point, deepest_entry, is_listed, merge_points, sort_last
from .overlap_samples import walk_overlap
from .turning_cells import UNCLEAR, count_turns, foot_aside, list_from_samples
from .penetrated import LINE_SHARP, NODE_SHARP, meet_wheel, turning_point

#: Between two samples the overlap is examined in this many parts at most; in half as many where both samples
#: show that it turns.
PARTS: Final[int] = 8
HIDDEN_PART: Final[int] = 1
OVERLAP_PART: Final[int] = 2
#: Bounds of the bend along the rail's normals are wider than those straight down by this share of the wheel's
#: bend: an overlap of 100 micrometres over a rail of 13 mm radius, and more.
NORMAL_SHARE: Final[float] = 0.01
#: Cuts of a part while the tangents of the rise leave room for a hump.
HUMP_ITERATIONS: Final[int] = 20
#: The deepest point beside the smallest gap is sought in steps that double from the first one on, up to the
#: other [m].
FIRST_STEP: Final[float] = 1e-7
FAR_STEP: Final[float] = 1e-3
#: Steps that a deepest point is sought beyond its two samples.
WIDENINGS: Final[int] = 6


@seldom
def find_overlaps(pair: Pair, overlap: Overlap, side: SideSearch, height: float):
    """List the regions in which the wheel of ``side``, moved down by ``height`` [m], overlaps its rail; their
    number."""
    list_deep_points(pair, overlap, side, height)
    if overlap.count > 0:
        merge_points(pair, overlap)
    return overlap.count


@seldom
def list_deep_points(pair: Pair, overlap: Overlap, side: SideSearch, height: float):
    """The same of all deepest points, before those of one region are joined."""
    place = side.place
    samples = overlap.samples
    node = node_below(pair.scan, side.best_y)
    overlap.count = 0
    overlap.height = height
    overlap.stretch.known = -1
    start = walk_overlap(pair, samples, place, node, -1, height, OVERLAP_LIMIT - 1) + 1
    stop = walk_overlap(pair, samples, place, node + 1, 1, height, OVERLAP_LIMIT)
    searched = False
    for entry in range(start, stop - 1):
        if samples.adjacent[entry + 1] == 1.0:
            if list_in_cell(pair, overlap, place, entry):
                searched = True
    if searched or overlap.count == 0:
        list_beside_smallest_gap(pair, overlap, side)
    if overlap.count > 0:
        find_saddles(pair, overlap, place)


@seldom
def list_in_cell(pair: Pair, overlap: Overlap, place: Place, entry: int) -> bool:
    """List the deepest points between the sample ``entry`` and the next one; whether that took a search."""
    samples = overlap.samples
    rise = samples.rise[entry]
    following = samples.rise[entry + 1]
    hidden = may_turn(pair, samples, place, entry)
    if not hidden and not (rise > 0.0 and following <= 0.0):
        return False
    turns = count_turns(pair, overlap, place, entry)
    if turns == 1 and list_from_samples(pair, overlap, place, entry):
        turns = 0
    if turns > 0:
        search_cell(pair, overlap, place, entry, hidden)
    return turns > 0


@seldom
def search_cell(pair: Pair, overlap: Overlap, place: Place, entry: int, hidden: bool):
    """The same by a search, of a cell in which the overlap may turn unseen if ``hidden``."""
    samples = overlap.samples
    open_stretch(pair, overlap, place, entry)
    stretch = overlap.stretch
    finest = OVERLAP_PART
    listed = False
    if hidden:
        # the samples are straight down: what counts is the rise along the normal
        widen_bounds(pair, overlap, place, entry)
        if stretch.known == entry:
            copy(stretch.end, stretch.first)
        else:
            measure_rise(pair, overlap, place, stretch.first, samples.wheel[entry])
        measure_rise(pair, overlap, place, stretch.last, samples.wheel[entry + 1])
        copy(stretch.last, stretch.end)
        stretch.known = entry + 1
        finest = HIDDEN_PART
    elif stretch.least > 0.0:
        listed = list_turning_point(pair, overlap, place, stretch.first.x, stretch.last.x, stretch.wheel)
    else:
        widen_bounds(pair, overlap, place, entry)
    if not listed:
        if not hidden:
            stretch.least = min(stretch.least, 0.0)
            widen_stretch(pair, overlap, place)
        list_on_stretch(pair, overlap, place, finest)


@seldom
def open_stretch(pair: Pair, overlap: Overlap, place: Place, entry: int):
    """Open the stretch between the sample ``entry`` and the next one, with bounds for the overlap straight
    down."""
    samples = overlap.samples
    stretch = overlap.stretch
    # from foot to foot where cells beside it are judged from their samples
    low = samples.rail[entry] + min(foot_aside(samples, entry), 0.0)
    high = samples.rail[entry + 1] + max(foot_aside(samples, entry + 1), 0.0)
    set_point(stretch.first, max(low, pair.rail.start), samples.rise[entry], 0.0)
    set_point(stretch.last, min(high, pair.rail.stop), samples.rise[entry + 1], 0.0)
    stretch.wheel = 0.5 * (samples.wheel[entry] + samples.wheel[entry + 1])
    stretch.width = samples.wheel[entry + 1] - samples.wheel[entry]
    node = int(samples.node[entry])
    stretch.least, stretch.most = bend_bounds(pair.scan, place, node, samples.rail[entry])


@seldom
def set_point(point: RisePoint, x: float, rise: float, rate: float):
    """Write a place [m] with its rise [-] and the derivative of that [1/m]."""
    point.x = x
    point.rise = rise
    point.rate = rate


@seldom
def measure_rise(pair: Pair, overlap: Overlap, place: Place, point: RisePoint, y: float):
    """Rise of the overlap along the normal at ``point``, sought from the wheel's ``y`` [m]; zeros where there
    is none."""
    point.rise = 0.0
    point.rate = 0.0
    if meet_wheel(pair, place, point.x, y, overlap.height, NODE_SHARP):
        z_rail, slope = height_slope(pair.rail, point.x)
        point.rise = place.meeting.rise
        point.rate = place.meeting.rate * sqrt(1.0 + slope * slope)


@seldom
def widen_bounds(pair: Pair, overlap: Overlap, place: Place, entry: int):
    """Widen the bounds of the stretch after the sample ``entry`` to those of the bend along the normals.

    A normal meets the wheel aside of the sample, in the next cell at most, and by a share of NORMAL_SHARE
    sooner or later.
    """
    scan = pair.scan
    stretch = overlap.stretch
    node = int(overlap.samples.node[entry])
    if node > 0:
        low, high = bend_bounds(scan, place, node - 1, stretch.first.x)
        stretch.least = min(stretch.least, low)
        stretch.most = max(stretch.most, high)
    if node + 2 < scan.count:
        low, high = bend_bounds(scan, place, node + 1, stretch.first.x)
        stretch.least = min(stretch.least, low)
        stretch.most = max(stretch.most, high)
    share = NORMAL_SHARE * scan.nodes[node].steepest_bends[0]
    stretch.least -= share
    stretch.most += share


@seldom
def list_turning_point(pair: Pair, overlap: Overlap, place: Place, low: float, high: float, y: float) -> bool:
    """List the deepest point between two rail abscissae [m], sought from the wheel's ``y`` [m], if there is
    an overlap and it is not listed yet; whether there is a turning point."""
    rail, turned = turning_point(pair, place, low, high, 0.5 * (low + high), y, overlap.height, 1.0)
    if turned and place.meeting.overlap > 0.0 and not is_listed(overlap, rail):
        append_point(overlap, rail, place.meeting)
    return turned


@inlined
def may_turn(pair: Pair, samples: Samples, place: Place, entry: int) -> bool:
    """Whether between the sample ``entry`` and the next one the overlap may turn unseen by both."""
    rise = samples.rise[entry]
    following = samples.rise[entry + 1]
    answer = False
    if min(fabs(rise), fabs(following)) < fabs(samples.turn[entry]) + fabs(samples.turn[entry + 1]):
        # the bounds are those of the overlap straight down
        answer = True
    elif rise * following > 0.0:
        node = int(samples.node[entry])
        least, most = bend_bounds(pair.scan, place, node, samples.rail[entry])
        if least < 0.0:
            width = samples.wheel[entry + 1] - samples.wheel[entry]
            answer = not only_rises_or_falls(least, most, width, -rise, -following)
    return answer


@seldom
def widen_stretch(pair: Pair, overlap: Overlap, place: Place):
    """Widen the stretch until the overlap rises from its first end and falls to its last one: the samples are
    straight down, and their slope may change its sign a little before the overlap along the normal has its
    maximum."""
    stretch = overlap.stretch
    step = stretch.last.x - stretch.first.x
    low = bracket_end(pair, overlap, place, stretch.first.x, -step)
    high = bracket_end(pair, overlap, place, stretch.last.x, step)
    stretch.width *= (high - low) / step
    stretch.first.x = low
    stretch.last.x = high


@seldom
def bracket_end(pair: Pair, overlap: Overlap, place: Place, x: float, step: float):
    """``x``, or the first place some ``step`` [m] further, from where the overlap rises towards the other
    side."""
    rail = pair.rail
    y = overlap.stretch.wheel
    for i in range(WIDENINGS):
        if x <= rail.start:
            return rail.start
        if x >= rail.stop:
            return rail.stop
        if not meet_wheel(pair, place, x, y, overlap.height, LINE_SHARP):
            break
        if place.meeting.rise * step < 0.0:
            break
        y = place.meeting.wheel
        x += step
    return x


@seldom
def list_on_stretch(pair: Pair, overlap: Overlap, place: Place, finest: int):
    """List the deepest points on the stretch: on nearly conformal profiles the joints of their arcs leave
    several, of which a bracket by itself would end at either.

    It is halved until the bounds show that the overlap has one largest value at most on each part, or a part
    is ``finest`` of the PARTS.  There the tangents of the rise show what may still be hidden.
    """
    stretch = overlap.stretch
    before = stretch.before
    after = stretch.after
    each = (stretch.last.x - stretch.first.x) / float(PARTS)
    copy(stretch.first, before)
    start = 0
    size = PARTS
    while start < PARTS:
        stop = start + size
        if stop < PARTS:
            after.x = stretch.first.x + each * float(stop)
            measure_rise(pair, overlap, place, after, wheel_beside(stretch, float(stop)))
        else:
            copy(stretch.last, after)
        once = turns_once(stretch, float(size) / float(PARTS))
        if size > finest and not once:
            size = size // 2
        else:
            if before.rise > 0.0 and after.rise <= 0.0:
                list_turning_point(
                    pair, overlap, place, before.x, after.x, wheel_beside(stretch, 0.5 * float(start + stop))
                )
            elif not once:
                list_hidden_point(pair, overlap, place)
            copy(after, before)
            start = stop
            while start < PARTS and size < PARTS and start % (2 * size) == 0:
                size = 2 * size


@seldom
def wheel_beside(stretch: Stretch, parts: float):
    """About which wheel abscissa [m] belongs to the place that many ``parts`` after the first end of the
    stretch."""
    return stretch.wheel + (parts / float(PARTS) - 0.5) * stretch.width


@seldom
def turns_once(stretch: Stretch, share: float) -> bool:
    """Whether the overlap certainly has one largest value at most on the open part, a ``share`` of the
    stretch."""
    before = stretch.before.rise
    after = stretch.after.rise
    answer = False
    if stretch.least > 0.0:
        answer = True
    elif before * after > 0.0:
        answer = only_rises_or_falls(stretch.least, stretch.most, share * stretch.width, -before, -after)
    return answer


@seldom
def list_hidden_point(pair: Pair, overlap: Overlap, place: Place):
    """List the deepest point of a hump on the open part if the overlap rises, or falls, at both ends of it.

    A rise that bends one way, or has one kink, is nowhere beyond its tangents at both ends.  While those
    meet beyond zero, the rise is measured where they meet, and the part ends there.
    """
    stretch = overlap.stretch
    low = stretch.low
    high = stretch.high
    middle = stretch.middle
    copy(stretch.before, low)
    copy(stretch.after, high)
    sign = 1.0
    if low.rise < 0.0:
        sign = -1.0
    for i in range(HUMP_ITERATIONS):
        if not (low.rise * high.rise > 0.0 and sign * low.rate < 0.0 and sign * high.rate > 0.0):
            return
        width = high.x - low.x
        step = (low.rise - high.rise + high.rate * width) / (high.rate - low.rate)
        if sign * (low.rise + low.rate * step) > 0.0:
            return
        if not (step > 0.0 and step < width):
            step = 0.5 * width
        middle.x = low.x + step
        measure_rise(pair, overlap, place, middle, stretch.wheel)
        if sign * middle.rise < 0.0:
            if sign > 0.0:
                list_turning_point(pair, overlap, place, low.x, middle.x, stretch.wheel)
            else:
                list_turning_point(pair, overlap, place, middle.x, high.x, stretch.wheel)
            return
        if sign * middle.rate < 0.0:
            copy(middle, low)
        else:
            copy(middle, high)


@seldom
def list_beside_smallest_gap(pair: Pair, overlap: Overlap, side: SideSearch):
    """List the deepest point beside the smallest gap where none on the list is as deep as the overlap there:
    between two scan nodes on nearly conformal profiles the slope of the overlap can change its sign three
    times."""
    place = side.place
    z, slope = height_slope(pair.wheel, side.best_y)
    y_track, z_track, outline_slope = outline_point(place, side.best_y, z, slope)
    x = y_track - pair.rail_y
    meeting = place.meeting
    found = meet_wheel(pair, place, x, side.best_y, overlap.height, LINE_SHARP)
    deepest = 0.0
    if overlap.count > 0:
        deepest = overlap.points[deepest_entry(overlap)].depth
    if found and meeting.overlap > deepest:
        step = FIRST_STEP
        if meeting.rise < 0.0:
            step = -FIRST_STEP
        far = x
        while meeting.rise * step > 0.0 and fabs(far - x) < FAR_STEP and found:
            far += step
            found = meet_wheel(pair, place, far, meeting.wheel, overlap.height, LINE_SHARP)
            step *= 2.0
        low = x
        high = far
        if far < x:
            low = far
            high = x
        rail, turned = turning_point(
            pair, place, low, high, 0.5 * (low + high), side.best_y, overlap.height, 1.0
        )
        if turned and meeting.overlap > deepest:
            append_point(overlap, rail, meeting)
            sort_last(overlap)


@seldom
def find_saddles(pair: Pair, overlap: Overlap, place: Place):
    """The smallest overlap between neighbouring deepest points."""
    for entry in range(overlap.count - 1):
        point = overlap.points[entry]
        following = overlap.points[entry + 1]
        x, turned = turning_point(
            pair,
            place,
            point.rail,
            following.rail,
            0.5 * (point.rail + following.rail),
            0.5 * (point.wheel + following.wheel),
            overlap.height,
            -1.0,
        )
        point.saddle = x
        point.between = place.meeting.overlap
