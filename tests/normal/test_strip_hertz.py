"""Strips on constant curvatures, where Hertz's ellipse is the solution, piece by piece and together."""

import math

import numpy as np
import pytest

from data.hertz import MODULUS, hertz
from tests.helpers.constant_curvatures import (
    sweep_constant_curvatures,
    trace_constant_curvatures,
)
from wrcontact.kernel.normal import strip_pressures
from wrcontact.kernel.normal.strip_lengths import (
    TESTED,
    correct_lengths,
    edge_move,
    end_axis,
    limit_axis,
    move_edges,
)
from wrcontact.kernel.normal.strip_levels import deepen_levels
from wrcontact.kernel.normal.strip_runs import lay_strips

A, FORCE = 1.087, 78.5e3
RATIOS = (0.05, 0.1, 0.3, 1.0, 1.5, 5.0, 20.0, 60.0)


def strip_numbers(problem, name):
    return np.array([getattr(problem.strips[i], name) for i in range(problem.count)])


def solve(ratio, force=FORCE, squeeze=1.0, **given):
    """Relative errors in penetration, area and peak pressure (3,) with B/A = ``ratio``, and in the width; the
    first run is ``squeeze`` times as wide as it begins otherwise."""
    tables, work, _ = trace_constant_curvatures(A, ratio * A, force, **given)
    run = work.contact.strip_problem.runs[0]
    run.start, run.stop = squeeze * run.start, squeeze * run.stop
    found = sweep_constant_curvatures(tables, work, force)
    penetration, a, b, pressure = hertz(A, ratio * A, force)
    return (found / [penetration, math.pi * a * b, pressure] - 1, work.sides[1].totals.width / (2 * b) - 1)


# --- one sweep ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "count, middle, ends",
    [
        # measured 0.080, 0.049, 0.015 % in the middles; 2.6 % of the gap at the next strips to the
        # outermost, 0.9 % further in
        (8, 1.2e-3, (0.039, 0.013)),
        (10, 7.5e-4, (0.039, 0.013)),
        (16, 2.3e-4, (0.039, 0.013)),
    ],
)
@pytest.mark.parametrize("ratio", [0.1, 0.3, 1.0, 3.0, 10.0])
def test_hertz_s_pressures_displace_as_hertz_s_gap_wants(ratio, count, middle, ends):
    """In the middles the displacement is the penetration less the gap (of the penetration), and at 0.9 of the
    half-lengths it is less by as much as the gap rises (of that); eqs. (S3), (S6), (S11), (S12)."""
    tables, work, exact = trace_constant_curvatures(A, ratio * A, FORCE, strips=count)
    problem, waves = work.contact.strip_problem, tables.waves
    _, a, b, pressure = hertz(A, ratio * A, FORCE)
    problem.runs[0].start, problem.runs[0].stop = -b, b
    for i in range(count):
        problem.strips[i].axis = a
    lay_strips(problem, waves, True)
    for i in range(count):
        problem.strips[i].y = pressure * waves.sin[i] / (math.pi * MODULUS)
    strip_pressures.see_pairs(problem)
    strip_pressures.write_equations(tables, problem, work.contact.equations, False)
    rows = np.frombuffer(work.contact.equations).reshape(len(work.contact.equations), -1)
    displaced = rows[:count, :count] @ strip_numbers(problem, "y")
    station, half = strip_numbers(problem, "station"), strip_numbers(problem, "half_length")
    np.testing.assert_allclose(half, a * np.sqrt(1 - (station / b) ** 2), rtol=1e-12)
    np.testing.assert_allclose(strip_numbers(problem, "gap"), ratio * A * station**2, atol=1e-12 * exact)
    np.testing.assert_allclose(displaced, exact - ratio * A * station**2, atol=middle * exact)
    beside = [
        strip_pressures.local_displacement(tables, problem, 0, i)
        + np.mean(strip_pressures.tested_displacements(tables, problem, i, TESTED * half[i], False))
        for i in range(count)
    ]
    error = (displaced - beside) / (A * (TESTED * half) ** 2) - 1
    assert np.all(np.abs(error[[1, -2]]) < ends[0]), error
    assert np.all(np.abs(error[2:-2]) < ends[1]), error


