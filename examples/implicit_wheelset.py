"""A wheelset on its primary suspension runs over a bend of the track, by solvers of every kind.

    python -m examples.implicit_wheelset

The contact gives forces by ``stepper.resultant`` and, to solvers with a Jacobian, their derivatives by
``stepper.derivatives``.  Equations of motion as in hunting_wheelset/wheelset.py, for small roll and yaw:

    m y'' = F_y - K_y y - D_y y'               m z'' = F_z + W
    I_x q'' + I_y w_0 p' = M_x + p M_y         I_z p'' - I_y w_0 q' = M_z - K_p p
    I_y w' = T
"""

import math
import time

import numpy as np
from scipy.integrate import solve_ivp

import wrcontact

MASS, ROLL_INERTIA, PITCH_INERTIA, YAW_INERTIA = 1813.0, 1120.0, 112.0, 1120.0
STIFFNESS, DAMPING, YAW_STIFFNESS = 7.8e6, 4e3, 2e7
SPEED, RADIUS, LOAD = 30.0, 0.46, 54.5e3  # [m/s], [m], of a wheel [N]
DURATION = 0.6  # [s]
#: Motion of the wheelset, and what acts on it.
PLACES = ("lateral_shift", "vertical_shift_input", "roll_input", "yaw")
RATES = ("lateral_velocity", "vertical_velocity", "roll_rate", "yaw_rate", "wheel_rate")
FORCES = ("force.y", "force.z", "moment.x", "moment.y", "moment.z", "driving_torque")


def bend(place):
    """Lateral displacement of the track [m] at a ``place`` along it [m]: 3 mm over 10 m."""
    return 1.5e-3 * (1.0 - math.cos(2.0 * math.pi * (place - 3.0) / 10.0)) if 3.0 < place < 13.0 else 0.0


class Wheelset:
    """The rates of a motion (9,): places, then their rates; counts what it asks of the contact."""

    def __init__(self):
        self.system = wrcontact.ContactSystem(
            contact_mode="compliant", contact_damping=1.0, tangential_model="strips"
        )
        self.stepper = self.system.stepper(outputs="patches")
        self.at = [self.stepper.place(name) for name in FORCES]
        self.into = [self.stepper.place(name) for name in (*PLACES, *RATES)]
        self.rails = [self.stepper.place(f"{side}.rail_lateral") for side in ("left", "right")]
        self.stepper.inputs[self.stepper.place("speed")] = SPEED
        self.steps = self.derivatives = 0
        stands = self.system.evaluate(normal_force=LOAD).equilibrium
        self.start = np.array([0.0, stands.vertical_shift, stands.roll, 0, 0, 0, 0, 0, SPEED / RADIUS])

    def place(self, now, motion):
        self.stepper.inputs[self.into] = motion
        self.stepper.inputs[self.rails] = bend(SPEED * now)

    def rates(self, now, motion):
        """The rates (9,) of a motion."""
        self.place(now, motion)
        self.steps += 1
        if self.stepper.step() > wrcontact.Status.UNLOADED:
            return np.full(9, np.nan)
        return self.moved(motion, self.stepper.outputs[self.at])

    def moved(self, motion, acting):
        """The rates (9,) under what acts (6,)."""
        y, _, _, yaw, *speeds = motion
        force_y, force_z, moment_x, moment_y, moment_z, torque = acting
        gyroscope = PITCH_INERTIA * SPEED / RADIUS
        return np.array(
            [
                *speeds[:4],
                (force_y - STIFFNESS * y - DAMPING * speeds[0]) / MASS,
                (force_z + 2.0 * LOAD) / MASS,
                (moment_x + yaw * moment_y - gyroscope * speeds[3]) / ROLL_INERTIA,
                (moment_z - YAW_STIFFNESS * yaw + gyroscope * speeds[2]) / YAW_INERTIA,
                torque / PITCH_INERTIA,
            ]
        )

    def jacobian(self, now, motion):
        """How the rates follow the motion (9, 9)."""
        self.place(now, motion)
        self.derivatives += 1
        by_motion = self.stepper.derivatives(FORCES, (*PLACES, *RATES))
        self.steps += 1
        self.stepper.step()
        acting = self.stepper.outputs[self.at]
        rest = self.moved(motion, acting)
        own = np.array([self.moved(motion + row, acting) - rest for row in np.eye(9)]).T
        return own + np.array([self.moved(motion, acting + row) - rest for row in np.eye(6)]).T @ by_motion


