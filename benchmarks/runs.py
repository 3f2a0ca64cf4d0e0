"""Poses for timing, and the stored runs for errors."""

import csv
from functools import cache
from pathlib import Path

import numpy as np

from wrcontact.kernel import layout

TESTS = Path(__file__).parents[1] / "tests"
POSITIONS = TESTS / "reference" / "positions.csv"
MANCHESTER = TESTS / "reference" / "manchester_a22_rolls.csv"
HUNTING = TESTS / "trajectories" / "hunting.csv"
FORCE = 78.5e3  # [N]
SHIFT, YAW = 6.6e-3, 0.02  # [m, rad] amplitudes of the timed runs
ANY_YAW = 0.035  # [rad] 2 deg


def trajectory(count, yaw=YAW):
    """Lateral shift [m] and yaw [rad]: from flange to flange, about twice in 2000 poses; yaw a quarter cycle
    apart."""
    turn = 12.0 * np.arange(count) / 2000
    return SHIFT * np.sin(turn), yaw * np.cos(turn)


def anywhere(count, yaw=ANY_YAW):
    """Lateral shift [m] and yaw [rad] (count,) of independent random poses."""
    random = np.random.default_rng(0)
    return random.uniform(-SHIFT, SHIFT, count), yaw * random.uniform(-1, 1, count)


def rows(poses, force=FORCE):
    """Inputs (n, INPUT_COUNT) of lateral shifts [m] and yaws [rad] under a force [N]; the others are zero."""
    shift, yaw = poses
    inputs = np.zeros((len(shift), layout.INPUT_COUNT))
    for place, values in ((layout.IN_LATERAL_SHIFT, shift), (layout.IN_YAW, yaw),
                          (layout.IN_NORMAL_FORCE, force)):
        inputs[:, place] = values
    return inputs


@cache
def stored(path):
    """Columns of a stored run by name, arrays (n,)."""
    with open(path, newline="", encoding="utf-8") as file:
        names, *rows = csv.reader(file)
    return dict(zip(names, np.array(rows, dtype=float).T))
