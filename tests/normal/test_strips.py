"""The strip correction: its influence function and solver, Hertz, the complete theory, and what no step may do to it."""

import functools
import math

import numpy as np
import pytest
from scipy.integrate import quad

import wrcontact
from tests.helpers.constant_curvatures import MODULUS, hertz, lay_constant_curvatures
from tests.helpers.planar_cases import planar_cases
from tests.reference import brute_force, halfspace_reference
from wrcontact import Status
from wrcontact.kernel import layout
from wrcontact.kernel.binding.hertz_table import hertz_table
from wrcontact.kernel.binding.influence_table import RANGE, influence, influence_table
from wrcontact.kernel.layout import InfluenceTable
from wrcontact.kernel.normal import analyn, strip_surfaces
from wrcontact.kernel.normal.elimination import eliminate
from wrcontact.kernel.normal.hertz import (
    STEEPEST,
    hertz_coefficients,
    skewed_coefficients,
    upright_coefficients,
)
from wrcontact.kernel.normal.strip_influence import line_influence, near_share
from wrcontact.kernel.normal.strip_patches import fill_from_strips
from wrcontact.kernel.normal.strip_placement import place_strips
from wrcontact.kernel.normal.strips import solve_strips
from wrcontact.profiles.profile import Profile
from wrcontact.profiles.zones import Arc

TABLE = layout.HertzTable.at(hertz_table())
NAMES = ("penetration", "area", "max_pressure")
EXTENT = (*NAMES, "patch_length", "patch_width")
POSE = [layout.IN_LATERAL_SHIFT, layout.IN_YAW, layout.IN_NORMAL_FORCE]     # what random poses differ in


def system_of(model="analyn_strip", **parameters):
    return _system_of(model, tuple(sorted(parameters.items())))


@functools.lru_cache
def _system_of(model, parameters):
    return wrcontact.ContactSystem(normal_model=model, **dict(parameters))


def errors(side, truth):
    """Relative errors in penetration, area and peak pressure (3,)."""
    return np.array([getattr(side, name) / getattr(truth, name) - 1 for name in NAMES])


def random_poses(count, seed, low=3e3, high=2e5):
    """Inputs (count, 7): S1002's tread to flange, ``low`` to ``high`` N, half of them with up to 2 degrees of yaw."""
    rng = np.random.default_rng(seed)
    rows = np.zeros((count, layout.INPUT_COUNT))
    rows[:, layout.IN_LATERAL_SHIFT] = rng.uniform(-6.6e-3, 6.6e-3, count)
    rows[:, layout.IN_YAW] = np.radians(rng.uniform(-2, 2, count)) * (rng.random(count) < 0.5)
    rows[:, layout.IN_NORMAL_FORCE] = np.exp(rng.uniform(np.log(low), np.log(high), count))
    return rows


def step_all(stepper, rows, before=lambda stepper: None):
    """Outputs (n, m) of all rows, one after the other, ``before`` done to the stepper ahead of each; NaN where not valid."""
    outputs = np.full((len(rows), layout.OUTPUT_COUNT), np.nan)
    for row, values in zip(outputs, rows):
        before(stepper)
        stepper.inputs[:] = values
        if stepper.step() <= Status.UNLOADED:
            row[:] = stepper.outputs
    return outputs


# --- the influence of a strip -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("t", [1e-4, 1e-2, 0.1, 0.5, 1.0, 3.0, 30.0, 1000.0])
def test_influence_is_the_integral_over_the_line(t):
    integral = 2 * quad(lambda u: math.sqrt(1 - u * u) / math.hypot(u, t), 0, 1, epsabs=0, epsrel=1e-12, limit=400,
                        points=[min(t, 0.5)])[0]
    value, slope = influence(np.array([t]))
    assert value[0] == pytest.approx(integral, rel=1e-9)
    step = 1e-5
    around, _ = influence(t * np.exp([-step, step]))
    assert slope[0] == pytest.approx((around[1] - around[0]) / (2 * step), rel=1e-5)


def test_influence_table_holds_it_to_1e_6():
    array = influence_table()
    table = InfluenceTable.at(array)
    u = np.linspace(*RANGE, 5001)
    held = np.array([line_influence(table, value) for value in u])
    exact = influence(np.exp(u))[0]
    assert np.max(np.abs(held - exact)) < 1e-6
    # beyond the table's ends its ends: nothing is nearer or felt from farther
    assert line_influence(table, RANGE[0] - 5) == pytest.approx(exact[0], abs=1e-6)
    assert line_influence(table, RANGE[1] + 5) == pytest.approx(exact[-1], abs=1e-6)


