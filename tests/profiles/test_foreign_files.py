"""Files of MiniProf, Vampire and GENSYS, lists of slices, and shapes that genuine files have."""

import re
import warnings

import numpy as np
import pytest

from tests.helpers.foreign_files import gensys, several, vampire, wavy_back, worn_rail
from tests.helpers.profile_points import MM, Y, Z, changed, columns, error, miniprof, points, read, simpack
from wrcontact import ContactSystem, Profile
from wrcontact.profiles import standard_profile
from wrcontact.wear.shape import wheel_shape

RAIL_Y, RAIL_Z = points("rail")


def write(folder, text, name):
    (folder / name).write_text(text)
    return folder / name


# --- several profiles -----------------------------------------------------------------------------


TWO = several([("first", RAIL_Y, -RAIL_Z), ("second", RAIL_Y[::2], -RAIL_Z[::2])])


@pytest.mark.parametrize(
    "select, count",
    [(1, len(RAIL_Y)), ("first", len(RAIL_Y)), ("2", len(RAIL_Y[::2])), ("second", len(RAIL_Y[::2]))],
)
def test_one_of_several_profiles_is_chosen_by_number_or_name(tmp_path, select, count):
    profile = Profile.from_file(write(tmp_path, TWO, "own.mpt"), "rail", select=select)
    assert profile.reading.points == count and error(profile) < 1e-3


@pytest.mark.parametrize(
    "select, sentence",
    [
        (None, r"contains 2 profiles \(1: first, 2: second\); select is None; permitted are a number or"),
        (3, r"contains 1: first, 2: second; select is 3; permitted are the numbers 1 \.\.\. 2 and names"),
        ("third", "contains 1: first, 2: second; select is 'third'"),
    ],
)
def test_a_choice_that_is_not_there_is_refused(tmp_path, select, sentence):
    for kind in ("wheel", "rail"):
        with pytest.raises(ValueError, match=sentence):
            Profile.from_file(write(tmp_path, TWO, "own.mpt"), kind, select=select)


def test_equal_names_are_chosen_by_number(tmp_path):
    text = several([("same", RAIL_Y, -RAIL_Z), ("same", RAIL_Y, -RAIL_Z)])
    with pytest.raises(ValueError, match="has that name more than once; select is 'same'"):
        Profile.from_file(write(tmp_path, text, "own.mpt"), "rail", select="same")
    assert Profile.from_file(write(tmp_path, text, "own.mpt"), "rail", select=2).reading.points == len(RAIL_Y)


def test_the_number_of_a_profile_may_have_two_digits(tmp_path):
    """Twelve profiles, each with one point fewer."""
    text = several([(f"p{k}", RAIL_Y[k:], -RAIL_Z[k:]) for k in range(12)])
    for number in (9, 10, 12):
        profile = Profile.from_file(write(tmp_path, text, "own.mpt"), "rail", select=number)
        assert profile.reading.points == len(RAIL_Y) - number + 1


def test_a_single_profile_needs_no_choice(tmp_path):
    profile, said = read(tmp_path, several([("one", RAIL_Y, -RAIL_Z)]), "rail", "own.mpt")
    assert error(profile) < 1e-3 and "lines" not in said


@pytest.mark.parametrize(
    "name, kind, sentence",
    [
        ("own.slcs", "rail", "ends in .slcs, a list of slices of a profile that varies along the rail;"),
        ("own.slcw", "wheel", "ends in .slcw, a list of slices of a profile that varies around the wheel;"),
    ],
)
def test_a_list_of_slices_is_refused_by_what_it_is(tmp_path, name, kind, sentence):
    with pytest.raises(ValueError, match=re.escape(sentence)):
        Profile.from_file(write(tmp_path, "1.0 'a.prr'\n2.0 'b.prr'\n", name), kind)


# --- Vampire and GENSYS ---------------------------------------------------------------------------


@pytest.mark.parametrize(
    "datum, shift",
    [("EUROPEAN", 0.0), ("CUSTOM 65.0", 5.0), ("us1", 70.0 - 72.23125), ("US2", 70.0 - 77.7875)],
)
def test_a_vampire_wheel_lies_at_its_tread_datum(tmp_path, datum, shift):
    text = vampire("wheel", Y - shift, Z, datum=datum)
    profile, said = read(tmp_path, text, "wheel", "own.whe")
    assert said == "" and error(profile) < 1e-3


@pytest.mark.parametrize("select", ["left", "right", None])
def test_a_vampire_rail_has_two_sides(tmp_path, select):
    other = RAIL_Z + 0.01 * (RAIL_Y + 40.0)
    left = (RAIL_Y, RAIL_Z) if select == "left" else (RAIL_Y, other)
    right = (RAIL_Y, other) if select == "left" else (RAIL_Y, RAIL_Z)
    path = write(tmp_path, vampire("rail", *right, left=left), "own.rai")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert error(Profile.from_file(path, "rail", select=select)) < 1e-3


