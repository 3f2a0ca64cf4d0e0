"""Times beside those of the models: of what can be skipped, with the number of wheelsets and of threads, with
the number of stations, of elastic wheelsets, and of derivatives."""

import itertools
import math
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np

from wrcontact.kernel import layout

from .errors import FORCE, MODELS, STATION_NUMBERS, anywhere, hunting, inputs_of, system, trajectory
from .machine import Cost, cost, unit
from .rows import batch

NO_YAW, COARSE = "no yaw", "tolerance 0.02 instead of 0.0015"
GROWTH = (1, 10, 100, 1000, 10_000)     # numbers of wheelsets
THREADS = (1, 2)
SINE_STEPS, CONTACT_MODES = 1000, ("rigid", "compliant", "elastic")
DERIVATIVES = {"Hertz": {"normal_model": "hertz"}, "ANALYN": {}, "strips": {"normal_model": "analyn_strip"},
         "ANALYN, compliant": {"contact_mode": "compliant"}, "ANALYN, elastic": {"contact_mode": "elastic"},
         "strips, elastic": {"contact_mode": "elastic", "normal_model": "analyn_strip"}}
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
    yield Skip(NO_YAW, full, batch(system(), yawed), count,
               "hunting run with its yaw left out: {mean} mean, {worst} worst")
    yield Skip("inputs unchanged, stepper", *resting(count), count, "the same bits")
    yield Skip("inputs unchanged, `evaluate()`", *resting_evaluate(count), count, "the same bits")
    yield Skip('geometry alone, `outputs="geometry"`', batch(system(), straight, outputs="geometry"), full,
               count, "the same bits")
    yield Skip('no outline, `outputs="patches"`', batch(system(), straight, outputs="patches"), full, count,
               "the same bits")
    yield Skip('one side, `side="right"`', batch(system(), straight, side="right"), full, count,
               "the same bits")
    yield Skip("a wheel without load, `load_transfer=1`", loaded(straight, 1.0), full, count,
               "its patch is empty")
    yield Skip("known basin: the search starts at the last contact (geometry alone)",
               batch(system(), straight, outputs="geometry"), wrong_start(straight), count,
               "the same minimum, bounded")
    yield Skip("force solve: penetration prescribed, the most that its history could save", sunk(straight),
               full, count, "another question")
    yield Skip(COARSE, batch(coarse, straight), batch(fine, straight), count,
               "hunting run: {mean} mean instead of {fine}")


def skip_answers():
    """Errors on the hunting run of the skips that change the result [%], by their names."""
    ignored, coarse, fine = (hunting(system(), yawed=False), hunting(system(tolerance=0.02)),
                             hunting(system(tolerance=0.0015)))
    return {NO_YAW: {"mean": 100 * ignored.mean, "worst": 100 * ignored.worst},
            COARSE: {"mean": 100 * coarse.mean, "fine": 100 * fine.mean}}


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
    return (lambda: [evaluate(1e-3) for _ in range(count)]), (lambda: [evaluate(1e-3 + 1e-9 * k)
                                                                       for k in range(count)])


def loaded(poses, transfer):
    shift, yaw = poses
    return lambda: system().evaluate_many(shift, yaw, FORCE, transfer)


def wrong_start(poses):
    """Poses with a given roll guess, which start the search without known contacts."""
    shift, yaw = poses
    return lambda: system().evaluate_many(shift, yaw, FORCE, roll_guess=1e-3, outputs="geometry")


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
        poses, repeats = anywhere(number), max(1, 300 // number)
        yield number, cost(repeated(batch(system(), poses), repeats), number * repeats, rounds)


def repeated(work, times):
    """A call that runs ``work`` so many times."""
    return lambda: [work() for _ in range(times)]


def threads(number, rounds, counts=THREADS):
    """Rows: threads, seconds of a wheelset, speed-up.  Each thread has its own stepper and ``number`` poses.

    The kernel is called through ctypes, which lets other threads run meanwhile; a batch is one call.
    """
    steppers = [batch_of(number, seed) for seed in range(max(counts))]
    best = {}
    for _ in range(rounds):
        unit()
        for count in counts:
            with ThreadPoolExecutor(count) as pool:
                list(pool.map(lambda work: None, range(count)))  # start the threads before timing
                start = time.perf_counter()
                list(pool.map(lambda work: work(), steppers[:count]))
                seconds = (time.perf_counter() - start) / (count * number)
            best[count] = min(seconds, best.get(count, seconds))
    return [(count, seconds, best[counts[0]] / seconds) for count, seconds in best.items()]


def batch_of(number, seed):
    """A call that steps ``number`` poses of the trajectory at once, with a stepper of its own."""
    inputs = inputs_of(trajectory(number))
    outputs, status = np.empty((number, layout.OUTPUT_COUNT)), np.empty(number)
    stepper = system().stepper()
    return lambda: stepper.step_many(inputs, outputs, status)


# ------------------------------------------------------------------- stations, elastic wheelsets, derivatives


def station_times(effort):
    """By number: :class:`~benchmarks.machine.Cost` of a step of the trajectory without yaw."""
    best, poses = {}, trajectory(effort.count, yaw=0.0)
    for _ in range(effort.passes):
        for number in STATION_NUMBERS:
            work = batch(system(stations=number), poses)
            best[str(number)] = cost(work, effort.count, effort.rounds).least(best.get(str(number)))
    return best


def sine():
    """Lateral shift [m] and yaw [rad] of a hunting wheelset (SINE_STEPS,)."""
    phase = np.linspace(0.0, 2 * math.pi, SINE_STEPS)
    return 5e-3 * np.sin(phase), 5e-3 * np.cos(phase)


def elastic_times(effort):
    """By model and contact mode: :class:`~benchmarks.machine.Cost` of a step of the sine; the compliant
    form's at the elastic positions."""
    shift, yaw = sine()
    stand = system(contact_mode="elastic").evaluate_many(shift, yaw, FORCE)
    given = dict(vertical_shift_input=stand.vertical_shift, roll_input=stand.roll)
    best = {}
    for _ in range(effort.passes):
        for case in itertools.product(MODELS, CONTACT_MODES):
            pair = system(normal_model=case[0], contact_mode=case[1])
            found = cost(lambda: pair.evaluate_many(shift, yaw, FORCE, **given), SINE_STEPS, effort.rounds)
            best[case] = found.least(best.get(case))
    return {model: {mode: best[model, mode] for mode in CONTACT_MODES} for model in MODELS}


def derivative_times(effort):
    """By case: :class:`~benchmarks.machine.Cost` of a step and a derivative along the lateral shift."""
    works = {name: derivatives(options) for name, options in DERIVATIVES.items()}
    best = {}
    for _ in range(effort.passes):
        for name, work in works.items():
            best[name] = cost(work, DERIVATIVE_POSES, effort.rounds).least(best.get(name))
    return best


def derivatives(options):
    """A function that takes DERIVATIVE_POSES steps, each with its derivative."""
    stepper = system(**options).stepper()
    shift, yaw = trajectory(DERIVATIVE_POSES)
    inputs = inputs_of((shift, yaw))
    stand = system(contact_mode="elastic").evaluate_many(shift, yaw, FORCE)
    inputs[:, layout.IN_VERTICAL_SHIFT], inputs[:, layout.IN_ROLL] = stand.vertical_shift, stand.roll
    along = np.eye(layout.INPUT_COUNT)[layout.IN_LATERAL_SHIFT]

    def work():
        for row in inputs:
            stepper.inputs[:] = row
            stepper.step()
            stepper._bound.derivative(along)

    return work
