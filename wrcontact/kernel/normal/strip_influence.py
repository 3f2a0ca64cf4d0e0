"""How strips displace each other's middle lines: Phi of eq. (S2), with the mean over the width close by, eq.
(S4)."""

from math import fabs, log, sqrt

from ..layout import Distances, Influences, InfluenceTable, Regions, StripProblem, Strips
from .interaction import region_lead


def measure_distances(distances: Distances, strips: Strips, regions: Regions, i: int, others: int):
    """Logarithms of the distances between strip ``i`` and the first ``others``.

    The lead of one region over another along the track counts as distance (interaction.region_lead).
    """
    strip = strips[i]
    for j in range(others):
        if j != i:
            other = strips[j]
            apart = fabs(strip.station - other.station)
            if strip.region != other.region:
                lead = region_lead(regions[strip.region], regions[other.region])
                apart = sqrt(apart * apart + lead * lead)
            distance = log(apart)
            distances[i][j] = distance
            distances[j][i] = distance
    return 0


def line_influence(table: InfluenceTable, abscissa: float):
    """Phi of eq. (S2) at ``abscissa`` = ln(distance / half-length); at the table's end beyond it."""
    u = (abscissa - table.start) * table.cells_per_unit
    if not u > 0.0:
        u = 0.0
    if u > table.count:
        u = table.count
    cell = int(u)
    u -= float(cell)
    cubic = table.cells[cell]
    return cubic.value + u * (cubic.slope + u * (cubic.bend + u * cubic.third))


def near_share(share: float):
    """What the mean of Phi over a strip's width exceeds its middle value by, eq. (S4); ``share`` is
    half-width over distance.

    The series of 2 - [(1 + share) ln(1 + share) - (1 - share) ln(1 - share)] / share, up to the eighth power.
    """
    square = share * share
    rest = 1.0 / 42.0 + square * (1.0 / 72.0 + square / 110.0)
    return 2.0 * square * (1.0 / 6.0 + square * (1.0 / 20.0 + square * rest))


def fill_influences(table: InfluenceTable, problem: StripProblem):
    """F_ij of all pairs: displacement of middle line i for y_j = 1; eqs. (S2), (S4)."""
    strips = problem.strips
    count = problem.count
    for i in range(count):
        row = problem.influences[i]
        distances = problem.distances[i]
        for j in range(count):
            if j != i:
                row[j] = line_influence(table, distances[j] - strips[j].log_half_length)
        for j in range(i - 2, i + 3):
            if j >= 0 and j < count and j != i:
                row[j] += near_share(0.5 * strips[j].width / fabs(strips[i].station - strips[j].station))
        row[i] = 2.0 * log(8.0 * strips[i].half_length / strips[i].width)
    turn_influences(problem.influences, strips, count)
    return 0


def turn_influences(influences: Influences, strips: Strips, count: int):
    """Multiply the influence between two strips by the cosine of the angle between their normals."""
    for i in range(count):
        for j in range(count):
            if j != i:
                influences[i][j] *= strips[i].cos * strips[j].cos + strips[i].sin * strips[j].sin
    return 0
