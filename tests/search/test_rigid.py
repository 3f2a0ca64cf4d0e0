"""Rigid contact: published positions, an independent brute-force search, and the conditions
of contact themselves."""

import math

import numpy as np
import pytest

import data
import wrcontact
from data import brute_force
from tests.helpers.fuzzing import cut
from tests.helpers.surface_witness import Surfaces, assert_positions
from wrcontact.kernel.search import first_root
from wrcontact.profiles import standard_profile
from wrcontact.profiles.placement import place_rail

ROLL = 1e-9  # [rad]
POSITION = 1e-6  # [m]


@pytest.fixture(scope="module")
def system():
    return wrcontact.ContactSystem()


@pytest.mark.parametrize(
    "value",
    data.rows_of(data.FOLDER / "rigid_positions.csv"),
    ids=lambda r: f"{r['lateral_shift_mm']}mm_{r['yaw_deg']}deg",
)
def test_reference_positions(system, value):
    state = system.evaluate(lateral_shift=value["lateral_shift_mm"] * 1e-3, yaw=np.radians(value["yaw_deg"]))
    assert state.status == 0
    assert state.roll == pytest.approx(value["roll_rad"], abs=ROLL)
    assert state.vertical_shift == pytest.approx(value["wheelset_z_mm"] * 1e-3, abs=1e-9)
    for letter, side in (("R", state.right), ("L", state.left)):
        assert side.contact.y_wheel == pytest.approx(value[f"{letter}_y_wheel_mm"] * 1e-3, abs=POSITION)
        assert side.contact.x_wheel == pytest.approx(value[f"{letter}_x_wheel_mm"] * 1e-3, abs=POSITION)
        assert side.contact.y_track == pytest.approx(value[f"{letter}_y_track_mm"] * 1e-3, abs=POSITION)
        assert side.rolling_radius == pytest.approx(value[f"{letter}_rolling_radius_mm"] * 1e-3, abs=POSITION)
        # the angle follows the position with the wheel's curvature, 77 1/m at most
        assert side.contact_angle == pytest.approx(value[f"{letter}_contact_angle_rad"], abs=1e-4)


