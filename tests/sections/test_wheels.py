"""Wheels that are not round: closed forms of their height, grids, the round wheel that an eccentric one is, and energy."""

from functools import cache
from math import asin, cos, pi, sin, sqrt

import numpy as np
import pytest

from tests.helpers.changing import CYLINDER, RADIUS, mirrored, smallest_gap
from wrcontact import ContactSystem, Profile, RailSections, WheelSections
from wrcontact.profiles import standard_profile
from wrcontact.profiles.placement import place_rail
from wrcontact.profiles.zones import Polynomial
from wrcontact.status import explain

WHEEL, RAIL = standard_profile("S1002"), standard_profile("UIC60")
OFFSET = 1e-3


@cache
def round_height():
    """The vertical shift [m] of a round wheelset of cylinders."""
    return ContactSystem(wheel=CYLINDER, rail_inclination=0.0).evaluate().vertical_shift


def drop(wheel, chi):
    """By how much the centre of a wheelset of such wheels stands lower than that of round ones [m], and how far ahead they touch
    [m]."""
    state = system_of(wheel).evaluate(wheel_rotation=chi)
    assert state.status == 0, chi
    return state.vertical_shift - round_height(), state.right.contact.x_track


@cache
def system_of(wheel):
    return ContactSystem(wheel=wheel, rail_inclination=0.0)


# --- closed forms on a level rail --------------------------------------------------------------------------------


ECCENTRIC = WheelSections.eccentric(CYLINDER, OFFSET)


@pytest.mark.parametrize("chi", [0.3, 3.1, -2.0, 1000.0])
def test_an_eccentric_wheel_stands_on_its_circle(chi):
    down, ahead = drop(ECCENTRIC, chi)
    assert down == pytest.approx(-OFFSET * cos(chi), abs=1e-11)
    assert ahead == pytest.approx(-OFFSET * sin(chi), abs=1e-8)


@pytest.mark.parametrize(
    "order, amplitude, phase",
    [
        (3, 3e-4, 0.2),
        *(pytest.param(*one, marks=pytest.mark.full) for one in ((1, 5e-4, 0.4), (20, 1e-4, -0.1))),
    ],
)
def test_a_polygon_stands_on_its_lowest_place(order, amplitude, phase):
    """The greatest r cos(phi), where tan(phi) = r' / r: by Newton's method from the first order, phi = r' / r."""
    wheel = WheelSections.polygon(CYLINDER, order, amplitude, phase)
    for chi in (0.0, 0.05, 0.11, 2.0, -3.0):
        phi = 0.0
        for _ in range(100):
            label = order * (phi + chi - phase)
            r, rate = RADIUS + amplitude * cos(label), -amplitude * order * sin(label)
            phi = np.arctan2(rate, r)
        down, ahead = drop(wheel, chi)
        assert down == pytest.approx(RADIUS - r * cos(phi), abs=1e-10), chi
        assert ahead == pytest.approx(r * sin(phi), abs=1e-7), chi


LENGTH = 0.05


@pytest.mark.parametrize("chi", [-0.035, -0.0175, 0.012, 0.02, 0.05, 0.08, pi])
def test_a_fresh_flat_turns_about_its_edge(chi):
    """Johnson, or any book of geometry: the centre stands R cos(psi - |chi|) above the rail, with psi = asin(L / 2 R)."""
    half = asin(0.5 * LENGTH / RADIUS)
    within = max(half - abs(chi), 0.0)
    wheel = WheelSections.flat(CYLINDER, LENGTH, rounded=False, edge_radius=1e-4)
    down, ahead = drop(wheel, chi)
    assert down == pytest.approx(RADIUS * (1.0 - cos(within)), abs=1e-7)
    assert ahead == pytest.approx(np.sign(chi) * RADIUS * sin(within), abs=2e-5)


@pytest.mark.parametrize("chi", [-0.05, -0.01, 0.004, 0.03, 0.06])
def test_a_rounded_flat_stands_on_its_lowest_place(chi):
    wheel = WheelSections.flat(CYLINDER, LENGTH)
    depth = RADIUS - sqrt(RADIUS**2 - 0.25 * LENGTH**2)
    phi = np.linspace(-0.1, 0.1, 400_001)
    at = (phi + chi) * RADIUS / LENGTH
    r = RADIUS - np.where(np.abs(at) < 0.5, 0.5 * depth * (1.0 + np.cos(2.0 * pi * at)), 0.0)
    lowest = int(np.argmax(r * np.cos(phi)))
    down, ahead = drop(wheel, chi)
    assert down == pytest.approx(RADIUS - r[lowest] * cos(phi[lowest]), abs=3e-9)
    assert ahead == pytest.approx(r[lowest] * sin(phi[lowest]), abs=2e-5)


