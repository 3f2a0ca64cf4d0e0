"""The half-space solver: closed forms, tables, an independent program, balances, scaling, and its place in ContactSystem."""

import dataclasses
import doctest
import functools
import math
import pickle

import numpy as np
import pytest
from scipy.integrate import dblquad
from scipy.interpolate import CubicSpline

import wrcontact
from wrcontact import Status
from wrcontact.reference import deflection, edge, halfspace, missed, one_grid, outputs, true_gap
from wrcontact.conventions import MIRROR
from wrcontact.simulation.session import Refused, Session
from wrcontact.interface.variables import REFERENCE
from wrcontact.kernel import layout
from wrcontact.kernel.contact import planes
from wrcontact.kernel.binding.library import Kernel
from wrcontact.profiles.compiled import evaluate_table
from wrcontact.methods import Halfspace
from wrcontact.methods import CHOICES

from tests.reference import brute_force, halfspace_reference
from tests.helpers.constant_curvatures import MODULUS, hertz
from tests.helpers.planar_cases import planar_cases

WIDE = (-0.2, 0.2, -0.2, 0.2)


def paraboloid(A, B):
    return lambda x, s: A * x[:, None] ** 2 + B * s**2


def on_hertz(A, B, force, cells, precision=1e-8, **load):
    """Solution on ``cells`` over Hertz's ellipse and two more on each side; and Hertz's numbers."""
    exact = hertz(A, B, force)
    x, s = (half * (1 + 4 / cells) * (2 * np.arange(cells + 4) + 1 - cells - 4) / (cells + 4) for half in exact[1:3])
    gap = paraboloid(A, B)(x, s)
    return one_grid.solve(x, s, gap, contact_modulus=MODULUS, precision=precision, **(load or {"force": force})), exact


def test_example_of_the_module():
    assert doctest.testmod(halfspace) == (0, 5)


# --- the influence of one cell ------------------------------------------------------------------------------------------


def test_influence_is_the_integral_over_the_cell():
    """1/r integrated by quadrature over a cell that is far from square, one cell and one diagonal away."""
    dx, ds = 1e-4, 3e-4
    influence = deflection.influence(3, 3, dx, ds, contact_modulus=MODULUS)
    for i, j in ((1, 0), (0, 1), (2, 1)):
        def distance(s, x, i=i, j=j):
            return 1.0 / math.hypot(x - i * dx, s - j * ds)
        integral = dblquad(distance, -dx / 2, dx / 2, -ds / 2, ds / 2, epsrel=1e-11)[0]
        assert influence[i, j] == pytest.approx(integral / (math.pi * MODULUS), rel=1e-10)


def test_convolution_is_the_sum():
    """Nothing wraps round: against the plain double sum, on a grid that is not square."""
    pressure = np.random.default_rng(1).random((7, 5))
    bent = deflection.Deflection(pressure.shape, 2e-4, 1e-4, MODULUS)(pressure)
    influence = deflection.influence(7, 5, 2e-4, 1e-4, contact_modulus=MODULUS)
    for i, j in ((0, 0), (6, 4), (2, 3)):
        total = sum(pressure[k, m] * influence[abs(i - k), abs(j - m)] for k in range(7) for m in range(5))
        assert bent[i, j] == pytest.approx(total, rel=1e-12)


# --- closed forms -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("ratio", [0.03, 0.2, 1.0, 5.0, 60.0])
@pytest.mark.parametrize("force", [1e-3, 78.5e3, 1e6])
def test_hertz(ratio, force):
    """Ellipses up to 1:8, nanometres to a millimetre of penetration: 0.1 % in peak pressure, 0.5 % in area."""
    penetration, a, b, pressure = hertz(1.087, 1.087 * ratio, force)
    found = halfspace.solve_contact(paraboloid(1.087, 1.087 * ratio), WIDE, contact_modulus=MODULUS, force=force)
    assert found.penetration == pytest.approx(penetration, rel=3e-4)
    assert found.max_pressure == pytest.approx(pressure, rel=1e-3)
    assert found.area == pytest.approx(math.pi * a * b, rel=5e-3)
    assert found.force == pytest.approx(force, rel=1e-10)
    assert max(found.error.values()) <= halfspace.TOLERANCE


def test_peak_between_cells():
    """The peak of Hertz's pressure a third of a cell away from the nearest centre; the centre itself is 1e-3 lower."""
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
    """Edges within cells: Hertz's own pressure at the centres of 30 cells across; counting cells is off by up to 1 %."""
    errors = []
    for offset in np.linspace(0.0, 0.5, 6):
        x, s = np.arange(-30, 31) + offset, np.arange(-30, 31) + 0.7 * offset
        square = 1 - (x[:, None] / 15) ** 2 - (aspect * s / 30) ** 2 if aspect > 1 else 1 - (x[:, None] ** 2 + s**2) / 225
        area = math.pi * 15 * (30 / aspect if aspect > 1 else 15)
        field = edge.edge_field(np.sqrt(np.maximum(square, 0.0)))
        bias = edge.EDGE_BIAS * 2 * math.pi * 15     # the correction belongs to solved pressures, not to exact ones
        errors.append((edge.edge_area(field) + bias * (30 / aspect / 15 + 1) / 2) / area - 1 if aspect > 1
                      else (edge.edge_area(field) + bias) / area - 1)
    assert np.max(np.abs(errors)) < 4e-3