def test_influence_close_by_is_a_logarithm_and_far_away_a_point():
    """2 ln(4 / t) - 2 for t -> 0, whose mean over a strip is the system's diagonal, 2 ln(8 a / h); pi / (2 t) far away."""
    assert influence(np.array([1e-5]))[0][0] == pytest.approx(2 * math.log(4e5) - 2, abs=1e-8)
    assert influence(np.array([1e3]))[0][0] == pytest.approx(math.pi / 2e3, rel=1e-6)
    half, width = 3.0, 0.01
    mean = quad(lambda eta: influence(np.array([eta / half]))[0][0], 0, width / 2, epsrel=1e-12)[0] / (width / 2)
    assert 2 * math.log(8 * half / width) == pytest.approx(mean, abs=1e-4)


@pytest.mark.parametrize("share", [0.05, 0.2, 0.4, 0.5])
def test_near_share_is_the_mean_of_the_logarithm(share):
    """Mean of -2 ln(distance) over a strip of half-width ``share`` times the distance, less its middle value."""
    mean = quad(lambda v: -2 * math.log(1 + share * v), -1, 1, epsabs=1e-14)[0] / 2
    assert near_share(share) == pytest.approx(mean, abs=1e-15 + share**12 / 60)
    assert near_share(share) < mean + 1e-15


# --- the linear system --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("size", [*range(1, 12), 16, 25, 39, 40])
def test_elimination(size):
    rng = np.random.default_rng(size)
    matrix = rng.uniform(-1, 1, (size, size)) + np.diag(rng.uniform(1.5, 3, size) * size)
    sides = rng.uniform(-1, 1, (size, 2))
    array = np.zeros(layout.WORK_SIZE)
    equations = layout.Work.at(array).equations
    rows = np.frombuffer(equations).reshape(len(equations), -1)
    rows[:size, :size + 2] = np.hstack([matrix, sides])
    others = np.ones_like(array, dtype=bool)
    others[layout.WORK_EQUATIONS:][:rows.size].reshape(rows.shape)[:size, :size + 2] = False
    eliminate(equations, size)
    np.testing.assert_allclose(rows[:size, size:size + 2], np.linalg.solve(matrix, sides), rtol=1e-11, atol=1e-14)
    assert not array[others].any()


# --- Hertz --------------------------------------------------------------------------------------------------------------------


def solve_constant_curvatures(A, B, force, count=24, sweeps=2, half_nodes=15):
    """The strip correction on the gap B s^2 and constant A: relative errors in penetration, area and pressure (3,)."""
    tables, work, state, hertzian = lay_constant_curvatures(A, B, force, half_nodes, 4, strips=count, sweeps=sweeps)
    predicted, met = analyn.solve_penetrations(tables, work.regions, work.nodes, state, 1, force, 0.7 * hertzian, 0)
    assert met == 1
    problem = work.strip_problem
    place_strips(problem, work.regions, work.nodes, 1, tables.strips, predicted)
    assert problem.count == count
    strip_surfaces.describe_strips(problem, work.regions, work.nodes)
    penetration, found = solve_strips(problem, work.regions, work.nodes, work.equations, tables, state, force, 0)
    assert found == 1
    fill_from_strips(problem, work.regions, work.solved)
    exact, a, b, pressure = hertz(A, B, force)
    totals = work.solved.totals
    assert totals.load == pytest.approx(force, rel=1e-12)
    return np.array([penetration / exact, totals.area / (math.pi * a * b), totals.max_pressure / pressure]) - 1


@pytest.mark.parametrize("ratio", [0.05, 0.1, 0.3, 0.7, 1.0, 1.5, 5.0, 20.0, 60.0])
def test_strips_on_constant_curvatures_are_nearly_hertz(ratio):
    """Within 0.5 %, 2 % and 1 % whatever the load: 24 strips, two sweeps, nothing fitted to Hertz."""
    error = solve_constant_curvatures(1.087, 1.087 * ratio, 78.5e3)
    assert np.all(np.abs(error) < (0.005, 0.02, 0.01)), error
    np.testing.assert_allclose(solve_constant_curvatures(1.087, 1.087 * ratio, 1e-3), error, atol=1e-9)


@pytest.mark.parametrize("ratio", [0.05, 0.2, 1.0, 5.0, 20.0])
def test_error_falls_with_the_strips(ratio):
    """16, 32, 64 strips with as many sweeps as it takes: each doubling takes away a quarter or more of the largest error."""
    worst = [np.abs(solve_constant_curvatures(1.0, ratio, 1e4, count=count, sweeps=4, half_nodes=30)).max()
             for count in (16, 32, 64)]
    assert worst[1] < 0.75 * worst[0] and worst[2] < 0.75 * worst[1], worst
    assert worst[2] < 4e-3


