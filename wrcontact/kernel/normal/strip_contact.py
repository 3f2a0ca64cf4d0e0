"""The strip model: strips of the rail that press on each other through the elastic half-space
(docs/method.md, section 9).

Each strip has a place s_j along the rail, a middle x_j and a half-length a_j along the track, and the
pressure p_j sqrt(1 - ((x - x_j) / a_j)^2).  What it displaces is eq. (S1).  One round of

1. solve sum_j F_ij y_j = c_i penetration - g_i with y = h p / (pi E*) >= 0 and the given force, eq. (S5)
   (strip_pressures); F_ij is how strip j displaces the middle of strip i, eqs. (S2) and (S4)
   (strip_pressures),
2. correct every half-length by how much less the surface is displaced towards the ends of the strip than the
   gap rises, and let the middle move to where both ends are alike, eqs. (S6) and (S7) (strip_lengths)

is a sweep.  Strips are laid twice (strip_layout): evenly over the overlap, and by the pressures that were
found.

The first strips lie where wheel and rail overlap as they are laid.
"""

from math import isfinite, sqrt
from typing import Final

from ..contact.deep_points import deepest_entry
from ..contact.frame import enter_plane, is_yawed, leave_plane, locate_along_track
from ..contact.pressed_regions import gather_overlaps, sink_deeper, sink_wheel
from ..contact.widths import zone_width
from ..layout import Contact, Pair, Region, SideSearch, StripZone, Tables
from .estimate import first_penetration
from .strip_layout import FIRST_SHARE, divide_cells, strip_cells, zone_cells
from .strip_lengths import FIRST_POWER, POWER, adopt_lengths, correct_lengths
from .strip_patches import add_stiffness, fill_from_strips
from .strip_pressures import begin_influences, solve_pressures
from .strip_surfaces import (first_lengths, incline_strips, lengths_before, place_on_middle, set_gaps,
                             trace_strips)

#: A zone ends where the overlap has fallen to this share of the deepest one, or of its own: far from the
#: deepest, a region is loaded long before it is so deep.
SHALLOW: Final[float] = 0.03
OWN_SHALLOW: Final[float] = 0.25
#: Sweeps of the first layout.
FIRST_SWEEPS: Final[int] = 1
#: Where the first strips show that the wheel stands deeper than this many times its estimate, it is sunk
#: anew, at most so often: the patch may reach farther than its strips do.
SUNK_DEEPER: Final[float] = 1.15
SINKINGS: Final[int] = 4


def find_zones(pair: Pair, contact: Contact, count: int, deepest: float):
    """The zones of ``count`` regions, of which the deepest overlaps by ``deepest`` [m]."""
    for index in range(count):
        region = contact.regions[index]
        enter_plane(contact.frame, contact.frames, region, index)
        measure_zone(pair, contact, region, contact.strip_problem.zones[index], deepest)
        leave_plane(contact.frame, contact.frames, region)


def measure_zone(pair: Pair, contact: Contact, region: Region, zone: StripZone, deepest: float):
    """The zone of a region whose frame is open; without width where nothing overlaps."""
    zone.start = region.offset + region.station
    zone.stop = zone.start
    depth = contact.frame.depth
    shallow = min(SHALLOW * deepest, OWN_SHALLOW * depth)
    level = depth - shallow
    zone.level = 0.0
    if level > 0.0:
        zone.level = level
        bend = max(region.bend, region.curvature)
        estimate = sqrt(2.0 * level / bend)
        contact.frame.blur = 0.0
        high = zone_width(pair, contact.frame, contact.origin, region, 1.0, level, estimate)
        low = zone_width(pair, contact.frame, contact.origin, region, -1.0, level, high)
        zone.stop = zone.start + high
        zone.start -= low


def lay_strips(pair: Pair, contact: Contact, count: int, wanted: int):
    """Divide the cells into about ``wanted`` strips, with the surfaces at each."""
    problem = contact.strip_problem
    divide_cells(problem, contact.regions, count, wanted)
    trace_strips(pair, contact, count)
    place_on_middle(problem.strips, problem.count)
    incline_strips(pair.tables, contact.frame, problem)


