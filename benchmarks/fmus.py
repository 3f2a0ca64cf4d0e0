"""Cost of a step of the FMUs: set five inputs, step, read every output.

    python -m benchmarks.fmus

The Python FMU is stepped through fmpy's slave object.  Of its report ``kernel`` is one evaluation, ``layer``
the FMU's own Python around it (measured with a kernel that does nothing), ``importer`` the time that fmpy and
PythonFMU need to pass the values.  The native FMUs are stepped over the hunting run by a C host,
data/native_host.c, compiled by the system's ``cc`` against the archive alone.
"""

import json
import subprocess
import sys
import tempfile
import time
import zipfile
from pathlib import Path
from shutil import rmtree
from statistics import median
from types import MappingProxyType

import numpy as np
from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Slave

import data
from data.native_host import MOVED, native_host, rows_text

from .machine import Cost, description, unit
from .tables import figure, markdown

STEPS, REPEATS = 2000, 15
TARGET = 30  # units
ROUNDS = 5
NATIVE_TARGET = 12.5   # units

# ------------------------------------------------------------------------------------------------- Python FMU


def report_python():
    """Print the cost of a step of the Python FMU and its parts."""
    with tempfile.TemporaryDirectory() as folder:
        unpacked = extract(built(folder))
        try:
            report_parts(unpacked)
        finally:
            rmtree(unpacked, ignore_errors=True)


def built(folder):
    """The FMU of this checkout or of the installed package."""
    from wrcontact.fmu import build_fmu

    return str(build_fmu(folder))


def report_parts(unpacked):
    """Print the cost of a step and its parts."""
    fmu = Instance(unpacked)
    one = unit()
    print(f"unit: np.sqrt of 2000 doubles = {one * 1e6:.2f} us")
    moving = median_cost(fmu.step_over(moving_inputs()))
    kernel = median_cost(fmu.kernel_over(moving_inputs()))
    fmu.silence_kernel()
    layer = median_cost(fmu.layer_over(moving_inputs()))
    importer = median_cost(fmu.step_over(resting_inputs())) - median_cost(fmu.layer_over(resting_inputs()))
    rows = {"whole step": moving, "kernel": kernel, "layer": layer, "importer": importer}
    for name, seconds in rows.items():
        print(f"{name:12} {seconds * 1e6:7.1f} us {seconds / one:7.1f} units")
    print(f"target: {TARGET} units, {'met' if moving <= TARGET * one else 'MISSED'}")
    fmu.slave.freeInstance()


def steps(folder):
    """A function that makes STEPS steps of an FMU, which is built and unpacked in ``folder``."""
    step = Instance(extract(built(folder), str(Path(folder, "unpacked")))).step_over(moving_inputs())

    def work():
        for _ in range(STEPS):
            step()

    return work


class Instance:
    """One initialised FMU, and the session inside it: it runs in this process.

    ``strings`` are parameters by name, ``moved`` the names of the inputs that steps set.
    """

    def __init__(self, unpacked, strings=MappingProxyType({}), moved=MOVED):
        description = read_model_description(unpacked)
        self.slave = FMU2Slave(
            guid=description.guid,
            unzipDirectory=unpacked,
            modelIdentifier=description.coSimulation.modelIdentifier,
            instanceName="benchmark",
        )
        self.slave.instantiate()
        named = {v.name: v.valueReference for v in description.modelVariables}
        self.slave.setString([named[name] for name in strings], list(strings.values()))
        self.slave.setupExperiment()
        self.slave.enterInitializationMode()
        self.slave.exitInitializationMode()
        variables = description.modelVariables
        self.inputs = [named[name] for name in moved]
        self.reals = [v.valueReference for v in variables if v.causality == "output" and v.type == "Real"]
        self.integers = [v.valueReference for v in variables if v.causality == "output"
                         and v.type == "Integer"]
        module = next(module for name, module in sys.modules.items() if name.startswith("wheelset_contact_"))
        self.session = module.Session(tell=lambda sentence: None)
        self.session.start()

    def step_over(self, inputs):
        """The whole step as an importer does it."""
        slave, references, reals, integers = self.slave, self.inputs, self.reals, self.integers

        def step():
            slave.setReal(references, next(inputs))
            slave.doStep(0.0, 1e-3)
            slave.getReal(reals)
            slave.getInteger(integers)

        return step

    def layer_over(self, inputs):
        """The same calls on a session, without importer."""
        session, references, reals, integers = self.session, self.inputs, self.reals, self.integers

        def step():
            session.set_reals(references, next(inputs))
            session.step()
            session.get_reals(reals)
            session.get_integers(integers)

        return step

    def silence_kernel(self):
        """Replace the session's kernel by one that does nothing."""
        self.session._stepper.step = lambda: 0

    def kernel_over(self, inputs):
        """The kernel on the session's own arrays."""
        stepper = self.session._stepper

        def step():
            stepper.inputs[:len(MOVED)] = next(inputs)
            stepper.step()

        return step


