"""A wheelset on cones below a frame that runs straight ahead, for any program of rigid bodies.

The body is free, with its axes at rest those of the track: x forward, y to the right, z down.  The program integrates
it, with gravity along z; :meth:`Wheelset.pushes` is all that acts on it besides.  :func:`theory` is its hunting in
closed form: Hertz's patch, Kalker's coefficients, two coordinates (examples/vehicle/theory.py).
"""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import curve_fit

import wrcontact

from ..vehicle import manchester
from ..vehicle import theory as linear

MASS, INERTIA = manchester.WHEELSET.mass, manchester.WHEELSET.inertia  # [kg], roll, pitch, yaw [kg m2]
RADIUS, GRAVITY = manchester.WHEEL_RADIUS, manchester.GRAVITY
#: What the frame puts on the wheelset, besides its weight [N].
FRAME = manchester.LOAD - MASS * GRAVITY
#: The motion of a wheelset, and what acts on it.
PLACES = ("lateral_shift", "vertical_shift_input", "roll_input", "yaw")
RATES = ("lateral_velocity", "vertical_velocity", "roll_rate", "yaw_rate", "wheel_rate")
ACTING = ("force.y", "force.z", "moment.x", "moment.y", "moment.z", "driving_torque")
#: Hunting is slower than a wheelset on the springs of its contacts [rad/s].
FASTEST = 100.0
#: Friction far from its limit, so that creep forces are linear.
FRICTION = 2.0
#: Recorded rows before this are not fitted: the wheelset finds its roll and its rotation [s].
SETTLED = 0.3


@dataclass(frozen=True)
class Springs:
    """Between frame and wheelset: across [N/m] and against yaw [N m/rad]."""

    across: float = 0.0
    yaw: float = 0.0


#: So soft that the wheelset nearly hunts.
SOFT = Springs(across=4e5, yaw=8e5)


class Wheelset:
    """What acts on the body, and where it starts: ``speed`` [m/s], ``shift`` to the right [m]."""

    def __init__(self, speed, springs=SOFT, shift=0.2e-3):
        self.system = wrcontact.ContactSystem(
            wheel="cone20",
            rail_inclination=1 / 20,
            contact_mode="compliant",
            normal_model="hertz",
            tangential_model="strips",
        )
        self.stepper = self.system.stepper(outputs="patches")
        for side in ("left", "right"):
            self.stepper.inputs[self.stepper.place(f"{side}.friction")] = FRICTION
        self.springs = springs
        stands = self.system.evaluate(lateral_shift=shift, normal_force=manchester.LOAD / 2).equilibrium
        self.position = np.array([0.0, shift, stands.vertical_shift - RADIUS])
        self.roll = stands.roll
        self.velocity = np.array([speed, 0.0, 0.0])
        self.angular_velocity = np.array([0.0, -speed / RADIUS, 0.0])

    def pushes(self, position, rotation, velocity, angular_velocity):
        """Force (3,) [N] and moment (3,) [N m] on the body at its centre, in the axes of the track.

        Parameters
        ----------
        position : (3,) of the centre [m] from the track's middle at the running surface.
        rotation : (3, 3), whose columns are the body's axes in those of the track.
        velocity, angular_velocity : (3,) in the axes of the track [m/s], [rad/s].
        """
        motion = wrcontact.motion_of(position, rotation, velocity, angular_velocity)
        force, moment = self.stepper.resultant(motion)
        force += [0.0, -self.springs.across * motion["lateral_shift"], FRAME]
        moment[2] -= self.springs.yaw * motion["yaw"]
        return force, moment


@dataclass
class Run:
    """Of a wheelset: ``time`` (n,) [s], ``distance`` (n,) along the track [m], ``shift`` (n,) [m]."""

    time: np.ndarray
    distance: np.ndarray
    shift: np.ndarray

    def hunting(self, guess):
        """Growth [1/s] and circular frequency [rad/s], as a complex number near a ``guess``."""
        return self._swing(self.time, guess)

    def wave(self, guess):
        """Length of the wave [m]: by distance, since spin brakes a wheelset that nothing drives."""
        return 2 * np.pi / self._swing(self.distance, complex(0.0, 2 * np.pi / guess)).imag

    def _swing(self, along, guess):
        """Growth and frequency of the swing along (n,) that fits the shifts."""

        def swing(along, growth, frequency, cosine, sine, middle):
            angle = frequency * along
            return np.exp(growth * along) * (cosine * np.cos(angle) + sine * np.sin(angle)) + middle

        late = self.time > SETTLED
        start = [guess.real, guess.imag, 0.1, 0.1, 0.0]
        found, _ = curve_fit(swing, along[late], self.shift[late] / 1e-3, start)
        return complex(*found[:2])


