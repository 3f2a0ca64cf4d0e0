"""One wheel on one rail: the sides of a wheelset, the mirror, and a wheel that rolls by itself."""

import inspect
import random

import numpy as np
import pytest

import wrcontact
from tests.helpers.inside import counts_of
from tests.helpers.mirror import side_signs
from wrcontact import ContactSystem, Status, WheelContact
from wrcontact.interface.one_wheel import own_name, wheel_inputs

MODEL = {"tangential_model": "strips", "contact_damping": 0.4}
#: How far inputs are drawn to either side of 0, or from which value to which.
SIZES = {
    "lateral_shift": 5e-3,
    "yaw": 0.02,
    "vertical_shift_input": (1e-4, 3e-4),
    "roll_input": 1e-4,
    "speed": (5.0, 40.0),
    "lateral_velocity": 0.1,
    "vertical_velocity": 0.02,
    "yaw_rate": 0.1,
    "roll_rate": 0.05,
    "track_curvature": 2e-3,
    "wheel_rate": (10.0, 90.0),
}
OF_RAIL = {
    "rail_lateral": 2e-3,
    "rail_vertical": 2e-4,
    "rail_roll": 5e-3,
    "rail_lateral_velocity": 0.05,
    "rail_vertical_velocity": 0.05,
    "rail_roll_velocity": 0.5,
    "friction": (0.1, 0.5),
}


def drawn(draw, sizes):
    return {
        name: draw.uniform(*size) if isinstance(size, tuple) else draw.uniform(-size, size)
        for name, size in sizes.items()
    }


def poses(count, seed):
    """Seeded (motion of the wheelset, {side: motion of its rail, and its friction})."""
    draw = random.Random(seed)
    return [
        (drawn(draw, SIZES), {side: drawn(draw, OF_RAIL) for side in ("left", "right")}) for _ in range(count)
    ]


def numbers(wheel):
    """All outputs of a wheel (m,), or of a wheelset's side."""
    return np.array([wheel[name] for name in wheel.names])


@pytest.mark.parametrize(
    "model",
    [
        {"normal_model": "hertz", "tangential_model": "polach"},
        {"normal_model": "analyn", **MODEL},
        {"normal_model": "analyn_strip", **MODEL},
    ],
)
def test_two_single_wheels_are_a_wheelset(model):
    """To 1e-12 of the largest number of each unit; both rails move, each in its own way."""
    whole = ContactSystem(contact_mode="compliant", **model)
    wheels = {side: WheelContact(side=side, **model) for side in ("left", "right")}
    loaded = 0
    for motion, rails in poses(60, seed=11):
        given = {f"{side}_{name}": value for side, rail in rails.items() for name, value in rail.items()}
        both = whole.evaluate(**motion, **given)
        singles = {side: wheel.evaluate(**motion, **rails[side]) for side, wheel in wheels.items()}
        assert both.status == max(one.status for one in singles.values()), (motion, rails)
        if both.status > Status.UNLOADED:
            continue
        loaded += both.status == Status.VALID
        for side, one in singles.items():
            wanted = np.array([both[f"{side}.{name}"] for name in one.names])
            np.testing.assert_allclose(
                numbers(one), wanted, rtol=1e-12, atol=1e-12, err_msg=f"{side} {motion} {rails}"
            )
        for name in ("force", "moment"):
            summed = sum(np.asarray(getattr(one, name)) for one in singles.values())
            np.testing.assert_allclose(
                summed, np.asarray(getattr(both, name)), rtol=1e-12, atol=1e-7, err_msg=f"{motion} {rails}"
            )
        assert sum(one.driving_torque for one in singles.values()) == pytest.approx(
            both.driving_torque, rel=1e-12, abs=1e-7
        )
    assert loaded > 20


