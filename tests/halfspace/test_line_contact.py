"""A long roller against the closed forms of Carter (1926) and of plane rolling with spin.

The patch is a strip 400 half-lengths wide: in its middle row contact is plane.  There a stick zone reaches
from the leading edge over 2 (a - d); with e the direction of the traction and k = -phi G a / 2 mu p0

    p = mu p0/a (e sqrt(a^2 - x^2) - (e - (0, k)) sqrt((a - d)^2 - (x - d)^2)),
    xi = -2 (1 - nu) mu p0 d e_x / G a,      eta = -2 mu p0 d (e_y - k) / G a

because the traction mu p0 sqrt(a^2 - x^2)/a bends the surfaces by du/dx = -2 (1 - nu) mu p0 x / G a along x
and without 1 - nu across it (Johnson 1985, section 8.3).
"""

import numpy as np
import pytest

from wrcontact.halfspace.rolling import Outline, contact_of_slip, rigid_slip

A, PRESSURE, FRICTION, SHEAR_MODULUS, POISSON_RATIO = 5e-3, 1e9, 0.3, 80e9, 0.28
WIDE, ROWS, COLUMNS = 200, 21, 48
#: Of mu times the line load: first-order extrapolation of 48 and 96 cells leaves errors of second order.
TOLERANCE = 2e-4


def middle_row(columns, creepage_x, creepage_y, spin, poisson_ratio=POISSON_RATIO):
    """Line loads (2,) over mu times the normal one, and the share that sticks."""
    outline = Outline.of_stations(np.linspace(-WIDE, WIDE, 5) * A, np.full(5, A), np.full(5, PRESSURE))
    field = outline.on_grid(columns, ROWS)
    slip = rigid_slip(field, creepage_x, creepage_y, spin)
    slip[0] = creepage_x  # plane: spin moves the strip sideways only
    found = contact_of_slip(
        field, slip, friction=FRICTION, shear_modulus=SHEAR_MODULUS, poisson_ratio=poisson_ratio
    )
    row = ROWS // 2
    limit = FRICTION * PRESSURE * 0.5 * np.pi * A
    return found.line_loads()[:, row] / limit, np.mean(~found.slips[row])


def extrapolated_row(*motion):
    (coarse, _), (fine, sticks) = (middle_row(columns, *motion) for columns in (COLUMNS, 2 * COLUMNS))
    return 2.0 * fine - coarse, sticks


@pytest.mark.parametrize("d", [0.1, 0.5, 0.8], ids="d = {} a".format)
@pytest.mark.parametrize("angle, nu", [(0.0, 0.28), (90.0, 0.28), (180.0, 0.5), (-30.0, 0.0)], ids=str)
def test_creepage_is_carters(d, angle, nu):
    """The force is mu P (1 - (1 - d/a)^2) along the traction; with nu = 0 for any direction of it, else for
    tractions along x or y, as slip and traction have one direction only then."""
    e = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
    unit = 2.0 * FRICTION * PRESSURE * d / SHEAR_MODULUS
    load, sticks = extrapolated_row(-(1.0 - nu) * unit * e[0], -unit * e[1], 0.0, nu)
    assert load == pytest.approx(e * (1.0 - (1.0 - d) ** 2), abs=TOLERANCE)
    assert sticks == pytest.approx(1.0 - d, abs=2.0 / COLUMNS)  # counted in cells


def test_beyond_carters_limit_all_slips():
    unit = 2.0 * FRICTION * PRESSURE * 1.01 / SHEAR_MODULUS
    load, sticks = middle_row(COLUMNS, -(1.0 - POISSON_RATIO) * unit, 0.0, 0.0)
    assert load == pytest.approx([1.0, 0.0], abs=1e-6) and sticks == 0.0


@pytest.mark.parametrize("d, k", [(0.3, 0.5), (0.6, 0.8), (0.3, -0.5)], ids=str)
def test_creepage_with_spin(d, k):
    unit = 2.0 * FRICTION * PRESSURE / SHEAR_MODULUS
    load, _ = extrapolated_row(0.0, -unit * d * (1.0 - k), -unit * k / A)
    assert load == pytest.approx([0.0, 1.0 - (1.0 - k) * (1.0 - d) ** 2], abs=TOLERANCE)
