"""The half-space solver: closed forms, balances, scaling, and what it refuses."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.integrate import dblquad

from data.hertz import MODULUS, hertz
from tests.helpers.halfspace import WIDE, on_hertz, paraboloid
from wrcontact.halfspace import contact, deflection, edge, one_grid, outputs, window

pytestmark = [pytest.mark.check, pytest.mark.machine]


# --- the influence of one cell --------------------------------------------------------------------


def test_influence_is_the_integral_over_the_cell():
    """1/r integrated by quadrature over a cell that is far from square, one cell and one diagonal away."""
    dx, ds = 1e-4, 3e-4
    influence = deflection.influence(dx * np.arange(3), ds * np.arange(3), contact_modulus=MODULUS)
    for i, j in ((1, 0), (0, 1), (2, 1)):

        def distance(s, x, i=i, j=j):
            return 1.0 / math.hypot(x - i * dx, s - j * ds)

        integral = dblquad(distance, -dx / 2, dx / 2, -ds / 2, ds / 2, epsrel=1e-11)[0]
        assert influence[i, j] == pytest.approx(integral / (math.pi * MODULUS), rel=1e-10)


def test_convolution_is_the_sum():
    """Nothing wraps round: against the plain double sum, on a grid that is not square."""
    pressure = np.random.default_rng(1).random((7, 5))
    bent = deflection.Deflection(pressure.shape, 2e-4, 1e-4, MODULUS)(pressure)
    influence = deflection.influence(2e-4 * np.arange(7), 1e-4 * np.arange(5), contact_modulus=MODULUS)
    for i, j in ((0, 0), (6, 4), (2, 3)):
        total = sum(pressure[k, m] * influence[abs(i - k), abs(j - m)] for k in range(7) for m in range(5))
        assert bent[i, j] == pytest.approx(total, rel=1e-12)


# --- closed forms ---------------------------------------------------------------------------------


@pytest.mark.parametrize("ratio", [0.03, 0.2, 1.0, 5.0, 60.0])
@pytest.mark.parametrize("force", [1e-3, 78.5e3, 1e6])
def test_hertz(ratio, force):
    """Ellipses up to 1:8, nanometres to a millimetre of penetration: 0.1 % in peak
    pressure, 0.5 % in area."""
    penetration, a, b, pressure = hertz(1.087, 1.087 * ratio, force)
    found = contact.solve_contact(
        paraboloid(1.087, 1.087 * ratio), WIDE, contact_modulus=MODULUS, force=force
    )
    assert found.penetration == pytest.approx(penetration, rel=3e-4)
    assert found.max_pressure == pytest.approx(pressure, rel=1e-3)
    assert found.area == pytest.approx(math.pi * a * b, rel=5e-3)
    assert found.force == pytest.approx(force, rel=1e-10)
    assert max(found.error.values()) <= contact.TOLERANCE


def test_peak_between_cells():
    """The peak of Hertz's pressure a third of a cell away from the nearest centre; the centre
    itself is 1e-3 lower."""
    _, a, _, pressure = hertz(1.0, 1.0, 1e4)
    cells, third = 24, 1 / 3
    x = a * (1 + 4 / cells) * (2 * np.arange(cells + 4) + 1 - cells - 4) / (cells + 4)
    step = x[1] - x[0]
    x = x + (0.5 - third) * step
    found = one_grid.solve(x, x, paraboloid(1.0, 1.0)(x, x), contact_modulus=MODULUS, force=1e4)
    assert found.max_pressure == pytest.approx(pressure, rel=7e-4)
    assert found.pressure.max() < found.max_pressure


@pytest.mark.parametrize("aspect", [1.0, 3.0])
def test_area_of_an_exact_pressure_field(aspect):
    """Edges within cells: Hertz's own pressure at the centres of 30 cells across; counting
    cells is off by up to 1 %."""
    errors = []
    for offset in np.linspace(0.0, 0.5, 6):
        x, s = np.arange(-30, 31) + offset, np.arange(-30, 31) + 0.7 * offset
        square = 1 - (x[:, None] / 15) ** 2 - (aspect * s / (30 if aspect > 1 else 15)) ** 2
        area = math.pi * 15 * (30 / aspect if aspect > 1 else 15)
        field = edge.edge_field(np.sqrt(np.maximum(square, 0.0)))
        # the correction belongs to solved pressures, not to exact ones
        bias = edge.EDGE_BIAS * 2 * math.pi * 15
        errors.append(
            (edge.edge_area(field) + bias * (30 / aspect / 15 + 1) / 2) / area - 1
            if aspect > 1
            else (edge.edge_area(field) + bias) / area - 1
        )
    assert np.max(np.abs(errors)) < 4e-3


def test_flat_punch():
    """A rigid cylinder of radius a: N = 2 E* a delta (Johnson 1985, eq. 3.36); an edge, and
    no surface beyond it."""
    radius, cells = 5e-3, 120
    x = radius * 1.1 * (2 * np.arange(cells) + 1 - cells) / cells
    gap = np.where(np.hypot(x[:, None], x) < radius, 0.0, np.inf)
    found = one_grid.solve(x, x, gap, contact_modulus=MODULUS, penetration=1e-5)
    # the edge is known to half a cell
    assert found.force == pytest.approx(2 * MODULUS * radius * 1e-5, rel=0.01)
    by_force = one_grid.solve(x, x, gap, contact_modulus=MODULUS, force=found.force)
    assert by_force.penetration == pytest.approx(1e-5, rel=1e-6)


def test_two_separate_patches_press_each_other_down():
    """Two balls 40 mm apart, patches of 2 mm: each as Hertz under half the load, and
    N/2 / (pi E* D) deeper."""
    distance, force = 0.04, 2e4
    curvature = 5.0

    def gap(x, s):
        return curvature * (x[:, None] ** 2 + np.minimum((s - distance / 2) ** 2, (s + distance / 2) ** 2))

    alone = hertz(curvature, curvature, force / 2)
    found = contact.solve_contact(gap, (-0.05, 0.05, -0.06, 0.06), contact_modulus=MODULUS, force=force)
    # the far patch tilts the surface under the near one: a / D = 0.03
    assert found.penetration == pytest.approx(alone[0] + force / 2 / (math.pi * MODULUS * distance), rel=1e-3)
    assert found.max_pressure == pytest.approx(alone[3], rel=2e-3)
    assert found.area == pytest.approx(2 * math.pi * alone[1] * alone[2], rel=5e-3)
    patches = outputs.split_patches(found)
    assert len(patches) == 2
    assert patches[0].sum() == pytest.approx(patches[1].sum(), rel=1e-3)


# --- properties of the method ---------------------------------------------------------------------


def test_contact_conditions_hold():
    """p >= 0, no overlap, no pressure where the bodies are apart, to 1e-6 of the penetration."""
    found, _ = on_hertz(1.0, 4.0, 5e4, 40, precision=1e-7)
    loaded = found.pressure > 0.0
    assert np.all(found.pressure >= 0.0) and 0 < np.count_nonzero(loaded) < loaded.size
    assert np.max(np.abs(found.clearance[loaded])) < 1e-6 * found.penetration
    assert np.min(found.clearance[~loaded]) > -1e-6 * found.penetration


def test_grid_error_falls_with_the_cells():
    """Twice the cells, a quarter of the error in penetration (measured 2.1 as exponent), half
    in area before correction."""
    errors = {"penetration": [], "max_pressure": []}
    for cells in (18, 36, 72):
        found, (penetration, _, _, pressure) = on_hertz(1.0, 2.0, 1e4, cells)
        errors["penetration"].append(abs(found.penetration / penetration - 1))
        errors["max_pressure"].append(abs(found.max_pressure / pressure - 1))
    for name, values in errors.items():
        rate = math.log2(values[0] / values[-1]) / 2
        assert rate > 1.5, (name, values)


def test_cells_over_a_patch_do_not_hang_on_rounding():
    """The ratio of two lengths of a patch may be 20 or the next larger number; cells are counted instead."""
    random = np.random.default_rng(20)
    for _ in range(200):
        (x0, s0), (dx, ds) = random.uniform(-1e-2, 1e-2, 2), random.uniform(1e-5, 1e-3, 2)
        pressure = np.zeros((24, 24))
        wide, long = random.integers(1, 20, 2)
        pressure[2 : 2 + wide, 3 : 3 + long] = 1.0
        found = SimpleNamespace(x=x0 + dx * np.arange(24), s=s0 + ds * np.arange(24), pressure=pressure)
        bounds, cells = window.fit_window(found)
        assert cells == (window.PATCH_CELLS + 2 * window.MARGIN_CELLS,) * 2, (x0, s0, dx, ds, wide, long)
        free = 1.0 + 2.0 * window.MARGIN_CELLS / window.PATCH_CELLS
        assert bounds[1] - bounds[0] == pytest.approx(free * wide * dx, rel=1e-9)
        assert bounds[3] - bounds[2] == pytest.approx(free * long * ds, rel=1e-9)


def test_cells_over_two_patches_are_those_of_the_narrow_one():
    pressure = np.zeros((24, 24))
    pressure[4:14, 3:9] = pressure[4:14, 15:18] = 1.0
    _, cells = window.fit_window(
        SimpleNamespace(x=1e-3 * np.arange(24), s=1e-3 * np.arange(24), pressure=pressure)
    )
    assert cells == (20 + 4, 20 * 15 // 3 + 4)


@pytest.mark.parametrize("ratio", [1.0, 5.0, 60.0])
def test_estimated_error_bounds_the_real_one(ratio):
    """At four tolerances on Hertz's ellipses, against the closed form."""
    penetration, a, b, pressure = hertz(1.0, ratio, 1e4)
    sizes = []
    for tolerance in (0.05, 0.01, 3e-3, 1e-3):
        found = contact.solve_contact(
            paraboloid(1.0, ratio), WIDE, contact_modulus=MODULUS, force=1e4, tolerance=tolerance
        )
        assert max(found.error.values()) <= tolerance
        assert abs(found.area / (math.pi * a * b) - 1) < tolerance
        assert abs(found.penetration / penetration - 1) < tolerance
        assert abs(found.max_pressure / pressure - 1) < tolerance
        sizes.append(found.pressure.size)
    assert sizes == sorted(sizes) and sizes[-1] > sizes[0]


