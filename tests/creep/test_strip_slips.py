"""Creepages and spin of the strips of a patch: those of their own place on the wheel, in their own plane."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.cone import HEAD, cone_system
from tests.helpers.inside import work_of
from wrcontact.kernel import layout
from wrcontact.profiles.compiled import evaluate_table

MOTION = {
    "speed": 20.0,
    "wheel_rate": 20.0 / 0.46,
    "lateral_velocity": 0.02,
    "yaw_rate": 0.03,
    "track_curvature": 1e-3,
}


def rolled(system, **inputs):
    """Outputs and workspace of a step, as records."""
    stepper = system.stepper()
    stepper.inputs[:] = wrcontact.ContactSystem().evaluate(**inputs, **MOTION).inputs
    assert stepper.step() == 0
    return layout.Outputs.at(stepper.outputs), work_of(stepper), stepper


def ranked(side):
    """The patches of a side by falling load."""
    return sorted(side.patches[: side.patch_count], key=lambda patch: patch.rank)


@pytest.mark.parametrize("slope", [0.025, 0.05, 0.1])
def test_on_a_cone_it_is_that_of_spin(slope):
    """xi - phi y, since the rolling radius follows a straight line; the rail's round head turns the strips'
    planes, by 1 - cos of an angle of some hundredths."""
    outputs, work, _ = rolled(cone_system(slope, tangential_model="polach"), lateral_shift=2e-3)
    for index, mirror in enumerate((-1.0, 1.0)):
        patch, to = ranked(work.sides[index])[0], outputs.left[index].patch[0]
        spin = -mirror * to.spin
        for strip in patch.strips:
            expected = to.creepage_x - spin * strip.y
            assert strip.slip == pytest.approx(expected, abs=2e-3 * abs(spin) * to.width)


@pytest.mark.parametrize("shift, yaw", [(0.0, 0.0), (5e-3, 2e-3), (6.2e-3, 0.0), (8e-3, 0.0)])
def test_on_a_profile_it_follows_the_rolling_radius(shift, yaw):
    """v . e_x / V_ref at each strip's place on the rail, with the wheel's profile there; elastic contact."""
    system = wrcontact.ContactSystem(contact_mode="elastic", tangential_model="polach")
    outputs, work, stepper = rolled(system, lateral_shift=shift, yaw=yaw)
    wheel, rail, rail_y = system.profile_tables()
    roll, height = outputs.roll, outputs.vertical_shift
    axle = np.array([-np.sin(yaw) * np.cos(roll), np.cos(yaw) * np.cos(roll), np.sin(roll)])
    centre = np.array([0.0, shift, height - 0.46])
    rate = MOTION["speed"] / 0.46
    for index, mirror in enumerate((-1.0, 1.0)):
        for patch, to in zip(ranked(work.sides[index]), outputs.left[index].patch):
            places = np.array(
                [(to.x_track + strip.x, mirror * strip.y_track, strip.z_track) for strip in patch.strips]
            )
            # the strips lie on the rail
            across = mirror * places[:, 1] - rail_y
            np.testing.assert_allclose(places[:, 2], evaluate_table(rail, across)[0], rtol=0, atol=1e-12)
            arms = places - centre
            around = np.cross(axle, arms)
            radius = np.array([strip.rolling_radius for strip in patch.strips])
            rolling = rate * radius[:, None] * around / np.linalg.norm(around, axis=1)[:, None]
            turning = MOTION["yaw_rate"] + MOTION["speed"] * MOTION["track_curvature"]
            along = (
                MOTION["speed"] * (1 - MOTION["track_curvature"] * shift)
                - rolling[:, 0]
                - turning * arms[:, 1]
            )
            # yaw rate alone: the roll rate that follows from contact has no part along the track without yaw
            reference = patch.speed
            found = np.array([strip.slip for strip in patch.strips])
            tolerance = 1e-12 if yaw == 0.0 else 1e-3 * abs(to.spin) * to.width
            np.testing.assert_allclose(found, along / reference, rtol=0, atol=tolerance)
            # the wheel's profile where it lies on the rail: within its penetration, across a steep profile
            wheel_y = mirror * (arms[:, 1] * np.cos(roll) + arms[:, 2] * np.sin(roll)) - 0.75
            expected = 0.46 + evaluate_table(wheel, wheel_y)[0]
            slope = np.tan(abs(to.contact_angle) + 0.2)
            np.testing.assert_allclose(radius, expected, rtol=0, atol=2e-4 * (1 + slope))


def strips_of(work, outputs, side):
    """Arrays of a right wheel or, mirrored, of a left one by name, for its heaviest patch: strips' places in
    the track, normals from the rail to the wheel, directions to the field side, slips."""
    patch = ranked(work.sides[side])[0]
    sine, cosine = np.array([(strip.sin, strip.cos) for strip in patch.strips]).T
    none = np.zeros(len(sine))
    return patch, {
        "places": np.array(
            [(patch.x_track + strip.x, strip.y_track, strip.z_track) for strip in patch.strips]
        ),
        "normals": np.stack([none, sine, -cosine], axis=1),
        "across": np.stack([none, cosine, sine], axis=1),
        "lateral": np.array([strip.lateral for strip in patch.strips]),
        "spin": np.array([strip.spin for strip in patch.strips]),
        "radius": np.array([strip.rolling_radius for strip in patch.strips]),
    }


@pytest.mark.parametrize("roll", [0.0, 0.02])
@pytest.mark.parametrize("shift, yaw", [(5e-3, 4e-3), (6.2e-3, 0.0), (8e-3, 0.0)])
def test_lateral_creepage_and_spin_are_those_of_its_own_plane(shift, yaw, roll):
    """w_y = v . t and phi = -W . n over V_ref with the velocity v and the whole rotation W of a rigid body at
    the strip's place, and the normal n of the rail there; also on a rail that is rolled and rolls."""
    system = wrcontact.ContactSystem(contact_mode="compliant", tangential_model="strips")
    stand = wrcontact.ContactSystem(contact_mode="elastic").evaluate(shift, yaw, right_rail_roll=roll)
    given = {
        "lateral_shift": shift,
        "yaw": yaw,
        "vertical_shift_input": stand.vertical_shift,
        "roll_input": stand.roll,
        "vertical_velocity": -0.01,
        "roll_rate": 0.03,
        "right_rail_roll": roll,
        "right_rail_lateral_velocity": 0.02,
        "right_rail_vertical_velocity": 0.01,
        "right_rail_roll_velocity": 0.05,
    }
    outputs, work, _ = rolled(system, **given)
    patch, strips = strips_of(work, outputs, 1)
    _, rail, rail_y = system.profile_tables()
    # the rail rolls about its highest point; its profile is read where the strip lies on the upright rail
    away = strips["places"][:, 1:] - (rail_y, 0.0)
    upright = away @ np.array([[np.cos(roll), -np.sin(roll)], [np.sin(roll), np.cos(roll)]])
    slope = np.arctan(evaluate_table(rail, upright[:, 0])[1])
    expected = np.stack([np.zeros(16), np.sin(slope + roll), -np.cos(slope + roll)], axis=1)
    np.testing.assert_allclose(strips["normals"], expected, rtol=0, atol=1e-9)
    assert np.ptp(slope) > 0.03  # the patch turns
    centre = np.array([0.0, shift, stand.vertical_shift - 0.46])
    axle = np.array([-np.sin(yaw) * np.cos(stand.roll), np.cos(yaw) * np.cos(stand.roll), np.sin(stand.roll)])
    bend = MOTION["speed"] * MOTION["track_curvature"]
    turning = np.array([0.03 * np.cos(yaw), 0.03 * np.sin(yaw), MOTION["yaw_rate"] + bend])
    arms = strips["places"] - centre
    around = np.cross(axle, arms)
    rate = MOTION["speed"] / 0.46
    rolling = rate * strips["radius"][:, None] * around / np.linalg.norm(around, axis=1)[:, None]
    velocity = (
        (MOTION["speed"] - bend * shift, MOTION["lateral_velocity"], -0.01)
        + np.cross(turning, arms)
        - rolling
        - (0.0, 0.02, 0.01)
        - np.cross((0.05, 0.0, 0.0), strips["places"] - (0.0, rail_y, 0.0))
    )
    np.testing.assert_allclose(
        strips["lateral"], (velocity * strips["across"]).sum(axis=1) / patch.speed, rtol=0, atol=1e-12
    )
    np.testing.assert_allclose(
        strips["spin"], -strips["normals"] @ (turning - rate * axle) / patch.speed, rtol=1e-12
    )


