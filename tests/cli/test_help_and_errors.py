"""How the command line receives a user: help, proposals, remarks, and what it checks before the work."""

import os
import re

import pytest

from tests.helpers.foreign_files import inclined_rail
from tests.helpers.profile_points import Y, Z, columns
from wrcontact.cli import commands, tables
from wrcontact.cli.groups import USUAL
from wrcontact.cli.options import POSE, SYSTEM, name_of, option_of
from wrcontact.cli.typed import of_file, typed
from wrcontact.methods import CHOICES

COMMANDS = ("demo", "build", "solve", "sweep", "plot", "check", "profiles", "export", "figures")
MOST_LINES = 90  # of a help text: two screens


# --- help -------------------------------------------------------------------------------------------------


@pytest.fixture
def narrow(monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")


@pytest.mark.parametrize("command", COMMANDS)
def test_help_is_short_and_no_name_is_cut(run, narrow, command):
    texts = {"--help": run(command, "--help")[1]}
    if "--help-all" in texts["--help"]:
        texts["--help-all"] = run(command, "--help-all")[1]
    for text in texts.values():
        assert max(map(len, text.splitlines())) <= 80
        assert not re.search(r"--[a-z-]+-\n|\u2026", text)  # an option that is cut or divided
    assert len(texts["--help"].splitlines()) <= MOST_LINES
    names = {word: re.findall(r"^  (--[a-z-]+)", text, re.MULTILINE) for word, text in texts.items()}
    assert set(names["--help"]) <= set(names.get("--help-all", names["--help"]))


def test_help_has_the_usual_options_and_help_all_every_one(run, narrow):
    for words, wanted in (("--help", USUAL), ("--help-all", {name_of(v) for v in POSE + SYSTEM})):
        text = run("solve", words)[1]
        for variable in POSE + SYSTEM:
            shown = re.search(rf"^  {option_of(variable)} ", text, re.MULTILINE)
            assert bool(shown) == (name_of(variable) in wanted), option_of(variable)


def test_help_has_choices_and_units(run, narrow):
    """Where an option's name has no unit, its words have it: those of a table that is written here."""
    text = " ".join(run("solve", "--help-all")[1].split())
    for name in ("contact_mode", "normal_model", "tangential_model", "separation", "load"):
        assert f"--{name.replace('_', '-')} {'|'.join(CHOICES[name])}" in text
    units = {
        "--speed": "m/s",
        "--lateral-velocity": "m/s",
        "--vertical-velocity": "m/s",
        "--yaw-rate": "rad/s",
        "--roll-rate": "rad/s",
        "--wheel-rate": "rad/s",
        "--track-curvature": "1/m",
        "--left-rail-roll-velocity": "rad/s",
        "--right-rail-lateral-velocity": "m/s",
        "--friction-fall-rate": "s/m",
        "--contact-damping": "s/m",
        "--yaw-deg": "deg",
    }
    for option, unit in units.items():
        entry = re.search(rf" {option} NUMBER (.*?)\(default", text)[1]
        assert entry.endswith(f"[{unit}] "), entry
    keywords = set(re.findall(r"\b[a-z]+(?:_[a-z]+)+\b", text))
    assert keywords <= {"analyn_strip", "equidistant_chord"}  # options instead of Python's names


def test_commands_stand_in_groups(run, narrow):
    text = run("--help")[1]
    assert re.findall(r"^(\w.*):$", text, re.MULTILINE) == [
        "Options",
        "Contacts",
        "FMUs",
        "The study that wrcontact started from",
    ]
    assert len(text.splitlines()) < 40


# --- proposals --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "words, proposal",
    [
        (
            "solve --velocity 3",
            "no option --velocity; did you mean --lateral-velocity or --vertical-velocity",
        ),
        ("solve --normal-force 78", "did you mean --normal-force-kn?"),
        ("solve --lateral_shift_mm 1", "did you mean --lateral-shift-mm?"),
        ("solve --gage-mm 1435", "did you mean --gauge-mm?"),
        ("solve --xyzzy 1", "no option --xyzzy; --help-all lists its options"),
        ("solve --normal-model analin", "did you mean analyn?"),
        ("solve --wheel S1003", "did you mean S1002?"),
        ("build --native --platforms x86_64-linx", "did you mean x86_64-linux?"),
    ],
)
def test_an_unknown_word_comes_with_a_proposal(run, words, proposal):
    code, out, err = run(*words.split())
    assert (code, out) == (2, "") and proposal in err and err.count("\n") == 1


