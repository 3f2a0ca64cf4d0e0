"""How tests run an FMU in a fresh process, and what they compare its outputs with."""

import json
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import fmpy
import numpy as np
import pytest

from tests.helpers.cases import INPUT_NAMES, OUTPUT_NAMES
from tests.helpers.paths import HELPERS
from wrcontact import ContactSystem
from wrcontact.fmu.compilers import CompilerProblem, compiler_for
from wrcontact.interface import variables
from wrcontact.interface.variables import BOOLEAN, REFERENCE, STRING, VARIABLES
from wrcontact.kernel.binding.platforms import PLATFORMS, host_platform
from wrcontact.profiles.catalogue import standard_profile
from wrcontact.simulation.session import Session
from wrcontact.state import WheelsetState

SAME = 1e-12        # [relative] to the package; the same compiler and libm give the same bits
WARM_START = 1e-7   # [relative] what the warm start leaves: other iterations, same answer


def run_scenario(scenario, file, folder, arguments):
    """A scenario in a fresh process that is not in this repository."""
    command = [sys.executable, str(HELPERS / "fmu_process.py"), scenario, str(file), str(folder)]
    settings = {"capture_output": True, "text": True, "encoding": "utf-8", "cwd": folder.parent,
                "timeout": 600}
    done = subprocess.run(command, input=json.dumps(arguments), **settings)
    assert done.returncode == 0, f"{scenario} ended with {done.returncode}:\n{done.stdout}\n{done.stderr}"
    return json.loads(done.stdout)


def evaluated(inputs, stepper=None):
    """Outputs by name from the host's own wrcontact."""
    stepper = stepper or ContactSystem().stepper()
    stepper.inputs[:] = [inputs.get(v.name, v.start) for v in VARIABLES[: len(INPUT_NAMES)]]
    status = stepper.step()
    outputs = dict(zip((v.name for v in VARIABLES[variables.FIRST_OUTPUT : variables.STATUS]),
                       stepper.outputs.tolist()))
    return {**outputs, "status": status}


def assert_same(found, wanted, tolerance=SAME):
    """Outputs are equal to ``tolerance``, of the value or of its variable's nominal value."""
    for name, value in wanted.items():
        nominal = VARIABLES[REFERENCE[name]].nominal or 1.0
        assert found[name] == pytest.approx(value, rel=tolerance, abs=tolerance * nominal), name


FMI_HEADERS = Path(fmpy.__file__).parent / "c-code"


def has_compiler():
    try:
        return bool(compiler_for(PLATFORMS[host_platform()]))
    except (CompilerProblem, KeyError):
        return False


needs_compiler = pytest.mark.skipif(not has_compiler(),
                                    reason="a native FMU is built by a C compiler, and none is here")


def session(lines=None, **start):
    """The session that the Python FMU runs, initialised."""
    made = Session(tell=(lambda sentence: None) if lines is None else lines.append)
    for name, value in start.items():
        (made.set_strings if VARIABLES[REFERENCE[name]].type == STRING
         else made.set_reals)([REFERENCE[name]], [value])
    made.start()
    return made


def stepped(made, row):
    """Outputs by name after a step of a session."""
    switches = {name: value for name, value in row.items() if VARIABLES[REFERENCE[name]].type == BOOLEAN}
    reals = {name: value for name, value in row.items() if name not in switches}
    made.set_booleans([REFERENCE[name] for name in switches], list(switches.values()))
    made.set_reals([REFERENCE[name] for name in reals], list(reals.values()))
    made.step()
    reals = [v.name for v in VARIABLES[variables.FIRST_OUTPUT:variables.STATUS]]
    return {**dict(zip(reals, made._values[variables.FIRST_OUTPUT:variables.STATUS].tolist())),
            "status": made.status}


def header_functions(version):
    """Names of all functions in the standard's header."""
    text = Path(FMI_HEADERS, f"fmi{version}Functions.h").read_text()
    names = re.findall(rf"^ *FMI{version}_Export fmi{version}\w+TYPE +(fmi{version}\w+);", text, re.MULTILINE)
    assert len(names) == {2: 44, 3: 75}[version]
    return names


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


def outputs_of(script, fmu, folder, rows, start=None):
    """Outputs over rows of inputs, by fmu_process.py or native_process.py in a fresh process."""
    given = json.dumps({"rows": rows, "names": OUTPUT_NAMES, "start": start or {}})
    done = subprocess.run([sys.executable, str(HELPERS / script), "trajectory", str(fmu), str(folder)],
                          input=given, text=True, capture_output=True, encoding="utf-8", timeout=600)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)["seen"]


def outline_of_both(values):
    """Both sides' runs of an outline by the names of FMI 3."""
    state = WheelsetState(values, 0, None)
    return {f"{side}.{name}": getattr(getattr(state, side).outline, name).tolist()
            for side in ("left", "right") for name in ("station", "half_length", "pressure", "shear", "slip")}


needs_glibc = pytest.mark.skipif(not shutil.which("cc") or sys.platform != "linux",
                                 reason="no compiler for glibc here")
