"""The command line as people use it: what it prints, writes and refuses, and its exit codes."""

import json
import re

import numpy as np
import pytest

import wrcontact
from data import HUNTING
from tests.helpers.command_line import read_csv, start
from tests.helpers.paths import ROOT
from tests.helpers.slice_files import write_slices
from wrcontact import ContactSystem
from wrcontact.cli import main
from wrcontact.cli.options import POSE, SYSTEM, option_of
from wrcontact.cli.report import sentence
from wrcontact.kernel import layout
from wrcontact.methods import CHOICES
from wrcontact.results.convert import columns_of

COMMANDS = ("demo", "build", "solve", "sweep", "plot", "check", "profiles", "export", "figures")


# --- solve ----------------------------------------------------------------------------------------


def test_solve_prints_display_units(run):
    code, out, err = run("solve", "--lateral-shift-mm", 1, "--yaw-deg", 0, "--normal-force-kn", 78.5)
    state = ContactSystem().evaluate(lateral_shift=1e-3, yaw=0.0, normal_force=78.5e3)
    rows = {words[0]: words[1:] for words in map(str.split, out.splitlines()) if len(words) == 4}
    assert code == 0 and err == ""
    assert rows["contact.y_wheel"] == [
        "mm",
        *(f"{side.contact.y_wheel * 1e3:.4f}" for side in (state.left, state.right)),
    ]
    assert rows["contact.y_wheel"][2] == "-9.3567"  # [mm] as an independent search has it
    assert rows["area"] == ["mm2", f"{state.left.area * 1e6:.2f}", f"{state.right.area * 1e6:.2f}"]
    assert rows["max_pressure"] == [
        "MPa",
        f"{state.left.max_pressure / 1e6:.1f}",
        f"{state.right.max_pressure / 1e6:.1f}",
    ]
    assert rows["contact_angle"][1:] == [
        f"{np.degrees(side.contact_angle):.4f}" for side in (state.left, state.right)
    ]
    assert rows["normal_force"] == ["kN", "78.500", "78.500"]
    assert f"roll {np.degrees(state.roll):#.4g} deg" in out and "status 0 (valid)" in out


def test_solve_prints_each_patch_where_there_are_several(run):
    _, out, _ = run("solve", "--lateral-shift-mm", 5)
    state = ContactSystem().evaluate(lateral_shift=5e-3)
    assert state.right.patch_count == 2
    line = next(line for line in out.splitlines() if "patch[2].normal_force" in line)
    assert line.split() == ["patch[2].normal_force", "kN", f"{state.right.patches[1].normal_force / 1e3:.3f}"]


def test_solve_json_is_the_state_in_si(run):
    options = {
        "--lateral-shift-mm": 5,
        "--yaw-deg": 0.5,
        "--normal-force-kn": 60,
        "--load-transfer": 0.2,
        "--rail": "60E1",
        "--rail-inclination": "1:20",
        "--normal-model": "hertz",
        "--gauge-mm": 1440,
        "--youngs-modulus-mpa": 206000,
    }
    code, out, _ = run("solve", "--json", *(word for pair in options.items() for word in pair))
    system = ContactSystem(
        rail="60E1", rail_inclination=1 / 20, normal_model="hertz", gauge=1.44, youngs_modulus=206e9
    )
    state = system.evaluate(lateral_shift=5e-3, yaw=np.radians(0.5), normal_force=60e3, load_transfer=0.2)
    seen = json.loads(out)
    assert code == 0 and (seen["status"], seen["explanation"]) == (0, "")
    assert (seen["roll"], seen["vertical_shift"]) == (state.roll, state.vertical_shift)
    for side in ("left", "right"):
        wanted = getattr(state, side)
        assert seen[side]["contact"]["y_wheel"] == wanted.contact.y_wheel
        assert seen[side]["penetration"] == wanted.penetration
        assert seen[side]["patch_count"] == wanted.patch_count
        assert [patch["area"] for patch in seen[side]["patches"]] == [patch.area for patch in wanted.patches]
        assert seen[side]["outline"]["half_length"] == wanted.outline.half_length.tolist()


