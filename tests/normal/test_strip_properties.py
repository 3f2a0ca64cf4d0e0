"""The strip model over random poses: history, symmetry, limits and smoothness."""

import math

import numpy as np
import pytest

import wrcontact
from data.hertz import hertz
from tests.helpers.inside import workspace_of
from tests.helpers.strips import EXTENT, NAMES, POSE, errors, random_poses, step_all, system_of
from wrcontact import Status
from wrcontact.kernel import layout
from wrcontact.profiles.profile import Profile
from wrcontact.profiles.zones import Arc

# --- what was before changes nothing --------------------------------------------------------------


POISONS = {
    "nan": lambda work: work.fill(np.nan),
    "huge": lambda work: work.fill(1e300),
    "numbers": lambda work: np.copyto(work, np.random.default_rng(1).uniform(-1e3, 1e3, len(work))),
    "indices": lambda work: np.copyto(work, np.random.default_rng(2).integers(-3, 60, len(work))),
}


@pytest.mark.parametrize("poison", POISONS)
@pytest.mark.parametrize("model", ["hertz", "analyn", "analyn_strip"])
def test_nothing_is_read_from_the_workspace_that_was_not_written(model, poison):
    rows = random_poses(50, 41)
    rows[::10, layout.IN_NORMAL_FORCE] = 0.0
    clean = step_all(system_of(model).stepper(), rows)
    poisoned = step_all(
        system_of(model).stepper(), rows, before=lambda stepper: POISONS[poison](workspace_of(stepper))
    )
    assert np.all(np.isfinite(clean))
    np.testing.assert_array_equal(poisoned.view(np.int64), clean.view(np.int64))


# --- once wrong ----------------------------------------------------------------------------


def test_a_half_width_survives_a_first_guess_beyond_the_outline():
    """The flange of a wheel yawed by 5.2 degrees: its outline folds back within the first
    guess of the half-width."""
    pose = -4.67e-3, 0.09, 66549.97
    for model in ("analyn", "analyn_strip"):
        side = system_of(model, rail="54E1", rail_inclination=1 / 20).stepper("left")
        side.inputs[POSE] = pose
        assert side.step() == Status.VALID
        left = side.outputs[layout.OUT_LEFT :]
        assert left[layout.SIDE_AREA] == pytest.approx(2.000e-5, rel=0.05)  # half-space
        assert left[layout.SIDE_MAX_PRESSURE] == pytest.approx(4.982e9, rel=0.05)


def test_a_patch_on_a_flat_shelf_is_as_wide_as_the_half_space_says():
    """A light load on the tread: the gap levels off below the penetration 7 mm away."""
    pose = 0.68e-3, math.radians(-1.207), 5.08e3
    error = errors(system_of().evaluate(*pose).right, system_of("halfspace").evaluate(*pose).right)
    assert np.all(np.abs(error) < (0.02, 0.06, 0.06)), error


# --- light loads ----------------------------------------------------------------------------------


@pytest.mark.parametrize("yaw", [0.0, 0.005, -0.02, 0.035])
@pytest.mark.parametrize("force", [1e-3, 1e-1, 10.0, 100.0])
def test_light_loads_are_ellipses(force, yaw):
    """A patch of micrometres sees constant curvatures, where ANALYN is Hertz: strips as ANALYN, and no peak,
    p_max area / N = 1.5. Worst are patches on the flange, twenty times as long as wide."""
    shifts = np.linspace(-6.6e-3, 6.6e-3, 133)
    strip, plain = (
        system_of(model).evaluate_many(shifts, yaw, force) for model in ("analyn_strip", "analyn")
    )
    assert not strip.status.any() and not plain.status.any()
    for here, there in ((strip.left, plain.left), (strip.right, plain.right)):
        single = (here.patch_count == 1) & (there.patch_count == 1)
        assert single.mean() > 0.97
        peak = here.max_pressure * here.area / force
        assert np.all(peak[single] > 1.4) and np.all(peak[single] < 1.6)
        # measured 0.04, 0.07, 0.09 % in the mean and 0.30, 1.40, 3.20 % at most
        for name, mean, allowed in (
            ("penetration", 6e-4, 0.0045),
            ("area", 1.1e-3, 0.021),
            ("max_pressure", 1.35e-3, 0.048),
        ):
            ratio = getattr(here, name) / getattr(there, name)
            difference = np.abs(ratio[single] - 1)
            assert difference.mean() < mean, name
            assert difference.max() < allowed, (name, shifts[single][difference.argmax()])


