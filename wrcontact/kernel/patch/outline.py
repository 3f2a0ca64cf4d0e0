"""Where the outline of a side lies: three runs of equal length, its stations, half-lengths and pressures.

With STATION_COUNT stations it is part of the side's outputs.  With another number the outlines of both sides, left then
right, follow behind all outputs, and the places for it among the side's own stay zero.
"""

from ..layout import (
    OUT_LEFT,
    OUTPUT_COUNT,
    SIDE_STATION,
    STATION_COUNT,
    WORK_OUTLINES,
    WORK_OUTPUTS,
    SideOutputs,
    Tables,
    Work,
    offset,
)


def outline_place(tables: Tables, work: Work, out: SideOutputs):
    """Offset in the workspace of the outline of the side whose outputs are at ``out``."""
    stations = int(tables.stations)
    place = offset(out, work) + SIDE_STATION
    if stations != STATION_COUNT:
        place = WORK_OUTLINES
        if offset(out, work) > WORK_OUTPUTS + OUT_LEFT:
            place += 3 * stations
    return place


def fill_apart(tables: Tables, work: Work, out: SideOutputs, value: float):
    """Write ``value`` all over a side's outline, where it is not part of the side's outputs."""
    stations = int(tables.stations)
    if stations != STATION_COUNT:
        place = outline_place(tables, work, out)
        for i in range(3 * stations):
            work[place + i] = value
    return 0


def row_size(tables: Tables):
    """How many numbers an evaluation gives: the outputs, and the outlines where they follow behind them."""
    stations = int(tables.stations)
    size = OUTPUT_COUNT
    if stations != STATION_COUNT:
        size += 6 * stations
    return size
