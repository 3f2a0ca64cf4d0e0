"""Wheels of the package for several platforms, and that equal sources give equal bytes."""

import importlib.util
import os
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import zipfile
from pathlib import Path

import pytest

import wrcontact
from tests.helpers.paths import ROOT
from tests.helpers.platforms import KERNEL_EXPORTS, check_library, needs, needs_build, needs_zig
from tools.releasing import bill
from wrcontact import ContactSystem
from wrcontact.kernel.binding.compiler import KEPT, LOADER_NAME, LOADER_PLATFORM, find_compiler
from wrcontact.kernel.binding.files import LIBRARY_NAME, PLATFORMS, host_platform, library_name

# --- the same bytes again -------------------------------------------------------------------------


BUILD = """
import sys
from wrcontact.fmu import build_fmu
from wrcontact.fmu.native import build_native_fmus
build_native_fmus(sys.argv[1], platforms=sys.argv[2:])
build_fmu(sys.argv[1])
"""


@pytest.mark.complete
@needs_zig
def test_equal_archives_from_other_folders_and_an_empty_cache(tmp_path):
    """Native FMUs for every platform and the Python FMU, by two processes in folders of their own,
    with the products of matrices of two processors; the compiler's cache is that of this user for the
    one and empty for the other, and neither keeps compiled sources."""
    made = []
    clean = {key: value for key, value in os.environ.items() if key != KEPT}
    cache = {f"ZIG_{kind}_CACHE_DIR": str(tmp_path / "cache") for kind in ("LOCAL", "GLOBAL")}
    for folder, processor, caches in (("one", "Haswell", {}), ("an other", "Prescott", cache)):
        place = tmp_path / folder
        (place / "scratch").mkdir(parents=True)
        subprocess.run(
            [sys.executable, "-c", BUILD, "out", *PLATFORMS],
            cwd=place,
            check=True,
            stderr=subprocess.DEVNULL,
            env={
                **clean,
                **caches,
                "PYTHONPATH": os.pathsep.join(map(os.path.abspath, sys.path)),
                "TMPDIR": str(place / "scratch"),
                "OPENBLAS_CORETYPE": processor,
            },
        )
        made.append({file.name: file.read_bytes() for file in sorted((place / "out").iterdir())})
    assert len(made[0]) == 3
    assert made[0].keys() == made[1].keys()
    assert [name for name, content in made[0].items() if content != made[1][name]] == []


# --- wheels ---------------------------------------------------------------------------------------


@pytest.fixture(scope="session")
def sources(tmp_path_factory):
    """A copy of the checkout, with a library in it that belongs to no wheel."""
    copy = tmp_path_factory.mktemp("sources") / "wrcontact"
    ignored = (
        ".git",
        ".venv",
        "build",
        "dist",
        "out",
        "*.egg-info",
        "__pycache__",
        "*.so",
        "*.dll",
        "*.dylib",
    )
    shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(*ignored))
    (copy / "wrcontact" / "kernel" / "_wrcontact_kernel-amiga.so").write_bytes(b"a stray one")
    return copy


PACK = [sys.executable, "-m", "build", "--no-isolation"]


def built_wheel(sources, folder, **settings):
    """``python -m build --wheel`` with these settings; the wheel."""
    clean = {
        key: value
        for key, value in os.environ.items()
        if key not in ("WRCONTACT_PLATFORM", "WRCONTACT_KERNEL")
    }
    done = subprocess.run(
        [*PACK, "--wheel", "--outdir", str(folder), str(sources)],
        text=True,
        capture_output=True,
        env={**clean, **settings},
    )
    assert done.returncode == 0, done.stdout + done.stderr
    (wheel,) = folder.iterdir()
    return wheel


def libraries_in(wheel):
    with zipfile.ZipFile(wheel) as archive:
        return {
            name: archive.read(name)
            for name in archive.namelist()
            if name.endswith((".so", ".dll", ".dylib"))
        }


def expected_libraries(platform, kernel):
    """The kernel, and where PythonFMU has a library for Linux the loader of Python FMUs."""
    loader = [f"wrcontact/fmu/{LOADER_NAME}"] if platform == LOADER_PLATFORM else []
    return [*loader, f"wrcontact/kernel/{kernel}"]


