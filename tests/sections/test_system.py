"""A wheelset on rails whose section changes along the track, as a user has it: against grids, closed forms, the complete
theory, CONTACT, and the energy of a bump."""

import csv
import pickle
from functools import cache
from math import atan, pi, sin, sqrt, tan

import numpy as np
import pytest

import wrcontact
from data.hertz import MODULUS, hertz
from tests.helpers.changing import (
    CROWN,
    CYLINDER,
    RADIUS,
    mirrored,
    moving_rail,
    on_its_own,
    over_plane,
    smallest_gap,
    swaying,
    waving,
)
from tests.helpers.paths import DATA
from tests.helpers.sections import moved, nose
from tests.helpers.slice_files import POSITIONS, write_slices
from wrcontact import ContactSystem, RailSections, WheelContact
from wrcontact.halfspace.contact import solve_contact
from wrcontact.profiles import standard_profile
from wrcontact.status import explain
from wrcontact.wear import Usfd, Wear

WHEEL = standard_profile("S1002")


def values(state):
    return np.array([state[name] for name in state.names])


# --- rails that do not change ------------------------------------------------------------------------------------


@cache
def equal(mode):
    """A constant rail as sections on both sides and on one, and the same as a profile."""
    rail = moved([0.0, 0.5])
    kind = {"contact_mode": mode, "gauge": 1.437}
    return (
        ContactSystem(rail=rail, **kind),
        ContactSystem(rail=(rail, "UIC60"), rail_inclination=(0.0, 1 / 20), **kind),
        ContactSystem(rail_inclination=0.0, **kind),
        ContactSystem(rail_inclination=(0.0, 1 / 20), **kind),
    )


@pytest.mark.parametrize("mode", ["rigid", "compliant"])
@pytest.mark.parametrize("both", [True, False])
def test_equal_sections_are_the_constant_rail(mode, both):
    """All outputs, on both sides or beside a rail that is inclined; the gauge is measured in the section."""
    two, one, constant, beside = equal(mode)
    found, expected = (two, constant) if both else (one, beside)
    touching = equal("rigid")[2 if both else 3]
    for shift, yaw in ((0.0, 0.0), (3e-3, 0.01), (-5e-3, -0.02)):
        pose = {"lateral_shift": shift, "yaw": yaw}
        if mode == "compliant":
            rigid = touching.evaluate(**pose)
            pose |= {"vertical_shift_input": rigid.vertical_shift + 8e-5, "roll_input": rigid.roll}
        own, other = found.evaluate(track_position=0.3, **pose), expected.evaluate(**pose)
        assert own.status == other.status == 0
        wrong = np.abs(values(own) - values(other)) / (1e-9 + np.abs(values(other)))
        worst = int(np.argmax(np.where(np.abs(values(own) - values(other)) > 1e-9, wrong, 0.0)))
        assert wrong[worst] < 1e-6, (pose, own.names[worst], own[own.names[worst]], other[own.names[worst]])


# --- where a rail lies -------------------------------------------------------------------------------------------


SWAY = {
    "rail_origin_y": 0.7534,
    "left_rail_origin_y": 0.7541,
    "left_rail_position": 0.3,
    "left_rail_reversed": True,
}


@cache
def placed():
    return ContactSystem(rail=swaying(), rail_origin_z=2e-4, left_rail_origin_z=1e-4, **SWAY)


def assert_touching(count, seed):
    """Both wheels of a rigid wheelset touch their rails, and nowhere lie in them, with the roll that was found."""
    made, generator = swaying(), np.random.default_rng(seed)
    rails = {
        "right": lambda u, y: made.height(u, y - SWAY["rail_origin_y"]) + 2e-4,
        "left": lambda u, y: (
            made.height(SWAY["left_rail_position"] - u, y - SWAY["left_rail_origin_y"]) + 1e-4
        ),
    }
    for _ in range(count):
        u, shift, yaw = generator.uniform([-0.1, -5e-3, -0.015], [0.5, 5e-3, 0.015])
        state = placed().evaluate(lateral_shift=shift, yaw=yaw, track_position=u)
        assert state.status == 0, (u, shift, yaw)
        pose = u, shift, yaw, state.roll, state.vertical_shift
        for side, one in (("right", pose), ("left", mirrored(pose))):
            gap, y, angle = smallest_gap(rails[side], WHEEL, one)
            assert abs(gap) < 1e-9, (side, pose)
            assert getattr(state, side).contact.y_wheel == pytest.approx(y, abs=1e-5), (side, pose)


