"""Limits of flange climb and track shift, and the report of a run.

Witnesses: the triangle of forces on a flange, printed values, closed forms of sines, geometry of a wheelset that has
climbed.
"""

import numpy as np
import pytest

import wrcontact
from tests.helpers.cases import system
from wrcontact import plots
from wrcontact.profiles.catalogue import standard_profile

STEP, SPEED = 1e-3, 20.0
TIME = STEP * np.arange(8000)


def test_nadal_is_the_triangle_of_forces():
    """A wheel that slides down: load N across the slope, friction mu N up along it."""
    angle, friction = np.radians([60.0, 68.0, 75.0]), 0.4
    normal = np.array([np.sin(angle), np.cos(angle)])  # outwards, down
    along = np.array([-np.cos(angle), np.sin(angle)])  # down along the rail
    force = normal + friction * along
    np.testing.assert_allclose(wrcontact.nadal_limit(angle, friction), force[0] / force[1], rtol=1e-12)
    # 49 CFR 213.333: (tan d - 0.5) / (1 + 0.5 tan d)
    assert wrcontact.nadal_limit(np.radians(75.0), 0.5) == pytest.approx(
        (3.7321 - 0.5) / (1 + 0.5 * 3.7321), abs=1e-4
    )
    assert wrcontact.weinstock_limit(1.2, 0.3, 0.25) == wrcontact.nadal_limit(1.2, 0.3) + 0.25


def test_track_shift_limit_in_kilonewtons():
    assert wrcontact.track_shift_limit(180e3) == pytest.approx(70e3)
    np.testing.assert_allclose(wrcontact.track_shift_limit([90e3, 225e3], 0.85), [34e3, 72.25e3])
    for load, factor, words in ((0.0, 1.0, "axle_load is 0.0"), (1e5, -1.0, "factor is -1.0")):
        with pytest.raises(ValueError, match=words):
            wrcontact.track_shift_limit(load, factor)


def test_flange_angles_of_profiles():
    """As the drawings name them: S1002 70 deg, and a cone."""
    assert np.degrees(wrcontact.steepest_angle(standard_profile("S1002"))) == pytest.approx(70.0, abs=1e-6)
    with pytest.raises(ValueError, match="a rail"):
        wrcontact.steepest_angle(standard_profile("60E1"))


def test_a_wheel_that_slides_down_is_on_nadals_limit():
    """No margin is left; the other way round there is the whole of it."""
    one = system(normal_model="hertz", tangential_model="strips", contact_mode="rigid")
    found = [
        wrcontact.flange_climb(
            one.evaluate(6.6e-3, speed=1e-4, wheel_rate=1e-4, lateral_velocity=way, right_friction=0.3)
        )
        for way in (-10.0, 10.0)
    ]
    assert found[0].right_margin == pytest.approx(0.0, abs=0.03)
    assert found[1].right_margin < -0.5 and np.isnan(found[1].left_margin)
    assert found[0].sum_limit == pytest.approx(found[0].right_limit + 0.3)


def test_tables_states_and_runs_agree_and_mirror():
    one = system(tangential_model="strips")
    shifts = np.array([0.0, 6.2e-3, 6.6e-3])
    table = one.evaluate_many(shifts, yaw=8e-3, speed=20.0, right_friction=0.4)
    mirrored = one.evaluate_many(-shifts, yaw=-8e-3, speed=20.0, left_friction=0.4)
    run = {name: table[name] for name in table.names} | {"left.friction": 0.3, "right.friction": 0.4}
    whole = wrcontact.flange_climb(table)
    for other in (wrcontact.flange_climb(run), [wrcontact.flange_climb(table[k]) for k in range(3)]):
        other = other if isinstance(other, tuple) else tuple(np.transpose(other))
        np.testing.assert_allclose(tuple(whole), tuple(other), rtol=1e-12)
    assert whole.sum_limit[2] == pytest.approx(whole.right_limit[2] + 0.3, rel=1e-12)
    swapped = wrcontact.flange_climb(mirrored)
    np.testing.assert_allclose(swapped.left_margin, whole.right_margin, rtol=1e-6, atol=1e-6)
    np.testing.assert_allclose(swapped.sum_margin, whole.sum_margin, rtol=1e-6, atol=1e-6)
    stated = wrcontact.flange_climb(table, flange_angle=np.radians(70.0))
    np.testing.assert_allclose(stated.left_limit, np.tan(np.radians(70.0) - np.arctan(0.3)))
    with pytest.raises(ValueError, match="no column 'left.friction'"):
        wrcontact.flange_climb({"left.derailment_quotient": [0.1]})
    with pytest.raises(ValueError, match="flange_angle is 70"):
        wrcontact.flange_climb(table, 70)


