"""Where to look: the window that the load reaches, and the ridge along which surfaces are closest, by which
patches that a solution has missed are found."""

from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from .boxes import around, centres, clipped
from .gradients import estimate_penetration

# samples along and across the domain of the look for places that a solution has missed
LOOK = 25, 800
LOOK_SLACK = 0.25  # what a parabola along x finds below its samples is known to this share
SAMPLES = 48  # per side, of a box in which the patch is sought
ZOOM_LIMIT = 40
ZOOM_ENOUGH = 0.5  # a box that shrinks less than this in both directions is the window
WINDOW_MARGIN = 1.3  # on the estimated penetration that the window is made for
PATCH_CELLS = 20  # over the narrowest patch on the first grid that is fitted to it
#: A patch that carries less than this share of the load has no say in the cells' size.
MINOR_PATCH = 0.02
MARGIN_CELLS = 2  # free cells around the patch


@dataclass(frozen=True)
class Ridge:
    """The least gap along x at many stations.

    Attributes
    ----------
    s : stations (m,), rising [m].
    x : place of the least gap (m,) [m].
    low : that gap, at no penetration (m,) [m].
    spare : how much lower it may be (m,) [m].
    step : how well the places x are known [m].
    """

    s: np.ndarray
    x: np.ndarray
    low: np.ndarray
    spare: np.ndarray
    step: float


def find_window(gap_function, problem):
    """(x_low, x_high, s_low, s_high) [m] of what the penetration reaches, all patches together.

    Bodies touch only where h < delta. A box is sampled, and shrinks to the samples that are, or may have
    between them, a gap below the given or estimated penetration; between samples a gap dips below them by a
    quarter of their second differences at most, if those resolve it.
    """
    box, domain, force = problem.domain, problem.domain, problem.force
    for _ in range(ZOOM_LIMIT):
        x, s = centres(box, (SAMPLES, SAMPLES))
        dx, ds = x[1] - x[0], s[1] - s[0]
        gap = np.asarray(gap_function(x, s), dtype=float)
        if not np.isfinite(gap).any():
            raise ArithmeticError(
                f"there is no surface between x = {box[0]:g} ... {box[1]:g} m and s = "
                f"{box[2]:g} ... {box[3]:g} m; permitted are domains with a finite gap"
            )
        level = problem.penetration
        if force is not None:
            lowest = float(gap.min())
            estimate = estimate_penetration(gap, dx * ds, problem.contact_modulus, force)
            level = lowest + WINDOW_MARGIN * (estimate - lowest)
        near = gap - dip(gap) <= max(level, gap.min())
        shrunk = clipped(around(near, x, s, dx, ds, 1.5), domain)
        if all(shrunk[k + 1] - shrunk[k] > ZOOM_ENOUGH * (box[k + 1] - box[k]) for k in (0, 2)):
            return shrunk
        box = shrunk
    return box


def dip(gap):
    """How far the gap may fall below its samples between them (n, m) [m]."""
    padded = np.pad(gap, 1, mode="edge")
    with np.errstate(invalid="ignore"):
        along = np.abs(padded[2:, 1:-1] + padded[:-2, 1:-1] - 2.0 * gap)
        across = np.abs(padded[1:-1, 2:] + padded[1:-1, :-2] - 2.0 * gap)
        dip = 0.25 * (along + across)
    return np.where(np.isfinite(dip), dip, 0.0)


def fit_window(contact):
    """Window around the loaded cells and the number of cells (n, m) that gives each patch
    PATCH_CELLS both ways.  Cells are counted, not measured, so that no number hangs on rounding: a single
    patch has exactly PATCH_CELLS."""
    loaded = contact.pressure > 0.0
    labels, _ = ndimage.label(loaded, np.ones((3, 3)))
    sizes = [
        (rows.stop - rows.start, columns.stop - columns.start)
        for number, (rows, columns) in enumerate(ndimage.find_objects(labels), 1)
        if contact.pressure[labels == number].sum() >= MINOR_PATCH * contact.pressure.sum()
    ]
    bounds, cells = (), ()
    for axis, centre in enumerate((contact.x, contact.s)):
        marked = np.flatnonzero(loaded.any(axis=1 - axis))
        spacing = centre[1] - centre[0]
        low, high = centre[marked[0]] - 0.5 * spacing, centre[marked[-1]] + 0.5 * spacing
        span, narrowest = int(marked[-1] - marked[0]) + 1, min(size[axis] for size in sizes)
        count = min(-(-PATCH_CELLS * span // narrowest), 8 * PATCH_CELLS)  # rounded up
        margin = MARGIN_CELLS * (high - low) / count
        bounds += (low - margin, high + margin)
        cells += (count + 2 * MARGIN_CELLS,)
    return bounds, cells
