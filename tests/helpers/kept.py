"""What tests keep from one run to the next: compiled sources, and FMUs by a hash of all that they are made
of.

They lie in the user's cache; WRCONTACT_TEST_CACHE names another folder, or is "off": then nothing outlives
the run.  What no run has used for a month is removed.
"""

import contextlib
import hashlib
import os
import shutil
import sys
import tempfile
import time
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from wrcontact.fmu import SOURCES, build_fmu
from wrcontact.fmu.native import build_native_fmus
from wrcontact.fmu.online import PACKAGE

MONTH = 30 * 24 * 3600.0  # [s]
MAKERS = {"python": lambda folder, **chosen: [build_fmu(folder, **chosen)], "native": build_native_fmus}


def cache_folder(run):
    """The folder that is kept; inside the folder ``run`` of this test run if nothing is to be."""
    wanted = os.environ.get("WRCONTACT_TEST_CACHE")
    usual = Path(os.environ.get("XDG_CACHE_HOME") or "~/.cache", "wrcontact", "tests")
    folder = run / "kept" if wanted == "off" else Path(wanted or usual)
    with contextlib.suppress(OSError, RuntimeError):  # read-only, or there is no home
        folder = folder.expanduser()
        folder.mkdir(parents=True, exist_ok=True)
        if os.access(folder, os.W_OK):
            return folder
    return run / "kept"


def kept_fmus(folder, output, maker, **chosen):
    """The FMUs of a maker, "python" or "native", with ``chosen`` profiles and settings, as copies in the
    folder ``output``; they are built where ``folder`` has none of these sources."""
    place = folder / "fmus" / digest(maker, chosen)
    with locked(place):
        if not place.exists():
            made = tempfile.mkdtemp(dir=place.parent)
            MAKERS[maker](made, **chosen)
            os.replace(made, place)
            remove_unused(folder)
        os.utime(place)
        return [Path(shutil.copy(file, output)) for file in sorted(place.iterdir())]


def digest(maker, chosen):
    """A hash of the package, of its libraries, of the profiles, and of the versions of what packs them."""
    chosen = dict(chosen)
    found = hashlib.sha256(repr((maker, package(), sorted(chosen))).encode())
    found.update(repr((chosen.pop("settings", None), chosen.pop("side", None))).encode())
    for _, file in sorted(chosen.items()):
        found.update(f"{Path(file).name}\0".encode() + Path(file).read_bytes())
    return found.hexdigest()


@cache
def package():
    """A hash of everything that an FMU is made of, but the profiles."""
    found = hashlib.sha256(f"{sys.executable} {sys.version}".encode())
    for name in ("wrcontact", "pythonfmu", "fmpy", "numpy", "ziglang"):
        with contextlib.suppress(PackageNotFoundError):
            found.update(f"{name} {version(name)} ".encode())
    for top in (PACKAGE, SOURCES):
        for file in sorted(path for path in top.rglob("*") if path.is_file() and path.suffix != ".pyc"):
            found.update(f"{file.relative_to(top)}\0{file.stat().st_size}\0".encode() + file.read_bytes())
    return found.hexdigest()


@contextlib.contextmanager
def locked(place):
    """Nobody else makes ``place`` meanwhile; where the system has no such locks, others may make it too."""
    place.parent.mkdir(parents=True, exist_ok=True)
    with open(place.with_suffix(".lock"), "w") as file:
        with contextlib.suppress(ImportError):
            import fcntl

            fcntl.flock(file, fcntl.LOCK_EX)
        yield


def remove_unused(folder):
    """Remove what has not been used for a month."""
    for path in (*folder.glob("fmus/*"), *folder.glob("compiled/*")):
        with contextlib.suppress(OSError):
            if time.time() - path.stat().st_mtime > MONTH:
                shutil.rmtree(path) if path.is_dir() else path.unlink()
