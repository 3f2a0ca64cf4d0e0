"""ANALYN's coefficients at the nodes of a region, from the longitudinal curvature and a lateral one.

Lateral curvature.  Second differences over a window w (the curvature averaged with a triangle of half-width
w) are smooth but blind to what lies beyond; the secant g/s^2 knows how far the surfaces have parted but lags
behind.  With B_t and B_s these two,

    B = sqrt(B_t max(B_t, B_s)),   B_t, B_s >= FLOOR A

follows a sharp joint (B_t) and keeps a patch from growing where B_t falls to zero or below (B_s).

That is the lateral curvature "adaptive".  "smooth" and "rough" are the source's, prepared for each profile
(:mod:`lateral_curvature`), one B in all three places; where it is below FLOOR A it counts as that.
"""

from math import fabs, log, sqrt
from typing import Final

from ..layout import LATERAL_ADAPTIVE, NodeRun, Nodes, Region, Tables
from .hertz import hertz_coefficients, skewed_coefficients, table_value

#: Smallest lateral curvature as a share of the longitudinal one; B <= 0 inside the patch is the normal case
#: on treads.
FLOOR: Final[float] = 0.02
#: Smallest windowed curvature as a share of the secant's, and how much of what it exceeds that by is taken at
#: the edge.
WINDOW_FLOOR: Final[float] = 0.05
GROWTH: Final[float] = 0.12


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
    if averaged < WINDOW_FLOOR * secant:
        averaged = WINDOW_FLOOR * secant
    grown = secant
    if averaged > secant:
        grown += GROWTH * share * (averaged - secant)
    return sqrt(averaged * grown)


def adaptive_curvatures(region: Region, gaps: NodeRun, k: int, window: int, middle: float, mean: float,
                        least: float):
    """The three lateral curvatures [1/m] at node ``k``, for 1 + alpha, 1 + beta and n r: secant, side and
    window; none below ``least``."""
    spacing = region.spacing
    secant = secant_curvature(gaps, k, spacing, window, middle)
    if secant < least:
        secant = least
    share = fabs(float(k)) * spacing / mean
    if share > 1.0:
        share = 1.0
    B = windowed_curvature(second_difference(gaps, k, spacing, window), secant, share)
    if B < least:
        B = least
    side = region.side_high
    if k < 0:
        side = region.side_low
    if side < least:
        side = least
    return secant, side, B


def weigh_nodes(tables: Tables, region: Region, nodes: Nodes, window: int, yawed: bool):
    """ANALYN's coefficients at the nodes of a region: (1 + beta) g, E*/(n r) and (1 + alpha) A, each with its
    own B, or all with the prepared one.  ``window`` : of the lateral curvature, in nodes; ``yawed`` : 1 or
    0."""
    table = tables.hertz
    prepared = tables.lateral != LATERAL_ADAPTIVE
    alpha_factor = 1.0
    beta_factor = 1.0
    nr_factor = 1.0
    if yawed:
        alpha_factor, beta_factor, nr_factor = skew_factors(tables, region, nodes.A[0])
    mean = 0.5 * (region.width_low + region.width_high)
    middle = second_difference(nodes.gap, 0, region.spacing, window)
    if middle < 0.0:
        middle = 0.0
    for k in range(region.first, region.last + 1):
        A = nodes.A[k]
        least = FLOOR * A
        if prepared:
            B = nodes.B[k]
            if B < least:
                B = least
            secant = B
            side = B
        else:
            secant, side, B = adaptive_curvatures(region, nodes.gap, k, window, middle, mean, least)
        alpha = table_value(table, 0, log(secant / A))
        beta = table_value(table, 0, log(A / side))
        nr = table_value(table, 6, log(B / A))
        if yawed:
            alpha *= alpha_factor
            beta *= beta_factor
            nr *= nr_factor
        nodes.B[k] = B
        nodes.rise[k] = beta * nodes.gap[k]
        nodes.line[k] = tables.contact_modulus / nr
        nodes.length[k] = alpha * A


def skew_factors(tables: Tables, region: Region, A: float):
    """Factors of 1 + alpha, 1 + beta and n r for all nodes of a region, from the slant of a yawed wheel's
    ridge: its mean slant and curvature, with ``A`` [1/m] at the minimum."""
    table = tables.hertz
    B = 0.5 * (region.side_low + region.side_high)
    if B < FLOOR * A:
        B = FLOOR * A
    alpha, beta, nr = hertz_coefficients(table, A, B)
    skewed_alpha, skewed_beta, skewed_nr = skewed_coefficients(table, A, B, region.slant)
    return skewed_alpha / alpha, skewed_beta / beta, skewed_nr / nr
