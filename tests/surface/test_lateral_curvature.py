"""Lateral curvatures of profiles and their tables, against circles, scipy's fits and chords."""

import numpy as np
import pytest
from scipy.optimize import least_squares

import wrcontact
from tests.helpers.inside import tables_of
from tests.helpers.numpy_curvatures import fitted_curvature, smooth_curvature_table, turned_curvature
from tests.helpers.numpy_profiles import compile_profile
from tests.helpers.separations import PLACES
from wrcontact.kernel import layout
from wrcontact.methods import CHOICES
from wrcontact.profiles.catalogue import RAILS
from wrcontact.profiles.placement import place_rail, readable_wheel
from wrcontact.profiles.profile import Profile
from wrcontact.profiles.zones import Arc, Polynomial


@pytest.mark.parametrize("radius, side", [(13.0, -1), (80.0, +1), (300.0, -1)])
@pytest.mark.parametrize("curvature, scales", [(fitted_curvature, (0.1e-3, 3e-3, 10e-3)),
                                               (turned_curvature, (0.02e-3, 0.2e-3, 5e-3))],
                         ids=["smooth", "rough"])
def test_curvature_of_a_circle_is_exact_up_to_its_ends(radius, side, curvature, scales):
    table = compile_profile(Profile("arc", "rail", (Arc(-9.0, 9.0, radius, 0.0, -side * radius, side),)))
    y = np.linspace(-9e-3, 9e-3, 41)
    for scale in scales:
        # heights are exact to 1e-12 m between the ends of the kernel's pieces
        np.testing.assert_allclose(curvature(table, y, scale), -side * 1e3 / radius,
                                   atol=8 * 1e-12 / scale**2 + 1e-6)


@pytest.mark.parametrize("curvature", [fitted_curvature, turned_curvature])
def test_curvature_of_a_straight_line_is_none(curvature):
    table = compile_profile(Profile("line", "rail", (Polynomial(-9.0, 9.0, (1.0, 0.4)),)))
    np.testing.assert_allclose(curvature(table, np.linspace(-9e-3, 9e-3, 41), 1e-3), 0.0, atol=1e-8)


@pytest.mark.parametrize("parameters", [dict(curvature_step=5e-3), dict(curvature_step=0.02e-3),
                                        dict(curvature_reach=10e-3), dict(curvature_reach=0.1e-3)], ids=str)
@pytest.mark.parametrize("rail", RAILS)
def test_tables_hold_numbers_at_every_scale(rail, parameters):
    kind = "rough" if "curvature_step" in parameters else "smooth"
    system = wrcontact.ContactSystem(rail=rail, lateral_curvature=kind, **parameters)
    for setting, end in ((layout.SET_WHEEL_CURVATURE, layout.SET_RAIL_CURVATURE),
                         (layout.SET_RAIL_CURVATURE, layout.SET_RAIL_ARC)):
        start = int(tables_of(system)[setting])
        table = tables_of(system)[start:int(tables_of(system)[end])]
        assert np.all(np.isfinite(table)) and np.abs(table[3:]).max() < 2000.0
    state = system.evaluate_many(np.linspace(-6.5e-3, 6.5e-3, 41), normal_force=5e4)
    assert np.all(state.status == 0) and np.all(np.isfinite(state.values))


def profiles(system):
    """Wheel and inclined rail as the standards define them; by kind."""
    chosen = system.parameters
    placed = place_rail(system.rail, inclination=chosen["rail_inclination"], gauge=chosen["gauge"],
                        gauge_depth=chosen["gauge_depth"])
    return readable_wheel(system.wheel), placed.profile


def orthogonal_fit(profile, y, reach):
    """Curvature of the circle with the smallest sum of squared distances to the profile over y +- reach."""
    at = np.linspace(max(y - reach, profile.start), min(y + reach, profile.stop), 201)
    points = np.stack([at - y, profile.height(at) - profile.height(y)]) / reach

    def distances(unknown):
        a, b, c = unknown      # offset, angle and curvature; no division where it is straight
        u = points[0] * np.cos(b) + points[1] * np.sin(b)
        v = points[1] * np.cos(b) - points[0] * np.sin(b) - a
        square = c * (u**2 + v**2)
        return 2 * (0.5 * square - v) / (1 + np.sqrt(np.maximum(1 + c * (square - 2 * v), 0.0)))

    found = least_squares(distances, [0.0, np.arctan(profile.slope(y)), profile.curvature(y) * reach],
                          xtol=1e-14, ftol=1e-14)
    return found.x[2] / reach


