"""Errors of the models of creep forces against the complete theory of steady rolling, patch by patch
(docs/theory/rolling.md), quoted errors of CONTACT's fast methods, and what the models cost.

    python -m benchmarks tangential_errors tangential_times
    python -m benchmarks.creep       writes data/creep/held_out.json, about two minutes

An error is the length of the difference of the force vectors over mu N, or that of the moments over
mu N sqrt(ab).  Cases that are held out are those that nobody has chosen a constant on: random ellipses and
random patches of a wheelset, solved by the complete theory (wrcontact/halfspace/rolling).

Ellipses: a/b 0.1 ... 20, sqrt(ab) 1 ... 10 mm, 3 ... 200 kN, both log-uniform, Poisson's ratio 0.25 ... 0.3.
Patches: those of the strips of random poses (random_poses.py, from number FIRST on, which no other table
uses), each of which carries at least a tenth of its wheel's load.  Creepages: random directions in the units
in which the linear theory uses up the friction, 0.2 ... 8 of them, log-uniform; friction 0.1 ... 0.6.
"""

import itertools
import json
import math
import tempfile

import numpy as np

import wrcontact
from data.creep_cases import CREEP, MM, Case, Model, cases, read, summary
from tools.tables.exact_nodes import creep_coefficients
from wrcontact.creep import elliptic_patch, outlined_patch
from wrcontact.creep.forces import model_tables
from wrcontact.halfspace.rolling import Outline, outline_of_patch, roll_ellipse, roll_outline
from wrcontact.kernel import layout
from wrcontact.kernel.binding.library import default_kernel, span
from wrcontact.progress import tracked

from . import random_poses, times
from .record import Cost, cost, costs, short
from .rows import fmu_step, python_fmu

STORED = CREEP / "held_out.json"
SEED, FIRST = 2112, 700_000
ELLIPSES, PATCHES = 100, 60
RATIO, SIZE, FORCE = (0.1, 20.0), (1e-3, 10e-3), (3e3, 200e3)  # a/b, sqrt(ab) [m], load [N]
SATURATION, FRICTION, POISSON = (0.2, 8.0), (0.1, 0.6), (0.25, 0.3)
MODULUS, STEEL = 210e9, 0.28  # Young's modulus [Pa] and Poisson's ratio of the patches
LEAST_SHARE = 0.1  # of a wheel's load that a patch carries
DIGITS = 7


# --------------------------------------------------------------------------------------------- how it is made


def make():
    """Solve all cases and write them."""
    random = np.random.default_rng(SEED)
    found = {
        "meta": {
            "unit": "mm, N, MPa, 1/mm; slip of the wheel, force on the wheel",
            "youngs_modulus": MODULUS / 1e6,
            "seed": SEED,
            "first_pose": FIRST,
        },
        "ellipses": [solved_ellipse(random) for _ in tracked(range(ELLIPSES), "ellipses")],
        "patches": [solved_patch(random, *each) for each in tracked(list(patches()), "patches")],
    }
    lines = [
        f"{json.dumps(name)}: "
        + (json.dumps(rows) if name == "meta" else "[\n" + ",\n".join(map(json.dumps, rows)) + "\n]")
        for name, rows in found.items()
    ]
    STORED.write_text("{" + ",\n".join(lines) + "}\n", encoding="utf-8")


def solved_ellipse(random):
    """The next ellipse and its forces."""
    ratio, size, load = (log_uniform(random, limits) for limits in (RATIO, SIZE, FORCE))
    poisson_ratio = random.uniform(*POISSON)
    a, b = size * math.sqrt(ratio), size / math.sqrt(ratio)
    motion = random_motion(random, (a, b), load, poisson_ratio)
    return short(
        {
            "a": a / MM,
            "b": b / MM,
            "N": load,
            "nu": poisson_ratio,
            **kept(motion),
            "force": forces(roll_ellipse(a, b, load, **motion)),
        },
        DIGITS,
    )


def solved_patch(random, name, outline):
    """Forces of a patch, and those of the ellipse with its area and its ratio of length to width."""
    a, b = equivalent_axes(outline)
    load = outline.on_grid(48, 48).normal_force
    motion = random_motion(random, (a, b), load, STEEL)
    slant = np.polyfit(outline.station[1:-1], outline.middle[1:-1], 1)[0]
    straight = Outline.of_stations(
        outline.station, outline.half_length, outline.pressure, slant * outline.station
    )
    return short(
        {
            "name": name,
            "a": a / MM,
            "b": b / MM,
            "N": load,
            "nu": STEEL,
            **kept(motion),
            "force": forces(roll_outline(straight, **motion)),
            "ellipse": forces(roll_ellipse(a, b, load, **motion)),
            "slant": slant,
            "y": outline.station / MM,
            "half_length": outline.half_length / MM,
            "pressure": outline.pressure / 1e6,
        },
        DIGITS,
    )