@pytest.mark.parametrize(
    "change, sentence",
    [
        (("EUROPEAN", "MARTIAN"), r"has no tread datum in line 3 \('treaddatum martian'\); permitted are"),
        (
            ("FLANGEBACK", "BACK"),
            r"has no distance of the flange backs in line 4 \('back 1360.0'\); permitted",
        ),
        (("WHEELPROFILE", "RAILPROFILE"), "starts with RAILPROFILE; permitted are wheel profiles"),
        (("WHEELPROFILE", "PROFILE"), "starts with 'profile'; permitted are Vampire profiles, which start"),
    ],
)
def test_a_vampire_file_that_is_none_is_refused(tmp_path, change, sentence):
    with pytest.raises(ValueError, match=sentence):
        read(tmp_path, vampire("wheel", Y, Z).replace(*change), "wheel", "own.whe")


@pytest.mark.parametrize("kind, name", [("wheel", "own.wheel"), ("rail", "own.rail")])
def test_gensys_has_y_towards_the_track_centre(tmp_path, kind, name):
    y, z = points(kind)
    z = z + (np.where(y > 0, 1e-3 * y, 0.0) if kind == "wheel" else 0.0)
    profile, said = read(tmp_path, gensys(y, z), kind, name)
    assert "mirrored" not in said
    assert profile.stop == pytest.approx(y[-1] * MM, abs=1e-4)
    assert profile.height(40e-3 if kind == "wheel" else 20e-3) == pytest.approx(
        np.interp(40.0 if kind == "wheel" else 20.0, y, z) * MM, abs=1e-6
    )


# --- the running circle ---------------------------------------------------------------------------


@pytest.mark.parametrize("first", [0.05, 1.5, 7.0])
@pytest.mark.parametrize("side", [1, -1], ids=["flange first", "from the other side"])
def test_a_miniprof_wheel_counts_from_the_back_wherever_it_begins(tmp_path, first, side):
    kept = Y + 70.0 >= first
    text = miniprof(side * (Y[kept] + 70.0), 12.0 - Z[kept])
    profile, said = read(tmp_path, text, "wheel", "own.whl")
    assert said == "" and profile.start == pytest.approx((first - 70.0) * MM, abs=0.25 * MM)
    y = np.linspace(max(profile.start / MM + 0.5, -60.0), 55.0, 1001) * MM
    exact = standard_profile("S1002")
    assert np.abs(profile.height(y) - exact.height(y)).max() < 1e-6


def test_a_back_that_is_not_at_zero_is_reported(tmp_path):
    _, said = read(tmp_path, miniprof(Y + 73.0, 12.0 - Z), "wheel", "own.whl")
    assert "the back of its flange is at y = 3 mm" in said and "not at 0, where MiniProf has it" in said


def test_a_wheel_of_another_format_counts_from_its_back(tmp_path):
    """By points on the back, wherever it is; else y = 0 may be the back, which is told first."""
    profile, said = read(tmp_path, columns(Y + 100.0, Z))
    assert "from the back of the flange at y = 30" in said and error(profile) < 0.1
    kept = Y > -67.0
    profile, said = read(tmp_path, columns(Y[kept] + 70.0, Z[kept]))
    assert "taken to be at y = 0; y shifted by -70 mm" in said and error(profile) < 1e-3
    with pytest.raises(ValueError, match="or points on that back; shift = Y,Z moves y = 0"):
        read(tmp_path, columns(Y[kept] + 100.0, Z[kept]))


@pytest.mark.parametrize("first", [-70.0, -69.7, -68.0, -60.0, -50.0])
def test_the_thickness_of_a_flange_needs_its_back(tmp_path, first):
    """S1002 has 32.5 mm (EN 13715); without the back there is none."""
    kept = first <= Y
    profile, _ = read(tmp_path, columns(Y[kept], Z[kept]))
    shape = wheel_shape(profile)
    assert shape.flange_height == pytest.approx(28.0 * MM, abs=1e-6) or first > -55.0
    if first < -69.5:
        assert shape.flange_thickness == pytest.approx(32.5 * MM, abs=0.03 * MM)
    else:
        assert np.isnan(shape.flange_thickness)


# --- headers, lines, axes, gaps -------------------------------------------------------------------


@pytest.mark.parametrize("numbers", ["32.58 37.11 14.71", "32.58 37.11", "32.58 37.11 14.71 (Sd/Sh/qR)"])
def test_numbers_in_a_header_are_no_points(tmp_path, numbers):
    rows = columns(Y + 70.0, 12.0 - Z)
    profile, said = read(tmp_path, f"MINIPROF 2020\n{numbers}\n(Sd/Sh/qR)\n\n{rows}", "wheel", "own.whl")
    assert said == "" and profile.reading.points == len(Y) and error(profile) < 1e-3