def in_kilo(value):
    """A force [N] or power [W] as it is printed: three digits after the point, or four digits."""
    return f"{value / 1e3:.3f}" if abs(value) > 1e3 or abs(value) < 1e-6 else f"{value / 1e3:#.4g}"


def test_solve_prints_the_resultant(run):
    """On the flange, where it has a lateral force and a moment."""
    _, out, _ = run("solve", "--lateral-shift-mm", 6.5, "--yaw-deg", 1)
    state = ContactSystem().evaluate(lateral_shift=6.5e-3, yaw=np.radians(1))
    line = next(line for line in out.splitlines() if line.startswith("contact forces"))
    force, moment = (
        f"({', '.join(in_kilo(getattr(vector, axis)) for axis in 'xyz')})"
        for vector in (state.force, state.moment)
    )
    assert line == f"contact forces on the wheelset {force} kN, moment about its centre {moment} kN.m"
    _, out, _ = run("solve", "--lateral-shift-mm", 6.5, "--yaw-deg", 1, "--json")
    seen = json.loads(out)
    assert seen["force"] == {axis: getattr(state.force, axis) for axis in "xyz"}
    assert seen["moment"] == {axis: getattr(state.moment, axis) for axis in "xyz"}


METHODS = {
    "--contact-mode": "elastic",
    "--load": "vertical",
    "--normal-model": "analyn_strip",
    "--separation": "equidistant",
    "--longitudinal-curvature": "basic",
    "--lateral-curvature": "rough",
    "--curvature-step-mm": 0.5,
    "--curvature-reach-mm": 2,
    "--tolerance": 0.02,
}


def test_solve_takes_every_method(run):
    code, out, _ = run(
        "solve", "--lateral-shift-mm", 3, "--json", *(word for pair in METHODS.items() for word in pair)
    )
    system = ContactSystem(
        contact_mode="elastic",
        load="vertical",
        normal_model="analyn_strip",
        separation="equidistant",
        longitudinal_curvature="basic",
        lateral_curvature="rough",
        curvature_step=0.5e-3,
        curvature_reach=2e-3,
        tolerance=0.02,
    )
    state, seen = system.evaluate(lateral_shift=3e-3), json.loads(out)
    assert code == 0 and seen["status"] == 0
    assert (seen["roll"], seen["right"]["area"]) == (state.roll, state.right.area)
    # the load is the vertical component
    assert seen["force"]["z"] == pytest.approx(-2 * 78.5e3, rel=1e-6)
    assert "vertical force 78.500 kN per wheel" in run("solve", "--load", "vertical")[1]


def test_solve_at_a_given_height_and_roll(run):
    pose = ("--lateral-shift-mm", 1, "--contact-mode", "compliant")
    code, out, _ = run("solve", *pose, "--vertical-shift-mm", 0.2, "--roll-deg", -0.003, "--json")
    state = ContactSystem(contact_mode="compliant").evaluate(
        lateral_shift=1e-3, vertical_shift_input=0.2e-3, roll_input=np.radians(-0.003)
    )
    seen = json.loads(out)
    assert code == 0 and (seen["vertical_shift"], seen["roll"]) == (0.2e-3, np.radians(-0.003))
    assert seen["left"]["normal_force"] == state.left.normal_force > 1e4
    code, out, _ = run("solve", *pose, "--vertical-shift-mm", -1)
    assert code == 0 and "status 1 (unloaded)" in out and "--vertical-shift-mm is -1 mm" in out
    assert "lifted" in out
    assert "height and roll prescribed" in out
    code, out, err = run(
        "sweep", "--contact-mode", "compliant", "--vertical-shift-mm", 4, "--from-mm", 0, "--to-mm", 1
    )
    assert code == 2 and "--vertical-shift-mm is 4 mm" in err


def test_solve_tells_that_a_wheel_is_unloaded(run):
    code, out, _ = run("solve", "--load-transfer", 1)
    assert code == 0 and "status 1 (unloaded)" in out and "a wheel carries no load" in out


def test_json_has_null_where_there_is_no_contact(run):
    code, out, err = run("solve", "--lateral-shift-mm", 20, "--json")
    seen = json.loads(out)
    assert code == 2 and seen["status"] == 2 and seen["roll"] is None
    assert seen["right"]["contact"]["y_wheel"] is None
    assert seen["explanation"].startswith("lateral_shift is 0.02 m") and "--lateral-shift-mm is 20 mm" in err


