"""The arrays as wholes, their sizes, and the records of the room wheelset.

``setup``    from which the tables are prepared.
``tables``   what is fixed during a simulation: settings at the head, then the tables that they point to.
             Each side has a pair of wheel and rail; both pairs point to the same tables where wheels or rails
             are equal.
``work``     the workspace of one step.
``state``    what one step leaves for the next.
"""

from typing import Final

from .contact import (
    CubicTable,
    CurvatureTable,
    DeepPoints,
    FirstWidths,
    Frame,
    KeptFrames,
    Origin,
    Overlap,
    Profile,
    Regions,
)
from .creep import LeaningPatches, Rolling, RollingTable, Turning
from .interface import PATCH_LIMIT, Inputs, Outputs, Parameters, PatchOutputs, Resolution, SideOutputs
from .patch import (
    Equations,
    Forces,
    HertzTable,
    InfluenceTable,
    NodesOfRegions,
    Outline,
    Patch,
    PatchTotals,
    SolvedStrips,
    StripOutputs,
    StripProblem,
    Waves,
    WearRuns,
)
from .record import WIDTH, Float, To, record, size
from .search import ContactPoint, RollTrials, Scan, Sides, Starts
from .sections import Sections, SectionSearch, SectionTouches, ValleyNodes


@record
class Wheelset:
    """Where the wheelset stands, and the forces on it."""

    roll: float  # [rad]
    vertical_shift: float  # [m]
    vertical_velocity: float  # and how fast both grow in elastic contact [m/s, rad/s],
    roll_rate: float
    settled: bool  # with what the depth adds (wheelset/depth_rates.py)
    forces: Forces


@record
class Support:
    """How a side carries its load."""

    approach: float  # how far the wheel is estimated to come down below its smallest gap [m]
    height: float  # the vertical shift at which it carries its load [m]
    lever: float  # how that follows the roll [m]
    friction_load: float  # what its normal forces are to carry, over the load of the inputs [-]
    load_before: float  # the one before [-],
    share_before: float  # and what share of the wanted force it has given [-]
    low_load: float  # loads that give less and more than that [-]; 0 where none is known
    high_load: float
    turns: float  # in which these were found
    trials: float  # of both wheels in this step, counted for the left one
    residual: float  # how much faster than the wheelset it comes down where it moves [m/s]
    point: ContactPoint  # what is kept of the side while it is displaced
    totals: PatchTotals
    penetration: float  # [m]
    model_error: float  # [-]
    patch_count: int


#: Of the left and right side.
Supports = Support * 2


@record
class Broyden:
    """Broyden's method for the height and roll of an elastic wheelset; rolls count in
    metres at the wheels."""

    left: float  # residuals: how much lower each side carries its load [m]
    right: float
    left_height: float  # their derivatives with respect to height and roll [-]
    left_roll: float
    right_height: float
    right_roll: float
    move_height: float  # the last move [m]
    move_roll: float
    best: float  # sum of both residuals where it was smallest [m],
    best_height: float  # and where that was [m, rad]
    best_roll: float
    stalled: float  # trials since then


@record
class Bracket:
    """Two places between which a value changes its sign."""

    low: float  # height [m] or roll [rad]
    high: float
    at_low: float  # the value there [m]
    at_high: float


@record
class Jump:
    """The way from one end of a bracket of the roll to the other, on which a wheel's load jumps."""

    roll: float  # of its first end [rad]
    height: float  # and the wheelset's there [m]
    turn: float  # to the other end [rad]
    climb: float  # [m]
    sign: float  # of how much lower the wheel carries its load than it stands, at the first end
    pattern: int  # of its regions there (penetration_maxima.region_pattern); -1 where its load is compared
    near: float  # the jump lies between these shares of the way [-]
    far: float
    searched: float  # how wide the bracket was when a jump was sought last [m]
    found: bool  # whether one was found
    apart_low: float  # the bracketed difference of heights at both ends [m]
    apart_high: float


@record
class Spring:
    """The springs and dampers of a rail: [N/m], [N s/m].  Without a stiffness it is rigid."""

    lateral_stiffness: float
    vertical_stiffness: float
    lateral_damping: float
    vertical_damping: float


@record
class TriedDeflection:
    """A deflection of a rail, and what its springs carry there more than the wheel presses."""

    lateral: float  # [m]
    vertical: float
    residual_lateral: float  # [N], of a rigid support the deflection [m]
    residual_vertical: float


