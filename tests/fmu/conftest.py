"""FMUs of three kinds, "python", 2 and 3, each in a process that answers scenarios one after the other."""

import zipfile

import pytest
from fmpy import read_model_description

from tests.helpers.fmus import KINDS, Host, run_scenario


@pytest.fixture(scope="session")
def entries(fmu):
    """Contents of the Python FMU's archive by name."""
    with zipfile.ZipFile(fmu) as archive:
        return {info.filename: archive.read(info) for info in archive.infolist()}


@pytest.fixture(scope="session")
def description(fmu):
    return read_model_description(str(fmu))


@pytest.fixture(scope="session")
def archive_of(request):
    """The FMU of a kind."""

    def archive_of(kind):
        return request.getfixturevalue("fmu") if kind == "python" else request.getfixturevalue("fmus")[kind]

    return archive_of


@pytest.fixture(scope="session")
def hosts(archive_of, tmp_path_factory):
    """``hosts(2)`` is the process of an FMU."""
    made = {}

    def host(kind):
        if kind not in made:
            made[kind] = Host(archive_of(kind), tmp_path_factory.mktemp(f"host_{kind}"))
        return made[kind]

    yield host
    for one in made.values():
        one.end()


@pytest.fixture(params=KINDS)
def kind(request):
    """Each of the three FMUs in turn."""
    return request.param


@pytest.fixture
def run(hosts, kind):
    """Ask the FMU a scenario of fmu_process.py."""
    return hosts(kind).ask


@pytest.fixture
def run_alone(archive_of, kind, tmp_path):
    """The same in a process of its own."""
    folder = tmp_path / "unpacked"
    return lambda scenario, **arguments: run_scenario(scenario, archive_of(kind), folder, arguments)
