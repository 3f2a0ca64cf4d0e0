"""Normal and elastic contact at very many random poses (fuzzing.py): what has to hold at every one of them.

No number here is compared with one that the kernel has computed in the same way: a load with the one prescribed, a pressure's
integral with the load, a pose with its mirror image, with itself after another history, with the same bodies in another size
and of another stiffness, and a pose with those beside it.

A failure prints the line of Python that is its pose.
"""

import numpy as np
import pytest
from fuzzing import Cut, Poses, Scene, batches
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import wrcontact
from wrcontact import Status
from wrcontact.profiles import Profile, standard_profile
from wrcontact.profiles.zones import Arc

SIDES = (("left", -1), ("right", 1))
NAMES = ("penetration", "normal_force", "area", "max_pressure", "patch_length", "patch_width")
#: Powers of length in these at the same pressure.
POWERS = dict(zip(NAMES, (1, 2, 2, 0, 1, 1)))
#: Where one pose has one roll: a flange of 70 deg on a radius above 2 arms / tan(70 deg) has several, and beyond 0.093 rad of
#: yaw the outline folds back (test_rigid.py).
LARGEST_RADIUS = 0.54   # [m]
LARGEST_YAW = 0.09      # [rad]
#: Loads below this are less than a contact's place, known to 1e-12 m, tells of their patches: 1 kN sinks in by 5e-6 m.
HEAVY = 1e3             # [N]
#: Under more a wheel can stand deeper in a rail's corner than elastic contact allows, and it is chance whether one is found.
HEAVIEST = 3e5          # [N]
#: A contact that moves farther under a small change has jumped, or stands on profiles that are conformal to the last nanometre.
JUMPED = 1e-7           # [m]


def amounts(quick, share, complete):
    """Seeds, scenes and poses of each: for every run, for CI, and for a long run."""
    return pytest.mark.parametrize("seed, scenes, poses", [
        pytest.param(1, *quick, id="quick"),
        pytest.param(2, *share, id="share", marks=pytest.mark.slow),
        pytest.param(3, *complete, id="complete", marks=[pytest.mark.slow, pytest.mark.complete])])


def unique(seed, scenes, poses, **fixed):
    """Batches whose poses have one roll, on whole profiles."""
    for scene, drawn in batches(seed, scenes, poses, cuts=0.0, **fixed):
        radius = min(scene.arguments["nominal_radius"], LARGEST_RADIUS)
        yield Scene({**scene.arguments, "nominal_radius": radius}), drawn[np.abs(drawn.yaw) < LARGEST_YAW]


def heavy(poses):
    """The same poses under HEAVY at least on either wheel, and HEAVIEST at most."""
    return poses.changed(normal_force=np.clip(poses.normal_force, 10 * HEAVY, 0.5 * HEAVIEST),
                         load_transfer=np.clip(poses.load_transfer, -0.9, 0.9))


def forces(poses):
    """Prescribed on the left and on the right [N]."""
    return [poses.normal_force * (1 + sign * poses.load_transfer) for _, sign in SIDES]


def numbers(table, names=NAMES):
    """Outputs ``names`` of the left and of the right (2, names, n)."""
    return np.array([[getattr(getattr(table, side), name) for name in names] for side, _ in SIDES])


def differences(one, other, factors=(1.0,) * len(NAMES)):
    """Largest relative difference of each pose's NAMES (n,), ``one``'s times ``factors``; zeros agree."""
    a, b = numbers(one) * np.reshape(factors, (1, -1, 1)), numbers(other)
    return (np.abs(a - b) / np.where(b == 0.0, 1.0, np.abs(b))).max(axis=(0, 1))


def moved(one, other, scale=1.0):
    """How far the contacts of two tables are apart [m] (n,)."""
    return np.max([np.abs(getattr(one, side).contact.y_wheel - getattr(other, side).contact.y_wheel / scale)
                   for side, _ in SIDES], axis=0)


def assert_none(bad, scene, poses, what, measure=None):
    """No pose is ``bad`` (n,); the first that is, as a line of Python."""
    if np.any(bad):
        row = int(np.flatnonzero(bad)[0])
        found = "" if measure is None else f" {measure[row]:.3g}"
        pytest.fail(f"{what}{found}, {np.count_nonzero(bad)} of {len(bad)}: {scene.line(poses, row)}")


# --- loads, areas, pressures ----------------------------------------------------------------------------------------------------


