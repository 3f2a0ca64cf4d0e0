"""Quality of a profile where it is in contact: its points and repairs, its joints, and the roughness of its
curvature."""

import math
from dataclasses import dataclass

import numpy as np

from ..kernel.layout import Profile
from ..profiles.compiled import evaluate_table, places
from ..profiles.plausible import SMOOTH, roughness
from ..profiles.remarks import Reading
from ..results.words import ShortText

#: [rad] A joint with a larger change of angle is a kink: at a relative curvature of 5 1/m it moves the
#: contact by 0.2 mm.
KINK = 1e-3
#: [m] Spacing of the curvature's values.
STEP = 0.05e-3


@dataclass(frozen=True, repr=False)
class ProfileQuality(ShortText):
    """One profile, and the part of it that is in contact.

    Attributes
    ----------
    name, kind : of the profile.
    start, stop : ends of the profile [m]; a rail is inclined.
    visited : smallest and largest contact position [m], NaN without contact; the next four are for this part.
    pieces : number of pieces of the whole profile.
    kinks : (y [m], change of angle [rad]) of the joints whose angle changes by more than KINK.
    curvature_step : largest step of the curvature at a joint [1/m].
    roughness : median deviation of the curvature from its mean over SMOOTH [1/m].
    reading : :class:`~wrcontact.profiles.remarks.Reading` of a file of points; None for other profiles.
    """

    name: str
    kind: str
    start: float
    stop: float
    visited: tuple
    pieces: int
    kinks: tuple
    curvature_step: float
    roughness: float
    reading: Reading | None


def profile_quality(profile, table, visited, inclination=0.0):
    """The :class:`ProfileQuality` of ``profile``, with the kernel's ``table`` of it and contacts between
    ``visited`` = (low, high) [m]; ``inclination`` is that of a rail, as a slope."""
    y = _on_track(profile, math.atan(inclination))
    joints = [joint for joint, at in zip(profile.joints, y) if visited[0] <= at <= visited[1]]
    y = y[(y >= visited[0]) & (y <= visited[1])]
    square = 1.0 + profile.slope(np.array([joint.y for joint in joints])) ** 2
    turns = np.array([joint.slope_step for joint in joints]) / square  # to first order in the step
    steps = np.abs([joint.bend_step for joint in joints]) / square**1.5
    kinks = tuple((float(at), float(turn)) for at, turn in zip(y, turns) if abs(turn) > KINK)
    return ProfileQuality(
        profile.name,
        profile.kind,
        Profile.at(table).start,
        Profile.at(table).stop,
        visited,
        len(profile.zones),
        kinks,
        float(np.max(steps, initial=0.0)),
        _roughness(table, *visited),
        profile.reading,
    )


def _on_track(profile, angle):
    """Abscissae (n,) [m] of a profile's joints; those of a rail after it is inclined by ``angle`` [rad]."""
    y = np.array([joint.y for joint in profile.joints])
    if profile.kind == "wheel":
        return y
    raster = np.linspace(profile.start, profile.stop, 2001)[1:-1]
    highest = raster[np.argmin(math.cos(angle) * profile.height(raster) - math.sin(angle) * raster)]
    y, z = np.append(y, highest), profile.height(np.append(y, highest))
    turned = math.cos(angle) * y + math.sin(angle) * z
    return turned[:-1] - turned[-1]


def _roughness(table, low, high):
    """The :func:`~wrcontact.profiles.plausible.roughness` [1/m] between ``low`` and ``high`` [m]."""
    y = places(table, STEP)
    y = y[(y >= low) & (y <= high)]
    if not len(y):
        return math.nan
    _, slope, bend = evaluate_table(table, y)
    return roughness(bend / (1.0 + slope**2) ** 1.5, SMOOTH * 1e-3 / STEP)
