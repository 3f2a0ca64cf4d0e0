"""The mirror in the plane y = 0, as seen in the outputs of one wheel."""

import numpy as np

from wrcontact.interface.variables import FIRST_OUTPUT, FIRST_WEAR, VARIABLES

#: Outputs of one wheel that change their sign: y in the track frame, forces along y (true vectors), moments
#: about x and z (axial vectors), creepages across and about the normal, and the moment about it.
TURNED = (
    "contact.y_track",
    "y_track",
    "force.y",
    "moment.x",
    "moment.z",
    "creepage.y",
    "creepage.spin",
    "tangential.moment",
    "normal.force.y",
    "normal.moment.x",
    "normal.moment.z",
)


def side_signs():
    """The signs (m,) that turn the outputs of a right wheel into those of the left wheel in the mirror."""
    names = [
        one.name.removeprefix("right.")
        for one in VARIABLES[FIRST_OUTPUT:FIRST_WEAR]
        if one.name.startswith("right.")
    ]
    turned = [name in TURNED or name.partition("].")[2] in TURNED for name in names]
    return np.where(turned, -1.0, 1.0)
