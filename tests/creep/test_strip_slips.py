"""Longitudinal creepage of the strips of a patch: that of their own place on the wheel."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.cone import cone_system
from tests.helpers.inside import work_of
from wrcontact.kernel import layout
from wrcontact.profiles.compiled import evaluate_table

MOTION = {"speed": 20.0, "lateral_velocity": 0.02, "yaw_rate": 0.03, "track_curvature": 1e-3}


def rolled(system, **inputs):
    """Outputs and workspace of a step, as records."""
    stepper = system.stepper()
    stepper.inputs[:] = wrcontact.ContactSystem().evaluate(**inputs, **MOTION).inputs
    assert stepper.step() == 0
    return layout.Outputs.at(stepper.outputs), work_of(stepper), stepper


def ranked(side):
    """The patches of a side by falling load."""
    return sorted(side.patches[:side.patch_count], key=lambda patch: patch.rank)


@pytest.mark.parametrize("slope", [0.025, 0.05, 0.1])
def test_on_a_cone_it_is_that_of_spin(slope):
    """xi - phi y, since the rolling radius follows a straight line; the rail's round head turns the strips'
    planes, by 1 - cos of an angle of some hundredths."""
    outputs, work, _ = rolled(cone_system(slope, tangential_model="polach"), lateral_shift=2e-3)
    for index, mirror in enumerate((-1.0, 1.0)):
        patch, to = ranked(work.sides[index])[0], outputs.left[index].patch[0]
        spin = -mirror * to.spin
        for strip in patch.strips:
            expected = to.creepage_x - spin * strip.y
            assert strip.slip == pytest.approx(expected, abs=2e-3 * abs(spin) * to.width)


@pytest.mark.parametrize("shift, yaw", [(0.0, 0.0), (5e-3, 2e-3), (6.2e-3, 0.0), (8e-3, 0.0)])
def test_on_a_profile_it_follows_the_rolling_radius(shift, yaw):
    """v . e_x / V_ref at each strip's place on the rail, with the wheel's profile there; elastic contact."""
    system = wrcontact.ContactSystem(contact_mode="elastic", tangential_model="polach")
    outputs, work, stepper = rolled(system, lateral_shift=shift, yaw=yaw)
    wheel, rail, rail_y = system.profile_tables()
    roll, height = outputs.roll, outputs.vertical_shift
    axle = np.array([-np.sin(yaw) * np.cos(roll), np.cos(yaw) * np.cos(roll), np.sin(roll)])
    centre = np.array([0.0, shift, height - 0.46])
    rate = MOTION["speed"] / 0.46
    for index, mirror in enumerate((-1.0, 1.0)):
        for patch, to in zip(ranked(work.sides[index]), outputs.left[index].patch):
            places = np.array([(to.x_track + strip.x, mirror * strip.y_track, strip.z_track)
                               for strip in patch.strips])
            # the strips lie on the rail
            across = mirror * places[:, 1] - rail_y
            np.testing.assert_allclose(places[:, 2], evaluate_table(rail, across)[0], rtol=0, atol=1e-12)
            arms = places - centre
            around = np.cross(axle, arms)
            radius = np.array([strip.rolling_radius for strip in patch.strips])
            rolling = rate * radius[:, None] * around / np.linalg.norm(around, axis=1)[:, None]
            turning = MOTION["yaw_rate"] + MOTION["speed"] * MOTION["track_curvature"]
            along = (MOTION["speed"] * (1 - MOTION["track_curvature"] * shift) - rolling[:, 0]
                     - turning * arms[:, 1])
            # yaw rate alone: the roll rate that follows from contact has no part along the track without yaw
            reference = patch.speed
            found = np.array([strip.slip for strip in patch.strips])
            tolerance = 1e-12 if yaw == 0.0 else 1e-3 * abs(to.spin) * to.width
            np.testing.assert_allclose(found, along / reference, rtol=0, atol=tolerance)
            # the wheel's profile where it lies on the rail: within its penetration, across a steep profile
            wheel_y = mirror * (arms[:, 1] * np.cos(roll) + arms[:, 2] * np.sin(roll)) - 0.75
            expected = 0.46 + evaluate_table(wheel, wheel_y)[0]
            slope = np.tan(abs(to.contact_angle) + 0.2)
            np.testing.assert_allclose(radius, expected, rtol=0, atol=2e-4 * (1 + slope))