def install(wheel, folder):
    """An environment of its own with the wheel and the libraries that Python has here; its interpreter."""
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", str(folder)], check=True)
    python = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    pip = [sys.executable, "-m", "pip", "--python", str(python)]
    subprocess.run(
        [*pip, "install", "-q", "--no-deps", "--no-index", str(wheel)],
        check=True,
        env={**os.environ, "PATH": ""},
    )
    where = "import sysconfig; print(sysconfig.get_path('purelib'))"
    site = Path(
        subprocess.run([str(python), "-c", where], text=True, capture_output=True, check=True).stdout.strip()
    )
    theirs = [sysconfig.get_path(name) for name in ("purelib", "platlib")]
    site.joinpath("theirs.pth").write_text("".join(f"{path}\n" for path in theirs))
    return python


EVALUATE = """
import wrcontact
from wrcontact.kernel.binding import library
kernel = library.default_kernel()
state = wrcontact.ContactSystem().evaluate(lateral_shift=5e-3, yaw=1e-3)
print(library.__file__, kernel.compiled, state.right.penetration.hex())
"""


@pytest.mark.full
@needs_zig
@needs_build
@pytest.mark.parametrize(
    "name",
    (
        "x86_64-linux",
        *(pytest.param(name, marks=pytest.mark.complete) for name in PLATFORMS if name != "x86_64-linux"),
    ),
)
def test_wheel_for_a_platform(sources, tmp_path, name):
    """Its tag and its library, the right one alone, its version, and nothing of others that the list of
    licences does not name; this machine's is installed without a compiler and runs compiled."""
    wheel = built_wheel(sources, tmp_path / "wheels", WRCONTACT_PLATFORM=name)
    place = PLATFORMS[name]
    assert wheel.name.endswith(f"-py3-none-{place.wheel}.whl")
    with zipfile.ZipFile(wheel) as archive:
        metadata = archive.read(
            next(entry for entry in archive.namelist() if entry.endswith(".dist-info/WHEEL"))
        ).decode()
    assert f"-{wrcontact.__version__}-py3-" in wheel.name
    theirs = {"compiler-rt", "mingw-w64"} if name == "x86_64-windows" else {"compiler-rt"}
    assert {part.name for part in bill.parts_in(wheel)} == theirs
    tags = [line for line in metadata.splitlines() if line.startswith("Tag: ")]
    assert tags == [f"Tag: py3-none-{tag}" for tag in place.wheel.split(".")]
    found = libraries_in(wheel)
    assert sorted(found) == expected_libraries(name, library_name(name))
    if importlib.util.find_spec("lief"):
        check_library(
            found[f"wrcontact/kernel/{library_name(name)}"], name, f"_wrcontact_kernel-{name}", KERNEL_EXPORTS
        )
    if name == host_platform():
        python = install(wheel, tmp_path / "environment")
        done = subprocess.run(
            [str(python), "-I", "-W", "error", "-c", EVALUATE],
            cwd=tmp_path,
            text=True,
            capture_output=True,
            env={"PATH": "", "WRCONTACT_KERNEL": "auto"},
        )
        assert done.returncode == 0, done.stderr
        file, compiled, penetration = done.stdout.split()
        assert Path(file).is_relative_to(tmp_path / "environment") and compiled == "True"
        assert (
            float.fromhex(penetration)
            == ContactSystem().evaluate(lateral_shift=5e-3, yaw=1e-3).right.penetration
        )


@pytest.mark.full
@needs_build
@needs(find_compiler(), "no C compiler here")
def test_wheel_of_this_machine(sources, tmp_path):
    wheel = built_wheel(sources, tmp_path / "wheels")
    tag = wheel.stem.split("-")[2:]
    assert tag[:2] == ["py3", "none"]
    assert tag[2] == sysconfig.get_platform().replace("-", "_").replace(".", "_")
    assert sorted(libraries_in(wheel)) == expected_libraries(host_platform(), LIBRARY_NAME)


@pytest.mark.full
@needs_build
def test_source_archive_has_no_library(sources, tmp_path):
    subprocess.run(
        [*PACK, "--sdist", "--outdir", str(tmp_path), str(sources)], check=True, capture_output=True
    )
    (made,) = tmp_path.iterdir()
    theirs = {part.name: entries for part, entries in bill.parts_in(made).items()}
    assert set(theirs) == {"benchmark of EN 15302", "reference output of CONTACT"}
    with tarfile.open(made) as archive:
        names = archive.getnames()
    assert [name for name in names if name.endswith((".so", ".dll", ".dylib"))] == []
    assert [name for name in names if name.endswith("wrcontact/kernel/binding/files.py")]
