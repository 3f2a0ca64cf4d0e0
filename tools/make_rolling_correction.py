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

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from tools.tables.strip_nodes import EXACT, corrections  # noqa: E402
from wrcontact.kernel.binding.fixed_tables import CORRECTION  # noqa: E402


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--folder", type=Path, default=EXACT)
    options = parser.parse_args()
    made = corrections(options.folder)
    if options.check:
        with np.load(CORRECTION) as stored:
            apart = np.abs(stored["correction"].astype(float) - made["correction"]).max()
        print(f"the largest difference from the stored correction is {apart:.0f} of its units")
        return
    np.savez_compressed(CORRECTION, **made)
    print(CORRECTION)


if __name__ == "__main__":
    sys.exit(main())
