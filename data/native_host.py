"""Compiles native_host.c, which runs rows of inputs through a native FMU from C."""

import shutil
import subprocess
import zipfile
from pathlib import Path

from wrcontact.kernel.binding.files import PLATFORMS, host_platform

HOST = Path(__file__).with_name("native_host.c")
#: Inputs of a row; height and roll of compliant contact stay at their start values.
MOVED = ("lateral_shift", "yaw", "roll_guess", "normal_force", "load_transfer")


def rows_text(rows):
    """Rows of inputs as the program reads them."""
    return "".join(" ".join(repr(float(row[name])) for name in MOVED) + "\n" for row in rows)


def native_host(fmu, version, folder):
    """The program, compiled with the headers and linked with the library in an FMU, which is unpacked into
    ``folder``."""
    with zipfile.ZipFile(fmu) as archive:
        archive.extractall(folder)
    place = PLATFORMS[host_platform()]
    binaries = Path(folder, "binaries", place.fmi2 if version == 2 else place.name).resolve()
    library = binaries / f"WheelsetContact{place.suffix}"
    sources = Path(folder, "sources")
    shutil.copy(HOST, sources)
    subprocess.run(
        [
            "cc",
            "-std=gnu11",
            "-O2",
            f"-DFMI={version}",
            "-DINTERPOSE",
            HOST.name,
            "model.c",
            str(library),
            f"-Wl,-rpath,{binaries}",
            "-o",
            "native_host",
            "-lm",
            "-pthread",
        ],
        cwd=sources,
        check=True,
    )
    return sources / "native_host"
