"""Results of an evaluation: names for the kernel's output array, for one pose or for a table of poses.

Names, units and words of the properties are those of the rows in wrcontact/interface/outputs.py.
"""

import numpy as np

from .interface import outputs as table
from .interface.rows import AXES, Blocks, Run
from .interface.rows import Vector as VectorRow
from .kernel import layout


def _number(value):
    """A float of one pose, (n,) of a table."""
    return float(value) if value.ndim == 0 else value


def station_count(values):
    """The number of stations in outlines of this output array."""
    behind = values.shape[-1] - layout.OUTPUT_COUNT
    return behind // (2 * layout.RUN_COUNT) if behind else layout.STATION_COUNT


def outline_of(values, first):
    """Stations, half-lengths and pressures (3, stations) of the side of one pose whose outputs begin at
    ``first``."""
    start, stations = outline_offset(values, first), station_count(values)
    return values[start : start + layout.RUN_COUNT * stations].reshape(layout.RUN_COUNT, stations)


def outline_offset(values, first):
    """Where the outline of the side whose outputs begin at ``first`` lies, see kernel/patch/outline.py."""
    if values.shape[-1] == layout.OUTPUT_COUNT:
        return first + layout.SIDE_STATION
    return layout.OUTPUT_COUNT + (
        layout.RUN_COUNT * station_count(values) if first == layout.OUT_RIGHT else 0
    )


class _View:
    """Named places of an output array (m,) or (n, m) from ``offset`` on."""

    __slots__ = ("_values", "_offset")

    def __init__(self, values, offset):
        self._values = values
        self._offset = offset

    def __repr__(self):
        names = [name for name in dir(type(self)) if not name.startswith("_")]
        return f"{type(self).__name__}({', '.join(f'{name}={getattr(self, name)!r}' for name in names)})"


def _at(place, words):
    """A property for one value at ``place``: a float, or (n,) for a table."""
    return property(lambda self: _number(self._values[..., self._offset + place]), doc=words)


def _view(kind, place, words):
    """A property that is a view of ``kind`` from ``place`` on."""
    return property(lambda self: kind(self._values, self._offset + place), doc=words)


def _run(number, words):
    """A property for array ``number`` of an outline: (stations,), or (n, stations) for a table."""

    def read(self):
        stations = station_count(self._values)
        start = self._offset + number * stations
        return self._values[..., start : start + stations]

    return property(read, doc=words)


def _words(row, behind="."):
    """The docstring of a row's property."""
    words = row.meaning.format(axis=", ".join(way for _, way in AXES))
    return f"{words[0].upper()}{words[1:]} [{row.unit}]{behind}"


def _named(rows, record):
    """A class decorator: the properties of ``rows``, which lie in the ``record``, but for those that the
    class has itself.

    Rows with a dot in their name become a view: ``contact.y_wheel`` is a property of ``contact``.
    """

    def decorate(cls):
        for part, members in _parts(rows).items():
            owner = (
                cls
                if not part
                else type(part.capitalize(), (_View,), {"__slots__": (), "__doc__": table.PARTS[part]})
            )
            for name, row in members.items():
                place = getattr(record, row.field).offset // 8
                if name not in vars(owner):
                    setattr(
                        owner,
                        name,
                        _view(Vector, place, _words(row))
                        if isinstance(row, VectorRow)
                        else _at(place, _words(row)),
                    )
            if part:
                globals()[owner.__name__] = owner  # where pickle looks for it
                setattr(cls, part, _view(owner, 0, table.PARTS[part]))
        return cls

    return decorate


def _parts(rows):
    """The rows of single numbers and vectors by what stands before and behind the dot of their names."""
    parts = {}
    for row in rows:
        if not isinstance(row, (Blocks, Run)):
            part, _, name = row.name.rpartition(".")
            parts.setdefault(part, {})[name] = row
    return parts


class Vector(_View):
    """Three components in the track's axes: x forward, y to the right, z down."""

    __slots__ = ()


for _place, (_axis, _way) in enumerate(AXES):
    setattr(Vector, _axis, _at(_place, f"Component {_way}."))


@_named(table.PATCH, layout.Patch)
class Patch(_View):
    """One contact patch."""

    __slots__ = ()


class Outline(_View):
    """Outline and pressure at evenly spaced stations across, from the first loaded place to the last."""

    __slots__ = ()


for _place, _row in enumerate(row for row in table.SIDE if isinstance(row, Run)):
    setattr(Outline, _row.name, _run(_place, _words(_row, ", one value per station.")))


@_named(table.SIDE, layout.SideOutputs)
class Side(_View):
    """One wheel on its rail."""

    __slots__ = ()

    @property
    def patch_count(self):
        """Number of patches; ``patches`` has the three with the largest load."""
        count = self._values[..., self._offset + layout.SIDE_PATCH_COUNT]
        if count.ndim:
            return count
        return int(count) if np.isfinite(count) else 0

    @property
    def patches(self):
        """Patches by decreasing load; in a table always three, with zeros for missing ones."""
        start, size = self._offset + layout.SIDE_PATCH, layout.PATCH_SIZE
        count = layout.PATCH_LIMIT if self._values.ndim > 1 else min(self.patch_count, layout.PATCH_LIMIT)
        return tuple(Patch(self._values, start + size * k) for k in range(count))

    @property
    def outline(self):
        """Outline and pressure over the loaded width."""
        return Outline(self._values, outline_offset(self._values, self._offset))


@_named(table.WHEELSET, layout.Outputs)
class WheelsetState:
    """Result of an evaluation.

    Attributes
    ----------
    status : a :class:`~wrcontact.Status`; (n,) of a table, likewise the numbers that follow.
    roll [rad], vertical_shift [m], force [N], moment [N m] : of the wheelset; see their own words.
    left, right : a :class:`Side` each.
    inputs : the inputs, in the order of wrcontact/interface/inputs.py; (n, ...) for a table.
    values : the kernel's outputs, likewise.
    """

    __slots__ = ("values", "status", "inputs")
    _offset = 0

    def __init__(self, values, status, inputs):
        self.values = values
        self.status = status
        self.inputs = inputs

    @property
    def _values(self):
        return self.values

    @property
    def left(self):
        """The left wheel."""
        return Side(self.values, layout.OUT_LEFT)

    @property
    def right(self):
        """The right wheel."""
        return Side(self.values, layout.OUT_RIGHT)

    def __len__(self):
        if self.values.ndim == 1:
            raise TypeError("the state of one pose has no length")
        return len(self.values)

    def __repr__(self):
        if self.values.ndim > 1:
            return f"WheelsetState({len(self.values)} poses)"
        return (
            f"WheelsetState(status={self.status!r}, roll={self.roll:.6g} rad, "
            f"vertical_shift={self.vertical_shift:.6g} m)"
        )
