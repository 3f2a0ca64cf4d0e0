"""What creep forces cost: a model alone, for one patch, and the whole element with it.

    python -m benchmarks tangential_times

Steps of 1 ms of the trajectory that the speed is judged by (benchmarks/trajectory.py), at SPEED and with the
lateral velocity and yaw rate that belong to it.  A model's own time is the difference of a step with and
without it, over the patches of a step; ANALYN, rigid.  Besides it, the kernel's calls that cut a patch into
strips and solve it are timed by themselves, over and over on some of the patches that are held out.
"""

import itertools
import tempfile
from pathlib import Path

import numpy as np
from fmpy import extract

import wrcontact
from tests.helpers.creep_cases import Model
from wrcontact.creep import forces
from wrcontact.kernel import layout
from wrcontact.kernel.binding.library import default_kernel, span

from . import fmu_step, held_out, trajectory
from .machine import Cost, cost

SPEED = 20.0        # [m/s]
WITHOUT, MODELS = "none", ("polach", "fastsim", "fastrip", "strips")
ELEMENTS = {"ANALYN, rigid": {}, "ANALYN with strips, rigid": {"normal_model": "analyn_strip"},
            "ANALYN, elastic": {"contact_mode": "elastic"},
            "ANALYN with strips, elastic": {"normal_model": "analyn_strip", "contact_mode": "elastic"}}
ALONE = "ANALYN, rigid"
FMU = "ANALYN, rigid, FMU step through fmpy"
#: Inputs of the FMU's steps, and their places among the kernel's.
MOVED = {"lateral_shift": layout.IN_LATERAL_SHIFT, "yaw": layout.IN_YAW,
         "normal_force": layout.IN_NORMAL_FORCE, "speed": layout.IN_SPEED,
         "lateral_velocity": layout.IN_LATERAL_VELOCITY, "yaw_rate": layout.IN_YAW_RATE}
#: Steps that are timed: one run from flange to flange and back.
STEPS = 900
#: The same patch so many times, and which of the patches and ellipses that are held out.
CALLS, EACH_PATCH, EACH_ELLIPSE = 1000, 8, 20
#: Runs in a round of the element without elastic contact, whose steps are quick.
REPEATS = {"rigid": 3, "elastic": 1}


def measured(effort):
    """Rows by model: units and microseconds of a patch; and of a step of each of ELEMENTS, with the number of
    patches of a step and the bytes of a row of outputs and of a wheelset's memory."""
    count = min(STEPS, effort.count // 3)
    inputs = moving(count, STEPS // count)
    calls = {(element, model): trajectory.steps_of(ELEMENTS[element] | {"tangential_model": model}, inputs)
             for element in ELEMENTS for model in (WITHOUT, *MODELS)}
    best = {}
    for _ in range(effort.passes):
        for key, (call, _) in calls.items():
            repeats = REPEATS[key[0].split(", ")[1]]
            found = cost(lambda call=call, repeats=repeats: [call() for _ in range(repeats)],
                         repeats * count, effort.rounds)
            best[key] = found.least(best.get(key))
    patches, unit = patches_of(inputs), min(found.unit for found in best.values())
    best = {key: Cost(found.seconds, unit) for key, found in best.items()}      # differences need one unit
    without = best[ALONE, WITHOUT].seconds
    return {**{model: alone(Cost((best[ALONE, model].seconds - without) / patches, unit))
               for model in MODELS},
            **{element: {model: best[element, model].units for model in (WITHOUT, *MODELS)}
               for element in ELEMENTS},
            FMU: fmu_steps(inputs, effort),
            "by itself": {model: by_itself(model, effort.rounds) / unit for model in MODELS},
            "whole": {"patches": patches, "row": 8 * layout.OUTPUT_COUNT,
                      "wheelset": 8 * (layout.WORK_SIZE + layout.STATE_SIZE)}}


def moving(count, every=1):
    """Inputs (count, INPUT_COUNT) of the trajectory with velocities."""
    inputs = trajectory.inputs(count, every)
    inputs[:, layout.IN_SPEED] = SPEED
    inputs[:, layout.IN_FREE_ROLLING] = 1.0
    inputs[:, [layout.IN_LEFT_FRICTION, layout.IN_RIGHT_FRICTION]] = 0.3
    for place, of in ((layout.IN_LATERAL_VELOCITY, layout.IN_LATERAL_SHIFT),
                      (layout.IN_YAW_RATE, layout.IN_YAW)):
        inputs[:, place] = np.gradient(inputs[:, of], every * trajectory.STEP)
    return inputs


def alone(found):
    """A :class:`~benchmarks.machine.Cost` as it is kept."""
    return {"units": found.units, "µs": found.microseconds}


def patches_of(inputs):
    """Mean number of patches of a step, both wheels."""
    shift, yaw, force = inputs[:, [layout.IN_LATERAL_SHIFT, layout.IN_YAW, layout.IN_NORMAL_FORCE]].T
    table = wrcontact.ContactSystem(**ELEMENTS[ALONE]).evaluate_many(
        shift, yaw, force, outputs=["left.patch_count", "right.patch_count"])
    return float(np.mean(table.left.patch_count + table.right.patch_count))


def fmu_steps(inputs, effort):
    """Units of a step of the Python FMU by model: MOVED in, all outputs out."""
    rows = list(map(tuple, inputs[:, list(MOVED.values())].tolist()))
    best = {}
    with tempfile.TemporaryDirectory() as folder:
        unpacked = extract(fmu_step.built(folder), str(Path(folder, "unpacked")))
        steps = {model: fmu_step.Instance(unpacked, {"tangential_model": model}, tuple(MOVED)).step_over(
            itertools.cycle(rows)) for model in (WITHOUT, *MODELS)}
        for _ in range(effort.passes):
            for model, step in steps.items():
                found = cost(lambda step=step: [step() for _ in rows], len(rows), effort.rounds)
                best[model] = found.least(best.get(model))
    return {model: found.units for model, found in best.items()}


def by_itself(model, rounds):
    """Seconds of a patch that is cut into strips and solved, the mean over some cases."""
    some = [*held_out.real_patches()[::EACH_PATCH], *held_out.ellipses()[::EACH_ELLIPSE]]
    return float(np.mean([seconds_of(Model(model), case, rounds) for case in some]))


def seconds_of(model, case, rounds):
    """Seconds of one case; the arrays stay alive as long as the library works on them."""
    model.forces(case)      # which writes the patch
    patch, library = case.parts[0], default_kernel().library
    array = forces.model_tables(model.number, patch.youngs_modulus, patch.poisson_ratio)
    tables, workspace = span(array), span(model.workspace)

    def work():
        for _ in range(CALLS):
            library.wrcontact_cut_patch(workspace, 0)
            library.wrcontact_solve_tangential(tables, workspace)

    return cost(work, CALLS, rounds).seconds
