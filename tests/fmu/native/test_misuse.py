"""Wrong calls of the native FMUs that only C can make, wrong numbers, and odd instances: each is refused in a sentence
and changes nothing."""

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


def test_every_misuse_of_a_saved_state_is_refused_and_changes_nothing(native_fmu):
    """tests/fmu/test_life_cycle.py has those of all other calls."""
    _, ask = native_fmu
    seen = ask("misused_states")
    assert_refused(seen["answers"])
    for name, part in seen["parts"].items():
        assert part in seen["answers"][name][1][0][2], name
    assert seen["changed"] == [] and seen["equal"] and len(seen["answers"]) > 30


def test_numbers_that_are_none_in_every_input(native_fmu):
    _, ask = native_fmu
    seen, units = ask("every_input"), {row.name: unit_behind(row.unit) for row in INPUTS}
    assert units["normal_force"] == " N" and units["left.rail_roll_velocity"] == " rad/s"
    assert set(seen) == {f"{name} {value}" for name in REAL_INPUT_NAMES for value in ("nan", "inf", "-inf")}
    for name, answer in seen.items():
        variable, value = name.split()
        assert answer["status"] == 4 and answer["kept"] and answer["again"], name
        assert [line[2].split(";")[0] for line in answer["lines"]] == [
            f"{variable} is {value}{units[variable]}"
        ], answer["lines"]


def test_null_pointers(native_fmu):
    """Every function of the header, without an instance, and without each other pointer: an
    error and a sentence."""
    version, ask = native_fmu
    seen = ask("null_pointers")
    state = "FMUstate" if version == 2 else "FMUState"
    assert seen["answers"].pop(f"Free{state}, 1") == [0, []]  # the standards have it ignored
    assert [name for name, status in seen["without"].items() if status != ERROR] == []
    assert_refused(seen["answers"])
    assert len(seen["without"]) > (35 if version == 2 else 65) and seen["equal"]


def test_functions_of_other_kinds_of_fmu_are_refused(native_fmu):
    """Model exchange, events, clocks, other types, derivatives of inputs and outputs, steps
    that are still running."""
    version, ask = native_fmu
    refused = ask("null_pointers")["refused"]
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


def test_values_ahead_of_a_step_and_states_of_every_phase(native_fmu):
    _, ask = native_fmu
    seen = ask("phases")
    assert seen["ahead"] == seen["then"] != {"roll": 0.0}
    assert [name for name, equal in seen["phases"].items() if not equal] == []
    assert len(seen["phases"]) == 16


def test_instances_that_cannot_be_made_and_odd_ones_that_can(native_fmu):
    version, ask = native_fmu
    seen = ask("creation")
    for name, (made, lines) in seen["refused"].items():
        assert made is None and len(lines) == 1 and len(lines[0][2]) > 20, f"{name}: {lines}"
    for name, (works, lines, speaker) in seen["made"].items():
        assert works and len(lines) == 1, name  # with debug logging off too
        assert version == 3 or name != "other letters" or speaker == "Radsatz ä 轮对 %s"
    assert len(seen["made"]) == 9 and seen["without_log"] == (version == 3)


def test_log_categories(native_fmu):
    warning, error = "logStatusWarning", "logStatusError"
    _, ask = native_fmu
    found = ask("log_categories")
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
