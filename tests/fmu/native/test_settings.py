"""Start values of parameters and inputs that a build fixes: in the description and in the model, and what is
refused."""

import pytest
from fmpy import read_model_description
from typer.testing import CliRunner

from tests.helpers.cases import OUTPUT_NAMES, moving_track
from tests.helpers.fmus import WARM_START, Host, assert_same, needs_compiler, session, stepped
from wrcontact import ContactSystem, WheelContact
from wrcontact.cli import main
from wrcontact.fmu.archive import chosen_starts
from wrcontact.fmu.description import number_text
from wrcontact.fmu.variants import single_wheel

SETTINGS = {
    "contact_mode": "compliant",
    "tangential_model": "polach",
    "contact_damping": 0.7,
    "gauge": 1.433,
    "left_nominal_radius": 0.459,
    "left_rail_inclination": 0.0,
    "independent_wheels": True,
    "fatigue_outputs": True,
    "yield_shear": 280e6,
}


@needs_compiler
@pytest.mark.parametrize("kind", ("python", 2, 3))
@pytest.mark.turns(3)
def test_set_parameters_are_the_start_values_and_the_model(kept, tmp_path, kind):
    """Without any value set by the importer the FMU has the outputs of a session with these parameters."""
    files = kept("python" if kind == "python" else "native", settings=SETTINGS)
    file = files[0 if kind == "python" else kind - 2]
    described = {v.name: v.start for v in read_model_description(str(file)).modelVariables}
    assert {name: described[name] for name in SETTINGS} == {
        name: number_text(value) for name, value in SETTINGS.items()
    }
    assert (described["gauge_depth"], described["wheel_profile"]) == ("0.014", "S1002")
    host, rows = Host(file, tmp_path / "host"), moving_track(4, compliant=True)
    seen = host.ask("trajectory", rows=rows, names=OUTPUT_NAMES)["seen"]
    made, usual = session(**SETTINGS), session()
    for row, found in zip(rows, seen, strict=True):
        assert_same(found, stepped(made, row), WARM_START)
        assert abs(found["force.y"] - stepped(usual, row)["force.y"]) > 1.0
    # the importer may still choose another value
    start = {"contact_mode": "rigid", "gauge": 1.435}
    other = host.ask("trajectory", rows=rows, names=["force.y"], start=start)
    assert other["seen"][0]["force.y"] != seen[0]["force.y"]
    host.end()


INPUTS = {
    "lateral_shift": 3e-3,
    "speed": 20.0,
    "left.friction": 0.1,
    "free_rolling": False,
    "wheel_rate": 43.6,
}


@needs_compiler
@pytest.mark.parametrize("kind", ("python", 2, 3))
@pytest.mark.turns(3)
def test_a_compliant_wheelset_starts_where_its_wheels_carry_their_load(kept, tmp_path, kind):
    """In a host that sets nothing, at the inputs that were set; heights are found by another search."""
    settings = {"contact_mode": "compliant", "tangential_model": "polach", **INPUTS}
    files = kept("python" if kind == "python" else "native", settings=settings)
    file = files[0 if kind == "python" else kind - 2]
    described = {v.name: v.start for v in read_model_description(str(file)).modelVariables}
    assert {name: described[name] for name in INPUTS} == {n: number_text(v) for n, v in INPUTS.items()}
    names = ["status", "left.normal_force", "right.normal_force", "force.x"]
    host = Host(file, tmp_path / "host")
    answer = host.ask("trajectory", rows=[{}], names=names)
    host.end()
    (seen,) = answer["seen"]
    assert seen["status"] == 0 and answer["log"] == []
    loads = [seen["left.normal_force"], seen["right.normal_force"]]
    assert loads == pytest.approx([78.5e3, 78.5e3], rel=1e-6)
    heights = {name: float(described[name]) for name in ("vertical_shift_input", "roll_input")}
    made = session(contact_mode="compliant", tangential_model="polach")
    assert seen["force.x"] == pytest.approx(stepped(made, {**INPUTS, **heights})["force.x"], rel=WARM_START)


