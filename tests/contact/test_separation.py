"""How ANALYN's inputs are prepared: separations and lateral curvatures against profiles, arcs and chords computed apart."""

import itertools

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq, least_squares

from tests.helpers.numpy_profiles import compile_profile
import wrcontact
from tests.helpers.numpy_curvatures import fitted_curvature, smooth_curvature_table, turned_curvature
from wrcontact.kernel import layout
from wrcontact.kernel.contact import contact_plane, separation
from wrcontact.kernel.surface import profile_table
from wrcontact.profiles.catalogue import RAILS
from wrcontact.profiles.compiled import evaluate_table
from wrcontact.profiles.placement import place_rail, readable_wheel
from wrcontact.profiles.profile import Profile
from wrcontact.profiles.zones import Arc, Polynomial
from wrcontact.methods import CHOICES, NUMBERS

PLACES = {"tread": 1e-3, "root": 6e-3, "flange": 6.5e-3}
YAWS = {"no_yaw": 0.0, "yaw": 0.03, "yaw_back": -0.02}
EVERY_PLACE = pytest.mark.parametrize("shift, yaw", [pytest.param(shift, yaw, id=f"{place}-{turned}")
                                                     for place, shift in PLACES.items() for turned, yaw in YAWS.items()])


class Curve:
    """A curve across the track: ``point(u)`` and ``angle(u)`` of its tangent over a profile's abscissa u, its pieces' ends."""

    def __init__(self, table):
        self.table = table
        pieces = table[int(table[profile_table.PIECE_OFFSET]):].reshape(-1, profile_table.PIECE_SIZE)
        self.ends = pieces[1:-1, 0]
        self.error = 1e-14      # of arc lengths [m]

    def point(self, u):
        return np.array([u, evaluate_table(self.table, u)[0]])

    def angle(self, u):
        return np.arctan(evaluate_table(self.table, u)[1])

    def speed(self, u):
        return 1 / np.cos(self.angle(u))

    def arc(self, start, stop):
        """Arc length by scipy's adaptive quadrature, broken where the curvature may jump."""
        inside = np.sort([u for u in self.ends if min(start, stop) < u < max(start, stop)])
        edges = [start, *(inside if stop > start else inside[::-1]), stop]
        return sum(quad(self.speed, a, b, epsabs=self.error, epsrel=0.0)[0] for a, b in zip(edges[:-1], edges[1:]))

    def at_arc(self, start, length):
        return self._root(lambda u: self.arc(start, u) - length, start, length)

    def at_chord(self, start, chord):
        """Abscissa where a circle of radius abs(chord) around the point at ``start`` cuts the curve."""
        middle = self.point(start)
        return self._root(lambda u: np.hypot(*(self.point(u) - middle)) - abs(chord), start, chord)

    def _root(self, function, start, length):
        return brentq(function, start, start + 1.2 * length, xtol=1e-16, rtol=8.9e-16)


