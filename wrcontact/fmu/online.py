"""Which files of the package a simulation needs: what the session imports, and the kernel with its compiled library."""

import ast
import sys
from pathlib import Path

PACKAGE = Path(__file__).resolve().parent.parent
ENTRANCE = "interface/session.py"
#: Doors for people, and studies: never packed, even where a function of a packed module reaches for them.
OFFLINE = frozenset({"cli", "plots", "study", "fmu", "fmu_src", "halfspace", "true_gap"})


def online_files():
    """Contents of the needed files by their path in the package."""
    files = imported_from(PACKAGE / ENTRANCE) | set((PACKAGE / "kernel").glob("*.py")) | set(compiled_kernel())
    return {file.relative_to(PACKAGE).as_posix(): file.read_bytes() for file in sorted(files)}


def compiled_kernel():
    """The kernel's library for this platform, or a warning where there is no usable one."""
    from ..kernel.library import HERE, LIBRARY_NAME, LibraryUnusable, open_library

    try:
        open_library()
        return [HERE / LIBRARY_NAME]
    except LibraryUnusable as reason:
        print(f"WARNING: the FMU gets no compiled kernel and runs the slow Python source: {reason}", file=sys.stderr)
        return []


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
    """Files of the package that one module needs: the ``__init__`` of its folders, and what it imports anywhere in it."""
    yield from (folder / "__init__.py" for folder in module.parents if PACKAGE in folder.parents)
    for node in ast.walk(ast.parse(module.read_bytes())):
        if isinstance(node, ast.ImportFrom) and node.level:
            yield from files_of(module.parents[node.level - 1], node)
        elif names_itself(node):
            raise ValueError(f"{module}, line {node.lineno}: a packed module must import relatively, or it gets the host's")


def files_of(folder, node):
    """Files that ``from <node.module> import <node.names>`` reads, with ``folder`` as the place it starts from."""
    folder = folder.joinpath(*(node.module or "").split("."))
    for target in (folder, *(folder / alias.name for alias in node.names)):
        if target != PACKAGE and OFFLINE.isdisjoint(target.relative_to(PACKAGE).parts):
            yield from (file for file in (target.with_suffix(".py"), target / "__init__.py") if file.is_file())


def names_itself(node):
    """Whether an import names the package by its own name."""
    names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else [getattr(node, "module", None) or ""]
    return isinstance(node, (ast.Import, ast.ImportFrom)) and any(name.split(".")[0] == PACKAGE.name for name in names)
