"""Patches in which all slides: tractions are friction times pressure against the rigid slip, so that force,
moment and power are integrals over the ellipse.

Witness: Gauss's quadrature.  The patches are sheared, as a yawed wheel's, whose strips are ahead on one side.
"""

from dataclasses import replace

import numpy as np
import pytest

import wrcontact
from data.creep_cases import Model, full_slip, vector
from wrcontact.creep import elliptic_patch
from wrcontact.halfspace.rolling_step import roll_strips
from wrcontact.kernel.wheelset.rolling_contact import strip_shear, strip_slip

FRICTION, LOAD, YOUNG, POISSON = 0.3, 8e4, 210e9, 0.28
BOUND = FRICTION * LOAD


def sheared(ratio, slant):
    """An ellipse of ``ratio`` a/b, and its semi-axes [m]."""
    a, b = 5e-3 * ratio**0.5, 5e-3 * ratio**-0.5
    return replace(elliptic_patch(a, b, LOAD), slant=slant), a, b


def integrals(a, b, slant, slip):
    """Force x, y [N], moment [N m] (3,) and power over the rolling speed [N] of an ellipse that slides with
    the creepages and the spin ``slip`` (3,) at its middle."""
    s, weight = np.polynomial.legendre.leggauss(24)
    s, weight = 0.5 * (s + 1.0), 0.5 * weight
    turn = (np.arange(96) + 0.5) * np.pi / 48
    # p = p0 s with s^2 = 1 - r^2, and r dr = -s ds
    bound = (1.5 * BOUND / np.pi * s * s * weight * np.pi / 48)[:, None]
    radius = np.sqrt(1.0 - s * s)[:, None]
    y = b * radius * np.sin(turn)
    x = a * radius * np.cos(turn) + slant * y
    along, across = slip[0] - slip[2] * y, slip[1] + slip[2] * x
    whole = np.hypot(along, across)
    force_x, force_y = -bound * along / whole, -bound * across / whole
    return (
        np.array([force_x.sum(), force_y.sum(), (x * force_y - y * force_x).sum()]),
        (bound * whole).sum(),
    )


#: Creepages over those of the spin at sqrt(ab): spin alone, and beside creepage along, across and both.
SLIPS = [(0.0, 0.0, 1.0), (0.3, 0.0, 1.0), (0.0, 0.5, 1.0), (0.5, -0.5, 1.0)]


@pytest.mark.parametrize("slant", [0.5, -0.5])
@pytest.mark.parametrize("ratio", [0.5, 1.0, 3.0])
def test_forces_of_a_sheared_patch_are_integrals(ratio, slant):
    """Sixteen strips of sixteen points miss up to 0.7 % of them; a patch that is not sheared, or to the other
    side, has a force across and a moment that are 4 to 14 % off."""
    patch, a, b = sheared(ratio, slant)
    scale, _, size = full_slip(patch, FRICTION)
    for slip in SLIPS:
        slip = np.array(slip) * [size, size, 1.0] * 1e4 * scale[2]
        found = vector(Model("strips").solve(patch, *slip, FRICTION))
        expected, _ = integrals(a, b, slant, slip)
        unit = BOUND * np.array([1.0, 1.0, size])
        np.testing.assert_allclose(found / unit, expected / unit, rtol=0, atol=0.01)


@pytest.mark.parametrize("backwards", [False, True])
@pytest.mark.parametrize("slant", [0.5, -0.5])
def test_each_strip_has_the_power_of_its_place(slant, backwards):
    """Shear times slip of the strips, of which wear is computed; each strip's moment is about the patch's
    centre."""
    patch, a, b = sheared(1.0, slant)
    scale, _, size = full_slip(patch, FRICTION)
    slip = np.array([0.3 * size, -0.2 * size, 1.0]) * 1e4 * scale[2]
    model = Model("strips")
    model.rolling.backwards = backwards
    found = model.solve(patch, *slip, FRICTION)
    found.speed = 1.0
    _, power = integrals(a, b, slant, slip)
    total = sum(
        strip_shear(strip) * strip_slip(found, strip) * 2.0 * strip.half_length * strip.width
        for strip in found.strips
    )
    # backwards the tractions are against the slip as well
    assert total == pytest.approx(power, rel=0.01)


