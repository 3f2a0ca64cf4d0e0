"""From a definition to the table of quintic pieces, the record Profile.

Each piece has the height, slope and second derivative of the exact definition at both ends. Joints of zones
are ends of pieces, so a jump of the curvature stays where the standard has it. Where the printed coefficients
leave a step in height (S1002: 3.7e-5 mm at y = -26 mm and 1.2e-4 mm at y = -35 mm), both sides are led to
their mean over REPAIR_WIDTH. Otherwise the contact would stay at an edge that no real wheel has.

Where the angle of two zones differs is a corner. It is rounded by one piece: the search for contacts, and
every model of them, needs a curvature.
"""

from math import fabs, sqrt
from typing import Final

from ..elementary.circle import atan
from ..elementary.whole import COUNTED, rounded_up
from ..layout import PIECE_SIZE, Profile, offset
from .zones import DEFINITION_COUNT, DEFINITION_ROW, DEFINITION_ZONES, ZONE_START, ZONE_STOP, zone_jet

#: Permitted height error of a piece between its ends [mm]; it is small against the 1e-9 rad
#: required of the roll.
PIECE_ERROR: Final[float] = 1e-9
#: Permitted error of the second derivative between the ends [1/mm]; 1e-6 of a curvature of 1/10 mm.
PIECE_BEND_ERROR: Final[float] = 1e-7
LONGEST_PIECE: Final[float] = 1.0  # [mm]
SHORTEST_PIECE: Final[float] = 1e-3  # [mm]; measured profiles have knots this close
#: Distance from a joint over which a height step of the published coefficients is smoothed [mm]. On UIC60
#: 1:40 the step at y = -35 mm would hold the contact for 1 um of lateral shift. Half a millimetre changes the
#: curvature by at most 2 %.
REPAIR_WIDTH: Final[float] = 0.5
REPAIRED_STEP: Final[float] = 1e-6  # [mm]; smaller height steps are not repaired
#: Where the direction changes by more than this is a corner [rad]; where the height steps, too, by more than
#: STEPPED_CORNER (the steps of S1002 come with 8e-6).
LEAST_CORNER: Final[float] = 1e-8
STEPPED_CORNER: Final[float] = 1e-5
#: A corner is rounded by about this radius, but over no less than the width on either side, and over no more
#: than a quarter of either zone [mm].
CORNER_RADIUS: Final[float] = 1.0
CORNER_WIDTH: Final[float] = 0.05
#: Width of the bins of pieces [mm], so fine that few hold two: mispredicted branches cost more than bins.
BIN_WIDTH: Final[float] = 0.03125
BINS_EACH_METRE: Final[float] = 32000.0
MM: Final[float] = 1e-3
#: mm ** (1 - k) for the coefficients k = 2 ... 5, as computed from 1e-3.
SCALE_2: Final[float] = 1000.0
SCALE_3: Final[float] = 1000000.0
SCALE_4: Final[float] = 999999999.9999999
SCALE_5: Final[float] = 999999999999.9999
#: Between the ends of a piece its error is seen at this many even parts.
SEEN_PARTS: Final[int] = 10
HALVINGS: Final[int] = 24
FULL: Final[int] = -1  # in place of an offset: the tables are full


def write_quintic(
    tables: "float[:]",
    at: int,
    low: float,
    high: float,
    z_low: float,
    slope_low: float,
    bend_low: float,
    z_high: float,
    slope_high: float,
    bend_high: float,
):
    """The quintic with given height, slope and second derivative at both ends, into
    the piece at ``at`` [mm].

    Many arguments because the values at both ends come from one zone or are the mean of two.
    """
    h = high - low
    c2 = 0.5 * bend_low
    rest = z_high - (z_low + h * (slope_low + h * c2))
    slope = (slope_high - (slope_low + 2.0 * h * c2)) * h
    bend = (bend_high - 2.0 * c2) * h * h
    cube = h * h * h
    tables[at] = low
    tables[at + 1] = z_low
    tables[at + 2] = slope_low
    tables[at + 3] = c2
    tables[at + 4] = (10.0 * rest - 4.0 * slope + 0.5 * bend) / cube
    tables[at + 5] = (-15.0 * rest + 7.0 * slope - bend) / (cube * h)
    tables[at + 6] = (6.0 * rest - 3.0 * slope + 0.5 * bend) / (cube * h * h)


