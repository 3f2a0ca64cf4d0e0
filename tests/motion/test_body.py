"""Inputs from a spinning body: closed forms, and rates against matrices that turn."""

import math

import numpy as np
import pytest

import wrcontact

RADIUS = 0.46


def about(axis, angle):
    """The rotation matrix about an axis of the track, x, y or z."""
    first, second = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    matrix = np.eye(3)
    matrix[first, first] = matrix[second, second] = math.cos(angle)
    matrix[second, first], matrix[first, second] = math.sin(angle), -math.sin(angle)
    return matrix


def attitude(yaw, roll, spin):
    """Rz(yaw) Rx(roll) Ry(-spin): a wheelset that rolls forward turns about minus its axle."""
    return about("z", yaw) @ about("x", roll) @ about("y", -spin)


@pytest.mark.parametrize("seed", range(8))
def test_rates_of_a_matrix_that_turns(seed):
    """The angular velocity from R' R^T by differences, the rates as they were put in."""
    rng = np.random.default_rng(seed)
    yaw, roll, spin = rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1), rng.uniform(0.0, 6.0)
    yaw_rate, roll_rate, wheel_rate = rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0), rng.uniform(-60.0, 60.0)

    def at(time):
        return attitude(yaw + yaw_rate * time, roll + roll_rate * time, spin + wheel_rate * time)

    step = 1e-5
    turning = (8.0 * (at(step) - at(-step)) - (at(2 * step) - at(-2 * step))) / (12.0 * step) @ at(0.0).T
    omega = turning[2, 1], turning[0, 2], turning[1, 0]
    found = wrcontact.motion_of([3.0, 2e-3, 1e-4 - RADIUS], at(0.0), [20.0, 0.1, -0.2], omega, lateral=5e-4)
    wanted = {
        "lateral_shift": 2e-3,
        "yaw": yaw,
        "vertical_shift_input": 1e-4,
        "roll_input": roll,
        "speed": 20.0,
        "lateral_velocity": 0.1,
        "vertical_velocity": -0.2,
        "yaw_rate": yaw_rate,
        "roll_rate": roll_rate,
        "wheel_rate": wheel_rate,
        "free_rolling": False,
        "left_rail_lateral": 5e-4,
        "right_rail_lateral": 5e-4,
    }
    assert found.keys() == wanted.keys()
    for name, value in wanted.items():
        assert found[name] == pytest.approx(value, rel=1e-9, abs=1e-9), name


def test_a_wheelset_that_rolls_straight():
    found = wrcontact.motion_of((0, 0, -0.5), np.eye(3).tolist(), (10, 0, 0), (0, -20, 0), nominal_radius=0.5)
    assert all(type(value) in (float, bool) for value in found.values())
    assert found == {**dict.fromkeys(found, 0.0), "speed": 10.0, "wheel_rate": 20.0, "free_rolling": False}
    state = wrcontact.ContactSystem(nominal_radius=0.5).evaluate(**found)
    free = wrcontact.ContactSystem(nominal_radius=0.5).evaluate(speed=10.0)
    assert np.array_equal(state.values, free.values)


def test_wheels_that_do_not_turn_slide():
    """A wheel_rate of 0 is taken as it is."""
    found = wrcontact.motion_of((0, 0, -RADIUS), np.eye(3), (10, 0, 0), (0, 0, 0))
    state = wrcontact.ContactSystem().evaluate(**found)
    assert state.right.patches[0].creepage.x == pytest.approx(2.0, rel=1e-9)  # V / (V / 2)


def test_power_of_the_forces_is_that_of_friction():
    """What the forces take from the body, F . v + M . w, is the friction power of its wheels."""
    rotation = attitude(4e-3, 3e-4, 1.7)
    # a wheelset that stays on its rails: rates that follow from contact
    system = wrcontact.ContactSystem(tangential_model="strips")
    turning = [1e-3, -20.02 / RADIUS, 5e-3]
    motion = wrcontact.motion_of([0, 2e-3, -RADIUS], rotation, [20.0, 0.01, 0.0], turning)
    state = system.evaluate(**motion)
    soon = 1e-4  # [s]
    high, low = (
        system.evaluate(
            **{
                **motion,
                "lateral_shift": 2e-3 + way * soon * motion["lateral_velocity"],
                "yaw": motion["yaw"] + way * soon * motion["yaw_rate"],
            }
        )
        for way in (1, -1)
    )
    sinking, rolling = (
        (getattr(high, name) - getattr(low, name)) / (2.0 * soon) for name in ("vertical_shift", "roll")
    )
    axle = about("z", motion["yaw"]) @ about("x", state.roll) @ np.array([0.0, 1.0, 0.0])
    ahead = np.array([math.cos(motion["yaw"]), math.sin(motion["yaw"]), 0.0])
    omega = np.array([0.0, 0.0, motion["yaw_rate"]]) + rolling * ahead - motion["wheel_rate"] * axle
    power = np.dot(state.force, [20.0, 0.01, sinking]) + np.dot(state.moment, omega)
    assert -power == pytest.approx(state.left.friction_power + state.right.friction_power, rel=2e-3)


@pytest.mark.parametrize(
    "change, words",
    [
        ({"position": [0, 1]}, "position is"),
        ({"velocity": 3.0}, "velocity is"),
        ({"angular_velocity": ["a", 1, 2]}, "angular_velocity is"),
        ({"rotation": np.ones(3)}, "3 x 3"),
        ({"rotation": 2 * np.eye(3)}, "length 2"),
        ({"rotation": np.eye(3)[[0, 2, 1]]}, "vertical"),
    ],
)
def test_what_is_refused(change, words):
    given = {
        "position": [0, 0, -RADIUS],
        "rotation": np.eye(3),
        "velocity": [1, 0, 0],
        "angular_velocity": [0, 0, 0],
    }
    with pytest.raises(ValueError, match=words):
        wrcontact.motion_of(**given | change)
