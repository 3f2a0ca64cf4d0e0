"""Strips and ANALYN on patches that turn, against the complete theory on a curved reference
(data/conformal.csv), and the same patch in every mode."""

import math

import numpy as np
import pytest

import data
from tests.helpers.strips import random_poses, system_of
from wrcontact import Status
from wrcontact.kernel import layout

ROWS = data.rows_of(data.CONFORMAL)


def errors_at(model, row):
    """Relative errors in load, area, peak pressure and force along y and z (5,) of the right wheel."""
    state = system_of(model, contact_mode="compliant").evaluate(
        row["lateral_shift_mm"] * 1e-3, math.radians(row["yaw_deg"]),
        vertical_shift_input=row["vertical_shift_mm"] * 1e-3, roll_input=row["roll_rad"])
    assert state.status == Status.VALID
    side = state.right
    found = side.normal_force, side.area * 1e6, side.max_pressure * 1e-6, abs(side.force.y), abs(side.force.z)
    truth = [row[name] for name in ("N_f_N", "area_f_mm2", "pmax_f_MPa", "Fy_f_N", "Fz_f_N")]
    return np.array(found) / truth - 1


@pytest.mark.parametrize("model, mean, worst", [
    # the reference's grid is good to 0.2 % in N and 1 % in area; at 2 degrees of yaw another half-space
    # theory finds 2 % more area than the reference
    # measured 0.20, 1.17, 1.33, 0.27, 0.33 % in the mean, 0.55, 3.7, 5.3, 0.63, 1.3 % at worst: pressures are
    # worse than with strips that do not reach over the whole overlap (0.84 and 3.9 %), most at 6.2 mm and
    # 1 degree of yaw; 28 strips have 0.87 and 3.3 %
    ("analyn_strip", (0.0026, 0.0138, 0.0172, 0.0034, 0.0039), (0.0083, 0.0555, 0.080, 0.0095, 0.0150)),
    ("analyn", (0.03, 0.07, 0.035, 0.03, 0.02), (0.06, 0.20, 0.08, 0.07, 0.06)),
    # CONTACT counts cells, which gives 0.5 ... 1 % more area than the edge within the cells, and warns of its
    # own curve in yawed rows beyond 0.025 rad; on a flange the direction of its force is off by 0.6 degrees
    pytest.param("halfspace", (0.0025, 0.015, 0.0025, 0.005, 0.005), (0.0065, 0.02, 0.013, 0.016, 0.024),
                 marks=pytest.mark.full)])
def test_complete_theory_on_patches_that_turn(model, mean, worst):
    error = np.abs([errors_at(model, row) for row in ROWS])
    assert np.all(error.mean(axis=0) < mean), error.mean(axis=0)
    assert np.all(error.max(axis=0) < worst), error.max(axis=0)


#: Lateral shift [m], yaw [deg], force [N]; penetration [m], area [m2] and peak pressure [Pa] of the wheel
#: that has moved straight down from where it just touches, by the trial program from which the half-space's
#: theory was taken, on grids of 90 x 180 cells. Penetration is the sinking times the cosine of the contact
#: angle. What the one plane of a half-space gave with the same penetration: 2195, 5412 and 1985 MPa.
SUNK = {"wide": ((6.24e-3, 0.0, 120e3), (115.1e-6, 154e-6, 1754e6)),
        "split": ((5.85e-3, 2.0, 120e3), (146.1e-6, 64.7e-6, 3214e6)),
        "widest": ((6.25e-3, 0.0, 78.5e3), (79.0e-6, 137e-6, 1330e6))}


@pytest.mark.parametrize("name", SUNK)
@pytest.mark.parametrize("model", ["analyn_strip", pytest.param("halfspace", marks=pytest.mark.full)])
def test_a_rigid_wheel_sinks_straight_down(model, name):
    """Strips have 4.7 % too much area in the patch that lies in two places."""
    (shift, yaw, force), wanted = SUNK[name]
    side = system_of(model).evaluate(shift, math.radians(yaw), force, side="right").right
    near = (2e-3, 0.012, 2e-3) if model == "halfspace" else (0.01, 0.03 if yaw == 0 else 0.055, 0.04)
    for found, value, allowed in zip((side.penetration, side.area, side.max_pressure), wanted, near):
        assert found == pytest.approx(value, rel=allowed)
    assert side.normal_force == pytest.approx(force, rel=1e-6)


def test_a_rigid_wheel_is_a_compliant_one_where_it_has_sunk():
    """Within what two layouts of 24 strips differ by: on one wheel at the height that its penetration
    says."""
    for pose in random_poses(40, 61, low=2e4):
        shift, yaw, force = pose[[layout.IN_LATERAL_SHIFT, layout.IN_YAW, layout.IN_NORMAL_FORCE]]
        rigid = system_of().evaluate(shift, yaw, force)
        for name in ("left", "right"):
            side = getattr(rigid, name)
            height = rigid.vertical_shift + side.penetration / math.cos(side.contact_angle)
            stands = getattr(system_of(contact_mode="compliant").evaluate(
                shift, yaw, vertical_shift_input=height, roll_input=rigid.roll), name)
            assert stands.normal_force == pytest.approx(force, rel=0.025), (name, *pose)
            assert stands.max_pressure == pytest.approx(side.max_pressure, rel=0.05), (name, *pose)


@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
def test_nothing_jumps_where_a_patch_begins_to_turn(model):
    """Through 15 degrees between the normals, and through the conformal zone, in steps of 0.5 um: no step of
    the load at one depth."""
    shifts = np.arange(5.9e-3, 5.95e-3, 0.5e-6)
    table = system_of(model, contact_mode="rigid").evaluate_many(shifts, 0.0, 78.5e3)
    for name, allowed in (("penetration", 2e-3), ("area", 1e-2), ("max_pressure", 1e-2)):
        values = getattr(table.right, name)
        assert np.abs(np.diff(values) / values[1:]).max() < allowed, name
