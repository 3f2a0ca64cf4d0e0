"""Profiles from files; the only module that opens a profile file.

A file of points is text in one of the formats in formats/. The points are repaired where the repair is
certain enough (repair.py), smoothed if they are noisy (smoothing.py), and turned into a smooth curve. A
:class:`ProfileWarning` reports what was done. A prepared file (.json) contains the pieces themselves and
needs only numpy; an FMU contains its profiles in this form.

The functions get the class that they make, :class:`~wrcontact.Profile`, as ``make``.
"""

import json
import math
import os
from dataclasses import replace

import numpy as np

from ..conventions import MILLIMETRE as MM
from ..interface.parameters import PARAMETERS
from .formats import read_points
from .remarks import Reading, Refusal, by_weight, remark, stretch
from .repair import LEAST_POINTS, WIDTHS, mend, words_on_cuts
from .smoothing import LEAST_NOISE, Curve, pieces_of
from .zones import Arc, Polynomial

SMOOTHING = PARAMETERS["smoothing"].number
#: Largest permitted file [bytes].
LARGEST_FILE = 4_000_000
#: [1/m] No wheel or rail is sharper, a radius of 0.5 mm, between points this close [mm].  What is steeper than
#: STEEPEST [-], 80 degrees, is not read.
SHARPEST, CLOSE, STEEPEST = 2e3, 0.02, math.tan(math.radians(80.0))
#: A curve may reach so far beyond its points [mm]: a wall that is drawn less steep does, by a thousandth of
#: its height and by the noise.
OUTSIDE = 1.0
#: Largest ratio of weights in an even file: those of flat and of steep places.
EVEN = 25.0
#: Largest wear of a rail's inner face [m].
MOST_WORN = 0.05
#: Points of a rail within this height of its highest point count as equally high [mm].
LEVEL = 1e-9


def read_profile(file, kind, smoothing, make, track=None):
    """The profile in a ``file``; ValueError, in one sentence, if the file cannot be used.

    Parameters
    ----------
    file : :class:`~wrcontact.profiles.options.ProfileFile` of points in a format of formats/, or of a
        prepared file.
    kind : "wheel" or "rail".
    smoothing : root mean square distance [m] between the smoothing spline and the points; 0 goes through
        every point; None is the estimated noise of the points, and no smoothing if that is below 0.01 um.
    make : the class of the profile.
    track : inclination of the rails on the track [1]: a symmetric head that leans as much is turned upright;
        None where it is not known.
    """
    tolerance, path = smoothing_in_mm(smoothing), os.fspath(file.path)
    try:
        text = _text(path)
        _check_options(file, kind, prepared=text.lstrip().startswith("{"))
        if text.lstrip().startswith("{"):
            return _with_corners(prepared_profile(text, kind, make), file)
        name, extension = os.path.splitext(os.path.basename(path))
        points = read_points(text, extension.lower(), kind, file.select)
        remarks = [*points.remarks]
        found, turned = mend(points, kind, file, track, remarks, keep_all=tolerance == 0.0)
        profile = _smooth_profile(found, name, kind, tolerance, remarks, make)
        profile = replace(profile, reading=replace(profile.reading, inclination=turned))
    except Refusal as problem:
        raise ValueError(f"{kind} profile {path} {problem}") from None
    remark(kind, os.path.basename(path), remarks)
    return _with_corners(profile, file)


def _with_corners(profile, file):
    """The ``profile`` with its corners as the options of the ``file`` ask for."""
    return profile if file.corner_radius is None else profile.rounded(file.corner_radius)


def smoothing_in_mm(smoothing):
    """``smoothing`` [m] as a tolerance [mm]; None, which means the noise, stays None;
    ValueError outside SMOOTHING."""
    value = SMOOTHING.checked("smoothing", smoothing)
    return None if value is None else value / MM


def _check_options(file, kind, *, prepared):
    """Refuse options that this file does not use."""
    others = [name for name in file.given if name != "corner_radius"]
    if prepared and others:
        name = others[0]
        raise Refusal(
            f"is a prepared profile, which is not changed; {name} is {getattr(file, name)!r}; "
            "permitted is that for files of points"
        )
    if kind == "wheel" and file.file_inclination is not None:
        raise Refusal(
            f"is that of a wheel; file_inclination is {file.file_inclination:g}; permitted is that for rails"
        )


