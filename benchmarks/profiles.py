"""Profiles: equivalent conicity of standard ones, also with measurement noise, and the benchmark of EN 15302
(docs/check.md); the effect of noise on ANALYN's contacts after smoothing (docs/profiles.md), of profiles that
data/noisy_profiles.py makes."""

import tempfile
import warnings
from pathlib import Path

import numpy as np

import wrcontact
from data import en15302
from data.noisy_profiles import NAMES, SEEDS, case, noisy_points
from wrcontact import ContactSystem, ProfileWarning
from wrcontact.progress import tracked

#: Rows of the table: rail, its inclination, and the curve of the check.
PAIRS = {"60E1 1:40, without roll": ("60E1", "level"), "60E1 1:40, with roll": ("60E1", "rolled"),
         "UIC60 1:40, without roll": ("UIC60", "level")}
NOISE = 0.01  # [mm] in y and z
SPACING = 0.2  # [mm]
SEED = 0
NOISY = {"UIC60 1:40, without roll, with noise, smoothed": None,
         "UIC60 1:40, without roll, with noise, not smoothed": 0.0}
#: Spacing [mm], noise [mm], and whether y has noise too.
NOISE_CASES = [(spacing, noise, True) for noise in (1e-3, 1e-2, 5e-2) for spacing in (0.1, 0.2, 0.5)] + [
    (0.2, noise, False) for noise in (1e-3, 1e-2, 5e-2)]
RAW_NOISE = (1e-3, 1e-2)  # [mm] noise in z that is not smoothed

# --------------------------------------------------------------------------------------------------- conicity


def conicities():
    """Conicities at 1 ... 8 mm of S1002 on each of PAIRS; nominal radius 460 mm, gauge 1435 mm."""
    reports = {rail: wrcontact.check(ContactSystem(rail=rail)) for rail in ("60E1", "UIC60")}
    return {name: {"conicity": getattr(reports[rail].conicity, curve)}
            for name, (rail, curve) in PAIRS.items()}


def noisy_conicities():
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


def en15302_rows():
    """Rows by case of EN 15302: amplitudes, how many of them keep the tolerance on the value and either
    tolerance, deviation of the conicity, and distance of the curves [mm]."""
    rows = {}
    for name in en15302.WHEELS:
        limits, found = en15302.limits(name), en15302.found_conicity(name)
        off = np.abs(found - limits.value)
        curve = 1e3 * en15302.distances(en15302.radius_difference(name), en15302.found_curve(name))
        value, shift = limits.inside_value(found), limits.inside_shift(found)
        rows[name] = {"wheel": en15302.wheel_words(name), "amplitudes": len(found), "value": int(value.sum()),
                      "either": int((value | shift).sum()), "mean": off.mean(), "worst": off.max(),
                      "curve mean": curve.mean(), "curve worst": curve.max()}
    return rows


# ------------------------------------------------------------------------------------------------------ noise


def noise_study(quick=False):
    """Rows by case: position [mm], area and pressure [%], median and 90 % of each, and poses that are not
    valid; without smoothing the pressure's median [%] alone."""
    rows = {}
    with tempfile.TemporaryDirectory() as folder:
        seeds = range(1 if quick else SEEDS)
        for spacing, noise, both in tracked(NOISE_CASES[:1] if quick else NOISE_CASES, "noisy profiles"):
            off, bad = case(spacing, noise, both, folder, seeds)
            position, area, pressure = np.nanquantile(off, [0.5, 0.9], axis=1).T
            rows[f"{1e3 * noise:g}, {'y, z' if both else 'z'}, {spacing:g}"] = {
                "position": position, "area": 100 * area, "pressure": 100 * pressure, "not valid": bad}
        for noise in RAW_NOISE:
            off, _ = case(0.2, noise, False, folder, seeds, smoothing=0.0)
            rows[f"{1e3 * noise:g}, z, 0.2, not smoothed"] = {"pressure": 100 * np.nanmedian(off[2])}
    return rows
