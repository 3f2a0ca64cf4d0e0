"""Linear theory of the bogie in examples/vehicle, which knows nothing of the package, against the package's
derivatives and against the theory in data/hunting_theory.py; needs no exudyn.

Cones spin, and where friction has a limit that takes a share of the creep forces' slopes: of the longitudinal one
1.8 % at a friction of 2, 2.8 % at 1.  Kalker's coefficients know of no limit, the half-space does."""

import numpy as np
import pytest
from scipy.optimize import brentq

from data import hunting_theory
from data.hertz import hertz
from examples.vehicle import hunting, theory
from examples.vehicle import manchester as vehicle
from examples.vehicle.contact import CONES, FORCES, NEAR, Contact, contact_system
from wrcontact import creep_forces, elliptic_patch
from wrcontact.halfspace.rolling.extrapolation import roll_ellipse
from wrcontact.kernel.binding.library import default_kernel

LOAD, SPEED = vehicle.LOAD / 2, 80.0
kalker_slopes = theory.slopes
#: Motions of a wheelset in the theories: y, z, roll, yaw, their rates, the rotation.
MOTION = [
    list(NEAR).index(name)
    for name in (
        "lateral_shift",
        "vertical_shift_input",
        "roll_input",
        "yaw",
        "lateral_velocity",
        "vertical_velocity",
        "roll_rate",
        "yaw_rate",
        "wheel_rate",
    )
]
compiled = pytest.mark.skipif(
    not default_kernel().compiled,
    reason="the derivatives are those of the compiled library, and none is here",
)


def test_ellipse():
    along, across = np.cos(np.arctan(0.05)) / (2 * vehicle.WHEEL_RADIUS), 1 / (2 * theory.HEAD)
    assert theory.ellipse(LOAD) == pytest.approx(hertz(along, across, LOAD)[1:3], rel=1e-6)


def test_slopes_of_the_creep_forces():
    """Kalker's table against the package."""
    a, b = theory.ellipse(LOAD)
    patch = elliptic_patch(half_length=a, half_width=b, normal_force=LOAD)
    small = {"creepage_x": 1e-7, "creepage_y": 1e-7, "spin": 1e-5}
    found = [creep_forces(patch, friction=2.0, **{name: size}) for name, size in small.items()]
    found = -found[0].x / 1e-7, -found[1].y / 1e-7, abs(found[2].y) / 1e-5
    assert found == pytest.approx(theory.slopes(LOAD), rel=0.015)  # C23 1.1 %, C11 and C22 0.04 %


def slopes_beside_spin(load, friction):
    """As ``theory.slopes``: f11 and f22 by the half-space, beside the spin of the cones; f23 is Kalker's."""
    a, b = theory.ellipse(load)
    size = 1e-5 * friction

    def force(x, y):
        spin = theory.CONE / vehicle.WHEEL_RADIUS
        material = {"friction": friction, "shear_modulus": theory.SHEAR, "poisson_ratio": theory.POISSON}
        found = roll_ellipse(a, b, load, creepage_x=x, creepage_y=y, spin=spin, **material)
        return np.array([found.force_x, found.force_y])

    along = force(-size, 0.0) - force(size, 0.0)
    across = force(0.0, -size) - force(0.0, size)
    return np.array([along[0] / (2.0 * size), across[1] / (2.0 * size), kalker_slopes(load)[2]])


def by_package(speed, friction=hunting.FRICTION):
    """Forces (6,) of the steady motion in the middle, and their derivatives (6, 9)."""
    system = contact_system(**CONES)
    contact = Contact(system, LOAD, friction)
    motion = dict.fromkeys(NEAR, 0.0) | {"speed": speed, "wheel_rate": speed / vehicle.WHEEL_RADIUS}
    motion["vertical_shift_input"] = system.evaluate(0.0, normal_force=LOAD).equilibrium.vertical_shift
    for _ in range(8):
        force = contact.resultant(motion)
        by = contact.stepper.derivatives(FORCES, list(NEAR))
        change = np.linalg.solve(by[np.ix_([2, 4], [1, 9])], [force[2] + vehicle.LOAD, force[4]])
        motion["vertical_shift_input"] -= change[0]
        motion["wheel_rate"] -= change[1]
    force = contact.resultant(motion)
    assert force[[2, 4]] == pytest.approx([-vehicle.LOAD, 0.0], abs=1e-3)
    return force, contact.stepper.derivatives(FORCES, list(NEAR))[:, MOTION]


def by_closed_form(speed):
    """The same by data/hunting_theory.py."""
    rail_y = hunting.touching() + 0.3 * np.sin(np.arctan(0.05))
    inertia = [vehicle.WHEELSET.inertia[place] for place in (0, 2, 1)]
    model = hunting_theory.Wheelset(
        slope=0.05,
        rail_y=rail_y,
        coefficients=hunting_theory.COEFFICIENTS,
        mass=vehicle.WHEELSET.mass,
        inertia=tuple(inertia),
        load=vehicle.LOAD,
    )
    steady = hunting_theory.steady(model, speed)
    acting = [
        np.concatenate(hunting_theory.contact(model, steady + way, speed)[:2])
        for way in (*np.diag(hunting_theory.STEPS), *-np.diag(hunting_theory.STEPS))
    ]
    middle = np.concatenate(hunting_theory.contact(model, steady, speed)[:2])
    return middle, (np.array(acting[:9]) - acting[9:]).T / (2 * hunting_theory.STEPS)


