"""Coupled strips: creep force of any patch, strip by strip.

Each strip has its stick zone and its slip zone (traction_integration.py), with the stiffness that it has beside the others
on one half-space (stiffness.py).  What an ellipse with the patch's area and length over width is known to
differ by from the complete theory comes to the sum (correction.py).  Sums over a strip:

    int p dx = sum_q p_q a pi/(n + 1) sin t_q - c (e - (0, k)) (pi/2) m (a - d)^2,   x_q = a cos t_q   (T1)
    int x p_y dx = sum_q x_q p_q,y a pi/(n + 1) sin t_q - c (e_y - k) (pi/2) m (a - d)^2 d            (T2)

in which the second root of eq. (Z1) is integrated exactly.  Written with (u, v) = d (e - (0, k)) nothing is
divided by d but what lies behind the edge: so for small creepages these are Kalker's linear theory.

Where a strip sticks is strip theory with a bound, made continuous.  In units of the bound's rate m the
creepages of a strip are u = -K1 w_x / m, v = -K2 w_y / m [m] and k = -K3 phi / m.  The strip sticks from -a +
2 d to its leading edge a, with the traction

    p = m (e sqrt(a^2 - x^2) - (e - (0, k)) sqrt((a - d)^2 - (x - d)^2))                         (Z1)
    e = (u, v + k d) / d,   d^2 (1 - k^2) - 2 v k d - (U + v^2) = 0,   U = u^2 + s^2             (Z2)

after Haines & Ollerton (1963) and Kalker (1967); without spin this is Carter's.  s^2 is twice the variance
of u over the strip's width, and a floor in long patches, where all strips would begin to slip at once as k
passes 1:

    s^2 = (K1 phi h / m)^2 / 6 + (0.3 min(1, r/4.5) min(|k|, 1.5)^2 a)^2,   r = a/b of the patch     (Z3)

Strips slip later than lines: u, v, k and s are taken 1 - (1/2) E f^2 / (d/a) times, E = 0.08 r / (1 + r),
f = 2 d/a - (d/a)^2, and eq. (Z2) is solved once more.                                            (Z4)

A strip carries more, the more its neighbours slip, which then help it less.  With its share of the force
of linear theory, g = 1 - d/(2 a) or a/(2 d) where d > a, and the mean G of the patch, weighted with K1 a h,
u and v are taken this many times as well, the second time:

    1 + 0.6 / (1 + 4 k^2) (g - G) / max(g, G)                                                    (Z6)

In an ellipse without spin all g are alike.  u has delta of eq. (K6) in it.

Where the stick zone of eq. (Z2) is about to be none, or asks for tractions beyond the bound at the leading
edge, its weight c falls smoothly from 1 to 0, so that no force jumps:  with S(z) = z^2 (3 - 2 z),
D = v^2 + (1 - k^2) U, t = sqrt(1 - d/a) and q = |e (1 - t) + (0, k) t|

    c = S(D/v^2) (1 - S(q - 1)) S((1 - d/a) / 0.1)                                               (Z5)

of which the first two count only for k^2 > 1, the first only for v k < 0.
"""

from math import fabs, pi, sqrt
from typing import Final

from ..layout import ROLLING_STRIP_LIMIT, Patch, Rolling, StripIntegration, RollingStrip, Tables
from .correction import correct_force
from .falling import open_falling
from .traction_integration import NOTHING, integrate_strips, open_integrations, set_pushes, set_stick
from .stiffness import patch_stiffnesses, stiffnesses_at
from .tractions import add_strip, bound_rate, patch_area, point_weight

#: E of eq. (Z4) in very long patches.
LATER: Final[float] = 0.08
#: Share of the strip over which its stick zone fades.
FADE: Final[float] = 0.1
#: How much more a strip carries whose neighbours slip, and how spin reduces that; eq. (Z6).
YIELD: Final[float] = 0.6
YIELD_TWIST: Final[float] = 4.0
#: Floor of eq. (Z3): its size, and the a/b and the |k| from which on it does not grow.
SPREAD_FLOOR: Final[float] = 0.3
FLOOR_RATIO: Final[float] = 4.5
FLOOR_TWIST: Final[float] = 1.5


