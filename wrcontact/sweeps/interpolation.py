"""Values between the states of a table, and how wrong they are against direct evaluation."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from os import PathLike
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..interface.calls import checked_input
from ..interface.index import PLACES
from ..methods.numbers import check_choice, unit_behind
from ..methods.words import did_you_mean
from ..results.layout import variable_of
from ..results.words import ShortText, shown, unit_name
from .grid import keyword_of, row_of
from .specification import system_of
from .stores import DESCRIBED, open_dataset, plain

if TYPE_CHECKING:
    import xarray

#: Methods, and the number of values that an axis needs.
METHODS = {"linear": 2, "cubic": 4}
#: Random poses at which a table is compared with direct evaluation at most, and where their numbers begin.
POSES, SEED = 10_000, 0
#: Share of the errors below the one that is quoted beside median and worst [%].
PERCENTILE = 95.0


def interpolate(
    table: str | PathLike[str] | xarray.Dataset,
    outputs: str | Iterable[str] | None = None,
    method: str = "linear",
) -> Interpolation:
    """What gives values between the states of a table that :func:`wrcontact.sweep` has made.

    Parameters
    ----------
    table : the path of a store, or a data set, of which dimensions may have been cut or chosen:
        ``dataset.sel(normal_force=78.5e3)``.
    outputs : names as of an FMU, ``["roll", "right.area"]``, or of the data set; None are all of the table.
    method : "linear", or "cubic": splines, which swing where the contact jumps.

    Raises
    ------
    ValueError
        in one sentence, if the table or an argument is not permitted.
    """
    dataset = open_dataset(table) if isinstance(table, (str, PathLike)) else table
    if not {*DESCRIBED} <= {*getattr(dataset, "attrs", ())}:
        raise ValueError(
            f"table is {str(table)[:60]!r}; permitted is the path of a store, or a data set, of "
            "wrcontact.sweep"
        )
    check_choice("method", method, tuple(METHODS))
    asked = json.loads(dataset.attrs["asked"])
    if lost := [name for name in asked["axes"] if name not in dataset.coords]:
        raise ValueError(
            f"the table has lost its axis {lost[0]}; permitted is a choice that keeps its "
            f"value, dataset.isel({lost[0]}=0)"
        )
    for name in dataset["status"].dims:
        if dataset.sizes[name] < METHODS[method]:
            raise ValueError(
                f"the axis {name} has {dataset.sizes[name]} values; permitted for {method!r} "
                f"are {METHODS[method]} or more; dataset.isel({name}=0) is the table without it"
            )
    return Interpolation(dataset, _names(dataset, outputs), method)


def _names(dataset, outputs):
    """Names of the ``outputs`` as of an FMU."""
    known = {name: dataset[name].attrs["fmu_name"] for name in dataset.data_vars if name != "status"}
    found = []
    for name in known if outputs is None else [outputs] if isinstance(outputs, str) else outputs:
        if not isinstance(name, str) or plain(name) not in known:
            hint = did_you_mean(name, known.values()) or f"; it has {', '.join(known.values())}"
            raise ValueError(f"outputs has {name!r}, which the table does not have{hint}")
        found.append(known[plain(name)])
    if not found:
        raise ValueError("outputs is empty; permitted are outputs of the table")
    return (*found,)


class Interpolation:
    """A table of contacts as a function of its axes.

    Called with a number or an array for each axis, by its name, it returns ``{output: array}``; arrays
    broadcast.  Values are NaN outside the table, and in a cell of which a corner has no result.

    Attributes
    ----------
    axes : {name: array (n,)}, SI.
    outputs : names as of an FMU.
    method : as for :func:`wrcontact.interpolate`.
    """

    def __init__(self, dataset: xarray.Dataset, outputs: tuple[str, ...], method: str) -> None:
        self.outputs, self.method = outputs, method
        status = dataset["status"]
        self.axes = {name: np.asarray(dataset[name], dtype=float) for name in status.dims}
        self._asked = {name: json.loads(dataset.attrs[name]) for name in ("asked", "profiles")}
        self._chosen = {
            name: float(dataset[name]) for name in self._asked["asked"]["axes"] if name not in self.axes
        }
        values = np.stack([np.asarray(dataset[plain(name)].transpose(*self.axes)) for name in outputs], -1)
        without = np.count_nonzero(~np.all(np.isfinite(values), axis=-1))
        if method != "linear" and without:
            raise ValueError(
                f"{without} of {status.size} states have no result; permitted for {method!r} is "
                "a table without such states, a part of this one by dataset.sel, or 'linear'"
            )
        self._grid = (_linear if method == "linear" else _cubic)([*self.axes.values()], values)

    def __repr__(self) -> str:
        sizes = " x ".join(f"{name} {len(values)}" for name, values in self.axes.items())
        return f"Interpolation({sizes}; {', '.join(self.outputs)}; {self.method})"

    def __call__(self, **poses: ArrayLike) -> dict[str, NDArray[Any]]:
        points = self._points(poses)
        values = self._grid(np.stack(points, axis=-1))
        return {name: values[..., place] for place, name in enumerate(self.outputs)}

    def _points(self, poses):
        """Arrays of one shape, one for each axis."""
        given = {keyword_of(name) or name: values for name, values in poses.items()}
        if unknown := [name for name in given if name not in self.axes]:
            raise TypeError(f"the table has no axis {unknown[0]!r}; its axes are {', '.join(self.axes)}")
        if missing := [name for name in self.axes if name not in given]:
            raise TypeError(f"{missing[0]} is not given; the axes are {', '.join(self.axes)}")
        for name in self.axes:
            checked_input(PLACES[name], given[name])
        return np.broadcast_arrays(*(np.asarray(given[name], dtype=float) for name in self.axes))

    @cached_property
    def errors(self) -> Errors:
        """The :class:`Errors` at random poses, always the same ones: as many as the table has states, at most
        10 000."""
        count = min(int(np.prod([*map(len, self.axes.values())])), POSES)
        generator = np.random.default_rng(SEED)
        return self.errors_at(
            **{name: generator.uniform(min(values), max(values), count) for name, values in self.axes.items()}
        )

    def errors_at(self, **poses: ArrayLike) -> Errors:
        """The :class:`Errors` at these ``poses``, arrays (n,) by the names of the axes: the difference from
        the direct evaluation by the system of the table."""
        points = [np.atleast_1d(part).ravel() for part in self._points(poses)]
        system = system_of(self._asked["asked"], self._asked["profiles"])
        points, own = dict(zip(self.axes, points)), self(**dict(zip(self.axes, points)))
        table = system.evaluate_many(
            outputs=self.outputs, **self._asked["asked"]["fixed"], **self._chosen, **points
        )
        wrong = {name: own[name] - table[name] for name in self.outputs}
        both = np.all([np.isfinite(difference) for difference in wrong.values()], axis=0)
        return Errors(
            len(both),
            int(np.count_nonzero(~both)),
            {name: _error(difference, points) for name, difference in wrong.items()},
        )


def _linear(axes, values):
    """A function of points (..., axes) through ``values`` (n, m, ..., outputs); NaN outside."""
    from scipy.interpolate import RegularGridInterpolator  # not needed before

    return RegularGridInterpolator(axes, values, bounds_error=False)


def _cubic(axes, values):
    """The same by tensor products of cubic splines, which go through all values; those of
    RegularGridInterpolator have errors of 5e-4."""
    from scipy.interpolate import NdBSpline, make_interp_spline

    knots = []
    for place, axis in enumerate(axes):
        order = np.argsort(axis)
        spline = make_interp_spline(axis[order], np.take(values, order, place), axis=place)
        knots.append(spline.t)
        values = np.moveaxis(spline.c, 0, place)
    return NdBSpline(tuple(knots), values, k=3, extrapolate=False)


def _error(difference, points):
    """The :class:`Error` of one output."""
    there = np.flatnonzero(np.isfinite(difference))
    if not there.size:
        return Error(np.nan, np.nan, np.nan, {})
    size = np.abs(difference[there])
    worst = there[np.argmax(size)]
    return Error(
        float(np.median(size)),
        float(np.percentile(size, PERCENTILE)),
        float(np.max(size)),
        {name: float(values[worst]) for name, values in points.items()},
    )


@dataclass(frozen=True)
class Error(ShortText):
    """Absolute errors of one output in SI: ``median``, the one that ``most``, 95 of 100, do not exceed, the
    ``worst``, and ``where`` that is, by the names of the axes."""

    median: float
    most: float
    worst: float
    where: dict[str, float]


@dataclass(frozen=True, repr=False)
class Errors:
    """Errors of an interpolation against direct evaluation.

    Attributes
    ----------
    count : compared poses.
    without : those of them that have no result, by the table or directly; they have no part in the numbers.
    by_output : the :class:`Error` of each output; ``errors["right.area"]`` is one.
    """

    count: int
    without: int
    by_output: dict[str, Error]

    def __getitem__(self, name: str) -> Error:
        return self.by_output[name]

    def __repr__(self) -> str:
        """A table in display units."""
        rows = [("", "median", f"{PERCENTILE:g} %", "worst", "at")]
        for name, error in self.by_output.items():
            unit = variable_of(name).unit or "1"
            sizes = [shown(size, unit) for size in (error.median, error.most, error.worst)]
            where = ", ".join(
                f"{axis} {value:.5g}{unit_behind(row_of(axis).unit)}" for axis, value in error.where.items()
            )
            rows.append((f"{name} {f'[{unit_name(unit)}]' * bool(unit_name(unit))}".rstrip(), *sizes, where))
        widths = [max(map(len, column)) for column in list(zip(*rows))[:4]]
        lines = [
            "  ".join([row[0].ljust(widths[0]), *map(str.rjust, row[1:4], widths[1:]), row[4]]).rstrip()
            for row in rows
        ]
        return "\n".join([f"{self.count} poses, {self.without} of them without a result", *lines])
