"""The rotation without torque, or with a given one: against bisections and scans over the rate, sums over
strips, closed forms, balances of power, and differences."""

import warnings

import numpy as np
import pytest

import wrcontact
from tests.helpers.cases import CREEP_MODELS
from tests.helpers.cone import cone_system
from tests.helpers.inside import work_of

SPEED, LOAD = 20.0, 78.5e3
POSES = {
    "centred": {},
    "tread": {"lateral_shift": 1.5e-3, "yaw": 1e-3},
    "moving": {"lateral_shift": -3e-3, "yaw": 4e-3, "lateral_velocity": 0.03, "yaw_rate": 0.02},
    "two patches": {"lateral_shift": 4.95e-3},
    "flange": {"lateral_shift": 6.6e-3, "yaw": -4e-3, "track_curvature": 1 / 300, "left_friction": 0.15},
}
MODES = ("rigid", "elastic", "compliant")


def system(model="strips", mode="rigid", **parameters):
    return wrcontact.ContactSystem(
        wheel="S1002", rail="60E1", tangential_model=model, contact_mode=mode, **parameters
    )


def posed(mode, pose):
    """The pose with height and roll where these are inputs."""
    given = {"speed": SPEED, "normal_force": LOAD, **pose}
    if mode == "compliant":
        names = ("lateral_shift", "yaw", "normal_force")
        stand = system("none", "elastic").evaluate(**{name: given[name] for name in names if name in given})
        given |= {"vertical_shift_input": stand.vertical_shift, "roll_input": stand.roll}
    return given


def scale(state, given):
    """Torque of all friction [N m]."""
    return sum(
        given.get(f"{name}_friction", 0.3) * side.normal_force * 0.46
        for name, side in (("left", state.left), ("right", state.right))
    )


def bisected(torque, low, high):
    """Where a torque that falls between two rates is zero."""
    assert torque(low) > 0.0 > torque(high)
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if torque(middle) > 0.0 else (low, middle)
    return 0.5 * (low + high)


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("model", CREEP_MODELS)
@pytest.mark.parametrize("pose", POSES)
def test_it_is_the_rate_without_torque(pose, model, mode):
    """That of a bisection over wheel_rate, with all other outputs; the torque is 1e-9 of that of friction."""
    one, given = system(model, mode), posed(mode, POSES[pose])
    free = one.evaluate(**given)
    assert free.status == 0 and abs(free.driving_torque) <= 1e-9 * scale(free, given)
    found = free.right.wheel_rate_found
    assert found == free.left.wheel_rate_found != SPEED / 0.46
    rate = bisected(
        lambda rate: one.evaluate(**given, wheel_rate=rate, outputs="patches").driving_torque,
        0.9 * SPEED / 0.46,
        1.1 * SPEED / 0.46,
    )
    # a torque of 1e-9 of that of friction, over its slope: stiffness of some patches times the radius; FaStrip's
    # force jumps, and has several such rates close together
    assert found == pytest.approx(rate, rel=1e-6 if model == "fastrip" else 1e-10)
    same = one.evaluate(**given, wheel_rate=found)
    np.testing.assert_array_equal(free.values, same.values)


@pytest.mark.parametrize("pose", ["centred", "tread", "two patches"])
def test_strips_and_what_comes_to_them_have_no_torque_in_sum(pose):
    """Without yaw: longitudinal forces times the radii where they act, and moments of spin."""
    stepper = system().stepper()
    given = {"speed": SPEED, **{name: value for name, value in POSES[pose].items() if name != "yaw"}}
    for name, value in given.items():
        stepper.inputs[stepper.place(name)] = value
    assert stepper.step() == 0
    torque = friction = 0.0
    for side in work_of(stepper).sides:
        axle = np.array([side.motion.axle_y, side.motion.axle_z])
        for patch in side.patches[: side.patch_count]:
            forces = np.array([strip.force_x * strip.width for strip in patch.strips])
            radii = np.array([strip.rolling_radius for strip in patch.strips])
            torque -= (forces * radii).sum() + (patch.creep_x - forces.sum()) * patch.rolling_radius
            # and the moments about the normals, which meet the axle at the contact angle
            moments = np.array([strip.moment * strip.width for strip in patch.strips])
            normals = np.array([(-strip.sin, strip.cos) for strip in patch.strips])
            rest = patch.creep_moment - moments.sum() + (forces * [strip.y for strip in patch.strips]).sum()
            torque -= (moments * (normals @ axle)).sum()
            torque -= rest * (axle @ (patch.angle_sin, patch.angle_cos))
            friction += 0.3 * patch.totals.load * patch.rolling_radius
    assert abs(torque) < 2e-9 * friction


