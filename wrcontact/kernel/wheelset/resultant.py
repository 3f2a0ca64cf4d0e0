"""The resultant of the contact forces on the wheelset, in the track's axes.

The rail pushes the wheel along the normal (0, -+ sin(angle), -cos(angle)), on the right and on the left,
where a region's load acts: the rail's normal there, or the mean over the region where that is known
(mean_normal.py).  The moment is that about the wheelset's centre, which is the nominal radius above the
running circles.

Forces are summed over the parts of patches: a patch that reaches over the bound between two regions has two
normals and two points, one for each.  The force of a patch is the sum over its parts, that of a wheel the sum
over its patches, and that of the wheelset the sum over both wheels.
"""

from math import atan, sqrt

from ..contact.arc_length import rail_abscissa
from ..layout import (
    LOAD_VERTICAL,
    RESULTANT_COUNT,
    Contact,
    Frame,
    Inputs,
    Outputs,
    Region,
    Resultant,
    SolvedPart,
    SolvedPatch,
    Tables,
)
from ..surface.profile_table import height_slope
from ..surface.rails import on_track


def clear_resultant(resultant: Resultant):
    """No force and no moment."""
    for i in range(RESULTANT_COUNT):
        resultant[i] = 0.0
    return 0


def add_patches(tables: Tables, contact: Contact, penetration: float, mirror: float, resultant: Resultant):
    """Forces and local penetrations of the solved patches of a side with this ``penetration`` [m], and their
    resultant about the track's origin; ``mirror`` = 1 on the right, -1 on the left."""
    solved = contact.solved
    for index in range(solved.count):
        clear_force(solved.patches[index])
    for index in range(solved.part_count):
        part = solved.parts[index]
        if part.load != 0.0:
            patch = solved.patches[part.patch]
            region = contact.regions[part.region]
            local = region.alignment * penetration - region.gap
            if local > patch.local_penetration:
                patch.local_penetration = local
            add_part_force(tables, contact.frame, region, part, patch, mirror, resultant)
    for index in range(solved.count):
        finish_force(solved.patches[index], mirror)
    return 0


def clear_force(patch: SolvedPatch):
    """No force and no penetration yet."""
    patch.local_penetration = 0.0
    force = patch.force
    force.y = 0.0
    force.z = 0.0
    force.moment_x = 0.0
    force.moment_y = 0.0
    force.moment_z = 0.0
    force.x_track = 0.0
    force.y_track = 0.0
    force.z_track = 0.0
    force.rolling_radius = 0.0
    return 0


def add_part_force(tables: Tables, frame: Frame, block: Region, part: SolvedPart, patch: SolvedPatch,
                   mirror: float, resultant: Resultant):
    """Add the force of a part of a patch, which lies in the region ``block``, to the patch and to
    ``resultant``; the patch's centre of load [m] is weighted by the loads, until :func:`finish_force`."""
    load = part.load
    # from the region's smallest gap to the part's centre of load; a part that carries less than nothing
    # (patch/filling.py) has no such centre
    away = 0.0
    if load > 0.0:
        away = part.moment / load - block.offset - block.station
    # stations of a wheel that just touches are those of its contact plane, all others run along the rail
    abscissa = block.rail + away * frame.plane.cos
    if frame.pressed:
        abscissa = rail_abscissa(tables, block.rail, away)
    height, slope = height_slope(tables.rail, abscissa)
    normal_cos = 1.0 / sqrt(1.0 + slope * slope)
    normal_sin = slope * normal_cos
    if frame.pressed or tables.load == LOAD_VERTICAL:
        normal_cos = block.cos
        normal_sin = block.sin
    x = block.x_track + block.slant * away
    y, z = on_track(frame.place, tables.rail_y, tables.rail_y + abscissa, height)
    y = mirror * y
    if frame.place.leaning:
        down = normal_cos
        normal_cos = frame.place.rail_cos * down - frame.place.rail_sin * normal_sin
        normal_sin = frame.place.rail_cos * normal_sin + frame.place.rail_sin * down
    force_y = mirror * normal_sin * load
    force_z = -normal_cos * load
    resultant[1] += force_y
    resultant[2] += force_z
    moment_x = y * force_z - z * force_y
    moment_y = -x * force_z
    moment_z = x * force_y
    resultant[3] += moment_x
    resultant[4] += moment_y
    resultant[5] += moment_z
    wheel_height, wheel_slope = height_slope(tables.wheel, block.wheel)
    wheel_height, wheel_slope = height_slope(tables.wheel,
                                             block.wheel + away / sqrt(1.0 + wheel_slope * wheel_slope))
    force = patch.force
    force.y += force_y
    force.z += force_z
    force.moment_x += moment_x
    force.moment_y += moment_y
    force.moment_z += moment_z
    force.x_track += load * x
    force.y_track += load * y
    force.z_track += load * z
    force.rolling_radius += load * (tables.radius + wheel_height)
    return 0


def finish_force(patch: SolvedPatch, mirror: float):
    """The centre of load of a patch [m], and the angle of its force [rad]."""
    load = patch.totals.load
    if load > 0.0:
        force = patch.force
        force.x_track /= load
        force.y_track /= load
        force.z_track /= load
        force.rolling_radius /= load
        patch.contact_angle = -atan(mirror * force.y / -force.z)
    return 0


def write_resultant(tables: Tables, inputs: Inputs, outputs: Outputs, left: Resultant, right: Resultant):
    """The resultants of both sides and of the wheelset, from ``left`` and ``right``; moments about
    the wheelset's centre."""
    for i in range(3):
        outputs.force[i] = left[i] + right[i]
        outputs.moment[i] = left[3 + i] + right[3 + i]
        outputs.left[0].force[i] = left[i]
        outputs.left[0].moment[i] = left[3 + i]
        outputs.left[1].force[i] = right[i]
        outputs.left[1].moment[i] = right[3 + i]
    y = inputs.lateral_shift
    z = outputs.vertical_shift - tables.height
    outputs.moment[0] -= y * outputs.force[2] - z * outputs.force[1]
    for index in range(2):
        side = outputs.left[index]
        side.moment[0] -= y * side.force[2] - z * side.force[1]
        for i in range(3):
            side.normal_part[i] = side.force[i]
            side.normal_moment[i] = side.moment[i]
    for i in range(3):
        outputs.normal_part[i] = outputs.force[i]
        outputs.normal_moment[i] = outputs.moment[i]
    outputs.driving_torque = 0.0
    return 0
