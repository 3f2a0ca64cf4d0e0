"""The half-space on the true gap: tables, the independent program, and its place in ContactSystem."""

import dataclasses
import math
import pickle

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

import wrcontact
from data import brute_force, conformal_reference, halfspace_reference
from data.hertz import MODULUS, hertz
from tests.helpers.cases import planar_cases
from tests.helpers.inside import solver_of, tables_of
from tests.helpers.mirror import side_signs
from wrcontact import Status
from wrcontact.conventions import MIRROR
from wrcontact.halfspace import contact, outputs, stepping
from wrcontact.halfspace.turning_gap import turning_gap
from wrcontact.halfspace.wheel_on_rail import wheel_on_rail
from wrcontact.kernel import layout
from wrcontact.methods import Halfspace

# --- tables and the independent program -----------------------------------------------------------


@pytest.mark.parametrize("case", planar_cases(), ids=lambda case: f"{case['y_ws_mm']}mm")
def test_complete_theory_on_the_planar_gap(case):
    """CONTACT on the same h = x^2/2R + g(s) with cells of 0.1 mm: measured 4.1e-5 in penetration, 0.083 % in
    peak pressure, 0.40 % in area (theirs is larger by about 0.05 cells along the edge)."""
    s_given, height = (
        np.array(case["s_mm"]) * 1e-3,
        CubicSpline(np.array(case["s_mm"]) * 1e-3, np.array(case["g_mm"]) * 1e-3),
    )

    def gap(x, s):
        across = np.where((s >= s_given[0]) & (s <= s_given[-1]), height(s), np.inf)
        return x[:, None] ** 2 / (2e-3 * case["R_x_mm"]) + across

    found = contact.solve_contact(
        gap, (-0.02, 0.02, s_given[0], s_given[-1]), contact_modulus=MODULUS, force=78.5e3
    )
    truth = case["solution"]
    assert found.penetration == pytest.approx(truth["penetration_mm"] * 1e-3, rel=6e-5)
    assert found.max_pressure == pytest.approx(truth["pmax_MPa"] * 1e6, rel=1.2e-3)
    assert found.area == pytest.approx(truth["area_fit_mm2"] * 1e-6, rel=6e-3)
    loads = sorted((region["fn_N"] for region in truth["regions"]), reverse=True)
    cell = (found.x[1] - found.x[0]) * (found.s[1] - found.s[0])
    np.testing.assert_allclose(
        [p.sum() * cell for p in outputs.split_patches(found)], loads, rtol=5e-6
    )  # measured 3.2e-6


POSES = {  # lateral shift [m], yaw [deg], force [N], side
    "tread": (1e-3, 1.0, 78.5e3, "right"),
    "left": (4e-3, -0.7, 5e4, "left"),
    "two_point": (5e-3, 0.0, 78.5e3, "right"),
    "flange_root": (6e-3, 0.5, 1e5, "right"),
    "flange": (6.5e-3, 2.0, 78.5e3, "right"),
    "light": (6.4e-3, -1.0, 5.0, "right"),
}


def sunk_as_deep(track, state, side):
    """``sunk_pose`` for the independent wheel without steps: as far below where that one touches."""
    sunk = sunk_pose(state, side)
    touching = conformal_reference.remaining_gap(
        track, dataclasses.replace(sunk, vertical_shift=state.vertical_shift)
    )
    return dataclasses.replace(sunk, vertical_shift=sunk.vertical_shift + touching)


