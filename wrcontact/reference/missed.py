"""Patches that a solution has missed: places away from its loaded cells where the bodies overlap.  (H9)"""

import math

import numpy as np
from scipy import ndimage

from .boxes import around, centres, clipped, touched_sides
from .refinement import COARSE_CELLS, WINDOW_REPEATS
from .window import dip

# samples along and across the domain of the look for places that a solution has missed
LOOK = 25, 800
LOOK_SLACK = 0.25        # what a parabola along x finds below its samples is known to this share
LOOK_LUMPS = 16          # per side, of the pressures as the look sees them
PLACE_SAMPLES = 9        # per side, around a place
PLACE_ZOOMS = 4
MISSED_SHARE = 1e-3      # of the penetration: less overlap than this is nothing missed


def ridge(gap_function, domain):
    """Stations s (m,), and for each the place x (m,) of the least gap, that gap (m,) and what
    it may be lower (m,) [m].

    Along x a wheel's gap is smooth and has one minimum: the parabola through the three lowest of few samples
    finds it. Across, samples are dense.
    """
    x, s = centres(domain, LOOK)
    gap = np.asarray(gap_function(x, s), dtype=float)
    columns = np.arange(len(s))
    k = np.clip(gap.argmin(axis=0), 1, len(x) - 2)
    before, here, after = (gap[k + step, columns] for step in (-1, 0, 1))
    with np.errstate(invalid="ignore", divide="ignore"):
        bend = before - 2.0 * here + after
        turn = np.clip(np.where(bend > 0.0, 0.5 * (before - after) / bend, 0.0), -1.0, 1.0)
        fall = np.where(bend > 0.0, 0.5 * bend * turn**2, 0.0)
    turn, fall = np.nan_to_num(turn), np.nan_to_num(fall, posinf=0.0)
    low = np.minimum(here - fall, gap.min(axis=0))
    return s, x[k] + turn * (x[1] - x[0]), low, LOOK_SLACK * fall + dip(low[None])[0]


def missed(gap_function, domain, look, found, contact_modulus):
    """Boxes (x_low, x_high, s_low, s_high) [m] where the bodies of a solution overlap
    away from its loaded cells.

    At each minimum along the ``look`` of the gap with the deflection under the found
    pressures that may lie below the penetration, the gap is sampled ever more closely; where
    it does lie below, the overlap is boxed. (H9)
    """
    s, x, low, spare = look
    near = np.flatnonzero(low - spare < found.penetration)
    total = np.full(len(s) + 2, math.inf)
    total[near + 1] = low[near] + far_deflection(found, x[near], s[near], contact_modulus)
    lowest = (total[1:-1] <= total[:-2]) & (total[1:-1] < total[2:])
    places = [k for k in np.flatnonzero(lowest) if total[k + 1] - spare[k] < found.penetration
              and not is_loaded(found, x[k], s[k])]
    step_x, step_s = (domain[1] - domain[0]) / LOOK[0], s[1] - s[0]
    boxes = []
    for k in places:
        box = clipped((x[k] - step_x, x[k] + step_x, s[k] - 1.5 * step_s, s[k] + 1.5 * step_s), domain)
        place, gap = _lowest_place(gap_function, box)
        level = found.penetration - far_deflection(found, *(np.array([value]) for value in place),
                                                   contact_modulus)[0]
        if gap < level - MISSED_SHARE * found.penetration and not is_loaded(found, *place):
            boxes.append(_overlap(gap_function, domain, place, level, step_s))
    return boxes


def far_deflection(found, x, s, contact_modulus):
    """Deflection [m] at places x (k,), s (k,) under a solution's pressures, in lumps:
    sum of N / (pi E* r). (H9)"""
    rows, columns = np.nonzero(found.pressure)
    forces = found.pressure[rows, columns]
    width, depth = (max(1, math.ceil((k.max() - k.min() + 1) / LOOK_LUMPS)) for k in (rows, columns))
    _, lump = np.unique(np.stack([rows // width, columns // depth]), axis=1, return_inverse=True)
    lump = lump.ravel()
    weight = np.bincount(lump, forces)
    x_lump, s_lump = (np.bincount(lump, forces * k) / weight for k in (found.x[rows], found.s[columns]))
    dx, ds = found.x[1] - found.x[0], found.s[1] - found.s[0]
    # inside a lump of radius c the mean of 1 / r is 2 / c
    least = 0.5 * math.sqrt(width * depth * dx * ds / math.pi)
    distance = np.hypot(x[:, None] - x_lump, s[:, None] - s_lump)
    return dx * ds / (math.pi * contact_modulus) * (weight / np.maximum(distance, least)).sum(axis=1)


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


def _overlap(gap_function, domain, place, level, size):
    """Box around ``place`` in which the gap lies below ``level``, from one of the ``size`` [m] on."""
    half = [size, size]
    for _ in range(WINDOW_REPEATS):
        box = clipped((place[0] - half[0], place[0] + half[0], place[1] - half[1], place[1] + half[1]),
                      domain)
        x, s = centres(box, (COARSE_CELLS, COARSE_CELLS))
        below, _ = ndimage.label(gap_function(x, s) < level, np.ones((3, 3)))
        here = below == below[np.argmin(np.abs(x - place[0])), np.argmin(np.abs(s - place[1]))]
        if not here.any() or not below[here].all():
            return box
        touched = touched_sides(here)
        if not any(touched):
            return around(here, x, s, x[1] - x[0], s[1] - s[0], 0.5)
        half = [size * (2 if any(touched[2 * k:2 * k + 2]) else 1) for k, size in enumerate(half)]
    return box
