"""Make wrcontact/kernel/data/rolling_correction.npz: ``python tools/make_rolling_correction.py``.

What the exact forces of ellipses (tools/make_rolling_tables.py) differ from those of the kernel's strips by,
at the nodes of both: force over mu N and moment over mu N sqrt(ab), in units of 2e-5.  It has to be made anew
after every change of the strips or of the exact forces, and takes a second with a compiled kernel.

    --check          compare with the stored file, write nothing
    --folder DIR     where the exact forces are
"""

import argparse
import sys
from pathlib import Path

import numpy as np

from wrcontact.creep.elliptic_nodes import EXACT, corrections
from wrcontact.kernel.binding import rolling_table


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--folder", type=Path, default=EXACT)
    options = parser.parse_args()
    made = corrections(options.folder)
    if options.check:
        with np.load(rolling_table.CORRECTION) as stored:
            apart = np.abs(stored["correction"].astype(float) - made["correction"]).max()
        print(f"the largest difference from the stored correction is {apart:.0f} of its units")
        return
    np.savez_compressed(rolling_table.CORRECTION, **made)
    print(rolling_table.CORRECTION)


if __name__ == "__main__":
    sys.exit(main())
