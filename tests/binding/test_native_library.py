"""The compiled kernel beside its Python source: a library that does not fit is not used, and arrays keep
their bounds."""

import gc
import shutil
import sys
import weakref
from pathlib import Path

import numpy as np
import pytest

import wrcontact
from tests.helpers import kernel_runs
from tests.helpers.kernel_runs import FORMS, KERNEL, PACKAGE, bits, needs_library, poses, run_steps
from wrcontact.kernel.binding import library
from wrcontact.kernel.binding.compiler import STEP_UNITS, CompilerProblem, compile_library, find_compiler
from wrcontact.kernel.binding.files import LIBRARY_NAME
from wrcontact.kernel.binding.library import fingerprint
from wrcontact.kernel.layout import (
    INPUT_COUNT,
    OUTPUT_COUNT,
    SETTING_COUNT,
    STATE_SIZE,
    UNLOADED,
    WORK_SIZE,
)

needs_compiler = pytest.mark.skipif(find_compiler() is None, reason="no C compiler here")


def copy_package(folder, name, *, with_library):
    """A copy of the package under another name, as inside an FMU."""
    ignored = ["__pycache__"] + ([] if with_library else [LIBRARY_NAME])
    return Path(shutil.copytree(PACKAGE, folder / name, ignore=shutil.ignore_patterns(*ignored)))


@pytest.fixture(scope="module")
def checked_package(tmp_path_factory):
    """A copy of the package whose library ends the process at the first index outside its array."""
    package = copy_package(tmp_path_factory.mktemp("checked"), "checked_wheelset", with_library=False)
    flags = ["-DWRCONTACT_CHECK_BOUNDS", "-O1"]
    compile_library(package / "kernel", extra_flags=flags, units=STEP_UNITS)
    return package


STRIPS_OF_PAIRS = [
    {"normal_model": "analyn_strip", "strips": strips, **pair}
    for strips in (6, 16)
    for pair in ({}, {"rail": "54E1", "rail_inclination": 0.05}, {"rail": "60E1", "gauge": 1.425})
]


@needs_library
@needs_compiler
@pytest.mark.full
@pytest.mark.parametrize(
    "parameters",
    [
        {},
        {"nodes": 4},
        {"nodes": 38},
        {"normal_model": "analyn_strip", "nodes": 4, "strips": 6, "sweeps": 1},
        {"normal_model": "analyn_strip"},
        {"normal_model": "analyn_strip", "nodes": 38, "strips": 16, "sweeps": 20},
        {"separation": "vertical", "lateral_curvature": "smooth", "nodes": 38},
        {"separation": "equidistant", "lateral_curvature": "rough", "normal_model": "analyn_strip"},
        {"separation": "equidistant_chord", "nodes": 4},
        *FORMS,
        *STRIPS_OF_PAIRS,
        {"contact_mode": "elastic", "nodes": 38, "normal_model": "analyn_strip", "strips": 16, "sweeps": 20},
        {"contact_mode": "compliant", "nodes": 4, "separation": "vertical", "lateral_curvature": "rough"},
    ],
    ids=kernel_runs.id_of,
)
@pytest.mark.turns(3)
def test_no_index_leaves_its_array(tmp_path, checked_package, parameters):
    """The library with checked indices takes the same steps: 1200 over tread and flange, 6000 of strips in
    three pairs of profiles, from 1 mN to 1 MN."""
    rows = poses(6000 if parameters in STRIPS_OF_PAIRS else 1200, seed=21)
    rows[::3, 3] = 10 ** np.random.default_rng(22).uniform(-3, 6, len(rows[::3]))
    checked = run_steps(rows, tmp_path, choice="compiled", package=checked_package, **parameters)
    usual = run_steps(rows, tmp_path, choice="compiled", **parameters)
    np.testing.assert_array_equal(checked[:, 0], usual[:, 0])


@pytest.mark.parametrize("mode", ["rigid", "elastic", "compliant"])
def test_many_steps_are_single_steps(mode):
    system = wrcontact.ContactSystem(contact_mode=mode)
    one, many, rows = system.stepper(), system.stepper(), poses(24)
    outputs, statuses = np.zeros((len(rows), OUTPUT_COUNT)), np.zeros(len(rows))
    many.step_many(rows, outputs, statuses)
    for row, block, status in zip(rows, outputs, statuses):
        one.inputs[:] = row
        assert one.step() == status
        if status <= UNLOADED:
            np.testing.assert_array_equal(bits(one.outputs), bits(block))


