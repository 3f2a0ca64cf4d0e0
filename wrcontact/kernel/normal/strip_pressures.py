"""Pressures of the strips: no strip pulls, none without load penetrates, and together they carry the force;
eq. (S5).

A linear complementarity problem: elimination for the strips that are taken as loaded, then an exchange of
those that pull or penetrate, until none does.

Strips displace each other by Phi of eq. (S2), with the mean over the width close by, eq. (S4).
"""

from math import fabs, pi, sqrt
from typing import Final

from ..layout import (INFLUENCE_CELLS, INFLUENCE_COLUMN, INFLUENCE_COLUMNS, INFLUENCE_MAP, Equations,
                      InfluenceTable, Strip, StripProblem, Tables)

#: All wrong strips are exchanged at once in so many rounds, then one strip in each round, which cannot go in
#: circles.
EXCHANGES: Final[int] = 10
EXCHANGE_LIMIT: Final[int] = 200
#: A strip without load is loaded if it penetrates by this share of the penetration; rounding is 1e-14.
TOUCH: Final[float] = 1e-12


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


def mean_at(table: InfluenceTable, strip: Strip, distance: float, v: float):
    """The mean of Phi over the width of ``strip`` at a ``distance`` of more than half of that [m]."""
    half = 0.5 * strip.breadth
    near = max(distance - half, 0.0)
    far = distance + half
    inner = influence_at(table, INFLUENCE_MAP, nearness(near, strip.half_length), v)
    outer = influence_at(table, INFLUENCE_MAP, nearness(far, strip.half_length), v)
    return (far * outer - near * inner) / strip.breadth


def begin_influences(problem: StripProblem):
    """No influence is known yet of strips that lie as they do now."""
    for j in range(problem.count):
        problem.strips[j].known = False


def know_influences(table: InfluenceTable, problem: StripProblem, yawed: bool):
    """Find the influences of all loaded strips of which they are not known yet."""
    for j in range(problem.count):
        strip = problem.strips[j]
        if strip.loaded and not strip.known:
            fill_column(table, problem, j, yawed)
            strip.known = True


def fill_column(table: InfluenceTable, problem: StripProblem, j: int, yawed: bool):
    """F_ij of strip j for all i: displacement of the middle of i for y_j = 1, along the normal of i; eqs.
    (S2), (S4)."""
    strips = problem.strips
    other = strips[j]
    x = other.x + other.lead
    half = other.half_length
    for i in range(problem.count):
        strip = strips[i]
        if i != j:
            u = nearness(fabs(strip.place - other.place), half)
            problem.near[i][j] = u
            if yawed:
                influence = influence_at(table, 0, u, apartness(strip.x + strip.lead - x, half))
            else:
                # all middles lie on one line
                influence = middle_influence(table, 0, u)
            problem.influences[i][j] = influence * (strip.cos * other.cos + strip.sin * other.sin)
    for i in range(j - 1, j + 2, 2):
        if i >= 0 and i < problem.count:
            strip = strips[i]
            influence = mean_at(table, other, fabs(strip.place - other.place),
                                apartness(strip.x + strip.lead - x, half))
            problem.influences[i][j] = influence * (strip.cos * other.cos + strip.sin * other.sin)
    problem.near[j][j] = nearness(0.5 * other.breadth, half)
    problem.influences[j][j] = middle_influence(table, INFLUENCE_MAP, problem.near[j][j])


def far_displacement(table: InfluenceTable, problem: StripProblem, i: int, x: float, first: int, last: int):
    """What the loaded strips ``first`` ... ``last`` - 1 displace at the place of strip ``i`` and ``x`` [m],
    along its normal."""
    strips = problem.strips
    near = problem.near[i]
    cosine = strips[i].cos
    sine = strips[i].sin
    total = 0.0
    for j in range(first, last):
        other = strips[j]
        if other.y > 0.0:
            v = apartness(x - other.x - other.lead, other.half_length)
            total += influence_at(table, 0, near[j], v) * other.y * (cosine * other.cos + sine * other.sin)
    return total