def first_layout(pair: Pair, contact: Contact, count: int, force: float, by_penetration: bool):
    """Strips that lie evenly over the zones of ``count`` regions, as the cells of the second layout; their
    penetration [m] under ``force`` [N], or the problem's where ``by_penetration``, and whether found."""
    problem = contact.strip_problem
    zone_cells(problem, count)
    lay_strips(pair, contact, count, int(FIRST_SHARE * float(pair.tables.strips) + 0.5))
    first_lengths(pair, contact, count)
    penetration = problem.penetration
    found = False
    for sweep in range(FIRST_SWEEPS):
        penetration, found = solve_strips(pair.tables, contact, force, by_penetration)
        if not found:
            return penetration, found
        correct_lengths(pair.tables, problem, penetration, FIRST_POWER, is_yawed(contact.frame))
        adopt_lengths(problem)
    strip_cells(problem)
    return penetration, found


def second_layout(pair: Pair, contact: Contact, count: int, force: float, by_penetration: bool):
    """Strips that are laid by the pressures of the first layout, solved; results as there.

    Of a wheel that stands where it is pressed, the force counts in the last sweep only: where it carries
    that, the strips are those of a wheel that is pressed so deep.  The last correction is for the patches
    alone.
    """
    problem = contact.strip_problem
    lay_strips(pair, contact, count, pair.tables.strips)
    lengths_before(pair, contact.frame, problem)
    penetration = problem.penetration
    found = False
    for sweep in range(pair.tables.sweeps):
        last = sweep == pair.tables.sweeps - 1
        given = True
        if last or contact.frame.sunk:
            given = by_penetration
        penetration, found = solve_strips(pair.tables, contact, force, given)
        if not found:
            return penetration, found
        if not last or contact.filling:
            correct_lengths(pair.tables, problem, penetration, POWER, is_yawed(contact.frame))
        if not last:
            adopt_lengths(problem)
    return penetration, found


def solve_strips(tables: Tables, contact: Contact, force: float, by_penetration: bool):
    """Pressures of the strips as they lie; penetration [m], and whether found."""
    problem = contact.strip_problem
    set_gaps(problem)
    begin_influences(problem)
    return solve_pressures(problem, contact.equations, tables, force, by_penetration, is_yawed(contact.frame))


def strip_contact(pair: Pair, contact: Contact, side: SideSearch, force: float, prescribed: float):
    """Fill the patches of a side by strips if they are wanted; penetration [m], number of regions, and
    whether the force is satisfied.

    A wheel that just touches is sunk to an estimated penetration first, and then to the one that the strips
    have found there.
    """
    by_penetration = isfinite(prescribed)
    problem = contact.strip_problem
    if contact.frame.pressed:
        # where it is, it has its penetration
        count = open_zones(pair, contact)
        penetration, satisfied = first_layout(pair, contact, count, force, True)
    else:
        estimate = prescribed
        if not by_penetration:
            estimate = first_penetration(pair, contact, force)
        penetration = estimate
        count = 0
        satisfied = False
        for repeat in range(SINKINGS):
            estimate = penetration
            if sink_wheel(pair, contact.frame, contact.overlap, side, estimate) == 0:
                # it overlaps most at the end of a profile
                return estimate, 0, False
            count = open_zones(pair, contact)
            penetration, satisfied = first_layout(pair, contact, count, force, by_penetration)
            if not satisfied or penetration < SUNK_DEEPER * estimate:
                break
        if satisfied and not by_penetration:
            sink_deeper(contact.frame, contact.frames, contact.regions, count, penetration)
            problem.penetration = penetration
    if satisfied:
        penetration, satisfied = second_layout(pair, contact, count, force, by_penetration)
    if satisfied:
        add_stiffness(pair.tables, contact.regions, problem, contact.equations, count)
    if satisfied and contact.filling:
        locate_along_track(pair, contact.frame, contact.regions, count)
        fill_from_strips(pair.tables, contact, side, count)
    return penetration, count, satisfied


def coarse_contact(pair: Pair, contact: Contact, force: float):
    """As ``strip_contact`` for a wheel that is pressed and carries ``force`` [N], from the first layout alone
    and without patches: about a per cent off."""
    count = open_zones(pair, contact)
    penetration, satisfied = first_layout(pair, contact, count, force, False)
    if satisfied:
        add_stiffness(pair.tables, contact.regions, contact.strip_problem, contact.equations, count)
    return penetration, count, satisfied


def open_zones(pair: Pair, contact: Contact):
    """Open the regions where the wheel overlaps its rail, and their zones; how many."""
    contact.strip_problem.penetration = contact.frame.depth
    count = gather_overlaps(pair, contact.frame, contact.frames, contact.regions, contact.overlap)
    deepest = contact.overlap.points[deepest_entry(contact.overlap)]
    find_zones(pair, contact, count, deepest.depth)
    return count