@pytest.mark.parametrize("model", ["strips", "polach"])
@pytest.mark.parametrize("pose", POSES)
def test_no_other_rate_is_without_torque(pose, model):
    """The torque falls all the way over 121 rates, from half to twice the one that is found."""
    one, given = system(model), posed("rigid", POSES[pose])
    found = one.evaluate(**given).right.wheel_rate_found
    rates = np.unique(
        np.concatenate([found * np.linspace(0.5, 2.0, 61), found * np.linspace(0.98, 1.02, 61)])
    )
    torques = one.evaluate_many(**given, wheel_rate=rates, outputs="driving_torque").driving_torque
    assert (np.sign(torques[rates < found]) == 1).all() and (np.sign(torques[rates > found]) == -1).all()
    # Polach's formula rises by less than 5e-5 of the friction's torque where its creep forces saturate
    assert np.diff(torques).max() < 5e-5 * 0.3 * 2 * LOAD * 0.46


@pytest.mark.parametrize("mode", MODES)
def test_power(mode):
    """Without a torque, friction takes the power of the forces on the wheelset's centre and of its yaw; with
    one, that of the torque too."""
    one, given = system(mode=mode), posed(mode, {"lateral_shift": 4e-3, "yaw": 2e-3})
    for torque in (0.0, 3e3, -3e3):
        state = one.evaluate(**given, axle_torque=torque)
        taken = state.left.friction_power + state.right.friction_power
        # rigid and elastic wheelsets do not move down or roll here: no velocity across, no yaw rate
        given_power = -state.force.x * SPEED + torque * state.right.wheel_rate_found
        assert taken == pytest.approx(given_power, rel=1e-6) and taken > 0.0


def test_it_saves_power():
    """A wheelset at speed / nominal_radius is braked by 0.7 kN m where it is centred, and by 7 kN m near the
    flange; a free one has a quarter more of yaw moment there."""
    free, nominal = system(), system(nominal_rolling=True)
    for shift, torque in ((0.0, 600.0), (4.95e-3, 7000.0)):
        one, other = (each.evaluate(shift, speed=SPEED) for each in (free, nominal))
        powers = [state.left.friction_power + state.right.friction_power for state in (one, other)]
        assert powers[0] < powers[1] and abs(other.driving_torque) > torque
    assert other.right.wheel_rate_found == SPEED / 0.46
    np.testing.assert_array_equal(
        other.values, free.evaluate(4.95e-3, speed=SPEED, wheel_rate=SPEED / 0.46).values
    )
    assert one.moment.z / other.moment.z == pytest.approx(1.246, abs=0.005)


@pytest.mark.parametrize("conicity", [0.025, 0.1])
def test_cones(conicity):
    """Two cones have opposite creepages, so that w = V (r_l + r_r) / (r_l^2 + r_r^2), or V / r where they are
    centred."""
    for shift in (0.0, 0.5e-3):
        state = cone_system(conicity, tangential_model="strips", normal_model="hertz").evaluate(
            lateral_shift=shift, speed=SPEED
        )
        left, right = state.left.patches[0], state.right.patches[0]
        radii = np.array([left.rolling_radius, right.rolling_radius])
        assert state.right.wheel_rate_found == pytest.approx(SPEED * radii.sum() / (radii**2).sum(), rel=1e-6)
        assert right.creepage.x == pytest.approx(-left.creepage.x, rel=0.01, abs=1.5e-6)


