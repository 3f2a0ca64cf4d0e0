"""Creep forces of the wheelset: what they add to forces and moments, and powers.

Witness: vectors in numpy from the outputs of each patch, for whatever model has found them.
"""

import numpy as np
import pytest

import wrcontact
from tests.helpers.cases import CREEP_MODELS, system
from tests.helpers.inside import counts_of, work_of
from wrcontact.conventions import SIDES
from wrcontact.kernel import layout
from wrcontact.kernel.creep.creep_force import solve_creep_force

POSE = {"lateral_shift": 3e-3, "yaw": 4e-3, "speed": 20.0, "lateral_velocity": 0.02, "yaw_rate": 0.05}
POSES = {
    "tread": {"lateral_shift": 1e-3, "yaw": 1e-3, "speed": 20.0},
    "moving": POSE,
    "flange root": {**POSE, "lateral_shift": 6.2e-3, "yaw": 0.01},
    "flange": {**POSE, "lateral_shift": 8e-3, "yaw": -0.01},
    "braking": {**POSE, "wheel_rate": 20.0 / 0.46 * 0.97},
    "locked": {**POSE, "wheel_rate": 0.0, "free_rolling": False},
    "backwards": {**POSE, "speed": -20.0},
    "curve": {**POSE, "track_curvature": 1 / 300},
}


def compliant(inputs):
    """The inputs with the height and roll of a compliant wheelset that carries the usual load."""
    found = system(contact_mode="elastic").evaluate(**inputs)
    return inputs | {"vertical_shift_input": found.vertical_shift, "roll_input": found.roll}


def stepped(contact, inputs):
    """The state of a system at ``inputs``, and the workspace of its step."""
    state, stepper = contact.evaluate(**inputs), contact.stepper()
    stepper.inputs[:] = state.inputs
    assert stepper.step() == state.status == 0
    return state, work_of(stepper)


def cross_sum(state, work):
    """Force, moment about the wheelset's centre (6,) and torque about the axle of the creep forces of each
    side, and their power, in numpy: tractions along the track act at their strips, all else at the centre of
    load.  About the axle their arm is the rolling radius; without that in the moment."""
    found = {}
    yaw, roll = state["yaw"], state.roll
    axle = np.array([-np.sin(yaw) * np.cos(roll), np.cos(yaw) * np.cos(roll), np.sin(roll)])
    centre = np.array([0.0, state["lateral_shift"], state.vertical_shift - 0.46])

    def turned(place, radius, force):
        """Moment (3,) of a force, and its part about the axle with the rolling radius."""
        moment = np.cross(place - centre, force)
        return moment, radius / np.linalg.norm(np.cross(axle, place - centre)) * (moment @ axle)

    for mirror, name, side in zip((-1.0, 1.0), SIDES, work.sides):
        total, torque, power = np.zeros(6), 0.0, 0.0
        for record in side.patches[: side.patch_count]:
            patch = getattr(state, name).patches[record.rank - 1]
            sine, cosine = np.sin(patch.contact_angle), np.cos(patch.contact_angle)
            outside = np.array([0.0, mirror * cosine, -sine])  # to the field side, in the patch's plane
            normal = np.array([0.0, -mirror * sine, -cosine])  # from the rail to the wheel
            place = np.array([patch.x_track, patch.y_track, patch.z_track])
            along = np.array([1.0, 0.0, 0.0])
            rest_x, rest_y, turning = patch.tangential.x, patch.tangential.y, patch.tangential.moment
            force, moments = np.zeros(3), []
            for strip in record.strips:
                own = np.array([0.0, mirror * strip.sin, -strip.cos])  # its normal
                force_x, force_y = strip.force_x * strip.width, strip.force_y * strip.width
                moment = strip.moment * strip.width - strip.x * force_y  # about its own middle
                rest_x, rest_y = rest_x - force_x, rest_y - force_y
                turning += mirror * (strip.moment * strip.width - strip.y * force_x)
                acting = force_x * along + force_y * np.array([0.0, mirror * strip.cos, strip.sin])
                at = np.array([patch.x_track + strip.x, mirror * strip.y_track, strip.z_track])
                moments += [
                    turned(at, strip.rolling_radius, acting),
                    (-mirror * moment * own, -mirror * moment * own @ axle),
                ]
                force += acting
            rest = rest_x * along + rest_y * outside
            moments += [
                turned(place, patch.rolling_radius, rest),
                (turning * normal, turning * normal @ axle),
            ]
            total += np.concatenate([force + rest, sum(moment for moment, _ in moments)])
            torque -= sum(part for _, part in moments)
            power += patch.friction_power
        found[name] = total, torque, power
    return found, axle


