"""The kernel's preparation of its tables: against the exact profiles, scipy and dense samples, compiled
against its source, and what it refuses."""

import math

import numpy as np
import pytest
from scipy.integrate import quad

import wrcontact
from tests.helpers.inside import tables_of
from wrcontact.interface.inputs import LATERAL_LIMIT, YAW_LIMIT
from wrcontact.interface.parameters import KERNEL_PARAMETERS
from wrcontact.kernel import layout
from wrcontact.kernel.binding import library
from wrcontact.kernel.binding.fixed_tables import fixed_tables, hertz_table, influence_table
from wrcontact.kernel.binding.library import Kernel, default_kernel
from wrcontact.kernel.binding.setup import setup_of
from wrcontact.kernel.prepare import pieces as made
from wrcontact.kernel.prepare import scan as raster
from wrcontact.kernel.prepare import scan_bends, zones
from wrcontact.kernel.prepare import tables as prepare
from wrcontact.kernel.prepare.tables import START_STEP, STARTS_EACH_METRE
from wrcontact.kernel.search.bounds import STEEP, WIDEST
from wrcontact.methods import NUMBERS
from wrcontact.profiles import Profile
from wrcontact.profiles.catalogue import standard_profile
from wrcontact.profiles.compiled import evaluate_table, table_pieces
from wrcontact.profiles.definition import definition
from wrcontact.profiles.placement import place_rail, readable_wheel
from wrcontact.profiles.zones import Arc, Polynomial
from wrcontact.stepper import Stepper

MM = 1e-3
LARGE_STEP = {
    "rail": "54E1",
    "rail_inclination": 1 / 20,
    "gauge": 1.43,
    "gauge_depth": 0.012,
    "nominal_radius": 0.5,
}


def worn_wheel():
    y = np.arange(-60.0, 56.0, 0.5)
    return Profile.from_points(
        y, -y / 20 + np.where(y < -30, 0.05 * (y + 30) ** 2, 0.0), name="worn", kind="wheel"
    )


def measured_rail():
    y = np.arange(-36.0, 36.1, 0.4)
    return Profile.from_points(
        y, 1e3 * standard_profile("UIC60").height(1e-3 * y), name="measured", kind="rail"
    )


def stepped_wheel():
    """A cone with a zone of 0.6 mm that is a step of 0.1 um higher: too short for the usual
    repair at both its ends."""
    zones = ((-60.0, -10.0, 0.0), (-10.0, -9.4, 1e-4), (-9.4, 55.0, 0.0))
    return Profile(
        "stepped", "wheel", tuple(Polynomial(low, high, (step, -0.05), 0.0) for low, high, step in zones)
    )


CASES = {
    "default": {},
    "other rail and track": LARGE_STEP,
    "upright": {"rail": "60E1", "rail_inclination": 0.0, "running_circle_distance": 1.51},
    "measured": {"wheel": worn_wheel(), "rail": measured_rail()},
    "stepped": {"wheel": stepped_wheel()},
    "methods": {
        "normal_model": "analyn_strip",
        "contact_mode": "elastic",
        "load": "vertical",
        "separation": "vertical",
        "longitudinal_curvature": "basic",
        "tolerance": 0.02,
        "youngs_modulus": 2e11,
        "poisson_ratio": 0.3,
    },
    "rough": {"lateral_curvature": "rough", "rail": measured_rail()},
    "smooth": {"lateral_curvature": "smooth", "curvature_reach": 1.7e-3},
}


#: Cases of which each run of the tests has all; the others are full.
QUICK = ("default", "measured", "methods")


@pytest.fixture(
    params=[case if case in QUICK else pytest.param(case, marks=pytest.mark.full) for case in CASES]
)
def prepared(request):
    """A system and the head of its tables."""
    system = wrcontact.ContactSystem(**CASES[request.param])
    return system, layout.Tables.at(tables_of(system))


def exact_profiles(system):
    """Wheel and placed rail as their definitions have them."""
    chosen = system.parameters
    placed = place_rail(
        system.rail,
        inclination=chosen["rail_inclination"],
        gauge=chosen["gauge"],
        gauge_depth=chosen["gauge_depth"],
    )
    return readable_wheel(system.wheel), placed


