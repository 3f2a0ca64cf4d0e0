"""Steps of the compiled kernel and of its Python source, each in a process of its own."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import wrcontact
from wrcontact.kernel.binding.platforms import LIBRARY_NAME

PACKAGE = Path(wrcontact.__file__).parent
KERNEL = PACKAGE / "kernel"
needs_library = pytest.mark.skipif(not (KERNEL / LIBRARY_NAME).exists(), reason="no compiled library here")

RUN = """
import json
import sys
import numpy as np
import {package} as wrcontact
stepper = wrcontact.ContactSystem(**json.loads(sys.argv[3])).stepper()
rows = []
for pose in np.load(sys.argv[1]):
    stepper.inputs[:] = pose
    rows.append([stepper.step(), *stepper.outputs])
np.save(sys.argv[2], np.array(rows))
"""


def run_steps(rows, folder, *, choice, package=PACKAGE, **parameters):
    """[status, outputs] of each pose, from a fresh process in which ``package`` runs the
    ``choice`` of kernel."""
    np.save(folder / "poses.npy", rows)
    child = run_python(RUN.format(package=package.name), package.parent, choice, folder / "poses.npy",
                       folder / "steps.npy", json.dumps(parameters))
    assert child.returncode == 0, child.stderr
    return np.load(folder / "steps.npy")


def run_python(code, path, choice, *arguments):
    """Run ``code`` with ``path`` in front of the module path, away from this checkout."""
    return subprocess.run([sys.executable, "-W", "always", "-c", code, *map(str, arguments)], cwd=path,
                          text=True, capture_output=True,
                          env={**os.environ, "PYTHONPATH": str(path), "WRCONTACT_KERNEL": choice})


def bits(array):
    return np.ascontiguousarray(array).view(np.int64)
