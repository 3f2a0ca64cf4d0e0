"""The Manchester contact benchmark, A-2.2: CONTACT's creep forces of a wheelset, and ours.

The benchmark's wheelset shifts by 0 ... 10 mm and yaws by 2.4 mrad for each; 10 kN on each rail, friction
0.3, 2 m/s, S1002 on UIC60.  Its forces are on the rail, so that Fx is the opposite of ours; Fs is that on the
wheel towards y_c, to the left on both sides (README.md).
"""

import csv
from functools import cache

import numpy as np

import wrcontact

from . import FOLDER

SHEAR, POISSON, FRICTION = 82e9, 0.28, 0.3
system = cache(wrcontact.ContactSystem)


def rows():
    with open(FOLDER / "manchester_a22_creepages.csv", newline="", encoding="utf-8") as file:
        return [
            {key: text if key == "side" else float(text) for key, text in row.items()}
            for row in csv.DictReader(file)
        ]


def wheel(row, model, mode="elastic"):
    """The wheel of one row."""
    one = system(
        youngs_modulus=2 * SHEAR * (1 + POISSON),
        poisson_ratio=POISSON,
        load="vertical",
        contact_mode=mode,
        tangential_model=model,
    )
    state = one.evaluate(
        1e-3 * row["lateral_shift_mm"],
        row["yaw_rad"],
        10e3,
        speed=2.0,
        wheel_rate=-row["pitch_rate_rad_s"],
        left_friction=FRICTION,
        right_friction=FRICTION,
    )
    assert state.status == 0
    return getattr(state, row["side"])


def error(row, found):
    """Difference of the force in the plane of the patch, of mu N."""
    left = 1 if row["side"] == "left" else -1  # ours is to the field side
    along = sum(patch.tangential.x for patch in found.patches) + row["Fx_N"]
    across = left * sum(patch.tangential.y for patch in found.patches) - row["Fs_N"]
    return np.hypot(along, across) / (FRICTION * row["FN_N"])