@pytest.mark.parametrize("rounded", [True, False])
def test_both_edges_of_a_flat_are_refused(rounded):
    """Standing on the flat a wheel touches at both edges: no single answer, so status 3, and the next pose is as before."""
    system = ContactSystem(wheel=WheelSections.flat(CYLINDER, LENGTH, rounded), rail_inclination=0.0)
    assert system.evaluate(wheel_rotation=0.0).status == 3
    assert system.evaluate(wheel_rotation=0.2).status == 0


# --- real profiles -----------------------------------------------------------------------------------------------


def right_rail():
    """The right rail, upright, as a function of track positions and track coordinates."""
    placed = place_rail(RAIL, inclination=0.0, gauge=1.435, gauge_depth=0.014)
    return lambda u, y: placed.profile.height(y - placed.y_track) + 0.0 * u


SHAPES = {
    "polygon": (
        WheelSections.polygon(WHEEL, 17, 8e-5, 0.3),
        lambda chi: lambda phi, r: 8e-5 * np.cos(17 * (phi + chi - 0.3)),
    ),
    "eccentric": (
        WheelSections.eccentric(WHEEL, OFFSET),
        lambda chi: (
            lambda phi, r: OFFSET * np.cos(phi + chi) + np.sqrt(r**2 - (OFFSET * np.sin(phi + chi)) ** 2) - r
        ),
    ),
}


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=pytest.mark.full)])
def test_touching_height_and_roll_are_those_of_grids(shape, seed):
    """Random poses with yaw: both wheels of a rigid wheelset touch where grids have them."""
    rng = np.random.default_rng(4230 + seed)
    wheel, deviation = SHAPES[shape]
    pose = {
        "lateral_shift": rng.uniform(-6e-3, 6e-3),
        "yaw": rng.uniform(-0.03, 0.03),
        "wheel_rotation": rng.uniform(-4.0, 4.0),
    }
    state = system_of(wheel).evaluate(**pose)
    assert state.status == 0, pose
    at = (0.0, pose["lateral_shift"], pose["yaw"], state.roll, state.vertical_shift)
    own = deviation(pose["wheel_rotation"])
    gaps = [smallest_gap(right_rail(), WHEEL, one, own)[0] for one in (at, mirrored(at))]
    assert np.abs(gaps).max() < 2e-9, (pose, gaps)


@pytest.mark.parametrize(
    "degrees", [-1.15, *(pytest.param(one, marks=pytest.mark.full) for one in (-2.4, 1.7))]
)
def test_a_flat_of_a_real_profile_stands_where_grids_have_it(degrees):
    """A fresh flat follows the profile; at -1.15 degrees a rounded one is nearly as hollow as the wheel is round."""
    chi, half = np.radians(degrees), asin(0.5 * LENGTH / RADIUS)
    chord = lambda phi, r: r * np.minimum(cos(half) / np.cos(np.clip(phi + chi, -half, half)) - 1.0, 0.0)  # noqa: E731
    depth = RADIUS - sqrt(RADIUS**2 - 0.25 * LENGTH**2)
    wave = lambda phi, r: (  # noqa: E731
        -0.5 * depth * (1.0 + np.cos(2.0 * pi * np.clip((phi + chi) * RADIUS / LENGTH, -0.5, 0.5)))
    )
    for rounded, own, most in ((False, chord, 2e-7), (True, wave, 1e-8)):
        state = system_of(WheelSections.flat(WHEEL, LENGTH, rounded)).evaluate(wheel_rotation=chi, yaw=5e-3)
        assert state.status == 0
        at = (0.0, 0.0, 5e-3, state.roll, state.vertical_shift)
        gaps = [smallest_gap(right_rail(), WHEEL, one, own)[0] for one in (at, mirrored(at))]
        assert np.abs(gaps).max() < most, gaps


@cache
def beside(model):
    kind = {"contact_mode": "compliant", "normal_model": model, "rail_inclination": 1 / 40}
    return (
        ContactSystem(wheel=SHAPES["eccentric"][0], **kind),
        ContactSystem(wheel=WHEEL, **kind),
        ContactSystem(wheel=WHEEL, rail_inclination=1 / 40),
    )


