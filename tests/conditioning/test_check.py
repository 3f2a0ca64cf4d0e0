"""The check of a pair: conicity, jumps, moves, conformal zones, quality, against closed forms and
independent searches."""

import csv
import dataclasses
import json
import math
from types import SimpleNamespace

import numpy as np
import pytest

import data
import wrcontact
from data import brute_force
from data.noisy_profiles import even_points, noisy_points
from tests.helpers.cases import MM
from wrcontact import ContactSystem, Profile
from wrcontact.cli.check import move_table
from wrcontact.conditioning import measures
from wrcontact.conditioning.conicity import OFF_PROFILE
from wrcontact.conditioning.table import table_text
from wrcontact.conditioning.text import check_text
from wrcontact.interface.units import by_name
from wrcontact.plots import check_figure
from wrcontact.profiles.zones import Polynomial


@pytest.fixture(scope="module")
def uic60():
    return wrcontact.check(ContactSystem())


# --- jumps and moves ------------------------------------------------------------------------------


def test_jumps_are_where_the_brute_force_search_has_them(uic60):
    """data/find_jumps.py on UIC60 1:40 [mm]; the printed S1002 has steps."""
    right = [jump for jump in uic60.jumps if jump.side == "right"]
    for expected in (4.847933, 6.251818):
        assert min(abs(jump.lateral_shift / MM - expected) for jump in right) < 3e-4
    left = [jump for jump in uic60.jumps if jump.side == "left"]
    assert len(left) == len(right) >= 3
    assert uic60.nearest_jump == pytest.approx(min(jump.lateral_shift for jump in right))
    middle = len(uic60.curves.lateral_shift) // 2
    assert uic60.curves.jump_distance[middle] == uic60.nearest_jump
    told = next(remark for remark in uic60.remarks if "centred position" in remark)
    assert "jumps 0.21 mm" in told and "2.2 to -8.0 mm on the right wheel" in told


def test_the_printed_distance_to_the_next_jump_is_in_millimetres(uic60):
    """Of data/find_jumps.py, too."""
    columns = {
        str(column.header).split("\n")[0]: list(column.cells) for column in move_table(uic60.curves).columns
    }
    printed = dict(zip(columns["shift"], columns["next jump"]))
    for shift, jump in ((4, 4.847933), (5, 4.847933), (6, 6.251818), (7, 6.251818), (8, 6.251818)):
        assert float(printed[str(shift)]) == pytest.approx(abs(shift - jump), abs=0.006), shift


def test_two_places_touch_at_a_jump(uic60):
    """Both have the same gap, straight from the printed profiles, at the jump's own shift and roll."""
    track = brute_force.track("UIC60", 1 / 40)
    for jump in uic60.jumps:
        pose = brute_force.Pose(
            jump.lateral_shift, 0.0, ContactSystem().evaluate(lateral_shift=jump.lateral_shift).roll
        )
        pose = pose if jump.side == "right" else pose.mirrored()
        places = np.array([jump.before, jump.after])
        gaps = brute_force.vertical_gap(track, pose, np.zeros(2), places)[0]
        # [m] S1002's printed joints have steps of 1.2e-7
        assert gaps[0] == pytest.approx(gaps[1], abs=2e-7), jump
        across = brute_force.wheel_surface(track, pose, np.zeros(2), places)[0][1] - track.rail_origin
        np.testing.assert_allclose([jump.rail_before, jump.rail_after], across, atol=1e-6, err_msg=str(jump))


def test_moves_add_up_to_the_reference_positions(uic60):
    """Between 1 and 3 mm the contacts do not jump: the integrals of the rates are the
    published differences."""
    rows = {
        row["lateral_shift_mm"]: row
        for row in data.rows_of(data.FOLDER / "rigid_positions.csv")
        if row["yaw_deg"] == 0.0
    }
    curves = uic60.curves
    between = (curves.lateral_shift > 0.999 * MM) & (curves.lateral_shift < 3.001 * MM)
    rates = {
        "roll_rad": (curves.roll_rate, 1.0),
        "R_y_wheel_mm": (curves.right.wheel_rate, MM),
        "L_y_wheel_mm": (curves.left.wheel_rate, MM),
    }
    for name, (rate, unit) in rates.items():
        mean = 0.5 * (rate[between][1:] + rate[between][:-1])
        total = np.sum(mean * np.diff(curves.lateral_shift[between]))
        # the trapezoidal rule at 0.05 mm leaves 1e-5 of it
        assert total == pytest.approx((rows[3][name] - rows[1][name]) * unit, rel=1e-4), name


