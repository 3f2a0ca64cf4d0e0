"""Creepage without spin on an ellipse: each model's own theory has closed forms of force and stick."""

import numpy as np
import pytest

from data.creep_cases import Model, full_slip, vector
from wrcontact.creep import elliptic_patch
from wrcontact.creep.kalker_table import kalker_coefficients

FRICTION, LOAD = 0.3, 8e4
BOUND, SHEAR, POISSON = FRICTION * LOAD, 210e9 / (2 * 1.28), 0.28
SHAPES = [0.4, 1.0, 2.5]
#: Creepages over that at which linear theory has the force of full slip.
LEVELS = [0.2, 0.6, 1.0, 1.5, 2.4]


def solved(name, ratio, axis, level):
    """Force against the creepage over mu N, share that sticks, creepage, semi-axes, Kalker's coefficient."""
    a, b = 5e-3 * ratio**0.5, 5e-3 * ratio**-0.5
    patch = elliptic_patch(a, b, LOAD)
    creepage = level * full_slip(patch, FRICTION)[0][axis]
    found = Model(name).solve(patch, *(creepage * np.eye(3)[axis]), FRICTION)
    return (
        -vector(found)[axis] / BOUND,
        found.stick_share,
        creepage,
        a,
        b,
        kalker_coefficients(ratio, POISSON)[axis, 0],
    )


@pytest.mark.parametrize("level", LEVELS)
@pytest.mark.parametrize("ratio", SHAPES)
@pytest.mark.parametrize("axis", [0, 1])
def test_fastsim_has_the_force_of_a_straight_line_under_an_ellipse(axis, ratio, level):
    """The traction rises by s = 3 C G xi / (8 a) to the bound m sqrt(a^2 - x^2), which it meets where
    (a - x) s = m sqrt(a^2 - x^2): behind the share 1 / (1 + (s/m)^2) of each strip; m = mu p0 / a."""
    force, share, creepage, a, b, kalker = solved("fastsim", ratio, axis, level)
    e = 3.0 * kalker * SHEAR * creepage / (8.0 * a) / (1.5 * BOUND / (np.pi * a * b) / a)
    # sixteen points: the force and the share lie between those of neighbouring points
    assert force == pytest.approx(2.0 / np.pi * (np.arctan(e) + e / (1.0 + e * e)), abs=0.02)
    assert share == pytest.approx(1.0 / (1.0 + e * e), abs=0.1)


def haines_ollerton(depth):
    """Force over mu N, and share that sticks, of an ellipse whose strips have one slip zone, ``depth`` in
    half-lengths of the middle one."""
    if depth >= 1.0:
        return 1.0, 0.0
    end = np.sqrt(1.0 - depth * depth)
    inner = end - end**3 / 3.0 + depth * depth * end - depth * (end * depth + np.arcsin(end))
    return 1.0 - 1.5 * inner, 2.0 / np.pi * (np.arccos(depth) - depth * end)


@pytest.mark.parametrize("level", LEVELS)
@pytest.mark.parametrize("ratio", SHAPES)
@pytest.mark.parametrize("axis", [0, 1])
def test_fastrip_has_the_force_of_strip_theory(axis, ratio, level):
    """Haines and Ollerton (1963): d = K xi / m with the stiffness K = 2 C G / pi^2 of Kalker's force."""
    force, share, creepage, a, b, kalker = solved("fastrip", ratio, axis, level)
    rate = 1.5 * BOUND / (np.pi * a * b) / a
    wanted, sticks = haines_ollerton(2.0 * kalker * SHEAR / np.pi**2 * creepage / rate / a)
    # sixteen strips that have the mean of a^2, points, and cubics through Kalker's coefficients
    assert force == pytest.approx(wanted, abs=0.01)
    assert share == pytest.approx(sticks, abs=0.02)


@pytest.mark.parametrize("direction", [(0.0, 0.5, 1.0), (0.0, -0.2, 1.0), (0.5, -0.3, 1.0), (1.0, 0.0, 0.0)])
@pytest.mark.parametrize("ratio", [0.5, 3.0])
def test_what_sticks_of_the_strips_does_not_jump(ratio, direction):
    """As creepage and spin grow the share that sticks falls from one to zero without a jump, also where the
    stick zone would ask for tractions beyond the bound: the steepest of 200 steps, halved twenty times, has
    nothing left.

    Between the nodes of the correction, straight lines leave up to two of a hundred where nothing sticks.
    """
    patch = elliptic_patch(5e-3 * ratio**0.5, 5e-3 * ratio**-0.5, LOAD)
    slip, model = np.array(direction) * full_slip(patch, FRICTION)[0], Model("strips")

    def share(level):
        return model.solve(patch, *(level * slip), FRICTION).stick_share

    levels = np.linspace(0.0, 4.0, 201)
    shares = np.array([share(level) for level in levels])
    assert shares[0] == pytest.approx(1.0, abs=1e-9) and 0.0 <= shares[-1] < 0.02
    for k in np.argsort(-np.abs(np.diff(shares)))[:5]:
        low, high = levels[k : k + 2]
        for _ in range(20):
            middle = 0.5 * (low + high)
            if abs(share(middle) - share(low)) > abs(share(high) - share(middle)):
                high = middle
            else:
                low = middle
        # a root's slope at worst: 1e-3 of the step before it
        assert abs(share(high) - share(low)) < 2e-3, levels[k]
