"""Where the roll search starts without a near pose before: contacts without yaw,
known for a row of lateral shifts.

A start sets the cost and never the answer, which is certified.
"""

from ..layout import Starts


def nearest_start(starts: Starts, shift: float):
    """The row of the table that is nearest to the lateral ``shift`` [m]; -1 if nothing is known there."""
    u = (shift - starts.first_shift) * starts.per_metre + 0.5
    if not (u >= 0.0 and u < starts.count):
        return -1
    row = int(u)
    if not starts.rows[row].known:
        row = -1
    return row
