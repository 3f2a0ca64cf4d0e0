"""Small swings of a bogie below a car body that stands still: linear theory, without exudyn and wrcontact.

Seven coordinates: y and yaw of both wheelsets; y, yaw and roll of the frame.  Wheelsets roll as their cones
say, in proportion to y.  Hertz's patches (Johnson 1985, 4.26) and Kalker's coefficients.  Frames and signs
are those of docs/reference/conventions.md.
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
    modulus = SHEAR / (1 - POISSON)  # E / (2 (1 - nu^2)), of two bodies alike
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


def lean(load, half):
    """How far a wheelset rolls to the left for each metre that it goes to the right [rad/m], and the force to
    the left that comes of each N m of roll moment [1/m].

    The moment loads one wheel more and the other less; both push inwards with CONE of their load and outwards
    by the spin of the cones.  Without the spin the two numbers are equal, by virtual work.
    """
    inwards = CONE - slopes(load)[2] * CONE / data.WHEEL_RADIUS / load
    return (CONE / (half - data.WHEEL_RADIUS * CONE), inwards / (half - data.WHEEL_RADIUS * inwards))


def wheelset(speed, load, half):
    """Damping and stiffness (2, 2) of y and yaw of a wheelset on its rails.

    Parameters
    ----------
    speed : [m/s].
    load : of a wheel [N].
    half : how far beside the middle the wheels touch the rails [m].

    Returns
    -------
    damping, stiffness : creep forces, gyroscope, and what loads do: at y the contacts lie HEAD roll y to the
        other side of their rails, so that the wheels carry unlike, and normals and spin lean by the roll; a
        yaw takes the contacts, and the lateral forces in them, along the track.
    """
    f11, f22, f23 = slopes(load)
    radius, (roll, push) = data.WHEEL_RADIUS, lean(load, half)
    moved = 1 + radius * roll  # how far a contact goes across for each metre of y
    pushed = 1 + radius * push  # what its creep force is in y
    conicity = CONE * (1 + (radius + HEAD) * roll)  # the roll moves the contact along wheel and rail
    gyro = data.WHEELSET.inertia[1] * speed / radius
    damping = np.array(
        [
            [2 * f22 * moved * pushed / speed, 2 * f23 * pushed / speed - gyro * push],
            [gyro * roll - 2 * f23 * moved / speed, 2 * f11 * half**2 / speed],
        ]
    )
    spread = 2 * (load * CONE - f23 * CONE / radius) * half
    gravity = 2 * (load - f23 / radius) * roll * pushed + 2 * load * (1 + HEAD * roll) * push
    stiffness = np.array(
        [[gravity, -2 * f22 * pushed], [2 * f11 * half * conicity / radius, 2 * f23 - spread]]
    )
    return damping, stiffness


def matrices(speed, half, primary=data.SOFT):
    """Mass, damping and stiffness (7, 7) at ``speed`` [m/s]; ``half`` as in :func:`wheelset`."""
    roll, push = lean(data.LOAD / 2, half)
    across = data.WHEELSET.mass + data.WHEELSET.inertia[0] * roll * push
    mass = np.diag([across, data.WHEELSET.inertia[2]] * 2 + [data.FRAME.mass, *data.FRAME.inertia[::-2]])
    damping, stiffness = np.zeros((7, 7)), np.zeros((7, 7))

    def spring(k, d, pushes=None, **parts):
        longer = way(**parts)
        pushes = longer if pushes is None else pushes
        stiffness[:] += k * np.outer(pushes, longer)
        damping[:] += d * np.outer(pushes, longer)

    (k_x, k_y, k_z), (d_x, d_y, d_z) = primary.stiffness, primary.damping
    boxes = 2 * data.HALF_BOXES**2
    for number, x in enumerate((data.HALF_BASE, -data.HALF_BASE)):
        own = slice(2 * number, 2 * number + 2)
        more = wheelset(speed, data.LOAD / 2, half)
        damping[own, own] += more[0]
        stiffness[own, own] += more[1]
        up = data.FRAME.height - data.WHEEL_RADIUS
        spring(2 * k_y, 2 * d_y, **{f"y{number}": 1}, y=-1, yaw=-x, roll=up)
        spring(boxes * k_x, boxes * d_x, **{f"yaw{number}": 1}, yaw=-1)
        spring(boxes * k_z, boxes * d_z, way(**{f"y{number}": push}, roll=1), **{f"y{number}": roll}, roll=1)
    (k_sx, k_sy, k_sz), (_, d_sy, d_sz) = data.SECONDARY.stiffness, data.SECONDARY.damping
    springs = 2 * data.HALF_SPRINGS**2
    spring(springs * k_sz + data.ROLL_BAR, springs * d_sz, roll=1)
    spring(2 * k_sy, 2 * d_sy, y=1, roll=data.SECONDARY_HEIGHT - data.FRAME.height)
    spring(springs * k_sx, 0.0, yaw=1)
    return mass, damping, stiffness


def root(speed, half, primary=data.SOFT):
    """Growth [1/s] and circular frequency [rad/s] of hunting."""
    mass, damping, stiffness = matrices(speed, half, primary)
    state = np.block(
        [[np.zeros((7, 7)), np.eye(7)], [-np.linalg.solve(mass, stiffness), -np.linalg.solve(mass, damping)]]
    )
    found = [root for root in np.linalg.eigvals(state) if 1 < root.imag < 60]
    return max(found, key=lambda root: root.real)


def critical_speed(half, primary=data.SOFT, low=40.0, high=120.0):
    """Where hunting begins to grow [m/s]."""
    return brentq(lambda speed: root(speed, half, primary).real, low, high)
