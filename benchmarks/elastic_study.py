"""What elastic equilibrium costs and how it moves: time and trials of a step, and the largest step of the
roll.

``python -m benchmarks.elastic_study``, some 20 s.  A step costs the smallest of five runs over a sine of 5 mm
and 0.3 deg, in microseconds and in ``np.sqrt`` of 2000 doubles; trials are those of random poses and include
the rigid search's.
"""

import math

import numpy as np

import wrcontact
from wrcontact.kernel import layout

from .machine import cost, description
from .table import markdown

FORCE = 78.5e3   # per wheel [N]
STEPS, POSES, ROUNDS = 1000, 2000, 5
MODELS = ("analyn", "analyn_strip", "hertz")


def sine():
    """Lateral shift [m] and yaw [rad] of a hunting wheelset (STEPS,)."""
    phase = np.linspace(0.0, 2 * math.pi, STEPS)
    return 5e-3 * np.sin(phase), 5e-3 * np.cos(phase)


def step_cost(**parameters):
    """:class:`~benchmarks.machine.Cost` of a step of the sine; the compliant form's at the elastic stands."""
    shift, yaw = sine()
    stand = wrcontact.ContactSystem(contact_mode="elastic").evaluate_many(shift, yaw, FORCE)
    pair = wrcontact.ContactSystem(**parameters)
    given = dict(vertical_shift_input=stand.vertical_shift, roll_input=stand.roll)
    return cost(lambda: pair.evaluate_many(shift, yaw, FORCE, **given), STEPS, ROUNDS)


def trials(model, load):
    """Trials of each of POSES random poses, up to 8 mm and 0.03 rad, 1 ... 150 kN."""
    rng = np.random.default_rng(4)
    stepper = wrcontact.ContactSystem(contact_mode="elastic", normal_model=model, load=load).stepper()
    found = []
    for shift, yaw, force in rng.uniform((-8e-3, -0.03, 1e3), (8e-3, 0.03, 150e3), (POSES, 3)):
        stepper.inputs[[0, 1, 3]] = shift, yaw, force
        before = stepper.state[layout.STATE_ROLL_COUNT]
        stepper.step()
        found.append(stepper.state[layout.STATE_ROLL_COUNT] - before)
    return np.array(found)


def largest_roll_step(yaw, step=1e-6):
    """Largest step of the roll [rad] from -8 to 8 mm, and where [mm]."""
    shift = np.arange(-8e-3, 8e-3, step)
    table = wrcontact.ContactSystem(contact_mode="elastic").evaluate_many(shift, yaw, FORCE)
    steps = np.abs(np.diff(table.roll))
    return steps.max(), 1e3 * shift[np.argmax(steps)]


def main():
    rows = []
    for model in MODELS:
        costs = [step_cost(contact_mode=mode, normal_model=model)
                 for mode in ("rigid", "compliant", "elastic")]
        rows.append([model, *(f"{each.microseconds:.0f} / {each.units:.0f}" for each in costs)])
    print(markdown("Cost of a step", ["µs / units", "rigid", "compliant", "elastic"], rows))
    rows = []
    for model in MODELS:
        for load in ("normal", "vertical"):
            count = trials(model, load)
            rows.append([f"{model}, {load}", f"{count.mean():.1f}", f"{np.percentile(count, 99):.0f}",
                         f"{count.max():.0f}"])
    print(markdown("Trials of a pose", ["", "mean", "99 %", "most"], rows))
    rows = []
    for degrees in (0, 1, 2):
        largest, shift = largest_roll_step(math.radians(degrees))
        rows.append([f"{degrees}°", f"{1e6 * largest:.1f}", f"{shift:.3f}"])
    print(markdown("Steps of the roll in 1 µm", ["yaw", "largest [µrad]", "at [mm]"], rows))
    print(description())


if __name__ == "__main__":
    main()
