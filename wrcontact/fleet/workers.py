"""Who does the work: this process, processes on this machine, or the workers of a dask scheduler."""

import multiprocessing
import os
import signal
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing.spawn import get_preparation_data

from ..results.convert import needed

#: Pairs that make it worth while to start one more process, which takes a second.
SHARE = 8
#: Tasks that are handed to each worker before it asks for them.
AHEAD = 3
#: Time in which a scheduler must answer [s].
PATIENCE = 10


class Here:
    """An executor that works at once, in this process."""

    def submit(self, function, *arguments):
        """A Future with the result."""
        future = Future()
        future.set_result(function(*arguments))
        return future


@contextmanager
def workers(processes, scheduler, pairs):
    """An executor and how many tasks may be under way: the workers of the dask ``scheduler``, an address or a
    client, where there is one; otherwise ``processes``, by default one for each core.

    Raises
    ------
    ImportError, ValueError
        if dask is not installed, or its scheduler does not answer.
    RuntimeError
        if a process ends early.
    """
    if scheduler is not None:
        with _client(scheduler) as client:
            yield client.get_executor(pure=False), AHEAD * max(1, len(client.nthreads()))
        return
    affinity = getattr(os, "sched_getaffinity", None)
    cores = len(affinity(0)) if affinity else os.cpu_count() or 1
    count = processes or min(cores, max(1, pairs // SHARE))
    if count == 1:
        yield Here(), 1
        return
    # a process that runs the script again as it starts is refused here, before it has a pool to leave behind
    get_preparation_data("")
    pool = ProcessPoolExecutor(count, multiprocessing.get_context("spawn"), _begin)
    try:
        yield pool, AHEAD * count
    except BrokenProcessPool:
        raise RuntimeError(
            f"a process of {count} has ended early: there is too little memory, or the call "
            "does not stand below \"if __name__ == '__main__':\" in a script; pairs that are "
            "done are kept, and the next run continues"
        ) from None
    finally:
        pool.shutdown(cancel_futures=True)


def _begin():
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C ends the process that hands out the work


@contextmanager
def _client(scheduler):
    """The dask client of an address, closed in the end; a client that was given stays open."""
    if not isinstance(scheduler, str):
        yield scheduler
        return
    distributed = needed("distributed", "a scheduler", extra="cluster")
    try:
        client = distributed.Client(scheduler, timeout=PATIENCE)
    except (OSError, TimeoutError, ValueError) as wrong:
        raise ValueError(
            f"scheduler is {scheduler!r}, where no dask scheduler answers within {PATIENCE} s "
            f"({type(wrong).__name__}); permitted are addresses such as "
            "'tcp://host:8786'"
        ) from None
    try:
        yield client
    finally:
        client.close()


def results(executor, most, function, tasks):
    """(key, result) of each of the ``tasks``, {key: arguments}, as they are done; at ``most`` so many are
    under way, since each holds its profiles."""
    waiting, running = iter(tasks), {}
    while True:
        for _, key in zip(range(most - len(running)), waiting):
            running[executor.submit(function, *tasks[key])] = key
        if not running:
            return
        for future in wait(running, return_when=FIRST_COMPLETED).done:
            yield running.pop(future), future.result()