def check_sound(scene, poses):
    """Statuses, loads and patches of one batch; how many of its poses have not converged."""
    table = scene.system().evaluate_many(**poses.arguments)
    compliant, vertical = (scene.arguments[name] == word for name, word in (("contact_mode", "compliant"), ("load", "vertical")))
    lost = table.status == Status.NOT_CONVERGED
    assert_none(table.status > Status.NOT_CONVERGED, scene, poses, "status", table.status)
    good = table.status <= Status.UNLOADED
    for (name, _), force in zip(SIDES, forces(poses)):
        side = getattr(table, name)
        loaded = good & ((side.normal_force > 0) if compliant else (force > 0))
        values = np.array([getattr(side, name) for name in NAMES] + [side.patch_count])
        assert_none(loaded & ~np.all(np.isfinite(values) & (values > 0), axis=0), scene, poses, f"{name} is not positive")
        assert_none(good & ~loaded & np.any(values != 0, axis=0), scene, poses, f"{name} has no load but a patch")
        if not compliant and not vertical:
            # solved to 1e-12, and added up over strips and nodes
            off = np.where(loaded, np.abs(side.normal_force - force) / np.where(loaded, force, 1.0), 0.0)
            assert_none(off > 1e-9, scene, poses, f"{name} misses its load by", off)
        with np.errstate(invalid="ignore", divide="ignore"):
            mean = side.normal_force / side.area
            # 1.5 for an ellipse, 1.27 for an endless line; 1 would be a flat punch
            peak = np.where(loaded, side.max_pressure / mean, 1.5)
        assert_none(peak < 1.0, scene, poses, f"{name} has a peak pressure below the mean one", peak)
    if vertical and not compliant:
        # the resultant is added up from the patches and their normals, the load is met region by region
        wanted = 2.0 * poses.normal_force
        both = good & (np.abs(poses.load_transfer) < 1) & (wanted > 0)
        off = np.where(both, np.abs(table.force.z + wanted) / np.where(both, wanted, 1.0), 0.0)
        assert_none(off > VERTICAL, scene, poses, "the vertical load is missed by", off)
    return int(np.count_nonzero(lost & (not scene.is_cut))), int(np.count_nonzero(lost)), scene, poses, lost


VERTICAL = 1e-6


@amounts((12, 100), (100, 100), (400, 1000))
def test_every_pose_has_a_status_and_sound_patches(seed, scenes, poses):
    """All modes, models and methods, profiles that are cut off among them.  Status 3 on whole profiles: none in 10 000 poses, and
    1 of 100 000, elastic with "vertical" distances under 700 kN."""
    whole = every = 0
    for scene, drawn in batches(seed, scenes, poses):
        found = check_sound(scene, drawn)
        whole, every = whole + found[0], every + found[1]
        if scenes * poses <= 10_000:
            assert_none(found[4] & (not scene.is_cut), scene, drawn, "not converged")
    assert whole <= 2e-5 * scenes * poses + 1 and every <= 2e-3 * scenes * poses


# --- mirror, history ------------------------------------------------------------------------------------------------------------


def check_mirror(scene, poses):
    system = scene.system()
    one, other = system.evaluate_many(**poses.arguments), system.evaluate_many(**poses.mirrored().arguments)
    assert_none(one.status != other.status, scene, poses, "status in the mirror", other.status)
    good = one.status <= Status.UNLOADED
    left, right = numbers(other)
    twin = np.array([right, left])
    if scene.arguments["contact_mode"] == "compliant":
        # given height and roll, both sides compute the same numbers
        assert_none(np.any((numbers(one) != twin)[..., good], axis=(0, 1)), scene, poses[good], "in the mirror")
    for name, sum_or_difference in (("roll", one.roll + other.roll), ("height", one.vertical_shift - other.vertical_shift)):
        off = np.where(good, np.abs(sum_or_difference), 0.0)
        assert_none(off > 1e-12, scene, poses, f"{name} in the mirror off by", off)       # [rad, m]
    off = np.max(np.abs(numbers(one) - twin) / np.where(twin == 0, 1.0, np.abs(twin)), axis=(0, 1))
    # 1e-12 m against the sharpest edge: a kilonewton's strip, 5e-6 m deep, next to a joint that bends 10 times as much
    assert_none(np.where(good, off, 0.0) > 1e-5, scene, poses, "patches in the mirror off by", off)
    return off[good]


@amounts((6, 100), (60, 60), (400, 500))
def test_left_is_the_mirror_image_of_right(seed, scenes, poses):
    off = np.concatenate([check_mirror(scene, heavy(drawn)) for scene, drawn in unique(seed, scenes, poses)])
    assert np.percentile(off, 90) < 1e-10


