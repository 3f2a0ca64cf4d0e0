"""Coulomb's law cell by cell, the energy, symmetries, and wrong arguments."""

import math

import numpy as np
import pytest

from tests.helpers.creep import forces
from wrcontact.halfspace.rolling import Outline, PressureField, roll_outline, rolling_contact
from wrcontact.halfspace.rolling.newton import PRECISION

pytestmark = pytest.mark.check

MATERIAL = {"friction": 0.3, "shear_modulus": 82e9, "poisson_ratio": 0.28}
OUTLINE = Outline.of_ellipse(6e-3, 4e-3, 8e4)
LIMIT = 0.3 * 8e4
#: Creepages (xi, eta, phi [1/m]) from little to much slip.
MOTIONS = {
    "mostly stick": (-4e-4, 3e-4, 0.05),
    "half": (-1.5e-3, -1e-3, -0.4),
    "spin": (0.0, 0.0, 1.5),
    "opposed": (2e-4, 3e-3, -1.2),
    "all slips": (6e-3, -4e-3, 2.0),
}


def motion(values):
    return dict(zip(("creepage_x", "creepage_y", "spin"), values))


def solve(values, outline=OUTLINE, cells=30, **changed):
    return rolling_contact(outline.on_grid(cells, cells), **motion(values), **{**MATERIAL, **changed})


@pytest.mark.parametrize("values", MOTIONS.values(), ids=MOTIONS)
def test_coulombs_law_holds_in_every_cell(values):
    """To the solver's precision, in units of the largest bound; a slip counts by the traction it would
    change."""
    found = solve(values)
    p, s, bound = found.tractions, found.slip, 0.3 * found.field.pressure
    allowed = 2.0 * PRECISION * bound.max()
    assert np.all(np.hypot(*p) <= bound + allowed)
    sticks = ~found.slips & (bound > 0.0)
    stiffness = bound.max() / math.hypot(*values[:2], 4e-3 * values[2])
    assert np.all(np.hypot(*s[:, sticks]) * stiffness < 1e-3 * bound.max())
    direction = s[:, found.slips] / np.hypot(*s[:, found.slips])
    assert np.abs(p[:, found.slips] + bound[found.slips] * direction).max() < 2e-5 * bound.max()


@pytest.mark.parametrize("values", MOTIONS.values(), ids=MOTIONS)
def test_the_friction_power_is_the_work_of_the_forces(values):
    """No elastic energy is left behind in steady rolling: power over speed is -(Fx xi + Fy eta + Mz phi).
    What the cells leave over after extrapolation is 1.5 % of the power of full friction at most."""
    found = roll_outline(OUTLINE, **motion(values), **MATERIAL)
    work = -forces(found) @ values
    full = LIMIT * math.hypot(*values[:2], 4e-3 * values[2])
    assert found.dissipation == pytest.approx(work, abs=0.015 * full)
    assert found.dissipation >= 0.0 and found.coarse.dissipation >= 0.0


@pytest.mark.parametrize("values", MOTIONS.values(), ids=MOTIONS)
def test_reversed_motion_reverses_the_forces(values):
    allowed = 1e-5 * LIMIT
    reversed_motion = tuple(-each for each in values)
    assert forces(solve(reversed_motion)) == pytest.approx(-forces(solve(values)), abs=allowed)


@pytest.mark.parametrize("values", MOTIONS.values(), ids=MOTIONS)
def test_a_mirrored_patch_has_mirrored_forces(values):
    outline = Outline.of_stations(
        [-3e-3, -1e-3, 0.0, 2e-3, 5e-3],
        [0.0, 3e-3, 4e-3, 5e-3, 0.0],
        [0.0, 8e8, 9e8, 6e8, 0.0],
        [1e-3, 0.0, 0.0, -5e-4, 0.0],
    )
    mirrored = Outline(
        -outline.station[::-1],
        *(each[::-1] for each in (outline.half_length, outline.pressure, outline.middle)),
    )
    xi, eta, phi = values
    allowed = 1e-5 * 0.3 * outline.normal_force
    assert forces(solve((xi, -eta, -phi), mirrored)) == pytest.approx(
        forces(solve(values, outline)) * (1.0, -1.0, -1.0), abs=allowed
    )


