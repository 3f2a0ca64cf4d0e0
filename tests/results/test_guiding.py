"""Y and Q of results, and the filters of EN 14363 against closed forms."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.cases import system

STEP = 1e-3
TIME = STEP * np.arange(4000)
SHIFTS = [0.0, 6.1e-3, -6.3e-3]


def test_without_friction_the_quotient_is_the_tangent_of_the_contact_angle():
    """Of one patch, outwards over downwards, on both sides."""
    for shift in SHIFTS:
        state = system(normal_model="hertz").evaluate(shift)
        for side in (state.left, state.right):
            assert side.derailment_quotient == pytest.approx(np.tan(side.patches[0].contact_angle), rel=1e-12)


@pytest.mark.parametrize("climbs", [True, False])
def test_a_flange_that_slides_has_the_quotient_of_nadal(climbs):
    """tan(gamma - arctan mu) where the flange slides down over its rail, and tan(gamma + arctan mu) where it
    is pushed up.  A wheel that nearly stands slides as it is moved, along its contact plane."""
    friction = 0.3
    state = system(normal_model="hertz", tangential_model="strips", contact_mode="rigid").evaluate(
        6.6e-3,
        speed=1e-4,
        wheel_rate=1e-4,
        lateral_velocity=10.0 if climbs else -10.0,
        right_friction=friction,
    )
    (patch,) = state.right.patches
    angle = patch.contact_angle
    assert angle > 0.8 and patch.saturation == pytest.approx(1.0, abs=1e-3)
    wanted = np.tan(angle + np.arctan(friction if climbs else -friction))
    assert state.right.derailment_quotient == pytest.approx(wanted, rel=2e-2)


def test_guiding_forces_are_those_on_the_rails():
    """Opposite to those on the wheels, which the wheelset's are the sum of."""
    table = system(tangential_model="strips").evaluate_many(SHIFTS, yaw=2e-3, speed=20.0)
    forces = wrcontact.guiding_forces(table)
    np.testing.assert_allclose(forces.sum_y, -table.force.y, atol=1e-9)
    np.testing.assert_allclose(forces.left_q + forces.right_q, -table.force.z, atol=1e-9)
    np.testing.assert_allclose(forces.right_y / forces.right_q, table.right.derailment_quotient, rtol=1e-14)
    np.testing.assert_allclose(forces.left_y / forces.left_q, table.left.derailment_quotient, rtol=1e-14)
    # a flange pushes its rail outwards
    assert forces.right_y[1] > 1e4 and forces.left_y[2] > 1e4
    assert (forces.left_q > 0.0).all() and (forces.right_q > 0.0).all()
    one = wrcontact.guiding_forces(table[1])
    assert one.right_y == forces.right_y[1] and isinstance(one.sum_y, float)
    for side, sign in (("left", 1.0), ("right", -1.0)):
        force, _ = system(tangential_model="strips").rail_reaction(table[1], side)
        assert getattr(one, f"{side}_y") == pytest.approx(-sign * force[1], rel=1e-12)
        assert getattr(one, f"{side}_q") == pytest.approx(force[2], rel=1e-12)


def test_a_wheel_without_load_has_no_quotient():
    assert system().evaluate(0.0, load_transfer=1.0).left.derailment_quotient == 0.0


# --- low pass -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("frequency", [2.0, 10.0, 20.0, 40.0, 80.0])
def test_a_sine_is_let_through_by_the_closed_form(frequency):
    """Without delay: -3 dB at 20 Hz, 24 dB an octave beyond."""
    wave = np.sin(2.0 * np.pi * frequency * TIME)
    ratio = np.tan(np.pi * frequency * STEP) / np.tan(np.pi * 20.0 * STEP)
    share = 1.0 / (1.0 + (np.sqrt(2.0) - 1.0) * ratio**4)
    found = wrcontact.low_pass(wave, STEP)
    inside = slice(500, -500)
    np.testing.assert_allclose(found[inside], share * wave[inside], atol=1e-9)
    if frequency == 20.0:
        assert share == pytest.approx(np.sqrt(0.5), rel=1e-12)
    if frequency == 80.0:
        half = 1.0 / (1.0 + (np.sqrt(2.0) - 1.0) * 2.0**4)
        assert 20.0 * np.log10(half / share) == pytest.approx(24.0, abs=1.6)