@pytest.mark.parametrize("mode", ["rigid", "elastic", "compliant"])
@pytest.mark.parametrize("pose", POSES)
def test_forces_of_wheels_and_wheelset_are_sums_over_patches(pose, mode):
    inputs = compliant(POSES[pose]) if mode == "compliant" else POSES[pose]
    for model in CREEP_MODELS:
        state, work = stepped(system(contact_mode=mode, tangential_model=model), inputs)
        sides, axle = cross_sum(state, work)
        total, torque = np.zeros(6), 0.0
        for name, (expected, part, power) in sides.items():
            side = getattr(state, name)
            expected[3:] -= (part + expected[3:] @ axle) * axle
            added = np.concatenate(
                [np.subtract(side.force, side.normal.force), np.subtract(side.moment, side.normal.moment)]
            )
            np.testing.assert_allclose(added, expected, rtol=0, atol=1e-6)  # N, N m: rounding of 1e5
            assert side.friction_power == pytest.approx(power, rel=1e-12, abs=1e-9)
            assert np.hypot(expected[0], np.hypot(*expected[1:3])) > 100.0, "no creep force to speak of"
            total, torque = total + expected, torque + part
        np.testing.assert_allclose(np.subtract(state.force, state.normal.force), total[:3], atol=1e-6)
        np.testing.assert_allclose(np.subtract(state.moment, state.normal.moment), total[3:], atol=1e-6)
        assert state.driving_torque == pytest.approx(torque, abs=1e-6)


def test_lifted_wheel_and_one_side():
    contact = system(tangential_model=CREEP_MODELS[0])
    state = contact.evaluate(**POSE, load_transfer=1.0)
    assert state.status == 1
    assert np.all(np.isfinite(state.values))
    assert state.left.friction_power == 0.0
    one = contact.evaluate(**POSE, side="right")
    both = contact.evaluate(**POSE)
    np.testing.assert_array_equal(one.values[layout.OUT_RIGHT :], both.values[layout.OUT_RIGHT :])
    assert np.isnan(one.driving_torque)


@pytest.mark.parametrize("friction", [-1e-9, 2.0001, np.nan, np.inf])
def test_friction_out_of_range(friction):
    state = system(tangential_model=CREEP_MODELS[0]).evaluate(**POSE, right_friction=friction)
    assert state.status == wrcontact.Status.INVALID_INPUT
    sentence = wrcontact.status.explain(state.status, state.inputs)
    assert "right.friction" in sentence and "permitted" in sentence
    if np.isfinite(friction):
        assert "0 <= right.friction <= 2" in sentence


@pytest.mark.parametrize("mode", ["rigid", "elastic"])
@pytest.mark.parametrize("pose", ["moving", "flange root", "flange", "backwards"])
def test_vertical_load_includes_friction(pose, mode):
    """Each wheel's whole force has the vertical component that is prescribed, to LOAD_MET."""
    contact = system(contact_mode=mode, load="vertical", tangential_model=CREEP_MODELS[0])
    state = contact.evaluate(**POSES[pose], normal_force=80e3, load_transfer=0.2)
    assert -state.left.force.z == pytest.approx(64e3, rel=1e-8)
    assert -state.right.force.z == pytest.approx(96e3, rel=1e-8)
    assert abs(state.right.normal.force.z + 96e3) > 30.0, "friction carries nothing here"


