"""Libraries and wheels for other machines: what they need and export; those of Windows and
aarch64 run under emulators."""

import os
import platform
import shutil
import struct
import subprocess
import sys
import sysconfig
from contextlib import contextmanager
from functools import cache
from pathlib import Path

import fmpy
import numpy as np
import pytest
from fmpy import read_model_description
from fmpy.validation import validate_fmu

from tests.helpers.cases import INPUT_NAMES, REAL_INPUT_NAMES, RUNS, stored
from tests.helpers.fmus import header_functions
from tests.helpers.paths import HELPERS
from tests.helpers.platforms import (
    FMU_KERNEL_EXPORTS,
    REFERENCE,
    check_library,
    needs,
    needs_lief,
    needs_reference,
    needs_zig,
)
from wrcontact import ContactSystem
from wrcontact.fmu import build_fmu, native, online
from wrcontact.fmu.online import compile_kernel
from wrcontact.interface.variables import OUTPUT, REAL, VARIABLES
from wrcontact.kernel import layout
from wrcontact.kernel.binding import compiler
from wrcontact.kernel.binding.compiler import CompilerProblem, chosen_platform, compiler_for, requirements
from wrcontact.kernel.binding.files import HERE as KERNEL
from wrcontact.kernel.binding.files import LIBRARY_NAME, PLATFORMS, host_platform, library_name
from wrcontact.kernel.binding.library import fingerprint

ARM_ROOT = Path("/usr/aarch64-linux-gnu")
WINE = shutil.which("wine") or shutil.which("wine64")


# --- names ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "system, machine, python, name, library",
    [
        ("linux", "x86_64", "linux-x86_64", "x86_64-linux", "_wrcontact_kernel-x86_64-linux.so"),
        ("linux", "aarch64", "linux-aarch64", "aarch64-linux", "_wrcontact_kernel-aarch64-linux.so"),
        ("linux", "riscv64", "linux-riscv64", "riscv64-linux", "_wrcontact_kernel-riscv64-linux.so"),
        ("win32", "AMD64", "win-amd64", "x86_64-windows", "_wrcontact_kernel-x86_64-windows.dll"),
        # emulated there
        ("win32", "ARM64", "win-amd64", "x86_64-windows", "_wrcontact_kernel-x86_64-windows.dll"),
        ("win32", "AMD64", "win32", "x86-windows", "_wrcontact_kernel-x86-windows.dll"),
        (
            "darwin",
            "arm64",
            "macosx-11.0-universal2",
            "aarch64-darwin",
            "_wrcontact_kernel-aarch64-darwin.dylib",
        ),
        (
            "darwin",
            "x86_64",
            "macosx-11.0-universal2",
            "x86_64-darwin",
            "_wrcontact_kernel-x86_64-darwin.dylib",
        ),
    ],
)
def test_names_of_platforms(monkeypatch, system, machine, python, name, library):
    monkeypatch.setattr(sys, "platform", system)
    monkeypatch.setattr(platform, "machine", lambda: machine)
    monkeypatch.setattr(sysconfig, "get_platform", lambda: python)
    assert host_platform() == name and library_name(name) == library


def test_a_platform_for_a_wheel_is_known_or_refused(monkeypatch):
    monkeypatch.delenv("WRCONTACT_PLATFORM", raising=False)
    assert chosen_platform() is None
    monkeypatch.setenv("WRCONTACT_PLATFORM", "x86_64-windows")
    assert chosen_platform() == "x86_64-windows" and requirements() == ["ziglang"]
    monkeypatch.setenv("WRCONTACT_PLATFORM", "amiga")
    with pytest.raises(CompilerProblem, match="WRCONTACT_PLATFORM is 'amiga'; permitted are x86_64-linux, "):
        requirements()


def test_generated_c_of_another_version_is_not_compiled(monkeypatch):
    monkeypatch.setattr("wrcontact.fmu.online.fingerprint", lambda: 5)
    with pytest.raises(CompilerProblem, match="does not belong to this version of its source"):
        compile_kernel(host_platform())


