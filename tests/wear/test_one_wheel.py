"""Wear and fatigue of one wheel by itself: the numbers of that side of a wheelset, by names without it."""

from functools import cache

import numpy as np
import pytest

import wrcontact
from tests.helpers.wear_cases import MODELS, energy, poses, system
from wrcontact import plots
from wrcontact.cli.tables import write_table
from wrcontact.results.convert import columns_of
from wrcontact.wear import Usfd

SIDES = ("left", "right")
#: Sides that differ in all that wear reads, but for the radius, by which heights count.
TRACK = {
    "left": {"wheel": "cone40", "rail": "54E1", "rail_inclination": 0.05, "nominal_radius": 0.45},
    "right": {"wheel": "S1002", "rail": "UIC60", "rail_inclination": 0.025, "nominal_radius": 0.45},
}
SHARE = poses()[1]
#: Relative to the deepest place; measured are equal bits on the right, and 1.1e-13 on the left.
LAST_DIGITS = 1e-11


@cache
def whole():
    """A wheelset with these sides in compliant contact, and its table of all poses."""
    both = {name: tuple(TRACK[side][name] for side in SIDES) for name in TRACK["right"]}
    inputs = {**poses()[0], "wheel_rate": poses()[0]["speed"] / 0.45, "free_rolling": 0.0}
    stands = wrcontact.ContactSystem(**both, contact_mode="elastic", **MODELS).evaluate_many(**inputs)
    del inputs["normal_force"]
    inputs |= {"vertical_shift_input": stands.vertical_shift, "roll_input": stands.roll}
    found = wrcontact.ContactSystem(**both, contact_mode="compliant", **MODELS)
    return found, found.evaluate_many(**inputs)


def one(side, **changes):
    return wrcontact.WheelContact(side=side, **{**TRACK[side], **MODELS, **changes})


def simulate(wheel):
    """The table of one wheel at the same poses, and the distances."""
    inputs = whole()[1].inputs
    names = (
        "lateral_shift",
        "yaw",
        "track_curvature",
        "speed",
        "wheel_rate",
        "free_rolling",
        "vertical_shift_input",
        "roll_input",
    )
    given = {name: inputs[name] for name in names}
    return wheel.evaluate_many(friction=inputs[f"{wheel.side}.friction"], **given), SHARE


@cache
def table(side):
    return simulate(one(side))[0]


def columns(side):
    """The same as the FMU of one wheel has it: names without the side."""
    found = columns_of(whole()[1])
    own = {
        name.removeprefix(f"{side}."): values for name, values in found.items() if name.startswith(f"{side}.")
    }
    return {**own, **{name: found[name] for name in ("status", "speed")}, "time": np.arange(60.0)}


def worn_by(contact, law, *given):
    wear = wrcontact.Wear(contact, law)
    wear.add(*given)
    return wear


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("law", [energy, Usfd()])
def test_one_wheel_wears_as_that_side_of_a_wheelset(side, law):
    """Results are those of the wheelset to 1e-12 (tests/system/test_one_wheel.py), mostly in their bits."""
    wheelset, both = whole()
    assert np.all(both.status == 0) and wheelset.left_wheel.name != wheelset.wheel.name
    wanted, found = worn_by(wheelset, law, both, SHARE), worn_by(one(side), law, table(side), SHARE)
    assert (found.rows, found.distance, found.side) == (60, wanted.distance, side)
    for part in ("wheel", "rail"):
        places, depth = found.depth(part)
        assert depth.max() > 0.0
        name, near = f"{side}.{part}", {"rtol": 0.0, "atol": LAST_DIGITS * depth.max()}
        np.testing.assert_array_equal(places, wanted.depth(name)[0])
        np.testing.assert_allclose(depth, wanted.depth(name)[1], **near)
        np.testing.assert_allclose(found.error(part), wanted.error(name), **near)
        assert found.mass(part) == pytest.approx(wanted.mass(name), rel=LAST_DIGITS)
        assert found.shares(part) == pytest.approx(wanted.shares(name), rel=LAST_DIGITS)
        y, run = np.linspace(-30e-3, 30e-3, 1001), 0.5e-3 / depth.max()
        both_worn = found.worn(part, run).height(y), wanted.worn(name, run).height(y)
        np.testing.assert_allclose(*both_worn, rtol=0.0, atol=1e-12)  # [m]


