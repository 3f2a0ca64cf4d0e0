"""The blocks of a sweep, solved by threads, by the workers of Dask, or, on the half-space, by processes."""

import contextlib
import math
from concurrent.futures import CancelledError, ThreadPoolExecutor, as_completed
from dataclasses import dataclass

import numpy as np

from ..methods import Halfspace
from ..progress import silently
from ..results.convert import needed
from ..version import __version__
from ..workers import await_workers
from .grid import block_at
from .specification import SweepSpecification
from .stores import EMPTY, plain

#: Blocks that are sent to the scheduler of Dask at once.
BATCH = 200
#: Trials to send the task to the workers.
TRIALS = 5


@dataclass(frozen=True)
class Task:
    """What a worker needs to solve any block: the specification, and the store that it writes to."""

    specification: SweepSpecification
    store: object
    version: str = __version__

    def missing(self):
        """Corners (n, axes) of the blocks that are not there yet."""
        block = self.store.block
        first = _statuses(self.store.arrays()["status"], block)
        empty = first == EMPTY
        for place in np.argwhere(~empty):
            empty[tuple(place)] = self.store.lost(place, self.specification.names)
        return np.argwhere(empty) * block

    def states(self, corners):
        """The number of states in the blocks at ``corners``."""
        return sum(math.prod(piece.stop - piece.start for piece in self._at(corner)) for corner in corners)

    def _at(self, corner):
        return block_at(corner, self.store.block, self.specification.sizes)

    def solve(self, corner, **shared):
        """Solve the block at ``corner`` and write it, its status last; return the number of its states and of
        those without a result.  ``shared`` says how many threads or processes share it."""
        specification, arrays = self.specification, self.store.arrays()
        at = self._at(corner)
        parts = [values[piece] for values, piece in zip(specification.axes.values(), at)]
        grid = dict(zip(specification.axes, (one.ravel() for one in np.meshgrid(*parts, indexing="ij"))))
        table = specification.system.evaluate_many(
            outputs=specification.outputs, **grid, **specification.fixed, **shared
        )
        shape = tuple(map(len, parts))
        try:
            for name in specification.names:
                self.store.whole(arrays[plain(name)])[at] = table[name].reshape(shape)
            arrays["status"][at] = table.status.reshape(shape).astype(np.int8)
        except OSError as problem:
            problem.filename = problem.filename or self.store.path  # of a full disk there is no name
            raise
        return table.status.size, int(np.count_nonzero(table.status > 1))


def solve_here(task, corners, workers, advance):
    """Solve the blocks at ``corners`` in this process and call ``advance`` with what :meth:`Task.solve`
    returns; few blocks are shared by several threads each."""
    if isinstance(task.specification.system.methods["normal_model"], Halfspace):
        for corner in corners:
            advance(*task.solve(corner, processes=workers))
        return

    def solve(corner):
        with silently():
            return task.solve(corner, threads=max(1, workers // len(corners)))

    with ThreadPoolExecutor(workers) as pool:
        futures = [pool.submit(solve, corner) for corner in corners]
        try:
            for future in as_completed(futures):
                advance(*future.result())
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def solve_on_cluster(task, client, advance):
    """Solve the blocks that are missing by the workers of a Dask ``client``, until none is: what a worker has
    not finished when it dies is done by another one."""
    left = task.missing()
    while len(left):
        lost, reported = _solve_once(task, client, left, advance)
        before, left = left, task.missing() if lost else ()
        if lost:  # some of these may have been written
            advance(task.states(before) - task.states(left) - reported, 0)


def _solve_once(task, client, corners, advance):
    """Give every block at ``corners`` to a worker once; the number of blocks that were lost, since all
    workers that had the task have died, and of the states that were reported."""
    distributed, lost, reported = needed("distributed", "client", "cluster"), 0, 0
    shipped = _shipped(task, client)
    futures = client.map(_solve, corners.tolist(), task=shipped, pure=False, batch_size=BATCH)
    try:
        for future in distributed.as_completed(futures):
            try:
                states, wrong = future.result()
            except CancelledError:  # also where its worker has died since the block was finished
                lost += 1
                continue
            future.release()  # or it would be done again where its worker dies
            advance(states, wrong)
            reported += states
    except distributed.KilledWorker:
        raise RuntimeError(
            "several workers have died with the same block; permitted are workers that have the memory for it"
        ) from None
    finally:
        client.cancel([future for future in futures if future.status == "pending"])
    return lost, reported


def _shipped(task, client):
    """The ``task`` with every worker; again where one dies meanwhile."""
    for trial in range(TRIALS):
        await_workers(client)
        try:
            return client.scatter(task, broadcast=True, hash=False)
        except (TimeoutError, KeyError):  # the scheduler looks for a worker that it has just lost
            if trial == TRIALS - 1:
                raise


def _solve(corner, task):
    """One block on a worker."""
    if task.version != __version__:
        raise RuntimeError(f"a worker has wrcontact {__version__}; permitted is {task.version}, which asks")
    return task.solve(corner, threads=1)


def _statuses(array, block):
    """The status of the first state of each block; EMPTY where it is damaged and cannot be read."""
    places = tuple(slice(None, None, width) for width in block)
    try:
        return np.array(array[places])
    except OSError:
        raise
    except Exception:  # a damaged chunk fails in many ways
        count = [-(-size // width) for size, width in zip(array.shape, block)]
        found = np.full(count, EMPTY)
        for place in np.ndindex(*count):
            with contextlib.suppress(Exception):
                found[place] = array[tuple(k * width for k, width in zip(place, block))]
        return found
