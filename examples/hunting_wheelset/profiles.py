"""Wheel profiles of the closed loop: a cone with a flange, as a file."""

from pathlib import Path

import numpy as np

#: Slope of the cone: 1:20.
SLOPE = 0.05


def cone_wheel(folder, slope=SLOPE):
    """File of a wheel in ``folder``: a cone as far as 30 mm from the running circle, then a round flange of 28
    mm; points [mm]."""
    y = np.arange(-58.0, 60.01, 0.5)
    z = -slope * y + 0.04 * np.minimum(y + 30.0, 0.0) ** 2
    file = Path(folder, f"cone_1_{1 / slope:.0f}.txt")
    file.parent.mkdir(parents=True, exist_ok=True)
    np.savetxt(file, np.column_stack([y, z]), fmt="%.6f")
    return file
