"""Runs: columns by the names of an FMU, from states, from arrays by name, or from a file of results."""

from __future__ import annotations

import csv
from collections.abc import Collection
from os import PathLike, fspath
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..interface.inputs import INPUT_NAMES
from ..interface.one_wheel import wheel_inputs
from ..methods.words import did_you_mean
from .convert import needed

PERMITTED = (
    "the path of a .csv or .parquet file, what fmpy returns, a pandas.DataFrame, and a dictionary of columns"
)
#: How fmpy writes a Boolean, and an empty cell.
WORDS = {"True": 1.0, "False": 0.0, "": np.nan}


class Run:
    """Columns in SI by FMU name, ``run["right.area"]``: (n,), or one number of a state of one pose.

    Attributes
    ----------
    columns : what has them by name.
    names : of the columns.
    name : of the run, for sentences.
    """

    def __init__(self, columns: Any, names: Collection[str], name: str) -> None:
        self.columns, self.names, self.name = columns, names, name

    @classmethod
    def of(cls, run: Any, argument: str = "run") -> Run:
        """That of a state or table, of arrays (n,) by name (a dict, the result of fmpy, a DataFrame of any kind), or of
        the file at a path; ValueError if it is none of these."""
        if isinstance(run, Run):
            return run
        if isinstance(run, (str, PathLike)):
            columns = read_run(run)
            return cls(columns, columns, Path(run).name)
        if hasattr(run, "inputs") and hasattr(run, "names"):  # of a wheelset, or of one wheel
            inputs = wheel_inputs(run.side) if hasattr(run, "side") else INPUT_NAMES
            return cls(run, dict.fromkeys((*run.names, *inputs, "status")), "the table")
        names = run if hasattr(run, "keys") else getattr(run, "columns", None)
        names = getattr(getattr(run, "dtype", None), "names", names)
        if names is None:
            raise ValueError(f"{argument} is {type(run).__name__}; permitted are {PERMITTED}, and states")
        return cls(run, dict.fromkeys(names), f"the {argument}")

    def __contains__(self, name: object) -> bool:
        return name in self.names

    def __getitem__(self, name: str) -> NDArray[Any]:
        if name not in self.names:
            raise ValueError(f"{self.name} has no column {name!r}{did_you_mean(name, self.names)}")
        return np.asarray(self.columns[name], dtype=float)[()]


def read_run(path: str | PathLike[str]) -> dict[str, NDArray[Any]]:
    """Arrays (n,) by name from a .parquet file, or from a CSV file: a line of names, then numbers, as fmpy and
    ``wrcontact sweep`` write it.

    Raises
    ------
    ValueError
        where a line has not as many numbers as there are names, in a sentence.
    """
    if Path(path).suffix.lower() == ".parquet":
        frame = needed("pandas", "a .parquet file").read_parquet(path)
        return {name: frame[name].to_numpy() for name in frame}
    try:
        with open(path, newline="", encoding="utf-8-sig") as file:
            rows = [row for row in csv.reader(file) if row]
    except UnicodeDecodeError as wrong:
        raise ValueError(
            f"{fspath(path)} is not text in UTF-8 (byte {wrong.start}); permitted is a CSV file in UTF-8"
        ) from None
    except csv.Error as wrong:
        raise ValueError(f"{fspath(path)} is no CSV file: {wrong}") from None
    if len(rows) < 2:
        raise ValueError(
            f"{fspath(path)} has no rows; permitted is a line of names, and lines of numbers below"
        )
    names = [name.strip() for name in rows[0]]
    for line, row in enumerate(rows[1:], 2):
        if len(row) != len(names):
            raise ValueError(
                f"row {line} of {fspath(path)} has {len(row)} values; permitted are as many as there are "
                f"names, {len(names)}"
            )
    try:
        values = np.array([[_number(value) for value in row] for row in rows[1:]])
    except ValueError as wrong:
        raise ValueError(f"{fspath(path)} has a value that is no number: {wrong}") from None
    return dict(zip(names, values.T))


def _number(text):
    return WORDS[text] if text in WORDS else float(text)
