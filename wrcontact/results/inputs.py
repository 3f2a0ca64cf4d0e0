"""The inputs that a state belongs to: an array whose columns have names."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..interface.index import PLACES
from ..interface.inputs import INPUT_NAMES, INPUTS
from ..methods.numbers import unit_behind
from ..methods.words import did_you_mean
from .fields import InputFields
from .views import number
from .words import short


class Rows:
    """Rows of inputs (n, inputs), of which only the columns that vary are held.

    Parameters
    ----------
    start : an array (inputs,), the values of all others.
    places : of those that vary (k,), and their values ``columns`` (n, k).
    named : whether outputs were asked for by name: files and frames of the table then have no other inputs.
    """

    __slots__ = ("start", "places", "columns", "named")

    def __init__(self, start, places, columns, named=False):
        self.start, self.places, self.columns, self.named = start, places, columns, named

    @classmethod
    def of(cls, given, count, named):
        """Of the inputs ``given``, a number or an array each, in ``count`` rows."""
        places = [place for place, values in enumerate(given) if np.ndim(values)]
        start = np.array([math.nan if np.ndim(values) else float(values) for values in given])
        columns = np.empty((count, len(places)))
        for column, place in enumerate(places):
            columns[:, column] = given[place]
        return cls(start, places, columns, named)

    def __len__(self):
        return len(self.columns)

    def __getitem__(self, key):
        """A row (inputs,), or some (m, inputs), as an array."""
        columns = self.columns[key]
        found = np.empty((*columns.shape[:-1], len(self.start)))
        found[:] = self.start
        found[..., self.places] = columns
        return found

    def part(self, key):
        """Some of the rows; of one row, whose ``columns`` are (k,), ``[:]`` is an array (inputs,)."""
        return Rows(self.start, self.places, self.columns[key], self.named)

    def as_table(self):
        """One row as rows."""
        return self.part(None)

    def column(self, place):
        """The values (n,) of the input at this ``place``."""
        if place in self.places:
            return self.columns[:, self.places.index(place)]
        return np.full(len(self), self.start[place])

    @property
    def varying(self):
        """Names of the inputs that vary."""
        return tuple(INPUT_NAMES[place] for place in self.places)

    @property
    def names(self):
        """Names of the inputs that files and frames of the table have."""
        return self.varying if self.named else INPUT_NAMES


class Inputs(InputFields):
    """Inputs in SI, in the order of wrcontact/interface/inputs.py: (inputs,) of one pose, (n, inputs) of a
    table.

    ``inputs.lateral_shift`` and ``inputs["left.friction"]`` are a number, (n,) of a table.  For everything
    else it is an array; whole rows keep the names, other parts and what is computed with it do not.
    """

    compliant = False  #: whether they are those of compliant contact, for :func:`wrcontact.explain`

    @classmethod
    def of(cls, array: NDArray[Any], compliant: bool) -> Inputs:
        """The ``array`` with names."""
        found = array.view(cls)
        found.compliant = compliant
        return found

    def __getitem__(self, key: Any) -> Any:
        array = self.view(np.ndarray)
        if not isinstance(key, str):
            found = array[key]
            whole = not isinstance(key, tuple) and np.shape(found)[-1:] == array.shape[-1:]
            return Inputs.of(found, self.compliant) if whole else found
        if key not in PLACES:
            raise KeyError(f"there is no input {key!r}{did_you_mean(key, PLACES)}")
        return number(array[..., PLACES[key]])

    def __array_wrap__(self, array: Any, context: Any = None, return_scalar: bool = False) -> Any:
        return array[()] if array.ndim == 0 else array.view(np.ndarray)

    def to_dict(self) -> dict[str, Any]:
        """All of them by the names of an FMU."""
        return {name: self[name] for name in INPUT_NAMES}

    def __repr__(self) -> str:
        """The main ones, and others that are not at their start."""
        poses = [f"{len(self)} poses"] if self.ndim > 1 else []
        shown = [
            f"{row.keyword}={short(self[row.name])}{unit_behind(row.unit)}"
            for row in INPUTS
            if row.positional or np.any(self[row.name] != row.start)
        ]
        return f"Inputs({', '.join(poses + shown)})"

    __str__ = __repr__
