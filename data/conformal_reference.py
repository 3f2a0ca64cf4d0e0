"""Frictionless contact of a wheel that has moved straight down into its rail: the slow, independent witness
where a patch turns.

Seen along the track, rail points r are joined with the wheel along the mean n of both bodies' normals; the
middles m of the joints are the curve on which the contact is solved, by its arc length and by x along the
track. Wheel and rail are met along n from m, by root search on the surfaces themselves::

    lowered wheel -> curve m(sigma), n(sigma) -> h(x, sigma) < 0 in the overlap -> pressure

A pressure at j moves the surface at i by Love's influence K over the distances x and sigma, times the cosine
of the angle between the normals (both bodies of one material; Vollebergt, CONTACT v25.2, "conformal")::

    u_i = sum_j cos(a_i - a_j) K_ij p_j,   p >= 0,   u + h >= 0,   p (u + h) = 0

Everything is plain and done anew for every height; units m, N, Pa, rad; a left wheel is a mirrored right one.
"""

from dataclasses import dataclass, replace

import numpy as np

from data.brute_force import Pose, smallest_gap
from data.halfspace_reference import (
    ITERATIONS,
    Displacement,
    bounds,
    loaded_cells,
    meet,
    without_steps,
)

STATIONS = 60e-6  # [m] between the curve's points
RAIL_STEEPEST = np.tan(np.radians(80))  # the rail is used up to here
AHEAD = 60e-3  # [m] how far along the track the wheel is looked at
ROUNDS = 4  # of the mean normal
CLOSE = 0.25e-3  # [m] the curve reaches as far as the bodies come closer than this
COARSE, FINE = (40, 60), 110  # cells over the overlap
FINEST_WIDE = 0.08e-3  # [m] largest cell across the rail
MOST_ALONG = 5  # times as many cells along the track, where overlaps lie behind each other
PRECISION = 1e-7  # residual of the contact condition, as a share of the largest deflection
MATCHED = 3e-5  # error of the force that is looked for; less than the grid's


@dataclass(frozen=True)
class Curve:
    """Between wheel and rail: stations sigma, places y, z, angles of the normals (0, -sin a, -cos a)."""

    sigma: np.ndarray
    y: np.ndarray
    z: np.ndarray
    angle: np.ndarray

    def at(self, sigma):
        return tuple(np.interp(sigma, self.sigma, values) for values in (self.y, self.z, self.angle))


