"""Elastic and compliant systems, what their wheels carry, and the rail beneath."""

import numpy as np

from tests.helpers.cases import system
from wrcontact.profiles.compiled import evaluate_table


def elastic(**parameters):
    return system(contact_mode="elastic", **parameters)


def compliant(**parameters):
    return system(contact_mode="compliant", **parameters)


def carried(side, load="normal"):
    """What a wheel carries [N] in the sense of ``load``, summed from its patches."""
    if load == "normal":
        return side.normal_force
    return sum(patch.normal_force * np.cos(patch.contact_angle) for patch in side.patches)


def placed_rail():
    """UIC60 1:40 at gauge: the kernel's table of it, and its track coordinate [m]."""
    return system().profile_tables()[1:]


def rail_point_along(start, stations):
    """Abscissae [m] of the rail at arc lengths ``stations`` from ``start``, by numpy on a dense grid."""
    table, _ = placed_rail()
    x = np.linspace(start - 0.02, start + 0.03, 200_001)
    x = x[(x > table[0]) & (x < table[1])]
    speed = np.sqrt(1 + evaluate_table(table, x)[1] ** 2)
    length = np.concatenate(([0.0], np.cumsum(0.5 * (speed[1:] + speed[:-1]) * np.diff(x))))
    return np.interp(stations, length - np.interp(start, x, length), x)


def rail_slope_along(start, stations):
    return evaluate_table(placed_rail()[0], rail_point_along(start, stations))[1]