def test_prescribed_penetration_is_the_inverse_on_a_grid():
    found, _ = on_hertz(1.0, 3.0, 4e4, 40)
    back = one_grid.solve(
        found.x,
        found.s,
        paraboloid(1.0, 3.0)(found.x, found.s),
        contact_modulus=MODULUS,
        penetration=found.penetration,
        precision=1e-8,
    )
    assert back.force == pytest.approx(4e4, rel=1e-7)
    np.testing.assert_allclose(back.pressure, found.pressure, atol=1e-4 * found.max_pressure)


def test_a_guess_changes_the_cost_and_not_the_answer():
    plain, _ = on_hertz(1.0, 3.0, 4e4, 40)
    gap = paraboloid(1.0, 3.0)(plain.x, plain.s)
    warm = one_grid.solve(
        plain.x, plain.s, gap, contact_modulus=MODULUS, force=4e4, guess=plain.pressure, precision=1e-8
    )
    bad = one_grid.solve(
        plain.x,
        plain.s,
        gap,
        contact_modulus=MODULUS,
        force=4e4,
        precision=1e-8,
        guess=np.random.default_rng(2).random(gap.shape),
    )
    assert warm.iterations <= 2 < plain.iterations < bad.iterations
    assert bad.penetration == pytest.approx(plain.penetration, rel=1e-8)


