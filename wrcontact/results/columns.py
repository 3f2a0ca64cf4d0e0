"""Names of the columns of an output array, and the choice of those that a table keeps."""

import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache

import numpy as np

from ..interface.outputs import SIDE, WEAR
from ..interface.rows import Run
from ..interface.variables import INPUT, OUTPUT, VARIABLES
from ..kernel import layout
from ..methods.numbers import check_choice
from ..methods.words import did_you_mean

SIDES = {"left": layout.OUT_LEFT, "right": layout.OUT_RIGHT}
#: The number of a side's outputs that each depth computes.
DEPTH_SIZES = {"all": layout.SIDE_SIZE, "patches": layout.SIDE_STATION, "geometry": layout.SIDE_PENETRATION}
#: Outputs that are there whatever is wanted.
ALWAYS = ("roll", "vertical_shift")
#: The outcome of a step, which every table has; who asks for it by name gets that of the whole contact.
STATUS = "status"
PERMITTED = (
    "; permitted are 'all', 'patches', 'geometry', or names such as 'right.area', 'right.patch' and "
    "'roll' (docs/reference/nomenclature.md)"
)
RUNS = tuple(row.name for row in SIDE if isinstance(row, Run))
#: Runs that are there with wear_outputs only.
WEAR_RUNS = tuple(row.name for row in WEAR)
INPUT_PLACES = {v.name: v.index for v in VARIABLES if v.causality == INPUT}
#: Variables of the kernel's outputs by name.
OUTPUTS = {v.name: v for v in VARIABLES if v.causality == OUTPUT and v.index is not None}


def has_wear(width):
    """Whether output arrays of ``width`` numbers have the outputs of wear: these are an odd number."""
    return (width - layout.OUTPUT_COUNT) % 2 == 1


@cache
def station_count(width):
    """The number of stations of each outline in output arrays of ``width`` numbers."""
    behind = width - layout.OUTPUT_COUNT
    if not has_wear(width):
        return behind // (2 * layout.RUN_COUNT) if behind else layout.STATION_COUNT
    behind -= layout.WEAR_END
    if behind == 2 * layout.WEAR_RUN_COUNT * layout.STATION_COUNT:
        return layout.STATION_COUNT
    return behind // (2 * (layout.RUN_COUNT + layout.WEAR_RUN_COUNT))


def wear_place(width):
    """Where the outputs of wear begin in output arrays of ``width`` numbers."""
    stations = station_count(width)
    return layout.OUTPUT_COUNT + (0 if stations == layout.STATION_COUNT else 2 * layout.RUN_COUNT * stations)


def strips_place(width, side, patch):
    """Where the strips of a patch, 0 ... 2, of a ``side`` begin in output arrays with outputs of wear."""
    behind = 2 * layout.WEAR_RUN_COUNT * station_count(width)
    number = layout.PATCH_LIMIT * (*SIDES,).index(side) + patch
    return wear_place(width) + behind + layout.STRIP_OUTPUTS_SIZE * number


@cache
def output_places(width):
    """{name: place} of all outputs in output arrays of ``width`` numbers."""
    stations, behind = station_count(width), []
    places = {name: variable.index for name, variable in OUTPUTS.items() if not is_run(name, WEAR_RUNS)}
    if stations != layout.STATION_COUNT:
        places = {name: place for name, place in places.items() if not is_run(name)}
        behind.append(RUNS)
    if has_wear(width):
        behind.append(WEAR_RUNS)
    names = (
        f"{side}.{run}[{j + 1}]" for runs in behind for side in SIDES for run in runs for j in range(stations)
    )
    return places | {name: layout.OUTPUT_COUNT + place for place, name in enumerate(names)}


@cache
def _names_by_place(width):
    return {place: name for name, place in output_places(width).items()}


def output_names(places, width):
    """Names of the outputs at ``places`` (None: all), in their order."""
    if places is None:
        return tuple(output_places(width))
    known = _names_by_place(width)
    return tuple(known[place] for place in places.tolist() if place in known)


def is_run(name, runs=(*RUNS, *WEAR_RUNS)):
    """Whether this is a number of an outline, such as ``right.pressure[7]``, in one of these ``runs``."""
    return _stem(name).rpartition(".")[2] in runs and name != _stem(name)


def variable_of(name):
    """The variable of an output, also where an outline has other stations than those of an FMU."""
    return OUTPUTS.get(name) or OUTPUTS[f"{_stem(name)}[1]"]


def _stem(name):
    return re.sub(r"\[\d+\]$", "", name)


