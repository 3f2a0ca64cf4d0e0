"""Runs to a mileage: steps, interruption, data set, pictures, and the command line."""

import json

import numpy as np
import pytest

import wrcontact
from tests.helpers.wear_cases import energy, poses, system, table
from wrcontact import plots
from wrcontact.cli.tables import write_table
from wrcontact.results.convert import columns_of
from wrcontact.wear.run import profiles_of


def simulate(worn):
    inputs, share = poses()
    return worn.evaluate_many(**inputs), share


def simulate_few(worn):
    """Every third pose stands for three."""
    inputs, share = poses()
    few = {name: values[::3] for name, values in inputs.items()}
    return worn.evaluate_many(**few), share[::3] / share[::3].sum()


def deepest(run):
    """Distance [m] over the depth [m] at the deepest place."""
    y = np.linspace(-45e-3, 45e-3, 1801)
    depths = np.cumsum([np.interp(y, *step.depth["right"]) for step in run.steps[:-1]], axis=0)
    return np.concatenate([[0.0], depths.max(axis=1)])


def distance_to(run, depth):
    return float(np.interp(depth, deepest(run), run.distance))


@pytest.mark.full
def test_half_the_step_is_the_same_run():
    """3 % in the distance to 0.3 mm, and no waves on the tread."""
    runs = [
        wrcontact.wear_run(simulate, system(), wrcontact.Usfd(), 2750e3, step, mirrored=True)
        for step in (1e-4, 0.5e-4)
    ]
    whole, half = (distance_to(run, 0.3e-3) for run in runs)
    assert deepest(runs[0])[-1] > 0.3e-3
    assert whole == pytest.approx(half, rel=0.03)
    y = np.linspace(-30e-3, 30e-3, 3001)
    for run in runs:
        assert run.shape("curvature").max() < 2.0 * run.shape("curvature")[0]
        assert run.distance[-1] == pytest.approx(2750e3, rel=1e-12)
        assert run.shape("flange_thickness")[-1] < run.shape("flange_thickness")[0] - 0.03e-3
        assert run.profiles("left")[-1].zones == run.profiles("right")[-1].zones  # mirrored
    taken = sum(step.taken["right"] for step in runs[1].steps)
    lost = np.trapezoid(runs[1].profiles()[0].height(y) - runs[1].profiles()[-1].height(y), y)
    inside = (
        sum(
            np.sum(np.where(np.abs(step.depth["right"][0]) < 30e-3, step.depth["right"][1], 0.0))
            for step in runs[1].steps
        )
        * 0.25e-3
    )
    assert taken == pytest.approx(runs[1].shape("worn_area")[-1], rel=1e-12)
    assert lost == pytest.approx(inside, rel=0.02)


def test_the_middle_of_a_step_is_half_worn():
    """With the same contacts in both halves, each point has moved half of its way there."""
    inputs, share = poses()
    same, seen = (
        (system().evaluate_many(**{name: values[::3] for name, values in inputs.items()}), share[::3]),
        [],
    )

    def simulate_same(worn):
        seen.append(profiles_of(worn, "wheel")["right"])
        return same

    run = wrcontact.wear_run(simulate_same, system(), energy, 1e5, mirrored=True)
    y = np.linspace(-30e-3, 30e-3, 601)
    new, middle, worn = (profile.height(y) for profile in (*seen[:2], run.profiles()[-1]))
    assert len(run.steps) == 2 and np.max(new - worn) > 1e-6
    # [m] the second half's depth is that of the contacts on the profile that is half worn
    np.testing.assert_allclose(new - middle, 0.5 * (new - worn), rtol=0, atol=0.02 * np.max(new - worn))