@pytest.mark.parametrize(
    "model", [*(pytest.param(one, marks=pytest.mark.full) for one in ("hertz", "analyn")), "analyn_strip"]
)
def test_an_eccentric_wheel_is_a_round_one_about_its_centre(model):
    """Loads, patches and places are those of the round wheelset whose centre is at that of the circles."""
    eccentric, whole, rigid = beside(model)
    rng = np.random.default_rng(4240)
    for _ in range(4):
        shift, yaw, chi = rng.uniform(-5e-3, 5e-3), rng.uniform(-0.02, 0.02), rng.uniform(-4.0, 4.0)
        touching = rigid.evaluate(lateral_shift=shift, yaw=yaw)
        roll, height = touching.roll, touching.vertical_shift + rng.uniform(4e-5, 1.2e-4)
        # the centre lies ahead by -e sin(chi) and below by e cos(chi), in the axes of the wheelset
        ahead, down = -OFFSET * sin(chi), OFFSET * cos(chi)
        aside = ahead * sin(yaw) - down * cos(yaw) * sin(roll)
        own = eccentric.evaluate(
            lateral_shift=shift - aside,
            yaw=yaw,
            roll_input=roll,
            vertical_shift_input=height - down * cos(roll),
            wheel_rotation=chi,
        )
        other = whole.evaluate(lateral_shift=shift, yaw=yaw, roll_input=roll, vertical_shift_input=height)
        pose = (shift, yaw, chi, height)
        assert own.status == other.status == 0, pose
        moved = ahead * cos(yaw) + down * sin(yaw) * sin(roll)
        for side in ("left", "right"):
            found, expected = getattr(own, side), getattr(other, side)
            # widths follow the curvature at points that lie elsewhere by the rounding of the wheel's table
            for name in ("normal_force", "penetration", "area", "max_pressure"):
                assert getattr(found, name) == pytest.approx(getattr(expected, name), rel=1e-3), (pose, name)
            if expected.normal_force:
                assert found.contact.x_track - moved == pytest.approx(expected.contact.x_track, abs=1e-6), (
                    pose
                )
                assert found.contact.y_track == pytest.approx(expected.contact.y_track, abs=1e-6), pose


def test_an_eccentric_wheel_on_a_ramp_is_a_round_one_about_its_centre():
    """Over a rail that rises 1:20 and moves, with yaw: loads, pressures and forces along the track."""
    u = np.linspace(-0.4, 0.4, 9)
    ramp = RailSections(u, [RAIL] * 9, places=np.column_stack([0.01 * u, -0.05 * u]))
    kind = {"rail": ramp, "contact_mode": "compliant", "normal_model": "analyn_strip"}
    eccentric, whole = ContactSystem(wheel=SHAPES["eccentric"][0], **kind), ContactSystem(wheel=WHEEL, **kind)
    rigid = ContactSystem(rail=ramp)
    for at, shift, yaw, chi in ((0.05, 1e-3, 0.01, 1.9), (-0.1, -3e-3, -0.015, -0.8)):
        touching = rigid.evaluate(track_position=at, lateral_shift=shift, yaw=yaw)
        roll, height = touching.roll, touching.vertical_shift + 8e-5
        ahead = np.array([cos(yaw), sin(yaw), 0.0])
        axle = np.array([-sin(yaw) * cos(roll), cos(yaw) * cos(roll), sin(roll)])
        offset = -OFFSET * sin(chi) * ahead + OFFSET * cos(chi) * np.cross(ahead, axle)
        own = eccentric.evaluate(
            track_position=at - offset[0],
            lateral_shift=shift - offset[1],
            yaw=yaw,
            roll_input=roll,
            vertical_shift_input=height - offset[2],
            wheel_rotation=chi,
        )
        other = whole.evaluate(
            track_position=at, lateral_shift=shift, yaw=yaw, roll_input=roll, vertical_shift_input=height
        )
        assert own.status == other.status == 0
        for side in ("left", "right"):
            found, expected = getattr(own, side), getattr(other, side)
            assert expected.normal_force > 1e4
            for name in ("normal_force", "area", "max_pressure"):
                assert getattr(found, name) == pytest.approx(getattr(expected, name), rel=1e-3), (side, name)
            assert found.force.x == pytest.approx(expected.force.x, rel=1e-3)
            assert found.contact.x_track - offset[0] == pytest.approx(expected.contact.x_track, abs=1e-6)
            places = [
                np.array([patch.x_track, patch.y_track, patch.z_track])
                for patch in (found.patches[0], expected.patches[0])
            ]
            np.testing.assert_allclose(places[0] - [offset[0], 0.0, 0.0], places[1], rtol=0.0, atol=1e-6)


