"""Stored numbers of the models, against integrals and tables of others."""

import json

import numpy as np
import pytest
from scipy import integrate

from data.creep_cases import CREEP
from tools.tables import rolling_table, strip_nodes
from wrcontact.creep import kalker_table
from wrcontact.kernel import layout
from wrcontact.kernel.binding.fixed_tables import CORRECTION, CORRECTION_UNIT, corrections, fixed_tables
from wrcontact.kernel.creep import stiffness, tractions
from wrcontact.kernel.prepare import tables as fixed

pytestmark = pytest.mark.machine


def kernel_table(nu):
    """The kernel's record RollingTable for a Poisson's ratio."""
    array = np.zeros(layout.SETTING_COUNT + layout.ROLLING_TABLE_SIZE)
    tables = layout.Tables.at(array)
    tables.rolling = layout.SETTING_COUNT
    fixed.append_rolling(tables, layout.SETTING_COUNT, memoryview(fixed_tables()), nu)
    return tables


@pytest.mark.parametrize("nu", [0.0, 0.25, 0.5])
def test_kalkers_coefficients_are_those_of_his_table(nu):
    """At its nodes, and in the kernel's cubics within half of its third digit, 0.3 %."""
    column = kalker_table.POISSON_NODES.index(nu)
    table = np.array(json.loads((CREEP / "kalker_cij.json").read_text())["table"])
    tables = kernel_table(nu)
    for long, rows in enumerate(table):
        for k, row in enumerate(rows):
            ratio = ((k + 1) / 10.0) ** (-1.0 if long else 1.0)
            np.testing.assert_allclose(
                kalker_table.kalker_coefficients(ratio, nu)[:, 0], row[:, column], rtol=1e-12
            )
            np.testing.assert_allclose(
                tractions.kalker_coefficients(tables.rolling, ratio), row[:, column], rtol=3e-3
            )


@pytest.mark.parametrize("nu", [0.0, 0.28, 0.5])
def test_kalkers_coefficients_go_over_into_their_asymptotes(nu):
    """Continuously at g = 0.1, where the asymptotes are some per cent off, and up to them far away."""
    for end in (-1.0, 1.0):
        beside = np.exp(end * np.log(10.0) * (1.0 + np.array([-1e-9, 1e-9])))
        one, other = kalker_table.kalker_coefficients(beside, nu).T
        np.testing.assert_allclose(one, other, rtol=1e-7)
        far = np.array([end * np.log(1e5)])
        found = kalker_table.kalker_coefficients(np.exp(far), nu)[:, 0]
        for k, column in enumerate(kalker_table.POISSON_NODES):
            if column == nu:
                np.testing.assert_allclose(found, kalker_table.asymptotes(far, nu)[:, 0], rtol=1e-4)


@pytest.mark.parametrize("eta", [0.02, 0.7, 5.0])
def test_reaches_are_their_integrals(eta):
    """Eq. (K4), by adaptive quadrature over the square."""

    def over_square(function):
        return (
            integrate.dblquad(
                lambda t, u: function(np.hypot(np.cos(t) - np.cos(u), eta), t, u),
                0.0,
                np.pi,
                lambda t: 0.0,
                lambda t: t,
                epsabs=1e-9,
                epsrel=1e-9,
            )[0]
            * 2.0
        )

    spin = lambda t, u: (np.sin(t) * np.sin(u)) ** 2  # noqa: E731
    wanted = [
        over_square(lambda r, t, u: eta / r) / (2.0 * np.pi**2),
        over_square(lambda r, t, u: (eta / r) ** 3) / (2.0 * np.pi**2),
        over_square(lambda r, t, u: spin(t, u) * eta / r) * 2.0 / np.pi**2,
        over_square(lambda r, t, u: spin(t, u) * (eta / r) ** 3) * 2.0 / np.pi**2,
    ]
    found = [
        np.interp(np.log(eta), rolling_table.reach_nodes(), row[0])
        for row in rolling_table.stored()["reaches"]
    ]
    # straight lines between the nodes here: an eighth of the cell's width squared times the bend
    np.testing.assert_allclose(found, wanted, atol=5e-4)


