"""Two different worn wheels on rails that move, in a native FMU: a short run of
examples/irregular_track.py."""

import runpy

import numpy as np
import pytest

from tests.helpers.fmus import needs_compiler
from tests.helpers.paths import ROOT
from wrcontact.fmu import native

pytestmark = needs_compiler
EXAMPLE = runpy.run_path(str(ROOT / "examples" / "irregular_track.py"))
MASS, INERTIA, LOAD, STEP = (EXAMPLE[name] for name in ("MASS", "INERTIA", "LOAD", "STEP"))
SIDES = ("left", "right")
PATCH = ("x_track", "y_track", "z_track", "force.x", "force.y", "force.z")
WHEEL = ("force.x", "force.y", "force.z", "moment.x", "moment.y", "moment.z")
NAMES = [
    *WHEEL,
    *(f"{side}.{name}" for side in SIDES for name in WHEEL),
    *(f"{side}.patch[{k}].{name}" for side in SIDES for k in (1, 2, 3) for name in PATCH),
]
RADIUS = 0.46


@pytest.fixture(scope="module")
def archive(tmp_path_factory, compiled):
    """The native FMU with a left wheel that is little and a right one that is much worn."""
    folder = tmp_path_factory.mktemp("worn")
    left, right = (
        EXAMPLE["worn_wheel"](folder / f"{side}.csv", depth, seed)
        for side, depth, seed in (("left", 0.2e-3, 1), ("right", 0.6e-3, 2))
    )
    with pytest.warns(match="noise"):
        return native.build_native_fmus(folder / "out", wheel=(left, right), cache=compiled)[0]


@pytest.fixture(scope="module")
def ride(archive):
    """Half a second, in which the longest wave of the rails passes once: times, rails, places, velocities,
    and outputs as a function of their name."""
    time, rails, place, velocity, seen = EXAMPLE["ride"](archive, 0.45, outputs=NAMES)
    return time, rails, place, velocity, lambda name: seen[:, NAMES.index(name)]


def vectors(of, name):
    return np.stack([of(f"{name}.{axis}") for axis in "xyz"], axis=1)


def patches(of):
    """Points (n, 3) and forces (n, 3) of all patches; zeros where there is none."""
    for side in SIDES:
        for k in (1, 2, 3):
            name = f"{side}.patch[{k}]"
            point = np.stack([of(f"{name}.{axis}_track") for axis in "xyz"], axis=1)
            yield point, vectors(of, f"{name}.force")


def test_forces_of_wheels_and_patches_are_those_of_the_wheelset(ride):
    """Moments are about the wheelset's centre, where its shifts and its radius place it."""
    _, _, place, _, of = ride
    centre = np.stack([0.0 * place[:, 0], place[:, 0], place[:, 1] - RADIUS], axis=1)
    force = sum(force for _, force in patches(of))
    moment = sum(np.cross(point - centre, force) for point, force in patches(of))
    for name, wanted, size in (("force", force, LOAD), ("moment", moment, LOAD)):
        both = vectors(of, f"left.{name}") + vectors(of, f"right.{name}")
        # rounding of sums
        np.testing.assert_allclose(vectors(of, name), both, rtol=0, atol=1e-13 * size)
        np.testing.assert_allclose(vectors(of, name), wanted, rtol=0, atol=1e-12 * size)


def test_forces_balance_weight_and_inertia(ride):
    """Mass times the acceleration seen in the trajectory, and the same for the roll: forces of the patches
    and their moments about the centre, the weight, and across the track the guide of the bogie."""
    _, _, place, velocity, of = ride
    acceleration = np.diff(place, 2, axis=0) / STEP**2
    force = sum(force for _, force in patches(of))[1:-1]
    guide = EXAMPLE["GUIDE"] * place[1:-1, 0] + EXAMPLE["DAMPER"] * velocity[1:-1, 0]
    # the rounding of places of 1 mm in their second differences: 1e-11 m/s2
    np.testing.assert_allclose(MASS * acceleration[:, 1], force[:, 2] + LOAD, rtol=0, atol=1e-6)  # [N]
    np.testing.assert_allclose(MASS * acceleration[:, 0], force[:, 1] - guide, rtol=0, atol=1e-6)
    np.testing.assert_allclose(INERTIA * acceleration[:, 2], of("moment.x")[1:-1], rtol=0, atol=1e-6)  # [N m]
    # it does move: the forces are not those at rest
    assert np.ptp(force[:, 2]) > 0.1 * LOAD


def test_the_mean_force_is_the_weight(ride):
    """But for what the wheelset moves faster at the end than at the start."""
    time, _, _, velocity, of = ride
    change = MASS * (velocity[-1, 1] - velocity[0, 1]) / (time[-1] - time[0])
    assert abs(change) < 2e-3 * LOAD
    assert of("force.z")[:-1].mean() == pytest.approx(change - LOAD, abs=1e-9 * LOAD)


def test_work_of_the_patches_is_the_energy_gained(ride):
    """Power of each patch's force at the velocity of its point, and of the load and the guide."""
    _, _, place, velocity, of = ride
    energy = 0.5 * velocity**2 @ [MASS, MASS, INERTIA]
    still = np.zeros(len(place))
    centre = np.stack([still, place[:, 0], place[:, 1] - RADIUS], axis=1)
    middle = 0.5 * (velocity[1:] + velocity[:-1])  # forces act from one step to the next
    turning = np.stack([middle[:, 2], still[1:], still[1:]], axis=1)
    drift = np.stack([still[1:], middle[:, 0], middle[:, 1]], axis=1)
    power = LOAD * middle[:, 1] - middle[:, 0] * (
        EXAMPLE["GUIDE"] * place[:-1, 0] + EXAMPLE["DAMPER"] * velocity[:-1, 0]
    )
    exchanged = np.abs(power)
    for point, force in patches(of):
        done = np.sum(force[:-1] * (drift + np.cross(turning, (point - centre)[:-1])), axis=1)
        power, exchanged = power + done, exchanged + np.abs(done)
    gained = np.cumsum(power) * STEP
    # the rounding of sums of what is exchanged
    near = 1e-11 * np.sum(exchanged) * STEP
    np.testing.assert_allclose(gained, (energy - energy[0])[1:], rtol=0, atol=near)
    assert np.ptp(energy) > 0.1  # [J]


def test_long_waves_are_followed(ride):
    """The rails move at 2 to 15 Hz, far below the resonance of the wheelset on its contacts, so it follows
    them: heights as the mean of both rails, roll as their difference over the distance of the contacts."""
    _, rails, place, _, of = ride
    apart = (of("right.patch[1].y_track") - of("left.patch[1].y_track")).mean()
    down, turned = 0.5 * (rails[:, 1] + rails[:, 4]), (rails[:, 4] - rails[:, 1]) / apart
    # what its shift by 2 mm adds on cones of 1:40 and hollow wheels, and the rails' roll
    for found, wanted in ((place[:, 1], down), (place[:, 2], turned)):
        assert np.abs(found - wanted - (found - wanted).mean()).max() < 0.08 * np.ptp(wanted)
