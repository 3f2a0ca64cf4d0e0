"""The source's searches: they find what the exact search finds where they can, and
say so where they cannot."""

import math

import numpy as np
import pytest

import wrcontact
from wrcontact.fmu.online import online_files
from wrcontact.study import (
    AdaptiveSearch,
    ConstraintSearch,
    DenserSearch,
    Search2D,
    Search3D,
    exact_result,
    variants,
)
from wrcontact.study.search import (
    Pose,
    Surfaces,
    jump_to_flange,
    lever_share,
    longitudinal_limit,
    profile_nodes,
    wang_shift,
)

pytestmark = pytest.mark.check

SPACINGS = (4e-4, 2e-4, 1e-4, 5e-5)  # [m]
EXACTLY = 1e-12  # tolerance of the distances [m], so that the nodes alone are seen


@pytest.fixture(scope="module")
def system():
    return wrcontact.ContactSystem()


def deg(yaw):
    return math.radians(yaw)


def roll_error(system, search, shift, yaw=0.0):
    return abs(search.solve(shift, yaw).roll - exact_result(system, shift, yaw).roll)


@pytest.mark.parametrize(
    "shifts, share",
    [((1e-3, 3e-3, 5e-3, 6e-3), 15.0), ((6.3e-3, 6.5e-3, 8e-3), 3000.0)],
    ids=["tread_and_root", "flange"],
)
def test_plane_search_converges_to_the_exact_one(system, shifts, share):
    """Between nodes a distance h apart curves are missed by h^2, on the flange with a short lever."""
    worst = []
    for spacing in SPACINGS:
        search = Search2D(system, spacing, tolerance=EXACTLY)
        for shift in shifts:
            found, exact = search.solve(shift), exact_result(system, shift)
            assert found.converged and abs(found.right.y_wheel - exact.right.y_wheel) < 1.5 * spacing
            # [m] with a lever of 1 m
            assert abs(found.vertical_shift - exact.vertical_shift) < share * spacing**2
        worst.append(max(roll_error(system, search, shift) for shift in shifts))
        assert worst[-1] < share * spacing**2
    rate = np.polyfit(np.log(SPACINGS), np.log(worst), 1)[0]
    assert 1.4 < rate < 2.8


@pytest.mark.parametrize(
    "shift, yaw, share",
    [(1e-3, 1, 30.0), (-3e-3, 3, 30.0), (6e-3, 1, 30.0), (6.5e-3, 1, 3000.0), (6e-3, 2, 3000.0)],
    ids=str,
)
def test_search_with_yaw_converges_to_the_exact_one(system, shift, yaw, share):
    yaw = deg(yaw)
    for spacing in SPACINGS[1:3]:
        dx = 5 * spacing
        profiles = math.ceil(Surfaces(system).reach(yaw) / dx) + 2
        search = Search3D(system, dx, spacing, tolerance=EXACTLY, profiles=profiles)
        found, exact = search.solve(shift, yaw), exact_result(system, shift, yaw)
        assert found.converged and found.remark == ""
        assert abs(found.roll - exact.roll) < share * spacing**2
        for side in ("left", "right"):
            one, other = getattr(found, side), getattr(exact, side)
            assert abs(one.y_wheel - other.y_wheel) < 1.5 * spacing
            # along the valley of the gap x goes with y, by up to 14 on the flange at 2 deg
            assert abs(one.x_wheel - other.x_wheel) < dx + 20 * spacing


@pytest.mark.parametrize("rail, inclination", [("60E1", 1 / 20), ("54E1", 0.0)])
def test_other_rails(rail, inclination):
    system = wrcontact.ContactSystem(rail=rail, rail_inclination=inclination)
    for shift, yaw in ((2e-3, 0.0), (-4e-3, deg(1))):
        for search in (Search3D(system, dx=5e-4), AdaptiveSearch(system), DenserSearch(system)):
            assert roll_error(system, search, shift, yaw) < 1e-6


def test_left_is_the_mirror_image_of_right(system):
    for search in (Search3D(system, dx=5e-4), DenserSearch(system, 1e-4, 1e-4)):
        one, other = search.solve(5.5e-3, deg(1)), search.solve(-5.5e-3, deg(-1))
        assert one.roll == pytest.approx(-other.roll, abs=1e-15)
        assert one.right.y_wheel == other.left.y_wheel and one.left.x_wheel == other.right.x_wheel


# ----------------------------------------------------------------------------------------------------- errata


