"""Directional derivatives of creepages and damped forces, against differences."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.cases import input_row
from wrcontact.interface.variables import BOOLEAN, FIRST_OUTPUT, INPUT, STATUS, VARIABLES
from wrcontact.kernel.binding.library import default_kernel

pytestmark = pytest.mark.skipif(not default_kernel().compiled,
                                reason="the derivatives are those of the compiled library, and none is here")

INPUTS = [v for v in VARIABLES if v.causality == INPUT]
NAMES = [v.name for v in VARIABLES[FIRST_OUTPUT:STATUS]]
CREEPAGES = np.array([".creepage." in name for name in NAMES])
FORCES = np.array([name.endswith(("normal_force", "force.y", "force.z", "moment.x")) for name in NAMES])
#: Roll guess and load do not count, and a switch has no derivative.
MOVED = [place for place, v in enumerate(INPUTS) if v.type != BOOLEAN
         and v.name not in ("roll_guess", "normal_force", "load_transfer")]
MOTION = {"speed": 25.0, "lateral_velocity": 0.04, "vertical_velocity": -0.02, "yaw_rate": 0.05,
          "roll_rate": 0.03, "wheel_rate": 54.0, "track_curvature": 2e-3,
          "left.rail_lateral_velocity": 0.01, "right.rail_vertical_velocity": 0.02,
          "right.rail_roll_velocity": -0.03}
POSES = [(1.1e-3, 0.0), (-3e-3, 0.004), (3.3e-3, -0.01)]


def moving_row(parameters, shift, yaw):
    row = input_row(shift, yaw, 0.0, 78.5e3)
    for place, variable in enumerate(INPUTS):
        row[place] = MOTION.get(variable.name, row[place])
    if parameters.get("contact_mode") == "compliant":
        stand = wrcontact.ContactSystem(**parameters | {"contact_mode": "elastic"}).evaluate(shift, yaw)
        row[5:7] = stand.vertical_shift, stand.roll
    return row


@pytest.mark.parametrize("shift, yaw", POSES)
@pytest.mark.parametrize("parameters, of", [
    ({"normal_model": "hertz"}, CREEPAGES), ({}, CREEPAGES), ({"contact_mode": "elastic"}, CREEPAGES),
    ({"contact_mode": "compliant", "contact_damping": 0.5}, CREEPAGES | FORCES)],
    ids=["hertz", "rigid", "elastic", "compliant"])
def test_derivatives(parameters, of, shift, yaw):
    """With respect to every input: central differences over two steps, of which one is to be met."""
    stepper = wrcontact.ContactSystem(**parameters).stepper()
    row = moving_row(parameters, shift, yaw)

    def outputs(at):
        stepper.inputs[:] = at
        assert stepper.step() == 0
        return stepper.outputs.copy()

    nominal = np.array([v.nominal or 1.0 for v in VARIABLES[FIRST_OUTPUT:STATUS]])
    for place in MOVED:
        outputs(row)
        rates = stepper._bound.tangent(np.eye(len(row))[place])[1]
        off = np.inf
        for share in (1e-5, 1e-4, 1e-3):
            step = share * INPUTS[place].nominal * np.eye(len(row))[place]
            difference = (outputs(row + step) - outputs(row - step)) / (2 * step[place])
            off = np.minimum(off, np.abs(rates - difference))
        size = np.maximum(np.abs(rates), 0.02 * nominal / INPUTS[place].nominal)
        worst = (off / size)[of].max()
        assert worst < 2e-5, (INPUTS[place].name, NAMES[np.flatnonzero(of)[(off / size)[of].argmax()]], worst)
