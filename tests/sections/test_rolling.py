"""Velocities, creepages and creep forces on rails whose section changes: against constant rails, turned ones, the relative
velocity of both surfaces, and the balance of power."""

from functools import cache
from math import atan, cos, sin

import numpy as np
import pytest

from tests.helpers.changing import head
from tests.helpers.sections import moved, stepped, stepper_on, waves
from wrcontact import ContactSystem, RailSections, WheelSections
from wrcontact.profiles import standard_profile
from wrcontact.profiles.placement import place_rail

MODELS = "strips", "fastsim", "fastrip", "polach"
#: Velocities of a wheelset; of a compliant one both, of rails the last ones.
RUN = dict(speed=20.0, lateral_velocity=0.02, yaw_rate=0.03)
BOUNCE = dict(vertical_velocity=-0.015, roll_rate=0.02)
CURVE = dict(track_curvature=1 / 400, right_rail_lateral_velocity=0.01, left_rail_vertical_velocity=-0.02)


def turned_by(yaw, roll):
    """The rotation matrix of a wheelset, but for that about its axle: columns ahead, along the axle, down."""
    c, s, u, v = cos(yaw), sin(yaw), cos(roll), sin(roll)
    return np.array([[c, -s * u, s * v], [s, c * u, -c * v], [0.0, v, u]])


def vector(found, name):
    return np.array([found[f"{name}.{axis}"] for axis in "xyz"])


@cache
def system():
    return ContactSystem(rail_inclination=0.0)


# --- rails that do not change ------------------------------------------------------------------------------------


@cache
def on_equal_slices(model, mode, damping):
    made = ContactSystem(
        rail_inclination=0.0,
        tangential_model=model,
        contact_mode=mode,
        contact_damping=damping,
        fatigue_outputs=True,
        independent_wheels=model == "polach",
    )
    return made.stepper(), stepper_on(made, moved([0.0, 0.5]))


@pytest.mark.parametrize(
    "model", [pytest.param(name, marks=pytest.mark.full) for name in MODELS[1:]] + ["strips"]
)
@pytest.mark.parametrize("mode", ["rigid", "compliant", "elastic"])
@pytest.mark.parametrize("rate", [0.0, pytest.param(43.0, marks=pytest.mark.full)])
def test_a_wheelset_that_rolls_on_equal_slices_does_so_on_the_constant_rail(rate, mode, model):
    """All outputs, with the rotation given or following; a compliant one with damped contact."""
    straight, changing = on_equal_slices(model, mode, 0.3 if mode == "compliant" else 0.0)
    for shift, yaw in ((2e-3, 0.01), (-5.5e-3, -0.006)):
        inputs = dict(lateral_shift=shift, yaw=yaw, wheel_rate=rate, left_friction=0.2, **RUN, **CURVE)
        inputs |= {"left.wheel_rate": rate, "right.axle_torque": 200.0}
        if mode == "compliant":
            touching = system().evaluate(lateral_shift=shift, yaw=yaw)
            inputs |= BOUNCE | dict(
                vertical_shift_input=touching.vertical_shift + 9e-5, roll_input=touching.roll
            )
        status, wanted = stepped(straight, **inputs)
        found = stepped(changing, track_position=0.2, **inputs)
        assert (found[0], status) == (0, 0)
        for name, value in wanted.items():
            if (
                "station" in name or "curvature_y" in name
            ):  # pieces follow second derivatives of a profile to 1e-7
                continue
            near = 1e-6 * abs(value) + (
                1e-3 if "force" in name or "torque" in name or "moment" in name else 1e-8
            )
            if name.endswith("]") or name.endswith("power"):
                near = 1e-5 * (abs(value) + 1.0)
            assert abs(found[1][name] - value) < near, (name, shift, found[1][name], value)


# --- rails that are constant ones from another direction ---------------------------------------------------------


def seen_from(frame, pose, velocity, rotation, axle_rate):
    """Inputs in a track with the axes ``frame`` (columns) of a wheelset with yaw and roll ``pose``, the ``velocity`` of its
    centre, its ``rotation`` but for that about the axle (``axle_rate``)."""
    axle = frame.T @ turned_by(*pose)[:, 1]
    yaw, roll = np.arctan2(-axle[0], axle[1]), np.arcsin(axle[2])
    speed, lateral, vertical = frame.T @ velocity
    own = np.column_stack([[0.0, 0.0, 1.0], [cos(yaw), sin(yaw), 0.0], axle])
    yaw_rate, roll_rate, rest = np.linalg.solve(own, frame.T @ rotation)
    return dict(
        yaw=yaw,
        roll_input=roll,
        speed=speed,
        lateral_velocity=lateral,
        vertical_velocity=vertical,
        yaw_rate=yaw_rate,
        roll_rate=roll_rate,
        wheel_rate=axle_rate - rest,
    )


