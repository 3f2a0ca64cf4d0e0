"""The rigid witness against stored positions of another brute-force search, and against itself."""

from math import atan, radians

import numpy as np
import pytest

import data
from data.brute_force import (
    RAIL_HEADS,
    Pose,
    inclined_head,
    local_minima,
    rigid_contact,
    s1002,
    track,
    vertical_gap,
)

ROLL = 1e-12  # [rad]
POSITION = 1e-5  # [mm] the stored search located its minima to this
ANGLE = 1e-6  # [rad]


@pytest.fixture(scope="module")
def system():
    return track()


def every_third_is_quick(rows):
    """The rows as test parameters; two of three run with the long tests only."""
    return [pytest.param(row, marks=[pytest.mark.full] if k % 3 else []) for k, row in enumerate(rows)]


@pytest.mark.parametrize(
    "row",
    every_third_is_quick(data.rows_of(data.FOLDER / "rigid_positions.csv")),
    ids=lambda row: f"{row['lateral_shift_mm']}mm_{row['yaw_deg']}deg",
)
@pytest.mark.turns(3)
def test_agrees_with_stored_positions(system, row):
    found = rigid_contact(system, row["lateral_shift_mm"] * 1e-3, radians(row["yaw_deg"]))
    assert found.roll == pytest.approx(row["roll_rad"], abs=ROLL)
    assert found.vertical_shift * 1e3 == pytest.approx(row["wheelset_z_mm"], abs=POSITION)
    for side, wheel in (("R", found.right), ("L", found.left)):
        for name in ("y_wheel", "x_wheel", "y_track", "rolling_radius"):
            assert getattr(wheel, name) * 1e3 == pytest.approx(row[f"{side}_{name}_mm"], abs=POSITION), (
                side,
                name,
            )
        assert wheel.contact_angle == pytest.approx(row[f"{side}_contact_angle_rad"], abs=ANGLE)


def test_wheel_and_rail_touch_with_a_common_tangent(system):
    """At the contact z_wheel = r cos phi - R0, z_rail = z_track, and wheel and rail have the
    same angle to the track."""
    found = rigid_contact(system, 2e-3, 0.0)
    for wheel, side in ((found.right, 1), (found.left, -1)):
        assert wheel.z_rail == pytest.approx(wheel.z_track, abs=1e-15)
        assert wheel.z_wheel == pytest.approx(wheel.rolling_radius - system.nominal_radius, abs=1e-15)
        assert -atan(system.wheel(wheel.y_wheel)[1]) - side * found.roll == pytest.approx(
            wheel.contact_angle, abs=1e-12
        )


def test_no_point_of_the_wheel_is_lower(system):
    """Random points all over the wheel stay above the rail at the equilibrium pose."""
    found = rigid_contact(system, 6e-3, radians(1))
    pose = Pose(found.lateral_shift, found.yaw, found.roll, found.vertical_shift)
    assert local_minima(system, pose)[0].min() == pytest.approx(0, abs=1e-15)
    draw = np.random.default_rng(1)
    phi, y = draw.uniform(-0.2, 0.2, 200_000), draw.uniform(-0.07, 0.06, 200_000)
    assert vertical_gap(system, pose, phi, y)[0].min() > 0


@pytest.mark.parametrize("name", RAIL_HEADS)
@pytest.mark.parametrize("inclination", (0, 1 / 40, 1 / 20))
def test_rail_is_one_smooth_line(name, inclination):
    """Height and slope of neighbouring zones agree at every joint; the highest point is the origin."""
    head = inclined_head(RAIL_HEADS[name], inclination)
    for zone, (_, joint) in enumerate(head.ends[:-1]):
        here, there = head(joint * 1e-3, zone), head(joint * 1e-3, zone + 1)
        assert here[0] == pytest.approx(there[0], abs=1e-15) and here[1] == pytest.approx(there[1], rel=1e-9)
    assert head(0.0)[:2] == (0.0, 0.0)


def test_wheel_has_the_steps_of_the_printed_table():
    """0.12 um at -35 mm, 0.04 um at -26 mm, nothing elsewhere."""
    wheel = s1002()
    steps = [
        float(wheel(end * 1e-3, zone)[0] - wheel(end * 1e-3, zone + 1)[0])
        for zone, (_, end) in enumerate(wheel.ends[:-1])
    ]
    assert steps == pytest.approx([0, 0, 0, 0, 1.183e-7, -3.655e-8, 0], abs=1e-10)


def test_gauge():
    """Highest rail point of UIC60 1:40 at 760.5385 mm, so that the heads are 1435 mm apart 14 mm lower."""
    system = track()
    assert system.rail_origin * 1e3 == pytest.approx(760.5385, abs=5e-5)
    assert system.rail(0.7175 - system.rail_origin)[0] == pytest.approx(14e-3, abs=1e-14)
