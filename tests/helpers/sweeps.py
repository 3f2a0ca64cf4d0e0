"""Small sweeps that several tests share."""

import numpy as np

import wrcontact

#: Axes in the order of the dimensions; 480 states, the last shifts are off the profile.
AXES = {
    "lateral_shift": np.linspace(-5e-3, 16e-3, 12),
    "yaw": np.linspace(-4e-3, 4e-3, 8),
    "normal_force": np.array([40e3, 60e3, 78.5e3, 80e3, 100e3]),
}
OUTPUTS = ["roll", "right.patch[1].area", "left.contact", "right.patch_count"]
#: States in a block; of 20 there are 24.
BLOCK = 20
FIXED = {"speed": 20.0, "left.friction": 0.2}
#: What OUTPUTS mean, as variables of a data set.
VARIABLES = [
    "roll",
    "right_patch_1_area",
    *(
        f"left_contact_{axis}_{frame}"
        for frame, axes in (("wheel", "xyz"), ("rail", "yz"), ("track", "xyz"))
        for axis in axes
    ),
    "right_patch_count",
]
#: A sweep in a process of its own, which is killed once it has {kill} blocks: ``PROGRAM.format(...)``.
PROGRAM = """
import os, signal
import wrcontact
from tests.helpers.sweeps import AXES, BLOCK, FIXED, OUTPUTS

signal.signal(signal.SIGINT, signal.default_int_handler)   # is ignored in the background

def progress(done, total, bad):
    if done >= {states}:
        os.kill(os.getpid(), signal.SIG{blow})

wrcontact.sweep(wrcontact.ContactSystem(), AXES, OUTPUTS, {store!r}, block=BLOCK, workers={workers},
                progress=progress, **FIXED)
"""


def in_memory(system=None, **options):
    """The sweep of AXES in this process, without a store."""
    return wrcontact.sweep(
        system or wrcontact.ContactSystem(),
        AXES,
        OUTPUTS,
        **{"progress": False, "block": BLOCK, **FIXED, **options},
    )


def points_file(path, wheel, step=0.25):
    """Write a wheel profile as a file of points."""
    y = np.arange(-60.0, 55.0, step)
    path.write_text("".join(f"{place:.6f} {1e3 * wheel.height(1e-3 * place):.9f}\n" for place in y))
    return path
