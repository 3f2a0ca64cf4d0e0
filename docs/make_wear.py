"""Run the route of examples/wear_of_a_wheel.py and write its table and the pictures of docs/guides/wear.md.

    python docs/make_wear.py [OUT]

A run that OUT has already is not run again; without one it takes about nine minutes on two cores.
"""

import sys
from concurrent.futures import ProcessPoolExecutor
from dataclasses import fields
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT))

import wrcontact  # noqa: E402
from benchmarks.tables import grid, write_part  # noqa: E402
from examples import wear_of_a_wheel as route  # noqa: E402
from examples.hunting_wheelset.coupling import CONTACT, build_wheelset, unpacked  # noqa: E402
from wrcontact.plots import (  # noqa: E402
    fatigue_figure,
    save,
    shakedown_figure,
    wear_depth_figure,
    wear_figure,
)

PAGE, IMAGES = ROOT / "docs" / "guides" / "wear.md", ROOT / "docs" / "img"
#: Yield stress in shear for the pictures of fatigue [Pa], and distance of the picture of depths [m].
YIELD, DISTANCE = 300e6, 10e6


def mileage_table(run):
    """Lines of the table over the mileage."""
    rows = []
    for step in run.steps:
        shape, wide = step.shapes["right"], 1e3
        rows.append(
            [
                f"{step.distance / 1e6:.1f}",
                f"{wide * shape.flange_thickness:.3f}",
                f"{wide * shape.flange_height:.3f}",
                f"{wide * shape.flange_steepness:.3f}",
                f"{wide * shape.hollow:.3f}",
                f"{wide * shape.radius_loss:.3f}",
                f"{1e6 * shape.worn_area:.1f}",
                f"{step.conicity:.3f}",
            ]
        )
    head = [
        "1000 km",
        "Sd [mm]",
        "Sh [mm]",
        "qR [mm]",
        "hollow [mm]",
        "radius lost [mm]",
        "worn [mm²]",
        "conicity",
    ]
    return grid(head, rows)


def section_table(wears):
    """Lines of the table of the sections with new wheels, by the law without calibration."""
    rows = []
    for (radius, speed, ahead, share), wear in wears:
        places, depth = wear.arc("wheel").places, wear.smooth_depth("wheel", 1e-3)
        k = int(np.argmax(depth))
        rows.append(
            [
                "straight" if np.isinf(radius) else f"{radius:.0f} m",
                "both" if np.isinf(radius) else "leading" if ahead > 0 else "trailing",
                f"{100 * share:.3g}",
                f"{3.6 * speed:.0f}",
                f"{1e9 * depth[k]:.3f}",
                f"{1e3 * places[k]:.1f}",
                f"{100 * wear.error('wheel', smoothing=1e-3)[k] / depth[k]:.0f}",
            ]
        )
    head = ["curve", "wheelset", "share [%]", "km/h", "deepest [mm / 1000 km]", "at y [mm]", "error [%]"]
    return grid(head, rows)


def joined(parts):
    """One record of fatigue of several."""
    return type(parts[0])(
        *(np.concatenate([getattr(part, one.name) for part in parts]) for one in fields(parts[0]))
    )


def new_wheels(out):
    """Tables of the route's sections with new wheels, and the wear of each and of all."""
    system = wrcontact.ContactSystem(**CONTACT, wear_outputs=True)
    wheelset = build_wheelset(out)
    unpacked(wheelset)
    with ProcessPoolExecutor(2) as pool:
        tables = route.simulate(system, out, pool, wheelset)
    whole = wrcontact.Wear(system, wrcontact.Usfd(), mirrored=True)
    wears = []
    for run, (table, distance) in zip(route.sections(), tables):
        whole.add(table, distance)
        wears.append((run, wrcontact.Wear(system, wrcontact.Usfd(), mirrored=True)))
        wears[-1][1].add(table)
    return tables, wears, whole


if __name__ == "__main__":
    out = Path((sys.argv[1:] or ["out"])[0])
    run = route.wear_out(out)
    save(wear_figure(run), IMAGES / "wear_route.png")
    write_part(PAGE, "docs/make_wear.py", "mileage", mileage_table(run).splitlines())
    tables, wears, whole = new_wheels(out)
    write_part(PAGE, "docs/make_wear.py", "sections", section_table(wears).splitlines())
    deepest = whole.smooth_depth("wheel", 1e-3).max()
    shares = ", ".join(f"{100 * share:.1f} % {name}" for name, share in whole.shares("wheel").items())
    worst = max(step.left_out for step in run.steps)
    laboratory = (
        "With new wheels the law without calibration takes 1 mm in "
        f"{1e-3 / deepest / 1e3:.0f} km at the deepest place; by mass {shares}. The run over "
        f"{run.distance[-1] / 1e6:.0f} 000 km with {route.CALIBRATION:g} of it has {len(run.steps) - 1} "
        f"steps; of the rows of a step at most {worst} are left out."
    )
    write_part(PAGE, "docs/make_wear.py", "laboratory", [laboratory])
    save(wear_depth_figure(whole, DISTANCE), IMAGES / "wear_depth.png")
    found = [wrcontact.fatigue(table, yield_shear=YIELD) for table, _ in tables]
    everything = joined(found)
    weights = np.concatenate([np.full(len(table), distance) for table, distance in tables])
    save(shakedown_figure(everything), IMAGES / "wear_shakedown.png")
    save(fatigue_figure(everything, "damage", "rail", weights), IMAGES / "wear_fatigue.png")
