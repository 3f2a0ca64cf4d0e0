"""Standard profiles by name: their numbers against printed dimensions, designations of EN 13715, and pairs of all."""

import subprocess
import sys
import warnings

import numpy as np
import pytest

import wrcontact
from wrcontact import ContactSystem, Profile, ProfileWarning
from wrcontact.profiles import standard_profile
from wrcontact.profiles.catalogue import find_profile, standard_name
from wrcontact.profiles.standards import PATTERNS, names, standards
from wrcontact.profiles.zones import Arc, Polynomial

MM = 1e-3
RAILS, WHEELS = names("rail"), names("wheel")
FLANGES = (
    "S1002/h28/e32.5/6.7%",
    "S1002/h30/e31.5/15%",
    "S1002/h32/e28.5/15%",
    "1-40/h30/e32.5/15%",
    "1-40/h31/e29/6.7%",
)
#: Printed width of a head [mm] and how far below its top it is measured [mm].
WIDTHS = {
    "60E1": (72.0, 14.3),
    "60E2": (72.0, 14.3),
    "54E1": (70.0, 14.1),
    "49E1": (67.0, 14.0),
    "46E1": (65.0, 14.3),
    "50E1": (65.0, 13.58),
    "56E1": (69.85, 14.53),
    "R65": (73.0, 15.67),
    "R50": (70.24, 15.4),
    "CHN60": (70.8, 14.2),
    "60N": (70.8, 14.2),
}
#: The same of heads of EN 13674-1 without a drawing that was compared, in whole millimetres, as makers of rails name
#: them; 14 mm below the top, where the widths of the others are within 0.1 mm of theirs.
ROUNDED_WIDTHS = {
    **{name: 62.0 for name in ("46E2", "55E1")},
    **{name: 65.0 for name in ("50E6", "52E1")},
    **{name: 67.0 for name in ("49E2", "49E5", "50E5", "54E2", "54E3", "54E4")},
    **{name: 70.0 for name in ("50E3", "50E4")},
}
#: Heights of the tread of S1002 [mm] by y [mm], of tables C.1 and C.2 of EN 13715:2020.
TREAD = {
    -30.0: 3.922,
    -26.0: 2.741,
    -20.0: 1.597,
    -10.0: 0.523,
    -5.0: 0.211,
    5.0: -0.132,
    10.0: -0.208,
    20.0: -0.312,
    30.0: -0.646,
}


@pytest.mark.parametrize("name", WIDTHS)
def test_heads_have_the_printed_width(name):
    width, depth = WIDTHS[name]
    y = np.linspace(30.0, 38.0, 100001) * MM
    z = standard_profile(name).height(y)
    found = np.interp(depth * MM, z[np.isfinite(z)], y[np.isfinite(z)])
    assert found == pytest.approx(0.5 * width * MM, abs=0.002 * MM)


@pytest.mark.parametrize("name", ROUNDED_WIDTHS)
def test_heads_have_the_width_of_data_sheets(name):
    y = np.linspace(30.0, 36.0, 6001) * MM
    z = standard_profile(name).height(y)
    found = np.interp(14.0 * MM, z[np.isfinite(z)], y[np.isfinite(z)])
    assert found == pytest.approx(0.5 * ROUNDED_WIDTHS[name] * MM, abs=0.05 * MM)


@pytest.mark.parametrize("name", RAILS[:-1])
def test_heads_are_tangent_symmetric_and_deep_enough(name):
    rail = standard_profile(name)
    assert rail.smooth and max(abs(joint.slope_step) for joint in rail.joints) < 1e-6
    y = np.linspace(0.0, rail.stop, 301)
    np.testing.assert_allclose(rail.height(-y), rail.height(y), rtol=0, atol=1e-15)
    assert rail.height(0.0) == 0.0 and rail.height(y).max() > 20.0 * MM