def test_settings_are_the_parameters(prepared):
    system, tables = prepared
    chosen = system.parameters
    modulus, nu = chosen["youngs_modulus"], chosen["poisson_ratio"]
    methods = {name: numbers[chosen[name]] for name, numbers in NUMBERS.items()}
    for pair in tables.pairs:
        assert pair.radius == chosen["nominal_radius"]
        assert pair.rail_y == pytest.approx(exact_profiles(system)[1].y_track, rel=1e-15)
    wanted = dict(
        height=chosen["nominal_radius"],
        arm=0.5 * chosen["running_circle_distance"],
        contact_modulus=modulus / (2 * (1 - nu**2)),
        shear_modulus=modulus / (2 * (1 + nu)),
        lateral_limit=LATERAL_LIMIT,
        yaw_limit=YAW_LIMIT,
        sides=layout.SIDES_BOTH,
        depth=layout.DEPTH_ALL,
        absent=np.nan,
        stations=layout.STATION_COUNT,
        mode=methods["contact_mode"],
        load=methods["load"],
        normal_model=methods["normal_model"],
        separation=methods["separation"],
        longitudinal=methods["longitudinal_curvature"],
        lateral=methods["lateral_curvature"],
        tangential=methods["tangential_model"],
    )
    np.testing.assert_allclose([getattr(tables, name) for name in wanted], list(wanted.values()), rtol=1e-15)
    resolution = system.resolution
    assert (tables.nodes, tables.stride, tables.sweeps) == (
        resolution.nodes,
        resolution.stride,
        resolution.sweeps,
    )
    if methods["normal_model"] == layout.MODEL_ANALYN_STRIP:
        assert tables.waves.count == resolution.strips
    assert np.isnan(tables.penetration[:]).all()
    known = {**chosen, **methods, "tolerance": chosen["tolerance"] or 0.01}
    np.testing.assert_array_equal(tables.parameters[:], [known[name] for name in KERNEL_PARAMETERS])


def test_tables_lie_one_after_the_other(prepared):
    system, _ = prepared
    numbers = tables_of(system)
    tables = layout.Tables.at(numbers)
    pair = tables.pairs[1]
    places = [
        layout.offset(part, numbers)
        for part in (
            tables.hertz,
            tables.influence,
            tables.starts,
            pair.wheel,
            pair.wheel_curvature,
            pair.rail,
            pair.rail_curvature,
            pair.rail_arc,
            pair.rail_at_arc,
            pair.scan,
        )
    ]
    hertz, influence, starts, wheel, wheel_bends, rail, rail_bends, arc, at_arc, scan = places
    assert hertz == layout.SETTING_COUNT and places == sorted(places)
    np.testing.assert_array_equal(numbers[hertz:influence], hertz_table())
    waves = starts
    if system.parameters["normal_model"] == "analyn_strip":
        waves = layout.offset(tables.waves, numbers)
        assert starts - waves == layout.WAVES_SIZE
    np.testing.assert_array_equal(numbers[influence:waves], influence_table())
    assert wheel - starts == layout.STARTS_SIZE
    if system.parameters["lateral_curvature"] == "adaptive":
        assert wheel_bends == rail and rail_bends == arc
    else:
        assert rail - wheel_bends == 3 + numbers[wheel_bends] and arc - rail_bends == 3 + numbers[rail_bends]
    for first, after in ((arc, at_arc), (at_arc, scan)):
        assert after - first == 3 + 4 * numbers[first]


# --- profiles -------------------------------------------------------------------------------------


def zone_jets(profile, index, y):
    """Height [m], slope and second derivative [1/m] of zone ``index`` at ``y`` [m], (3, n)."""
    return np.array(profile.zones[index](np.asarray(y) / MM)) * np.array([MM, 1.0, 1 / MM])[:, None]


def joint_jets(profile, index, y):
    """Those of zone ``index`` at the end ``y`` of a piece (2,), whose heights are led to the mean where a
    joint has a step; and whether one has."""
    jets, stepped = zone_jets(profile, index, y), False
    for column, other in ((0, index - 1), (1, index + 1)):
        joint = profile.zones[index].start if column == 0 else profile.zones[index].stop
        if 0 <= other < len(profile.zones) and y[column] == joint * MM:
            beside = zone_jets(profile, other, y)[:, column]
            if abs(beside[0] - jets[0, column]) > made.REPAIRED_STEP * MM:
                jets[:, column], stepped = 0.5 * (jets[:, column] + beside), True
    return jets, stepped


