"""Pressures of the strips: together they carry the force and push every middle down as far as it must go; eq.
(S5).

Strips displace each other by Phi of eq. (S2).  Close by that is a logarithm, which a rule of points cannot
integrate: what it leaves out is known exactly for the cosines of a run, eq. (S11), and the rest depends on
the distance of the strips alone, eq. (S12).
"""

from math import fabs, pi, sqrt
from typing import Final

from ..layout import (
    INFLUENCE_CELLS,
    INFLUENCE_COLUMN,
    INFLUENCE_COLUMNS,
    INFLUENCE_MAP,
    SPACING_CELLS,
    Equations,
    InfluenceTable,
    StripProblem,
    Tables,
    inlined,
)

#: Displacement and gap are compared in the middle of a strip and at this share of its half-length.
TESTED: Final[float] = 0.9
#: sqrt(1 - e^2) there, and k(e) of eq. (S12) in the middle and there.
TESTED_HEIGHT: Final[float] = 0.43588989435406735
MIDDLE_CONSTANT: Final[float] = 0.77258872223978123762
TESTED_CONSTANT: Final[float] = 0.9045568429297992
#: Widths of strips over their half-lengths that the tables of spacing reach from and to.
CLOSEST_SPACING: Final[float] = 1e-3
WIDEST_SPACING: Final[float] = 30.0
#: Numbers of cells end below this.
LAST_CELL: Final[float] = 95.999999999
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
    """The place sqrt(t / (1 + t)) with t = ``distance`` / ``half_length`` in the cells of the table."""
    return min(sqrt(distance / (distance + half_length)) * float(INFLUENCE_CELLS), LAST_CELL)


def apartness(apart: float, square: float):
    """The place e^2 / (1 + e^2) with e^2 = ``apart`` / ``square`` in the columns of the table."""
    return apart / (apart + square) * float(INFLUENCE_COLUMNS)


@inlined
def middle_influence(table: InfluenceTable, at: int, x: float):
    """Phi at ``x`` in the cell whose numbers begin at ``at``: at e = 0, or in the column that ``at`` lies in."""
    return table.numbers[at] + x * (table.numbers[at + 1] + x * table.numbers[at + 2])


@inlined
def influence_at(table: InfluenceTable, at: int, x: float, along: float):
    """Phi at ``x`` in the cell whose numbers begin at ``at`` in the first column, ``along`` in the columns.

    Parabolas along the first, smoothly joined: with straight lines there, derivatives would jump by 1e-5
    between any two poses.
    """
    column = int(along)
    low_at = INFLUENCE_COLUMN * column + at
    low = middle_influence(table, low_at, x)
    high = middle_influence(table, low_at + INFLUENCE_COLUMN, x)
    return low + (along - float(column)) * (high - low)


def spacing_at(table: InfluenceTable, first: int, slender: float):
    """S of eq. (S12) at ln(width / half-length); the table begins at number ``first``."""
    place = min(max((slender - FIRST_SPACING) * SPACINGS_EACH, 0.0), float(SPACING_CELLS))
    cell = min(int(place), SPACING_CELLS - 1)
    x = place - float(cell)
    at = first + 3 * cell
    return table.numbers[at] + x * (table.numbers[at + 1] + x * table.numbers[at + 2])


def own_influence(tables: Tables, slender: float, i: int, height: float, constant: float, first: int):
    """What strip ``i`` of its run displaces in its own middle, or beside it, per y and width: eqs. (S11),
    (S12) with ``height`` = sqrt(1 - e^2), k(e) = ``constant`` and the table of spacing from ``first`` on."""
    waves = tables.waves
    rest = constant + spacing_at(tables.influence, first, slender)
    return rest - height * (2.0 * (slender + waves.spread[i]) + waves.singular[i][i])


def fill_rows(problem: StripProblem):
    """What loops over pairs of strips read, in rows."""
    rows = problem.rows
    for i in range(problem.count):
        strip = problem.strips[i]
        rows.place[i] = strip.place
        rows.cos[i] = strip.cos
        rows.sin[i] = strip.sin
        rows.half_length[i] = strip.half_length
        rows.square[i] = strip.square
        rows.width[i] = strip.width
        rows.middle[i] = strip.middle


