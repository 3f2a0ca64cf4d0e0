"""The table of a rail whose section changes, as the kernel reads it (kernel/layout/sections.py).

Bounds of slopes and second derivatives are found from samples of the surface, closer together than its lines, in each
cell and around it, and are widened by a share of their range. tests/sections/test_bounds.py compares them with other
samples.
"""

from weakref import WeakKeyDictionary

import numpy as np

from ..kernel import layout
from ..kernel.changing.rail_at_pose import CELL_LIMIT
from ..kernel.prepare.curvatures import ARC_STEP
from ..kernel.prepare.pieces import BINS_EACH_METRE
from .surface import BEFORE, BEHIND, HEIGHT, PLACE, SLOPE

#: Longest cell along the track [m], and most cells between two breaks.
ALONG, MOST_ALONG = 5e-3, 16
#: Cells across the track [m], and how far they go beyond the ends of sections.
ACROSS, MARGIN = 5e-4, 5e-3
#: Cells across a wheel [m]; and so many of its samples are taken at a time.
WHEEL_ACROSS, MANY = 1e-2, 200_000
#: Samples along a cell, and where they are across between two lines of the surface.
SAMPLES_ALONG, SHARES = 7, np.linspace(0.0, 1.0, 5)
#: Shares of their ranges by which bounds are widened, and the least of it: of slopes [-], second derivatives [1/m], and the
#: x component of the normal [-].
WIDENED = np.array([0.05, 0.05, 0.15, 0.15, 0.15, 0.05])
LEAST = np.array([1e-6, 1e-6, 1e-2, 1e-2, 1e-2, 1e-6])
#: The highest place may lie this much higher than the highest sample [m].
HIGHER = 1e-5
#: The rail of a pose may be this much longer than its section is wide.
LONGEST_ARC = 4.0
#: Tables of the surfaces that are in use: several wheelsets may run on one.
_TABLES = WeakKeyDictionary()
#: Numbers of the head of a table.
HEAD, KNOT, CELL = (
    layout.size(layout.Sections),
    layout.size(layout.SectionKnot),
    layout.size(layout.SectionCell),
)


def with_sections(tables, index, surface, lateral):
    """The kernel's ``tables`` (n,) with a changing rail on side ``index``, 0 left and 1 right: its ``surface``, whose
    origin has the track coordinate ``lateral`` [m] as that of a right side."""
    joined = np.concatenate([tables, _kept(surface)])
    pair = layout.Tables.at(joined).pairs[index]
    pair.sections = len(tables) - layout.offset(pair, joined)
    pair.changing = True
    pair.rail_y = lateral
    return joined


def _kept(surface, wheel=False):
    """The table of ``surface``, that of a rail or of what a ``wheel`` deviates by, which is made once."""
    table = _TABLES.get(surface)
    if table is None:
        table = _TABLES[surface] = section_table(surface, wheel)
    return table


def with_deviation(tables, index, surface):
    """The kernel's ``tables`` (n,) with a wheel on side ``index`` that deviates from a round one by ``surface``, over angles and
    abscissae."""
    table = _kept(surface, wheel=True)
    joined = np.concatenate([tables, table])
    pair = layout.Tables.at(joined).pairs[index]
    pair.deviation = len(tables) - layout.offset(pair, joined)
    pair.out_of_round = True
    return joined


def with_changing_rails(tables, rails):
    """The kernel's ``tables`` (n,), prepared with any rails, for steps on ``rails``: (surface, lateral) of the left and the
    right side, as for :func:`with_sections`; with room for the constant rails that these are at a pose (kernel/changing)."""
    for index, (surface, lateral) in enumerate(rails):
        tables = with_room(with_sections(tables, index, surface, lateral), index, lateral)
    layout.Tables.at(tables).longitudinal = layout.LONGITUDINAL_CHANGING
    return tables


