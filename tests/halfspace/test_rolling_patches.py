"""Solved patches of the kernel as outlines, and on the grid."""

import numpy as np
import pytest

from tests.helpers.inside import work_of
from tests.helpers.strips import system_of
from wrcontact import Status
from wrcontact.halfspace.rolling import Outline, outline_of_patch, roll_ellipse, roll_patch
from wrcontact.kernel import layout

A, B, FORCE = 6e-3, 4e-3, 8e4
MOTION = {
    "creepage_x": -1e-3,
    "creepage_y": -5e-4,
    "spin": -0.3,
    "friction": 0.3,
    "shear_modulus": 82e9,
    "poisson_ratio": 0.28,
}


def solved_ellipse(rule, count=41, station=3e-3, slant=0.0):
    """A Hertz patch whose middle is at ``station``, as a model of normal contact would fill it, and its
    strips."""
    strips, patch = layout.SolvedStrips(), layout.Patch()
    totals = patch.totals
    totals.load, totals.centroid, totals.moment = FORCE, station, FORCE * station
    totals.start, totals.stop, totals.width = station - B, station + B, 2.0 * B
    totals.max_half_length, totals.max_pressure = A, 1.5 * FORCE / (np.pi * A * B)
    patch.rule, patch.slant = rule, slant
    if rule == layout.RULE_ELLIPSE:
        totals.centroid = 0.0
        return strips, patch
    patch.first, patch.last = 0, count - 1
    for k in range(count):
        strip = strips[k]
        share = 2.0 * (k + 0.5) / count - 1.0
        strip.width = 2.0 * B / count
        strip.station = station + share * B
        strip.x = 2e-2 + slant * share * B
        strip.half_length_square = (1.0 - share**2) * A**2
        strip.pressure_square = (1.0 - share**2) * totals.max_pressure**2
        strip.line_load = 0.5 * np.pi * A * totals.max_pressure * (1.0 - share**2)
    return strips, patch


@pytest.mark.parametrize("rule", [layout.RULE_ELLIPSE, layout.RULE_QUADRATIC, layout.RULE_STRAIGHT])
def test_forces_of_an_elliptic_patch(rule):
    """Straight lines between 41 strips: 1e-3 of the friction limit."""
    strips, patch = solved_ellipse(rule)
    wanted, found = roll_ellipse(A, B, FORCE, **MOTION), roll_patch(strips, patch, **MOTION)
    limit = 0.3 * FORCE
    assert found.force_x == pytest.approx(wanted.force_x, abs=1e-3 * limit)
    assert found.force_y == pytest.approx(wanted.force_y, abs=1e-3 * limit)
    assert found.moment == pytest.approx(wanted.moment, abs=1e-3 * limit * 5e-3)
    assert found.max_shear <= 0.3 * patch.totals.max_pressure * (1.0 + 1e-6)


def test_a_slanted_patch_lies_around_its_centre_of_load():
    outline = outline_of_patch(*solved_ellipse(layout.RULE_STRAIGHT, slant=0.4))
    assert outline.middle == pytest.approx(0.4 * np.clip(outline.station, -B, B), abs=0.4 * B / 40)
    field = outline.on_grid(40, 40)
    x, y = np.meshgrid(field.x, field.y)
    assert np.average(x, weights=field.pressure) == pytest.approx(0.0, abs=1e-5)
    assert np.average(y, weights=field.pressure) == pytest.approx(0.0, abs=1e-5)
    assert field.normal_force == pytest.approx(FORCE)


@pytest.mark.parametrize("model", ["hertz", "analyn", "analyn_strip"])
@pytest.mark.parametrize("shift, yaw", [(1e-3, 0.0), (5.5e-3, 0.0), (3.5e-3, 0.02)], ids=str)
def test_patches_of_the_models(model, shift, yaw):
    """Load and position exactly; area and largest pressure to 2 %, what straight lines between the 9 nodes of
    the coarsest patch leave."""
    stepper = system_of(model).stepper()
    stepper.inputs[[layout.IN_LATERAL_SHIFT, layout.IN_YAW, layout.IN_NORMAL_FORCE]] = shift, yaw, 78.5e3
    assert stepper.step() == Status.VALID
    work = work_of(stepper)
    side = work.sides[1]  # the strips are those of the wheel that was solved last
    assert side.patch_count > 0
    for patch in side.patches[: side.patch_count]:
        field, totals = outline_of_patch(work.contact.strips, patch).on_grid(60, 60), patch.totals
        assert field.normal_force == pytest.approx(totals.load, rel=1e-9)
        assert field.y[[0, -1]] + totals.centroid == pytest.approx(
            [totals.start, totals.stop], abs=totals.width / 60
        )
        assert field.cover.sum() * field.cell_area == pytest.approx(totals.area, rel=0.02)
        assert field.pressure.max() == pytest.approx(totals.max_pressure, rel=0.02)
        assert np.average(field.y, weights=field.pressure.sum(axis=1)) == pytest.approx(
            0.0, abs=0.01 * totals.width
        )


def test_a_patch_without_load_is_refused():
    strips, patch = solved_ellipse(layout.RULE_STRAIGHT)
    for k in range(41):
        strips[k].line_load = -1.0
    with pytest.raises(ValueError, match="no loaded strip"):
        outline_of_patch(strips, patch)


def test_pressures_on_the_grid_are_those_of_the_ellipse():
    """Means over cells: exact along x, to 1e-3 of the largest across at the edge of the patch."""
    field = Outline.of_ellipse(A, B, FORCE).on_grid(31, 31)
    largest = 1.5 * FORCE / (np.pi * A * B)
    assert field.pressure[15, 15] == pytest.approx(largest * (1.0 - 2.0 / 6.0 / 31**2), rel=1e-4)
    x, y = np.meshgrid(field.x, field.y)
    inside = (x / A) ** 2 + (y / B) ** 2 < 0.8
    wanted = largest * np.sqrt(1.0 - (x[inside] / A) ** 2 - (y[inside] / B) ** 2)
    assert np.abs(field.pressure[inside] - wanted).max() < 1e-2 * largest
    assert field.cover.sum() * field.cell_area == pytest.approx(np.pi * A * B, rel=2e-3)
    assert np.all((field.cover >= 0.0) & (field.cover <= 1.0 + 1e-12))


@pytest.mark.parametrize(
    "station, half_length, match",
    [
        ([0.0, 1.0], [1.0, 1.0], "station"),
        ([0.0, 2.0, 1.0], [1.0, 1.0, 1.0], "station"),
        ([0.0, 1.0, 2.0], [0.0, 0.0, 0.0], "half_length"),
        ([0.0, 1.0, 2.0], [0.0, -1.0, 0.0], "half_length"),
    ],
)
def test_wrong_outlines_are_refused(station, half_length, match):
    with pytest.raises(ValueError, match=match):
        Outline.of_stations(station, half_length, [0.0, 1e9, 0.0][: len(station)])
