"""How oblique the patch of a yawed wheel is, against the surfaces themselves."""

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from data import brute_force
from tests.helpers.cases import FORCE, system
from tests.helpers.inside import work_of
from tests.helpers.overlap import overlap


def ridge(track, pose, abscissa):
    """Where along x the wheel overlaps the rail's point most, along the rail's normal there: a grid, and the
    parabola through its highest three values."""
    x = np.linspace(-0.06, 0.06, 2401)
    depth = overlap(track, pose, x, np.full_like(x, abscissa))
    k = np.argmax(depth)
    before, here, after = depth[k - 1 : k + 2]
    return x[k] + 0.5 * (x[1] - x[0]) * (before - after) / (before - 2.0 * here + after)


def abscissa_at(track, start, length):
    """The rail's abscissa at this arc length from ``start`` [m]."""

    def rest(y):
        return quad(lambda v: math.hypot(1.0, track.rail(v)[1]), start, y, epsabs=1e-12)[0] - length

    return brentq(rest, start - abs(length) - 1e-6, start + abs(length) + 1e-6, xtol=1e-12)


@pytest.mark.parametrize("shift, yaw", [(2e-3, 0.02), (5.2e-3, 0.0175), (7.5e-3, 0.03), (7.5e-3, -0.03)])
def test_the_ridge_of_a_yawed_wheel_s_patch_is_as_oblique_as_its_gap(shift, yaw):
    """Between both ends of the interpenetration, over the rail's arc length; up to 3 on a flange. The wheel
    has sunk to its estimated penetration."""
    stepper = system().stepper()
    stepper.inputs[:7] = shift, yaw, 0.0, FORCE, 0.0, 0.0, 0.0
    assert stepper.step() == 0
    contact = work_of(stepper).contact  # of the right wheel, which came last
    region, point = contact.regions[0], contact.overlap.points[0]
    state = system().evaluate(shift, yaw)
    track = brute_force.track()
    height = contact.frame.height  # to which it has sunk
    sunk = state.right.penetration / math.cos(state.right.contact_angle)
    assert height - state.vertical_shift == pytest.approx(sunk, rel=0.2)
    pose = brute_force.Pose(shift, yaw, state.roll, height)
    low, high = (abscissa_at(track, point.rail, way) for way in (-region.width_low, region.width_high))
    slant = (ridge(track, pose, high) - ridge(track, pose, low)) / (region.width_low + region.width_high)
    assert region.slant == pytest.approx(slant, rel=1e-3)
    assert 0.05 < abs(slant) < 4.0
