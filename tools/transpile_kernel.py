"""Translate the kernel's Python modules to C: wrcontact/kernel/*.py -> wrcontact/kernel/generated/.

    python tools/transpile_kernel.py            write the C files
    python tools/transpile_kernel.py --check only tell whether they are what would be written (exit 1 if not)

A developer's tool: it needs Pyccel (``pip install ".[dev]"``, which needs gcc and gfortran). The C files are
committed, so that installing needs a C compiler only. The output depends on the modules and on Pyccel's
version, on nothing else.

What Pyccel writes is tidied like this:

* ``Final`` constants become ``static const`` definitions in the header, with the value that Python gives
  them. The compiler can fold them, and nothing has to be initialised at run time (where threads could race):
  ``<module>__init`` is gone, and the wrappers for CPython with it.
* Headers include ``native/spans.h`` and each other, instead of Pyccel's own library of containers.
* Functions are ``static``, in the order of the Python source, each under its docstring; ``unit.c`` includes
  them all, so the kernel is one translation unit; the modules prepare_*.py, which lay out its tables once,
  are another, and its tangents, which tools/tangent.py writes (implicit.py is an input of that one only), a
  third. Those of the modules in SELDOM are not inlined. Locals that Pyccel adds and nobody reads are dropped.
* ``unit.c`` also defines the fingerprint of the modules (wrcontact/kernel/binding/files.py).

Before that, the end of a range gets a name (``for k in range(int(work[3]))`` ends at ``k_end``) where the
loop might change it: C reads it anew in each turn, Python once.

Other Python that Pyccel translates to something else without a word is refused, with the line: ``else`` after
a loop; a loop that changes its own variable, or whose variable is read after it; ``hypot``, ``pow`` and
powers like ``x ** 2``, which CPython computes otherwise than C; a slice as an argument; a module variable
that is not ``Final``; a call of anything that spans.h and a few functions of math.h do not define.
"""

import argparse
import ast
import importlib
import importlib.metadata
import os
import re
import runpy
import subprocess
import sys
import tempfile
import types
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import lower_records  # noqa: E402  found through the line above
from tangent import RULE_MODULE, tangent_modules  # noqa: E402

KERNEL = Path(__file__).resolve().parents[1] / "wrcontact" / "kernel"
PYCCEL_VERSION = "2.2.3"        # the same as in pyproject.toml: another version may write other C
FILES = runpy.run_path(str(KERNEL / "binding" / "files.py"))

EDGE = "/*........................................*/"        # Pyccel's line above and below each function
#: Modules that a usual step does not enter, and the function of each that decides it. All others of theirs
#: are kept out of line: a compiler inlines only so much of one unit, and what it spent on them it took from
#: the usual step (4 % when yawed).
SELDOM = {"separation": "separation"} | dict.fromkeys((
    "arc_length", "brackets", "compliant", "curves", "deep_points", "elastic", "moves", "overlap_samples",
    "overlaps", "planes", "pressed", "pressed_regions", "touching", "trial"))
#: Tuples of numbers of the room layout that the C beside the kernel reads.
ARRAYS = {"INPUT_NOMINALS"}
#: Runs Pyccel's command without writing wrappers for CPython: nobody reads them, and they
#: take most of its time.
WITHOUT_WRAPPERS = """
from pyccel.codegen.wrappergen import Wrappergen
from pyccel.commands.console import pyccel_command
Wrappergen.wrap = lambda self, folder: None
pyccel_command()
"""
C_WORDS = {"if", "for", "while", "return", "sizeof", "switch"}
MATH_CALLS = set("acos asin atan atan2 ceil copysign cos cosh exp expm1 fabs floor fmod isfinite isinf isnan "
                 "log log10 log1p pow sin sinh sqrt tan tanh".split())
SPAN_CALLS = set("INT64_C cspan_at cspan_slice double_min double_max int64_t_min int64_t_max "
                 "py_floor_div_int64_t pyc_modulo".split())


class Refused(Exception):
    """The kernel cannot be translated; the message says where and why."""


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true",
                        help="write nothing; exit 1 if the C files are not up to date")
    parser.add_argument("--kernel", type=Path, default=KERNEL, help="folder of the kernel's modules")
    options = parser.parse_args(arguments)
    try:
        files = translate(options.kernel)
    except Refused as refusal:
        sys.exit(f"The kernel was not translated: {refusal}")
    generated = options.kernel / "generated"
    stale = stale_files(files, generated)
    if not options.check:
        write(files, generated)
        print(f"{len(files)} files in {generated}, {len(stale)} of them changed")
    elif stale:
        sys.exit("The generated C is not what the kernel's Python gives; run tools/transpile_kernel.py. "
                 f"Stale: {', '.join(stale)}")
    else:
        print(f"The {len(files)} generated files are up to date.")


