"""Standard profiles as if measured: points with noise, and what that does to their contacts.

S1002 and UIC60 are sampled at even arc lengths, noise is added to y and z (or to z alone), and the files are
read as any file is.  Right contacts at lateral shifts of -6 ... 6 mm are compared with those of the exact
profiles.
"""

import functools
import math
import warnings
from pathlib import Path

import numpy as np

import wrcontact
from wrcontact.profiles import ProfileWarning, standard_profile

MM = 1e-3
NAMES = {"wheel": "S1002", "rail": "UIC60"}
SHIFTS = np.arange(-6.0, 6.01, 0.5) * MM
SEEDS = 6


@functools.lru_cache
def even_points(kind, spacing):
    """y, z (n,) [mm] of the standard profile, ``spacing`` [mm] apart along it, exact."""
    profile = standard_profile(NAMES[kind])
    y = profile.start + (profile.stop - profile.start) * (
        0.5 - 0.5 * np.cos(np.linspace(0.0, math.pi, 50001))
    )
    s = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y), np.diff(profile.height(y))))]) / MM
    y = np.clip(np.interp(np.arange(0.0, s[-1], spacing), s, y), profile.start, profile.stop)
    return y / MM, profile.height(y) / MM


def noisy_points(kind, spacing, noise, seed, both=True):
    """The points with normal noise [mm] in y and z, or in z alone."""
    random = np.random.default_rng(seed)
    y, z = even_points(kind, spacing)
    return y + (random.normal(0.0, noise, len(y)) if both else 0.0), z + random.normal(0.0, noise, len(z))


def contacts(**profiles):
    """Contact position [mm], patch area [m2], largest pressure [Pa] of the right wheel (3, n), and how many
    are not valid."""
    state = wrcontact.ContactSystem(**profiles).evaluate_many(
        lateral_shift=SHIFTS, side="right", outputs="patches"
    )
    right = state.right
    return np.array([right.contact.y_wheel / MM, right.area, right.max_pressure]), int(
        np.count_nonzero(state.status)
    )


def differences(found, wanted):
    """Differences of position [mm], area and pressure (3, n); the last two are relative."""
    return np.abs(np.vstack([found[:1] - wanted[:1], found[1:] / wanted[1:] - 1.0]))


def case(spacing, noise, both, folder, seeds=range(SEEDS), smoothing=None):
    """Differences (3, n) of all seeds from the exact profiles, and how many poses are not valid."""
    exact, _ = contacts()
    off, bad = [], 0
    for seed in seeds:
        profiles = {}
        for kind in NAMES:
            path = Path(folder, f"{kind}.txt")
            np.savetxt(path, np.transpose(noisy_points(kind, spacing, noise, seed, both)), fmt="%.9f")
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", ProfileWarning)
                profiles[kind] = wrcontact.Profile.from_file(path, kind, smoothing)
        found, failed = contacts(**profiles)
        off, bad = [*off, differences(found, exact)], bad + failed
    return np.concatenate(off, axis=1), bad
