"""Rows of results by the names of an FMU: tables of states, files of FMUs' results, dictionaries.

A row that has a status other than 0, or a number that is not finite where rubbing is read, is left out and
counted.
"""

import os
import re
from pathlib import Path

import numpy as np

from ..conventions import SIDES
from ..methods.words import did_you_mean
from ..results.columns import has_wear
from ..results.convert import needed
from ..state import WheelsetState

#: Share of rows that may be left out.
MOST_LEFT_OUT = 0.1
NEEDED = 'wear needs results with creep forces: ContactSystem(tangential_model="strips", wear_outputs=True)'
#: How a file's results are made.
NEEDED_OF_FILES = (
    "wear needs results with creep forces and the outputs of wear: an FMU with the parameters "
    "tangential_model and wear_outputs"
)
BY_TIME = "time*speed"


class Rows:
    """Columns by name; ``rows["right.power[3]"]`` is (n,).

    Attributes
    ----------
    table : the table of states, or None for a file.
    name : for sentences.
    """

    def __init__(self, columns, table, name):
        self.columns, self.table, self.name = columns, table, name

    def __len__(self):
        return len(self["speed"])

    def __contains__(self, name):
        return name in self.columns

    def __getitem__(self, name):
        if name not in self.columns:
            raise ValueError(f"{self.name} has no column {name!r}{did_you_mean(name, self.columns)}")
        return np.asarray(self.columns[name], dtype=float)

    def get(self, name, default=np.nan):
        """A column, or ``default`` (n,) where there is none."""
        return self[name] if name in self.columns else np.full(len(self), default)

    def runs(self, side, name, stations):
        """Columns (n, stations) of an outline."""
        return np.stack([self[f"{side}.{name}[{j + 1}]"] for j in range(stations)], axis=1)

    @property
    def stations(self):
        """The number of stations of an outline."""
        numbers = [
            int(found[1]) for name in self.columns if (found := re.fullmatch(r"right\.power\[(\d+)\]", name))
        ]
        if not numbers:
            raise ValueError(f"{self.name} has no column 'right.power[1]'; {NEEDED_OF_FILES}")
        return max(numbers)

    def picked(self, places):
        """Some of the rows."""
        if self.table is not None:
            table = self.table[places]
            return Rows(TableColumns(table), table, self.name)
        columns = {name: np.asarray(values)[places] for name, values in self.columns.items()}
        return Rows(columns, None, self.name)

    def valid(self):
        """Which rows (n,) count; ValueError if more than MOST_LEFT_OUT do not."""
        good = np.isfinite(self["speed"])
        if "status" in self:
            good &= self["status"] == 0
        for side in SIDES:
            good &= np.isfinite(self.get(f"{side}.friction_power", 0.0))
        if not len(good):
            raise ValueError(f"{self.name} has no rows; permitted are tables of one row or more")
        if (left_out := np.count_nonzero(~good)) > MOST_LEFT_OUT * len(good):
            raise ValueError(
                f"{left_out} of {len(good)} rows of {self.name} have a status other than 0 or "
                f"numbers that are not finite; permitted are {100 * MOST_LEFT_OUT:g} % of them"
            )
        slow = good & ~(np.abs(self["speed"]) > 0.0)
        if np.any(slow):
            raise ValueError(
                f"speed is 0 in row {int(np.argmax(slow))} of {self.name}; permitted is a speed "
                "that is not zero, since wear is counted per distance"
            )
        return good


class TableColumns:
    """A table of states as a mapping of names to columns."""

    def __init__(self, table):
        self.table = table
        self.names = set(table.names)

    def __contains__(self, name):
        return name in ("status", "speed", "left.friction", "right.friction") or name in self.names

    def __iter__(self):
        return iter(self.names)

    def __getitem__(self, name):
        return self.table[name]


def rows_of_table(table):
    """:class:`Rows` of a table of states; ValueError without outputs of wear or creep forces."""
    if not isinstance(table, WheelsetState):
        raise ValueError(f"table is {type(table).__name__}; permitted is what evaluate_many returns")
    if table.values.ndim == 1:
        table = table._as_table()
    if not has_wear(table._values.shape[-1]):
        raise ValueError(f"the table has no outputs of wear; {NEEDED}")
    rows = Rows(TableColumns(table), table, "the table")
    refuse_without_creep(rows, NEEDED)
    return rows


