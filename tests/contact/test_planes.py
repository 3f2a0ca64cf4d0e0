"""Regions of a wheel that has sunk straight down carry load along normals of their own."""

import dataclasses
import math

import numpy as np
import pytest
from scipy.optimize import brentq

from data import brute_force
from data.hertz import MODULUS, hertz
from tests.helpers.cases import system
from tests.helpers.elastic import rail_slope_along
from tests.helpers.inside import work_of
from tests.helpers.overlap import deepest, overlap
from wrcontact.kernel import layout

#: yaw [deg], shift [mm], force [N]: flange root and flange carry load at once
SPREAD = [
    (0.9, 6.15, 180e3),
    (0.9, 6.17, 15e3),
    (0.9, 6.17, 78.5e3),
    (1.2, 6.1, 78.5e3),
    (1.2, 6.1, 180e3),
    (1.6, 6.0, 15e3),
    (1.6, 6.0, 78.5e3),
    (1.6, 6.0, 180e3),
]


def second_derivatives(track, pose, x, abscissa, along=1.5e-3, across=2.5e-4):
    """Principal curvatures (2,) [1/m] of the distance from the rail, less the rail's own
    normal, at a smallest one."""
    _, slope, _ = track.rail(abscissa)
    step = across / math.hypot(1.0, slope)
    three = np.array([-1.0, 0.0, 1.0])
    grid = -overlap(track, pose, x + along * three[:, None], abscissa + step * three[None, :])
    xx = (grid[0, 1] - 2 * grid[1, 1] + grid[2, 1]) / along**2
    ss = (grid[1, 0] - 2 * grid[1, 1] + grid[1, 2]) / across**2
    xs = (grid[0, 0] + grid[2, 2] - grid[0, 2] - grid[2, 0]) / (4 * along * across)
    return np.linalg.eigvalsh([[xx, xs], [xs, ss]])


def two_hertz_loads(track, pose, state, force):
    """Loads of the root and of the flange [N], each Hertz's with the overlap along its own normal, the
    penetration at the contact point [m], and both angles [rad].

    The wheel comes down by d, and each region gets cos(its angle) d; each presses the other down by
    N / (pi E* distance), and of that cos(turn) comes along its normal. Overlaps are found by dense search
    where the kernel's wheel stands, and go on from there in proportion.
    """
    side = state.right
    stood = side.penetration / math.cos(side.contact_angle)
    pose = dataclasses.replace(pose, vertical_shift=pose.vertical_shift + stood)
    found = [deepest(track, pose, side.contact.y_rail, 5e-4), deepest(track, pose, -0.0424, 8e-4)]
    angles = [-math.atan(track.rail(y)[1]) for _, _, y in found]
    places = np.array([(x, y, track.rail(y)[0]) for _, x, y in found])
    push = math.cos(angles[1] - angles[0]) / (math.pi * MODULUS * np.linalg.norm(places[1] - places[0]))
    stiffness = [
        1e4 / hertz(*(second_derivatives(track, pose, x, y) / 2), 1e4)[0] ** 1.5 for _, x, y in found
    ]

    def loads(down):
        depths = [depth + (down - stood) * math.cos(angle) for (depth, _, _), angle in zip(found, angles)]
        one = other = 0.0
        for _ in range(60):
            one = stiffness[0] * max(depths[0] - push * other, 0.0) ** 1.5
            other = stiffness[1] * max(depths[1] - push * one, 0.0) ** 1.5
        return one, other

    down = brentq(lambda down: sum(loads(down)) - force, 1e-7, 1e-3, xtol=1e-12)
    return (*loads(down), down * math.cos(side.contact_angle), angles)


@pytest.mark.parametrize("yaw, shift, force", SPREAD)
def test_root_and_flange_share_a_rigid_wheel(yaw, shift, force):
    state = system().evaluate(shift * 1e-3, math.radians(yaw), force)
    side = state.right
    assert state.status == 0 and side.patch_count == 2
    root_patch, flange = sorted(side.patches, key=lambda patch: patch.contact_angle)
    assert flange.contact_angle - root_patch.contact_angle > math.radians(15)
    for patch in (root_patch, flange):
        slopes = rail_slope_along(
            side.contact.y_rail, patch.centroid + np.linspace(-0.5, 0.5, 9) * patch.width
        )
        assert min(slopes) <= -math.tan(patch.contact_angle) <= max(slopes)
    assert side.normal_force == pytest.approx(force, rel=1e-9)
    assert root_patch.normal_force + flange.normal_force == pytest.approx(force, rel=1e-9)
    outline = side.outline
    assert np.all(np.diff(outline.station) > 0) and np.all(outline.half_length >= 0)
    assert outline.station[-1] - outline.station[0] == pytest.approx(side.patch_width, rel=1e-12)
    # the flange lies to the inside, and the stations between them are empty
    assert flange.centroid + flange.width < root_patch.centroid - root_patch.width / 2
    between = (outline.station > flange.centroid + flange.width) & (
        outline.station < root_patch.centroid - root_patch.width
    )
    assert np.all(outline.half_length[between] == 0.0)


