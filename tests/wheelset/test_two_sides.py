"""A wheelset whose left side differs from its right one: profiles, nominal radius,
inclination of the rail."""

import pickle
from dataclasses import replace

import numpy as np
import pytest

import wrcontact
from data import brute_force
from tests.helpers.inside import tables_of
from tests.helpers.mirror import side_signs
from tests.helpers.surface_witness import assert_positions
from wrcontact.interface.inputs import RAILS
from wrcontact.interface.variables import FIRST_OUTPUT, FIRST_WEAR, VARIABLES
from wrcontact.kernel import layout
from wrcontact.status import Status

#: Left and right side.
SIDES = {
    "profiles": dict(wheel=("cone40", "S1002"), rail=("54E1", "UIC60")),
    "radii": dict(nominal_radius=(0.459, 0.46)),
    "inclinations": dict(rail_inclination=(1 / 20, 1 / 40)),
    "all": dict(
        wheel=("S1002", "cone20"),
        rail=("60E1", "54E1"),
        nominal_radius=(0.4615, 0.459),
        rail_inclination=(0.0, 1 / 40),
    ),
}
METHODS = {
    "rigid": {},
    "rigid hertz": dict(normal_model="hertz", load="vertical"),
    "rigid strips": dict(normal_model="analyn_strip"),
    "elastic": dict(contact_mode="elastic"),
    "elastic strips": dict(contact_mode="elastic", normal_model="analyn_strip"),
    "compliant": dict(contact_mode="compliant"),
}
LEFT = slice(layout.OUT_LEFT, layout.OUT_LEFT + layout.SIDE_SIZE)
RIGHT = slice(layout.OUT_RIGHT, layout.OUT_RIGHT + layout.SIDE_SIZE)


def swapped(sides):
    """The wheelset in the mirror."""
    return {name: value[::-1] for name, value in sides.items()}


def rows(sides, mode, count=12, seed=4):
    """Inputs (count, n) over tread and flange root; of a compliant wheelset with heights and rolls at which
    it is loaded."""
    rng = np.random.default_rng(seed)
    found = np.zeros((count, layout.INPUT_COUNT))
    found[:, layout.IN_LATERAL_SHIFT] = rng.uniform(-5e-3, 5e-3, count)
    found[:, layout.IN_YAW] = rng.uniform(-0.02, 0.02, count) * (np.arange(count) % 2)
    found[:, layout.IN_NORMAL_FORCE] = rng.uniform(2e4, 1.2e5, count)
    found[:, layout.IN_LOAD_TRANSFER] = rng.uniform(-0.5, 0.5, count)
    if mode == "compliant":
        rigid = wrcontact.ContactSystem(**sides, normal_model="hertz")
        table = rigid.evaluate_many(found[:, layout.IN_LATERAL_SHIFT], found[:, layout.IN_YAW])
        found[:, layout.IN_VERTICAL_SHIFT], found[:, layout.IN_ROLL] = table.vertical_shift + 9e-5, table.roll
    return found


def outputs(rows, **parameters):
    """Outputs (count, m) and status (count,) of a new wheelset at every row."""
    found, status = [], []
    for row in rows:
        stepper = wrcontact.ContactSystem(**parameters).stepper()
        stepper.inputs[:] = row
        status.append(stepper.step())
        found.append(stepper.outputs.copy())
    return np.array(found), np.array(status)


#: Inputs that keep their sign in the mirror.
KEPT = ("normal_force", "vertical_shift_input", "left.rail_vertical", "right.rail_vertical")


def mirrored(row):
    """Inputs (n,) of the wheelset in the mirror."""
    names = [one.name for one in VARIABLES[: layout.INPUT_COUNT]]
    found = dict(zip(names, row))
    swap = {"left": "right", "right": "left"}
    there = {
        f"{swap[name.split('.')[0]]}.{name.split('.')[1]}" if "." in name else name: value
        if name in KEPT or name.endswith("friction")
        else -value
        for name, value in found.items()
    }
    return np.array([there[name] for name in names])