def test_a_failing_compiler_leaves_this_machines_kernel(monkeypatch, capsys):
    def fail(name):
        raise CompilerProblem("zig is broken")

    monkeypatch.setattr(online, "has_zig", lambda: True)
    monkeypatch.setattr(online, "compile_kernel", fail)
    made = online.kernel_libraries(["x86_64-windows"])
    told = capsys.readouterr().err
    assert "WARNING: the FMU gets no compiled kernel for other machines: zig is broken" in told
    if KERNEL.joinpath(LIBRARY_NAME).exists():
        assert made == {f"kernel/{LIBRARY_NAME}": KERNEL.joinpath(LIBRARY_NAME).read_bytes()}
    else:
        assert made == {} and "runs the slow Python source" in told


# --- what libraries need and export ---------------------------------------------------------------


@contextmanager
def less_optimised():
    """Within this a compiler takes a third of the time, and a sixth for macOS, where no root is a call even so;
    wheels and digests are of libraries as they are given away."""

    def leveled(place):
        return [*compiler_for(place), "-O0" if place.name.endswith("darwin") else "-O1"]

    with pytest.MonkeyPatch.context() as changed:
        changed.setattr(compiler, "FLAGS", tuple(flag for flag in compiler.FLAGS if flag != "-O3"))
        changed.setattr(compiler, "compiler_for", leveled)
        yield


@pytest.fixture(scope="session")
def fmus(tmp_path_factory):
    """The native FMUs for every platform, unpacked, by version of FMI."""
    folders = {}
    with less_optimised():
        made = native.build_native_fmus(tmp_path_factory.mktemp("native"), platforms=list(PLATFORMS))
    for version, fmu in zip((2, 3), made):
        assert validate_fmu(str(fmu)) == []
        folders[version] = Path(fmpy.extract(str(fmu), tmp_path_factory.mktemp(f"fmi{version}")))
    return folders


@pytest.fixture(scope="session")
def kernels():
    """The kernel's library of a platform by its name, compiled once; or that in the folder
    WRCONTACT_TEST_KERNELS, for the wheels of a release."""
    given = os.environ.get("WRCONTACT_TEST_KERNELS")
    if given:
        return lambda name: Path(given, library_name(name)).read_bytes()

    def compiled(name):
        with less_optimised():
            return compile_kernel(name)

    return cache(compiled)


def share(names, chosen):
    """What is tried before every merge; the others at night."""
    return [name if name in chosen else pytest.param(name, marks=pytest.mark.complete) for name in names]


def library_of(folder, version, name):
    place = PLATFORMS[name]
    return (
        folder / "binaries" / (place.fmi2 if version == 2 else place.name) / f"WheelsetContact{place.suffix}"
    )


@pytest.mark.full
@needs_zig
@needs_lief
@pytest.mark.parametrize("name", PLATFORMS)
@pytest.mark.parametrize("version", (2, 3))
def test_libraries_need_the_c_library_alone_and_export_the_standard(fmus, version, name):
    content = library_of(fmus[version], version, name).read_bytes()
    check_library(content, name, "WheelsetContact", set(header_functions(version)))


@pytest.mark.full
@needs_zig
@needs_lief
@pytest.mark.parametrize("name", share(PLATFORMS, ("x86_64-linux", "x86_64-windows")))
def test_kernels_need_the_c_library_alone(kernels, name):
    check_library(kernels(name), name, f"_wrcontact_kernel-{name}", FMU_KERNEL_EXPORTS)


# --- values on other machines ---------------------------------------------------------------------


