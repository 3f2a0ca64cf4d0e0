"""Creepages of profiles that are not cones: finite displacements, symmetry, the half-space."""

import math

import numpy as np
import pytest

import wrcontact
from tests.helpers.cases import MODELS, system
from tests.helpers.motion import creepages
from wrcontact.interface.inputs import MOTION as MOTION_INPUTS
from wrcontact.interface.inputs import RAILS

RADIUS = 0.46
#: A motion in which everything moves.
MOTION = dict(speed=25.0, lateral_velocity=0.04, yaw_rate=0.06, wheel_rate=55.0, track_curvature=1 / 400)
#: Tread, flange root and flange with yaw, and two patches.
POSES = [(1e-3, 0.0), (-3e-3, 0.004), (5.2e-3, -0.01), (7e-3, 0.035), (-6.5e-3, -0.02), (5e-3, 0.0)]


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("shift, yaw", POSES)
def test_velocities_are_those_of_finite_displacements(shift, yaw, model):
    """Of a compliant wheelset, which is told all velocities: the wheel's surface at the centre of load is
    moved with the wheelset. The place on the surface is that of the centre, at the rolling radius."""
    stand = system(contact_mode="elastic", normal_model=model).evaluate(shift, yaw)
    given = dict(vertical_velocity=-0.03, roll_rate=0.05, **MOTION)
    state = system(contact_mode="compliant", normal_model=model).evaluate(
        shift, yaw, vertical_shift_input=stand.vertical_shift, roll_input=stand.roll, **given
    )
    moves = dict(
        centre=np.array([0.0, shift, state.vertical_shift - RADIUS]),
        yaw=yaw,
        roll=state.roll,
        speed=25.0,
        wheel_rate=55.0,
        lateral=0.04,
        vertical=-0.03,
        yaw_rate=0.06,
        roll_rate=0.05,
        curvature=1 / 400,
    )
    for sign, wheel in ((-1, state.left), (1, state.right)):
        for patch in wheel.patches:
            expected = creepages(
                place=(patch.x_track, patch.y_track, patch.z_track),
                sign=sign,
                radius=patch.rolling_radius,
                angle=patch.contact_angle,
                **moves,
            )
            found = patch.creepage.x, patch.creepage.y, patch.creepage.spin
            # differences over 1e-6 s, and the depth of the place times the rates
            np.testing.assert_allclose(found, expected, rtol=0, atol=1e-6)


def test_rolling_backwards():
    """Speed and rotation of the other sign, nothing else moving: the creepages change sign."""
    forth = system().evaluate(3e-3, 0.01, speed=20.0)
    back = system().evaluate(3e-3, 0.01, speed=-20.0)
    for here, there in zip(forth.right.patches, back.right.patches):
        for name in ("x", "y", "spin"):
            assert getattr(here.creepage, name) == -getattr(there.creepage, name)


def test_no_motion_no_creepages():
    still = system().evaluate(3e-3, 0.01, lateral_velocity=1.0, yaw_rate=1.0)
    for patch in (*still.left.patches, *still.right.patches):
        assert (patch.creepage.x, patch.creepage.y, patch.creepage.spin) == (0.0, 0.0, 0.0)


def test_locked_and_spinning_wheels():
    """A wheelset that does not turn slides by all its speed, which is twice V_ref; one that spins where it
    stands, by minus that."""
    locked = system().evaluate(1e-3, speed=20.0, free_rolling=False)
    spinning = system().evaluate(1e-3, wheel_rate=30.0)
    for patch in locked.right.patches:
        assert patch.creepage.x == pytest.approx(2.0, rel=1e-12)
        assert patch.creepage.spin == 0.0
    for patch in spinning.right.patches:
        assert patch.creepage.x == pytest.approx(-2.0, rel=1e-12)


@pytest.mark.parametrize("mode", ["rigid", "elastic"])
def test_halfspace(mode):
    """At the centre of load of its own patches, which ANALYN finds within 0.1 mm on the tread."""
    motion = dict(lateral_shift=3e-3, yaw=5e-3, **MOTION)
    exact = system(contact_mode=mode, normal_model="halfspace", tolerance=0.02).evaluate(**motion)
    model = system(contact_mode=mode, normal_model="analyn").evaluate(**motion)
    for side in ("left", "right"):
        found, wanted = (getattr(state, side).patches[0].creepage for state in (exact, model))
        assert found.x == pytest.approx(wanted.x, abs=2e-5)
        assert found.y == pytest.approx(wanted.y, rel=1e-3)
        assert found.spin == pytest.approx(wanted.spin, rel=0.01, abs=1e-3)


def test_rotation_of_wheels_is_given_or_follows():
    follows = system().evaluate(1e-3, speed=20.0)
    given = system().evaluate(1e-3, speed=20.0, wheel_rate=20.0 / RADIUS)
    np.testing.assert_array_equal(follows.values, given.values)


@pytest.mark.parametrize("row", [*RAILS, *MOTION_INPUTS], ids=lambda row: row.name)
def test_not_a_number_is_refused(row):
    """Infinite values neither, in any contact mode."""
    for mode, value in (("rigid", math.nan), ("elastic", -math.inf), ("compliant", math.nan)):
        state = system(contact_mode=mode).evaluate(**{row.keyword: value})
        assert state.status == 4
        assert f"{row.name} is {value}" in wrcontact.status.explain(4, state.inputs)


@pytest.mark.parametrize("mode", ["rigid", "elastic"])
@pytest.mark.parametrize("side", ["left", "right"])
def test_one_side_alone(side, mode):
    """Its creepages need both contacts, whether the other side is wanted or not."""
    one = system(contact_mode=mode, normal_model="hertz")
    both, alone = (one.evaluate(5e-3, 0.01, side=wanted, **MOTION) for wanted in ("both", side))
    for mine, other in zip(getattr(both, side).patches, getattr(alone, side).patches):
        for name in ("x", "y", "spin"):
            assert getattr(mine.creepage, name) == getattr(other.creepage, name) != 0.0