def check_history(scene, poses):
    system = scene.system()
    order = np.random.default_rng(len(poses)).permutation(len(poses))
    one, other = system.evaluate_many(**poses.arguments), system.evaluate_many(**poses[order].arguments)
    back = np.argsort(order)
    assert_none(one.status != other.status[back], scene, poses, "status after other poses", other.status[back])
    good = one.status <= Status.UNLOADED
    for name in ("roll", "vertical_shift"):
        off = np.where(good, np.abs(getattr(one, name) - getattr(other, name)[back]), 0.0)
        assert_none(off > 1e-12, scene, poses, f"{name} after other poses off by", off)   # [rad, m]
    a, b = numbers(one), numbers(other)[..., back]
    off = np.where(good, np.max(np.abs(a - b) / np.where(b == 0, 1.0, np.abs(b)), axis=(0, 1)), 0.0)
    assert_none(off > 1e-5, scene, poses, "patches after other poses off by", off)      # as for the mirror


@amounts((6, 100), (60, 60), (400, 500))
def test_what_came_before_changes_nothing(seed, scenes, poses):
    for scene, drawn in unique(seed, scenes, poses):
        check_history(scene, heavy(drawn))


# --- scaling --------------------------------------------------------------------------------------------------------------------

STIFFER = 1.7
LARGER = 1.17
LENGTHS = {"gauge": 1.435, "gauge_depth": 0.014, "running_circle_distance": 1.5, "nominal_radius": 0.46,
           "curvature_step": 0.2e-3, "curvature_reach": 3e-3}      # [m]


@amounts((6, 100), (60, 60), (400, 500))
def test_loads_times_stiffness_are_the_same_patches(seed, scenes, poses):
    """No force is hidden in the kernel: modulus and loads k-fold give the same lengths, and pressures k-fold."""
    factors = [STIFFER if name in ("normal_force", "max_pressure") else 1.0 for name in NAMES]
    for scene, drawn in unique(seed, scenes, poses):
        drawn = heavy(drawn)
        soft = scene.system().evaluate_many(**drawn.arguments)
        stiff = scene.system(youngs_modulus=STIFFER * 210e9).evaluate_many(
            **drawn.changed(normal_force=STIFFER * drawn.normal_force).arguments)
        assert_none(soft.status != stiff.status, scene, drawn, "status when stiffer", stiff.status)
        good = soft.status <= Status.UNLOADED
        roll = np.where(good, np.abs(soft.roll - stiff.roll), 0.0)
        assert_none(roll > 1e-11, scene, drawn, "roll when stiffer off by", roll)       # [rad]; 1e-12 of the stand, on flat profiles
        off = np.where(good, differences(soft, stiff, factors), 0.0)
        assert_none(off > 1e-6, scene, drawn, "patches when stiffer off by", off)


def larger_zone(zone):
    k = LARGER
    if isinstance(zone, Arc):
        return Arc(k * zone.start, k * zone.stop, k * zone.radius, k * zone.y_centre, k * zone.z_centre, zone.side)
    coefficients = tuple(c * k ** (1 - i) for i, c in enumerate(zone.coefficients))
    return type(zone)(k * zone.start, k * zone.stop, coefficients, k * zone.origin)


def larger(profile):
    """A profile LARGER times as large, from its name or Cut."""
    whole = profile.profile() if isinstance(profile, Cut) else standard_profile(profile)
    return Profile(whole.name, whole.kind, tuple(larger_zone(zone) for zone in whole.zones))


def check_size(scene, poses):
    """Which of the poses kept their places when all is larger (n,), and how far their patches are off."""
    changes = {name: LARGER * scene.arguments.get(name, value) for name, value in LENGTHS.items()}
    changes.update({name: larger(scene.arguments[name]) for name in ("wheel", "rail")})
    one = scene.system().evaluate_many(**poses.arguments)
    other = scene.system(**changes).evaluate_many(**poses.changed(
        lateral_shift=LARGER * poses.lateral_shift, normal_force=LARGER**2 * poses.normal_force,
        vertical_shift_input=LARGER * poses.vertical_shift_input).arguments)
    good = (one.status <= Status.UNLOADED) & (other.status <= Status.UNLOADED)
    kept = good & (moved(one, other, LARGER) < JUMPED)
    off = differences(one, other, [LARGER ** POWERS[name] for name in NAMES])
    return kept, np.where(kept, off, 0.0)


@amounts((6, 100), (60, 60), (400, 500))
def test_loads_times_area_are_the_same_pressures(seed, scenes, poses):
    """Lengths k-fold and loads k^2-fold give the same angles and pressures."""
    every = [check_size(scene, heavy(drawn)) for scene, drawn in unique(seed, scenes, poses, contact_mode="rigid")]
    kept, off = (np.concatenate(part) for part in zip(*every))
    print(kept.mean(), [np.percentile(off[kept], q) for q in (50, 90, 95, 99, 99.9, 100)])