@pytest.mark.parametrize("methods", METHODS)
@pytest.mark.parametrize("sides", ["all", pytest.param("profiles", marks=pytest.mark.full)])
@pytest.mark.parametrize("moved", [0.0, 1.0], ids=["rails at rest", "rails moved"])
def test_in_the_mirror_left_and_right_change_places(sides, methods, moved):
    """Lateral shift, yaw and roll change their signs, and each side has the outputs of the other."""
    chosen, methods = SIDES[sides], METHODS[methods]
    poses, rng = rows(chosen, methods.get("contact_mode")), np.random.default_rng(6)
    for rail in RAILS:
        size = moved * (0.01 if rail.unit == "rad" else 1e-3)
        place = next(k for k, one in enumerate(VARIABLES) if one.name == rail.name)
        poses[:, place] = rng.uniform(-size, size, len(poses))
    found, status = outputs(poses, **chosen, **methods)
    there, status_there = outputs(np.array([mirrored(row) for row in poses]), **swapped(chosen), **methods)
    assert np.array_equal(status, status_there)
    valid = status <= Status.UNLOADED
    assert valid.mean() > (0.5 if moved else 0.99)
    found, there = found[valid], there[valid]
    # at least the usual size: on a cone the centre of load is nearly zero
    usual = [variable.nominal or 1.0 for variable in VARIABLES[FIRST_OUTPUT:FIRST_WEAR]]
    size = np.maximum(np.abs(found).max(axis=0), usual)
    # rigid rolls are found to 1e-14 rad; elastic heights and rolls to 1e-13 m, of a penetration of 50 um
    near = 1e-7 if "elastic" in methods.values() else 1e-9
    signs = side_signs()
    for one, other in ((LEFT, RIGHT), (RIGHT, LEFT)):
        assert (np.abs(found[:, one] - signs * there[:, other]) <= near * size[one]).all()
    assert np.abs(found[:, layout.OUT_ROLL] + there[:, layout.OUT_ROLL]).max() < 1e-12  # [rad]
    # rigid: the height is that of the right wheel, whose gap equals the left one's
    apart = found[:, layout.OUT_VERTICAL_SHIFT] - there[:, layout.OUT_VERTICAL_SHIFT]
    assert np.abs(apart).max() < 1e-12  # [m]


@pytest.mark.parametrize(
    "sides",
    [
        dict(wheel=("S1002", "S1002")),
        dict(rail=("UIC60", "UIC60"), nominal_radius=(0.46, 0.46)),
        dict(left_rail_inclination=1 / 40),
        {},
    ],
)
def test_equal_sides_are_one(sides):
    """However they are said, with the same bits."""
    system, plain = wrcontact.ContactSystem(**sides), wrcontact.ContactSystem()
    assert system.equal_sides and len(tables_of(system)) == len(tables_of(plain))
    found, wanted = (one.evaluate(3e-3, 0.01, 9e4, 0.1) for one in (system, plain))
    assert np.array_equal(found.values, wanted.values)


@pytest.mark.parametrize(
    "name, value, shared",
    [
        ("left_nominal_radius", 0.459, ("rail", "rail_curvature", "rail_arc", "rail_at_arc")),
        ("left_rail_inclination", 1 / 20, ("wheel", "wheel_curvature")),
        ("left_rail", "54E1", ("wheel", "wheel_curvature")),
    ],
)
def test_what_is_equal_is_prepared_once(name, value, shared):
    """Only the left wheel or the left rail differs: the other one's tables are those of the right side."""
    system = wrcontact.ContactSystem(**{name: value})
    left, right = layout.Tables.at(tables_of(system)).pairs
    parts = ("wheel", "wheel_curvature", "rail", "rail_curvature", "rail_arc", "rail_at_arc", "scan")
    same = tuple(
        part
        for part in parts
        if layout.offset(getattr(left, part), tables_of(system))
        == layout.offset(getattr(right, part), tables_of(system))
    )
    assert same == shared and not system.equal_sides