@pytest.mark.parametrize("side", SIDES)
def test_its_mass_is_its_friction_work_s(side):
    work = np.sum(SHARE * table(side).friction_power / table(side)["speed"]) / np.sum(SHARE)  # [J/m]
    for part in ("wheel", "rail"):
        assert worn_by(one(side), energy, table(side), SHARE).mass(part) == pytest.approx(
            1e-9 * work, rel=1e-12
        )


@pytest.mark.parametrize("side", SIDES)
def test_results_of_its_fmu_wear_as_those_of_a_wheelset(side, tmp_path):
    file = tmp_path / "wheel.csv"
    write_table(file, columns(side))
    wanted = wrcontact.Wear(whole()[0], energy)
    wanted.add_fmu(columns_of(whole()[1]), distance=SHARE)
    found = wrcontact.Wear(one(side), energy)
    found.add_fmu(file, distance=SHARE)
    for part in ("wheel", "rail"):
        np.testing.assert_array_equal(found.depth(part)[1], wanted.depth(f"{side}.{part}")[1])
    # strips and stations have the same friction work
    strips = worn_by(one(side), energy, table(side), SHARE)
    assert found.mass("wheel") == pytest.approx(strips.mass("wheel"), rel=1e-9)


@pytest.mark.parametrize("side", SIDES)
def test_its_fatigue_is_that_of_the_side(side):
    """Arrays without the axis of sides."""
    found = wrcontact.fatigue(table(side), yield_shear=300e6, surface_life=(10.0, 4.0))
    wanted = wrcontact.fatigue(whole()[1], yield_shear=300e6, surface_life=(10.0, 4.0))
    for name, values in vars(found).items():
        assert values.shape == (60, 3) and np.any(np.isfinite(values)), name
        wanted_values = getattr(wanted, name)[:, SIDES.index(side)]
        np.testing.assert_allclose(values, wanted_values, rtol=LAST_DIGITS, atol=1e-11, err_msg=name)
    both = found.histogram("damage", weights=SHARE), wanted.histogram("damage", side=side, weights=SHARE)
    np.testing.assert_allclose(*both, rtol=LAST_DIGITS, atol=1e-15)
    single = wrcontact.fatigue(table(side)[7], yield_shear=300e6)
    np.testing.assert_array_equal(single.damage[0], found.damage[7])
    with pytest.raises(ValueError, match="side is 'left'; it cannot be given for one wheel"):
        found.histogram("damage", side="left")
    shown = plots.shakedown_figure(found).axes[0].collections
    assert [len(points.get_offsets()) for points in shown] == [np.isfinite(found.damage).sum()]
    bars = plots.fatigue_figure(found).axes[0].patches
    assert sum(bar.get_height() for bar in bars) == pytest.approx(np.nansum(found.damage), rel=1e-9)


