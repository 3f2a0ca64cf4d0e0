"""The kernel's modules as they are translated: in one folder, without records, and refused where they would
mean something else in C.
"""

import ast
import importlib
import re
import runpy
import sys
import tempfile
import types
from pathlib import Path

import lower_records
from differentiate import RULE_MODULES, derivative_modules

KERNEL = Path(__file__).resolve().parents[2] / "wrcontact" / "kernel"
#: A value of each kind, for functions with nothing in them.
VALUES = {"float": "0.0", "int": "0", "bool": "False"}
FILES = runpy.run_path(str(KERNEL / "binding" / "files.py"))


#: Modules that have been read, by their room and name and by both texts.
KNOWN = {}
#: What the kernel may import from math: the same bits on every machine.
EXACT = {"copysign", "fabs", "inf", "isfinite", "nan", "pi", "sqrt"}


class Refused(Exception):
    """The kernel cannot be translated; the message says where and why."""


def source_modules(kernel=KERNEL):
    """The modules in the rooms of the folder ``kernel`` with their records lowered to offsets, as
    they stand in one folder."""
    paths = {flat_name(path): path for path in FILES["kernel_modules"](kernel)}
    texts = {name: flat_imports(path) for name, path in paths.items()}
    try:
        lowered = lower_records.lower(texts, import_kernel(kernel, "layout"))
    except lower_records.Refused as refusal:
        raise Refused(refusal) from None
    return [known_module(path, lowered[name]) for name, path in paths.items()]


def known_module(path, text):
    """A module without traps; what has been read before, in a copy of the kernel too, is the same one."""
    key = path.parent.name, path.name, path.read_bytes(), text
    if key not in KNOWN:
        found = Module(path, text)
        found.refuse_silent_traps()
        KNOWN[key] = found
    return KNOWN[key]


def read_modules(kernel, derivatives=True):
    """What is translated: the modules in the folder ``kernel``, and their ``derivatives``."""
    sources = source_modules(kernel)
    plain = [module for module in sources if module.name not in RULE_MODULES]
    return [*plain, *rated_modules(sources)] if derivatives else plain


