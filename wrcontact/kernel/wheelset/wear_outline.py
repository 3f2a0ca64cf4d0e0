"""Shear and slip over the outline of a wheel, for models of wear.

Of a strip with the creep force F_i and the power P_i per width and the half-length a_i

    shear = |F_i| / (2 a_i),   slip = P_i / |F_i|,   P_i = -V_ref (w_x F_x + eta F_y + phi M_z)

so that shear times slip is the friction power per area, as the strip has it from its leading to its trailing
edge.  Elastic deformation takes and gives back power within a strip and is no part of P_i.  Between the
middles of strips both follow straight lines; a strip that would gain power counts as one that sticks.
"""

from math import sqrt

from ..layout import Outline, RollingPatch, RollingSide, RollingStrip


def write_wear(outline: Outline, stations: int, rolling: RollingSide):
    """Shear [Pa] and slip [m/s] of the patches of a wheel at the ``stations`` of its outline; zero between
    patches."""
    for j in range(1, stations - 1):
        station = outline.numbers[j]
        for number in range(rolling.count):
            patch = rolling.patches[number]
            if reaches(patch, station) == 1:
                shear, slip = wear_at(patch, station)
                outline.numbers[3 * stations + j] = shear
                outline.numbers[4 * stations + j] = slip
    return 0


def reaches(patch: RollingPatch, station: float):
    """1 if ``station`` [m] lies in the patch, else 0."""
    first = patch.strips[0]
    last = patch.strips[patch.count - 1]
    within = 0
    if station > first.station - 0.5 * first.width and station < last.station + 0.5 * last.width:
        within = 1
    return within


def wear_at(patch: RollingPatch, station: float):
    """Shear [Pa] and slip [m/s] at a station."""
    index = 0
    while index < patch.count - 1 and patch.strips[index].station < station:
        index += 1
    high = patch.strips[index]
    shear = strip_shear(high)
    slip = strip_slip(patch, high)
    if index > 0 and station < high.station:
        low = patch.strips[index - 1]
        share = (high.station - station) / (high.station - low.station)
        shear += share * (strip_shear(low) - shear)
        slip += share * (strip_slip(patch, low) - slip)
    return shear, slip


def strip_shear(strip: RollingStrip):
    """Creep force per area of a strip [Pa]."""
    shear = 0.0
    if strip.half_length > 0.0:
        force = sqrt(strip.force_x * strip.force_x + strip.force_y * strip.force_y)
        shear = force / (2.0 * strip.half_length)
    return shear


def strip_slip(patch: RollingPatch, strip: RollingStrip):
    """Friction power of a strip over its creep force [m/s]."""
    force = sqrt(strip.force_x * strip.force_x + strip.force_y * strip.force_y)
    slip = 0.0
    if force > 0.0:
        power = -(strip.slip * strip.force_x + patch.creepage_y * strip.force_y + patch.spin * strip.moment)
        if power > 0.0:
            slip = patch.speed * power / force
    return slip
