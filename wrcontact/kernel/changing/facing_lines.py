"""The lines of a changing rail that a wheel at a pose faces, from the place where it is nearest on to both sides."""

from math import fabs
from typing import Final

from ..elementary.circle import atan2
from ..layout import Pair, Place, Sections, SectionTouch
from ..sections.section_surface import break_below, clamped_position, line_below
from ..surface.locus import around_wheel
from ..surface.tables import height_slope
from .bridges import DEEP, find_beyond
from .valley import APART, follow_line, line_point

#: The rail is laid this far to both sides of where the wheel touches at least [m]: some nodes of the wheel's raster.
LEAST_REACH: Final[float] = 5e-3
#: From one line to the next the outline's abscissa goes on by less than this [m] and this many times their distance: beyond, it
#: nearly folds back, and what lies between is not known.
LONGEST: Final[float] = 1e-3
FOLDED: Final[float] = 3.0
#: A gap up to which all of the rail is laid, also beyond a groove [m].
ALL: Final[float] = 1e3


def follow_valley(pair: Pair, place: Place, touch: SectionTouch, position: float, far: float) -> bool:
    """Write the nodes of the lines that the wheel at ``place`` faces, from the place where it is nearest on to both sides, up
    to gaps of ``far`` [m]; whether there are any on both."""
    sections = pair.sections
    at = clamped_position(sections, position + touch.rail_x)
    interval = break_below(sections.breaks, sections.interval_count, at)
    first = interval * sections.knot_count
    below = line_below(sections, first, at - sections.breaks[interval], touch.rail_y - sections.lateral)
    sections.far = far
    sections.bridged = False
    sections.cut_first = follow_side(pair, place, touch, position, far, below, -1)
    sections.cut_last = follow_side(pair, place, touch, position, far, below + 1, 1)
    if not (sections.first <= below and sections.last > below):
        return False
    measure_section(pair, position, at)
    return True


def measure_section(pair: Pair, position: float, at: float):
    """How far the section at the position ``at`` [m], of which a part is laid, reaches in the frame, and how long it is."""
    sections = pair.sections
    last = sections.knot_count - 1
    interval = break_below(sections.breaks, sections.interval_count, at)
    share = (at - sections.breaks[interval]) / (sections.breaks[interval + 1] - sections.breaks[interval])
    sections.arc_start = sections.nodes[sections.first].y
    sections.arc_before = 0.0
    if sections.cut_first:
        x, y, z, rise, lean, x_u = line_point(pair, sections.frame, position, 0, at)
        sections.arc_start = y
        sections.arc_before = arc_of_line(sections, interval, share, sections.first)
    sections.arc_stop = sections.nodes[sections.last].y
    if sections.cut_last:
        x, y, z, rise, lean, x_u = line_point(pair, sections.frame, position, last, at)
        sections.arc_stop = y
    sections.arc_total = arc_of_line(sections, interval, share, last)


def arc_of_line(sections: Sections, interval: int, share: float, line: int):
    """How long the section is up to a line [m], at a ``share`` of an interval."""
    before = sections.arcs[interval * sections.knot_count + line]
    behind = sections.arcs[(interval + 1) * sections.knot_count + line]
    return before + share * (behind - before)


def follow_side(
    pair: Pair, place: Place, touch: SectionTouch, position: float, far: float, line: int, step: int
) -> bool:
    """Write the nodes from ``line`` on to one side; whether that ended before the last one, where a line could not be
    followed or the gap is larger than ``far`` [m].  The last one that is written is noted."""
    sections = pair.sections
    z, slope = height_slope(pair.wheel, touch.y)
    sine, cosine = around_wheel(place, slope)
    y = touch.y
    angle = atan2(sine, cosine)
    u = position + touch.rail_x
    end = -1
    if step > 0:
        end = sections.knot_count
    last = line - step
    first = line
    cut = False
    # whether there may be a part of the rail beyond a groove
    grooved = True
    while line != end:
        found, u, y, angle = follow_line(pair, place, position, line, u, y, angle, sections.nodes[line])
        if found and line != first:
            if not float(step) * (sections.nodes[line].y - sections.nodes[last].y) > APART:
                found = False
            farther = float(step) * (sections.nodes[line].wheel - sections.nodes[last].wheel)
            if farther <= 0.0 or farther > LONGEST + FOLDED * fabs(
                sections.nodes[line].y - sections.nodes[last].y
            ):
                found = False
        deep = found and line != first and sections.nodes[line].gap > DEEP
        if far >= ALL and line != first and (not found or (deep and grooved)):
            beyond, next_u, next_y, next_angle = find_beyond(pair, place, touch, position, last, step)
            grooved = beyond != last
            if grooved:
                line = beyond
                u = next_u
                y = next_y
                angle = next_angle
                found = True
        if not found:
            cut = True
            break
        last = line
        line += step
        away = float(step) * (sections.nodes[last].wheel - touch.y)
        if line != end and sections.nodes[last].gap > far and away > LEAST_REACH:
            cut = True
            break
    if step > 0:
        sections.last = last
    else:
        sections.first = last
    return cut
