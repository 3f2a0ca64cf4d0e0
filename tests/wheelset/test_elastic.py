"""Elastic equilibrium, its compliant form, the resultant, and planes of their own for rigid regions that lean away.

The witnesses are a published benchmark, the wheel as a rolled and yawed surface of revolution met by dense search, Hertz's
formulas by scipy's elliptic integrals, scipy's root finders on the compliant form, limits, symmetries and statics.
"""

import csv
import math
import sys
from functools import cache

import numpy as np
import pytest
from scipy.optimize import brentq, root

from tests.helpers.numpy_profiles import compile_profile
import wrcontact
from tests.binding.test_native_library import bits, needs_library, run_steps
from tests.helpers.constant_curvatures import MODULUS, hertz
from wrcontact.kernel import layout
from wrcontact.kernel.contact import overlaps
from wrcontact.profiles.catalogue import standard_profile
from wrcontact.profiles.compiled import evaluate_table
from wrcontact.profiles.placement import place_rail
from wrcontact.profiles.profile import Profile
from wrcontact.profiles.zones import Arc
from wrcontact.status import explain

from tests.reference import brute_force
from tests.helpers.paths import REFERENCE_DATA

FORCE = 78.5e3   # per wheel [N]
MODELS = ("analyn", "analyn_strip", "hertz")
LOADS = ("normal", "vertical")
PAIRS = [(rail, inclination) for rail in ("UIC60", "60E1", "54E1") for inclination in (1 / 40, 1 / 20)]

#: lateral shift [m], yaw [rad], load transfer
CASES = {
    "tread": (1e-3, 0.0, 0.0),
    "two_region": (4.95e-3, 0.0, 0.0),
    "root": (6e-3, 0.0, 0.0),
    "conformal": (6.29e-3, 0.0, 0.0),
    "flange": (7.5e-3, 0.0, 0.0),
    "yawed": (5.2e-3, 0.0175, 0.0),
    "yawed_flange": (-6.6e-3, -0.035, 0.3),
    "root_and_flange": (6.15e-3, 0.0175, 0.0),
    "transfer": (3e-3, 0.0, 0.8),
}


@cache
def system(**parameters):
    return wrcontact.ContactSystem(**parameters)


def elastic(**parameters):
    return system(contact_mode="elastic", **parameters)


def compliant(**parameters):
    return system(contact_mode="compliant", **parameters)


def carried(side, load="normal"):
    """What a wheel carries [N] in the sense of ``load``, summed from its patches."""
    if load == "normal":
        return side.normal_force
    return sum(patch.normal_force * np.cos(patch.contact_angle) for patch in side.patches)


# ------------------------------------------------------------------------------------------------ published equilibria


def manchester():
    """The Manchester contact benchmark (Shackleton and Iwnicki 2008), case A-2.2: shift, yaw, roll, force, load transfer."""
    with open(REFERENCE_DATA / "manchester_a22_rolls.csv", newline="") as file:
        for row in csv.DictReader(file):
            left, right = float(row["normal_force_left_N"]), float(row["normal_force_right_N"])
            yield (float(row["lateral_shift_mm"]) * 1e-3, float(row["yaw_rad"]), float(row["roll_rad"]), (left + right) / 2,
                   (right - left) / (left + right))


@pytest.mark.parametrize("model", ["analyn", "analyn_strip"])
def test_rolls_of_the_manchester_benchmark(model):
    """Published rolls have four digits, and CONTACT's equilibrium of heights closes to 1 um, 7e-7 rad."""
    shift, yaw, roll, force, transfer = np.array(list(manchester())).T
    found = elastic(normal_model=model).evaluate_many(shift, yaw, force, transfer)
    assert not np.any(found.status)
    error = np.abs(found.roll - roll)
    near = shift <= 6.5e-3
    assert error[near].max() < 1.2e-6        # [rad]; measured 3e-7
    assert error.max() < 4e-5                # measured 2.7e-6
    rigid = np.abs(system(normal_model=model).evaluate_many(shift, yaw, force, transfer).roll - roll)
    assert rigid[1:].min() > 1.5e-6 and rigid.max() > 7e-5
    assert np.all(rigid[1:] > 4 * error[1:])


# ------------------------------------------------------------------------------------------------------ smooth in shift


def steps_of(quantity, start, stop, step, yaw):
    """Steps of ``quantity`` during a slow lateral move [m], both wheels at FORCE."""
    shift = np.arange(start, stop, step)
    table = elastic().evaluate_many(shift, yaw)
    assert not np.any(table.status)
    return np.abs(np.diff(getattr(table, quantity)))


@pytest.mark.parametrize("yaw", [0.0, math.radians(1), math.radians(2)])
@pytest.mark.parametrize("window", [(4.4e-3, 5.5e-3, 1e-6), (5.8e-3, 6.5e-3, 1e-6), (6.2e-3, 6.4e-3, 2e-7)])
def test_roll_does_not_jump(window, yaw):
    """The steepest slope is 17 rad/m (measured, at 2 deg and 5.995 mm).  Without yaw two equilibria stand side by side from
    6.2926 to 6.2985 mm, on root and on flange, 3e-5 rad apart, and which one is found changes some ten times; at 1 deg
    regions that come and go make steps of 8e-6 rad near 6.233 mm."""
    steps = steps_of("roll", *window, yaw)
    assert steps.max() < 4e-5                                   # [rad]; measured 3.0e-5
    jumps = np.count_nonzero(steps > 20.0 * window[2] + 2e-6)
    assert jumps <= (20 if window[1] > 6.3e-3 else 0), jumps


@pytest.mark.slow
@pytest.mark.parametrize("yaw", [0.0, math.radians(1), math.radians(2)])
def test_roll_does_not_jump_over_the_whole_range(yaw):
    for quantity in ("roll", "vertical_shift"):
        largest = steps_of(quantity, -8e-3, 8e-3 + 5e-7, 1e-6, yaw).max()
        assert largest < 4e-5    # [rad, m]; measured 2.7e-5 and 2.9e-5


