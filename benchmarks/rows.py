"""The rows that are timed, each with its errors: models by tolerance, strips and sweeps, the ways to call
them.

A row is one wheelset: search, roll, and both wheels' patches.  Unless a row says otherwise, the poses follow
a trajectory without yaw and are evaluated by evaluate_many.
"""

from collections.abc import Callable
from dataclasses import dataclass

import data
from wrcontact.methods import Analyn, Strip

from . import errors
from .errors import FORCE, anywhere, system, trajectory
from .machine import cost

HALFSPACE = (0.1, 0.03, 0.01, 0.005)  # tolerances
STRIPS, SWEEPS = (16, 24, 32, 48, 64), (1, 2, 3)
EVERY = 10  # in a quick run the half-space solves each tenth row of the hunting run
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
QUICK = Effort(300, 3, 1, HALFSPACE[:2], EVERY)


@dataclass
class Row:
    """One line of the table: ``work()`` makes ``calls`` evaluations; ``kind`` is its group and marker in the
    picture."""

    name: str
    kind: str
    work: Callable
    calls: int
    system: object
    rounds: int
    every: int = 1
    setting: str = ""  # label in the picture

    def cost(self):
        """:class:`Cost` of one evaluation."""
        return cost(self.work, self.calls, self.rounds)

    def errors(self):
        """Errors by name, as they are kept: mean and worst of both runs in %, or those of the rigid
        contact."""
        if self.kind == "geometry":
            return errors.rigid(self.system)
        return errors.percentages(errors.positions(self.system), errors.hunting(self.system, self.every))


def all_rows(effort):
    """Every measured row, not yet measured."""
    return [*formulas(effort), *ladders(effort), *halfspace(effort), *strips(effort), *orders(effort),
            *doors(effort)]


def batch(system, poses, **options):
    """A call of evaluate_many."""
    shift, yaw = poses
    return lambda: system.evaluate_many(shift, yaw, FORCE, **options)


def formulas(effort):
    """Geometry alone; Hertz."""
    poses = trajectory(effort.count, yaw=0.0)
    yield Row("geometry and roll alone", "geometry", batch(system(), poses, outputs="geometry"), effort.count,
              system(), effort.rounds)
    hertz = system(normal_model="hertz")
    yield Row("Hertz", "Hertz", batch(hertz, poses), effort.count, hertz, effort.rounds)


def ladders(effort):
    """ANALYN and strips at each of their tolerances, and ANALYN with the other longitudinal
    curvature."""
    poses = trajectory(effort.count, yaw=0.0)
    for model in (Analyn, Strip):
        for tolerance, resolution in model.ladder.items():
            of = system(normal_model=model(tolerance=tolerance))
            yield Row(ladder_row(model, tolerance, resolution), model.name,
                      batch(of, poses), effort.count, of, effort.rounds, setting=f"{tolerance:g}")
    basic = system(longitudinal_curvature="basic")
    yield Row("analyn, longitudinal curvature basic", "analyn", batch(basic, poses), effort.count, basic,
              effort.rounds)


def halfspace(effort):
    """The half-space at each tolerance, timed on the 20 positions."""
    shift = data.columns(data.POSITIONS)["lateral_shift"]
    for tolerance in effort.halfspace:
        of = system(normal_model="halfspace", tolerance=tolerance)
        yield Row(HALFSPACE_FORM.format(tolerance), "halfspace", batch(of, (shift, 0.0 * shift)), len(shift),
                  of, 1, effort.every, setting=f"{tolerance:g}")


def strips(effort):
    """Number of strips and sweeps, nodes as at the default tolerance."""
    poses = trajectory(effort.count, yaw=0.0)
    for sweeps in SWEEPS:
        for strips in STRIPS:
            of = system(normal_model="analyn_strip", strips=strips, sweeps=sweeps)
            yield Row(f"analyn_strip, {strips} strips × {sweeps}", "strips", batch(of, poses), effort.count,
                      of, effort.rounds, setting=f"× {sweeps}")


def orders(effort):
    """Trajectory and random order of the poses, with and without yaw."""
    for of in (system(), system(normal_model="analyn_strip")):
        model = of.parameters["normal_model"]
        for name, poses in (("trajectory with yaw", trajectory(effort.count)),
                            ("random poses", anywhere(effort.count, yaw=0.0)),
                            ("random poses with yaw", anywhere(effort.count))):
            yield Row(f"{model}, {name}", "order", batch(of, poses), effort.count, of, effort.rounds)


def doors(effort):
    """Ways to call: ``evaluate()`` and the stepper; :func:`fmu_row` has the FMU."""
    shift, yaw = trajectory(effort.count)
    poses = list(zip(shift.tolist(), yaw.tolist()))
    stepper = system().stepper()

    def step():
        for stepper.inputs[0], stepper.inputs[1] in poses:
            stepper.step()

    stepper.inputs[3] = FORCE
    yield Row("analyn, trajectory with yaw, `evaluate()` from Python", "door",
              lambda: [system().evaluate(shift, yaw) for shift, yaw in poses], effort.count, system(),
              effort.rounds)
    yield Row("analyn, trajectory with yaw, stepper from Python", "door", step, effort.count, system(),
              effort.rounds)


class NativeRow(Row):
    """A native FMU's step, which its C host measures."""

    def cost(self):
        return self.work()


def hosted(folder, effort):
    """Rows of the steps of all three FMUs, which are built in ``folder``."""
    from . import fmus

    yield Row(FMU_ROW, "FMU", fmus.steps(folder), fmus.STEPS, system(), effort.rounds)
    for version, measure in fmus.measures(folder):
        yield NativeRow(NATIVE_ROW.format(version), "native", measure, 0, system(), 0)
