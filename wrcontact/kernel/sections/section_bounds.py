"""Bounds of the surface's slopes and second derivatives over a part of it, from the table of cells.

A row of cells across the track begins every few millimetres along it. The table has the bounds of single cells and
of LEVEL_RATIO and LEVEL_RATIO^2 cells in a row along the track, so that a long part is covered by few of them.
"""

from math import inf

from ..layout import LEVEL_COUNT, LEVEL_RATIO, SectionBounds, SectionCell, Sections
from .section_surface import break_below


def across_cell(sections: Sections, y: float):
    """The cell across the track that holds ``y`` [m], or the nearest."""
    place = min(
        max(0.0, (y - sections.across_start) * sections.across_per_metre), float(sections.across_count - 1)
    )
    return int(place)


def empty(found: SectionBounds):
    """Make bounds those of nothing."""
    found.least_along = inf
    found.most_along = -inf
    found.least_across = inf
    found.most_across = -inf
    found.least_bend_along = inf
    found.most_bend_along = -inf
    found.least_twist = inf
    found.most_twist = -inf
    found.least_bend_across = inf
    found.most_bend_across = -inf
    found.least_lean = inf
    found.most_lean = -inf


def widen(found: SectionBounds, cell: SectionCell):
    """Let bounds hold for a cell, too."""
    found.least_along = min(found.least_along, cell.least_along)
    found.most_along = max(found.most_along, cell.most_along)
    found.least_across = min(found.least_across, cell.least_across)
    found.most_across = max(found.most_across, cell.most_across)
    found.least_bend_along = min(found.least_bend_along, cell.least_bend_along)
    found.most_bend_along = max(found.most_bend_along, cell.most_bend_along)
    found.least_twist = min(found.least_twist, cell.least_twist)
    found.most_twist = max(found.most_twist, cell.most_twist)
    found.least_bend_across = min(found.least_bend_across, cell.least_bend_across)
    found.most_bend_across = max(found.most_bend_across, cell.most_bend_across)
    found.least_lean = min(found.least_lean, cell.least_lean)
    found.most_lean = max(found.most_lean, cell.most_lean)


def section_bounds(
    sections: Sections, found: SectionBounds, u_low: float, u_high: float, y_low: float, y_high: float
):
    """Write the bounds over ``u_low`` ... ``u_high``, ``y_low`` ... ``y_high`` [m] to ``found``.

    Beyond both ends along the track the surface is that of its ends; beside the cells across the track the bounds are
    those of the last ones.
    """
    first = break_below(sections.along, sections.along_count, u_low)
    last = break_below(sections.along, sections.along_count, u_high)
    low = across_cell(sections, y_low)
    high = across_cell(sections, y_high)
    width = 1
    level = 0
    while level + 1 < LEVEL_COUNT and width * LEVEL_RATIO <= last - first + 1:
        width *= LEVEL_RATIO
        level += 1
    base = level * sections.along_count
    empty(found)
    row = first
    covered = False
    while not covered:
        # the last row ends with the last cell
        if row + width > last:
            row = last + 1 - width
            covered = True
        at = (base + row) * sections.across_count
        for column in range(low, high + 1):
            widen(found, sections.cells[at + column])
        row += width
