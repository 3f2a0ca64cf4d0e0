"""Computations that can be skipped: the cost of each skip beside the full cost, and its effect on the
result."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from . import errors, runs
from .machine import Cost, cost
from .rows import batch, system

NO_YAW, COARSE = "no yaw", "tolerance 0.02 instead of 0.0015"


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
    straight, yawed = runs.trajectory(effort.count, yaw=0.0), runs.trajectory(effort.count)
    count, full = effort.count, batch(system(), runs.trajectory(effort.count, yaw=0.0))
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


def answers():
    """Errors on the hunting run of the skips that change the result [%], by their names."""
    ignored, coarse, fine = (errors.hunting(system(), yawed=False), errors.hunting(system(tolerance=0.02)),
                             errors.hunting(system(tolerance=0.0015)))
    return {NO_YAW: {"mean": 100 * ignored.mean, "worst": 100 * ignored.worst},
            COARSE: {"mean": 100 * coarse.mean, "fine": 100 * fine.mean}}


def resting(count):
    """Steps of a stepper at one pose, and at poses that change in the last digits."""
    stepper = system().stepper()
    stepper.inputs[:] = runs.rows(([1e-3], [0.0]))[0]

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
    return lambda: system().evaluate_many(shift, yaw, runs.FORCE, transfer)


def wrong_start(poses):
    """Poses with a given roll guess, which start the search without known contacts."""
    shift, yaw = poses
    return lambda: system().evaluate_many(shift, yaw, runs.FORCE, roll_guess=1e-3, outputs="geometry")


def sunk(poses):
    """Poses with their own mean penetration prescribed instead of the force."""
    shift, yaw = poses
    table = system().evaluate_many(shift, yaw, runs.FORCE)
    mean = tuple(float(np.mean(side.penetration)) for side in (table.left, table.right))
    return batch(system(), poses, penetration=mean)
