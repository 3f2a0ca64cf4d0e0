"""Rollers in the place of rails: against Hertz, grids over the roller in closed form, CONTACT, and the rail that a large one is."""

import json
from math import sqrt

import numpy as np
import pytest

from data.hertz import hertz
from tests.helpers.changing import CYLINDER, RADIUS, mirrored, smallest_gap
from tests.helpers.paths import DATA
from tests.helpers.sections import moved
from wrcontact import ContactSystem
from wrcontact.profiles import standard_profile
from wrcontact.profiles.placement import place_rail
from wrcontact.status import explain

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


# --- rollers that turn -------------------------------------------------------------------------------------------


def rolling(**more):
    return ContactSystem(
        rail="60E1",
        rail_inclination=1 / 40,
        roller_radius=ROLLER,
        contact_mode="compliant",
        normal_model="analyn_strip",
        tangential_model="strips",
        **more,
    )


def test_creepages_are_those_of_two_turning_bodies():
    """Velocities of both material points by cross products, at the place and in the plane that the patch reports."""
    system, rng = rolling(), np.random.default_rng(4260)
    rigid = ContactSystem(rail="60E1", rail_inclination=1 / 40, roller_radius=ROLLER)
    for _ in range(4):
        shift, yaw, ahead = rng.uniform(-4e-3, 4e-3), rng.uniform(-0.02, 0.02), rng.uniform(-5e-3, 5e-3)
        base = rigid.evaluate(lateral_shift=shift, yaw=yaw, track_position=ahead)
        pose = {
            "lateral_shift": shift,
            "yaw": yaw,
            "track_position": ahead,
            "roll_input": base.roll,
            "vertical_shift_input": base.vertical_shift + 8e-5,
            "speed": 10.0,
            "wheel_rate": 10.0 / RADIUS * (1.0 + rng.uniform(-2e-3, 2e-3)),
            "lateral_velocity": rng.uniform(-0.02, 0.02),
            "vertical_velocity": rng.uniform(-0.02, 0.02),
            "yaw_rate": rng.uniform(-0.01, 0.01),
        }
        patch = system.evaluate(**pose).right.patches[0]
        axle = np.array(
            [-np.sin(yaw) * np.cos(base.roll), np.cos(yaw) * np.cos(base.roll), np.sin(base.roll)]
        )
        place = np.array([patch.x_track, patch.y_track, patch.z_track])
        arm = place - [0.0, shift, pose["vertical_shift_input"] - RADIUS]
        turn = np.array([0.0, 0.0, pose["yaw_rate"]])
        rolled = np.cross(pose["wheel_rate"] * axle, arm)
        # an elastic wheel turns with the circumference that it has when it carries nothing
        rolled *= patch.rolling_radius / np.linalg.norm(arm - (arm @ axle) * axle)
        wheel = [0.0, pose["lateral_velocity"], pose["vertical_velocity"]] + np.cross(turn, arm) - rolled
        roller = np.cross([0.0, 10.0 / ROLLER, 0.0], place - [-ahead, 0.0, ROLLER])
        normal = system.evaluate(**{**pose, "speed": 0.0, "wheel_rate": 0.0, "lateral_velocity": 0.0, "vertical_velocity": 0.0,
                                    "yaw_rate": 0.0}).right.patches[0]  # fmt: skip
        normal = np.array([normal.force.x, normal.force.y, normal.force.z])
        normal /= np.linalg.norm(normal)
        along = np.array([-normal[2], 0.0, normal[0]])  # of the roller's surface and of its motion
        along /= np.linalg.norm(along)
        across = np.cross(normal, along)  # to the left
        speed = 0.5 * (10.0 * along[0] + abs(rolled @ along))
        slide = wheel - roller
        spin = (turn - pose["wheel_rate"] * axle - [0.0, 10.0 / ROLLER, 0.0]) @ normal
        assert patch.creepage.x == pytest.approx(slide @ along / speed, abs=1e-7), pose
        assert patch.creepage.y == pytest.approx(slide @ across / speed, abs=1e-7), pose
        assert patch.creepage.spin == pytest.approx(spin / speed, abs=1e-5), pose


