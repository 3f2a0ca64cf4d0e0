"""Elastic contact over random poses: cost, statuses, poses that once failed, and bad input."""

import math

import numpy as np
import pytest

import wrcontact
from tests.helpers.cases import LOADS, MODELS, PAIRS, system
from tests.helpers.elastic import carried, compliant, elastic
from tests.helpers.inside import counts_of
from wrcontact.status import explain

# --- random poses ------------------------------------------------------------------------------------


def random_poses(count, seed, shift=9e-3, yaw=0.06, forces=(1.0, 4e5), transfer=0.9):
    rng = np.random.default_rng(seed)
    yaws = rng.uniform(-yaw, yaw, count)
    yaws[::3] = 0.0
    return (
        rng.uniform(-shift, shift, count),
        yaws,
        np.exp(rng.uniform(*np.log(forces), count)),
        rng.uniform(-transfer, transfer, count),
    )


@pytest.mark.parametrize(
    "model, mean, most", [("analyn", 12, 100), ("analyn_strip", 14, 100), ("hertz", 12, 100)]
)
def test_a_step_takes_few_trials(model, mean, most):
    """Measured with those of the rigid search, which ends with one more Newton step from a rounded roll so that
    its last bits are those of the inputs alone: 10.9 on average (12.2 with strips, whose first ones are coarse),
    22 at the 99th percentile, 53 at most, with brackets."""
    stepper, counts = elastic(normal_model=model).stepper(), []
    for pose in zip(*random_poses(600, 44, 8e-3, 0.03, (1e3, 1.5e5), 0.5)):
        stepper.inputs[[0, 1, 3, 4]] = pose
        before = counts_of(stepper)["roll"]
        assert stepper.step() == 0
        counts.append(counts_of(stepper)["roll"] - before)
    assert np.mean(counts) < mean and np.percentile(counts, 99) < 60 and max(counts) < most


def check_random_poses(count, seed, rail, inclination, model, load):
    """Statuses 0 and 1; or 2 where a wheel would stand about 2 mm deep: under vertical loads
    of some 300 kN on a flange."""
    parameters = dict(rail=rail, rail_inclination=inclination, normal_model=model, load=load)
    poses = np.array(random_poses(count, seed))
    table = elastic(**parameters).evaluate_many(*poses)
    refused = np.flatnonzero(table.status > 1)
    for k in refused:
        where = f"{parameters} {[float(value) for value in poses[:, k]]}: status {table.status[k]}"
        rigid = system(**parameters).evaluate(*poses[:, k])
        sink = max(side.penetration / math.cos(side.contact_angle) for side in (rigid.left, rigid.right))
        assert table.status[k] == 2 and load == "vertical" and sink > 1e-3, (
            f"{where}, {1e3 * sink:.2f} mm deep"
        )
    for sign, side in ((-1, table.left), (1, table.right)):
        good = table.status == 0
        if load == "normal":
            wanted = poses[2] * (1 + sign * poses[3])
            np.testing.assert_allclose(side.normal_force[good], wanted[good], rtol=1e-6)
    return len(refused)


@pytest.mark.parametrize(
    "count, seed, most", [(60, 50, 1), pytest.param(4000, 70, 12, marks=pytest.mark.full)]
)
@pytest.mark.parametrize("load", LOADS)
@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("pair", range(len(PAIRS)))
@pytest.mark.turns(3)
def test_random_poses_stand(pair, model, load, count, seed, most):
    """Measured: no status 3 in 216 000 poses; status 2 in one of 1100 with vertical loads."""
    assert check_random_poses(count, seed + pair, *PAIRS[pair], model, load) <= most


#: Once refused (status 3): the first sample of the overlap lay beyond the rail, and the guess beside it was
#: the other side's; Newton's method for a deepest point swung to and fro.
ONCE_REFUSED = [
    (
        "54E1",
        1 / 20,
        "normal",
        (-0.0058487261477867675, 0.04631273279453417, 203082.27503455844, -0.5752669176125726),
    ),
    (
        "54E1",
        1 / 20,
        "normal",
        (0.005753283566805999, 0.04565362260413991, 42.233597926451544, 0.06340601422594294),
    ),
    (
        "54E1",
        1 / 20,
        "normal",
        (0.005627118423548107, 0.049592264914850415, 9.282953393581076, -0.620919936840998),
    ),
    (
        "54E1",
        1 / 20,
        "vertical",
        (-0.0054536774061790805, 0.0559478341625486, 1065.9421201621758, 0.7234823042869359),
    ),
    ("54E1", 1 / 40, "vertical", (-0.006533775692339662, 0.0, 167302.94718115925, -0.5631799716684236)),
]


