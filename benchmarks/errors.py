"""Errors against independent references: mean and worst in penetration, area and peak pressure.

Positions are the right wheel from tread to flange (tests/reference/positions.csv), the run is both wheels of growing
hunting with yaw and load transfer (tests/trajectories/hunting.csv).  Both are a half-space solver's answers on the true
three-dimensional gap; its own errors are 0.004, 0.9 and 0.6 %.
"""

from functools import cache
from typing import NamedTuple

import numpy as np

from . import runs

PATCH = ("penetration", "area", "max_pressure")
PLACE = ("x_wheel", "y_wheel", "z_wheel")
SIDES = ("left", "right")


class Errors(NamedTuple):
    """Shares of penetration, area and peak pressure (3,)."""

    mean: np.ndarray
    worst: np.ndarray
    count: int  # wheels that were compared


@cache
def positions(system):
    """:class:`Errors` on the 20 positions."""
    run = runs.stored(runs.POSITIONS)
    table = system.evaluate_many(run["lateral_shift"], run["yaw"], run["normal_force"])
    return compared(table, run, ("right",))


@cache
def hunting(system, every=1, yawed=True):
    """:class:`Errors` on each ``every``-th row of the hunting run; ``yawed`` = False leaves its yaw out."""
    run = {name: column[::every] for name, column in runs.stored(runs.HUNTING).items()}
    table = system.evaluate_many(run["lateral_shift"], run["yaw"] * yawed, run["normal_force"], run["load_transfer"])
    return compared(table, run, SIDES)


def compared(table, run, sides):
    if np.any(table.status != 0):
        raise ArithmeticError(f"{np.sum(table.status != 0)} of the stored poses are not solved: {set(table.status.tolist())}")
    shares = np.array([np.concatenate([getattr(getattr(table, side), name) / run[f"{side}.{name}"] - 1 for side in sides])
                       for name in PATCH])
    return summary(shares)


def summary(shares):
    """:class:`Errors` of signed shares (3, n)."""
    size = np.abs(shares)
    return Errors(size.mean(axis=1), size.max(axis=1), size.shape[1])


def rigid(system):
    """Worst error of the rigid contact in the hunting run, in words: roll [rad] and contact position [mm]."""
    run = runs.stored(runs.HUNTING)
    table = system.evaluate_many(run["lateral_shift"], run["yaw"], run["normal_force"], run["load_transfer"])
    roll = np.max(np.abs(table.roll - run["roll"]))
    place = max(np.max(np.abs(getattr(getattr(table, side).contact, name) - run[f"{side}.contact.{name}"]))
                for side in SIDES for name in PLACE)
    return f"roll {roll:.0e} rad, position {place * 1e3:.0e} mm"