def test_left_is_the_mirror_of_right(uic60):
    curves = uic60.curves
    for field in dataclasses.fields(curves.left):
        left, right = (getattr(side, field.name) for side in (curves.left, curves.right))
        sign = -1 if field.name.endswith("_rate") else 1
        if field.name == "near_width" or field.name == "near_turn":
            np.testing.assert_allclose(left, right[::-1], atol=1e-9)
        else:
            np.testing.assert_allclose(left, sign * right[::-1], rtol=1e-5, atol=1e-7, err_msg=field.name)


def test_a_check_has_the_same_bits_again(uic60):
    """Threads that shared long tables decided last digits by which of them was first."""
    assert check_text(wrcontact.check(ContactSystem())) == check_text(uic60)


# --- the table over the lateral shift -------------------------------------------------------------


def test_the_table_of_a_cone_has_closed_forms():
    """Cones of 1:20 at zero roll: a shift of y changes each rolling radius by y / 20 and the conicity is 1 / 20;
    roll turns both contact angles by as much, one up and one down."""
    text = table_text(wrcontact.check(ContactSystem("cone20")))
    comments = [line for line in text.splitlines() if line.startswith("#")]
    assert comments[0].startswith("# cone20 on UIC60: gauge 1435 mm, inclination 1:40") and len(comments) == 8
    heads, *rows = csv.reader(line for line in text.splitlines() if not line.startswith("#"))
    read = dict(zip(heads, np.array([[float(cell or "nan") for cell in row] for row in rows]).T))
    shift = read["lateral_shift [mm]"]
    assert len(shift) > 300 and np.max(np.abs(np.diff(shift) - 0.05)) < 1e-9
    np.testing.assert_allclose(read["level_radius_difference [mm]"], shift / 10, atol=1e-6)
    inside = (np.abs(shift) > 0.01) & (np.abs(shift) < 14)
    np.testing.assert_allclose(read["conicity [1]"][inside], 1 / 20, rtol=2e-6)
    assert np.isnan(read["conicity [1]"][shift == 0.0])
    slope = math.degrees(math.atan(1 / 20))
    for side, sign in (("right", 1.0), ("left", -1.0)):
        angle = read[f"{side}.contact_angle [deg]"]
        np.testing.assert_allclose(angle, slope - sign * read["roll [deg]"], atol=1e-6)
        y, radius = read[f"{side}.contact.y_wheel [mm]"], read[f"{side}.rolling_radius [mm]"]
        np.testing.assert_allclose(radius, 460 - y / 20, atol=1e-6)
    difference = read["right.rolling_radius [mm]"] - read["left.rolling_radius [mm]"]
    np.testing.assert_allclose(difference, read["radius_difference [mm]"], atol=1e-6)
    tangents = [np.tan(np.radians(read[f"{side}.contact_angle [deg]"])) for side in ("right", "left")]
    np.testing.assert_allclose(read["delta_tan_gamma [1]"], tangents[0] - tangents[1], atol=1e-8)
    # Redtenbacher: along a curve of radius r e / (difference of the radii), to the left if the right wheel is larger
    apart = 1.5 + 1e-3 * (read["right.contact.y_wheel [mm]"] + read["left.contact.y_wheel [mm]"])
    mean = 0.5e-3 * (read["right.rolling_radius [mm]"] + read["left.rolling_radius [mm]"])
    np.testing.assert_allclose(
        read["free_curvature [1/m]"], -1e-3 * difference / (mean * apart), rtol=1e-3, atol=1e-9
    )


def test_a_cell_without_a_value_is_empty(uic60):
    """The rolling radius difference of the outermost shifts has no oscillation around it."""
    last = table_text(uic60).splitlines()[-1]
    assert last.startswith("15,") and last.endswith(",,")


def test_a_wheelset_rolls_freely_in_the_curve_of_its_place(uic60):
    """Both wheels touch without longitudinal creepage where the track bends as much, and only there."""
    curves = uic60.curves
    system = ContactSystem(tangential_model="fastsim", normal_model="hertz")
    for shift in (-5.5e-3, -2e-3, 1e-3, 5.5e-3):
        at = int(np.argmin(np.abs(curves.lateral_shift - shift)))
        bend = float(curves.free_curvature[at])
        assert bend * shift < 0.0
        for curvature, free in ((bend, True), (0.0, False)):
            state = system.evaluate(shift, speed=10.0, track_curvature=curvature)
            slip = state.right.patches[0].creepage.x - state.left.patches[0].creepage.x
            assert abs(slip) < 1e-7 if free else abs(slip) > 1e-3, (shift, curvature, slip)


