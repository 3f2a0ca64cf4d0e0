"""Inputs from a spinning body: closed forms, and rates against matrices that turn."""

import inspect
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


def small_rotation(turn):
    """exp of the cross product with ``turn`` (3,), by Rodrigues' formula."""
    angle = np.linalg.norm(turn)
    cross = np.cross(np.eye(3), turn)  # cross @ v is turn x v
    return np.eye(3) + np.sinc(angle / np.pi) * cross + (1 - math.cos(angle)) / angle**2 * cross @ cross


def moved(body, column, step):
    """(position, rotation, velocity, angular velocity) with a small change of one of the 12."""
    position, rotation, velocity, omega = body
    change = np.zeros((4, 3))
    change[divmod(column, 3)] = step
    turned = small_rotation(change[1]) @ rotation if change[1].any() else rotation
    return position + change[0], turned, velocity + change[2], omega + change[3]


@pytest.mark.parametrize("seed", range(4))
def test_jacobian_is_that_of_differences(seed):
    """Of every input by every change of the body, with a roll that is larger than any on a track."""
    rng = np.random.default_rng(seed)
    rotation = attitude(rng.uniform(-0.4, 0.4), rng.uniform(-0.4, 0.4), rng.uniform(0.0, 6.0))
    body = rng.normal(size=3), rotation, rng.normal(size=3), rng.normal(scale=20.0, size=3)
    rows = wrcontact.motion_jacobian(rotation, body[3])
    same = {"free_rolling", "left_rail_lateral", "right_rail_lateral"}  # which no motion changes
    assert set(rows) == set(wrcontact.motion_of(*body)) - same
    step = 1e-4
    for column in range(12):
        near = {
            way: wrcontact.motion_of(*moved(body, column, way * step)) for way in (-2, -1, 1, 2)
        }  # differences of fourth order
        for name, row in rows.items():
            at = {way: found[name] for way, found in near.items()}
            slope = (8.0 * (at[1] - at[-1]) - (at[2] - at[-2])) / (12.0 * step)
            assert row[column] == pytest.approx(slope, rel=1e-9, abs=1e-9), (name, column)


def test_jacobian_of_forces_by_the_body():
    """The product with the derivatives of the contact, against forces of a body that is moved."""
    system = wrcontact.ContactSystem(contact_mode="compliant", tangential_model="polach", contact_damping=1.0)
    stepper = system.stepper(outputs="patches")
    height = system.evaluate().equilibrium.vertical_shift
    body = (
        np.array([0.0, 1e-3, height - RADIUS]),
        attitude(2e-3, 1e-5, 0.7),
        np.array([20.0, 0.01, 0.0]),
        np.array([1e-3, -20.02 / RADIUS, 0.02]),
    )
    stepper.resultant(wrcontact.motion_of(*body))
    inputs, of = wrcontact.motion_jacobian(body[1], body[3]), ["force.y", "force.z", "moment.x", "moment.z"]
    slopes = stepper.derivatives(of=of, by=list(inputs)) @ np.array(list(inputs.values()))
    for column, step in zip(range(12), np.repeat((1e-9, 1e-9, 1e-6, 1e-6), 3)):  # [m], [rad], [m/s], [rad/s]
        forces = [
            np.concatenate(stepper.resultant(wrcontact.motion_of(*moved(body, column, way * step))))
            for way in (1, -1)
        ]
        change = (forces[0] - forces[1])[[1, 2, 3, 5]] / (2.0 * step)
        size = np.maximum(np.abs(change), 1e-3 * np.abs(slopes).max(axis=1))
        assert np.all(np.abs(slopes[:, column] - change) < 1e-4 * size), column


@pytest.mark.parametrize("function", (wrcontact.motion_of, wrcontact.motion_jacobian, wrcontact.low_pass))
def test_signatures_can_be_read(function):
    """`help` shows words, not what numpy makes of them: 1338 letters of motion_of."""
    assert "_NestedSequence" not in str(inspect.signature(function))
    assert len(str(inspect.signature(function))) < 220


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
