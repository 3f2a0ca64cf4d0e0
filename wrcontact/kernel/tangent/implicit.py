"""How a step's results move with its inputs: what is found by iteration, differentiated implicitly.

The kernel is differentiated along a seed of its inputs by ``tools/tangent.py``, statement by statement. Where
it searches or iterates, the way there says nothing about how the result moves; the equation that the result
solves does. Of r(x, p) = 0

    dx = -(dr/dp dp) / (dr/dx)

Here stands one rule for each such iteration: it takes the kernel's own result, evaluates the equation
there with rates, and lets the result move by them. Values are left as they are. What the rules call
beside the kernel's functions is told in ``tools/tangent.py``; this module is an input of that one and
is not translated itself.
"""

from math import cos, fabs, log, sin, sqrt

from ..contact.arc_length import arc_length
from ..contact.contact_plane import normal_gap
from ..contact.curves import curve_jet, curve_speed
from ..contact.moves import move_across, move_arc, move_chord
from ..contact.overlaps import find_overlaps
from ..contact.pressed import normal_line
from ..contact.regions import BEYOND, PLACE_SHARP, PLACE_TRACE, find_saddle, open_region
from ..contact.separation import separation
from ..contact.touching import touching_pair
from ..contact.traces import start_traces
from ..contact.zone_width import HALVED_SHARP, WIDTH_TRACE, width_limit, width_tolerance, zone_width
from ..layout import (
    MODE_COMPLIANT,
    MODE_ELASTIC,
    MODE_RIGID,
    RAIL,
    WHEEL,
    Frame,
    HertzTable,
    Origin,
    Overlap,
    Place,
    Region,
    SideSearch,
    State,
    Tables,
    Work,
)
from ..normal.analyn import load_regions, region_load, solve_penetrations
from ..normal.elimination import eliminate
from ..normal.hertz import table_value, upright_coefficients
from ..normal.interaction import region_influence
from ..search.roll import place_both
from ..surface.gap import gap_per_roll, vertical_gap
from ..surface.locus import mirror_place, outline_jet, turn_wheelset
from ..surface.profile_table import height_slope_bend
from ..wheelset.compliant import load_at_height
from ..wheelset.elastic import ELASTIC_SHARP
from ..wheelset.requested import omit_outputs, side_force
from ..wheelset.resultant import write_resultant
from ..wheelset.rigid import solve_rigid
from ..wheelset.trial import balance_side


def held(x: float):
    """``x`` as a constant."""
    return x


def moving(x: float, other: float):
    """``x``, which moves as ``other`` does."""
    return x


def seeded(x: float, rate: float):
    """``x``, which moves at ``rate``."""
    return x


def rate_of(x: float):
    """How ``x`` moves; nothing does where no rates are carried."""
    return 0.0


def differentiated(x: float):
    """``x``, a call of a function that has a rule, differentiated as it is written."""
    return x


def place_moving(tables: Tables, work: Work, roll: float):
    """Both wheels at ``roll``; one that begins to yaw is placed as a yawed one."""
    place_both(tables, work.inputs, work.sides, roll)
    yaw = work.inputs.yaw
    if yaw == 0.0 and rate_of(yaw) != 0.0:
        work.sides[1].place.sin_yaw = sin(yaw)
        work.sides[1].place.cos_yaw = cos(yaw)
        work.sides[1].place.yawed = True
        turn_wheelset(work.sides[1].place, roll)
        mirror_place(work.sides[1].place, work.sides[0].place)
    return 0


def follow_minimum(tables: Tables, work: Work, index: int):
    """Let the smallest gap of side ``index`` and its place move with the placed wheel: there the slopes of
    wheel and rail agree, mismatch(y) = 0."""
    side = work.sides[index]
    at = work.sides[index].place
    y = held(side.best_y)
    gap, mismatch, rate = vertical_gap(tables, at, y)
    y = moving(y, -mismatch / held(rate))
    gap, mismatch, rate = vertical_gap(tables, at, y)
    side.best_y = y
    side.best = moving(side.best, gap)
    return 0


