"""Tables that do not depend on the profiles, from the array ``fixed`` (binding/fixed_tables.py).

It begins with the sizes of its tables: Hertz's, that of influences, and that of rolling for all Poisson's
ratios (binding/rolling_table.py).  The tables follow one after the other.
"""

from typing import Final

from ..layout import (CORRECTION_RADII, CORRECTION_SCALES, CORRECTION_SIZE, POINT_LIMIT, REACH_CELLS,
                      REACH_COLUMNS, REACH_ROW, ROLLING_TABLE_SIZE, SHAPE_CELLS, SHAPE_ROW, RollingTable,
                      Tables)
from .pieces import FULL

FIXED_HERTZ: Final[int] = 0
FIXED_INFLUENCE: Final[int] = 1
FIXED_ROLLING: Final[int] = 2
FIXED_COUNT: Final[int] = 3

#: Poisson's ratios of Kalker's table (binding/kalker_table.py).
LOW_RATIO: Final[float] = 0.0
MIDDLE_RATIO: Final[float] = 0.25
HIGH_RATIO: Final[float] = 0.5
#: Poisson's ratios of the corrections; below and above they are those of the ends.
FIRST_CORRECTION: Final[float] = 0.25
SECOND_CORRECTION: Final[float] = 0.28
THIRD_CORRECTION: Final[float] = 0.30


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
    first = write_shapes(tables.rolling, fixed, first + 2 * POINT_LIMIT, poisson_ratio)
    first = write_reaches(tables.rolling, fixed, first, poisson_ratio)
    write_corrections(tables.rolling, fixed, first, poisson_ratio)
    return at + ROLLING_TABLE_SIZE


def write_shapes(table: RollingTable, fixed: 'float[:]', first: int, poisson_ratio: float):
    """The shapes, parabolas of Poisson's ratio, from ``first`` on; the place behind them."""
    size = SHAPE_ROW * SHAPE_CELLS
    low, middle, high = parabola_weights(LOW_RATIO, MIDDLE_RATIO, HIGH_RATIO, poisson_ratio)
    for i in range(size):
        table.shapes[i] = (low * fixed[first + i] + middle * fixed[first + size + i]
                           + high * fixed[first + 2 * size + i])
    return first + 3 * size


def write_reaches(table: RollingTable, fixed: 'float[:]', first: int, poisson_ratio: float):
    """The reaches, eq. (K5) of binding/reach_table.py, from ``first`` on; the place behind them."""
    size = REACH_ROW * (REACH_CELLS + 1)
    for i in range(size):
        weight = poisson_ratio
        if i // 4 % REACH_COLUMNS == 0:
            weight = poisson_ratio / (1.0 - poisson_ratio)
        table.reaches[i] = fixed[first + i] + weight * fixed[first + size + i]
    return first + 2 * size


def write_corrections(table: RollingTable, fixed: 'float[:]', first: int, poisson_ratio: float):
    """The corrections, parabolas of Poisson's ratio, from ``first`` on."""
    ratio = poisson_ratio
    if ratio < FIRST_CORRECTION:
        ratio = FIRST_CORRECTION
    if ratio > THIRD_CORRECTION:
        ratio = THIRD_CORRECTION
    for i in range(CORRECTION_RADII):
        table.radii[i] = fixed[first + i]
    low, middle, high = parabola_weights(FIRST_CORRECTION, SECOND_CORRECTION, THIRD_CORRECTION, ratio)
    at = first + CORRECTION_RADII
    for i in range(CORRECTION_SCALES):
        table.scales[i] = (low * fixed[at + i] + middle * fixed[at + CORRECTION_SCALES + i]
                           + high * fixed[at + 2 * CORRECTION_SCALES + i])
    at += 3 * CORRECTION_SCALES
    for i in range(CORRECTION_SIZE):
        table.corrections[i] = (low * fixed[at + i] + middle * fixed[at + CORRECTION_SIZE + i]
                                + high * fixed[at + 2 * CORRECTION_SIZE + i])
