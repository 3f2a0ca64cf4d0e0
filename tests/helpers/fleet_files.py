"""Files of a fleet: worn wheels and worn rails with noise, as an instrument writes them.

``python -m tests.helpers.fleet_files FOLDER`` writes 30 wheels and 10 rails, those of the measurement in
docs/guides/fleets.md.
"""

import sys
from pathlib import Path

import numpy as np

from data.noisy_profiles import even_points

NOISE = 5e-3  # [mm]
SPACING = 0.2  # [mm]


def worn_wheel(number):
    """y, z (n,) [mm] of S1002 with a hollow tread and a thinner flange that grow with the ``number``."""
    y, z = even_points("wheel", SPACING)
    z = z - 0.05 * number * np.exp(-((y / 25.0) ** 2))
    return _noisy(y + 0.02 * number * (y < -30.0) * np.clip((-30.0 - y) / 5.0, 0.0, 1.0), z, 100 + number)


def worn_rail(number):
    """y, z (n,) [mm] of UIC60 with a flatter head and a worn gauge corner that grow with the ``number``."""
    y, z = even_points("rail", SPACING)
    return _noisy(y, z + 0.03 * number * np.exp(-(((y + 15.0) / 12.0) ** 2)), 200 + number)


def _noisy(y, z, seed):
    random = np.random.default_rng(seed)
    return y + random.normal(0.0, NOISE, len(y)), z + random.normal(0.0, NOISE, len(z))


def write_fleet(folder, wheels, rails):
    """Write so many files into ``folder``/wheels and ``folder``/rails; both folders."""
    folders = []
    for name, count, make in (("wheels", wheels, worn_wheel), ("rails", rails, worn_rail)):
        place = Path(folder, name)
        place.mkdir(parents=True, exist_ok=True)
        for number in range(count):
            np.savetxt(place / f"{name[:-1]}{number:02d}.txt", np.transpose(make(number)), fmt="%.5f")
        folders.append(place)
    return tuple(folders)


if __name__ == "__main__":
    write_fleet(sys.argv[1], 30, 10)
