"""The native FMUs as an importer sees them, each in a fresh process, against the package."""

import ctypes
import importlib.util
import json
import math
import re
import shutil
import subprocess
import sys
import tempfile
import timeit
import zipfile
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from fmpy import read_model_description
from fmpy.validation import validate_fmu

from tests.test_fmu import (CASES, INPUT_NAMES, OUTPUT_NAMES, TRAJECTORIES, WRONG, poses, pressed_poses, profile_file,
                            run_scenario, stored)
from wrcontact import ContactSystem
from wrcontact.fmu import compilers, native
from wrcontact.fmu.compilers import PLATFORMS, CompilerProblem, compiler_for, host_platform
from wrcontact.interface import variables
from wrcontact.interface.session import Refused, Session
from wrcontact.interface.variables import OUTPUT, REFERENCE, STRING, VARIABLES
from wrcontact.kernel.library import default_kernel

HERE = Path(__file__).resolve().parent
SAME = 1e-12   # [relative] to the package; the same compiler and libm give the same bits


def has_compiler():
    try:
        return bool(compiler_for(PLATFORMS[host_platform()]))
    except (CompilerProblem, KeyError):
        return False


pytestmark = pytest.mark.skipif(not has_compiler(), reason="no C compiler here")


@pytest.fixture(scope="session")
def fmus(tmp_path_factory):
    """The FMUs by version of FMI, built once."""
    return dict(zip((2, 3), native.build_native_fmus(tmp_path_factory.mktemp("native"))))


@pytest.fixture
def run(fmus, tmp_path):
    """Run a scenario of fmu_process.py with the FMU of FMI 2."""
    return lambda scenario, **arguments: run_scenario(scenario, fmus[2], tmp_path / "unpacked", arguments)


@pytest.fixture
def run3(fmus, tmp_path):
    """Run a scenario of native_process.py with the FMU of FMI 3."""

    def run3(scenario, **arguments):
        command = [sys.executable, str(HERE / "native_process.py"), scenario, str(fmus[3]), str(tmp_path / "unpacked3")]
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
    assert {"modelDescription.xml", "documentation/index.html", "documentation/licenses/fmi.txt"} <= set(names)
    place = PLATFORMS[host_platform()]
    assert f"binaries/{place.fmi2 if version == 2 else place.name}/WheelsetContact{place.suffix}" in names


def test_fmi3_variables_are_those_of_the_table(fmus):
    described = read_model_description(str(fmus[3])).modelVariables
    assert [v.valueReference for v in described] == list(range(1, len(described) + 1))
    assert described[0].name == "time" and described[0].causality == "independent"
    seen = []
    for v in described[1:]:
        count = math.prod(int(d.start) for d in v.dimensions) if v.dimensions else 1
        seen += [f"{v.name}[{k + 1}]" for k in range(count)] if v.dimensions else [v.name]
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
    assert int(by_name["left.station"].dimensions[0].start) == 31


def test_fmi3_dependencies_are_those_of_the_table(fmus):
    described = read_model_description(str(fmus[3]))
    follows = {u.variable.name: {d.name for d in u.dependencies} for u in described.outputs}
    for variable in VARIABLES:
        name = re.sub(r"((?:station|half_length|pressure))\[\d+\]", r"\1", variable.name)
        if variable.causality == OUTPUT:
            assert follows[name] == set(variable.depends_on), name
    initial = {u.variable.name: {d.name for d in u.dependencies} for u in described.initialUnknowns}
    assert {"gauge", "nominal_radius", "lateral_shift"} <= initial["roll"]


