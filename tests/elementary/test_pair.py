"""Two linear equations with two unknowns, against numpy's solver."""

import numpy as np
import pytest

from wrcontact.kernel.elementary.pair import solve_pair


def test_the_moves_let_both_residuals_vanish():
    random = np.random.default_rng(4)
    for number in range(200):
        residuals, slopes = random.normal(size=2), random.normal(size=(2, 2))
        determinant, *moves = solve_pair(*residuals, *slopes.ravel())
        limit = 1e-14 * np.linalg.cond(slopes) * (1 + np.abs(moves).max())
        assert determinant == pytest.approx(np.linalg.det(slopes), abs=1e-14), number
        assert moves == pytest.approx(np.linalg.solve(slopes, -residuals), abs=limit), number


def test_parallel_equations_have_no_moves():
    assert solve_pair(1.0, 2.0, 1.0, -3.0, 2.0, -6.0) == (0.0, 0.0, 0.0)
