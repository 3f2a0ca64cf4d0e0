"""Cost of a directional derivative of all outputs, its own step included (docs/method.md, section 13)."""

import numpy as np

from wrcontact.kernel import layout

from . import runs
from .machine import cost
from .rows import system

CASES = {"Hertz": {"normal_model": "hertz"}, "ANALYN": {}, "strips": {"normal_model": "analyn_strip"},
         "ANALYN, compliant": {"contact_mode": "compliant"}, "ANALYN, elastic": {"contact_mode": "elastic"},
         "strips, elastic": {"contact_mode": "elastic", "normal_model": "analyn_strip"}}
POSES = 100  # of the trajectory with yaw


def times(effort):
    """By case: :class:`~benchmarks.machine.Cost` of a step and a derivative along the lateral shift."""
    works = {name: derivatives(options) for name, options in CASES.items()}
    best = {}
    for _ in range(effort.passes):
        for name, work in works.items():
            best[name] = cost(work, POSES, effort.rounds).least(best.get(name))
    return best


def derivatives(options):
    """A function that takes POSES steps, each with its derivative."""
    stepper = system(**options).stepper()
    shift, yaw = runs.trajectory(POSES)
    inputs = runs.rows((shift, yaw))
    stand = system(contact_mode="elastic").evaluate_many(shift, yaw, runs.FORCE)
    inputs[:, layout.IN_VERTICAL_SHIFT], inputs[:, layout.IN_ROLL] = stand.vertical_shift, stand.roll
    along = np.eye(layout.INPUT_COUNT)[layout.IN_LATERAL_SHIFT]

    def work():
        for row in inputs:
            stepper.inputs[:] = row
            stepper.step()
            stepper._bound.tangent(along)

    return work
