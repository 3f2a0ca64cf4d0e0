"""The one door through which tests look into a system and its stepper."""

import numpy as np

from wrcontact.kernel import layout


def work_of(stepper):
    """The kernel's workspace as a record; of both wheels the right one comes last."""
    return layout.Work.at(workspace_of(stepper))


def counts_of(stepper):
    """What a stepper's kernel has done so far, by name."""
    work = work_of(stepper)
    sides = work.sides
    return {
        "gap": sides[0].place.gap_count + sides[1].place.gap_count,
        "scan": sides[0].scan_count + sides[1].scan_count,
        "roll": sides[1].roll_count,
        "node": sides[0].place.node_count + sides[1].place.node_count,
        "solve": work.contact.regions[0].solve_count,
        "strip": work.contact.strip_problem.strip_count,
    }


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
    """Settings and tables of a system."""
    return system._tables


def lateral_curvatures(system, body):
    """Places (n,) [m] and lateral curvatures (n,) [1/m] that are prepared for the "wheel" or the "rail",
    positive where a profile bulges towards the other one."""
    table = getattr(layout.Tables.at(tables_of(system)).pairs[1], f"{body}_curvature")
    count = int(table.count)
    return table.start + np.arange(count) / table.per_metre, np.array(table.curvatures[:count])