def test_sentence_promises_no_kept_values():
    """A command has no last valid values."""
    for status, inputs in (
        (2, (0.02, 0, 0, 1, 0, 0, 0)),
        (3, (0, 0, 0, 1, 0, 0, 0)),
        (4, (np.nan, 0, 0, 1, 0, 0, 0)),
    ):
        for compliant in (False, True):
            assert "keep" not in sentence(status, inputs, compliant)


def test_every_input_and_parameter_has_an_option(run):
    _, out, _ = run("solve", "--help-all")
    for variable in POSE + SYSTEM:
        assert option_of(variable) in out
    assert {option_of(v) for v in POSE} == {
        "--lateral-shift-mm",
        "--yaw-deg",
        "--normal-force-kn",
        "--load-transfer",
        "--vertical-shift-mm",
        "--roll-deg",
        "--speed",
        "--lateral-velocity",
        "--vertical-velocity",
        "--yaw-rate",
        "--roll-rate",
        "--wheel-rate",
        "--track-curvature",
        "--left-friction",
        "--right-friction",
        "--left-wheel-rate",
        "--right-wheel-rate",
        "--axle-torque-knm",
        "--left-axle-torque-knm",
        "--right-axle-torque-knm",
        "--rail-time-step",
        "--track-position-mm",
        "--wheel-rotation-deg",
        *(
            f"--{side}-rail-deflection-{direction}-before-mm"
            for side in ("left", "right")
            for direction in ("lateral", "vertical")
        ),
        *(
            f"--{side}-rail-{part}"
            for side in ("left", "right")
            for part in (
                "lateral-mm",
                "vertical-mm",
                "roll-deg",
                "lateral-velocity",
                "vertical-velocity",
                "roll-velocity",
            )
        ),
    }
    methods = {
        "contact-mode",
        "load",
        "normal-model",
        "separation",
        "longitudinal-curvature",
        "lateral-curvature",
        "curvature-step-mm",
        "curvature-reach-mm",
        "tolerance",
        "tangential-model",
        "flange-friction-ratio",
        "flange-friction-angle-deg",
        "friction-fall",
        "friction-fall-rate",
        "slope-reduction",
        "slope-reduction-floor",
        "slope-reduction-rate",
    }
    assert {f"--{name}" for name in methods} <= {option_of(v) for v in SYSTEM}
    assert all("|".join(CHOICES[name]) in out for name in CHOICES)
    assert max(map(len, out.splitlines())) <= 80


def test_rail_inclination_is_read_as_a_ratio_or_a_slope(run):
    answers = {run("solve", "--json", "--rail-inclination", text)[1] for text in ("1:40", "1/40", "0.025")}
    assert len(answers) == 1


# --- sweep ----------------------------------------------------------------------------------------


def test_sweep_writes_what_evaluate_many_returns(run, tmp_path):
    file = tmp_path / "sweep.csv"
    load = ("--yaw-deg", 0.3, "--normal-force-kn", 100)
    code, out, _ = run("sweep", "--from-mm", -7, "--to-mm", 7, "--step-mm", 0.1, *load, "--csv", file)
    written = read_csv(file)
    shifts = np.round(np.linspace(-7, 7, 141), 9) / 1e3
    expected = columns_of(
        ContactSystem().evaluate_many(lateral_shift=shifts, yaw=np.radians(0.3), normal_force=100e3)
    )
    assert code == 0 and "141 rows" in out
    assert list(written) == list(expected) and len(expected) == layout.INPUT_COUNT + layout.OUTPUT_COUNT + 1
    for name, column in expected.items():
        np.testing.assert_array_equal(written[name], column, err_msg=name)


