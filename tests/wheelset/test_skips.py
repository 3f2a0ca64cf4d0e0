"""What is not wanted is not computed, unchanged inputs are not evaluated again, and what a pose may cost."""

import threading

import numpy as np
import pytest

import wrcontact
from tests.helpers.cases import input_row
from tests.helpers.cases import system as kept_system
from tests.helpers.inside import counts_of
from wrcontact import Status
from wrcontact.kernel import layout

COUNTERS = "gap", "scan", "roll", "node", "solve", "strip"
MODELS = ("hertz", "analyn", "analyn_strip")
PATCHES = slice(layout.SIDE_PENETRATION, layout.SIDE_STATION)
OUTLINE = slice(layout.SIDE_STATION, layout.SIDE_SIZE)


def system_of(model):
    return kept_system(normal_model=model)


def rows_of(shift, yaw=0.0, force=78.5e3):
    """Inputs (n, 7)."""
    rows = np.zeros((len(shift), layout.INPUT_COUNT))
    rows[:, layout.IN_LATERAL_SHIFT], rows[:, layout.IN_YAW], rows[:, layout.IN_NORMAL_FORCE] = (
        shift,
        yaw,
        force,
    )
    return rows


def random_rows(count, seed=61):
    rng = np.random.default_rng(seed)
    return rows_of(
        rng.uniform(-6.6e-3, 6.6e-3, count),
        np.radians(rng.uniform(-2, 2, count)) * (rng.random(count) < 0.5),
        np.exp(rng.uniform(np.log(3e3), np.log(2e5), count)),
    )


def cost(model, rows, **wanted):
    """Counts per pose by name."""
    stepper = system_of(model).stepper(**wanted)
    stepper.step_many(rows, np.zeros((len(rows), layout.OUTPUT_COUNT)), np.zeros(len(rows)))
    return {name: count / len(rows) for name, count in counts_of(stepper).items()}


def step(stepper, row):
    """Status and outputs at the first inputs; those that ``row`` leaves out stay as they are."""
    stepper.inputs[: len(row)] = row
    return stepper.step(), stepper.outputs.copy()


def side_of(outputs, name):
    first = {"left": layout.OUT_LEFT, "right": layout.OUT_RIGHT}[name]
    return outputs[first : first + layout.SIDE_SIZE]


# --- unchanged inputs ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("force", [78.5e3, 0.0])
def test_unchanged_inputs_are_not_evaluated_again(model, force):
    stepper = system_of(model).stepper()
    status, outputs = step(stepper, (5e-3, 0.01, 0.0, force, 0.1))
    assert status == (Status.VALID if force else Status.UNLOADED)
    state = stepper.state.copy()
    for _ in range(3):
        stepper.outputs[:] = np.nan  # whatever somebody wrote there
        again, repeated = step(stepper, (5e-3, 0.01, 0.0, force, 0.1))
        assert again == status
        np.testing.assert_array_equal(repeated, outputs)
    np.testing.assert_array_equal(stepper.state, state)


@pytest.mark.parametrize("place", range(layout.INPUT_COUNT))
def test_every_changed_input_is_evaluated(place):
    """The smallest change there is, and back again."""
    stepper = system_of("analyn_strip").stepper()
    row = input_row(5e-3, 0.01, 1e-4, 78.5e3, 0.1, 1e-4, 1e-3)
    changed = row.copy()
    changed[place] = np.nextafter(row[place], 0.0 if row[place] else 1.0)
    step(stepper, row)
    for following in (changed, row):
        before = counts_of(stepper)
        step(stepper, following)
        # strips have no force iterations
        assert all(counts_of(stepper)[name] > before[name] for name in COUNTERS if name != "solve")