@pytest.mark.parametrize("name, separator", [("own.txt", ";"), ("own.csv", ","), ("own.whl", ";")])
@pytest.mark.parametrize("empty", ["{y}{s}", "{s}{y}", "{y}"])
def test_a_line_with_an_empty_field_is_reported(tmp_path, name, separator, empty):
    lines = columns(Y + 70.0 * name.endswith("whl"), Z, separator).splitlines()
    for k in range(300, 400, 10):
        lines[k] = empty.format(y=lines[k].split(separator)[0], s=separator)
    profile, said = read(tmp_path, "\n".join(lines), "wheel", name)
    assert "10 lines without two numbers left out (line 301, 311, 321, ...)" in said
    assert profile.reading.points == len(Y) - 10


def test_a_line_with_an_empty_field_is_reported_in_a_vampire_file(tmp_path):
    text = vampire("wheel", Y, Z).splitlines()
    text[104] = text[104].rsplit(",", 1)[0]
    _, said = read(tmp_path, "\n".join(text), "wheel", "own.whe")
    assert "1 line without four numbers left out (line 105)" in said


def nose(width):
    """y, z (n,) [mm] of a narrow head of 30 mm, 15 mm high, on a flat base of this ``width``, z down."""
    y = np.arange(-15.0, 15.25 + width, 0.25)
    return y, 15.0 * np.minimum(np.abs(y) / 15.0, 1.0) ** 2


@pytest.mark.parametrize("width", [20.0, 40.0, 55.0])
@pytest.mark.parametrize("form", ["simpack", "columns", "vampire"])
def test_a_wide_base_does_not_turn_a_head_over(tmp_path, width, form):
    y, z = nose(width)
    text = {
        "simpack": lambda: simpack(y, z, "rail"),
        "columns": lambda: columns(y, z),
        "vampire": lambda: vampire("rail", y, z),
    }[form]()
    name = {"simpack": "own.prr", "columns": "own.txt", "vampire": "own.rai"}[form]
    profile, said = read(tmp_path, text, "rail", name)
    assert "sign" not in said and profile.height(-10.0 * MM) == pytest.approx(100.0 / 15.0 * MM, abs=5e-5)


def test_a_format_with_z_down_is_not_turned_over(tmp_path):
    path = write(tmp_path, simpack(RAIL_Y, -RAIL_Z, "rail"), "own.prr")
    with pytest.raises(
        ValueError, match="and its format has z down; mirror_z = True turns it over, mirror_z = F"
    ):
        Profile.from_file(path, "rail")
    assert error(Profile.from_file(path, "rail", mirror_z=True)) < 1e-3


def test_a_gap_below_the_gauge_is_cut(tmp_path):
    """The side is 1:20; behind the gap it stands 1.5 mm farther out, so that no straight line bridges it."""
    gauge_side = RAIL_Y < 0.0
    y = np.where(gauge_side & (RAIL_Z > 30.0), RAIL_Y - 1.5, RAIL_Y)
    kept = ~(gauge_side & (RAIL_Z > 17.0) & (RAIL_Z <= 30.0))
    profile, said = read(tmp_path, columns(y[kept], RAIL_Z[kept]), "rail")
    assert re.search(
        r"gap of 13.* mm from 1[67].* mm below the top on; the points behind it are left out", said
    ), said
    assert error(profile) < 1e-3 and profile.height(profile.start) == pytest.approx(17.0 * MM, abs=0.3 * MM)
    kept = ~(gauge_side & (RAIL_Z > 8.0) & (RAIL_Z <= 30.0))
    with pytest.raises(ValueError, match="a gap of 2.* mm; permitted are 10 mm or a straight stretch"):
        read(tmp_path, columns(y[kept], RAIL_Z[kept]), "rail")


def test_a_gap_beyond_the_rail_s_head_is_cut(tmp_path):
    z = Z + np.where(Y > 57.0, 3.0, 0.0)
    kept = (Y < 46.0) | (Y > 57.0)
    profile, said = read(tmp_path, columns(Y[kept], z[kept]))
    assert "mm from y = 45." in said and "on; the points behind it are left out" in said
    assert error_up_to(profile, 45.0) < 1e-3


def error_up_to(profile, last):
    """Largest difference in height from S1002 up to this y [mm]."""
    y = np.linspace(-60.0, last, 2001) * MM
    return np.max(np.abs(profile.height(y) - standard_profile("S1002").height(y))) / MM


def test_json_of_another_program_is_refused_by_what_it_is(tmp_path):
    for text in ('{"profile_role": "wheel", "lateral_meters": [0.0]}', "{}", '{"zones": []}'):
        with pytest.raises(
            ValueError, match="is JSON, but not a profile of wrcontact; permitted are points y and z"
        ):
            read(tmp_path, text, "wheel", "own.json")


