"""Compile C: which compiler there is, and how sources become a library.

For the package's installation, for developers and for FMUs.  Only the standard library, and only modules of
the package that need nothing else: the build backend loads this one before the package is installed.

The machine's own compiler is used, or ziglang, which also builds for other machines.  zig's first build for a
platform compiles a part of the C library, which takes a minute or two, most of it for Windows.  zig keeps the
result in its own cache (``ZIG_GLOBAL_CACHE_DIR`` selects the folder).
"""

import atexit
import hashlib
import importlib.metadata
import importlib.util
import os
import signal
import platform
import shlex
import shutil
import subprocess
import sys
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from functools import cache
from pathlib import Path

from ...storage.atomic import write_atomically
from .files import HERE, LIBRARY_NAME, PLATFORMS, host_platform, library_name

#: What is compiled of the kernel.  Steps, preparation and derivatives are separate units, so that the
#: optimisation of the first does not depend on the others.
KERNEL_UNITS = tuple(f"kernel/native/{file.name}" for file in sorted((HERE / "native").glob("*.c")))
#: Of these what an FMU has: it is asked for derivatives along one direction at a time, and its rails are the same all
#: along the track.
FMU_UNITS = tuple(
    unit for unit in KERNEL_UNITS if not any(name in unit for name in ("jacobian", "sections", "changing"))
)
#: What is needed without derivatives.
STEP_UNITS = tuple(unit for unit in KERNEL_UNITS if "jacobian" not in unit and "derivative" not in unit)

# No fused a*b + c: the results are those of the Python source, to the last bit, on every machine.  For the
# same reason CFLAGS is not read.  Without errno a root is an instruction: no mathematical library is needed.
FLAGS = (
    "-std=gnu11",
    "-O3",
    "-ffp-contract=off",
    "-fno-math-errno",
    "-fvisibility=hidden",
    "-g0",
    "-Werror=implicit-function-declaration",
    "-fPIC",
)
#: A unit that -O2 compiles in six tenths of the time; its loops over directions are unrolled all the same.
LESS_OPTIMISED = "kernel/native/wrcontact_jacobian.c"
#: The library by which a host loads a Python FMU: where PythonFMU has one for Linux, and its file in the package.
LOADER_PLATFORM, LOADER_NAME = "x86_64-linux", "_wrcontact_loader-x86_64-linux.so"
ZIG = (sys.executable, "-m", "ziglang", "cc")
PROBE = "#include <math.h>\ndouble probe(double x) { return sqrt(x); }\n"
#: Environment variable: a folder in which compiled sources are kept where the caller names none.
KEPT = "WRCONTACT_COMPILED"


class CompilerProblem(ValueError):
    """There is no compiler, or the compiler failed; the message says which."""


# --- which compiler -----------------------------------------------------------------------------------------


def has_zig():
    """Whether ziglang is installed."""
    return importlib.util.find_spec("ziglang") is not None


def find_compiler():
    """Command of a compiler for this machine: the first of $CC, cc, gcc and clang that compiles a small
    library; else ziglang; else None."""
    named = shlex.split(os.environ.get("CC", ""), posix=os.name != "nt")
    for command in (named, ["cc"], ["gcc"], ["clang"]):
        if command and shutil.which(command[0]) and makes_library(command):
            return command
    return [*ZIG, "-mcpu=baseline"] if has_zig() else None  # without it for the builder's own processor


def makes_library(command):
    """Whether ``command`` compiles and links; a compiler may be installed without headers."""
    with tempfile.TemporaryDirectory() as scratch:
        Path(scratch, "probe.c").write_text(PROBE)
        built = run([*command, "-shared", *FLAGS, "probe.c", "-o", LIBRARY_NAME], scratch)
        return built.returncode == 0


def compiler_for(place):
    """The compiler's command for a platform: ziglang's, without it the machine's own for its own platform;
    CompilerProblem if there is none."""
    if has_zig():
        return [*ZIG, "-target", place.target, "-s"]
    own = find_compiler() if place.name == host_platform() else None
    if own:
        return own
    raise CompilerProblem(
        f"there is no compiler for {place.name}; pip install ziglang, a compiler for every platform"
    )


# --- from sources to a library ------------------------------------------------------------------------------


def compile_library(target_folder, *, platform=None, compiler=None, extra_flags=(), units=KERNEL_UNITS):
    """Compile the kernel into ``target_folder`` and return the library's path.

    ``platform`` is a name in PLATFORMS, for which ziglang compiles; by default this machine.  ``compiler`` is
    a command as a list of words; by default the first one that works on this machine.  ``units`` are the
    sources.
    """
    place = PLATFORMS[platform] if platform else None
    command = [*ZIG, "-target", place.target, "-s"] if place else compiler or find_compiler()
    if command is None:
        raise CompilerProblem(
            "no C compiler was found: $CC, cc, gcc, clang, and ziglang from PyPI were tried"
        )
    target = Path(target_folder, library_name(platform) if platform else LIBRARY_NAME)
    links = place.link_flags(target.name) if place else []
    command = [*command, *FLAGS, *extra_flags]
    write_atomically(target, linked(command, HERE.parent, units, target.name, links))
    return target


def compile_loader(sources, target_folder=None):
    """Compile the library by which hosts on Linux load a Python FMU, from the folder ``sources``; returns it as
    bytes, or its path in ``target_folder``.

    For x86_64-linux, the only such platform of PythonFMU; CompilerProblem where there is no compiler for it.
    """
    made = compile_platform(LOADER_PLATFORM, sources, ["loader.c"], "loader", links=["-ldl"])
    if target_folder is None:
        return made
    target = Path(target_folder, LOADER_NAME)
    write_atomically(target, made)
    return target


