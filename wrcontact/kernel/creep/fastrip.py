"""FaStrip: strip theory in the stick zone, FASTSIM's direction in the slip zone.

M. Sh. Sichani, R. Enblom, M. Berg, An alternative to FASTSIM for tangential solution of the wheel-rail
contact, Vehicle System Dynamics 54 (2016) 748-764.  Strip theory (eqs. (Z1), (Z2) of coupled_strips.py, there
with s = 0) has the stiffnesses that give Kalker's force for an ellipse,

    K1 = 2 C11 G / pi^2,   K2 = 2 C22 G / pi^2,   K3 = 3 C23 G sqrt(b/a) / (2 pi)                (A1)

the same in all strips.  A strip that has no stick zone, or one that is longer than itself, slips all over.
Where a strip slips its traction is the bound, in the direction that FASTSIM's traction has there.  As
published, -phi y has the stiffness K3 / (1 - nu) in strip theory and L3 in FASTSIM; with those of
longitudinal creepage, K1 and L1, the force is closer to the complete theory.  Where friction falls, the slip
zone's tractions count with its share (falling.py).

The force is not continuous: strips begin to slip all over while their stick zone has a length.
"""

from math import pi, sqrt

from ..layout import (
    POINT_LIMIT,
    ROLLING_STRIP_LIMIT,
    Patch,
    Rolling,
    RollingMarch,
    RollingStrip,
    RollingTable,
    Tables,
)
from .falling import point_share
from .fastsim import stiffnesses, strip_push
from .tractions import add_strip, bound_rate, cut_to, kalker_coefficients, patch_area, point_weight


def solve_fastrip(tables: Tables, rolling: Rolling, patch: Patch):
    """Force, moment, stick share and largest traction of a patch."""
    march = rolling.march
    along, across, turning = stiffnesses(tables, patch)
    set_stiffnesses(tables, patch, march)
    march.largest = 0.0
    stuck = 0.0
    lost = 0.0
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        rate = bound_rate(patch, strip)
        if rate > 0.0:
            march.half_length = strip.half_length
            march.rate = rate
            slanted = strip.spin * strip.x
            find_stick(march, longitudinal(tables, rolling, patch, strip), strip.lateral, strip.spin)
            march.push_x = strip_push(rolling, patch, strip, along, turning)
            march.push_y = (strip.lateral - slanted) * across + slanted * turning
            march.push_turn = strip.spin * turning
            lost += add_tractions(tables.rolling, patch, march, strip)
            stuck += 2.0 * (march.half_length - march.depth) * strip.width
    patch.friction -= lost / patch.totals.load
    patch.max_shear = sqrt(march.largest)
    patch.stick_share = stuck / patch_area(patch)


def set_stiffnesses(tables: Tables, patch: Patch, march: RollingMarch):
    """K1, K2, K3 of all strips; eq. (A1)."""
    ratio = patch.half_length / patch.half_width
    first, second, third = kalker_coefficients(tables.rolling, ratio)
    modulus = tables.shear_modulus
    march.along = 2.0 * first * modulus / (pi * pi)
    march.across = 2.0 * second * modulus / (pi * pi)
    march.turning = 1.5 * third * modulus / (pi * sqrt(ratio))


def longitudinal(tables: Tables, rolling: Rolling, patch: Patch, strip: RollingStrip):
    """K1 w_x of a strip [Pa]."""
    march = rolling.march
    push = march.along * strip.slip
    if rolling.published:
        push = march.along * patch.creepage_x + march.turning * (strip.slip - patch.creepage_x) / (
            1.0 - tables.parameters.poisson_ratio
        )
    return push