@pytest.mark.parametrize("cut", [5.0, 20.0, 33.0])
@pytest.mark.parametrize("shape", [points("rail"), worn_rail()], ids=["new", "worn"])
def test_a_part_of_a_rail_is_no_wheel(tmp_path, cut, shape):
    y, z = shape
    with pytest.raises(
        ValueError, match="as part of a rail does; permitted are wheels with the tip of the flange"
    ):
        read(tmp_path, columns(y[y < cut], z[y < cut]))


# --- points that run back -------------------------------------------------------------------------


def run_back(place, back, apart=0.0):
    """S1002 whose points from ``place`` [mm] on have moved to smaller y by ``back``, and by ``apart`` in z."""
    behind = Y > place
    return np.where(behind, Y - back, Y), np.where(behind, np.interp(Y - back, Y, Z) + apart, Z)


@pytest.mark.parametrize(
    "place, back, apart, words",
    [
        (-54.0, 0.6, 0.2, r"6 points left out where the points run back by up to 0\.\d+ mm \(y = -54"),
        (-20.0, 0.7, 0.0, r"6 points sorted by y \(y = -20"),
        (10.0, 1.5, 0.0, r"14 points sorted by y"),
    ],
)
def test_points_that_run_back_cut_nothing(tmp_path, place, back, apart, words):
    profile, said = read(tmp_path, columns(*run_back(place, back, apart)))
    assert re.search(words, said), said
    assert profile.start == Y[0] * MM and error(profile) < apart + 0.01


def test_a_fold_behind_which_the_flange_is_lost_is_reported(tmp_path):
    """Points that run back by 3 mm are no stretch that was measured twice."""
    profile, said = read(tmp_path, columns(*run_back(-54.0, 3.0, 0.3)))
    assert re.search(
        r"vertical at y = -5\d.* mm; its points at smaller y, to -\d+.* mm, are left out", said
    ), said
    assert np.isnan(wheel_shape(profile).flange_thickness)


# --- shapes of genuine files ----------------------------------------------------------------------


@pytest.mark.parametrize("amplitude", [2e-3, 5e-3, 2e-2])
def test_a_flange_back_that_waves_is_no_reason_to_refuse(tmp_path, amplitude):
    y, z = wavy_back(amplitude)
    profile, _ = read(tmp_path, miniprof(y + 70.0, 12.0 - z), "wheel", "own.whl")
    inside = np.linspace(-54.0, 55.0, 500) * MM
    exact, _ = read(tmp_path, columns(Y, Z))
    np.testing.assert_allclose(profile.height(inside), exact.height(inside), atol=4e-3 * amplitude)
    assert ContactSystem(wheel=profile).evaluate(normal_force=78.5e3).status == 0


def test_a_top_near_the_end_of_the_points_is_used_and_reported(tmp_path):
    y, z = points("rail")
    keep = y < 6.0
    profile, said = read(tmp_path, columns(y[keep], z[keep]), "rail")
    assert "its highest point is 6 mm from the end of the points; there is no contact beyond it" in said
    exact, _ = read(tmp_path, columns(y, z), "rail")
    at = np.linspace(-30.0, 5.0, 100) * MM
    np.testing.assert_allclose(profile.height(at), exact.height(at), atol=1e-7)


def test_vertical_sides_give_no_warning(tmp_path):
    y, z = points("rail")
    head = np.abs(y) < 34.0
    deep = np.arange(9.0, 31.0, 0.1)
    y = np.r_[np.full(len(deep), -34.0), y[head], np.full(len(deep), 34.0)]
    z = np.r_[deep[::-1], z[head], deep]
    with warnings.catch_warnings():
        warnings.simplefilter("error", RuntimeWarning)
        profile = Profile.from_file(write(tmp_path, columns(y, z), "own.txt"), "rail")
    assert ContactSystem(rail=profile).evaluate(normal_force=78.5e3).status == 0


def test_a_gauge_face_that_recedes_is_taken_as_vertical(tmp_path):
    y, z = points("rail")
    recess = np.where((y < 0) & (z > 11.0), 0.15 * (z - 11.0), 0.0)
    profile, said = read(tmp_path, columns(y + recess, z), "rail")
    assert re.search(
        r"the gauge face recedes by 0\.\d+ mm from 1\d\.?\d* mm below the top on; it is taken", said
    )
    assert ContactSystem(rail=profile).evaluate(normal_force=78.5e3).status == 0


def test_an_outlier_of_several_repairs_stays_one_sentence(tmp_path):
    _, said = read(tmp_path, miniprof(Y + 70.0, 12.0 - changed(Z, [200], 0.5)), "wheel", "own.whl")
    assert "1 outlier of up to" in said and "\n" not in said
