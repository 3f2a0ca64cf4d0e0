"""Which files of the package a simulation needs: what the session imports, and the kernel with its compiled
libraries."""

import ast
import sys
from pathlib import Path

from ..interface.references import LIST
from ..kernel.binding.compiler import FMU_UNITS, CompilerProblem, compile_platform, has_zig
from ..kernel.binding.files import LIBRARY_NAME, library_name
from ..kernel.binding.fixed_tables import CORRECTION, FIXED
from ..kernel.binding.library import HERE, LibraryUnusable, fingerprint, open_library
from ..profiles.standards import FILE
from ..progress import tracked

PACKAGE = Path(__file__).resolve().parent.parent
ENTRANCE = "simulation/session.py"
#: Doors for people, and studies: never packed, even where a function of a packed module reaches for them.
OFFLINE = frozenset(
    {
        "cli",
        "plots",
        "study",
        "conditioning",
        "fleet",
        "fmu",
        "halfspace",
        "linear",
        "progress",
        "sweeps",
        "results/convert",
        "results/pages",
    }
)


def online_files():
    """Contents of the needed files by their path in the package."""
    kernel = set((PACKAGE / "kernel").rglob("*.py")) - {PACKAGE / "kernel" / "binding" / "compiler.py"}
    files = imported_from(PACKAGE / ENTRANCE) | kernel | {FIXED, CORRECTION, LIST, FILE}
    return {file.relative_to(PACKAGE).as_posix(): file.read_bytes() for file in sorted(files)}


def kernel_libraries(platforms):
    """Contents of the kernel's libraries by their path in the package: where ziglang is installed for each of
    ``platforms``, and for this machine; with a warning where there are none."""
    made = {}
    try:
        if has_zig():
            made = {
                library_name(name): compile_kernel(name) for name in tracked(platforms, "kernels for the FMU")
            }
    except CompilerProblem as problem:
        print(f"WARNING: the FMU gets no compiled kernel for other machines: {problem}", file=sys.stderr)
    try:
        if LIBRARY_NAME not in made:
            open_library()
            made[LIBRARY_NAME] = HERE.joinpath(LIBRARY_NAME).read_bytes()
    except LibraryUnusable as reason:
        print(
            f"WARNING: the FMU gets no compiled kernel and runs the slow Python source: {reason}",
            file=sys.stderr,
        )
    return {f"kernel/{name}": library for name, library in made.items()}


def compile_kernel(name):
    """The kernel's library for the platform ``name`` as bytes."""
    if f"INT64_C(0x{fingerprint():015x})" not in HERE.joinpath("generated", "unit.c").read_text():
        raise CompilerProblem("the kernel's generated C does not belong to this version of its source")
    return compile_platform(name, PACKAGE, FMU_UNITS, Path(library_name(name)).stem)


def imported_from(file):
    """``file`` and the modules of the package that it imports, directly or through others."""
    found, open_ends = set(), [file]
    while open_ends:
        module = open_ends.pop()
        if module not in found:
            found.add(module)
            open_ends.extend(imports_of(module))
    return found


def imports_of(module):
    """Files of the package that one module needs: the ``__init__`` of its folders, and what it imports
    anywhere in it."""
    yield from (folder / "__init__.py" for folder in module.parents if PACKAGE in folder.parents)
    for node in ast.walk(ast.parse(module.read_bytes())):
        if isinstance(node, ast.ImportFrom) and node.level:
            yield from files_of(module.parents[node.level - 1], node)
        elif names_itself(node):
            raise ValueError(
                f"{module}, line {node.lineno}: a packed module must import relatively, or it gets the host's"
            )


def files_of(folder, node):
    """Files that ``from <node.module> import <node.names>`` reads, with ``folder`` as the place it starts
    from."""
    folder = folder.joinpath(*(node.module or "").split("."))
    for target in (folder, *(folder / alias.name for alias in node.names)):
        place = target.relative_to(PACKAGE)
        if target != PACKAGE and OFFLINE.isdisjoint(each.as_posix() for each in (place, *place.parents)):
            yield from (
                file for file in (target.with_suffix(".py"), target / "__init__.py") if file.is_file()
            )


def names_itself(node):
    """Whether an import names the package by its own name."""
    if isinstance(node, ast.Import):
        names = [alias.name for alias in node.names]
    else:
        names = [getattr(node, "module", None) or ""]
    return isinstance(node, (ast.Import, ast.ImportFrom)) and any(
        name.split(".")[0] == PACKAGE.name for name in names
    )
