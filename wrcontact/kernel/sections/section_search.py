"""The smallest gap of a wheel over a rail whose section changes along the track.

The gap F(y, phi) is sought over the abscissa y on the wheel and the angle phi around it. A box of places that waits is
bounded from its middle: with c the largest |F_yphi| and m the smallest F_phiphi in it, h and k its half-widths,

    F >= F_0 - |F_y| h + min(F_yy, 0) h^2 / 2 - B,
    B = (|F_phi| + c h)^2 / 2 m  if m > 0,  else |F_phi| k + c h k - m k^2 / 2.                                (A2)

Where m > 0 the gap has one minimum by phi for each y, whatever the angles, and the second dimension costs nothing. A box
that can hold a smaller gap is divided, until it cannot or until F is convex in it and Newton's method has found its
minimum. The angles of a box are those at which wheel and rail can have the same normal, by (A1) and the rail's slopes
over the box, and at which the wheel is low enough.
"""

from math import fabs
from typing import Final

from ..elementary.circle import sine_cosine
from ..layout import BOX_LIMIT, Pair, Place, SectionBox, SectionSearch, SectionSpread
from .section_bounds import section_bounds
from .section_gap import compute_gap, settled_angle
from .section_spread import (
    angles_of_normals,
    lowest_angle,
    spread_angles,
    spread_bends,
    spread_deviation,
    spread_reach,
    spread_slopes,
    spread_wheel,
)
from .wheel_radius import radius_jet

#: Cells of the wheel's raster in a first box.
FIRST_CELLS: Final[int] = 4
#: A gap smaller than the smallest one known by less than this is not sought [m].
SETTLED: Final[float] = 1e-11
#: Boxes are not divided below these half-widths [m, rad].
LEAST_WIDTH: Final[float] = 1e-8
LEAST_ANGLE: Final[float] = 1e-8
#: Rounding of gaps [m].
ROUNDING: Final[float] = 1e-15
LARGE_GAP: Final[float] = 1e3
MOST_BOXES: Final[float] = 20000.0
NEWTON_STEPS: Final[int] = 12
SHARP: Final[float] = 1e-13
#: Boxes at the end of the surface are not divided below these half-widths [m, rad].
EDGE_WIDTH: Final[float] = 1e-5
EDGE_ANGLE: Final[float] = 1e-4
#: Steepest angle around the wheel that is looked at [rad].
STEEPEST_ANGLE: Final[float] = 1.5
#: Bounds are read anew where the angles have become fewer by this share [-].
NARROWED: Final[float] = 0.7


def search_sections(pair: Pair, place: Place, search: SectionSearch) -> bool:
    """Write the smallest gap of the placed wheel at ``search.position``, its abscissa and angle to ``search``; whether it
    is certain.

    It may lie beside the section, on its straight continuation. It is not certain if the gap may be smaller where that ends.
    """
    scan = pair.scan
    probe_sections(pair, place, search)
    first = 0
    certain = True
    while first + 1 < scan.count:
        last = min(first + FIRST_CELLS, scan.count - 1)
        write_box(search.boxes[0], scan.nodes[first].y, scan.nodes[last].y, -STEEPEST_ANGLE, STEEPEST_ANGLE)
        if not search_boxes(pair, place, search):
            certain = False
        first = last
    refine_best(pair, place, search)
    return certain and search.edge >= search.best - SETTLED


def probe_sections(pair: Pair, place: Place, search: SectionSearch):
    """Write the best of the minima that a few places lead to, which need not be the smallest gap, to ``search``."""
    scan = pair.scan
    search.box_count = 0.0
    search.gap_count = 0.0
    search.edge = LARGE_GAP
    search.best = LARGE_GAP
    search.best_y = scan.nodes[0].y
    search.best_angle = 0.0
    first = 0
    while first + 1 < scan.count:
        last = min(first + FIRST_CELLS, scan.count - 1)
        try_first(pair, place, search, 0.5 * (scan.nodes[first].y + scan.nodes[last].y))
        first = last
    refine_best(pair, place, search)


