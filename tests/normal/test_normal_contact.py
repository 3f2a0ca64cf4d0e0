"""Normal contact: Hertz in closed form, the complete theory's tables, balances, limits and scaling."""

import numpy as np
import pytest

import data
import wrcontact
from data.hertz import MODULUS, hertz
from tests.helpers.cases import MODELS, planar_cases
from tests.helpers.constant_curvatures import lay_constant_curvatures
from wrcontact.halfspace.hertz import coefficients
from wrcontact.kernel import layout
from wrcontact.kernel.binding.fixed_tables import hertz_table
from wrcontact.kernel.normal import analyn
from wrcontact.kernel.normal.coefficients import (
    FLOOR,
    GROWTH,
    adaptive_curvatures,
    hertz_coefficients,
    hertz_stiffness,
)
from wrcontact.kernel.normal.node_patches import fill_from_nodes
from wrcontact.kernel.patch.outline import write_outline
from wrcontact.kernel.wheelset.report import report_load, report_outline

TABLE = layout.HertzTable.at(hertz_table())
CURVATURES = [(1.087, 1.087 * ratio) for ratio in (0.03, 0.2, 0.7, 1.3, 5.0, 60.0)]


@pytest.mark.parametrize("ratio", np.exp(np.linspace(-15, 15, 31)))
def test_hertz_table_holds_the_elliptic_integrals(ratio):
    one_alpha, one_beta, nr = hertz_coefficients(TABLE, 1.0, ratio)
    exact_alpha, exact_nr = coefficients(np.log(ratio))
    assert (one_alpha, nr) == pytest.approx((float(exact_alpha), float(exact_nr)), rel=1e-11)
    assert one_beta == pytest.approx(float(coefficients(-np.log(ratio))[0]), rel=1e-11)
    # and those are Hertz's, by scipy: penetration = (1 + alpha) A a^2 = (1 + beta) B b^2
    if abs(np.log(ratio)) < 11 and abs(np.log(ratio)) > 1e-9:
        penetration, a, b, _ = hertz(1.0, ratio, 1e4)
        assert one_alpha * a**2 == pytest.approx(penetration, rel=1e-8)
        assert one_beta * ratio * b**2 == pytest.approx(penetration, rel=1e-8)


@pytest.mark.parametrize("A, B", CURVATURES)
def test_hertz_stiffness(A, B):
    penetration = hertz(A, B, 78.5e3)[0]
    _, one_beta, nr = hertz_coefficients(TABLE, A, B)
    assert hertz_stiffness(one_beta, nr, B, MODULUS) * penetration**1.5 == pytest.approx(78.5e3, rel=1e-8)


def solve_constant_curvatures(A, B, force, half_nodes=15, window=3):
    """The kernel's ANALYN, from nodes to patches, on the gap B s^2 and constant A: penetration [m], side,
    strips and outputs of the side."""
    tables, work, penetration = lay_constant_curvatures(A, B, force, half_nodes, window)
    found, satisfied = analyn.solve_penetrations(
        tables, work.contact.regions, work.contact.nodes, 1, force, 0.7 * penetration, 0
    )
    assert satisfied == 1
    side, out = work.sides[1], work.outputs.left[1]
    fill_from_nodes(work.contact, side, 1)
    write_outline(side.outline, layout.STATION_COUNT, side, work.contact.strips, work.contact.regions, 1)
    report_load(side, out, 1.0, False)
    report_outline(side, layout.Outline.at(work, layout.offset(out.station, work)), layout.STATION_COUNT, 0)
    return found, side, work.contact.strips, out


