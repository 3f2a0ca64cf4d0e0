"""Wrong calls of the native FMUs, one after the other: each is refused in a sentence and changes nothing."""

from tests.helpers.cases import REAL_INPUT_NAMES
from tests.helpers.fmus import needs_compiler
from wrcontact.interface.inputs import INPUTS
from wrcontact.methods.numbers import unit_behind

pytestmark = needs_compiler

ERROR = 3


def assert_refused(answers):
    """Each call ended in an error with one line of one sentence."""
    for name, (status, lines, *_) in answers.items():
        assert status == ERROR and len(lines) == 1, f"{name}: {status}, {lines}"
        assert lines[0][1] == "logStatusError" and 10 < len(lines[0][2]) < 300, f"{name}: {lines}"


NAMED = {
    "Integer as Real": "status",
    "String as Real": "load",
    "output": "roll",
    "half a list": "roll",
    "unknown reference": "4711",
    "fixed Real": "gauge is fixed at 1.435",
    "fixed String": "load is fixed at 'normal'",
    "fixed Boolean": "independent_wheels is fixed at False after initialisation and cannot become True",
    "step of nan": "nan s",
    "step of -1 s": "-1.0 s",
    "long String": "load has 5000 bytes",
    "String without letters": "load is a NULL pointer",
    "too few values": "30 values; these variables have 31",
    "state: freed": "saved state is not one of this instance",
    "state: cut at 64": "holds 64 bytes",
    "state: damaged at 16": "comes from another FMU",
}


def test_every_misuse_is_refused_in_a_sentence_and_changes_nothing(raw):
    version, seen = raw
    answers = seen["bad_input"]["answers"]
    assert_refused(answers)
    assert [name for name, answer in answers.items() if not answer[2]] == []
    for name, part in NAMED.items():
        assert (version == 2 and name == "too few values") or part in answers[name][1][0][2], name
    # the message is a format in FMI 2, and has value references between number signs in both
    signs = "'%%s%%n%%%%d ##7'" if version == 2 else "'%s%n%%d ##7'"
    assert signs in answers["fixed String with signs"][1][0][2]
    assert seen["bad_input"]["good_inputs_after"] and seen["bad_input"]["after_a_reset"]


def test_numbers_that_are_none_in_every_input(raw):
    _, seen = raw
    units = {row.name: unit_behind(row.unit) for row in INPUTS}
    assert units["normal_force"] == " N" and units["left.rail_roll_velocity"] == " rad/s"
    assert len(seen["every_input"]) == 3 * len(REAL_INPUT_NAMES)
    for name, answer in seen["every_input"].items():
        variable, value = name.split()
        assert answer["calls"] == [0, 0] and answer["status"] == 4 and answer["kept"] and answer["again"], (
            name
        )
        assert [line[2].split(";")[0] for line in answer["lines"]] == [
            f"{variable} is {value}{units[variable]}"
        ], answer["lines"]


def test_null_pointers(raw):
    """Every function of the header, without a component, and without each other pointer: an
    error and a sentence."""
    version, seen = raw
    answers = seen["null_pointers"]["answers"]
    state = "FMUstate" if version == 2 else "FMUState"
    assert answers.pop(f"Free{state}, 1") == [0, []]  # the standards have it ignored
    without = {name: answers.pop(name) for name in list(answers) if name.endswith("no component")}
    assert [name for name, answer in without.items() if answer != [ERROR, []]] == []
    assert_refused(answers)
    assert len(without) > (35 if version == 2 else 65) and seen["null_pointers"]["after"]


def test_functions_of_other_kinds_of_fmu_are_refused(raw):
    """Model exchange, events, clocks, other types, derivatives of inputs and outputs, steps
    that are still running."""
    version, seen = raw
    refused = seen["null_pointers"]["refused"]
    assert_refused(refused)
    some = (
        (
            "SetRealInputDerivatives",
            "GetRealOutputDerivatives",
            "CancelStep",
            "GetStatus",
            "SetTime",
            "EnterEventMode",
            "GetDerivatives",
        )
        if version == 2
        else (
            "EnterStepMode",
            "GetBinary",
            "SetClock",
            "GetOutputDerivatives",
            "SetTime",
            "EvaluateDiscreteStates",
            "GetContinuousStates",
            "GetInt64",
        )
    )
    assert set(some) <= set(refused) and len(refused) >= (16 if version == 2 else 45)


def test_sizes_of_steps(raw):
    """tests/fmu/test_life_cycle.py has the order of calls."""
    _, seen = raw
    order = seen["order"]
    assert order["last"] == 1.0 + (0.1 + 1e-12)
    assert order["sizes"] == [0] * len(order["sizes"]) and order["at_the_end"] == [0, 0, [0.0]]
    assert order["after"]


def test_values_ahead_of_a_step_and_states_of_every_phase(raw):
    _, seen = raw
    assert seen["legal"]["ahead"] == seen["legal"]["then"] != [0.0]
    assert [name for name, equal in seen["legal"]["phases"].items() if not equal] == []
    assert len(seen["legal"]["phases"]) == 16


def test_instances_that_cannot_be_made_and_odd_ones_that_can(raw):
    version, seen = raw
    for name, (made, lines) in seen["creation"]["refused"].items():
        assert made is None and len(lines) == 1 and len(lines[0][2]) > 20, f"{name}: {lines}"
    for name, (works, lines) in seen["creation"]["made"].items():
        assert works and len(lines) == 1, name  # with debug logging off too
    if version == 2:
        assert seen["creation"]["made"]["other letters"][1][0][0] == "Radsatz ä 轮对 %s"
    assert seen["creation"]["without_log"] == (version == 3)


def test_log_categories(raw):
    warning, error = "logStatusWarning", "logStatusError"
    _, seen = raw
    found = seen["categories"]
    assert found.pop("first") == [warning, error]
    assert {name: answer[2] for name, answer in found.items()} == {
        "all off": [error],
        "errors off": [],
        "warnings on": [warning],
        "unknown": [warning],
        "errors on, too": [warning, error],
        "warnings off": [error],
        "all on": [warning, error],
    }
    assert {name for name, answer in found.items() if answer[0]} == {"unknown"}