@pytest.fixture(scope="module")
def rolled():
    """A patch of strips that slides all over on the half-space, and its integrals."""
    patch, a, b = sheared(1.0, 0.5)
    scale, _, size = full_slip(patch, FRICTION)
    slip = np.array([0.3 * size, 0.0, 1.0]) * 2e3 * scale[2]
    model = Model("halfspace")
    found = model.solve(patch, *slip, FRICTION)
    roll_strips(found, shear_modulus=YOUNG / (2 * (1 + POISSON)), poisson_ratio=POISSON)
    return found, integrals(a, b, 0.5, slip)[0], size


def test_the_half_space_has_the_sheared_outline(rolled):
    """But for its grid."""
    found, expected, size = rolled
    unit = BOUND * np.array([1.0, 1.0, size])
    np.testing.assert_allclose(vector(found) / unit, expected / unit, rtol=0, atol=0.02)


def test_the_half_space_s_rows_add_up(rolled):
    """Moments of the strips about the patch's centre and the force along at their stations are the patch's
    moment; sixteen rows of a finer grid."""
    found, _, size = rolled
    force_y = sum(strip.force_y * strip.width for strip in found.strips)
    moment = sum((strip.moment - strip.y * strip.force_x) * strip.width for strip in found.strips)
    assert force_y == pytest.approx(found.creep_y, abs=0.02 * BOUND)
    assert moment == pytest.approx(found.creep_moment, abs=0.02 * BOUND * size)


#: A wheelset that slides sideways, and one that does not roll and turns about a place of its right patch.
#: Its slip and its force's direction run along straight lines from strip to strip, also past the place that
#: does not slide: there shear times slip is up to a tenth too large.
MOVES = {
    "across": (0.02, dict(speed=20.0, lateral_velocity=1.0)),
    "turning": (0.12, dict(speed=0.375, yaw_rate=0.5, free_rolling=False)),
}


@pytest.mark.parametrize("name", MOVES)
def test_shear_times_slip_of_a_wheel_is_its_power(name):
    """Under little friction all slides, and shear times slip over the outline is what friction takes, which
    is friction times pressure times the slip of each place."""
    allowed, motion = MOVES[name]
    contact = wrcontact.ContactSystem(tangential_model="strips", stations=201)
    state = contact.evaluate(1e-3, right_friction=0.01, **motion)
    patch, outline = state.right.patches[0], state.right.outline
    total = np.trapezoid(outline.shear * outline.slip * 2.0 * outline.half_length, outline.station)
    assert total == pytest.approx(state.right.friction_power, rel=allowed)
    # the rolling speed: the wheel that does not turn has half of the wheelset's
    speed = motion["speed"] * (1.0 if name == "across" else 0.5)
    assert state.right.friction_power == pytest.approx(0.01 * place_by_place(patch, outline, speed), rel=0.02)


def place_by_place(patch, outline, speed):
    """Integral of pressure times slip velocity over a patch [W]; in its plane with its spin."""
    t, weight = np.polynomial.chebyshev.chebgauss(16)
    weight = weight * (1.0 - t * t)  # of the root in the pressure
    y = -(outline.station - patch.centroid)  # spin turns to the left, the stations run to the right
    along = patch.creepage.x - patch.creepage.spin * y[:, None]
    across = patch.creepage.y + patch.creepage.spin * outline.half_length[:, None] * t
    whole = speed * np.hypot(along, across)
    return np.trapezoid(outline.pressure * outline.half_length * (whole @ weight), outline.station)
