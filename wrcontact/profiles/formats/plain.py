"""Columns of numbers, as spreadsheets and programs write them."""

import re

from ..remarks import Refusal
from .base import Format, columns, fields_of, left_out, number_of, points_of, register

#: A line that is either two numbers with decimal commas or four whole numbers.
AMBIGUOUS = re.compile(r"^[ \t]*[+-]?\d+,\d+,[+-]?\d+,\d+[ \t]*\r?$", re.MULTILINE)


def read(text, kind=None, select=None):
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


def _named_columns(rows, usual):
    """Indices of the columns named y and z in a header; 0 and 1 if there is no such header."""
    for fields in rows:
        names = [re.sub(r"[\s_\[(].*", "", part.strip("\"' ").lower()) for part in fields]
        if len(names) == usual and names.count("y") == 1 and names.count("z") == 1:
            return names.index("y"), names.index("z")
    return 0, 1


def write(profile, y, z):
    """The profile's text."""
    return f"# {profile.name}, {profile.kind}: y to the field side, z down [mm]\ny,z\n{columns(y, z, ',')}"


register(
    Format(
        "text",
        90,
        {".csv": "", ".txt": ""},
        read,
        recognised=lambda text: True,
        write=write,
    )
)