def test_halves_of_strips_stay_above_half_their_width(monkeypatch):
    """The floor SQUARE is there for patches that are short along the track: below an eighth of its width a strip would pull
    itself down by its own pressure.  A patch a twenty-fifth as long as wide shows it."""
    short = (1.0, 0.003, 1.0)
    assert np.all(np.abs(solve_constant_curvatures(*short)) < 0.1)
    monkeypatch.setattr(strip_surfaces, "SQUARE", 0.01)
    with pytest.raises((AssertionError, ValueError)):
        solve_constant_curvatures(*short)


# --- Hertz, yawed -------------------------------------------------------------------------------------------------------------


def skewed_hertz(A, B, slant):
    """1 + alpha, 1 + beta, n r of A (x - slant s)^2 + B s^2 from the eigenvectors of its quadratic form: half-length on the
    line s = 0, half-width of its shadow on s, and pressure, of the ellipse that Hertz finds for the eigenvalues."""
    form = np.array([[A, -A * slant], [-A * slant, A * slant**2 + B]])
    (small, large), axes = np.linalg.eigh(form)
    along, across, nr = hertz_coefficients(TABLE, small, large)
    # the ellipse x^T E x = penetration, with its axes along the eigenvectors
    ellipse = axes @ np.diag([along * small, across * large]) @ axes.T
    length = ellipse[0, 0]                                   # penetration / a^2 on s = 0
    width = 1 / np.linalg.inv(ellipse)[1, 1]                 # penetration / b^2, b the largest s
    # line load (pi/2) a p_0 on s = 0 per penetration is E* / (n r)
    return length / A, width / B, nr * math.sqrt(length / (along * small))


SKEWED = [(A, B, slant) for A, B in ((1.0, 0.2), (1.0, 1.0), (0.7, 5.0), (0.3, 60.0)) for slant in (-0.3, 0.01, 0.1, 0.3)
          if A * slant**2 <= STEEPEST * B]


@pytest.mark.parametrize("A, B, slant", SKEWED)
def test_skewed_coefficients_are_those_of_the_principal_axes(A, B, slant):
    found = skewed_coefficients(TABLE, A, B, slant)
    np.testing.assert_allclose(found, skewed_hertz(A, B, slant), rtol=1e-9)
    np.testing.assert_allclose(skewed_coefficients(TABLE, A, B, -slant), found, rtol=1e-13)


@pytest.mark.parametrize("A, B", [(1.0, 0.05), (1.0, 1.0), (1.0, 60.0)])
def test_no_slant_is_upright(A, B):
    upright = hertz_coefficients(TABLE, A, B)
    np.testing.assert_allclose(skewed_coefficients(TABLE, A, B, 0.0), upright, rtol=1e-12)
    np.testing.assert_allclose(skewed_coefficients(TABLE, A, B, 1e-9), upright, rtol=1e-8)


def test_a_steep_slant_counts_as_the_steepest_permitted():
    at_limit = skewed_coefficients(TABLE, 1.0, 0.02, math.sqrt(STEEPEST * 0.02))
    np.testing.assert_allclose(skewed_coefficients(TABLE, 1.0, 0.02, 3.0), at_limit, rtol=1e-12)


@pytest.mark.parametrize("A, B, slant", SKEWED)
def test_upright_coefficients_give_the_same_axes_and_pressure(A, B, slant):
    """The upright ellipse of penetration share d has the half-length, half-width and pressure of the tilted one of d."""
    alpha, beta, nr = skewed_coefficients(TABLE, A, B, slant)
    upright_A, upright_B, share = upright_coefficients(TABLE, alpha * A, beta * B, nr)
    one_alpha, one_beta, one_nr = hertz_coefficients(TABLE, upright_A, upright_B)
    # with penetration share * d: a^2 = share d / ((1 + alpha) A), likewise b; p_0 goes with d / (n r a)
    assert one_alpha * upright_A / share == pytest.approx(alpha * A, rel=1e-9)
    assert one_beta * upright_B / share == pytest.approx(beta * B, rel=1e-9)
    assert one_nr / share == pytest.approx(nr, rel=1e-9)


def test_upright_coefficients_of_an_upright_ellipse_are_its_own():
    alpha, beta, nr = hertz_coefficients(TABLE, 1.3, 4.0)
    np.testing.assert_allclose(upright_coefficients(TABLE, alpha * 1.3, beta * 4.0, nr), (1.3, 4.0, 1.0), rtol=1e-9)


