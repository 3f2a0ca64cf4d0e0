"""Pressures of the strips: together they carry the force and push every middle down as far as it must go; eq.
(S5).

Strips displace each other by Phi of eq. (S2).  Close by that is a logarithm, which a rule of points cannot
integrate: what it leaves out is known exactly for the cosines of a run, eq. (S11), and the rest depends on
the distance of the strips alone, eq. (S12).
"""

from math import fabs, pi, sqrt
from typing import Final

from ..layout import (INFLUENCE_CELLS, INFLUENCE_COLUMN, INFLUENCE_COLUMNS, INFLUENCE_MAP, SPACING_CELLS,
                      Equations, InfluenceTable, StripProblem, Tables)

#: Displacement and gap are compared in the middle of a strip and at this share of its half-length.
TESTED: Final[float] = 0.9
#: sqrt(1 - e^2) there, and k(e) of eq. (S12) in the middle and there.
TESTED_HEIGHT: Final[float] = 0.43588989435406735
MIDDLE_CONSTANT: Final[float] = 0.77258872223978123762
TESTED_CONSTANT: Final[float] = 0.9045568429297992
#: Widths of strips over their half-lengths that the tables of spacing reach from and to.
CLOSEST_SPACING: Final[float] = 1e-3
WIDEST_SPACING: Final[float] = 30.0
#: And in logarithms.
FIRST_SPACING: Final[float] = -6.90775527898213705205
SPACINGS_EACH: Final[float] = 18.624588386459845


