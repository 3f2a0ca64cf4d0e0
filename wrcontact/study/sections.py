"""What the source feeds to ANALYN, its chapter 6: separations and curvatures along wheel and rail, without
yaw; and ANALYN as the source writes it.

A right wheel and its rail are two curves that touch. From the contact point, nodes are laid along both, and
what lies between two nodes of a pair is the separation::

    same y             vertical distance                                Section.vertical
    same arc length    distance of the pair                             Section.equidistant (arcs, or chords)
    same station       distance along the contact normal, as the kernel Section.normal

Plain numpy on the profiles' own formulas: nothing of the kernel but the rigid pose and the table of elliptic
integrals.

ANALYN is source eqs. (2.19)-(2.26): one lateral curvature for everything, nodes at fixed distances, one
patch. With E* of its eq. (2.9) the factor of eq. (2.25) must be 2 E*/pi; with
E*/(2 pi), as printed, the pressure carries a quarter of the force. Where B <= 0 the formulas have no
value: such nodes drop out of the patch.

>>> import numpy as np
>>> from wrcontact.study.sections import solve_analyn
>>> y = np.linspace(-0.01, 0.01, 801)
>>> A, B = np.full_like(y, 1.0), np.full_like(y, 1.0)
>>> patch = solve_analyn(y, B * y**2, A, B, force=1e4, modulus=1.139e11)
>>> round(patch.penetration * 1e6, 2)           # Hertz: (9 F^2 / 16 R E*^2)^(1/3) with R = 0.5 m
20.54
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicHermiteSpline, CubicSpline
from scipy.optimize import brentq

from ..halfspace.hertz import coefficients
from ..profiles.placement import place_rail, readable_wheel

#: Points of a profile between which abscissae are interpolated, 0.01 mm apart on a rail head,
#: before Newton's method.
DENSE = 8001
NEWTON_STEPS = 4


class Curve:
    """A profile on the track: ``point(t)`` at the profile's abscissa t [m], from the
    contact point at ``origin``.

    Axes as in the track frame, y to the field side and z down; ``angle`` [rad] turns from y to z.
    """

    def __init__(self, profile, origin, angle=0.0):
        self.profile, self.origin, self.angle = profile, origin, angle
        self.ends = np.nextafter((profile.start, profile.stop), (profile.stop, profile.start))
        self._top = profile.height(origin)
        t = np.unique(np.append(np.linspace(*self.ends, DENSE), origin))
        self._t, self._points = t, self.point(t)
        self._arc = self._arc_lengths(t)

    def point(self, t):
        """Coordinates y, z [m] relative to the contact point, (2, ...)."""
        c, s = math.cos(self.angle), math.sin(self.angle)
        y, z = t - self.origin, self.profile.height(t) - self._top
        return np.array([c * y - s * z, s * y + c * z])

    def direction(self, t):
        """Inclination of the tangent [rad], from y to z."""
        return np.arctan(self.profile.slope(t)) + self.angle

    def curvature(self, t):
        """d(inclination) / d(arc length) [1/m], from the profile's second derivative."""
        return self.profile.curvature(t)

    def _arc_lengths(self, t):
        """Arc length from the contact point [m] at ``t``, by Simpson's rule."""
        speed = [np.hypot(1.0, self.profile.slope(place)) for place in (t[:-1], (t[:-1] + t[1:]) / 2, t[1:])]
        pieces = np.diff(t) * (speed[0] + 4 * speed[1] + speed[2]) / 6
        lengths = np.concatenate([[0.0], np.cumsum(pieces)])
        return lengths - lengths[np.searchsorted(t, self.origin)]

    def at_arc(self, s):
        """Abscissa [m] at arc length ``s`` (n,) [m]; NaN beyond the profile."""
        slope = 1 / np.hypot(1.0, self.profile.slope(self._t))
        return CubicHermiteSpline(self._arc, self._t, slope, extrapolate=False)(s)

    def at_distance(self, direction, distance):
        """Abscissa [m] at ``distance`` (n,) [m] from the contact point along the unit vector
        ``direction``; NaN beyond.

        Where the curve comes back (steeper than the direction's normal) only the run around
        the contact point counts.
        """
        along = direction @ self._points
        run = _rising_run(along, np.searchsorted(self._t, self.origin))
        t = np.interp(distance, along[run], self._t[run], left=np.nan, right=np.nan)
        for _ in range(NEWTON_STEPS):
            angle = self.direction(t)
            rate = (direction[0] * np.cos(angle) + direction[1] * np.sin(angle)) * np.hypot(
                1.0, self.profile.slope(t)
            )
            t = np.clip(t - (direction @ self.point(t) - distance) / rate, *self.ends)
        return t

    def at_chords(self, length, count):
        """Abscissae [m] of up to ``count`` nodes to either side, each ``length`` [m]
        from the one before; rising.

        Source section 6.1: the intersection of the curve with a half circle about the last node.
        """
        sides = [self._chords(sign, length, count) for sign in (-1, 1)]
        return np.concatenate([sides[0][::-1], [self.origin], sides[1]])

    def _chords(self, sign, length, count):
        nodes, t = np.full(count, np.nan), self.origin
        for k in range(count):
            y, z = here = self.point(t)
            step = sign * length * math.cos(self.direction(t) - self.angle)
            for _ in range(2 * NEWTON_STEPS):
                if not self.ends[0] < t + step < self.ends[1]:
                    return nodes
                y, z = self.point(t + step) - here
                distance, angle = math.hypot(y, z), self.direction(t + step)
                rate = (y * math.cos(angle) + z * math.sin(angle)) / distance / math.cos(angle - self.angle)
                step -= (distance - length) / rate
            t = nodes[k] = t + step
        return nodes