@pytest.mark.parametrize("tread", ["S1002", "1-40"])
@pytest.mark.parametrize("height", [28.0, 29.3, 30.0, 32.0])
@pytest.mark.parametrize("thickness", [28.5, 31.5, 32.5])
def test_flanges_have_the_height_and_the_thickness_of_their_designation(tread, height, thickness):
    """The thickness is measured 10 mm below the running circle; the face has 70 deg."""
    wheel = standard_profile(standard_name(f"{tread}/h{height:g}/e{thickness:g}/15%"))
    y = np.linspace(-69.9, -30.0, 40001) * MM
    z = wheel.height(y)
    lower = 12.0 - np.sqrt(
        12.0**2 - (0.5 * (32.5 - thickness)) ** 2
    )  # both arcs R12 of the tip meet in a corner
    assert z.max() == pytest.approx((height - lower) * MM, abs=2e-3 * MM)  # steps of 1-40: 1.5 um
    face = y[z > 10.0 * MM][-1]
    assert face == pytest.approx(
        -(70.0 - (32.5 - thickness) - 32.5) * MM - (32.5 - thickness) * MM * 2, abs=0.01
    )
    assert 70.0 + face / MM == pytest.approx(thickness, abs=0.005)
    assert np.degrees(np.arctan(wheel.slope(y)).min()) == pytest.approx(-70.0, abs=1e-3)
    turns = [joint for joint in wheel.joints if -50.0 * MM < joint.y < -34.0 * MM - (32.5 - thickness) * MM]
    assert max(abs(joint.height_step) for joint in turns) < 2e-7
    assert wheel.slope([50.0 * MM])[0] == pytest.approx(-0.15, abs=1e-12)


def test_the_flange_of_28_mm_is_that_of_s1002():
    wheel, exact = standard_profile("S1002/h28/e32.5/6.7%"), standard_profile("S1002")
    y = np.linspace(-69.0, 59.0, 5001) * MM
    np.testing.assert_allclose(wheel.height(y), exact.height(y), rtol=0, atol=1e-9)


@pytest.mark.parametrize("name", ["S1002", "S1002/h32/e32.5/15%"])
def test_the_tread_of_s1002_is_the_standards_table(name):
    found = standard_profile(name).height(np.array(list(TREAD)) * MM) / MM
    np.testing.assert_allclose(found, list(TREAD.values()), rtol=0, atol=6e-4)


def test_a_thinner_flange_moves_with_the_tread_beside_it():
    thin, whole = standard_profile("S1002/h28/e30/6.7%"), standard_profile("S1002")
    y = np.linspace(-37.0, -0.6, 301) * MM
    np.testing.assert_allclose(thin.height(y - 2.5 * MM), whole.height(y), rtol=0, atol=3e-7)
    straight = np.linspace(-3.0, 0.0, 7) * MM
    np.testing.assert_allclose(
        np.diff(thin.height(straight)), -0.5 * MM * thin.height([-3.0 * MM])[0] / (3.0 * MM)
    )


@pytest.mark.parametrize("name", [*WHEELS, *FLANGES])
def test_a_wheel_has_height_0_on_its_running_circle(name):
    """As the nominal radius and the heights of flanges have it; prints of six digits leave 7 nm."""
    assert standard_profile(name).height(0.0) == pytest.approx(0.0, abs=1e-8)


def test_names_are_read_in_any_case_and_by_other_names():
    for name, known in {
        "uic54": "54E1",
        "UIC 54": "54E1",
        "bs-113a": "56E1",
        "p65": "R65",
        "\u042065": "R65",
        "lma": "LMA",
        "en15302_c": "P8",
        "S1002/H30/E31.50/15": "S1002/h30/e31.5/15%",
        "1/40 / h28 / e32.5 / 6.7 %": "1-40/h28/e32.5/6.7%",
        "EN 13715 – 1-40 / h 28 / e 32,5 / 6,7 %": "1-40/h28/e32.5/6.7%",
        "EN13715_S1002_h30_e32.5_6.7%": "S1002/h30/e32.5/6.7%",
    }.items():
        assert standard_name(name) == known
        kind = standard_profile(known).kind
        assert find_profile(name, kind) is standard_profile(known)
    every = [
        one
        for kind in ("rails", "wheels")
        for name, entry in standards()[kind].items()
        for one in (name, *entry.get("also", ()))
    ]
    assert len({one.lower() for one in every}) == len(every)


