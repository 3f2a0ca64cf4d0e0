"""The check of a pair: conicity, jumps, moves, conformal zones, quality, against closed forms and independent searches."""

import csv
import dataclasses
import json
import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import wrcontact
from benchmarks.profile_noise import even_points, noisy_points
from wrcontact import ContactSystem, Profile
from wrcontact.cli import main
from wrcontact.conditioning import equivalent_conicity
from wrcontact.conditioning.conformal import NEAR
from wrcontact.conditioning.conicity import NO_RETURN, OFF_PROFILE, Swing
from wrcontact.plots import check_figure
from wrcontact.profiles.zones import Arc, Polynomial

from tests.reference import brute_force
from tests.helpers.paths import REFERENCE_DATA

MM = 1e-3
AMPLITUDES = np.arange(1, 9) * MM


@pytest.fixture(scope="module")
def standard():
    """The check of the pair and set-up that EN 15302 has a reference value for."""
    return wrcontact.check(ContactSystem(rail="60E1"))


@pytest.fixture(scope="module")
def uic60():
    return wrcontact.check(ContactSystem())


# --- equivalent conicity of given rolling radius differences ---------------------------------------


def half_wave_in_time(shift, difference, start):
    """Half a wave [m] of y'' = -delta_r(y) from a turning point, by integrating the motion until the next one."""

    def turns(_, state):
        return state[1]

    turns.terminal, turns.direction = True, -1.0 if start < 0.0 else 1.0
    nudge = 1e-9 * abs(start)       # off the turning point at which the integration starts
    rate = -np.interp(start, shift, difference)
    first = math.sqrt(2 * nudge / abs(rate))
    # steps short enough to see a jump, which spans 2e-9 m in the curves
    found = solve_ivp(lambda _, state: [state[1], -np.interp(state[0], shift, difference)], (first, 1e6),
                      [start + math.copysign(nudge, rate), rate * first], events=turns, rtol=1e-9, atol=1e-13, max_step=0.05)
    return found.t_events[0][0]


def test_cone():
    shift = np.linspace(-10, 10, 7) * MM
    np.testing.assert_allclose(equivalent_conicity(shift, 2 * 0.05 * shift, AMPLITUDES), 0.05, rtol=1e-9)


def test_constant_difference_thrown_over_in_the_middle():
    """delta_r = c sign(y): each quarter wave is a fall over the amplitude, sqrt(2 A / c)."""
    c, shift = 0.5 * MM, np.array([-10, -1e-9, 1e-9, 10]) * MM
    expected = np.pi**2 * c / (16 * AMPLITUDES)
    np.testing.assert_allclose(equivalent_conicity(shift, [-c, -c, c, c], AMPLITUDES), expected, rtol=1e-6)


def test_cones_with_a_clearance_between_them():
    """Nothing turns the wheelset within +-2 mm, a cone of 0.1 beyond: it crosses the clearance as fast as it comes."""
    free, cone = 2 * MM, 0.1
    shift = np.array([-10 * MM, -free, free, 10 * MM])
    difference = np.array([-2 * cone * (10 * MM - free), 0, 0, 2 * cone * (10 * MM - free)])
    amplitude = AMPLITUDES[3:]
    rate = math.sqrt(2 * cone)
    half = np.pi / rate + 2 * free / (rate * (amplitude - free))
    np.testing.assert_allclose(equivalent_conicity(shift, difference, amplitude), 0.5 * (np.pi / half) ** 2, rtol=1e-5)
    value, middle, reason = Swing(shift, difference).conicity(1 * MM)
    assert (value, middle, reason) == (0.0, 0.0, "")       # no wave, as on a cylinder


