"""How a model of normal contact fills the patches of a wheel: one after the other by rising station, then
totals and ranks."""

from math import pi, sqrt

from ..layout import (
    REGION_LIMIT,
    SOLVED_PATCH_LIMIT,
    Patch,
    PatchTotals,
    Region,
    SideSearch,
    clear,
    copy,
    seldom,
)


def clear_patches(side: SideSearch):
    """No patches."""
    side.patch_count = 0
    clear(side.totals)


def begin_patch(side: SideSearch, region: Region, start: float, first: int, rule: int):
    """Begin the next patch at station ``start`` [m] and strip ``first``, at the point of ``region``; its
    index.

    Where there is no room for another patch, the last one goes on.
    """
    index = side.patch_count
    if index == SOLVED_PATCH_LIMIT:
        return index - 1
    side.patch_count = index + 1
    patch = side.patches[index]
    forget(patch)
    patch.totals.start = start
    patch.totals.stop = start
    patch.rail = region.rail
    patch.wheel = region.wheel
    patch.station = region.offset + region.station
    patch.x = region.x_track
    patch.slant = region.slant
    patch.rule = rule
    patch.first = first
    patch.last = first - 1
    return index


def forget(patch: Patch):
    """No load, no rank, no place and no motion.

    The strips along the rolling direction are cut anew before they are read: to clear them too would cost a
    rigid step 3 %.
    """
    clear(patch.totals)
    patch.pressure_square = 0.0
    patch.half_length_square = 0.0
    clear(patch.loads)
    clear(patch.moments)
    patch.rank = 0
    patch.penetration = 0.0
    patch.x_track = 0.0
    patch.y_track = 0.0
    patch.z_track = 0.0
    patch.rolling_radius = 0.0
    patch.normal_y = 0.0
    patch.normal_z = 0.0
    clear(patch.normal_moment)
    patch.damping_power = 0.0
    patch.creepage_x = 0.0
    patch.creepage_y = 0.0
    patch.spin = 0.0
    patch.speed = 0.0
    patch.creep_x = 0.0
    patch.creep_y = 0.0
    patch.creep_moment = 0.0
    patch.stick_share = 0.0
    patch.max_shear = 0.0
    patch.saturation = 0.0


def add_load(patch: Patch, region: int, load: float, moment: float):
    """Add load [N] and moment [N m] in a region to a patch."""
    patch.totals.load += load
    patch.totals.moment += moment
    patch.loads[region] += load
    patch.moments[region] += moment


def finish_patch(side: SideSearch):
    """Give the last patch, if there is one, what follows from its load, its edges and its largest squares."""
    if side.patch_count > 0:
        patch = side.patches[side.patch_count - 1]
        patch.totals.max_pressure = sqrt(patch.pressure_square)
        patch.totals.max_half_length = sqrt(patch.half_length_square)
        complete_totals(patch.totals)
        if patch.pressure_square == 0.0 and patch.totals.load > 0.0:
            fill_sliver(patch)


@seldom
def fill_sliver(patch: Patch):
    """Largest pressure and half-length of a loaded patch that lies between two strips: those of an ellipse
    with its load, area and width."""
    totals = patch.totals
    if totals.area > 0.0 and totals.width > 0.0:
        totals.max_pressure = 1.5 * totals.load / totals.area
        totals.max_half_length = 2.0 * totals.area / (pi * totals.width)
        patch.pressure_square = totals.max_pressure * totals.max_pressure
        patch.half_length_square = totals.max_half_length * totals.max_half_length


def complete_totals(totals: PatchTotals):
    """Centroid and width from load, moment and edges."""
    totals.width = totals.stop - totals.start
    if totals.load > 0.0:
        totals.centroid = totals.moment / totals.load


def remove_unloaded(side: SideSearch):
    """Take away patches that carry nothing in sum: between jumps of the curvatures the quadratic of the line
    load can be negative all over a sliver.  What they carry counts for their neighbours, so that the patches
    carry together what the regions do."""
    index = 0
    while side.patch_count > 1 and index < side.patch_count:
        if side.patches[index].totals.load > 0.0:
            index += 1
        else:
            remove_patch(side, index)
            index = 0


def remove_patch(side: SideSearch, index: int):
    """Take a finished patch away; the one before, or else the one behind it gets its load and its area."""
    beside = index - 1
    if beside < 0:
        beside = 1
    heir = side.patches[beside]
    removed = side.patches[index]
    heir.totals.load += removed.totals.load
    heir.totals.moment += removed.totals.moment
    heir.totals.area += removed.totals.area
    complete_totals(heir.totals)
    for region in range(REGION_LIMIT):
        heir.loads[region] += removed.loads[region]
        heir.moments[region] += removed.moments[region]
    side.patch_count = side.patch_count - 1
    for following in range(index, side.patch_count):
        copy(side.patches[following + 1], side.patches[following])


def finish_patches(side: SideSearch):
    """The totals of all patches that carry load, and their ranks, when the last patch is finished."""
    remove_unloaded(side)
    total_patches(side)
    for rank in range(1, side.patch_count + 1):
        heaviest = heaviest_patch(side)
        if heaviest >= 0:
            ranked = side.patches[heaviest]
            ranked.rank = rank


def total_patches(side: SideSearch):
    """The totals of all patches together."""
    totals = side.totals
    totals.load = 0.0
    totals.area = 0.0
    totals.moment = 0.0
    for index in range(side.patch_count):
        one = side.patches[index].totals
        totals.load += one.load
        totals.area += one.area
        totals.moment += one.moment
        totals.max_pressure = max(totals.max_pressure, one.max_pressure)
        totals.max_half_length = max(totals.max_half_length, one.max_half_length)
        if index == 0:
            totals.start = one.start
        totals.stop = one.stop
    complete_totals(totals)


def heaviest_patch(side: SideSearch):
    """Index of the heaviest patch that carries load and has no rank, of equal ones the first; -1 if there is
    none."""
    heaviest = -1
    load = 0.0
    for index in range(side.patch_count):
        patch = side.patches[index]
        if patch.rank == 0 and patch.totals.load > load:
            heaviest = index
            load = patch.totals.load
    return heaviest