@pytest.mark.parametrize("A, B", CURVATURES)
@pytest.mark.parametrize("force", [1.0, 78.5e3])
def test_analyn_on_constant_curvatures_is_hertz(A, B, force):
    penetration, a, b, pressure = hertz(A, B, force)
    found, _, _, side = solve_constant_curvatures(A, B, force)
    assert found == pytest.approx(penetration, rel=1e-9)
    assert side.area == pytest.approx(np.pi * a * b, rel=1e-9)
    assert side.max_pressure == pytest.approx(pressure, rel=1e-9)
    assert side.patch_length == pytest.approx(2 * a, rel=1e-9)
    assert side.patch_width == pytest.approx(2 * b, rel=1e-9)
    assert side.patch_centroid == pytest.approx(0.0, abs=1e-12 * b)
    assert side.normal_force == pytest.approx(force, rel=1e-12)
    ellipse = np.sqrt(np.maximum(0.0, 1 - (np.array(side.station) / b) ** 2))
    # the ends, like a root, to 1e-12
    np.testing.assert_allclose(side.half_length, a * ellipse, atol=1e-6 * a)


@pytest.mark.parametrize("A, B", CURVATURES)
def test_strips_of_a_solved_patch_are_slices_of_hertz_s_ellipse(A, B):
    _, a, b, pressure = hertz(A, B, 78.5e3)
    _, side, strips, _ = solve_constant_curvatures(A, B, 78.5e3)
    assert side.patch_count == 1
    patch = side.patches[0]
    assert (patch.rank, patch.rule) == (1, layout.RULE_QUADRATIC)
    assert (patch.totals.start, patch.totals.stop) == pytest.approx((-b, b), rel=1e-9)
    strips = np.ctypeslib.as_array(strips)[patch.first : patch.last + 1]
    assert strips["width"].sum() == pytest.approx(patch.totals.width, rel=1e-12)
    inside = strips[strips["width"] > 0.0]
    share = 1 - (inside["station"] / b) ** 2
    np.testing.assert_allclose(inside["half_length_square"], a**2 * share, rtol=1e-8)
    np.testing.assert_allclose(inside["pressure_square"], pressure**2 * share, rtol=1e-8)
    np.testing.assert_allclose(inside["line_load"], np.pi / 2 * a * pressure * share, rtol=1e-8)
    np.testing.assert_allclose(inside["curvature"], 2 * A, rtol=1e-12)
    outside = strips[strips["width"] == 0.0]
    assert (outside["half_length_square"] <= 0.0).all()


@pytest.fixture(scope="module")
def system():
    return wrcontact.ContactSystem()


@pytest.mark.parametrize("shift", [0.0, 1e-3, 3e-3, 5e-3, 6e-3])
def test_hertz_model_is_hertz_with_the_curvatures_at_the_contact(shift):
    side = wrcontact.ContactSystem(normal_model="hertz").evaluate(lateral_shift=shift).right
    A, B = side.curvature_x / 2, max(side.curvature_y / 2, FLOOR * side.curvature_x / 2)
    penetration, a, b, pressure = hertz(A, B, 78.5e3)
    assert (side.penetration, side.area, side.max_pressure) == pytest.approx(
        (penetration, np.pi * a * b, pressure), rel=1e-8
    )
    outline = side.outline
    np.testing.assert_allclose((outline.half_length / a) ** 2 + (outline.station / b) ** 2, 1.0, atol=1e-8)


