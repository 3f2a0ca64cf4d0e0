"""Creepages of a cone on rails with round heads, in closed form."""

from math import atan, cos, pi, sin, sqrt

import numpy as np
import pytest
from scipy.optimize import brentq

import wrcontact
from tests.helpers.cone import ARM, HEAD, RADIUS, cone_system, rail_place, stand
from tests.helpers.motion import runge_kutta, slips

SLOPES = (0.025, 0.05, 0.1)
SPEED = 30.0


@pytest.mark.parametrize("shift", [-6e-3, 0.0, 2e-3])
@pytest.mark.parametrize("slope", SLOPES)
def test_straight_ahead(slope, shift):
    """The wheel's circumference has the speed w r, and V_ref is the mean of it and V; the axle is inclined
    by the roll against a normal that has the cone's angle to it."""
    system = cone_system(slope)
    roll, _, *wheels = stand(slope, shift, rail_place(system))
    state = system.evaluate(lateral_shift=shift, speed=SPEED)
    assert state.roll == pytest.approx(roll, abs=1e-12)
    rate = SPEED / RADIUS
    for sign, wheel, found in zip((-1, 1), wheels, slips(state)):
        reference = (SPEED + rate * wheel.radius) / 2
        expected = (
            (SPEED - rate * wheel.radius) / reference,
            0.0,
            sign * rate * sin(atan(slope)) / reference,
        )
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-9)  # the place is known to 1e-7 m


@pytest.mark.parametrize("slope", SLOPES)
def test_yaw_slides_in_the_plane_of_the_contact(slope):
    """A wheel that stays on its rail and rolls at an angle to it: v lies in the plane of the contact, so that
    its lateral part is v_y / cos(angle), and v_y = -w (e2 x (P - C))_y."""
    yaw = 0.02
    state = cone_system(slope).evaluate(lateral_shift=3e-3, yaw=yaw, speed=SPEED)
    rate = SPEED / RADIUS
    for wheel, found in zip((state.left, state.right), slips(state)):
        at = wheel.contact
        down = at.z_track - (state.vertical_shift - RADIUS)
        # y_c points to the left, and the wheel slides to the left of where it heads: to the right of its path
        v_y = -rate * (at.x_track * sin(state.roll) + down * sin(yaw) * cos(state.roll))
        around_x = cos(yaw) * cos(state.roll) * down - sin(state.roll) * (at.y_track - 3e-3)
        reference = (SPEED + rate * around_x) / 2
        assert found[1] == pytest.approx(-v_y / cos(wheel.contact_angle) / reference, abs=1e-9)
        assert found[1] == pytest.approx(yaw, rel=0.02)


def test_a_wheelset_that_moves_sideways_climbs():
    """Its centre and roll follow the closed form, and the wheels slide by v_y / cos(angle)."""
    slope, shift, step, speed = 0.1, 4e-3, 1e-5, 0.05
    system = cone_system(slope)
    rail_y = rail_place(system)
    low, high = (stand(slope, shift + way * step, rail_y) for way in (-1, 1))
    roll_rate = (high[0] - low[0]) / (2 * step) * speed
    roll, height, *wheels = stand(slope, shift, rail_y)
    state = system.evaluate(lateral_shift=shift, speed=SPEED, lateral_velocity=speed)
    rate = SPEED / RADIUS
    for wheel, found in zip(wheels, slips(state)):
        down = height + HEAD * (1 - cos(wheel.angle))
        sideways = speed - roll_rate * down
        reference = (SPEED + rate * wheel.radius) / 2
        assert found[1] == pytest.approx(-sideways / cos(wheel.angle) / reference, abs=1e-9)
    # nearly all of it is the lateral velocity
    assert slips(state)[1][1] == pytest.approx(-speed / SPEED, rel=0.15)


@pytest.mark.parametrize("curvature", [1 / 300, -1 / 1500])
def test_free_rolling_through_a_steady_curve(curvature):
    """Where both wheels run through arcs in the ratio of their radii neither slides along the track.

    The rails' arcs at the contacts are as 1 - y times the curvature; with the shift -(curvature) b r0 / slope
    the cone's radii are in this ratio to first order. In a curve to the right the left wheel has more way to
    go, and the wheelset moves to the left."""
    slope = 0.1
    system = cone_system(slope)
    rail_y = rail_place(system)

    def unequal(shift):
        _, _, left, right = stand(slope, shift, rail_y)
        return left.radius * (1 - curvature * right.y) - right.radius * (1 - curvature * left.y)

    shift = brentq(unequal, -0.014, 0.014, xtol=1e-16)
    # the cone looks steeper with the roll: tests/conditioning/test_conicity.py
    steeper = slope / (1 - slope * (HEAD + RADIUS) / ARM)
    assert shift == pytest.approx(-curvature * ARM * RADIUS / steeper, rel=0.02)
    right = stand(slope, shift, rail_y)[3]
    rate = SPEED * (1 - curvature * right.y) / right.radius
    state = system.evaluate(lateral_shift=shift, speed=SPEED, wheel_rate=rate, track_curvature=curvature)
    for x, y, _ in slips(state):
        assert x == pytest.approx(0.0, abs=1e-9) and y == pytest.approx(0.0, abs=1e-12)
    # spin: the cone's, and the turning of the track about the normal
    turning = -curvature * cos(right.angle) + rate / SPEED * sin(atan(slope))
    assert slips(state)[1][2] == pytest.approx(turning, rel=2e-3)  # V_ref is not V