def chord_angles(profile, y, step):
    """Angle from chord to chord per arc, on a polyline of 1e-8 m."""
    at = np.arange(y - 1.1 * step, y + 1.1 * step, 1e-8)
    z = profile.height(at)
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(at), np.diff(z)))])
    middle = np.interp(y, at, arc)
    nodes = np.interp(middle + step * np.array([-1, 0, 1]), arc, at)
    heights = profile.height(nodes)
    return np.diff(np.arctan2(np.diff(heights), np.diff(nodes)))[0] / step


@pytest.mark.parametrize("place", list(PLACES))
@pytest.mark.parametrize("kind, witness, scale, error", [
    # algebraic and geometric distance part where the profile is no circle
    ("smooth", orthogonal_fit, 3e-3, 0.02), ("smooth", orthogonal_fit, 0.5e-3, 0.002),
    ("rough", chord_angles, 0.2e-3, 1e-3), ("rough", chord_angles, 0.7e-3, 1e-4)])
def test_curvature_at_the_contact_against_its_definition(place, kind, witness, scale, error):
    system = wrcontact.ContactSystem(lateral_curvature=kind, curvature_step=scale,
                                     curvature_reach=max(scale, 0.1e-3))
    side = system.evaluate(PLACES[place]).right
    wheel, rail = profiles(system)
    expected = witness(rail, side.contact.y_rail, scale) - witness(wheel, side.contact.y_wheel, scale)
    assert side.curvature_y == pytest.approx(expected, rel=error, abs=0.02)


@pytest.mark.parametrize("kind", ["smooth", "rough"])
def test_curvature_of_a_small_scale_is_the_profile_s_own(kind):
    system = wrcontact.ContactSystem(lateral_curvature=kind, curvature_step=0.02e-3, curvature_reach=0.1e-3)
    own = wrcontact.ContactSystem()
    for place in ("root", "flange"):
        found, wanted = (one.evaluate(PLACES[place]).right.curvature_y for one in (system, own))
        assert found == pytest.approx(wanted, rel=1e-3)


def test_hertz_takes_the_chosen_lateral_curvature():
    sides = [wrcontact.ContactSystem(normal_model="hertz", lateral_curvature=kind).evaluate(1e-3).right
             for kind in CHOICES["lateral_curvature"]]
    assert sides[1].curvature_y < 0.8 * sides[0].curvature_y and sides[1].area > 1.1 * sides[0].area
    assert sides[2].curvature_y == pytest.approx(sides[0].curvature_y, rel=1e-3)


def test_rough_and_smooth_are_what_the_source_shows():
    """Sections 7.2 and 7.3 of the source: at 1 mm the rough curvature of wheel and rail together jumps within
    the patch, even below zero, and the smooth one does not."""
    system = wrcontact.ContactSystem()
    tables = tables_of(system)
    wheel, rail = (tables[int(tables[a]):int(tables[b])] for a, b in ((layout.SET_WHEEL, layout.SET_RAIL),
                                                                       (layout.SET_RAIL, layout.SET_SCAN)))
    contact = system.evaluate(1e-3).right.contact
    s = np.linspace(-7e-3, 7e-3, 281)
    rough, smooth = (curvature(rail, contact.y_rail + s, scale) - curvature(wheel, contact.y_wheel + s, scale)
                     for curvature, scale in ((turned_curvature, 0.2e-3), (fitted_curvature, 3e-3)))
    assert np.abs(np.diff(rough)).max() > 5 * np.abs(np.diff(smooth)).max()
    assert rough.min() < 0.0


def test_the_table_s_sign_is_that_of_a_bulge():
    table = compile_profile(Profile("arc", "wheel", (Arc(-9.0, 9.0, 80.0, 0.0, -80.0, +1),)))
    np.testing.assert_allclose(smooth_curvature_table(table, -1.0, 1e-3)[3:], 12.5, rtol=1e-5)
