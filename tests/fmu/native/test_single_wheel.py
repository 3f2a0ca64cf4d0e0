"""The native FMUs of one wheel: the numbers of ``WheelContact``, by names without left and right."""

import math
import random

import numpy as np
import pytest
from fmpy import read_model_description
from fmpy.validation import validate_fmu
from typer.testing import CliRunner

from tests.helpers.fmus import WARM_START, Host, needs_compiler
from tests.helpers.schemas import xml_problems
from wrcontact import WheelContact
from wrcontact.cli import main
from wrcontact.fmu.native import build_native_fmus
from wrcontact.interface.one_wheel import SHARED, wheel_inputs

SETTINGS = {"tangential_model": "strips", "contact_damping": 0.4, "gauge": 1.434}
NUMBERS = (
    "patch_count",
    "contact_angle",
    "normal_force",
    "area",
    "driving_torque",
    "friction_power",
    *(f"{name}.{axis}" for name in ("force", "moment", "normal.force") for axis in "xyz"),
    "patch[1].tangential.x",
    "patch[1].creepage.spin",
    "pressure[16]",
    "shear[16]",
)


def rows(count, seed):
    """Inputs of a loaded wheel."""
    draw = random.Random(seed)
    sizes = {
        "lateral_shift": 3e-3,
        "yaw": 0.02,
        "roll_input": 1e-4,
        "rail_lateral": 1e-3,
        "rail_vertical": 2e-5,
        "rail_roll": 2e-3,
        "rail_lateral_velocity": 0.05,
        "lateral_velocity": 0.1,
        "yaw_rate": 0.1,
    }
    return [
        {name: draw.uniform(-size, size) for name, size in sizes.items()}
        | {
            "vertical_shift_input": draw.uniform(2.5e-4, 4e-4),
            "speed": 20.0,
            "wheel_rate": draw.uniform(43.0, 44.0),
            "friction": draw.uniform(0.1, 0.5),
        }
        for _ in range(count)
    ]


@pytest.fixture(scope="module", params=("right", "left"))
def wheels(request, kept, tmp_path_factory):
    """A side, the FMUs of its wheel by version, and their hosts."""
    files = dict(zip((2, 3), kept("native", settings=SETTINGS, side=request.param)))
    made = {
        version: Host(file, tmp_path_factory.mktemp(f"wheel_{version}")) for version, file in files.items()
    }
    yield request.param, files, made
    for host in made.values():
        host.end()


@needs_compiler
@pytest.mark.parametrize("version", (2, 3))
def test_values_and_derivatives_are_those_of_one_wheel(wheels, version):
    """In co-simulation, and in model exchange without a step."""
    side, _, made = wheels
    wheel, given = WheelContact(side=side, **SETTINGS), rows(6, seed=21)
    seen = made[version].ask("trajectory", rows=given, names=["status", *NUMBERS])
    exchanged = made[version].ask("points", rows=given, names=["status", *NUMBERS], exchange=True)
    assert exchanged["continuous"] == seen["seen"]
    assert seen["log"] == []  # at the start, too, where the wheel carries its load
    for row, found in zip(given, seen["seen"], strict=True):
        state = wheel.evaluate(**row)
        wanted = {name: state[name] for name in NUMBERS}
        assert found.pop("status") == state.status == 0 and wanted["normal_force"] > 1e3
        assert found == pytest.approx(wanted, rel=WARM_START, abs=1e-6), row
    of, by = ["force.y", "driving_torque"], ["rail_lateral", "wheel_rate", "friction"]
    found = made[version].ask("rates", row=given[0], outputs=of, inputs=by)
    np.testing.assert_allclose(np.transpose(found), wheel.derivatives(of, by, **given[0]), rtol=1e-6)


@needs_compiler
@pytest.mark.parametrize("version", (2, 3))
def test_variables_are_those_of_one_side(wheels, version, fmus):
    """With the value references of the wheelset's FMU; what has no meaning is not there."""
    side, files, _ = wheels
    found = {v.name: v for v in read_model_description(str(files[version])).modelVariables}
    whole = {v.name: v for v in read_model_description(str(fmus[version])).modelVariables}
    assert not [name for name in found if name.startswith(("left", "right"))]
    inputs = [name for name, v in found.items() if v.causality == "input"]
    assert inputs == list(wheel_inputs(side))
    outputs = [name for name, v in found.items() if v.causality == "output"]
    assert set(outputs) == {
        name.removeprefix(f"{side}.")
        for name, v in whole.items()
        if v.causality == "output" and name.startswith(f"{side}.")
    } | {"status"}
    for name, variable in found.items():
        other = whole.get(f"{side}.{name}", whole.get(name))
        if name in SHARED:
            other = whole[name]
        assert (variable.valueReference, variable.type, variable.unit) == (
            other.valueReference,
            other.type,
            other.unit,
        ), name
    parameters = {name for name, v in found.items() if v.causality == "parameter"}
    assert {"wheel_profile", "gauge", "contact_damping"} < parameters
    assert not {"contact_mode", "load", "independent_wheels", "left_nominal_radius"} & parameters
    assert found["gauge"].start == "1.434"


@needs_compiler
@pytest.mark.parametrize("version", (2, 3))
def test_archives_are_valid(wheels, version):
    _, files, _ = wheels
    assert files[version].name == f"WheelContact_native_fmi{version}.fmu"
    assert validate_fmu(str(files[version])) == []
    assert not any(xml_problems(files[version], version).values())


@needs_compiler
def test_sentences_have_the_wheel_s_names(wheels):
    _, _, made = wheels
    cases = {
        "friction": {"friction": 3.0},
        "rail_lateral": {"rail_lateral": math.nan},
        "wheel_rate": {"wheel_rate": 3000.0},
    }
    for host in made.values():
        for name, row in cases.items():
            seen = host.ask("trajectory", rows=[row], names=["status"])
            (line,) = (told[2] for told in seen["log"])
            assert seen["seen"][0]["status"] == 4 and line.startswith(f"{name} is "), line


@pytest.mark.check
@pytest.mark.parametrize(
    "words, said",
    [
        (["--single-wheel"], "--single-wheel is given; it is permitted only with --native"),
        (
            ["--native", "--single-wheel", "--set", "contact_mode=rigid"],
            "mode is 'rigid'; permitted with one",
        ),
        (
            ["--native", "--single-wheel", "--set", "load=vertical"],
            "load cannot be given for one wheel",
        ),
    ],
)
def test_what_has_no_meaning_is_refused(tmp_path, words, said):
    done = CliRunner().invoke(main, ["build", *words, "--output", str(tmp_path / "out")])
    assert done.exit_code == 2 and said in done.stderr and not list(tmp_path.glob("out/*"))


@pytest.mark.check
def test_a_profile_of_the_other_wheel_is_refused(tmp_path):
    with pytest.raises(
        ValueError, match="left_wheel cannot be given for one wheel, which has wheel, and side='left'"
    ):
        build_native_fmus(tmp_path, wheel=("cone20", "S1002"), side="right")