@dataclass(frozen=True)
class Selection:
    """What a table keeps: ``places`` of its columns in the kernel's outputs (k,), None for all; what has to
    be computed for them, ``side`` and ``depth``; whether outputs were ``named`` one by one."""

    side: str
    depth: str
    places: np.ndarray | None
    named: bool = False


def selected(side, outputs, width):
    """The :class:`Selection` for the arguments ``side`` and ``outputs`` of
    :meth:`~wrcontact.ContactSystem.evaluate_many`.

    Raises
    ------
    ValueError
        if one of them does not exist.
    """
    check_choice("side", side, ("both", *SIDES))
    if not isinstance(outputs, str) or outputs not in DEPTH_SIZES:
        return _named(side, outputs, width)
    if side == "both" and outputs == "all":
        return Selection(side, outputs, None)
    places, strips = list(range(layout.OUT_LEFT)), []
    for name, first in SIDES.items():
        if side in ("both", name):
            places.extend(range(first, first + DEPTH_SIZES[outputs]))
            if outputs == "all":
                runs = (
                    place
                    for run, place in output_places(width).items()
                    if place >= layout.OUTPUT_COUNT and run.startswith(f"{name}.")
                )
                places.extend(runs)
                if has_wear(width):
                    first = strips_place(width, name, 0)
                    strips.extend(range(first, first + layout.WEAR_STRIPS))
    known = _names_by_place(width)
    return Selection(side, outputs, np.array([place for place in places if place in known] + strips))


def _named(side, outputs, width):
    """The selection of outputs given by one name or several, or by the beginning of names up to a dot or
    bracket."""
    known = output_places(width)
    if isinstance(outputs, str):
        chosen = _matching(outputs, known, "is")
    else:
        if not isinstance(outputs, Iterable):
            raise ValueError(f"outputs is {outputs!r}{PERMITTED}")
        chosen = [full for name in outputs for full in _matching(name, known, "has")]
    if not chosen:
        raise ValueError(f"outputs is empty{PERMITTED}")
    owners = {_owner(name) for name in chosen if name not in ALWAYS}
    if side == "both" and len(owners) == 1:
        side = owners.pop()
    depth = max((_depth(name, known.get(name)) for name in chosen), key=list(reversed(DEPTH_SIZES)).index)
    places = dict.fromkeys(known[name] for name in chosen if name != STATUS)
    return Selection(side, depth, np.array([*places], dtype=int), named=True)


def _matching(name, known, verb):
    """Names of the outputs that ``name`` means."""
    if name == STATUS:
        return [name]
    found = [
        full
        for full in known
        if isinstance(name, str) and (full == name or full.startswith((f"{name}.", f"{name}[")))
    ]
    if not found:
        words = dict.fromkeys(re.sub(r"\[\d+\]", "", full) for full in known)
        hint = did_you_mean(name, [STATUS, *DEPTH_SIZES, *words])
        raise ValueError(f"outputs {verb} {name!r}{PERMITTED}{hint}")
    return found


def _owner(name):
    """Whose output this is: "left", "right", or "both" for the wheelset's."""
    side = name.partition(".")[0]
    return side if side in SIDES else "both"


def _depth(name, place):
    """What has to be computed for the output ``name`` at this place."""
    if is_run(name):
        return "all"
    if name in ALWAYS:
        return "geometry"
    owner = _owner(name)
    loaded = owner == "both" or place - SIDES[owner] >= layout.SIDE_PENETRATION
    return "patches" if loaded or name.endswith(".patch_count") else "geometry"


class Kept:
    """The columns ``places`` (k,) of an output array (n, width), held as ``values`` (n, k); others read as
    NaN."""

    __slots__ = ("values", "_columns")
    ndim = 2

    def __init__(self, values, places, width):
        self.values = values
        self._columns = np.full(width, -1)
        self._columns[places] = np.arange(len(places))

    @property
    def shape(self):
        return len(self.values), len(self._columns)

    def __getitem__(self, key):
        """``self[..., place]`` (n,) or ``self[..., first:stop]`` (n, m)."""
        columns = self._columns[key[-1]]
        if self.values.shape[1] == 0:
            return np.full((len(self.values), *columns.shape), np.nan)
        return np.where(columns < 0, np.nan, self.values[:, columns])

    def row(self, place):
        """One row with all columns (width,)."""
        found = np.full(len(self._columns), np.nan)
        found[self._columns >= 0] = self.values[place][self._columns[self._columns >= 0]]
        return found
