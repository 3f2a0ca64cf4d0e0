"""Shear and slip over the outline of a wheel, for models of wear.

Of a strip with the creep force F_i and the power P_i per width and the half-length a_i

    shear = |F_i| / (2 a_i),   slip = P_i / |F_i|,   P_i = -V_ref (w_x F_x + eta F_y + phi M_z)

so that shear times slip is the friction power per area, as the strip has it from its leading to its trailing
edge.  Elastic deformation takes and gives back power within a strip and is no part of P_i.  Between the
middles of strips both follow straight lines; a strip that would gain power counts as one that sticks.
"""

from math import sqrt

from ..layout import ROLLING_STRIP_LIMIT, Outline, Patch, RollingStrip, SideSearch


def write_wear(side: SideSearch, stations: int):
    """Shear [Pa] and slip [m/s] of the patches of a wheel at the ``stations`` of its outline; zero between
    patches."""
    for i in range(3 * stations, 5 * stations):
        side.outline.numbers[i] = 0.0
    for number in range(side.patch_count):
        write_patch_wear(side.outline, stations, side.patches[number])


def write_patch_wear(outline: Outline, stations: int, patch: Patch):
    """Shear and slip of a patch at the stations that lie in it, which ascend, along with the strips."""
    first = patch.strips[0]
    last = patch.strips[ROLLING_STRIP_LIMIT - 1]
    start = first.station - 0.5 * first.width
    stop = last.station + 0.5 * last.width
    index = 0
    low_station = first.station
    high_station = first.station
    low_shear = 0.0
    low_slip = 0.0
    high_shear = strip_shear(first)
    high_slip = strip_slip(patch, first)
    for j in range(1, stations - 1):
        station = outline.numbers[j]
        if station > start and station < stop:
            while index < ROLLING_STRIP_LIMIT - 1 and high_station < station:
                index += 1
                strip = patch.strips[index]
                low_station = high_station
                low_shear = high_shear
                low_slip = high_slip
                high_station = strip.station
                high_shear = strip_shear(strip)
                high_slip = strip_slip(patch, strip)
            shear = high_shear
            slip = high_slip
            if index > 0 and station < high_station:
                share = (high_station - station) / (high_station - low_station)
                shear += share * (low_shear - shear)
                slip += share * (low_slip - slip)
            outline.numbers[3 * stations + j] = shear
            outline.numbers[4 * stations + j] = slip


def strip_shear(strip: RollingStrip):
    """Creep force per area of a strip [Pa]."""
    shear = 0.0
    if strip.half_length > 0.0:
        force = sqrt(strip.force_x * strip.force_x + strip.force_y * strip.force_y)
        shear = force / (2.0 * strip.half_length)
    return shear


def strip_slip(patch: Patch, strip: RollingStrip):
    """Friction power of a strip over its creep force [m/s]."""
    force = sqrt(strip.force_x * strip.force_x + strip.force_y * strip.force_y)
    slip = 0.0
    if force > 0.0:
        power = -(strip.slip * strip.force_x + patch.creepage_y * strip.force_y + patch.spin * strip.moment)
        if power > 0.0:
            slip = patch.speed * power / force
    return slip
