"""What two samples of an overlap say of the deepest points between them, against the overlap itself: its
slope along the rail's normals, in steps of some 40 micrometres."""

import warnings

import numpy as np

import wrcontact
from data.noisy_profiles import noisy_points
from tests.helpers.inside import counts_of, tables_of
from wrcontact.kernel import layout
from wrcontact.kernel.contact.overlap_samples import DEEPEST, falling_exponent, sample_overlap
from wrcontact.kernel.contact.turning_cells import SLOPE_STEP, UNCLEAR, count_turns
from wrcontact.kernel.search import roll
from wrcontact.kernel.surface import gap
from wrcontact.kernel.surface.locus import outline_point
from wrcontact.kernel.surface.tables import height_slope, height_slope_bend
from wrcontact.profiles import ProfileWarning

YAWS = (0.0, 0.02, 0.0, 0.05)  # [rad]
PARTS = 16  # of a cell


def slopes(pair, place, height, y):
    """F, the rail's slope less the outline's, at the feet x of the normals through the wheel's points ``y``
    (n,) [m], and the overlap there."""
    found = []
    for where in y:
        z, slope = height_slope(pair.wheel, where)
        y_track, z_track, outline_slope = outline_point(place, where, z, slope)
        across, down = y_track - pair.rail_y, z_track + height
        x = across
        for _ in range(8):
            z_rail, m, bend = height_slope_bend(pair.rail, x)
            x += (across - x + (down - z_rail) * m) / (1.0 + m * m - (down - z_rail) * bend)
        z_rail, m = height_slope(pair.rail, x)
        found.append((m - outline_slope, (down - z_rail - m * (across - x)) / np.sqrt(1.0 + m * m)))
    return np.array(found).T


def cells(system, count, seed):
    """Cells of random placements in which wheel and rail overlap by up to 0.25 mm, and how often the overlap
    turns in them according to the samples."""
    rng = np.random.default_rng(seed)
    tables = layout.Tables.at(tables_of(system))
    pair, work = tables.pairs[1], layout.Work.at(np.zeros(layout.WORK_SIZE))
    place, overlap = work.sides[1].place, work.contact.overlap
    nodes = [pair.scan.nodes[node].y for node in range(pair.scan.count)]
    for trial in range(count):
        work.inputs.lateral_shift = rng.uniform(-0.0065, 0.0065)
        work.inputs.yaw = YAWS[trial % len(YAWS)]
        roll.place_both(tables, work.inputs, work.sides, rng.uniform(-0.002, 0.002))
        gaps = np.array(
            [gap.vertical_gap(pair, place, y)[0] if on_rail(pair, place, y) else 1.0 for y in nodes]
        )
        overlap.height = gaps.min() + 10.0 ** rng.uniform(-5.0, -3.6)
        near = np.flatnonzero(gaps < overlap.height + 3e-5)
        for node in near[:-1]:
            if node + 1 in near:
                sample_overlap(pair, overlap.samples, place, int(node), overlap.height, 1)
                sample_overlap(pair, overlap.samples, place, int(node) + 1, overlap.height, 2)
                yield (
                    pair,
                    place,
                    overlap,
                    (nodes[node], nodes[node + 1]),
                    count_turns(pair, overlap, place, 1),
                    (work.inputs.lateral_shift, work.inputs.yaw),
                )


def on_rail(pair, place, y):
    """Whether the wheel's point is above the rail."""
    z, slope = height_slope(pair.wheel, y)
    return pair.rail.start <= outline_point(place, y, z, slope)[0] - pair.rail_y <= pair.rail.stop


def noisy_system(folder):
    """A wheel and a rail with noise, as read."""
    profiles = {}
    for kind in ("wheel", "rail"):
        np.savetxt(folder / f"{kind}.txt", np.transpose(noisy_points(kind, 0.2, 0.005, 3)), fmt="%.9f")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ProfileWarning)
            profiles[kind] = wrcontact.Profile.from_file(folder / f"{kind}.txt", kind)
    return wrcontact.ContactSystem(**profiles)


def checked_cells(system, count, seed):
    """How many cells are judged to hold no deepest point, one, or are unclear; each is looked into."""
    seen = [0, 0, 0]
    for pair, place, overlap, (low, high), turns, pose in cells(system, count, seed):
        seen[turns] += 1
        if turns == UNCLEAR:
            continue
        where = (low, overlap.height, *pose)
        y = np.linspace(low, high, PARTS + 1)
        slope, depth = slopes(pair, place, overlap.height, y)
        ends = np.array([slope[0] - overlap.cell.first, slope[-1] - overlap.cell.last])
        assert np.all(np.abs(ends) <= overlap.cell.error), where
        # the overlap turns where F comes up through zero: past steps of the slope at joints
        signs = slope[np.abs(slope) > SLOPE_STEP] > 0.0
        rises = int(np.count_nonzero(~signs[:-1] & signs[1:]))
        if not depth.max() > 0.0:
            continue
        assert rises == turns, where
        if overlap.cell.jump == 0.0:
            line = np.interp(
                0.5 * (y[1:] + y[:-1]), (low, high), (overlap.cell.first_bend, overlap.cell.last_bend)
            )
            bend = np.diff(slope) / np.diff(y)
            allowed = overlap.cell.departure + 2.0 * SLOPE_STEP / np.diff(y)
            assert np.all(np.abs(bend - line) <= allowed), where
    return seen


