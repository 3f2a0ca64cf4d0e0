"""The life cycle of the FMUs: what is refused, when, and what the log has of it.

PythonFMU knows neither fmi2Error nor the GUID, so the Python FMU refuses with the same sentences and other
statuses: fmi2OK, and fmi2Discard for a step.
"""

import pytest

from tests.helpers.cases import poses
from tests.helpers.fmus import needs_compiler

OK, WARNING, DISCARD, ERROR = range(4)
STEPS = {
    "step before",
    "step inside",
    "step back",
    "step nan",
    "step at infinity",
    "beyond the stop",
    "step after",
}
GOOD = {
    "good times",
    "wrong parameter",
    "right parameter",
    "enter",
    "output inside",
    "leave",
    "step",
    "last step",
    "unset",
    "terminate",
    "read after",
    "reset",
    "enter again",
    "leave again",
    "step again",
}
#: Part of the sentence.
NAMED = {
    "step before": "has not been initialised",
    "output before": "roll is an output and cannot be read before",
    "enter refused": "gauge is 14.35;",
    "start nan": "startTime is nan s",
    "stop nan": "stopTime nan s",
    "fixed parameter": "gauge is fixed at 1.435",
    "fixed text": "cannot become 'a ##7 %",
    "half a list": "roll is an output",
    "unknown reference": "4711 does not exist",
    "step nan": "a step of nan s",
    "beyond the stop": "ends after the stopTime 1.1 s",
    "step after": "has been terminated",
    "set after": "yaw cannot be set",
    "enter twice": " once, ",
}


def assert_lines(answers):
    """Refused calls have one line each, with status and category; all others have none."""
    assert {name for name, (_, lines) in answers.items() if not lines} == GOOD & set(answers)
    for name in answers.keys() - GOOD:
        ((status, category, sentence),) = answers[name][1]
        assert (status, category) == (ERROR, "logStatusError"), f"{name}: {answers[name]}"
        assert NAMED.get(name, "") in sentence, name


def test_python_fmu_refuses_without_a_fatal_status(hosts):
    seen = hosts("python").ask("life")
    assert_lines(seen["answers"])
    assert {name for name, (status, _) in seen["answers"].items() if status == DISCARD} == STEPS
    assert all(status == OK for name, (status, _) in seen["answers"].items() if name not in STEPS)
    assert seen["after"]["status"] == seen["after"]["yaw"] == 0 and seen["after"]["gauge"] == 1.435


@needs_compiler
@pytest.mark.parametrize("version", (2, 3))
def test_native_fmu_refuses_with_the_sentences_of_the_python_fmu(hosts, version):
    """FMI 3 has other value references, and says its times as it enters initialisation mode."""
    seen, wanted = hosts(version).ask("life"), hosts("python").ask("life")
    assert_lines(seen["answers"])
    assert all(status == (OK if name in GOOD else ERROR) for name, (status, _) in seen["answers"].items())
    if version == 2:
        assert {name: lines for name, (_, lines) in seen["answers"].items()} == {
            name: lines for name, (_, lines) in wanted["answers"].items()
        }
    assert seen["after"] == pytest.approx(wanted["after"], abs=1e-12)


def test_a_step_may_begin_at_any_time(run, kind):
    """Times that go back, leap or stand still: the model keeps nothing of them, so that the outputs are those
    of steps that follow each other, to the bit, and no call is refused."""
    seen = run("jumping_times", rows=poses(7))
    assert seen["answers"] == [[OK, []]] * 7 and seen["jumping"] == seen["straight"]
    assert len({one["right.area"] for one in seen["jumping"]}) == 7
    assert len(seen["times"]) == (7 if kind == 3 else 0)
    assert all(end == time == last for end, time, last in seen["times"])


def test_a_state_holds_its_stop_time(run, kind):
    answers = run("foreign_stop")
    (found, ((_, category, sentence),)) = answers.pop("foreign")
    assert (found, category) == (DISCARD if kind == "python" else ERROR, "logStatusError")
    assert "after the stopTime 1.0 s" in sentence
    assert answers == {name: [OK, []] for name in ("before", "up to its stop", "own again")}


def test_refusals_reach_the_log_without_debug_logging(run, kind):
    """But those of the Python FMU: PythonFMU's log is off then. Its simulations end at their start, without
    values."""
    seen = run("unlogged")
    assert seen["status"] == []  # a physical situation is a matter of debug logging
    if kind == "python":
        assert seen["parameter"] == []
        assert {tuple(row[1:]) for row in seen["simulated"]} == {("nan", "4")}
        assert {float(row[0]) for row in seen["simulated"]} == {0.0}
        return
    ((status, category, sentence),) = seen["parameter"]
    assert (status, category) == (ERROR, "logStatusError") and "gauge is 14.35;" in sentence
    assert seen["simulated"] == ERROR and "gauge is 14.35;" in seen["printed"]


def test_a_text_that_is_none_is_no_crash(hosts):
    assert hosts("python").ask("pointers") == {"text": OK}