def bogie_root(speed, contact):
    """Root of hunting of a bogie whose wheelsets move and roll as their contacts let them.

    Coordinates (11): y, z, roll, yaw of each wheelset; y, yaw, roll of the frame; and two rotations."""
    force, by = contact(speed)
    rows, gyro = [1, 2, 3, 5], vehicle.WHEELSET.inertia[1] * speed / vehicle.WHEEL_RADIUS
    mass, stiffness, damping, turned = np.zeros(11), np.zeros((11, 11)), np.zeros((11, 11)), np.zeros((11, 2))
    e = np.eye(11)

    def spring(k, d, way):
        stiffness[:] += k * np.outer(way, way)
        damping[:] += d * np.outer(way, way)

    (k_x, k_y, k_z), (d_x, d_y, d_z) = vehicle.SOFT.stiffness, vehicle.SOFT.damping
    for number, x in enumerate((vehicle.HALF_BASE, -vehicle.HALF_BASE)):
        y, z, roll, yaw = range(4 * number, 4 * number + 4)
        own = slice(y, yaw + 1)
        mass[own] = vehicle.WHEELSET.mass, vehicle.WHEELSET.mass, *vehicle.WHEELSET.inertia[::2]
        stiffness[own, own] -= by[rows, :4]
        damping[own, own] -= by[rows, 4:8]
        stiffness[roll, yaw] -= force[4]
        damping[roll, yaw] += gyro
        damping[yaw, roll] -= gyro
        turned[own, number] = by[rows, 8]
        up = vehicle.FRAME.height - vehicle.WHEEL_RADIUS
        spring(2 * k_y, 2 * d_y, e[y] - e[8] - x * e[9] + up * e[10])
        spring(2 * k_x, 2 * d_x, e[yaw] - e[9])
        spring(2 * k_z, 2 * d_z, e[z])
        spring(2 * k_z, 2 * d_z, e[roll] - e[10])
    mass[8:] = vehicle.FRAME.mass, *vehicle.FRAME.inertia[::-2]
    (s_x, s_y, s_z), (_, c_y, c_z) = vehicle.SECONDARY.stiffness, vehicle.SECONDARY.damping
    spring(2 * s_z + vehicle.ROLL_BAR, 2 * c_z, e[10])
    spring(2 * s_y, 2 * c_y, e[8] + (vehicle.SECONDARY_HEIGHT - vehicle.FRAME.height) * e[10])
    spring(2 * s_x, 0.0, e[9])
    state = np.zeros((24, 24))
    state[:11, 11:22] = np.eye(11)
    state[11:22] = np.hstack([-stiffness, -damping, turned]) / mass[:, None]
    for number in range(2):
        y = 4 * number
        state[22 + number, [*range(y, y + 4), *range(11 + y, 15 + y), 22 + number]] = (
            -by[4] / vehicle.WHEELSET.inertia[1]
        )
    return max((root for root in np.linalg.eigvals(state) if 1 < root.imag < 60), key=lambda root: root.real)


def check_hunting(contact, error):
    """Critical speed and frequency of a bogie with this ``contact`` against ``theory``'s."""
    half = hunting.touching()
    found = brentq(lambda speed: bogie_root(speed, contact).real, 70.0, 90.0, xtol=1e-3)
    assert found == pytest.approx(theory.critical_speed(half), rel=error)
    rate = bogie_root(SPEED, contact).imag
    assert rate == pytest.approx(theory.root(SPEED, half).imag, rel=6e-3)


def test_critical_speed_by_closed_form():
    check_hunting(by_closed_form, 2e-3)  # 0.08 %


@compiled
@pytest.mark.parametrize("friction", [1.0, hunting.FRICTION])
def test_critical_speed(friction, monkeypatch):
    """80.68 and 80.23 m/s for 80.61 and 80.02, and 80.15 with finer cells; by Kalker's slopes alone it would be
    79.67 for both."""
    kept = slopes_beside_spin(LOAD, friction)
    monkeypatch.setattr(theory, "slopes", lambda load: kept)
    check_hunting(lambda speed: by_package(speed, friction), 5e-3)


def test_a_swing_is_read():
    time = np.linspace(0.4, 2.0, 300)
    shifts = [
        size * np.exp(0.3 * time) * np.cos(25 * time + phase) + 1e-5 for size, phase in ((3e-4, 0), (2e-4, 1))
    ]
    growth, rate, missed = hunting.swing(time, np.array(shifts).T, 24.0)
    assert (growth, rate) == pytest.approx((0.3, 25.0), rel=1e-6) and missed < 1e-12
    assert hunting.critical_speed([70.0, 80.0, 90.0], [-1.0, 0.0, 1.2]) == pytest.approx(80.0)