@pytest.mark.full  # README's command installs none of the tables' packages
def test_a_check_as_a_frame(uic60):
    pytest.importorskip("pandas")
    frame = uic60.to_pandas()
    at = frame.index[np.isclose(frame["lateral_shift"], 3e-3)][0]
    state = ContactSystem().evaluate(lateral_shift=3e-3)
    for name in (
        "right.contact.y_wheel",
        "left.contact.y_rail",
        "right.contact_angle",
        "left.rolling_radius",
    ):
        assert frame[name][at] == pytest.approx(state[name], abs=1e-12), name
    assert frame["conicity"][at] == pytest.approx(uic60.conicity.level[2], rel=1e-9)
    assert frame["rolled_conicity"][at] == pytest.approx(uic60.conicity.rolled[2], rel=1e-9)


# --- profiles, ranges, files ----------------------------------------------------------------------


def wheel_file(folder, y, z, name="own.txt"):
    path = folder / name
    np.savetxt(path, np.column_stack([y, z]), fmt="%.9f")
    return path


def hollow(y, z, depth):
    """The wheel's points with a groove of this depth [mm] worn into the tread."""
    return z - depth * np.exp(-((y / 14.0) ** 2))


def test_points_are_reported(tmp_path):
    y, z = noisy_points("wheel", 0.2, 10e-3, 5)
    z[300] += 0.8
    with pytest.warns(wrcontact.ProfileWarning):
        report = wrcontact.check(ContactSystem(wheel=wheel_file(tmp_path, y, z), rail="60E1"))
    reading = report.wheel.reading
    # the outlier, and what the noise made turn back at the vertical back of the flange
    assert len(y) - 5 < reading.points < len(y) and reading.spacing == pytest.approx(0.2 * MM, rel=0.05)
    # scatters by 2 to 6 %
    assert reading.noise == pytest.approx(10e-6, rel=0.15) and reading.smoothing == reading.noise
    remarks = [remark for remark in report.remarks if remark.startswith("wheel profile own")]
    assert any("1 outlier" in remark for remark in remarks)
    assert any("noise of" in remark for remark in remarks)
    assert report.rail.reading is None and report.wheel.roughness < 1.0  # [1/m]
    assert report.conicity.level[2] == pytest.approx(0.174, abs=0.02)  # noise of 10 um moves it by 5 %


@pytest.mark.full
def test_noise_that_is_not_smoothed_is_reported(tmp_path):
    """10 um every 0.2 mm are curvatures of 10 um / (0.2 mm)^2 = 250 1/m and more; the
    conicity averages them away."""
    wheel = Profile.from_file(
        wheel_file(tmp_path, *noisy_points("wheel", 0.2, 10e-3, 1)), "wheel", smoothing=0.0
    )
    rail = Profile.from_file(
        wheel_file(tmp_path, *noisy_points("rail", 0.2, 10e-3, 2)), "rail", smoothing=0.0
    )
    report = wrcontact.check(ContactSystem(wheel, rail))
    assert report.wheel.roughness > 100 and report.rail.roughness > 100  # [1/m]
    assert any("follows noise" in remark for remark in report.remarks)
    assert any(remark.startswith("the right contact jumps") for remark in report.remarks)
    assert report.conicity.level[2] == pytest.approx(0.180, abs=0.01)


@pytest.mark.parametrize("depth", [1.0, 3.0])
def test_hollow_wear_raises_the_conicity(tmp_path, depth):
    """Contact stays on the groove's shoulders, 15 to 25 mm off the running circle: one jumps
    near the centred position."""
    y, z = even_points("wheel", 0.5)
    report = wrcontact.check(ContactSystem(wheel=wheel_file(tmp_path, y, hollow(y, z, depth)), rail="60E1"))
    assert report.usable and 0.0 < report.nearest_jump < 1 * MM
    nearest = min(report.jumps, key=lambda jump: abs(jump.lateral_shift))
    assert abs(nearest.after - nearest.before) > 25 * MM
    assert np.all(report.conicity.level[:3] > 1.5 * np.array([0.354, 0.219, 0.174]))


def test_kink_is_reported():
    halves = Polynomial(-70, -9, (-0.045, -0.055), -9.0), Polynomial(-9, 60, (-0.045, -0.05), -9.0)
    wheel = Profile("bent", "wheel", halves, smooth=False)
    report = wrcontact.check(ContactSystem(wheel))
    ((y, turn),) = report.wheel.kinks
    assert y == pytest.approx(-9 * MM) and turn == pytest.approx(5e-3, rel=0.01)
    assert any("kink of 5.0 mrad at y = -9.0 mm" in remark for remark in report.remarks)