@pytest.mark.parametrize("version", (2, 3))
def test_every_function_of_the_standard_is_exported(fmus, tmp_path, version):
    import fmpy

    library = ctypes.CDLL(str(unpacked_library(fmus[version], version, tmp_path)))
    text = Path(fmpy.__file__).parent.joinpath("c-code", f"fmi{version}Functions.h").read_text()
    names = re.findall(rf"^ *FMI{version}_Export fmi{version}\w+TYPE +(fmi{version}\w+);", text, re.MULTILINE)
    exchange = ("EventMode", "DiscreteStates", "ContinuousTimeMode", "CompletedIntegratorStep", "SetTime", "ContinuousStates",
                "Derivatives", "EventIndicators")
    if version == 2:
        names = [name for name in names if not name.endswith(exchange) or name.endswith(("InputDerivatives", "OutputDerivatives"))]
    assert len(names) > (30 if version == 2 else 70)
    assert [name for name in names if not hasattr(library, name)] == []
    assert not hasattr(library, "wrcontact_step"), "the kernel's own functions stay inside"


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


@pytest.mark.parametrize("name", TRAJECTORIES)
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


@pytest.mark.parametrize("case", PARAMETER_SETS)
def test_parameters_arrive(run, run3, case):
    start = {"lateral_shift": 3e-3, "yaw": 1e-3, **PARAMETER_SETS[case]}
    wanted = stepped(session(**start), {})
    assert_same(run("first_instant", start=start)["after_initialisation"], wanted)
    assert_same(run3("first_instant", start=start)["after_initialisation"], wanted)


def test_own_profiles_are_packed(tmp_path):
    wheel = profile_file(tmp_path, "wheel")
    files = native.build_native_fmus(tmp_path / "out", wheel=wheel)
    start = {"wheel_profile": "S1002"}
    seen = run_scenario("first_instant", files[0], tmp_path / "unpacked", {"start": start})
    stepper = ContactSystem(wheel=str(wheel)).stepper()
    stepper.inputs[:] = [v.start for v in VARIABLES[:len(INPUT_NAMES)]]
    stepper.step()
    names = [v.name for v in VARIABLES[variables.FIRST_OUTPUT:variables.STATUS]]
    assert_same(seen["default"], dict(zip(names, stepper.outputs.tolist())))
    assert_same(seen["after_initialisation"], stepped(session(), {}))


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


DERIVATIVE_OUTPUTS = ["roll", "force.y", "left.contact.y_wheel", "right.curvature_y", "right.area", "left.patch[1].length"]
DERIVATIVE_INPUTS = ["lateral_shift", "yaw", "normal_force", "load_transfer", "roll_guess"]


def kernel_rates(start, row, names, inputs):
    """The kernel's own rates of the outputs that are named, along each input."""
    keywords = {VARIABLES[REFERENCE[name]].keyword or name: value for name, value in start.items()}
    stepper = ContactSystem(**keywords).stepper()
    made = session(**start)
    stepped(made, row)
    stepper.inputs[:] = made._values[:len(stepper.inputs)]
    stepper.step()
    places = [REFERENCE[name] - variables.FIRST_OUTPUT for name in names]
    return [stepper._bound.tangent(np.eye(len(stepper.inputs))[REFERENCE[name]])[1][places].tolist() for name in inputs]


@pytest.mark.skipif(not default_kernel().compiled, reason="no compiled library here")
@pytest.mark.parametrize("start", [{}, {"contact_mode": "elastic", "normal_model": "hertz"}], ids=["rigid", "elastic"])
def test_directional_derivatives(run, run3, start):
    rows = poses(3)
    given = {"rows": rows, "inputs": DERIVATIVE_INPUTS, "start": start}
    seen = run("derivatives", outputs=DERIVATIVE_OUTPUTS, **given)
    seen3 = run3("derivatives", outputs=[*DERIVATIVE_OUTPUTS, "right.station"], **given)
    names = [*DERIVATIVE_OUTPUTS, *(f"right.station[{k + 1}]" for k in range(31))]
    for row, found, found3 in zip(rows, seen["seen"], seen3["seen"]):
        wanted = kernel_rates(start, row, names, DERIVATIVE_INPUTS)
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