def sunk_pose(state, side):
    """The independent program's pose of a wheel, as a right one, that has moved straight down from rigid
    contact (which tests/search compares with its own search)."""
    wheel = getattr(state, side)
    pose = brute_force.Pose(
        state["lateral_shift"],
        state["yaw"],
        state.roll,
        state.vertical_shift + wheel.penetration / math.cos(wheel.contact_angle),
    )
    return pose if side == "right" else pose.mirrored()


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[pytest.mark.full] if k else []) for k, name in enumerate(POSES)]
)
def test_true_gap_is_that_of_the_independent_program(system, track, name):
    """Along the same normals, wherever the gap is below 2 mm: to 1e-13 m, or 1.2e-7 m across the printed
    steps of S1002, which both take out in their own ways (wrcontact/profiles/compiled.py; without_steps)."""
    shift, yaw, force, side = POSES[name]
    pose = sunk_pose(wrcontact.ContactSystem().evaluate(shift, math.radians(yaw), force), side)
    pair = wheel_on_rail(
        tables_of(system),
        1,
        lateral_shift=pose.lateral_shift,
        yaw=pose.yaw,
        roll=pose.roll,
        vertical_shift=pose.vertical_shift,
    )
    ours = turning_gap(pair, 0.0)
    x, s = np.linspace(-0.02, 0.02, 21), np.linspace(0.002, 0.04, 97)
    for reach in (2e-3, 4e-4):  # closer together where the wheel is pressed in
        row, column = np.unravel_index(np.argmin(ours.gap(x, s)), (len(x), len(s)))
        more = reach * np.linspace(-1, 1, 20)
        x, s = np.sort(np.r_[x, x[row] + more]), np.sort(np.r_[s, s[column] + more])
    gap = ours.gap(x, s)
    wheel = halfspace_reference.without_steps(track.wheel)
    theirs = conformal_reference.Lowered(dataclasses.replace(track, wheel=wheel), pose).gap(
        conformal_reference.Curve(ours.curve.s, ours.curve.y, ours.curve.z, ours.curve.angle), x, s
    )
    near = np.isfinite(gap) & (gap < 2e-3)
    assert np.count_nonzero(near) > 300 and gap.min() < 0.0
    away = np.abs(gap - theirs)[near]
    assert np.max(away) < 1.2e-7
    # no step lies between this part of the tread and the running circle
    assert name != "tread" or np.median(away) < 1e-13
    # infinite only where the bodies are not close
    assert np.min(theirs[np.isinf(gap)], initial=1.0) > 2.5e-4


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[pytest.mark.full] * (name != "flange_root")) for name in POSES]
)
def test_the_independent_program_agrees(system, track, name):
    """At the height to which the wheel sinks, on its grid of 110 cells or more: as much force, to 5e-4 (3e-4
    in penetration); 0.2 % in peak pressure, 1 % in area, whose edge it finds along x only."""
    shift, yaw, force, side = POSES[name]
    state = system.evaluate(shift, math.radians(yaw), force, side=side)
    found = getattr(state, side)
    assert found.patch_count == (2 if name == "two_point" else 1)
    truth = conformal_reference.lowered_contact(track, sunk_as_deep(track, state, side))
    assert truth.force == pytest.approx(force, rel=5e-4)
    assert found.max_pressure == pytest.approx(truth.max_pressure, rel=2e-3)
    assert found.area == pytest.approx(truth.area, rel=0.01)


@pytest.mark.full
@pytest.mark.parametrize("seed", (3, *(pytest.param(seed, marks=pytest.mark.complete) for seed in (4, 5))))
def test_the_independent_program_agrees_on_random_poses(system, track, seed):
    """Its area, cut along x only, is up to 1.5 % too large on long narrow patches, where ours stands when the
    tolerance becomes five times smaller."""
    rng = np.random.default_rng(seed)
    for _ in range(8):
        shift, yaw, force = rng.uniform(-6.8e-3, 6.8e-3), rng.uniform(-0.03, 0.03), 10 ** rng.uniform(2, 5.2)
        state = system.evaluate(shift, yaw, force)
        assert state.status == Status.VALID
        for side in ("left", "right"):
            found, pose = getattr(state, side), (shift, yaw, force, side)
            truth = conformal_reference.lowered_contact(track, sunk_as_deep(track, state, side))
            assert truth.force == pytest.approx(force, rel=2e-3), pose
            assert found.max_pressure == pytest.approx(truth.max_pressure, rel=5e-3), pose
            assert found.area == pytest.approx(truth.area, rel=0.02), pose


@pytest.mark.full
def test_the_independent_program_sinks_as_deep(system, track):
    """It looks for the height itself."""
    shift, yaw, force = 6.1e-3, 0.4, 8e4
    rigid = brute_force.rigid_contact(track, shift, math.radians(yaw))
    truth = conformal_reference.sunk_contact(track, rigid, "right", force)
    found = system.evaluate(shift, math.radians(yaw), force, side="right").right
    assert found.penetration == pytest.approx(truth.penetration, rel=4e-4)
    assert found.max_pressure == pytest.approx(truth.max_pressure, rel=2e-3)


# --- in ContactSystem -----------------------------------------------------------------------------


