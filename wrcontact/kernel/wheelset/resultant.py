"""The resultant of the contact forces on the wheelset, in the track's axes.

The rail pushes the wheel along the normal (0, -+ sin(angle), -cos(angle)), on the right and on the left,
where a region's load acts: the rail's normal there, or the mean over the region where that is known
(mean_normal.py).  The moment is that about the wheelset's centre, which is the nominal radius above the
running circles.

Forces are summed over regions and not over patches: a patch that reaches over the bound between two regions
has two normals and two points, one for each.  Load and moment of a region are those that its strips carry in
the solved patches.
"""

from math import sqrt

from ..layout import LOAD_VERTICAL, RESULTANT_COUNT, Inputs, Outputs, Resultant, Tables, Work
from ..surface.profile_table import height_slope


def clear_resultant(resultant: Resultant):
    """No force and no moment."""
    for i in range(RESULTANT_COUNT):
        resultant[i] = 0.0
    return 0


def add_region(tables: Tables, work: Work, region: int, mirror: float, resultant: Resultant):
    """Add the force of a region and its moment about the track's origin to ``resultant``; ``mirror`` = 1 on
    the right, -1 on the left."""
    block = work.contact.regions[region]
    load = block.carried
    if load > 0.0:
        # of the region's plane
        cosine = work.contact.frame.plane.cos
        if work.contact.frame.pressed or block.own:
            cosine = 1.0 / sqrt(1.0 + block.inclination * block.inclination)
        # from the region's smallest gap to its centre of load, along its plane
        away = block.moment / load - block.offset - block.station
        abscissa = block.rail + away * cosine
        height, slope = height_slope(tables.rail, abscissa)
        normal_cos = 1.0 / sqrt(1.0 + slope * slope)
        normal_sin = slope * normal_cos
        if work.contact.frame.pressed or tables.load == LOAD_VERTICAL:
            normal_cos = block.cos
            normal_sin = block.sin
        x = block.x_track + block.slant * away
        y = mirror * (tables.rail_y + abscissa)
        z = height
        force_y = mirror * normal_sin * load
        force_z = -normal_cos * load
        resultant[1] += force_y
        resultant[2] += force_z
        resultant[3] += y * force_z - z * force_y
        resultant[4] -= x * force_z
        resultant[5] += x * force_y
    return 0


def write_resultant(tables: Tables, inputs: Inputs, outputs: Outputs, left: Resultant, right: Resultant):
    """The resultant of both sides, from ``left`` and ``right``, its moment about the wheelset's centre."""
    for i in range(3):
        outputs.force[i] = left[i] + right[i]
        outputs.moment[i] = left[3 + i] + right[3 + i]
    y = inputs.lateral_shift
    z = outputs.vertical_shift - tables.radius
    outputs.moment[0] -= y * outputs.force[2] - z * outputs.force[1]
    return 0
