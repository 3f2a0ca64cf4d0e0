"""The life cycle of the FMUs: what is refused, when, and what the log has of it.

PythonFMU knows neither fmi2Error nor the GUID, so the Python FMU refuses with the same sentences and other
statuses: fmi2OK, and fmi2Discard for a step.
"""

import pytest

from tests.helpers.cases import poses
from tests.helpers.fmu_misuse import LIFE, TIMES, calls
from tests.helpers.fmus import needs_compiler

OK, WARNING, DISCARD, ERROR = range(4)


def test_calls_in_the_order_of_a_life(hosts, kind):
    """Each call of the list is permitted or refused in every FMU alike: in one line of one sentence, which
    changes nothing.  What is permitted says nothing."""
    seen, rows = hosts(kind).ask("life"), calls(kind, LIFE)
    assert list(seen["answers"]) == list(rows)
    for name, (status, lines) in seen["answers"].items():
        part = rows[name].refused
        if part is None:
            assert (status, lines) == (OK, []), name
            continue
        ((level, category, sentence),) = lines
        assert (level, category) == (ERROR, "logStatusError"), f"{name}: {lines}"
        assert part in sentence and 10 < len(sentence) < 300, f"{name}: {sentence}"
        python = DISCARD if name.startswith("step") else OK
        assert status == (python if kind == "python" else ERROR), f"{name}: {status}"
    assert seen["changed"] == [] and seen["equal"]
    assert seen["end"] == (None if kind == "python" else TIMES[0] + (0.1 + 1e-12))


@needs_compiler
@pytest.mark.parametrize("version", (2, 3))
def test_native_fmus_refuse_with_the_sentences_of_the_python_fmu(hosts, version):
    """FMI 3 has other value references, and says its times as it enters initialisation mode."""
    seen, wanted = hosts(version).ask("life"), hosts("python").ask("life")
    if version == 2:
        lines = {name: lines for name, (_, lines) in wanted["answers"].items()}
        assert lines == {name: seen["answers"][name][1] for name in lines}
    assert seen["after"] == pytest.approx(wanted["after"], abs=1e-12)
    assert seen["after"]["gauge"] == 1.435


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