class Outline(Curve):
    """The wheel's outline, seen along the track: of each circle around the axle the point whose normal has no x part.

    That point is found numerically, with the wheelset's attitude as a product of two rotation matrices.
    """

    def __init__(self, table, system, state):
        super().__init__(table)
        c, s = np.cos(float(state.inputs[1])), np.sin(float(state.inputs[1]))
        cr, sr = np.cos(float(state.roll)), np.sin(float(state.roll))
        self.turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
        self.radius = system.parameters["nominal_radius"]
        self.arm = system.parameters["running_circle_distance"] / 2
        self.error = 1e-14 if c == 1.0 else 3e-13

    def around(self, u):
        """Position and normal in the track's axes at profile abscissa ``u``, from the wheelset's centre."""
        z, slope, _ = evaluate_table(self.table, u)
        r = self.radius + z
        along = lambda phi: self.turn[0] @ [np.sin(phi), -slope, np.cos(phi)]
        phi = brentq(along, -0.7, 0.7, xtol=1e-16, rtol=8.9e-16) if self.turn[0, 1] != 0.0 else 0.0
        return (self.turn @ [r * np.sin(phi), self.arm + u, r * np.cos(phi)],
                self.turn @ np.array([np.sin(phi), -slope, np.cos(phi)]))

    def point(self, u):
        return self.around(u)[0][1:]

    def angle(self, u):
        normal = self.around(u)[1]
        return np.arctan2(-normal[1], normal[2])

    def speed(self, u, step=2e-5):
        """By differences of sixth order on one side of a piece's end; without yaw the profile's, whose roll does not count."""
        if self.turn[0, 1] == 0.0:
            return np.hypot(1.0, evaluate_table(self.table, u)[1])
        low, high = self.piece(u)
        step = min(step, 0.99 * (high - u) / 3, 0.99 * (u - low) / 3)
        one, two, three = ((self.point(u + k * step) - self.point(u - k * step)) / (2 * k * step) for k in (1, 2, 3))
        return np.hypot(*(1.5 * one - 0.6 * two + 0.1 * three))

    def piece(self, u):
        edges = np.concatenate([[self.table[profile_table.START]], self.ends, [self.table[profile_table.STOP]]])
        at = np.searchsorted(edges, u)
        return edges[at - 1], edges[at]


class Contact:
    """The right wheel's contact at a pose: both curves, its abscissae, and the kernel's own frame at it."""

    def __init__(self, shift, yaw=0.0, kind="normal", **parameters):
        self.system = wrcontact.ContactSystem(separation=kind, **parameters)
        stepper = self.system.stepper()
        stepper.inputs[:4] = shift, yaw, 0.0, 78.5e3
        assert stepper.step() == 0
        self.state = self.system.evaluate(shift, yaw)
        self.tables, self.memory, self.work = stepper._tables, stepper.state, stepper._workspace
        self.rail = Curve(self.tables[int(self.tables[layout.SET_RAIL]):int(self.tables[layout.SET_SCAN])])
        self.wheel = Outline(self.tables[int(self.tables[layout.SET_WHEEL]):int(self.tables[layout.SET_RAIL])], self.system,
                             self.state)
        self.u_rail = self.work[contact_plane.FRAME_ABSCISSA]
        self.u_wheel = self.work[contact_plane.FRAME_Y]
        self.angle = np.arctan2(self.work[contact_plane.FRAME_SIN], self.work[contact_plane.FRAME_COS])

    def kernel(self, kind, stations, spacing=0.0):
        """Gap [m], rate [-], bend [1/m] and 1/R_x [1/m] from the kernel's Python, (4, n), at ``stations`` from the contact."""
        tables, work, state = self.tables.copy(), self.work.copy(), self.memory
        tables[layout.SET_SEPARATION] = NUMBERS["separation"][kind]
        tables, work = memoryview(tables), memoryview(work)
        contact_plane.start_tracer(work, 0.0, self.u_rail, self.u_wheel)
        separation.open_origin(tables, work, 0.0, 0.0, self.u_rail, self.u_wheel, spacing)
        return np.array([separation.separation(tables, work, state, float(s), 1e-13) for s in stations]).T

    def between(self, u_rail, u_wheel):
        """Wheel's point less the rail's, both from the contact [m]."""
        return ((self.wheel.point(u_wheel) - self.wheel.point(self.u_wheel))
                - (self.rail.point(u_rail) - self.rail.point(self.u_rail)))

    def along_mean_normal(self, u_rail, u_wheel):
        normals = [np.array([np.sin(curve.angle(u)), -np.cos(curve.angle(u))])
                   for curve, u in ((self.rail, u_rail), (self.wheel, u_wheel))]
        return self.between(u_rail, u_wheel) @ sum(normals) / np.hypot(*sum(normals))

    def vertical(self, station):
        lateral = station * np.cos(self.angle)
        start = self.wheel.point(self.u_wheel)[0]
        u = brentq(lambda u: self.wheel.point(u)[0] - start - lateral, self.u_wheel - 5e-3, self.u_wheel + 5e-3, xtol=1e-16,
                   rtol=8.9e-16)
        return -self.between(self.u_rail + lateral, u)[1]

    def equidistant(self, station):
        return self.along_mean_normal(self.rail.at_arc(self.u_rail, station), self.wheel.at_arc(self.u_wheel, station))

    def chords(self, count, spacing):
        u_rail, u_wheel = self.u_rail, self.u_wheel
        for _ in range(count):
            u_rail, u_wheel = self.rail.at_chord(u_rail, spacing), self.wheel.at_chord(u_wheel, spacing)
        return self.along_mean_normal(u_rail, u_wheel)