def test_another_origin_is_the_same_motion():
    """Patch and pole of spin moved together: same forces, and a moment that belongs to them."""
    xi, eta, phi = MOTIONS["half"]
    x, y = 2e-3, -3e-3
    moved = Outline(OUTLINE.station + y, OUTLINE.half_length, OUTLINE.pressure, OUTLINE.middle + x)
    here, there = forces(solve((xi, eta, phi))), forces(solve((xi + phi * y, eta - phi * x, phi), moved))
    allowed = 1e-5 * LIMIT
    assert there[:2] == pytest.approx(here[:2], abs=allowed)
    assert there[2] - x * there[1] + y * there[0] == pytest.approx(here[2], abs=1e-2 * allowed)


def test_only_ratios_count():
    """Over mu N, forces depend on creepage times G ab / mu N alone; moments over mu N sqrt(ab)."""
    values = MOTIONS["half"]
    larger = Outline.of_ellipse(18e-3, 12e-3, 1.6e5)
    scale = (1.6e5 * 0.15) / (8e4 * 0.3) * 82e9 / 40e9 / 9.0
    other = solve(
        (scale * values[0], scale * values[1], scale / 3.0 * values[2]),
        larger,
        friction=0.15,
        shear_modulus=40e9,
    )
    assert forces(other) == pytest.approx(forces(solve(values)) * (1.0, 1.0, 3.0), abs=1e-5 * LIMIT)


def test_a_field_of_creepage_along_x():
    """What a strip's own rolling radius gives: -phi y in the creepage along x, without the spin's other
    part, is a linear slope over the rows."""
    field = OUTLINE.on_grid(24, 24)
    slope = rolling_contact(field, creepage_x=-1e-3 + 0.2 * field.y, creepage_y=0.0, spin=0.0, **MATERIAL)
    stations = roll_outline(
        OUTLINE, creepage_x=-1e-3 + 0.2 * OUTLINE.station, creepage_y=0.0, spin=0.0, **MATERIAL
    )
    assert forces(stations.coarse) == pytest.approx(forces(slope), abs=1e-5 * LIMIT)
    even = rolling_contact(field, creepage_x=-1e-3, creepage_y=0.0, spin=0.0, **MATERIAL)
    assert slope.moment != pytest.approx(even.moment, abs=0.01 * LIMIT * 5e-3)
    # rows at +y and -y differ from the middle one by as much
    first, last = np.sum(slope.line_loads()[0, :12]), np.sum(slope.line_loads()[0, 12:])
    assert first > last > 0.0


def test_without_creepage_there_is_no_force():
    assert np.all(forces(solve((0.0, 0.0, 0.0))) == 0.0)


@pytest.mark.parametrize(
    "name, value",
    [("friction", 0.0), ("friction", float("nan")), ("shear_modulus", -1.0), ("poisson_ratio", 0.6)],
)
def test_wrong_material_is_refused(name, value):
    with pytest.raises(ValueError, match=name):
        solve(MOTIONS["half"], **{name: value})


@pytest.mark.parametrize(
    "x, y, pressure, match",
    [
        ([0.0, 1.0, 3.0], [0.0, 1.0], np.ones((2, 3)), "x"),
        ([0.0, 1.0], [1.0, 0.0], np.ones((2, 2)), "y"),
        ([0.0, 1.0, 2.0], [0.0, 1.0], np.ones((3, 2)), "shape"),
        ([0.0, 1.0], [0.0, 1.0], np.zeros((2, 2)), "positive"),
        ([0.0, 1.0], [0.0, 1.0], [[1.0, -1.0], [1.0, 1.0]], "positive"),
    ],
)
def test_wrong_pressures_are_refused(x, y, pressure, match):
    with pytest.raises(ValueError, match=match):
        PressureField.of_cells(x, y, pressure)