def test_flat_punch():
    """A rigid cylinder of radius a: N = 2 E* a delta (Johnson 1985, eq. 3.36); an edge, and no surface beyond it."""
    radius, cells = 5e-3, 120
    x = radius * 1.1 * (2 * np.arange(cells) + 1 - cells) / cells
    gap = np.where(np.hypot(x[:, None], x) < radius, 0.0, np.inf)
    found = one_grid.solve(x, x, gap, contact_modulus=MODULUS, penetration=1e-5)
    assert found.force == pytest.approx(2 * MODULUS * radius * 1e-5, rel=0.01)      # the edge is known to half a cell
    by_force = one_grid.solve(x, x, gap, contact_modulus=MODULUS, force=found.force)
    assert by_force.penetration == pytest.approx(1e-5, rel=1e-6)


def test_two_separate_patches_press_each_other_down():
    """Two balls 40 mm apart, patches of 2 mm: each as Hertz under half the load, and N/2 / (pi E* D) deeper."""
    distance, force = 0.04, 2e4
    curvature = 5.0

    def gap(x, s):
        return curvature * (x[:, None] ** 2 + np.minimum((s - distance / 2) ** 2, (s + distance / 2) ** 2))

    alone = hertz(curvature, curvature, force / 2)
    found = halfspace.solve_contact(gap, (-0.05, 0.05, -0.06, 0.06), contact_modulus=MODULUS, force=force)
    # the far patch tilts the surface under the near one: a / D = 0.03
    assert found.penetration == pytest.approx(alone[0] + force / 2 / (math.pi * MODULUS * distance), rel=1e-3)
    assert found.max_pressure == pytest.approx(alone[3], rel=2e-3)
    assert found.area == pytest.approx(2 * math.pi * alone[1] * alone[2], rel=5e-3)
    patches = outputs.split_patches(found)
    assert len(patches) == 2
    assert patches[0].sum() == pytest.approx(patches[1].sum(), rel=1e-3)


# --- properties of the method -----------------------------------------------------------------------------------------------


def test_contact_conditions_hold():
    """p >= 0, no overlap, no pressure where the bodies are apart, to 1e-6 of the penetration."""
    found, _ = on_hertz(1.0, 4.0, 5e4, 40, precision=1e-7)
    loaded = found.pressure > 0.0
    assert np.all(found.pressure >= 0.0) and 0 < np.count_nonzero(loaded) < loaded.size
    assert np.max(np.abs(found.clearance[loaded])) < 1e-6 * found.penetration
    assert np.min(found.clearance[~loaded]) > -1e-6 * found.penetration


def test_grid_error_falls_with_the_cells():
    """Twice the cells, a quarter of the error in penetration (measured 2.1 as exponent), half in area before correction."""
    errors = {"penetration": [], "max_pressure": []}
    for cells in (18, 36, 72):
        found, (penetration, _, _, pressure) = on_hertz(1.0, 2.0, 1e4, cells)
        errors["penetration"].append(abs(found.penetration / penetration - 1))
        errors["max_pressure"].append(abs(found.max_pressure / pressure - 1))
    for name, values in errors.items():
        rate = math.log2(values[0] / values[-1]) / 2
        assert rate > 1.5, (name, values)


@pytest.mark.parametrize("ratio", [1.0, 5.0, 60.0])
def test_estimated_error_bounds_the_real_one(ratio):
    """At four tolerances on Hertz's ellipses, against the closed form."""
    penetration, a, b, pressure = hertz(1.0, ratio, 1e4)
    sizes = []
    for tolerance in (0.05, 0.01, 3e-3, 1e-3):
        found = halfspace.solve_contact(paraboloid(1.0, ratio), WIDE, contact_modulus=MODULUS, force=1e4, tolerance=tolerance)
        assert max(found.error.values()) <= tolerance
        assert abs(found.area / (math.pi * a * b) - 1) < tolerance
        assert abs(found.penetration / penetration - 1) < tolerance
        assert abs(found.max_pressure / pressure - 1) < tolerance
        sizes.append(found.pressure.size)
    assert sizes == sorted(sizes) and sizes[-1] > sizes[0]


def test_prescribed_penetration_is_the_inverse_on_a_grid():
    found, _ = on_hertz(1.0, 3.0, 4e4, 40)
    back = one_grid.solve(found.x, found.s, paraboloid(1.0, 3.0)(found.x, found.s), contact_modulus=MODULUS,
                           penetration=found.penetration, precision=1e-8)
    assert back.force == pytest.approx(4e4, rel=1e-7)
    np.testing.assert_allclose(back.pressure, found.pressure, atol=1e-4 * found.max_pressure)


def test_a_guess_changes_the_cost_and_not_the_answer():
    plain, _ = on_hertz(1.0, 3.0, 4e4, 40)
    gap = paraboloid(1.0, 3.0)(plain.x, plain.s)
    warm = one_grid.solve(plain.x, plain.s, gap, contact_modulus=MODULUS, force=4e4, guess=plain.pressure, precision=1e-8)
    bad = one_grid.solve(plain.x, plain.s, gap, contact_modulus=MODULUS, force=4e4, precision=1e-8,
                          guess=np.random.default_rng(2).random(gap.shape))
    assert warm.iterations <= 2 < plain.iterations < bad.iterations
    assert bad.penetration == pytest.approx(plain.penetration, rel=1e-8)


def test_scaling_with_size():
    """All lengths times k, the load times k^2: the same pressures on the same cells, to the residual that is left."""
    one, large = (halfspace.solve_contact(lambda x, s, k=k: paraboloid(1.0, 3.0)(x / k, s / k) * k, np.array(WIDE) * k,
                                          contact_modulus=MODULUS, force=1e4 * k**2) for k in (1.0, 32.0))
    assert large.pressure.shape == one.pressure.shape
    np.testing.assert_allclose(large.pressure, one.pressure, atol=2e-5 * one.max_pressure)
    assert large.penetration == pytest.approx(32.0 * one.penetration, rel=1e-6)
    assert large.area == pytest.approx(32.0**2 * one.area, rel=1e-4)