STATIONS = np.array([0.2e-3, 0.6e-3, 1.1e-3])     # on a flange the rail's side begins soon


# --- separations --------------------------------------------------------------------------------------------------------

@EVERY_PLACE
@pytest.mark.parametrize("side", [1, -1], ids=["field", "flange"])
def test_separations_are_what_they_say(shift, yaw, side):
    contact = Contact(shift, yaw)
    stations = side * STATIONS
    # places are met to 1e-13 m, but a yawed outline's length is known by differences only
    np.testing.assert_allclose(contact.kernel("vertical", stations)[0], [contact.vertical(s) for s in stations], atol=2e-13)
    np.testing.assert_allclose(contact.kernel("equidistant", stations)[0], [contact.equidistant(s) for s in stations],
                               atol=2e-13 if yaw == 0.0 else 1e-12)
    spacing = side * 0.2e-3
    np.testing.assert_allclose(contact.kernel("equidistant_chord", spacing * np.array([1, 2, 5]), abs(spacing))[0],
                               [contact.chords(count, spacing) for count in (1, 2, 5)], atol=2e-13)


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
    """The kernel's arc against the zones as the standard prints them, away from the joints that are evened out."""
    contact = Contact(PLACES[place])
    tables, work = memoryview(contact.tables), memoryview(contact.work)
    wheel = contact.system.wheel
    for length in (0.4e-3, -0.8e-3):
        contact_plane.start_tracer(work, 0.0, contact.u_rail, contact.u_wheel)
        assert separation.move_arc(tables, work, contact_plane.TRACER_WHEEL, length) == 1
        found = quad(lambda u: np.hypot(1.0, wheel.slope(u)), contact.u_wheel, work[contact_plane.TRACER_WHEEL],
                     epsabs=1e-15)[0]
        assert found == pytest.approx(length, abs=1e-12)


def test_a_chord_is_shorter_than_its_arc_by_the_cube():
    """On a circle k chords of h span the angle 2 k asin(h / 2R): too long an arc by k h^3 / 24 R^2."""
    radius, contact = 80e-3, Contact(0.0)
    u = 6e-3       # on the rail's shoulder
    errors = []
    for count in (4, 8, 16):
        spacing = 4e-3 / count
        work = contact.work.copy()
        work[contact_plane.TRACER_RAIL] = u
        work, tables = memoryview(work), memoryview(contact.tables)
        for _ in range(count):
            assert separation.move_chord(tables, work, contact_plane.TRACER_RAIL, spacing) == 1
        arc = contact.rail.arc(u, work[contact_plane.TRACER_RAIL])
        assert arc == pytest.approx(2 * count * radius * np.arcsin(spacing / (2 * radius)), abs=1e-12)
        errors.append(arc - 4e-3)
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=1e-3) and errors[1] / errors[2] == pytest.approx(4.0, rel=1e-3)


def test_chord_steps_approach_true_arc_length_with_the_square_of_the_spacing():
    contact = Contact(PLACES["root"])
    station = 1.2e-3
    exact = contact.kernel("equidistant", [station])[0, 0]
    errors = [contact.kernel("equidistant_chord", station / count * np.arange(1, count + 1), station / count)[0, -1] - exact
              for count in (3, 6, 12)]
    assert abs(errors[0]) > 1e-12
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.1) and errors[1] / errors[2] == pytest.approx(4.0, rel=0.1)


