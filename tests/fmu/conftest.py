"""The Python FMU, built once for a worker."""

import zipfile

import pytest
from fmpy import read_model_description

from tests.helpers.fmus import run_scenario
from wrcontact.fmu import build_fmu


@pytest.fixture(scope="session")
def fmu(tmp_path_factory):
    """The FMU, built once."""
    return build_fmu(tmp_path_factory.mktemp("fmu"))


@pytest.fixture(scope="session")
def entries(fmu):
    """Contents of the archive by name."""
    with zipfile.ZipFile(fmu) as archive:
        return {info.filename: archive.read(info) for info in archive.infolist()}


@pytest.fixture(scope="session")
def description(fmu):
    return read_model_description(str(fmu))


@pytest.fixture
def run(fmu, tmp_path):
    """Run a scenario of fmu_process.py with the FMU and return what it saw."""

    def run(scenario, file=fmu, folder=tmp_path / "unpacked", **arguments):
        return run_scenario(scenario, file, folder, arguments)

    return run
