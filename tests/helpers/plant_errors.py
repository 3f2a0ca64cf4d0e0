"""Do the quick tests see an error in the kernel?  Plant one, run them, and see which test fails.

    python -m tests.helpers.plant_errors all errors below; exit code 1 if one is not seen python -m
    tests.helpers.plant_errors roll_sign hertz_power only these python -m tests.helpers.plant_errors --list
    names, places and meanings python -m tests.helpers.plant_errors --random 20 --seed 1 as many at random
    places instead, to measure the tests

Needs Pyccel (``pip install ".[dev]"``) and a C compiler. Each error is planted in a copy of the repository,
never here, and the copy's kernel is translated and compiled as tools/transpile_kernel.py and
tools/compile_kernel.py do it. So the compiled kernel of a copy agrees with its source, and no test sees an
error by that alone. All copies are translated in one run of Pyccel: a module with an error stands there
beside the others, under another name, since what it calls and what calls it is translated as before. In the
end the tests that have failed are run without any error, and have to pass.
"""

import argparse
import ast
import copy
import os
import random
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

from tests.helpers.paths import ROOT, TESTS

#: ``old`` occurs once in the kernel, and is replaced by ``new``; the tests in the room
#: ``first`` run before all others. ``module`` is the flat name of the file; without it the
#: file is the one in which ``old`` occurs.
Error = namedtuple("Error", "name old new meaning first module", defaults=[""])

ERRORS = [
    Error("roll_sign", "difference = sides[1].best - sides[0].best\n    rate",
          "difference = sides[1].best + sides[0].best\n    rate",
          "a sign in the equation of the roll", "search"),
    Error("missed_minimum", "    walk(tables, side, state, node, -1, 0)",
          "    walk(tables, side, state, node, 1, 1)",
          "the gap is searched to one side only: a minimum on the other is missed", "search"),
    Error("stale_minima", "if known == 1 and before_left ==", "if known == 1 or before_left ==",
          "the minima of the step before are taken though the search has found a smaller one", "search"),
    Error("stale_outputs", "workspace.known = False", "workspace.known = True",
          "after a step that failed, its inputs count as those of the outputs", "wheelset"),
    Error("swapped_loads", "sign = float(2 * index - 1)", "sign = float(1 - 2 * index)",
          "load is transferred to the other side", "normal"),
    Error("mirror_yaw", "mirrored.sin_yaw = -place.sin_yaw", "mirrored.sin_yaw = place.sin_yaw",
          "the left wheel is mirrored without its yaw", "search"),
    Error("yaw_term", "(around * around / r - bend * e2 * e2) / steep", "around * around / (r * steep)",
          "the longitudinal curvature lacks its term of yaw", "normal"),
    Error("wrong_profile", "(tables.rail_curvature, abscissa)", "(tables.wheel_curvature, abscissa)",
          "the rail's curvature is read in the wheel's table", "contact"),
    Error("off_profile", "    if fabs(mismatch) >= PARALLEL:", "    if fabs(mismatch) >= 1e9:",
          "a wheel on the end of a profile is not reported by its status", "search"),
    Error("hertz_power", "stiffness)) ** (2.0 / 3.0)", "stiffness)) ** (3.0 / 4.0)",
          "the power 3/4 for Hertz's 2/3", "normal"),
    Error("hertz_cell", "at = HERTZ_ROW * cell + column",
          "at = HERTZ_ROW * (cell + 1) + column",
          "Hertz's table is read one cell too far", "normal"),
    Error("analyn_axes", "beta = table_value(table, 0, log(A / side))",
          "beta = table_value(table, 0, log(side / A))",
          "ANALYN's 1 + beta is taken for the other axis", "normal"),
    Error("last_node", "region.last = after", "region.last = after - 1", "a region ends one node early",
          "normal"),
    Error("isolated_patches", "    result *= planes_cosine(one, other)",
          "    result *= 0.0 * planes_cosine(one, other)", "patches side by side do not press on each other",
          "normal"),
    Error("early_end", "NEARLY_SHARP: Final[float] = 1e-9", "NEARLY_SHARP: Final[float] = 1e-4",
          "Newton's method for the force gives up some steps early", "normal"),
    Error("strip_near", "row[j] += near_share(", "row[j] -= near_share(",
          "the correction of neighbouring strips has the wrong sign", "normal"),
    Error("elastic_loads", "outcome = balance_side(tables, work, state, 1, right, height)",
          "outcome = balance_side(tables, work, state, 1, left, height)",
          "the right elastic wheel carries the left one's load", "wheelset"),
    Error("elastic_sharp", "ELASTIC_SHARP: Final[float] = 1e-11", "ELASTIC_SHARP: Final[float] = 1e-7",
          "the elastic equilibrium is found to a tolerance a thousand times wider", "tangent"),
    Error("moment", "resultant[3] += y * force_z - z * force_y", "resultant[3] += y * force_z + z * force_y",
          "a sign in the moment of a patch", "wheelset"),
    Error("piece", "-15.0 * rest + 7.0 * slope - bend", "-15.0 * rest + 8.0 * slope - bend",
          "a wrong coefficient of the profiles' quintics", "prepare"),
    Error("scan_bound", "cell.least_bends[exponent] = least", "cell.least_bends[exponent] = most",
          "the search takes the rail's largest bend for its smallest one", "search"),
    Error("tangent_rule", "y = moving(y, -mismatch / held(rate))", "y = moving(y, mismatch / held(rate))",
          "the contact moves the wrong way in the derivatives", "tangent"),
]

