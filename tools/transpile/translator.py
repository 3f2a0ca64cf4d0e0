"""Pyccel's C for the kernel's modules."""

import importlib.metadata
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from .modules import Refused

PYCCEL_VERSION = "2.2.3"  # the same as in pyproject.toml: another version may write other C
START = Path(__file__).with_name("pyccel_start.py")


def run_pyccel(modules, stubs=None):
    """Pyccel's header and code, by module name; ``stubs`` are texts of modules that these import and that are
    not translated."""
    found = installed_pyccel()
    if found != PYCCEL_VERSION:
        raise Refused(f'it needs Pyccel {PYCCEL_VERSION}, and here is {found}; pip install ".[dev]"')
    with tempfile.TemporaryDirectory() as folder:
        for module in modules:
            Path(folder, f"{module.name}.py").write_bytes(module.source())
        for name, text in (stubs or {}).items():
            Path(folder, f"{name}.py").write_text(text, encoding="utf-8")
        command = [
            sys.executable,
            str(START),
            "make",
            "--language",
            "C",
            "--convert-only",
            "--output",
            "out",
            "--files",
            *(f"{module.name}.py" for module in modules),
            *(f"{name}.py" for name in stubs or ()),
        ]
        # Pyccel would name its folder after the worker of a test run, as __pyccel__gw0
        environment = {name: value for name, value in os.environ.items() if name != "PYTEST_XDIST_WORKER"}
        run = subprocess.run(
            command,
            cwd=folder,
            text=True,
            encoding="utf-8",
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            env={**environment, "PYTHONUTF8": "1", "PYTHONHASHSEED": "0"},
        )
        if run.returncode:
            raise Refused(f"Pyccel says\n{run.stdout}")
        out = Path(folder, "out", "__pyccel__")
        return {
            module.name: tuple(
                (out / (module.name + end)).read_text(encoding="utf-8") for end in (".h", ".c")
            )
            for module in modules
        }


def installed_pyccel():
    """Version of Pyccel in this Python, or 'none'."""
    try:
        return importlib.metadata.version("pyccel")
    except importlib.metadata.PackageNotFoundError:
        return "none"