def open_stick_zone(integration: StripIntegration, shift: float, width: float, ratio: float):
    """Depth and weight of a strip's stick zone as eq. (Z2) first has them, and the strip's share of linear
    theory, into its integration; its longitudinal creepage has a ``shift`` in it, ``width`` [m] is the strip's,
    ``ratio`` the patch's a/b."""
    a = integration.half_length
    inverse = 1.0 / integration.rate
    integration.stick_x = -integration.along * (integration.slip + shift) * inverse
    integration.stick_y = -integration.across * integration.lateral * inverse
    integration.twist = -integration.turning * integration.spin * inverse
    integration.spread = spread_square(integration, width * inverse, integration.twist, ratio)
    depth, weight = slip_depth(
        integration.stick_x * integration.stick_x + integration.spread,
        integration.stick_y,
        integration.twist,
        a,
    )
    integration.depth = depth
    integration.weight = weight
    if depth < a:
        integration.carried = weight * (1.0 - 0.5 * depth / a)
    else:
        integration.carried = weight * (0.5 * a / depth)


def find_stick_zone(integration: StripIntegration, mean: float, ratio: float):
    """Depth, direction and weight of a strip's stick zone, into its integration; ``mean`` is the patch's share of
    linear theory."""
    a = integration.half_length
    share = later_share(integration.depth / a, ratio)
    yielding = YIELD / (1.0 + YIELD_TWIST * integration.twist * integration.twist)
    push = share * (
        1.0 + yielding * (integration.carried - mean) / (max(integration.carried, mean) + NOTHING)
    )
    u = push * integration.stick_x
    v = push * integration.stick_y
    k = share * integration.twist
    depth, weight = slip_depth(u * u + share * share * integration.spread, v, k, a)
    weight = min(weight, integration.weight)
    integration.depth = a
    integration.weight = 0.0
    integration.twist = k
    integration.stick_x = 0.0
    integration.stick_y = 0.0
    integration.lead_x = u
    integration.lead_y = v
    if weight > 0.0 and depth < a:
        integration.depth = depth
        integration.stick_x = u / (depth + NOTHING)
        integration.stick_y = v / (depth + NOTHING) + k
        integration.weight = weight * smooth_step((1.0 - depth / a) / FADE) * edge_weight(integration)
    integration.edge = 2.0 * integration.depth - a


def spread_square(integration: StripIntegration, scale: float, k: float, ratio: float):
    """s^2 [m^2] of eq. (Z3); ``scale`` is the strip's width over m."""
    over_width = integration.along * integration.spin * scale
    twist = min(fabs(k), FLOOR_TWIST)
    long = min(ratio / FLOOR_RATIO, 1.0)
    floor = SPREAD_FLOOR * long * twist * twist * integration.half_length
    return over_width * over_width / 6.0 + floor * floor


def slip_depth(square: float, v: float, k: float, a: float):
    """d of eq. (Z2) [m] for ``square`` = U, and the first factor of eq. (Z5); a weight of 0 is no stick
    zone."""
    rest = 1.0 - k * k
    cross = v * k
    spread = v * v + rest * square
    depth = 2.0 * a
    weight = 0.0
    if spread > 0.0 or (rest > 0.0 and spread == 0.0):
        root = sqrt(spread)
        if cross <= 0.0:
            depth = (square + v * v) / (root - cross + NOTHING)
            weight = 1.0
            if rest < 0.0:
                weight = smooth_step(spread / (v * v + NOTHING))
        elif rest > 0.0:
            depth = (cross + root) / rest
            weight = 1.0
    return depth, weight


def later_share(depth: float, ratio: float):
    """The factor of eq. (Z4) for d/a = ``depth``."""
    filled = 1.0
    share = 1.0
    if depth < 1.0:
        filled = depth * (2.0 - depth)
    if depth > 0.0:
        share = 1.0 - 0.5 * LATER * ratio / (1.0 + ratio) * filled * (filled / depth)
    return share


def edge_weight(integration: StripIntegration):
    """The second factor of eq. (Z5)."""
    weight = 1.0
    if integration.twist * integration.twist > 1.0:
        t = sqrt(1.0 - integration.depth / integration.half_length)
        along = integration.stick_x * (1.0 - t)
        across = integration.stick_y * (1.0 - t) + integration.twist * t
        weight = 1.0 - smooth_step(sqrt(along * along + across * across) - 1.0)
    return weight


