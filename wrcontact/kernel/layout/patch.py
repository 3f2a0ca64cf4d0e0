"""Records of the rooms patch and normal: the contact patches of a wheel, from the model of normal contact to
the report, and the nodes and strips of regions.

Everything stands in the frame of a right wheel: y to the field side, z down.  A left wheel is mirrored where
its forces are added to those of the right one, and in the report.
"""

from typing import Final

from .contact import REGION_LIMIT, Cubic
from .interface import RUN_COUNT, STATION_LIMIT, WEAR_RUN_COUNT, Vector
from .record import OPEN, Float, centred, record, run, size

SOLVED_PATCH_LIMIT: Final[int] = 8  # contact patches of one wheel
SOLVED_STRIP_LIMIT: Final[int] = 1024  # strips of all of them: the nodes of four regions
ROLLING_STRIP_LIMIT: Final[int] = 16  # strips that a patch is cut into along the rolling direction

#: A number for each region.
RegionRun = run(REGION_LIMIT)

# how half-length and pressure follow between the strips of a patch (patch/outline.py)
RULE_ELLIPSE: Final[int] = 0  # the patch is an ellipse and has no strips: in closed form
RULE_QUADRATIC: Final[int] = 1  # quadratics through the squares at evenly spaced strips
RULE_STRAIGHT: Final[int] = 2  # straight lines through the squares, to zero at the patch's edges
NODE_LIMIT: Final[int] = 256  # nodes of a region
NODE_MIDDLE: Final[int] = 128  # place of node 0 in them

#: Numbers at the nodes of a region; node 0 is at its minimum.
NodeRun = centred(NODE_LIMIT, NODE_MIDDLE)


@record
class SolvedStrip:
    station: float  # of its middle, along the rail's profile, from the contact point [m]
    width: float  # along the profile [m]; 0: outside the patches, for the interpolation
    x: float  # track coordinate x of its middle [m]
    curvature: float  # relative longitudinal curvature 1/R_x [1/m]
    line_load: float  # load per width [N/m]; not above zero where there is no load, like
    half_length_square: float  # the square of its half-length [m^2] and
    pressure_square: float  # the square of the pressure on its middle [Pa^2]


@record
class PatchTotals:
    """Of one patch, or of all patches of a wheel together."""

    load: float  # [N]
    area: float  # [m^2]
    moment: float  # of the load about station zero [N m]
    centroid: float  # station of the load's centre [m]
    max_pressure: float  # [Pa]
    max_half_length: float  # [m]
    start: float  # stations of the edges [m]
    stop: float
    width: float  # from edge to edge [m]


SolvedStrips = SolvedStrip * SOLVED_STRIP_LIMIT


@record
class RollingStrip:
    """A strip of a patch along the rolling direction, with the creep force on it."""

    start: float  # stations of its edges [m]
    stop: float
    station: float  # and of its middle
    y: float  # its middle, from the patch's centre of load [m]
    width: float  # [m]
    x: float  # how far its middle is ahead of the centre of load [m]
    half_length: float  # [m]
    line_load: float  # load per width [N/m]
    slip: float  # its longitudinal creepage [-],
    lateral: float  # its lateral one on its middle [-]
    spin: float  # and its spin [1/m], about its own normal
    y_track: float  # track coordinates of its middle [m]
    z_track: float
    cos: float  # of the rail's inclination there, downwards to the field side: its normal
    sin: float  # is (0, sin, -cos)
    rolling_radius: float  # there [m],
    radius_share: float  # and over its distance from the axle [-]
    force_x: float  # creep force on the wheel per width [N/m],
    force_y: float
    moment: float  # and moment of the lateral one about the centre of load, per width [N]


@record
class Forces:
    """Forces on a patch, a wheel or the wheelset, and their moments about the wheelset's centre."""

    force: Vector  # [N]
    moment: Vector  # [N m]
    normal_force: Vector  # of the pressures alone
    normal_moment: Vector
    driving_torque: float  # of the creep forces about the axle [N m], positive where it drives
    friction_power: float  # that friction takes [W],
    damping_power: float  # and that contact damping takes
    wear_number: float  # creep forces times creepages [N]


