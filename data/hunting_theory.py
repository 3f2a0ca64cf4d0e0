"""Linear theory of a wheelset with conical wheels on round rails, without anything of the package's.

Wheels are cones, exact in space; rails are cylinders along x.  The tangent plane of a cone along the
generator whose normal has no part along x touches the cylinder along a line, so that the contact is there in
closed form.  Normal forces are Hertz's, creep forces Kalker's linear theory.  Frames and signs are those of
docs/reference/conventions.md.  Equations of motion are those of the wheelset in examples/hunting_wheelset,
written anew.
"""

from dataclasses import dataclass

import numpy as np
from scipy.linalg import eigvals
from scipy.optimize import brentq, fsolve

from data.hertz import hertz

SHEAR = 210e9 / (2 * 1.28)
#: Steps of the differences: places [m, rad], and rates [m/s, rad/s].
STEPS = np.array([1e-8, 1e-8, 1e-8, 1e-8, 1e-6, 1e-6, 1e-6, 1e-6, 1e-6])


@dataclass(frozen=True)
class Wheelset:
    """Wheelset, springs between it and the frame, and the rails; SI.

    ``springs`` and ``dampers`` act across, down, in roll and in yaw, with the frame at the height 0;
    ``coefficients`` are Kalker's C11, C22, C23 and C33 of the patch; ``rail_y`` is where the rails' axes are.
    """

    slope: float
    rail_y: float
    coefficients: tuple
    mass: float = 1500.0
    inertia: tuple = (900.0, 900.0, 120.0)  # roll, yaw, pitch
    springs: tuple = (0.0, 0.0, 0.0, 0.0)
    dampers: tuple = (0.0, 0.0, 0.0, 0.0)
    load: float = 157e3
    head: float = 0.3
    radius: float = 0.46
    arm: float = 0.75


#: Kalker (1990), table E3, at nu 0.28 and a/b 1.330: C11, C22, C23, by parabolas in nu and linear in b/a;
#: C33 by CONTACT for a/b = 1, which hardly counts.
COEFFICIENTS = (4.555, 4.145, 1.870, 1.14)


def cones(touched, suspension):
    """A wheelset with cones 1:20 on a suspension, with the rail where the wheels touch it, ``touched`` [m]
    beside the middle."""
    across = 2 * suspension["lateral_stiffness"]
    return Wheelset(
        slope=0.05,
        rail_y=touched + 0.3 * np.sin(np.arctan(0.05)),
        coefficients=COEFFICIENTS,
        springs=(across, 0.0, 0.0, 2 * suspension["longitudinal_stiffness"]),
    )


def patch(model):
    """Depth [m] and semi-axes [m] of Hertz's patch at half the load."""
    across = 1 / (2 * model.head)
    along = np.cos(np.arctan(model.slope)) / (2 * model.radius)
    return hertz(along, across, model.load / 2)[:3]


def touch(model, side, place):
    """Point of the right (1) or left (-1) wheel, normal from the rail to the wheel, and depth [m]."""
    y, z, roll, yaw = place
    e1 = np.array([np.cos(yaw), np.sin(yaw), 0.0])
    e2 = np.array([-np.sin(yaw) * np.cos(roll), np.cos(yaw) * np.cos(roll), np.sin(roll)])
    e3 = np.cross(e1, e2)
    cone = np.arctan(model.slope)
    turn = np.arcsin(-side * np.tan(cone) * e2[0] / np.hypot(e1[0], e3[0])) - np.arctan2(e3[0], e1[0])
    radial = np.cos(turn) * e3 + np.sin(turn) * e1
    down = np.cos(cone) * radial + side * np.sin(cone) * e2
    start = np.array([0.0, y, z - model.radius]) + side * model.arm * e2 + model.radius * radial
    axis = np.array([0.0, side * model.rail_y, model.head])
    distance = (axis - start) @ down
    across = np.cross(down, [1.0, 0.0, 0.0])
    generator = side * e2 - model.slope * radial
    way = (axis - distance * down - start) @ across / (generator @ across)
    return start + way * generator, -down, model.head - distance, e2


