"""Contact damping of a compliant wheelset."""

import numpy as np
import pytest

import wrcontact
from tests.helpers import motion
from tests.helpers.cases import system
from tests.helpers.motion import about_x, runge_kutta

FORCE, DAMPING = 78.5e3, 0.4
POSES = [(0.0, 0.0), (3e-3, 0.01), (5.2e-3, 0.0), (-6.2e-3, -0.015)]


def pressed(shift, yaw, model="analyn", damping=DAMPING, **motion):
    stand = system(contact_mode="elastic", normal_model=model).evaluate(shift, yaw)
    return system(contact_mode="compliant", normal_model=model, contact_damping=damping).evaluate(
        shift, yaw, vertical_shift_input=stand.vertical_shift, roll_input=stand.roll, **motion
    )


def vector(of):
    return np.array([of.x, of.y, of.z])


@pytest.mark.parametrize("model", ["hertz", "analyn", "analyn_strip"])
@pytest.mark.parametrize("shift, yaw", POSES)
def test_forces_grow_with_the_approach(shift, yaw, model):
    """Of a wheelset that moves down, by 1 + damping times velocity times the normal's cosine; areas and
    pressures stay, and sums are those of the patches."""
    still, moving = pressed(shift, yaw, model), pressed(shift, yaw, model, vertical_velocity=0.2)
    for before, after in ((still.left, moving.left), (still.right, moving.right)):
        for one, other in zip(before.patches, after.patches):
            factor = 1 + DAMPING * 0.2 * np.cos(one.contact_angle)
            assert other.normal_force == pytest.approx(factor * one.normal_force, rel=1e-12)
            np.testing.assert_allclose(vector(other.force), factor * vector(one.force), rtol=1e-12)
            for name in ("x_track", "y_track", "z_track", "contact_angle", "area", "max_pressure"):
                assert getattr(other, name) == getattr(one, name)
        assert after.normal_force == pytest.approx(sum(patch.normal_force for patch in after.patches))
        np.testing.assert_allclose(
            vector(after.force), sum(vector(patch.force) for patch in after.patches), rtol=0, atol=1e-9
        )
        if len(after.patches) == 1:
            np.testing.assert_allclose(
                vector(after.moment), factor * vector(before.moment), rtol=1e-9, atol=1e-9 * FORCE
            )
        np.testing.assert_array_equal(after.outline.pressure, before.outline.pressure)
    np.testing.assert_allclose(
        vector(moving.left.moment) + vector(moving.right.moment),
        vector(moving.moment),
        rtol=0,
        atol=1e-12 * FORCE,
    )


#: Each motion alone, of the size that moves a place at the rail's top by about 0.1 m/s, and all together.
MOVES = [
    {"lateral_velocity": 0.1},
    {"vertical_velocity": 0.1},
    {"yaw_rate": 0.5},
    {"roll_rate": 0.15},
    {"left_rail_lateral_velocity": 0.1, "right_rail_lateral_velocity": -0.1},
    {"left_rail_vertical_velocity": -0.1, "right_rail_vertical_velocity": 0.1},
    {"left_rail_roll_velocity": 5.0, "right_rail_roll_velocity": 5.0},
]
MOVES.append({name: value for move in MOVES for name, value in move.items()})


def approach(patch, state, sign, moves):
    """Speed [m/s] at which the wheel and the rail at a patch's centre of load come together along its normal;
    both are moved by finite displacements, the rail about its highest point."""
    side = {1: "right", -1: "left"}[sign]
    place = np.array([patch.x_track, patch.y_track, patch.z_track])
    centre = np.array([0.0, state["lateral_shift"], state.vertical_shift - 0.46])
    wheel = motion.velocity(
        place,
        centre=centre,
        yaw=state["yaw"],
        roll=state.roll,
        lateral=moves.get("lateral_velocity", 0.0),
        vertical=moves.get("vertical_velocity", 0.0),
        yaw_rate=moves.get("yaw_rate", 0.0),
        roll_rate=moves.get("roll_rate", 0.0),
    )
    top = np.array([0.0, sign * system().profile_tables()[2], 0.0])
    turn = 1e-6 * moves.get(f"{side}_rail_roll_velocity", 0.0)
    rail = (about_x(turn) - about_x(-turn)) @ (place - top) / 2e-6
    rail[1] += moves.get(f"{side}_rail_lateral_velocity", 0.0)
    rail[2] += moves.get(f"{side}_rail_vertical_velocity", 0.0)
    return (wheel - rail) @ [0.0, sign * np.sin(patch.contact_angle), np.cos(patch.contact_angle)]