def test_klingels_motion():
    """A wheelset that rolls without sliding swings with Klingel's wave length 2 pi sqrt(b r0 / conicity).

    His wheelset does not roll about its x axis. With the roll the wheels slide by y' - r0 q' - yaw V, so that
    y' (1 - r0 dq/dy) = yaw V; dq/dy is about -slope / b, which makes the wave 1.5 % longer here.
    """
    slope, amplitude = 0.05, 1e-4
    system = cone_system(slope)
    roll, _, left, right = stand(slope, amplitude, rail_place(system))
    conicity = (right.radius - left.radius) / (2 * amplitude)
    arm = (right.y - left.y) / 2
    assert roll / amplitude == pytest.approx(-slope / ARM, rel=0.1)
    radius = (left.radius + right.radius) / 2
    klingel = 2 * pi * sqrt(arm * radius * (1 - radius * roll / amplitude) / conicity)
    assert wave_length(system, amplitude) == pytest.approx(klingel, rel=1e-4)


def wave_length(system, amplitude, step=0.05):
    """Wave length [m] of a wheelset that rolls without longitudinal creepage, and without lateral creepage in
    the mean of its wheels, from where it passes the middle; Runge and Kutta's method."""

    def course(state):
        """dy/dx and d(yaw)/dx."""
        return free_rates(system, *state)

    state, x, passed = np.array([amplitude, 0.0]), 0.0, []
    while len(passed) < 3:
        following = runge_kutta(course, state, step)
        if state[0] * following[0] < 0:
            passed.append(
                x
                + step
                * cubic_root(state[0], following[0], step * course(state)[0], step * course(following)[0])
            )
        state, x = following, x + step
    return passed[2] - passed[0]


def cubic_root(low, high, low_rate, high_rate):
    """Where a cubic with these ends and slopes passes zero, in 0 ... 1."""
    return brentq(
        lambda t: (
            low * (1 + 2 * t) * (1 - t) ** 2
            + high * t * t * (3 - 2 * t)
            + low_rate * t * (1 - t) ** 2
            - high_rate * t * t * (1 - t)
        ),
        0.0,
        1.0,
    )


def free_rates(system, shift, yaw):
    """Lateral velocity and yaw rate [per m of way] for which the wheels roll freely: creepages times V_ref
    are linear in the rates."""

    def slides(lateral, turn, rate):
        state = system.evaluate(
            lateral_shift=shift, yaw=yaw, speed=1.0, lateral_velocity=lateral, yaw_rate=turn, wheel_rate=rate
        )
        (x1, y1, _), (x2, y2, _) = slips(state)
        return np.array([x1, x2, y1 + y2])

    rates = np.array([0.0, 0.0, 1 / RADIUS])
    for _ in range(3):  # V_ref is not quite constant: Newton's method
        base = slides(*rates)
        steps = (1e-4, 1e-4, 1e-4)
        matrix = np.column_stack(
            [(slides(*(rates + h * axis)) - base) / h for h, axis in zip(steps, np.eye(3))]
        )
        rates = rates - np.linalg.solve(matrix, base)
    return rates[:2]


def test_klingel_with_a_profiles_own_conicity():
    """S1002 on UIC60 for a small amplitude: the radii of the wheels at +-amplitude say the conicity."""
    system = wrcontact.ContactSystem(rail_inclination=0.05, normal_model="hertz")
    amplitude = 5e-5
    state = system.evaluate(lateral_shift=amplitude)
    conicity = (state.right.rolling_radius - state.left.rolling_radius) / (2 * amplitude)
    arm = (state.right.contact.y_track - state.left.contact.y_track) / 2
    klingel = 2 * pi * sqrt(arm * RADIUS * (1 - RADIUS * state.roll / amplitude) / conicity)
    assert wave_length(system, amplitude, 0.2) == pytest.approx(klingel, rel=1e-3)