@pytest.mark.parametrize("shift", [-4e-3, 0.0, 3e-3])
def test_on_a_round_head_the_spin_follows_the_angle(shift):
    """A strip at the angle g on a rail's round head, by its place on the circle; with the roll q and the
    rotations w about the axle and r about the vertical it spins with (r cos g - w sin(g + q)) / V_ref.  The
    elastic wheel moves along the rail in the mean only: with the lateral velocity v and the vertical one u
    that it has at the strip its creepage is (v cos g - u sin g) / V_ref."""
    system = cone_system(0.05, tangential_model="polach", contact_mode="elastic")
    outputs, work, _ = rolled(system, lateral_shift=shift)
    patch, strips = strips_of(work, outputs, 1)
    rail_y, roll = system.profile_tables()[2], outputs.roll
    across, down = strips["places"][:, 1] - rail_y, HEAD - strips["places"][:, 2]
    np.testing.assert_allclose(np.hypot(across, down), HEAD, rtol=1e-9)
    angle = -np.arctan2(across, down)
    assert np.ptp(angle) > 0.02
    rate, turning = MOTION["speed"] / 0.46, MOTION["yaw_rate"] + MOTION["speed"] * MOTION["track_curvature"]
    np.testing.assert_allclose(
        strips["spin"] * patch.speed, turning * np.cos(angle) - rate * np.sin(angle + roll), rtol=0, atol=1e-9
    )
    arm = strips["places"][:, 1:] - (shift, outputs.vertical_shift - 0.46)
    motion = work.sides[1].motion
    v = MOTION["lateral_velocity"] - motion.turn_x * arm[:, 1]  # the strips have no place along the track
    u = motion.vertical + motion.turn_x * arm[:, 0]
    np.testing.assert_allclose(
        strips["lateral"] * patch.speed, v * np.cos(angle) - u * np.sin(angle), rtol=0, atol=1e-9
    )