@pytest.mark.check
def test_heights_are_found_only_where_they_are_not_given():
    """A height that is given stays; of a roll that is given both wheels together carry the load; other modes
    read no height."""
    compliant = {"contact_mode": "compliant"}
    whole, _ = chosen_starts(settings=compliant)
    assert whole["roll_input"] == pytest.approx(0.0, abs=1e-12)
    height = {**compliant, "vertical_shift_input": 1e-4}
    assert chosen_starts(settings=height)[0] == height
    assert not {"vertical_shift_input", "roll_input"} & set(chosen_starts(settings={"gauge": 1.43})[0])
    rolled, _ = chosen_starts(settings={**compliant, "roll_input": 2e-4})
    state = ContactSystem(**compliant).evaluate(
        roll_input=2e-4, vertical_shift_input=rolled["vertical_shift_input"]
    )
    assert state.left.normal_force < 50e3 < 100e3 < state.right.normal_force
    assert -state.force[2] == pytest.approx(2 * 78.5e3, rel=5e-3)  # vertical parts, within cos 0.1
    heavy = {**compliant, "normal_force": 1e7}  # no wheel less than 2 mm deep carries it
    with pytest.warns(match="normal_force is 1e\\+07 N"):
        assert chosen_starts(settings=heavy)[0] == heavy


@pytest.mark.check
@pytest.mark.parametrize("side", ("right", "left"))
def test_one_wheel_starts_where_it_carries_its_load(side):
    """At its own inputs; in the middle the height is that of a wheelset, which is found otherwise."""
    height = "vertical_shift_input"
    middle, _ = chosen_starts(settings={"contact_mode": "compliant"}, side=side)
    whole, _ = chosen_starts(settings={"contact_mode": "compliant"})
    assert middle[height] == pytest.approx(whole[height], abs=1e-12)
    aside = single_wheel(side).starts({"lateral_shift": 4e-3, "rail_vertical": 1e-3})
    assert aside == {"lateral_shift": 4e-3, f"{side}.rail_vertical": 1e-3, "contact_mode": "compliant"}
    found, _ = chosen_starts(settings=aside, side=side)
    wheel = WheelContact(side=side)
    state = wheel.evaluate(lateral_shift=4e-3, rail_vertical=1e-3, vertical_shift_input=found[height])
    assert state.normal_force == pytest.approx(78.5e3, rel=1e-6)
    named = single_wheel(side).named(found)
    assert named["rail_vertical"] == 1e-3 and "contact_mode" not in named


REFUSED = {
    "contact_mod=compliant": "contact_mod is not a parameter or input of the FMU; permitted are "
    "rail_inclination",
    "contact_mode=bouncy": "contact_mode is 'bouncy'; permitted are 'rigid', 'elastic', 'compliant'",
    "normal_model=halfspace": "normal_model is 'halfspace'; permitted are 'analyn', 'analyn_strip', 'auto', 'hertz'",
    "gauge=wide": "gauge is 'wide'; permitted is a number, in SI units",
    "gauge=14.35": "gauge is 14.35; permitted is 0.5 ... 2 m",
    "gauge=nan": "gauge is nan; permitted is 0.5 ... 2 m",
    "independent_wheels=1": "independent_wheels is '1'; permitted is true or false",
    "left_nominal_radius=0.01": "left_nominal_radius is 0.01; permitted is 0.1 ... 1 m",
    "wheel_profile=cone20": "wheel_profile is chosen by its own argument wheel, which takes built-in names "
    "too",
    "gauge": "'gauge' has no =; permitted is NAME=VALUE",
    "lateral_shift=1": "lateral_shift is 1.0; permitted is -0.015 ... 0.015 m",
    "speed=nan": "speed is nan; permitted is -200 ... 200 m/s",
    "left.friction=wet": "left.friction is 'wet'; permitted is a number, in SI units",
    "free_rolling=1": "free_rolling is '1'; permitted is true or false",
    "force.y=3": "force.y is not a parameter or input of the FMU",
}


@pytest.mark.parametrize("word", REFUSED)
def test_a_wrong_setting_is_refused_in_one_sentence(tmp_path, word):
    done = CliRunner().invoke(main, ["build", "--set", word, "--output", str(tmp_path / "out")])
    assert done.exit_code == 2 and not (tmp_path / "out").exists()
    (line,) = done.stderr.splitlines()
    assert line.startswith(f"wrcontact: --set: {REFUSED[word]}"), line


def test_settings_that_do_not_fit_each_other_are_refused(tmp_path):
    done = CliRunner().invoke(main, ["build", "--set", "gauge=1.4", "--set", "gauge=1.5"])
    assert done.exit_code == 2 and "gauge is set twice" in done.stderr
    with pytest.raises(ValueError, match="tolerance is 0.0001; permitted .* is 0.004 ... 0.1"):
        chosen_starts(settings={"tolerance": 1e-4, "normal_model": "analyn_strip"})
    with pytest.raises(ValueError, match="stations is not a parameter or input"):
        chosen_starts(settings={"stations": 61})
