"""The native FMUs as an importer sees them, each in a fresh process, against the package."""

import ctypes
import json
import math
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path
from xml.etree import ElementTree

import fmpy
import numpy as np
import pytest
from fmpy import read_model_description
from fmpy.build import build_platform_binary
from fmpy.validation import validate_fmu

import benchmarks.native
from benchmarks.native import native_host, rows_text
from tests.fmu.test_fmu import (CASES, INPUT_NAMES, OUTPUT_NAMES, RUNS, WRONG, poses, pressed_poses, run_scenario, stored)
from tests.helpers.paths import HELPERS, ROOT
from wrcontact import ContactSystem
from wrcontact.cli import demo
from wrcontact.fmu import compilers, native
from wrcontact.fmu.compilers import CompilerProblem, compiler_for
from wrcontact.interface import variables
from wrcontact.simulation.session import Refused, Session
from wrcontact.interface.variables import OUTPUT, REFERENCE, STRING, VARIABLES
from wrcontact.kernel.binding.library import default_kernel
from wrcontact.kernel.binding.platforms import PLATFORMS, host_platform
from wrcontact.profiles.catalogue import standard_profile
from wrcontact.state import WheelsetState

FMI_HEADERS = Path(fmpy.__file__).parent / "c-code"
SAME = 1e-12   # [relative] to the package; the same compiler and libm give the same bits


def has_compiler():
    try:
        return bool(compiler_for(PLATFORMS[host_platform()]))
    except (CompilerProblem, KeyError):
        return False


pytestmark = pytest.mark.skipif(not has_compiler(), reason="a native FMU is built by a C compiler, and none is here")


@pytest.fixture
def run(fmus, tmp_path):
    """Run a scenario of fmu_process.py with the FMU of FMI 2."""
    return lambda scenario, **arguments: run_scenario(scenario, fmus[2], tmp_path / "unpacked", arguments)


@pytest.fixture
def run3(fmus, tmp_path):
    """Run a scenario of native_process.py with the FMU of FMI 3."""

    def run3(scenario, **arguments):
        command = [sys.executable, str(HELPERS / "native_process.py"), scenario, str(fmus[3]), str(tmp_path / "unpacked3")]
        done = subprocess.run(command, input=json.dumps(arguments), capture_output=True, text=True, encoding="utf-8", timeout=600)
        assert done.returncode == 0, f"{scenario} ended with {done.returncode}:\n{done.stdout}\n{done.stderr}"
        return json.loads(done.stdout)

    return run3


def session(lines=None, **start):
    """The session that the Python FMU runs, initialised."""
    made = Session(tell=(lambda sentence: None) if lines is None else lines.append)
    for name, value in start.items():
        (made.set_strings if VARIABLES[REFERENCE[name]].type == STRING else made.set_reals)([REFERENCE[name]], [value])
    made.start()
    return made


def stepped(made, row):
    """Outputs by name after a step of a session."""
    made.set_reals([REFERENCE[name] for name in row], list(row.values()))
    made.step()
    reals = [v.name for v in VARIABLES[variables.FIRST_OUTPUT:variables.STATUS]]
    return {**dict(zip(reals, made._values[variables.FIRST_OUTPUT:variables.STATUS].tolist())), "status": made.status}


def assert_same(found, wanted):
    for name, value in wanted.items():
        nominal = VARIABLES[REFERENCE[name]].nominal or 1.0
        assert found[name] == pytest.approx(value, rel=SAME, abs=SAME * nominal), name


# --- description --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("version", (2, 3))
def test_fmpy_finds_no_problem(fmus, version):
    assert validate_fmu(str(fmus[version])) == []


@pytest.mark.parametrize("version", (2, 3))
def test_archive_needs_no_python(fmus, version):
    with zipfile.ZipFile(fmus[version]) as archive:
        names = archive.namelist()
    assert not [name for name in names if name.startswith("resources/") or name.endswith((".py", ".pyc"))]
    assert {"modelDescription.xml", "documentation/index.html", "documentation/licenses/fmi.txt",
            "terminalsAndIcons/terminalsAndIcons.xml"} <= set(names)
    place = PLATFORMS[host_platform()]
    assert f"binaries/{place.fmi2 if version == 2 else place.name}/WheelsetContact{place.suffix}" in names


def test_fmi3_variables_are_those_of_the_table(fmus):
    described = read_model_description(str(fmus[3])).modelVariables
    assert [v.valueReference for v in described] == list(range(1, len(described) + 1))
    assert described[0].name == "time" and described[0].causality == "independent"
    with zipfile.ZipFile(fmus[3]) as archive:
        stations = ElementTree.fromstring(archive.read("modelDescription.xml")).find("ModelVariables/UInt64").attrib
    assert stations.pop("description") and stations == {
        "name": "stations", "valueReference": "2", "causality": "structuralParameter", "variability": "fixed", "start": "31",
        "min": "3", "max": "201"}
    seen = []
    for v in described[2:]:
        assert [d.valueReference for d in v.dimensions] in ([], [2])
        seen += [f"{v.name}[{k + 1}]" for k in range(v.shape[0])] if v.dimensions else [v.name]
    assert seen == [v.name for v in VARIABLES]
    by_name = {v.name: v for v in described}
    for variable in VARIABLES:
        found = by_name.get(variable.name)
        if found is not None:
            assert (found.causality, found.variability, found.description) == (
                variable.causality, variable.variability, variable.description)
            assert found.unit == (variable.unit or None)
            if variable.start is not None:
                assert found.start == (variable.start if variable.type == STRING else repr(variable.start))
    assert by_name["left.station"].shape == (31,)


def test_fmi3_dependencies_are_those_of_the_table(fmus):
    described = read_model_description(str(fmus[3]))
    follows = {u.variable.name: {d.name for d in u.dependencies} for u in described.outputs}
    for variable in VARIABLES:
        name = re.sub(r"((?:station|half_length|pressure))\[\d+\]", r"\1", variable.name)
        if variable.causality == OUTPUT:
            assert follows[name] == set(variable.depends_on), name
    initial = {u.variable.name: {d.name for d in u.dependencies} for u in described.initialUnknowns}
    assert {"gauge", "nominal_radius", "lateral_shift"} <= initial["roll"] and "stations" not in initial["roll"]
    assert initial["right.pressure"] == initial["roll"] | {"stations"}