def test_step_with_the_sign_as_printed_turns_away(system):
    assert not Search2D(system, gain=-1.2).solve(1e-3).converged


@pytest.mark.parametrize("roll, yaw, slope", [(3e-3, 0.03, -1.2), (-5e-3, -0.05, 0.4), (0.0, 0.0, -0.1)])
def test_corrected_shift_of_wang_is_the_contact_locus(roll, yaw, slope):
    t = math.tan(yaw) * math.sin(roll)
    phi = -math.atan(t) - math.asin(math.tan(yaw) * math.cos(roll) * slope / math.sqrt(1 + t * t))
    pose = Pose(0.0, yaw, roll)
    contact, lowest = (
        variants.turned(pose, 0.47 * math.sin(angle), 0.0, 0.47 * math.cos(angle)) for angle in (phi, 0.0)
    )
    np.testing.assert_allclose(
        wang_shift(0.47, -slope, roll=roll, yaw=yaw), np.subtract(contact, lowest), atol=1e-15
    )


def test_yawed_rail_as_printed_does_not_converge(system):
    """Source eq. (5.12) maps the abscissa the wrong way round: an error of 2 (1 - cos yaw) of
    it that no spacing cures."""
    shift, yaw = 3e-3, deg(3)
    printed, corrected = (
        Search3D(system, 2e-4, 2.5e-5, tolerance=EXACTLY, as_printed=printed) for printed in (True, False)
    )
    assert roll_error(system, corrected, shift, yaw) < 1e-8
    assert roll_error(system, printed, shift, yaw) > 2e-6


def test_contact_on_the_flange_beyond_the_range_of_the_source(system):
    """At 6 mm and 2 deg the right wheel touches 43 mm ahead; the 2-D search, in the flange
    root, lets look 7 mm ahead."""
    shift, yaw = 6e-3, deg(2)
    exact, plane = exact_result(system, shift, yaw), Search2D(system).solve(shift)
    height, slope = Surfaces(system).wheel(np.array(plane.right.y_wheel))
    limit = longitudinal_limit(0.46 + height, -slope, roll=plane.roll, yaw=yaw)
    assert exact.right.x_wheel == pytest.approx(42.762e-3, abs=1e-6)
    assert limit == pytest.approx(7.26e-3, abs=1e-4)
    found = Search3D(system).solve(shift, yaw)
    # and does not notice
    assert found.converged and abs(found.right.y_wheel - exact.right.y_wheel) > 9e-3
    assert roll_error(system, Search3D(system, dx=1e-3, profiles=67), shift, yaw) < 2e-5
    assert roll_error(system, DenserSearch(system), shift, yaw) < 1e-6


def test_flange_contact_comes_earlier_with_yaw_but_not_in_the_source_as_described(system):
    yaw, search = deg(2), Search3D(system, dx=1e-3)
    exact = jump_to_flange(lambda shift: exact_result(system, shift, yaw))
    found = jump_to_flange(lambda shift: search.solve(shift, yaw))
    plane = jump_to_flange(Search2D(system).solve)
    assert exact == pytest.approx(5.878e-3, abs=3e-6)
    assert found == pytest.approx(plane, abs=3e-6) and plane == pytest.approx(6.252e-3, abs=3e-6)


def test_the_gain_of_the_source_suits_the_tread(system):
    """A step is K times the difference over 2 * 750 mm, right on the tread; on the flange the
    true lever is a fifth."""
    steps = {
        gain: [Search2D(system, gain=gain).solve(shift).steps for shift in (3e-3, 6.5e-3)]
        for gain in (1.0, 1.2, 1.9)
    }
    assert steps[1.0][0] <= 5 and steps[1.9][0] > 30
    assert steps[1.2][1] > 30 and steps[1.9][1] < 0.7 * steps[1.2][1]


@pytest.mark.parametrize("shift, share", [(3e-3, 0.968), (6.5e-3, 0.226), (8e-3, 0.544)])
def test_lever_of_the_roll(system, shift, share):
    """Against the difference of the smallest distances 1e-5 rad to either side of the balance."""
    search, roll, gaps = Search2D(system, 1e-5), exact_result(system, shift).roll, []
    for turned in (roll - 1e-5, roll + 1e-5):
        left, right = (
            search._matrices[side][0].lowest(Pose(shift, 0.0, turned).of(side)) for side in ("left", "right")
        )
        gaps.append(left.gap - right.gap)
    measured = (gaps[1] - gaps[0]) / 2e-5 / (left.y_axle + right.y_axle)
    assert lever_share(system, shift) == pytest.approx(share, abs=1e-3)
    assert measured == pytest.approx(share, abs=5e-3)


