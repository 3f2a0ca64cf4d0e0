"""Times beside those of the models: of what can be skipped, with the number of wheelsets and of threads, with
the number of stations, of elastic wheelsets, and of derivatives; the work of a step, counted by the kernel
itself (fields of its records whose names end in count); and the trajectory that the speed is judged
by: a wheelset that hunts from flange to flange, with a faster motion on top and a load that changes.

    python -m benchmarks trajectory

One step of 1 ms after another by a single call of the stepper; a step has both wheels and all outputs.
"""

import math
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np

import wrcontact
from wrcontact.kernel import layout

from .errors import FORCE, MODELS, STATION_NUMBERS, anywhere, hunting, inputs_of, system, trajectory
from .record import Cost, cost, costs, unit
from .rows import batch

NO_YAW, COARSE = "no yaw", "tolerance 0.02 instead of 0.0015"
GROWTH = (1, 10, 100, 1000, 10_000)  # numbers of wheelsets
THREADS = (1, 2)
SINE_STEPS, CONTACT_MODES = 1000, ("rigid", "compliant", "elastic")
DERIVATIVES = {
    "Hertz": {"normal_model": "hertz"},
    "ANALYN": {},
    "strips": {"normal_model": "analyn_strip"},
    "ANALYN, compliant": {"contact_mode": "compliant"},
    "ANALYN, elastic": {"contact_mode": "elastic"},
    "strips, elastic": {"contact_mode": "elastic", "normal_model": "analyn_strip"},
}
DERIVATIVE_POSES = 100  # of the trajectory with yaw


# ---------------------------------------------------------------------------------------- what can be skipped


@dataclass
class Skip:
    """``work`` with the skip and ``full`` without it, ``calls`` evaluations each; ``answer`` is the effect on
    the result, with fields for the errors of :func:`answers`."""

    name: str
    work: Callable
    full: Callable
    calls: int
    answer: str
    less: Cost = None
    more: Cost = None

    def measure(self, rounds):
        self.less = cost(self.work, self.calls, rounds).least(self.less)
        self.more = cost(self.full, self.calls, rounds).least(self.more)
        return self


def all_skips(effort):
    """Every :class:`Skip`, not yet measured."""
    straight, yawed = trajectory(effort.count, yaw=0.0), trajectory(effort.count)
    count, full = effort.count, batch(system(), trajectory(effort.count, yaw=0.0))
    coarse, fine = system(tolerance=0.02), system(tolerance=0.0015)
    yield Skip(
        NO_YAW,
        full,
        batch(system(), yawed),
        count,
        "hunting run with its yaw left out: {mean} mean, {worst} worst",
    )
    yield Skip("inputs unchanged, stepper", *resting(count), count, "the same bits")
    yield Skip("inputs unchanged, `evaluate()`", *resting_evaluate(count), count, "the same bits")
    yield Skip(
        'geometry alone, `outputs="geometry"`',
        batch(system(), straight, outputs="geometry"),
        full,
        count,
        "the same bits",
    )
    yield Skip(
        'no outline, `outputs="patches"`',
        batch(system(), straight, outputs="patches"),
        full,
        count,
        "the same bits",
    )
    yield Skip(
        'one side, `side="right"`', batch(system(), straight, side="right"), full, count, "the same bits"
    )
    yield Skip(
        "a wheel without load, `load_transfer=1`", loaded(straight, 1.0), full, count, "its patch is empty"
    )
    yield Skip(
        "known basin: the search starts at the last contact (geometry alone)",
        batch(system(), straight, outputs="geometry"),
        wrong_start(straight),
        count,
        "the same minimum, bounded",
    )
    yield Skip(
        "force solve: penetration prescribed, the most that its history could save",
        sunk(straight),
        full,
        count,
        "another question",
    )
    yield Skip(
        COARSE,
        batch(coarse, straight),
        batch(fine, straight),
        count,
        "hunting run: {mean} mean instead of {fine}",
    )


def skip_answers():
    """Errors on the hunting run of the skips that change the result [%], by their names."""
    ignored, coarse, fine = (
        hunting(system(), yawed=False),
        hunting(system(tolerance=0.02)),
        hunting(system(tolerance=0.0015)),
    )
    return {
        NO_YAW: {"mean": 100 * ignored.mean, "worst": 100 * ignored.worst},
        COARSE: {"mean": 100 * coarse.mean, "fine": 100 * fine.mean},
    }


