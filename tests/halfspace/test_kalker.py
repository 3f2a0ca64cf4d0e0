"""Kalker's coefficients: as printed, between the lines, and as the limit of small creepage."""

import math

import numpy as np
import pytest

from tests.helpers.creep import stored
from tools.tables.exact_nodes import RATIOS, creep_coefficients
from wrcontact.creep.kalker_table import POISSON_NODES, asymptotes
from wrcontact.halfspace.rolling import roll_ellipse

#: Linear force over the friction limit.  Between them the ratio of true to linear force is a straight line,
#: which leads to the limit of no slip; the rest is 1e-5.
LEVELS = (1e-2, 5e-3)


def test_the_table_is_kalkers():
    table = np.array(stored("kalker_cij.json")["table"])
    for case, k, m in np.ndindex(2, len(RATIOS), 3):
        half_length, half_width = (RATIOS[k], 1.0) if case == 0 else (1.0, RATIOS[k])
        if case == 0 or RATIOS[k] < 1.0:
            found = creep_coefficients(half_length, half_width, POISSON_NODES[m])
            assert found == pytest.approx(table[case, k, :, m], rel=1e-12), (case, k, m)


def test_between_the_lines():
    """Straight in g; 1/C a parabola of nu, which lies between its neighbours here."""
    here = creep_coefficients(0.35, 1.0, 0.25)
    assert here == pytest.approx([3.485, 2.815, 0.769], rel=1e-12)
    low, middle, high = (creep_coefficients(1.0, 1.0, nu) for nu in (0.25, 0.28, 0.5))
    assert np.all((low < middle) & (middle < high))


@pytest.mark.parametrize("nu", POISSON_NODES)
def test_the_limits_meet_the_table(nu):
    """At g = 0.1 the first terms of the limits and the table are within 8 %."""
    for half_length in (0.1, 10.0):
        limit, table = asymptotes([math.log(half_length)], nu)[:, 0], creep_coefficients(half_length, 1.0, nu)
        assert limit == pytest.approx(table, rel=0.08), (half_length, limit, table)


def measured(ratio, nu, cells):
    """C11, C22, C23 by spin's force, C23 by the moment of lateral creepage (4,), and Kalker's."""
    a, b = math.sqrt(ratio), 1.0 / math.sqrt(ratio)
    c11, c22, c23 = wanted = creep_coefficients(a, b, nu)
    found = []
    for level in LEVELS:
        limit = level * 0.3  # N and G are 1, sqrt(ab) too
        material = {"friction": 0.3, "shear_modulus": 1.0, "poisson_ratio": nu, "cells": cells}
        along, across, spin = (
            roll_ellipse(a, b, 1.0, creepage_x=xi, creepage_y=eta, spin=phi, **material)
            for xi, eta, phi in ((-limit / c11, 0.0, 0.0), (0.0, -limit / c22, 0.0), (0.0, 0.0, -limit / c23))
        )
        found.append(
            np.array([along.force_x * c11, across.force_y * c22, spin.force_y * c23, -across.moment * c22])
            / limit
        )
    return 2.0 * found[1] - found[0], np.append(wanted, c23)


def test_small_creepage_is_kalkers():
    """C11 and C22 within 1 %: the table's three digits, and 0.5 % of the cells.  C23 needs more cells."""
    found, wanted = measured(1.0, 0.25, 32)
    assert found[:2] == pytest.approx(wanted[:2], rel=0.01)


def everywhere():
    """(a/b, tolerance, Poisson's ratio): one ratio for each a/b is full, the others are complete."""
    ratios = (0.1, 0.015), (0.3, 0.01), (1.0, 0.01), (10 / 3, 0.01), (10.0, 0.015)
    for i, (ratio, tolerance) in enumerate(ratios):
        for j, nu in enumerate(POISSON_NODES):
            yield pytest.param(
                ratio,
                tolerance,
                nu,
                id=f"a/b {ratio:.1f}, nu {nu}",
                marks=pytest.mark.full if i % 3 == j else pytest.mark.complete,
            )


@pytest.mark.parametrize("ratio, tolerance, nu", [*everywhere()])
@pytest.mark.turns(2)
def test_small_creepage_is_kalkers_everywhere(ratio, tolerance, nu):
    """1 %; at both ends of the table 1.5 %, where two grids differ by as much in the moment."""
    found, wanted = measured(ratio, nu, 48)
    assert found == pytest.approx(wanted, rel=tolerance)
