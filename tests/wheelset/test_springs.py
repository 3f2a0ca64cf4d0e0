"""Rails on springs and dampers in compliant contact: closed forms, rails that are moved by hand, sweeps over
two contacts, and the refusals.

Independent are the springs' law, k u + c du/dt = force, and evaluations over rigid rails that are displaced
by the inputs; scipy finds by these what the kernel finds by itself.
"""

import numpy as np
import pytest
from scipy.optimize import brentq, root

import wrcontact
from wrcontact import Status

#: Stiffnesses of a rail [N/m], and of its pads' dampers [N s/m].
LATERAL, VERTICAL = 2e7, 5e7
LATERAL_DAMPING, VERTICAL_DAMPING = 5e4, 1e5
SPRINGS = {"rail_lateral_stiffness": LATERAL, "rail_vertical_stiffness": VERTICAL}
DAMPERS = {"rail_lateral_damping": LATERAL_DAMPING, "rail_vertical_damping": VERTICAL_DAMPING}
#: A rail settles to a last move of 2e-14 m, over a contact of 2e9 N/m; share of a load of some kN.
BALANCED = 1e-8
#: Smallest gaps are found from another start, and to 1e-13 m.
SAME = 1e-9
MODELS = ("hertz", "analyn", "analyn_strip")


def one_wheel(model="analyn", **parameters):
    return wrcontact.WheelContact(side="right", normal_model=model, **parameters)


def deflection(side):
    return np.array([side.rail_deflection_lateral, side.rail_deflection_vertical])


def missed(side, lateral=LATERAL, vertical=VERTICAL):
    """How far springs and forces are apart, over the force of the wheel."""
    residual = [
        lateral * side.rail_deflection_lateral + side.force.y,
        vertical * side.rail_deflection_vertical + side.force.z,
    ]
    return np.max(np.abs(residual)) / np.hypot(side.force.y, side.force.z)


def poses(count, seed):
    """Inputs of a wheel that carries 4 ... 200 kN, on tread, root and flange, with yaw and friction."""
    rng = np.random.default_rng(seed)
    for _ in range(count):
        load = 10 ** rng.uniform(3.6, 5.3)
        yield {
            "lateral_shift": rng.uniform(-7e-3, 7e-3),
            "yaw": rng.normal(0, 5e-3),
            "roll_input": 0.0,
            "vertical_shift_input": load / VERTICAL + 1e-4 * (load / 8e4) ** (2 / 3),
            "speed": 20.0,
            "lateral_velocity": rng.normal(0, 0.02),
            "friction": 0.3,
            "wheel_rate": 43.5,
        }


# --- statics ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("friction", ["none", "strips"])
def test_springs_carry_what_the_wheel_presses_as_over_rails_moved_by_hand(model, friction):
    """Rigid rails at the deflections that were found have the same forces; only Hertz's one contact jumps."""
    soft, rigid = (one_wheel(model, tangential_model=friction, **springs) for springs in (SPRINGS, {}))
    settled = 0
    for pose in poses(25, 4):
        side = soft.evaluate(**pose)
        if side.status != Status.VALID:
            continue
        lateral, vertical = deflection(side)
        moved = rigid.evaluate(**pose, rail_lateral=lateral, rail_vertical=vertical)
        assert [*moved.force, *moved.moment] == pytest.approx(
            [*side.force, *side.moment], rel=SAME, abs=SAME * side.normal_force
        ), pose
        settled += missed(side) < BALANCED
        assert model == "hertz" or missed(side) < 0.03, pose
    assert settled >= (15 if model == "hertz" else 20)


#: Wheels of 50 mN ... 500 N: model, friction, stiffnesses across and down; shift, yaw, height, roll of the rail.
LIGHT = [
    (
        "analyn_strip",
        "strips",
        0.0,
        587553746.8375279,
        0.0008566961662380187,
        0.0072676379741689065,
        0.0001387101527550058,
        0.0,
    ),
    (
        "analyn",
        "polach",
        128753143.46989626,
        54677287.67643608,
        0.0015283776271139918,
        -0.010928034253213625,
        8.938738678275581e-05,
        0.0,
    ),
    (
        "analyn_strip",
        "strips",
        0.0,
        42971340.92565048,
        0.001395282744060566,
        0.0010592219937904613,
        9.481079096307308e-05,
        0.0,
    ),
    (
        "hertz",
        "none",
        32834836.45168784,
        23537811.280861203,
        0.00014995101187049997,
        -0.0011748659943896288,
        0.00019597675012374296,
        -0.0007585505116544643,
    ),
]