def test_memory_stays_flat(run):
    assert run("endurance", steps=100_000)["resident"] < 2e6  # [bytes]


def test_path_with_spaces_and_other_letters(fmus, tmp_path):
    folder = tmp_path / "Räder & Schienen 轮轨"
    folder.mkdir()
    for version, script in ((2, "fmu_process.py"), (3, "native_process.py")):
        copy = shutil.copy(fmus[version], folder / f"my FMU ä {version}.fmu")
        done = subprocess.run([sys.executable, str(HERE / script), "first_instant", str(copy), str(folder / f"entpackt ü {version}")],
                              input="{}", capture_output=True, text=True, encoding="utf-8", cwd=folder)
        assert done.returncode == 0, done.stderr
        assert_same(json.loads(done.stdout)["default"], stepped(session(), {}))


def test_command_line_prints_the_paths(fmus, tmp_path):
    command = [sys.executable, str(HERE.parent / "build_fmu.py"), "--native", "--output", str(tmp_path / "out")]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    printed = list(map(Path, done.stdout.split()))
    assert printed == [tmp_path / "out" / f"WheelsetContact_native_fmi{version}.fmu" for version in (2, 3)]
    assert [file.read_bytes() for file in printed] == [file.read_bytes() for file in fmus.values()]
    wrong = subprocess.run([*command, "--platforms", "x86_64-linux,amiga"], capture_output=True, text=True)
    assert wrong.returncode == 1 and "platform is 'amiga'; permitted are x86_64-linux" in wrong.stderr


def test_equal_sources_give_equal_bytes(fmus, tmp_path):
    for version, again in zip((2, 3), native.build_native_fmus(tmp_path)):
        assert again.read_bytes() == fmus[version].read_bytes()


def test_other_contents_give_another_token(fmus, tmp_path):
    other = native.build_native_fmus(tmp_path, wheel=profile_file(tmp_path, "wheel"))
    assert read_model_description(str(other[1])).instantiationToken != read_model_description(str(fmus[3])).instantiationToken


SOURCE_BUILD = ["-shared", "-fPIC", "-O2"]


@pytest.mark.skipif(not shutil.which("cc"), reason="no system compiler here")
@pytest.mark.parametrize("version", (2, 3))
def test_sources_in_the_archive_give_the_same_values(fmus, tmp_path, version):
    """Compiled by the system's compiler alone, from what the archive itself says."""
    with zipfile.ZipFile(fmus[version]) as archive:
        archive.extractall(tmp_path / "sources only")
    place, description = PLATFORMS[host_platform()], tmp_path / "sources only" / "modelDescription.xml"
    sources = description.parent / "sources"
    listed = ElementTree.parse(description if version == 2 else sources / "buildDescription.xml").getroot()
    units = [node.get("name") for node in listed.iter("File" if version == 2 else "SourceFile")]
    assert len(units) == 6
    library = description.parent / "binaries" / (place.fmi2 if version == 2 else place.name) / f"WheelsetContact{place.suffix}"
    library.unlink()
    done = subprocess.run(["cc", *SOURCE_BUILD, *units, "-o", str(library), "-lm"], cwd=sources, text=True, capture_output=True)
    assert done.returncode == 0, done.stderr
    again = tmp_path / "again.fmu"
    with zipfile.ZipFile(again, "w") as archive:
        for file in sorted(description.parent.rglob("*")):
            archive.write(file, file.relative_to(description.parent))
    rows, script = poses(20), "fmu_process.py" if version == 2 else "native_process.py"
    seen = [subprocess.run([sys.executable, str(HERE / script), "trajectory", str(file), str(tmp_path / f"unpacked {k}")],
                           input=json.dumps({"rows": rows, "names": OUTPUT_NAMES}), text=True, capture_output=True)
            for k, file in enumerate((fmus[version], again))]
    one, other = (json.loads(run.stdout)["seen"] for run in seen)
    for ours, theirs in zip(one, other, strict=True):
        assert_same(theirs, ours)