@pytest.mark.parametrize("shift, yaw", [(0.0, 0.0), (1e-3, 0.01), (4e-3, -0.02), (6e-3, 0.0), (6.5e-3, 0.02)])
def test_light_loads_scale_like_hertz(shift, yaw):
    """Penetration and area with N^(2/3), pressure with N^(1/3), over six decades; measured 1.4e-4."""
    forces = np.geomspace(1e-6, 1.0, 13)
    side = system_of().evaluate_many(shift, yaw, forces).right
    for name, power in zip(NAMES, (2 / 3, 2 / 3, 1 / 3)):
        constant = getattr(side, name) / forces**power
        np.testing.assert_allclose(constant / constant[0], 1.0, atol=2.1e-4)


# --- prescribed penetration -----------------------------------------------------------------------


@pytest.mark.parametrize(
    "model, middle, most, worst",
    [
        # measured 0.0014, 0.11, 0.40 % with strips
        ("analyn_strip", 2.2e-5, 1.7e-3, 6e-3),
        ("analyn", 2e-3, 0.03, 0.1),
    ],
)
def test_prescribed_penetration_is_the_inverse(model, middle, most, worst):
    """The first strips lie over what overlaps at the estimated penetration in one case, and at the prescribed
    one in the other: some parts of a thousand of the load, where a region appears. So does the window over
    which ANALYN takes its lateral curvature: a few per cent of it, and much less of the force."""
    ratios = []
    for shift, yaw, force in random_poses(150, 45, low=1e3)[:, POSE]:
        one = system_of(model).evaluate(shift, yaw, force)
        depths = one.left.penetration, one.right.penetration
        back = system_of(model).evaluate(shift, yaw, penetration=depths)
        for there, here in ((one.left, back.left), (one.right, back.right)):
            assert here.penetration == there.penetration
            ratios.append(here.normal_force / there.normal_force - 1)
    found = np.quantile(np.abs(ratios), [0.5, 0.95, 0.99])
    assert np.all(found < (middle, most, worst)), found


@pytest.mark.parametrize("yaw", [0.0, 0.015])
@pytest.mark.parametrize("separation", ["vertical", "equidistant", "equidistant_chord"])
def test_the_depth_is_that_of_the_load_with_every_separation(separation, yaw):
    """On the tread the contact angle is below 6.5 degrees: distances to the rail differ by less than its
    cosine does from 1, 0.6 %, whichever way they are measured; measured 0.13 %. Once the depth stayed that of
    the first estimate, and could be less than nothing."""
    shift, force = np.meshgrid([-4e-3, -2e-3, 2e-3, 4e-3], [1e3, 1e4, 78.5e3, 2e5])
    along = system_of().evaluate_many(shift.ravel(), yaw, force.ravel())
    found = system_of(separation=separation).evaluate_many(shift.ravel(), yaw, force.ravel())
    for side in ("left", "right"):
        np.testing.assert_allclose(
            getattr(found, side).penetration, getattr(along, side).penetration, rtol=6e-3
        )


@pytest.mark.full
@pytest.mark.parametrize(
    "pose, side", [((0.39926e-3, 0.0, 3010.27), "right"), ((-0.65543e-3, -1.31087e-3, 9696.16), "left")]
)
def test_a_region_that_is_deeper_than_estimated_takes_up_load(pose, side):
    """By the half-space; the strips find it where they are given the same penetration."""
    truth = getattr(system_of("halfspace").evaluate(*pose), side)
    back = system_of().evaluate(*pose[:2], penetration=truth.penetration, side=side, outputs="patches")
    assert getattr(back, side).normal_force == pytest.approx(pose[2], rel=7e-3)
    error = errors(getattr(system_of().evaluate(*pose), side), truth)
    # measured 0.12, 0.73 and 3.8 %: the peak of the first pose lies on a joint of arcs in a patch over both
    # regions; 12 strips have 1.1 % there
    assert np.all(np.abs(error) < (1.8e-3, 0.011, 0.056)), error


