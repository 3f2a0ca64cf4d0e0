"""Who does the work: this process, processes on this machine, or the workers of a dask scheduler."""

from concurrent.futures import Future
from contextlib import contextmanager

from ..stepper import core_count
from ..workers import dask_client, process_pool

#: Pairs that make it worth while to start one more process, which takes a second.
SHARE = 8
#: Tasks that are handed to each worker before it asks for them.
AHEAD = 3


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
        with dask_client(scheduler) as client:
            yield client.get_executor(pure=False), AHEAD * max(1, len(client.nthreads()))
        return
    count = processes or min(core_count(), max(1, pairs // SHARE))
    if count == 1:
        yield Here(), 1
        return
    kept = "; pairs that are done are kept, and the next run continues"
    with process_pool(count, remark=kept) as pool:
        yield pool, AHEAD * count
