"""A system goes on in other processes; bits do not depend on the threads of the libraries beneath."""

import hashlib
import multiprocessing
import os
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor

import numpy as np
import pytest

from tests.helpers.cases import poses
from tests.helpers.command_line import OUTSIDE
from tests.helpers.faults import needs_linux, points_of
from wrcontact import ContactSystem

pytestmark = needs_linux


def contact_of(system, rows):
    """All outputs of rows that are evaluated one after the other, as a few bytes."""
    return hashlib.sha256(b"".join(system.evaluate(**row).values.tobytes() for row in rows)).digest()


@pytest.mark.full
@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_a_system_goes_on_in_other_processes(method):
    """One that has been used before: after a fork with all that it keeps, after a spawn made
    anew from its parameters."""
    system, rows = ContactSystem(rail="54E1"), poses(8)
    system.evaluate(2e-3)
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context(method)) as pool:
        found = list(pool.map(contact_of, [system] * 4, [rows] * 4))
    assert set(found) == {contact_of(ContactSystem(rail="54E1"), rows)}


def test_a_system_goes_on_after_a_bare_fork():
    """In both processes, each with its own memory."""
    system, rows = ContactSystem(), poses(8)
    contact_of(system, rows[:4])
    inlet, outlet = os.pipe()
    if (child := os.fork()) == 0:
        os.write(outlet, contact_of(system, rows[4:]))
        os._exit(0)
    here, there = contact_of(system, rows[4:]), os.read(inlet, 100)
    os.close(inlet), os.close(outlet), os.waitpid(child, 0)
    assert here == there


ANSWERS = """
import hashlib, sys, warnings
import numpy as np
import wrcontact
warnings.simplefilter("ignore")
found = hashlib.sha256()
shifts = np.linspace(-7e-3, 7e-3, 41)
for options in ({}, {"contact_mode": "elastic", "normal_model": "analyn_strip"}, {"wheel": sys.argv[1]},
                {"wheel": sys.argv[1], "smoothing": 2e-5, "lateral_curvature": "smooth"}):
    table = wrcontact.ContactSystem(**options).evaluate_many(lateral_shift=shifts, yaw=2e-3)
    found.update(table.values.tobytes())
for shift in (0.0, 5.5e-3):
    state = wrcontact.ContactSystem(normal_model="halfspace", tolerance=0.02).evaluate(shift)
    found.update(state.values.tobytes())
print(found.hexdigest())
"""


@pytest.mark.full
def test_bits_do_not_depend_on_the_threads_of_blas(tmp_path):
    """Of measured profiles that are mended and smoothed, and of the half-space, which use scipy."""
    wheel, chance = tmp_path / "wheel.txt", np.random.default_rng(5)
    points = np.array([list(map(float, line.split())) for line in points_of("S1002").splitlines()])
    np.savetxt(wheel, points + [0.0, 5e-3] * chance.standard_normal(points.shape), fmt="%.6f")
    answers = set()
    for threads in ("1", "7"):
        limits = dict.fromkeys(("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"), threads)
        done = subprocess.run(
            [sys.executable, "-c", ANSWERS, str(wheel)],
            env={**OUTSIDE, **limits},
            text=True,
            capture_output=True,
            timeout=300,
        )
        assert done.returncode == 0, done.stderr
        answers.add(done.stdout)
    assert len(answers) == 1
