"""Records of the room normal: numbers at the nodes and strips of regions."""

from typing import Final

from .contact import REGION_LIMIT
from .record import OPEN, Float, centred, record, run
from .surface import Cubic

NODE_LIMIT: Final[int] = 256         # nodes of a region
NODE_MIDDLE: Final[int] = 128        # place of node 0 in them
STRIP_LIMIT: Final[int] = 104        # strips of one wheel: 64, and 12 at least in each region

#: Numbers at the nodes of a region; node 0 is at its minimum.
NodeRun = centred(NODE_LIMIT, NODE_MIDDLE)


@record
class Nodes:
    gap: NodeRun                    # rise of the gap over the region's minimum [m]
    A: NodeRun                      # longitudinal A = 1/(2 R_x) [1/m]
    rise: NodeRun                   # (1 + beta) times the gap's rise [m]
    line: NodeRun                   # E* / (n r): line load per local penetration [N/m^2]
    length: NodeRun                 # (1 + alpha) A [1/m]
    B: NodeRun                      # lateral curvature B [1/m]


NodesOfRegions = Nodes * REGION_LIMIT


@record
class StripZone:
    start: float                    # where the strips of a region begin and end [m]
    stop: float
    penetration: float              # along the region's normal, as ANALYN predicts it [m]
    weight: float                   # integral of sqrt(B) sqrt(1 - g / penetration) from start to stop [m^1/2]


@record
class Strip:
    station: float                  # s of its middle [m]
    width: float                    # h [m]
    region: int                     # the region that it belongs to
    joined: bool                    # it touches the next strip
    gap: float                      # g at its middle [m]
    A: float                        # longitudinal A = 1/(2 R_x), under yaw that of the upright ellipse [1/m]
    penetration_share: float        # penetration of the upright ellipse along the normal over the total [-]
    load_per_square: float          # ANALYN's line load over the square of the half-length, eq. (S7) [N/m^3]
    loaded: bool
    half_length: float              # a of this sweep [m]
    log_half_length: float          # ln a
    y: float                        # h p / (pi E*), eq. (S5) [m]; 0 where the strip is not loaded
    line_load: float                # q [N/m]
    half_length_square: float       # a^2 after this sweep, eq. (S8) [m^2]
    pressure: float                 # p on the middle line, eq. (S8) [Pa]
    curvature: float                # relative longitudinal curvature 1/R_x of the surfaces [1/m]


Strips = Strip * STRIP_LIMIT
#: Numbers of pairs of strips: row i, column j.
DistanceRow = run(STRIP_LIMIT)
Distances = DistanceRow * STRIP_LIMIT
InfluenceRow = run(STRIP_LIMIT)
Influences = InfluenceRow * STRIP_LIMIT
#: Linear equations: coefficients of the unknowns, then two right-hand sides, which become the two solutions.
EquationRow = run(STRIP_LIMIT + 2)
Equations = EquationRow * STRIP_LIMIT


@record
class StripProblem:
    penetration: float              # that ANALYN predicts [m]
    count: int                      # strips of all regions, in the order of regions and stations
    even: float                     # of all strips, the share per metre that is spread evenly [1/m]
    graded: float                   # and the share per weight that is spread by weight [m^-1/2]
    zones: StripZone * REGION_LIMIT
    strips: Strips
    loaded: run(STRIP_LIMIT)        # the numbers of the loaded strips, in order
    distances: Distances            # ln of the distance of strips i and j, in metres
    influences: Influences          # F_ij, displacement of middle line i for y_j = 1; eqs. (S2), (S4)


@record
class InfluenceTable:
    start: float                    # ln(distance / half-length) where the first cell begins
    cells_per_unit: float
    count: float                    # number of cells
    cells: Cubic * OPEN             # Phi of eq. (S2) over the place 0 <= u < 1 in each cell


HERTZ_ROW: Final[int] = 12           # numbers of a cell of Hertz's table


@record
class HertzTable:
    """1 + alpha and n r over ln(B/A), as quintics over uniform cells (normal/hertz.py)."""

    count: float                    # cells
    start: float                    # where the first one begins
    cells_per_unit: float
    rows: Float * OPEN              # HERTZ_ROW numbers a cell: six of 1 + alpha, six of n r