def follow_roll(tables: Tables, work: Work):
    """The rigid roll [rad], at which both smallest gaps are equal: a gap's place does not count for
    how it follows the roll."""
    roll = held(work.outputs.roll)
    place_moving(tables, work, roll)
    left = held(work.sides[0].best_y)
    right = held(work.sides[1].best_y)
    gap_left, mismatch_left, rate_left = vertical_gap(tables, work.sides[0].place, left)
    gap_right, mismatch_right, rate_right = vertical_gap(tables, work.sides[1].place, right)
    lever = (gap_per_roll(tables, work.sides[1].place, right)
             + gap_per_roll(tables, work.sides[0].place, left))
    return moving(roll, -(gap_right - gap_left) / held(lever))


def follow_stand(tables: Tables, work: Work, state: State, roll: float, height: float):
    """Both sides of an elastic wheelset that stands at ``roll`` and ``height``, each under its load."""
    place_moving(tables, work, roll)
    for index in range(2):
        follow_minimum(tables, work, index)
        balance_side(tables, work, state, index, side_force(work.inputs, index), height)
    return 0


def follow_elastic(tables: Tables, work: Work, state: State):
    """The elastic stand: what both sides lack of the height vanishes, over height and roll.

    1 where it does not, else 0: then the wheelset stands where a side's load jumps past its force
    (elastic.bracket_height), and no equation tells how that place moves.
    """
    roll = work.outputs.roll
    height = work.outputs.vertical_shift
    left = work.supports[0]
    right = work.supports[1]
    follow_stand(tables, work, state, held(roll), held(height))
    if fabs(left.height - height) + fabs(right.height - height) > 1e4 * ELASTIC_SHARP:
        return 1
    lack_left = rate_of(left.height)
    lack_right = rate_of(right.height)
    follow_stand(tables, work, state, held(roll), seeded(height, 1.0))
    left_height = rate_of(left.height) - lack_left - 1.0
    right_height = rate_of(right.height) - lack_right - 1.0
    follow_stand(tables, work, state, seeded(roll, 1.0), held(height))
    left_roll = rate_of(left.height) - lack_left
    right_roll = rate_of(right.height) - lack_right
    determinant = left_height * right_roll - right_height * left_roll
    if determinant == 0.0:
        return 1
    height_rate = (lack_right * left_roll - lack_left * right_roll) / determinant
    roll_rate = (lack_left * right_height - lack_right * left_height) / determinant
    follow_stand(tables, work, state, seeded(roll, roll_rate), seeded(height, height_rate))
    work.outputs.roll = seeded(roll, roll_rate)
    work.outputs.vertical_shift = seeded(height, height_rate)
    return 0


def follow_compliant(tables: Tables, work: Work, state: State):
    """Both sides of a wheelset that stands at the height and roll of the inputs."""
    roll = work.inputs.roll
    height = work.inputs.vertical_shift
    place_moving(tables, work, roll)
    work.outputs.roll = roll
    work.outputs.vertical_shift = height
    for index in range(2):
        follow_minimum(tables, work, index)
        load_at_height(tables, work, state, index, height)
    return 0


def differentiate(tables: Tables, work: Work, state: State):
    """Let the outputs of a step that was VALID or UNLOADED move with its inputs; the workspace is as the step
    left it. 1 where that cannot be told (``follow_elastic``), else 0."""
    mode = tables.mode
    outcome = 0
    if mode == MODE_RIGID:
        roll = follow_roll(tables, work)
        place_moving(tables, work, roll)
        for index in range(2):
            follow_minimum(tables, work, index)
        solve_rigid(tables, work, state, roll)
    if mode == MODE_ELASTIC:
        outcome = follow_elastic(tables, work, state)
    if mode == MODE_COMPLIANT:
        follow_compliant(tables, work, state)
    write_resultant(tables, work.inputs, work.outputs, work.supports[0].resultant, work.supports[1].resultant)
    omit_outputs(tables, work)
    return outcome


