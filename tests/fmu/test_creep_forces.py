"""Creep forces in all FMUs: the package's numbers over a run in which speed, yaw and friction change, and
directional derivatives against differences."""

from functools import cache

import numpy as np
import pytest

from tests.helpers.cases import INPUT_NAMES, poses, system
from tests.helpers.fmus import WARM_START, assert_same, evaluated, needs_compiler
from wrcontact import ContactSystem
from wrcontact.interface.variables import PLACE, VARIABLES

MODELS = ("polach", "fastsim", "strips")
#: Of a derivative's size; points of FASTSIM come to slide one by one, each with a kink.
AGREE = {"polach": 1e-4, "fastsim": 2e-2, "strips": 1e-3}
WORDS = (".tangential.", "force.", "moment.", "friction_power", "wear_number", "driving_torque", "saturation",
         "stick_share", "max_shear", ".creepage.", "normal_force")
NAMES = [v.name for v in VARIABLES if v.causality == "output" and any(word in v.name for word in WORDS)]
#: Names of arrays' elements in FMI 2.
OUTLINE = [f"right.{name}[{j}]" for name in ("shear", "slip") for j in (8, 16, 24)]
#: What a run is made with, by its name.
STARTS = {"rigid": {}, "elastic": {"contact_mode": "elastic"}, "compliant": {"contact_mode": "compliant"},
          "vertical": {"load": "vertical"},
          "wet": {"flange_friction_ratio": 0.4, "friction_fall": 0.5, "friction_fall_rate": 0.6,
                  "slope_reduction": 0.6, "slope_reduction_rate": 0.5}}


def rolling_rows(mode, count=8):
    """Poses that roll: from standstill to backwards, in curves, braked, over changing friction."""
    rows = []
    for k, pose in enumerate(poses(count)):
        row = {**pose, "speed": (0.0, 5.0, 20.0, 40.0, -20.0)[k % 5], "yaw_rate": 0.05 * np.sin(k),
               "lateral_velocity": 0.04 * np.cos(k), "track_curvature": 2e-3 * (k % 3 - 1),
               "left.friction": 0.1 + 0.05 * k, "right.friction": 0.5 - 0.05 * k}
        if k % 4 == 2:
            row["wheel_rate"] = row["speed"] / 0.46 * 1.002
        else:
            row["wheel_rate"] = 0.0
        if mode == "compliant":
            stand = system(contact_mode="elastic").evaluate(**pose)
            row |= {"vertical_shift_input": stand.vertical_shift, "roll_input": stand.roll}
        rows.append(row)
    return rows


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("case", STARTS)
def test_the_fmu_has_the_package_s_creep_forces(run, model, case):
    start = {**STARTS[case], "tangential_model": model}
    rows, expected = rolled(model, case)
    seen = run("trajectory", rows=rows, names=NAMES + OUTLINE, start=start)["seen"]
    for found, wanted in zip(seen, expected, strict=True):
        assert_same(found, {name: wanted[name] for name in found}, WARM_START)
    assert seen[0]["left.patch[1].tangential.x"] == 0.0       # at standstill
    assert all(row["right.patch[1].saturation"] > 0.01 for row in expected[1:5])
    if model != "polach":
        assert expected[3]["right.shear[16]"] > 1e6 and expected[3]["right.slip[16]"] > 0.0


@cache
def rolled(model, case):
    """Rows of inputs and what the package gives for them."""
    start = {**STARTS[case], "tangential_model": model}
    rows, stepper = rolling_rows(start.get("contact_mode", "rigid")), ContactSystem(**start).stepper()
    expected = [evaluated(row, stepper) for row in rows]
    assert [row["status"] for row in expected] == [0] * len(rows)
    return rows, expected


OUTPUTS = ["force.x", "force.y", "force.z", "moment.x", "moment.y", "moment.z", "driving_torque",
           "left.force.x", "right.force.y", "right.moment.z", "left.patch[1].tangential.x",
           "right.patch[1].tangential.y", "right.friction_power"]
INPUTS = ["speed", "lateral_velocity", "yaw_rate", "wheel_rate", "left.friction", "right.friction"]
POSE = {"lateral_shift": 2.3e-3, "yaw": 3e-3, "speed": 20.0, "wheel_rate": 43.4, "lateral_velocity": 0.02,
        "yaw_rate": 0.03, "left.friction": 0.25, "right.friction": 0.35, "normal_force": 70e3,
        "load_transfer": 0.1}


@needs_compiler
@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("case", ["rigid", "elastic", "compliant", "vertical"])
def test_derivatives_of_creep_forces_are_differences(hosts, model, case):
    start = {**STARTS[case], "tangential_model": model}
    pose = dict(POSE)
    if case == "compliant":
        stand = system(contact_mode="elastic").evaluate(POSE["lateral_shift"], POSE["yaw"])
        pose |= {"vertical_shift_input": stand.vertical_shift, "roll_input": stand.roll}
    given = {"rows": [pose], "inputs": INPUTS, "start": start, "outputs": OUTPUTS}
    two, three = (np.array(hosts(version).ask("derivatives", **given)["seen"][0]["matrix"])
                  for version in (2, 3))
    np.testing.assert_allclose(two, three, rtol=1e-9, atol=1e-9)
    stepper = ContactSystem(**start).stepper()

    def outputs(name, move):
        found = evaluated({**pose, name: pose[name] + move}, stepper)
        assert found["status"] == 0
        return np.array([found[output] for output in OUTPUTS])

    assert set(pose) <= set(INPUT_NAMES)
    for rates, name in zip(two, INPUTS):
        # of two steps one is to be met: forces have kinks
        nominal = VARIABLES[PLACE[name]].nominal
        off = np.inf
        for step in (1e-5 * nominal, 1e-4 * nominal):
            difference = (outputs(name, step) - outputs(name, -step)) / (2 * step)
            off = np.minimum(off, np.abs(rates - difference))
        size = np.maximum(np.abs(rates), 10.0 / nominal)        # of forces of 10 N
        assert (off / size).max() < AGREE[model], (name, OUTPUTS[(off / size).argmax()], rates, off)
        assert np.abs(rates).max() > 10.0 / nominal, f"nothing follows {name}"
