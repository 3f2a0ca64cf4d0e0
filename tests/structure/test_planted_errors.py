"""The planted errors of plant_errors.py: each is still to be planted, and is seen by the tests of .ci/run."""

import ast
import os
import shutil
import subprocess
import sys

import pytest

from tests.helpers.paths import ROOT, TESTS
from tests.helpers.plant_errors import copies, ordered_tests, shared
from tests.helpers.plant_kernel import make_kernel
from tests.helpers.planted import ERRORS, planted, source_of
from tests.helpers.random_errors import drawn_lines, random_errors
from wrcontact.kernel.binding.compiler import find_compiler

#: Prints all bits of some patches.
BITS = """
import wrcontact
system = wrcontact.ContactSystem(normal_model="hertz")
table = system.evaluate_many([0.0, 1e-3, 4e-3, 6e-3], normal_force=8e4)
print(*(values.tobytes().hex() for values in (table.right.penetration, table.left.area, table.roll)))
"""


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


@pytest.mark.full
@pytest.mark.skipif(not find_compiler(), reason="no C compiler here")
def test_the_kernel_of_a_copy_has_the_bits_of_its_source(tmp_path):
    _, (tree,) = copies([error for error in ERRORS if error.name == "hertz_cell"], tmp_path)
    make_kernel(tree, derivatives=False)

    def bits(folder, kernel):
        chosen = os.environ | {"PYTHONPATH": str(folder), "WRCONTACT_KERNEL": kernel}
        command = [sys.executable, "-c", BITS]
        return subprocess.run(command, cwd=folder, env=chosen, check=True, stdout=subprocess.PIPE).stdout

    assert bits(tree, "compiled") == bits(tree, "python") != bits(ROOT, "python")


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