def patches():
    """Yield name and outline of the first PATCHES patches of the random poses, both wheels in turn."""
    count = 0
    for index in range(FIRST, FIRST + PATCHES):
        pose = random_poses.pose(index)
        system = random_poses.system(pose.rail, pose.inclination, normal_model="analyn_strip")
        stepper = system.stepper(side=random_poses.SIDES[index % 2])
        stepper.inputs[[layout.IN_LATERAL_SHIFT, layout.IN_YAW, layout.IN_NORMAL_FORCE]] = pose[2:]
        if stepper.step():
            raise ArithmeticError(f"pose {index} is not solved: {pose}")
        work = layout.Work.at(stepper._workspace)
        side = work.sides[index % 2]  # the strips are those of the wheel that is wanted
        for patch in side.patches[: side.patch_count]:
            if patch.totals.load > LEAST_SHARE * pose.normal_force and count < PATCHES:
                count += 1
                yield (
                    f"{random_poses.SIDES[index % 2]} wheel, {pose}",
                    outline_of_patch(work.contact.strips, patch),
                )


def equivalent_axes(outline):
    """Half-axes [m] of the ellipse with the patch's area and its ratio of length to width."""
    field = outline.on_grid(48, 48)
    ratio = 2.0 * outline.half_length.max() / np.ptp(outline.station)
    size = math.sqrt(field.cover.sum() * field.cell_area / math.pi)
    return size * math.sqrt(ratio), size / math.sqrt(ratio)


def random_motion(random, axes, load, poisson_ratio):
    """Creepages and material as the solver reads them."""
    shear_modulus = MODULUS / (2.0 * (1.0 + poisson_ratio))
    direction = random.normal(size=3)
    saturation = log_uniform(random, SATURATION) * direction / np.linalg.norm(direction)
    friction, (a, b) = random.uniform(*FRICTION), axes
    saturation[2] /= math.sqrt(1.0 + 0.66 * (a / b) ** -2.7)  # short patches need much spin
    unit = friction * load / (a * b * shear_modulus) / creep_coefficients(a, b, poisson_ratio)
    xi, eta, phi = -saturation * unit / (1.0, 1.0, math.sqrt(a * b))
    return {
        "creepage_x": xi,
        "creepage_y": eta,
        "spin": phi,
        "friction": friction,
        "shear_modulus": shear_modulus,
        "poisson_ratio": poisson_ratio,
    }


def log_uniform(random, limits):
    return math.exp(random.uniform(*np.log(limits)))


def kept(motion):
    """What the file has of a motion."""
    return {
        "xi": motion["creepage_x"],
        "eta": motion["creepage_y"],
        "phi": motion["spin"] * MM,
        "mu": motion["friction"],
    }


def forces(found):
    """Force x, y [N] and moment [N mm] (3,)."""
    return [found.force_x, found.force_y, found.moment / MM]


# ----------------------------------------------------------------------------------------- what is made of it


def stored():
    return json.loads(STORED.read_text(encoding="utf-8"))


def case(row, patch):
    """A row of the file as a case."""
    a, b, (x, y, moment) = row["a"] * MM, row["b"] * MM, row["force"]
    creepages = row["xi"], row["eta"], row["phi"] / MM
    return Case(
        row.get("name", f"ellipse a/b {a / b:.3g}"),
        (patch,),
        creepages,
        row["mu"],
        (x, y),
        moment * MM,
        row["mu"] * row["N"],
        math.sqrt(a * b),
    )


def ellipses():
    """The ellipses as :class:`~data.creep_cases.Case`."""
    return [
        case(row, elliptic_patch(row["a"] * MM, row["b"] * MM, row["N"], MODULUS, row["nu"]))
        for row in stored()["ellipses"]
    ]


def real_patches():
    """The patches of the wheelset, likewise."""
    return [
        case(
            row,
            outlined_patch(
                np.array(row["y"]) * MM,
                np.array(row["half_length"]) * MM,
                np.array(row["pressure"]) * 1e6,
                slant=row["slant"],
                normal_force=row["N"],
                youngs_modulus=MODULUS,
                poisson_ratio=row["nu"],
            ),
        )
        for row in stored()["patches"]
    ]


def equivalent_ellipses():
    """Force and moment (n, 3) of the complete theory on the ellipses that stand for the patches."""
    return np.array([row["ellipse"] for row in stored()["patches"]]) * (1.0, 1.0, MM)


# --------------------------------------------------------------------------------------- errors of the models


