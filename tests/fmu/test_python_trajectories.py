"""The Python FMU on the stored runs, within what each output may differ from the complete theory."""

import math

import numpy as np
import pytest

from tests.helpers.cases import RUNS, stored

# What a stored trajectory may differ by, from the name of its column.
# [rad] measured 7.7e-13, [rad] measured 6.8e-8 (the file has eight digits), not compared
RIGID = {"roll": 2e-12, "contact_angle": 1e-7, "curvature": math.inf}
POSITION = 1.2e-9  # [m] measured 8e-10
#: Means of a run's deviations from the complete theory may be so many times what is measured [%].
MARGIN = 1.3
MEAN = {"hunting": {"penetration": 0.49, "area": 1.01, "max_pressure": 1.07},
        "jumps": {"penetration": 0.73, "area": 2.20, "max_pressure": 1.32},
        "load": {"penetration": 0.32, "area": 0.37, "max_pressure": 0.37}}
#: Largest deviations: measured 0.179, 0.160, 0.264, by ANALYN at 6.2548 ... 6.2638 mm, where the patch
#: reaches around the flange root (0.112, 0.157, 0.251 when model and reference had planes). The wheels of
#: "hunting" and "load" stay within 0.031, 0.065 and 0.127.
WORST = {"penetration": 0.24, "area": 0.22, "max_pressure": 0.34}
#: The wheel as printed has a step at y = -35 mm, on which the reference's contact rests for 1 um of lateral
#: shift; ours is led over it within half a millimetre, half the step (6e-8 m) up or down.
# [m]; [rad], and 77 1/m times the arc that belongs to
RESTING, ON_THE_STEP = -0.035, {"roll": 1e-7, "contact_angle": 0.065}
POSITION_ON_THE_STEP = 6e-4  # [m]


# --- values ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", RUNS)
def test_trajectory(run, name):
    times, rows, expected = stored(name)
    seen = run("trajectory", rows=rows, names=[*expected[0]])
    assert_near(seen["seen"], expected, name)


@pytest.mark.parametrize("name", RUNS)
def test_trajectory_by_simulate_fmu(run, name):
    times, rows, expected = stored(name)
    seen = run("simulated", rows=rows, times=times, names=[*expected[0]])["seen"]
    assert_near(seen[1:], expected[: len(seen) - 1], name)


def assert_near(seen, expected, run):
    """Outputs agree with a stored trajectory, each within what its name allows."""
    deviations = {name: [] for name in WORST}
    for k, (found, wanted) in enumerate(zip(seen, expected, strict=True)):
        resting = any(abs(wanted[f"{side}.contact.y_wheel"] - RESTING) < 1e-9 for side in ("left", "right"))
        for name, value in wanted.items():
            if value is not None:
                difference = abs(found[name] - value)
                assert difference <= allowance(name, value, resting), (
                    f"row {k}: {name} is {found[name]!r}, expected {value!r}")
                last = name.split(".")[-1]
                if last in WORST and value:
                    deviations[last].append(100 * difference / abs(value))
    for name, measured in MEAN[run].items():
        assert np.mean(deviations[name]) <= MARGIN * measured, name


def allowance(name, value, resting):
    """What an output may differ by from ``value``."""
    last = name.split(".")[-1]
    if last in ("status", "patch_count"):
        return 0
    if last in WORST:
        return WORST[last] * abs(value)
    if last == "normal_force":
        return 1e-6 * abs(value)  # [N]
    if resting:
        return ON_THE_STEP.get(last, POSITION_ON_THE_STEP)
    return RIGID.get(last, POSITION)
