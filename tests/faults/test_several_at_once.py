"""Several builds at once, and several FMUs in one process."""

import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.helpers.cases import OUTPUT_NAMES, poses
from tests.helpers.faults import building, needs_linux, parts_in
from tests.helpers.fmus import needs_compiler, run_scenario
from tests.helpers.paths import ROOT
from wrcontact.fmu import build_fmu, native
from wrcontact.kernel.binding.compiler import CompilerProblem, compile_library
from wrcontact.kernel.binding.library import LIBRARY_NAME, LibraryUnusable, open_library
from wrcontact.storage import atomic

pytestmark = needs_linux


@pytest.mark.full
@needs_compiler
@pytest.mark.parametrize(
    "cold", [False, pytest.param(True, marks=pytest.mark.complete)], ids=["warm", "cold"]
)
def test_builds_at_once(tmp_path, fmus, compiled, cold):
    """Of the same FMUs into one folder, with one cache of compiled sources; empty and full."""
    programs = [building(tmp_path / "out", tmp_path / "cache" if cold else compiled) for _ in range(3)]
    answers = [program.communicate(timeout=600) for program in programs]
    assert [program.returncode for program in programs] == [0] * 3, answers
    assert [file.read_bytes() for file in sorted((tmp_path / "out").iterdir())] == [
        file.read_bytes() for file in fmus.values()
    ]
    assert not cold or not parts_in(tmp_path / "cache")


@pytest.mark.complete
def test_kernels_compiled_at_once_while_others_load_them(tmp_path):
    """Into one folder: there is a whole library at any time."""
    folder = tmp_path / "kernel"
    shutil.copytree(Path(atomic.__file__).parents[1] / "kernel", folder)
    command = [sys.executable, str(ROOT / "tools" / "compile_kernel.py"), "--folder", str(folder)]
    environment = {**os.environ, "WRCONTACT_COMPILED": ""}
    programs = [
        subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment) for _ in range(3)
    ]
    loads = 0
    while any(program.poll() is None for program in programs):
        try:
            open_library(folder)
        except LibraryUnusable as reason:
            assert "there is no" in str(reason)
        loads += 1
        time.sleep(0.05)
    assert [program.communicate()[0].strip() for program in programs] == [str(folder / LIBRARY_NAME)] * 3
    assert loads > 5 and open_library(folder) and parts_in(folder) == []


def test_a_compiler_that_fails_leaves_the_kernel_as_it_was(tmp_path):
    (tmp_path / LIBRARY_NAME).write_bytes(b"before")
    with pytest.raises(CompilerProblem):
        compile_library(tmp_path, compiler=["false"])
    assert [file.name for file in tmp_path.iterdir()] == [LIBRARY_NAME]
    assert (tmp_path / LIBRARY_NAME).read_bytes() == b"before"


VARIANTS = {"one": ("0.1.0", None), "two": ("0.2.0", "54E1")}  #: version and rail


@pytest.mark.full
@needs_compiler
@pytest.mark.parametrize(
    "shared",
    [pytest.param(False, marks=pytest.mark.complete), True],
    ids=["names of their own", "names shared"],
)
def test_two_versions_of_all_fmus_in_one_process(tmp_path, compiled, monkeypatch, shared):
    """Native ones and Python ones, of other version numbers and start values; the values of each are those
    that it has alone, also where the host shares the names of all libraries that it loads (RTLD_GLOBAL)."""
    built = {}
    for name, (version, rail) in VARIANTS.items():
        monkeypatch.setattr("wrcontact.fmu.build.__version__", version)
        monkeypatch.setattr("wrcontact.fmu.native.__version__", version)
        built[f"python {name}"] = build_fmu(tmp_path / name, rail=rail)
        built[f"native {name}"] = native.build_native_fmus(tmp_path / name, rail=rail, cache=compiled)[0]
    rows = poses(6)
    names = list(built)
    given = {
        "others": {name: [str(built[name]), str(tmp_path / f"beside {name}")] for name in names[1:]},
        "rows": rows,
        "shared": shared,
    }
    seen = run_scenario("several", built[names[0]], tmp_path / "unpacked", given)
    alone = {
        name: run_scenario(
            "trajectory", built[name], tmp_path / f"alone {name}", {"rows": rows, "names": OUTPUT_NAMES}
        )
        for name in names
    }
    for name, answer in seen.items():
        assert answer["seen"] == alone[name if name in alone else names[0]]["seen"], name
        assert answer["rail"] == ("54E1" if name.endswith("two") else "UIC60")
    assert alone["native one"]["seen"] == alone["python one"]["seen"] != alone["python two"]["seen"]