def follow_sections(pair: Pair, place: Place, search: SectionSearch, y: float, angle: float) -> bool:
    """Write the minimum that Newton's method finds from the place ``y`` [m], ``angle`` [rad] on to ``search``; whether it
    finds one."""
    box = search.boxes[0]
    scan = pair.scan
    search.best = LARGE_GAP
    write_box(box, scan.nodes[0].y, scan.nodes[scan.count - 1].y, -STEEPEST_ANGLE, STEEPEST_ANGLE)
    if not newton_in(pair, place, search, box, y, angle):
        return False
    compute_gap(pair, place, search, search.settled_y, search.settled_angle)
    search.best = search.at.gap
    search.best_y = search.settled_y
    search.best_angle = search.settled_angle
    return above_surface(pair, search.at.y)


def write_box(box: SectionBox, low: float, high: float, back: float, ahead: float):
    box.low = low
    box.high = high
    box.back = back
    box.ahead = ahead


def above_surface(pair: Pair, y: float) -> bool:
    """Whether there is a surface below a place with the track coordinate ``y`` [m]."""
    abscissa = y - pair.rail_y
    return abscissa >= pair.sections.across_start and abscissa <= pair.sections.across_stop


def try_first(pair: Pair, place: Place, search: SectionSearch, y: float):
    """Keep the smallest gap at ``y`` [m] by the angle, from the level wheel on, if it is the smallest one known."""
    if pair.out_of_round:
        # Newton's method may be led away where the wheel is nearly as hollow as it is round
        compute_gap(pair, place, search, y, 0.0)
        keep_gap(pair, search, y, 0.0)
    angle = settled_angle(pair, place, search, y, 0.0, -STEEPEST_ANGLE, STEEPEST_ANGLE)
    keep_gap(pair, search, y, angle)


def keep_gap(pair: Pair, search: SectionSearch, y: float, angle: float):
    """Keep the gap last computed, at ``y`` and ``angle``, if it is the smallest one known."""
    if search.at.gap < search.best and above_surface(pair, search.at.y):
        search.best = search.at.gap
        search.best_y = y
        search.best_angle = angle


def refine_best(pair: Pair, place: Place, search: SectionSearch):
    """Newton's method from the smallest gap known, whose derivatives are then in ``search.at``: where it settles counts
    rather than a place with the same gap but for the last bits."""
    box = search.boxes[0]
    scan = pair.scan
    write_box(box, scan.nodes[0].y, scan.nodes[scan.count - 1].y, -STEEPEST_ANGLE, STEEPEST_ANGLE)
    if newton_in(pair, place, search, box, search.best_y, search.best_angle):
        compute_gap(pair, place, search, search.settled_y, search.settled_angle)
        if search.at.gap < search.best + ROUNDING:
            search.best = search.at.gap
            search.best_y = search.settled_y
            search.best_angle = search.settled_angle
    compute_gap(pair, place, search, search.best_y, search.best_angle)


def newton_in(
    pair: Pair, place: Place, search: SectionSearch, box: SectionBox, y: float, angle: float
) -> bool:
    """Newton's method for the minimum of the gap from ``y``, ``angle`` on; whether it has found one in the box, which is
    kept if it is the smallest one."""
    at = search.at
    for i in range(NEWTON_STEPS):
        compute_gap(pair, place, search, y, angle)
        keep_gap(pair, search, y, angle)
        determinant = at.bend_across * at.bend_around - at.twist * at.twist
        if not (determinant > 0.0 and at.bend_around > 0.0):
            return False
        move = -(at.bend_around * at.across - at.twist * at.around) / determinant
        turn = -(at.bend_across * at.around - at.twist * at.across) / determinant
        if fabs(move) < SHARP and fabs(turn) < SHARP:
            search.settled_y = y
            search.settled_angle = angle
            return True
        y += move
        angle += turn
        if not (y >= box.low and y <= box.high and angle >= box.back and angle <= box.ahead):
            return False
    return False


def search_boxes(pair: Pair, place: Place, search: SectionSearch) -> bool:
    """Search the first box of the stack; whether it was searched to the end."""
    waiting = 1
    while waiting > 0:
        waiting -= 1
        search.box_count += 1.0
        if search.box_count > MOST_BOXES or waiting + 2 > BOX_LIMIT:
            return False
        box = search.boxes[waiting]
        if narrow_box(pair, place, search, box):
            waiting += judge_box(pair, place, search, box, search.boxes[waiting + 1])
    return True