@pytest.mark.parametrize("place", list(PLACES))
def test_vertical_is_normal_over_the_cosine_near_the_contact(place):
    contact = Contact(PLACES[place])
    stations = np.array([0.2e-3, 0.1e-3, 0.05e-3])
    ratio = contact.kernel("vertical", stations)[0] / contact.kernel("normal", stations)[0]
    errors = ratio * np.cos(contact.angle) - 1
    assert np.abs(errors[-1]) < 0.02
    if place != "tread":
        np.testing.assert_allclose(errors[:-1] / errors[1:], 2.0, rtol=0.1)      # of first order in s


def test_equidistant_is_normal_to_fourth_order():
    contact = Contact(PLACES["root"])
    stations = np.array([0.8e-3, 0.4e-3, 0.2e-3])
    errors = contact.kernel("equidistant", stations)[0] - contact.kernel("normal", stations)[0]
    np.testing.assert_allclose(errors[:-1] / errors[1:], 16.0, rtol=0.2)
    assert abs(errors[0]) < 5e-3 * contact.kernel("normal", stations)[0, 0]


def test_beyond_the_end_of_a_profile_there_is_no_separation():
    contact = Contact(PLACES["tread"])
    for kind in NUMBERS["separation"]:
        gap = contact.kernel(kind, np.arange(1, 101) * 1e-3, 1e-3)[0]
        assert gap[0] < contact_plane.NO_GAP <= gap[-1] and np.all(np.isfinite(gap))


def circles(wheel_radius=0.3, rail_radius=0.2, **parameters):
    """Two circles in place of profiles, in contact at their tops, the rail upright."""
    wheel = Profile("ball", "wheel", (Arc(-60.0, 60.0, 1e3 * wheel_radius, 0.0, -1e3 * wheel_radius, +1),))
    rail = Profile("crown", "rail", (Arc(-70.0, 70.0, 1e3 * rail_radius, 0.0, 1e3 * rail_radius, -1),))
    return dict(wheel=wheel, rail=rail, rail_inclination=0.0, gauge=1.5 - 2 * np.sqrt(0.2**2 - 0.19**2), gauge_depth=0.01,
                **parameters)


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


# --- lateral curvature --------------------------------------------------------------------------------------------------

@pytest.mark.parametrize("radius, side", [(13.0, -1), (80.0, +1), (300.0, -1)])
@pytest.mark.parametrize("curvature, scales", [(fitted_curvature, (0.1e-3, 3e-3, 10e-3)),
                                               (turned_curvature, (0.02e-3, 0.2e-3, 5e-3))], ids=["smooth", "rough"])
def test_curvature_of_a_circle_is_exact_up_to_its_ends(radius, side, curvature, scales):
    table = compile_profile(Profile("arc", "rail", (Arc(-9.0, 9.0, radius, 0.0, -side * radius, side),)))
    y = np.linspace(-9e-3, 9e-3, 41)
    for scale in scales:
        # heights are exact to 1e-12 m between the ends of the kernel's pieces
        np.testing.assert_allclose(curvature(table, y, scale), -side * 1e3 / radius, atol=8 * 1e-12 / scale**2 + 1e-6)


@pytest.mark.parametrize("curvature", [fitted_curvature, turned_curvature])
def test_curvature_of_a_straight_line_is_none(curvature):
    table = compile_profile(Profile("line", "rail", (Polynomial(-9.0, 9.0, (1.0, 0.4)),)))
    np.testing.assert_allclose(curvature(table, np.linspace(-9e-3, 9e-3, 41), 1e-3), 0.0, atol=1e-8)


@pytest.mark.parametrize("parameters", [dict(curvature_step=5e-3), dict(curvature_step=0.02e-3), dict(curvature_reach=10e-3),
                                        dict(curvature_reach=0.1e-3)], ids=str)