def test_a_left_wheel_is_the_mirror_image_of_a_right_one():
    mirrored = (
        "lateral_shift",
        "yaw",
        "roll_input",
        "lateral_velocity",
        "yaw_rate",
        "roll_rate",
        "track_curvature",
        "rail_lateral",
        "rail_roll",
        "rail_lateral_velocity",
        "rail_roll_velocity",
    )
    right, left = (WheelContact(side=side, **MODEL) for side in ("right", "left"))
    for motion, rails in poses(10, seed=12):
        given = {**motion, **rails["right"]}
        one = right.evaluate(**given)
        other = left.evaluate(
            **{name: -value if name in mirrored else value for name, value in given.items()}
        )
        assert one.status == other.status, given
        np.testing.assert_allclose(
            numbers(other), numbers(one) * side_signs(), rtol=1e-12, atol=1e-9, err_msg=str(given)
        )


def test_a_wheel_that_rolls_freely_has_no_longitudinal_force():
    """Its rotation is the speed over the radius where its load is; one that is locked slides with the whole
    friction, which turns it forward."""
    pose = {"lateral_shift": 1e-3, "vertical_shift_input": 1.4e-4, "speed": 20.0, "friction": 0.3}
    wheel = WheelContact(tangential_model="strips")
    rates = np.array([0.999, 1.001]) * 20.0 / wheel.evaluate(**pose).patches[0].rolling_radius
    for _ in range(6):  # secant
        torques = np.array([wheel.evaluate(wheel_rate=rate, **pose).driving_torque for rate in rates])
        if torques[0] == torques[1]:
            break
        slope = (torques[1] - torques[0]) / (rates[1] - rates[0])
        rates = np.array([rates[1], rates[1] - torques[1] / slope])
    free = wheel.evaluate(wheel_rate=rates[1], **pose)
    limit = 0.3 * free.normal_force
    assert abs(free.driving_torque) < 1e-6 * limit and abs(free.force.x) < 2e-3 * limit
    assert rates[1] == pytest.approx(20.0 / free.patches[0].rolling_radius, rel=2e-5)
    locked = wheel.evaluate(wheel_rate=0.0, free_rolling=False, **pose)
    assert locked.force.x == pytest.approx(-limit, rel=1e-3)
    assert locked.driving_torque == pytest.approx(limit * locked.patches[0].rolling_radius, rel=2e-3)
    driven = wheel.evaluate(wheel_rate=1.01 * rates[1], **pose)
    assert driven.force.x > 0.5 * limit and driven.driving_torque < 0.0


def test_one_wheel_costs_half():
    """Neither gaps nor nodes of the other wheel are computed."""
    motion, _ = poses(1, seed=13)[0]
    found = {}
    for side in ("left", "right", "both"):
        stepper = ContactSystem(contact_mode="compliant").stepper(side)
        for name, value in motion.items():
            stepper.inputs[stepper.place(name)] = value
        assert stepper.step() <= Status.UNLOADED
        found[side] = counts_of(stepper)
    for name in ("gap", "scan", "node"):
        assert found["left"][name] + found["right"][name] == found["both"][name], (name, found)
    assert min(found["left"]["gap"], found["right"]["gap"]) > 0


def test_the_other_wheel_does_not_matter():
    """A wheelset is off its profiles where the flange of one wheel is in its rail; the other wheel alone is
    not."""
    whole = ContactSystem(contact_mode="compliant")
    pose = {"vertical_shift_input": 2e-4}
    assert whole.evaluate(**pose, left_rail_lateral=0.05).status == Status.OFF_PROFILE
    assert WheelContact(side="left").evaluate(**pose, rail_lateral=0.05).status == Status.OFF_PROFILE
    one = WheelContact().evaluate(**pose)
    alone = whole.evaluate(**pose, left_rail_lateral=0.05, side="right")
    assert one.status == alone.status == Status.VALID and one.normal_force == alone.right.normal_force > 1e4


