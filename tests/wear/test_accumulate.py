"""Wear from tables and files: nothing is lost between the strips and the bins, and bad input is refused."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.wear_cases import (
    ARCHARD,
    BRITISH_RAIL,
    MODELS,
    energy,
    mirrored,
    poses,
    system,
    table,
)
from wrcontact.profiles.compiled import ends, evaluate_table
from wrcontact.results.convert import columns_of
from wrcontact.wear.accumulate import PARTS
from wrcontact.wear.bins import Arc, deposit

SIDES = ("left", "right")


def worn_by(law, **options):
    wear = wrcontact.Wear(system(), law, **options)
    wear.add(table(), poses()[1])
    return wear


@pytest.mark.parametrize("part", ["wheel", "rail"])
@pytest.mark.parametrize("side", SIDES)
def test_worn_mass_is_the_friction_work_s(side, part):
    """A law of energy takes k times the mean friction power over the speed, to rounding."""
    share = poses()[1]
    work = np.sum(share * getattr(table(), side).friction_power / 20.0) / np.sum(share)  # [J/m]
    assert worn_by(energy).mass(f"{side}.{part}") == pytest.approx(1e-9 * work, rel=1e-12)


def test_a_wheel_s_depth_is_that_of_passages_over_its_circumference():
    wear = worn_by(energy)
    wheel, rail = wear.depth("right.wheel")[1], wear.depth("right.rail")[1]
    turned = wheel.sum() * wear.arcs["right.wheel"].width * 2 * np.pi * 0.46
    assert turned == pytest.approx(rail.sum() * wear.arcs["right.rail"].width, rel=1e-12)


def test_stretches_are_shared_among_bins_without_loss():
    arc, draw = Arc(system().wheel), np.random.default_rng(3)
    start = draw.uniform(-1e-3, arc.s[-1], 5000)
    length, amount = 10 ** draw.uniform(-9, -2.2, 5000), draw.uniform(0.0, 1.0, 5000)
    rows = draw.integers(7, size=5000)
    sums = deposit(arc, start, start + length, amount, rows, 7)
    for row in range(7):
        assert sums[row].sum() == pytest.approx(amount[rows == row].sum(), rel=1e-12)
    # the mean place of what one stretch leaves is its middle
    one = deposit(arc, np.array([0.0301]), np.array([0.0337]), np.array([2.0]), np.array([0]), 1)[0]
    assert one @ arc.middles / 2.0 == pytest.approx(0.0319, abs=0.02e-3)
    assert one.max() == pytest.approx(2.0 * arc.width / 0.0036, rel=1e-9)


@pytest.mark.parametrize("inclination", [0.0, 1 / 40, 1 / 20])
def test_places_on_a_rail_are_those_of_the_inclined_head(inclination):
    """The arc of the upright profile, turned, is the kernel's own table of the inclined rail."""
    kernel = wrcontact.ContactSystem(rail_inclination=inclination)
    arc, rail = Arc(kernel.rail, inclination), kernel.profile_tables()[1]
    angle, (start, stop) = np.arctan(inclination), ends(rail)
    height = np.cos(angle) * arc.height - np.sin(angle) * arc.y
    inside = (arc.abscissa > start + 1e-4) & (arc.abscissa < stop - 1e-4)
    assert inside.sum() > 5000
    found = evaluate_table(rail, arc.abscissa[inside])[0]
    assert found == pytest.approx(height[inside] - height.min(), abs=1e-9)


def test_strips_lie_where_the_stations_have_their_power():
    """The centre of friction of a patch by strips and by stations."""
    strips, stations = worn_by(energy), wrcontact.Wear(system(), energy)
    stations.add_fmu(columns_of(table()), distance=poses()[1])
    for part in PARTS:
        arc, depths = strips.arcs[part], (strips.depth(part)[1], stations.depth(part)[1])
        middle = [depth @ arc.middles / depth.sum() for depth in depths]
        assert middle[0] == pytest.approx(middle[1], abs=0.03e-3), part
        # 31 stations are 1 mm and more apart where two patches are
        smooth = [wear.smooth_depth(part, 1e-3) for wear in (strips, stations)]
        assert np.abs(smooth[1] - smooth[0]).max() < 0.05 * smooth[0].max(), part


