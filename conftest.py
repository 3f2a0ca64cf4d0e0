"""Which wrcontact the tests see, as pytest reads this before any test: the installed one.

``python -m pytest`` puts this folder in front of ``sys.path``, so that ``wrcontact/`` here would hide the installed package,
and a file missing from that would not be noticed.  So this folder goes to the end: ``import wrcontact`` finds what pip
installed (with ``pip install -e .`` that is the source here), and the source here only where nothing is installed.  The
rest of the repository (build_fmu, benchmarks, tools, ...) is still found.

An installed copy that is not of this source any more would be tested by mistake: that ends the run at once.
"""

import importlib.util
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent


def is_root(entry):
    return Path(entry or ".").resolve() == ROOT


sys.path[:] = [entry for entry in sys.path if not is_root(entry)] + [str(ROOT)]


def outdated_file():
    """A module here that the installed package has not, or has otherwise; None where there is none."""
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
        pytest.exit(f"The installed wrcontact is not the one of this folder: {path.relative_to(ROOT)} differs. "
                    "Run 'pip install .' again, or once 'pip install -e .'.", returncode=4)
