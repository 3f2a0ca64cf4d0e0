"""Friction in a patch: its coefficient, and how steeply the creep force begins.

    mu = mu_side f(gamma) [(1 - A) exp(-B w) + A]                 Polach (2005)
    k  = k0 [alpha + (1 - alpha) / (1 + beta epsilon)]            Spiryagin, Polach, Cole (2013)

with f from 1 on the tread to ``flange_friction_ratio`` on the flange over the contact angle gamma, the
sliding velocity w of each point (falling.py), for Polach's formula w = V_ref sqrt(xi^2 + eta^2), and epsilon = G pi a b k0 C11 sqrt(xi^2 + (eta + phi a)^2) / (4
mu N). The flexibility of the contact is divided by k; as the models know it only beside the creepages, these
are multiplied by k.

Friction takes power: where a model would give some back, its moment is changed.

In steady rolling elastic deformation takes no power in sum, and over the rolling speed friction takes

    P = -(xi F_x + eta F_y + phi M
          + sum_i [(w_x,i - xi + phi y_i) F_x,i + (w_y,i - phi_i x_i - eta) F_y,i
                   + (phi_i - phi) M_i])                                       (W1)

with the creepages and the spin of the strips' own places.  The complete theory has P >= 0, and so have the
models almost everywhere.  In one of some thousand cases, with spin on long patches, the error of the moment
makes P negative; there the moment is the one with P = 0.  Forces stay as they are, and nothing jumps.
"""

from math import fabs, sqrt
from typing import Final

from ..elementary.powers import exp
from ..layout import ROLLING_STRIP_LIMIT, TANGENTIAL_POLACH, Patch, Tables
from .tractions import kalker_coefficients

PI: Final[float] = 3.141592653589793
#: Half the range of contact angles over which friction changes from tread to flange [rad].
FLANGE_RANGE: Final[float] = 0.2


def set_friction(tables: Tables, patch: Patch, friction: float, resting: bool):
    """Coefficient of friction of a patch that rolls, where that of its side is ``friction``, and how it
    falls with the creepages of its points; ``resting``: it does not fall."""
    patch.friction = friction
    patch.fall_rate = 0.0
    parameters = tables.parameters
    if parameters.flange_friction_ratio != 1.0:
        share = flange_share(tables, patch.contact_angle)
        patch.friction *= 1.0 + (parameters.flange_friction_ratio - 1.0) * share
    if parameters.friction_fall_rate > 0.0 and not resting:
        fall = parameters.friction_fall
        if tables.tangential == TANGENTIAL_POLACH:
            creepage = sqrt(patch.creepage_x * patch.creepage_x + patch.creepage_y * patch.creepage_y)
            sliding = patch.speed * creepage
            patch.friction *= (1.0 - fall) * exp(-parameters.friction_fall_rate * sliding) + fall
        else:
            patch.fall_rate = parameters.friction_fall_rate * patch.speed
            patch.fall_floor = fall


def flange_share(tables: Tables, angle: float):
    """How much of the flange's friction there is at a contact ``angle`` [rad]: 0 on the tread, 1 on the
    flange, with a smooth slope."""
    share = 0.5 + 0.5 * (angle - tables.parameters.flange_friction_angle) / FLANGE_RANGE
    share = min(max(share, 0.0), 1.0)
    return share * share * (3.0 - 2.0 * share)


def slope_factor(tables: Tables, patch: Patch):
    """k of a patch, by which its creepages are multiplied where wet or dirty rails reduce the initial
    slope."""
    factor = 1.0
    parameters = tables.parameters
    if parameters.slope_reduction != 1.0 or parameters.slope_reduction_rate > 0.0:
        initial = parameters.slope_reduction
        limit = patch.friction * patch.totals.load
        factor = initial
        if parameters.slope_reduction_rate > 0.0 and limit > 0.0:
            across = patch.creepage_y + patch.spin * patch.half_length
            creepage = sqrt(patch.creepage_x * patch.creepage_x + across * across)
            c11, c22, c23 = kalker_coefficients(tables.rolling, patch.half_length / patch.half_width)
            epsilon = (
                tables.shear_modulus
                * PI
                * patch.half_length
                * patch.half_width
                * initial
                * c11
                * creepage
                / (4.0 * limit)
            )
            factor = initial * parameters.slope_reduction_floor
            factor = factor + (initial - factor) / (1.0 + parameters.slope_reduction_rate * epsilon)
    return factor


def multiply_creepages(patch: Patch, factor: float):
    """Multiply the creepages of a patch and of its strips by ``factor``; friction falls as before."""
    patch.fall_rate /= factor
    patch.creepage_x *= factor
    patch.creepage_y *= factor
    patch.spin *= factor
    for index in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[index]
        strip.slip *= factor
        strip.lateral *= factor
        strip.spin *= factor


def is_frictional(friction: float, limit: float) -> bool:
    """Whether a coefficient of friction is within 0 and ``limit``."""
    return friction >= 0.0 and friction <= limit


def keep_dissipating(patch: Patch):
    """Change the moment where it would be a gain of power, eq. (W1), but to no more than friction has.

    Polach's formula has no moment of its own, but a lateral force of spin, which is a gain of power where
    lateral creepage has its direction.
    """
    gain = creep_gain(patch)
    if gain > 0.0 and patch.spin != 0.0:
        reach = max(patch.half_length, patch.half_width)
        most = patch.friction * patch.totals.load * reach
        moment = max(min(patch.creep_moment - gain / patch.spin, most), -most)
        patch.creep_moment = moment


def creep_gain(patch: Patch):
    """-P of eq. (W1) [N].  The sum over the strips is zero in a plane patch."""
    gain = (
        patch.creepage_x * patch.creep_x + patch.creepage_y * patch.creep_y + patch.spin * patch.creep_moment
    )
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        plane = patch.creepage_x - patch.spin * strip.y
        lateral = strip.lateral - strip.spin * strip.x - patch.creepage_y
        gain += (
            (strip.slip - plane) * strip.force_x
            + lateral * strip.force_y
            + (strip.spin - patch.spin) * strip.moment
        ) * strip.width
    return gain
