"""The structure of the code: which room imports which, how long files and functions are.

A room is a folder of the package, or a module at its top. Rooms stand in one order; a module imports from its
own room and from rooms before it, and no modules import each other in a circle. A function that needs more
lines or arguments than the limits says so in its docstring, in a line that starts with "Long because" or
"Many arguments because".
"""

import ast
import re
from functools import cache

import pytest

from tests.helpers.paths import ROOT
from tests.helpers.sources import parsed
from wrcontact.kernel.binding.files import ROOMS

PACKAGE = ROOT / "wrcontact"
#: Rooms from upstream to downstream.
ORDER = (
    "version",
    "storage",
    "progress",
    "conventions",
    "methods",
    "interface",
    *(f"kernel.{room}" for room in ROOMS),
    "kernel.binding",
    "profiles",
    "sections",
    "results",
    "keywords",
    "status",
    "state",
    "motion",
    "stepper",
    "workers",
    "halfspace",
    "creep",
    "linear",
    "system",
    "wheel",
    "track",
    "export",
    "sweeps",
    "simulation",
    "conditioning",
    "wear",
    "plots",
    "fleet",
    "study",
    "fmu",
    "cli",
)
#: What a user holds; nothing else stands loose at the top of the package.
TOP = {"system", "wheel", "stepper", "state", "status", "conventions", "version", "workers", "keywords"}
CODE = ("wrcontact", "fmu_src", "build_hooks", "tools", "benchmarks", "docs", "examples")

#: Statements are counted, not lines, which are the formatter's; of C, which has none, the lines.
FILE_STATEMENTS = 290
C_LINES = 399
FUNCTION_STATEMENTS = 55
MOST_ARGUMENTS = 8  # without self
REASONS = {"statements": "Long because", "arguments": "Many arguments because"}

#: Known exceptions, which have to shrink to nothing: a test fails when one is no longer needed.
BACK_IMPORTS = set()
LONG_FILES = set()
#: (File, function, what exceeds the limit.)
LARGE_FUNCTIONS = set()


def modules():
    """Path of every module of the package by its name without ``wrcontact.``; packages by their own name."""
    found = {}
    for path in sorted(PACKAGE.rglob("*.py")):
        parts = path.relative_to(PACKAGE).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


MODULES = modules()


@cache
def trees():
    return {name: parsed(path) for name, path in MODULES.items()}


def targets(name, node):
    """(Module, name or None) of everything that an import statement of the module ``name``
    reads, in the package."""
    parts = name.split(".") if name else []
    package = parts if MODULES[name].name == "__init__.py" else parts[:-1]
    if isinstance(node, ast.Import):
        for alias in node.names:
            if alias.name.split(".")[0] == PACKAGE.name:
                yield ".".join(alias.name.split(".")[1:]), None
    elif isinstance(node, ast.ImportFrom):
        inside = (node.module or "").split(".") if node.module else []
        if not node.level and inside[0] != PACKAGE.name:
            return
        base = [*package[: len(package) - node.level + 1], *inside] if node.level else inside[1:]
        yield from ((".".join(base), alias.name) for alias in node.names)
    elif isinstance(node, ast.Call) and getattr(node.func, "id", None) == "import_module":
        words = node.args[0].value
        dots = len(words) - len(words.lstrip("."))
        yield ".".join([*package[: len(package) - dots + 1], words.lstrip(".")]), None


def home(module, name):
    """The module that ``from module import name`` reads: a submodule, or where a package's
    face has the name from."""
    if name is None or name == "*":
        return module
    if ".".join(filter(None, (module, name))) in MODULES:
        return ".".join(filter(None, (module, name)))
    if module in MODULES and MODULES[module].name == "__init__.py":
        for node in trees()[module].body:
            if isinstance(node, ast.ImportFrom) and any(alias.name == name for alias in node.names):
                return next(home(*target) for target in targets(module, node) if target[1] == name)
    return module


@cache
def imports():
    """Modules that each module imports, anywhere in it; the package's own face, which hands
    names on, imports nothing."""
    return {
        name: {home(*target) for node in ast.walk(tree) for target in targets(name, node)} - {name, ""}
        for name, tree in trees().items()
        if name
    }


def room(name):
    parts = name.split(".")
    return ".".join(parts[:2]) if parts[0] == "kernel" and len(parts) > 1 else parts[0]


def test_every_module_has_a_room():
    assert {room(name) for name in imports()} - {"kernel"} == set(ORDER)
    assert {path.stem for path in PACKAGE.glob("*.py")} - {"__init__"} == TOP
    assert all(target in MODULES for targets in imports().values() for target in targets)


def test_imports_point_upstream():
    place = {name: k for k, name in enumerate(ORDER)}
    back = {
        (name, target)
        for name, targets in imports().items()
        for target in targets
        if room(name) != "kernel" and place[room(target)] > place[room(name)]
    }
    assert back == BACK_IMPORTS