def resting(count):
    """Steps of a stepper at one pose, and at poses that change in the last digits."""
    stepper = system().stepper()
    stepper.inputs[:] = inputs_of(([1e-3], [0.0]))[0]

    def rest():
        stepper.inputs[0] = 1e-3
        for _ in range(count):
            stepper.step()

    def move():
        for k in range(count):
            stepper.inputs[0] = 1e-3 + 1e-9 * k
            stepper.step()

    return rest, move


def resting_evaluate(count):
    evaluate = system().evaluate
    return (lambda: [evaluate(1e-3) for _ in range(count)]), (
        lambda: [evaluate(1e-3 + 1e-9 * k) for k in range(count)]
    )


def loaded(poses, transfer):
    shift, yaw = poses
    return lambda: system().evaluate_many(shift, yaw, FORCE, transfer, threads=1)


def wrong_start(poses):
    """Poses with a given roll guess, which start the search without known contacts."""
    shift, yaw = poses
    return lambda: system().evaluate_many(shift, yaw, FORCE, roll_guess=1e-3, outputs="geometry", threads=1)


def sunk(poses):
    """Poses with their own mean penetration prescribed instead of the force."""
    shift, yaw = poses
    table = system().evaluate_many(shift, yaw, FORCE)
    mean = tuple(float(np.mean(side.penetration)) for side in (table.left, table.right))
    return batch(system(), poses, penetration=mean)


# -------------------------------------------------------------------------------------- wheelsets and threads


