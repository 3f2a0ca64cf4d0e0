"""Records of the room search: the smallest gap of a side."""

from typing import Final

from .record import Float, record

SCAN_LIMIT: Final[int] = 400         # scan nodes over one wheel
ROLLS_BLOCK: Final[int] = 256        # rolls at which both sides have been searched


@record
class SideSearch:
    best: float                     # smallest gap found [m]
    best_y: float                   # its wheel abscissa
    best_rail: float                # and its rail abscissa, while the roll is sought
    first: int                    # first and last of the minima listed as candidates for further regions:
    last: int
    spare_5: Float * 3
    place: Float * 40               # their wheel abscissae [m]
    abscissa: Float * 40            # their places on the rail [m]
    stack: Float * 312              # cells still to be searched
