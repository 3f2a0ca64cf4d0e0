"""From the solved patches to the outputs of a side: its totals and its heaviest patches."""

from ..layout import PATCH_LIMIT, Patch, SideOutputs, SolvedPatch, SolvedPatches


def write_patches(solved: SolvedPatches, side: SideOutputs):
    """The totals of all patches, and the PATCH_LIMIT heaviest patches by falling load, into the outputs of a side."""
    load = 0.0
    area = 0.0
    moment = 0.0
    pressure = 0.0
    half_length = 0.0
    count = solved.count
    for index in range(count):
        patch = solved.patches[index]
        load += patch.load
        area += patch.area
        moment += patch.moment
        if patch.max_pressure > pressure:
            pressure = patch.max_pressure
        if patch.max_half_length > half_length:
            half_length = patch.max_half_length
        rank = patch.rank
        if rank > 0 and rank <= PATCH_LIMIT:
            write_patch(patch, side.patch[rank - 1])
    side.patch_count = float(count)
    side.normal_force = load
    side.area = area
    side.max_pressure = pressure
    side.patch_length = 2.0 * half_length
    if count > 0:
        last = solved.patches[count - 1]
        first = solved.patches[0]
        side.patch_width = last.stop - first.start
        side.patch_centroid = moment / load
    return 0


def write_patch(patch: SolvedPatch, to: Patch):
    """One patch into its outputs."""
    to.normal_force = patch.load
    to.area = patch.area
    to.max_pressure = patch.max_pressure
    to.length = 2.0 * patch.max_half_length
    to.width = patch.stop - patch.start
    to.centroid = patch.moment / patch.load
    to.contact_angle = patch.contact_angle
    return 0
