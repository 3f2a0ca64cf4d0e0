"""Laws with a closed form that see what other tests of wear did not."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.wear_cases import MODELS, energy, poses, system, table
from wrcontact.results.convert import columns_of
from wrcontact.wear.cells import _hats

SIDES = ("left", "right")


def test_each_wheel_wears_over_its_own_circumference():
    """Mass per metre of friction energy does not depend on the radius; the depth goes with one over it."""
    own = wrcontact.ContactSystem(**MODELS, left_nominal_radius=0.4)
    wear = wrcontact.Wear(own, energy)
    wear.add(own.evaluate_many([-3e-3, 0.0, 3e-3], speed=20.0))
    for side, radius in zip(SIDES, (0.4, 0.46)):
        wheel, rail = (wear.depth(f"{side}.{part}")[1] for part in ("wheel", "rail"))
        volumes = [
            each.sum() * wear.arcs[f"{side}.{part}"].width
            for each, part in ((wheel, "wheel"), (rail, "rail"))
        ]
        assert volumes[0] * 2.0 * np.pi * radius == pytest.approx(volumes[1], rel=1e-12)


def test_mirrored_shares_are_those_of_both_sides():
    law, share = wrcontact.Usfd(first=1e6, second=5e6), poses()[1]
    wears = [wrcontact.Wear(system(), law, mirrored=mirrored) for mirrored in (True, False)]
    for wear in wears:
        wear.add(table(), share)
    masses = [wears[1].mass(f"{side}.wheel") for side in SIDES]
    for name, both in wears[0].shares("wheel").items():
        each = [wears[1].shares(f"{side}.wheel")[name] for side in SIDES]
        assert both == pytest.approx(np.dot(each, masses) / np.sum(masses), rel=1e-12)
    assert wears[1].shares("left.wheel") != pytest.approx(wears[1].shares("right.wheel"), rel=0.01)


def test_the_error_of_one_pose_in_parts_of_any_length_is_none():
    """Equal poses that stand for unequal distances have the same mean in every sample."""
    inputs = {name: values[:1].repeat(20) for name, values in poses()[0].items()}
    wear = wrcontact.Wear(system(), energy)
    wear.add(system().evaluate_many(**inputs), distance=np.linspace(1.0, 30.0, 20))
    depth = wear.depth("right.wheel")[1]
    assert wear.error("right.wheel").max() < 1e-9 * depth.max()


def test_rows_of_an_unloaded_wheel_do_not_count():
    columns = {name: np.array(values, dtype=float) for name, values in columns_of(table()).items()}
    columns["status"][3] = 1.0
    wear = wrcontact.Wear(system(), energy)
    wear.add_fmu(columns, distance=1.0)
    assert (wear.rows, wear.left_out, wear.distance) == (59, 1, 59.0)


@pytest.mark.parametrize("values", [np.arange(1.0, 8.0), 3.0 - 0.4 * np.arange(7.0)])
def test_means_around_stations_integrate_a_line(values):
    """Of a function that is linear between stations, as a hat weights it: at an end 2/3 and 1/3."""
    found = _hats(values[None])[0]
    assert found[1:-1] == pytest.approx(values[1:-1], rel=1e-12)
    assert found[0] == pytest.approx((2 * values[0] + values[1]) / 3, rel=1e-12)
    assert found[-1] == pytest.approx((2 * values[-1] + values[-2]) / 3, rel=1e-12)


def test_a_step_is_as_long_as_the_side_that_wears_more_permits():
    def simulate(worn):
        return worn.evaluate_many(lateral_shift=np.full(2, 5e-3), yaw=4e-3, speed=20.0)

    wear = wrcontact.Wear(system(), energy)
    wear.add(simulate(system()))
    deepest = {side: wear.depth(f"{side}.wheel")[1].max() for side in SIDES}
    assert max(deepest.values()) > 2.0 * min(deepest.values())
    length = 1e-5 / max(deepest.values())
    first = wrcontact.wear_run(simulate, system(), energy, 1.5 * length, 1e-5, method="euler").steps[0]
    assert first.length == pytest.approx(length, rel=1e-12)


def test_a_histogram_begins_with_its_first_bin():
    """Each place in its own bin, by hand."""
    table_of = wrcontact.fatigue(table(), yield_shear=300e6)
    place = table_of.of_side("rail_place", "right")
    value = table_of.of_side("shakedown_ratio", "right")
    there = np.isfinite(place) & np.isfinite(value)
    places, sums = table_of.histogram("shakedown_ratio", "rail", "right", width=1e-3)
    for middle, one in zip(places, sums):
        inside = there & (np.abs(place - middle) < 0.5e-3)
        assert one == pytest.approx(value[inside].sum(), rel=1e-12, abs=1e-30)
    assert sums[0] == value[there & (place < places[0] + 0.5e-3)].sum() > 0.0
    assert places[0] - 0.5e-3 <= place[there].min() and sums.sum() == pytest.approx(
        value[there].sum(), rel=1e-12
    )
