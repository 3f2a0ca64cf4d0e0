"""Model exchange of the native FMUs, call by call: what is permitted in which mode, and what is refused."""

from tests.helpers.fmus import needs_compiler

pytestmark = needs_compiler

OK, ERROR = 0, 3
MODES = "new", "initialising", "event", "continuous", "terminated"
#: In which modes a call is permitted; lists of none in all.
PERMITTED = {
    "enter event mode": {"event", "continuous"},
    "end event": {"event"},
    "enter continuous-time mode": {"event"},
    "completed step": {"continuous"},
    "time": {"event", "continuous"},
    "time nan": set(),
    "step": set(),
    "free_rolling": {"new", "initialising", "event"},
    "free_rolling as it is": {"new", "initialising", "event", "continuous"},
}


def test_functions_of_model_exchange_in_every_mode(raw):
    """The table of the standards.  Nothing is wanted after an event or a step, and a list of states has
    none."""
    version, seen = raw
    answers = seen["exchange_modes"]["exchange"]
    lists = {name.split(",")[0] for name in answers} - set(PERMITTED)
    assert len(lists) == (10 if version == 2 else 12)
    wanted = PERMITTED | {name: set() if name.endswith("of one") else set(MODES) for name in lists}
    for name, modes in wanted.items():
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


def test_the_same_functions_in_co_simulation(raw):
    """Each is refused in one sentence, except values and steps."""
    _, seen = raw
    for name, (status, lines) in seen["exchange_modes"]["steps"].items():
        if name in ("step", "free_rolling", "free_rolling as it is"):
            assert (status, lines) == (OK, [])
        else:
            assert status == ERROR and len(lines) == 1, name
            assert "this instance is for co-simulation" in lines[0][2], name


def test_a_reset_in_model_exchange(raw):
    _, seen = raw
    assert seen["exchange_modes"]["reset"] and seen["exchange_modes"]["again"]


def test_answers_without_a_place(raw):
    version, seen = raw
    answers = seen["exchange_pointers"]["answers"]
    assert len(answers) == (3 if version == 2 else 10)
    for name, (status, lines) in answers.items():
        assert status == ERROR and len(lines) == 1 and "NULL pointer" in lines[0][2], f"{name}: {lines}"
    assert seen["exchange_pointers"]["after"]