@dataclass(frozen=True)
class Lowered:
    """A right wheel at its place and the rail below it."""

    system: object
    pose: Pose

    def place(self, x, y, z, angle, t):
        """Points (3, ...) at distance t along normals from (x, y, z)."""
        return np.stack(np.broadcast_arrays(x, y - t * np.sin(angle), z - t * np.cos(angle)))

    def in_wheelset(self, p):
        centre = self.pose.centre(self.system)
        return np.tensordot(self.pose.rotation().T, p - centre.reshape(3, *(1,) * (p.ndim - 1)), axes=1)

    def wheel(self, x, y, z, angle):
        """Distance to the wheel along normals; nan without one."""

        def inside(t, x, y, z, angle):
            qx, qy, qz = self.in_wheelset(self.place(x, y, z, angle, t))
            radius = self.system.nominal_radius + self.system.wheel(qy - self.system.half_distance)[0]
            return radius - np.hypot(qx, qz)

        return meet(inside, *np.broadcast_arrays(x, y, z, angle))

    def rail(self, y, z, angle):
        """Distance to the rail along normals; nan without one."""

        def above(t, y, z, angle):
            _, py, pz = self.place(0.0, y, z, angle, t)
            return self.system.rail(py - self.system.rail_origin)[0] - pz

        return meet(above, y, z, angle)

    def wheel_angle(self, x, y, z, angle, t):
        """Angle of the wheel's normal, seen along the track, at the point met from (x, y, z)."""
        qx, qy, qz = self.in_wheelset(self.place(x, y, z, angle, t))
        slope = self.system.wheel(qy - self.system.half_distance)[1]
        r = np.hypot(qx, qz)
        _, ny, nz = np.tensordot(self.pose.rotation(), np.stack([qx / r, -slope, qz / r]), axes=1)
        return np.arctan2(ny, nz)

    def closest(self, y, z, angle, around=None):
        """Where along the track the wheel is closest to each normal, and its distance there; by parabolas
        through ever closer samples, which begin a millimetre from the places ``around`` if those are
        given."""
        x = np.linspace(-AHEAD, AHEAD, 61)[:, None]
        if around is not None:
            x = around + np.linspace(-1e-3, 1e-3, 7)[:, None]
        for _ in range(3 if around is None else 1):
            grid = np.broadcast_to(x, (len(x), len(y)))
            t = self.wheel(grid, y, z, angle)
            low = np.clip(np.argmin(np.where(np.isfinite(t), t, np.inf), axis=0), 1, len(grid) - 2)
            columns = np.arange(len(y))
            before, here, after = (t[low + k, columns] for k in (-1, 0, 1))
            step = grid[1] - grid[0]
            bend = before - 2 * here + after
            x_low = grid[low, columns] + step * np.nan_to_num(0.5 * (before - after) / bend).clip(-1, 1)
            x = x_low + np.linspace(-1, 1, 7)[:, None] * 0.3 * step
        return x_low, self.wheel(x_low, y, z, angle)

    def rail_points(self):
        """Points STATIONS apart on the rail, and the angles of its normals."""
        y = np.linspace(-45e-3, 45e-3, 180_001)
        z, slope, _ = self.system.rail(y)
        usable = np.abs(slope) < RAIL_STEEPEST
        y, z = y[usable], z[usable]
        arc = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y), np.diff(z)))])
        y = np.interp(np.arange(0.0, arc[-1], STATIONS), arc, y)
        z, slope, _ = self.system.rail(y)
        return y + self.system.rail_origin, z, -np.arctan(slope)

    def curve(self):
        """The curve between the bodies, as far as they are close."""
        y, z, angle = self.rail_points()
        few = slice(None, None, 10)
        t = self.closest(y[few], z[few], angle[few])[1]
        near = np.flatnonzero(np.where(np.isfinite(t), t, np.inf) < CLOSE)
        part = slice(10 * max(near[0] - 1, 0), 10 * (near[-1] + 2))
        y, z, angle = y[part], z[part], angle[part]
        mean, x = angle, None
        for _ in range(ROUNDS):
            x, t = self.closest(y, z, mean, x)
            facing = self.wheel_angle(x, y, z, mean, t)
            mean = np.where(np.isfinite(t), 0.5 * (angle + facing), angle)
        half = 0.5 * np.clip(np.nan_to_num(self.closest(y, z, mean, x)[1]), -CLOSE * 8, CLOSE)
        y, z = y - half * np.sin(mean), z - half * np.cos(mean)
        sigma = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y), np.diff(z)))])
        return Curve(sigma, y, z, mean)

    def gap(self, curve, x, sigma):
        """Distance of the surfaces along the curve's normals (n, m), negative in an overlap."""
        y, z, angle = curve.at(sigma)
        h = self.wheel(x[:, None], y, z, angle) - self.rail(y, z, angle)
        outside = (sigma < curve.sigma[0]) | (sigma > curve.sigma[-1])
        return np.where(np.isfinite(h) & ~outside, h, 1.0)


@dataclass(frozen=True)
class Solution:
    """Pressures on the cells (n, m), and what a railway engineer asks of them."""

    x: np.ndarray
    sigma: np.ndarray
    angle: np.ndarray
    pressure: np.ndarray
    curve: Curve = None

    @property
    def cell(self):
        return (self.x[1] - self.x[0]) * (self.sigma[1] - self.sigma[0])

    @property
    def force(self):
        return float(self.pressure.sum() * self.cell)

    @property
    def area(self):
        """Loaded area, rows along x cut where p^2 falls to zero."""
        return float(sum(loaded_cells(row) for row in self.pressure.T) * self.cell)

    @property
    def max_pressure(self):
        return float(self.pressure.max())