@pytest.mark.parametrize("rate, rise", [(0.02, 0.0), (-0.1, 0.0), (0.0, 0.02), (0.0, -0.1)])
@pytest.mark.parametrize("model", ["strips", pytest.param("fastrip", marks=pytest.mark.full)])
@pytest.mark.parametrize("shift", [pytest.param(1e-3, marks=pytest.mark.full), -4e-3])
def test_on_a_rail_that_moves_or_rises_a_wheel_rolls_as_a_turned_one(shift, model, rate, rise):
    """A compliant wheel with damped contact: sizes, creepages, tangential forces and powers are the same, vectors turned."""
    along = np.array([1.0, rate, -rise]) / np.sqrt(1.0 + rate**2 + rise**2)
    aside = np.array([-rate, 1.0, 0.0]) / np.sqrt(1.0 + rate**2)
    frame = np.column_stack([along, aside, np.cross(along, aside)])
    narrow, flat, u = cos(atan(rate)), cos(atan(rise)), 0.07
    straight = ContactSystem(
        rail=head(narrow, flat),
        rail_inclination=0.0,
        contact_mode="compliant",
        tangential_model=model,
        contact_damping=0.3,
    )
    at = np.linspace(-0.4, 0.4, 9)
    moving = RailSections(at, [head()] * 9, places=np.column_stack([rate * at, -rise * at]))
    stepper = stepper_on(straight, moving, lateral=straight.profile_tables()[2] / narrow - rate * u)
    yaw, roll = 0.01, 1e-3
    velocity = np.array([20.0, 0.02, -0.015 - 20.0 * rise])
    rotation = np.array([0.02 * cos(yaw), 0.02 * sin(yaw), 0.03])
    turned = seen_from(frame, (yaw, roll), velocity, rotation, 43.6)
    load, height = 0.0, -4e-3
    while not load > 4e4 and height < 4e-3:
        height += 5e-5
        status, wanted = stepped(
            straight.stepper("right"), vertical_shift_input=height, lateral_shift=narrow * shift, **turned
        )
        load = wanted["right.normal_force"] if status == 0 else 0.0
    assert 4e4 < load < 2e5
    radius = 0.46
    status, found = stepped(
        stepper,
        track_position=u,
        lateral_shift=shift,
        yaw=yaw,
        roll_input=roll,
        vertical_shift_input=radius - rise * u - (radius - height) / flat,
        speed=velocity[0],
        lateral_velocity=velocity[1],
        vertical_velocity=velocity[2],
        yaw_rate=0.03,
        roll_rate=0.02,
        wheel_rate=43.6,
    )
    assert status <= 1  # the left wheel may be lifted
    shared = [
        name
        for name in wanted
        if name.startswith("right.")
        and name.split(".")[-1]
        in (
            "normal_force", "area", "max_pressure", "penetration", "stick_share", "max_shear", "friction_power",
            "saturation", "wear_number", "driving_torque", "damping_power", "length", "width", "patch_count",
        )
    ]  # fmt: skip
    shared += [name for name in wanted if name.startswith("right.patch[1].creepage")]
    shared += [name for name in wanted if name.startswith("right.patch[1].tangential")]
    assert len(shared) > 20
    for name in shared:
        small = 1e-6 if "tangential" in name else 1e-8
        assert found[name] == pytest.approx(wanted[name], rel=2e-6, abs=small), name
    for part in ("force", "moment", "normal.force", "normal.moment", "patch[1].force"):
        turned_back = frame @ vector(wanted, f"right.{part}")
        size = np.linalg.norm(turned_back)
        np.testing.assert_allclose(
            vector(found, f"right.{part}"), turned_back, atol=1e-6 * size, err_msg=part
        )
    assert abs(found["right.patch[1].tangential.x"]) > 100.0


# --- what the surfaces say ---------------------------------------------------------------------------------------