def test_left_is_the_mirror_image(system):
    """The left wheel at -y, -yaw is the right one at y, yaw: everything but the signs of y in the track
    frame, of lateral forces, and of moments about x and z; to the residual of the pressures, 5e-6 of the
    largest deflection."""
    shift, yaw = 5.1e-3, 0.012
    right = system.evaluate(shift, yaw, 6e4).values[layout.OUT_RIGHT :].copy()
    left = (
        system.evaluate(MIRROR[0] * shift, MIRROR[1] * yaw, 6e4)
        .values[layout.OUT_LEFT : layout.OUT_RIGHT]
        .copy()
    )
    left *= side_signs()
    np.testing.assert_allclose(left, right, rtol=5e-6, atol=1e-9)


def test_outputs_of_a_wheel_fit_together(system):
    """5 mm: flange root and tread; totals against patches, the outline against area and load,
    angles against the rail."""
    state = system.evaluate(5e-3)
    side, heavy = state.right, state.right.patches[0]
    assert state.status == Status.VALID and side.patch_count == len(side.patches) == 2
    assert side.normal_force == pytest.approx(78.5e3, rel=1e-9)
    assert sum(patch.normal_force for patch in side.patches) == pytest.approx(78.5e3, rel=1e-9)
    assert sum(patch.area for patch in side.patches) == pytest.approx(side.area, rel=1e-3)
    assert heavy.normal_force > side.patches[1].normal_force and heavy.max_pressure == side.max_pressure
    moment = sum(patch.normal_force * patch.centroid for patch in side.patches)
    assert moment / 78.5e3 == pytest.approx(side.patch_centroid, rel=1e-6)
    # the flange is on the inner side: lower station, steeper rail
    assert heavy.centroid < side.patches[1].centroid
    assert heavy.contact_angle > side.patches[1].contact_angle + 0.1
    outline = side.outline
    width = outline.station[-1] - outline.station[0]
    assert width == pytest.approx(side.patch_width, rel=1e-9)
    assert np.any(outline.half_length[1:-1] == 0.0)  # between the two
    assert 2 * outline.half_length.max() == pytest.approx(side.patch_length, rel=0.02)  # 31 stations
    one = system.evaluate(3e-3).right
    outline = one.outline
    assert np.trapezoid(2 * outline.half_length, outline.station) == pytest.approx(one.area, rel=0.01)
    # an ellipse along x, as on the planar gap
    line = math.pi / 2 * outline.half_length * outline.pressure
    assert np.trapezoid(line, outline.station) == pytest.approx(78.5e3, rel=0.02)


def test_light_loads_are_hertz_at_the_contact_point(system):
    """1e-3 N: half a nanometre, so the curvatures at the point decide; yaw turns the ellipse, so without."""
    for shift in (0.0, 3e-3, 6e-3, 7e-3):
        side = system.evaluate(shift, normal_force=1e-3).right
        penetration, a, b, pressure = hertz(side.curvature_x / 2, side.curvature_y / 2, 1e-3)
        assert side.penetration == pytest.approx(penetration, rel=2e-3), shift
        assert side.max_pressure == pytest.approx(pressure, rel=3e-3), shift
        assert side.area == pytest.approx(math.pi * a * b, rel=8e-3), shift
        assert (side.patch_length, side.patch_width) == pytest.approx((2 * a, 2 * b), rel=0.02), shift


def test_prescribed_penetration_is_the_inverse(system):
    for shift, yaw, force in ((3e-3, 0.0, 78.5e3), (5e-3, 0.01, 4e4), (6.5e-3, -0.02, 1e-2)):
        by_force = system.evaluate(shift, yaw, force)
        depths = by_force.left.penetration, by_force.right.penetration
        back = system.evaluate(shift, yaw, penetration=depths)
        for one, other, depth in (
            (by_force.left, back.left, depths[0]),
            (by_force.right, back.right, depths[1]),
        ):
            assert other.penetration == depth
            assert other.normal_force == pytest.approx(one.normal_force, rel=5e-4), (shift, yaw, force)
    assert system.evaluate(1e-3).right.normal_force == pytest.approx(78.5e3)


