"""Forces of patches, wheels and wheelset: their sums, their points and their angles.

The witnesses are statics, the rail's and the wheel's profiles as tables, Hertz's contact of two cylinders
across each other, and the wheelset's own resultant.
"""

import itertools
import math

import numpy as np
import pytest

import wrcontact
from tests.helpers.cases import FORCE, LOADS, MODELS, POSES, system
from tests.helpers.elastic import rail_point_along, rail_slope_along
from wrcontact.profiles.compiled import evaluate_table

MODES = ("rigid", "elastic", "compliant")


def vector(of):
    return np.array([of.x, of.y, of.z])


def stated(mode, model, load, shift, yaw, transfer, **wanted):
    """The state of a case; a compliant wheelset stands where the elastic one does."""
    if mode != "compliant":
        return system(contact_mode=mode, normal_model=model, load=load).evaluate(
            shift, yaw, FORCE, transfer, **wanted
        )
    stand = system(contact_mode="elastic", normal_model=model, load=load).evaluate(
        shift, yaw, FORCE, transfer
    )
    return system(contact_mode=mode, normal_model=model, load=load).evaluate(
        shift, yaw, vertical_shift_input=stand.vertical_shift, roll_input=stand.roll, **wanted
    )


CASES = [case for case in itertools.product(MODES, MODELS, LOADS)]


@pytest.mark.parametrize("pose", POSES)
@pytest.mark.parametrize("mode, model, load", CASES)
def test_patches_add_up_to_wheels_and_wheels_to_the_wheelset(mode, model, load, pose):
    state = stated(mode, model, load, *POSES[pose])
    wheels = state.left, state.right
    scale = sum(side.normal_force for side in wheels)
    np.testing.assert_allclose(
        sum(vector(side.force) for side in wheels), vector(state.force), rtol=0, atol=1e-12 * scale
    )
    np.testing.assert_allclose(
        sum(vector(side.moment) for side in wheels), vector(state.moment), rtol=0, atol=1e-12 * scale
    )  # levers of about 1 m
    for sign, side in zip((-1, 1), wheels):
        assert side.patch_count <= 3
        np.testing.assert_allclose(
            sum(vector(patch.force) for patch in side.patches),
            vector(side.force),
            rtol=0,
            atol=1e-12 * side.normal_force,
        )
        for patch in side.patches:
            # less than its load where the normal turns over the patch: with a line load like 1 - u^2 over
            # -t < u t < t it is 3 (sin t - t cos t) / t^3, 0.955 where the rail turns by 2 t = 77 deg
            size = np.linalg.norm(vector(patch.force))
            assert patch.force.x == 0.0 and size <= patch.normal_force * (1 + 1e-12)
            assert size > 0.955 * patch.normal_force
            assert math.atan2(-sign * patch.force.y, -patch.force.z) == pytest.approx(
                patch.contact_angle, abs=1e-12
            )


@pytest.mark.parametrize("pose", [pose for pose in POSES if pose != "conformal"])
@pytest.mark.parametrize("mode", MODES)
def test_moments_are_those_of_the_forces_at_their_points(mode, pose):
    """About the wheelset's centre, which is the nominal radius above the running circles."""
    shift, yaw, transfer = POSES[pose]
    state = stated(mode, "analyn", "normal", shift, yaw, transfer)
    centre = np.array([0.0, shift, state.vertical_shift - 0.46])
    for side in (state.left, state.right):
        moment = sum(
            np.cross(np.array([patch.x_track, patch.y_track, patch.z_track]) - centre, vector(patch.force))
            for patch in side.patches
        )
        np.testing.assert_allclose(moment, vector(side.moment), rtol=0, atol=1e-9 * side.normal_force)


