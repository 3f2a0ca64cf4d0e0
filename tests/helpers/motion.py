"""Where a place on a moving wheelset is, by finite rotations, and the velocity that follows from it."""

import numpy as np


def about_x(angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])


def about_y(angle):
    """Positive for a wheel that rolls forward, which is a negative rotation about y."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, 0, -s], [0, 1, 0], [s, 0, c]])


def about_z(angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def velocity(
    place,
    *,
    centre,
    yaw,
    roll,
    speed=0.0,
    lateral=0.0,
    vertical=0.0,
    yaw_rate=0.0,
    roll_rate=0.0,
    wheel_rate=0.0,
    curvature=0.0,
    step=1e-6,
):
    """Velocity in space [m/s] of the wheel's material that is at ``place`` [m] of the track frame now.

    The wheelset is moved by ``step`` [s] forward and back; in a curve the track frame runs on a circle.
    """
    start = np.asarray(place, float) - centre
    in_wheelset = (about_z(yaw) @ about_x(roll)).T @ start

    def moved(t):
        turned = about_z(yaw + yaw_rate * t) @ about_x(roll + roll_rate * t) @ about_y(wheel_rate * t)
        in_track = centre + np.array([0, lateral, vertical]) * t + turned @ in_wheelset
        angle = speed * curvature * t
        along = speed * t
        origin = (
            (along, 0.0) if curvature == 0 else (np.sin(angle) / curvature, (1 - np.cos(angle)) / curvature)
        )
        return np.array([*origin, 0.0]) + about_z(angle) @ in_track

    return (moved(step) - moved(-step)) / (2 * step)


def sliding(*, place, radius, angle, sign, centre, yaw, roll, speed, wheel_rate, **rates):
    """Velocity of the wheel's surface against the rail (3,) [m/s] at a patch, its direction across (3,), its
    rotation about the patch's normal [rad/s], and the rolling speed [m/s], by finite displacements.

    place : centre of load of the patch [m].
    radius : of the wheel at the centre of load [m]; the wheel's surface is this far from the axle.
    angle : of the patch's normal, positive towards the flange [rad]; ``sign`` = 1 on the right, -1 on the
        left.
    """
    axle = about_z(yaw) @ about_x(roll) @ [0.0, 1.0, 0.0]
    place = np.asarray(place, float)
    away = place - centre - (place - centre) @ axle * axle
    surface = place + away * (radius / np.linalg.norm(away) - 1)
    lateral = np.cross([0.0, -sign * np.sin(angle), -np.cos(angle)], [1.0, 0.0, 0.0])
    moves = dict(centre=centre, yaw=yaw, roll=roll, speed=speed, **rates)
    slide = velocity(surface, wheel_rate=wheel_rate, **moves)
    rolling = slide - velocity(surface, **moves)
    # a rotation about the normal moves what lies to the left against x
    ahead = velocity(surface + 1e-3 * lateral, wheel_rate=wheel_rate, **moves)
    return slide, lateral, (slide[0] - ahead[0]) / 1e-3, (abs(speed) + abs(rolling[0])) / 2


def creepages(**given):
    """(x, y, spin) of a patch by finite displacements; arguments as :func:`sliding` has them."""
    slide, lateral, turning, reference = sliding(**given)
    return np.array([slide[0], slide @ lateral, turning]) / reference


def slips(state):
    """Creepages (patches, 3) of all patches of a state, left ones first: x, y, spin."""
    return np.array(
        [
            (patch.creepage.x, patch.creepage.y, patch.creepage.spin)
            for wheel in (state.left, state.right)
            for patch in wheel.patches
        ]
    )


def runge_kutta(rates, state, step):
    """The state (n,) after a step, by Runge and Kutta's method of fourth order."""
    k1 = rates(state)
    k2 = rates(state + step / 2 * k1)
    k3 = rates(state + step / 2 * k2)
    return state + step / 6 * (k1 + 2 * k2 + 2 * k3 + rates(state + step * k3))