@pytest.mark.parametrize("case", LIGHT)
def test_springs_carry_a_light_wheel_as_exactly_as_a_heavy_one(case):
    """Broyden's last move of 1e-13 m leaves more than 1e-8 of such a load; then the rail settles further."""
    model, friction, lateral, vertical, shift, yaw, height, roll = case
    stiffness = {"rail_lateral_stiffness": lateral, "rail_vertical_stiffness": vertical}
    wheel = one_wheel(model, tangential_model=friction, **stiffness)
    side = wheel.evaluate(
        lateral_shift=shift,
        yaw=yaw,
        vertical_shift_input=height,
        rail_roll=roll,
        speed=20.0,
        lateral_velocity=0.01,
    )
    assert side.status == Status.VALID
    residual = np.array([lateral, vertical]) * deflection(side) + [
        side.force.y * (lateral > 0.0),
        side.force.z,
    ]
    assert np.abs(residual).sum() < 1e-8 * (abs(side.force.y) + abs(side.force.z))


#: Free wheels whose rails stand at a jump of the forces at the first rate, and in balance at the one that follows:
#: model, stiffnesses across and down; shift, yaw, height.
LEFT_JUMPS = [
    (
        "hertz",
        2001195.6578689073,
        3482002.6112442077,
        0.006361062324063431,
        0.002463318325762344,
        0.013821219526204917,
    ),
    (
        "analyn",
        85207067.91379963,
        609700275.2186563,
        0.005875148383643695,
        0.0037166873745473747,
        4.4947334659779233e-05,
    ),
    (
        "analyn_strip",
        658540097.7090515,
        0.0,
        0.006875741531914174,
        0.003261736191181931,
        5.8066752659297507e-05,
    ),
]


@pytest.mark.parametrize("case", LEFT_JUMPS)
def test_a_rail_leaves_a_jump_that_another_rate_does_not_have(case):
    model, lateral, vertical, shift, yaw, height = case
    wheel = one_wheel(
        model, tangential_model="polach", rail_lateral_stiffness=lateral, rail_vertical_stiffness=vertical
    )
    side = wheel.evaluate(
        lateral_shift=shift, yaw=yaw, vertical_shift_input=height, speed=20.0, lateral_velocity=0.01
    )
    held = np.array([lateral, vertical]) * deflection(side) + [side.force.y, side.force.z * (vertical > 0.0)]
    assert side.status == Status.VALID and np.abs(held).max() < 1e-9 * abs(side.force.z)


@pytest.mark.full
@pytest.mark.parametrize("model", MODELS)
@pytest.mark.turns(3)
def test_random_wheels_settle(model):
    """On springs of 1 MN/m to 1 GN/m, one direction or both: 20 wheels of 400 poses each.  Measured: no wheel
    without an answer; ANALYN and strips miss the springs' force in 3 of 1000 poses, by 10 % at most, Hertz in
    3 of 100 by up to two thirds."""
    rng, missing, count = np.random.default_rng(40), [], 0
    for k in range(20):
        lateral, vertical = 10 ** rng.uniform(6, 9, 2) * ((1, 1), (1, 1), (0, 1), (1, 0))[k % 4]
        wheel = one_wheel(
            model,
            tangential_model=("none", "polach")[k % 2],
            rail_lateral_stiffness=lateral,
            rail_vertical_stiffness=vertical,
        )
        load = 10 ** rng.uniform(3.5, 5.3, 400)
        table = wheel.evaluate_many(
            lateral_shift=rng.uniform(-8e-3, 8e-3, 400),
            yaw=rng.normal(0, 5e-3, 400),
            speed=20.0,
            vertical_shift_input=1e-4 * (load / 8e4) ** (2 / 3) + (load / vertical if vertical else 0.0),
            lateral_velocity=0.01,
            rail_roll=rng.normal(0, 5e-3) * (k % 3 == 0),
        )
        assert set(table.status) <= {Status.VALID, Status.UNLOADED, Status.OFF_PROFILE}
        sound = table[table.status == Status.VALID]
        left = [
            stiffness and stiffness * deflected + force
            for stiffness, deflected, force in (
                (lateral, sound.rail_deflection_lateral, sound.force.y),
                (vertical, sound.rail_deflection_vertical, sound.force.z),
            )
        ]
        share = np.maximum(*map(np.abs, left)) / np.hypot(sound.force.y, sound.force.z)
        missing.extend(share[share > 1e-7])
        count += len(share)
    assert count > 4000
    assert len(missing) < (0.06 if model == "hertz" else 0.006) * count
    assert max(missing, default=0.0) < (0.8 if model == "hertz" else 0.15)


