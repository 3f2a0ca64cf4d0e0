"""Pack the FMU and print its path: ``python build_fmu.py [--native] [--output DIR] [--wheel FILE] [--rail FILE]``.

The door to ``wrcontact.fmu``.  Where an installed wrcontact is the one of this folder it is taken, because it has the
compiled kernel; otherwise the source here, compiled or not.
"""

import sys
from importlib.util import find_spec
from pathlib import Path

HERE = Path(__file__).resolve().parent


def use_installed():
    """Put this folder to the end of sys.path, where that finds an installed wrcontact of the same source."""
    elsewhere = [entry for entry in sys.path if Path(entry or ".").resolve() != HERE]
    sys.path[:] = [*elsewhere, str(HERE)]
    package = Path(find_spec("wrcontact").origin).parent
    if not (same(HERE / "wrcontact", package) and same(HERE / "fmu_src", package / "fmu_src")):
        sys.path[:] = [str(HERE), *elsewhere]


def same(source, copy):
    """Whether every module of ``source`` is in ``copy`` too."""
    files = {file: copy / file.relative_to(source) for file in source.rglob("*.py")}
    return all(twin.is_file() and twin.read_bytes() == file.read_bytes() for file, twin in files.items())


if __name__ == "__main__":
    use_installed()
    from wrcontact.fmu.command import main

    sys.exit(main())
