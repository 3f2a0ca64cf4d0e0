"""Outside the package there is no circle: data and tools stand first, then benchmarks, then scripts of pages;
tests read them and nothing reads tests."""

import ast
from functools import cache

import pytest

from tests.helpers.paths import ROOT
from tests.helpers.sources import parsed

#: What the modules of a folder may import of the repository, besides their own folder.
MAY_IMPORT = {
    "wrcontact": set(),
    "data": {"wrcontact"},
    "examples": {"wrcontact"},
    "tools": {"wrcontact"},
    "benchmarks": {"wrcontact", "data", "tools"},
    "docs": {"wrcontact", "data", "examples", "benchmarks", "tools"},
    "tests": {"wrcontact", "data", "examples", "tools"},
}
#: Folders of tests that test the benchmarks, and what they write into the pages.
OF_BENCHMARKS = {"tests/benchmarks", "tests/docs"}
#: Modules with functions and numbers that several files of tests share.
SHARED = ("tests.helpers", "tests.conftest")


@cache
def imported(path):
    """Names of the modules that a file imports by absolute names, anywhere in it."""
    names = []
    for node in ast.walk(parsed(path)):
        if isinstance(node, ast.Import):
            names += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and not node.level:
            names += [f"{node.module}.{alias.name}" for alias in node.names]
    return names


def files(folder):
    return sorted(path for path in (ROOT / folder).rglob("*.py") if "generated" not in path.parts)


@pytest.mark.full
@pytest.mark.parametrize("folder", MAY_IMPORT)
def test_folders_read_what_stands_before_them(folder):
    found = set()
    for path in files(folder):
        permitted = {folder} | MAY_IMPORT[folder]
        if path.relative_to(ROOT).parent.as_posix() in OF_BENCHMARKS:
            permitted.add("benchmarks")
        found |= {
            (path.relative_to(ROOT).as_posix(), name)
            for name in imported(path)
            if name.split(".")[0] in set(MAY_IMPORT) - permitted
        }
    assert not found


def test_no_test_imports_another():
    found = {
        (path.relative_to(ROOT).as_posix(), name)
        for path in files("tests")
        for name in imported(path)
        if name.startswith("tests.") and not name.startswith(SHARED)
    }
    assert not found


def test_independent_programs_do_not_import_the_package():
    """The witnesses in data: what they compute is compared with the package."""
    for name in (
        "brute_force",
        "conformal_reference",
        "find_jumps",
        "halfspace_reference",
        "hertz",
        "hunting_theory",
    ):
        assert not any(
            found.startswith(("wrcontact", "examples")) for found in imported(ROOT / "data" / f"{name}.py")
        ), name