@pytest.mark.parametrize("yaw", [0.0, 0.01, 0.035])
def test_yawed_ball_end_to_end(yaw):
    """Constant radii on both bodies, flank contact of a yawed wheel: Hertz's tilted ellipse; against the half-space."""
    wheel = Profile("ball", "wheel", (Arc(-50.0, 50.0, 200.0, 20.0, -199.0, 1),))
    rail = Profile("crown", "rail", (Arc(-36.0, 36.0, 90.0, 0.0, 90.0, -1),))
    bodies = {model: wrcontact.ContactSystem(wheel, rail, rail_inclination=0.02, gauge=1.4, gauge_depth=6e-3,
                                             normal_model=model) for model in ("analyn", "analyn_strip", "halfspace")}
    state = {model: body.evaluate(2e-3, yaw, normal_force=2e4) for model, body in bodies.items()}
    for side in ("left", "right"):
        truth = getattr(state["halfspace"], side)
        assert np.all(np.abs(errors(getattr(state["analyn"], side), truth)) < (0.004, 0.01, 0.004)), side
        assert np.all(np.abs(errors(getattr(state["analyn_strip"], side), truth)) < (0.004, 0.01, 0.004)), side


# --- the complete theory --------------------------------------------------------------------------------------------------------


POSITIONS = (0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 4.7, 5, 5.2, 5.5, 5.8, 6, 6.2, 6.3, 6.4, 6.5)      # [mm]
FEW = (0.5, 5.5)
#: Where ANALYN and strips are worst: a second region takes up load, and the load leaves the first one.
HARD = (4.55, 4.6, 4.65, 4.7, 4.75, 5.0, 5.1, 5.2, 5.3, 5.4)


@functools.lru_cache
def truth_at(shift):
    """The independent program's contact of the right wheel at ``shift`` [mm], 78.5 kN, no yaw."""
    track = brute_force.track()
    wheelset = brute_force.rigid_contact(track, shift * 1e-3, 0.0)
    return halfspace_reference.normal_contact(track, wheelset, "right", 78.5e3)


def errors_at(model, shifts):
    return np.array([errors(system_of(model).evaluate(shift * 1e-3).right, truth_at(shift)) for shift in shifts])


@pytest.mark.parametrize("shift", FEW)
def test_half_space_on_two_positions(shift):
    assert np.all(np.abs(errors_at("analyn", (shift,))) < (0.035, 0.05, 0.05))
    assert np.all(np.abs(errors_at("analyn_strip", (shift,))) < (0.007, 0.01, 0.012))


@pytest.mark.slow
@pytest.mark.parametrize("model, mean, worst", [
    ("analyn", (0.016, 0.05, 0.04), (0.065, 0.10, 0.09)),
    ("analyn_strip", (0.003, 0.018, 0.014), (0.01, 0.055, 0.045)),
])
def test_half_space_on_positions_from_tread_to_flange(model, mean, worst):
    """Penetration, area, peak pressure; analyn measures 0.7, 2.0, 1.4 % mean, strips 0.27, 0.55, 0.34 %."""
    error = np.abs(errors_at(model, POSITIONS))
    assert np.all(error.mean(axis=0) <= mean) and np.all(error.max(axis=0) <= worst), (error.mean(axis=0), error.max(axis=0))


@pytest.mark.slow
@pytest.mark.parametrize("model, worst", [("analyn", (0.05, 0.08, 0.09)), ("analyn_strip", (0.012, 0.04, 0.03))])
def test_half_space_where_a_region_appears(model, worst):
    error = np.abs(errors_at(model, HARD))
    assert np.all(error.max(axis=0) <= worst), dict(zip(HARD, error.round(4).tolist()))


@pytest.mark.parametrize("case", planar_cases(), ids=lambda case: f"{case['y_ws_mm']}mm")
def test_complete_theory_on_the_planar_gap(case):
    """CONTACT's solution of the same gap; their area follows elements of 0.1 mm and is up to 0.6 % too large."""
    truth = case["solution"]
    side = system_of().evaluate(case["y_ws_mm"] * 1e-3).right
    assert side.penetration == pytest.approx(truth["penetration_mm"] * 1e-3, rel=0.01)
    assert side.area == pytest.approx(truth["area_fit_mm2"] * 1e-6, rel=0.035)
    assert side.max_pressure == pytest.approx(truth["pmax_MPa"] * 1e6, rel=0.03)
    assert side.patch_count == len(truth["regions"])
    loads = sorted((region["fn_N"] for region in truth["regions"]), reverse=True)
    np.testing.assert_allclose([patch.normal_force for patch in side.patches], loads, rtol=0.02)
    centre = sum(region["s_centroid_mm"] * region["fn_N"] for region in truth["regions"]) / 78500
    assert side.patch_centroid == pytest.approx(centre * 1e-3, abs=1.5e-4)


