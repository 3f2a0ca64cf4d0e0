"""The zones by which standards define profiles: polynomials and circular arcs, in millimetres as printed.

``zone(y)`` returns height z [mm] (positive down), slope dz/dy [1] and second derivative [1/mm] at y [mm],
arrays of y's shape.
"""

import math
from dataclasses import dataclass, replace

import numpy as np


@dataclass(frozen=True)
class Polynomial:
    """z = sum c_k (y - origin)^k between ``start`` and ``stop`` [mm]."""

    start: float
    stop: float
    coefficients: tuple
    origin: float = 0.0

    def __call__(self, y):
        if isinstance(y, float):
            return self._at(float(y) - self.origin)
        u = np.asarray(y, dtype=float) - self.origin
        c = np.asarray(self.coefficients, dtype=float)
        first = c[1:] * np.arange(1, len(c))
        second = first[1:] * np.arange(1, len(first))
        return tuple(
            np.polyval(part[::-1], u) if len(part) else np.zeros_like(u) for part in (c, first, second)
        )

    def _at(self, u):
        """The same bits for one place, in a twentieth of the time: joints are many."""
        value = slope = bend = 0.0
        for k in range(len(self.coefficients) - 1, -1, -1):
            c = self.coefficients[k]
            value = value * u + c
            if k > 0:
                slope = slope * u + c * k
            if k > 1:
                bend = bend * u + c * k * (k - 1)
        return value, slope, bend


class Chain:
    """Polynomials in a row, evaluated together, with the bits of each one by itself; where two of them
    meet, the later one counts."""

    def __init__(self, zones):
        self.start, self.stop, self.origin = np.array([(z.start, z.stop, z.origin) for z in zones]).T
        most = max(3, max(len(zone.coefficients) for zone in zones))
        c = np.array([(*zone.coefficients, *[0.0] * (most - len(zone.coefficients))) for zone in zones])
        first = c[:, 1:] * np.arange(1, c.shape[1])
        second = first[:, 1:] * np.arange(1, first.shape[1])
        self.parts = c, first, second

    @classmethod
    def of(cls, zones):
        """The chain of these ``zones``, by rising y; None if one is no polynomial."""
        return cls(zones) if all(type(zone) is Polynomial for zone in zones) else None

    def __call__(self, y):
        """Height, slope and second derivative at ``y`` [mm] between both ends, (3,) and y's shape; NaN in
        a hole."""
        at = np.maximum(np.searchsorted(self.start, y, side="right") - 1, 0)
        u, found = y - self.origin[at], np.zeros((3, *np.shape(y)))
        for k, part in enumerate(self.parts):
            for coefficients in part.T[::-1]:
                found[k] = found[k] * u + coefficients[at]
        found[:, ~(y <= self.stop[at])] = np.nan
        return found


@dataclass(frozen=True)
class Arc:
    """Part of the circle around (y_centre, z_centre); ``side`` +1 is its lower half (larger z), -1 its upper
    half.

    z = z_centre + side * sqrt(radius^2 - (y - y_centre)^2)
    """

    start: float
    stop: float
    radius: float
    y_centre: float
    z_centre: float
    side: int

    def __call__(self, y):
        u = np.asarray(y, dtype=float) - self.y_centre
        root = np.sqrt(np.maximum(self.radius * self.radius - u * u, 0.0))
        with np.errstate(divide="ignore"):
            return (
                self.z_centre + self.side * root,
                -self.side * u / root,
                -self.side * (self.radius * self.radius) / (root * root * root),
            )


@dataclass(frozen=True)
class Moved:
    """``zone`` rotated by ``angle`` [rad] from y to z about the origin of its frame, then shifted by
    (y_shift, z_shift) [mm].

    The moved curve is a function of its own abscissa y: the zone's parameter t with
    t cos(angle) - z(t) sin(angle) + y_shift = y is found by Newton's method.
    """

    zone: object
    angle: float
    y_shift: float = 0.0
    z_shift: float = 0.0

    @property
    def start(self):
        return self.place(self.zone.start)[0]

    @property
    def stop(self):
        return self.place(self.zone.stop)[0]

    def place(self, t):
        """Point (y, z) [mm] of the moved curve at the zone's parameter ``t`` [mm]."""
        z = float(self.zone(t)[0])
        c, s = math.cos(self.angle), math.sin(self.angle)
        return c * t - s * z + self.y_shift, s * t + c * z + self.z_shift

    def __call__(self, y):
        y = np.asarray(y, dtype=float) - self.y_shift
        c, s = math.cos(self.angle), math.sin(self.angle)
        t = np.clip(c * y, self.zone.start, self.zone.stop)
        for _ in range(60):
            z, slope, _ = self.zone(t)
            step = (c * t - s * z - y) / (c - s * slope)
            t = np.clip(t - step, self.zone.start, self.zone.stop)
            if np.all(np.abs(step) <= 1e-15 * (1 + np.abs(y))):
                break
        z, slope, bend = self.zone(t)
        stretch = c - s * slope
        return s * t + c * z + self.z_shift, (s + c * slope) / stretch, bend / (stretch * stretch * stretch)


def mirror_zone(zone):
    """``zone`` reflected in y = 0."""
    if isinstance(zone, Arc):
        return Arc(-zone.stop, -zone.start, zone.radius, -zone.y_centre, zone.z_centre, zone.side)
    flipped = tuple(c * (-1) ** k for k, c in enumerate(zone.coefficients))
    return Polynomial(-zone.stop, -zone.start, flipped, -zone.origin)


def lifted(zone, by):
    """``zone`` moved down by ``by`` [mm]."""
    if isinstance(zone, Arc):
        return replace(zone, z_centre=zone.z_centre + by)
    if isinstance(zone, Moved):
        return replace(zone, z_shift=zone.z_shift + by)
    first, *others = zone.coefficients
    return replace(zone, coefficients=(first + by, *others))


def moved_across(zone, by):
    """``zone``, an Arc or a Polynomial, moved by ``by`` [mm] along y."""
    start, stop = zone.start + by, zone.stop + by
    if isinstance(zone, Arc):
        return replace(zone, start=start, stop=stop, y_centre=zone.y_centre + by)
    return replace(zone, start=start, stop=stop, origin=zone.origin + by)


def joined(zones, least, most):
    """The ``zones`` without steps in height between ``least`` and ``most`` [mm], and the steps that they had:
    what lies outside of such a step, seen from y = 0, is moved to meet what lies inside."""
    middle = min(range(len(zones)), key=lambda i: max(zones[i].start, -zones[i].stop, 0.0))
    found, steps = list(zones), []
    for order in (range(middle + 1, len(zones)), range(middle - 1, -1, -1)):
        shift = 0.0
        for i in order:
            inner = zones[i - 1] if i > middle else zones[i + 1]
            joint = max(zones[i].start, inner.start)
            step = float(inner(joint)[0]) - float(zones[i](joint)[0])
            if least < abs(step) <= most:
                steps.append(step)
                shift += step
            if shift:
                found[i] = lifted(zones[i], shift)
    return tuple(found), steps