def check_pieces(table, profile):
    """Each piece has its zone's height, slope and second derivative at both ends and keeps to it between
    them; steps of the heights are led over within REPAIR_WIDTH or half of the zone."""
    pieces, head = table_pieces(table), layout.Profile.at(table)
    assert (head.start, head.stop) == (profile.start, profile.stop) and np.isnan(pieces[-1]).all()
    np.testing.assert_array_equal(pieces[:-1, 7], pieces[1:, 0])
    edges = np.append(pieces[:-1, 0], head.stop)
    assert (np.diff(edges) > 0).all() and np.diff(edges).max() <= MM * made.LONGEST_PIECE * (1 + 1e-9)
    starts = np.array([zone.start * MM for zone in profile.zones])
    assert np.isin(starts, edges).all()
    owners = np.searchsorted(starts, 0.5 * (edges[1:] + edges[:-1])) - 1
    for index, low, high, row in zip(owners, edges, edges[1:], pieces):
        wanted, stepped = joint_jets(profile, index, np.array([low, high]))
        quintic = np.polynomial.Polynomial(row[1:7])

        def jets(u):
            return np.array([quintic(u), quintic.deriv()(u), quintic.deriv(2)(u)])

        width = high - low
        rounding = 1e-13 * np.abs(wanted).max(axis=1, keepdims=True) + [
            [1e-17],
            [1e-16 / width],
            [1e-15 / width**2],
        ]
        assert (np.abs(jets(np.array([0.0, width])) - wanted) <= rounding).all(), (low, high)
        if stepped:
            zone = profile.zones[index]
            repaired = MM * min(made.REPAIR_WIDTH, 0.5 * (zone.stop - zone.start))
            assert width == pytest.approx(repaired, rel=1e-9)
        elif width > 2 * MM * made.SHORTEST_PIECE:
            u = width * np.linspace(0.1, 0.9, 9)
            off, exact = jets(u), zone_jets(profile, index, low + u)
            assert np.abs(off - exact)[0].max() <= MM * made.PIECE_ERROR * 1.001
            bends = np.abs(off - exact)[2] / (1 / MM + np.abs(exact[2]))
            assert bends.max() <= made.PIECE_BEND_ERROR * 1.001
    left = head.start + made.BIN_WIDTH * MM * np.arange(int(head.bin_count))
    assert head.stop - made.BIN_WIDTH * MM <= left[-1] < head.stop
    assert head.bins_per_metre == 1 / (made.BIN_WIDTH * MM)
    first = (np.asarray(head.bins[: len(left)]) - head.bins[0]) / layout.PIECE_SIZE
    np.testing.assert_array_equal(first, np.searchsorted(edges[:-1], left + 1e-15, side="right") - 1)


def test_pieces_are_those_of_the_exact_profiles(prepared):
    system, _ = prepared
    wheel, rail, _ = system.profile_tables()
    exact_wheel, placed = exact_profiles(system)
    check_pieces(wheel, exact_wheel)
    check_pieces(rail, placed.profile)


@pytest.mark.parametrize("inclination", [0.0, 1 / 40, 0.1])
def test_profiles_are_read_up_to_80_degrees(inclination):
    """Both sides of the head and the back of the flange; the wheel's field side is less steep."""
    wheel, rail, _ = wrcontact.ContactSystem(rail_inclination=inclination).profile_tables()
    for table, wanted in ((rail, (-80.0, 80.0)), (wheel, (80.0, -np.degrees(np.arctan(1 / 15))))):
        head = layout.Profile.at(table)
        steepness = np.degrees(np.arctan(evaluate_table(table, [head.start, head.stop])[1]))
        np.testing.assert_allclose(steepness, wanted, atol=1e-6)


def test_pieces_are_few():
    """As many as it takes to keep to S1002 and UIC60, counted once."""
    tables = wrcontact.ContactSystem().profile_tables()[:2]
    assert [len(table_pieces(table)) - 1 for table in tables] == [323, 259]


# --- the search's raster --------------------------------------------------------------------------


