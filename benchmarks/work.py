"""Work of a step, counted by the kernel itself (fields of its records whose names end in count), and
the trajectory that the speed is judged by: a wheelset that hunts from flange to flange, with a faster motion
on top and a load that changes.

    python -m benchmarks trajectory

One step of 1 ms after another by a single call of the stepper; a step has both wheels and all outputs.
"""

import numpy as np

import wrcontact
from wrcontact.kernel import layout

from .errors import anywhere, inputs_of, system, trajectory
from .machine import cost

#: Per wheelset; a scan searches one side at one roll for a smaller gap.
COUNTS = ("gap evaluations", "scans", "roll iterations", "normal-gap nodes", "force solves", "strip systems")
FULL_RASTER = "full raster: gap evaluations"  # without the bounds of the search
ROOT, FLANGE = 4.848e-3, 6.252e-3  # [m] where the contact jumps without yaw


def classes(count):
    """Poses by class."""
    turn = np.linspace(0.0, 1.0, count)
    straight = 0.0 * turn
    return {
        "trajectory": trajectory(count, yaw=0.0),
        "trajectory with yaw": trajectory(count),
        "random": anywhere(count, yaw=0.0),
        "random with yaw": anywhere(count),
        "tread (0 … 4.8 mm), slowly": (ROOT * turn, straight),
        "flange root (4.85 … 6.25 mm), slowly": (ROOT + (FLANGE - ROOT) * turn, straight),
        "flange (6.25 … 7.5 mm), slowly": (FLANGE + (7.5e-3 - FLANGE) * turn, straight),
    }


def per_wheelset(model, poses):
    """Mean counts (6,) of :data:`COUNTS` over a model's poses."""
    stepper = system(normal_model=model).stepper()
    inputs = inputs_of(poses)
    outputs, status = np.empty((len(inputs), layout.OUTPUT_COUNT)), np.empty(len(inputs))
    stepper.step_many(inputs, outputs, status)
    if np.any(status != 0):
        raise ArithmeticError(f"{np.sum(status != 0)} poses are not solved")
    return counted(stepper) / len(inputs)


def counted(stepper):
    """What a stepper's kernel has done so far (6,): :data:`COUNTS`."""
    work = layout.Work.at(stepper._workspace)
    places = [side.place for side in work.sides]
    return np.array([sum(place.gap_count for place in places), sum(side.scan_count for side in work.sides),
                     work.sides[1].roll_count, sum(place.node_count for place in places),
                     work.contact.regions[0].solve_count, work.contact.strip_problem.strip_count])


def raster():
    """Number of nodes on the wheel: gap evaluations of a scan without bounds."""
    return layout.Tables.at(system()._tables).scan.count


def count_table(count):
    """Rows by model and class of poses: gap evaluations without bounds, and each of COUNTS."""
    rows = {}
    for model in ("analyn", "analyn_strip"):
        for name, poses in classes(count).items():
            found = dict(zip(COUNTS, per_wheelset(model, poses)))
            rows[f"{model}, {name}"] = {FULL_RASTER: raster() * found["scans"], **found}
    return rows


# --------------------------------------------------------------------------------------------- the trajectory


STEP = 1e-3                 # [s]
STEPS, ROUNDS = 5_000, 3    # which are timed
WHOLE = 20_000              # from these, work is counted
#: Name of the row, parameters, and the units of ``np.sqrt`` of 2000 doubles that a step is to cost at most;
#: None where none is asked for.
ROWS = {
    "Hertz, rigid": (dict(normal_model="hertz"), 1.6),
    "ANALYN, rigid": (dict(), 6.0),
    "strips, rigid": (dict(normal_model="analyn_strip"), 17.0),
    "ANALYN, compliant": (dict(contact_mode="compliant"), 8.5),
    "ANALYN, elastic": (dict(contact_mode="elastic"), 31.0),
    "strips, compliant": (dict(contact_mode="compliant", normal_model="analyn_strip"), 20.0),
    "strips, elastic": (dict(contact_mode="elastic", normal_model="analyn_strip"), 62.0),
}


def motion(count, every=1):
    """Lateral shift [m], yaw [rad] and force [N] (count,) of each ``every``-th step."""
    turn = 2 * np.pi * STEP * every * np.arange(count)
    return (6e-3 * np.sin(1.1 * turn) + 0.4e-3 * np.sin(7 * turn), 4e-3 * np.cos(1.1 * turn),
            78.5e3 * (1 + 0.2 * np.sin(3 * turn)))


def inputs(count, every=1, stand=False):
    """Inputs (count, INPUT_COUNT) of the trajectory; with ``stand`` also height and roll where the wheelset
    stands in elastic contact, for the compliant form."""
    found = np.zeros((count, layout.INPUT_COUNT))
    shift, yaw, force = motion(count, every)
    found[:, layout.IN_LATERAL_SHIFT], found[:, layout.IN_YAW] = shift, yaw
    found[:, layout.IN_NORMAL_FORCE] = force
    if stand:
        table = wrcontact.ContactSystem(contact_mode="elastic").evaluate_many(shift, yaw, force)
        found[:, layout.IN_VERTICAL_SHIFT], found[:, layout.IN_ROLL] = table.vertical_shift, table.roll
    return found


def steps_of(parameters, rows):
    """A call that makes a step of every row of inputs, and the stepper that it uses."""
    stepper = wrcontact.ContactSystem(**parameters).stepper()
    outputs, status = np.empty((len(rows), layout.OUTPUT_COUNT)), np.empty(len(rows))
    return lambda: stepper.step_many(rows, outputs, status), stepper


def work(parameters, count, every=1):
    """Mean counts (6,) of :data:`COUNTS` a step, from a stepper that begins there."""
    stand = parameters.get("contact_mode") == "compliant"
    call, stepper = steps_of(parameters, inputs(count, every, stand))
    call()
    return counted(stepper) / count


def measured(quick=False):
    """Rows by name: units and microseconds of a step, what was asked, and the counts."""
    count, rounds = (5, 1) if quick else (STEPS, ROUNDS)
    return {name: row_of(*ROWS[name], count, rounds) for name in ROWS}


def row_of(parameters, asked, count, rounds):
    """One row of :func:`measured`."""
    stand = parameters.get("contact_mode") == "compliant"
    call, _ = steps_of(parameters, inputs(count, stand=stand))
    took = cost(call, count, rounds)
    found = work(parameters, min(count, 2000), max(1, WHOLE // 2000))
    return {"units": took.units, "asked": asked, "µs": took.microseconds, **dict(zip(COUNTS, found.tolist()))}
