"""Building native FMUs: the command, the compilers, the sources in the archive."""

import shutil
import subprocess
import sys
import zipfile
from pathlib import Path
from xml.etree import ElementTree

import pytest
from fmpy import read_model_description
from fmpy.build import build_platform_binary

from tests.helpers.cases import OUTPUT_NAMES, poses
from tests.helpers.fmus import assert_same, needs_compiler, needs_glibc, run_scenario
from tests.helpers.paths import ROOT
from tests.helpers.platforms import MATHEMATICS
from wrcontact.fmu import native
from wrcontact.kernel.binding import compiler
from wrcontact.kernel.binding.compiler import CompilerProblem, compiler_for
from wrcontact.kernel.binding.files import PLATFORMS, host_platform

pytestmark = needs_compiler


# --- behaviour ------------------------------------------------------------------------------------


@pytest.mark.full
def test_command_line_prints_the_paths(fmus, tmp_path):
    command = [sys.executable, str(ROOT / "build_fmu.py"), "--native", "--output", str(tmp_path / "out")]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    printed = list(map(Path, done.stdout.split()))
    assert printed == [tmp_path / "out" / f"WheelsetContact_native_fmi{version}.fmu" for version in (2, 3)]
    assert [file.read_bytes() for file in printed] == [file.read_bytes() for file in fmus.values()]


def test_command_line_refuses_in_a_sentence(tmp_path):
    command = [sys.executable, str(ROOT / "build_fmu.py"), "--native", "--output", str(tmp_path / "out")]
    wrong = subprocess.run([*command, "--platforms", "amiga"], capture_output=True, text=True)
    assert wrong.returncode == 2 and "--platforms has 'amiga'; permitted are x86_64-linux" in wrong.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.skipif(not shutil.which("nm"), reason="nm, which lists symbols, is not installed")
@pytest.mark.parametrize("version", (2, 3))
def test_no_mathematical_library_is_needed(fmus, tmp_path, version):
    """Its functions differ from machine to machine in their last bits."""
    place = PLATFORMS[host_platform()]
    entry = f"binaries/{place.fmi2 if version == 2 else place.name}/WheelsetContact{place.suffix}"
    with zipfile.ZipFile(fmus[version]) as archive:
        library = archive.extract(entry, tmp_path)
    listed = subprocess.run(
        ["nm", "-D", "--undefined-only", library], text=True, capture_output=True, check=True
    )
    names = {line.split()[-1].partition("@")[0] for line in listed.stdout.splitlines()}
    assert "memcpy" in names and not names & MATHEMATICS


def test_other_contents_give_another_token(fmus, packed):
    tokens = [read_model_description(str(fmu)).instantiationToken for fmu in (fmus[3], packed[0][3])]
    assert tokens[0] != tokens[1]


#: The language that the build description names; not optimised, which saves most of the time.
SOURCE_BUILD = ["-std=c11", "-shared", "-fPIC", "-O0", "-fno-math-errno"]


@pytest.mark.full
@pytest.mark.skipif(not shutil.which("cc"), reason="the machine has no C compiler of its own")
@pytest.mark.parametrize("version", (2, 3))
@pytest.mark.parametrize("builder", ("system", "fmpy"))
@pytest.mark.turns(4)
def test_sources_in_the_archive_give_the_same_values(fmus, tmp_path, version, builder):
    """Compiled from what the archive itself says: by the system's compiler alone, and
    as fmpy does, by CMake."""
    if builder == "fmpy" and not shutil.which("cmake"):
        pytest.skip("fmpy builds by CMake, which is not installed")
    with zipfile.ZipFile(fmus[version]) as archive:
        archive.extractall(tmp_path / "sources only")
    place, description = PLATFORMS[host_platform()], tmp_path / "sources only" / "modelDescription.xml"
    library = (
        description.parent
        / "binaries"
        / (place.fmi2 if version == 2 else place.name)
        / f"WheelsetContact{place.suffix}"
    )
    library.unlink()
    if builder == "fmpy":
        build_platform_binary(description.parent, configuration="Debug")  # compiled in a third of the time
    else:
        compile_as_described(version, description, library)
    again = tmp_path / "again.fmu"
    with zipfile.ZipFile(again, "w") as archive:
        for file in sorted(description.parent.rglob("*")):
            archive.write(file, file.relative_to(description.parent))
    given = {"rows": poses(20), "names": OUTPUT_NAMES}
    one, other = (
        run_scenario("trajectory", file, tmp_path / f"unpacked {k}", given)["seen"]
        for k, file in enumerate((fmus[version], again))
    )
    for ours, theirs in zip(one, other, strict=True):
        assert_same(theirs, ours)


def compile_as_described(version, description, library):
    """By the system's compiler, the files that the archive lists."""
    sources = description.parent / "sources"
    listed = ElementTree.parse(description if version == 2 else sources / "buildDescription.xml").getroot()
    kinds = [listed.find(kind) for kind in ("ModelExchange", "CoSimulation")] if version == 2 else [listed]
    for kind in kinds:
        units = [node.get("name") for node in kind.iter("File" if version == 2 else "SourceFile")]
        assert units == native.compiled_units(version)
    done = subprocess.run(
        ["cc", *SOURCE_BUILD, *units, "-o", str(library)], cwd=sources, text=True, capture_output=True
    )
    assert done.returncode == 0, done.stderr


# --- from a C host --------------------------------------------------------------------------------


@pytest.mark.full
@needs_glibc
@pytest.mark.parametrize("version", (2, 3))
def test_compilers_have_nothing_to_say(tmp_path, version):
    """About the sources in the archive, with -Wall."""
    native.write_sources(native.sources(version, "{token}", *native.packed_profiles()), tmp_path)
    for unit in native.compiled_units(version):
        command = ["cc", "-std=gnu11", "-Wall", "-Werror", "-fsyntax-only", unit]
        done = subprocess.run(command, cwd=tmp_path, text=True, capture_output=True)
        assert (done.returncode, done.stderr) == (0, ""), done.stderr[:2000]


# --- building -------------------------------------------------------------------------------------


def test_missing_compiler_is_reported(monkeypatch):
    monkeypatch.setattr(compiler.importlib.util, "find_spec", lambda name: None)
    monkeypatch.setattr(compiler.shutil, "which", lambda name: None)
    with pytest.raises(CompilerProblem, match="no compiler for aarch64-darwin; pip install ziglang"):
        compiler_for(PLATFORMS["aarch64-darwin"])


@pytest.mark.full
@pytest.mark.skipif(not shutil.which("cc"), reason="the machine has no C compiler of its own")
def test_the_systems_own_compiler_gives_the_same_values(fmus, tmp_path, monkeypatch):
    """Another compiler, the same bits but for the mathematical library."""
    monkeypatch.setattr(compiler.importlib.util, "find_spec", lambda name: None)
    own = native.build_native_fmus(tmp_path / "own")
    rows = poses(20)
    seen = [
        run_scenario("trajectory", fmu, tmp_path / f"unpacked {k}", {"rows": rows, "names": OUTPUT_NAMES})[
            "seen"
        ]
        for k, fmu in enumerate((fmus[2], own[0]))
    ]
    for one, other in zip(*seen):
        assert_same(one, other)
