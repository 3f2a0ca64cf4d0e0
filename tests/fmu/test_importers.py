"""Native FMUs in importers that are independent of fmpy and of each other, each in a process of its own.

They come with the extra "importers"; what is not installed is skipped, except with WRCONTACT_IMPORTERS=all,
as in .ci/run. Of FMI 3 Ecos has scalars only; libcosim ends its process with any FMU of FMI 3.
"""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.helpers.cases import RUNS, stored
from tests.helpers.fmus import assert_same, has_compiler, run_scenario, session, stepped
from tests.helpers.paths import HELPERS
from tests.helpers.platforms import needs_importer
from wrcontact.interface.variables import OUTPUT, REAL, VARIABLES

SAME = 1e-9  # [relative]
ARRAYS = ("station[", "half_length[", "pressure[", "shear[", "slip[", "wheel_place[", "rail_place[", "power[",
          "patch_of[")  # FMI 3 has arrays
NAMES = [v.name for v in VARIABLES if v.causality == OUTPUT and v.type == REAL
         and not any(a in v.name for a in ARRAYS)]
pytestmark = pytest.mark.skipif(not has_compiler(),
                                reason="a native FMU is built by a C compiler, and none is here")


@pytest.fixture(scope="session")
def wanted():
    """Inputs of the stored runs, one after the other, and what the package gives. A rigid wheelset is in
    equilibrium where it stands."""
    rows = [row for name in RUNS for row in stored(name)[1]]
    made = session()
    return rows, [[stepped(made, row)[name.removeprefix("equilibrium.")] for name in NAMES] for row in rows]


def assert_near(seen, wanted):
    for found, expected in zip(seen, wanted, strict=True):
        assert_same(dict(zip(NAMES, found, strict=True)), dict(zip(NAMES, expected)), SAME)


@pytest.mark.parametrize("importer, version", [
    pytest.param(name, version, marks=needs_importer(name))
    for name, version in (("libcosimpy", 2), ("ecospy", 2), ("ecospy", 3))])
def test_importer(fmus, wanted, importer, version, tmp_path):
    rows, expected = wanted
    libraries = os.pathsep.join(filter(None,
                                       [str(Path(sys.prefix, "lib")), os.environ.get("LD_LIBRARY_PATH")]))
    done = subprocess.run([sys.executable, str(HELPERS / "importer_process.py"), importer,
                           str(fmus[version])], text=True,
                          input=json.dumps({"rows": rows, "names": NAMES}), capture_output=True, cwd=tmp_path,
                          timeout=300,
                          env={**os.environ, "LD_LIBRARY_PATH": libraries})     # Ecos looks for its tbb there
    assert done.returncode == 0, f"{done.stdout[-2000:]}\n{done.stderr[-2000:]}"
    assert_near(json.loads(done.stdout.strip().splitlines()[-1])["seen"], expected)


def tool(name, *arguments, folder):
    """Run a tool of the FMU Manipulation Toolbox; what it says."""
    command = shutil.which(name, path=str(Path(sys.executable).parent))
    done = subprocess.run([command, *arguments], text=True, capture_output=True, cwd=folder, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout + done.stderr


@needs_importer("fmu_manipulation_toolbox")
@pytest.mark.parametrize("version", (2, 3))
def test_fmutool_finds_nothing(fmus, version, tmp_path):
    said = tool("fmutool", "-input", str(fmus[version]), "-check", folder=tmp_path)
    assert f"compliant with FMI-{version}.0" in said
    assert f"No semantic error against the FMI-{version} standard" in said


@needs_importer("fmu_manipulation_toolbox")
@pytest.mark.parametrize("version", (pytest.param(2, marks=pytest.mark.full), 3))
def test_container(fmus, wanted, version, tmp_path):
    """The FMU inside a container of FMI 2: the container's C importer drives it, fmpy the container."""
    rows, expected = wanted
    shutil.copy(fmus[version], tmp_path)
    ports = [f"OUTPUT;{fmus[version].name};{name};;{name}" for name in NAMES]
    (tmp_path / "container.csv").write_text("\n".join(["rule;from_fmu;from_port;to_fmu;to_port",
                                                       f"FMU;{fmus[version].name};;;", *ports]) + "\n")
    # it takes no arrays whose length is a structural parameter
    only = ["-no-auto-output"] if version == 3 else []
    tool("fmucontainer", "-fmu-directory", ".", "-container", "container.csv:0.001", "-auto-parameter", *only,
         folder=tmp_path)
    seen = run_scenario("trajectory", tmp_path / "container.fmu", tmp_path / "unpacked",
                        {"rows": rows, "names": NAMES})["seen"]
    assert_near([[found[name] for name in NAMES] for found in seen], expected)
