"""Irregularities and curves.

Witnesses: closed integrals of the spectra, periodograms of scipy, printed values of another program's manual, Fresnel's
integrals, and the symmetry of the rails.
"""

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.signal import welch
from scipy.special import fresnel

import wrcontact
from wrcontact import track
from wrcontact.track.spectra import QUANTITIES

NAMES = tuple(track.SPECTRA)


def test_european_spectra_are_those_of_the_gensys_manual():
    """TRC_IPSD prints ORE B176 high over waves per metre [m2/(1/m)]: lateral and vertical at 314.16, 50 and 10 m."""
    high = track.spectrum("ERRI high")
    for wave, lateral, vertical in (
        (0.02, 4.6657e-3, 8.2268e-3),
        (2 * np.pi * 0.02, 2.3194e-4, 4.0897e-4),
        (2 * np.pi * 0.1, 6.1608e-6, 1.0863e-5),
    ):
        assert 2 * np.pi * high.lateral(wave) == pytest.approx(lateral, rel=5e-3)
        assert 2 * np.pi * high.vertical(wave) == pytest.approx(vertical, rel=5e-3)


@pytest.mark.parametrize("level, size", [("low", 4.032e-7), ("high", 1.08e-6)])
def test_variance_has_a_closed_form(level, size):
    """Partial fractions of A c^2 / ((W^2 + r^2) (W^2 + c^2)), two arctangents."""
    c, r = 0.8246, 0.0206
    ends = 2 * np.pi / np.array([150.0, 3.0])
    inner = np.arctan(ends / r) / r - np.arctan(ends / c) / c
    wanted = size * c**2 / (c**2 - r**2) * (inner[1] - inner[0])
    assert track.spectrum(f"ERRI {level}").variance("vertical", 150.0, 3.0) == pytest.approx(
        wanted, rel=1e-10
    )


@pytest.mark.parametrize("number, size", [(1, 1.2107), (6, 0.0339)])
def test_variance_of_american_track(number, size):
    """0.25 A c^2 / (W^2 (W^2 + c^2)): -1 / W - arctan(W / c) / c, with A in cm2 rad/m."""
    c, ends = 0.8245, 2 * np.pi / np.array([100.0, 2.0])
    inner = -1.0 / ends - np.arctan(ends / c) / c
    wanted = 0.25e-4 * size * (inner[1] - inner[0])
    assert track.spectrum(f"fra {number}").variance("vertical", 100.0, 2.0) == pytest.approx(
        wanted, rel=1e-10
    )
    assert track.spectrum(f"AAR {number}") is track.spectrum(f"FRA {number}")


def test_american_track_beside_another_text():
    """Fryba (1996), A b^2 (f^2 + a^2) / (f^4 (f^2 + b^2)) over waves per metre, as TTB-2D quotes it: the corner b is the
    same, deviations of waves of 3 ... 25 m are 3 ... 8 times smaller."""
    a, b = 23.3e-3, 13.1e-2
    assert 2.0 * np.pi * b == pytest.approx(0.8245, rel=3e-3)
    sizes = np.array([15.53, 8.85, 4.92, 2.75, 1.57, 0.98]) * 1e-8
    variance = quad(lambda f: b**2 * (f**2 + a**2) / (f**4 * (f**2 + b**2)), 1 / 25.0, 1 / 3.0)[0]
    found = [track.spectrum(f"FRA {number}").variance("vertical", 25.0, 3.0) for number in range(1, 7)]
    ratio = np.sqrt(np.array(found) / (sizes * variance))
    assert ((ratio > 3.4) & (ratio < 8.3)).all(), ratio
    assert 1e3 * np.sqrt([found[5], sizes[5] * variance]) == pytest.approx([1.43, 0.41], abs=5e-3)


def test_powers_meet_at_their_ends():
    """The pieces of the Chinese spectra meet to 8 %, as their constants are printed."""
    china = track.spectrum("china ballastless")
    for quantity, ends in (
        ("lateral", (0.0450, 0.1234)),
        ("vertical", (0.0187, 0.0474, 0.1533)),
        ("cross_level", (0.0258, 0.1163)),
        ("gauge", (0.1090, 0.2938)),
    ):
        for end in ends:
            below, above = getattr(china, quantity)(2 * np.pi * end * np.array([1 - 1e-9, 1 + 1e-9]))
            assert below == pytest.approx(above, rel=0.08), (quantity, end)
    # f^-n over 1/m in mm2, by its antiderivative, in the last piece
    a, n, ends = 3.9488e-4, 3.4516, np.array([0.2, 0.5])
    wanted = 1e-6 * a * (ends[0] ** (1 - n) - ends[1] ** (1 - n)) / (n - 1)
    assert china.variance("vertical", 5.0, 2.0) == pytest.approx(wanted, rel=1e-9)


