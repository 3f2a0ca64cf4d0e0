"""Records of the room normal: numbers at the nodes and strips of regions."""

from typing import Final

from .contact import REGION_LIMIT
from .record import centred, record

NODE_FIELDS: Final[int] = 6          # node arrays of each
NODE_LIMIT: Final[int] = 256         # their length
NODE_MIDDLE: Final[int] = 128        # place of node 0 in them
STRIP_FIELDS: Final[int] = 16        # strip arrays
STRIP_LIMIT: Final[int] = 104        # their length

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
