"""The contact of one side by ANALYN and the strip correction."""

from math import isfinite

from ..contact.planes import locate_along_track
from ..layout import Contact, SideSearch, State, Tables
from .analyn_contact import solve_analyn
from .strip_patches import fill_from_strips
from .strip_placement import place_strips
from .strip_surfaces import describe_strips, incline_strips
from .strips import solve_strips


def strip_contact(tables: Tables, contact: Contact, state: State, side: SideSearch, force: float,
                  prescribed: float):
    """Fill the solved patches by the strip correction of ANALYN; penetration [m], number of regions, and 1
    when the force is satisfied, else 0."""
    by_penetration = 0
    if isfinite(prescribed):
        by_penetration = 1
    penetration, count, satisfied = solve_analyn(tables, contact, state, side, force, prescribed)
    if satisfied == 1:
        locate_along_track(tables, contact.frame, contact.regions, count)
        problem = contact.strip_problem
        place_strips(problem, contact.regions, contact.nodes, count, tables.strips, penetration)
        describe_strips(problem, contact.regions, contact.nodes)
        incline_strips(tables, contact.frame, problem, contact.regions)
        penetration, satisfied = solve_strips(problem, contact.regions, contact.nodes, contact.equations,
                                              tables, state, force, by_penetration)
        if satisfied == 1:
            fill_from_strips(problem, contact.regions, contact.solved)
    return penetration, count, satisfied