def minimum_rule(tables: Tables, frame: Frame, region: Region, state: State, station: float):
    """``open_region``: at the minimum the gap's rate is zero."""
    found = open_region(tables, frame, region, state, station)
    if found < BEYOND:
        place = held(region.station)
        start_traces(frame, place, held(frame.traces[RAIL].abscissa), held(frame.traces[WHEEL].abscissa))
        gap, rate, bend, curvature = normal_gap(tables, frame, state, place, PLACE_TRACE)
        place = moving(place, -rate / held(bend))
        found = differentiated(open_region(tables, frame, region, state, place))
    return found


def saddle_rule(tables: Tables, frame: Frame, low: Region, high: Region, state: State):
    """``find_saddle``: at the saddle the gap's rate is zero; a sample that stands for it
    keeps its share of the way."""
    station, gap = find_saddle(tables, frame, low, high, state)
    way = high.station - low.station
    place = low.station + way * held((station - low.station) / way)
    if frame.station == station:
        start_traces(frame, held(station), held(frame.traces[RAIL].abscissa),
                     held(frame.traces[WHEEL].abscissa))
        saddle, rate, bend, curvature = normal_gap(tables, frame, state, held(station), PLACE_TRACE)
        if bend < 0.0 and fabs(rate) < -10.0 * PLACE_SHARP * bend:
            place = -rate / held(bend)
    station = moving(station, place)
    return station, gap


def width_rule(tables: Tables, frame: Frame, origin: Origin, region: Region, state: State, direction: float,
               level: float, estimate: float):
    """``zone_width``: its Newton steps are followed as they are. A width that halving has found ends where a
    profile ends, and stays on that point; or else where the gap has risen by ``level``."""
    width = differentiated(zone_width(tables, frame, origin, region, state, direction, level, estimate))
    limit = width_limit(region, direction)
    if width < limit and region.reached != level:
        inner = held(width) * (1.0 - 10.0 * HALVED_SHARP)
        tolerance = width_tolerance(held(estimate))
        gap, rate = width_jet(tables, frame, origin, region, state, direction, inner, tolerance)
        rail_rate = rate_of(frame.traces[RAIL].abscissa)
        wheel_rate = rate_of(frame.traces[WHEEL].abscissa)
        missing = rate_of(level - gap + region.gap)
        moved = 0.0
        if rate * direction > 0.0:
            moved = missing / held(rate * direction)
        gap, rate = width_jet(tables, frame, origin, region, state, direction, seeded(inner, 1.0), tolerance)
        x = frame.traces[RAIL].abscissa
        y = frame.traces[WHEEL].abscissa
        out = rate_of(x) - rail_rate
        if out != 0.0 and (x < tables.rail.start + WIDTH_TRACE or x > tables.rail.stop - WIDTH_TRACE):
            moved = -rail_rate / out
        out = rate_of(y) - wheel_rate
        if out != 0.0 and (y < tables.wheel.start + WIDTH_TRACE or y > tables.wheel.stop - WIDTH_TRACE):
            moved = -wheel_rate / out
        gap, rate = width_jet(tables, frame, origin, region, state, direction, seeded(inner, moved),
                              tolerance)
        width = seeded(width, moved)
        region.reached = moving(region.reached, gap - region.gap)
    return width


def width_jet(tables: Tables, frame: Frame, origin: Origin, region: Region, state: State, direction: float,
              width: float, tolerance: float):
    """Gap [m] and its rate [-] at a distance ``width`` from a region's minimum, as
    ``zone_width`` measures it."""
    start_traces(frame, region.station, region.rail, region.wheel)
    gap, rate, bend, curvature = separation(tables, frame, origin, state, region.station + direction * width,
                                            tolerance)
    return gap, rate