PAIRS = [(rail, inclination) for inclination in (1 / 40, 1 / 20) for rail in ("UIC60", "60E1", "54E1")]
#: A rigid contact that moves this far [m] within
JUMP = 5e-4
#: this lateral shift [m] to either side is near a jump: the surfaces nearly touch in a second place, whose load hangs on the
#: last micrometre of the gap.
NEAR_JUMP = 1e-4


def near_jump(system, pose, side):
    """Whether the side's rigid contact jumps near the pose."""
    shifts = pose[layout.IN_LATERAL_SHIFT] + np.linspace(-NEAR_JUMP, NEAR_JUMP, 21)
    table = system.evaluate_many(shifts, pose[layout.IN_YAW], outputs="geometry")
    return np.abs(np.diff(getattr(table, side).contact.y_wheel)).max() > JUMP


def compare_on_random_poses(count, seed, **parameters):
    """Errors (n, 3) of analyn_strip against the package's half-space on both sides, with whether a jump is near, and where."""
    found, near, where = [], [], []
    for k, pose in enumerate(random_poses(count, seed)):
        rail, inclination = PAIRS[k % len(PAIRS)]
        given = {"rail": rail, "rail_inclination": inclination, **parameters}
        shift, yaw, force = pose[POSE]
        truth = system_of("halfspace", **given).evaluate(shift, yaw, force)
        state = system_of(**given).evaluate(shift, yaw, force)
        assert state.status == truth.status == Status.VALID
        for side in ("left", "right"):
            found.append(errors(getattr(state, side), getattr(truth, side)))
            near.append(near_jump(system_of(**given), pose, side))
            where.append((rail, inclination, side, *pose))
    return np.array(found), np.array(near), where


def assert_near_the_half_space(found, near, where, worst, worst_near_jump):
    error = np.abs(found)
    assert np.all(error[~near].mean(axis=0) <= (0.003, 0.012, 0.010)), error[~near].mean(axis=0)
    for rows, limit in ((np.flatnonzero(~near), worst), (np.flatnonzero(near), worst_near_jump)):
        for row in rows:
            assert np.all(error[row] <= limit), (found[row].round(4), where[row])


def test_half_space_on_random_poses():
    """Three rails, two inclinations, tread to flange, 3 to 200 kN, half of them yawed: mean 0.2, 0.4, 0.4 %."""
    assert_near_the_half_space(*compare_on_random_poses(24, 31), worst=(0.02, 0.06, 0.06), worst_near_jump=(0.03, 0.10, 0.35))


@pytest.mark.slow
@pytest.mark.complete
def test_half_space_on_more_random_poses():
    assert_near_the_half_space(*compare_on_random_poses(150, 32), worst=(0.02, 0.06, 0.06), worst_near_jump=(0.03, 0.10, 0.35))


@pytest.mark.slow
def test_half_space_of_another_material():
    """Aluminium: patches are larger under the same force."""
    found, near, where = compare_on_random_poses(18, 33, youngs_modulus=70e9, poisson_ratio=0.33)
    assert_near_the_half_space(found, near, where, worst=(0.02, 0.06, 0.06), worst_near_jump=(0.03, 0.10, 0.35))


@pytest.mark.parametrize("yaw", [0.0, 0.02])
@pytest.mark.parametrize("shift", [0.0, 3e-3, 5e-3, 6.4e-3])
def test_force_over_modulus_decides_the_patch(shift, yaw):
    """The same N / E* is the same patch at pressures that go with E*."""
    modulus = {"steel": MODULUS, "aluminium": 70e9 / (2 * (1 - 0.33**2))}
    one = system_of().evaluate(shift, yaw, normal_force=5e4).right
    soft = system_of(youngs_modulus=70e9, poisson_ratio=0.33).evaluate(
        shift, yaw, normal_force=5e4 * modulus["aluminium"] / modulus["steel"]).right
    for name in ("penetration", "area", "patch_length", "patch_width"):
        assert getattr(soft, name) == pytest.approx(getattr(one, name), rel=1e-9), name
    assert soft.max_pressure / modulus["aluminium"] == pytest.approx(one.max_pressure / modulus["steel"], rel=1e-9)


# --- what was before changes nothing ----------------------------------------------------------------------------------------


POISONS = {
    "nan": lambda work: work.fill(np.nan),
    "huge": lambda work: work.fill(1e300),
    "numbers": lambda work: np.copyto(work, np.random.default_rng(1).uniform(-1e3, 1e3, len(work))),
    "indices": lambda work: np.copyto(work, np.random.default_rng(2).integers(-3, 60, len(work))),
}