# --------------------------------------------------------------------------------------------------------------- limits


@pytest.mark.parametrize("shift, yaw", [(3e-3, 0.0), (5.5e-3, 0.0), (7e-3, 0.02), (-6e-3, 0.01)])
def test_a_light_wheelset_stands_as_a_rigid_one(shift, yaw):
    """All approaches are Hertz's for small loads, N^(2/3)."""
    forces = np.array([1.0, 1e-2, 1e-4])
    rigid, table = system().evaluate(shift, yaw), elastic().evaluate_many(shift, yaw, forces)
    assert not np.any(table.status)
    lacks = {"roll": table.roll - rigid.roll, "height": table.vertical_shift - rigid.vertical_shift}
    for side in ("left", "right"):
        for name in ("y_wheel", "y_rail"):
            lacks[side, name] = getattr(getattr(table, side).contact, name) - getattr(getattr(rigid, side).contact, name)
    for name, lack in lacks.items():
        assert abs(lack[0]) < 3e-7 and abs(lack[2]) < 1e-9, name
        # the smallest of them, 1e-11 rad, has two digits that are not rounding
        assert np.polyfit(np.log(forces), np.log(np.abs(lack)), 1)[0] == pytest.approx(2 / 3, abs=0.01), name


# ------------------------------------------------------------------------------- the equilibrium, from the compliant form


class Loads:
    """The compliant form as two functions of height and roll, for scipy."""

    def __init__(self, case, load, model):
        self.shift, self.yaw, transfer = CASES[case]
        self.load, self.system = load, compliant(load=load, normal_model=model)
        self.wanted = FORCE * np.array([1 - transfer, 1 + transfer])

    def lacks(self, height, roll):
        """Loads of left and right over the prescribed ones, less one."""
        state = self.system.evaluate(self.shift, self.yaw, vertical_shift_input=height, roll_input=roll)
        assert state.status <= 1
        return np.array([carried(side, self.load) for side in (state.left, state.right)]) / self.wanted - 1

    def height(self, index, roll, start):
        """At which the wheel ``index`` carries its load [m]; it lifts somewhere above."""
        low = high = start
        while self.lacks(high, roll)[index] < 0:
            high += 1e-4
        while self.lacks(low, roll)[index] > 0:
            low -= 1e-4
        return brentq(lambda z: self.lacks(z, roll)[index], low, high, xtol=1e-16, rtol=1e-14)

    def stand(self, start, reach=4e-5):
        """Height and roll at which both do: brackets within brackets, around the rigid ``start``."""
        def difference(roll):
            return self.height(1, roll, start.vertical_shift) - self.height(0, roll, start.vertical_shift)

        low = high = start.roll
        while difference(high) > 0:
            high += reach
        while difference(low) < 0:
            low -= reach
        roll = brentq(difference, low, high, xtol=1e-15, rtol=1e-13)
        return self.height(1, roll, start.vertical_shift), roll


@pytest.mark.parametrize("case", [case for case in CASES if case != "conformal"])
def test_scipy_finds_the_same_equilibrium(case):
    loads = Loads(case, "normal", "analyn")
    shift, yaw, transfer = CASES[case]
    height, roll = loads.stand(system().evaluate(shift, yaw))
    state = elastic().evaluate(shift, yaw, FORCE, transfer)
    assert state.status == 0
    # height and roll are sought to 1e-11 m, which is 1e-7 of a wheel's depth
    assert state.roll == pytest.approx(roll, abs=1e-10)                  # [rad]
    assert state.vertical_shift == pytest.approx(height, abs=1e-10)      # [m]
    np.testing.assert_allclose(loads.lacks(state.vertical_shift, state.roll), 0.0, atol=1e-6)


@pytest.mark.parametrize("case", CASES)
def test_vertical_load_stands_where_its_normal_loads_do(case):
    """The vertical load is met in sum, and each wheel's normal load leads to the same stand."""
    shift, yaw, transfer = CASES[case]
    state = elastic(load="vertical").evaluate(shift, yaw, FORCE, transfer)
    assert state.status == 0
    assert state.force.z == pytest.approx(-2 * FORCE, rel=1e-9)
    left, right = state.left.normal_force, state.right.normal_force
    again = elastic().evaluate(shift, yaw, (left + right) / 2, (right - left) / (right + left))
    # at 6.29 mm two stands lie 3e-5 rad apart, on root and flange
    near = 5e-5 if case == "conformal" else 1e-9
    assert again.roll == pytest.approx(state.roll, abs=near)
    assert again.vertical_shift == pytest.approx(state.vertical_shift, abs=near)


@pytest.mark.parametrize("case", CASES)
def test_force_acts_along_the_mean_of_the_normals(case):
    """Of the outline: pressure times length over its stations, by the rail's normal there; 31 stations tell it to 1 %, and the
    kernel's dozen nodes around the corner of 13 mm, where the conformal one stands, to 1.5 %."""
    shift, yaw, transfer = CASES[case]
    state = elastic().evaluate(shift, yaw, FORCE, transfer)
    total = np.zeros(2)
    for sign, side in ((-1, state.left), (1, state.right)):
        line = np.pi / 2 * side.outline.half_length * side.outline.pressure
        slope = rail_slope_along(side.contact.y_rail, side.outline.station)
        normal = np.array([sign * slope, -np.ones_like(slope)]) / np.hypot(1, slope)
        total += side.normal_force * (normal * line).sum(axis=1) / line.sum()
    allowed = 0.02 if case == "conformal" else 0.01
    assert (state.force.y, state.force.z) == pytest.approx(tuple(total), abs=allowed * FORCE)


