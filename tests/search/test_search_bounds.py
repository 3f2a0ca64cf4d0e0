"""What the search skips holds no smaller gap: its bounds against dense sampling."""

import numpy as np
import pytest

import wrcontact
from data.noisy_profiles import noisy_points
from tests.helpers.inside import tables_of
from wrcontact.kernel import layout
from wrcontact.kernel.search import bounds, own_bounds, roll, single_minimum, smallest_gap
from wrcontact.kernel.search import bounds as raster
from wrcontact.kernel.surface import gap, locus
from wrcontact.profiles.compiled import evaluate_table

SEARCH_YAWS = (0.0, 0.02, 0.05, 0.105)  # [rad]
PER_CELL = 8  # samples of the gap in a cell of the search


def sampled_placements(count, seed, largest_roll):
    """Random placements of a right wheel, and its gap sampled PER_CELL times in each cell of
    the search: wheel and rail, inputs, the wheel's place, abscissae, gaps, slope differences and
    whether the rail is below, (n,) each."""
    rng = np.random.default_rng(seed)
    tables = layout.Tables.at(tables_of(wrcontact.ContactSystem()))
    pair = tables.pairs[1]
    work = layout.Work.at(np.zeros(layout.WORK_SIZE))
    nodes = np.array([pair.scan.nodes[node].y for node in range(pair.scan.count)])
    share = np.arange(PER_CELL) / PER_CELL
    y = np.append((nodes[:-1, None] + share * np.diff(nodes)[:, None]).ravel(), nodes[-1])
    place = work.sides[1].place
    for trial in range(count):
        work.inputs.lateral_shift = rng.uniform(-0.01, 0.01)
        work.inputs.yaw = SEARCH_YAWS[trial % len(SEARCH_YAWS)]
        roll.place_both(tables, work.inputs, work.sides, rng.uniform(-largest_roll, largest_roll))
        gaps, mismatches, _ = np.array([gap.vertical_gap(pair, place, where) for where in y]).T
        below = np.array([on_rail(pair, place, where) for where in y])
        yield pair, work.inputs, place, y, gaps, mismatches, below


def test_a_place_beside_the_rail_has_the_cell_that_is_nearest():
    tables = layout.Tables.at(tables_of(wrcontact.ContactSystem()))
    scan = tables.pairs[1].scan
    last = scan.rail_count - 1
    places = {-3.0: 0, 0.0: 0, 0.9: 0, 1.0: 1, last - 0.1: last - 1, last + 0.5: last, last + 7.0: last}
    assert {u: bounds.rail_index(scan, u) for u in places} == places


