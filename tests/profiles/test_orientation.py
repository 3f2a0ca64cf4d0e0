"""Rails that are already inclined or have their gauge side at larger y, and the options of ProfileFile."""

import warnings
from dataclasses import replace

import numpy as np
import pytest

import wrcontact
from tests.helpers.foreign_files import inclined_rail, worn_rail
from tests.helpers.profile_points import MM, Y, Z, columns, error, miniprof, points, read, simpack
from wrcontact import ContactSystem, Profile, ProfileFile, ProfileWarning
from wrcontact.profiles.orientation import _gauge_side, head_of
from wrcontact.profiles.running_circle import BACK


def write(folder, text, name):
    (folder / name).write_text(text)
    return folder / name


def read_with(path, kind="rail", **options):
    """The profile in a file and what is said of it."""
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        profile = Profile.from_file(path, kind, **options)
    return profile, str(said[0].message) if said else ""


# --- inclination ----------------------------------------------------------------------------------


@pytest.mark.parametrize("noise", [0.0, 0.01, 0.05])
@pytest.mark.parametrize("inclination", [1 / 20, 1 / 40, 1 / 100, 0.0])
def test_the_inclination_of_a_new_head_is_found(inclination, noise):
    found = head_of(*inclined_rail(inclination, noise=noise))
    assert found.symmetric and found.inclination == pytest.approx(inclination, abs=2e-3)