#: Rooms whose tests run before the others: those of the kernel, the short ones first.
KERNEL_ROOMS = ("normal", "prepare", "system", "tangent", "contact", "wheelset", "search", "patch", "methods",
                "profiles", "study", "reference", "reference_theory")
#: Tests that report that something has changed and not what is right; this script's own ones
#: would see every error.
NO_WITNESS = ("tests/study/test_figures.py::test_documentation_has_today_s_numbers",
              "tests/structure/test_planted_errors.py",
              "tests/binding/test_native_library.py::test_generated_c_is_of_this_source")
#: What is no part of a copy. Without conftest.py a copy's tests see the copy's wrcontact,
#: whatever is installed.
NOT_COPIED = shutil.ignore_patterns(".git", ".venv", "venv", "__pycache__", ".*_cache", ".hypothesis", "*.so",
                                    "*.dylib", "*.dll", "build", "dist", "*.egg-info")
#: The quick tests end within this on a slow machine [s]; an error that keeps them running is seen.
PATIENCE = 1800

Outcome = namedtuple("Outcome", "error seen test seconds")


def planted(text, error):
    """``text`` of the module with the error in it."""
    found = text.count(error.old)
    if found != 1:
        raise ValueError(f"{error.name}: {error.old!r} occurs {found} times, and should occur once")
    return text.replace(error.old, error.new)


def source_of(error, root=ROOT):
    """The kernel's file in which the error is planted."""
    from tools.transpile_kernel import FILES, flat_name

    paths = FILES["kernel_modules"](root / "wrcontact" / "kernel")
    if error.module:
        return next(path for path in paths if flat_name(path) == error.module)
    found = [path for path in paths if error.old in path.read_text(encoding="utf-8")]
    if len(found) != 1:
        raise ValueError(f"{error.name}: {error.old!r} occurs in {len(found)} files of the kernel, and "
                         f"should occur in one")
    return found[0]


def random_errors(count, seed):
    """Errors at random places of the kernel's functions: another operator, comparison or constant."""
    from tools.transpile_kernel import flat_name

    places = [(path, *place) for path in kernel_modules()
              for place in changes(path.read_text(encoding="utf-8"))]
    for number, (path, at, old, new, line) in enumerate(random.Random(seed).sample(places, count)):
        text = path.read_text(encoding="utf-8")
        # so much around the place that it is there once
        reach = next(reach for reach in range(len(text))
                     if text.count(text[max(at - reach, 0):at + len(old) + reach]) == 1)
        before, after = text[max(at - reach, 0):at], text[at + len(old):at + len(old) + reach]
        yield Error(f"random_{seed}_{number}", before + old + after, before + new + after,
                    f"line {line}: {old} -> {new} in {text.splitlines()[line - 1].strip()}", "normal",
                    flat_name(path))


def kernel_modules():
    from tools.transpile_kernel import FILES, KERNEL

    return [path for path in FILES["kernel_modules"](KERNEL) if path.parent.name != "layout"]