def test_wheel_lift_is_the_height_of_the_running_circle():
    """Half the flange up; the point of the running circle in the track frame, from the attitude."""
    state = system().evaluate(7.5e-3)
    z, roll = state.vertical_shift, state.roll
    for side, sign in (("left", -1.0), ("right", 1.0)):
        # (y, z) of a point of the wheelset at (sign 0.75, 0.46) below its centre, less that without any motion
        down = z - 0.46 + sign * 0.75 * np.sin(roll) + 0.46 * np.cos(roll)
        assert wrcontact.wheel_lift(state, side) == pytest.approx(-down, abs=0.46 * roll**2)
    assert wrcontact.wheel_lift(state, "right") > 5e-3 > abs(wrcontact.wheel_lift(state, "left"))
    with pytest.raises(ValueError, match="side is 'top'"):
        wrcontact.wheel_lift(state, "top")


def test_climb_distances_of_a_sine():
    """1 + sin exceeds 1.5 over a third of each wave."""
    distance = np.arange(0.0, 30.0, 0.01)
    quotient = 1.0 + np.sin(2.0 * np.pi * distance / 10.0)
    begins, lengths = wrcontact.climb_distances(quotient, 1.5, distance)
    np.testing.assert_allclose(begins, [10.0 / 12.0, 10.0 + 10.0 / 12.0, 20.0 + 10.0 / 12.0], atol=1e-4)
    np.testing.assert_allclose(lengths, 10.0 / 3.0, atol=1e-4)
    limit = np.where(distance < 15.0, np.nan, 1.5)
    assert len(wrcontact.climb_distances(quotient, limit, distance)[0]) == 1
    begins, lengths = wrcontact.climb_distances(quotient, -0.5, distance)
    assert begins == [0.0] and lengths == [distance[-1]]
    with pytest.raises(ValueError, match="distance"):
        wrcontact.climb_distances(quotient, 1.0, distance[::-1])


def test_climb_distance_of_tcrp_71():
    """The printed coefficients in feet, inches, degrees and mrad, term by term; A feet without an angle of attack, and
    A B L over the angle at a large one."""
    foot, inch, angle = 0.3048, 0.0254, np.radians(72.0)
    length = 0.75
    first, second = 100.0 / (-137.7216 + 146.56) + 3.1, -0.0092 * 5184.0 + 87.4944 - 39.031
    a = first * length - 1.0 / second + 1.23
    b = (10.0 / (-15.86775 + 2.1052) + 0.05) * 72.0 + 10.0 / (0.2016 - 0.0266) - 5.0
    limit = wrcontact.climb_distance_limit
    attacks = np.array([-4e-3, 0.0, 5e-3, 10e-3, 1e3])
    wanted = foot * a * b * length / (np.array([0.0, 0.0, 5.0, 10.0, 1e6]) + b * length)
    np.testing.assert_allclose(limit(attacks, angle, length * inch), wanted, rtol=1e-12)
    assert limit(0.0, angle, length * inch) == pytest.approx(a * foot, rel=1e-12)
    assert limit(1e3, angle, length * inch) == pytest.approx(a * b * length * foot / 1e6, rel=1e-5)
    # 3.65 ft at 5 mrad: shorter than 49 CFR 213.333's window of 5 ft, and falling with the angle of attack
    assert limit(5e-3, angle, length * inch) == pytest.approx(3.65 * foot, abs=2e-3)
    assert (np.diff(limit(np.linspace(0.0, 50e-3, 20), angle, 19e-3)) < 0.0).all()