@pytest.mark.parametrize("pose", POSES)
def test_a_patch_lies_on_its_rail_and_on_its_wheel(pose):
    """Its centre of load is on the rail's surface, its force along a mean of the rail's normals over the
    patch, and its rolling radius the wheel's at the abscissa that the attitude gives."""
    shift, yaw, transfer = POSES[pose]
    state = system().evaluate(shift, yaw, FORCE, transfer)
    wheel, table, rail_y = system().profile_tables()
    c, s, cr, sr = (of(angle) for angle in (yaw, state.roll) for of in (math.cos, math.sin))
    axle = np.array([-s * cr, c * cr, sr])
    centre = np.array([0.0, shift, state.vertical_shift - 0.46])
    for sign, side in ((-1, state.left), (1, state.right)):
        for patch in side.patches:
            height, slope, _ = evaluate_table(table, sign * patch.y_track - rail_y)
            if side.patch_count == 1:
                assert patch.z_track == pytest.approx(height, abs=1e-12)
                on_rail = rail_point_along(side.contact.y_rail, patch.centroid)
                # a dense grid of 0.25 um; the kernel's arcs come from a table
                assert sign * patch.y_track - rail_y == pytest.approx(on_rail, abs=2e-8)
            slopes = rail_slope_along(
                side.contact.y_rail, patch.centroid + np.linspace(-0.5, 0.5, 9) * patch.width
            )
            assert min(slopes) <= -math.tan(patch.contact_angle) <= max(slopes)
            # the wheel sinks straight down, and a patch counts the part of it along its own normal; where it
            # is deepest has moved by then (second order)
            sunk = side.penetration / math.cos(side.contact_angle)
            assert 0.0 < patch.penetration <= sunk / math.hypot(1.0, min(abs(slopes))) * (1 + 1e-3)
            place = np.array([patch.x_track, patch.y_track, patch.z_track])
            on_wheel = sign * (axle @ (place - centre)) - 0.75
            radius = 0.46 + evaluate_table(wheel, on_wheel)[0]
            # at the wheel's own slope from its point of smallest gap, which the penetration moves aside
            assert patch.rolling_radius == pytest.approx(radius, abs=4e-4 * max(1.0, abs(slope)))
        assert side.patches[0].penetration == pytest.approx(side.penetration, rel=0.6)


@pytest.mark.parametrize(
    "rail, methods",
    [
        ("UIC60", {}),
        ("60E1", {"separation": "equidistant"}),
        ("54E1", {"separation": "vertical", "longitudinal_curvature": "basic"}),
    ],
    ids=["UIC60", "60E1", "54E1"],
)
@pytest.mark.parametrize("load", LOADS)
def test_a_sliver_that_carries_less_than_nothing_is_no_patch(rail, methods, load):
    """Between two jumps of the source's curvatures the quadratic of the line load can be negative all over a
    loaded piece: -46 N of 78.5 kN at 6 mm. The force is that of the load that is held, and of its patches."""
    pair = wrcontact.ContactSystem(rail=rail, load=load, lateral_curvature="rough", **methods)
    state = pair.evaluate(6e-3, 0.0, FORCE)
    for side in (state.left, state.right):
        held = -side.force.z if load == "vertical" else side.normal_force
        assert held == pytest.approx(FORCE, rel=1e-9)  # the force is satisfied to 1e-9 in the kernel
        assert len(side.patches) == side.patch_count
        assert all(patch.normal_force > 0.0 for patch in side.patches)
        carried = sum(patch.normal_force for patch in side.patches)
        assert carried == pytest.approx(side.normal_force, rel=1e-12)
        assert sum(patch.area for patch in side.patches) == pytest.approx(side.area, rel=1e-12)
        np.testing.assert_allclose(
            sum(vector(patch.force) for patch in side.patches), vector(side.force), rtol=0, atol=1e-12 * FORCE
        )


@pytest.mark.full
@pytest.mark.parametrize("pose", ["tread", "two_region", "yawed", "flange"])
def test_the_half_space_has_the_same_outputs(pose):
    shift, yaw, transfer = POSES[pose]
    strip = system(normal_model="analyn_strip").evaluate(shift, yaw, FORCE, transfer)
    truth = system(normal_model="halfspace", tolerance=0.02).evaluate(shift, yaw, FORCE, transfer)
    np.testing.assert_allclose(
        vector(truth.left.force) + vector(truth.right.force),
        vector(truth.force),
        rtol=0,
        atol=1e-12 * 2 * FORCE,
    )
    for ours, theirs in ((strip.left, truth.left), (strip.right, truth.right)):
        np.testing.assert_allclose(vector(ours.force), vector(theirs.force), rtol=0, atol=6e-3 * FORCE)
        np.testing.assert_allclose(vector(ours.moment), vector(theirs.moment), rtol=0, atol=6e-3 * FORCE)
        for mine, its in zip(ours.patches, theirs.patches):
            assert mine.x_track == pytest.approx(its.x_track, abs=1e-3)
            assert mine.y_track == pytest.approx(its.y_track, abs=3e-4)
            assert mine.rolling_radius == pytest.approx(its.rolling_radius, abs=2e-4)
            assert mine.penetration == pytest.approx(its.penetration, rel=0.05)
