"""C compilers for the native FMU: the machine's own, or ziglang, which builds for other machines too."""

import hashlib
import importlib.util
import os
import platform
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

#: No fused a*b + c: the results are those of the kernel's Python source, to the last bit.
FLAGS = ("-std=gnu11", "-O3", "-ffp-contract=off", "-fvisibility=hidden", "-g0", "-Werror=implicit-function-declaration",
         "-DWRCONTACT_EXPORT=")


@dataclass(frozen=True)
class Platform:
    """A machine: its name in FMI 3 and FMI 2, how libraries are called there, and its name and flags for zig."""

    name: str
    fmi2: str
    suffix: str
    target: str
    flags: tuple = ()


PLATFORMS = {
    platform.name: platform
    for platform in (
        Platform("x86_64-linux", "linux64", ".so", "x86_64-linux-gnu.2.17", ("-fPIC", "-Wl,--no-undefined")),
        Platform("x86_64-windows", "win64", ".dll", "x86_64-windows-gnu"),
        Platform("aarch64-linux", "aarch64-linux", ".so", "aarch64-linux-gnu.2.17", ("-fPIC", "-Wl,--no-undefined")),
        Platform("aarch64-darwin", "aarch64-darwin", ".dylib", "aarch64-macos.11.0", ("-fPIC",)),
        Platform("x86_64-darwin", "darwin64", ".dylib", "x86_64-macos.10.15", ("-fPIC",)),
    )
}


class CompilerProblem(ValueError):
    """There is no compiler, or it failed; the message says which."""


def host_platform():
    """The name of this machine among PLATFORMS, or its like."""
    machine = {"AMD64": "x86_64", "arm64": "aarch64", "ARM64": "aarch64"}.get(platform.machine(), platform.machine())
    return f"{machine}-{platform.system().lower()}"


def compile_platform(name, folder, sources, identifier, cache):
    """The library for a platform as bytes, from ``sources`` in ``folder``.

    Compiled sources are kept in ``cache``: those in a folder of their own, as the kernel's, include nothing else, and are
    the same in every version of FMI.  The machine's own platform is compiled by its own compiler where no ziglang is installed.
    """
    if name not in PLATFORMS:
        raise CompilerProblem(f"platform is {name!r}; permitted are {', '.join(PLATFORMS)}")
    chosen = PLATFORMS[name]
    command, cache = [*compiler_for(chosen), *FLAGS, *chosen.flags], Path(cache)
    cache.mkdir(parents=True, exist_ok=True)

    def run(*arguments):
        done = subprocess.run([*command, *arguments], cwd=folder, text=True, errors="replace", stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              env={**os.environ, "ZIG_LOCAL_CACHE_DIR": str(cache), "ZIG_GLOBAL_CACHE_DIR": str(cache)})
        if done.returncode:
            raise CompilerProblem(f"{' '.join(command)} failed for {name}:\n{done.stdout}")

    def compiled(source):
        kept = cache / f"{digest(command, folder, source)}.o"
        if not kept.exists():
            part = kept.with_suffix(f".{os.getpid()}.part.o")
            run("-c", source, "-o", str(part))
            part.replace(kept)
        return str(kept)

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        objects = list(pool.map(compiled, sources))
    output = Path(folder, identifier + chosen.suffix)
    install_name = [f"-Wl,-install_name,@rpath/{identifier}.dylib"] if chosen.suffix == ".dylib" else []
    run("-shared", *install_name, *objects, "-o", output.name, *([] if chosen.suffix == ".dll" else ["-lm"]))
    return output.read_bytes()


def digest(command, folder, source):
    """A name for the compiled ``source``: of the command, and of all files that it can include."""
    top = Path(folder, Path(source).parts[0])
    files = top.rglob("*.[ch]") if top.is_dir() else Path(folder).rglob("*.[ch]")
    found = hashlib.sha256(repr((command, source)).encode())
    for file in sorted(files):
        found.update(f"{file.name}\0{file.stat().st_size}\0".encode() + file.read_bytes())
    return found.hexdigest()


def compiler_for(chosen):
    """The command of a compiler for a platform."""
    if importlib.util.find_spec("ziglang"):
        return [sys.executable, "-m", "ziglang", "cc", "-target", chosen.target, "-s"]
    own = next((command for command in ("cc", "gcc", "clang") if shutil.which(command)), None)
    if chosen.name == host_platform() and own:
        return [own]
    raise CompilerProblem(f"there is no compiler for {chosen.name}; pip install ziglang, which is one for every platform")
