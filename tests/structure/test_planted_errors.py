"""The planted errors of plant_errors.py: each is still to be planted, and is seen by the tests of .ci/run."""

import ast
import shutil
import subprocess
import sys

import pytest

from tests.helpers.paths import ROOT, TESTS
from tests.helpers.plant_errors import copies, ordered_tests, shared
from tests.helpers.plant_kernel import changed_files, generated
from tests.helpers.planted import ERRORS, planted, source_of
from tests.helpers.random_errors import drawn_lines, random_errors
from tools.transpile_kernel import translate


@pytest.mark.full
@pytest.mark.parametrize("error", ERRORS, ids=lambda error: error.name)
def test_an_error_can_be_planted_in_today_s_sources(error):
    text = source_of(error).read_text(encoding="utf-8")
    changed = planted(text, error)
    assert changed != text
    if source_of(error).suffix == ".py":
        assert ast.dump(ast.parse(changed)) != ast.dump(ast.parse(text))
    assert (TESTS / error.first).is_file() or list((TESTS / error.first).glob("test_*.py"))


def test_names_are_unique():
    assert len({error.name for error in ERRORS}) == len(ERRORS) >= 10


def test_turns_of_a_share_come_to_every_error_that_a_file_sees():
    quick = {error.name for error in ERRORS if error.first.endswith(".py") and "fmu/" not in error.first}
    turns = [{error.name for error in shared(6, turn)} for turn in range(len(quick) // 6 + 1)]
    assert set().union(*turns) == quick and all(len(turn) == 6 for turn in turns)


@pytest.mark.full
def test_random_errors_can_be_planted():
    for error in random_errors(20, seed=3):
        text = source_of(error).read_text(encoding="utf-8")
        assert ast.dump(ast.parse(planted(text, error))) != ast.dump(ast.parse(text)), error


def test_lines_at_random_are_the_same_for_a_seed():
    lines = drawn_lines(30, seed=5)
    assert lines == drawn_lines(30, seed=5) != drawn_lines(30, seed=6)
    for line in lines:
        name, number, text = line.split(":", 2)
        assert (ROOT / name).read_text(encoding="utf-8").splitlines()[int(number) - 1].strip() == text.strip()


def test_the_tests_of_an_error_s_room_run_first_and_all_others_after_them():
    names = ordered_tests(ROOT, "search", False)
    assert names[0].startswith("tests/search/") and len(set(names)) == len(names) > 80
    assert ordered_tests(ROOT, "search/test_rigid.py", True)[0] == "tests/search/test_rigid.py"
    assert all((ROOT / name).is_file() for name in names)


@pytest.mark.complete
def test_a_copy_is_translated_as_the_kernel_is(tmp_path):
    plain, (tree,) = copies([error for error in ERRORS if error.name == "hertz_cell"], tmp_path)
    files = changed_files(plain, tree)
    there = {path.name: path.read_text(encoding="utf-8") for path in generated(plain).glob("*.[ch]")}
    assert there | files == translate(tree / "wrcontact" / "kernel") != there


@pytest.mark.complete
@pytest.mark.skipif(not (shutil.which("gcc") or shutil.which("cc")), reason="no C compiler here")
def test_every_planted_error_is_seen():
    run = subprocess.run(
        [sys.executable, "-m", "tests.helpers.plant_errors", "--full"],
        cwd=ROOT,
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
    )
    assert run.returncode == 0, run.stdout