def test_an_eccentric_wheel_rolls_as_a_round_one_about_its_centre():
    """Loads with damping, creep forces and powers of the round wheelset whose centre moves as that of the circles does; creepages
    refer to the speeds of the centre and of the axle."""
    kind = {
        "contact_mode": "compliant",
        "normal_model": "analyn_strip",
        "tangential_model": "strips",
        "rail_inclination": 1 / 40,
        "contact_damping": 0.5,
    }
    eccentric, whole = ContactSystem(wheel=SHAPES["eccentric"][0], **kind), ContactSystem(wheel=WHEEL, **kind)
    rigid, rng = beside("hertz")[2], np.random.default_rng(4250)
    for _ in range(4):
        shift, yaw, chi = rng.uniform(-5e-3, 5e-3), rng.uniform(-0.02, 0.02), rng.uniform(-4.0, 4.0)
        touching = rigid.evaluate(lateral_shift=shift, yaw=yaw)
        roll, height = touching.roll, touching.vertical_shift + rng.uniform(4e-5, 1e-4)
        motion = {
            "wheel_rate": 10.0 / RADIUS * (1.0 + rng.uniform(-2e-3, 2e-3)),
            "yaw_rate": rng.uniform(-0.01, 0.01),
            "roll_rate": rng.uniform(-0.01, 0.01),
        }
        ahead = np.array([cos(yaw), sin(yaw), 0.0])
        axle = np.array([-sin(yaw) * cos(roll), cos(yaw) * cos(roll), sin(roll)])
        offset = -OFFSET * sin(chi) * ahead + OFFSET * cos(chi) * np.cross(ahead, axle)
        turn = motion["roll_rate"] * ahead + [0.0, 0.0, motion["yaw_rate"]] - motion["wheel_rate"] * axle
        velocity = np.array([10.0, rng.uniform(-0.02, 0.02), rng.uniform(-0.02, 0.02)])
        names = ("speed", "lateral_velocity", "vertical_velocity")
        own = eccentric.evaluate(
            lateral_shift=shift - offset[1],
            yaw=yaw,
            roll_input=roll,
            vertical_shift_input=height - offset[2],
            wheel_rotation=chi,
            **motion,
            **dict(zip(names, velocity)),
        )
        other = whole.evaluate(
            lateral_shift=shift,
            yaw=yaw,
            roll_input=roll,
            vertical_shift_input=height,
            **motion,
            **dict(zip(names, velocity + np.cross(turn, offset))),
        )
        pose = (shift, yaw, chi, height, motion, velocity)
        assert own.status == other.status == 0, pose
        for side in ("left", "right"):
            found, expected = getattr(own, side), getattr(other, side)
            if expected.normal_force > 0.0:
                assert found.normal_force == pytest.approx(expected.normal_force, rel=2e-4), pose
                assert found.damping_power == pytest.approx(expected.damping_power, rel=2e-3, abs=0.01), pose
                assert found.friction_power == pytest.approx(expected.friction_power, rel=2e-3), pose
                limit = 0.3 * expected.normal_force
                for name in ("x", "y"):
                    force = getattr(expected.patches[0].tangential, name)
                    assert getattr(found.patches[0].tangential, name) == pytest.approx(
                        force, abs=2e-3 * limit
                    ), pose


def test_a_rigid_wheelset_rises_as_its_wheels_turn():
    """Its creepages are those of a compliant wheelset with the vertical velocity and roll rate that differences of height and roll
    over the rotation have."""
    kind = {"rail_inclination": 0.0, "normal_model": "hertz", "tangential_model": "strips"}
    rigid, compliant = (
        ContactSystem(wheel=SHAPES["polygon"][0], contact_mode=mode, **kind)
        for mode in ("rigid", "compliant")
    )
    step, rate, pose = 1e-5, 20.0, {"lateral_shift": 4e-3, "yaw": 2e-3, "speed": 9.2, "wheel_rate": 20.0}
    at = [rigid.evaluate(**pose, wheel_rotation=0.33 + part * step) for part in (-1.0, 0.0, 1.0)]
    rates = {
        name: rate * (getattr(at[2], field) - getattr(at[0], field)) / (2.0 * step)
        for name, field in (("vertical_velocity", "vertical_shift"), ("roll_rate", "roll"))
    }
    assert abs(rates["vertical_velocity"]) > 0.01
    given = {
        "roll_input": at[1].roll,
        "vertical_shift_input": at[1].vertical_shift + 1e-7,
        "wheel_rotation": 0.33,
    }
    moved, still = compliant.evaluate(**pose, **given, **rates), compliant.evaluate(**pose, **given)
    for side in ("left", "right"):
        own, other, without = (getattr(one, side).patches[0].creepage.y for one in (at[1], moved, still))
        assert abs(other - without) > 2e-5 and own == pytest.approx(other, abs=0.02 * abs(other - without))