def on_waves(**more):
    """A wheelset on rails that twist, rise and move, and slopes and ruling rate of the right one at track coordinates."""
    made = ContactSystem(rail_inclination=0.0, **more)
    rail, lateral = waves(), 0.75

    def slopes(u, y):
        jet = rail.surface.jet(u, y - lateral)
        return float(jet[1]), float(jet[2]), float(jet[6])

    return stepper_on(made, rail, lateral=lateral), slopes


def unit(vector):
    return vector / np.linalg.norm(vector)


def place_of(found, name, centre):
    """A place from the wheelset's centre."""
    return np.array([found[f"{name}.{axis}_track"] for axis in "xyz"]) - centre


def slid(found, side, slopes, inputs, motion, k=1):
    """Creepages of patch ``k`` of a side by vectors in the track, and those of the outputs: ``motion`` is the velocity of
    the wheelset's centre and its rotation but for that about the axle."""
    velocity, rotation = motion
    patch, field = f"{side}.patch[{k}]", 1.0 if side == "right" else -1.0
    centre = np.array([0.0, inputs["lateral_shift"], found["vertical_shift"] - 0.46])
    place = place_of(found, patch, centre)
    touch = place_of(found, f"{side}.contact", centre)
    z_u, z_y, q = slopes(inputs["track_position"] + touch[0], field * (touch + centre)[1])
    ruling = np.array([1.0, field * q, z_u + q * z_y])  # of the place of contact
    z_u, z_y, _ = slopes(inputs["track_position"] + place[0], field * (place + centre)[1])
    surface = unit(np.array([z_u, field * z_y, -1.0]))
    lean, angle = found[f"{patch}.slope"], found[f"{patch}.contact_angle"]
    normal = unit(np.array([-np.tan(lean), -field * np.tan(angle), -1.0]))
    assert np.linalg.norm(normal - surface) < 0.02  # the mean over the patch, and that of its middle
    axle = turned_by(inputs["yaw"], found["roll"])[:, 1]
    rate = found[f"{side}.wheel_rate_found"]
    rolling = rate * found[f"{patch}.rolling_radius"] * unit(np.cross(axle, place))
    ahead = unit(ruling - ruling @ normal * normal)
    left = np.cross(normal, ahead)
    slide = velocity + np.cross(rotation, place) - rolling
    turn = rotation - rate * axle
    speed = 0.5 * (abs(velocity @ ahead) + abs(rolling @ ahead))
    wanted = np.array([slide @ ahead, slide @ left, turn @ normal]) / speed
    return wanted, np.array([found[f"{patch}.creepage.{name}"] for name in ("x", "y", "spin")])


POSES = [
    (0.15, 0.0, 0.0),
    (0.2, 3e-3, 0.01),
    (0.27, -5e-3, -0.01),
    (0.33, 6.5e-3, 0.005),
    (0.41, -6.5e-3, 0.01),
]
FEW = [*(pytest.param(pose, marks=pytest.mark.full) for pose in POSES[1:3]), POSES[3]]


@pytest.mark.parametrize("pose", POSES, ids=lambda pose: f"{1e3 * pose[1]:g}mm")
def test_creepages_are_the_relative_velocity_of_both_surfaces(pose):
    """Of a rigid wheelset, whose vertical velocity and roll rate are those along its path in time; where it touches, its
    surface moves along that of the rail, and the power of the creep forces is that of friction."""
    stepper, slopes = on_waves(tangential_model="strips")
    u, shift, yaw = pose
    V, y_rate, yaw_rate, dt = 20.0, 0.03, 0.05, 2e-6
    ways = []
    for t in (-dt, dt):
        moved_on = dict(track_position=u + V * t, lateral_shift=shift + y_rate * t, yaw=yaw + yaw_rate * t)
        status, found = stepped(stepper, **moved_on)
        assert status == 0, pose
        ways.append([found["vertical_shift"], found["roll"]])
    z_rate, roll_rate = (np.array(ways[1]) - ways[0]) / (2.0 * dt)
    assert abs(z_rate) > 0.05  # 1e4 times what it is on a constant rail
    inputs = dict(track_position=u, lateral_shift=shift, yaw=yaw)
    status, found = stepped(stepper, speed=V, lateral_velocity=y_rate, yaw_rate=yaw_rate, **inputs)
    assert status == 0, pose
    velocity = np.array([V, y_rate, z_rate])
    rotation = np.array([roll_rate * cos(yaw), roll_rate * sin(yaw), yaw_rate])
    centre = np.array([0.0, shift, found["vertical_shift"] - 0.46])
    axle = turned_by(yaw, found["roll"])[:, 1]
    for side in ("left", "right"):
        turning = rotation - found[f"{side}.wheel_rate_found"] * axle
        force, moment = (
            vector(found, f"{side}.{part}") - vector(found, f"{side}.normal.{part}")
            for part in ("force", "moment")
        )
        power = force @ velocity + moment @ turning
        assert power == pytest.approx(-found[f"{side}.friction_power"], rel=1e-6), (pose, side)
        field = 1.0 if side == "right" else -1.0
        touch = place_of(found, f"{side}.contact", centre)
        z_u, z_y, _ = slopes(u + touch[0], field * (touch + centre)[1])
        normal = unit(np.array([z_u, field * z_y, -1.0]))
        assert abs((velocity + np.cross(rotation, touch)) @ normal) < 1e-6 * V, (pose, side)
        for k in range(1, int(found[f"{side}.patch_count"]) + 1):
            wanted, own = slid(found, side, slopes, inputs, (velocity, rotation), k)
            np.testing.assert_allclose(own, wanted, rtol=1e-6, atol=2e-7, err_msg=f"{pose} {side} {k}")