@pytest.mark.parametrize("mode", MODES)
def test_independent_wheels_and_one_wheel(mode):
    """Each is without torque; a wheel by itself is one of them, whatever the other does."""
    independent = system(mode=mode, independent_wheels=True)
    given = posed(mode, POSES["moving"])
    state = independent.evaluate(**given)
    for side in (state.left, state.right):
        assert abs(side.driving_torque) < 1e-9 * 0.3 * LOAD * 0.46 * 1.1
    assert state.left.wheel_rate_found != state.right.wheel_rate_found
    driven = independent.evaluate(**given, right_axle_torque=2e3)
    assert driven.right.driving_torque == pytest.approx(-2e3, abs=1e-4)
    assert driven.left.wheel_rate_found == state.left.wheel_rate_found
    held = independent.evaluate(**given, left_wheel_rate=43.0, axle_torque=1e5)
    assert held.left.wheel_rate_found == 43.0 and held.right.force.x == state.right.force.x
    if mode == "compliant":
        del given["normal_force"]
        for side in ("left", "right"):
            wheel = wrcontact.WheelContact(
                wheel="S1002", rail="60E1", tangential_model="strips", side=side
            ).evaluate(**given)
            assert wheel.wheel_rate_found == getattr(state, side).wheel_rate_found
            assert wheel.force.y == getattr(state, side).force.y


@pytest.mark.parametrize("mode", MODES)
def test_one_side_has_the_values_of_both(mode):
    one, given = system(mode=mode), posed(mode, POSES["two patches"])
    both = one.evaluate(**given)
    for side in ("left", "right"):
        alone = one.evaluate(**given, side=side)
        assert alone.status == both.status
        for name in ("wheel_rate_found", "driving_torque", "normal_force"):
            assert getattr(getattr(alone, side), name) == getattr(getattr(both, side), name)


@pytest.mark.parametrize("model", CREEP_MODELS)
@pytest.mark.parametrize("share", [0.05, 0.5, 0.9, 0.97])
def test_a_torque_is_carried(share, model):
    """The creep forces have the opposite one, of a motor or a brake."""
    one = system(model)
    most = 0.3 * 2 * LOAD * 0.46
    free = one.evaluate(2e-3, 1e-3, speed=SPEED).right.wheel_rate_found
    for torque in (share * most, -share * most):
        state = one.evaluate(2e-3, 1e-3, speed=SPEED, axle_torque=torque)
        assert state.status == 0
        assert state.driving_torque == pytest.approx(-torque, abs=1e-9 * 1.01 * most)
        assert state.force.x == pytest.approx(torque / 0.46, rel=0.02)
        assert (state.right.wheel_rate_found - free) * torque > 0.0


def test_more_than_the_wheels_carry_is_a_status():
    one = system()
    for torque in (0.3 * 2 * LOAD * 0.46 * 1.01, -1e5):
        state = one.evaluate(2e-3, speed=SPEED, axle_torque=torque)
        assert state.status == wrcontact.Status.BEYOND_ADHESION
        words = wrcontact.explain(state.status, state.inputs)
        assert words.startswith(f"axle_torque is {torque:g} N.m") and "spin or slide" in words
    assert one.evaluate(2e-3, speed=SPEED, axle_torque=6e4, left_friction=1.0, right_friction=1.0).status == 0
    smooth = one.evaluate(2e-3, speed=SPEED, axle_torque=1.0, left_friction=0.0, right_friction=0.0)
    assert smooth.status == wrcontact.Status.BEYOND_ADHESION
    far = system().evaluate(axle_torque=2e7)
    assert far.status == 4 and "|axle_torque| <= 1e+07 N.m" in wrcontact.explain(4, far.inputs)
    given = one.evaluate(2e-3, speed=SPEED, axle_torque=1e5, wheel_rate=43.4)
    assert given.status == 0 and given.right.wheel_rate_found == 43.4  # where it is not read


def test_standstill_and_backwards():
    """The same rate over speed down to rest, with the other sign on the way back; a wheelset at rest carries
    the torque of its motor, as static friction does."""
    one = system()
    usual = one.evaluate(1e-3, speed=SPEED).right.wheel_rate_found / SPEED
    for speed in (-SPEED, 1e-3, -1e-6, 1e-8):
        assert one.evaluate(1e-3, speed=speed).right.wheel_rate_found / speed == pytest.approx(
            usual, rel=2e-9
        )
    held = one.evaluate(1e-3, axle_torque=5e3)
    assert held.status == 0 and held.driving_torque == pytest.approx(-5e3, abs=1e-4)
    assert held.force.x == pytest.approx(5e3 / 0.46, rel=1e-3) and abs(held.right.wheel_rate_found) < 1e-11
    turning = one.evaluate(1e-3, yaw_rate=0.01)
    assert abs(turning.driving_torque) < 1e-9 * 0.3 * 2 * LOAD * 0.47 and turning.moment.z < -3e4


