"""The smallest gap over a rail whose section changes: against brute force, closed forms, and the search over constant rails."""

from functools import cache
from math import asin, atan, cos, sin, sqrt, tan

import numpy as np
import pytest

from tests.helpers.sections import NOSE_RISE, OnSections, moved, nose
from wrcontact import ContactSystem, Profile, RailSections
from wrcontact.kernel import layout
from wrcontact.kernel.binding.library import Kernel, default_kernel
from wrcontact.profiles import standard_profile
from wrcontact.profiles.zones import Polynomial

RAIL, RADIUS = standard_profile("UIC60"), 0.46
CROWN = 0.75  # half the distance of the running circles: the rail's highest point below y = 0 of the wheel


@cache
def system(wheel="S1002"):
    if wheel == "cylinder":
        wheel = Profile("cylinder", "wheel", (Polynomial(-60.0, 60.0, (0.0,)),))
    return ContactSystem(wheel=wheel, rail_inclination=0.0)


@cache
def waving(depth, length, spacing=5e-3):
    """A dip, a cosine, of this ``depth`` and ``length`` [m], at positions 0 ... ``length``."""
    u = np.arange(-0.3, 0.4, spacing)
    down = np.where((u > 0.0) & (u < length), 0.5 * depth * (1.0 - np.cos(2.0 * np.pi * u / length)), 0.0)
    return RailSections(u, [RAIL] * len(u), places=np.column_stack([0.0 * u, down]))


def rails():
    """Rail, where its origin lies, and the positions of a wheelset over it [m]."""
    across = system().profile_tables()[2]
    return {
        "constant": (lambda: moved([0.0, 0.5]), across, (-0.2, 0.7)),
        "nose": (lambda: nose(np.linspace(-0.1, 0.1, 21)), CROWN, (-0.06, 0.03)),
        "moving": (lambda: moved(np.linspace(-0.3, 0.6, 9), rate=0.04), across, (-0.05, 0.05)),
        "moving fast": (lambda: moved(np.linspace(-0.3, 0.6, 9), rate=0.1), across, (-0.05, 0.05)),
        "ramp": (lambda: moved(np.linspace(-0.3, 0.9, 9), rise=1.0 / 60.0), across, (-0.2, 0.5)),
        "ends": (lambda: moved(np.linspace(-0.3, 0.3, 7), rise=0.05), across, (0.2, 0.4)),
        "shallow dip": (lambda: waving(3e-4, 0.06), across, (-0.02, 0.08)),
        "short dip": (lambda: waving(3e-4, 0.04), across, (-0.02, 0.06)),
    }


def assert_brute(name, seed, count):
    made, lateral, (low, high) = rails()[name]
    over, generator = OnSections(system(), made(), lateral), np.random.default_rng(seed)
    for _ in range(count):
        pose = (
            generator.uniform(low, high),
            generator.uniform(-6e-3, 6e-3),
            generator.uniform(-0.03, 0.03),
            generator.uniform(-5e-3, 5e-3),
        )
        found = over.at(*pose)
        assert found.best == pytest.approx(over.brute(pose), abs=1e-10), pose
        own = over.gaps(pose, np.array([found.best_y]), np.array([found.best_angle]))
        assert own[0] == pytest.approx(found.best, abs=1e-13), pose


@pytest.mark.parametrize("name", rails())
def test_it_is_that_of_brute_force(name):
    assert_brute(name, 42, 1)


@pytest.mark.full
@pytest.mark.parametrize("name", rails())
def test_it_is_that_of_brute_force_at_more_poses(name):
    assert_brute(name, 43, 4)


@pytest.mark.parametrize("yaw", [0.0, 0.02])
@pytest.mark.parametrize("shift", [-4e-3, 0.0, 5.5e-3])
def test_equal_slices_are_touched_where_the_constant_rail_is(shift, yaw):
    """On both sides, at the roll of a wheelset on constant rails."""
    state = system().evaluate(lateral_shift=shift, yaw=yaw)
    for index, side, sign in ((0, state.left, -1.0), (1, state.right, 1.0)):
        over = OnSections(system(), moved([0.0, 0.5]), system().profile_tables()[2], index=index)
        found = over.at(0.2, sign * shift, sign * yaw, sign * state.roll)
        assert found.best == pytest.approx(state.vertical_shift, abs=1e-12)
        assert found.best_y == pytest.approx(side.contact.y_wheel, abs=1e-8)
        assert found.at.x == pytest.approx(side.contact.x_track, abs=1e-8)


@pytest.mark.parametrize("rate", [0.02, -0.1])
def test_a_rail_that_moves_is_a_narrower_one_under_a_turned_wheelset(rate):
    """By the angle a of its way: the section times cos(a), yaw less by a; of a head that is a polynomial."""
    turn = atan(rate)
    narrow, lateral, u = cos(turn), 0.755, 0.07
    heads = [
        Profile("own", "rail", (Polynomial(-36.0 * s, 36.0 * s, (0.0, 0.0, 4e-3 / s**2, 0.0, 2e-5 / s**4)),))
        for s in (1.0, narrow)
    ]
    at = np.linspace(-0.3, 0.3, 7)
    moving = RailSections(at, [heads[0]] * 7, places=np.column_stack([rate * at, 0.0 * at]))
    straight = RailSections([0.0, 1.0], [heads[1]] * 2)
    for shift, yaw, roll in ((0.0, 0.0, 0.0), (2e-3, 0.01, 1e-3), (-3e-3, -0.02, -2e-3)):
        found = OnSections(system(), moving, lateral).at(u, shift, yaw, roll)
        other = OnSections(system(), straight, narrow * (lateral + rate * u))
        turned = other.at(0.5, narrow * shift, yaw - turn, roll)
        assert found.best == pytest.approx(turned.best, abs=1e-11)
        assert found.best_y == pytest.approx(turned.best_y, abs=1e-8)
        assert found.best_angle == pytest.approx(turned.best_angle, abs=1e-8)


