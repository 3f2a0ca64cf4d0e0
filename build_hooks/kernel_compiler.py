"""Compile the kernel's translation units into the library that the package loads.

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
_NAMES = runpy.run_path(str(KERNEL / "binding" / "platforms.py"))
PLATFORMS, host_platform, library_name = (_NAMES[name]
                                          for name in ("PLATFORMS", "host_platform", "library_name"))
LIBRARY_NAME = library_name(host_platform())
write_atomically = runpy.run_path(str(KERNEL.parent / "storage" / "atomic.py"))["write_atomically"]

#: Steps, preparation and derivatives are separate units, so that the optimisation of the first does not
#: depend on the others.
SOURCES = [KERNEL / "native" / name
           for name in ("wrcontact_kernel.c", "wrcontact_prepare.c", "wrcontact_tangent.c")]

# No fused a*b + c: the results are those of the Python source, to the last bit.  For the same reason CFLAGS
# is not read.  Without errno several roots are taken at once; gcc would then also write sin(atan(x)) as a
# root, which has other last bits, if it knew what atan is.
FLAGS = ("-std=gnu11", "-O3", "-ffp-contract=off", "-fno-math-errno", "-fno-builtin-atan",
         "-fvisibility=hidden", "-g0",
         "-Werror=implicit-function-declaration", "-shared", "-fPIC")
ZIG = (sys.executable, "-m", "ziglang", "cc")
PROBE = "#include <math.h>\ndouble probe(double x) { return sin(x); }\n"
ZIG_PLATFORMS = {("Linux", "x86_64"), ("Linux", "aarch64"), ("Darwin", "x86_64"), ("Darwin", "arm64"),
                 ("Windows", "AMD64"), ("Windows", "ARM64")}


class CompilerProblem(Exception):
    """There is no compiler, or the compiler failed; the message says which."""


def compile_library(target_folder, *, platform=None, compiler=None, extra_flags=()):
    """Compile the kernel into ``target_folder`` and return the library's path.

    ``platform`` is a name in PLATFORMS, for which ziglang compiles; by default this machine.  ``compiler`` is
    a command as a list of words; by default the first one that works on this machine.
    """
    if platform:
        chosen = PLATFORMS[platform]
        name, compiler = library_name(platform), [*ZIG, "-target", chosen.target, "-s"]
        extra_flags = [*chosen.link_flags(name), *extra_flags]
    else:
        name, compiler = LIBRARY_NAME, compiler or find_compiler()
    if compiler is None:
        raise CompilerProblem("no C compiler was found: $CC, cc, gcc, clang, and ziglang from PyPI were "
                              "tried")
    with tempfile.TemporaryDirectory() as scratch:
        built = Path(scratch, name)
        run = run_compiler(compiler, SOURCES, built, extra_flags, keeps_cache=bool(platform))
        if run.returncode:
            raise CompilerProblem(f"{' '.join(compiler)} failed on the kernel:\n{run.stdout}")
        return place(built, target_folder)


def place(library, folder):
    """Copy a library into ``folder``, atomically."""
    target = Path(folder) / library.name
    write_atomically(target, library.read_bytes())
    return target


def find_compiler():
    """Command of a C compiler: the first of $CC, cc, gcc and clang that compiles a small library; else
    ziglang; else None."""
    named = shlex.split(os.environ.get("CC", ""), posix=os.name != "nt")
    for command in (named, ["cc"], ["gcc"], ["clang"]):
        if command and shutil.which(command[0]) and makes_library(command):
            return command
    if importlib.util.find_spec("ziglang"):
        return [*ZIG, "-mcpu=baseline"]      # without it zig compiles for the builder's own processor
    return None


def makes_library(command):
    """Whether ``command`` compiles and links; a compiler may be installed without headers."""
    with tempfile.TemporaryDirectory() as scratch:
        source = Path(scratch, "probe.c")
        source.write_text(PROBE)
        return run_compiler(command, [source], Path(scratch, LIBRARY_NAME)).returncode == 0


def run_compiler(command, sources, library, extra_flags=(), keeps_cache=False):
    """Run the compiler; unless ``keeps_cache``, zig's cache is beside ``library``, so that nothing stays
    behind."""
    cache = str(library.parent / "cache")
    changed = {} if keeps_cache else {"ZIG_LOCAL_CACHE_DIR": cache, "ZIG_GLOBAL_CACHE_DIR": cache}
    return subprocess.run([*command, *FLAGS, *extra_flags, *map(str, sources), "-o", str(library), "-lm"],
                          text=True, errors="replace", stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, env={**os.environ, **changed})


def requirements():
    """Build requirements from PyPI: ziglang for a chosen platform, or if no compiler works on this machine
    and ziglang is available for it."""
    if not wanted():
        return []
    here = (platform.system(), platform.machine()) in ZIG_PLATFORMS
    return ["ziglang"] if chosen_platform() or here and not find_compiler() else []


def wanted():
    """Whether to compile a library; WRCONTACT_KERNEL=python at installation means no."""
    return os.environ.get("WRCONTACT_KERNEL") != "python"


def chosen_platform():
    """The platform that WRCONTACT_PLATFORM names; None is this machine."""
    name = os.environ.get("WRCONTACT_PLATFORM") or None
    if name not in (None, *PLATFORMS):
        raise CompilerProblem(f"WRCONTACT_PLATFORM is {name!r}; permitted are {', '.join(PLATFORMS)}")
    return name
