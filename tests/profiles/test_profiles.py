"""Profiles: definitions, joints, placement on the track, and the kernel's tables of them."""

import warnings

import numpy as np
import pytest

import wrcontact
from data.noisy_profiles import noisy_points
from wrcontact.kernel.layout import PIECE_SIZE, offset
from wrcontact.kernel.layout import Profile as Table
from wrcontact.kernel.surface import tables
from wrcontact.profiles import RAILS, WHEELS, Profile, standard_profile
from wrcontact.profiles.catalogue import find_profile, standard_name
from wrcontact.profiles.compiled import evaluate_table
from wrcontact.profiles.files import prepared_text
from wrcontact.profiles.placement import place_rail
from wrcontact.profiles.zones import Chain, Polynomial

MM = 1e-3


def placed(name, inclination=1 / 40, gauge=1.435):
    return place_rail(standard_profile(name), inclination=inclination, gauge=gauge, gauge_depth=0.014)


def test_s1002_joints_are_as_the_standard_prints_them():
    # EN 13715's rounding leaves 1.2e-4 mm at C/D and 3.7e-5 mm at B/C; everywhere else the zones meet
    steps = {round(joint.y / MM): abs(joint.height_step) / MM for joint in standard_profile("S1002").joints}
    assert steps.pop(-35) == pytest.approx(1.183e-4, rel=1e-3)
    assert steps.pop(-26) == pytest.approx(3.655e-5, rel=1e-3)
    assert max(steps.values()) < 1e-7


def test_s1002_known_points():
    wheel = standard_profile("S1002")
    assert wheel.height(0.0) == pytest.approx(0.0, abs=1e-12)
    assert wheel.height(-0.055) == pytest.approx(0.028, abs=1e-9)  # flange tip: 16 + 12 mm
    assert wheel.slope(-0.039) == pytest.approx(-np.tan(np.radians(70)), rel=1e-6)
    assert wheel.slope(0.05) == pytest.approx(-1 / 15, rel=1e-6)  # the field side's 1:15 cone
    assert abs(wheel.curvature(-0.037)) == pytest.approx(1 / 0.013, rel=1e-9)


@pytest.mark.parametrize(
    "name, corner, depth", [("UIC60", 0.036, 0.014259738), ("60E1", 0.0359998, 0.0142999)]
)
def test_rail_chain_ends_where_published(name, corner, depth):
    assert standard_profile(name).height(corner) == pytest.approx(depth, abs=1e-6)


@pytest.mark.parametrize("name", RAILS)
def test_rail_arcs_are_tangent_and_symmetric(name):
    rail = standard_profile(name)
    assert max(abs(joint.slope_step) for joint in rail.joints) < 1e-9
    y = np.linspace(0, rail.stop, 200)
    np.testing.assert_allclose(rail.height(y), rail.height(-y), atol=1e-15)
    assert rail.curvature(0.0) == pytest.approx(1 / 0.3)
    assert rail.curvature(0.02) == pytest.approx(1 / 0.08)


def test_broken_profiles_are_refused():
    straight = Polynomial(0.0, 50.0, (0.0, 0.1))
    with pytest.raises(ValueError, match="hole between y = 50.0 mm and 51.0 mm"):
        Profile("holed", "rail", (straight, Polynomial(51.0, 60.0, (5.0, 0.1))))
    with pytest.raises(ValueError, match="height step of 1 mm at y = 50.0 mm"):
        Profile("stepped", "rail", (straight, Polynomial(50.0, 60.0, (1.0, 0.1))))
    with pytest.raises(ValueError, match="slope step of 0.1 at y = 50.0 mm"):
        Profile("kinked", "rail", (straight, Polynomial(50.0, 60.0, (-5.0, 0.2))))


def test_arrays_in_arrays_out_and_nan_outside():
    wheel = standard_profile("S1002")
    heights = wheel.height(np.array([[-0.08, 0.0], [0.03, 0.061]]))
    assert heights.shape == (2, 2)
    np.testing.assert_array_equal(np.isnan(heights), [[True, False], [False, True]])


def test_highest_point_of_the_inclined_uic60():
    # UIC60, 1:40, gauge 1435 mm: 760.5385 mm from the track centre
    # (data/brute_force.py finds the same)
    assert placed("UIC60").y_track == pytest.approx(0.7605385, abs=5e-8)


