"""Outputs of wear of patches on the half-space."""

import numpy as np
import pytest

from wrcontact import ContactSystem

POSE = {"lateral_shift": 6.2e-3, "yaw": 0.01, "speed": 20.0, "lateral_velocity": 0.05}


@pytest.mark.parametrize("mode", ["rigid", "elastic"])
@pytest.mark.parametrize("model", ["none", "strips", "halfspace"])
def test_stations_and_strips_have_all_the_power(model, mode):
    """And they lie where those of strips of the kernel do: patches differ by some hundredths of mm."""
    state = ContactSystem(
        normal_model="halfspace", tolerance=0.03, tangential_model=model, contact_mode=mode, wear_outputs=True
    ).evaluate(**POSE)
    other = ContactSystem(normal_model="analyn_strip", contact_mode=mode, wear_outputs=True).evaluate(**POSE)
    for wheel, known in ((state.left, other.left), (state.right, other.right)):
        line, power = wheel.outline, wheel.friction_power
        assert (power > 0.0) == (model != "none")
        assert abs(np.trapezoid(line.power, line.station) - power) <= 1e-12 * power
        for strips, patch in zip(wheel.strips, wheel.patches, strict=True):
            assert strips.power @ strips.width == pytest.approx(patch.friction_power, rel=1e-12)
            assert strips.line_load @ strips.width == pytest.approx(patch.normal_force, rel=1e-9)
        for name in ("wheel_place", "rail_place"):
            places, wanted = getattr(line, name), getattr(known.outline, name)
            assert (np.diff(places) > 0.0).all()
            # stations of the half-space run along the curve between wheel and rail
            found = np.interp(line.station[1:-1], known.outline.station, wanted)
            np.testing.assert_allclose(places[1:-1], found, atol=4e-5, err_msg=name)
        np.testing.assert_allclose(np.sort(np.unique(line.patch_of)), np.arange(1, wheel.patch_count + 1))


def test_the_complete_theory_on_the_kernel_s_patches():
    wheel = ContactSystem(tangential_model="halfspace", wear_outputs=True).evaluate(**POSE).right
    line = wheel.outline
    assert np.trapezoid(line.power, line.station) == pytest.approx(wheel.friction_power, rel=1e-12)
    known = ContactSystem(tangential_model="strips", wear_outputs=True).evaluate(**POSE).right
    np.testing.assert_array_equal(line.wheel_place, known.outline.wheel_place)
    # between the outermost strips, which have the value of the nearest row of cells
    np.testing.assert_allclose(
        wheel.strips[0].power[1:-1], known.strips[0].power[1:-1], atol=0.01 * known.strips[0].power.max()
    )
