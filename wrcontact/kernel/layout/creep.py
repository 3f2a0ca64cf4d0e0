"""Records of the room creep: how wheelset and rails move, and what the models of creep forces work with."""

from typing import Final

from .interface import Vector
from .patch import ROLLING_STRIP_LIMIT, SOLVED_PATCH_LIMIT
from .record import Float, record, run

# the table of rolling: columns over the shape of a patch, ln(a/b), as cubics over even cells
SHAPE_START: Final[float] = -3.0
SHAPE_PER_UNIT: Final[float] = 4.0
SHAPE_CELLS: Final[int] = 28
SHAPE_COLUMNS: Final[int] = 6  # 1/C11, 1/C22, 1/C23 and the factors of strips' stiffnesses
SHAPE_ROW: Final[int] = 4 * SHAPE_COLUMNS
# how strips of tractions reach beside themselves, over the fourth root of distance / half-length, likewise
REACH_PER_UNIT: Final[float] = 32.0
REACH_CELLS: Final[int] = 90
REACH_COLUMNS: Final[int] = 3  # longitudinal, lateral, spin
REACH_ROW: Final[int] = 4 * REACH_COLUMNS
# what exact forces of ellipses differ from the strips' by, over ln(a/b) and the saturation in polar
# coordinates; the last ones are r / (1 + r) with 0 and 1
CORRECTION_RATIOS: Final[int] = 9
CORRECTION_ELEVATIONS: Final[int] = 6
CORRECTION_AZIMUTHS: Final[int] = 13
CORRECTION_RADII: Final[int] = 12
CORRECTION_COLUMNS: Final[int] = 4  # force_x, force_y over mu N, moment over mu N sqrt(ab), stick share
CORRECTION_SCALES: Final[int] = 3 * CORRECTION_RATIOS
CORRECTION_AXES: Final[int] = 5  # slopes: force_x by s1, force_y by s2 and s3, moment by s2 and s3
CORRECTION_SLOPES: Final[int] = CORRECTION_AXES * CORRECTION_RATIOS
CORRECTION_LINE: Final[int] = CORRECTION_RADII * CORRECTION_COLUMNS
CORRECTION_SIZE: Final[int] = (
    CORRECTION_RATIOS * CORRECTION_ELEVATIONS * CORRECTION_AZIMUTHS * CORRECTION_LINE
)

POINT_LIMIT: Final[int] = 16  # points of a strip, from its leading edge


@record
class RailMotion:
    """How a rail moves, and the place about which it rolls; and how a roller turns about its axle."""

    lateral: float  # velocity to the right [m/s]
    vertical: float  # and down
    roll: float  # rotation, right side down [rad/s]
    y: float  # track coordinates of its highest point [m]
    z: float
    turn: float  # of a roller, whose surface runs back below the wheel [rad/s]; 0 for a rail
    axle_x: float  # place of its axle ahead of the wheelset's middle, and below the track [m]
    axle_z: float


@record
class Leaning:
    """A place of contact on a rail whose section changes, in the track; the left side's is mirrored."""

    x: float  # place [m]
    y: float
    z: float
    ahead: Vector  # along the rail in the plane of contact,
    aside: Vector  # to the field side in it,
    down: Vector  # and along the normal into the rail, which is ahead x aside [-]
    swelling: float  # how fast a wheel that is not round grows there towards the rail as it turns [m]


@record
class LeaningPatch:
    """Those of a patch: of its centre of load, and of its strips."""

    own: Leaning
    strips: Leaning * ROLLING_STRIP_LIMIT


@record
class Constraint:
    """What keeps a wheel on its rail: a force on it does no work as the wheelset moves."""

    y: float  # the force in the track frame, in any unit
    z: float
    moment_x: float  # its moment about the wheelset's centre, in this unit times m
    moment_y: float
    moment_z: float


@record
class Motion:
    """How the wheelset and the rail of one side move in the track frame; the left side's is mirrored."""

    speed: float  # of its centre along the track [m/s]
    lateral: float  # to the right
    vertical: float  # and down
    turn_x: float  # its rotation but for that about the axle [rad/s]
    turn_y: float
    turn_z: float
    wheel_rate: float  # rotation about the axle, positive when it rolls forward [rad/s]
    track_rate: float  # rotation of the track frame in space, about z [rad/s]
    ahead_x: float  # direction of the axis about which the wheelset rolls, forward
    ahead_y: float
    axle_x: float  # direction of the axle, to the right
    axle_y: float
    axle_z: float
    centre_y: float  # the wheelset's centre [m]
    centre_z: float
    rail: RailMotion
    constraint: Constraint


