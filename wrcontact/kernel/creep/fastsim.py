"""FASTSIM, Kalker's simplified theory.

J. J. Kalker, A fast algorithm for the simplified theory of rolling contact, Vehicle System Dynamics 11 (1982)
1-13.  The surface gives way like u = L p, so that along a strip, in the direction of rolling,

    dp_x/dx = (xi - phi y) / L1,   dp_y/dx = eta / L2 + phi x / L3                              (F1)
    L1 = 8 a / (3 C11 G),  L2 = 8 a / (3 C22 G),  L3 = pi a sqrt(a/b) / (4 C23 G)               (F2)

from zero at the leading edge, cut to the bound.  a, b and the coefficients are those of the ellipse with the
patch's area and length over width.  As published, -phi y has the flexibility L3; with L1, which is that of
all longitudinal creepage, the force is closer to the complete theory.  The bound is that of the pressure,
mu p0 sqrt(1 - (x/a)^2).  Where L1 and L2 differ, the force of full slip does not point quite against the
slip: up to 10 degrees.

Where friction falls, tractions that were cut count with its share (falling.py); those of which the cut takes
next to nothing between that share and 1, so that the force is continuous.
"""

from math import pi, sqrt
from typing import Final

from ..layout import POINT_LIMIT, ROLLING_STRIP_LIMIT, Patch, Rolling, RollingStrip, RollingTable, Tables
from .falling import point_share
from .tractions import add_strip, bound_rate, cut_to, kalker_coefficients, patch_area, point_weight


#: What the cut takes of the traction that a step pushes, from where on a point counts as one that slips.
NEAR_STICK: Final[float] = 0.1


def solve_fastsim(tables: Tables, rolling: Rolling, patch: Patch):
    """Force, moment, stick share and largest traction of a patch."""
    along, across, turning = stiffnesses(tables, patch)
    stuck = 0.0
    lost = 0.0
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        rate = bound_rate(patch, strip)
        if rate > 0.0:
            push = strip_push(rolling, patch, strip, along, turning)
            sticks, loses = integrate_strip(tables.rolling, patch, strip, rate, push, across, turning)
            stuck += sticks
            lost += loses
    patch.friction -= lost / patch.totals.load
    area = patch_area(patch)
    if area > 0.0:
        patch.stick_share = stuck / area


def stiffnesses(tables: Tables, patch: Patch):
    """1/L1, 1/L2, 1/L3 [Pa/m]; eq. (F2)."""
    a = patch.half_length
    ratio = a / patch.half_width
    first, second, third = kalker_coefficients(tables.rolling, ratio)
    modulus = tables.shear_modulus
    return (
        3.0 * first * modulus / (8.0 * a),
        3.0 * second * modulus / (8.0 * a),
        4.0 * third * modulus / (pi * a * sqrt(ratio)),
    )


def strip_push(rolling: Rolling, patch: Patch, strip: RollingStrip, along: float, turning: float):
    """dp_x/dx of a strip [Pa/m]; eq. (F1)."""
    push = strip.slip * along
    if rolling.published:
        push = patch.creepage_x * along + (strip.slip - patch.creepage_x) * turning
    return push


def integrate_strip(
    table: RollingTable,
    patch: Patch,
    strip: RollingStrip,
    rate: float,
    push: float,
    across: float,
    turning: float,
):
    """Add a strip's force from its tractions; the area that sticks [m^2], and what its bound loses where
    friction falls [N]."""
    a = strip.half_length
    slanted = strip.spin * strip.x
    lateral = (strip.lateral - slanted) * across + slanted * turning
    turn = strip.spin * turning
    before = a
    p_x = 0.0
    p_y = 0.0
    force_x = 0.0
    force_y = 0.0
    moment = 0.0
    stuck = 0.0
    total = 0.0
    lost = 0.0
    falls = patch.fall_rate > 0.0
    largest = patch.max_shear * patch.max_shear
    for q in range(POINT_LIMIT):
        x = a * table.cosines[q]
        weight = table.sines[q]
        step = before - x
        free_x = p_x - step * push
        free_y = p_y - step * (lateral + turn * (x + 0.5 * step))
        bound = rate * a * weight
        last_x = p_x
        last_y = p_y
        p_x, p_y = cut_to(free_x, free_y, bound)
        along = p_x
        sideways = p_y
        if p_x == free_x and p_y == free_y:
            stuck += weight
        elif falls:
            share = point_share(patch, strip, x)
            share += (1.0 - share) * sticking(free_x, free_y, free_x - last_x, free_y - last_y, bound)
            along *= share
            sideways *= share
            lost += weight * bound * (1.0 - share)
        total += weight
        square = along * along + sideways * sideways
        largest = max(largest, square)
        force_x += weight * along
        force_y += weight * sideways
        moment += weight * x * sideways
        before = x
    patch.max_shear = sqrt(largest)
    weight = point_weight(strip)
    add_strip(patch, strip, weight * force_x, weight * force_y, weight * moment)
    return 2.0 * a * strip.width * stuck / total, weight * strip.width * lost


def sticking(free_x: float, free_y: float, push_x: float, push_y: float, bound: float):
    """How much a point that is about to slip counts as one that sticks: 1 where the cut takes nothing of the
    traction that a step has pushed by so much, 0 from a share of the push on."""
    excess = sqrt(free_x * free_x + free_y * free_y) - bound
    part = 0.0
    push = NEAR_STICK * sqrt(push_x * push_x + push_y * push_y)
    if excess < push:
        part = 1.0 - max(excess, 0.0) / push
    return part