def test_both_wheels_touch_where_the_grid_does():
    """A rail that moves and dips, and the same one the other way round on the left."""
    assert_touching(2, 11)


@pytest.mark.full
def test_both_wheels_touch_where_the_grid_does_at_more_poses():
    assert_touching(6, 12)


@pytest.mark.full
def test_positions_are_counted_from_the_rail_position():
    one = ContactSystem(rail=swaying(), rail_origin_y=CROWN)
    other = ContactSystem(rail=swaying(), rail_origin_y=CROWN, rail_position=12.0)
    pose = {"lateral_shift": 2e-3, "yaw": 0.01}
    np.testing.assert_allclose(
        values(other.evaluate(track_position=12.15, **pose)),
        values(one.evaluate(track_position=0.15, **pose)),
        rtol=1e-7,
        atol=1e-9,
    )


@pytest.mark.full
def test_a_reversed_rail_is_that_of_slices_in_the_other_order():
    u, across = np.linspace(-0.4, 0.4, 17), np.linspace(0.0, 4e-3, 17) ** 2 / 4e-3
    reversed_ = ContactSystem(rail=moving_rail(u, across, 0.0), rail_origin_y=CROWN, rail_reversed=True)
    other = ContactSystem(rail=moving_rail(-u[::-1], across[::-1], 0.0), rail_origin_y=CROWN)
    pose = {"lateral_shift": 1e-3, "yaw": 5e-3, "track_position": 0.17}
    np.testing.assert_allclose(
        values(reversed_.evaluate(**pose)), values(other.evaluate(**pose)), rtol=1e-7, atol=1e-9
    )
    surface = swaying().surface
    again = surface.placed(0.3, True, 0.0).placed(0.3, True, 0.0)
    at = np.linspace(-0.6, 1.0, 50)
    np.testing.assert_allclose(again.jet(at, 1e-3), surface.jet(at, 1e-3), atol=1e-9)


@pytest.mark.full
def test_the_gauge_is_that_of_the_section_at_position_0():
    """Its inner face at half the gauge 14 mm below its highest place, which is at the height 0."""
    rail = moving_rail(np.linspace(-0.2, 0.4, 13), 0.013, np.linspace(-1e-3, 2e-3, 13))
    one = ContactSystem(rail=rail, rail_position=5.0, gauge=1.44, contact_mode="compliant", wheel=CYLINDER)
    face, depth = ContactSystem(rail_inclination=0.0, gauge=1.44).profile_tables()[2], 0.013
    other = ContactSystem(
        rail=rail,
        rail_position=5.0,
        rail_origin_y=face - depth,
        rail_origin_z=-0.0,
        contact_mode="compliant",
        wheel=CYLINDER,
    )
    pose = {"track_position": 5.1, "lateral_shift": 1e-3, "vertical_shift_input": 6e-4}
    np.testing.assert_allclose(
        values(one.evaluate(**pose)), values(other.evaluate(**pose)), rtol=1e-6, atol=1e-8
    )


# --- closed forms ------------------------------------------------------------------------------------------------


@cache
def rising():
    return ContactSystem(
        wheel=CYLINDER,
        rail=moved(np.linspace(-0.8, 0.8, 9), rise=0.1),
        rail_origin_y=CROWN,
        normal_model="hertz",
    )


