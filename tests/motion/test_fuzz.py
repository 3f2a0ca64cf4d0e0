"""Random motions of random poses: every answer is a number, and mirrors have mirrored creepages."""

import numpy as np
import pytest

from tests.helpers.cases import system
from wrcontact.interface.motion import MOTION

SIGNS = {"lateral_velocity": -1, "yaw_rate": -1, "roll_rate": -1, "track_curvature": -1}


def motions(count, rng):
    """Velocities of all sizes up to the limits, of either sign, a third of them zero."""
    given = {}
    for row in MOTION:
        sizes = row.maximum * 10.0 ** rng.uniform(-12, 0, count) * rng.choice([-1.0, 0.0, 1.0], count)
        given[row.keyword] = (sizes != 0.0).astype(float) if row.switch else sizes
    return given


def mirrored(motion):
    """The motion in the mirror along the track; rails change places."""
    found = {}
    for name, values in motion.items():
        other = name.replace("left", "?").replace("right", "left").replace("?", "right")
        sign = SIGNS.get(name, -1 if name.endswith(("lateral_velocity", "roll_velocity")) else 1)
        found[other] = sign * values
    return found


def creepages(side):
    return np.array([[patch.creepage.x, patch.creepage.y, patch.creepage.spin] for patch in side.patches])


@pytest.mark.parametrize("mode, count", [
    ("rigid", 2000), ("compliant", 2000), pytest.param("rigid", 100_000, marks=pytest.mark.slow),
    pytest.param("compliant", 100_000, marks=pytest.mark.slow),
    pytest.param("elastic", 20_000, marks=pytest.mark.slow)])
def test_random_motions(mode, count):
    rng = np.random.default_rng(17)
    pose = dict(lateral_shift=rng.uniform(-8e-3, 8e-3, count),
                yaw=rng.uniform(-0.03, 0.03, count) * (rng.random(count) < 0.5))
    signs = dict.fromkeys(("lateral_shift", "yaw", "roll_input"), -1)
    more = {}
    if mode == "compliant":
        stand = system(normal_model="hertz").evaluate_many(**pose)
        pose |= dict(vertical_shift_input=stand.vertical_shift + rng.uniform(-2e-5, 2e-4, count),
                     roll_input=stand.roll)
        more = {"contact_damping": 0.1}
    one, motion = system(contact_mode=mode, normal_model="hertz", **more), motions(count, rng)
    here = one.evaluate_many(**pose, **motion)
    there = one.evaluate_many(**{name: signs.get(name, 1) * values for name, values in pose.items()},
                              **mirrored(motion))
    np.testing.assert_array_equal(here.status, there.status)
    valid = here.status <= 1
    assert valid.mean() > 0.9 and np.isfinite(here.values[valid]).all()
    for side, other in ((here.left, there.right), (here.right, there.left)):
        mine = creepages(side)[..., valid]
        twin = creepages(other)[..., valid] * np.array([1, -1, -1])[None, :, None]
        # the pose of a mirror has other last digits, and 1e-6 m/s is the least V_ref
        assert np.quantile(np.abs(mine - twin) / (1e-3 + np.abs(mine)), 0.999) < 1e-6
        assert (side.normal_force[valid] >= 0.0).all()
