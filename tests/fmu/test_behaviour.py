"""What an importer sees of the three FMUs: outcomes, refusals, saved states, instances, where they lie."""

import math
import shutil
from pathlib import Path

import pytest

from tests.helpers.cases import (
    INVALID_INPUTS,
    LEFT_SIDE,
    REAL_INPUT_NAMES,
    WRONG_PARAMETERS,
    moving_track,
    poses,
    pressed_poses,
    profile_file,
)
from tests.helpers.fmus import (
    KINDS,
    WARM_START,
    assert_same,
    has_compiler,
    run_process,
    run_scenario,
    session,
    stepped,
)
from wrcontact.interface.variables import VARIABLES
from wrcontact.simulation.session import Refused

WARNING, ERROR = 1, 3
START = {v.name: v.start for v in VARIABLES}
ONLY_PYTHON = pytest.mark.parametrize("kind", ["python"])

# --- outcomes -------------------------------------------------------------------------------------

#: Inputs, and words of the sentence on them.
SITUATIONS = {
    **{name: (case, [variable, value]) for name, (case, _, variable, value) in INVALID_INPUTS.items()},
    "far yaw": ({"yaw": 0.3}, ["yaw"]),
    "end of the profile": ({"lateral_shift": 0.0149, "yaw": 0.11}, []),
    "minus infinity": ({"normal_force": -math.inf}, ["-inf"]),
    "no load": ({"normal_force": 0.0}, []),
    "left lifted": ({"load_transfer": 1.0}, []),
}
PRESSED = {
    "lifted": ({"vertical_shift_input": -1e-3}, ["vertical_shift_input is -0.001 m", "lifted"]),
    "far": ({"vertical_shift_input": -0.01}, ["-0.01 m"]),
    "deep": ({"vertical_shift_input": 5e-3}, ["vertical_shift_input is 0.005 m", "0.002 m"]),
    "deeper": ({"vertical_shift_input": 0.05}, ["0.05 m"]),
    "steep": ({"roll_input": 0.3}, ["roll_input is 0.3 rad", "0.12 rad"]),
    "far roll": ({"roll_input": 0.6}, ["0.6 rad"]),
    "no roll": ({"roll_input": math.nan}, ["roll_input is nan rad"]),
}


@pytest.fixture(params=["rigid", "compliant"])
def outcomes(request, run):
    """Mode, every situation between two valid steps, and what the package's session makes of the same:
    outputs and sentences."""
    mode, start = request.param, {"contact_mode": request.param}
    valid = {name: START[name] for name in REAL_INPUT_NAMES} | {"lateral_shift": 1e-3}
    situations = dict(SITUATIONS)
    if mode == "compliant":
        situations |= PRESSED
        valid["vertical_shift_input"] = 0.25e-3
    answers = run(
        "outcomes", cases={name: case for name, (case, _) in situations.items()}, valid=valid, start=start
    )
    lines, wanted = [], {}
    made = session(lines, **start)
    for name, (case, _) in situations.items():
        stepped(made, valid)
        lines.clear()
        wanted[name] = stepped(made, case), list(lines)
        made.step()
    return mode, situations, answers, wanted


def test_outcomes_and_sentences_are_those_of_the_package(outcomes):
    """One sentence for each step with a status; the last valid outputs are kept, and a valid step follows."""
    mode, situations, answers, wanted = outcomes
    for name, (_, words) in situations.items():
        answer, (outputs, lines) = answers[name], wanted[name]
        assert_same(answer["during"], outputs)
        assert answer["log"] == [[WARNING, "logStatusWarning", line] for line in lines], name
        assert all(word in " ".join(lines).lower() for word in words), lines
        assert len(lines) == len(answer["again"]) == (outputs["status"] != 0) and answer["rest"] == [], name
        assert answer["before"]["status"] == answer["after"]["status"] == 0, name
        assert_same(answer["after"], answer["before"], WARM_START)
        if answer["during"]["status"] > 1:  # of compliant contact the equilibrium is another pose's
            changed = {of for of, value in answer["before"].items() if value != answer["during"][of]}
            equilibrium = {"equilibrium.vertical_shift", "equilibrium.roll"} if mode == "compliant" else set()
            assert {"status"} <= changed <= {"status"} | equilibrium, f"{name}: outputs are not kept"


def test_statuses_and_empty_patches(outcomes):
    mode, situations, answers, _ = outcomes
    for name, (_, status, *_) in INVALID_INPUTS.items():
        assert answers[name]["during"]["status"] == status, name
    if mode == "rigid":
        left, both = answers["left lifted"]["during"], answers["no load"]["during"]
        assert left["status"] == both["status"] == 1
        assert left["left.patch_count"] == both["right.patch_count"] == 0 < left["right.patch_count"]
        assert left["left.area"] == left["left.penetration"] == left["left.normal_force"] == 0.0
        assert left["right.normal_force"] == pytest.approx(2 * 78.5e3)
        # [rad] geometry stays valid
        assert left["roll"] == pytest.approx(answers["left lifted"]["before"]["roll"], abs=1e-9)
        return
    assert {name: answers[name]["during"]["status"] for name in PRESSED} == {
        "lifted": 1,
        "far": 1,
        "deep": 2,
        "deeper": 2,
        "steep": 2,
        "far roll": 2,
        "no roll": 4,
    }
    lifted = answers["lifted"]["during"]
    assert lifted["left.normal_force"] == lifted["right.area"] == lifted["force.z"] == 0.0
    assert lifted["vertical_shift"] == -1e-3


