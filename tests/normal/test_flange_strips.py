"""Strips of yawed wheels on their flanges, where tread, fillet and flange carry load together, against the
half-space, and against ANALYN in random poses."""

import math

import numpy as np
import pytest

import wrcontact
from data.make_flange_strips import RESULTS, answer, rows
from tests.helpers.constant_curvatures import sweep_constant_curvatures, trace_constant_curvatures
from tests.helpers.inside import tables_of, work_of
from wrcontact import Status
from wrcontact.kernel import layout
from wrcontact.kernel.contact.penetration_maxima import merge_points
from wrcontact.kernel.normal.strip_contact import agrees_with_levels
from wrcontact.kernel.normal.strip_runs import add_run, adopt_runs
from wrcontact.kernel.surface.tables import height_slope

ROWS = rows()
#: Load, largest pressure, penetration and area may be off by so much.  Measured: 0.13, 7.7, 1.5 and 4.8 %;
#: where one zone is a shoulder of another, up to 2 MN, 1.0, 6.9, 1.2 and 5.6 %.
BOUNDS = dict.fromkeys(("skew", "share", "regions", "sliver"), (3e-3, 0.09, 0.018, 0.06))
BOUNDS["shoulder"] = (0.012, 0.08, 0.014, 0.07)
#: Of ANALYN where a wheel has four regions; measured: 1.4, 1.5 and 5 %.
ANALYN_BOUNDS = (1e-6, 0.02, 0.02, 0.06)


def truth(row):
    return np.array([float(row[f"found_{name}"]) for name in RESULTS])


@pytest.mark.parametrize("row", ROWS, ids=[f"{i}-{row['cause']}" for i, row in enumerate(ROWS)])
def test_half_space_where_strips_were_wrong_by_far(row):
    """Loads were up to 80 and pressures up to 3000 times too large, or half as large as they are."""
    status, found = answer(row, normal_model="analyn_strip")
    assert status == Status.VALID
    error = np.array(found) / truth(row) - 1
    assert np.all(np.abs(error) <= BOUNDS[row["cause"]]), error.round(4)


@pytest.mark.parametrize("row", [row for row in ROWS if row["cause"] == "regions"])
def test_analyn_has_all_four_regions(row):
    """With three of them, the flange was left out, and pressures were down to 0.41 of these."""
    status, found = answer(row, normal_model="analyn")
    assert status == Status.VALID
    error = np.array(found) / truth(row) - 1
    assert np.all(np.abs(error) <= ANALYN_BOUNDS), error.round(4)


# --- random poses -------------------------------------------------------------------------------------------


TRACKS = [(rail, inclination) for rail in ("54E1", "60E1", "UIC60") for inclination in (1 / 20, 1 / 40)]
WANTED = ["right.normal_force", "right.max_pressure", "right.penetration", "status"]


def flange_poses(count, seed, track, mode):
    """Random inputs by name (count,) of flange contact, rigid under 20 ... 400 kN, or lowered by 0.03 ... 0.6
    mm."""
    rng = np.random.default_rng([seed, TRACKS.index(track), mode == "compliant"])
    given = {
        "lateral_shift": rng.uniform(4.5e-3, 8.5e-3, count),
        "yaw": rng.uniform(15e-3, 30e-3, count) * rng.choice([-1, 1], count),
    }
    if mode == "rigid":
        return given | {"normal_force": np.exp(rng.uniform(np.log(20e3), np.log(400e3), count))}
    stands = wrcontact.ContactSystem(rail=track[0], rail_inclination=track[1])
    stands = stands.evaluate_many(outputs=["vertical_shift", "roll"], **given)
    lowered = stands["vertical_shift"] + rng.uniform(0.03e-3, 0.6e-3, count)
    return given | {"vertical_shift_input": lowered, "roll_input": stands["roll"]}


@pytest.mark.full
@pytest.mark.parametrize(
    "count, seed", [(2000, 12), pytest.param(60_000, 13, marks=pytest.mark.complete)], ids=["some", "many"]
)
@pytest.mark.parametrize("mode", ["rigid", "compliant"])
@pytest.mark.parametrize("track", TRACKS, ids=str)
def test_strips_and_analyn_agree_on_random_flange_poses(track, mode, count, seed):
    """Two models that share little but the regions.  On poses where they part most, 37 and 95 % in peak, half
    of the difference was ANALYN's error against the half-space."""
    given = flange_poses(count, seed, track, mode)
    found = {}
    for model in ("analyn", "analyn_strip"):
        system = wrcontact.ContactSystem(
            rail=track[0], rail_inclination=track[1], contact_mode=mode, normal_model=model
        )
        found[model] = system.evaluate_many(side="right", outputs=WANTED, **given)
    assert np.all(found["analyn_strip"]["status"] == found["analyn"]["status"])
    valid = found["analyn"]["status"] == Status.VALID
    assert valid.mean() > 0.99
    # measured with seeds 8 and 9: 0.67 ... 1.06, 0.63 ... 1.63 and 0.87 ... 1.18
    for name, low, high in zip(WANTED, (0.6, 0.55, 0.8), (1.15, 2.0, 1.3)):
        ratio = found["analyn_strip"][name][valid] / found["analyn"][name][valid]
        assert np.all((ratio > low) & (ratio < high)), (name, ratio.min(), ratio.max())


