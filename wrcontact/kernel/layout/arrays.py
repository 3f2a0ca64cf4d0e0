"""The arrays as wholes, their sizes, and the records of the room wheelset.

``setup``    from which the tables are prepared.
``tables``   what is fixed during a simulation: settings at the head, then the tables that they point to.
             Each side has its tables; where both sides are equal they are one array.  Settings of the whole
             wheelset are read from those of the right side, as are the starts.
``work``     the workspace of one step.
``state``    what one step leaves for the next.
"""

from typing import Final

from .contact import (CubicTable, CurvatureTable, DeepPoints, Frame, KeptFrames, Origin, Overlap, Profile,
                      Regions)
from .creep import Rolling, RollingTable
from .interface import Inputs, Outputs, Parameters, PatchOutputs, Resolution, SideOutputs
from .patch import (Equations, Forces, HertzTable, InfluenceTable, NodesOfRegions, Outline, Patch,
                    SolvedStrips, StripProblem)
from .record import Float, To, record, size
from .search import RollTrials, Scan, Sides, Starts


@record
class Wheelset:
    """Where the wheelset stands, and the forces on it."""

    roll: float                     # [rad]
    vertical_shift: float           # [m]
    forces: Forces


@record
class Support:
    """How a side carries its load."""

    approach: float                 # how far the wheel is estimated to come down below its smallest gap [m]
    height: float                   # the vertical shift at which it carries its load [m]
    lever: float                    # how that follows the roll [m]
    friction_load: float            # what its normal forces are to carry, over the load of the inputs [-]
    load_before: float              # the one before [-],
    share_before: float             # and what share of the wanted force it has given [-]


#: Of the left and right side.
Supports = Support * 2


@record
class Broyden:
    """Broyden's method for the height and roll of an elastic wheelset; rolls count in
    metres at the wheels."""

    left: float                     # residuals: how much lower each side carries its load [m]
    right: float
    left_height: float              # their derivatives with respect to height and roll [-]
    left_roll: float
    right_height: float
    right_roll: float
    move_height: float              # the last move [m]
    move_roll: float


@record
class Bracket:
    """Two places between which a value changes its sign."""

    low: float                      # height [m] or roll [rad]
    high: float
    at_low: float                   # the value there [m]
    at_high: float


@record
class Reference:
    """The vertical shift for which wheels are placed over rolled rails, while it is sought."""

    height: float                   # the last one [m]
    residual: float                 # how much lower the contact was found [m]
    slope: float                    # how that follows the height [-]
    contacts: float                 # how many were found
    within: Bracket                 # heights below and above the one that is sought, and their residuals


@record
class State:
    """What one step leaves for the next; the head of its array."""

    array = "state"
    roll: float                     # last valid roll [rad]
    warm: bool                      # whether there is one
    y_left: float                   # wheel abscissae of the last contacts [m]
    y_right: float
    shift: float                    # and the lateral shift [m]


@record
class Setup:
    array = "setup"
    parameters: Parameters
    resolution: Resolution
    height: float                   # of the wheelset's centre, the mean of both nominal radii [m]
    absent: float                   # not a number