def test_an_unusual_load_is_logged_once_and_with_the_sentence_of_the_package(run):
    """78.5 for 78.5 kN, and 78.5e6; a load of zero lifts a wheel."""
    valid = {name: START[name] for name in REAL_INPUT_NAMES}
    cases = {"usual": {"normal_force": 78.5e3}, "kN": {"normal_force": 78.5}, "again": {"normal_force": 78.0}}
    lines, answers = [], run("outcomes", cases=cases, valid=valid)
    made = session(lines)
    stepped(made, {**valid, **cases["kN"]})
    assert len(lines) == 1 and "normal_force is 78.5 N; usual is 500 ... 1e+06 N" in lines[0]
    assert [answers[name]["log"] for name in cases] == [[], [[WARNING, "logStatusWarning", lines[0]]], []]
    pressed = run(
        "outcomes",
        cases=cases,
        valid={**valid, "vertical_shift_input": 0.25e-3},
        start={"contact_mode": "compliant"},
    )
    assert all(answer["log"] == [] for answer in pressed.values())


REFUSED = {
    **{name: start for name, (start, _) in WRONG_PARAMETERS.items()},
    "other kind": {"rail_profile": "S1002"},
    "quote": {"load": "it's"},
    "tolerance": {"tolerance": 2e-4},
    "tolerance of a model": {"tolerance": 0.003, "normal_model": "analyn_strip"},
    "infinite": {"youngs_modulus": math.inf},
    "offline": {"normal_model": "halfspace"},
    "tiny": {"rail_inclination": 1e-5 - 1e-3},
}


#: What Python says for most of the catalogue.
PROFILES = ", the other names of `wrcontact profiles`"


def test_wrong_parameters_are_refused_with_the_sentences_of_the_package(run, kind):
    answers = run("refusals", cases=REFUSED)
    for name, start in REFUSED.items():
        with pytest.raises(Refused) as wrong:
            session(**start)
        sentence = str(wrong.value)
        wanted = sentence if kind == "python" else sentence.split(", or the name of a profile file")[0]
        answer = answers[name]
        ((level, kind_of_line, told),) = answer["log"]
        assert answer["refused"] and (level, kind_of_line) == (ERROR, "logStatusError"), name
        if kind != "python" and PROFILES in wanted:  # a native FMU names them all
            wanted = wanted.partition(PROFILES)[0]
            (said, known), (head, named) = (text.split("permitted are ") for text in (told, wanted))
            assert said == head and set(named.split(", ")) < set(known.split(", ")), name
        else:
            assert told == wanted, name
        assert all(word in wanted for word in WRONG_PARAMETERS.get(name, ((), ()))[1]), wanted
        assert answer["after"]["status"] == 0, f"{name}: not usable after a reset"


def test_the_fmus_read_no_file_of_the_host(run, kind, tmp_path):
    """A profile that Python would read is no choice of an FMU, by any path to it."""
    file = profile_file(tmp_path, "wheel")
    names = {"root": str(file), "upwards": "/".join([*[".."] * 40, *file.parts[1:]])}
    answers = run("refusals", cases={way: {"wheel_profile": name} for way, name in names.items()})
    for way, answer in answers.items():
        ((_, _, sentence),) = answer["log"]
        told = "has" if kind != "python" and len(names[way]) > 255 else "is"
        assert answer["refused"] and sentence.startswith(f"wheel_profile {told} "), way
        assert answer["after"]["status"] == 0, way


def test_numbers_have_a_point_in_a_locale_with_commas(run, run_alone, comma):
    """In statuses and in refusals, short numbers and long ones; the host prints with a comma."""
    cases = {
        "status": {"lateral_shift": 0.0812},
        "small": {"normal_force": -1.25e-7},
        "large": {"lateral_shift": -1.5e300},
        "transfer": {"load_transfer": 1.5},
    }
    wrong = {
        "gauge": {"gauge": 14.35},
        "long": {"gauge": 0.12345678901234567},
        "tolerance": {"tolerance": 2.5e-4},
        "large": {"youngs_modulus": 2.5e25},
    }
    valid = {name: START[name] for name in REAL_INPUT_NAMES}
    for scenario, given in (("outcomes", {"cases": cases, "valid": valid}), ("refusals", {"cases": wrong})):
        seen = run_alone("localised", locale_name=comma, inner=scenario, arguments=given)
        assert seen["one and a half"] == "1,5" and seen["answer"] == run(scenario, **given)
        assert all("." in answer["log"][0][-1] for answer in seen["answer"].values())


# --- saved states -----------------------------------------------------------------------------------


