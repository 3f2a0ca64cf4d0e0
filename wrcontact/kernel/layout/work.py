"""The array ``work``: the workspace of one step."""

from .contact import CONTACT_BLOCK, OVERLAP_BLOCK, REGION_LIMIT, Frame, Origin, Regions
from .interface import Inputs, Outputs
from .normal import Equations, NodesOfRegions, StripProblem
from .patch import Outline, SolvedPatches
from .record import Float, record
from .search import ROLLS_BLOCK, SideSearch
from .surface import Place
from .wheelset import Support


@record
class Work:
    array = "work"
    inputs: Inputs
    known: float
    status: float
    outputs: Outputs
    outlines: Outline * 2           # with another number of stations than STATION_COUNT; one right after the other
    places: Place * 2
    sides: SideSearch * 2
    frame: Frame
    regions: Regions
    nodes: NodesOfRegions
    solved: SolvedPatches
    strip_problem: StripProblem
    equations: Equations
    origin: Origin
    frames: Float * (CONTACT_BLOCK * (REGION_LIMIT + 1))
    overlap: Float * OVERLAP_BLOCK
    supports: Support * 2
    rolls: Float * ROLLS_BLOCK
