"""The C host of the native FMUs, tests/fmu/native/host.c: how it is built, and its answers."""

import json
import shutil
import subprocess
import tempfile
import zipfile
from pathlib import Path

import pytest

from tests.helpers.fmus import header_functions, unpacked_library
from tests.helpers.paths import TESTS

SOURCE = TESTS / "fmu" / "native" / "host.c"
#: Inputs of a row that the host reads; height and roll of compliant contact stay at their start values.
MOVED = ("lateral_shift", "yaw", "roll_guess", "normal_force", "load_transfer")
HOOKS = ["-Dmalloc=hooked_malloc", "-Dcalloc=hooked_calloc", "-Drealloc=hooked_realloc"]
#: Little optimised: the compiler takes 17 s for the kernel, with -O1 41 s.
SANITIZERS = (
    "-Og",
    "-DWRCONTACT_CHECK_BOUNDS",
    "-fsanitize=address,undefined,float-cast-overflow",
    "-fno-sanitize-recover=all",
)
RACES = ("-Og", "-fsanitize=thread")


def can_use(flags):
    """Whether the system's compiler links a program with these flags, and it runs."""
    if not shutil.which("cc"):
        return False
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "probe.c").write_text("int main(void) { return 0; }\n")
        made = subprocess.run(["cc", *flags, "probe.c", "-o", "probe"], cwd=folder, capture_output=True)
        return made.returncode == 0 and subprocess.run([str(Path(folder, "probe"))]).returncode == 0


needs_sanitizers = pytest.mark.skipif(not can_use(SANITIZERS), reason="no sanitizers here")
needs_race_detector = pytest.mark.skipif(not can_use(RACES), reason="no thread sanitizer here")


def linked_host(fmu, version, folder):
    """The program with the library in an FMU, which is unpacked into ``folder``; every allocation of its process is
    counted."""
    with zipfile.ZipFile(fmu) as archive:
        archive.extractall(folder)
    library = unpacked_library(fmu, version, folder)
    sources = shutil.copy(SOURCE, folder / "sources"), folder / "sources" / "model.c"
    flags = ["-std=gnu11", "-O2", f"-DFMI={version}", "-DINTERPOSE", f"-Wl,-rpath,{library.parent}"]
    program = folder / "host"
    subprocess.run(["cc", *flags, *sources, library, "-o", program, "-lm", "-pthread"], check=True)
    return program


def rows_text(rows):
    """Rows of inputs as the host reads them."""
    return "".join(" ".join(repr(float(row[name])) for name in MOVED) + "\n" for row in rows)


def answer_of(program, *arguments):
    done = subprocess.run([str(program), *map(str, arguments)], text=True, capture_output=True, timeout=1800)
    assert done.returncode == 0, f"{done.stdout[-3000:]}\n{done.stderr[-4000:]}"
    return json.loads(done.stdout)


def fuzz(program, version, seed, calls):
    """Random calls, legal and illegal, with allocations that fail now and then; what they reached."""
    counted = answer_of(program, "fuzz", seed, calls)
    assert counted["calls"] == calls and counted["odd_lines"] == counted["damage_accepted"] == 0
    assert counted["valid_steps"] > 0.03 * calls and counted["lines"] > 0.1 * calls
    assert set(counted["functions"]) == set(header_functions(version)), (
        "every function of the standard is called"
    )
    return counted