def test_another_left_and_right_wheel_and_a_jump():
    """Against the motion itself, step by step; the turning points are no more the same left and right."""
    shift = np.concatenate([np.linspace(-12, 3, 301), [3 + 1e-6], np.linspace(3.05, 12, 180)]) * MM
    difference = (0.2 * (shift - 0.7 * MM) + 40 * (shift - 0.7 * MM) ** 2 * np.sign(shift)
                  + np.where(shift > 3.0000005 * MM, 1.5 * MM, 0.0))
    for amplitude in (1 * MM, 3 * MM, 6 * MM):
        value, middle, reason = Swing(shift, difference).conicity(amplitude)
        assert reason == "" and abs(middle) > 0.1 * MM, amplitude
        half = half_wave_in_time(shift, difference, middle - amplitude)
        assert value == pytest.approx(0.5 * (np.pi / half) ** 2, rel=2e-5), amplitude


def test_swing_beside_a_middle_that_drives_out():
    """delta_r = k (y^3 / a^2 - y) rests at +-a, where it rises by 2 k: small swings there have tan(gamma) = k."""
    k, a = 0.05, 3 * MM
    shift = np.linspace(-10, 10, 4001) * MM
    swing = Swing(shift, k * (shift**3 / a**2 - shift))
    value, middle, _ = swing.conicity(0.05 * MM)
    assert abs(middle) == pytest.approx(a, rel=1e-3) and value == pytest.approx(k, rel=1e-3)
    # from sqrt(2) a on it swings over the middle; in between there is no swing
    assert swing.conicity(3.5 * MM)[2] == NO_RETURN
    assert swing.conicity(4.5 * MM)[1] == pytest.approx(0.0, abs=1e-9)
    assert Swing(shift, -k * shift).conicity(1 * MM)[2] == NO_RETURN
    assert Swing(shift, k * shift).conicity(11 * MM)[2] == OFF_PROFILE


@pytest.mark.parametrize("shift, difference, amplitude, told", [
    ([0, 1, 2], [0, 1], 1, "lateral_shift has shape (3,) and radius_difference (2,)"),
    ([0, 2, 1], [0, 1, 2], 1, "does not rise"),
    ([0, 1, 2], [0, math.nan, 2], 1, "not finite"),
    ([0, 1, 2], [0, 1, 2], 0.0, "amplitude is 0.0; permitted is amplitude > 0 m"),
])
def test_bad_curves_are_refused(shift, difference, amplitude, told):
    with pytest.raises(ValueError) as refusal:
        equivalent_conicity(shift, difference, amplitude)
    assert told in str(refusal.value)


# --- equivalent conicity of pairs ------------------------------------------------------------------


def test_reference_value_of_the_standard(standard):
    """EN 15302: S1002 on 60E1 1:40, gauge 1435 mm, without roll, at 3 mm."""
    assert standard.conicity.level[2] == pytest.approx(0.174, abs=0.003)


def test_conicity_from_a_search_of_its_own(standard):
    """S1002 and 60E1 as printed, each side's smallest vertical gap of a level wheelset on a grid, and the motion itself."""
    track = brute_force.track("60E1", 1 / 40)
    y = np.arange(-36, 26, 0.01) * MM
    height = track.wheel(y)[0]
    shift = np.arange(-6, 6.01, 0.02) * MM
    ground = np.arange(-60, 60, 0.005) * MM
    head = track.rail(ground)[0]
    at = [np.argmin(np.interp(track.half_distance + y + one - track.rail_origin, ground, head) - height) for one in shift]
    difference = height[at] - height[at][::-1]
    # a contact is found to 5 um, on treads of slope 0.1: 0.5 um of 0.5 mm, averaged over a swing
    for amplitude in (2, 3, 5):
        half = half_wave_in_time(shift, difference, -amplitude * MM)
        expected = 0.5 * (np.pi / half) ** 2
        assert standard.conicity.level[amplitude - 1] == pytest.approx(expected, rel=2e-3), amplitude


def test_wavelength_is_klingels(standard):
    conicity = standard.conicity
    klingel = 2 * np.pi * np.sqrt(1.5 * 0.46 / (2 * conicity.level))
    np.testing.assert_allclose(conicity.wavelength, klingel, rtol=1e-12)
    assert conicity.nonlinearity == pytest.approx((conicity.level[3] - conicity.level[1]) / 2e-3)