@pytest.mark.parametrize("moving", [False, True], ids=["alike and still", "different sides and moving rails"])
@pytest.mark.parametrize("mode", ["rigid", "elastic", "compliant"])
def test_saved_states(run, mode, moving):
    rows, start = pressed_poses(20) if mode == "compliant" else poses(20), {"contact_mode": mode}
    if moving:
        rows = moving_track(20, mode == "compliant")
        start |= {**LEFT_SIDE, "contact_damping": 0.2}
    seen = run("saved_states", rows=rows, start=start)
    assert {one["status"] for one in seen["straight"]} == {0}
    assert seen["restored"] == seen["before"]
    assert seen["straight"] == seen["back"] == seen["elsewhere"]
    assert seen["refusals"] == [True] * 4 and seen["kept"] and len(seen["log"]) == 4
    for status, category, sentence in seen["log"]:
        assert (status, category) == (ERROR, "logStatusError") and "saved state" in sentence
    assert seen["after"]["status"] == 0


def test_saved_states_at_unchanged_inputs(run):
    """Going back to inputs that were known when the state was saved gives the same bits, and
    so does another way there."""
    rows = [row for row in poses(15) for _ in range(2)]
    seen = run("saved_states", rows=rows, start={}, taken=11)
    assert seen["straight"] == seen["back"] == seen["elsewhere"]


def test_damaged_states_are_refused(hosts, run_alone, kind):
    """Flipped bits, cut and longer ones, noise, those of the other FMUs: each with one sentence, and
    the instance goes on."""
    others = {"python", 2, 3} - {kind} if has_compiler() else ()
    foreign = [hosts(other).ask("saved", rows=poses(3)) for other in others]
    seen = run_alone("damaged_states", rows=poses(8), seed=5, count=300, foreign=foreign)
    assert seen["wrong"] == [] and seen["equal"] and seen["count"] > 300


# --- instances and processes ------------------------------------------------------------------------


def test_an_instance_goes_on_after_a_fork_and_in_a_spawned_process(run_alone):
    seen = run_alone("forked", rows=poses(8))
    assert seen["parent"] == seen["child"] == seen["spawned"]


def test_reset(run):
    start = {"rail_inclination": 0.05, "gauge": 1.44, "normal_model": "hertz"}
    seen = run("reset", start=start)
    assert seen["first"] == seen["second"] and seen["fresh"] == seen["fresh_instance"]
    assert seen["values"] == {**{name: START[name] for name in start}, "lateral_shift": 0.0}


def test_instances_in_turn_and_in_threads(run):
    parameters = [
        {},
        {"normal_model": "hertz"},
        {"rail_profile": "54E1", "gauge": 1.44},
        {"nominal_radius": 0.5, "rail_inclination": 0.05},
    ]
    seen = run("instances", parameters=parameters, rows=poses(20))
    assert seen["together"] == seen["alone"] == seen["parallel"]
    assert all(one != other for one, other in zip(seen["together"], seen["together"][1:]))


@pytest.mark.parametrize("kind", KINDS[:2])
@pytest.mark.turns(2)
def test_memory_stays_flat(run_alone, kind, entries):
    compiled = any(
        Path(name).suffix in (".so", ".dll", ".dylib") for name in entries if name.startswith("resources/")
    )
    grown = run_alone("endurance", steps=100_000 if compiled or kind == 2 else 2_000)
    assert grown["resident"] < 2e6, grown  # [bytes]
    # objects of Python; one lost per saved state would be 1000, per step 100 000
    assert kind == 2 or grown["blocks"] < 800, grown


def test_path_with_spaces_and_other_letters(archive_of, kind, tmp_path):
    """The FMU may lie anywhere, and be unpacked anywhere."""
    folder = tmp_path / "Räder & Schienen 轮轨"
    folder.mkdir()
    copy = shutil.copy(archive_of(kind), folder / "my FMU ä.fmu")
    assert_same(
        run_scenario("first_instant", copy, folder / "entpackt ü", {})["default"], stepped(session(), {})
    )


# --- the Python FMU alone ---------------------------------------------------------------------------


@ONLY_PYTHON
def test_lazy(run_alone):
    seen = run_alone("laziness")
    assert seen["counts"] == [1, 1, 2, 3]
    assert seen["ahead"] == seen["after"]


@ONLY_PYTHON
def test_runs_its_own_code(run_alone, tmp_path):
    modules = run_alone("modules")
    assert "wrcontact" not in modules and len(modules) > 20
    assert all(Path(file).is_relative_to(tmp_path / "unpacked" / "resources") for file in modules.values()), (
        modules
    )


@ONLY_PYTHON
def test_unpacked_again_after_its_folder_was_removed(run_alone, fmu, tmp_path):
    seen = run_alone("vanished_folder", again=str(fmu), elsewhere=str(tmp_path / "again"))
    assert seen["status"] == 0


def test_the_console_has_the_sentence(fmu, tmp_path):
    _, console = run_process("unlogged", fmu, tmp_path / "unpacked", {})
    assert console.count("instance: gauge is 14.35;") == 1, console