@pytest.mark.parametrize("version", (2, 3))
def test_every_function_of_the_standard_is_exported(fmus, tmp_path, version):
    library = ctypes.CDLL(str(unpacked_library(fmus[version], version, tmp_path)))
    assert [name for name in header_functions(version) if not hasattr(library, name)] == []
    assert not hasattr(library, "wrcontact_step"), "the kernel's own functions stay inside"


def header_functions(version):
    """Names of all functions in the standard's header."""
    text = Path(FMI_HEADERS, f"fmi{version}Functions.h").read_text()
    names = re.findall(rf"^ *FMI{version}_Export fmi{version}\w+TYPE +(fmi{version}\w+);", text, re.MULTILINE)
    assert len(names) == {2: 44, 3: 75}[version]
    return names


def unpacked_library(fmu, version, folder):
    place = PLATFORMS[host_platform()]
    with zipfile.ZipFile(fmu) as archive:
        return Path(archive.extract(f"binaries/{place.fmi2 if version == 2 else place.name}/WheelsetContact{place.suffix}", folder))


# --- values ---------------------------------------------------------------------------------------------------


def test_first_instant(run, run3):
    start = {"lateral_shift": 2e-3, "yaw": 1e-3}
    wanted, default = stepped(session(**start), {}), stepped(session(), {})
    for seen in (run("first_instant", start=start), run3("first_instant", start=start)):
        assert_same(seen["default"], default)
        assert_same(seen["after_initialisation"], wanted)
        assert seen["in_initialisation"] == seen["after_initialisation"]


@pytest.mark.parametrize("name", [pytest.param(name, marks=[pytest.mark.slow] * (k > 0)) for k, name in enumerate(RUNS)])
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
    for answer in (run("simulated", rows=rows, times=times, names=names), run3("simulated", rows=rows, times=times, names=names)):
        made = session()
        for row, found in zip(rows, answer["seen"][1:]):
            wanted = stepped(made, row)
            for name in names:      # another history: the warm start's last digits
                assert found[name] == pytest.approx(wanted[name], rel=1e-9, abs=1e-12), name


PARAMETER_SETS = {
    "strip, elastic": {"normal_model": "analyn_strip", "contact_mode": "elastic", "load": "vertical", "tolerance": 0.02},
    "hertz, basic": {"normal_model": "hertz", "longitudinal_curvature": "basic", "rail_profile": "54E1", "rail_inclination": 0.05},
    "rough, vertical": {"lateral_curvature": "rough", "separation": "vertical", "curvature_step": 1e-3, "gauge": 1.43},
    "smooth, chord": {"lateral_curvature": "smooth", "separation": "equidistant_chord", "curvature_reach": 2e-3},
    "material": {"youngs_modulus": 2e11, "poisson_ratio": 0.3, "nominal_radius": 0.5, "running_circle_distance": 1.51,
                 "gauge_depth": 0.012, "tolerance": 0.0015},
}


@pytest.mark.parametrize("case", [pytest.param(case, marks=[pytest.mark.slow] * (k not in (0, 2))) for k, case in enumerate(PARAMETER_SETS)])
def test_parameters_arrive(run, run3, case):
    start = {"lateral_shift": 3e-3, "yaw": 1e-3, **PARAMETER_SETS[case]}
    wanted = stepped(session(**start), {})
    assert_same(run("first_instant", start=start)["after_initialisation"], wanted)
    assert_same(run3("first_instant", start=start)["after_initialisation"], wanted)


# --- profiles of one's own --------------------------------------------------------------------------------------


def measured(name, file, step=1e-4):
    """A file of points [mm] on a standard profile, as a measurement without noise would give them."""
    profile = standard_profile(name)
    y = np.arange(profile.start + 1e-4, profile.stop - 1e-4, step)
    file.parent.mkdir(parents=True, exist_ok=True)
    np.savetxt(file, 1e3 * np.column_stack((y, profile.height(y))), fmt="%.6f")
    return file


@pytest.fixture(scope="session")
def packed(tmp_path_factory, compiled):
    """FMUs by version with a wheel and a rail of one's own, and their files, whose names have spaces and other letters."""
    folder = tmp_path_factory.mktemp("Profile & 轮轨")
    wheel, rail = measured("S1002", folder / "Rad 7 ä.txt"), measured("UIC60", folder / "Schiene 轨 'neu'.txt")
    fmus = native.build_native_fmus(folder / "out", wheel=wheel, rail=rail, cache=compiled)
    return dict(zip((2, 3), fmus)), wheel, rail


def test_own_profiles_are_packed_and_can_be_switched(packed, tmp_path):
    """All pairs of measured and standard profiles, by the String parameters: the values of a Python session of the file."""
    fmus, wheel, rail = packed
    rows = poses(6)
    for version, script in ((2, "fmu_process.py"), (3, "native_process.py")):
        described = {v.name: v for v in read_model_description(str(fmus[version])).modelVariables}
        assert (described["wheel_profile"].start, described["rail_profile"].start) == (wheel.name, rail.name)
        pairs = ({"wheel_profile": "S1002", "rail_profile": "54E1"}, {"wheel_profile": wheel.name, "rail_profile": "UIC60"},
                 {"wheel_profile": "S1002", "rail_profile": rail.name})
        for pair in ({}, *pairs[3 - version:]):
            start = {**pair, "normal_model": "hertz"}
            seen = outputs_of(script, fmus[version], tmp_path / f"unpacked {version}", rows, start)
            made = Session(resources=str(wheel.parent), tell=lambda sentence: None)
            whole = {"wheel_profile": wheel.name, "rail_profile": rail.name, **start}
            made.set_strings([REFERENCE[name] for name in whole], list(whole.values()))
            made.start()
            for row, found in zip(rows, seen, strict=True):
                assert_same(found, stepped(made, row))


