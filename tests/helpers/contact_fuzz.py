"""What has to hold of the contacts of random scenes, and how far two answers may be apart."""

import numpy as np
import pytest

from tests.helpers.fuzzing import Cut, Scene, batches
from wrcontact.profiles import Profile, standard_profile
from wrcontact.profiles.zones import Arc

SIDES = (("left", -1), ("right", 1))
NAMES = ("penetration", "normal_force", "area", "max_pressure", "patch_length", "patch_width")
#: Powers of length in these at the same pressure.
POWERS = dict(zip(NAMES, (1, 2, 2, 0, 1, 1)))
#: Where one pose has one roll: a flange of 70 deg on a radius above 2 arms / tan(70 deg) has several, and
#: beyond 0.093 rad of yaw the outline folds back (test_rigid.py).
LARGEST_RADIUS = 0.54  # [m]
LARGEST_YAW = 0.09  # [rad]
#: Loads below this are less than a contact's place, known to 1e-12 m, tells of their patches:
#: 1 kN sinks in by 5e-6 m.
HEAVY = 1e3  # [N]
#: Under more a wheel can stand deeper in a rail's corner than elastic contact allows, and it is chance
#: whether one is found.
HEAVIEST = 3e5  # [N]
#: A contact that moves farther under a small change has jumped, or stands on profiles that are
#: conformal to a nanometre.
JUMPED = 1e-7  # [m]
#: The vertical load is met region by region, and added up again from the patches and their normals: 8e-12
#: measured, relative.
VERTICAL = 1e-9

#: A wheel of a smaller load [N] has none.
LEAST_LOAD = 1e-10


def amounts(quick, share, complete):
    """Seeds, scenes and poses of each: for every run, for CI, and for a long run."""
    return pytest.mark.parametrize(
        "seed, scenes, poses",
        [
            pytest.param(1, *quick, id="quick"),
            pytest.param(2, *share, id="share", marks=pytest.mark.full),
            pytest.param(3, *complete, id="complete", marks=pytest.mark.complete),
        ],
    )


def unique(seed, scenes, poses, **fixed):
    """Batches whose poses have one roll, on whole profiles."""
    for scene, drawn in batches(seed, scenes, poses, cuts=0.0, **fixed):
        radius = min(scene.arguments["nominal_radius"], LARGEST_RADIUS)
        yield Scene({**scene.arguments, "nominal_radius": radius}), drawn[np.abs(drawn.yaw) < LARGEST_YAW]


def heavy(poses):
    """The same poses under HEAVY at least on either wheel, and HEAVIEST at most."""
    return poses.changed(
        normal_force=np.clip(poses.normal_force, 10 * HEAVY, 0.5 * HEAVIEST),
        load_transfer=np.clip(poses.load_transfer, -0.9, 0.9),
    )


def forces(poses):
    """Prescribed on the left and on the right [N]."""
    wanted = (poses.normal_force * (1 + sign * poses.load_transfer) for _, sign in SIDES)
    return [np.where(force < LEAST_LOAD, 0.0, force) for force in wanted]


def numbers(table, names=NAMES):
    """Outputs ``names`` of the left and of the right (2, names, n)."""
    return np.array([[getattr(getattr(table, side), name) for name in names] for side, _ in SIDES])


def differences(one, other, factors=1.0):
    """Largest relative difference of each pose's NAMES (n,), ``one``'s times ``factors``; zeros agree."""
    a, b = numbers(one) * np.reshape(factors, (1, -1, 1)), numbers(other)
    return (np.abs(a - b) / np.where(b == 0.0, 1.0, np.abs(b))).max(axis=(0, 1))


def moved(one, other, scale=1.0):
    """How far the contacts of two tables are apart [m] (n,)."""
    return np.max(
        [
            np.abs(getattr(one, side).contact.y_wheel - getattr(other, side).contact.y_wheel / scale)
            for side, _ in SIDES
        ],
        axis=0,
    )


def assert_none(bad, scene, poses, what, measure=None):
    """No pose is ``bad`` (n,); the first that is, as a line of Python."""
    if np.any(bad):
        row = int(np.flatnonzero(bad)[0])
        found = "" if measure is None else f" {measure[row]:.3g}"
        pytest.fail(f"{what}{found}, {np.count_nonzero(bad)} of {len(bad)}: {scene.line(poses, row)}")


STIFFER = 1.7
LARGER = 1.17
LENGTHS = {
    "gauge": 1.435,
    "gauge_depth": 0.014,
    "running_circle_distance": 1.5,
    "nominal_radius": 0.46,
    "curvature_step": 0.2e-3,
    "curvature_reach": 3e-3,
}  # [m]


def larger_zone(zone):
    k = LARGER
    if isinstance(zone, Arc):
        return Arc(
            k * zone.start, k * zone.stop, k * zone.radius, k * zone.y_centre, k * zone.z_centre, zone.side
        )
    coefficients = tuple(c * k ** (1 - i) for i, c in enumerate(zone.coefficients))
    return type(zone)(k * zone.start, k * zone.stop, coefficients, k * zone.origin)


def larger(profile):
    """A profile LARGER times as large, from its name or Cut."""
    whole = profile.profile() if isinstance(profile, Cut) else standard_profile(profile)
    return Profile(whole.name, whole.kind, tuple(larger_zone(zone) for zone in whole.zones))
