"""Writes the stored runs that the product is checked against: hunting.csv, jumps.csv, load.csv.

Inputs are made here, rigid columns come from ``brute_force``, patch columns from ``conformal_reference``: the
wheel has come straight down from its rigid pose. S1002 on UIC60 1:40, gauge 1435 mm. SI units. About an hour
on one core::

    python -m data.make_trajectories [hunting] [jumps] [load]
"""

import csv
import sys
from dataclasses import asdict
from functools import cache

import numpy as np

from data import TRAJECTORIES
from data.brute_force import rigid_contact, track
from data.conformal_reference import sunk_contact
from data.find_jumps import find_jumps
from wrcontact.progress import tracked

TIME_STEP = 0.01  # [s]
WHEEL_FORCE = 78.5e3  # [N]
SIDES = ("left", "right")
PATCH = ("penetration", "area", "max_pressure")
MM = 1e-3

SYSTEM = track()


def main(names):
    for name in names:
        inputs = RUNS[name]()
        rows = rigid_rows(inputs)
        write(name, rows)  # early, with empty patch columns
        write(name, [{**row, **patches(row)} for row in tracked(rows, f"patches of {name}")])


# ----------------------------------------------------------------------------------------------------- inputs
# Each run is a list of (lateral_shift, yaw, roll_guess, normal_force, load_transfer).


def hunting(rows=160, cycles=4):
    """Growing hunting: shift to +-7.6 mm, yaw a quarter cycle behind to +-1.2 deg, load
    moving with the shift."""
    phase = 2 * np.pi * cycles * np.arange(rows) / (rows - 1)
    growth = np.minimum(1, (0.3 + phase / phase[-1]) / 1.05)
    shift, yaw = growth * np.sin(phase), growth * np.sin(phase - np.pi / 2)
    return [
        (round(7.6e-3 * y, 9), round(np.radians(1.2) * a, 9), None, WHEEL_FORCE, round(0.25 * y, 6))
        for y, a in zip(shift, yaw)
    ]


SWEEPS = [  # yaw [deg], from, to [mm], rows
    (0, 4.75, 5.10, 22),
    (0, 6.15, 6.35, 21),
    (1, 4.80, 5.10, 22),
    (1, 6.05, 6.30, 21),
]
BESIDE_JUMP = np.array([0.25, 0.6, 1.5, 4, 12]) * 1e-6  # [m] rows this far from a jump, both sides
CLEAR_OF_JUMP = 0.2e-6  # [m] and none closer


def jumps():
    """Slow sweeps of the shift through the places where the contact point jumps."""
    return [
        (shift, np.radians(yaw), 0.0, WHEEL_FORCE, 0.0)
        for yaw, start, stop, rows in SWEEPS
        for shift in sweep(yaw, start, stop, rows)
    ]


def sweep(yaw, start, stop, rows):
    """Even steps from start to stop [mm] and more around each jump, none within CLEAR_OF_JUMP of one; [m]."""
    places = [jump.lateral_shift for jump in find_jumps(SYSTEM, np.radians(yaw), start * MM, stop * MM)]
    beside = [place + sign * distance for place in places for sign in (-1, 1) for distance in BESIDE_JUMP]
    beside += [(a + b) / 2 for a, b in zip(places, places[1:])]
    shifts = np.unique(np.round(np.concatenate([np.linspace(start, stop, rows) * MM, beside]), 9))
    return [float(s) for s in shifts if all(abs(s - place) > CLEAR_OF_JUMP for place in places)]


def load():
    """Load from nothing to 150 kN and back at 3 and 6 mm, then all of it moved from
    one wheel to the other."""
    forces = 1e3 * np.array(
        [0, 0.1, 1, 3, 10, 20, 35, 55, 78.5, 55, 20, 3, 0, 40, 78.5, 100, 125, 150, 110, 78.5]
    )
    shares = np.concatenate([np.linspace(0, -1, 6), np.linspace(-0.9, 1, 14)])
    wrong = (0.01, -0.01, 0.0)  # roll guesses that must not matter
    plan = [(f, 0.0) for f in forces] + [(WHEEL_FORCE, round(float(share), 6)) for share in shares]
    return [
        (shift, 0.0, wrong[k % 3], float(f), share)
        for shift in (3e-3, 6e-3)
        for k, (f, share) in enumerate(plan)
    ]


RUNS = {"hunting": hunting, "jumps": jumps, "load": load}

# ------------------------------------------------------------------------------------------------------- rows


@cache
def rigid(lateral_shift, yaw):
    return rigid_contact(SYSTEM, lateral_shift, yaw)


def rigid_rows(inputs):
    """Inputs and rigid answers, patch columns still empty; a roll_guess of None becomes the
    roll of the row before."""
    rows, last_roll = [], 0.0
    for index, given in enumerate(tracked(inputs, "rigid contacts")):
        lateral_shift, yaw, roll_guess, normal_force, load_transfer = given
        wheelset = rigid(lateral_shift, yaw)
        row = dict(
            time=index * TIME_STEP,
            lateral_shift=lateral_shift,
            yaw=yaw,
            roll_guess=last_roll if roll_guess is None else roll_guess,
            normal_force=normal_force,
            load_transfer=load_transfer,
            roll=wheelset.roll,
            vertical_shift=wheelset.vertical_shift,
        )
        row |= wheel_columns("left", wheelset.left, normal_force * (1 - load_transfer))
        row |= wheel_columns("right", wheelset.right, normal_force * (1 + load_transfer))
        rows.append(row)
        last_roll = round(wheelset.roll, 6)
    return rows


def wheel_columns(side, contact, force):
    """Columns of one wheel under its normal force [N]."""
    point = asdict(contact)
    outside = {key: point.pop(key) for key in ("contact_angle", "rolling_radius")}
    return (
        {f"{side}.contact.{key}": value for key, value in point.items()}
        | {f"{side}.{key}": value for key, value in outside.items()}
        | {f"{side}.normal_force": force}
        | {f"{side}.{key}": "" for key in PATCH}
    )


def patches(row):
    """Patch columns of both wheels of a row; an unloaded wheel has zeros."""
    wheelset = rigid(row["lateral_shift"], row["yaw"])
    return {
        f"{side}.{key}": value
        for side in SIDES
        for key, value in zip(PATCH, patch(wheelset, side, row[f"{side}.normal_force"]))
    }


@cache
def patch(wheelset, side, force):
    """penetration [m], area [m^2], max_pressure [Pa] to nine digits."""
    if force == 0:
        return 0.0, 0.0, 0.0
    solution = sunk_contact(SYSTEM, wheelset, side, force)
    return tuple(float(f"{getattr(solution, key):.9g}") for key in PATCH)


def write(name, rows):
    """One CSV; numbers in full, zeros without a sign or a rounding tail."""
    with open(TRAJECTORIES[name], "w", newline="") as file:
        table = csv.DictWriter(file, rows[0], lineterminator="\n")
        table.writeheader()
        table.writerows(
            {key: value if value == "" else repr(round(float(value), 16) + 0.0) for key, value in row.items()}
            for row in rows
        )
    print(name, len(rows), "rows", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:] or list(RUNS))