@pytest.mark.parametrize("name", RAILS)
@pytest.mark.parametrize("inclination", [0.0, 1 / 40, 1 / 20])
def test_inclined_rail_is_the_turned_one(name, inclination):
    rail, head = standard_profile(name), placed(name, inclination).profile
    assert head.height(0.0) == pytest.approx(0.0, abs=1e-12)
    assert head.slope(0.0) == pytest.approx(0.0, abs=1e-9)
    # points turned by hand; the crown's top is 300 mm from its centre, which turns with the head
    angle = -np.arctan(inclination)
    y = np.linspace(-0.024, 0.024, 81)
    turned_y = np.cos(angle) * y - np.sin(angle) * rail.height(y)
    turned_z = np.sin(angle) * y + np.cos(angle) * rail.height(y)
    centre = -0.3 * np.sin(angle), 0.3 * np.cos(angle)
    # at 1:20 the top lies on the R80 shoulder
    top = (centre[0], centre[1] - 0.3) if abs(centre[0]) < 0.01 else None
    if top is None:
        finest = np.linspace(0.0, 0.02, 2000001)
        k = np.argmin(np.sin(angle) * finest + np.cos(angle) * rail.height(finest))
        top = (
            np.cos(angle) * finest[k] - np.sin(angle) * rail.height(finest[k]),
            np.sin(angle) * finest[k] + np.cos(angle) * rail.height(finest[k]),
        )
    np.testing.assert_allclose(head.height(turned_y - top[0]), turned_z - top[1], atol=1e-8)


@pytest.mark.parametrize("gauge", [1.425, 1.435, 1.45])
def test_gauge_is_measured_14_mm_below_the_top(gauge):
    # on the inclined head, whose inner face is the last point as deep as that
    rail, inclination = standard_profile("60E1"), 1 / 40
    angle = -np.arctan(inclination)
    y = np.linspace(rail.start, -0.03, 400001)
    turned_y = np.cos(angle) * y - np.sin(angle) * rail.height(y)
    turned_z = np.sin(angle) * y + np.cos(angle) * rail.height(y)
    # the highest point lies on the R300 crown
    top = np.array([-0.3 * np.sin(angle), 0.3 * np.cos(angle) - 0.3])
    inner = np.interp(-top[1] - 0.014, -turned_z, turned_y) - top[0]
    assert placed("60E1", inclination, gauge).y_track + inner == pytest.approx(gauge / 2, abs=1e-8)


def test_shallow_rail_is_refused():
    head = Profile("shallow", "rail", standard_profile("UIC60").zones[2:5])
    with pytest.raises(ValueError, match="inner side of the rail profile shallow ends"):
        place_rail(head, inclination=1 / 40, gauge=1.435, gauge_depth=0.014)


def test_the_kernel_reads_its_table_as_numpy_does():
    table = wrcontact.ContactSystem().profile_tables()[0]
    profile = Table.at(table)
    for y in np.random.default_rng(2).uniform(-0.069, 0.06, 500):
        np.testing.assert_array_equal(tables.height_slope_bend(profile, y), evaluate_table(table, y))
        assert tables.height_slope(profile, y) == tables.height_slope_bend(profile, y)[:2]


@pytest.mark.parametrize("y", [np.nan, np.inf, -np.inf, 1e300, -1e300])
def test_an_abscissa_out_of_this_world_stays_inside_the_table(y):
    table = wrcontact.ContactSystem().profile_tables()[0]
    profile = Table.at(table)
    piece = offset(tables.find_piece(profile, y), table)
    assert offset(profile.pieces, table) <= piece < len(table) - PIECE_SIZE


def test_points_file_gives_the_profile_back(tmp_path):
    wheel = standard_profile("S1002")
    y = np.concatenate([np.arange(-0.069, -0.0305, 5e-5), np.arange(-0.03, 0.06, 5e-4)])
    path = tmp_path / "worn wheel.csv"
    path.write_text(
        "y;z\n" + "\n".join(f"{a / MM!r}; {b / MM!r}" for a, b in zip(y.tolist(), wheel.height(y).tolist()))
    )
    read = Profile.from_file(path, "wheel")
    assert read.name == "worn wheel"
    smooth = np.random.default_rng(3).uniform(-0.06, 0.059, 2000)
    # a spline rings where S1002 steps (1.2e-7 m)
    assert np.max(np.abs(read.height(smooth) - wheel.height(smooth))) < 2e-7