@pytest.mark.parametrize("poison", POISONS)
@pytest.mark.parametrize("model", ["hertz", "analyn", "analyn_strip"])
def test_nothing_is_read_from_the_workspace_that_was_not_written(model, poison):
    rows = random_poses(50, 41)
    rows[::10, layout.IN_NORMAL_FORCE] = 0.0
    clean = step_all(system_of(model).stepper(), rows)
    poisoned = step_all(system_of(model).stepper(), rows, before=lambda stepper: POISONS[poison](stepper._workspace))
    assert np.all(np.isfinite(clean))
    np.testing.assert_array_equal(poisoned.view(np.int64), clean.view(np.int64))


def numbers_of(outputs, names=EXTENT):
    """Totals of both sides (n, 2 k) from outputs."""
    places = [getattr(layout, f"SIDE_{name.upper()}") for name in names]
    return outputs[:, [first + place for first in (layout.OUT_LEFT, layout.OUT_RIGHT) for place in places]]


@pytest.mark.parametrize("model, names, allowed", [
    ("analyn", EXTENT, 1e-9),
    # contact stations known to 1e-14 m: a strip at the edge carries a share of 1e-14 more or less, and at the edge the
    # half-length is the root of it
    ("analyn_strip", EXTENT, 1e-7),
    ("analyn_strip", ("penetration",), 1e-9),
])
def test_the_order_of_poses_changes_nothing(model, names, allowed):
    rows = random_poses(1500, 42)
    order = np.random.default_rng(43).permutation(len(rows))
    one, other = system_of(model).stepper(), system_of(model).stepper()
    straight, mixed = np.full((2, len(rows), layout.OUTPUT_COUNT), np.nan)
    one.step_many(rows, straight, np.zeros(len(rows)))
    shuffled = np.zeros_like(mixed)
    other.step_many(np.ascontiguousarray(rows[order]), shuffled, np.zeros(len(rows)))
    mixed[order] = shuffled
    difference = np.abs(numbers_of(mixed, names) / numbers_of(straight, names) - 1)
    worst = np.argmax(difference.max(axis=1))
    assert difference.max() < allowed, (difference.max(), rows[worst])


@pytest.mark.parametrize("model, allowed", [("analyn", 1e-8), ("analyn_strip", 1e-5)])
def test_mirror(model, allowed):
    """Left and right change places with the signs of shift and yaw: roll to 1e-12 rad, contact stations to 1e-12 m, so that
    penetration and pressure agree to 1e-9; areas hang on the root of what the last strip carries."""
    rows = random_poses(1500, 44)
    shift, yaw, force = rows[:, 0], rows[:, 1], rows[:, 3]
    one, other = (system_of(model).evaluate_many(sign * shift, sign * yaw, force) for sign in (1, -1))
    assert np.abs(one.roll + other.roll).max() < 1e-12
    for here, there in ((one.left, other.right), (one.right, other.left)):
        assert np.abs(here.contact.y_wheel - there.contact.y_wheel).max() < 1e-12
        assert np.abs(here.contact.x_wheel - there.contact.x_wheel).max() < 1e-12
        for name in ("penetration", "max_pressure", "patch_length", "patch_width"):
            assert np.abs(getattr(here, name) / getattr(there, name) - 1).max() < 1e-8, name
        assert np.abs(here.area / there.area - 1).max() < allowed


# --- known to be wrong --------------------------------------------------------------------------------------------------------


def test_a_half_width_survives_a_first_guess_beyond_the_outline():
    """The flange of a wheel yawed by 5.2 degrees: its outline folds back within the first guess of the half-width."""
    pose = -4.67e-3, 0.09, 66549.97
    for model in ("analyn", "analyn_strip"):
        side = system_of(model, rail="54E1", rail_inclination=1 / 20).stepper("left")
        side.inputs[POSE] = pose
        assert side.step() == Status.VALID
        left = side.outputs[layout.OUT_LEFT:]
        assert left[layout.SIDE_AREA] == pytest.approx(2.000e-5, rel=0.05)              # half-space
        assert left[layout.SIDE_MAX_PRESSURE] == pytest.approx(4.982e9, rel=0.05)


@pytest.mark.xfail(strict=True, reason="nodes end where ANALYN's patch would; a flat shelf beyond it takes up load too")
def test_a_patch_on_a_flat_shelf_is_as_wide_as_the_half_space_says():
    """A light load on the tread: the gap levels off below the penetration 7 mm away."""
    pose = 0.68e-3, math.radians(-1.207), 5.08e3
    error = errors(system_of().evaluate(*pose).right, system_of("halfspace").evaluate(*pose).right)
    assert np.all(np.abs(error) < (0.02, 0.06, 0.06)), error


