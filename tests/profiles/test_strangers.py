"""Public files of other people (data/foreign), with what other programs or their formats say of them."""

import warnings

import numpy as np
import pytest

from tests.helpers.paths import DATA
from wrcontact import ContactSystem, Profile, ProfileWarning
from wrcontact.wear.shape import wheel_shape

MM = 1e-3
FOREIGN = DATA / "foreign"


def opened(name, kind, **options):
    """The profile in a file, and what is said of it."""
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        profile = Profile.from_file(FOREIGN / name, kind, **options)
    assert all(issubclass(one.category, ProfileWarning) for one in said)
    return profile, " ".join(str(one.message) for one in said)


def test_a_miniprof_wheel_is_in_contact_where_contact_says():
    """CONTACT's case 22: 32.66 mm from the back of the flange, 0.6455 rad, at a normal force of 114 kN."""
    wheel, said = opened("avg_wheel_points.whl", "wheel")
    rail, _ = opened("avg_HR_points.ban", "rail")
    assert "running circle" not in said
    system = ContactSystem(
        wheel=wheel,
        rail=rail,
        rail_inclination=0.0,
        gauge=1.4351,
        gauge_depth=15.875 * MM,
        running_circle_distance=1.3522 + 2 * 70.0 * MM,
        nominal_radius=0.4191,
        contact_mode="compliant",
    )
    heights = np.linspace(0.25, 0.40, 31) * MM
    left = system.evaluate_many(
        lateral_shift=-12.916 * MM, roll_input=1.413332e-3, yaw=-7.708929e-3, vertical_shift_input=heights
    ).left
    height = np.interp(114.0e3, left.normal_force, heights)
    assert np.interp(height, heights, left.contact.y_wheel) / MM + 70.0 == pytest.approx(32.66, abs=0.3)
    assert np.interp(height, heights, left.contact_angle) == pytest.approx(0.6455, abs=0.01)


def test_points_that_run_back_at_the_tip_cut_nothing():
    """x = 0 is the back of the flange; 10 mm below the running circle its face is at 33.1 mm."""
    wheel, said = opened("Car7216_0001r.whl", "wheel")
    assert "4 points left out where the points run back by up to 0.597 mm (y = -54.7 ... -54.11 mm)" in said
    assert wheel.start == pytest.approx(-70.0 * MM, abs=0.2 * MM)
    assert wheel_shape(wheel).flange_thickness == pytest.approx(33.1 * MM, abs=0.2 * MM)
