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
    turn: NodeRun                   # cosine of the angle between the rail's normal and the region's [-]


NodesOfRegions = Nodes * REGION_LIMIT


@record
class StripZone:
    """Where the wheel overlaps the rail around the deepest point of a region."""

    start: float                    # stations of its ends [m]
    stop: float
    level: float                    # how deep it is, over the overlap at its ends [m]


@record
class StripCell:
    """A piece of the rail that is divided into strips."""

    start: float                    # stations of its ends [m]
    stop: float
    weight: float                   # its share of the strips, over that of all cells
    half_length: float              # of the strip that was there before [m], and how far
    lead: float                     # the middle of that was before the ridge [m]
    loaded: bool                    # whether it was


@record
class Strip:
    station: float                  # s of its middle [m]
    width: float                    # along the rail [m]
    region: int                     # the region that it belongs to
    joined: bool                    # it touches the next strip
    place: float                    # its middle on the curve between wheel and rail [m],
    breadth: float                  # and its width there [m]
    cos: float                      # of the inclination of that curve
    sin: float
    overlap: float                  # of wheel and rail where they were laid, on the ridge [m]
    rise: float                     # how fast that rises along the rail [-]
    wheel: float                    # wheel abscissa there [m]
    x: float                        # track coordinate x of the ridge [m]
    A: float                        # the gap beside the ridge, at a distance x: A x^2 + skew x^3 [1/m]
    skew: float                     # [1/m^2]
    share: float                    # of the penetration that comes along its normal [-]
    counted: float                  # share of its load that counts for the prescribed force [-]
    gap: float                      # on its middle, where nothing penetrates [m]
    loaded: bool
    known: bool                     # how it displaces all strips
    half_length: float              # a of this sweep [m]
    lead: float                     # of its middle before the ridge, along x [m]
    y: float                        # h p / (pi E*), eq. (S5) [m]; 0 where the strip is not loaded
    line_load: float                # q [N/m]
    half_length_square: float       # a^2 after this sweep [m^2]
    pressure: float                 # p on its middle [Pa]
    next_lead: float                # its lead after this sweep [m]


Strips = Strip * STRIP_LIMIT
#: Numbers of pairs of strips: row i, column j.
InfluenceRow = run(STRIP_LIMIT)
Influences = InfluenceRow * STRIP_LIMIT
#: Linear equations: coefficients of the unknowns, then two right-hand sides, which become the two solutions.
EquationRow = run(STRIP_LIMIT + 2)
Equations = EquationRow * STRIP_LIMIT


@record
class StripProblem:
    penetration: float              # for which the strips are laid [m]
    count: int                      # strips of all regions, in the order of stations
    cell_count: int
    zones: StripZone * REGION_LIMIT
    cells: StripCell * STRIP_LIMIT
    strips: Strips
    loaded: run(STRIP_LIMIT)        # the numbers of the loaded strips, in order
    near: Influences                # sqrt(t / (1 + t)) of strips i and j, t = distance / half-length of j
    influences: Influences          # F_ij, displacement of the middle of i for y_j = 1; eq. (S2)


INFLUENCE_CELLS: Final[int] = 96     # of the table of influences along sqrt(t / (1 + t)),
INFLUENCE_COLUMNS: Final[int] = 48   # and along e^2 / (1 + e^2)
#: Numbers of a column, the parabola of each cell, and of a map.
INFLUENCE_COLUMN: Final[int] = 3 * INFLUENCE_CELLS
INFLUENCE_MAP: Final[int] = INFLUENCE_COLUMN * (INFLUENCE_COLUMNS + 1)


@record
class InfluenceTable:
    numbers: Float * OPEN           # map of Phi, eq. (S2), then of its means (binding/influence_table.py)


HERTZ_ROW: Final[int] = 12           # numbers of a cell of Hertz's table


@record
class HertzTable:
    """1 + alpha and n r over ln(B/A), as quintics over uniform cells (normal/coefficients.py)."""

    count: float                    # cells
    start: float                    # where the first one begins
    cells_per_unit: float
    rows: Float * OPEN              # HERTZ_ROW numbers a cell: six of 1 + alpha, six of n r