@record
class RollingTable:
    """What the models of creep forces read, for one Poisson's ratio (tools/tables/rolling_table.py)."""

    cosines: Float * POINT_LIMIT  # points of a strip x/a = cos(q pi / (n + 1)), q = 1 ... n,
    sines: Float * POINT_LIMIT  # and sqrt(1 - (x/a)^2) there
    shapes: Float * (SHAPE_ROW * SHAPE_CELLS)
    reaches: Float * (REACH_ROW * (REACH_CELLS + 1))  # the last row is what stays beyond the cells
    radii: Float * CORRECTION_RADII
    scales: Float * CORRECTION_SCALES
    corrections: Float * CORRECTION_SIZE
    slopes: Float * CORRECTION_SLOPES  # of the corrections at no creepage


BLOCK_COUNT: Final[int] = 8  # pairs of strips, for which stiffnesses are found


@record
class RollingBlock:
    """A pair of strips."""

    start: float  # stations of its edges [m]
    stop: float
    half_length: float  # [m]
    slip: float  # mean longitudinal creepage [-]
    along: float  # its stiffnesses K1, K2, K3 [Pa], eq. (K3)
    across: float
    turning: float


#: Equations of the blocks: coefficients of the unknowns, then two right-hand sides, which become the
#: solutions: for unit creepages, and for the longitudinal ones of the blocks.
BlockRow = run(BLOCK_COUNT + 2)
BlockMatrix = BlockRow * BLOCK_COUNT
RollingBlocks = RollingBlock * BLOCK_COUNT


#: Patches of both wheels, which may turn about one axle.
AXLE_PATCHES: Final[int] = 2 * SOLVED_PATCH_LIMIT


#: Those of the left wheel, then those of the right one.
LeaningPatches = LeaningPatch * AXLE_PATCHES


@record
class KeptStiffnesses:
    """Of a patch whose creepages change: what its stiffnesses have been found with."""

    blocks: RollingBlocks
    equations_x: BlockMatrix


@record
class StripIntegration:
    """A strip while its stick zone is found, and FaStrip's tractions; equations of coupled_strips.py."""

    half_length: float  # a [m]
    rate: float  # m, bound of the traction over sqrt(a^2 - x^2) [Pa/m]
    slip: float  # w_x [-]
    lateral: float  # w_y on its middle [-]
    spin: float  # [1/m]
    along: float  # stiffnesses K1, K2, K3 [Pa]
    across: float
    turning: float
    spread: float  # s^2 [m^2] of eq. (Z3)
    carried: float  # its share of the force of linear theory
    weight: float  # c, how much the stick zone counts; 0: the strip slips all over
    depth: float  # d, half the length of the slip zone [m]
    lead_x: float  # u and v of the creepages [m], eq. (Z2)
    lead_y: float
    stick_x: float  # e, direction of the stick zone's traction
    stick_y: float
    twist: float  # k, share of spin in it
    edge: float  # where the stick zone begins, -a + 2 d [m]
    push_x: float  # FaStrip: what the traction loses per way [Pa/m]: along,
    push_y: float  # across on the middle,
    push_turn: float  # and across per distance from it [Pa/m^2]
    x: float  # where it has come to [m]
    first_x: float  # traction there, as if nothing stuck [Pa]
    first_y: float
    sum_x: float  # sums of tractions over the points,
    sum_y: float
    sum_moment: float  # and of x p_y
    largest: float  # square of the largest traction [Pa^2]


#: A number for each strip.
StripRow = run(ROLLING_STRIP_LIMIT)


