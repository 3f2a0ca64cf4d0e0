"""The life cycle of the FMUs of FMI 2: what is refused, when, and what the log has of it.

PythonFMU knows neither fmi2Error nor the GUID, so the Python FMU refuses with the same sentences and other
statuses: fmi2OK, and fmi2Discard for a step.
"""

import json
import subprocess
import sys

import pytest

from tests.helpers.fmus import needs_compiler, run_scenario
from tests.helpers.paths import HELPERS

OK, WARNING, DISCARD, ERROR = range(4)
STEPS = {"step before", "step inside", "step back", "step nan", "step at infinity", "beyond the stop",
         "step after"}
GOOD = {"good times", "wrong parameter", "right parameter", "enter", "output inside", "leave", "step",
        "last step", "unset", "terminate", "read after", "reset", "enter again", "leave again", "step again"}
#: Part of the sentence.
NAMED = {
    "step before": "has not been initialised", "output before": "roll is an output and cannot be read before",
    "enter refused": "gauge is 14.35;", "start nan": "startTime is nan s", "stop nan": "stopTime nan s",
    "fixed parameter": "gauge is fixed at 1.435", "fixed text": "cannot become 'a ##7 %%s'",
    "half a list": "roll is an output", "unknown reference": "4711 does not exist",
    "step nan": "a step of nan s", "beyond the stop": "ends after the stopTime 1.1 s",
    "step after": "has been terminated", "set after": "yaw cannot be set", "enter twice": "entered once",
}


@pytest.fixture
def native(fmus, tmp_path):
    """Run a scenario of fmu_process.py with the native FMU of FMI 2."""
    return lambda scenario, **arguments: run_scenario(scenario, fmus[2], tmp_path / "native", arguments)


@pytest.fixture
def native3(fmus, tmp_path):
    """Run a scenario of native_process.py with the native FMU of FMI 3."""
    return lambda scenario: run_process("native_process.py", scenario, fmus[3], tmp_path)[0]


def run_process(script, scenario, file, folder):
    """What a scenario has seen, and what it has written on the console."""
    command = [sys.executable, str(HELPERS / script), scenario, str(file), str(folder / "unpacked")]
    done = subprocess.run(command, input="{}", capture_output=True, text=True, encoding="utf-8", timeout=100)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout), done.stderr


def assert_lines(answers):
    """Refused calls have one line each, with status and category; all others have none."""
    assert {name for name, (_, lines) in answers.items() if not lines} == GOOD
    for name in answers.keys() - GOOD:
        (status, category, sentence), = answers[name][1]
        assert (status, category) == (ERROR, "logStatusError"), f"{name}: {answers[name]}"
        assert NAMED.get(name, "") in sentence, name


def test_python_fmu_refuses_without_a_fatal_status(run):
    seen = run("life")
    assert_lines(seen["answers"])
    assert {name for name, (status, _) in seen["answers"].items() if status == DISCARD} == STEPS
    assert all(status == OK for name, (status, _) in seen["answers"].items() if name not in STEPS)
    assert seen["after"]["status"] == seen["after"]["yaw"] == 0 and seen["after"]["gauge"] == 1.435


@needs_compiler
def test_native_fmu_refuses_with_the_sentences_of_the_python_fmu(run, native):
    seen, wanted = native("life"), run("life")
    assert_lines(seen["answers"])
    assert {name for name, (status, _) in seen["answers"].items() if status == OK} == GOOD
    assert all(status in (OK, ERROR) for status, _ in seen["answers"].values())
    assert ({name: lines for name, (_, lines) in seen["answers"].items()}
            == {name: lines for name, (_, lines) in wanted["answers"].items()})
    assert seen["after"] == pytest.approx(wanted["after"], abs=1e-12)


def assert_foreign_stop(answers, status):
    """A state brings its own stopTime."""
    (found, ((_, category, sentence),)) = answers.pop("foreign")
    assert (found, category) == (status, "logStatusError") and "after the stopTime 1.0 s" in sentence
    assert answers == {name: [OK, []] for name in ("before", "up to its stop", "own again")}


def test_a_state_of_the_python_fmu_holds_its_stop_time(run):
    assert_foreign_stop(run("foreign_stop"), DISCARD)


@needs_compiler
def test_a_state_of_the_native_fmu_holds_its_stop_time(native):
    assert_foreign_stop(native("foreign_stop"), ERROR)


@needs_compiler
def test_a_state_of_fmi_3_holds_its_stop_time(native3):
    answers = native3("foreign_stop")
    failed, ((category, sentence),) = answers.pop("foreign")
    assert failed and category == "logStatusError" and "after the stopTime 1.0 s" in sentence
    assert answers == {name: [False, []] for name in ("before", "up to its stop", "own again")}


@needs_compiler
def test_native_refusals_reach_the_log_without_debug_logging(native):
    seen = native("unlogged")
    (status, category, sentence), = seen["parameter"]
    assert (status, category) == (ERROR, "logStatusError") and "gauge is 14.35;" in sentence
    assert seen["status"] == []     # a physical situation is a matter of debug logging
    assert seen["simulated"] == ERROR and "gauge is 14.35;" in seen["printed"]


@needs_compiler
def test_refusals_of_fmi_3_reach_the_log_without_debug_logging(native3):
    seen = native3("unlogged")
    (category, sentence), = seen["parameter"]
    assert category == "logStatusError" and "gauge is 14.35;" in sentence
    assert seen["status"] == [] and "gauge is 14.35;" in seen["printed"]


def test_a_simulation_with_the_python_fmu_ends_after_a_refusal(run):
    """PythonFMU's log is off without debug logging; the result ends at its start, without values."""
    seen = run("unlogged")
    assert seen["parameter"] == seen["status"] == []
    assert {tuple(row[1:]) for row in seen["simulated"]} == {("nan", "4")}
    assert {float(row[0]) for row in seen["simulated"]} == {0.0}


def test_the_console_has_the_sentence(fmu, tmp_path):
    _, console = run_process("fmu_process.py", "unlogged", fmu, tmp_path)
    assert console.count("instance: gauge is 14.35;") == 1, console


def test_a_text_that_is_none_is_no_crash(run):
    assert run("pointers") == {"text": OK}
