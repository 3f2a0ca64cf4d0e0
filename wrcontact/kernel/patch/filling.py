"""How a model of normal contact fills the solved patches: one after the other by rising station, then their ranks."""

from math import sqrt

from ..layout import SOLVED_PATCH_LIMIT, Region, SolvedPatches


def clear_patches(solved: SolvedPatches):
    """No patches."""
    solved.count = 0
    return 0


def begin_patch(solved: SolvedPatches, region: Region, start: float, first: int, rule: int, contact_angle: float):
    """Begin the next patch at station ``start`` [m] and strip ``first``, with the plane and the point of ``region``; its index.

    Where there is no room for another patch, the last one goes on.
    """
    index = solved.count
    if index == SOLVED_PATCH_LIMIT:
        return index - 1
    solved.count = index + 1
    solved.pressure_square = 0.0
    solved.half_length_square = 0.0
    patch = solved.patches[index]
    patch.load = 0.0
    patch.area = 0.0
    patch.moment = 0.0
    patch.max_pressure = 0.0
    patch.max_half_length = 0.0
    patch.start = start
    patch.stop = start
    patch.contact_angle = contact_angle
    patch.cos = region.cos
    patch.sin = region.sin
    patch.rail = region.rail
    patch.wheel = region.wheel
    patch.station = region.offset + region.station
    patch.x = region.along
    patch.slant = region.slant
    patch.local_penetration = region.level
    patch.rule = rule
    patch.first = first
    patch.last = first - 1
    patch.rank = 0
    return index


def finish_patch(solved: SolvedPatches):
    """Give the last patch, if there is one, its largest pressure and half-length."""
    if solved.count > 0:
        patch = solved.patches[solved.count - 1]
        patch.max_pressure = sqrt(solved.pressure_square)
        patch.max_half_length = sqrt(solved.half_length_square)
    return 0


def rank_patches(solved: SolvedPatches):
    """Rank the patches that carry load, the heaviest first; of equal ones the one with the smaller station."""
    count = solved.count
    for rank in range(1, count + 1):
        heaviest = -1
        load = 0.0
        for index in range(count):
            patch = solved.patches[index]
            if patch.rank == 0 and patch.load > load:
                heaviest = index
                load = patch.load
        if heaviest >= 0:
            ranked = solved.patches[heaviest]
            ranked.rank = rank
    return 0
