"""How ANALYN's inputs are prepared: separations and lateral curvatures against profiles, arcs and
chords computed apart."""

import numpy as np
import pytest
from scipy.integrate import quad

import wrcontact
from tests.helpers.separations import EVERY_PLACE, PLACES, SHARE_OF_PLACES, STATIONS, Contact
from wrcontact.kernel import layout
from wrcontact.kernel.contact import curves, traces
from wrcontact.kernel.contact.frame import NO_GAP
from wrcontact.kernel.layout import RAIL, WHEEL
from wrcontact.methods import CHOICES, NUMBERS
from wrcontact.profiles.profile import Profile
from wrcontact.profiles.zones import Arc

# --- separations ----------------------------------------------------------------------------------


@SHARE_OF_PLACES
@pytest.mark.parametrize("side", [1, -1], ids=["field", "flange"])
def test_separations_are_what_they_say(shift, yaw, side):
    contact = Contact(shift, yaw)
    stations = side * STATIONS
    # the wheel's point is found to 1e-6 m, which counts where its curvature jumps, and the rail's arcs come
    # from a table: together less than 0.01 % of the gap
    np.testing.assert_allclose(
        contact.kernel("normal", stations)[0], [contact.normal(s) for s in stations], atol=4e-11, rtol=1e-4
    )
    # places are met to 1e-13 m, but a yawed outline's length is known by differences only
    np.testing.assert_allclose(
        contact.kernel("vertical", stations)[0], [contact.vertical(s) for s in stations], atol=2e-13
    )
    np.testing.assert_allclose(
        contact.kernel("equidistant", stations)[0],
        [contact.equidistant(s) for s in stations],
        atol=2e-13 if yaw == 0.0 else 1e-12,
    )
    spacing = side * 0.2e-3
    np.testing.assert_allclose(
        contact.kernel("equidistant_chord", spacing * np.array([1, 2, 5]), abs(spacing))[0],
        [contact.chords(count, spacing) for count in (1, 2, 5)],
        atol=2e-13,
    )


@EVERY_PLACE
@pytest.mark.parametrize("kind", ["vertical", "equidistant"])
def test_rate_and_bend_are_the_gap_s_derivatives(shift, yaw, kind):
    contact = Contact(shift, yaw)
    step = 1e-5
    for station in (-0.83e-3, 0.41e-3, 1.37e-3):
        gap, rate, bend, _ = contact.kernel(kind, station + step * np.array([-2, -1, 0, 1, 2]))
        difference = (8 * (gap[3] - gap[1]) - (gap[4] - gap[0])) / (12 * step)
        assert rate[2] == pytest.approx(difference, abs=1e-7, rel=1e-6)
        # the equidistant bend leaves terms out that are of second order in the station
        assert bend[2] == pytest.approx((rate[3] - rate[1]) / (2 * step), rel=1e-2, abs=1.0)


@pytest.mark.parametrize("kind", ["vertical", "equidistant", "equidistant_chord"])
@EVERY_PLACE
def test_wheel_s_longitudinal_curvature_is_read_where_the_node_is(shift, yaw, kind):
    contact = Contact(shift, yaw)
    exact = contact.kernel("normal", [0.0, 0.5e-3])[3]
    found = contact.kernel(kind, [0.0, 0.5e-3], 0.5e-3)[3]
    assert found[0] == pytest.approx(exact[0], rel=1e-12) and found[1] == pytest.approx(exact[1], rel=0.1)


@pytest.mark.parametrize("place", ["tread", "flange"])
def test_arc_length_is_that_of_the_exact_profile(place):
    """The kernel's arc against the zones as the standard prints them, away from the
    joints that are evened out."""
    contact = Contact(PLACES[place])
    pair, work = layout.Tables.at(contact.tables).pairs[1], layout.Work.at(contact.work)
    wheel = contact.system.wheel
    for length in (0.4e-3, -0.8e-3):
        traces.start_traces(work.contact.frame, 0.0, contact.u_rail, contact.u_wheel)
        assert curves.move_arc(pair, work.contact.frame, work.contact.origin, WHEEL, length) == 1
        found = quad(
            lambda u: np.hypot(1.0, wheel.slope(u)),
            contact.u_wheel,
            work.contact.frame.traces[WHEEL].abscissa,
            epsabs=1e-15,
        )[0]
        assert found == pytest.approx(length, abs=1e-12)


