"""Simpack's .prw and .prr."""

import math
import re
from dataclasses import replace

import numpy as np

from ..remarks import Refusal
from .base import UNITS_IN_MM, Format, columns, left_out, number_of, points_of, register

#: What no other format has.
POINTS = re.compile(r"^[ \t]*point\.begin", re.MULTILINE | re.IGNORECASE)


def read(text, kind, select=None):
    """Points from the text.

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


def write(profile, y, z):
    """The profile's text."""
    kind = int(profile.kind == "wheel")
    return (
        f"header.begin\n  version = 1\n  type = {kind}\nheader.end\nspline.begin\n  comment = '{profile.name}'\n"
        "  approx.smooth = 0.0\n  units.len = 'mm'\n  units.len.f = 1000.0\n  units.ang = 'rad'\n  units.ang.f = 1.0\n"
        f"  point.begin\n{columns(y, z)}  point.end\nspline.end\n"
    )


register(
    Format("Simpack", 30, {".prw": "wheel", ".prr": "rail"}, read, recognised=POINTS.search, write=write)
)