def test_sweep_prints_a_table(run):
    code, out, err = run("sweep", "--from-mm", 0, "--to-mm", 6, "--step-mm", 3)
    rows = [line.split() for line in out.splitlines() if re.match(r" *\d+\.\d{3} ", line)]
    right = ContactSystem().evaluate(lateral_shift=3e-3).right
    assert code == 0 and err == "" and [row[0] for row in rows] == ["0.000", "3.000", "6.000"]
    assert rows[1][5:] == [
        f"{right.contact.y_wheel * 1e3:.3f}",
        f"{right.area * 1e6:.1f}",
        f"{right.max_pressure / 1e6:.0f}",
    ]
    assert max(map(len, out.splitlines())) <= 80


def test_sweep_beyond_the_profiles_leaves_cells_empty_and_says_so(run, tmp_path):
    code, out, err = run(
        "sweep", "--from-mm", 14, "--to-mm", 16, "--step-mm", 1, "--csv", tmp_path / "sweep.csv"
    )
    written = read_csv(tmp_path / "sweep.csv")
    assert code == 0 and written["status"].tolist() == [0, 0, 2]
    assert np.isnan(written["roll"]).tolist() == [False, False, True]
    assert "1 of 3 rows" in err and "16 mm" in err and "15 mm" in err


# --- plot -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name, opening",
    [
        ("pose.png", b"\x89PNG"),
        *(
            pytest.param(*row, marks=pytest.mark.full)
            for row in (("pose.svg", b"<?xml"), ("pose.pdf", b"%PDF"))
        ),
    ],
)
def test_plot_draws_a_picture(run, tmp_path, name, opening):
    code, out, _ = run("plot", "--lateral-shift-mm", 5, "--output", tmp_path / name)
    content = (tmp_path / name).read_bytes()
    assert code == 0 and str(tmp_path / name) in out
    assert content.startswith(opening) and len(content) > 20_000


KINDS = {
    "lines": "--yaw-deg 1 --side left",
    "radii": "",
    "angles": "",
    "roll": "--wheel cone20",
    "wheel": "--lateral-shift-mm 5",
    "patch": "--tangential-model strips --speed 20 --colour slip",
    "creep": "--over spin",
    "history": "--run {run} --names max_pressure",
    "animation": "--run {run} --frames 2",
}


@pytest.mark.parametrize(
    "kind",
    [
        "lines",
        "history",
        *(pytest.param(kind, marks=pytest.mark.full) for kind in KINDS if kind not in ("lines", "history")),
    ],
)
def test_plot_draws_every_kind(run, tmp_path, monkeypatch, kind):
    """In the working directory, under the name of its kind; a checkout may have spaces in its path."""
    monkeypatch.chdir(tmp_path)
    words = [word.format(run=HUNTING) for word in KINDS[kind].split()]
    name = f"{kind}.{'gif' if kind == 'animation' else 'png'}"
    assert run("plot", kind, *words) == (0, f"picture written to {name}\n", "")
    assert (tmp_path / name).read_bytes()[:4] in (b"\x89PNG", b"GIF8")


# --- wrong input ----------------------------------------------------------------------------------