def test_contact_has_the_same_creepages_and_creep_forces():
    """CONTACT's refer to another point of the patch: 0.2 mm times the spin, 3e-5.  Forces agree as on rails, where those of wide
    patches differ by a few per cent of the friction limit: each strip here rolls with its own radius."""
    system = rolling()
    for row in json.loads((DATA / "rollers.json").read_text())["rows"]:
        found = system.evaluate(
            lateral_shift=row["lateral_shift"],
            yaw=row["yaw"],
            roll_input=row["roll"],
            vertical_shift_input=row["z_ws"],
            speed=10.0,
            wheel_rate=row["wheel_rate"],
        )
        patch, limit = found.right.patches[0], 0.3 * row["normal_force"]
        assert -patch.creepage.x == pytest.approx(row["creepage_x"], abs=6e-5)
        assert patch.creepage.y == pytest.approx(row["creepage_y"], abs=1e-5)
        assert patch.creepage.spin == pytest.approx(row["spin"], rel=0.04)
        assert -patch.tangential.x == pytest.approx(row["force_x"], abs=0.07 * limit)
        assert -patch.tangential.y == pytest.approx(row["force_s"], abs=0.02 * limit)


def test_a_wheelset_turns_freely_on_rollers():
    """No torque is left, in every model; wheel and roller run at one speed but for the creep that spin needs."""
    for model in ("strips", "fastsim", "polach"):
        state = ContactSystem(roller_radius=ROLLER, tangential_model=model).evaluate(
            lateral_shift=2e-3, speed=20.0
        )
        assert state.status == 0
        limit = 0.3 * state.right.normal_force * RADIUS
        assert abs(state.driving_torque) < 1e-7 * limit
        assert state.right.wheel_rate_found == pytest.approx(20.0 / RADIUS, rel=5e-3)


def test_a_large_roller_that_turns_is_the_rail():
    kind = {"contact_mode": "compliant", "tangential_model": "strips", "contact_damping": 0.2}
    pose = {
        "lateral_shift": 1e-3,
        "yaw": 4e-3,
        "vertical_shift_input": 3e-4,
        "speed": 10.0,
        "lateral_velocity": 0.01,
    }
    pose |= {"vertical_velocity": 0.01, "yaw_rate": 0.01, "wheel_rate": 21.74}
    rail = ContactSystem(**kind).evaluate(**pose).right
    roller = ContactSystem(**kind, roller_radius=1000.0).evaluate(**pose).right
    for name, most in (("normal_force", 1e-3), ("damping_power", 1e-3), ("friction_power", 2e-3)):
        assert getattr(roller, name) == pytest.approx(getattr(rail, name), rel=most)
    assert roller.patches[0].tangential.y == pytest.approx(rail.patches[0].tangential.y, rel=2e-3)


# --- what is refused ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "given, sentence",
    [
        ({"roller_radius": -1.0}, "roller_radius is -1.0; permitted is 0 ... 1000 m"),
        ({"roller_radius": 0.02}, "roller_radius is 0.02 m, but the section of UIC60"),
        (
            {"rail": (moved([0.0, 0.5]), "UIC60"), "left_roller_radius": ROLLER, "contact_mode": "elastic"},
            "roller",
        ),
    ],
)
def test_what_is_refused(given, sentence):
    with pytest.raises(ValueError, match=sentence):
        ContactSystem(**given)


@pytest.mark.parametrize("mode", ["rigid", "elastic", "compliant"])
def test_a_roller_has_no_curve(mode):
    """Rails in a curve have two speeds, and rollers turn with one. The next good step counts."""
    system = ContactSystem(
        roller_radius=ROLLER, left_roller_radius=0.0, contact_mode=mode, tangential_model="polach"
    )
    pose = {"vertical_shift_input": 3e-4} if mode == "compliant" else {}
    curved = system.evaluate(**pose, speed=10.0, track_curvature=1e-3)
    assert curved.status == 4 and np.isnan(curved.right.area)
    assert explain(curved.status, curved.inputs) == "track_curvature is 0.001 1/m; permitted on a roller is 0"
    assert system.evaluate(**pose, speed=10.0).status == 0


def test_the_next_position_is_evaluated_after_one_too_far_ahead():
    system = ContactSystem(roller_radius=ROLLER)
    far = system.evaluate(track_position=0.5)
    assert far.status != 0 and np.isnan(far.right.area)
    assert system.evaluate(track_position=0.01).status == 0
