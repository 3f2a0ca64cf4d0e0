"""How the tables of Hertz coefficients and of influences are made, which are stored for the kernel
(wrcontact/kernel/binding/fixed_tables.py, tools/make_fixed_tables.py).

The table of Hertz coefficients (record HertzTable) comes from elliptic integrals
(wrcontact/halfspace/hertz.py).

The table of influences says how a strip of contact pressure pushes the half-space down.  A line load along x
with the profile sqrt(1 - (x/a)^2), |x| < a, displaces the surface at x and the distance eta beside it by a
factor times

    Phi(t, e) = integral from -1 to 1 of sqrt(1 - v^2) / sqrt((v - e)^2 + t^2) dv,   t = eta / a,  e = x / a

The table holds it over sqrt(t / (1 + t)) and e^2 / (1 + e^2): parabolas along the first in even cells, joined
with one slope, and straight lines along the second.  Behind it, over the logarithm of their distance, is what
lines of pressure that lie apart displace less than a smooth pressure (``spacing``).  Witness in tests: the
integrals themselves.
"""

import numpy as np

from wrcontact.halfspace.hertz import coefficients
from wrcontact.kernel import layout
from wrcontact.kernel.layout import (
    HERTZ_CELLS,
    HERTZ_OCTAVES,
    INFLUENCE_CELLS,
    INFLUENCE_COLUMNS,
    INFLUENCE_MAP,
    SPACING_CELLS,
)
from wrcontact.kernel.normal.strip_pressures import CLOSEST_SPACING, TESTED, WIDEST_SPACING

DEGREE = 5
#: The profile as this many straight pieces, closer together near its ends; error 1e-7.
PIECES = 100
#: The smooth pressure reaches this many half-lengths, and its integral has so many graded points.
FARTHEST, GRADED = 12.0, 4000
#: Step of the slopes, of a cell; and where the first node, at t = 0, is taken, of a cell.
SLOPE_STEP, FIRST = 1e-3, 0.25


def basis(nodes):
    """Coefficients of 1, t, t^2, ... of the polynomials that are 1 at one of the nodes and 0 at the
    others (node, power)."""
    rows = []
    for node in nodes:
        row = np.eye(1, len(nodes))[0]
        for other in nodes[nodes != node]:
            row = (np.roll(row, 1) - other * row) / (node - other)
        rows.append(row)
    return np.array(rows)


def hertz_table():
    """The table as the kernel reads it (n,): without products of matrices, whose last bits
    depend on the processor."""
    nodes = 0.5 - 0.5 * np.cos(np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1))
    octaves = 2.0 ** np.arange(-HERTZ_OCTAVES, HERTZ_OCTAVES)
    within = 1.0 + (np.arange(HERTZ_CELLS)[:, None] + nodes) / HERTZ_CELLS
    ratios = octaves[:, None, None] * within
    columns = [
        sum(value[:, None] * row for value, row in zip(values.reshape(-1, len(nodes)).T, basis(nodes)))
        for values in coefficients(np.log(ratios.ravel()))
    ]
    assert 2 * (DEGREE + 1) == layout.HERTZ_ROW
    return np.hstack(columns).ravel()


def profile():
    """Ends of the pieces (n + 1,) and the profile's value and slope along each, (n,), so that each piece
    has the load of the profile."""
    ends = np.cos(np.linspace(np.pi, 0.0, PIECES + 1))
    angle = np.arcsin(ends)
    load = np.diff(0.5 * (ends * np.cos(angle) + angle))
    moment = np.diff(-(np.cos(angle) ** 3) / 3.0)
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


def near_constant(e):
    """k(e): Phi is -2 sqrt(1 - e^2) ln t + k close to the strip's middle line, of an ellipse."""
    height = np.sqrt(1.0 - e * e)
    return height * (2.0 * np.log(4.0) + 2.0 * np.log(1.0 - e * e) - 2.0) + 2.0 * e * np.arcsin(e)