#: Elastic, vertical load, 60E1 1:40: a sliver of a run had 16 GPa, and the wheel 8.6 GN instead of 0.56 MN.
JAGGED = {
    "lateral_shift": 0.006161073825503355,
    "yaw": -0.02965957796831644,
    "normal_force": 348481.0680153373,
}


def test_an_elastic_flange_carries_a_vertical_load():
    """As far as ANALYN, around the pose at which it did not."""
    given = {name: np.full(9, value) for name, value in JAGGED.items()}
    given["lateral_shift"] = JAGGED["lateral_shift"] + np.linspace(-4e-6, 4e-6, 9)
    forces = []
    for model in ("analyn", "analyn_strip"):
        system = wrcontact.ContactSystem(
            rail="60E1", rail_inclination=1 / 40, contact_mode="elastic", normal_model=model, load="vertical"
        )
        found = system.evaluate_many(outputs=["right.normal_force", "status"], **given)
        assert np.all(found["status"] == Status.VALID)
        forces.append(found["right.normal_force"])
    np.testing.assert_allclose(forces[1], forces[0], rtol=0.03)  # measured 1.6 %
    assert np.ptp(forces[1]) < 0.02 * forces[1].mean()  # 1.2 kN for each micrometre


# --- the guard, runs and regions ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    "strips, level, agrees",
    [(1.0, 1.0, True), (1.0, 4.0, False), (1.0, 0.25, False), (-1.0, 1.0, False), (math.nan, 1.0, False)],
)
def test_strips_that_part_from_the_levels_are_no_answer(strips, level, agrees):
    """Hertz's contact, of which the pressures of the strips, or the levels, are multiplied."""
    A, force = 2.0, 5e4
    tables, work, _ = trace_constant_curvatures(A, A, force)
    problem = work.contact.strip_problem
    sweep_constant_curvatures(tables, work, force)
    for i in range(problem.count):
        problem.strips[i].y *= strips
    for i in range(problem.traced_count):
        problem.traced[i].level *= level
    assert agrees_with_levels(tables, problem) is agrees


def test_a_spike_of_pressure_is_no_answer():
    """One strip at an edge, which carries next to nothing."""
    tables, work, _ = trace_constant_curvatures(2.0, 2.0, 5e4)
    problem = work.contact.strip_problem
    sweep_constant_curvatures(tables, work, 5e4)
    assert agrees_with_levels(tables, problem)
    problem.strips[0].y *= 20.0
    assert not agrees_with_levels(tables, problem)


def test_where_there_is_no_room_the_narrowest_run_goes():
    _, work, _ = trace_constant_curvatures(1.0, 1.0, 2e4)
    problem = work.contact.strip_problem
    last = problem.traced_count - 1
    problem.next_count = 0
    widths = (5e-4, 3e-4, 4e-4, 6e-4, 7e-4, 8e-4, 2.6e-4, 9e-4)  # each wide enough for a run
    for i, width in enumerate(widths):
        start = 1.5e-3 * (i - 4)
        add_run(problem, 0, last, start, start + width)
    adopt_runs(problem)
    found = [problem.runs[k].stop - problem.runs[k].start for k in range(problem.run_count)]
    assert problem.run_count == layout.STRIP_RUN_LIMIT
    assert found == pytest.approx([5e-4, 4e-4, 6e-4, 7e-4, 8e-4, 9e-4], rel=1e-9)


def test_of_too_many_deepest_points_the_one_touched_last_goes():
    """A flange, 72 degrees steep, is the least deep along its normal, but was touched first."""
    system = wrcontact.ContactSystem()
    pair = layout.Tables.at(tables_of(system)).pairs[1]
    overlap = work_of(system.stepper()).contact.overlap
    rail = (pair.rail.start + 0.2e-3, -25e-3, -10e-3, 0.0, 10e-3)
    depth = (80e-6, 95e-6, 110e-6, 120e-6, 130e-6)
    overlap.count = len(rail)
    for i, point in enumerate(zip(rail, depth)):
        overlap.points[i].rail, overlap.points[i].depth = point
        overlap.points[i].between = -1e-6
    merge_points(pair, overlap)
    kept = [overlap.points[i].rail for i in range(overlap.count)]
    slope = [(height_slope(pair.rail, y + 1e-7)[0] - height_slope(pair.rail, y)[0]) / 1e-7 for y in rail]
    fallen = np.array(depth) * np.hypot(1.0, slope)
    assert np.argmin(depth) == 0 and np.argmin(fallen) != 0 and abs(slope[0]) > 1.0
    assert kept == [y for i, y in enumerate(rail) if i != np.argmin(fallen)]
