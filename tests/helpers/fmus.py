"""How tests run an FMU in a fresh process, and what they compare its outputs with."""

import json
import shutil
import subprocess
import sys
import threading
import time
import zipfile
from pathlib import Path

import numpy as np
import pytest

from tests.helpers.cases import INPUT_NAMES
from tests.helpers.fmi_host import signatures
from tests.helpers.paths import HELPERS
from wrcontact import ContactSystem
from wrcontact.interface import variables
from wrcontact.interface.outputs import WEAR
from wrcontact.interface.variables import BOOLEAN, PLACE, REFERENCE, STRING, VARIABLES
from wrcontact.kernel.binding.compiler import CompilerProblem, compiler_for
from wrcontact.kernel.binding.files import PLATFORMS, host_platform
from wrcontact.profiles.catalogue import standard_profile
from wrcontact.simulation.session import Session
from wrcontact.state import WheelsetState

SAME = 1e-12  # [relative] to the package; the same compiler and libm give the same bits
WARM_START = 1e-7  # [relative] what the warm start leaves: other iterations, same answer


def run_process(scenario, file, folder, arguments):
    """A scenario in a process of its own, outside this repository, and what it writes on the console."""
    done = subprocess.run(
        command(file, folder),
        input=question(scenario, arguments),
        capture_output=True,
        text=True,
        encoding="utf-8",
        cwd=folder.parent,
        timeout=600,
    )
    assert done.returncode == 0, f"{scenario} ended with {done.returncode}:\n{done.stdout}\n{done.stderr}"
    return answer_of(done.stdout, scenario), done.stderr


def run_scenario(scenario, file, folder, arguments):
    return run_process(scenario, file, folder, arguments)[0]


def command(file, folder):
    return [sys.executable, str(HELPERS / "fmu_process.py"), str(file), str(folder)]


def question(scenario, arguments):
    return json.dumps({"scenario": scenario, **arguments}) + "\n"


def answer_of(line, scenario):
    seen = json.loads(line)
    assert "error" not in seen, f"{scenario}:\n{seen['error']}"
    return seen["answer"]


class Host:
    """A process with an FMU that answers one scenario after the other; ``folder`` is its scratch."""

    def __init__(self, file, folder):
        self.file, self.folder, self.errors = file, folder, folder / "errors.txt"
        self.process = None
        folder.mkdir(exist_ok=True)

    def ask(self, scenario, **arguments):
        """What the FMU does in a scenario. A process that has ended says why, and is begun anew."""
        if self.process is None:
            with open(self.errors, "w") as errors:
                place = self.folder / f"unpacked {time.monotonic_ns()}"
                self.process = subprocess.Popen(
                    command(self.file, place),
                    stdin=subprocess.PIPE,
                    text=True,
                    stdout=subprocess.PIPE,
                    stderr=errors,
                    encoding="utf-8",
                    cwd=self.folder,
                )
        patience = threading.Timer(600, self.process.kill)
        patience.start()
        self.process.stdin.write(question(scenario, arguments))
        self.process.stdin.flush()
        line = self.process.stdout.readline()
        patience.cancel()
        if not line:
            self.end()
            pytest.fail(f"{scenario} ended the process:\n{self.errors.read_text(errors='replace')[-4000:]}")
        return answer_of(line, scenario)

    def end(self):
        if self.process:
            self.process.stdin.close()
            self.process.wait(timeout=600)
            self.process.stdout.close()
            self.process = None


def evaluated(inputs, stepper=None):
    """Outputs by name from the host's own wrcontact."""
    stepper = stepper or ContactSystem().stepper()
    stepper.inputs[:] = [inputs.get(v.name, v.start) for v in VARIABLES[: len(INPUT_NAMES)]]
    status = stepper.step()
    outputs = dict(
        zip((v.name for v in VARIABLES[variables.FIRST_OUTPUT : variables.STATUS]), stepper.outputs.tolist())
    )
    return {**outputs, "status": status}


def assert_same(found, wanted, tolerance=SAME):
    """Outputs are equal to ``tolerance``, of the value or of its variable's nominal value."""
    for name, value in wanted.items():
        nominal = VARIABLES[PLACE[name]].nominal or 1.0
        assert found[name] == pytest.approx(value, rel=tolerance, abs=tolerance * nominal), name


def has_compiler():
    try:
        return bool(compiler_for(PLATFORMS[host_platform()]))
    except (CompilerProblem, KeyError):
        return False


needs_compiler = pytest.mark.skipif(
    not has_compiler(), reason="a native FMU is built by a C compiler, and none is here"
)


#: Of FMUs: the Python FMU, and the native ones by version of FMI.
KINDS = ("python", pytest.param(2, marks=needs_compiler), pytest.param(3, marks=needs_compiler))


def session(lines=None, **start):
    """The session that the Python FMU runs, initialised."""
    made = Session(log=(lambda sentence: None) if lines is None else lines.append)
    for name, value in start.items():
        setters = {STRING: made.set_strings, BOOLEAN: made.set_booleans}
        setters.get(VARIABLES[PLACE[name]].type, made.set_reals)([REFERENCE[name]], [value])
    made.start()
    return made


def stepped(made, row):
    """Outputs by name after a step of a session."""
    switches = {name: value for name, value in row.items() if VARIABLES[PLACE[name]].type == BOOLEAN}
    reals = {name: value for name, value in row.items() if name not in switches}
    made.set_booleans([REFERENCE[name] for name in switches], list(switches.values()))
    made.set_reals([REFERENCE[name] for name in reals], list(reals.values()))
    made.step()
    reals = [v.name for v in VARIABLES[variables.FIRST_OUTPUT : variables.STATUS]]
    return {
        **dict(zip(reals, made._values[variables.FIRST_OUTPUT : variables.STATUS].tolist())),
        "status": made.status,
    }


def header_functions(version):
    """Names of all functions in the standard's header."""
    return [f"fmi{version}{name}" for name in signatures(version)]


def unpacked_library(fmu, version, folder):
    place = PLATFORMS[host_platform()]
    inside = place.fmi2 if version == 2 else place.name
    with zipfile.ZipFile(fmu) as archive:
        return Path(archive.extract(f"binaries/{inside}/WheelsetContact{place.suffix}", folder))


def measured(name, file, step=1e-4):
    """A file of points [mm] on a standard profile, as a measurement without noise would give them."""
    profile = standard_profile(name)
    y = np.arange(profile.start + 1e-4, profile.stop - 1e-4, step)
    file.parent.mkdir(parents=True, exist_ok=True)
    np.savetxt(file, 1e3 * np.column_stack((y, profile.height(y))), fmt="%.6f")
    return file


def outline_of_both(values, layout):
    """Both sides' runs of an outline by the names of FMI 3; those of wear are zero where they are not
    computed."""
    state = WheelsetState(values, 0, None, layout)
    found = {}
    for side in ("left", "right"):
        outline = getattr(state, side).outline.to_dict()
        outline |= {row.name: [0.0] * len(outline["station"]) for row in WEAR if row.name not in outline}
        found |= {f"{side}.{name}": values for name, values in outline.items()}
    return found


needs_glibc = pytest.mark.skipif(
    not shutil.which("cc") or sys.platform != "linux", reason="no compiler for glibc here"
)
