"""What depends on the shape of a patch, its length over its width, from the table of rolling."""

from math import log

from ..layout import SHAPE_CELLS, SHAPE_PER_UNIT, SHAPE_ROW, SHAPE_START, RollingTable
from ..surface.table_cell import table_cell


def shape_place(axis_ratio: float):
    """Place of a/b in the table, counted in cells; beyond its ends the shape of the end is taken."""
    return (log(axis_ratio) - SHAPE_START) * SHAPE_PER_UNIT


def shape_value(table: RollingTable, column: int, place: float):
    """Value of a column, 0 ... SHAPE_COLUMNS - 1, at a place."""
    cell, u = table_cell(place, float(SHAPE_CELLS))
    at = SHAPE_ROW * cell + 4 * column
    high = table.shapes[at + 2] + u * table.shapes[at + 3]
    return table.shapes[at] + u * (table.shapes[at + 1] + u * high)


def kalker_coefficients(table: RollingTable, axis_ratio: float):
    """Kalker's creepage coefficients C11, C22, C23 of an ellipse with this a/b, length over width."""
    place = shape_place(axis_ratio)
    return (1.0 / shape_value(table, 0, place), 1.0 / shape_value(table, 1, place),
            1.0 / shape_value(table, 2, place))
