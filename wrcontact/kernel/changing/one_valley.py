"""Whether a wheel is nearest to its rail at one place along it, everywhere where both overlap.

Where the gap F(y, phi) has m > 0 as a lower bound of F_phiphi, it has one minimum by the angle for each abscissa.  A rail
that is more hollow along the track than the wheel is round may be touched twice along it.
"""

from typing import Final

from ..layout import BOX_LIMIT, Pair, SectionBox, Sections, SectionSearch, SectionTouch
from ..sections.section_gap import compute_gap
from ..sections.section_search import FIRST_CELLS, STEEPEST_ANGLE, largest_fall, narrow_box, write_box
from ..sections.section_spread import spread_bends, spread_slopes

#: So many boxes are looked at, of each first one, until bounds decide.
CONVEX_BOXES: Final[int] = 400
#: Angles at the ends of a box are left out in this share of its angles at a time, and so often at most.
TRIMMED: Final[float] = 0.25
TRIMS: Final[int] = 40
#: Where the overlap ends is looked for in boxes down to this width [m].
NARROW: Final[float] = 5e-4


def has_one_valley(pair: Pair, touch: SectionTouch, search: SectionSearch, depth: float) -> bool:
    """Whether the gap of a wheel, which is lowered by ``depth`` [m] below where it touches, has one minimum along the rail
    wherever it is below zero; between which wheel abscissae that may be is then in ``search``."""
    scan = pair.scan
    search.best = touch.best + depth
    search.low = touch.y
    search.high = touch.y
    search.on_bridge = False
    first = 0
    while first + 1 < scan.count:
        last = min(first + FIRST_CELLS, scan.count - 1)
        write_box(search.boxes[0], scan.nodes[first].y, scan.nodes[last].y, -STEEPEST_ANGLE, STEEPEST_ANGLE)
        if not is_convex_along(pair, touch, search):
            return False
        first = last
    return True


def is_convex_along(pair: Pair, touch: SectionTouch, search: SectionSearch) -> bool:
    """Whether that holds in the first box of the stack: its parts across have m > 0 between the first and the last angle at
    which both may overlap."""
    waiting = 1
    count = 0
    while waiting > 0:
        waiting -= 1
        count += 1
        if count > CONVEX_BOXES or waiting + 2 > BOX_LIMIT - 1:
            return False
        box = search.boxes[waiting]
        if narrow_box(pair, touch.place, search, box):
            if trim_box(pair, touch, search, box):
                wide = box.high - box.low > NARROW
                beyond = is_beyond(pair.sections, box)
                over_bridge = is_over_bridge(pair.sections, box)
                if not search.spread.bend_around > 0.0 or (wide and (beyond or over_bridge)):
                    middle = 0.5 * (box.low + box.high)
                    write_box(search.boxes[waiting + 1], middle, box.high, box.back, box.ahead)
                    box.high = middle
                    waiting += 2
                else:
                    search.low = min(search.low, box.low)
                    search.high = max(search.high, box.high)
                    search.on_bridge = search.on_bridge or over_bridge
    return True


def is_beyond(sections: Sections, box: SectionBox) -> bool:
    """Whether a box reaches beyond the rail that is laid, so that a narrower one may tell whether the overlap does."""
    beyond = sections.cut_first and box.low < sections.nodes[sections.first].wheel
    return beyond or (sections.cut_last and box.high > sections.nodes[sections.last].wheel)


def is_over_bridge(sections: Sections, box: SectionBox) -> bool:
    """Whether a box reaches between two nodes one of which is that of a bridge."""
    over = False
    if sections.bridged:
        for k in range(sections.first, sections.last):
            before = sections.nodes[k]
            behind = sections.nodes[k + 1]
            if (before.bridge or behind.bridge) and box.low < behind.wheel and box.high > before.wheel:
                over = True
    return over


def trim_box(pair: Pair, touch: SectionTouch, search: SectionSearch, box: SectionBox) -> bool:
    """Leave out angles at both ends of a box where wheel and rail do not overlap, until m > 0; whether any are left.  The
    bounds for those that are left are then in ``search.spread``."""
    part = search.boxes[BOX_LIMIT - 1]
    for i in range(TRIMS):
        if not bound_box(pair, touch, search, box):
            return False
        if search.spread.bend_around > 0.0:
            return True
        cut = TRIMMED * (box.ahead - box.back)
        write_box(part, box.low, box.high, box.back, box.back + cut)
        trimmed = False
        if not bound_box(pair, touch, search, part):
            box.back += cut
            trimmed = True
        write_box(part, box.low, box.high, box.ahead - cut, box.ahead)
        if not bound_box(pair, touch, search, part):
            box.ahead -= cut
            trimmed = True
        if not trimmed:
            return bound_box(pair, touch, search, box)
    return bound_box(pair, touch, search, box)


def bound_box(pair: Pair, touch: SectionTouch, search: SectionSearch, box: SectionBox) -> bool:
    """Write bounds over a box to ``search.spread``; whether wheel and rail may overlap in it."""
    if not narrow_box(pair, touch.place, search, box):
        return False
    spread_slopes(touch.place, search.spread, search.bounds)
    spread_bends(touch.place, search.spread, search.bounds)
    if search.spread.least_turn > 0.0 or search.spread.most_turn < 0.0:
        return False
    compute_gap(pair, touch.place, search, 0.5 * (box.low + box.high), 0.5 * (box.back + box.ahead))
    fall, by_angle, by_place = largest_fall(search, 0.5 * (box.high - box.low), 0.5 * (box.ahead - box.back))
    return search.at.gap - fall < search.best
