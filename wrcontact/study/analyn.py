"""ANALYN as the source writes it, in numpy: one lateral curvature for everything, nodes at
fixed distances, one patch.

Source eqs. (2.19)-(2.26). With E* of its eq. (2.9) the factor of eq. (2.25) must be 2 E*/pi; with
E*/(2 pi), as printed, the pressure carries a quarter of the force. Where B <= 0 the formulas have no
value: such nodes drop out of the patch.

>>> import numpy as np
>>> from wrcontact.study.analyn import solve_analyn
>>> y = np.linspace(-0.01, 0.01, 801)
>>> A, B = np.full_like(y, 1.0), np.full_like(y, 1.0)
>>> patch = solve_analyn(y, B * y**2, A, B, force=1e4, modulus=1.139e11)
>>> round(patch.penetration * 1e6, 2)           # Hertz: (9 F^2 / 16 R E*^2)^(1/3) with R = 0.5 m
20.54
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk, ellipkm1

RANGE = 14.0    # of |ln(B/A)|
DEEPEST = 2e-3  # largest penetration [m]


def _hertz(q):
    """ln(B/A), 1 + alpha and n r for an ellipse with semi-axes b = q a, q <= 1; source eqs.
    (2.6)-(2.11), (2.21)."""
    m1 = q * q                                  # complementary parameter
    K, E = ellipkm1(m1), ellipe(1 - m1)
    small_over_large = (K - E) / (E / m1 - K)   # A / B
    return -np.log(small_over_large), K * q * q / E * (1 + 1 / small_over_large), 2 / np.pi * K * q


def _spline():
    """1 + alpha and n r as splines over ln(B/A), from both halves of the table."""
    q = np.exp(-np.linspace(0.0, 10.5, 1200)[1:])
    ratio, one_alpha, nr = _hertz(q)
    K, E = ellipkm1(q * q), ellipe(1 - q * q)
    mirrored = K / E * (1 + np.exp(-ratio))     # B < A: the patch is longer across
    x = np.concatenate([-ratio[::-1], [0.0], ratio])
    return (CubicSpline(x, np.concatenate([mirrored[::-1], [2.0], one_alpha])),
            CubicSpline(x, np.concatenate([(nr / q)[::-1], [2 / np.pi * ellipk(0.0)], nr])))


_ONE_ALPHA, _NR = _spline()


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
            d = depth - _ONE_ALPHA(-ratio) * gap
            d = np.where(d > 0, d, 0.0)                                           # NaN > 0 is False
            a = np.nan_to_num(np.sqrt(d / (_ONE_ALPHA(ratio) * A)))               # (2.23)
            line = np.nan_to_num(modulus * d / _NR(ratio))                        # pi/2 a p0, (2.24), (2.25)
        return used, a, line

    def missing(depth):
        return float(patch(depth)[2].sum()) * spacing - force

    depth = brentq(missing, 0.0, DEEPEST, xtol=1e-13)
    used, a, line = patch(depth)
    pressure = np.divide(2 / math.pi * line, a, out=np.zeros_like(a), where=a > 0)
    return StudyPatch(station, a, pressure, depth, float(line.sum()) * spacing, used)
