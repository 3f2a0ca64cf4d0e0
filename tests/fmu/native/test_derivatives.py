"""Directional derivatives of the native FMUs are those of the kernel, and of the equilibrium differences;
tests/derivative has the kernel's against differences."""

import numpy as np
import pytest

from tests.helpers.cases import LEFT_SIDE, moving_track, poses, system
from tests.helpers.fmus import needs_compiler, outline_of_both, session, stepped
from wrcontact import ContactSystem
from wrcontact.interface import variables
from wrcontact.interface.variables import PLACE, VARIABLES
from wrcontact.kernel.binding.library import default_kernel

pytestmark = needs_compiler

OUTPUTS = [
    "roll",
    "force.y",
    "left.contact.y_wheel",
    "right.curvature_y",
    "right.area",
    "left.patch[1].length",
]
INPUTS = ["lateral_shift", "yaw", "normal_force", "load_transfer", "roll_guess"]
#: Of wheelsets that roll.
CREEP = [
    "left.patch[1].creepage.x",
    "right.patch[1].creepage.spin",
    "right.patch[1].tangential.y",
    "right.moment.z",
    "right.friction_power",
    "driving_torque",
]
MOTION = ["speed", "lateral_velocity", "wheel_rate", "vertical_velocity", "left.friction", "right.friction"]


def kernel_rates(start, stations, row, names, inputs):
    """The kernel's own rates of the outputs that are named and of the right outline's
    stations, along each input."""
    keywords = {VARIABLES[PLACE[name]].keyword or name: value for name, value in start.items()}
    stepper = ContactSystem(stations=stations, **keywords).stepper()
    made = session(**start)
    stepped(made, row)
    stepper.inputs[:] = made._values[: len(stepper.inputs)]
    stepper.step()
    places = [PLACE[name] - variables.FIRST_OUTPUT for name in names]
    rates = [stepper._bound.derivative(np.eye(len(stepper.inputs))[PLACE[name]])[1] for name in inputs]
    return [[*along[places], *outline_of_both(along, stepper.layout)["right.station"]] for along in rates]


@pytest.mark.skipif(
    not default_kernel().compiled,
    reason="the derivatives are those of the compiled library, and none is here",
)
@pytest.mark.parametrize(
    "start, stations",
    [
        pytest.param({}, 31, id="rigid"),
        pytest.param({}, 61, id="61 stations"),
        pytest.param({"contact_mode": "elastic", "normal_model": "hertz"}, 31, id="elastic"),
        pytest.param({"tangential_model": "polach", "load": "vertical"}, 31, id="polach, vertical"),
        pytest.param({"tangential_model": "strips", "contact_mode": "elastic"}, 31, id="strips, elastic"),
        pytest.param(
            {"tangential_model": "fastsim", "contact_mode": "compliant", "contact_damping": 0.3},
            31,
            id="fastsim, compliant",
        ),
        pytest.param(
            {
                "tangential_model": "polach",
                "contact_mode": "compliant",
                "rail_lateral_stiffness": 3e8,
                "rail_vertical_stiffness": 1e9,
                "left_rail_lateral_stiffness": 1e8,
            },
            31,
            id="springs",
        ),
    ],
)
def test_directional_derivatives(run, run3, start, stations):
    rolls = "tangential_model" in start
    rows = moving_track(3, "compliant" in start.values()) if rolls else poses(3)
    start = {**start, **LEFT_SIDE} if rolls else start
    outputs, inputs = OUTPUTS + rolls * CREEP, INPUTS + rolls * MOTION
    given = {"rows": rows, "inputs": inputs, "start": start}
    seen = run("derivatives", outputs=outputs, **given)
    seen3 = run3("derivatives", outputs=[*outputs, "right.station"], stations=stations, **given)
    for row, found, found3 in zip(rows, seen["seen"], seen3["seen"]):
        wanted = kernel_rates(start, stations, row, outputs, inputs)
        assert found["kept"] and found3["kept"]
        matrix = np.array(found3["matrix"])
        # the last digits of the warm start, and in elastic contact of the equilibrium
        assert matrix == pytest.approx(np.array(wanted), rel=1e-6, abs=1e-12)
        assert np.array(found["matrix"]) == pytest.approx(matrix[:, : len(outputs)], rel=1e-6, abs=1e-12)
        assert found3["together"] == pytest.approx(
            matrix.sum(axis=0), rel=1e-9, abs=1e-12 * np.abs(matrix).max()
        )
        assert found3["adjoint"] == pytest.approx(
            matrix.sum(axis=1), rel=1e-9, abs=1e-15 * np.abs(matrix).max()
        )
        assert not matrix[inputs.index("roll_guess")].any()
        assert found["together"] == pytest.approx(
            np.array(found["matrix"]).sum(axis=0), rel=1e-9, abs=1e-12 * np.abs(matrix).max()
        )
    for one in (seen, seen3):
        assert np.array(one["inside"]) == pytest.approx(
            np.array(one["seen"][0]["matrix"]), rel=1e-6, abs=1e-12
        )
        assert one["after"]
    for name, (refused, lines) in {**seen["calls"], **seen3["calls"]}.items():
        assert refused and len(lines) == 1 and len(lines[0][-1]) > 30, f"{name}: {lines}"


def test_derivatives_of_the_equilibrium(run, run3):
    """Differences of an elastic wheelset; nothing else moves it."""
    names, (row,) = ["vertical_shift", "roll"], moving_track(2, compliant=True)[1:]
    given = {
        "rows": [row],
        "inputs": ["lateral_shift", "yaw", "normal_force", "speed", "roll_input"],
        "outputs": [f"equilibrium.{name}" for name in names],
        "start": {"contact_mode": "compliant"},
    }
    keys = {
        key.replace(".", "_"): row[key]
        for key in row
        if key in INPUTS or ".rail_" in key and not key.endswith("velocity")
    }
    for ask in (run, run3):
        matrix = np.array(ask("derivatives", **given)["seen"][0]["matrix"])
        for along, name in zip(matrix, given["inputs"][:3]):
            step = 1e-4 * VARIABLES[PLACE[name]].nominal
            high, low = (
                system(contact_mode="elastic").evaluate(**{**keys, name: keys[name] + way * step})
                for way in (1, -1)
            )
            found = [(getattr(high, of) - getattr(low, of)) / (2 * step) for of in names]
            np.testing.assert_allclose(along, found, rtol=1e-4, atol=1e-12)
        assert not matrix[3:].any()