def test_the_conformal_stand_is_an_equilibrium():
    """At 6.29 mm there are more than one, as the wheel hangs on root or flange; the one that was found is a root of both
    loads, to which Powell's method comes back, but for bends in the load that stop it a few nm short."""
    loads = Loads("conformal", "normal", "analyn")
    state = elastic().evaluate(*CASES["conformal"][:2], FORCE)
    np.testing.assert_allclose(loads.lacks(state.vertical_shift, state.roll), 0.0, atol=1e-6)
    found = root(lambda at: loads.lacks(*at), (state.vertical_shift + 2e-8, state.roll - 2e-8), tol=1e-13)
    np.testing.assert_allclose(found.x, (state.vertical_shift, state.roll), rtol=0.0, atol=5e-8)


@pytest.mark.parametrize("model, tolerance", [("hertz", 1e-8), ("analyn_strip", 0.01)])
@pytest.mark.parametrize("case", ["tread", "root", "flange", "yawed_flange"])
def test_compliant_loads_are_the_elastic_ones_with_other_models(case, model, tolerance):
    """Two sweeps of strips begin at ANALYN's patch for the load in one form and for the depth in the other: 0.7 %."""
    loads = Loads(case, "normal", model)
    state = elastic(normal_model=model).evaluate(*CASES[case][:2], FORCE, CASES[case][2])
    np.testing.assert_allclose(loads.lacks(state.vertical_shift, state.roll), 0.0, atol=tolerance)


@pytest.mark.parametrize("shift", [6.283e-3, 6.287e-3, 6.293e-3])
def test_where_the_load_jumps_the_stand_is_at_the_jump(shift):
    """Hertz's wheel between root and flange has the curvature of one or the other, and no height carries the load: 10 nm higher
    it carries less, 10 nm lower more; the other wheel carries its own, and the mirror image stands there too."""
    state = elastic(normal_model="hertz").evaluate(shift)
    mirrored = elastic(normal_model="hertz").evaluate(-shift)
    assert state.status == mirrored.status == 0
    assert (mirrored.roll, mirrored.vertical_shift) == pytest.approx((-state.roll, state.vertical_shift), abs=1e-11)
    above, below = (compliant(normal_model="hertz").evaluate(shift, vertical_shift_input=state.vertical_shift + away,
                                                             roll_input=state.roll) for away in (-1e-8, 1e-8))
    assert above.right.normal_force < 0.9 * FORCE < 1.1 * FORCE < below.right.normal_force
    assert above.left.normal_force == pytest.approx(FORCE, rel=1e-3)
    assert below.left.normal_force == pytest.approx(FORCE, rel=1e-3)


# --------------------------------------------------------------------------------------------- overlap, by dense search


def overlap(track, pose, x, abscissa):
    """How deep the right wheel is below the rail's point at ``abscissa`` and ``x`` along the track [m], along the rail's
    normal, broadcast; the wheel is the surface of revolution hypot(q_x, q_z) = R_0 + z(q_y), by Newton's method."""
    z, slope, _ = track.rail(abscissa)
    cosine = 1 / np.sqrt(1 + slope**2)
    turn = pose.rotation()
    start = np.stack(np.broadcast_arrays(x, track.rail_origin + abscissa, z), axis=-1) - pose.centre(track)
    along = np.stack(np.broadcast_arrays(0 * x, -slope * cosine, cosine), axis=-1)
    start, along = start @ turn, along @ turn
    depth = np.zeros(start.shape[:-1])
    for _ in range(40):
        q = start + depth[..., None] * along
        height, slope, _ = track.wheel(q[..., 1] - track.half_distance)
        distance = np.hypot(q[..., 0], q[..., 2])
        rate = slope * along[..., 1] - (q[..., 0] * along[..., 0] + q[..., 2] * along[..., 2]) / distance
        move = np.clip(-(track.nominal_radius + height - distance) / rate, -2e-3, 2e-3)
        depth = depth + move
    return np.where(np.abs(move) < 1e-10, depth, -1.0)


def deepest(track, pose, near, reach=1.5e-3):
    """Largest overlap, x and abscissa [m] within ``reach`` of the rail's abscissa ``near``: grids of ever smaller cells."""
    x, y, wide, high = 0.0, near, 0.06, reach
    for _ in range(9):
        grid_x, grid_y = x + np.linspace(-wide, wide, 41)[:, None], y + np.linspace(-high, high, 41)[None, :]
        depth = overlap(track, pose, grid_x, grid_y)
        i, j = np.unravel_index(np.argmax(depth), depth.shape)
        x, y, wide, high = grid_x[i, 0], grid_y[0, j], wide / 5, high / 5
    return depth[i, j], x, y


OVERLAPS = [(0.0, 0.0), (2e-3, 0.01), (4.95e-3, 0.0), (5.2e-3, 0.0175), (6e-3, 0.0), (6.15e-3, 0.0175), (7e-3, 0.02),
            (-6e-3, 0.03), (6.6e-3, -0.05)]


@pytest.mark.parametrize("shift, yaw", OVERLAPS)
def test_overlap_is_that_of_the_surface_of_revolution(shift, yaw):
    """Every region's deepest point along the rail's normals, at the pose where the wheelset carries FORCE."""
    stand = elastic().evaluate(shift, yaw)
    stepper, track = compliant().stepper(), brute_force.track()
    stepper.inputs[:] = shift, yaw, 0.0, 0.0, 0.0, stand.vertical_shift, stand.roll
    assert stepper.step() == 0
    work = stepper._workspace
    count = int(work[overlaps.DEEP_COUNT])
    regions = work[overlaps.DEEP_FIRST:][:overlaps.DEEP_SIZE * count].reshape(-1, overlaps.DEEP_SIZE)
    pose = brute_force.Pose(shift, yaw, stand.roll, stand.vertical_shift)
    for region in regions:    # of the right wheel, which came last
        depth, _, abscissa = deepest(track, pose, region[overlaps.DEEP_RAIL])
        assert region[overlaps.DEEP_DEPTH] == pytest.approx(depth, abs=1e-11)      # [m]; measured 5e-13
        assert region[overlaps.DEEP_RAIL] == pytest.approx(abscissa, abs=1e-7)
    state = compliant().evaluate(shift, yaw, vertical_shift_input=stand.vertical_shift, roll_input=stand.roll)
    assert state.right.penetration == max(regions[:, overlaps.DEEP_DEPTH])
    assert deepest(track, pose.mirrored(), state.left.contact.y_rail)[0] == pytest.approx(state.left.penetration, abs=1e-11)
    assert len(regions) == (2 if shift in (4.95e-3, 5.2e-3, 6.15e-3) else 1)


