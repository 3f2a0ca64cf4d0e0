"""The contact of one side by strips (docs/method.md, section 9)."""

from math import isfinite

from ..contact.deep_points import deepest_entry
from ..contact.planes import locate_along_track
from ..contact.pressed_regions import gather_overlaps, sink_wheel
from ..layout import Contact, SideSearch, State, Tables
from .estimate import first_penetration
from .strip_patches import fill_from_strips
from .strip_zones import find_zones
from .strips import solve_strips


def strip_contact(tables: Tables, contact: Contact, state: State, side: SideSearch, force: float,
                  prescribed: float):
    """Fill the solved patches by strips; penetration [m], number of regions, and 1 when the force is
    satisfied, else 0."""
    by_penetration = 0
    if isfinite(prescribed):
        by_penetration = 1
    if not contact.frame.pressed:
        penetration = prescribed
        if by_penetration == 0:
            penetration = first_penetration(tables, contact, state, force)
        if sink_wheel(tables, contact.frame, contact.overlap, side, state, penetration) == 0:
            # it overlaps most at the end of a profile
            return penetration, 0, 0
    problem = contact.strip_problem
    problem.penetration = contact.frame.depth
    count = gather_overlaps(tables, contact.frame, contact.frames, contact.regions, contact.overlap, state)
    locate_along_track(tables, contact.frame, contact.regions, count)
    deepest = contact.overlap.points[deepest_entry(contact.overlap)]
    find_zones(tables, contact, state, count, deepest.depth)
    penetration, satisfied = solve_strips(tables, contact, state, count, force, by_penetration)
    if satisfied == 1:
        fill_from_strips(tables, contact, count)
    return penetration, count, satisfied
