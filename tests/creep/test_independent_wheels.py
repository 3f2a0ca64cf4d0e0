"""Wheelsets whose wheels turn by themselves."""

import random

import numpy as np
import pytest

from wrcontact import ContactSystem, Status, WheelContact, explain

STRIPS = {"tangential_model": "strips"}
POSE = {"lateral_shift": 3e-3, "speed": 20.0}


def couple(state):
    """Longitudinal creep forces that turn a wheelset to the left [N]."""
    return state.right.patches[0].tangential.x - state.left.patches[0].tangential.x


def pair(mode="rigid", **more):
    """A wheelset, and the same with independent wheels."""
    return tuple(
        ContactSystem(contact_mode=mode, independent_wheels=independent, **STRIPS, **more)
        for independent in (False, True)
    )


@pytest.mark.parametrize("mode", ["rigid", "elastic", "compliant"])
def test_equal_rates_have_the_bits_of_one_rate(mode):
    """Each is read in its own case only; with one torque on both wheels their rates would not be equal."""
    usual, independent = pair(mode, nominal_rolling=True)
    draw = random.Random(31)
    for _ in range(6):
        pose = {
            "lateral_shift": draw.uniform(-5e-3, 5e-3),
            "yaw": draw.uniform(-0.02, 0.02),
            "speed": draw.choice([0.0, 20.0, -20.0]),
            "track_curvature": draw.uniform(-2e-3, 2e-3),
            "vertical_shift_input": draw.uniform(1e-4, 3e-4),
            "free_rolling": draw.random() < 0.7,
        }
        for rate in (0.0, draw.uniform(-50.0, 50.0)):
            one = usual.evaluate(**pose, wheel_rate=rate, left_wheel_rate=3.0, right_wheel_rate=-4.0)
            two = independent.evaluate(**pose, wheel_rate=5.0, left_wheel_rate=rate, right_wheel_rate=rate)
            np.testing.assert_array_equal(one.values, two.values, err_msg=f"{pose} {rate}")
            assert one.status == two.status <= Status.UNLOADED
    assert not usual.parameters["independent_wheels"] and independent.parameters["independent_wheels"]


def free_rates(system, **pose):
    """Rates [rad/s] at which neither wheel has a torque, by secants."""

    def torques(rates):
        state = system.evaluate(**pose, left_wheel_rate=rates[0], right_wheel_rate=rates[1])
        return np.array([state.left.driving_torque, state.right.driving_torque])

    before = np.full(2, pose["speed"] / 0.46)
    rates, was = before * 1.0001, torques(before)
    for _ in range(12):
        now = torques(rates)
        if np.abs(now).max() < 1e-6:
            break
        rates, before, was = rates - now * (rates - before) / (now - was), rates, now
    return rates


def test_wheels_that_roll_freely_have_no_couple():
    """A wheelset off its centre steers, since its wheels have one rate and two radii; independent wheels turn
    with their own radii, and do not."""
    usual, independent = pair()
    rates = free_rates(independent, **POSE)
    free = independent.evaluate(**POSE, left_wheel_rate=rates[0], right_wheel_rate=rates[1])
    steered = usual.evaluate(**POSE, wheel_rate=rates.mean())
    radii = [wheel.patches[0].rolling_radius for wheel in (free.left, free.right)]
    assert rates * radii == pytest.approx(20.0, rel=3e-4) and rates[0] > rates[1] * 1.001
    assert couple(steered) > 5e3 and abs(couple(free)) < 0.02 * couple(steered)
    assert abs(free.driving_torque) < 1e-5


def test_torques_are_those_of_each_wheel():
    """A wheel that is driven has a negative one, a braked one a positive one; both are the wheelset's."""
    _, independent = pair()
    state = independent.evaluate(lateral_shift=0.0, speed=20.0, left_wheel_rate=43.2, right_wheel_rate=43.8)
    left, right = state.left.driving_torque, state.right.driving_torque
    assert right < -5e3 and left > 5e3 and state.driving_torque == left + right
    for wheel in (state.left, state.right):
        assert wheel.driving_torque == pytest.approx(-0.46 * wheel.force.x, rel=0.01)
    assert state.moment.z == pytest.approx(-1.5 * state.right.force.x, rel=0.01)


def test_rates_of_zero_are_those_of_each_wheel_s_radius():
    _, independent = pair(left_nominal_radius=0.459, nominal_rolling=True)
    radii = [independent.side_parameters(side)["nominal_radius"] for side in ("left", "right")]
    assert radii[0] != radii[1]
    given = {f"{side}_wheel_rate": 20.0 / radius for side, radius in zip(("left", "right"), radii)}
    np.testing.assert_array_equal(
        independent.evaluate(**POSE).values, independent.evaluate(**POSE, **given).values
    )


def test_one_wheel_turns_while_the_wheelset_stands():
    _, independent = pair()
    state = independent.evaluate(lateral_shift=1e-3, right_wheel_rate=10.0)
    assert state.left.patches[0].creepage.x == state.left.force.x == state.left.driving_torque == 0.0
    # it spins on the spot: its circumference moves twice as fast as the mean
    assert state.right.patches[0].creepage.x == pytest.approx(-2.0, rel=1e-6) and state.right.force.x > 2e4


def test_a_side_is_a_wheel_by_itself():
    independent = ContactSystem(contact_mode="compliant", independent_wheels=True, **STRIPS)
    pose = {**POSE, "vertical_shift_input": 2e-4, "yaw": 0.01}
    both = independent.evaluate(**pose, left_wheel_rate=43.4, right_wheel_rate=43.7)
    for side, rate in (("left", 43.4), ("right", 43.7)):
        one = WheelContact(side=side, **STRIPS).evaluate(**pose, wheel_rate=rate)
        np.testing.assert_allclose(
            [one[name] for name in one.names],
            [both[f"{side}.{name}"] for name in one.names],
            rtol=1e-12,
            atol=1e-12,
        )


def test_derivatives_by_the_rate_of_one_wheel():
    _, independent = pair()
    pose = {**POSE, "left_wheel_rate": 43.45, "right_wheel_rate": 43.5}
    of = ["left.driving_torque", "right.driving_torque", "moment.z"]
    found = independent.derivatives(of, ["left.wheel_rate", "right.wheel_rate", "wheel_rate"], **pose)
    for k, name in enumerate(("left_wheel_rate", "right_wheel_rate")):
        ahead, behind = (independent.evaluate(**{**pose, name: pose[name] + step}) for step in (1e-5, -1e-5))
        expected = [(ahead[one] - behind[one]) / 2e-5 for one in of]
        np.testing.assert_allclose(found[:, k], expected, rtol=1e-4, atol=1.0)
    assert found[1, 0] == found[0, 1] == 0.0 and not found[:, 2].any() and found[0, 0] < -1e4


def test_what_is_refused():
    _, independent = pair()
    state = independent.evaluate(**POSE, left_wheel_rate=2001.0)
    assert state.status == Status.INVALID_INPUT
    assert explain(state.status, state.inputs).startswith(
        "left.wheel_rate is 2001 rad/s; permitted is |left.wheel_rate| <= 2000 rad/s"
    )
    for wrong in (1, "yes", None):
        with pytest.raises(ValueError, match="independent_wheels is .*; permitted is True or False"):
            ContactSystem(independent_wheels=wrong)
    with pytest.raises(
        ValueError, match="independent_wheels cannot be given for one wheel: it turns by its own wheel_rate"
    ):
        WheelContact(independent_wheels=True)