# --------------------------------------------------------------------------------------------------- Hertz, pressed down

BALL, CROWN = 0.2, 0.09   # radii of wheel and rail profile [m]


@cache
def circles(**parameters):
    """A wheel and a rail of one circle each, that touch at 13 deg."""
    wheel = Profile("ball", "wheel", (Arc(-60.0, 60.0, 1e3 * BALL, 45.0, -199.0, +1),))
    rail = Profile("crown", "rail", (Arc(-36.0, 36.0, 1e3 * CROWN, 0.0, 1e3 * CROWN, -1),))
    return wrcontact.ContactSystem(wheel, rail, rail_inclination=0.0, gauge=1.4, gauge_depth=6e-3, **parameters)


@pytest.mark.parametrize("sink", [1e-6, 1e-5, 1e-4])
def test_a_ball_pressed_down_on_a_slope_is_hertz(sink):
    """Circles overlap by what their radii exceed the distance of their centres, sink cos(angle) to first order."""
    rigid = circles().evaluate()
    state = circles(contact_mode="compliant").evaluate(vertical_shift_input=rigid.vertical_shift + sink)
    angle = rigid.right.contact_angle
    assert state.status == 0 and abs(angle) > 0.1
    total = BALL + CROWN
    apart = total * np.array([np.sin(angle), np.cos(angle)]) - [0.0, sink]      # of the centres, across and down
    depth = total - np.hypot(*apart)
    assert depth == pytest.approx(sink * math.cos(angle), rel=sink / total)
    A = 0.5 * math.cos(angle) / rigid.right.rolling_radius
    B = 0.5 * (1 / BALL + 1 / CROWN)
    force = brentq(lambda load: hertz(A, B, load)[0] - depth, 1e-3, 1e7, rtol=1e-13)
    for side in (state.left, state.right):
        assert side.penetration == pytest.approx(depth, abs=1e-13)
        # the gap is a circle's and not its parabola's: patch over radius squared, 1e-3
        assert side.normal_force == pytest.approx(force, rel=2e-3)
    again = circles(contact_mode="elastic").evaluate(normal_force=state.right.normal_force)
    assert again.vertical_shift == pytest.approx(state.vertical_shift, abs=1e-12)


# ------------------------------------------------------------------------------------------------------------ resultant


@cache
def placed_rail():
    """UIC60 1:40 at gauge: the kernel's table of it, and its track coordinate [m]."""
    placed = place_rail(standard_profile("UIC60"), inclination=1 / 40, gauge=1.435, gauge_depth=0.014)
    return compile_profile(placed.profile), placed.y_track


def rail_point_along(start, stations):
    """Abscissae [m] of the rail at arc lengths ``stations`` from ``start``, by numpy on a dense grid."""
    table, _ = placed_rail()
    x = np.linspace(start - 0.02, start + 0.03, 200_001)
    x = x[(x > table[0]) & (x < table[1])]
    speed = np.sqrt(1 + evaluate_table(table, x)[1] ** 2)
    length = np.concatenate(([0.0], np.cumsum(0.5 * (speed[1:] + speed[:-1]) * np.diff(x))))
    return np.interp(stations, length - np.interp(start, x, length), x)


def rail_slope_along(start, stations):
    return evaluate_table(placed_rail()[0], rail_point_along(start, stations))[1]


def forces_of(state, bent):
    """Contact forces (n, 3) [N] and the places where they act (n, 3) [m] in the track frame, from the patches' outputs.

    A force acts along the rail's normal at its patch's centroid, which is measured along the rail where ``bent``, else in the
    contact plane."""
    table, rail_y = placed_rail()
    for sign, side in ((-1, state.left), (1, state.right)):
        for patch in side.patches:
            x = side.contact.y_rail + patch.centroid * math.cos(side.contact_angle)
            if bent:
                x = rail_point_along(side.contact.y_rail, patch.centroid)
            height, slope, _ = evaluate_table(table, x)
            place = (side.contact.x_track, sign * (rail_y + x), height)
            force = np.array((0.0, sign * slope, -1.0)) / math.hypot(1.0, slope)
            yield patch.normal_force * force, np.array(place)


@pytest.mark.parametrize("mode", ["elastic", "rigid"])
@pytest.mark.parametrize("case", [case for case in CASES if case != "conformal"])
def test_resultant_is_the_sum_of_the_patches(case, mode):
    shift, yaw, transfer = CASES[case]
    state = system(contact_mode=mode).evaluate(shift, yaw, FORCE, transfer)
    apart = any(abs(patch.contact_angle - side.contact_angle) > math.radians(15) for side in (state.left, state.right)
                for patch in side.patches)
    forces, places = map(np.array, zip(*forces_of(state, mode == "elastic" or apart)))
    got = np.array([[getattr(of, axis) for axis in "xyz"] for of in (state.force, state.moment)])
    # the mean of the normals is not quite the normal at the centroid, least on the tread with its 17 mm of patch (5e-3); and a
    # second patch's centroid is not quite on the rail where the contact plane has it
    several = any(side.patch_count > 1 for side in (state.left, state.right))
    atol = 6e-3 if mode == "elastic" or apart else 2e-3 if several else 1e-4
    np.testing.assert_allclose(got[0], forces.sum(axis=0), atol=atol * FORCE)
    centre = np.array([0.0, shift, state.vertical_shift - 0.46])
    moment = np.cross(places - centre, forces).sum(axis=0)
    # levers of half a metre; a yawed second patch is up to 17 mm ahead of the contact point: times its share of the load 7 mm
    assert abs(got[1] - moment)[0] < 4e-3 * FORCE
    assert np.all(abs(got[1] - moment)[1:] < (7e-3 * FORCE if yaw else 1e-12))