def test_curvature_steps_are_those_of_the_standard(uic60):
    """From the straight flank, 1 / 13 mm; R13 against R80 on the head."""
    assert uic60.wheel.curvature_step == pytest.approx(1 / 13e-3, rel=1e-9)
    assert uic60.rail.curvature_step == pytest.approx(1 / 13e-3 - 1 / 80e-3, rel=1e-9)
    assert uic60.wheel.kinks == () == uic60.rail.kinks


def short_wheel(stop):
    """S1002 that ends ``stop`` [mm] beyond its running circle."""
    y, z = even_points("wheel", 0.5)
    inside = (y > -60) & (y < stop)
    return Profile.from_points(y[inside], z[inside], name="short", kind="wheel")


def test_a_contact_beyond_the_end_of_a_wheel_is_none():
    """Followed from the last pose, a minimum of the gap ran past the end of the wheel and was called valid:
    S1002 that ends at 8 mm on 60E1, lateral shift 5 mm, touched with y_wheel = 13.3 mm on the left."""
    system = ContactSystem(short_wheel(8.0), "60E1")
    shifts = np.linspace(-8, 8, 161) * MM
    for order in (shifts, shifts[::-1]):  # the search starts where the last one ended
        table = system.evaluate_many(lateral_shift=order, outputs="geometry")
        valid = np.asarray(table.status) <= 1
        for side in (table.left, table.right):
            assert np.all(side.contact.y_wheel[valid] <= system.wheel.stop)
        assert np.array_equal(valid, valid[::-1])
    assert system.evaluate(lateral_shift=5 * MM).status == wrcontact.Status.OFF_PROFILE
    assert system.evaluate(lateral_shift=-5 * MM).status == wrcontact.Status.OFF_PROFILE


def test_ends_of_the_profiles_are_reported():
    report = wrcontact.check(ContactSystem(short_wheel(8.0), "60E1"))
    first, last = report.usable_shifts
    assert -first == pytest.approx(last, abs=2e-6) and 1 * MM < last < 3 * MM and report.usable
    # the left contact is at the end of the wheel there
    state = report.system.evaluate(lateral_shift=last, outputs="geometry")
    assert state.left.contact.y_wheel == pytest.approx(report.system.wheel.stop, abs=0.02 * MM)
    assert any("leaves the profiles beyond" in remark for remark in report.remarks)
    assert np.isnan(report.conicity.level[3:]).all()
    assert set(report.conicity.level_reason[3:]) == {OFF_PROFILE}
    assert math.isfinite(report.conicity.level[0])


def test_flange_contact_is_reported():
    """10 mm less gauge is 5 mm less play."""
    wide, narrow = (wrcontact.check(ContactSystem(rail="60E1", gauge=gauge)) for gauge in (1.435, 1.425))
    # the other side rolls with it
    assert wide.flange_shift - narrow.flange_shift == pytest.approx(5 * MM, abs=0.15 * MM)
    assert any("flange touches from 1.3" in remark for remark in narrow.remarks)
    assert not any("flange" in remark for remark in wide.remarks)
    none = wrcontact.check(ContactSystem(rail="60E1", gauge=1.419))
    assert none.flange_shift == 0.0
    assert "a flange is in contact already in the centred position" in none.remarks


def test_pair_without_contact_is_reported():
    report = wrcontact.check(ContactSystem(gauge=1.6))
    assert not report.usable and math.isnan(report.usable_shifts[0]) and report.jumps == ()
    assert report.remarks[0].startswith("there is no contact in the centred position")
    assert np.isnan(report.conicity.level).all() and report.conicity_curves["level"] is None


# --- the door -------------------------------------------------------------------------------------


def test_what_is_no_system_is_refused():
    with pytest.raises(ValueError, match="system is 'S1002'; permitted is a ContactSystem"):
        wrcontact.check("S1002")


@pytest.mark.full
def test_command(run, tmp_path, standard):
    picture, content, table = (tmp_path / f"pair.{ending}" for ending in ("png", "json", "csv"))
    code, out, err = run("check", "--rail", "60E1", "--output", picture, "--json", content, "--table", table)
    assert code == 0 and err == ""
    for text in (
        "S1002 on 60E1: gauge 1435 mm, inclination 1:40",
        "contact at lateral shifts from -15.00 to 15.00 mm",
        "0.174",
        "0.2259",
        "contact jumps 0.23 mm from the centred position",
        f"picture written to {picture}",
    ):
        assert text in out
    assert picture.stat().st_size > 50_000
    assert out.endswith(f"table written to {table}\n") and table.read_text() == table_text(standard)
    read = json.loads(content.read_text(encoding="utf-8"))
    assert set(read) == {field.name for field in dataclasses.fields(standard)}
    assert read["conicity"]["level"] == standard.conicity.level.tolist()
    assert read["system"]["gauge"] == 1.435 and len(read["jumps"]) == len(standard.jumps)


