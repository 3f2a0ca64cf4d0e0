"""Rules for the iterations of the rooms contact and normal (wheelset_rules.py has the method): widths of
zones, points a given way along a curve, overlaps, penetrations of regions that share a load.
"""

from math import fabs, sqrt

from ..contact.curves import arc_length, curve_jet, curve_speed, move_across, move_arc, move_chord
from ..contact.overlaps import find_overlaps
from ..contact.penetrated import LINE_SHARP, meet_wheel
from ..contact.separation import separation_jet
from ..contact.traces import start_traces
from ..contact.widths import HALVED_SHARP, WIDTH_TRACE, width_limit, width_tolerance, zone_width
from ..layout import RAIL, WHEEL, Frame, Origin, Overlap, Pair, Place, Region, SideSearch, Tables, Work
from ..normal.analyn import load_regions, region_influence, region_load, solve_penetrations
from ..normal.strip_pressures import eliminate
from ..surface.locus import outline_jet
from ..surface.tables import height_slope_bend
from .intrinsics import differentiated, held, moving, nonzero, rate_of, seeded, common_rate


def width_rule(
    pair: Pair, frame: Frame, origin: Origin, region: Region, direction: float, level: float, estimate: float
):
    """``zone_width``: its Newton steps are followed as they are. A width that halving has found ends where a
    profile ends, and stays on that point; or else where the gap has risen by ``level``."""
    width = differentiated(zone_width(pair, frame, origin, region, direction, level, estimate))
    limit = width_limit(region, direction)
    if width < limit and region.reached != level:
        inner = held(width) * (1.0 - 10.0 * HALVED_SHARP)
        tolerance = width_tolerance(held(estimate))
        gap, rate = width_jet(pair, frame, origin, region, direction, inner, tolerance)
        rail_rate = rate_of(frame.traces[RAIL].abscissa)
        wheel_rate = rate_of(frame.traces[WHEEL].abscissa)
        missing = rate_of(level - gap + region.gap)
        moved = 0.0
        if rate * direction > 0.0:
            moved = missing / held(rate * direction)
        gap, rate = width_jet(pair, frame, origin, region, direction, seeded(inner, 1.0), tolerance)
        x = frame.traces[RAIL].abscissa
        y = frame.traces[WHEEL].abscissa
        out = rate_of(x) - rail_rate
        if nonzero(out) and (x < pair.rail.start + WIDTH_TRACE or x > pair.rail.stop - WIDTH_TRACE):
            moved = -rail_rate / out
        out = rate_of(y) - wheel_rate
        if nonzero(out) and (y < pair.wheel.start + WIDTH_TRACE or y > pair.wheel.stop - WIDTH_TRACE):
            moved = -wheel_rate / out
        gap, rate = width_jet(pair, frame, origin, region, direction, seeded(inner, moved), tolerance)
        width = seeded(width, moved)
        region.reached = moving(region.reached, gap - region.gap)
    return width


def width_jet(
    pair: Pair, frame: Frame, origin: Origin, region: Region, direction: float, width: float, tolerance: float
):
    """Gap [m] and its rate [-] at a distance ``width`` from a region's minimum, as
    ``zone_width`` measures it."""
    start_traces(frame, region.station, region.rail, region.wheel)
    gap, rate, bend = separation_jet(pair, frame, origin, region.station + direction * width, tolerance)
    return gap, rate


def arc_rule(pair: Pair, frame: Frame, origin: Origin, curve: int, length: float) -> bool:
    """``move_arc``: the arc from the old abscissa to the new one has the given length."""
    start = frame.traces[curve].abscissa
    exists = move_arc(pair, frame, origin, curve, length)
    if exists:
        u = held(frame.traces[curve].abscissa)
        place = length / held(curve_speed(pair, frame, origin, curve, u))
        if u == start:
            place = start + place
        else:
            place -= arc_length(pair, frame, origin, curve, start, u) / held(
                curve_speed(pair, frame, origin, curve, u)
            )
        frame.traces[curve].abscissa = moving(u, place)
    return exists


def chord_rule(pair: Pair, frame: Frame, origin: Origin, curve: int, chord: float) -> bool:
    """``move_chord``: both abscissae are a chord apart."""
    start = frame.traces[curve].abscissa
    from_across, from_down, slope, stretch, bend = curve_jet(pair, frame, origin, curve, start)
    exists = move_chord(pair, frame, origin, curve, chord)
    if exists:
        u = held(frame.traces[curve].abscissa)
        across, down, slope, stretch, bend = curve_jet(pair, frame, origin, curve, u)
        across -= from_across
        down -= from_down
        length = sqrt(across * across + down * down)
        along = (across + slope * down) * stretch
        frame.traces[curve].abscissa = moving(u, -(length - fabs(chord)) * held(length / along))
    return exists


