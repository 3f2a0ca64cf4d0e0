"""Where the height and the roll of a compliant wheelset start, so that a tool that connects nothing sees
wheels that carry their loads and not a wheelset that floats."""

import math

from ..interface.index import ROWS
from ..interface.inputs import HEIGHT_LIMIT

HEIGHT, ROLL = "vertical_shift_input", "roll_input"
#: How close a wheel's load must come to the load that it starts with: a jump may be in between.
CLOSE = 1e-6
#: Halvings of the range of heights, down to its last bits.
HALVINGS = 60


def at_rest(system, starts, side=""):
    """Start values of height and roll, by name, at which the wheels carry their loads.

    Parameters
    ----------
    system : the :class:`~wrcontact.ContactSystem` of the FMU.
    starts : start values by name, as the build fixes them.
    side : "" for a wheelset, else the wheel that stands alone.

    Returns
    -------
    dict
        empty in other contact modes than compliant, where the build fixes the height, and where the start
        values leave no place at which the loads are carried.
    """
    if system.parameters["contact_mode"] != "compliant" or HEIGHT in starts:
        return {}
    inputs = {ROWS[name].keyword: value for name, value in starts.items() if name in ROWS}
    if side:
        found = {HEIGHT: _height_of_wheel(system, inputs, side)}
    elif ROLL in starts:
        found = {HEIGHT: system.stand_at(inputs.pop(ROLL), **inputs).vertical_shift}
    else:
        place = system.evaluate(**inputs).equilibrium
        found = {HEIGHT: place.vertical_shift, ROLL: place.roll}
    return {name: float(value) for name, value in found.items()} if _finite(found.values()) else {}


def _height_of_wheel(system, inputs, side):
    """Height at which one wheel carries the load that a wheel of a wheelset starts with [m]; NaN if there is
    none."""
    load, (high, low) = ROWS["normal_force"].start, (-HEIGHT_LIMIT, HEIGHT_LIMIT)
    for _ in range(HALVINGS):
        middle = (high + low) / 2
        # a wheel that is too deep in its rail has no result
        if not _force(system, inputs, side, middle) < load:
            low = middle
        else:
            high = middle
    return high if abs(_force(system, inputs, side, high) - load) <= CLOSE * load else math.nan


def _force(system, inputs, side, height):
    """Normal force of a wheel at a height [N]; NaN without a valid result."""
    return getattr(system.evaluate(**{**inputs, HEIGHT: height}), side).normal_force


def _finite(values):
    return all(map(math.isfinite, values))