@pytest.mark.parametrize("pose", FEW, ids=lambda pose: f"{1e3 * pose[1]:g}mm")
def test_damping_follows_the_rate_of_the_penetration(pose):
    """Along a path in time of a compliant wheelset: the force is 1 + d a of that without damping, with the rate a of the
    penetration at the deepest point, but for how far the centre of load lies beside it."""
    u, shift, yaw = pose
    rigid, _ = on_waves()
    status, touching = stepped(rigid, track_position=u, lateral_shift=shift, yaw=yaw)
    plain, _ = on_waves(contact_mode="compliant", normal_model="hertz")
    damped, _ = on_waves(contact_mode="compliant", normal_model="hertz", contact_damping=0.5)
    rates = dict(
        track_position=20.0, lateral_shift=0.03, yaw=0.05, vertical_shift_input=0.1, roll_input=-0.04
    )
    start = dict(
        track_position=u,
        lateral_shift=shift,
        yaw=yaw,
        vertical_shift_input=touching["vertical_shift"] + 6e-5,
        roll_input=touching["roll"],
    )
    dt, depths = 1e-8, []
    for t in (-dt, dt):
        status, found = stepped(plain, **{name: value + rates[name] * t for name, value in start.items()})
        assert status == 0, pose
        depths.append([found["left.penetration"], found["right.penetration"]])
    approach = np.diff(depths, axis=0)[0] / (2.0 * dt)
    velocities = dict(
        speed=20.0, lateral_velocity=0.03, yaw_rate=0.05, vertical_velocity=0.1, roll_rate=-0.04
    )
    loads = {}
    for name, stepper in (("plain", plain), ("damped", damped)):
        status, found = stepped(stepper, **start, **velocities)
        assert status == 0, pose
        loads[name] = np.array([found["left.normal_force"], found["right.normal_force"]])
        powers = [found["left.damping_power"], found["right.damping_power"]]
    assert (np.abs(approach) > 0.05).any()
    np.testing.assert_allclose(
        loads["damped"] / loads["plain"], 1.0 + 0.5 * approach, atol=2e-3, err_msg=pose
    )
    np.testing.assert_allclose(
        powers, (loads["damped"] - loads["plain"]) * approach, rtol=0.05, atol=20.0, err_msg=pose
    )