def stretches(system, count, seed):
    """Where the overlap is said to fall from a node on: slope of the overlap against the way, in steps of some
    100 micrometres, and how many cells each stretch has; at random placements, both ways."""
    for pair, place, overlap, (low, high), _, pose in cells(system, count, seed):
        scan, samples = pair.scan, overlap.samples
        for entry, direction in ((2, 1), (1, -1)):
            node = int(samples.node[entry])
            depth = overlap.height - samples.gap[entry]
            slope = -direction * (samples.rise[entry] + samples.turn[entry])
            if not (slope > 0.0 and 0.0 < depth < DEEPEST):
                continue
            exponent = falling_exponent(
                scan, place, node, direction, samples.rail[entry], depth, slope, layout.EXPONENTS - 1
            )
            if exponent < 0:
                yield 0, np.zeros(0), pose
                continue
            ends = sorted((scan.nodes[node].y, scan.nodes[node + direction * 2**exponent].y))
            y = np.linspace(*ends, 6 * 2**exponent + 1)
            y = y[[on_rail(pair, place, where) for where in y]]
            falls, depths = slopes(pair, place, overlap.height, y)
            yield 2**exponent, direction * falls[depths > 0.0], pose


def checked_stretches(system, count, seed):
    """How many cells the stretches have together over how many nodes they begin from; in each the overlap falls."""
    found = list(stretches(system, count, seed))
    for _, falls, pose in found:
        assert np.all(falls > 0.0), (pose, falls.min())
    return sum(cells for cells, *_ in found) / len(found)


def test_overlaps_fall_over_the_stretches_that_are_left_out(tmp_path):
    """Along the rail's normals, on standard profiles and on those with noise."""
    for rail, inclination, seed in (("UIC60", 1 / 40, 8), ("54E1", 1 / 20, 9)):
        system = wrcontact.ContactSystem(rail=rail, rail_inclination=inclination)
        assert checked_stretches(system, 12, seed) > 2.0
    assert checked_stretches(noisy_system(tmp_path), 12, 10) > 0.5


def test_answers_are_the_same_where_no_stretch_is_left_out():
    """With bounds that let no overlap count as one that only falls, a tenth more places are looked at."""
    rng = np.random.default_rng(12)
    pose = rng.uniform(-8e-3, 8e-3, 200), rng.uniform(-0.04, 0.04, 200), 10.0 ** rng.uniform(3.5, 5.3, 200)
    usual, whole = (wrcontact.ContactSystem(rail="54E1", rail_inclination=1 / 20) for _ in range(2))
    for pair in layout.Tables.at(tables_of(whole)).pairs:
        for k in range(int(pair.scan.rail_count)):
            pair.scan.rail[k].turns[:] = [1e9] * (layout.EXPONENTS + 1)
    found, wanted = (system.evaluate_many(*pose).values for system in (usual, whole))
    np.testing.assert_allclose(found, wanted, rtol=1e-9, atol=1e-9)
    counts = []
    for system in (usual, whole):
        stepper = system.stepper()
        for shift, yaw, force in zip(*pose):
            stepper.inputs[:2], stepper.inputs[stepper.place("normal_force")] = (shift, yaw), force
            assert stepper.step() == 0
        counts.append(counts_of(stepper)["gap"])
    assert counts[1] > 1.08 * counts[0]


def test_cells_of_standard_profiles_turn_as_often_as_their_samples_say():
    """S1002 on three rails: most cells are judged, with one deepest point or none."""
    for rail, inclination, seed in (("UIC60", 1 / 40, 5), ("54E1", 1 / 20, 6)):
        none, one, unclear = checked_cells(
            wrcontact.ContactSystem(rail=rail, rail_inclination=inclination), 12, seed
        )
        assert none > 100 and one > 8 and unclear < 0.03 * none, (none, one, unclear)


def test_cells_of_measured_profiles_turn_as_often_as_their_samples_say(tmp_path):
    """Profiles with noise, as read: their bends jump nowhere and wave everywhere."""
    none, one, unclear = checked_cells(noisy_system(tmp_path), 30, 7)
    assert none > 300 and one > 20 and unclear < 0.1 * none, (none, one, unclear)