def test_resultant_of_a_centred_wheelset_is_its_weight():
    for mode in ("elastic", "rigid"):
        state = system(contact_mode=mode).evaluate()
        forces, _ = map(np.array, zip(*forces_of(state, mode == "elastic")))
        assert state.force.z == pytest.approx(forces.sum(axis=0)[2], rel=5e-4)
        assert abs(state.force.y) < 1e-5 and abs(state.moment.x) < 1e-5    # [N, N m]
        assert state.force.x == state.moment.y == state.moment.z == 0.0


@pytest.mark.parametrize("mode", ["elastic", "rigid"])
def test_vertical_load_is_what_the_wheels_carry_vertically(mode):
    rng = np.random.default_rng(31)
    shift, force, transfer = rng.uniform(-6.2e-3, 6.2e-3, 200), rng.uniform(1e3, 1e5, 200), rng.uniform(-0.9, 0.9, 200)
    table = system(contact_mode=mode, load="vertical").evaluate_many(shift, 0.01, force, transfer)
    assert not np.any(table.status)
    np.testing.assert_allclose(-table.force.z, 2 * force, rtol=1e-9)


def test_forces_nearly_come_from_a_potential():
    """A height's force and a roll's moment are derivatives of one energy if contact conserves it.  ANALYN's nearly does: the
    stiffness's two halves differ by 2.0 % of k_zz times half the distance of the wheels at most, measured; its load follows
    the deepest point, and its centre of load does not quite stand there.  Not so at 6.29 mm, where the patch reaches around
    the flange root and its force along the mean of 30 ... 70 deg, but the load still follows the deepest point: a third."""
    for case in set(CASES) - {"conformal"}:
        shift, yaw, transfer = CASES[case]
        stand = elastic().evaluate(shift, yaw, FORCE, transfer)

        def slope(of, height, roll):
            ahead, behind = (compliant().evaluate(shift, yaw, vertical_shift_input=stand.vertical_shift + sign * height,
                                                  roll_input=stand.roll + sign * roll) for sign in (1, -1))
            return (of(ahead) - of(behind)) / (2 * (height + roll))

        own = abs(slope(lambda state: state.force.z, 1e-7, 0.0)) * 0.75
        by_roll = slope(lambda state: state.force.z, 0.0, 1e-7)
        by_height = slope(lambda state: state.moment.x, 1e-7, 0.0)
        assert abs(by_roll - by_height) < 0.03 * own, (case, by_roll / own, by_height / own)


def test_a_lifted_wheelset_carries_nothing():
    rigid = system().evaluate(3e-3, 0.01)
    for model in MODELS:
        pair = compliant(normal_model=model)
        state = pair.evaluate(3e-3, 0.01, vertical_shift_input=rigid.vertical_shift - 1e-4, roll_input=rigid.roll)
        assert state.status == wrcontact.Status.UNLOADED
        assert state.left.normal_force == state.right.normal_force == 0.0 and state.right.patch_count == 0
        assert all(getattr(of, axis) == 0.0 for of in (state.force, state.moment) for axis in "xyz")
        # one wheel down, the other up
        state = pair.evaluate(3e-3, 0.01, vertical_shift_input=rigid.vertical_shift, roll_input=rigid.roll + 1e-4)
        assert state.status == wrcontact.Status.UNLOADED
        assert state.left.normal_force == 0.0 and state.right.normal_force > 1e4 and state.moment.x < 0.0


def test_a_wheel_that_comes_down_carries_more():
    for case in CASES:
        shift, yaw, _ = CASES[case]
        rigid = system().evaluate(shift, yaw)
        sink = np.linspace(1e-6, 2e-4, 200)
        height = rigid.vertical_shift + sink
        table = compliant().evaluate_many(shift, yaw, vertical_shift_input=height, roll_input=rigid.roll)
        assert not np.any(table.status)
        for side in (table.left, table.right):
            fall = np.diff(side.normal_force) / side.normal_force[:-1]
            assert fall.min() > -0.12, case    # where a second region opens ANALYN's load may step back


# ------------------------------------------------------------------------------------- symmetry, history, random poses


def random_poses(count, seed, shift=9e-3, yaw=0.06, forces=(1.0, 4e5), transfer=0.9):
    rng = np.random.default_rng(seed)
    yaws = rng.uniform(-yaw, yaw, count)
    yaws[::3] = 0.0
    return (rng.uniform(-shift, shift, count), yaws, np.exp(rng.uniform(*np.log(forces), count)),
            rng.uniform(-transfer, transfer, count))


@pytest.mark.parametrize("load", LOADS)
@pytest.mark.parametrize("model", MODELS)
def test_mirror_guess_and_history_change_nothing(model, load):
    """Measured: 3.2e-11 rad by mirroring, 2e-11 rad by the guess, 1e-15 rad by the order."""
    pair = elastic(normal_model=model, load=load)
    shift, yaw, force, transfer = random_poses(400, 41, 8e-3, 0.03, (1e3, 1.5e5), 0.5)
    rng = np.random.default_rng(42)
    order = rng.permutation(400)
    plain = pair.evaluate_many(shift, yaw, force, transfer)
    mirrored = pair.evaluate_many(-shift, -yaw, force, -transfer)
    guessed = pair.evaluate_many(shift, yaw, force, transfer, roll_guess=rng.uniform(-0.01, 0.01, 400))
    mixed = pair.evaluate_many(shift[order], yaw[order], force[order], transfer[order])
    assert not np.any(plain.status)
    for name, sign in (("roll", -1), ("vertical_shift", 1)):
        one = getattr(plain, name)
        np.testing.assert_allclose(getattr(mirrored, name), sign * one, atol=2e-10)
        np.testing.assert_allclose(getattr(guessed, name), one, atol=2e-10)
        np.testing.assert_allclose(getattr(mixed, name), one[order], atol=1e-13)
    np.testing.assert_allclose(mirrored.left.penetration, plain.right.penetration, rtol=1e-6)
    np.testing.assert_allclose(mirrored.force.y, -plain.force.y, atol=1e-5 * 1.5e5)
    for k in range(0, 400, 40):
        fresh = pair.stepper()
        fresh.inputs[:5] = shift[k], yaw[k], 0.0, force[k], transfer[k]
        assert fresh.step() == 0
        assert fresh.outputs[layout.OUT_ROLL] == pytest.approx(plain.roll[k], abs=1e-12)


