"""Corners rounded by a stated radius.

Witnesses: the closed form of a fillet between two straight lines, and between a line and a circle; tangents; the distance
of a centre from both curves.
"""

import json
import warnings

import numpy as np
import pytest

import wrcontact
from wrcontact import Profile, ProfileFile, ProfileWarning
from wrcontact.profiles import standard_profile
from wrcontact.profiles.zones import Arc, Polynomial

MM = 1e-3


def wedge(left, right):
    """Two straight lines of these slopes that meet at y = 0."""
    return Profile(
        "wedge", "rail", (Polynomial(-40, 0, (0.0, left)), Polynomial(0, 40, (0.0, right))), smooth=False
    )


def rounded(profile, radius):
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        found = profile.rounded(radius)
    return found, " ".join(str(each.message) for each in said)


@pytest.mark.parametrize("left, right", [(-0.3, 0.4), (0.6, 0.1), (0.0, 1.5), (0.2, -0.2)])
@pytest.mark.parametrize("radius", [0.5, 3.0, 12.0])
def test_a_fillet_between_two_lines(left, right, radius):
    """Tangents of the length R tan(turn / 2) from the corner, and R (1 / cos(turn / 2) - 1) between corner and arc."""
    found, said = rounded(wedge(left, right), radius * MM)
    before, arc, after = found.zones
    turn = abs(np.arctan(right) - np.arctan(left))
    reach = radius * np.tan(turn / 2)
    assert before.stop == arc.start == pytest.approx(-reach * np.cos(np.arctan(left)), rel=1e-9)
    assert after.start == arc.stop == pytest.approx(reach * np.cos(np.arctan(right)), rel=1e-9)
    assert isinstance(arc, Arc) and arc.radius == radius
    assert np.hypot(arc.y_centre, arc.z_centre) == pytest.approx(radius / np.cos(turn / 2), rel=1e-9)
    for zone, at in ((before, arc.start), (after, arc.stop)):
        np.testing.assert_allclose([part for part in arc(at)][:2], [part for part in zone(at)][:2], atol=1e-9)
    moved = 1e3 * radius * (1 / np.cos(turn / 2) - 1)
    assert (
        f"moves the profile by up to {moved:.2g} um" in said
        and f"of up to {np.degrees(turn):.3g} deg" in said
    )
    # the profile lies on the inner side of its corner, and nowhere else it has moved
    y = np.linspace(-0.03, 0.03, 1201)
    lift = found.height(y) - wedge(left, right).height(y)
    assert (np.sign(right - left) * lift >= -1e-15).all()
    outside = (y * 1e3 < arc.start - 1e-9) | (y * 1e3 > arc.stop + 1e-9)
    assert (lift[outside] == 0.0).all() and (arc.stop - arc.start < 0.05 or abs(lift).max() > 0.0)


def test_a_fillet_between_a_line_and_a_circle():
    """The centre is R from the line and R + r or R - r from the circle's centre."""
    circle = Arc(0.0, 20.0, 30.0, 0.0, 30.0, -1)
    profile = Profile("bent", "rail", (Polynomial(-20, 0, (0.0, -0.5)), circle), smooth=False)
    found, _ = rounded(profile, 4e-3)
    arc = found.zones[1]
    assert np.hypot(arc.y_centre, arc.z_centre - 30.0) == pytest.approx(30.0 - 4.0, abs=1e-9)
    line = (0.5 * arc.y_centre + arc.z_centre) / np.hypot(0.5, 1.0)
    assert abs(line) == pytest.approx(4.0, abs=1e-9)
    assert max(abs(joint.slope_step) for joint in found.joints) < 1e-9


def test_corners_of_printed_profiles():
    """EN 15302's wheel H has three; none of them is left, and its tread has not moved."""
    wheel = standard_profile("EN15302-H")
    found, said = rounded(wheel, 1e-3)
    assert "3 corners" in said and len(found.zones) == len(wheel.zones) + 3
    for joint in found.joints:
        slope = found.slope(joint.y)
        assert abs(joint.slope_step) / (1 + slope**2) < 1e-4
    y = np.linspace(-5e-3, 25e-3, 301)
    assert (found.height(y) == wheel.height(y)).all()
    state = wrcontact.ContactSystem(wheel=found).evaluate(3e-3)
    assert state.status == 0