# --- from a C host ---------------------------------------------------------------------------------------------

HOOKS = ["-Dmalloc=hooked_malloc", "-Dcalloc=hooked_calloc", "-Drealloc=hooked_realloc"]
SANITIZERS = ["-O1", "-DWRCONTACT_CHECK_BOUNDS", "-fsanitize=address,undefined,float-cast-overflow", "-fno-sanitize-recover=all"]
CALLS = 100_000
COST = 25.0 / 2.0   # of set 5, do step, get all on the run "hunting", in units of np.sqrt over 2000 numbers
DERIVATIVE_COST = 25.0      # of one directional derivative of all outputs there, likewise
NOISE = 2.0         # of a shared machine


@pytest.fixture(scope="session")
def host(tmp_path_factory):
    """Build native_host.c with the FMU's sources, once for each version and flags."""
    made = {}

    def host(version, *flags):
        if (version, flags) not in made:
            folder = tmp_path_factory.mktemp("host")
            native.write_sources(native.sources(version, "{token}", *native.packed_profiles()), folder)
            shutil.copy(HERE / "native_host.c", folder)
            units = {unit: HOOKS if "/" not in unit else [] for unit in native.compiled_units(version)}
            units["native_host.c"] = [f"-DFMI={version}"]
            for number, (unit, extra) in enumerate(units.items()):
                subprocess.run(["cc", "-std=gnu11", "-O3", "-ffp-contract=off", *flags, *extra, "-c", unit, "-o", f"{number}.o"],
                               cwd=folder, check=True)
            objects = [f"{number}.o" for number in range(len(units))]
            subprocess.run(["cc", *flags, *objects, "-o", "host", "-lm"], cwd=folder, check=True)
            made[version, flags] = folder / "host"
        return made[version, flags]

    return host


needs_system_compiler = pytest.mark.skipif(not shutil.which("cc"), reason="no system compiler here")


def sanitizers_work():
    """Whether the system's compiler links and runs a sanitized program."""
    if not shutil.which("cc"):
        return False
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "probe.c").write_text("int main(void) { return 0; }\n")
        made = subprocess.run(["cc", *SANITIZERS, "probe.c", "-o", "probe"], cwd=folder, capture_output=True)
        return made.returncode == 0 and subprocess.run([str(Path(folder, "probe"))]).returncode == 0


def fuzz(program, seed, calls):
    """Random calls, legal and illegal, with allocations that fail now and then; what the program counted."""
    done = subprocess.run([str(program), "fuzz", str(seed), str(calls)], text=True, capture_output=True, timeout=1800)
    assert done.returncode == 0, f"seed {seed}: {done.stdout}\n{done.stderr[-4000:]}"
    counted = json.loads(done.stdout)
    assert counted["valid_steps"] > 0.03 * calls and counted["lines"] > 0.1 * calls and counted["odd_lines"] == 0
    return counted


@pytest.mark.skipif(not sanitizers_work(), reason="no sanitizers here")
@pytest.mark.parametrize("version", (2, 3))
def test_random_calls_under_sanitizers(host, version):
    fuzz(host(version, *SANITIZERS), 5, CALLS)


@pytest.mark.slow
@pytest.mark.skipif(not sanitizers_work(), reason="no sanitizers here")
@pytest.mark.parametrize("version", (2, 3))
def test_a_million_random_calls_under_sanitizers(host, version):
    for seed in range(10):
        fuzz(host(version, *SANITIZERS), seed, CALLS)