@needs_library
@pytest.mark.parametrize("parameters", [
    {"contact_mode": "elastic"}, {"contact_mode": "elastic", "normal_model": "analyn_strip", "load": "vertical"},
    {"contact_mode": "compliant"}, {"contact_mode": "compliant", "normal_model": "hertz"},
], ids=lambda parameters: "-".join(parameters.values()))
def test_compiled_and_python_are_one_in_the_last_bit(tmp_path, parameters):
    shift, yaw, force, transfer = random_poses(14, 43, 8e-3, 0.03, (1e3, 1.5e5), 0.5)
    stand = elastic().evaluate_many(shift, yaw, force, transfer)
    rows = np.column_stack([shift, yaw, 0 * shift, force, transfer, stand.vertical_shift, stand.roll])
    rows[3, 5], rows[6, 6], rows[9, 5] = math.nan, 1.0, -1e-2
    found = [run_steps(rows, tmp_path, choice=choice, **parameters) for choice in ("compiled", "python")]
    if sys.platform == "win32":                     # the compiler's sin and atan are not CPython's there
        np.testing.assert_allclose(*found, rtol=1e-9)
    else:
        np.testing.assert_array_equal(bits(found[0]), bits(found[1]))


@pytest.mark.parametrize("model, mean, most", [("analyn", 10, 100), ("analyn_strip", 10, 100), ("hertz", 10, 100)])
def test_a_step_takes_few_trials(model, mean, most):
    """Measured with those of the rigid search: 8.7 on average, 20 at the 99th percentile, 74 at most, with brackets."""
    stepper, counts = elastic(normal_model=model).stepper(), []
    for pose in zip(*random_poses(600, 44, 8e-3, 0.03, (1e3, 1.5e5), 0.5)):
        stepper.inputs[[0, 1, 3, 4]] = pose
        before = stepper.state[layout.STATE_ROLL_COUNT]
        assert stepper.step() == 0
        counts.append(stepper.state[layout.STATE_ROLL_COUNT] - before)
    assert np.mean(counts) < mean and np.percentile(counts, 99) < 60 and max(counts) < most


def check_random_poses(count, seed, rail, inclination, model, load):
    """Statuses 0 and 1; or 2 where a wheel would stand about 2 mm deep: under vertical loads of some 300 kN on a flange."""
    parameters = dict(rail=rail, rail_inclination=inclination, normal_model=model, load=load)
    poses = np.array(random_poses(count, seed))
    table = elastic(**parameters).evaluate_many(*poses)
    refused = np.flatnonzero(table.status > 1)
    for k in refused:
        where = f"{parameters} {[float(value) for value in poses[:, k]]}: status {table.status[k]}"
        rigid = system(**parameters).evaluate(*poses[:, k])
        sink = max(side.penetration / math.cos(side.contact_angle) for side in (rigid.left, rigid.right))
        assert table.status[k] == 2 and load == "vertical" and sink > 1e-3, f"{where}, {1e3 * sink:.2f} mm deep"
    for sign, side in ((-1, table.left), (1, table.right)):
        good = table.status == 0
        if load == "normal":
            wanted = poses[2] * (1 + sign * poses[3])
            np.testing.assert_allclose(side.normal_force[good], wanted[good], rtol=1e-6)
    return len(refused)


@pytest.mark.parametrize("load", LOADS)
@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("pair", range(len(PAIRS)))
def test_random_poses_stand(pair, model, load):
    assert check_random_poses(60, 50 + pair, *PAIRS[pair], model, load) <= 1


@pytest.mark.slow
@pytest.mark.parametrize("load", LOADS)
@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("pair", range(len(PAIRS)))
def test_many_random_poses_stand(pair, model, load):
    """Measured: no status 3 in 216 000 poses; status 2 in one of 1100 with vertical loads."""
    assert check_random_poses(4000, 70 + pair, *PAIRS[pair], model, load) <= 12


#: Once refused (status 3): the first sample of the overlap lay beyond the rail, and the guess beside it was the other
#: side's; Newton's method for a deepest point swung to and fro.
ONCE_REFUSED = [
    ("54E1", 1 / 20, "normal", (-0.0058487261477867675, 0.04631273279453417, 203082.27503455844, -0.5752669176125726)),
    ("54E1", 1 / 20, "normal", (0.005753283566805999, 0.04565362260413991, 42.233597926451544, 0.06340601422594294)),
    ("54E1", 1 / 20, "normal", (0.005627118423548107, 0.049592264914850415, 9.282953393581076, -0.620919936840998)),
    ("54E1", 1 / 20, "vertical", (-0.0054536774061790805, 0.0559478341625486, 1065.9421201621758, 0.7234823042869359)),
    ("54E1", 1 / 40, "vertical", (-0.006533775692339662, 0.0, 167302.94718115925, -0.5631799716684236)),
]


@pytest.mark.parametrize("rail, inclination, load, pose", ONCE_REFUSED)
def test_poses_that_were_refused_once(rail, inclination, load, pose):
    for model in MODELS:
        assert elastic(rail=rail, rail_inclination=inclination, load=load, normal_model=model).evaluate(*pose).status == 0


