"""The Python FMU's archive: what is in it, and that equal sources give equal bytes."""

import ast
import os
import subprocess
import sys
import zipfile
from pathlib import Path

from fmpy import read_model_description

from tests.helpers.cases import profile_file
from tests.helpers.fmus import needs_compiler
from tests.helpers.paths import ROOT
from wrcontact.fmu import native
from wrcontact.kernel.binding import compiler
from wrcontact.kernel.binding.files import PLATFORMS, host_platform


def test_archive_holds_what_is_needed_and_nothing_else(entries):
    assert {"modelDescription.xml", "documentation/index.html", "resources/slavemodule.txt"} <= set(entries)
    assert b"MIT" in entries["documentation/licenses/pythonfmu.txt"]
    packed = [name.split("/", 2)[2] for name in entries if name.startswith("resources/wrcontact_")]
    offline = ("cli", "plots", "study", "fmu", "kernel/native", "kernel/generated")
    assert not [name for name in packed if name.startswith(offline)]
    assert {"simulation/session.py", "system.py", "status.py", "kernel/binding/library.py"} <= set(packed)


def test_packed_code_loads_with_numpy_only(entries):
    resources = {name.split("/")[1] for name in entries if name.startswith("resources/")}
    for name, content in entries.items():
        if name.endswith(".py") and "/pythonfmu/" not in name:
            assert imported(content) <= {"numpy", *sys.stdlib_module_names, *resources}, name


def imported(source):
    """First names of the modules that a source needs when it is loaded; relative imports do not count."""
    nodes = ast.parse(source).body
    names = {alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names}
    names |= {node.module for node in nodes if isinstance(node, ast.ImportFrom) and not node.level}
    return {name.split(".")[0] for name in names}


def test_command_line_prints_the_path_of_an_archive_with_the_same_bytes(fmu, tmp_path):
    """Built by another process, in another folder, with other hashes of texts."""
    command = [sys.executable, str(ROOT / "build_fmu.py"), "--output", str(tmp_path / "out")]
    done = subprocess.run(
        command, capture_output=True, text=True, cwd=tmp_path, env={**os.environ, "PYTHONHASHSEED": "7"}
    )
    assert done.returncode == 0, done.stderr
    assert Path(done.stdout.strip()) == tmp_path / "out" / fmu.name
    assert os.listdir(tmp_path / "out") == ["WheelsetContact.fmu"]
    assert (tmp_path / "out" / fmu.name).read_bytes() == fmu.read_bytes()


@needs_compiler
def test_equal_sources_are_compiled_to_equal_bytes(tmp_path):
    """A part of the native FMUs, in two folders and not kept; test_wheels.py has the whole."""
    command = [*compiler.compiler_for(PLATFORMS[host_platform()]), *compiler.FLAGS]
    sources = native.sources(2, "{token}", *native.packed_profiles())
    made = []
    for name in ("one", "an other"):
        native.write_sources(sources, tmp_path / name)
        compiler.checked([*command, "-c", "wheelset.c", "-o", "part.o"], tmp_path / name)
        made.append((tmp_path / name / "part.o").read_bytes())
    assert made[0] == made[1]


def test_other_contents_give_another_name_and_guid(description, fmu, kept, tmp_path):
    (other,) = kept("python", wheel=profile_file(tmp_path, "wheel"))
    assert read_model_description(str(other)).guid != description.guid
    assert unique_names(other).isdisjoint(unique_names(fmu))


def unique_names(fmu):
    """Names in the resources that hold the hash of the contents."""
    with zipfile.ZipFile(fmu) as archive:
        names = {name.split("/")[1] for name in archive.namelist() if name.startswith("resources/")}
    return {name for name in names if name.startswith(("wrcontact_", "wheelset_contact_"))}
