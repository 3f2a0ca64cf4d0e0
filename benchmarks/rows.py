"""The rows that are timed, each with its errors: models by tolerance, strips and sweeps, the ways to call
them, and the FMUs.

A row is one wheelset: search, roll, and both wheels' patches.  Unless a row says otherwise, the poses follow
a trajectory without yaw and are evaluated by evaluate_many.  A step of an FMU sets inputs, steps and reads
every output: the Python FMU's through fmpy's slave object, the native ones' by a C host, native_times.c,
compiled by the system's ``cc`` against the archive alone.
"""

import itertools
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Slave

import data
from wrcontact.methods import Analyn, Strip

from . import errors
from .errors import FORCE, anywhere, system, trajectory
from .native_times import NativeStep
from .record import Cost, cost, unit

HALFSPACE = (0.1, 0.03, 0.01, 0.005)  # tolerances
STRIPS, SWEEPS = (6, 8, 10, 12, 16), (3, 6, 12)
EVERY = 10  # in a quick run the half-space solves each tenth row of the hunting run
FMU_STEPS = 2000
#: Inputs of a step of an FMU; height and roll of compliant contact stay at their start values.
MOVED = ("lateral_shift", "yaw", "roll_guess", "normal_force", "load_transfer")
HALFSPACE_FORM = "halfspace, tolerance {:g}"
FMU_ROW = "analyn, hunting with yaw, FMU step through fmpy: 5 inputs, all outputs"
NATIVE_ROW = "analyn, hunting with yaw, native FMU step from C, FMI {}.0: 5 inputs, all outputs"


def ladder_row(model, tolerance, resolution):
    """Name of the row of a model at one of its tolerances."""
    strips = f", {resolution.strips} strips × {resolution.sweeps}" if model is Strip else ""
    return f"{model.name}, tolerance {tolerance:g} ({resolution.nodes} nodes{strips})"


DEFAULT_ROW, STRIP_ROW = (ladder_row(model, 0.01, model.ladder[0.01]) for model in (Analyn, Strip))


@dataclass(frozen=True)
class Effort:
    """How much time a run spends on measuring."""

    count: int  # poses of a timed run
    rounds: int
    passes: int  # over all rows, so that a disturbance of some seconds does not slow all rounds of a row
    halfspace: tuple  # tolerances
    every: int  # the half-space solves each ``every``-th row of the hunting run


FULL = Effort(2000, 3, 5, HALFSPACE, 1)
QUICK = Effort(300, 3, 1, HALFSPACE[::2], EVERY)  # with the tolerance that the README shows


@dataclass
class Row:
    """One line of the table: ``cost()`` measures the :class:`Cost` of one evaluation; ``kind`` is its group
    and marker in the picture."""

    name: str
    kind: str
    cost: Callable
    system: object
    every: int = 1
    setting: str = ""  # label in the picture

    def errors(self):
        """Errors by name, as they are kept: mean and worst of both runs in %, or those of the rigid
        contact."""
        if self.kind == "geometry":
            return errors.rigid(self.system)
        return errors.percentages(errors.positions(self.system), errors.hunting(self.system, self.every))


def all_rows(effort):
    """Every measured row, not yet measured."""
    return [
        *formulas(effort),
        *ladders(effort),
        *halfspace(effort),
        *strips(effort),
        *orders(effort),
        *doors(effort),
    ]


def batch(system, poses, **options):
    """A call of evaluate_many."""
    shift, yaw = poses
    return lambda: system.evaluate_many(shift, yaw, FORCE, threads=1, **options)


def batch_row(name, kind, effort, poses=None, setting="", outputs="all", **options):
    """A row of evaluate_many over ``poses``, the trajectory without yaw by default, of the system with these
    ``options``."""
    of, poses = system(**options), trajectory(effort.count, yaw=0.0) if poses is None else poses
    work = batch(of, poses, outputs=outputs)
    return Row(name, kind, lambda: cost(work, effort.count, effort.rounds), of, setting=setting)


def formulas(effort):
    """Geometry alone; Hertz."""
    yield batch_row("geometry and roll alone", "geometry", effort, outputs="geometry")
    yield batch_row("Hertz", "Hertz", effort, normal_model="hertz")


def ladders(effort):
    """ANALYN and strips at each of their tolerances, and ANALYN with the other longitudinal
    curvature."""
    for model in (Analyn, Strip):
        for tolerance, resolution in model.ladder.items():
            yield batch_row(
                ladder_row(model, tolerance, resolution),
                model.name,
                effort,
                setting=f"{tolerance:g}",
                normal_model=model(tolerance=tolerance),
            )
    yield batch_row("analyn, longitudinal curvature basic", "analyn", effort, longitudinal_curvature="basic")


def halfspace(effort):
    """The half-space at each tolerance, timed once on the 20 positions."""
    shift = data.columns(data.POSITIONS)["lateral_shift"]
    for tolerance in effort.halfspace:
        of = system(normal_model="halfspace", tolerance=tolerance)
        work = batch(of, (shift, 0.0 * shift))
        yield Row(
            HALFSPACE_FORM.format(tolerance),
            "halfspace",
            lambda work=work: cost(work, len(shift), 1),
            of,
            effort.every,
            f"{tolerance:g}",
        )


