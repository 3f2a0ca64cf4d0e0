"""Hertz's coefficients and closed-form contact, through a table of exact values.

With q the ratio of the short to the long semi-axis and K, E the complete elliptic integrals of modulus sqrt(1 - q^2),

    A > B (long across):  m = L q, n = L, r = 2 K / (pi L);   A < B: m = L, n = L q, r the same;   L^3 = 2 E / (pi q^2)

so that the three combinations ANALYN needs are functions of ln(B/A) alone:

    1 + alpha = (r / m^2)(1 + B/A),    1 + beta = (r / n^2)(1 + A/B),    n r

and 1 + beta at ln(B/A) is 1 + alpha at ln(A/B).  The table holds quintics over uniform cells, exact to 1e-11
(wrcontact/profiles is not involved; see wrcontact/hertz_table.py).
"""

from math import log, sqrt
from typing import Final

TABLE_COUNT: Final[int] = 0
TABLE_START: Final[int] = 1
TABLE_CELLS_PER_UNIT: Final[int] = 2
TABLE_CELLS: Final[int] = 4
TABLE_ROW: Final[int] = 12


def table_value(tables: 'float[:]', base: int, column: int, abscissa: float):
    """Value of table column 0 (1 + alpha) or 6 (n r) at ``abscissa`` = ln(B/A); clamped to the table's range."""
    u = (abscissa - tables[base + TABLE_START]) * tables[base + TABLE_CELLS_PER_UNIT]
    last = tables[base + TABLE_COUNT]
    if not u > 0.0:
        u = 0.0
    if u > last:
        u = last
    cell = int(u)
    if cell > int(last) - 1:
        cell = int(last) - 1
    u -= float(cell)
    at = base + TABLE_CELLS + TABLE_ROW * cell + column
    return tables[at] + u * (tables[at + 1] + u * (tables[at + 2] + u * (tables[at + 3] + u * (
        tables[at + 4] + u * tables[at + 5]))))


def hertz_coefficients(tables: 'float[:]', base: int, A: float, B: float):
    """1 + alpha, 1 + beta and n r for the separation A x^2 + B s^2; both positive."""
    ratio = log(B / A)
    return (table_value(tables, base, 0, ratio), table_value(tables, base, 0, -ratio),
            table_value(tables, base, 6, ratio))


def hertz_stiffness(tables: 'float[:]', base: int, A: float, B: float, contact_modulus: float):
    """N / penetration^(3/2) [N/m^1.5].

    N = integral of E* d / (n r) over the width with d = penetration - (1 + beta) B s^2: eq. (2.15) of Hertz's closed
    form in ANALYN's coefficients, (4/3) E* / (n r sqrt((1 + beta) B)).
    """
    one_alpha, one_beta, nr = hertz_coefficients(tables, base, A, B)
    return 4.0 / 3.0 * contact_modulus / (nr * sqrt(one_beta * B))
