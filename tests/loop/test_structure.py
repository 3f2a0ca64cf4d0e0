"""The closed loop as an SSP: its description, and the same bits but for rounding by an independent master."""

import json
import subprocess
import sys
import zipfile

import numpy as np
from fmpy import read_model_description
from fmpy.ssp.ssd import read_ssd, read_ssv

from examples.hunting_wheelset.coupling import Loop, build_wheelset
from examples.hunting_wheelset.structure import EXAMPLE, STEP, settings, write_ssp
from tests.helpers.paths import ROOT
from tests.helpers.platforms import needs_importer

#: In a process of its own, which libcosim may end.
PROGRAM = """
import json, os, sys
from pathlib import Path
from examples.hunting_wheelset.structure import compare
folder, *archives = map(Path, sys.argv[1:])
theirs, mine, worst, _ = compare(folder, archives, count=2000)
print("\\n" + json.dumps([theirs.tolist(), mine.tolist(), worst]), flush=True)
os._exit(0)
"""


#: fmpy's master, which reads no parameter set; the library of PythonFMU may end its process afterwards.
SIMULATED = """
import json, os, sys
from fmpy.ssp.simulation import simulate_ssp
ssp, step, stop, *names = sys.argv[1:]
rows = simulate_ssp(ssp, stop_time=float(stop), step_size=float(step))
print("\\n" + json.dumps([rows["wheelset." + name].tolist() for name in names]), flush=True)
os._exit(0)
"""


def test_description(archives, tmp_path):
    """fmpy reads it by the standard's schema; every input that the wheelset's motion or the contact's forces
    give is connected once, and connectors are variables of the FMUs with the same causality."""
    ssp = write_ssp(tmp_path / "loop.ssp", archives, *settings(archives, EXAMPLE))
    system = read_ssd(str(ssp)).system
    with zipfile.ZipFile(ssp) as archive:
        archive.extractall(tmp_path / "unpacked")
    variables, values = {}, settings(archives, EXAMPLE)
    for part, wanted in zip(system.elements, values):
        (binding,) = part.parameterBindings
        given = read_ssv(str(ssp), resource=binding.source).parameters
        assert {one.name: one.value if one.type == "String" else float(one.value) for one in given} == wanted
    for part in system.elements:
        found = read_model_description(str(tmp_path / "unpacked" / part.source)).modelVariables
        variables[part.name] = {v.name: v.causality for v in found}
        for connector in part.connectors:
            assert variables[part.name][connector.name] == connector.kind
    ends = [(c.endElement, c.endConnector) for c in system.connections]
    assert len(set(ends)) == len(ends) == 17
    for connection in system.connections:
        assert variables[connection.startElement][connection.startConnector] == "output"
        assert variables[connection.endElement][connection.endConnector] == "input"


@needs_importer("libcosimpy")
def test_libcosim(archives, tmp_path):
    """2000 steps by libcosim and by fmpy in the same order; both compute with the same libraries, so that no
    more than rounding differs."""
    theirs, mine, worst = _answer(PROGRAM, tmp_path, *archives)
    assert worst == 0
    theirs, mine = np.array(theirs), np.array(mine)
    size = np.abs(mine).max(axis=0)
    assert np.all(size[[0, 3]] > 1e-4)  # it moves
    np.testing.assert_array_less(np.abs(theirs - mine).max(axis=0), 1e-10 * np.maximum(size, 1e-3))


def _answer(program, *arguments):
    """The last line that a process writes."""
    done = subprocess.run(
        [sys.executable, "-c", program, *map(str, arguments)],
        text=True,
        cwd=ROOT,
        capture_output=True,
        timeout=300,
    )
    assert done.returncode == 0, f"{done.stdout[-2000:]}\n{done.stderr[-2000:]}"
    return json.loads(done.stdout.strip().splitlines()[-1])


def test_parameters_stay_without_a_parameter_set(archives, kept, tmp_path):
    """In fmpy's own master, which reads none, from the start values of the FMUs.  It hands zeros to all inputs
    in its first step, so that motions agree but for what one step of 20 us without forces leaves."""
    contact, wheelset = values = settings(archives, EXAMPLE)
    own = kept("native", settings=contact)[0], build_wheelset(tmp_path / "own", wheelset)
    ssp, count = write_ssp(tmp_path / "loop.ssp", own, *values), 1000
    names = ("lateral_shift", "yaw")
    theirs = _answer(SIMULATED, ssp, STEP, (count - 0.5) * STEP, *names)
    with Loop(archives, EXAMPLE) as loop:
        mine = loop.run(count * STEP, STEP, parallel=True)
    for name, column, near in zip(names, theirs, (1e-6, 2e-6)):  # [m], [rad]
        assert len(column) == count and np.ptp(mine[name]) > 50 * near
        np.testing.assert_allclose(column, mine[name], rtol=0, atol=near)