#: Name of the row: the model, and whether spin is as published.
MODELS = {
    "polach": ("polach", False),
    "fastsim, published_spin=1": ("fastsim", True),
    "fastsim": ("fastsim", False),
    "fastrip, published_spin=1": ("fastrip", True),
    "fastrip": ("fastrip", False),
    "strips": ("strips", False),
}
WITHOUT_MOMENT = ("polach",)
#: Name of the set in the tables: its cases.
SETS = {
    "CONTACT's ellipses": lambda: cases("hertz"),
    "ellipses, a/b 0.2 … 4": lambda: cases("ellipses"),
    "longer and shorter ellipses": lambda: cases("long_and_short"),
    "patches of a wheelset": lambda: cases("patches"),
    "CONTACT's patches": lambda: cases("contact_patches"),
    "held out: ellipses": ellipses,
    "held out: patches": real_patches,
}
HERTZ, GRIDS, NEW_ELLIPSES, NEW_PATCHES = (list(SETS)[k] for k in (0, 4, 5, 6))
EQUIVALENT = "complete theory on the equivalent ellipse"
#: CONTACT's own fast methods, as in the files.
QUOTED = {
    "CONTACT's FASTSIM": "fastsim",
    "CONTACT's FaStrip": "fastrip",
    "CONTACT's Kik-Piotrowski with FASTSIM": "kpec_fastsim",
    "CONTACT's ANALYN with FASTSIM": "analyn_fastsim",
}


def errors():
    """Rows by model: in each set [mean, 95 %, worst] of the errors of force and of moment [%]; the number of
    cases of each set."""
    sets = {name: tuple(chosen()) for name, chosen in SETS.items()}
    rows = {"cases": {name: len(chosen) for name, chosen in sets.items()}}
    for name, (model, published) in MODELS.items():
        solver = Model(model, published)
        rows[name] = {
            label: compared([solver.forces(case) for case in chosen], chosen)
            for label, chosen in sets.items()
        }
    rows[EQUIVALENT] = {NEW_PATCHES: compared(equivalent_ellipses(), sets[NEW_PATCHES])}
    return rows | quoted()


def compared(found, chosen):
    """Summaries of the errors [%] of forces and moments (n, 3); cases without a known moment do not count."""
    truth = np.array([[*case.force, case.moment] for case in chosen])
    bound, size = np.array([(case.bound, case.size) for case in chosen]).T
    apart = np.array(found) - truth
    force = 100.0 * np.hypot(apart[:, 0], apart[:, 1]) / bound
    moment = 100.0 * np.abs(apart[:, 2]) / (bound * size)
    return {"force": summary(force), "moment": summary(moment[np.isfinite(moment)])}


def quoted():
    """Rows of CONTACT's own fast methods, on its own cases; ANALYN's and Kik-Piotrowski's are those of
    their own approximate patches."""
    ellipses = [
        {name: (row[name]["fx"], row[name]["fy"]) for name in ("contact", *QUOTED.values()) if name in row}
        for row in read("hertz")["cases"]
    ]
    file = json.loads((CREEP / "contact_fast_methods.json").read_text(encoding="utf-8"))
    patches = [row for patch in file["patches"] for row in patch["cases"]]
    found = {}
    for label, name in QUOTED.items():
        here = {each: rows for each, rows in ((HERTZ, ellipses), (GRIDS, patches)) if name in rows[0]}
        found[label] = {
            each: {
                "force": summary([100.0 * np.hypot(*np.subtract(row[name], row["contact"])) for row in rows])
            }
            for each, rows in here.items()
        }
    return found


# ------------------------------------------------------------------------------------------------------ times


# What a model costs alone, for one patch, and the whole element with it: steps of 1 ms of the trajectory that
# the speed is judged by (times.py), at SPEED and with the lateral velocity and yaw rate that belong to it.  A
# model's own time is the difference of a step with and without it, over the patches of a step; ANALYN, rigid.
# The kernel's calls that cut a patch into strips and solve it are also timed by themselves, over and over on
# some of the patches that are held out.

SPEED = 20.0  # [m/s]
WITHOUT, TIMED = "none", ("polach", "fastsim", "fastrip", "strips")
ELEMENTS = {
    "ANALYN, rigid": {},
    "ANALYN with strips, rigid": {"normal_model": "analyn_strip"},
    "ANALYN, elastic": {"contact_mode": "elastic"},
    "ANALYN with strips, elastic": {"normal_model": "analyn_strip", "contact_mode": "elastic"},
}
ALONE = "ANALYN, rigid"
FMU = "ANALYN, rigid, FMU step through fmpy"
#: Inputs of the FMU's steps, and their places among the kernel's.
MOVED = {
    "lateral_shift": layout.IN_LATERAL_SHIFT,
    "yaw": layout.IN_YAW,
    "normal_force": layout.IN_NORMAL_FORCE,
    "speed": layout.IN_SPEED,
    "lateral_velocity": layout.IN_LATERAL_VELOCITY,
    "yaw_rate": layout.IN_YAW_RATE,
}
#: Steps that are timed: one run from flange to flange and back.
TIMED_STEPS = 900
#: The same patch so many times, and which of the patches and ellipses that are held out.
CALLS, EACH_PATCH, EACH_ELLIPSE = 1000, 8, 20
#: Runs in a round of the element without elastic contact, whose steps are quick.
REPEATS = {"rigid": 3, "elastic": 1}


