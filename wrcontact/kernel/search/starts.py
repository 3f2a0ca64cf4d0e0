"""Where the roll search starts without a near pose before: contacts without yaw, known for a row of lateral shifts.

A start sets the cost and never the answer, which is certified.
"""

from typing import Final

from ..layout import Tables

# the table of starts: sizes, then a row for each lateral shift
START_COUNT: Final[int] = 0
START_FIRST: Final[int] = 1          # lateral shift of the first row [m]
START_PER_METRE: Final[int] = 2
START_ROWS: Final[int] = 3
START_ROW: Final[int] = 4            # of a lateral shift:
START_KNOWN: Final[int] = 0          # 1 if the wheelset stands on the rails there, else 0
START_ROLL: Final[int] = 1           # [rad]
START_LEFT: Final[int] = 2           # wheel abscissae of the contacts [m]
START_RIGHT: Final[int] = 3


def nearest_start(tables: Tables, shift: float):
    """Offset in ``tables`` of the row nearest to the lateral ``shift`` [m]; -1 if nothing is known there."""
    base = int(tables.starts)
    u = (shift - tables[base + START_FIRST]) * tables[base + START_PER_METRE] + 0.5
    if not (u >= 0.0 and u < tables[base + START_COUNT]):
        return -1
    row = base + START_ROWS + START_ROW * int(u)
    if tables[row + START_KNOWN] == 0.0:
        row = -1
    return row