def test_a_slope_pushes_back():
    """Of 1:10: the axle over the slope below it by R (sqrt(1 + m^2) - 1), the contact at x = R m / sqrt(1 + m^2), the force
    normal to the slope and through the axle, and the patch that on a level rail."""
    m, steep = 0.1, sqrt(1.01)
    depth, along, across, _ = hertz(
        0.5 / RADIUS, 0.5 / (0.3 * steep), 78500.0
    )  # the section is lower by 1 / steep
    for u in (-0.2, 0.0, 0.13):
        state = rising().evaluate(track_position=u)
        assert state.status == 0 and state.roll == pytest.approx(0.0, abs=1e-12)
        assert -state.vertical_shift == pytest.approx(m * u + RADIUS * (steep - 1.0), abs=1e-11)
        for wheel in (state.left, state.right):
            assert wheel.contact.x_track == pytest.approx(RADIUS * m / steep, abs=1e-10)
            assert wheel.contact.z_track == pytest.approx(-m * (u + RADIUS * m / steep), abs=1e-10)
            assert wheel.force.x == pytest.approx(-78500.0 * m / steep, rel=1e-10)
            assert wheel.force.z == pytest.approx(-78500.0 / steep, rel=1e-10)
            assert wheel.moment.y == pytest.approx(0.0, abs=1e-4)
            assert wheel.patches[0].slope == pytest.approx(atan(m), abs=1e-12)
            assert wheel.area == pytest.approx(pi * along * across, rel=1e-5)
            assert wheel.penetration == pytest.approx(depth, rel=1e-5)
        assert state.force.x == pytest.approx(2.0 * state.right.force.x, rel=1e-12)


def test_a_vertical_load_is_carried_by_the_slope():
    """The force along the rail is then the load times the slope."""
    system = ContactSystem(
        wheel=CYLINDER, rail=moved(np.linspace(-0.8, 0.8, 9), rise=0.1), rail_origin_y=CROWN, load="vertical"
    )
    found = system.evaluate(normal_force=60e3).right
    assert found.force.z == pytest.approx(-60e3, rel=1e-9) and found.force.x == pytest.approx(-6e3, rel=1e-9)


def test_a_wave_is_followed_on_its_parallel_curve():
    """A sine of height a cos(k u), axle at u - R sin(t): height a cos(k u) + R (cos(t) - 1), contact at x = R sin(t), with
    tan(t) = -a k sin(k u); the curvature of the wave is that of the contact besides 1 / R, more on a crest."""
    height, k = 1e-4, 2.0 * pi / 0.2
    system = ContactSystem(wheel=CYLINDER, rail=waving(height), rail_origin_y=CROWN, normal_model="hertz")
    for u in (-0.07, -0.03, 0.0, 0.02, 0.1):
        turn = atan(-height * k * sin(k * u))
        state = system.evaluate(track_position=u - RADIUS * sin(turn))
        wheel = state.right
        assert state.status == 0
        assert -state.vertical_shift == pytest.approx(
            height * np.cos(k * u) + RADIUS * (np.cos(turn) - 1.0), abs=1e-7
        )
        assert wheel.contact.x_track == pytest.approx(RADIUS * sin(turn), abs=1e-6)
        assert wheel.patches[0].slope == pytest.approx(turn, abs=1e-6)
        bend = height * k * k * np.cos(k * u) / (1.0 + tan(turn) ** 2) ** 1.5
        assert wheel.curvature_x == pytest.approx(1.0 / RADIUS + bend, rel=2e-3)


def test_no_work_is_left_over_a_bump():
    """Up a ramp with one overlap and down with another: the work of the force along the way and down, over a closed way, is
    zero. What each force would do alone is thousands of times more."""
    rise, length = 1e-3, 1.0

    def height(u):
        return 0.5 * rise * (1.0 - np.cos(pi * np.clip(u / length, 0.0, 1.0)))

    at = np.arange(-0.4, 1.1, 0.1)
    system = ContactSystem(
        wheel=CYLINDER,
        rail=moving_rail(at, 0.0, -height(at)),
        rail_origin_y=CROWN,
        contact_mode="compliant",
        normal_model="hertz",
    )
    u, deep = np.linspace(-0.2, 0.5, 31), np.linspace(8e-5, 1.2e-4, 31)
    ways = [(u, deep[0], 1.0), (0.5, deep, 1.0), (u, deep[-1], -1.0), (-0.2, deep, -1.0)]
    total = along = 0.0
    for at, sunk, way in ways:
        at, down = np.broadcast_arrays(at, sunk - height(at))
        table = system.evaluate_many(track_position=at, vertical_shift_input=down, outputs=["force"])
        assert (table.status == 0).all()
        one = np.trapezoid(table.force.x, at), np.trapezoid(table.force.z, down)
        total, along = total + way * sum(one), along + abs(one[0])
    assert along > 100.0 and abs(total) < 1e-4 * along


