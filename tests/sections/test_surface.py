"""The surface through the sections of a rail, against its closed forms."""

import warnings

import numpy as np
import pytest

from tests.helpers.sections import NOSE_RADIUS, NOSE_RISE, moved, nose, waves
from wrcontact import ProfileWarning, RailSections
from wrcontact.profiles import standard_profile

RAIL = standard_profile("UIC60")
NAMES = ("z", "z_u", "z_y", "z_uu", "z_uy", "z_yy", "Y_u", "Y_uu")
GENERATOR = np.random.default_rng(42)
PLACES = GENERATOR.uniform(RAIL.start + 1e-6, RAIL.stop - 1e-6, 2000)


def assert_jet(found, expected, slope, tolerances):
    """Compare what counts across the surface: each derivative of a steep place over its power of the steepness."""
    steep = np.sqrt(1.0 + slope**2)
    for name, value, tolerance, power in zip(NAMES, expected, tolerances, (1, 2, 2, 3, 3, 3, 0, 0)):
        np.testing.assert_allclose(
            found[name] / steep**power, value / steep**power, rtol=0.0, atol=tolerance, err_msg=name
        )


@pytest.mark.parametrize("positions", [[0.0, 0.5], [0.0, 0.1, 0.5], [-0.2, 0.0, 0.05, 0.3, 0.31]])
def test_equal_slices_are_the_constant_rail(positions):
    """Also beyond the first and the last of them."""
    u = GENERATOR.uniform(-1.0, 1.0, 2000)
    z, slope, bend = RAIL.evaluate(PLACES)
    found = moved(positions).evaluate(u, PLACES)
    zero = 0.0 * u
    tolerances = [1e-12, 1e-12, 1e-7, 1e-9, 1e-9, 1e-2, 1e-12, 1e-12]
    assert_jet(found, (z, zero, slope, zero, zero, bend, zero, zero), slope, tolerances)


@pytest.mark.parametrize("rate, rise", [(0.1, 0.0), (0.0, 0.1), (-0.04, 0.02)])
def test_a_rail_that_moves_and_rises_evenly_is_a_cylinder_along_its_way(rate, rise):
    rail = moved(np.linspace(-0.2, 0.3, 6), rate, rise)
    u = GENERATOR.uniform(-0.2, 0.3, len(PLACES))
    z, s, b = RAIL.evaluate(PLACES)
    found = rail.evaluate(u, PLACES + rate * u)
    expected = (z - rise * u, -rise - rate * s, s, rate**2 * b, -rate * b, b, rate + 0.0 * u, 0.0 * u)
    assert_jet(found, expected, s, [1e-12, 1e-8, 1e-7, 1e-4, 1e-3, 1e-2, 1e-12, 1e-12])


@pytest.fixture(scope="module")
def uneven():
    with pytest.warns(ProfileWarning, match="between the slices at .* m the surface stands up to 2.. um"):
        return waves()


def test_derivatives_are_those_of_the_height(uneven):
    rail, step = uneven, 1e-6
    u, y = GENERATOR.uniform(-0.1, 0.7, 1000), GENERATOR.uniform(-0.028, 0.028, 1000)
    found = rail.evaluate(u, y)
    for name, of, move in (
        ("z_u", "z", (step, 0.0)),
        ("z_y", "z", (0.0, step)),
        ("z_uu", "z_u", (step, 0.0)),
        ("z_uy", "z_u", (0.0, step)),
        ("z_yy", "z_y", (0.0, step)),
    ):
        ahead, back = (rail.evaluate(u + k * move[0], y + k * move[1])[of] for k in (1.0, -1.0))
        # second derivatives have kinks at knots and slices: a few of the differences lie across one
        wrong = np.abs((ahead - back) / (2.0 * step) - found[name])
        assert np.quantile(wrong, 0.95) < 2e-4 * (1.0 + np.abs(found[name]).max()), name