@pytest.mark.parametrize("moves", MOVES, ids=lambda moves: "+".join(moves)[:24])
@pytest.mark.parametrize("shift, yaw", [(2e-3, 0.02), (-6.2e-3, -0.015)])
def test_forces_grow_with_the_approach_of_wheel_and_rail(shift, yaw, moves):
    """By 1 + damping times the approach of both bodies, in all their motions; the wheel's centre of load is
    that of its patches."""
    still, moving = pressed(shift, yaw), pressed(shift, yaw, **moves)
    for sign, before, after in ((-1, still.left, moving.left), (1, still.right, moving.right)):
        factors = [1 + DAMPING * approach(patch, moving, sign, moves) for patch in before.patches]
        # differences over 1e-6 s
        np.testing.assert_allclose(
            [patch.normal_force for patch in after.patches],
            [factor * patch.normal_force for factor, patch in zip(factors, before.patches)],
            rtol=1e-8,
        )
        loads = np.array([patch.normal_force for patch in after.patches])
        assert after.patch_centroid == pytest.approx(
            loads @ [patch.centroid for patch in after.patches] / loads.sum(), rel=1e-12
        )
        moment = sum(
            np.cross(
                [patch.x_track, patch.y_track, patch.z_track]
                - np.array([0.0, shift, moving.vertical_shift - 0.46]),
                vector(patch.force),
            )
            for patch in after.patches
        )
        # a patch that turns has the moments of its regions, which its one place misses by some tenths of mm
        np.testing.assert_allclose(vector(after.moment), moment, rtol=0, atol=3e-4 * loads.sum())


@pytest.mark.parametrize("model", ["strips", "fastsim"])
def test_friction_carries_what_damping_adds(model):
    """Where all slides the creep force is friction times the damped load."""
    state = system(contact_mode="elastic").evaluate(3e-3)
    contact = system(contact_mode="compliant", contact_damping=DAMPING, tangential_model=model)
    moving = contact.evaluate(
        3e-3,
        vertical_shift_input=state.vertical_shift,
        roll_input=state.roll,
        vertical_velocity=0.5,
        speed=10.0,
        free_rolling=False,
    )
    for before, after in ((state.left, moving.left), (state.right, moving.right)):
        assert after.normal_force > 1.15 * before.normal_force
        # a locked wheel slides at every strip; FASTSIM's slip starts behind the leading edge
        assert np.hypot(after.force.x, after.force.y - after.normal.force.y) == pytest.approx(
            0.3 * after.normal_force, rel=2e-3
        )


def test_never_adhesive():
    """A wheelset that is torn up has no force, whatever its velocity."""
    for velocity in (-3.0, -5.0, -20.0):
        state = pressed(3e-3, 0.01, vertical_velocity=velocity)
        for wheel in (state.left, state.right):
            assert wheel.normal_force == 0.0 and wheel.force.z == 0.0 and wheel.moment.x == 0.0
        assert state.force.z == 0.0
    assert pressed(3e-3, 0.01, vertical_velocity=-2.4).right.normal_force > 0.0


def test_roll_and_rails_approach():
    """The right wheel comes down where the wheelset rolls to the right, and its rail comes up."""
    still = pressed(0.0, 0.0)
    rolling, lifted = pressed(0.0, 0.0, roll_rate=0.1), pressed(0.0, 0.0, right_rail_vertical_velocity=-0.1)
    for state, arm in ((rolling, 0.75), (lifted, 1.0)):
        gain = state.right.normal_force / still.right.normal_force - 1
        assert gain == pytest.approx(DAMPING * 0.1 * arm, rel=0.03)
    assert rolling.left.normal_force < still.left.normal_force
    assert lifted.left.normal_force == still.left.normal_force


