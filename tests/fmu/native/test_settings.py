"""Start values of parameters that a build fixes: in the description and in the model, and what is refused."""

import pytest
from fmpy import read_model_description
from typer.testing import CliRunner

from tests.helpers.cases import OUTPUT_NAMES, moving_track
from tests.helpers.fmus import WARM_START, Host, assert_same, needs_compiler, session, stepped
from wrcontact.cli import main
from wrcontact.fmu.archive import chosen_starts
from wrcontact.fmu.description import number_text

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


REFUSED = {
    "contact_mod=compliant": "contact_mod is not a parameter of the FMU; permitted are rail_inclination",
    "contact_mode=bouncy": "contact_mode is 'bouncy'; permitted are 'rigid', 'elastic', 'compliant'",
    "normal_model=halfspace": "normal_model is 'halfspace'; permitted are 'analyn', 'analyn_strip', 'hertz'",
    "gauge=wide": "gauge is 'wide'; permitted is a number, in SI units",
    "gauge=14.35": "gauge is 14.35; permitted is 0.5 ... 2 m",
    "gauge=nan": "gauge is nan; permitted is 0.5 ... 2 m",
    "independent_wheels=1": "independent_wheels is '1'; permitted is true or false",
    "left_nominal_radius=0.01": "left_nominal_radius is 0.01; permitted is 0.1 ... 1 m",
    "wheel_profile=cone20": "wheel_profile is chosen by its own argument wheel, which takes built-in names "
    "too",
    "gauge": "'gauge' has no =; permitted is NAME=VALUE",
    "lateral_shift=1": "lateral_shift is not a parameter of the FMU",
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
    with pytest.raises(ValueError, match="stations is not a parameter"):
        chosen_starts(settings={"stations": 61})