@pytest.fixture(scope="session")
def run_on(tmp_path_factory):
    """Run library_host.c on a platform, under an emulator if need be; its lines."""
    folder, made = tmp_path_factory.mktemp("hosts"), {}

    def run_on(name, *arguments):
        emulator = emulator_of(name, folder)
        if name not in made:
            made[name] = folder / f"{name} host.exe"
            headers = ["-I", str(Path(fmpy.__file__).parent / "c-code"), "-I", str(KERNEL / "native")]
            subprocess.run(
                [
                    *compiler_for(PLATFORMS[name]),
                    *headers,
                    str(HELPERS / "library_host.c"),
                    "-o",
                    str(made[name]),
                    *([] if name.endswith("windows") else ["-ldl"]),
                ],
                check=True,
            )
        quiet = {
            "WINEDEBUG": "-all",
            "WINEDLLOVERRIDES": "mscoree,mshtml=",
            "DISPLAY": "",
            "WINEPREFIX": str(folder / "wine"),
        }
        done = subprocess.run(
            [*emulator, str(made[name]), *map(str, arguments)],
            text=True,
            capture_output=True,
            timeout=600,
            env={**os.environ, **quiet},
        )
        assert done.returncode == 0, done.stderr
        return done.stdout.splitlines()

    return run_on


def emulator_of(name, folder):
    """The command that runs programs of a platform here; skips the test where there is none."""
    if name == host_platform():
        return []
    if name == "x86_64-windows":
        return [WINE] if WINE else pytest.skip("wine is not installed")
    if name == "aarch64-linux" and shutil.which("qemu-aarch64") and (ARM_ROOT / "lib").is_dir():
        return ["qemu-aarch64", "-L", str(ARM_ROOT)]
    return pytest.skip("qemu-user or libc6-arm64-cross is not installed")


def bits(numbers):
    return [struct.pack(">d", number).hex() for number in numbers]


def listed(references):
    return [f"{number:x}" for number in (len(references), *references)]


def answers(lines):
    """Outputs (n, m) and status (n,) of the host's lines."""
    rows = [line.split() for line in lines]
    outputs = np.array([[int(word, 16) for word in row[:-1]] for row in rows], np.uint64)
    return outputs.view(float), [int(row[-1], 16) for row in rows]


def rows_of(run, names=INPUT_NAMES):
    """These inputs of a stored run; the kernel has switches among them, the FMU's real inputs have none."""
    starts = {v.name: v.start for v in VARIABLES}
    return [[row.get(name, starts[name]) for name in names] for row in stored(run)[1]]


def plan_of(description, rows):
    """What the host reads: the references of an FMU's inputs and outputs, and rows of inputs."""
    variables = {v.name: v for v in description.modelVariables}
    outputs = [v for v in variables.values() if v.causality == "output" and v.type in ("Real", "Float64")]
    words = listed([variables[name].valueReference for name in REAL_INPUT_NAMES]) + listed(
        [v.valueReference for v in outputs]
    )
    count = len([v for v in VARIABLES if v.causality == OUTPUT and v.type == REAL])
    return " ".join(
        [
            *words,
            f"{count:x}",
            f"{variables['status'].valueReference:x}",
            f"{len(rows):x}",
            *bits(sum(rows, [])),
        ]
    )


SETTINGS = [
    {},
    {"contact_mode": "elastic", "load": "vertical"},
    {"normal_model": "analyn_strip"},
    {"normal_model": "hertz"},
    {"lateral_curvature": "smooth", "separation": "equidistant", "rail_profile": "54E1"},
]


@pytest.mark.full
@needs_zig
@needs_reference
@pytest.mark.parametrize("settings", SETTINGS, ids=lambda settings: "-".join(settings.values()) or "default")
@pytest.mark.parametrize("version", share((2, 3), (2,)))
@pytest.mark.parametrize("name", ("x86_64-windows", "aarch64-linux"))
def test_values_on_other_machines(fmus, run_on, tmp_path, name, version, settings):
    """The library is loaded and stepped through the stored runs, with the same bits."""
    emulator_of(name, tmp_path)
    description, plan = read_model_description(str(fmus[version])), tmp_path / "plan.txt"
    reference = {v.name: v.valueReference for v in description.modelVariables}
    texts = [f"{reference[key]}={text}" for key, text in settings.items()]
    rows = {run: rows_of(run, REAL_INPUT_NAMES) for run in RUNS}
    plan.write_text(plan_of(description, sum(rows.values(), [])))
    (ours, our_status), (theirs, status) = (
        answers(
            run_on(
                place,
                f"fmi{version}",
                library_of(fmus[version], version, place),
                description.guid,
                plan,
                *texts,
            )
        )
        for place in (REFERENCE, name)
    )
    assert len(ours) == sum(map(len, rows.values())) and status == our_status and set(status) <= {0, 1}
    np.testing.assert_array_equal(theirs.view(np.int64), ours.view(np.int64))