def follows_zone(tables: "float[:]", at: int, zones: "float[:]", row: int, low: float, high: float) -> bool:
    """Whether the piece at ``at`` follows the zone closely enough between ``low`` and ``high`` [mm]."""
    c0 = tables[at + 1]
    c1 = tables[at + 2]
    c2 = tables[at + 3]
    c3 = tables[at + 4]
    c4 = tables[at + 5]
    c5 = tables[at + 6]
    part = (high - low) / float(SEEN_PARTS)
    good = True
    for i in range(1, SEEN_PARTS):
        y = float(i) * part + low
        u = y - low
        z, slope, bend = zone_jet(zones, row, y)
        height = ((((c5 * u + c4) * u + c3) * u + c2) * u + c1) * u + c0
        own_bend = ((c5 * 20.0 * u + c4 * 12.0) * u + c3 * 6.0) * u + c2 * 2.0
        if not fabs(height - z) <= PIECE_ERROR:
            good = False
        if not fabs(own_bend - bend) / (1.0 + fabs(bend)) <= PIECE_BEND_ERROR:
            good = False
    return good


def write_refined(
    tables: "float[:]",
    at: int,
    zones: "float[:]",
    row: int,
    start: float,
    stop: float,
    work: "float[:]",
    scratch: int,
):
    """Pieces between ``start`` and ``stop`` [mm], halved until they follow the zone; the
    offset after them, or FULL."""
    low = start
    waiting = 1
    work[scratch] = stop
    while waiting > 0:
        high = work[scratch + waiting - 1]
        if at + 2 * PIECE_SIZE > tables.shape[0]:
            return FULL
        z_low, slope_low, bend_low = zone_jet(zones, row, low)
        z_high, slope_high, bend_high = zone_jet(zones, row, high)
        write_quintic(tables, at, low, high, z_low, slope_low, bend_low, z_high, slope_high, bend_high)
        if (
            high - low < 2.0 * SHORTEST_PIECE
            or waiting == HALVINGS
            or follows_zone(tables, at, zones, row, low, high)
        ):
            at += PIECE_SIZE
            low = high
            waiting -= 1
        else:
            work[scratch + waiting] = 0.5 * (low + high)
            waiting += 1
    return at


def height_step(zones: "float[:]", before: int, after: int):
    """How much larger the height of the second of two zones is where it starts [mm]."""
    y = zones[after + ZONE_START]
    z_before, slope, bend = zone_jet(zones, before, y)
    z_after, slope, bend = zone_jet(zones, after, y)
    return z_after - z_before


def steps(zones: "float[:]", before: int, after: int) -> bool:
    """Whether the heights of two zones differ where the second starts."""
    return fabs(height_step(zones, before, after)) > REPAIRED_STEP


def corner_width(zones: "float[:]", before: int, after: int):
    """The width [mm] on either side over which the corner between two zones is rounded; 0 where there is
    none."""
    y = zones[after + ZONE_START]
    z, slope, bend = zone_jet(zones, before, y)
    z, other, bend = zone_jet(zones, after, y)
    turn = fabs(atan(other) - atan(slope))
    width = 0.0
    if turn > LEAST_CORNER and (turn > STEPPED_CORNER or not steps(zones, before, after)):
        steep = min(fabs(slope), fabs(other))
        width = max(0.5 * CORNER_RADIUS * turn / sqrt(1.0 + steep * steep), CORNER_WIDTH)
        width = min(width, 0.25 * (zones[before + ZONE_STOP] - zones[before + ZONE_START]))
        width = min(width, 0.25 * (zones[after + ZONE_STOP] - zones[after + ZONE_START]))
    return width


