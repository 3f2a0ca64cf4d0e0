"""Errors at random places, to measure the tests, and lines at random for errors by hand."""

import ast
import random
import re
from functools import cache

from tests.helpers.paths import ROOT
from tests.helpers.planted import Error


def random_errors(count, seed, room=""):
    """Errors at random places of the kernel's functions, or of those of one ``room``: another operator,
    comparison or constant."""
    from tools.transpile_kernel import flat_name

    places = [
        (path, *place)
        for path in kernel_modules()
        if room in ("", path.parent.name)
        for place in changes(path.read_text(encoding="utf-8"))
    ]
    for number, (path, at, old, new, line) in enumerate(random.Random(seed).sample(places, count)):
        text = path.read_text(encoding="utf-8")
        # so much around the place that it is there once
        reach = next(
            reach
            for reach in range(len(text))
            if text.count(text[max(at - reach, 0) : at + len(old) + reach]) == 1
        )
        before, after = text[max(at - reach, 0) : at], text[at + len(old) : at + len(old) + reach]
        yield Error(
            f"random_{room}{seed}_{number}",
            before + old + after,
            before + new + after,
            f"line {line}: {old} -> {new} in {text.splitlines()[line - 1].strip()}",
            room or "normal",
            flat_name(path),
        )


def drawn_lines(count, seed):
    """``path:number: text`` of so many lines of kernel, interface and FMUs at random, without imports,
    comments and docstrings; each is a place for an error of one word by hand."""
    return random.Random(seed).sample(all_lines(), count)


@cache
def all_lines():
    return [
        f"{path.relative_to(ROOT).as_posix()}:{number}: {text.strip()}"
        for path in drawn_files()
        for number, text in code_lines(path)
    ]


def drawn_files():
    """The files of the kernel, of the interface and of the FMUs."""
    others = [
        path
        for folder, pattern in (
            ("wrcontact/interface", "*.py"),
            ("wrcontact/fmu", "*.py"),
            ("fmu_src", "*.py"),
            ("fmu_src/native", "*.c"),
        )
        for path in sorted((ROOT / folder).glob(pattern))
    ]
    return [*kernel_modules(), *others]


def code_lines(path):
    """(Number, text) of the lines that compute or state something."""
    lines = list(enumerate(path.read_text(encoding="utf-8").splitlines(), 1))
    if path.suffix == ".c":
        return [
            (n, text)
            for n, text in lines
            if re.search(r"[=+*<>?&|-]", text) and not re.match(r"\s*(/\*|\*|//|#)|.*\*/$", text)
        ]
    taken = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        words = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
        if (
            isinstance(node, (ast.stmt, ast.keyword))
            and not words
            and not hasattr(node, "body")
            and not (isinstance(node, (ast.Import, ast.ImportFrom)))
        ):
            taken |= set(range(node.lineno, node.end_lineno + 1))
        elif isinstance(node, (ast.If, ast.While)):
            taken.add(node.lineno)
    empty = re.compile(r"\s*(#|return$|[\])}]*,?$)")
    return [(n, text) for n, text in lines if n in taken and not empty.match(text)]


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
        match = re.search(
            "|".join(map(re.escape, sorted(words, key=len, reverse=True))),
            text[begin : place(right.lineno, right.col_offset)],
        )
        return (begin + match.start(), match[0], words[match[0]], text.count("\n", 0, begin) + 1)

    signs = {"+": "-", "-": "+"}
    comparisons = {"<": ">", ">": "<", "<=": ">", ">=": "<", "==": "!=", "!=": "=="}
    for function in ast.parse(text).body:
        if not isinstance(function, ast.FunctionDef):
            continue
        nodes = [node for statement in function.body for node in ast.walk(statement)]
        places = {
            inner for node in nodes if isinstance(node, ast.Subscript) for inner in ast.walk(node.slice)
        }
        for node in [node for node in nodes if node not in places]:
            if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Sub)):
                yield between(node.left, node.right, signs)
            elif isinstance(node, ast.AugAssign) and isinstance(node.op, (ast.Add, ast.Sub)):
                yield between(node.target, node.value, signs)
            elif isinstance(node, ast.Compare):
                yield between(node.left, node.comparators[0], comparisons)
            elif isinstance(node, ast.Constant) and type(node.value) in (int, float):
                at = place(node.lineno, node.col_offset)
                old = text[at : place(node.end_lineno, node.end_col_offset)]
                other = (
                    node.value + 1 if isinstance(node.value, int) or node.value == 0.0 else 1.1 * node.value
                )
                yield at, old, repr(other), node.lineno
