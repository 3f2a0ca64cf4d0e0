"""Where the outline of a side lies: three runs of equal length, its stations, half-lengths and pressures.

With STATION_COUNT stations it is part of the side's outputs.  With another number the outlines of both sides, left then
right, follow behind all outputs, and the places for it among the side's own stay zero.
"""

from ..layout import OUTPUT_COUNT, OUT_LEFT, SET_STATIONS, SIDE_STATION, STATION_COUNT, WORK_OUTLINES, WORK_OUTPUTS


def outline_place(tables: 'float[:]', out: int):
    """Offset in the workspace of the outline of the side whose outputs are at ``out``."""
    stations = int(tables[SET_STATIONS])
    place = out + SIDE_STATION
    if stations != STATION_COUNT:
        place = WORK_OUTLINES
        if out > WORK_OUTPUTS + OUT_LEFT:
            place += 3 * stations
    return place


def fill_apart(tables: 'float[:]', work: 'float[:]', out: int, value: float):
    """Write ``value`` all over a side's outline, where it is not part of the side's outputs."""
    stations = int(tables[SET_STATIONS])
    if stations != STATION_COUNT:
        place = outline_place(tables, out)
        for i in range(3 * stations):
            work[place + i] = value
    return 0


def row_size(tables: 'float[:]'):
    """How many numbers an evaluation gives: the outputs, and the outlines where they follow behind them."""
    stations = int(tables[SET_STATIONS])
    size = OUTPUT_COUNT
    if stations != STATION_COUNT:
        size += 6 * stations
    return size
