"""MiniProf's .whl and .ban, with one profile."""

from ...conventions import MILLIMETRE as MM
from ..remarks import Refusal
from .base import Format, columns, fields_of, left_out, number_of, points_of, register

#: A header of MiniProf has fewer lines of numbers.
MANY = 5
#: Distance of the running circle from the back of the flange [mm], from which MiniProf counts.
BACK = 70.0
#: A wheel's running circle is at the height 0 to this [mm], or MiniProf's format, which has no datum, would lose it.
LEVEL = 1e-4


def read(text, kind=None, select=None):
    """Points from the text.

    Header lines are ``Keyword=value``.  ``ColumnDef`` (such as X,Y,A,C,N) names the columns: X is lateral and
    Y vertical, both in mm; without it they are the first two columns.  "#" starts a comment.  X of a wheel is 0
    at the back of its flange.  Wheels may be measured upwards or downwards, and from either side, a rail from
    either side; the directions are found from the shape.
    """
    columns, rows, ends = (0, 1), [], [0]
    lines = text.splitlines()
    for number, line in enumerate(lines, start=1):
        key, equals, value = line.partition("=")
        names = [name.strip().upper() for name in value.strip().split(",")]
        if key.strip().lower() == "columndef" and names.count("X") == names.count("Y") == 1:
            columns = names.index("X"), names.index("Y")
        if equals or not line.strip():
            ends.append(number)
            lines[number - 1] = ""
    for number, fields in fields_of("\n".join(lines)):
        values = [number_of(fields[k]) if k < len(fields) else None for k in columns]
        rows.append((number, len(fields), None if None in values else values))
    points, first = below_header(rows, ends)
    if not points:
        raise Refusal(
            "contains no lines of numbers after its header; permitted are MiniProf profiles with X "
            "and Y in mm"
        )
    bad = [number for number, _, values in rows if values is None and number > first]
    points = points_of(points, free=True)
    if bad:
        points.remarks.append(left_out("line", bad, "without two numbers"))
    return points


def below_header(rows, ends):
    """Rows (line, y, z) of a MiniProf file below its header, and the line of the first.

    The header may have lines of numbers: with another number of fields than most lines, or fewer than MANY
    before one of the lines ``ends``, which are blank or ``Keyword=value``.

    Parameters
    ----------
    rows : (line, number of fields, two values or None).
    ends : numbers of the lines that may end the header.
    """
    counts = [count for _, count, values in rows if values]
    usual = max(set(counts), key=counts.count, default=0)
    first = min((number for number, count, values in rows if values and count == usual), default=0)
    for end in ends:
        before = sum(1 for number, _, values in rows if values and first <= number < end)
        if before < MANY:
            first = max(first, end)
    return [(number, *values) for number, _, values in rows if values and number >= first], first


def write(profile, y, z):
    """The profile's text: X of a wheel is 0 at the back of its flange, Y is upwards."""
    height = float(profile.height(0.0)) / MM if profile.start < 0.0 < profile.stop else 0.0
    if profile.kind == "wheel" and abs(height) > LEVEL:
        raise ValueError(
            f"the profile {profile.name} is {height:.4g} mm high at its running circle, which MiniProf's format does "
            "not show; permitted are wheels with height 0 there"
        )
    shift = BACK if profile.kind == "wheel" else 0.0
    return f"Name={profile.name}\nColumnDef=X,Y\n\n{columns(y + shift, -z)}"


register(Format("MiniProf", 40, {".whl": "wheel", ".ban": "rail"}, read, write=write))
