"""Profiles as files of points for other programs, in the formats that readers.py reads.

Points lie at every joint of zones and at most SPACING apart along the curve, with nine digits behind the point of a
millimetre. Directions: y to the field side, z down, but where a format has others.
"""

import math
import os

import numpy as np

from ..conventions import MILLIMETRE as MM
from .files import prepared_text

SPACING = 0.1  # [mm]
#: Points beside a joint where the curvature jumps, so that a spline does not swing there [mm], but none beside a corner, a
#: larger step of the slope: a spline would only be sharper.
NEAR_JOINT, CORNER = np.array([0.01, 0.03]), 1e-6
SEEN = 401  # places of a zone between which its length is straight
#: Distance of the running circle from the back of the flange [mm], from which MiniProf counts.
BACK = 70.0
#: A wheel's running circle is at the height 0 to this [mm], or MiniProf's format, which has no datum, would lose it.
LEVEL = 1e-4


def saved_text(profile, path):
    """The text of ``profile`` for a file at ``path``, by its ending; ValueError, in a sentence, if there is no
    format for it, or none for this profile."""
    ending = os.path.splitext(os.fspath(path))[1].lower()
    if ending == ".json":
        return prepared_text(profile)
    if ending in UNKNOWN:
        raise ValueError(
            f"path is {os.fspath(path)!r}, a file of {UNKNOWN[ending]}, whose form no public text describes; permitted is a "
            f"file that ends in .json, {', '.join(FORMATS)}"
        )
    if ending not in FORMATS:
        raise ValueError(
            f"path is {os.fspath(path)!r}; permitted is a file that ends in .json, {', '.join(FORMATS)}"
        )
    kind, write = FORMATS[ending]
    if kind not in (None, profile.kind):
        raise ValueError(
            f"path is {os.fspath(path)!r}, a file of a {kind}, and the profile is a {profile.kind}; permitted for "
            f"it are {', '.join(known for known, (of, _) in FORMATS.items() if of in (None, profile.kind))} and .json"
        )
    return write(profile, *points(profile))


def points(profile):
    """Points y and z (n,) [mm] on the whole ``profile``."""
    found = []
    corners = [abs(joint.slope_step) > CORNER for joint in profile.joints]
    for zone, first, last in zip(profile.zones, [True, *corners], [*corners, True]):
        # near vertical ends even steps of an angle see the length
        turn = np.linspace(0.0, math.pi, SEEN)
        y = zone.start + 0.5 * (zone.stop - zone.start) * (1.0 - np.cos(turn))
        y = np.clip(y, profile.start / MM, profile.stop / MM)
        z = profile.height(y * MM) / MM
        length = np.append(0.0, np.cumsum(np.hypot(np.diff(y), np.diff(z))))
        along = np.linspace(0.0, length[-1], math.ceil(length[-1] / SPACING) + 1)
        beside = NEAR_JOINT[NEAR_JOINT < 0.5 * length[-1]]
        more = ([] if first else beside, [] if last else length[-1] - beside)
        found.append(np.interp(np.sort(np.concatenate([along, *more])), length, y))
    y = np.unique(np.round(np.concatenate(found), 9))
    y = np.clip(y, profile.start / MM, profile.stop / MM)
    return y, profile.height(y * MM) / MM


def columns(y, z, between=" "):
    """Lines of two numbers."""
    return "\n".join(f"{a:.9f}{between}{b:.9f}" for a, b in zip(y + 0.0, z + 0.0)) + "\n"


def _plain(profile, y, z):
    return f"# {profile.name}, {profile.kind}: y to the field side, z down [mm]\ny,z\n{columns(y, z, ',')}"


def _simpack(profile, y, z):
    kind = int(profile.kind == "wheel")
    return (
        f"header.begin\n  version = 1\n  type = {kind}\nheader.end\nspline.begin\n  comment = '{profile.name}'\n"
        "  approx.smooth = 0.0\n  units.len = 'mm'\n  units.len.f = 1000.0\n  units.ang = 'rad'\n  units.ang.f = 1.0\n"
        f"  point.begin\n{columns(y, z)}  point.end\nspline.end\n"
    )


def _miniprof(profile, y, z):
    """X of a wheel is 0 at the back of its flange, Y is upwards."""
    height = float(profile.height(0.0)) / MM if profile.start < 0.0 < profile.stop else 0.0
    if profile.kind == "wheel" and abs(height) > LEVEL:
        raise ValueError(
            f"the profile {profile.name} is {height:.4g} mm high at its running circle, which MiniProf's format does "
            "not show; permitted are wheels with height 0 there"
        )
    shift = BACK if profile.kind == "wheel" else 0.0
    return f"Name={profile.name}\nColumnDef=X,Y\n\n{columns(y + shift, -z)}"


def _gensys(profile, y, z):
    """Flange and gauge side are at larger y."""
    return f"# {profile.name}\n{columns(-y[::-1], z[::-1])}"


#: Endings of programs whose files are not written, since their form was not found in a public text.
UNKNOWN = {
    ".wpf": "Universal Mechanism",
    ".rpf": "Universal Mechanism",
    ".kpfr": "GENSYS's contact functions",
}
#: Kind, None for both, and writer by ending.
FORMATS = {
    ".csv": (None, _plain),
    ".txt": (None, _plain),
    ".prw": ("wheel", _simpack),
    ".prr": ("rail", _simpack),
    ".whl": ("wheel", _miniprof),
    ".ban": ("rail", _miniprof),
    ".wheel": ("wheel", _gensys),
    ".rail": ("rail", _gensys),
}