# --- the Python FMU -------------------------------------------------------------------------------


@pytest.fixture(scope="session")
def python_fmu(tmp_path_factory):
    """The Python FMU, unpacked."""
    with less_optimised():
        fmu = build_fmu(tmp_path_factory.mktemp("python"))
    return Path(fmpy.extract(str(fmu), tmp_path_factory.mktemp("unpacked")))


def packed_kernel(folder):
    return next(folder.glob("resources/wrcontact_*/kernel"))


@pytest.mark.full
@needs_zig
def test_python_fmu_carries_the_kernel_of_each_platform_that_loads_it(python_fmu, kernels):
    carried = {
        file.name: file.read_bytes()
        for file in packed_kernel(python_fmu).iterdir()
        if file.is_file() and file.suffix != ".py"
    }
    places = {place.fmi2: name for name, place in PLATFORMS.items()}
    names = {places[folder.name] for folder in python_fmu.joinpath("binaries").iterdir()} | {host_platform()}
    assert {"x86_64-linux", "x86_64-windows"} <= names
    assert carried == {library_name(name): kernels(name) for name in names}


LOAD = """
import platform, sys
sys.path.insert(0, sys.argv[1])
if len(sys.argv) > 3:
    platform.machine = lambda: sys.argv[3]
library = __import__(sys.argv[2] + ".kernel.binding.library", fromlist=["library"])
kernel = library.default_kernel()
print(kernel.compiled, kernel.compiled and kernel.library._name)
"""


@pytest.mark.full
@needs_zig
@needs(sys.platform != "win32", "the machine's name has another source there")
def test_python_fmu_loads_the_kernel_of_its_platform(python_fmu):
    kernel = packed_kernel(python_fmu)
    loads = [
        sys.executable,
        "-I",
        "-W",
        "always",
        "-c",
        LOAD,
        str(python_fmu / "resources"),
        kernel.parent.name,
    ]
    here = subprocess.run(loads, text=True, capture_output=True, check=True)
    assert here.stdout.split(maxsplit=1) == ["True", f"{kernel / LIBRARY_NAME}\n"] and not here.stderr
    elsewhere = subprocess.run([*loads, "riscv64"], text=True, capture_output=True, check=True)
    assert elsewhere.stdout.split() == ["False", "False"]
    assert elsewhere.stderr.count("RuntimeWarning: The contact kernel runs uncompiled") == 1
    assert (
        f"there is no {LIBRARY_NAME.replace(platform.machine(), 'riscv64')} in {kernel}" in elsewhere.stderr
    )


@pytest.mark.full
@needs_zig
@needs_reference
@pytest.mark.parametrize("name", share(("x86_64-windows", "aarch64-linux"), ("x86_64-windows",)))
def test_kernel_on_other_machines(kernels, run_on, tmp_path, name):
    """The kernel's library, of this source, steps there as here."""
    emulator_of(name, tmp_path)
    library = tmp_path / library_name(name)
    library.write_bytes(kernels(name))
    stepper, rows = ContactSystem().stepper(), rows_of("hunting")
    sizes = (layout.STATE_SIZE, layout.WORK_SIZE, layout.INPUT_COUNT, layout.OUTPUT_COUNT, len(rows))
    tables = stepper.tables
    plan = [f"{len(tables):x}", *bits(tables), *(f"{size:x}" for size in sizes), *bits(sum(rows, []))]
    (tmp_path / "plan.txt").write_text(" ".join(plan))
    version, *lines = run_on(name, "kernel", library, tmp_path / "plan.txt")
    assert int(version, 16) == fingerprint()
    found, status = answers(lines)
    for row, values, outcome in zip(rows, found, status, strict=True):
        stepper.inputs[:] = row
        assert stepper.step() == outcome
        np.testing.assert_array_equal(values.view(np.int64), stepper.outputs.view(np.int64))
