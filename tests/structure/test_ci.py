"""What .ci/run refuses before it has run a test, and that no test is skipped without being missed."""

import os
import shutil
import subprocess
import sys

import pytest

from tests.helpers.paths import ROOT
from tests.helpers.skips import PERMITTED

CLEAN = {name: value for name, value in os.environ.items() if not name.startswith(("GIT_", "PYTEST_"))}


def git(folder, *words):
    subprocess.run(
        ["git", "-c", "user.name=x", "-c", "user.email=x", *words],
        cwd=folder,
        check=True,
        env=CLEAN,
        capture_output=True,
    )


def ci_run(folder):
    """Exit code and complaint of .ci/run in a checkout whose README shows no command."""
    done = subprocess.run([folder / ".ci" / "run"], text=True, capture_output=True, env=CLEAN)
    return done.returncode, done.stderr


@pytest.mark.skipif(not shutil.which("git"), reason="git is not installed")
def test_a_file_that_git_does_not_track_ends_ci(tmp_path):
    """In a folder of the project; not one that is ignored, nor notes at the top."""
    for name in (".ci/run", "wrcontact/known.py", "README.md"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("*.so\n")
    shutil.copy(ROOT / ".ci" / "run", tmp_path / ".ci" / "run")
    (tmp_path / ".gitignore").write_text("*.so\n")
    git(tmp_path, "init", "-q")
    git(tmp_path, "add", "-A")
    git(tmp_path, "commit", "-q", "-m", "x")
    for name in ("wrcontact/library.so", "notes.txt"):
        (tmp_path / name).write_text("")
    beyond = "README.md does not show the command"
    assert ci_run(tmp_path)[0] == 1 and beyond in ci_run(tmp_path)[1]
    (tmp_path / "wrcontact" / "forgotten.py").write_text("")
    code, complaint = ci_run(tmp_path)
    assert code == 1 and beyond not in complaint
    assert complaint == (
        "not tracked by git, so no other copy has them: wrcontact/forgotten.py - git add "
        "them, or ignore them\n"
    )
    git(tmp_path, "add", "wrcontact/forgotten.py")
    assert beyond in ci_run(tmp_path)[1]


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


@pytest.mark.full
def test_cases_take_turns(tmp_path):
    """Each turn has some of every test, few turns have all of them, and without a turn all of them run."""
    (tmp_path / "test_some.py").write_text(TURNS)
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-q",
        "--collect-only",
        "-p",
        "tests.conftest",
        "-c",
        os.devnull,
        "--rootdir",
        str(tmp_path),
        str(tmp_path),
    ]

    def collected(turn=""):
        run = subprocess.run(
            command, cwd=ROOT, text=True, capture_output=True, env={**CLEAN, "WRCONTACT_TURN": turn}
        )
        assert run.returncode == 0, run.stdout
        return {line.partition("::")[2] for line in run.stdout.splitlines() if "::" in line}

    every, turns = collected(), [collected(str(day)) for day in (364, 365, 366)]
    assert len(every) == 13 and set.union(*turns) == every
    for turn in turns:
        assert {name.partition("[")[0] for name in turn} == {"test_many", "test_two", "test_one", "test_all"}
        assert sum("many" in name for name in turn) in (2, 3) and sum("two" in name for name in turn) == 1
        assert sum("all" in name for name in turn) == 3
