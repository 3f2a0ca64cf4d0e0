"""Rows of results by the names of an FMU: tables of states, files of FMUs' results, dictionaries.

A row that has a status other than 0, or a number that is not finite where rubbing is read, is left out and
counted.
"""

import os
import re
from pathlib import Path

import numpy as np

from ..conventions import SIDES
from ..kernel.layout import PATCH_LIMIT
from ..results.runs import PERMITTED, Run
from ..results.views import View
from ..state import WheelsetState
from ..system import ContactSystem
from ..wheel import WheelContact, WheelState

#: Share of rows that may be left out.
MOST_LEFT_OUT = 0.1
NEEDED = 'wear needs results with creep forces: {}(tangential_model="strips", wear_outputs=True)'
#: How a file's results are made.
NEEDED_OF_FILES = (
    "wear needs results with creep forces and the outputs of wear: an FMU with the parameters "
    "tangential_model and wear_outputs"
)
BY_TIME = "time*speed"
#: What is read of a file: of each station of an outline, and of each patch.
OUTLINE = ("station", "half_length", "pressure", "power", "slip", "wheel_place", "rail_place", "patch_of")
PATCH = (
    "tangential.x",
    "tangential.y",
    "saturation",
    "normal_force",
    "creepage.x",
    "creepage.y",
    "friction_power",
    "length",
    "max_pressure",
)


def whole_of(system):
    """The :class:`~wrcontact.ContactSystem` of a ``system`` whose profiles wear, and the side of its only
    wheel, None of a wheelset; ValueError if it is none."""
    if isinstance(system, WheelContact):
        return system.system, system.side
    if isinstance(system, ContactSystem):
        return system, None
    raise ValueError(
        f"system is {type(system).__name__}; permitted is a ContactSystem, or a WheelContact of one wheel"
    )


def prefixes_of(side):
    """What the names of each side begin with; nothing of one wheel."""
    return tuple(f"{one}." for one in SIDES) if side is None else ("",)


class Rows(Run):
    """A run whose columns are read for wear; ``rows["right.power[3]"]`` is (n,), of one wheel ``rows["power[3]"]``.

    Attributes
    ----------
    table : the table of states, or None for a file.
    prefixes : see :func:`prefixes_of`.
    """

    def __init__(self, run, table, prefixes):
        super().__init__(run.columns, run.names, run.name)
        self.table, self.prefixes = table, prefixes

    def __len__(self):
        return len(self["speed"])

    def get(self, name, default=np.nan):
        """A column, or ``default`` (n,) where there is none."""
        return self[name] if name in self else np.full(len(self), default)

    def runs(self, prefix, name, stations):
        """Columns (n, stations) of an outline."""
        return np.stack([self[f"{prefix}{name}[{j + 1}]"] for j in range(stations)], axis=1)

    def strips(self, prefix):
        """Strips of each patch of a table."""
        return (getattr(self.table, prefix[:-1]) if prefix else self.table).strips

    @property
    def stations(self):
        """The number of stations of an outline."""
        first = f"{self.prefixes[-1]}power["
        if f"{first}1]" not in self:
            raise ValueError(f"{self.name} has no column '{first}1]'; {NEEDED_OF_FILES}")
        outlines = [f"{prefix}{name}[" for prefix in self.prefixes for name in OUTLINE]
        numbers = [
            int(found[2])
            for name in self.names
            if (found := re.fullmatch(r"(.+\[)(\d+)\]", name)) and found[1] in outlines
        ]
        missing = [
            f"{one}{number}]"
            for one in outlines
            for number in range(1, max(numbers) + 1)
            if f"{one}{number}]" not in self
        ]
        if missing:
            raise ValueError(
                f"{self.name} has no column {missing[0]!r}, though others have {max(numbers)} stations; permitted are "
                "all stations of all outputs of wear"
            )
        return max(numbers)

    def reads(self):
        """Names of the columns of a file that rubbing is read from."""
        outlines = [f"{prefix}{name}[" for prefix in self.prefixes for name in OUTLINE]
        patches = [f"{prefix}patch[{k + 1}]." for prefix in self.prefixes for k in range(PATCH_LIMIT)]
        return [
            name
            for name in self.names
            if name.startswith(tuple(outlines))
            or any(name == patch + one for patch in patches for one in PATCH)
        ]

    def picked(self, places):
        """Some of the rows."""
        if self.table is not None:
            table = self.table[places]
            return Rows(Run.of(table), table, self.prefixes)
        columns = {name: np.asarray(self.columns[name])[places] for name in self.names}
        return Rows(Run(columns, columns, self.name), None, self.prefixes)

    def valid(self):
        """Which rows (n,) count; ValueError if more than MOST_LEFT_OUT do not."""
        good = np.isfinite(self["speed"])
        if "status" in self:
            good &= self["status"] == 0
        for prefix in self.prefixes:
            good &= np.isfinite(self.get(f"{prefix}friction_power", 0.0))
        for name in self.reads() if self.table is None else ():
            good &= np.isfinite(self[name])
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


def rows_of_table(table, side=None):
    """:class:`Rows` of a table of states of a wheelset, or of the wheel of a ``side``; ValueError without
    outputs of wear or creep forces."""
    kind, maker = (WheelsetState, ContactSystem) if side is None else (WheelState, WheelContact)
    if not isinstance(table, kind):
        raise ValueError(
            f"table is {type(table).__name__}; permitted with a {maker.__name__} is what its evaluate_many "
            "returns"
        )
    if side is not None and table.side != side:
        raise ValueError(f"table is of a {table.side} wheel; permitted is one of a {side} wheel")
    table, needed_words = table._as_table(), NEEDED.format(maker.__name__)
    if not table.layout.wear:
        raise ValueError(f"the table has no outputs of wear; {needed_words}")
    rows = Rows(Run.of(table), table, prefixes_of(side))
    refuse_without_creep(rows, needed_words)
    return rows


def refuse_without_creep(rows, needed_words):
    """ValueError if no row has a creep force where wheels roll."""
    power = sum(
        np.nansum(np.abs(rows.get(f"{prefix}{name}", 0.0)))
        for prefix in rows.prefixes
        for name in ("friction_power", "wear_number")
    )
    if power == 0.0:
        raise ValueError(f"{rows.name} has no creep forces; {needed_words}")


def rows_of_file(results, side=None):
    """:class:`Rows` of a file of an FMU's results, .csv or .parquet, or of columns by name; of the FMU of one
    wheel with a ``side``."""
    if isinstance(results, (str, os.PathLike)):
        _check_file(Path(results))
    if isinstance(results, View):
        raise ValueError(f"results is {type(results).__name__}; permitted are {PERMITTED}")
    rows = Rows(Run.of(results, "results"), None, prefixes_of(side))
    if side is None and "power[1]" in rows:
        raise ValueError(
            f"{rows.name} has results of one wheel; permitted with a ContactSystem are a wheelset's"
        )
    if side is not None and "right.power[1]" in rows:
        raise ValueError(
            f"{rows.name} has results of a wheelset; permitted with a WheelContact are one wheel's"
        )
    rows["speed"], rows.stations  # both are needed
    refuse_without_creep(rows, NEEDED_OF_FILES)
    return rows


def _check_file(path):
    if path.suffix.lower() not in (".csv", ".parquet"):
        raise ValueError(f"{path} ends in {path.suffix!r}; permitted are .csv and .parquet")
    if not path.is_file():
        raise ValueError(
            f"results is '{path}', and there is no such file; permitted is a file of an FMU's results"
        )


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