def test_rolling_does_not_approach():
    """Neither speed nor yaw nor a curve changes a force."""
    still, moving = pressed(4e-3, 0.01), pressed(4e-3, 0.01, speed=50.0, track_curvature=5e-3)
    assert moving.right.normal_force == still.right.normal_force


@pytest.mark.parametrize("mode", ["rigid", "elastic"])
def test_other_modes_are_not_damped(mode):
    plain = system(contact_mode=mode).evaluate(1e-3, vertical_velocity=1.0)
    damped = system(contact_mode=mode, contact_damping=1.0).evaluate(1e-3, vertical_velocity=1.0)
    np.testing.assert_array_equal(plain.values, damped.values)


def test_the_halfspace_has_none():
    with pytest.raises(ValueError, match="contact_damping is 0.5; permitted with the normal_model 'half"):
        wrcontact.ContactSystem(contact_mode="compliant", normal_model="halfspace", contact_damping=0.5)


def test_without_damping_velocities_change_no_force():
    still, moving = (pressed(3e-3, 0.01, damping=0.0, vertical_velocity=velocity) for velocity in (0.0, 1.0))
    np.testing.assert_array_equal(still.values, moving.values)


def bounce(damping, cycles=3):
    """Energies [J] of a wheelset of 1500 kg on springless rails at the top of each bounce: it starts 50 um
    above the height at which it carries its weight, and moves up and down alone; Runge and Kutta's method."""
    mass, weight, step = 1500.0, 2 * 20e3, 2e-5
    one = wrcontact.ContactSystem(contact_mode="compliant", normal_model="hertz", contact_damping=damping)
    rest = (
        wrcontact.ContactSystem(contact_mode="elastic", normal_model="hertz")
        .evaluate(0.0, normal_force=weight / 2)
        .vertical_shift
    )

    def rates(state):
        force = one.evaluate(0.0, vertical_shift_input=state[0], vertical_velocity=state[1]).force.z
        return np.array([state[1], (weight + force) / mass])

    state, tops = np.array([rest - 2e-5, 0.0]), [rest - 2e-5]
    while len(tops) <= cycles:
        following = runge_kutta(rates, state, step)
        if state[1] < 0 <= following[1]:
            share = -state[1] / (following[1] - state[1])
            # the height of a parabola's top between two steps
            tops.append(state[0] + 0.5 * share * step * state[1])
        state = following
    return np.array(tops) - rest


def test_energy_of_a_bouncing_wheelset():
    """It comes back to its height without damping, and less and less high with it."""
    kept, lost = bounce(0.0), bounce(0.5)
    np.testing.assert_allclose(kept, kept[0], rtol=1e-4)
    assert (np.diff(np.abs(lost)) < -0.01 * abs(lost[0])).all()


# --- energy ---------------------------------------------------------------------------------------------


#: A wheelset that rolls and is moved by hand while its rails move too: velocity, amplitude and phase of each
#: motion.
CYCLE = {
    "vertical_shift_input": ("vertical_velocity", 3e-5, 0.0),
    "right_rail_vertical": ("right_rail_vertical_velocity", 1e-5, 2.0),
    "left_rail_vertical": ("left_rail_vertical_velocity", 1e-5, 0.3),
}
WITH_ROLL = CYCLE | {"roll_input": ("roll_rate", 2e-5, 1.0)}
ROLLING = {"speed": 20.0, "wheel_rate": 43.4, "lateral_velocity": 0.0, "yaw_rate": 0.0}


def run_through(cycle, rate, count, **parameters):
    """Inputs by name and the state, ``count`` times in a period at ``rate`` [rad/s], of a wheelset at 3 mm of
    lateral shift and 5 mrad of yaw about the height at which it carries 78.5 kN a wheel."""
    pose = {"lateral_shift": 3e-3, "yaw": 5e-3}
    model = parameters.get("normal_model", "analyn")
    stand = system(contact_mode="elastic", normal_model=model).evaluate(**pose)
    start = {**pose, **ROLLING, "vertical_shift_input": stand.vertical_shift, "roll_input": stand.roll}
    contact = system(contact_mode="compliant", tangential_model="strips", **parameters)
    for phase in 2 * np.pi * np.arange(count) / count:
        given = dict(start)
        for name, (velocity, size, ahead) in cycle.items():
            given[name] = given.get(name, 0.0) + size * np.sin(phase + ahead)
            given[velocity] = given.get(velocity, 0.0) + size * rate * np.cos(phase + ahead)
        yield given, contact, contact.evaluate(**given)


