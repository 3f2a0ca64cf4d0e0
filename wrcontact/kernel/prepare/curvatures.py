"""Lateral curvature of a profile all along it, as the source takes it.

Curvatures here are d(angle)/d(arc length) with z down, positive where the profile is hollow upwards; the
table has them positive where the profile bulges towards the other body, which is this sign on a rail and the
other one on a wheel. The table is the record CurvatureTable.

The rail's arc length is tabled over its abscissa, and the abscissa over the arc length.  Cubics of Hermite
over even cells: value and slope at the ends of a cell are exact.
"""

from math import fabs, sqrt
from typing import Final

from ..elementary.circle import atan2
from ..elementary.whole import rounded_up
from ..layout import (
    CUBIC_SIZE,
    LATERAL_ROUGH,
    LATERAL_SMOOTH,
    PIECE_SIZE,
    CubicTable,
    CurvatureTable,
    Profile,
    Tables,
    offset,
)
from ..surface.tables import height_slope
from .pieces import FULL
from .scan import first_piece, piece_count, piece_width

# distance of the values: this share of what they are averaged over, between these [m]
RASTER_SHARE: Final[float] = 0.25
FINEST: Final[float] = 0.01e-3
COARSEST: Final[float] = 0.05e-3
SAMPLES: Final[int] = 61  # points of a profile that a circle is fitted to
GAUSS_POINTS: Final[int] = 10
ARC_ITERATIONS: Final[int] = 30
ARC_SHARP: Final[float] = 1e-15  # last Newton step to a node [m]
#: Longest cell of either table [m].
ARC_STEP: Final[float] = 1e-4


def circle_curvature(
    n00: float, n01: float, n02: float, n11: float, n12: float, n22: float, r0: float, r1: float, r2: float
):
    """Curvature of the circle c (u^2 + v^2) + b u + a = v from its normal equations, by
    symmetric elimination.

    Many arguments because these are the nine different numbers of three symmetric equations.
    """
    l01 = n01 / n00
    l02 = n02 / n00
    m11 = n11 - l01 * n01
    m12 = n12 - l01 * n02
    s1 = r1 - l01 * r0
    l12 = m12 / m11
    c = (r2 - l02 * r0 - l12 * s1) / (n22 - l02 * n02 - l12 * m12)
    b = (s1 - m12 * c) / m11
    a = (r0 - n01 * b - n02 * c) / n00
    return 2.0 * c / sqrt(1.0 + b * b - 4.0 * a * c)


def fitted_curvature(tables: "float[:]", profile: int, y: float, reach: float):
    """Curvature [1/m] of the circle fitted to the profile over y - reach ... y + reach, at ``y`` [m]."""
    low = max(y - reach, Profile.at(tables, profile).start)
    high = min(y + reach, Profile.at(tables, profile).stop)
    z_0, slope = height_slope(Profile.at(tables, profile), y)
    cosine = 1.0 / sqrt(1.0 + slope * slope)
    sine = slope * cosine
    n00, n01, n02, n11, n12, n22 = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    r0, r1, r2 = 0.0, 0.0, 0.0
    for k in range(SAMPLES):
        at = low + (high - low) * (float(k) / float(SAMPLES - 1))
        z, slope = height_slope(Profile.at(tables, profile), at)
        across = at - y
        down = z - z_0
        u = (across * cosine + down * sine) / reach
        v = (down * cosine - across * sine) / reach
        w = u * u + v * v
        n00 += 1.0
        n01 += u
        n02 += w
        n11 += u * u
        n12 += u * w
        n22 += w * w
        r0 += v
        r1 += u * v
        r2 += w * v
    return circle_curvature(n00, n01, n02, n11, n12, n22, r0, r1, r2) / reach


def write_gauss(work: "float[:]", scratch: int):
    """Nodes and weights of Gauss's formula into scratch."""
    work[scratch + 0] = -0.9739065285171717
    work[scratch + GAUSS_POINTS + 0] = 0.06667134430868814
    work[scratch + 1] = -0.8650633666889845
    work[scratch + GAUSS_POINTS + 1] = 0.1494513491505804
    work[scratch + 2] = -0.6794095682990244
    work[scratch + GAUSS_POINTS + 2] = 0.219086362515982
    work[scratch + 3] = -0.4333953941292472
    work[scratch + GAUSS_POINTS + 3] = 0.2692667193099965
    work[scratch + 4] = -0.14887433898163122
    work[scratch + GAUSS_POINTS + 4] = 0.2955242247147528
    work[scratch + 5] = 0.14887433898163122
    work[scratch + GAUSS_POINTS + 5] = 0.2955242247147528
    work[scratch + 6] = 0.4333953941292472
    work[scratch + GAUSS_POINTS + 6] = 0.2692667193099965
    work[scratch + 7] = 0.6794095682990244
    work[scratch + GAUSS_POINTS + 7] = 0.219086362515982
    work[scratch + 8] = 0.8650633666889845
    work[scratch + GAUSS_POINTS + 8] = 0.1494513491505804
    work[scratch + 9] = 0.9739065285171717
    work[scratch + GAUSS_POINTS + 9] = 0.06667134430868814