def changes(text):
    """(place, old, new, line) of what can be changed in a module's functions without changing a type: signs,
    comparisons and constants, but for those in an index, which soon end outside an array."""
    starts = [0]
    for line in text.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))

    def place(line, column):
        return starts[line - 1] + column

    def between(left, right, words):
        begin = place(left.end_lineno, left.end_col_offset)
        match = re.search("|".join(map(re.escape, sorted(words, key=len, reverse=True))),
                          text[begin:place(right.lineno, right.col_offset)])
        return (begin + match.start(), match[0], words[match[0]], text.count("\n", 0, begin) + 1)

    signs = {"+": "-", "-": "+"}
    comparisons = {"<": ">", ">": "<", "<=": ">", ">=": "<", "==": "!=", "!=": "=="}
    for function in ast.parse(text).body:
        if not isinstance(function, ast.FunctionDef):
            continue
        body = function.body
        if (sum(isinstance(node, ast.Return) for node in ast.walk(function)) == 1
            and ast.unparse(body[-1]) == "return 0"):
            body = body[:-1]                                    # nobody reads it
        nodes = [node for statement in body for node in ast.walk(statement)]
        places = {inner for node in nodes if isinstance(node, ast.Subscript)
                  for inner in ast.walk(node.slice)}
        for node in [node for node in nodes if node not in places]:
            if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Sub)):
                yield between(node.left, node.right, signs)
            elif isinstance(node, ast.AugAssign) and isinstance(node.op, (ast.Add, ast.Sub)):
                yield between(node.target, node.value, signs)
            elif isinstance(node, ast.Compare):
                yield between(node.left, node.comparators[0], comparisons)
            elif isinstance(node, ast.Constant) and type(node.value) in (int, float):
                at = place(node.lineno, node.col_offset)
                old = text[at:place(node.end_lineno, node.end_col_offset)]
                other = node.value + 1 if isinstance(node.value,
                                                     int) or node.value == 0.0 else 1.1 * node.value
                yield at, old, repr(other), node.lineno


def translate_all(trees):
    """Generated files of the kernels in ``trees``, in one run of Pyccel; the first one is without error."""
    import tools.transpile_kernel as tool

    kernels = [tree / "wrcontact" / "kernel" for tree in trees]
    of_kernel = [tool.read_modules(kernel) for kernel in kernels]
    plain = {module.name: module for module in of_kernel[0]}
    # (number of the kernel, name): the module under another name
    others = {}
    for number, modules in enumerate(of_kernel):
        for module in modules:
            if module.text != plain[module.name].text:
                other = others[number, module.name] = copy.copy(module)
                other.name = f"{module.name}_v{number}"
                other.path = module.path.with_name(f"{other.name}.py")
    raw = tool.run_pyccel([*plain.values(), *others.values()])
    for number, (kernel, modules) in enumerate(zip(kernels, of_kernel)):
        own = {name: raw[name] for name in plain}
        for (of, name), other in others.items():
            if of == number:
                own[name] = tuple(text.replace(other.name, name) for text in raw[other.name])
        yield tool.assemble(kernel, modules, own)


def compile_tree(tree):
    """Compile the copy's kernel; with less optimising the bits are the same, and the compiler
    is done in half the time."""
    code = "import kernel_compiler as k; k.compile_library(k.KERNEL, extra_flags=['-O1'])"
    subprocess.run([sys.executable, "-c", code], cwd=tree / "build_hooks", check=True)


