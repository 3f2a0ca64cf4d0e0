"""MiniProf's files: .whl and .ban with one profile, .mpt with several."""

import re

from .formats import fields_of, left_out, number_of, points_of
from .options import choose
from .remarks import Refusal

#: Heads of the sections of one profile in a .mpt file, such as [Profile2Info] and [Profile2Points].
SECTION = re.compile(r"^[ \t]*\[[ \t]*profile[ \t]*(\d+)[ \t]*(info|points)[ \t]*\]", re.IGNORECASE)
#: Header lines that name a profile, the first that is there.
NAMES = ("name", "profilename", "filename", "mpdn")


def miniprof_points(text):
    """Points from MiniProf's .whl and .ban.

    Header lines are ``Keyword=value``.  ``ColumnDef`` (such as X,Y,A,C,N) names the columns: X is lateral and
    Y vertical, both in mm; without it they are the first two columns.  "#" starts a comment.  A wheel may be
    measured from the back of its flange, upwards or downwards, and from either side, a rail from either side;
    position and directions are found from the shape.
    """
    columns, data = (0, 1), []
    for line in text.splitlines():
        key, equals, value = line.partition("=")
        names = [name.strip().upper() for name in value.strip().split(",")]
        if key.strip().lower() == "columndef" and names.count("X") == names.count("Y") == 1:
            columns = names.index("X"), names.index("Y")
        data.append("" if equals else line)
    rows, bad = [], []
    for number, fields in fields_of("\n".join(data)):
        values = [number_of(fields[k]) if k < len(fields) else None for k in columns]
        if None not in values:
            rows.append((number, *values))
        elif rows:
            bad.append(number)
    if not rows:
        raise Refusal("contains no lines of numbers after its header; permitted are MiniProf profiles with X "
                      "and Y in mm")
    points = points_of(rows, free=True)
    if bad:
        points.remarks.append(left_out("line", bad, "without two numbers"))
    return points


def several_points(text, select):
    """Points of the selected profile in MiniProf's .mpt.

    Each profile has two sections: [Profile1Info] with the header lines and [Profile1Points] with the points,
    both as in a .ban file.  Lines of other sections are left out.
    """
    parts, line_ends, own = {}, len(text.splitlines()), None
    for line_number, line in enumerate(text.splitlines()):
        head = SECTION.match(line)
        if head or line.lstrip().startswith("["):
            own = parts.setdefault(int(head[1]), [""] * line_ends) if head else None
        elif own is not None:
            own[line_number] = line         # lines keep their numbers
    if not parts:
        raise Refusal("contains no section [Profile1Points]; permitted are MiniProf files with such sections")
    chosen = list(parts)[choose([_name(lines) for lines in parts.values()], select)]
    return miniprof_points("\n".join(parts[chosen]))


def _name(lines):
    """The name in the header lines of one profile; "" without one."""
    values = {key.strip().lower(): value.strip() for key, equals, value in
              (line.partition("=") for line in lines) if equals}
    return next((values[key] for key in NAMES if values.get(key)), "")