def write_corner(tables: "float[:]", at: int, zones: "float[:]", before: int, after: int, width: float):
    """The piece that rounds the corner between two zones over ``width`` [mm] on either side, each zone moved
    by half the step in height; the offset after it, or FULL."""
    if at + 2 * PIECE_SIZE > tables.shape[0]:
        return FULL
    half = 0.0
    if steps(zones, before, after):
        half = 0.5 * height_step(zones, before, after)
    low = zones[after + ZONE_START] - width
    high = zones[after + ZONE_START] + width
    z_0, slope_0, bend_0 = zone_jet(zones, before, low)
    z_1, slope_1, bend_1 = zone_jet(zones, after, high)
    write_quintic(tables, at, low, high, z_0 + half, slope_0, bend_0, z_1 - half, slope_1, bend_1)
    return at + PIECE_SIZE


def write_moved(
    tables: "float[:]",
    at: int,
    zones: "float[:]",
    row: int,
    low: float,
    high: float,
    first: float,
    last: float,
):
    """A piece of one zone between ``low`` and ``high`` [mm], moved by ``first`` and ``last`` [mm] there; the
    offset after it, or FULL."""
    if at + 2 * PIECE_SIZE > tables.shape[0]:
        return FULL
    z_0, slope_0, bend_0 = zone_jet(zones, row, low)
    z_1, slope_1, bend_1 = zone_jet(zones, row, high)
    write_quintic(tables, at, low, high, z_0 + first, slope_0, bend_0, z_1 + last, slope_1, bend_1)
    return at + PIECE_SIZE


def write_repair(
    tables: "float[:]", at: int, zones: "float[:]", before: int, after: int, low: float, high: float
):
    """A piece that leads from the mean of two zones into the second, or from the first into the mean; the
    offset after it, or FULL."""
    if at + 2 * PIECE_SIZE > tables.shape[0]:
        return FULL
    z_0, slope_0, bend_0 = zone_jet(zones, before, low)
    z_1, slope_1, bend_1 = zone_jet(zones, before, high)
    z_2, slope_2, bend_2 = zone_jet(zones, after, low)
    z_3, slope_3, bend_3 = zone_jet(zones, after, high)
    if low == zones[after + ZONE_START]:
        write_quintic(
            tables,
            at,
            low,
            high,
            0.5 * (z_0 + z_2),
            0.5 * (slope_0 + slope_2),
            0.5 * (bend_0 + bend_2),
            z_3,
            slope_3,
            bend_3,
        )
    else:
        write_quintic(
            tables,
            at,
            low,
            high,
            z_0,
            slope_0,
            bend_0,
            0.5 * (z_1 + z_3),
            0.5 * (slope_1 + slope_3),
            0.5 * (bend_1 + bend_3),
        )
    return at + PIECE_SIZE


def repair_end(zones: "float[:]", row: int, width: float):
    """How far from a joint of a zone its height is repaired [mm], next to a corner of this ``width``."""
    return min(max(REPAIR_WIDTH, 2.0 * width), 0.5 * (zones[row + ZONE_STOP] - zones[row + ZONE_START]))


def write_start(tables: "float[:]", at: int, zones: "float[:]", before: int, row: int):
    """What joins zone ``row`` to the one ``before`` it, but for a corner's own piece: the offset after that,
    or FULL, and the abscissa [mm] from which the zone is followed."""
    start = zones[row + ZONE_START]
    inner = start
    stepped = steps(zones, before, row)
    width = corner_width(zones, before, row)
    if stepped and width > 0.0:
        inner = start + repair_end(zones, row, width)
        half = -0.5 * height_step(zones, before, row)
        at = write_moved(tables, at, zones, row, start + width, inner, half, 0.0)
    elif stepped:
        inner = min(start + REPAIR_WIDTH, 0.5 * (start + zones[row + ZONE_STOP]))
        at = write_repair(tables, at, zones, before, row, start, inner)
    elif width > 0.0:
        inner = start + width
    return at, inner


def write_stop(tables: "float[:]", at: int, zones: "float[:]", row: int, after: int, last: float):
    """What joins zone ``row``, followed up to ``last`` [mm], to the one ``after`` it; the offset after that,
    or FULL."""
    stop = zones[row + ZONE_STOP]
    width = corner_width(zones, row, after)
    if width > 0.0:
        if steps(zones, row, after):
            half = 0.5 * height_step(zones, row, after)
            at = write_moved(tables, at, zones, row, last, stop - width, 0.0, half)
        if at != FULL:
            at = write_corner(tables, at, zones, row, after, width)
    elif steps(zones, row, after):
        at = write_repair(tables, at, zones, row, after, last, stop)
    return at