@record
class Patch:
    """One contact patch of a wheel, from its normal model to the report."""

    totals: PatchTotals
    pressure_square: float  # squares of the largest pressure [Pa^2] and of the largest half-length
    half_length_square: float  # [m^2], while it is filled
    loads: RegionRun  # what of its load lies in each region [N],
    moments: RegionRun  # and the moment of that about station zero [N m]
    rank: int  # its place among the patches of the wheel by load, from 1; 0: no load
    rule: int  # how to interpolate between its solved strips, one of RULE_...
    first: int  # the solved strips that it lies between: the outermost may have no width
    last: int
    slant: float  # of the line through the strips' middles, dx/ds [-]; 0 without yaw
    rail: float  # its point, the closest or deepest one: rail abscissa [m],
    wheel: float  # wheel abscissa [m],
    station: float  # station [m],
    x: float  # track coordinate x [m]
    penetration: float  # of the undeformed surfaces at its point [m]
    contact_angle: float  # of its force [rad],
    angle_sin: float  # and its sine and cosine
    angle_cos: float
    x_track: float  # its centre of load [m]
    y_track: float
    z_track: float
    rolling_radius: float  # there [m]
    normal_y: float  # force of its pressures [N]; x has no part of it
    normal_z: float
    normal_moment: Vector  # and its moment about the track's origin [N m]
    damping_power: float  # that contact damping takes [W]
    half_length: float  # semi-axes of the ellipse with its area, length over width [m]
    half_width: float
    friction: float  # coefficient of friction [-]; once the force is known its mean, where it falls
    fall_rate: float  # how fast friction falls with the creepages of points [-]; 0: it does not
    fall_floor: float  # friction at infinite sliding over that of rest [-]
    speed: float  # the rolling speed [m/s]
    creepage_x: float  # velocity of the wheel on the rail over the rolling speed: x forward,
    creepage_y: float  # y to the field side [-],
    spin: float  # and its turning about x times y [1/m]
    radius_share: float  # rolling radius over the distance from the axle [-]
    backwards: bool  # whether it rolls towards -x
    strips: RollingStrip * ROLLING_STRIP_LIMIT
    creep_x: float  # creep force on the wheel [N], in the frame of the creepages
    creep_y: float
    creep_moment: float  # and its moment about the normal through the centre of load [N m]
    stick_share: float  # share of the area that sticks [-]
    max_shear: float  # largest traction [Pa]
    normal_x: float  # force of its pressures along a rail that changes [N]
    slope: float  # inclination of its force along the track [rad]
    saturation: float  # creep force over friction times load [-]
    forces: Forces


Patches = Patch * SOLVED_PATCH_LIMIT


@record
class Outline:
    """Stations, half-lengths and pressures of one wheel, as many of each as stations are wanted, one run
    after the other."""

    numbers: Float * (RUN_COUNT * STATION_LIMIT)


@record
class WearRuns:
    """Places on wheel and rail, friction power per width and numbers of patches at the stations of one wheel,
    one run after the other: the rows WEAR of outputs.py."""

    numbers: Float * (WEAR_RUN_COUNT * STATION_LIMIT)


#: A number for each strip along the rolling direction.
StripNumbers = run(ROLLING_STRIP_LIMIT)


@record
class StripOutputs:
    """Outputs of the strips of one patch: the rows STRIPS of outputs.py."""

    wheel_place: StripNumbers  # [m]
    rail_place: StripNumbers
    width: StripNumbers
    line_load: StripNumbers  # [N/m]
    half_length: StripNumbers  # [m]
    power: StripNumbers  # [W/m]
    slip: StripNumbers  # [m/s]


#: Those of the patches of one wheel, in the order of the patches.
StripsOfPatches = StripOutputs * SOLVED_PATCH_LIMIT


@record
class Nodes:
    gap: NodeRun  # rise of the gap over the region's minimum [m]
    A: NodeRun  # longitudinal A = 1/(2 R_x) [1/m]
    rise: NodeRun  # (1 + beta) times the gap's rise [m]
    line: NodeRun  # E* / (n r): line load per local penetration [N/m^2]
    length: NodeRun  # (1 + alpha) A [1/m]
    B: NodeRun  # lateral curvature B [1/m]
    turn: NodeRun  # cosine of the angle between the rail's normal and the region's [-]


