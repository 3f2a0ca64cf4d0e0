"""How often the overlap of a pressed wheel turns between two neighbouring samples, from both samples alone.

Along the wheel's outline, the overlap along the rail's normals turns where F = m - m_w is zero: the slope m
of the rail at the foot x of the normal through the wheel's point, less the wheel's m_w there.  F is positive
where the overlap falls.  With Y' the outline's stretch,

    F' = z_rail''(x) x' - m_w',   x' = Y' (1 + m m_w) / (1 + m^2 - depth z_rail'')

F and F' are known at every sample.  Between two of them F' follows a straight line but for a departure that
tables bound (prepare/scan_bends.py), and for a jump where a joint of the rail lies between.  Bounds of F' say
how often F comes up through zero: nowhere, once, or it is unclear and overlaps.py looks more closely.
"""

from math import fabs
from typing import Final

from ..layout import Overlap, Pair, Place, RailCell, Samples, Scan, TurnCell, inlined, seldom
from ..search.bounds import only_rises_or_falls, rail_index, rail_place
from ..search.single_minimum import departure_from_line
from ..surface.locus import outline_jet
from .penetration_maxima import append_point, is_listed
from .penetrated import turning_point

#: The overlap may turn more than once between two samples, or the bounds do not say.
UNCLEAR: Final[int] = 2
#: What is deeper [m], wider or has its feet farther aside than the tables reach is not judged from samples.
DEEPEST: Final[float] = 3e-4
WIDEST_CELL: Final[float] = 1.25e-3
FARTHEST_FOOT: Final[float] = 1.5e-4
#: F is known but for this share of its change on the way to the foot, and for steps of the slope with which
#: standard profiles are joined [-].
FOOT_SHARE: Final[float] = 0.2
SLOPE_STEP: Final[float] = 1e-5
#: Newton's steps on the cubic through both samples, from which a deepest point is sought.
CUBIC_ITERATIONS: Final[int] = 2


@seldom
def count_turns(pair: Pair, overlap: Overlap, place: Place, entry: int) -> int:
    """How many deepest points lie between the sample ``entry`` and the next one: 0, 1 or UNCLEAR."""
    samples = overlap.samples
    cell = overlap.cell
    scan = pair.scan
    x = samples.rail[entry]
    rail = scan.rail[rail_index(scan, rail_place(scan, x))]
    if not open_cell(scan, overlap, rail, place, entry):
        return UNCLEAR
    bound_departure(scan, overlap, rail, place, entry)
    before = cell.first_bend + cell.joint * (cell.last_bend - cell.jump - cell.first_bend)
    after = before + cell.jump
    least = min(min(cell.first_bend, cell.last_bend), min(before, after)) - cell.departure
    most = max(max(cell.first_bend, cell.last_bend), max(before, after)) + cell.departure
    rise = (
        0.5
        * cell.width
        * (cell.joint * (cell.first_bend + before) + (1.0 - cell.joint) * (after + cell.last_bend))
    )
    if not fabs(cell.last - cell.first - rise) <= 2.0 * cell.error + cell.departure * cell.width:
        return UNCLEAR
    turns = part_turns(cell.first, cell.last, cell.error, cell.error, least, most, cell.width)
    if turns == UNCLEAR and cell.jump != 0.0:
        turns = joined_turns(cell, before, after, rise)
    if turns > 0:
        gap = min(samples.gap[entry], samples.gap[entry + 1])
        if gap - 0.125 * max(most, 0.0) * cell.width * cell.width > overlap.height:
            turns = 0
    return turns


@seldom
def part_turns(
    first: float, last: float, first_error: float, last_error: float, least: float, most: float, width: float
) -> int:
    """The same of a ``width`` [m] in which F changes from ``first`` to ``last``, both but for their errors,
    and F' lies between ``least`` and ``most`` [1/m]."""
    turns = UNCLEAR
    if most <= 0.0:
        turns = 0
    elif first > first_error and last > last_error:
        if only_rises_or_falls(least, most, width, first - first_error, last - last_error):
            turns = 0
    elif first < -first_error and last < -last_error:
        if only_rises_or_falls(least, most, width, first + first_error, last + last_error):
            turns = 0
    elif first < -first_error and last > last_error and least > 0.0:
        turns = 1
    return turns


@seldom
def joined_turns(cell: TurnCell, before: float, after: float, rise: float) -> int:
    """The same of both sides of the cell's joint, where F' is ``before`` and ``after`` [1/m], and ``rise``
    [-] what F' adds to F in the cell; UNCLEAR where the sign of F at the joint is."""
    share = cell.joint
    middle = cell.first + 0.5 * share * cell.width * (cell.first_bend + before)
    middle += share * (cell.last - cell.first - rise)
    error = cell.error + 0.5 * cell.departure * cell.width
    if not fabs(middle) > error:
        return UNCLEAR
    turns = part_turns(
        cell.first,
        middle,
        cell.error,
        error,
        min(cell.first_bend, before) - cell.departure,
        max(cell.first_bend, before) + cell.departure,
        share * cell.width,
    )
    turns += part_turns(
        middle,
        cell.last,
        error,
        cell.error,
        min(after, cell.last_bend) - cell.departure,
        max(after, cell.last_bend) + cell.departure,
        (1.0 - share) * cell.width,
    )
    return min(turns, UNCLEAR)