def solve(x, sigma, angle, gap):
    """Pressures where bodies overlap by -gap: Polonsky & Keer (1999), with the height prescribed."""
    plain = Displacement(gap.shape, x[1] - x[0], sigma[1] - sigma[0])
    cosine, sine = np.cos(angle), np.sin(angle)

    def deflection(p):
        return cosine * plain(cosine * p) + sine * plain(sine * p)

    p = np.sqrt(np.maximum(-gap, 0.0))
    p *= -np.sum(p * gap) / np.sum(p * deflection(p))
    direction, last, conjugate = np.zeros(gap.shape), 1.0, False
    for _ in range(ITERATIONS):
        contact = p > 0
        u = deflection(p)
        g = u + gap
        norm = np.sum(g[contact] ** 2)
        overlap = (p == 0) & (g < 0)
        allowed = PRECISION * u.max()
        if norm < contact.sum() * allowed**2 and not np.any(g[overlap] < -allowed):
            return Solution(x, sigma, angle, p)
        direction = np.where(contact, g + conjugate * norm / last * direction, 0)
        step = np.sum((g * direction)[contact]) / np.sum((deflection(direction) * direction)[contact])
        p = np.maximum(p - step * direction, 0)
        p[overlap] -= step * g[overlap]
        conjugate, last = not overlap.any(), norm
    raise ArithmeticError(f"no convergence in {ITERATIONS} iterations")


def lowered_contact(system, pose, cells=FINE, curve=None):
    """The contact of a right wheel at ``pose``, which overlaps its rail; ``cells`` over the overlap along x,
    and at least as many across; ``curve`` if it is known."""
    lowered = Lowered(replace(system, wheel=without_steps(system.wheel)), pose)
    curve = curve or lowered.curve()
    low, high = np.array([-AHEAD, curve.sigma[0]]), np.array([AHEAD, curve.sigma[-1]])
    for _ in range(3):
        x, sigma = (np.linspace(a, b, n) for a, b, n in zip(low, high, (121, 241)))
        h = lowered.gap(curve, x, sigma)
        # an overlap between samples along x is found by their parabolas
        low, high = bounds(x, sigma, h - 0.25 * np.abs(np.gradient(np.gradient(h, axis=0), axis=0)) < 0.0)
    # as many cells over the longest overlap along x, where a yawed wheel has several behind each other
    longest = (h < 0.0).sum(axis=0).max() * (x[1] - x[0])
    along = int(cells * min((high[0] - low[0]) / longest, MOST_ALONG))
    counts = (along, max(cells, int((high[1] - low[1]) / FINEST_WIDE))) if cells > COARSE[0] else COARSE
    x, sigma = (a + (b - a) * (np.arange(n) + 0.5) / n for a, b, n in zip(low, high, counts))
    return replace(solve(x, sigma, curve.at(sigma)[2], lowered.gap(curve, x, sigma)), curve=curve)


@dataclass(frozen=True)
class Sunk:
    """The contact of a wheel that has come down from rigid contact until it carries its force."""

    penetration: float  # sinking times the cosine of the rigid contact angle [m]
    solution: Solution

    @property
    def area(self):
        return self.solution.area

    @property
    def max_pressure(self):
        return self.solution.max_pressure


def sunk_contact(system, wheelset, side, force, guess=None, cells=FINE):
    """Contact of one wheel that carries its normal force [N], by how far it has sunk since it touched;
    ``guess`` is a penetration [m] to start from.

    A wheel without the steps of its profile touches a little later or sooner, by up to 0.12 micrometres.
    """
    pose = Pose(wheelset.lateral_shift, wheelset.yaw, wheelset.roll, wheelset.vertical_shift)
    pose = pose if side == "right" else pose.mirrored()
    steep = np.cos(getattr(wheelset, side).contact_angle)
    sunk = (guess or 80e-6 * (force / 78.5e3) ** (2 / 3)) / steep
    power = 1.5
    for count in (COARSE[0], cells):
        done, curve = None, None
        for _ in range(20):
            lowered = replace(pose, vertical_shift=pose.vertical_shift + sunk)
            found = lowered_contact(system, lowered, count, curve)
            if done is not None and abs(sunk / done[0] - 1.0) > 1e-9:
                power = float(np.clip(np.log(found.force / done[1]) / np.log(sunk / done[0]), 1.0, 3.0))
            done = sunk, found.force
            if abs(found.force / force - 1.0) < (1e-2 if count < cells else MATCHED):
                break
            sunk *= np.clip((force / found.force) ** (1.0 / power), 0.5, 2.0)
            # moved by a per cent, the wheel has the same curve
            curve = found.curve if abs(found.force / force - 1.0) < 0.02 else None
    return Sunk(float((done[0] - remaining_gap(system, pose)) * steep), found)


def remaining_gap(system, pose):
    """How far a right wheel without the steps of its profile is above its rail at ``pose`` [m]."""
    return float(smallest_gap(replace(system, wheel=without_steps(system.wheel)), pose)[0])