def translate(kernel):
    """Text of every generated file by name, from the modules in the folder ``kernel``."""
    modules = read_modules(kernel)
    return assemble(kernel, modules, run_pyccel(modules))


def source_modules(kernel=KERNEL):
    """The modules in the rooms of the folder ``kernel`` with their records lowered to offsets, as
    they stand in one folder."""
    paths = {flat_name(path): path for path in FILES["kernel_modules"](kernel)}
    texts = {name: flat_imports(path) for name, path in paths.items()}
    try:
        lowered = lower_records.lower(texts, import_kernel(kernel, "layout"))
    except lower_records.Refused as refusal:
        raise Refused(refusal) from None
    return [Module(path, lowered[name]) for name, path in paths.items()]


def read_modules(kernel):
    """What Pyccel translates: the modules in the folder ``kernel``, and their tangents."""
    sources = source_modules(kernel)
    with tempfile.TemporaryDirectory() as folder:
        for name, text in tangent_modules(sources).items():
            Path(folder, f"{name}.py").write_text(text, encoding="utf-8")
        tangents = [Module(path) for path in sorted(Path(folder).glob("*.py"))]
    modules = [*(module for module in sources if module.name != RULE_MODULE), *tangents]
    for module in modules:
        module.refuse_silent_traps()
    return modules


def assemble(kernel, modules, raw):
    """Text of every generated file by name, from what Pyccel has made of the ``modules``:
    ``raw``, by module name."""
    kernel_modules = [module for module in modules if not module.tangent]
    constants = constant_values(kernel, kernel_modules) | {module.name: {} for module in modules
                                                           if module.tangent}
    functions = {f"{module.name}__{name}" for module in modules for name in module.functions}
    files = {}
    for module in modules:
        header, code = raw[module.name]
        files[module.name + ".h"] = tidy_header(module, header, constants[module.name])
        if module.functions:
            files[module.name + ".c"] = tidy_code(module, code)
            refuse_unknown_calls(module, files[module.name + ".c"], functions)
    files["unit.c"] = unit([module for module in kernel_modules if not module.prepares],
                           FILES["fingerprint"](kernel, import_kernel(kernel, "layout").digest()))
    files["prepare_unit.c"] = prepare_unit(kernel_modules)
    files["tangent_unit.c"] = tangent_unit(modules)
    return files


