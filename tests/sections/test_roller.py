"""Rollers in the place of rails: against Hertz, grids over the roller in closed form, CONTACT, and the rail that a large one is."""

import json
from math import sqrt

import numpy as np
import pytest

from data.hertz import hertz
from tests.helpers.changing import CYLINDER, RADIUS, mirrored, smallest_gap
from tests.helpers.paths import DATA
from wrcontact import ContactSystem
from wrcontact.profiles import standard_profile
from wrcontact.profiles.placement import place_rail

RAIL, WHEEL, ROLLER = standard_profile("UIC60"), standard_profile("S1002"), 0.5


def turned(radius, inclination=0.0):
    """The height [m] of a right roller at track positions and track coordinates, in closed form."""
    placed = place_rail(RAIL, inclination=inclination, gauge=1.435, gauge_depth=0.014)

    def height(x, y):
        place = np.clip(y - placed.y_track, placed.profile.start, placed.profile.stop)
        here = radius - np.sqrt((radius - placed.profile.height(place)) ** 2 - x**2)
        return np.where(place == y - placed.y_track, here, np.nan)

    return height


def test_a_cylinder_on_a_crowned_roller_is_hertz():
    """Curvature along the track is that of both radii; UIC60 is a circle of 0.3 m where they touch."""
    system = ContactSystem(
        wheel=CYLINDER,
        rail_inclination=0.0,
        roller_radius=ROLLER,
        contact_mode="compliant",
        normal_model="hertz",
    )
    force = 20e3
    depth, a, b, peak = hertz(0.5 * (1.0 / RADIUS + 1.0 / ROLLER), 0.5 / 0.3, force)
    found = system.evaluate(vertical_shift_input=depth).right
    assert found.normal_force == pytest.approx(force, rel=1e-5)
    assert found.max_pressure == pytest.approx(peak, rel=1e-5)
    assert found.area == pytest.approx(np.pi * a * b, rel=1e-5)


@pytest.mark.parametrize("seed", range(2))
def test_touching_height_and_roll_are_those_of_grids(seed):
    """Random poses: both wheels of a rigid wheelset touch, to the height and roll of grids over the roller in closed form."""
    rng = np.random.default_rng(4200 + seed)
    system, roller = ContactSystem(rail_inclination=1 / 40, roller_radius=ROLLER), turned(ROLLER, 1 / 40)
    pose = {
        "lateral_shift": rng.uniform(-6e-3, 6e-3),
        "yaw": rng.uniform(-0.03, 0.03),
        "track_position": rng.uniform(-0.01, 0.01),
    }
    state = system.evaluate(**pose)
    assert state.status == 0, pose
    at = (pose["track_position"], pose["lateral_shift"], pose["yaw"], state.roll, state.vertical_shift)
    gaps = [smallest_gap(roller, WHEEL, one)[0] for one in (at, mirrored(at))]
    assert np.abs(gaps).max() < 2e-9, (pose, gaps)


def test_a_wheelset_ahead_of_the_rollers_stands_lower():
    """Cylinder on the crown: the centres of both circles stay R + r apart."""
    system = ContactSystem(
        wheel=CYLINDER,
        rail_inclination=0.0,
        roller_radius=ROLLER,
        contact_mode="compliant",
        normal_model="hertz",
    )
    depth, *_ = hertz(0.5 * (1.0 / RADIUS + 1.0 / ROLLER), 0.5 / 0.3, 20e3)
    ahead, apart = 5e-3, RADIUS + ROLLER
    down = apart - depth - sqrt((apart - depth) ** 2 - ahead**2)
    state = system.evaluate(track_position=ahead, vertical_shift_input=depth + down)
    assert state.right.normal_force == pytest.approx(20e3, rel=1e-5)
    # it slides down: the force on the wheel points ahead
    assert state.right.force.x == pytest.approx(20e3 * ahead / (apart - depth), rel=1e-3)


@pytest.mark.parametrize("mode", ["analyn", "analyn_strip"])
def test_contact_has_the_same_loads(mode):
    rows = json.loads((DATA / "rollers.json").read_text())["rows"]
    system = ContactSystem(
        rail="60E1",
        rail_inclination=1 / 40,
        roller_radius=ROLLER,
        contact_mode="compliant",
        normal_model=mode,
    )
    bar = {"analyn": (0.035, 0.06, 0.07), "analyn_strip": (0.004, 0.016, 0.006)}[mode]
    for row in rows:
        pose = {name: row[name] for name in ("lateral_shift", "yaw")}
        found = system.evaluate(vertical_shift_input=row["z_ws"], roll_input=row["roll"], **pose).right
        for name, most in zip(("normal_force", "area", "max_pressure"), bar):
            assert getattr(found, name) == pytest.approx(row[name], rel=most), (pose, name)


def test_a_large_roller_is_the_rail():
    """Loads differ by the share that the roller's curvature has in the sum: half as much with twice the radius."""
    kind = {"contact_mode": "compliant", "rail_inclination": 1 / 40}
    rail = ContactSystem(**kind)
    pose = {"lateral_shift": 1e-3, "yaw": 4e-3, "vertical_shift_input": 3e-4}
    load = rail.evaluate(**pose).right.normal_force
    parts = []
    for radius in (250.0, 500.0):
        found = ContactSystem(**kind, roller_radius=radius).evaluate(**pose).right.normal_force
        parts.append(1.0 - found / load)
    # Hertz: the load of a penetration falls with the square root of the curvature along, at most
    assert 0.0 < parts[0] < 0.5 * RADIUS / 250.0
    assert parts[0] / parts[1] == pytest.approx(2.0, rel=0.05)


def test_one_side_may_be_a_roller():
    both = ContactSystem(rail_inclination=1 / 40, roller_radius=ROLLER)
    right = ContactSystem(rail_inclination=1 / 40, roller_radius=(0.0, ROLLER))
    left = ContactSystem(rail_inclination=1 / 40, roller_radius=(ROLLER, 0.0))
    assert both.equal_sides and not right.equal_sides
    found = [one.evaluate() for one in (both, right, left)]
    assert found[1].right.area == pytest.approx(found[0].right.area, rel=1e-6)
    assert found[1].left.area == pytest.approx(found[2].right.area, rel=1e-6)
    assert found[1].left.area > 1.2 * found[0].left.area


@pytest.mark.parametrize(
    "given, sentence",
    [
        ({"roller_radius": -1.0}, "roller_radius is -1.0; permitted is 0 ... 1000 m"),
        ({"roller_radius": 0.02}, "roller_radius is 0.02 m, but the section of UIC60"),
        (
            {"roller_radius": ROLLER, "contact_mode": "elastic"},
            "contact_mode is 'elastic'; permitted with a roller are",
        ),
    ],
)
def test_what_is_refused(given, sentence):
    with pytest.raises(ValueError, match=sentence):
        ContactSystem(**given)


def test_the_next_position_is_evaluated_after_one_too_far_ahead():
    system = ContactSystem(roller_radius=ROLLER)
    far = system.evaluate(track_position=0.5)
    assert far.status != 0 and np.isnan(far.right.area)
    assert system.evaluate(track_position=0.01).status == 0