def test_force_rises_with_penetration():
    loads = [halfspace.solve_contact(paraboloid(1.0, 3.0), WIDE, contact_modulus=MODULUS, penetration=depth).force
             for depth in np.geomspace(1e-9, 1e-4, 11)]
    np.testing.assert_allclose(np.diff(np.log(loads)) / np.diff(np.log(np.geomspace(1e-9, 1e-4, 11))), 1.5, atol=2e-3)


def test_no_load_and_no_contact():
    x = np.linspace(-1e-3, 1e-3, 9)
    gap = paraboloid(1.0, 1.0)(x, x) + 1e-6
    empty = one_grid.solve(x, x, gap, contact_modulus=MODULUS, force=0.0)
    assert (empty.force, empty.area, empty.penetration) == (0.0, 0.0, pytest.approx(1e-6))
    apart = halfspace.solve_contact(lambda x, s: paraboloid(1.0, 1.0)(x, s) + 1e-6, WIDE, contact_modulus=MODULUS,
                                    penetration=5e-7)
    assert apart.force == 0.0 and not apart.pressure.any() and apart.clearance.min() >= 5e-7 - 1e-15


# --- tables and the independent program ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("case", planar_cases(), ids=lambda case: f"{case['y_ws_mm']}mm")
def test_complete_theory_on_the_planar_gap(case):
    """CONTACT on the same h = x^2/2R + g(s) with cells of 0.1 mm: 1e-4 in penetration, 0.3 % in peak pressure, 0.6 % in area
    (theirs is larger by about 0.05 cells along the edge)."""
    s_given, height = np.array(case["s_mm"]) * 1e-3, CubicSpline(np.array(case["s_mm"]) * 1e-3, np.array(case["g_mm"]) * 1e-3)

    def gap(x, s):
        across = np.where((s >= s_given[0]) & (s <= s_given[-1]), height(s), np.inf)
        return x[:, None] ** 2 / (2e-3 * case["R_x_mm"]) + across

    found = halfspace.solve_contact(gap, (-0.02, 0.02, s_given[0], s_given[-1]), contact_modulus=MODULUS, force=78.5e3)
    truth = case["solution"]
    assert found.penetration == pytest.approx(truth["penetration_mm"] * 1e-3, rel=2e-4)
    assert found.max_pressure == pytest.approx(truth["pmax_MPa"] * 1e6, rel=3e-3)
    assert found.area == pytest.approx(truth["area_fit_mm2"] * 1e-6, rel=6e-3)
    loads = sorted((region["fn_N"] for region in truth["regions"]), reverse=True)
    cell = (found.x[1] - found.x[0]) * (found.s[1] - found.s[0])
    np.testing.assert_allclose([p.sum() * cell for p in outputs.split_patches(found)], loads, rtol=1e-3)


POSES = {  # lateral shift [m], yaw [deg], force [N], side
    "tread": (1e-3, 1.0, 78.5e3, "right"),
    "left": (4e-3, -0.7, 5e4, "left"),
    "two_point": (5e-3, 0.0, 78.5e3, "right"),
    "flange_root": (6e-3, 0.5, 1e5, "right"),
    "flange": (6.5e-3, 2.0, 78.5e3, "right"),
    "light": (6.4e-3, -1.0, 5.0, "right"),
}


@pytest.fixture(scope="module")
def system():
    return wrcontact.ContactSystem(normal_model="halfspace")


@pytest.fixture(scope="module")
def track():
    return brute_force.track()


@functools.lru_cache
def rigid(shift, yaw):
    return brute_force.rigid_contact(brute_force.track(), shift, math.radians(yaw))


def plane_of(system, shift, yaw, side):
    stepper = system.stepper()
    stepper.inputs[:5] = shift, yaw, 0.0, 1e3, 0.0
    rigid_state = system.evaluate(shift, yaw, 1e3)
    return true_gap.contact_plane(stepper._tables, rigid_state.values, stepper.inputs, int(side == "right"))


@pytest.mark.parametrize("name", [pytest.param(name, marks=[pytest.mark.slow] if k else []) for k, name in enumerate(POSES)])
def test_true_gap_is_that_of_the_independent_program(system, track, name):
    """Wherever the gap is below 2 mm: to 1e-11 m, or 1.2e-7 m across the printed steps of S1002, which both take out in
    their own ways (wrcontact/profiles/compiled.py; without_steps)."""
    shift, yaw, _, side = POSES[name]
    x, s = np.linspace(-0.02, 0.02, 21), np.linspace(-0.012, 0.02, 65)
    ours = plane_of(system, shift, math.radians(yaw), side).gap(x, s)
    wheelset = rigid(shift, yaw)
    theirs = halfspace_reference.contact_plane(track, wheelset, side).gap(x, s)
    near = np.isfinite(ours) & (ours < 2e-3)
    assert np.count_nonzero(near) > 300
    assert np.max(np.abs(ours - theirs)[near]) < (1e-11 if name in ("tread", "left") else 1.2e-7)
    # our rail ends where it is steeper than 80 deg: no patch reaches so far
    assert np.min(theirs[np.isinf(ours)], initial=1.0) > 2.5e-4


@pytest.mark.parametrize("name", [pytest.param(name, marks=[pytest.mark.slow] * (name in ("flange", "light", "left")))
                                  for name in POSES])
def test_the_independent_program_agrees(system, track, name):
    """On its grid of 100 or so cells: 3e-4 in penetration, 0.2 % in peak pressure, 0.8 % in area, whose edge it counts
    without the correction for the cells."""
    shift, yaw, force, side = POSES[name]
    wheelset = rigid(shift, yaw)
    truth = halfspace_reference.normal_contact(track, wheelset, side, force)
    found = getattr(system.evaluate(shift, math.radians(yaw), force), side)
    assert found.penetration == pytest.approx(truth.penetration, rel=4e-4)
    assert found.max_pressure == pytest.approx(truth.max_pressure, rel=2e-3)
    assert found.area == pytest.approx(truth.area, rel=8e-3)
    assert found.patch_count == (2 if name == "two_point" else 1)


