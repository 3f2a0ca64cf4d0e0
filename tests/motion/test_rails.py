"""Rails that move: only the motion of the wheelset against them counts."""

import numpy as np
import pytest

from tests.helpers.cases import system
from tests.helpers.motion import slips

POSE = dict(lateral_shift=5.4e-3, yaw=0.012)
RAILS = ("left_rail_", "right_rail_")


def both(**velocities):
    """The same velocities of both rails."""
    return {f"{rail}{name}_velocity": value for rail in RAILS for name, value in velocities.items()}


@pytest.mark.parametrize("mode", ["rigid", "elastic"])
def test_both_rails_move_to_one_side(mode):
    """Which is the wheelset moving to the other."""
    one = system(contact_mode=mode, normal_model="hertz")
    rails = slips(one.evaluate(**POSE, speed=20.0, **both(lateral=0.05)))
    wheelset = slips(one.evaluate(**POSE, speed=20.0, lateral_velocity=-0.05))
    np.testing.assert_allclose(rails, wheelset, rtol=0, atol=1e-14)


@pytest.mark.parametrize("mode", ["rigid", "elastic"])
def test_both_rails_move_down(mode):
    """And the wheelset with them: nothing slides."""
    one = system(contact_mode=mode, normal_model="hertz")
    moving = slips(one.evaluate(**POSE, speed=20.0, **both(vertical=0.3)))
    np.testing.assert_allclose(moving, slips(one.evaluate(**POSE, speed=20.0)), rtol=0, atol=1e-14)


@pytest.mark.parametrize("mode", ["rigid", "elastic"])
def test_the_track_rolls(mode):
    """Both rails roll about the track's origin, and the wheelset with them: its creepages are those of a
    wheelset whose centre moves sideways with them. A rail that rolls about its own highest point, and moves
    as this does, is a rail that rolls about the origin. (With a yaw it would turn about the axle, too.)"""
    one, rate, straight = system(contact_mode=mode, normal_model="hertz"), 0.04, {"lateral_shift": 5.4e-3}
    at = one.profile_tables()[2]
    state = one.evaluate(**straight)
    height = state.vertical_shift - 0.46
    track = {"left_rail_vertical_velocity": -rate * at, "right_rail_vertical_velocity": rate * at,
             **both(roll=rate)}
    rolling = slips(one.evaluate(**straight, speed=20.0, lateral_velocity=-rate * height, **track))
    np.testing.assert_allclose(rolling, slips(one.evaluate(**straight, speed=20.0)), rtol=0, atol=1e-13)


def test_a_compliant_wheelset_and_its_rails_move_together():
    one = system(contact_mode="compliant", normal_model="hertz")
    stand = system(contact_mode="elastic", normal_model="hertz").evaluate(**POSE)
    pose = dict(**POSE, vertical_shift_input=stand.vertical_shift, roll_input=stand.roll, speed=20.0)
    moving = one.evaluate(**pose, lateral_velocity=0.1, vertical_velocity=0.2,
                          **both(lateral=0.1, vertical=0.2))
    np.testing.assert_allclose(slips(moving), slips(one.evaluate(**pose)), rtol=0, atol=1e-14)


def test_one_rail_moves_out():
    """On the tread only its own wheel slides, by the velocity over the speed to first order."""
    one = system(normal_model="hertz")
    still = slips(one.evaluate(1e-3, speed=20.0))
    moved = slips(one.evaluate(1e-3, speed=20.0, right_rail_lateral_velocity=0.02)) - still
    # y_c points to the left, and the wheel slides to the left of its rail
    assert moved[1, 1] == pytest.approx(0.02 / 20.0, rel=0.05)
    assert abs(moved[0, 1]) < 0.05 * moved[1, 1]
