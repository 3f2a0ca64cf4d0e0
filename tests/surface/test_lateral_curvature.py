"""Lateral curvatures of profiles and their tables, against circles, scipy's fits and chords."""

import numpy as np
import pytest
from scipy.optimize import least_squares

import wrcontact
from tests.helpers.inside import lateral_curvatures
from tests.helpers.separations import PLACES, Curve
from wrcontact.kernel import layout
from wrcontact.methods import CHOICES
from wrcontact.profiles.catalogue import RAILS
from wrcontact.profiles.compiled import evaluate_table
from wrcontact.profiles.placement import place_rail, readable_wheel
from wrcontact.profiles.profile import Profile
from wrcontact.profiles.zones import Arc

SCALES = {"smooth": (0.1e-3, 3e-3, 10e-3), "rough": (0.02e-3, 0.2e-3, 5e-3)}


def system_of(kind, scale, **given):
    return wrcontact.ContactSystem(
        lateral_curvature=kind,
        **{"curvature_reach" if kind == "smooth" else "curvature_step": scale},
        **given,
    )


@pytest.mark.parametrize("radius, reach", [(13.0, 11.7), (80.0, 36.0), (300.0, 60.0)])
@pytest.mark.parametrize("kind, scale", [(kind, scale) for kind in SCALES for scale in SCALES[kind]])
def test_curvature_of_a_circle_is_exact_up_to_its_ends(radius, reach, kind, scale):
    """And that of a cone is none; both are positive where the profile bulges."""
    head = Profile("head", "rail", (Arc(-reach, reach, radius, 0.0, radius, -1),))
    ball = Profile("ball", "wheel", (Arc(-reach, reach, radius, 0.0, -radius, +1),))
    for wheel, curvature in ((ball, 1e3 / radius), ("cone40", 0.0)):
        system = system_of(kind, scale, wheel=wheel, rail=head, rail_inclination=0.0, gauge_depth=5e-3)
        # heights are exact to 1e-12 m between the ends of the kernel's pieces
        near = 8 * 1e-12 / scale**2 + 1e-6
        np.testing.assert_allclose(lateral_curvatures(system, "rail")[1], 1e3 / radius, atol=near)
        np.testing.assert_allclose(lateral_curvatures(system, "wheel")[1], curvature, atol=near)


def fitted(table, y, reach):
    """Curvature [1/m] of the circle fitted to a compiled profile over y +- reach, of which only what is there
    counts: least squares of the algebraic distance, in axes along the tangent. With u along and v across,
    c (u^2 + v^2) + b u + a = v, whose curvature is 2 c / sqrt(1 + b^2 - 4 a c)."""
    start, stop = layout.Profile.at(table).start, layout.Profile.at(table).stop
    at = np.linspace(max(y - reach, start), min(y + reach, stop), 61)
    height, slope, _ = evaluate_table(table, y)
    across, down, along = at - y, evaluate_table(table, at)[0] - height, np.hypot(1.0, slope)
    u, v = (across + down * slope) / (along * reach), (down - across * slope) / (along * reach)
    a, b, c = np.linalg.lstsq(np.stack([np.ones(61), u, u**2 + v**2], axis=1), v)[0]
    return 2 * c / np.sqrt(1 + b**2 - 4 * a * c) / reach


def turned(table, y, step):
    """Change of a compiled profile's angle per arc length [1/m], from chord to chord between nodes ``step``
    [m] of arc before ``y``, at y and after it; beside an end the three are moved inward. The source's rough
    one, eq. (6.3), writes to node n what nodes n, n + 1 and n + 2 give; here it stands at the middle one."""
    curve, head = Curve(table), layout.Profile.at(table)
    if curve.arc(head.start, y) < step:
        nodes = [curve.at_arc(head.start, k * step) if k else head.start for k in range(3)]
    elif curve.arc(y, head.stop) < step:
        nodes = [curve.at_arc(head.stop, -k * step) if k else head.stop for k in (2, 1, 0)]
    else:
        nodes = [curve.at_arc(y, -step), y, curve.at_arc(y, step)]
    angles = np.arctan2(np.diff(evaluate_table(table, nodes)[0]), np.diff(nodes))
    return np.diff(angles)[0] / step


@pytest.mark.parametrize(
    "kind, witness, scale",
    [
        ("smooth", fitted, 3e-3),
        ("smooth", fitted, 0.5e-3),
        ("rough", turned, 0.2e-3),
        ("rough", turned, 0.7e-3),
    ],
)
@pytest.mark.parametrize("body, sign", [("wheel", -1), ("rail", 1)])
def test_tables_hold_what_the_source_says(kind, witness, scale, body, sign):
    """At a share of their places, the ends among them."""
    system = system_of(kind, scale)
    table = system.profile_tables()[body == "rail"]
    places, found = lateral_curvatures(system, body)
    head = layout.Profile.at(table)
    assert places[-1] == pytest.approx(head.stop, abs=1e-15) and places[0] == head.start
    assert np.diff(places).max() <= np.clip(0.25 * scale, 0.01e-3, 0.05e-3) * (1 + 1e-9)
    some = np.unique([*range(0, len(places), 41), 1, 2, len(places) - 2, len(places) - 1])
    wanted = [sign * witness(table, np.clip(y, head.start, head.stop), scale) for y in places[some]]
    # chords between points that are exact to 1e-17 m
    np.testing.assert_allclose(found[some], wanted, rtol=1e-9, atol=1e-8)


