"""The work of the costliest steps beside that of a usual one, for real time: evaluations of the profiles in a
step, counted by the kernel (gap evaluations of the searches and nodes of the patches), over random poses and
over the hunting run.  Counts are the same in every run and on every machine.

    python -m benchmarks worst_steps
"""

import numpy as np

import wrcontact
from wrcontact.kernel import layout

from .errors import MODELS
from .times import CONTACT_MODES, motion

SEED = 11
#: Random poses: lateral shift [m], yaw [rad] of every other one, and force [N].
SHIFT, YAW, FORCE = 6.6e-3, np.radians(2), (3e3, 200e3)
SPRINGS = {"rail_lateral_stiffness": 2e7, "rail_vertical_stiffness": 5e7}
SHARES = {"median": 0.5, "99.9 of 100": 0.999, "worst": 1.0}


def random_rows(count):
    """Lateral shift, yaw and force (count, 3) of random poses."""
    random = np.random.default_rng(SEED)
    rows = random.uniform((-SHIFT, -YAW, np.log(FORCE[0])), (SHIFT, YAW, np.log(FORCE[1])), (count, 3))
    rows[::2, 1] = 0.0
    rows[:, 2] = np.exp(rows[:, 2])
    return rounded(rows)


def rounded(rows):
    """Without the last bits, which sine and exponential have from the processor."""
    return np.round(rows, 9)


def inputs_of_rows(rows, options):
    """Inputs by name, (n,) each: in compliant contact height and roll of the elastic wheelset with ANALYN, on
    springs by their deflection lower."""
    names = dict(zip(("lateral_shift", "yaw", "normal_force"), rows.T))
    if options.get("contact_mode") == "compliant":
        stands = wrcontact.ContactSystem(contact_mode="elastic").evaluate_many(**names)
        sunk = (
            rows[:, 2] / options["rail_vertical_stiffness"] if "rail_vertical_stiffness" in options else 0.0
        )
        names |= {"vertical_shift_input": stands.vertical_shift + sunk, "roll_input": stands.roll}
    return names


def evaluations(rows, **options):
    """Evaluations of the profiles in each step (n,)."""
    stepper = wrcontact.ContactSystem(**options).stepper()
    names = inputs_of_rows(rows, options)
    places = [stepper.place(name) for name in names]
    sides = layout.Work.at(stepper._workspace).sides
    counted = [0.0]
    for row in np.column_stack(list(names.values())):
        stepper.inputs[places] = row
        stepper.step()
        counted.append(sum(side.place.gap_count + side.place.node_count for side in sides))
    return np.diff(counted)


def systems():
    """Options by name."""
    for mode in CONTACT_MODES:
        for model in MODELS:
            yield f"{model}, {mode}", {"contact_mode": mode, "normal_model": model}
    for model in MODELS:
        options = {"contact_mode": "compliant", "normal_model": model, **SPRINGS}
        yield f"{model}, compliant, rails on springs", options


def worst_steps(count, only=None):
    """Rows by system, or by those of ``only`` these names: the SHARES of the evaluations over ``count`` random poses and, of the same number of
    steps, the hunting run; and the worst of both over the median of the random poses."""
    found = {}
    for name, options in systems():
        if only is not None and name not in only:
            continue
        counts = [
            evaluations(rows, **options)
            for rows in (random_rows(count), rounded(np.transpose(motion(count))))
        ]
        row = {
            f"{where}{share}": np.quantile(values, at)
            for where, values in zip(("", "hunting: "), counts)
            for share, at in SHARES.items()
        }
        most = max(values.max() for values in counts)
        found[name] = {**row, "worst over median": most / row["median"]}
    return found
