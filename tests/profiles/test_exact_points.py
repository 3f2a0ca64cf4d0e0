"""Exact points of a profile are kept at any spacing, and outliers among points are still found."""

import numpy as np
import pytest

from tests.helpers.profile_points import INSIDE, MM, Y, Z, changed, columns, read
from wrcontact.profiles import RAILS, WHEELS, standard_profile

NAMED = (0.22, 0.25, 0.3, 0.35, 0.4, 1.0)
OTHERS = (0.05, 0.07, 0.1, 0.15, 0.2, 0.27, 0.5, 0.7, 0.85)


def sampled(name, spacing, share, along):
    """y, z (n,) [mm] of a standard profile, ``spacing`` [mm] apart in y or along the arc, from ``share`` of
    the spacing after its start."""
    profile = standard_profile(name)
    start, stop = profile.start / MM, profile.stop / MM
    y = start + (stop - start) * (0.5 - 0.5 * np.cos(np.linspace(0.0, np.pi, 50001)))
    s = y
    if along == "arc":
        s = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y), np.diff(profile.height(y * MM)) / MM))])
    y = np.clip(np.interp(np.arange(s[0] + share * spacing, s[-1], spacing), s, y), start, stop)
    return y, profile.height(y * MM) / MM


def check_kept(folder, name, spacing, share, along):
    """Nothing is reported, the curve goes through every point, and is within 2 um if they are close."""
    kind = "wheel" if name in WHEELS else "rail"
    y, z = sampled(name, spacing, share, along)
    text = "".join(f"{a!r} {b!r}\n" for a, b in zip(y.tolist(), z.tolist()))
    profile, said = read(folder, text, kind)
    case = (name, spacing, share, along)
    assert said == "" and profile.reading.points == len(y), case
    low, high = (
        max(limit, edge) if limit < 0 else min(limit, edge)
        for limit, edge in zip(INSIDE[kind], (y[0], y[-1]))
    )
    exact = standard_profile(name)
    for places, most in ((y[(y > low) & (y < high)], 5e-6), (np.linspace(low, high, 3001), 2e-3)):
        error = np.abs(profile.height(places * MM) - exact.height(places * MM)) / MM
        assert np.max(error / np.hypot(1.0, exact.slope(places * MM))) < most or spacing > 0.25, case


@pytest.mark.parametrize("along", ["y", pytest.param("arc", marks=pytest.mark.full)])
@pytest.mark.parametrize("name", ["S1002", *(pytest.param(rail, marks=pytest.mark.full) for rail in RAILS)])
def test_exact_points_are_kept(tmp_path, name, along):
    shares = np.random.default_rng(14).random(len(NAMED))
    for spacing, share in zip(NAMED, shares):
        check_kept(tmp_path, name, spacing, share, along)


@pytest.mark.complete
@pytest.mark.parametrize("along", ["y", "arc"])
@pytest.mark.parametrize("name", ["S1002", *RAILS])
def test_exact_points_are_kept_at_any_offset(tmp_path, name, along):
    random = np.random.default_rng(41)
    for spacing in (*NAMED, *OTHERS):
        for share in (0.0, *random.random(4)):
            check_kept(tmp_path, name, spacing, share, along)


@pytest.mark.parametrize("name", ["S1002", "UIC60"])
@pytest.mark.parametrize("spacing", [0.1, 0.25, 0.4])
def test_spikes_among_exact_points_are_left_out(tmp_path, name, spacing):
    kind, random = "wheel" if name in WHEELS else "rail", np.random.default_rng(7)
    y, z = sampled(name, spacing, 0.3, "arc")
    flat = np.flatnonzero((y > INSIDE[kind][0]) & (y < INSIDE[kind][1]))
    places = random.choice(flat[10:-10:20], 6, replace=False)
    z = changed(z, places, random.uniform(0.1, 1.0, 6) * random.choice([-1, 1], 6))
    profile, said = read(tmp_path, columns(y, z), kind)
    assert "6 outliers of up to" in said
    others = np.setdiff1d(flat, places)
    shift = 0.0 if kind == "wheel" else profile.zones[0].start - y[0]
    heights = profile.height((y[others] + shift) * MM) / MM
    assert np.ptp(heights - z[others]) < 1e-4


@pytest.mark.parametrize("seed", range(9, 13))
def test_spikes_in_noise_are_left_out(tmp_path, seed):
    random = np.random.default_rng(seed)
    y, z = (part + random.normal(0.0, 0.01, len(Y)) for part in (Y, Z))
    places = random.choice(np.arange(40, 720, 12), 20, replace=False)
    profile, said = read(tmp_path, columns(y, changed(z, places, random.uniform(0.15, 2.0, 20))))
    assert "20 outliers of up to" in said


def test_without_smoothing_outliers_and_kinks_are_kept_and_reported(tmp_path):
    z = changed(Z, [300], 0.3)
    profile, said = read(tmp_path, columns(Y, z), smoothing=0.0)
    assert "1 outlier of up to 0.2" in said and "kept, since smoothing is 0 (y = " in said
    inside = (Y > INSIDE["wheel"][0]) & (Y < INSIDE["wheel"][1])
    assert np.max(np.abs(profile.height(Y[inside] * MM) / MM - z[inside])) < 1e-9
    z = Z - np.tan(np.radians(10.0)) * np.maximum(Y - 3.05, 0.0)
    profile, said = read(tmp_path, columns(Y, z), smoothing=0.0)
    assert "1 kink of up to 9." in said and "kept, since smoothing is 0" in said
    assert np.max(np.abs(profile.height(Y[inside] * MM) / MM - z[inside])) < 1e-9