def test_pressure_has_the_torque_of_the_energy_that_it_takes():
    """Turning at one height: the moment about the axle is what the load times the rise of the wheel takes, and a whole turn leaves
    nothing."""
    offset, kind = 5e-5, {"contact_mode": "compliant", "rail_inclination": 0.0}
    eccentric = ContactSystem(wheel=WheelSections.eccentric(CYLINDER, offset), normal_model="hertz", **kind)
    chi = np.linspace(-pi, pi, 73)
    table = eccentric.evaluate_many(
        vertical_shift_input=1.2 * offset,
        wheel_rotation=chi,
        outputs=["right.normal_force", "right.moment.y"],
    )
    assert (table.status == 0).all()
    power = -np.asarray(table.right.normal_force) * offset * np.sin(chi)
    largest = np.abs(power).max()
    assert largest > 1.0
    assert np.allclose(np.abs(table.right.moment.y), np.abs(power), atol=0.02 * largest)
    assert abs(np.trapezoid(table.right.moment.y, chi)) < 1e-6 * largest


def test_whole_turns_change_nothing_and_left_wheels_turn_alike():
    system = system_of(SHAPES["polygon"][0])
    one = system.evaluate(lateral_shift=1e-3, yaw=4e-3, wheel_rotation=0.5)
    other = system.evaluate(lateral_shift=1e-3, yaw=4e-3, wheel_rotation=0.5 + 20.0 * pi)
    mirror = system.evaluate(lateral_shift=-1e-3, yaw=-4e-3, wheel_rotation=0.5)
    assert other.right.area == pytest.approx(one.right.area, rel=1e-9)
    assert mirror.left.area == one.right.area and mirror.left.contact.x_track == one.right.contact.x_track


def test_one_wheel_of_two_and_a_changing_rail():
    """A wheel that is not round beside a round one, and over a rail that dips."""
    polygon = SHAPES["polygon"][0]
    both = system_of(polygon).evaluate(wheel_rotation=0.3)
    one = ContactSystem(wheel=(WHEEL, polygon), rail_inclination=0.0).evaluate(wheel_rotation=0.3)
    other = ContactSystem(wheel=(polygon, WHEEL), rail_inclination=0.0).evaluate(wheel_rotation=0.3)
    assert one.roll == pytest.approx(-other.roll, abs=1e-12) and one.roll != 0.0
    assert one.vertical_shift == pytest.approx(
        0.5 * (both.vertical_shift + system_of(WHEEL).evaluate().vertical_shift), abs=1e-7
    )
    rail = RailSections([0.0, 1.0], [RAIL] * 2)
    over = ContactSystem(wheel=polygon, rail=rail).evaluate(track_position=0.4, wheel_rotation=0.3)
    assert over.vertical_shift == pytest.approx(both.vertical_shift, abs=1e-11)


ANGLES = np.linspace(-0.75, 0.75, 11)


@cache
def cylinders():
    """A polygon of order 2 and 0.2 mm, by the sections at these angles."""
    parts = [
        Profile("section", "wheel", (Polynomial(-60.0, 60.0, (0.2 * cos(2.0 * angle),)),)) for angle in ANGLES
    ]
    return WheelSections(ANGLES, parts, CYLINDER)


def test_sections_of_a_wheel_are_those_of_its_shape():
    """Splines over slices 9 degrees apart are within a ten-thousandth of a wave of order 2."""
    wheels = WheelSections.polygon(CYLINDER, 2, 2e-4), cylinders()
    found = [system_of(one).evaluate(wheel_rotation=0.3).vertical_shift for one in wheels]
    assert found[1] == pytest.approx(found[0], abs=2e-8)


