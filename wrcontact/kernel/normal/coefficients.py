"""Hertz's coefficients and closed-form contact, through a table of exact values, and ANALYN's at nodes.

With q the ratio of the short to the long semi-axis, K, E the complete elliptic integrals of modulus
sqrt(1 - q^2) and L^3 = 2 E / (pi q^2),

    A > B (long across):   m = L q,  n = L,    r = 2 K / (pi L)
    A < B:                 m = L,    n = L q,  r the same

so that the three combinations ANALYN needs are functions of B/A alone:

    1 + alpha = (r / m^2)(1 + B/A),    1 + beta = (r / n^2)(1 + A/B),    n r

and 1 + beta at B/A is 1 + alpha at A/B.  The table holds quintics over 32 even cells in each octave of B/A,
where an exponent and a difference find the place, exact to 1e-12
(tools/tables/exact_tables.py).

ANALYN's coefficients at the nodes of a region follow from the longitudinal curvature and lateral ones.
Second differences over a window (the curvature averaged with a triangle) are smooth but blind to what lies
beyond; the secant g/t^2 knows how far the surfaces have parted but lags behind.  Each coefficient takes what
it depends on: 1 + beta the secant of its side, 1 + alpha that of the node, n r a mean of both; equations
(8.1) to (8.3) of docs/theory/curvature.md.

That is the lateral curvature "adaptive".  "smooth" and "rough" are the source's, prepared for each profile
(:mod:`curvature`), one B in all three places; where it is below FLOOR A it counts as that.
"""

from math import fabs, sqrt
from typing import Final

from ..elementary.binary import exponent, power_of_two
from ..layout import (
    HERTZ_CELLS,
    HERTZ_OCTAVES,
    HERTZ_ROW,
    LATERAL_ADAPTIVE,
    HertzTable,
    NodeRun,
    Nodes,
    Region,
    Tables,
)

#: Principal curvatures closer than this share are one: the ellipse is a circle.
TILTED: Final[float] = 1e-12
STEEPEST_SLANT: Final[float] = 0.3
#: Smallest lateral curvature as a share of the longitudinal one; B <= 0 inside the patch is the normal case
#: on treads.
FLOOR: Final[float] = 0.02
#: Smallest windowed curvature as a share of the secant's, and how much of what it exceeds that by is taken at
#: the edge.
WINDOW_FLOOR: Final[float] = 0.05
GROWTH: Final[float] = 0.12
#: Range of the table of Hertz's coefficients: 2^-26 to the last float below 2^26.
LEAST_RATIO: Final[float] = 1.4901161193847656e-08
MOST_RATIO: Final[float] = 67108863.999999993


def table_value(table: HertzTable, column: int, ratio: float):
    """Value of column 0 (1 + alpha) or 6 (n r) at the ``ratio`` B/A; clamped to the table's range."""
    ratio = min(max(LEAST_RATIO, ratio), MOST_RATIO)
    octave = exponent(ratio)
    place = float(HERTZ_CELLS) * (ratio * power_of_two(-octave) - 1.0)
    cell = int(place)
    u = place - float(cell)
    at = HERTZ_ROW * (HERTZ_CELLS * (octave + HERTZ_OCTAVES) + cell) + column
    high = table.rows[at + 3] + u * (table.rows[at + 4] + u * table.rows[at + 5])
    return table.rows[at] + u * (table.rows[at + 1] + u * (table.rows[at + 2] + u * high))


def hertz_coefficients(table: HertzTable, A: float, B: float):
    """1 + alpha, 1 + beta and n r for the separation A x^2 + B s^2; both positive."""
    ratio = B / A
    return table_value(table, 0, ratio), table_value(table, 0, A / B), table_value(table, 6, ratio)


def skewed_coefficients(table: HertzTable, A: float, B: float, slant: float):
    """1 + alpha, 1 + beta and n r for the separation A (x - slant s)^2 + B s^2 of a yawed wheel.

    Its principal curvatures, of product A B, give a tilted ellipse.  Cut along x at the station s it is an
    upright one again, which is all that ANALYN asks of it: half-length 0 where (1 + beta) B s^2 is the
    penetration, and at s = 0 a half-length a with (1 + alpha) A a^2 the penetration and n r for its
    pressure.  Exact for constant curvatures.

    Where the lateral curvature has fallen to its floor, a slant would make a long oblique ellipse of what is
    a patch's edge: A slant^2 counts as STEEPEST_SLANT B at most.
    """
    if A * slant * slant > STEEPEST_SLANT * B:
        slant = sqrt(STEEPEST_SLANT * B / A)
    cross = A * slant
    diagonal = B + cross * slant
    half = 0.5 * (A - diagonal)
    spread = sqrt(half * half + cross * cross)
    large = 0.5 * (A + diagonal) + spread
    small = A * B / large
    along, across, nr = hertz_coefficients(table, small, large)
    along *= small
    across *= large
    # the square of the cosine of the long axis' angle to x; a circle has no long axis
    cosine = 0.5
    if spread > TILTED * large:
        cosine = 0.5 - 0.5 * half / spread
    length = cosine * along + (1.0 - cosine) * across
    width = along * across / (cosine * along + (1.0 - cosine) * across)
    return length / A, width / B, nr * sqrt(length / along)


