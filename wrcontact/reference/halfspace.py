"""Frictionless contact of two elastic half-spaces: the complete theory, for any gap between the undeformed bodies.

>>> import numpy as np
>>> from wrcontact.reference import halfspace
>>> ball = lambda x, s: (x[:, None] ** 2 + s**2) / (2 * 0.3)                       # radius 0.3 m on a flat
>>> contact = halfspace.solve_contact(ball, (-0.1, 0.1, -0.1, 0.1), contact_modulus=1.14e11, force=1e4)
>>> f"{contact.penetration:.2e} m, {contact.max_pressure:.2e} Pa"
'2.43e-05 m, 6.54e+08 Pa'

The bodies touch where the pressure p is positive; the equations (H1) ... are those of docs/method.md:

    u + h - delta = 0 where p > 0,   u + h - delta >= 0 where p = 0,   sum of p dx ds = N                        (H1)

Pressure is constant on each cell of a grid.  Its deflection u is a convolution (Love 1929; Johnson 1985, section 3.3), done
by fast Fourier transform; the pressures follow by conjugate gradients that keep p >= 0 (Polonsky and Keer 1999, Wear 231,
206-219).  :func:`solve` takes a grid; :func:`solve_contact` finds the patch and refines the grid until the answer stands.

Lengths in m, pressures in Pa, forces in N; x along the first axis of every array, s along the second.
"""

import math
from dataclasses import dataclass, field

import numpy as np
from scipy import fft, ndimage

#: Remaining residual of the contact condition, rms over the loaded cells, as a share of the largest deflection.
PRECISION = 1e-7
ITERATION_LIMIT = 1000
#: Error in penetration (or force), area and peak pressure at which a grid is fine enough.
TOLERANCE = 5e-3
TOLERANCE_RANGE = (3e-4, 0.1)     # the edge is known to EDGE_DOUBT: less would take more than CELL_LIMIT
#: The residual is reduced to this share of the tolerance, so that it does not count in the grid's error.
RESIDUAL_SHARE = 1e-3

SAMPLES = 48             # per side, of a box in which the patch is sought
ZOOM_LIMIT = 40
ZOOM_ENOUGH = 0.5        # a box that shrinks less than this in both directions is the window
WINDOW_MARGIN = 1.3      # on the estimated penetration that the window is made for
COARSE_CELLS = 24        # per side of the first window
WINDOW_REPEATS = 12
PATCH_CELLS = 20         # over the narrowest patch on the first grid that is fitted to it
#: A patch that carries less than this share of the load has no say in the cells' size.
MINOR_PATCH = 0.02
CELL_LIMIT = 2_000_000   # of a grid
LOOK = 25, 800           # samples along and across the domain of the look for places that a solution has missed
LOOK_SLACK = 0.25        # what a parabola along x finds below its samples is known to this share
LOOK_LUMPS = 16          # per side, of the pressures as the look sees them
LOOK_REPEATS = 5
PLACE_SAMPLES = 9        # per side, around a place
PLACE_ZOOMS = 4
MISSED_SHARE = 1e-3      # of the penetration: less overlap than this is nothing missed
MARGIN_CELLS = 2         # free cells around the patch
EDGE_LAYERS = 3          # cells by which a patch's p^2 is continued to find its edge
EDGE_PAD = EDGE_LAYERS + 1    # cells by which an edge field is larger than its pressure field, on each side
#: The edge of a grid's patch lies this far outside [cells]: Hertz's ellipses, 0.02 (1:10) ... 0.06 (circle), 40 to 140 cells.
EDGE_BIAS = 0.04
EDGE_DOUBT = 0.03        # [cells]; what this leaves, as the error of an area
DIRECTIONS = [(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1) if (i, j) != (0, 0)]


@dataclass(frozen=True)
class HalfspaceContact:
    """A solved contact.

    Attributes
    ----------
    x, s : cell centres (n,), (m,) [m]; evenly spaced, but for jumps where patches far from each other have their own grids.
    pressure : (n, m) [Pa], zero where the bodies are apart.
    clearance : distance of the deformed bodies u + h - delta (n, m) [m], zero to the precision where they touch; NaN where
        rows of one grid cross columns of another.
    penetration : delta, approach of distant points of the bodies [m].
    force : N [N].
    area : of the loaded cells, the edge found within the cells [m^2]; see :func:`loaded_area`.
    max_pressure : [Pa], see :func:`peak_pressure`.
    iterations : of the conjugate gradients, over all grids.
    error : estimated relative errors of the grid by name ("penetration" or "force", "area", "max_pressure"); empty from
        :func:`solve`, which knows one grid.
    """

    x: np.ndarray
    s: np.ndarray
    pressure: np.ndarray
    clearance: np.ndarray
    penetration: float
    force: float
    area: float
    max_pressure: float
    iterations: int
    error: dict = field(default_factory=dict)


# --- deflection ------------------------------------------------------------------------------------------------------


def corner_potential(x, s):
    """Integral of 1/r over the rectangle from (0, 0) to (x, s) [m]; odd in both, arrays broadcast.

    ``x arsinh(s / x) + s arsinh(x / s)``: Love (1929), Johnson (1985) eq. (3.25) with its logarithms gathered.  (H3)
    """
    return x * np.arcsinh(s / np.abs(x)) + s * np.arcsinh(x / np.abs(s))