class Samples:
    """Second derivatives and slopes of a profile's table: of each piece at 17 places, both ends among
    them, so that a jump of the curvature counts with both its sides."""

    def __init__(self, table):
        self.table, head, pieces = table, layout.Profile.at(table), table_pieces(table)[:-1]
        self.start, self.stop = head.start, head.stop
        widths = np.diff(np.append(pieces[:, 0], head.stop))
        u = np.linspace(0.0, 1.0, raster.LAST_SAMPLE + 1)[:, None] * widths
        quintics = np.polynomial.polynomial
        coefficients = pieces[:, 1:7].T
        self.y = pieces[:, 0] + u
        self.slopes, self.bends = (
            quintics.polyval(u, quintics.polyder(coefficients, order)[:, None, :], tensor=False)
            for order in (1, 2)
        )

    def between(self, low, high):
        """Smallest and largest second derivative [1/m], and largest absolute slope, with both ends'."""
        low, high = np.clip([low, high], self.start, self.stop)
        inside = (self.y >= low) & (self.y <= high)
        _, slopes, bends = evaluate_table(self.table, [low, high])
        bends, slopes = np.append(self.bends[inside], bends), np.append(self.slopes[inside], slopes)
        return bends.min(), bends.max(), np.abs(slopes).max()


def test_the_raster_and_its_bounds_are_those_of_samples(prepared):
    system, tables = prepared
    wheel, rail, _ = system.profile_tables()
    scan, of_wheel, of_rail = tables.pairs[1].scan, Samples(wheel), Samples(rail)
    nodes = [scan.nodes[k] for k in range(int(scan.count))]
    y = np.array([node.y for node in nodes])
    coarse = np.linspace(
        of_wheel.start, of_wheel.stop, int(np.ceil((of_wheel.stop - of_wheel.start) / raster.COARSE_STEP)) + 1
    )
    middles = [
        0.5 * (low + high)
        for low, high in zip(coarse, coarse[1:])
        if np.abs(of_wheel.between(low, high)[:2]).max() > raster.FLAT_BEND
    ]
    np.testing.assert_allclose(y, np.sort([*coarse, *middles]), atol=1e-16)
    assert (scan.bin_count, scan.bins_per_metre) == (
        len(coarse) - 1,
        (len(coarse) - 1) / (of_wheel.stop - of_wheel.start),
    )
    np.testing.assert_array_equal(scan.bins[: len(coarse) - 1], np.searchsorted(y, coarse[:-1] - 1e-12))
    height, slope, _ = evaluate_table(wheel, y)
    np.testing.assert_array_equal([(node.height, node.slope) for node in nodes], np.array([height, slope]).T)
    near = dict(rel=1e-11, abs=1e-9)
    for k, node in enumerate(nodes):
        for exponent in range(layout.EXPONENTS):
            least, most, steepest = of_wheel.between(y[k], y[min(k + 2**exponent, len(y) - 1)])
            assert node.steepest_bends[exponent] == pytest.approx(max(abs(least), abs(most)), **near)
            assert node.most_bends[exponent] == pytest.approx(
                most if steepest < STEEP else raster.TOO_STEEP, **near
            )
        assert node.least_bend == pytest.approx(of_wheel.between(y[k], y[min(k + 1, len(y) - 1)])[0], **near)
    assert scan.steepest == pytest.approx(of_wheel.between(-1.0, 1.0)[2], **near)
    at = y[:, None] + np.append(np.diff(y), 0.0)[:, None] * np.linspace(0.0, 1.0, raster.LAST_SAMPLE + 1)[:-1]
    z, slope, _ = evaluate_table(wheel, at)
    levers = (-slope * (tables.pairs[1].radius + z) - (tables.arm + at)).max(axis=1)
    np.testing.assert_allclose(
        [node.lever for node in nodes], np.maximum.accumulate(levers[::-1])[::-1], rtol=1e-12
    )
    step = raster.FINE_STEP
    assert (scan.rail_start, scan.rail_per_metre) == (of_rail.start, 1.0 / step)
    assert scan.rail_count == np.ceil((of_rail.stop - of_rail.start) / step)
    for k in range(int(scan.rail_count)):
        cell, edge = scan.rail[k], of_rail.start + step * k
        # a wheel's cell starts in one of the rail's and is COARSE_STEP long, a quarter more when yawed
        least, most, _ = of_rail.between(edge - step, edge + step + 1.5 * raster.COARSE_STEP)
        assert (cell.least_bend, cell.most_bend) == pytest.approx((least, most), **near)
        wanted = [
            of_rail.between(edge - 0.01 * step, edge + step * (1.01 + (1 + WIDEST) * 1.01 * 2**n))[0]
            for n in range(layout.EXPONENTS + 1)
        ]
        assert cell.least_bends[:] == pytest.approx(wanted, **near)
        for n, bound in enumerate(cell.turns):
            reach = edge + step * (1.01 + (1 + WIDEST) * 1.01 * 2**n) + raster.FOOT_REACH
            x = np.linspace(edge - raster.FOOT_REACH, reach, 41).clip(of_rail.start, of_rail.stop)
            _, slope, bend = evaluate_table(rail, x)
            largest = np.abs(slope * bend / (1.0 + slope**2)).max()
            least, most, steepest = of_rail.between(x[0], x[-1])
            assert largest <= bound * (1.0 + 1e-9) + 1e-12
            assert bound == pytest.approx(max(abs(least), abs(most)) * min(steepest, 0.5), **near)