def test_a_file_of_an_fmu_has_the_same_mass(tmp_path):
    """Friction work of the stations is that of the strips to rounding; the laws' nonlinearity is 0.2 %."""
    columns = columns_of(table())
    columns["distance"] = np.cumsum(poses()[1])
    file = tmp_path / "result.csv"
    file.write_text(
        ",".join(columns)
        + "\n"
        + "\n".join(",".join(repr(float(cell)) for cell in row) for row in zip(*columns.values()))
    )
    for law, bound in (
        (energy, 1e-9),
        (wrcontact.Usfd(), 3e-3),
        (wrcontact.BritishRail(**BRITISH_RAIL), 1e-9),
    ):
        read, direct = wrcontact.Wear(system(), law), wrcontact.Wear(system(), law)
        read.add_fmu(file, distance=poses()[1])
        direct.add(table(), poses()[1])
        assert read.mass("right.wheel") == pytest.approx(direct.mass("right.wheel"), rel=bound), law
    along, steps = wrcontact.Wear(system(), energy), np.diff(columns["distance"])
    along.add_fmu(file, distance_column="distance")
    half = 0.5 * (np.append(steps, 0) + np.insert(steps, 0, 0))
    assert along.distance == pytest.approx(steps.sum(), rel=1e-12)
    assert along.mass("left.wheel") == pytest.approx(
        1e-9 * half @ table().left.friction_power / 20.0 / steps.sum(), rel=1e-9
    )


@pytest.mark.full
def test_results_of_the_native_fmu_wear_as_python_s(fmus, tmp_path):
    """fmpy runs the FMU along poses; its results, as fmpy returns and writes them, against evaluate_many."""
    fmpy = pytest.importorskip("fmpy")
    from fmpy.util import write_csv

    inputs, time = poses()[0], np.arange(60.0)
    given = [(name.replace("_friction", ".friction"), values) for name, values in inputs.items()]
    signals = np.rec.fromarrays(
        [time, *(values for _, values in given)], names=["time", *(n for n, _ in given)]
    )
    names = [name for name in columns_of(table()) if "patch[" in name or "[" in name or "power" in name]
    found = fmpy.simulate_fmu(
        str(fmus[2]),
        stop_time=59.0,
        step_size=1.0,
        output_interval=1.0,
        input=signals,
        start_values={"tangential_model": "strips", "normal_model": "analyn_strip", "wear_outputs": True},
        output=["speed", "status", "left.friction", "right.friction", *names],
    )
    write_csv(tmp_path / "result.csv", found)
    direct = wrcontact.Wear(system(), wrcontact.Usfd())
    # fmpy sets the inputs of a step at its beginning, and reads the results at its end
    shifted = table()[np.maximum(np.arange(60) - 1, 0)]
    direct.add_fmu(columns_of(shifted), distance=1.0)
    for results in (found, tmp_path / "result.csv"):
        wear = wrcontact.Wear(system(), wrcontact.Usfd())
        wear.add_fmu(results, distance=1.0)
        assert (wear.rows, wear.left_out) == (60, 0)
        for part in PARTS:
            depth = direct.depth(part)[1]
            assert wear.depth(part)[1] == pytest.approx(depth, rel=1e-6, abs=1e-6 * depth.max()), part


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_distance_counts_and_not_time(way):
    """Two poses, each for 0.5 s, at 10 and 30 m/s stand for 5 and 15 m, backwards too."""
    inputs = {name: values[[20, 45]] for name, values in poses()[0].items()}
    found = columns_of(system().evaluate_many(**{**inputs, "speed": [way * 10.0, way * 30.0]}))
    wear = wrcontact.Wear(system(), energy)
    wear.add_fmu({**found, "time": np.array([0.0, 1.0])})
    assert wear.distance == pytest.approx(20.0)
    each = found["right.friction_power"] / [10.0, 30.0]  # [J/m]
    assert wear.mass("right.wheel") == pytest.approx(1e-9 * (5.0 * each[0] + 15.0 * each[1]) / 20.0, rel=1e-9)


def test_mirror_images_wear_alike():
    inputs, share = poses()
    other = wrcontact.Wear(system(), wrcontact.Usfd())
    other.add(system().evaluate_many(**mirrored(inputs)), share)
    here = worn_by(wrcontact.Usfd())
    for part in ("wheel", "rail"):
        left, right = here.depth(f"left.{part}")[1], here.depth(f"right.{part}")[1]
        assert other.depth(f"right.{part}")[1] == pytest.approx(left, rel=1e-9, abs=1e-9 * left.max())
        both = worn_by(wrcontact.Usfd(), mirrored=True)
        assert both.depth(part)[1] == pytest.approx(0.5 * (left + right), rel=1e-12)
        assert both.depth(f"left.{part}")[1] == pytest.approx(both.depth(part)[1], rel=0)


def test_shares_are_those_of_the_mass():
    wear = worn_by(wrcontact.ArchardMap(**ARCHARD))
    shares = wear.shares("right.wheel")
    assert sum(shares.values()) == pytest.approx(1.0, rel=1e-12)
    assert list(shares) == ["slow", "middle", "fast", "pressed"]
    without = worn_by(wrcontact.ArchardMap(**{**ARCHARD, "middle": 0.0}))
    assert without.mass("right.wheel") == pytest.approx(
        (1 - shares["middle"]) * wear.mass("right.wheel"), rel=1e-9
    )