WRONG = {
    "wheel": ("solve --wheel S1003", ["--wheel is 'S1003'", "S1002"]),
    "rail": ("sweep --rail Vignole", ["--rail is 'Vignole'", "UIC60"]),
    "model": ("plot --normal-model kalker", ["--normal-model is 'kalker'", "analyn", "hertz"]),
    "mode": (
        "solve --contact-mode elastisch",
        ["--contact-mode is 'elastisch'", "rigid", "elastic", "compliant"],
    ),
    "load": ("sweep --load lateral", ["--load is 'lateral'", "normal", "vertical"]),
    "separation": ("solve --separation lateral", ["--separation", "lateral", "equidistant_chord"]),
    "step_of_curvature": ("plot --curvature-step-mm 50", ["--curvature-step-mm is 50", "0.02 ... 5 mm"]),
    "height_of_rigid": (
        "solve --vertical-shift-mm 0.1",
        ["--vertical-shift-mm", "--contact-mode compliant", "'rigid'"],
    ),
    "roll_of_elastic": (
        "sweep --roll-deg 0.1 --contact-mode elastic",
        ["--roll-deg", "compliant", "'elastic'"],
    ),
    "force_of_compliant": (
        "plot --normal-force-kn 9 --contact-mode compliant",
        ["--normal-force-kn", "rigid or elastic"],
    ),
    "deep": (
        "solve --contact-mode compliant --vertical-shift-mm 4",
        ["--vertical-shift-mm is 4 mm", "--lateral-shift-mm 0 mm", "deeper in its rail than 2 mm"],
    ),
    "gauge": ("solve --gauge-mm 14350", ["--gauge-mm is 14350; permitted is 500 ... 2000 mm"]),
    "gauge_of_a_hair_too_much": ("solve --gauge-mm 2000.0000001", ["--gauge-mm is 2000.0000001;"]),
    "modulus": ("solve --youngs-modulus-mpa 1e308", ["--youngs-modulus-mpa is 1e+308", "MPa"]),
    "tolerance": (
        "solve --normal-model halfspace --tolerance 1e-4",
        ["--tolerance is 0.0001", "--normal-model 'halfspace'"],
    ),
    "inclination": ("solve --rail-inclination 1:forty", ["--rail-inclination", "1:forty", "1:40"]),
    "inclination_of_nothing": ("solve --rail-inclination 1:0", ["--rail-inclination", "1:0"]),
    "steep_inclination": ("solve --rail-inclination 1:2", ["--rail-inclination is 0.5", "0.1"]),
    "word": ("solve --yaw-deg left", ["--yaw-deg", "left", "number"]),
    "comma": ("solve --yaw-deg 1,5", ["--yaw-deg", "'1,5' is not a number", "point"]),
    "missing_value": ("solve --yaw-deg", ["--yaw-deg"]),
    "nan": ("solve --lateral-shift-mm nan", ["--lateral-shift-mm is nan"]),
    "overflow": ("solve --normal-force-kn 1e308", ["--normal-force-kn is inf kN"]),
    "digits": ("solve --lateral-shift-mm 9" + 5000 * "9", ["--lateral-shift-mm is inf mm"]),
    "shift": ("solve --lateral-shift-mm 20", ["--lateral-shift-mm is 20 mm", "<= 15 mm"]),
    "shift_of_a_hair_too_much": (
        "solve --lateral-shift-mm 15.00000001",
        ["--lateral-shift-mm is 15.00000001 mm", "<= 15 mm"],
    ),
    "yaw": ("plot --yaw-deg 10", ["--yaw-deg is 10 deg", "6.87549 deg"]),
    "force": ("solve --normal-force-kn -1", ["--normal-force-kn is -1 kN"]),
    "force_of_a_sweep": ("sweep --normal-force-kn -1", ["--normal-force-kn is -1 kN"]),
    "transfer": ("solve --load-transfer 1.5", ["--load-transfer is 1.5"]),
    "friction": (
        "solve --right-friction 3 --tangential-model polach --speed 20",
        ["--right-friction is 3", "<= 2"],
    ),
    "speed": ("solve --speed 1000", ["--speed is 1000 m/s; permitted is |--speed| <= 200 m/s"]),
    "step": ("sweep --step-mm 0", ["--step-mm", "0"]),
    "backwards": ("sweep --from-mm 3 --to-mm -3", ["--from-mm 3", "--to-mm -3"]),
    "far": ("sweep --from-mm -1e308 --to-mm 1e308", ["--from-mm -1e+308", "1000"]),
    "endless": ("sweep --step-mm 1e-9 --output {folder}/a.csv", ["--step-mm 1e-09", "1000000"]),
    "endless_step": ("sweep --step-mm 1e-320 --output {folder}/a.csv", ["--step-mm", "1000000"]),
    "many_rows_to_print": ("sweep --step-mm 0.001", ["16001 rows", "10000", "--output FILE"]),
    "no_contact": ("sweep --from-mm 16 --to-mm 20 --output {folder}/a.csv", ["lateral shift is 16 mm"]),
    "folder": ("sweep --csv {folder}/no/such/sweep.csv", ["sweep.csv", "No such file"]),
    "ending": ("sweep --output {folder}/a.xls", ["--output", "a.xls", ".csv, .json, .parquet, .nc"]),
    "no_ending": ("sweep --output {folder}/a", ["--output", ".csv"]),
    "other_ending": ("sweep --netcdf {folder}/a.csv", ["--netcdf", "a.csv", ".nc"]),
    "two_files": ("sweep --csv a.csv --json a.json", ["--csv and --json", "one of them"]),
    "picture": ("plot --output {folder}/pose.doc", ["pose.doc", ".png"]),
    "picture_kind": ("plot line", ["KIND is 'line'", "'lines'", "did you mean lines?"]),
    "picture_of_no_pose": ("plot lines --load-transfer 0.1", ["--load-transfer is given; plot lines"]),
    "swapped_profiles": (
        "solve --wheel UIC60 --rail S1002",
        ["--wheel is 'UIC60'", "did you swap --wheel and --rail?"],
    ),
    "metres": (
        "solve --gauge-mm 1.435",
        ["permitted is 500 ... 2000 mm; did you mean 1.435 m, which is 1435 mm?"],
    ),
    "other_side_of_a_ratio": ("solve --rail-inclination 40", ["is 40; permitted is", "did you mean 1:40?"]),
    "picture_side": ("plot radii --side left", ["--side is given", "plot lines or wheel or patch or creep"]),
    "picture_without_run": ("plot history --names yaw", ["--run is missing", "CSV file"]),
    "picture_without_names": ("plot history --run run.csv", ["--names is missing"]),
    "picture_of_no_file": ("plot history --run {folder}/no.csv --names yaw", ["no.csv", "No such file"]),
    "picture_of_no_system": (
        "plot history --run run.csv --names yaw --rail 60E1",
        ["--rail is given; plot history does not use it"],
    ),
    "picture_of_no_friction": ("plot patch --colour slip", ["--colour is 'slip'; permitted is 'pressure'"]),
    "picture_colour": ("plot patch --colour red", ["--colour is 'red'; permitted are 'pressure', 'shear'"]),
    "picture_over": ("plot creep --over time", ["--over is 'time'; permitted are 'creepage_x'"]),
    "picture_film": ("plot animation --run run.csv --output {folder}/a.png", ["a.png", ".gif, .mp4"]),
    "picture_yaw": ("plot roll --yaw-deg 10", ["none of the 321 lateral shifts has a contact", "yaw is"]),
    "picture_folder": ("plot --output {folder}/no/such/pose.png", ["pose.png", "No such file"]),
    "demo_folder": ("demo --output {folder}/file/inside", ["file"]),
    "platforms": ("build --platforms all", ["--platforms", "--native"]),
    "option": ("solve --velocity 100", ["--velocity"]),
    "command": ("solv", ["solv"]),
    "argument": ("solve 5", ["5"]),
}