@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
@pytest.mark.parametrize("yaw", [0.0, 0.01, 0.02])
def test_force_rises_with_penetration(yaw, model):
    for shift in np.linspace(-6.6e-3, 6.6e-3, 23):
        loads = [
            system_of(model)
            .evaluate(shift, yaw, penetration=depth, side="right", outputs="patches")
            .right.normal_force
            for depth in np.linspace(5e-6, 2e-4, 60)
        ]
        assert np.all(np.diff(loads) > 0), shift


@pytest.mark.parametrize("model", ["hertz", "analyn", "analyn_strip"])
def test_no_penetration_is_no_load(model):
    """Whatever force is given beside it; the other wheel does not mind."""
    state = system_of(model).evaluate(2e-3, penetration=(0.0, 5e-5))
    assert state.status == Status.UNLOADED and np.all(np.isfinite(state.values))
    assert state.left.patch_count == 0 and state.left.normal_force == 0.0
    assert state.right.penetration == 5e-5 and state.right.normal_force > 1e4


# --- pairs from hell ------------------------------------------------------------------------------


@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
@pytest.mark.parametrize("hollow", [90.2, 91.0, 95.0, 120.0, 300.0])
def test_nearly_conformal_pairs(hollow, model):
    """A hollow wheel of almost the rail's radius: valid or not converged, and never anything but numbers."""
    wheel = Profile("hollow", "wheel", (Arc(-35.0, 35.0, hollow, 0.0, hollow, -1),))
    rail = Profile("crown", "rail", (Arc(-30.0, 30.0, 90.0, 0.0, 90.0, -1),))
    system = wrcontact.ContactSystem(
        wheel, rail, rail_inclination=0.0, gauge=1.44, gauge_depth=5e-3, normal_model=model
    )
    table = system.evaluate_many(np.repeat([-2e-3, 0.0, 1e-3], 4), 0.0, np.tile([1.0, 1e3, 3e4, 1.5e5], 3))
    assert set(table.status) <= {Status.VALID, Status.NOT_CONVERGED, Status.OFF_PROFILE}
    valid = table.status == Status.VALID
    assert np.all(np.isfinite(table.values[valid])) and np.all(np.isnan(table.values[~valid]))


@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
@pytest.mark.parametrize("radius", [6.0, 10.0, 30.0])
def test_sharp_crowns(radius, model):
    """A crown of millimetres under a wheel of half a metre: patches twenty times longer along
    the track than across."""
    wheel = Profile("flat", "wheel", (Arc(-50.0, 50.0, 5000.0, 0.0, -5000.0, 1),))
    rail = Profile("ridge", "rail", (Arc(-0.99 * radius, 0.99 * radius, radius, 0.0, radius, -1),))
    system = wrcontact.ContactSystem(
        wheel,
        rail,
        rail_inclination=0.0,
        gauge=1.5 - 2e-3 * math.sqrt(10 * radius - 25),
        gauge_depth=0.005,
        normal_model=model,
    )
    table = system.evaluate_many([0.0, 1e-3, -2e-3, 0.0], [0.0, 0.01, 0.0, 0.02], [1.0, 100.0, 1e3, 1e4])
    assert set(table.status) <= {Status.VALID, Status.NOT_CONVERGED}
    assert np.all(np.isfinite(table.values[table.status == Status.VALID]))
    assert table.status[0] == Status.VALID
    penetration, a, b, pressure = hertz(
        0.5 * table.right.curvature_x[0], 0.5 * table.right.curvature_y[0], 1.0
    )
    assert table.right.penetration[0] == pytest.approx(penetration, rel=0.01)
    assert table.right.area[0] == pytest.approx(math.pi * a * b, rel=0.02)
    assert table.right.max_pressure[0] == pytest.approx(pressure, rel=0.02)


# --- smoothness -----------------------------------------------------------------------------------