def test_profiles_without_corners_stay():
    for name in ("S1002", "60E1"):
        profile = standard_profile(name)
        found, said = rounded(profile, 2e-3)
        assert found == profile and said == ""


def test_an_arc_reaches_over_short_zones():
    """As in a file of points: zones of 0.2 mm beside a corner."""

    def pieces(slope, ends):
        return [Polynomial(a, b, (0.0, slope)) for a, b in zip(ends, ends[1:])]

    zones = (
        *pieces(-0.2, np.arange(-10.0, 0.1, 0.2).round(9)),
        *pieces(0.3, np.arange(0.0, 10.1, 0.2).round(9)),
    )
    found, _ = rounded(Profile("fine", "rail", zones, smooth=False), 5e-3)
    plain, _ = rounded(wedge(-0.2, 0.3), 5e-3)
    y = np.linspace(-5e-3, 5e-3, 501)
    np.testing.assert_allclose(found.height(y), plain.height(y), atol=1e-12)
    assert len(found.zones) < len(zones)


def test_what_does_not_fit_is_refused():
    with pytest.raises(ValueError, match=r"an arc of 500 mm does not fit into the corner at y = 0 mm"):
        wedge(-0.3, 0.4).rounded(0.5)
    near = Profile(
        "near",
        "rail",
        (Polynomial(-20, 0, (0.0, -0.5)), Polynomial(0, 1, (0.0,)), Polynomial(1, 20, (0.0, 0.5), 1.0)),
        smooth=False,
    )
    with pytest.raises(ValueError, match="does not fit"):
        near.rounded(10e-3)
    assert len(rounded(near, 1e-3)[0].zones) == 5
    for radius in (0.0, -1e-3, 2.0, "1"):
        with pytest.raises(ValueError, match="radius is"):
            wedge(-0.3, 0.4).rounded(radius)


def test_the_option_of_files_and_names(tmp_path):
    """Of a name, of a prepared file, and of a system; kept by a prepared file."""
    with pytest.warns(ProfileWarning, match="radius of 2 mm"):
        system = wrcontact.ContactSystem(wheel=ProfileFile("en15302-h", corner_radius=2e-3))
    wanted, _ = rounded(standard_profile("EN15302-H"), 2e-3)
    assert system.wheel.zones == wanted.zones
    standard_profile("EN15302-H").save(tmp_path / "h.json")
    wanted.save(tmp_path / "rounded.json")
    y = np.linspace(-12e-3, -8e-3, 401)
    with pytest.warns(ProfileWarning, match="radius of 2 mm"):
        found = Profile.from_file(tmp_path / "h.json", "wheel", corner_radius=2e-3)
    np.testing.assert_allclose(found.height(y), wanted.height(y), atol=1e-12)
    back = Profile.from_file(tmp_path / "rounded.json", "wheel")
    np.testing.assert_allclose(back.height(y), wanted.height(y), atol=1e-12)
    assert "arc" in json.dumps(json.loads((tmp_path / "rounded.json").read_text())).lower()
    with pytest.raises(ValueError, match="corner_radius is 2"):
        ProfileFile("S1002", corner_radius=2.0)


def test_an_fmu_packs_the_rounded_profile():
    """Under a name of its own: the standard name would be read as the standard profile."""
    from wrcontact.fmu.archive import chosen_starts

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        starts, profiles = chosen_starts(wheel_profile=ProfileFile("EN15302-H", corner_radius=2e-3))
    assert starts["wheel_profile"] == "EN15302-H-corners-2mm.json"
    wanted, _ = rounded(standard_profile("EN15302-H"), 2e-3)
    assert profiles[starts["wheel_profile"]].zones == wanted.zones


def test_the_option_of_the_command_line(run):
    code, out, err = run(
        "solve", "--wheel", "EN15302-H", "--wheel-corner-radius-mm", 2, "--lateral-shift-mm", 1
    )
    assert code == 0 and "radius of 2 mm" in " ".join(err.split())
    code, _, err = run("solve", "--wheel", "EN15302-H", "--wheel-corner-radius-mm", 2000)
    assert code == 2 and "permitted is 0.001 ... 100 mm" in " ".join(err.split())