@pytest.mark.parametrize("ratio", RATIOS)
def test_first_strips_are_hertz_s(ratio):
    """Edges and half-lengths from ANALYN's levels, by straight lines between stations: measured 1.0 % and, in
    the inner half, 0.7 %."""
    _, work, _ = trace_constant_curvatures(A, ratio * A, FORCE)
    problem = work.contact.strip_problem
    _, a, b, _ = hertz(A, ratio * A, FORCE)
    assert problem.run_count == 1 and problem.count == 10
    assert -problem.runs[0].start == pytest.approx(problem.runs[0].stop, rel=1e-9)
    assert problem.runs[0].stop == pytest.approx(b, rel=0.015)
    np.testing.assert_allclose(strip_numbers(problem, "axis")[2:-2], a, rtol=0.01)


@pytest.mark.parametrize("depth", [0.6, 0.9])
@pytest.mark.parametrize("ratio", [0.1, 1.0, 10.0])
def test_levels_are_raised_until_they_carry_the_force(ratio, depth):
    """Of a wheel that is sunk by 0.6 or 0.9 of Hertz's penetration, to that penetration; measured 0.5 ... 1 %
    below it, as a sum over sixteen stations has it."""
    _, work, exact = trace_constant_curvatures(A, ratio * A, FORCE, depth=depth)
    rise = deepen_levels(work.contact.strip_problem, FORCE)
    assert depth + rise / exact == pytest.approx(1.0, abs=0.015)


def test_the_outermost_axis_is_that_of_a_parabola():
    """Axes that are c + d t^2, t = 1/2, 3/2, 5/2 steps from the edge; within 0.6 ... 1.6 of the next one.
    The lead moves as the next one's."""
    _, work, _ = trace_constant_curvatures(A, A, FORCE)
    first, inner, second = (work.contact.strip_problem.strips[i] for i in range(3))
    for c, d in ((4e-3, 3e-4), (5e-3, -2e-4), (1.0, 0.0)):
        inner.next_axis, second.next_axis = c + 9 * d, c + 25 * d
        first.lead, inner.lead, inner.next_lead = 1e-3, 5e-4, 7e-4
        end_axis(first, inner, second)
        assert first.next_axis == pytest.approx(c + d, rel=1e-12)
        assert first.next_lead == pytest.approx(1.2e-3, rel=1e-12)
    for after, share in ((9.0, 0.6), (0.1, 1.45), (-9.0, 1.6)):
        inner.next_axis, second.next_axis = 1.0, after
        end_axis(first, inner, second)
        assert first.next_axis == pytest.approx(share, rel=1e-12)


# --- edges ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("shift", [0.0, 2e-3])
def test_edges_move_to_where_a_line_contact_ends(shift):
    """A cylinder's pressure p on an interval that is wrong by d at its ends: to first order in d, p sin t is
    h sin^2 t + d.  The edges of the next sweep are right but for the square of d, eq. (S14)."""
    half = 5e-3
    for low, high in ((1e-5, 1e-5), (-2e-5, -2e-5), (1e-5, -3e-5), (0.0, 2e-5)):
        tables, work, _ = trace_constant_curvatures(A, A, FORCE)
        problem, waves = work.contact.strip_problem, tables.waves
        run, zone = problem.runs[0], problem.zones[0]
        zone.start, zone.stop = shift - 1.0, shift + 1.0
        run.start, run.stop = shift - half, shift + half
        for i in range(waves.count):
            # the pressure ends at -half - low and half + high
            cosine = waves.cos[i]
            product = half * waves.sin[i] ** 2 + (low * (1 + cosine) + high * (1 - cosine)) / 2
            problem.strips[i].y = 1e-3 * product / waves.sin[i]
        move_edges(problem, waves, run, 0, 1.0)
        assert run.next_start - shift == pytest.approx(-half - low, abs=0.02 * abs(low) + 1e-12)
        assert run.next_stop - shift == pytest.approx(half + high, abs=0.02 * abs(high) + 1e-12)
        move_edges(problem, waves, run, 0, 0.5)
        assert run.next_stop - shift == pytest.approx(half + 0.5 * high, abs=0.02 * abs(high) + 1e-12)


