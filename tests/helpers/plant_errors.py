"""Do the tests of `make check` see an error in the sources?  Plant one, run them, and see which test fails.

    python -m tests.helpers.plant_errors
        all errors of planted.py; exit code 1 if one is not seen
    python -m tests.helpers.plant_errors roll_sign hertz_power
        only these
    python -m tests.helpers.plant_errors roll_sign --tests tests/search tests/wheelset/test_forces.py
        and only the tests of these files and folders
    python -m tests.helpers.plant_errors --own
        and only those of the room or the file that the error names; of a file the full ones too
    python -m tests.helpers.plant_errors --full
        the full tests too
    python -m tests.helpers.plant_errors --list
        names, places and meanings
    python -m tests.helpers.plant_errors --share 6 --turn 3
        so many of those that one test file sees, and only that file; every turn has others
    python -m tests.helpers.plant_errors --random 20 --seed 1
        as many at random places of the kernel instead, to measure the tests; --room search: of this room of it,
        with the tests of the same room first; names choose among these
    python -m tests.helpers.plant_errors --lines 20 --seed 1
        plants nothing: so many lines of kernel, interface and FMUs at random, for errors by hand

Needs a C compiler. Each error is planted in a copy of the repository, never here, and the copy's kernel is
translated and compiled (plant_kernel.py). So the compiled kernel of a copy agrees with its source, and no test
sees an error by that alone. Tests that ask for no derivative run first, with a kernel that has none. In the end
the tests that have failed are run without any error, and have to pass. Every run works in folders of its own, so
several can run at a time, within a test run too.
"""

import argparse
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections import namedtuple
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from tests.helpers.paths import ROOT
from tests.helpers.plant_kernel import make_kernel
from tests.helpers.planted import ERRORS, planted, source_of
from tests.helpers.random_errors import drawn_lines, random_errors

#: Rooms whose tests run before the others: those of the kernel, the short ones first.
KERNEL_ROOMS = (
    "interface",
    "normal",
    "prepare",
    "system",
    "derivative",
    "contact",
    "wheelset",
    "search",
    "patch",
    "methods",
    "profiles",
    "study",
    "data",
    "halfspace",
)
#: Tests that report that something has changed and not what is right; this script's own ones
#: would see every error.
NO_WITNESS = (
    "tests/structure/test_planted_errors.py",
    "tests/docs/test_pages.py",
    "tests/docs/test_nomenclature.py",
    "tests/docs/test_doctests.py",
    "tests/binding/test_native_library.py::test_generated_c_is_of_this_source",
)
#: What is no part of a copy. Without conftest.py a copy's tests see the copy's wrcontact,
#: whatever is installed.
NOT_COPIED = shutil.ignore_patterns(
    ".git",
    ".venv",
    "venv",
    "__pycache__",
    ".*_cache",
    ".hypothesis",
    "*.so",
    "*.dylib",
    "*.dll",
    "build",
    "dist",
    "*.egg-info",
)
#: The tests end within this on a slow machine [s]; an error that keeps them running is seen.
PATIENCE = 1800

#: Exit codes of pytest: a wrong call, and no tests.
NO_TESTS = (4, 5)

Outcome = namedtuple("Outcome", "error seen test seconds")


def asks_for_derivatives(tree, name):
    """Whether a file of tests may ask the kernel for derivatives, which FMUs do."""
    return bool(re.search("derivativ|jacobian|fmu", (tree / name).read_text(encoding="utf-8"), re.IGNORECASE))


