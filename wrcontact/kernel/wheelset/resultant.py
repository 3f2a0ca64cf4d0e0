"""The resultant of the contact forces on the wheelset, in the track's axes.

The rail pushes the wheel along the normal (0, -+ sin(angle), -cos(angle)), on the right and on the left, where a region's load
acts: the rail's normal there, or the mean over the region where that is known (normal_contact.mean_normal).  The moment is
that about the wheelset's centre, which stands the nominal radius above the running circles.
"""

from math import sqrt
from typing import Final

from ..contact.contact_plane import FRAME_COS, FRAME_PRESSED, ridge_place
from ..layout import (IN_LATERAL_SHIFT, LOAD_VERTICAL, OUT_FORCE, OUT_MOMENT, OUT_VERTICAL_SHIFT, SET_LOAD, SET_RADIUS,
                     SET_RAIL, SET_RAIL_Y, WORK_INPUTS, WORK_OUTPUTS)
from ..surface.profile_table import height_slope
from ..contact.regions import (REGION_CARRIED, REGION_COS, REGION_LEAN, REGION_MOMENT, REGION_OFFSET, REGION_OWN, REGION_RAIL,
                      REGION_SIN, REGION_SLANT, REGION_STATION, REGION_WHEEL, region_block)

RESULTANT_SIZE: Final[int] = 6       # force x, y, z [N], moment x, y, z [N m]


def clear_resultant(work: 'float[:]', at: int):
    """No force and no moment at ``at``."""
    for i in range(RESULTANT_SIZE):
        work[at + i] = 0.0
    return 0


def add_region(tables: 'float[:]', work: 'float[:]', region: int, mirror: float, at: int):
    """Add the force of a region and its moment about the track's origin at ``at``; ``mirror`` = 1 on the right, -1 on the
    left."""
    block = region_block(region)
    load = work[block + REGION_CARRIED]
    if load > 0.0:
        # of the region's plane
        cosine = work[FRAME_COS]
        if work[FRAME_PRESSED] == 1.0 or work[block + REGION_OWN] == 1.0:
            cosine = 1.0 / sqrt(1.0 + work[block + REGION_LEAN] * work[block + REGION_LEAN])
        # from the region's smallest gap to its centre of load, along its plane
        away = work[block + REGION_MOMENT] / load - work[block + REGION_OFFSET] - work[block + REGION_STATION]
        abscissa = work[block + REGION_RAIL] + away * cosine
        height, slope = height_slope(tables, int(tables[SET_RAIL]), abscissa)
        normal_cos = 1.0 / sqrt(1.0 + slope * slope)
        normal_sin = slope * normal_cos
        if work[FRAME_PRESSED] == 1.0 or int(tables[SET_LOAD]) == LOAD_VERTICAL:
            normal_cos = work[block + REGION_COS]
            normal_sin = work[block + REGION_SIN]
        x = ridge_place(tables, work, work[block + REGION_WHEEL]) + work[block + REGION_SLANT] * away
        y = mirror * (tables[SET_RAIL_Y] + abscissa)
        z = height
        force_y = mirror * normal_sin * load
        force_z = -normal_cos * load
        work[at + 1] += force_y
        work[at + 2] += force_z
        work[at + 3] += y * force_z - z * force_y
        work[at + 4] -= x * force_z
        work[at + 5] += x * force_y
    return 0


def write_resultant(tables: 'float[:]', work: 'float[:]', left: int, right: int):
    """The resultant of both sides, from ``left`` and ``right``, its moment about the wheelset's centre."""
    for i in range(3):
        work[WORK_OUTPUTS + OUT_FORCE + i] = work[left + i] + work[right + i]
        work[WORK_OUTPUTS + OUT_MOMENT + i] = work[left + 3 + i] + work[right + 3 + i]
    y = work[WORK_INPUTS + IN_LATERAL_SHIFT]
    z = work[WORK_OUTPUTS + OUT_VERTICAL_SHIFT] - tables[SET_RADIUS]
    work[WORK_OUTPUTS + OUT_MOMENT] -= y * work[WORK_OUTPUTS + OUT_FORCE + 2] - z * work[WORK_OUTPUTS + OUT_FORCE + 1]
    return 0