def test_no_edge_moves_far():
    """By no more than a quarter of half the run, the same way outwards and inwards; small moves in full."""
    assert edge_move(2.0, 1e-4, 0.0) == pytest.approx(2e-4, rel=1e-6)
    assert edge_move(2.0, 1e6, 0.3) == -edge_move(2.0, -1e6, -0.3) == pytest.approx(0.5, rel=1e-9)


def test_an_edge_that_swings_swings_less():
    """Back by no more than it came and a twentieth of half the run together; short moves are no swing."""
    assert edge_move(2.0, 1e6, -0.1) == -edge_move(2.0, -1e6, 0.1) == pytest.approx(0.5 * 0.2 / 0.7, rel=1e-9)
    assert edge_move(2.0, 1e-4, -1e-3) == pytest.approx(2e-4, rel=2e-3)


def test_no_axis_is_much_longer_than_those_beside_it():
    _, work, _ = trace_constant_curvatures(A, A, FORCE)
    before, strip, after = (work.contact.strip_problem.strips[i] for i in range(3))
    before.axis, after.axis = 2.0, 1.0
    for wanted, found in ((9.0, 3.0), (2.9, 2.9)):
        strip.next_axis = wanted
        limit_axis(before, strip, after)
        assert strip.next_axis == pytest.approx(found, rel=1e-12)


@pytest.mark.parametrize(
    "squeeze, sweeps, width, errors",
    [
        # measured 0.10, 0.05, 0.92 % of the width; 0.13, 0.16, 0.15, then 0.25, 0.20, 0.28 and 0.38, 0.60, 0.39 %
        # of penetration, area and peak
        (0.9, 12, 1.5e-3, (2e-3, 2.4e-3, 2.3e-3)),
        (1.1, 12, 1.5e-3, (2e-3, 2.4e-3, 2.8e-3)),
        (0.7, 6, 0.014, (5.7e-3, 9e-3, 5.9e-3)),
    ],
)
@pytest.mark.parametrize("ratio", [0.1, 1.0, 10.0])
def test_runs_that_begin_wrong_end_right(ratio, squeeze, sweeps, width, errors):
    found, wide = solve(ratio, squeeze=squeeze, sweeps=sweeps)
    assert abs(wide) < width, wide
    assert np.all(np.abs(found) < errors), found


# --- all sweeps -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "strips, sweeps, allowed",
    [
        # measured 0.049, 0.253, 0.740 %, 0.055, 0.156, 0.186 % and 0.033, 0.081, 0.031 % at most
        (8, 4, (7.5e-4, 3.9e-3, 7.5e-3)),
        (10, 6, (8.5e-4, 2.4e-3, 2.8e-3)),
        (16, 20, (5e-4, 1.3e-3, 5e-4)),
    ],
)
@pytest.mark.parametrize("ratio", RATIOS)
def test_strips_on_constant_curvatures_are_hertz(ratio, strips, sweeps, allowed):
    """Whatever the load: the coarsest, the usual and the finest."""
    error, wide = solve(ratio, strips=strips, sweeps=sweeps)
    assert np.all(np.abs(error) < allowed), error
    assert abs(wide) < 4e-3
    if strips == 8:
        light, _ = solve(ratio, force=1e-3, strips=strips, sweeps=sweeps)
        np.testing.assert_allclose(light, error, atol=1e-9)


@pytest.mark.parametrize("ratio", [0.1, 1.0, 20.0])
def test_errors_fall_with_strips_and_sweeps(ratio):
    """Of 10 strips from 1 sweep to 12; of 12 sweeps from 6 strips to 16."""
    by_sweeps = [np.abs(solve(ratio, sweeps=sweeps)[0]).max() for sweeps in (1, 12)]
    by_strips = [np.abs(solve(ratio, strips=strips, sweeps=12)[0]).max() for strips in (6, 16)]
    # measured 0.59, 0.40, 1.00 and 0.16, 0.08, 0.09 %; 0.68, 0.25, 0.24 and 0.08, 0.02, 0.08 %
    assert by_sweeps[1] < 0.4 * by_sweeps[0], by_sweeps
    assert by_strips[1] < 0.5 * by_strips[0], by_strips