def test_departures_from_straight_lines_are_bounded(prepared):
    """What samples of an overlap are judged by: the wheel's bend between the nodes of the raster, and the
    rail's over any chord near a cell, its joints taken out, in steps of some micrometres."""
    system, tables = prepared
    wheel, rail, _ = system.profile_tables()
    scan, rng = tables.pairs[1].scan, np.random.default_rng(4)
    nodes = [scan.nodes[k] for k in range(int(scan.count))]
    for node, after in zip(nodes, nodes[1:]):
        y = np.linspace(node.y, after.y, 301)
        bends = evaluate_table(wheel, y)[2]
        assert (node.bend, after.bend) == pytest.approx(bends[[0, -1]], rel=1e-12)
        departure = np.abs(bends - np.interp(y, y[[0, -1]], bends[[0, -1]])).max()
        assert departure - 1e-9 <= node.departure <= 1.3 * departure + 2e-2, node.y
    joints = [scan.joints[k] for k in range(200)]
    joints = joints[: next(k for k, joint in enumerate(joints) if joint.place > 1.0)]
    for joint in joints:
        before, after = evaluate_table(rail, joint.place + np.array([-1e-12, 0.0]))[2]
        assert joint.jump == pytest.approx(after - before, abs=1e-6 * abs(after))
    places, jumps = (np.array([getattr(joint, name) for joint in joints]) for name in ("place", "jump"))
    for k in range(int(scan.rail_count)):
        cell, edge = scan.rail[k], rail[0] + raster.FINE_STEP * k
        assert np.count_nonzero(places < edge - scan_bends.FOOT_REACH) == cell.joint
        for _ in range(5):
            low = np.clip(
                edge + rng.uniform(-scan_bends.FOOT_REACH, raster.FINE_STEP), rail[0], rail[1] - 1e-4
            )
            x = np.linspace(low, min(low + rng.uniform(1e-4, scan_bends.CELL_REACH), rail[1]), 101)
            bends = evaluate_table(rail, x)[2] - (jumps * (places <= x[:, None])).sum(axis=1)
            departure = np.abs(bends - np.interp(x, x[[0, -1]], bends[[0, -1]])).max()
            length = x[-1] - x[0]
            bound = length * (length * cell.wave / 8.0 + cell.kinks / 4.0)
            assert departure <= bound + scan_bends.LEAST_JUMP, (k, low)


def test_starts_are_those_of_steps(prepared):
    """Roll and contacts of a system that is told a step before; opposite shifts are mirror images."""
    system, tables = prepared
    starts, middle = tables.starts, layout.START_COUNT // 2
    assert layout.START_COUNT == 2 * round(LATERAL_LIMIT / START_STEP) + 1
    assert (starts.count, starts.first_shift, starts.per_metre) == (
        layout.START_COUNT,
        -LATERAL_LIMIT,
        STARTS_EACH_METRE,
    )
    shifts = starts.first_shift + np.arange(layout.START_COUNT) / STARTS_EACH_METRE
    table = system.evaluate_many(shifts, normal_force=0.0, outputs="geometry")
    for k, status in enumerate(table.status):
        row, twin = starts.rows[k], starts.rows[layout.START_COUNT - 1 - k]
        assert row.known == (status <= layout.UNLOADED)
        assert (row.roll, row.left, row.right) == (-twin.roll, twin.right, twin.left)
        if row.known:
            wanted = table.roll[k], table.left.contact.y_wheel[k], table.right.contact.y_wheel[k]
            assert (row.roll, row.left, row.right) == pytest.approx(wanted, rel=1e-9, abs=1e-9)
    assert starts.rows[middle].roll == 0.0