def test_on_a_slope_the_wheel_stands_higher_and_touches_ahead():
    """By R (sqrt(1 + m^2) - 1) over the ramp below the axle, at x = R m / sqrt(1 + m^2)."""
    over = OnSections(system("cylinder"), moved(np.linspace(-0.2, 0.2, 5), rise=0.1), CROWN)
    for u in (-0.1, 0.0, 0.1):
        found, steep = over.at(u), sqrt(1.01)
        assert found.best == pytest.approx(-0.1 * u - RADIUS * (steep - 1.0), abs=1e-11)
        assert found.at.x == pytest.approx(RADIUS * 0.1 / steep, abs=1e-8)
        assert found.best_angle == pytest.approx(asin(0.1 / steep), abs=1e-8)
        assert found.best_y == pytest.approx(0.0, abs=1e-8)


def test_the_nose_of_the_test_bank_is_touched_where_it_was():
    """S1002 over the nose: x 45.76 mm ahead and -2.1618 mm below, by brute force on the points of its slices."""
    found = OnSections(system(), nose(np.linspace(-0.1, 0.1, 21)), CROWN).at()
    assert found.best == pytest.approx(-2.1618e-3, abs=1e-6)
    assert found.at.x == pytest.approx(45.7588e-3, abs=2e-5)
    assert found.at.along == pytest.approx(-NOSE_RISE, abs=1e-9)


def test_a_yawed_wheelset_on_a_wave_follows_its_parallel_curve():
    """A sine of height a cos(k u) with a k^2 R < 1: axle at u - R sin(t), a cos(k u) + R (cos(t) - 1) over the level, with
    tan(t) = -a k sin(k u) and the contact at x = R sin(t)."""
    height, k = 1e-4, 2.0 * np.pi / 0.2
    at = np.arange(-0.2, 0.2001, 2e-3)
    rail = RailSections(at, [RAIL] * len(at), places=np.column_stack([0.0 * at, -height * np.cos(k * at)]))
    over = OnSections(system("cylinder"), rail, CROWN)
    for u in (-0.07, -0.03, 0.0, 0.02, 0.09):
        turn = atan(-height * k * sin(k * u))
        found = over.at(u - RADIUS * sin(turn))
        assert -found.best == pytest.approx(height * cos(k * u) + RADIUS * (cos(turn) - 1.0), abs=1e-7)
        assert found.at.x == pytest.approx(RADIUS * sin(turn), abs=1e-5)


def test_at_the_foot_of_a_slope_the_contact_jumps_ahead():
    """Both are touched with the axle at u = -R tan(atan(m) / 2)."""
    slope, at = 0.05, np.r_[-0.1:-0.0105:0.01, -0.01:0.0101:5e-4, 0.02:0.1501:0.01]
    rail = RailSections(
        at, [RAIL] * len(at), places=np.column_stack([0.0 * at, -slope * np.maximum(at, 0.0)])
    )
    over = OnSections(system("cylinder"), rail, CROWN)
    both = -RADIUS * tan(0.5 * atan(slope))
    before = over.at(both - 5e-5)
    assert before.at.x == pytest.approx(0.0, abs=1e-5) and before.best == pytest.approx(0.0, abs=1e-7)
    behind = over.at(both + 5e-5)
    assert behind.at.x == pytest.approx(RADIUS * sin(atan(slope)), abs=1e-5)
    assert behind.best == pytest.approx(-slope * 5e-5, abs=1e-7)


def test_few_boxes_are_looked_at():
    """With no start known: fewer than 150 at most poses; more where the flange stands beside the gauge face."""
    generator = np.random.default_rng(7)
    for name in ("constant", "nose", "ramp", "shallow dip", "short dip"):
        made, lateral, (low, high) = rails()[name]
        over = OnSections(system(), made(), lateral)
        poses = generator.uniform([low, -6e-3, -0.03, -5e-3], [high, 6e-3, 0.03, 5e-3], (25, 4))
        counts = [over.at(*pose).box_count for pose in poses]
        assert np.median(counts) <= 150 and max(counts) <= 2000, (name, counts)


@pytest.mark.skipif(not default_kernel().compiled, reason="the kernel is not compiled")
@pytest.mark.parametrize("name", ["nose"])
def test_the_source_has_the_bits_of_the_library(name):
    made, lateral, (low, high) = rails()[name]
    pose = 0.5 * (low + high), -2e-3, -0.02, 1e-3
    found = [
        OnSections(system(), made(), lateral, kernel)
        .at(*pose)
        .numbers()[: layout.SectionSearch.boxes.offset // 8]
        for kernel in (Kernel(), default_kernel())
    ]
    assert list(found[0]) == list(found[1])


def test_where_the_surface_ends_the_gap_is_not_certain():
    """A wheel whose tread hangs beside a head that ends on a slope touches its continuation, which ends 5 mm farther."""
    y = np.linspace(-20.0, 0.0, 201) * 1e-3
    head = RailSections([0.0, 0.5], [np.column_stack([y, 0.5 * (y - 0.06)])] * 2)
    over = OnSections(system(), head, CROWN + 0.03)
    pose = np.array([0.2, 0.0, 0.0, 0.0])
    assert not over.kernel.search_sections(over.tables, over.work, 1, pose)
