"""The strip model's influence function and linear system, and Hertz's contact by it."""

import math

import numpy as np
import pytest
from scipy.integrate import quad

import wrcontact
from data.hertz import hertz
from tests.helpers.constant_curvatures import lay_constant_curvatures
from tests.helpers.strips import errors
from wrcontact.kernel import layout
from wrcontact.kernel.binding.exact_tables import influence, mean_influence
from wrcontact.kernel.binding.fixed_tables import hertz_table, influence_table
from wrcontact.kernel.layout import INFLUENCE_MAP, InfluenceTable
from wrcontact.kernel.normal import strip_contact
from wrcontact.kernel.normal.coefficients import STEEPEST_SLANT, hertz_coefficients, skewed_coefficients
from wrcontact.kernel.normal.strip_patches import fill_from_strips
from wrcontact.kernel.normal.strip_pressures import (
    apartness,
    eliminate,
    influence_at,
    middle_influence,
    nearness,
)
from wrcontact.profiles.profile import Profile
from wrcontact.profiles.zones import Arc

TABLE = layout.HertzTable.at(hertz_table())

# --- the influence of a strip ---------------------------------------------------------------------


def line_integral(t, e):
    """Phi(t, e) by quadrature over v = -cos(angle)."""
    def integrand(angle):
        return math.sin(angle) ** 2 / math.hypot(math.cos(angle) + e, t)

    points = [math.acos(-e)] if e < 1 else None
    return quad(integrand, 0, math.pi, epsabs=0, epsrel=1e-11, limit=500, points=points)[0]


@pytest.mark.parametrize("e", [0.0, 0.5, 0.9, 1.2, 3.0])
@pytest.mark.parametrize("t", [1e-2, 0.1, 0.5, 1.0, 3.0, 30.0])
def test_influence_is_the_integral_over_the_line(t, e):
    assert influence(t, e) == pytest.approx(line_integral(t, e), rel=2e-6)
    mean = quad(lambda eta: float(influence(eta, e)), 0, t, epsrel=1e-9, limit=400)[0] / t
    assert mean_influence(t, e) == pytest.approx(mean, rel=1e-5)


@pytest.mark.parametrize("low, high, error", [(0.0, 1e-9, 1e-3), (0.0, 0.7, 0.01), (0.7, 0.97, 0.04)])
def test_influence_table_holds_it(low, high, error):
    """On the middle line, and up to the end of a strip, for strips from a hundredth of a half-length on: Phi
    is 1 ... 10 there. Farther away the table is as good everywhere."""
    array = influence_table()
    table = InfluenceTable.at(array)
    rng = np.random.default_rng(5)
    for t, e in zip(np.exp(rng.uniform(math.log(0.01), 3.0, 300)), rng.uniform(low, high, 300)):
        u, v = nearness(t, 1.0), apartness(e, 1.0)
        allowed = error if t < 0.2 else 0.004
        assert influence_at(table, 0, u, v) == pytest.approx(float(influence(t, e)), abs=allowed)
        if t < 0.5:
            assert influence_at(table, INFLUENCE_MAP, u, v) == pytest.approx(
                float(mean_influence(t, e)), abs=2.5 * allowed)
        assert middle_influence(table, 0, u) == influence_at(table, 0, u, 0.0)


def test_influence_close_by_is_a_logarithm_and_far_away_a_point():
    """2 ln(4 / t) - 2 for t -> 0, whose mean over a strip is the system's diagonal, 2 ln(8 a / h) for narrow
    strips; pi / (2 t) far away."""
    assert float(influence(1e-3, 0.0)) == pytest.approx(2 * math.log(4e3) - 2, abs=5e-4)
    assert float(influence(1e3, 0.0)) == pytest.approx(math.pi / 2e3, rel=1e-6)
    half, width = 3.0, 0.01
    mean = float(mean_influence(width / 2 / half, 0.0))
    assert 2 * math.log(8 * half / width) == pytest.approx(mean, abs=5e-4)


# --- the linear system ----------------------------------------------------------------------------


