"""From measured points to a smooth curve: noise estimate, smoothing spline over the arc length, and its
pieces in y.

The spline is FITPACK's of degree 5 over the arc length, so flanges and gauge faces may be vertical.  It uses
the smallest number of knots that keeps the points within the tolerance: sum of squared distances <= (n + 3
sqrt(2 n)) tolerance^2.  Few knots on the tread and many in the root give a usable curvature: with 1 to 10 um
of noise every 0.2 mm its error on the tread of S1002 is 0.1 to 0.5 1/m; a spline of uniform stiffness has an
error of 1 to 2 1/m.
"""

import math
import warnings

import numpy as np

from .remarks import Refusal
from .zones import Polynomial

#: Points with less noise are not smoothed [mm]; rounding to four decimals gives three times as much.
LEAST_NOISE = 1e-5
#: Noise is the residual of polynomials fitted to stretches of points: number of points, degree, step from one
#: stretch to the next, and the median of chi squared with (points - degree - 1) degrees of freedom.  If the
#: points are far apart, the residual of long stretches includes the profile's own joints.  The short stretch
#: is used if its variance is less than half of that and the spacing is more than SPARSE times the noise.
STRETCHES = ((11, 5, 2, 4.3515), (5, 3, 1, 0.4549))
SPARSE = 20.0
#: Noise is estimated by place where the estimates around PLACE points differ by more than UNEVEN from the
#: tenth to the ninetieth of a hundred: even noise gives up to 2. Only what exceeds JOINTS [1/mm] times the
#: squared spacing counts as noise, since joints of exact profiles leave half as much.
PLACE, UNEVEN, JOINTS = 61, 3.0, 1e-3
#: Largest ratio of the noise of two places.
MOST_CERTAIN = 1e3
#: Relative regularisation, for repeated points; it changes a fit by this share.
RIDGE = 1e-12
#: Squared cosine of the angle above which a stretch is flat, and below which it is steep.
FLAT, STEEP = 0.75, 0.5
#: Smallest number of flat or steep stretches that gives a noise of its own.
FEWEST = 6
#: Points are averaged over this many times the noise before directions are computed.
AVERAGED = 10.0
#: Longest and shortest piece along the curve [mm].
PIECE, SHORTEST_PIECE = 0.5, 0.01
#: Slope beyond which a curve is a wall.  A rail continues in straight pieces there; a wheel ends there.
WALL = math.tan(math.radians(88.0))
#: A wall may begin this far below the top of a rail or the running circle, or beyond this y on a wheel, or
#: behind its flange [mm].
WALL_DEPTH, FIELD_SIDE = 5.0, 25.0
#: Smallest advance in y of a wall's pieces, relative to their length; 20 mm of vertical gauge face advance by
#: 0.02 mm.
LEAST_ADVANCE = 1e-3
#: Smallest width of a piece in y [mm].
NARROWEST = 1e-6


def noise_of(y, z):
    """Standard deviation [mm] of points ``y``, ``z`` (n,) across their curve where it is flat, and the factor
    (n,) by which it is smaller at each point.

    It is the median, over stretches, of the residual of a polynomial, separately for flat and steep
    stretches: noise in z alone is smaller across a flank.
    """
    if len(y) < 2 * STRETCHES[0][0]:
        return 0.0, np.ones(len(y))
    (flat, steep), short = (_variances(y, z, *stretch) for stretch in STRETCHES)
    if short[0] < 0.5 * flat and np.median(np.hypot(np.diff(y), np.diff(z))) > SPARSE * math.sqrt(flat):
        flat, steep = short
    angle = np.arctan2(np.gradient(z), np.gradient(y))
    half = STRETCHES[0][0] // 2
    level = np.convolve(
        np.pad(np.cos(angle) ** 2, half, mode="edge"), np.ones(2 * half + 1), mode="valid"
    ) / (2 * half + 1)
    sideways = max(2.0 * steep - flat, 0.0)  # steep stretches are assumed to be at 45 degrees
    certainty = np.sqrt(flat / np.maximum(level * flat + (1.0 - level) * sideways, 1e-300))
    return math.sqrt(flat), np.clip(certainty, 0.2, 5.0) if flat > 0.0 else np.ones(len(y))


