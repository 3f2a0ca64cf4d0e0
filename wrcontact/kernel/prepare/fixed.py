"""Tables that do not depend on the profiles, from the array ``fixed`` (binding/fixed_tables.py).

It begins with the sizes of its tables: Hertz's, that of influences, and that of rolling for each of three
Poisson's ratios.  The tables follow one after the other.
"""

from typing import Final

from ..layout import POINT_LIMIT, ROLLING_TABLE_SIZE, SHAPE_CELLS, SHAPE_ROW, Tables
from .pieces import FULL

FIXED_HERTZ: Final[int] = 0
FIXED_INFLUENCE: Final[int] = 1
FIXED_ROLLING: Final[int] = 2
FIXED_COUNT: Final[int] = 3

#: Poisson's ratios of Kalker's table, eq. in binding/kalker_table.py.
LOW_RATIO: Final[float] = 0.0
MIDDLE_RATIO: Final[float] = 0.25
HIGH_RATIO: Final[float] = 0.5


def fixed_table(fixed: 'float[:]', index: int):
    """Where table ``index`` begins."""
    at = FIXED_COUNT
    for i in range(index):
        at += int(fixed[i])
    return at


def append_fixed(tables: 'float[:]', at: int, fixed: 'float[:]', index: int):
    """Copy table ``index`` to ``at``; the offset after it, or FULL."""
    size = int(fixed[index])
    if at + size > tables.shape[0]:
        return FULL
    first = fixed_table(fixed, index)
    for i in range(size):
        tables[at + i] = fixed[first + i]
    return at + size


def parabola_weights(low: float, middle: float, high: float, x: float):
    """Weights of the values at three nodes in the parabola through them at ``x``."""
    return ((x - middle) * (x - high) / ((low - middle) * (low - high)),
            (x - low) * (x - high) / ((middle - low) * (middle - high)),
            (x - low) * (x - middle) / ((high - low) * (high - middle)))


def append_rolling(tables: Tables, at: int, fixed: 'float[:]', poisson_ratio: float):
    """The table of rolling at ``at`` for a Poisson's ratio, which ``tables`` already point to; the offset
    after it, or FULL."""
    if at + ROLLING_TABLE_SIZE > tables.raw.shape[0]:
        return FULL
    first = fixed_table(fixed, FIXED_ROLLING)
    for i in range(POINT_LIMIT):
        tables.rolling.cosines[i] = fixed[first + i]
        tables.rolling.sines[i] = fixed[first + POINT_LIMIT + i]
    first += 2 * POINT_LIMIT
    size = SHAPE_ROW * SHAPE_CELLS
    low, middle, high = parabola_weights(LOW_RATIO, MIDDLE_RATIO, HIGH_RATIO, poisson_ratio)
    shapes = tables.rolling.shapes
    for i in range(size):
        shapes[i] = (low * fixed[first + i] + middle * fixed[first + size + i]
                     + high * fixed[first + 2 * size + i])
    return at + ROLLING_TABLE_SIZE