@pytest.mark.parametrize(
    "name, kind, sentence",
    [
        ("CHN6", "rail", "did you mean CHN60"),
        ("APTA14", "wheel", "did you mean APTA140 or APTA140M"),
        (
            "GOST 10791",
            "wheel",
            "'GOST 10791': no public source with enough numbers was found of GOST10791; permitted is a file",
        ),
        ("a GOST wheel", "wheel", "no public source with enough numbers was found of GOST;"),
        ("ГОСТ 10791-2011", "wheel", "found of GOST10791;"),
        ("136re", "rail", "'136re': no public source with enough numbers was found of 136RE"),
        ("AREMA 136RE", "rail", "found of 136RE"),
        ("AAR-1B wide", "wheel", "found of AAR1B"),
        ("EPS/h28/e32.5/6.7%", "wheel", "found of EPS"),
        ("EPS/h28.csv", "wheel", "found of EPS"),
        ("steps.csv", "wheel", "there is no such file"),
        ("folder/LMD.csv", "wheel", "there is no such file"),
        ("GOST", "rail", "permitted are UIC60"),
        ("LMX", "wheel", "permitted are S1002"),
        ("P100", "wheel", "permitted are S1002"),
        ("S1002/h30", "wheel", "a wheel of EN 13715 is written S1002/h28/e32.5/6.7% or 1-40/h28"),
        ("1-20/h28/e32.5/6.7%", "wheel", "a wheel of EN 13715 is written"),
        ("R65", "wheel", "a profile of the other kind"),
        (
            "S1002/h33/e30/15%",
            "wheel",
            "height of its flange h of wheel 'S1002/h33/e30/15%' is 33 mm; permitted is 28 ... 32 mm",
        ),
        ("S1002/h30/e33/15%", "wheel", "thickness of its flange e .* 28.5 ... 32.5 mm"),
        ("1-40/h30/e30/20%", "wheel", "outer slope .* is 20 %; permitted is 6.7 ... 15 %"),
    ],
)
def test_what_is_no_name_is_refused_in_a_sentence(name, kind, sentence):
    with pytest.raises(ValueError, match=sentence):
        find_profile(name, kind)


@pytest.mark.parametrize("name", [*RAILS, *WHEELS, *PATTERNS])
def test_every_profile_says_where_its_numbers_come_from(name):
    source = standard_profile(name).source
    assert source.standard and source.origin and source.sources >= 1 - (name.startswith("cone"))
    assert "\n" not in str(source) and source.standard in str(source)


def test_nothing_is_read_before_a_name_is_asked():
    asked = "from wrcontact.profiles.standards import standards; print(standards.cache_info().misses)"
    code = f"import wrcontact, wrcontact.cli; {asked}; wrcontact.ContactSystem(); {asked}"
    assert subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    ).stdout.split() == ["0", "1"]


# --- printed zones --------------------------------------------------------------------------------------------