def followed_end(zones: "float[:]", row: int, after: int):
    """The abscissa [mm] up to which zone ``row`` is followed before it joins the one ``after`` it."""
    start = zones[row + ZONE_START]
    stop = zones[row + ZONE_STOP]
    width = corner_width(zones, row, after)
    if steps(zones, row, after):
        last = max(stop - REPAIR_WIDTH, 0.5 * (start + stop))
        if width > 0.0:
            last = stop - repair_end(zones, row, width)
        return last
    return stop - width


def write_zone(
    tables: "float[:]", at: int, zones: "float[:]", base: int, index: int, work: "float[:]", scratch: int
):
    """Pieces of zone ``index``; the offset after them, or FULL."""
    size = int(zones[base + DEFINITION_ROW])
    row = base + DEFINITION_ZONES + index * size
    start = zones[row + ZONE_START]
    last = zones[row + ZONE_STOP]
    joined = index + 1 < int(zones[base + DEFINITION_COUNT])
    if index > 0:
        at, start = write_start(tables, at, zones, row - size, row)
    if joined:
        last = followed_end(zones, row, row + size)
    if last > start and at != FULL:
        count = rounded_up((last - start) / LONGEST_PIECE)
        length = (last - start) / float(count)
        for i in range(count):
            high = float(i + 1) * length + start
            if i + 1 == count:
                high = last
            if at != FULL:
                at = write_refined(tables, at, zones, row, float(i) * length + start, high, work, scratch)
    if joined and at != FULL:
        at = write_stop(tables, at, zones, row, row + size, last)
    return at


def write_profile(
    tables: "float[:]",
    base: int,
    zones: "float[:]",
    definition: int,
    nowhere: float,
    work: "float[:]",
    scratch: int,
):
    """The table of a definition at ``base``; the offset after it, or FULL.  ``nowhere`` is not a number."""
    count = int(zones[definition + DEFINITION_COUNT])
    start = zones[definition + DEFINITION_ZONES + ZONE_START]
    stop = zones[
        definition + DEFINITION_ZONES + (count - 1) * int(zones[definition + DEFINITION_ROW]) + ZONE_STOP
    ]
    bins = rounded_up((stop - start) / BIN_WIDTH)
    profile = Profile.at(tables, base)
    first = offset(profile.bins, tables) + bins
    at = first
    if first + PIECE_SIZE > tables.shape[0]:
        return FULL
    for index in range(count):
        if at != FULL:
            at = write_zone(tables, at, zones, definition, index, work, scratch)
    if at == FULL:
        return FULL
    profile.start = start * MM
    profile.stop = stop * MM
    profile.bins_per_metre = BINS_EACH_METRE
    profile.bin_count = float(bins)
    profile.pieces = first - base
    piece = first
    for i in range(bins):
        left = start + BIN_WIDTH * float(i)
        while piece + PIECE_SIZE < at and tables[piece + PIECE_SIZE] <= left:
            piece += PIECE_SIZE
        profile.bins[i] = COUNTED + float(piece - base)
    to_metres(tables, first, at)
    for k in range(PIECE_SIZE):
        tables[at + k] = nowhere
    write_stops(tables, first, at)
    return at + PIECE_SIZE


def write_stops(tables: "float[:]", first: int, end: int):
    """Where pieces stop: the start of what follows each of them."""
    following = first + PIECE_SIZE
    while following <= end:
        tables[following - 1] = tables[following]
        following += PIECE_SIZE


def to_metres(tables: "float[:]", first: int, end: int):
    """Pieces from millimetres to metres."""
    at = first
    while at < end:
        tables[at] = tables[at] * MM
        tables[at + 1] = tables[at + 1] * MM
        tables[at + 3] = tables[at + 3] * SCALE_2
        tables[at + 4] = tables[at + 4] * SCALE_3
        tables[at + 5] = tables[at + 5] * SCALE_4
        tables[at + 6] = tables[at + 6] * SCALE_5
        at += PIECE_SIZE
