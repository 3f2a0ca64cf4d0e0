"""Native FMUs in importers that are independent of fmpy and of each other, each in a process of its own.

They come with the extra "importers"; what is not installed is skipped, except with WRCONTACT_IMPORTERS=all,
as in .ci/run. Of FMI 3 Ecos has scalars only; libcosim ends its process with any FMU of FMI 3.
"""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.helpers.cases import RUNS, stored
from tests.helpers.fmus import assert_same, has_compiler, run_scenario, session, stepped
from tests.helpers.paths import HELPERS, ROOT
from tests.helpers.platforms import needs_importer
from wrcontact import ContactSystem
from wrcontact.interface.variables import OUTPUT, REAL, VARIABLES

SAME = 1e-9  # [relative]
ARRAYS = (
    "station[",
    "half_length[",
    "pressure[",
    "shear[",
    "slip[",
    "wheel_place[",
    "rail_place[",
    "power[",
    "patch_of[",
)  # FMI 3 has arrays
NAMES = [
    v.name
    for v in VARIABLES
    if v.causality == OUTPUT and v.type == REAL and not any(a in v.name for a in ARRAYS)
]
pytestmark = pytest.mark.skipif(
    not has_compiler(), reason="a native FMU is built by a C compiler, and none is here"
)


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


@pytest.mark.parametrize(
    "importer, version",
    [
        pytest.param(name, version, marks=needs_importer(name))
        for name, version in (("libcosimpy", 2), ("ecospy", 2), ("ecospy", 3))
    ],
)
def test_importer(fmus, wanted, importer, version, tmp_path):
    rows, expected = wanted
    last = in_process(
        tmp_path,
        str(HELPERS / "importer_process.py"),
        importer,
        str(fmus[version]),
        question=json.dumps({"rows": rows, "names": NAMES}),
    )
    assert_near(json.loads(last)["seen"], expected)


def in_process(folder, *words, question=None):
    """The last line that Python says, run with these words in a folder."""
    libraries = os.pathsep.join(
        filter(None, [str(Path(sys.prefix, "lib")), os.environ.get("LD_LIBRARY_PATH")])
    )
    environment = {**os.environ, "LD_LIBRARY_PATH": libraries}  # Ecos looks for its tbb there
    done = subprocess.run(
        [sys.executable, *words],
        text=True,
        input=question,
        capture_output=True,
        cwd=folder,
        timeout=300,
        env=environment,
    )
    assert done.returncode == 0, f"{done.stdout[-2000:]}\n{done.stderr[-2000:]}"
    return done.stdout.strip().splitlines()[-1]


PAGE = (ROOT / "docs" / "guides" / "importers.md").read_text(encoding="utf-8")


def example(kind, word, version):
    """The example of the page that has this word, for this version of FMI."""
    (code,) = (block for block in re.findall(rf"```{kind}\n(.*?)```", PAGE, re.DOTALL) if word in block)
    return code.replace("fmi2", f"fmi{version}")


def pages_case():
    """Force to the right and status of the page's pose, in Python: methods that only Strings can choose."""
    case = eval(re.search(r"^start = (\{.*?\})$", PAGE, re.MULTILINE | re.DOTALL)[1])
    methods = {name: case.pop(name) for name in ("contact_mode", "tangential_model")}
    state = ContactSystem(**methods).evaluate(**case)
    return pytest.approx([state.force.y, state.status], rel=SAME)


@pytest.mark.parametrize(
    "importer, version",
    [
        pytest.param(name, version, marks=needs_importer(name))
        for name, version in (("libcosimpy", 2), ("ecospy", 2), ("ecospy", 3))
    ],
)
def test_example_of_the_page(fmus, importer, version, tmp_path):
    """It sets Strings, and prints the force and the status."""
    shutil.copy(fmus[version], tmp_path)
    code = example("python", f"from {importer}", version)
    ending = "\nimport os\nos.sys.stdout.flush()\nos._exit(0)\n"  # without what importers do at the end
    last = in_process(tmp_path, "-c", code + ending)
    assert [float(word) for word in last.split()] == pages_case()


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
    (tmp_path / "container.csv").write_text(
        "\n".join(["rule;from_fmu;from_port;to_fmu;to_port", f"FMU;{fmus[version].name};;;", *ports]) + "\n"
    )
    # it takes no arrays whose length is a structural parameter
    only = ["-no-auto-output"] if version == 3 else []
    tool(
        "fmucontainer",
        "-fmu-directory",
        ".",
        "-container",
        "container.csv:0.001",
        "-auto-parameter",
        *only,
        folder=tmp_path,
    )
    seen = run_scenario(
        "trajectory", tmp_path / "container.fmu", tmp_path / "unpacked", {"rows": rows, "names": NAMES}
    )["seen"]
    assert_near([[found[name] for name in NAMES] for found in seen], expected)


@needs_importer("fmu_manipulation_toolbox")
@pytest.mark.parametrize("version", (2, 3))
def test_container_of_the_page(fmus, version, tmp_path):
    """Its rows of START set Strings."""
    shutil.copy(fmus[version], tmp_path)
    (tmp_path / "contact.csv").write_text(example("csv", "START", version))
    words = re.search(r"^    fmucontainer (.*)$", PAGE, re.MULTILINE)[1].split()
    tool("fmucontainer", *words, folder=tmp_path)
    code = (
        "import fmpy\nresult = fmpy.simulate_fmu('contact.fmu', stop_time=3e-3, step_size=1e-3, "
        "output=['force.y', 'status'])\nprint(result['force.y'][-1], result['status'][-1])"
    )
    assert [float(word) for word in in_process(tmp_path, "-c", code).split()] == pages_case()