def tangential_times(effort):
    """Rows by model: units and microseconds of a patch; and of a step of each of ELEMENTS, with the number of
    patches of a step and the bytes of a row of outputs and of a wheelset's memory."""
    count = min(TIMED_STEPS, effort.count // 3)
    inputs = moving(count, TIMED_STEPS // count)
    found = costs(
        {
            (element, model): repeated(element, model, inputs)
            for element in ELEMENTS
            for model in (WITHOUT, *TIMED)
        },
        effort,
    )
    patches, unit = patches_of(inputs), min(each.unit for each in found.values())
    best = {key: Cost(each.seconds, unit) for key, each in found.items()}  # differences need one unit
    without = best[ALONE, WITHOUT].seconds
    return {
        **{model: Cost((best[ALONE, model].seconds - without) / patches, unit).kept() for model in TIMED},
        **{
            element: {model: best[element, model].units for model in (WITHOUT, *TIMED)}
            for element in ELEMENTS
        },
        FMU: fmu_steps(inputs, effort),
        "by itself": {model: by_itself(model, effort.rounds) / unit for model in TIMED},
        "whole": {
            "patches": patches,
            "row": 8 * layout.OUTPUT_COUNT,
            "wheelset": 8 * (layout.WORK_SIZE + layout.STATE_SIZE),
        },
    }


def repeated(element, model, inputs):
    """A call that makes REPEATS runs of the steps, and the number of steps that it makes."""
    call, *_ = times.steps_of(ELEMENTS[element] | {"tangential_model": model}, inputs)
    repeats = REPEATS[element.split(", ")[1]]
    return (lambda: [call() for _ in range(repeats)]), repeats * len(inputs)


def moving(count, every=1):
    """Inputs (count, INPUT_COUNT) of the trajectory with velocities."""
    inputs = times.inputs(count, every)
    inputs[:, layout.IN_SPEED] = SPEED
    inputs[:, layout.IN_FREE_ROLLING] = 1.0
    inputs[:, [layout.IN_LEFT_FRICTION, layout.IN_RIGHT_FRICTION]] = 0.3
    for place, of in (
        (layout.IN_LATERAL_VELOCITY, layout.IN_LATERAL_SHIFT),
        (layout.IN_YAW_RATE, layout.IN_YAW),
    ):
        inputs[:, place] = np.gradient(inputs[:, of], every * times.STEP)
    return inputs


def patches_of(inputs):
    """Mean number of patches of a step, both wheels."""
    shift, yaw, force = inputs[:, [layout.IN_LATERAL_SHIFT, layout.IN_YAW, layout.IN_NORMAL_FORCE]].T
    table = wrcontact.ContactSystem(**ELEMENTS[ALONE]).evaluate_many(
        shift, yaw, force, outputs=["left.patch_count", "right.patch_count"]
    )
    return float(np.mean(table.left.patch_count + table.right.patch_count))


def fmu_steps(inputs, effort):
    """Units of a step of the Python FMU by model: MOVED in, all outputs out."""
    rows = inputs[:, list(MOVED.values())].tolist()

    def run(step):
        return (lambda: [step() for _ in rows]), len(rows)

    with tempfile.TemporaryDirectory() as folder:
        unpacked = python_fmu(folder)
        found = costs(
            {
                model: run(fmu_step(unpacked, itertools.cycle(rows), MOVED, tangential_model=model))
                for model in (WITHOUT, *TIMED)
            },
            effort,
        )
    return {model: each.units for model, each in found.items()}


def by_itself(model, rounds):
    """Seconds of a patch that is cut into strips and solved, the mean over some cases."""
    some = [*real_patches()[::EACH_PATCH], *ellipses()[::EACH_ELLIPSE]]
    return float(np.mean([seconds_of(Model(model), case, rounds) for case in some]))


def seconds_of(model, case, rounds):
    """Seconds of one case; the arrays stay alive as long as the library works on them."""
    model.forces(case)  # which writes the patch
    patch, library = case.parts[0], default_kernel().library
    array = model_tables(model.number, patch.youngs_modulus, patch.poisson_ratio)
    tables, workspace = span(array), span(model.workspace)

    def calls():
        for _ in range(CALLS):
            library.wrcontact_divide_into_strips(workspace)
            library.wrcontact_solve_creep_force(tables, workspace)

    return cost(calls, CALLS, rounds).seconds


if __name__ == "__main__":
    make()