NodesOfRegions = Nodes * REGION_LIMIT


WAVE_LIMIT: Final[int] = 16  # strips of a run, at most,
FINE_WAVES: Final[int] = 3  # as many fine ones for each of them,
FINE_LIMIT: Final[int] = 48  # so many for all
STRIP_RUN_LIMIT: Final[int] = 6  # runs of loaded strips of one wheel
STRIP_LIMIT: Final[int] = 96  # their strips
TRACED_LIMIT: Final[int] = 64  # stations at which the surfaces under strips are traced, all zones

WaveRow = run(WAVE_LIMIT)
FineRow = run(FINE_LIMIT)


@record
class Waves:
    """What the strips of a run have from their number alone: strip i lies at angle t_i = (i + 1/2) pi / n,
    fine strip k at (k + 1/2) pi / (3 n); eqs. (S10) ... (S13)."""

    count: int  # n
    cos: WaveRow
    sin: WaveRow
    spread: WaveRow  # ln(n / (pi sin t))
    start: WaveRow  # weights of a smooth function's value at the start of the run
    stop: WaveRow  # and at its end
    singular: WaveRow * WAVE_LIMIT  # 2 (n / pi) D_ij: what the rule of points leaves out of the logarithm
    fine_cos: FineRow
    fine_sin: FineRow
    smoothing: FineRow * WAVE_LIMIT  # values at strips of the first n cosines through fine strips
    refining: WaveRow * FINE_LIMIT  # values at fine strips of the cosines through strips
    roughness: FineRow * FINE_LIMIT  # sum of m g_m cos(m t) over the cosines from n on


@record
class StripZone:
    """Where the wheel overlaps the rail around the deepest point of a region."""

    start: float  # stations of its ends [m]
    stop: float
    middle: float  # and of its deepest point
    depth: float  # how deep that is [m]
    spacing: float  # of its traced stations [m]
    one_alpha: float  # ANALYN's coefficients there: 1 + alpha,
    line: float  # and E* / (n r): line load per penetration [N/m^2]
    lean: float  # slope dx/ds of the line of middles over that of the ridge [-]


@record
class TracedStation:
    """Wheel and rail at a station; between stations they follow by interpolation."""

    station: float  # s [m]
    region: int  # the region that it belongs to
    joined: bool  # the next one lies on the same curve
    overlap: float  # of wheel and rail, on the ridge [m]
    rise: float  # how fast that rises along the rail [-]
    wheel: float  # wheel abscissa [m]
    level: float  # a^2 (1 + alpha) A of a strip as ANALYN has it [m]
    place: float  # the station on the curve between wheel and rail [m]
    stretch: float  # length there over that along the rail [-]
    cos: float  # of the inclination of that curve
    sin: float
    x: float  # track coordinate x of the ridge [m]
    A: float  # the gap beside the ridge, at a distance x: x^2 (A + skew x) [1/m]
    skew: float  # [1/m^2]
    odd: float  # skew x is within +-this, its value where it was measured [1/m]
    share: float  # of the penetration that comes along its normal [-]
    counted: float  # share of its load that counts for the prescribed force [-]
    gaps: Float * 4  # cubic of the gap on the way to the next station, 0 ... 1 [m]


@record
class StripRun:
    """A run of loaded strips."""

    low: int  # first and last traced station of its curve
    high: int
    start: float  # stations of its edges [m]
    stop: float
    next_start: float  # and after this sweep
    next_stop: float
    start_move: float  # how far outwards the edges have moved in this sweep [m]
    stop_move: float
    origin: int  # the run of the sweep before whose strips it has; -1: it has new ones
    gaps: FineRow  # share times sunk depth, less the overlap, at its fine strips [m]


