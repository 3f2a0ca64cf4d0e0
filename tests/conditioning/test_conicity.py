"""Equivalent conicity, against closed forms, the standard's reference value, and a search of its own."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import wrcontact
from data import brute_force
from tests.helpers.cases import MM
from wrcontact import ContactSystem, Profile
from wrcontact.conditioning import equivalent_conicity, regressed_conicity
from wrcontact.conditioning.conformal import NEAR
from wrcontact.conditioning.conicity import NO_RETURN, OFF_PROFILE, Swing
from wrcontact.profiles.zones import Arc, Polynomial

AMPLITUDES = np.arange(1, 9) * 1e-3  # [m]


# --- equivalent conicity of given rolling radius differences --------------------------------------


def half_wave_in_time(shift, difference, start):
    """Half a wave [m] of y'' = -delta_r(y) from a turning point, by integrating the
    motion until the next one."""

    def turns(_, state):
        return state[1]

    turns.terminal, turns.direction = True, -1.0 if start < 0.0 else 1.0
    nudge = 1e-9 * abs(start)  # off the turning point at which the integration starts
    rate = -np.interp(start, shift, difference)
    first = math.sqrt(2 * nudge / abs(rate))
    # steps short enough to see a jump, which spans 2e-9 m in the curves
    found = solve_ivp(
        lambda _, state: [state[1], -np.interp(state[0], shift, difference)],
        (first, 1e6),
        [start + math.copysign(nudge, rate), rate * first],
        events=turns,
        rtol=1e-9,
        atol=1e-13,
        max_step=0.05,
    )
    return found.t_events[0][0]


def test_cone():
    shift = np.linspace(-10, 10, 7) * MM
    np.testing.assert_allclose(equivalent_conicity(shift, 2 * 0.05 * shift, AMPLITUDES), 0.05, rtol=1e-9)


def test_linear_regression_of_a_cone_and_of_a_cubic():
    """Of delta_r = k y^3 the line has the slope 3/5 k A^2; the integral of the motion gives 0.359 k A^2."""
    shift = np.linspace(-10, 10, 4001) * MM
    np.testing.assert_allclose(regressed_conicity(shift, 0.1 * shift, AMPLITUDES), 0.05, rtol=1e-12)
    found = regressed_conicity(shift, 100.0 * shift**3, AMPLITUDES)
    np.testing.assert_allclose(found, 30.0 * AMPLITUDES**2, rtol=1e-4)
    # sampled least squares of an uneven curve with an offset
    uneven = np.sort(np.random.default_rng(2).uniform(-9.0, 9.0, 50)) * MM
    uneven[[0, -1]] = -9.0 * MM, 9.0 * MM
    curve = np.sin(600.0 * uneven) * MM + 0.2 * MM
    y = np.linspace(-4.0, 4.0, 400001) * MM
    slope = np.polyfit(y, np.interp(y, uneven, curve), 1)[0]
    assert regressed_conicity(uneven, curve, 4.0 * MM)[0] == pytest.approx(0.5 * slope, rel=1e-4)
    assert np.isnan(regressed_conicity(uneven, curve, 9.5 * MM))[0]


def test_the_report_has_the_regression_and_the_delta_of_tan_gamma():
    report = wrcontact.check(wrcontact.ContactSystem("cone20"))
    np.testing.assert_allclose(report.conicity.regressed, 0.05, rtol=2e-3)
    delta = report.curves.delta_tan_gamma
    np.testing.assert_allclose(delta[np.abs(report.curves.lateral_shift) < 5 * MM], 0.0, atol=1e-3)
    curves = wrcontact.check(wrcontact.ContactSystem()).curves
    middle = np.abs(curves.lateral_shift) < 6 * MM
    np.testing.assert_allclose(
        curves.delta_tan_gamma[middle], -curves.delta_tan_gamma[middle][::-1], atol=1e-6
    )
    assert np.nanmax(curves.delta_tan_gamma) > 2.0  # on the flange


def test_constant_difference_thrown_over_in_the_middle():
    """delta_r = c sign(y): each quarter wave is a fall over the amplitude, sqrt(2 A / c)."""
    c, shift = 0.5 * MM, np.array([-10, -1e-9, 1e-9, 10]) * MM
    expected = np.pi**2 * c / (16 * AMPLITUDES)
    np.testing.assert_allclose(equivalent_conicity(shift, [-c, -c, c, c], AMPLITUDES), expected, rtol=1e-6)


def test_cones_with_a_clearance_between_them():
    """Nothing turns the wheelset within +-2 mm, a cone of 0.1 beyond: it crosses the
    clearance as fast as it comes."""
    free, cone = 2 * MM, 0.1
    shift = np.array([-10 * MM, -free, free, 10 * MM])
    difference = np.array([-2 * cone * (10 * MM - free), 0, 0, 2 * cone * (10 * MM - free)])
    amplitude = AMPLITUDES[3:]
    rate = math.sqrt(2 * cone)
    half = np.pi / rate + 2 * free / (rate * (amplitude - free))
    np.testing.assert_allclose(
        equivalent_conicity(shift, difference, amplitude), 0.5 * (np.pi / half) ** 2, rtol=1e-5
    )
    value, middle, reason = Swing(shift, difference).conicity(1 * MM)
    assert (value, middle, reason) == (0.0, 0.0, "")  # no wave, as on a cylinder


def test_another_left_and_right_wheel_and_a_jump():
    """Against the motion itself, step by step; the turning points are no more the same left and right."""
    shift = np.concatenate([np.linspace(-12, 3, 301), [3 + 1e-6], np.linspace(3.05, 12, 180)]) * MM
    difference = (
        0.2 * (shift - 0.7 * MM)
        + 40 * (shift - 0.7 * MM) ** 2 * np.sign(shift)
        + np.where(shift > 3.0000005 * MM, 1.5 * MM, 0.0)
    )
    for amplitude in (1 * MM, 3 * MM, 6 * MM):
        value, middle, reason = Swing(shift, difference).conicity(amplitude)
        assert reason == "" and abs(middle) > 0.1 * MM, amplitude
        half = half_wave_in_time(shift, difference, middle - amplitude)
        assert value == pytest.approx(0.5 * (np.pi / half) ** 2, rel=2e-5), amplitude


def test_swing_beside_a_middle_that_drives_out():
    """delta_r = k (y^3 / a^2 - y) rests at +-a, where it rises by 2 k: small swings
    there have tan(gamma) = k."""
    k, a = 0.05, 3 * MM
    shift = np.linspace(-10, 10, 4001) * MM
    swing = Swing(shift, k * (shift**3 / a**2 - shift))
    value, middle, _ = swing.conicity(0.05 * MM)
    assert abs(middle) == pytest.approx(a, rel=1e-3) and value == pytest.approx(k, rel=1e-3)
    # from sqrt(2) a on it swings over the middle; in between there is no swing
    assert swing.conicity(3.5 * MM)[2] == NO_RETURN
    assert swing.conicity(4.5 * MM)[1] == pytest.approx(0.0, abs=1e-9)
    assert Swing(shift, -k * shift).conicity(1 * MM)[2] == NO_RETURN
    assert Swing(shift, k * shift).conicity(11 * MM)[2] == OFF_PROFILE
    # a curve that ends within the amplitude on one side alone
    beyond = np.linspace(-1 * MM, 12 * MM, 27)
    for curve in (beyond, -beyond[::-1]):
        assert Swing(curve, 0.0 * curve).conicity(2 * MM)[2] == OFF_PROFILE


@pytest.mark.parametrize(
    "shift, difference, amplitude, told",
    [
        ([0, 1, 2], [0, 1], 1, "lateral_shift has shape (3,) and radius_difference (2,)"),
        ([0, 2, 1], [0, 1, 2], 1, "does not rise"),
        ([0, 1, 2], [0, math.nan, 2], 1, "not finite"),
        ([0, 1, 2], [0, 1, 2], 0.0, "amplitude is 0.0; permitted is amplitude > 0 m"),
    ],
)
def test_bad_curves_are_refused(shift, difference, amplitude, told):
    with pytest.raises(ValueError) as refusal:
        equivalent_conicity(shift, difference, amplitude)
    assert told in str(refusal.value)


# --- equivalent conicity of pairs -----------------------------------------------------------------


def test_reference_value_of_the_standard(standard):
    """EN 15302: S1002 on 60E1 1:40, gauge 1435 mm, without roll, at 3 mm."""
    assert standard.conicity.level[2] == pytest.approx(0.174, abs=0.003)


def test_conicity_from_a_search_of_its_own(standard):
    """S1002 and 60E1 as printed, each side's smallest vertical gap of a level wheelset on a
    grid, and the motion itself."""
    track = brute_force.track("60E1", 1 / 40)
    y = np.arange(-36, 26, 0.01) * MM
    height = track.wheel(y)[0]
    shift = np.arange(-6, 6.01, 0.02) * MM
    ground = np.arange(-60, 60, 0.005) * MM
    head = track.rail(ground)[0]
    at = [
        np.argmin(np.interp(track.half_distance + y + one - track.rail_origin, ground, head) - height)
        for one in shift
    ]
    difference = height[at] - height[at][::-1]
    # a contact is found to 5 um, on treads of slope 0.1: 0.5 um of 0.5 mm, averaged over a swing
    for amplitude in (2, 3, 5):
        half = half_wave_in_time(shift, difference, -amplitude * MM)
        expected = 0.5 * (np.pi / half) ** 2
        assert standard.conicity.level[amplitude - 1] == pytest.approx(expected, rel=2e-3), amplitude


def test_wavelength_is_klingels(standard):
    conicity = standard.conicity
    klingel = 2 * np.pi * np.sqrt(1.5 * 0.46 / (2 * conicity.level))
    np.testing.assert_allclose(conicity.wavelength, klingel, rtol=1e-12)
    assert conicity.nonlinearity == pytest.approx((conicity.level[3] - conicity.level[1]) / 2e-3)


def cone_wheel(slope):
    return Profile("cone", "wheel", (Polynomial(-70, 60, (0.0, -slope)),))


@pytest.mark.parametrize("rail", ["UIC60", "54E1"])
def test_conical_wheel_has_its_cone(rail):
    """Without roll a cone keeps touching the same place of the rail.

    With roll, slope / arm of the shift, the place moves on the head, R 300 mm here, and the wheel turns about
    its axle: by (R + r0) slope / arm in all, which makes the cone look steeper.
    """
    report = wrcontact.check(ContactSystem(wheel=cone_wheel(0.05), rail=rail))
    np.testing.assert_allclose(report.conicity.level, 0.05, rtol=1e-6)
    steeper = 0.05 / (1.0 - 0.05 * (0.30 + 0.46) / 0.75)
    # slopes squared, and the arm to the contact
    np.testing.assert_allclose(report.conicity.rolled, steeper, rtol=2e-3)
    assert report.jumps == () and report.nearest_jump == math.inf and report.flange_shift == math.inf
    assert report.usable and not any("jump" in remark for remark in report.remarks)


#: Radii [m] of a hollow wheel on a rail head, both of one arc, and the slope at which they touch in
#: the centred position.
HOLLOW, HEAD, SLOPE = 0.33, 0.30, 0.05


@pytest.fixture(scope="module")
def arcs():
    """The check of arc on arc, for which a level wheelset has closed forms."""
    sine = SLOPE / math.hypot(1.0, SLOPE)
    y_centre = 1e3 * HOLLOW * sine
    wheel = Profile(
        "hollow",
        "wheel",
        (Arc(-45, 45, 1e3 * HOLLOW, y_centre, math.sqrt(1e6 * HOLLOW**2 - y_centre**2), -1),),
    )
    rail = Profile("head", "rail", (Arc(-68, 68, 1e3 * HEAD, 0.0, 1e3 * HEAD, -1),))
    depth = 5e-3
    # the rail's place of that slope lies under the running circle
    top = 0.75 + HEAD * sine
    gauge = 2 * (top - math.sqrt(HEAD**2 - (HEAD - depth) ** 2))
    return wrcontact.check(ContactSystem(wheel, rail, rail_inclination=0.0, gauge=gauge, gauge_depth=depth))


def test_arc_on_arc_has_its_closed_form(arcs):
    """tan(gamma) = slope R_w / (R_w - R_r) for small amplitudes, and the curve rises
    with y as the slope does."""
    value = equivalent_conicity(*arcs.conicity_curves["level"], [0.1 * MM])[0]
    # the slope's square counts for 1 %
    assert value == pytest.approx(SLOPE * HOLLOW / (HOLLOW - HEAD), rel=0.02)
    assert value == pytest.approx(0.55, rel=0.02)


def test_moves_on_arcs(arcs):
    """Of a level wheelset the places of equal slope move by R_w / (R_w - R_r) = 11 per shift on the wheel, by
    R_r / (R_w - R_r) on the rail; roll turns the wheel against the rail, as a shift
    of (R_r + r0) roll does."""
    middle = len(arcs.curves.lateral_shift) // 2
    side = arcs.curves.right
    assert side.y_wheel[middle] == pytest.approx(0.0, abs=1e-6)
    assert side.contact_angle[middle] == pytest.approx(SLOPE, rel=1e-2)
    assert side.wheel_rate[middle] - side.rail_rate[middle] == pytest.approx(-1.0, abs=0.05)
    turned = arcs.curves.roll_rate[middle]
    wheel = -HOLLOW / (HOLLOW - HEAD) * (1.0 - (HEAD + 0.46) * turned)
    assert side.wheel_rate[middle] == pytest.approx(wheel, rel=0.02)


def test_near_stretch_of_arcs(arcs):
    """The gap of two arcs is s^2 / 2 (1 / R_r - 1 / R_w): within NEAR over 2 sqrt(2 NEAR / (1
    / R_r - 1 / R_w)) = 51 mm."""
    middle = len(arcs.curves.lateral_shift) // 2
    curvature = 1 / HEAD - 1 / HOLLOW
    width = 2 * math.sqrt(2 * NEAR / curvature)
    assert arcs.curves.right.curvature[middle] == pytest.approx(curvature, rel=1e-2)
    assert arcs.curves.right.near_width[middle] == pytest.approx(width, rel=0.01)
    # between chords of 1 mm
    assert arcs.curves.right.near_turn[middle] == pytest.approx((width - MM) / HOLLOW, rel=0.02)
    assert any(zone.start < 0.0 < zone.stop and zone.width >= 0.99 * width for zone in arcs.conformal)