def test_a_wheel_that_friction_jams_meets_its_load():
    """A flange that climbs carries N (cos angle - mu sin angle) at most, where all friction points down the
    flange: below mu = cot(angle) the load is met soon, well beyond by patches that reach the flange root,
    under several times the normal force."""
    contact = system(load="vertical", tangential_model="polach")
    climbing = {"lateral_shift": 7e-3, "yaw": -0.03, "speed": 20.0}
    smooth = contact.evaluate(**climbing, right_friction=0.0)
    jams = 1.0 / np.tan(max(patch.contact_angle for patch in smooth.right.patches))
    assert 0.3 < jams < 0.6
    pressed = []
    for share in (0.3, 0.8, 1.2, 2.0, 3.0):
        state = contact.evaluate(**climbing, right_friction=share * jams)
        assert state.status == wrcontact.Status.VALID
        assert -state.right.force.z == pytest.approx(78.5e3, rel=1e-9)
        pressed.append(state.right.normal_force)
    assert np.all(np.diff(pressed) > 0.0) and pressed[-1] > 10.0 * 78.5e3


#: Across a flange that climbs under large friction: a shift, yaw -17 mrad, friction 0.6.
CLIMBING = {
    "lateral_shift": np.linspace(5e-3, 8.5e-3, 2001),
    "yaw": -0.017,
    "speed": 20.0,
    "wheel_rate": 20.0 / 0.46,
    "left_friction": 0.6,
    "right_friction": 0.6,
}


def missed(table):
    """By what share of it each pose misses a vertical load of 78.5 kN (n,)."""
    return np.max([np.abs(side.force.z / 78.5e3 + 1.0) for side in (table.left, table.right)], axis=0)


def test_vertical_loads_are_met_across_a_flange():
    """In all poses, but for those in which the vertical force jumps past the load: these have a status."""
    table = system(load="vertical", tangential_model="strips").evaluate_many(**CLIMBING)
    met = table.status == wrcontact.Status.VALID
    assert np.isin(table.status, (wrcontact.Status.VALID, wrcontact.Status.NOT_CONVERGED)).all()
    assert np.count_nonzero(~met) < 60  # 36 measured
    assert (missed(table)[met] <= 1.001e-9).all()


@pytest.mark.parametrize("normal", ["analyn", "analyn_strip"])
@pytest.mark.parametrize("mode, count", [("rigid", 200), pytest.param("elastic", 60, marks=pytest.mark.full)])
def test_no_answer_misses_its_vertical_load(mode, count, normal):
    """Friction that jams flanges: answers carried up to 614 times the load that was asked, 1.34 m deep."""
    rng = np.random.default_rng(37)
    poses = {
        "lateral_shift": rng.uniform(5e-3, 8.5e-3, count),
        "yaw": rng.uniform(-30e-3, -10e-3, count),
        "normal_force": np.exp(rng.uniform(np.log(20e3), np.log(150e3), count)),
        "left_friction": rng.uniform(0.5, 0.9, count),
        "right_friction": rng.uniform(0.5, 0.9, count),
        "speed": 20.0,
    }
    contact = system(contact_mode=mode, load="vertical", normal_model=normal, tangential_model="polach")
    table = contact.evaluate_many(**poses)
    met = table.status == wrcontact.Status.VALID
    assert np.mean(met) > 0.9
    if mode == "elastic" and normal == "analyn_strip":
        # rows 5 and 41: one wheel moves the load of the other one past those that enclosed it
        assert met.all()
    for side in (table.left, table.right):
        np.testing.assert_allclose(-side.force.z[met], poses["normal_force"][met], rtol=1.1e-9)
        assert side.penetration[met].max() <= 2e-3
    # work is bounded: passes of a rigid wheelset, trials of an elastic one, of which 1381 are the most; the
    # last Newton step of each trial, for states without history, is among them
    stepper = contact.stepper()
    before = 0.0
    for row in range(count):
        stepper.inputs[:] = table.inputs[row]
        stepper.step()
        rolls = counts_of(stepper)["roll"]
        assert rolls - before < (1600 if mode == "rigid" else 2200)
        before = rolls


