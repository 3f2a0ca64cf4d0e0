"""The work of a step is bounded: counts of trials and of searches, never times; and what a step finds where
its equations have no solution, since a force jumps there.

Witnesses are the compliant form on both sides of the jump, and the springs' law.
"""

import numpy as np
import pytest

import wrcontact
from tests.helpers.elastic import carried, compliant, elastic
from tests.helpers.inside import counts_of
from wrcontact import ContactSystem, Status

#: Poses without an equilibrium, in which brackets around brackets took some 1000 solutions of a side: near the
#: track's centre, and where the flange root gives way to the flange.
AT_JUMPS = [
    (-0.0002252, 0.0, 12450.0),
    (0.00028323731898677426, 0.0, 14049.55826880349),
    (-0.00021834354404874732, 0.0, 11857.37632974075),
    (-0.0002870600730216664, -0.005862262719247956, 13841.790112917057),
    (-0.004897752132684291, -0.017834442410487233, 194220.62896930095),
]
#: Poses with one, in which trials that follow the deepest points contradict a search for them.
HIDDEN = [
    (-0.006017456757690824, 0.02959442139722454, 29704.693451247294),
    (-0.006217536055066883, -0.020150010234988525, 130542.16528259638),
]
#: Poses whose last trial contradicts the points that were followed: 34 or 35 trials, and 50 ... 58 where Newton's
#: method then goes on instead of a bracket.
CONTRADICTED = [
    (0.005082852310168998, -0.015457963454034718, 259033.8674792424),
    (-0.0050861321730791675, 0.001738413404493426, 247857.2705299917),
    (-0.00011841995995655677, -0.003472530344036509, 48866.972497927665),
]
#: Poses with one, in which a trial far above it had D of the wrong sign: the bracket closed where a wheel lacks
#: 5e-4 and 1.3e-3 of its load.
MISJUDGED = [(-0.006053683, 0.032544573, 199839.794226237), (-0.00603373, 0.028837116, 31393.34541602)]
#: Measured: 52 trials at most over 10 000 random poses, 11 in the median; those of the rigid roll are among them.
MOST_TRIALS = 60
#: Measured: 16 ... 24, and 38 ... 44 where a bracket around the jump was halved.
TRIALS_AT_JUMP = 27


def trials(stepper, pose):
    """Trials of a step at shift [m], yaw [rad] and force [N]; its status."""
    stepper.inputs[[stepper.place(name) for name in ("lateral_shift", "yaw", "normal_force")]] = pose
    before = counts_of(stepper)["roll"]
    status = stepper.step()
    return counts_of(stepper)["roll"] - before, status


@pytest.mark.parametrize("pose", AT_JUMPS + HIDDEN)
@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
def test_elastic_trials_are_few(pose, model):
    count, status = trials(elastic(normal_model=model).stepper(), pose)
    assert status == 0 and count <= MOST_TRIALS


@pytest.mark.parametrize("pose", AT_JUMPS)
@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
def test_a_jump_is_found_in_few_trials(pose, model):
    count, status = trials(elastic(normal_model=model).stepper(), pose)
    assert status == 0 and count <= TRIALS_AT_JUMP


@pytest.mark.parametrize("pose", CONTRADICTED)
def test_a_contradiction_ends_newton_s_method(pose):
    count, status = trials(elastic(normal_model="analyn").stepper(), pose)
    assert status == 0 and count <= 24


@pytest.mark.full
@pytest.mark.parametrize("model", ["hertz", "analyn"])
def test_elastic_trials_are_few_in_random_poses(model):
    random, stepper = np.random.default_rng(37), elastic(normal_model=model).stepper()
    for _ in range(5000):
        shift, yaw = random.uniform((-6.6e-3, -0.0349), (6.6e-3, 0.0349))
        count, status = trials(stepper, (shift, yaw, 10 ** random.uniform(3.5, 5.3)))
        assert status == 0 and count <= MOST_TRIALS


@pytest.mark.parametrize("pose", AT_JUMPS)
def test_a_wheel_that_jumps_past_its_load_stands_at_the_jump(pose):
    """The compliant form carries less 3 nm higher and more 3 nm lower, at the wheel that jumps; the other one
    carries its load, as far as 1 nm tells."""
    shift, yaw, force = pose
    state = elastic().evaluate(shift, yaw, force)
    loads = []
    for away in (-3e-9, 3e-9):
        pressed = compliant().evaluate(
            shift, yaw, vertical_shift_input=state.vertical_shift + away, roll_input=state.roll
        )
        loads.append([carried(side, "normal") / force - 1 for side in (pressed.left, pressed.right)])
    lack = np.array(loads)
    assert (lack[0] < 0).all() and (lack[1] > 0).all()
    jump = np.ptp(lack, axis=0)
    assert jump.max() > 0.01 and jump.min() < 1e-3


