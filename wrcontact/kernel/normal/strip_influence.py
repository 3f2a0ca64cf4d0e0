"""How strips displace each other: Phi of eq. (S2), with the mean over the width close by, eq. (S4)."""

from math import fabs, sqrt

from ..layout import (
    INFLUENCE_CELLS,
    INFLUENCE_COLUMN,
    INFLUENCE_COLUMNS,
    INFLUENCE_MAP,
    InfluenceRow,
    InfluenceTable,
    Strip,
    StripProblem,
    Strips,
)


def cubic_through_slopes(low: float, low_slope: float, high: float, high_slope: float, x: float):
    """The cubic between two values with their slopes, at 0 <= ``x`` <= 1."""
    rise = high - low
    rest = 1.0 - x
    return low + x * (rise + rest * (rest * (low_slope - rise) - x * (high_slope - rise)))


def middle_influence(table: InfluenceTable, first: int, u: float):
    """Phi, or its mean, at x = 0 and ``u`` = sqrt(t / (1 + t)); the map begins at number ``first``."""
    place = u * float(INFLUENCE_CELLS)
    cell = int(place)
    if cell > INFLUENCE_CELLS - 1:
        cell = INFLUENCE_CELLS - 1
    at = first + 2 * cell
    return cubic_through_slopes(table.numbers[at], table.numbers[at + 1], table.numbers[at + 2],
                                table.numbers[at + 3], place - float(cell))


def influence_at(table: InfluenceTable, first: int, u: float, square: float):
    """The same at x / half-length with this ``square``."""
    place = u * float(INFLUENCE_CELLS)
    cell = int(place)
    if cell > INFLUENCE_CELLS - 1:
        cell = INFLUENCE_CELLS - 1
    along = square / (1.0 + square) * float(INFLUENCE_COLUMNS)
    column = int(along)
    if column > INFLUENCE_COLUMNS - 1:
        column = INFLUENCE_COLUMNS - 1
    share = along - float(column)
    at = first + INFLUENCE_COLUMN * column + 2 * cell
    to = at + INFLUENCE_COLUMN
    low = table.numbers[at] + share * (table.numbers[to] - table.numbers[at])
    low_slope = table.numbers[at + 1] + share * (table.numbers[to + 1] - table.numbers[at + 1])
    high = table.numbers[at + 2] + share * (table.numbers[to + 2] - table.numbers[at + 2])
    high_slope = table.numbers[at + 3] + share * (table.numbers[to + 3] - table.numbers[at + 3])
    return cubic_through_slopes(low, low_slope, high, high_slope, place - float(cell))


def nearness(distance: float, half_length: float):
    """sqrt(t / (1 + t)) with t = ``distance`` / ``half_length``."""
    return sqrt(distance / (distance + half_length))


def mean_at(table: InfluenceTable, strip: Strip, distance: float, square: float):
    """The mean of Phi over the width of ``strip`` at a ``distance`` of more than half of that [m]."""
    half = 0.5 * strip.breadth
    near = distance - half
    if near < 0.0:
        near = 0.0
    far = distance + half
    inner = influence_at(table, INFLUENCE_MAP, nearness(near, strip.half_length), square)
    outer = influence_at(table, INFLUENCE_MAP, nearness(far, strip.half_length), square)
    return (far * outer - near * inner) / strip.breadth


def fill_row(table: InfluenceTable, strips: Strips, i: int, first: int, last: int, near: InfluenceRow,
             row: InfluenceRow):
    """Phi of the strips ``first`` ... ``last`` - 1 at the middle of strip ``i``, and how near they are."""
    strip = strips[i]
    x = strip.x + strip.lead
    for j in range(first, last):
        other = strips[j]
        u = nearness(fabs(strip.place - other.place), other.half_length)
        near[j] = u
        apart = (x - other.x - other.lead) / other.half_length
        row[j] = influence_at(table, 0, u, apart * apart)
    return 0