def cone_wheel(slope):
    return Profile("cone", "wheel", (Polynomial(-70, 60, (0.0, -slope)),))


@pytest.mark.parametrize("rail", ["UIC60", "54E1"])
def test_conical_wheel_has_its_cone(rail):
    """Without roll a cone keeps touching the same place of the rail.

    With roll, slope / arm of the shift, the place moves on the head, R 300 mm here, and the wheel turns about its axle: by
    (R + r0) slope / arm in all, which makes the cone look steeper.
    """
    report = wrcontact.check(ContactSystem(wheel=cone_wheel(0.05), rail=rail))
    np.testing.assert_allclose(report.conicity.level, 0.05, rtol=1e-6)
    steeper = 0.05 / (1.0 - 0.05 * (0.30 + 0.46) / 0.75)
    np.testing.assert_allclose(report.conicity.rolled, steeper, rtol=2e-3)     # slopes squared, and the arm to the contact
    assert report.jumps == () and report.nearest_jump == math.inf and report.flange_shift == math.inf
    assert report.usable and not any("jump" in remark for remark in report.remarks)


#: Radii [m] of a hollow wheel on a rail head, both of one arc, and the slope at which they touch in the centred position.
HOLLOW, HEAD, SLOPE = 0.33, 0.30, 0.05


@pytest.fixture(scope="module")
def arcs():
    """The check of arc on arc, for which a level wheelset has closed forms."""
    sine = SLOPE / math.hypot(1.0, SLOPE)
    y_centre = 1e3 * HOLLOW * sine
    wheel = Profile("hollow", "wheel", (Arc(-45, 45, 1e3 * HOLLOW, y_centre, math.sqrt(1e6 * HOLLOW**2 - y_centre**2), -1),))
    rail = Profile("head", "rail", (Arc(-68, 68, 1e3 * HEAD, 0.0, 1e3 * HEAD, -1),))
    depth = 5e-3
    # the rail's place of that slope lies under the running circle
    top = 0.75 + HEAD * sine
    gauge = 2 * (top - math.sqrt(HEAD**2 - (HEAD - depth) ** 2))
    return wrcontact.check(ContactSystem(wheel, rail, rail_inclination=0.0, gauge=gauge, gauge_depth=depth))


def test_arc_on_arc_has_its_closed_form(arcs):
    """tan(gamma) = slope R_w / (R_w - R_r) for small amplitudes, and the curve rises with y as the slope does."""
    value = equivalent_conicity(*arcs.conicity_curves["level"], [0.1 * MM])[0]
    assert value == pytest.approx(SLOPE * HOLLOW / (HOLLOW - HEAD), rel=0.02)       # the slope's square counts for 1 %
    assert value == pytest.approx(0.55, rel=0.02)


def test_moves_on_arcs(arcs):
    """Of a level wheelset the places of equal slope move by R_w / (R_w - R_r) = 11 per shift on the wheel, by
    R_r / (R_w - R_r) on the rail; roll turns the wheel against the rail, as a shift of (R_r + r0) roll does."""
    middle = len(arcs.curves.lateral_shift) // 2
    side = arcs.curves.right
    assert side.y_wheel[middle] == pytest.approx(0.0, abs=1e-6)
    assert side.contact_angle[middle] == pytest.approx(SLOPE, rel=1e-2)
    assert side.wheel_rate[middle] - side.rail_rate[middle] == pytest.approx(-1.0, abs=0.05)
    turned = arcs.curves.roll_rate[middle]
    wheel = -HOLLOW / (HOLLOW - HEAD) * (1.0 - (HEAD + 0.46) * turned)
    assert side.wheel_rate[middle] == pytest.approx(wheel, rel=0.02)


