"""Frictionless contact of two elastic half-spaces: the complete theory, for any gap
between the undeformed bodies.

>>> import numpy as np
>>> from wrcontact.halfspace import contact
>>> ball = lambda x, s: (x[:, None] ** 2 + s**2) / (2 * 0.3)                       # radius 0.3 m on a flat
>>> found = contact.solve_contact(ball, (-0.1, 0.1, -0.1, 0.1), contact_modulus=1.14e11, force=1e4)
>>> f"{found.penetration:.2e} m, {found.max_pressure:.2e} Pa"
'2.43e-05 m, 6.54e+08 Pa'

The bodies touch where the pressure p is positive; the equations (H1) ... are those of docs/theory:

    u + h - delta = 0 where p > 0, u + h - delta >= 0 where p = 0, sum of p dx ds = N (H1)

Pressure is constant on each cell of a grid. Its deflection u is a convolution (Love 1929; Johnson 1985,
section 3.3), done by fast Fourier transform; the pressures follow by conjugate gradients that keep p >= 0
(Polonsky and Keer 1999, Wear 231, 206-219). :func:`solve_contact` takes the gap over a plane as a function,
finds the patch and refines the grid until the answer stands. :func:`solve_problem` does this for any
surfaces; those of a wheel and its rail have normals that turn (turning_gap.py), and pressures act on each
other with the cosine of the angle between them.

Lengths in m, pressures in Pa, forces in N; x along the first axis of every array, s along the second.
"""

import math

import numpy as np
from scipy import ndimage

from .blocks import refine_blocks
from .boxes import are_apart, around, centres, clipped, loaded_boxes, merged, touched_sides
from .flat_gap import FlatGap
from .one_grid import check_load, check_number, checked_domain
from .problem import Problem
from .refinement import COARSE_CELLS, WINDOW_REPEATS, refine, solve_window

LOOK_LUMPS = 16  # per side, of the pressures as the look sees them
PLACE_SAMPLES = 9  # per side, around a place
PLACE_ZOOMS = 4
MISSED_SHARE = 1e-3  # of the penetration: less overlap than this is nothing missed
#: Error in penetration (or force), area and peak pressure at which a grid is fine enough.
TOLERANCE = 5e-3
TOLERANCE_RANGE = (3e-4, 0.1)  # the edge is known to EDGE_DOUBT: less would take more than CELL_LIMIT
#: The residual is reduced to this share of the tolerance, so that it does not count in the grid's error.
RESIDUAL_SHARE = 1e-3
LOOK_REPEATS = 7


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
    places = [
        k
        for k in np.flatnonzero(lowest)
        if total[k + 1] < ridge.spare[k] and not is_loaded(found, ridge.x[k], s[k])
    ]
    step = s[1] - s[0]
    boxes = []
    for k in places:
        box = clipped(
            (ridge.x[k] - ridge.step, ridge.x[k] + ridge.step, s[k] - 1.5 * step, s[k] + 1.5 * step),
            problem.domain,
        )
        place, gap = _lowest_place(problem.surfaces.gap, box)
        x, station = (np.array([value]) for value in place)
        level = (
            found.penetration * problem.surfaces.share(station) - far_deflection(problem, found, x, station)
        )[0]
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
    x_lump, s_lump, angle = (
        np.bincount(lump, forces * k) / weight
        for k in (found.x[rows], found.s[columns], found.angle[columns])
    )
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
    if abs(found.x[i] - x) > 1.5 * (found.x[1] - found.x[0]) or abs(found.s[j] - s) > 1.5 * (
        found.s[1] - found.s[0]
    ):
        return False
    return bool(found.pressure[max(i - 1, 0) : i + 2, max(j - 1, 0) : j + 2].any())


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
        box = clipped(
            (place[0] - half[0], place[0] + half[0], place[1] - half[1], place[1] + half[1]), problem.domain
        )
        x, s = centres(box, (COARSE_CELLS, COARSE_CELLS))
        below, _ = ndimage.label(problem.surfaces.gap(x, s) < level, np.ones((3, 3)))
        here = below == below[np.argmin(np.abs(x - place[0])), np.argmin(np.abs(s - place[1]))]
        if not here.any() or not below[here].all():
            return box
        touched = touched_sides(here)
        if not any(touched):
            return around(here, x, s, x[1] - x[0], s[1] - s[0], 0.5)
        half = [size * (2 if any(touched[2 * k : 2 * k + 2]) else 1) for k, size in enumerate(half)]
    return box


def solve_contact(
    gap_function, domain, *, contact_modulus, force=None, penetration=None, tolerance=TOLERANCE
):
    """The contact for any gap: finds the patches, fits a grid to them, and refines it
    until the answer stands.

    A solution stands only if the bodies overlap nowhere else in the domain (:func:`missed`).  Each group of
    patches has its own grid where they are far apart, or where patches have been missed at first.

    Parameters
    ----------
    gap_function : called with cell centres x (n,), s (m,) [m]; returns the undeformed distance (n, m) [m],
        infinite where there is no surface.
    domain : (x_low, x_high, s_low, s_high) [m], within which all patches lie; the look for further ones takes
        LOOK samples of it, and along x one minimum for each s.
    contact_modulus : E* [Pa].
    force, penetration : [N], [m]; exactly one of the two.
    tolerance : permitted relative error in penetration (or force), area and peak pressure, 3e-4 ... 0.1.

    Returns
    -------
    HalfspaceContact
        with ``error`` by :func:`estimate_error`.

    Raises
    ------
    ValueError
        in one sentence with name, value, unit and what is permitted.
    ArithmeticError
        if the grid would need more than CELL_LIMIT cells, or the patch reaches the end of the domain.
    """
    check_load(force, penetration)
    check_number("contact_modulus", contact_modulus, "Pa", above=True)
    domain = checked_domain(domain)
    if not TOLERANCE_RANGE[0] <= tolerance <= TOLERANCE_RANGE[1]:
        raise ValueError(
            f"tolerance is {tolerance!r}; permitted is {TOLERANCE_RANGE[0]:g} ... {TOLERANCE_RANGE[1]:g}"
        )
    return solve_problem(
        Problem(
            FlatGap(gap_function), domain, contact_modulus, force, penetration, RESIDUAL_SHARE * tolerance
        ),
        tolerance,
    )


def solve_problem(problem, tolerance=TOLERANCE):
    """The contact of a :class:`~wrcontact.halfspace.problem.Problem`, over a plane or where the patches turn;
    as :func:`solve_contact`."""
    found = solve_window(problem, problem.surfaces.window(problem))
    if not found.pressure.any():
        return found
    ridge = problem.surfaces.ridge(problem.domain)
    for _ in range(LOOK_REPEATS):
        boxes = missed(problem, ridge, found)
        if found.error and not boxes:
            return found
        # what a patch that has been missed will carry is not known, but little
        patches = loaded_boxes(found) + [(box, 0.0) for box in boxes]
        found = (
            refine_blocks(problem, patches, tolerance)
            if boxes or are_apart(merged([box for box, _ in patches]))
            else refine(problem, found, tolerance)
        )
    raise ArithmeticError(
        f"{len(boxes)} places are still missed after {LOOK_REPEATS} looks; all of them must be found"
    )