def test_a_missing_file_is_called_missing(run, tmp_path):
    for name in ("worn.csv", "here/worn", tmp_path / "worn"):
        code, _, err = run("solve", "--wheel", name)
        assert (
            code == 2
            and "and there is no such file; permitted are S1002, cone20, cone40, the other names" in err
        )


# --- remarks ----------------------------------------------------------------------------------------------


@pytest.mark.full
def test_a_remark_has_a_line_and_the_gravest_is_first(run, tmp_path):
    """A rail whose inclination is not what is said, and whose z is upwards, in the names of options."""
    y, z = inclined_rail(1 / 40)
    (tmp_path / "own.txt").write_text(columns(y, -z))
    words = ["--rail", tmp_path / "own.txt", "--rail-file-inclination", "1:20"]
    code, _, err = run("solve", *words)
    lines = err.splitlines()
    assert code == 0 and len(lines) == 2
    assert lines[0] == (
        "wrcontact: rail profile own.txt: its head is inclined by 1:40 towards the track centre, although "
        "--rail-file-inclination is 0.05"
    )
    assert "z was positive upwards" in lines[1]
    _, out, _ = run("check", *words, "--output", tmp_path / "check.png")
    assert "its head is inclined by 1:40" in out.splitlines()[1]
    assert "z was positive upwards" in out.partition("Other remarks\n")[2]


def test_a_rail_that_leans_otherwise_is_refused_in_the_names_of_options(run, tmp_path):
    (tmp_path / "own.txt").write_text(columns(*inclined_rail(1 / 40)))
    code, out, err = run("solve", "--rail", tmp_path / "own.txt", "--rail-inclination", "1:20")
    assert code == 2 and out == "" and err.count("\n") == 1
    assert err.endswith(
        "and its track inclines it by 1:20; --rail-file-inclination 0.025 turns it upright, "
        "--rail-file-inclination 0 confirms that it is upright\n"
    )


def test_a_wheel_with_a_wrong_origin_is_remarked(run, tmp_path):
    (tmp_path / "own.txt").write_text(columns(Y - 12.0, Z))
    code, out, err = run("solve", "--wheel", tmp_path / "own.txt")
    assert code == 0 and out and "the back-to-back distance is 1336 mm; usual is 1350 ... 1368 mm" in err


@pytest.mark.parametrize(
    "said, kind, wanted",
    [
        (
            "mirror_y = True mirrors it, mirror_y = False confirms",
            "rail",
            "--rail-mirror-y mirrors it, --no-rail-mirror-y confirms",
        ),
        (
            "contains 2 profiles; select is None; permitted",
            "wheel",
            "contains 2 profiles; --wheel-select is not given; permitted",
        ),
        ("select is 3; permitted", "rail", "--rail-select is 3; permitted"),
        ("3 outliers kept, since smoothing is 0", "wheel", "3 outliers kept, since --smoothing-um is 0"),
    ],
)
def test_sentences_on_files_have_options(said, kind, wanted):
    assert of_file(said, kind) == wanted
    assert typed(f"{kind} profile a.csv {said}") == f"{kind} profile a.csv {wanted}"


# --- before the work --------------------------------------------------------------------------------------


