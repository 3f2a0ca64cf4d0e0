"""What can be chosen of a step, by number, what it reports, and how much of it."""

from typing import Final

PATCH_LIMIT: Final[int] = 3          # patches that are reported for each wheel
STATION_COUNT: Final[int] = 31       # stations of an outline, unless another number is asked for:
STATION_LEAST: Final[int] = 3
STATION_LIMIT: Final[int] = 201

MODE_RIGID: Final[int] = 0
MODE_ELASTIC: Final[int] = 1
MODE_COMPLIANT: Final[int] = 2
LOAD_NORMAL: Final[int] = 0
LOAD_VERTICAL: Final[int] = 1

MODEL_HERTZ: Final[int] = 0
MODEL_ANALYN: Final[int] = 1
MODEL_ANALYN_STRIP: Final[int] = 2
SIDES_BOTH: Final[int] = 0
SIDES_LEFT: Final[int] = 1
SIDES_RIGHT: Final[int] = 2
DEPTH_GEOMETRY: Final[int] = 0       # contact point, angle, radius, curvatures
DEPTH_PATCHES: Final[int] = 1        # and penetration, patches
DEPTH_ALL: Final[int] = 2            # and the outline
LONGITUDINAL_EFFECTIVE: Final[int] = 0
LONGITUDINAL_BASIC: Final[int] = 1
SEPARATION_NORMAL: Final[int] = 0
SEPARATION_VERTICAL: Final[int] = 1
SEPARATION_EQUIDISTANT: Final[int] = 2
SEPARATION_CHORD: Final[int] = 3
LATERAL_ADAPTIVE: Final[int] = 0
LATERAL_SMOOTH: Final[int] = 1
LATERAL_ROUGH: Final[int] = 2

# outcome of a step ---------------------------------------------------------------------------------
VALID: Final[int] = 0
UNLOADED: Final[int] = 1
OFF_PROFILE: Final[int] = 2
NOT_CONVERGED: Final[int] = 3
INVALID_INPUT: Final[int] = 4