@pytest.mark.parametrize("nu", [0.25, 0.28, 0.3])
def test_reaches_are_those_of_the_trial_program(nu):
    """Over all distances; its own quadrature is good to 2e-7."""
    stored = json.loads((CREEP / "kernels.json").read_text())[f"{nu:g}"]
    tables = kernel_table(nu)
    table = tables.rolling
    found = np.array([stiffness.reaches(table, eta) for eta in stored["eta"]]).T
    for row, name in zip(found, "xys"):
        np.testing.assert_allclose(row, stored["S"][name], atol=1e-6)
    # nearer than anything stored they fall to zero without a change of sign, far away they stay
    near = np.array([stiffness.reaches(table, eta) for eta in np.geomspace(1e-12, 1e-2, 300)])
    assert np.all(near > 0.0) and np.all(np.diff(near, axis=0) > 0.0)
    assert np.all(np.array(stiffness.reaches(table, 0.0)) < 1e-8)
    np.testing.assert_array_equal(stiffness.reaches(table, 100.0), stiffness.reaches(table, 1e9))
    # and a half far away: a tail that falls like the square of the distance
    np.testing.assert_allclose(stiffness.reaches(table, 1e3), np.full(3, 0.5), atol=1e-3)


def test_factors_are_those_of_the_trial_program():
    """Where Kalker's coefficients are the same: at the nodes of his table both take them as they are."""
    stored = json.loads((CREEP / "factors.json").read_text())
    tables = kernel_table(stored["nu"])
    table = tables.rolling
    ratios, wanted = np.array(stored["a_over_b"]), np.array(stored["factor_K1_K2_K3"])
    for ratio in (0.2, 0.5, 1.0, 2.0):
        near = [np.interp(np.log(ratio), np.log(ratios), column) for column in wanted.T]
        found = [tractions.shape_value(table, 3 + k, tractions.shape_place(ratio)) for k in range(3)]
        # between nodes it takes the coefficients along straight lines, up to 2 % too high
        np.testing.assert_allclose(found, near, rtol=0.02)


@pytest.mark.parametrize(("nu", "allowed"), [(0.0, 1e-6), (0.25, 1e-6), (0.3, 1e-2), (0.45, 1.5e-2)])
def test_strips_of_an_ellipse_have_kalkers_stiffness(nu, allowed):
    """Force of small creepages by the sum over the strips alone, at nodes of the table.  Between the
    Poisson's ratios of Kalker's table the factors are parabolas of it, and so are 1/C."""
    tables = kernel_table(nu)
    tables.shear_modulus = 1.0
    tables.parameters.poisson_ratio = nu
    work = layout.Work.at(np.zeros(layout.WORK_SIZE))
    for ratio in np.exp(rolling_table.shape_nodes()[1::4]):
        found = strip_nodes.strip_coefficients(tables, work, ratio)
        np.testing.assert_allclose(found, kalker_table.kalker_coefficients(ratio, nu)[:, 0], rtol=allowed)


def test_the_correction_is_that_of_these_strips():
    """At some nodes of each Poisson's ratio it is exact minus strips; else it would have to be made anew
    (tools/make_rolling_correction.py)."""
    with np.load(CORRECTION) as stored:
        correction = stored["correction"] * CORRECTION_UNIT
    for column, nu in enumerate(rolling_table.CORRECTION_NODES):
        exact = strip_nodes.exact_forces(nu)
        some = {name: values[::2] if name in ("alpha", "rho") else values for name, values in exact.items()}
        some["forces"] = exact["forces"][:, :, ::2, ::2]
        apart = some["forces"] - strip_nodes.strip_forces(some, nu)
        assert apart.size > 1000
        np.testing.assert_allclose(
            correction[column][:, :, ::2, ::2], apart, rtol=0, atol=0.51 * CORRECTION_UNIT
        )


@pytest.mark.parametrize("poisson_ratio", [0.25, 0.265, 0.28, 0.293, 0.3])
def test_corrections_are_parabolas_of_poissons_ratio(poisson_ratio):
    """Those of three ratios are stored. Witness: numpy's parabola through them; also of the slopes at no creepage."""
    tables = kernel_table(poisson_ratio)
    stored = corrections()
    places = 3 * layout.CORRECTION_SIZE
    for numbers, found in (
        (
            stored[-places - 3 * layout.CORRECTION_SLOPES : -3 * layout.CORRECTION_SLOPES],
            tables.rolling.corrections,
        ),
        (stored[-3 * layout.CORRECTION_SLOPES :], tables.rolling.slopes),
    ):
        three = numbers.reshape(3, -1)
        parabolas = np.polyfit(np.array([0.25, 0.28, 0.3]) - 0.28, three, 2)
        wanted = (
            parabolas[0] * (poisson_ratio - 0.28) ** 2 + parabolas[1] * (poisson_ratio - 0.28) + parabolas[2]
        )
        got = [found[k] for k in range(three.shape[1])]
        np.testing.assert_allclose(got, wanted, atol=1e-10 * np.abs(three).max())
        assert np.ptp(three, axis=0).max() > 1e-3
