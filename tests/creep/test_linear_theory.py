"""Kalker's creepage coefficients: as printed, and as the complete theory has them at small creepage."""

import math

import numpy as np
import pytest

import wrcontact
from tests.helpers.creep import stored
from wrcontact.halfspace.rolling import roll_ellipse

LEVELS = (1e-2, 5e-3)  # linear moment over the friction limit; their straight line leads to no slip


def twist(ratio, nu, cells=24):
    """C33 of an ellipse from the moment of small spins in the complete theory, N, G and sqrt(ab) are 1."""
    found = []
    for spin in (level * 0.3 for level in LEVELS):
        rolled = roll_ellipse(
            math.sqrt(ratio),
            1.0 / math.sqrt(ratio),
            1.0,
            creepage_x=0.0,
            creepage_y=0.0,
            spin=-spin,
            friction=0.3,
            shear_modulus=1.0,
            poisson_ratio=nu,
            cells=cells,
        )
        found.append(rolled.moment / spin)
    return 2.0 * found[1] - found[0]


def test_rows_are_kalkers():
    table = np.array(stored("kalker_cij.json")["table"])
    g = np.arange(1, 11) / 10
    for m, nu in enumerate((0.0, 0.25, 0.5)):
        for case, ratio in enumerate((g, 1.0 / g)):
            found = np.array(wrcontact.kalker_coefficients(ratio, nu)[:3])
            np.testing.assert_allclose(found, table[case, :, :, m].T, rtol=1e-12)


@pytest.mark.parametrize("nu", (0.0, 0.25, 0.5))
def test_rows_of_the_moment_of_spin_are_smooth(nu):
    """Each row but the outermost ones is on the cubic of ln C33 over ln(a/b) through its four neighbours, but for
    the three digits of the print, which leave 0.7 %. A wrong digit would be off by several per cent."""
    ratio = np.concatenate([np.arange(1, 11) / 10, 10 / np.arange(9, 0, -1)])
    row = np.log(wrcontact.kalker_coefficients(ratio, nu)[3])
    for k in range(1, 18):
        first = min(max(k - 2, 0), 14)
        near = [i for i in range(first, first + 5) if i != k]
        cubic = np.polyfit(np.log(ratio[near] / ratio[k]), row[near], 3)
        assert cubic[-1] == pytest.approx(row[k], abs=0.008), ratio[k]


@pytest.mark.parametrize("ratio, nu", [(0.5, 0.25), (1.0, 0.0), (2.0, 0.5)])
def test_the_moment_of_spin_is_that_of_the_complete_theory(ratio, nu):
    """Measured 0.3, 0.7, 2.1 %; the cells leave up to 2 % at this number."""
    assert wrcontact.kalker_coefficients(ratio, nu)[3] == pytest.approx(twist(ratio, nu), rel=0.03)


@pytest.mark.full
@pytest.mark.parametrize("nu", [0.0, 0.28, 0.5])
@pytest.mark.parametrize("ratio", [0.1, 0.3, 0.45, 1.0, 1.6, 3.3, 10.0])
def test_the_moment_of_spin_is_that_of_the_complete_theory_everywhere(ratio, nu):
    """Between the rows, too; the moment of long patches with nu = 0.5 is small, and two grids differ by 10 %."""
    wanted = wrcontact.kalker_coefficients(ratio, nu)[3]
    assert wanted == pytest.approx(twist(ratio, nu), rel={3.3: 0.06, 10.0: 0.12}.get(ratio, 0.025))


def test_shapes_and_ranges():
    found = wrcontact.kalker_coefficients(np.full((2, 3), 1.7), 0.28)
    assert [c.shape for c in found] == 4 * [(2, 3)]
    # 1/C33 falls and rises with the axis ratio without a wave between the rows
    fine = wrcontact.kalker_coefficients(np.geomspace(0.1, 10.0, 400), 0.28)
    assert np.all(np.diff(fine[3]) < 0.0) and np.all(np.diff(fine[0]) > 0.0)
    for ratio in (0.09, 11.0, math.nan):
        with pytest.raises(ValueError, match="a_over_b is .*; permitted are 0.1 ... 10"):
            wrcontact.kalker_coefficients(ratio, 0.25)
    with pytest.raises(ValueError, match="poisson_ratio is 0.6; permitted are 0 ... 0.5"):
        wrcontact.kalker_coefficients(1.0, 0.6)