# --- complete theory and another program -------------------------------------------------------------------------


@pytest.mark.parametrize(
    "rail, position, load, area, pressure",
    [
        (lambda: waving(2e-4, 0.3), 0.05, 0.005, 0.02, 0.02),
        (lambda: waving(2e-4, 0.3), 0.0, 0.005, 0.02, 0.02),
        (swaying, 0.1, 0.005, 0.02, 0.02),
        (lambda: nose(np.linspace(-0.1, 0.1, 21)), 0.0, 0.01, 0.05, 0.04),
    ],
)
def test_loads_are_those_of_the_half_space_on_the_true_gap(rail, position, load, area, pressure):
    """Of a compliant wheel without roll, by strips: against complete theory over the tangent plane."""
    made = rail()
    shift = 0.0 if made.name == "nose" else 4e-3
    own = lambda u, y: made.height(u, y + shift - CROWN)  # noqa: E731
    pose = position, 0.0, 0.0, 0.0, 0.0
    sunk = smallest_gap(own, WHEEL, pose)[0] + 5e-5
    system = on_its_own(WHEEL, made, normal_model="analyn_strip")
    state = system.evaluate(
        track_position=position, lateral_shift=shift, vertical_shift_input=sunk, side="right"
    )
    found = state.right
    assert state.status == 0 and found.patch_count == 1
    place = found.contact.x_track, found.contact.y_track - shift
    gap, approach = over_plane(own, WHEEL, position, sunk, place)
    box = -0.012, 0.012, -0.008, 0.008
    complete = solve_contact(gap, box, contact_modulus=MODULUS, penetration=approach)
    assert found.normal_force == pytest.approx(complete.force, rel=load)
    assert found.area == pytest.approx(complete.area, rel=area)
    assert found.max_pressure == pytest.approx(complete.max_pressure, rel=pressure)


def test_the_nose_carries_what_it_does_in_contact():
    """At the height given to CONTACT: force within 3 %, area within 6 %, angles, the approach within 1 um, and the place within
    the 0.3 mm by which CONTACT's weighted middle differs from a rigid point."""
    with open(DATA / "crossing_nose.csv") as file:
        row = {name: float(value) for name, value in next(csv.DictReader(file)).items()}
    made = nose(np.linspace(-0.1, 0.1, 21))
    nu = row["poisson_ratio"]
    steel = 2e9 * row["shear_modulus_gpa"] * (1.0 + nu)
    system = on_its_own(WHEEL, made, normal_model="analyn_strip", youngs_modulus=steel, poisson_ratio=nu)
    state = system.evaluate(vertical_shift_input=1e-3 * row["z_ws_mm"], side="right")
    found = state.right
    assert state.status == 0
    assert found.penetration == pytest.approx(1e-3 * row["approach_mm"], abs=1e-6)
    assert found.normal_force == pytest.approx(row["normal_force_n"], rel=0.03)
    assert -found.force.z == pytest.approx(row["fz_n"], rel=0.03)
    assert found.area == pytest.approx(row["area_mm2"] * 1e-6, rel=0.06)
    assert found.patches[0].contact_angle == pytest.approx(-row["angle_rad"], abs=0.002)
    assert found.contact.x_track == pytest.approx(row["x_mm"] * 1e-3, abs=1e-5)
    assert found.contact.y_track == pytest.approx(row["y_track_mm"] * 1e-3, abs=3e-4)


# --- what a user does with it ------------------------------------------------------------------------------------


def test_tables_steppers_and_copies_have_the_same_bits():
    """Over the position along the track: rows are those of single poses, whatever was before, in threads, and after pickling."""
    system, u = placed(), np.linspace(-0.1, 0.5, 4)
    table = system.evaluate_many(track_position=u, lateral_shift=1e-3)
    assert (table.status == 0).all() and np.ptp(table.right.contact.y_track) > 1e-4
    copy, stepper = pickle.loads(pickle.dumps(system)), system.stepper()
    kept = None
    for k in (3, 0, 1, 2):
        stepper.inputs[stepper.place("track_position")] = u[k]
        stepper.inputs[stepper.place("lateral_shift")] = 1e-3
        assert stepper.step() == 0
        assert stepper.outputs.tobytes() == values_of(table[k]).tobytes()
        assert (
            values_of(copy.evaluate(track_position=u[k], lateral_shift=1e-3)).tobytes()
            == values_of(table[k]).tobytes()
        )
        kept = pickle.loads(pickle.dumps(stepper))
        assert kept.outputs.tobytes() == stepper.outputs.tobytes() and kept.step() == 0