def write_wheel(folder, ending):
    """Files of the wheel of :func:`cylinders`, by angles in degrees."""
    y = np.linspace(-60.0, 60.0, 241)
    rows = []
    for k, angle in enumerate(ANGLES):
        z = np.full(len(y), 0.2 * cos(2.0 * angle))
        np.savetxt(folder / f"w{k}.csv", np.column_stack([y, z]), fmt="%.12f")
        rows.append(np.degrees(angle))
    path = folder / f"wheel.{ending}"
    if ending == "slcw":
        lines = [f"0.0 {pi / 180.0!r} % TH_OFFSET TH_SCALE", f"{len(rows)}", "0 0 0", "1"]
        lines += [f"{angle!r} 'w{k}.csv'" for k, angle in enumerate(map(float, rows))]
    else:
        lines = ['kind = "wheel sections"', 'unit = "mm"', 'angle_unit = "deg"']
        for k, angle in enumerate(map(float, rows)):
            lines += ["[[slice]]", f"angle = {angle!r}", f'file = "w{k}.csv"']
    path.write_text("\n".join(lines))
    return path


@pytest.mark.parametrize("ending", ["slcw", pytest.param("toml", marks=pytest.mark.full)])
def test_files_are_read(tmp_path, ending):
    """As the same sections in Python; their path is a wheel, too."""
    if ending == "toml":
        pytest.importorskip("tomllib", reason="Python reads TOML from version 3.11")
    path = write_wheel(tmp_path, ending)
    expected = system_of(cylinders()).evaluate(wheel_rotation=0.3)
    for wheel in (path, str(path), WheelSections.from_file(path)):
        found = ContactSystem(wheel=wheel, rail_inclination=0.0).evaluate(wheel_rotation=0.3)
        assert found.vertical_shift == pytest.approx(expected.vertical_shift, abs=1e-9)


@pytest.mark.parametrize(
    "text, sentence",
    [
        ("0 1\n1\n0 0 0\n1\n", "has 1 as NSLC, the number of slices; permitted are 2"),
        ("0 1\n2\n2 0 0\n1\n", "has 2 features; permitted is 0 for a wheel"),
        (
            "0 1\n2\n0 0 0\n1\n0.0 'none.csv'\n1.0 'none.csv'\n",
            "has slice 1 in 'none.csv', which cannot be read",
        ),
    ],
)
def test_files_that_are_none_are_refused(tmp_path, text, sentence):
    path = tmp_path / "wheel.slcw"
    path.write_text(text)
    with pytest.raises(ValueError, match=sentence):
        WheelSections.from_file(path)


# --- what is refused ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "make, sentence",
    [
        (
            lambda: WheelSections.polygon("S1002", 0, 1e-4),
            r"order is 0; permitted are whole numbers 1 \.\.\. 60",
        ),
        (
            lambda: WheelSections.polygon("S1002", 3, 0.1),
            r"amplitude is 0.1 m; permitted is -0.005 \.\.\. 0.005 m",
        ),
        (lambda: WheelSections.eccentric("UIC60", 1e-3), "profile is 'UIC60'"),
        (lambda: WheelSections.flat("S1002", 1.0), r"length is 1.0 m; permitted is 0.005 \.\.\. 0.15 m"),
        (lambda: WheelSections([0.0], [WHEEL]), "angles has the shape"),
        (lambda: WheelSections([0.0, 1.0], [WHEEL]), "there are 1 profiles for 2 angles"),
        (lambda: WheelSections([1.0, 0.0], [WHEEL] * 2), "angle 2 is 0 rad, behind 1 rad"),
        (lambda: WheelSections([0.0, 1.0], [WHEEL, RAIL]), "section 2 at 1 rad is a rail profile"),
        (
            lambda: ContactSystem(rail=ECCENTRIC),
            "rail is WheelSections '.*', which changes around the wheel; permitted",
        ),
        (
            lambda: ContactSystem(wheel=ECCENTRIC, tangential_model="halfspace"),
            "tangential_model is 'halfspace'; permitted with a wheel that is not round are",
        ),
        (
            lambda: ContactSystem(wheel=ECCENTRIC, independent_wheels=True),
            "independent_wheels is True; permitted with two wheels that are not round is False",
        ),
    ],
)
def test_what_is_refused(make, sentence):
    with pytest.raises(ValueError, match=sentence):
        make()


def test_a_rotation_that_is_not_finite_is_refused_and_the_next_one_counts():
    system = system_of(ECCENTRIC)
    state = system.evaluate(wheel_rotation=np.nan)
    assert state.status == 4
    assert explain(state.status, state.inputs) == "wheel_rotation is nan rad; permitted are finite numbers"
    assert system.evaluate(wheel_rotation=0.1).status == 0