@pytest.mark.parametrize("ratio", [0.003, 300.0])
def test_very_long_and_very_wide_patches(ratio):
    """Strips that lie farther apart than they are long count by their spacing: measured 0.08, 0.60, 2.0 %."""
    assert np.all(np.abs(solve(ratio)[0]) < (1.3e-3, 9e-3, 0.03))
    # 0.04, 0.09, 0.38 %
    assert np.all(np.abs(solve(ratio, strips=16, sweeps=20)[0]) < (6e-4, 1.4e-3, 5.8e-3))


@pytest.mark.parametrize("ratio", [0.1, 1.0, 10.0])
def test_a_share_of_the_penetration_is_that_share(ratio):
    """Where 0.9 of the penetration comes along the normal, it is a ninth larger, and all else is the same,
    but for other stations; measured 0.03 % and 0.09 %."""
    plain, _ = solve(ratio)
    shared, _ = solve(ratio, share=0.9)
    assert (1 + shared[0]) * 0.9 == pytest.approx(1 + plain[0], abs=6e-4)
    np.testing.assert_allclose(shared[1:], plain[1:], atol=1.4e-3)


@pytest.mark.parametrize("ratio", [0.1, 1.0, 10.0])
def test_area_and_pressure_are_those_on_the_curve_between_wheel_and_rail(ratio):
    """Where that is 0.9 times as long as the rail, B is 1 / 0.81 times as large on it; measured 0.07, 0.15
    and 0.07 % from Hertz's ellipse for that."""
    tables, work, _ = trace_constant_curvatures(A, ratio * A, FORCE, stretch=0.9)
    found = sweep_constant_curvatures(tables, work, FORCE)
    penetration, a, b, pressure = hertz(A, ratio * A / 0.81, FORCE)
    np.testing.assert_allclose(found, [penetration, math.pi * a * b, pressure], rtol=2.3e-3)


def peaks_at_a_joint(at, strips, sweeps):
    """Peak pressure [Pa] where B is A before a joint and 3 A behind it."""
    place = at * hertz(A, A, FORCE)[2]

    def rise(s):
        return A * s * s + 2 * A * max(s - place, 0.0) ** 2

    def slope(s):
        return 2 * A * s + 4 * A * max(s - place, 0.0)

    tables, work, _ = trace_constant_curvatures(A, A, FORCE, strips=strips, sweeps=sweeps, gap=(rise, slope))
    return sweep_constant_curvatures(tables, work, FORCE)[2]


@pytest.mark.parametrize(
    "at, allowed",
    [
        # measured 0.03, 0.06, 0.29 %; 2.2, 2.2 and 1.1 % without the fine part
        (0.0, 5e-4),
        (0.2, 9e-4),
        (0.45, 4.4e-3),
    ],
)
def test_the_peak_of_a_gap_with_a_joint(at, allowed):
    """The curvature changes threefold at a share of the half-width: 8 strips have the peak of 16 strips after
    20 sweeps, eq. (S13)."""
    few, many = peaks_at_a_joint(at, 8, 12), peaks_at_a_joint(at, 16, 20)
    assert few == pytest.approx(many, rel=allowed), few / many - 1


def test_middles_beside_the_ridge_move_towards_it():
    """Displacements are alike to both sides of middles that lie on one line, a little before the ridge:
    by the gap alone they come back by 0.6 of the way, eq. (S7)."""
    tables, work, exact = trace_constant_curvatures(A, A, FORCE)
    problem = work.contact.strip_problem
    for i in range(problem.count):
        problem.strips[i].lead = 1e-4
    lay_strips(problem, tables.waves, True)
    strip_pressures.solve_pressures(tables, problem, work.contact.equations, FORCE, False, True)
    correct_lengths(tables, problem, exact, True, 1.0)
    np.testing.assert_allclose(strip_numbers(problem, "next_lead"), 4e-5, rtol=1e-6)