def penetrations_rule(work: Work, tables: Tables, state: State, count: int, force: float, penetration: float,
                      prescribed: int):
    """``solve_penetrations`` as it is lowered: of each region local penetration = turn penetration - gap -
    sum of pushes, and of all the load is the force.

    Linear equations for the rates of the penetrations, from how loads follow the
    local ones and move at fixed ones.
    """
    regions = work.contact.regions
    nodes = work.contact.nodes
    given = penetration
    penetration, met = solve_penetrations(tables, regions, nodes, state, count, force, penetration,
                                          prescribed)
    if met == 0:
        return penetration, met
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
        row[size] = rate_of(rest)
        row[size + 1] = 0.0
    for j in range(count):
        block = regions[j]
        load, stiffness = region_load(block, nodes[j], seeded(block.local_penetration, 1.0))
        per_level = rate_of(load) - rate_of(block.load)
        for i in range(count):
            equations[i][j] = held(equations[i][j]) * per_level
        equations[j][j] = held(equations[j][j]) + 1.0
        last[j] = 0.0
        if prescribed == 0:
            last[j] = held(block.share) * per_level
    last[count] = 0.0
    last[size] = rate_of(force - total)
    last[size + 1] = 0.0
    if prescribed == 1:
        last[count] = 1.0
        last[size] = rate_of(given)
    eliminate(equations, size)
    for i in range(count):
        region = regions[i]
        region.local_penetration = seeded(region.local_penetration, equations[i][size])
    load_regions(regions, nodes, count)
    penetration = seeded(penetration, last[size])
    return penetration, met


def pair_rule(tables: Tables, place: Place, y: float, abscissa: float, shift: float):
    """``touching_pair``: both slopes agree, and the line between the points is normal to them."""
    y, abscissa, depth, aside, back_shift, found = touching_pair(tables, place, y, abscissa, shift)
    if found == 1:
        for i in range(2):
            z, slope, bend = height_slope_bend(tables.wheel, y)
            y_track, z_track, outline_slope, stretch, rate = outline_jet(place, y, z, slope, bend)
            height, m, rail_bend = height_slope_bend(tables.rail, abscissa)
            across = y_track - tables.rail_y - abscissa
            down = z_track + shift - height
            if i == 0:
                mismatch = outline_slope - m
                apart = across + down * m
                along = stretch * (1.0 + outline_slope * m)
                back = down * rail_bend - 1.0 - m * m
                determinant = held(rate * back + rail_bend * along)
                y = moving(y, -(mismatch * held(back) + held(rail_bend) * apart) / determinant)
                abscissa = moving(abscissa, -(held(rate) * apart - held(along) * mismatch) / determinant)
            else:
                depth = moving(depth, (down - m * across) / sqrt(1.0 + m * m))
                aside = moving(aside, -across)
                back_shift = moving(back_shift, shift - down)
    return y, abscissa, depth, aside, back_shift, found


def upright_rule(table: HertzTable, length: float, width: float, nr: float):
    """``upright_coefficients``: ratio + log((1 + beta)/(1 + alpha)) = log(width / length),
    over ratio = log(B/A)."""
    A, B, share = upright_coefficients(table, length, width, nr)
    ratio = seeded(log(held(B) / held(A)), 1.0)
    change = log(table_value(table, 0, -ratio) / table_value(table, 0, ratio))
    slope = 1.0 + rate_of(change)
    ratio = moving(ratio, log(width / length) / slope)
    alpha = table_value(table, 0, ratio)
    beta = table_value(table, 0, -ratio)
    share = moving(share, table_value(table, 6, ratio) / nr)
    A = moving(A, share * length / alpha)
    B = moving(B, share * width / beta)
    return A, B, share


def arc_rule(tables: Tables, frame: Frame, origin: Origin, curve: int, length: float):
    """``move_arc``: the arc from the old abscissa to the new one has the given length."""
    start = frame.traces[curve].abscissa
    exists = move_arc(tables, frame, origin, curve, length)
    if exists == 1:
        u = held(frame.traces[curve].abscissa)
        place = length / held(curve_speed(tables, frame, origin, curve, u))
        if u == start:
            place = start + place
        else:
            place -= arc_length(tables, frame, origin, curve, start,
                                u) / held(curve_speed(tables, frame, origin, curve, u))
        frame.traces[curve].abscissa = moving(u, place)
    return exists


