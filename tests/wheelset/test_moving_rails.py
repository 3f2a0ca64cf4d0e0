"""Rails that are displaced and rolled: seen from a rail the wheelset moves the other way."""

import math
from dataclasses import replace

import numpy as np
import pytest

import wrcontact
from data import brute_force
from tests.helpers.surface_witness import assert_positions
from wrcontact.interface.inputs import RAIL_LIMIT, RAIL_ROLL_LIMIT, RAILS
from wrcontact.status import Status

METHODS = {
    "rigid": {},
    "rigid hertz": dict(normal_model="hertz", load="vertical"),
    "rigid strips": dict(normal_model="analyn_strip"),
    "elastic": dict(contact_mode="elastic"),
    "elastic strips": dict(contact_mode="elastic", normal_model="analyn_strip"),
    "compliant": dict(contact_mode="compliant"),
    "compliant strips": dict(contact_mode="compliant", normal_model="analyn_strip"),
}
POSES = ((1e-3, 0.0), (-2.5e-3, 0.012), (5.7e-3, 0.0), (6.2e-3, -0.01))
# [m] radius of UIC60's crown, whose centre lies below the highest point of any inclination
CROWN = 0.3


def height_and_roll(shift, yaw, **moved):
    """Vertical shift [m] and roll [rad] at which a compliant wheelset carries some 100 kN."""
    rigid = wrcontact.ContactSystem(normal_model="hertz").evaluate(shift, yaw, **moved)
    return {"vertical_shift_input": rigid.vertical_shift + 9e-5, "roll_input": rigid.roll}


def side_values(wheel):
    """What a wheel's contact and patches are, without where they lie in the track; (n,)."""
    found = [
        wheel.contact.x_wheel,
        wheel.contact.y_wheel,
        wheel.contact.z_wheel,
        wheel.contact.y_rail,
        wheel.contact.z_rail,
        wheel.contact.x_track,
        wheel.contact_angle,
        wheel.rolling_radius,
        wheel.penetration,
    ]
    return np.array(found)


def loads(wheel):
    """Forces, areas and pressures (n,)."""
    return np.array([wheel.normal_force, wheel.area, wheel.max_pressure, wheel.force.y, wheel.force.z])


@pytest.mark.parametrize("name", METHODS)
def test_moving_both_rails_is_moving_the_wheelset_the_other_way(name):
    system, (u, w) = wrcontact.ContactSystem(**METHODS[name]), (0.7e-3, 1.3e-3)
    moved = dict(left_rail_lateral=u, right_rail_lateral=u, left_rail_vertical=w, right_rail_vertical=w)
    for shift, yaw in POSES:
        given = height_and_roll(shift, yaw) if "compliant" in name else {}
        lower = {key: value + w * (key == "vertical_shift_input") for key, value in given.items()}
        wanted = system.evaluate(shift, yaw, **given)
        found = system.evaluate(shift + u, yaw, **lower, **moved)
        assert found.status == wanted.status == Status.VALID
        assert found.roll == pytest.approx(wanted.roll, abs=1e-12)
        assert found.vertical_shift - w == pytest.approx(wanted.vertical_shift, abs=1e-12)
        for side in ("left", "right"):
            mine, theirs = getattr(found, side), getattr(wanted, side)
            # contacts are the roots of slopes: 1e-15 m of rounding over a relative curvature of 1 / m
            assert side_values(mine) == pytest.approx(side_values(theirs), abs=1e-11)
            # the rounding of 1e-16 m in the shift over a penetration of 50 um, and elastic heights to 1e-13 m
            assert loads(mine) == pytest.approx(loads(theirs), rel=1e-7 if "elastic" in name else 1e-9)
            assert mine.contact.y_track - u == pytest.approx(theirs.contact.y_track, abs=1e-12)
            assert mine.contact.z_track - w == pytest.approx(theirs.contact.z_track, abs=1e-12)
            for one, other in zip(mine.patches, theirs.patches, strict=True):
                assert one.y_track - u == pytest.approx(other.y_track, abs=1e-9)
                assert one.z_track - w == pytest.approx(other.z_track, abs=1e-9)
        # about the wheelset's centre
        assert np.asarray(found.moment) == pytest.approx(np.asarray(wanted.moment), rel=1e-6, abs=1e-5)