def pressure(rail, **track):
    """Largest pressure [Pa] of S1002 on this rail in the middle, silently."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ProfileWarning)
        system = ContactSystem(rail=rail, **track)
    return system.evaluate(normal_force=78.5e3).right.max_pressure


@pytest.mark.parametrize("track", [1 / 20, 1 / 40])
@pytest.mark.parametrize("noise", [0.0, 0.002])
def test_a_head_that_leans_as_its_track_is_turned_upright(tmp_path, track, noise):
    """And has the contact of the upright rail on this track, not that of a rail that is inclined twice."""
    path = write(tmp_path, simpack(*inclined_rail(track, noise=noise), "rail"), "own.prr")
    with pytest.warns(ProfileWarning, match="as this track inclines it; turned upright from 1:"):
        system = ContactSystem(rail=path, rail_inclination=track)
    assert system.rail.reading.inclination == track
    exact = pressure("UIC60", rail_inclination=track)
    if not noise:
        assert error(system.rail) < 1e-3
        assert pressure(path, rail_inclination=track) == pytest.approx(exact, rel=2e-3)
        # what a rail inclined twice would have
        twice = pressure(ProfileFile(path, file_inclination=0.0), rail_inclination=track)
        assert twice > 1.05 * exact


@pytest.mark.parametrize("left", [1 / 20, None])
def test_the_left_rail_is_turned_by_the_left_track(tmp_path, left):
    path = write(tmp_path, simpack(*inclined_rail(1 / 20), "rail"), "own.prr")
    if left is None:
        with pytest.raises(
            ValueError, match="and its track inclines it by 1:40; file_inclination = 0.05 turns"
        ):
            ContactSystem(left_rail=path)
        return
    with pytest.warns(ProfileWarning, match="turned upright from 1:20"):
        system = ContactSystem(left_rail=path, left_rail_inclination=left)
    assert system.left_rail.reading.inclination == left and system.rail.reading is None


@pytest.mark.parametrize(
    "inclination, track, sentence",
    [
        (
            1 / 40,
            1 / 20,
            "towards the track centre in the file, and its track inclines it by 1:20; "
            "file_inclination = 0.025 turns it upright, file_inclination = 0 confirms that it is upright",
        ),
        (1 / 40, 1 / 33, "file_inclination = 0.025 turns it upright"),
        (
            -1 / 40,
            1 / 40,
            "away from the track centre in the file, and its track inclines it by 1:40; "
            "mirror_y = True mirrors it, file_inclination = 0 confirms",
        ),
    ],
)
def test_a_head_that_leans_otherwise_is_refused_until_it_is_said(tmp_path, inclination, track, sentence):
    path = write(tmp_path, simpack(*inclined_rail(inclination), "rail"), "own.prr")
    with pytest.raises(ValueError, match=sentence):
        ContactSystem(rail=path, rail_inclination=track)
    assert "inclines it by" in sentence or ContactSystem(rail=path, rail_inclination=1 / 39)
    with pytest.raises(ValueError, match="in the file, without its track; "):
        Profile.from_file(path, "rail")
    assert pressure(ProfileFile(path, file_inclination=0.0), rail_inclination=track) > 0.0


def test_a_rail_is_used_as_it_stands_on_an_upright_track(tmp_path):
    path = write(tmp_path, simpack(*inclined_rail(1 / 40), "rail"), "own.prr")
    with pytest.warns(ProfileWarning, match="inclined by 1:40 .* in the file, and used so on this track"):
        ContactSystem(rail=path, rail_inclination=0.0)
    assert pressure(path, rail_inclination=0.0) == pytest.approx(pressure("UIC60"), rel=2e-3)


def test_an_inclined_rail_is_turned_upright(tmp_path):
    path = write(tmp_path, simpack(*inclined_rail(1 / 40), "rail"), "own.prr")
    profile, said = read_with(path, file_inclination=1 / 40)
    assert said == "" and error(profile) < 1e-3
    assert pressure(ProfileFile(path, file_inclination=1 / 40)) == pytest.approx(pressure("UIC60"), rel=2e-3)
    _, said = read_with(path, file_inclination=0.0)
    assert said == ""
    _, said = read_with(path, file_inclination=1 / 20)
    assert "its head is inclined by 1:40 towards the track centre, although file_inclination is 0.05" in said


def test_check_says_first_what_makes_all_results_wrong(tmp_path, run):
    path = write(tmp_path, simpack(*inclined_rail(1 / 40), "rail"), "own.prr")
    with pytest.warns(ProfileWarning, match="although file_inclination is 0.05"):
        system = ContactSystem(rail=ProfileFile(path, file_inclination=1 / 20))
    assert "although file_inclination is 0.05" in wrcontact.check(system).remarks[0]
    _, out, _ = run(
        "check", "--output", tmp_path / "own.png", "--rail", path, "--rail-file-inclination", "1:20"
    )
    lines = out.splitlines()
    assert "although --rail-file-inclination is 0.05" in lines[1] and out.count("although") == 1


# --- gauge side -----------------------------------------------------------------------------------


@pytest.mark.parametrize("shape", [inclined_rail(1 / 40), worn_rail()], ids=["inclined", "worn"])
def test_a_miniprof_rail_with_the_gauge_side_at_larger_y_is_mirrored(tmp_path, shape):
    y, z = shape
    one, said = read_with(write(tmp_path, miniprof(y, -z), "one.ban"), file_inclination=0.0)
    assert "mirrored" not in said
    other, said = read_with(write(tmp_path, miniprof(-y, -z), "other.ban"), file_inclination=0.0)
    assert "the gauge side was at the larger y (" in said and "; mirrored" in said
    at = np.linspace(-30.0, 20.0, 200) * MM
    np.testing.assert_allclose(other.height(at), one.height(at), atol=1e-9)


def test_a_text_rail_is_not_mirrored_but_reported(tmp_path):
    y, z = worn_rail()
    profile, said = read(tmp_path, columns(-y[::-1], z[::-1]), "rail")
    assert "the gauge side seems to be at the larger y (the corner there is wider by" in said
    assert profile.stop > 0.036
    path = tmp_path / "own.txt"
    mirrored, said = read_with(path, mirror_y=True)
    assert "gauge side" not in said and mirrored.start == pytest.approx(-profile.stop, abs=1e-4)
    assert "gauge side" not in read_with(path, mirror_y=False)[1]


#: Half-width of a head of our own [mm].
SIDE = 30.0


def head(y_top=0.0, wider=0.0):
    """y, z (n,) [mm] of a head that is 60 mm wide and 30 mm high: straight lines through its highest point at
    ``y_top`` and the corners 5 and 14 mm below it, of which the one at smaller y is ``wider`` by so much [mm]
    than the other."""
    corners = [
        (-SIDE - 1.0, 30.0),
        (-SIDE, 14.0),
        (-SIDE + 5.0 + wider, 5.0),
        (y_top, 0.0),
        (SIDE - 5.0, 5.0),
        (SIDE, 14.0),
        (SIDE + 1.0, 30.0),
    ]
    places = np.array(corners)
    y = np.arange(-SIDE - 1.0, SIDE + 1.0, 0.1)
    return y, np.interp(y, *places.T)


@pytest.mark.parametrize("wider, side", [(0.6, 0), (1.7, -1), (-0.6, 0), (-1.7, 1)])
def test_a_corner_that_is_wider_by_a_millimetre_is_the_gauge_s(wider, side):
    """Its width lies between the depths 5 and 14 mm."""
    found = head_of(*head(wider=wider))
    # means over 2 mm round the corners, by a tenth
    assert found.rounder == pytest.approx(wider, abs=0.2)
    assert _gauge_side(replace(found, scatter=1.0, aside=0.0))[0] == side


@pytest.mark.parametrize("y_top, side", [(1.4, 0), (2.8, -1), (-1.4, 0), (-2.8, 1)])
def test_the_highest_point_is_away_from_the_gauge_side(y_top, side):
    """Wear at the gauge corner moves it to the field side, by two millimetres and more."""
    found = head_of(*head(y_top=y_top))
    assert found.aside == pytest.approx(y_top, abs=0.2)
    assert _gauge_side(replace(found, scatter=1.0, rounder=0.0))[0] == side


def test_corner_and_highest_point_that_disagree_tell_nothing():
    found = head_of(*head(y_top=-2.8, wider=1.7))
    assert _gauge_side(replace(found, scatter=1.0)) == (0, "")
    agreeing = _gauge_side(replace(head_of(*head(y_top=2.8, wider=1.7)), scatter=1.0))
    assert agreeing[0] == -1 and "corner there is wider" in agreeing[1] and "highest point is" in agreeing[1]


def test_an_ambiguous_shape_is_reported(tmp_path):
    y, z = points("rail")
    z = z + 0.8 * np.exp(-(((y + 12.0) / 4.0) ** 2))
    _, said = read(tmp_path, miniprof(y, -z), "rail", "own.ban")
    assert "the gauge side cannot be found from the shape; the smaller y is used" in said
    assert "its head is not symmetric, so its shape does not show whether it is already inclined" in said


def test_a_new_upright_rail_says_nothing(tmp_path):
    for noise in (0.0, 0.02):
        y, z = inclined_rail(0.0, noise=noise)
        _, said = read(tmp_path, miniprof(y, -z), "rail", "own.ban")
        assert "gauge" not in said and "inclin" not in said


# --- options --------------------------------------------------------------------------------------


def test_points_are_shifted_rotated_and_mirrored(tmp_path):
    c, s = np.cos(0.02), np.sin(0.02)
    # undone in reverse order: mirror, rotate, shift
    y, z = -Y, -Z
    y, z = c * y + s * z, c * z - s * y
    path = write(tmp_path, columns(y + 3.0, z - 2.0), "own.txt")
    profile, said = read_with(path, "wheel", shift=(-3e-3, 2e-3), rotate=0.02, mirror_y=True, mirror_z=True)
    assert said == "the points ran from the largest y to the smallest; reversed" or said == ""
    assert error(profile) < 1e-4


def test_a_given_shift_replaces_the_one_from_the_shape(tmp_path):
    path = write(tmp_path, miniprof(Y + BACK + 2.0, 12.0 - Z), "own.whl")
    profile, _ = read_with(path, "wheel", shift=(-(BACK + 2.0) * MM, 0.0))
    assert error(profile) < 2e-4


@pytest.mark.parametrize(
    "options, sentence",
    [
        (dict(mirror_y="yes"), "mirror_y is 'yes'; permitted are True, False and None"),
        (dict(rotate=4.0), r"rotate is 4.0; permitted is -3.14159 \.\.\. 3.14159 rad"),
        (dict(shift=3.0), r"shift is 3.0; permitted are two numbers \(y, z\) in m"),
        (dict(shift=(3.0, 0.0)), r"shift in y is 3.0; permitted is -1 \.\.\. 1 m"),
        (dict(file_inclination=0.2), r"file_inclination is 0.2; permitted is 0 \.\.\. 0.1"),
        (
            dict(select=0),
            "select is 0; permitted are the number of a profile in the file, from 1, and its name",
        ),
        (dict(select=2), "contains one profile; select is 2 and cannot be given"),
    ],
)
def test_options_that_are_not_permitted_are_refused(tmp_path, options, sentence):
    path = write(tmp_path, columns(*points("rail")), "own.txt")
    with pytest.raises(ValueError, match=sentence):
        Profile.from_file(path, "rail", **options)


def test_a_wheel_has_no_inclination(tmp_path):
    path = write(tmp_path, columns(Y, Z), "own.txt")
    with pytest.raises(ValueError, match="is that of a wheel; file_inclination is 0.025; permitted is that"):
        Profile.from_file(path, "wheel", file_inclination=0.025)


def test_a_prepared_profile_takes_no_options(tmp_path):
    from wrcontact.profiles.files import prepared_text

    profile = Profile.from_file(write(tmp_path, columns(Y, Z), "own.txt"), "wheel")
    path = write(tmp_path, prepared_text(profile), "own.json")
    with pytest.raises(ValueError, match="is a prepared profile, which is not changed; mirror_y is True"):
        Profile.from_file(path, "wheel", mirror_y=True)


def test_the_command_line_takes_the_options(tmp_path, run):
    y, z = inclined_rail(1 / 40)
    path = write(tmp_path, columns(-y, z), "own.txt")
    code, _, said = run("solve", "--rail", path, "--rail-mirror-y", "--rail-file-inclination", "1:40")
    assert not code and said == ""
    for words, sentence in (
        (["--rail-mirror-y"], "--rail-mirror-y is given; it is permitted only with --rail FILE"),
        (
            ["--rail", path, "--rail-rotate-deg", "300"],
            "'300' is out of range; permitted is -180 ... 180 deg",
        ),
        (["--rail", path, "--rail-shift-mm", "3"], "'3' is not of the permitted form, two numbers Y,Z"),
        (
            ["--rail", path, "--rail-file-inclination", "1:5"],
            "'1:5' is out of range; permitted is 0 ... 1:10",
        ),
    ):
        code, _, said = run("solve", *words)
        assert code == 2 and sentence in said and said.count("\n") == 1
