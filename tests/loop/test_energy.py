"""Energy over the coupling: what frozen forces make up falls with the step, with derivatives with its
square."""

import numpy as np
import pytest
from scipy.integrate import trapezoid

from examples.hunting_wheelset.coupling import CONES, Loop
from examples.hunting_wheelset.energy import WHEELSET, orders, study


@pytest.mark.parametrize(
    "derivatives, order, largest", [(False, 1, 0.05), (True, 2, 5e-3)], ids=["explicit", "derivatives"]
)
def test_balance(archives, derivatives, order, largest):
    errors, exchanged, worst = study(archives, derivatives, steps=(4e-4, 2e-4, 1e-4), duration=0.1)
    assert worst == 0
    np.testing.assert_allclose(orders(errors), order, atol=0.1)
    assert np.abs(errors[-1]) < largest * exchanged
    assert np.abs(errors[-1]) > 1e-9 * exchanged  # the balance sees something


def test_both_couplings_find_the_same_motion(archives):
    """Where explicit steps lead as they become smaller, extrapolated, a step with derivatives is already."""
    ends = []
    for step, derivatives in ((2e-4, False), (1e-4, False), (1e-4, True)):
        with Loop(archives, WHEELSET, CONES) as loop:
            loop.run(0.06, step, derivatives=derivatives)
            ends.append(np.array(loop.motion.read()[:4]))
    coarse, fine, smooth = ends
    extrapolated = 2 * fine - coarse
    size = np.abs(smooth).max()
    assert np.abs(coarse - fine).max() > 1e-4 * size
    assert np.abs(extrapolated - smooth).max() < 0.05 * np.abs(coarse - fine).max()


def test_the_drive_pays_for_friction(archives):
    """What the frame's pull along the track gives is what creepage and dampers take and the wheelset keeps.
    The power of friction is of the creepages, whose depth under the wheel counts for a little: 1 %."""
    seen = ("force.x", "left.friction_power", "right.friction_power", "energy", "supply", "speed")
    still = CONES | {"contact_damping": 0.0}
    with Loop(archives, WHEELSET, still, seen=seen) as loop:
        loop.run(0.05, 1e-4)
        run = loop.run(0.3, 4e-4, derivatives=True)
    step = run.time[1] - run.time[0]
    drive = trapezoid(-run["speed"] * run["force.x"], dx=step)
    friction = trapezoid(run["left.friction_power"] + run["right.friction_power"], dx=step)
    kept = run["energy"][-1] - run["energy"][0] - trapezoid(run["supply"], dx=step)
    assert drive > 0 and friction > 0
    assert friction + kept == pytest.approx(drive, abs=0.01 * friction)
