"""Named places of an array of outputs: what all parts of a result have in common."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Generic, overload

import numpy as np
from numpy.typing import NDArray

from ..interface.rows import AXES
from ..kernel.layout import ROLLING_STRIP_LIMIT
from . import words as text
from .layout import Layout
from .saved import check_mark, version_mark

if TYPE_CHECKING:
    from typing_extensions import TypeVar

    N = TypeVar("N", default=float)
else:
    from typing import TypeVar

    N = TypeVar("N")  # a number of one pose, an array of a table


def number(value: NDArray[Any]) -> Any:
    """A float of one pose, (n,) of a table."""
    return float(value) if value.ndim == 0 else value


class View(Generic[N]):
    """Named places of an output array (m,) or (n, m) from ``offset`` on, whose rows have this
    ``layout`` (:class:`~wrcontact.results.layout.Layout`)."""

    __slots__ = ("_values", "_offset", "layout")
    _members: tuple[str, ...] = ()  # names of the parts, in the order of the table
    _shown: tuple[str, ...] = ()  # those of them in the short text; () for all

    def __init__(self, values: Any, offset: int, layout: Layout) -> None:
        self._values = values
        self._offset = offset
        self.layout = layout

    def _number(self, place: int) -> Any:
        """The value at ``place``: a float, or (n,) for a table."""
        return number(self._values[..., self._offset + place])

    def __getstate__(self) -> Any:
        names = [name for kind in type(self).__mro__ for name in getattr(kind, "__slots__", ())]
        return version_mark(), {name: getattr(self, name) for name in names}

    def __setstate__(self, saved: Any) -> None:
        mark, values = saved
        check_mark(mark, f"the {type(self).__name__}")
        for name, value in values.items():
            setattr(self, name, value)

    def __repr__(self) -> str:
        shown = [f"{name}={text.short(getattr(self, name))}" for name in self._shown or self._members]
        poses = [f"{self._values.shape[0]} poses"] if self._values.ndim > 1 else []
        return f"{type(self).__name__}({', '.join(poses + shown)})"

    def __len__(self) -> int:
        if self._values.ndim == 1:
            raise TypeError(f"the {type(self).__name__} of one pose has no length")
        return int(self._values.shape[0])

    def __bool__(self) -> bool:
        """Whether a table has rows; what belongs to one pose is there."""
        return self._values.ndim == 1 or len(self) > 0

    def to_dict(self) -> dict[str, Any]:
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


class Vector(View[N]):
    """Three components in the track's axes: x forward, y to the right, z down, as names, as a sequence of
    three, and with ``np.asarray`` as an array (3,), (n, 3) of a table."""

    __slots__ = ()
    _members = tuple(axis for axis, _ in AXES)

    @property
    def x(self) -> N:
        """Component forward."""
        return self._number(0)

    @property
    def y(self) -> N:
        """Component to the right."""
        return self._number(1)

    @property
    def z(self) -> N:
        """Component down."""
        return self._number(2)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return np.array(self._values[..., self._offset : self._offset + len(AXES)], dtype=dtype)

    def __len__(self) -> int:
        return len(AXES)

    def __iter__(self) -> Iterator[N]:
        return iter([self.x, self.y, self.z])

    @overload
    def __getitem__(self, key: int) -> N: ...
    @overload
    def __getitem__(self, key: slice) -> tuple[N, ...]: ...
    def __getitem__(self, key):
        return tuple(self)[key]


class RunView(View[N]):
    """What has one value for each station of the outline of a ``side``."""

    __slots__ = ("_side",)

    def __init__(self, values: Any, layout: Layout, side: str) -> None:
        super().__init__(values, 0, layout)
        self._side = side

    def _run(self, name: str) -> NDArray[Any]:
        """The values (stations,), or (n, stations) for a table, if they are computed."""
        if name not in self._members:
            raise AttributeError(f"{name} is not computed; it needs ContactSystem(wear_outputs=True)")
        return self._values[..., self.layout.run(self._side, name)]


class StripView(View[N]):
    """What has one value for each strip of a patch."""

    __slots__ = ()

    def _strips(self, place: int) -> NDArray[Any]:
        """The values (16,), or (n, 16) for a table, that begin at ``place``."""
        start = self._offset + place
        return self._values[..., start : start + ROLLING_STRIP_LIMIT]
