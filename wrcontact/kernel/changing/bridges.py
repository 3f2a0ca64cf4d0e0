"""Bridges between the parts of a section that a wheel faces, such as the nose and the wing of a crossing, and one frame for all.

Between them lies a groove, into which no wheel reaches. Lines on its walls cannot be followed (valley.py), so the constant rail
is laid there along the wheel's outline, as far below it as at the ends of the bridge. That no contact lies there is shown afterwards: boxes of places where wheel
and rail may overlap do not reach over a bridge (one_valley.py).

Parts that move to different sides have different ruling directions, and the frame can have one only. Where two of them carry, it
lies between those of their deepest places, by the roots of their depths there and of what they are nearer than BESIDE, so that it turns evenly before
a part touches, and as load goes from one to the other. A patch runs obliquely in it, then. How much is measured by

    H_xy^2 / (H_xx H_yy),

of the second derivatives H of the gap, 0 where it runs along the frame and 1 where it is a line across. Strips along the frame are
wrong there: on the crossing of the benchmark by 2 ... 6 % of the load at 0.35, and by a factor of two in the pressure at 0.7.
"""

from math import fabs, sqrt
from typing import Final

from ..elementary.circle import atan2
from ..layout import Pair, Place, Sections, SectionTouch
from ..surface.locus import around_wheel, outline_jet
from ..surface.tables import height_slope, height_slope_bend
from .valley import APART, follow_line, line_point, outline_at

#: A bridge begins where the rail is farther below the wheel than the second one [m], or lines cannot be followed, and ends where it
#: is between both.
SHALLOW: Final[float] = 1e-3
DEEP: Final[float] = 5e-3
#: Parts that the wheel is nearer to than this turn the frame; so far beyond the overlap other contacts are looked for [m].
BESIDE: Final[float] = 2e-5
#: A patch that runs more obliquely in its frame is not solved [-].
MOST_SKEW: Final[float] = 0.35


def find_beyond(pair: Pair, place: Place, touch: SectionTouch, position: float, last: int, step: int):
    """The next line beyond the node ``last`` that can be followed, though not the one beside it, its position [m], and its wheel
    abscissa [m] and angle [rad]; the line is ``last`` if there is none.  The nodes between are those of a bridge."""
    sections = pair.sections
    near = sections.nodes[last]
    if not near.gap > SHALLOW:
        return last, 0.0, 0.0, 0.0
    # the frame begins where the wheel is nearest
    line = last + 2 * step
    while line >= 0 and line < sections.knot_count:
        node = sections.nodes[line]
        u = position + touch.rail_x
        x, across, z, slope, rise, x_u = line_point(pair, sections.frame, position, line, u)
        y = touch.y + across
        if y >= pair.wheel.start and y <= pair.wheel.stop:
            wheel_z, wheel_slope = height_slope(pair.wheel, y)
            sine, cosine = around_wheel(place, wheel_slope)
            found, u, y, angle = follow_line(pair, place, position, line, u, y, atan2(sine, cosine), node)
            apart = float(step) * (node.y - near.y) > APART and float(step) * (node.wheel - near.wheel) > 0.0
            if found and apart and node.gap > SHALLOW and node.gap < DEEP:
                if lay_bridge(pair, place, last, line, step):
                    return line, u, y, angle
        line += step
    return last, 0.0, 0.0, 0.0


def lay_bridge(pair: Pair, place: Place, last: int, line: int, step: int) -> bool:
    """Write the nodes between those of ``last`` and ``line``: along the wheel's outline, below it; whether it reaches there."""
    sections = pair.sections
    near = sections.nodes[last]
    far = sections.nodes[line]
    slant = (far.gap - near.gap) / (far.y - near.y)
    y = near.wheel
    at = last + step
    while at != line:
        share = fabs(float(at - last)) / fabs(float(line - last))
        across = near.y + share * (far.y - near.y)
        y, over = outline_at(pair, place, across, y)
        if not over:
            return False
        z, slope, bend = height_slope_bend(pair.wheel, y)
        y_track, z_track, outline_slope, stretch, slope_rate = outline_jet(place, y, z, slope, bend)
        node = sections.nodes[at]
        node.y = across
        node.gap = near.gap + share * (far.gap - near.gap)
        node.z = z_track + node.gap
        node.slope = outline_slope + slant
        node.before = slope_rate / stretch
        node.behind = slope_rate / stretch
        node.wheel = y
        node.move = 0.0
        node.lift = 0.0
        node.rise = 0.0
        node.bend = 0.0
        node.rate = 0.0
        node.skew = 0.0
        node.bridge = True
        at += step
    # at its ends, too, the bridge bends as the wheel
    if step > 0:
        near.behind = sections.nodes[last + step].before
        far.before = sections.nodes[line - step].behind
    else:
        near.before = sections.nodes[last + step].behind
        far.behind = sections.nodes[line - step].before
    sections.bridged = True
    return True


def direction_between(sections: Sections, depth: float):
    """How many parts between bridges the wheel, lowered by another ``depth`` [m], overlaps or is beside, and the lateral rate of
    the direction between theirs [-]."""
    count = 0
    total = 0.0
    weighted = 0.0
    deepest = 0.0
    rate = 0.0
    for k in range(sections.first, sections.last + 1):
        node = sections.nodes[k]
        cut = (k == sections.first and sections.cut_first) or (k == sections.last and sections.cut_last)
        if cut and node.gap < SHALLOW and depth + BESIDE > deepest:
            # the wheel may come nearer where this frame does not let lines be followed
            deepest = depth + BESIDE
            rate = node.rate
        if not node.bridge and depth + BESIDE - node.gap > deepest:
            deepest = depth + BESIDE - node.gap
            rate = node.rate
        if (node.bridge or k == sections.last) and deepest > 0.0:
            count += 1
            weight = sqrt(deepest)
            total += weight
            weighted += weight * rate
            deepest = 0.0
    if count > 0:
        weighted /= total
    return count, weighted


def is_oblique(sections: Sections, depth: float) -> bool:
    """Whether a patch of the wheel, lowered by another ``depth`` [m], runs so obliquely in the frame that it is not solved."""
    for k in range(sections.first, sections.last + 1):
        node = sections.nodes[k]
        if node.gap < depth and node.skew > MOST_SKEW:
            return True
    return False
