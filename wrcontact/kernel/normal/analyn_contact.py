"""ANALYN's contact of one side: estimate, regions, nodes, local penetrations, patches.

1. Estimate the penetration from the force and the width of the interpenetration,
2. find the regions that it reaches, and the half-width of each one's interpenetration, which sets
3. spacing and window of the nodes, on which
4. the force is satisfied.

The estimate depends on pose and force alone and is smooth in them, and so is the result.
"""

from math import isfinite
from typing import Final

from ..contact.penetration_maxima import keep_deepest
from ..contact.frame import locate_along_track
from ..contact.penetrated_regions import gather_overlaps, sink_wheel
from ..contact.widths import keep_widths, start_widths
from ..layout import REGION_LIMIT, Contact, Pair, SideSearch
from .analyn import solve_penetrations
from .estimate import first_penetration, start_penetrations
from .nodes import covered, prepare_regions
from .node_patches import fill_from_nodes

#: Regions and nodes are laid anew while the estimate was off by more than this factor.
ESTIMATE_FACTOR: Final[float] = 1.5
ESTIMATE_REPEATS: Final[int] = 4
#: Nodes that do not cover the patch are laid anew so often, each time this much farther.
COVER_REPEATS: Final[int] = 6
ENLARGED: Final[float] = 1.4


def analyn_contact(pair: Pair, contact: Contact, side: SideSearch, force: float, prescribed: float):
    """Fill the patches of a side by ANALYN if they are wanted; penetration [m], number of regions, and
    whether the force is satisfied."""
    penetration, count, satisfied = solve_analyn(pair, contact, side, force, prescribed)
    if satisfied and contact.filling:
        fill_from_analyn(pair, contact, side, count)
    return penetration, count, satisfied


def fill_from_analyn(pair: Pair, contact: Contact, side: SideSearch, count: int):
    """Fill the patches of a side from ``count`` regions that carry their loads."""
    locate_along_track(pair, contact.frame, contact.regions, count)
    fill_from_nodes(contact, side, count)


def solve_analyn(pair: Pair, contact: Contact, side: SideSearch, force: float, prescribed: float):
    """Penetration [m] and number of regions under ``force`` [N], or at ``prescribed`` penetration [m] if that
    is a number; third value: whether the force is satisfied.  A pressed wheel has its regions where it
    stands."""
    by_penetration = False
    penetration = prescribed
    if isfinite(prescribed):
        by_penetration = True
    contact.first_widths.penetration = 0.0
    if contact.frame.pressed:
        penetration, count, satisfied = solve_estimated(
            pair, contact, contact.frame.depth, force, by_penetration
        )
        return penetration, count, satisfied
    if not by_penetration:
        penetration = first_penetration(pair, contact, force)
        keep_widths(contact.first_widths, contact.regions[0])
    count = 0
    satisfied = False
    for repeat in range(ESTIMATE_REPEATS):
        estimate = penetration
        if sink_wheel(pair, contact.frame, contact.overlap, side, estimate) == 0:
            # it overlaps most at the end of a profile
            return penetration, 0, False
        penetration, count, satisfied = solve_estimated(pair, contact, estimate, force, by_penetration)
        if penetration < ESTIMATE_FACTOR * estimate and ESTIMATE_FACTOR * penetration > estimate:
            break
    return penetration, count, satisfied


def solve_estimated(pair: Pair, contact: Contact, estimate: float, force: float, by_penetration: bool):
    """Penetration [m] and number of regions, with regions and nodes laid for the ``estimate`` of it; third
    value: whether the force is satisfied."""
    count = gather_regions(pair, contact, estimate)
    penetration, satisfied = solve_fine(pair, contact, count, force, estimate, by_penetration)
    if not satisfied and count > 1:
        # regions so close that pressing on each other has no fixed point are one region
        keep_deepest(contact.overlap)
        count = gather_regions(pair, contact, estimate)
        penetration, satisfied = solve_fine(pair, contact, count, force, estimate, by_penetration)
    return penetration, count, satisfied


def gather_regions(pair: Pair, contact: Contact, penetration: float):
    """Open the regions where the wheel overlaps its rail, with their first local penetrations; their
    number."""
    for i in range(REGION_LIMIT):
        contact.regions[i].slant = 0.0
    count = gather_overlaps(pair, contact.frame, contact.frames, contact.regions, contact.overlap)
    for i in range(count):
        start_widths(contact.first_widths, contact.regions[i])
    start_penetrations(contact.regions, count, penetration)
    return count


def solve_fine(
    pair: Pair, contact: Contact, count: int, force: float, penetration: float, by_penetration: bool
):
    """Penetration [m] on fine nodes over the regions, laid again where the patch outgrows them; and whether
    the force is satisfied."""
    start = penetration
    enlarge = 1.0
    satisfied = False
    for repeat in range(COVER_REPEATS):
        prepare_regions(pair, contact, count, enlarge)
        penetration, satisfied = solve_penetrations(
            pair.tables, contact.regions, contact.nodes, count, force, start, by_penetration
        )
        if not satisfied:
            return start, satisfied
        if covered(contact.frame, contact.regions, contact.nodes, count):
            break
        if repeat < COVER_REPEATS - 1:
            enlarge *= ENLARGED
            start = penetration
            # nodes stay where the wheel stands; there are only more of them
            start_penetrations(contact.regions, count, contact.frame.depth)
    return penetration, satisfied
