"""Whether a wheel is nearest to its rail at one place along it, everywhere where both overlap.

Where the gap F(y, phi) has m > 0 as a lower bound of F_phiphi, it has one minimum by the angle for each abscissa.  A rail
that is more hollow along the track than the wheel is round may be touched twice along it.
"""

from typing import Final

from ..layout import Pair, SectionBox, SectionSearch, SectionTouch
from ..sections.section_search import FIRST_CELLS, STEEPEST_ANGLE, narrow_box, write_box
from ..sections.section_spread import spread_bends, spread_slopes

#: So many boxes are looked at, of each first one, until bounds decide.
CONVEX_BOXES: Final[int] = 64


def has_one_valley(pair: Pair, touch: SectionTouch, search: SectionSearch, depth: float) -> bool:
    """Whether the gap of a wheel, which is lowered by ``depth`` [m] below where it touches, has one minimum along the rail
    wherever it is below zero."""
    scan = pair.scan
    search.best = touch.best + depth
    first = 0
    while first + 1 < scan.count:
        last = min(first + FIRST_CELLS, scan.count - 1)
        write_box(search.boxes[0], scan.nodes[first].y, scan.nodes[last].y, -STEEPEST_ANGLE, STEEPEST_ANGLE)
        if not is_convex_along(pair, touch, search):
            return False
        first = last
    return True


def is_convex_along(pair: Pair, touch: SectionTouch, search: SectionSearch) -> bool:
    """Whether that holds in the first box of the stack."""
    waiting = 1
    count = 0
    while waiting > 0:
        waiting -= 1
        count += 1
        box = search.boxes[waiting]
        if may_overlap(pair, touch, search, box):
            spread_slopes(touch.place, search.spread, search.bounds)
            spread_bends(touch.place, search.spread, search.bounds)
            if not search.spread.bend_around > 0.0:
                if count > CONVEX_BOXES:
                    return False
                middle = 0.5 * (box.low + box.high)
                other = search.boxes[waiting + 1]
                write_box(other, middle, box.high, box.back, box.ahead)
                box.high = middle
                waiting += 2
    return True


def may_overlap(pair: Pair, touch: SectionTouch, search: SectionSearch, box: SectionBox) -> bool:
    """Whether wheel and rail may overlap where a box has a minimum along the rail; what is known of the rail below the box is
    then in ``search``."""
    if not narrow_box(pair, touch.place, search, box):
        return False
    spread_slopes(touch.place, search.spread, search.bounds)
    return not (search.spread.least_turn > 0.0 or search.spread.most_turn < 0.0)
