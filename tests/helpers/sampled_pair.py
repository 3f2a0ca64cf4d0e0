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
#: A corner turns by more than this [rad], or this beside a step in height of more than STEP [mm]; it is
#: rounded over WIDTH [mm] on either side, or more for a radius of about RADIUS [mm].
CORNER, STEPPED, WIDTH, RADIUS = 1e-8, 1e-5, 0.05, 1.0
#: Steps in height are led over this [mm] on either side, or twice a corner's width.
STEP, REPAIR = 1e-6, 0.5
#: Ends of zones this close meet [mm]: steps in height part those of a rail that is turned.
MEETING = 1e-4
ROLLS = 0.1  # [rad] rolls are permitted up to here
JUMP = 1e-9  # [m] gaps that differ by more where no roll is left between jump there
AT_END = 3e-6  # [m] a place this close to the end of a profile is on it
PIECE = 400  # points of a piece that joins two zones


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
            if np.abs(np.arctan(slope[[0, -1]]) + self.angle).max() > steepest:
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


def sampled(low, high, first, last):
    """Points (2, PIECE) [mm] of ``hermite``."""
    u = np.linspace(0.0, high - low, PIECE)
    return np.array([low + u, hermite(low, high, first, last)(u)])


def raised(values, height):
    """Height, slope and second derivative with another height."""
    return values[0] + height, values[1], values[2]


def joining(before, after, x, room):
    """The points (2, n) [mm] that join two turned zones at ``x``, which are as long as ``room``: where there
    is a corner or a step in height. None where they just meet."""
    one, other = before.jet(x), after.jet(x)
    turn, step = abs(np.arctan(other[1]) - np.arctan(one[1])), other[0] - one[0]
    stepped = abs(step) > STEP
    width = 0.0
    if turn > (STEPPED if stepped else CORNER):
        steep = min(abs(one[1]), abs(other[1]))
        width = max(WIDTH, 0.5 * RADIUS * turn / np.hypot(1.0, steep))
        width = min(width, 0.25 * room[0], 0.25 * room[1])
    if not stepped:
        return sampled(x - width, x + width, before.jet(x - width), after.jet(x + width)) if width else None
    reach = [min(max(REPAIR, 2.0 * width), 0.5 * length) for length in room]
    first, last = x - reach[0], x + reach[1]
    if not width:
        middle = 0.5 * (np.array(one) + other)
        parts = [
            sampled(first, x, before.jet(first), middle),
            sampled(x, last, middle, after.jet(last)),
        ]
        return np.concatenate(parts, axis=1)
    low = raised(before.jet(x - width), 0.5 * step)
    high = raised(after.jet(x + width), -0.5 * step)
    parts = [
        sampled(first, x - width, before.jet(first), low),
        sampled(x - width, x + width, low, high),
        sampled(x + width, last, high, after.jet(last)),
    ]
    return np.concatenate(parts, axis=1)