@pytest.mark.parametrize("name", NAMES)
def test_orders_of_size(name):
    """Standard deviations of waves of 3 ... 25 m (EN 13848's D1) are tenths of a millimetre to centimetres; FRA 1 is the
    roughest, and classes fall."""
    kind = track.spectrum(name)
    for quantity in QUANTITIES:
        deviation = kind.variance(quantity, 25.0, 3.0) ** 0.5
        assert 5e-5 < deviation < 2e-2, (quantity, deviation)
        check = quad(getattr(kind, quantity), 2 * np.pi / 25.0, 2 * np.pi / 3.0, limit=200)[0] ** 0.5
        assert deviation == pytest.approx(check, rel=1e-3)
    assert kind.source


def test_a_generated_track_has_its_spectrum():
    """By Welch's periodogram with windows of 512 m, 62 of them with half of each overlapping: 12 % of scatter for each wave
    number, 5 sigma, and what a window of Hann leaks where the spectrum is steep; the mean of all within 2 %."""
    made = track.generate("ERRI high", 16384.0, step=0.5, seed=3)
    for quantity in QUANTITIES:
        f, found = welch(getattr(made, quantity), fs=2.0, nperseg=1024, detrend=False)
        inside = (f > 1 / 100.0) & (f < 1 / 4.0)
        wanted = 2 * np.pi * getattr(track.spectrum("ERRI high"), quantity)(2 * np.pi * f[inside])
        ratio = found[inside] / wanted
        assert abs(ratio - 1.0).max() < 0.65, (quantity, ratio.min(), ratio.max())
        assert np.median(ratio) == pytest.approx(1.0, abs=0.04), quantity


def test_variance_of_a_generated_track():
    """The sum of the waves' variances, which is the integral to what the first few waves leave."""
    made = track.generate("FRA 5", 4096.0, seed=8, longest=100.0, shortest=2.0)
    for quantity in QUANTITIES:
        values = getattr(made, quantity)
        assert values.mean() == pytest.approx(0.0, abs=1e-12)
        assert values.var() == pytest.approx(track.spectrum("FRA 5").variance(quantity, 100.0, 2.0), rel=0.02)
    # no waves beyond the band
    power = abs(np.fft.rfft(made.lateral)) ** 2
    waves = np.fft.rfftfreq(len(made.lateral), 0.25)
    assert power[(waves < 0.99 / 100.0) | (waves > 1.01 / 2.0)].max() < 1e-20 * power.max()


def test_seeds():
    one, same, other = (track.generate("ERRI low", 300.0, seed=seed) for seed in (4, 4, 5))
    assert (one.lateral == same.lateral).all() and not np.allclose(one.lateral, other.lateral)
    found = np.corrcoef(
        [getattr(track.generate("ERRI low", 20000.0, longest=20.0), name) for name in QUANTITIES]
    )
    assert abs(found - np.eye(4)).max() < 0.1


def made_of(**quantities):
    distance = np.arange(0.0, 50.0, 0.25)
    zeros = np.zeros_like(distance)
    return track.Irregularities(distance, **{name: quantities.get(name, zeros) for name in QUANTITIES})


