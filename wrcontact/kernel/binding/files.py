"""The files of the kernel: which are its source, which version they are, and what its library is called on
each of the platforms that libraries are built for.

Standard library only and no imports from the package, so that build tools can run this file by its path.
"""

import hashlib
import platform
import sys
import sysconfig
from pathlib import Path
from typing import NamedTuple

HERE = Path(__file__).resolve().parents[1]
#: The rooms of the kernel, from upstream to downstream; a module imports from its own room
#: and from those before it.
ROOMS = (
    "layout",
    "elementary",
    "surface",
    "search",
    "sections",
    "contact",
    "patch",
    "normal",
    "creep",
    "wheelset",
    "prepare",
    "changing",
    "derivative",
)
HANDLE_VERSION = 9  # raise when the functions or the handle in native/*.h change


def kernel_modules(folder=HERE):
    """Paths of the modules that are translated, sorted by room and name; the records of the room
    layout are one of them."""
    return [
        path
        for path in kernel_sources(folder)
        if (path.parent.name == "layout") == (path.name == "__init__.py")
    ]


def kernel_sources(folder=HERE):
    """Paths of all that the generated C follows from."""
    return [path for room in ROOMS for path in sorted(Path(folder, room).glob("*.py"))]


def fingerprint(folder, layout):
    """One positive 60-bit integer that tells one kernel source from another.

    ``layout`` is the digest of the room layout, whose records follow from the table in wrcontact/interface.

    It is written into the generated C and answered by ``wrcontact_abi()``, so a library compiled from other
    sources than the ones beside it is recognised. Line ends do not count: a checkout may change them.
    """
    digest = hashlib.sha256(b"handle %d, layout %s" % (HANDLE_VERSION, layout.encode()))
    for path in kernel_sources(folder):
        text = path.read_bytes().replace(b"\r\n", b"\n")
        digest.update(b"\0%s\0%d\0" % (path.relative_to(folder).as_posix().encode(), len(text)))
        digest.update(text)
    return int(digest.hexdigest()[:15], 16)


class Platform(NamedTuple):
    """A platform: its names in FMI 3, in FMI 2, in wheels and for zig, and how libraries end there."""

    name: str
    fmi2: str
    wheel: str
    target: str
    suffix: str

    def link_flags(self, library):
        """What the compiler is told for a shared library of this file name."""
        if self.suffix == ".dylib":
            return [f"-Wl,-install_name,@rpath/{library}"]
        return ["-Wl,--no-undefined"] if self.suffix == ".so" else []


PLATFORMS = {
    place.name: place
    for place in (
        Platform(
            "x86_64-linux",
            "linux64",
            "manylinux_2_17_x86_64.manylinux2014_x86_64",
            "x86_64-linux-gnu.2.17",
            ".so",
        ),
        Platform("x86_64-windows", "win64", "win_amd64", "x86_64-windows-gnu", ".dll"),
        Platform(
            "aarch64-linux",
            "aarch64-linux",
            "manylinux_2_17_aarch64.manylinux2014_aarch64",
            "aarch64-linux-gnu.2.17",
            ".so",
        ),
        Platform("aarch64-darwin", "aarch64-darwin", "macosx_11_0_arm64", "aarch64-macos.11.0", ".dylib"),
        Platform("x86_64-darwin", "darwin64", "macosx_10_15_x86_64", "x86_64-macos.10.15", ".dylib"),
    )
}


def host_platform():
    """The name of the platform that this Python runs on, among PLATFORMS or like them."""
    # In Windows the Python's own machine, which need not be the computer's.
    machine = sysconfig.get_platform().removeprefix("win-") if sys.platform == "win32" else platform.machine()
    machine = {"amd64": "x86_64", "arm64": "aarch64", "win32": "x86"}.get(machine, machine)
    return machine + "-" + {"win32": "windows"}.get(sys.platform, sys.platform)


def library_name(name):
    """File name of the kernel's library for the platform of this name."""
    system = name.rpartition("-")[2]
    return f"_wrcontact_kernel-{name}" + {"windows": ".dll", "cygwin": ".dll", "darwin": ".dylib"}.get(
        system, ".so"
    )


#: Of the library that this Python loads.
LIBRARY_NAME = library_name(host_platform())
