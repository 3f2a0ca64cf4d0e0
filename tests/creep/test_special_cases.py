"""Where nothing rolls, presses or rubs, and other ends of the range: each has its value, and no NaN."""

from dataclasses import replace

import numpy as np
import pytest

from data.creep_cases import Model, all_shapes, full_slip, vector
from tests.helpers.cases import CREEP_MODELS, STRIP_MODELS
from wrcontact.creep import elliptic_patch, forces, outlined_patch
from wrcontact.kernel import layout
from wrcontact.methods import TangentialModel

MODELS = ("none", *CREEP_MODELS)
PATCH = elliptic_patch(6e-3, 4e-3, 8e4)


def everything(rolling):
    return [*vector(rolling), rolling.max_shear]


@pytest.mark.parametrize("name", MODELS)
def test_no_creepage_no_force(name):
    """Standing, or rolling without slip: all of the patch sticks where the model knows a stick zone."""
    for patch in all_shapes():
        found = Model(name).solve(patch, 0.0, 0.0, 0.0, 0.3)
        assert everything(found) == [0.0] * 4
        assert found.stick_share == pytest.approx(float(name in STRIP_MODELS), abs=1e-12)


@pytest.mark.parametrize("name", MODELS)
@pytest.mark.parametrize(("friction", "load"), [(0.0, 8e4), (0.3, 0.0), (0.0, 0.0)])
def test_without_friction_or_load_there_is_no_force(name, friction, load):
    found = Model(name).solve(elliptic_patch(6e-3, 4e-3, load), 1e-3, -2e-3, 0.5, friction)
    assert everything(found) == [0.0] * 4 and found.stick_share == 0.0


@pytest.mark.parametrize("name", MODELS)
def test_a_patch_that_is_not_there_has_no_force(name):
    """A lifted wheel: no load, no width, no strips."""
    model = Model(name)
    table = forces.model_tables(model.number, 210e9, 0.28)
    model.rolling.creepage_x, model.rolling.friction = 1e-3, 0.3
    forces.default_kernel().divide_into_strips(model.workspace)
    forces.default_kernel().solve_creep_force(table, model.workspace)
    assert everything(model.rolling) == [0.0] * 4
    assert all(
        np.isfinite([strip.y, strip.half_length, strip.line_load]).all() for strip in model.rolling.strips
    )


@pytest.mark.parametrize("name", MODELS[1:])
@pytest.mark.parametrize("slip", [(2.0, 0.0, 0.0), (1.99, 0.05, 0.4), (-2.0, -0.3, 0.0)])
def test_a_locked_wheel_slides(name, slip):
    """Creepage 2, of which spin and elasticity are no part any more: mu N against the slip."""
    bound = 0.3 * PATCH.normal_force
    found = Model(name).solve(PATCH, *slip, 0.3)
    wanted = -bound * np.array(slip[:2]) / np.hypot(*slip[:2])
    # FASTSIM with three flexibilities, and what is built on it, is some degrees off
    off = 0.02 if name in TangentialModel.family.with_keyword("published_spin") else 0.01
    np.testing.assert_allclose(vector(found)[:2], wanted, atol=off * bound)
    assert found.stick_share < 1e-6
    if name in STRIP_MODELS:
        # the largest traction at a point near the middle of the patch
        peak = 1.5 * PATCH.normal_force / (np.pi * 6e-3 * 4e-3)
        assert found.max_shear == pytest.approx(0.3 * peak, rel=0.03)


@pytest.mark.parametrize("name", MODELS[1:])
@pytest.mark.parametrize("scale", [1e-4, 1e-2, 1e2])
def test_patches_of_any_size_are_similar(name, scale):
    """Lengths s times, loads s^2 times: forces s^2 times at the same creepages and 1/s of the spin."""
    model = Model(name)
    for patch in all_shapes()[::3]:
        motion = np.array([0.8, -0.5, 1.1]) * full_slip(patch, 0.3)[0]
        force = vector(model.solve(patch, *motion, 0.3)) * (1.0, 1.0, scale)
        other = forces_of_scaled(model, patch, scale, motion / (1.0, 1.0, scale))
        np.testing.assert_allclose(other / scale**2, force, rtol=1e-9, atol=1e-9 * abs(force).max())


def forces_of_scaled(model, patch, scale, motion):
    """Force and moment (3,) of the patch enlarged ``scale`` times at equal pressures."""
    other = replace(
        patch,
        station=scale * patch.station,
        half_length=scale * patch.half_length,
        line_load=scale * patch.line_load,
        normal_force=scale**2 * patch.normal_force,
    )
    return vector(model.solve(other, *motion, 0.3))