def test_a_failed_step_is_tried_again():
    """After an input that cannot be the same valid one is evaluated anew, and the failed one again too."""
    stepper = system_of("analyn").stepper()
    _, good = step(stepper, (2e-3, 0.0, 0.0, 5e4, 0.0))
    for wrong, status in (((np.nan, 0, 0, 5e4, 0), 4), ((0.5, 0, 0, 5e4, 0), 2), ((2e-3, 0, 0, -1, 0), 4)):
        for _ in range(2):
            assert step(stepper, wrong)[0] == status
            np.testing.assert_array_equal(stepper.outputs, good)
        before = counts_of(stepper)
        again, outputs = step(stepper, (2e-3, 0.0, 0.0, 5e4, 0.0))
        assert again == Status.VALID and counts_of(stepper)["gap"] > before["gap"]
        np.testing.assert_allclose(outputs, good, rtol=1e-9, atol=1e-12)


def test_minus_zero_is_zero_and_rows_repeat():
    rows = np.repeat(random_rows(20), 5, axis=0)
    stepper = system_of("analyn").stepper()
    outputs = np.zeros((len(rows), layout.OUTPUT_COUNT))
    stepper.step_many(rows, outputs, np.zeros(len(rows)))
    repeated = counts_of(stepper)
    single = system_of("analyn").stepper()
    single.step_many(np.ascontiguousarray(rows[::5]), np.zeros((20, layout.OUTPUT_COUNT)), np.zeros(20))
    assert repeated == counts_of(single)
    for k in range(5):
        np.testing.assert_array_equal(outputs[k::5], outputs[::5])


def test_prescribing_and_wanting_are_changes():
    """The same inputs, but other questions."""
    stepper = system_of("analyn").stepper()
    row = (3e-3, 0.0, 0.0, 78.5e3, 0.0)
    by_force = step(stepper, row)[1]
    stepper.prescribe(5e-5)
    by_penetration = step(stepper, row)[1]
    assert side_of(by_penetration, "right")[layout.SIDE_PENETRATION] == 5e-5
    stepper.prescribe((5e-5, 6e-5))
    assert side_of(step(stepper, row)[1], "right")[layout.SIDE_PENETRATION] == 6e-5
    stepper.prescribe(None)
    np.testing.assert_allclose(step(stepper, row)[1], by_force, rtol=1e-9, atol=1e-12)
    stepper.want(side="left")
    assert np.all(np.isnan(side_of(step(stepper, row)[1], "right")))
    stepper.want()
    np.testing.assert_allclose(step(stepper, row)[1], by_force, rtol=1e-9, atol=1e-12)


# --- what is wanted -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("outputs", ["all", "patches", "geometry"])
@pytest.mark.parametrize("side", ["both", "left", "right"])
def test_wanted_values_are_those_of_the_full_evaluation(model, outputs, side):
    """Bit by bit, poses in the same order; NaN in all others."""
    full, part = system_of(model).stepper(), system_of(model).stepper(side, outputs)
    rows = random_rows(40)
    rows[::8, layout.IN_NORMAL_FORCE] = 0.0
    for row in rows:
        status, whole = step(full, row)
        assert step(part, row)[0] == status
        some = part.outputs
        wheelset = whole[: layout.OUT_LEFT].copy()
        # the resultant is that of both sides, and of their patches
        if side != "both" or outputs == "geometry":
            wheelset[layout.OUT_FORCE :] = np.nan
        np.testing.assert_array_equal(some[: layout.OUT_LEFT], wheelset)
        for name in ("left", "right"):
            expected = side_of(whole, name).copy()
            if side not in ("both", name):
                expected[:] = np.nan
            if outputs != "all":
                expected[OUTLINE] = np.nan
            if outputs == "geometry":
                expected[PATCHES] = expected[layout.SIDE_PATCH_COUNT] = np.nan
            found = side_of(some, name)
            np.testing.assert_array_equal(found, expected)
            exact = np.isfinite(expected)
            np.testing.assert_array_equal(found[exact].view(np.int64), expected[exact].view(np.int64))


@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
def test_geometry_costs_no_normal_contact(model):
    """No normal gap, no force solve, no strips, and no more than Hertz's search."""
    rows = random_rows(300)
    found = cost(model, rows, outputs="geometry")
    assert found["node"] == found["solve"] == found["strip"] == 0.0
    assert {name: found[name] for name in ("gap", "scan", "roll")} == {
        name: cost("hertz", rows)[name] for name in ("gap", "scan", "roll")
    }
    assert cost(model, rows, side="right", outputs="geometry")["node"] == 0.0