def arc_panel(tables: "float[:]", profile: int, low: float, high: float, work: "float[:]", scratch: int):
    """Arc length [m] from ``low`` to ``high`` [m], which lie in one piece."""
    half = 0.5 * (high - low)
    total = 0.0
    for k in range(GAUSS_POINTS):
        z, slope = height_slope(Profile.at(tables, profile), 0.5 * (low + high) + half * work[scratch + k])
        total += sqrt(1.0 + slope * slope) * work[scratch + GAUSS_POINTS + k]
    return half * total


def write_lengths(tables: "float[:]", profile: int, work: "float[:]", scratch: int):
    """Gauss's formula and the arc length at the start of each piece and at the end of all into
    scratch; the end's [m]."""
    write_gauss(work, scratch)
    total = 0.0
    first = first_piece(tables, profile)
    lengths = scratch + 2 * GAUSS_POINTS
    work[lengths] = 0.0
    for i in range(piece_count(tables, profile)):
        at = first + PIECE_SIZE * i
        total += arc_panel(
            tables, profile, tables[at], tables[at] + piece_width(tables, profile, at), work, scratch
        )
        work[lengths + i + 1] = total
    return total


def length_at(tables: "float[:]", profile: int, y: float, work: "float[:]", scratch: int):
    """Arc length [m] at ``y`` [m]."""
    first = first_piece(tables, profile)
    low = 0
    high = piece_count(tables, profile)
    while high - low > 1:
        middle = (low + high) // 2
        if tables[first + PIECE_SIZE * middle] <= y:
            low = middle
        else:
            high = middle
    return work[scratch + 2 * GAUSS_POINTS + low] + arc_panel(
        tables, profile, tables[first + PIECE_SIZE * low], y, work, scratch
    )


def place_at_length(tables: "float[:]", profile: int, length: float, work: "float[:]", scratch: int):
    """Abscissa [m] at arc length ``length`` [m]: Newton's method within the piece that holds it."""
    lengths = scratch + 2 * GAUSS_POINTS
    piece = 0
    end = piece_count(tables, profile)
    while end - piece > 1:
        middle = (piece + end) // 2
        if work[lengths + middle] <= length:
            piece = middle
        else:
            end = middle
    at = first_piece(tables, profile) + PIECE_SIZE * piece
    low = tables[at]
    high = low + piece_width(tables, profile, at)
    share = (length - work[lengths + piece]) / (work[lengths + piece + 1] - work[lengths + piece])
    y = low + share * (high - low)
    i = 0
    while i < ARC_ITERATIONS:
        before = y
        missing = length - work[lengths + piece] - arc_panel(tables, profile, low, y, work, scratch)
        z, slope = height_slope(Profile.at(tables, profile), y)
        y = min(max(y + missing / sqrt(1.0 + slope * slope), low), high)
        i += 1
        if fabs(y - before) <= ARC_SHARP:
            i = ARC_ITERATIONS
    return y


def turned_curvature(
    tables: "float[:]", profile: int, y: float, step: float, total: float, work: "float[:]", scratch: int
):
    """Change of the profile's angle per arc length [1/m] from chord to chord between nodes ``step`` [m]
    before ``y`` [m], at it and after it; ``total`` is the whole arc length [m]."""
    step = min(step, 0.5 * total)
    middle = min(max(length_at(tables, profile, y, work, scratch), step), total - step)
    y_0 = place_at_length(tables, profile, middle - step, work, scratch)
    y_1 = place_at_length(tables, profile, middle, work, scratch)
    y_2 = place_at_length(tables, profile, middle + step, work, scratch)
    z_0, slope = height_slope(Profile.at(tables, profile), y_0)
    z_1, slope = height_slope(Profile.at(tables, profile), y_1)
    z_2, slope = height_slope(Profile.at(tables, profile), y_2)
    return (atan2(z_2 - z_1, y_2 - y_1) - atan2(z_1 - z_0, y_1 - y_0)) / step