def test_climb_distances_between_the_poles_of_the_fit():
    """Denominators of A vanish at 55.1, 76.6 and 77.0 deg; in the permitted range distances are 1 ft ... 10 m."""
    poles = [146.56 / 1.9128, *np.roots([-0.0092, 1.2152, -39.031])]
    assert sorted(round(float(pole), 1) for pole in poles) == [55.1, 76.6, 77.0]
    for angle in np.radians(np.linspace(60.0, 75.0, 7)):
        for length in np.linspace(10e-3, 26e-3, 5):
            found = wrcontact.climb_distance_limit([0.0, 2e-3, 10e-3, 30e-3], angle, length)
            assert (np.diff(found) < 0.0).all() and 0.1 < found[-1] < found[0] < 11.0, (angle, length, found)
    for wrong, words in (
        ((1e-3, 70.0, 19e-3), "flange_angle is 70.0; permitted are numbers of 1.047 ... 1.309, in rad"),
        ((1e-3, 1.2, 0.75), "flange_length is 0.75; permitted are numbers of 0.01 ... 0.026, in m"),
        (([1e-3, np.nan], 1.2, 19e-3), "angle_of_attack"),
    ):
        with pytest.raises(ValueError, match=words):
            wrcontact.climb_distance_limit(*wrong)


def run_of(sum_y, q=80e3):
    """A run whose wheels shift the track with a force (n,), and spread it with 2 kN."""
    zeros = np.zeros_like(sum_y)
    return {
        "left.force.y": zeros + 2e3,
        "right.force.y": -sum_y - 2e3,
        "left.force.z": zeros - q,
        "right.force.z": zeros - q,
    }


def test_report_of_a_slow_sine():
    """The share p of A sin's values lies below -A cos(pi p); means over 2 m of a wave of 100 m keep sin(x) / x."""
    wave, size = 100.0, 40e3
    sum_y = size * np.sin(2.0 * np.pi * SPEED * TIME / wave) + 5e3
    report = wrcontact.guiding_report(run_of(sum_y), STEP, SPEED * TIME, axle_load=180e3, factor=0.85)
    row = report["sum_y"]
    kept = np.sinc(2.0 / wave)
    assert row.high == pytest.approx(5e3 + size * kept * np.cos(np.pi * 0.0015), rel=2e-3)
    assert row.low == pytest.approx(5e3 - size * kept * np.cos(np.pi * 0.0015), rel=4e-3)
    assert row.limit == pytest.approx(59.5e3) and row.share == pytest.approx(row.high / row.limit)
    assert report["right.quotient"].high == pytest.approx((row.high + 2e3) / 80e3, rel=1e-6)
    assert report["right.quotient"].limit == 0.8 and np.isnan(report["right.q"].limit)
    assert report["left.q"].median == pytest.approx(80e3) and report["left.y"].high == pytest.approx(2e3)


def test_report_leaves_out_what_is_fast(tmp_path):
    """100 Hz is gone but for 0.3 %, and some at the ends."""
    report = wrcontact.guiding_report(run_of(40e3 * np.sin(200.0 * np.pi * TIME)), STEP, SPEED * TIME)
    assert report["right.y"].high < 2e3 + 0.05 * 40e3 and np.isnan(report["sum_y"].limit)
    assert "99.85 %" in str(report) and str(report).count("\n") == 7
    report.save(tmp_path / "report.csv")
    lines = (tmp_path / "report.csv").read_text(encoding="utf-8").splitlines()
    assert lines[0] == "name,unit,low,median,high,limit,share" and len(lines) == 8
    with pytest.raises(KeyError, match="sum_y"):
        report["sum"]


def test_histories_of_margins():
    one = system(tangential_model="strips")
    table = one.evaluate_many(np.linspace(5e-3, 7e-3, 9), yaw=8e-3, speed=20.0)
    axis = plots.history(table, "climb_margin", over=np.arange(9.0))
    drawn = axis.get_lines()[1].get_ydata()
    np.testing.assert_allclose(drawn, wrcontact.flange_climb(table).right_margin)
    axis = plots.history(table, "right.wheel_lift", over=np.arange(9.0))
    np.testing.assert_allclose(axis.get_lines()[0].get_ydata(), 1e3 * wrcontact.wheel_lift(table, "right"))
    assert "[mm]" in axis.get_ylabel()