def test_one_side_alone_does_not_see_the_other():
    """A wheel has the patches that it has in a wheelset of equal sides with the same pose."""
    sides = dict(nominal_radius=(0.4601, 0.46), rail_inclination=(1 / 39, 1 / 40))
    alike = [
        wrcontact.ContactSystem(**{name: value[k] for name, value in sides.items()}, contact_mode="compliant")
        for k in range(2)
    ]
    mixed = wrcontact.ContactSystem(**sides, contact_mode="compliant")
    for pose in rows(sides, "compliant"):
        shift, yaw, down, roll = pose[
            [layout.IN_LATERAL_SHIFT, layout.IN_YAW, layout.IN_VERTICAL_SHIFT, layout.IN_ROLL]
        ]
        both = mixed.evaluate(shift, yaw, vertical_shift_input=down, roll_input=roll)
        for k, side in enumerate(("left", "right")):
            # its centre stands its own radius above the running circles, that of the mixed one the mean
            higher = sides["nominal_radius"][k] - 0.46005
            alone = alike[k].evaluate(shift, yaw, vertical_shift_input=down + higher, roll_input=roll)
            for name in ("area", "max_pressure", "normal_force", "rolling_radius", "contact_angle"):
                found, wanted = (getattr(getattr(state, side), name) for state in (both, alone))
                # heights differ by 1e-16 m, penetrations are 1e-5 m and more
                assert found == pytest.approx(wanted, rel=1e-8, abs=1e-12), (side, name)


UNLIKE = {
    "profiles": (dict(rail=("54E1", "UIC60")), dict(rail="54E1"), {}),
    "inclinations": (dict(rail_inclination=(1 / 20, 1 / 40)), dict(inclination=1 / 20), {}),
    "radii": (dict(nominal_radius=(0.458, 0.461)), {}, dict(nominal_radius=0.458)),
}


@pytest.mark.full
@pytest.mark.parametrize(
    "case", ["profiles", *(pytest.param(case, marks=pytest.mark.full) for case in ("inclinations", "radii"))]
)
@pytest.mark.parametrize(
    "pose",
    [
        (5.5e-3, 0.02),
        pytest.param((0.5e-3, 0.0), marks=pytest.mark.full),
        pytest.param((-6.2e-3, -0.01), marks=pytest.mark.full),
    ],
)
@pytest.mark.turns(2)
def test_rigid_positions_are_those_of_brute_force(case, pose):
    given, track, changed = UNLIKE[case]
    radii = given.get("nominal_radius", (0.46, 0.46))
    height = dict(height=0.5 * sum(radii))
    right = replace(brute_force.track(), nominal_radius=radii[1], **height)
    left = replace(brute_force.track(**track), **height, **changed)
    wanted = brute_force.rigid_contact(right, *pose, left)
    found = wrcontact.ContactSystem(**given).evaluate(*pose, 0.0)
    assert_positions(found, wanted, rail=("y_rail",))


def test_a_larger_left_wheel_lets_the_wheelset_roll_right_side_down():
    """Two cones on rails: contact keeps its place to first order, so the roll is the difference of the radii
    over the distance of the contacts, and the centre stands at the mean."""
    plain = wrcontact.ContactSystem("cone20").evaluate()
    larger = 0.2e-3
    found = wrcontact.ContactSystem("cone20", nominal_radius=(0.46 + larger, 0.46)).evaluate()
    apart = plain.right.contact.y_track - plain.left.contact.y_track
    # of second order are a shift of the contact by 0.06 mm and the cone's 1:20 under this roll
    assert found.roll == pytest.approx(larger / apart, rel=0.05)
    assert found.vertical_shift == pytest.approx(plain.vertical_shift, abs=0.01 * larger)
    assert found.left.rolling_radius - found.right.rolling_radius == pytest.approx(larger, rel=0.1)