def test_prepared_file_gives_the_profile_back_bit_for_bit(tmp_path):
    y = np.linspace(-36, 36, 145)
    rail = Profile.from_points(y + 3.0, 7.0 + y**2 / 160, name="measured", kind="rail")
    path = tmp_path / "measured.json"
    rail.save(path)
    assert path.read_text() == prepared_text(rail)
    assert Profile.from_file(path, "rail") == rail
    assert rail.height(0.0) == pytest.approx(0.0, abs=1e-15)
    assert rail.slope(0.0) == pytest.approx(0.0, abs=1e-12)
    for name in ("measured.xyz", "measured.whl", "measured"):
        with pytest.raises(ValueError, match=r"path is .*measured.*; permitted"):
            rail.save(tmp_path / name)
        assert not (tmp_path / name).exists()


@pytest.mark.parametrize(
    "source, kind, sentence",
    [
        ("S1003", "wheel", "wheel is 'S1003'; permitted are S1002"),
        ("UIC60", "wheel", "a profile of the other kind; did you swap wheel and rail"),
        (3.0, "rail", "rail is '3.0'; permitted are UIC60, 60E1, 54E1"),
        (standard_profile("UIC60"), "wheel", "wheel is a rail profile"),
    ],
)
def test_what_is_no_profile_is_refused(source, kind, sentence):
    with pytest.raises(ValueError, match=sentence):
        find_profile(source, kind)


@pytest.mark.parametrize(
    "text, sentence",
    [
        ("nothing here", "no lines of two numbers"),
        ("\n".join(f"{k} 0" for k in range(5)), "5 points; permitted are 10 or more"),
        ("\n".join(f"{k % 7} 0" for k in range(30)), "has 7 points; permitted are 10 or more"),
        ("\n".join(f"{k * 1e-4} 0" for k in range(60)), "0.0059 mm wide; permitted are 20 ... 200 mm"),
        ("\n".join(f"{k} nan" for k in range(60)), "not finite"),
    ],
)
def test_unusable_points_are_refused(tmp_path, text, sentence):
    path = tmp_path / "broken.txt"
    path.write_text(text)
    with pytest.raises(ValueError, match=sentence):
        Profile.from_file(path, "wheel")


@pytest.mark.parametrize("name", ["s1002", "S1002", "Uic60", "60e1", "54E1", "CONE40"])
def test_names_are_read_without_regard_to_case(name):
    kind = "wheel" if standard_name(name) in WHEELS else "rail"
    assert find_profile(name, kind) is standard_profile(standard_name(name))


@pytest.mark.parametrize("name, slope", [("cone20", 1 / 20), ("cone40", 1 / 40)])
def test_cones_have_the_conicity_of_their_slope(name, slope):
    conicity = wrcontact.check(wrcontact.ContactSystem(wheel=name)).conicity
    np.testing.assert_allclose(conicity.level, slope, rtol=1e-3)


@pytest.mark.parametrize("smoothing", [None, 0.0])
def test_polynomials_in_a_row_are_each_by_itself(tmp_path, smoothing):
    """Bit for bit, also where two meet, and just outside."""
    y, z = noisy_points("wheel", 0.2, 5e-3, 3)
    np.savetxt(tmp_path / "wheel.txt", np.column_stack([y, z]), fmt="%.5f")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        profile = Profile.from_file(tmp_path / "wheel.txt", "wheel", smoothing)
    ends = [end for zone in profile.zones for end in (zone.start, zone.stop)]
    y = np.concatenate([np.linspace(profile.start / MM - 1.0, profile.stop / MM + 1.0, 2001), ends])
    expected = np.full((3, len(y)), np.nan)
    for zone in profile.zones:
        inside = (y >= zone.start) & (y <= zone.stop)
        expected[:, inside] = zone(y[inside])
    chain = Chain.of(profile.zones)
    within = np.isfinite(expected[0])
    np.testing.assert_array_equal(chain(y[within]), expected[:, within])
    assert not within.all() and Chain.of(standard_profile("S1002").zones) is None
    np.testing.assert_array_equal(np.isnan(profile.height(y * MM)[:2001]), ~within[:2001])


def test_polynomials_of_several_degrees_in_a_row():
    zones = Polynomial(-70, -9, (-0.045, -0.055), -9.0), Polynomial(-9, 60, (-0.045, -0.05, 1e-3, 2e-5), 3.0)
    for zone in zones:
        y = np.linspace(zone.start, zone.stop - 1e-9, 101)
        np.testing.assert_array_equal(Chain.of(zones)(y), zone(y))
