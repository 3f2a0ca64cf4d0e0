"""Public files of other people (data/foreign), with what other programs or their formats say of them."""

import warnings

import numpy as np
import pytest

from tests.helpers.paths import DATA
from wrcontact import ContactSystem, Profile, ProfileFile, ProfileWarning
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


def contact(name, **options):
    """Where the rail in a file touches S1002 [m], silently."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ProfileWarning)
        return ContactSystem(rail=ProfileFile(FOREIGN / name, **options)).evaluate(normal_force=78.5e3).right


def test_a_nose_on_a_wide_base_is_not_turned_over():
    """Simpack has z down; the contact is 11.2 mm from the top of the nose."""
    rail, said = opened("nose_10.prr", "rail")
    assert (
        said == ""
        and rail.height(0.0) == pytest.approx(0.0, abs=1e-12)
        and rail.height(rail.stop) > 15.0 * MM
    )
    assert contact("nose_10.prr").contact.y_rail == pytest.approx(-11.2 * MM, abs=0.2 * MM)


def test_a_gap_below_the_gauge_needs_no_points():
    """The gauge is measured 14 mm below the top; the gap begins at 17.6 mm."""
    rail, said = opened("roller_left.ban", "rail")
    assert "gap of 12.6 mm from 17.6 mm below the top on; the points behind it are left out" in said
    assert rail.height(rail.start) > 15.5 * MM
    assert np.isfinite(contact("roller_left.ban").contact.y_rail)


def test_one_of_two_heads_in_a_file_is_cut_out():
    """The running rail ends at y = 0 of the file, its gauge face."""
    with pytest.raises(
        ValueError, match="for a rail; y_range = FROM,TO uses one of several profiles in a file"
    ):
        opened("guard_rail.ban", "rail")
    rail, said = opened("guard_rail.ban", "rail", y_range=(-80.0 * MM, 1.0 * MM))
    assert "only this side reaches 14 mm below the top); mirrored" in said
    assert rail.stop - rail.start == pytest.approx(67.28 * MM + 1.0 * MM, abs=1.0 * MM)
    with pytest.raises(ValueError, match="has 0 points between y = 200 and 300 mm; permitted are 10 or more"):
        opened("guard_rail.ban", "rail", y_range=(0.2, 0.3))


def test_noise_in_a_part_of_a_file_is_smoothed_there():
    """CONTACT: 1096 MPa at y = 9.33 mm on the wheel."""
    wheel, said = opened("wheel_section_1.txt", "wheel")
    rail, _ = opened("r300_wide.prr", "rail")
    assert "its noise differs from place to place, 0." in said and "each place is smoothed by its own" in said
    assert wheel.reading.noise == pytest.approx(6.0 * MM * MM, rel=0.3)
    right = (
        ContactSystem(wheel=wheel, rail=rail, rail_inclination=0.02, nominal_radius=0.49)
        .evaluate(normal_force=125e3)
        .right
    )
    assert right.max_pressure == pytest.approx(1096e6, rel=0.05)
    assert right.contact.y_wheel == pytest.approx(9.33 * MM, abs=1.0 * MM)
