"""Long tables, shared among threads: the same bits as by one."""

import os
import threading

import numpy as np
import pytest

import wrcontact
from wrcontact import stepper
from wrcontact.stepper import SHARED_ROWS, thread_count

#: Rows: three whole blocks and a part of one.
COUNT = 3 * SHARED_ROWS + 77


def table(threads, system, **asked):
    """Random poses, of which some are invalid, unloaded or off the profile."""
    rng = np.random.default_rng(20)
    poses = {
        "lateral_shift": rng.uniform(-8e-3, 8e-3, COUNT),
        "yaw": rng.uniform(-0.03, 0.03, COUNT),
        "normal_force": rng.uniform(1e3, 2e5, COUNT),
    }
    poses["lateral_shift"][::50] = np.nan
    poses["lateral_shift"][7::90] = 0.03
    poses["normal_force"][3::70] = 0.0
    return system.evaluate_many(threads=threads, **poses, **asked)


@pytest.mark.parametrize(
    "methods, asked",
    [
        ({}, {}),
        ({"tangential_model": "polach"}, {"speed": 20.0, "outputs": ["status", "force", "right.patch"]}),
        ({"contact_mode": "elastic", "normal_model": "hertz"}, {"side": "right"}),
        ({"normal_model": "hertz"}, {"penetration": 5e-5, "outputs": "patches"}),
    ],
    ids=["rigid", "names", "one_side", "penetration"],
)
def test_threads_give_the_bits_of_one(methods, asked):
    system = wrcontact.ContactSystem(**methods)
    one = table(1, system, **asked)
    assert len(set(one.status)) > 1
    for threads in (2, 3, 16):
        found = table(threads, system, **asked)
        np.testing.assert_array_equal(found.values.view(np.int64), one.values.view(np.int64))
        np.testing.assert_array_equal(found.status, one.status)
        np.testing.assert_array_equal(found.inputs, one.inputs)


@pytest.mark.parametrize("methods", [{}, {"contact_mode": "elastic"}], ids=["rigid", "elastic"])
def test_threads_give_the_bits_of_one_where_the_search_begins_near(methods):
    """Poses that change little from row to row, of which each search begins at the roll before."""
    system, shifts = wrcontact.ContactSystem(**methods), np.linspace(-6e-3, 6e-3, COUNT)
    one, two = (system.evaluate_many(shifts, yaw=2e-3, threads=threads) for threads in (1, 2))
    np.testing.assert_array_equal(two.values.view(np.int64), one.values.view(np.int64))
    parts = list(system.evaluate_parts(shifts, yaw=2e-3))
    np.testing.assert_array_equal(np.concatenate([part.values for part in parts]), one.values)


def test_as_many_threads_as_cores_and_blocks(monkeypatch):
    assert thread_count(3, 100 * SHARED_ROWS) == 3
    assert thread_count(3, 2 * SHARED_ROWS) == 2
    assert thread_count(8, SHARED_ROWS - 1) == thread_count(8, 0) == 1
    monkeypatch.setattr(os, "sched_getaffinity", lambda process: {0, 2, 5}, raising=False)
    assert thread_count(None, 100 * SHARED_ROWS) == 3


def test_each_thread_has_a_stepper_of_its_own(monkeypatch):
    """Two blocks run at the same time, each in its own memory: the first waits for the second to begin."""
    meeting, seen = threading.Barrier(2, timeout=600), {}
    plain = stepper.Stepper.step_many

    def step_many(self, *arguments):
        if threading.get_ident() not in seen:
            seen[threading.get_ident()] = self
            meeting.wait()
        plain(self, *arguments)

    monkeypatch.setattr(stepper.Stepper, "step_many", step_many)
    table(2, wrcontact.ContactSystem(normal_model="hertz"))
    assert len(seen) == len(set(map(id, seen.values()))) == 2


@pytest.mark.parametrize("threads", [0, -1, 1.5, True, "2"])
def test_a_wrong_number_of_threads_is_refused(threads):
    with pytest.raises(ValueError, match="^threads is .*; permitted is a whole number from 1 on$"):
        wrcontact.ContactSystem().evaluate_many(lateral_shift=[0.0], threads=threads)