@pytest.mark.parametrize(
    "mode, shift, yaw, force",
    [
        ("rigid", 5.5e-3, 0.049410464000100594, 66986.25868528389),
        ("elastic", 5.800301577896962e-3, 0.04273883444233607, 325564.17596696055),
    ],
)
def test_three_regions_share_a_wheel(mode, shift, yaw, force):
    """Tread, flange root and flange."""
    side = system(contact_mode=mode).evaluate(shift, yaw, force).right
    assert side.patch_count == 3
    angles = sorted(patch.contact_angle for patch in side.patches)
    assert angles[2] - angles[1] > math.radians(40) and angles[1] - angles[0] > math.radians(8)
    assert min(patch.normal_force for patch in side.patches) > 0.05 * force
    assert sum(patch.normal_force for patch in side.patches) == pytest.approx(force, rel=1e-8)
    assert np.all(np.diff(side.outline.station) > 0)


@pytest.mark.parametrize("yaw, shift, force", SPREAD)
def test_the_flange_carries_what_hertz_says_at_its_own_normal(yaw, shift, force):
    shift, yaw = shift * 1e-3, math.radians(yaw)
    state = system().evaluate(shift, yaw, force)
    pose = brute_force.Pose(shift, yaw, state.roll, state.vertical_shift)
    one, other, down, angles = two_hertz_loads(brute_force.track(), pose, state, force)
    root_patch, flange = sorted(state.right.patches, key=lambda patch: patch.contact_angle)
    # a centre of load 0.1 mm beside the smallest gap, on the rail's radius of 13 mm
    assert flange.contact_angle == pytest.approx(angles[1], abs=0.008)
    # measured 0.018 and 5 %: ANALYN's root patch is no ellipse
    assert flange.normal_force / force == pytest.approx(other / force, abs=0.025)
    assert state.right.penetration == pytest.approx(down, rel=0.07)


@pytest.mark.parametrize(
    "rail, inclination, shift, yaw, force",
    [
        ("UIC60", 1 / 40, 6.15e-3, 0.0175, 78.5e3),
        ("54E1", 1 / 20, 5.86e-3, -0.0312, 195e3),
        ("UIC60", 1 / 40, 5.5e-3, 0.049410464000100594, 66986.25868528389),
    ],
)
def test_patches_press_on_each_other_over_their_distance(rail, inclination, shift, yaw, force):
    """Equations (E3) and (8.4) of docs/theory: 15 and more degrees apart the lead counts, 9
    degrees apart it does not."""
    stepper = system(rail=rail, rail_inclination=inclination).stepper()
    stepper.inputs[:7] = shift, yaw, 0.0, force, 0.0, 0.0, 0.0
    assert stepper.step() == 0
    side = layout.Outputs.at(stepper.outputs).left[1]
    contact = work_of(stepper).contact  # of the right wheel, which came last
    regions = contact.regions[: int(side.patch_count)]
    modulus = 210e9 / (2 * (1 - 0.28**2))
    angles = [-math.atan(region.inclination) for region in regions]
    pressed = 0
    for one, angle in zip(regions, angles):
        down = math.cos(angle) / math.cos(side.contact_angle) * side.penetration - one.gap
        for other, its in zip(regions, angles):
            if other is one:
                continue
            distance = one.offset + one.middle - other.offset - other.middle
            apart = abs(angle - its) > math.radians(15)
            lead = one.x_track - other.x_track if apart else 0.0
            pressed += apart and abs(lead) > 3e-3
            # of the forces, which act along the mean normals
            cosine = one.cos * other.cos + one.sin * other.sin
            squares = 0.3 * (one.square + other.square)
            down -= other.load * cosine / (math.pi * modulus * math.sqrt(distance**2 + lead**2 + squares))
        assert one.local_penetration == pytest.approx(down, rel=1e-8)
    assert pressed