# --- light loads ----------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("yaw", [0.0, 0.005, -0.02, 0.035])
@pytest.mark.parametrize("force", [1e-3, 1e-1, 10.0, 100.0])
def test_light_loads_are_ellipses(force, yaw):
    """A patch of micrometres sees constant curvatures: strips as ANALYN, and no peak, p_max area / N = 1.5 for Hertz."""
    shifts = np.linspace(-6.6e-3, 6.6e-3, 133)
    strip, plain = (system_of(model).evaluate_many(shifts, yaw, force) for model in ("analyn_strip", "analyn"))
    assert not strip.status.any() and not plain.status.any()
    for here, there in ((strip.left, plain.left), (strip.right, plain.right)):
        single = (here.patch_count == 1) & (there.patch_count == 1)
        assert single.mean() > 0.97
        peak = here.max_pressure * here.area / force
        assert np.all(peak[single] > 1.4) and np.all(peak[single] < 1.6)
        for name, allowed in (("penetration", 0.01), ("area", 0.01), ("max_pressure", 0.01)):
            ratio = getattr(here, name) / getattr(there, name)
            assert np.abs(ratio[single] - 1).max() < allowed, (name, shifts[single][np.abs(ratio[single] - 1).argmax()])


@pytest.mark.parametrize("shift, yaw", [(0.0, 0.0), (1e-3, 0.01), (4e-3, -0.02), (6e-3, 0.0), (6.5e-3, 0.02)])
def test_light_loads_scale_like_hertz(shift, yaw):
    """Penetration and area with N^(2/3), pressure with N^(1/3), over nine decades."""
    forces = np.geomspace(1e-6, 1.0, 13)
    side = system_of().evaluate_many(shift, yaw, forces).right
    for name, power in zip(NAMES, (2 / 3, 2 / 3, 1 / 3)):
        constant = getattr(side, name) / forces**power
        np.testing.assert_allclose(constant / constant[0], 1.0, atol=0.01)


# --- prescribed penetration ----------------------------------------------------------------------------------------------------


def test_prescribed_penetration_is_the_inverse():
    """ANALYN's zone is placed by the strips' penetration in one case, and by its own in the other: 1 % of the load, more
    only where a region appears."""
    ratios = []
    for shift, yaw, force in random_poses(150, 45, low=1e3)[:, POSE]:
        one = system_of().evaluate(shift, yaw, force)
        back = system_of().evaluate(shift, yaw, penetration=(one.left.penetration, one.right.penetration))
        for there, here in ((one.left, back.left), (one.right, back.right)):
            assert here.penetration == there.penetration
            ratios.append(here.normal_force / there.normal_force - 1)
    error = np.abs(ratios)
    assert np.median(error) < 1e-3 and np.percentile(error, 95) < 5e-3 and error.max() < 0.1


@pytest.mark.parametrize("yaw", [0.0, 0.02])
def test_force_rises_with_penetration(yaw):
    for shift in np.linspace(-6.6e-3, 6.6e-3, 23):
        loads = [system_of().evaluate(shift, yaw, penetration=depth, side="right", outputs="patches").right.normal_force
                 for depth in np.linspace(5e-6, 2e-4, 60)]
        assert np.all(np.diff(loads) > 0), shift


def test_no_penetration_is_no_load():
    state = system_of().evaluate(2e-3, penetration=(0.0, 5e-5))
    assert state.status == Status.UNLOADED and np.all(np.isfinite(state.values))
    assert state.left.patch_count == 0 and state.left.normal_force == 0.0
    assert state.right.penetration == 5e-5 and state.right.normal_force > 1e4


# --- pairs from hell ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
@pytest.mark.parametrize("hollow", [90.2, 91.0, 95.0, 120.0, 300.0])
def test_nearly_conformal_pairs(hollow, model):
    """A hollow wheel of almost the rail's radius: valid or not converged, and never anything but numbers."""
    wheel = Profile("hollow", "wheel", (Arc(-35.0, 35.0, hollow, 0.0, hollow, -1),))
    rail = Profile("crown", "rail", (Arc(-30.0, 30.0, 90.0, 0.0, 90.0, -1),))
    system = wrcontact.ContactSystem(wheel, rail, rail_inclination=0.0, gauge=1.44, gauge_depth=5e-3, normal_model=model)
    table = system.evaluate_many(np.repeat([-2e-3, 0.0, 1e-3], 4), 0.0, np.tile([1.0, 1e3, 3e4, 1.5e5], 3))
    assert set(table.status) <= {Status.VALID, Status.NOT_CONVERGED, Status.OFF_PROFILE}
    valid = table.status == Status.VALID
    assert np.all(np.isfinite(table.values[valid])) and np.all(np.isnan(table.values[~valid]))