def test_second_derivatives_along_the_track_are_continuous_also_where_slices_end(uneven):
    rail, e = uneven, 1e-9
    y = np.linspace(-0.025, 0.025, 50)
    for u in rail.surface.breaks:
        before, behind = rail.evaluate(u - e, y), rail.evaluate(u + e, y)
        for name in NAMES:
            np.testing.assert_allclose(
                before[name], behind[name], rtol=1e-5, atol=2e-3, err_msg=f"{name} at {u}"
            )
    far = rail.evaluate(10.0, y)
    assert max(np.abs(far[name]).max() for name in ("z_u", "z_uu", "z_uy", "Y_u", "Y_uu")) < 1e-9


def test_lines_of_equal_share_bend_as_the_places_of_slices_do():
    """A section that moves on a parabola: Y_uu is its second derivative, and the height goes with it."""
    u = np.linspace(0.0, 0.4, 5)
    rail = RailSections(u, [RAIL] * 5, places=np.column_stack([0.1 * u**2, 0.0 * u]))
    at = GENERATOR.uniform(0.0, 0.4, len(PLACES))
    found = rail.evaluate(at, PLACES + 0.1 * at**2)
    np.testing.assert_allclose(found["Y_u"], 0.2 * at, atol=1e-12)
    np.testing.assert_allclose(found["Y_uu"], 0.2, atol=1e-9)
    np.testing.assert_allclose(found["z"], RAIL.height(PLACES), atol=3e-11)


def test_points_on_arcs_make_arcs():
    """The artificial nose: radius of its edges and rise, from points 0.1 mm apart."""
    rail = nose(np.linspace(-0.1, 0.1, 21))
    u, turn = GENERATOR.uniform(-0.09, 0.09, 400), GENERATOR.uniform(0.1, 1.2, 400)
    y = (5.0 - NOSE_RADIUS * np.sin(turn)) * 1e-3
    found = rail.evaluate(u, y)
    np.testing.assert_allclose(
        found["z"], NOSE_RADIUS * 1e-3 * (1.0 - np.cos(turn)) - NOSE_RISE * u, atol=3e-8
    )
    curvature = found["z_yy"] / (1.0 + found["z_y"] ** 2) ** 1.5
    assert np.quantile(np.abs(curvature * NOSE_RADIUS * 1e-3 - 1.0), 0.9) < 0.01
    np.testing.assert_allclose(found["z_u"], -NOSE_RISE, atol=1e-9)


def test_features_stay_together():
    """A ridge that moves across a level section stays a ridge between the slices with a feature on it; without it
    knots keep their places, and it is cut off."""
    u = np.array([0.0, 0.1, 0.2])
    sections, features = [], []
    for top in (0.02, 0.03, 0.04):
        y = np.linspace(0.0, 0.06, 601)
        sections.append(np.column_stack([y, 0.5 * np.sqrt((y - top) ** 2 + 1e-3**2)]))
        chords = np.hypot(*np.diff(sections[-1], axis=0).T)
        features.append([0.0, chords[: round(top / 1e-4)].sum(), chords.sum()])
    with_feature = RailSections(u, sections, features)
    with pytest.warns(ProfileWarning, match="stands up to"):
        without = RailSections(u, sections)
    ridge = with_feature.evaluate(0.05, 0.025)
    assert abs(ridge["z"] - 0.5e-3) < 1e-6 and abs(ridge["z_y"]) < 1e-3
    assert without.height(0.05, 0.025) > 0.55e-3


def test_a_surface_has_no_height_beside_its_sections():
    rail = moved([0.0, 0.5], rate=0.1)
    first, last = rail.edges([0.0, 0.5])
    np.testing.assert_allclose(first, RAIL.start + 0.1 * np.array([0.0, 0.5]), atol=1e-15)
    np.testing.assert_allclose(last - first, RAIL.stop - RAIL.start, atol=1e-15)
    assert np.isnan(rail.height(0.5, [first[1] - 1e-6, last[1] + 1e-6])).all()
    assert np.isfinite(rail.height(0.5, [first[1] + 1e-6, last[1] - 1e-6])).all()
    assert len(rail.section(0.25)) > 100 and rail.section(0.25)[0, 0] == pytest.approx(RAIL.start + 0.025)


