"""What creep forces cost, a model alone, for one patch, and the whole element with it; and the tables of
creep forces.

    python -m benchmarks tangential_times

Steps of 1 ms of the trajectory that the speed is judged by (work.py), at SPEED and with the lateral velocity
and yaw rate that belong to it.  A model's own time is the difference of a step with and without it, over the
patches of a step; ANALYN, rigid.  The kernel's calls that cut a patch into strips and solve it are also timed
by themselves, over and over on some of the patches that are held out.
"""

import itertools
import tempfile
from pathlib import Path

import numpy as np
from fmpy import extract

import wrcontact
from data.creep_cases import Model
from wrcontact.creep import forces
from wrcontact.kernel import layout
from wrcontact.kernel.binding.library import default_kernel, span

from . import creep, fmus, work
from .creep import EQUIVALENT, MODELS, NEW_ELLIPSES, NEW_PATCHES, QUOTED, SETS, WITHOUT_MOMENT
from .machine import Cost, cost
from .tables import SOURCE, figure, grid

SPEED = 20.0        # [m/s]
WITHOUT, TIMED = "none", ("polach", "fastsim", "fastrip", "strips")
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
    calls = {(element, model): work.steps_of(ELEMENTS[element] | {"tangential_model": model}, inputs)
             for element in ELEMENTS for model in (WITHOUT, *TIMED)}
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
               for model in TIMED},
            **{element: {model: best[element, model].units for model in (WITHOUT, *TIMED)}
               for element in ELEMENTS},
            FMU: fmu_steps(inputs, effort),
            "by itself": {model: by_itself(model, effort.rounds) / unit for model in TIMED},
            "whole": {"patches": patches, "row": 8 * layout.OUTPUT_COUNT,
                      "wheelset": 8 * (layout.WORK_SIZE + layout.STATE_SIZE)}}


def moving(count, every=1):
    """Inputs (count, INPUT_COUNT) of the trajectory with velocities."""
    inputs = work.inputs(count, every)
    inputs[:, layout.IN_SPEED] = SPEED
    inputs[:, layout.IN_FREE_ROLLING] = 1.0
    inputs[:, [layout.IN_LEFT_FRICTION, layout.IN_RIGHT_FRICTION]] = 0.3
    for place, of in ((layout.IN_LATERAL_VELOCITY, layout.IN_LATERAL_SHIFT),
                      (layout.IN_YAW_RATE, layout.IN_YAW)):
        inputs[:, place] = np.gradient(inputs[:, of], every * work.STEP)
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
        unpacked = extract(fmus.built(folder), str(Path(folder, "unpacked")))
        steps = {model: fmus.Instance(unpacked, {"tangential_model": model}, tuple(MOVED)).step_over(
            itertools.cycle(rows)) for model in (WITHOUT, *TIMED)}
        for _ in range(effort.passes):
            for model, step in steps.items():
                found = cost(lambda step=step: [step() for _ in rows], len(rows), effort.rounds)
                best[model] = found.least(best.get(model))
    return {model: found.units for model, found in best.items()}


def by_itself(model, rounds):
    """Seconds of a patch that is cut into strips and solved, the mean over some cases."""
    some = [*creep.real_patches()[::EACH_PATCH], *creep.ellipses()[::EACH_ELLIPSE]]
    return float(np.mean([seconds_of(Model(model), case, rounds) for case in some]))


def seconds_of(model, case, rounds):
    """Seconds of one case; the arrays stay alive as long as the library works on them."""
    model.forces(case)      # which writes the patch
    patch, library = case.parts[0], default_kernel().library
    array = forces.model_tables(model.number, patch.youngs_modulus, patch.poisson_ratio)
    tables, workspace = span(array), span(model.workspace)

    def calls():
        for _ in range(CALLS):
            library.wrcontact_cut_patch(workspace)
            library.wrcontact_solve_creep_force(tables, workspace)

    return cost(calls, CALLS, rounds).seconds


# ----------------------------------------------------------------------------------------------------- tables


NOTE = ("Errors: mean / 95 of 100 / worst of |ΔF|/(μN) or |ΔM|/(μN √(ab)) [%] on patches and ellipses on "
        "which no constant of a model was chosen. Units: of one patch.")
