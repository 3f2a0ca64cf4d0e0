"""The elastic witness against Hertz, against CONTACT on the same gap, and against CONTACT
with its own geometry."""

from math import pi, radians

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

import data
from data.brute_force import rigid_contact, track
from data.halfspace_reference import CONTACT_MODULUS, influence_coefficients, normal_contact, solve
from data.hertz import hertz
from tests.helpers.cases import planar_cases


def cells(half_width, count):
    return half_width * (2 * np.arange(count) + 1 - count) / count


def test_displacement_of_a_square_and_far_away():
    """Centre of a square of side h: p h 4 ln(1 + sqrt 2) / (pi E*); far away like a point force."""
    u = influence_coefficients((60, 60), 1e-3, 1e-3)
    assert u[0, 0] == pytest.approx(4e-3 * np.log(1 + np.sqrt(2)) / (pi * CONTACT_MODULUS), rel=1e-12)
    assert u[50, 30] == pytest.approx(1e-6 / (pi * CONTACT_MODULUS * np.hypot(50e-3, 30e-3)), rel=2e-5)


@pytest.mark.parametrize(
    "A, B", [(1 / 0.92, 1 / 0.92), (1 / 0.92, 1 / 0.04), (1 / 2, 1 / 0.02), (1 / 0.04, 1 / 0.92)]
)
def test_hertz(A, B):
    force = 78.5e3
    penetration, a, b, peak = hertz(A, B, force)
    x, s = cells(1.12 * a, 110), cells(1.12 * b, 110)
    found = solve(x, s, A * x[:, None] ** 2 + B * s**2, force)
    assert found.penetration == pytest.approx(penetration, rel=3.6e-5)  # measured 2.4e-5
    assert found.max_pressure == pytest.approx(peak, rel=1.4e-4)  # measured 9.3e-5
    assert found.area == pytest.approx(pi * a * b, rel=3e-3)  # measured 2.6e-3
    assert found.pressure.sum() * found.cell == pytest.approx(force, rel=1e-12)


@pytest.mark.parametrize("case", planar_cases(), ids=lambda case: f"{case['y_ws_mm']}mm")
def test_contact_on_the_same_gap(case):
    """CONTACT's complete theory on h = x^2 / 2R + g(s), g by its stored points."""
    s, g, R, theirs = (
        np.array(case["s_mm"]) * 1e-3,
        np.array(case["g_mm"]) * 1e-3,
        case["R_x_mm"] * 1e-3,
        case["solution"],
    )
    reach = s[g < 0.2e-3]
    across = np.arange(reach[0], reach[-1], 0.05e-3)
    along = cells(np.sqrt(2 * R * theirs["penetration_mm"] * 1e-3), 160)
    found = solve(along, across, along[:, None] ** 2 / (2 * R) + CubicSpline(s, g)(across), case["fn_N"])
    assert not found.touches_border
    assert found.penetration * 1e3 == pytest.approx(theirs["penetration_mm"], rel=1.2e-5)  # measured 8e-6
    assert found.max_pressure / 1e6 == pytest.approx(theirs["pmax_MPa"], rel=1.2e-3)  # measured 7.9e-4
    assert found.area * 1e6 == pytest.approx(theirs["area_fit_mm2"], rel=3.4e-3)  # measured 2.3e-3


def full_cases(*positions):
    rows = data.rows_of(data.FOLDER / "contact_full.csv")
    finest = {(row["lateral_shift_mm"], row["yaw_deg"]): row for row in rows}
    return [finest[position] for position in positions]


@pytest.mark.parametrize(
    "row",
    full_cases((0, 0), (3, 0), (1, 1), (6.5, 2)),
    ids=lambda row: f"{row['lateral_shift_mm']}mm_{row['yaw_deg']}deg",
)
@pytest.mark.turns(2)
def test_contact_with_its_own_geometry(row):
    """The true gap, where CONTACT's load-weighted plane lies within 0.02 rad of the rigid tangent plane."""
    system = track()
    wheelset = rigid_contact(system, row["lateral_shift_mm"] * 1e-3, radians(row["yaw_deg"]))
    found = normal_contact(system, wheelset, "right", row["normal_force_N"])
    assert wheelset.right.contact_angle == pytest.approx(-row["contact_plane_angle_rad"], abs=0.02)
    # measured 1.7e-3, 1.4e-3, 8.5e-3 at most
    assert found.penetration * 1e3 == pytest.approx(row["penetration_mm"], rel=2.6e-3)
    assert found.max_pressure / 1e6 == pytest.approx(row["max_pressure_MPa"], rel=2.1e-3)
    assert found.area * 1e6 == pytest.approx(row["area_fit_mm2"], rel=1e-2)


@pytest.mark.full
def test_small_load_is_hertz_with_the_local_curvatures():
    """Flank (straight) on the rail's R13 corner: B = 1/2 R13; along the rail A = cos(delta) / 2 r."""
    system = track()
    wheelset = rigid_contact(system, 6.35e-3)
    wheel = wheelset.right
    A, B = np.cos(wheel.contact_angle) / (2 * wheel.rolling_radius), 1 / (2 * 13e-3)
    penetration, a, b, peak = hertz(A, B, 200.0)
    found = normal_contact(system, wheelset, "right", 200.0)
    assert found.penetration == pytest.approx(penetration, rel=5e-3)
    assert found.max_pressure == pytest.approx(peak, rel=5e-3)
    assert found.area == pytest.approx(pi * a * b, rel=1e-2)


@pytest.mark.full
def test_left_is_the_mirror_image():
    """The left wheel at -y, -yaw is the right wheel at y, yaw."""
    system = track()
    right = normal_contact(system, rigid_contact(system, 4e-3, radians(0.5)), "right", 5e4)
    left = normal_contact(system, rigid_contact(system, -4e-3, -radians(0.5)), "left", 5e4)
    assert left.penetration == pytest.approx(right.penetration, rel=1e-9)
    assert left.area == pytest.approx(right.area, rel=1e-6)
