"""Profiles from files and by name; the only place that opens a profile file.

A points file is text with two columns, y and z in millimetres (comma, semicolon or white space between them; lines that
are not numbers are skipped), in the project's frames.  It is read as a cubic spline through its points, so it must be
smooth: noise becomes curvature.  A prepared file (.json) holds the pieces themselves and needs nothing but numpy; an
FMU carries its profiles that way.
"""

import json
import os
import re

import numpy as np

from .catalogue import BUILDERS, RAILS, WHEELS, standard_profile
from .profile import Profile
from .zones import Arc, Polynomial

LEAST_POINTS = 10
#: A profile's width in millimetres; a file in metres or inches falls outside.
WIDTHS = (20.0, 200.0)


def find_profile(source, kind):
    """The profile meant by ``source``: a :class:`Profile`, a standard name, or the path of a file.

    ``kind`` is "wheel" or "rail".  ValueError in one sentence where it is none of these.
    """
    if isinstance(source, Profile):
        if source.kind != kind:
            raise ValueError(f"{kind} is a {source.kind} profile ({source.name}); permitted are {kind} profiles")
        return source
    names = WHEELS if kind == "wheel" else RAILS
    if isinstance(source, str) and source in names:
        return standard_profile(source)
    if isinstance(source, (str, os.PathLike)) and os.path.isfile(source):
        return read_profile(source, kind)
    other = " (that is the name of the other kind)" if source in BUILDERS else ""
    raise ValueError(f"{kind} is {str(source)!r}{other}; permitted are {', '.join(names)}, the path of a profile file, "
                     f"or a Profile")


def read_profile(path, kind):
    """The profile in the file at ``path``; ValueError in one sentence where it cannot be one."""
    name = os.path.splitext(os.path.basename(path))[0]
    with open(path, encoding="utf-8", errors="replace") as file:
        text = file.read()
    if text.lstrip().startswith("{"):
        return _prepared(json.loads(text), path, kind)
    return profile_from_points(*_columns(text, path), name=name, kind=kind)


def profile_from_points(y, z, *, name, kind):
    """A profile through points ``y`` (n,), ``z`` (n,) in millimetres by a cubic spline.

    A rail is shifted so that its highest point is the origin.

    Raises
    ------
    ValueError
        when the points are too few, not finite, not rising in y, or not of a profile's size.
    """
    from scipy.interpolate import CubicSpline  # not needed where profiles come prepared

    y, z = np.asarray(y, dtype=float), np.asarray(z, dtype=float)
    if len(y) < LEAST_POINTS or len(y) != len(z):
        raise ValueError(f"{kind} profile {name} has {len(y)} points; permitted are {LEAST_POINTS} or more")
    if not (np.all(np.isfinite(y)) and np.all(np.isfinite(z))):
        raise ValueError(f"{kind} profile {name} has points that are not finite numbers")
    if y[0] > y[-1]:
        y, z = y[::-1], z[::-1]
    if not np.all(np.diff(y) > 0):
        where = int(np.argmax(np.diff(y) <= 0)) + 1
        raise ValueError(f"{kind} profile {name}: y does not rise from point {where} to {where + 1}; permitted are "
                         f"points in the order of y")
    if not WIDTHS[0] <= y[-1] - y[0] <= WIDTHS[1]:
        raise ValueError(f"{kind} profile {name} is {y[-1] - y[0]:g} mm wide; permitted are {WIDTHS[0]:g} ... "
                         f"{WIDTHS[1]:g} mm")
    spline = CubicSpline(y, z)
    if kind == "rail":
        extrema = spline.derivative().roots(extrapolate=False)
        tops = np.concatenate([extrema, y[[0, -1]]])
        top = tops[np.argmin(spline(tops))]
        y, z = y - top, z - spline(top)
        spline = CubicSpline(y, z)
    zones = tuple(Polynomial(float(low), float(high), tuple(map(float, piece[::-1])), float(low))
                  for low, high, piece in zip(y[:-1], y[1:], spline.c.T))
    return Profile(name, kind, zones)


def prepared_text(profile):
    """The text of a prepared file that :func:`read_profile` gives ``profile`` back from, bit for bit."""
    zones = [{"family": type(zone).__name__.lower(), **vars(zone)} for zone in profile.zones]
    return json.dumps({"name": profile.name, "kind": profile.kind, "smooth": profile.smooth, "zones": zones}, indent=1)


def _prepared(content, path, kind):
    try:
        families = {"arc": Arc, "polynomial": Polynomial}
        zones = tuple(_zone(families, dict(entry)) for entry in content["zones"])
        profile = Profile(content["name"], content["kind"], zones, content["smooth"])
    except (KeyError, TypeError) as error:
        raise ValueError(f"{path} is not a prepared profile ({error!r})") from error
    return find_profile(profile, kind)


def _zone(families, entry):
    family = families[entry.pop("family")]
    if "coefficients" in entry:
        entry["coefficients"] = tuple(entry["coefficients"])
    return family(**entry)


def _columns(text, path):
    """The two columns of numbers in ``text``."""
    rows = []
    for line in text.splitlines():
        parts = [part for part in re.split(r"[\s,;]+", line.strip()) if part]
        try:
            rows.append((float(parts[0]), float(parts[1])))
        except (ValueError, IndexError):
            continue
    if not rows:
        raise ValueError(f"{path} holds no lines of two numbers; permitted are text files with y and z in mm")
    return np.array(rows).T
