"""The platforms that libraries are built for, and what the kernel's library is called on each.

Standard library only and no imports from the package, so that build tools can run this file by its path.
"""

import platform
import sys
import sysconfig
from typing import NamedTuple


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
        Platform("x86_64-linux", "linux64", "manylinux_2_17_x86_64.manylinux2014_x86_64",
                 "x86_64-linux-gnu.2.17", ".so"),
        Platform("x86_64-windows", "win64", "win_amd64", "x86_64-windows-gnu", ".dll"),
        Platform("aarch64-linux", "aarch64-linux", "manylinux_2_17_aarch64.manylinux2014_aarch64",
                 "aarch64-linux-gnu.2.17", ".so"),
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
    return f"_wrcontact_kernel-{name}" + {"windows": ".dll", "cygwin": ".dll",
                                          "darwin": ".dylib"}.get(system, ".so")


#: Of the library that this Python loads.
LIBRARY_NAME = library_name(host_platform())