def test_the_bootstrap_has_the_spread_of_a_mean():
    """For rows of equal weight the standard error of a mean is that of a sum of independent rows."""
    wear = wrcontact.Wear(system(), energy)
    wear.add(table())
    power = table().right.friction_power / 20.0
    expected = 1e-9 * power.std() / np.sqrt(len(power))  # of the mass per metre
    draw = np.random.default_rng(0)
    added = wear.additions[0]
    sums = added.sums["right.wheel"].sum(axis=1)
    found = np.std([sums[draw.integers(60, size=60)].mean() for _ in range(2000)])
    assert found * 7850 == pytest.approx(expected, rel=0.05)
    error, depth = wear.error("right.wheel"), wear.depth("right.wheel")[1]
    assert np.all(error[depth == 0.0] == 0.0) and 0.05 < np.max(error) / np.max(depth) < 1.0


def test_rows_without_contact_are_left_out_and_counted():
    inputs = {name: np.concatenate([values, values[:4]]) for name, values in poses()[0].items()}
    inputs["lateral_shift"][-4:] = [np.nan, 0.3, np.nan, 0.3]
    wear = wrcontact.Wear(system(), energy)
    wear.add(system().evaluate_many(**inputs))
    assert (wear.rows, wear.left_out) == (60, 4)
    inputs["lateral_shift"][:4] = np.nan
    with pytest.raises(ValueError, match="8 of 64 rows of the table have a status other than 0 .* 10 %"):
        wear.add(system().evaluate_many(**inputs))


def few(**changes):
    inputs = {name: values[:3] for name, values in poses()[0].items()}
    return system().evaluate_many(**{**inputs, **changes})


NO_CREEP = wrcontact.ContactSystem(wear_outputs=True)


@pytest.mark.parametrize(
    "wrong, words",
    [
        (
            lambda wear: wear.add(NO_CREEP.evaluate_many([0.0], speed=20.0)),
            "has no creep forces; wear needs results",
        ),
        (
            lambda wear: wear.add(wrcontact.ContactSystem().evaluate_many([0.0])),
            "has no outputs of wear; wear needs",
        ),
        (lambda wear: wear.add(few(speed=[20.0, 0.0, 20.0])), "speed is 0 in row 1 of the table"),
        (lambda wear: wear.add(few(), distance=[1.0, -2.0, 1.0]), "distance is -2 m in a row"),
        (lambda wear: wear.add(few(), distance=0.0), "distance is 0 m in a row"),
        (lambda wear: wear.add(few(), distance=[1.0, 2.0]), "one for each of the 3 rows of the table"),
        (lambda wear: wear.add(few(), distance="far"), "distance is 'far'; permitted is one number"),
        (lambda wear: wear.add_fmu("nothing.csv"), "results is 'nothing.csv', and there is no such file"),
        (
            lambda wear: (wear.add(few()), wear.worn("right.wheel", "far")),
            "distance is 'far'; permitted is distance > 0",
        ),
        (lambda wear: wear.add_fmu({"speed": [1.0]}), "has no column 'right.power[1]'; wear needs results"),
        (lambda wear: wear.add_fmu({"time": [1.0]}), "the results has no column 'speed'"),
        (lambda wear: wear.add_fmu(columns_of(few())), "has no column 'time'"),
        (lambda wear: wear.add_fmu("result.xlsx"), "ends in '.xlsx'; permitted are .csv and .parquet"),
        (lambda wear: wear.depth("right.wheel"), "nothing has run yet"),
        (lambda wear: (wear.add(few()), wear.depth("wheel")), "part is 'wheel'; permitted are 'left.wheel'"),
        (
            lambda wear: (wear.add(few()), wear.worn("right.wheel", 0.0)),
            "distance is 0.0; permitted is distance > 0",
        ),
        (
            lambda wear: (wear.add(few()), wear.worn("right.wheel", 1e12)),
            "mm in one step; permitted are 2 mm",
        ),
        (
            lambda wear: (wear.add(few()), wear.worn("right.wheel", 1e6, smoothing=6e-3)),
            "smoothing is 0.006 m; permitted is 0 ... 0.005 m",
        ),
        (lambda wear: wrcontact.Wear(system(), "archard"), "law is 'archard'; permitted are Usfd()"),
        (
            lambda wear: wrcontact.Wear(system(), lambda power_density: -power_density).add(few()),
            "permitted are rates >= 0",
        ),
        (
            lambda wear: wrcontact.Wear(
                wrcontact.ContactSystem(("S1002", "cone20"), **MODELS), energy, mirrored=True
            ),
            "mirrored is True and the left side differs",
        ),
    ],
)
def test_bad_input_is_refused_in_a_sentence(wrong, words):
    with pytest.raises(ValueError) as refused:
        wrong(wrcontact.Wear(system(), energy))
    said = str(refused.value)
    assert words in said and "\n" not in said and len(said) < 400
