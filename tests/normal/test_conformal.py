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
        row["lateral_shift_mm"] * 1e-3,
        math.radians(row["yaw_deg"]),
        vertical_shift_input=row["vertical_shift_mm"] * 1e-3,
        roll_input=row["roll_rad"],
    )
    assert state.status == Status.VALID
    side = state.right
    found = side.normal_force, side.area * 1e6, side.max_pressure * 1e-6, abs(side.force.y), abs(side.force.z)
    truth = [row[name] for name in ("N_f_N", "area_f_mm2", "pmax_f_MPa", "Fy_f_N", "Fz_f_N")]
    return np.array(found) / truth - 1


@pytest.mark.parametrize(
    "model, mean, worst",
    [
        # the reference's grid is good to 0.2 % in N and 1 % in area; at 2 degrees of yaw another half-space
        # theory finds 2 % more area than the reference
        # measured 0.17, 1.10, 0.69, 0.21, 0.35 % in the mean, 0.49, 2.2, 4.5, 1.1, 1.8 % at worst: the force's
        # direction at 6.0 mm and 2 degrees of yaw, where the patch lies in two places and the half-space has as
        # much, otherwise 0.24 and 0.34 %; the pressure at 6.2 mm and 1 degree, otherwise 0.7 %
        ("analyn_strip", (0.0026, 0.0138, 0.0093, 0.0031, 0.0039), (0.0074, 0.033, 0.0535, 0.0167, 0.027)),
        ("analyn", (0.03, 0.07, 0.035, 0.03, 0.02), (0.06, 0.20, 0.08, 0.07, 0.06)),
        # CONTACT counts cells, which gives 0.5 ... 1 % more area than the edge within the cells, and warns of its
        # own curve in yawed rows beyond 0.025 rad; on a flange the direction of its force is off by 0.6 degrees
        pytest.param(
            "halfspace",
            (0.0025, 0.015, 0.0025, 0.005, 0.005),
            (0.0065, 0.02, 0.013, 0.016, 0.024),
            marks=pytest.mark.full,
        ),
    ],
)
def test_complete_theory_on_patches_that_turn(model, mean, worst):
    error = np.abs([errors_at(model, row) for row in ROWS])
    assert np.all(error.mean(axis=0) < mean), error.mean(axis=0)
    assert np.all(error.max(axis=0) < worst), error.max(axis=0)


#: Lateral shift [m], yaw [deg], force [N]; penetration [m], area [m2] and peak pressure [Pa] of the wheel
#: that has moved straight down from where it just touches, by the trial program from which the half-space's
#: theory was taken, on grids of 90 x 180 cells. Penetration is the sinking times the cosine of the contact
#: angle. What the one plane of a half-space gave with the same penetration: 2195, 5412 and 1985 MPa.
SUNK = {
    "wide": ((6.24e-3, 0.0, 120e3), (115.1e-6, 154e-6, 1754e6)),
    "split": ((5.85e-3, 2.0, 120e3), (146.1e-6, 64.7e-6, 3214e6)),
    "widest": ((6.25e-3, 0.0, 78.5e3), (79.0e-6, 137e-6, 1330e6)),
}


@pytest.mark.parametrize("name", SUNK)
@pytest.mark.parametrize("model", ["analyn_strip", pytest.param("halfspace", marks=pytest.mark.full)])
def test_a_rigid_wheel_sinks_straight_down(model, name):
    """Strips have 0.24, 2.4 and 1.4 % at most."""
    (shift, yaw, force), wanted = SUNK[name]
    side = system_of(model).evaluate(shift, math.radians(yaw), force, side="right").right
    near = (2e-3, 0.012, 2e-3) if model == "halfspace" else (3e-3, 0.03, 0.02)
    for found, value, allowed in zip((side.penetration, side.area, side.max_pressure), wanted, near):
        assert found == pytest.approx(value, rel=allowed)
    assert side.normal_force == pytest.approx(force, rel=1e-6)


def test_a_rigid_wheel_is_a_compliant_one_where_it_has_sunk():
    """At the height that its penetration says: measured 0.6 and 3.2 %, since the first strips begin at other
    levels."""
    for pose in random_poses(40, 61, low=2e4):
        shift, yaw, force = pose[[layout.IN_LATERAL_SHIFT, layout.IN_YAW, layout.IN_NORMAL_FORCE]]
        rigid = system_of().evaluate(shift, yaw, force)
        for name in ("left", "right"):
            side = getattr(rigid, name)
            height = rigid.vertical_shift + side.penetration / math.cos(side.contact_angle)
            stands = getattr(
                system_of(contact_mode="compliant").evaluate(
                    shift, yaw, vertical_shift_input=height, roll_input=rigid.roll
                ),
                name,
            )
            assert stands.normal_force == pytest.approx(force, rel=9e-3), (name, *pose)
            assert stands.max_pressure == pytest.approx(side.max_pressure, rel=0.05), (name, *pose)


@pytest.mark.parametrize(
    "model, steps",
    [
        # measured 1.3e-4, 4.9e-4, 3.7e-4
        ("analyn_strip", (2e-4, 7.5e-4, 6e-4)),
        ("analyn", (2e-3, 1e-2, 1e-2)),
    ],
)
def test_nothing_jumps_where_a_patch_begins_to_turn(model, steps):
    """Through 15 degrees between the normals, and through the conformal zone, in steps of 0.5 um: no step of
    the load at one depth."""
    shifts = np.arange(5.9e-3, 5.95e-3, 0.5e-6)
    table = system_of(model, contact_mode="rigid").evaluate_many(shifts, 0.0, 78.5e3)
    for name, allowed in zip(("penetration", "area", "max_pressure"), steps):
        values = getattr(table.right, name)
        assert np.abs(np.diff(values) / values[1:]).max() < allowed, name
