"""From the solved patches to the outputs of a side: its totals and its heaviest patches."""

from ..layout import PATCH_LIMIT, Patch, SideOutputs, SolvedPatch, SolvedPatches


def write_patches(solved: SolvedPatches, side: SideOutputs):
    """The totals of all patches, and the PATCH_LIMIT heaviest patches by falling load, into the outputs of a
    side."""
    totals = solved.totals
    side.patch_count = float(solved.count)
    side.normal_force = totals.load
    side.area = totals.area
    side.max_pressure = totals.max_pressure
    side.patch_length = 2.0 * totals.max_half_length
    side.patch_width = totals.width
    side.patch_centroid = totals.centroid
    for index in range(solved.count):
        patch = solved.patches[index]
        rank = patch.rank
        if rank > 0 and rank <= PATCH_LIMIT:
            write_patch(patch, side.patch[rank - 1])
    return 0


def write_patch(patch: SolvedPatch, to: Patch):
    """One patch into its outputs."""
    totals = patch.totals
    to.normal_force = totals.load
    to.area = totals.area
    to.max_pressure = totals.max_pressure
    to.length = 2.0 * totals.max_half_length
    to.width = totals.width
    to.centroid = totals.centroid
    to.contact_angle = patch.contact_angle
    to.penetration = patch.local_penetration
    force = patch.force
    to.rolling_radius = force.rolling_radius
    to.x_track = force.x_track
    to.y_track = force.y_track
    to.z_track = force.z_track
    to.force[0] = 0.0
    to.force[1] = force.y
    to.force[2] = force.z
    return 0