def see_pairs(problem: StripProblem):
    """How near all strips lie to each other, and how they face each other.

    What a sweep needs of a pair more than once is kept.  Here and below, roots and quotients have loops of
    their own: there a compiler computes several at once.
    """
    fill_rows(problem)
    rows = problem.rows
    size = problem.count
    for i in range(size):
        place = rows.place[i]
        for j in range(size):
            rows.near[j] = nearness(fabs(place - rows.place[j]), rows.half_length[j])
        rows.near[i] = 0.0  # a constant: a root has no derivative at zero
        cells = problem.cells[i]
        within = problem.within[i]
        for j in range(size):
            cell = int(rows.near[j])
            cells[j] = float(3 * cell)
            within[j] = rows.near[j] - float(cell)
        cos = rows.cos[i]
        sin = rows.sin[i]
        facing = problem.facing[i]
        for j in range(size):
            facing[j] = (cos * rows.cos[j] + sin * rows.sin[j]) * rows.width[j]
        facing[i] = 0.0


def write_equations(tables: Tables, problem: StripProblem, equations: Equations, yawed: bool):
    """sum_j F_ij y_j = right-hand side: once the displacement for a penetration of 1, once the gap."""
    waves = tables.waves
    table = tables.influence
    strips = problem.strips
    rows = problem.rows
    size = problem.count
    for i in range(size):
        row = equations[i]
        cells = problem.cells[i]
        within = problem.within[i]
        facing = problem.facing[i]
        if yawed:
            middle = rows.middle[i]
            for j in range(size):
                away = middle - rows.middle[j]
                rows.ahead[j] = apartness(away * away, rows.square[j])
            for j in range(size):
                row[j] = facing[j] * influence_at(table, int(cells[j]), within[j], rows.ahead[j])
        else:
            # all middles lie on one line
            for j in range(size):
                row[j] = facing[j] * middle_influence(table, int(cells[j]), within[j])
        row[size] = strips[i].share
        row[size + 1] = strips[i].gap
    for k in range(problem.run_count):
        first = k * waves.count
        for own in range(waves.count):
            row = equations[first + own]
            facing = problem.facing[first + own]
            singular = waves.singular[own]
            strip = strips[first + own]
            for j in range(waves.count):
                row[first + j] -= singular[j] * facing[first + j]
            row[first + own] = strip.width * own_influence(
                tables, strip.slender, own, 1.0, MIDDLE_CONSTANT, INFLUENCE_MAP
            )


def local_displacement(tables: Tables, problem: StripProblem, first: int, own: int):
    """What strip ``own`` of the run that begins with strip ``first`` displaces beside itself, and the
    logarithms of the run there [m]."""
    strip = problem.strips[first + own]
    facing = problem.facing[first + own]
    singular = tables.waves.singular[own]
    left = 0.0
    for j in range(tables.waves.count):
        left += singular[j] * facing[first + j] * problem.strips[first + j].y
    influence = own_influence(
        tables, strip.slender, own, TESTED_HEIGHT, TESTED_CONSTANT, INFLUENCE_MAP + 3 * SPACING_CELLS
    )
    return strip.width * strip.y * influence - TESTED_HEIGHT * left


def tested_displacements(tables: Tables, problem: StripProblem, i: int, away: float, yawed: bool):
    """What the other strips displace at a distance ``away`` along x before the middle of strip ``i``, and
    behind it [m], along its normal."""
    table = tables.influence
    rows = problem.rows
    cells = problem.cells[i]
    within = problem.within[i]
    facing = problem.facing[i]
    size = problem.count
    front = 0.0
    back = 0.0
    if yawed:
        middle = rows.middle[i]
        for j in range(size):
            x = middle - rows.middle[j] + away
            rows.ahead[j] = apartness(x * x, rows.square[j])
            x -= 2.0 * away
            rows.behind[j] = apartness(x * x, rows.square[j])
        for j in range(size):
            pushed = facing[j] * problem.strips[j].y
            front += influence_at(table, int(cells[j]), within[j], rows.ahead[j]) * pushed
            back += influence_at(table, int(cells[j]), within[j], rows.behind[j]) * pushed
    else:
        for j in range(size):
            rows.ahead[j] = apartness(away * away, rows.square[j])
        for j in range(size):
            pushed = facing[j] * problem.strips[j].y
            front += influence_at(table, int(cells[j]), within[j], rows.ahead[j]) * pushed
        back = front
    return front, back


def solve_pressures(
    tables: Tables,
    problem: StripProblem,
    equations: Equations,
    force: float,
    by_penetration: bool,
    yawed: bool,
):
    """y of all strips under ``force`` [N], or at the problem's penetration where ``by_penetration``; the
    penetration [m]."""
    penetration = problem.penetration
    size = problem.count
    problem.strip_count += 1.0
    see_pairs(problem)
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