def narrow_box(pair: Pair, place: Place, search: SectionSearch, box: SectionBox) -> bool:
    """Leave to a box those angles at which it can have a minimum below the smallest gap known; whether any are left, above
    the surface. What is known of the rail below the box is then in ``search``.

    A minimum at the end of the surface is none where normals meet, so angles there are only bounded by the height.
    """
    spread = search.spread
    sections = pair.sections
    spread_wheel(pair, spread, box.low, box.high)
    spread_deviation(pair, search, box)
    reach = lowest_angle(place, spread, sections.top, search.best, box.low, box.high)
    box.back = max(box.back, -reach)
    box.ahead = min(box.ahead, reach)
    if not box.back <= box.ahead or reach < 0.0:
        return False
    if pair.out_of_round:
        spread_wheel(pair, spread, box.low, box.high)
        spread_deviation(pair, search, box)
    find_below(pair, place, search, box)
    if search.inside:
        keep_angles(place, spread, box, sections.least_lean, sections.most_lean)
        if not box.back <= box.ahead:
            return False
        find_below(pair, place, search, box)
    if search.abscissa + search.aside < sections.across_start:
        return False
    if search.abscissa - search.aside > sections.across_stop:
        return False
    read_bounds(pair, search)
    if search.inside:
        # once more, with the slopes of the rail below this box
        width = box.ahead - box.back
        keep_angles(place, spread, box, search.bounds.least_lean, search.bounds.most_lean)
        if not box.back <= box.ahead:
            return False
        if box.ahead - box.back < NARROWED * width:
            if pair.out_of_round:
                spread_wheel(pair, spread, box.low, box.high)
                spread_deviation(pair, search, box)
            find_below(pair, place, search, box)
            read_bounds(pair, search)
    return True


def keep_angles(place: Place, spread: SectionSpread, box: SectionBox, least_lean: float, most_lean: float):
    """Leave to a box the angles at which normals can meet."""
    back, ahead = angles_of_normals(place, spread, least_lean, most_lean)
    box.back = max(box.back, back)
    box.ahead = min(box.ahead, ahead)


def find_below(pair: Pair, place: Place, search: SectionSearch, box: SectionBox):
    """Write where the rail below a box is."""
    spread = search.spread
    spread_angles(spread, box.back, box.ahead)
    x, y = wheel_place(pair, place, search.rotation, 0.5 * (box.low + box.high), 0.5 * (box.back + box.ahead))
    ahead, aside = spread_reach(place, spread, 0.5 * (box.high - box.low), 0.5 * (box.ahead - box.back))
    search.u = search.position + x
    search.abscissa = y - pair.rail_y
    search.ahead = ahead
    search.aside = aside
    search.inside = (
        search.abscissa - aside >= pair.sections.across_start
        and search.abscissa + aside <= pair.sections.across_stop
    )


def read_bounds(pair: Pair, search: SectionSearch):
    """Read the bounds of the rail below a box."""
    section_bounds(
        pair.sections,
        search.bounds,
        search.u - search.ahead,
        search.u + search.ahead,
        search.abscissa - search.aside,
        search.abscissa + search.aside,
    )


def wheel_place(pair: Pair, place: Place, rotation: float, y: float, angle: float):
    """Track coordinates x, from the middle of the wheelset, and y [m] of a place on the wheel."""
    sine, cosine = sine_cosine(angle)
    r, r_y, r_yy, r_f, r_fy, r_ff = radius_jet(pair, place, rotation, y, angle)
    across = (place.arm + y) * place.cos_roll - r * cosine * place.sin_roll
    return (
        place.cos_yaw * r * sine - place.sin_yaw * across,
        place.shift + place.sin_yaw * r * sine + place.cos_yaw * across,
    )