@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
def test_one_side_costs_half_the_normal_contact(model):
    """The sides' counts add up to those of both; the roll search is the same."""
    rows = random_rows(300)
    both, left, right = (cost(model, rows, side=side) for side in ("both", "left", "right"))
    for name in ("node", "solve", "strip"):
        assert left[name] + right[name] == pytest.approx(both[name], rel=1e-12), name
        assert 0.4 * both[name] <= left[name] <= 0.6 * both[name]
    assert left["roll"] == right["roll"] == both["roll"] and left["scan"] == both["scan"]
    geometry = cost(model, rows, outputs="geometry")["gap"]
    assert left["gap"] + right["gap"] - geometry == pytest.approx(both["gap"], rel=1e-12)


@pytest.mark.parametrize("model", MODELS)
def test_no_load_costs_what_geometry_costs(model):
    rows = random_rows(100)
    rows[:, layout.IN_NORMAL_FORCE] = 0.0
    assert cost(model, rows) == cost(model, random_rows(100), outputs="geometry")


def test_outline_costs_no_evaluation():
    rows = random_rows(100)
    for model in ("analyn", "analyn_strip"):
        assert cost(model, rows, outputs="patches") == cost(model, rows)


def test_yaw_alone_costs_no_more_contacts():
    """Without yaw the outline is the profile: fewer evaluations of the vertical gap, no other
    count changes by a half."""
    rows = random_rows(300)
    straight, yawed = rows.copy(), rows.copy()
    straight[:, layout.IN_YAW], yawed[:, layout.IN_YAW] = 0.0, 0.02
    for model in ("analyn", "analyn_strip"):
        plain, turned = cost(model, straight), cost(model, yawed)
        assert all(turned[name] < 1.5 * plain[name] for name in plain if plain[name]), (plain, turned)


def test_status_is_of_the_sides_that_are_wanted():
    system = system_of("analyn")
    for side, status in (("both", Status.UNLOADED), ("left", Status.VALID), ("right", Status.UNLOADED)):
        assert system.evaluate(2e-3, load_transfer=-1.0, side=side).status == status


@pytest.mark.parametrize(
    "arguments, sentence",
    [
        ({"side": "middle"}, "side is 'middle'; permitted are 'both', 'left', 'right'"),
        ({"outputs": "everything"}, "outputs is 'everything'; permitted are 'all', 'patches', 'geometry'"),
        ({"side": None}, "side is None; permitted are 'both', 'left', 'right'"),
    ],
)
def test_wrong_wishes_are_refused(arguments, sentence):
    system = system_of("analyn")
    for ask in (system.stepper, system.evaluate, system.evaluate_many):
        with pytest.raises(ValueError) as refusal:
            ask(**arguments)
        assert str(refusal.value).startswith(sentence)
    assert system.evaluate(1e-3).status == Status.VALID


def test_wishes_can_be_mixed_in_one_thread():
    """Every evaluate() of a thread shares one stepper: each answer is that of a stepper which
    never did anything else."""
    system = wrcontact.ContactSystem(normal_model="analyn_strip")
    rows = random_rows(6)
    problems = []

    def work(seed):
        rng = np.random.default_rng(seed)
        for _ in range(120):
            row = rows[rng.integers(len(rows))]
            wanted = {
                "side": str(rng.choice(["both", "left", "right"])),
                "outputs": str(rng.choice(["all", "patches", "geometry"])),
                "penetration": [None, 4e-5, (3e-5, 6e-5)][rng.integers(3)],
            }
            found = system.evaluate(row[0], row[1], row[3], **wanted)
            fresh = system.stepper(wanted["side"], wanted["outputs"])
            fresh.prescribe(wanted["penetration"])
            expected = step(fresh, row)[1]
            if not (
                np.array_equal(np.isnan(found.values), np.isnan(expected))
                and np.allclose(found.values, expected, rtol=1e-6, atol=1e-9, equal_nan=True)
            ):
                problems.append((row, wanted))

    threads = [threading.Thread(target=work, args=(seed,)) for seed in (62, 63)]
    [thread.start() for thread in threads], [thread.join() for thread in threads]
    assert not problems, problems[0]