@record
class RailSlopes:
    """How what the springs of a rail carry more than the wheel presses, laterally and vertically, follows both
    deflections [N/m]."""

    lateral_lateral: float
    lateral_vertical: float
    vertical_lateral: float
    vertical_vertical: float


@record
class RailEquilibrium:
    """A rail on springs that settles under the forces of its wheel.

    Over a step in time a damper is a spring, too, from another place.
    """

    lateral_stiffness: float  # of both together [N/m]; 0: rigid
    vertical_stiffness: float
    lateral_rest: float  # where the rail stands without forces [m]
    vertical_rest: float
    lateral_before: float  # and where it stood before the step in time [m]
    vertical_before: float
    lateral: float  # residuals: what the springs carry more than the wheel presses [N]
    vertical: float
    slopes: RailSlopes
    move_lateral: float  # the last move [m]
    move_vertical: float
    one: TriedDeflection  # two deflections whose moves lead towards each other,
    other: TriedDeflection
    away_lateral: float  # and the move from the first [m]
    away_vertical: float


@record
class BalancedRail:
    """A rail that has settled in this step, for the case that its wheel turns at another rate."""

    standing: (
        bool  # whether its wheel is lifted, or a force jumps past what the springs carry: it stays as it is
    )
    lifted: bool
    slopes: RailSlopes


@record
class Reference:
    """The vertical shift for which wheels are placed over rolled rails, while it is sought."""

    height: float  # the last one [m]
    low_load: float  # loads that give less and more than that [-]; 0 where none is known
    high_load: float
    residual: float  # how much lower the contact was found [m]
    slope: float  # how that follows the height [-]
    contacts: float  # how many were found
    within: Bracket  # heights below and above the one that is sought, and their residuals


@record
class State:
    """What one step leaves for the next; the head of its array."""

    array = "state"
    roll: float  # last valid roll [rad]
    warm: bool  # whether there is one
    y_left: float  # wheel abscissae of the last contacts [m]
    y_right: float
    shift: float  # and the lateral shift [m]


@record
class Setup:
    array = "setup"
    parameters: Parameters
    resolution: Resolution
    left_radius: float  # nominal radius of the left wheel [m]
    left_inclination: float  # of the left rail [1]
    left_spring: Spring  # below it
    absent: float  # not a number
    side: int  # whose profiles cannot be used: 0 left, 1 right; the rest says why
    reached: float  # where the inner side of the rail ends [m]
    depth: float  # how deep the gauge is measured, in the same frame [m]
    width: float  # of the wheel [m]


@record
class Pair:
    """A wheel over its rail, both as those of a right side."""

    tables: To("Tables")  # which it is in
    radius: float  # nominal radius of the wheel [m]
    wheel: To(Profile)
    wheel_curvature: To(CurvatureTable)
    rail_y: float  # track coordinate of the rail's highest point [m]
    rail: To(Profile)
    rail_curvature: To(CurvatureTable)
    rail_arc: To(CubicTable)  # arc length of the rail from its start [m] over its abscissa
    rail_at_arc: To(CubicTable)  # and the abscissa over the arc length
    scan: To(Scan)  # raster over both
    sections: To(
        Sections
    )  # of a rail whose section changes along the track, beside which ``rail`` does not count
    changing: bool  # whether it does
    deviation: To(
        Sections
    )  # of a wheel that is not round: how much larger its radius is, over angles and abscissae
    out_of_round: bool  # whether it is one
    roller: float  # radius of the roller that stands for the rail [m]; 0 for a rail