@pytest.mark.parametrize(
    "model, penetration, area, pressure, centroid",
    [
        # measured 0.58, 1.39, 3.34 % and 0.29 mm on a tread patch 20 mm wide; 0.12, 0.54, 0.68 % and 0.032 mm
        ("analyn", 0.0088, 0.0209, 0.048, 4.3e-4),
        ("analyn_strip", 0.0017, 0.0081, 0.0102, 4.8e-5),
    ],
)
@pytest.mark.parametrize("case", planar_cases(), ids=lambda case: f"{case['y_ws_mm']}mm")
def test_complete_theory_on_the_planar_gap(case, model, penetration, area, pressure, centroid):
    """CONTACT's frictionless solution for the gap in the tangent plane, whose area follows elements of 0.1 mm
    and is up to 0.6 % too large. At 5 and 6 mm the patch turns by 10 degrees and more, so that this is
    another gap; there CONTACT counts with wheel and rail as they are, below."""
    truth = case["solution"]
    side = wrcontact.ContactSystem(normal_model=model).evaluate(lateral_shift=case["y_ws_mm"] * 1e-3).right
    assert side.contact_angle == pytest.approx(-case["delta_rad"], abs=1e-4)
    # theirs is r / cos(angle in the track), exact is the angle in the wheelset's
    # frame: roll times tan(angle) less
    assert 1e3 / side.curvature_x == pytest.approx(case["R_x_mm"], rel=4e-4)
    assert side.patch_count == len(truth["regions"])
    if case["y_ws_mm"] >= 5.0:
        return
    assert side.penetration == pytest.approx(truth["penetration_mm"] * 1e-3, rel=penetration)
    assert side.area == pytest.approx(truth["area_fit_mm2"] * 1e-6, rel=area)
    assert side.max_pressure == pytest.approx(truth["pmax_MPa"] * 1e6, rel=pressure)
    centre = sum(region["s_centroid_mm"] * region["fn_N"] for region in truth["regions"]) / 78500
    assert side.patch_centroid == pytest.approx(centre * 1e-3, abs=centroid)  # [m]


@pytest.mark.parametrize(
    "model, mean, worst",
    [
        # measured 0.71, 1.29, 0.72 % and 1.29, 6.48, 3.21 %
        ("analyn", (0.0092, 0.0168, 0.0094), (0.0194, 0.0972, 0.0481)),
        # measured 0.22, 0.44, 0.42 % and 0.72, 0.97, 0.78 %
        ("analyn_strip", (0.0033, 0.0066, 0.0063), (0.0108, 0.0146, 0.0117)),
        # measured 0.20, 0.24, 0.11 % and 0.57, 1.05, 0.30 %
        ("halfspace", (0.0027, 0.0032, 0.0014), (0.0086, 0.0158, 0.0045)),
    ],
)
def test_complete_theory_with_full_geometry_and_yaw(model, mean, worst):
    """CONTACT with wheel and rail as they are, some yawed, finest grid of each pose. Its contact plane is the
    load-weighted one; at 5 and 6 mm that is 0.09 and 0.02 rad away from the rigid one, which turns the
    approach by 0.4 % at most."""
    rows = data.rows_of(data.FOLDER / "contact_full.csv")
    finest = {(row["lateral_shift_mm"], row["yaw_deg"]): row for row in rows}
    system = wrcontact.ContactSystem(normal_model=model)
    compared = []
    for (shift, yaw), row in finest.items():
        side = system.evaluate(lateral_shift=shift * 1e-3, yaw=np.radians(yaw), side="right").right
        compared.append(
            [
                side.penetration * 1e3 / row["penetration_mm"],
                side.area * 1e6 / row["area_fit_mm2"],
                side.max_pressure * 1e-6 / row["max_pressure_MPa"],
            ]
        )
    error = np.abs(np.array(compared) - 1)
    assert len(error) == 8
    assert np.all(error.mean(axis=0) < mean), error
    assert np.all(error.max(axis=0) < worst), error


def random_poses(count, seed):
    rng = np.random.default_rng(seed)
    shift = rng.uniform(-0.0066, 0.0066, count)
    yaw = rng.uniform(-0.035, 0.035, count) * (rng.random(count) < 0.5)
    return shift, yaw, 10 ** rng.uniform(0.0, 5.5, count)


