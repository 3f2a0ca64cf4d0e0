"""Hertz's coefficients and closed-form contact, through a table of exact values.

With q the ratio of the short to the long semi-axis, K, E the complete elliptic integrals of modulus
sqrt(1 - q^2) and L^3 = 2 E / (pi q^2),

    A > B (long across):   m = L q,  n = L,    r = 2 K / (pi L)
    A < B:                 m = L,    n = L q,  r the same

so that the three combinations ANALYN needs are functions of ln(B/A) alone:

    1 + alpha = (r / m^2)(1 + B/A),    1 + beta = (r / n^2)(1 + A/B),    n r

and 1 + beta at ln(B/A) is 1 + alpha at ln(A/B).  The table holds quintics over uniform cells, exact to 1e-11
(kernel/binding/hertz_table.py).
"""

from math import fabs, log, sqrt
from typing import Final

from ..layout import HERTZ_ROW, HertzTable
from ..surface.table_cell import table_cell

#: Principal curvatures closer than this share are one: the ellipse is a circle.
TILTED: Final[float] = 1e-12
STEEPEST: Final[float] = 0.3


def table_value(table: HertzTable, column: int, abscissa: float):
    """Value of column 0 (1 + alpha) or 6 (n r) at ``abscissa`` = ln(B/A); clamped to the table's range."""
    cell, u = table_cell((abscissa - table.start) * table.cells_per_unit, table.count)
    at = HERTZ_ROW * cell + column
    high = table.rows[at + 3] + u * (table.rows[at + 4] + u * table.rows[at + 5])
    return table.rows[at] + u * (table.rows[at + 1] + u * (table.rows[at + 2] + u * high))


def hertz_coefficients(table: HertzTable, A: float, B: float):
    """1 + alpha, 1 + beta and n r for the separation A x^2 + B s^2; both positive."""
    ratio = log(B / A)
    return (table_value(table, 0, ratio), table_value(table, 0, -ratio),
            table_value(table, 6, ratio))


def skewed_coefficients(table: HertzTable, A: float, B: float, slant: float):
    """1 + alpha, 1 + beta and n r for the separation A (x - slant s)^2 + B s^2 of a yawed wheel.

    Its principal curvatures, of product A B, give a tilted ellipse.  Cut along x at the station s it is an
    upright one again, which is all that ANALYN asks of it: half-length 0 where (1 + beta) B s^2 is the
    penetration, and at s = 0 a half-length a with (1 + alpha) A a^2 the penetration and n r for its
    pressure.  Exact for constant curvatures.

    Where the lateral curvature has fallen to its floor, a slant would make a long oblique ellipse of what is
    a patch's edge: A slant^2 counts as STEEPEST B at most.
    """
    if A * slant * slant > STEEPEST * B:
        slant = sqrt(STEEPEST * B / A)
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
    if A * slant * slant > STEEPEST * B:
        slant = sqrt(STEEPEST * B / A) * slant / fabs(slant)
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


def hertz_stiffness(table: HertzTable, A: float, B: float, contact_modulus: float):
    """N / penetration^(3/2) [N/m^1.5].

    N = integral of E* d / (n r) over the width with d = penetration - (1 + beta) B s^2: eq. (2.15) of Hertz's
    closed form in ANALYN's coefficients, (4/3) E* / (n r sqrt((1 + beta) B)).
    """
    one_alpha, one_beta, nr = hertz_coefficients(table, A, B)
    return 4.0 / 3.0 * contact_modulus / (nr * sqrt(one_beta * B))