@pytest.mark.parametrize("pose", [AT_JUMPS[0], AT_JUMPS[3], AT_JUMPS[4]])
def test_a_wheel_that_jumps_stands_where_it_carries_no_less_than_its_load(pose):
    """... in the two others it cannot: there it stands at the other end of the jump, and lacks at most 4e-4."""
    state = elastic().evaluate(*pose)
    pressed = compliant().evaluate(
        *pose[:2], vertical_shift_input=state.vertical_shift, roll_input=state.roll
    )
    left, right = (carried(side, "normal") / pose[2] - 1 for side in (pressed.left, pressed.right))
    assert left > 0.01 and abs(right) < 1e-9


@pytest.mark.parametrize(
    "pose, model", [(pose, "analyn") for pose in HIDDEN] + [(pose, "analyn_strip") for pose in MISJUDGED]
)
def test_an_equilibrium_that_a_search_finds_is_one(pose, model):
    """Both wheels carry their loads in the compliant form."""
    shift, yaw, force = pose
    state = elastic(normal_model=model).evaluate(shift, yaw, force)
    pressed = compliant(normal_model=model).evaluate(
        shift, yaw, vertical_shift_input=state.vertical_shift, roll_input=state.roll
    )
    for side in (pressed.left, pressed.right):
        assert carried(side, "normal") == pytest.approx(force, rel=1e-6)


@pytest.mark.full
@pytest.mark.parametrize("model", ["hertz", "analyn", "analyn_strip"])
def test_wheels_carry_their_loads_or_stand_at_a_jump(model):
    """The compliant form carries both loads where the elastic one stands, or less 0.1 nm higher and more 0.1 nm
    lower.  At jumps of Hertz 30 of 4000 poses stand, of the others fewer."""
    random = np.random.default_rng(371)
    shift, yaw = random.uniform(-6.6e-3, 6.6e-3, 4000), random.uniform(-0.0349, 0.0349, 4000)
    force = 10 ** random.uniform(3.5, 5.3, 4000)
    inputs = {"lateral_shift": shift, "yaw": yaw}
    stands = elastic(normal_model=model).evaluate_many(**inputs, normal_force=force)
    assert (stands.status == 0).all()

    def lack(away):
        pressed = compliant(normal_model=model).evaluate_many(
            **inputs, vertical_shift_input=stands.vertical_shift + away, roll_input=stands.roll
        )
        return np.array([pressed.left.normal_force, pressed.right.normal_force]) / force - 1

    balanced = (abs(lack(0.0)) < 1e-6).all(axis=0)
    at_jump = (lack(-1e-10) < 1e-6).all(axis=0) & (lack(1e-10) > -1e-6).all(axis=0)
    wrong = np.flatnonzero(~balanced & ~at_jump)
    assert not wrong.size, [(shift[i], yaw[i], force[i]) for i in wrong]
    assert balanced.mean() > 0.98


# --- rails on springs -------------------------------------------------------------------------------------

SPRINGS = {
    "rail_lateral_stiffness": 2e7,
    "rail_vertical_stiffness": 5e7,
    "rail_lateral_damping": 5e4,
    "rail_vertical_damping": 1e5,
}


@pytest.mark.parametrize("friction, most", [("none", 240), ("strips", 110)])
def test_springs_settle_in_few_searches(friction, most):
    """Measured in 1000 poses: 25 searches of a smallest gap at 99 of 100, 197 and 81 at most, the first where
    a force jumps past the springs."""
    stepper = wrcontact.ContactSystem(
        contact_mode="compliant", tangential_model=friction, **SPRINGS
    ).stepper()
    random, counts = np.random.default_rng(3), []
    for _ in range(300):
        load = 10 ** random.uniform(3.6, 5.3)
        inputs = {
            "lateral_shift": random.uniform(-7e-3, 7e-3),
            "yaw": random.normal(0, 5e-3),
            "vertical_shift_input": load / 5e7 + 1e-4 * (load / 8e4) ** (2 / 3),
            "speed": 20.0,
            "wheel_rate": 20.0 / 0.46,
            "lateral_velocity": random.normal(0, 0.02),
            "rail_time_step": 1e-3,
        }
        for side in ("left", "right"):
            inputs[f"{side}.rail_deflection_vertical_before"] = load / 5e7 * random.normal(1, 0.1)
            inputs[f"{side}.rail_deflection_lateral_before"] = random.normal(0, 1e-4)
        stepper.inputs[[stepper.place(name) for name in inputs]] = list(inputs.values())
        before = counts_of(stepper)["scan"]
        assert stepper.step() <= 1
        counts.append(counts_of(stepper)["scan"] - before)
    assert max(counts) <= most and np.quantile(counts, 0.9) <= 40