@pytest.mark.parametrize("words, told", WRONG.values(), ids=WRONG)
def test_wrong_input_is_one_sentence(run, tmp_path, words, told):
    (tmp_path / "file").write_text("not a folder")
    code, out, err = run(*(word.format(folder=tmp_path) for word in words.split()))
    assert code == 2 and out == ""
    assert err.startswith("wrcontact: ") and err.count("\n") == 1 and "Traceback" not in err
    assert all(word in err for word in told), err
    assert not list(tmp_path.glob("a.*"))


def test_a_force_in_wrong_units_is_remarked_once(run):
    """In the option's name and unit; the result is printed all the same."""
    for command in ("solve", "sweep --from-mm 0 --to-mm 1"):
        code, out, err = run(*command.split(), "--normal-force-kn", "5000", "--nominal-radius-mm", "920")
        assert (
            code == 0
            and out
            and err.splitlines()
            == [
                "wrcontact: --nominal-radius-mm is 920 mm; usual is 125 ... 700 mm. It is used as it is.",
                "wrcontact: --normal-force-kn is 5000 kN; usual is 0.5 ... 1000 kN. It is used as it is.",
            ]
        )
    code, out, err = run("solve", "--normal-force-kn", 0.0785)
    assert code == 0 and err == (
        "wrcontact: --normal-force-kn is 0.0785 kN; usual is 0.5 ... 1000 kN. It is used as it is.\n"
    )
    assert run("solve", "--normal-force-kn", 0)[2] == ""  # a lifted wheel