def run_tests(tree, tests, *options):
    """Exit code of pytest in a copy, None if it had no end, the first test that failed, and whether derivatives
    were missing."""
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-q",
        "-rfE",
        "-pno:cacheprovider",
        f"--basetemp={tree}.scratch",
        *options,
        *tests,
    ]
    # not what a test run tells its workers, whose folders are not this run's
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
    environment |= {
        "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",  # what plugins import takes longer than most tests
        "PYTHONPATH": str(tree),
        "WRCONTACT_KERNEL": "compiled",
        "COLUMNS": "1000",
        "WRCONTACT_TEST_CACHE": str(tree.parent / "kept"),
    }
    run = subprocess.Popen(
        command,
        cwd=tree,
        env=environment,
        text=True,
        errors="replace",
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        start_new_session=True,
    )
    try:
        said, _ = run.communicate(timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        os.killpg(run.pid, signal.SIGKILL)
        run.communicate()
        return None, "", False
    failed = re.search(r"^(?:FAILED|ERROR) (tests/.+?)(?: - .*)?$", said, re.MULTILINE)
    if run.returncode > 1:
        print(said[-3000:], file=sys.stderr)
    missing = re.search("undefined symbol: wrcontact_(derivative|jacobian)", said) is not None
    return run.returncode, failed[1] if failed else "", missing


def ordered_tests(tree, first, short):
    """The test files of a copy: those of the room or the file named first, of the kernel's rooms, and all
    others unless ``short``."""
    tests = tree / "tests"
    places = [tests / room for room in (first, *KERNEL_ROOMS)] + ([] if short else [tests])
    names = dict.fromkeys(
        path.relative_to(tree).as_posix()
        for place in places
        for path in ([place] if place.is_file() else sorted(place.rglob("test_*.py")))
    )
    return [name for name in names if name not in NO_WITNESS]


def own_tests(tree, error):
    """The test files of a copy that the error names, a room or a file."""
    return [
        name
        for name in ordered_tests(tree, error.first, True)
        if name == f"tests/{error.first}" or name.startswith(f"tests/{error.first}/")
    ]


def examine(error, plain, tests_of, options):
    """Compile the copy with the error in it and run the tests there, up to the first one that fails: those of
    the error's room that ask for no derivative with a kernel that has none, then the others."""
    begin = time.perf_counter()
    tree = copy_with(error, plain)
    tests = tests_of(error, tree)
    if tests == [f"tests/{error.first}"] and "-m" not in options:
        options = [*options, "-m", "not complete"]  # a file may have full tests alone
    left_out = [f"--deselect={name}" for name in NO_WITNESS if "::" in name]
    own = [name for name in tests if name.startswith(f"tests/{error.first}")]
    first = [name for name in own if (tree / name).is_file() and not asks_for_derivatives(tree, name)]
    seen = False
    for some, derivatives in ((first, False), ([name for name in tests if name not in first], True)):
        if seen or not some:
            continue
        make_kernel(tree, derivatives)
        code, test, missing = run_tests(tree, some, "-x", *left_out, *options)
        if missing and not derivatives:
            make_kernel(tree)
            code, test, _ = run_tests(tree, some, "-x", *left_out, *options)
        if code in NO_TESTS and len(some) == len(tests):
            raise RuntimeError(f"pytest ended with exit code {code}: it has not run what it was asked for")
        seen = code not in (0, *NO_TESTS)
        if code is None:
            test = "the tests had no end"
        elif seen and not test:
            test = f"the tests ended with exit code {code}"
    outcome = Outcome(error, seen, test, time.perf_counter() - begin)
    shutil.rmtree(tree)
    shutil.rmtree(f"{tree}.scratch", ignore_errors=True)
    print(row(outcome), flush=True)
    return outcome


def shared(count, turn):
    """So many errors that one file of tests sees without building an FMU, others in every ``turn``."""
    quick = [error for error in ERRORS if error.first.endswith(".py") and not error.first.startswith("fmu/")]
    return [quick[(turn * count + k) % len(quick)] for k in range(min(count, len(quick)))]


def row(outcome):
    error, test = outcome.error, outcome.test if outcome.seen else "NOT SEEN"
    return f"| {error.name} | {source_of(error).name} | {error.meaning} | {test} | {outcome.seconds:.0f} s |"


def copies(errors, folder):
    """A copy of the repository without error, and one with each of ``errors``, not yet translated."""
    plain = Path(folder, "plain")
    shutil.copytree(ROOT, plain, ignore=NOT_COPIED)
    (plain / "conftest.py").unlink()
    return plain, [copy_with(error, plain) for error in errors]


def copy_with(error, plain):
    """A copy of the copy ``plain`` with an error in it."""
    tree = plain.with_name(error.name)
    shutil.copytree(plain, tree)
    path = source_of(error, tree)
    path.write_bytes(planted(path.read_text(encoding="utf-8"), error).encode())
    return tree


def plant(errors, workers, tests, options=()):
    """Plant each error in a copy of its own and run there what ``tests`` gives for it; what came of it, and
    whether the tests that have failed pass without any error. ``options`` are pytest's."""
    with tempfile.TemporaryDirectory() as folder:
        plain, _ = copies([], folder)
        with ThreadPoolExecutor(workers) as pool:
            outcomes = list(pool.map(lambda error: examine(error, plain, tests, options), errors))
        seen_by = sorted({outcome.test for outcome in outcomes if outcome.test.startswith("tests/")})
        make_kernel(plain, any(asks_for_derivatives(plain, test.partition("::")[0]) for test in seen_by))
        chosen = options if "-m" in options else [*options, "-m", "not complete"]  # full ones were among them
        return outcomes, not seen_by or run_tests(plain, seen_by, *chosen)[0] == 0


def main(arguments=None):
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--list", action="store_true")
    parser.add_argument(
        "--workers", type=int, default=2, help="copies that are tested at a time (default: 2)"
    )
    parser.add_argument(
        "--own", action="store_true", help="run only the tests of the room or the file that the error names"
    )
    parser.add_argument("--short", action="store_true", help="run the kernel's tests only")
    parser.add_argument(
        "--full", action="store_true", help="run the full tests too, not only those of 'make check'"
    )
    parser.add_argument(
        "--tests", nargs="+", default=[], metavar="FILE", help="run only the tests of these files and folders"
    )
    parser.add_argument(
        "--share",
        type=int,
        default=0,
        metavar="N",
        help="plant so many that one test file sees, and run that file",
    )
    parser.add_argument("--turn", type=int, default=0, help="which share; each turn has other errors")
    parser.add_argument(
        "--random", type=int, default=0, metavar="N", help="plant so many errors at random places instead"
    )
    parser.add_argument("--room", default="", help="with --random: only in this room of the kernel")
    parser.add_argument(
        "--lines", type=int, default=0, metavar="N", help="plant nothing, but show so many lines at random"
    )
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args(arguments)
    drawn = list(random_errors(options.random, options.seed, options.room)) if options.random else ERRORS
    unknown = set(options.names) - {error.name for error in drawn}
    if unknown:
        parser.error(f"there is no error called {', '.join(sorted(unknown))}; --list tells the names")
    errors = [error for error in drawn if not options.names or error.name in options.names]
    if options.share:
        errors = shared(options.share, options.turn)
    if options.lines:
        print(*drawn_lines(options.lines, options.seed), sep="\n")
        return 0
    if options.list:
        for error in errors:
            print(f"{error.name:16} {source_of(error).name:22} {error.meaning}")
        return 0
    begin = time.perf_counter()
    print("| error | module | meaning | seen by | after |\n|---|---|---|---|---|", flush=True)

    def tests(error, tree):
        alone = [f"tests/{error.first}"] if options.share else own_tests(tree, error) if options.own else []
        return options.tests or alone or ordered_tests(tree, error.first, options.short)

    chosen = ["-m", "not complete"] if options.full or options.share else []
    outcomes, right = plant(errors, options.workers, tests, chosen)
    seen = sum(outcome.seen for outcome in outcomes)
    print(f"\n{seen} of {len(outcomes)} errors are seen, in {time.perf_counter() - begin:.0f} s")
    if not right:
        print("A test that has failed fails without any error, too.")
    return 0 if right and seen == len(outcomes) else 1


if __name__ == "__main__":
    sys.exit(main())
