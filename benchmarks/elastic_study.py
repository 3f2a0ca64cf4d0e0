"""What elastic equilibrium costs and how it moves: time and trials of a step, the largest step of the roll,
and published rolls (docs/method.md, section 11).

A step is one of a sine of 5 mm and 0.3 deg; trials are those of random poses and include the rigid search's.
"""

import csv
import itertools
import math

import numpy as np

from wrcontact.kernel import layout
from wrcontact.progress import tracked

from . import runs
from .machine import cost
from .rows import system

FORCE = 78.5e3   # per wheel [N]
STEPS, POSES = 1000, 500
MODELS, MODES = ("hertz", "analyn", "analyn_strip"), ("rigid", "compliant", "elastic")
NEAR = 6.5  # [mm] flange contact begins
COLUMNS = ("lateral_shift_mm", "yaw_rad", "roll_rad", "normal_force_left_N", "normal_force_right_N")


def sine():
    """Lateral shift [m] and yaw [rad] of a hunting wheelset (STEPS,)."""
    phase = np.linspace(0.0, 2 * math.pi, STEPS)
    return 5e-3 * np.sin(phase), 5e-3 * np.cos(phase)


def times(effort):
    """By model and contact mode: :class:`~benchmarks.machine.Cost` of a step of the sine; the compliant
    form's at the elastic positions."""
    shift, yaw = sine()
    stand = system(contact_mode="elastic").evaluate_many(shift, yaw, FORCE)
    given = dict(vertical_shift_input=stand.vertical_shift, roll_input=stand.roll)
    best = {}
    for _ in range(effort.passes):
        for case in itertools.product(MODELS, MODES):
            pair = system(normal_model=case[0], contact_mode=case[1])
            found = cost(lambda: pair.evaluate_many(shift, yaw, FORCE, **given), STEPS, effort.rounds)
            best[case] = found.least(best.get(case))
    return {model: {mode: best[model, mode] for mode in MODES} for model in MODELS}


def trials(model, load):
    """Trials of each of POSES random poses, up to 8 mm and 0.03 rad, 1 ... 150 kN."""
    rng = np.random.default_rng(4)
    stepper = system(contact_mode="elastic", normal_model=model, load=load).stepper()
    found = []
    for shift, yaw, force in rng.uniform((-8e-3, -0.03, 1e3), (8e-3, 0.03, 150e3), (POSES, 3)):
        stepper.inputs[[0, 1, 3]] = shift, yaw, force
        before = stepper.state[layout.STATE_ROLL_COUNT]
        stepper.step()
        found.append(stepper.state[layout.STATE_ROLL_COUNT] - before)
    return np.array(found)


def largest_roll_step(yaw, step=1e-6):
    """Largest step of the roll [rad] from -8 to 8 mm, and how far from the middle [mm]: at both signs of the
    shift it is the same but for rounding."""
    shift = np.arange(-8e-3, 8e-3, step)
    table = system(contact_mode="elastic").evaluate_many(shift, yaw, FORCE)
    steps = np.abs(np.diff(table.roll))
    return steps.max(), 1e3 * abs(shift[np.argmax(steps)] + 0.5 * step)


def all_trials():
    """By model and load: mean, 99 % and largest number of trials."""
    rows = {}
    for model in MODELS:
        for load in ("normal", "vertical"):
            count = trials(model, load)
            rows[f"{model}, load {load}"] = {"mean": count.mean(), "99 %": np.percentile(count, 99),
                                             "most": count.max()}
    return rows


def roll_steps(quick=False):
    """By yaw: largest change of the roll [µrad] in 1 µm of lateral shift, and where [mm]."""
    rows = {}
    for degrees in tracked((0, 1, 2), "rolls of the elastic wheelset"):
        largest, shift = largest_roll_step(math.radians(degrees), 1e-4 if quick else 1e-6)
        rows[f"{degrees}°"] = {"step": 1e6 * largest, "at": shift}
    return rows


def manchester():
    """Largest difference from the rolls of the Manchester contact benchmark, case A-2.2 [µrad], elastic and
    rigid, up to NEAR [mm] and beyond."""
    with open(runs.MANCHESTER, newline="", encoding="utf-8") as file:
        shift, yaw, roll, left, right = np.array([[float(row[name]) for name in COLUMNS]
                                                  for row in csv.DictReader(file)]).T
    rows = {}
    for mode in ("elastic", "rigid"):
        table = system(contact_mode=mode).evaluate_many(1e-3 * shift, yaw, (left + right) / 2,
                                                        (right - left) / (left + right))
        off = 1e6 * np.abs(table.roll - roll)
        rows[mode] = {"near": off[shift <= NEAR].max(), "beyond": off[shift > NEAR].max()}
    return rows
