"""Steps of the compiled kernel and of its Python source, in processes of their own."""

import atexit
import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import wrcontact
from wrcontact.kernel.binding.files import LIBRARY_NAME

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
            [sys.executable, "-W", "always", "-c", code], cwd=package.parent, text=True,
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            env=environment(package.parent, choice))
        atexit.register(child.kill)
    line = json.dumps([str(folder / "poses.npy"), str(folder / "steps.npy"), parameters]) + "\n"
    try:
        child.stdin.write(line)
        child.stdin.flush()
    except BrokenPipeError:
        pass                                            # the next line is empty, and stderr says why
    if child.stdout.readline() != "done\n":
        del RUNNING[choice, package]
        raise AssertionError(child.stderr.read())
    return np.load(folder / "steps.npy")


def environment(path, choice):
    return {**os.environ, "PYTHONPATH": str(path), "WRCONTACT_KERNEL": choice}


def run_python(code, path, choice, *arguments):
    """Run ``code`` with ``path`` in front of the module path, away from this checkout."""
    return subprocess.run([sys.executable, "-W", "always", "-c", code, *map(str, arguments)], cwd=path,
                          text=True, capture_output=True,
                          env=environment(path, choice))


def bits(array):
    return np.ascontiguousarray(array).view(np.int64)
