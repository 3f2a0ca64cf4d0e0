"""A function read from a table of cubics over even cells (the record CubicTable)."""

from ..layout import CubicTable
from .table_cell import table_cell


def read_cubic(table: CubicTable, at: float):
    """Value of the function; outside the table, that at its end."""
    cell, x = table_cell((at - table.start) * table.cells_per_unit, table.count)
    cubic = table.cells[cell]
    return cubic.value + x * (cubic.slope + x * (cubic.bend + x * cubic.third))


def read_cubic_jet(table: CubicTable, at: float):
    """Value of the function and its derivative; outside the table, those at its end."""
    cell, x = table_cell((at - table.start) * table.cells_per_unit, table.count)
    cubic = table.cells[cell]
    q2 = cubic.bend + x * cubic.third
    q1 = cubic.slope + x * q2
    return cubic.value + x * q1, (q1 + x * (q2 + x * cubic.third)) * table.cells_per_unit
