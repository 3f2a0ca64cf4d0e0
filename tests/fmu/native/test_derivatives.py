"""Directional derivatives of the native FMUs are those of the kernel."""

import numpy as np
import pytest

from tests.helpers.cases import poses
from tests.helpers.fmus import needs_compiler, outline_of_both, session, stepped
from wrcontact import ContactSystem
from wrcontact.interface import variables
from wrcontact.interface.variables import PLACE, REFERENCE, VARIABLES
from wrcontact.kernel.binding.library import default_kernel

pytestmark = needs_compiler

DERIVATIVE_OUTPUTS = ["roll", "force.y", "left.contact.y_wheel", "right.curvature_y", "right.area",
                      "left.patch[1].length"]
DERIVATIVE_INPUTS = ["lateral_shift", "yaw", "normal_force", "load_transfer", "roll_guess"]


def kernel_rates(start, stations, row, names, inputs):
    """The kernel's own rates of the outputs that are named and of the right outline's
    stations, along each input."""
    keywords = {VARIABLES[PLACE[name]].keyword or name: value for name, value in start.items()}
    stepper = ContactSystem(stations=stations, **keywords).stepper()
    made = session(**start)
    stepped(made, row)
    stepper.inputs[:] = made._values[:len(stepper.inputs)]
    stepper.step()
    places = [REFERENCE[name] - variables.FIRST_OUTPUT for name in names]
    rates = [stepper._bound.derivative(np.eye(len(stepper.inputs))[REFERENCE[name]])[1] for name in inputs]
    return [[*along[places], *outline_of_both(along)["right.station"]] for along in rates]


@pytest.mark.skipif(not default_kernel().compiled,
                    reason="the derivatives are those of the compiled library, and none is here")
@pytest.mark.parametrize("start, stations",
                         [({}, 31), ({"contact_mode": "elastic", "normal_model": "hertz"}, 31), ({}, 61)],
                         ids=["rigid", "elastic", "61 stations"])
def test_directional_derivatives(run, run3, start, stations):
    rows = poses(3)
    given = {"rows": rows, "inputs": DERIVATIVE_INPUTS, "start": start}
    seen = run("derivatives", outputs=DERIVATIVE_OUTPUTS, **given)
    seen3 = run3("derivatives", outputs=[*DERIVATIVE_OUTPUTS, "right.station"], stations=stations, **given)
    for row, found, found3 in zip(rows, seen["seen"], seen3["seen"]):
        wanted = kernel_rates(start, stations, row, DERIVATIVE_OUTPUTS, DERIVATIVE_INPUTS)
        assert found["kept"] and found3["kept"]
        matrix = np.array(found3["matrix"])
        # the last digits of the warm start, and in elastic contact of the equilibrium
        assert matrix == pytest.approx(np.array(wanted), rel=1e-6, abs=1e-12)
        assert np.array(found["matrix"]) == pytest.approx(matrix[:, :len(DERIVATIVE_OUTPUTS)], rel=1e-6,
                                                          abs=1e-12)
        assert found3["together"] == pytest.approx(matrix.sum(axis=0), rel=1e-9,
                                                   abs=1e-12 * np.abs(matrix).max())
        assert found3["adjoint"] == pytest.approx(matrix.sum(axis=1), rel=1e-9,
                                                  abs=1e-15 * np.abs(matrix).max())
        assert not matrix[DERIVATIVE_INPUTS.index("roll_guess")].any()
        assert found["together"] == pytest.approx(np.array(found["matrix"]).sum(axis=0), rel=1e-9,
                                                  abs=1e-12 * np.abs(matrix).max())
    assert np.array(seen["inside"]) == pytest.approx(np.array(seen["seen"][0]["matrix"]), rel=1e-6, abs=1e-12)
    assert np.array(seen3["inside"]) == pytest.approx(np.array(seen3["seen"][0]["matrix"]), rel=1e-6,
                                                      abs=1e-12)
    assert seen["after"] and seen3["after"]
    for name, (refused, lines) in {**seen["calls"], **seen3["calls"]}.items():
        assert refused and len(lines) == 1 and len(lines[0][-1]) > 30, f"{name}: {lines}"