def write_curvatures(tables: Tables, base: int, profile: int, sign: float, work: "float[:]", scratch: int):
    """What the chosen lateral curvature reads of a profile, at ``base``; the offset after it, or FULL."""
    kind = int(tables.parameters.lateral_curvature)
    step = tables.parameters.curvature_step
    reach = tables.parameters.curvature_reach
    if kind != LATERAL_SMOOTH and kind != LATERAL_ROUGH:
        return base
    scale = step
    if kind == LATERAL_SMOOTH:
        scale = reach
    start = Profile.at(tables.raw, profile).start
    stop = Profile.at(tables.raw, profile).stop
    count = rounded_up((stop - start) / min(max(RASTER_SHARE * scale, FINEST), COARSEST)) + 1
    table = CurvatureTable.at(tables.raw, base)
    first = offset(table.curvatures, tables)
    if first + count > tables.raw.shape[0]:
        return FULL
    table.count = float(count)
    table.start = start
    table.per_metre = float(count - 1) / (stop - start)
    total = 0.0
    if kind == LATERAL_ROUGH:
        total = write_lengths(tables.raw, profile, work, scratch)
    distance = (stop - start) / float(count - 1)
    for i in range(count):
        y = float(i) * distance + start
        if i + 1 == count:
            y = stop
        curvature = 0.0
        if kind == LATERAL_SMOOTH:
            curvature = fitted_curvature(tables.raw, profile, y, reach)
        else:
            curvature = turned_curvature(tables.raw, profile, y, step, total, work, scratch)
        table.curvatures[i] = sign * curvature
    return first + count


def open_table(tables: Tables, base: int, start: float, length: float):
    """A table of cubics over ``length`` [m] from ``start`` [m] on, at ``base``; its number of cells and the
    offset after it, or FULL."""
    cells = rounded_up(length / ARC_STEP)
    table = CubicTable.at(tables.raw, base)
    end = offset(table.cells[0], tables) + CUBIC_SIZE * cells
    if end > tables.raw.shape[0]:
        return cells, FULL
    table.count = float(cells)
    table.start = start
    table.cells_per_unit = float(cells) / length
    return cells, end


def write_cubic(
    tables: Tables, base: int, cell: int, low: float, high: float, low_rise: float, high_rise: float
):
    """Cell ``cell`` of the table at ``base``, with these values at its ends, and slopes per cell."""
    cubic = CubicTable.at(tables.raw, base).cells[cell]
    rise = high - low
    cubic.value = low
    cubic.slope = low_rise
    cubic.bend = 3.0 * rise - 2.0 * low_rise - high_rise
    cubic.third = low_rise + high_rise - 2.0 * rise


def rail_speed(tables: Tables, rail: int, abscissa: float):
    """Arc length per abscissa of the rail [-]."""
    height, slope = height_slope(Profile.at(tables.raw, rail), abscissa)
    return sqrt(1.0 + slope * slope)


def write_arcs(tables: Tables, base: int, rail: int, work: "float[:]", scratch: int):
    """The arc length of the rail over its abscissa, at ``base``; the offset after it, or FULL."""
    start = Profile.at(tables.raw, rail).start
    width = Profile.at(tables.raw, rail).stop - start
    cells, end = open_table(tables, base, start, width)
    if end == FULL:
        return FULL
    total = write_lengths(tables.raw, rail, work, scratch)
    step = width / float(cells)
    low = 0.0
    low_rise = step * rail_speed(tables, rail, start)
    for cell in range(cells):
        x = start + step * float(cell + 1)
        high = total
        if cell + 1 < cells:
            high = length_at(tables.raw, rail, x, work, scratch)
        high_rise = step * rail_speed(tables, rail, x)
        write_cubic(tables, base, cell, low, high, low_rise, high_rise)
        low = high
        low_rise = high_rise
    return end


def write_abscissae(tables: Tables, base: int, rail: int, work: "float[:]", scratch: int):
    """The abscissa of the rail over its arc length, at ``base``; the offset after it, or FULL."""
    start = Profile.at(tables.raw, rail).start
    total = write_lengths(tables.raw, rail, work, scratch)
    cells, end = open_table(tables, base, 0.0, total)
    if end == FULL:
        return FULL
    step = total / float(cells)
    low = start
    low_rise = step / rail_speed(tables, rail, start)
    for cell in range(cells):
        high = Profile.at(tables.raw, rail).stop
        if cell + 1 < cells:
            high = place_at_length(tables.raw, rail, step * float(cell + 1), work, scratch)
        high_rise = step / rail_speed(tables, rail, high)
        write_cubic(tables, base, cell, low, high, low_rise, high_rise)
        low = high
        low_rise = high_rise
    return end