def test_scaling_with_size():
    """All lengths times k, the load times k^2: the same pressures on the same cells, to the
    residual that is left."""
    one, large = (
        contact.solve_contact(
            lambda x, s, k=k: paraboloid(1.0, 3.0)(x / k, s / k) * k,
            np.array(WIDE) * k,
            contact_modulus=MODULUS,
            force=1e4 * k**2,
        )
        for k in (1.0, 32.0)
    )
    assert large.pressure.shape == one.pressure.shape
    np.testing.assert_allclose(large.pressure, one.pressure, atol=2e-5 * one.max_pressure)
    assert large.penetration == pytest.approx(32.0 * one.penetration, rel=1e-6)
    assert large.area == pytest.approx(32.0**2 * one.area, rel=1e-4)


def test_force_rises_with_penetration():
    loads = [
        contact.solve_contact(paraboloid(1.0, 3.0), WIDE, contact_modulus=MODULUS, penetration=depth).force
        for depth in np.geomspace(1e-9, 1e-4, 11)
    ]
    np.testing.assert_allclose(
        np.diff(np.log(loads)) / np.diff(np.log(np.geomspace(1e-9, 1e-4, 11))), 1.5, atol=2e-3
    )


def test_no_load_and_no_contact():
    x = np.linspace(-1e-3, 1e-3, 9)
    gap = paraboloid(1.0, 1.0)(x, x) + 1e-6
    empty = one_grid.solve(x, x, gap, contact_modulus=MODULUS, force=0.0)
    assert (empty.force, empty.area, empty.penetration) == (0.0, 0.0, pytest.approx(1e-6))
    apart = contact.solve_contact(
        lambda x, s: paraboloid(1.0, 1.0)(x, s) + 1e-6, WIDE, contact_modulus=MODULUS, penetration=5e-7
    )
    assert apart.force == 0.0 and not apart.pressure.any() and apart.clearance.min() >= 5e-7 - 1e-15