def outline(zones, angle=0.0, steepest=STEEPEST):
    """Points (2, n) [mm] of a profile that is turned by ``angle`` [rad], around y = 0, without zones that are
    steeper than ``steepest`` [rad]."""
    turned = [Turned(zone, angle) for zone in zones]
    rows = [zone.points(steepest) for zone in turned]
    first = last = next(k for k, (x, _) in enumerate(rows) if len(x) and x[0] <= 0.0 <= x[-1])
    while first > 0 and rows[first - 1].size and abs(rows[first - 1][0, -1] - rows[first][0, 0]) < MEETING:
        first -= 1
    while (
        last + 1 < len(rows)
        and rows[last + 1].size
        and abs(rows[last][0, -1] - rows[last + 1][0, 0]) < MEETING
    ):
        last += 1
    found = rows[first : last + 1]
    room = [row[0, -1] - row[0, 0] for row in found]
    parts = [found[0]]
    for k in range(1, len(found)):
        one, other = turned[first + k - 1 : first + k + 1]
        piece = joining(one, other, found[k][0, 0], room[k - 1 : k + 1])
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
        return outline(self.wheel, steepest=0.5 * np.pi) * MM

    @cached_property
    def rail_points(self):
        """Points (2, n) [m] of the placed rail: lateral and downward coordinate in the track."""
        angle = -np.arctan(self.inclination)
        rows = [Turned(zone, angle).points(np.pi) for zone in self.rail]
        sharp = np.concatenate([row for row in rows if row.size], axis=1)
        # where the height steps the later zone counts
        counts = np.concatenate([row[0] < row[0, -1] - 3.0 * LONGEST for row in rows if row.size])
        counts |= np.concatenate([row[0] == row[0, 0] for row in rows if row.size])
        top = np.argmin(np.where(counts, sharp[1], np.inf))
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
        """Smallest gap [m] of the right wheel without yaw, its wheel abscissa [m], and a zero, the angle
        around the wheel."""
        y, z = self.wheel_points
        low, high = y[:1], y[-1:]
        for step, hidden in SCREENS:
            count = int(np.max(high - low) / step) + 2
            seen = low + (high - low) * np.linspace(0.0, 1.0, count)[:, None]
            gaps = self.gaps(np.array([seen, np.interp(seen, y, z)]), shift, roll)
            near = np.nonzero(np.fmin(gaps[:-1], gaps[1:]) < np.nanmin(gaps) + hidden)
            low, high = seen[:-1][near], seen[1:][near]
        best = np.nanargmin(gaps)
        return gaps.flat[best], seen.flat[best], 0.0

    def on_surface(self, y, around, shift, roll, yaw):
        """Lateral and downward track coordinate [m] of points of the wheel's surface: at abscissae ``y`` [m]
        and angles ``around`` it [rad]."""
        r = self.radius + np.interp(y, *self.wheel_points)
        s, c = np.sin(roll), np.cos(roll)
        lateral = (self.arm + y) * c - r * np.cos(around) * s
        across = shift + np.sin(yaw) * r * np.sin(around) + np.cos(yaw) * lateral
        return across, (self.arm + y) * s + r * np.cos(around) * c - self.radius

    def surface_gaps(self, y, around, shift, roll, yaw):
        """Gap [m] of points of the wheel's surface; infinite beside the rail."""
        across, down = self.on_surface(y, around, shift, roll, yaw)
        return np.interp(across, *self.rail_points, left=np.inf, right=np.inf) - down

    def smallest_yawed(self, shift, roll, yaw, places=()):
        """Smallest gap [m] of the yawed right wheel, and its abscissa [m] and angle [rad]: on a raster over
        its surface, refined around the lowest places and around these ``places`` (abscissa, angle)."""
        y = np.linspace(*self.wheel_points[0, [0, -1]], 2001)
        around = np.linspace(-0.16, 0.16, 161)
        gaps = self.surface_gaps(y[:, None], around, shift, roll, yaw)
        lowest = gaps.min(axis=1)
        turns = (lowest <= np.roll(lowest, 1)) & (lowest <= np.roll(lowest, -1))
        near = np.flatnonzero(turns & (lowest < lowest.min() + 60e-6))
        starts = [(y[k], around[gaps[k].argmin()], 1.5 * (y[1] - y[0]), 3e-3) for k in near]
        starts += [(*place, 1e-6, 1e-4) for place in places]
        return min(self.refined(*start, shift, roll, yaw) for start in starts)

    def refined(self, at, angle, reach, turn, shift, roll, yaw):
        """The smallest gap [m] beside a place of the wheel's surface, its abscissa and angle, by finer and
        finer rasters.

        Many arguments because a place has two coordinates and two reaches, and a pose three.
        """
        share, found = np.linspace(-1.0, 1.0, 31), (np.inf, at, angle)
        for _ in range(14):
            y = np.clip(found[1] + reach * share, *self.wheel_points[0, [0, -1]])
            around = found[2] + turn * share
            gaps = self.surface_gaps(y[:, None], around, shift, roll, yaw)
            i, k = np.unravel_index(gaps.argmin(), gaps.shape)
            found = min(found, (gaps[i, k], y[i], around[k]))
            reach, turn = 0.35 * reach, 0.35 * turn
        return found

    def touches_end(self, shift, yaw):
        """Whether a wheelset of two such pairs rests on the end of a profile, or on nothing within the
        permitted rolls."""
        found = self.smallest_yawed if yaw else lambda shift, roll, yaw: self.smallest(shift, roll)
        low, high = -ROLLS, ROLLS
        for _ in range(40):
            roll = 0.5 * (low + high)
            right, left = found(shift, roll, yaw), found(-shift, -roll, -yaw)
            if not np.isfinite(right[0] + left[0]):
                return True
            low, high = (roll, high) if right[0] > left[0] else (low, roll)
        if abs(right[0] - left[0]) > JUMP:
            return True
        for sign, (_, y, around) in ((1.0, right), (-1.0, left)):
            across, _ = self.on_surface(y, around, sign * shift, sign * roll, sign * yaw)
            ends = [y - self.wheel_points[0, [0, -1]], across - self.rail_points[0, [0, -1]]]
            if np.abs(ends).min() < AT_END:
                return True
        return False