PARTS = ("tangential_errors", "tangential_times")
#: What docs/models.md says of the models: description, and what to use it for.
WORDS = {
    "none": ("no friction", "normal contact alone"),
    "strips": ("coupled strips on the patch as it is, corrected by exact solutions of ellipses",
               "simulations"),
    "fastrip": ("strip theory joined with FASTSIM", "comparison with other programs"),
    "fastsim": ("Kalker's simplified theory", "comparison with other programs"),
    "polach": ("Polach's formula for one ellipse", "rough studies with little spin"),
    "halfspace": ("complete theory of steady rolling", "reference; Python only, 0.1 s a patch"),
}


def force_table(parts):
    """Errors of the force, model by model."""
    return error_table(parts, "force", [*MODELS, EQUIVALENT, *QUOTED])


def moment_table(parts):
    """Errors of the moment of the models that have one."""
    return error_table(parts, "moment", [*(name for name in MODELS if name not in WITHOUT_MOMENT),
                                         EQUIVALENT])


def error_table(parts, kind, names):
    found = parts["tangential_errors"]["rows"]
    return grid([f"{kind}: mean / 95 of 100 / worst [%]",
                 *(f"{label} ({found['cases'][label]})" for label in SETS)],
                [[f"{name} ({SOURCE.split(', other')[0]})" if name in QUOTED else name,
                  *(precise(found[name][label][kind]) if label in found[name] else "" for label in SETS)]
                 for name in names])


def precise(values):
    """Numbers as "0.12 / 3.4 / 5.6"."""
    return " / ".join(f"{value:.2f}" if value < 0.995 else figure(value) for value in values)


def time_table(parts):
    """Models alone, then the element with each of them."""
    found = parts["tangential_times"]["rows"]
    whole = found["whole"]
    models = (WITHOUT, *TIMED)
    rows = [["one patch", "", *(figure(found[model]["units"]) for model in TIMED)],
            ["one patch [µs]", "", *(figure(found[model]["µs"]) for model in TIMED)],
            ["one patch, by itself", "", *(figure(found["by itself"][model]) for model in TIMED)],
            *([f"wheelset, {element}", *(figure(found[element][model]) for model in models)]
              for element in (*ELEMENTS, FMU))]
    return (f"{grid(['units', *models], rows)}\n\nA step has {whole['patches']:.2f} patches in the mean. A "
            f"row of all outputs has {whole['row']:,.0f} bytes, the memory of a wheelset "
            f"{whole['wheelset'] / 1e3:,.0f} kB, whatever the model.")


def short_table(parts):
    """Errors on the cases that are held out, and what a patch costs."""
    errors, times = (parts[name]["rows"] for name in PARTS)
    rows = []
    for name, (model, _) in MODELS.items():
        kinds = ("force",) if name in WITHOUT_MOMENT else ("force", "moment")
        cells = [precise(errors[name][label][kind]) for kind in kinds
                 for label in (NEW_PATCHES, NEW_ELLIPSES)]
        rows.append([name, *cells, *[""] * (4 - len(cells)), figure(times["by itself"][model]),
                     figure(times[model]["units"])])
    return grid(["model", "force: patches", "ellipses", "moment: patches", "ellipses", "units by itself",
                 "in a step"], rows)


def model_table(parts):
    """The models as docs/models.md has them."""
    errors, times = (parts[name]["rows"] for name in PARTS)
    rows = []
    for name, (description, use) in WORDS.items():
        cells = ["", "", ""]
        if name in errors:
            cells = [*(precise(errors[name][label]["force"]) for label in (NEW_PATCHES, NEW_ELLIPSES)),
                     figure(times[name]["units"])]
        elif name == "halfspace":
            cells = ["0 by definition", "0 by definition", ""]
        default = " (default)" if name == WITHOUT else ""
        rows.append([f'`"{name}"`{default}', description, use, *cells])
    return grid(["`tangential_model`", "description", "use it for", "error on patches", "on ellipses",
                 "units"], rows, words=3)


def readme_row(parts):
    """The README's row of creep forces: time of a whole step with ANALYN, error on the patches that are held
    out."""
    errors, times = (parts[name]["rows"] for name in PARTS)
    mean, _, worst = errors["strips"][NEW_PATCHES]["force"]
    units = times[ALONE]["strips"]
    one = times["strips"]["µs"] / times["strips"]["units"]
    return [f"ANALYN and creep forces by strips, at {SPEED:g} m/s", figure(units * one), figure(units),
            f"creep force: {precise([mean])}", precise([worst])]