def test_half_the_moves_of_the_rails_are_half_the_moves():
    """Rigid: a rail 1 mm lower on one side rolls the wheelset by 1 mm over the distance of the contacts."""
    system = wrcontact.ContactSystem("cone40")
    plain, down = system.evaluate(), 1e-5
    found = system.evaluate(right_rail_vertical=down)
    apart = plain.right.contact.y_track - plain.left.contact.y_track
    assert found.roll == pytest.approx(down / apart, rel=0.03)  # the cone's 1:40, and where it touches
    assert found.vertical_shift == pytest.approx(plain.vertical_shift + 0.5 * down, abs=0.05 * down)


def rolled_rail(system, side, roll):
    """How another inclination's rail is displaced (to the right, down) [m] from its nominal place where it is
    that of ``system``, rolled by ``roll`` [rad] about its highest point; and that inclination.

    The crown's centre lies CROWN below the highest point, before and after.
    """
    outward = roll if side == "right" else -roll  # field side down
    inclination = math.tan(math.atan(1 / 40) - outward)
    other = wrcontact.ContactSystem(rail_inclination=inclination)
    across = system.profile_tables()[2] - CROWN * math.sin(outward) - other.profile_tables()[2]
    return inclination, across if side == "right" else -across, CROWN * (math.cos(roll) - 1.0)


def over_rolled_rails(pose, given, left_roll=0.006, right_roll=-0.004, **methods):
    """The state at a pose over rails that are rolled, and that over rails of the inclinations that they have
    then."""
    plain = wrcontact.ContactSystem(**methods)
    found = plain.evaluate(*pose, **given, left_rail_roll=left_roll, right_rail_roll=right_roll)
    left, right = rolled_rail(plain, "left", left_roll), rolled_rail(plain, "right", right_roll)
    wanted = wrcontact.ContactSystem(**methods, rail_inclination=(left[0], right[0])).evaluate(
        *pose,
        **given,
        left_rail_lateral=left[1],
        left_rail_vertical=left[2],
        right_rail_lateral=right[1],
        right_rail_vertical=right[2],
    )
    assert found.status == wanted.status == Status.VALID
    for side in ("left", "right"):
        mine, theirs = getattr(found, side), getattr(wanted, side)
        for part in ("x_wheel", "y_wheel", "z_wheel", "x_track", "y_track", "z_track"):
            assert getattr(mine.contact, part) == pytest.approx(getattr(theirs.contact, part), abs=1e-8), part
        assert mine.contact_angle == pytest.approx(theirs.contact_angle, abs=1e-7)
    return found, wanted


@pytest.mark.parametrize(
    "name", ["compliant", "compliant strips", pytest.param("compliant vertical", marks=pytest.mark.full)]
)
@pytest.mark.parametrize("pose", POSES)
def test_rolling_a_rail_is_another_inclination(name, pose):
    """Of a compliant wheelset, whose height and roll are given, in all it reports in the track."""
    methods = METHODS.get(name) or dict(contact_mode="compliant", load="vertical")
    given = height_and_roll(*pose, left_rail_roll=0.006, right_rail_roll=-0.004)
    found, wanted = over_rolled_rails(pose, given, **methods)
    few = 2e-6 if "strips" in name else 1e-6
    for side in ("left", "right"):
        mine, theirs = getattr(found, side), getattr(wanted, side)
        assert mine.normal_force > 1e3
        # overlaps are measured along the rail's normals and do not know down, but the place of the rigid
        # contact does: the wheel touches first straight above, by each rail's own vertical; stations of
        # strips lie between the ends of the overlap: 6e-7 of the force
        assert mine.normal_force == pytest.approx(theirs.normal_force, rel=few if "strips" in name else 2e-7)
        # and 5e-7 of the area
        assert mine.area == pytest.approx(theirs.area, rel=1e-6 if "strips" in name else 2e-7)
        for name_of in ("x", "y", "z"):
            assert getattr(mine.force, name_of) == pytest.approx(
                getattr(theirs.force, name_of), rel=few, abs=1e-3
            )
            assert getattr(mine.moment, name_of) == pytest.approx(
                getattr(theirs.moment, name_of), rel=few, abs=1e-3
            )
        for one, other in zip(mine.patches, theirs.patches, strict=True):
            assert one.contact_angle == pytest.approx(other.contact_angle, abs=1e-7)
            assert one.y_track == pytest.approx(other.y_track, abs=1e-8)
            assert one.z_track == pytest.approx(other.z_track, abs=1e-8)
            assert one.rolling_radius == pytest.approx(other.rolling_radius, abs=1e-8)


