"""Towards standstill: creep forces keep their limit, and depend on the inputs of their step alone."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.cases import CREEP_MODELS

MODES = ("rigid", "elastic", "compliant")
#: A wheelset against a flange whose rates across are in proportion to its speed [1, 1/m].
POSE = {"lateral_shift": -6e-3, "yaw": 2e-3}
ACROSS, TURNING = 1.5e-3, 0.2
#: Speeds of a wheelset that brakes to a stop [m/s]; the last one is rest.
SPEEDS = np.append(np.geomspace(1e-3, 1e-15, 49), 0.0)


def system(model, mode="rigid", **parameters):
    return wrcontact.ContactSystem(
        wheel="S1002", rail="60E1", tangential_model=model, contact_mode=mode, **parameters
    )


def pose(mode):
    if mode != "compliant":
        return POSE
    found = system("none", "elastic").evaluate(**POSE)
    return {**POSE, "vertical_shift_input": found.vertical_shift, "roll_input": found.roll}


def moving(speed):
    return {"speed": speed, "lateral_velocity": ACROSS * speed, "yaw_rate": TURNING * speed}


def forces_of(table):
    """Force and moment per 1 m, of each row."""
    return np.column_stack(
        [getattr(getattr(table, kind), axis) for kind in ("force", "moment") for axis in "xyz"]
    )


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("model", CREEP_MODELS)
def test_forces_depend_on_ratios_of_velocities_alone(model, mode):
    """With constant friction, so that they keep their limit on the way to rest; at rest there are none."""
    one = system(model, mode)
    table = one.evaluate_many(**pose(mode), **moving(SPEEDS))
    found = forces_of(table)
    usual = forces_of(one.evaluate_many(**pose(mode), **moving(np.array([10.0]))))[0]
    fast = SPEEDS >= 1e-9
    # 1e-12 m/s count as rolling; elastic rates across are differences over a micrometre
    np.testing.assert_allclose(found[fast], np.broadcast_to(usual, found[fast].shape), rtol=0, atol=1.0)
    rest = one.evaluate(**pose(mode))
    np.testing.assert_array_equal(found[-1], forces_of(one.evaluate_many(**pose(mode)))[0])
    assert rest.force.y == rest.normal.force.y and rest.right.patches[0].tangential.y == 0.0
    # and nothing jumps: neighbours differ by a factor of 1.8 in speed
    assert np.abs(np.diff(found[:, 1])).max() < 0.4 * 0.3 * 2 * 78.5e3
    power = table.left.friction_power[fast] / SPEEDS[fast]
    np.testing.assert_allclose(power, power[0], rtol=1e-4)


@pytest.mark.parametrize("model", CREEP_MODELS)
def test_a_step_does_not_see_those_before_it(model):
    """Speeds through standstill, in any order, by one thread or two: the same bits as each from scratch."""
    speeds = np.array([20.0, 1e-3, 2e-6, 9e-7, 1e-7, 1e-9, 1e-12, 1e-14])
    shifts = np.array([-6e-3, 1e-3, 5.5e-3])
    speed, shift = (each.ravel() for each in np.meshgrid(speeds, shifts))
    alone = np.array(
        [
            forces_of(system(model).evaluate_many(lateral_shift=y, speed=[v]))[0]
            for y, v in zip(shift[::5], speed[::5])
        ]
    )
    for order in (
        np.arange(len(speed)),
        np.arange(len(speed))[::-1],
        np.random.default_rng(1).permutation(24),
    ):
        for threads in (1, 2):
            table = system(model).evaluate_many(
                lateral_shift=shift[order], speed=speed[order], threads=threads
            )
            found = np.empty((len(order), 6))
            found[order] = forces_of(table)
            # forces of the pressures differ in last bits with where the search for the roll begins
            np.testing.assert_allclose(found[::5], alone, rtol=1e-9, atol=1e-6)


@pytest.mark.parametrize("model", CREEP_MODELS)
@pytest.mark.parametrize("speed", [1e-4, 1e-8, 0.0])
def test_a_wheelset_that_slides_sideways_has_coulombs_friction(model, speed):
    """mu N of each patch against its lateral velocity, however slowly it rolls."""
    one = system(model)
    state = one.evaluate(lateral_shift=1e-3, speed=speed, lateral_velocity=0.2, left_friction=0.4)
    # the wheelset rolls as it moves, about its centre 0.46 m above
    turn = (one.evaluate(lateral_shift=1.01e-3).roll - one.evaluate(lateral_shift=0.99e-3).roll) / 2e-5
    sliding = 0.2 * (1.0 - 0.46 * turn)
    for side, friction, against in ((state.left, 0.4, 1.0), (state.right, 0.3, -1.0)):
        patch = side.patches[0]
        # along, the rolling radii still differ; across, FASTSIM's spin turns the tractions
        assert patch.tangential.y == pytest.approx(against * friction * patch.normal_force, rel=2e-3)
        assert (patch.creepage.y != 0.0) == (speed != 0.0) == (side.wear_number != 0.0)
        assert side.friction_power == pytest.approx(friction * side.normal_force * sliding, rel=3e-3)


@pytest.mark.parametrize("model", CREEP_MODELS)
def test_slopes_towards_standstill(model):
    """A function of ratios: slopes times velocities sum to nothing (Euler), and grow as 1/V."""
    by, of = ["speed", "lateral_velocity", "yaw_rate"], ["force.x", "force.y", "moment.z"]
    slopes = {}
    for speed in (1.0, 1e-3, 5e-7, 1e-8):
        given = moving(speed)
        found = system(model).derivatives(of=of, by=by, **POSE, **given)
        size = np.abs(found * [given[name] for name in by]).max()
        np.testing.assert_allclose(found @ [given[name] for name in by], 0.0, atol=1e-6 * size)
        slopes[speed] = found * speed
    for speed in slopes:
        np.testing.assert_allclose(
            slopes[speed], slopes[1.0], rtol=1e-6, atol=1e-6 * np.abs(slopes[1.0]).max()
        )