def poses(count, seed):
    """Random pairs, inclinations and poses; every second one without yaw."""
    rng = np.random.default_rng(seed)
    for k in range(count):
        yaw = rng.uniform(-0.0873, 0.0873) if k % 2 else 0.0
        yield ("UIC60", "60E1", "54E1")[k % 3], (1 / 40, 1 / 20)[k // 3 % 2], rng.uniform(-0.01, 0.01), yaw


#: Within 50 um of the right contact's jumps on UIC60 1:40 (data/find_jumps.py), but for the 1 um
#: in which the raw step of S1002's printed coefficients at y = -35 mm would hold the contact.
NEAR_JUMPS = [
    ("UIC60", 1 / 40, shift, yaw)
    for shift, yaw in (
        (4.8475e-3, 0.0),
        (4.8485e-3, 0.0),
        (4.80e-3, 0.0),
        (4.89e-3, 0.0),
        (6.2507e-3, 0.0),
        (6.2519e-3, 0.0),
        (6.21e-3, 0.0),
        (6.30e-3, 0.0),
        (4.9265e-3, np.radians(1)),
        (4.9272e-3, np.radians(1)),
        (6.1572e-3, np.radians(1)),
        (6.1578e-3, np.radians(1)),
        (-5.1632e-3, np.radians(-2)),
        (-5.8775e-3, np.radians(-2)),
        (-5.8780e-3, np.radians(-2)),
    )
]


def compare_with_brute_force(rail, inclination, shift, yaw):
    system = wrcontact.ContactSystem(rail=rail, rail_inclination=inclination)
    truth = brute_force.rigid_contact(brute_force.track(rail, inclination), shift, yaw)
    assert_positions(system.evaluate(lateral_shift=shift, yaw=yaw), truth, POSITION, ("y_rail", "z_rail"))


@pytest.mark.parametrize(
    "pose",
    [
        pose if k == 3 else pytest.param(pose, marks=pytest.mark.full)
        for k, pose in enumerate([*poses(3, seed=11), *NEAR_JUMPS[::8]])
    ],
)
def test_brute_force_agrees(pose):
    compare_with_brute_force(*pose)


MANY = list(poses(60, seed=12)) + NEAR_JUMPS


@pytest.mark.full
@pytest.mark.parametrize(
    "pose", [pytest.param(pose, marks=pytest.mark.complete) if k % 3 else pose for k, pose in enumerate(MANY)]
)
@pytest.mark.turns(3)
def test_brute_force_agrees_on_many(pose):
    compare_with_brute_force(*pose)


def test_contact_point_is_one_point_in_all_frames(system):
    """Wheel frame to track frame by the attitude matrix, rail frame to track frame by the rail's place."""
    shift, yaw = 5.5e-3, 0.02
    state = system.evaluate(lateral_shift=shift, yaw=yaw)
    rail = place_rail(standard_profile("UIC60"), inclination=1 / 40, gauge=1.435, gauge_depth=0.014)
    turn = np.array([[np.cos(yaw), -np.sin(yaw), 0], [np.sin(yaw), np.cos(yaw), 0], [0, 0, 1]])
    lean = np.array(
        [[1, 0, 0], [0, np.cos(state.roll), -np.sin(state.roll)], [0, np.sin(state.roll), np.cos(state.roll)]]
    )
    for sign, side in ((-1, state.left), (1, state.right)):
        point = side.contact
        wheel = np.array([point.x_wheel, sign * (0.75 + point.y_wheel), 0.46 + point.z_wheel])
        track = turn @ lean @ wheel + [0, shift, state.vertical_shift - 0.46]
        np.testing.assert_allclose(track, [point.x_track, point.y_track, point.z_track], atol=1e-12)
        assert sign * point.y_track == pytest.approx(rail.y_track + point.y_rail, abs=1e-12)
        assert point.z_rail == pytest.approx(rail.profile.height(point.y_rail), abs=1e-11)
        assert np.tan(side.contact_angle) == pytest.approx(-rail.profile.slope(point.y_rail), abs=1e-7)
        assert np.hypot(point.x_wheel, 0.46 + point.z_wheel) == pytest.approx(side.rolling_radius, abs=1e-12)


def test_contact_jumps_where_a_railway_engineer_expects(system):
    """Tread to flange root at 4.848 mm, to the flange at 6.25 mm; the second one earlier with yaw."""
    shift = np.arange(4.5e-3, 6.6e-3, 2e-6)
    for yaw, jumps in ((0.0, (4.8479e-3, 6.2518e-3)), (np.radians(1), (4.9268e-3, 6.1575e-3))):
        y = system.evaluate_many(shift, yaw).right.contact.y_wheel
        found = shift[np.flatnonzero(np.abs(np.diff(y)) > 2e-3)]
        np.testing.assert_allclose(found, jumps, atol=4e-6)


@pytest.mark.parametrize(
    "arguments",
    [
        dict(lateral_shift=0.05),
        dict(lateral_shift=-1.0),
        dict(lateral_shift=1e30),
        dict(yaw=0.2),
        dict(yaw=-3.0),
    ],
)
def test_beyond_the_profiles_is_a_status_and_keeps_the_last_values(system, arguments):
    before = system.evaluate(lateral_shift=1e-3)
    state = system.evaluate(**arguments)
    assert state.status == wrcontact.Status.OFF_PROFILE
    assert np.isnan(state.values).all()
    assert system.evaluate(lateral_shift=1e-3).values == pytest.approx(before.values, rel=1e-9, abs=1e-12)


def test_a_contact_on_the_end_of_a_profile_is_off_it():
    """S1002 is straight from 32.2 mm to its end at 60 mm: on a wider track the same place of the rail touches
    it as much further out, up to that end."""
    gauge, end = 1.54, 60e-3  # [m]
    room = end - wrcontact.ContactSystem(gauge=gauge).evaluate().right.contact.y_wheel
    inside = wrcontact.ContactSystem(gauge=gauge + 2 * (room - 1e-6)).evaluate(outputs="geometry")
    assert inside.status == 0
    for side in (inside.left, inside.right):
        assert side.contact.y_wheel == pytest.approx(end - 1e-6, abs=1e-9)
    beyond = wrcontact.ContactSystem(gauge=gauge + 2 * (room + 1e-6)).evaluate(outputs="geometry")
    assert beyond.status == wrcontact.Status.OFF_PROFILE


@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
def test_a_wheel_that_sinks_over_the_end_of_its_profile_is_off_it(model):
    """The wheel sinks straight down on a slope: where it is deepest lies further out than where it touched,
    by depth times sine of the angle, 7 um here."""
    gauge, end = 1.54, 60e-3  # [m]
    centred = wrcontact.ContactSystem(gauge=gauge, normal_model=model).evaluate().right
    room = end - centred.contact.y_wheel
    aside = 107e-6 * math.sin(centred.contact_angle)  # by Hertz's penetration at that place
    inside, beyond = (
        wrcontact.ContactSystem(gauge=gauge + 2 * (room - share * aside), normal_model=model).evaluate()
        for share in (1.2, 0.8)
    )
    assert inside.status == 0
    assert beyond.status == wrcontact.Status.OFF_PROFILE


@pytest.mark.parametrize("left", [1e-3, 1e-4])
@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
def test_a_patch_ends_where_the_wheels_profile_ends(model, left):
    """The inner half of a patch grows like the root of the penetration; the outer one has ``left`` [m]."""
    gauge, end = 1.54, 60e-3  # [m]

    def patch(gauge):
        system = wrcontact.ContactSystem(gauge=gauge, normal_model=model)
        wheel = system.evaluate(normal_force=10e3, side="right").right
        return wheel, wheel.patches[0]

    whole, far = patch(gauge)
    cut, near = patch(gauge + 2 * (end - whole.contact.y_wheel - left))
    inner = 0.5 * far.width * math.sqrt(cut.penetration / whole.penetration)
    assert near.width < 1.02 * inner + left
    assert cut.penetration > whole.penetration and cut.area < whole.area


@pytest.mark.parametrize(
    "rail, inclination, shift, yaw, force",
    [
        # nearly conformal R13 on R13, y_wheel -36 mm
        ("UIC60", 1 / 40, -6.251934541417579e-3, 0.0, 8e3),
        # likewise, beside S1002's step at -35 mm
        ("60E1", 1 / 40, 6.2597306526431685e-3, 0.0, 6.9e3),
        # between the last scan node and the rail's end
        ("UIC60", 1 / 40, 5.452984024507772e-3, 0.051588600550075296, 2.5),
        # kinks in the load over penetration
        ("UIC60", 1 / 40, -6.159960302142493e-3, 0.015818061840829713, 9.5e4),
        # regions that were closed too early
        ("UIC60", 1 / 40, 4.529254062720551e-3, 0.0, 7.1e4),
        # two regions that press each other away
        ("UIC60", 1 / 40, 6.165668323384629e-3, -0.015987082958319174, 6.4e4),
        # outline folded back beside the contact
        ("UIC60", 1 / 40, 4.905236053824249e-3, -0.08038425688630561, 1.7e5),
        ("60E1", 1 / 20, 4.844598087213372e-3, 0.08497943295679282, 7e5),  # contact beside a fold
        ("54E1", 1 / 40, 5.116213193802009e-3, -0.03593182758325816, 6.4e4),  # a region that is none
    ],
)
def test_poses_that_once_failed(rail, inclination, shift, yaw, force):
    state = wrcontact.ContactSystem(rail=rail, rail_inclination=inclination).evaluate(shift, yaw, force)
    assert state.status == 0
    for side in (state.left, state.right):
        assert side.normal_force == pytest.approx(force, rel=1e-6)
        assert 0 < side.max_pressure < 8 * side.normal_force / side.area


def test_far_moves_from_flange_to_tread_converge():
    """Newton crept along one side of the bracket when a pose followed one on the flange."""
    system = wrcontact.ContactSystem(rail="60E1", rail_inclination=1 / 20)
    system.evaluate(0.0063870354021925545, -0.034081234770175765, 112.0)
    state = system.evaluate(0.004809773635151726, 0.023961499467004543, 0.94)
    assert state.status == 0 and state.roll == pytest.approx(-6.393952188661e-05, abs=1e-12)


def test_the_same_inputs_give_the_same_roll_at_large_yaw(system):
    rng = np.random.default_rng(7)
    shift, yaw = rng.uniform(-2e-3, 2e-3, 3000), rng.uniform(0.093, 0.12, 3000)
    plain, guessed = (
        system.evaluate_many(shift, yaw, roll_guess=guess, outputs="geometry") for guess in (0.0, 1e-3)
    )
    assert np.abs(plain.roll - guessed.roll).max() < 1e-12


def test_what_is_settled_starts_from_a_grid():
    """Rolls and places that differ by less than the search's tolerance start from the same multiple of 2^-30, or
    in the middle between two of them; witness: fractions of whole numbers."""
    rng = np.random.default_rng(30)
    for number in rng.integers(-(2**30), 2**30, 200):
        for away in rng.uniform(-0.49, 0.49, 3):
            x = (float(number) + away) / 2**30
            assert first_root.on_grid(x) == first_root.on_other_grid(x) == number / 2**30, x
            assert not first_root.is_unsure(x), x
        middle = (float(number) + 0.5) / 2**30
        for x in (middle - 1.5e-12, middle, middle + 1.5e-12):
            assert first_root.is_unsure(x) and first_root.on_other_grid(x) == middle, x
        for x in (middle - 2.5e-12, middle + 2.5e-12):
            assert not first_root.is_unsure(x) and abs(first_root.on_other_grid(x) - x) < 2.0**-31, x


#: Arguments of the system, lateral shift [m] and yaw [rad], and why the answer once hung on
#: where the search started.
SEVERAL_ANSWERS = {
    "flank above the rail again": (
        dict(rail="54E1", rail_inclination=1 / 30, gauge=1.4347667900382095),
        -0.00282366979555442,
        -0.09984709995757851,
    ),
    "three rolls with a large wheel": (dict(nominal_radius=0.7), 6e-3, 0.0),
    "three rolls with both flanges": (dict(nominal_radius=0.7, gauge=1.425), 1e-3, 0.09),
    "two contacts in a cell": (
        dict(
            rail="54E1",
            rail_inclination=0.0,
            gauge=1.4334222645965715,
            gauge_depth=0.010622885987956932,
            nominal_radius=0.5089481155805106,
        ),
        -0.00427645824847085,
        0.044798104788786125,
    ),
    "a zero that just vanishes": (
        dict(
            rail="54E1",
            gauge=1.4414783620838294,
            gauge_depth=0.010256278977611655,
            nominal_radius=0.6160197692263196,
        ),
        -0.008319861039315497,
        0.0,
    ),
    "a jump beside it": (
        dict(rail="60E1", gauge=1.442560391487472, nominal_radius=0.5873005509731646),
        -0.0099124892437712,
        0.0,
    ),
}


@pytest.mark.parametrize("name", SEVERAL_ANSWERS)
def test_there_is_one_answer(name):
    """From any start, and of several rolls the first one from level: a scan of the
    way there finds no other."""
    arguments, shift, yaw = SEVERAL_ANSWERS[name]
    guesses = np.concatenate([[0.0], np.linspace(-0.1, 0.1, 41), np.linspace(-0.01, 0.01, 40)])
    table = wrcontact.ContactSystem(**arguments).evaluate_many(
        shift, yaw, roll_guess=guesses, outputs="geometry"
    )
    assert not table.status.any()
    assert np.ptp(table.roll) < 1e-12 and np.ptp(table.vertical_shift) < 1e-12
    surfaces = Surfaces(**arguments)
    way = table.roll[0] * np.linspace(0.0, 1.0, 60)[:-1]
    right, left = (
        surfaces.lowest(np.full(59, sign * shift), np.full(59, sign * yaw), sign * way)
        for sign in (1.0, -1.0)
    )
    assert np.all((right - left) * table.roll[0] > 0.0)  # D keeps its sign from level to the roll


@pytest.mark.parametrize("shift", [8.133158769028561e-05, 8.132284882685428e-05])
def test_a_start_that_finds_no_roll_does_not_decide(shift):
    """Beyond its end a wheel's smallest gap jumps: from 4 mrad on the search ended there, with status 2."""
    system = wrcontact.ContactSystem(
        cut("S1002", stop=1.149722310560055),
        gauge=1.4262290727589113,
        gauge_depth=0.011519422829102665,
        nominal_radius=0.6543992887310359,
    )
    table = system.evaluate_many(
        shift, 0.04903556557466748, roll_guess=np.linspace(-0.1, 0.1, 81), outputs="geometry"
    )
    assert not table.status.any()
    assert np.ptp(table.roll) < 1e-12


def test_a_printed_joint_is_no_end():
    """S1002's joint at y = -49.66 mm steps by 6e-11 m in its last digits; the contact
    stays on it for 0.3 um."""
    system = wrcontact.ContactSystem(
        rail="54E1",
        gauge=1.4298494513942086,
        gauge_depth=0.01103666657956913,
        nominal_radius=0.6963042611736863,
    )
    state = system.evaluate(-0.009625104234436804, -0.059105590772747164, roll_guess=-0.06792508450680196)
    assert state.status == 0 and state.left.contact.y_wheel == pytest.approx(-49.66243e-3, abs=1e-7)


def test_a_wheel_that_ends_on_the_tread_is_off_the_profile():
    """Not "not converged": the smallest gap lies at its end, from wherever the search starts."""
    system = wrcontact.ContactSystem(wheel=cut("S1002", stop=6.7))
    guesses = np.linspace(-0.1, 0.1, 21)
    for shift in (0.0, 1e-3, 4e-3, 8e-3):
        statuses = set(system.evaluate_many(shift, 0.01, roll_guess=guesses, outputs="geometry").status)
        whole = wrcontact.ContactSystem().evaluate(shift, 0.01)
        beyond = max(whole.left.contact.y_wheel, whole.right.contact.y_wheel) > 6.7e-3
        assert statuses == {wrcontact.Status.OFF_PROFILE if beyond else wrcontact.Status.VALID}, shift


def test_a_wheel_is_searched_to_its_last_millimetre():
    """Contact 0.2 mm from the end, which lay beyond the last node of the search."""
    whole = wrcontact.ContactSystem().evaluate(2e-3, 0.01)
    stop = whole.left.contact.y_wheel * 1e3 + 0.2
    state = wrcontact.ContactSystem(wheel=cut("S1002", stop=stop)).evaluate(2e-3, 0.01)
    assert state.status == 0 and state.roll == pytest.approx(whole.roll, abs=1e-12)


@pytest.mark.parametrize(
    "start, stop", [(-70.0, 28.481727808186925), (-35.19681944545982, 60.0), (-44.1, 0.7)]
)
def test_a_profile_has_a_height_at_both_its_ends(start, stop):
    profile = cut("S1002", start, stop)
    for name in ("UIC60", "60E1", "54E1"):
        ends = standard_profile(name)
        assert np.isfinite(ends.height([ends.start, ends.stop])).all()
    assert np.isfinite(profile.height([profile.start, profile.stop])).all()
    assert np.isnan(profile.height([profile.start - 1e-9, profile.stop + 1e-9])).all()