def test_a_step_that_fails_keeps_what_was_wanted_before():
    stepper = system_of("analyn").stepper("right", "patches")
    kept = step(stepper, (2e-3, 0, 0, 5e4, 0))[1]
    assert step(stepper, (np.nan, 0, 0, 5e4, 0))[0] == Status.INVALID_INPUT
    np.testing.assert_array_equal(stepper.outputs, kept)


# --- budgets ------------------------------------------------------------------------------------------------


TURN = np.linspace(0, 2 * np.pi, 2000)
RNG = np.random.default_rng(63)
CLASSES = {
    "trajectory": rows_of(6.6e-3 * np.sin(TURN)),
    "yawed_trajectory": rows_of(6.6e-3 * np.sin(TURN), 5e-3 * np.cos(TURN)),
    "random": rows_of(
        RNG.uniform(-6.6e-3, 6.6e-3, 2000), force=np.exp(RNG.uniform(np.log(3e3), np.log(2e5), 2000))
    ),
    "yawed": rows_of(RNG.uniform(-6.6e-3, 6.6e-3, 2000), np.radians(RNG.uniform(-2, 2, 2000))),
    "two_point": rows_of(RNG.uniform(4.5e-3, 5.3e-3, 2000)),
}
#: Vertical gaps, scans, normal gaps and force iterations of both wheels: a tenth more than measured.
ANALYN_BUDGETS = {
    "trajectory": (93, 2.4, 59, 8),
    "yawed_trajectory": (95, 2.4, 59, 8),
    "random": (84, 2.3, 58, 8),
    "yawed": (108, 2.5, 61, 8.5),
    "two_point": (105, 2.5, 78, 8.6),
}
#: Surfaces under strips are traced once, their systems are solved by elimination: no force iterations, but
#: six sweeps of each wheel, of ten unknowns where one patch carries (11 systems of up to 24 before). A wheel
#: that they find deeper than estimated is sunk anew, which costs gaps and nodes; one whose estimate was far
#: too deep begins again where ANALYN stands.
STRIP_BUDGETS = {
    "trajectory": (98, 2.4, 77, 0.01, 12.01),
    "yawed_trajectory": (100, 2.4, 77, 0, 12),
    "random": (89, 2.3, 74, 0, 12),
    "yawed": (115, 2.5, 82, 0, 12),
    "two_point": (112, 2.5, 102, 0, 12),
}


@pytest.mark.parametrize("name", CLASSES)
@pytest.mark.parametrize(
    "model, budgets",
    [("analyn", ANALYN_BUDGETS), pytest.param("analyn_strip", STRIP_BUDGETS, marks=pytest.mark.full)],
)
def test_work_of_a_pose_is_bounded(model, budgets, name):
    """What speed rests on, counted and not timed."""
    found = cost(model, CLASSES[name])
    spent = [found[counter] for counter in ("gap", "scan", "node", "solve", "strip")[: len(budgets[name])]]
    assert np.all(np.array(spent) <= budgets[name]), (spent, budgets[name])


@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
def test_no_pose_costs_many_times_the_usual(model):
    """The most expensive of 2000 poses: ten times the mean in no count."""
    stepper = system_of(model).stepper()
    before, worst = counts_of(stepper), {name: 0.0 for name in COUNTERS}
    for row in CLASSES["yawed"]:
        step(stepper, row)
        now = counts_of(stepper)
        worst = {name: max(most, now[name] - before[name]) for name, most in worst.items()}
        before = now
    usual = cost(model, CLASSES["yawed"])
    assert all(worst[name] <= 10 * usual[name] for name in COUNTERS), (worst, usual)
