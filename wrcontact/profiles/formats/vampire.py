"""Vampire's .whe and .rai: both sides of a wheelset or track in one file."""

import re

import numpy as np

from ...conventions import SIDES
from ..remarks import Refusal
from .base import Format, left_out, number_of, points_of, register

INCH = 25.4  # [mm]
#: Distance [mm] of the tread datum, the running circle, from the back of the flange, by its name.
TREAD_DATUM = {"european": 70.0, "us1": (2 + 27 / 32) * INCH, "us2": (3 + 1 / 16) * INCH}
COMMENT = re.compile(r"[\"!%].*")
FIRST = {"wheel": "wheelprofile", "rail": "railprofile"}


def read(text, kind, select):
    """Points from the text, as the public reader of CONTACT describes the format.

    Lines 1 to 4 are WHEELPROFILE or RAILPROFILE, a title, the datum (TREADDATUM or GAUGEPOINT, followed by
    EUROPEAN, US1, US2, US, or CUSTOM with a length in mm), and the width (FLANGEBACK, the distance between
    the backs of the flanges, or GAUGE).  The other lines have four columns in mm, y and z of the left and of
    the right profile, y from the middle of the wheelset or track to the right.  A quotation mark, "!" and "%"
    start comments.  ``select`` is "left" or "right", the default.  A wheel's y is shifted to the tread datum;
    a rail's z is positive upwards.
    """
    lines = text.lstrip().splitlines()
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


def _begins_so(text):
    return text.lstrip()[:12].strip().lower() in FIRST.values()


register(Format("Vampire", 20, {".whe": "wheel", ".rai": "rail"}, read, _begins_so, several=True))