@pytest.mark.parametrize("mode", ["rigid", "elastic"])
def test_a_load_that_is_too_large_is_named(run, mode):
    """78 500 kN: the profile is not blamed."""
    code, out, err = run("solve", "--normal-force-kn", 78500, "--contact-mode", mode)
    assert (
        code == 2
        and out == ""
        and err.splitlines()[1].startswith(
            "wrcontact: --normal-force-kn is 78500 kN; usual is at most 1000 kN: it presses a wheel"
        )
    )


def test_a_bug_is_seen(monkeypatch):
    """Only what the package refuses becomes a sentence."""

    def broken(*arguments, **options):
        raise ZeroDivisionError("a bug")

    monkeypatch.setattr(ContactSystem, "evaluate", broken)
    with pytest.raises(ZeroDivisionError):
        main(["solve"])


# --- help, entry point, examples ------------------------------------------------------------------


@pytest.mark.parametrize(
    "words", [(), ("--help",), *((command, "--help") for command in COMMANDS)], ids=" ".join
)
def test_help(run, words):
    code, out, _ = run(*words)
    assert code == 0 and "Usage: wrcontact" in out
    assert all(command in out for command in COMMANDS) or words[0] in COMMANDS


def test_version(run):
    assert run("--version") == (0, f"wrcontact {wrcontact.__version__}\n", "")


def test_entry_point():
    assert 'wrcontact = "wrcontact.cli:main"' in (ROOT / "pyproject.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    "name, most",
    [
        pytest.param("one_pose", 40, marks=pytest.mark.full),
        pytest.param("lateral_sweep", 40, marks=pytest.mark.full),
        pytest.param("dipped_weld", 60, marks=pytest.mark.full),
        pytest.param("wheel_flat", 60, marks=pytest.mark.full),
        pytest.param("compare_models", 40, marks=pytest.mark.full),
        pytest.param("step_the_fmu", 40, marks=pytest.mark.full),
        # compiles a native FMU; tests/fmu/native/test_irregular_track.py runs it with one that is compiled
        pytest.param("irregular_track", 130, marks=pytest.mark.full),
    ],
)
@pytest.mark.turns(2)
def test_example(tmp_path, name, most):
    """Each example ends with an assertion of its own."""
    script = ROOT / "examples" / f"{name}.py"
    done = start(str(script), folder=tmp_path)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / f"{name}.png").stat().st_size > 10_000
    assert len(script.read_text(encoding="utf-8").splitlines()) < most


def test_creepages_of_a_wheelset_that_rolls(run):
    _, still, _ = run("solve", "--lateral-shift-mm", "1")
    _, rolling, _ = run("solve", "--lateral-shift-mm", "1", "--speed", "20", "--track-curvature", "0.001")
    assert "creepage" not in still and "patch[1].creepage.spin" in rolling and "patch[1].area" not in rolling


def printed(out):
    """Cells of a printed state by the names of its rows, the unit first."""
    return {cells[0]: cells[1:] for cells in map(str.split, out.splitlines()) if len(cells) in (3, 4)}


def test_creep_forces_are_printed_with_a_model(run):
    options = (
        "--lateral-shift-mm",
        3,
        "--yaw-deg",
        0.2,
        "--speed",
        20,
        "--tangential-model",
        "polach",
        "--left-friction",
        0.2,
        "--right-friction",
        0.4,
    )
    code, out, err = run("solve", *options)
    state = ContactSystem(tangential_model="polach").evaluate(
        3e-3, np.radians(0.2), speed=20.0, left_friction=0.2, right_friction=0.4
    )
    sides, rows = (state.left, state.right), printed(out)
    assert (code, err) == (0, "")
    assert rows["patch[1].tangential.x"] == ["kN", *(in_kilo(side.patches[0].tangential.x) for side in sides)]
    assert rows["patch[1].saturation"] == [f"{side.patches[0].saturation:.4f}" for side in sides]
    assert rows["friction_power"] == ["kW", *(f"{side.friction_power / 1e3:.4f}" for side in sides)]
    assert rows["wear_number"] == ["kN", *(in_kilo(side.wear_number) for side in sides)]
    assert rows["normal.force.y"] == ["kN", *(in_kilo(side.normal.force.y) for side in sides)]
    assert f"driving torque {in_kilo(state.driving_torque)} kN.m" in out