def spacing(e, tau):
    """S(e, tau) for one tau: what evenly spaced lines of pressure, tau half-lengths apart, displace less than
    a smooth pressure, beyond what the logarithm of Phi says."""
    count = int(np.clip(FARTHEST / tau, 40, 20_000))
    z = (np.arange(GRADED) + 0.5) / GRADED
    reach = (count + 0.5) * tau
    smooth = 2.0 * (influence(reach * z**4, np.full(GRADED, e)) * 4.0 * reach * z**3).sum() / GRADED
    lines = 2.0 * tau * influence(np.arange(1, count + 1) * tau, np.full(count, e)).sum()
    logarithm = 2.0 * np.sqrt(1.0 - e * e) * np.log(tau / (2.0 * np.pi))
    return (smooth - lines) / tau + logarithm - near_constant(e)


def spacing_tables():
    """Parabolas of S over even cells of ln tau (n,): at e = 0, then at the place where strips are tested."""
    at = np.linspace(np.log(CLOSEST_SPACING), np.log(WIDEST_SPACING), SPACING_CELLS // 2 + 1)
    step = SLOPE_STEP * (at[1] - at[0])
    tables = []
    for e in (0.0, TESTED):
        before, value, after = ([spacing(e, np.exp(x + move)) for x in at] for move in (-step, 0.0, step))
        slope = np.subtract(after, before) / (4.0 * SLOPE_STEP)
        tables.append(joined_parabolas(np.array(value)[None], slope[None]).ravel())
    return np.concatenate(tables)


def map_of(function):
    """Parabolas a + b x + c x^2, 0 <= x <= 1, of a function of t and e in the cells (n,), column by
    column.

    Two cells lie between nodes, where the parabolas have the function's value and slope.
    """
    nodes = INFLUENCE_CELLS // 2
    u = np.arange(nodes + 1) / nodes
    u[0], u[-1] = FIRST / nodes, 1.0 - 1e-6
    column = np.arange(INFLUENCE_COLUMNS) / INFLUENCE_COLUMNS
    step = SLOPE_STEP / nodes

    def along(u):
        u = np.minimum(u, 1.0 - 1e-6)
        t = u * u / (1.0 - u * u)
        return function(*np.broadcast_arrays(t[None, :], np.sqrt(column / (1.0 - column))[:, None]))

    value, before, after = along(u), along(u - step), along(u + step)
    slope = (after - before) / (4.0 * SLOPE_STEP)  # of a cell
    value[:, -1] = 0.0
    slope[:, -1] = (value[:, -1] - before[:, -1]) / (2.0 * SLOPE_STEP)
    parabolas = np.zeros((INFLUENCE_COLUMNS + 1, nodes, 2, 3))  # infinitely far along x: none
    parabolas[:-1] = joined_parabolas(value, slope)
    return parabolas.ravel()


def joined_parabolas(value, slope):
    """Parabolas (rows, n, 2, 3) in two cells between each two nodes, where they have these values and slopes
    per cell (rows, n + 1)."""
    low, high, rise, fall = value[:, :-1], value[:, 1:], slope[:, :-1], slope[:, 1:]
    middle = 0.5 * (low + high) + 0.25 * (rise - fall)
    steep = (high - low) - 0.5 * (rise + fall)
    return np.stack(
        [
            np.stack([low, rise, 0.5 * (steep - rise)], axis=-1),
            np.stack([middle, steep, 0.5 * (fall - steep)], axis=-1),
        ],
        axis=2,
    )


def influence_table():
    """The table as the kernel reads it (n,): the map of Phi, then the tables of spacing."""
    table = np.concatenate([map_of(influence), spacing_tables()])
    if len(table) != INFLUENCE_MAP + 6 * SPACING_CELLS:
        raise TypeError(f"the table of influences has {len(table)} numbers, its record another number")
    return table
