"""What wrcontact is measured against: stored poses, trajectories and answers of other programs, and the
programs that made them (README.md).  Tests and benchmarks read it; nothing of theirs is imported here."""

import csv
from functools import cache
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).parent
POSITIONS = FOLDER / "positions.csv"
CONFORMAL = FOLDER / "conformal.csv"
MANCHESTER = FOLDER / "manchester_a22_rolls.csv"
#: Runs of many poses, with their expected outputs; the first is the one of the demo, which is in the package.
HUNTING = FOLDER.parent / "wrcontact" / "cli" / "data" / "hunting.csv"
TRAJECTORIES = {
    "hunting": HUNTING,
    "jumps": FOLDER / "trajectories" / "jumps.csv",
    "load": FOLDER / "trajectories" / "load.csv",
}


@cache
def columns(path):
    """Columns of a table of numbers by name, arrays (n,)."""
    with open(path, newline="", encoding="utf-8") as file:
        names, *rows = csv.reader(file)
    return dict(zip(names, np.array(rows, dtype=float).T))


def rows_of(path):
    """The rows of such a table, numbers by name."""
    return [dict(zip(columns(path), row)) for row in np.transpose([*columns(path).values()]).tolist()]