def test_near_stretch_of_arcs(arcs):
    """The gap of two arcs is s^2 / 2 (1 / R_r - 1 / R_w): within NEAR over 2 sqrt(2 NEAR / (1 / R_r - 1 / R_w)) = 51 mm."""
    middle = len(arcs.curves.lateral_shift) // 2
    curvature = 1 / HEAD - 1 / HOLLOW
    width = 2 * math.sqrt(2 * NEAR / curvature)
    assert arcs.curves.right.curvature[middle] == pytest.approx(curvature, rel=1e-2)
    assert arcs.curves.right.near_width[middle] == pytest.approx(width, rel=0.01)
    assert arcs.curves.right.near_turn[middle] == pytest.approx((width - MM) / HOLLOW, rel=0.02)    # between chords of 1 mm
    assert any(zone.start < 0.0 < zone.stop and zone.width >= 0.99 * width for zone in arcs.conformal)


# --- jumps and moves -------------------------------------------------------------------------------


def test_jumps_are_where_the_brute_force_search_has_them(uic60):
    """tests/reference/find_jumps.py on UIC60 1:40 [mm]; the printed S1002 has steps."""
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


def test_two_places_touch_at_a_jump(uic60):
    """Both have the same gap, straight from the printed profiles, at the jump's own shift and roll."""
    track = brute_force.track("UIC60", 1 / 40)
    for jump in uic60.jumps:
        pose = brute_force.Pose(jump.lateral_shift, 0.0, ContactSystem().evaluate(lateral_shift=jump.lateral_shift).roll)
        pose = pose if jump.side == "right" else pose.mirrored()
        places = np.array([jump.before, jump.after])
        gaps = brute_force.vertical_gap(track, pose, np.zeros(2), places)[0]
        assert gaps[0] == pytest.approx(gaps[1], abs=2e-7), jump        # [m] S1002's printed joints have steps of 1.2e-7
        across = brute_force.wheel_surface(track, pose, np.zeros(2), places)[0][1] - track.rail_origin
        np.testing.assert_allclose([jump.rail_before, jump.rail_after], across, atol=1e-6, err_msg=str(jump))


def test_moves_add_up_to_the_reference_positions(uic60):
    """Between 1 and 3 mm the contacts do not jump: the integrals of the rates are the published differences."""
    with open(REFERENCE_DATA / "rigid_positions.csv", newline="", encoding="utf-8") as file:
        rows = {float(row["lateral_shift_mm"]): row for row in csv.DictReader(file) if float(row["yaw_deg"]) == 0.0}
    curves = uic60.curves
    between = (curves.lateral_shift > 0.999 * MM) & (curves.lateral_shift < 3.001 * MM)
    rates = {"roll_rad": (curves.roll_rate, 1.0), "R_y_wheel_mm": (curves.right.wheel_rate, MM),
             "L_y_wheel_mm": (curves.left.wheel_rate, MM)}
    for name, (rate, unit) in rates.items():
        mean = 0.5 * (rate[between][1:] + rate[between][:-1])
        total = np.sum(mean * np.diff(curves.lateral_shift[between]))
        # the trapezoidal rule at 0.05 mm leaves 1e-5 of it
        assert total == pytest.approx((float(rows[3][name]) - float(rows[1][name])) * unit, rel=1e-4), name


def test_left_is_the_mirror_of_right(uic60):
    curves = uic60.curves
    for field in dataclasses.fields(curves.left):
        left, right = (getattr(side, field.name) for side in (curves.left, curves.right))
        sign = -1 if field.name.endswith("_rate") else 1
        if field.name == "near_width" or field.name == "near_turn":
            np.testing.assert_allclose(left, right[::-1], atol=1e-9)
        else:
            np.testing.assert_allclose(left, sign * right[::-1], rtol=1e-5, atol=1e-7, err_msg=field.name)


# --- profiles, ranges, files -----------------------------------------------------------------------


def wheel_file(folder, y, z, name="own.txt"):
    path = folder / name
    np.savetxt(path, np.column_stack([y, z]), fmt="%.9f")
    return path


def hollow(y, z, depth):
    """The wheel's points with a groove of this depth [mm] worn into the tread."""
    return z - depth * np.exp(-((y / 14.0) ** 2))


