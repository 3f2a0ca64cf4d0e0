"""A sweep from its specification to a data set."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import contextmanager
from os import PathLike
from typing import TYPE_CHECKING, Any

from ..interface.calls import check_count
from ..methods import Halfspace
from ..profiles.changing import refuse_changing
from ..progress import working
from ..results.convert import needed
from ..stepper import core_count
from ..system import ContactSystem
from .specification import asked
from .stores import Memory, opened
from .workers import Task, solve_here, solve_on_cluster

if TYPE_CHECKING:
    import xarray
    from numpy.typing import ArrayLike

#: States in a block: some seconds' work, beside which writing takes little time; of the half-space.
BLOCK, HALFSPACE_BLOCK = 50_000, 100
#: Numbers in a block at most, for the memory of a worker.
NUMBERS = 5_000_000


def sweep(
    system: ContactSystem,
    axes: Mapping[str, ArrayLike],
    outputs: str | Sequence[str] = "all",
    store: str | PathLike[str] | None = None,
    *,
    block: int | None = None,
    client: Any = None,
    workers: int | None = None,
    progress: bool | Callable[[int, int, int], object] = True,
    **fixed: float,
) -> xarray.Dataset:
    """A table of contacts over a grid of inputs; a sweep with a ``store`` goes on where it was stopped.

    The grid is computed in blocks, of which each is written when it is done.  A sweep that was interrupted or
    killed is continued by the same call, also with other ``workers`` or another ``client``.

    Many arguments because a sweep has a specification, a place and workers.

    Parameters
    ----------
    system : a :class:`~wrcontact.ContactSystem`.
    axes : the inputs that vary, ``{"lateral_shift": array, "yaw": array}``, by the names of
        :meth:`~wrcontact.ContactSystem.evaluate` or of an FMU; values rise, or fall.  They are the dimensions
        of the result.
    outputs : as for :meth:`~wrcontact.ContactSystem.evaluate_many`, ``["roll", "right.area"]``; the rest is
        not computed.
    store : path of a folder for a Zarr store, which is made, or continued; None keeps the table in memory.
    block : states that are computed and written at once; by default 50 000, fewer with more
        than 100 outputs; of the half-space 100.
    client : a ``dask.distributed.Client``, whose workers compute the blocks and write them to the store; None
        computes in this process.
    workers : threads in this process, of the half-space processes; None are as many as there are cores.
    progress : True shows a line with the time left, False nothing; a function is called after each block with
        the number of states done, to be done, and without a result.
    fixed : the other inputs, by keyword.

    Returns
    -------
    xarray.Dataset
        with one variable for each output, in SI, with attributes ``fmu_name``, ``units`` and ``long_name``:
        ``right.area`` is ``right_area``, ``right.patch[1].area`` is ``right_patch_1_area``.  States with
        ``status`` 2, 3 or 4 are NaN.

    Raises
    ------
    ValueError
        in one sentence, if an argument is not permitted, or the store has another specification.
    RuntimeError
        if a worker does not see the store, or cannot do its work.
    """
    specification = asked(system, axes, outputs, fixed)
    _check(store, block, client, workers)
    place = _place(specification, store, block)
    task = Task(specification, place)
    missing = task.missing()
    with _reported(progress, task.states(missing)) as advance:
        if client is not None:
            solve_on_cluster(task, client, advance)
        elif len(missing):
            solve_here(task, missing, workers or core_count(), advance)
    return place.dataset()


def _check(store, block, client, workers):
    """Refuse arguments that are not permitted, in a sentence."""
    for name, count in {"block": block, "workers": workers}.items():
        if count is not None:
            check_count(name, count)
    if client is not None and store is None:
        raise ValueError("store is None; permitted with a client is a folder")
    if client is not None and workers is not None:
        raise ValueError(f"workers is {workers}; it cannot be given with a client")
    if client is not None and not hasattr(client, "wait_for_workers"):
        raise ValueError(f"client is {client!r}; permitted is a dask.distributed.Client")


def _place(specification, store, block):
    """Where the values of a sweep are kept."""
    needed("xarray", "sweep")
    usual = HALFSPACE_BLOCK if isinstance(specification.system.methods["normal_model"], Halfspace) else BLOCK
    usual = min(usual, NUMBERS // max(1, len(specification.names)))
    if store is None:
        return Memory(specification, block or usual)
    refuse_changing(specification.system, "the store of a sweep")
    return opened(store, specification, block, usual)


@contextmanager
def _reported(progress, total):
    """Tells of the ``total`` states that are to be computed; yields a function for the numbers of states that
    are done, and of those without a result."""
    done = bad = 0

    def count(states, wrong):
        nonlocal done, bad
        done, bad = done + states, bad + wrong
        if callable(progress):
            progress(done, total, bad)

    if progress is True:
        with working("sweep", total) as advance:
            yield lambda states, wrong: advance(states)
    else:
        yield count
