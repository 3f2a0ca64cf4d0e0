"""What tests of the native FMUs run: packed profiles, C hosts; each made once for a worker."""

import shutil
import subprocess

import pytest

from tests.helpers import c_host
from tests.helpers.cases import stored
from tests.helpers.fmus import measured
from tests.helpers.kept import locked
from wrcontact.fmu import native
from wrcontact.kernel.binding.compiler import digest
from wrcontact.storage.atomic import write_atomically


@pytest.fixture
def run(hosts):
    """Ask the FMU of FMI 2 a scenario of fmu_process.py."""
    return hosts(2).ask


@pytest.fixture
def run3(hosts):
    """The same of FMI 3."""
    return hosts(3).ask


@pytest.fixture(scope="session")
def packed(tmp_path_factory, kept):
    """FMUs by version with a wheel and a rail of one's own, and their files, whose names have
    spaces and other letters."""
    folder = tmp_path_factory.mktemp("Profile & 轮轨")
    wheel = measured("S1002", folder / "Rad 7 ä.txt")
    rail = measured("UIC60", folder / "Schiene 轨 'neu'.txt")
    return dict(zip((2, 3), kept("native", wheel=wheel, rail=rail))), wheel, rail


@pytest.fixture(params=(2, 3))
def native_fmu(request, hosts):
    """A version of FMI, and how to ask its FMU a scenario."""
    return request.param, hosts(request.param).ask


@pytest.fixture(scope="session")
def linked_host(fmus, tmp_path_factory):
    """The C host with the library in the FMU; `linked_host(2)` is the program."""
    made = {}

    def linked_host(version):
        if version not in made:
            made[version] = c_host.linked_host(fmus[version], version, tmp_path_factory.mktemp("linked"))
        return made[version]

    return linked_host


@pytest.fixture(scope="session")
def host(tmp_path_factory, compiled):
    """The C host with the FMU's sources, compiled with flags: `host(2, *SANITIZERS)`."""

    def host(version, *flags):
        folder = tmp_path_factory.mktemp("host")
        native.write_sources(native.sources(version, "{token}", *native.packed_profiles()), folder)
        shutil.copy(c_host.SOURCE, folder)
        units = {unit: c_host.HOOKS if "/" not in unit else [] for unit in native.compiled_units(version)}
        units[c_host.SOURCE.name] = [f"-DFMI={version}"]
        objects = [kept_object(compiled, folder, unit, *flags, *extra) for unit, extra in units.items()]
        subprocess.run(["cc", *flags, *objects, "-o", "host", "-lm", "-pthread"], cwd=folder, check=True)
        return folder / "host"

    return host


def kept_object(compiled, folder, unit, *flags):
    """A unit as an object in the folder ``compiled``; the kernel is compiled once for both versions of FMI
    and for all processes of a run."""
    command = ["cc", "-std=gnu11", "-O3", "-ffp-contract=off", *flags]
    kept = compiled / f"{digest(command, folder, unit)}.o"
    with locked(kept):
        if not kept.exists():
            subprocess.run([*command, "-c", unit, "-o", folder / "made.o"], cwd=folder, check=True)
            write_atomically(kept, (folder / "made.o").read_bytes())
        kept.touch()  # it is in use
    return kept


@pytest.fixture(scope="session")
def rows_file(tmp_path_factory):
    """Inputs of the stored run "hunting" as the C host reads them; the last 24 by ``rows_file(24)``."""
    folder = tmp_path_factory.mktemp("rows")
    _, rows, _ = stored("hunting")

    def rows_file(last=0):
        file = folder / f"last {last}.txt"
        file.write_text(c_host.rows_text(rows[-last:]))
        return file

    return rows_file