def _rising_run(values, start):
    """Slice around ``start`` in which ``values`` rise."""
    falls = np.flatnonzero(np.diff(values) <= 0)
    low, high = falls[falls < start], falls[falls >= start]
    return slice(low[-1] + 1 if len(low) else 0, high[0] + 1 if len(high) else len(values))


@dataclass(frozen=True)
class Separation:
    """Nodes in pairs: station [m], gap [m], and abscissae of the pair on wheel and
    rail [m], four arrays (n,).

    ``stretch`` is the length along the contact plane per station: 1, or 1 / cos(contact
    angle) where stations are y.
    """

    station: np.ndarray
    gap: np.ndarray
    wheel: np.ndarray
    rail: np.ndarray
    stretch: float = 1.0

    @property
    def spacing(self):
        """Distance of the nodes [m]."""
        return float(self.station[1] - self.station[0])


class Section:
    """Wheel and rail of the right side in the plane of the principal profile, at a lateral
    shift [m] and without yaw."""

    def __init__(self, system, lateral_shift):
        chosen = system.parameters
        state = system.evaluate(lateral_shift=lateral_shift, normal_force=0.0, outputs="geometry")
        self.state, contact = state, state.right.contact
        placed = place_rail(
            system.rail,
            inclination=chosen["rail_inclination"],
            gauge=chosen["gauge"],
            gauge_depth=chosen["gauge_depth"],
        )
        self.radius, self.angle = chosen["nominal_radius"], state.right.contact_angle
        self.wheel = Curve(readable_wheel(system.wheel), contact.y_wheel, state.roll)
        self.rail = Curve(placed.profile, contact.y_rail)

    # --- separations, source section 6.1 ---

    def vertical(self, dy, count=400):
        """Vertical distance at the same y, nodes ``dy`` [m] apart."""
        y, axis = dy * np.arange(-count, count + 1), np.array([1.0, 0.0])
        wheel, rail = self.wheel.at_distance(axis, y), self.rail.at_distance(axis, y)
        gap = self.rail.point(rail)[1] - self.wheel.point(wheel)[1]
        return _known(y, gap, wheel, rail, 1 / math.cos(self.angle))

    def equidistant(self, ds, count=400, chords=False):
        """Distance of nodes at the same arc length, ``ds`` [m] apart, or as many chords of that length."""
        s = ds * np.arange(-count, count + 1)
        wheel, rail = (
            (curve.at_chords(ds, count) if chords else curve.at_arc(s)) for curve in (self.wheel, self.rail)
        )
        return _known(s, np.hypot(*(self.rail.point(rail) - self.wheel.point(wheel))), wheel, rail)

    def normal(self, ds, count=400):
        """Distance along the contact normal at the same station in the contact plane,
        nodes ``ds`` [m] apart."""
        s = ds * np.arange(-count, count + 1)
        across, normal = self.axes()
        wheel, rail = self.wheel.at_distance(across, s), self.rail.at_distance(across, s)
        return _known(s, normal @ (self.rail.point(rail) - self.wheel.point(wheel)), wheel, rail)

    def axes(self):
        """Unit vectors (y, z) along the contact plane to the field side and down along its normal."""
        c, s = math.cos(self.angle), math.sin(self.angle)
        return np.array([c, -s]), np.array([s, c])

    # --- curvatures, source sections 6.2 and 6.3 ---

    def longitudinal(self, wheel, effective=True):
        """A [1/m] at abscissae ``wheel``: ``1 / 2R``, or with ``R_eff = R / cos(delta)``,
        source eqs. (6.1), (6.2).

        delta counts from the axle, which the wheel is round about; counted from the track it lacks the roll.
        """
        A = 1 / (2 * (self.radius + self.wheel.profile.height(wheel)))
        return A * np.cos(self.wheel.direction(wheel) - self.wheel.angle) if effective else A

    def exact_lateral(self, nodes):
        """B [1/m] of ``nodes`` from the profiles' second derivatives."""
        return 0.5 * (self.rail.curvature(nodes.rail) - self.wheel.curvature(nodes.wheel))

    def smooth_lateral(self, nodes, reach):
        """B [1/m] from circles through the profiles within ``reach`` [m] to both sides:
        ANALYN's own way in the source."""
        curves = (self.rail, nodes.rail), (self.wheel, nodes.wheel)
        rail, wheel = (circle_curvature(curve, t, reach) for curve, t in curves)
        return 0.5 * (rail - wheel)