def _text(path):
    """The text of a file in UTF-8, UTF-16 or Latin-1; a Refusal if it is too large or
    changes while it is read."""
    with open(path, "rb") as file:
        before = os.fstat(file.fileno())
        content = file.read(LARGEST_FILE + 1)
        after = os.fstat(file.fileno())
    if len(content) > LARGEST_FILE:
        raise Refusal(f"has more than {LARGEST_FILE / 1e6:g} MB; permitted are files of at most that")
    if len(content) != after.st_size or (before.st_size, before.st_mtime_ns) != (
        after.st_size,
        after.st_mtime_ns,
    ):
        raise Refusal("changed while it was read; permitted are files that are not being written")
    if content[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return content.decode("utf-16", errors="replace")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("latin-1")


def _smooth_profile(found, name, kind, tolerance, remarks, make):
    """The profile for the ``found`` points, smoothed to ``tolerance`` [mm], or to
    their noise if that is None."""
    if found.noise > SMOOTHING.high / MM:
        raise Refusal(
            f"has noise of {1e3 * found.noise:.3g} um; permitted is at most {1e6 * SMOOTHING.high:g} um"
        )
    asked = tolerance is not None
    tolerance = tolerance if asked else found.noise if found.noise > LEAST_NOISE else 0.0
    try:
        profile = make(name, kind, *_zones_along(found, name, kind, tolerance, asked, remarks))
    except Refusal:
        raise
    except ValueError as problem:
        raise Refusal(f"has points through which no smooth curve can be drawn ({problem})") from None
    remark_sharpest(profile, remarks)
    return replace(profile, reading=_reading(found, tolerance, remarks))


def remark_sharpest(profile, remarks):
    """Say where points no farther than CLOSE apart make the curve sharper than SHARPEST: rounded coordinates
    do."""
    width = np.diff([*(zone.start for zone in profile.zones), profile.zones[-1].stop])
    ends = np.array([(zone.start, 0.5 * (zone.start + zone.stop), zone.stop) for zone in profile.zones]) * MM
    _, slope, bend = profile.evaluate(np.clip(ends, profile.start, profile.stop))
    curvature = np.where(np.abs(slope) < STEEPEST, np.abs(bend) / (1.0 + slope**2) ** 1.5, 0.0).max(axis=1)
    sharp = np.flatnonzero((curvature > SHARPEST) & (width < CLOSE))
    if len(sharp):
        worst = sharp[np.argmax(curvature[sharp])]
        remarks.append(
            f"points {1e3 * width[worst]:.3g} um apart make a radius of {1e6 / curvature[worst]:.2g} um "
            f"({stretch([profile.zones[k].start for k in sharp])}), as rounded coordinates do: contacts follow "
            "it, and the search takes longer; more smoothing removes it"
        )


def _reading(found, tolerance, remarks):
    """The :class:`Reading` of ``found`` points that were smoothed to ``tolerance`` [mm]."""
    chords = np.hypot(np.diff(found.y), np.diff(found.z)) * MM
    return Reading(
        len(found.y),
        float(np.median(chords)),
        float(np.max(chords)),
        found.noise * MM,
        tolerance * MM,
        tuple(by_weight(remarks)),
    )


def _zones_along(found, name, kind, tolerance, asked, remarks):
    """Zones through or, to ``tolerance`` [mm], along ``found`` points, and whether they meet smoothly."""
    if tolerance == 0.0 and np.all(np.diff(found.y) > 0.0):
        return zones_through(found.y, found.z, name, kind), True
    # an asked smoothing is that of all places
    weight = np.minimum(found.weight, EVEN * found.weight.min()) if asked else found.weight
    curve = Curve(found.y, found.z, weight, tolerance)
    if tolerance > 0.0:
        done = (
            f"smoothed to {1e3 * tolerance:.3g} um"
            if asked
            else f"noise of {1e3 * tolerance:.3g} um smoothed"
        )
        remarks.append(f"{done}, points moved by up to {1e3 * curve.moved:.3g} um")
    top = curve.highest() if kind == "rail" else curve.nearest(0.0)
    zones, smooth = pieces_of(curve, top, walls=kind == "rail")
    if zones[-1].stop - zones[0].start < WIDTHS[0]:
        raise Refusal(
            f"folds back or is vertical at y = {zones[0].start:.4g} and {zones[-1].stop:.4g} mm; "
            f"permitted is a distance of {WIDTHS[0]:g} mm or more between"
        )
    ends = np.array([zones[0].start, zones[-1].stop])
    across = found.y - curve.origin[0]
    if ends[0] < across.min() - OUTSIDE or ends[1] > across.max() + OUTSIDE:
        raise Refusal(f"has points that no smooth curve follows: {_sharpest(found)}")
    remarks.extend(words_on_cuts(ends, across))
    return zones, smooth


def _sharpest(found):
    """Where ``found`` points turn most, in words."""
    heading = np.diff(np.arctan2(np.diff(found.z), np.diff(found.y)))
    turn = np.abs((heading + np.pi) % (2.0 * np.pi) - np.pi)
    worst = int(np.argmax(turn))
    return f"they turn by {math.degrees(turn[worst]):.3g} deg at y = {found.y[worst + 1]:.4g} mm"


def zones_through(y, z, name, kind):
    """Zones through points ``y`` (n,), ``z`` (n,) in millimetres by a cubic spline, as
    :meth:`wrcontact.Profile.from_points`."""
    from scipy.interpolate import CubicSpline  # not needed for prepared profiles

    y, z = np.asarray(y, dtype=float), np.asarray(z, dtype=float)
    if len(y) < LEAST_POINTS or len(y) != len(z):
        raise ValueError(f"{kind} profile {name} has {len(y)} points; permitted are {LEAST_POINTS} or more")
    if not (np.all(np.isfinite(y)) and np.all(np.isfinite(z))):
        raise ValueError(f"{kind} profile {name} has points that are not finite numbers")
    if y[0] > y[-1]:
        y, z = y[::-1], z[::-1]
    if not np.all(np.diff(y) > 0):
        where = int(np.argmax(np.diff(y) <= 0)) + 1
        raise ValueError(
            f"{kind} profile {name}: y does not rise from point {where} to {where + 1}; "
            "permitted are points in the order of y"
        )
    if not WIDTHS[0] <= y[-1] - y[0] <= WIDTHS[1]:
        raise ValueError(
            f"{kind} profile {name} is {y[-1] - y[0]:g} mm wide; permitted are {WIDTHS[0]:g} "
            f"... {WIDTHS[1]:g} mm"
        )
    spline = CubicSpline(y, z)
    if kind == "rail":
        top = _top(spline)
        y, z = y - top, z - spline(top)
        spline = CubicSpline(y, z)
    return tuple(
        Polynomial(float(low), float(high), tuple(map(float, piece[::-1])), float(low))
        for low, high, piece in zip(y[:-1], y[1:], spline.c.T)
    )


def _top(spline):
    """Abscissa [mm] of the highest point of ``spline`` (smallest z); the middle of a flat top."""
    extrema = spline.derivative().roots(extrapolate=False)
    tops = np.concatenate([extrema[np.isfinite(extrema)], spline.x[[0, -1]]])
    heights = spline(tops)
    level = tops[heights <= heights.min() + LEVEL]
    middle = 0.5 * (level.min() + level.max())
    return middle if spline(middle) <= heights.min() + LEVEL else tops[np.argmin(heights)]


def prepared_text(profile):
    """The text of a prepared file, from which :func:`read_profile` restores ``profile`` bit by bit."""
    zones = [{"family": type(zone).__name__.lower(), **vars(zone)} for zone in profile.zones]
    worn = {"worn_face": profile.worn_face} if profile.worn_face else {}
    return json.dumps(
        {"name": profile.name, "kind": profile.kind, "smooth": profile.smooth, **worn, "zones": zones},
        indent=1,
    )


def prepared_profile(text, kind, make):
    """The profile in the text of a prepared file."""
    try:
        content = json.loads(text)
        if not isinstance(content, dict) or not {"name", "kind", "zones", "smooth"} <= content.keys():
            raise Refusal(
                "is JSON, but not a profile of wrcontact; permitted are points y and z as text columns"
            )
        zones = tuple(_zone(dict(entry)) for entry in content["zones"])
        profile = make(str(content["name"]), content["kind"], zones, bool(content["smooth"]))
        worn = float(content.get("worn_face", 0.0))
        if not abs(worn) <= MOST_WORN:
            raise ValueError(f"worn_face is {worn} m")
        profile = replace(profile, worn_face=worn) if worn else profile
    except Refusal:
        raise
    except (ValueError, LookupError, TypeError, AttributeError, RecursionError, OverflowError) as error:
        raise Refusal(f"is not a prepared profile ({type(error).__name__}: {error})") from None
    return of_kind(profile, kind)


def of_kind(profile, kind):
    """``profile``; ValueError where it is not of this ``kind``, "wheel" or "rail"."""
    if profile.kind != kind:
        raise ValueError(
            f"{kind} is a {profile.kind} profile ({profile.name}); permitted are {kind} profiles"
        )
    return profile


def _zone(entry):
    family = {"arc": Arc, "polynomial": Polynomial}[entry.pop("family")]
    numbers = [value for value in entry.values() if not isinstance(value, list)] + entry.get(
        "coefficients", []
    )
    if not all(isinstance(number, (int, float)) and math.isfinite(number) for number in numbers):
        raise ValueError("a zone has values that are not finite numbers")
    if "coefficients" in entry:
        entry["coefficients"] = tuple(entry["coefficients"])
    zone = family(**entry)
    if not zone.start < zone.stop:
        raise ValueError(f"a zone goes from y = {zone.start} to {zone.stop} mm")
    return zone
