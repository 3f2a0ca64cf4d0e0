"""Patches that the half-space solver's first grid steps over, and patches in planes of their own."""

import math

import numpy as np
import pytest

import wrcontact
from data import brute_force, conformal_reference
from data.hertz import MODULUS
from tests.helpers.inside import tables_of
from wrcontact import Status
from wrcontact.halfspace import contact, deflection, outputs
from wrcontact.halfspace.contact import is_loaded
from wrcontact.halfspace.pressed_wheel import Settings, press
from wrcontact.halfspace.turning_gap import REACH_X
from wrcontact.halfspace.wheel_on_rail import wheel_on_rail
from wrcontact.kernel import layout

#: Rail, inclination, (lateral shift [m], yaw [rad], force [N]), side, and of each patch: load [N],
#: centroid [m], angle [rad].
MISSED = {
    "flange_ahead": (
        "60E1",
        1 / 40,
        (-0.006037944, -0.026654101, 8107.57),
        "left",
        [(7192, 0.0, 0.401), (915, -10.73e-3, 1.223)],
    ),
    "three": (
        "UIC60",
        1 / 20,
        (-0.005960749371552871, 0.0, 6283.808696130702),
        "left",
        [(3837, -0.44e-3, 0.018), (1836, -22.69e-3, 0.115), (610, -37.30e-3, 0.386)],
    ),
    "inner": (
        "60E1",
        1 / 20,
        (0.006257170613387163, 0.018450140773861007, 30717.30179453353),
        "right",
        [(27291, -0.08e-3, 0.459), (2796, 15.69e-3, 0.115), (631, -10.01e-3, 1.222)],
    ),
    "flange_root": (
        "54E1",
        1 / 40,
        (0.0058417922877720425, -0.03358323754363793, 60084.7449943978),
        "right",
        [(59041, 0.0, 0.360), (1044, -11.29e-3, 1.224)],
    ),
    "far_ahead": (
        "UIC60",
        1 / 40,
        (0.005324708915429254, -0.05511213786185546, 35566.6),
        "right",
        [(34209, -0.16e-3, 0.118), (1358, -23.68e-3, 1.208)],
    ),
    "farthest": (
        "UIC60",
        1 / 20,
        (-0.005033642375874028, 0.07105501647277541, 107146.0),
        "left",
        [(100892, -1.14e-3, 0.013), (6254, -48.48e-3, 1.157)],
    ),
}


def solved(name):
    """The system and the state of a pose in MISSED, and its pressed wheel, solved once more by itself."""
    rail, inclination, pose, side, _ = MISSED[name]
    model = wrcontact.ContactSystem(
        rail=rail, rail_inclination=inclination, normal_model="halfspace", tolerance=0.02
    )
    state = model.evaluate(*pose, side=side)
    pair = wheel_on_rail(
        tables_of(model),
        int(side == "right"),
        lateral_shift=pose[0],
        yaw=pose[1],
        roll=state.roll,
        vertical_shift=state.vertical_shift,
    )
    found = getattr(state, side)
    sunk = found.penetration / math.cos(found.contact_angle)
    settings = Settings(layout.Tables.at(tables_of(model)).contact_modulus, 0.0, False, 0.02)
    return state, found, press(pair, settings, penetration=sunk)


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=[pytest.mark.full] * (k > 0) + [pytest.mark.complete] * (k > 2))
        for k, name in enumerate(MISSED)
    ],
)
def test_no_patch_is_missed(name):
    """Loads and places as measured; and nowhere on a dense grid over the whole rail do the bodies overlap by
    more than 1 % of the penetration."""
    pose, side, patches = MISSED[name][2:]
    state, found, wheel = solved(name)
    assert state.status == Status.VALID and found.patch_count == len(patches)
    assert sum(patch.normal_force for patch in found.patches) == pytest.approx(pose[2], rel=1e-6)
    for patch, (load, centroid, angle) in zip(found.patches, patches):
        assert patch.normal_force == pytest.approx(load, abs=0.01 * pose[2])
        assert patch.centroid == pytest.approx(centroid, abs=2e-4)
        assert patch.contact_angle == pytest.approx(angle, abs=0.01)
        assert 0.0 < patch.width < 0.02
    surfaces, contact = wheel.surfaces, wheel.contact
    x, s = np.linspace(-REACH_X, REACH_X, 151), np.linspace(surfaces.curve.s[0], surfaces.curve.s[-1], 701)
    depth = contact.penetration * surfaces.share(s) - surfaces.gap(x, s)
    i, j = np.nonzero(depth > 0.0)
    away = np.array([not is_loaded(contact, x[a], s[b]) for a, b in zip(i, j)], dtype=bool)
    i, j = i[away], j[away]
    overlap = depth[i, j] - deflection_at(wheel, x[i], s[j])
    assert np.max(overlap, initial=0.0) < 0.01 * contact.penetration