# -------------------------------------------------------------------------------------------------- proposals


def test_adaptive_dx_reaches_the_fine_result_with_fewer_gaps(system):
    shift, yaw, dx = 6.5e-3, deg(1), 5e-5
    adaptive, fine = AdaptiveSearch(system, dx).solve(shift, yaw), Search3D(system, dx).solve(shift, yaw)
    assert adaptive.converged and fine.converged
    assert abs(adaptive.roll - fine.roll) < 1e-6
    assert abs(adaptive.right.y_wheel - fine.right.y_wheel) < 1.01e-4
    assert adaptive.gap_evaluations < fine.gap_evaluations / 3


def test_denser_nodes_are_ten_times_better_for_less(system):
    for shift, yaw in ((5e-3, deg(1)), (6.5e-3, deg(1)), (8e-3, deg(3))):
        denser, adaptive = (search(system).solve(shift, yaw) for search in (DenserSearch, AdaptiveSearch))
        exact = exact_result(system, shift, yaw)
        assert denser.converged and abs(denser.right.y_wheel - exact.right.y_wheel) < 1e-5
        assert abs(denser.roll - exact.roll) < 1e-6
        assert denser.gap_evaluations < 0.5 * adaptive.gap_evaluations


# -------------------------------------------------------------------------------------------------- equations


@pytest.mark.parametrize("method", ["hybr", "lm"])
@pytest.mark.parametrize(
    "shift, yaw", [(1e-3, 0), (-5e-3, 0), (6e-3, 1), (6e-3, 2), (6.5e-3, 0), (8e-3, 3)], ids=str
)
def test_equations_find_the_exact_contact_from_nearby(system, shift, yaw, method):
    yaw = deg(yaw)
    exact = exact_result(system, shift, yaw)
    start = (exact.roll + 1e-5, exact.left.y_wheel + 1e-4, exact.right.y_wheel - 1e-4)
    found = ConstraintSearch(system, method).solve(shift, yaw, start=start)
    assert found.converged and found.remark == ""
    assert abs(found.roll - exact.roll) < 1e-9 and abs(found.vertical_shift - exact.vertical_shift) < 1e-9
    for side in ("left", "right"):
        for name in ("x_wheel", "y_wheel", "y_rail"):
            assert abs(getattr(getattr(found, side), name) - getattr(getattr(exact, side), name)) < 1e-8


def test_equations_may_find_another_stationary_point(system):
    """From the flange root, where the contact would be without yaw: all equations are met,
    0.33 mm inside the rail."""
    shift, yaw = 6e-3, deg(2)
    plane = Search2D(system).solve(shift)
    found = ConstraintSearch(system).solve(
        shift, yaw, start=(plane.roll, plane.left.y_wheel, plane.right.y_wheel)
    )
    assert found.converged and "another stationary point: a wheel is 0.33" in found.remark
    assert abs(found.right.y_wheel - exact_result(system, shift, yaw).right.y_wheel) > 9e-3


# --------------------------------------------------------------------------------------------------- failures


def test_failures_are_results(system):
    wild = Search2D(system, gain=3.0).solve(3e-3)
    assert not wild.converged and wild.remark == "the roll left +-0.12 rad"
    for search in (Search2D(system), Search3D(system), AdaptiveSearch(system), DenserSearch(system)):
        for shift, yaw in ((0.2, 0.0), (-0.2, deg(1))):
            found = search.solve(shift, yaw)
            assert not found.converged and "above its rail" in found.remark
    unsolved = ConstraintSearch(system).solve(6e-3, 0.0, start=(0.0, 0.0, 0.0))
    assert not unsolved.converged and unsolved.remark == "the equations are not met"
    assert not exact_result(system, 0.2).converged


def test_contact_in_the_last_profile_is_reported(system):
    assert "last profile (right)" in Search3D(system, profiles=101).solve(6.5e-3, deg(1)).remark


def test_nodes_are_multiples_of_their_spacing():
    np.testing.assert_allclose(
        profile_nodes((-0.35, 0.25), 0.1), [-0.3, -0.2, -0.1, 0.0, 0.1, 0.2], atol=1e-15
    )


def test_studies_are_not_packed():
    assert not [name for name in online_files() if "study" in name]
