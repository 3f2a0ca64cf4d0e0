"""Points from the text of a profile file: plain columns, and Simpack's .prw and .prr.

MiniProf's and Vampire's files are read in readers.py, which also chooses the reader.  Each
reader's docstring and docs/guides/profiles.md describe what is read.  A reader returns the points of the
file, with
the unit, shift and mirror that the file itself states; everything that must be guessed is left to repair.py.
"""

import math
import re
from dataclasses import dataclass, field, replace

import numpy as np

from .remarks import Refusal

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
#: A line that is either two numbers with decimal commas or four whole numbers.
AMBIGUOUS = re.compile(r"^[ \t]*[+-]?\d+,\d+,[+-]?\d+,\d+[ \t]*\r?$", re.MULTILINE)
#: Endings of GENSYS's files: columns y and z in mm, y positive towards the track centre, z down (manual of
#: its program KPF).
GAUGE_AT_LARGER_Y = (".wheel", ".rail")
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


# --- plain columns ------------------------------------------------------------------------------------------


def plain_points(text):
    """Points from columns of numbers.

    Columns are separated by semicolons, tabs, blanks or commas.  The decimal sign is a point, or a comma if
    it cannot be a separator.  The first two columns are y and z, unless a header line names columns y and z.
    Comments start with #, !, % or //.  Lines with another number of fields than most lines are headers.
    """
    lines = list(fields_of(text))
    rows = [(number, fields) for number, fields in lines if len(fields) >= 2]
    if 2 * len(AMBIGUOUS.findall(text)) > len(rows) > 0:
        raise Refusal(
            "has commas that may be decimal signs or separators; permitted are points as decimal "
            "signs, or semicolons, tabs or blanks between the columns"
        )
    counts = [
        len(fields)
        for _, fields in rows
        if number_of(fields[0]) is not None and number_of(fields[1]) is not None
    ]
    if not counts:
        raise Refusal("contains no lines of two numbers; permitted are text files with y and z in mm")
    usual = max(set(counts), key=counts.count)
    first, second = _named_columns([fields for _, fields in rows], usual)
    values = [
        (number, number_of(fields[first]), number_of(fields[second]))
        for number, fields in rows
        if len(fields) == usual
    ]
    values = [row for row in values if None not in row[1:]]
    if not values:
        raise Refusal("contains no lines of two numbers; permitted are text files with y and z in mm")
    points = points_of(values)
    used = set(points.lines.tolist())
    odd = [
        number for number, _ in lines if points.lines[0] < number < points.lines[-1] and number not in used
    ]
    if odd:
        points.remarks.append(left_out("line", odd, "without two numbers"))
    return points


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


def _named_columns(rows, usual):
    """Indices of the columns named y and z in a header; 0 and 1 if there is no such header."""
    for fields in rows:
        names = [re.sub(r"[\s_\[(].*", "", part.strip("\"' ").lower()) for part in fields]
        if len(names) == usual and names.count("y") == 1 and names.count("z") == 1:
            return names.index("y"), names.index("z")
    return 0, 1


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


# --- Simpack ------------------------------------------------------------------------------------------------


def simpack_points(text, kind):
    """Points from Simpack's .prw and .prr.

    Lines between ``point.begin`` and ``point.end`` contain y, z and optionally a weight for smoothing; a
    point of weight 0 is left out.  These keys are applied, in the order in which such files number them:
    ``point.dist.min``, ``shift.y``, ``shift.z``, ``rotate`` (about x, from y to z), ``bound.y.min`` ...
    ``bound.z.max`` (none where min > max), ``mirror.y``, ``mirror.z``, ``inversion``, ``units.len.f`` (length
    unit per metre; without it ``units.len``) and ``units.ang.f``.  ``type`` in the header (0 rail, 1 wheel)
    must be the requested one.  ``approx.smooth`` is not applied, since its scale is Simpack's own.  "!"
    starts a comment.
    """
    keys, rows, bad, inside, section = {}, [], [], False, ""
    for number, line in enumerate(text.splitlines(), start=1):
        line = line.split("!")[0].strip()
        word = line.lower()
        if word.endswith((".begin", ".end")):
            inside, section = (
                word == "point.begin",
                word.removesuffix(".begin") if word.endswith(".begin") else "",
            )
        elif inside and line:
            values = [number_of(part) for part in line.replace(",", " ").split()[:3]]
            if len(values) < 2 or None in values:
                bad.append(number)
            else:
                rows.append((number, *values))
        elif "=" in line and section:
            key, _, value = line.partition("=")
            keys[f"{section}:{key.strip().lower()}"] = value.strip().strip("'\"")
    if not rows:
        raise Refusal(
            "contains no points between point.begin and point.end; permitted are Simpack profiles "
            "with y and z there"
        )
    points = points_of(rows)
    points.defined = True
    if bad:
        points.remarks.append(left_out("line", bad, "without two numbers"))
    asked = {"0": "rail", "1": "wheel"}.get(keys.get("header:type", "").strip())
    if asked and asked != kind:
        raise Refusal(
            f"says header type {keys['header:type']}, which is a {asked} profile; permitted are "
            f"{kind} profiles"
        )
    with np.errstate(all="ignore"):  # what becomes infinite is left out as such
        return _processed(points, keys)


def _processed(points, keys):
    """``points`` after the operations that the keys of a Simpack file define."""

    def value(key, default):
        given = number_of(keys.get(f"spline:{key}", ""))
        return default if given is None or not math.isfinite(given) else given

    if value("approx.smooth", 0.0) > 0.0:
        points.remarks.append(f"approx.smooth = {value('approx.smooth', 0.0):g} is not applied")
    keep = (points.weight > 0.0) & np.isfinite(points.weight)
    nearest = value("point.dist.min", 0.0)
    if nearest > 0.0:
        keep &= _apart(points.y, points.z, nearest)
    y, z = points.y + value("shift.y", 0.0), points.z + value("shift.z", 0.0)
    angle = value("rotate", 0.0) / (value("units.ang.f", 1.0) or 1.0)
    y, z = math.cos(angle) * y - math.sin(angle) * z, math.sin(angle) * y + math.cos(angle) * z
    for name, part in (("y", y), ("z", z)):
        low, high = value(f"bound.{name}.min", 1.0), value(f"bound.{name}.max", 0.0)
        if low < high:
            keep &= ~((part < low) | (part > high))
    y = -y if value("mirror.y", 0.0) == 1.0 else y
    z = -z if value("mirror.z", 0.0) == 1.0 else z
    order = np.flatnonzero(keep)[:: -1 if value("inversion", 0.0) == 1.0 else 1]
    factor = value("units.len.f", 0.0)
    scale = 1e3 / factor if factor > 0.0 else UNITS_IN_MM.get(keys.get("spline:units.len", "").lower(), 1.0)
    return replace(
        points, y=scale * y[order], z=scale * z[order], weight=points.weight[order], lines=points.lines[order]
    )


def _apart(y, z, nearest):
    """Mask of the points that are at least ``nearest`` from the last point kept."""
    keep, last = np.zeros(len(y), dtype=bool), None
    for i in range(len(y)):
        if last is None or not math.hypot(y[i] - y[last], z[i] - z[last]) < nearest:
            keep[i], last = True, i
    return keep
