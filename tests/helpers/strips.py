"""Systems with strips, random poses, and their errors against another solution."""

import numpy as np

from tests.helpers.cases import system
from wrcontact import Status
from wrcontact.kernel import layout

NAMES = ("penetration", "area", "max_pressure")
EXTENT = (*NAMES, "patch_length", "patch_width")
POSE = [layout.IN_LATERAL_SHIFT, layout.IN_YAW, layout.IN_NORMAL_FORCE]  # what random poses differ in


def system_of(model="analyn_strip", **parameters):
    return system(normal_model=model, **parameters)


def errors(side, truth):
    """Relative errors in penetration, area and peak pressure (3,)."""
    return np.array([getattr(side, name) / getattr(truth, name) - 1 for name in NAMES])


def random_poses(count, seed, low=3e3, high=2e5):
    """Inputs (count, 7): S1002's tread to flange, ``low`` to ``high`` N, half of them
    with up to 2 degrees of yaw."""
    rng = np.random.default_rng(seed)
    rows = np.zeros((count, layout.INPUT_COUNT))
    rows[:, layout.IN_LATERAL_SHIFT] = rng.uniform(-6.6e-3, 6.6e-3, count)
    rows[:, layout.IN_YAW] = np.radians(rng.uniform(-2, 2, count)) * (rng.random(count) < 0.5)
    rows[:, layout.IN_NORMAL_FORCE] = np.exp(rng.uniform(np.log(low), np.log(high), count))
    return rows


def step_all(stepper, rows, before=lambda stepper: None):
    """Outputs (n, m) of all rows, one after the other, ``before`` done to the stepper ahead
    of each; NaN where not valid."""
    outputs = np.full((len(rows), layout.OUTPUT_COUNT), np.nan)
    for row, values in zip(outputs, rows):
        before(stepper)
        stepper.inputs[:] = values
        if stepper.step() <= Status.UNLOADED:
            row[:] = stepper.outputs
    return outputs