@record
class Tables:
    array = "tables"
    radius: float                   # nominal radius [m]
    height: float                   # of the wheelset's centre, the mean of both nominal radii [m]
    arm: float                      # half the distance of the running circles [m]
    rail_y: float                   # track coordinate of the right rail's highest point [m]
    contact_modulus: float          # E* [Pa]
    lateral_limit: float            # largest |lateral shift| [m]
    yaw_limit: float                # largest |yaw| [rad]
    wheel: To(Profile)
    rail: To(Profile)
    scan: To(Scan)
    hertz: To(HertzTable)
    normal_model: int               # one of MODEL_...
    longitudinal: int               # one of LONGITUDINAL_...
    penetration: Float * 2          # prescribed, left and right [m]; not a number: the force is prescribed
    nodes: int                      # nodes per half-width of the interpenetration, a multiple of five
    stride: int                     # every so many of them are traced on the profiles
    strips: int                     # strips of the strip model that are asked for
    sweeps: int                     # and how often it is made
    influence: To(InfluenceTable)   # how its strips displace the half-space beside them
    starts: To(Starts)
    sides: int                      # which sides are wanted, one of SIDES_...
    depth: int                      # what is wanted of them, one of DEPTH_...
    absent: float                   # what stands in outputs that are not wanted: not a number
    stations: int                   # stations of an outline; where it then lies is told in outline.py
    separation: int                 # one of SEPARATION_...
    lateral: int                    # one of LATERAL_...
    wheel_curvature: To(CurvatureTable)
    rail_curvature: To(CurvatureTable)
    rail_arc: To(CubicTable)        # arc length of the rail from its start [m] over its abscissa
    rail_at_arc: To(CubicTable)     # and the abscissa over the arc length
    mode: int                       # one of MODE_...
    load: int                       # one of LOAD_...
    tangential: int                 # one of TANGENTIAL_...
    shear_modulus: float            # G of wheel and rail [Pa]
    rolling: To(RollingTable)       # what the models of creep forces read; 0 where none is chosen
    parameters: Parameters          # all of the setup's


@record
class Contact:
    """The contact of one wheel while it is solved, from its frame to the strips of its normal model."""

    filling: bool                   # whether patches are filled in, or only the penetration is wanted
    coarse: bool                    # whether an approximate penetration is enough
    following: bool                 # whether deepest points may be followed from the trial before
    frame: Frame
    regions: Regions
    nodes: NodesOfRegions
    strips: SolvedStrips
    strip_problem: StripProblem
    equations: Equations
    origin: Origin
    frames: KeptFrames
    overlap: Overlap
    deep_points: DeepPoints * 2     # of the left and right wheel, as the last search has left them


@record
class Work:
    array = "work"
    inputs: Inputs
    known: bool                     # whether the outputs are those of the inputs, and with which status
    status: int
    outputs: Outputs
    outlines: Outline * 2           # with another number of stations than STATION_COUNT
    sides: Sides
    contact: Contact
    supports: Supports
    broyden: Broyden
    height_bracket: Bracket
    roll_bracket: Bracket
    trials: RollTrials
    reference: Reference
    wheelset: Wheelset
    rolling: Rolling
    patch: Patch                    # a patch by itself, apart from a step


INPUT_COUNT: Final[int] = size(Inputs)
OUTPUT_COUNT: Final[int] = size(Outputs)
WORK_SIZE: Final[int] = size(Work)
STATE_SIZE: Final[int] = size(State)
SETTING_COUNT: Final[int] = size(Tables)
SETUP_SIZE: Final[int] = size(Setup)
PARAMETERS_SIZE: Final[int] = size(Parameters)
ROLLING_TABLE_SIZE: Final[int] = size(RollingTable)


def _offsets(prefix, kind):
    """{constant: place} of the fields of a record class, for what reads the arrays by index."""
    return {f"{prefix}_{name.lstrip('_').upper()}": getattr(kind, name).offset // 8
            for name, _ in kind._fields_}


globals().update(_offsets("IN", Inputs))
globals().update(_offsets("OUT", Outputs))
globals().update(_offsets("SIDE", SideOutputs))
globals().update(_offsets("PATCH_OUTPUTS", PatchOutputs))
globals().update(_offsets("SET", Tables))
globals().update(_offsets("SETUP", Setup))
globals().update(_offsets("PARAMETERS", Parameters))
globals().update(_offsets("STATE", State))
globals().update(_offsets("WORK", Work))
OUT_RIGHT = OUT_LEFT + size(SideOutputs)  # noqa: F821
SIDE_SIZE, PATCH_OUTPUTS_SIZE = size(SideOutputs), size(PatchOutputs)
SET_PENETRATION_LEFT, SET_PENETRATION_RIGHT = SET_PENETRATION, SET_PENETRATION + 1  # noqa: F821