# --- power -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "model", [pytest.param(name, marks=pytest.mark.full) for name in MODELS[1:]] + ["strips"]
)
def test_the_power_of_all_forces_goes_into_friction_and_elastic_energy(model):
    """Of a compliant wheelset on rails that move and rise, with the penetrations along its path in time: Hertz's energy
    2/5 N d changes by N dd where the curvatures stay, and what it follows these beyond that is not in a force along the
    normal of the deepest point."""
    at = np.linspace(-0.3, 0.6, 10)
    rail = RailSections(at, [head()] * 10, places=np.column_stack([0.04 * at, -0.03 * at]))
    made = ContactSystem(
        rail_inclination=0.0, contact_mode="compliant", normal_model="hertz", tangential_model=model
    )
    stepper = stepper_on(made, rail, lateral=0.75)
    rates = dict(
        track_position=20.0, lateral_shift=0.05, yaw=0.08, vertical_shift_input=-0.55, roll_input=-0.02
    )
    start = dict(
        track_position=0.1, lateral_shift=2e-3, yaw=6e-3, vertical_shift_input=-1.8e-2, roll_input=1e-3
    )
    touching = stepped(
        stepper_on(system(), rail, lateral=0.75), track_position=0.1, lateral_shift=2e-3, yaw=6e-3
    )
    start |= dict(vertical_shift_input=touching[1]["vertical_shift"] + 8e-5, roll_input=touching[1]["roll"])
    dt, depths = 1e-7, []
    for t in (-dt, dt):
        status, found = stepped(stepper, **{name: value + rates[name] * t for name, value in start.items()})
        assert status == 0
        depths.append([found["left.penetration"], found["right.penetration"]])
    status, found = stepped(
        stepper,
        **start,
        speed=20.0,
        lateral_velocity=0.05,
        yaw_rate=0.08,
        vertical_velocity=-0.55,
        roll_rate=-0.02,
        wheel_rate=43.7,
    )
    assert status == 0
    loads = np.array([found["left.normal_force"], found["right.normal_force"]])
    stored = loads @ np.diff(depths, axis=0)[0] / (2.0 * dt)
    velocity, yaw = np.array([20.0, 0.05, -0.55]), start["yaw"]
    turning = np.array([-0.02 * cos(yaw), -0.02 * sin(yaw), 0.08])
    axle = turned_by(yaw, start["roll_input"])[:, 1]
    pressed = vector(found, "normal.force") @ velocity + vector(found, "normal.moment") @ turning
    total = vector(found, "force") @ velocity + vector(found, "moment") @ (turning - 43.7 * axle)
    rubbed = found["left.friction_power"] + found["right.friction_power"]
    assert abs(stored) > 500.0 and rubbed > 500.0
    assert pressed == pytest.approx(-stored, rel=1e-5)
    assert total == pytest.approx(pressed - rubbed, rel=1e-8)
    assert vector(found, "moment") @ axle == pytest.approx(-found["driving_torque"], abs=1e-3)


# --- patches that lean -------------------------------------------------------------------------------------------


def growing():
    """UIC60 as it is inclined, with its width growing by its own width per m: its gauge face moves to the wheel; and where it
    lies."""
    placed = place_rail(standard_profile("UIC60"), inclination=1 / 40, gauge=1.435, gauge_depth=0.014)
    y = np.linspace(placed.profile.start + 1e-6, placed.profile.stop - 1e-6, 401)
    points, at = np.column_stack([y, placed.profile.height(y)]), np.linspace(-0.2, 0.2, 9)
    return RailSections(at, [points * [1.0 + wider, 1.0] for wider in at]), placed.y_track


