"""Named places of an array of outputs: what all parts of a result have in common."""

from types import GenericAlias

import numpy as np

from ..interface.rows import AXES
from . import words as text
from .inputs import number
from .saved import check_mark, version_mark


class View:
    """Named places of an output array (m,) or (n, m) from ``offset`` on, whose rows have this
    ``layout`` (:class:`~wrcontact.results.layout.Layout`)."""

    __slots__ = ("_values", "_offset", "layout")
    __class_getitem__ = classmethod(GenericAlias)  # numbers of a pose, arrays of a table: types alone know
    _members = ()  # names of the parts, in the order of the table
    _shown = ()  # those of them in the short text; () for all

    def __init__(self, values, offset, layout):
        self._values = values
        self._offset = offset
        self.layout = layout

    def __getstate__(self):
        names = [name for kind in type(self).__mro__ for name in getattr(kind, "__slots__", ())]
        return version_mark(), {name: getattr(self, name) for name in names}

    def __setstate__(self, saved):
        mark, values = saved
        check_mark(mark, f"the {type(self).__name__}")
        for name, value in values.items():
            setattr(self, name, value)

    def __repr__(self):
        shown = [f"{name}={text.short(getattr(self, name))}" for name in self._shown or self._members]
        poses = [f"{self._values.shape[0]} poses"] if self._values.ndim > 1 else []
        return f"{type(self).__name__}({', '.join(poses + shown)})"

    def __len__(self):
        if self._values.ndim == 1:
            raise TypeError(f"the {type(self).__name__} of one pose has no length")
        return self._values.shape[0]

    def __bool__(self):
        """Whether a table has rows; what belongs to one pose is there."""
        return self._values.ndim == 1 or len(self) > 0

    def to_dict(self):
        """All values by name, dicts in dicts: of one pose numbers and lists, of a table arrays (n, ...)."""
        single = self._values.ndim == 1
        return {name: plain(getattr(self, name), single) for name in self._members}


def plain(value, single):
    """A part of a result for a dict."""
    if isinstance(value, View):
        return value.to_dict()
    if isinstance(value, tuple):
        return [entry.to_dict() for entry in value]
    return value.tolist() if single and isinstance(value, np.ndarray) else value


def number_at(place, words):
    """A property for one value at ``place``: a float, or (n,) for a table."""
    return property(lambda self: number(self._values[..., self._offset + place]), doc=words)


def view_at(kind, place, words):
    """A property that is a view of ``kind`` from ``place`` on."""
    return property(lambda self: kind(self._values, self._offset + place, self.layout), doc=words)


def words_of(row, behind="."):
    """The docstring of a row's property."""
    words = row.meaning.format(axis=", ".join(way for _, way in AXES))
    return f"{words[0].upper()}{words[1:]} [{row.unit}]{behind}"