def chord_rule(tables: Tables, frame: Frame, origin: Origin, curve: int, chord: float):
    """``move_chord``: both abscissae are a chord apart."""
    start = frame.traces[curve].abscissa
    from_across, from_down, slope, stretch, bend = curve_jet(tables, frame, origin, curve, start)
    exists = move_chord(tables, frame, origin, curve, chord)
    if exists == 1:
        u = held(frame.traces[curve].abscissa)
        across, down, slope, stretch, bend = curve_jet(tables, frame, origin, curve, u)
        across -= from_across
        down -= from_down
        length = sqrt(across * across + down * down)
        along = (across + slope * down) * stretch
        frame.traces[curve].abscissa = moving(u, -(length - fabs(chord)) * held(length / along))
    return exists


def across_rule(tables: Tables, frame: Frame, origin: Origin, lateral: float):
    """``move_across``: the wheel's outline is at the given lateral coordinate."""
    exists = move_across(tables, frame, origin, lateral)
    if exists == 1:
        u = held(frame.traces[WHEEL].abscissa)
        across, down, slope, stretch, bend = curve_jet(tables, frame, origin, WHEEL, u)
        frame.traces[WHEEL].abscissa = moving(u, -(across - lateral) / held(stretch))
    return exists


def line_rule(tables: Tables, frame: Frame, place: Place, abscissa: float, y: float, height: float):
    """``normal_line``: the wheel's point lies on the rail's normal."""
    y, overlap, rise, bend, curvature, found = normal_line(tables, frame, place, abscissa, y, height)
    if found == 1:
        z_rail, m, rail_bend = height_slope_bend(tables.rail, abscissa)
        z, slope, bend = height_slope_bend(tables.wheel, y)
        y_track, z_track, outline_slope, stretch, rate = outline_jet(place, y, z, slope, bend)
        residual = y_track - tables.rail_y - abscissa + (z_track + height - z_rail) * m
        y = moving(y, -residual / held(stretch * (1.0 + m * outline_slope)))
        y, overlap, rise, bend, curvature, found = differentiated(normal_line(tables, frame, place, abscissa,
                                                                              y, height))
    return y, overlap, rise, bend, curvature, found


def turning_rule(tables: Tables, frame: Frame, place: Place, x: float, y: float, height: float):
    """Rail and wheel abscissa [m] where the overlap is largest or smallest, near ``x`` and ``y``, and the
    overlap: its rate is zero there."""
    x = held(x)
    found_x = x
    y, overlap, rise, bend, curvature, found = line_rule(tables, frame, place, x, held(y), height)
    if found == 1:
        y, overlap, more, bend, curvature, found = line_rule(tables, frame, place, seeded(x, 1.0), held(y),
                                                             height)
        change = rate_of(more) - rate_of(rise)
        if change != 0.0:
            found_x = moving(x, -rise / change)
        y, overlap, more, bend, curvature, found = line_rule(tables, frame, place, found_x, held(y), height)
    return found_x, y, overlap, found


def overlaps_rule(tables: Tables, frame: Frame, overlap: Overlap, side: SideSearch, state: State,
                  height: float):
    """``find_overlaps``: the overlap's rate is zero at deepest points and saddles."""
    count = find_overlaps(tables, frame, overlap, side, state, height)
    for entry in range(count):
        point = overlap.points[entry]
        x, y, depth, found = turning_rule(tables, frame, side.place, point.rail, point.wheel, height)
        point.rail = moving(point.rail, x)
        point.wheel = moving(point.wheel, y)
        point.depth = moving(point.depth, depth)
    for entry in range(count - 1):
        point = overlap.points[entry]
        following = overlap.points[entry + 1]
        x, y, depth, found = turning_rule(tables, frame, side.place, point.saddle,
                                          0.5 * (point.wheel + following.wheel), height)
        point.saddle = moving(point.saddle, x)
        point.between = moving(point.between, depth)
    return count
