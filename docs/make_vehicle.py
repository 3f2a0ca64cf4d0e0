"""Run the examples in exudyn anew and write their tables and picture into docs/guides/vehicle.md and
docs/img.

    pip install exudyn
    python docs/make_vehicle.py

It takes three minutes.
"""

import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT))

from benchmarks.tables import grid, write_part  # noqa: E402
from examples.vehicle import hunting, runs, theory  # noqa: E402
from examples.vehicle import manchester as vehicle  # noqa: E402
from wrcontact.plots.style import save  # noqa: E402

PAGE, IMAGES = ROOT / "docs" / "guides" / "vehicle.md", ROOT / "docs" / "img"
MODELS = ("strips", "fastsim")


def loads(run):
    """Smallest and largest load of a wheel [N]."""
    found = np.concatenate([run["left_load"], run["right_load"]])
    return found.min(), found.max()


def hunts():
    """Table of growth and frequency, and the growths of the first model by speed."""
    half, rows, growths = hunting.touching(), [], {model: [] for model in MODELS}
    for speed in hunting.SPEEDS:
        wanted = theory.root(speed, half)
        found = {model: hunting.grown(speed, wanted.imag, model) for model in MODELS}
        for model in MODELS:
            growths[model].append(found[model][0])
        rows.append(
            [
                f"{speed:g}",
                *(f"{found[model][0]:+.3f}" for model in MODELS),
                f"{wanted.real:+.3f}",
                *(f"{found[model][1]:.3f}" for model in MODELS),
                f"{wanted.imag:.3f}",
            ]
        )
    names = [f"`{model}`" for model in MODELS]
    critical = {model: hunting.critical_speed(hunting.SPEEDS, growths[model]) for model in MODELS}
    wanted = theory.critical_speed(half)
    words = ", ".join(
        f"{speed:.2f} m/s with `{model}` ({100 * (speed / wanted - 1):+.2f} %)"
        for model, speed in critical.items()
    )
    lines = grid(
        [
            "speed [m/s]",
            *(f"growth, {name} [1/s]" for name in names),
            "theory",
            *(f"frequency, {name} [rad/s]" for name in names),
            "theory",
        ],
        rows,
    ).splitlines()
    lines += ["", f"Critical speed: {words}, by the theory {wanted:.2f} m/s."]
    return lines, dict(zip(hunting.SPEEDS, growths["strips"]))


def solvers():
    """Table of the cost of the bulge, and the run by RK44."""
    rows, kept = [], None
    for name, (_, step, _, _) in runs.SOLVERS.items():
        run = runs.over_bulge(name)
        kept = run if name == "`RK44`" else kept
        largest = 1e3 * np.abs(run.places[:, :4, 1]).max()
        rows.append(
            [
                name,
                f"{1e3 * step:g}",
                run.steps,
                f"{run.contact_steps / run.steps:.1f}",
                f"{run.derivatives / run.steps:.1f}",
                f"{run.processor:.1f}",
                f"{largest:.3f}",
                f"{loads(run)[0] / 1e3:.2f}",
                run.failed,
            ]
        )
    return grid(
        [
            "solver",
            "step [ms]",
            "steps",
            "contact steps a step",
            "derivatives a step",
            "processor [s]",
            "largest y [mm]",
            "smallest load [kN]",
            "failed",
        ],
        rows,
    ).splitlines(), kept


def checks(curved, shaken):
    """Sums that follow from mechanics alone."""
    low, high = loads(runs.weight())
    pushed, needed = runs.needed_in_curve(curved)
    shift, yaw = 1e3 * curved["shift"][-1, 0], 1e3 * curved["yaw"][-1, 0]
    left = 1e3 * np.abs(shaken["shift"]).max()
    pushed, needed = f"{pushed / 1e3:.2f}", f"{needed / 1e3:.2f}"
    return [
        f"* Weight: a wheel carries {low:.1f} … {high:.1f} N at 40 m/s, its share of the weight is "
        f"{vehicle.LOAD / 2:.1f} N.",
        f"* Curve: the rails push all wheelsets with {pushed} kN, masses times accelerations of all "
        f"bodies are {needed} kN. The first wheelset is at {shift:+.2f} mm, its yaw is {yaw:+.2f} mrad.",
        f"* Irregular track: a wheelset is {left:.2f} mm beside the track at most, the smallest load is "
        f"{loads(shaken)[0] / 1e3:.1f} kN; {shaken.calls:.1f} calls of the contact a step.",
    ]


if __name__ == "__main__":
    table, growths = hunts()
    write_part(PAGE, "docs/make_vehicle.py", "hunting", table)
    table, bulged = solvers()
    write_part(PAGE, "docs/make_vehicle.py", "solvers", table)
    curved, shaken = runs.through_curve(), runs.on_irregular_track()
    write_part(PAGE, "docs/make_vehicle.py", "checks", checks(curved, shaken))
    save(runs.draw(growths, bulged, curved, shaken), IMAGES / "vehicle.png")
