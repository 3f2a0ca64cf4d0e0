"""The outline of a wheel's patches: half-length and pressure at evenly spaced stations, from the first edge
to the last.

With STATION_COUNT stations it is part of the outputs of its side.  With another number the outlines of both
sides, left then right, follow all outputs, and the places for it among the outputs of the side stay zero.
With wear_outputs the runs of wear of both sides follow, and the strips of their patches.

Half-length and pressure between the strips of a patch follow by the rule of the model that filled it.
"""

from math import sqrt

from ..layout import (
    OUTPUT_COUNT,
    RULE_ELLIPSE,
    RULE_QUADRATIC,
    RUN_COUNT,
    STATION_COUNT,
    WEAR_END,
    WEAR_RUN_COUNT,
    Outline,
    Patch,
    PatchTotals,
    Region,
    Regions,
    SideSearch,
    SolvedStrips,
    Tables,
)
from .quadrature import quadratic_value


def curved_at(strips: SolvedStrips, regions: Regions, count: int, station: float):
    """Half-length [m] and pressure [Pa] at ``station`` [m] by RULE_QUADRATIC, from the strips of ``count``
    regions; zeros where nothing is loaded.

    The quadratics of half-length and pressure do not end exactly where the load does: just outside a patch
    they can be positive.
    """
    half_length = 0.0
    pressure = 0.0
    for index in range(count):
        region = regions[index]
        own = station - region.offset
        if own >= region.low and own <= region.high and half_length == 0.0:
            half_length, pressure = between_strips(region, strips, own)
    return half_length, pressure


def between_strips(region: Region, strips: SolvedStrips, own: float):
    """Half-length [m] and pressure [Pa] at station ``own`` [m] of the region's own ones, from the three
    strips that the cell's quadratic goes through; zeros where the region is not loaded."""
    half_length = 0.0
    pressure = 0.0
    u = (own - region.station) / region.spacing
    inside = u > region.first and u < region.last
    if region.local_penetration > 0.0 and inside:
        outward = 1
        if u < 0.0:
            outward = -1
            u = -u
        low = int(u)
        x = u - float(low)
        inner = region.strip + outward * low
        before = strips[inner - outward]
        here = strips[inner]
        after = strips[inner + outward]
        length = quadratic_value(
            before.half_length_square, here.half_length_square, after.half_length_square, x
        )
        square = quadratic_value(before.pressure_square, here.pressure_square, after.pressure_square, x)
        if length > 0.0 and square > 0.0:
            half_length = sqrt(length)
            pressure = sqrt(square)
    return half_length, pressure


def straight_at(patch: Patch, strips: SolvedStrips, after: int, station: float):
    """Half-length [m] and pressure [Pa] of a patch at ``station`` [m] between its edges, by RULE_STRAIGHT;
    ``after`` is its first strip beyond the station, or the one after its last."""
    low = patch.totals.start
    low_length = 0.0
    low_pressure = 0.0
    if after > patch.first:
        inner = strips[after - 1]
        low = inner.station
        low_length = inner.half_length_square
        low_pressure = inner.pressure_square
    high = patch.totals.stop
    high_length = 0.0
    high_pressure = 0.0
    if after <= patch.last:
        outer = strips[after]
        high = outer.station
        high_length = outer.half_length_square
        high_pressure = outer.pressure_square
    share = (station - low) / (high - low)
    half_length = sqrt(low_length + share * (high_length - low_length))
    pressure = sqrt(low_pressure + share * (high_pressure - low_pressure))
    return half_length, pressure


def row_size(tables: Tables):
    """How many numbers an evaluation gives: the outputs, and the outlines where they follow behind them."""
    size = wear_place(tables)
    if tables.wear:
        size += 2 * WEAR_RUN_COUNT * tables.stations + WEAR_END
    return size


def wear_place(tables: Tables):
    """How many numbers come before the outputs of wear."""
    stations = tables.stations
    size = OUTPUT_COUNT
    if stations != STATION_COUNT:
        size += 2 * RUN_COUNT * stations
    return size


def write_outline(
    outline: Outline, stations: int, side: SideSearch, strips: SolvedStrips, regions: Regions, count: int
):
    """The outline of the patches of a side at ``stations`` stations, from the ``strips`` that its normal
    model has laid in ``count`` regions; without shear and slip."""
    if side.patch_count > 0:
        rule = side.patches[0].rule
        if rule == RULE_ELLIPSE:
            write_ellipse(outline, stations, side.totals)
        elif rule == RULE_QUADRATIC:
            write_quadratic(outline, stations, side.totals, strips, regions, count)
        else:
            write_straight(outline, stations, side, strips)


def write_ellipse(outline: Outline, stations: int, totals: PatchTotals):
    """The outline of a single elliptic patch around station zero."""
    half_length = totals.max_half_length
    half_width = totals.stop
    pressure = totals.max_pressure
    last = stations - 1
    for j in range((stations + 1) // 2):
        share = 1.0 - 2.0 * float(j) / float(last)
        height = sqrt(1.0 - share * share)
        outline.numbers[j] = 0.0 - share * half_width
        outline.numbers[last - j] = share * half_width
        outline.numbers[stations + j] = half_length * height
        outline.numbers[stations + last - j] = half_length * height
        outline.numbers[2 * stations + j] = pressure * height
        outline.numbers[2 * stations + last - j] = pressure * height


def write_quadratic(
    outline: Outline, stations: int, totals: PatchTotals, strips: SolvedStrips, regions: Regions, count: int
):
    """The outline of patches with RULE_QUADRATIC.  The quadratics can rise above the largest values where the
    surfaces have a kink; they are cut there."""
    start = totals.start
    stop = totals.stop
    largest = totals.max_half_length
    peak = totals.max_pressure
    for j in range(stations):
        station = start + (stop - start) * float(j) / float(stations - 1)
        half_length = 0.0
        pressure = 0.0
        if j > 0 and j < stations - 1:
            half_length, pressure = curved_at(strips, regions, count, station)
        half_length = min(half_length, largest)
        pressure = min(pressure, peak)
        outline.numbers[j] = station
        outline.numbers[stations + j] = half_length
        outline.numbers[2 * stations + j] = pressure


def write_straight(outline: Outline, stations: int, side: SideSearch, strips: SolvedStrips):
    """The outline of patches with RULE_STRAIGHT."""
    start = side.totals.start
    stop = side.totals.stop
    index = 0
    strip = 0
    for j in range(stations):
        station = start + (stop - start) * float(j) / float(stations - 1)
        half_length = 0.0
        pressure = 0.0
        index = patch_beside(side, index, station)
        patch = side.patches[index]
        if j > 0 and j < stations - 1 and station > patch.totals.start and station < patch.totals.stop:
            strip = max(strip, patch.first)
            while strip <= patch.last and strips[strip].station < station:
                strip += 1
            half_length, pressure = straight_at(patch, strips, strip, station)
        outline.numbers[j] = station
        outline.numbers[stations + j] = half_length
        outline.numbers[2 * stations + j] = pressure


def patch_beside(side: SideSearch, index: int, station: float):
    """The first patch from ``index`` on that does not end before ``station`` [m]; the last one if all do."""
    while index < side.patch_count - 1 and station > side.patches[index].totals.stop:
        index += 1
    return index
