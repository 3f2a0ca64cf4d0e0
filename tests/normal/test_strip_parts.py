"""Runs of strips that part, join or end, with stations and pressures written by hand."""

import numpy as np
import pytest

from tests.helpers.constant_curvatures import sweep_constant_curvatures, trace_constant_curvatures
from wrcontact.kernel.normal.strip_levels import deepen_levels
from wrcontact.kernel.normal.strip_runs import add_run, adopt_runs, renew_runs

A, FORCE = 1.0, 2e4


def one_run(pressures, strips=10, half=5e-3):
    """A problem of one run of half-width ``half`` [m] whose strips have these pressures at cosines of theirs,
    and the table of its number."""
    tables, work, _ = trace_constant_curvatures(A, A, FORCE, strips=strips)
    problem, waves = work.contact.strip_problem, tables.waves
    run = problem.runs[0]
    run.start, run.stop = run.next_start, run.next_stop = -half, half
    for i in range(strips):
        strip = problem.strips[i]
        strip.next_station = -half * waves.cos[i]
        strip.y = 1e-3 * pressures(-waves.cos[i])
        strip.next_half, strip.next_axis, strip.next_lead = 2e-3 * waves.sin[i], 2e-3, 1e-4
    return problem, waves


def edges(problem):
    return [(problem.runs[k].start, problem.runs[k].stop) for k in range(problem.run_count)]


def test_a_run_that_presses_everywhere_goes_on_with_its_strips():
    problem, waves = one_run(lambda s: np.sqrt(1 - s * s))
    renew_runs(problem, waves)
    assert edges(problem) == [(-5e-3, 5e-3)] and problem.count == waves.count
    assert problem.runs[0].origin == 0
    assert {problem.strips[i].axis for i in range(waves.count)} == {2e-3}
    assert {problem.strips[i].lead for i in range(waves.count)} == {1e-4}


def test_a_run_that_pulls_inside_is_two():
    """It is cut where the straight lines between strips cross zero; pressures are straight beside +-0.3."""
    problem, waves = one_run(lambda s: abs(s) - 0.3)
    renew_runs(problem, waves)
    (low, first), (second, high) = edges(problem)
    assert (low, high) == (-5e-3, 5e-3) and problem.count == 2 * waves.count
    assert first == pytest.approx(-1.5e-3, abs=1e-12) and second == pytest.approx(1.5e-3, abs=1e-12)
    # half-lengths by straight lines between the strips that were there, and no flatter than a quarter
    stations = [problem.strips[i].next_station for i in range(waves.count)]
    halves = [2e-3 * waves.sin[i] for i in range(waves.count)]
    axes = []
    for i in range(waves.count):
        station = 0.5 * (low + first) - 0.5 * (first - low) * waves.cos[i]
        axes.append(np.interp(station, stations, halves) / waves.sin[i])
    found = [problem.strips[i].axis for i in range(waves.count)]
    np.testing.assert_allclose(found, np.maximum(axes, 0.25 * max(axes)), rtol=1e-12)


def test_a_run_whose_end_pulls_is_shorter():
    problem, waves = one_run(lambda s: 0.8 - s)
    renew_runs(problem, waves)
    ((low, high),) = edges(problem)
    assert low == -5e-3 and high == pytest.approx(4e-3, abs=1e-12)


def test_a_strip_that_hardly_pulls_is_none():
    """Less than a thousandth of the largest pressure; an outermost strip pulls as it likes."""
    problem, waves = one_run(lambda s: 1.0 if s < 0.5 else -9e-4)
    renew_runs(problem, waves)
    assert edges(problem) == [(-5e-3, 5e-3)]
    problem, waves = one_run(lambda s: 1.0 if s < 0.98 else -1.0)
    renew_runs(problem, waves)
    assert edges(problem) == [(-5e-3, 5e-3)]


def test_a_single_strip_between_strips_that_pull_counts_from_a_tenth_on():
    for height, count in ((0.05, 1), (0.2, 2)):
        problem, waves = one_run(lambda s, height=height: 1.0 if s < 0 else height if 0.4 < s < 0.5 else -1.0)
        renew_runs(problem, waves)
        assert problem.run_count == count


@pytest.mark.parametrize(
    "start, wanted",
    [(9e-4, [(-4e-3, 3e-3)]), (1.1e-3, [(-4e-3, 3e-3)]), (1.3e-3, [(-4e-3, 1e-3), (1.3e-3, 3e-3)])],
)
def test_runs_of_one_curve_that_meet_are_one(start, wanted):
    """What is narrower than 2 % of the zone, 0.2 mm, is neither a run nor a gap between two."""
    problem, _ = one_run(lambda s: 1.0)
    problem.next_count = 0
    last = problem.traced_count - 1
    add_run(problem, 0, last, -4e-3, 1e-3)
    add_run(problem, 0, last, start, 3e-3)
    add_run(problem, 0, last, 3.5e-3, 3.5e-3 + 1e-9)  # too narrow
    adopt_runs(problem)
    assert edges(problem) == wanted
    assert problem.runs[0].origin == -1


def test_levels_that_were_raised_are_those_of_the_deeper_wheel():
    """They carry the force then: nothing is left to raise."""
    tables, work, exact = trace_constant_curvatures(A, A, FORCE, depth=0.8)
    problem = work.contact.strip_problem
    before = problem.traced[8].level
    rise = deepen_levels(problem, FORCE)
    assert rise > 0.1 * exact and problem.traced[8].level == pytest.approx(before + rise, rel=1e-12)
    assert deepen_levels(problem, FORCE) == pytest.approx(0.0, abs=1e-9 * exact)
    found = sweep_constant_curvatures(tables, work, FORCE)
    assert found[0] == pytest.approx(exact, rel=2e-3)