def test_without_friction_the_nominal_radius_counts():
    """No torque tells of a rate."""
    for state in (
        system("none").evaluate(2e-3, speed=SPEED),
        system().evaluate(2e-3, speed=SPEED, left_friction=0.0, right_friction=0.0),
    ):
        assert state.right.wheel_rate_found == SPEED / 0.46 and state.driving_torque == 0.0


def test_a_step_does_not_see_those_before_it():
    rng = np.random.default_rng(4)
    given = {
        "lateral_shift": rng.uniform(-6.5e-3, 6.5e-3, 60),
        "speed": rng.choice([20.0, 1.0, -30.0], 60),
        "axle_torque": rng.choice([0.0, 4e3, -8e3], 60),
    }
    names = ["right.wheel_rate_found", "right.tangential.x", "status"]
    del names[1]
    one = system().evaluate_many(**given, outputs=names, threads=1)["right.wheel_rate_found"]
    order = rng.permutation(60)
    for threads in (1, 2):
        other = system().evaluate_many(
            **{name: values[order] for name, values in given.items()}, outputs=names, threads=threads
        )
        np.testing.assert_array_equal(other["right.wheel_rate_found"], one[order])


#: A pose with three rates without torque where friction falls steeply, found at random.
SEVERAL = {
    "lateral_shift": 6.3e-3,
    "speed": 40.0,
    "normal_force": 70e3,
    "track_curvature": 1 / 300,
    "yaw": 2e-3,
}


@pytest.mark.parametrize("fall, rate", [(0.4, 0.6), (0.2, 2.0)])
def test_falling_friction_has_the_rate_that_constant_friction_leads_to(fall, rate):
    """Followed by bisection around the last one as the fall begins, in forty steps."""
    found = system().evaluate(**SEVERAL).right.wheel_rate_found
    for part in np.linspace(0.0, rate, 41)[1:]:
        one = system(friction_fall=fall, friction_fall_rate=part)
        near = found * (1.0 + np.linspace(-2e-3, 2e-3, 41))
        torques = one.evaluate_many(**SEVERAL, wheel_rate=near, outputs="driving_torque").driving_torque
        at = np.flatnonzero((torques[:-1] > 0.0) & (torques[1:] <= 0.0))
        cell = at[np.argmin(np.abs(near[at] - found))]
        found = bisected(
            lambda w: one.evaluate(**SEVERAL, wheel_rate=w, outputs="patches").driving_torque,
            near[cell],
            near[cell + 1],
        )
    state = one.evaluate(**SEVERAL)
    assert state.right.wheel_rate_found == pytest.approx(found, rel=1e-9)
    assert abs(state.driving_torque) < 1e-9 * 0.3 * 2 * 70e3 * 0.46


def test_falling_friction_carries_less():
    """Beyond the largest torque in a scan over the rate there is a status, below it the first rate."""
    one = system(friction_fall=0.4, friction_fall_rate=0.6)
    rates = SPEED / 0.46 * (1.0 + np.geomspace(1e-5, 1.0, 2000))
    carried = -one.evaluate_many(1e-3, speed=SPEED, wheel_rate=rates, outputs="driving_torque").driving_torque
    most = carried.max()
    assert carried[-1] < 0.7 * most
    for share in (0.3, 0.9, 0.999):
        state = one.evaluate(1e-3, speed=SPEED, axle_torque=share * most)
        first = rates[np.argmax(carried > share * most)]
        assert state.driving_torque == pytest.approx(-share * most, abs=1e-4)
        assert state.right.wheel_rate_found == pytest.approx(first, rel=2e-4)
    assert one.evaluate(1e-3, speed=SPEED, axle_torque=1.001 * most).status == 5