#: Once refused (status 2 or 3) although the wheelset stands 0.05 to 0.5 mm deep: on the way from the rigid roll to the stand a
#: steep flange would have to be deeper than 2 mm, or the nodes of a deep stand carried more than the load at every level.
STEEP = {"separation": {"separation": "vertical"}, "basic": {"longitudinal_curvature": "basic"}, "default": {}}
ONCE_TOO_STEEP = [
    ("default", (-0.006441960288928336, -0.01931160209022382, 191217.56157863978, -0.9453709409738588)),
    ("basic", (0.006434177935025435, 0.021933914269399883, 190255.06901448508, 0.43692107314968576)),
    ("basic", (0.0065390967883287195, -0.010049882209345197, 168127.83108761467, 0.7583132760564419)),
    ("basic", (0.00646611254798964, -0.0274989256469922, 173709.85983908392, 0.6047533954709294)),
    ("separation", (0.00646611254798964, -0.0274989256469922, 173709.85983908392, 0.6047533954709294)),
    ("separation", (0.0065022498121319085, -0.02087709900787211, 190650.18990882143, 0.9067269304079526)),
    ("separation", (0.00637832868166607, 0.030976122547405567, 153597.37537829397, 0.5586651678481243)),
    ("separation", (0.0064203371819753635, -0.020948591203970697, 177722.16171836772, 0.5811281964470212)),
    ("separation", (0.006463620028195276, -0.02712576155100905, 132535.87157966816, 0.7955738453260797)),
]


@pytest.mark.parametrize("choice, pose", ONCE_TOO_STEEP)
def test_a_steep_flange_stands_where_the_compliant_form_carries_its_load(choice, pose):
    """The compliant form, which is given height and roll, carries the tread's load there, and more than the flange's 10 nm
    lower, less 10 nm higher."""
    shift, yaw, force, transfer = pose
    state = elastic(load="vertical", **STEEP[choice]).evaluate(*pose)
    assert state.status == 0
    away = []
    for move in (-1e-8, 1e-8):
        stand = compliant(load="vertical", **STEEP[choice]).evaluate(
            shift, yaw, vertical_shift_input=state.vertical_shift + move, roll_input=state.roll)
        tread = stand.left if shift > 0 else stand.right
        assert carried(tread, "vertical") == pytest.approx(force * (1 - abs(transfer)), rel=2e-3)   # 1e-8 m is up to 1e-3
        away.append(-stand.force.z - carried(tread, "vertical"))
    wanted = force * (1 + abs(transfer))
    # the stand is met to 1e-13 m, 1e-9 of the load
    assert away[0] < (1 + 1e-8) * wanted and away[1] > (1 - 1e-8) * wanted, (away[0] / wanted, away[1] / wanted)


def test_both_wheels_stand_at_one_height_where_the_flange_s_jumps():
    """The flange carries its load at several heights of one roll; once the two wheels stood 0.1 mm apart there, at status 0."""
    parameters = dict(load="vertical", normal_model="analyn_strip", separation="vertical", longitudinal_curvature="basic",
                      lateral_curvature="smooth")
    shift, yaw, force, transfer = 0.006717038521666567, -0.02235267519980281, 177991.03241361293, 0.8098496174104448
    state = elastic(**parameters).evaluate(shift, yaw, force, transfer)
    assert state.status == 0
    stand = compliant(**parameters).evaluate(shift, yaw, vertical_shift_input=state.vertical_shift, roll_input=state.roll)
    # strips are corrected for the load in one form and for the depth in the other, on a tread 0.14 % at most (measured)
    assert stand.left.normal_force == pytest.approx(state.left.normal_force, rel=2e-3)


def test_a_load_that_no_depth_carries_is_told():
    """The flange carries at most 0.989 of its load where it is less than 2 mm deep and the tread carries its own, by a scan of the
    compliant form over 1200 rolls; half of the load stands."""
    pair = elastic(load="vertical", longitudinal_curvature="basic")
    pose = (0.00673795137966747, 0.03108301780155364)
    assert pair.evaluate(*pose, 91133.0, 0.9198425535487278).status == 0
    state = pair.evaluate(*pose, 182267.24730465972, 0.9198425535487278)
    sentence = explain(state.status, state.inputs)
    assert state.status == 2
    assert all(word in sentence for word in ("normal_force 182267 N", "load_transfer 0.919843", "deeper", "0.002 m")), sentence


# ------------------------------------------------------------------------------- planes of their own, in rigid contact

#: yaw [deg], shift [mm], force [N]: flange root and flange carry load at once
SPREAD = [(0.9, 6.13, 78.5e3), (0.9, 6.15, 180e3), (0.9, 6.17, 15e3), (0.9, 6.17, 78.5e3), (1.2, 6.1, 78.5e3),
          (1.2, 6.1, 180e3), (1.6, 6.0, 15e3), (1.6, 6.0, 78.5e3), (1.6, 6.0, 180e3)]


def second_derivatives(track, pose, x, abscissa, along=1.5e-3, across=2.5e-4):
    """Principal curvatures (2,) [1/m] of the distance from the rail, less the rail's own normal, at a smallest one."""
    _, slope, _ = track.rail(abscissa)
    step = across / math.hypot(1.0, slope)
    three = np.array([-1.0, 0.0, 1.0])
    grid = -overlap(track, pose, x + along * three[:, None], abscissa + step * three[None, :])
    xx = (grid[0, 1] - 2 * grid[1, 1] + grid[2, 1]) / along**2
    ss = (grid[1, 0] - 2 * grid[1, 1] + grid[1, 2]) / across**2
    xs = (grid[0, 0] + grid[2, 2] - grid[0, 2] - grid[2, 0]) / (4 * along * across)
    return np.linalg.eigvalsh([[xx, xs], [xs, ss]])