def test_scipy_finds_the_same_deflections_over_rigid_rails():
    """From a start 0.1 mm beside, by scipy's root of the springs' law over rails that the inputs displace."""
    soft, rigid = one_wheel(**SPRINGS), one_wheel()
    for pose in ({"lateral_shift": 1e-3}, {"lateral_shift": 5.6e-3}, {"lateral_shift": 7e-3, "yaw": 5e-3}):
        pose |= {"vertical_shift_input": 1.7e-3}
        side = soft.evaluate(**pose)

        def residual(moved):
            at = rigid.evaluate(**pose, rail_lateral=1e-3 * moved[0], rail_vertical=1e-3 * moved[1])
            return [
                1e-8 * LATERAL * moved[0] + 1e-5 * at.force.y,
                1e-8 * VERTICAL * moved[1] + 1e-5 * at.force.z,
            ]

        found = root(residual, 1e3 * deflection(side) + [0.02, 0.02], tol=1e-13).x
        assert found == pytest.approx(1e3 * deflection(side), rel=1e-8), pose


def test_hertz_in_series_with_a_spring():
    """The spring takes load / k of the height, the contact the rest; their compliances add up."""
    rigid, soft = one_wheel("hertz"), one_wheel("hertz", rail_vertical_stiffness=VERTICAL)
    height = 1.2e-3
    at = soft.evaluate(vertical_shift_input=height)

    def over(deflected):
        return VERTICAL * deflected + rigid.evaluate(vertical_shift_input=height - deflected).force.z

    deflected = brentq(over, 0.5e-3, height, xtol=1e-18, rtol=1e-14)
    assert at.rail_deflection_vertical == pytest.approx(deflected, rel=1e-9)
    assert at.rail_deflection_lateral == 0.0
    # compliances add up: one over the stiffness that differences show is 1/k + 1/contact
    step = 1e-8
    series, contact = (
        -(
            one.evaluate(vertical_shift_input=middle + step).force.z
            - one.evaluate(vertical_shift_input=middle - step).force.z
        )
        / (2 * step)
        for one, middle in ((soft, height), (rigid, height - deflected))
    )
    assert 1 / series == pytest.approx(1 / VERTICAL + 1 / contact, rel=1e-6)


@pytest.mark.parametrize("stiffness", [1e6, 1e8, 1e12])
def test_stiffer_springs_come_down_to_rigid_rails(stiffness):
    soft = one_wheel(rail_lateral_stiffness=stiffness, rail_vertical_stiffness=stiffness)
    height = 1e-4 + 5e4 / stiffness
    side = soft.evaluate(lateral_shift=2e-3, vertical_shift_input=height)
    assert missed(side, stiffness, stiffness) < BALANCED
    if stiffness == 1e12:
        rigid = one_wheel().evaluate(lateral_shift=2e-3, vertical_shift_input=height)
        assert side.force.z == pytest.approx(rigid.force.z, rel=3e-3)  # 1e9 over 1e12 N/m


@pytest.mark.parametrize("direction", [0, 1])
def test_a_spring_in_one_direction_leaves_the_other_rigid(direction):
    name = ("rail_lateral_stiffness", "rail_vertical_stiffness")[direction]
    side = one_wheel(**{name: 3e7}).evaluate(lateral_shift=6.3e-3, vertical_shift_input=4e-4)
    assert deflection(side)[1 - direction] == 0.0
    assert 3e7 * deflection(side)[direction] == pytest.approx(-side.force[1 + direction], rel=BALANCED)


