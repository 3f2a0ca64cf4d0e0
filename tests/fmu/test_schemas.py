"""Every XML file in each of the three archives keeps to the official schemas, unmodified."""

import zipfile
from xml.etree import ElementTree

import pytest
from fmpy.validation import validate_fmu

from tests.helpers.fmus import needs_compiler
from tests.helpers.schemas import problems_of, xml_problems

pytestmark = pytest.mark.check

NATIVE = {2: {"modelDescription.xml"}}
NATIVE[3] = NATIVE[2] | {"terminalsAndIcons/terminalsAndIcons.xml", "sources/buildDescription.xml"}


@pytest.mark.parametrize(
    "kind", [3, *(pytest.param(kind, marks=pytest.mark.full) for kind in ("python", 2))], indirect=True
)
def test_fmpy_finds_no_problem(archive_of, kind):
    """Nor in any other archive: it would not be written."""
    assert validate_fmu(str(archive_of(kind))) == []


def test_python_archive(fmu):
    assert xml_problems(fmu, 2) == {name: [] for name in NATIVE[2]}


@needs_compiler
@pytest.mark.parametrize("version", (2, 3))
def test_native_archive(fmus, version):
    assert xml_problems(fmus[version], version) == {name: [] for name in NATIVE[version]}


@needs_compiler
def test_build_description_names_the_compiler_of_its_options(fmus):
    with zipfile.ZipFile(fmus[3]) as archive:
        root = ElementTree.fromstring(archive.read("sources/buildDescription.xml"))
    files = root.find("BuildConfiguration/SourceFileSet")
    assert files.get("compiler") == "gcc"
    assert files.get("compilerOptions") == "-O3 -ffp-contract=off -fno-math-errno"
    assert files.get("language") == "C11"


def test_schemas_see_a_wrong_version():
    wrong = b'<fmiTerminalsAndIcons fmiVersion="2.0"/>'
    assert "fmiVersion" in problems_of(wrong, "fmi3/fmi3TerminalsAndIcons.xsd")[0]
