"""The library by which a host on Linux loads the Python FMU: in folders of any name, by any location, and without
a Python in the host."""

import os
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path
from urllib.parse import quote

import fmpy
import numpy as np
import pytest
from fmpy import read_model_description

import wrcontact
from tests.helpers.fmi_host import HEADERS
from tests.helpers.fmus import needs_glibc
from tests.helpers.paths import HELPERS
from wrcontact.fmu import SOURCES, build
from wrcontact.kernel.binding.compiler import LOADER_NAME, CompilerProblem, compile_loader

pytestmark = [pytest.mark.check, needs_glibc]

LIBPYTHON = Path(sysconfig.get_config_var("LIBDIR") or "/", sysconfig.get_config_var("INSTSONAME") or "none")
needs_libpython = pytest.mark.skipif(
    not LIBPYTHON.is_file() or ".so" not in LIBPYTHON.name,
    reason="this Python is linked statically and has no libpython",
)
#: Names of folders: letters of other languages, what a URI has for itself, and what looks like it is decoded.
NAMES = ("ä ö", "轮轨", "50 %", "a#b?c", 'it\'s "so"', "Söhne & Co (neu) [1]", "1+1=2, @", "a%20b", "c%41")


@pytest.fixture(scope="module")
def host(fmu, tmp_path_factory):
    """``host(archive's folder, location, ...)`` runs a C program there: its lines, one for each location."""
    folder = tmp_path_factory.mktemp("host")
    source = HELPERS / "python_fmu_host.c"
    subprocess.run(
        ["cc", "-std=gnu11", "-O1", f"-I{HEADERS}", str(source), "-o", "host", "-ldl"],
        cwd=folder,
        check=True,
    )
    described = read_model_description(str(fmu))
    reference = {v.name: str(v.valueReference) for v in described.modelVariables}
    words = [described.guid, reference["lateral_shift"], reference["right.area"]]
    home = {
        "PYTHONHOME": sys.base_prefix,
        "PYTHONPATH": str(Path(np.__file__).parents[1]),
        "WRCONTACT_LIBPYTHON": str(LIBPYTHON),
    }

    def run(place, *locations, **settings):
        library = place / "binaries" / "linux64" / "WheelsetContact.so"
        environment = {**os.environ, **home, **settings}
        done = subprocess.run(
            [str(folder / "host"), str(library), *words, *locations],
            capture_output=True,
            text=True,
            encoding="utf-8",
            env=environment,
            timeout=300,
        )
        assert done.returncode == 0, f"{done.returncode}: {done.stdout}\n{done.stderr}"
        return done.stdout.splitlines()

    return run


@pytest.fixture(scope="module")
def unpacked(fmu, tmp_path_factory):
    """The archive's contents in a folder of a plain name."""
    folder = tmp_path_factory.mktemp("plain")
    fmpy.extract(str(fmu), str(folder))
    return folder


@pytest.fixture(scope="module")
def area():
    """Of the right patch at 2 mm, from the package itself [m2]."""
    return wrcontact.ContactSystem().evaluate(lateral_shift=2e-3).right.area


@needs_libpython
def test_a_folder_may_have_any_name(host, unpacked, area, tmp_path):
    """Instances from all of them in one process, as a host names them."""
    folders = [Path(shutil.copytree(unpacked, tmp_path / name)) for name in NAMES]
    lines = host(unpacked, *((folder / "resources").as_uri() for folder in folders))
    assert [float(line) for line in lines] == pytest.approx([area] * len(NAMES), rel=1e-7)
    (line,) = host(folders[3], (folders[3] / "resources").as_uri())
    assert float(line) == pytest.approx(area, rel=1e-7)


@pytest.mark.full
@needs_libpython
def test_a_location_may_have_any_form(host, unpacked, area, tmp_path):
    """Also one that does not say where: the resources are then beside the library."""
    folder = Path(shutil.copytree(unpacked, tmp_path / "Räder & Schienen"))
    path = str(folder / "resources")
    forms = [
        f"file:{quote(path)}",
        f"file://localhost{quote(path)}",
        f"file://{quote(path)}/",
        f"file://{quote(path).replace('%C3', '%c3')}",
        f"file://{path}",
        path,
        "NULL",
        "",
        "file:///no/such/folder",
        "file://%",
    ]
    lines = host(folder, *forms)
    assert [float(line) for line in lines] == pytest.approx([area] * len(forms), rel=1e-7)


@needs_libpython
def test_a_location_counts_where_the_resources_are_not_beside_the_library(host, unpacked, area, tmp_path):
    """Beside it they would be found anyhow."""
    shutil.copytree(unpacked / "binaries", tmp_path / "alone" / "binaries")
    place = Path(shutil.copytree(unpacked / "resources", tmp_path / "Räder 轮轨"))
    (line,) = host(tmp_path / "alone", place.as_uri())
    assert float(line) == pytest.approx(area, rel=1e-7)


@needs_libpython
def test_a_library_alone_says_what_is_missing(host, unpacked, tmp_path):
    shutil.copytree(unpacked / "binaries", tmp_path / "binaries")
    lines = host(tmp_path, "file:///no/such/folder", "NULL")
    words = "host 4 logStatusError: fmuResourceLocation is {}; permitted is the folder resources of this FMU"
    assert [
        line.startswith(words.format(where)) for line, where in zip(lines, ("file:///no/such/folder", "NULL"))
    ] == [
        True,
        True,
    ]


@needs_libpython
def test_without_numpy_there_is_a_sentence(host, unpacked, tmp_path):
    """And no instance; the process goes on."""
    (tmp_path / "numpy.py").write_text("raise ModuleNotFoundError('No module named numpy')\n")
    (line,) = host(unpacked, (unpacked / "resources").as_uri(), PYTHONPATH=str(tmp_path))
    assert line.startswith("host 4 logStatusError: Python 3.") and "with numpy: ModuleNotFoundError" in line


def test_without_libpython_there_is_a_sentence(host, unpacked):
    """And no instance; the process goes on."""
    settings = {"WRCONTACT_LIBPYTHON": "/no/libpython.so", "PATH": "/no"}
    (line,) = host(unpacked, (unpacked / "resources").as_uri(), **settings)
    assert line.startswith("host 4 logStatusError: this FMU runs in Python, and no library of Python 3.10")


def test_the_loader_of_the_installation_is_packed_without_a_compiler(monkeypatch, tmp_path, capsys):
    """And without that PythonFMU's own library, with a warning."""

    def none(*_):
        raise CompilerProblem("there is no compiler")

    monkeypatch.setattr(build, "compile_loader", none)
    monkeypatch.setattr(build, "__file__", str(tmp_path / "build.py"))
    monkeypatch.setattr(build, "host_platform", lambda: "x86_64-linux")
    entries = build.runtime()
    assert "binaries/linux64/pythonfmu-export.so" not in entries
    assert "the FMU gets no loader" in capsys.readouterr().err
    made = compile_loader(SOURCES / "python", tmp_path)
    assert made.name == LOADER_NAME
    packed = build.runtime()
    assert packed["binaries/linux64/WheelsetContact.so"] == made.read_bytes()
    assert packed["binaries/linux64/pythonfmu-export.so"] == entries["binaries/linux64/WheelsetContact.so"]
    assert capsys.readouterr().err == ""
