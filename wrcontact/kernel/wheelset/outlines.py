"""Where the outline of each side is: among its outputs, or behind those of both sides for
another number of stations."""

from ..layout import RUN_COUNT, STATION_COUNT, Outline, Tables, Work, offset
from ..patch.outline import fill_outline


def outline_place(tables: Tables, work: Work, index: int):
    """Offset in the workspace of the outline of side ``index``."""
    place = offset(work.outputs.left[index].station, work)
    if tables.stations != STATION_COUNT:
        place = offset(work.outlines[0], work) + RUN_COUNT * tables.stations * index
    return place


def fill_apart(tables: Tables, work: Work, index: int, value: float):
    """Write ``value`` all over a side's outline, where it is not part of the side's outputs."""
    if tables.stations != STATION_COUNT:
        fill_outline(Outline.at(work, outline_place(tables, work, index)), tables.stations, value)
    return 0
