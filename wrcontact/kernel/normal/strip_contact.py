"""The strip model: strips of the rail that press on each other through the elastic half-space
(docs/theory/strips.md).

Each strip has a place s_j along the rail, a middle x_j and a half-length a_j along the track, and the
pressure p_j sqrt(1 - ((x - x_j) / a_j)^2).  What it displaces is eq. (S1).  Wheel and rail are traced once
(strip_surfaces); the strips lie in runs from edge to edge, which begin like ANALYN's patches (strip_levels).
One round of

1. solve sum_j F_ij y_j = c_i penetration - g_i with y = p / (pi E*) and the given force, eq. (S5)
   (strip_pressures),
2. correct every half-length by how much less the surface is displaced towards the ends of the strip than the
   gap rises, and let the middle move to where both ends are alike, eqs. (S6) and (S7); let the edges move to
   where the pressure falls like a square root, eq. (S14) (strip_lengths),
3. cut runs where they pull, and join those that have met (strip_runs)

is a sweep.  There are always as many, so that results follow the pose smoothly.
"""

from math import isfinite, pi
from typing import Final

from ..contact.penetration_maxima import deepest_entry
from ..contact.frame import is_yawed, locate_along_track
from ..contact.penetrated_regions import gather_overlaps, sink_wheel
from ..layout import SEPARATION_VERTICAL, Contact, Pair, SideSearch, StripProblem, Tables
from .analyn_contact import solve_analyn
from .estimate import first_penetration
from .strip_levels import begin_runs, deepen_levels, level_contact
from .strip_lengths import RELAXED, correct_lengths
from .strip_patches import add_stiffness, fill_from_strips
from .strip_pressures import solve_pressures
from .strip_runs import lay_strips, renew_runs
from .strip_surfaces import find_zones, measure_ridges, trace_zones

#: Sweeps of the form for first trials.
FIRST_SWEEPS: Final[int] = 2
#: The gap counts by its smooth part in so many last sweeps; before, points of it are near enough.
SMOOTH_SWEEPS: Final[int] = 4
#: A wheel that just touched is sunk anew where it stands deeper than this many times its estimate, at most so
#: often: the patch may reach farther than its strips do.
SUNK_DEEPER: Final[float] = 1.15
#: One that needs less than this share of it stood at a wrong depth, where it overlaps its rail at another
#: place by far more.
SUNK_LESS: Final[float] = 0.5
SINKINGS: Final[int] = 4
#: Strips whose load or largest pressure is off what ANALYN's levels have by more than this factor are wrong.
#: Right ones carry 0.50 ... 1.62 of that load, and have a largest pressure of up to 2.2 times that one.
PARTED: Final[float] = 3.0
#: The same with distances along the vertical: they rise suddenly in the flange root, where levels are narrow
#: and strips bridge them; right ones have up to 9 times the levels' largest pressure there.
PARTED_VERTICAL: Final[float] = 15.0
#: Strips that carry less are not judged [N]: their levels are within what gaps are known to.
LIGHTEST: Final[float] = 1.0


def strip_contact(pair: Pair, contact: Contact, side: SideSearch, force: float, prescribed: float):
    """Fill the patches of a side by strips if they are wanted; penetration [m], number of regions, and
    whether the force is satisfied.

    A wheel that just touches is sunk to an estimated penetration first.
    """
    by_penetration = isfinite(prescribed)
    if contact.frame.pressed:
        count = open_zones(pair, contact)
        start_runs(pair, contact)
        penetration = sweep_strips(pair, contact, pair.tables.sweeps, force, by_penetration)
    elif by_penetration:
        penetration, count = sink_strips(pair, contact, side, force, prescribed, True)
    else:
        estimate = first_penetration(pair, contact, force)
        penetration, count = sink_strips(pair, contact, side, force, estimate, False)
        if count > 0 and (penetration < SUNK_LESS * contact.frame.depth or contact.strip_problem.count == 0):
            estimate, count, known = solve_analyn(pair, contact, side, force, prescribed)
            if not known:
                # the regions are now ANALYN's, and the strips stand at a wrong depth
                return contact.frame.depth, count, False
            penetration, count = sink_strips(pair, contact, side, force, estimate, False)
    if count == 0:
        return contact.frame.depth, 0, False
    if not penetration > 0.0:
        # strips of picometres on a straight gap can ask for less than nothing
        penetration = contact.frame.depth
    satisfied = contact.strip_problem.count > 0
    if contact.filling and satisfied:
        satisfied = agrees_with_levels(pair.tables, contact.strip_problem)
    if satisfied:
        add_stiffness(pair.tables, contact.regions, contact.strip_problem, contact.equations, count)
        if contact.filling:
            locate_along_track(pair, contact.frame, contact.regions, count)
            fill_from_strips(pair.tables, contact, side, count)
    return penetration, count, satisfied