def judge_box(pair: Pair, place: Place, search: SectionSearch, box: SectionBox, other: SectionBox) -> int:
    """Whether a box can hold a smaller gap than the smallest one known: 0 if not, or 2, and the box and the ``other`` one
    are its halves."""
    spread = search.spread
    at = search.at
    y = 0.5 * (box.low + box.high)
    half = 0.5 * (box.high - box.low)
    spread_slopes(place, spread, search.bounds)
    if search.inside and slopes_away(pair, spread, box):
        return 0
    angle = settled_angle(pair, place, search, y, 0.5 * (box.back + box.ahead), box.back, box.ahead)
    keep_gap(pair, search, y, angle)
    spread_bends(place, spread, search.bounds)
    turn = max(box.ahead - angle, angle - box.back)
    m = spread.bend_around
    c = spread.twist
    bend = spread.bend_across
    fall, by_angle, by_place = largest_fall(search, half, turn)
    if at.gap - fall >= search.best - SETTLED:
        return 0
    if search.inside and no_minimum(pair, search, box, angle, half, turn):
        return 0
    if m > 0.0 and bend * m > c * c and newton_in(pair, place, search, box, y, angle):
        if search.inside or above_surface(pair, at.y):
            return 0
    if not search.inside and half < EDGE_WIDTH and turn < EDGE_ANGLE:
        search.edge = min(search.edge, at.gap - fall)
        return 0
    if half < LEAST_WIDTH and turn < LEAST_ANGLE:
        return 0
    # where the gap is convex by the angle a narrower box across makes it certain, too, unless it falls there all along
    sloping = m <= 0.0 or fabs(at.around) > c * half
    if turn >= LEAST_ANGLE and (half < LEAST_WIDTH or (sloping and by_angle > by_place)):
        middle = 0.5 * (box.back + box.ahead)
        write_box(other, box.low, box.high, middle, box.ahead)
        box.ahead = middle
    else:
        write_box(other, y, box.high, box.back, box.ahead)
        box.high = y
    return 2


def largest_fall(search: SectionSearch, half: float, turn: float):
    """How far the gap can fall [m] over ``half`` [m] and ``turn`` [rad] to either side of the place in ``search.at``, by the
    bounds in ``search.spread``; and the parts of it by the angle and by the abscissa."""
    at = search.at
    spread = search.spread
    m = spread.bend_around
    c = spread.twist
    bend = spread.bend_across
    by_angle = fabs(at.around) * turn + c * half * turn - 0.5 * m * turn * turn
    if m > 0.0:
        reach = fabs(at.around) + c * half
        by_angle = min(reach * reach / (2.0 * m), fabs(at.around) * turn + c * half * turn)
    by_place = fabs(at.across) * half - 0.5 * min(bend, 0.0) * half * half
    steepest = max(fabs(spread.least_rise), fabs(spread.most_rise)) * half
    steepest += max(fabs(spread.least_turn), fabs(spread.most_turn)) * turn
    fall = min(by_angle + by_place, steepest)
    if m > 0.0 and bend * m > c * c:
        fall = min(fall, convex_fall(fabs(at.across), fabs(at.around), bend, c, m, half))
    return fall, by_angle, by_place


def slopes_away(pair: Pair, spread: SectionSpread, box: SectionBox) -> bool:
    """Whether the gap certainly has a slope all over a box: by the angle, or by the abscissa but at the ends of the
    wheel."""
    if spread.least_turn > 0.0 or spread.most_turn < 0.0:
        return True
    return within_wheel(pair, box) and (spread.least_rise > 0.0 or spread.most_rise < 0.0)


def within_wheel(pair: Pair, box: SectionBox) -> bool:
    """Whether a box does not reach an end of the wheel."""
    scan = pair.scan
    return box.low > scan.nodes[0].y and box.high < scan.nodes[scan.count - 1].y


def no_minimum(
    pair: Pair, search: SectionSearch, box: SectionBox, angle: float, half: float, turn: float
) -> bool:
    """Whether the gap certainly has a slope all over a box: by the angle, where Newton's method has stopped at one of its
    ends or F_phi is larger than what it can change by; or by the abscissa, but at the ends of the wheel."""
    at = search.at
    spread = search.spread
    change = spread.twist * half
    if fabs(at.around) > change + spread.most_around * turn:
        return True
    if spread.bend_around > 0.0:
        if (angle <= box.back and at.around > change) or (angle >= box.ahead and -at.around > change):
            return True
    return within_wheel(pair, box) and fabs(at.across) > spread.most_across * half + spread.twist * turn


def convex_fall(across: float, around: float, bend: float, c: float, m: float, half: float):
    """How far a convex gap can fall over ``half`` [m] to either side, over any angles, from a place with these absolute
    slopes: of its minimum by the angle, G, the slope is F_y, but for c F_phi / m, and grows by no less than
    F_yy - c^2 / m."""
    slope = across + c * around / m
    rise = bend - c * c / m
    fall = slope * half - 0.5 * rise * half * half
    if slope < rise * half:
        fall = 0.5 * slope * slope / rise
    return fall + 0.5 * around * around / m
