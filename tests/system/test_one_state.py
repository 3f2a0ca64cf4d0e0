"""A state depends on its inputs alone, to the last bit: not on the states before it, their order, threads,
blocks, or a guess of the roll."""

import numpy as np
import pytest

import wrcontact
from wrcontact.stepper import SHARED_ROWS

SPEEDS = {"speed": (1.0, 30.0)}
RAILS = {"right_rail_lateral": (-1e-3, 1e-3), "left_rail_vertical": (-1e-3, 1e-3)}
#: Arguments of the system, and ranges of inputs that are drawn beside lateral shift and yaw.
CASES = {
    "rigid": ({}, {}),
    "rigid_strips": ({"normal_model": "analyn_strip", "tangential_model": "strips"}, SPEEDS),
    "rigid_vertical": ({"load": "vertical", "tangential_model": "fastsim"}, {**SPEEDS, **RAILS}),
    "rigid_rolled_rails": ({"rail": "60E1"}, {"right_rail_roll": (-5e-3, 5e-3)}),
    "elastic": ({"contact_mode": "elastic", "tangential_model": "polach"}, {**SPEEDS, **RAILS}),
    "elastic_strips": (
        {"contact_mode": "elastic", "normal_model": "analyn_strip", "tangential_model": "strips"},
        {**SPEEDS, "load_transfer": (-0.5, 0.5)},
    ),
    "elastic_hertz": (
        {"contact_mode": "elastic", "normal_model": "hertz"},
        {"right_rail_roll": (-5e-3, 5e-3)},
    ),
    "compliant": (
        {"contact_mode": "compliant", "tangential_model": "fastrip"},
        {**SPEEDS, "vertical_shift_input": (0.0, 2e-4), "roll_input": (-3e-4, 3e-4)},
    ),
    "springs": (
        {"contact_mode": "compliant", "rail_lateral_stiffness": 5e7, "rail_vertical_stiffness": 1e8},
        {"vertical_shift_input": (0.0, 2e-4), "roll_input": (-3e-4, 3e-4)},
    ),
}


def drawn(case, count, seed, yaw=0.05):
    """The system and random inputs (name: (count,)) of a case; a third of them without yaw."""
    arguments, ranges = CASES[case]
    rng = np.random.default_rng(seed)
    inputs = {
        "lateral_shift": rng.uniform(-9e-3, 9e-3, count),
        "yaw": rng.uniform(-yaw, yaw, count) * (rng.random(count) < 0.67),
        **{name: rng.uniform(*ends, count) for name, ends in ranges.items()},
    }
    return wrcontact.ContactSystem(**arguments), inputs


def assert_one_table(system, inputs, seed=1):
    """The bits of all outputs and the statuses do not depend on order, threads and guess."""
    count = len(inputs["yaw"])

    def values(order, **more):
        rows = {name: column[order] for name, column in inputs.items()}
        table = system.evaluate_many(**rows, **more)
        found = np.empty((count, table.values.shape[1] + 1))
        found[order] = np.column_stack([table.values, table.status])
        return np.nan_to_num(found, nan=-1e300).view(np.int64)

    given = np.arange(count)
    one = values(given, threads=1)
    orders = {
        "shuffled": np.random.default_rng(seed).permutation(count),
        "sorted": np.argsort(inputs["lateral_shift"], kind="stable"),
        "backwards": given[::-1],
    }
    for name, order in orders.items():
        np.testing.assert_array_equal(values(order, threads=1), one, err_msg=name)
    np.testing.assert_array_equal(values(orders["shuffled"], threads=2), one, err_msg="threads")
    for guess in (1e-3, -4e-3):
        np.testing.assert_array_equal(values(given, threads=1, roll_guess=guess), one, err_msg=str(guess))


@pytest.mark.parametrize("case", CASES)
def test_a_state_depends_on_its_inputs_alone(case):
    assert_one_table(*drawn(case, 40, 71))


@pytest.mark.full
@pytest.mark.parametrize("case", CASES)
def test_more_states_depend_on_their_inputs_alone(case):
    """By two threads, too: some blocks of rows."""
    few = case == "springs"
    assert_one_table(*drawn(case, 200 if few else 3 * SHARED_ROWS + 77, 72))


@pytest.mark.full
def test_strongly_yawed_wheelsets_depend_on_their_inputs_alone():
    assert_one_table(*drawn("rigid", 10_000, 73, yaw=0.1))


@pytest.mark.complete
@pytest.mark.parametrize("part", range(20))
@pytest.mark.parametrize("case", CASES)
def test_many_states_depend_on_their_inputs_alone(case, part):
    assert_one_table(*drawn(case, 2_000 if case == "springs" else 50_000, [74, part]))


def test_one_step_after_another_has_the_bits_of_each_alone():
    """A stepper with memory, and a new system for each pose."""
    stepper = wrcontact.ContactSystem().stepper()
    for shift in (1e-3, 1.1e-3, -6e-3, -6.05e-3, 1e-3):
        stepper.inputs[:] = wrcontact.ContactSystem().evaluate(lateral_shift=shift).inputs
        assert stepper.step() == 0
        alone = wrcontact.ContactSystem().evaluate(lateral_shift=shift)
        np.testing.assert_array_equal(stepper.outputs, alone.values)


def test_a_roll_between_two_places_of_the_grid_is_one():
    """Where rounding decides between two places of the grid, what is found from either is rounded once more,
    to a third. Such a shift is found by halving; from guess to guess its roll would be rounded as it comes."""
    system = wrcontact.ContactSystem()
    shift = np.linspace(2e-3, 2e-3 + 2e-7, 2001)

    def above(shift):
        roll = system.evaluate_many(shift, outputs="geometry").roll
        return np.mod(roll * 2.0**30, 1.0) - 0.5  # crosses zero in the middle, and jumps at a place

    crossing = np.flatnonzero(np.abs(np.diff(np.sign(above(shift)))) * (np.abs(above(shift)[:-1]) < 0.2))
    low, high = shift[crossing[0] : crossing[0] + 2]
    rises = above([high])[0] > 0.0
    for _ in range(40):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if (above([middle])[0] < 0.0) == rises else (low, middle)
    near = low + np.arange(-40, 40) * np.spacing(low)
    rolls = [
        system.evaluate_many(near, roll_guess=guess, outputs="geometry").roll
        for guess in (0.0, 1e-3, -1e-3, 3e-3, 1e-4, 2e-4)
    ]
    assert all(np.array_equal(roll, rolls[0]) for roll in rolls)
    assert np.any(np.abs(np.mod(rolls[0] * 2.0**30, 1.0) - 0.5) < 1e-4)  # 1e-13 rad
