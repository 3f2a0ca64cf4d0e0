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
MEAN = {"hunting": {"penetration": 0.46, "area": 0.98, "max_pressure": 1.05},
        "jumps": {"penetration": 0.64, "area": 2.20, "max_pressure": 1.10},
        "load": {"penetration": 0.44, "area": 1.18, "max_pressure": 0.82}}
#: Largest deviations: measured 0.112, 0.109, 0.251, where the load moves between two regions, which ANALYN
#: sees as a jump (the run "jumps" is made of such rows); 0.157 of the area if a patch leans.
WORST = {"penetration": 0.16, "area": 0.18, "max_pressure": 0.30}
#: The wheel as printed has a step at y = -35 mm, on which the reference's contact rests for 1 um of lateral
#: shift; ours is led over it within half a millimetre, half the step (6e-8 m) up or down.
# [m]; [rad], and 77 1/m times the arc that belongs to
RESTING, ON_THE_STEP = -0.035, {"roll": 1e-7, "contact_angle": 0.065}
POSITION_ON_THE_STEP = 6e-4  # [m]
#: The stored patches of "hunting" and "jumps" are those of a half-space on one plane, the contact point's. A
#: flange patch that leans away from it has a plane of its own here, in which the half-space has its pressure
#: too (test_halfspace.py): half of what is stored.
LEANING, PRESSURE_LEANING = math.radians(15), 0.50  # [rad], of the stored value; measured 0.44
LEAST_UPRIGHT = 0.85  # share of a run's wheels that have no such patch
# of the complete theory's; two joints of S1002 lie in this patch, a sharp second contact beside it
PRESSURE_ON_THE_STEP = 0.40  # measured 0.385


# --- values ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", RUNS)
def test_trajectory(run, name):
    times, rows, expected = stored(name)
    seen = run("trajectory", rows=rows, names=[*expected[0], *PATCH_NAMES])
    assert_near(seen["seen"], expected, name)


@pytest.mark.parametrize("name", RUNS)
def test_trajectory_by_simulate_fmu(run, name):
    times, rows, expected = stored(name)
    seen = run("simulated", rows=rows, times=times, names=[*expected[0], *PATCH_NAMES])["seen"]
    assert_near(seen[1:], expected[: len(seen) - 1], name)


def assert_near(seen, expected, run):
    """Outputs agree with a stored trajectory, each within what its name allows."""
    deviations, upright = {name: [] for name in WORST}, []
    for k, (found, wanted) in enumerate(zip(seen, expected, strict=True)):
        resting = any(abs(wanted[f"{side}.contact.y_wheel"] - RESTING) < 1e-9 for side in ("left", "right"))
        leaning = {side: leans_away(found, side) for side in ("left", "right")}
        upright += [not leans for leans in leaning.values()]
        for name, value in wanted.items():
            if value is not None:
                leans = leaning.get(name.split(".")[0], False)
                difference = abs(found[name] - value)
                allowed = allowance(name, value, resting)
                if leans and name.endswith("max_pressure"):
                    allowed = PRESSURE_LEANING * value
                assert difference <= allowed, f"row {k}: {name} is {found[name]!r}, expected {value!r}"
                last = name.split(".")[-1]
                if last in WORST and value and not leans and not (resting and last == "max_pressure"):
                    deviations[last].append(100 * difference / abs(value))
    for name, measured in MEAN[run].items():
        assert np.mean(deviations[name]) <= MARGIN * measured, name
    assert np.mean(upright) >= LEAST_UPRIGHT


PATCH_NAMES = [f"{side}.patch[{k}].{name}" for side in ("left", "right") for k in (1, 2, 3)
               for name in ("normal_force", "contact_angle")]


def leans_away(found, side):
    """Whether a loaded patch leans away from the wheel's contact plane."""
    patches = [(found[f"{side}.patch[{k}].normal_force"], found[f"{side}.patch[{k}].contact_angle"])
               for k in (1, 2, 3)]
    return any(force > 0.0 and abs(angle - found[f"{side}.contact_angle"]) > LEANING
               for force, angle in patches)


def allowance(name, value, resting):
    """What an output may differ by from ``value``."""
    last = name.split(".")[-1]
    if last in ("status", "patch_count"):
        return 0
    if last == "max_pressure" and resting:
        return PRESSURE_ON_THE_STEP * abs(value)
    if last in WORST:
        return WORST[last] * abs(value)
    if last == "normal_force":
        return 1e-6 * abs(value)  # [N]
    if resting:
        return ON_THE_STEP.get(last, POSITION_ON_THE_STEP)
    return RIGID.get(last, POSITION)
