"""C compilers for libraries in FMUs: the machine's own, or ziglang, which also builds for other machines.

The first build for a platform compiles a part of the C library, which takes a minute or two, most of it for
Windows.  zig keeps the result in its own cache (``ZIG_GLOBAL_CACHE_DIR`` selects the folder).
"""

import atexit
import hashlib
import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from pathlib import Path

from ..kernel.binding.library import HERE, fingerprint
from ..kernel.binding.platforms import PLATFORMS, host_platform, library_name
from ..progress import tracked
from ..storage.atomic import write_atomically

#: Results have the same bits as the kernel's Python source; build_hooks/kernel_compiler.py says why.
FLAGS = ("-std=gnu11", "-O3", "-ffp-contract=off", "-fno-math-errno", "-fno-builtin-atan",
         "-fvisibility=hidden", "-g0",
         "-Werror=implicit-function-declaration", "-fPIC")
KERNEL_UNITS = tuple(f"native/wrcontact_{part}.c" for part in ("kernel", "prepare", "tangent"))


class CompilerProblem(ValueError):
    """There is no compiler, or the compiler failed; the message says which."""


def compile_platform(name, folder, sources, identifier, flags=(), cache=None):
    """Compile ``sources`` in ``folder`` for the platform ``name``; returns the library ``identifier`` as
    bytes.

    Object files are kept in the folder ``cache``, if given.  Sources in a folder of their own, such as the
    kernel's, include nothing outside it, so their object files serve both versions of FMI.  Without ziglang
    the machine's own compiler is used, for the machine's own platform only.  CompilerProblem if there is no
    compiler or if it fails.
    """
    if name not in PLATFORMS:
        raise CompilerProblem(f"platform is {name!r}; permitted are {', '.join(PLATFORMS)}")
    chosen = PLATFORMS[name]
    command, library = [*compiler_for(chosen), *FLAGS, *flags], identifier + chosen.suffix

    def run(*arguments):
        done = subprocess.run([*command, *arguments], cwd=folder, text=True, errors="replace",
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              env={**os.environ, **zig_cache()})
        if done.returncode:
            raise CompilerProblem(f"{' '.join(command)} failed for {name}:\n{done.stdout}")

    with tempfile.TemporaryDirectory() as scratch:
        place = Path(cache or scratch)
        place.mkdir(parents=True, exist_ok=True)

        def compiled(source):
            kept = place / f"{digest(command, folder, source)}.o"
            if not kept.exists():
                made = Path(scratch, f"{threading.get_ident()}.o")
                run("-c", source, "-o", str(made))
                write_atomically(kept, made.read_bytes())
            return str(kept)

        with ThreadPoolExecutor(os.cpu_count()) as pool:
            made = tracked(pool.map(compiled, sources), f"compiling for {name}", len(sources))
            objects = list(made)
        output = Path(scratch, library)
        run("-shared", *chosen.link_flags(library), *objects, "-o", str(output), "-lm")
        return output.read_bytes()


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
    except (OSError, RuntimeError):     # read-only, or there is no home
        pass
    folder = tempfile.mkdtemp(prefix="wrcontact-zig-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return {"ZIG_GLOBAL_CACHE_DIR": folder, "ZIG_LOCAL_CACHE_DIR": folder}


def digest(command, folder, source):
    """Name of the compiled ``source``: a hash of the command and of all files that it may include."""
    top = Path(folder, Path(source).parts[0])
    files = top.rglob("*.[ch]") if top.is_dir() else Path(folder).rglob("*.[ch]")
    found = hashlib.sha256(repr((command, source)).encode())
    for file in sorted(files):
        found.update(f"{file.name}\0{file.stat().st_size}\0".encode() + file.read_bytes())
    return found.hexdigest()


def compile_kernel(name):
    """The kernel's library for the platform ``name`` as bytes."""
    if f"INT64_C(0x{fingerprint():015x})" not in HERE.joinpath("generated", "unit.c").read_text():
        raise CompilerProblem("the kernel's generated C does not belong to this version of its source")
    return compile_platform(name, HERE, KERNEL_UNITS, Path(library_name(name)).stem)


def has_zig():
    """Whether ziglang is installed."""
    return importlib.util.find_spec("ziglang") is not None


def compiler_for(chosen):
    """The compiler's command for a platform; CompilerProblem if there is none."""
    if has_zig():
        return [sys.executable, "-m", "ziglang", "cc", "-target", chosen.target, "-s"]
    own = next((command for command in ("cc", "gcc", "clang") if shutil.which(command)), None)
    if chosen.name == host_platform() and own:
        return [own]
    raise CompilerProblem(f"there is no compiler for {chosen.name}; pip install ziglang, a compiler for "
                          "every platform")
