"""Compile the kernel's two translation units into the library that the package loads.

Standard library only.  Used by the build backend beside this file, by tools/compile_kernel.py and by tests.
"""

import importlib.util
import os
import platform
import runpy
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

KERNEL = Path(__file__).resolve().parents[1] / "wrcontact" / "kernel"
LIBRARY_NAME = runpy.run_path(str(KERNEL / "files.py"))["LIBRARY_NAME"]

#: What steps, what prepares and what differentiates: units of their own, so that no other takes from the optimising of the first.
SOURCES = [KERNEL / "native" / name for name in ("wrcontact_kernel.c", "wrcontact_prepare.c", "wrcontact_tangent.c")]

# No fused a*b + c: the results are those of the Python source, to the last bit.  For the same reason CFLAGS is not read.
FLAGS = ("-std=gnu11", "-O3", "-ffp-contract=off", "-fvisibility=hidden", "-g0",
         "-Werror=implicit-function-declaration", "-shared", "-fPIC")
PROBE = "#include <math.h>\ndouble probe(double x) { return sin(x); }\n"
ZIG_PLATFORMS = {("Linux", "x86_64"), ("Linux", "aarch64"), ("Darwin", "x86_64"), ("Darwin", "arm64"), ("Windows", "AMD64"),
                 ("Windows", "ARM64")}


class CompilerProblem(Exception):
    """There is no compiler, or it failed; the message says which."""


def compile_library(target_folder, *, compiler=None, extra_flags=()):
    """Compile the kernel into ``target_folder`` and return the library's path.

    ``compiler`` is a command as a list of words, by default the first that works.
    """
    compiler = compiler or find_compiler()
    if compiler is None:
        raise CompilerProblem("no C compiler was found: $CC, cc, gcc, clang, and ziglang from PyPI were tried")
    with tempfile.TemporaryDirectory() as scratch:
        built = Path(scratch, LIBRARY_NAME)
        run = run_compiler(compiler, SOURCES, built, extra_flags)
        if run.returncode:
            raise CompilerProblem(f"{' '.join(compiler)} failed on the kernel:\n{run.stdout}")
        return place(built, target_folder)


def place(library, folder):
    """Copy a library into ``folder`` under another name and move it: there is a whole one, or the one from before."""
    target = Path(folder) / LIBRARY_NAME
    part = target.with_name(f"{target.name}.{os.getpid()}.part")
    try:
        shutil.copyfile(library, part)
        os.replace(part, target)
    finally:
        part.unlink(missing_ok=True)
    return target


def find_compiler():
    """Command of a C compiler: of $CC, cc, gcc and clang the first that makes a small library, else ziglang, else None."""
    named = shlex.split(os.environ.get("CC", ""), posix=os.name != "nt")
    for command in (named, ["cc"], ["gcc"], ["clang"]):
        if command and shutil.which(command[0]) and makes_library(command):
            return command
    if importlib.util.find_spec("ziglang"):
        return [sys.executable, "-m", "ziglang", "cc", "-mcpu=baseline"]     # else zig takes the builder's own processor
    return None


def makes_library(command):
    """Whether ``command`` compiles and links; a compiler may be there without its headers."""
    with tempfile.TemporaryDirectory() as scratch:
        source = Path(scratch, "probe.c")
        source.write_text(PROBE)
        return run_compiler(command, [source], Path(scratch, LIBRARY_NAME)).returncode == 0


def run_compiler(command, sources, library, extra_flags=()):
    """Run the compiler; zig keeps its cache beside ``library``, so that nothing is left behind."""
    cache = str(library.parent / "cache")
    return subprocess.run([*command, *FLAGS, *extra_flags, *map(str, sources), "-o", str(library), "-lm"], text=True, errors="replace",
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          env={**os.environ, "ZIG_LOCAL_CACHE_DIR": cache, "ZIG_GLOBAL_CACHE_DIR": cache})


def requirements():
    """What a build needs from PyPI: ziglang where no compiler works and there is a ziglang for this machine."""
    if not wanted() or find_compiler() or (platform.system(), platform.machine()) not in ZIG_PLATFORMS:
        return []
    return ["ziglang"]


def wanted():
    """Whether a library is wanted: WRCONTACT_KERNEL=python at installation says no."""
    return os.environ.get("WRCONTACT_KERNEL") != "python"
