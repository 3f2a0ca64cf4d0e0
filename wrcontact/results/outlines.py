"""The outline of a wheel's patches at stations, and the strips of a patch, as parts of a result."""

from ..interface import outputs as table
from ..interface.rows import Run
from ..kernel import layout
from .views import View, words_of


class Outline(View):
    """Outline and pressure at evenly spaced stations across, from the first loaded place to the last."""

    __slots__ = ("_side",)
    _members = tuple(row.name for row in table.SIDE if isinstance(row, Run))

    def __init__(self, values, layout, side):
        super().__init__(values, 0, layout)
        self._side = side


class WornOutline(Outline):
    """An outline with the outputs of wear."""

    __slots__ = ()
    _members = Outline._members + tuple(row.name for row in table.WEAR)


def _run(name, words):
    """A property for a run of an outline: (stations,), or (n, stations) for a table."""

    def read(self):
        if name not in self._members:
            raise AttributeError(f"{name} is not computed; it needs ContactSystem(wear_outputs=True)")
        return self._values[..., self.layout.run(self._side, name)]

    return property(read, doc=words)


for _row in (*table.SIDE, *table.WEAR):
    if isinstance(_row, Run):
        _behind = (
            ", one value per station; with wear_outputs."
            if _row in table.WEAR
            else ", one value per station."
        )
        setattr(Outline, _row.name, _run(_row.name, words_of(_row, _behind)))


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