# --- arc lengths ----------------------------------------------------------------------------------


def nodes_of(table):
    """Ends of the cells of a table of cubics, and value and slope there, (n,) each, on which the cubics
    of both sides agree."""
    count, width = int(table.count), 1 / table.cells_per_unit
    cells = np.array(
        [(cell.value, cell.slope, cell.bend, cell.third) for cell in (table.cells[k] for k in range(count))]
    )
    ahead = np.stack([cells.sum(axis=1), cells @ [0, 1, 2, 3]], axis=1)
    np.testing.assert_allclose(ahead[:-1], cells[1:, :2], rtol=1e-9)
    jets = np.append(cells[:, :2], ahead[-1:], axis=0) * [1.0, 1 / width]
    return table.start + width * np.arange(count + 1), *jets.T


def test_arc_lengths_are_integrals_along_the_rail(prepared):
    """By adaptive quadrature between the ends of the pieces."""
    system, tables = prepared
    pair, rail = tables.pairs[1], system.profile_tables()[1]
    head = layout.Profile.at(rail)

    def speed(y):
        return np.hypot(1.0, evaluate_table(rail, y)[1])

    def arc(low, high):
        return quad(speed, low, high, epsabs=1e-15)[0]

    ends = np.append(table_pieces(rail)[:-1, 0], head.stop)
    lengths = np.append(0.0, np.cumsum([arc(low, high) for low, high in zip(ends, ends[1:])]))

    def length_at(y):
        piece = min(np.searchsorted(ends, y, side="right"), len(ends) - 1) - 1
        return lengths[piece] + arc(ends[piece], y)

    for table, start, whole in (
        (pair.rail_arc, head.start, head.stop - head.start),
        (pair.rail_at_arc, 0.0, lengths[-1]),
    ):
        assert (table.start, table.count) == (start, np.ceil(whole / 1e-4))
        assert table.count / table.cells_per_unit == pytest.approx(whole, abs=1e-13)
    y, found, slope = (np.append(each[:-1:11], each[-1]) for each in nodes_of(pair.rail_arc))
    y = np.minimum(y, head.stop)
    np.testing.assert_allclose(found, [length_at(place) for place in y], rtol=0, atol=1e-13)
    np.testing.assert_allclose(slope, speed(y), rtol=1e-12)
    length, found, slope = (np.append(each[:-1:11], each[-1]) for each in nodes_of(pair.rail_at_arc))
    found = np.minimum(found, head.stop)
    np.testing.assert_allclose([length_at(place) for place in found], length, rtol=0, atol=1e-13)
    np.testing.assert_allclose(slope, 1 / speed(found), rtol=1e-11)


@pytest.mark.skipif(not default_kernel().compiled, reason="no compiled library here")
@pytest.mark.parametrize("case", ["default", "measured", pytest.param("rough", marks=pytest.mark.full)])
def test_compiled_preparation_is_its_source_to_the_last_bit(case, monkeypatch):
    compiled = tables_of(wrcontact.ContactSystem(**CASES[case]))
    monkeypatch.setattr(library.default_kernel(), "library", None)
    source = tables_of(wrcontact.ContactSystem(**CASES[case]))
    np.testing.assert_array_equal(compiled.view(np.int64), source.view(np.int64))


def test_more_room_is_found(monkeypatch):
    expected = tables_of(wrcontact.ContactSystem())
    for room in (500, 3000, 9200, 12700, 13600):
        monkeypatch.setattr(library, "TABLE_ROOM", room)
        np.testing.assert_array_equal(tables_of(wrcontact.ContactSystem()), expected)


def test_no_room_is_reported(monkeypatch):
    monkeypatch.setattr(library, "TABLE_ROOM", 1000)
    monkeypatch.setattr(library, "MOST_ROOM", 2000)
    with pytest.raises(ValueError, match="S1002 and UIC60 have too many points"):
        wrcontact.ContactSystem()