@pytest.mark.parametrize("size", [*range(1, 12), 16, 25, 39, 40])
def test_elimination(size):
    rng = np.random.default_rng(size)
    matrix = rng.uniform(-1, 1, (size, size)) + np.diag(rng.uniform(1.5, 3, size) * size)
    sides = rng.uniform(-1, 1, (size, 2))
    array = np.zeros(layout.WORK_SIZE)
    equations = layout.Work.at(array).contact.equations
    rows = np.frombuffer(equations).reshape(len(equations), -1)
    rows[:size, :size + 2] = np.hstack([matrix, sides])
    others = np.ones_like(array, dtype=bool)
    others[layout.offset(equations, array):][:rows.size].reshape(rows.shape)[:size, :size + 2] = False
    eliminate(equations, size)
    np.testing.assert_allclose(rows[:size, size:size + 2], np.linalg.solve(matrix, sides), rtol=1e-11,
                               atol=1e-14)
    assert not array[others].any()


# --- Hertz ----------------------------------------------------------------------------------------


def solve_constant_curvatures(A, B, force, count=24, sweeps=2):
    """The strips on the gap B s^2 and constant A, laid at Hertz's penetration: relative errors in
    penetration, area and pressure (3,)."""
    tables, work, exact = lay_constant_curvatures(A, B, force, strips=count, sweeps=sweeps)
    contact, side = work.contact, work.sides[1]
    contact.frame.plane.cos, contact.frame.sunk, contact.filling = 1.0, True, True
    contact.regions[0].curvature = 2.0 * A
    problem = contact.strip_problem
    problem.penetration = exact
    zone = problem.zones[0]
    zone.level = 0.9 * exact
    zone.start, zone.stop = (side * math.sqrt(zone.level / B) for side in (-1, 1))

    def trace(pair, contact, regions):
        for i in range(problem.count):
            strip = problem.strips[i]
            strip.overlap, strip.rise = exact - B * strip.station**2, 0.0
            strip.cos, strip.sin, strip.x, strip.A, strip.skew = 1.0, 0.0, 0.0, A, 0.0

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(strip_contact, "trace_strips", trace)
        penetration, found = strip_contact.first_layout(tables.pairs[1], contact, 1, force, 0)
        assert found == 1
        penetration, found = strip_contact.second_layout(tables.pairs[1], contact, 1, force, 0)
        assert found == 1
    fill_from_strips(tables, contact, side, 1)
    exact, a, b, pressure = hertz(A, B, force)
    totals = side.totals
    assert totals.load == pytest.approx(force, rel=1e-12)
    return np.array([penetration / exact, totals.area / (math.pi * a * b),
                     totals.max_pressure / pressure]) - 1


@pytest.mark.parametrize("sweeps, allowed", [
    # measured 0.55, 1.78, 0.09 % at most, and 0.27, 2.01, 0.49 %
    (2, (0.0082, 0.0267, 0.0013)), (3, (0.0041, 0.025, 0.0073)),
])
@pytest.mark.parametrize("ratio", [0.05, 0.1, 0.3, 0.7, 1.0, 1.5, 5.0, 20.0, 60.0])
def test_strips_on_constant_curvatures_are_nearly_hertz(ratio, sweeps, allowed):
    """Whatever the load: 24 strips, the usual number of sweeps and one more."""
    error = solve_constant_curvatures(1.087, 1.087 * ratio, 78.5e3, sweeps=sweeps)
    assert np.all(np.abs(error) < allowed), error
    light = solve_constant_curvatures(1.087, 1.087 * ratio, 1e-3, sweeps=sweeps)
    np.testing.assert_allclose(light, error, atol=1e-9)


@pytest.mark.parametrize("ratio", [0.05, 0.2, 1.0, 5.0, 20.0])
def test_error_falls_with_the_strips(ratio):
    """From 16 strips to 64 with as many sweeps as there are; half a per cent of the area stays where a patch
    is long and thin, whose few strips come nearer by chance."""
    few, many = (np.abs(solve_constant_curvatures(1.0, ratio, 1e4, count=count, sweeps=4)).max()
                 for count in (16, 64))
    # measured 0.38, 0.26, 0.45, 1.15, 0.30 % and 0.22, 0.15, 0.07, 0.54, 0.49 %
    assert many < max(few, 6e-3), (few, many)
    assert many < 7.5e-3