def values_of(state):
    return state._values


@pytest.mark.parametrize("side", ["left", "right"])
def test_one_wheel_is_that_of_a_wheelset(side):
    """At the same height and roll, with its own rotation."""
    given = {"rail": swaying(), "rail_origin_y": CROWN, "tangential_model": "strips", "contact_damping": 0.2}
    wheel, system = WheelContact(side=side, **given), ContactSystem(contact_mode="compliant", **given)
    pose = {"lateral_shift": 1e-3, "vertical_shift_input": 6e-4, "yaw": 4e-3, "roll_input": 1e-4}
    run = {"track_position": [0.1, 0.22], "speed": 10.0, "wheel_rate": 21.6, "vertical_velocity": 0.01}
    own, whole = wheel.evaluate_many(**pose, **run), system.evaluate_many(**pose, **run)
    assert (own.status == 0).all() and (own.normal_force > 1e4).all()
    for name in (
        "force.x",
        "force.z",
        "moment.y",
        "patch[1].creepage.x",
        "patch[1].tangential.y",
        "driving_torque",
    ):
        assert (own[name] == whole[f"{side}.{name}"]).all(), name
    free = wheel.evaluate(track_position=0.1, speed=10.0, **pose)
    assert abs(free.driving_torque) < 1e-2 and free.patches[0].tangential.y != 0.0


def test_one_side_and_less_are_those_of_the_whole():
    pose = {"track_position": 0.12, "lateral_shift": -2e-3, "yaw": 4e-3}
    whole = placed().evaluate(**pose)
    for side in ("left", "right"):
        own = placed().evaluate(side=side, **pose)
        assert getattr(own, side).normal_force == getattr(whole, side).normal_force
        assert getattr(own, side).area == getattr(whole, side).area
    geometry = placed().evaluate(outputs="geometry", **pose)
    assert geometry.right.contact.y_track == whole.right.contact.y_track
    assert np.isnan(geometry.right.area)


@pytest.mark.full
def test_a_sweep_runs_over_positions():
    pytest.importorskip("xarray")
    axes = {"track_position": np.linspace(0.0, 0.2, 3), "lateral_shift": [0.0, 2e-3]}
    found = wrcontact.sweep(placed(), axes, outputs=["right.normal_force", "right.contact.y_track"])
    one = placed().evaluate(track_position=0.1, lateral_shift=2e-3)
    at = found["right_contact_y_track"].sel(track_position=0.1, lateral_shift=2e-3)
    assert float(at) == one.right.contact.y_track
    table = placed().evaluate_many(track_position=axes["track_position"], lateral_shift=1e-3)
    assert "track_position" in table.to_xarray().coords


def test_files_are_read_and_moved(tmp_path):
    """A slice file, its path, and the sections in Python are one rail."""
    path = write_slices(tmp_path)
    made = nose(POSITIONS)
    pose = {"vertical_shift_input": -2.1e-3, "side": "right"}
    found = [on_its_own(WHEEL, one).evaluate(**pose).right.normal_force for one in (str(path), path, made)]
    assert found[0] == found[1] == pytest.approx(found[2], rel=1e-4) and found[0] > 1e3


