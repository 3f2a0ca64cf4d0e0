"""The strip model: strips of the rail that press on each other through the elastic half-space
(docs/method.md, section 9).

Each strip has a place s_j along the rail, a middle x_j and a half-length a_j along the track, and the
pressure p_j sqrt(1 - ((x - x_j) / a_j)^2).  What it displaces is eq. (S1).  One round of

1. solve sum_j F_ij y_j = c_i penetration - g_i with y = h p / (pi E*) >= 0 and the given force, eq. (S5)
   (strip_pressures); F_ij is how strip j displaces the middle of strip i, eqs. (S2) and (S4)
   (strip_influence),
2. correct every half-length by how much less the surface is displaced towards the ends of the strip than the
   gap rises, and let the middle move to where both ends are alike, eqs. (S6) and (S7) (strip_lengths)

is a sweep.  Strips are laid twice (strip_layout): evenly over the overlap, and by the pressures that were
found.
"""

from typing import Final

from ..contact.contact_plane import is_yawed
from ..layout import Contact, State, Tables
from .strip_influence import begin_influences
from .strip_layout import FIRST_SHARE, divide_cells, strip_cells, zone_cells
from .strip_lengths import FIRST_POWER, POWER, adopt_lengths, correct_lengths
from .strip_pressures import solve_pressures
from .strip_surfaces import (first_lengths, incline_strips, lengths_before, place_on_middle, set_gaps,
                             trace_strips)

#: Sweeps of the first layout.
FIRST_SWEEPS: Final[int] = 1


def lay_strips(tables: Tables, contact: Contact, state: State, count: int, wanted: int):
    """Divide the cells into about ``wanted`` strips, with the surfaces at each."""
    problem = contact.strip_problem
    divide_cells(problem, contact.regions, count, wanted)
    trace_strips(tables, contact, state, count)
    place_on_middle(problem.strips, problem.count)
    incline_strips(tables, contact.frame, problem)


def first_layout(tables: Tables, contact: Contact, state: State, count: int, force: float,
                 by_penetration: bool):
    """Strips that lie evenly over the zones of ``count`` regions, as the cells of the second layout; their
    penetration [m] under ``force`` [N], or the problem's where ``by_penetration``, and whether found."""
    problem = contact.strip_problem
    zone_cells(problem, count)
    lay_strips(tables, contact, state, count, int(FIRST_SHARE * float(tables.strips) + 0.5))
    first_lengths(tables, contact, count)
    penetration = problem.penetration
    found = False
    for sweep in range(FIRST_SWEEPS):
        penetration, found = solve_strips(tables, contact, state, force, by_penetration)
        if not found:
            return penetration, found
        correct_lengths(tables, problem, penetration, FIRST_POWER, is_yawed(contact.frame))
        adopt_lengths(problem)
    strip_cells(problem)
    return penetration, found


def second_layout(tables: Tables, contact: Contact, state: State, count: int, force: float,
                  by_penetration: bool):
    """Strips that are laid by the pressures of the first layout, solved; results as there.

    Of a wheel that stands where it is pressed, the force counts in the last sweep only: where it carries
    that, the strips are those of a wheel that is pressed so deep.  The last correction is for the patches
    alone.
    """
    problem = contact.strip_problem
    lay_strips(tables, contact, state, count, tables.strips)
    lengths_before(tables, contact.frame, problem)
    penetration = problem.penetration
    found = False
    for sweep in range(tables.sweeps):
        last = sweep == tables.sweeps - 1
        given = True
        if last or contact.frame.sunk:
            given = by_penetration
        penetration, found = solve_strips(tables, contact, state, force, given)
        if not found:
            return penetration, found
        if not last or contact.filling:
            correct_lengths(tables, problem, penetration, POWER, is_yawed(contact.frame))
        if not last:
            adopt_lengths(problem)
    return penetration, found


def solve_strips(tables: Tables, contact: Contact, state: State, force: float, by_penetration: bool):
    """Pressures of the strips as they lie; penetration [m], and whether found."""
    problem = contact.strip_problem
    set_gaps(problem)
    begin_influences(problem)
    return solve_pressures(problem, contact.equations, tables, state, force, by_penetration,
                           is_yawed(contact.frame))