def test_straight_lines_pass_and_columns_are_filtered_one_by_one():
    line = 3.0 + 2.0 * TIME
    np.testing.assert_allclose(wrcontact.low_pass(line, STEP), line, atol=1e-9)
    waves = np.stack([line, np.sin(40.0 * TIME)], axis=1)
    np.testing.assert_array_equal(
        wrcontact.low_pass(waves, STEP)[:, 1], wrcontact.low_pass(waves[:, 1], STEP)
    )
    assert len(wrcontact.low_pass([1.0, 1.0, 1.0], STEP)) == 3


# --- sliding mean ---------------------------------------------------------------------------------------


def test_means_of_a_line_and_of_a_wave_are_closed_forms():
    """Rows are not even; a wave of the length of a window has no mean."""
    rng = np.random.default_rng(3)
    along = 5.0 + np.cumsum(rng.uniform(5e-4, 1.5e-3, 20000))
    places, means = wrcontact.sliding_mean(1.0 + 0.25 * along, along)
    np.testing.assert_allclose(means, 1.0 + 0.25 * places, rtol=1e-12)
    assert places[0] == along[0] + 1.0 and np.ptp(np.diff(places)) < 1e-12 and places[1] - places[0] == 0.5
    assert along[-1] - 1.5 < places[-1] <= along[-1] - 1.0 + 1e-12
    for length in (2.0, 3.0):
        wave = np.sin(2.0 * np.pi * along / length)
        places, means = wrcontact.sliding_mean(wave, along, step=0.1)
        share = np.sinc(2.0 / length)
        np.testing.assert_allclose(means, share * np.sin(2.0 * np.pi * places / length), atol=2e-6)


def test_a_table_as_long_as_a_window_has_one_mean():
    places, means = wrcontact.sliding_mean([[1.0, 2.0], [3.0, 6.0]], [0.0, 2.0])
    np.testing.assert_allclose(places, [1.0])
    np.testing.assert_allclose(means, [[2.0, 4.0]])
    along = np.linspace(0.0, 10.0, 1001)
    assert len(wrcontact.sliding_mean(along, along)[0]) == 17


LOW, MEAN = wrcontact.low_pass, wrcontact.sliding_mean


@pytest.mark.parametrize(
    "call, arguments, words",
    [
        (LOW, ([1.0, np.nan, 2.0], 1e-3), "values is not finite in row 1; permitted are finite numbers"),
        (LOW, ([1.0, 2.0], 0.0), "step is 0.0; permitted are numbers above 0, in s"),
        (LOW, ([1.0, 2.0], 0.025), "frequency is 20 Hz; permitted with a step of 0.025 s is less than 20 Hz"),
        (LOW, ([1.0], 1e-3), r"values has the shape \(1,\); permitted are two rows at least"),
        (LOW, ("ab", 1e-3), "values is 'ab'; permitted are numbers"),
        (MEAN, ([1.0, 2.0], [0.0, 1.0]), "distance covers 1 m; permitted with a window of 2 m is as much"),
        (MEAN, ([1.0, 2.0, 3.0], [0.0, 4.0, 3.0]), "distance does not rise from row to row"),
        (MEAN, ([1.0, 2.0], [0.0, 1.0, 2.0]), r"distance has the shape \(3,\); permitted .* is \(2,\)"),
        (MEAN, ([1.0, 2.0], [0.0, 3.0], -1.0), "length is -1.0; permitted are numbers above 0, in m"),
        (MEAN, ([1.0, 2.0], [0.0, 3.0], 2.0, True), "step is True; permitted are numbers above 0, in m"),
    ],
)
def test_wrong_input_is_refused_in_a_sentence(call, arguments, words):
    with pytest.raises(ValueError, match=words):
        call(*arguments)