def test_forces_balance_about_the_centre():
    """Moments count about the wheelset's centre, the mean of both radii above the running circles."""
    system = wrcontact.ContactSystem(**SIDES["all"])
    state = system.evaluate(1e-3, 0.0, 8e4)
    height = 0.5 * (0.4615 + 0.459)
    total = np.zeros(3)
    for side in (state.left, state.right):
        for patch in side.patches:
            arm = np.array(
                [patch.x_track, patch.y_track - 1e-3, patch.z_track - (state.vertical_shift - height)]
            )
            total += np.cross(arm, [patch.force.x, patch.force.y, patch.force.z])
    moment = np.array([state.moment.x, state.moment.y, state.moment.z])
    assert moment == pytest.approx(total, rel=1e-9, abs=1e-6)  # [N m]


def test_the_half_space_sees_both_sides():
    """In the mirror, to what the half-space is asked for."""
    chosen = dict(normal_model="halfspace", tolerance=0.05)
    found = wrcontact.ContactSystem(**SIDES["radii"], **chosen).evaluate(1e-3)
    there = wrcontact.ContactSystem(**swapped(SIDES["radii"]), **chosen).evaluate(-1e-3)
    for one, other in ((found.left, there.right), (found.right, there.left)):
        assert one.area == pytest.approx(other.area, rel=0.05)
        assert one.penetration == pytest.approx(other.penetration, rel=0.01)
    kernel = wrcontact.ContactSystem(**SIDES["radii"]).evaluate(1e-3)
    assert found.roll == kernel.roll and found.left.rolling_radius == kernel.left.rolling_radius


def test_a_copy_has_the_same_sides():
    system = wrcontact.ContactSystem(**SIDES["all"])
    copy = pickle.loads(pickle.dumps(system))
    assert np.array_equal(copy.evaluate(1e-3).values, system.evaluate(1e-3).values)
    assert eval(repr(system), {"ContactSystem": wrcontact.ContactSystem}).parameters == system.parameters


@pytest.mark.parametrize(
    "given, words",
    [
        (dict(wheel=("S1002", "UIC60")), "wheel is 'UIC60' (a profile of the other kind; did you swap"),
        (dict(wheel=("UIC60", "S1002")), "left_wheel is 'UIC60' (a profile of the other kind; did you swap"),
        (dict(rail=("UIC60",)), "rail is ('UIC60',); permitted is one value, or (left, right)"),
        (dict(nominal_radius=(0.0, 0.46)), "left_nominal_radius is 0.0; permitted is 0.1 ... 1 m"),
        (dict(nominal_radius=(0.45, 0.46), left_nominal_radius=0.44), "left_nominal_radius is 0.44, but"),
        (dict(left_rail_inclination=0.2), "left_rail_inclination is 0.2; permitted is 0 ... 0.1"),
    ],
)
def test_what_is_refused(given, words):
    with pytest.raises(ValueError) as refusal:
        wrcontact.ContactSystem(**given)
    assert str(refusal.value).startswith(words)


def test_an_upright_left_rail_is_not_that_of_the_right():
    """In Python 0 is a value; only an FMU takes it for "as on the right"."""
    assert not wrcontact.ContactSystem(rail_inclination=(0.0, 1 / 40)).equal_sides


def test_every_parameter_of_the_left_side_stands_beside_one_of_the_right():
    names = [one.name for one in VARIABLES if one.causality == "parameter"]
    assert [name for name in names if name.startswith("left_")] == [
        "left_wheel_profile",
        "left_rail_profile",
        "left_rail_inclination",
        "left_nominal_radius",
        *(
            f"left_rail_{direction}_{kind}"
            for kind in ("stiffness", "damping")
            for direction in ("lateral", "vertical")
        ),
    ]
