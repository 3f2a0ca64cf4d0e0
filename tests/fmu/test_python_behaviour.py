"""The Python FMU's behaviour as an importer sees it, each scenario in a fresh process."""

from pathlib import Path

import pytest

from tests.helpers.cases import (
    INVALID_INPUTS,
    LEFT_SIDE,
    OUTPUT_NAMES,
    WRONG_PARAMETERS,
    moving_track,
    poses,
    pressed_poses,
    profile_file,
)
from tests.helpers.fmus import WARM_START, assert_same, evaluated, run_scenario
from wrcontact import ContactSystem
from wrcontact.fmu import build_fmu

ERROR = 3

# --- behaviour ------------------------------------------------------------------------------------


def test_outcomes_and_recovery(run):
    answers = run("outcomes", cases={name: case for name, (case, *_) in INVALID_INPUTS.items()})
    for name, (case, status, variable, value) in INVALID_INPUTS.items():
        answer = answers[name]
        assert answer["during"].pop("status") == status, name
        before = {key: kept for key, kept in answer["before"].items() if key != "status"}
        assert answer["during"] == before, f"{name}: the last valid outputs are not kept"
        assert len(answer["log"]) == len(answer["again"]) == 1, f"{name}: {answer['log']} {answer['again']}"
        category, sentence = answer["log"][0][1:]
        assert category == "logStatusWarning" and variable in sentence and value in sentence.lower(), sentence
        assert_same(answer["after"], answer["before"], WARM_START)
        assert answer["rest"] == [], name


def test_unloaded_wheel(run):
    answer = run("outcomes", cases={"left": {"load_transfer": 1.0}, "both": {"normal_force": 0.0}})
    left, both = answer["left"]["during"], answer["both"]["during"]
    assert left["status"] == both["status"] == 1
    assert left["left.patch_count"] == both["right.patch_count"] == 0 and left["right.patch_count"] > 0
    assert left["left.area"] == left["left.penetration"] == left["left.normal_force"] == 0.0
    assert left["right.normal_force"] == pytest.approx(2 * 78.5e3)
    # [rad] geometry stays valid
    assert left["roll"] == pytest.approx(answer["left"]["before"]["roll"], abs=1e-9)
    assert len(answer["left"]["log"]) == 1
    assert answer["left"]["after"]["status"] == 0


def test_lazy(run):
    seen = run("laziness")
    assert seen["counts"] == [1, 1, 2, 3]
    assert seen["ahead"] == seen["after"]


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
    assert {category for _, category, _ in seen["log"]} == {"logStatusError"}
    assert len(seen["log"]) == 4
    assert all("saved state" in sentence for *_, sentence in seen["log"])
    assert seen["after"]["status"] == 0


def test_damaged_states_are_refused(run):
    """Flipped bits, cut and longer ones, noise: each with one sentence, and the instance goes on."""
    seen = run("damaged_states", rows=poses(8), seed=5, count=300)
    assert seen["wrong"] == [] and seen["equal"] and seen["count"] > 300


@pytest.mark.slow
def test_numbers_have_a_point_in_a_locale_with_commas(run, comma):
    for scenario, cases in (("outcomes", {"off": {"lateral_shift": 0.0812}}),
                            ("refusals", {"gauge": {"gauge": 14.35}})):
        seen = run("localised", locale_name=comma, inner=scenario, arguments={"cases": cases})
        assert seen["one and a half"] == "1,5" and seen["answer"] == run(scenario, cases=cases)


@pytest.mark.slow
def test_an_instance_goes_on_after_a_fork_and_in_a_spawned_process(run):
    seen = run("forked", rows=poses(8))
    assert seen["parent"] == seen["child"] == seen["spawned"]


def test_reset(run):
    seen = run("reset", start={"gauge": 1.44, "normal_model": "hertz"})
    assert seen["first"] == seen["second"]
    assert seen["values"] == {"gauge": 1.435, "normal_model": "analyn", "lateral_shift": 0.0}
    assert seen["fresh"] == seen["fresh_instance"]


def test_instances_do_not_disturb_each_other(run):
    seen = run("instances", parameters=[{}, {"gauge": 1.44}, {"rail_inclination": 0.05}], rows=poses(15))
    assert seen["together"] == seen["alone"] == seen["parallel"]
    assert seen["together"][0] != seen["together"][1] != seen["together"][2]


def test_two_different_fmus_in_one_process(run, tmp_path):
    other = build_fmu(tmp_path / "other", wheel=profile_file(tmp_path, "wheel"))
    seen = run("neighbours", other=str(other), other_folder=str(tmp_path / "second"))
    assert len([name for name in seen["modules"] if name.startswith("wrcontact_") and "." not in name]) == 2
    assert seen["one"] != seen["two"]
    assert seen["wheels"] == [{"wheel_profile": "S1002"}, {"wheel_profile": "own wheel.txt"}]
    assert_same(seen["one"], evaluated({"lateral_shift": 1e-3}), WARM_START)
    own = ContactSystem(wheel=tmp_path / "own wheel.txt").stepper()
    assert_same(seen["two"], evaluated({"lateral_shift": 1e-3}, own), WARM_START)


def test_path_with_spaces_and_other_letters(fmu, tmp_path):
    """The FMU may lie anywhere; unpacked it may have spaces in its path (PythonFMU
    decodes no other characters)."""
    folder = tmp_path / "Räder & Schienen 轮轨"
    folder.mkdir()
    copy = folder / "my FMU ä.fmu"
    copy.write_bytes(fmu.read_bytes())
    seen = run_scenario("first_instant", copy, tmp_path / "un packed here", {})
    assert_same(seen["default"], evaluated({}), WARM_START)


def test_wrong_parameters_are_refused_in_initialisation(run):
    answers = run("refusals", cases={name: start for name, (start, _) in WRONG_PARAMETERS.items()})
    for name, (_, words) in WRONG_PARAMETERS.items():
        answer = answers[name]
        assert answer["refused"], name
        (status, category, sentence), = answer["log"]
        assert (status, category) == (ERROR, "logStatusError"), name
        assert all(word in sentence for word in words), f"{name}: {sentence}"
        assert answer["after"]["status"] == 0, f"{name}: not usable after a reset"


def test_unpacked_again_after_its_folder_was_removed(run, fmu, tmp_path):
    seen = run("vanished_folder", again=str(fmu), elsewhere=str(tmp_path / "again"))
    assert seen["status"] == 0


def test_memory_stays_flat(run, entries):
    compiled = any(Path(name).suffix in (".so", ".dll", ".dylib") for name in entries
                   if name.startswith("resources/"))
    grown = run("endurance", steps=100_000 if compiled else 2_000)
    assert grown["resident"] < 2e6, grown  # [bytes]
    # objects of Python; one lost per saved state would be 1000, per step 100 000
    assert grown["blocks"] < 800, grown
