"""Random motions of random poses: every answer is a number, and mirrors have mirrored creepages."""

import numpy as np
import pytest

from tests.helpers.cases import system
from tests.helpers.moving_fuzz import creepages, mirrored_motion, motions


@pytest.mark.parametrize("mode, count", [
    ("rigid", 2000), ("compliant", 2000), pytest.param("rigid", 100_000, marks=pytest.mark.full),
    pytest.param("compliant", 100_000, marks=pytest.mark.full),
    pytest.param("elastic", 20_000, marks=pytest.mark.full)])
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
                              **mirrored_motion(motion))
    np.testing.assert_array_equal(here.status, there.status)
    valid = here.status <= 1
    assert valid.mean() > 0.9 and np.isfinite(here.values[valid]).all()
    for side, other in ((here.left, there.right), (here.right, there.left)):
        mine = creepages(side)[..., valid]
        twin = creepages(other)[..., valid] * np.array([1, -1, -1])[None, :, None]
        # the pose of a mirror has other last digits, and 1e-6 m/s is the least V_ref
        assert np.quantile(np.abs(mine - twin) / (1e-3 + np.abs(mine)), 0.999) < 1e-6
        assert (side.normal_force[valid] >= 0.0).all()
