"""Model exchange of the native FMUs: the bits of co-simulation at the same inputs, at every point of a
solver."""

import pytest

from tests.helpers.cases import LEFT_SIDE, OUTPUT_NAMES, moving_track, poses
from tests.helpers.fmus import WARM_START, assert_same, needs_compiler

pytestmark = [needs_compiler, pytest.mark.parametrize("version", (2, 3))]

WARNING, ERROR = 1, 3
NAMES = ["status", "roll", "force.y", "right.area", "left.patch[1].length"]
MODELS = {
    "rigid": {},
    "elastic": {"contact_mode": "elastic", "tangential_model": "polach"},
    "compliant": {"contact_mode": "compliant", "tangential_model": "strips", "contact_damping": 0.5},
}


@pytest.mark.parametrize("model", MODELS)
def test_outputs_follow_inputs_without_a_step(hosts, version, model):
    """The bits of co-simulation after a step at the same inputs, in both modes, and then again by steps."""
    start, host = MODELS[model] | (LEFT_SIDE if model != "rigid" else {}), hosts(version)
    rows = moving_track(12, compliant=model == "compliant") if model != "rigid" else poses(12)
    wanted = host.ask("trajectory", rows=rows, names=OUTPUT_NAMES, start=start)["seen"]
    seen = host.ask("points", rows=rows, names=OUTPUT_NAMES, start=start, exchange=True)
    assert seen["continuous"] == wanted
    assert len({str(one) for one in wanted}) == 12
    for found, other in zip(seen["event"], wanted):
        assert_same(found, other, WARM_START)  # another start of the search
    steps = host.ask("trajectory", rows=rows, names=OUTPUT_NAMES, start=start, exchange=True)
    assert steps["seen"] == wanted


def test_derivatives_are_those_of_co_simulation(hosts, version):
    given = {
        "rows": moving_track(3, True),
        "start": MODELS["compliant"] | LEFT_SIDE,
        "outputs": ["force.y", "moment.z", "left.area"],
        "inputs": ["lateral_shift", "yaw", "yaw_rate", "speed"],
    }
    if version == 3:
        given = given | {"stations": 61, "outputs": [*given["outputs"], "right.pressure"]}
    found, wanted = (
        hosts(version).ask("derivatives", exchange=exchange, **given) for exchange in (True, False)
    )
    assert found["seen"] == wanted["seen"] and any(map(any, found["seen"][0]["matrix"]))
    assert all(one["kept"] for one in found["seen"]) and found["after"]
    if version == 3:  # the adjoint of all outputs is the sum of each column
        for one in found["seen"]:
            assert one["adjoint"] == pytest.approx([sum(column) for column in one["matrix"]], rel=1e-12)


@pytest.mark.parametrize("invalid, status", [(0.05, 2), (float("nan"), 4)], ids=["off the profile", "nan"])
def test_invalid_points_hold_to_the_accepted_one(hosts, version, invalid, status):
    """And not to one that the solver has tried; also after the state was saved and set elsewhere.  Only
    completed steps are told."""
    accepted, tried = poses(3)[1:]
    seen = hosts(version).ask(
        "tries",
        accepted=accepted,
        tried=tried,
        invalid={"lateral_shift": invalid},
        names=OUTPUT_NAMES,
        exchange=True,
    )
    codes = {name: row.pop("status") for name, row in seen.items() if isinstance(row, dict)}
    assert codes == {
        "accepted": 0,
        "tried": 0,
        "invalid": status,
        "elsewhere": status,
        "still invalid elsewhere": status,
        "again": 0,
    }
    assert abs(seen["tried"]["right.area"] - seen["accepted"]["right.area"]) > 1e-6
    for name in ("invalid", "elsewhere", "still invalid elsewhere"):
        assert_same(seen[name], seen["accepted"], WARM_START)
    assert_same(seen["again"], seen["tried"], WARM_START)
    assert seen["silent"] == seen["rest"] == []
    first, second = seen["told"]
    assert first == second and first[:2] == [WARNING, "logStatusWarning"] and "lateral_shift is" in first[2]


def test_saved_states(hosts, version):
    """A continuation from a state has the bits of the run that was not interrupted."""
    seen = hosts(version).ask("saved_states", rows=poses(9), start={}, exchange=True)
    assert seen["straight"] == seen["back"] == seen["elsewhere"] and seen["restored"] == seen["before"]
    assert seen["refusals"] == [True] * 4 and seen["kept"]


def test_a_state_belongs_to_its_kind(hosts, version):
    answers = hosts(version).ask("foreign_states", rows=poses(3))
    for exchange, (refused, lines, works) in answers.items():
        kinds = ("model exchange", "co-simulation")[:: 1 if exchange == "True" else -1]
        words = "the saved state is one of {}, and this instance is for {}; the present state is kept"
        assert refused and works and lines == [[ERROR, "logStatusError", words.format(*kinds)]]


@pytest.mark.parametrize("solver", ["CVode", "Euler"])
def test_simulated_by_fmpy(hosts, version, solver):
    """Each row holds the outputs of the inputs at its time, not of those before it."""
    rows, times = poses(11), [0.01 * k for k in range(11)]
    host = hosts(version)
    found = host.ask("simulated_exchange", rows=rows, times=times, names=NAMES, solver=solver)
    assert found["times"] == pytest.approx(times)
    steps = host.ask("trajectory", rows=rows, names=NAMES)["seen"]
    for one, wanted in zip(found["seen"], steps, strict=True):
        assert_same(one, wanted, 1e-6)  # a time that was added up moves the inputs