def two_hertz_loads(track, pose, state, force):
    """Loads of the contact point's region and of the flange's [N], each Hertz's with the gap along its own normal.

    The wheel comes down the contact point's normal by d, and the flange's by cos(turn) d less its gap; each presses the
    other down by N / (pi E* distance), and of that cos(turn) comes along its normal.
    """
    near = state.right.contact.y_rail
    gap, x_f, y_f = deepest(track, pose, -0.0424, 8e-4)
    _, x_0, y_0 = deepest(track, pose, near, 2e-4)
    angles = [-math.atan(track.rail(y)[1]) for y in (y_0, y_f)]
    turn = math.cos(angles[1] - angles[0])
    places = np.array([(x, y, track.rail(y)[0]) for x, y in ((x_0, y_0), (x_f, y_f))])
    push = turn / (math.pi * MODULUS * np.linalg.norm(places[1] - places[0]))
    stiffness = [1e4 / hertz(*(second_derivatives(track, pose, x, y) / 2), 1e4)[0]**1.5 for x, y in ((x_0, y_0), (x_f, y_f))]

    def loads(down):
        one = other = 0.0
        for _ in range(60):
            one = stiffness[0] * max(down - push * other, 0.0)**1.5
            other = stiffness[1] * max(turn * down + gap - push * one, 0.0)**1.5
        return one, other

    down = brentq(lambda down: sum(loads(down)) - force, 1e-7, 1e-3, xtol=1e-12)
    return (*loads(down), down, angles)


@pytest.mark.parametrize("yaw, shift, force", SPREAD)
def test_root_and_flange_share_a_rigid_wheel(yaw, shift, force):
    state = system().evaluate(shift * 1e-3, math.radians(yaw), force)
    side = state.right
    assert state.status == 0 and side.patch_count == 2
    root_patch, flange = sorted(side.patches, key=lambda patch: patch.contact_angle)
    assert flange.contact_angle - root_patch.contact_angle > math.radians(15)
    assert root_patch.contact_angle == pytest.approx(side.contact_angle, abs=1e-9)
    assert side.normal_force == pytest.approx(force, rel=1e-9)
    assert root_patch.normal_force + flange.normal_force == pytest.approx(force, rel=1e-9)
    outline = side.outline
    assert np.all(np.diff(outline.station) > 0) and np.all(outline.half_length >= 0)
    assert outline.station[-1] - outline.station[0] == pytest.approx(side.patch_width, rel=1e-12)
    # the flange lies to the inside, and the stations between them are empty
    assert flange.centroid + flange.width < root_patch.centroid - root_patch.width / 2
    between = (outline.station > flange.centroid + flange.width) & (outline.station < root_patch.centroid - root_patch.width)
    assert np.all(outline.half_length[between] == 0.0)


@pytest.mark.parametrize("mode, shift, yaw, force", [
    ("rigid", 5.487379916049944e-3, 0.049410464000100594, 66986.25868528389),
    ("elastic", 5.800301577896962e-3, 0.04273883444233607, 325564.17596696055)])
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
    assert flange.contact_angle == pytest.approx(angles[1], abs=1e-3)
    # measured 0.018 and 5 %: ANALYN's root patch is no ellipse
    assert flange.normal_force / force == pytest.approx(other / force, abs=0.025)
    assert state.right.penetration == pytest.approx(down, rel=0.07)


# ------------------------------------------------------------------------------------------------------------ bad input


@pytest.mark.parametrize("mode", ["elastic", "compliant"])
def test_a_penetration_is_refused(mode):
    with pytest.raises(ValueError, match=f"penetration is given; permitted with the contact_mode .*{mode}.* is none"):
        system(contact_mode=mode).evaluate(penetration=5e-5)
    with pytest.raises(ValueError, match=f"contact_mode is '{mode}'; permitted with .* 'halfspace'.*is 'rigid'"):
        wrcontact.ContactSystem(contact_mode=mode, normal_model="halfspace")


def test_bad_heights_and_rolls_are_told_and_forgotten():
    pair, rigid = compliant(), system().evaluate(1e-3)
    good = dict(lateral_shift=1e-3, vertical_shift_input=rigid.vertical_shift + 5e-5, roll_input=rigid.roll)
    first = pair.evaluate(**good)
    assert first.status == 0
    for name in ("vertical_shift_input", "roll_input"):
        for value in (math.nan, math.inf):
            state = pair.evaluate(**{**good, name: value})
            assert state.status == wrcontact.Status.INVALID_INPUT
            assert name in explain(state.status, state.inputs)
            np.testing.assert_array_equal(state.values, first.values)
    for change in (dict(roll_input=0.5), dict(vertical_shift_input=5e-3)):
        assert pair.evaluate(**{**good, **change}).status == wrcontact.Status.OFF_PROFILE
    np.testing.assert_array_equal(pair.evaluate(**good).values, first.values)


def test_a_stand_on_a_jump_of_the_load_is_always_the_same_end_of_it():
    """Two places of the right wheel are equally deep where it stands, one carries more than the load and the other less; once they
    took turns from one nanometre to the next."""
    pair = wrcontact.ContactSystem(
        rail="54E1", rail_inclination=1 / 30, gauge=1.4452408348436032, nominal_radius=0.4724724783139843,
        contact_mode="elastic", normal_model="hertz", separation="equidistant_chord", longitudinal_curvature="basic",
        lateral_curvature="rough")
    shift, yaw, force, transfer = 0.008346254944846863, -0.07552726543349111, 150e3, 0.01602679187811673
    table = pair.evaluate_many(shift + 1e-9 * np.arange(-20, 21), yaw, force, load_transfer=transfer)
    mirrored = pair.evaluate_many(-shift - 1e-9 * np.arange(-20, 21), -yaw, force, load_transfer=-transfer)
    assert not table.status.any() and not mirrored.status.any()
    # 20 nm move the place by 1e-7 m, and to the other one it is 14 mm
    assert np.ptp(table.right.contact.y_wheel) < 1e-6
    assert np.abs(table.right.contact.y_wheel - mirrored.left.contact.y_wheel).max() < 1e-6
