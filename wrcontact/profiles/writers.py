"""Profiles as files of points for other programs, in the formats that have a writer.

Points lie at every joint of zones and at most SPACING apart along the curve, with nine digits behind the point of a
millimetre. Directions: y to the field side, z down, but where a format has others.
"""

import math
import os

import numpy as np

from ..conventions import MILLIMETRE as MM
from .files import prepared_text
from .formats import FORMATS

SPACING = 0.1  # [mm]
#: Points beside a joint where the curvature jumps, so that a spline does not swing there [mm], but none beside a corner, a
#: larger step of the slope: a spline would only be sharper.
NEAR_JOINT, CORNER = np.array([0.01, 0.03]), 1e-6
#: Kind, "" for both, of the profiles that are written, by ending.
WRITTEN = {ending: kind for one in FORMATS[::-1] if one.write for ending, kind in one.endings.items()}
SEEN = 401  # places of a zone between which its length is straight


def saved_text(profile, path):
    """The text of ``profile`` for a file at ``path``, by its ending; ValueError, in a sentence, if there is no
    format for it, or none for this profile."""
    ending = os.path.splitext(os.fspath(path))[1].lower()
    if ending == ".json":
        return prepared_text(profile)
    made = next((one for one in FORMATS if ending in one.endings), None)
    if made is None or not made.write:
        why = f", a file of {made.name}, {made.unwritten};" if made and made.unwritten else ";"
        raise ValueError(
            f"path is {os.fspath(path)!r}{why} permitted is a file that ends in .json, {', '.join(WRITTEN)}"
        )
    kind = WRITTEN[ending]
    if kind not in ("", profile.kind):
        raise ValueError(
            f"path is {os.fspath(path)!r}, a file of a {kind}, and the profile is a {profile.kind}; permitted for "
            f"it are {', '.join(known for known, of in WRITTEN.items() if of in ('', profile.kind))} and .json"
        )
    return made.write(profile, *points(profile))


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
