"""ANALYN and the strip model against stored answers of complete half-space theory: by mean and worst
error, close to what is measured."""

import numpy as np
import pytest

import data
from benchmarks import errors, random_poses
from tests.helpers.strips import system_of
from wrcontact.interface.inputs import INPUTS

pytestmark = pytest.mark.machine

#: By how much a change may raise what is measured.
MEAN, WORST = 1.3, 1.5
#: Measured errors [%] of penetration, area and peak pressure by model and run: mean, and worst.
#:
#: ANALYN is worst at 6.2548 ... 6.2638 mm, where the patch reaches around the flange root. Strips are worst
#: in penetration at 6.2511 ... 6.2516 mm, where the rigid contact, from which the penetration counts, rests
#: on the step of the printed wheel (data/README.md).
#:
#: Strips with planes had areas of 0.55 % in "positions" and 0.42 % in "load" in the mean, 1.8 and 0.7 % at
#: worst, against planar references.
MEASURED = {
    "analyn": {
        "positions": ((0.65, 1.77, 1.08), (2.68, 6.17, 3.25)),
        "hunting": ((0.49, 1.01, 1.07), (3.11, 6.52, 12.7)),
        "jumps": ((0.72, 2.20, 1.32), (17.9, 16.0, 26.5)),
        "load": ((0.30, 0.36, 0.37), (1.68, 3.06, 1.94)),
    },
    "analyn_strip": {
        "positions": ((0.044, 0.39, 0.34), (0.15, 1.40, 1.13)),
        # two lobes between which little is pressed: once 1 in 318 wheels has 11 % of area too little
        "hunting": ((0.03, 0.33, 0.18), (0.51, 11.3, 1.40)),
        # micrometres from a jump, an edge that is still on its way: 4.7, 8.3, 5.1 % at worst with 24 strips,
        # and 0.46, 0.53, 0.54 % in the mean
        "jumps": ((0.15, 0.52, 0.69), (10.1, 6.70, 21.3)),
        "load": ((0.026, 0.24, 0.08), (0.08, 0.61, 0.66)),
    },
}
#: The same of the stored random poses: mean, 99 of 100, and worst. Strips with planes had 0.40 % of area in
#: the mean and 1.8 % in 99 of 100, but 16 % at worst and 40 % of pressure, against planar references.
RANDOM = {
    "analyn": ((0.47, 0.97, 1.57), (2.30, 5.67, 6.27), (20.0, 31.7, 12.8)),
    "analyn_strip": ((0.044, 0.20, 0.18), (0.19, 1.18, 1.65), (0.87, 7.02, 7.96)),
}


def compared(model, name):
    """Errors (3, n) [%] at all loaded wheels of a run."""
    run = data.columns(data.POSITIONS if name == "positions" else data.TRAJECTORIES[name])
    given = {row.name: run[row.name] for row in INPUTS if row.name in run}
    table = system_of(model).evaluate_many(**given)
    assert not np.any(table.status > 1)
    found = []
    for side in ("right",) if name == "positions" else ("left", "right"):
        wheel = getattr(table, side)
        stored = np.array([run[f"{side}.{quantity}"] for quantity in errors.PATCH])
        ours = np.array([getattr(wheel, quantity) for quantity in errors.PATCH])
        loaded = stored[0] > 0.0
        found.append(100 * np.abs(ours[:, loaded] / stored[:, loaded] - 1))
    return np.concatenate(found, axis=1)


@pytest.mark.parametrize("name", ["positions", "hunting", "jumps", "load"])
@pytest.mark.parametrize("model", MEASURED)
def test_half_space_on_stored_runs(model, name):
    """The runs' own errors are up to 0.004, 0.9 and 0.6 % (data/README.md)."""
    found = compared(model, name)
    mean, worst = np.array(MEASURED[model][name])
    assert np.all(found.mean(axis=1) <= MEAN * mean), found.mean(axis=1)
    assert np.all(found.max(axis=1) <= WORST * worst), found.max(axis=1)
    assert found.shape[1] >= {"positions": 20, "hunting": 318, "jumps": 259, "load": 148}[name]


@pytest.mark.parametrize("model", RANDOM)
def test_half_space_on_stored_random_poses(model):
    """Three rails, two inclinations, half of them with yaw, 3 ... 200 kN; the half-space's tolerance is 1 %.

    ANALYN is worst where a second, shallow region begins to carry under a few kilonewtons (area -30 %), and
    beside jumps of the contact."""
    truth = random_poses.references(random_poses.COUNT, random_poses.STORED)
    found = random_poses.compared(truth, (model,))[model]
    mean, most, worst = np.array(RANDOM[model])
    assert found["refused"] == 0
    assert np.all(found["mean"] <= MEAN * mean), found["mean"]
    assert np.all(found["99 of 100"] <= WORST * most), found["99 of 100"]
    assert np.all(found["worst"] <= WORST * worst), found["worst"]
