"""Cost of a step of the Python FMU through fmpy's slave object: set five inputs, step, read every output.

    python -m benchmarks.fmu_step [FMU]

The unit is ``np.sqrt`` of 2000 doubles, measured in the same run, so that results of two machines can be
compared.  Without an argument the FMU is built into a temporary folder.  ``kernel`` is one evaluation,
``layer`` the FMU's own Python around it (measured with a kernel that does nothing), ``importer`` the time
that fmpy and PythonFMU need to pass the values.
"""

import sys
import tempfile
import time
from pathlib import Path
from shutil import rmtree
from statistics import median
from types import MappingProxyType

import numpy as np
from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Slave

from .machine import unit

STEPS, ROUNDS = 2000, 15
#: Inputs that are set in every step; height and roll of compliant contact are not.
MOVED = ("lateral_shift", "yaw", "roll_guess", "normal_force", "load_transfer")
TARGET = 30  # units


def main(fmu=None):
    with tempfile.TemporaryDirectory() as folder:
        fmu = fmu or built(folder)
        unpacked = extract(fmu)
        try:
            report(unpacked)
        finally:
            rmtree(unpacked, ignore_errors=True)


def built(folder):
    """The FMU of this checkout or of the installed package."""
    from wrcontact.fmu import build_fmu

    return str(build_fmu(folder))


def report(unpacked):
    """Print the cost of a step and its parts."""
    fmu = Instance(unpacked)
    one = unit()
    print(f"unit: np.sqrt of 2000 doubles = {one * 1e6:.2f} us")
    moving, kernel = cost(fmu.step_over(moving_inputs())), cost(fmu.kernel_over(moving_inputs()))
    fmu.silence_kernel()
    layer = cost(fmu.layer_over(moving_inputs()))
    importer = cost(fmu.step_over(resting_inputs())) - cost(fmu.layer_over(resting_inputs()))
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


def cost(action, count=STEPS, rounds=ROUNDS):
    """Seconds per call: the median of several rounds."""
    found = []
    for _ in range(rounds):
        start = time.perf_counter()
        for _ in range(count):
            action()
        found.append((time.perf_counter() - start) / count)
    return median(found)


if __name__ == "__main__":
    main(*sys.argv[1:])
