"""Pack the FMU and print its path: ``python build_fmu.py [--native] [--output DIR] [--wheel FILE] [--rail
FILE]``.

This is the command ``wrcontact build``.  If an installed wrcontact has the same source as this folder, it is
used, because it contains the compiled kernel; otherwise the source in this folder is used.
"""

import sys
from importlib.util import find_spec
from pathlib import Path

HERE = Path(__file__).resolve().parent


def use_installed():
    """Move this folder to the end of sys.path if an installed wrcontact has the same source."""
    elsewhere = [entry for entry in sys.path if Path(entry or ".").resolve() != HERE]
    sys.path[:] = [*elsewhere, str(HERE)]
    package = Path(find_spec("wrcontact").origin).parent
    if not (same(HERE / "wrcontact", package) and same(HERE / "fmu_src", package / "fmu_src")):
        sys.path[:] = [str(HERE), *elsewhere]


def same(source, copy):
    """Whether ``copy`` contains every module of ``source``, unchanged."""
    files = {file: copy / file.relative_to(source) for file in source.rglob("*.py")}
    return all(twin.is_file() and twin.read_bytes() == file.read_bytes() for file, twin in files.items())


if __name__ == "__main__":
    use_installed()
    from wrcontact.cli import main

    main(["build", *sys.argv[1:]], prog_name="build_fmu.py")