@pytest.mark.full
def test_an_interrupted_run_goes_on(tmp_path):
    calls = []

    def breaks(worn):
        calls.append(worn)
        if len(calls) == 3:
            raise KeyboardInterrupt
        return simulate_few(worn)

    given, once = (system(), energy, 2e6, 0.5e-4), {"method": "euler", "store": tmp_path}
    whole = wrcontact.wear_run(simulate_few, *given, method="euler")
    with pytest.raises(KeyboardInterrupt):
        wrcontact.wear_run(breaks, *given, **once)
    assert len(list(tmp_path.glob("step_*.json"))) == 2
    rest = wrcontact.wear_run(breaks, *given, **once)
    assert len(calls) == 3 + len(whole.steps) - 1 - 2
    for one, other in zip(whole.steps, rest.steps, strict=True):
        assert one.distance == other.distance and one.shapes == other.shapes
        assert one.profiles["right"].zones == other.profiles["right"].zones
        assert one.profiles["left"].zones == other.profiles["left"].zones
    before = len(calls)
    longer = wrcontact.wear_run(breaks, system(), energy, 2.2e6, 0.5e-4, **once)
    assert len(calls) == before + 1 and longer.distance[-1] == pytest.approx(2.2e6)
    for wrong, words in (
        ((system(), energy, 2.2e6, 1e-4), "which has another run"),
        ((system(), energy, 1e6, 0.5e-4), "mileage is 1e.06 and the store has"),
    ):
        with pytest.raises(ValueError, match=words):
            wrcontact.wear_run(breaks, *wrong, **once)


def test_rails_wear_by_passages_and_keep_their_top():
    run = wrcontact.wear_run(simulate, system(), energy, 5e5, part="rail", mirrored=True, method="euler")
    worn = run.profiles()[-1]
    y = np.linspace(-30e-3, 30e-3, 6001)
    assert worn.height(y).min() == pytest.approx(0.0, abs=1e-9)
    assert worn.height(0.0) == pytest.approx(0.0, abs=1e-9)
    work = (
        sum(np.sum(poses()[1] * getattr(table(), side).friction_power / 20.0) for side in ("left", "right"))
        / 2
    )
    first = run.steps[0]
    assert 7850.0 * first.taken["right"] / first.length == pytest.approx(1e-9 * work, rel=1e-9)
    assert np.all(np.isnan(run.conicity)) and run.shape("worn_area")[-1] > 1e-6


def test_sections_and_own_wears_are_the_same():
    """A list of tables with distances, and a Wear to which the same was added."""
    inputs, share = poses()
    parts = [
        (system().evaluate_many(**{name: values[some] for name, values in inputs.items()}), share[some])
        for some in (slice(0, 20), slice(20, 60))
    ]

    def filled(worn):
        wear = wrcontact.Wear(worn, energy)
        wear.add(*simulate(worn))
        return wear

    runs = [
        wrcontact.wear_run(function, system(), energy, 1e4, method="euler")
        for function in (simulate, filled, lambda worn: parts)
    ]
    for run in runs[1:]:
        assert run.shape("worn_area") == pytest.approx(runs[0].shape("worn_area"), rel=1e-12)


@pytest.mark.full  # README's command installs none of the tables' packages
def test_the_data_set_has_the_run():
    pytest.importorskip("xarray")
    run = wrcontact.wear_run(simulate, system(), wrcontact.Usfd(), 4e5, mirrored=True)
    data = run.to_xarray()
    assert dict(data.sizes)["step"] == len(run.steps) and data.height.attrs["units"] == "m"
    place, whole = data.place.values, run.profiles("left")[0]
    for room in (place[0] - whole.start, whole.stop - place[-1]):  # every 0.2 mm, from end to end
        assert -1e-12 < room < 0.2e-3 - 1e-9
    assert data.height.sel(side="left")[-1].values == pytest.approx(
        run.profiles("left")[-1].height(place), nan_ok=True
    )
    assert data.flange_thickness.sel(side="right").values == pytest.approx(run.shape("flange_thickness"))
    assert data.distance.values[-1] == pytest.approx(4e5)


@pytest.mark.parametrize(
    "given, words",
    [
        ({"simulate": 3}, "simulate is 3; permitted is a function of a system"),
        ({"mileage": 0.0}, "mileage is 0.0; permitted is mileage > 0"),
        ({"depth_step": 0.1}, "depth_step is 0.1 m; permitted is 1e-06 ... 0.001 m"),
        ({"part": "axle"}, "part is 'axle'"),
        ({"method": "heun"}, "method is 'heun'; permitted are 'midpoint', 'euler'"),
        ({"folder": "x"}, "a keyword of wear_run is 'folder'; permitted are 'method', 'mirrored'"),
    ],
)
def test_wrong_runs_are_refused(given, words):
    with pytest.raises(ValueError, match=words):
        wrcontact.wear_run(system=system(), law=energy, **{"simulate": simulate, "mileage": 1e3, **given})