BY = {
    "lateral_shift": 1e-8,
    "yaw": 1e-8,
    "speed": 1e-4,
    "lateral_velocity": 1e-7,
    "yaw_rate": 1e-6,
    "normal_force": 1.0,
    "left.friction": 1e-6,
    "axle_torque": 1e-1,
}
OF = ["right.wheel_rate_found", "force.y", "moment.z", "right.friction_power", "driving_torque"]


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("torque", [0.0, 3e3])
def test_derivatives(mode, torque):
    """Against differences of free wheelsets over distances within which contact has no kinks; torques vanish
    to 1e-11 and less of that of friction where the search ends."""
    one = system(mode=mode)
    given = posed(mode, POSES["moving"]) | {"axle_torque": torque}
    by = [name for name in BY if not (mode == "compliant" and name == "normal_force")]
    found = one.derivatives(OF, by, **given)
    size = np.array([50.0, 1e4, 1e4, 1e3, 1e3])
    start = {"left.friction": 0.3}
    for column, name in enumerate(by):
        key, step = name.replace(".", "_"), BY[name]
        value = given.get(key, start.get(name, 0.0))
        if mode == "elastic" and name == "lateral_shift":
            # forces and power scatter by 2e-11 and 5e-11 of themselves, over 1e-8 m 4e-3 of the power's change
            step *= 10.0
        high, low = (one.evaluate(**given | {key: value + way * step}) for way in (1, -1))
        wanted = np.array([(high[output] - low[output]) / (2.0 * step) for output in OF])
        near = 1e-11 * size / step
        off = np.abs(found[:, column] - wanted)
        assert (off < 2e-4 * np.abs(wanted) + near)[:-1].all(), (name, found, wanted)
    assert found[4, by.index("axle_torque")] == pytest.approx(-1.0, abs=1e-12)
    np.testing.assert_allclose(found[4, : by.index("axle_torque")], 0.0, atol=1e-2)


def test_vertical_loads_and_rails_on_springs():
    """Where creep forces change the contact, they are those without torque, too."""
    vertical = system(load="vertical").evaluate(**posed("rigid", POSES["flange"]))
    assert vertical.status == 0 and abs(vertical.driving_torque) < 1e-3 * 0.5
    assert -vertical.right.force.z == pytest.approx(LOAD, rel=1e-9)
    springs = {"rail_lateral_stiffness": 2e7, "rail_vertical_stiffness": 5e7}
    soft, given = system(mode="compliant", **springs), posed("compliant", POSES["tread"])
    given["vertical_shift_input"] += 2e-3
    state = soft.evaluate(**given)
    assert state.status == 0 and abs(state.driving_torque) < 1e-9 * scale(state, given)
    rate = bisected(lambda w: soft.evaluate(**given, wheel_rate=w).driving_torque, 43.0, 44.0)
    # springs settle to 1e-8 of their forces
    assert state.right.wheel_rate_found == pytest.approx(rate, rel=1e-9)
    found = soft.derivatives(OF[:3], ["lateral_velocity"], **given)[:, 0]
    high, low = (soft.evaluate(**given, lateral_velocity=way * 1e-6) for way in (1, -1))
    wanted = np.array([(high[name] - low[name]) / 2e-6 for name in OF[:3]])
    np.testing.assert_allclose(found, wanted, rtol=1e-4, atol=1e-4 * np.abs(wanted).max())


@pytest.mark.parametrize("model", ["fastrip", "strips"])
def test_light_wheelsets_roll_freely(model):
    """Of 0.1 N to 100 N a wheel: a solution is found for each, which leaves next to nothing of the torque that
    friction could have."""
    low, high = (-4e-3, -0.03, -1.0, -0.1, -0.02), (4e-3, 0.03, 2.0, 0.1, 0.02)
    shift, yaw, power, lateral, turn = np.random.default_rng(9).uniform(low, high, (100, 5)).T
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # loads that small are unusual
        table = wrcontact.ContactSystem(tangential_model=model).evaluate_many(
            shift, yaw, normal_force=10.0**power, speed=20.0, lateral_velocity=lateral, yaw_rate=turn
        )
    left = np.abs(table.driving_torque) / (0.3 * 0.46 * 10.0**power)
    for k in range(100):
        assert table.status[k] == 0 and left[k] < 1e-8, (shift[k], yaw[k], 10.0 ** power[k])
