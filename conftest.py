"""Makes the tests use the installed wrcontact; pytest reads this file before any test.

``python -m pytest`` puts this folder first in ``sys.path``, so ``wrcontact/`` here would hide the installed
package, and a file that is missing from it would not be noticed.  So this folder is moved to the end:
``import wrcontact`` finds what pip installed (with ``pip install -e .`` the source here), and the source here
only if nothing is installed.  The other parts of the repository (build_fmu, benchmarks, tools, ...) are still
found.

If the installed copy differs from the source here, the test run ends at once.

Modules and tests that are collected live to the end: Python's search for garbage passes over them.  Linear
algebra runs in one thread: several processes test at once, and threads that wait for each other use their
cores.
"""

import gc
import importlib.util
import os
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when numpy is imported


def is_root(entry):
    return Path(entry or ".").resolve() == ROOT


sys.path[:] = [entry for entry in sys.path if not is_root(entry)] + [str(ROOT)]


def outdated_file():
    """A module here that is missing or different in the installed package; None if there is none."""
    installed = Path(importlib.util.find_spec("wrcontact").origin).parent
    if installed == ROOT / "wrcontact":
        return None
    for folder, copies in ((ROOT / "wrcontact", installed), (ROOT / "fmu_src", installed / "fmu_src")):
        for path in sorted(folder.rglob("*.py")):
            copy = copies / path.relative_to(folder)
            if not copy.exists() or copy.read_bytes() != path.read_bytes():
                return path
    return None


def pytest_sessionstart(session):
    path = outdated_file()
    if path:
        pytest.exit(
            f"The installed wrcontact is not the one of this folder: {path.relative_to(ROOT)} "
            f"differs. "
            "Run 'pip install .' again, or once 'pip install -e .'.",
            returncode=4,
        )


@pytest.hookimpl(wrapper=True)
def pytest_collection():
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()
