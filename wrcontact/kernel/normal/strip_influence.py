"""How strips displace each other: Phi of eq. (S2), with the mean over the width close by, eq. (S4)."""

from math import fabs, sqrt

from ..layout import (INFLUENCE_CELLS, INFLUENCE_COLUMN, INFLUENCE_COLUMNS, INFLUENCE_MAP, InfluenceTable,
                      Strip, StripProblem)


def nearness(distance: float, half_length: float):
    """u = sqrt(t / (1 + t)) with t = ``distance`` / ``half_length``."""
    return sqrt(distance / (distance + half_length))


def apartness(x: float, half_length: float):
    """v = e^2 / (1 + e^2) with e = ``x`` / ``half_length``."""
    square = x * x
    return square / (square + half_length * half_length)


def cell_at(place: float, count: int):
    """The cell that holds ``place``, 0 ... ``count``; the last one has its end too."""
    cell = int(place)
    if cell > count - 1:
        cell = count - 1
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
    near = distance - half
    if near < 0.0:
        near = 0.0
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