def wheelsets(numbers, rounds):
    """(number, cost per wheelset) of evaluate_many for each number of random poses."""
    for number in numbers:
        work, repeats = batch(system(), anywhere(number)), max(1, 300 // number)
        yield number, cost(lambda: [work() for _ in range(repeats)], number * repeats, rounds)


def threads(number, rounds, counts=THREADS):
    """Rows: threads, seconds of a wheelset, speed-up.  Each thread has its own stepper and ``number`` poses.

    The kernel is called through ctypes, which lets other threads run meanwhile; a batch is one call.
    """
    inputs = inputs_of(trajectory(number))
    works = [steps_of({}, inputs)[0] for _ in range(max(counts))]
    best = {}
    for _ in range(rounds):
        unit()
        for count in counts:
            with ThreadPoolExecutor(count) as pool:
                list(pool.map(lambda work: None, range(count)))  # start the threads before timing
                start = time.perf_counter()
                list(pool.map(lambda work: work(), works[:count]))
                seconds = (time.perf_counter() - start) / (count * number)
            best[count] = min(seconds, best.get(count, seconds))
    return [(count, seconds, best[counts[0]] / seconds) for count, seconds in best.items()]


# ------------------------------------------------------------------- stations, elastic wheelsets, derivatives


def station_times(effort):
    """By number: :class:`~benchmarks.record.Cost` of a step of the trajectory without yaw."""
    poses = trajectory(effort.count, yaw=0.0)
    return costs(
        {str(number): (batch(system(stations=number), poses), effort.count) for number in STATION_NUMBERS},
        effort,
    )


def sine():
    """Lateral shift [m] and yaw [rad] of a hunting wheelset (SINE_STEPS,)."""
    phase = np.linspace(0.0, 2 * math.pi, SINE_STEPS)
    return 5e-3 * np.sin(phase), 5e-3 * np.cos(phase)


def elastic_times(effort):
    """By model and contact mode: :class:`~benchmarks.record.Cost` of a step of the sine; the compliant
    form's at the elastic positions."""
    shift, yaw = sine()
    stand = system(contact_mode="elastic").evaluate_many(shift, yaw, FORCE)
    given = dict(vertical_shift_input=stand.vertical_shift, roll_input=stand.roll)
    best = costs(
        {
            (model, mode): (
                batch(system(normal_model=model, contact_mode=mode), (shift, yaw), **given),
                SINE_STEPS,
            )
            for model in MODELS
            for mode in CONTACT_MODES
        },
        effort,
    )
    return {model: {mode: best[model, mode] for mode in CONTACT_MODES} for model in MODELS}


def derivative_times(effort):
    """By case: :class:`~benchmarks.record.Cost` of a step and a derivative along the lateral shift."""
    return costs(
        {name: (derivatives(options), DERIVATIVE_POSES) for name, options in DERIVATIVES.items()}, effort
    )


def derivatives(options):
    """A function that takes DERIVATIVE_POSES steps, each with its derivative."""
    stepper = system(**options).stepper()
    inputs = standing(inputs_of(trajectory(DERIVATIVE_POSES)))
    along = np.eye(layout.INPUT_COUNT)[layout.IN_LATERAL_SHIFT]

    def work():
        for row in inputs:
            stepper.inputs[:] = row
            stepper.step()
            stepper._bound.derivative(along)

    return work


# ----------------------------------------------------------------------------- work of a step, the trajectory


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
    inputs = inputs_of(poses)
    call, stepper, status = steps_of({"normal_model": model}, inputs)
    call()
    if np.any(status != 0):
        raise ArithmeticError(f"{np.sum(status != 0)} poses are not solved")
    return counted(stepper) / len(inputs)


def counted(stepper):
    """What a stepper's kernel has done so far (6,): :data:`COUNTS`."""
    work = layout.Work.at(stepper._workspace)
    places = [side.place for side in work.sides]
    return np.array(
        [
            sum(place.gap_count for place in places),
            sum(side.scan_count for side in work.sides),
            work.sides[1].roll_count,
            sum(place.node_count for place in places),
            work.contact.regions[0].solve_count,
            work.contact.strip_problem.strip_count,
        ]
    )


def raster():
    """Number of nodes on the wheel: gap evaluations of a scan without bounds."""
    return layout.Tables.at(system()._tables).pairs[1].scan.count


def count_table(count):
    """Rows by model and class of poses: gap evaluations without bounds, and each of COUNTS."""
    rows = {}
    for model in ("analyn", "analyn_strip"):
        for name, poses in classes(count).items():
            found = dict(zip(COUNTS, per_wheelset(model, poses)))
            rows[f"{model}, {name}"] = {FULL_RASTER: raster() * found["scans"], **found}
    return rows


STEP = 1e-3  # [s]
STEPS, ROUNDS = 5_000, 3  # which are timed
WHOLE = 20_000  # from these, work is counted
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
    return (
        6e-3 * np.sin(1.1 * turn) + 0.4e-3 * np.sin(7 * turn),
        4e-3 * np.cos(1.1 * turn),
        78.5e3 * (1 + 0.2 * np.sin(3 * turn)),
    )


def inputs(count, every=1):
    """Inputs (count, INPUT_COUNT) of the trajectory."""
    shift, yaw, force = motion(count, every)
    return inputs_of((shift, yaw), force)


def standing(inputs):
    """These inputs with height and roll where the wheelset stands in elastic contact, for the compliant
    form."""
    shift, yaw, force = inputs[:, [layout.IN_LATERAL_SHIFT, layout.IN_YAW, layout.IN_NORMAL_FORCE]].T
    stand = system(contact_mode="elastic").evaluate_many(shift, yaw, force)
    inputs[:, layout.IN_VERTICAL_SHIFT], inputs[:, layout.IN_ROLL] = stand.vertical_shift, stand.roll
    return inputs


def steps_of(parameters, rows):
    """A call that makes a step of every row of inputs, the stepper that it uses, and the status (n,) that it
    writes."""
    stepper = wrcontact.ContactSystem(**parameters).stepper()
    outputs, status = np.empty((len(rows), layout.OUTPUT_COUNT)), np.empty(len(rows))
    return lambda: stepper.step_many(rows, outputs, status), stepper, status


def trajectory_steps(parameters, count, every=1):
    """:func:`steps_of` the trajectory."""
    rows = inputs(count, every)
    return steps_of(parameters, standing(rows) if parameters.get("contact_mode") == "compliant" else rows)


def work(parameters, count, every=1):
    """Mean counts (6,) of :data:`COUNTS` a step, from a stepper that begins there."""
    call, stepper, _ = trajectory_steps(parameters, count, every)
    call()
    return counted(stepper) / count


def trajectory_times(quick=False):
    """Rows by name: units and microseconds of a step, what was asked, and the counts."""
    count, rounds = (5, 1) if quick else (STEPS, ROUNDS)
    return {name: row_of(*ROWS[name], count, rounds) for name in ROWS}


def row_of(parameters, asked, count, rounds):
    """One row of :func:`trajectory_times`."""
    took = cost(trajectory_steps(parameters, count)[0], count, rounds)
    found = work(parameters, min(count, 2000), max(1, WHOLE // 2000))
    return {"units": took.units, "asked": asked, "µs": took.microseconds, **dict(zip(COUNTS, found.tolist()))}
