"""Where the rigid contact point jumps: lateral shifts at which two local minima of the gap exchange rank.

Walk along the lateral shift; where the right contact moves far in one step, halve the step until the move is
either plainly continuous or confined to a nanometre. Run as a script to print a table for a few yaw angles.
"""

from dataclasses import dataclass

import numpy as np

from data.brute_force import rigid_contact, track

STEP = 0.05e-3  # [m] walking step
FAR = 0.2e-3  # [m] a larger move of the contact in one step is looked into
RESOLUTION = 1e-9  # [m] a jump is located to this


@dataclass(frozen=True)
class Jump:
    lateral_shift: float  # [m]
    before: float  # y_wheel of the right contact on either side [m]
    after: float


def find_jumps(system, yaw, start, stop):
    """Jumps of the right contact between two lateral shifts [m]."""
    shifts = np.linspace(start, stop, round((stop - start) / STEP) + 1)
    places = [place(system, shift, yaw) for shift in shifts]
    steps = zip(shifts, shifts[1:], places, places[1:])
    return [jump for step in steps for jump in inside(system, yaw, *step)]


def inside(system, yaw, left, right, before, after):
    """Jumps between two neighbouring shifts with their contact places, by halving."""
    if abs(after - before) < FAR:
        return []
    if right - left < RESOLUTION:
        return [Jump((left + right) / 2, before, after)]
    middle = (left + right) / 2
    between = place(system, middle, yaw)
    return inside(system, yaw, left, middle, before, between) + inside(
        system, yaw, middle, right, between, after
    )


def place(system, lateral_shift, yaw):
    """y_wheel of the right contact [m]."""
    return rigid_contact(system, lateral_shift, yaw).right.y_wheel


if __name__ == "__main__":
    standard = track()
    print("yaw [deg]  lateral shift [mm]  y_wheel before, after [mm]")
    for degrees in (0, 0.5, 1, 1.2, 1.5, 2):
        for jump in find_jumps(standard, np.radians(degrees), 3.5e-3, 6.6e-3):
            print(
                f"{degrees:8.2f} {jump.lateral_shift * 1e3:16.6f} {jump.before * 1e3:18.4f} "
                f"{jump.after * 1e3:10.4f}",
                flush=True,
            )
