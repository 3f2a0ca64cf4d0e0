"""The rows of a table with the half-space, shared by several processes."""

import math
import multiprocessing
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from ..stepper import Stepper
from .stepping import halfspace_solver

CHUNK = 2                # rows that a process takes at a time

_worker = None           # in a worker: its stepper, and the places of the outputs that are wanted


def shared_parts(tables, solver, rows, places, processes):
    """Evaluate ``rows`` of inputs (n, inputs) in ``processes``; yields what
    :meth:`~wrcontact.stepper.Stepper.parts` yields, in the order of the rows and with the same numbers.

    Parameters
    ----------
    tables : of a stepper's right and left side, with what is wanted and prescribed.
    solver : arguments of :func:`~wrcontact.halfspace.stepping.halfspace_solver`.
    places : of the wanted outputs, None for all.

    Raises
    ------
    RuntimeError
        where the processes cannot start or end early.
    """
    parts = [slice(start, min(start + CHUNK, len(rows))) for start in range(0, len(rows), CHUNK)]
    with TemporaryDirectory() as folder:
        # a process that ends as it starts leaves its arguments unread, and long ones then wait for ever
        path = Path(folder, "tables.npz")
        right, left = tables
        np.savez(path, right=right, **({} if left is right else {"left": left}))
        pool = ProcessPoolExecutor(min(processes, len(parts)), multiprocessing.get_context("spawn"), _begin,
                                   (path, solver, places))
        try:
            for part, (found, status) in zip(parts, pool.map(_evaluated, [rows[part] for part in parts])):
                yield part, found, status
        except BrokenProcessPool:
            raise RuntimeError(f"processes is {processes}; permitted is more than 1 in a script that makes "
                               "this call below \"if __name__ == '__main__':\"; a process has ended "
                               "early") from None
        finally:
            pool.shutdown(cancel_futures=True)


def _begin(path, solver, places):
    global _worker
    with np.load(path) as tables:
        _worker = Stepper(tables["right"], halfspace_solver(*solver), tables.get("left")), places


def _evaluated(rows):
    """Outputs and status of some rows."""
    stepper, places = _worker
    outputs, status = np.full((len(rows), len(stepper.outputs)), math.nan), np.empty(len(rows))
    stepper.step_many(rows, outputs, status)
    return outputs if places is None else outputs[:, places], status.astype(int)
