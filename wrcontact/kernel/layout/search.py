"""Records of the room search: the raster over wheel and rail, what is known of a side, rolls that
were tried, and starts."""

from typing import Final

from .creep import Motion
from .patch import Forces, Outline, Patches, PatchTotals, StripsOfPatches, WearRuns
from .record import OPEN, Float, To, record, run, size
from .contact import Place

SCAN_LIMIT: Final[int] = 400  # nodes of the raster over a wheel
EXPONENTS: Final[int] = 6  # bounds are known over stretches of 2^0, 2^1 ... 2^5 cells of the raster
# parts of a cell that wait to be searched; 1 mm is halved down to 1 pm 30 times
STACK_LIMIT: Final[int] = 52
TRIAL_LIMIT: Final[int] = 60  # rolls kept at a time on the way to the first root
START_COUNT: Final[int] = 61  # lateral shifts for which a start is kept


@record
class ScanNode:
    """A node of the raster over the wheel."""

    y: float  # wheel abscissa [m]
    height: float  # of the profile [m]
    slope: float  # [-]
    bend: float  # second derivative there, on the side of the next node [1/m]
    departure: float  # its largest departure from a straight line up to the next one [1/m]
    least_bend: float  # smallest second derivative up to the next node [1/m]
    most_bends: Float * EXPONENTS  # largest one up to the node 2^k further on [1/m]
    steepest_bends: Float * EXPONENTS  # largest absolute value, likewise [1/m]
    lever: float  # largest change of the gap with the roll, from here outwards [m]


@record
class RailCell:
    """A cell of the raster over the rail."""

    least_bend: float  # smallest and largest second derivative around it [1/m]
    most_bend: float
    wave: float  # largest absolute fourth derivative around it [1/m^3]
    kinks: float  # sum of the jumps of the third one [1/m^2]
    joint: int  # the first joint beyond where that begins
    least_bends: Float * (EXPONENTS + 1)  # smallest one over 2^k cells from here [1/m]
    turns: Float * (EXPONENTS + 1)  # bound of slope times second derivative over 1 + slope^2 [1/m]


@record
class RailJoint:
    """A place where the second derivative of the rail jumps."""

    place: float  # abscissa [m]; beyond everything in the one after the last
    jump: float  # [1/m]


SCAN_NODE_SIZE: Final[int] = size(ScanNode)
RAIL_CELL_SIZE: Final[int] = size(RailCell)
RAIL_JOINT_SIZE: Final[int] = size(RailJoint)
#: The raster's cells of the rail and its joints, and the number of the first node of each bin of the wheel.
RailCells = RailCell * OPEN
RailJoints = RailJoint * OPEN
Bins = run(OPEN)


@record
class Scan:
    """The raster over wheel and rail; its nodes are followed by the rail's cells, the bins and the joints."""

    count: int  # of nodes
    rail_count: int  # of the rail's cells
    rail_start: float  # where the first one begins [m]
    rail_per_metre: float
    rail: To(RailCells)
    bins: To(Bins)
    joints: To(RailJoints)
    bin_count: int
    bins_per_metre: float
    steepest: float  # largest absolute slope of the wheel [-]
    nodes: ScanNode * OPEN


@record
class Cell:
    """A part of a cell that waits to be searched: its ends, and gap and slope difference there."""

    low: float  # wheel abscissae [m]
    high: float
    gap_low: float  # [m]
    gap_high: float
    mismatch_low: float  # slope of the rail minus that of the outline [-]
    mismatch_high: float
    least: float  # bounds of the gap's second derivative in it [1/m]
    most: float


@record
class ContactPoint:
    """Where a wheel touches or overlaps its rail most, in the frames of wheel, rail and track."""

    x_wheel: float  # [m]
    y_wheel: float
    z_wheel: float
    y_rail: float
    z_rail: float
    x_track: float
    y_track: float
    z_track: float
    contact_angle: float  # [rad]
    rolling_radius: float  # [m]
    curvature_x: float  # relative ones [1/m]
    curvature_y: float


@record
class Deflection:
    """How far a rail on springs stands from their foot, and how fast it moves."""

    lateral: float  # to the field side [m]
    vertical: float  # down [m]
    lateral_rate: float  # [m/s]
    vertical_rate: float


@record
class SideSearch:
    """One wheel on its rail: what the search has found, its patches, and the forces on it."""

    place: Place
    deflection: Deflection  # of its rail
    best: float  # smallest gap found [m]
    best_y: float  # its wheel abscissa [m]
    best_rail: float  # and its abscissa on the rail [m], while the roll is sought
    scan_count: float  # searches of it for a smaller gap
    roll_count: float  # turns of the search for roll or equilibrium, counted on the right side
    stack: Cell * STACK_LIMIT
    point: ContactPoint
    penetration: float  # approach of the two bodies along the normal [m]
    model_error: float  # estimate of the normal model's error in the peak pressure [-]; 0 without one
    patch_count: int
    patches: Patches  # by rising station
    totals: PatchTotals  # of all of them
    outline: Outline
    wear: WearRuns
    worn: StripsOfPatches
    motion: Motion
    forces: Forces


#: Left and right side.
Sides = SideSearch * 2


@record
class RollTrial:
    """What is known of the difference of the gaps at a roll."""

    roll: float  # [rad]
    difference: float  # smallest gap of the right side minus that of the left one [m]
    left: float  # wheel abscissae of the smallest gaps [m]
    right: float


@record
class RollTrials:
    """The way from zero roll to a root."""

    near: RollTrial  # up to here there is no root
    far: RollTrial * TRIAL_LIMIT  # the known root, then ends of unexamined stretches, nearest last


@record
class Start:
    """Where the search for the roll may start at a lateral shift."""

    known: bool  # whether the wheelset touches both rails there
    roll: float  # [rad]
    left: float  # wheel abscissae of the contacts [m]
    right: float


@record
class Starts:
    """Starts at even lateral shifts."""

    count: float  # none while the table is being filled
    first_shift: float  # [m]
    per_metre: float
    rows: Start * START_COUNT


STARTS_SIZE: Final[int] = size(Starts)