def test_a_lifted_wheel_leaves_its_rail_at_rest():
    side = one_wheel(**SPRINGS).evaluate(vertical_shift_input=-1e-3)
    assert side.status == Status.UNLOADED and deflection(side).tolist() == [0.0, 0.0]


def test_both_sides_of_a_wheelset_are_single_wheels_and_its_mirror_image():
    given = {"contact_mode": "compliant", **SPRINGS, "left_rail_vertical_stiffness": 9e7}
    pose = {"lateral_shift": 4e-3, "yaw": 3e-3, "vertical_shift_input": 1.4e-3, "roll_input": -1e-4}
    both = wrcontact.ContactSystem(**given).evaluate(**pose)
    alone = {
        "right": one_wheel(**SPRINGS),
        "left": wrcontact.WheelContact(side="left", **(SPRINGS | {"rail_vertical_stiffness": 9e7})),
    }
    for side, wheel in alone.items():
        found = wheel.evaluate(**pose)
        assert list(getattr(both, side).force) == pytest.approx(list(found.force), rel=SAME)
        assert deflection(getattr(both, side)) == pytest.approx(deflection(found), rel=SAME)
    swapped = SPRINGS | {"rail_vertical_stiffness": 9e7, "left_rail_vertical_stiffness": VERTICAL}
    mirror = {name: value if name == "vertical_shift_input" else -value for name, value in pose.items()}
    image = wrcontact.ContactSystem(contact_mode="compliant", **swapped).evaluate(**mirror)
    assert deflection(image.left) == pytest.approx(deflection(both.right) * [-1, 1], rel=SAME)
    assert deflection(image.right) == pytest.approx(deflection(both.left) * [-1, 1], rel=SAME)


def test_deflections_before_the_step_are_mirrored_too():
    """The left rail has come from its own side."""
    system = wrcontact.ContactSystem(contact_mode="compliant", **SPRINGS, **DAMPERS)

    def at(sign, left, right):
        return system.evaluate(
            lateral_shift=sign * 4e-3,
            yaw=sign * 3e-3,
            roll_input=sign * -1e-4,
            vertical_shift_input=1.4e-3,
            rail_time_step=1e-3,
            left_rail_deflection_lateral_before=left[0],
            left_rail_deflection_vertical_before=left[1],
            right_rail_deflection_lateral_before=right[0],
            right_rail_deflection_vertical_before=right[1],
        )

    one = at(1, (2e-4, 9e-4), (-1e-4, 11e-4))
    image = at(-1, (1e-4, 11e-4), (-2e-4, 9e-4))
    assert deflection(image.left) == pytest.approx(deflection(one.right) * [-1, 1], rel=SAME)
    assert deflection(image.right) == pytest.approx(deflection(one.left) * [-1, 1], rel=SAME)


def test_a_displaced_foot_moves_the_rail_and_a_rolled_one_too():
    """The displacement of the foot is that of the wheelset the other way; a roll changes the contact, and
    springs act along the track."""
    soft = one_wheel(**SPRINGS)
    pose = {"lateral_shift": 3e-3, "vertical_shift_input": 1.5e-3}
    foot = soft.evaluate(
        lateral_shift=3.2e-3, vertical_shift_input=1.9e-3, rail_lateral=0.2e-3, rail_vertical=0.4e-3
    )
    assert deflection(foot) == pytest.approx(deflection(soft.evaluate(**pose)), rel=1e-8)
    rolled = soft.evaluate(**pose, rail_roll=0.01)
    assert missed(rolled) < BALANCED and rolled.force.z != soft.evaluate(**pose).force.z