def test_points_are_told(tmp_path):
    y, z = noisy_points("wheel", 0.2, 10e-3, 5)
    z[300] += 0.8
    with pytest.warns(wrcontact.ProfileWarning):
        report = wrcontact.check(ContactSystem(wheel=wheel_file(tmp_path, y, z), rail="60E1"))
    reading = report.wheel.reading
    # the outlier, and what the noise made turn back at the vertical back of the flange
    assert len(y) - 5 < reading.points < len(y) and reading.spacing == pytest.approx(0.2 * MM, rel=0.05)
    assert reading.noise == pytest.approx(10e-6, rel=0.15) and reading.smoothing == reading.noise   # scatters by 2 to 6 %
    remarks = [remark for remark in report.remarks if remark.startswith("wheel profile own")]
    assert any("1 outlier" in remark for remark in remarks) and any("noise of" in remark for remark in remarks)
    assert report.rail.reading is None and report.wheel.roughness < 1.0     # [1/m]
    assert report.conicity.level[2] == pytest.approx(0.174, abs=0.02)       # noise of 10 um moves it by 5 %


@pytest.mark.slow
def test_noise_that_is_not_smoothed_is_told(tmp_path):
    """10 um every 0.2 mm are curvatures of 10 um / (0.2 mm)^2 = 250 1/m and more; the conicity averages them away."""
    wheel = Profile.from_file(wheel_file(tmp_path, *noisy_points("wheel", 0.2, 10e-3, 1)), "wheel", smoothing=0.0)
    rail = Profile.from_file(wheel_file(tmp_path, *noisy_points("rail", 0.2, 10e-3, 2)), "rail", smoothing=0.0)
    report = wrcontact.check(ContactSystem(wheel, rail))
    assert report.wheel.roughness > 100 and report.rail.roughness > 100     # [1/m]
    assert any("follow noise" in remark for remark in report.remarks)
    assert any(remark.startswith("the right contact jumps") for remark in report.remarks)
    assert report.conicity.level[2] == pytest.approx(0.180, abs=0.01)


@pytest.mark.parametrize("depth", [1.0, 3.0])
def test_hollow_wear_raises_the_conicity(tmp_path, depth):
    """Contact stays on the groove's shoulders, 15 to 25 mm off the running circle: one jumps near the centred position."""
    y, z = even_points("wheel", 0.5)
    report = wrcontact.check(ContactSystem(wheel=wheel_file(tmp_path, y, hollow(y, z, depth)), rail="60E1"))
    assert report.usable and 0.0 < report.nearest_jump < 1 * MM
    nearest = min(report.jumps, key=lambda jump: abs(jump.lateral_shift))
    assert abs(nearest.after - nearest.before) > 25 * MM
    assert np.all(report.conicity.level[:3] > 1.5 * np.array([0.354, 0.219, 0.174]))


def test_kink_is_told():
    halves = Polynomial(-70, -9, (-0.045, -0.055), -9.0), Polynomial(-9, 60, (-0.045, -0.05), -9.0)
    wheel = Profile("bent", "wheel", halves, smooth=False)
    report = wrcontact.check(ContactSystem(wheel))
    (y, turn), = report.wheel.kinks
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
    """Followed from the last pose, a minimum of the gap ran past the end of the wheel and was called valid: S1002 that ends at
    8 mm on 60E1, lateral shift 5 mm, touched with y_wheel = 13.3 mm on the left."""
    system = ContactSystem(short_wheel(8.0), "60E1")
    shifts = np.linspace(-8, 8, 161) * MM
    for order in (shifts, shifts[::-1]):        # the search starts where the last one ended
        table = system.evaluate_many(lateral_shift=order, outputs="geometry")
        valid = np.asarray(table.status) <= 1
        for side in (table.left, table.right):
            assert np.all(side.contact.y_wheel[valid] <= system.wheel.stop)
        assert np.array_equal(valid, valid[::-1])
    assert system.evaluate(lateral_shift=5 * MM).status == wrcontact.Status.OFF_PROFILE
    assert system.evaluate(lateral_shift=-5 * MM).status == wrcontact.Status.OFF_PROFILE


