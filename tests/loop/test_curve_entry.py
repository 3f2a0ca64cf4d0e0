"""Into a curve: the steady state in closed form, and where a flange leads."""

import numpy as np
import pytest
from scipy.optimize import brentq

import wrcontact
from examples.hunting_wheelset.coupling import CONES, CONTACT, Loop
from examples.hunting_wheelset.curve_entry import RADIUS_OF_CURVE, SPEED, WHEELSET, enter, equilibrium
from examples.hunting_wheelset.hunting import elastic, rolling


@pytest.mark.parametrize("curvature", [1 / 2000, -1 / 3000])
def test_free_wheelset_finds_the_rolling_line(archives, curvature):
    """Nothing holds the wheelset, so that in the end neither wheel slides along the track: radii are as the
    ways on the rails, r_right / r_left = (1 - k y_right) / (1 - k y_left). It then has no yaw but for
    spin."""
    system = elastic(CONES)

    def unequal(shift):
        state = system.evaluate(lateral_shift=shift)
        right, left = (wheel.patches[0] for wheel in (state.right, state.left))
        return right.rolling_radius * (1 - curvature * left.y_track) - left.rolling_radius * (
            1 - curvature * right.y_track
        )

    line = brentq(unequal, -6e-3, 6e-3)
    conicity = rolling(system, 1e-3).conicity(5e-4)
    assert line == pytest.approx(-curvature * 0.7525 * 0.46 / conicity, rel=0.02)
    # a damper of the yaw, which acts on no steady state, lets the hunting die
    given = {
        "frame_speed": 10.0,
        "curve_curvature": curvature,
        "curve_start": 1.0,
        "transition_length": 8.0,
        "lateral_damping": 4e4,
    }
    with Loop(archives, given, CONES) as loop:
        loop.run(1.0, 2e-4)
        run = loop.run(3.3, 2e-4)  # two waves, whose mean is the steady state
    assert run.worst_status == 0
    assert run["lateral_shift"].mean() == pytest.approx(line, rel=0.05)


@pytest.mark.full
def test_steady_state_on_the_flange(archives):
    """The run through the transition ends where Python, without an FMU or a run, finds all accelerations
    zero; the outer wheel touches with its flange root and pushes the rail outwards."""
    run = enter(archives)
    still = equilibrium(wrcontact.ContactSystem(**CONTACT), WHEELSET, run.motion[-1])
    np.testing.assert_allclose(run.motion[-1], still, rtol=1e-6, atol=1e-8)
    assert run.worst_status == 0
    assert run["left.patch[1].contact_angle"][-1] > 0.65 and run["left.force.y"][-1] > 35e3
    # loads on the rails are the load; across, the rails hold the springs and the centrifugal force
    down = run["left.force.z"][-1] + run["right.force.z"][-1]
    across = run["left.force.y"][-1] + run["right.force.y"][-1]
    assert down == pytest.approx(-157e3, rel=1e-6)
    thrown = 157e3 / 9.81 * SPEED**2 / RADIUS_OF_CURVE
    assert across == pytest.approx(2 * WHEELSET["lateral_stiffness"] * still[0] + thrown, rel=1e-4)
