"""The table of a fleet: a row for each pair, and one for each file that cannot be used."""

import csv
import io
import math
from dataclasses import dataclass

import numpy as np

from ..conditioning.measures import PAIR
from ..results.convert import needed
from ..results.words import plain

OTHERS = ("wheel", "rail", "wheel_file", "rail_file", "error", "usable", "remarks", "json", "picture")


def numbers_of(report):
    """The numbers in PAIR of a :class:`~wrcontact.conditioning.Conditioning`; None where there is no value."""
    return plain({name: one.read(report) for name, one in PAIR.items()})


def empty_row(wheel="", rail="", **more):
    """A row without numbers."""
    return {
        "wheel": wheel,
        "rail": rail,
        "wheel_file": "",
        "rail_file": "",
        "error": "",
        "usable": False,
        **dict.fromkeys(PAIR),
        "remarks": [],
        "json": "",
        "picture": "",
        **more,
    }


@dataclass(frozen=True, repr=False)
class Fleet:
    """The rows of :func:`wrcontact.check_fleet`, pairs in the order of their wheels and then of their rails,
    after them the files that cannot be used.

    ``fleet[3]`` is a row, ``fleet["conicity_3mm"]`` a column as an array.

    Attributes
    ----------
    rows : tuple of dicts: names and files of the pair, ``error`` (a sentence, or ""), ``usable``, numbers in
        SI (None where there is no value), ``remarks``, and the paths of ``json`` and ``picture`` in the
        folder.
    report : path of the report in HTML; None where no folder was given.
    """

    rows: tuple
    report: str | None = None

    def __len__(self):
        return len(self.rows)

    def __iter__(self):
        return iter(self.rows)

    def __getitem__(self, key):
        if not isinstance(key, str):
            return self.rows[key]
        if key not in (*OTHERS, *PAIR):
            raise KeyError(f"{key!r}; there are {', '.join((*OTHERS, *PAIR))}")
        values = [row[key] for row in self.rows]
        if key in PAIR:
            return np.array([math.nan if value is None else value for value in values], dtype=float)
        return np.array(values, dtype=bool if key == "usable" else object)

    def __repr__(self):
        wrong = len(self.broken)
        return (
            f"Fleet({len(self) - wrong} pairs, {int(self['usable'].sum())} of them usable"
            f"{f'; rows with an error: {wrong}' if wrong else ''})"
        )

    @property
    def broken(self):
        """The rows with an error."""
        return tuple(row for row in self.rows if row["error"])

    def to_pandas(self):
        """A pandas.DataFrame with a column for each entry of a row.

        Raises
        ------
        ImportError
            in one sentence, if pandas is not installed.
        """
        pandas = needed("pandas", "to_pandas")
        return pandas.DataFrame({name: self[name] for name in (*OTHERS[:6], *PAIR, *OTHERS[6:])})

    def csv_text(self):
        """The table as text for a spreadsheet, in SI; remarks stand in one cell."""
        out = io.StringIO()
        names = (*OTHERS[:6], *PAIR, *OTHERS[6:])
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(names)
        for row in self.rows:
            writer.writerow(["; ".join(row[name]) if name == "remarks" else row[name] for name in names])
        return out.getvalue()