def outputs_of(script, fmu, folder, rows, start=None):
    """Outputs over rows of inputs, by fmu_process.py or native_process.py in a fresh process."""
    given = json.dumps({"rows": rows, "names": OUTPUT_NAMES, "start": start or {}})
    done = subprocess.run([sys.executable, str(HELPERS / script), "trajectory", str(fmu), str(folder)], input=given, text=True,
                          capture_output=True, encoding="utf-8", timeout=600)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)["seen"]


def test_measured_points_give_the_standards_contact(packed):
    """To what points 0.1 mm apart tell of the rail's steep side, from which the gauge is measured."""
    _, wheel, rail = packed
    own, standard = ContactSystem(wheel=str(wheel), rail=str(rail)), ContactSystem()
    for shift in (0.0, 3e-3, 7e-3):
        found, wanted = (system.evaluate(lateral_shift=shift, yaw=0.0, normal_force=78.5e3) for system in (own, standard))
        assert found.roll == pytest.approx(wanted.roll, abs=3e-6)  # [rad]; 2e-7 with points twice as dense
        assert found.right.penetration == pytest.approx(wanted.right.penetration, rel=0.05)


def test_names_of_packed_profiles_are_told(packed, tmp_path):
    fmus, wheel, rail = packed
    answer = run_scenario("refusals", fmus[2], tmp_path / "unpacked", {"cases": {
        "unknown": {"wheel_profile": "S1003"}, "of the other kind": {"wheel_profile": rail.name}}})
    for name, part in (("unknown", wheel.name), ("of the other kind", "a profile of the other kind")):
        assert answer[name]["refused"] and part in answer[name]["log"][0][-1] and answer[name]["after"]["status"] == 0


BAD_FILES = {"no numbers": "wheel\nof the tram\n", "two points": "0 0\n1 1\n", "nan": "0 0\n1 nan\n2 0\n" * 20, "empty": ""}


@pytest.mark.parametrize("case", BAD_FILES)
def test_bad_profile_file_is_refused_at_the_build(tmp_path, case):
    file = tmp_path / "Rad ä.txt"
    file.write_text(BAD_FILES[case])
    with pytest.raises(ValueError, match="Rad ä") as refused:
        native.build_native_fmus(tmp_path / "out", wheel=str(file))
    assert 20 < len(str(refused.value)) < 400 and not (tmp_path / "out").exists()


def test_two_profiles_of_one_name_are_refused(tmp_path):
    wheel, rail = measured("S1002", tmp_path / "a" / "profile.txt"), measured("UIC60", tmp_path / "b" / "profile.txt")
    with pytest.raises(ValueError, match="wheel and rail profile have the same file name, profile.txt; rename one of them"):
        native.build_native_fmus(tmp_path / "out", wheel=wheel, rail=rail)
    with pytest.raises(ValueError, match="missing.txt"):
        native.build_native_fmus(tmp_path / "out", wheel=str(tmp_path / "missing.txt"))


# --- behaviour ------------------------------------------------------------------------------------------------


