"""The wheels and the source archive of a release, built and tried."""

import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

from wrcontact import ContactSystem
from wrcontact.kernel.binding.compiler import KEPT
from wrcontact.kernel.binding.files import PLATFORMS, host_platform

ROOT = Path(__file__).resolve().parents[2]
#: A step of the installed package: where it is, whether it is compiled, its version, and one number's bits.
EVALUATE = """
import wrcontact
from wrcontact.kernel.binding import library
kernel = library.default_kernel()
state = wrcontact.ContactSystem().evaluate(lateral_shift=5e-3, yaw=1e-3)
print(library.__file__, kernel.compiled, wrcontact.__version__, state.right.penetration.hex())
"""
#: Settings of the build that the caller may have for himself.
OWN = ("WRCONTACT_PLATFORM", "WRCONTACT_KERNEL")


class ReleaseProblem(Exception):
    """What a release may not have; a sentence."""


def run(*words, **settings):
    """Run a command in the checkout; ReleaseProblem with its last lines if it fails."""
    clean = {name: value for name, value in os.environ.items() if name not in OWN}
    done = subprocess.run(
        [*map(str, words)], text=True, capture_output=True, cwd=ROOT, env={**clean, **settings}
    )
    if done.returncode:
        last = "\n".join((done.stdout + done.stderr).splitlines()[-20:])
        raise ReleaseProblem(f"{' '.join(map(str, words))} ended with code {done.returncode}:\n{last}")
    return done.stdout


def run_there(program, *words):
    """Run a program of another environment, without the packages of this one."""
    return run(program, *words, PYTHONPATH="")


def build_packages(folder, platforms, kept):
    """Build the source archive and a wheel for each of the ``platforms`` into ``folder``; their paths.

    ``kept`` is a folder for compiled sources.
    """
    pack = [sys.executable, "-m", "build", "--no-isolation", "--outdir", folder]
    run(*pack, "--sdist", ROOT)
    for name in platforms:
        run(*pack, "--wheel", ROOT, WRCONTACT_PLATFORM=name, **{KEPT: str(kept)})
    return sorted(folder.glob("wrcontact-*"))


def try_packages(folder, scratch):
    """Try the packages in ``folder`` as users would: sentences on what was done.

    The wheel of this machine and the one that its source archive gives are installed into environments of
    their own; they evaluate a pose with the bits that are known here, and the first runs the demo.
    """
    wheel = wheel_of(folder, host_platform())
    (archive,) = folder.glob("wrcontact-*.tar.gz")
    python = environment(scratch / "wheel", wheel)
    words = [tried(python, f"{wheel.name} in a new environment")]
    run_there(python.with_name("wrcontact"), "demo", "--output", scratch / "demo")
    words.append(f"wrcontact demo of {wheel.name}: all its checks hold")
    run(sys.executable, "-m", "venv", scratch / "builder")
    builder = interpreter(scratch / "builder")
    run_there(builder, "-m", "pip", "wheel", "-q", "--no-deps", "--wheel-dir", scratch / "built", archive)
    (built,) = (scratch / "built").iterdir()
    python = environment(scratch / "source", built)
    return [*words, tried(python, f"{archive.name}, built as {built.name}")]


def wheel_of(folder, platform):
    """The wheel in ``folder`` for a platform."""
    (wheel,) = folder.glob(f"wrcontact-*-py3-none-{PLATFORMS[platform].wheel}.whl")
    return wheel


def interpreter(folder):
    return folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


def environment(folder, wheel):
    """A new environment with a ``wheel`` and what it needs; its interpreter."""
    run(sys.executable, "-m", "venv", folder)
    run_there(interpreter(folder), "-m", "pip", "install", "-q", wheel)
    return interpreter(folder)


def tried(python, what):
    """A sentence, once an installed package has evaluated a pose as this one does."""
    file, compiled, version, found = run_there(python, "-I", "-W", "error", "-c", EVALUATE).split()
    expected = ContactSystem().evaluate(lateral_shift=5e-3, yaw=1e-3).right.penetration.hex()
    if not Path(file).is_relative_to(python.parents[1]) or (compiled, found) != ("True", expected):
        raise ReleaseProblem(
            f"{what}: {file}, compiled {compiled}, version {version}, gives {found} and not {expected}"
        )
    return f"{what}: version {version}, compiled, the bits of this machine"


def try_kernels(folder, platforms, scratch):
    """Run the kernels of the wheels of other ``platforms`` under emulators, where there are; a sentence."""
    place = scratch / "kernels"
    place.mkdir()
    for name in platforms:
        with zipfile.ZipFile(wheel_of(folder, name)) as archive:
            (library,) = (
                entry for entry in archive.namelist() if entry.startswith("wrcontact/kernel/_wrcontact")
            )
            place.joinpath(Path(library).name).write_bytes(archive.read(library))
    told = run(
        sys.executable,
        "-m",
        "pytest",
        "-q",
        "-rs",
        "-m",
        "",
        "-p",
        "no:cacheprovider",
        "tests/fmu/test_platforms.py",
        "-k",
        "test_kernel_on_other_machines",
        WRCONTACT_TEST_KERNELS=str(place),
    )
    shutil.rmtree(place)
    return f"kernels of the wheels under emulators: {told.strip().splitlines()[-1]}"