def run_tests(tree, tests, *options):
    """Exit code of pytest in a copy, None if it had no end, and the first test that failed."""
    command = [sys.executable, "-m", "pytest", "-q", "-rfE", "-p", "no:cacheprovider", *options, *tests]
    environment = {**os.environ, "PYTHONPATH": str(tree), "WRCONTACT_KERNEL": "compiled", "COLUMNS": "1000"}
    run = subprocess.Popen(command, cwd=tree, env=environment, text=True, errors="replace",
                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True)
    try:
        said, _ = run.communicate(timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        os.killpg(run.pid, signal.SIGKILL)
        run.communicate()
        return None, ""
    failed = re.search(r"^(?:FAILED|ERROR) (tests/.+?)(?: - .*)?$", said, re.MULTILINE)
    if run.returncode > 1:
        print(said[-3000:], file=sys.stderr)
    return run.returncode, failed[1] if failed else ""


def ordered_tests(first, short):
    """The test files: those of the room named first, of the kernel's rooms, and all
    others unless ``short``."""
    folders = [TESTS / room for room in (first, *KERNEL_ROOMS)] + ([] if short else [TESTS])
    names = dict.fromkeys(path.relative_to(ROOT).as_posix() for folder in folders
                          for path in sorted(folder.rglob("test_*.py")))
    return [name for name in names if name not in NO_WITNESS]


def examine(error, tree, short):
    """Compile the copy with the error in it and run the tests there, up to the first one that fails."""
    compile_tree(tree)
    begin = time.perf_counter()
    left_out = [f"--deselect={name}" for name in NO_WITNESS if "::" in name]
    code, test = run_tests(tree, ordered_tests(error.first, short), "-x", *left_out)
    if code is None:
        test = "the tests had no end"
    elif code != 0 and not test:
        test = f"the tests ended with exit code {code}"
    outcome = Outcome(error, code != 0, test, time.perf_counter() - begin)
    shutil.rmtree(tree)
    print(row(outcome), flush=True)
    return outcome


def row(outcome):
    error, test = outcome.error, outcome.test if outcome.seen else "NOT SEEN"
    return f"| {error.name} | {source_of(error).name} | {error.meaning} | {test} | {outcome.seconds:.0f} s |"


def copies(errors, folder):
    """A copy of the repository without error, and one with each of ``errors``, not yet translated."""
    plain, *trees = [Path(folder, name) for name in ["plain", *(error.name for error in errors)]]
    shutil.copytree(ROOT, plain, ignore=NOT_COPIED)
    (plain / "conftest.py").unlink()
    for error, tree in zip(errors, trees):
        shutil.copytree(plain, tree)
        path = source_of(error, tree)
        path.write_bytes(planted(path.read_text(encoding="utf-8"), error).encode())
    return plain, trees


def plant(errors, workers, short):
    """Plant each error in a copy of its own and run the tests there; what came of it, and whether the tests
    that have failed pass without any error."""
    with tempfile.TemporaryDirectory() as folder:
        plain, trees = copies(errors, folder)
        for tree, files in zip([plain, *trees], translate_all([plain, *trees])):
            for name, text in files.items():
                (tree / "wrcontact" / "kernel" / "generated" / name).write_bytes(text.encode())
        with ThreadPoolExecutor(workers) as pool:
            outcomes = list(pool.map(lambda pair: examine(*pair, short), zip(errors, trees)))
        compile_tree(plain)
        seen_by = sorted({outcome.test for outcome in outcomes if outcome.test.startswith("tests/")})
        return outcomes, not seen_by or run_tests(plain, seen_by)[0] == 0


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--workers", type=int, default=2,
                        help="copies that are tested at a time (default: 2)")
    parser.add_argument("--short", action="store_true",
                        help="run the kernel's tests only, not all quick tests")
    parser.add_argument("--random", type=int, default=0, metavar="N",
                        help="plant so many errors at random places instead")
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args(arguments)
    unknown = set(options.names) - {error.name for error in ERRORS}
    if unknown:
        parser.error(f"there is no error called {', '.join(sorted(unknown))}; --list tells the names")
    errors = list(random_errors(options.random, options.seed)) if options.random else [
        error for error in ERRORS if not options.names or error.name in options.names]
    if options.list:
        for error in errors:
            print(f"{error.name:16} {source_of(error).name:22} {error.meaning}")
        return 0
    begin = time.perf_counter()
    print("| error | module | meaning | seen by | after |\n|---|---|---|---|---|", flush=True)
    outcomes, right = plant(errors, options.workers, options.short)
    seen = sum(outcome.seen for outcome in outcomes)
    print(f"\n{seen} of {len(outcomes)} errors are seen, in {time.perf_counter() - begin:.0f} s")
    if not right:
        print("A test that has failed fails without any error, too.")
    return 0 if right and seen == len(outcomes) else 1


if __name__ == "__main__":
    sys.exit(main())
