"""Velocities in, a switch, creepages and the equilibrium out: the FMUs against the package."""

import numpy as np
import pytest

from tests.helpers.cases import poses, system
from tests.helpers.fmus import assert_same, needs_compiler, session, stepped
from wrcontact.interface.variables import PLACE, REFERENCE, VARIABLES

MOTION = {"speed": 25.0, "lateral_velocity": 0.04, "vertical_velocity": -0.02, "yaw_rate": 0.05,
          "roll_rate": 0.03, "track_curvature": 2e-3, "left.rail_lateral_velocity": 0.01,
          "right.rail_roll_velocity": -0.03}
NAMES = [v.name for v in VARIABLES if ".creepage." in v.name or v.name.endswith("force.y")]
EQUILIBRIUM = ["equilibrium.vertical_shift", "equilibrium.roll"]


def moving_rows(mode):
    """Poses that move; wheels that roll freely, are given their rotation, or stand."""
    rows = []
    for k, pose in enumerate(poses(6)):
        row = {**pose, **MOTION, "wheel_rate": (0.0, 55.0, 0.0)[k % 3], "free_rolling": k % 3 < 2}
        if mode == "compliant":
            stand = system(contact_mode="elastic").evaluate(**pose)
            row |= {"vertical_shift_input": stand.vertical_shift, "roll_input": stand.roll}
        rows.append(row)
    return rows


@pytest.mark.parametrize("mode", ["rigid", "elastic", "compliant"])
def test_creepages_and_equilibrium(run, mode):
    start = {"contact_mode": mode, "contact_damping": 0.3}
    rows, names = moving_rows(mode), NAMES + EQUILIBRIUM
    made = session(**start)
    seen = run("trajectory", rows=rows, names=names, start=start)["seen"]
    for row, found in zip(rows, seen, strict=True):
        wanted = stepped(made, row)
        wanted |= dict(zip(EQUILIBRIUM, made.get_reals([REFERENCE[name] for name in EQUILIBRIUM])))
        # another history: the warm start's last digits
        assert_same(found, {name: wanted[name] for name in names}, 1e-7)
        assert found["right.patch[1].creepage.x"] != 0.0
    assert seen[2]["left.patch[1].creepage.x"] > 1.9        # wheels that do not turn


@needs_compiler
def test_derivatives_of_creepages_and_of_the_equilibrium(hosts):
    """Of creepages those that the kernel gives; of the equilibrium differences of an elastic wheelset."""
    outputs = ["left.patch[1].creepage.x", "right.patch[1].creepage.spin", "right.normal_force", *EQUILIBRIUM]
    inputs = ["lateral_shift", "yaw", "normal_force", "speed", "vertical_velocity", "roll_input"]
    start, rows = {"contact_mode": "compliant", "contact_damping": 0.3}, moving_rows("compliant")[1:2]
    given = {"rows": rows, "inputs": inputs, "start": start, "outputs": outputs}
    matrices = [np.array(hosts(version).ask("derivatives", **given)["seen"][0]["matrix"])
                for version in (2, 3)]
    np.testing.assert_allclose(matrices[0], matrices[1], rtol=1e-9, atol=1e-12)
    made = session(**start)
    stepped(made, rows[0])
    made._stepper.step()
    for along, name in zip(matrices[0], inputs):
        seed = np.eye(len(made._stepper.inputs))[REFERENCE[name]]
        rates = made._stepper._bound.derivative(seed)[1]
        places = [REFERENCE[output] - REFERENCE["roll"] for output in outputs[:3]]
        np.testing.assert_allclose(along[:3], rates[places], rtol=1e-6, atol=1e-12)
        keys = {key: rows[0][key] for key in ("lateral_shift", "yaw", "normal_force", "load_transfer")}
        if name in keys:
            step = 1e-4 * VARIABLES[PLACE[name]].nominal
            high, low = (system(contact_mode="elastic").evaluate(**{**keys, name: keys[name] + way * step})
                         for way in (1, -1))
            found = [(getattr(high, of) - getattr(low, of)) / (2 * step) for of in ("vertical_shift", "roll")]
            np.testing.assert_allclose(along[3:], found, rtol=1e-4, atol=1e-12)
        else:
            assert not along[3:].any()
