"""Records of the room tangential: a patch that rolls, as the models of creep forces read it.

They know one frame: x forward, y = station to the field side, and the normal x times y.  Creepages are the
velocity of the wheel against the rail over the rolling speed.
"""

from typing import Final

from .interface import PATCH_LIMIT
from .record import Float, record

ROLLING_STRIP_LIMIT: Final[int] = 16

# the table of rolling: columns over the shape of a patch, ln(a/b), as cubics over even cells
SHAPE_START: Final[float] = -3.0
SHAPE_PER_UNIT: Final[float] = 4.0
SHAPE_CELLS: Final[int] = 28
SHAPE_COLUMNS: Final[int] = 3        # 1/C11, 1/C22, 1/C23
SHAPE_ROW: Final[int] = 4 * SHAPE_COLUMNS

POINT_LIMIT: Final[int] = 16         # points of a strip, from its leading edge


@record
class RollingTable:
    """What the models of creep forces read, for one Poisson's ratio (binding/rolling_table.py)."""

    cosines: Float * POINT_LIMIT    # points of a strip x/a = cos(q pi / (n + 1)), q = 1 ... n,
    sines: Float * POINT_LIMIT      # and sqrt(1 - (x/a)^2) there
    shapes: Float * (SHAPE_ROW * SHAPE_CELLS)


@record
class RollingStrip:
    """A strip of the patch along the rolling direction."""

    start: float                    # stations of its edges [m]
    stop: float
    station: float                  # and of its middle
    y: float                        # its middle, from the point that the creepages hold for [m]
    width: float                    # [m]
    x: float                        # how far its middle is ahead of that point [m]
    half_length: float              # [m]
    line_load: float                # load per width [N/m]
    slip: float                     # its longitudinal creepage [-]
    y_track: float                  # track coordinates of its middle [m]
    z_track: float
    rolling_radius: float           # there [m]
    force_x: float                  # what is found: force on the wheel per width [N/m],
    force_y: float
    moment: float                   # and moment of the lateral one about the patch's point, per width [N]


@record
class RollingPatch:
    """What a model of creep forces reads, and what it finds."""

    count: int                      # strips
    load: float                     # normal force [N]
    half_length: float              # semi-axes of the ellipse with its area, length over width [m]
    half_width: float
    friction: float                 # coefficient of friction [-]
    speed: float                    # the rolling speed [m/s]
    creepage_x: float               # [-]
    creepage_y: float
    spin: float                     # [1/m]
    backwards: bool                 # whether it rolls towards -x
    published: bool                 # FASTSIM and FaStrip: both parts of spin as they were published
    strips: RollingStrip * ROLLING_STRIP_LIMIT
    force_x: float                  # what is found: force on the wheel [N]
    force_y: float
    moment: float                   # and moment about the normal through the point [N m]
    stick_share: float              # share of the area that sticks [-]
    max_shear: float                # largest traction [Pa]


@record
class RollingSide:
    """The patches of a wheel that are reported, by falling load."""

    count: int
    patches: RollingPatch * PATCH_LIMIT
