"""Steps of the compiled kernel and of its Python source, in processes of their own; and poses for both:
tread, flange, jumps, and what no wheelset can have."""

import atexit
import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import wrcontact
from tests.helpers.cases import input_row
from wrcontact.interface.inputs import RAILS
from wrcontact.kernel.binding.files import LIBRARY_NAME
from wrcontact.kernel.layout import IN_LATERAL_SHIFT, IN_ROLL, IN_VERTICAL_SHIFT, IN_YAW, INPUT_COUNT

PACKAGE = Path(wrcontact.__file__).parent
KERNEL = PACKAGE / "kernel"
needs_library = pytest.mark.skipif(not (KERNEL / LIBRARY_NAME).exists(), reason="no compiled library here")

RUN = """
import json
import sys
import numpy as np
import {package} as wrcontact
for line in sys.stdin:
    poses, steps, parameters = json.loads(line)
    stepper = wrcontact.ContactSystem(**parameters).stepper()
    rows = []
    for pose in np.load(poses):
        stepper.inputs[:len(pose)] = pose
        rows.append([stepper.step(), *stepper.outputs])
    np.save(steps, np.array(rows))
    print("done", flush=True)
"""
#: Processes that step, by the choice of kernel and the package; one serves all tests of a file.
RUNNING = {}


def run_steps(rows, folder, *, choice, package=PACKAGE, **parameters):
    """[status, outputs] of each pose, from a process of its own in which ``package`` runs the ``choice`` of
    kernel, by a new ContactSystem."""
    np.save(folder / "poses.npy", rows)
    child = RUNNING.get((choice, package))
    if child is None:
        code = RUN.format(package=package.name)
        child = RUNNING[choice, package] = subprocess.Popen(
            [sys.executable, "-W", "always", "-c", code],
            cwd=package.parent,
            text=True,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            env=environment(package.parent, choice),
        )
        atexit.register(child.kill)
    line = json.dumps([str(folder / "poses.npy"), str(folder / "steps.npy"), parameters]) + "\n"
    try:
        child.stdin.write(line)
        child.stdin.flush()
    except BrokenPipeError:
        pass  # the next line is empty, and stderr says why
    if child.stdout.readline() != "done\n":
        del RUNNING[choice, package]
        raise AssertionError(child.stderr.read())
    return np.load(folder / "steps.npy")


def environment(path, choice):
    return {**os.environ, "PYTHONPATH": str(path), "WRCONTACT_KERNEL": choice}


def run_python(code, path, choice, *arguments):
    """Run ``code`` with ``path`` in front of the module path, away from this checkout."""
    return subprocess.run(
        [sys.executable, "-W", "always", "-c", code, *map(str, arguments)],
        cwd=path,
        text=True,
        capture_output=True,
        env=environment(path, choice),
    )


def bits(array):
    return np.ascontiguousarray(array).view(np.int64)


RAIL_PLACES = range(7, 7 + len(RAILS))

#: Every contact mode with every normal model, and the vertical load.
FORMS = [
    {"contact_mode": "elastic", "normal_model": "analyn"},
    {"contact_mode": "elastic", "normal_model": "analyn_strip", "load": "vertical"},
    {"contact_mode": "elastic", "normal_model": "hertz"},
    {"contact_mode": "compliant", "normal_model": "analyn"},
    {"contact_mode": "compliant", "normal_model": "analyn_strip"},
    {"contact_mode": "compliant", "normal_model": "hertz"},
    {"load": "vertical"},
    {"load": "vertical", "normal_model": "hertz"},
    {
        "contact_mode": "elastic",
        "load": "vertical",
        "separation": "equidistant",
        "lateral_curvature": "smooth",
    },
]


def id_of(parameters):
    return "-".join(map(str, parameters.values())) or "default"


def poses(count, seed=20):
    """Inputs (count, n) over tread and flange: cold jumps, a slow run, and some that no wheelset can have;
    heights and rolls around those of rigid contact, from lifted wheels to 0.2 mm deep ones. Rails are moved
    at one of ten, and every other wheelset runs."""
    rng = np.random.default_rng(seed)
    rows = np.zeros((count, INPUT_COUNT))
    rows[:, :7] = np.column_stack(
        [
            rng.uniform(-8e-3, 8e-3, count),  # lateral shift [m]
            rng.uniform(-0.02, 0.02, count),  # yaw [rad]
            rng.uniform(-1e-3, 1e-3, count),  # roll guess [rad]
            rng.uniform(2e4, 1.5e5, count),  # normal force [N]
            rng.uniform(-0.5, 0.5, count),  # load transfer
            rng.uniform(-5e-5, 2e-4, count),  # height below rigid contact [m]
            rng.uniform(-1e-4, 1e-4, count),
        ]
    )  # roll beyond it [rad]
    rows[::4, 1] = 0.0
    run = count // 2
    rows[run:, 0] = np.linspace(-7e-3, 7e-3, count - run)
    rigid = wrcontact.ContactSystem().evaluate_many(
        rows[:, IN_LATERAL_SHIFT], rows[:, IN_YAW], outputs="geometry"
    )
    rows[:, IN_VERTICAL_SHIFT] += rigid.vertical_shift
    rows[:, IN_ROLL] += rigid.roll
    rows[run::7, :7] = [[np.nan, 0.0, 0.0, 7e4, 0.0, 0.0, 0.0]]
    rows[run + 1 :: 7, :7] = [[0.3, 0.0, 0.0, 7e4, 0.0, 0.0, 0.0]]
    rows[run + 2 :: 7, 3] = 0.0
    for place in RAIL_PLACES:
        rows[3::10, place] = rng.uniform(-2e-4, 2e-4, len(rows[3::10]))
    motion = slice(7 + len(RAILS), None)
    rows[:, motion] = input_row()[motion]
    rows[::2, motion] += rng.normal(size=rows[::2, motion].shape)
    return rows
