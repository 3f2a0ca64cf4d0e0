"""The smallest gap of profiles with corners and with points that are very close to each other."""

import warnings

import numpy as np
import pytest

import wrcontact
from tests.helpers.rough_pairs import rough_pairs
from tests.helpers.sampled_pair import SampledPair
from wrcontact.profiles import standard_profile
from wrcontact.profiles.compiled import evaluate_table
from wrcontact.profiles.zones import Arc, Polynomial

#: [m] The search may hide 1e-11 m in a cell; the pieces of both profiles follow their zones to 1e-12 m, and
#: the sampled gap is as much above the smallest one.
SAMPLED = 1e-10
PLACED = 1e-9  # [m] the same of a rail with steps in height, which is placed by sampled points, too
COLD = 1e-7  # [rad] a guess, so that no pose starts at the contacts of the one before


#: The wheel 1:40 of EN 13715 with a flange of 28 mm.
WHEEL_1_40 = standard_profile("1-40/h28/e32.5/6.7%")


def fine_rail(step, digits):
    """UIC60 as points: every 0.25 mm, and ``step`` [mm] apart where its corner touches flanges; heights
    [mm] with so many digits behind the point."""
    y = np.unique(np.append(np.arange(-35.9, 35.9, 0.25), np.arange(-35.9, -33.0, step)))
    z = np.round(standard_profile("UIC60").height(y * 1e-3) * 1e3, digits)
    return wrcontact.Profile.from_points(y, z, name="fine", kind="rail")


def misses(pair, table, shift, yaw):
    """By how much the vertical shifts of the valid poses of a ``table`` are above the smallest gap of each of
    their wheels (2 n,) [m]."""
    found = []
    for k in np.flatnonzero(table.status == 0):
        for sign, side in ((-1, table.left), (1, table.right)):
            pose = sign * shift[k], sign * table.roll[k]
            if yaw[k]:
                y = side.contact.y_wheel[k]
                radius = pair.radius + np.interp(y, *pair.wheel_points)
                place = y, np.arcsin(side.contact.x_wheel[k] / radius)
                found.append(table.vertical_shift[k] - pair.smallest_yawed(*pose, sign * yaw[k], [place])[0])
            else:
                found.append(table.vertical_shift[k] - pair.smallest(*pose)[0])
    return np.array(found)


def check_pairs(seed, count, poses, first=0, yawed=False):
    """The smallest gaps of random pairs are those of the sampled surfaces, and what is refused rests on the
    end of a profile."""
    valid = 0
    for number, pair, shift, yaw in rough_pairs(seed, count, poses, first):
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", wrcontact.ProfileWarning)
                system = pair.system
        except ValueError as problem:  # a rail whose drawn side ends above the depth of the gauge
            assert "gauge_depth" in str(problem), number
            continue
        yaw = yaw if yawed else 0.0 * yaw
        table = system.evaluate_many(shift, yaw, roll_guess=COLD, outputs="geometry")
        off = misses(pair.sampled, table, shift, yaw)
        assert np.abs(off).max(initial=0.0) < PLACED, (number, off)
        for k in np.flatnonzero(table.status):
            assert table.status[k] == wrcontact.Status.OFF_PROFILE, (number, k)
            assert pair.sampled.touches_end(shift[k], yaw[k]), (number, k)
        valid += np.sum(table.status == 0)
    assert valid > 0.6 * count * poses


def test_points_five_micrometres_apart_hide_no_contact():
    """In the cell in which the rail ends, a bound of -1 1/m stood for a bend of -150 000 1/m: 81 of 400 such
    poses had status 2."""
    system = wrcontact.ContactSystem(rail=fine_rail(5e-3, 3))
    pair = SampledPair(system.wheel.zones, system.rail.zones)
    shift = np.linspace(6.28e-3, 6.36e-3, 24)
    table = system.evaluate_many(shift, roll_guess=COLD, outputs="geometry")
    assert not table.status.any()
    assert np.abs(misses(pair, table, shift, 0.0 * shift)).max() < SAMPLED