def test_normal_forces_of_vertical_loads_have_these_vertical_forces():
    """An elastic wheelset under the normal forces that vertical loads have led to, as normal loads. The few
    poses in which no loads are found have a status."""
    poses = CLIMBING | {"lateral_shift": CLIMBING["lateral_shift"][::20]}
    given = dict(contact_mode="elastic", tangential_model="strips")
    table = system(load="vertical", **given).evaluate_many(**poses)
    found = table.status == wrcontact.Status.VALID
    assert np.count_nonzero(found) >= 94 and (missed(table)[found] < 1e-9).all()
    left, right = table.left.normal_force[found], table.right.normal_force[found]
    poses |= {
        "lateral_shift": poses["lateral_shift"][found],
        "normal_force": 0.5 * (left + right),
        "load_transfer": (right - left) / (right + left),
    }
    again = system(load="normal", **given).evaluate_many(**poses)
    assert right.max() > 10.0 * 78.5e3
    # forces that friction jams follow the normal ones many times as fast
    assert (missed(again) < 1e-8).all(), poses["lateral_shift"][missed(again).argmax()]


def test_falling_friction():
    """Polach's form, with the sliding velocity V sqrt(xi^2 + eta^2), where all slides."""
    fall = {"friction_fall": 0.4, "friction_fall_rate": 0.6}
    state = system(tangential_model=CREEP_MODELS[0], **fall).evaluate(speed=10.0, free_rolling=False)
    patch = state.right.patches[0]
    sliding = 0.5 * 10.0 * np.hypot(patch.creepage.x, patch.creepage.y)
    expected = 0.3 * (0.6 * np.exp(-0.6 * sliding) + 0.4)
    assert sliding == pytest.approx(10.0, rel=1e-6)
    assert np.hypot(patch.tangential.x, patch.tangential.y) == pytest.approx(
        expected * patch.normal_force, rel=1e-3
    )


def test_flange_lubrication():
    """Full friction on the tread, the given share on the flange."""
    lubricated = system(tangential_model="polach", flange_friction_ratio=0.3)
    plain = system(tangential_model="polach")
    sliding = {"speed": 20.0, "free_rolling": False}
    tread = [contact.evaluate(**sliding).right.patches[0] for contact in (lubricated, plain)]
    assert tread[0].tangential.x == tread[1].tangential.x
    found, full = (
        contact.evaluate(lateral_shift=9e-3, **sliding).right.patches[0] for contact in (lubricated, plain)
    )
    assert full.contact_angle > 0.8
    assert found.tangential.x == pytest.approx(0.3 * full.tangential.x, rel=1e-3)


@pytest.mark.parametrize("model", CREEP_MODELS)
def test_slope_reduction(model):
    """k0 alone is a half of all creepages; with beta the slope falls further, and full slip stays."""
    full, reduced = (
        system(tangential_model=model, **reduction).stepper() for reduction in ({}, {"slope_reduction": 0.5})
    )
    for stepper in (full, reduced):
        stepper.inputs[:] = system().evaluate(**POSE, wheel_rate=20.0 / 0.46).inputs
        assert stepper.step() == 0
    work = work_of(full)
    patch = next(patch for patch in work.sides[1].patches if patch.rank == 1)
    for name in ("creepage_x", "creepage_y", "spin"):
        setattr(patch, name, 0.5 * getattr(patch, name))
    for strip in patch.strips:
        for name in ("slip", "lateral", "spin"):
            setattr(strip, name, 0.5 * getattr(strip, name))
    solve_creep_force(layout.Tables.at(full.tables), work.rolling, patch)
    found = layout.Outputs.at(reduced.outputs).left[1].patch[0]
    assert found.creep_force_x == pytest.approx(patch.creep_x, rel=1e-12)
    assert found.creep_force_y == pytest.approx(patch.creep_y, rel=1e-12)
    wet = {"slope_reduction": 0.54, "slope_reduction_rate": 0.64}
    forces = [
        -system(tangential_model=model, **wet)
        .evaluate(speed=20.0, wheel_rate=20.0 / 0.46 * (1 - creepage))
        .right.force.x
        for creepage in (0.003, 0.05, 0.5)
    ]
    assert forces[0] < forces[1] < forces[2]
    assert forces[2] == pytest.approx(0.3 * 78500, rel=0.05)