def with_room(tables, index, lateral):
    """The ``tables`` (n,) with a raster of the wheel, nodes, and room for the rail of a pose of side ``index``."""
    pair = layout.Tables.at(tables).pairs[index]
    sections, scan = pair.sections, pair.scan
    lines, wheel = sections.knot_count, scan.count
    width = sections.across_stop - sections.across_start
    first = layout.offset(scan, tables)
    nodes_at = layout.offset(scan.nodes, tables) - first
    raster = tables[first : first + nodes_at + layout.SCAN_NODE_SIZE * wheel]
    bins = np.array(scan.bins[: scan.bin_count])
    cells = np.zeros(layout.RAIL_CELL_SIZE * CELL_LIMIT)
    nodes = np.zeros(lines * layout.size(layout.ValleyNode))
    scratch = np.zeros(100 + 3 * lines)
    arcs = 2 * (16 + layout.CUBIC_SIZE * int(LONGEST_ARC * width / ARC_STEP))
    room = np.zeros(
        layout.PROFILE_HEAD + int(BINS_EACH_METRE * 2.0 * width) + layout.PIECE_SIZE * (lines + 2)
        + arcs + layout.RAIL_JOINT_SIZE * (lines + 2)
    )  # fmt: skip
    parts = [tables, raster, cells, bins, nodes, scratch, room]
    places = np.cumsum([0, *map(len, parts)])
    joined = np.concatenate(parts)
    pair = layout.Tables.at(joined).pairs[index]
    own = layout.Scan.at(joined, int(places[1]))
    own.rail, own.bins = int(places[2] - places[1]), int(places[3] - places[1])
    pair.scan = int(places[1]) - layout.offset(pair, joined)
    sections = pair.sections
    sections.lateral, sections.room, sections.scratch = lateral, int(places[6]), int(places[5])
    sections.nodes = int(places[4]) - layout.offset(sections, joined)
    return joined


def section_table(surface, wheel=False):
    """The table (n,) of a :class:`~wrcontact.sections.surface.Surface`, that of a rail or of what a ``wheel`` deviates by, which
    has no arc lengths."""
    across = WHEEL_ACROSS if wheel else ACROSS
    along, start, cells, top = bounds_of(surface, across, _column_cells if wheel else _row_cells)
    levels = np.stack(leveled(cells))
    intervals, _, knots, _ = surface.cubics.shape
    order = [PLACE, HEIGHT, SLOPE, BEFORE, BEHIND]
    cubics = np.moveaxis(surface.cubics, 1, -1)[:, :, order]  # (interval, knot, quantity, power)
    arcs = np.array([] if wheel else [surface.arcs(u) for u in surface.breaks])
    parts = [surface.breaks, cubics.ravel(), along, levels.ravel(), arcs.ravel()]
    places = HEAD + np.cumsum([0, *map(len, parts)])
    table = np.concatenate([np.zeros(HEAD), *parts])
    head = layout.Sections.at(table)
    head.interval_count, head.knot_count = intervals, knots
    head.breaks, head.knots, head.along, head.cells, head.arcs = (int(place) for place in places[:5])
    head.along_count, head.across_count = len(along) - 1, cells.shape[1]
    head.across_start, head.across_stop = start, start + cells.shape[1] * across
    head.across_per_metre = 1.0 / across
    head.top, head.least_lean, head.most_lean = top, cells[..., 10].min(), cells[..., 11].max()
    return table


def _row_cells(surface, u, start, count, across):
    """Least and most of what is bounded, each (n, count, CELL / 2), in rows of cells, from samples at positions ``u`` (n, k), and
    the smallest height."""
    found = [_sampled(surface, row, start, count, across) for row in u]
    least, most, highest = zip(*found)
    return np.stack(least), np.stack(most), min(highest)