@needs_system_compiler
@pytest.mark.parametrize("version", (2, 3))
def test_cost_and_allocations(host, version, tmp_path):
    """Set 5, do step, get all outputs: within its cost, and without an allocation after the initialisation."""
    _, rows, _ = stored("hunting")
    names = ("lateral_shift", "yaw", "roll_guess", "normal_force", "load_transfer")
    (tmp_path / "rows.txt").write_text("".join(" ".join(repr(row[name]) for name in names) + "\n" for row in rows))
    done = subprocess.run([str(host(version)), "cost", str(tmp_path / "rows.txt")], text=True, capture_output=True, check=True)
    found = json.loads(done.stdout)
    assert found["allocations"] == 0 and found["rows"] == len(rows)
    assert found["outputs"] == len([v for v in VARIABLES if v.causality == OUTPUT and v.type == "Real"])
    root = np.arange(2000.0)
    unit = 1e6 * min(timeit.repeat(lambda: np.sqrt(root), number=1, repeat=2000))
    assert found["microseconds"] <= NOISE * COST * unit, f"{found['microseconds']} us where np.sqrt takes {unit} us"
    assert found["derivative"] <= NOISE * DERIVATIVE_COST * unit, f"{found['derivative']} us where np.sqrt takes {unit} us"


# --- building -------------------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.skipif(not importlib.util.find_spec("ziglang"), reason="ziglang is not installed")
def test_all_platforms_are_built_on_this_machine(tmp_path):
    """Each library in its place, of the right kind, needing nothing but libc and libm."""
    magic = {".so": b"\x7fELF", ".dll": b"MZ", ".dylib": b"\xcf\xfa\xed\xfe"}
    for version, fmu in zip((2, 3), native.build_native_fmus(tmp_path, platforms=list(PLATFORMS))):
        with zipfile.ZipFile(fmu) as archive:
            for place in PLATFORMS.values():
                library = archive.read(f"binaries/{place.fmi2 if version == 2 else place.name}/WheelsetContact{place.suffix}")
                assert library.startswith(magic[place.suffix]), place.name
                if place.suffix == ".so":
                    needed = set(re.findall(rb"[\w-]+\.so\.\d+", library)) - {b"ld-linux-aarch64.so.1"}
                    assert needed <= {b"libm.so.6", b"libc.so.6"}, place.name
                    versions = [tuple(map(int, found.split(b"."))) for found in re.findall(rb"GLIBC_([\d.]+)", library)]
                    assert versions and max(versions) <= (2, 17), place.name
                if place.suffix == ".dll":
                    needed = {name.lower() for name in re.findall(rb"[\w-]+\.dll", library)}
                    system = (b"kernel32", b"api-ms-win-crt-", b"wheelsetcontact")
                    assert all(name.startswith(system) for name in needed), place.name
        assert validate_fmu(str(fmu)) == []


def test_unknown_platform_is_refused(tmp_path):
    with pytest.raises(ValueError, match="platform is 'amiga'; permitted are x86_64-linux"):
        native.build_native_fmus(tmp_path / "out", platforms=["amiga"])
    assert not (tmp_path / "out").exists()


def test_missing_compiler_is_told(monkeypatch):
    monkeypatch.setattr(compilers.importlib.util, "find_spec", lambda name: None)
    monkeypatch.setattr(compilers.shutil, "which", lambda name: None)
    with pytest.raises(CompilerProblem, match="no compiler for aarch64-darwin; pip install ziglang"):
        compiler_for(PLATFORMS["aarch64-darwin"])


@pytest.mark.skipif(not shutil.which("cc"), reason="no system compiler here")
def test_the_systems_own_compiler_gives_the_same_values(fmus, tmp_path, monkeypatch):
    """Another compiler, the same bits but for the mathematical library."""
    monkeypatch.setattr(compilers.importlib.util, "find_spec", lambda name: None)
    own = native.build_native_fmus(tmp_path / "own")
    rows = poses(20)
    seen = [run_scenario("trajectory", fmu, tmp_path / f"unpacked {k}", {"rows": rows, "names": OUTPUT_NAMES})["seen"]
            for k, fmu in enumerate((fmus[2], own[0]))]
    for one, other in zip(*seen):
        assert_same(one, other)