def rated_modules(sources):
    """The derivatives of the modules ``sources``."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in derivative_modules(sources).items():
            Path(folder, f"{name}.py").write_text(text, encoding="utf-8")
        derivatives = [Module(path) for path in sorted(Path(folder).glob("*.py"))]
    rooms = {module.name: module.room for module in sources}
    for module in derivatives:
        room = rooms.get(module.name.removeprefix("derivative_"), "derivative")
        module.room = "derivative" if room == "derivative" else f"derivative_{room}"
    return derivatives


class Module:
    """One Python module of the kernel, parsed."""

    def __init__(self, path, text=None):
        self.path = path
        self.name = flat_name(path)
        self.place = path.name if self.name.startswith("derivative_") else f"{path.parent.name}/{path.name}"
        self.text = flat_imports(path) if text is None else text
        written = ast.parse(path.read_bytes())
        self.marks = {
            node.name: mark.id
            for node in written.body
            if isinstance(node, ast.FunctionDef)
            for mark in node.decorator_list
        }
        if "native" in self.marks.values():
            self.text = native_text(written)
        if self.name == "derivative_rates":  # native/directions.h has them
            self.marks = {node.name: "native" for node in written.body if isinstance(node, ast.FunctionDef)}
        self.tree = ast.parse(self.text, str(path))
        self.functions = {node.name: node for node in self.tree.body if isinstance(node, ast.FunctionDef)}
        self.constants = [node.target.id for node in self.tree.body if isinstance(node, ast.AnnAssign)]
        self.imports = {
            node.module: {alias.name for alias in node.names}
            for node in self.tree.body
            if isinstance(node, ast.ImportFrom) and node.level
        }
        #: Offsets and sizes of records, which only the lowered text has.
        self.offsets = (
            {
                node.target.id: ast.literal_eval(node.value)
                for node in self.tree.body
                if isinstance(node, ast.AnnAssign)
            }
            if self.name == "layout"
            else {}
        )
        self.room = path.parent.name
        self.derivative = self.name.startswith("derivative_")

    def refuse(self, node, why):
        raise Refused(f"{self.path.name}, line {node.lineno}: {why}")

    def refuse_silent_traps(self):
        """Refuse Python whose translation compiles and means something else."""
        for node in self.tree.body:
            is_final = (
                isinstance(node, ast.AnnAssign)
                and ast.unparse(node.annotation).startswith("Final[")
                and node.value
            )
            is_docstring = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
            if not (is_final or is_docstring or isinstance(node, (ast.FunctionDef, ast.ImportFrom))):
                self.refuse(
                    node,
                    "a module may hold its docstring, 'from' imports, Final constants and functions only",
                )
        for node in ast.walk(self.tree):
            if isinstance(node, (ast.For, ast.While)) and node.orelse:
                self.refuse(node, "a loop has no else")
            if isinstance(node, ast.For) and not ast.unparse(node.iter).startswith("range("):
                self.refuse(node, "a for loop runs over a range")
            if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
                self.refuse(
                    node,
                    "a power differs from machine to machine in the last bit; write x*x, "
                    "sqrt(x) or cube_root(x)",
                )
            if isinstance(node, ast.ImportFrom) and node.module == "math":
                for name in sorted({alias.name for alias in node.names} - EXACT):
                    self.refuse(
                        node,
                        f"{name} of math differs from machine to machine in the last bit; the "
                        "room elementary has functions that do not",
                    )
        for function, loop in self.range_loops():
            self.refuse_loop_variable(function, loop)

    def range_loops(self):
        """(function, loop) of every ``for``."""
        return [
            (function, node)
            for function in self.functions.values()
            for node in ast.walk(function)
            if isinstance(node, ast.For)
        ]

    def refuse_loop_variable(self, function, loop):
        """Refuse uses of the loop's variable that C's ``for`` gives another value."""
        variables = stored([loop.target])
        if stored(loop.body) & variables:
            self.refuse(loop, "the loop changes its own variable, which in C changes the number of turns")
        later = [
            name
            for name in ast.walk(function)
            if isinstance(name, ast.Name) and name.id in variables and name.lineno > loop.end_lineno
        ]
        first = min(later, key=lambda name: (name.lineno, isinstance(name.ctx, ast.Store)), default=None)
        if first is not None and isinstance(first.ctx, ast.Load):
            self.refuse(first, f"after its loop, {first.id} is one turn further in C than in Python")


def native_text(tree):
    """The text of a module of functions that C has by itself, as bytes: the same functions with nothing in
    them."""
    lines = [f'"""{ast.get_docstring(tree)}"""']
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            lines += [
                "",
                "",
                f"def {node.name}({ast.unparse(node.args)}):",
                f"    result = {VALUES[node.returns.id]}",
                "    return result",
            ]
    return "\n".join([*lines, ""]).encode()


def flat_name(path):
    """The name of a module among all others, as if they stood in one folder, which is the one that C has."""
    room = path.parent.name
    if "layout" in (room, path.name):  # whichever of its files: they are one module
        return "layout"
    return f"prepare_{path.stem}" if room == "prepare" else path.stem


def flat_imports(path):
    """The text of a module as it is where all modules are in one folder (bytes, each
    import still in its line)."""
    folder = path.parent

    lines = path.read_bytes().split(b"\n")
    for number, line in enumerate(lines):
        found = re.match(rb"from (\.+)([\w.]*) import", line)
        if found:
            target = folder if len(found[1]) == 1 else folder.parent
            target = target.joinpath(*found[2].decode().split("."))
            lines[number] = b"from ." + flat_name(target).encode() + line[found.end(2) :]
    return b"\n".join(lines)


def stored(nodes):
    """Names that the statements ``nodes`` assign to."""
    names = (name for node in nodes for name in ast.walk(node) if isinstance(name, ast.Name))
    return {name.id for name in names if isinstance(name.ctx, ast.Store)}


def import_kernel(kernel, name):
    """The module ``name``, such as "search.roll", of the kernel in the folder
    ``kernel``, imported on its own."""
    package, room = (
        types.ModuleType("package_being_translated"),
        types.ModuleType("package_being_translated.kernel"),
    )
    package.__path__, room.__path__ = [str(kernel.parent), str(KERNEL.parent)], [str(kernel)]
    if getattr(sys.modules.get(room.__name__), "__path__", None) != room.__path__:
        for old in [old for old in sys.modules if old.startswith(package.__name__)]:
            del sys.modules[old]  # those of another folder
        sys.modules |= {package.__name__: package, room.__name__: room}
    sys.dont_write_bytecode = True
    return importlib.import_module(f"{room.__name__}.{name}")