@pytest.mark.parametrize(
    "name", ["rigid hertz", "elastic", pytest.param("elastic strips", marks=pytest.mark.full)]
)
@pytest.mark.parametrize("pose", POSES[:3])
def test_roll_and_height_over_rolled_rails_are_those_of_another_inclination(name, pose):
    """Where wheels sink does not hang on the frame in which it was found: the same vertical shift and roll as
    over rails with this inclination."""
    found, wanted = over_rolled_rails(pose, {}, **METHODS[name])
    # nodes of patches are traced to 1e-6 m in either frame, which moves heights by its square over radii
    # stations of strips lie between the ends of the overlap, which know down: 1.4e-10
    near = {"rigid hertz": 1e-12, "elastic strips": 2.2e-10}.get(name, 1e-11)
    assert found.roll == pytest.approx(wanted.roll, abs=near)
    assert found.vertical_shift == pytest.approx(wanted.vertical_shift, abs=near)


@pytest.mark.full
@pytest.mark.parametrize(
    "moved",
    [dict(left_rail_lateral=-10e-3), pytest.param(dict(right_rail_lateral=10e-3), marks=pytest.mark.full)],
)
@pytest.mark.parametrize(
    "pose", [(1e-3, math.radians(1)), pytest.param((-4e-3, math.radians(-0.5)), marks=pytest.mark.full)]
)
def test_gauge_widening_is_that_of_brute_force(moved, pose):
    """10 mm on one side, with yaw."""
    plain = brute_force.track()
    wider = replace(plain, rail_origin=plain.rail_origin + 10e-3)
    sides = (wider, plain) if "left_rail_lateral" in moved else (plain, wider)
    wanted = brute_force.rigid_contact(sides[1], *pose, sides[0])
    found = wrcontact.ContactSystem().evaluate(*pose, 0.0, **moved)
    assert_positions(found, wanted, rail=("y_rail",))


@pytest.mark.full
def test_a_rolled_rail_with_yaw_is_that_of_brute_force():
    """Another head, displaced as the crown's centre says (see rolled_rail)."""
    roll, pose = -0.007, (3e-3, math.radians(1))
    head = brute_force.inclined_head(brute_force.RAIL_HEADS["UIC60"], math.tan(math.atan(1 / 40) - roll))
    plain = brute_force.track()
    rolled = replace(
        plain,
        rail=head,
        rail_origin=plain.rail_origin - CROWN * math.sin(roll),
        rail_depth=CROWN * (math.cos(roll) - 1.0),
    )
    wanted = brute_force.rigid_contact(rolled, *pose, plain)
    found = wrcontact.ContactSystem().evaluate(*pose, 0.0, right_rail_roll=roll)
    assert_positions(found, wanted)


def test_the_step_before_does_not_matter():
    """Over rails that move; the search begins where the wheelset was."""
    system, rng = wrcontact.ContactSystem(normal_model="hertz"), np.random.default_rng(9)
    stepper = system.stepper()
    for _ in range(40):
        moved = {row.keyword: rng.uniform(-1.0, 1.0) * (0.02 if row.unit == "rad" else 4e-3) for row in RAILS}
        fresh = system.stepper()
        row = system.evaluate(rng.uniform(-6e-3, 6e-3), rng.uniform(-0.02, 0.02), 8e4, **moved).inputs
        stepper.inputs[:] = fresh.inputs[:] = row
        assert stepper.step() == fresh.step()
        assert stepper.outputs == pytest.approx(fresh.outputs, rel=1e-7, abs=1e-10)


@pytest.mark.parametrize("row", RAILS, ids=lambda row: row.name)
def test_what_is_refused(row):
    system = wrcontact.ContactSystem()
    assert system.evaluate(**{row.keyword: math.nan}).status == Status.INVALID_INPUT
    limit = RAIL_ROLL_LIMIT if row.unit == "rad" else RAIL_LIMIT
    far = system.evaluate(**{row.keyword: 1.01 * limit})
    assert far.status == Status.OFF_PROFILE
    words = wrcontact.status.explain(far.status, far.inputs)
    assert words.startswith(f"{row.name} is") and f"permitted is |{row.name}| <=" in words