def test_jumps_and_overshoots_are_told():
    u = np.linspace(0.0, 0.08, 9)
    with pytest.warns(ProfileWarning, match=r"heights change by 3 mm between the slices at 0.04 and 0.05 m"):
        RailSections(u, [RAIL] * 9, places=np.column_stack([0.0 * u, np.where(u > 0.045, 3e-3, 0.0)]))
    u = np.linspace(0.0, 1.6, 9)
    with pytest.warns(
        ProfileWarning, match=r"between the slices at 0.6 and 0.8 m the surface stands up to \d+ um"
    ):
        RailSections(u, [RAIL] * 9, places=np.column_stack([0.0 * u, 0.02 * np.maximum(u - 0.8, 0.0)]))


# --- what is refused ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "changes, sentence",
    [
        ({"positions": [0.0]}, r"positions has the shape \(1,\); permitted are 2 or more numbers in m"),
        ({"positions": ["a", "b", "c"]}, "positions has the shape"),
        ({"positions": [0.0, np.nan, 1.0]}, "position 2 is nan; permitted are finite numbers in m"),
        (
            {"positions": [0.0, 0.2, 0.2]},
            "position 3 is 0.2 m, behind 0.2 m of the one before; permitted are positions",
        ),
        ({"positions": [0.0, 1.0]}, "there are 3 profiles for 2 positions; permitted is one each"),
        (
            {"places": [[0.0, 0.0]]},
            r"places has the shape \(1, 2\); permitted are finite numbers \(3, 2\) in m",
        ),
        ({"places": np.full((3, 2), np.inf)}, "and values that are not finite"),
        (
            {"profiles": [RAIL, standard_profile("S1002"), RAIL]},
            r"slice 2 at 0.1 m is a wheel profile \(S1002\)",
        ),
        ({"profiles": [RAIL, 7.0, RAIL]}, r"slice 2 at 0.1 m is (float|an array)"),
        ({"profiles": [RAIL, "UIC60", RAIL]}, "slice 2 at 0.1 m is str; permitted are a Profile or points"),
        ({"profiles": [RAIL, np.zeros((3, 2)), RAIL]}, r"slice 2 at 0.1 m is an array of shape \(3, 2\)"),
        (
            {"profiles": [RAIL, np.full((9, 2), np.nan), RAIL]},
            "slice 2 at 0.1 m has a point 1 that is not finite",
        ),
        (
            {"profiles": [RAIL, np.column_stack([np.r_[0.0:0.03:30j, 0.02], np.zeros(31)]), RAIL]},
            "slice 2 at 0.1 m folds back or is steeper than 88.9 deg at y = ",
        ),
        (
            {"features": [[0.0, 0.05]]},
            r"features has the shape \(1, 2\); permitted are lengths in m, \(3, 2 or more\)",
        ),
        ({"features": [[0.0, 0.05], [0.0], [0.0, 0.05]]}, "features has the shape"),
        (
            {"features": [[0.0, 0.05], [0.0, np.nan], [0.0, 0.05]]},
            "slice 2 at 0.1 m has a feature that is not a finite",
        ),
        (
            {"features": [[0.0, 0.05], [-1.0, 0.05], [0.0, 0.05]]},
            "slice 2 at 0.1 m does not have feature 1; permitted",
        ),
        (
            {"features": [[0.0, 0.05], [0.05, 0.04], [0.0, 0.05]]},
            "slice 2 at 0.1 m: feature 2 at 40 mm does not lie behind feature 1 at 50 mm, where the section is",
        ),
        (
            {
                "positions": [0.0, 0.1, 0.2, 0.3],
                "profiles": [RAIL] * 4,
                "features": [[0.0, 0.08], [0.05, 0.0502], [0.05, 0.0502], [0.0, 0.08]],
            },
            "lines of equal share cross between the positions 0.1 and 0.2 m; permitted are sections",
        ),
    ],
)
def test_sections_that_cannot_be_used_are_refused_in_one_sentence(changes, sentence):
    given = {"positions": [0.0, 0.1, 0.2], "profiles": [RAIL] * 3, **changes}
    with warnings.catch_warnings(), pytest.raises(ValueError, match=sentence) as raised:
        warnings.simplefilter("ignore", ProfileWarning)
        RailSections(**given, name="own")
    assert str(raised.value).startswith("rail sections own") and "\n" not in str(raised.value)