def moving_inputs():
    """A hunting wheelset: poses that change at every step, flange to flange."""
    phase = np.linspace(0, 2 * np.pi, STEPS, endpoint=False)
    shift, yaw = 5e-3 * np.sin(phase), 5e-3 * np.cos(phase)
    force, transfer = 78.5e3 + 5e3 * np.sin(7 * phase), 0.1 * np.sin(3 * phase)
    rows = [tuple(row) for row in np.column_stack((shift, yaw, 0 * phase, force, transfer)).tolist()]
    while True:
        yield from rows


def resting_inputs():
    """Inputs that never change: nothing is computed."""
    while True:
        yield (1e-3, 0.0, 0.0, 78.5e3, 0.0)


def median_cost(action, count=STEPS, rounds=REPEATS):
    """Seconds per call: the median of several rounds."""
    found = []
    for _ in range(rounds):
        start = time.perf_counter()
        for _ in range(count):
            action()
        found.append((time.perf_counter() - start) / count)
    return median(found)


# ------------------------------------------------------------------------------------------------ native FMUs


def report_native(fmus=()):
    with tempfile.TemporaryDirectory() as folder:
        rows = []
        for version, measure in measures(folder, fmus):
            cost = measure()
            for _ in range(ROUNDS - 1):
                cost = measure().least(cost)
            rows.append([f"FMI {version}.0", figure(cost.units), figure(cost.microseconds)])
    print(markdown("Native FMUs from a C host, hunting with yaw: 5 inputs in, step, all outputs out",
                   ["", "units", "µs"], rows))
    print(f"Target: {NATIVE_TARGET} units.")
    print(description())


def measures(folder, fmus=()):
    """Yield the version of FMI and a function that returns the :class:`~benchmarks.Cost` of a step,
    for each of the ``fmus``; without any, they are built.  ``folder`` is for scratch."""
    if not fmus:
        from wrcontact.fmu.native import build_native_fmus

        fmus = build_native_fmus(folder)
    run = data.columns(data.HUNTING)
    file = Path(folder, "rows.txt")
    file.write_text(rows_text([{name: run[name][k] if name in run else 0.0 for name in MOVED}
                               for k in range(len(run["lateral_shift"]))]))
    for number, fmu in enumerate(fmus):
        with zipfile.ZipFile(fmu) as archive:
            version = 3 if "sources/buildDescription.xml" in archive.namelist() else 2
        host = native_host(fmu, version, Path(folder, f"native{number}"))
        yield version, lambda host=host: host_cost(host, file)


def host_cost(host, file):
    """:class:`~benchmarks.Cost` of a step, after a measurement of the unit."""
    one = unit()
    done = subprocess.run([str(host), "cost", str(file)], text=True, capture_output=True, check=True)
    return Cost(1e-6 * json.loads(done.stdout)["microseconds"], one)


if __name__ == "__main__":
    report_python()
    report_native()
