"""The Python FMU's outputs are those of the package, for all methods."""

import math
from pathlib import Path

import pytest

from tests.helpers.cases import OUTPUT_NAMES, poses, pressed_poses
from tests.helpers.fmus import WARM_START, assert_same, evaluated
from wrcontact import ContactSystem


def test_first_instant(run):
    start = {"lateral_shift": 2e-3, "yaw": 1e-3}
    seen = run("first_instant", start=start)
    assert_same(seen["default"], evaluated({}), WARM_START)
    assert_same(seen["after_initialisation"], evaluated(start), WARM_START)
    assert seen["in_initialisation"] == seen["after_initialisation"]


def test_methods_and_their_parameters_arrive(run):
    """The tables that they need are prepared inside the FMU."""
    chosen = {"separation": "equidistant", "lateral_curvature": "rough", "curvature_step": 1e-3,
              "curvature_reach": 2e-3}
    start = {"lateral_shift": 2e-3, "yaw": 1e-3}
    for more in ({}, {"lateral_curvature": "smooth"}):
        parameters = {**chosen, **more}
        seen = run("first_instant", start={**start, **parameters})
        assert_same(seen["after_initialisation"], evaluated(start, ContactSystem(**parameters).stepper()),
                    WARM_START)
        assert seen["after_initialisation"]["right.area"] != seen["default"]["right.area"]


def test_contact_modes_arrive(run):
    """Elastic: height and roll follow the load; compliant: they are inputs, and the loads follow."""
    start = {"lateral_shift": 3e-3, "yaw": 1e-3, "contact_mode": "elastic", "load": "vertical"}
    elastic = run("first_instant", start=start)["after_initialisation"]
    assert_same(elastic, evaluated(start, ContactSystem(contact_mode="elastic", load="vertical").stepper()),
                WARM_START)
    assert elastic["status"] == 0 and elastic["force.z"] == pytest.approx(-2 * 78.5e3, rel=1e-6)
    given = {"vertical_shift_input": elastic["vertical_shift"], "roll_input": elastic["roll"]}
    start = {**start, **given, "contact_mode": "compliant", "normal_force": 1.0}
    compliant = run("first_instant", start=start)["after_initialisation"]
    assert_same(compliant, evaluated(start, ContactSystem(contact_mode="compliant").stepper()), WARM_START)
    for name in ("left.normal_force", "right.normal_force", "right.area", "force.y", "moment.x"):
        assert compliant[name] == pytest.approx(elastic[name], rel=1e-5), name


@pytest.mark.parametrize("mode", ["elastic", "compliant"])
def test_contact_modes_step_as_the_kernel(run, mode):
    rows = pressed_poses(12) if mode == "compliant" else poses(12)
    seen = run("trajectory", rows=rows, names=OUTPUT_NAMES, start={"contact_mode": mode})["seen"]
    stepper = ContactSystem(contact_mode=mode).stepper()
    for row, found in zip(rows, seen):
        assert_same(found, evaluated(row, stepper), WARM_START)
        assert found["status"] == 0


def test_a_lifted_wheelset_is_a_status_with_a_sentence(run):
    """And a height that no wheelset can have; both with the next valid height forgotten."""
    cases = {"lifted": {"vertical_shift_input": -1e-3}, "deep": {"vertical_shift_input": 5e-3},
             "steep": {"roll_input": 0.3}, "nan": {"roll_input": math.nan}}
    answers = run("outcomes", cases=cases, start={"contact_mode": "compliant"},
                  valid={"vertical_shift_input": 0.25e-3})
    assert {name: answer["during"]["status"] for name, answer in answers.items()} == {
        "lifted": 1, "deep": 2, "steep": 2, "nan": 4}
    lifted = answers["lifted"]["during"]
    assert lifted["left.normal_force"] == lifted["right.area"] == lifted["force.z"] == 0.0
    assert lifted["vertical_shift"] == -1e-3
    words = {"lifted": ["vertical_shift_input is -0.001 m", "lifted"],
             "deep": ["vertical_shift_input is 0.005 m", "0.002 m"],
             "steep": ["roll_input is 0.3 rad", "0.12 rad"], "nan": ["roll_input is nan rad"]}
    for name, answer in answers.items():
        assert answer["before"]["status"] == answer["after"]["status"] == 0 and len(answer["log"]) == 1, name
        assert all(word in answer["log"][0][2] for word in words[name]), answer["log"]
        assert_same(answer["after"], answer["before"], WARM_START)


def test_runs_its_own_code(run, tmp_path):
    modules = run("first_instant")["modules"]
    assert "wrcontact" not in modules
    assert all(Path(file).is_relative_to(tmp_path / "unpacked" / "resources")
               for file in modules.values()), modules


def test_fmu_returns_what_the_kernel_returns(run):
    rows = poses(40)
    seen = run("trajectory", rows=rows, names=OUTPUT_NAMES)["seen"]
    stepper = ContactSystem().stepper()
    for row, found in zip(rows, seen):
        assert_same(found, evaluated(row, stepper), WARM_START)