def influence(rows, columns, dx, ds, *, contact_modulus):
    """Deflection [m] at 0 ... ``rows``, 0 ... ``columns`` cells' distance from a cell dx x ds [m] under 1 Pa: K.

    The four corners of the cell, seen from the place: Love (1929), Johnson (1985) eq. (3.25).  (H3)
    """
    x = (np.arange(rows + 2) - 0.5) * dx
    s = (np.arange(columns + 2) - 0.5) * ds
    corners = corner_potential(x[:, None], s[None, :])
    return np.diff(np.diff(corners, axis=0), axis=1) / (math.pi * contact_modulus)


class Deflection:
    """Pressure (n, m) [Pa] to deflection of both bodies together (n, m) [m]: the convolution (H2).

    The grid is padded to twice its size, so that the periodic convolution of the Fourier transform is the plain one.
    """

    def __init__(self, shape, dx, ds, contact_modulus):
        self.shape = shape
        self.padded = tuple(fft.next_fast_len(2 * count - 1, real=True) for count in shape)
        rows, columns = (np.minimum(np.arange(size), size - np.arange(size)) for size in self.padded)
        kernel = influence(rows.max(), columns.max(), dx, ds, contact_modulus=contact_modulus)
        self.transfer = fft.rfft2(kernel[rows[:, None], columns])

    def __call__(self, pressure):
        rows, columns = self.padded
        # one axis after the other: the padding rows are not transformed along s, nor back
        spectrum = fft.fft(fft.rfft(pressure, columns, axis=1), rows, axis=0, overwrite_x=True)
        spectrum *= self.transfer
        inside = fft.ifft(spectrum, axis=0, overwrite_x=True)[: self.shape[0]]
        return fft.irfft(inside, columns, axis=1)[:, : self.shape[1]]


