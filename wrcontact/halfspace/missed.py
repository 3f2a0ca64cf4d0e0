"""Patches that a solution has missed: places away from its loaded cells where the bodies overlap.  (H9)"""

import math

import numpy as np
from scipy import ndimage

from .boxes import around, centres, clipped, touched_sides
from .refinement import COARSE_CELLS, WINDOW_REPEATS

LOOK_LUMPS = 16          # per side, of the pressures as the look sees them
PLACE_SAMPLES = 9        # per side, around a place
PLACE_ZOOMS = 4
MISSED_SHARE = 1e-3      # of the penetration: less overlap than this is nothing missed


def missed(problem, ridge, found):
    """Boxes (x_low, x_high, s_low, s_high) [m] where the bodies of a solution overlap
    away from its loaded cells.

    At each minimum along the ``ridge`` of the gap with the deflection under the found
    pressures that may lie below the penetration, the gap is sampled ever more closely; where
    it does lie below, the overlap is boxed. (H9)
    """
    s, low = ridge.s, ridge.low - found.penetration * problem.surfaces.share(ridge.s)
    near = np.flatnonzero(low - ridge.spare < 0.0)
    total = np.full(len(s) + 2, math.inf)
    total[near + 1] = low[near] + far_deflection(problem, found, ridge.x[near], s[near])
    lowest = (total[1:-1] <= total[:-2]) & (total[1:-1] < total[2:])
    places = [k for k in np.flatnonzero(lowest) if total[k + 1] < ridge.spare[k]
              and not is_loaded(found, ridge.x[k], s[k])]
    step = s[1] - s[0]
    boxes = []
    for k in places:
        box = clipped((ridge.x[k] - ridge.step, ridge.x[k] + ridge.step, s[k] - 1.5 * step,
                       s[k] + 1.5 * step), problem.domain)
        place, gap = _lowest_place(problem.surfaces.gap, box)
        x, station = (np.array([value]) for value in place)
        level = (found.penetration * problem.surfaces.share(station)
                 - far_deflection(problem, found, x, station))[0]
        if gap < level - MISSED_SHARE * found.penetration and not is_loaded(found, *place):
            boxes.append(_overlap(problem, place, level, step))
    return boxes


def far_deflection(problem, found, x, s):
    """Deflection [m] at places x (k,), s (k,) under a solution's pressures, in lumps: sum of
    N cos(a_i - a_j) / (pi E* r), and of the coupled part. (H9)"""
    rows, columns = np.nonzero(found.pressure)
    forces = found.pressure[rows, columns]
    width, depth = (max(1, math.ceil((k.max() - k.min() + 1) / LOOK_LUMPS)) for k in (rows, columns))
    _, lump = np.unique(rows // width * found.pressure.shape[1] + columns // depth, return_inverse=True)
    weight = np.bincount(lump, forces)
    x_lump, s_lump, angle = (np.bincount(lump, forces * k) / weight
                             for k in (found.x[rows], found.s[columns], found.angle[columns]))
    dx, ds = found.x[1] - found.x[0], found.s[1] - found.s[0]
    # inside a lump of radius c the mean of 1 / r is 2 / c
    least = 0.5 * math.sqrt(width * depth * dx * ds / math.pi)
    away = s[:, None] - s_lump
    distance = np.maximum(np.hypot(x[:, None] - x_lump, away), least)
    turn = problem.surfaces.angle(s)[:, None] - angle
    response = np.cos(turn) + problem.coupling * np.sin(turn) * away / distance
    return dx * ds / (math.pi * problem.contact_modulus) * (weight * response / distance).sum(axis=1)


def is_loaded(found, x, s):
    """Whether a cell is loaded at or next to (x, s)."""
    i, j = int(np.argmin(np.abs(found.x - x))), int(np.argmin(np.abs(found.s - s)))
    if (abs(found.x[i] - x) > 1.5 * (found.x[1] - found.x[0])
        or abs(found.s[j] - s) > 1.5 * (found.s[1] - found.s[0])):
        return False
    return bool(found.pressure[max(i - 1, 0):i + 2, max(j - 1, 0):j + 2].any())


def _lowest_place(gap_function, box):
    """The place (x, s) of the least gap in a box, and that gap."""
    for _ in range(PLACE_ZOOMS):
        x, s = centres(box, (PLACE_SAMPLES, PLACE_SAMPLES))
        gap = gap_function(x, s)
        i, j = np.unravel_index(np.argmin(gap), gap.shape)
        dx, ds = x[1] - x[0], s[1] - s[0]
        box = x[i] - 1.5 * dx, x[i] + 1.5 * dx, s[j] - 1.5 * ds, s[j] + 1.5 * ds
    return (x[i], s[j]), float(gap[i, j])


def _overlap(problem, place, level, size):
    """Box around ``place`` in which the gap lies below ``level``, from one of the ``size`` [m] on."""
    half = [size, size]
    for _ in range(WINDOW_REPEATS):
        box = clipped((place[0] - half[0], place[0] + half[0], place[1] - half[1], place[1] + half[1]),
                      problem.domain)
        x, s = centres(box, (COARSE_CELLS, COARSE_CELLS))
        below, _ = ndimage.label(problem.surfaces.gap(x, s) < level, np.ones((3, 3)))
        here = below == below[np.argmin(np.abs(x - place[0])), np.argmin(np.abs(s - place[1]))]
        if not here.any() or not below[here].all():
            return box
        touched = touched_sides(here)
        if not any(touched):
            return around(here, x, s, x[1] - x[0], s[1] - s[0], 0.5)
        half = [size * (2 if any(touched[2 * k:2 * k + 2]) else 1) for k, size in enumerate(half)]
    return box