def test_no_modules_import_each_other_in_a_circle():
    """What imports nothing, or only what has been taken away already, is taken away;
    a circle would remain."""
    left = dict(imports())
    while ends := [name for name, targets in left.items() if not targets & set(left)]:
        for name in ends:
            del left[name]
    assert left == {}


def test_the_native_fmus_c_has_no_circle():
    """The files of a wheelset and its sentences: what calls none of the others is taken away, and so on."""
    texts = {
        path.name: path.read_text(encoding="utf-8") for path in (ROOT / "fmu_src" / "native").glob("[ws]*.c")
    }
    homes = {
        name: file
        for file, text in texts.items()
        for name in re.findall(r"^\w[\w *]*?\b((?:wheelset|sentence)_\w+)\(", text, re.MULTILINE)
    }
    left = {
        file: {homes[name] for name in re.findall(r"\b\w+(?=\()", text) if name in homes} - {file}
        for file, text in texts.items()
    }
    assert len(homes) > 40 and left["wheelset.c"]
    while ends := [name for name, targets in left.items() if not targets & set(left)]:
        for name in ends:
            del left[name]
    assert left == {}


def test_the_whole_workspace_is_handed_on_by_the_wheelset_only():
    """A function reads what its arguments name; the wheelset's recipes and their derivatives see everything."""
    wide = [
        f"{name}.{node.name}"
        for name, tree in trees().items()
        for node in ast.walk(tree)
        if isinstance(node, ast.FunctionDef)
        and name.startswith("kernel.")
        and any(
            ast.unparse(argument.annotation) == "Work" for argument in node.args.args if argument.annotation
        )
    ]
    assert {room(name) for name in wide} == {"kernel.wheelset", "kernel.changing", "kernel.derivative"}, wide


# --- sizes --------------------------------------------------------------------------------------------------


def hand_written(*endings):
    """Files of the project's code that people write."""
    for folder in CODE:
        for path in sorted((ROOT / folder).rglob("*")):
            inside = path.relative_to(ROOT)
            if path.suffix in endings and not {"generated", "__pycache__"} & set(inside.parts):
                if not path.read_bytes().startswith(b"# Written by"):
                    yield inside.as_posix(), path


@cache
def sizes():
    """(Statements, [(function, by what it is too large)]) of every file of Python by its path."""
    return {
        name: (statements(parsed(path)), [(node.name, too_large(node)) for node in functions(parsed(path))])
        for name, path in hand_written(".py")
    }


def test_files_are_short():
    long = {name for name, path in hand_written(".c", ".h") if path.read_bytes().count(b"\n") > C_LINES}
    long |= {name for name, (count, _) in sizes().items() if count > FILE_STATEMENTS}
    assert long == LONG_FILES


def statements(tree):
    """How many statements there are inside a tree; docstrings are none."""
    return sum(
        isinstance(node, ast.stmt)
        and not (isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant))
        for node in ast.walk(tree)
        if node is not tree
    )


def too_large(node):
    """By what a function exceeds the limits without a reason in its docstring: "statements", "arguments"."""
    arguments = node.args
    names = [
        argument.arg
        for argument in (
            *arguments.posonlyargs,
            *arguments.args,
            *arguments.kwonlyargs,
            *filter(None, (arguments.vararg, arguments.kwarg)),
        )
    ]
    sizes = {
        "statements": statements(node) > FUNCTION_STATEMENTS,
        "arguments": len(names) - (names[:1] in (["self"], ["cls"])) > MOST_ARGUMENTS,
    }
    reasons = [line.strip() for line in (ast.get_docstring(node) or "").splitlines()]
    return [
        kind
        for kind, exceeded in sizes.items()
        if exceeded and not any(line.startswith(REASONS[kind]) for line in reasons)
    ]


def functions(tree):
    return [node for node in ast.walk(tree) if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))]


def test_functions_are_small():
    found = {
        (name, function, kind)
        for name, (_, found) in sizes().items()
        for function, kinds in found
        for kind in kinds
    }
    assert found == LARGE_FUNCTIONS


@pytest.mark.parametrize(
    "text, found",
    [
        ("def f(self, a, b, c, d, e, f, g, h): pass", []),
        ("def f(a, b, c, d, e, f, *, g, h, **i): pass", ["arguments"]),
        (
            "def f(a, b, c, d, e, f, g, h, i):\n    '''F.\n\n    Many arguments because they are one each.\n    '''",
            [],
        ),
        ("def f():\n" + "    pass\n" * 56, ["statements"]),
        ("def f():\n    '''F.'''\n" + "    pass\n" * 55, []),
        ("def f():\n    '''F.\n\n    Long because it is a table.\n    '''\n" + "    pass\n" * 60, []),
    ],
)
def test_a_function_s_size_is_seen(text, found):
    assert too_large(ast.parse(text).body[0]) == found
