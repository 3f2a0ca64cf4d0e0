"""Run time and error of the wheelset, side by side, as a Markdown table.

    python -m benchmarks [--quick]

The unit is ``np.sqrt`` of 2000 doubles, timed in turn with each row, so that figures of two machines compare; a row is
the smallest of several rounds, since noise only adds.  A row is one wheelset: search, roll and both wheels' patches.
Errors are against tests/trajectories/hunting.csv: rigid positions by brute force, patches by a half-space solver
(complete theory) on the true three-dimensional gap.
"""

import csv
import sys
import tempfile
import timeit
from pathlib import Path

import numpy as np

import wrcontact

from . import fmu_step

RUN = Path(__file__).parents[1] / "tests" / "trajectories" / "hunting.csv"
PATCH = ("penetration", "area", "max_pressure")


def main(quick=False):
    rounds, count = (3, 500) if quick else (15, 2000)
    analyn, hertz = wrcontact.ContactSystem(), wrcontact.ContactSystem(normal_model="hertz")
    turn, random = np.linspace(0.0, 12.0, count), np.random.default_rng(0)
    trajectory, anywhere = 6.6e-3 * np.sin(turn), random.uniform(-6.6e-3, 6.6e-3, count)
    swing, any_yaw = 0.02 * np.cos(turn), random.uniform(-0.03, 0.03, count)
    rigid, patches, ellipses = rigid_error(analyn), patch_error(analyn), patch_error(hertz)
    rows = [
        ("geometry alone (unloaded), trajectory", many(analyn, trajectory, 0.0, 0.0), count, rigid),
        ("Hertz, trajectory", many(hertz, trajectory, 0.0), count, ellipses),
        ("ANALYN, trajectory", many(analyn, trajectory, 0.0), count, patches),
        ("ANALYN, trajectory with yaw", many(analyn, trajectory, swing), count, patches),
        ("ANALYN, random poses", many(analyn, anywhere, 0.0), count, patches),
        ("ANALYN, random poses with yaw", many(analyn, anywhere, any_yaw), count, patches),
        ("ANALYN, `evaluate()` from Python, trajectory", one_by_one(analyn, trajectory), count, patches),
    ]
    print("| one wheelset, both patches | units | µs | error (mean / worst) |")
    print("|---|---|---|---|")
    for name, work, calls, error in rows:
        seconds, units = cost(work, calls, rounds)
        print(f"| {name} | {units:.1f} | {seconds * 1e6:.1f} | {error} |", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        seconds, units = fmu_step.whole_step(folder, rounds)
    print(f"| FMU step through fmpy's slave object: 5 inputs, all outputs | {units:.1f} | {seconds * 1e6:.1f} | {patches} |")
    print(f"\nunit: np.sqrt of 2000 doubles, {unit() * 1e6:.2f} µs here; kernel "
          f"{'compiled' if analyn.stepper().compiled else 'UNCOMPILED'}")


def many(system, shift, yaw, force=78.5e3):
    return lambda: system.evaluate_many(shift, yaw, force)


def one_by_one(system, shift):
    shifts = shift.tolist()
    return lambda: [system.evaluate(lateral_shift=value) for value in shifts]


def cost(work, calls, rounds):
    """Seconds of one call and units, each the smallest of ``rounds`` taken in turn."""
    found = [(timeit.timeit(work, number=1) / calls, unit()) for _ in range(rounds)]
    return min(seconds for seconds, _ in found), min(seconds / one for seconds, one in found)


def unit():
    values = np.linspace(0.0, 1.0, 2000)
    return min(timeit.repeat(lambda: np.sqrt(values), number=300, repeat=5)) / 300


def stored_run():
    with open(RUN, newline="", encoding="utf-8") as file:
        names, *rows = csv.reader(file)
    return dict(zip(names, np.array(rows, dtype=float).T))


def evaluated(system, run):
    return system.evaluate_many(run["lateral_shift"], run["yaw"], run["normal_force"], run["load_transfer"])


def rigid_error(system):
    run = stored_run()
    table = evaluated(system, run)
    roll = np.max(np.abs(table.roll - run["roll"]))
    place = max(np.max(np.abs(getattr(getattr(table, side).contact, name) - run[f"{side}.contact.{name}"]))
                for side in ("left", "right") for name in ("x_wheel", "y_wheel", "z_wheel"))
    return f"roll {roll:.0e} rad, position {place * 1e3:.0e} mm (worst)"


def patch_error(system):
    run = stored_run()
    table = evaluated(system, run)
    errors = [100 * np.abs(np.concatenate([getattr(getattr(table, side), name) / run[f"{side}.{name}"] - 1
                                           for side in ("left", "right")])) for name in PATCH]
    mean, worst = (" / ".join(f"{figure(error):.1f}" for error in errors) for figure in (np.mean, np.max))
    return f"{mean} % mean, {worst} % worst (penetration / area / peak pressure)"


if __name__ == "__main__":
    main(quick="--quick" in sys.argv[1:])