def test_force_balance_and_sane_patches(system):
    shift, yaw, force = random_poses(1500, 7)
    transfer = np.random.default_rng(8).uniform(-0.9, 0.9, 1500)
    table = system.evaluate_many(shift, yaw, force, transfer)
    assert not np.any(table.status)
    for sign, side in ((-1, table.left), (1, table.right)):
        np.testing.assert_allclose(side.normal_force, force * (1 + sign * transfer), rtol=1e-6)
        shown = sum(patch.normal_force for patch in side.patches)
        few = side.patch_count <= 3
        np.testing.assert_allclose(shown[few], side.normal_force[few], rtol=1e-9)
        for name in ("penetration", "area", "max_pressure", "patch_length", "patch_width"):
            assert np.all(getattr(side, name) > 0), name
        # no spurious peak: not above four times the Hertz pressure of the mean, p = 1.5 N / area (3.4
        # of two joined regions)
        assert np.all(side.max_pressure < 6 * side.normal_force / side.area)
        outline = side.outline
        assert np.all(np.diff(outline.station, axis=1) > 0) and np.all(outline.half_length >= 0)
        # 31 stations can miss a narrow second patch
        longest = 2 * outline.half_length.max(axis=1) / side.patch_length
        assert longest.max() < 1 + 1e-12 and np.all(longest[side.patch_count == 1] > 0.9)
        width = outline.station[:, -1] - outline.station[:, 0]
        np.testing.assert_allclose(width, side.patch_width, rtol=1e-12)


@pytest.mark.parametrize("model", MODELS)
def test_the_prescribed_force_is_met(model):
    """By the loads of all patches, to ten digits, wherever the wheels stand and whatever they carry."""
    low, high = (-6e-3, -0.01, 3.0), (6e-3, 0.01, 5.5)
    shift, yaw, power = np.random.default_rng(0).uniform(low, high, (60, 3)).T
    table = wrcontact.ContactSystem(normal_model=model).evaluate_many(shift, yaw, normal_force=10.0**power)
    for wheel in (table.left, table.right):
        missed = wheel.normal_force / 10.0**power - 1.0
        worst = np.argmax(np.abs(missed))
        assert abs(missed[worst]) < 1e-10, (shift[worst], yaw[worst], 10.0 ** power[worst])


def test_outline_integrates_to_area_and_force(system):
    """31 stations by the trapezoidal rule: a few per cent, since the ends fall like a root."""
    for shift in (0.0, 1e-3, 3e-3, 6e-3, 7e-3):
        side = system.evaluate(lateral_shift=shift).right
        outline = side.outline
        assert np.trapezoid(2 * outline.half_length, outline.station) == pytest.approx(side.area, rel=0.03)
        line = np.pi / 2 * outline.half_length * outline.pressure
        assert np.trapezoid(line, outline.station) == pytest.approx(side.normal_force, rel=0.03)


def test_a_penetration_below_zero_is_refused(system):
    with pytest.raises(ValueError, match=r"penetration \(left\) is -1 m; permitted is 0 ... 0.01 m"):
        system.evaluate(penetration=-1.0)
    assert system.evaluate().right.normal_force == pytest.approx(78.5e3)


def test_flat_and_concave_pairs_are_handled(system):
    """S1002 on UIC60: the relative lateral curvature is below zero at some tread
    contacts and inside many patches."""
    table = system.evaluate_many(np.linspace(-4e-3, 4e-3, 400))
    assert not np.any(table.status)
    for side in (table.left, table.right):
        assert np.any(side.curvature_y < 0.3 * side.curvature_x)
        # peak over Hertz's share of the mean pressure: 1 for an ellipse
        assert np.all(np.abs(np.log(side.max_pressure / (1.5 * side.normal_force / side.area))) < np.log(2.2))


