"""Sweeps by the workers of Dask: nothing is lost where they die; profiles are shipped by their content."""

import os
import signal
import time
from dataclasses import replace

import pytest

import wrcontact
from tests.helpers.faults import needs_linux
from tests.helpers.sweeps import AXES, in_memory, points_file
from wrcontact.sweeps import workers
from wrcontact.sweeps.specification import asked
from wrcontact.sweeps.stores import opened
from wrcontact.sweeps.workers import Task

pytest.importorskip("zarr")
xarray, distributed = pytest.importorskip("xarray"), pytest.importorskip("distributed")


@pytest.fixture(scope="module")
def client():
    """Of two processes with one thread each, which are started again when they die."""
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        yield client


@needs_linux
@pytest.mark.parametrize("dying, after", [(1, 0), (2, 0), (2, 2)])
def test_workers_die(tmp_path, client, dying, after):
    """One of two, or both, with a profile file that the workers do not have; at once, or some time after the
    third block, when other blocks are finished whose numbers have not been fetched."""
    file = points_file(tmp_path / "worn.csv", wrcontact.ContactSystem().wheel)
    system = wrcontact.ContactSystem(wheel=str(file))
    file.unlink()
    client.wait_for_workers(2, 60)
    pids, told = list(client.run(os.getpid).values()), []

    def progress(*numbers):
        told.append(numbers)
        if len(told) == 3:
            time.sleep(after)
            for pid in pids[:dying]:
                os.kill(pid, signal.SIGKILL)

    found = in_memory(system, store=tmp_path / "a.zarr", client=client, progress=progress)
    xarray.testing.assert_identical(found.load(), in_memory(system))
    assert told[-1][:2] == (480, 480) and len(told) <= 24 + (dying - 1)  # no block is told twice
    assert set(client.run(os.getpid).values()) != set(pids)


def test_a_cluster_goes_on_where_this_process_was(tmp_path, client):
    """And says when a worker does not see the folder."""
    specification = asked(wrcontact.ContactSystem(), AXES, ["roll"], {})
    store = opened(tmp_path / "a.zarr", specification, 20, None)
    task = Task(specification, store)
    for corner in task.missing()[:7]:
        task.solve(corner)
    told = []
    found = wrcontact.sweep(
        wrcontact.ContactSystem(),
        AXES,
        ["roll"],
        tmp_path / "a.zarr",
        client=client,
        progress=lambda *numbers: told.append(numbers),
    )
    assert len(told) == 24 - 7 and not len(task.missing())
    xarray.testing.assert_identical(
        found.load(), wrcontact.sweep(wrcontact.ContactSystem(), AXES, ["roll"], block=20, progress=False)
    )
    store.identity = "another folder of this name"
    with pytest.raises(RuntimeError, match="a worker does not see the store .*a.zarr; permitted is a folder"):
        task.solve([0, 0, 0])


def test_a_worker_has_another_version(tmp_path):
    task = replace(Task(None, None), version="9.9")
    with pytest.raises(RuntimeError, match=f"has wrcontact {wrcontact.__version__}; permitted is 9.9, which"):
        workers._solve([0], task)


def test_a_scheduler_without_workers(tmp_path, monkeypatch):
    monkeypatch.setattr("wrcontact.workers.ARRIVAL", 0.2)
    with (
        distributed.LocalCluster(n_workers=0, dashboard_address=":0", processes=False) as cluster,
        distributed.Client(cluster) as client,
        pytest.raises(RuntimeError, match="the scheduler .* has no workers"),
    ):
        in_memory(store=tmp_path / "a.zarr", client=client)
