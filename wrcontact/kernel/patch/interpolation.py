"""Half-length and pressure of a patch between its strips, by the rule of the model that filled it."""

from math import sqrt

from ..layout import Patch, Region, Regions, SolvedStrips
from .quadrature import quadratic_value


def quadratic_at(strips: SolvedStrips, regions: Regions, count: int, station: float):
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
        length = quadratic_value(before.half_length_square, here.half_length_square,
                                 after.half_length_square, x)
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