class Module:
    """One Python module of the kernel, parsed."""

    def __init__(self, path, text=None):
        self.path = path
        self.name = flat_name(path)
        self.place = path.name if self.name.startswith("tangent_") else f"{path.parent.name}/{path.name}"
        self.text = flat_imports(path) if text is None else text
        self.tree = ast.parse(self.text, str(path))
        self.functions = {node.name: node for node in self.tree.body if isinstance(node, ast.FunctionDef)}
        self.constants = [node.target.id for node in self.tree.body if isinstance(node, ast.AnnAssign)]
        self.imports = {node.module: {alias.name for alias in node.names} for node in self.tree.body
                        if isinstance(node, ast.ImportFrom) and node.level}
        #: Offsets and sizes of records, which only the lowered text has.
        self.offsets = {node.target.id: ast.literal_eval(node.value) for node in self.tree.body
                        if isinstance(node, ast.AnnAssign)} if self.name == "layout" else {}
        self.prepares = self.name.startswith("prepare_")
        self.tangent = self.name.startswith("tangent_")

    def refuse(self, node, why):
        raise Refused(f"{self.path.name}, line {node.lineno}: {why}")

    def refuse_silent_traps(self):
        """Refuse Python whose translation compiles and means something else."""
        for node in self.tree.body:
            is_final = (isinstance(node, ast.AnnAssign) and ast.unparse(node.annotation).startswith("Final[")
                        and node.value)
            is_docstring = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
            if not (is_final or is_docstring or isinstance(node, (ast.FunctionDef, ast.ImportFrom))):
                self.refuse(node,
                            "a module may hold its docstring, 'from' imports, Final constants and functions "
                            "only")
        for node in ast.walk(self.tree):
            if isinstance(node, (ast.For, ast.While)) and node.orelse:
                self.refuse(node, "Pyccel drops the else of a loop")
            if isinstance(node, ast.For) and not ast.unparse(node.iter).startswith("range("):
                self.refuse(node, "a for loop runs over a range")
            if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow) and is_number(node.right):
                self.refuse(node,
                            "a power that the C compiler replaces differs in the last bit; write x*x or "
                            "sqrt(x)")
            if isinstance(node, ast.Name) and node.id in ("hypot", "pow"):
                self.refuse(node,
                            f"{node.id} differs from C's {node.id} in the last bit; write it with *, sqrt or "
                            "**")
        for function, loop in self.range_loops():
            self.refuse_loop_variable(function, loop)

    def range_loops(self):
        """(function, loop) of every ``for``."""
        return [(function, node) for function in self.functions.values() for node in ast.walk(function)
                if isinstance(node, ast.For)]

    def refuse_loop_variable(self, function, loop):
        """Refuse uses of the loop's variable that C's ``for`` gives another value."""
        variables = stored([loop.target])
        if stored(loop.body) & variables:
            self.refuse(loop, "the loop changes its own variable, which in C changes the number of turns")
        later = [name for name in ast.walk(function) if isinstance(name, ast.Name) and name.id in variables
                 and name.lineno > loop.end_lineno]
        first = min(later, key=lambda name: (name.lineno, isinstance(name.ctx, ast.Store)), default=None)
        if first is not None and isinstance(first.ctx, ast.Load):
            self.refuse(first, f"after its loop, {first.id} is one turn further in C than in Python")

    def source(self):
        """The module's text with a name for each range's end that C, which reads it anew in each
        turn, might find changed."""
        lines = self.text.splitlines()                              # bytes, as ast counts columns
        for function, loop in sorted(self.range_loops(), key=lambda pair: -pair[1].lineno):
            end = loop.iter.args[1 if len(loop.iter.args) > 1 else 0]
            names = {node.id for node in ast.walk(end) if isinstance(node, ast.Name)}
            if not (names & stored(loop.body)
                    or any(isinstance(node, ast.Subscript) for node in ast.walk(end))):
                continue
            name = f"{loop.target.id}_end"
            if (end.end_lineno != loop.lineno
                or name in {node.id for node in ast.walk(function) if isinstance(node, ast.Name)}):
                self.refuse(loop,
                            f"the range should stand in one line, and the name {name} be free for its end")
            line = lines[loop.lineno - 1]
            expression = line[end.col_offset:end.end_col_offset]
            head = line[:end.col_offset] + name.encode() + line[end.end_col_offset:]
            lines[loop.lineno - 1:loop.lineno] = [b" " * loop.col_offset + name.encode() + b" = "
                                                  + expression, head]
        return b"\n".join(lines) + b"\n"


def flat_name(path):
    """The name of a module among all others, which Pyccel and C see in one folder."""
    room = path.parent.name
    if "layout" in (room, path.name):           # whichever of its files: they are one module
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
            lines[number] = b"from ." + flat_name(target).encode() + line[found.end(2):]
    return b"\n".join(lines)


def is_number(node):
    """Whether the expression is a number as written, like 2 or -0.5 (and not like 1.0 / 3.0)."""
    return isinstance(node.operand if isinstance(node, ast.UnaryOp) else node, ast.Constant)


def stored(nodes):
    """Names that the statements ``nodes`` assign to."""
    names = (name for node in nodes for name in ast.walk(node) if isinstance(name, ast.Name))
    return {name.id for name in names if isinstance(name.ctx, ast.Store)}


def run_pyccel(modules):
    """Pyccel's header and code, by module name."""
    found = installed_pyccel()
    if found != PYCCEL_VERSION:
        raise Refused(f"it needs Pyccel {PYCCEL_VERSION}, and here is {found}; pip install \".[dev]\"")
    with tempfile.TemporaryDirectory() as folder:
        for module in modules:
            Path(folder, f"{module.name}.py").write_bytes(module.source())
        command = [sys.executable, "-c", WITHOUT_WRAPPERS, "make",
                   "--language", "C", "--convert-only", "--output", "out", "--files",
                   *(f"{module.name}.py" for module in modules)]
        run = subprocess.run(command, cwd=folder, text=True, encoding="utf-8", stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT,
                             env={**os.environ, "PYTHONUTF8": "1", "PYTHONHASHSEED": "0"})
        if run.returncode:
            raise Refused(f"Pyccel says\n{run.stdout}")
        out = Path(folder, "out", "__pyccel__")
        return {module.name: tuple((out / (module.name + end)).read_text(encoding="utf-8")
                                   for end in (".h", ".c"))
                for module in modules}


