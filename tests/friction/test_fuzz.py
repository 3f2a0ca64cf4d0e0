"""Random wheelsets with friction, two different sides, rails that are displaced and roll, and motions of all
sizes: what has to hold of creep forces.  A failure prints the line of Python that is its pose."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.contact_fuzz import amounts
from tests.helpers.moving_fuzz import (
    MODES,
    SIDES,
    assert_none,
    draw_friction,
    draw_poses,
    draw_wheelset,
    mirrored,
)
from wrcontact.status import Status


def patches_of(table):
    """(Side, number, friction's limit as a whole, patch) of all patches."""
    for name in SIDES:
        for number, patch in enumerate(getattr(table, name).patches):
            yield name, number, patch


def check_creep(wheelset, given, table):
    """Sizes, powers and sums of one batch; poses (n,) that have a result."""
    check = dict(wheelset=wheelset, given=given)
    good = table.status <= Status.UNLOADED
    assert_none(good & ~np.isfinite(table.values).all(axis=-1), what="not a number", **check)
    for name, number, patch in patches_of(table):
        what = f"{name}.patch[{number + 1}]"
        # the flange's ratio and the fall only take friction away
        limit = given[f"{name}_friction"] * patch.normal_force
        force = np.hypot(patch.tangential.x, patch.tangential.y)
        assert_none(good & (force > limit * (1 + 1e-12)), what=f"{what}: a force above friction", **check)
        for share in ("stick_share", "saturation"):
            value = getattr(patch, share)
            assert_none(good & ~((value >= 0) & (value <= 1 + 1e-12)), what=f"{what}: {share}", measure=value,
                        **check)
        assert_none(good & ~(patch.max_shear >= 0.0), what=f"{what}: a negative traction", **check)
        # of what friction takes at most: the whole of it, at the speed of the inputs and the wheels
        most = limit * (np.abs(given["speed"]) + np.abs(given["wheel_rate"]) * patch.rolling_radius)
        power = patch.friction_power / (1e-12 + most)
        # strips with rolling radii of their own rub as if apart from the patch's plane, in which its force
        # acts: Hertz's ellipses reach far out of it
        least = -0.1 if wheelset["normal_model"] == "hertz" else -1e-4
        assert_none(good & (power < least), what=f"{what}: friction drives", measure=power, **check)
    return good


@pytest.mark.parametrize("mode", MODES)
@amounts((6, 50), (20, 100), (40, 500))
def test_creep_forces_of_random_wheelsets(seed, scenes, poses, mode):
    off = []
    for number in range(scenes):
        rng = np.random.default_rng([seed, 77, MODES.index(mode), number])
        wheelset = draw_wheelset(rng, mode)
        given = draw_poses(rng, wheelset, poses)
        wheelset, friction = draw_friction(rng, wheelset, poses)
        given |= friction
        table = wrcontact.ContactSystem(**wheelset).evaluate_many(**given)
        good = check_creep(wheelset, given, table)
        other_wheelset, other = mirrored(wheelset, {name: values for name, values in given.items()
                                                    if name not in friction})
        other |= {f"{side}_friction": friction[f"{turned}_friction"]
                  for side, turned in zip(SIDES, SIDES[::-1])}
        there = wrcontact.ContactSystem(**other_wheelset).evaluate_many(**other)
        assert good.mean() > 0.7
        both = good & (there.status <= Status.UNLOADED)
        for one, twin, name in ((table.left, there.right, "left"), (table.right, there.left, "right")):
            for mine, its in zip(one.patches, twin.patches):
                same = both & (np.abs(mine.normal_force - its.normal_force) <= 1e-9 * mine.normal_force)
                limit = 1e-9 + given[f"{name}_friction"] * mine.normal_force
                apart = np.hypot(mine.tangential.x - its.tangential.x, mine.tangential.y - its.tangential.y)
                off.append((apart / limit)[same])
    off = np.concatenate(off)
    # creepages agree to rounding; where that is all there is of them, 1 of 100 000, it is their direction too
    assert np.quantile(off, 0.999) < 1e-6 and np.mean(off > 1e-2) < 1e-4