@pytest.mark.slow
@pytest.mark.parametrize("seed", (3, *(pytest.param(seed, marks=pytest.mark.complete) for seed in (4, 5))))
def test_the_independent_program_agrees_on_random_poses(system, track, seed):
    """Its area, cut along x only, is up to 1.5 % too large on long narrow patches, where ours stands when the tolerance
    becomes five times smaller."""
    rng = np.random.default_rng(seed)
    for _ in range(8):
        shift, yaw, force = rng.uniform(-6.8e-3, 6.8e-3), rng.uniform(-0.03, 0.03), 10 ** rng.uniform(2, 5.2)
        state = system.evaluate(shift, yaw, force)
        wheelset = brute_force.rigid_contact(track, shift, yaw)
        assert state.status == Status.VALID
        for side in ("left", "right"):
            truth = halfspace_reference.normal_contact(track, wheelset, side, force)
            found = getattr(state, side)
            assert found.penetration == pytest.approx(truth.penetration, rel=1e-3), (shift, yaw, force, side)
            assert found.max_pressure == pytest.approx(truth.max_pressure, rel=5e-3), (shift, yaw, force, side)
            assert found.area == pytest.approx(truth.area, rel=0.02), (shift, yaw, force, side)


# --- in ContactSystem -----------------------------------------------------------------------------------------------------


def test_left_is_the_mirror_image(system):
    """The left wheel at -y, -yaw is the right one at y, yaw: everything but the sign of y_track."""
    shift, yaw = 5.1e-3, 0.012
    right = system.evaluate(shift, yaw, 6e4).values[layout.OUT_RIGHT:].copy()
    left = system.evaluate(MIRROR[0] * shift, MIRROR[1] * yaw, 6e4).values[layout.OUT_LEFT:layout.OUT_RIGHT].copy()
    left[layout.SIDE_Y_TRACK] *= -1
    np.testing.assert_allclose(left, right, rtol=1e-6, atol=1e-9)


def test_outputs_of_a_wheel_fit_together(system):
    """5 mm: flange root and tread; totals against patches, the outline against area and load, angles against the rail."""
    state = system.evaluate(5e-3)
    side, heavy = state.right, state.right.patches[0]
    assert state.status == Status.VALID and side.patch_count == len(side.patches) == 2
    assert side.normal_force == pytest.approx(78.5e3, rel=1e-9)
    assert sum(patch.normal_force for patch in side.patches) == pytest.approx(78.5e3, rel=1e-9)
    assert sum(patch.area for patch in side.patches) == pytest.approx(side.area, rel=1e-3)
    assert heavy.normal_force > side.patches[1].normal_force and heavy.max_pressure == side.max_pressure
    moment = sum(patch.normal_force * patch.centroid for patch in side.patches)
    assert moment / 78.5e3 == pytest.approx(side.patch_centroid, rel=1e-6)
    # the flange is on the inner side: lower station, steeper rail
    assert heavy.centroid < side.patches[1].centroid and heavy.contact_angle > side.patches[1].contact_angle + 0.1
    outline = side.outline
    width = outline.station[-1] - outline.station[0]
    assert width == pytest.approx(side.patch_width, rel=1e-9)
    assert np.any(outline.half_length[1:-1] == 0.0)                                     # between the two
    assert 2 * outline.half_length.max() == pytest.approx(side.patch_length, rel=0.02)  # 31 stations
    one = system.evaluate(3e-3).right
    outline = one.outline
    assert np.trapezoid(2 * outline.half_length, outline.station) == pytest.approx(one.area, rel=0.01)
    line = math.pi / 2 * outline.half_length * outline.pressure      # an ellipse along x, as on the planar gap
    assert np.trapezoid(line, outline.station) == pytest.approx(78.5e3, rel=0.02)


def test_light_loads_are_hertz_at_the_contact_point(system):
    """1e-3 N: half a nanometre, so the curvatures at the point decide; yaw turns the ellipse, so without."""
    for shift in (0.0, 3e-3, 6e-3, 7e-3):
        side = system.evaluate(shift, normal_force=1e-3).right
        penetration, a, b, pressure = hertz(side.curvature_x / 2, side.curvature_y / 2, 1e-3)
        assert side.penetration == pytest.approx(penetration, rel=2e-3), shift
        assert side.max_pressure == pytest.approx(pressure, rel=3e-3), shift
        assert side.area == pytest.approx(math.pi * a * b, rel=8e-3), shift
        assert (side.patch_length, side.patch_width) == pytest.approx((2 * a, 2 * b), rel=0.02), shift


def test_prescribed_penetration_is_the_inverse(system):
    for shift, yaw, force in ((3e-3, 0.0, 78.5e3), (5e-3, 0.01, 4e4), (6.5e-3, -0.02, 1e-2)):
        by_force = system.evaluate(shift, yaw, force)
        depths = by_force.left.penetration, by_force.right.penetration
        back = system.evaluate(shift, yaw, penetration=depths)
        for one, other, depth in ((by_force.left, back.left, depths[0]), (by_force.right, back.right, depths[1])):
            assert other.penetration == depth
            assert other.normal_force == pytest.approx(one.normal_force, rel=5e-4), (shift, yaw, force)
    assert system.evaluate(1e-3).right.normal_force == pytest.approx(78.5e3)