def sink_strips(
    pair: Pair, contact: Contact, side: SideSearch, force: float, estimate: float, by_penetration: bool
):
    """Penetration [m] and number of regions of a wheel that is sunk to an ``estimate`` [m] of it, and then to
    the one that ANALYN's levels have there; no region where it overlaps most at the end of a profile."""
    penetration = estimate
    count = 0
    for repeat in range(SINKINGS):
        if sink_wheel(pair, contact.frame, contact.overlap, side, penetration) == 0:
            return penetration, 0
        count = open_zones(pair, contact)
        if by_penetration:
            break
        deeper = penetration + deepen_levels(contact.strip_problem, force)
        if deeper < SUNK_DEEPER * penetration:
            break
        penetration = deeper
    start_runs(pair, contact)
    return sweep_strips(pair, contact, pair.tables.sweeps, force, by_penetration), count


def agrees_with_levels(tables: Tables, problem: StripProblem) -> bool:
    """Whether the load of the strips is about that of ANALYN's levels, which the sweeps leave as they are, and
    their largest pressure not far above theirs.

    Below it can be far, where a joint of arcs lets a level be narrow that the strips bridge.  Strips that all
    together pull are wrong, however little they carry.
    """
    load, pressure = level_contact(problem)
    parted = PARTED
    if tables.separation == SEPARATION_VERTICAL:
        parted = PARTED_VERTICAL
    normal = 0.0
    carried = 0.0
    largest = 0.0
    for i in range(problem.count):
        strip = problem.strips[i]
        normal += strip.half_length * strip.width * strip.y
        carried += strip.half_length * strip.width * strip.counted * strip.y
        largest = max(largest, strip.y)
    carried *= 0.5 * pi * pi * tables.contact_modulus
    largest *= pi * tables.contact_modulus
    if not normal > 0.0:
        return False
    if carried < LIGHTEST and load < LIGHTEST:
        return True
    return carried > load / parted and carried < load * parted and largest < pressure * parted


def coarse_contact(pair: Pair, contact: Contact, force: float):
    """As ``strip_contact`` for a wheel that is pressed and carries ``force`` [N], from the first sweeps alone
    and without patches: about a per cent off."""
    count = open_zones(pair, contact)
    start_runs(pair, contact)
    penetration = sweep_strips(pair, contact, FIRST_SWEEPS, force, False)
    if not penetration > 0.0:
        penetration = contact.frame.depth
    satisfied = contact.strip_problem.count > 0
    if satisfied:
        add_stiffness(pair.tables, contact.regions, contact.strip_problem, contact.equations, count)
    return penetration, count, satisfied


def open_zones(pair: Pair, contact: Contact):
    """Open the regions where the wheel overlaps its rail, and trace both there; how many regions."""
    problem = contact.strip_problem
    problem.penetration = contact.frame.depth
    count = gather_overlaps(pair, contact.frame, contact.frames, contact.regions, contact.overlap)
    deepest = contact.overlap.points[deepest_entry(contact.overlap)]
    find_zones(pair, contact, count, deepest.depth)
    trace_zones(pair, contact, count)
    return count


def start_runs(pair: Pair, contact: Contact):
    """The first runs, and the gap beside a yawed wheel's ridge."""
    if is_yawed(contact.frame):
        measure_ridges(pair, contact.frame.place, contact.strip_problem)
    begin_runs(contact.strip_problem, pair.tables.waves)


def sweep_strips(pair: Pair, contact: Contact, sweeps: int, force: float, by_penetration: bool):
    """Make so many sweeps; penetration [m], which may be less than nothing.

    Of a wheel that stands where it is pressed, the force counts in the last sweep only: where it carries
    that, the strips are those of a wheel that is pressed so deep.  The last correction is for the patches
    alone.
    """
    tables = pair.tables
    problem = contact.strip_problem
    yawed = is_yawed(contact.frame)
    penetration = problem.penetration
    found = penetration
    for sweep in range(sweeps):
        if problem.count == 0:
            break
        last = sweep == sweeps - 1
        given = by_penetration
        if contact.frame.pressed and not contact.frame.sunk and not last:
            given = True
        lay_strips(problem, tables.waves, sweep >= sweeps - SMOOTH_SWEEPS)
        found = solve_pressures(tables, problem, contact.equations, force, given, yawed)
        if found > 0.0:
            penetration = found
        if not last or contact.filling:
            share = RELAXED
            if sweep == 0:
                # half-lengths do not swing yet
                share = 1.0
            correct_lengths(tables, problem, penetration, yawed, share)
        if not last:
            renew_runs(problem, tables.waves)
    return found
