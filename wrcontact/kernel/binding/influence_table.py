"""How a strip of contact pressure pushes the half-space down: the table that the strip model reads.

A line load along x with the profile sqrt(1 - (x/a)^2), |x| < a, displaces the surface at x and the distance
eta beside it by a factor times

    Phi(t, e) = integral from -1 to 1 of sqrt(1 - v^2) / sqrt((v - e)^2 + t^2) dv,   t = eta / a,  e = x / a

and a strip that reaches from -T to T on average by the mean of Phi over 0 < t < T.  The table holds both,
over u = sqrt(t / (1 + t)) and v = e^2 / (1 + e^2), at even steps, for straight lines along both.  Numpy
alone, because an FMU makes this table on a machine that may have nothing else. Witness in tests: the integral
itself.
"""

from functools import lru_cache

import numpy as np

from ..layout import INFLUENCE_CELLS, INFLUENCE_COLUMN, INFLUENCE_COLUMNS, INFLUENCE_MAP

#: The profile as this many straight pieces, closer together near its ends; error 1e-7.
PIECES = 100
#: Where the first node, at t = 0, is taken, of a cell.
FIRST = 0.25


def profile():
    """Ends of the pieces (n + 1,) and the profile's value and slope along each, (n,), so that each piece
    has the load of the profile."""
    ends = np.cos(np.linspace(np.pi, 0.0, PIECES + 1))
    angle = np.arcsin(ends)
    load = np.diff(0.5 * (ends * np.cos(angle) + angle))
    moment = np.diff(-np.cos(angle) ** 3 / 3.0)
    middle, width = 0.5 * (ends[1:] + ends[:-1]), np.diff(ends)
    slope = (moment - middle * load) * 12.0 / width**3
    return ends, load / width - slope * middle, slope


def influence(t, e):
    """Phi(t, e) for t > 0 (..., n) and e (..., n)."""
    ends, value, slope = profile()
    w = ends - np.asarray(e, dtype=float)[..., None]
    t = np.asarray(t, dtype=float)[..., None]
    level, rise = np.arcsinh(w / t), np.sqrt(w * w + t * t)
    at = value + slope * np.asarray(e, dtype=float)[..., None]
    return (at * np.diff(level) + slope * np.diff(rise)).sum(axis=-1)


def mean_influence(t, e):
    """The mean of Phi over 0 ... t at e."""
    ends, value, slope = profile()
    w = ends - np.asarray(e, dtype=float)[..., None]
    w = np.where(w == 0.0, 1e-30, w)
    t = np.asarray(t, dtype=float)[..., None]
    beside, along = np.arcsinh(t / np.abs(w)), np.arcsinh(w / t)
    level = w * beside + t * along
    rise = 0.5 * (w * w * beside + t * np.sqrt(w * w + t * t))
    at = value + slope * np.asarray(e, dtype=float)[..., None]
    return (at * np.diff(level) + slope * np.diff(rise)).sum(axis=-1) / t[..., 0]


def map_of(function):
    """A function of t and e at the nodes, the columns one after the other; both are 0 infinitely far away."""
    u = np.arange(INFLUENCE_CELLS) / INFLUENCE_CELLS
    u[0] = FIRST / INFLUENCE_CELLS
    t = u * u / (1.0 - u * u)
    v = np.arange(INFLUENCE_COLUMNS) / INFLUENCE_COLUMNS
    numbers = np.zeros((INFLUENCE_COLUMNS + 2, INFLUENCE_COLUMN))
    numbers[:INFLUENCE_COLUMNS, :INFLUENCE_CELLS] = function(
        *np.broadcast_arrays(t[None, :], np.sqrt(v / (1.0 - v))[:, None]))
    return numbers.ravel()


@lru_cache(maxsize=1)
def influence_table():
    """The table as the kernel reads it (n,): the map of Phi, then that of its means."""
    table = np.concatenate([map_of(influence), map_of(mean_influence)])
    if len(table) != 2 * INFLUENCE_MAP:
        raise TypeError(f"the table of influences has {len(table)} numbers, its record {2 * INFLUENCE_MAP}")
    return table
