"""The search's raster over the wheel, with the bounds that certify it; layout in wrcontact/kernel/search.py."""

import numpy as np

from ..kernel import profile_table
from ..kernel import search as layout
from ..kernel.layout import SCAN_LIMIT
from .compiled import evaluate_table

COARSE_STEP = 1.0e-3  # [m]
FINE_STEP = 0.5e-3    # [m]
#: Where the wheel's second derivative stays below this the coarse step does [1/m]: 20 (1e-3)^2 / 8 = 2.5 um.
STRAIGHT = 20.0
SAMPLES = 33          # of the second derivative in a raster cell


def scan_table(wheel, rail):
    """Scan nodes on the wheel (height, slope, smallest second derivative up to the next node) and the rail's largest
    second derivative around each cell of its raster, from both compiled profile tables.

    Raises
    ------
    ValueError
        when the wheel is wider than the raster.
    """
    wheel_start, wheel_stop = wheel[[profile_table.START, profile_table.STOP]]
    rail_start, rail_stop = rail[[profile_table.START, profile_table.STOP]]
    y = _raster(wheel, wheel_start, wheel_stop)
    if len(y) > SCAN_LIMIT:
        raise ValueError(f"the wheel profile is {wheel_stop - wheel_start:.4g} m wide; permitted are at most "
                         f"{SCAN_LIMIT * FINE_STEP:.4g} m")
    nodes = np.zeros((len(y), layout.SCAN_ROW))
    nodes[:, layout.ROW_Y] = y
    nodes[:, layout.ROW_HEIGHT], nodes[:, layout.ROW_SLOPE], _ = evaluate_table(wheel, y)
    nodes[:-1, layout.ROW_LEAST_BEND], nodes[:-1, layout.ROW_MOST_BEND] = _bend_range(wheel, y[:-1], y[1:])
    rail_count = int(np.ceil((rail_stop - rail_start) / FINE_STEP))
    edges = rail_start + FINE_STEP * np.arange(rail_count)
    # a wheel cell starts in a raster cell and is COARSE_STEP long, a quarter more when yawed
    bounds = np.stack(_bend_range(rail, edges - FINE_STEP, edges + FINE_STEP + 1.5 * COARSE_STEP), axis=1)
    head = np.zeros(layout.SCAN_NODES)
    head[layout.SCAN_COUNT], head[layout.SCAN_RAIL_COUNT] = len(y), rail_count
    head[layout.SCAN_RAIL_START], head[layout.SCAN_RAIL_STEP] = rail_start, FINE_STEP
    head[layout.SCAN_RAIL_OFFSET] = layout.SCAN_NODES + nodes.size
    return np.concatenate([head, nodes.ravel(), bounds.ravel()])


def _raster(wheel, start, stop):
    """Abscissae (n,) of the scan nodes: COARSE_STEP apart where the wheel is nearly straight, else FINE_STEP."""
    count = int((stop - start) / COARSE_STEP)
    edges = start + 0.5 * (stop - start - count * COARSE_STEP) + COARSE_STEP * np.arange(count + 1)
    least, most = _bend_range(wheel, edges[:-1], edges[1:])
    halved = np.maximum(np.abs(least), np.abs(most)) > STRAIGHT
    return np.sort(np.concatenate([edges, edges[:-1][halved] + FINE_STEP]))


def _bend_range(table, low, high):
    """Smallest and largest second derivative (n,) between ``low`` and ``high`` (n,), clipped to the profile."""
    share = np.linspace(0.0, 1.0, SAMPLES)
    y = np.clip(low[:, None] + (high - low)[:, None] * share, table[profile_table.START], table[profile_table.STOP])
    bends = evaluate_table(table, y)[2]
    return bends.min(axis=1), bends.max(axis=1)