def test_tables_transfer_and_unloaded_wheels(system):
    shift = np.array([0.0, 2e-3, np.nan, 6e-3])
    table = system.evaluate_many(shift, 0.005, 5e4, [0.2, 1.0, 0.0, -0.5])
    np.testing.assert_array_equal(table.status, [0, 1, 4, 0])
    np.testing.assert_allclose(table.right.normal_force, [6e4, 1e5, np.nan, 2.5e4])
    np.testing.assert_allclose(table.left.normal_force, [4e4, 0.0, np.nan, 7.5e4])
    assert (table.left.area[1], table.left.patch_count[1], table.left.penetration[1]) == (0.0, 0.0, 0.0)
    assert np.isfinite(table.left.contact.y_wheel[1]) and np.all(np.isnan(table.values[2]))
    one = system.evaluate(6e-3, 0.005, 5e4, -0.5)
    assert one.right.area == pytest.approx(table.right.area[3], rel=1e-9)
    empty = system.evaluate(2e-3, penetration=(0.0, 5e-5))
    assert empty.status == Status.UNLOADED and empty.left.normal_force == 0.0 and empty.right.normal_force > 1e4


def test_roll_and_contact_are_the_kernels(system):
    plain, solved = wrcontact.ContactSystem().evaluate(5e-3, 0.01), system.evaluate(5e-3, 0.01)
    assert solved.roll == pytest.approx(plain.roll, abs=1e-13)
    for first in (layout.OUT_LEFT, layout.OUT_RIGHT):
        geometry = slice(first + layout.SIDE_X_WHEEL, first + layout.SIDE_PENETRATION)
        np.testing.assert_allclose(solved.values[geometry], plain.values[geometry], rtol=1e-9, atol=1e-12)


def test_what_does_not_converge_is_status_3_and_keeps_the_outputs():
    """Rubber: the patch would be larger than the wheel.  The stepper goes on with the next input."""
    stepper = wrcontact.ContactSystem(normal_model="halfspace", youngs_modulus=1e7).stepper()
    stepper.inputs[:5] = 1e-3, 0.0, 0.0, 1.0, 0.0
    assert stepper.step() == Status.VALID
    kept = stepper.outputs.copy()
    for wrong, status in (((1e-3, 0, 0, 1e6, 0), 3), ((1.0, 0, 0, 1.0, 0), 2), ((np.nan, 0, 0, 1.0, 0), 4)):
        stepper.inputs[:5] = wrong
        assert stepper.step() == status
        np.testing.assert_array_equal(stepper.outputs, kept)
    stepper.inputs[:5] = 1e-3, 0.0, 0.0, 1.0, 0.0
    assert stepper.step() == Status.VALID
    np.testing.assert_allclose(stepper.outputs, kept, rtol=1e-9, atol=1e-12)


def test_tolerance_decides_the_grid(system):
    assert Halfspace.numbers()["tolerance"].low == halfspace.TOLERANCE_RANGE[0]
    coarse = wrcontact.ContactSystem(normal_model="halfspace", tolerance=0.03)
    fine = wrcontact.ContactSystem(normal_model="halfspace", tolerance=2e-3)
    assert pickle.loads(pickle.dumps(coarse)).stepper()._bound.tolerance == 0.03
    for shift in (2e-3, 6e-3):
        truth = fine.evaluate(shift).right
        for given, allowed in ((coarse, 0.03), (system, halfspace.TOLERANCE)):
            side = given.evaluate(shift).right
            for name in ("penetration", "area", "max_pressure"):
                assert getattr(side, name) == pytest.approx(getattr(truth, name), rel=allowed), (shift, name, allowed)


# --- patches that a first grid steps over ---------------------------------------------------------------------------------


#: Rail, inclination, (lateral shift [m], yaw [rad], force [N]), side, how much deeper ANALYN stands for giving the second
#: patch its own plane, and of each patch: load [N], centroid [m].
MISSED = {
    "flange_ahead": ("60E1", 1 / 40, (-0.006037944, -0.026654101, 8107.57), "left", 0.053, [(5092, 0.0), (3015, -9.54e-3)]),
    "three": ("UIC60", 1 / 20, (-0.005960749371552871, 0.0, 6283.808696130702), "left", 0.003,
              [(3810, -0.4e-3), (1828, -22.66e-3), (646, -36.98e-3)]),
    "inner": ("60E1", 1 / 20, (0.006257170613387163, 0.018450140773861007, 30717.30179453353), "right", 0.000,
              [(22803, -0.2e-3), (7915, -9.05e-3)]),
    "flange_root": ("54E1", 1 / 40, (0.0058417922877720425, -0.03358323754363793, 60084.7449943978), "right", 0.002,
                    [(46376, -0.1e-3), (13708, -9.91e-3)]),
    "far_ahead": ("UIC60", 1 / 40, (0.005324708915429254, -0.05511213786185546, 35566.6), "right", 0.036,
                  [(31005, -0.2e-3), (4562, -20.87e-3)]),
    "farthest": ("UIC60", 1 / 20, (-0.005033642375874028, 0.07105501647277541, 107146.0), "left", 0.046,
                 [(94981, -1.1e-3), (12165, -45.06e-3)]),
}


@pytest.mark.parametrize("name", [pytest.param(name, marks=[pytest.mark.slow] * (k > 0) + [pytest.mark.complete] * (k > 2))
                                  for k, name in enumerate(MISSED)])