@seldom
def open_cell(scan: Scan, overlap: Overlap, rail: RailCell, place: Place, entry: int) -> bool:
    """Write F, F' and a joint between the sample ``entry``, above the cell ``rail``, and the next one to the
    overlap's ``cell``; whether that can be judged."""
    samples = overlap.samples
    cell = overlap.cell
    x = samples.rail[entry]
    length = samples.rail[entry + 1] - x
    aside = samples.aside[entry]
    next_aside = samples.aside[entry + 1]
    if not (
        length > 0.0
        and length < WIDEST_CELL
        and max(fabs(aside), fabs(next_aside)) < FARTHEST_FOOT
        and overlap.height - min(samples.gap[entry], samples.gap[entry + 1]) < DEEPEST
    ):
        return False
    cell.width = samples.wheel[entry + 1] - samples.wheel[entry]
    cell.first = -samples.rise[entry]
    cell.last = -samples.rise[entry + 1]
    cell.share, cell.first_bend = sample_bend(scan, overlap, place, entry)
    share, cell.last_bend = sample_bend(scan, overlap, place, entry + 1)
    cell.error = SLOPE_STEP + max(foot_error(samples, entry), foot_error(samples, entry + 1))
    cell.joint = 1.0
    cell.jump = 0.0
    cell.rail_jump = 0.0
    low = x + min(aside, 0.0)
    high = x + length + max(next_aside, 0.0)
    index = rail.joint
    while scan.joints[index].place < low:
        index += 1
    at = scan.joints[index].place
    if at <= high:
        if not (
            at > x + max(aside, 0.0)
            and at < x + length + min(next_aside, 0.0)
            and scan.joints[index + 1].place > high
        ):
            return False
        cell.rail_jump = scan.joints[index].jump
        cell.jump = cell.rail_jump * cell.share
        cell.joint = (at - x - aside) / (length + next_aside - aside)
    return True


@inlined
def sample_bend(scan: Scan, overlap: Overlap, place: Place, entry: int):
    """x' [-] and F' [1/m] at the sample ``entry``."""
    samples = overlap.samples
    node = scan.nodes[int(samples.node[entry])]
    y_track, z_track, outline_slope, stretch, rate = outline_jet(
        place, node.y, node.height, node.slope, node.bend
    )
    m = samples.rail_slope[entry]
    bend = samples.rail_bend[entry]
    depth = max(overlap.height - samples.gap[entry], 0.0)
    share = stretch * (1.0 + (m * (outline_slope - m) + depth * bend) / (1.0 + m * m))
    return share, share * bend - rate


@inlined
def foot_error(samples: Samples, entry: int):
    """By how much F may differ from the one of the sample ``entry``, which has changed on the way to the foot
    by ``turn``, if it went there at all."""
    change = fabs(samples.aside[entry] * samples.rail_bend[entry])
    error = FOOT_SHARE * change
    if samples.turn[entry] == 0.0:
        error += change
    return error


@seldom
def foot_aside(samples: Samples, entry: int):
    """How far the foot of the sample ``entry`` may lie aside [m]; 0 where cells beside it are not judged."""
    aside = (1.0 + FOOT_SHARE) * samples.aside[entry]
    if fabs(aside) > (1.0 + FOOT_SHARE) * FARTHEST_FOOT:
        aside = 0.0
    return aside


@seldom
def bound_departure(scan: Scan, overlap: Overlap, rail: RailCell, place: Place, entry: int):
    """Write how far F' may depart from the straight line in the open cell."""
    samples = overlap.samples
    cell = overlap.cell
    node = scan.nodes[int(samples.node[entry])]
    length = samples.rail[entry + 1] - samples.rail[entry]
    aside = max(fabs(samples.aside[entry]), fabs(samples.aside[entry + 1]))
    change = samples.rail_bend[entry + 1] - cell.rail_jump - samples.rail_bend[entry]
    # a foot may lie beyond the chord's ends
    rest = node.departure + length * (0.2 * length * rail.wave + 0.4 * rail.kinks)
    departure, slid = departure_from_line(place, node, rest)
    cell.departure = (
        departure
        + (slid + aside / length) * fabs(change)
        + 2.0 * DEEPEST * fabs(cell.rail_jump * samples.rail_bend[entry])
    )


@seldom
def list_from_samples(pair: Pair, overlap: Overlap, place: Place, entry: int) -> bool:
    """List the one deepest point in the open cell after the sample ``entry``, sought from where the cubic
    through both samples is zero; whether it was found."""
    samples = overlap.samples
    cell = overlap.cell
    rise = cell.last - cell.first
    start = cell.first_bend * cell.width - rise
    end = cell.last_bend * cell.width - rise
    t = -cell.first / rise
    for i in range(CUBIC_ITERATIONS):
        rest = 1.0 - t
        curve = rest * start - t * end
        slope = rise + (rest - t) * curve - t * rest * (start + end)
        if slope > 0.0:
            t -= (cell.first + t * (rise + rest * curve)) / slope
        t = min(max(t, 0.0), 1.0)
    low = samples.rail[entry] + samples.aside[entry]
    high = samples.rail[entry + 1] + samples.aside[entry + 1]
    slack = FOOT_SHARE * max(fabs(samples.aside[entry]), fabs(samples.aside[entry + 1]))
    x, turned = turning_point(
        pair,
        place,
        low - slack,
        high + slack,
        low + t * (high - low),
        samples.wheel[entry] + t * cell.width,
        overlap.height,
        1.0,
    )
    meeting = place.meeting
    turned = turned and meeting.rate < 0.0
    if turned and meeting.overlap > 0.0 and not is_listed(overlap, x):
        append_point(overlap, x, meeting)
    return turned
