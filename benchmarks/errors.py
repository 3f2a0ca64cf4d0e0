"""Errors against independent references: mean and worst error of penetration, area and peak pressure.

*Positions*: the right wheel from tread to flange (tests/reference/positions.csv).  *Hunting run*: both wheels
during growing hunting with yaw and load transfer (tests/trajectories/hunting.csv).  Both are results of a
half-space solver on the true three-dimensional gap, whose own errors are 0.004, 0.9 and 0.6 %.
"""

from functools import cache
from typing import NamedTuple

import numpy as np

from . import runs

PATCH = ("penetration", "area", "max_pressure")
PLACE = ("x_wheel", "y_wheel", "z_wheel")
SIDES = ("left", "right")


class Errors(NamedTuple):
    """Relative errors of penetration, area and peak pressure (3,)."""

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
    """:class:`Errors` at each ``every``-th row of the hunting run; ``yawed=False`` sets the yaw to zero."""
    run = {name: column[::every] for name, column in runs.stored(runs.HUNTING).items()}
    table = system.evaluate_many(run["lateral_shift"], run["yaw"] * yawed, run["normal_force"],
                                 run["load_transfer"])
    return compared(table, run, SIDES)


def compared(table, run, sides):
    """:class:`Errors` of a table of states against a stored run; ArithmeticError if a pose is not solved."""
    if np.any(table.status != 0):
        raise ArithmeticError(f"{np.sum(table.status != 0)} of the stored poses are not solved: "
                              f"{set(table.status.tolist())}")
    shares = np.array([np.concatenate([getattr(getattr(table, side), name) / run[f"{side}.{name}"] - 1
                                       for side in sides])
                       for name in PATCH])
    return summary(shares)


def summary(shares):
    """:class:`Errors` from signed relative errors (3, n)."""
    size = np.abs(shares)
    return Errors(size.mean(axis=1), size.max(axis=1), size.shape[1])


def percentages(positions, hunting):
    """Both :class:`Errors` as they are kept [%]."""
    return {"positions mean": 100 * positions.mean, "positions worst": 100 * positions.worst,
            "hunting mean": 100 * hunting.mean, "hunting worst": 100 * hunting.worst}


def rigid(system):
    """Largest errors of the rigid contact in the hunting run: roll [rad] and contact position [mm]."""
    run = runs.stored(runs.HUNTING)
    table = system.evaluate_many(run["lateral_shift"], run["yaw"], run["normal_force"], run["load_transfer"])
    place = max(np.max(np.abs(getattr(getattr(table, side).contact, name) - run[f"{side}.contact.{name}"]))
                for side in SIDES for name in PLACE)
    return {"roll": np.max(np.abs(table.roll - run["roll"])), "position": place * 1e3}