# --- wrong input ----------------------------------------------------------------------------------


GRID = (np.linspace(0, 1e-3, 5), np.linspace(0, 1e-3, 4), np.zeros((5, 4)))


@pytest.mark.parametrize(
    "arguments, load, words",
    [
        (GRID, {}, "force is None N and penetration is None m; permitted is exactly one of them"),
        (GRID, {"force": 1.0, "penetration": 1e-6}, "force is 1.0 N and penetration is 1e-06 m"),
        (GRID, {"force": -1.0}, "force is -1.0 N; permitted is force >= 0 N"),
        (GRID, {"force": math.nan}, "force is nan N"),
        (GRID, {"penetration": math.inf}, "penetration is inf m; permitted are finite"),
        (
            GRID,
            {"force": 1.0, "contact_modulus": 0.0},
            "contact_modulus is 0.0 Pa; permitted is contact_modulus > 0 Pa",
        ),
        ((GRID[0][::-1], *GRID[1:]), {"force": 1.0}, "x has shape (5,); permitted are two or more rising"),
        (
            (GRID[0], np.array([0.0, 1e-3, 3e-3, 4e-3]), GRID[2]),
            {"force": 1.0},
            "s has shape (4,); permitted are",
        ),
        ((*GRID[:2], np.zeros((4, 5))), {"force": 1.0}, "gap has shape (4, 5); permitted is (5, 4)"),
        ((*GRID[:2], np.full((5, 4), np.nan)), {"force": 1.0}, "gap holds nan"),
    ],
)
def test_wrong_grids_and_loads_are_refused_in_a_sentence(arguments, load, words):
    with pytest.raises(ValueError) as refusal:
        one_grid.solve(*arguments, **{"contact_modulus": MODULUS, **load})
    assert str(refusal.value).startswith(words) and "\n" not in str(refusal.value)


def test_wrong_domains_and_tolerances_are_refused_in_a_sentence():
    ball, load = paraboloid(1.0, 1.0), {"contact_modulus": MODULUS, "force": 1e4}
    with pytest.raises(ValueError, match=r"domain is \(1, 0, 0, 1\) m; permitted is"):
        contact.solve_contact(ball, (1, 0, 0, 1), **load)
    with pytest.raises(ValueError, match=r"tolerance is 1e-06; permitted is 0.0003 ... 0.1"):
        contact.solve_contact(ball, WIDE, tolerance=1e-6, **load)
    with pytest.raises(ArithmeticError, match=r"the patch reaches [xs] = -?0.001 m, the end of the domain"):
        contact.solve_contact(ball, (-1e-3, 1e-3, -1e-3, 1e-3), **load)
    with pytest.raises(ArithmeticError, match="there is no surface between"):
        contact.solve_contact(lambda x, s: np.full((len(x), len(s)), np.inf), WIDE, **load)
