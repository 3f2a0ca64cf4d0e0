"""Processes that are ended while they write, disks that are full, and what they leave."""

import contextlib
import resource
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from tests.helpers.command_line import OUTSIDE
from wrcontact.profiles import standard_profile
from wrcontact.storage import atomic

WRITER = Path(atomic.__file__)
needs_linux = pytest.mark.skipif(
    sys.platform != "linux", reason="signals, limits and devices are those of Linux"
)


def parts_in(folder):
    """What writers have left."""
    return list(Path(folder).glob(".wrcontact-*.part"))


def cli(*words, before="", **settings):
    """The command line in a process of its own, running; it hears interrupts also where these tests run in
    the background of a shell, which passes on to ignore them."""
    return _program(f"{before}\nfrom wrcontact.cli import main; main()", words, settings)


def loaded_cli(*words, **settings):
    """The same, returned when the package has been loaded, however long that takes on a busy machine."""
    program = _program("from wrcontact.cli import main; print('loaded', flush=True); main()", words, settings)
    assert program.stdout.readline() == "loaded\n", program.communicate()
    return program


def usual_signals():
    """Take signals as a terminal's programs do: a shell's background and nohup ignore some of them."""
    for number in (signal.SIGINT, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


def _program(source, words, settings):
    command = [sys.executable, "-c", source, *map(str, words)]
    return subprocess.Popen(
        command,
        env=OUTSIDE,
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        preexec_fn=usual_signals,
        **settings,
    )


@contextlib.contextmanager
def largest_file(size):
    """No file may grow beyond ``size`` bytes here, as on a disk that is full."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


def assert_files_are_whole(folder):
    """Every table, picture, page and FMU; how many there are."""
    found = [file for file in Path(folder).rglob("*") if file.is_file() and file.suffix != ".part"]
    for file in found:
        content = file.read_bytes()
        if file.suffix == ".csv":
            rows = content.decode().splitlines()
            assert content.endswith(b"\n") and len({row.count(",") for row in rows if '"' not in row}) == 1, (
                file
            )
        elif file.suffix == ".png":
            assert content.endswith(b"IEND\xaeB`\x82"), file
        elif file.suffix == ".fmu":
            assert fmpy_finds_nothing(file), file
        else:
            assert file.name == "figures.md" and content.endswith(b"\n"), file
    return len(found)


def fmpy_finds_nothing(file):
    from fmpy import read_model_description  # raises where it finds something

    return read_model_description(str(file), validate_model_structure=True) is not None


BUILD = (
    "import sys; from wrcontact.fmu.native import build_native_fmus as build; "
    "print(*build(sys.argv[1], cache=sys.argv[2]))"
)


def building(folder, cache, **settings):
    """A process that builds the native FMUs."""
    command = [sys.executable, "-c", BUILD, str(folder), str(cache)]
    return subprocess.Popen(
        command,
        env=OUTSIDE,
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        preexec_fn=usual_signals,
        **settings,
    )


def points_of(name):
    """A standard profile as lines of points [mm]."""
    profile = standard_profile(name)
    y = np.arange(profile.start + 1e-4, profile.stop - 1e-4, 1e-4)
    return "".join(f"{1e3 * a:.6f} {1e3 * b:.6f}\n" for a, b in zip(y, profile.height(y)))