def test_small_numbers_keep_four_digits(run):
    """Creepages of 1e-4, and the wear number of a wheelset that hardly slides."""
    options = ("--lateral-shift-mm", 0.1, "--speed", 20, "--tangential-model", "strips")
    rows, tiny = (
        printed(run("solve", *options)[1]),
        ContactSystem(tangential_model="strips").evaluate(0.1e-3, speed=20.0),
    )
    sides = (tiny.left, tiny.right)
    assert rows["patch[1].creepage.x"] == [f"{side.patches[0].creepage.x:#.4g}" for side in sides]
    assert rows["wear_number"] == ["kN", *(f"{side.wear_number / 1e3:#.4g}" for side in sides)]
    assert abs(tiny.left.patches[0].creepage.x) < 1e-3 and abs(tiny.left.wear_number) < 10.0
    table = run("sweep", "--from-mm", 0.1, "--to-mm", 0.1, *options[2:])[1].splitlines()
    power = next(line.split()[-1] for line in table if line.split()[:1] == ["0.100"])
    assert power == f"{tiny.right.friction_power / 1e3:#.3g}" and float(power) < 0.1


def test_without_creep_forces_none_are_printed(run):
    _, plain, _ = run("solve", "--lateral-shift-mm", 3, "--speed", 20)
    _, still, _ = run("solve", "--lateral-shift-mm", 3, "--tangential-model", "polach")
    for word in ("tangential", "saturation", "friction_power", "normal.force", "driving torque"):
        assert word not in plain and word not in still
    assert "no creep forces: neither --speed nor --wheel-rate is given" in still and "creep" in plain
    code, out, err = run("solve", "--left-friction", 0.2)
    assert (code, out) == (2, "") and "--left-friction is given" in err and "polach" in err


def test_a_sweep_with_creep_forces(run):
    sweep = ("sweep", "--from-mm", 1, "--to-mm", 3, "--step-mm", 1)
    _, plain, _ = run(*sweep)
    code, out, err = run(*sweep, "--tangential-model", "polach", "--speed", 20, "--right-friction", 0.4)
    assert (code, err) == (0, "") and "pressure" in plain and "used" not in plain
    table = ContactSystem(tangential_model="polach").evaluate_many(
        [1e-3, 2e-3, 3e-3], speed=20.0, right_friction=0.4
    )
    last = next(line.split() for line in out.splitlines() if line.split()[:1] == ["3.000"])
    assert float(last[-1]) == pytest.approx(table.right.friction_power[2] / 1e3, abs=5e-4)
    assert float(last[-2]) == pytest.approx(table["right.patch[1].saturation"][2], abs=5e-4)
    assert "kW" in out and "used" in out


@pytest.mark.full
def test_rails_that_change_along_the_track(run, tmp_path):
    """One is solved and drawn along the track; what cannot have it refuses it in one sentence."""
    file = write_slices(tmp_path)
    code, out, err = run("solve", "--rail", file)
    assert code == 0 and "force.x" in out and err == ""
    picture = tmp_path / "along.png"
    code, out, err = run("plot", "along", "--rail", file, "--normal-force-kn", "20", "--output", picture)
    assert (code, out, err) == (0, f"picture written to {picture}\n", "") and picture.stat().st_size > 10_000
    refused = "changes along the track; permitted for {} are rails that are the same all along it"
    for words, what in (
        (("check",), "check"),
        (("build", "--output", tmp_path / "fmu"), "an FMU"),
        (("build", "--native", "--output", tmp_path / "fmu"), "an FMU"),
        (("plot", "lines", "--output", tmp_path / "lines.png"), "profile_tables"),
        (("plot", "radii", "--output", tmp_path / "radii.png"), "a sweep over the lateral shift"),
    ):
        code, _, err = run(*words, "--rail", file)
        assert code == 2 and refused.format(what) in err and err.count("\n") == 1, err
    code, _, err = run("plot", "along", "--output", picture)
    assert code == 2 and "permitted is one with RailSections" in err
    code, _, err = run("plot", "along", "--rail", file, "--track-position-mm", "3", "--output", picture)
    assert code == 2 and "plot along does not use it" in err