def _known(station, gap, wheel, rail, stretch=1.0):
    """The :class:`Separation` of the pairs that both profiles have."""
    there = np.isfinite(gap)
    return Separation(station[there], gap[there], wheel[there], rail[there], stretch)


def rough_curvature(points, printed=False):
    """Change of the inclination from chord to chord over their length [1/m] at ``points`` (2,
    n); the ends repeat the next.

    It belongs to the middle one of three nodes. Source eq. (6.3) as ``printed`` gives it to
    the first one, a node early.
    """
    step = np.diff(points, axis=1)
    inclination = np.unwrap(np.arctan2(step[1], step[0]))
    lengths = np.hypot(*step)
    bend = np.diff(inclination) / ((lengths[1:] + lengths[:-1]) / 2)
    first = 0 if printed else 1
    return np.pad(bend, (first, 2 - first), mode="edge")


def circle_curvature(curve, t, reach, count=31):
    """Curvature [1/m] of circles fitted by least squares to ``count`` points within ``reach``
    [m] of abscissae ``t`` (n,).

    In axes along the chord, ``v = a + b u + k (u^2 + v^2) / 2`` is a circle of curvature ``k / sqrt(1 + b^2 -
    2 a k)`` and linear in (a, b, k).
    """
    places = np.clip(t[:, None] + reach * np.linspace(-1, 1, count), *curve.ends)
    y, z = curve.point(places) - curve.point(t)[:, :, None]
    c, s = (part[:, -1:] - part[:, :1] for part in (y, z))
    chord = np.hypot(c, s)
    c, s = c / chord, s / chord
    u, v = (c * y + s * z) / reach, (c * z - s * y) / reach
    columns = np.stack([np.ones_like(u), u, (u**2 + v**2) / 2], axis=-1)
    matrix, right = np.swapaxes(columns, 1, 2) @ columns, np.swapaxes(columns, 1, 2) @ v[..., None]
    a, b, k = np.linalg.solve(matrix, right)[..., 0].T
    return k / np.sqrt(1 + b * b - 2 * a * k) / reach