@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
@pytest.mark.parametrize("radius", [6.0, 10.0, 30.0])
def test_sharp_crowns(radius, model):
    """A crown of millimetres under a wheel of half a metre: patches twenty times longer along the track than across."""
    wheel = Profile("flat", "wheel", (Arc(-50.0, 50.0, 5000.0, 0.0, -5000.0, 1),))
    rail = Profile("ridge", "rail", (Arc(-0.99 * radius, 0.99 * radius, radius, 0.0, radius, -1),))
    system = wrcontact.ContactSystem(wheel, rail, rail_inclination=0.0, gauge=1.5 - 2e-3 * math.sqrt(10 * radius - 25),
                                     gauge_depth=0.005, normal_model=model)
    table = system.evaluate_many([0.0, 1e-3, -2e-3, 0.0], [0.0, 0.01, 0.0, 0.02], [1.0, 100.0, 1e3, 1e4])
    assert set(table.status) <= {Status.VALID, Status.NOT_CONVERGED}
    assert np.all(np.isfinite(table.values[table.status == Status.VALID]))
    assert table.status[0] == Status.VALID
    penetration, a, b, pressure = hertz(0.5 * table.right.curvature_x[0], 0.5 * table.right.curvature_y[0], 1.0)
    assert table.right.penetration[0] == pytest.approx(penetration, rel=0.01)
    assert table.right.area[0] == pytest.approx(math.pi * a * b, rel=0.02)
    assert table.right.max_pressure[0] == pytest.approx(pressure, rel=0.02)


# --- smoothness -----------------------------------------------------------------------------------------------------------------


SWEEP = np.arange(-6600, 6601, 10) * 1e-6
#: Lateral shifts of a right wheel [mm] where a second difference over 10 um may exceed 1 %, and why.
ROUGH = {
    "a second region opens or is joined, and the model takes a step": [(-0.42, -0.10), (4.38, 4.60)],
    "the load changes from one region to the other": [(-0.04, 0.27), (4.74, 5.58)],
    "the rigid contact jumps, or moves a millimetre in 10 um": [(6.04, 6.30)],
    "the contact passes a joint of the flange's arcs: the half-space moves that fast too": [(6.33, 6.44)],
}
#: Of the width also, where the last strip on a flat side takes up load or loses it.
ROUGH_WIDTH = [(-1.24, -1.08), (0.45, 0.52), (0.81, 0.90), (1.81, 1.89), (3.34, 3.42), (5.64, 5.72)]


def roughness(model, yaw, name):
    """Second differences over the sweep (n,), as shares of the value or of 10 mm for the centroid."""
    table = system_of(model).evaluate_many(SWEEP, yaw, outputs="patches")
    assert not table.status.any()
    values = getattr(table.right, name)
    scale = 1e-2 if name == "patch_centroid" else np.abs(values[1:-1])
    return np.abs(np.diff(values, 2)) / scale


@pytest.mark.parametrize("name", [*EXTENT, "patch_centroid"])
@pytest.mark.parametrize("yaw", [0.0, 0.01])
@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
def test_outputs_move_smoothly(model, yaw, name):
    """Second differences over 10 um below 1 % but for named places, the median 1e-4 or less."""
    rough = roughness(model, yaw, name)
    windows = sum(ROUGH.values(), []) + (ROUGH_WIDTH if name == "patch_width" and model == "analyn_strip" else [])
    shift = SWEEP[1:-1] * 1e3
    inside = np.any([(shift >= low) & (shift <= high) for low, high in windows], axis=0)
    worst = np.argmax(np.where(inside, 0.0, rough))
    assert rough[~inside].max() < 0.01, (shift[worst], rough[worst])
    assert np.median(rough) < 1e-4
    assert inside.mean() < 0.25


@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
@pytest.mark.parametrize("load, force", [("normal", 216.86e3), ("vertical", 73.9e3)])
def test_a_patch_that_reaches_the_profile_s_end_grows_smoothly(model, load, force):
    """Half newtons on a yawed wheel whose half-width ends with the profile: once two answers took turns, 0.15 % apart, as the
    slant was measured to the end or to the middle.  Every step is that of a load's power 1/2 ... 1."""
    forces = force + 0.5 * np.arange(200)
    table = system_of(model, load=load).evaluate_many(6.156e-3, -0.0245, forces, load_transfer=0.75)
    assert not table.status.any()
    for name, least, most in (("penetration", 0.5, 1.0), ("max_pressure", 0.1, 1.0)):
        powers = np.diff(np.log(getattr(table.right, name))) / np.diff(np.log(forces))
        assert least < powers.min() and powers.max() < most, (name, powers.min(), powers.max())