@pytest.mark.parametrize(
    "parameters",
    [
        dict(curvature_step=5e-3),
        dict(curvature_step=0.02e-3),
        dict(curvature_reach=10e-3),
        dict(curvature_reach=0.1e-3),
    ],
    ids=str,
)
@pytest.mark.parametrize("rail", RAILS)
def test_tables_hold_numbers_at_every_scale(rail, parameters):
    kind = "rough" if "curvature_step" in parameters else "smooth"
    system = wrcontact.ContactSystem(rail=rail, lateral_curvature=kind, **parameters)
    for body in ("wheel", "rail"):
        found = lateral_curvatures(system, body)[1]
        assert np.all(np.isfinite(found)) and np.abs(found).max() < 2000.0
    state = system.evaluate_many(np.linspace(-6.5e-3, 6.5e-3, 41), normal_force=5e4)
    assert np.all(state.status == 0) and np.all(np.isfinite(state.values))


def profiles(system):
    """Wheel and inclined rail as the standards define them; by kind."""
    chosen = system.parameters
    placed = place_rail(
        system.rail,
        inclination=chosen["rail_inclination"],
        gauge=chosen["gauge"],
        gauge_depth=chosen["gauge_depth"],
    )
    return readable_wheel(system.wheel), placed.profile


def orthogonal_fit(profile, y, reach):
    """Curvature of the circle with the smallest sum of squared distances to the profile over y +- reach."""
    at = np.linspace(max(y - reach, profile.start), min(y + reach, profile.stop), 201)
    points = np.stack([at - y, profile.height(at) - profile.height(y)]) / reach

    def distances(unknown):
        a, b, c = unknown  # offset, angle and curvature; no division where it is straight
        u = points[0] * np.cos(b) + points[1] * np.sin(b)
        v = points[1] * np.cos(b) - points[0] * np.sin(b) - a
        square = c * (u**2 + v**2)
        return 2 * (0.5 * square - v) / (1 + np.sqrt(np.maximum(1 + c * (square - 2 * v), 0.0)))

    found = least_squares(
        distances, [0.0, np.arctan(profile.slope(y)), profile.curvature(y) * reach], xtol=1e-14, ftol=1e-14
    )
    return found.x[2] / reach


@pytest.mark.parametrize("place", list(PLACES))
@pytest.mark.parametrize("scale, error", [(3e-3, 0.02), (0.5e-3, 0.002)])
def test_curvature_at_the_contact_is_that_of_a_fitted_circle(place, scale, error):
    """Algebraic and geometric distance part where the profile is no circle."""
    system = system_of("smooth", scale)
    side = system.evaluate(PLACES[place]).right
    wheel, rail = profiles(system)
    expected = orthogonal_fit(rail, side.contact.y_rail, scale) - orthogonal_fit(
        wheel, side.contact.y_wheel, scale
    )
    assert side.curvature_y == pytest.approx(expected, rel=error, abs=0.02)


@pytest.mark.parametrize("kind", ["smooth", "rough"])
def test_curvature_of_a_small_scale_is_the_profile_s_own(kind):
    system = wrcontact.ContactSystem(lateral_curvature=kind, curvature_step=0.02e-3, curvature_reach=0.1e-3)
    own = wrcontact.ContactSystem()
    for place in ("root", "flange"):
        found, wanted = (one.evaluate(PLACES[place]).right.curvature_y for one in (system, own))
        assert found == pytest.approx(wanted, rel=1e-3)


def test_hertz_takes_the_chosen_lateral_curvature():
    sides = [
        wrcontact.ContactSystem(normal_model="hertz", lateral_curvature=kind).evaluate(1e-3).right
        for kind in CHOICES["lateral_curvature"]
    ]
    assert sides[1].curvature_y < 0.8 * sides[0].curvature_y and sides[1].area > 1.1 * sides[0].area
    assert sides[2].curvature_y == pytest.approx(sides[0].curvature_y, rel=1e-3)


def test_rough_and_smooth_are_what_the_source_shows():
    """Sections 7.2 and 7.3 of the source: at 1 mm the rough curvature of wheel and rail together jumps within
    the patch, even below zero, and the smooth one does not."""
    contact = wrcontact.ContactSystem().evaluate(1e-3).right.contact
    s = np.linspace(-7e-3, 7e-3, 281)
    rough, smooth = (
        sum(
            np.interp(place + s, *lateral_curvatures(system, body))
            for body, place in (("wheel", contact.y_wheel), ("rail", contact.y_rail))
        )
        for system in (system_of("rough", 0.2e-3), system_of("smooth", 3e-3))
    )
    assert np.abs(np.diff(rough)).max() > 5 * np.abs(np.diff(smooth)).max()
    assert rough.min() < 0.0
