"""The tables of the constant rail that a changing one is at a pose, from its nodes: pieces, arc lengths, and what bounds
them, as prepare/ writes them."""

from typing import Final

from ..elementary.whole import COUNTED, rounded_up
from ..layout import (
    PIECE_SIZE,
    CubicTable,
    Pair,
    Profile,
    Tables,
    offset,
)
from ..prepare.pieces import BINS_EACH_METRE, FULL, write_quintic, write_stops
from ..prepare.scan import FINE_STEP
from ..prepare.scan_bends import write_joints, write_waves
from .arcs_at_pose import write_abscissae_at_pose, write_arcs_at_pose
from .bounds_at_pose import write_bounds_at_pose

#: Cells of bounds of the rail that have room (sections/kernel_table.py).
CELL_LIMIT: Final[int] = 400


def write_rail_at_pose(tables: Tables, pair: Pair) -> bool:
    """Write the rail through the nodes of the pair, and let the pair have it; whether there is room for it."""
    sections = pair.sections
    room = sections.room
    end = write_pieces(tables, pair, room)
    if end == FULL:
        return False
    pair.rail_arc = CubicTable.at(tables, end)
    total, end = write_arcs_at_pose(tables, pair, end)
    if end == FULL:
        return False
    pair.rail_at_arc = CubicTable.at(tables, end)
    end = write_abscissae_at_pose(tables, pair, end, total)
    if end == FULL:
        return False
    scan = pair.scan
    cells = rounded_up((pair.rail.stop - pair.rail.start) / FINE_STEP)
    if cells > CELL_LIMIT:
        return False
    scan.rail_count = cells
    scan.rail_start = pair.rail.start
    write_bounds_at_pose(tables, pair, scan)
    if write_joints(tables, pair, scan, end) == FULL:
        return False
    write_waves(tables, pair, scan)
    tables.valley = offset(sections.nodes, tables)
    tables.valley_first = sections.first
    tables.valley_last = sections.last
    pair.rail_y = 0.0
    return True


def write_pieces(tables: Tables, pair: Pair, base: int):
    """The profile through the nodes at ``base``; the offset after it, or FULL."""
    sections = pair.sections
    start = sections.nodes[sections.first].y
    stop = sections.nodes[sections.last].y
    bins = rounded_up((stop - start) * BINS_EACH_METRE)
    profile = Profile.at(tables, base)
    first = offset(profile.bins, tables) + bins
    end = first + PIECE_SIZE * (sections.last - sections.first)
    if end + PIECE_SIZE > tables.raw.shape[0]:
        return FULL
    at = first
    for line in range(sections.first, sections.last):
        low = sections.nodes[line]
        high = sections.nodes[line + 1]
        write_quintic(
            tables.raw,
            at,
            low.y,
            high.y,
            low.z,
            low.slope,
            low.behind,
            high.z,
            high.slope,
            high.before,
        )
        at += PIECE_SIZE
    profile.start = start
    profile.stop = stop
    profile.bins_per_metre = BINS_EACH_METRE
    profile.bin_count = float(bins)
    profile.pieces = first - base
    piece = first
    for i in range(bins):
        left = start + float(i) / BINS_EACH_METRE
        while piece + PIECE_SIZE < end and tables.raw[piece + PIECE_SIZE] <= left:
            piece += PIECE_SIZE
        profile.bins[i] = COUNTED + float(piece - base)
    for k in range(PIECE_SIZE):
        tables.raw[end + k] = tables.absent
    write_stops(tables.raw, first, end)
    pair.rail = Profile.at(tables, base)
    return end + PIECE_SIZE
