"""Writes second_patches.csv: right wheels with two patches at random poses, by the half-space.

S1002 on three rails at 1:40 and 1:20, half of them with yaw, 30 ... 150 kN, rigid. Poses are those at which
ANALYN has two patches. SI units. About ten minutes on one core::

    python -m data.make_second_patches
"""

import csv
from pathlib import Path

import numpy as np

import wrcontact
from wrcontact.progress import tracked

OUTPUT = Path(__file__).resolve().with_name("second_patches.csv")
SEED, COUNT = 606, 60
RAILS = ("UIC60", "60E1", "54E1")
#: Poses that are tried for each row; the first with two patches is taken.
TRIED = 60
POSE = ("rail", "rail_inclination", "lateral_shift", "yaw", "normal_force")
WHEEL = ("penetration", "area", "max_pressure")
#: Of the patch nearest to the track's centre, and of the other one; not a number where there is one patch.
PATCHES = ("inner_load", "inner_area", "outer_load", "outer_area")


def draw(rng):
    """Rail, its inclination, and a pose (lateral shift, yaw, load) at which ANALYN has two patches."""
    while True:
        rail, inclination = str(rng.choice(RAILS)), float(rng.choice([1 / 40, 1 / 20]))
        shift = rng.uniform(-1e-3, 6.6e-3, TRIED)
        yaw = rng.uniform(-0.02, 0.02, TRIED) * (rng.random(TRIED) < 0.5)
        load = 10 ** rng.uniform(np.log10(3e4), np.log10(1.5e5), TRIED)
        table = wrcontact.ContactSystem(rail=rail, rail_inclination=inclination).evaluate_many(
            shift, yaw, normal_force=load
        )
        two = np.flatnonzero((table.status == 0) & (table.right.patch_count == 2))
        if len(two):
            return rail, inclination, float(shift[two[0]]), float(yaw[two[0]]), float(load[two[0]])


def answer(rail, inclination, shift, yaw, load, model="halfspace"):
    """Penetration, area and peak pressure of the right wheel, and load and area of both patches."""
    system = wrcontact.ContactSystem(rail=rail, rail_inclination=inclination, normal_model=model)
    wheel = system.evaluate(shift, yaw, normal_force=load).right
    patches = sorted(wheel.patches[: wheel.patch_count], key=lambda patch: patch.y_track)
    found = [np.nan] * 4
    if len(patches) == 2:
        found = [value for patch in patches for value in (patch.normal_force, patch.area)]
    return [wheel.penetration, wheel.area, wheel.max_pressure, *found]


def main():
    rng = np.random.default_rng(SEED)
    with open(OUTPUT, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow((*POSE, *WHEEL, *PATCHES))
        for _ in tracked(range(COUNT), "poses"):
            pose = draw(rng)
            table.writerow([*pose, *(f"{value:.7g}" for value in answer(*pose))])


if __name__ == "__main__":
    main()
