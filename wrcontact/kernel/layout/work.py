"""The array ``work``: the workspace of one step."""

from .contact import DeepPoints, Frame, KeptFrames, Origin, Overlap, Regions
from .interface import Inputs, Outputs
from .normal import Equations, NodesOfRegions, StripProblem
from .patch import Outline, Patch, SolvedStrips
from .record import Float, record
from .search import RollTrials, Sides
from .tangential import Rolling
from .wheelset import Bracket, Broyden, Reference, Supports, Wheelset


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
