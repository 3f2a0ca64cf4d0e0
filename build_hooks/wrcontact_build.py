"""PEP 517 backend: setuptools, and the compiled kernel in the wheel.

* If no C compiler works, ``ziglang`` (a C compiler as a wheel) becomes a build requirement.
* The library is written into the wheel, whose tag is then ``py3-none-<platform>``, and also beside its
  sources.  There it is used by an editable installation, and by Python started in the checkout (``python -m
  benchmarks``), which finds this package before the installed one.  Git ignores it, and the loader refuses it
  when its sources have changed.
* ``WRCONTACT_PLATFORM=x86_64-windows python -m build --wheel`` makes the wheel for another platform with
  ziglang, whatever compilers are installed; wrcontact/kernel/binding/files.py lists them.
* The FMU's sources, ``fmu_src`` at the top of the checkout, are part of the wheel as ``wrcontact/fmu_src``.
* If compilation fails, one warning is printed and the wheel is ``py3-none-any`` without a library: the
  package then runs its Python source, slowly, with a warning.  pip shows the build's warning only with
  ``-v``.

``WRCONTACT_KERNEL=python pip install .`` compiles nothing.
"""

import atexit
import contextlib
import importlib
import shutil
import sys
import tempfile
import types
from pathlib import Path

from setuptools import build_meta
from setuptools.build_meta import *  # noqa: F401,F403  the unchanged hooks
from setuptools.command.bdist_wheel import bdist_wheel
from setuptools.command.build import build
from setuptools.command.build_py import build_py

PACKAGE = Path(__file__).resolve().parents[1] / "wrcontact"
KERNEL = PACKAGE / "kernel"
SOURCES = PACKAGE.parent / "fmu_src"


def module_of_sources(name):
    """A module of the package, which is not installed yet: imported with its folders and without
    wrcontact/__init__.py, which needs numpy."""
    bare = sys.modules.setdefault("wrcontact_sources", types.ModuleType("wrcontact_sources"))
    bare.__path__ = [str(PACKAGE)]
    return importlib.import_module(f"{bare.__name__}.{name}")


compiler = module_of_sources("kernel.binding.compiler")


def get_requires_for_build_wheel(config_settings=None):
    return build_meta.get_requires_for_build_wheel(config_settings) + compiler.requirements()


def get_requires_for_build_editable(config_settings=None):
    return build_meta.get_requires_for_build_editable(config_settings) + compiler.requirements()


class FreshBuild(build):
    """``build`` in a new folder: setuptools' ``build/`` may contain modules that have been deleted since."""

    def initialize_options(self):
        super().initialize_options()
        self.build_base = tempfile.mkdtemp(prefix="wrcontact-build-")
        atexit.register(shutil.rmtree, self.build_base, ignore_errors=True)


class BuildWithKernel(build_py):
    """``build_py``, followed by the compiled library and the FMU's sources."""

    def run(self):
        super().run()
        package = PACKAGE if self.editable_mode else Path(self.build_lib, "wrcontact")
        self.distribution.has_kernel_library = compiler.wanted() and compiled_into(package / "kernel")
        if self.distribution.has_kernel_library:
            loader_into(package / "fmu")
        if not self.editable_mode:
            shutil.copytree(SOURCES, package / "fmu_src", ignore=shutil.ignore_patterns("__pycache__"))


class PlatformWheel(bdist_wheel):
    """A wheel for any Python 3; for one platform only if it contains a library."""

    def finalize_options(self):
        # tells setuptools that the wheel depends on the platform
        self.distribution.has_ext_modules = lambda: True
        super().finalize_options()

    def get_tag(self):
        if not getattr(self.distribution, "has_kernel_library", True):
            return "py3", "none", "any"
        chosen = compiler.chosen_platform()
        return "py3", "none", compiler.PLATFORMS[chosen].wheel if chosen else super().get_tag()[2]


def compiled_into(folder):
    """Compile the library into ``folder`` and into the checkout; returns False, after a warning, if that is
    not possible.

    For a platform chosen by WRCONTACT_PLATFORM it is compiled only into ``folder``, and a failure is an
    error.
    """
    if compiler.chosen_platform():
        return bool(compiler.compile_library(folder, platform=compiler.chosen_platform()))
    try:
        library = compiler.compile_library(folder)
    except (compiler.CompilerProblem, OSError) as problem:
        print(
            f"WARNING: {compiler.LIBRARY_NAME} was not built, wrcontact will run uncompiled (about 100 "
            f"times slower): {problem}",
            file=sys.stderr,
        )
        return False
    if folder != KERNEL:
        with contextlib.suppress(OSError):  # a read-only checkout
            compiler.write_atomically(KERNEL / library.name, library.read_bytes())
    return True


def loader_into(folder):
    """Compile the loader of Python FMUs into ``folder`` for a wheel of the one platform that has it: a machine
    without a compiler packs it, others compile it for each FMU."""
    if (compiler.chosen_platform() or compiler.host_platform()) == compiler.LOADER_PLATFORM:
        with contextlib.suppress(compiler.CompilerProblem, OSError):  # FMUs say it if it is missing
            compiler.compile_loader(SOURCES / "python", folder)