@pytest.mark.parametrize("rail, inclination, load, pose", ONCE_REFUSED)
def test_poses_that_were_refused_once(rail, inclination, load, pose):
    for model in MODELS:
        assert (
            elastic(rail=rail, rail_inclination=inclination, load=load, normal_model=model)
            .evaluate(*pose)
            .status
            == 0
        )


#: Once refused (status 2 or 3) although the wheelset stands 0.05 to 0.5 mm deep: on the way from the rigid
#: roll to the stand a steep flange would have to be deeper than 2 mm, or the nodes of a deep stand carried
#: more than the load at every level.
STEEP = {
    "separation": {"separation": "vertical"},
    "basic": {"longitudinal_curvature": "basic"},
    "default": {},
}
#: Vertical distances beside the rail's side, 0.4 mm deep: the half-width of the region, and with it the place
#: of its nodes, jumps between heights 5 um apart, and the load from 56 to 560 kN.
VERTICAL_SIDE = "a rare pose where elastic and compliant form differ (docs/evidence/reliability.md)"
ONCE_TOO_STEEP = [
    ("default", (-0.006441960288928336, -0.01931160209022382, 191217.56157863978, -0.9453709409738588)),
    ("basic", (0.006434177935025435, 0.021933914269399883, 190255.06901448508, 0.43692107314968576)),
    ("basic", (0.0065390967883287195, -0.010049882209345197, 168127.83108761467, 0.7583132760564419)),
    ("basic", (0.00646611254798964, -0.0274989256469922, 173709.85983908392, 0.6047533954709294)),
    ("separation", (0.00646611254798964, -0.0274989256469922, 173709.85983908392, 0.6047533954709294)),
    ("separation", (0.0065022498121319085, -0.02087709900787211, 190650.18990882143, 0.9067269304079526)),
    ("separation", (0.00637832868166607, 0.030976122547405567, 153597.37537829397, 0.5586651678481243)),
    ("separation", (0.0064203371819753635, -0.020948591203970697, 177722.16171836772, 0.5811281964470212)),
    pytest.param(
        "separation",
        (0.006463620028195276, -0.02712576155100905, 132535.87157966816, 0.7955738453260797),
        marks=pytest.mark.xfail(strict=True, reason=VERTICAL_SIDE),
    ),
]


@pytest.mark.parametrize("choice, pose", ONCE_TOO_STEEP)
def test_a_steep_flange_stands_where_the_compliant_form_carries_its_load(choice, pose):
    """The compliant form, which is given height and roll, carries the tread's load there, and more than the
    flange's 10 nm lower, less 10 nm higher."""
    shift, yaw, force, transfer = pose
    state = elastic(load="vertical", **STEEP[choice]).evaluate(*pose)
    assert state.status == 0
    away = []
    for move in (-1e-8, 1e-8):
        stand = compliant(load="vertical", **STEEP[choice]).evaluate(
            shift, yaw, vertical_shift_input=state.vertical_shift + move, roll_input=state.roll
        )
        tread = stand.left if shift > 0 else stand.right
        # 1e-8 m is up to 1e-3
        assert carried(tread, "vertical") == pytest.approx(force * (1 - abs(transfer)), rel=2e-3)
        away.append(-stand.force.z - carried(tread, "vertical"))
    wanted = force * (1 + abs(transfer))
    # the stand is met to 1e-13 m, 1e-9 of the load
    assert away[0] < (1 + 1e-8) * wanted and away[1] > (1 - 1e-8) * wanted, (
        away[0] / wanted,
        away[1] / wanted,
    )