@pytest.mark.parametrize("side, part", [("left", "wheel"), ("right", "rail")])
def test_a_run_wears_one_wheel(side, part, tmp_path):
    """Its first step is that of the wheelset's side; it goes on where it stopped; a wheelset's folder is not
    its own."""
    wear = worn_by(one(side), energy, table(side), SHARE)
    mileage = 1.5e-4 / wear.depth(part)[1].max()
    given = {"part": part, "method": "euler", "store": tmp_path}
    whole_run = wrcontact.wear_run(simulate, one(side), energy, mileage, part=part, method="euler")
    wrcontact.wear_run(simulate, one(side), energy, 0.5 * mileage, **given)
    again = wrcontact.wear_run(simulate, one(side), energy, mileage, **given)
    for found in (whole_run, again):
        assert found.sides == (side,) and found.distance[-1] == pytest.approx(mileage)
        assert np.all(np.isnan(found.conicity)) and len(found.steps) > 2
    first = whole_run.steps[0]
    np.testing.assert_array_equal(first.depth[side][1], wear.smooth_depth(part, 1e-3) * first.length)
    assert whole_run.profiles()[1].zones == wear.worn(part, first.length).zones
    # what the second step has seen is the worn wheel
    worn = one(side, **{part: whole_run.profiles()[1]})
    second = worn_by(worn, energy, *simulate(worn)).smooth_depth(part, 1e-3) * whole_run.steps[1].length
    np.testing.assert_array_equal(whole_run.steps[1].depth[side][1], second)
    other = SIDES[1 - SIDES.index(side)]
    with pytest.raises(ValueError, match="which has another run"):
        wrcontact.wear_run(simulate, one(other, **TRACK[side]), energy, mileage, **given)
    with pytest.raises(ValueError, match=f"side is '{other}'; permitted is '{side}'"):
        whole_run.shape("worn_area", other)
    titles = [panel.get_title(loc="left") for panel in plots.wear_figure(whole_run).axes]
    assert f"{side} {part}, depth enlarged 10 times" in titles


@pytest.mark.full  # README's command installs none of the tables' packages
def test_the_data_set_has_its_side():
    pytest.importorskip("xarray")
    found = wrcontact.wear_run(simulate, one("left"), energy, 1e3, method="euler")
    data = found.to_xarray()
    assert data.side.values.tolist() == ["left"]
    wanted = found.profiles()[-1].height(data.place.values)
    assert data.height.sel(side="left")[-1].values == pytest.approx(wanted, nan_ok=True)


def test_half_steps_are_those_of_a_mirror_image():
    """The midpoint's run of a left wheel, and of the right wheel with the same profiles in mirrored poses."""
    signs = {"lateral_shift": -1, "yaw": -1, "track_curvature": -1, "roll_input": -1}

    def mirrored(wheel):
        names = (*signs, "speed", "wheel_rate", "free_rolling", "vertical_shift_input")
        inputs = whole()[1].inputs
        given = {name: signs.get(name, 1) * inputs[name] for name in names}
        return wheel.evaluate_many(friction=inputs["left.friction"], **given), SHARE

    left = wrcontact.wear_run(simulate, one("left"), energy, 1e5)
    right = wrcontact.wear_run(mirrored, one("right", **TRACK["left"]), energy, 1e5)
    assert right.shape("worn_area")[-1] == pytest.approx(left.shape("worn_area")[-1], rel=1e-6)
    assert right.shape("worn_area")[-1] > 0.0


def test_the_picture_of_its_depth():
    wear = worn_by(one("left"), energy, table("left"), SHARE)
    panels = plots.wear_depth_figure(wear, 1e5).axes
    for panel, part, factor in zip(panels, ("wheel", "rail"), (1e8, 1e9)):
        (line,) = panel.lines
        assert line.get_ydata().max() == pytest.approx(wear.smooth_depth(part, 1e-3).max() * factor)


def test_the_command_wears_one_wheel(run, tmp_path):
    file, worn = tmp_path / "results.csv", tmp_path / "worn.json"
    write_table(file, columns("right"))
    code, out, error = run("wear", file, "--part", "wheel", "--distance-km", 100, "--output", worn)
    assert (code, error) == (0, "")
    wear = wrcontact.Wear(wrcontact.WheelContact(), Usfd())
    wear.add_fmu(file)
    y = np.linspace(-45e-3, 45e-3, 901)
    found = wrcontact.ContactSystem(wheel=worn).wheel.height(y)
    assert found == pytest.approx(wear.worn("wheel", 100e3).height(y), abs=1e-15)
    code, _, error = run("wear", file)
    assert code == 2 and "results of one wheel; permitted with --part left.wheel" in error
    write_table(file, columns_of(whole()[1]))
    code, _, error = run("wear", file, "--part", "rail")
    assert code == 2 and "results of a wheelset; permitted with --part wheel or rail" in error