@record
class Tables:
    array = "tables"
    pairs: Pair * 2  # left and right side
    height: float  # of the wheelset's centre, the mean of both nominal radii [m]
    arm: float  # half the distance of the running circles [m]
    springs: Spring * 2  # below both rails
    sprung: bool  # whether there are any
    contact_modulus: float  # E* [Pa]
    lateral_limit: float  # largest |lateral shift| [m]
    yaw_limit: float  # largest |yaw| [rad]
    hertz: To(HertzTable)
    normal_model: int  # one of MODEL_...
    longitudinal: int  # one of LONGITUDINAL_...
    penetration: Float * 2  # prescribed, left and right [m]; not a number: the force is prescribed
    nodes: int  # nodes per half-width of the interpenetration, a multiple of five
    stride: int  # every so many of them are traced on the profiles
    waves: To(Waves)  # what the strips of a run have from their number alone
    sweeps: int  # how often their half-lengths and edges are corrected
    influence: To(InfluenceTable)  # how they displace the half-space beside them
    starts: To(Starts)
    sides: int  # which sides are wanted, one of SIDES_...
    alone: bool  # whether the wheel that is wanted is one by itself, on no wheelset
    depth: int  # what is wanted of them, one of DEPTH_...
    absent: float  # what stands in outputs that are not wanted: not a number
    stations: int  # stations of an outline; where it then lies is told in outline.py
    separation: int  # one of SEPARATION_...
    lateral: int  # one of LATERAL_...
    mode: int  # one of MODE_...
    load: int  # one of LOAD_...
    tangential: int  # one of TANGENTIAL_...
    wear: bool  # whether outputs of wear follow the others
    fatigue: bool  # whether those of fatigue are computed
    error: bool  # whether ANALYN estimates its error
    shear_modulus: float  # G of wheel and rail [Pa]
    rolling: To(RollingTable)  # what the models of creep forces read; 0 where none is chosen
    parameters: Parameters  # all of the setup's
    valley: To(ValleyNodes)  # of the changing rail at work, for LONGITUDINAL_CHANGING
    valley_first: int  # and the numbers of its first and last node
    valley_last: int


@record
class Contact:
    """The contact of one wheel while it is solved, from its frame to the strips of its normal model."""

    filling: bool  # whether patches are filled in, or only the penetration is wanted
    coarse: bool  # whether an approximate penetration is enough
    following: bool  # whether deepest points may be followed from the trial before
    frame: Frame
    first_widths: FirstWidths
    regions: Regions
    nodes: NodesOfRegions
    strips: SolvedStrips
    strip_problem: StripProblem
    equations: Equations
    origin: Origin
    frames: KeptFrames
    overlap: Overlap
    deep_points: DeepPoints * 2  # of the left and right wheel, as the last search has left them
    changing: DeepPoints  # of a wheel whose regions change between two rolls, none joined
    trial: To(DeepPoints)  # those of the wheel that is pressed


#: What follows the runs of wear in a row: strips of the patches of both sides, and a number that makes rows
#: with outputs of wear as long as no other ones.
WEAR_STRIPS: Final[int] = PATCH_LIMIT * size(StripOutputs)
WEAR_END: Final[int] = 2 * WEAR_STRIPS + 1


@record
class Work:
    array = "work"
    inputs: Inputs
    known: bool  # whether the outputs are those of the inputs, and with which status
    status: int
    outputs: Outputs
    outlines: Outline * 2  # with another number of stations than STATION_COUNT
    wear_runs: WearRuns * 2  # room for what follows with wear_outputs, where stations leave off
    wear_strips: StripOutputs * (2 * PATCH_LIMIT)
    wear_end: float
    sides: Sides
    contact: Contact
    supports: Supports
    displaced: Inputs  # those of a wheelset that has moved on
    broyden: Broyden
    height_bracket: Bracket
    roll_bracket: Bracket
    jump: Jump
    trials: RollTrials
    reference: Reference
    equilibrium: RailEquilibrium
    settled: BalancedRail * 2
    wheelset: Wheelset
    turning: Turning
    rolling: Rolling
    patch: Patch  # a patch by itself, apart from a step
    section_search: SectionSearch
    touches: SectionTouches
    leaning: LeaningPatches  # places of contact on rails whose section changes


INPUT_COUNT: Final[int] = size(Inputs)
OUTPUT_COUNT: Final[int] = size(Outputs)
WORK_SIZE: Final[int] = size(Work)
STATE_SIZE: Final[int] = size(State)
SETTING_COUNT: Final[int] = size(Tables)
SETUP_SIZE: Final[int] = size(Setup)
ROLLING_TABLE_SIZE: Final[int] = size(RollingTable)
WAVES_SIZE: Final[int] = size(Waves)
STRIP_OUTPUTS_SIZE: Final[int] = size(StripOutputs)
SIDE_SIZE, PATCH_OUTPUTS_SIZE = size(SideOutputs), size(PatchOutputs)
OUT_RIGHT = Outputs.left.offset // WIDTH + SIDE_SIZE

# where inputs and outputs are, for what reads their arrays by index: IN_YAW, OUT_ROLL, SIDE_AREA
for _prefix, _kind in (("IN", Inputs), ("OUT", Outputs), ("SIDE", SideOutputs)):
    globals().update(
        {f"{_prefix}_{name.upper()}": getattr(_kind, name).offset // WIDTH for name, _ in _kind._fields_}
    )