def test_tables_transfer_and_unloaded_wheels(system):
    shift = np.array([0.0, 2e-3, np.nan, 6e-3])
    table = system.evaluate_many(shift, 0.005, 5e4, [0.2, 1.0, 0.0, -0.5])
    np.testing.assert_array_equal(table.status, [0, 1, 4, 0])
    np.testing.assert_allclose(table.right.normal_force, [6e4, 1e5, np.nan, 2.5e4])
    np.testing.assert_allclose(table.left.normal_force, [4e4, 0.0, np.nan, 7.5e4])
    assert (table.left.area[1], table.left.patch_count[1], table.left.penetration[1]) == (0.0, 0.0, 0.0)
    assert np.isfinite(table.left.contact.y_wheel[1]) and np.all(np.isnan(table.values[2]))
    one = system.evaluate(6e-3, 0.005, 5e4, -0.5)
    assert one.right.area == pytest.approx(table.right.area[3], rel=1e-9)
    empty = system.evaluate(2e-3, penetration=(0.0, 5e-5))
    assert empty.status == Status.UNLOADED and empty.left.normal_force == 0.0
    assert empty.right.normal_force > 1e4


def test_roll_and_contact_are_the_kernels(system):
    plain, solved = wrcontact.ContactSystem().evaluate(5e-3, 0.01), system.evaluate(5e-3, 0.01)
    assert solved.roll == pytest.approx(plain.roll, abs=1e-13)
    for first in (layout.OUT_LEFT, layout.OUT_RIGHT):
        geometry = slice(first + layout.SIDE_X_WHEEL, first + layout.SIDE_PENETRATION)
        np.testing.assert_allclose(solved.values[geometry], plain.values[geometry], rtol=1e-9, atol=1e-12)


def test_what_has_no_answer_keeps_the_outputs():
    """Rubber: the wheel would be deeper in its rail than 2 mm.  The stepper goes on with the next input."""
    stepper = wrcontact.ContactSystem(normal_model="halfspace", youngs_modulus=1e7).stepper()
    stepper.inputs[:5] = 1e-3, 0.0, 0.0, 1.0, 0.0
    assert stepper.step() == Status.VALID
    kept = stepper.outputs.copy()
    for wrong, status in (((1e-3, 0, 0, 1e6, 0), 2), ((1.0, 0, 0, 1.0, 0), 2), ((np.nan, 0, 0, 1.0, 0), 4)):
        stepper.inputs[:5] = wrong
        assert stepper.step() == status
        np.testing.assert_array_equal(stepper.outputs, kept)
    stepper.inputs[:5] = 1e-3, 0.0, 0.0, 1.0, 0.0
    assert stepper.step() == Status.VALID
    np.testing.assert_allclose(stepper.outputs, kept, rtol=1e-9, atol=1e-12)


def test_tolerance_decides_the_grid(system):
    assert Halfspace.numbers()["tolerance"].low == contact.TOLERANCE_RANGE[0]
    coarse = wrcontact.ContactSystem(normal_model="halfspace", tolerance=0.03)
    fine = wrcontact.ContactSystem(normal_model="halfspace", tolerance=2e-3)
    assert solver_of(pickle.loads(pickle.dumps(coarse)).stepper()).tolerance == 0.03
    for shift in (2e-3, 6e-3):
        truth = fine.evaluate(shift).right
        for given, allowed in ((coarse, 0.03), (system, contact.TOLERANCE)):
            side = given.evaluate(shift).right
            for name in ("penetration", "area", "max_pressure"):
                assert getattr(side, name) == pytest.approx(getattr(truth, name), rel=allowed), (
                    shift,
                    name,
                    allowed,
                )


# --- patches that a first grid steps over ---------------------------------------------------------


def test_area_where_bodies_graze():
    """Row 41 of the stored hunting run: p^2 continued from coarse cells ended outside the
    loaded ones, 3 % too large."""
    pose = 7.92637e-4, -0.010910954, 78500.0, 0.026074
    coarse, fine = (
        wrcontact.ContactSystem(normal_model="halfspace", tolerance=tolerance)
        .evaluate(*pose, side="left")
        .left
        for tolerance in (0.01, 2e-3)
    )
    assert coarse.area == pytest.approx(fine.area, rel=0.01)


#: The mirror of a force and of a moment, which is an axial vector.
MIRRORED = np.array([1.0, -1.0, 1.0, -1.0, 1.0, -1.0])


