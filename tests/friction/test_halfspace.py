"""Creep forces of a wheelset by the complete theory, in the place of the kernel's models."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.inside import work_of
from wrcontact.halfspace import rolling_step
from wrcontact.halfspace.rolling.extrapolation import roll_ellipse
from wrcontact.halfspace.rolling_step import roll_strips
from wrcontact.interface.outputs import SIDES

POSE = {"lateral_shift": 3e-3, "yaw": 4e-3, "speed": 20.0, "lateral_velocity": 0.02}


@pytest.fixture(scope="module")
def states():
    """The wheelset by the complete theory and by FASTSIM."""
    return [wrcontact.ContactSystem(tangential_model=model).evaluate(**POSE)
            for model in ("halfspace", "fastsim")]


def test_forces_are_near_those_of_the_models(states):
    """FASTSIM is within some per cent of mu N of the complete theory; contact and creepages are the same."""
    exact, fast = states
    for side in SIDES:
        one, other = getattr(exact, side).patches[0], getattr(fast, side).patches[0]
        assert one.creepage.x == other.creepage.x and one.normal_force == other.normal_force
        limit = 0.3 * one.normal_force
        off = np.hypot(one.tangential.x - other.tangential.x, one.tangential.y - other.tangential.y)
        assert 0.0 < off < 0.06 * limit
        force = np.hypot(one.tangential.x, one.tangential.y)
        assert one.saturation == pytest.approx(force / limit, rel=1e-12)


def test_resultants_take_them_up(states):
    exact, fast = states
    np.testing.assert_array_equal(exact.normal.force, fast.normal.force)
    np.testing.assert_array_equal(exact.normal.moment, fast.normal.moment)
    longitudinal = sum(getattr(exact, side).patches[0].tangential.x for side in SIDES)
    assert exact.force.x == pytest.approx(longitudinal, rel=1e-12)
    assert exact.right.force.y == pytest.approx(exact.right.patches[0].force.y, rel=1e-12)
    for side in (exact.left, exact.right):
        outline = side.outline
        power = np.trapezoid(outline.shear * outline.slip * 2 * outline.half_length, outline.station)
        # strips and stations are coarse, and their elastic power is left out
        assert power == pytest.approx(side.friction_power, rel=0.05)


def test_an_ellipse_of_strips_is_that_ellipse():
    """Strips of a Hertz patch, put together again, have the force of the ellipse itself."""
    system = wrcontact.ContactSystem(normal_model="hertz", tangential_model="polach")
    stepper = system.stepper()
    stepper.inputs[:] = system.evaluate(1e-3, speed=20.0, lateral_velocity=0.03).inputs
    assert stepper.step() == 0
    work = work_of(stepper)
    patch = work.sides[1].patches[0]
    for strip in patch.strips:
        strip.slip = patch.creepage_x - patch.spin * strip.y
        strip.x = 0.0
    material = {"shear_modulus": 210e9 / 2.56, "poisson_ratio": 0.28}
    exact = roll_ellipse(patch.half_length, patch.half_width, patch.totals.load, creepage_x=patch.creepage_x,
                         creepage_y=patch.creepage_y, spin=patch.spin, friction=patch.friction, **material)
    roll_strips(patch, **material)
    found = np.array([patch.creep_x, patch.creep_y])
    # both are extrapolated from the same numbers of cells
    np.testing.assert_allclose(found, [exact.force_x, exact.force_y],
                               atol=2e-3 * patch.friction * patch.totals.load, rtol=0)


def test_backwards_is_the_mirror_image():
    """On the way back with the opposite yaw the forces along the track are reversed."""
    system = wrcontact.ContactSystem(tangential_model="halfspace")
    there = system.evaluate(lateral_shift=2e-3, speed=20.0, lateral_velocity=0.02).right
    back = system.evaluate(lateral_shift=2e-3, speed=-20.0, lateral_velocity=0.02).right
    limit = 0.3 * there.normal_force
    assert back.force.x == pytest.approx(-there.force.x, abs=1e-6 * limit)
    assert back.force.y == pytest.approx(there.force.y, abs=1e-6 * limit)


def test_what_it_does_not_know():
    with pytest.raises(ValueError, match="load is 'vertical'"):
        wrcontact.ContactSystem(tangential_model="halfspace", load="vertical")


def test_a_step_that_does_not_converge_keeps_the_last_outputs(monkeypatch):
    stepper = wrcontact.ContactSystem(tangential_model="halfspace").stepper()
    stepper.inputs[:] = wrcontact.ContactSystem().evaluate(**POSE).inputs
    assert stepper.step() == 0
    good = stepper.outputs.copy()
    with monkeypatch.context() as broken:
        broken.setattr(rolling_step, "roll_strips", fail)
        stepper.inputs[0] = 2e-3
        assert stepper.step() == wrcontact.Status.NOT_CONVERGED
    np.testing.assert_array_equal(stepper.outputs, good)
    assert stepper.step() == 0
    assert np.any(stepper.outputs != good)
    stepper.inputs[0] = POSE["lateral_shift"]
    assert stepper.step() == 0
    # a start elsewhere leaves the contact's last digits, and the solver's tolerance
    np.testing.assert_allclose(stepper.outputs, good, rtol=1e-3, atol=30.0)


def fail(*_, **__):
    raise ArithmeticError("no convergence")