SWEEP = np.arange(-6600, 6601, 10) * 1e-6
#: Lateral shifts of a right wheel [mm] where a second difference over 10 um may exceed 1 %, and why.
ROUGH = {
    "a second region opens or is joined, and the model takes a step": [(-0.42, -0.10), (4.38, 4.60)],
    "the load changes from one region to the other": [(-0.04, 0.27), (4.74, 5.58)],
    "the rigid contact jumps, or moves a millimetre in 10 um": [(6.04, 6.30)],
    "the contact passes a joint of the flange's arcs: the half-space moves that fast too": [(6.33, 6.44)],
}
#: The same with strips, at the same places, but narrower.
ROUGH_STRIPS = [
    (-0.37, -0.33),
    (0.18, 0.27),
    (4.41, 4.58),
    (4.77, 4.90),
    (5.34, 5.58),
    (6.13, 6.31),
    (6.34, 6.46),
]
#: Of area, peak and width also where the patch's edge passes the joint of the wheel's arcs, from -1.09 mm on,
#: and where the second part of a patch becomes a run of its own, from 5.58 mm on.
ROUGH_EDGES = {
    "area": [(-1.09, -1.01)],
    "max_pressure": [(-1.09, -1.01), (5.66, 5.72)],
    "patch_width": [(5.58, 5.66)],
}
#: Second differences there; measured 1.5 %.
ROUGHEST_EDGE = 0.02
#: The median everywhere; measured 2.4e-5 and 1.7e-5, both of the width.
MEDIAN = {"analyn": 3.7e-5, "analyn_strip": 2.6e-5}
#: Share of the shifts in windows.
ROUGH_SHARE = {"analyn": 0.17, "analyn_strip": 0.1}


def roughness(model, yaw, name):
    """Second differences over the sweep (n,), as shares of the value or of 10 mm for the centroid."""
    table = system_of(model).evaluate_many(SWEEP, yaw, outputs="patches")
    assert not table.status.any()
    values = getattr(table.right, name)
    scale = 1e-2 if name == "patch_centroid" else np.abs(values[1:-1])
    return np.abs(np.diff(values, 2)) / scale


@pytest.mark.parametrize("name", [*EXTENT, "patch_centroid"])
@pytest.mark.parametrize("yaw", [0.0, 0.01])
@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
def test_outputs_move_smoothly(model, yaw, name):
    """Second differences over 10 um below 1 % but for named places, the median some 1e-5."""
    rough = roughness(model, yaw, name)
    windows, edges = sum(ROUGH.values(), []), []
    if model == "analyn_strip":
        windows, edges = ROUGH_STRIPS, ROUGH_EDGES.get(name, [])
    shift = SWEEP[1:-1] * 1e3
    named, beside = (
        np.any([(shift >= low) & (shift <= high) for low, high in [(9.0, 9.0), *places]], axis=0)
        for places in (windows, edges)
    )
    assert np.all(rough[beside & ~named] < ROUGHEST_EDGE)
    inside = named | beside
    worst = np.argmax(np.where(inside, 0.0, rough))
    assert rough[~inside].max() < 0.01, (shift[worst], rough[worst])
    assert np.median(rough) < MEDIAN[model]
    assert inside.mean() < ROUGH_SHARE[model]


@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
@pytest.mark.parametrize("load, force", [("normal", 216.86e3), ("vertical", 73.9e3)])
def test_a_patch_that_reaches_the_profile_s_end_grows_smoothly(model, load, force):
    """Half newtons on a yawed wheel whose half-width ends with the profile: once two answers took
    turns, 0.15 % apart, as the slant was measured to the end or to the middle. Every step is that of
    a load's power 1/2 ... 1."""
    forces = force + 0.5 * np.arange(200)
    table = system_of(model, load=load).evaluate_many(6.156e-3, -0.0245, forces, load_transfer=0.75)
    assert not table.status.any()
    for name, least, most in (("penetration", 0.5, 1.0), ("max_pressure", 0.1, 1.0)):
        powers = np.diff(np.log(getattr(table.right, name))) / np.diff(np.log(forces))
        assert least < powers.min() and powers.max() < most, (name, powers.min(), powers.max())
