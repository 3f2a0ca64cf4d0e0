"""The native FMUs' behaviour as an importer sees it, each scenario in a fresh process."""

import json
import math
import shutil
import subprocess
import sys

import pytest

from tests.helpers.cases import (
    INPUT_NAMES,
    INVALID_INPUTS,
    LEFT_SIDE,
    OUTPUT_NAMES,
    WRONG_PARAMETERS,
    moving_track,
    poses,
    pressed_poses,
)
from tests.helpers.fmus import assert_same, needs_compiler, session, stepped
from tests.helpers.paths import HELPERS
from wrcontact.interface.variables import REFERENCE, VARIABLES
from wrcontact.simulation.session import Refused

pytestmark = needs_compiler

SITUATIONS = {
    **{name: case for name, (case, *_) in INVALID_INPUTS.items()},
    "far yaw": {"yaw": 0.3}, "end of the profile": {"lateral_shift": 0.0149, "yaw": 0.11},
    "minus infinity": {"normal_force": -math.inf}, "no load": {"normal_force": 0.0},
    "left lifted": {"load_transfer": 1.0},
}


@pytest.mark.parametrize("mode", ["rigid", "compliant"])
def test_outcomes_and_sentences_are_those_of_the_python_fmu(run3, mode):
    """The same status, kept values, and sentence, in every situation."""
    situations = dict(SITUATIONS)
    if mode == "compliant":
        situations |= {"lifted": {"vertical_shift_input": -0.01}, "deep": {"vertical_shift_input": 0.05},
                       "far roll": {"roll_input": 0.6}, "pressed": {"vertical_shift_input": 2e-4}}
    answers = run3("situations", start={"contact_mode": mode}, cases=situations)
    lines = []
    made = session(lines, contact_mode=mode)
    valid = dict(zip(INPUT_NAMES, (v.start for v in VARIABLES)))
    for name, case in situations.items():
        stepped(made, valid)
        lines.clear()
        wanted = stepped(made, case)
        assert_same(answers[name]["seen"], wanted)
        assert answers[name]["log"] == [["logStatusWarning", line] for line in lines], name


def test_outcomes_and_recovery(run):
    answers = run("outcomes", cases={name: case for name, (case, *_) in INVALID_INPUTS.items()})
    for name, (_, status, variable, value) in INVALID_INPUTS.items():
        answer = answers[name]
        assert answer["during"].pop("status") == status, name
        assert (answer["during"]
                == {key: kept for key, kept in answer["before"].items() if key != "status"}), name
        assert len(answer["log"]) == len(answer["again"]) == 1 and answer["rest"] == [], name
        category, sentence = answer["log"][0][1:]
        assert category == "logStatusWarning" and variable in sentence and value in sentence.lower(), sentence


REFUSED = {
    **{name: start for name, (start, _) in WRONG_PARAMETERS.items()},
    "other kind": {"rail_profile": "S1002"}, "quote": {"load": "it's"}, "tolerance": {"tolerance": 2e-4},
    "tolerance of a model": {"tolerance": 0.003, "normal_model": "analyn_strip"},
    "infinite": {"youngs_modulus": math.inf}, "offline": {"normal_model": "halfspace"},
    "tiny": {"rail_inclination": 1e-5 - 1e-3},
}


def test_wrong_parameters_are_refused_with_the_sentences_of_the_python_fmu(run, run3):
    answers = {2: run("refusals", cases=REFUSED), 3: run3("refusals", cases=REFUSED)}
    for name, start in REFUSED.items():
        with pytest.raises(Refused) as wrong:
            session(**start)
        wanted = str(wrong.value).split(", the path of a profile file")[0]
        for version, answer in ((v, a[name]) for v, a in answers.items()):
            assert answer["refused"] and answer["after"]["status"] == 0, (version, name)
            sentences = [line[-1] for line in answer["log"]]
            assert sentences == [wanted], (version, name)


@pytest.mark.parametrize("moving", [False, True], ids=["alike and still", "different sides and moving rails"])
@pytest.mark.parametrize("mode", ["rigid", "elastic", "compliant"])
def test_saved_states(run, mode, moving):
    rows, start = pressed_poses(20) if mode == "compliant" else poses(20), {"contact_mode": mode}
    if moving:
        rows = moving_track(20, mode == "compliant")
        start |= {**LEFT_SIDE, "contact_damping": 0.2}
    seen = run("saved_states", rows=rows, names=OUTPUT_NAMES, start=start)
    assert {one["status"] for one in seen["straight"]} == {0}
    assert seen["restored"] == seen["before"]
    assert seen["straight"] == seen["back"] == seen["elsewhere"]
    assert seen["refusals"] == [True] * 4 and seen["kept"]
    assert len(seen["log"]) == 4 and all("saved state" in sentence for *_, sentence in seen["log"])
    assert seen["after"]["status"] == 0