def installed_pyccel():
    """Version of Pyccel in this Python, or 'none'."""
    try:
        return importlib.metadata.version("pyccel")
    except importlib.metadata.PackageNotFoundError:
        return "none"


def import_kernel(kernel, name):
    """The module ``name``, such as "search.roll", of the kernel in the folder
    ``kernel``, imported on its own."""
    package, room = (types.ModuleType("package_being_translated"),
                     types.ModuleType("package_being_translated.kernel"))
    package.__path__, room.__path__ = [str(kernel.parent), str(KERNEL.parent)], [str(kernel)]
    if getattr(sys.modules.get(room.__name__), "__path__", None) != room.__path__:
        for old in [old for old in sys.modules if old.startswith(package.__name__)]:
            del sys.modules[old]                                # those of another folder
        sys.modules |= {package.__name__: package, room.__name__: room}
    sys.dont_write_bytecode = True
    return importlib.import_module(f"{room.__name__}.{name}")


def constant_values(kernel, modules):
    """Value of every constant, as Python computes it: {module: {constant: value}}."""
    values = {}
    for module in modules:
        source = import_kernel(kernel,
                               f"{module.path.parent.name}.{module.path.stem}".removesuffix(".__init__"))
        values[module.name] = {name: getattr(source, name) for name in module.constants
                               if hasattr(source, name)}
        values[module.name] |= module.offsets
        if module.name == "layout":
            values["layout"] |= {name: value for name, value in vars(source).items() if name in ARRAYS}
    return values


def storage(module, function):
    """How a function is declared."""
    return "static inline" if SELDOM.get(module.name, function) == function else "static OUT_OF_LINE"


def tidy_header(module, text, constants):
    """A header with spans.h, the headers of other modules, constants and prototypes."""
    guard = f"WRCONTACT_KERNEL_{module.name.upper()}_H"
    headers = re.findall(r'^#include "(\w+\.h)"$', text, re.MULTILINE)
    includes = ['#include "../native/spans.h"'] + [f'#include "{name}"' for name in headers
                                                   if name != "pyc_math_c.h"]
    definitions = [definition(f"{module.name}__{name}", value) for name, value in constants.items()]
    found = re.findall(rf"^((\w.* \*?){module.name}__(\w+)\(.*\));$", text, re.MULTILINE)
    prototypes = [f"{storage(module, name)} {line};" for line, _, name in found if name != "init"]
    parts = [[banner(module)], [f"#ifndef {guard}", f"#define {guard}"], includes, definitions, prototypes,
             ["#endif"]]
    return "\n\n".join("\n".join(part) for part in parts if part) + "\n"


def definition(name, value):
    """C definition of one constant."""
    if isinstance(value, tuple):
        return f"static const double {name}[] = {{{', '.join(map(repr, value))}}};"
    if isinstance(value, bool):
        return f"static const bool {name} = {int(value)};"
    if isinstance(value, int):
        return f"static const int64_t {name} = INT64_C({value});"
    if isinstance(value, float) and value - value == 0.0:
        return f"static const double {name} = {value!r};"
    raise Refused(f"the constant {name} = {value!r} is not a bool, an int or a finite float")


def tidy_code(module, text):
    """The module's functions in the order of the Python source, each under its docstring."""
    chunks = {}
    for chunk in text.split(EDGE):
        signature = re.search(rf"^(\w.* \*?{module.name}__(\w+)\(.*\))\n\{{\n(.*)^\}}$", chunk,
                              re.MULTILINE | re.DOTALL)
        if signature and signature[2] != "init":
            head = f"{storage(module, signature[2])} {signature[1]}"
            chunks[signature[2]] = f"{head}\n{{\n{tidy_body(signature[3])}}}"
    if set(chunks) != set(module.functions):
        raise Refused(f"{module.path.name}: Pyccel renamed or dropped "
                      f"{sorted(set(chunks) ^ set(module.functions))}")
    documented = [comment(ast.get_docstring(node)) + chunks[name] for name, node in module.functions.items()]
    return "\n\n".join([banner(module), f'#include "{module.name}.h"', *documented]) + "\n"


