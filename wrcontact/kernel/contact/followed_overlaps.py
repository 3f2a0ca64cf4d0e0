"""Deepest points that are followed from one trial of an elastic wheelset to the next, which stands a few
micrometres away: a search for them costs as much as the rest of a trial."""

from typing import Final

from ..layout import DeepPoint, DeepPoints, Overlap, Place, Tables
from .deep_points import copy_point
from .touching import turning_point

#: A point that has moved farther than this along the rail is not followed, and a saddle is sought between
#: its points [m].
FOLLOWED: Final[float] = 5e-4


def keep_points(overlap: Overlap, kept: DeepPoints):
    """Note the deepest points on the list for the next trial."""
    kept.count = overlap.count
    for entry in range(overlap.count):
        copy_point(overlap.points[entry], kept.points[entry])


def follow_overlaps(tables: Tables, overlap: Overlap, kept: DeepPoints, place: Place, height: float):
    """List the deepest points that ``kept`` ones have become under the wheel at ``place``, moved down by
    ``height`` [m], with the saddles between them; their number, or 0 if one was lost or moved too far."""
    overlap.height = height
    overlap.count = kept.count
    for entry in range(kept.count):
        point = overlap.points[entry]
        copy_point(kept.points[entry], point)
        x = point.rail
        rail, wheel, depth, turned = turning_point(tables, place, x - FOLLOWED, x + FOLLOWED, point.wheel,
                                                   height, 1.0)
        if not turned or not depth > 0.0:
            return 0
        point.rail = rail
        point.wheel = wheel
        point.depth = depth
    for entry in range(kept.count - 1):
        follow_saddle(tables, place, overlap.points[entry], overlap.points[entry + 1], height)
    return overlap.count


def follow_saddle(tables: Tables, place: Place, point: DeepPoint, following: DeepPoint, height: float):
    """Find the saddle between two neighbouring points from where it was."""
    y = 0.5 * (point.wheel + following.wheel)
    reach = FOLLOWED
    if point.saddle - point.rail < reach:
        reach = point.saddle - point.rail
    if following.rail - point.saddle < reach:
        reach = following.rail - point.saddle
    x, y, depth, turned = turning_point(tables, place, point.saddle - reach, point.saddle + reach, y, height,
                                        -1.0)
    if not turned:
        x, y, depth, turned = turning_point(tables, place, point.rail, following.rail,
                                            0.5 * (point.wheel + following.wheel), height, -1.0)
    point.saddle = x
    point.between = depth
