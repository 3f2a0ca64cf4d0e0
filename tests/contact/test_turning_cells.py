"""What two samples of an overlap say of the deepest points between them, against the overlap itself: its
slope along the rail's normals, in steps of some 40 micrometres."""

import warnings

import numpy as np

import wrcontact
from data.noisy_profiles import noisy_points
from tests.helpers.inside import tables_of
from wrcontact.kernel import layout
from wrcontact.kernel.contact.overlap_samples import sample_overlap
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


def test_cells_of_standard_profiles_turn_as_often_as_their_samples_say():
    """S1002 on three rails: most cells are judged, with one deepest point or none."""
    for rail, inclination, seed in (("UIC60", 1 / 40, 5), ("54E1", 1 / 20, 6)):
        none, one, unclear = checked_cells(
            wrcontact.ContactSystem(rail=rail, rail_inclination=inclination), 12, seed
        )
        assert none > 100 and one > 8 and unclear < 0.03 * none, (none, one, unclear)


def test_cells_of_measured_profiles_turn_as_often_as_their_samples_say(tmp_path):
    """Profiles with noise, as read: their bends jump nowhere and wave everywhere."""
    profiles = {}
    for kind in ("wheel", "rail"):
        np.savetxt(tmp_path / f"{kind}.txt", np.transpose(noisy_points(kind, 0.2, 0.005, 3)), fmt="%.9f")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ProfileWarning)
            profiles[kind] = wrcontact.Profile.from_file(tmp_path / f"{kind}.txt", kind)
    none, one, unclear = checked_cells(wrcontact.ContactSystem(**profiles), 30, 7)
    assert none > 300 and one > 20 and unclear < 0.1 * none, (none, one, unclear)
