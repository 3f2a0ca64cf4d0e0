"""Frictionless normal contact of two elastic half-spaces: the slow, independent
witness for patch and pressure.

Half-space solver: pressure constant on each rectangle of a grid, displacement by Love (1929) and a fast
Fourier convolution, complementarity by the constrained conjugate gradients of Polonsky & Keer (1999)::

    gap h(x, s), force N  ->  pressure p >= 0,  u(p) + h - delta >= 0,  p (u + h - delta) = 0,  sum p = N

True gap of wheel and rail: both surfaces are met along the normals of the tangent plane at the rigid contact
point, by root search on the surfaces themselves - no parabola along the rail, no contact locus::

    rigid pose -> tangent plane -> h(x, s) -> coarse solution -> grid fitted to the patch -> solution

References: Love, Phil. Trans. R. Soc. A 228 (1929); Johnson, Contact Mechanics (1985), section 3.3; Polonsky
& Keer, Wear 231 (1999) 206-219. Units m, N, Pa, rad.
"""

from dataclasses import dataclass, replace
from math import pi

import numpy as np
from scipy import fft
from scipy.interpolate import RegularGridInterpolator
from scipy.optimize.elementwise import find_root

from data.brute_force import Pose, Zones

YOUNGS_MODULUS = 210e9  # [Pa] both bodies
POISSON_RATIO = 0.28
CONTACT_MODULUS = YOUNGS_MODULUS / (2 * (1 - POISSON_RATIO**2))  # E* [Pa], Johnson eq. (4.20)

# ------------------------------------------------------------------------------------------ half-space solver


def influence_coefficients(shape, dx, ds, contact_modulus=CONTACT_MODULUS):
    """Displacement [m] i, j cells away from a rectangle dx x ds [m] that carries 1 Pa; array (n, m).

    ``u = 1/(pi E*) [F(x+a, s+b) - F(x-a, s+b) - F(x+a, s-b) + F(x-a, s-b)]``, a = dx/2, b = ds/2, where
    ``F(x, s) = x arsinh(s/|x|) + s arsinh(x/|s|)`` is the integral of 1/r over the rectangle from (0, 0) to
    (x, s): Love (1929), Johnson (1985) eq. (3.25) with the logarithms gathered.
    """
    x = (np.arange(shape[0] + 1) - 0.5)[:, None] * dx
    s = (np.arange(shape[1] + 1) - 0.5)[None, :] * ds
    F = x * np.arcsinh(s / np.abs(x)) + s * np.arcsinh(x / np.abs(s))
    return (F[1:, 1:] - F[:-1, 1:] - F[1:, :-1] + F[:-1, :-1]) / (pi * contact_modulus)


class Displacement:
    """p (n, m) -> u (n, m): discrete convolution with the influence coefficients, zero-padded
    so nothing wraps round."""

    def __init__(self, shape, dx, ds, contact_modulus=CONTACT_MODULUS):
        self.shape = shape
        self.padded = [fft.next_fast_len(2 * n - 1, real=True) for n in shape]
        cells = [np.minimum(np.arange(size), size - np.arange(size)) for size in self.padded]  # 0 1 2 ... 2 1
        reach = [cell.max() + 1 for cell in cells]
        kernel = influence_coefficients(reach, dx, ds, contact_modulus)[np.ix_(*cells)]
        self.transfer = fft.rfft2(kernel)

    def __call__(self, pressure):
        spectrum = fft.rfft2(pressure, self.padded)
        return fft.irfft2(spectrum * self.transfer, self.padded)[: self.shape[0], : self.shape[1]]


@dataclass(frozen=True)
class Solution:
    """Pressure on the grid and what a railway engineer asks of it."""

    x: np.ndarray  # cell centres (n,), (m,) [m]
    s: np.ndarray
    pressure: np.ndarray  # (n, m) [Pa]
    clearance: np.ndarray  # u + h - delta (n, m) [m], zero in contact
    penetration: float  # [m]
    iterations: int

    @property
    def cell(self):
        return (self.x[1] - self.x[0]) * (self.s[1] - self.s[0])

    @property
    def area(self):
        """Loaded area [m^2], rows along x cut where p^2 falls to zero; counting cells
        would give 0.5 % more."""
        return float(sum(loaded_cells(row) for row in self.pressure.T) * self.cell)

    @property
    def max_pressure(self):
        return float(self.pressure.max())

    @property
    def touches_border(self):
        p = self.pressure
        return bool(p[0].any() or p[-1].any() or p[:, 0].any() or p[:, -1].any())


SHORT = 8  # [cells] a run this short is counted, not fitted


def loaded_cells(row):
    """Length of the loaded runs of one row [cells]; the ends of each are where a straight
    line through p^2 meets zero.

    At the edge of a Hertzian patch p^2 falls linearly. The outermost cell is only partly loaded, so the line
    goes through the second and third cell from the end.
    """
    loaded = np.flatnonzero(row)
    runs = np.split(loaded, np.flatnonzero(np.diff(loaded) > 1) + 1)
    return sum(
        len(run) if len(run) < SHORT else len(run) - 1 + overhang(row[run]) + overhang(row[run[::-1]])
        for run in runs
    )


