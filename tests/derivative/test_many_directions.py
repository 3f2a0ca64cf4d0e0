"""Derivatives in Python: along many inputs in one pass those of one direction at a time, and of differences;
what is refused."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.cases import CREEP_MODELS
from tests.helpers.derivatives import poses
from tests.helpers.inside import solver_of
from wrcontact.kernel.binding.library import Kernel, default_kernel
from wrcontact.kernel.layout import INPUT_COUNT
from wrcontact.stepper import Stepper

pytestmark = pytest.mark.skipif(
    not default_kernel().compiled,
    reason="the derivatives are those of the compiled library, and none is here",
)
FORCES = ["force.x", "force.y", "force.z", "moment.x", "moment.y", "moment.z"]
MOTION = [
    "lateral_shift",
    "vertical_shift_input",
    "roll_input",
    "yaw",
    "lateral_velocity",
    "vertical_velocity",
    "roll_rate",
    "yaw_rate",
    "wheel_rate",
]
#: Steps of differences [of an input's usual size].
STEPS = (1e-8, 3e-8, 1e-7, 3e-7, 1e-6, 3e-6, 1e-5, 1e-4)
SIZES = dict(zip(MOTION, (1e-3, 1e-3, 1e-3, 1e-2, 0.01, 0.01, 0.01, 0.1, 20.0)))
COMPLIANT = {"contact_mode": "compliant", "contact_damping": 1.0}
CASES = [
    {"contact_mode": mode, "normal_model": normal, "tangential_model": creep, **more}
    for mode in ("rigid", "elastic", "compliant")
    for normal, creep, more in (
        ("analyn", "none", {}),
        *(("analyn", creep, {}) for creep in CREEP_MODELS),
        ("hertz", "strips", {}),
        ("analyn_strip", "strips", {}),
        ("analyn", "strips", {"separation": "vertical", "stations": 61}),
        ("analyn", "strips", {"separation": "equidistant_chord"}),
        ("analyn", "polach", {"lateral_curvature": "rough", "load": "vertical"}),
    )
]


def running(parameters, count, seed):
    """A stepper, and inputs (count, n) of poses with motion and friction."""
    stepper = wrcontact.ContactSystem(**parameters).stepper()
    rows = poses(count, seed, parameters["contact_mode"])
    rng = np.random.default_rng(seed)
    given = {"speed": 20.0, "free_rolling": 1.0, "left.friction": 0.35, "right.friction": 0.25}
    for name, value in given.items():
        rows[:, stepper.place(name)] = value
    for name in MOTION[4:]:
        rows[:, stepper.place(name)] = SIZES[name] * rng.uniform(-1.0, 1.0, count)
    rows[:, stepper.place("wheel_rate")] = 20.0 / 0.46 * (1.0 + rng.normal(scale=2e-3, size=count))
    return stepper, rows


@pytest.mark.parametrize("case", range(len(CASES)))
def test_many_directions_are_single_ones(case):
    """All inputs at once, in three passes; what the memory of a pass held before does not count."""
    stepper, rows = running(CASES[case], 2, 5)
    solver = solver_of(stepper)
    for row, held in zip(rows, (0.0, np.nan)):
        stepper.inputs[:] = row
        assert stepper.step() <= wrcontact.Status.UNLOADED, row.tolist()
        before = stepper.outputs.copy()
        _, rates = solver.derivatives(np.eye(INPUT_COUNT))
        solver._wide_room[:] = held
        _, again = solver.derivatives(np.eye(INPUT_COUNT))
        assert np.array_equal(rates, again), row.tolist()
        single = np.array([solver.derivative(seed)[1] for seed in np.eye(INPUT_COUNT)])
        size = np.abs(single).max(axis=1, keepdims=True) + 1e-300
        assert np.abs(rates - single).max(initial=0.0, where=single == 0.0) <= 1e-9 * size.max(), row.tolist()
        # rounding: a wheel whose yaw begins is placed as a yawed one for all directions at once
        assert (np.abs(rates - single) <= 1e-7 * np.abs(single) + 1e-9 * size).all(), row.tolist()
        assert np.array_equal(stepper.outputs, before) and np.array_equal(stepper.inputs, row)


def misses(stepper, row):
    """How far the derivatives of the forces by the motion are from the nearest central difference, and from
    the nearest one to one side, (6, 9), of their size."""
    stepper.inputs[:] = row
    stepper.step()
    rates, middle = stepper.derivatives(FORCES, MOTION), np.array([*stepper.force, *stepper.moment])
    central, single = np.full((2, *rates.shape), np.inf)
    for column, name in enumerate(MOTION):
        size = np.maximum(np.abs(rates[:, column]), 0.05 * 1e5 / (100.0 * SIZES[name]))
        for step in np.array(STEPS) * SIZES[name]:
            sides = []
            for way in (1.0, -1.0):
                stepper.inputs[:] = row
                stepper.inputs[stepper.place(name)] += way * step
                stepper.step()
                sides.append(way * (np.array([*stepper.force, *stepper.moment]) - middle) / step)
            off = [np.abs(side - rates[:, column]) / size for side in sides]
            central[:, column] = np.fmin(
                central[:, column], np.abs(0.5 * (sides[0] + sides[1]) - rates[:, column]) / size
            )
            single[:, column] = np.fmin(single[:, column], np.fmin(*off))
    return central, single


@pytest.mark.parametrize("model", ["none", *CREEP_MODELS])
def test_forces_by_motion_against_differences(model):
    """Half of all within 1e-7 of a difference, 99 % within 1e-5; what is beyond has a kink there, and is the
    rate on one of its sides."""
    stepper, rows = running(COMPLIANT | {"tangential_model": model}, 12, 8)
    found = np.array([misses(stepper, row) for row in rows])
    central, single = found[:, 0], found[:, 1]
    assert np.isfinite(central).all()
    assert np.median(central) < 1e-7 and np.quantile(central, 0.99) < 1e-5
    for k in np.argwhere(central > 1e-5):
        assert single[tuple(k)] < 1e-3, f"{FORCES[k[1]]} by {MOTION[k[2]]} at {rows[k[0]].tolist()}"


def test_a_system_has_them_by_keyword():
    system = wrcontact.ContactSystem(contact_mode="elastic", tangential_model="strips")
    pose = {"lateral_shift": 2e-3, "yaw": 3e-3, "speed": 20.0, "wheel_rate": 43.4, "left_friction": 0.2}
    of, by = ["right.area", "roll", "driving_torque"], ["lateral_shift", "left.friction"]
    found = system.derivatives(of=of, by=by, **pose)
    assert found.shape == (3, 2)
    for column, (name, step) in enumerate((("lateral_shift", 1e-7), ("left_friction", 1e-5))):
        high, low = (system.evaluate(**{**pose, name: pose[name] + way * step}) for way in (1, -1))
        wanted = np.array([(high[output] - low[output]) / (2 * step) for output in of])
        np.testing.assert_allclose(found[:, column], wanted, rtol=1e-5, atol=1e-6 * np.abs(wanted).max())


def test_the_equilibrium_has_derivatives():
    """As those of the elastic wheelset that stands there; nothing else moves it."""
    pose = {"lateral_shift": 2e-3, "yaw": 3e-3}
    compliant, elastic = (wrcontact.ContactSystem(contact_mode=mode) for mode in ("compliant", "elastic"))
    of = ["equilibrium.roll", "force.y", "equilibrium.vertical_shift"]
    by = ["lateral_shift", "yaw", "roll_input"]
    found = compliant.derivatives(of, by, **pose)
    wanted = elastic.derivatives(["roll", "vertical_shift"], by, **pose)
    assert np.array_equal(found[[0, 2]], wanted) and not wanted[:, 2].any() and wanted[:, :2].all()
    assert np.array_equal(found[1], compliant.derivatives(["force.y"], by, **pose)[0])
    assert np.array_equal(elastic.derivatives(of[:1], by, **pose)[0], wanted[0])


def test_no_derivatives_off_the_profile():
    found = wrcontact.ContactSystem().derivatives(["roll", "force.y"], ["yaw"], lateral_shift=0.02)
    assert found.shape == (2, 1) and np.isnan(found).all()


@pytest.mark.parametrize(
    "of, by, words",
    [
        (["force.yy"], ["yaw"], "did you mean force.y"),
        (["force.y"], ["yow"], "did you mean yaw"),
        ("force.y", ["yaw"], "list of names"),
        (["force.y"], "yaw", "list of names"),
        (["right.patch_count"], ["yaw"], "count"),
        (["force.y"], ["free_rolling"], "true or false"),
        (["right.shear[1]"], ["yaw"], "outputs='all'"),
        (["left.area"], ["yaw"], "side='left'"),
        (["equilibrium.roll"], ["yaw"], "names of outputs"),
    ],
)
def test_what_a_stepper_refuses(of, by, words):
    with pytest.raises(ValueError, match=words):
        wrcontact.ContactSystem().stepper(side="right", outputs="patches").derivatives(of, by)


def test_models_outside_the_compiled_kernel_have_none():
    tables = wrcontact.ContactSystem().stepper().tables
    source = Stepper(tables)
    source._bound = Kernel().bind(
        tables, source.state, np.zeros_like(source._workspace), source.inputs, source.outputs
    )
    with pytest.raises(RuntimeError, match="uncompiled"):
        source.derivatives(["roll"], ["yaw"])
    with pytest.raises(RuntimeError, match="half-space"):
        wrcontact.ContactSystem(tangential_model="halfspace").derivatives(["roll"], ["yaw"])