def test_halves_of_strips_stay_above_half_their_width():
    """A patch a twenty-fifth as long as wide is shorter than a strip is wide; with more strips the error
    goes."""
    # measured 11.5 and 2.6 % at most
    assert np.all(np.abs(solve_constant_curvatures(1.0, 0.003, 1.0)) < 0.17)
    assert np.all(np.abs(solve_constant_curvatures(1.0, 0.003, 1.0, count=64)) < 0.039)


# --- Hertz, yawed ---------------------------------------------------------------------------------


def skewed_hertz(A, B, slant):
    """1 + alpha, 1 + beta, n r of A (x - slant s)^2 + B s^2 from the eigenvectors of its quadratic form:
    half-length on the line s = 0, half-width of its shadow on s, and pressure, of the ellipse that Hertz
    finds for the eigenvalues."""
    form = np.array([[A, -A * slant], [-A * slant, A * slant**2 + B]])
    (small, large), axes = np.linalg.eigh(form)
    along, across, nr = hertz_coefficients(TABLE, small, large)
    # the ellipse x^T E x = penetration, with its axes along the eigenvectors
    ellipse = axes @ np.diag([along * small, across * large]) @ axes.T
    length = ellipse[0, 0]                                   # penetration / a^2 on s = 0
    width = 1 / np.linalg.inv(ellipse)[1, 1]                 # penetration / b^2, b the largest s
    # line load (pi/2) a p_0 on s = 0 per penetration is E* / (n r)
    return length / A, width / B, nr * math.sqrt(length / (along * small))


SKEWED = [(A, B, slant) for A, B in ((1.0, 0.2), (1.0, 1.0), (0.7, 5.0), (0.3, 60.0))
          for slant in (-0.3, 0.01, 0.1, 0.3)
          if A * slant**2 <= STEEPEST_SLANT * B]


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
    at_limit = skewed_coefficients(TABLE, 1.0, 0.02, math.sqrt(STEEPEST_SLANT * 0.02))
    np.testing.assert_allclose(skewed_coefficients(TABLE, 1.0, 0.02, 3.0), at_limit, rtol=1e-12)


@pytest.mark.parametrize("force, analyn", [
    # the patch is too small to turn: measured 6e-6, 8.1e-5, 1.1e-5 at most
    (20.0, (1e-5, 1.5e-4, 1.7e-5)),
    # it turns by 1.7 degrees to either side: measured 8.6e-5, 5.1e-4, 4.1e-4 at most
    (2e4, (1.3e-4, 7.7e-4, 6.1e-4)),
])
@pytest.mark.parametrize("yaw", [0.0, 0.01, 0.035])
def test_yawed_ball_end_to_end(yaw, force, analyn):
    """Constant radii on both bodies, flank contact of a yawed wheel: Hertz's tilted ellipse;
    against the half-space."""
    wheel = Profile("ball", "wheel", (Arc(-50.0, 50.0, 200.0, 20.0, -199.0, 1),))
    rail = Profile("crown", "rail", (Arc(-36.0, 36.0, 90.0, 0.0, 90.0, -1),))
    given = {"analyn": {}, "analyn_strip": {}, "halfspace": {"tolerance": 2e-3}}
    state = {model: wrcontact.ContactSystem(wheel, rail, rail_inclination=0.02, gauge=1.4, gauge_depth=6e-3,
                                            normal_model=model, **more).evaluate(2e-3, yaw, force)
             for model, more in given.items()}
    for side in ("left", "right"):
        truth = getattr(state["halfspace"], side)
        assert np.all(np.abs(errors(getattr(state["analyn"], side), truth)) < analyn), side
        # measured 0.28, 0.85, 0.05 % at most
        assert np.all(np.abs(errors(getattr(state["analyn_strip"], side), truth))
                      < (4.2e-3, 1.28e-2, 7e-4)), side