def overhang(run):
    """How far the load reaches beyond the centre of the first cell of a run [cells]."""
    square = run[1:3] ** 2
    return square[0] / (square[1] - square[0]) - 1


PRECISION = 1e-7  # share of the force that still moves in one iteration when the solution is accepted
ITERATIONS = 2000


def solve(x, s, gap, force, contact_modulus=CONTACT_MODULUS, guess=None):
    """Frictionless contact with prescribed force: Polonsky & Keer (1999), section 3, eqs. (5)-(17).

    Parameters
    ----------
    x, s : cell centres along and across, evenly spaced (n,), (m,) [m].
    gap : undeformed distance h (n, m) [m].
    force : N [N].
    guess : pressure to start from (n, m) [Pa]; uniform by default.
    """
    dx, ds = x[1] - x[0], s[1] - s[0]
    displacement, total = Displacement(gap.shape, dx, ds, contact_modulus), force / (dx * ds)
    p = np.ones(gap.shape) if guess is None or not guess.any() else np.maximum(guess, 0)
    p *= total / p.sum()
    direction, last_norm, conjugate = np.zeros(gap.shape), 1.0, False
    for iteration in range(ITERATIONS):
        contact = p > 0
        g = displacement(p) + gap
        delta = g[contact].mean()
        g -= delta
        norm = np.sum(g[contact] ** 2)
        direction = np.where(contact, g + conjugate * norm / last_norm * direction, 0)
        q = displacement(direction)
        q -= q[contact].mean()
        step = np.sum((g * direction)[contact]) / np.sum((q * direction)[contact])
        previous, p = p, np.maximum(p - step * direction, 0)
        overlap = (p == 0) & (g < 0)
        p[overlap] -= step * g[overlap]
        p *= total / p.sum()
        conjugate, last_norm = not overlap.any(), norm
        if conjugate and np.abs(p - previous).sum() < PRECISION * total:
            return Solution(x, s, p, g, float(delta), iteration + 1)
    raise ArithmeticError(f"no convergence in {ITERATIONS} iterations, overlapping cells: {overlap.sum()}")


# --------------------------------------------------------------------------------------------------- true gap


def without_steps(profile):
    """The same profile with the zones moved in height to meet at their joints,
    starting from the zone of y = 0.

    The rounding of the printed S1002 leaves steps of 0.04 and 0.12 um. They hardly move a rigid contact, but
    a step is an edge, and the elastic pressure at an edge grows without limit as the grid gets finer.
    """
    home, count = int(profile.zone_of(0.0)), len(profile.ends)
    lift = np.zeros(count)
    for zone in range(home - 1, -1, -1):
        lift[zone] = lift[zone + 1] + step(profile, zone)
    for zone in range(home + 1, count):
        lift[zone] = lift[zone - 1] - step(profile, zone - 1)
    return Zones(profile.ends, tuple(lifted(f, h) for f, h in zip(profile.formulas, lift)))


def step(profile, zone):
    """Height of the next zone above this one at their joint, in the table's mm."""
    joint = np.float64(profile.ends[zone][1])
    return profile.formulas[zone + 1](joint)[0] - profile.formulas[zone](joint)[0]


def lifted(formula, height):
    """``formula`` with ``height`` added [mm]."""

    def evaluate(y):
        z, *derivatives = formula(y)
        return z + height, *derivatives

    return evaluate


@dataclass(frozen=True)
class ContactPlane:
    """Tangent plane at the rigid contact of one wheel, seen as a right wheel: x along the
    track, s to the field side."""

    system: object
    pose: Pose
    origin: np.ndarray  # rigid contact point in the track frame [m]
    angle: float  # contact angle [rad]

    @property
    def lateral(self):
        """Direction of s: with the contact angle positive towards the flange, the field side lies higher."""
        return np.array([0, np.cos(self.angle), -np.sin(self.angle)])

    @property
    def normal(self):
        """Direction from the rail into the wheel."""
        return np.array([0, -np.sin(self.angle), -np.cos(self.angle)])

    def point(self, x, s, t):
        """Track coordinates (3, ...) of the point at (x, s) in the plane and t above it."""
        x, s, t = np.broadcast_arrays(x, s, t)
        return np.array(
            [
                o + x * along + s * across + t * up
                for o, along, across, up in zip(self.origin, (1, 0, 0), self.lateral, self.normal)
            ]
        )

    def rail(self, s):
        """Height of the rail surface above the plane [m]; nan where the normal misses it."""

        def above(t, s):
            _, y, z = self.point(0, s, t)
            return self.system.rail(y - self.system.rail_origin)[0] - z

        return meet(above, s)

    def wheel(self, x, s):
        """Height of the wheel surface above the plane [m]; nan where the normal misses it."""
        turn, centre = self.pose.rotation().T, self.pose.centre(self.system)

        def inside(t, x, s):
            p = self.point(x, s, t)
            qx, qy, qz = np.tensordot(turn, p - centre.reshape(3, *(1,) * t.ndim), axes=1)
            radius = self.system.nominal_radius + self.system.wheel(qy - self.system.half_distance)[0]
            return radius - np.hypot(qx, qz)

        return meet(inside, *np.broadcast_arrays(x, s))

    def gap(self, x, s):
        """Distance h of the surfaces, beyond that at the origin, at x (n,), s (m,) -> (n, m)
        [m]; FAR where none is found."""
        origin = self.wheel(0.0, 0.0) - self.rail(0.0)  # what without_steps has opened there
        distance = self.wheel(x[:, None], s[None, :]) - self.rail(s) - origin
        return np.where(np.isfinite(distance), distance, FAR)


