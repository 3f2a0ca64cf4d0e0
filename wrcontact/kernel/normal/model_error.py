"""An estimate of ANALYN's error in the peak pressure, from the nodes that it has anyway.

ANALYN is exact where A and B are constant; its strips know nothing of each other.  What it misses comes with
lateral curvatures that change within the patch.  With the windowed curvature B_k at node k, and w nodes the
window of it, the change that a straight line through both sides does not explain is

    c_k = |B_(k-w) - 2 B_k + B_(k+w)| / (B_(k-w) + 2 B_k + B_(k+w)),    0 <= c_k <= 1           (E1)

and with its mean over the load, q the line loads of all regions,

    error = LEAST + RATE sum q_k c_k / sum q_k                                                  (E2)

Chosen against the half-space on two thirds of 1800 wheels at random poses, new, worn and measured profiles
(docs/theory/analyn.md says how far it holds on the last third).
"""

from math import fabs
from typing import Final

from ..layout import Nodes, NodesOfRegions, Region, Regions, Tables, seldom
from .nodes import window_nodes

#: LEAST and RATE of eq. (E2).
LEAST: Final[float] = 0.0025
RATE: Final[float] = 0.23
#: What strips miss where ANALYN misses one.
STRIPS_MISS: Final[float] = 0.28


@seldom
def analyn_error(tables: Tables, regions: Regions, nodes: NodesOfRegions, count: int):
    """Estimate of ANALYN's error in the peak pressure [-], once its regions carry their load; eq. (E2)."""
    window = window_nodes(tables)
    load = 0.0
    changes = 0.0
    for index in range(count):
        region = regions[index]
        if region.local_penetration > 0.0:
            own, change = curvature_change(region, nodes[index], window)
            load += own * region.spacing
            changes += change * region.spacing
    error = 0.0
    if load > 0.0:
        error = LEAST + RATE * changes / load
    return error


@seldom
def curvature_change(region: Region, nodes: Nodes, window: int):
    """Sums of q and of q c over the nodes of a region [N/m]; eq. (E1).  Beyond the first and the last node B
    is that of the end."""
    load = 0.0
    changes = 0.0
    for k in range(region.first, region.last + 1):
        d = region.local_penetration - nodes.rise[k]
        if d > 0.0:
            low = nodes.B[max(k - window, region.first)]
            high = nodes.B[min(k + window, region.last)]
            twice = 2.0 * nodes.B[k]
            own = nodes.line[k] * d
            load += own
            changes += own * fabs(low - twice + high) / (low + twice + high)
    return load, changes