def refuse_without_creep(rows, needed_words):
    """ValueError if no row has a creep force where wheels roll."""
    power = sum(
        np.nansum(np.abs(rows.get(f"{side}.{name}", 0.0)))
        for side in SIDES
        for name in ("friction_power", "wear_number")
    )
    if power == 0.0:
        raise ValueError(f"{rows.name} has no creep forces; {needed_words}")


def rows_of_file(results):
    """:class:`Rows` of a file of an FMU's results, .csv or .parquet, or of columns by name."""
    if isinstance(results, (str, os.PathLike)):
        path = Path(results)
        columns, name = _read(path), path.name
    elif hasattr(results, "keys") or getattr(getattr(results, "dtype", None), "names", None):
        names = list(results) if hasattr(results, "keys") else results.dtype.names
        columns, name = {key: np.asarray(results[key]) for key in names}, "the results"
    else:
        raise ValueError(
            f"results is {type(results).__name__}; permitted are the path of a .csv or .parquet file, what "
            "fmpy returns, a pandas.DataFrame, and a dictionary of columns"
        )
    rows = Rows(columns, None, name)
    rows["speed"], rows.stations  # both are needed
    refuse_without_creep(rows, NEEDED_OF_FILES)
    return rows


def _read(path):
    if path.suffix.lower() == ".parquet":
        frame = needed("pandas", "a .parquet file").read_parquet(path)
        return {name: frame[name].to_numpy() for name in frame}
    if path.suffix.lower() != ".csv":
        raise ValueError(f"{path} ends in {path.suffix!r}; permitted are .csv and .parquet")
    if not path.is_file():
        raise ValueError(
            f"results is '{path}', and there is no such file; permitted is a file of an FMU's results"
        )
    with open(path, encoding="utf-8-sig") as file:
        names = [name.strip().strip('"') for name in file.readline().rstrip("\n").split(",")]
        if len(names) < 2:
            raise ValueError(
                f"{path} has the first line {','.join(names)[:60]!r}; permitted is a line of "
                "names with commas, as fmpy writes it"
            )
        try:
            numbers = np.genfromtxt(file, delimiter=",", dtype=float)
        except ValueError as wrong:
            raise ValueError(
                f"{path} has lines that differ in their number of cells: {' '.join(str(wrong).split())[:120]}"
            ) from None
    numbers = numbers.reshape(-1, len(names)) if numbers.size else np.empty((0, len(names)))
    return dict(zip(names, numbers.T))


def distances(rows, distance, column):
    """Distance (n,) [m] that each row stands for.

    Parameters
    ----------
    distance : None, one number, or (n,) [m]; None for all alike in a table.
    column : of a file: BY_TIME, or the name of a column with the distance run [m]; None for ``distance``.
    """
    if column is None:
        found = _given(1.0 if distance is None else distance, rows)
    elif column == BY_TIME:
        found = np.abs(rows["speed"]) * _shares(rows["time"], rows, "time")
    else:
        found = _shares(rows[column], rows, column)
    if not (np.all(found[np.isfinite(rows["speed"])] >= 0.0) and np.sum(found) > 0.0):
        raise ValueError(
            f"distance is {float(np.min(found)):g} m in a row of {rows.name}; permitted is "
            "distance >= 0 m, and a sum above 0 m"
        )
    return found


def _given(distance, rows):
    """``distance`` as numbers (n,), one for each row."""
    permitted = f"permitted is one number, or one for each of the {len(rows)} rows of {rows.name}, in m"
    try:
        found = np.asarray(distance, dtype=float)
    except (TypeError, ValueError):
        raise ValueError(f"distance is {distance!r}; {permitted}") from None
    if found.shape not in ((), (1,), (len(rows),)):
        raise ValueError(f"distance has the shape {found.shape}; {permitted}")
    return np.broadcast_to(found, (len(rows),))


def _shares(values, rows, name):
    """Half the way to both neighbours (n,) of values that do not fall."""
    if len(values) < 2 or np.any(np.diff(values) < 0.0):
        raise ValueError(
            f"column {name!r} of {rows.name} falls, or has fewer than two rows; permitted are "
            "rows in their order"
        )
    steps = np.diff(values)
    return 0.5 * (np.append(steps, 0.0) + np.insert(steps, 0, 0.0))