class Nearby(Wheelset):
    """For a solver that takes differences for its Jacobian and has no place for another one: near the last
    place the forces follow from their derivatives there."""

    #: Within this the forces are as straight as differences need them.
    NEAR = np.array([1e-7] * 4 + [1e-5] * 4 + [1e-4])

    def __init__(self):
        super().__init__()
        self.last, self.acting, self.by_motion = (np.nan, np.full(9, np.nan)), None, None

    def rates(self, now, motion):
        before, place = self.last
        if now != before or (np.abs(motion - place) > self.NEAR).any():
            found = super().rates(now, motion)
            self.last, self.acting, self.by_motion = (now, motion.copy()), self.stepper.outputs[self.at], None
            return found
        if self.by_motion is None:
            self.place(*self.last)
            self.derivatives += 1
            self.by_motion = self.stepper.derivatives(FORCES, (*PLACES, *RATES))
        return self.moved(motion, self.acting + self.by_motion @ (motion - place))


def semi_implicit(wheelset, step):
    """Euler's semi-implicit method: velocities first, places with the new ones."""
    motion, largest = wheelset.start.copy(), 0.0
    for k in range(round(DURATION / step)):
        rates = wheelset.rates(k * step, motion)
        motion[4:] += step * rates[4:]
        motion[:4] += step * motion[4:8]
        largest = max(largest, abs(motion[0]))
    return round(DURATION / step), largest


def linearly_implicit(wheelset, step):
    """The trapezoidal rule, linearised at the beginning of each step: (1 - h/2 J) dx = h f."""
    motion, largest = wheelset.start.copy(), 0.0
    for k in range(round(DURATION / step)):
        jacobian = wheelset.jacobian(k * step, motion)
        rates = wheelset.rates((k + 0.5) * step, motion)
        motion += np.linalg.solve(np.eye(9) - 0.5 * step * jacobian, step * rates)
        largest = max(largest, abs(motion[0]))
    return round(DURATION / step), largest


def adaptive(wheelset, method, own_jacobian=True):
    """A solver of scipy that chooses its steps."""
    more = {"jac": wheelset.jacobian if own_jacobian else None} if method in ("Radau", "BDF") else {}
    found = solve_ivp(
        wheelset.rates,
        (0.0, DURATION),
        wheelset.start,
        method,
        rtol=1e-5,
        max_step=0.01,
        atol=np.array([1e-8] * 4 + [1e-6] * 4 + [1e-5]),
        **more,
    )
    return len(found.t) - 1, abs(found.y[0]).max()


SOLVERS = {
    "Euler, semi-implicit, 0.25 ms": lambda wheelset: semi_implicit(wheelset, 0.25e-3),
    "trapezoidal, linearised, 1 ms": lambda wheelset: linearly_implicit(wheelset, 1e-3),
    "RK45": lambda wheelset: adaptive(wheelset, "RK45"),
    "Radau, Jacobian by differences": lambda wheelset: adaptive(wheelset, "Radau", own_jacobian=False),
    "Radau, differences answered by derivatives": lambda wheelset: adaptive(
        wheelset, "Radau", own_jacobian=False
    ),
    "Radau, Jacobian by derivatives": lambda wheelset: adaptive(wheelset, "Radau"),
    "BDF, Jacobian by derivatives": lambda wheelset: adaptive(wheelset, "BDF"),
}


def run(name):
    """Steps, steps of the contact, its derivatives, largest lateral shift [m], processor time [s]."""
    wheelset, began = (Nearby if "answered" in name else Wheelset)(), time.process_time()
    steps, largest = SOLVERS[name](wheelset)
    return steps, wheelset.steps, wheelset.derivatives, largest, time.process_time() - began


def main():
    print("| solver | steps | contact steps | derivatives | largest shift [mm] | processor [s] |")
    print("| --- | ---: | ---: | ---: | ---: | ---: |")
    for name in SOLVERS:
        steps, evaluated, derived, largest, used = run(name)
        print(f"| {name} | {steps} | {evaluated} | {derived} | {1e3 * largest:.3f} | {used:.2f} |")


if __name__ == "__main__":
    main()
