"""Cost of a step of the native FMUs, from a C host, on the hunting run: set five inputs, step, get all Real
outputs.

    python -m benchmarks.native [FMU ...]

Without an argument the FMUs are built into a temporary folder.  The host is tests/helpers/native_host.c,
compiled by the system's ``cc`` against the archive alone.
"""

import json
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

from wrcontact.fmu.compilers import PLATFORMS, host_platform

from . import machine, runs
from .fmu_step import MOVED
from .table import figure, markdown

HOST = runs.TESTS / "helpers" / "native_host.c"
ROUNDS = 5
TARGET = 12.5   # units


def main(fmus=()):
    with tempfile.TemporaryDirectory() as folder:
        rows = []
        for version, measure in measures(folder, fmus):
            cost = measure()
            for _ in range(ROUNDS - 1):
                cost = measure().least(cost)
            rows.append([f"FMI {version}.0", figure(cost.units), figure(cost.microseconds)])
    print(markdown("Native FMUs from a C host, hunting with yaw: 5 inputs in, step, all outputs out",
                   ["", "units", "µs"], rows))
    print(f"Target: {TARGET} units.")
    print(machine.description())


def measures(folder, fmus=()):
    """Yield the version of FMI and a function that returns the :class:`~benchmarks.machine.Cost` of a step,
    for each of the ``fmus``; without any, they are built.  ``folder`` is for scratch."""
    if not fmus:
        from wrcontact.fmu.native import build_native_fmus

        fmus = build_native_fmus(folder)
    run = runs.stored(runs.HUNTING)
    file = Path(folder, "rows.txt")
    file.write_text(rows_text([{name: run[name][k] if name in run else 0.0 for name in MOVED}
                               for k in range(len(run["lateral_shift"]))]))
    for number, fmu in enumerate(fmus):
        with zipfile.ZipFile(fmu) as archive:
            version = 3 if "sources/buildDescription.xml" in archive.namelist() else 2
        host = native_host(fmu, version, Path(folder, f"native{number}"))
        yield version, lambda host=host: measured(host, file)


def measured(host, file):
    """:class:`~benchmarks.machine.Cost` of a step, after a measurement of the unit."""
    one = machine.unit()
    done = subprocess.run([str(host), "cost", str(file)], text=True, capture_output=True, check=True)
    return machine.Cost(1e-6 * json.loads(done.stdout)["microseconds"], one)


def rows_text(rows):
    """Rows of inputs as native_host reads them."""
    return "".join(" ".join(repr(float(row[name])) for name in MOVED) + "\n" for row in rows)


def native_host(fmu, version, folder):
    """The program native_host, compiled with the headers and linked with the library in an FMU, unpacked into
    ``folder``."""
    with zipfile.ZipFile(fmu) as archive:
        archive.extractall(folder)
    place = PLATFORMS[host_platform()]
    binaries = Path(folder, "binaries", place.fmi2 if version == 2 else place.name).resolve()
    library = binaries / f"WheelsetContact{place.suffix}"
    sources = Path(folder, "sources")
    shutil.copy(HOST, sources)
    subprocess.run(["cc", "-std=gnu11", "-O2", f"-DFMI={version}", "-DINTERPOSE", HOST.name, "model.c",
                    str(library), f"-Wl,-rpath,{binaries}", "-o", "native_host", "-lm", "-pthread"],
                   cwd=sources, check=True)
    return sources / "native_host"


if __name__ == "__main__":
    main(sys.argv[1:])
