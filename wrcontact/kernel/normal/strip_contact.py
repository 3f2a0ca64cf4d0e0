"""The contact of one side by strips (docs/method.md, section 9)."""

from math import isfinite
from typing import Final

from ..contact.deep_points import deepest_entry
from ..contact.planes import locate_along_track
from ..contact.pressed_regions import gather_overlaps, sink_deeper, sink_wheel
from ..layout import Contact, SideSearch, State, Tables
from .estimate import first_penetration
from .strip_patches import add_stiffness, fill_from_strips
from .strip_zones import find_zones
from .strips import first_layout, second_layout

#: Where the first strips show that the wheel stands deeper than this many times its estimate, it is sunk
#: anew, at most so often: the patch may reach farther than its strips do.
DEEPER: Final[float] = 1.15
SINKINGS: Final[int] = 4


def strip_contact(tables: Tables, contact: Contact, state: State, side: SideSearch, force: float,
                  prescribed: float):
    """Fill the patches of a side by strips if they are wanted; penetration [m], number of regions, and
    whether the force is satisfied.

    A wheel that just touches is sunk to an estimated penetration first, and then to the one that the strips
    have found there.
    """
    by_penetration = isfinite(prescribed)
    problem = contact.strip_problem
    if contact.frame.pressed:
        # where it is, it has its penetration
        count = open_zones(tables, contact, state)
        penetration, satisfied = first_layout(tables, contact, state, count, force, True)
    else:
        estimate = prescribed
        if not by_penetration:
            estimate = first_penetration(tables, contact, state, force)
        penetration = estimate
        count = 0
        satisfied = False
        for repeat in range(SINKINGS):
            estimate = penetration
            if sink_wheel(tables, contact.frame, contact.overlap, side, state, estimate) == 0:
                # it overlaps most at the end of a profile
                return estimate, 0, False
            count = open_zones(tables, contact, state)
            penetration, satisfied = first_layout(tables, contact, state, count, force, by_penetration)
            if not satisfied or penetration < DEEPER * estimate:
                break
        if satisfied and not by_penetration:
            sink_deeper(contact.frame, contact.frames, contact.regions, count, penetration)
            problem.penetration = penetration
    if satisfied:
        penetration, satisfied = second_layout(tables, contact, state, count, force, by_penetration)
    if satisfied:
        add_stiffness(tables, contact.regions, problem, contact.equations, count)
    if satisfied and contact.filling:
        locate_along_track(tables, contact.frame, contact.regions, count)
        fill_from_strips(tables, contact, side, count)
    return penetration, count, satisfied


def coarse_contact(tables: Tables, contact: Contact, state: State, force: float):
    """As ``strip_contact`` for a wheel that is pressed and carries ``force`` [N], from the first layout alone
    and without patches: about a per cent off."""
    count = open_zones(tables, contact, state)
    penetration, satisfied = first_layout(tables, contact, state, count, force, False)
    if satisfied:
        add_stiffness(tables, contact.regions, contact.strip_problem, contact.equations, count)
    return penetration, count, satisfied


def open_zones(tables: Tables, contact: Contact, state: State):
    """Open the regions where the wheel overlaps its rail, and their zones; how many."""
    contact.strip_problem.penetration = contact.frame.depth
    count = gather_overlaps(tables, contact.frame, contact.frames, contact.regions, contact.overlap, state)
    deepest = contact.overlap.points[deepest_entry(contact.overlap)]
    find_zones(tables, contact, state, count, deepest.depth)
    return count
