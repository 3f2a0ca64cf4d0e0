"""What the number of stations of the outline decides: the error of sums over them, and the cost of a step
(docs/fmu.md)."""

import numpy as np

from . import runs
from .machine import cost
from .rows import batch, system

NUMBERS = (31, 61, 201)
SHIFT = 1e-3  # [m] one patch on the tread


def errors():
    """By number: errors [%] of area and load from the trapezoidal rule over the outline."""
    found = {}
    for number in NUMBERS:
        side = system(stations=number).evaluate(SHIFT).right
        outline, steps = side.outline, np.diff(side.outline.station)
        area, load = (float(np.sum(0.5 * (values[1:] + values[:-1]) * steps))
                      for values in (2.0 * outline.half_length,
                                     0.5 * np.pi * outline.half_length * outline.pressure))
        found[str(number)] = {"area": 100 * abs(area / side.area - 1),
                              "load": 100 * abs(load / side.normal_force - 1)}
    return found


def times(effort):
    """By number: :class:`~benchmarks.machine.Cost` of a step of the trajectory without yaw."""
    best, poses = {}, runs.trajectory(effort.count, yaw=0.0)
    for _ in range(effort.passes):
        for number in NUMBERS:
            work = batch(system(stations=number), poses)
            best[str(number)] = cost(work, effort.count, effort.rounds).least(best.get(str(number)))
    return best
