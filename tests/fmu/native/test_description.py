"""The native FMUs' descriptions and archives, and that their libraries export all of the standard."""

import ctypes
import re
import zipfile
from xml.etree import ElementTree

import pytest
from fmpy import read_model_description

from tests.helpers.fmus import header_functions, needs_compiler, unpacked_library
from wrcontact.cli import demo
from wrcontact.fmu import native
from wrcontact.fmu.description3 import variable_blocks
from wrcontact.interface.variables import BOOLEAN, OUTPUT, PARAMETER, STRING, VARIABLES
from wrcontact.kernel.binding.files import PLATFORMS, host_platform

pytestmark = needs_compiler


# --- description ----------------------------------------------------------------------------------


@pytest.mark.parametrize("version", (2, 3))
def test_archive_needs_no_python(fmus, version):
    with zipfile.ZipFile(fmus[version]) as archive:
        names = archive.namelist()
    assert not [name for name in names if name.startswith("resources/") or name.endswith((".py", ".pyc"))]
    assert {
        "modelDescription.xml",
        "documentation/index.html",
        "documentation/licenses/fmi.txt",
    } <= set(names)
    assert ("terminalsAndIcons/terminalsAndIcons.xml" in names) == (version == 3)
    place = PLATFORMS[host_platform()]
    assert f"binaries/{place.fmi2 if version == 2 else place.name}/WheelsetContact{place.suffix}" in names


def test_fmi3_variables_are_those_of_the_table(fmus):
    described = read_model_description(str(fmus[3])).modelVariables
    assert [(v.name, v.valueReference) for v in described] == [
        (block.name, block.reference) for block in variable_blocks()
    ]
    assert described[0].name == "time" and described[0].causality == "independent"
    with zipfile.ZipFile(fmus[3]) as archive:
        page = ElementTree.fromstring(archive.read("modelDescription.xml"))
    stations = page.find("ModelVariables/UInt64").attrib
    assert stations.pop("description") and stations == {
        "name": "stations",
        "valueReference": "2",
        "causality": "structuralParameter",
        "variability": "fixed",
        "start": "31",
        "min": "3",
        "max": "201",
    }
    seen = []
    for v in described[2:]:
        assert [d.valueReference for d in v.dimensions] in ([], [2])
        seen += [f"{v.name}[{k + 1}]" for k in range(v.shape[0])] if v.dimensions else [v.name]
    assert seen == [v.name for v in VARIABLES]
    by_name = {v.name: v for v in described}
    for variable in VARIABLES:
        found = by_name.get(variable.name)
        if found is not None:
            assert (found.causality, found.variability, found.description) == (
                variable.causality,
                variable.variability,
                variable.description,
            )
            assert found.unit == (variable.unit or None)
            if variable.start is not None:
                wanted = variable.start if variable.type == STRING else repr(variable.start)
                assert found.start == (wanted.lower() if variable.type == BOOLEAN else wanted)
    assert by_name["left.station"].shape == (31,)


def test_fmi3_dependencies_are_those_of_the_table(fmus):
    described = read_model_description(str(fmus[3]))
    follows = {u.variable.name: {d.name for d in u.dependencies} for u in described.outputs}
    runs = r"(station|half_length|pressure|shear|slip|wheel_place|rail_place|power|patch_of)\[\d+\]"
    for variable in VARIABLES:
        name = re.sub(runs, r"\1", variable.name)
        if variable.causality == OUTPUT:
            assert follows[name] == set(variable.depends_on), name
    initial = {u.variable.name: {d.name for d in u.dependencies} for u in described.initialUnknowns}
    parameters = {v.name for v in VARIABLES if v.causality == PARAMETER}
    assert initial["roll"] == follows["roll"] | parameters
    assert "stations" not in initial["roll"]
    assert initial["right.pressure"] == initial["roll"] | {"stations"}


@pytest.mark.parametrize("version", (2, 3))
def test_every_function_of_the_standard_is_exported(fmus, tmp_path, version):
    library = ctypes.CDLL(str(unpacked_library(fmus[version], version, tmp_path)))
    assert [name for name in header_functions(version) if not hasattr(library, name)] == []
    assert not hasattr(library, "wrcontact_step"), "the kernel's own functions stay inside"


# --- behaviour ------------------------------------------------------------------------------------


def test_demo_runs_a_native_fmu(fmus, tmp_path, monkeypatch, capsys):
    """As wrcontact demo --native does, without building and drawing."""
    monkeypatch.setattr(native, "build_native_fmus", lambda folder: list(fmus.values()))
    monkeypatch.setattr(demo, "draw", lambda *arguments: None)
    assert demo.run_demo(tmp_path, native=True)
    assert fmus[2].name in capsys.readouterr().out.replace("\n", "")
