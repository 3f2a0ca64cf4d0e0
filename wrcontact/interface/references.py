"""Value references: the numbers by which an FMU's variables are addressed, one list for each version of FMI.

``value_references.csv`` holds the number of every variable that there ever was.  It is only appended to: a
new variable gets the next number, wherever its row stands, and the number of a variable that is gone is never
used again.  So nobody's connections move.  ``make pages`` appends the lines that are missing.
"""

import csv
from itertools import count
from pathlib import Path

LIST = Path(__file__).with_name("value_references.csv")
#: The first number in each version of FMI.
FIRST = {2: 0, 3: 1}


def _stored():
    """The number of every name of the list, by version."""
    with LIST.open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {
        version: {row["name"]: int(row[f"fmi{version}"]) for row in rows if row[f"fmi{version}"]}
        for version in FIRST
    }


STORED = _stored()


def numbered(names, version):
    """Value references by name: those of the list, and the next free ones for names that are not in it."""
    stored = STORED[version]
    free = count(max(stored.values(), default=FIRST[version] - 1) + 1)
    return {name: stored[name] if name in stored else next(free) for name in names}