def test_rails_of_a_track():
    """A wider gauge moves rails outwards, a cross level lowers the right one; both as evaluate sees them."""
    distance = np.arange(0.0, 50.0, 0.25)
    ones = np.ones_like(distance)
    rails = made_of(gauge=4e-3 * ones, cross_level=2e-3 * ones).inputs(10.0)
    assert rails["left_rail_lateral"] == pytest.approx(-2e-3) and rails[
        "right_rail_lateral"
    ] == pytest.approx(2e-3)
    assert rails["left_rail_vertical"] == pytest.approx(-1e-3) and rails[
        "right_rail_vertical"
    ] == pytest.approx(1e-3)
    system = wrcontact.ContactSystem()
    state, plain = system.evaluate(**rails), system.evaluate()
    assert state.roll - plain.roll == pytest.approx(2e-3 / 1.5, rel=0.02)
    wide = wrcontact.ContactSystem(gauge=1.439).evaluate()
    narrow = system.evaluate(**made_of(gauge=4e-3 * ones).inputs(10.0))
    assert narrow.right.contact.y_wheel == pytest.approx(wide.right.contact.y_wheel, abs=1e-7)
    moved = system.evaluate(3e-3, **made_of(lateral=3e-3 * ones).inputs(10.0))
    assert moved.right.contact.y_wheel == pytest.approx(plain.right.contact.y_wheel, abs=1e-9)


def test_velocities_are_speed_times_slope():
    distance = np.arange(0.0, 50.0, 0.25)
    wave = 2 * np.pi / 12.0
    made = made_of(lateral=2e-3 * np.sin(wave * distance), vertical=1e-3 * np.cos(wave * distance))
    where = np.array([[11.1, 20.0], [33.3, 40.0]])
    found = made.inputs(where, moving_at=30.0)
    assert set(found) < {row.keyword for row in wrcontact.interface.inputs.INPUTS}
    np.testing.assert_allclose(found["right_rail_lateral"], 2e-3 * np.sin(wave * where), atol=1e-8)
    np.testing.assert_allclose(
        found["left_rail_lateral_velocity"], 30.0 * 2e-3 * wave * np.cos(wave * where), atol=1e-5
    )
    np.testing.assert_allclose(
        found["left_rail_vertical_velocity"], -30.0 * 1e-3 * wave * np.sin(wave * where), atol=1e-5
    )
    with pytest.raises(ValueError, match="distance is 49 ... 51 m; permitted are 0 ... 49.75 m"):
        made.inputs([49.0, 51.0])


def test_tables_take_it():
    rails = track.generate("ERRI high", 400.0, seed=2).inputs(np.arange(50.0, 60.0, 0.5))
    table = wrcontact.ContactSystem().evaluate_many(0.0, **rails)
    assert len(table) == 20 and (table.status == 0).all() and np.ptp(table.roll) > 1e-5


# --- measured -----------------------------------------------------------------------------------------------


def test_files_come_back(tmp_path):
    made = track.generate("ERRI high", 100.0, seed=7, longest=50.0)
    made.save(tmp_path / "track.csv")
    back = track.read_irregularities(tmp_path / "track.csv")
    for name in ("distance", *QUANTITIES):
        np.testing.assert_allclose(getattr(back, name), getattr(made, name), rtol=0, atol=1e-15)


def written(folder, heading, rows):
    path = folder / "measured.csv"
    path.write_text(
        heading + "\n" + "\n".join(",".join(map(str, row)) for row in rows) + "\n", encoding="utf-8"
    )
    return path


HEADING = "# car 7\nDistance [km],gauge (mm),Cross level [mm],vertical,lateral [cm],speed"
ROWS = [[12.0 + 2.5e-4 * k, 1437.0 + k, -k, 3.0, 0.1 * k, 80] for k in range(8)]


def test_units_and_a_gauge_itself(tmp_path):
    found = track.read_irregularities(written(tmp_path, HEADING, ROWS), units={"vertical": "mm"})
    np.testing.assert_allclose(found.distance, 12000.0 + 0.25 * np.arange(8))
    np.testing.assert_allclose(found.gauge, 2e-3 + 1e-3 * np.arange(8))
    np.testing.assert_allclose(found.cross_level, -1e-3 * np.arange(8))
    np.testing.assert_allclose(found.lateral, 1e-3 * np.arange(8), atol=1e-15)
    assert (found.vertical == 3e-3).all()


def test_uneven_steps_and_gaps(tmp_path):
    rows = [row for k, row in enumerate(ROWS) if k != 4]
    path = written(tmp_path, HEADING, rows)
    with pytest.raises(ValueError, match="gap of 0.5 m at 12000.8 m, where steps are 0.25 m"):
        track.read_irregularities(path, units={"vertical": "mm"})
    found = track.read_irregularities(path, units={"vertical": "mm"}, longest_gap=0.6)
    assert len(found.distance) == 8 and found.gauge[4] == pytest.approx(6e-3)