def test_pictures_show_what_there_is():
    run = wrcontact.wear_run(simulate, system(), wrcontact.Usfd(), 4e5, mirrored=True)
    assert tuple(run) == run.steps
    for wrong, words in (
        (lambda: run.profiles("top"), "side is 'top'; permitted are 'left', 'right'"),
        (lambda: run.shape("thickness"), "name is 'thickness'; .* did you mean flange_thickness"),
    ):
        with pytest.raises(ValueError, match=words):
            wrong()
    figure = plots.wear_figure(run)
    titles = [panel.get_title(loc="left") for panel in figure.axes]
    assert {"right wheel, depth enlarged 10 times", "Change of dimensions"} <= set(titles)
    area = next(panel for panel in figure.axes if panel.get_title(loc="left") == "Worn cross-section")
    assert area.lines[0].get_ydata()[-1] == pytest.approx(run.shape("worn_area", "left")[-1] * 1e6)
    wear = wrcontact.Wear(system(), wrcontact.Usfd())
    wear.add(*simulate(system()))
    depth = plots.wear_depth_figure(wear, 1e5).axes[0].lines[1]
    assert depth.get_ydata().max() == pytest.approx(wear.smooth_depth("right.wheel", 1e-3).max() * 1e8)
    found = wrcontact.fatigue(table(), yield_shear=300e6)
    shown = plots.shakedown_figure(table(), yield_shear=300e6).axes[0].collections
    assert sum(len(one.get_offsets()) for one in shown) == np.isfinite(found.shakedown_ratio).sum()
    bars = plots.fatigue_figure(found).axes[0].patches
    assert sum(bar.get_height() for bar in bars) == pytest.approx(np.nansum(found.damage), rel=1e-9)


# --- the command line -------------------------------------------------------------------------------------


@pytest.fixture
def results(tmp_path):
    """A file as an FMU's results."""
    columns = columns_of(table())
    columns["time"] = np.arange(60.0)
    write_table(tmp_path / "results.csv", columns)
    return tmp_path / "results.csv"


def test_the_command_writes_a_worn_profile_and_a_picture(run, results):
    worn = results.with_name("worn.json")
    code, out, error = run("wear", results, "--distance-km", 300, "--output", worn, "--plot")
    assert (code, error) == (0, "")
    wear = wrcontact.Wear(wrcontact.ContactSystem(), wrcontact.Usfd())
    wear.add_fmu(results)
    depth = wear.smooth_depth("right.wheel", 1e-3).max() * 300e3
    assert f"{1e3 * depth:.3f} ±" in out and "flange thickness Sd" in out and "worn in regime mild" in out
    y = np.linspace(-45e-3, 45e-3, 901)
    profile = wrcontact.ContactSystem(wheel=worn).wheel
    assert profile.height(y) == pytest.approx(wear.worn("right.wheel", 300e3).height(y), abs=1e-15)
    assert (
        json.loads(worn.read_text())["kind"] == "wheel" and results.with_name("worn.png").stat().st_size > 1e4
    )


@pytest.mark.parametrize(
    "words, sentence",
    [
        (
            ("--law", "archad"),
            "--law is 'archad'; permitted are usfd, archard, british-rail, zobory; did you mean archard?",
        ),
        (
            ("--law", "zobory"),
            "Zobory needs mild, severe and limit; they have no default, since no source of them was "
            "read; give each by --constant NAME=VALUE",
        ),
        (
            ("--constant", "mld=1"),
            "--constant is 'mld=1'; permitted is NAME=VALUE, of usfd with the names calibration",
        ),
        (("--distance-km", "-5"), "--distance-km is -5; permitted is distance > 0"),
        (("--distance-km", "1e9"), "--distance-km is 1e+09, which takes"),
        (("--part", "axle"), "--part is 'axle'; permitted are 'left.wheel'"),
        (("--output", "worn.csv"), "--output is 'worn.csv'; permitted is a file that ends in .json"),
        (("--distance-column", "way"), "has no column 'way'"),
    ],
)
def test_the_command_says_what_is_wrong(run, results, words, sentence):
    code, _, error = run("wear", results, *words)
    assert code == 2 and sentence in error and error.count("\n") == 1
