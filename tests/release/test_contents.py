"""What a release has inside: nothing of others that its list of licences does not name, and sums of all."""

import json
import shutil
import subprocess
import zipfile
from importlib.metadata import PackageNotFoundError
from pathlib import Path

import pytest

import wrcontact
from tests.helpers.fmus import needs_compiler
from tools.releasing import bill
from tools.releasing.packages import ROOT, ReleaseProblem


def names_in(archive):
    return {part.name for part in bill.parts_in(Path(archive))}


@needs_compiler
@pytest.mark.full
def test_everything_in_native_fmus_is_ours_or_named(fmus):
    for version, fmu in fmus.items():
        # without a library for Windows
        assert names_in(fmu) == {f"FMI {version}.0 headers", "compiler-rt"}
        (headers,) = (part for part in bill.parts_in(Path(fmu)) if part.name.startswith("FMI"))
        for name, content in bill.entries_of(Path(fmu)).items():
            theirs = b"Modelica Association Project" in content and name.endswith(".h")
            assert theirs == (name in bill.parts_in(Path(fmu))[headers]), name


def test_everything_in_the_python_fmu_is_ours_or_named(fmu):
    found = {part.name: names for part, names in bill.parts_in(Path(fmu)).items()}
    assert {"PythonFMU", "compiler-rt"} <= set(found)
    libraries = [name for name in found["PythonFMU"] if name.startswith("binaries/")]
    assert libraries and not set(libraries) & set(found["compiler-rt"])


def test_what_nobody_has_named_ends_the_build(fmu, tmp_path):
    copy = tmp_path / "WheelsetContact.fmu"
    shutil.copy(fmu, copy)
    with zipfile.ZipFile(copy, "a") as archive:
        archive.writestr("resources/theirs.py", "print('of others')\n")
    with pytest.raises(ReleaseProblem, match=r"entries of unknown origin: resources/theirs\.py"):
        bill.parts_in(copy)


def test_libraries_for_windows_have_start_up_code_of_others(tmp_path):
    wheel = tmp_path / "wrcontact-1-py3-none-win_amd64.whl"
    with zipfile.ZipFile(wheel, "w") as archive:
        archive.writestr("wrcontact/kernel/_wrcontact_kernel-x86_64-windows.dll", "")
        archive.writestr("wrcontact/__init__.py", (ROOT / "wrcontact" / "__init__.py").read_bytes())
    assert names_in(wheel) == {"mingw-w64", "compiler-rt"} and bill.libraries_of(wheel) == {"x86_64-windows"}


@needs_compiler
def test_bill_of_materials(fmu, fmus):
    archives = [Path(fmu), *map(Path, fmus.values())]
    try:
        text, licences = bill.bill(archives)
    except PackageNotFoundError:
        pytest.fail("wrcontact is not installed, so it states no needs")
    page = json.loads(text)
    assert (page["bomFormat"], page["specVersion"]) == ("CycloneDX", "1.6")
    assert page["metadata"]["component"]["version"] == wrcontact.__version__
    names = {component["name"] for component in page["components"]}
    assert {"FMI 2.0 headers", "FMI 3.0 headers", "PythonFMU", "numpy", "scipy", "typer"} <= names
    assert "fmpy" in map(str.lower, names)
    assert "pytest" not in names  # of an extra
    references = [component["bom-ref"] for component in page["components"]]
    assert len(set(references)) == len(references) and page["dependencies"][0]["dependsOn"] == references
    for component in page["components"]:
        ((one,),) = (entry.values() for entry in component["licenses"])
        assert {*one} <= {"id", "name"} and all(one.values()), component
        assert f"{component['name']} {component.get('version', '')}".strip() in licences
    assert bill.bill(archives) == (text, licences)


def test_sums_are_those_of_sha256sum(tmp_path):
    from tools.release import SUMS, write_sums

    for name in ("b.whl", "a.fmu"):
        (tmp_path / name).write_bytes(name.encode() * 1000)
    assert [file.name for file in write_sums(tmp_path)] == ["a.fmu", "b.whl"]
    if shutil.which("sha256sum"):
        subprocess.run(["sha256sum", "--check", "--quiet", SUMS], cwd=tmp_path, check=True)
    (tmp_path / "a.fmu").write_bytes(b"other")
    assert (tmp_path / SUMS).read_text().count("\n") == 2


def test_a_folder_with_files_is_refused(tmp_path, capsys):
    import typer

    from tools.release import release

    (tmp_path / "old.whl").write_text("")
    with pytest.raises(typer.Exit):
        release(tmp_path)
    assert "is not empty; permitted is a new or an empty folder" in capsys.readouterr().err
