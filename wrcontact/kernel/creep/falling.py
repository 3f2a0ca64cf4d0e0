"""Friction that falls with the sliding velocity of each point.

What slips at the point x of a strip has the share

    f = (1 - A) exp(-t) + A,   t = (B V_ref / k) sqrt(w_x^2 + (w_y + phi x)^2)                   (L1)

of the friction of rest, with the strip's creepages and spin and the k of a reduced slope, by which they are
multiplied.  Stick zones, integrations and directions are those of the friction of rest: only tractions of slip
count f times.  So the force is continuous, and no equation has several solutions.  The coefficient of
friction of the patch is then the mean over its points, weighted with their pressure, in which what sticks
counts with the friction of rest.

The correction of strips counts in proportion to that mean.
"""

from math import sqrt
from typing import Final

from ..layout import ROLLING_STRIP_LIMIT, FallingFriction, Patch, StripIntegrations, RollingStrip

#: exp(-t) is the sixty-fourth power of exp(-t/64).
POWER: Final[float] = 64.0
#: exp(-t) counts as that of this t beyond it, 4e-18.
LARGEST: Final[float] = 40.0


def open_falling(falling: FallingFriction, patch: Patch):
    """Exponents of all strips of a patch, eq. (L1)."""
    falling.floor = patch.fall_floor
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        falling.slide_x[i] = patch.fall_rate * strip.slip
        falling.slide_y[i] = patch.fall_rate * strip.lateral
        falling.slide_turn[i] = patch.fall_rate * strip.spin * strip.half_length
        falling.lost[i] = 0.0


def find_shares(falling: FallingFriction, x: float):
    """f of all strips at the place ``x`` over a, eq. (L1)."""
    floor = falling.floor
    for i in range(ROLLING_STRIP_LIMIT):
        along = falling.slide_x[i]
        across = falling.slide_y[i] + falling.slide_turn[i] * x
        falling.share[i] = floor + (1.0 - floor) * decay(sqrt(along * along + across * across))


def point_share(patch: Patch, strip: RollingStrip, x: float):
    """f at the place ``x`` [m] of a ``strip``."""
    along = strip.slip
    across = strip.lateral + strip.spin * x
    slide = patch.fall_rate * sqrt(along * along + across * across)
    return patch.fall_floor + (1.0 - patch.fall_floor) * decay(slide)


def decay(t: float):
    """exp(-t) for t >= 0, within 1e-14, without a branch: compilers do several at once."""
    z = min(t, LARGEST) / POWER
    p = 1.0 - z / 6.0 * (1.0 - z / 7.0 * (1.0 - z / 8.0))
    p = 1.0 - z * (1.0 - z / 2.0 * (1.0 - z / 3.0 * (1.0 - z / 4.0 * (1.0 - z / 5.0 * p))))
    p *= p
    p *= p
    p *= p
    p *= p
    p *= p
    return p * p


def weigh_slips(integrations: StripIntegrations, falling: FallingFriction, bound: float):
    """Let what slips at a point with the ``bound`` count with friction's share, until
    :func:`restore_slips`."""
    for i in range(ROLLING_STRIP_LIMIT):
        share = falling.share[i]
        slips = integrations.slips[i]
        noted = integrations.noted[i]
        falling.slips[i] = slips
        falling.noted[i] = noted
        falling.lost[i] += bound * bound * slips * (1.0 - share)
        integrations.slips[i] = slips * share
        integrations.noted[i] = noted * share * share


def restore_slips(integrations: StripIntegrations, falling: FallingFriction):
    """Let what slips count as a whole again."""
    for i in range(ROLLING_STRIP_LIMIT):
        integrations.slips[i] = falling.slips[i]
        integrations.noted[i] = falling.noted[i]
