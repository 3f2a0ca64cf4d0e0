"""What .ci/run refuses before it has run a test, what it tells of steps that fail, that no test is skipped without
being missed, and which tests it runs on which day."""

import csv
import importlib.util
import os
import shutil
import subprocess
import sys

import pytest

from tests.helpers.paths import ROOT
from tests.helpers.skips import PERMITTED
from tests.helpers.turns import WEEK, WEEKLY, changed_paths, due

CLEAN = {
    name: value
    for name, value in os.environ.items()
    if not name.startswith(("GIT_", "PYTEST_", "WRCONTACT_"))
}
needs_git = pytest.mark.skipif(not shutil.which("git"), reason="git is not installed")


def git(folder, *words, **environment):
    subprocess.run(
        ["git", "-c", "user.name=x", "-c", "user.email=x", *words],
        cwd=folder,
        check=True,
        env={**CLEAN, **environment},
        capture_output=True,
    )


def ci_run(folder):
    """Exit code and complaint of .ci/run in a checkout whose README shows no command."""
    done = subprocess.run([folder / ".ci" / "run"], text=True, capture_output=True, env=CLEAN)
    return done.returncode, done.stderr


@needs_git
def test_a_file_that_git_does_not_track_ends_ci(tmp_path):
    """In a folder of the project; not one that is ignored, nor notes at the top."""
    for name in ("wrcontact/known.py", "README.md", ".gitignore"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("*.so\n")
    for name in (".ci/run", ".ci/steps.py", "tests/__init__.py", "tests/helpers/turns.py"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    git(tmp_path, "init", "-q")
    git(tmp_path, "add", "-A")
    git(tmp_path, "commit", "-q", "-m", "x")
    for name in ("wrcontact/library.so", "notes.txt"):
        (tmp_path / name).write_text("")
    beyond = "README.md does not show the command"
    code, complaint = ci_run(tmp_path)
    assert code == 1 and beyond in complaint
    (tmp_path / "wrcontact" / "forgotten.py").write_text("")
    code, complaint = ci_run(tmp_path)
    assert code == 1 and beyond not in complaint
    assert complaint == (
        "not tracked by git, so no other copy has them: wrcontact/forgotten.py - git add "
        "them, or ignore them\n"
    )
    git(tmp_path, "add", "wrcontact/forgotten.py")
    assert beyond in ci_run(tmp_path)[1]
    left = subprocess.run(
        ["git", "status", "--porcelain"], cwd=tmp_path, text=True, capture_output=True
    ).stdout
    assert left == "A  wrcontact/forgotten.py\n?? notes.txt\n"


# --- steps ----------------------------------------------------------------------------------------

TWO_FAIL = """
import pytest

def test_passes():
    pass

@pytest.mark.parametrize("word", ["a - b", "c"])
def test_fails(word):
    assert word == "d"
"""


@pytest.fixture(scope="module")
def steps():
    """The program of .ci/run."""
    spec = importlib.util.spec_from_file_location("steps", ROOT / ".ci" / "steps.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def three(steps, tmp_path_factory):
    """A run of three steps: one fails, one has tests that fail, one passes."""
    folder = tmp_path_factory.mktemp("three")
    (folder / "test_two.py").write_text(TWO_FAIL)
    run = steps.Run(folder)
    assert not run.step("a line", "echo first && exit 3")
    words = [
        sys.executable,
        "-m",
        "pytest",
        "-q",
        "-c",
        os.devnull,
        "--rootdir",
        folder,
        "-p",
        "no:cacheprovider",
    ]
    assert not run.step("some tests", [*words, "test_two.py"], WRCONTACT_SKIPS="listed")
    assert run.step("the last", [sys.executable, "-c", "pass"])
    return run


@pytest.mark.full
def test_a_step_that_fails_does_not_end_ci(three):
    assert [done.code for done in three.done] == [3, 1, 0]
    assert all(0 < done.seconds < 300 and done.cpu >= 0 for done in three.done)
    assert three.done[1].cpu > 0.05


def test_what_a_step_says_is_shown(steps, tmp_path, capsys):
    run = steps.Run(tmp_path)
    run.step("a line", "echo α; echo complaint >&2; exit 3")
    assert capsys.readouterr().out == (
        "== a line (after 0 s)\nα\ncomplaint\n== a line has failed with exit code 3\n"
    )


def test_all_failures_are_reported_at_the_end_with_what_repeats_them(three):
    """The last line is as pytest's own, with the sums of all test runs; the line that failed is an error."""
    *lines, last = three.report().splitlines()
    assert "    echo first && exit 3" in lines
    for test in ("test_two.py::test_fails[c]", "test_two.py::test_fails[a - b]"):
        assert f"    WRCONTACT_SKIPS=listed .venv/bin/python -m pytest -m '' '{test}'" in lines
    (row,) = [line.split() for line in lines if line.endswith("some tests FAILED")]
    assert float(row[0]) >= 0 and float(row[1]) >= 0
    assert any(line.endswith("the last") for line in lines) and not any(
        "the last (exit" in line for line in lines
    )
    assert last.startswith("2 failed, 1 passed, 1 error in ")


def test_a_run_without_a_failure_tells_none(steps, tmp_path):
    run = steps.Run(tmp_path)
    assert run.step("tests", ["echo", "7 passed, 1 skipped, 2 warnings in 63.10s (0:01:03)"])
    assert run.step("more tests", ["echo", "==== 5 passed, 3 deselected in 1.00s ===="])
    assert "failed" not in run.report() and "repeats" not in run.report()
    assert run.report().splitlines()[-1].startswith("12 passed, 1 skipped, 3 deselected in ")


def test_a_program_that_is_missing_and_a_process_that_is_left_behind_end_no_run(steps, tmp_path):
    run = steps.Run(tmp_path)
    assert not run.step("missing", ["no-such-program-anywhere"])
    assert run.step("left behind", "sleep 20 & echo on")
    assert run.done[0].code == 127 and run.done[1].seconds < 15


def test_steps_side_by_side_are_steps(steps, tmp_path, capsys):
    """In their order, each with its own output and processor time, though the second ends first."""
    run = steps.Run(tmp_path)
    busy = "while time.process_time() < 0.3: pass"
    run.together(
        {
            "long": [sys.executable, "-c", f"import time\n{busy}\nprint('ended')"],
            "short": "echo 3 passed in 0.10s; exit 2",
        }
    )
    assert [(done.name, done.code, done.counts) for done in run.done] == [
        ("long", 0, ""),
        ("short", 2, "3 passed in 0.10s"),
    ]
    assert run.done[0].cpu > 0.29 > run.done[1].cpu
    seen = capsys.readouterr().out
    assert "-- long\nended\n" in seen
    assert "-- short\n3 passed in 0.10s\n== short has failed with exit code 2\n" in seen


def test_seconds_are_kept_from_run_to_run(steps, three, tmp_path):
    file = tmp_path / "new" / "seconds.csv"
    for commit in ("1234", "5678"):
        three.keep(file, commit)
    rows = list(csv.DictReader(file.open()))
    assert [(row["commit"], row["step"], row["exit_code"]) for row in rows] == [
        (commit, *step)
        for commit in ("1234", "5678")
        for step in (("a line", "3"), ("some tests", "1"), ("the last", "0"))
    ]
    assert all(float(row["seconds"]) >= 0 and float(row["cpu_seconds"]) >= 0 for row in rows)
    three.keep("/dev/null/no/folder", "9")  # where nothing can be written none is kept


# --- days -----------------------------------------------------------------------------------------


def test_what_is_weekly_exists():
    for name, paths in WEEKLY.items():
        place, _, test = name.partition("::")
        assert not name.startswith("tests/") or (ROOT / place).exists(), name
        assert not test or f"def {test.partition('[')[0]}" in (ROOT / place).read_text("utf-8"), name
        for path in paths:
            stem = ROOT / path
            assert stem.exists() or list(stem.parent.glob(f"{stem.name}*")), (name, path)
    steps = (ROOT / ".ci" / "steps.py").read_text(encoding="utf-8")
    assert all(f'due("{name}", ' in steps for name in WEEKLY if not name.startswith("tests/"))


def test_what_is_weekly_runs_once_a_week_and_where_its_files_have_changed():
    for name, paths in WEEKLY.items():
        days = [turn for turn in range(360, 360 + WEEK) if due(name, turn, ["CHANGELOG.md"])]
        assert len(days) == 1
        for changed in ([name.partition("::")[0]], [f"{paths[0]}x"], ["a", paths[-1]], None):
            assert all(due(name, turn, changed) for turn in range(WEEK))
    row = "tests/docs/test_tables.py::test_errors_are_those_of_today"
    assert due(f"{row}[table_errors]", 1, []) and due(f"{row}[table_errors]", 2, [])
    assert sum(due(f"{row}[worn_pairs]", turn, []) for turn in range(WEEK)) == 1
    assert sum(due("tests/loop/test_energy.py::test_x", turn, []) for turn in range(WEEK)) == 1
    assert due("tests/wear/test_run.py", 1, []) and due("anything", 2, [])


@needs_git
def test_changes_are_those_of_a_day_and_of_a_branch(tmp_path):
    """By the dates of the commits: a change from before counts only where the main branch does not have it."""

    def commit(name, day):
        (tmp_path / name).write_text(str(day))
        git(tmp_path, "add", "-A")
        date = f"2026-03-{day:02d}T12:00:00Z"
        git(tmp_path, "commit", "-q", "-m", "x", GIT_AUTHOR_DATE=date, GIT_COMMITTER_DATE=date)

    git(tmp_path, "init", "-q")
    assert changed_paths(tmp_path) is None
    commit("first", 1)
    assert changed_paths(tmp_path) is None  # nothing to compare with
    commit("second", 5)
    commit("third", 9)
    assert changed_paths(tmp_path) == ["third"]
    git(tmp_path, "update-ref", "refs/remotes/origin/main", "HEAD~2")
    assert changed_paths(tmp_path) == ["second", "third"]
    (tmp_path / "first").write_text("by hand")
    assert changed_paths(tmp_path) == ["first", "second", "third"]


# --- skips and turns ------------------------------------------------------------------------------

SKIPPED = f"""
import pytest

@pytest.mark.parametrize("reason", {[*PERMITTED]!r})
def test_on_the_list(reason):
    pytest.skip("this: " + reason)

def test_that_passes():
    pass
"""
#: Ways to be skipped without a word, by file.
UNLISTED = {
    "test_mark.py": 'import pytest\n@pytest.mark.skip(reason="no reason")\ndef test_mark():\n    pass\n',
    "test_call.py": 'import pytest\ndef test_call():\n    pytest.skip("no reason")\n',
    "test_file.py": 'import pytest\npytest.importorskip("no_such_package")\n',
}


@pytest.mark.full
def test_a_run_of_ci_fails_if_a_test_is_skipped_that_is_not_on_the_list(tmp_path):
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-q",
        "-p",
        "tests.conftest",
        "-c",
        os.devnull,
        "--rootdir",
        str(tmp_path),
        str(tmp_path),
    ]
    complaint = "skipped, and not on the list in tests/helpers/skips.py: "
    for files in ({"test_some.py": SKIPPED}, UNLISTED):
        for name, content in files.items():
            (tmp_path / name).write_text(content)
        run = subprocess.run(
            command, cwd=ROOT, text=True, capture_output=True, env={**CLEAN, "WRCONTACT_SKIPS": "listed"}
        )
        told = {
            line.removeprefix(complaint).partition(":")[0]
            for line in run.stdout.splitlines()
            if line.startswith(complaint)
        }
        assert told == (set(UNLISTED) if files is UNLISTED else set()), run.stdout
        assert run.returncode == (files is UNLISTED) and "1 passed" in run.stdout


TURNS = """
import pytest

@pytest.mark.turns(3)
@pytest.mark.parametrize("k", range(7))
def test_many(k):
    pass

@pytest.mark.turns(4)
@pytest.mark.parametrize("k", range(2))
def test_two(k):
    pass

@pytest.mark.turns(2)
def test_one():
    pass

@pytest.mark.parametrize("k", range(3))
def test_all(k):
    pass
"""

#: What is collected without a turn and in three turns, by one process.
EACH_TURN = """
import os, sys, pytest

for turn in ("", "364", "365", "366"):
    os.environ["WRCONTACT_TURN"] = turn
    print("a turn", flush=True)
    if pytest.main(sys.argv[1:]):
        sys.exit(1)
"""


@pytest.mark.full
def test_cases_take_turns(tmp_path):
    """Each turn has some of every test, few turns have all of them, and without a turn all of them run."""
    (tmp_path / "test_some.py").write_text(TURNS)
    words = ["-q", "--collect-only", "-p", "tests.conftest", "-c", os.devnull, "--rootdir"]
    run = subprocess.run(
        [sys.executable, "-c", EACH_TURN, *words, tmp_path, tmp_path],
        cwd=ROOT,
        text=True,
        capture_output=True,
        env=CLEAN,
    )
    assert run.returncode == 0, run.stdout
    every, *turns = (
        {line.partition("::")[2] for line in part.splitlines() if "::" in line}
        for part in run.stdout.split("a turn\n")[1:]
    )
    assert len(every) == 13 and set.union(*turns) == every
    for turn in turns:
        assert {name.partition("[")[0] for name in turn} == {"test_many", "test_two", "test_one", "test_all"}
        assert sum("many" in name for name in turn) in (2, 3) and sum("two" in name for name in turn) == 1
        assert sum("all" in name for name in turn) == 3