@pytest.mark.parametrize(
    "wrong, words",
    [
        (lambda: wrcontact.Wear("S1002", energy), "system is str; permitted is a ContactSystem, or a Wheel"),
        (lambda: wrcontact.Wear(one("right"), energy, mirrored=True), "mirrored is True with one wheel"),
        (
            lambda: worn_by(one("right"), energy, whole()[1]),
            "table is WheelsetState; permitted with a WheelC",
        ),
        (lambda: worn_by(system(), energy, table("right")), "table is WheelState; permitted with a ContactS"),
        (
            lambda: worn_by(one("right"), energy, table("left")),
            "table is of a left wheel; permitted is one of a",
        ),
        (
            lambda: worn_by(one("left"), energy, one("left", wear_outputs=False).evaluate()),
            "no outputs of wear; wear needs results with creep forces: WheelContact(",
        ),
        (lambda: wrcontact.Wear(one("left"), energy).add_fmu({"speed": [1.0]}), "has no column 'power[1]'"),
        (
            lambda: worn_by(one("left"), energy, table("left")).depth("left.wheel"),
            "part is 'left.wheel'; permitted are 'wheel', 'rail'",
        ),
        (lambda: wrcontact.fatigue([1.0], yield_shear=1e8), "table is list; permitted is what evaluate"),
        (
            lambda: wrcontact.wear_run(lambda wheel: whole()[1], one("left"), energy, 1e3),
            "table is WheelsetState",
        ),
        (
            lambda: wrcontact.wear_run(
                lambda wheel: worn_by(*whole()[:1], energy, whole()[1]), one("left"), energy, 1e3
            ),
            "part is 'wheel'; permitted are 'left.wheel'",
        ),
    ],
)
def test_bad_input_is_refused_in_a_sentence(wrong, words):
    with pytest.raises(ValueError) as refused:
        wrong()
    said = str(refused.value)
    assert words in said and "\n" not in said and len(said) < 300


@pytest.mark.full
@pytest.mark.parametrize("side", SIDES)
@pytest.mark.turns(2)
def test_the_fmu_of_one_wheel_wears_as_python_s(kept, side):
    """fmpy runs the FMU of ``wrcontact build --native --single-wheel`` along the poses."""
    fmpy = pytest.importorskip("fmpy")
    fmu = kept("native", settings={"tangential_model": "strips"}, side=side)[0]
    wheel, both = wrcontact.WheelContact(side=side, **MODELS), whole()[1].inputs
    names = ("lateral_shift", "yaw", "track_curvature", "speed", "vertical_shift_input", "roll_input")
    given = {**{name: np.array(both[name]) for name in names}, "friction": np.array(both[f"{side}.friction"])}
    direct = wheel.evaluate_many(**given)
    signals = np.rec.fromarrays([np.arange(60.0), *given.values()], names=["time", *given])
    # fmpy sets the inputs of a step at its beginning, and reads the results at its end
    shifted = direct[np.maximum(np.arange(60) - 1, 0)]
    found = fmpy.simulate_fmu(
        str(fmu),
        stop_time=59.0,
        step_size=1.0,
        output_interval=1.0,
        input=signals,
        start_values={"normal_model": "analyn_strip", "wear_outputs": True},
        output=["speed", "status", "friction", *direct.names],
    )
    wanted, wear = (wrcontact.Wear(wheel, Usfd()) for _ in range(2))
    wanted.add_fmu(
        {**{name: shifted[name] for name in (*direct.names, "speed", "status", "friction")}}, distance=1.0
    )
    wear.add_fmu(found, distance=1.0)
    assert wear.rows == wanted.rows > 54
    for part in ("wheel", "rail"):
        depth = wanted.depth(part)[1]
        assert wear.depth(part)[1] == pytest.approx(depth, rel=1e-6, abs=1e-6 * depth.max()), part