def across_rule(pair: Pair, frame: Frame, origin: Origin, lateral: float) -> bool:
    """``move_across``: the wheel's outline is at the given lateral coordinate."""
    exists = move_across(pair, frame, origin, lateral)
    if exists:
        u = held(frame.traces[WHEEL].abscissa)
        across, down, slope, stretch, bend = curve_jet(pair, frame, origin, WHEEL, u)
        frame.traces[WHEEL].abscissa = moving(u, -(across - lateral) / held(stretch))
    return exists


def meet_rule(pair: Pair, place: Place, abscissa: float, y: float, height: float, tolerance: float) -> bool:
    """``meet_wheel``: the wheel's point lies on the rail's normal."""
    found = meet_wheel(pair, place, abscissa, y, height, tolerance)
    if found:
        y = held(place.meeting.wheel)
        z_rail, m, rail_bend = height_slope_bend(pair.rail, abscissa)
        z, slope, bend = height_slope_bend(pair.wheel, y)
        y_track, z_track, outline_slope, stretch, rate = outline_jet(place, y, z, slope, bend)
        residual = y_track - pair.rail_y - abscissa + (z_track + height - z_rail) * m
        y = moving(y, -residual / held(stretch * (1.0 + m * outline_slope)))
        differentiated(meet_wheel(pair, place, abscissa, y, height, tolerance))
    return found


def turning_rule(pair: Pair, place: Place, x: float, y: float, height: float):
    """Rail and wheel abscissa [m] where the overlap is largest or smallest, near ``x`` and ``y``, and the
    overlap: its rate is zero there."""
    meeting = place.meeting
    x = held(x)
    y = held(y)
    found_x = x
    overlap = 0.0
    if meet_rule(pair, place, x, y, height, LINE_SHARP):
        rise = meeting.rise
        meet_rule(pair, place, seeded(x, 1.0), held(meeting.wheel), height, LINE_SHARP)
        change = rate_of(meeting.rise) - rate_of(rise)
        if nonzero(change):
            found_x = moving(x, -rise / change)
        meet_rule(pair, place, found_x, held(meeting.wheel), height, LINE_SHARP)
        y = meeting.wheel
        overlap = meeting.overlap
    return found_x, y, overlap


def overlaps_rule(pair: Pair, overlap: Overlap, side: SideSearch, height: float):
    """``find_overlaps``: the overlap's rate is zero at deepest points and saddles."""
    count = find_overlaps(pair, overlap, side, height)
    for entry in range(count):
        point = overlap.points[entry]
        x, y, depth = turning_rule(pair, side.place, point.rail, point.wheel, height)
        point.rail = moving(point.rail, x)
        point.wheel = moving(point.wheel, y)
        point.depth = moving(point.depth, depth)
    for entry in range(count - 1):
        point = overlap.points[entry]
        following = overlap.points[entry + 1]
        x, y, depth = turning_rule(
            pair, side.place, point.saddle, 0.5 * (point.wheel + following.wheel), height
        )
        point.saddle = moving(point.saddle, x)
        point.between = moving(point.between, depth)
    return count


def penetrations_rule(
    work: Work, tables: Tables, count: int, force: float, penetration: float, prescribed: bool
):
    """``solve_penetrations`` as it is lowered: of each region local penetration = turn penetration - gap -
    sum of pushes, and of all the load is the force.

    Linear equations for the rates of the penetrations, from how loads follow the
    local ones and move at fixed ones.
    """
    regions = work.contact.regions
    nodes = work.contact.nodes
    given = penetration
    penetration, satisfied = solve_penetrations(tables, regions, nodes, count, force, penetration, prescribed)
    if not satisfied:
        return penetration, satisfied
    size = count + 1
    equations = work.contact.equations
    for i in range(count):
        region = regions[i]
        region.local_penetration = held(region.local_penetration)
    total = load_regions(regions, nodes, count)
    last = equations[count]
    for i in range(count):
        block = regions[i]
        row = equations[i]
        pushed = 0.0
        for j in range(count):
            share = 0.0
            if j != i:
                share = region_influence(tables, block, regions[j])
            pushed += share * regions[j].load
            row[j] = held(share)
        rest = block.alignment * held(penetration) - block.gap - pushed
        row[count] = -held(block.alignment)
        row[size] = seeded(0.0, rate_of(rest))
        row[size + 1] = 0.0
    for j in range(count):
        block = regions[j]
        load, stiffness = region_load(block, nodes[j], seeded(block.local_penetration, 1.0))
        per_level = common_rate(rate_of(load) - rate_of(block.load))
        for i in range(count):
            equations[i][j] = held(equations[i][j]) * per_level
        equations[j][j] = held(equations[j][j]) + 1.0
        last[j] = 0.0
        if not prescribed:
            last[j] = held(block.share) * per_level
    last[count] = 0.0
    last[size] = seeded(0.0, rate_of(force - total))
    last[size + 1] = 0.0
    if prescribed:
        last[count] = 1.0
        last[size] = seeded(0.0, rate_of(given))
    eliminate(equations, size)
    for i in range(count):
        region = regions[i]
        region.local_penetration = moving(region.local_penetration, equations[i][size])
    load_regions(regions, nodes, count)
    penetration = moving(penetration, last[size])
    return penetration, satisfied