def test_a_chord_is_shorter_than_its_arc_by_the_cube():
    """On a circle k chords of h span the angle 2 k asin(h / 2R): too long an arc by k h^3 / 24 R^2."""
    radius, contact = 80e-3, Contact(0.0)
    u = 6e-3  # on the rail's shoulder
    errors = []
    for count in (4, 8, 16):
        spacing = 4e-3 / count
        pair, work = layout.Tables.at(contact.tables).pairs[1], layout.Work.at(contact.work.copy())
        work.contact.frame.traces[RAIL].abscissa = u
        for _ in range(count):
            assert curves.move_chord(pair, work.contact.frame, work.contact.origin, RAIL, spacing) == 1
        arc = contact.rail.arc(u, work.contact.frame.traces[RAIL].abscissa)
        assert arc == pytest.approx(2 * count * radius * np.arcsin(spacing / (2 * radius)), abs=1e-12)
        errors.append(arc - 4e-3)
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=1e-3)
    assert errors[1] / errors[2] == pytest.approx(4.0, rel=1e-3)


def test_chord_steps_approach_true_arc_length_with_the_square_of_the_spacing():
    contact = Contact(PLACES["root"])
    station = 1.2e-3
    exact = contact.kernel("equidistant", [station])[0, 0]
    errors = [
        contact.kernel("equidistant_chord", station / count * np.arange(1, count + 1), station / count)[0, -1]
        - exact
        for count in (3, 6, 12)
    ]
    assert abs(errors[0]) > 1e-12
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.1)
    assert errors[1] / errors[2] == pytest.approx(4.0, rel=0.1)


@pytest.mark.parametrize("place", list(PLACES))
def test_vertical_is_normal_over_the_cosine_near_the_contact(place):
    contact = Contact(PLACES[place], force=1.0)  # just touching: a depth turns with the rail's normal
    stations = np.array([0.2e-3, 0.1e-3, 0.05e-3])
    ratio = contact.kernel("vertical", stations)[0] / contact.kernel("normal", stations)[0]
    errors = ratio * np.cos(contact.angle) - 1
    assert np.abs(errors[-1]) < 0.02
    if place != "tread":
        np.testing.assert_allclose(errors[:-1] / errors[1:], 2.0, rtol=0.1)  # of first order in s


def test_equidistant_is_normal_to_fourth_order():
    contact = Contact(PLACES["root"], force=1e-3)  # just touching: a depth turns with the rail's normal
    stations = np.array([0.8e-3, 0.4e-3, 0.2e-3])
    errors = contact.kernel("equidistant", stations)[0] - [contact.normal(station) for station in stations]
    np.testing.assert_allclose(errors[:-1] / errors[1:], 16.0, rtol=0.2)
    assert abs(errors[0]) < 5e-3 * contact.kernel("normal", stations)[0, 0]


def test_beyond_the_end_of_a_profile_there_is_no_separation():
    contact = Contact(PLACES["tread"])
    for kind in NUMBERS["separation"]:
        gap = contact.kernel(kind, np.arange(1, 101) * 1e-3, 1e-3)[0]
        assert gap[0] < NO_GAP <= gap[-1] and np.all(np.isfinite(gap))


def circles(wheel_radius=0.3, rail_radius=0.2, **parameters):
    """Two circles in place of profiles, in contact at their tops, the rail upright."""
    wheel = Profile("ball", "wheel", (Arc(-60.0, 60.0, 1e3 * wheel_radius, 0.0, -1e3 * wheel_radius, +1),))
    rail = Profile("crown", "rail", (Arc(-70.0, 70.0, 1e3 * rail_radius, 0.0, 1e3 * rail_radius, -1),))
    return dict(
        wheel=wheel,
        rail=rail,
        rail_inclination=0.0,
        gauge=1.5 - 2 * np.sqrt(0.2**2 - 0.19**2),
        gauge_depth=0.01,
        **parameters,
    )


@pytest.mark.parametrize("kind", list(NUMBERS["separation"]))
@pytest.mark.parametrize("lateral", CHOICES["lateral_curvature"])
def test_two_circles_are_hertz(kind, lateral):
    """On an untilted contact; what is left are the terms of fourth order in the gap, (width / radius)^2."""
    given = circles(separation=kind, lateral_curvature=lateral)
    force = 2e3
    analyn = wrcontact.ContactSystem(**given, nodes=38).evaluate(normal_force=force).right
    hertz = wrcontact.ContactSystem(**given, normal_model="hertz").evaluate(normal_force=force).right
    assert analyn.contact_angle == pytest.approx(0.0, abs=1e-9)
    assert hertz.curvature_y == pytest.approx(1 / 0.3 + 1 / 0.2, rel=1e-6)
    assert hertz.curvature_x == pytest.approx(1 / 0.46, rel=1e-9)
    for name in ("penetration", "area", "max_pressure", "patch_length", "patch_width"):
        assert getattr(analyn, name) == pytest.approx(getattr(hertz, name), rel=2e-4), name