def fill_straight_row(table: InfluenceTable, strips: Strips, i: int, first: int, last: int,
                      near: InfluenceRow, row: InfluenceRow):
    """``fill_row`` without yaw: all middles lie on one line."""
    strip = strips[i]
    for j in range(first, last):
        other = strips[j]
        u = nearness(fabs(strip.place - other.place), other.half_length)
        near[j] = u
        row[j] = middle_influence(table, 0, u)
    return 0


def fill_influences(table: InfluenceTable, problem: StripProblem, yawed: int):
    """F_ij of all pairs: displacement of the middle of i for y_j = 1, along the normal of i; eqs. (S2),
    (S4)."""
    strips = problem.strips
    count = problem.count
    for i in range(count):
        strip = strips[i]
        row = problem.influences[i]
        near = problem.near[i]
        if yawed == 1:
            fill_row(table, strips, i, 0, i, near, row)
            fill_row(table, strips, i, i + 1, count, near, row)
        else:
            fill_straight_row(table, strips, i, 0, i, near, row)
            fill_straight_row(table, strips, i, i + 1, count, near, row)
        for j in range(i - 1, i + 2, 2):
            if j >= 0 and j < count:
                other = strips[j]
                apart = (strip.x + strip.lead - other.x - other.lead) / other.half_length
                row[j] = mean_at(table, other, fabs(strip.place - other.place), apart * apart)
        near[i] = nearness(0.5 * strip.breadth, strip.half_length)
        row[i] = middle_influence(table, INFLUENCE_MAP, near[i])
        for j in range(count):
            row[j] *= strip.cos * strips[j].cos + strip.sin * strips[j].sin
    return 0


def far_displacement(table: InfluenceTable, problem: StripProblem, i: int, x: float, first: int, last: int):
    """What the loaded strips ``first`` ... ``last`` - 1 displace at the place of strip ``i`` and ``x`` [m],
    along its normal: ``influence_at`` for each."""
    strips = problem.strips
    near = problem.near[i]
    cosine = strips[i].cos
    sine = strips[i].sin
    total = 0.0
    for j in range(first, last):
        other = strips[j]
        if other.y > 0.0:
            apart = x - other.x - other.lead
            square = apart * apart
            along = square / (square + other.half_length * other.half_length) * float(INFLUENCE_COLUMNS)
            column = int(along)
            share = along - float(column)
            place = near[j] * float(INFLUENCE_CELLS)
            cell = int(place)
            at = INFLUENCE_COLUMN * column + 2 * cell
            to = at + INFLUENCE_COLUMN
            low = table.numbers[at] + share * (table.numbers[to] - table.numbers[at])
            low_slope = table.numbers[at + 1] + share * (table.numbers[to + 1] - table.numbers[at + 1])
            high = table.numbers[at + 2] + share * (table.numbers[to + 2] - table.numbers[at + 2])
            high_slope = table.numbers[at + 3] + share * (table.numbers[to + 3] - table.numbers[at + 3])
            influence = cubic_through_slopes(low, low_slope, high, high_slope, place - float(cell))
            total += influence * other.y * (cosine * other.cos + sine * other.sin)
    return total


def end_displacement(table: InfluenceTable, problem: StripProblem, i: int, away: float):
    """Displacement [m] at a distance ``away`` along x from the middle of strip ``i``, along its normal."""
    strips = problem.strips
    count = problem.count
    strip = strips[i]
    x = strip.x + strip.lead + away
    apart = away / strip.half_length
    total = strip.y * influence_at(table, INFLUENCE_MAP, problem.near[i][i], apart * apart)
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
                apart = (x - other.x - other.lead) / other.half_length
                influence = mean_at(table, other, fabs(strip.place - other.place), apart * apart)
                total += influence * other.y * (strip.cos * other.cos + strip.sin * other.sin)
    total += far_displacement(table, problem, i, x, 0, first)
    total += far_displacement(table, problem, i, x, last, count)
    return total
