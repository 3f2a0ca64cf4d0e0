"""Growth of the cost with the number of wheelsets and of threads."""

import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from wrcontact.kernel import layout

from . import runs
from .machine import cost, unit
from .rows import batch, system

NUMBERS = (1, 10, 100, 1000, 10_000)
THREADS = (1, 2)


def wheelsets(numbers, rounds):
    """(number, cost per wheelset) of evaluate_many for each number of random poses."""
    for number in numbers:
        poses, repeats = runs.anywhere(number), max(1, 300 // number)
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
    inputs = runs.rows(runs.trajectory(number))
    outputs, status = np.empty((number, layout.OUTPUT_COUNT)), np.empty(number)
    stepper = system().stepper()
    return lambda: stepper.step_many(inputs, outputs, status)