def contact(model, state, speed):
    """Force (3,) and moment about the centre (3,) of both contacts, and the torque about the axle."""
    place, (across, down, rolling, yawing, rate) = state[:4], state[4:]
    depth, a, b = patch(model)
    c11, c22, c23, c33 = model.coefficients
    centre = np.array([0.0, place[0], place[1] - model.radius])
    force, moment = np.zeros(3), np.zeros(3)
    for side in (-1, 1):
        point, normal, sunk, e2 = touch(model, side, place)
        turning = np.array([rolling * np.cos(place[3]), rolling * np.sin(place[3]), yawing])
        arm, load = point - centre, model.load / 2 * (sunk / depth) ** 1.5
        ab = a * b * sunk / depth
        circumference = rate * np.cross(e2, arm)
        slip = np.array([speed, across, down]) + np.cross(turning, arm) - circumference
        mean = (speed + abs(circumference[0])) / 2
        forward = np.array([1.0, 0.0, 0.0])
        lateral = np.cross(normal, forward)
        xi, eta, phi = slip @ forward / mean, slip @ lateral / mean, (turning - rate * e2) @ normal / mean
        push = (
            load * normal
            - SHEAR * ab * c11 * xi * forward
            - SHEAR * ab * (c22 * eta + c23 * np.sqrt(ab) * phi) * lateral
        )
        force += push
        moment += np.cross(arm, push) - SHEAR * ab**1.5 * (-c23 * eta + c33 * np.sqrt(ab) * phi) * normal
    return force, moment, -moment @ e2


def accelerations(model, state, speed):
    """Of the shifts, of roll and yaw, and of the rotation about the axle: (5,)."""
    force, moment, torque = contact(model, state, speed)
    yaw = state[3]
    spin = model.inertia[2] * speed / model.radius
    push = np.array(
        [force[1], force[2] + model.load, moment[0] * np.cos(yaw) + moment[1] * np.sin(yaw), moment[2]]
    )
    push -= np.array(model.springs) * state[:4] + np.array(model.dampers) * state[4:8]
    push += spin * np.array([0.0, 0.0, -state[7], state[6]])
    inertia = np.array([model.mass, model.mass, *model.inertia])
    return np.append(push, torque) / inertia


def steady(model, speed):
    """The steady motion in the middle (9,): the height at which the load is carried, and the rotation at
    which nothing turns the axle."""
    high = (patch(model)[0] - touch(model, 1, np.zeros(4))[2]) / np.cos(np.arctan(model.slope))
    rolling = speed / model.radius

    def moved(unknown):
        state = np.zeros(9)
        state[1], state[8] = high + 1e-6 * unknown[0], rolling * (1 + 1e-3 * unknown[1])
        return state

    def missing(unknown):
        change = accelerations(model, moved(unknown), speed)
        return change[1], change[4]

    return moved(fsolve(missing, [0.0, 0.0], xtol=1e-9))


def state_matrix(model, speed):
    """Of the motion near the middle (9, 9): places, then rates."""
    state = steady(model, speed)
    matrix = np.zeros((9, 9))
    matrix[:4, 4:8] = np.eye(4)
    for k, step in enumerate(STEPS):
        move = step * np.eye(9)[k]
        matrix[4:, k] = (
            accelerations(model, state + move, speed) - accelerations(model, state - move, speed)
        ) / (2 * step)
    return matrix


def hunting_root(matrix):
    """The eigenvalue of the hunting motion, which is slower than those of the contacts' springs [1/s,
    rad/s]."""
    found = [root for root in eigvals(matrix) if 1e-3 < root.imag < 300.0]
    return max(found, key=lambda root: root.real)


def critical_speed(model, low, high):
    """Where hunting begins to grow [m/s], to 1e-6."""
    return brentq(lambda speed: hunting_root(state_matrix(model, speed)).real, low, high, xtol=1e-6)
