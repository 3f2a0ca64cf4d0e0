"""Profiles as files for other programs, and read back."""

import math
import warnings

import numpy as np
import pytest

from wrcontact import Profile
from wrcontact.profiles import standard_profile
from wrcontact.profiles.formats.base import FORMATS, Format, register
from wrcontact.profiles.writers import WRITTEN, points

MM = 1e-3
PAIRS = [
    (name, ending)
    for name in ("S1002", "EN15302-H", "APTA240", "60E1", "46E1")
    for ending, kind in WRITTEN.items()
    if kind in ("", standard_profile(name).kind)
]


@pytest.mark.parametrize("name, ending", PAIRS)
def test_what_is_written_is_read_back(tmp_path, name, ending):
    profile, path = standard_profile(name), tmp_path / f"profile{ending}"
    profile.save(path)
    given = {"file_inclination": 0.0} if profile.kind == "rail" else {}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # a warning says the order of points, and that corners stay
        found = Profile.from_file(path, profile.kind, smoothing=0.0, **given)
    y, z = points(profile)
    y, z = (
        y[(y * MM >= found.start) & (y * MM <= found.stop)],
        z[(y * MM >= found.start) & (y * MM <= found.stop)],
    )
    assert len(y) > 1000
    # MiniProf counts the height of a wheel from its running circle, which its reader finds to 0.05 um
    np.testing.assert_allclose(found.height(y * MM), z * MM, rtol=0, atol=1e-7 if ending == ".whl" else 1e-9)
    # a spline through the points swings beside a corner
    between = np.linspace(-30.0, 29.0, 3001) * MM
    np.testing.assert_allclose(
        found.height(between), profile.height(between), rtol=0, atol=2e-6 if name == "EN15302-H" else 5e-7
    )


@pytest.mark.parametrize("name", ["60E1", "R65", "CHN60"])
def test_a_head_is_the_same_between_its_points(tmp_path, name):
    """A cubic spline swings where arcs meet, by less than 1 nm where points are close."""
    rail = standard_profile(name)
    rail.save(tmp_path / "a.prr")
    found = Profile.from_file(tmp_path / "a.prr", "rail", smoothing=0.0, file_inclination=0.0)
    y = np.linspace(rail.start, rail.stop, 40001)[1:-1]
    apart = (found.height(y) - rail.height(y)) / np.hypot(1.0, rail.slope(y))
    np.testing.assert_allclose(apart, 0.0, atol=1e-9)


def test_points_are_close_and_include_the_joints():
    wheel = standard_profile("S1002")
    y, z = points(wheel)
    assert np.hypot(np.diff(y), np.diff(z)).max() < 0.11  # [mm], where the back of the flange is vertical
    assert all(np.min(np.abs(y - joint.y / MM)) < 1e-8 for joint in wheel.joints)


def test_simpack_says_its_kind_and_units(tmp_path):
    standard_profile("60E1").save(tmp_path / "a.prr")
    text = (tmp_path / "a.prr").read_text()
    assert "type = 0" in text and "units.len.f = 1000.0" in text and text.count("point.") == 2


def numbers(path, skipped):
    """Rows (n, 2) of a written file behind so many lines."""
    return np.loadtxt(path, skiprows=skipped)


def test_miniprof_counts_from_the_back_of_the_flange_and_upwards(tmp_path):
    """Readers find out by themselves what other programs take as agreed."""
    standard_profile("S1002").save(tmp_path / "a.whl")
    standard_profile("60E1").save(tmp_path / "a.ban")
    for name in ("a.whl", "a.ban"):
        assert (tmp_path / name).read_text().split("\n")[1:3] == ["ColumnDef=X,Y", ""]
    wheel, rail = numbers(tmp_path / "a.whl", 3), numbers(tmp_path / "a.ban", 3)
    assert wheel[0, 0] == 0.0 and np.interp(70.0, *wheel.T) == pytest.approx(0.0, abs=1e-6)
    assert np.interp(70.0 - 55.0, *wheel.T) == pytest.approx(-28.0, abs=1e-3)  # the tip of the flange
    assert np.interp([0.0, 10.0], *rail.T) == pytest.approx(
        [0.0, -(300.0 - math.sqrt(300.0**2 - 10.0**2))], abs=1e-5
    )


def test_gensys_has_the_flange_at_larger_y(tmp_path):
    standard_profile("S1002").save(tmp_path / "a.wheel")
    wheel = numbers(tmp_path / "a.wheel", 1)
    assert np.all(np.diff(wheel[:, 0]) > 0.0)
    assert np.interp(55.0, *wheel.T) == pytest.approx(28.0, abs=1e-3)


def test_endings_are_refused_in_a_sentence(tmp_path):
    wheel = standard_profile("S1002")
    with pytest.raises(ValueError, match="permitted is a file that ends in .json, .csv"):
        wheel.save(tmp_path / "wheel.xyz")
    with pytest.raises(
        ValueError,
        match="a file of a rail, and the profile is a wheel; permitted for it are .csv, .txt, .wheel, .whl, .prw",
    ):
        wheel.save(tmp_path / "wheel.prr")
    worn = Profile(
        "worn",
        "wheel",
        tuple(
            type(z)(z.start, z.stop, (z.coefficients[0] + 1.0, *z.coefficients[1:]), z.origin)
            for z in standard_profile("cone20").zones
        ),
    )
    with pytest.raises(ValueError, match="worn is 1 mm high at its running circle"):
        worn.save(tmp_path / "worn.whl")
    assert not list(tmp_path.iterdir())


def test_a_format_that_takes_anothers_ending_is_refused():
    """A format registers itself, once: the list is as it was."""
    before = list(FORMATS)
    for other in (Format("other", 99, {".ban": "rail"}), Format("other", before[0].turn, {".xyz": ""})):
        with pytest.raises(ValueError, match="formats .* and other have one turn or one ending"):
            register(other)
    assert before == FORMATS and [one.turn for one in FORMATS] == sorted(one.turn for one in FORMATS)
