"""Directional derivatives of creep forces, against differences."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.moving_rates import INPUTS, NAMES, errors_of_rates, moved_inputs, moving_row
from wrcontact.kernel.binding.library import default_kernel

pytestmark = pytest.mark.skipif(not default_kernel().compiled,
                                reason="the derivatives are those of the compiled library, and none is here")

#: Shares of stick jump from point to point of a strip, and runs over the outline follow them.
SMOOTH = np.array([name.endswith((".force.x", ".force.y", ".force.z", ".moment.x", ".moment.y", ".moment.z",
                                  "driving_torque", "tangential.x", "tangential.y", "tangential.moment",
                                  "friction_power", "saturation", "wear_number")) for name in NAMES])
MOTION = {"speed": 25.0, "lateral_velocity": 0.04, "vertical_velocity": -0.02, "yaw_rate": 0.05,
          "roll_rate": 0.03, "wheel_rate": 54.3, "track_curvature": 1e-3, "left.friction": 0.35,
          "right.friction": 0.25}
POSES = [(1.1e-3, 0.0), (-3e-3, 0.004), (3.3e-3, -0.003)]
PARAMETERS = {
    "rigid": {},
    "elastic": {"contact_mode": "elastic"},
    "compliant": {"contact_mode": "compliant", "contact_damping": 0.5},
    "vertical": {"load": "vertical"},
    "elastic vertical": {"load": "vertical", "contact_mode": "elastic"},
    "falling friction": {"friction_fall": 0.4, "friction_fall_rate": 0.6, "flange_friction_ratio": 0.5,
                         "slope_reduction": 0.6, "slope_reduction_rate": 0.6},
}
#: Of a derivative's size; points of FASTSIM come to slide one by one, each with a kink,
#: and there are kinks where a point of the strips passes the edge of the stick zone.
AGREE = {"polach": 1e-4, "fastsim": 2e-2, "strips": 5e-3}


@pytest.mark.parametrize("model", ["polach", "fastsim", "strips"])
@pytest.mark.parametrize("case", PARAMETERS)
def test_derivatives(case, model):
    """With respect to every input: central differences over steps, of which one is to be met."""
    parameters = PARAMETERS[case]
    stepper = wrcontact.ContactSystem(**parameters, tangential_model=model).stepper()
    for shift, yaw in POSES:
        row = moving_row(parameters, MOTION, shift, yaw)
        for place in moved_inputs():
            worst = np.where(SMOOTH, errors_of_rates(stepper, row, place, 0.05), 0.0)
            assert worst.max() < AGREE[model], (
                f"d {NAMES[worst.argmax()]} / d {INPUTS[place].name} at {shift}, {yaw}: {worst.max():.2g}")
