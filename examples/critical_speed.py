"""Critical speed and limit cycle of a wheelset on its suspension: by eigenvalues, and by runs.

    python -m examples.critical_speed [FOLDER]

prints both of each and draws FOLDER/root_locus.png.
"""

import sys
from pathlib import Path

import numpy as np
from scipy.optimize import brentq

import wrcontact
from wrcontact.linear.point import PLACES, RATES
from wrcontact.plots import root_locus_figure, save

#: Mass [kg], moments of inertia about x, the axle and z [kg m2], load of both rails [N].
MASS, ROLL, PITCH, YAW, LOAD = 1500.0, 900.0, 120.0, 900.0, 157e3
INERTIA = np.array([MASS, MASS, ROLL, YAW])
#: Springs [N/m, N m/rad] and dampers [N s/m, N m s/rad] to the frame: across, down, in roll and in yaw.
SPRINGS, DAMPERS = np.array([2e5, 0.0, 0.0, 4e5]), np.array([0.0, 6e4, 6e4, 0.0])
SUSPENSION = {"stiffness": SPRINGS, "damping": DAMPERS, "inertia_pitch": PITCH}
#: Step of the run and its length [s], and its lateral shift at the start [m].
STEP, DURATION, START = 5e-4, 2.0, 1e-5
#: Speed at which the limit cycle is looked for [m/s].
CYCLE = 36.0
#: Places of a large swing; between flange and tread its derivatives change fast.
PHASES = 128


def root(system, speed):
    """The eigenvalue of hunting at a ``speed`` [m/s]."""
    return system.linearize(speed=speed, normal_force=LOAD / 2).hunting_root(INERTIA, **SUSPENSION)


def critical_speed(system, low, high):
    """Where hunting begins to grow, between two speeds [m/s]."""
    return brentq(lambda speed: root(system, speed).real, low, high, xtol=1e-4)


def swing_root(system, speed, amplitude, rounds=3):
    """The eigenvalue of a large swing, by the quasi-linear matrices of two degrees of freedom; yaw and frequency of
    the swing are those of its eigenvector."""
    frequency = share = 0.0
    for _ in range(rounds):
        pair = system.linearize(
            speed=speed,
            normal_force=LOAD / 2,
            amplitude=amplitude,
            yaw_amplitude=share * amplitude,
            frequency=frequency,
            phases=PHASES,
        )
        matrix = pair.state_matrix([MASS, YAW], SPRINGS[[0, 3]], inertia_pitch=PITCH)
        roots, shapes = np.linalg.eig(matrix)
        place = max((k for k in range(4) if roots[k].imag > 1e-3), key=lambda k: roots[k].real)
        frequency, share = roots[place].imag, abs(shapes[1, place] / shapes[0, place])
    return roots[place]


def limit_cycle(system, speed, low, high):
    """Amplitude [m] between two at which a swing neither grows nor decays."""
    return brentq(lambda amplitude: swing_root(system, speed, amplitude).real, low, high, xtol=5e-5)


class Run:
    """The wheelset in time, by the classical method of Runge and Kutta; nothing of it is linear."""

    def __init__(self, system, speed):
        self.system, self.stepper = system, system.stepper()
        self.speed = speed
        self.places = [self.stepper.place(name) for name in (*PLACES, *RATES)]
        start = system.evaluate(speed=speed, normal_force=LOAD / 2)
        self.rest = np.array([0.0, start.equilibrium.vertical_shift, start.equilibrium.roll, 0.0])
        self.stepper.inputs[self.stepper.place("speed")] = speed

    def rates(self, state):
        """Velocities and accelerations (8,) of a state (8,)."""
        place, velocity = state[:4], state[4:]
        self.stepper.inputs[self.places] = state
        if self.stepper.step() > 1:
            raise RuntimeError(f"the contact has no answer at {state}")
        (_, y, z), (about_x, about_y, about_z) = self.stepper.force, self.stepper.moment
        forces = np.array([y, z + LOAD, about_x * np.cos(place[3]) + about_y * np.sin(place[3]), about_z])
        forces -= SPRINGS * (place - self.rest) + DAMPERS * velocity
        turning = PITCH * self.speed / 0.46
        forces += turning * np.array([0.0, 0.0, -velocity[3], velocity[2]])
        return np.concatenate([velocity, forces / INERTIA])

    def lateral_shift(self, duration=DURATION, step=STEP, start=START):
        """Lateral shift (n,) [m] from a displaced ``start`` [m], at which the wheels carry their load."""
        state = np.concatenate([self.rest, np.zeros(4)])
        stands = self.system.evaluate(start, normal_force=LOAD / 2).equilibrium
        state[:3] = start, stands.vertical_shift, stands.roll
        found = []
        for _ in range(round(duration / step)):
            found.append(state[0])
            first = self.rates(state)
            second = self.rates(state + 0.5 * step * first)
            third = self.rates(state + 0.5 * step * second)
            fourth = self.rates(state + step * third)
            state = state + step / 6.0 * (first + 2.0 * second + 2.0 * third + fourth)
        return np.array(found)


def growth(shift, step=STEP):
    """Growth [1/s] of an oscillation, by its turning points after the first two."""
    turns = np.flatnonzero((shift[1:-1] - shift[:-2]) * (shift[2:] - shift[1:-1]) < 0.0)[2:] + 1
    sizes = np.abs(np.diff(shift[turns]))
    return np.polyfit(step * (turns[1:] + turns[:-1]) / 2.0, np.log(sizes), 1)[0]


def critical_speed_of_runs(system, near, apart=0.05):
    """Where the growth of runs at two speeds ``apart`` [of it] around a speed ``near`` [m/s] passes zero."""
    speeds = near * np.array([1.0 - apart, 1.0 + apart])
    slow, fast = (growth(Run(system, speed).lateral_shift()) for speed in speeds)
    return speeds[0] - slow * (speeds[1] - speeds[0]) / (fast - slow)


if __name__ == "__main__":
    folder = Path((sys.argv[1:] or ["."])[0])
    system = wrcontact.ContactSystem(contact_mode="compliant", tangential_model="strips")
    critical = critical_speed(system, 10.0, 80.0)
    run = critical_speed_of_runs(system, critical)
    print(f"critical speed {critical:.3f} m/s by eigenvalues, {run:.3f} m/s by runs")
    predicted = limit_cycle(system, CYCLE, 5.5e-3, 6.3e-3)
    shift = Run(system, CYCLE).lateral_shift(3.0, start=6.2e-3)
    found = np.ptp(shift[-len(shift) // 5 :]) / 2.0
    print(
        f"limit cycle at {CYCLE:g} m/s: {1e3 * predicted:.3f} mm by quasi-linear matrices, {1e3 * found:.3f} mm by a run"
    )
    speeds = np.linspace(5.0, 80.0, 151)
    save(
        root_locus_figure(speeds, [root(system, speed) for speed in speeds], critical),
        folder / "root_locus.png",
    )
    assert abs(run / critical - 1.0) < 0.01 and abs(predicted / found - 1.0) < 0.05