@pytest.mark.parametrize("count", [8, pytest.param(20, marks=pytest.mark.full)])
def test_no_cell_of_the_search_holds_more_than_its_bound_says(count):
    """The certificate of the global minimum, against dense sampling of the gap at random
    placements up to 6 deg."""
    checked = 0
    for pair, inputs, place, y, gaps, mismatches, below in sampled_placements(count, 21, 0.01):
        for cell in range(len(y) // PER_CELL):
            inside = slice(PER_CELL * cell, PER_CELL * (cell + 1) + 1)
            if not np.all(below[inside]):
                continue
            checked += 1
            abscissa = raster.node_gap(pair, place, cell)[2]
            least, most = bounds.bend_bounds(pair.scan, place, cell, abscissa)
            dip = min(gaps[inside][0], gaps[inside][-1]) - gaps[inside].min()
            where = (cell, y[inside][0], inputs.yaw)
            assert dip <= most * np.ptp(y[inside]) ** 2 / 8 + 1e-12, where
            if least > 0.0 and mismatches[inside].max() < gap.FOLDED:
                assert np.all(np.diff(mismatches[inside]) > -1e-12), where  # one place of contact at most
    assert checked > 60 * count


@pytest.mark.parametrize("count", [8, pytest.param(40, marks=pytest.mark.full)])
def test_a_cell_that_is_certified_to_rise_does(count):
    """``rises_in_cell`` against dense sampling: where it holds the slope difference rises from sample to
    sample, and it holds in most cells in which it does."""
    certified = rising = joined = 0
    for pair, inputs, place, y, _, mismatches, below in sampled_placements(count, 24, 0.013):
        for cell in range(len(y) // PER_CELL):
            inside = slice(PER_CELL * cell, PER_CELL * (cell + 1) + 1)
            holds = single_minimum.rises_in_cell(pair, place, cell)
            if not np.all(below[inside]):
                continue
            steps = np.diff(mismatches[inside])
            if holds:
                certified += 1
                where = (inputs.lateral_shift, inputs.yaw, cell, y[inside][0])
                assert mismatches[inside].max() < gap.FOLDED, where
                assert np.all(steps > 0.0), where
                bends = steps / np.diff(y[inside])
                joined += np.ptp(bends) > 5.0  # the curvature jumps in the cell
            rising += np.all(steps > 0.0)
    assert certified > 0.85 * rising > 12 * count and joined > count


@pytest.mark.parametrize("width, wider", [(1e-6, 1.03), (1e-5, 1.25)])
def test_bounds_of_small_parts_are_hardly_wider_than_what_they_bound(width, wider):
    """Second derivatives and slopes of the wheel, sampled; S1002's led-over steps and joints among them."""
    system = wrcontact.ContactSystem()
    tables = layout.Tables.at(tables_of(system))
    table, wheel = system.profile_tables()[0], tables.pairs[1].wheel
    joints = np.array([joint.y for joint in system.wheel.joints])
    random = np.random.default_rng(3).uniform(-0.05, 0.04, 200)
    bent = 0
    for low in [*random, *(joints - 0.5 * width), *(joints + 1e-4), *(joints - 1e-4)]:
        least, most, steepest = own_bounds.bends_between(wheel, low, low + width)
        y = np.linspace(low, low + width, 41)[:-1]
        _, slope, bend = evaluate_table(table, y)
        assert least <= bend.min() + 1e-9 and most >= bend.max() - 1e-9, low
        assert (
            np.abs(slope).max()
            <= steepest + 1e-12
            < np.abs(slope).max() + 2.0 * width * np.abs(bend).max() + 1e-9
        )
        if np.ptp(bend) > 1e-6:
            bent += 1
            assert most - least < wider * 40 / 39 * np.ptp(bend) + 1e-9, low
    assert bent > 100


def test_the_outline_is_bent_and_stretched_no_more_than_the_search_allows():
    """What roll and yaw make of a profile point, against the shares of ``least_bend``."""
    rng = np.random.default_rng(23)
    place, checked = layout.Place.at(np.zeros(layout.PLACE_SIZE)), 0
    for _ in range(5000):
        turn, yaw = rng.choice([0.02, 0.1]) * rng.uniform(-1, 1), rng.choice([0.0, rng.uniform(-0.12, 0.12)])
        slope, bend = rng.uniform(-bounds.STEEP, bounds.STEEP), rng.choice([-1, 1]) * 10 ** rng.uniform(-1, 3)
        z = rng.uniform(-0.02, 0.03)
        locus.place_wheelset(place, 0.0, yaw, turn, 0.46, 0.46, 0.75)
        _, _, _, stretch, rate = locus.outline_jet(place, rng.uniform(-0.04, 0.03), z, slope, bend)
        square = np.sin(yaw) ** 2
        widened = bounds.ROLL_STRETCH * abs(np.sin(turn)) + square * (
            bounds.BEND_STRETCH * 0.46 * abs(bend) + bounds.STEEP_STRETCH
        )
        if widened < bounds.WIDEST:
            checked += 1
            assert abs(stretch - 1.0) <= widened + 1e-12, (turn, yaw, slope, bend)
            share = bounds.ROLL_BEND * abs(np.sin(turn)) + bounds.YAW_BEND * square
            assert abs(rate - bend) <= (share + 1e-12) * abs(bend), (turn, yaw, slope, bend)
    assert checked > 2000


@pytest.mark.parametrize("count", [8, pytest.param(16, marks=pytest.mark.full)])
def test_no_stretch_that_the_search_skips_holds_a_smaller_gap(count):
    """``clear_exponent`` may not clear a stretch in which the sampled gap falls further than allowed; and it
    has to clear most of those far above."""
    checked = cleared = 0
    for pair, inputs, place, y, gaps, _, below in sampled_placements(count, 22, 0.013):
        for node in np.flatnonzero(below[::PER_CELL]):
            node = int(node)
            gap_there, mismatch, abscissa = raster.node_gap(pair, place, node)
            for direction in (1, -1):
                for exponent in range(layout.EXPONENTS):
                    end = PER_CELL * (node + direction * 2**exponent)
                    if not 0 <= end < len(y):
                        continue
                    inside = np.arange(PER_CELL * node, end + direction, direction)
                    inside = inside[np.cumprod(below[inside]) == 1]  # up to the end of the rail
                    fall = gap_there - gaps[inside].min()
                    arguments = (pair.scan, place, node, direction, abscissa)
                    where = (inputs.lateral_shift, inputs.yaw, node, direction, exponent)
                    slope = direction * mismatch
                    checked += 1
                    if fall > 1e-12:
                        allowed = fall * (1 - 1e-9) - 1e-13
                        assert bounds.clear_exponent(*arguments, allowed, slope, exponent) < exponent, where
                    if bounds.clear_exponent(*arguments, 2e-3, slope, exponent) == exponent:
                        cleared += 1
    assert checked > 600 * count and cleared > checked / 2


def test_smallest_gap_of_rough_profiles(tmp_path):
    """S1002 on UIC60 from points with 1 um of noise every 0.2 mm, not smoothed: the gap has several minima in
    a cell of the search, of which it took the first that it met. 14 of these 320 wheels had a smaller gap
    elsewhere, by up to 1.7 um; at -5.35, -6.25 and 7.55 mm a node of the search was left as the smallest and
    taken for the end of a profile."""
    profiles = []
    for seed, kind in ((1, "wheel"), (2, "rail")):
        path = tmp_path / f"{kind}.txt"
        np.savetxt(path, np.column_stack(noisy_points(kind, 0.2, 1e-3, seed)), fmt="%.9f")
        profiles.append(wrcontact.Profile.from_file(path, kind, smoothing=0.0))
    system = wrcontact.ContactSystem(*profiles)
    wheel, rail, rail_y = system.profile_tables()
    y = np.arange(wheel[0], wheel[1], 5e-6)
    arm, radius = 0.75 + y, 0.46 + evaluate_table(wheel, y)[0]
    for shift in np.concatenate([np.linspace(-8e-3, 8e-3, 161), [-5.35e-3, -6.25e-3, 7.55e-3]]):
        state = system.evaluate(lateral_shift=shift, outputs="geometry")
        assert state.status == 0, shift
        for sign in (-1, 1):
            across = sign * shift + arm * np.cos(state.roll) - sign * radius * np.sin(state.roll) - rail_y
            below = sign * arm * np.sin(state.roll) + radius * np.cos(state.roll) - 0.46
            above = (across >= rail[0]) & (across <= rail[1])
            gap_there = evaluate_table(rail, across[above])[0] - below[above]
            # [m] what a cell of 32 um may hide
            assert state.vertical_shift - gap_there.min() < 2e-9, (shift, sign)


def on_rail(pair, place, y):
    """Whether the outline of a placed wheel is above the rail at wheel abscissa ``y`` [m]."""
    return gap.above_rail(pair, raster.rail_below(pair, place, y)) == 1


@pytest.mark.parametrize("shift", [-4e-3, -1e-3, 0.0, 2e-3, 5e-3])
def test_a_part_that_dips_a_hundredth_below_the_smallest_known_gap_is_searched(shift):
    """The gap around its minimum is a parabola, for which the bound of a part is sharp. Witness: dense sampling."""
    tables = layout.Tables.at(tables_of(wrcontact.ContactSystem()))
    work = layout.Work.at(np.zeros(layout.WORK_SIZE))
    work.inputs.lateral_shift = shift
    roll.place_both(tables, work.inputs, work.sides, 0.0)
    for side in range(2):
        pair, own, half = tables.pairs[side], work.sides[side], 0.03
        middle, samples = 0.0, 201
        while half > 1e-7:
            y = np.linspace(middle - half, middle + half, samples)
            gaps = np.array([gap.vertical_gap(pair, own.place, where)[0] for where in y])
            middle, half = y[gaps.argmin()], 2.0 * half / (samples - 1)
        low, high = middle - 2e-5, middle + 2e-5
        edge = min(gap.vertical_gap(pair, own.place, where)[0] for where in (low, high))
        own.best = known = edge - 0.99 * (edge - gaps.min())
        smallest_gap.search_cell(pair, own, -1e6, 1e6, low, high)
        assert own.best < known and own.best == pytest.approx(gaps.min(), abs=1e-13), (shift, side)


def test_every_place_of_the_wheel_lies_in_the_cell_that_is_found():
    """At random places, near the end, at every node and beside it; but for rounding."""
    system = wrcontact.ContactSystem()
    tables = layout.Tables.at(tables_of(system))
    scan = tables.pairs[1].scan
    nodes = np.array([scan.nodes[k].y for k in range(scan.count)])
    random = np.random.default_rng(5).uniform(nodes[0], nodes[-1], 500)
    near_the_end = nodes[-1] - np.geomspace(1e-9, 5e-3, 200)
    for y in [*random, *near_the_end, *nodes, *(nodes[1:] - 1e-9), *(nodes[:-1] + 1e-9)]:
        found = bounds.node_below(scan, y)
        assert 0 <= found < scan.count - 1 and nodes[found] <= y <= nodes[found + 1] + 1e-12, y


def test_the_least_slope_is_where_the_steepest_lines_meet():
    """Random slopes at both ends of a stretch that the bounds of its rise permit. Witness: at each place of a grid
    the slope is above both lines that bound it."""
    rng, steady = np.random.default_rng(6), 0
    for _ in range(500):
        width, least = rng.uniform(1e-4, 1e-2), rng.uniform(-50.0, 20.0)
        most = max(least, 0.0) + rng.exponential(30.0)
        first = rng.uniform(-0.3, 0.3)
        last = first + width * rng.uniform(least, most)
        way = np.linspace(0.0, width, 2001)
        lines = np.maximum(first + least * way, last - most * (width - way))
        found = bounds.least_slope(least, most, width, first, last)
        assert found == pytest.approx(lines.min(), abs=(most - least) * width / 1000), (
            least,
            most,
            first,
            last,
        )
        falls = -np.minimum(first + most * way, last - least * (width - way)).max()
        certain = max(found, falls)
        if abs(certain) > (most - least) * width / 1000:
            assert bounds.only_rises_or_falls(least, most, width, first, last) == (certain > 0.0)
            steady += certain > 0.0
    assert 100 < steady < 450