@record
class Strip:
    station: float  # s [m]
    region: int  # the region that it belongs to
    place: float  # its place on the curve between wheel and rail [m]
    stretch: float  # length there over that along the rail [-]
    cos: float  # of the inclination of that curve
    sin: float
    x: float  # track coordinate x of the ridge [m]
    A: float  # the gap beside the ridge, at a distance x: x^2 (A + skew x) [1/m]
    skew: float  # [1/m^2]
    odd: float  # skew x is within +-this, its value where it was measured [1/m]
    share: float  # of the penetration that comes along its normal [-]
    counted: float  # share of its load that counts for the prescribed force [-]
    gap: float  # on its middle, where nothing penetrates [m]
    width: float  # what it stands for on the curve [m]
    axis: float  # its half-length over sin t [m]
    half_length: float  # a of this sweep [m]
    square: float  # and its square [m^2]
    slender: float  # ln(width / half-length)
    lead: float  # of its middle before the ridge, along x [m]
    middle: float  # track coordinate x of its middle [m]
    y: float  # p / (pi E*) on its middle [-], of this sweep
    next_axis: float  # axis, lead, half-length and station after this sweep [m]
    next_lead: float
    next_half: float
    next_station: float
    pressure: float  # and the pressure on its middle, of the same load [Pa],
    smooth: float  # over sin t, if it presses


Strips = Strip * STRIP_LIMIT
#: Numbers of pairs of strips: row i, column j.
PairRow = run(STRIP_LIMIT)
PairNumbers = PairRow * STRIP_LIMIT
#: Linear equations: coefficients of the unknowns, then two right-hand sides, which become the two solutions.
EquationRow = run(STRIP_LIMIT + 2)
Equations = EquationRow * STRIP_LIMIT


@record
class StripRows:
    """What loops over pairs of strips read: numbers of all strips in rows, by the names that a strip has for
    them, and rows for one strip beside all."""

    place: PairRow
    cos: PairRow
    sin: PairRow
    half_length: PairRow
    square: PairRow
    width: PairRow
    middle: PairRow
    near: PairRow  # how near all lie to one strip, in the cells of the table of influences,
    ahead: PairRow  # and how far apart along x, in its columns: before that one's middle
    behind: PairRow  # and behind it


@record
class StripProblem:
    penetration: float  # for which the surfaces are traced [m]
    traced_count: int
    run_count: int
    count: int  # strips of all runs, in the order of stations
    strip_count: float  # systems solved
    zones: StripZone * REGION_LIMIT
    traced: TracedStation * TRACED_LIMIT
    runs: StripRun * STRIP_RUN_LIMIT
    next_count: int  # runs of the next sweep
    next_runs: StripRun * STRIP_RUN_LIMIT
    strips: Strips
    rows: StripRows
    cells: PairNumbers  # for strips i and j, the first number of the cell of the table of influences that
    within: PairNumbers  # holds t = distance / half-length of j, and where in it, 0 ... 1
    facing: PairNumbers  # cosine of the angle between i and j, by j's width [m]; 0 of itself


INFLUENCE_CELLS: Final[int] = 96  # of the table of influences along sqrt(t / (1 + t)),
INFLUENCE_COLUMNS: Final[int] = 48  # and along e^2 / (1 + e^2)
#: Numbers of a column, the parabola of each cell, and of the map.
INFLUENCE_COLUMN: Final[int] = 3 * INFLUENCE_CELLS
INFLUENCE_MAP: Final[int] = INFLUENCE_COLUMN * (INFLUENCE_COLUMNS + 1)
SPACING_CELLS: Final[int] = 192  # of the two tables of spacing, behind the map


@record
class InfluenceTable:
    numbers: Float * OPEN  # map of Phi, eq. (S2), then the tables of spacing, eq. (S12), in the
    # middle of a strip and beside it (binding/fixed_tables.py)


HERTZ_ROW: Final[int] = 12  # numbers of a cell of Hertz's table
HERTZ_CELLS: Final[int] = 32  # its cells in each octave of B/A
HERTZ_OCTAVES: Final[int] = 26  # and its octaves on each side of 1


@record
class HertzTable:
    """1 + alpha and n r over B/A, as quintics over HERTZ_CELLS even cells in each octave, between
    2^-HERTZ_OCTAVES and 2^HERTZ_OCTAVES (normal/coefficients.py)."""

    rows: Float * OPEN  # HERTZ_ROW numbers a cell: six of 1 + alpha, six of n r
