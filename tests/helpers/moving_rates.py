"""Derivatives of a wheelset that moves, beside central differences of its steps."""

import numpy as np

import wrcontact
from tests.helpers.cases import input_row
from tests.helpers.inside import rates_along
from wrcontact.interface.variables import BOOLEAN, FIRST_OUTPUT, INPUT, STATUS, VARIABLES

INPUTS = [v for v in VARIABLES if v.causality == INPUT]
OUTPUTS = VARIABLES[FIRST_OUTPUT:STATUS]
NAMES = [v.name for v in OUTPUTS]
NOMINAL = np.array([v.nominal or 1.0 for v in OUTPUTS])
STEPS = (1e-5, 1e-4, 1e-3)      # [of an input's nominal value]; one of them is to be met


def moved_inputs(*left_out):
    """Places of the inputs that derivatives are taken of: a switch has none, and a guess does not count."""
    return [place for place, v in enumerate(INPUTS) if v.type != BOOLEAN
            and v.name not in ("roll_guess", *left_out)]


def moving_row(parameters, motion, shift, yaw):
    """Inputs of a pose with ``motion`` by name; a compliant wheelset stands as an elastic one does."""
    row = input_row(shift, yaw, 0.0, 78.5e3)
    for place, variable in enumerate(INPUTS):
        row[place] = motion.get(variable.name, row[place])
    if parameters.get("contact_mode") == "compliant":
        stand = wrcontact.ContactSystem(**parameters | {"contact_mode": "elastic"}).evaluate(shift, yaw)
        row[5:7] = stand.vertical_shift, stand.roll
    return row


def errors_of_rates(stepper, row, place, floor):
    """How far the rates of all outputs along the input at ``place`` are from the nearest difference, of the
    rate or of ``floor`` times the nominal one."""
    def outputs(at):
        stepper.inputs[:] = at
        assert stepper.step() == 0
        return stepper.outputs.copy()

    along, nominal = np.eye(len(row))[place], INPUTS[place].nominal
    outputs(row)
    rates = rates_along(stepper, along)
    off = np.min([np.abs(rates - (outputs(row + step * along) - outputs(row - step * along)) / (2 * step))
                  for step in np.array(STEPS) * nominal], axis=0)
    return off / np.maximum(np.abs(rates), floor * NOMINAL / nominal)