def end_displacement(table: InfluenceTable, problem: StripProblem, i: int, away: float):
    """Displacement [m] at a distance ``away`` along x from the middle of strip ``i``, along its normal."""
    strips = problem.strips
    count = problem.count
    strip = strips[i]
    x = strip.x + strip.lead + away
    total = strip.y * influence_at(table, INFLUENCE_MAP, problem.near[i][i],
                                   apartness(away, strip.half_length))
    first = i
    last = i + 1
    for j in range(i - 1, i + 2, 2):
        if j >= 0 and j < count:
            other = strips[j]
            if j < i:
                first = j
            else:
                last = j + 1
            if other.y > 0.0:
                influence = mean_at(table, other, fabs(strip.place - other.place),
                                    apartness(x - other.x - other.lead, other.half_length))
                total += influence * other.y * (strip.cos * other.cos + strip.sin * other.sin)
    total += far_displacement(table, problem, i, x, 0, first)
    total += far_displacement(table, problem, i, x, last, count)
    return total


def solve_pressures(problem: StripProblem, equations: Equations, tables: Tables, force: float,
                    by_penetration: bool, yawed: bool):
    """y of all strips, and which are loaded, under ``force`` [N], or at the problem's penetration where
    ``by_penetration``; the penetration [m], and whether found."""
    penetration = problem.penetration
    for exchange in range(EXCHANGE_LIMIT):
        problem.strip_count += 1.0
        know_influences(tables.influence, problem, yawed)
        size = list_loaded(problem)
        write_equations(problem, equations, size)
        eliminate(equations, size)
        if not by_penetration:
            penetration = equilibrium_penetration(problem, equations, tables, size, force)
        read_solution(problem, equations, size, penetration)
        single = exchange >= EXCHANGES
        if exchange_strips(problem, penetration, single) == 0:
            return penetration, True
    return penetration, False


def list_loaded(problem: StripProblem):
    """List the loaded strips; their number."""
    size = 0
    for i in range(problem.count):
        if problem.strips[i].loaded:
            problem.loaded[size] = float(i)
            size += 1
    return size


def write_equations(problem: StripProblem, equations: Equations, size: int):
    """sum_j F_ij y_j = right-hand side, for the loaded strips: once the displacement for a penetration of 1,
    once the gap."""
    for rank in range(size):
        row = equations[rank]
        i = int(problem.loaded[rank])
        influences = problem.influences[i]
        for other in range(size):
            row[other] = influences[int(problem.loaded[other])]
        row[size] = problem.strips[i].share
        row[size + 1] = problem.strips[i].gap


def equilibrium_penetration(problem: StripProblem, equations: Equations, tables: Tables, size: int,
                            force: float):
    """Penetration [m] at which the solved strips carry ``force`` [N]: (pi^2/2) E* sum_j a_j y_j, as far
    as it counts."""
    unit_load = 0.0
    rest_load = 0.0
    for rank in range(size):
        row = equations[rank]
        strip = problem.strips[int(problem.loaded[rank])]
        half = strip.half_length * strip.counted
        unit_load += half * row[size]
        rest_load += half * row[size + 1]
    return (force / (0.5 * pi * pi * tables.contact_modulus) + rest_load) / unit_load


def read_solution(problem: StripProblem, equations: Equations, size: int, penetration: float):
    """y of every strip at the ``penetration`` [m]."""
    for i in range(problem.count):
        problem.strips[i].y = 0.0
    for rank in range(size):
        row = equations[rank]
        problem.strips[int(problem.loaded[rank])].y = penetration * row[size] - row[size + 1]


def exchange_strips(problem: StripProblem, penetration: float, single: bool):
    """Unload strips that pull and load strips that penetrate, where ``single`` only the last one of all; how
    many."""
    strips = problem.strips
    count = problem.count
    changed = 0
    for back in range(count):
        i = count - 1 - back
        strip = strips[i]
        if not single or changed == 0:
            if strip.loaded:
                if strip.y < 0.0:
                    strip.loaded = False
                    changed += 1
            else:
                pushed = (strip.share - TOUCH) * penetration - strip.gap
                row = problem.influences[i]
                for j in range(count):
                    if strips[j].y != 0.0:
                        pushed -= row[j] * strips[j].y
                if pushed > 0.0:
                    strip.loaded = True
                    changed += 1
    return changed
