"""Pack the FMU and print its path: ``python build_fmu.py [--output DIR] [--wheel FILE] [--rail FILE]``.

The door to ``wrcontact.fmu``.  The installed wrcontact is packed, because that is the one with a compiled kernel; with
``pip install -e .`` it is the source here.
"""

import sys
from pathlib import Path

HERE = str(Path(__file__).resolve().parent)
sys.path[:] = [entry for entry in sys.path if str(Path(entry or ".").resolve()) != HERE] + [HERE]

from wrcontact.fmu.build import main  # noqa: E402

if __name__ == "__main__":
    sys.exit(main())