def test_ends_of_the_profiles_are_told():
    report = wrcontact.check(ContactSystem(short_wheel(8.0), "60E1"))
    first, last = report.usable_shifts
    assert -first == pytest.approx(last, abs=2e-6) and 1 * MM < last < 3 * MM and report.usable
    # the left contact is at the end of the wheel there
    state = report.system.evaluate(lateral_shift=last)
    assert state.left.contact.y_wheel == pytest.approx(report.system.wheel.stop, abs=0.02 * MM)
    assert any("leaves the profiles beyond" in remark for remark in report.remarks)
    assert np.isnan(report.conicity.level[3:]).all() and set(report.conicity.level_reason[3:]) == {OFF_PROFILE}
    assert math.isfinite(report.conicity.level[0])


def test_flange_contact_is_told():
    """10 mm less gauge is 5 mm less play."""
    wide, narrow = (wrcontact.check(ContactSystem(rail="60E1", gauge=gauge)) for gauge in (1.435, 1.425))
    assert wide.flange_shift - narrow.flange_shift == pytest.approx(5 * MM, abs=0.15 * MM)     # the other side rolls with it
    assert any("flange touches from 1.3" in remark for remark in narrow.remarks)
    assert not any("flange" in remark for remark in wide.remarks)


def test_pair_without_contact_is_told():
    report = wrcontact.check(ContactSystem(gauge=1.6))
    assert not report.usable and math.isnan(report.usable_shifts[0]) and report.jumps == ()
    assert report.remarks[0].startswith("there is no contact in the centred position")
    assert np.isnan(report.conicity.level).all() and report.conicity_curves["level"] is None


# --- the door --------------------------------------------------------------------------------------


@pytest.fixture
def run(capsys):
    """Run the command line in this process: (exit code, standard output, error output)."""

    def run(*words):
        with pytest.raises(SystemExit) as ended:
            main(["check", *map(str, words)], prog_name="wrcontact")
        seen = capsys.readouterr()
        return ended.value.code or 0, seen.out, seen.err

    return run


def test_command(run, tmp_path, standard):
    picture, content = tmp_path / "pair.png", tmp_path / "pair.json"
    code, out, err = run("--rail", "60E1", "--output", picture, "--json", content)
    assert code == 0 and err == ""
    for text in ("S1002 on 60E1: gauge 1435 mm, inclination 1:40", "contact at lateral shifts from -15.00 to 15.00 mm", "0.174", "0.2259",
                 "contact jumps 0.23 mm from the centred position", f"picture written to {picture}"):
        assert text in out
    assert picture.stat().st_size > 50_000
    read = json.loads(content.read_text(encoding="utf-8"))
    assert set(read) == {field.name for field in dataclasses.fields(standard)}
    assert read["conicity"]["level"] == standard.conicity.level.tolist()
    assert read["system"]["gauge"] == 1.435 and len(read["jumps"]) == len(standard.jumps)


def test_command_refuses_in_a_sentence(run, tmp_path):
    for words, told in ((("--output", tmp_path / "pair.doc"), ".png"), (("--wheel", "S1003"), "S1003"),
                        (("--gauge-mm", "3000"), "gauge"), (("--load", "normal"), "--load")):
        code, _, err = run(*words)
        assert code == 2 and err.startswith("wrcontact: ") and err.count("\n") == 1 and told in err


def test_command_tells_a_useless_pair(run, tmp_path):
    code, out, _ = run("--gauge-mm", "1600", "--output", tmp_path / "none.svg")
    assert (tmp_path / "none.svg").stat().st_size > 10_000
    assert code == 1 and "no contact in the centred position" in out and "nan" not in out


# --- the picture -----------------------------------------------------------------------------------


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
    spans = [patch for patch in panels["near"].patches if patch.get_gid() == "conformal"]
    assert len(spans) == sum(zone.side == "right" for zone in standard.conformal)
    # lines join places that touch: at their lower ends the rail has the height it is drawn with
    places = panels["places"]
    assert len([line for line in places.lines if len(line.get_xdata()) == 2]) == 65 + 2 * 3