def test_saved_states_at_unchanged_inputs(run3):
    """Going back to inputs that were known when the state was saved gives the same bits, and
    so does another way there."""
    seen = run3("state_again", rows=poses(30))
    assert seen["straight"] == seen["back"] == seen["elsewhere"]


def test_damaged_states_are_refused(run, run3):
    """Flipped bits, cut and longer ones, noise, those of the other FMU: each with one sentence, and
    the instance goes on."""
    seen = run("damaged_states", rows=poses(8), seed=5, count=300)
    other = run3("damaged_states", rows=poses(8), seed=6, count=300, foreign=[seen["saved"]])
    for answer in (seen, other,
                   run("damaged_states", rows=poses(8), seed=7, count=0, foreign=[other["saved"]])):
        assert answer["wrong"] == [] and answer["equal"] and answer["count"] > 30


def test_numbers_have_a_point_in_a_locale_with_commas(run, comma):
    """In statuses and in refusals, short numbers and long ones; the host prints with a comma."""
    cases = {"status": {"lateral_shift": 0.0812}, "small": {"normal_force": -1.25e-7},
             "large": {"lateral_shift": -1.5e300}, "transfer": {"load_transfer": 1.5}}
    wrong = {"gauge": {"gauge": 14.35}, "long": {"gauge": 0.12345678901234567},
             "tolerance": {"tolerance": 2.5e-4}, "large": {"youngs_modulus": 2.5e25}}
    for scenario, some in (("outcomes", cases), ("refusals", wrong)):
        seen = run("localised", locale_name=comma, inner=scenario, arguments={"cases": some})
        assert seen["one and a half"] == "1,5" and seen["answer"] == run(scenario, cases=some)
        assert all("." in answer["log"][0][-1] for answer in seen["answer"].values())


def test_an_instance_goes_on_after_a_fork_and_in_a_spawned_process(run):
    seen = run("forked", rows=poses(8))
    assert seen["parent"] == seen["child"] == seen["spawned"]


def test_reset(run):
    start = {"rail_inclination": 0.05, "normal_model": "hertz"}
    seen = run("reset", start=start)
    assert seen["first"] == seen["second"] and seen["fresh"] == seen["fresh_instance"]
    assert seen["values"] == {**{name: VARIABLES[REFERENCE[name]].start for name in start},
                              "lateral_shift": 0.0}


def test_instances_in_turn_and_in_threads(run):
    parameters = [{}, {"normal_model": "hertz"}, {"rail_profile": "54E1"}, {"nominal_radius": 0.5}]
    seen = run("instances", parameters=parameters, rows=poses(20))
    assert seen["together"] == seen["alone"] == seen["parallel"]


def test_misuse_ends_in_an_error_with_a_sentence(run3):
    seen = run3("misuse")
    for name, (refused, lines) in seen["calls"].items():
        assert refused, name
        assert len(lines) == 1 and lines[0][0] == "logStatusError" and len(lines[0][1]) > 20, (
            f"{name}: {lines}")
    assert seen["after"]["status"] == 0
    assert seen["not_made"] == {name: 1 for name in seen["not_made"]}, seen["not_made"]


def test_misuse_of_fmi_2(run):
    names = ("fixed parameter", "output", "integer output", "unknown reference", "wrong type")
    answers = run("illegal", cases=list(names))
    for name in names:
        refused, lines = answers["calls"][name]
        assert refused and len(lines) == 1 and lines[0][1] == "logStatusError", f"{name}: {lines}"
    assert answers["unready"][0] and "has not been initialised" in answers["unready"][1][0][2]
    assert answers["after"]["status"] == 0


@pytest.mark.slow
def test_memory_stays_flat(run):
    assert run("endurance", steps=100_000)["resident"] < 2e6  # [bytes]


def test_path_with_spaces_and_other_letters(fmus, tmp_path):
    folder = tmp_path / "Räder & Schienen 轮轨"
    folder.mkdir()
    for version, script in ((2, "fmu_process.py"), (3, "native_process.py")):
        copy = shutil.copy(fmus[version], folder / f"my FMU ä {version}.fmu")
        done = subprocess.run([sys.executable, str(HELPERS / script), "first_instant", str(copy),
                               str(folder / f"entpackt ü {version}")],
                              input="{}", capture_output=True, text=True, encoding="utf-8", cwd=folder)
        assert done.returncode == 0, done.stderr
        assert_same(json.loads(done.stdout)["default"], stepped(session(), {}))