@pytest.mark.parametrize("name", MODELS[1:])
def test_strips_without_load_are_left_out(name):
    """A patch with a gap in its middle is the sum of two, but for the ellipse that stands for its shape."""
    station = np.linspace(-8e-3, 8e-3, 65)
    shape = np.sqrt(np.clip(1.0 - ((np.abs(station) - 4.5e-3) / 3.5e-3) ** 2, 0.0, None))
    patch = outlined_patch(station, 4e-3 * shape, 1e9 * shape)
    scale, bound, size = full_slip(patch, 0.3)
    found = vector(Model(name).solve(patch, *(np.array([2e3, 0.0, 0.0]) * scale), 0.3))
    np.testing.assert_allclose(found, [-bound, 0.0, 0.0], atol=1e-3 * bound)
    some = Model(name).solve(patch, *(np.array([0.3, 0.4, 0.2]) * scale), 0.3)
    assert np.isfinite(everything(some)).all() and np.hypot(*vector(some)[:2]) < bound


@pytest.mark.parametrize("name", MODELS[1:])
def test_forces_are_finite_at_the_ends_of_numbers(name):
    """The smallest and the largest creepages that floating point has room for."""
    model = Model(name)
    for size in (5e-324, 1e-200, 1e-80, 1e-30, 1e20, 1e60):
        for direction in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, -1.0, 1.0)):
            found = everything(model.solve(PATCH, *(size * np.array(direction)), 0.3))
            assert np.isfinite(found).all(), (size, direction, found)
            assert np.hypot(*found[:2]) <= 0.3 * PATCH.normal_force * (1.0 + 1e-12)


def test_the_widest_patch_has_sixteen_strips_that_fill_it():
    """Cut of each patch: widths, load and middle of load are those of the patch; an ellipse to rounding."""
    model = Model("none")
    for patch in all_shapes():
        strips = model.solve(patch, 0.0, 0.0, 0.0, 0.3).strips
        width, load, y, a = np.array([(s.width, s.line_load, s.y, s.half_length) for s in strips]).T
        assert len(strips) == layout.ROLLING_STRIP_LIMIT
        assert width.sum() == pytest.approx(np.ptp(patch.station), rel=1e-12)
        assert width @ load == pytest.approx(patch.normal_force, rel=1e-12)
        # loads lie in the middles of their strips here
        assert abs(width @ (load * y)) < 2e-3 * patch.normal_force * np.ptp(patch.station)
        if patch.ellipse:
            b = patch.station[-1]
            edges = -b * np.cos(np.arange(17) * np.pi / 16)
            mean = np.diff(edges - edges**3 / (3.0 * b * b)) / np.diff(edges)
            np.testing.assert_allclose(a, patch.half_length.max() * np.sqrt(mean), rtol=1e-10)


def test_a_sheared_patch_is_what_its_strips_say():
    """Strips that are ahead have the lateral creepage eta + phi x there, and the moment x F_y besides.  In
    full slip by lateral creepage the lever is that of the centre of load, none."""
    model = Model("strips")
    straight = all_shapes()[2]
    sheared = replace(straight, slant=0.5)
    scale, bound, size = full_slip(straight, 0.3)
    one, two = (vector(model.solve(patch, 0.0, 1e3 * scale[1], 0.0, 0.3)) for patch in (straight, sheared))
    np.testing.assert_allclose(two, one, atol=1e-6 * bound)
    # with spin as well, w_y = eta + phi x is larger where the strips are ahead
    found = model.solve(sheared, 0.0, 0.0, 0.3 * scale[2], 0.3)
    ahead = sum(strip.force_y * strip.width for strip in found.strips if strip.x > 0.0)
    behind = sum(strip.force_y * strip.width for strip in found.strips if strip.x < 0.0)
    assert ahead < behind < 0.0


def test_the_strips_own_creepage_counts():
    """The coordinate system may hand each strip its own longitudinal creepage: half of them driven, half
    braked, give no force but a moment."""
    model = Model("strips")
    patch = all_shapes()[2]
    scale, bound, size = full_slip(patch, 0.3)
    model.solve(patch, 0.0, 0.0, 0.0, 0.3)
    for strip in model.rolling.strips:
        strip.slip = np.sign(strip.y) * 50.0 * scale[0]
    forces.default_kernel().solve_creep_force(forces.model_tables(model.number, 210e9, 0.28), model.workspace)
    found = vector(model.rolling)
    # the lever of half an ellipsoid's load is 3 b / 8
    assert found[2] == pytest.approx(bound * 3.0 / 8.0 * patch.station[-1], rel=0.01)
    assert abs(found[0]) < 1e-9 * bound and abs(found[1]) < 1e-9 * bound