FAR = 20e-3  # [m] gap where a normal meets no surface
DEPTH = 15e-3  # [m] how far along the normal the surfaces are sought


def meet(side, *where):
    """t at which ``side`` changes sign along the normals at ``where``."""
    found = find_root(side, (-DEPTH, DEPTH), args=where, tolerances=dict(xatol=1e-13, xrtol=1e-12))
    return np.where(found.success, found.x, np.nan)


def contact_plane(system, wheelset, side):
    """Tangent plane of the ``"left"`` or ``"right"`` wheel at the rigid equilibrium ``wheelset``."""
    pose = Pose(wheelset.lateral_shift, wheelset.yaw, wheelset.roll, wheelset.vertical_shift)
    contact = getattr(wheelset, side)
    mirror = 1 if side == "right" else -1
    origin = np.array([contact.x_track, mirror * contact.y_track, contact.z_track])
    smooth = replace(system, wheel=without_steps(system.wheel))
    return ContactPlane(smooth, pose if mirror > 0 else pose.mirrored(), origin, contact.contact_angle)


# ----------------------------------------------------------------------------------------------- patch finder

WINDOW = (60e-3, 25e-3)  # [m] half-width of the region that is looked at, along and across
COARSE = (48, 120)  # cells of the first solution
FINE = 110  # cells over the patch, each way
FINEST_WIDE = 0.08e-3  # [m] largest cell across the rail
MARGIN = 0.05  # empty border of the fine grid, in patch sizes


def normal_contact(system, wheelset, side, force, fine=FINE):
    """Contact of one wheel at the rigid pose under its normal force [N], on a grid fitted to the patch."""
    plane = contact_plane(system, wheelset, side)
    limit = 0.19e-3 * (force / 78.5e3) ** (2 / 3)
    coarse = solve_within(plane, *where_closer(plane, limit), COARSE, force)
    while coarse.penetration > limit:  # only points with h < delta can touch: the window must reach that far
        limit *= 1.5
        coarse = solve_within(plane, *where_closer(plane, limit), COARSE, force)
    low, high = around_patch(coarse)
    while True:
        cells = (fine, max(fine, int((high[1] - low[1]) / FINEST_WIDE)))
        solution = solve_within(plane, low, high, cells, force, coarse)
        if not solution.touches_border:
            return solution
        low, high = low - 0.1 * (high - low), high + 0.1 * (high - low)


def where_closer(plane, limit):
    """Corners (low, high) of the rectangle in which the gap is below ``limit`` [m],
    found by closing in on it."""
    high = np.array(WINDOW)
    low = -high
    for level in limit * 4.0 ** np.arange(max(0, np.ceil(np.log(1e-3 / limit) / np.log(4))), -1, -1):
        x, s = (np.linspace(a, b, n) for a, b, n in zip(low, high, (61, 241)))
        low, high = bounds(x, s, plane.gap(x, s) < level)
    return low, high


def bounds(x, s, chosen):
    """Rectangle (low, high) around the chosen points, one grid step wider."""
    low, high = [], []
    for axis, grid in enumerate((x, s)):
        index = np.flatnonzero(chosen.any(axis=1 - axis))
        step = grid[1] - grid[0]
        low.append(grid[index[0]] - step)
        high.append(grid[index[-1]] + step)
    return np.array(low), np.array(high)


def around_patch(solution):
    """Rectangle around all that touches or nearly touches, with a margin."""
    low, high = bounds(solution.x, solution.s, solution.clearance < 0.03 * solution.penetration)
    return low - MARGIN * (high - low), high + MARGIN * (high - low)


def solve_within(plane, low, high, cells, force, guess=None):
    """Solution on a grid of ``cells`` over a rectangle of the plane, started from a
    coarser one if there is any."""
    x, s = (a + (b - a) * (np.arange(n) + 0.5) / n for a, b, n in zip(low, high, cells))
    if guess is not None:
        look_up = RegularGridInterpolator(
            (guess.x, guess.s), guess.pressure, bounds_error=False, fill_value=0.0
        )
        guess = look_up(tuple(np.meshgrid(x, s, indexing="ij")))
    return solve(x, s, plane.gap(x, s), force, guess=guess)
