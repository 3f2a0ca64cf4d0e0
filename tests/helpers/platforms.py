"""What tests of several platforms need, and what a library has to export."""

import importlib.util
import os

import pytest

from wrcontact.kernel.binding.files import PLATFORMS, host_platform

REFERENCE = "x86_64-linux"  # the platform that others are compared with
KERNEL_EXPORTS = {
    f"wrcontact_{name}"
    for name in (
        "abi",
        "step",
        "step_many",
        "divide_into_strips",
        "solve_creep_force",
        "derivative",
        "derivative_room",
        "jacobian",
        "jacobian_room",
        "prepare",
        "prepare_room",
        "search_sections",
        "step_changing",
        "step_changing_many",
    )
}
#: Those of the kernel in a Python FMU, which has no derivatives along many directions, and no rails that change.
FMU_KERNEL_EXPORTS = {
    name for name in KERNEL_EXPORTS if not any(part in name for part in ("jacobian", "sections", "changing"))
}


def needs(condition, reason):
    return pytest.mark.skipif(not condition, reason=reason)


def needs_importer(module):
    """One of the extra "importers"; with WRCONTACT_IMPORTERS=all nothing is skipped."""
    return needs(
        importlib.util.find_spec(module) or os.environ.get("WRCONTACT_IMPORTERS") == "all",
        f"{module} is not installed",
    )


def for_platforms(reason, *packages):
    """A test of the platforms needs these packages of the extra "platforms", which .ci/run installs for such
    tests alone: with ziglang there, FMUs for this machine are compiled by it too."""
    skips = needs(all(map(importlib.util.find_spec, packages)), reason)
    return lambda test: pytest.mark.platforms(skips(test))


needs_zig = for_platforms("ziglang is not installed", "ziglang")
needs_lief = for_platforms("lief, which reads libraries of every platform, is not installed", "lief")
needs_build = for_platforms("build or setuptools is not installed", "build", "setuptools")
needs_reference = needs(
    host_platform() == REFERENCE, f"this is not {REFERENCE}, with whose values others are compared"
)

MACHINES = {
    "x86_64-linux": "X86_64",
    "aarch64-linux": "AARCH64",
    "x86_64-windows": "AMD64",
    "aarch64-darwin": "ARM64",
    "x86_64-darwin": "X86_64",
}


def parsed(content):
    """A library as lief reads it."""
    import lief

    read = lief.parse(list(content))
    return read.at(0) if isinstance(read, lief.MachO.FatBinary) else read


#: Functions of the mathematical libraries, whose last bits differ from machine to machine.
MATHEMATICS = set(
    "acos asin atan atan2 cbrt ceil cos cosh exp exp2 expm1 floor fma fmax fmin fmod hypot log "
    "log10 log1p log2 pow rint round sin sincos sinh sqrt tan tanh trunc".split()
)


def check_library(content, name, identifier, wanted):
    """Right machine, nothing needed beyond the C library of the oldest system promised,
    exactly ``wanted`` exported."""
    read, suffix = parsed(content), PLATFORMS[name].suffix
    imported = {function.name.lstrip("_") for function in read.imported_functions}
    assert imported and not imported & MATHEMATICS
    if suffix == ".so":
        assert read.header.machine_type.name == MACHINES[name]
        assert set(read.libraries) <= {"libc.so.6"}
        versions = [
            symbol.name
            for need in read.symbols_version_requirement
            for symbol in need.get_auxiliary_symbols()
        ]
        assert versions
        assert all(tuple(map(int, text.removeprefix("GLIBC_").split("."))) <= (2, 17) for text in versions)
        exported = {symbol.name for symbol in read.exported_symbols}
    elif suffix == ".dll":
        assert read.header.machine.name == MACHINES[name]
        system = ("kernel32", "api-ms-win-crt-")  # part of Windows 10
        assert all(library.name.lower().startswith(system) for library in read.imports), [
            lib.name for lib in read.imports
        ]
        exported = {function.name for function in read.exported_functions}
    else:
        assert read.header.cpu_type.name == MACHINES[name]
        assert [library.name for library in read.libraries] == [
            f"@rpath/{identifier}.dylib",
            "/usr/lib/libSystem.B.dylib",
        ]
        assert read.build_version.minos == ([11, 0, 0] if name == "aarch64-darwin" else [10, 15, 0])
        # Apple's own machines ask for it
        assert read.has_uuid and (read.has_code_signature or name == "x86_64-darwin")
        exported = {symbol.name for symbol in read.exported_symbols} - {"__mh_dylib_header", "___dso_handle"}
        exported = {symbol.removeprefix("_") for symbol in exported}
    assert exported == wanted
