"""Friction in a patch: over the contact angle, over the sliding velocity and over the creepage on wet rails.

Witness: the laws from their papers in numpy, and Polach's formula with Kalker's table.
"""

import numpy as np
import pytest
from scipy.interpolate import CubicHermiteSpline

import wrcontact
from tests.helpers.cases import system
from tests.helpers.creep_witnesses import OF_FORCE, POISSON, YOUNG, kalker, polach

FRICTION, SHEAR = 0.3, YOUNG / (2 * (1 + POISSON))
#: Its wheels do not turn, so that all slides: the force is friction times load.
LOCKED = {"speed": 4.0, "free_rolling": False}


def share(patch):
    """Creep force over load."""
    return np.hypot(patch.tangential.x, patch.tangential.y) / patch.normal_force


@pytest.mark.parametrize("middle", [0.6, 0.4])
def test_friction_goes_over_to_the_flange_s_with_the_contact_angle(middle):
    """From one level to the other within 0.2 rad to either side of the middle, by the cubic that is level at
    both ends."""
    contact = system(tangential_model="polach", flange_friction_ratio=0.4, flange_friction_angle=middle)
    law = CubicHermiteSpline([middle - 0.2, middle + 0.2], [FRICTION, 0.4 * FRICTION], [0.0, 0.0])
    table = [contact.evaluate(shift, **LOCKED).right.patches for shift in np.linspace(5.2e-3, 7.6e-3, 49)]
    patches = [patch for found in table for patch in found]
    angles = np.array([patch.contact_angle for patch in patches])
    expected = law(np.clip(angles, middle - 0.2, middle + 0.2))
    # where all slides Polach's formula lacks 1e-3 of the friction limit
    np.testing.assert_allclose([share(patch) for patch in patches], expected, rtol=2e-3)
    # the ends of the range are asked as well as its middle
    places = np.histogram(angles, middle + np.array([-0.6, -0.2, -0.07, 0.07, 0.2, 0.6]))[0]
    assert (places > 0).all(), places


@pytest.mark.parametrize("across", [0.0, 0.9, -0.9])
def test_falling_friction_counts_the_sliding_across(across):
    """A locked wheel slides over its rail with the velocity of the wheelset: (V, v_y / cos(angle))."""
    fall = {"friction_fall": 0.4, "friction_fall_rate": 0.6}
    state = system(tangential_model="polach", **fall).evaluate(
        speed=1.2, free_rolling=False, lateral_velocity=across
    )
    for side in (state.left, state.right):
        patch = side.patches[0]
        sliding = np.hypot(1.2, across / np.cos(patch.contact_angle))
        expected = FRICTION * (0.6 * np.exp(-0.6 * sliding) + 0.4)
        # the wheelset rolls as well, by some thousandths of the lateral velocity; Polach's formula lacks 1e-3
        assert share(patch) == pytest.approx(expected, rel=3e-3)


#: Poses and motions by what leads: creepage along the track, across, spin on the flange root, and all.
WET_POSES = {
    "along": {"wheel_rate": 20.0 / 0.46 * 0.998},
    "across": {"yaw": 2e-3, "lateral_velocity": 0.01},
    "spin": {"lateral_shift": 6.0e-3, "wheel_rate": 20.0 / 0.46},
    "all": {"lateral_shift": 3e-3, "yaw": -1.5e-3, "wheel_rate": 20.0 / 0.46 * 1.001},
}


@pytest.mark.parametrize(
    "law",
    [
        {"slope_reduction": 0.5},
        {"slope_reduction": 0.4, "slope_reduction_rate": 0.8},
        {"slope_reduction_rate": 0.5},
        {"slope_reduction": 0.6, "slope_reduction_rate": 3.0, "slope_reduction_floor": 0.3},
    ],
    ids=str,
)
@pytest.mark.parametrize("pose", WET_POSES)
def test_wet_rails_have_the_slope_of_the_paper(pose, law):
    """k = k0 [alpha + (1 - alpha) / (1 + beta epsilon)], and Polach's formula with k times the creepages."""
    k0, alpha, beta = (
        law.get(f"slope_reduction{part}", start)
        for part, start in (("", 1.0), ("_floor", 0.02), ("_rate", 0.0))
    )
    state = system(tangential_model="polach", **law).evaluate(**{"speed": 20.0, **WET_POSES[pose]})
    for sign, side in ((-1.0, state.left), (1.0, state.right)):
        for patch in side.patches:
            ratio = patch.length / patch.width
            a, b = np.sqrt(patch.area / np.pi * ratio), np.sqrt(patch.area / np.pi / ratio)
            x, y, spin = patch.creepage.x, -sign * patch.creepage.y, -sign * patch.creepage.spin
            bound = FRICTION * patch.normal_force
            c11 = kalker(a, b, POISSON)[0]
            epsilon = SHEAR * np.pi * a * b * k0 * c11 * np.hypot(x, y + spin * a) / (4.0 * bound)
            k = k0 * (alpha + (1.0 - alpha) / (1.0 + beta * epsilon)) if beta else k0
            expected = polach(
                a=a,
                b=b,
                load=patch.normal_force,
                friction=FRICTION,
                shear_modulus=SHEAR,
                nu=POISSON,
                x=k * x,
                y=k * y,
                spin=k * spin,
            )
            found = patch.tangential.x, patch.tangential.y
            np.testing.assert_allclose(found, expected, rtol=0, atol=OF_FORCE * bound)


def test_dry_rails_are_the_limit_of_wet_ones():
    """beta to zero, and a floor of one."""
    given = {"lateral_shift": 3e-3, "yaw": 1e-3, "speed": 20.0}
    dry, *wet = (
        wrcontact.ContactSystem(tangential_model="polach", **law).evaluate(**given).right.force
        for law in (
            {},
            {"slope_reduction_rate": 1e-9},
            {"slope_reduction_rate": 5.0, "slope_reduction_floor": 1.0},
        )
    )
    for force in wet:
        np.testing.assert_allclose(force, dry, rtol=1e-8)
