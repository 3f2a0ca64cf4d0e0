"""The worn profile: circles stay circles, nothing taken leaves everything, and integrals stay."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.wear_cases import system
from wrcontact.profiles.catalogue import standard_profile
from wrcontact.profiles.profile import Profile
from wrcontact.profiles.zones import Arc as Circle
from wrcontact.wear.bins import Arc, evaluate
from wrcontact.wear.shape import wheel_shape
from wrcontact.wear.update import moved_places, smoothed, worn_profile

#: Kind of profile, side of the circle (+1: its lower half), and which way its radius goes.
CIRCLES = (("wheel", +1, -1), ("wheel", -1, +1), ("rail", -1, -1))


def circle(kind, side, radius=80.0):
    """Part of a circle [mm] as a profile with its end of the radius at 0."""
    return Profile(f"circle {side:+d}", kind, (Circle(-40.0, 40.0, radius, 0.0, -side * radius, side),))


@pytest.mark.parametrize("kind, side, sign", CIRCLES)
def test_a_circle_stays_a_circle(kind, side, sign):
    profile = circle(kind, side)
    arc = Arc(profile)
    worn = worn_profile(arc, np.full(len(arc.middles), 0.3e-3))
    y = np.linspace(worn.start, worn.stop, 5001)[1:-1]
    # a rail's highest point is its origin again
    centre = -side * 80e-3 if kind == "wheel" else 80e-3 - 0.3e-3
    radius = np.hypot(y, worn.height(y) - centre)
    assert radius == pytest.approx(80e-3 + sign * 0.3e-3, abs=1e-9)


def test_nothing_taken_leaves_the_profile():
    arc = Arc(system().wheel)
    worn = worn_profile(arc, np.zeros(len(arc.middles)))
    assert worn == system().wheel
    y = np.linspace(worn.start, worn.stop, 1001)
    assert np.array_equal(worn.height(y), system().wheel.height(y))


def bump(arc, depth, at=0.06, width=4e-3):
    return depth * np.exp(-(((arc.middles - at) / width) ** 2)) * (np.abs(arc.middles - at) < 4 * width)


def test_unworn_pieces_stay():
    wheel = system().wheel
    arc = Arc(wheel)
    depth = bump(arc, 0.2e-3)
    worn = worn_profile(arc, depth)
    places = arc.places[depth > 0.0]
    assert worn.zones[0] == wheel.zones[0] and worn.zones[-1].stop == wheel.zones[-1].stop
    for y in (
        np.linspace(wheel.start, places[0] - 1e-3, 500),
        np.linspace(places[-1] + 1e-3, wheel.stop, 500),
    ):
        assert worn.height(y) == pytest.approx(wheel.height(y), abs=1e-15)
    assert max(abs(joint.slope_step) for joint in worn.joints) < 3e-5


def test_depth_on_a_flank_is_along_its_normal():
    """70 degrees: a depth of 0.1 mm lowers the flank by 0.292 mm at the same y, and moves it by 0.106 mm."""
    wheel = system().wheel
    arc, flank = Arc(wheel), -39.1e-3
    depth = np.where(np.abs(arc.middles - np.interp(flank, arc.y, arc.s)) < 15e-3, 0.1e-3, 0.0)
    worn = worn_profile(arc, smoothed(depth, arc, 1e-3))
    lower = wheel.height(flank) - worn.height(flank)
    assert lower == pytest.approx(0.1e-3 * np.hypot(1.0, wheel.slope(flank)), rel=2e-3)
    assert lower == pytest.approx(0.292e-3, rel=0.01)


def test_two_halves_are_one_whole_to_second_order():
    """The second half takes as much off the same points of the material."""

    def difference(depth):
        arc = Arc(system().wheel)
        once, half = worn_profile(arc, bump(arc, depth)), worn_profile(arc, bump(arc, depth / 2))
        again = Arc(half)
        places = moved_places(arc, bump(arc, depth / 2), half)
        twice = worn_profile(again, np.interp(again.own_places, places, bump(arc, depth / 2)))
        y = np.linspace(-40e-3, 20e-3, 4001)
        return np.max(np.abs(once.height(y) - twice.height(y)))

    errors = np.array([difference(depth) for depth in (0.8e-3, 0.4e-3, 0.2e-3)])
    assert errors[0] < 0.05e-3
    assert np.all(errors[:-1] / errors[1:] > 3.5), errors  # 4 for second order


@pytest.mark.parametrize("kind", ["wheel", "rail"])
def test_points_of_the_material_are_found_again(kind):
    """A point that moves along its normal lies on the worn profile, at the place that is told."""
    profile = getattr(system(), kind)
    arc = Arc(profile)
    depth = bump(arc, 0.3e-3, at=0.5 * arc.s[-1], width=12e-3)
    worn = worn_profile(arc, depth)
    places, sign = moved_places(arc, depth, worn), 1.0 if kind == "wheel" else -1.0
    height, slope = evaluate(profile, arc.own_places)
    moved = height - sign * depth / np.hypot(1.0, slope)
    inside = np.abs(slope) < 5.0
    down = np.median(moved[inside] - worn.height(places[inside]))  # a rail's origin goes down with its top
    # where the curvature jumps, a spline through points 0.2 mm apart is off by 0.2 um
    off = np.abs(worn.height(places[inside]) - (moved[inside] - down))
    assert np.max(off) < 3e-7 and np.median(off) < 1e-8
    assert down == pytest.approx(0.0 if kind == "wheel" else np.min(moved), abs=1e-7)


@pytest.mark.parametrize("smoothing", [0.0, 0.3e-3, 1e-3, 5e-3])
def test_smoothing_keeps_the_integral(smoothing):
    arc, draw = Arc(system().rail), np.random.default_rng(1)
    for depth in (
        draw.uniform(0.0, 1e-3, len(arc.middles)),
        np.eye(len(arc.middles))[0],
        np.eye(len(arc.middles))[-1],
    ):
        assert smoothed(depth, arc, smoothing).sum() == pytest.approx(depth.sum(), rel=1e-12)
    if smoothing > arc.width:
        one = smoothed(np.eye(len(arc.middles))[len(arc.middles) // 2], arc, smoothing)
        spread = np.sqrt(one @ (arc.middles - arc.middles[len(arc.middles) // 2]) ** 2)
        assert spread == pytest.approx(smoothing, rel=1e-3)


def test_many_pieces_are_read_as_one_by_one():
    arc = Arc(system().wheel)
    worn = worn_profile(arc, bump(arc, 0.2e-3))
    y = np.linspace(worn.start + 1e-6, worn.stop - 1e-6, 3001)
    height, slope = evaluate(worn, y)
    assert height == pytest.approx(worn.height(y), abs=1e-15)
    assert slope == pytest.approx(worn.slope(y), abs=1e-10)


def test_a_place_alone_has_the_bits_of_an_array():
    """Joints of many zones are checked one by one."""
    arc = Arc(system().wheel)
    for zone in (*system().wheel.zones, *worn_profile(arc, bump(arc, 0.2e-3)).zones[::40]):
        for y in np.linspace(zone.start, zone.stop, 5):
            alone, array = zone(float(y)), np.array(zone(np.array([y])))[:, 0]
            assert np.array_equal(alone, array, equal_nan=True), (zone, y)


def test_a_curve_that_folds_is_refused():
    """A hollow circle of 20 mm cannot lose 30 mm of depth on the way to its centre; one mm in steps of 0.1 mm
    with depths that jump folds a steep flank."""
    arc = Arc(system().wheel)
    flank = np.interp(-39e-3, arc.y, arc.s)
    depth = np.where(np.abs(arc.middles - flank) < 0.3e-3, 1.9e-3, 0.0)
    with pytest.raises(ValueError, match="worn profile S1002 folds at y = .* permitted are smaller steps"):
        worn_profile(arc, depth)


def test_the_next_system_reads_the_worn_profile(tmp_path):
    """As an object, and as the file of a prepared profile."""
    from wrcontact.profiles.files import prepared_text

    arc = Arc(system().wheel)
    worn = worn_profile(arc, bump(arc, 0.2e-3))
    (tmp_path / "worn.json").write_text(prepared_text(worn))
    states = [wrcontact.ContactSystem(wheel=wheel).evaluate(2e-3) for wheel in (worn, tmp_path / "worn.json")]
    assert np.array_equal(states[0].values, states[1].values) and states[0].status == 0


def test_what_a_workshop_measures():
    """EN 13715's S1002 has h 28 and e 32.5; a wheel that is smaller by 1 mm everywhere but at its back has a
    flange of the same height and is thinner on its front."""
    new = standard_profile("S1002")
    shape = wheel_shape(new)
    assert shape.flange_height == pytest.approx(28e-3, abs=1e-6)
    assert shape.flange_thickness == pytest.approx(32.5e-3, abs=1e-5)
    # qR: the front at 10 mm above, and 2 mm below the tip
    y = np.linspace(-56e-3, -30e-3, 26001)
    at = [y[np.argmin(np.abs(new.height(y) - level))] for level in (10e-3, 26e-3)]
    assert shape.flange_steepness == pytest.approx(at[0] - at[1], abs=2e-6)
    hollow = wheel_shape(
        worn_profile(Arc(new), bump(Arc(new), 1.0e-3, at=Arc(new).at(8e-3), width=8e-3)), new
    )
    assert 0.3e-3 < hollow.hollow < 1.0e-3 and shape.hollow == 0.0
    assert hollow.flange_height > shape.flange_height
    assert np.isnan(wheel_shape(standard_profile("cone20")).flange_height)
