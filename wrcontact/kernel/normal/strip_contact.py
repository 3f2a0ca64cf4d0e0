"""The contact of one side by ANALYN and the strip correction."""

from math import isfinite

from ..contact.planes import line_up
from ..layout import SideSearch, State, Tables, Work
from ..patch.strip_patches import gather_strips
from .analyn_contact import solve_analyn
from .strips import correct_strips


def strip_contact(tables: Tables, work: Work, state: State, side: SideSearch, force: float, prescribed: float):
    """Fill the solved patches by the strip correction of ANALYN; penetration [m], number of regions, and 1 when the force is
    satisfied, else 0."""
    by_penetration = 0
    if isfinite(prescribed):
        by_penetration = 1
    penetration, count, satisfied = solve_analyn(tables, work, state, side, force, prescribed)
    if satisfied == 1:
        line_up(tables, work, count)
        penetration, strips, satisfied = correct_strips(tables, work, state, count, force, penetration, by_penetration)
        if satisfied == 1:
            gather_strips(work, strips)
    return penetration, count, satisfied
