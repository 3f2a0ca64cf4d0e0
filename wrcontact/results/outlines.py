"""The outline of a wheel's patches at stations, and the strips of a patch, as parts of a result."""

from ..interface import outputs as table
from ..interface.rows import Run
from ..kernel import layout
from . import columns
from .views import View, words_of


def station_count(values):
    """The number of stations in outlines of this output array."""
    return columns.station_count(values.shape[-1])


def outline_offset(values, first):
    """Where the outline of the side whose outputs begin at ``first`` lies, see kernel/patch/outline.py."""
    if station_count(values) == layout.STATION_COUNT:
        return first + layout.SIDE_STATION
    behind = layout.RUN_COUNT * station_count(values) if first == layout.OUT_RIGHT else 0
    return layout.OUTPUT_COUNT + behind


def _run(number, words):
    """A property for array ``number`` of an outline: (stations,), or (n, stations) for a table."""

    def read(self):
        stations = station_count(self._values)
        start = self._offset + number * stations
        return self._values[..., start : start + stations]

    return property(read, doc=words)


class Outline(View):
    """Outline and pressure at evenly spaced stations across, from the first loaded place to the last."""

    __slots__ = ("_is_right",)
    _members = tuple(row.name for row in table.SIDE if isinstance(row, Run))

    def __init__(self, values, offset, is_right):
        super().__init__(values, offset)
        self._is_right = is_right


for _place, _row in enumerate(row for row in table.SIDE if isinstance(row, Run)):
    setattr(Outline, _row.name, _run(_place, words_of(_row, ", one value per station.")))


def _wear_run(number, row):
    """A property for array ``number`` of the outputs of wear at the stations of an outline."""

    def read(self):
        width, stations = self._values.shape[-1], station_count(self._values)
        if not columns.has_wear(width):
            raise AttributeError(f"{row.name} is not computed; it needs ContactSystem(wear_outputs=True)")
        behind = layout.WEAR_RUN_COUNT if self._is_right else 0
        start = columns.wear_place(width) + (behind + number) * stations
        return self._values[..., start : start + stations]

    return property(read, doc=words_of(row, ", one value per station; with wear_outputs."))


class WornOutline(Outline):
    """An outline with the outputs of wear."""

    __slots__ = ()
    _members = Outline._members + tuple(row.name for row in table.WEAR)


for _place, _row in enumerate(table.WEAR):
    setattr(Outline, _row.name, _wear_run(_place, _row))


class Strips(View):
    """The strips of a patch along the rolling direction, across the rail: arrays (16,), or (n, 16) of a
    table, zero where the patch is not there."""

    __slots__ = ()
    _members = tuple(row.name for row in table.STRIPS)


def _of_strips(row):
    """A property for one number of each strip."""
    place, count = getattr(layout.StripOutputs, row.field).offset // 8, layout.ROLLING_STRIP_LIMIT

    def read(self):
        start = self._offset + place
        return self._values[..., start : start + count]

    return property(read, doc=words_of(row, ", one value per strip."))


for _row in table.STRIPS:
    setattr(Strips, _row.name, _of_strips(_row))
