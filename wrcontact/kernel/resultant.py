"""The resultant of the contact forces on the wheelset, in the track's axes.

The rail pushes the wheel along each region's normal, (0, -+ sin(angle), -cos(angle)) on the right and on the left, where the
region's load acts; the moment is that about the wheelset's centre, which stands the nominal radius above the running circles.
"""

from .contact_plane import ridge_place
from .layout import (IN_LATERAL_SHIFT, OUT_FORCE, OUT_MOMENT, OUT_VERTICAL_SHIFT, SET_RADIUS, SET_RAIL, SET_RAIL_Y,
                     WORK_INPUTS, WORK_OUTPUTS)
from .profile_table import height_slope
from .regions import (REGION_CARRIED, REGION_COS, REGION_MOMENT, REGION_OFFSET, REGION_RAIL, REGION_SIN, REGION_SLANT,
                      REGION_STATION, REGION_WHEEL, region_block)


def clear_resultant(work: 'float[:]'):
    """No force and no moment."""
    for i in range(3):
        work[WORK_OUTPUTS + OUT_FORCE + i] = 0.0
        work[WORK_OUTPUTS + OUT_MOMENT + i] = 0.0
    return 0


def add_region(tables: 'float[:]', work: 'float[:]', region: int, mirror: float):
    """Add the force of a region, ``mirror`` = 1 on the right, -1 on the left."""
    block = region_block(region)
    load = work[block + REGION_CARRIED]
    if load > 0.0:
        cosine = work[block + REGION_COS]
        sine = work[block + REGION_SIN]
        # from the region's smallest gap to its centre of load, along its plane
        away = work[block + REGION_MOMENT] / load - work[block + REGION_OFFSET] - work[block + REGION_STATION]
        height, slope = height_slope(tables, int(tables[SET_RAIL]), work[block + REGION_RAIL])
        x = ridge_place(tables, work, work[block + REGION_WHEEL]) + work[block + REGION_SLANT] * away
        y = mirror * (tables[SET_RAIL_Y] + work[block + REGION_RAIL] + away * cosine)
        z = height + away * sine
        arm_y = y - work[WORK_INPUTS + IN_LATERAL_SHIFT]
        arm_z = z - work[WORK_OUTPUTS + OUT_VERTICAL_SHIFT] + tables[SET_RADIUS]
        force_y = mirror * sine * load
        force_z = -cosine * load
        work[WORK_OUTPUTS + OUT_FORCE + 1] += force_y
        work[WORK_OUTPUTS + OUT_FORCE + 2] += force_z
        work[WORK_OUTPUTS + OUT_MOMENT] += arm_y * force_z - arm_z * force_y
        work[WORK_OUTPUTS + OUT_MOMENT + 1] -= x * force_z
        work[WORK_OUTPUTS + OUT_MOMENT + 2] += x * force_y
    return 0
