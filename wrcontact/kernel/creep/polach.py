"""Polach's formula for one ellipse.

O. Polach, A fast wheel-rail forces calculation computer code, Vehicle System Dynamics Supplement 33 (1999)
728-739, without his reduction factors for wet rails.  With the semi-axes a along and b across, Kalker's
coefficients C_ij and

    eta_c = eta + phi a where that is larger than eta, else eta;   s_c = sqrt(xi^2 + eta_c^2)
    C = sqrt((C11 xi)^2 + (C22 eta)^2) / sqrt(xi^2 + eta^2)
    e = pi a b G C s_c / (4 mu N)                                                              (P1)
    F = (2 mu N / pi) (e / (1 + e^2) + arctan e)                                               (P2)

the force is F (xi, eta) / s_c against the slip, and the lateral force of spin

    B = 1 + 6.3 (1 - exp(-a/b)),   e_s = (8/3) G b sqrt(ab) C23 s_c / (mu N B)                 (P3)
    K = e_s (d^3/3 - d^2/2 + 1/6) - (1 - d^2)^1.5 / 3,   d = (e_s^2 - 1) / (e_s^2 + 1)         (P4)
    F_s = (9/16) a mu N K B phi / s_c                                                          (P5)

comes to it; K is negative.  Their sum is cut to mu N.  The formula knows neither a moment of spin nor a stick
zone.  For small creepages it is Kalker's linear theory: K = -(2/3) e_s.
"""

from math import fabs, pi, sqrt
from typing import Final

from ..elementary.circle import atan
from ..elementary.powers import exp
from ..layout import Patch, Tables
from .tractions import kalker_coefficients

#: Below this slip forces are those of linear theory.
SMALLEST: Final[float] = 1e-150
#: A slip of this size has no direction yet: C of eq. (P1) begins as C11 for the longitudinal force and as C22
#: for the lateral one, so that the formula has slopes at no creepage.
AIMLESS: Final[float] = 1e-9


def solve_polach(tables: Tables, patch: Patch):
    """Force and largest traction of a patch."""
    a = patch.half_length
    reach = patch.creepage_y + patch.spin * a
    if fabs(reach) < fabs(patch.creepage_y):
        reach = patch.creepage_y
    whole = sqrt(patch.creepage_x * patch.creepage_x + reach * reach)
    first, second, third = kalker_coefficients(tables.rolling, a / patch.half_width)
    modulus = tables.shear_modulus
    along = mean_coefficient(patch, first, second, first)
    across = mean_coefficient(patch, first, second, second)
    patch.creep_x = -slope(modulus, patch, along, whole) * patch.creepage_x
    patch.creep_y = -slope(modulus, patch, across, whole) * patch.creepage_y
    patch.creep_y += spin_slope(modulus, patch, third, whole) * patch.spin
    cut_force(patch)
    patch.max_shear = largest_shear(patch)


def mean_coefficient(patch: Patch, first: float, second: float, own: float):
    """Kalker's coefficient in the direction of the slip; where the slip is next to nothing, the ``own`` one of
    a force's direction."""
    x = patch.creepage_x * patch.creepage_x
    y = patch.creepage_y * patch.creepage_y
    floor = AIMLESS * AIMLESS
    return sqrt((first * first * x + second * second * y + own * own * floor) / (x + y + floor))


def slope(shear_modulus: float, patch: Patch, coefficient: float, whole: float):
    """Force over slip [N] where that is ``whole``; eqs. (P1), (P2)."""
    bound = patch.friction * patch.totals.load
    rate = 0.25 * pi * patch.half_length * patch.half_width * shear_modulus * coefficient / bound
    e = rate * whole
    share = 2.0 * rate
    if whole > SMALLEST:
        share = atan(e)
        if e < 1.0:
            share += e / (1.0 + e * e)
        else:
            share += 1.0 / (e + 1.0 / e)
        share /= whole
    return 2.0 / pi * bound * share


def spin_slope(shear_modulus: float, patch: Patch, coefficient: float, whole: float):
    """Lateral force of spin over the spin [N m]; eqs. (P3) to (P5)."""
    a = patch.half_length
    b = patch.half_width
    bound = patch.friction * patch.totals.load
    wide = 1.0 + 6.3 * (1.0 - exp(-a / b))
    rate = 8.0 / 3.0 * shear_modulus * b * sqrt(a * b) * coefficient / (bound * wide)
    share = -2.0 / 3.0 * rate
    if whole > SMALLEST:
        share = spin_share(rate * whole) / whole
    return 9.0 / 16.0 * a * bound * wide * share


def spin_share(e: float):
    """K of eq. (P4), written in c = 1 - d so that nothing cancels where e is large."""
    c = 2.0 / (1.0 + e * e)
    root = e * c  # sqrt(1 - d^2)
    # d^3/3 - d^2/2 + 1/6 = c^2/2 - c^3/3
    return 0.5 * e * c * c * (1.0 - 2.0 / 3.0 * c) - root * root * root / 3.0


def cut_force(patch: Patch):
    """Let the force not exceed that of full slip."""
    bound = patch.friction * patch.totals.load
    force = sqrt(patch.creep_x * patch.creep_x + patch.creep_y * patch.creep_y)
    if force > bound:
        patch.creep_x *= bound / force
        patch.creep_y *= bound / force


def largest_shear(patch: Patch):
    """The largest traction [Pa] where tractions are spread like the pressure of the ellipse."""
    force = sqrt(patch.creep_x * patch.creep_x + patch.creep_y * patch.creep_y)
    return 1.5 * force / (pi * patch.half_length * patch.half_width)