def find_stick(march: RollingMarch, push: float, lateral: float, spin: float):
    """Depth of the slip zone and direction of the stick zone of a strip; ``push`` = K1 w_x."""
    u = -push / march.rate
    v = -march.across * lateral / march.rate
    k = -march.turning * spin / march.rate
    rest = 1.0 - k * k
    cross = v * k
    spread = v * v + rest * u * u
    depth = 2.0 * march.half_length
    if rest > 0.0:
        root = sqrt(spread)
        depth = root + cross
        if cross < 0.0:
            # the same without cancellation
            depth = (u * u + v * v) / (root - cross) * rest
        depth /= rest
    elif cross < 0.0 and spread > 0.0:
        depth = (u * u + v * v) / (sqrt(spread) - cross)
    march.twist = k
    march.depth = march.half_length
    march.lead_x = u
    march.lead_y = v
    march.stick_x = 0.0
    march.stick_y = 0.0
    if depth < march.half_length:
        march.depth = depth
        march.stick_x = u / (depth + 1e-300)
        march.stick_y = v / (depth + 1e-300) + k
    march.edge = 2.0 * march.depth - march.half_length


def add_tractions(table: RollingTable, patch: Patch, march: RollingMarch, strip: RollingStrip):
    """Add a strip's force from its tractions; what its bound loses where friction falls [N].

    The stick zone's are those of strip theory without end, integrated exactly as in eqs. (T1), (T2), but for
    the points behind its edge, and for what the bound cuts.
    """
    a = march.half_length
    march.x = a
    march.first_x = 0.0
    march.first_y = 0.0
    lost = 0.0
    open_stick(march)
    for q in range(POINT_LIMIT):
        x = a * table.cosines[q]
        bound = march.rate * a * table.sines[q]
        march_on(march, x, bound)
        p_x, p_y = slip_direction(march, bound)
        without_x = march.stick_x * bound
        without_y = march.stick_y * bound
        if x > march.edge:
            without_x, without_y = stick_traction(march, x, bound)
            p_x, p_y = cut_to(without_x, without_y, bound)
        elif patch.fall_rate > 0.0:
            share = point_share(patch, strip, x)
            p_x *= share
            p_y *= share
            lost += table.sines[q] * bound * (1.0 - share)
        square = p_x * p_x + p_y * p_y
        march.largest = max(march.largest, square)
        march.sum_x += table.sines[q] * (p_x - without_x)
        march.sum_y += table.sines[q] * (p_y - without_y)
        march.sum_moment += table.sines[q] * x * (p_y - without_y)
    weight = point_weight(strip)
    add_strip(patch, strip, weight * march.sum_x, weight * march.sum_y, weight * march.sum_moment)
    return weight * strip.width * lost


def open_stick(march: RollingMarch):
    """Sums over the points of strip theory's traction without end; nothing where all of a strip slips."""
    march.sum_x = 0.0
    march.sum_y = 0.0
    march.sum_moment = 0.0
    if march.depth < march.half_length:
        depth = march.depth / march.half_length
        whole = 0.5 * float(POINT_LIMIT + 1) * march.rate
        march.sum_x = whole * march.lead_x * (2.0 - depth)
        march.sum_y = whole * (march.lead_y * (2.0 - depth) + march.twist * march.half_length)
        march.sum_moment = -whole * march.lead_y * march.half_length * (1.0 - depth) * (1.0 - depth)


def march_on(march: RollingMarch, x: float, bound: float):
    """FASTSIM's traction at the next point ``x``."""
    step = march.x - x
    across = march.push_y + march.push_turn * (x + 0.5 * step)
    p_x, p_y = cut_to(march.first_x - step * march.push_x, march.first_y - step * across, bound)
    march.x = x
    march.first_x = p_x
    march.first_y = p_y


def slip_direction(march: RollingMarch, bound: float):
    """The bound in the direction of FASTSIM's traction."""
    p_x = march.first_x
    p_y = march.first_y
    size = sqrt(p_x * p_x + p_y * p_y)
    if size > 0.0:
        p_x *= bound / size
        p_y *= bound / size
    return p_x, p_y


def stick_traction(march: RollingMarch, x: float, bound: float):
    """The traction of strip theory at ``x`` in the stick zone, eq. (Z1), in a form that is regular where no
    depth slips."""
    reach = march.half_length - march.depth
    root = march.rate * sqrt(max(reach * reach - (x - march.depth) * (x - march.depth), 0.0))
    lead = 2.0 * march.rate * march.rate * (march.half_length - x) / (bound + root)
    return march.lead_x * lead, march.lead_y * lead + march.twist * bound
