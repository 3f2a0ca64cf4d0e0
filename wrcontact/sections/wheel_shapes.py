"""How far wheels are out of round: the deviation d(theta, y) of their radius over the angle theta around the wheel and its
abscissa y.

``slices(profile, radius)`` of a shape returns rising angles (n,) [rad], abscissae of lines (k,) [m], and there d [m], d_y [-] and
d_yy [1/m], each (n, k), of a wheel with this round ``profile`` and nominal ``radius`` [m].  Beyond the first and the last angle d does
not change.
"""

import math
from dataclasses import dataclass

import numpy as np

#: Slices reach from half a turn back to half a turn ahead, and so far beyond, since a wheel touches before or behind its lowest
#: point [rad].
BEYOND = 0.4
END = math.pi + BEYOND
#: Slices for each wave of a polygon, each turn of an eccentric wheel, over a flat, and over each of its edges.
WAVE, TURN, FLAT, EDGE = 120, 360, 321, 33
#: Distance of lines where a deviation hardly follows the profile, at a flat, and where it is that of sections [m].
APART, FLAT_APART, FINE = 8e-3, 2e-3, 5e-4
#: Slices of a flat reach so far past its edges, as a share of its half-length or of the width of an edge [-].
PAST = 1.5
#: Radius at the edges of a fresh flat [m]; it stands 0.14 times this radius, times the square of the half-angle, too low.
EDGE_RADIUS = 2e-4


def all_around(count):
    """At least ``count`` angles for each turn [rad]."""
    return np.linspace(-END, END, 1 + math.ceil(count * END / math.pi))


def lines(profile, apart):
    """Abscissae that are ``apart`` or less, from one end of the ``profile`` to the other [m]."""
    return np.linspace(profile.start, profile.stop, 2 + int((profile.stop - profile.start) / apart))


def alike(theta, d, profile):
    """The slices of a wheel whose deviation ``d`` (n,) is the same at all abscissae."""
    flat = np.zeros((len(theta), 2))
    return theta, np.array([profile.start, profile.stop]), d[:, None] + flat, flat, flat


@dataclass(frozen=True)
class Polygon:
    """d = amplitude cos(order (theta - phase))."""

    order: int
    amplitude: float
    phase: float

    def slices(self, profile, radius):
        theta = all_around(WAVE * self.order)
        return alike(theta, self.amplitude * np.cos(self.order * (theta - self.phase)), profile)


@dataclass(frozen=True)
class Eccentric:
    """Every circle of the wheel, of radius R, turns about a point that lies ``offset`` e beside its centre:
    R + d = e cos(theta) + sqrt(R^2 - e^2 sin^2(theta))."""

    offset: float

    def slices(self, profile, radius):
        theta = all_around(TURN)[:, None]
        y = lines(profile, APART)
        z, slope, bend = profile.evaluate(y)
        r, across = radius + z, self.offset * np.sin(theta)
        root = np.sqrt(r**2 - across**2)
        rate = r / root - 1.0
        d = self.offset * np.cos(theta) + root - r
        return theta[:, 0], y, d, rate * slope, rate * bend - across**2 / root**3 * slope**2


@dataclass(frozen=True)
class Flat:
    """A flat of this ``length`` L about theta = 0, as deep as a chord, D = R - sqrt(R^2 - L^2 / 4).

    A fresh one is the chord, d = -R T P(g / T) with g = cos(L / 2 R) / cos(theta) - 1, whose edges are rounded by
    P(x) = 3/16 - x / 2 + 3/8 x^2 - x^4 / 16 where g is within +-T; a rounded one is d = -D (1 + cos(2 pi theta R / L)) / 2.
    """

    length: float
    rounded: bool
    edge_radius: float

    def slices(self, profile, radius):
        chord = 0.5 * self.length / radius
        depth = radius * (1.0 - math.sqrt(1.0 - chord**2))
        if self.rounded:
            theta = PAST * chord * np.linspace(-1.0, 1.0, FLAT)
            inside = np.minimum(np.abs(theta) / chord, 1.0)
            return alike(theta, -0.5 * depth * (1.0 + np.cos(math.pi * inside)), profile)
        half = math.asin(chord)
        steep = math.tan(half)
        width = 0.75 * steep * self.edge_radius / radius
        edge = half + PAST * width * np.linspace(-1.0, 1.0, EDGE)
        theta = np.concatenate([-edge[::-1], np.linspace(-edge[0], edge[0], FLAT)[1:-1], edge])
        x = np.clip((math.cos(half) / np.cos(theta) - 1.0) / (width * steep), None, 1.0)
        near = np.maximum(x, -1.0)
        share = (
            -width
            * steep
            * np.where(x < -1.0, -x, 3.0 / 16.0 - 0.5 * near + 0.375 * near**2 - near**4 / 16.0)
        )
        y = lines(profile, FLAT_APART)
        z, slope, bend = profile.evaluate(y)
        return theta, y, *(share[:, None] * part for part in (radius + z, slope, bend))


@dataclass(frozen=True)
class Slices:
    """Sections at ``angles`` (n,), each a Profile."""

    angles: tuple
    profiles: tuple

    def slices(self, profile, radius):
        y = lines(profile, FINE)
        parts = [np.stack(one.evaluate(np.clip(y, one.start, one.stop))) for one in self.profiles]
        d, slope, bend = np.moveaxis(np.stack(parts) - np.stack(profile.evaluate(y)), 1, 0)
        return np.array(self.angles), y, d, slope, bend