#: Rails without dampers.
BARE = {"rail_lateral_stiffness": 2e7, "rail_vertical_stiffness": 5e7}


def standing(count):
    """Inputs by name (count,) of random wheelsets where they stand on rails on springs, but for these being
    rigid sideways."""
    random = np.random.default_rng(5)
    rows = random.uniform((-6.6e-3, -0.035, np.log(3e3)), (6.6e-3, 0.035, np.log(2e5)), (count, 3))
    rows[::2, 1] = 0.0
    rows[:, 2] = np.exp(rows[:, 2])
    stands = elastic().evaluate_many(*rows.T)
    return {
        "lateral_shift": rows[:, 0],
        "yaw": rows[:, 1],
        "vertical_shift_input": stands.vertical_shift + rows[:, 2] / BARE["rail_vertical_stiffness"],
        "roll_input": stands.roll,
    }


def searches(stepper, inputs, k):
    """Searches of a smallest gap in a step at row ``k`` of the inputs, and its status."""
    for name, values in inputs.items():
        stepper.inputs[stepper.place(name)] = values[k]
    before = counts_of(stepper)["scan"]
    status = stepper.step()
    return counts_of(stepper)["scan"] - before, status


#: Usual and largest numbers of searches that are permitted without friction, and of wheels that roll freely.
#: Measured: 17, 19 and 18 usual, 315, 197 and 48 at most; 52 … 54, and 528 … 618, 165 and 404 where a rail that
#: stands at a jump settles from rest on once more, at the rate that was found; how often brackets there are halved hangs
#: on rounding.
MOST_SEARCHES = {"hertz": (19, 340, 58, 650), "analyn": (20, 220, 60, 180), "analyn_strip": (20, 60, 60, 430)}


@pytest.mark.parametrize("model", MOST_SEARCHES)
def test_no_rail_on_springs_takes_long_to_settle(model):
    """Also where its contact is about to leave tread or flange, and its force jumps past the springs."""
    usual, most, *_ = MOST_SEARCHES[model]
    stepper = ContactSystem(contact_mode="compliant", normal_model=model, **BARE).stepper()
    inputs = standing(1500)
    counts, statuses = zip(*(searches(stepper, inputs, k) for k in range(1500)))
    assert max(statuses) == 0
    assert np.median(counts) <= usual and max(counts) <= most, (max(counts), np.argmax(counts))


@pytest.mark.parametrize("model", MOST_SEARCHES)
def test_rails_settle_quickly_under_wheels_that_roll_freely(model):
    """For each rate that is tried they settle from where they stand; at a jump they stay, but for the last rate."""
    *_, usual, most = MOST_SEARCHES[model]
    stepper = ContactSystem(
        contact_mode="compliant", normal_model=model, tangential_model="strips", **BARE
    ).stepper()
    inputs = standing(300) | {"speed": np.full(300, 20.0)}
    counts, statuses = zip(*(searches(stepper, inputs, k) for k in range(300)))
    assert max(statuses) == 0
    assert np.median(counts) <= usual and max(counts) <= most, (max(counts), np.argmax(counts))


def test_rails_under_free_wheels_stand_where_they_stand_at_the_rate_that_was_found():
    """The same rate as an input lets the rails settle from rest on."""
    system = ContactSystem(contact_mode="compliant", tangential_model="strips", **BARE)
    inputs = standing(60) | {"speed": 20.0}
    free = system.evaluate_many(**inputs)
    given = system.evaluate_many(**inputs, wheel_rate=free.right.wheel_rate_found)
    for one, other in ((free.left, given.left), (free.right, given.right)):
        for which in ("rail_deflection_lateral", "rail_deflection_vertical"):
            np.testing.assert_allclose(getattr(one, which), getattr(other, which), rtol=0.0, atol=1e-12)
    assert np.max(np.abs(free.driving_torque)) < 1e-4  # [N m]


