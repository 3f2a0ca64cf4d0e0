"""The power of friction is that of the forces, friction never drives, and forces add up, also where a wheel
has more patches than are reported."""

import numpy as np
import pytest
from numpy.polynomial import chebyshev, polynomial

import wrcontact
from tests.helpers.cases import CREEP_MODELS, MODELS
from tests.helpers.inside import work_of
from wrcontact.interface.inputs import INPUTS
from wrcontact.profiles import Profile
from wrcontact.profiles.zones import Polynomial

NORMAL = ("analyn", "analyn_strip")
MOTION = {"speed": 20.0, "lateral_velocity": 0.03, "yaw_rate": 0.02}


def greatest_power(side, friction, given):
    """Friction times load at the speeds of the inputs (n,) [W]."""
    return friction * side.normal_force * (np.abs(given["speed"]) + 0.46 * np.abs(given["wheel_rate"]))


@pytest.mark.parametrize("normal", NORMAL)
@pytest.mark.parametrize("model", CREEP_MODELS)
def test_power_is_that_of_force_and_moment(normal, model):
    """P = -(F . v + M . W) with the creep forces in the outputs, the velocity v of the centre and the
    rotation W of the wheelset with that about the axle.  A yaw rate turns a rolled wheelset about its axle as
    well, there with the distance from it in the place of the rolling radius: below 1e-8 of mu N V."""
    rng = np.random.default_rng(5)
    shift, yaw = rng.uniform(-6.5e-3, 6.5e-3, 60), rng.uniform(-0.02, 0.02, 60)
    stand = wrcontact.ContactSystem(contact_mode="elastic", normal_model=normal).evaluate_many(shift, yaw)
    given = {
        "lateral_shift": shift,
        "yaw": yaw,
        "vertical_shift_input": stand.vertical_shift,
        "roll_input": stand.roll,
        "speed": rng.uniform(-30, 30, 60),
        "free_rolling": np.zeros(60),
        "wheel_rate": rng.uniform(-60, 60, 60),
        "lateral_velocity": rng.uniform(-0.1, 0.1, 60),
        "vertical_velocity": rng.uniform(-0.01, 0.01, 60),
        "yaw_rate": rng.uniform(-0.05, 0.05, 60),
        "roll_rate": rng.uniform(-0.02, 0.02, 60),
        "track_curvature": rng.uniform(-3e-3, 3e-3, 60),
    }
    table = wrcontact.ContactSystem(
        contact_mode="compliant", normal_model=normal, tangential_model=model
    ).evaluate_many(**given)
    assert (table.status == 0).all()
    creep, moment = (
        np.subtract(one, two)
        for one, two in ((table.force, table.normal.force), (table.moment, table.normal.moment))
    )
    axle = np.array([-np.sin(yaw) * np.cos(table.roll), np.cos(yaw) * np.cos(table.roll), np.sin(table.roll)])
    bend = given["speed"] * given["track_curvature"]
    velocity = np.array(
        [given["speed"] - bend * shift, given["lateral_velocity"], given["vertical_velocity"]]
    )
    rotation = (
        np.array(
            [given["roll_rate"] * np.cos(yaw), given["roll_rate"] * np.sin(yaw), given["yaw_rate"] + bend]
        )
        - given["wheel_rate"] * axle
    )
    wanted = -(creep.T * velocity).sum(axis=0) - (moment.T * rotation).sum(axis=0)
    found = table.left.friction_power + table.right.friction_power
    most = sum(greatest_power(side, 0.3, given) for side in (table.left, table.right))
    assert np.abs(found - wanted).max() > 0.0
    assert (np.abs(found - wanted) < 1e-8 * most).all()
    np.testing.assert_allclose(table.driving_torque, -(moment.T * axle).sum(axis=0), atol=1e-8, rtol=1e-9)


def usual_motions(count, rng):
    """A wheelset on a curved track: half of its shifts are those at which the flange root rolls on the rail's
    corner."""
    speed = rng.uniform(5, 60, count)
    root = np.arange(count) % 2 == 1
    return {
        "lateral_shift": np.where(root, rng.uniform(6.2e-3, 6.4e-3, count), rng.uniform(-7e-3, 7e-3, count)),
        "yaw": rng.uniform(-0.02, 0.02, count) * (rng.random(count) < 0.5),
        "normal_force": rng.uniform(3e4, 1.5e5, count),
        "speed": speed,
        "wheel_rate": speed / 0.46 * (1.0 + rng.normal(0.0, 3e-3, count)),
        "lateral_velocity": rng.normal(0.0, 0.03, count),
        "yaw_rate": rng.normal(0.0, 0.05, count),
    }


