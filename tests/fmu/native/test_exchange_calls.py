"""Model exchange of the native FMUs, call by call: what is permitted in which mode, and what is refused."""

from tests.helpers.fmu_misuse import MODES, of_exchange
from tests.helpers.fmus import needs_compiler

pytestmark = needs_compiler

OK, ERROR = 0, 3


def test_functions_of_model_exchange_in_every_mode(native_fmu):
    """The table of the standards.  Nothing is wanted after an event or a step, and a list of states has
    none."""
    version, ask = native_fmu
    answers, rows = ask("exchange_modes")["exchange"], of_exchange(version)
    assert len(rows) == 9 + (10 if version == 2 else 12) and len(answers) == 5 * len(rows)
    for name, (_, modes) in rows.items():
        for mode in MODES:
            status, lines = answers[f"{name}, {mode}"]
            words = f"{name}, {mode}: {status}, {lines}"
            assert status == (OK if mode in modes else ERROR), words
            assert [line[1] for line in lines] == ["logStatusError"] * (status == ERROR), words
            assert all(10 < len(line[2]) < 300 for line in lines)
    said = {name: answers[name][1][0][2] for name in answers if answers[name][0]}
    assert said["time nan, event"] == "the time is nan s; permitted are finite times"
    parts = {
        "free_rolling, continuous": "can be changed only in event mode, not in continuous-time mode",
        "step, continuous": "permitted in co-simulation only; this instance is for model exchange",
        "GetContinuousStates of one, event": "asks for 1 continuous states; this model has none",
    }
    assert all(said[name].endswith(part) for name, part in parts.items())
    assert said["completed step, event"].endswith("only in continuous-time mode")


def test_the_same_functions_in_co_simulation(native_fmu):
    """Each is refused in one sentence, except values and steps."""
    _, ask = native_fmu
    for name, (status, lines) in ask("exchange_modes")["steps"].items():
        if name in ("step", "free_rolling", "free_rolling as it is"):
            assert (status, lines) == (OK, [])
        else:
            assert status == ERROR and len(lines) == 1, name
            assert "this instance is for co-simulation" in lines[0][2], name


def test_a_reset_in_model_exchange(native_fmu):
    _, ask = native_fmu
    assert ask("exchange_modes")["again"]


def test_answers_without_a_place(native_fmu):
    version, ask = native_fmu
    seen = ask("exchange_pointers")
    answers = seen["answers"]
    assert len(answers) == (3 if version == 2 else 10)
    for name, (status, lines) in answers.items():
        assert status == ERROR and len(lines) == 1 and "NULL pointer" in lines[0][2], f"{name}: {lines}"
    assert seen["equal"]