def middle_slant(table: HertzTable, A: float, B: float, slant: float):
    """dx/ds of the line through the middles of the ellipse's chords along x, for a gap whose ridge has this
    ``slant``; steep ones are taken as there."""
    if A * slant * slant > STEEPEST_SLANT * B:
        slant = sqrt(STEEPEST_SLANT * B / A) * slant / fabs(slant)
    cross = A * slant
    diagonal = B + cross * slant
    half = 0.5 * (A - diagonal)
    spread = sqrt(half * half + cross * cross)
    large = 0.5 * (A + diagonal) + spread
    small = A * B / large
    if not spread > TILTED * large:
        return slant
    along, across, nr = hertz_coefficients(table, small, large)
    along *= small
    across *= large
    cosine = 0.5 - 0.5 * half / spread
    length = cosine * along + (1.0 - cosine) * across
    return cross * (across - along) / ((large - small) * length)


def hertz_stiffness(one_beta: float, nr: float, B: float, contact_modulus: float):
    """N / penetration^(3/2) [N/m^1.5], from 1 + beta and n r.

    N = integral of E* d / (n r) over the width with d = penetration - (1 + beta) B s^2: eq. (2.15) of Hertz's
    closed form in ANALYN's coefficients, (4/3) E* / (n r sqrt((1 + beta) B)).
    """
    return 4.0 / 3.0 * contact_modulus / (nr * sqrt(one_beta * B))


def second_difference(values: NodeRun, k: int, spacing: float, window: int):
    """Half the second derivative [1/m] of the values at node ``k``, averaged with a triangle of half-width
    window h."""
    width = spacing * float(window)
    return (values[k + window] - 2.0 * values[k] + values[k - window]) / (2.0 * width * width)


def secant_curvature(gaps: NodeRun, k: int, spacing: float, window: int, middle: float):
    """g / s^2 [1/m] at node ``k``; within the window a blend from ``middle`` to the secant at its end."""
    if k >= window or k <= -window:
        s = spacing * float(k)
        return gaps[k] / (s * s)
    width = spacing * float(window)
    edge = gaps[window] / (width * width)
    if k < 0:
        edge = gaps[-window] / (width * width)
    return middle + (edge - middle) * fabs(float(k)) / float(window)


def windowed_curvature(averaged: float, secant: float, share: float):
    """sqrt(B_w (B_s + GROWTH share max(B_w - B_s, 0))) [1/m], with B_w not below WINDOW_FLOOR B_s."""
    averaged = max(averaged, WINDOW_FLOOR * secant)
    grown = secant
    if averaged > secant:
        grown += GROWTH * share * (averaged - secant)
    return sqrt(averaged * grown)


def adaptive_curvatures(
    region: Region, gaps: NodeRun, k: int, window: int, middle: float, mean: float, least: float
):
    """The three lateral curvatures [1/m] at node ``k``, for 1 + alpha, 1 + beta and n r: secant, side and
    window; none below ``least``."""
    spacing = region.spacing
    secant = max(secant_curvature(gaps, k, spacing, window, middle), least)
    share = min(fabs(float(k)) * spacing / mean, 1.0)
    B = max(windowed_curvature(second_difference(gaps, k, spacing, window), secant, share), least)
    side = region.side_high
    if k < 0:
        side = region.side_low
    side = max(side, least)
    return secant, side, B


def weigh_nodes(tables: Tables, region: Region, nodes: Nodes, window: int, yawed: bool, filling: bool):
    """ANALYN's coefficients at the nodes of a region: (1 + beta) g, E*/(n r) and (1 + alpha) A, each with its
    own B, or all with the prepared one.  ``window`` : of the lateral curvature, in nodes; ``yawed`` : 1 or
    0; ``filling`` : whether there will be patches, which alone read (1 + alpha) A beside the minimum."""
    table = tables.hertz
    prepared = tables.lateral != LATERAL_ADAPTIVE
    alpha_factor = 1.0
    beta_factor = 1.0
    nr_factor = 1.0
    if yawed:
        alpha_factor, beta_factor, nr_factor = skew_factors(tables, region, nodes.A[0])
    mean = 0.5 * (region.width_low + region.width_high)
    middle = max(second_difference(nodes.gap, 0, region.spacing, window), 0.0)
    for k in range(region.first, region.last + 1):
        A = nodes.A[k]
        least = FLOOR * A
        if prepared:
            B = max(nodes.B[k], least)
            secant = B
            side = B
        else:
            secant, side, B = adaptive_curvatures(region, nodes.gap, k, window, middle, mean, least)
        beta = table_value(table, 0, A / side)
        nr = table_value(table, 6, B / A)
        if yawed:
            beta *= beta_factor
            nr *= nr_factor
        nodes.B[k] = B
        nodes.rise[k] = beta * nodes.gap[k]
        nodes.line[k] = tables.contact_modulus / nr
        if filling or k == 0:
            alpha = table_value(table, 0, secant / A)
            if yawed:
                alpha *= alpha_factor
            nodes.length[k] = alpha * A


def skew_factors(tables: Tables, region: Region, A: float):
    """Factors of 1 + alpha, 1 + beta and n r for all nodes of a region, from the slant of a yawed wheel's
    ridge: its mean slant and curvature, with ``A`` [1/m] at the minimum."""
    table = tables.hertz
    B = max(0.5 * (region.side_low + region.side_high), FLOOR * A)
    alpha, beta, nr = hertz_coefficients(table, A, B)
    skewed_alpha, skewed_beta, skewed_nr = skewed_coefficients(table, A, B, region.slant)
    return skewed_alpha / alpha, skewed_beta / beta, skewed_nr / nr
