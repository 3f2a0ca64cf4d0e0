"""The strip model's influence function and linear system, and yawed wheels that are Hertz's."""

import math

import numpy as np
import pytest
from scipy.integrate import quad

import wrcontact
from tests.helpers.strips import errors
from tools.tables.exact_tables import influence, near_constant, spacing
from wrcontact.kernel import layout
from wrcontact.kernel.binding.fixed_tables import hertz_table, influence_table
from wrcontact.kernel.layout import INFLUENCE_MAP, SPACING_CELLS, InfluenceTable
from wrcontact.kernel.normal.coefficients import STEEPEST_SLANT, hertz_coefficients, skewed_coefficients
from wrcontact.kernel.normal.strip_pressures import (
    CLOSEST_SPACING,
    MIDDLE_CONSTANT,
    TESTED,
    TESTED_CONSTANT,
    TESTED_HEIGHT,
    WIDEST_SPACING,
    apartness,
    eliminate,
    influence_at,
    middle_influence,
    nearness,
    spacing_at,
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


@pytest.mark.parametrize("low, high, error", [(0.0, 1e-9, 1e-3), (0.0, 0.7, 0.01), (0.7, 0.97, 0.04)])
def test_influence_table_holds_it(low, high, error):
    """On the middle line, and up to the end of a strip, for strips from a hundredth of a half-length on: Phi
    is 1 ... 10 there. Farther away the table is as good everywhere."""
    table = InfluenceTable.at(influence_table())
    rng = np.random.default_rng(5)
    for t, e in zip(np.exp(rng.uniform(math.log(0.01), 3.0, 300)), rng.uniform(low, high, 300)):
        near = nearness(t, 1.0)
        at, x = 3 * int(near), near % 1.0
        allowed = error if t < 0.2 else 0.004
        found = influence_at(table, at, x, apartness(e * e, 1.0))
        assert found == pytest.approx(float(influence(t, e)), abs=allowed)
        assert middle_influence(table, at, x) == influence_at(table, at, x, 0.0)


def test_influence_close_by_is_a_logarithm_and_far_away_a_point():
    """2 ln(4 / t) - 2 for t -> 0, which is -2 ln t + k of eq. (S12); pi / (2 t) far away."""
    assert float(influence(1e-3, 0.0)) == pytest.approx(2 * math.log(4e3) - 2, abs=5e-4)
    assert float(influence(1e3, 0.0)) == pytest.approx(math.pi / 2e3, rel=1e-6)


@pytest.mark.parametrize(
    "e, height, constant", [(0.0, 1.0, MIDDLE_CONSTANT), (TESTED, TESTED_HEIGHT, TESTED_CONSTANT)]
)
def test_constants_beside_the_logarithm(e, height, constant):
    """k(e) from Phi very near the middle line: what is left falls like t."""
    near = line_integral(1e-5, e) + 2 * height * math.log(1e-5)
    assert height == pytest.approx(math.sqrt(1 - e * e), rel=1e-14)
    assert constant == pytest.approx(float(near_constant(e)), rel=1e-14)
    assert constant == pytest.approx(near, abs=1e-4)


def spacing_by_quadrature(e, tau):
    """S of eq. (S12): twenty half-lengths, and 30 lines at least, of the smooth pressure less those of the
    lines; over t the kernel's integral is asinh(t / |v - e|)."""
    count = max(30, round(20 / tau))
    reach = (count + 0.5) * tau

    def integrand(angle):
        return math.sin(angle) ** 2 * math.asinh(reach / max(abs(math.cos(angle) + e), 1e-300))

    smooth = 2 * quad(integrand, 0, math.pi, epsrel=1e-11, limit=500, points=[math.acos(-e)])[0]
    lines = 2 * tau * sum(line_integral(k * tau, e) for k in range(1, count + 1))
    logarithm = -2 * math.sqrt(1 - e * e) * math.log(tau / (2 * math.pi)) + float(near_constant(e))
    return (smooth - lines) / tau - logarithm


@pytest.mark.parametrize("e, first", [(0.0, INFLUENCE_MAP), (TESTED, INFLUENCE_MAP + 3 * SPACING_CELLS)])
def test_spacing_is_what_lines_leave_out(e, first):
    """The function, and its table between the nodes and beyond its ends; S is 2.4 where lines are 23
    half-lengths apart, and is nothing where they are close together."""
    table = InfluenceTable.at(influence_table())
    for tau in (0.11, 0.35, 0.93, 2.1, 6.7, 23.0):
        truth = spacing_by_quadrature(e, tau)
        # measured 1.2e-4 both, of the hundred straight pieces of the profile
        assert spacing(e, tau) == pytest.approx(truth, abs=1.8e-4), tau
        assert spacing_at(table, first, math.log(tau)) == pytest.approx(truth, abs=1.8e-4), tau
    assert spacing_at(table, first, math.log(CLOSEST_SPACING)) == pytest.approx(0.0, abs=8e-4)
    for beyond, end in ((1e-5, CLOSEST_SPACING), (1e3, WIDEST_SPACING)):
        assert spacing_at(table, first, math.log(beyond)) == pytest.approx(
            spacing_at(table, first, math.log(end)), abs=1e-9
        )


# --- the linear system ----------------------------------------------------------------------------


@pytest.mark.parametrize("size", [*range(1, 12), 16, 25, 39, 40])
def test_elimination(size):
    rng = np.random.default_rng(size)
    matrix = rng.uniform(-1, 1, (size, size)) + np.diag(rng.uniform(1.5, 3, size) * size)
    sides = rng.uniform(-1, 1, (size, 2))
    array = np.zeros(layout.WORK_SIZE)
    equations = layout.Work.at(array).contact.equations
    rows = np.frombuffer(equations).reshape(len(equations), -1)
    rows[:size, : size + 2] = np.hstack([matrix, sides])
    others = np.ones_like(array, dtype=bool)
    others[layout.offset(equations, array) :][: rows.size].reshape(rows.shape)[:size, : size + 2] = False
    eliminate(equations, size)
    np.testing.assert_allclose(
        rows[:size, size : size + 2], np.linalg.solve(matrix, sides), rtol=1e-11, atol=1e-14
    )
    assert not array[others].any()


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
    length = ellipse[0, 0]  # penetration / a^2 on s = 0
    width = 1 / np.linalg.inv(ellipse)[1, 1]  # penetration / b^2, b the largest s
    # line load (pi/2) a p_0 on s = 0 per penetration is E* / (n r)
    return length / A, width / B, nr * math.sqrt(length / (along * small))


SKEWED = [
    (A, B, slant)
    for A, B in ((1.0, 0.2), (1.0, 1.0), (0.7, 5.0), (0.3, 60.0))
    for slant in (-0.3, 0.01, 0.1, 0.3)
    if A * slant**2 <= STEEPEST_SLANT * B
]


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


@pytest.mark.parametrize(
    "force, analyn",
    [
        # the patch is too small to turn: measured 6e-6, 8.1e-5, 1.1e-5 at most
        (20.0, (1e-5, 1.5e-4, 1.7e-5)),
        # it turns by 1.7 degrees to either side: measured 8.6e-5, 5.1e-4, 4.1e-4 at most
        (2e4, (1.3e-4, 7.7e-4, 6.1e-4)),
    ],
)
@pytest.mark.parametrize("yaw", [0.0, 0.01, 0.035])
def test_yawed_ball_end_to_end(yaw, force, analyn):
    """Constant radii on both bodies, flank contact of a yawed wheel: Hertz's tilted ellipse;
    against the half-space."""
    wheel = Profile("ball", "wheel", (Arc(-50.0, 50.0, 200.0, 20.0, -199.0, 1),))
    rail = Profile("crown", "rail", (Arc(-36.0, 36.0, 90.0, 0.0, 90.0, -1),))
    given = {"analyn": {}, "analyn_strip": {}, "halfspace": {"tolerance": 2e-3}}
    state = {
        model: wrcontact.ContactSystem(
            wheel, rail, rail_inclination=0.02, gauge=1.4, gauge_depth=6e-3, normal_model=model, **more
        ).evaluate(2e-3, yaw, force)
        for model, more in given.items()
    }
    for side in ("left", "right"):
        truth = getattr(state["halfspace"], side)
        assert np.all(np.abs(errors(getattr(state["analyn"], side), truth)) < analyn), side
        # measured 0.061, 0.087, 0.071 % at most
        assert np.all(
            np.abs(errors(getattr(state["analyn_strip"], side), truth)) < (9.2e-4, 1.3e-3, 1.06e-3)
        ), side
