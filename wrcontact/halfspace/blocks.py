"""Patches far from each other, each group on its own grid; all grids have equal cells
and press on each other."""

import math

import numpy as np
from scipy import ndimage

from .boxes import around, enlarged, hull, merged, touched_sides
from .edge import EDGE_PAD, loaded_area, peak_pressure
from .gradients import constrained_gradients, estimate_penetration
from .problem import HalfspaceContact
from .refinement import CELL_LIMIT, area_doubt, changes, estimate_error
from .window import MINOR_PATCH, PATCH_CELLS

MINOR_CELLS = 5  # over a patch that carries less than MINOR_PATCH, on the first grid


def refine_blocks(problem, patches, tolerance):
    """As :func:`refine`, each group of patches on its own grid, all with equal cells.  ``patches`` are
    boxes with their shares of the load."""
    hulls = [hull(group) for group in merged([box for box, _ in patches])]
    cell = [
        max(
            min(
                (box[k + 1] - box[k]) / (PATCH_CELLS if share >= MINOR_PATCH else MINOR_CELLS)
                for box, share in patches
            ),
            max(each[k + 1] - each[k] for each in hulls) / (8 * PATCH_CELLS),
        )
        for k in (0, 2)
    ]
    previous, before, iterations = None, None, 0
    error = {}
    while True:
        if len(hulls) * np.prod(_blocks(hulls, cell)[0]) > CELL_LIMIT:
            raise ArithmeticError(
                f"tolerance is {tolerance:g}, but the error is still "
                f"{max(error.values(), default=1):.2g}; permitted are {CELL_LIMIT} cells"
            )
        found = _solve_blocks(problem, hulls, cell, previous)
        iterations += found.iterations
        wider = _outgrown(found, hulls, cell, problem.domain)
        if wider != hulls:
            # grids that grew into each other become one
            hulls = [hull(group) for group in merged(wider)]
            continue
        if previous is None:
            hulls = [hull(group) for group in merged(_fitted(found, hulls, cell))]
        else:
            change = changes(previous, found, problem.wanted)
            error = {
                name: estimate_error(before[name], now) if before else now for name, now in change.items()
            }
            error["area"] = max(error["area"], area_doubt(found))
            # a first change counts as one of first order
            if max(error.values()) <= tolerance:
                return HalfspaceContact(**{**vars(found), "iterations": iterations, "error": error})
            before = change
        problem = problem.near(found.penetration)
        previous, cell = found, [0.5 * size for size in cell]


def _blocks(hulls, cell):
    """Number of cells (n, m) of every grid, and the grids' first cells (b, 2): the
    hulls with free cells around."""
    first = [[math.floor(each[k] / cell[k // 2] + 1e-9) - EDGE_PAD for k in (0, 2)] for each in hulls]
    shape = [
        max(
            math.ceil(each[2 * k + 1] / cell[k] - 1e-9) + EDGE_PAD - start[k]
            for each, start in zip(hulls, first)
        )
        for k in (0, 1)
    ]
    return shape, np.array(first)


def _solve_blocks(problem, hulls, cell, guess):
    """The contact on one grid a hull, on the rows and columns of all of them."""
    shape, first = _blocks(hulls, cell)
    centres = [tuple((start[k] + 0.5 + np.arange(shape[k])) * cell[k] for k in (0, 1)) for start in first]
    surfaces = problem.surfaces
    gap = np.stack([surfaces.gap(x, s) for x, s in centres])
    angle, share = (np.stack([of(s) for _, s in centres]) for of in (surfaces.angle, surfaces.share))
    share = share[:, None, :]
    deflect = problem.deflection(gap.shape, *cell, angle, first)
    area = cell[0] * cell[1]
    if guess is None:
        level = (
            problem.penetration
            if problem.force is None
            else estimate_penetration((gap / share).ravel(), area, problem.contact_modulus, problem.force)
        )
        start = np.sqrt(np.maximum(level * share - gap, 0.0))
    else:
        start = np.stack([_sampled(guess, x, s) for x, s in centres])
    # two grids may share cells: the first one has them
    free = _owned(first, shape)
    gap = np.where(free, gap, math.inf)
    start = np.where(np.isfinite(gap), start, 0.0)
    pressure, clearance, delta, iterations = constrained_gradients(
        start, gap, deflect, problem, cell=area, share=share, weight=problem.weight(angle)[:, None, :]
    )
    rows, columns = (
        np.unique(np.concatenate([start[k] + np.arange(shape[k]) for start in first])) for k in (0, 1)
    )
    whole, apart = np.zeros((len(rows), len(columns))), np.full((len(rows), len(columns)), math.nan)
    for k, start in enumerate(first):
        i, j = np.searchsorted(rows, start[0]), np.searchsorted(columns, start[1])
        here = slice(i, i + shape[0]), slice(j, j + shape[1])
        whole[here] += pressure[k]
        apart[here] = np.where(free[k], clearance[k], apart[here])
    s = (columns + 0.5) * cell[1]
    return HalfspaceContact(
        (rows + 0.5) * cell[0],
        s,
        whole,
        apart,
        delta,
        float(whole.sum() * area),
        float(loaded_area(whole) * area),
        peak_pressure(whole),
        iterations,
        angle=surfaces.angle(s),
    )


def _owned(first, shape):
    """Whether a cell of each grid (b, n, m) belongs to no grid before it."""
    rows, columns = (first[:, k, None] + np.arange(shape[k]) for k in (0, 1))
    owned = np.ones((len(first), *shape), dtype=bool)
    for one in range(len(first)):
        for other in range(one):
            row, column = (np.isin(each[one], each[other]) for each in (rows, columns))
            owned[one] &= ~(row[:, None] & column)
    return owned


def _sampled(found, x, s):
    """Pressure of ``found``, linear between its cells, at x, s; zero where they lie outside."""
    rows, columns = (
        np.interp(x, found.x, np.arange(len(found.x))),
        np.interp(s, found.s, np.arange(len(found.s))),
    )
    places = np.meshgrid(rows, columns, indexing="ij")
    return np.sqrt(
        np.maximum(ndimage.map_coordinates(found.pressure**2, places, order=1, mode="nearest"), 0.0)
    )


def _parts(found, hulls, cell):
    """Rows and columns (slices) of each grid within those of all."""
    shape, first = _blocks(hulls, cell)
    for start in first:
        begin = [
            int(np.searchsorted(centres, (start[k] + 0.4) * cell[k]))
            for k, centres in enumerate((found.x, found.s))
        ]
        yield tuple(slice(begin[k], begin[k] + shape[k]) for k in (0, 1))


def _outgrown(found, hulls, cell, domain):
    """The hulls, each larger where its outermost cells are loaded."""
    touched = [touched_sides(found.pressure[part]) for part in _parts(found, hulls, cell)]
    return [enlarged(each, sides, domain, 0.3) if any(sides) else each for each, sides in zip(hulls, touched)]


def _fitted(found, hulls, cell):
    """Boxes a cell larger than what is loaded on each grid; none where nothing is."""
    parts = [part for part in _parts(found, hulls, cell) if found.pressure[part].any()]
    return [
        around(found.pressure[part] > 0.0, found.x[part[0]], found.s[part[1]], *cell, 1.5) for part in parts
    ]