def test_no_patch_is_missed(name, monkeypatch):
    """Loads and places as measured (ANALYN, which looks in another way, has them within 10 % of the total, and 0.2 mm); and
    nowhere on a dense grid over the whole domain do the bodies overlap by more than 1 % of the penetration.

    The half-space presses both patches along the normal of one plane, the contact point's, and ANALYN in one plane stands
    as deep within 3 %.  By default it gives a patch that leans away its own plane: a flange at 70 deg then gets only the
    cosine of the wheel's approach, and the wheel stands up to 5 % deeper.
    """
    rail, inclination, pose, side, deeper, patches = MISSED[name]
    model = wrcontact.ContactSystem(rail=rail, rail_inclination=inclination, normal_model="halfspace", tolerance=0.02)
    state = model.evaluate(*pose, side=side)
    found = getattr(state, side)
    assert state.status == Status.VALID and found.patch_count == len(patches)
    assert sum(patch.normal_force for patch in found.patches) == pytest.approx(pose[2], rel=1e-9)
    for patch, (load, centroid) in zip(found.patches, patches):
        assert patch.normal_force == pytest.approx(load, abs=0.01 * pose[2])
        assert patch.centroid == pytest.approx(centroid, abs=2e-4)
        assert 0.0 < patch.width < 0.01
    pair = {"rail": rail, "rail_inclination": inclination}
    split = getattr(wrcontact.ContactSystem(**pair).evaluate(*pose), side)
    other = getattr(analyn_in_one_plane(monkeypatch, **pair).evaluate(*pose), side)
    assert found.penetration == pytest.approx(other.penetration, rel=0.03)
    assert split.penetration / other.penetration - 1 == pytest.approx(deeper, abs=2e-3)
    plane = true_gap.contact_plane(model._own.stepper._tables, state.values, state.inputs, int(side == "right"))
    x, s = np.linspace(-true_gap.REACH_X, true_gap.REACH_X, 151), np.linspace(-true_gap.REACH_S, true_gap.REACH_S, 1067)
    i, j = np.nonzero(plane.gap(x, s) < found.penetration)
    contact = solved(plane, pose[2], 0.02)
    away = np.array([not missed.is_loaded(contact, x[a], s[b]) for a, b in zip(i, j)], dtype=bool)
    i, j = i[away], j[away]
    bent = deflection_at(contact, x[i], s[j])
    overlap = contact.penetration - plane.gap(x, s)[i, j] - bent
    assert np.max(overlap, initial=0.0) < 0.01 * contact.penetration


def analyn_in_one_plane(monkeypatch, **parameters):
    """ANALYN, uncompiled, whose regions lie in the contact point's plane however far they lean away from it."""
    monkeypatch.setattr(planes, "SPLIT", 2.0)                                     # no sine is that large
    monkeypatch.setattr(wrcontact.stepper, "default_kernel", Kernel)
    return wrcontact.ContactSystem(**parameters)


@pytest.mark.parametrize("model, shift", [("analyn", 6.125e-3), ("analyn", 6.135e-3), ("analyn_strip", 6.125e-3)])
def test_a_patch_that_leans_away_is_the_half_space_s_in_its_own_plane(model, shift):
    """The flange beside the flange root, 44 deg apart, in rows of the stored run "jumps": under its load the half-space on
    its own tangent plane, without its neighbour, has its pressure (1.7 and 2.2 GPa) and area.  In the contact point's
    plane, as stored, the pressure is twice that (3.4 and 4.0 GPa)."""
    stepper = wrcontact.ContactSystem(normal_model=model).stepper()
    stepper.inputs[:5] = shift, 0.0174532925199433, 0.0, 78.5e3, 0.0
    assert stepper.step() == Status.VALID
    wheel = wrcontact.state.WheelsetState(stepper.outputs, 0, stepper.inputs).right
    patch = next(patch for patch in wheel.patches if abs(patch.contact_angle - wheel.contact_angle) > 0.7)
    contact = true_gap.contact_plane(stepper._tables, stepper.outputs, stepper.inputs, 1)
    plane = plane_at(contact, wheel, patch)
    domain = [1.1 * sign * extent for extent in (patch.length, patch.width) for sign in (-1, 1)]
    truth = halfspace.solve_contact(plane.gap, domain, contact_modulus=MODULUS, force=patch.normal_force, tolerance=0.02)
    assert patch.max_pressure == pytest.approx(truth.max_pressure, rel=0.03)
    assert patch.area == pytest.approx(truth.area, rel=0.05)


def plane_at(contact, wheel, patch):
    """The tangent plane of a patch's centre of load, as ``contact`` is that of the rigid contact point."""
    guess = wheel.contact.y_rail + patch.centroid * math.cos(0.5 * (wheel.contact_angle + patch.contact_angle))
    places = np.linspace(guess - 3e-3, guess + 3e-3, 6001)
    angles = -np.arctan(evaluate_table(contact.rail, places)[1])
    y = places[np.argmin(np.abs(angles - patch.contact_angle))]
    origin = np.array([contact.origin[0], y + contact.rail_y, float(evaluate_table(contact.rail, y)[0])])
    along = np.linspace(-0.06, 0.06, 2401)
    plane = dataclasses.replace(contact, origin=origin, angle=patch.contact_angle)
    origin[0] += along[np.argmin(plane.wheel_height(along, np.zeros(1))[:, 0])]
    x, _, z = contact.attitude.T @ (origin - contact.centre)
    return dataclasses.replace(plane, origin=origin, around=math.atan2(x, z))


def solved(plane, force, tolerance):
    domain = -true_gap.REACH_X, true_gap.REACH_X, -true_gap.REACH_S, true_gap.REACH_S
    modulus = wrcontact.ContactSystem()._tables[layout.SET_CONTACT_MODULUS]
    return halfspace.solve_contact(plane.gap, domain, contact_modulus=modulus, force=force, tolerance=tolerance)