@record
class StripIntegrations:
    """All strips side by side while their tractions are followed; equations of traction_integration.py.  Places are
    over a and tractions over m a."""

    push_x: StripRow  # what the traction of integration A loses per way: along,
    push_y: StripRow  # across on the middle,
    push_turn: StripRow  # and across per distance from it
    centre_x: StripRow  # the same of integration B
    centre_y: StripRow
    centre_turn: StripRow
    lag: StripRow  # where in a step the spin is taken, of the step
    slips: StripRow  # how much the traction of slip counts,
    noted: StripRow  # and the square of it in the largest traction
    first_x: StripRow  # tractions of both integrations
    first_y: StripRow
    second_x: StripRow
    second_y: StripRow
    sum_x: StripRow  # sums of tractions over the points,
    sum_y: StripRow
    sum_moment: StripRow  # and of x p_y
    largest: StripRow  # square of the largest traction
    sticks: StripRow  # c, how much the stick zone counts; 0: the strip slips all over
    stick_x: StripRow  # e, direction of the stick zone's traction
    stick_y: StripRow
    edge: StripRow  # where the stick zone begins
    edge_x: StripRow  # traction there
    edge_y: StripRow
    edge_share: StripRow  # its way to the next point, of the step between the points around it
    next: StripRow  # the next strip whose stick zone ends before the same point; -1: none
    at_point: Float * POINT_LIMIT  # the first of them
    share: float  # W, of integration B in the direction of slip


@record
class FallingFriction:
    """Friction at a point of all strips while their tractions are followed (falling.py)."""

    floor: float  # friction at infinite sliding over that of rest [-]
    slide_x: StripRow  # exponent of the law: along,
    slide_y: StripRow  # across on the middle,
    slide_turn: StripRow  # and across per place x/a
    share: StripRow  # friction at the point over that of rest
    slips: StripRow  # slips and noted of the integrations, without friction's share
    noted: StripRow
    lost: StripRow  # sums over the points of what friction has lost


@record
class Rolling:
    """What the models of creep forces work with, one patch after the other."""

    bare: bool  # whether only the sum over the strips is asked for
    published: bool  # FASTSIM and FaStrip: both parts of spin as they were published
    resting: bool  # whether friction is that of rest, from which it does not fall
    keeping: bool  # whether stiffnesses are kept, as patches stay and only their creepages change,
    place: int  # at which place,
    kept: bool  # and whether they are already there
    blocks: RollingBlocks
    shift: float  # of longitudinal creepages where strips begin to slip [-], eq. (K6)
    equations_x: BlockMatrix  # of the blocks, for longitudinal and lateral creepage and for spin
    equations_y: BlockMatrix
    equations_spin: BlockMatrix
    integration: StripIntegration  # of FaStrip, one strip after the other
    begun: StripIntegration * ROLLING_STRIP_LIMIT
    integrations: StripIntegrations
    falling: FallingFriction
    stiffnesses: KeptStiffnesses * AXLE_PATCHES


@record
class TurningPatch:
    """A patch of wheels whose rotation is sought, as the stand-in of creep/turning.py has it."""

    along: (
        float  # velocity of the wheel at its centre of load against the rail, along the wheel's own heading
    )
    radius: float  # and without its rotation [m/s]; rolling radius [m],
    ahead: float  # of which so much moves along the track [m]
    stiffness: float  # force over longitudinal creepage [N]
    lateral: float  # lateral force of small creepages times the rolling speed [W]
    limit: float  # friction times load [N]


@record
class Turning:
    """The rotation of wheels on which a given torque acts, while it is sought; equations of
    creep/turning.py."""

    rates: Float * 2  # of the left and the right wheel, as they were found [rad/s]
    sought: bool  # whether they have been found before in this step
    count: int
    patches: TurningPatch * AXLE_PATCHES
    wanted: float  # torque that drives the wheels from outside [N m]
    scale: float  # torque of all friction [N m]
    speed: float  # |V| [m/s]
    low: float  # rates with too much and too little torque [rad/s],
    high: float
    low_known: bool  # and whether these have been tried
    high_known: bool
    end_low: float  # no rate beyond these is tried where a torque is given
    end_high: float
    rate: float  # the last rate that was tried [rad/s],
    torque: float  # what it leaves of the torques [N m],
    missing: float  # and how much that is more than the stand-in's
    shift: float  # D [N m] and E [N m s] of eq. (A3)
    slope: float
    reach: float  # up to this distance E counts [rad/s]
    turns: int  # rates that were tried
    span: float  # distance of low and high when it was last halved [rad/s],
    slow: int  # and how many were tried since then