@pytest.mark.parametrize(
    "change, words",
    [
        (lambda heading, rows: (heading, rows), "column 'vertical' .* has the unit None"),
        (lambda heading, rows: (heading.replace("gauge", "width"), rows), "no column 'gauge'"),
        (lambda heading, rows: (heading.replace("(mm)", "(in)"), rows), "has the unit 'in'"),
        (
            lambda heading, rows: (heading.replace("lateral [cm]", "lateral [m]"), rows),
            "lateral .* is its unit right",
        ),
        (lambda heading, rows: (heading, rows[:2]), "3 lines"),
        (lambda heading, rows: (heading, [*rows, ["x"] * 6]), "no number"),
        (lambda heading, rows: (heading, [*rows, [13.0, 1437, 0, "nan", 0, 0]]), "not finite in point 9"),
        (lambda heading, rows: (heading, rows[::-1]), "does not rise"),
    ],
)
def test_wrong_files_are_refused(tmp_path, change, words):
    heading, rows = change(HEADING, ROWS)
    units = None if "unit None" in words else {"vertical": "mm"}
    with pytest.raises(ValueError, match=words):
        track.read_irregularities(written(tmp_path, heading, rows), units=units)


@pytest.mark.parametrize(
    "given, words",
    [
        ({"name": "FRA 7"}, "spectrum is 'FRA 7'"),
        ({"length": 0.0}, "length is 0.0"),
        ({"step": 2.0}, "two steps"),
        ({"longest": 500.0}, "the length of the track"),
    ],
)
def test_wrong_tracks_are_refused(given, words):
    with pytest.raises(ValueError, match=words):
        track.generate(**{"name": "ERRI low", "length": 300.0, **given})


# --- curves -------------------------------------------------------------------------------------------------


def test_a_transition_is_a_clothoid():
    """Fresnel's integrals: heading W^2 / (2 R T) along the first transition."""
    curve = track.Curve(radius=300.0, transition=60.0, length=100.0, start=20.0, cant=0.1)
    way = np.array([0.0, 13.0, 37.0, 60.0])
    scale = np.sqrt(np.pi * 300.0 * 60.0)
    sine, cosine = fresnel(way / scale)
    x, y = curve.position(20.0 + way)
    np.testing.assert_allclose(x, scale * cosine, atol=1e-10)
    np.testing.assert_allclose(y, scale * sine, atol=1e-10)


def test_curvature_heading_and_position_belong_together():
    curve = track.Curve(radius=-200.0, transition=40.0, length=70.0, start=10.0, cant=0.12)
    where = np.array([5.0, 25.0, 60.0, 130.0, 155.0, 200.0])
    step = 1e-3
    turned = (curve.heading(where + step) - curve.heading(where - step)) / (2 * step)
    np.testing.assert_allclose(turned, curve.curvature(where), atol=1e-9)
    assert curve.curvature(60.0) == -1 / 200.0 and curve.curvature(30.0) == pytest.approx(-1 / 400.0)
    assert curve.heading(1e3) == pytest.approx(-(70.0 + 40.0) / 200.0)
    np.testing.assert_allclose(curve.cant_at(where), -curve.curvature(where) * 200.0 * 0.12)
    ahead, behind = (np.array(curve.position(where + way * step)) for way in (1.0, -1.0))
    np.testing.assert_allclose(np.hypot(*(ahead - behind)), 2 * step, rtol=1e-5)
    # the full curve is an arc
    a, b, c = (np.array(curve.position(s)) for s in (55.0, 80.0, 105.0))
    sides = [np.linalg.norm(one - other) for one, other in ((a, b), (b, c), (a, c))]
    (p, q), (r, s) = b - a, c - a
    assert np.prod(sides) / (2 * abs(p * s - q * r)) == pytest.approx(200.0, rel=1e-9)
    assert (
        wrcontact.ContactSystem().evaluate(speed=20.0, track_curvature=float(curve.curvature(60.0))).status
        == 0
    )


@pytest.mark.parametrize("given", [{"radius": 5.0}, {"transition": 0.0}, {"length": -1.0}, {"cant": 100.0}])
def test_wrong_curves_are_refused(given):
    with pytest.raises(ValueError, match=next(iter(given))):
        track.Curve(**{"radius": 300.0, "transition": 50.0, "length": 100.0, **given})