@pytest.mark.parametrize("side", ["left", "right"])
def test_the_reaction_is_about_the_rail_where_it_stands(side):
    """That on a rigid rail which was moved by hand to the same place."""
    soft, rigid = (wrcontact.ContactSystem(contact_mode="compliant", **springs) for springs in (SPRINGS, {}))
    pose = {"lateral_shift": 4e-3, "yaw": 3e-3, "vertical_shift_input": 1.4e-3, "roll_input": -1e-4}
    state = soft.evaluate(**pose)
    moved = rigid.evaluate(
        **pose,
        **{
            f"{side}_rail_{part}": state[f"{side}.rail_deflection_{part}"] for part in ("lateral", "vertical")
        },
        side=side,
    )
    for found, wanted in zip(soft.rail_reaction(state, side), rigid.rail_reaction(moved, side), strict=True):
        assert found == pytest.approx(wanted, rel=SAME, abs=1e-6 * state[f"{side}.normal_force"])


def test_only_what_is_wanted_changes_nothing():
    system = wrcontact.ContactSystem(contact_mode="compliant", **SPRINGS)
    pose = {"lateral_shift": 5e-3, "vertical_shift_input": 1.5e-3}
    whole = system.evaluate(**pose).right
    for outputs in ("patches", "geometry"):
        for side in ("both", "right"):
            part = system.evaluate(**pose, outputs=outputs, side=side).right
            assert part.contact.y_track == whole.contact.y_track
    assert np.isnan(part.rail_deflection_lateral)


# --- two contacts -------------------------------------------------------------------------------------


@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
def test_a_wheel_runs_onto_its_flange_without_a_jump(model):
    """From tread over two contacts to the flange in steps of 0.02 mm, at a height that is given: the lateral
    force changes by no more than the lateral spring and the steeper flange give, the vertical one by 2 % of
    the load where a region goes.  On rigid rails a step is worth 20 ... 30 kN in each."""
    shifts = np.arange(4.5e-3, 8e-3, 2e-5)
    table = one_wheel(model, **SPRINGS).evaluate_many(lateral_shift=shifts, vertical_shift_input=1.7e-3)
    assert (table.status == Status.VALID).all()
    assert table.patch_count.min() == 1 and table.patch_count.max() >= 2
    assert np.max(np.abs(np.diff(table.force.y))) < 1.5 * LATERAL * 2e-5
    assert np.max(np.abs(np.diff(table.force.z))) < 0.02 * np.max(-table.force.z)
    worst = np.argmax(np.abs(LATERAL * table.rail_deflection_lateral + table.force.y))
    assert (
        missed(one_wheel(model, **SPRINGS).evaluate(lateral_shift=shifts[worst], vertical_shift_input=1.7e-3))
        < 0.02
    )


# --- dampers ------------------------------------------------------------------------------------------


def test_dampers_carry_nothing_without_a_time_step():
    pose = {"lateral_shift": 2e-3, "vertical_shift_input": 1.5e-3, "rail_deflection_lateral_before": 1e-3}
    assert (
        deflection(one_wheel(**SPRINGS, **DAMPERS).evaluate(**pose))
        == deflection(one_wheel(**SPRINGS).evaluate(**pose))
    ).all()


def test_a_released_rail_comes_back_as_an_exponential():
    """Without a wheel k u + c du/dt = 0: each step divides by 1 + k h / c; many give exp(-k t / c)."""
    free = one_wheel(**SPRINGS, **DAMPERS)
    before = np.array([1e-3, -2e-3])
    step, time = 1e-6, 2e-3
    rates = np.array([LATERAL / LATERAL_DAMPING, VERTICAL / VERTICAL_DAMPING])
    side = free.evaluate(
        vertical_shift_input=-5e-3,
        rail_time_step=step,
        rail_deflection_lateral_before=before[0],
        rail_deflection_vertical_before=before[1],
    )
    assert deflection(side) == pytest.approx(before / (1 + rates * step), rel=1e-12)
    assert (deflection(side) / before) ** (time / step) == pytest.approx(np.exp(-rates * time), rel=1e-3)