def test_both_wheels_stand_at_one_height_where_the_flange_s_jumps():
    """The flange carries its load at several heights of one roll; once the two wheels stood 0.1 mm
    apart there, at status 0."""
    parameters = dict(
        load="vertical",
        normal_model="analyn_strip",
        separation="vertical",
        longitudinal_curvature="basic",
        lateral_curvature="smooth",
    )
    shift, yaw, force, transfer = (
        0.006717038521666567,
        -0.02235267519980281,
        177991.03241361293,
        0.8098496174104448,
    )
    state = elastic(**parameters).evaluate(shift, yaw, force, transfer)
    assert state.status == 0
    stand = compliant(**parameters).evaluate(
        shift, yaw, vertical_shift_input=state.vertical_shift, roll_input=state.roll
    )
    # strips are corrected for the load in one form and for the depth in the other, on a tread
    # 0.14 % at most (measured)
    assert stand.left.normal_force == pytest.approx(state.left.normal_force, rel=2e-3)


def test_a_load_that_no_depth_carries_is_reported():
    """The flange carries at most 0.989 of its load where it is less than 2 mm deep and the tread carries its
    own, by a scan of the compliant form over 1200 rolls; half of the load stands."""
    pair = elastic(load="vertical", longitudinal_curvature="basic")
    pose = (0.00673795137966747, 0.03108301780155364)
    assert pair.evaluate(*pose, 91133.0, 0.9198425535487278).status == 0
    state = pair.evaluate(*pose, 182267.24730465972, 0.9198425535487278)
    sentence = explain(state.status, state.inputs)
    assert state.status == 2
    assert all(
        word in sentence for word in ("normal_force 182267 N", "load_transfer 0.919843", "deeper", "0.002 m")
    ), sentence


# --- bad input ------------------------------------------------------------------------------------


@pytest.mark.parametrize("mode", ["elastic", "compliant"])
def test_a_penetration_is_refused(mode):
    with pytest.raises(ValueError, match="penetration can be prescribed with the contact_mode 'rigid' only"):
        system(contact_mode=mode).evaluate(penetration=5e-5)


def test_bad_heights_and_rolls_are_reported_and_forgotten():
    pair, rigid = compliant(), system().evaluate(1e-3)
    good = dict(lateral_shift=1e-3, vertical_shift_input=rigid.vertical_shift + 5e-5, roll_input=rigid.roll)
    first = pair.evaluate(**good)
    assert first.status == 0
    for name in ("vertical_shift_input", "roll_input"):
        for value in (math.nan, math.inf):
            state = pair.evaluate(**{**good, name: value})
            assert state.status == wrcontact.Status.INVALID_INPUT
            assert name in explain(state.status, state.inputs)
            assert np.isnan(state.values).all()
    for change in (dict(roll_input=0.5), dict(vertical_shift_input=5e-3)):
        assert pair.evaluate(**{**good, **change}).status == wrcontact.Status.OFF_PROFILE
    np.testing.assert_array_equal(pair.evaluate(**good).values, first.values)


def test_a_stand_on_a_jump_of_the_load_is_always_the_same_end_of_it():
    """Two places of the right wheel are equally deep where it stands, one carries more than the load and the
    other less; once they took turns from one nanometre to the next."""
    pair = wrcontact.ContactSystem(
        rail="54E1",
        rail_inclination=1 / 30,
        gauge=1.4452408348436032,
        nominal_radius=0.4724724783139843,
        contact_mode="elastic",
        normal_model="hertz",
        separation="equidistant_chord",
        longitudinal_curvature="basic",
        lateral_curvature="rough",
    )
    shift, yaw, force, transfer = 0.008346254944846863, -0.07552726543349111, 150e3, 0.01602679187811673
    table = pair.evaluate_many(shift + 1e-9 * np.arange(-20, 21), yaw, force, load_transfer=transfer)
    mirrored = pair.evaluate_many(-shift - 1e-9 * np.arange(-20, 21), -yaw, force, load_transfer=-transfer)
    assert not table.status.any() and not mirrored.status.any()
    # 20 nm move the place by 1e-7 m, and to the other one it is 14 mm
    assert np.ptp(table.right.contact.y_wheel) < 1e-6
    assert np.abs(table.right.contact.y_wheel - mirrored.left.contact.y_wheel).max() < 1e-6