def test_tables_steppers_and_derivatives_agree_with_single_poses():
    wheel = WheelContact(side="left", tangential_model="strips")
    shifts = np.linspace(-2e-3, 2e-3, 5)
    pose = {
        "vertical_shift_input": 1.4e-4,
        "speed": 20.0,
        "wheel_rate": 43.6,
        "rail_lateral": 1e-4,
        "friction": 0.25,
    }
    table = wheel.evaluate_many(lateral_shift=shifts, **pose)
    some = wheel.evaluate_many(lateral_shift=shifts, outputs=["force", "status"], **pose)
    assert some.names == ("force.x", "force.y", "force.z")
    stepper = wheel.stepper("patches")
    for k, shift in enumerate(shifts):
        one = wheel.evaluate(lateral_shift=shift, **pose)
        np.testing.assert_array_equal(numbers(table[k]), numbers(one))
        assert some["force.y"][k] == table.force.y[k] == one.force.y
        for name, row in wheel_inputs("left").items():
            stepper.inputs[stepper.place(row.name)] = one.inputs[name]
        assert stepper.step() == one.status
        assert stepper.outputs[stepper.place("left.moment.x")] == one.moment.x
    assert one.to_dict()["driving_torque"] == one.driving_torque and one.inputs["friction"] == 0.25
    slopes = wheel.derivatives(["force.y", "driving_torque"], ["rail_lateral", "wheel_rate"], **pose)
    for k, (name, step) in enumerate({"rail_lateral": 1e-8, "wheel_rate": 1e-6}.items()):
        ahead, behind = (wheel.evaluate(**{**pose, name: pose[name] + sign * step}) for sign in (1, -1))
        expected = [
            (ahead.force.y - behind.force.y) / (2 * step),
            (ahead.driving_torque - behind.driving_torque) / (2 * step),
        ]
        np.testing.assert_allclose(slopes[:, k], expected, rtol=1e-4)


def test_names_of_one_wheel():
    shown = list(inspect.signature(WheelContact.evaluate).parameters)
    assert shown[1:-1] == list(wheel_inputs("right")) == list(wheel_inputs("left"))
    assert {"lateral_shift", "wheel_rate", "rail_lateral", "friction"} < set(shown)
    assert own_name("right.friction", "left") == "" and own_name("left.friction", "left") == "friction"
    assert repr(WheelContact("cone20", side="left")).startswith("WheelContact(side='left', wheel='cone20'")


@pytest.mark.parametrize(
    "given, words",
    [
        ({"contact_mode": "rigid"}, "contact_mode is 'rigid'; permitted with one wheel is 'compliant'"),
        ({"load": "vertical"}, "load cannot be given for one wheel: its load follows"),
        (
            {"left_wheel": "S1002"},
            "left_wheel cannot be given for one wheel, which has wheel, and side='left'",
        ),
        ({"rail": ("UIC60", "54E1")}, "rail is .*; permitted with one wheel is one value"),
        ({"side": "both"}, "side is 'both'; permitted are 'left', 'right'"),
    ],
)
def test_parameters_without_meaning_are_refused(given, words):
    with pytest.raises(ValueError, match=words):
        WheelContact(**given)


@pytest.mark.parametrize(
    "name, words",
    [
        ("normal_force", "one wheel has no input 'normal_force': its load follows from its height"),
        ("roll_guess", "one wheel has no input 'roll_guess': its roll is given"),
        ("right_friction", "there is no input 'right_friction'; inputs of one wheel are lateral_shift, "),
    ],
)
def test_inputs_without_meaning_are_refused(name, words):
    with pytest.raises(TypeError, match=words):
        WheelContact().evaluate(**{name: 0.1})
    assert wrcontact.WheelContact is WheelContact


@pytest.mark.parametrize("name", ["left.force.z", "force_z"])
def test_an_unknown_output_is_refused_by_the_wheel_s_own_names(name):
    with pytest.raises(ValueError) as refusal:
        WheelContact(side="left").derivatives(of=[name], by=["yaw"], vertical_shift_input=2e-4)
    assert str(refusal.value) == (
        f"of has {name!r}; permitted are names of one wheel's outputs; did you mean force.z?"
    )