@pytest.mark.parametrize("rail", RAILS)
def test_tables_hold_numbers_at_every_scale(rail, parameters):
    kind = "rough" if "curvature_step" in parameters else "smooth"
    system = wrcontact.ContactSystem(rail=rail, lateral_curvature=kind, **parameters)
    for setting, end in ((layout.SET_WHEEL_CURVATURE, layout.SET_RAIL_CURVATURE), (layout.SET_RAIL_CURVATURE, None)):
        start = int(system._tables[setting])
        table = system._tables[start:int(system._tables[end]) if end else None]
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

    found = least_squares(distances, [0.0, np.arctan(profile.slope(y)), profile.curvature(y) * reach], xtol=1e-14, ftol=1e-14)
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
    system = wrcontact.ContactSystem(lateral_curvature=kind, curvature_step=scale, curvature_reach=max(scale, 0.1e-3))
    side = system.evaluate(PLACES[place]).right
    wheel, rail = profiles(system)
    expected = witness(rail, side.contact.y_rail, scale) - witness(wheel, side.contact.y_wheel, scale)
    assert side.curvature_y == pytest.approx(expected, rel=error, abs=0.02)


@pytest.mark.parametrize("kind", ["smooth", "rough"])
def test_curvature_of_a_small_scale_is_the_profile_s_own(kind):
    system = wrcontact.ContactSystem(lateral_curvature=kind, curvature_step=0.02e-3, curvature_reach=0.1e-3)
    own = wrcontact.ContactSystem()
    for place in ("root", "flange"):
        assert system.evaluate(PLACES[place]).right.curvature_y == pytest.approx(own.evaluate(PLACES[place]).right.curvature_y,
                                                                                 rel=1e-3)


def test_hertz_takes_the_chosen_lateral_curvature():
    sides = [wrcontact.ContactSystem(normal_model="hertz", lateral_curvature=kind).evaluate(1e-3).right
             for kind in CHOICES["lateral_curvature"]]
    assert sides[1].curvature_y < 0.8 * sides[0].curvature_y and sides[1].area > 1.1 * sides[0].area
    assert sides[2].curvature_y == pytest.approx(sides[0].curvature_y, rel=1e-3)


def test_rough_and_smooth_are_what_the_source_shows():
    """Sections 7.2 and 7.3 of the source: at 1 mm the rough curvature of wheel and rail together jumps within the patch, even
    below zero, and the smooth one does not."""
    system = wrcontact.ContactSystem()
    tables = system._tables
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


# --- what depends on what -----------------------------------------------------------------------------------------------

RIGID = list(range(layout.SIDE_X_WHEEL, layout.SIDE_CURVATURE_X))
COLUMNS = {name: [side + k for side in (layout.OUT_LEFT, layout.OUT_RIGHT) for k in slots]
           for name, slots in (("rigid", RIGID), ("curvature_x", [layout.SIDE_CURVATURE_X]),
                               ("curvature_y", [layout.SIDE_CURVATURE_Y]), ("penetration", [layout.SIDE_PENETRATION]))}
COLUMNS["rigid"] = [layout.OUT_ROLL, layout.OUT_VERTICAL_SHIFT, *COLUMNS["rigid"]]