def test_points_a_micrometre_apart_hide_little():
    """Bends of 1e7 1/m between rounded points: cells were halved to 2 um, which hides micrometres of them."""
    system = wrcontact.ContactSystem(rail=fine_rail(1e-3, 4))
    pair = SampledPair(system.wheel.zones, system.rail.zones)
    shift = np.array([6.15e-3, -6.3e-3, 6.9e-3])
    table = system.evaluate_many(shift, roll_guess=COLD, outputs="geometry")
    assert not table.status.any()
    # a piece of 1 um is not divided further, and follows its zone to 2 nm
    assert np.abs(misses(pair, table, shift, 0.0 * shift)).max() < 5e-9


def test_ripples_of_twenty_nanometres_hide_no_contact():
    """A cone rests on one of several crests, 0.15 mm apart. A cell as wide as that was left out if it could
    hide no more than 0.1 um."""
    y = np.unique(np.round(np.append(np.arange(-35.9, 35.9, 0.25), np.arange(-9.0, -6.0, 0.01)), 9))
    ripple = 2e-5 * np.cos(2.0 * np.pi * y / 0.15) * (np.abs(y + 7.5) < 1.4)
    z = standard_profile("60E1").height(y * 1e-3) * 1e3 + ripple
    rail = wrcontact.Profile.from_points(y, z, name="ripple", kind="rail")
    system = wrcontact.ContactSystem("cone20", rail)
    pair = SampledPair(system.wheel.zones, system.rail.zones)
    shift = np.linspace(-3e-3, 3e-3, 12)
    table = system.evaluate_many(shift, roll_guess=COLD, outputs="geometry")
    assert not table.status.any()
    assert np.ptp(table.right.contact.y_rail) > 0.14e-3  # another crest
    assert np.abs(misses(pair, table, shift, 0.0 * shift)).max() < SAMPLED


def test_a_hollow_corner_hides_no_contact():
    """The bounds of bends do not see a jump of slope: roll 0.2515 mrad, contact at -11.60 mm."""
    zones = (Polynomial(-60.0, -15.0, (0.375, -0.1), -15.0), Polynomial(-15.0, 60.0, (0.375, -0.025), -15.0))
    wheel = wrcontact.Profile("corner", "wheel", zones, smooth=False)
    with pytest.warns(wrcontact.ProfileWarning, match=r"1 corner of up to 4\.28 deg .* by up to 0\.7 um"):
        system = wrcontact.ContactSystem(wheel, "60E1", rail_inclination=0.0)
    state = system.evaluate(lateral_shift=-7.39e-3, outputs="geometry")
    assert state.status == 0
    # the steeper line alone touches there, far from the corner
    steep = wrcontact.Profile("line", "wheel", (Polynomial(-60.0, 60.0, (0.375, -0.1), -15.0),))
    flat = wrcontact.Profile("line", "wheel", (Polynomial(-60.0, 60.0, (0.375, -0.025), -15.0),))
    pairs = [SampledPair(line.zones, system.rail.zones, 0.0) for line in (steep, flat)]
    for sign in (-1, 1):
        # a wheel with a hollow corner is the higher of both lines
        lowest = min(pair.smallest(sign * -7.39e-3, sign * state.roll)[0] for pair in pairs)
        assert state.vertical_shift == pytest.approx(lowest, abs=1e-11)
    assert state.roll == pytest.approx(0.3260e-3, abs=5e-8)
    assert state.left.contact.y_wheel == pytest.approx(-19.55e-3, abs=5e-5)


@pytest.mark.parametrize("step", [0.0, 5e-5, -1.9e-4])
@pytest.mark.parametrize("turn", [0.175, -0.04, 2e-5])
def test_a_corner_with_a_step_in_height_is_rounded_like_one_without(step, turn):
    """Both sides are led to their mean height, and keep their slopes up to the corner: the repair of S1002's
    steps led both slopes to their mean, too, 8.7 um off a corner of 0.175."""
    zones = (
        Polynomial(-30.0, -5.0, (0.2, -0.03), -5.0),
        Polynomial(-5.0, 30.0, (0.2 + step, -0.03 + turn, -1e-3), -5.0),
    )
    wheel = wrcontact.Profile("step", "wheel", zones, smooth=False)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", wrcontact.ProfileWarning)
        table = wrcontact.ContactSystem(wheel, "60E1").profile_tables()[0]
    y, z = SampledPair(zones, zones).wheel_points
    height, slope, bend = evaluate_table(table, y)
    assert np.abs(height - z).max() < 2e-12
    near = np.abs(y + 5e-3) < 0.6e-3
    sharp = np.where(y < -5e-3, *(zone(y * 1e3)[0] for zone in zones)) * 1e-3
    width = max(0.05, 0.5 * abs(turn)) * 1e-3
    # half the step, and 3/16 of turn times width in the middle of a corner
    assert np.abs(height - sharp).max() < 0.5e-3 * abs(step) + 3 / 16 * abs(turn) * width + 1e-9
    assert np.all((slope > -0.03 - 2e-3 + min(turn, 0.0)) & (slope < -0.03 + 2e-3 + max(turn, 0.0)) | ~near)


