"""The inputs that a state belongs to: an array whose columns have names."""

import numpy as np

from ..interface.inputs import INPUT_NAMES, INPUTS
from ..methods.numbers import unit_behind
from ..methods.words import did_you_mean
from .words import short

#: Places by the names of an FMU and by those of Python's keywords.
PLACES = {name: place for place, row in enumerate(INPUTS) for name in (row.name, row.keyword)}


def number(value):
    """A float of one pose, (n,) of a table."""
    return float(value) if value.ndim == 0 else value


class Inputs(np.ndarray):
    """Inputs in SI, in the order of wrcontact/interface/inputs.py: (inputs,) of one pose, (n, inputs) of a
    table.

    ``inputs.lateral_shift`` and ``inputs["left.friction"]`` are a number, (n,) of a table.  For everything
    else it is an array; whole rows keep the names, other parts and what is computed with it do not.
    """

    compliant = False  #: whether they are those of compliant contact, for :func:`wrcontact.explain`

    @classmethod
    def of(cls, array, compliant):
        """The ``array`` with names."""
        found = array.view(cls)
        found.compliant = compliant
        return found

    def __getitem__(self, key):
        array = self.view(np.ndarray)
        if not isinstance(key, str):
            found = array[key]
            whole = not isinstance(key, tuple) and np.shape(found)[-1:] == array.shape[-1:]
            return Inputs.of(found, self.compliant) if whole else found
        if key not in PLACES:
            raise KeyError(f"there is no input {key!r}{did_you_mean(key, PLACES)}")
        return number(array[..., PLACES[key]])

    def __array_wrap__(self, array, context=None, return_scalar=False):
        return array[()] if array.ndim == 0 else array.view(np.ndarray)

    def to_dict(self):
        """All of them by the names of an FMU."""
        return {name: self[name] for name in INPUT_NAMES}

    def __repr__(self):
        """The main ones, and others that are not at their start."""
        poses = [f"{len(self)} poses"] if self.ndim > 1 else []
        shown = [
            f"{row.keyword}={short(self[row.name])}{unit_behind(row.unit)}"
            for row in INPUTS
            if row.positional or np.any(self[row.name] != row.start)
        ]
        return f"Inputs({', '.join(poses + shown)})"

    __str__ = __repr__


for _row in INPUTS:
    setattr(
        Inputs,
        _row.keyword,
        property(lambda self, name=_row.name: self[name], doc=f"{_row.words} [{_row.unit}]."),
    )