@pytest.mark.parametrize("yaw, shift", [(-0.02, 4.75e-3), pytest.param(0.0, 4.6e-3, marks=pytest.mark.full)])
def test_a_second_patch_leans_from_the_first_one_along_the_rail(yaw, shift):
    """Both patches lie at other places along the wheel: each has the creepages, the power and the rolling radius of its own
    place, where the wheel's surface is below the rail's by the penetration."""
    rail, lateral = growing()

    def slopes(u, y):
        jet = rail.surface.jet(u, y - lateral)
        return float(jet[1]), float(jet[2]), float(jet[6])

    elastic, compliant = (
        stepper_on(
            ContactSystem(rail_inclination=0.0, tangential_model="strips", contact_mode=mode),
            rail,
            lateral=lateral,
        )
        for mode in ("elastic", "compliant")
    )
    inputs = dict(lateral_shift=shift, yaw=yaw, track_position=0.0)
    status, stands = stepped(elastic, normal_force=1.2e5, **inputs)
    assert status == 0
    status, found = stepped(
        compliant,
        **inputs,
        vertical_shift_input=stands["vertical_shift"],
        roll_input=stands["roll"],
        speed=20.0,
        lateral_velocity=0.05,
        yaw_rate=0.1,
        vertical_velocity=0.02,
        roll_rate=-0.03,
        wheel_rate=43.5,
        right_friction=0.01,
    )
    assert status == 0 and found["right.patch_count"] == 2
    velocity = np.array([20.0, 0.05, 0.02])
    rotation = np.array([-0.03 * cos(yaw), -0.03 * sin(yaw), 0.1])
    axle = turned_by(yaw, found["roll"])[:, 1]
    centre = np.array([0.0, shift, found["vertical_shift"] - 0.46])
    lean = [found[f"right.patch[{k}].slope"] for k in (1, 2)]
    assert abs(lean[1] - lean[0]) > 5e-3
    for k in (1, 2):
        wanted, own = slid(found, "right", slopes, inputs, (velocity, rotation), k)
        # the ruling direction is that where the wheel would touch first, 0.1 mm higher
        np.testing.assert_allclose(own, wanted, rtol=1e-6, atol=1e-6)
        # all of it slips, its strips in their own planes as the patch in its own
        rubbed = np.array([found[f"right.patch[{k}].tangential.{name}"] for name in ("x", "y")])
        assert unit(rubbed) @ unit(own[:2] * [-1.0, 1.0]) > np.cos(0.04), (k, rubbed, own)
        patch = f"right.patch[{k}]"
        normal = unit(
            np.array([-np.tan(found[f"{patch}.slope"]), -np.tan(found[f"{patch}.contact_angle"]), -1.0])
        )
        below = place_of(found, patch, centre) - found[f"{patch}.penetration"] * normal
        radius = 0.46 + float(standard_profile("S1002").height(below @ axle - 0.75))
        assert found[f"{patch}.rolling_radius"] == pytest.approx(radius, abs=1e-6 if yaw == 0.0 else 1e-7)
    force, moment = (
        vector(found, f"right.{part}") - vector(found, f"right.normal.{part}") for part in ("force", "moment")
    )
    power = force @ velocity + moment @ (rotation - 43.5 * axle)
    assert power == pytest.approx(-found["right.friction_power"], rel=1e-6)


# --- places of wear ----------------------------------------------------------------------------------------------


def test_wear_lies_in_the_sections():
    """On equal slices, displaced, all outputs of wear are those of the constant rail; on one that grows, the loads of the strips
    of a patch have their mean place on wheel and rail at its centre of load."""
    given = dict(tangential_model="strips", rail_inclination=0.0, wear_outputs=True)
    pose = dict(lateral_shift=-5.5e-3, yaw=-6e-3, right_rail_lateral=1e-3, speed=20.0, lateral_velocity=0.02)
    one = ContactSystem(rail=moved([0.0, 0.5]), gauge=1.437, **given).evaluate(track_position=0.2, **pose)
    other = ContactSystem(gauge=1.437, **given).evaluate(**pose)
    assert one.status == other.status == 0
    for side in ("left", "right"):
        for name in ("wheel_place", "rail_place", "patch_of", "power"):
            own, wanted = (np.asarray(getattr(getattr(state, side).outline, name)) for state in (one, other))
            np.testing.assert_allclose(own, wanted, rtol=1e-5, atol=1e-7, err_msg=f"{side} {name}")
        for name in ("wheel_place", "rail_place", "power", "width", "line_load", "slip"):
            own, wanted = (getattr(getattr(state, side).strips[0], name) for state in (one, other))
            np.testing.assert_allclose(own, wanted, rtol=1e-5, atol=1e-8, err_msg=f"{side} {name}")
    rail, lateral = growing()
    system_ = ContactSystem(rail=rail, rail_origin_y=lateral, contact_mode="elastic", **given)
    yaw, shift = -0.02, 4.75e-3
    state = system_.evaluate(lateral_shift=shift, yaw=yaw, normal_force=1.2e5)
    axle = turned_by(yaw, state.roll)[:, 1]
    centre = np.array([0.0, shift, state.vertical_shift - 0.46])
    assert state.right.patch_count == 2
    for k, patch in enumerate(state.right.patches[:2]):
        strips = state.right.strips[k]
        weight = strips.width * strips.line_load / np.sum(strips.width * strips.line_load)
        place = np.array([patch.x_track, patch.y_track, patch.z_track])
        assert weight @ strips.rail_place == pytest.approx(place[1] - lateral, abs=5e-5)
        normal = unit(np.array([-np.tan(patch.slope), -np.tan(patch.contact_angle), -1.0]))
        below = place - centre - patch.penetration * normal
        assert weight @ strips.wheel_place == pytest.approx(below @ axle - 0.75, abs=5e-5)


