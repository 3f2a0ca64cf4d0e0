"""Writes flange_strips.csv: yawed right wheels on their flanges where strips were once wrong by far, by the
half-space.

S1002 on three rails at 1:40 and 1:20. Each pose stands for a cause, named in the column ``cause``:

* skew: the cubic of the gap beside a yawed wheel's ridge was read far beyond where it was measured;
* share: levels of tread and flange were lowered by one amount;
* regions: of four deepest points the flange was left out;
* shoulder: two zones met under load, and runs ended between them;
* sliver: slivers of runs left no room for the tread.

Poses and causes are read from the file; loads, largest pressures, penetrations and areas are written anew. SI
units; a pose has either a normal force, or a vertical shift and a roll. A minute on one core::

    python -m data.make_flange_strips
"""

import csv
from pathlib import Path

import wrcontact

OUTPUT = Path(__file__).resolve().with_name("flange_strips.csv")
TRACK = ("rail", "rail_inclination")
POSE = ("lateral_shift", "yaw", "normal_force", "vertical_shift_input", "roll_input")
RESULTS = ("normal_force", "max_pressure", "penetration", "area")
COLUMNS = ("cause", *TRACK, *POSE, *(f"found_{name}" for name in RESULTS))
#: Of the half-space.
TOLERANCE = 0.005


def rows():
    """Rows of the file, by column."""
    with open(OUTPUT, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def answer(row, **options):
    """Status and the right wheel's RESULTS of a model at the pose of a row."""
    pose = {name: float(row[name]) for name in POSE if row[name]}
    mode = "rigid" if row["normal_force"] else "compliant"
    track = {"rail": row["rail"], "rail_inclination": float(row["rail_inclination"])}
    state = wrcontact.ContactSystem(contact_mode=mode, **track, **options).evaluate(side="right", **pose)
    return state.status, [getattr(state.right, name) for name in RESULTS]


def main():
    known = rows()
    with open(OUTPUT, "w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        table.writeheader()
        for row in known:
            _, found = answer(row, normal_model="halfspace", tolerance=TOLERANCE)
            for name, value in zip(RESULTS, found):
                row[f"found_{name}"] = f"{value:.7g}"
            table.writerow(row)


if __name__ == "__main__":
    main()