def test_what_does_not_fit_is_refused_in_a_sentence():
    with pytest.raises(
        ValueError,
        match=r"gauge_depth reaches 0\.029\d* m, but the inner side of the rail profile "
        r"crown ends at",
    ):
        wrcontact.ContactSystem(
            rail=Profile("crown", "rail", (Arc(-30.0, 30.0, 300.0, 0.0, 300.0, -1),)), gauge_depth=0.03
        )
    with pytest.raises(ValueError, match=r"the wheel profile is 0\.\d+ m wide; permitted are at most 0\.2 m"):
        wide = tuple(Polynomial(low, low + 1.0, (0.0, 0.0, 0.0)) for low in range(-150, 250))
        wrcontact.ContactSystem(wheel=Profile("wide", "wheel", bent(wide)))
    with pytest.raises(ValueError, match="too steep at y = 0"):
        wrcontact.ContactSystem(wheel=Profile("away", "wheel", (Polynomial(5.0, 60.0, (0.0,)),)))


def bent(zones):
    """The same zones on a parabola that is bent enough for the fine raster."""
    bend = 0.02 / 2  # [1/mm]
    return tuple(
        Polynomial(z.start, z.stop, (bend * z.start**2, 2 * bend * z.start, bend), z.start) for z in zones
    )


def test_a_definition_is_read_exactly():
    """Every number of the zones is in the definition."""
    wheel = standard_profile("S1002")
    held = definition(wheel)
    for zone in wheel.zones:
        numbers = [value for value in vars(zone).values() if isinstance(value, float)] + list(
            getattr(zone, "coefficients", ())
        )
        assert all(value in held for value in numbers)


def test_a_rail_is_exchanged_by_itself():
    """Another rail behind the tables of a system, with its raster: the answers of a system with that rail."""
    system, other = wrcontact.ContactSystem(), wrcontact.ContactSystem(rail="54E1")
    size, room = len(tables_of(system)), 60_000
    array, work = np.append(tables_of(system), np.zeros(room)), memoryview(np.zeros(2 * room))
    tables, setup = layout.Tables.at(array), layout.Setup.at(setup_of(system.parameters, system.methods))
    held = memoryview(definition(other.rail))
    end = size
    for pair in tables.pairs:
        end = prepare.write_rail(setup, tables, pair, 1 / 40, end, held, work)
        end = raster.write_scan(setup, tables, pair, end, work)
        end = scan_bends.write_scan_bends(tables, pair, end)
    assert size < end <= len(array)
    expected = tables_of(other).copy()
    for each in (array, expected):
        layout.Tables.at(each).starts.count = 0.0  # they are those of another rail
    changed, wanted = Stepper(array), Stepper(expected)
    for shift, yaw in ((0.0, 0.0), (2e-3, 5e-3), (-5.5e-3, -0.01), (6.5e-3, 0.02)):
        for one in (changed, wanted):
            one.inputs[:4] = shift, yaw, 0.0, 8e4
        assert changed.step() == wanted.step() == 0
        np.testing.assert_array_equal(changed.outputs, wanted.outputs)


def test_setup_that_is_no_array_is_refused():
    upright = definition(standard_profile("UIC60"))
    with pytest.raises(TypeError, match="setup must be a numpy array"):
        Kernel().prepare([0.0], *[upright] * 4, fixed_tables())


@pytest.mark.parametrize("turn, fits", [(0.0, True), (3.0, True), (4.9, True), (5.1, False), (8.0, False)])
def test_a_polynomial_that_becomes_too_steep_is_left_out(turn, fits):
    """A straight zone of 75 degrees is turned up to 80. Witness: its ends turned by hand; either way round."""
    for sign in (-1.0, 1.0):
        row = np.zeros(zones.ZONE_COEFFICIENTS + 4)
        row[zones.ZONE_FAMILY] = zones.FAMILY_POLYNOMIAL
        row[zones.ZONE_START], row[zones.ZONE_STOP] = -2.0, 3.0
        row[zones.ZONE_TERMS] = 2.0
        row[zones.ZONE_COEFFICIENTS + 1] = slope = sign * math.tan(math.radians(75.0))
        angle = sign * math.radians(turn)
        assert zones.turn_polynomial(row, 0, angle, 0.5, 0.25) == int(fits)
        if fits:
            cosine, sine = math.cos(angle), math.sin(angle)
            ends = [cosine * y - sine * slope * y + 0.5 for y in (-2.0, 3.0)]
            assert [row[zones.ZONE_START], row[zones.ZONE_STOP]] == pytest.approx(ends, abs=1e-12)
