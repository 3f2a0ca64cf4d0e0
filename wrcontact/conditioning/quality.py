"""How good a profile is where contacts are: what was read and put right, its joints, and how rough its curvature is."""

import math
from dataclasses import dataclass

import numpy as np

from ..kernel.layout import Profile
from ..profiles.compiled import evaluate_table, places
from ..profiles.reading import Reading

#: [rad] A joint that turns by more is a kink: where wheel and rail are bent apart by 5 1/m, it moves the contact by 0.2 mm.
KINK = 1e-3
#: [m] Waves of the curvature shorter than this are roughness: patches are longer, and no design has such waves.
SMOOTH = 4e-3
#: [m] From value to value of the curvature.
STEP = 0.05e-3


@dataclass(frozen=True)
class ProfileQuality:
    """One profile, and the part of it that contacts visit.

    ``start``, ``stop`` where it can be read [m], a rail on the track as it leans; ``visited`` first and last place of a
    contact [m], NaN without one; ``pieces`` how many; ``kinks``, (y [m], turn [rad]) of the visited joints that turn by more
    than KINK; ``curvature_step``, the largest step of the curvature at a visited joint [1/m]; ``roughness``, how far the
    visited curvature is off its mean over SMOOTH, in the median [1/m]; ``reading`` of the file, None for a profile that is
    not from points.
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
    """The :class:`ProfileQuality` of ``profile``, which the kernel reads as ``table``, with contacts between ``visited`` =
    (low, high) [m]; a rail leans by ``inclination``."""
    y = _on_track(profile, math.atan(inclination))
    joints = [joint for joint, at in zip(profile.joints, y) if visited[0] <= at <= visited[1]]
    y = y[(y >= visited[0]) & (y <= visited[1])]
    square = 1.0 + profile.slope(np.array([joint.y for joint in joints])) ** 2
    turns = np.array([joint.slope_step for joint in joints]) / square       # to first order in the step
    steps = np.abs([joint.bend_step for joint in joints]) / square**1.5
    kinks = tuple((float(at), float(turn)) for at, turn in zip(y, turns) if abs(turn) > KINK)
    return ProfileQuality(profile.name, profile.kind, Profile.at(table).start, Profile.at(table).stop,
                          visited, len(profile.zones), kinks, float(np.max(steps, initial=0.0)), _roughness(table, *visited),
                          profile.reading)


def _on_track(profile, angle):
    """Abscissae (n,) [m] of a profile's joints once it leans by ``angle`` [rad] and begins at its highest point."""
    y = np.array([joint.y for joint in profile.joints])
    if profile.kind == "wheel":
        return y
    raster = np.linspace(profile.start, profile.stop, 2001)[1:-1]
    highest = raster[np.argmin(math.cos(angle) * profile.height(raster) - math.sin(angle) * raster)]
    y, z = np.append(y, highest), profile.height(np.append(y, highest))
    turned = math.cos(angle) * y + math.sin(angle) * z
    return turned[:-1] - turned[-1]


def _roughness(table, low, high):
    """Median distance [1/m] of the curvature between ``low`` and ``high`` [m] from its mean over SMOOTH; a design's few
    joints do not count in it."""
    y = places(table, STEP)
    y = y[(y >= low) & (y <= high)]
    window = np.ones(int(SMOOTH / STEP) | 1)
    if len(y) <= len(window):
        return math.nan
    _, slope, bend = evaluate_table(table, y)
    curvature = bend / (1.0 + slope**2) ** 1.5
    spare = len(window) // 2
    mean = np.convolve(curvature, window / len(window), mode="valid")
    return float(np.median(np.abs(curvature[spare:len(curvature) - spare] - mean)))