def tidy_body(body):
    """The statements of one function, without the names that Pyccel declares and nobody reads."""
    for name in ["result", *re.findall(r"\bDummy_\d+(?=;)", body)]:
        uses = len(re.findall(rf"\b{name}\b", body))
        called = re.search(rf"^ *{name} = \w+\(", body, re.MULTILINE)
        if uses == 1 or uses == 2 and called:
            body = re.sub(rf"^ *\w+ {name};\n", "", body, flags=re.MULTILINE)
            body = re.sub(rf"^( *){name} = ", r"\1", body, flags=re.MULTILINE)
    return re.sub(r"^( *)/\*(.*)\*/$", lambda match: f"{match[1]}/* {apart(match[2]).strip()} */", body,
                  flags=re.MULTILINE)


def apart(text):
    """Text for a C comment, which ``E*/(n r)`` would end."""
    return text.replace("*/", "* /").replace("/*", "/ *")


def comment(text):
    """A docstring as a C comment, with a line end; '' where there is none."""
    if not text:
        return ""
    lines = apart(text).splitlines()
    if len(lines) == 1:
        return f"/* {lines[0]} */\n"
    return "\n".join([f"/* {lines[0]}", *(f" * {line}".rstrip() for line in lines[1:]), " */\n"])


def banner(module):
    """First lines of a generated file."""
    origin = f"Generated from {module.place} by tools/transpile_kernel.py; change that one."
    return comment(f"{origin}\n\n{ast.get_docstring(module.tree) or ''}".rstrip()).rstrip()


def refuse_unknown_calls(module, text, functions):
    """Refuse calls that neither the kernel nor spans.h and math.h define, and arrays on the stack."""
    code = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    if re.search(r"\w+\[", code.replace("shape[", "")):
        raise Refused(f"{module.path.name}: the C would copy an array to the stack; an argument like x[a:b] "
                      "needs a name first")
    unknown = set(re.findall(r"\b([A-Za-z_]\w*)\(", code)) - functions - MATH_CALLS - SPAN_CALLS - C_WORDS
    if unknown:
        raise Refused(f"{module.path.name}: the C would call {', '.join(sorted(unknown))}, which spans.h and "
                      "math.h do not have")


def unit(modules, fingerprint):
    """The file that includes all others."""
    lines = ["/* The whole kernel. Generated by tools/transpile_kernel.py. */",
             f"#define WRCONTACT_KERNEL_FINGERPRINT INT64_C(0x{fingerprint:015x})", ""]
    lines += [f'#include "{module.name}.{"c" if module.functions else "h"}"' for module in modules]
    return "\n".join(lines) + "\n"


def prepare_unit(modules):
    """The file that includes what prepares the kernel's tables, and the modules whose
    functions that calls."""
    lines = ["/* What prepares the kernel's tables. Generated by tools/transpile_kernel.py. */"]
    return "\n".join(lines
                     + inclusions(modules, {module.name for module in modules if module.prepares})) + "\n"


def tangent_unit(modules):
    """The file that includes the differentiated kernel, and the modules whose functions that calls."""
    lines = ["/* The kernel with a rate beside every value. Generated by tools/transpile_kernel.py. */"]
    return "\n".join(lines
                     + inclusions(modules, {module.name for module in modules if module.tangent})) + "\n"


def inclusions(modules, needed):
    """Lines that include the modules ``needed`` and all whose functions those call."""
    by_name = {module.name: module for module in modules}
    waiting = list(needed)
    while waiting:
        called = {name for name, used in by_name[waiting.pop()].imports.items()
                  if used & set(by_name[name].functions)}
        waiting.extend(called - needed)
        needed |= called
    return [f'#include "{name}.c"' for name in sorted(needed)]


def stale_files(files, generated):
    """Names that are missing, superfluous or different in the folder ``generated``."""
    present = {path.name: path.read_bytes() for path in generated.glob("*.[ch]")}
    wanted = {name: text.encode() for name, text in files.items()}
    return sorted(name for name in present.keys() | wanted.keys() if present.get(name) != wanted.get(name))


def write(files, generated):
    """Make the folder ``generated`` hold exactly ``files``."""
    generated.mkdir(exist_ok=True)
    for path in generated.glob("*.[ch]"):
        if path.name not in files:
            path.unlink()
    for name, text in files.items():
        (generated / name).write_bytes(text.encode())


if __name__ == "__main__":
    main()
