"""The height at which a wheelset stands at a given lateral shift and roll."""

import math

from ..state import Equilibrium
from ..status import Status

#: The load is met to this share [-], or the height is known to this [m].
MET, SHARP = 1e-12, 1e-16
#: A wheelset is lifted and let down again by these lengths [m] until it is off the rails, and stands on them;
#: a wheel that is 2 mm deep in its rail is off the profile.
LIFT, DROP = 1e-3, 2e-4
#: It is lifted and let down so often at most, and the height halved.
LIFTS, DROPS, HALVINGS = 60, 400, 100


def stand_at(system, roll, inputs):
    """An :class:`~wrcontact.state.Equilibrium` at the ``roll`` [rad]: the height at which both wheels of a
    compliant ``system`` together carry the loads among the keyword ``inputs``."""

    def at(height):
        return system.evaluate(**inputs, vertical_shift_input=height, roll_input=roll, outputs="patches")

    start = system.evaluate(**inputs)
    load = 2.0 * start.inputs.normal_force
    low = 0.0 if math.isnan(start.equilibrium.vertical_shift) else start.equilibrium.vertical_shift
    lifted = next((low - LIFT * k for k in range(LIFTS) if at(low - LIFT * k).force.z == 0.0), None)
    if lifted is None:
        return Equilibrium(math.nan, math.nan, at(low).status)
    low = lifted
    for _ in range(DROPS):
        high = low + DROP
        found = at(high)
        if found.status > Status.UNLOADED or -found.force.z >= load:
            break
        low = high
    if found.status > Status.UNLOADED:
        return Equilibrium(math.nan, math.nan, found.status)
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        found = at(middle)
        if abs(found.force.z + load) <= MET * load or high - low <= SHARP:
            break
        low, high = (middle, high) if -found.force.z < load else (low, middle)
    return Equilibrium(middle, roll, found.status)
