"""Errors of the stored random poses by where the wheel touches, against the complete theory.

    tread           one patch, contact angle up to 15 degrees
    flange root     one patch, up to 45 degrees
    flange          one patch, more than that
    two places      two patches or more

Each wheel is sorted by ANALYN's answer: the largest angle of its patches, and how many there are.
"""

import numpy as np

from . import random_poses

ZONES = "tread", "flange root", "flange", "two places"
ANGLES = np.radians([15.0, 45.0])  # where the flange root and the flange begin
KINDS = "mean", "95 of 100", "worst"  # what the table shows of them


def by_zone(count=random_poses.COUNT):
    """Rows by zone: the number of wheels, and by model the KINDS of their errors (3,) [%]."""
    truth = random_poses.references(count, random_poses.STORED).reshape(-1, 3)
    poses = [random_poses.pose(index) for index in range(count)]
    zone = zones(poses)
    rows = {name: {"wheels": 0} for name in ZONES}
    for model in ("analyn", "analyn_strip"):
        found, _ = random_poses.answers(poses, normal_model=model)
        errors = 100 * np.abs(found.reshape(-1, 3) / truth - 1)
        for number, name in enumerate(ZONES):
            here = errors[(zone == number) & np.isfinite(errors).all(axis=1)]
            rows[name]["wheels"] = len(here)
            if len(here):
                kinds = dict(random_poses.quantiles(here))
                rows[name][model] = {kind: kinds[kind] for kind in KINDS}
    return rows


def zones(poses):
    """The number of each wheel's zone (2 n,), left and right of every pose."""
    found = np.zeros((len(poses), 2), dtype=int)
    for row, pose in enumerate(poses):
        state = random_poses.system(pose.rail, pose.inclination).evaluate(*pose[2:])
        for side, wheel in enumerate((state.left, state.right)):
            angle = max((abs(patch.contact_angle) for patch in wheel.patches), default=0.0)
            found[row, side] = 3 if len(wheel.patches) > 1 else int(np.searchsorted(ANGLES, angle))
    return found.ravel()