@pytest.mark.parametrize("shift, yaw", [(5e-3, 0.01), (-6.5e-3, 0.02), (7e-3, 0.0)])
def test_the_resultant_is_that_of_the_patches(system, shift, yaw):
    """Force of the patches, whose angle is that of their force, and which is a little less than the sum of
    pressures where a patch turns; ANALYN's, which takes the normals at the smallest gaps, are near; and the
    mirror has the mirrored ones.  Without friction all of it is the normal part."""
    state, near = system.evaluate(shift, yaw), wrcontact.ContactSystem().evaluate(shift, yaw)
    patches = [(sign, patch) for sign, side in ((-1, state.left), (1, state.right)) for patch in side.patches]
    force = np.sum([[p.force.y, p.force.z] for _, p in patches], axis=0)
    np.testing.assert_allclose([state.force.y, state.force.z], force, rtol=1e-6)
    for sign, p in patches:
        size = math.hypot(p.force.y, p.force.z)
        assert 0.97 * p.normal_force < size < p.normal_force
        np.testing.assert_allclose(
            [p.force.y, p.force.z],
            [-sign * size * math.sin(p.contact_angle), -size * math.cos(p.contact_angle)],
            rtol=1e-9,
        )
    np.testing.assert_allclose(
        state.values[layout.OUT_FORCE : layout.OUT_DRIVING_TORQUE],
        near.values[layout.OUT_FORCE : layout.OUT_DRIVING_TORQUE],
        atol=0.02 * 78.5e3,
    )
    assert np.linalg.norm(state.values[layout.OUT_MOMENT : layout.OUT_LEFT]) > 1e4
    other = system.evaluate(-shift, -yaw).values[layout.OUT_FORCE : layout.OUT_DRIVING_TORQUE]
    np.testing.assert_allclose(
        other * np.tile(MIRRORED, 2),
        state.values[layout.OUT_FORCE : layout.OUT_DRIVING_TORQUE],
        rtol=1e-4,
        atol=1.0,
    )


def test_the_resultant_follows_a_prescribed_penetration(system):
    """And it is there only for both wheels with their loads."""
    state = system.evaluate(1e-3, penetration=(5e-5, 0.0))
    left = state.left
    # the normals of a patch on the tread differ by 3 deg
    assert state.force.z == pytest.approx(
        -left.normal_force * math.cos(left.patches[0].contact_angle), rel=1e-3
    )
    for wanted in ({"side": "right"}, {"outputs": "geometry"}):
        some = system.evaluate(1e-3, **wanted)
        assert np.all(np.isnan(some.values[layout.OUT_FORCE : layout.OUT_LEFT])) and np.isfinite(some.roll)


def test_only_what_is_wanted_is_there(system):
    """No outline with "patches"; the rest as with "all"."""
    plain, short = system.evaluate(1e-3), system.evaluate(1e-3, outputs="patches")
    for side in ("left", "right"):
        outline = getattr(short, side).outline
        assert np.all(np.isnan(outline.station)) and np.all(np.isnan(outline.pressure))
        for name in ("penetration", "area", "max_pressure", "patch_length"):
            assert getattr(getattr(short, side), name) == pytest.approx(
                getattr(getattr(plain, side), name), rel=1e-9
            )
    state = system.evaluate(1e-3, outputs="geometry")
    assert np.isnan(state.right.area) and np.isfinite(state.right.contact_angle)


def test_unchanged_inputs_are_not_solved_again(monkeypatch):
    stepper = wrcontact.ContactSystem(normal_model="halfspace", tolerance=0.05).stepper()
    calls, press = [], stepping.press
    monkeypatch.setattr(stepping, "press", lambda *given, **named: calls.append(1) or press(*given, **named))
    stepper.inputs[:5] = 1e-3, 0.0, 0.0, 5e4, 0.0
    assert stepper.step() == Status.VALID and len(calls) == 2
    kept = stepper.outputs.copy()
    stepper.outputs[:] = 0.0
    assert stepper.step() == Status.VALID and len(calls) == 2
    np.testing.assert_array_equal(stepper.outputs, kept)
    stepper.prescribe(2e-5)
    assert stepper.step() == Status.VALID and len(calls) == 4
    stepper.inputs[0] = 1.0
    assert stepper.step() == Status.OFF_PROFILE
    stepper.inputs[0] = 1e-3
    assert stepper.step() == Status.VALID and len(calls) == 6
