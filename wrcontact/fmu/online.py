"""Which files of the package are packed into the Python FMU: all but a list, and the compiled kernel."""

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
#: What a simulation never reads: commands, pictures, studies, results for other programs, and compilers.
LEFT_OUT = (
    "__init__.py",
    "cli",
    "conditioning",
    "creep",
    "export",
    "fleet",
    "fmu",
    "fmu_src",
    "halfspace",
    "interface/one_wheel.py",
    "kernel/binding/compiler.py",
    "keywords.py",
    "linear",
    "plots",
    "profiles/compiled.py",
    "profiles/placement.py",
    "progress",
    "results/climbing.py",
    "results/convert.py",
    "results/guiding.py",
    "results/pages.py",
    "results/runs.py",
    "sections",
    "study",
    "sweeps",
    "track",
    "wear",
    "wheel.py",
    "workers.py",
)
#: Files of data that a simulation reads.
DATA = (FIXED, CORRECTION, LIST, FILE)


def online_files():
    """Contents of the needed files by their path in the package."""
    paths = {path.relative_to(PACKAGE): path for path in (*PACKAGE.rglob("*.py"), *DATA)}
    return {
        name.as_posix(): path.read_bytes()
        for name, path in sorted(paths.items())
        if not any(Path(one) in (name, *name.parents) for one in LEFT_OUT)
    }


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