def test_the_independent_program_has_the_second_patch():
    """At the height that carries the load: each patch within 1 % of the total."""
    rail, inclination, pose, _, patches = MISSED["flange_ahead"]
    state, found, _ = solved("flange_ahead")
    height = state.vertical_shift + found.penetration / math.cos(found.contact_angle)
    truth = conformal_reference.lowered_contact(
        brute_force.track(rail, inclination), brute_force.Pose(*pose[:2], state.roll, height).mirrored()
    )
    on_flange = truth.angle > 0.8
    loads = [truth.pressure[:, part].sum() * truth.cell for part in (~on_flange, on_flange)]
    np.testing.assert_allclose(loads, [load for load, *_ in patches], atol=0.01 * pose[2])


@pytest.mark.parametrize(
    "model, shift, pressure, area",
    [
        ("analyn", 6.125e-3, 0.03, 0.04),
        ("analyn", 6.135e-3, 0.03, 0.1),
        # few of the strips lie on so small a patch: measured 0.17 and 0.13
        ("analyn_strip", 6.135e-3, 0.25, 0.2),
    ],
)
def test_a_patch_that_leans_away_is_the_half_space_s(model, shift, pressure, area):
    """The flange beside the flange root, 44 deg apart, in rows of the stored run "jumps". How much it carries
    hangs on the direction in which the wheel is pressed; as a patch of Hertz's its pressure goes with the
    cube root of its load and its area with the square of that, whatever it carries."""
    pose = shift, 0.0174532925199433, 78.5e3
    patches = []
    for given in ({"normal_model": model}, {"normal_model": "halfspace", "tolerance": 0.01}):
        wheel = wrcontact.ContactSystem(**given).evaluate(*pose, side="right").right
        patches.append(
            next(patch for patch in wheel.patches if abs(patch.contact_angle - wheel.contact_angle) > 0.7)
        )
    near, truth = patches
    load = near.normal_force / truth.normal_force
    assert near.max_pressure == pytest.approx(truth.max_pressure * load ** (1 / 3), rel=pressure)
    assert near.area == pytest.approx(truth.area * load ** (2 / 3), rel=area)


def deflection_at(wheel, x, s):
    """u at places (k,) under every loaded cell as a rectangle, by the cosine of the angle between normals: no
    lumps, no transform."""
    contact = wheel.contact
    rows, columns = np.nonzero(contact.pressure)
    dx, ds = contact.x[1] - contact.x[0], contact.s[1] - contact.s[0]
    bent = []
    for one, other in zip(x, s):
        # not on an edge
        away_x, away_s = one - contact.x[rows] + 1e-12, other - contact.s[columns] + 1e-12
        corners = [
            sign * deflection.corner_potential(away_x + a * dx / 2, away_s + b * ds / 2)
            for a, b, sign in ((1, 1, 1), (-1, 1, -1), (1, -1, -1), (-1, -1, 1))
        ]
        turn = np.cos(wheel.surfaces.angle(np.array([other])) - contact.angle[columns])
        bent.append(np.sum(contact.pressure[rows, columns] * turn * sum(corners)) / (math.pi * MODULUS))
    return np.array(bent)


@pytest.mark.parametrize("turn, coupling", [(0.0, 0.0), (0.1, 0.3)], ids=["plane", "turning, two materials"])
def test_grids_of_two_patches_press_each_other_down(turn, coupling):
    """Two grids of equal cells are one grid with a hole: against the plain convolution over both."""
    corners, shape, angle = np.array([(0, 0), (9, 5)]), (2, 4, 3), turn * np.arange(8) ** 1.5
    pressure = np.random.default_rng(3).random(shape)
    whole = np.zeros((13, 8))
    whole[:4, :3], whole[9:, 5:] = pressure
    given = {"coupling": coupling, "contact_modulus": MODULUS}
    bent = deflection.Deflection(whole.shape, 2e-4, 1e-4, angle=angle if turn else None, **given)(whole)
    parts = deflection.Deflection(
        shape, 2e-4, 1e-4, corners=corners, angle=np.stack([angle[:3], angle[5:]]) if turn else None, **given
    )(pressure)
    np.testing.assert_allclose(parts[0], bent[:4, :3], rtol=1e-10)
    np.testing.assert_allclose(parts[1], bent[9:, 5:], rtol=1e-10)


def test_a_missed_patch_with_its_own_grid():
    """A ball, and 45 mm away a narrow ridge; force and penetration are each other's
    inverse, with two patches."""

    def gap(x, s):
        ball = x[:, None] ** 2 + s**2
        return np.minimum(ball, 4e-6 + (x[:, None] - 0.03) ** 2 + 100.0 * (s - 0.0347) ** 2)

    domain = (-0.15, 0.15, -0.08, 0.08)
    found = contact.solve_contact(gap, domain, contact_modulus=MODULUS, force=1e4, tolerance=0.02)
    patches = outputs.split_patches(found)
    assert len(patches) == 2 and np.all(np.diff(found.x) > 0.0)
    back = contact.solve_contact(
        gap, domain, contact_modulus=MODULUS, penetration=found.penetration, tolerance=0.02
    )
    assert back.force == pytest.approx(1e4, rel=5e-3)
    assert len(outputs.split_patches(back)) == 2
    held = np.isfinite(found.clearance)
    # the residual is 2e-5 in the root mean square
    assert found.clearance[held].min() > -1e-3 * found.penetration
