"""Rolling contact fatigue: check values, closed forms, and no jumps."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.wear_cases import MODELS, poses, system, table
from wrcontact.wear.fatigue import indices, line_shear, shakedown_limit, wear_number_damage

YIELD = 300e6


@pytest.mark.parametrize(
    "number, damage",
    [(10, 0.0), (20, 0.0), (40, 4.44e-6), (65, 9.9915e-6), (120, 4.992e-6), (175, 0.0), (300, 0.0)],
)
def test_damage_has_the_published_values(number, damage):
    assert wear_number_damage(number) == pytest.approx(damage, abs=1e-12)


def test_the_lines_of_the_damage_meet():
    """As published, with three digits: they miss each other by less than 1 %."""
    edges = np.array([20.0, 65.0, 175.0])
    below, beyond = wear_number_damage(edges * (1 - 1e-12)), wear_number_damage(edges)
    assert np.abs(below - beyond).max() < 1e-7
    other = wear_number_damage(np.array([14.9, 40.0, 65.0, 120.0, 175.1]), breaks=(15.0, 65.0, 175.0))
    top = 2.22e-7 * 65 - 4.44e-6
    assert other == pytest.approx([0.0, top * 0.5, top, top * 0.5, 0.0], abs=1e-15)


def test_the_indices_of_one_patch():
    """80 kN on half-axes of 7 and 5 mm, 24 kN of creep force, k = 300 MPa."""
    area = np.pi * 7e-3 * 5e-3
    read = {
        "normal_force": 80e3,
        "area": area,
        "length": 14e-3,
        "width": 10e-3,
        "max_pressure": 1.2e9,
        "creepage.x": 1e-3,
        "creepage.y": -2e-3,
        "tangential.x": 14.4e3,
        "tangential.y": 19.2e3,
    }
    found = indices(
        {name: np.array(value) for name, value in read.items()}, YIELD, wear_number_damage, (10.0, 4.0)
    )
    assert found.mean_peak == pytest.approx(1091.35e6, rel=1e-5)
    assert found.surface_fatigue_index == pytest.approx(0.02511, abs=1e-5)
    assert found.surface_damage == pytest.approx(3.976e-8, rel=1e-3)
    assert found.shakedown_ratio == pytest.approx(3.638, rel=1e-4)
    assert found.peak_index == pytest.approx(0.3 - 300 / 1200, rel=1e-12)
    assert found.wear_number == pytest.approx(14.4 + 38.4, rel=1e-12)
    assert found.subsurface_stress == pytest.approx(80e3 / (4 * np.pi * 7e-3 * 5e-3) * 1.09, rel=1e-12)


def test_the_wear_number_is_the_wheel_s():
    found = wrcontact.fatigue(table(), yield_shear=YIELD)
    for k, side in enumerate(("left", "right")):
        assert np.nansum(found.wear_number[:, k], axis=1) == pytest.approx(
            getattr(table(), side).wear_number, rel=1e-12
        )


def test_shakedown_of_a_line_contact():
    """4 without friction, 1 / friction where the surface yields, and one from the other at about 0.37."""
    assert shakedown_limit(0.0) == pytest.approx(4.0, rel=1e-3)
    high = np.array([0.38, 0.5, 1.0])
    assert shakedown_limit(high) == pytest.approx(1 / high, rel=1e-12)
    friction = np.linspace(0.3, 0.4, 101)
    below = friction[shakedown_limit(friction) < (1 / friction) * (1 - 1e-9)]
    assert below.max() == pytest.approx(0.367, abs=0.005)
    assert shakedown_limit(-0.5) == shakedown_limit(0.5)


def test_stresses_below_a_line_contact_are_flamant_s_integral():
    """Johnson (2.23) by a sum over the loaded strip."""
    s = np.cos(np.pi * (np.arange(20000) + 0.5) / 20000)
    weight = np.pi / 20000 * (1 - s * s)  # of sqrt(1 - s^2) ds
    for x, z in ((0.0, 0.5), (0.87, 0.3), (-1.4, 0.2), (0.4, 1.2)):
        r4 = ((x - s) ** 2 + z * z) ** 2
        normal = -2 * z * z / np.pi * np.sum(weight * (x - s) / r4)
        along = -2 * z / np.pi * np.sum(weight * (x - s) ** 2 / r4)
        assert line_shear(x, z) == pytest.approx((normal, along), abs=1e-6), (x, z)


def test_fatigue_has_no_jumps_in_the_load():
    """Where the steps of a sweep are halved, those of the indices are."""

    def steps(count):
        loads = np.linspace(20e3, 120e3, count)
        states = system().evaluate_many(
            1e-3, yaw=3e-3, normal_force=loads, speed=20.0, left_friction=0.5, right_friction=0.5
        )
        found = wrcontact.fatigue(states, yield_shear=YIELD, surface_life=(10.0, 4.0))
        names = ("damage", "surface_fatigue_index", "shakedown_ratio", "subsurface_stress", "surface_damage")
        return np.array([np.abs(np.diff(getattr(found, name)[:, 1, 0])).max() for name in names])

    coarse, fine = steps(401), steps(801)
    assert np.all(coarse > 0.0) and np.all(fine < 0.62 * coarse), fine / coarse


def test_direction_chooses_which_traction_counts():
    """A wheelset that turns faster than it rolls is driven, and the rail pushes it forward."""
    rates = 20.0 / 0.46 * np.array([1.003, 0.997, 1.002, 0.998])
    states = system().evaluate_many(0.0, speed=20.0, wheel_rate=rates, free_rolling=False)
    found = {
        name: wrcontact.fatigue(states, yield_shear=YIELD, direction=name).damage[:, 1, 0]
        for name in ("both", "driven", "braked")
    }
    assert np.all(states.right.patches[0].tangential.x[[0, 2]] > 0.0)
    assert np.all(found["both"] > 0.0)
    assert found["driven"] == pytest.approx(found["both"] * [1, 0, 1, 0])
    assert found["braked"] == pytest.approx(found["both"] * [0, 1, 0, 1])


def test_a_histogram_has_all_of_it():
    found, weights = wrcontact.fatigue(table(), yield_shear=YIELD), 2.0 * poses()[1]
    for part in ("wheel", "rail"):
        places, sums = found.histogram("damage", part, "left", width=0.5e-3, weights=weights)
        assert sums.sum() == pytest.approx(np.nansum(found.damage[:, 0] * weights[:, None]), rel=1e-12)
        assert np.diff(places) == pytest.approx(0.5e-3)
        there = getattr(table().left.contact, f"y_{part}")
        assert places[0] - 8e-3 < there.min() and there.max() < places[-1] + 8e-3


def test_one_state_is_a_table_of_one_row_and_needs_no_outputs_of_wear():
    plain = wrcontact.ContactSystem(**{**MODELS, "wear_outputs": False})
    found = wrcontact.fatigue(plain.evaluate(6e-3, yaw=5e-3, speed=20.0), yield_shear=YIELD)
    assert found.damage.shape == (1, 2, 3) and np.all(np.isnan(found.rail_place))
    with pytest.raises(ValueError, match="no places of patches"):
        found.histogram("damage")


@pytest.mark.parametrize(
    "given, words",
    [
        ({"yield_shear": 0.0}, "yield_shear is 0.0; permitted is yield_shear > 0 Pa"),
        ({"yield_shear": "300e6"}, "yield_shear is '300e6'; permitted is yield_shear > 0 Pa"),
        ({"yield_shear": YIELD, "direction": "up"}, "direction is 'up'; permitted are 'both'"),
    ],
)
def test_wrong_arguments_are_refused(given, words):
    with pytest.raises(ValueError, match=words):
        wrcontact.fatigue(table(), **given)


def test_a_number_is_no_table_and_one_weight_not_that_of_all_rows():
    with pytest.raises(ValueError, match="table is int; permitted is what evaluate"):
        wrcontact.fatigue(3, yield_shear=YIELD)
    found = wrcontact.fatigue(table(), yield_shear=YIELD)
    with pytest.raises(ValueError, match=f"weights has the shape .1,.; .* {len(table())} rows"):
        found.histogram("damage", weights=[1.0])


def test_tables_without_creep_forces_are_refused():
    with pytest.raises(ValueError, match="no creep forces; fatigue needs"):
        wrcontact.fatigue(wrcontact.ContactSystem().evaluate(0.0), yield_shear=YIELD)
