"""How oblique the patch of a yawed wheel is, against the surfaces themselves."""

from types import SimpleNamespace

import numpy as np
import pytest

from tests.helpers.cases import FORCE, system
from tests.reference import brute_force
from tests.reference.halfspace_reference import contact_plane
from wrcontact.kernel import layout


def ridge(plane, station):
    """Where the gap is smallest along x at ``station`` [m]: a grid, and the parabola through its lowest three
    values."""
    x = np.linspace(-0.06, 0.06, 2401)
    gap = plane.gap(x, np.array([station]))[:, 0]
    k = np.argmin(gap)
    before, here, after = gap[k - 1:k + 2]
    return x[k] + 0.5 * (x[1] - x[0]) * (before - after) / (before - 2.0 * here + after)


@pytest.mark.parametrize("shift, yaw", [(2e-3, 0.02), (5.2e-3, 0.0175), (7.5e-3, 0.03), (7.5e-3, -0.03)])
def test_the_ridge_of_a_yawed_wheel_s_patch_is_as_oblique_as_its_gap(shift, yaw):
    """Between both ends of the interpenetration; up to 3 on a flange."""
    stepper = system().stepper()
    stepper.inputs[:] = shift, yaw, 0.0, FORCE, 0.0, 0.0, 0.0
    assert stepper.step() == 0
    region = layout.Work.at(stepper._workspace).contact.regions[0]       # of the right wheel, which came last
    state = system().evaluate(shift, yaw)
    contact = state.right.contact
    wheelset = SimpleNamespace(lateral_shift=shift, yaw=yaw, roll=state.roll,
                               vertical_shift=state.vertical_shift, right=SimpleNamespace(
                                   x_track=contact.x_track, y_track=contact.y_track, z_track=contact.z_track,
                                   contact_angle=state.right.contact_angle))
    plane = contact_plane(brute_force.track(), wheelset, "right")
    low, high = -region.width_low, region.width_high
    slant = (ridge(plane, high) - ridge(plane, low)) / (high - low)
    assert region.slant == pytest.approx(slant, rel=1e-3)
    assert 0.05 < abs(slant) < 4.0