# --- what depends on what -------------------------------------------------------------------------


RIGID = list(range(layout.SIDE_X_WHEEL, layout.SIDE_CURVATURE_X))
COLUMNS = {
    name: [side + k for side in (layout.OUT_LEFT, layout.OUT_RIGHT) for k in slots]
    for name, slots in (
        ("rigid", RIGID),
        ("curvature_x", [layout.SIDE_CURVATURE_X]),
        ("curvature_y", [layout.SIDE_CURVATURE_Y]),
        ("penetration", [layout.SIDE_PENETRATION]),
    )
}
COLUMNS["rigid"] = [layout.OUT_ROLL, layout.OUT_VERTICAL_SHIFT, *COLUMNS["rigid"]]


@pytest.mark.parametrize(
    "changed, unchanged, moved",
    [
        (dict(separation="vertical"), ("rigid", "curvature_x", "curvature_y"), "penetration"),
        (dict(separation="equidistant"), ("rigid", "curvature_x", "curvature_y"), "penetration"),
        (dict(separation="equidistant_chord"), ("rigid", "curvature_x", "curvature_y"), "penetration"),
        (dict(lateral_curvature="smooth"), ("rigid", "curvature_x"), "curvature_y"),
        (dict(lateral_curvature="rough"), ("rigid", "curvature_x"), "curvature_y"),
        (dict(longitudinal_curvature="basic"), ("rigid", "curvature_y"), "curvature_x"),
        (dict(curvature_step=1e-3, curvature_reach=1e-3), tuple(COLUMNS), None),
        (dict(lateral_curvature="smooth", curvature_step=1e-3), tuple(COLUMNS), None),
    ],
    ids=str,
)
def test_a_choice_changes_what_it_should_and_nothing_else(changed, unchanged, moved):
    plain = (
        {"lateral_curvature": changed["lateral_curvature"]}
        if moved is None and "lateral_curvature" in changed
        else {}
    )
    poses = dict(lateral_shift=np.linspace(-7e-3, 7e-3, 29), yaw=np.tile([0.0, 0.02], 15)[:29])
    before, after = (
        wrcontact.ContactSystem(**given).evaluate_many(**poses).values for given in (plain, changed)
    )
    for name in unchanged:
        np.testing.assert_array_equal(after[:, COLUMNS[name]], before[:, COLUMNS[name]], err_msg=name)
    if moved:
        assert np.mean(after[:, COLUMNS[moved]] != before[:, COLUMNS[moved]]) > 0.9


def test_a_steep_side_leaves_no_hole_in_the_vertical_distance():
    """A cubic over four nodes to the rail's side fell below zero here, and no force was met. The vertical
    distance is larger than the normal one, and the wheel sinks deeper under its load, by 5 % (measured)."""
    shift = np.linspace(6.2e-3, 6.225e-3, 6)
    normal, vertical = (
        wrcontact.ContactSystem(separation=kind).evaluate_many(shift, np.radians(-0.5))
        for kind in ("normal", "vertical")
    )
    assert np.all(vertical.status == 0)
    ratio = vertical.right.penetration / normal.right.penetration
    assert np.all((ratio > 1.0) & (ratio < 1.1))


@pytest.mark.parametrize("place", list(PLACES))
def test_tread_hardly_notices_and_a_flange_does(place):
    """The source's finding of its section 7.1, and what it does not say: on a flange the vertical distance is
    the normal one over the cosine, so that the patch is too narrow."""
    areas = {
        kind: wrcontact.ContactSystem(separation=kind, nodes=38).evaluate(PLACES[place]).right.area
        for kind in NUMBERS["separation"]
    }
    assert areas["equidistant"] == pytest.approx(areas["normal"], rel=0.02)
    assert areas["equidistant_chord"] == pytest.approx(areas["equidistant"], rel=2e-3)
    low, high = {"tread": (0.99, 1.01), "root": (0.85, 0.97), "flange": (0.5, 0.75)}[place]
    assert low < areas["vertical"] / areas["normal"] < high