@pytest.mark.parametrize("changed, unchanged, moved", [
    (dict(separation="vertical"), ("rigid", "curvature_x", "curvature_y"), "penetration"),
    (dict(separation="equidistant"), ("rigid", "curvature_x", "curvature_y"), "penetration"),
    (dict(separation="equidistant_chord"), ("rigid", "curvature_x", "curvature_y"), "penetration"),
    (dict(lateral_curvature="smooth"), ("rigid", "curvature_x"), "curvature_y"),
    (dict(lateral_curvature="rough"), ("rigid", "curvature_x"), "curvature_y"),
    (dict(longitudinal_curvature="basic"), ("rigid", "curvature_y"), "curvature_x"),
    (dict(curvature_step=1e-3, curvature_reach=1e-3), tuple(COLUMNS), None),
    (dict(lateral_curvature="smooth", curvature_step=1e-3), tuple(COLUMNS), None),
], ids=str)
def test_a_choice_changes_what_it_should_and_nothing_else(changed, unchanged, moved):
    plain = {"lateral_curvature": changed["lateral_curvature"]} if moved is None and "lateral_curvature" in changed else {}
    poses = dict(lateral_shift=np.linspace(-7e-3, 7e-3, 29), yaw=np.tile([0.0, 0.02], 15)[:29])
    before, after = (wrcontact.ContactSystem(**given).evaluate_many(**poses).values for given in (plain, changed))
    for name in unchanged:
        np.testing.assert_array_equal(after[:, COLUMNS[name]], before[:, COLUMNS[name]], err_msg=name)
    if moved:
        assert np.mean(after[:, COLUMNS[moved]] != before[:, COLUMNS[moved]]) > 0.9


EVERY_CHOICE = list(itertools.product(CHOICES["separation"], CHOICES["longitudinal_curvature"], CHOICES["lateral_curvature"],
                                      ("analyn", "analyn_strip", "hertz")))


def assert_all_valid(rail, shifts, yaws):
    shift, yaw = (column.ravel() for column in np.meshgrid(np.linspace(-8e-3, 8e-3, shifts),
                                                           np.radians(np.linspace(-3.0, 3.0, yaws))))
    for kind, longitudinal, lateral, model in EVERY_CHOICE:
        system = wrcontact.ContactSystem(rail=rail, separation=kind, longitudinal_curvature=longitudinal,
                                         lateral_curvature=lateral, normal_model=model)
        found = system.evaluate_many(shift, yaw)
        failed = found.status != 0
        assert not np.any(failed), (system, list(zip(shift[failed], yaw[failed]))[:5])
        assert np.all(np.isfinite(found.values)), system
        np.testing.assert_allclose(found.right.normal_force, 78.5e3, rtol=1e-9)
        assert np.all(found.right.area > 1e-6) and np.all(found.right.penetration < 1e-3), system


@pytest.mark.parametrize("rail", [pytest.param(rail, marks=[pytest.mark.slow] * (k > 0)) for k, rail in enumerate(RAILS)])
def test_every_choice_holds_everywhere(rail):
    assert_all_valid(rail, 17, 5)


def test_a_steep_side_leaves_no_hole_in_the_vertical_distance():
    """A cubic over four nodes to the rail's side fell below zero here, and no force was met."""
    found = wrcontact.ContactSystem(separation="vertical").evaluate(6.225e-3, np.radians(-0.5))
    assert found.status == 0 and 50e-6 < found.right.penetration < 80e-6


@pytest.mark.slow
@pytest.mark.parametrize("rail", [RAILS[0], *(pytest.param(rail, marks=pytest.mark.complete) for rail in RAILS[1:])])
def test_every_choice_holds_everywhere_on_a_fine_grid(rail):
    assert_all_valid(rail, 641, 13)


@pytest.mark.parametrize("place", list(PLACES))
def test_tread_hardly_notices_and_a_flange_does(place):
    """The source's finding of its section 7.1, and what it does not say: on a flange the vertical distance is the normal one
    over the cosine, so that the patch is too narrow."""
    areas = {kind: wrcontact.ContactSystem(separation=kind, nodes=38).evaluate(PLACES[place]).right.area
             for kind in NUMBERS["separation"]}
    assert areas["equidistant"] == pytest.approx(areas["normal"], rel=0.02)
    assert areas["equidistant_chord"] == pytest.approx(areas["equidistant"], rel=2e-3)
    low, high = {"tread": (0.99, 1.01), "root": (0.85, 0.97), "flange": (0.5, 0.75)}[place]
    assert low < areas["vertical"] / areas["normal"] < high
