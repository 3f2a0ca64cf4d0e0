"""Where a value lies in a table with even steps."""


def table_cell(u: float, last: float):
    """The cell that holds ``u`` [cells], and where in it, 0 ... 1.

    ``u`` is clamped to 0 ... ``last``, and is 0 if it is not a number.
    """
    if not u > 0.0:
        u = 0.0
    if u > last:
        u = last
    cell = int(u)
    if cell > int(last) - 1:
        cell = int(last) - 1
    return cell, u - float(cell)
