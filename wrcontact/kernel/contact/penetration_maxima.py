"""The list of deepest points of the overlap, in the order of the rail, with the saddles between them.

They are followed from one trial of an elastic wheelset to the next, which stands a few micrometres away: a
search for them costs as much as the rest of a trial.
"""

from math import sqrt
from typing import Final

from ..layout import (
    DEEP_LIMIT,
    REGION_LIMIT,
    DeepPoint,
    DeepPoints,
    Meeting,
    Overlap,
    Pair,
    Place,
    copy,
    seldom,
)
from ..surface.tables import height_slope
from .penetrated import turning_point

#: Two deepest points are one region while the overlap between them has fallen by less than this share of
#: the largest.  Against the complete theory 0.3 does best; 0.2 parts the centred S1002 (peak pressure
#: +14 %), 0.45 joins what is separate.
MERGE: Final[float] = 0.3
#: A hump of the overlap that rises by less over the saddle beside it is none [m]: joints of profiles leave
#: some, and whether they are found would hang on where the overlap is sampled.
LEAST_HUMP: Final[float] = 1e-9
#: Deepest points closer than this on the rail are one [m].
SAME_POINT: Final[float] = 1e-6
#: A point that has moved farther than this along the rail is not followed, and a saddle is sought between
#: its points [m].
FOLLOWED: Final[float] = 5e-4


@seldom
def append_point(overlap: Overlap, rail: float, meeting: Meeting):
    """List a deepest point at the end."""
    count = overlap.count
    if count < DEEP_LIMIT:
        point = overlap.points[count]
        point.rail = rail
        point.wheel = meeting.wheel
        point.depth = meeting.overlap
        overlap.count = count + 1


@seldom
def sort_last(overlap: Overlap):
    """Bring the last point listed to its place along the rail."""
    entry = overlap.count - 1
    rail = overlap.points[entry].rail
    wheel = overlap.points[entry].wheel
    depth = overlap.points[entry].depth
    while entry > 0 and rail < overlap.points[entry - 1].rail:
        copy(overlap.points[entry - 1], overlap.points[entry])
        entry -= 1
    point = overlap.points[entry]
    point.rail = rail
    point.wheel = wheel
    point.depth = depth


@seldom
def is_listed(overlap: Overlap, x: float) -> bool:
    """Whether the last point listed is at ``x`` [m] or beyond."""
    listed = False
    entry = overlap.count - 1
    if entry >= 0:
        if x < overlap.points[entry].rail + SAME_POINT:
            listed = True
    return listed


@seldom
def deepest_entry(overlap: Overlap):
    """The deepest of the list."""
    best = 0
    for entry in range(overlap.count):
        if overlap.points[entry].depth > overlap.points[best].depth:
            best = entry
    return best


@seldom
def fallen(pair: Pair, point: DeepPoint):
    """How far the wheel has come down since it touched at a deepest point [m]."""
    z, slope = height_slope(pair.rail, point.rail)
    return point.depth * sqrt(1.0 + slope * slope)


@seldom
def last_touched(pair: Pair, overlap: Overlap):
    """The one of the list that was touched last.

    Not the least deep one: along its normal, a flange is less deep than a tread that was touched later.
    """
    last = 0
    least = fallen(pair, overlap.points[0])
    for entry in range(1, overlap.count):
        height = fallen(pair, overlap.points[entry])
        if height < least:
            last = entry
            least = height
    return last


@seldom
def keep_deepest(overlap: Overlap):
    """Leave only the deepest of the list, which then has no bounds."""
    copy(overlap.points[deepest_entry(overlap)], overlap.points[0])
    overlap.count = 1


@seldom
def remove_point(overlap: Overlap, entry: int):
    """Take a point off the list with its own saddle."""
    count = overlap.count
    for i in range(entry, count - 1):
        copy(overlap.points[i + 1], overlap.points[i])
    overlap.count = count - 1


@seldom
def drop_point(overlap: Overlap, entry: int):
    """Leave out a deepest point; of the saddles beside it the less deep one stays."""
    if entry > 0 and entry < overlap.count - 1:
        point = overlap.points[entry]
        before = overlap.points[entry - 1]
        if point.between < before.between:
            before.between = point.between
            before.saddle = point.saddle
    remove_point(overlap, entry)


@seldom
def merge_points(pair: Pair, overlap: Overlap):
    """Join points with a low saddle between them, or hardly one, and keep REGION_LIMIT of them."""
    depth = overlap.points[deepest_entry(overlap)].depth
    entry = 0
    while entry < overlap.count - 1:
        point = overlap.points[entry]
        following = overlap.points[entry + 1]
        lower = min(point.depth, following.depth)
        if depth - point.between < MERGE * depth or lower - point.between < LEAST_HUMP:
            less = entry
            if point.depth > following.depth:
                less = entry + 1
                # the saddle between the two goes, the one on the far side stays
                point.saddle = following.saddle
                point.between = following.between
            remove_point(overlap, less)
        else:
            entry += 1
    while overlap.count > REGION_LIMIT:
        drop_point(overlap, last_touched(pair, overlap))


def keep_points(overlap: Overlap, kept: DeepPoints):
    """Note the deepest points on the list for the next trial."""
    kept.count = overlap.count
    for entry in range(overlap.count):
        copy(overlap.points[entry], kept.points[entry])


def follow_overlaps(pair: Pair, overlap: Overlap, kept: DeepPoints, place: Place, height: float):
    """List the deepest points that ``kept`` ones have become under the wheel at ``place``, moved down by
    ``height`` [m], with the saddles between them; their number, or 0 if one was lost or moved too far."""
    overlap.height = height
    overlap.count = kept.count
    for entry in range(kept.count):
        point = overlap.points[entry]
        copy(kept.points[entry], point)
        x = point.rail
        x, turned = turning_point(pair, place, x - FOLLOWED, x + FOLLOWED, x, point.wheel, height, 1.0)
        if not turned or not place.meeting.overlap > 0.0:
            return 0
        point.rail = x
        point.wheel = place.meeting.wheel
        point.depth = place.meeting.overlap
    for entry in range(kept.count - 1):
        follow_saddle(pair, place, overlap.points[entry], overlap.points[entry + 1], height)
    return overlap.count


def follow_saddle(pair: Pair, place: Place, point: DeepPoint, following: DeepPoint, height: float):
    """Find the saddle between two neighbouring points from where it was."""
    y = 0.5 * (point.wheel + following.wheel)
    reach = min(min(FOLLOWED, point.saddle - point.rail), following.rail - point.saddle)
    x, turned = turning_point(
        pair, place, point.saddle - reach, point.saddle + reach, point.saddle, y, height, -1.0
    )
    if not turned:
        x, turned = turning_point(
            pair, place, point.rail, following.rail, 0.5 * (point.rail + following.rail), y, height, -1.0
        )
    point.saddle = x
    point.between = place.meeting.overlap