# --- ANALYN ----------------------------------------------------------------------------------------


RANGE = 14.0  # of |ln(B/A)|
DEEPEST = 2e-3  # largest penetration [m]
#: 1 + alpha and n r of source eqs. (2.6)-(2.11), (2.21) over ln(B/A).
LOG_RATIO = np.linspace(-RANGE, RANGE, 2801)
ONE_ALPHA, NR = (CubicSpline(LOG_RATIO, column) for column in coefficients(LOG_RATIO))


@dataclass(frozen=True)
class StudyPatch:
    """A patch on its nodes.

    Attributes
    ----------
    station, half_length, pressure : y [m], a(y) [m], p0(y) [Pa], arrays (n,); zero where unloaded.
    penetration : delta_0 [m].
    normal_force : sum over the nodes [N].
    lateral : B used [1/m] (n,); NaN where the node has dropped out.
    first_point_loaded : whether the node at the rigid contact point is in the patch.
    """

    station: np.ndarray
    half_length: np.ndarray
    pressure: np.ndarray
    penetration: float
    normal_force: float
    lateral: np.ndarray

    @property
    def loaded(self):
        """Which nodes carry load."""
        return self.half_length > 0

    @property
    def spacing(self):
        return float(self.station[1] - self.station[0])

    @property
    def width(self):
        """Extent from the first loaded node to the last, and half a node further [m]."""
        places = self.station[self.loaded]
        return float(places[-1] - places[0]) + self.spacing if len(places) else 0.0

    @property
    def length(self):
        return 2 * float(self.half_length.max())

    @property
    def area(self):
        return 2 * float(self.half_length.sum()) * self.spacing

    @property
    def first_point_loaded(self):
        return bool(self.loaded[np.argmin(np.abs(self.station))])

    @property
    def regions(self):
        """Number of runs of loaded nodes."""
        return int(np.sum(np.diff(np.concatenate([[0], self.loaded.astype(int)])) == 1))


def corrected(B, inside, degree):
    """``B`` with what is not positive among the nodes ``inside`` replaced by a polynomial fitted to all of
    them; NaN where that is not positive either.

    The source says so of ANALYN's own code, without the degree.
    """
    B = np.array(B)
    wrong = inside & ~(B > 0)
    if degree is not None and wrong.any() and inside.sum() > degree + 1:
        place = np.linspace(-1, 1, inside.sum())
        fit = np.polynomial.Polynomial.fit(place, B[inside], degree)(place)
        B[wrong] = fit[wrong[inside]]
    return np.where(B > 0, B, np.nan)


def solve_analyn(station, gap, A, B, *, force, modulus, correction=None):
    """The patch that carries ``force`` [N]; a :class:`StudyPatch`.

    Parameters
    ----------
    station : of the nodes, equal distances [m]; gap, A, B : g [m] and the relative curvatures
    [1/m] there, arrays (n,).
    modulus : E* [Pa].
    correction : degree of the polynomial that replaces B <= 0 inside the interpenetration, or None.
    """
    spacing = float(station[1] - station[0])

    def patch(depth):
        used = corrected(B, gap < depth, correction)
        with np.errstate(invalid="ignore"):
            ratio = np.clip(np.log(used / A), -RANGE, RANGE)
            # (2.26), 1 + beta by symmetry
            d = depth - ONE_ALPHA(-ratio) * gap
            d = np.where(d > 0, d, 0.0)  # NaN > 0 is False
            a = np.nan_to_num(np.sqrt(d / (ONE_ALPHA(ratio) * A)))  # (2.23)
            line = np.nan_to_num(modulus * d / NR(ratio))  # pi/2 a p0, (2.24), (2.25)
        return used, a, line

    def missing(depth):
        return float(patch(depth)[2].sum()) * spacing - force

    depth = brentq(missing, 0.0, DEEPEST, xtol=1e-13)
    used, a, line = patch(depth)
    pressure = np.divide(2 / math.pi * line, a, out=np.zeros_like(a), where=a > 0)
    return StudyPatch(station, a, pressure, depth, float(line.sum()) * spacing, used)
