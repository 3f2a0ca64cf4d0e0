"""Who shares work: processes of this machine, and the workers of a Dask scheduler."""

import multiprocessing
import signal
from concurrent.futures import FIRST_COMPLETED, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing.spawn import get_preparation_data

from .results.convert import needed

#: Time in which a scheduler must answer, and in which it must have a worker [s].
PATIENCE, ARRIVAL = 10, 30


class ProcessEnded(RuntimeError):
    """A process of a pool has ended before its work was done."""


@contextmanager
def process_pool(count, begin=None, arguments=(), remark=""):
    """A pool of ``count`` new processes, closed in the end; what has not begun then is not done.

    An interrupt ends the process that hands out the work alone. Each process calls ``begin(*arguments)`` before its
    first task; long ``arguments`` belong in a file, since a process that dies at its start never reads them, and
    sending them would block for ever.

    Raises
    ------
    ProcessEnded
        if a process ends early, with the ``remark`` behind the sentence.
    RuntimeError
        by multiprocessing, before any process is there, if the script that calls this runs it again in each
        process.
    """
    get_preparation_data("")
    context = multiprocessing.get_context("spawn")
    pool = ProcessPoolExecutor(count, context, _begin, (begin, arguments))
    try:
        yield pool
    except BrokenProcessPool:
        raise ProcessEnded(
            f"a process of {count} has ended early: there is too little memory, or the call does not stand below "
            f"\"if __name__ == '__main__':\" in a script{remark}"
        ) from None
    finally:
        pool.shutdown(cancel_futures=True)


def _begin(begin, arguments):
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if begin:
        begin(*arguments)


@contextmanager
def dask_client(scheduler):
    """The Dask client of an address, closed in the end; a client that is given stays open.

    Raises
    ------
    ImportError
        if dask.distributed is not installed.
    ValueError
        if no scheduler answers at the address.
    """
    if not isinstance(scheduler, str):
        yield scheduler
        return
    distributed = needed("distributed", "a scheduler", extra="cluster")
    try:
        client = distributed.Client(scheduler, timeout=PATIENCE)
    except (OSError, TimeoutError, ValueError) as wrong:
        raise ValueError(
            f"scheduler is {scheduler!r}, where no dask scheduler answers within {PATIENCE} s "
            f"({type(wrong).__name__}); permitted is the address that 'dask scheduler' prints, such as "
            "tcp://host:8786"
        ) from None
    try:
        yield client
    finally:
        client.close()


def await_workers(client):
    """RuntimeError where the scheduler of a Dask client has no workers for some time."""
    try:
        client.wait_for_workers(1, ARRIVAL)
    except TimeoutError:
        raise RuntimeError(f"the scheduler {client.scheduler.address} has no workers") from None


def results(executor, most, function, tasks):
    """(key, result) of each of the ``tasks``, {key: arguments}, as they are done; at ``most`` so many are
    under way, since each holds its arguments."""
    waiting, running = iter(tasks), {}
    while True:
        for _, key in zip(range(most - len(running)), waiting):
            running[executor.submit(function, *tasks[key])] = key
        if not running:
            return
        for future in wait(running, return_when=FIRST_COMPLETED).done:
            yield running.pop(future), future.result()