def test_a_pressed_rail_creeps_down_as_its_differential_equation_says():
    """c du/dt = Q(height - u) - k u by scipy over rigid rails, against implicit steps that are halved: their
    error falls in proportion to the step."""
    from scipy.integrate import solve_ivp

    damper = {"rail_vertical_stiffness": VERTICAL, "rail_vertical_damping": 1e6}
    soft, rigid = one_wheel("hertz", **damper), one_wheel("hertz")
    height, time = 2e-4, 2e-3

    def rate(_, u):
        return [(-rigid.evaluate(vertical_shift_input=height - u[0]).force.z - VERTICAL * u[0]) / 1e6]

    exact = solve_ivp(rate, (0, time), [0.0], rtol=1e-10, atol=1e-16).y[0, -1]
    errors = []
    for count in (20, 40):
        found = 0.0
        for _ in range(count):
            found = soft.evaluate(
                vertical_shift_input=height,
                rail_time_step=time / count,
                rail_deflection_vertical_before=found,
            ).rail_deflection_vertical
        errors.append(found - exact)
    assert abs(errors[0]) < 0.05 * exact
    assert errors[0] / errors[1] == pytest.approx(2.0, abs=0.2)


def test_the_rail_moves_with_its_deflection():
    """Creepages and contact damping are those over a rigid rail with the rates of the deflection, which rolls
    about its own highest point."""
    model = {"tangential_model": "polach", "contact_damping": 0.5}
    soft, rigid = one_wheel(**SPRINGS, **DAMPERS, **model), one_wheel(**model)
    pose = {
        "lateral_shift": 2e-3,
        "vertical_shift_input": 1.4e-3,
        "speed": 20.0,
        "wheel_rate": 20.0 / 0.46,
        "lateral_velocity": 0.02,
        "rail_roll_velocity": 0.2,
    }
    before, step = np.array([1.1e-4, 1.18e-3]), 2e-3
    side = soft.evaluate(
        **pose,
        rail_time_step=step,
        rail_deflection_lateral_before=before[0],
        rail_deflection_vertical_before=before[1],
    )
    now = deflection(side)
    rates = (now - before) / step
    moved = rigid.evaluate(
        **pose,
        rail_lateral=now[0],
        rail_vertical=now[1],
        rail_lateral_velocity=rates[0],
        rail_vertical_velocity=rates[1],
    )
    assert np.abs(rates).min() > 1e-4
    assert list(moved.force) == pytest.approx(list(side.force), rel=1e-12)
    assert moved.patches[0].creepage.y == pytest.approx(side.patches[0].creepage.y, rel=1e-12)
    carried = np.array([LATERAL, VERTICAL]) * now + np.array([LATERAL_DAMPING, VERTICAL_DAMPING]) * rates
    assert carried == pytest.approx([-side.force.y, -side.force.z], rel=BALANCED)


# --- derivatives --------------------------------------------------------------------------------------


OF = (
    "right.force.y",
    "right.force.z",
    "right.rail_deflection_lateral",
    "right.rail_deflection_vertical",
    "left.rail_deflection_lateral",
    "left.force.z",
    "moment.x",
    "right.contact.y_wheel",
)
#: Rails settle to 1e-15 m, which shows in differences of small deflections over less than 4e-7 m of a rail's displacement
#: (2.8e-5 over 1e-7 m, 1.3e-6 over 4e-7 m); from 6e-7 m on they meet the kink below.
STEPS = {
    "lateral_shift": 2e-7,
    "vertical_shift_input": 2e-8,
    "yaw": 1e-6,
    "roll_input": 1e-7,
    "speed": 1e-3,
    "lateral_velocity": 1e-4,
    "right.rail_lateral": 4e-7,
    "left.rail_vertical": 4e-7,
    "right.rail_deflection_vertical_before": 1e-7,
    "rail_time_step": 1e-6,
    "left.friction": 1e-4,
}
CASES = {
    "hertz": {"normal_model": "hertz"},
    "strips": {"tangential_model": "strips", "contact_damping": 0.5},
    "one direction": {
        "normal_model": "analyn_strip",
        "tangential_model": "polach",
        "rail_vertical_stiffness": 0.0,
        "rail_vertical_damping": 0.0,
    },
}