def test_a_rail_at_a_jump_stands_between_what_its_wheel_presses_on_both_sides():
    """Hertz, a wheel on tread or flange: on rails that are rigid within 50 nm of where the springs stand it
    presses more than these carry, and less."""
    system = ContactSystem(contact_mode="compliant", normal_model="hertz", **BARE)
    rigid = ContactSystem(contact_mode="compliant", normal_model="hertz")
    inputs, found = standing(1000), 0
    table = system.evaluate_many(**inputs)
    left, side = table.left, table.right
    across, down = side.rail_deflection_lateral, side.rail_deflection_vertical
    carried_across = -BARE["rail_lateral_stiffness"] * across
    carried_down = -BARE["rail_vertical_stiffness"] * down
    missed = np.abs(side.force.y - carried_across) + np.abs(side.force.z - carried_down)
    for k in np.flatnonzero(missed > 1e-3 * np.abs(side.force.z)):
        around = [
            rigid.evaluate(
                **{name: values[k] for name, values in inputs.items()},
                right_rail_lateral=across[k] + aside,
                right_rail_vertical=down[k] + away,
                left_rail_vertical=left.rail_deflection_vertical[k],
            ).right.force
            for aside in (-5e-8, 0.0, 5e-8)
            for away in (-5e-8, 0.0, 5e-8)
        ]
        lateral, vertical = [force.y for force in around], [force.z for force in around]
        assert min(lateral) < carried_across[k] < max(lateral) or min(vertical) < carried_down[k] < max(
            vertical
        ), k
        found += 1
    assert found >= 8


# --- what a step keeps ------------------------------------------------------------------------------------


def test_a_penetration_that_changes_in_place_is_another_one():
    system = wrcontact.ContactSystem()
    asked = np.array([5e-5, 6e-5])
    assert system.evaluate(3e-3, penetration=asked).right.penetration == pytest.approx(6e-5, rel=1e-12)
    asked[1] = 8e-5
    assert system.evaluate(3e-3, penetration=asked).right.penetration == pytest.approx(8e-5, rel=1e-12)


def test_a_patch_between_two_strips_has_pressure_and_length():
    """A sliver of 2 mN: those of an ellipse with its load, area and width."""
    state = wrcontact.ContactSystem().evaluate(
        0.00016353951946166366, 0.006192928493336386, 4633.023531096806
    )
    for patch in state.right.patches:
        assert patch.max_pressure > patch.normal_force / patch.area > 0 and patch.length > 0
    sliver = min(state.right.patches, key=lambda patch: patch.normal_force)
    assert sliver.normal_force < 0.1  # [N]
    assert np.pi / 4 * sliver.length * sliver.width == pytest.approx(sliver.area, rel=1e-12)
    assert 2 / 3 * sliver.max_pressure * sliver.area == pytest.approx(sliver.normal_force, rel=1e-12)


# --- forces beyond what contacts are computed for -----------------------------------------------------------


@pytest.mark.parametrize("model", ["hertz", "analyn", "analyn_strip"])
@pytest.mark.parametrize("mode", ["rigid", "elastic"])
def test_no_load_presses_a_wheel_deeper_than_two_millimetres(mode, model):
    """Up to 40 MN, with a penetration that grows until the step is refused; a rigid wheel of 100 MN was 13 mm
    deep in its rail."""
    system = ContactSystem(contact_mode=mode, normal_model=model)
    loads = np.geomspace(1e5, 4e7, 30)
    table = system.evaluate_many(1e-3, normal_force=loads)
    valid = table.status == Status.VALID
    first = np.argmin(valid)
    assert 10 < first < 29 and not valid[first:].any()
    assert set(table.status[first:]) <= {Status.OFF_PROFILE, Status.NOT_CONVERGED}
    depths = table.right.penetration[:first]
    assert np.all(np.diff(depths) > 0.0) and 1.5e-3 < depths[-1] <= 2e-3
    if mode == "rigid":
        assert system.evaluate(1e-3, penetration=2.1e-3).status == Status.VALID
        # the one wheel that is too deep may be the left one
        for side, transfer in (("left", -0.9), ("right", 0.9)):
            heavier = system.evaluate_many(1e-3, normal_force=loads, load_transfer=transfer)
            deepest = np.nanmax(getattr(heavier, side).penetration)
            assert 1.5e-3 < deepest <= 2e-3 and heavier.status[-1] == Status.OFF_PROFILE


@pytest.mark.parametrize("load", ["normal", "vertical"])
@pytest.mark.parametrize("mode", ["rigid", "elastic"])
def test_a_wheel_of_next_to_no_load_has_none(mode, load):
    """Below 1e-10 N, where loads were not met; above, both wheels carry theirs."""
    system = ContactSystem(contact_mode=mode, load=load, tangential_model="strips")
    transfer = np.concatenate([1.0 - 2.0 ** -np.arange(20.0, 54.0), [1.0]])
    for force in (1e-4, 1.0, 5e4):
        found = system.evaluate_many(
            -1.3729e-3, -22.4e-3, normal_force=force, load_transfer=transfer, speed=20.0
        )
        carried = force * (1.0 - transfer)
        np.testing.assert_array_equal(found.status, np.where(carried < 1e-10, Status.UNLOADED, Status.VALID))
        wanted = found.left.normal_force if load == "normal" else -found.left.force.z
        np.testing.assert_allclose(wanted, np.where(carried < 1e-10, 0.0, carried), rtol=1e-8)
