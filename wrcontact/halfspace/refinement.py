"""One grid refined until the answer no longer changes, and the error that is left.  (H7)"""

import math

import numpy as np
from scipy import ndimage

from .boxes import centres, enlarged, touched_sides
from .one_grid import solve_grid
from .problem import HalfspaceContact
from .window import fit_window

COARSE_CELLS = 24  # per side of the first window
WINDOW_REPEATS = 12
CELL_LIMIT = 2_000_000  # of a grid
EDGE_DOUBT = 0.05  # [cells]; what is left of a patch's edge, as the error of an area


def solve_window(problem, window):
    """The contact on a coarse grid over ``window``, made larger until the patch lies inside."""
    for _ in range(WINDOW_REPEATS):
        found = solve_grid(problem, *centres(window, (COARSE_CELLS, COARSE_CELLS)))
        touched = touched_sides(found.pressure)
        if not any(touched):
            return found
        window = enlarged(window, touched, problem.domain, 0.4)
    raise ArithmeticError(
        f"the patch reaches beyond x = {window[0]:g} ... {window[1]:g} m, s = "
        f"{window[2]:g} ... {window[3]:g} m after {WINDOW_REPEATS} enlargements"
    )


def refine(problem, coarse, tolerance):
    """Grids fitted to the patches of ``coarse``, with cells halved until the answer stands
    within ``tolerance``. (H7)"""
    window, counts = fit_window(coarse)
    previous, found, iterations, before = coarse, coarse, coarse.iterations, None
    while True:
        found = solve_grid(
            problem.near(found.penetration), *centres(window, counts), _resampled(found, window, counts)
        )
        iterations += found.iterations
        touched = touched_sides(found.pressure)
        if any(touched):
            window, counts = _widened(window, counts, touched, problem.domain)
            continue
        change = changes(previous, found, problem.wanted)
        error = (
            change
            if before is None
            else {name: estimate_error(before[name], now) for name, now in change.items()}
        )
        error["area"] = max(error["area"], area_doubt(found))
        if before is not None and max(error.values()) <= tolerance:
            return HalfspaceContact(**{**vars(found), "iterations": iterations, "error": error})
        previous, before, counts = found, change, tuple(2 * n for n in counts)
        if counts[0] * counts[1] > CELL_LIMIT:
            raise ArithmeticError(
                f"tolerance is {tolerance:g}, but the error is still "
                f"{max(error.values()):.2g} on {counts[0] // 2} x {counts[1] // 2} cells; "
                f"permitted are {CELL_LIMIT} cells"
            )


def _widened(window, counts, touched, domain):
    """Window and cell numbers with a tenth more on the touched sides, cells as large as before."""
    wider = enlarged(window, touched, domain, 0.1)
    stretch = [(wider[k + 1] - wider[k]) / (window[k + 1] - window[k]) for k in (0, 2)]
    # a stretch of 1.1 is a whole number of cells more or less a rounding
    return wider, tuple(math.ceil(count * factor - 1e-9) for count, factor in zip(counts, stretch))


def _resampled(contact, window, counts):
    """Pressure of ``contact``, linear between its cells, at the cells of another grid."""
    x, s = centres(window, counts)
    rows = (x - contact.x[0]) / (contact.x[1] - contact.x[0])
    columns = (s - contact.s[0]) / (contact.s[1] - contact.s[0])
    places = np.meshgrid(rows, columns, indexing="ij")
    # Hertz's pressure is a root: its square is the smoother field
    return np.sqrt(np.maximum(ndimage.map_coordinates(contact.pressure**2, places, order=1, cval=0.0), 0.0))


def estimate_error(before, now):
    """Error that is left after halving the cells twice changed the answer by
    ``before`` and then by ``now``. (H7)

    The changes' ratio r tells the order, which lies between the first (r = 1/2) and the second (1/4); what is
    left is ``now r / (1 - r)``. A chance agreement counts as two steps of second order.
    """
    ratio = min(max(now / before, 0.25), 0.5) if before > 0.0 else 0.5
    return max(now * ratio / (1.0 - ratio), before / 16.0)


def area_doubt(found):
    """Share of the area that lies within EDGE_DOUBT of its edge, or that no loaded cell covers.

    Where bodies graze, p^2 does not fall linearly, and what is continued from the inner cells ends
    outside the loaded ones.
    """
    cell = (found.x[1] - found.x[0]) * (found.s[1] - found.s[0])
    return max(
        _edge_doubt(found.pressure > 0.0), found.area / (np.count_nonzero(found.pressure) * cell) - 1.0
    )


def _edge_doubt(loaded):
    """Share of the area that lies within EDGE_DOUBT of its edge."""
    crossings = np.count_nonzero(loaded[1:] != loaded[:-1]) + np.count_nonzero(
        loaded[:, 1:] != loaded[:, :-1]
    )
    return EDGE_DOUBT * math.pi / 4 * crossings / np.count_nonzero(loaded)


def changes(before, found, answer):
    """Relative changes from ``before`` to ``found`` by name; ``answer`` is what was not prescribed."""
    return {
        name: abs(getattr(before, name) / getattr(found, name) - 1.0)
        for name in (answer, "area", "max_pressure")
    }