# --- elastic wheelsets -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("load", ["normal", "vertical"])
@pytest.mark.parametrize("pose", FEW, ids=lambda pose: f"{1e3 * pose[1]:g}mm")
def test_an_elastic_wheelset_is_a_compliant_one_at_the_height_and_roll_that_it_finds(pose, load):
    """It carries its loads there; and with the velocities along its path in time it has the same creepages."""
    elastic, _ = on_waves(contact_mode="elastic", tangential_model="strips", load=load)
    compliant, _ = on_waves(contact_mode="compliant", tangential_model="strips")
    u, shift, yaw = pose
    inputs = dict(lateral_shift=shift, yaw=yaw, track_position=u)
    run = dict(speed=20.0, lateral_velocity=0.03, yaw_rate=0.05)
    forces = dict(normal_force=5e4, load_transfer=0.2)
    status, found = stepped(elastic, **inputs, **run, **forces)
    assert status == 0, pose
    prescribed = "right.force.z" if load == "vertical" else "right.normal_force"
    assert abs(found[prescribed]) == pytest.approx(6e4, rel=2e-9)
    ways, dt = [], 1e-6
    if load == "normal":
        for t in (-dt, dt):
            status, way = stepped(
                elastic,
                track_position=u + 20.0 * t,
                lateral_shift=shift + 0.03 * t,
                yaw=yaw + 0.05 * t,
                **forces,
            )
            assert status == 0, pose
            ways.append([way["vertical_shift"], way["roll"]])
        rates = (np.array(ways[1]) - ways[0]) / (2.0 * dt)
        run |= dict(vertical_velocity=rates[0], roll_rate=rates[1])
    other = stepped(
        compliant,
        **inputs,
        **run,
        vertical_shift_input=found["vertical_shift"],
        roll_input=found["roll"],
    )
    assert other[0] == 0, pose
    for side in ("left", "right"):
        for name in ("normal_force", "area", "normal.force.x", "patch[1].x_track"):
            assert other[1][f"{side}.{name}"] == pytest.approx(found[f"{side}.{name}"], rel=1e-5), (
                pose,
                name,
            )
        for name in ("x", "y", "spin") if load == "normal" else ():
            name = f"{side}.patch[1].creepage.{name}"
            assert other[1][name] == pytest.approx(found[name], rel=1e-4, abs=2e-7), (pose, name)


@pytest.mark.parametrize("kind", ["roller", "polygon"])
def test_an_elastic_wheelset_on_rollers_or_with_wheels_that_are_not_round_is_a_compliant_one(kind):
    """At its height and roll, with the velocities along its path in time: the same loads and creepages."""
    given = {"roller_radius": 0.5}
    if kind == "polygon":
        given = {"wheel": WheelSections.polygon(standard_profile("S1002"), 3, 3e-4)}
    elastic, compliant = (
        ContactSystem(tangential_model="strips", contact_mode=mode, **given)
        for mode in ("elastic", "compliant")
    )
    start = dict(lateral_shift=5e-3, yaw=4e-3, wheel_rotation=0.4)
    rates = dict(lateral_shift=0.05, yaw=0.02, wheel_rotation=43.0)
    run = dict(speed=20.0, lateral_velocity=0.05, yaw_rate=0.02, wheel_rate=43.0)
    times = np.array([-1e-6, 1e-6])
    ways = elastic.evaluate_many(**{name: value + rates[name] * times for name, value in start.items()})
    found = elastic.evaluate(**start, **run)
    assert found.status == 0 and (ways.status == 0).all()
    other = compliant.evaluate(
        **start,
        **run,
        vertical_shift_input=found.vertical_shift,
        roll_input=found.roll,
        vertical_velocity=np.diff(ways.vertical_shift)[0] / 2e-6,
        roll_rate=np.diff(ways.roll)[0] / 2e-6,
    )
    for side in ("left", "right"):
        assert found[f"{side}.normal_force"] == pytest.approx(78.5e3, rel=1e-9)
        for name in ("normal_force", "area", "patch[1].tangential.y"):
            assert other[f"{side}.{name}"] == pytest.approx(found[f"{side}.{name}"], rel=1e-5), name
        for name in ("x", "y", "spin"):
            name = f"{side}.patch[1].creepage.{name}"
            assert other[name] == pytest.approx(found[name], rel=1e-5, abs=2e-7), name