class BlockDeflection:
    """As :class:`Deflection` for several grids (b, n, m) of equal cells, which press on each other.

    ``corners`` (b, 2) are the grids' first cells, counted in cells.
    """

    def __init__(self, shape, corners, dx, ds, contact_modulus):
        self.count, *self.shape = shape
        self.padded = tuple(fft.next_fast_len(2 * count - 1, real=True) for count in self.shape)
        places = [np.arange(size) for size in self.padded]
        places = [np.where(k < count, k, k - size) for k, count, size in zip(places, self.shape, self.padded)]
        self.transfer = np.empty((self.count, self.count, self.padded[0], self.padded[1] // 2 + 1), dtype=complex)
        for one in range(self.count):
            for other in range(self.count):
                away = [k + int(corners[one][axis] - corners[other][axis]) for axis, k in enumerate(places)]
                edges = [np.stack([k - 0.5, k + 0.5]) * step for k, step in zip(away, (dx, ds))]
                low, high = (corner_potential(edge[:, None], edges[1][:, None, :]) for edge in edges[0])
                kernel = (high[1] - high[0] - low[1] + low[0]) / (math.pi * contact_modulus)
                self.transfer[one, other] = fft.rfft2(kernel)

    def __call__(self, pressure):
        spectrum = np.einsum("abij,bij->aij", self.transfer, fft.rfft2(pressure, self.padded))
        return fft.irfft2(spectrum, self.padded)[:, : self.shape[0], : self.shape[1]]


# --- one grid --------------------------------------------------------------------------------------------------------


def solve(x, s, gap, *, contact_modulus, force=None, penetration=None, guess=None, precision=PRECISION):
    """The contact on a given grid, for a prescribed force or a prescribed penetration.

    Parameters
    ----------
    x, s : cell centres (n,), (m,) [m], rising and evenly spaced, two or more each.
    gap : undeformed distance h of the bodies (n, m) [m]; infinite where there is no surface.
    contact_modulus : E*, 1/E* = (1 - nu1**2)/E1 + (1 - nu2**2)/E2 [Pa].
    force : N [N], zero or more; or
    penetration : delta [m], against the zero of ``gap``; exactly one of the two.
    guess : pressure to start from (n, m) [Pa]; changes the cost, never the answer beyond ``precision``.
    precision : residual of the contact condition, rms over the loaded cells, as a share of the largest deflection.

    Returns
    -------
    HalfspaceContact

    Raises
    ------
    ValueError
        in one sentence with name, value, unit and what is permitted.
    ArithmeticError
        if the residual does not fall to ``precision`` within ITERATION_LIMIT iterations.
    """
    x, s, gap = _checked_grid(x, s, gap)
    _check_load(force, penetration)
    _check_number("contact_modulus", contact_modulus, "Pa", above=True)
    _check_number("precision", precision, "1", above=True)
    dx, ds = (float(centres[-1] - centres[0]) / (len(centres) - 1) for centres in (x, s))
    lowest = float(gap.min())
    if force == 0.0 or (force is None and penetration <= lowest):
        delta = lowest if force == 0.0 else float(penetration)
        return HalfspaceContact(x, s, np.zeros(gap.shape), gap - delta, delta, 0.0, 0.0, 0.0, 0)
    deflect = Deflection(gap.shape, dx, ds, contact_modulus)
    if guess is None or not np.any(np.asarray(guess) > 0.0):
        level = penetration if force is None else estimate_penetration(gap, dx * ds, contact_modulus, force)
        guess = np.sqrt(np.maximum(level - gap, 0.0))      # the shape of Hertz's pressure
    start = np.where(np.isfinite(gap), np.maximum(guess, 0.0), 0.0)
    mean = None if force is None else force / (dx * ds)
    pressure, clearance, delta, iterations = _constrained_gradients(start, gap, deflect, mean, penetration, precision)
    return HalfspaceContact(x, s, pressure, clearance, delta, float(pressure.sum() * dx * ds),
                            float(loaded_area(pressure) * dx * ds), peak_pressure(pressure), iterations)


def _constrained_gradients(pressure, gap, deflect, total, penetration, precision):
    """Pressure, clearance, penetration, iterations: Polonsky and Keer (1999), section 3.

    ``total`` is the sum of all pressures [Pa]; None where the penetration [m] is prescribed.  Their steps: residual on the
    loaded cells, conjugate direction, exact line search, tension cut off, overlapping cells let in, load restored.
    """
    pressure = _scaled(pressure, gap, deflect, total, penetration)
    bent = deflect(pressure)
    direction, last = np.zeros(gap.shape), math.inf
    for iteration in range(ITERATION_LIMIT + 1):
        loaded = pressure > 0.0
        clearance = bent + gap
        delta = penetration if total is None else float(clearance[loaded].mean())
        clearance -= delta
        residual = clearance[loaded]
        square = float(residual @ residual)
        allowed = precision * float(bent.max())
        outside = ~loaded & (clearance < 0.0)
        if square <= allowed**2 * residual.size and not np.any(clearance[outside] < -allowed):
            return pressure, clearance, delta, iteration
        direction = np.where(loaded, clearance + (square / last) * direction, 0.0)
        change = deflect(direction)
        along, answer = direction[loaded], change[loaded]
        if total is not None:
            answer = answer - answer.mean()
        step = float(residual @ along) / float(answer @ along)
        if not step > 0.0:      # the direction has lost its meaning: restart
            direction, last = np.zeros(gap.shape), math.inf
            continue
        pressure = pressure - step * direction
        cut = pressure < 0.0
        pressure[cut] = 0.0
        pressure[outside] = -step * clearance[outside]
        last = math.inf if outside.any() else square
        share = 1.0 if total is None else total / pressure.sum()
        pressure *= share
        bent = deflect(pressure) if cut.any() or outside.any() else share * (bent - step * change)
        if not math.isfinite(share):
            break
    raise ArithmeticError(f"the contact condition is met to {math.sqrt(square / max(residual.size, 1)):.3g} m after "
                          f"{ITERATION_LIMIT} iterations; permitted is {allowed:.3g} m")


def _scaled(pressure, gap, deflect, total, penetration):
    """``pressure`` with the right sum, or with the scale of least energy where the penetration is prescribed."""
    if total is not None:
        return pressure * (total / pressure.sum())
    loaded = pressure > 0.0
    p = pressure[loaded]
    work = float(p @ (penetration - gap[loaded]))
    return pressure * (max(work, 0.0) / float(p @ deflect(pressure)[loaded]) or 1.0)


def estimate_penetration(gap, cell, contact_modulus, force):
    """Penetration [m] at which the interpenetration's volume V and area A carry ``force`` [N].

    ``N = 8 E* V / (3 sqrt(2 pi A))``, exact for a ball on a flat; right within a factor of two for other shapes.
    ``gap`` is sampled on cells of the area ``cell`` [m^2].
    """
    heights = np.sort(gap[np.isfinite(gap)])
    count = np.arange(1, len(heights) + 1)
    sums = np.cumsum(heights)
    stiffness = 8.0 / (3.0 * math.sqrt(2.0 * math.pi)) * contact_modulus * math.sqrt(cell)
    carried = stiffness * (count * heights - sums) / np.sqrt(count)
    k = max(int(np.searchsorted(carried, force)), 1) - 1
    return float((force * math.sqrt(count[k]) / stiffness + sums[k]) / count[k])


# --- what is read from a pressure field -----------------------------------------------------------------------------


def edge_field(pressure):
    """A field (n + 2 EDGE_PAD, m + 2 EDGE_PAD) [Pa^2] whose zero line is the edge of the loaded cells, found within the cells.

    Towards the edge of a patch p^2 falls linearly (Hertz).  The outermost cells are loaded in part only and do not know;
    so p^2 of the cells behind them is continued along rows, columns and diagonals, and where several
    reach a cell their mean is taken.  (H6)  A patch without inner cells is left as it is, with half its p^2 outside.
    """
    loaded = np.pad(pressure > 0.0, EDGE_PAD + 1)
    square = np.pad(pressure**2, EDGE_PAD + 1)
    known = ndimage.binary_erosion(loaded, np.ones((3, 3)))
    square = np.where(known, square, 0.0)
    for _ in range(EDGE_LAYERS):
        square, known = _continued(square, known)
    near = ndimage.binary_dilation(loaded, np.ones((3, 3)))
    square[~near] = np.minimum(square[~near], 0.0)
    lost = loaded & ~known
    inner = (slice(EDGE_PAD + 1, -EDGE_PAD - 1),) * 2
    square[lost] = (pressure**2)[lost[inner]]
    border = ~loaded & ndimage.binary_dilation(lost, np.ones((3, 3))) & ~known
    square[border] = -ndimage.maximum_filter(np.where(lost, square, 0.0), 3)[border]
    return square[1:-1, 1:-1]


def _continued(square, known):
    """``square`` continued by one cell around the ``known`` ones, and which are known then: by parabolas through three
    cells in line, which are exact for Hertz's p^2, or straight where only two are known."""
    total, count = np.zeros(square.shape), np.zeros(square.shape)
    for step in DIRECTIONS:
        one, two, three = (_shifted(square, step, k) for k in (1, 2, 3))
        straight = ~known & _shifted(known, step, 1) & _shifted(known, step, 2)
        curved = straight & _shifted(known, step, 3)
        total += np.where(curved, 3.0 * (one - two) + three, np.where(straight, 2.0 * one - two, 0.0))
        count += straight
    reached = count > 0.0
    square[reached] = total[reached] / count[reached]
    return square, known | reached


def _shifted(array, step, times):
    return np.roll(array, (times * step[0], times * step[1]), (0, 1))


def loaded_area(pressure):
    """Loaded area in cells: inside the zero line of :func:`edge_field`, less EDGE_BIAS along it."""
    return edge_area(edge_field(pressure))


def edge_area(values):
    """Area in cells where ``values`` (n, m), linear on the four triangles of each square of centres, are positive, less
    EDGE_BIAS along its edge."""
    corners = np.stack([values[:-1, :-1], values[1:, :-1], values[1:, 1:], values[:-1, 1:]])
    positive = (corners > 0.0).sum(axis=0)
    cut = corners[:, (positive > 0) & (positive < 4)]
    middle = cut.mean(axis=0)
    triangles = np.concatenate([np.stack([cut[k], cut[(k + 1) % 4], middle]) for k in range(4)], axis=1)
    inside = np.count_nonzero(positive == 4) + 0.25 * _positive_share(triangles).sum()
    length = math.pi / 4 * cut.shape[1]      # of the edge: a closed line meets 4/pi squares per unit of its length
    return float(inside - EDGE_BIAS * length)


def _positive_share(corners):
    """Share of triangles on which linear functions with ``corners`` (3, n) are positive."""
    low, middle, high = np.sort(corners, axis=0)
    share = np.where(low > 0.0, 1.0, 0.0)
    one = (high > 0.0) & (middle <= 0.0)
    two = (middle > 0.0) & (low <= 0.0)
    share[one] = (high[one] / (high[one] - low[one])) * (high[one] / (high[one] - middle[one]))
    share[two] = 1.0 - (low[two] / (low[two] - middle[two])) * (low[two] / (low[two] - high[two]))
    return share


def peak_pressure(pressure):
    """The highest pressure [Pa]: parabolas along x and s through the highest cell and its loaded neighbours."""
    i, j = np.unravel_index(np.argmax(pressure), pressure.shape)
    return float(pressure[i, j] + _rise(pressure[:, j], i) + _rise(pressure[i], j))


def _rise(row, k):
    """Height of the vertex of the parabola through k - 1, k, k + 1 over ``row[k]``; 0 at an end."""
    if not 0 < k < len(row) - 1 or row[k - 1] == 0.0 or row[k + 1] == 0.0:
        return 0.0
    bend = 2.0 * row[k] - row[k - 1] - row[k + 1]
    return (row[k + 1] - row[k - 1]) ** 2 / (8.0 * bend) if bend > 0.0 else 0.0


# --- from a gap to a converged contact ------------------------------------------------------------------------------


def solve_contact(gap_function, domain, *, contact_modulus, force=None, penetration=None, tolerance=TOLERANCE):
    """The contact for any gap: finds the patches, fits a grid to them, and refines it until the answer stands.

    A solution stands only if the bodies overlap nowhere else in the domain (:func:`missed`); where they do, or patches have
    been missed at first, each group of patches has its own grid.

    Parameters
    ----------
    gap_function : called with cell centres x (n,), s (m,) [m]; returns the undeformed distance (n, m) [m], infinite where
        there is no surface.
    domain : (x_low, x_high, s_low, s_high) [m], within which all patches lie; the look for further ones takes LOOK samples
        of it, and along x one minimum for each s.
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
    _check_load(force, penetration)
    _check_number("contact_modulus", contact_modulus, "Pa", above=True)
    domain = _checked_domain(domain)
    if not TOLERANCE_RANGE[0] <= tolerance <= TOLERANCE_RANGE[1]:
        raise ValueError(f"tolerance is {tolerance!r}; permitted is {TOLERANCE_RANGE[0]:g} ... {TOLERANCE_RANGE[1]:g} 1")
    load = {"contact_modulus": contact_modulus, "force": force, "penetration": penetration,
            "precision": RESIDUAL_SHARE * tolerance}
    window = find_window(gap_function, domain, contact_modulus=contact_modulus, force=force, penetration=penetration)
    coarse = _solve_window(gap_function, domain, window, load)
    if not coarse.pressure.any():
        return coarse
    look = ridge(gap_function, domain)
    boxes = missed(gap_function, domain, look, coarse, contact_modulus)
    if not boxes:
        found = _refine(gap_function, domain, coarse, load, tolerance)
        boxes = missed(gap_function, domain, look, found, contact_modulus)
        if not boxes:
            return found
        coarse = found
    for _ in range(LOOK_REPEATS):
        found = _refine_blocks(gap_function, domain, merged(loaded_boxes(coarse) + boxes), load, tolerance)
        boxes = missed(gap_function, domain, look, found, contact_modulus)
        if not boxes:
            return found
        coarse = found
    raise ArithmeticError(f"{len(boxes)} places are still missed after {LOOK_REPEATS} looks; permitted is none")


def find_window(gap_function, domain, *, contact_modulus, force=None, penetration=None):
    """(x_low, x_high, s_low, s_high) [m] of what the penetration reaches, all patches together.

    Bodies touch only where h < delta.  A box is sampled, and shrinks to the samples that are, or may have between them,
    a gap below the given or estimated penetration; between samples a gap dips below them by a quarter of their second
    differences at most, if those resolve it.
    """
    box = domain
    for _ in range(ZOOM_LIMIT):
        x, s = _centres(box, (SAMPLES, SAMPLES))
        dx, ds = x[1] - x[0], s[1] - s[0]
        gap = np.asarray(gap_function(x, s), dtype=float)
        if not np.isfinite(gap).any():
            raise ArithmeticError(f"there is no surface between x = {box[0]:g} ... {box[1]:g} m and s = {box[2]:g} ... "
                                  f"{box[3]:g} m; permitted are domains with a finite gap")
        level = penetration
        if force is not None:
            lowest = float(gap.min())
            level = lowest + WINDOW_MARGIN * (estimate_penetration(gap, dx * ds, contact_modulus, force) - lowest)
        near = gap - _dip(gap) <= max(level, gap.min())
        shrunk = _clipped(_around(near, x, s, dx, ds, 1.5), domain)
        if all(shrunk[k + 1] - shrunk[k] > ZOOM_ENOUGH * (box[k + 1] - box[k]) for k in (0, 2)):
            return shrunk
        box = shrunk
    return box


def _dip(gap):
    """How far the gap may fall below its samples between them (n, m) [m]."""
    padded = np.pad(gap, 1, mode="edge")
    with np.errstate(invalid="ignore"):
        along = np.abs(padded[2:, 1:-1] + padded[:-2, 1:-1] - 2.0 * gap)
        across = np.abs(padded[1:-1, 2:] + padded[1:-1, :-2] - 2.0 * gap)
        dip = 0.25 * (along + across)
    return np.where(np.isfinite(dip), dip, 0.0)


def _solve_window(gap_function, domain, window, load):
    """The contact on a coarse grid over ``window``, made larger until the patch lies inside."""
    for _ in range(WINDOW_REPEATS):
        found = _solve_on(gap_function, window, (COARSE_CELLS, COARSE_CELLS), load, None)
        touched = _touched(found.pressure)
        if not any(touched):
            return found
        window = _enlarged(window, touched, domain, 0.4)
    raise ArithmeticError(f"the patch reaches beyond x = {window[0]:g} ... {window[1]:g} m, s = {window[2]:g} ... "
                          f"{window[3]:g} m after {WINDOW_REPEATS} enlargements")


def _refine(gap_function, domain, coarse, load, tolerance):
    """Grids fitted to the patches of ``coarse``, with cells halved until the answer stands within ``tolerance``.  (H7)"""
    window, counts = fit_window(coarse)
    answer = "force" if load["force"] is None else "penetration"
    found, iterations, before = coarse, coarse.iterations, None
    while True:
        previous, found = found, _solve_on(gap_function, window, counts, load, _resampled(found, window, counts))
        iterations += found.iterations
        touched = _touched(found.pressure)
        if any(touched):
            window, counts = _widened(window, counts, touched, domain)
            continue
        change = _changes(previous, found, answer)
        error = change if before is None else {name: estimate_error(before[name], now) for name, now in change.items()}
        error["area"] = max(error["area"], _area_doubt(found))
        if before is not None and max(error.values()) <= tolerance:
            return HalfspaceContact(**{**vars(found), "iterations": iterations, "error": error})
        before, counts = change, tuple(2 * n for n in counts)
        if counts[0] * counts[1] > CELL_LIMIT:
            raise ArithmeticError(f"tolerance is {tolerance:g}, but the error is still {max(error.values()):.2g} on "
                                  f"{counts[0] // 2} x {counts[1] // 2} cells; permitted are {CELL_LIMIT} cells")


def _widened(window, counts, touched, domain):
    """Window and cell numbers with a tenth more on the touched sides, cells as large as before."""
    wider = _enlarged(window, touched, domain, 0.1)
    stretch = [(wider[k + 1] - wider[k]) / (window[k + 1] - window[k]) for k in (0, 2)]
    return wider, tuple(math.ceil(count * factor) for count, factor in zip(counts, stretch))


def fit_window(contact):
    """Window around the loaded cells and the number of cells (n, m) that gives each patch PATCH_CELLS both ways."""
    x, s, loaded = contact.x, contact.s, contact.pressure > 0.0
    dx, ds = x[1] - x[0], s[1] - s[0]
    labels, _ = ndimage.label(loaded, np.ones((3, 3)))
    sizes = [(rows.stop - rows.start, columns.stop - columns.start)
             for number, (rows, columns) in enumerate(ndimage.find_objects(labels), 1)
             if contact.pressure[labels == number].sum() >= MINOR_PATCH * contact.pressure.sum()]
    narrowest = [max(min(sizes_along), 1.0) for sizes_along in zip(*sizes)]
    low_x, high_x, low_s, high_s = _around(loaded, x, s, dx, ds, 0.5)
    cells = []
    bounds = []
    for low, high, spacing, narrow in ((low_x, high_x, dx, narrowest[0]), (low_s, high_s, ds, narrowest[1])):
        width = narrow * spacing / PATCH_CELLS
        count = min(math.ceil((high - low) / width), 8 * PATCH_CELLS)
        margin = MARGIN_CELLS * (high - low) / count
        bounds += [low - margin, high + margin]
        cells.append(count + 2 * MARGIN_CELLS)
    return tuple(bounds), tuple(cells)


def _solve_on(gap_function, window, counts, load, guess):
    x, s = _centres(window, counts)
    return solve(x, s, gap_function(x, s), guess=guess, **load)


def _resampled(contact, window, counts):
    """Pressure of ``contact``, linear between its cells, at the cells of another grid."""
    x, s = _centres(window, counts)
    rows = (x - contact.x[0]) / (contact.x[1] - contact.x[0])
    columns = (s - contact.s[0]) / (contact.s[1] - contact.s[0])
    places = np.meshgrid(rows, columns, indexing="ij")
    # Hertz's pressure is a root: its square is the smoother field
    return np.sqrt(np.maximum(ndimage.map_coordinates(contact.pressure**2, places, order=1, cval=0.0), 0.0))


def estimate_error(before, now):
    """Error that is left after halving the cells twice changed the answer by ``before`` and then by ``now``.  (H7)

    The changes' ratio r tells the order, which lies between the first (r = 1/2) and the second (1/4); what is left is
    ``now r / (1 - r)``.  A chance agreement counts as two steps of second order.
    """
    ratio = min(max(now / before, 0.25), 0.5) if before > 0.0 else 0.5
    return max(now * ratio / (1.0 - ratio), before / 16.0)


def _area_doubt(found):
    """Share of the area that lies within EDGE_DOUBT of its edge, or that no loaded cell covers.

    Where bodies graze, p^2 does not fall linearly, and what is continued from the inner cells ends outside the loaded ones.
    """
    cell = (found.x[1] - found.x[0]) * (found.s[1] - found.s[0])
    return max(_edge_doubt(found.pressure > 0.0), found.area / (np.count_nonzero(found.pressure) * cell) - 1.0)


def _edge_doubt(loaded):
    """Share of the area that lies within EDGE_DOUBT of its edge."""
    crossings = np.count_nonzero(loaded[1:] != loaded[:-1]) + np.count_nonzero(loaded[:, 1:] != loaded[:, :-1])
    return EDGE_DOUBT * math.pi / 4 * crossings / np.count_nonzero(loaded)


def _changes(before, found, answer):
    """Relative changes from ``before`` to ``found`` by name; ``answer`` is what was not prescribed."""
    return {name: abs(getattr(before, name) / getattr(found, name) - 1.0) for name in (answer, "area", "max_pressure")}


# --- patches that a solution has missed -----------------------------------------------------------------------------


def ridge(gap_function, domain):
    """Stations s (m,), and for each the place x (m,) of the least gap, that gap (m,) and what it may be lower (m,) [m].

    Along x a wheel's gap is smooth and has one minimum: the parabola through the three lowest of few samples finds it.
    Across, samples are dense.
    """
    x, s = _centres(domain, LOOK)
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
    return s, x[k] + turn * (x[1] - x[0]), low, LOOK_SLACK * fall + _dip(low[None])[0]


def missed(gap_function, domain, look, found, contact_modulus):
    """Boxes (x_low, x_high, s_low, s_high) [m] where the bodies of a solution overlap away from its loaded cells.

    At each minimum along the ``look`` of the gap with the deflection under the found pressures that may lie below the
    penetration, the gap is sampled ever more closely; where it does lie below, the overlap is boxed.  (H9)
    """
    s, x, low, spare = look
    near = np.flatnonzero(low - spare < found.penetration)
    total = np.full(len(s) + 2, math.inf)
    total[near + 1] = low[near] + far_deflection(found, x[near], s[near], contact_modulus)
    lowest = (total[1:-1] <= total[:-2]) & (total[1:-1] < total[2:])
    places = [k for k in np.flatnonzero(lowest) if total[k + 1] - spare[k] < found.penetration
              and not _is_loaded(found, x[k], s[k])]
    step_x, step_s = (domain[1] - domain[0]) / LOOK[0], s[1] - s[0]
    boxes = []
    for k in places:
        box = _clipped((x[k] - step_x, x[k] + step_x, s[k] - 1.5 * step_s, s[k] + 1.5 * step_s), domain)
        place, gap = _lowest_place(gap_function, box)
        level = found.penetration - far_deflection(found, *(np.array([value]) for value in place), contact_modulus)[0]
        if gap < level - MISSED_SHARE * found.penetration and not _is_loaded(found, *place):
            boxes.append(_overlap(gap_function, domain, place, level, step_s))
    return boxes


def far_deflection(found, x, s, contact_modulus):
    """Deflection [m] at places x (k,), s (k,) under a solution's pressures, in lumps: sum of N / (pi E* r).  (H9)"""
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


def _is_loaded(found, x, s):
    """Whether a cell is loaded at or next to (x, s)."""
    i, j = int(np.argmin(np.abs(found.x - x))), int(np.argmin(np.abs(found.s - s)))
    if abs(found.x[i] - x) > 1.5 * (found.x[1] - found.x[0]) or abs(found.s[j] - s) > 1.5 * (found.s[1] - found.s[0]):
        return False
    return bool(found.pressure[max(i - 1, 0):i + 2, max(j - 1, 0):j + 2].any())


def _lowest_place(gap_function, box):
    """The place (x, s) of the least gap in a box, and that gap."""
    for _ in range(PLACE_ZOOMS):
        x, s = _centres(box, (PLACE_SAMPLES, PLACE_SAMPLES))
        gap = gap_function(x, s)
        i, j = np.unravel_index(np.argmin(gap), gap.shape)
        dx, ds = x[1] - x[0], s[1] - s[0]
        box = x[i] - 1.5 * dx, x[i] + 1.5 * dx, s[j] - 1.5 * ds, s[j] + 1.5 * ds
    return (x[i], s[j]), float(gap[i, j])


def _overlap(gap_function, domain, place, level, size):
    """Box around ``place`` in which the gap lies below ``level``, from one of the ``size`` [m] on."""
    half = [size, size]
    for _ in range(WINDOW_REPEATS):
        box = _clipped((place[0] - half[0], place[0] + half[0], place[1] - half[1], place[1] + half[1]), domain)
        x, s = _centres(box, (COARSE_CELLS, COARSE_CELLS))
        below, _ = ndimage.label(gap_function(x, s) < level, np.ones((3, 3)))
        here = below == below[np.argmin(np.abs(x - place[0])), np.argmin(np.abs(s - place[1]))]
        if not here.any() or not below[here].all():
            return box
        touched = _touched(here)
        if not any(touched):
            return _around(here, x, s, x[1] - x[0], s[1] - s[0], 0.5)
        half = [size * (2 if any(touched[2 * k:2 * k + 2]) else 1) for k, size in enumerate(half)]
    return box


def loaded_boxes(found):
    """Box around each connected run of loaded cells that is more than a stray one."""
    dx, ds = found.x[1] - found.x[0], found.s[1] - found.s[0]
    labels, _ = ndimage.label(found.pressure > 0.0, np.ones((3, 3)))
    return [(found.x[rows][0] - 0.5 * dx, found.x[rows][-1] + 0.5 * dx, found.s[columns][0] - 0.5 * ds,
             found.s[columns][-1] + 0.5 * ds) for rows, columns in ndimage.find_objects(labels)]


def merged(boxes):
    """Groups of boxes: those that come closer to each other than a quarter of their sizes are solved on one grid."""
    groups = [[box] for box in boxes]
    while True:
        pair = next(((a, b) for a in range(len(groups)) for b in range(a) if _close(hull(groups[a]), hull(groups[b]))), None)
        if pair is None:
            return groups
        groups[pair[1]] += groups.pop(pair[0])


def hull(boxes):
    """The box around boxes."""
    sides = np.array(boxes)
    return sides[:, 0].min(), sides[:, 1].max(), sides[:, 2].min(), sides[:, 3].max()


def _close(one, other):
    spare = [0.25 * (one[k + 1] - one[k] + other[k + 1] - other[k]) for k in (0, 2)]
    return all(one[k] - spare[k // 2] < other[k + 1] and other[k] - spare[k // 2] < one[k + 1] for k in (0, 2))


def _refine_blocks(gap_function, domain, groups, load, tolerance):
    """As :func:`_refine`, each group of boxes on its own grid, all with equal cells."""
    boxes = [box for group in groups for box in group]
    hulls = [hull(group) for group in groups]
    cell = [max(min(box[k + 1] - box[k] for box in boxes) / PATCH_CELLS,
                max(each[k + 1] - each[k] for each in hulls) / (8 * PATCH_CELLS)) for k in (0, 2)]
    answer = "force" if load["force"] is None else "penetration"
    previous, before, iterations = None, None, 0
    error = {}
    while True:
        if len(hulls) * np.prod(_blocks(hulls, cell)[0]) > CELL_LIMIT:
            raise ArithmeticError(f"tolerance is {tolerance:g}, but the error is still {max(error.values(), default=1):.2g}"
                                  f"; permitted are {CELL_LIMIT} cells")
        found = _solve_blocks(gap_function, domain, hulls, cell, load, previous)
        iterations += found.iterations
        wider = _outgrown(found, hulls, cell, domain)
        if wider != hulls:
            # grids that grew into each other become one
            hulls = [hull(group) for group in merged(wider)]
            continue
        if previous is None:
            hulls = [hull(group) for group in merged(_fitted(found, hulls, cell))]
        else:
            change = _changes(previous, found, answer)
            error = {name: estimate_error(before[name], now) if before else now for name, now in change.items()}
            error["area"] = max(error["area"], _area_doubt(found))
            if before is not None and max(error.values()) <= tolerance:
                return HalfspaceContact(**{**vars(found), "iterations": iterations, "error": error})
            before = change
        previous, cell = found, [0.5 * size for size in cell]


def _blocks(hulls, cell):
    """Number of cells (n, m) of every grid, and the grids' first cells (b, 2): the hulls with free cells around."""
    first = [[math.floor(each[k] / cell[k // 2] + 1e-9) - EDGE_PAD for k in (0, 2)] for each in hulls]
    shape = [max(math.ceil(each[2 * k + 1] / cell[k] - 1e-9) + EDGE_PAD - start[k] for each, start in zip(hulls, first))
             for k in (0, 1)]
    return shape, np.array(first)


def _solve_blocks(gap_function, domain, hulls, cell, load, guess):
    """The contact on one grid a hull, on the rows and columns of all of them."""
    shape, first = _blocks(hulls, cell)
    centres = [tuple((start[k] + 0.5 + np.arange(shape[k])) * cell[k] for k in (0, 1)) for start in first]
    gap = np.stack([gap_function(x, s) for x, s in centres])
    deflect = BlockDeflection(gap.shape, first, *cell, load["contact_modulus"])
    area = cell[0] * cell[1]
    if guess is None:
        level = load["penetration"] if load["force"] is None else estimate_penetration(
            gap.ravel(), area, load["contact_modulus"], load["force"])
        start = np.sqrt(np.maximum(level - gap, 0.0))
    else:
        start = np.stack([_sampled(guess, x, s) for x, s in centres])
    # two grids may share cells: the first one has them
    free = _owned(first, shape)
    gap = np.where(free, gap, math.inf)
    start = np.where(np.isfinite(gap), start, 0.0)
    total = None if load["force"] is None else load["force"] / area
    pressure, clearance, delta, iterations = _constrained_gradients(start, gap, deflect, total, load["penetration"],
                                                                    load["precision"])
    rows, columns = (np.unique(np.concatenate([start[k] + np.arange(shape[k]) for start in first])) for k in (0, 1))
    whole, apart = np.zeros((len(rows), len(columns))), np.full((len(rows), len(columns)), math.nan)
    for k, start in enumerate(first):
        i, j = np.searchsorted(rows, start[0]), np.searchsorted(columns, start[1])
        here = slice(i, i + shape[0]), slice(j, j + shape[1])
        whole[here] += pressure[k]
        apart[here] = np.where(free[k], clearance[k], apart[here])
    return HalfspaceContact((rows + 0.5) * cell[0], (columns + 0.5) * cell[1], whole, apart, delta,
                            float(whole.sum() * area), float(loaded_area(whole) * area), peak_pressure(whole), iterations)


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
    rows, columns = np.interp(x, found.x, np.arange(len(found.x))), np.interp(s, found.s, np.arange(len(found.s)))
    places = np.meshgrid(rows, columns, indexing="ij")
    return np.sqrt(np.maximum(ndimage.map_coordinates(found.pressure**2, places, order=1, mode="nearest"), 0.0))


def _parts(found, hulls, cell):
    """Rows and columns (slices) of each grid within those of all."""
    shape, first = _blocks(hulls, cell)
    for start in first:
        begin = [int(np.searchsorted(centres, (start[k] + 0.4) * cell[k])) for k, centres in enumerate((found.x, found.s))]
        yield tuple(slice(begin[k], begin[k] + shape[k]) for k in (0, 1))


def _outgrown(found, hulls, cell, domain):
    """The hulls, each larger where its outermost cells are loaded."""
    touched = [_touched(found.pressure[part]) for part in _parts(found, hulls, cell)]
    return [_enlarged(each, sides, domain, 0.3) if any(sides) else each for each, sides in zip(hulls, touched)]


def _fitted(found, hulls, cell):
    """Boxes a cell larger than what is loaded on each grid; none where nothing is."""
    parts = [part for part in _parts(found, hulls, cell) if found.pressure[part].any()]
    return [_around(found.pressure[part] > 0.0, found.x[part[0]], found.s[part[1]], *cell, 1.5) for part in parts]


# --- boxes and grids --------------------------------------------------------------------------------------------------


def _centres(box, counts):
    """Centres (n,), (m,) of n x m cells that fill a box."""
    return tuple(low + (high - low) * (np.arange(count) + 0.5) / count
                 for low, high, count in zip(box[::2], box[1::2], counts))


def _around(marked, x, s, dx, ds, margin):
    """Box around the marked cells' centres, ``margin`` cells larger on each side."""
    rows, columns = np.flatnonzero(marked.any(axis=1)), np.flatnonzero(marked.any(axis=0))
    return (x[rows[0]] - margin * dx, x[rows[-1]] + margin * dx, s[columns[0]] - margin * ds, s[columns[-1]] + margin * ds)


def _clipped(box, domain):
    return tuple((max if k % 2 == 0 else min)(side, end) for k, (side, end) in enumerate(zip(box, domain)))


def _touched(pressure):
    """Whether a border of the grid is loaded: x low, x high, s low, s high."""
    return bool(pressure[0].any()), bool(pressure[-1].any()), bool(pressure[:, 0].any()), bool(pressure[:, -1].any())


def _enlarged(box, touched, domain, share):
    """``box`` larger by ``share`` of its size on the touched sides; ArithmeticError where the domain ends."""
    sides = list(box)
    for k, touch in enumerate(touched):
        if touch:
            if (sides[k] <= domain[k]) if k % 2 == 0 else (sides[k] >= domain[k]):
                raise ArithmeticError(f"the patch reaches {'x' if k < 2 else 's'} = {domain[k]:g} m, the end of the domain; "
                                      "permitted are patches inside")
            size = box[k | 1] - box[k & 2]
            sides[k] += share * size * (1 if k % 2 else -1)
    return _clipped(sides, domain)


# --- checks -----------------------------------------------------------------------------------------------------------


def _check_number(name, value, unit, above=False):
    """ValueError unless ``value`` is a finite number >= 0, or > 0 where ``above``."""
    try:
        good = math.isfinite(value) and (value > 0.0 if above else value >= 0.0)
    except TypeError:
        good = False
    if not good:
        raise ValueError(f"{name} is {value!r} {unit}; permitted is {name} {'>' if above else '>='} 0 {unit}, finite")


def _check_load(force, penetration):
    if (force is None) == (penetration is None):
        raise ValueError(f"force is {force!r} N and penetration is {penetration!r} m; permitted is exactly one of them")
    if force is not None:
        _check_number("force", force, "N")
    elif not (isinstance(penetration, (int, float, np.number)) and math.isfinite(penetration)):
        raise ValueError(f"penetration is {penetration!r} m; permitted are finite numbers")


def _checked_domain(domain):
    try:
        x_low, x_high, s_low, s_high = (float(side) for side in domain)
        good = x_low < x_high and s_low < s_high and math.isfinite(x_high - x_low) and math.isfinite(s_high - s_low)
    except (TypeError, ValueError):
        good = False
    if not good:
        raise ValueError(f"domain is {domain!r} m; permitted is (x_low, x_high, s_low, s_high), finite, low below high")
    return x_low, x_high, s_low, s_high


def _checked_grid(x, s, gap):
    x, s, gap = (np.asarray(array, dtype=float) for array in (x, s, gap))
    for name, centres in (("x", x), ("s", s)):
        steps = np.diff(centres) if centres.ndim == 1 else np.zeros(0)
        if len(steps) == 0 or not steps[0] > 0.0 or not np.all(np.abs(steps - steps.mean()) <= 1e-6 * steps.mean()):
            raise ValueError(f"{name} has shape {centres.shape}; permitted are two or more rising, evenly spaced values in m")
    if gap.shape != (len(x), len(s)):
        raise ValueError(f"gap has shape {gap.shape}; permitted is {(len(x), len(s))}, one value in m per cell")
    if np.isnan(gap).any() or not np.isfinite(gap).any() or np.any(gap == -math.inf):
        raise ValueError("gap holds nan or no finite value in m; permitted are finite values, and inf without a surface")
    return x, s, gap