def _column_cells(surface, u, start, count, across):
    """As :func:`_row_cells`, of a surface whose lines keep their places: many rows at a time."""
    places = surface.cubics[0, 0, :, PLACE]
    between = (places[:-1, None] + np.diff(places)[:, None] * SHARES[:-1]).ravel()
    y = np.concatenate([[start], between, places[-1:], [start + count * across]])
    edges = start + across * np.arange(count + 1)
    first = np.maximum(np.searchsorted(y, edges[:-1], side="right") - 1, 0)
    last = np.minimum(np.searchsorted(y, edges[1:], side="left"), len(y) - 1)
    least, most = np.empty((2, len(u), count, CELL // 2))
    highest, step = np.inf, max(1, MANY // (u.shape[1] * len(y)))
    for row in range(0, len(u), step):
        jet = surface.jet(u[row : row + step, :, None], y)
        values = np.stack(
            [jet[1], jet[2], *jet[3:6], -jet[1] / np.sqrt(1.0 + jet[1] ** 2 + jet[2] ** 2)], axis=-1
        )
        low, high = values.min(axis=1), values.max(axis=1)
        for cell, (a, b) in enumerate(zip(first, last)):
            least[row : row + step, cell] = low[:, a : b + 1].min(axis=1)
            most[row : row + step, cell] = high[:, a : b + 1].max(axis=1)
        highest = min(highest, jet[0].min())
    return least, most, highest


def bounds_of(surface, across=ACROSS, cells_of=_row_cells):
    """Breaks of cells along the track (a + 1,) and where those across begin [m], the cells (a, b, CELL), and the height of
    the highest place [m]."""
    lengths = np.diff(surface.breaks)
    counts = np.clip(np.ceil(lengths / ALONG - 1e-9), 1, MOST_ALONG).astype(int)
    along = np.concatenate(
        [
            *(
                low + length * np.arange(count) / count
                for low, length, count in zip(surface.breaks, lengths, counts)
            ),
            surface.breaks[-1:],
        ]
    )
    u = along[:-1, None] + np.diff(along)[:, None] * np.linspace(0.0, 1.0, SAMPLES_ALONG)
    first, last = surface.edges(u)
    start = first.min() - MARGIN
    count = int(np.ceil((last.max() + MARGIN - start) / across))
    least, most, top = cells_of(surface, u, start, count, across)
    wider = WIDENED * (most - least) + LEAST
    cells = np.stack([least - wider, most + wider], axis=-1).reshape(len(u), count, CELL)
    return along, start, cells, float(top) - HIGHER


def _sampled(surface, u, start, count, across):
    """Least and most of what is bounded (count, CELL / 2) in a row of cells, from samples at positions ``u`` (n,), and the
    smallest height there.

    A sample counts for every cell between the ones beside it, and for those that its line passes up to the next position.
    """
    least, most = np.full((count, CELL // 2), np.inf), np.full((count, CELL // 2), -np.inf)
    highest, cells = np.inf, np.arange(count)
    for one in u:
        y, jet = surface.samples(one, start, start + count * across, SHARES, across)
        z, z_u, z_y = jet[:3]
        values = np.stack([z_u, z_y, *jet[3:6], -z_u / np.sqrt(1.0 + z_u**2 + z_y**2)], axis=-1)
        drift = np.abs(jet[6]).max() * (u[1] - u[0])
        from_cell = np.floor((np.r_[y[0], y[:-1]] - drift - start) / across)
        to_cell = np.floor((np.r_[y[1:], y[-1]] + drift - start) / across)
        ends = np.column_stack(
            [np.searchsorted(to_cell, cells), np.searchsorted(from_cell, cells, side="right")]
        ).ravel()
        values = np.concatenate([values, values[-1:]])  # for a part that ends with the last one
        least = np.minimum(least, np.minimum.reduceat(values, ends)[::2])
        most = np.maximum(most, np.maximum.reduceat(values, ends)[::2])
        highest = min(highest, z.min())
    return least, most, highest


def leveled(cells):
    """Bounds of single cells, and of LEVEL_RATIO and more of them in a row along the track, as far as there are any."""
    levels, found = [cells], cells
    for _ in range(layout.LEVEL_COUNT - 1):
        step = layout.LEVEL_RATIO ** (len(levels) - 1)
        wider = found.copy()
        for move in range(1, layout.LEVEL_RATIO):
            shifted = found[np.minimum(np.arange(len(found)) + move * step, len(found) - 1)]
            wider[..., 0:12:2] = np.minimum(wider[..., 0:12:2], shifted[..., 0:12:2])
            wider[..., 1:12:2] = np.maximum(wider[..., 1:12:2], shifted[..., 1:12:2])
        levels.append(wider)
        found = wider
    return levels