def test_generated_c_is_of_this_source():
    assert f"INT64_C(0x{fingerprint():015x})" in (KERNEL / "generated" / "unit.c").read_text(), (
        "run tools/transpile_kernel.py"
    )


def test_missing_library_warns_once(tmp_path):
    package = copy_package(tmp_path, "renamed_wheelset", with_library=False)
    code = (
        "from renamed_wheelset.kernel.binding.library import default_kernel as k; "
        "print(k().compiled, k().compiled)"
    )
    child = kernel_runs.run_python(code, tmp_path, "auto")
    assert child.stdout.split() == ["False", "False"], child.stderr
    assert child.stderr.count("RuntimeWarning: The contact kernel runs uncompiled") == 1
    assert f"there is no {LIBRARY_NAME} in {package / 'kernel'}" in child.stderr


@needs_library
def test_library_of_other_sources_is_refused(tmp_path):
    folder = copy_package(tmp_path, "edited_wheelset", with_library=True) / "kernel"
    assert library.open_library(folder).wrcontact_abi() == fingerprint(folder)
    with open(folder / "layout" / "record.py", "a") as source:
        source.write("# edited\n")
    with pytest.raises(library.LibraryUnusable, match="another version of the kernel"):
        library.open_library(folder)


def test_file_that_is_no_library_is_refused(tmp_path):
    (tmp_path / LIBRARY_NAME).write_bytes(b"half a library")
    with pytest.raises(library.LibraryUnusable, match="cannot be loaded"):
        library.open_library(tmp_path)


def test_unknown_choice_is_refused(monkeypatch):
    monkeypatch.setenv("WRCONTACT_KERNEL", "fortran")
    with pytest.raises(ValueError, match="'fortran'; it may be auto, compiled, python"):
        library.default_kernel.__wrapped__()


def test_failing_compiler_leaves_no_library(tmp_path):
    with pytest.raises(CompilerProblem, match="SystemExit.* failed:"):
        compile_library(tmp_path, compiler=[sys.executable, "-c", "raise SystemExit(1)"])
    assert not list(tmp_path.iterdir())


def arrays(**changed):
    """Arrays that can be bound."""
    return {
        "tables": np.zeros(SETTING_COUNT),
        "state": np.zeros(STATE_SIZE),
        "workspace": np.zeros(WORK_SIZE),
        "inputs": np.zeros(INPUT_COUNT),
        "outputs": np.zeros(OUTPUT_COUNT),
        **changed,
    }


def read_only(size):
    array = np.zeros(size)
    array.flags.writeable = False
    return array


@pytest.mark.parametrize(
    "changed, sentence",
    [
        ({"tables": [0.0]}, "tables must be a numpy array of float64, not list"),
        ({"state": np.zeros(STATE_SIZE, np.float32)}, "state must be a numpy array of float64, not float32"),
        ({"workspace": np.zeros(2 * WORK_SIZE)[::2]}, "workspace must be C-contiguous"),
        (
            {"inputs": np.zeros(INPUT_COUNT - 1)},
            f"inputs has {INPUT_COUNT - 1} values and needs {INPUT_COUNT}",
        ),
        (
            {"workspace": np.zeros(WORK_SIZE - 1)},
            f"workspace has {WORK_SIZE - 1} values and needs {WORK_SIZE}",
        ),
        ({"outputs": read_only(OUTPUT_COUNT)}, "outputs is read-only"),
    ],
)
def test_unusable_arrays_are_refused(changed, sentence):
    with pytest.raises((TypeError, ValueError), match=sentence):
        library.Kernel().bind(**arrays(**changed))


def test_read_only_tables_are_welcome():
    library.Kernel().bind(**arrays(tables=read_only(SETTING_COUNT)))


@pytest.mark.parametrize("make", [library.Kernel, library.default_kernel])
def test_bound_arrays_stay_alive(make):
    kernel, given = make(), arrays()
    alive = {name: weakref.ref(array) for name, array in given.items()}
    bound = kernel.bind(**given)
    del given
    gc.collect()
    assert all(reference() is not None for reference in alive.values())
    del bound
    gc.collect()
    assert not any(reference() is not None for reference in alive.values())


def test_a_bare_step_keeps_its_arrays():
    """``step`` may outlive its stepper; its arrays then stay."""
    stepper = wrcontact.ContactSystem().stepper()
    stepper.inputs[:5] = 1e-3, 0.0, 0.0, 78.5e3, 0.0
    kept, step = weakref.ref(stepper.outputs), stepper.step
    del stepper
    gc.collect()
    assert step() == 0 and kept() is not None