def contact_power(given, contact, state):
    """Power of the contact's forces on the wheelset and on both rails [W], at their velocities."""
    yaw = given["yaw"]
    turn = np.array(
        [
            given.get("roll_rate", 0.0) * np.cos(yaw),
            given.get("roll_rate", 0.0) * np.sin(yaw),
            given["yaw_rate"],
        ]
    )
    velocity = [given["speed"], given["lateral_velocity"], given.get("vertical_velocity", 0.0)]
    power = (
        vector(state.force) @ velocity
        + vector(state.moment) @ turn
        + state.driving_torque * given["wheel_rate"]
    )
    for side in ("left", "right"):
        force, _ = contact.rail_reaction(state, side)
        power += force[2] * given.get(f"{side}_rail_vertical_velocity", 0.0)
    return power


@pytest.mark.parametrize("cycle, missed", [(CYCLE, 2e-6), (WITH_ROLL, 5e-4)], ids=["depth", "depth and roll"])
@pytest.mark.parametrize("normal", ["hertz", "analyn", "analyn_strip"])
def test_energy_of_a_wheelset_moved_by_hand(normal, cycle, missed):
    """Over a period, in which elastic energy comes and goes, the contact takes from the bodies what friction
    and damping have.

    Where only depths change the elastic energy is theirs alone, and closes as well as 48 points sum it: 8e-7
    of the elastic power with ANALYN's nodes, 1e-8 and less with the others.  Where the wheelset rolls, too,
    patches move along the profiles, and elastic force and moment are not exactly those of one energy:
    2.4e-4."""
    powers = []
    for given, contact, state in run_through(cycle, 400.0, 48, normal_model=normal, contact_damping=DAMPING):
        powers.append(
            (
                contact_power(given, contact, state),
                state.left.friction_power + state.right.friction_power,
                state.left.damping_power + state.right.damping_power,
            )
        )
    taken, friction, damping = np.transpose(powers)
    assert (damping >= 0.0).all() and damping.mean() > 3.0 and friction.mean() > 100.0
    stored = taken + friction + damping
    assert abs(stored.mean()) < missed * np.abs(stored).mean()


@pytest.mark.parametrize("normal", ["hertz", "analyn", "analyn_strip"])
@pytest.mark.parametrize("moves", MOVES, ids=lambda moves: "+".join(moves)[:24])
def test_damping_power_is_what_damped_forces_take_more(moves, normal):
    """At each instant; rails move too."""
    still = pressed(-6.2e-3, -0.015, normal, 0.0, **moves)
    for damping in (DAMPING, 30.0):
        moving = pressed(-6.2e-3, -0.015, normal, damping, **moves)
        assert still.left.damping_power == still.right.damping_power == 0.0
        contact = system(contact_mode="compliant", normal_model=normal)
        given = {
            "speed": 0.0,
            "lateral_velocity": 0.0,
            "yaw_rate": 0.0,
            "wheel_rate": 0.0,
            "yaw": -0.015,
            **moves,
        }
        taken = []
        for state in (still, moving):
            power = contact_power(given, contact, state)
            for side in ("left", "right"):
                force, moment = contact.rail_reaction(state, side)
                power += force[1] * given.get(f"{side}_rail_lateral_velocity", 0.0) + moment[0] * given.get(
                    f"{side}_rail_roll_velocity", 0.0
                )
            taken.append(-power)
        found = moving.left.damping_power + moving.right.damping_power
        wanted = taken[1] - taken[0]
        assert found == pytest.approx(wanted, rel=1e-10, abs=1e-9 * abs(taken[0])), (moves, damping)
        assert found > 0.0