def smooth_step(z: float):
    """S: from 0 at 0 to 1 at 1."""
    value = 0.0
    if z >= 1.0:
        value = 1.0
    elif z > 0.0:
        value = z * z * (3.0 - 2.0 * z)
    return value


def solve_coupled_strips(tables: Tables, rolling: Rolling, patch: Patch):
    """Force, moment, stick share and largest traction of a patch."""
    patch_stiffnesses(tables, rolling, patch)
    share = add_strips(tables, rolling, patch)
    if not rolling.bare:
        correct_force(tables, patch, share)
    patch.friction *= share


def add_strips(tables: Tables, rolling: Rolling, patch: Patch):
    """What the strips add up to, without correction; friction's share of that of rest."""
    integrations = rolling.integrations
    ratio = patch.half_length / patch.half_width
    plane, spinning = flexibilities(patch)
    open_integrations(integrations, ratio)
    mean = open_stick_zones(rolling, patch, ratio)
    falls = patch.fall_rate > 0.0
    if falls:
        open_falling(rolling.falling, patch)
    stuck = 0.0
    for i in range(ROLLING_STRIP_LIMIT):
        integration = rolling.begun[i]
        if integration.rate > 0.0:
            find_stick_zone(integration, mean, ratio)
            set_pushes(integration, integrations, i, plane, spinning, ratio)
            set_stick(tables.rolling, integration, integrations, i)
            stuck += (
                2.0
                * (integration.half_length - integration.depth)
                * integration.weight
                * patch.strips[i].width
            )
    integrate_strips(tables.rolling, integrations, rolling.falling, falls)
    finish_integrations(rolling, patch)
    patch.stick_share = stuck / patch_area(patch)
    share = 1.0
    if falls:
        share = 1.0 - lost_friction(rolling, patch) / (patch.friction * patch.totals.load)
    return share


def open_stick_zones(rolling: Rolling, patch: Patch, ratio: float):
    """The strips' stick zones as they first are; the mean of their shares of linear theory."""
    carried = 0.0
    whole = 0.0
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        integration = rolling.begun[i]
        integration.rate = bound_rate(patch, strip)
        if integration.rate > 0.0:
            begin_integration(rolling, integration, strip, i)
            open_stick_zone(integration, rolling.shift, strip.width, ratio)
            weight = integration.along * integration.half_length * strip.width
            whole += weight
            carried += weight * integration.carried
    return carried / (whole + NOTHING)


def flexibilities(patch: Patch):
    """i1/K1 and i3/K3 [1/m] of eq. (M3)."""
    first = 0.0
    second = 0.0
    third = 0.0
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        area = strip.half_length * strip.width
        first += area
        second += area * strip.half_length
        third += area * strip.half_length * strip.half_length
    return 0.5 * pi * first / second, 0.75 * pi * second / third


def begin_integration(rolling: Rolling, integration: StripIntegration, strip: RollingStrip, index: int):
    """Creepages and stiffnesses of a strip, into its ``integration``."""
    integration.half_length = strip.half_length
    integration.slip = strip.slip
    integration.lateral = strip.lateral
    integration.spin = strip.spin
    along, across, turning = stiffnesses_at(rolling.blocks, index, strip.station)
    integration.along = along
    integration.across = across
    integration.turning = turning


def finish_integrations(rolling: Rolling, patch: Patch):
    """Add the strips' forces, eqs. (T1), (T2), and find the largest traction."""
    integrations = rolling.integrations
    largest = 0.0
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        unit = bound_rate(patch, strip) * strip.half_length
        square = integrations.largest[i] * unit * unit
        largest = max(largest, square)
        if unit > 0.0:
            unit *= point_weight(strip)
            add_strip(
                patch,
                strip,
                unit * integrations.sum_x[i],
                unit * integrations.sum_y[i],
                unit * strip.half_length * integrations.sum_moment[i],
            )
    patch.max_shear = sqrt(largest)


def lost_friction(rolling: Rolling, patch: Patch):
    """How much of the bound on its force a patch loses where friction falls [N]."""
    lost = 0.0
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        unit = bound_rate(patch, strip) * strip.half_length * point_weight(strip) * strip.width
        lost += unit * rolling.falling.lost[i]
    return lost