def deflection_at(contact, x, s):
    """u at places (k,) under every loaded cell as a rectangle: no lumps, no transform."""
    rows, columns = np.nonzero(contact.pressure)
    dx, ds = contact.x[1] - contact.x[0], contact.s[1] - contact.s[0]
    bent = []
    for one, other in zip(x, s):
        away_x, away_s = one - contact.x[rows] + 1e-12, other - contact.s[columns] + 1e-12     # not on an edge
        corners = [sign * deflection.corner_potential(away_x + a * dx / 2, away_s + b * ds / 2)
                   for a, b, sign in ((1, 1, 1), (-1, 1, -1), (1, -1, -1), (-1, -1, 1))]
        modulus = wrcontact.ContactSystem()._tables[layout.SET_CONTACT_MODULUS]
        bent.append(np.sum(contact.pressure[rows, columns] * sum(corners)) / (math.pi * modulus))
    return np.array(bent)


def test_grids_of_two_patches_press_each_other_down():
    """Two grids of equal cells are one grid with a hole: against the plain convolution over both."""
    random = np.random.default_rng(3)
    corners, shape = np.array([(0, 0), (9, 5)]), (2, 4, 3)
    pressure = random.random(shape)
    whole = np.zeros((13, 8))
    whole[:4, :3], whole[9:, 5:] = pressure
    bent = deflection.Deflection(whole.shape, 2e-4, 1e-4, MODULUS)(whole)
    parts = deflection.BlockDeflection(shape, corners, 2e-4, 1e-4, MODULUS)(pressure)
    np.testing.assert_allclose(parts[0], bent[:4, :3], rtol=1e-10)
    np.testing.assert_allclose(parts[1], bent[9:, 5:], rtol=1e-10)


def test_a_missed_patch_with_its_own_grid():
    """A ball, and 45 mm away a narrow ridge; force and penetration are each other's inverse, with two patches."""
    def gap(x, s):
        ball = x[:, None] ** 2 + s**2
        return np.minimum(ball, 4e-6 + (x[:, None] - 0.03) ** 2 + 100.0 * (s - 0.0347) ** 2)

    domain = (-0.15, 0.15, -0.08, 0.08)
    found = halfspace.solve_contact(gap, domain, contact_modulus=MODULUS, force=1e4, tolerance=0.02)
    patches = outputs.split_patches(found)
    assert len(patches) == 2 and np.all(np.diff(found.x) > 0.0)
    back = halfspace.solve_contact(gap, domain, contact_modulus=MODULUS, penetration=found.penetration, tolerance=0.02)
    assert back.force == pytest.approx(1e4, rel=5e-3)
    assert len(outputs.split_patches(back)) == 2
    held = np.isfinite(found.clearance)
    assert found.clearance[held].min() > -1e-3 * found.penetration     # the residual is 2e-5 in the root mean square


def test_area_where_bodies_graze():
    """Row 41 of the stored hunting run: p^2 continued from coarse cells ended outside the loaded ones, 3 % too large."""
    pose = 7.92637e-4, -0.010910954, 78500.0, 0.026074
    coarse, fine = (wrcontact.ContactSystem(normal_model="halfspace", tolerance=tolerance).evaluate(*pose, side="left").left
                    for tolerance in (0.01, 2e-3))
    assert coarse.area == pytest.approx(fine.area, rel=0.01)


@pytest.mark.parametrize("shift, yaw", [(5e-3, 0.01), (-6.5e-3, 0.02), (7e-3, 0.0)])
def test_the_resultant_is_that_of_the_patches(system, shift, yaw):
    """Force and moment of the patches on their own normals; ANALYN's, which takes the normals at the smallest gaps, are
    near; and the mirror has the mirrored ones."""
    state, near = system.evaluate(shift, yaw), wrcontact.ContactSystem().evaluate(shift, yaw)
    patches = [(sign, patch) for sign, side in ((-1, state.left), (1, state.right)) for patch in side.patches]
    force = -np.sum([[sign * p.normal_force * math.sin(p.contact_angle), p.normal_force * math.cos(p.contact_angle)]
                     for sign, p in patches], axis=0)
    np.testing.assert_allclose([state.force.y, state.force.z], force, rtol=1e-6)
    np.testing.assert_allclose(state.values[layout.OUT_FORCE:layout.OUT_LEFT], near.values[layout.OUT_FORCE:layout.OUT_LEFT],
                               atol=0.02 * 78.5e3)
    assert np.linalg.norm(state.values[layout.OUT_MOMENT:layout.OUT_LEFT]) > 1e4
    other = system.evaluate(-shift, -yaw).values[layout.OUT_FORCE:layout.OUT_LEFT]
    np.testing.assert_allclose(other * outputs.MIRRORED_RESULTANT, state.values[layout.OUT_FORCE:layout.OUT_LEFT],
                               rtol=1e-4, atol=1.0)


def test_the_resultant_follows_a_prescribed_penetration(system):
    """And it is there only for both wheels with their loads."""
    state = system.evaluate(1e-3, penetration=(5e-5, 0.0))
    left = state.left
    assert state.force.z == pytest.approx(-left.normal_force * math.cos(left.patches[0].contact_angle), rel=1e-6)
    for wanted in ({"side": "right"}, {"outputs": "geometry"}):
        some = system.evaluate(1e-3, **wanted)
        assert np.all(np.isnan(some.values[layout.OUT_FORCE:layout.OUT_LEFT])) and np.isfinite(some.roll)


def test_only_what_is_wanted_is_there(system):
    """No outline with "patches"; the rest as with "all"."""
    plain, short = system.evaluate(1e-3), system.evaluate(1e-3, outputs="patches")
    for side in ("left", "right"):
        outline = getattr(short, side).outline
        assert np.all(np.isnan(outline.station)) and np.all(np.isnan(outline.pressure))
        for name in ("penetration", "area", "max_pressure", "patch_length"):
            assert getattr(getattr(short, side), name) == pytest.approx(getattr(getattr(plain, side), name), rel=1e-9)
    state = system.evaluate(1e-3, outputs="geometry")
    assert np.isnan(state.right.area) and np.isfinite(state.right.contact_angle)


