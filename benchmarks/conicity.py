"""Equivalent conicity of standard profiles, also with measurement noise, and the benchmark of EN 15302
(docs/check.md)."""

import tempfile
import warnings
from pathlib import Path

import numpy as np

import wrcontact
from tests.helpers import en15302
from wrcontact import ContactSystem, ProfileWarning

from .profile_noise import NAMES, noisy_points

#: Rows of the table: rail, its inclination, and the curve of the check.
PAIRS = {"60E1 1:40, without roll": ("60E1", "level"), "60E1 1:40, with roll": ("60E1", "rolled"),
         "UIC60 1:40, without roll": ("UIC60", "level")}
NOISE = 0.01  # [mm] in y and z
SPACING = 0.2  # [mm]
SEED = 0
NOISY = {"UIC60 1:40, without roll, with noise, smoothed": None,
         "UIC60 1:40, without roll, with noise, not smoothed": 0.0}


def pairs():
    """Conicities at 1 ... 8 mm of S1002 on each of PAIRS; nominal radius 460 mm, gauge 1435 mm."""
    reports = {rail: wrcontact.check(ContactSystem(rail=rail)) for rail in ("60E1", "UIC60")}
    return {name: {"conicity": getattr(reports[rail].conicity, curve)}
            for name, (rail, curve) in PAIRS.items()}


def noisy():
    """The same of NOISY: both profiles from points every SPACING with NOISE."""
    found = {}
    for name, smoothing in NOISY.items():
        report = wrcontact.check(ContactSystem(**noisy_profiles(smoothing)))
        found[name] = {"conicity": report.conicity.level}
    return found


def noisy_profiles(smoothing):
    """Wheel and rail from points with noise, read as files are."""
    profiles = {}
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore", ProfileWarning)
        for kind in NAMES:
            path = Path(folder, f"{kind}.txt")
            np.savetxt(path, np.transpose(noisy_points(kind, SPACING, NOISE, SEED)), fmt="%.9f")
            profiles[kind] = wrcontact.Profile.from_file(path, kind, smoothing)
    return profiles


def benchmark():
    """Rows by case of EN 15302: amplitudes, how many of them keep the tolerance on the value and either
    tolerance, deviation of the conicity, and distance of the curves [mm]."""
    rows = {}
    for case in en15302.WHEELS:
        limits, found = en15302.limits(case), en15302.found_conicity(case)
        off = np.abs(found - limits.value)
        curve = 1e3 * en15302.distances(en15302.radius_difference(case), en15302.found_curve(case))
        value, shift = limits.inside_value(found), limits.inside_shift(found)
        rows[case] = {"wheel": en15302.wheel_words(case), "amplitudes": len(found), "value": int(value.sum()),
                      "either": int((value | shift).sum()), "mean": off.mean(), "worst": off.max(),
                      "curve mean": curve.mean(), "curve worst": curve.max()}
    return rows