@pytest.fixture
def no_work(monkeypatch):
    """Nothing is computed: a system that is made, or an FMU, is a failure."""

    def work(*arguments, **options):
        raise AssertionError("work was begun")

    monkeypatch.setattr(commands, "ContactSystem", work)
    monkeypatch.setattr("wrcontact.fmu.build.built", work)
    monkeypatch.setattr("wrcontact.study.figures.write_figures", work)


@pytest.mark.parametrize(
    "words",
    [
        "build --output {0}/file/out",
        "build --native --output {0}/file",
        "plot --output {0}/no/a.png",
        "check --output {0}/no/a.png",
        "check --output {0}/a.png --json {0}/no/a.json",
        "sweep --output {0}/no/a.csv",
        "figures --output {0}/file",
        "plot --output {0}/folder.png",
    ],
)
def test_folders_are_checked_before_the_work(run, tmp_path, no_work, words):
    (tmp_path / "file").write_text("not a folder")
    (tmp_path / "folder.png").mkdir()
    code, out, err = run(*(word.format(tmp_path) for word in words.split()))
    assert (code, out) == (2, "") and err.count("\n") == 1 and str(tmp_path) in err
    assert sorted(path.name for path in tmp_path.iterdir()) == ["file", "folder.png"]


def test_a_folder_without_permission_is_refused(run, tmp_path, no_work, monkeypatch):
    monkeypatch.setattr(os, "access", lambda path, mode: False)  # an administrator may write anywhere
    for words, target in (("build --output", tmp_path / "out"), ("plot --output", tmp_path / "a.png")):
        assert run(*words.split(), target) == (2, "", f"wrcontact: {target}: Permission denied\n")


@pytest.mark.parametrize(
    "name, count, words",
    [
        ("a.csv", 50_000, ""),
        ("a.csv", 80_001, "a.csv will have about 0.68 GB, for 80001 rows; a .parquet file has"),
        ("a.parquet", 1_000_000, "a.parquet will have about 3.7 GB, for 1000000 rows"),
        ("a.json", 50_000, "about 1.1 GB"),
        ("a.nc", 50_000, ""),
    ],
)
def test_a_large_file_is_announced(name, count, words):
    file = tables.TableFile(name, tables.ENDINGS[name[1:]])
    said = file.size_words(count)
    assert words in said and bool(words) == bool(said)


@pytest.mark.parametrize("ending", ["csv", "json"])
def test_the_announced_size_is_about_that_of_a_file(run, tmp_path, ending):
    """With creep forces, which need the most digits; within a quarter."""
    path = tmp_path / f"a.{ending}"
    run("sweep", "--step-mm", 0.1, "--tangential-model", "strips", "--speed", 20, "--output", path)
    assert path.stat().st_size / 161 == pytest.approx(tables.ROW_SIZES[ending], rel=0.25)


def test_a_check_tells_its_remarks_once(run, tmp_path):
    """In the report, and not on the error stream as well."""
    (tmp_path / "own.txt").write_text(columns(*inclined_rail(1 / 40)))
    words = ["--rail", tmp_path / "own.txt", "--rail-file-inclination", "1:20"]
    _, out, err = run("check", *words, "--output", tmp_path / "检查.svg")
    assert err == "" and out.count("its head is inclined by 1:40") == 1


def test_a_picture_over_the_shift_takes_a_shift(run, tmp_path):
    code, out, err = run("plot", "radii", "--lateral-shift-mm", "3", "--output", tmp_path / "a.svg")
    assert code == 0 and out.startswith("picture written") and (tmp_path / "a.svg").stat().st_size > 5000
    assert err == "wrcontact: plot radii does not use --lateral-shift-mm\n"


@pytest.mark.full
@pytest.mark.filterwarnings("error")
def test_names_of_other_scripts_give_no_warnings(run, tmp_path):
    (tmp_path / "车轮.txt").write_text(columns(Y, Z))
    code, _, err = run("plot", "--wheel", tmp_path / "车轮.txt", "--output", tmp_path / "a.png")
    assert code == 0 and "Glyph" not in err
