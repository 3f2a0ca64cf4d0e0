"""Small swings of a bogie below a car body that stands still: linear theory, without exudyn and wrcontact.

Seven coordinates: y and yaw of both wheelsets; y, yaw and roll of the frame.  The wheels are cones that roll as
their cones say, so that the roll of a wheelset is s y.  Hertz's patches (Johnson 1985, 4.26) and Kalker's
coefficients.  Frames and signs are those of docs/conventions.md.
"""

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

from . import manchester as data

#: Cone 1:20, radius of the head [m], shear modulus [Pa] and Poisson's ratio of the wrcontact default.
CONE, HEAD, SHEAR, POISSON = 0.05, 0.3, 210e9 / (2 * 1.28), 0.28
#: Kalker (1990), table E3, at nu 0.28 and a/b 1.330, which is that of these radii: C11, C22, C23.
COEFFICIENTS = (4.555, 4.145, 1.870)
#: Coordinates, in this order.
NAMES = ("y0", "yaw0", "y1", "yaw1", "y", "yaw", "roll")


def ellipse(load):
    """Half-axes along and across [m] of a wheel on a rail."""
    along, across = 0.5 * np.cos(np.arctan(CONE)) / data.WHEEL_RADIUS, 0.5 / HEAD
    assert along < across

    def missing(m):
        return (ellipe(m) / (1 - m) - ellipk(m)) / (ellipk(m) - ellipe(m)) - across / along

    m = brentq(missing, 1e-9, 1 - 1e-9)
    modulus = SHEAR / (1 - POISSON)                 # E / (2 (1 - nu^2)), of two bodies alike
    a = (3 * load / (2 * np.pi * modulus) * ellipe(m) / (1 - m) / (along + across)) ** (1 / 3)
    return a, a * np.sqrt(1 - m)


def slopes(load):
    """Creep force by creepage, along, across, and across by spin: f11, f22 [N], f23 [N m]."""
    a, b = ellipse(load)
    c11, c22, c23 = COEFFICIENTS
    return SHEAR * a * b * np.array([c11, c22, c23 * np.sqrt(a * b)])


def way(**parts):
    """The elongation of a spring by the coordinates (7,)."""
    return np.array([parts.get(name, 0.0) for name in NAMES])


def wheelset(speed, load, half):
    """Damping and stiffness (2, 2) of y and yaw of a wheelset on its rails, whose wheels touch them ``half`` [m]
    beside the middle."""
    f11, f22, f23 = slopes(load)
    radius, roll = data.WHEEL_RADIUS, CONE / (half - data.WHEEL_RADIUS * CONE)      # roll by y [rad/m]
    lean = 1 + radius * roll                        # a point of the wheel goes so far across for each metre of y
    conicity = CONE * (1 + (radius + HEAD) * roll)  # the roll moves the contact along wheel and rail
    gyro = data.WHEELSET.inertia[1] * speed / radius * roll
    damping = np.array([[2 * f22 * lean**2 / speed, 2 * f23 * lean / speed - gyro],
                        [gyro - 2 * f23 * lean / speed, 2 * f11 * half**2 / speed]])
    stiffness = np.array([[0.0, -2 * f22 * lean],
                          [2 * f11 * half * conicity / radius, 2 * f23 - 2 * load * CONE * half]])
    return damping, stiffness


def matrices(speed, half, primary=data.SOFT):
    """Mass, damping and stiffness (7, 7) at ``speed`` [m/s]; ``half`` as in :func:`wheelset`."""
    roll = CONE / (half - data.WHEEL_RADIUS * CONE)
    across = data.WHEELSET.mass + data.WHEELSET.inertia[0] * roll**2
    mass = np.diag([across, data.WHEELSET.inertia[2]] * 2 + [data.FRAME.mass, *data.FRAME.inertia[::-2]])
    damping, stiffness = np.zeros((7, 7)), np.zeros((7, 7))

    def spring(k, d, **parts):
        stiffness[:] += k * np.outer(way(**parts), way(**parts))
        damping[:] += d * np.outer(way(**parts), way(**parts))

    (k_x, k_y, k_z), (d_x, d_y, d_z) = primary.stiffness, primary.damping
    boxes = 2 * data.HALF_BOXES**2
    for number, x in enumerate((data.HALF_BASE, -data.HALF_BASE)):
        own = slice(2 * number, 2 * number + 2)
        more = wheelset(speed, data.LOAD / 2, half)
        damping[own, own] += more[0]
        stiffness[own, own] += more[1]
        spring(2 * k_y, 2 * d_y, **{f"y{number}": 1}, y=-1, yaw=-x, roll=data.FRAME.height - data.WHEEL_RADIUS)
        spring(boxes * k_x, boxes * d_x, **{f"yaw{number}": 1}, yaw=-1)
    (k_sx, k_sy, k_sz), (_, d_sy, d_sz) = data.SECONDARY.stiffness, data.SECONDARY.damping
    springs = 2 * data.HALF_SPRINGS**2
    spring(2 * boxes * k_z + springs * k_sz + data.ROLL_BAR, 2 * boxes * d_z + springs * d_sz, roll=1)
    spring(2 * k_sy, 2 * d_sy, y=1, roll=data.SECONDARY_HEIGHT - data.FRAME.height)
    spring(springs * k_sx, 0.0, yaw=1)
    return mass, damping, stiffness


def root(speed, half, primary=data.SOFT):
    """Growth [1/s] and circular frequency [rad/s] of hunting."""
    mass, damping, stiffness = matrices(speed, half, primary)
    state = np.block([[np.zeros((7, 7)), np.eye(7)],
                      [-np.linalg.solve(mass, stiffness), -np.linalg.solve(mass, damping)]])
    return max((found for found in np.linalg.eigvals(state) if 1 < found.imag < 60), key=lambda found: found.real)


def critical_speed(half, primary=data.SOFT, low=40.0, high=120.0):
    """Where hunting begins to grow [m/s]."""
    return brentq(lambda speed: root(speed, half, primary).real, low, high)
