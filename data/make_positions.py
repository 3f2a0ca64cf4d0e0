"""Writes positions.csv: the right wheel's patch from tread to flange, complete theory where the wheel has
come down from its rigid pose.

S1002 on UIC60 1:40, gauge 1435 mm, 78.5 kN, no yaw; rigid pose from ``brute_force``, patch from
``conformal_reference``. SI units. About five minutes on one core::

    python -m data.make_positions
"""

import csv
from pathlib import Path

from data.brute_force import rigid_contact, track
from data.conformal_reference import sunk_contact
from wrcontact.progress import tracked

OUTPUT = Path(__file__).resolve().with_name("positions.csv")
# lateral shift [mm]
POSITIONS = (0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 4.7, 5, 5.2, 5.5, 5.8, 6, 6.2, 6.3, 6.4, 6.5)
FORCE = 78.5e3  # [N]
NAMES = ("lateral_shift", "yaw", "normal_force", "right.penetration", "right.area", "right.max_pressure")


def main():
    system = track()
    with open(OUTPUT, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(NAMES)
        for shift in tracked(POSITIONS, "positions"):
            patch = sunk_contact(system, rigid_contact(system, shift * 1e-3, 0.0), "right", FORCE)
            values = (f"{value:.9g}" for value in (patch.penetration, patch.area, patch.max_pressure))
            table.writerow([round(shift * 1e-3, 9), 0.0, FORCE, *values])


if __name__ == "__main__":
    main()
