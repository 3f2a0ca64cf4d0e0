"""The one door through which tests look into a system and its stepper."""

import numpy as np

from wrcontact.kernel import layout


def work_of(stepper):
    """The kernel's workspace as a record; of both wheels the right one comes last."""
    return layout.Work.at(workspace_of(stepper))


def workspace_of(stepper):
    """The kernel's workspace as numbers (n,)."""
    return stepper._workspace


def solver_of(stepper):
    """What works on the stepper's arrays: the kernel, or the half-space."""
    return stepper._bound


def rates_along(stepper, seed):
    """Derivatives of all outputs at the last step along ``seed`` (inputs,)."""
    return solver_of(stepper).derivative(seed)[1]


def tables_of(system):
    """Settings and tables of the right side of a system."""
    return system._tables


def lateral_curvatures(system, body):
    """Places (n,) [m] and lateral curvatures (n,) [1/m] that are prepared for the "wheel" or the "rail",
    positive where a profile bulges towards the other one."""
    table = getattr(layout.Tables.at(tables_of(system)), f"{body}_curvature")
    count = int(table.count)
    return table.start + np.arange(count) / table.per_metre, np.array(table.curvatures[:count])
