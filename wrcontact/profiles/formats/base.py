"""What a format of profile files is, the points that its reader returns, and what readers and writers share."""

import math
import re
from dataclasses import dataclass, field

import numpy as np

from ..remarks import Refusal

#: Largest number of points in a file; a profile measured every 7 um has as many.
MOST_POINTS = 20_000
NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eEdD][+-]?\d{1,3})?")
#: Longest field that is read as a number [characters].
LONGEST_NUMBER = 60
#: What instruments and programs write for a missing value.
ABSENT = frozenset(
    {
        "nan",
        "-nan",
        "+nan",
        "na",
        "n/a",
        "inf",
        "-inf",
        "+inf",
        "infinity",
        "-infinity",
        "null",
        "none",
        "-",
        "--",
        "nan(ind)",
        "-nan(ind)",
        "1.#qnan",
        "-1.#ind",
        "1.#inf",
    }
)
COMMENTS = re.compile(r"[#!%].*|//.*")
UNITS_IN_MM = {
    "m": 1e3,
    "dm": 100.0,
    "cm": 10.0,
    "mm": 1.0,
    "um": 1e-3,
    "in": 25.4,
    "inch": 25.4,
    "ft": 304.8,
}


@dataclass
class Points:
    """Points in the order of the file: ``y``, ``z`` (n,), in mm if the file states its unit, and ``weight``
    (n,).

    ``lines`` (n,) are their line numbers.  ``free`` is True for a format that does not define the position of
    the running circle and the direction of the axes; finding these is then not reported as a repair.  ``defined``
    is True for a format that defines where z points, so that a rail is not turned over by its shape.
    """

    y: np.ndarray
    z: np.ndarray
    weight: np.ndarray
    lines: np.ndarray
    free: bool = False
    defined: bool = False
    remarks: list = field(default_factory=list)


@dataclass(frozen=True)
class Format:
    """One format; each is made, and registered, in a file of its own.

    Attributes
    ----------
    name : of the program or the instrument.
    turn : formats are asked in this order whether a file is theirs.
    endings : kind of the profile, "wheel", "rail" or "" for both, by the ending of a file's name.
    read : function of text, kind and the selected profile (None for a file with one), which returns :class:`Points`
        or raises a Refusal; None for a format that is not read.
    recognised : function of a text that says whether it is of this format, whatever the ending is.
    several : whether a file may have several profiles.
    write : function of a profile and its points y and z (n,) [mm], which returns the text; None for a format that is
        not written.
    unwritten : why it is not written, a clause for the user.
    """

    name: str
    turn: int
    endings: dict
    read: object = None
    recognised: object = None
    several: bool = False
    write: object = None
    unwritten: str = ""

    def takes(self, extension, text):
        """Whether a file with this ending and ``text`` is of this format."""
        return extension in self.endings or bool(self.recognised and self.recognised(text))


#: All formats, in the order of their turns.
FORMATS = []


def register(made):
    """Add a :class:`Format`; ValueError where another one has its turn or one of its endings."""
    for known in FORMATS:
        if known.turn == made.turn or known.endings.keys() & made.endings.keys():
            raise ValueError(f"the formats {known.name} and {made.name} have one turn or one ending")
    FORMATS.append(made)
    FORMATS.sort(key=lambda one: one.turn)


# --- reading ------------------------------------------------------------------------------------------------


def fields_of(text):
    """Line number and fields of every line that is not empty."""
    lines = text.splitlines()
    if len(lines) > 5 * MOST_POINTS:
        raise Refusal(
            f"has {len(lines)} lines; permitted are at most {5 * MOST_POINTS}, and {MOST_POINTS} points"
        )
    for number, line in enumerate(lines, start=1):
        line = COMMENTS.sub("", line).strip()
        if line:
            yield number, _fields(line)


def _fields(line):
    if ";" in line or "\t" in line:
        fields = [part.strip() for part in re.split(r"[;\t]", line)]
        while fields and not fields[-1]:
            fields.pop()
    else:
        fields = re.split(r",\s+|\s+,?", line)
        if len(fields) == 1:
            return [part.strip() for part in line.rstrip(",").split(",")]
        fields = [part.rstrip(",") for part in fields if part.rstrip(",")]
    return [_point_for_comma(part) for part in fields]


def _point_for_comma(part):
    return part.replace(",", ".") if part.count(",") == 1 and "." not in part else part


def number_of(text):
    """``text`` as a number; NaN for a missing value, None for anything else."""
    text = text.strip("\"' ")
    if len(text) <= LONGEST_NUMBER and NUMBER.fullmatch(text):
        return float(text.replace("d", "e").replace("D", "e"))
    return math.nan if text.lower() in ABSENT else None


def points_of(rows, free=False):
    """:class:`Points` from rows (line number, y, z[, weight])."""
    if len(rows) > MOST_POINTS:
        raise Refusal(f"has {len(rows)} points; permitted are at most {MOST_POINTS}")
    table = np.array([(*row, 1.0)[:4] for row in rows], dtype=float)
    return Points(table[:, 1], table[:, 2], table[:, 3], table[:, 0].astype(int), free)


def left_out(word, numbers, why):
    some = ", ".join(map(str, numbers[:3])) + (", ..." if len(numbers) > 3 else "")
    return f"{len(numbers)} {word}{'s' * (len(numbers) > 1)} {why} left out ({word} {some})"


# --- writing ------------------------------------------------------------------------------------------------


def columns(y, z, between=" "):
    """Lines of two numbers."""
    return "\n".join(f"{a:.9f}{between}{b:.9f}" for a, b in zip(y + 0.0, z + 0.0)) + "\n"