def test_the_half_space_moves_with_its_rails():
    system = wrcontact.ContactSystem(normal_model="halfspace", tolerance=0.05)
    u, w = 1e-3, 2e-3
    wanted = system.evaluate(1e-3)
    found = system.evaluate(
        1e-3 + u, left_rail_lateral=u, right_rail_lateral=u, left_rail_vertical=w, right_rail_vertical=w
    )
    assert found.right.area == pytest.approx(wanted.right.area, rel=0.01)
    assert found.right.patches[0].y_track - u == pytest.approx(wanted.right.patches[0].y_track, abs=1e-6)
    assert found.right.patches[0].z_track - w == pytest.approx(wanted.right.patches[0].z_track, abs=1e-6)
    with pytest.raises(ValueError, match="right.rail_roll is 0.01 rad"):
        system.evaluate(right_rail_roll=0.01)


#: Wheelsets over leaning rails that are about to snap from a flange root to the flange, where contact falls
#: faster than the height rises for which it is sought: found at random, then with status 3.
SNAPPING = {
    "cone and flange": (
        dict(
            wheel=("cone20", "S1002"),
            rail=("54E1", "60E1"),
            nominal_radius=(0.4954132, 0.4946938),
            rail_inclination=(0.0, 1 / 30),
            gauge=1.4303685,
        ),
        dict(
            lateral_shift=5.7746e-3,
            normal_force=70e3,
            load_transfer=-0.52,
            left_rail_lateral=1.0795916e-3,
            left_rail_vertical=2.3712795e-3,
            left_rail_roll=7.9457518e-3,
            right_rail_lateral=2.8514355e-3,
            right_rail_roll=0.020825316,
        ),
    ),
    "little load": (
        dict(
            wheel=("S1002", "cone20"),
            rail=("54E1", "UIC60"),
            nominal_radius=(0.483708, 0.4849248),
            rail_inclination=(1 / 30, 0.0),
            gauge=1.4320556,
        ),
        dict(
            lateral_shift=-1.8435e-3,
            normal_force=8.25e3,
            left_rail_lateral=1.3761431e-3,
            left_rail_vertical=-1.8968459e-3,
            left_rail_roll=-0.022991831,
            right_rail_lateral=1.4416852e-3,
            right_rail_vertical=2.6366618e-3,
            right_rail_roll=3.138e-3,
        ),
    ),
    "small roll": (
        dict(
            rail="60E1", nominal_radius=(0.4242731, 0.425347), rail_inclination=(0.05, 0.0), gauge=1.4397078
        ),
        dict(
            lateral_shift=-6.6701e-3,
            normal_force=71e3,
            left_rail_lateral=1.9338775e-3,
            left_rail_vertical=1.868808e-4,
            left_rail_roll=-1.323893e-3,
            right_rail_lateral=1.7541584e-3,
            right_rail_vertical=1.910334e-3,
        ),
    ),
}


@pytest.mark.parametrize("model", ["analyn", pytest.param("hertz", marks=pytest.mark.full)])
@pytest.mark.parametrize(
    "case", [pytest.param(case, marks=[pytest.mark.full] * (case == "cone and flange")) for case in SNAPPING]
)
def test_a_wheelset_that_is_about_to_snap_stands(case, model):
    """Rigid and elastic. At the height and roll of an elastic one a compliant wheelset carries its loads, but
    where it snaps as its height is sought: it stands some micrometres beside that, 14 % of the load of a
    steep flange. (With Hertz the load jumps there whatever the rails do.)  Around the last one with little
    load the height falls nine times as fast as its reference rises: there is one that is its own reference, which
    a step of 1 nm beside a jump would leave 1.4e-5 of the load off."""
    sides, pose = SNAPPING[case]
    rigid, elastic, compliant = (
        wrcontact.ContactSystem(contact_mode=mode, normal_model=model, **sides)
        for mode in ("rigid", "elastic", "compliant")
    )
    for apart in (-1e-5, -1e-6, -1e-7, 0.0, 1e-7, 1e-6, 1e-5):
        given = pose | dict(lateral_shift=pose["lateral_shift"] + apart)
        assert rigid.evaluate(**given).status == Status.VALID
        state = elastic.evaluate(**given)
        assert state.status == Status.VALID
        stood = compliant.evaluate(**given, vertical_shift_input=state.vertical_shift, roll_input=state.roll)
        for side, sign in (("left", -1), ("right", 1)):
            load = given["normal_force"] * (1 + sign * given.get("load_transfer", 0.0))
            assert getattr(state, side).normal_force == pytest.approx(load, rel=1e-9)
            if model == "analyn":
                near = 0.2 if case == "cone and flange" else 1e-6
                assert getattr(stood, side).normal_force == pytest.approx(load, rel=near)
