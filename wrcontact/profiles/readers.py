"""Which reader reads a file: by its ending, or by what is in it; and the readers of MiniProf's and Vampire's
files, of which some have several profiles."""

import re

import numpy as np

from .formats import (
    GAUGE_AT_LARGER_Y,
    fields_of,
    left_out,
    number_of,
    plain_points,
    points_of,
    simpack_points,
)
from .options import choose
from .remarks import Refusal

#: Endings that say whether a file contains a wheel or a rail.
KINDS = {
    ".prw": "wheel",
    ".prr": "rail",
    ".whl": "wheel",
    ".ban": "rail",
    ".whe": "wheel",
    ".rai": "rail",
    ".wheel": "wheel",
    ".rail": "rail",
    ".slcs": "rail",
    ".slcw": "wheel",
}
#: Profiles that vary along the rail or around the wheel, as lists of files.
SLICES = {".slcs": "along the rail", ".slcw": "around the wheel"}
#: Heads of the sections of one profile in a .mpt file, such as [Profile2Info] and [Profile2Points].
SECTION = re.compile(r"^[ \t]*\[[ \t]*profile[ \t]*(\d+)[ \t]*(info|points)[ \t]*\]", re.IGNORECASE)
#: Header lines that name a profile, the first that is there.
NAMES = ("name", "profilename", "filename", "mpdn")
#: A header of MiniProf has fewer lines of numbers.
MANY = 5
INCH = 25.4  # [mm]
#: Distance [mm] of the tread datum, the running circle, from the back of the flange, by its name.
TREAD_DATUM = {"european": 70.0, "us1": (2 + 27 / 32) * INCH, "us2": (3 + 1 / 16) * INCH}
COMMENT = re.compile(r"[\"!%].*")
FIRST = {"wheel": "wheelprofile", "rail": "railprofile"}
SIDES = ("left", "right")


def read_points(text, extension, kind, select=None):
    """The :class:`~wrcontact.profiles.formats.Points` in ``text``; a Refusal if there are none.

    Parameters
    ----------
    text : the text of the file.
    extension : ending of its name in small letters, such as ".prw".
    kind : "wheel" or "rail".
    select : which profile of a file with several, or None.
    """
    named = KINDS.get(extension)
    if extension in SLICES:
        raise Refusal(
            f"ends in {extension}, a list of slices of a profile that varies {SLICES[extension]}; "
            f"permitted are files with one cross-section, such as those that it lists"
        )
    if named and named != kind:
        raise Refusal(
            f"ends in {extension}, which is a {named} profile; permitted are {kind} profiles (did you swap wheel and rail?)"
        )
    if extension == ".mpt" or any(map(SECTION.match, text.splitlines()[:100])):
        return several_points(text, select)
    if extension in (".whe", ".rai") or text.lstrip()[:12].strip().lower() in FIRST.values():
        return vampire_points(text.lstrip(), kind, select)
    if select is not None:
        raise Refusal(f"contains one profile; select is {select!r} and cannot be given")
    if extension in (".prw", ".prr") or re.search(r"^[ \t]*point\.begin", text, re.MULTILINE | re.IGNORECASE):
        return simpack_points(text, kind)
    if extension in (".whl", ".ban"):
        return miniprof_points(text)
    points = plain_points(text)
    if extension in GAUGE_AT_LARGER_Y:
        points.y, points.defined = -points.y, True
    return points


# --- MiniProf: .whl and .ban with one profile, .mpt with several --------------------------------------------


def miniprof_points(text):
    """Points from MiniProf's .whl and .ban.

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
            own[line_number] = line  # lines keep their numbers
    if not parts:
        raise Refusal("contains no section [Profile1Points]; permitted are MiniProf files with such sections")
    chosen = list(parts)[choose([_name(lines) for lines in parts.values()], select)]
    return miniprof_points("\n".join(parts[chosen]))


def _name(lines):
    """The name in the header lines of one profile; "" without one."""
    values = {
        key.strip().lower(): value.strip()
        for key, equals, value in (line.partition("=") for line in lines)
        if equals
    }
    return next((values[key] for key in NAMES if values.get(key)), "")


# --- Vampire: both sides of a wheelset or track in one file -------------------------------------------------


def vampire_points(text, kind, select):
    """Points from Vampire's .whe and .rai, as the public reader of CONTACT describes the format.

    Lines 1 to 4 are WHEELPROFILE or RAILPROFILE, a title, the datum (TREADDATUM or GAUGEPOINT, followed by
    EUROPEAN, US1, US2, US, or CUSTOM with a length in mm), and the width (FLANGEBACK, the distance between
    the backs of the flanges, or GAUGE).  The other lines have four columns in mm, y and z of the left and of
    the right profile, y from the middle of the wheelset or track to the right.  A quotation mark, "!" and "%"
    start comments.  ``select`` is "left" or "right", the default.  A wheel's y is shifted to the tread datum;
    a rail's z is positive upwards.
    """
    lines = text.splitlines()
    first = lines[0].strip().lower() if lines else ""
    if first not in FIRST.values():
        raise Refusal(
            f"starts with {first[:40]!r}; permitted are Vampire profiles, which start with "
            "WHEELPROFILE or RAILPROFILE"
        )
    if first != FIRST[kind]:
        raise Refusal(f"starts with {first.upper()}; permitted are {kind} profiles")
    side = "right" if select is None else str(select).lower()
    if side not in SIDES:
        raise Refusal(
            f"contains a left and a right profile; select is {select!r}; permitted are 'left' and 'right'"
        )
    columns = (2, 3) if side == "right" else (0, 1)
    rows, bad = [], []
    for number, line in enumerate(lines[4:], start=5):
        values = [number_of(part) for part in COMMENT.sub("", line).replace(",", " ").split()]
        if len(values) > columns[1] and None not in values[:4]:
            rows.append((number, values[columns[0]], values[columns[1]]))
        elif values:
            bad.append(number)
    if not rows:
        raise Refusal(
            "contains no lines of four numbers; permitted are Vampire profiles with y and z of the "
            "left and of the right side in mm"
        )
    points = points_of(rows)
    if bad:
        points.remarks.append(left_out("line", bad, "without four numbers"))
    points.y = points.y if side == "right" else -points.y
    if kind == "rail":
        points.z, points.defined = -points.z, True
        return points
    points.y = points.y - 0.5 * _width(lines) - _datum(lines)
    return points


def _words(lines, index):
    """The words of the header line ``index``, without comment and in small letters."""
    return COMMENT.sub("", lines[index]).lower().split() if index < len(lines) else []


def _datum(lines):
    """Distance [mm] of the tread datum from the back of the flange."""
    words = _words(lines, 2)
    if words[:1] == ["treaddatum"] and len(words) > 1:
        if words[1] in TREAD_DATUM:
            return TREAD_DATUM[words[1]]
        value = number_of(words[2]) if words[1] == "custom" and len(words) > 2 else None
        if value is not None and np.isfinite(value):
            return value
    raise Refusal(
        f"has no tread datum in line 3 ({' '.join(words)!r}); permitted are TREADDATUM EUROPEAN, "
        "US1, US2, or CUSTOM with a length in mm"
    )


def _width(lines):
    """Distance [mm] between the backs of the flanges."""
    words = _words(lines, 3)
    value = number_of(words[1]) if words[:1] == ["flangeback"] and len(words) > 1 else None
    if value is None or not value > 0.0:
        raise Refusal(
            f"has no distance of the flange backs in line 4 ({' '.join(words)!r}); permitted is "
            "FLANGEBACK with a length in mm"
        )
    return value
