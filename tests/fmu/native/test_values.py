"""The native FMUs return what the package returns."""

import pytest

from tests.helpers.cases import INPUT_NAMES, OUTPUT_NAMES, RUNS, stored
from tests.helpers.fmus import assert_same, needs_compiler, session, stepped
from tests.helpers.output_witnesses import SCENES, Scene
from wrcontact.interface.variables import VARIABLES

pytestmark = needs_compiler


def test_first_instant(run, run3):
    start = {"lateral_shift": 2e-3, "yaw": 1e-3}
    wanted, default = stepped(session(**start), {}), stepped(session(), {})
    for seen in (run("first_instant", start=start), run3("first_instant", start=start)):
        assert_same(seen["default"], default)
        assert_same(seen["after_initialisation"], wanted)
        assert seen["in_initialisation"] == seen["after_initialisation"]


@pytest.mark.parametrize("name", [pytest.param(name, marks=[pytest.mark.slow] * (k > 0))
                                  for k, name in enumerate(RUNS)])
def test_trajectory(run, run3, name):
    """The values of the Python FMU, to the last digits, at the stored inputs."""
    _, rows, _ = stored(name)
    seen = run("trajectory", rows=rows, names=OUTPUT_NAMES)["seen"]
    made = session()
    for row, found in zip(rows, seen):
        assert_same(found, stepped(made, row))
    assert run3("trajectory", rows=rows, names=OUTPUT_NAMES)["seen"] == seen


def test_trajectory_by_simulate_fmu(run, run3):
    times, rows, expected = stored("hunting")
    rows = [{**dict(zip(INPUT_NAMES, (v.start for v in VARIABLES))), **row} for row in rows]
    names = list(expected[0])
    for answer in (run("simulated", rows=rows, times=times, names=names),
                   run3("simulated", rows=rows, times=times, names=names)):
        made = session()
        for row, found in zip(rows, answer["seen"][1:]):
            wanted = stepped(made, row)
            for name in names:      # another history: the warm start's last digits
                assert found[name] == pytest.approx(wanted[name], rel=1e-9, abs=1e-12), name


@pytest.mark.parametrize("name", ["yawed", pytest.param("three_patches", marks=pytest.mark.slow)])
def test_outputs_are_what_their_witnesses_say(run, run3, name):
    """As of tests/interface/test_witnesses.py, read through the C of both versions."""
    start, inputs, _ = SCENES[name]
    for run_version in (run, run3):
        (seen,) = run_version("trajectory", rows=[inputs], names=OUTPUT_NAMES, start=start)["seen"]
        assert list(Scene(name, seen).misses()) == []


PARAMETER_SETS = {
    "strip, elastic": {"normal_model": "analyn_strip", "contact_mode": "elastic", "load": "vertical",
                       "tolerance": 0.02},
    "hertz, basic": {"normal_model": "hertz", "longitudinal_curvature": "basic", "rail_profile": "54E1",
                     "rail_inclination": 0.05},
    "rough, vertical": {"lateral_curvature": "rough", "separation": "vertical", "curvature_step": 1e-3,
                        "gauge": 1.43},
    "smooth, chord": {"lateral_curvature": "smooth", "separation": "equidistant_chord",
                      "curvature_reach": 2e-3},
    "material": {"youngs_modulus": 2e11, "poisson_ratio": 0.3, "nominal_radius": 0.5,
                 "running_circle_distance": 1.51, "gauge_depth": 0.012, "tolerance": 0.0015},
}


@pytest.mark.parametrize("case", [pytest.param(case, marks=[pytest.mark.slow] * (k not in (0, 2)))
                                  for k, case in enumerate(PARAMETER_SETS)])
def test_parameters_arrive(run, run3, case):
    start = {"lateral_shift": 3e-3, "yaw": 1e-3, **PARAMETER_SETS[case]}
    wanted = stepped(session(**start), {})
    assert_same(run("first_instant", start=start)["after_initialisation"], wanted)
    assert_same(run3("first_instant", start=start)["after_initialisation"], wanted)