def test_basic_and_effective_longitudinal_curvature():
    """At the flange the effective radius is longer: the patch grows along the track and shrinks
    across (source, ch. 7.2)."""
    states = [
        wrcontact.ContactSystem(longitudinal_curvature=kind).evaluate(lateral_shift=6.5e-3)
        for kind in ("effective", "basic")
    ]
    effective, basic = (state.right for state in states)
    in_the_wheelset = effective.contact_angle + states[0].roll
    assert 1 / effective.curvature_x == pytest.approx(
        effective.rolling_radius / np.cos(in_the_wheelset), rel=1e-9
    )
    assert 1 / basic.curvature_x == pytest.approx(basic.rolling_radius, rel=1e-12)
    assert effective.patch_length > 1.2 * basic.patch_length
    assert effective.patch_width < basic.patch_width
    tread = [
        wrcontact.ContactSystem(longitudinal_curvature=kind).evaluate().right.area
        for kind in ("effective", "basic")
    ]
    assert tread[0] == pytest.approx(tread[1], rel=1e-3)


def test_unloaded_wheels_keep_their_geometry(system):
    loaded, empty = system.evaluate(2e-3, 0.01), system.evaluate(2e-3, 0.01, normal_force=0.0)
    assert empty.status == wrcontact.Status.UNLOADED
    assert empty.right.contact.y_wheel == pytest.approx(loaded.right.contact.y_wheel, abs=1e-12)
    assert (empty.right.patch_count, empty.right.area, empty.right.patches) == (0, 0.0, ())
    one_sided = system.evaluate(2e-3, load_transfer=1.0)
    assert one_sided.status == wrcontact.Status.UNLOADED
    assert one_sided.left.normal_force == 0.0 and one_sided.right.normal_force == pytest.approx(157e3)


@pytest.mark.parametrize("side", [-1, 1])
def test_the_share_of_growing_curvature_is_whole_from_the_mean_on(side):
    """Of a gap that rises as the fourth power of the way: closed form of its secant c s^2 and of its averaged
    second difference c (6 s^2 + w^2); beyond the ``mean`` half-width the curvature hangs on it no more."""
    contact = layout.Work.at(np.zeros(layout.WORK_SIZE)).contact
    nodes, region = contact.nodes[0], contact.regions[0]
    region.spacing, window, c = 2e-4, 3, 4e5
    for k in range(-40, 41):
        nodes.gap[k] = c * (k * region.spacing) ** 4
    k = 20 * side
    s, width = 20 * region.spacing, window * region.spacing
    secant, averaged = c * s**2, c * (6.0 * s**2 + width**2)
    for mean, share in ((4.0 * s, 0.25), (2.0 * s, 0.5), (s, 1.0), (0.95 * s, 1.0), (0.1 * s, 1.0)):
        found = adaptive_curvatures(region, nodes.gap, k, window, 0.0, mean, 1e-3)
        grown = secant + GROWTH * share * (averaged - secant)
        assert found[0] == pytest.approx(secant, rel=1e-12)
        assert found[2] == pytest.approx(np.sqrt(averaged * grown), rel=1e-9), mean


@pytest.mark.parametrize("outward", [-1, 1])
def test_the_load_of_a_region_counts_what_is_loaded_again_beyond_a_gap(outward):
    """Nodes whose overlap is one parabola, which is negative between 2.3 and 5.4. Witness: its integral."""
    contact = layout.Work.at(np.zeros(layout.WORK_SIZE)).contact
    nodes, region = contact.nodes[0], contact.regions[0]
    region.spacing = 1e-3
    region.first, region.last = (0, 9) if outward > 0 else (-9, 0)
    region.low, region.high = 1e-3 * region.first, 1e-3 * region.last
    overlap = 1e-5 * np.poly1d([2.3, 5.4], r=True)
    for k in range(-10, 11):
        nodes.line[outward * k], nodes.rise[outward * k] = 2e9, 2e-4 - overlap(k)
    load, stiffness = analyn.region_load(region, nodes, 2e-4)
    whole = overlap.integ()
    assert load == pytest.approx(2e9 * 1e-3 * (whole(2.3) - whole(0.0) + whole(9.0) - whole(5.4)), rel=1e-12)
    assert stiffness == pytest.approx(2e9 * 1e-3 * (2.3 + 3.6), rel=1e-12)