def eliminate(equations: Equations, size: int):
    """Solve ``size`` equations in place: the two right-hand sides, in the last two columns, become the
    solutions.

    Gauss without exchange of rows: the matrix is that of a positive kernel, largest on the diagonal.
    """
    width = size + 2
    for pair in range(size // 2):
        # two columns at a time, so that every row is read and written once for both
        k = 2 * pair
        first = equations[k]
        second = equations[k + 1]
        inverse = 1.0 / first[k]
        factor = second[k] * inverse
        for j in range(k + 1, width):
            second[j] -= factor * first[j]
        next_inverse = 1.0 / second[k + 1]
        for i in range(k + 2, size):
            row = equations[i]
            factor = row[k] * inverse
            next_factor = (row[k + 1] - factor * first[k + 1]) * next_inverse
            for j in range(k + 2, width):
                row[j] = row[j] - factor * first[j] - next_factor * second[j]
    for back in range(size):
        k = size - 1 - back
        pivot = equations[k]
        one = pivot[size]
        other = pivot[size + 1]
        for j in range(k + 1, size):
            row = equations[j]
            one -= pivot[j] * row[size]
            other -= pivot[j] * row[size + 1]
        pivot[size] = one / pivot[k]
        pivot[size + 1] = other / pivot[k]


def nearness(distance: float, half_length: float):
    """u = sqrt(t / (1 + t)) with t = ``distance`` / ``half_length``."""
    return sqrt(distance / (distance + half_length))


def apartness(x: float, half_length: float):
    """v = e^2 / (1 + e^2) with e = ``x`` / ``half_length``."""
    square = x * x
    return square / (square + half_length * half_length)


def cell_at(place: float, count: int):
    """The cell that holds ``place``, 0 ... ``count``; the last one has its end too."""
    cell = min(int(place), count - 1)
    return cell


def influence_at(table: InfluenceTable, first: int, u: float, v: float):
    """Phi, or its mean, at ``u`` and ``v``; the map begins at number ``first``.

    Parabolas along u, smoothly joined: with straight lines there, derivatives would jump by 1e-5 between any
    two poses.
    """
    place = u * float(INFLUENCE_CELLS)
    cell = cell_at(place, INFLUENCE_CELLS)
    along = v * float(INFLUENCE_COLUMNS)
    column = cell_at(along, INFLUENCE_COLUMNS)
    x = place - float(cell)
    share = along - float(column)
    at = first + INFLUENCE_COLUMN * column + 3 * cell
    to = at + INFLUENCE_COLUMN
    low = table.numbers[at] + x * (table.numbers[at + 1] + x * table.numbers[at + 2])
    high = table.numbers[to] + x * (table.numbers[to + 1] + x * table.numbers[to + 2])
    return low + share * (high - low)


def middle_influence(table: InfluenceTable, first: int, u: float):
    """The same at v = 0."""
    place = u * float(INFLUENCE_CELLS)
    cell = cell_at(place, INFLUENCE_CELLS)
    x = place - float(cell)
    at = first + 3 * cell
    return table.numbers[at] + x * (table.numbers[at + 1] + x * table.numbers[at + 2])


def spacing_at(table: InfluenceTable, first: int, slender: float):
    """S of eq. (S12) at ln(width / half-length); the table begins at number ``first``."""
    place = min(max((slender - FIRST_SPACING) * SPACINGS_EACH, 0.0), float(SPACING_CELLS))
    cell = cell_at(place, SPACING_CELLS)
    x = place - float(cell)
    at = first + 3 * cell
    return table.numbers[at] + x * (table.numbers[at + 1] + x * table.numbers[at + 2])


def own_influence(tables: Tables, problem: StripProblem, i: int, tested: bool):
    """What strip ``i`` displaces in its own middle, or beside it where ``tested``, per y and width; eqs.
    (S11), (S12)."""
    strip = problem.strips[i]
    waves = tables.waves
    own = i % waves.count
    height = 1.0
    rest = MIDDLE_CONSTANT + spacing_at(tables.influence, INFLUENCE_MAP, strip.slender)
    if tested:
        height = TESTED_HEIGHT
        rest = TESTED_CONSTANT + spacing_at(tables.influence, INFLUENCE_MAP + 3 * SPACING_CELLS, strip.slender)
    return rest - height * (2.0 * (strip.slender + waves.spread[own]) + waves.singular[own][own])


def write_equations(tables: Tables, problem: StripProblem, equations: Equations, yawed: bool):
    """sum_j F_ij y_j = right-hand side: once the displacement for a penetration of 1, once the gap."""
    strips = problem.strips
    count = problem.count
    waves = tables.waves
    for i in range(count):
        strip = strips[i]
        row = equations[i]
        near = problem.near[i]
        facing = problem.facing[i]
        x = strip.x + strip.lead
        for j in range(count):
            other = strips[j]
            u = nearness(fabs(strip.place - other.place), other.half_length)
            near[j] = u
            face = (strip.cos * other.cos + strip.sin * other.sin) * other.width
            facing[j] = face
            if yawed:
                row[j] = face * influence_at(tables.influence, 0, u,
                                             apartness(x - other.x - other.lead, other.half_length))
            else:
                # all middles lie on one line
                row[j] = face * middle_influence(tables.influence, 0, u)
        first = i - i % waves.count
        singular = waves.singular[i - first]
        for j in range(waves.count):
            row[first + j] -= singular[j] * facing[first + j]
        row[i] = own_influence(tables, problem, i, False) * strip.width
        row[count] = strip.share
        row[count + 1] = strip.gap


def tested_displacement(tables: Tables, problem: StripProblem, i: int, away: float):
    """Displacement [m] at a distance ``away`` along x from the middle of strip ``i``, TESTED of its
    half-length, along its normal."""
    strips = problem.strips
    strip = strips[i]
    near = problem.near[i]
    facing = problem.facing[i]
    x = strip.x + strip.lead + away
    total = own_influence(tables, problem, i, True) * strip.width * strip.y
    for j in range(problem.count):
        if j != i:
            other = strips[j]
            v = apartness(x - other.x - other.lead, other.half_length)
            total += influence_at(tables.influence, 0, near[j], v) * facing[j] * other.y
    count = tables.waves.count
    first = i - i % count
    singular = tables.waves.singular[i - first]
    left = 0.0
    for j in range(count):
        if first + j != i:
            left += singular[j] * facing[first + j] * strips[first + j].y
    return total - TESTED_HEIGHT * left


def solve_pressures(tables: Tables, problem: StripProblem, equations: Equations, force: float,
                    by_penetration: bool, yawed: bool):
    """y of all strips under ``force`` [N], or at the problem's penetration where ``by_penetration``; the
    penetration [m]."""
    penetration = problem.penetration
    size = problem.count
    problem.strip_count += 1.0
    write_equations(tables, problem, equations, yawed)
    eliminate(equations, size)
    if not by_penetration:
        penetration = equilibrium_penetration(tables, problem, equations, force)
    for i in range(size):
        row = equations[i]
        problem.strips[i].y = penetration * row[size] - row[size + 1]
    return penetration


def equilibrium_penetration(tables: Tables, problem: StripProblem, equations: Equations, force: float):
    """Penetration [m] at which the solved strips carry ``force`` [N]: (pi^2/2) E* sum_j a_j w_j y_j, as far
    as it counts."""
    unit_load = 0.0
    rest_load = 0.0
    for i in range(problem.count):
        row = equations[i]
        strip = problem.strips[i]
        half = strip.half_length * strip.width * strip.counted
        unit_load += half * row[problem.count]
        rest_load += half * row[problem.count + 1]
    return (force / (0.5 * pi * pi * tables.contact_modulus) + rest_load) / unit_load
