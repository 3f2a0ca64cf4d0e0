"""How the numbers of a row of outputs lie: places and names for a number of stations, with and without wear."""

import re
from dataclasses import dataclass, field
from functools import cache

from ..interface.outputs import SIDE, WEAR
from ..interface.rows import Run
from ..interface.variables import OUTPUT, VARIABLES
from ..kernel import layout

#: Places of the first output of each side.
SIDE_STARTS = {"left": layout.OUT_LEFT, "right": layout.OUT_RIGHT}
#: Runs of an outline, with wear_outputs those of wear behind them.
RUNS = tuple(row.name for row in SIDE if isinstance(row, Run))
WEAR_RUNS = tuple(row.name for row in WEAR)
#: Variables of the kernel's outputs by name.
OUTPUTS = {v.name: v for v in VARIABLES if v.causality == OUTPUT and v.index is not None}


def is_run(name):
    """Whether this is a number of an outline, such as ``right.pressure[7]``."""
    stem = _stem(name)
    return stem != name and stem.rpartition(".")[2] in (*RUNS, *WEAR_RUNS)


def variable_of(name):
    """The variable of an output, also where an outline has other stations than those of an FMU."""
    return OUTPUTS.get(name) or OUTPUTS[f"{_stem(name)}[1]"]


def _stem(name):
    return re.sub(r"\[\d+\]$", "", name)


@dataclass(frozen=True)
class Layout:
    """Of the rows of one system: scalars, then both outlines, then outputs of wear.

    Outlines of STATION_COUNT stations stand among the scalars of their side, where an FMU has them.

    Attributes
    ----------
    stations : of each outline.
    wear : whether there are outputs of wear.
    size : how many numbers a row has.
    """

    stations: int = layout.STATION_COUNT
    wear: bool = False
    size: int = field(init=False, compare=False)

    def __post_init__(self):
        behind = 2 * len(WEAR_RUNS) * self.stations + layout.WEAR_END
        object.__setattr__(self, "size", self._wear + behind * self.wear)

    @classmethod
    def of(cls, tables):
        """That of a system with these settings and ``tables``."""
        settings = layout.Tables.at(tables)
        return cls(int(settings.stations), bool(settings.wear))

    @property
    def places(self):
        """{name: place} of all outputs, in the order of the places."""
        return _places(self)

    def names(self, places=None):
        """Names of the outputs at ``places`` (None: all), in their order; the numbers of strips have none."""
        if places is None:
            return tuple(self.places)
        known = _names(self)
        return tuple(known[place] for place in places.tolist() if place in known)

    def run(self, side, name):
        """Where the run ``name`` of the outline of a ``side`` lies, a slice."""
        right = side == "right"
        if name in WEAR_RUNS:
            first = self._wear + (right * len(WEAR_RUNS) + WEAR_RUNS.index(name)) * self.stations
        elif self._is_usual:
            first = SIDE_STARTS[side] + layout.SIDE_STATION + RUNS.index(name) * self.stations
        else:
            first = layout.OUTPUT_COUNT + (right * len(RUNS) + RUNS.index(name)) * self.stations
        return slice(first, first + self.stations)

    def strips(self, side):
        """Where the strips of the patches of a ``side`` begin and end, with outputs of wear."""
        first = self._wear + 2 * len(WEAR_RUNS) * self.stations + layout.WEAR_STRIPS * (side == "right")
        return first, first + layout.WEAR_STRIPS

    @property
    def _is_usual(self):
        return self.stations == layout.STATION_COUNT

    @property
    def _wear(self):
        """Where the outputs of wear begin."""
        return layout.OUTPUT_COUNT + (0 if self._is_usual else 2 * len(RUNS) * self.stations)


#: That of an FMU's variables, without wear.
USUAL = Layout()


@cache
def _places(rows):
    places = {name: variable.index for name, variable in OUTPUTS.items() if not is_run(name)}
    for side in SIDE_STARTS:
        for run in (*RUNS, *WEAR_RUNS * rows.wear):
            first = rows.run(side, run).start
            places |= {f"{side}.{run}[{j + 1}]": first + j for j in range(rows.stations)}
    return dict(sorted(places.items(), key=lambda item: item[1]))


@cache
def _names(rows):
    return {place: name for name, place in rows.places.items()}