def test_unchanged_inputs_are_not_solved_again(monkeypatch):
    stepper = wrcontact.ContactSystem(normal_model="halfspace", tolerance=0.05).stepper()
    calls, solve = [], halfspace.solve_contact
    monkeypatch.setattr(halfspace, "solve_contact", lambda *given, **named: calls.append(1) or solve(*given, **named))
    stepper.inputs[:5] = 1e-3, 0.0, 0.0, 5e4, 0.0
    assert stepper.step() == Status.VALID and len(calls) == 2
    kept = stepper.outputs.copy()
    stepper.outputs[:] = 0.0
    assert stepper.step() == Status.VALID and len(calls) == 2
    np.testing.assert_array_equal(stepper.outputs, kept)
    stepper.prescribe(2e-5)
    assert stepper.step() == Status.VALID and len(calls) == 4
    stepper.inputs[0] = 1.0
    assert stepper.step() == Status.OFF_PROFILE
    stepper.inputs[0] = 1e-3
    assert stepper.step() == Status.VALID and len(calls) == 6


# --- wrong input ------------------------------------------------------------------------------------------------------------


GRID = (np.linspace(0, 1e-3, 5), np.linspace(0, 1e-3, 4), np.zeros((5, 4)))


@pytest.mark.parametrize("arguments, load, words", [
    (GRID, {}, "force is None N and penetration is None m; permitted is exactly one of them"),
    (GRID, {"force": 1.0, "penetration": 1e-6}, "force is 1.0 N and penetration is 1e-06 m"),
    (GRID, {"force": -1.0}, "force is -1.0 N; permitted is force >= 0 N"),
    (GRID, {"force": math.nan}, "force is nan N"),
    (GRID, {"penetration": math.inf}, "penetration is inf m; permitted are finite"),
    (GRID, {"force": 1.0, "contact_modulus": 0.0}, "contact_modulus is 0.0 Pa; permitted is contact_modulus > 0 Pa"),
    ((GRID[0][::-1], *GRID[1:]), {"force": 1.0}, "x has shape (5,); permitted are two or more rising"),
    ((GRID[0], np.array([0.0, 1e-3, 3e-3, 4e-3]), GRID[2]), {"force": 1.0}, "s has shape (4,); permitted are"),
    ((*GRID[:2], np.zeros((4, 5))), {"force": 1.0}, "gap has shape (4, 5); permitted is (5, 4)"),
    ((*GRID[:2], np.full((5, 4), np.nan)), {"force": 1.0}, "gap holds nan"),
])
def test_wrong_grids_and_loads_are_refused_in_a_sentence(arguments, load, words):
    with pytest.raises(ValueError) as refusal:
        one_grid.solve(*arguments, **{"contact_modulus": MODULUS, **load})
    assert str(refusal.value).startswith(words) and "\n" not in str(refusal.value)


def test_wrong_domains_and_tolerances_are_refused_in_a_sentence():
    ball, load = paraboloid(1.0, 1.0), {"contact_modulus": MODULUS, "force": 1e4}
    with pytest.raises(ValueError, match=r"domain is \(1, 0, 0, 1\) m; permitted is"):
        halfspace.solve_contact(ball, (1, 0, 0, 1), **load)
    with pytest.raises(ValueError, match=r"tolerance is 1e-06; permitted is 0.0003 ... 0.1"):
        halfspace.solve_contact(ball, WIDE, tolerance=1e-6, **load)
    with pytest.raises(ArithmeticError, match=r"the patch reaches [xs] = -?0.001 m, the end of the domain"):
        halfspace.solve_contact(ball, (-1e-3, 1e-3, -1e-3, 1e-3), **load)
    with pytest.raises(ArithmeticError, match="there is no surface between"):
        halfspace.solve_contact(lambda x, s: np.full((len(x), len(s)), np.inf), WIDE, **load)


@pytest.mark.parametrize("arguments, sentence", [
    ({"normal_model": "halfspace", "longitudinal_curvature": "basic"},
     "longitudinal_curvature is 'basic'; permitted with the normal_model 'halfspace'"),
    ({"normal_model": "halfspace", "separation": "vertical"},
     "separation is 'vertical'; permitted with the normal_model 'halfspace', which knows the whole surface, is 'normal'"),
    ({"normal_model": "halfspace", "lateral_curvature": "rough"},
     "lateral_curvature is 'rough'; permitted with the normal_model 'halfspace'"),
    ({"tolerance": 0.5}, "tolerance is 0.5; permitted is 0.0001 ... 0.1"),
    ({"normal_model": "halfspace", "tolerance": 2e-4},
     "tolerance is 0.0002; permitted with the normal_model 'halfspace' is 0.0003 ... 0.1"),
    ({"tolerance": "fine"}, "tolerance is 'fine'; permitted is"),
    ({"normal_model": "kalker"}, "normal_model is 'kalker'; permitted are 'analyn',"),
])
def test_wrong_parameters_are_refused_in_a_sentence(arguments, sentence):
    with pytest.raises(ValueError) as refusal:
        wrcontact.ContactSystem(**arguments)
    assert str(refusal.value).startswith(sentence) and "\n" not in str(refusal.value)


def test_the_session_of_an_fmu_refuses_it():
    session = Session()
    session.set_strings([REFERENCE["normal_model"]], ["halfspace"])
    with pytest.raises(Refused) as refusal:
        session.start()
    permitted = ", ".join(repr(choice) for choice in CHOICES["normal_model"])
    assert "halfspace" not in permitted
    assert str(refusal.value) == f"normal_model is 'halfspace'; permitted are {permitted}"
