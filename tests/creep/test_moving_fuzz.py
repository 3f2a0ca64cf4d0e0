"""Random wheelsets with two different sides over rails that are displaced and roll, while all moves, with and
without friction: what has to hold at every pose. A failure prints the line of Python that is its pose."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.contact_fuzz import amounts
from tests.helpers.moving_fuzz import (
    LOADS,
    MODES,
    SIDES,
    TURNED,
    assert_none,
    creepages,
    draw_friction,
    draw_poses,
    draw_wheelset,
    mirrored,
)
from wrcontact.status import Status

#: What a wheel has that is not negative.
SIZES = ("normal_force", "area", "max_pressure", "patch_length", "patch_width")


def vectors(of, name):
    """(3, n)"""
    return np.array([getattr(getattr(of, name), axis) for axis in "xyz"])


def patch_vectors(side, name):
    """The sum over the patches (3, n)."""
    return sum(vectors(patch, name) for patch in side.patches)


def check_sound(wheelset, given, table):
    """Statuses, numbers, loads and balance of one batch."""
    check = dict(wheelset=wheelset, given=given)
    good = table.status <= Status.UNLOADED
    assert_none(table.status > Status.NOT_CONVERGED, what="status", **check)
    assert_none(good & ~np.isfinite(table.values).all(axis=-1), what="not a number", **check)
    compliant = wheelset["contact_mode"] == "compliant"
    for name, sign in zip(SIDES, (-1, 1)):
        side = getattr(table, name)
        for size in SIZES:
            assert_none(good & ~(getattr(side, size) >= 0), what=f"{name}.{size} is negative", **check)
        total = sum(patch.normal_force for patch in side.patches)
        three = side.patch_count <= 3  # a wheel may carry on more patches than are reported
        for what, load in (
            ("patches", np.where(three, total, side.normal_force)),
            *(
                ()
                if compliant
                else (("inputs", given["normal_force"] * (1 + sign * given["load_transfer"])),)
            ),
        ):
            # solved to 1e-12, and added up over strips and nodes
            off = np.where(good, np.abs(side.normal_force - load), 0.0) / (1.0 + np.abs(load))
            assert_none(off > 1e-9, what=f"{name} misses the load of its {what} by", measure=off, **check)
        force = vectors(side, "force")
        off = np.where(good & three, np.abs(force - patch_vectors(side, "force")).max(axis=0), 0.0)
        assert_none(off > 1e-12 * LOADS[1], what=f"{name}: patches miss the force by", measure=off, **check)
        longer = np.where(good, np.linalg.norm(force, axis=0) - side.normal_force, 0.0)
        assert_none(
            longer > 1e-9 * (1 + side.normal_force), what=f"{name}: a resultant above its loads", **check
        )
    for name in ("force", "moment"):
        both = vectors(table.left, name) + vectors(table.right, name)
        off = np.where(good, np.abs(vectors(table, name) - both).max(axis=0), 0.0)
        near = 1e-12 * (LOADS[1] + np.abs(both).max(axis=0))
        assert_none(off > near, what=f"{name} of both wheels is off by", measure=off, **check)
    return good


def wheelsets(seed, scenes, mode):
    for number in range(scenes):
        rng = np.random.default_rng([*np.atleast_1d(seed), MODES.index(mode), number])
        yield rng, draw_wheelset(rng, mode)


def check_mirror(wheelset, given, table):
    """The other wheelset in the mirrored pose has the statuses, heights and rolls of this one; how far the
    patches and creepages are off, with left and right exchanged, relative (n,) each."""
    other_wheelset, other_given = mirrored(wheelset, given)
    there = wrcontact.ContactSystem(**other_wheelset).evaluate_many(**other_given)
    check = dict(wheelset=wheelset, given=given)
    assert_none(table.status != there.status, what="status in the mirror", measure=there.status, **check)
    good = table.status <= Status.UNLOADED
    for name, apart in (
        ("roll", table.roll + there.roll),
        ("height", table.vertical_shift - there.vertical_shift),
    ):
        # rigid rolls are found to 1e-14 rad; elastic heights to 1e-13 m, beside a jump to 1e-9 m
        elastic = wheelset["contact_mode"] == "elastic"
        off = np.where(good, np.abs(apart), 0.0) > (1e-8 if elastic else 1e-11)
        assert_none(off & ~elastic, what=f"{name} in the mirror off by", measure=np.abs(apart), **check)
        good = good & ~off
    patches, slides = np.zeros(len(good)), np.zeros(len(good))
    for one, other in ((table.left, there.right), (table.right, there.left)):
        for name in SIZES:
            mine, twin = getattr(one, name), getattr(other, name)
            patches = np.maximum(patches, np.abs(mine - twin) / (1e-9 + np.abs(mine)))
        mine, twin = creepages(one), creepages(other) * np.array([1, -1, -1])[None, :, None]
        slides = np.maximum(slides, (np.abs(mine - twin) / (1e-3 + np.abs(mine))).max(axis=(0, 1)))
    if wheelset["contact_mode"] == "elastic":
        # the velocities of its height and roll are found, to 1e-5 of how fast it moves across: over a speed of
        # nothing that is no creepage
        slides[np.abs(given["speed"]) < 1e-2] = 0.0
    return patches[good], slides[good]


@pytest.mark.parametrize("mode", MODES)
@amounts((6, 50), (40, 100), (67, 500))
def test_every_pose_is_sound_and_has_a_mirror_image(seed, scenes, poses, mode):
    """Poses with status 3 are counted, and elastic ones that snap as their height is sought, which may stand
    elsewhere in the mirror: 1 of 20 000."""
    lost, snapped, patches, slides = 0, 0, [], []
    for rng, wheelset in wheelsets(seed, scenes, mode):
        given = draw_poses(rng, wheelset, poses)
        table = wrcontact.ContactSystem(**wheelset).evaluate_many(**given)
        good = check_sound(wheelset, given, table)
        lost += np.count_nonzero(table.status == Status.NOT_CONVERGED)
        near, slid = check_mirror(wheelset, given, table)
        snapped += np.count_nonzero(good) - len(near)
        patches.append(near)
        slides.append(slid)
        assert good.mean() > 0.8
    patches, slides = np.concatenate(patches), np.concatenate(slides)
    assert lost <= 1 + 1e-4 * scenes * poses and snapped <= 1 + 3e-4 * scenes * poses
    # at a jump of the contact 1e-12 m decide; an edge strip of a conformal patch carries load or not
    # velocities of an elastic wheelset are found to 1e-5 of how fast it moves across (1.5e-5 measured)
    near = 5e-5 if mode == "elastic" else 1e-6
    assert np.quantile(patches, 0.999) < 1e-6 and np.quantile(slides, 0.999) < near
    # and an elastic wheelset beside a jump of a wheel's load, by 1e-8 m, carries it here or there
    beside = np.count_nonzero((patches > 0.03) | (slides > 0.03))
    assert beside <= (3e-4 * len(patches) if mode == "elastic" else 0)


@pytest.mark.parametrize("mode", MODES)
@amounts((2, 30), (6, 100), (20, 500))
def test_zeros_are_as_good_as_nothing(seed, scenes, poses, mode):
    """Rails in their nominal place and a wheelset that does not move: the bits of a call without them. Sides
    that are given twice are one."""
    for rng, wheelset in wheelsets(seed, scenes, mode):
        given = draw_poses(rng, wheelset, poses)
        new = [name for name in given if name not in (*TURNED, "normal_force", "vertical_shift_input")]
        plain = {name: values for name, values in given.items() if name not in new}
        zeros = plain | {name: np.full(poses, float(name == "free_rolling")) for name in new}
        system = wrcontact.ContactSystem(**wheelset)
        one, other = system.evaluate_many(**plain), system.evaluate_many(**zeros)
        np.testing.assert_array_equal(one.status, other.status)
        np.testing.assert_array_equal(one.values, other.values)
        pairs = {name: values for name, values in wheelset.items() if isinstance(values, tuple)}
        once, twice = (
            {
                **wheelset,
                **{name: right if count == 1 else (right, right) for name, (_, right) in pairs.items()},
            }
            for count in (1, 2)
        )
        one, other = (wrcontact.ContactSystem(**sides).evaluate_many(**given) for sides in (once, twice))
        np.testing.assert_array_equal(one.values, other.values)


# --- creep forces ---------------------------------------------------------------------------------


def patches_of(table):
    """(Side, number, friction's limit as a whole, patch) of all patches."""
    for name in SIDES:
        for number, patch in enumerate(getattr(table, name).patches):
            yield name, number, patch


#: The sharpest bend of these rails, at the gauge corner [m].
SHARPEST = 0.013


def greatest_slip(given, name, rate, patch):
    """The largest sliding velocity [m/s] in a patch: that of its centre and what its places can differ from
    it, turning with the wheelset and about the patch's normal. The speed of the centre is rolling speed times
    creepage; rolling speed is at most the larger one of the speeds of inputs and wheel.

    Where a patch turns, what approaches its centre slides at its other places: velocities of compliant
    contact need not fit the rail.
    """
    zero = np.zeros(len(patch.width))
    approach = sum(
        np.abs(given.get(key, zero))
        for key in (
            "lateral_velocity",
            "vertical_velocity",
            "roll_rate",
            "yaw_rate",
            f"{name}_rail_lateral_velocity",
            f"{name}_rail_vertical_velocity",
            f"{name}_rail_roll_velocity",
        )
    )  # arms are shorter than 1 m
    rolling = np.maximum(np.abs(given["speed"]), rate * patch.rolling_radius)
    turning = (
        rate
        + np.abs(given["yaw_rate"])
        + np.abs(given["speed"] * given["track_curvature"])
        + rolling * np.abs(patch.creepage.spin)
    )
    # a wheelset that slides and does not roll has no creepages, but velocities; the rails move it, too
    moves = sum(
        np.abs(given.get(f"{side}_rail_{part}_velocity", zero))
        for side in SIDES
        for part in ("lateral", "vertical", "roll")
    )
    sliding = np.where(np.hypot(patch.creepage.x, patch.creepage.y) > 0.0, 0.0, 3.0 * (approach + moves))
    return (
        sliding
        + 1.1 * rolling * np.hypot(patch.creepage.x, patch.creepage.y)
        + (patch.length + patch.width) * turning
        + approach * np.minimum(1.0, patch.width / SHARPEST)
    )


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
            assert_none(
                good & ~((value >= 0) & (value <= 1 + 1e-12)), what=f"{what}: {share}", measure=value, **check
            )
        assert_none(good & ~(patch.max_shear >= 0.0), what=f"{what}: a negative traction", **check)
        # of what friction takes at most: the whole of it, at the speed of the inputs and the wheels
        rate = np.abs(getattr(table, name).wheel_rate_found)
        most = limit * (np.abs(given["speed"]) + rate * patch.rolling_radius)
        power = patch.friction_power / (1e-12 + most)
        assert_none(good & (power < -1e-9), what=f"{what}: friction drives", measure=power, **check)
        power = patch.friction_power / (1e-12 + limit * greatest_slip(given, name, rate, patch))
        assert_none(
            good & (power > 1.0), what=f"{what}: friction takes more than there is", measure=power, **check
        )
    return good


@pytest.mark.parametrize("mode", MODES)
@amounts((6, 50), (20, 100), (134, 500))
def test_creep_forces_of_random_wheelsets(seed, scenes, poses, mode):
    off = []
    for rng, wheelset in wheelsets([seed, 77], scenes, mode):
        given = draw_poses(rng, wheelset, poses)
        wheelset, friction = draw_friction(rng, wheelset, poses)
        given |= friction
        table = wrcontact.ContactSystem(**wheelset).evaluate_many(**given)
        good = check_creep(wheelset, given, table)
        other_wheelset, other = mirrored(
            wheelset, {name: values for name, values in given.items() if name not in friction}
        )
        other |= {
            f"{side}_friction": friction[f"{turned}_friction"] for side, turned in zip(SIDES, SIDES[::-1])
        }
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
