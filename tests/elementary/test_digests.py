"""The kernel gives the same bits on every machine: digests of what it computes are the stored ones.

Where results are meant to change, ``python -m tests.helpers.digests --write`` stores them anew.
"""

import os
import shutil
import subprocess
import sys

import numpy as np
import pytest

from tests.helpers import digests
from tests.helpers.kernel_runs import needs_library
from tests.helpers.paths import ROOT
from tests.helpers.platforms import needs, needs_zig
from tools.make_fixed_tables import made_tables
from wrcontact.kernel.binding.compiler import compiler_for, find_compiler
from wrcontact.kernel.binding.files import PLATFORMS, host_platform
from wrcontact.kernel.binding.fixed_tables import stored_tables
from wrcontact.kernel.binding.library import Kernel
from wrcontact.kernel.layout import INFLUENCE_MAP

pytestmark = pytest.mark.full
FEW, SOME, MANY = 3, 25, 100  # emulation is slow
PARTS = 4  # of the cases, for emulation
#: Cases of the uncompiled kernel, which takes seconds for the others.
PLAIN = [
    "rigid-hertz-polach",
    "rigid-analyn-strips",
    "rigid-analyn_strip-fastrip",
    "elastic-analyn-fastsim",
    "compliant-analyn-strips",
    "strips-0.3-0.5-0.4-0.6-0.5-0.5-0.3",
]
#: A processor without wide vectors and fused multiply-add, as glibc, numpy and OpenBLAS see it.
OLD_PROCESSOR = {
    "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-AVX2_Usable,-FMA_Usable",
    "OPENBLAS_CORETYPE": "Haswell",
}
FEATURES = (
    "import numpy._core._multiarray_umath as m; "
    "print(*(f for f in m.__cpu_dispatch__ if m.__cpu_features__[f]))"
)


def test_the_digests_are_of_all_models():
    """And each of them is of something else."""
    stored = digests.stored()
    assert list(stored) == list(digests.cases()) and len(stored) > 50
    page = (ROOT / "docs/evidence/reliability.md").read_text(encoding="utf-8")
    assert f"digests of {MANY} poses and ten rows of derivatives in each of {len(stored)} cases" in page
    assert f"the same, of {SOME} poses" in page and digests.DERIVATIVES == 10
    assert all(set(parts) == {"tables", *map(str, digests.PARTS), "rates"} for parts in stored.values())
    last = [parts[str(digests.POSES)] for parts in stored.values()]
    assert len(set(last)) == len(last)


def test_a_digest_follows_the_last_bit():
    values = np.linspace(0.0, 1.0, 5)
    moved = values.copy()
    moved[3] = np.nextafter(moved[3], 2.0)
    assert digests.digest(values) != digests.digest(moved)
    none = np.array([0x7FF8000000000000, 0xFFF8000000000001], np.uint64).view(float)  # as ARM and x86 do
    assert digests.digest(none[:1]) == digests.digest(none[1:])


@needs_library
def test_of_this_kernel():
    assert digests.differences(digests.run(count=MANY)) == []


@needs_library
def test_on_an_old_processor():
    features = subprocess.run([sys.executable, "-c", FEATURES], text=True, capture_output=True, check=True)
    environment = {**os.environ, **OLD_PROCESSOR, "NPY_DISABLE_CPU_FEATURES": features.stdout.strip()}
    done = subprocess.run(
        [sys.executable, "-m", "tests.helpers.digests", "--count", str(MANY)],
        cwd=ROOT,
        env=environment,
        text=True,
        capture_output=True,
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_of_the_uncompiled_kernel():
    found = digests.run(Kernel(), FEW, PLAIN)
    assert len(found) == len(PLAIN) and digests.differences(found) == []


@needs_zig
def test_of_a_library_that_zig_builds():
    """As for a wheel of this platform."""
    kernel = digests.built_kernel(compiler_for(PLATFORMS[host_platform()]))
    assert digests.differences(digests.run(kernel, MANY)) == []


@needs_zig
@pytest.mark.parametrize("part", range(PARTS))
@pytest.mark.parametrize(
    "name",  # the library above is of the same compiler as the program for x86_64-linux
    [pytest.param(name, marks=[pytest.mark.complete][: name == "x86_64-linux"]) for name in digests.TARGETS],
)
@pytest.mark.turns(PARTS)
def test_on_other_machines(name, part):
    if name != host_platform() and not shutil.which(digests.EMULATORS.get(name, "-")):
        pytest.skip(f"{digests.EMULATORS.get(name, 'an emulator')} is not installed")
    found = digests.emulated(name, SOME, list(digests.cases())[part::PARTS])
    assert len(found) > 10 and digests.differences(found) == []


@needs(sys.platform == "linux", "the processor's features are read from Linux")
def test_of_a_library_with_fused_multiply_add():
    """A compiler that may use it does not: contraction is off."""
    with open("/proc/cpuinfo") as file:
        if " fma " not in file.read():
            pytest.skip("this processor has no fused multiply-add")
    compiler = find_compiler()
    if compiler is None:
        pytest.skip("there is no compiler")
    found = digests.run(digests.built_kernel(compiler, ["-march=haswell", "-mtune=haswell"]), MANY)
    assert digests.differences(found) == []


def test_the_stored_tables_are_those_of_the_tool():
    """Numpy's functions differ by processor: the last bits of values count once (1e-12), in slopes by
    differences over a thousandth of a cell, a thousand times; where lines of pressure lie close together, 1e-3,
    their sums are divided by that (measured: 1.2e-8).  Nothing of that is seen beside the tables' own errors,
    1e-12 and 1e-7."""
    made = made_tables()
    for name, part, allowed in (
        ("hertz", slice(None), 1e-11),
        ("influence", slice(None, INFLUENCE_MAP), 1e-9),
        ("influence", slice(INFLUENCE_MAP, None), 5e-8),
        ("rolling", slice(None), 1e-11),
    ):
        stored, found = stored_tables()[name], made[name]
        assert len(stored) == len(found), name
        apart = np.abs(found - stored)[part] / np.maximum(np.abs(stored), 1.0)[part]
        assert apart.max() < allowed, (name, apart.max())
