"""The search's raster over the wheel, with the bounds that certify it; layout in wrcontact/kernel/search.py."""

import numpy as np

from ..kernel import profile_table
from ..kernel import search as layout
from ..kernel.layout import SCAN_LIMIT
from .compiled import evaluate_table

SCAN_STEP = 0.5e-3  # [m]
SAMPLES = 33        # of the second derivative in a raster cell


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
    count = int((wheel_stop - wheel_start) / SCAN_STEP)
    if count > SCAN_LIMIT:
        raise ValueError(f"the wheel profile is {wheel_stop - wheel_start:.4g} m wide; permitted are at most "
                         f"{SCAN_LIMIT * SCAN_STEP:.4g} m")
    start = wheel_start + 0.5 * (wheel_stop - wheel_start - (count - 1) * SCAN_STEP)
    y = start + SCAN_STEP * np.arange(count)
    nodes = np.zeros((count, layout.SCAN_ROW))
    nodes[:, 0], nodes[:, 1], _ = evaluate_table(wheel, y)
    nodes[:-1, 2] = _extreme_bends(wheel, y[:-1], y[1:], np.min)
    rail_count = int(np.ceil((rail_stop - rail_start) / SCAN_STEP))
    edges = rail_start + SCAN_STEP * np.arange(rail_count)
    bends = _extreme_bends(rail, edges - SCAN_STEP, edges + 3 * SCAN_STEP, np.max)
    head = np.zeros(layout.SCAN_NODES)
    head[layout.SCAN_COUNT], head[layout.SCAN_START], head[layout.SCAN_STEP] = count, start, SCAN_STEP
    head[layout.SCAN_RAIL_COUNT], head[layout.SCAN_RAIL_START] = rail_count, rail_start
    head[layout.SCAN_RAIL_STEP] = SCAN_STEP
    head[layout.SCAN_RAIL_OFFSET] = layout.SCAN_NODES + nodes.size
    return np.concatenate([head, nodes.ravel(), bends])


def _extreme_bends(table, low, high, extreme):
    """``extreme`` of the second derivative between each pair of ``low`` and ``high``, both clipped to the profile."""
    share = np.linspace(0.0, 1.0, SAMPLES)
    y = np.clip(low[:, None] + (high - low)[:, None] * share, table[profile_table.START], table[profile_table.STOP])
    return extreme(evaluate_table(table, y)[2], axis=1)
