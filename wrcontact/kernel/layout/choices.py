"""What can be wanted of a step, by number, and its outcome; the numbers of the
methods are in interface.py."""

from typing import Final

SIDES_BOTH: Final[int] = 0
SIDES_LEFT: Final[int] = 1
SIDES_RIGHT: Final[int] = 2
DEPTH_GEOMETRY: Final[int] = 0       # contact point, angle, radius, curvatures
DEPTH_PATCHES: Final[int] = 1        # and penetration, patches
DEPTH_ALL: Final[int] = 2            # and the outline

# outcome of a step ---------------------------------------------------------------------------------
VALID: Final[int] = 0
UNLOADED: Final[int] = 1
OFF_PROFILE: Final[int] = 2
NOT_CONVERGED: Final[int] = 3
INVALID_INPUT: Final[int] = 4
