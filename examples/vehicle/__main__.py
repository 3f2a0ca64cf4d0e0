"""All runs, their checks in a line each, and their picture.

    pip install "wrcontact[vehicle]"
    python -m examples.vehicle [FOLDER]

prints them and draws FOLDER/vehicle.png (default: out).  It takes a minute or two.
"""

import sys
from pathlib import Path

import numpy as np

from wrcontact.plots.style import save

from . import hunting, runs, theory
from . import manchester as data

folder = Path((sys.argv[1:] or ["out"])[0])
stands = runs.weight()
loads = np.concatenate([stands["left_load"], stands["right_load"]])
print(f"load of a wheel {loads.min():.1f} ... {loads.max():.1f} N, weight {data.LOAD / 2:.1f} N")
half, growths = hunting.touching(), {}
for speed in hunting.SPEEDS:
    wanted = theory.root(speed, half)
    growths[speed], rate, _ = hunting.grown(speed, wanted.imag)
    print(
        f"{speed:g} m/s: growth {growths[speed]:+.3f} 1/s, theory {wanted.real:+.3f}; "
        f"{rate:.3f} rad/s, theory {wanted.imag:.3f}"
    )
print(
    f"critical speed {hunting.critical_speed(hunting.SPEEDS, list(growths.values())):.2f} m/s, "
    f"theory {theory.critical_speed(half):.2f}"
)
bulged, curved, shaken = runs.over_bulge("`RK44`"), runs.through_curve(), runs.on_irregular_track()
print("in the curve: lateral force {:.0f} N, m v^2 / R {:.0f} N".format(*runs.needed_in_curve(curved)))
folder.mkdir(parents=True, exist_ok=True)
save(runs.draw(growths, bulged, curved, shaken), folder / "vehicle.png")
