"""Time of a step of the native FMUs, from C: native_times.c, linked with the library in an FMU."""

import math
import subprocess
from pathlib import Path

from fmpy import extract, read_model_description

from wrcontact.kernel.binding.files import PLATFORMS, host_platform

SOURCE = Path(__file__).with_name("native_times.c")


def linked_program(fmu, version, folder):
    """Path of the program, compiled with the headers and linked with the library in an FMU for this ``version`` of
    FMI, which is unpacked into ``folder``."""
    extract(str(fmu), str(folder))
    place = PLATFORMS[host_platform()]
    binaries = Path(folder, "binaries", place.fmi2 if version == 2 else place.name).resolve()
    library, program = binaries / f"WheelsetContact{place.suffix}", Path(folder, SOURCE.stem)
    command = ["cc", "-std=gnu11", "-O2", f"-DFMI={version}", f"-I{Path(folder, 'sources')}", SOURCE, library]
    subprocess.run([*command, f"-Wl,-rpath,{binaries}", "-o", program], check=True)
    return program


class NativeStep:
    """The step of a native FMU over rows of ``inputs``, {name: (n,)}: set them, step, read all Real outputs."""

    def __init__(self, fmu, version, folder, inputs):
        described = read_model_description(str(fmu))
        references = {v.name: v.valueReference for v in described.modelVariables}
        outputs = [
            v for v in described.modelVariables if v.causality == "output" and v.type in ("Real", "Float64")
        ]
        rows = [*zip(*inputs.values())]
        lines = [
            (len(inputs), len(outputs), sum(math.prod(v.shape or ()) for v in outputs), len(rows)),
            [references[name] for name in inputs],
            [v.valueReference for v in outputs],
            *rows,
        ]
        self._token = described.instantiationToken or described.guid
        self._program = linked_program(fmu, version, folder)
        self._file = Path(folder, "rows.txt")
        self._file.write_text("".join(" ".join(map(repr, map(_plain, line))) + "\n" for line in lines))

    def microseconds(self):
        """Of a step, the least of several rounds."""
        command = [str(self._program), self._token, str(self._file)]
        return float(subprocess.run(command, text=True, capture_output=True, check=True).stdout)


def _plain(number):
    return number if isinstance(number, int) else float(number)
