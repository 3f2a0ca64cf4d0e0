"""The choice of columns that a table keeps."""

import re
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from ..kernel import layout
from ..methods.numbers import check_choice
from ..methods.words import did_you_mean
from .layout import SIDE_STARTS, is_run

#: The number of a side's outputs that each depth computes.
DEPTH_SIZES = {"all": layout.SIDE_SIZE, "patches": layout.SIDE_STATION, "geometry": layout.SIDE_PENETRATION}
#: Outputs that are there whatever is wanted.
ALWAYS = ("roll", "vertical_shift")
#: The outcome of a step, which every table has; requested by name, it is the status of the full evaluation.
STATUS = "status"
PERMITTED = (
    "; permitted are 'all', 'patches', 'geometry', or names such as 'right.area', 'right.patch' and "
    "'roll' (docs/reference/nomenclature.md)"
)


@dataclass(frozen=True)
class Selection:
    """What a table keeps: ``places`` of its columns in the kernel's outputs (k,), None for all; what has to
    be computed for them, ``side`` and ``depth``; whether outputs were ``named`` one by one."""

    side: str
    depth: str
    places: np.ndarray | None
    named: bool = False


def selected(side, outputs, rows):
    """The :class:`Selection` for the arguments ``side`` and ``outputs`` of
    :meth:`~wrcontact.ContactSystem.evaluate_many`, of ``rows`` with this :class:`~wrcontact.results.layout.Layout`.

    Raises
    ------
    ValueError
        if one of them does not exist.
    """
    check_choice("side", side, ("both", *SIDE_STARTS))
    if not isinstance(outputs, str) or outputs not in DEPTH_SIZES:
        return _named(side, outputs, rows)
    if side == "both" and outputs == "all":
        return Selection(side, outputs, None)
    chosen = SIDE_STARTS if side == "both" else (side,)
    places = [place for name, place in rows.places.items() if _is_wanted(name, place, chosen, outputs)]
    if outputs == "all" and rows.wear:
        places.extend(range(*rows.strips(side)))
    return Selection(side, outputs, np.array(places))


def _is_wanted(name, place, sides, depth):
    """Whether the output ``name`` at this place is one of the wheelset, or of ``sides`` to this ``depth``."""
    owner = _owner(name)
    return (
        owner == "both"
        or owner in sides
        and (depth == "all" or place - SIDE_STARTS[owner] < DEPTH_SIZES[depth])
    )


def _named(side, outputs, rows):
    """The selection of outputs given by one name or several, or by the beginning of names up to a dot or
    bracket."""
    known = rows.places
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
    return side if side in SIDE_STARTS else "both"


def _depth(name, place):
    """What has to be computed for the output ``name`` at this place."""
    if is_run(name):
        return "all"
    if name in ALWAYS:
        return "geometry"
    owner = _owner(name)
    loaded = owner == "both" or place - SIDE_STARTS[owner] >= layout.SIDE_PENETRATION
    return "patches" if loaded or name.endswith(".patch_count") else "geometry"


class Kept:
    """The columns ``places`` (k,) of an array of outputs (n, ``size``), held as ``values`` (n, k); others read as
    NaN."""

    __slots__ = ("values", "_columns")
    ndim = 2

    def __init__(self, values, places, size):
        self.values = values
        self._columns = np.full(size, -1)
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
