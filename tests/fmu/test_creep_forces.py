"""Wheelsets with different sides that roll over moving rails, with creep forces, in all FMUs: the package's
numbers over a run in which motion and friction change; native/test_derivatives.py has the derivatives."""

from functools import cache

import numpy as np
import pytest

from tests.helpers.cases import LEFT_SIDE, moving_track
from tests.helpers.fmus import WARM_START, assert_same, session, stepped
from wrcontact.interface.variables import REFERENCE, VARIABLES

MODELS = ("polach", "fastsim", "strips")
WORDS = (
    ".tangential.",
    "force.",
    "moment.",
    "friction_power",
    "wear_number",
    "driving_torque",
    "saturation",
    "stick_share",
    "max_shear",
    ".creepage.",
    "normal_force",
    "equilibrium.",
)
NAMES = [v.name for v in VARIABLES if v.causality == "output" and any(word in v.name for word in WORDS)]
EQUILIBRIUM = [name for name in NAMES if name.startswith("equilibrium.")]
#: Names of arrays' elements in FMI 2.
OUTLINE = [f"right.{name}[{j}]" for name in ("shear", "slip") for j in (8, 16, 24)]
#: What a run is made with, by its name.
STARTS = {
    "rigid": {},
    "elastic": {"contact_mode": "elastic"},
    "compliant": {"contact_mode": "compliant", "contact_damping": 0.3},
    "vertical": {"load": "vertical"},
    "independent": {"independent_wheels": True, "contact_mode": "elastic"},
    "wet": {
        "flange_friction_ratio": 0.4,
        "friction_fall": 0.5,
        "friction_fall_rate": 0.6,
        "slope_reduction": 0.6,
        "slope_reduction_rate": 0.5,
    },
}


def rolling_rows(mode, count=8):
    """Rows that roll: from standstill to backwards, in curves, braked and locked, over changing friction."""
    rows = moving_track(count, mode == "compliant")
    for k, row in enumerate(rows):
        row |= {
            "speed": (0.0, 5.0, 20.0, 40.0, -20.0)[k % 5],
            "yaw_rate": 0.05 * np.sin(k),
            "lateral_velocity": 0.04 * np.cos(k),
            "track_curvature": 2e-3 * (k % 3 - 1),
            "left.friction": 0.1 + 0.05 * k,
            "right.friction": 0.5 - 0.05 * k,
            "free_rolling": k != 3,
        }
        row["wheel_rate"] = row["speed"] / 0.46 * 1.002 if k % 4 == 2 else 0.0
        row["left.wheel_rate"], row["right.wheel_rate"] = row["wheel_rate"] * 0.999, row["wheel_rate"] * 1.001
    return rows


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("case", STARTS)
def test_the_fmu_has_the_package_s_creep_forces(run, model, case):
    start, rows, expected = rolled(model, case)
    seen = run("trajectory", rows=rows, names=NAMES + OUTLINE, start=start)["seen"]
    for found, wanted in zip(seen, expected, strict=True):
        assert_same(found, {name: wanted[name] for name in found}, WARM_START)
    assert seen[0]["left.patch[1].tangential.x"] == 0.0  # at standstill
    assert seen[3]["left.patch[1].creepage.x"] > 1.9  # wheels that do not turn
    assert all(row["right.patch[1].saturation"] > 0.01 for row in expected[1:5])
    if model != "polach":
        assert expected[3]["right.shear[16]"] > 1e6 and expected[3]["right.slip[16]"] > 0.0


@cache
def rolled(model, case):
    """Start values, rows of inputs and what the package gives for them."""
    start = {**STARTS[case], **LEFT_SIDE, "tangential_model": model}
    rows, made = rolling_rows(start.get("contact_mode", "rigid")), session(**start)
    expected = []
    for row in rows:
        expected.append(stepped(made, row))
        expected[-1] |= dict(zip(EQUILIBRIUM, made.get_reals([REFERENCE[name] for name in EQUILIBRIUM])))
    assert [row["status"] for row in expected] == [0] * len(rows)
    return start, rows, expected