def strips(effort):
    """Number of strips and sweeps, nodes as at the default tolerance."""
    for sweeps, strips in itertools.product(SWEEPS, STRIPS):
        yield batch_row(
            f"analyn_strip, {strips} strips × {sweeps}",
            "strips",
            effort,
            setting=f"× {sweeps}",
            normal_model="analyn_strip",
            strips=strips,
            sweeps=sweeps,
        )


def orders(effort):
    """Trajectory and random order of the poses, with and without yaw."""
    for options in ({}, {"normal_model": "analyn_strip"}):
        model = system(**options).parameters["normal_model"]
        for name, poses in (
            ("trajectory with yaw", trajectory(effort.count)),
            ("random poses", anywhere(effort.count, yaw=0.0)),
            ("random poses with yaw", anywhere(effort.count)),
        ):
            yield batch_row(f"{model}, {name}", "order", effort, poses, **options)


def doors(effort):
    """Ways to call: ``evaluate()`` and the stepper; :func:`hosted` has the FMUs."""
    shift, yaw = trajectory(effort.count)
    poses = list(zip(shift.tolist(), yaw.tolist()))
    stepper = system().stepper()

    def step():
        for stepper.inputs[0], stepper.inputs[1] in poses:
            stepper.step()

    stepper.inputs[3] = FORCE
    for name, work in (
        ("`evaluate()`", lambda: [system().evaluate(shift, yaw) for shift, yaw in poses]),
        ("stepper", step),
    ):
        yield Row(
            f"analyn, trajectory with yaw, {name} from Python",
            "door",
            lambda work=work: cost(work, effort.count, effort.rounds),
            system(),
        )


# ------------------------------------------------------------------------------------------------------- FMUs


def hosted(folder, effort):
    """Rows of the steps of all three FMUs, which are built in ``folder``."""
    step = fmu_step(python_fmu(folder), hunting_inputs())
    yield Row(
        FMU_ROW,
        "FMU",
        lambda: cost(lambda: [step() for _ in range(FMU_STEPS)], FMU_STEPS, effort.rounds),
        system(),
    )
    for version, measure in native_costs(folder):
        yield Row(NATIVE_ROW.format(version), "native", measure, system())


def python_fmu(folder):
    """The folder of the Python FMU, which is built and unpacked in ``folder``."""
    from wrcontact.fmu import build_fmu

    return extract(str(build_fmu(folder)), str(Path(folder, "unpacked")))


def fmu_step(unpacked, inputs, moved=MOVED, **strings):
    """A step, as an importer makes it, of an initialised FMU that runs in this process: its inputs ``moved``
    get the next of ``inputs``; ``strings`` are its parameters by name."""
    description = read_model_description(unpacked)
    variables = description.modelVariables
    slave = FMU2Slave(
        guid=description.guid,
        unzipDirectory=unpacked,
        instanceName="benchmark",
        modelIdentifier=description.coSimulation.modelIdentifier,
    )
    slave.instantiate()
    named = {v.name: v.valueReference for v in variables}
    slave.setString([named[name] for name in strings], list(strings.values()))
    slave.setupExperiment()
    slave.enterInitializationMode()
    slave.exitInitializationMode()
    references = [named[name] for name in moved]
    reals, integers = (
        [v.valueReference for v in variables if v.causality == "output" and v.type == kind]
        for kind in ("Real", "Integer")
    )

    def step():
        slave.setReal(references, next(inputs))
        slave.doStep(0.0, 1e-3)
        slave.getReal(reals)
        slave.getInteger(integers)

    return step


def hunting_inputs():
    """Inputs MOVED of a hunting wheelset, without end: poses that change at every step, flange to flange."""
    phase = np.linspace(0, 2 * np.pi, FMU_STEPS, endpoint=False)
    shift, yaw = 5e-3 * np.sin(phase), 5e-3 * np.cos(phase)
    force, transfer = 78.5e3 + 5e3 * np.sin(7 * phase), 0.1 * np.sin(3 * phase)
    return itertools.cycle(np.column_stack((shift, yaw, 0 * phase, force, transfer)).tolist())


def native_costs(folder):
    """Yield the version of FMI and a function that returns the :class:`Cost` of a step over the hunting run,
    for both native FMUs, which are built in ``folder``."""
    from wrcontact.fmu.native import build_native_fmus

    run = data.columns(data.HUNTING)
    inputs = {name: run.get(name, np.zeros(len(run["time"]))) for name in MOVED}
    for version, fmu in zip((2, 3), build_native_fmus(folder)):
        step = NativeStep(fmu, version, Path(folder, f"native{version}"), inputs)
        yield version, lambda step=step: step_cost(step)


def step_cost(step):
    """:class:`Cost` of a step of a native FMU, after a measurement of the unit."""
    one = unit()
    return Cost(1e-6 * step.microseconds(), one)