def test_steps_between_printed_zones_are_joined_from_the_inside_out_with_a_remark():
    zones = (
        Polynomial(-40.0, -20.0, (0.009, -0.1), -20.0),
        Polynomial(-20.0, 20.0, (0.0, 0.0)),
        Arc(20.0, 30.0, 100.0, 20.0, 100.005, -1),
        Polynomial(30.0, 40.0, (0.51, 0.1), 30.0),
    )
    with pytest.warns(
        ProfileWarning, match=r"3 steps of up to 0.009 mm between its zones .* joined by moving the zones"
    ):
        wheel = Profile("printed", "wheel", zones, smooth=False)
    at = np.array([-20.0, -40.0, 20.0, 25.0, 30.0, 40.0]) * MM
    arc = 100.0 - np.sqrt(100.0**2 - np.array([0.0, 5.0, 10.0]) ** 2)
    expected = [0.0, 2.0, *arc, arc[-1] + 1.0]
    np.testing.assert_allclose(wheel.height(at) / MM, expected, rtol=0, atol=1e-12)
    assert max(abs(joint.height_step) for joint in wheel.joints) < 1e-16
    assert [round(joint.slope_step, 6) for joint in wheel.joints][0] == 0.1  # the corner stays


def test_a_larger_step_is_refused_with_the_largest_that_is_joined():
    with pytest.raises(ValueError, match="height step of 0.011 mm at y = 0.0 mm, permitted is 0.01 mm"):
        Profile("broken", "wheel", (Polynomial(-9.0, 0.0, (0.0, 0.0)), Polynomial(0.0, 9.0, (0.011, 0.0))))


# --- pairs ----------------------------------------------------------------------------------------------------


def check_pair(wheel, rail, count):
    """A rigid wheelset touches at every lateral shift within 10 mm."""
    source = standard_profile(standard_name(wheel)).source
    system = ContactSystem(
        wheel,
        rail,
        rail_inclination=0.0 if standard_profile(rail).source.inclined else 1 / 40,
        running_circle_distance=source.running_circle_distance or 1.5,
    )
    table = system.evaluate_many(np.linspace(-10.0, 10.0, count) * MM, outputs="geometry")
    assert not np.any(table.status), (wheel, rail)
    assert np.max(np.abs(table.roll)) < 0.1


@pytest.mark.parametrize("wheel", [*WHEELS, *FLANGES])
def test_a_wheel_of_the_catalogue_runs_on_rails_of_it(wheel):
    """Without a remark: names of standards need none."""
    first = [*WHEELS, *FLANGES].index(wheel)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for rail in (RAILS[first % len(RAILS)], RAILS[(5 * first + 3) % len(RAILS)]):
            check_pair(wheel, rail, 41)


@pytest.mark.full
@pytest.mark.parametrize("wheel", [*WHEELS, *FLANGES])
def test_every_pair_of_the_catalogue_runs(wheel):
    for rail in RAILS:
        check_pair(wheel, rail, 401)


@pytest.mark.full
@pytest.mark.parametrize("mode", [{"contact_mode": "elastic"}, {"yaw": 0.02}])
@pytest.mark.parametrize("wheel", [*WHEELS, *FLANGES])
def test_every_pair_of_the_catalogue_runs_elastic_and_with_yaw(wheel, mode):
    """Below the flange; a status other than valid is the end of a profile alone."""
    yaw = mode.get("yaw", 0.0)
    for rail in RAILS:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            system = ContactSystem(
                wheel, rail, rail_inclination=0.025, contact_mode=mode.get("contact_mode", "rigid")
            )
        table = system.evaluate_many(np.linspace(-10.0, 10.0, 41) * MM, yaw=yaw)
        assert set(np.unique(table.status)) <= {wrcontact.Status.VALID, wrcontact.Status.OFF_PROFILE}, (
            wheel,
            rail,
        )


def test_another_distance_of_the_running_circles_is_a_remark():
    with pytest.warns(
        ProfileWarning,
        match="running circles of its wheelsets are 1493 mm apart; running_circle_distance is 1500 mm",
    ):
        system = ContactSystem("LMA", "CHN60")
    assert system.parameters["running_circle_distance"] == 1.5  # nothing is changed


def test_a_rail_that_is_inclined_already_is_a_remark():
    with pytest.warns(ProfileWarning, match="it is inclined by 1:20 already"):
        ContactSystem("EN15302-A", "EN15302-rail-A")