def test_steps_in_height_do_not_cut_an_inclined_rail_off():
    """Turned zones whose heights differ by 0.2 um do not meet: a rail was read up to the first such joint
    only."""
    whole = standard_profile("60E1")
    moved = [
        Arc(zone.start, zone.stop, zone.radius, zone.y_centre, zone.z_centre + 1e-4 * (k % 2), zone.side)
        if isinstance(zone, Arc)
        else Polynomial(
            zone.start,
            zone.stop,
            (zone.coefficients[0] + 1e-4 * (k % 2), *zone.coefficients[1:]),
            zone.origin,
        )
        for k, zone in enumerate(whole.zones)
    ]
    stepped = wrcontact.Profile("steps", "rail", tuple(moved), smooth=False)
    tables = [wrcontact.ContactSystem(rail=rail, rail_inclination=1 / 20) for rail in (whole, stepped)]
    one, other = (system.evaluate_many(np.linspace(-7e-3, 7e-3, 29), outputs="geometry") for system in tables)
    assert not other.status.any()
    # steps of 1e-7 m, over levers of 0.2 m or more
    assert np.abs(one.vertical_shift - other.vertical_shift).max() < 3e-7
    assert np.abs(one.roll - other.roll).max() < 1e-6


@pytest.mark.parametrize("rail", ["60E1", "54E1", "UIC60"])
@pytest.mark.parametrize("inclination", [0.0, 1 / 40, 1 / 20])
def test_the_wheel_1_40_of_en_13715_touches_everywhere(rail, inclination):
    """Its corner of 1.016 mrad at y = -0.5 mm was refused as the end of a profile at 14 ... 82 of 1601
    shifts."""
    system = wrcontact.ContactSystem(WHEEL_1_40, rail, rail_inclination=inclination)
    shift = np.linspace(-8e-3, 8e-3, 321)
    table = system.evaluate_many(shift, outputs="geometry")
    assert not table.status.any()
    some = np.sort(np.random.default_rng(5).choice(321, 5))
    pair = SampledPair(system.wheel.zones, system.rail.zones, inclination)
    picked = system.evaluate_many(shift[some], outputs="geometry")
    assert np.abs(misses(pair, picked, shift[some], 0.0 * some)).max() < SAMPLED


def test_check_says_that_hertz_has_no_limit_at_a_convex_corner():
    zones = (Polynomial(-60.0, 0.0, (0.0, -0.025), 0.0), Polynomial(0.0, 60.0, (0.0, -0.067), 0.0))
    convex = wrcontact.Profile("convex", "wheel", zones, smooth=False)
    with pytest.warns(wrcontact.ProfileWarning, match="1 corner of up to 2.4 deg"):
        report = wrcontact.check(wrcontact.ContactSystem(convex, "60E1"))
    said = [remark for remark in report.remarks if "hertz has no limit" in remark]
    assert len(said) == 1 and "convex at 1 kink (y = 0 mm)" in said[0]


def test_random_pairs():
    check_pairs(31, 4, 4)
    check_pairs(32, 2, 1, yawed=True)


@pytest.mark.full
@pytest.mark.parametrize("part", range(4))
@pytest.mark.turns(4)
def test_a_thousand_poses_of_random_pairs(part):
    check_pairs(33, 15, 20, first=15 * part)
    check_pairs(34, 5, 5, first=5 * part, yawed=True)


@pytest.mark.complete
@pytest.mark.parametrize("part", range(100))
def test_a_million_poses_of_random_pairs(part):
    check_pairs(35, 100, 99, first=100 * part)
    check_pairs(36, 20, 5, first=20 * part, yawed=True)
