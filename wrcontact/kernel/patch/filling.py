"""How a model of normal contact fills the solved patches: one after the other by rising station, then totals
and ranks."""

from math import sqrt

from ..layout import (
    SOLVED_PART_LIMIT,
    SOLVED_PATCH_LIMIT,
    SOLVED_PATCH_SIZE,
    PatchTotals,
    Region,
    SolvedPatch,
    SolvedPatches,
)


def clear_totals(totals: PatchTotals, start: float):
    """Totals of nothing, at station ``start`` [m]."""
    totals.load = 0.0
    totals.area = 0.0
    totals.moment = 0.0
    totals.centroid = 0.0
    totals.max_pressure = 0.0
    totals.max_half_length = 0.0
    totals.start = start
    totals.stop = start
    totals.width = 0.0
    return 0


def clear_patches(solved: SolvedPatches):
    """No patches."""
    solved.count = 0
    solved.part_count = 0
    clear_totals(solved.totals, 0.0)
    return 0


def begin_patch(solved: SolvedPatches, region: Region, start: float, first: int, rule: int,
                contact_angle: float):
    """Begin the next patch at station ``start`` [m] and strip ``first``, at the point of ``region``; its
    index.

    Where there is no room for another patch, the last one goes on.
    """
    index = solved.count
    if index == SOLVED_PATCH_LIMIT:
        return index - 1
    solved.count = index + 1
    solved.pressure_square = 0.0
    solved.half_length_square = 0.0
    patch = solved.patches[index]
    clear_totals(patch.totals, start)
    place_patch(patch, region, first, rule, contact_angle)
    return index


def place_patch(patch: SolvedPatch, region: Region, first: int, rule: int, contact_angle: float):
    """Give a patch the plane and the point of its region; it has no rank, and no strips behind ``first``
    yet."""
    patch.contact_angle = contact_angle
    patch.cos = region.cos
    patch.sin = region.sin
    patch.rail = region.rail
    patch.wheel = region.wheel
    patch.station = region.offset + region.station
    patch.x = region.x_track
    patch.slant = region.slant
    patch.rule = rule
    patch.first = first
    patch.last = first - 1
    patch.rank = 0
    return 0


def add_part(solved: SolvedPatches, patch: int, region: int, load: float, moment: float):
    """Add load [N] and moment [N m] in a region to the part of a patch that lies there: the
    last part, or a new one."""
    index = solved.part_count - 1
    known = 0
    if index >= 0:
        last = solved.parts[index]
        if last.patch == patch and last.region == region:
            known = 1
    if known == 0 and index < SOLVED_PART_LIMIT - 1:
        index += 1
        solved.part_count = index + 1
        part = solved.parts[index]
        part.patch = patch
        part.region = region
        part.load = 0.0
        part.moment = 0.0
    part = solved.parts[index]
    part.load += load
    part.moment += moment
    return 0


def fill_single(solved: SolvedPatches):
    """Let the first patch, whose totals are known, be the only one."""
    solved.count = 1
    solved.part_count = 0
    patch = solved.patches[0]
    patch.rank = 1
    one = patch.totals
    add_part(solved, 0, 0, one.load, one.moment)
    totals = solved.totals
    totals.load = one.load
    totals.area = one.area
    totals.moment = one.moment
    totals.centroid = one.centroid
    totals.max_pressure = one.max_pressure
    totals.max_half_length = one.max_half_length
    totals.start = one.start
    totals.stop = one.stop
    totals.width = one.width
    return 0


def finish_patch(solved: SolvedPatches):
    """Give the last patch, if there is one, what follows from its load, its edges and its largest squares."""
    if solved.count > 0:
        patch = solved.patches[solved.count - 1]
        totals = patch.totals
        totals.max_pressure = sqrt(solved.pressure_square)
        totals.max_half_length = sqrt(solved.half_length_square)
        complete_totals(totals)
    return 0


def complete_totals(totals: PatchTotals):
    """Centroid and width from load, moment and edges."""
    totals.width = totals.stop - totals.start
    if totals.load > 0.0:
        totals.centroid = totals.moment / totals.load
    return 0


def remove_unloaded(solved: SolvedPatches):
    """Take away patches that carry nothing in sum: between jumps of the curvatures the quadratic of the line
    load can be negative all over a sliver.  What they carry counts for their neighbours, so that the patches
    carry together what the regions do."""
    index = 0
    while solved.count > 1 and index < solved.count:
        if solved.patches[index].totals.load > 0.0:
            index += 1
        else:
            remove_patch(solved, index)
            index = 0
    return 0


def remove_patch(solved: SolvedPatches, index: int):
    """Take a finished patch away; the one before, or else the one behind it gets its load and its area."""
    heir = index - 1
    if heir < 0:
        heir = 1
    from_totals = solved.patches[index].totals
    totals = solved.patches[heir].totals
    totals.load += from_totals.load
    totals.moment += from_totals.moment
    totals.area += from_totals.area
    complete_totals(totals)
    for number in range(solved.part_count):
        part = solved.parts[number]
        if part.patch == index:
            hand_part(solved, number, heir)
    for number in range(solved.part_count):
        part = solved.parts[number]
        if part.patch > index:
            part.patch = part.patch - 1
    solved.count = solved.count - 1
    for following in range(index, solved.count):
        patch = solved.patches[following]
        behind = solved.patches[following + 1]
        for i in range(SOLVED_PATCH_SIZE):
            patch[i] = behind[i]
    return 0


def hand_part(solved: SolvedPatches, number: int, heir: int):
    """Give the part ``number`` to the patch ``heir``: to its part in the same region if it has one."""
    part = solved.parts[number]
    part.patch = heir
    for i in range(solved.part_count):
        other = solved.parts[i]
        if i != number and other.patch == heir and other.region == part.region:
            other.load += part.load
            other.moment += part.moment
            part.load = 0.0
            part.moment = 0.0
            break
    return 0


def finish_patches(solved: SolvedPatches):
    """The totals of all patches that carry load, and their ranks, when the last patch is finished."""
    remove_unloaded(solved)
    count = solved.count
    totals = solved.totals
    for index in range(count):
        patch = solved.patches[index]
        one = patch.totals
        totals.load += one.load
        totals.area += one.area
        totals.moment += one.moment
        if one.max_pressure > totals.max_pressure:
            totals.max_pressure = one.max_pressure
        if one.max_half_length > totals.max_half_length:
            totals.max_half_length = one.max_half_length
        if index == 0:
            totals.start = one.start
        totals.stop = one.stop
    complete_totals(totals)
    for rank in range(1, count + 1):
        heaviest = heaviest_patch(solved)
        if heaviest >= 0:
            ranked = solved.patches[heaviest]
            ranked.rank = rank
    return 0


def heaviest_patch(solved: SolvedPatches):
    """Index of the heaviest patch that carries load and has no rank, of equal ones the first; -1 if there is
    none."""
    heaviest = -1
    load = 0.0
    for index in range(solved.count):
        patch = solved.patches[index]
        if patch.rank == 0 and patch.totals.load > load:
            heaviest = index
            load = patch.totals.load
    return heaviest