@pytest.mark.parametrize("case", CASES)
def test_derivatives_are_those_of_differences(case):
    given = {
        "contact_mode": "compliant",
        **SPRINGS,
        **DAMPERS,
        "left_rail_lateral_stiffness": 1e8,
        **CASES[case],
    }
    system = wrcontact.ContactSystem(**given)
    sunk = 1.3e-3 if given["rail_vertical_stiffness"] else 0.0
    inputs = {
        "lateral_shift": 3e-3,
        "yaw": 4e-3,
        "roll_input": -2e-4,
        "vertical_shift_input": 1.5e-4 + sunk,
        "speed": 20.0,
        "lateral_velocity": 0.01,
        "vertical_velocity": 3e-3,
        "rail_time_step": 1e-3,
        "right_rail_deflection_lateral_before": 3e-4,
        "right_rail_deflection_vertical_before": 0.8 * sunk,
        "left_rail_deflection_vertical_before": 0.8 * sunk,
        "left_rail_roll": 1e-3,
        "left_friction": 0.3,
        "right_rail_lateral": 0.0,
        "left_rail_vertical": 0.0,
    }
    found = system.derivatives(of=OF, by=list(STEPS), **inputs)

    def at(name, change):
        state = system.evaluate(**(inputs | {name: inputs[name] + change}))
        return np.array([state[one] for one in OF])

    for column, (name, step) in enumerate(STEPS.items()):
        keyword = name.replace(".", "_")
        coarse, fine = ((at(keyword, h) - at(keyword, -h)) / (2 * h) for h in (step, step / 2))
        # the largest seen: 1.9e-5 of a small one, beside the yaw's kink of rounded gaps
        scale = np.maximum(np.abs(found[:, column]), 1e-3 * np.abs(found).max(axis=1))
        assert np.all(np.abs(found[:, column] - (4 * fine - coarse) / 3) <= 2e-5 * scale), name


# --- what is refused ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "given, words",
    [
        (
            {"rail_lateral_stiffness": 1e7},
            "rail_lateral_stiffness is 10000000.0 N/m; permitted with the "
            "contact_mode 'rigid' is 0: rails stand on springs with the contact_mode 'compliant'",
        ),
        ({"contact_mode": "elastic", "left_rail_vertical_stiffness": 1e7}, "left_rail_vertical_stiffness is"),
        (
            {"contact_mode": "compliant", "normal_model": "halfspace", "rail_vertical_stiffness": 1e7},
            "rail_vertical_stiffness is 10000000.0 N/m; permitted with the normal_model 'halfspace' is 0",
        ),
        (
            {"contact_mode": "compliant", "rail_lateral_damping": 1e3},
            "rail_lateral_damping is 1000.0 N.s/m without rail_lateral_stiffness; permitted is 0, or a stiffness",
        ),
        (
            {
                "contact_mode": "compliant",
                "rail_lateral_stiffness": (0.0, 1e7),
                "left_rail_lateral_damping": 5.0,
            },
            "left_rail_lateral_damping is 5.0 N.s/m without left_rail_lateral_stiffness",
        ),
        (
            {"contact_mode": "compliant", "rail_lateral_stiffness": -1.0},
            "rail_lateral_stiffness is -1.0; permitted is 0 ... 1e+12 N/m",
        ),
    ],
)
def test_what_is_refused(given, words):
    with pytest.raises(ValueError) as refusal:
        wrcontact.ContactSystem(**given)
    assert str(refusal.value).startswith(words)


def test_a_rigid_left_rail_beside_a_soft_right_one():
    """In Python 0 is rigid; in an FMU it is "as on the right", and the stiffest spring stands for rigid."""
    soft = {"contact_mode": "compliant", "rail_vertical_stiffness": VERTICAL}
    pose = {"vertical_shift_input": 4e-4}
    rigid = wrcontact.ContactSystem(**soft, left_rail_vertical_stiffness=0.0).evaluate(**pose).left
    stiff = wrcontact.ContactSystem(**soft, left_rail_vertical_stiffness=1e12).evaluate(**pose).left
    both = wrcontact.ContactSystem(**soft).evaluate(**pose).left
    assert rigid.rail_deflection_vertical == 0.0 < stiff.rail_deflection_vertical < 1e-6
    assert both.rail_deflection_vertical > 1e-4


def test_a_bad_time_step_is_an_invalid_input():
    state = wrcontact.ContactSystem(contact_mode="compliant", **SPRINGS).evaluate(rail_time_step=-1e-3)
    assert state.status == Status.INVALID_INPUT
    assert "rail_time_step is -0.001 s; permitted is 0 <= rail_time_step <= 1e+06 s" in wrcontact.explain(
        state.status, state.inputs, compliant=True
    )
