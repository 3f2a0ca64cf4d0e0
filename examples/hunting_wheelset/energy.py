"""Energy balance over the coupling against the step: what the contact gives, and what the wheelset gets.

    python -m examples.hunting_wheelset.energy [FOLDER]

The wheelset's energy E = kinetic + springs follows from its state alone.  The contact's power is that of the
forces it gives, at the velocities it was given; the rest (load, dampers) is the wheelset's output ``supply``.
Their sum, by the trapezoidal rule over the steps of the loop, is E(end) - E(start) but for what the coupling
makes up.  Frozen forces make up energy in proportion to the step, and with the derivatives to its
square.
"""

import sys

import numpy as np
from scipy.integrate import trapezoid

from .coupling import CONES, Loop, build

STEPS = (4e-4, 2e-4, 1e-4, 5e-5)  # [s]
DURATION = 0.4  # [s]
SETTLE = 0.05  # [s] in which the wheelset finds its rotation, in the smallest steps
#: A swing of 3 mm on cones of 1:20, at 20 m/s on soft springs.
WHEELSET = {
    "frame_speed": 20.0,
    "start_lateral_shift": 3e-3,
    "longitudinal_stiffness": 2e5,
    "lateral_stiffness": 1e5,
    "lateral_damping": 1e3,
}


def contact_power(run):
    """Power (n,) of the contact's forces on the wheelset [W], without that along the track."""
    yaw = run["yaw"]
    about_x = run["moment.x"] * np.cos(yaw) + run["moment.y"] * np.sin(yaw)
    return (
        run["force.y"] * run["lateral_velocity"]
        + run["force.z"] * run["vertical_velocity"]
        + about_x * run["roll_rate"]
        + run["moment.z"] * run["yaw_rate"]
        + run["driving_torque"] * run["wheel_rate"]
    )


def balance(run):
    """Energy that is made up over a run [J], and what was exchanged: the integral of the sizes of powers."""
    power, step = contact_power(run) + run["supply"], run.time[1] - run.time[0]
    gained = run["energy"][-1] - run["energy"][0]
    return gained - trapezoid(power, dx=step), trapezoid(np.abs(contact_power(run)), dx=step)


def study(archives, derivatives, steps=STEPS, wheelset=WHEELSET, contact=CONES, duration=DURATION):
    """Energy made up [J] for each of ``steps`` [s], the exchanged energy [J], and the largest status."""
    errors, worst = [], 0
    for step in steps:
        with Loop(archives, wheelset, contact, seen=("energy", "supply")) as loop:
            loop.run(SETTLE, steps[-1])
            run = loop.run(duration, step, derivatives=derivatives)
        error, exchanged = balance(run)
        errors.append(error)
        worst = max(worst, run.worst_status)
    return np.array(errors), exchanged, worst


def orders(errors):
    """Order between neighbouring steps, of which each is half of the last."""
    return np.log2(np.abs(errors[:-1] / errors[1:]))


if __name__ == "__main__":
    folder = (sys.argv[1:] or ["out"])[0]
    archives = build(folder)
    for words, derivatives in (("explicit", False), ("with derivatives", True)):
        errors, exchanged, worst = study(archives, derivatives)
        print(f"{words}: {exchanged:.1f} J exchanged in {DURATION} s, largest status {worst}")
        for step, error, order in zip(STEPS, errors, [np.nan, *orders(errors)]):
            print(f"   step {step * 1e3:5.3f} ms: {error:12.4e} J made up, order {order:5.2f}")
