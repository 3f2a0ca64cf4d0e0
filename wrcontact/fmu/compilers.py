"""C compilers for the native FMU: the machine's own, or ziglang, which builds for other machines too."""

import importlib.util
import os
import platform
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

#: No fused a*b + c: the results are those of the kernel's Python source, to the last bit.
FLAGS = ("-std=gnu11", "-O3", "-ffp-contract=off", "-fvisibility=hidden", "-g0", "-Werror=implicit-function-declaration",
         "-DWRCONTACT_EXPORT=", "-shared")


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
    """The library for a platform as bytes, from ``sources`` in ``folder``; zig keeps what it made in ``cache``.

    The machine's own platform is compiled by its own compiler where no ziglang is installed.
    """
    if name not in PLATFORMS:
        raise CompilerProblem(f"platform is {name!r}; permitted are {', '.join(PLATFORMS)}")
    chosen = PLATFORMS[name]
    command = compiler_for(chosen)
    flags = [*FLAGS, *chosen.flags]
    if chosen.suffix == ".dylib":
        flags.append(f"-Wl,-install_name,@rpath/{identifier}.dylib")
    output = Path(folder, identifier + chosen.suffix)
    run = subprocess.run([*command, *flags, *sources, "-o", output.name, *([] if chosen.suffix == ".dll" else ["-lm"])],
                         cwd=folder, text=True, errors="replace", stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT,
                         env={**os.environ, "ZIG_LOCAL_CACHE_DIR": str(cache), "ZIG_GLOBAL_CACHE_DIR": str(cache)})
    if run.returncode:
        raise CompilerProblem(f"{' '.join(command)} failed for {name}:\n{run.stdout}")
    return output.read_bytes()


def compiler_for(chosen):
    """The command of a compiler for a platform."""
    if importlib.util.find_spec("ziglang"):
        return [sys.executable, "-m", "ziglang", "cc", "-target", chosen.target, "-s"]
    own = next((command for command in ("cc", "gcc", "clang") if shutil.which(command)), None)
    if chosen.name == host_platform() and own:
        return [own]
    raise CompilerProblem(f"there is no compiler for {chosen.name}; pip install ziglang, which is one for every platform")