SITUATIONS = {
    **{name: case for name, (case, *_) in CASES.items()},
    "far yaw": {"yaw": 0.3}, "end of the profile": {"lateral_shift": 0.0149, "yaw": 0.11},
    "minus infinity": {"normal_force": -math.inf}, "no load": {"normal_force": 0.0}, "left lifted": {"load_transfer": 1.0},
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
    answers = run("outcomes", cases={name: case for name, (case, *_) in CASES.items()})
    for name, (_, status, variable, value) in CASES.items():
        answer = answers[name]
        assert answer["during"].pop("status") == status, name
        assert answer["during"] == {key: kept for key, kept in answer["before"].items() if key != "status"}, name
        assert len(answer["log"]) == len(answer["again"]) == 1 and answer["rest"] == [], name
        category, sentence = answer["log"][0][1:]
        assert category == "logStatusWarning" and variable in sentence and value in sentence.lower(), sentence


REFUSED = {
    **{name: start for name, (start, _) in WRONG.items()},
    "other kind": {"rail_profile": "S1002"}, "quote": {"load": "it's"}, "tolerance": {"tolerance": 2e-4},
    "tolerance of a model": {"tolerance": 0.003, "normal_model": "analyn_strip"}, "infinite": {"youngs_modulus": math.inf},
    "offline": {"normal_model": "halfspace"}, "tiny": {"rail_inclination": 1e-5 - 1e-3},
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


@pytest.mark.parametrize("mode", ["rigid", "elastic", "compliant"])
def test_saved_states(run, mode):
    rows = pressed_poses(20) if mode == "compliant" else poses(20)
    seen = run("saved_states", rows=rows, names=OUTPUT_NAMES, start={"contact_mode": mode})
    assert seen["restored"] == seen["before"]
    assert seen["straight"] == seen["back"] == seen["elsewhere"]
    assert seen["refusals"] == [True] * 4 and seen["kept"]
    assert len(seen["log"]) == 4 and all("saved state" in sentence for *_, sentence in seen["log"])
    assert seen["after"]["status"] == 0


def test_saved_states_at_unchanged_inputs(run3):
    """Going back to inputs that were known when the state was saved gives the same bits, and so does another way there."""
    seen = run3("state_again", rows=poses(30))
    assert seen["straight"] == seen["back"] == seen["elsewhere"]


STATIONS = (3, 7, 31, 61, 201)


def test_outlines_with_other_numbers_of_stations(run3):
    """Instances with different numbers in one process, in turn: each with the values of the package, and as by itself."""
    rows = poses(8)
    answer = run3("outlines", stations=STATIONS, rows=rows)
    assert answer["seen"] == answer["alone"]
    for number, seen in zip(STATIONS, answer["seen"]):
        stepper = ContactSystem(stations=number).stepper()
        stepper.inputs[:] = [v.start for v in VARIABLES[:len(INPUT_NAMES)]]
        for row, found in zip(rows, seen):
            stepper.inputs[[REFERENCE[name] for name in row]] = list(row.values())
            status = stepper.step()
            wanted = {v.name: value for v, value in zip(VARIABLES[variables.FIRST_OUTPUT:variables.STATUS], stepper.outputs)
                      if not v.name.endswith("]")}
            for name, values in outline_of_both(stepper.outputs).items():
                wanted |= {f"{name}[{k + 1}]": value for k, value in enumerate(values)}
            assert len(found) == len(wanted) + 1 and found["status"] == status
            for name, value in wanted.items():
                nominal = VARIABLES[REFERENCE[re.sub(r"\[\d+\]$", "[1]", name)]].nominal or 1.0
                assert found[name] == pytest.approx(value, rel=SAME, abs=SAME * nominal), (number, name)


def outline_of_both(values):
    """Both sides' runs of an outline by the names of FMI 3."""
    state = WheelsetState(values, 0, None)
    return {f"{side}.{name}": getattr(getattr(state, side).outline, name).tolist()
            for side in ("left", "right") for name in ("station", "half_length", "pressure")}


def test_saved_states_with_other_numbers_of_stations(run3):
    """An outline is kept where a step is not possible, and goes on bit by bit from a saved state, elsewhere too."""
    seen = run3("stations_again", stations=201, other=7, rows=poses(30))
    assert seen["kept"] == [seen["before"], {"status": 4}] and seen["held"] == seen["before"]
    assert seen["straight"] == seen["back"] == seen["elsewhere"] and len(seen["straight"][0]) > 6 * 201
    assert seen["read"] == {"stations": 201}


def test_configuration_mode(run3):
    seen = run3("configuration")
    for name, (refused, lines) in seen["calls"].items():
        assert refused, name
        assert len(lines) == 1 and lines[0][0] == "logStatusError", f"{name}: {lines}"
    sentences = {name: lines[0][1] for name, (_, lines) in seen["calls"].items()}
    for wrong in (0, 2, 202, 2**64 - 1):
        assert sentences[f"{wrong}"] == f"stations is {wrong}; permitted is 3 ... 201"
    assert sentences["not entered"] == "stations is fixed at 31 outside configuration mode and cannot become 61"
    assert sentences["31 values"] == "fmi3GetFloat64: there are 31 values; these variables have 7"
    assert "8 values; these variables have 7" in sentences["8 values"]
    assert "permitted in configuration mode is stations" in sentences["another parameter"] + sentences["an output"]
    assert seen["kept"] == {"stations": 31} and seen["after"] == seen["running"] and len(seen["after"]) == 7
    assert seen["reset"] == {"stations": 31} and seen["again"] == seen["fresh"] and len(seen["twice"]) == 31
    assert seen["log"] == []


def test_outlines_by_simulate_fmu(run3):
    row = {"lateral_shift": 2e-3, "yaw": 1e-3}
    wanted = outline_of_both(ContactSystem(stations=61).evaluate(**row).values)
    for name, values in run3("simulated_stations", stations=61, row=row).items():
        assert values == pytest.approx(wanted[name], rel=SAME, abs=1e-15), name


DERIVATIVE_OUTPUTS = ["roll", "force.y", "left.contact.y_wheel", "right.curvature_y", "right.area", "left.patch[1].length"]
DERIVATIVE_INPUTS = ["lateral_shift", "yaw", "normal_force", "load_transfer", "roll_guess"]


def kernel_rates(start, stations, row, names, inputs):
    """The kernel's own rates of the outputs that are named and of the right outline's stations, along each input."""
    keywords = {VARIABLES[REFERENCE[name]].keyword or name: value for name, value in start.items()}
    stepper = ContactSystem(stations=stations, **keywords).stepper()
    made = session(**start)
    stepped(made, row)
    stepper.inputs[:] = made._values[:len(stepper.inputs)]
    stepper.step()
    places = [REFERENCE[name] - variables.FIRST_OUTPUT for name in names]
    rates = [stepper._bound.tangent(np.eye(len(stepper.inputs))[REFERENCE[name]])[1] for name in inputs]
    return [[*along[places], *outline_of_both(along)["right.station"]] for along in rates]


@pytest.mark.skipif(not default_kernel().compiled, reason="the derivatives are those of the compiled library, and none is here")
@pytest.mark.parametrize("start, stations", [({}, 31), ({"contact_mode": "elastic", "normal_model": "hertz"}, 31), ({}, 61)],
                         ids=["rigid", "elastic", "61 stations"])
def test_directional_derivatives(run, run3, start, stations):
    rows = poses(3)
    given = {"rows": rows, "inputs": DERIVATIVE_INPUTS, "start": start}
    seen = run("derivatives", outputs=DERIVATIVE_OUTPUTS, **given)
    seen3 = run3("derivatives", outputs=[*DERIVATIVE_OUTPUTS, "right.station"], stations=stations, **given)
    for row, found, found3 in zip(rows, seen["seen"], seen3["seen"]):
        wanted = kernel_rates(start, stations, row, DERIVATIVE_OUTPUTS, DERIVATIVE_INPUTS)
        assert found["kept"] and found3["kept"]
        matrix = np.array(found3["matrix"])
        # the last digits of the warm start, and in elastic contact of the equilibrium
        assert matrix == pytest.approx(np.array(wanted), rel=1e-6, abs=1e-12)
        assert np.array(found["matrix"]) == pytest.approx(matrix[:, :len(DERIVATIVE_OUTPUTS)], rel=1e-6, abs=1e-12)
        assert found3["together"] == pytest.approx(matrix.sum(axis=0), rel=1e-9, abs=1e-12 * np.abs(matrix).max())
        assert found3["adjoint"] == pytest.approx(matrix.sum(axis=1), rel=1e-9, abs=1e-15 * np.abs(matrix).max())
        assert not matrix[DERIVATIVE_INPUTS.index("roll_guess")].any()
    assert np.array(seen3["inside"]) == pytest.approx(np.array(seen3["seen"][0]["matrix"]), rel=1e-6, abs=1e-12)
    assert seen3["after"]
    for name, (refused, lines) in {**seen["calls"], **seen3["calls"]}.items():
        assert refused and len(lines) == 1 and len(lines[0][-1]) > 30, f"{name}: {lines}"


def test_damaged_states_are_refused(run, run3):
    """Flipped bits, cut and longer ones, noise, those of the other FMU: each with one sentence, and the instance goes on."""
    seen = run("damaged_states", rows=poses(8), seed=5, count=300)
    other = run3("damaged_states", rows=poses(8), seed=6, count=300, foreign=[seen["saved"]])
    for answer in (seen, other, run("damaged_states", rows=poses(8), seed=7, count=0, foreign=[other["saved"]])):
        assert answer["wrong"] == [] and answer["equal"] and answer["count"] > 30


def test_numbers_have_a_point_in_a_locale_with_commas(run, comma):
    """In statuses and in refusals, short numbers and long ones; the host prints with a comma."""
    cases = {"status": {"lateral_shift": 0.0812}, "small": {"normal_force": -1.25e-7}, "large": {"lateral_shift": -1.5e300},
             "transfer": {"load_transfer": 1.5}}
    wrong = {"gauge": {"gauge": 14.35}, "long": {"gauge": 0.12345678901234567}, "tolerance": {"tolerance": 2.5e-4},
             "large": {"youngs_modulus": 2.5e25}}
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
    assert seen["values"] == {**{name: VARIABLES[REFERENCE[name]].start for name in start}, "lateral_shift": 0.0}


def test_instances_in_turn_and_in_threads(run):
    parameters = [{}, {"normal_model": "hertz"}, {"rail_profile": "54E1"}, {"nominal_radius": 0.5}]
    seen = run("instances", parameters=parameters, rows=poses(20))
    assert seen["together"] == seen["alone"] == seen["parallel"]


def test_misuse_ends_in_an_error_with_a_sentence(run3):
    seen = run3("misuse")
    for name, (refused, lines) in seen["calls"].items():
        assert refused, name
        assert len(lines) == 1 and lines[0][0] == "logStatusError" and len(lines[0][1]) > 20, f"{name}: {lines}"
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
        done = subprocess.run([sys.executable, str(HELPERS / script), "first_instant", str(copy), str(folder / f"entpackt ü {version}")],
                              input="{}", capture_output=True, text=True, encoding="utf-8", cwd=folder)
        assert done.returncode == 0, done.stderr
        assert_same(json.loads(done.stdout)["default"], stepped(session(), {}))


@pytest.mark.slow
def test_command_line_prints_the_paths(fmus, tmp_path):
    command = [sys.executable, str(ROOT / "build_fmu.py"), "--native", "--output", str(tmp_path / "out")]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    printed = list(map(Path, done.stdout.split()))
    assert printed == [tmp_path / "out" / f"WheelsetContact_native_fmi{version}.fmu" for version in (2, 3)]
    assert [file.read_bytes() for file in printed] == [file.read_bytes() for file in fmus.values()]


def test_command_line_refuses_in_a_sentence(tmp_path):
    command = [sys.executable, str(ROOT / "build_fmu.py"), "--native", "--output", str(tmp_path / "out")]
    wrong = subprocess.run([*command, "--platforms", "amiga"], capture_output=True, text=True)
    assert wrong.returncode == 1 and "platform is 'amiga'; permitted are x86_64-linux" in wrong.stderr
    assert not (tmp_path / "out").exists()


def test_demo_runs_a_native_fmu(fmus, tmp_path, monkeypatch, capsys):
    """As wrcontact demo --native does, without building and drawing."""
    monkeypatch.setattr(native, "build_native_fmus", lambda folder: list(fmus.values()))
    monkeypatch.setattr(demo, "draw", lambda *arguments: None)
    assert demo.run_demo(tmp_path, native=True)
    assert fmus[2].name in capsys.readouterr().out.replace("\n", "")


@pytest.mark.slow
def test_equal_sources_give_equal_bytes(fmus, tmp_path):
    for version, again in zip((2, 3), native.build_native_fmus(tmp_path)):
        assert again.read_bytes() == fmus[version].read_bytes()


def test_other_contents_give_another_token(fmus, packed):
    tokens = [read_model_description(str(fmu)).instantiationToken for fmu in (fmus[3], packed[0][3])]
    assert tokens[0] != tokens[1]


SOURCE_BUILD = ["-std=c11", "-shared", "-fPIC", "-O2"]      # the language that the build description names


@pytest.mark.slow
@pytest.mark.skipif(not shutil.which("cc"), reason="the machine has no C compiler of its own")
@pytest.mark.parametrize("version", (2, 3))
@pytest.mark.parametrize("builder", ("system", "fmpy"))
def test_sources_in_the_archive_give_the_same_values(fmus, tmp_path, version, builder):
    """Compiled from what the archive itself says: by the system's compiler alone, and as fmpy does, by CMake."""
    if builder == "fmpy" and not shutil.which("cmake"):
        pytest.skip("fmpy builds by CMake, which is not installed")
    with zipfile.ZipFile(fmus[version]) as archive:
        archive.extractall(tmp_path / "sources only")
    place, description = PLATFORMS[host_platform()], tmp_path / "sources only" / "modelDescription.xml"
    library = description.parent / "binaries" / (place.fmi2 if version == 2 else place.name) / f"WheelsetContact{place.suffix}"
    library.unlink()
    if builder == "fmpy":
        build_platform_binary(description.parent)
    else:
        compile_as_described(version, description, library)
    again = tmp_path / "again.fmu"
    with zipfile.ZipFile(again, "w") as archive:
        for file in sorted(description.parent.rglob("*")):
            archive.write(file, file.relative_to(description.parent))
    rows, script = poses(20), "fmu_process.py" if version == 2 else "native_process.py"
    one, other = (outputs_of(script, file, tmp_path / f"unpacked {k}", rows) for k, file in enumerate((fmus[version], again)))
    for ours, theirs in zip(one, other, strict=True):
        assert_same(theirs, ours)


def compile_as_described(version, description, library):
    """By the system's compiler, the files that the archive lists."""
    sources = description.parent / "sources"
    listed = ElementTree.parse(description if version == 2 else sources / "buildDescription.xml").getroot()
    units = [node.get("name") for node in listed.iter("File" if version == 2 else "SourceFile")]
    assert len(units) == 6
    done = subprocess.run(["cc", *SOURCE_BUILD, *units, "-o", str(library), "-lm"], cwd=sources, text=True, capture_output=True)
    assert done.returncode == 0, done.stderr


# --- bad input, one call after the other ------------------------------------------------------------------------


@pytest.fixture(scope="session", params=(2, 3))
def raw(request, fmus, tmp_path_factory):
    """What native_raw.py saw with the library of a version of FMI, in a folder without resources."""
    version, folder = request.param, tmp_path_factory.mktemp("Räder & Schienen 轮轨")
    described = read_model_description(str(fmus[version]))
    given = {"token": described.instantiationToken or described.guid,
             "references": {v.name: v.valueReference for v in described.modelVariables}}
    command = [sys.executable, str(HELPERS / "native_raw.py"), str(version), str(unpacked_library(fmus[version], version, folder)),
               str(FMI_HEADERS)]
    done = subprocess.run(command, input=json.dumps(given), capture_output=True, text=True, encoding="utf-8", timeout=300)
    assert done.returncode == 0, f"{done.stdout[-2000:]}\n{done.stderr[-4000:]}"
    return version, json.loads(done.stdout)


ERROR = 3


def assert_refused(answers):
    """Each call ended in an error with one line of one sentence."""
    for name, (status, lines, *_) in answers.items():
        assert status == ERROR and len(lines) == 1, f"{name}: {status}, {lines}"
        assert lines[0][1] == "logStatusError" and 10 < len(lines[0][2]) < 300, f"{name}: {lines}"


NAMED = {"Integer as Real": "status", "String as Real": "load", "output": "roll", "half a list": "roll",
         "unknown reference": "4711", "fixed Real": "gauge is fixed at 1.435", "fixed String": "load is fixed at 'normal'", "step of nan": "nan s",
         "step of -1 s": "-1.0 s", "long String": "load has 5000 bytes", "String without letters": "load is a NULL pointer",
         "too few values": "30 values; these variables have 31", "state: freed": "saved state is not one of this instance",
         "state: cut at 64": "holds 64 bytes", "state: damaged at 16": "comes from another FMU"}


def test_every_misuse_is_refused_in_a_sentence_and_changes_nothing(raw):
    version, seen = raw
    answers = seen["bad_input"]["answers"]
    assert_refused(answers)
    assert [name for name, answer in answers.items() if not answer[2]] == []
    for name, part in NAMED.items():
        assert (version == 2 and name == "too few values") or part in answers[name][1][0][2], name
    signs = "'%%s%%n%%%%d'" if version == 2 else "'%s%n%%d'"     # the message is a format in FMI 2
    assert signs in answers["fixed String with signs"][1][0][2]
    assert seen["bad_input"]["good_inputs_after"] and seen["bad_input"]["after_a_reset"]


def test_numbers_that_are_none_in_every_input(raw):
    _, seen = raw
    assert len(seen["every_input"]) == 3 * len(INPUT_NAMES)
    for name, answer in seen["every_input"].items():
        variable, value = name.split()
        assert answer["calls"] == [0, 0] and answer["status"] == 4 and answer["kept"] and answer["again"], name
        assert [line[2].startswith(f"{variable} is {value} ") for line in answer["lines"]] == [True], answer["lines"]


def test_null_pointers(raw):
    """Every function of the header, without a component, and without each other pointer: an error and a sentence."""
    version, seen = raw
    answers = seen["null_pointers"]["answers"]
    state = "FMUstate" if version == 2 else "FMUState"
    assert answers.pop(f"Free{state}, 1") == [0, []]     # the standards have it ignored
    without = {name: answers.pop(name) for name in list(answers) if name.endswith("no component")}
    assert [name for name, answer in without.items() if answer != [ERROR, []]] == []
    assert_refused(answers)
    assert len(without) > (35 if version == 2 else 65) and seen["null_pointers"]["after"]


def test_functions_of_other_kinds_of_fmu_are_refused(raw):
    """Model exchange, events, clocks, other types, derivatives of inputs and outputs, steps that are still running."""
    version, seen = raw
    refused = seen["null_pointers"]["refused"]
    assert_refused(refused)
    some = ("SetRealInputDerivatives", "GetRealOutputDerivatives", "CancelStep", "GetStatus", "SetTime", "EnterEventMode",
            "GetDerivatives") if version == 2 else ("EnterStepMode", "GetBinary", "SetClock", "GetOutputDerivatives", "SetTime",
                                                    "EvaluateDiscreteStates", "GetContinuousStates", "GetInt64")
    assert set(some) <= set(refused) and len(refused) >= (16 if version == 2 else 45)


def test_order_of_calls_and_sizes_of_steps(raw):
    _, seen = raw
    order = seen["order"]
    assert_refused(order["answers"])
    assert "roll is an output" in order["answers"]["output before"][1][0][2]
    assert "1.1 s" in order["answers"]["beyond the stop"][1][0][2]
    assert order["input_before"] == [0.0, 1.435] and order["inside"][1:] == [0, 0] and abs(order["inside"][0][0]) < 1e-15
    assert order["last"] == 1.0 + (0.1 + 1e-12)
    assert order["sizes"] == [0] * len(order["sizes"]) and order["at_the_end"] == [0, 0, [0.0]] and order["after"]


def test_values_ahead_of_a_step_and_states_of_every_phase(raw):
    _, seen = raw
    assert seen["legal"]["ahead"] == seen["legal"]["then"] != [0.0]
    assert [name for name, equal in seen["legal"]["phases"].items() if not equal] == [] and len(seen["legal"]["phases"]) == 16


def test_instances_that_cannot_be_made_and_odd_ones_that_can(raw):
    version, seen = raw
    for name, (made, lines) in seen["creation"]["refused"].items():
        assert made is None and len(lines) == 1 and len(lines[0][2]) > 20, f"{name}: {lines}"
    for name, (works, lines) in seen["creation"]["made"].items():
        assert works and len(lines) == (name != "silent"), name
    if version == 2:
        assert seen["creation"]["made"]["other letters"][1][0][0] == "Radsatz ä 轮对 %s"
    assert seen["creation"]["without_log"] == (version == 3)


def test_log_categories(raw):
    warning, error = "logStatusWarning", "logStatusError"
    _, seen = raw
    found = seen["categories"]
    assert found.pop("first") == [warning, error]
    assert {name: answer[2] for name, answer in found.items()} == {
        "all off": [], "warnings on": [warning], "unknown": [warning], "errors on, too": [warning, error],
        "warnings off": [error], "all on": [warning, error]}
    assert {name for name, answer in found.items() if answer[0]} == {"unknown"}


def test_threads_of_python(raw):
    """Calls from Python's threads, which leave its lock and run at once: the bits of a run alone."""
    _, seen = raw
    assert all(all(equal) for equal in seen["threads"]["equal"])


@pytest.mark.skipif(sys.platform != "linux", reason="memory is read from /proc")
def test_no_memory_is_left_behind(raw):
    """Instances that were misused and freed, with states that nobody has freed."""
    _, seen = raw
    assert seen["memory"]["growth"] < 1e6  # [bytes]; one state in 100 of the 600 instances would be 3e6


# --- from a C host ---------------------------------------------------------------------------------------------

HOOKS = ["-Dmalloc=hooked_malloc", "-Dcalloc=hooked_calloc", "-Drealloc=hooked_realloc"]
SANITIZERS = ("-O1", "-DWRCONTACT_CHECK_BOUNDS", "-fsanitize=address,undefined,float-cast-overflow",
              "-fno-sanitize-recover=all")
RACES = ("-O1", "-fsanitize=thread")
needs_glibc = pytest.mark.skipif(not shutil.which("cc") or sys.platform != "linux", reason="no compiler for glibc here")


@pytest.fixture(scope="session")
def linked_host(fmus, tmp_path_factory):
    """native_host.c with the library in the FMU; `linked_host(2)` is the program."""
    made = {}

    def linked_host(version):
        if version not in made:
            made[version] = native_host(fmus[version], version, tmp_path_factory.mktemp("linked"))
        return made[version]

    return linked_host


@pytest.fixture(scope="session")
def host(tmp_path_factory):
    """native_host.c with the FMU's sources, compiled with flags: `host(2, *SANITIZERS)`."""
    kept = tmp_path_factory.mktemp("objects")

    def host(version, *flags):
        folder = tmp_path_factory.mktemp("host")
        native.write_sources(native.sources(version, "{token}", *native.packed_profiles()), folder)
        shutil.copy(HELPERS / "native_host.c", folder)
        units = {unit: HOOKS if "/" not in unit else [] for unit in native.compiled_units(version)}
        units["native_host.c"] = [f"-DFMI={version}"]
        objects = []
        for unit, extra in units.items():       # the kernel is the same for both versions
            objects.append(Path(kept if "/" in unit else folder, f"{abs(hash(flags))} {Path(unit).stem}.o"))
            if not objects[-1].exists():
                command = ["cc", "-std=gnu11", "-O3", "-ffp-contract=off", *flags, *extra, "-c", unit, "-o", objects[-1]]
                subprocess.run(command, cwd=folder, check=True)
        subprocess.run(["cc", *flags, *objects, "-o", "host", "-lm", "-pthread"], cwd=folder, check=True)
        return folder / "host"

    return host


def can_use(flags):
    """Whether the system's compiler links a program with these flags, and it runs."""
    if not shutil.which("cc"):
        return False
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "probe.c").write_text("int main(void) { return 0; }\n")
        made = subprocess.run(["cc", *flags, "probe.c", "-o", "probe"], cwd=folder, capture_output=True)
        return made.returncode == 0 and subprocess.run([str(Path(folder, "probe"))]).returncode == 0


needs_sanitizers = pytest.mark.skipif(not can_use(SANITIZERS), reason="no sanitizers here")
needs_race_detector = pytest.mark.skipif(not can_use(RACES), reason="no thread sanitizer here")


def answer_of(program, *arguments):
    done = subprocess.run([str(program), *map(str, arguments)], text=True, capture_output=True, timeout=1800)
    assert done.returncode == 0, f"{done.stdout[-3000:]}\n{done.stderr[-4000:]}"
    return json.loads(done.stdout)


def fuzz(program, version, seed, calls):
    """Random calls, legal and illegal, with allocations that fail now and then; what they reached."""
    counted = answer_of(program, "fuzz", seed, calls)
    assert counted["calls"] == calls and counted["odd_lines"] == counted["damage_accepted"] == 0
    assert counted["valid_steps"] > 0.03 * calls and counted["lines"] > 0.1 * calls
    assert set(counted["functions"]) == set(header_functions(version)), "every function of the standard is called"
    return counted


@needs_glibc
@pytest.mark.parametrize("version", (2, 3))
def test_random_calls(linked_host, version):
    counted = fuzz(linked_host(version), version, 5, 15_000)
    assert (counted["other_outlines"] > 0.01 * 15_000) == (version == 3)


@pytest.mark.slow
@needs_sanitizers
@pytest.mark.parametrize("version", (2, 3))
def test_a_million_random_calls_under_sanitizers(host, version):
    """Ten runs, or a share of them, in which every contact mode meets every normal model."""
    program, started, runs = host(version, *SANITIZERS), {}, int(os.environ.get("WRCONTACT_FUZZ_RUNS", 10))
    for seed in range(runs):
        for methods, count in fuzz(program, version, seed, 100_000)["started"].items():
            started[methods] = started.get(methods, 0) + count
    modes, models = (next(v for v in VARIABLES if v.name == name).choices for name in ("contact_mode", "normal_model"))
    assert len(started) == len(modes) * len(models) and min(started.values()) >= 2 * runs, started


@needs_glibc
def test_a_call_that_ends_the_program_is_told(linked_host, tmp_path):
    """With its seed and number, which repeat it."""
    running = subprocess.Popen([str(linked_host(2)), "fuzz", "11", "100000000"], text=True, stderr=subprocess.PIPE)
    children = Path(f"/proc/{running.pid}/task/{running.pid}/children")
    while not (child := children.read_text().split()):
        pass
    os.kill(int(child[0]), signal.SIGSEGV)
    _, told = running.communicate(timeout=60)
    assert running.returncode == 1 and re.match(r"native_host fuzz 11 \d+ fails: ended by signal 11", told), told


@pytest.fixture(scope="session")
def rows_file(tmp_path_factory):
    """Inputs of the stored run "hunting" as native_host reads them."""
    file = tmp_path_factory.mktemp("rows") / "rows.txt"
    _, rows, _ = stored("hunting")
    file.write_text(rows_text(rows))
    return file


@needs_glibc
@pytest.mark.parametrize("version", (2, 3))
def test_no_allocation_between_initialisation_and_end(linked_host, version, rows_file):
    """Nor in any other part of the process; but the first of the states that are saved has to be somewhere."""
    counted = answer_of(linked_host(version), "allocations", rows_file)
    assert counted["rows"] > 100 and counted["wrong"] == 0
    assert counted["steps"] == counted["states"] == 0 and counted["first_state"] == 1


@needs_glibc
@pytest.mark.parametrize("version", (2, 3))
def test_eight_instances_in_eight_threads(linked_host, version, rows_file):
    """Of different methods, each with the bits of its run alone."""
    assert answer_of(linked_host(version), "threads", 8, rows_file) == {"equal": 8, "variants": 8, "wrong": 0}


@needs_glibc
def test_a_random_walk_repeats_itself_and_resumes(linked_host):
    """A little of test_long_runs.py: the same bits by FMI 2.0, by FMI 3.0, and from saved states at random times."""
    walks = [answer_of(linked_host(version), way, 7, 4_000, 0)[0] for version in (2, 3) for way in ("walk", "resumed")]
    assert [walk["bad"] for walk in walks] == [0] * 4 and walks[1]["partings"] > 4 and walks[0]["jumps"] > 100
    assert len({walk["digest"] for walk in walks}) == 1
    threads = answer_of(linked_host(2), "walks", 7, 4_000, 2)
    assert threads[0]["digest"] == walks[0]["digest"] != threads[1]["digest"]


@pytest.mark.slow
@needs_race_detector
@pytest.mark.parametrize("version", (2, 3))
def test_threads_share_nothing(host, version, rows_file):
    assert answer_of(host(version, *RACES), "threads", 8, rows_file) == {"equal": 8, "variants": 8, "wrong": 0}


@needs_glibc
@pytest.mark.slow
@pytest.mark.complete
@pytest.mark.skipif(not shutil.which("valgrind"), reason="valgrind is not installed")
@pytest.mark.parametrize("version", (2, 3))
def test_valgrind_finds_nothing(host, version):
    """In the program as it is packed, without a sanitizer's help."""
    command = ["valgrind", "-q", "--error-exitcode=9", "--leak-check=full", "--trace-children=yes"]
    done = subprocess.run([*command, str(host(version)), "fuzz", "3", "3000"], text=True, capture_output=True, timeout=900)
    assert done.returncode == 0, done.stderr[-3000:]


@pytest.mark.slow
@needs_glibc
@pytest.mark.parametrize("version", (2, 3))
def test_compilers_have_nothing_to_say(tmp_path, version):
    """About the sources in the archive, with -Wall."""
    native.write_sources(native.sources(version, "{token}", *native.packed_profiles()), tmp_path)
    for unit in native.compiled_units(version):
        command = ["cc", "-std=gnu11", "-Wall", "-Werror", "-fsyntax-only", unit]
        done = subprocess.run(command, cwd=tmp_path, text=True, capture_output=True)
        assert (done.returncode, done.stderr) == (0, ""), done.stderr[:2000]


@pytest.mark.slow
@needs_glibc
def test_cost_is_measured(fmus, capsys):
    benchmarks.native.main(list(map(str, fmus.values())))
    rows = re.findall(r"\| FMI (\d)\.0 \| ([\d.]+) \| ([\d.]+) \|", capsys.readouterr().out)
    assert [version for version, *_ in rows] == ["2", "3"] and all(0.5 < float(units) < 200 for _, units, _ in rows)


# --- building -------------------------------------------------------------------------------------------------


def test_unknown_platform_is_refused(tmp_path):
    with pytest.raises(ValueError, match="platform is 'amiga'; permitted are x86_64-linux"):
        native.build_native_fmus(tmp_path / "out", platforms=["amiga"])
    assert not (tmp_path / "out").exists()


def test_missing_compiler_is_told(monkeypatch):
    monkeypatch.setattr(compilers.importlib.util, "find_spec", lambda name: None)
    monkeypatch.setattr(compilers.shutil, "which", lambda name: None)
    with pytest.raises(CompilerProblem, match="no compiler for aarch64-darwin; pip install ziglang"):
        compiler_for(PLATFORMS["aarch64-darwin"])


@pytest.mark.slow
@pytest.mark.skipif(not shutil.which("cc"), reason="the machine has no C compiler of its own")
def test_the_systems_own_compiler_gives_the_same_values(fmus, tmp_path, monkeypatch):
    """Another compiler, the same bits but for the mathematical library."""
    monkeypatch.setattr(compilers.importlib.util, "find_spec", lambda name: None)
    own = native.build_native_fmus(tmp_path / "own")
    rows = poses(20)
    seen = [run_scenario("trajectory", fmu, tmp_path / f"unpacked {k}", {"rows": rows, "names": OUTPUT_NAMES})["seen"]
            for k, fmu in enumerate((fmus[2], own[0]))]
    for one, other in zip(*seen):
        assert_same(one, other)