def noise_by_place(y, z):
    """Noise (n,) [mm] at each point, the median over stretches around it; None where it is about the same
    everywhere.  It differs in a file that was measured in part, or has few digits.  Outliers must be gone: close
    to each other they look like noise."""
    if len(y) < 2 * STRETCHES[0][0]:
        return None
    (long, short), chord = (
        (_around(y, z, *stretch) for stretch in STRETCHES),
        np.hypot(np.diff(y), np.diff(z)),
    )
    spacing = np.convolve(np.pad(chord, (10, 11), mode="reflect"), np.ones(21) / 21, mode="valid")
    joints = (short < 0.5 * long) & (spacing > SPARSE * np.sqrt(long))
    noise = np.sqrt(np.where(joints, short, long))
    low, high = np.percentile(noise, [10, 90])
    noisy = noise > np.maximum(LEAST_NOISE, JOINTS * spacing**2)
    if high <= UNEVEN * low or noisy.sum() < STRETCHES[0][0]:
        return None
    quiet = np.median(noise[~noisy]) if not noisy.all() else low
    found = np.where(noisy, noise, quiet)
    # the noisiest part has one noise, since the estimates scatter, and those at its ends are too small
    most = found > np.percentile(found[noisy], 90) / UNEVEN
    stretch = STRETCHES[int(np.mean(joints[most]) > 0.5)]
    starts, variance, _ = _stretches(y, z, *stretch)
    level = math.sqrt(np.median(variance[most[starts + stretch[0] // 2]]))
    most = np.convolve(most, np.ones(STRETCHES[0][0]), mode="same") > 0.0
    return np.clip(np.where(most, level, found), max(LEAST_NOISE, level / MOST_CERTAIN), level)


def _around(y, z, points, degree, step, median):
    """Variances (n,) [mm^2] at each point: the median of the stretches within PLACE points around it."""
    starts, variance, _ = _stretches(y, z, points, degree, step, median)
    near = min(PLACE // (2 * step), len(variance) - 1)
    padded = np.pad(variance, near, mode="reflect")
    medians = np.median(np.lib.stride_tricks.sliding_window_view(padded, 2 * near + 1), axis=1)
    return np.interp(np.arange(len(y)), starts + points // 2, medians)


def _stretches(y, z, points, degree, step, median):
    """First points (m,) of all stretches, their variances (m,) [mm^2], and the squared cosines (m,) of their
    directions."""
    starts = np.arange(0, len(y) - points + 1, step)
    rows = [part[starts[:, None] + np.arange(points)] for part in (y, z)]
    along, across = in_chords(*rows)
    left = across - np.einsum("sij,sj->si", _fits(along, degree), across)
    return starts, np.sum(left * left, axis=1) / median, np.cos(_directions(*rows)) ** 2


def _variances(y, z, *stretch):
    """Variances [mm^2] of flat and of steep stretches; if there are too few of a kind, that of all
    stretches."""
    _, variance, level = _stretches(y, z, *stretch)
    return [
        np.median(variance[some] if some.sum() >= FEWEST else variance)
        for some in (level > FLAT, level < STEEP)
    ]


def _directions(y, z):
    """Angles (m,) [rad] of the least-squares lines through rows of points (m, n)."""
    y, z = y - y.mean(axis=1, keepdims=True), z - z.mean(axis=1, keepdims=True)
    return 0.5 * np.arctan2(2 * np.sum(y * z, axis=1), np.sum(y * y, axis=1) - np.sum(z * z, axis=1))


def in_chords(y, z, y_more=None, z_more=None):
    """Coordinates along and across the least-squares line through each row of ``y``, ``z`` (m, n): of these
    points, followed by those of ``y_more``, ``z_more`` (m, k)."""
    angle = _directions(y, z)[:, None]
    y_mean, z_mean = y.mean(axis=1, keepdims=True), z.mean(axis=1, keepdims=True)
    y, z = (part if more is None else np.hstack([part, more]) for part, more in ((y, y_more), (z, z_more)))
    y, z = y - y_mean, z - z_mean
    return np.cos(angle) * y + np.sin(angle) * z, np.cos(angle) * z - np.sin(angle) * y


def _fits(along, degree):
    """Matrices (m, n, n) that project values at each row of ``along`` (m, n) onto polynomials."""
    scale = np.maximum(np.max(np.abs(along), axis=1, keepdims=True), 1e-300)
    powers = (along / scale)[:, :, None] ** np.arange(degree + 1)
    return powers @ pseudo_inverse(powers)


def pseudo_inverse(powers):
    """Pseudo-inverses (m, k, n) of scaled ``powers`` (m, n, k), by normal equations with RIDGE."""
    turned = np.swapaxes(powers, 1, 2)
    return np.linalg.solve(turned @ powers + RIDGE * np.eye(powers.shape[2]), turned)


def arc_lengths(y, z, noise):
    """Arc length (n,) [mm] of the points, along averages of them, so that noise does not lengthen it."""
    chord = np.hypot(np.diff(y), np.diff(z))
    group = max(1, min(round(AVERAGED * noise / max(np.median(chord), 1e-9)), len(y) // 8))
    if group == 1:
        return np.concatenate([[0.0], np.cumsum(chord)])
    starts = np.arange(0, len(y) - group + 1, group)
    count = np.diff(np.append(starts, len(y)))
    y_mean, z_mean = np.add.reduceat(y, starts) / count, np.add.reduceat(z, starts) / count
    base = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y_mean), np.diff(z_mean)))])
    angle = np.arctan2(np.gradient(z_mean), np.gradient(y_mean))
    own = np.repeat(np.arange(len(starts)), count)
    return base[own] + np.cos(angle[own]) * (y - y_mean[own]) + np.sin(angle[own]) * (z - z_mean[own])


def _most(count):
    """Sum of ``count`` squared distances that noise of 1 exceeds in one case of 700; a closer curve would
    follow the noise."""
    return count + 3.0 * math.sqrt(2.0 * count)


class Curve:
    """The smoothing spline for ordered points ``y``, ``z`` (n,) [mm], with a root mean square distance of
    ``tolerance`` [mm].

    ``weight`` (n,) multiplies the distance of each point.  With tolerance 0 the spline goes through every
    point.
    """

    def __init__(self, y, z, weight, tolerance):
        from scipy.interpolate import splprep

        s = arc_lengths(y, z, tolerance)
        order = np.argsort(s, kind="stable")
        s, y, z, weight = s[order], y[order], z[order], weight[order]
        new = np.concatenate([[True], np.diff(s) > 1e-7])
        s, y, z, weight = s[new], y[new], z[new], weight[new]
        if len(s) < 6:
            raise Refusal(f"has {len(s)} different points; permitted are 6 or more")
        self.s, self.origin = s, (0.0, 0.0)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # with too few knots it is as close to the points as possible
            self._spline, _ = splprep([y, z], u=s, w=weight, s=_most(len(s)) * tolerance**2, k=5)
        (y_smooth, z_smooth), *_ = self(s)
        self.moved = float(np.max(np.hypot(y_smooth - y, z_smooth - z)))

    def __call__(self, s):
        """((y, z), (y', z'), (y'', z'')) at arc lengths ``s``, from the origin."""
        from scipy.interpolate import splev

        (y, z), slope, bend = (splev(s, self._spline, der=order) for order in range(3))
        return (y - self.origin[0], z - self.origin[1]), slope, bend

    def ends_of_pieces(self):
        """Arc lengths (n,) at the ends of the pieces: knots at least SHORTEST_PIECE apart, and others at most
        PIECE apart."""
        knots = np.unique(np.clip(self._spline[0], self.s[0], self.s[-1]))
        kept = [knots[0]]
        for knot in knots[1:-1]:
            if knot - kept[-1] >= SHORTEST_PIECE and knots[-1] - knot >= SHORTEST_PIECE:
                kept.append(knot)
        kept.append(knots[-1])
        parts = [
            np.linspace(low, high, math.ceil((high - low) / PIECE) + 1)[:-1]
            for low, high in zip(kept[:-1], kept[1:])
        ]
        return np.append(np.concatenate(parts), knots[-1])

    def nearest(self, y):
        """The arc length at which the abscissa is closest to ``y`` [mm]."""
        s = np.linspace(self.s[0], self.s[-1], 2001)
        return s[np.argmin(np.abs(self(s)[0][0] - y))]

    def highest(self):
        """The arc length of the highest point (smallest z), which becomes the origin."""
        s = np.linspace(self.s[0], self.s[-1], 2001)
        top = s[np.argmin(self(s)[0][1])]
        low, high = max(top - (s[1] - s[0]), s[0]), min(top + (s[1] - s[0]), s[-1])
        while high - low > 1e-9:
            middle = 0.5 * (low + high)
            low, high = (middle, high) if self(middle)[1][1] < 0.0 else (low, middle)
        self.origin = tuple(float(part) for part in self(low)[0])
        return low


def pieces_of(curve, top, *, walls):
    """Quintic pieces in y of ``curve`` around the arc length ``top``, as far as it is less steep than WALL,
    and whether the result is smooth.  With ``walls``, straight pieces continue to the ends of the curve.

    Raises
    ------
    Refusal
        if the curve is steeper than that at ``top``.
    """
    s = curve.ends_of_pieces()
    (y, z), (dy, dz), (ddy, ddz) = curve(s)
    flat = (np.abs(dz) < WALL * dy) & (dy > 0)
    middle = int(np.argmin(np.abs(s - top)))
    if not flat[middle]:
        raise Refusal(f"folds back or is vertical at y = {y[middle]:.4g} mm, where wheel and rail meet")
    rising = flat[:-1] & flat[1:] & (np.diff(y) > 0.5 * np.diff(s) / math.hypot(1.0, WALL))
    breaks = np.flatnonzero(~rising)
    first = max(breaks[breaks < middle], default=-1) + 1
    last = min(breaks[breaks >= middle], default=len(s) - 1)
    with np.errstate(divide="ignore", invalid="ignore"):  # vertical parts are not used
        slope, bend = dz / dy, (ddz * dy - dz * ddy) / dy**3
    jets = list(zip(y, z, slope, bend))
    zones = [_quintic(*pair) for pair in zip(jets[first:last], jets[first + 1 : last + 1])]
    tip = y[int(np.argmax(z))]
    for end in {first, last} - {0, len(s) - 1}:
        outside = not walls and (y[end] >= FIELD_SIDE or y[end] < min(tip, -FIELD_SIDE))
        if z[end] < WALL_DEPTH and not outside:
            raise Refusal(
                f"folds back or is vertical at y = {y[end]:.4g} mm, z = {z[end]:.3g} mm; permitted "
                f"is that from z = {WALL_DEPTH:g} mm "
                "on" + ("" if walls else f", behind the flange and beyond y = {FIELD_SIDE:g} mm")
            )
    if walls:
        lower = _wall(-y[first::-1], z[first::-1], -slope[first])
        upper = _wall(y[last:], z[last:], slope[last])
        zones = [_mirrored(zone) for zone in reversed(lower)] + zones + upper
        return tuple(zones), not (lower or upper)
    return tuple(zones), True


def _quintic(low, high):
    """The piece between two points (y, z, slope, second derivative)."""
    (y, c0, c1, twice), (stop, z, slope, bend) = low, high
    h, c2 = stop - y, 0.5 * twice
    rest = (z - c0 - h * (c1 + h * c2)) / h**3
    turn = (slope - c1 - 2 * h * c2) / h**2
    bow = (bend - 2 * c2) / h
    terms = (
        c0,
        c1,
        c2,
        10 * rest - 4 * turn + 0.5 * bow,
        (-15 * rest + 7 * turn - bow) / h,
        (6 * rest - 3 * turn + 0.5 * bow) / h**2,
    )
    return Polynomial(float(y), float(stop), tuple(map(float, terms)), float(y))


def _wall(y, z, slope):
    """Straight pieces through the points of a wall, outwards and down until it turns up; y advances by at
    least LEAST_ADVANCE."""
    zones, start, height = [], float(y[0]), float(z[0])
    for low, high in zip(z[:-1], z[1:]):
        if high <= low or slope < 0.0:
            break
        k = len(zones) + 1
        stop = max(float(y[k]), start + LEAST_ADVANCE * float(high - low), start + NARROWEST)
        zones.append(Polynomial(start, stop, (height, float(high - height) / (stop - start)), start))
        start, height = stop, float(high)
    return zones


def _mirrored(zone):
    """A straight piece of a wall on the other side."""
    height, slope = zone.coefficients
    return Polynomial(
        -zone.stop, -zone.start, (height + slope * (zone.stop - zone.start), -slope), -zone.stop
    )