def _half(system):
    """How far beside the middle the wheels touch the rails [m]."""
    state = system.evaluate(normal_force=manchester.LOAD / 2, vertical_shift_input=1e-4)
    return (state.right.contact.y_track - state.left.contact.y_track) / 2


def theory(speed, springs=SOFT):
    """Growth [1/s] and circular frequency [rad/s] of hunting, as a complex number."""
    half = _half(Wheelset(speed).system)
    load = manchester.LOAD / 2
    damping, stiffness = linear.wheelset(speed, load, half)
    roll, push = linear.lean(load, half)
    mass = np.diag([MASS + INERTIA[0] * roll * push, INERTIA[2]])
    stiffness = stiffness + np.diag([springs.across, springs.yaw])
    state = np.block(
        [[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(mass, stiffness), -np.linalg.solve(mass, damping)]]
    )
    return max((root for root in np.linalg.eigvals(state) if root.imag > 0.1), key=lambda root: root.real)


def linear_motion(speed, springs=SOFT):
    """The same of the contact's own derivatives at the steady motion in the middle: nine rates of places and
    velocities, of a wheelset that also rolls, bounces and spins."""
    wheelset = Wheelset(speed, springs, shift=0.0)
    stepper, inputs = wheelset.stepper, [wheelset.stepper.place(name) for name in (*PLACES, *RATES)]
    stepper.inputs[stepper.place("speed")] = speed
    motion = np.zeros(9)
    motion[[1, 8]] = wheelset.position[2] + RADIUS, speed / RADIUS
    for _ in range(6):  # Newton: the load is carried, and nothing drives the axle
        stepper.inputs[inputs] = motion
        stepper.step()
        by = stepper.derivatives(ACTING, (*PLACES, *RATES))
        acting = stepper.outputs[[stepper.place(name) for name in ACTING]]
        missing = [acting[1] + manchester.LOAD, acting[5]]
        motion[[1, 8]] -= np.linalg.solve(by[np.ix_([1, 5], [1, 8])], missing)
    force_y, force_z, moment_x, _, moment_z, torque = by
    state, gyroscope = np.eye(9), INERTIA[1] * motion[8]
    roll, pitch, yaw = INERTIA
    matrix = np.vstack(
        [
            state[4:8],
            (force_y - springs.across * state[0]) / MASS,
            force_z / MASS,
            (moment_x + acting[3] * state[3] - gyroscope * state[7]) / roll,
            (moment_z - springs.yaw * state[3] + gyroscope * state[6]) / yaw,
            torque / pitch,
        ]
    )
    slow = [root for root in np.linalg.eigvals(matrix) if 0.1 < root.imag < FASTEST]
    return max(slow, key=lambda root: root.real)


def klingel():
    """Length of the wave of a wheelset that only rolls [m]: Klingel's 2 pi sqrt(b r / conicity), where the
    roll moves the contacts along wheel and rail."""
    half = _half(Wheelset(1.0).system)
    roll, _ = linear.lean(manchester.LOAD / 2, half)
    conicity = linear.CONE * (1 + (RADIUS + linear.HEAD) * roll)
    return 2 * np.pi * np.sqrt(half * RADIUS * (1 + RADIUS * roll) / conicity)


def report(run):
    """Print what ``run(wheelset, duration)`` makes of hunting at 20 m/s, and of a slow wheelset without
    springs."""
    found, near, wanted = run(Wheelset(20.0), 3.0).hunting(theory(20.0)), linear_motion(20.0), theory(20.0)
    print(
        f"hunting at 20 m/s: growth {found.real:.4f} 1/s, of the contact's derivatives {near.real:.4f}, "
        f"in closed form {wanted.real:.4f}; {found.imag:.4f} rad/s, {near.imag:.4f}, {wanted.imag:.4f}"
    )
    length = klingel()
    wave = run(Wheelset(5.0, Springs()), 5.0).wave(length)
    print(f"free at 5 m/s: wave of {wave:.4f} m, Klingel {length:.4f} m")