def compile_platform(name, folder, sources, library, flags=(), cache=None, watch=None, links=()):
    """Compile ``sources`` in ``folder`` for the platform ``name``; returns the library, whose name without
    its ending is ``library``, as bytes.  ``cache`` and ``watch`` are those of :func:`linked`, ``links`` are
    libraries that it needs."""
    if name not in PLATFORMS:
        raise CompilerProblem(f"platform is {name!r}; permitted are {', '.join(PLATFORMS)}")
    place = PLATFORMS[name]
    command, file = [*compiler_for(place), *FLAGS, *flags], library + place.suffix
    return linked(command, folder, sources, file, [*place.link_flags(file), *links], cache, watch)


def linked(command, folder, sources, library, links=(), cache=None, watch=None):
    """Compile ``sources`` in ``folder`` side by side and link them; returns the file ``library`` as bytes.

    Compiled sources are kept in the folder ``cache``, or in the one that WRCONTACT_COMPILED names.  Sources
    in a folder of their own, such as the kernel's, include nothing outside it, so they are kept once for
    both versions of FMI.  ``watch(iterable, total)`` may show how far it is.
    """
    watch = watch or (lambda made, total: made)
    with tempfile.TemporaryDirectory() as scratch:
        place = Path(cache or os.environ.get(KEPT) or scratch)
        place.mkdir(parents=True, exist_ok=True)

        def compiled(source):
            words = [*command, "-O2"] if source == LESS_OPTIMISED and "-O1" not in command else command
            kept = place / f"{digest(words, folder, source)}.o"
            if not kept.exists():
                made = Path(scratch, f"{threading.get_ident()}.o")
                checked([*words, "-c", source, "-o", str(made)], folder, running)
                write_atomically(kept, made.read_bytes())
            kept.touch()  # it is in use
            return str(kept)

        with ThreadPoolExecutor(os.cpu_count()) as pool, ended_together(pool) as running:
            objects = list(watch(pool.map(compiled, sources), len(sources)))
        output = Path(scratch, library)
        checked([*command, "-shared", *objects, *links, "-o", str(output)], folder)
        return output.read_bytes()


class Running(set):
    """Compilers that run; once ``ended``, one that has just been started ends itself."""

    ended = False


@contextmanager
def ended_together(pool):
    """The :class:`Running` compilers of the threads of a ``pool``; an interrupt or error ends them at once, with
    the programs that they have started, and lets no other one begin."""
    running = Running()
    try:
        yield running
    except BaseException:
        pool.shutdown(wait=False, cancel_futures=True)
        running.ended = True
        for process in list(running):
            _kill(process)
        raise


def _kill(process):
    """End a compiler and the programs that it has started."""
    with suppress(OSError):
        if hasattr(os, "killpg"):
            os.killpg(process.pid, signal.SIGKILL)
        else:
            process.kill()


def checked(command, folder, running=None):
    """Run a compiler; CompilerProblem with what it says if it fails."""
    done = run(command, folder, running)
    if done.returncode:
        raise CompilerProblem(f"{' '.join(command)} failed:\n{done.stdout}")


def run(command, folder, running=None):
    """A compiler's run in ``folder``, ended, with all that it has written; it is in the :class:`Running` ``running``
    meanwhile, where there is one."""
    running = Running() if running is None else running
    with subprocess.Popen(
        command,
        cwd=folder,
        text=True,
        errors="replace",
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        env={**os.environ, **zig_cache()},
        start_new_session=True,  # a group of its own, see _kill
    ) as process:
        running.add(process)
        if running.ended:  # between its start and the line above
            _kill(process)
        try:
            said, _ = process.communicate()
        except BaseException:
            _kill(process)
            raise
        finally:
            running.discard(process)
    return subprocess.CompletedProcess(command, process.returncode, said)


def digest(command, folder, source):
    """Name of the compiled ``source``: a hash of the command, of the compiler's version and of all files that
    it may include."""
    top = Path(folder, Path(source).parts[0])
    files = top.rglob("*.[ch]") if top.is_dir() else [*Path(folder).rglob("*.h"), top]
    found = hashlib.sha256(repr((command, version_of(*command[:3]), source)).encode())
    for file in sorted(files):
        found.update(f"{file.name}\0{file.stat().st_size}\0".encode() + file.read_bytes())
    return found.hexdigest()


@cache
def version_of(program, *first):
    """What tells one version of a compiler from another, by the first words of its command."""
    if (program, *first) == ZIG[:3]:
        return importlib.util.find_spec("ziglang").origin, importlib.metadata.version("ziglang")
    return run([program, "--version"], None).stdout


@cache
def zig_cache():
    """Environment variables for zig's cache: none for the usual folder, or a temporary folder if that is not
    writable."""
    if sys.platform == "win32" or "ZIG_GLOBAL_CACHE_DIR" in os.environ:
        return {}
    try:
        usual = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache", "zig")
        usual.mkdir(parents=True, exist_ok=True)
        if os.access(usual, os.W_OK):
            return {}
    except (OSError, RuntimeError):  # read-only, or there is no home
        pass
    folder = tempfile.mkdtemp(prefix="wrcontact-zig-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return {"ZIG_GLOBAL_CACHE_DIR": folder, "ZIG_LOCAL_CACHE_DIR": folder}


# --- what an installation is asked for ----------------------------------------------------------------------

ZIG_PLATFORMS = {
    ("Linux", "x86_64"),
    ("Linux", "aarch64"),
    ("Darwin", "x86_64"),
    ("Darwin", "arm64"),
    ("Windows", "AMD64"),
    ("Windows", "ARM64"),
}


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