@pytest.mark.parametrize("mode", ("rigid", "elastic", "compliant"))
@pytest.mark.parametrize(
    "normal", [pytest.param(name, marks=[pytest.mark.full] * (name == "analyn_strip")) for name in MODELS]
)
def test_friction_never_drives(normal, mode):
    """And takes no more than all of it, sliding at a third of the speed: a yaw of 0.02 and lateral velocities
    of 0.02 of the speed are three times as much along a flange of 70 degrees, 0.2 at most were found."""
    given = usual_motions(600, np.random.default_rng(8))
    if mode == "compliant":
        stand = wrcontact.ContactSystem(contact_mode="elastic", normal_model="hertz").evaluate_many(**given)
        given |= {"vertical_shift_input": stand.vertical_shift, "roll_input": stand.roll}
    for model in CREEP_MODELS:
        table = wrcontact.ContactSystem(
            contact_mode=mode, normal_model=normal, tangential_model=model
        ).evaluate_many(**given)
        good = table.status <= 1
        assert good.mean() > 0.99
        for side in (table.left, table.right):
            for patch in side.patches:
                most = 0.3 * patch.normal_force * given["speed"]
                power = patch.friction_power[good] / (1e-12 + most[good])
                assert power.min() >= -1e-9 and power.max() <= 0.3, (model, power.min(), power.max())


#: Slope of the cone and of the rail below it, height of the bumps and half of their width [mm].
SLOPE, HEIGHT, HALF = 0.02, 0.02, 12
#: Under this load [N] four bumps carry.
LOAD = 1e5


def bumpy_system(**parameters):
    """A cone on a rail with bumps beside each other, a Chebyshev polynomial: a wheel has four patches."""
    bumps = HEIGHT * chebyshev.cheb2poly([0.0] * 8 + [1.0]) / float(HALF) ** np.arange(9)
    head = polynomial.polyadd(bumps, [0.0, -SLOPE, 1.0 / 6000.0])
    slope = polynomial.polyder(head)

    def beyond(y):
        """The head goes on with its slope at ``y`` and a radius of 80 mm."""
        z, m, bend = polynomial.polyval(y, head), polynomial.polyval(y, slope), 1.0 / 160.0
        return z - m * y + bend * y * y, m - 2.0 * bend * y, bend

    rail = Profile(
        "bumps",
        "rail",
        (
            Polynomial(-60, -HALF, beyond(-HALF)),
            Polynomial(-HALF, HALF, tuple(head)),
            Polynomial(HALF, 60, beyond(HALF)),
        ),
    )
    wheel = Profile("cone", "wheel", (Polynomial(-70, 60, (0.0, -SLOPE)),))
    return wrcontact.ContactSystem(
        wheel=wheel, rail=rail, rail_inclination=0.0, gauge_depth=5.5e-3, **parameters
    )


@pytest.mark.parametrize("normal", NORMAL)
def test_all_patches_of_a_wheel_have_creep_forces(normal):
    """Also the fourth, which is not reported: it slips as the others do, and the sums include it."""
    stepper = bumpy_system(normal_model=normal, tangential_model="strips").stepper()
    given = {"lateral_shift": 0.5e-3, "normal_force": LOAD, **MOTION}
    stepper.inputs[:] = [given.get(row.keyword, row.start) for row in INPUTS]
    assert stepper.step() == 0
    work, state = work_of(stepper), wrcontact.WheelsetState(stepper.outputs, 0, stepper.inputs)
    for side, found in zip(work.sides, (state.left, state.right)):
        assert side.patch_count == found.patch_count == 4 and len(found.patches) == 3
        patches = side.patches[:4]
        fourth = next(patch for patch in patches if patch.rank == 4)
        assert fourth.totals.load > 0.02 * LOAD and 0.1 < fourth.saturation <= 1.0
        assert np.hypot(fourth.creep_x, fourth.creep_y) == pytest.approx(
            fourth.saturation * 0.3 * fourth.totals.load
        )
        assert found.force.x == pytest.approx(sum(patch.creep_x for patch in patches), rel=1e-12)
        assert found.friction_power == pytest.approx(
            sum(patch.forces.friction_power for patch in patches), rel=1e-12
        )
        assert found.friction_power > 1.01 * sum(patch.friction_power for patch in found.patches)
        assert found.normal_force == pytest.approx(sum(patch.totals.load for patch in patches), rel=1e-12)
        for axis in range(3):
            for name, out in (("force", found.force), ("moment", found.moment)):
                total = sum(getattr(patch.forces, name)[axis] for patch in patches)
                assert abs(np.asarray(out)[axis]) == pytest.approx(abs(total), rel=1e-12, abs=1e-9)
