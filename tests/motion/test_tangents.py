"""Directional derivatives of creepages and damped forces, against differences."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.moving_rates import INPUTS, NAMES, errors_of_rates, moved_inputs, moving_row
from wrcontact.kernel.binding.library import default_kernel

pytestmark = pytest.mark.skipif(not default_kernel().compiled,
                                reason="the derivatives are those of the compiled library, and none is here")

CREEPAGES = np.array([".creepage." in name for name in NAMES])
FORCES = np.array([name.endswith(("normal_force", "force.y", "force.z", "moment.x")) for name in NAMES])
MOTION = {"speed": 25.0, "lateral_velocity": 0.04, "vertical_velocity": -0.02, "yaw_rate": 0.05,
          "roll_rate": 0.03, "wheel_rate": 54.0, "track_curvature": 2e-3,
          "left.rail_lateral_velocity": 0.01, "right.rail_vertical_velocity": 0.02,
          "right.rail_roll_velocity": -0.03}
POSES = [(1.1e-3, 0.0), (-3e-3, 0.004), (3.3e-3, -0.01)]


@pytest.mark.parametrize("shift, yaw", POSES)
@pytest.mark.parametrize("parameters, of", [
    ({"normal_model": "hertz"}, CREEPAGES), ({}, CREEPAGES), ({"contact_mode": "elastic"}, CREEPAGES),
    ({"contact_mode": "compliant", "contact_damping": 0.5}, CREEPAGES | FORCES)],
    ids=["hertz", "rigid", "elastic", "compliant"])
def test_derivatives(parameters, of, shift, yaw):
    """With respect to every input but the load: central differences over steps, of which one is to be met."""
    stepper = wrcontact.ContactSystem(**parameters).stepper()
    row = moving_row(parameters, MOTION, shift, yaw)
    for place in moved_inputs("normal_force", "load_transfer"):
        off = np.where(of, errors_of_rates(stepper, row, place, 0.02), 0.0)
        assert off.max() < 2e-5, (INPUTS[place].name, NAMES[off.argmax()], off.max())