# --- what is refused ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "given, sentence",
    [
        (
            {"tangential_model": "halfspace"},
            "tangential_model is 'halfspace'; permitted with a rail that changes along the track are 'none', 'strips'",
        ),
        ({"normal_model": "halfspace"}, "normal_model is 'halfspace'; permitted with a rail that changes"),
        (
            {"normal_model": lambda *_: None},
            "normal_model is a function; permitted with a rail that changes along the track is a name",
        ),
        (
            {"longitudinal_curvature": "basic"},
            "longitudinal_curvature is 'basic'; permitted with a rail that changes",
        ),
        ({"lateral_curvature": "rough"}, "lateral_curvature is 'rough'; permitted with a rail that changes"),
        (
            {"contact_mode": "compliant", "left_rail_vertical_stiffness": 1e7},
            "left_rail_vertical_stiffness is 10000000.0 N/m; permitted with a rail that changes",
        ),
        (
            {"rail_inclination": 0.05},
            r"rail_inclination is 0.05; permitted with a rail that changes along the track is 0, since",
        ),
        (
            {"rail_origin_z": 1e-3},
            "rail_origin_z is 0.001 m without rail_origin_y; permitted is 0, or a rail_origin_y beside it",
        ),
        ({"rail_origin_y": 750.0}, "rail_origin_y is 750.0; permitted is -2 ... 2 m"),
        ({"rail_reversed": 2}, "rail_reversed is 2; permitted is True or False"),
        (
            {"gauge_depth": 0.035, "rail": nose(POSITIONS)},
            "gauge_depth is 0.035 m, but the inner side of the section of nose",
        ),
        (
            {"rail": "UIC60", "rail_position": 1.0},
            "rail_position is 1.0 m; permitted with a rail that is the same all along the",
        ),
        (
            {"rail": (moved([0.0, 0.5]), "UIC60"), "rail_reversed": (False, True)},
            "rail_reversed is True; permitted with a rail that",
        ),
        (
            {"rail": "nowhere.slcs"},
            "rail is 'nowhere.slcs', and there is no such file; permitted is the path of a file of sections",
        ),
        ({"rail": ("UIC60", "nowhere.toml")}, "rail is 'nowhere.toml', and there is no such file"),
        (
            {"wheel": moved([0.0, 0.5])},
            "wheel is RailSections 'moved', which changes along the track; permitted are profiles",
        ),
    ],
)
def test_what_does_not_go_with_sections_is_refused(given, sentence):
    with pytest.raises(ValueError, match=sentence) as raised:
        ContactSystem(**{"rail": moved([0.0, 0.5]), **given})
    assert "\n" not in str(raised.value)


def test_what_needs_a_constant_rail_says_so(tmp_path):
    system = equal("compliant")[0]
    state = system.evaluate(vertical_shift_input=1e-4)
    calls = {
        "check": lambda: wrcontact.check(system),
        "linearize": system.linearize,
        "rail_reaction": lambda: system.rail_reaction(state, "right"),
        "wear": lambda: Wear(system, Usfd()),
        "CONTACT": lambda: wrcontact.export.to_contact(system, state, tmp_path),
        "contact_table": lambda: wrcontact.export.contact_table(system, [0.0]),
        "profile_tables": system.profile_tables,
    }
    for what, call in calls.items():
        with pytest.raises(
            ValueError, match=f"rail 'moved' changes along the track; permitted for {what} are"
        ):
            call()
    with pytest.raises(ValueError, match="a rail changes along the track; permitted for"):
        system.stepper().rail_reaction("left")


@pytest.mark.parametrize(
    "pose, sentence",
    [
        (
            {"right_rail_roll_velocity": 10.0},
            "right.rail_roll_velocity is 10 rad/s; permitted with a rail that changes along the track is 0",
        ),
        (
            {"left_rail_roll": 1e-3},
            "left.rail_roll is 0.001 rad; permitted with a rail that changes along the track is 0",
        ),
        ({"track_position": np.nan}, "track_position is nan m; permitted are finite numbers"),
        (
            {"load_transfer": 2.0, "left_rail_roll": 1e-3},
            "load_transfer is 2; permitted is -1 <= load_transfer <= 1",
        ),
    ],
)
def test_inputs_that_are_not_known_with_sections_have_status_4(pose, sentence):
    state = equal("rigid")[0].evaluate(**pose)
    assert state.status == 4 and np.isnan(state.right.penetration)
    assert explain(state.status, state.inputs) == sentence


def test_sections_far_away_are_those_of_their_ends():
    """Beyond the slices, and their run-out, nothing changes."""
    system = ContactSystem(rail=swaying(), rail_origin_y=CROWN)
    ends = system.evaluate_many(track_position=[2.0, 50.0, 900.0], lateral_shift=1e-3)
    assert (ends.status == 0).all() and np.ptp(ends.right.contact.y_track) < 1e-12
    assert isinstance(system.rail, RailSections) and system.changing and not ContactSystem().changing