def test_command_refuses_in_a_sentence(run, tmp_path):
    for words, told in (
        (("--output", tmp_path / "pair.doc"), ".png"),
        (("--wheel", "S1003"), "S1003"),
        (("--gauge-mm", "3000"), "gauge"),
        (("--load", "normal"), "--load"),
        (("--table", tmp_path / "pair.txt"), "pair.txt'; permitted is a file that ends in .csv"),
        (
            ("--table", tmp_path / "a.csv", "--batch", "S1002", "60E1"),
            "--table is given; it is permitted only without",
        ),
    ):
        code, _, err = run("check", *words)
        assert code == 2 and err.startswith("wrcontact: ") and err.count("\n") == 1 and told in err


@pytest.mark.full
def test_command_tells_a_useless_pair(run, tmp_path):
    code, out, _ = run("check", "--gauge-mm", "1600", "--output", tmp_path / "none.svg")
    assert (tmp_path / "none.svg").stat().st_size > 10_000
    assert code == 1 and "no contact in the centred position" in out and "nan" not in out


# --- the picture ----------------------------------------------------------------------------------


def test_picture_draws_the_numbers(standard):
    figure = check_figure(standard)
    panels = {axes.get_label(): axes for axes in figure.axes}
    dots = [line for line in panels["conicity"].lines if line.get_marker() == "o"]
    np.testing.assert_array_equal(dots[1].get_ydata(), standard.conicity.level)
    marks = sorted(line.get_xdata()[0] for line in panels["moves"].lines if line.get_gid() == "right jump")
    np.testing.assert_allclose(marks, [0.2259, 4.9918, 6.2597], atol=1e-3)
    curve = panels["moves"].lines[0]
    x, y = curve.get_xdata(), curve.get_ydata()
    assert all(np.isnan(y[np.argmin(abs(x - mark))]) for mark in (0.225917, 4.991808))
    right = next(line for line in panels["angles"].lines if line.get_label() == "right")
    x, y = right.get_xdata(), right.get_ydata()
    for shift in (-4.0, 2.0):  # [mm]
        state = ContactSystem(rail="60E1").evaluate(lateral_shift=shift * MM)
        assert y[np.argmin(abs(x - shift))] == pytest.approx(
            math.degrees(state.right.contact_angle), abs=1e-9
        )
    spans = [patch for patch in panels["near"].patches if patch.get_gid() == "conformal"]
    assert len(spans) == sum(zone.side == "right" for zone in standard.conformal)
    # lines join places that touch: at their lower ends the rail has the height it is drawn with
    places = panels["places"]
    assert len([line for line in places.lines if len(line.get_xdata()) == 2]) == 65 + 2 * 3


# --- the table of numbers --------------------------------------------------------------------------


def test_numbers_are_shown_in_the_unit_that_is_named():
    """By a table of units that is written here; a name stands for the attribute that has it."""
    sizes = {"": 1, "1/m": 1, "m": 1, "mm": 1e3, "um": 1e6, "deg": 180 / np.pi, "mm/mm": 1, "mrad/mm": 1}
    tables = (
        measures.MOVES,
        measures.QUALITIES,
        measures.READINGS,
        measures.JUMPS,
        measures.ZONES,
        measures.CONICITIES,
        measures.PAIR,
    )
    for table in tables:
        for name, one in table.items():
            assert one.factor == pytest.approx(sizes[one.shown_unit]), name
    zone = SimpleNamespace(**{name: 0.5 + k for k, name in enumerate(measures.ZONES)})
    jump = SimpleNamespace(**{name: 0.5 + k for k, name in enumerate(measures.JUMPS)})
    for owner, table in ((zone, measures.ZONES), (jump, measures.JUMPS)):
        assert [one.read(owner) for one in table.values()] == list(vars(owner).values())
    curves = SimpleNamespace(**{name: name for name in measures.MOVES})
    curves.right = SimpleNamespace(**{name: f"right {name}" for name in measures.MOVES})
    assert [one.read(curves, "right").removeprefix("right ") for one in measures.MOVES.values()] == [
        *measures.MOVES
    ]
    with pytest.raises(ValueError, match="measure 'start' is declared twice"):
        by_name(measures.ZONES["start"], measures.QUALITIES["start"])
