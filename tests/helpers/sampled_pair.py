"""The smallest gap of a wheel over its rail by sampling alone: a witness for profiles with corners and with
very short zones.

Each zone becomes a row of points, so close that straight lines between them are within FLAT of it; a rail is
turned and placed point by point. Corners are rounded as docs/theory/surfaces.md says. Nothing is known of
where a contact can lie, and no code is the product's. Without yaw the outline of a wheel is its profile; with
yaw every circle of the wheel is searched.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

MM = 1e-3  # [m]
FLAT = 1e-9  # [mm]
LONGEST = 1e-2  # [mm] between two points
MOST = 20000  # points of a zone
STEEPEST = np.radians(80.0)  # profiles are read up to here
#: [m] The wheel is looked at with these steps, where a gap may be below the smallest one seen: a minimum
#: between two points is no more than so much below both. A corner of 0.2 rad, or a bend of 2e5 1/m, hides
#: 2.5 um between points 10 um apart.
SCREENS = (1e-5, 3e-6), (2e-7, 5e-8), (5e-9, 0.0)
#: A corner turns by more than this [rad]; it is rounded over this [mm] on either side, or more for a radius
#: of about RADIUS [mm].
CORNER, WIDTH, RADIUS = 1e-8, 0.05, 1.0


def jet(zone, t):
    """Height [mm], slope and second derivative [1/mm] of a zone, by its formula."""
    if hasattr(zone, "radius"):
        u = t - zone.y_centre
        root = np.sqrt(zone.radius**2 - u**2)
        return (
            zone.z_centre + zone.side * root,
            -zone.side * u / root,
            -zone.side * zone.radius**2 / root**3,
        )
    u = t - zone.origin
    z = slope = bend = 0.0 * u
    for c in reversed(zone.coefficients):
        bend = bend * u + 2.0 * slope
        slope = slope * u + z
        z = z * u + c
    return z, slope, bend


def even(low, high, bend):
    """Abscissae from ``low`` to ``high``, both included, for a curve with second derivatives up to
    ``bend``."""
    step = min(LONGEST, np.sqrt(8.0 * FLAT / max(bend, 1e-12)))
    return np.linspace(low, high, min(int((high - low) / step) + 2, MOST))


@dataclass(frozen=True)
class Turned:
    """A zone that is turned by ``angle`` [rad] about the origin of its frame."""

    zone: object
    angle: float

    def points(self, steepest=STEEPEST):
        """Points (2, n) [mm] along it, where it is less steep than ``steepest`` [rad]."""
        zone = self.zone
        if hasattr(zone, "radius"):
            ends = np.clip((np.array([zone.start, zone.stop]) - zone.y_centre) / zone.radius, -1.0, 1.0)
            tilt = -zone.side * self.angle
            low, high = np.arcsin(ends)
            low, high = max(low, -steepest - tilt), min(high, steepest - tilt)
            if not low < high:
                return np.zeros((2, 0))
            along = even(low * zone.radius, high * zone.radius, 1.0 / zone.radius) / zone.radius
            t = zone.y_centre + zone.radius * np.sin(along)
            z = zone.z_centre + zone.side * zone.radius * np.cos(along)
        else:
            seen = np.linspace(zone.start, zone.stop, 65)
            t = even(zone.start, zone.stop, np.abs(jet(zone, seen)[2]).max())
            z, slope, _ = jet(zone, t)
            if self.angle and np.abs(np.arctan(slope[[0, -1]]) + self.angle).max() > steepest:
                return np.zeros((2, 0))
        return self.place(t, z)

    def place(self, t, z):
        c, s = np.cos(self.angle), np.sin(self.angle)
        return np.array([c * t - s * z, s * t + c * z])

    def jet(self, x):
        """Height, slope and second derivative at an abscissa [mm] of the turned frame."""
        c, s = np.cos(self.angle), np.sin(self.angle)
        t = min(max(c * x, self.zone.start), self.zone.stop)
        for _ in range(50):
            z, slope, bend = jet(self.zone, t)
            step = (c * t - s * z - x) / (c - s * slope)
            t = min(max(t - step, self.zone.start), self.zone.stop)
            if abs(step) < 1e-15:
                break
        z, slope, bend = jet(self.zone, t)
        return s * t + c * z, (s + c * slope) / (c - s * slope), bend / (c - s * slope) ** 3


def hermite(low, high, first, last):
    """The quintic on [low, high] with these heights, slopes and second derivatives at both ends, as a
    polynomial of y - low."""
    h = high - low
    rows = [
        [
            np.prod(np.arange(k - d + 1, k + 1), dtype=float) * h ** (k - d) if k >= d else 0.0
            for k in range(6)
        ]
        for d in range(3)
    ]
    known = np.array([first[0], first[1], 0.5 * first[2]])
    right = np.array(last) - np.array(rows)[:, :3] @ known
    return np.polynomial.Polynomial([*known, *np.linalg.solve(np.array(rows)[:, 3:], right)])


def corner_piece(before, after, x, room):
    """The points (2, n) [mm] that round the corner between two turned zones at ``x``, with zones as long as
    ``room`` on either side; None where there is none."""
    one, other = before.jet(x)[1], after.jet(x)[1]
    turn = abs(np.arctan(other) - np.arctan(one))
    if turn <= CORNER:
        return None
    width = min(
        max(WIDTH, 0.5 * RADIUS * turn / np.sqrt(1.0 + min(one**2, other**2))), 0.25 * room[0], 0.25 * room[1]
    )
    piece = hermite(x - width, x + width, before.jet(x - width), after.jet(x + width))
    u = np.linspace(0.0, 2.0 * width, 400)
    return np.array([x - width + u, piece(u)])


def outline(zones, angle=0.0, corners=True):
    """Points (2, n) [mm] of a profile that is turned by ``angle`` [rad], around y = 0."""
    turned = [Turned(zone, angle) for zone in zones]
    rows = [zone.points() for zone in turned]
    first = last = next(k for k, (x, _) in enumerate(rows) if len(x) and x[0] <= 0.0 <= x[-1])
    while first > 0 and rows[first - 1].size and abs(rows[first - 1][0, -1] - rows[first][0, 0]) < 1e-9:
        first -= 1
    while (
        last + 1 < len(rows) and rows[last + 1].size and abs(rows[last][0, -1] - rows[last + 1][0, 0]) < 1e-9
    ):
        last += 1
    found = rows[first : last + 1]
    room = [row[0, -1] - row[0, 0] for row in found]
    parts = [found[0]]
    for k in range(1, len(found)):
        piece = None
        if corners:
            piece = corner_piece(
                turned[first + k - 1], turned[first + k], found[k][0, 0], room[k - 1 : k + 1]
            )
        if piece is None:
            parts.append(found[k])
            continue
        parts[-1] = parts[-1][:, parts[-1][0] < piece[0, 0]]
        parts += [piece, found[k][:, found[k][0] > piece[0, -1]]]
    return np.concatenate(parts, axis=1)


@dataclass(frozen=True)
class SampledPair:
    """A wheel on its rail, given by the zones of both profiles [mm]; a right one."""

    wheel: tuple
    rail: tuple
    inclination: float = 1 / 40
    gauge: float = 1.435
    gauge_depth: float = 0.014
    radius: float = 0.46
    arm: float = 0.75

    @cached_property
    def wheel_points(self):
        return outline(self.wheel) * MM

    @cached_property
    def rail_points(self):
        """Points (2, n) [m] of the placed rail: lateral and downward coordinate in the track."""
        angle = -np.arctan(self.inclination)
        sharp = np.concatenate(
            [part for part in (Turned(zone, angle).points(np.pi) for zone in self.rail) if part.size], axis=1
        )
        top = np.argmin(sharp[1])
        inner = slice(top, None, -1)
        depth = sharp[1, inner] - sharp[1, top] - self.gauge_depth / MM
        k = np.argmax(depth >= 0.0)
        share = depth[k - 1] / (depth[k - 1] - depth[k])
        x = sharp[0, inner]
        face = x[k - 1] + share * (x[k] - x[k - 1])
        # the rail is cut around its highest point
        points = outline(self.rail, angle) - sharp[:, [top]]
        return points * MM + [[0.5 * self.gauge + (sharp[0, top] - face) * MM], [0.0]]

    def gaps(self, points, shift, roll):
        """Gap [m] of wheel points (2, n) at roll without yaw; NaN beside the rail."""
        y, z = points
        c, s = np.cos(roll), np.sin(roll)
        across = shift + c * (self.arm + y) - s * (self.radius + z)
        down = s * (self.arm + y) + c * (self.radius + z) - self.radius
        return np.interp(across, *self.rail_points, left=np.nan, right=np.nan) - down

    def smallest(self, shift, roll):
        """Smallest gap [m] of the right wheel without yaw, and its wheel abscissa [m]."""
        y, z = self.wheel_points
        low, high = y[:1], y[-1:]
        for step, hidden in SCREENS:
            count = int(np.max(high - low) / step) + 2
            seen = low + (high - low) * np.linspace(0.0, 1.0, count)[:, None]
            gaps = self.gaps(np.array([seen, np.interp(seen, y, z)]), shift, roll)
            near = np.nonzero(np.fmin(gaps[:-1], gaps[1:]) < np.nanmin(gaps) + hidden)
            low, high = seen[:-1][near], seen[1:][near]
        best = np.nanargmin(gaps)
        return gaps.flat[best], seen.flat[best]
