"""Wheels whose y = 0 is not their running circle are reported, with distances known without the code: the
back of S1002's flange is 70 mm from its running circle (EN 13715), so wheelsets with circles 1500 mm apart
are 1360 mm back to back."""

import warnings

import numpy as np
import pytest

import wrcontact
from data.en15302 import profile as standard_wheel
from tests.helpers.profile_points import Y, Z, changed, columns, noisy
from wrcontact import ContactSystem, Profile, ProfileWarning
from wrcontact.fmu.archive import chosen_starts
from wrcontact.profiles import WHEELS, standard_profile
from wrcontact.profiles.plausible import nominal_gauge, remarks_on

TRACK = {"gauge": 1.435, "running_circle_distance": 1.5}
#: What a file has of the flange: its back, its tip, or its face alone; the first y that is kept [mm].
PARTS = {"back": -75.0, "tip": -62.0, "face": -48.0}


def wheel(folder, y, z, name="own.txt"):
    """The wheel through points, silently."""
    (folder / name).write_text(columns(y, z))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ProfileWarning)
        return Profile.from_file(folder / name, "wheel")


def shifted(folder, shift, part="back"):
    kept = Y >= PARTS[part]
    return wheel(folder, Y[kept] + shift, Z[kept])


# --- what is said -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "part, shifts",
    [("back", (-20, -10, -6, 4, 6, 10, 20)), ("tip", (-20, -10, 4, 10, 20)), ("face", (-20, -9, 4, 10))],
)
def test_a_wrong_origin_is_reported(tmp_path, part, shifts):
    for shift in shifts:
        said = " ".join(remarks_on(shifted(tmp_path, shift, part), TRACK))
        assert "of its flange is at y = " in said and "y = 0 is the running circle" in said, shift
        assert f"and z = 0 at y = {shift:.3g} mm" in said
    assert f"the {part} of its flange is at y = " in said or part == "tip"


def test_the_numbers_are_those_of_the_standard(tmp_path):
    (back,) = remarks_on(shifted(tmp_path, 10.0), TRACK)
    for words in (
        "the back of its flange is at y = -60 mm",
        "the back-to-back distance is 1380 mm",
        "with running circles 1500 mm apart",
        "usual is 1350 ... 1368 mm on a gauge of 1435 mm",
    ):
        assert words in back
    (tip,) = remarks_on(shifted(tmp_path, -10.0, "tip"), TRACK)  # S1002's is 15 mm from the back
    assert "the tip of its flange is at y = -65 mm" in tip and "is 1340 mm" in tip


@pytest.mark.parametrize("middle", [1.5, 3.0])
def test_a_wheel_that_has_grown_is_reported(tmp_path, middle):
    (said,) = remarks_on(wheel(tmp_path, Y, Z + middle), TRACK)
    assert said.startswith(f"at y = 0 it is {middle:g} mm larger than nominal_radius")


def test_another_distance_of_the_running_circles_is_a_wrong_origin_too():
    assert "is 1460 mm" in remarks_on(standard_profile("S1002"), {**TRACK, "running_circle_distance": 1.6})[0]


# --- what is not ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", WHEELS)
def test_built_in_wheels_are_not_reported(name):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ContactSystem(wheel=name)


@pytest.mark.parametrize("letter", "ABHI")
def test_wheels_of_the_standard_are_not_reported(letter):
    assert remarks_on(standard_wheel("wheel", letter), TRACK) == ()


WORN = {
    "hollow": (Y, Z - 3.0 * np.exp(-(((Y - 5.0) / 18.0) ** 2))),
    "worn tread": (Y, Z - 5.0 * (Y > -30.0) - 5.0 * np.clip((Y + 38.0) / 8.0, 0.0, 1.0) * (Y <= -30.0)),
    "thin flange": (Y - 6.0 * np.exp(-(((Y + 39.0) / 6.0) ** 2)), Z),
    "noise": noisy("wheel", 0.05, 3),
    "new at 2 mm": (Y + 2.0, Z),
}


@pytest.mark.parametrize("case", WORN)
def test_ordinary_wheels_are_not_reported(tmp_path, case):
    y, z = WORN[case]
    found = wheel(tmp_path, y, z)
    assert remarks_on(found, TRACK) == () and remarks_on(found, {**TRACK, "gauge": 1.465}) == ()


@pytest.mark.parametrize(
    "gauge, circles, back",
    [
        (1.435, 1.5, -72.2),
        (1.435, 1.511, -77.8),
        (1.520, 1.58, -70.0),
        (1.668, 1.733, -70.0),
        (1.0, 1.07, -70.0),
        (1.067, 1.13, -70.0),
    ],
)
def test_other_railways_have_their_own_distances(tmp_path, gauge, circles, back):
    """AAR's narrow and wide tread datum, Russia, Spain, the Rhaetian Railway, the Cape gauge."""
    track = {"gauge": gauge, "running_circle_distance": circles}
    assert remarks_on(wheel(tmp_path, Y + back + 70.0, Z), track) == ()


def test_no_main_line_has_no_known_distances(tmp_path):
    found = {gauge: nominal_gauge(gauge) for gauge in (1300.0, 1430.0, 1465.0, 1524.0)}
    assert found == {1300.0: None, 1430.0: 1435.0, 1465.0: 1435.0, 1524.0: 1520.0}
    assert remarks_on(shifted(tmp_path, 10.0), {**TRACK, "gauge": 0.75}) == ()


# --- where it is said -------------------------------------------------------------------------------------


def test_python_check_and_the_build_say_it_once(tmp_path):
    (tmp_path / "own.txt").write_text(columns(changed(Y, slice(None), 10.0), Z))
    words = "the back of its flange is at y = -60 mm"
    with pytest.warns(ProfileWarning, match=words) as said:
        system = ContactSystem(wheel=tmp_path / "own.txt")
    assert said[0].filename == __file__
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # the user has been told
        assert words in wrcontact.check(system).remarks[0]
    with pytest.warns(ProfileWarning, match=words) as said:
        chosen_starts(wheel_profile=str(tmp_path / "own.txt"))
    assert sum(words in str(one.message) for one in said) == 1
