"""Work per pose, counted by the kernel itself (the record State in wrcontact/kernel/layout/wheelset.py)."""

import numpy as np

from wrcontact.kernel import layout

from . import runs
from .rows import system

COUNTS = {  # per wheelset; a scan searches one side at one roll for a smaller gap
    "gap evaluations": layout.STATE_GAP_COUNT,
    "scans": layout.STATE_SCAN_COUNT,
    "roll iterations": layout.STATE_ROLL_COUNT,
    "normal-gap nodes": layout.STATE_NODE_COUNT,
    "force solves": layout.STATE_SOLVE_COUNT,
    "strip systems": layout.STATE_STRIP_COUNT,
}
FULL_RASTER = "full raster: gap evaluations"  # without the bounds of the search
ROOT, FLANGE = 4.848e-3, 6.252e-3  # [m] where the contact jumps without yaw


def classes(count):
    """Poses by class."""
    turn = np.linspace(0.0, 1.0, count)
    straight = 0.0 * turn
    return {
        "trajectory": runs.trajectory(count, yaw=0.0),
        "trajectory with yaw": runs.trajectory(count),
        "random": runs.anywhere(count, yaw=0.0),
        "random with yaw": runs.anywhere(count),
        "tread (0 … 4.8 mm), slowly": (ROOT * turn, straight),
        "flange root (4.85 … 6.25 mm), slowly": (ROOT + (FLANGE - ROOT) * turn, straight),
        "flange (6.25 … 7.5 mm), slowly": (FLANGE + (7.5e-3 - FLANGE) * turn, straight),
    }


def per_wheelset(model, poses):
    """Mean counts (6,) of :data:`COUNTS` over a model's poses."""
    stepper = system(normal_model=model).stepper()
    inputs = runs.rows(poses)
    outputs, status = np.empty((len(inputs), layout.OUTPUT_COUNT)), np.empty(len(inputs))
    stepper.step_many(inputs, outputs, status)
    if np.any(status != 0):
        raise ArithmeticError(f"{np.sum(status != 0)} poses are not solved")
    return stepper.state[list(COUNTS.values())] / len(inputs)


def raster():
    """Number of nodes on the wheel: gap evaluations of a scan without bounds."""
    return layout.Tables.at(system()._tables).scan.count


def table(count):
    """Rows by model and class of poses: gap evaluations without bounds, and each of COUNTS."""
    rows = {}
    for model in ("analyn", "analyn_strip"):
        for name, poses in classes(count).items():
            found = dict(zip(COUNTS, per_wheelset(model, poses)))
            rows[f"{model}, {name}"] = {FULL_RASTER: raster() * found["scans"], **found}
    return rows
