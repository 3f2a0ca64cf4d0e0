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
    StripIntegration,
    RollingStrip,
    RollingTable,
    Tables,
)
from .falling import point_share
from .fastsim import stiffnesses, strip_push
from .tractions import add_strip, bound_rate, cut_to, kalker_coefficients, patch_area, point_weight


def solve_fastrip(tables: Tables, rolling: Rolling, patch: Patch):
    """Force, moment, stick share and largest traction of a patch."""
    integration = rolling.integration
    along, across, turning = stiffnesses(tables, patch)
    set_stiffnesses(tables, patch, integration)
    integration.largest = 0.0
    stuck = 0.0
    lost = 0.0
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        rate = bound_rate(patch, strip)
        if rate > 0.0:
            integration.half_length = strip.half_length
            integration.rate = rate
            slanted = strip.spin * strip.x
            find_stick(integration, longitudinal(tables, rolling, patch, strip), strip.lateral, strip.spin)
            integration.push_x = strip_push(rolling, patch, strip, along, turning)
            integration.push_y = (strip.lateral - slanted) * across + slanted * turning
            integration.push_turn = strip.spin * turning
            lost += add_tractions(tables.rolling, patch, integration, strip)
            stuck += 2.0 * (integration.half_length - integration.depth) * strip.width
    patch.friction -= lost / patch.totals.load
    patch.max_shear = sqrt(integration.largest)
    patch.stick_share = stuck / patch_area(patch)


def set_stiffnesses(tables: Tables, patch: Patch, integration: StripIntegration):
    """K1, K2, K3 of all strips; eq. (A1)."""
    ratio = patch.half_length / patch.half_width
    first, second, third = kalker_coefficients(tables.rolling, ratio)
    modulus = tables.shear_modulus
    integration.along = 2.0 * first * modulus / (pi * pi)
    integration.across = 2.0 * second * modulus / (pi * pi)
    integration.turning = 1.5 * third * modulus / (pi * sqrt(ratio))


def longitudinal(tables: Tables, rolling: Rolling, patch: Patch, strip: RollingStrip):
    """K1 w_x of a strip [Pa]."""
    integration = rolling.integration
    push = integration.along * strip.slip
    if rolling.published:
        push = integration.along * patch.creepage_x + integration.turning * (
            strip.slip - patch.creepage_x
        ) / (1.0 - tables.parameters.poisson_ratio)
    return push


def find_stick(integration: StripIntegration, push: float, lateral: float, spin: float):
    """Depth of the slip zone and direction of the stick zone of a strip; ``push`` = K1 w_x."""
    u = -push / integration.rate
    v = -integration.across * lateral / integration.rate
    k = -integration.turning * spin / integration.rate
    rest = 1.0 - k * k
    cross = v * k
    spread = v * v + rest * u * u
    depth = 2.0 * integration.half_length
    if rest > 0.0:
        root = sqrt(spread)
        depth = root + cross
        if cross < 0.0:
            # the same without cancellation
            depth = (u * u + v * v) / (root - cross) * rest
        depth /= rest
    elif cross < 0.0 and spread > 0.0:
        depth = (u * u + v * v) / (sqrt(spread) - cross)
    integration.twist = k
    integration.depth = integration.half_length
    integration.lead_x = u
    integration.lead_y = v
    integration.stick_x = 0.0
    integration.stick_y = 0.0
    if depth < integration.half_length:
        integration.depth = depth
        integration.stick_x = u / (depth + 1e-300)
        integration.stick_y = v / (depth + 1e-300) + k
    integration.edge = 2.0 * integration.depth - integration.half_length


def add_tractions(table: RollingTable, patch: Patch, integration: StripIntegration, strip: RollingStrip):
    """Add a strip's force from its tractions; what its bound loses where friction falls [N].

    The stick zone's are those of strip theory without end, integrated exactly as in eqs. (T1), (T2), but for
    the points behind its edge, and for what the bound cuts.
    """
    a = integration.half_length
    integration.x = a
    integration.first_x = 0.0
    integration.first_y = 0.0
    lost = 0.0
    open_stick(integration)
    for q in range(POINT_LIMIT):
        x = a * table.cosines[q]
        bound = integration.rate * a * table.sines[q]
        integrate_on(integration, x, bound)
        p_x, p_y = slip_direction(integration, bound)
        without_x = integration.stick_x * bound
        without_y = integration.stick_y * bound
        if x > integration.edge:
            without_x, without_y = stick_traction(integration, x, bound)
            p_x, p_y = cut_to(without_x, without_y, bound)
        elif patch.fall_rate > 0.0:
            share = point_share(patch, strip, x)
            p_x *= share
            p_y *= share
            lost += table.sines[q] * bound * (1.0 - share)
        square = p_x * p_x + p_y * p_y
        integration.largest = max(integration.largest, square)
        integration.sum_x += table.sines[q] * (p_x - without_x)
        integration.sum_y += table.sines[q] * (p_y - without_y)
        integration.sum_moment += table.sines[q] * x * (p_y - without_y)
    weight = point_weight(strip)
    add_strip(
        patch, strip, weight * integration.sum_x, weight * integration.sum_y, weight * integration.sum_moment
    )
    return weight * strip.width * lost


def open_stick(integration: StripIntegration):
    """Sums over the points of strip theory's traction without end; nothing where all of a strip slips."""
    integration.sum_x = 0.0
    integration.sum_y = 0.0
    integration.sum_moment = 0.0
    if integration.depth < integration.half_length:
        depth = integration.depth / integration.half_length
        whole = 0.5 * float(POINT_LIMIT + 1) * integration.rate
        integration.sum_x = whole * integration.lead_x * (2.0 - depth)
        integration.sum_y = whole * (
            integration.lead_y * (2.0 - depth) + integration.twist * integration.half_length
        )
        integration.sum_moment = (
            -whole * integration.lead_y * integration.half_length * (1.0 - depth) * (1.0 - depth)
        )


def integrate_on(integration: StripIntegration, x: float, bound: float):
    """FASTSIM's traction at the next point ``x``."""
    step = integration.x - x
    across = integration.push_y + integration.push_turn * (x + 0.5 * step)
    p_x, p_y = cut_to(
        integration.first_x - step * integration.push_x, integration.first_y - step * across, bound
    )
    integration.x = x
    integration.first_x = p_x
    integration.first_y = p_y


def slip_direction(integration: StripIntegration, bound: float):
    """The bound in the direction of FASTSIM's traction."""
    p_x = integration.first_x
    p_y = integration.first_y
    size = sqrt(p_x * p_x + p_y * p_y)
    if size > 0.0:
        p_x *= bound / size
        p_y *= bound / size
    return p_x, p_y


def stick_traction(integration: StripIntegration, x: float, bound: float):
    """The traction of strip theory at ``x`` in the stick zone, eq. (Z1), in a form that is regular where no
    depth slips."""
    reach = integration.half_length - integration.depth
    root = integration.rate * sqrt(
        max(reach * reach - (x - integration.depth) * (x - integration.depth), 0.0)
    )
    lead = 2.0 * integration.rate * integration.rate * (integration.half_length - x) / (bound + root)
    return integration.lead_x * lead, integration.lead_y * lead + integration.twist * bound
