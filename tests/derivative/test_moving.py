"""Directional derivatives of a wheelset that moves and rubs over rails that are displaced and move, also with
different sides: positions, creepages, damped forces and creep forces, against central differences of its
steps."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.cases import CREEP_MODELS, input_row
from tests.helpers.derivatives import NAMES, NOMINAL, stepped
from tests.helpers.inside import rates_along
from wrcontact.interface.variables import BOOLEAN, INPUT, VARIABLES
from wrcontact.kernel.binding.library import default_kernel

pytestmark = pytest.mark.skipif(
    not default_kernel().compiled,
    reason="the derivatives are those of the compiled library, and none is here",
)
INPUTS = [v for v in VARIABLES if v.causality == INPUT]
STEPS = (1e-5, 1e-4, 3e-4, 1e-3)  # [of an input's nominal value]; one of them is to be met
#: Where it stands and touches, what it carries, and how it slips.
CREEPAGES = np.array(
    [
        name.endswith(
            (
                "roll",
                "vertical_shift",
                "contact_angle",
                "rolling_radius",
                "area",
                "penetration",
                "max_pressure",
                "force.y",
                "force.z",
                "moment.x",
            )
        )
        or ".contact." in name
        or ".creepage." in name
        for name in NAMES
    ]
)
DAMPED = np.array([name.endswith(("normal_force", "force.y", "force.z", "moment.x")) for name in NAMES])
#: Shares of stick jump from point to point of a strip, and runs over the outline follow them.
SMOOTH = np.array(
    [
        name.endswith(
            (
                ".force.x",
                ".force.y",
                ".force.z",
                ".moment.x",
                ".moment.y",
                ".moment.z",
                "driving_torque",
                "tangential.x",
                "tangential.y",
                "tangential.moment",
                "friction_power",
                "saturation",
                "wear_number",
            )
        )
        for name in NAMES
    ]
)
MOTION = {
    "speed": 25.0,
    "lateral_velocity": 0.04,
    "vertical_velocity": -0.02,
    "yaw_rate": 0.05,
    "roll_rate": 0.03,
    "wheel_rate": 54.0,
    "track_curvature": 2e-3,
    "left.rail_lateral_velocity": 0.01,
    "right.rail_vertical_velocity": 0.02,
    "right.rail_roll_velocity": -0.03,
    "left.rail_roll": 0.004,
    "right.rail_roll": -0.006,
    "left.rail_lateral": -1e-3,
    "right.rail_vertical": 2e-3,
}
ROLLING_CONTACT = {name: value for name, value in MOTION.items() if "rail" not in name} | {
    "wheel_rate": 54.3,
    "track_curvature": 1e-3,
    "left.friction": 0.35,
    "right.friction": 0.25,
}
TWO_SIDES = {
    "wheel": ("S1002", "cone20"),
    "rail": ("60E1", "54E1"),
    "nominal_radius": (0.4615, 0.459),
    "rail_inclination": (0.0, 1 / 40),
}
DAMPING = {"contact_mode": "compliant", "contact_damping": 0.5}


def moving_row(parameters, motion, shift, yaw):
    """Inputs of a pose with ``motion`` by name; a compliant wheelset stands as an elastic one does."""
    row = input_row(shift, yaw, 0.0, 78.5e3)
    for place, variable in enumerate(INPUTS):
        row[place] = motion.get(variable.name, row[place])
    if parameters.get("contact_mode") == "compliant":
        rails = {
            name.replace(".", "_"): value
            for name, value in motion.items()
            if ".rail_" in name and not name.endswith("velocity")
        }
        elastic = wrcontact.ContactSystem(**parameters | {"contact_mode": "elastic"})
        stand = elastic.evaluate(shift, yaw, **rails)
        row[5:7] = stand.vertical_shift, stand.roll
    return row


def assert_met(stepper, row, of, allowed, floor, left_out=()):
    """Rates of the outputs ``of`` along every input but those left out, a switch, which has none, and the
    guess, which does not count, are near one of the differences: to ``allowed`` of the rate, or of ``floor``
    times the nominal one."""
    for place, variable in enumerate(INPUTS):
        if variable.type == BOOLEAN or variable.name in ("roll_guess", "rail_time_step", *left_out):
            continue
        along = np.eye(len(row))[place]
        assert stepped(stepper, row)[0] == 0
        rates, off = rates_along(stepper, along), np.inf
        for step in np.array(STEPS) * variable.nominal:
            (good, high), (well, low) = (stepped(stepper, row + way * step * along) for way in (1, -1))
            assert good == well == 0
            off = np.minimum(off, np.abs(rates - (high - low) / (2 * step)))
        off = np.where(of, off / np.maximum(np.abs(rates), floor * NOMINAL / variable.nominal), 0.0)
        assert off.max() < allowed, f"d {NAMES[off.argmax()]} / d {variable.name}: {off.max():.2g}"


@pytest.mark.parametrize("shift, yaw", [(1.1e-3, 0.0), (-3e-3, 0.004), (3.3e-3, -0.01)])
@pytest.mark.parametrize(
    "parameters, of",
    [
        ({"normal_model": "hertz"}, CREEPAGES),
        ({}, CREEPAGES),
        ({"contact_mode": "elastic"}, CREEPAGES),
        (DAMPING, CREEPAGES | DAMPED),
        (TWO_SIDES, CREEPAGES),
        (TWO_SIDES | {"contact_mode": "elastic", "normal_model": "hertz"}, CREEPAGES),
    ],
    ids=["hertz", "rigid", "elastic", "compliant", "two sides", "two sides, elastic"],
)
def test_derivatives_of_creepages_and_damped_forces(parameters, of, shift, yaw):
    row = moving_row(parameters, MOTION, shift, yaw)
    assert_met(
        wrcontact.ContactSystem(**parameters).stepper(),
        row,
        of,
        2e-5,
        0.02,
        left_out=("normal_force", "load_transfer"),
    )


PARAMETERS = {
    "rigid": {},
    "elastic": {"contact_mode": "elastic"},
    "compliant": DAMPING,
    "vertical": {"load": "vertical"},
    "elastic vertical": {"load": "vertical", "contact_mode": "elastic"},
    "falling friction": {
        "friction_fall": 0.4,
        "friction_fall_rate": 0.6,
        "flange_friction_ratio": 0.5,
        "slope_reduction": 0.6,
        "slope_reduction_rate": 0.6,
    },
}
#: Steps of tangential models [of an input's nominal value]: kinks and roots without a slope are close.
CLOSE = (1e-8, 1e-7, 1e-6, 1e-5, 1e-4)
#: 99 % of all derivatives are so near to a central difference, of their size or of a twentieth of the nominal
#: one: what differences are good for, which near the many edges of FaStrip's stick zones is less.  Measured
#: are 2e-8 to 3e-7; with vertical loads, which are met to 1e-9, 1.1e-6 for fastsim and strips; for fastrip at
#: most 3e-6.
MOST = {"polach": 1e-6, "strips": 1.5e-6, "fastsim": 2e-6, "fastrip": 5e-6}
#: Velocities of an elastic wheelset are found to a hundred-thousandth of how fast it moves and are
#: differences themselves; 5.8e-6 is measured.
ELASTIC_MOST = 7e-6
#: What is beyond this has a kink within the steps; elsewhere rounding leaves less over the smallest steps.
KINK = 1e-4
#: Cases that each run of the tests has; the others are full.
QUICK = ("rigid", "elastic vertical", "falling friction")


def misses(stepper, row):
    """How far rates of the smooth outputs along all inputs are from the nearest of the central differences,
    and from the nearest of those to one side, (2, n), of their size."""
    found = []
    for place, variable in enumerate(INPUTS):
        if variable.type == BOOLEAN or variable.name == "roll_guess":
            continue
        along = np.eye(len(row))[place]
        assert stepped(stepper, row)[0] == 0
        rates, middle = rates_along(stepper, along), stepper.outputs.copy()
        size = np.maximum(np.abs(rates), 0.05 * NOMINAL / variable.nominal)
        central, single = np.inf, np.inf
        for step in np.array(CLOSE) * variable.nominal:
            ahead, behind = (
                way * (stepped(stepper, row + way * step * along)[1] - middle) / step for way in (1, -1)
            )
            central = np.fmin(central, np.abs(0.5 * (ahead + behind) - rates) / size)
            single = np.fmin(single, np.fmin(np.abs(ahead - rates), np.abs(behind - rates)) / size)
        found.append(np.array([central, single])[:, SMOOTH])
    return np.hstack(found)


def assert_kinks_alone(most, central, single):
    """Nearly all rates are those of central differences; each of the others is the rate on one side of a
    kink, where both sides have their own."""
    assert np.isfinite(central).all()
    assert np.quantile(central, 0.99) < most
    # one-sided differences are good to the curvature, which is large beside a kink, times the smallest step:
    # 1.5e-3 measured for polach
    assert (single[central > KINK] < 2e-3).all(), single[central > KINK].max()


@pytest.mark.parametrize(
    "case, model",
    [
        (case, model)
        if case == "rigid" or case in QUICK and model == "strips"
        else pytest.param(case, model, marks=pytest.mark.full)
        for case in PARAMETERS
        for model in CREEP_MODELS
    ],
)
def test_derivatives_of_creep_forces(case, model):
    stepper = wrcontact.ContactSystem(**PARAMETERS[case], tangential_model=model).stepper()
    poses = ((1.1e-3, 0.0), (-3e-3, 0.004), (3.3e-3, -0.003))
    most = max(MOST[model], ELASTIC_MOST) if "elastic" in case else MOST[model]
    assert_kinks_alone(
        most,
        *np.hstack([misses(stepper, moving_row(PARAMETERS[case], ROLLING_CONTACT, *pose)) for pose in poses]),
    )


def test_derivatives_by_velocities_of_an_elastic_wheelset_that_begins_to_move():
    """Its velocities are proportional to the inputs', depth included, and so are what it has none of yet."""
    names = [name for name in MOTION if "velocity" in name or name == "yaw_rate"]
    motion = {name: value for name, value in MOTION.items() if name not in (*names, "roll_rate")}
    row = moving_row({"contact_mode": "elastic"}, motion, 4.4e-3, 4e-3)
    assert_met(
        wrcontact.ContactSystem(contact_mode="elastic").stepper(),
        row,
        CREEPAGES,
        1e-5,
        0.02,
        left_out=[v.name for v in INPUTS if v.name not in names],
    )


@pytest.mark.full
@pytest.mark.parametrize("model", CREEP_MODELS)
def test_derivatives_of_creep_forces_at_random_poses(model):
    """With friction and creepages of any size, so that some poses lie beside kinks."""
    stepper, rng = wrcontact.ContactSystem(tangential_model=model).stepper(), np.random.default_rng(8)
    found = []
    for _ in range(12):
        motion = {
            name: value * rng.uniform(-1.0, 1.0) if name not in ("speed", "wheel_rate") else value
            for name, value in ROLLING_CONTACT.items()
        }
        motion |= {
            "wheel_rate": 54.3 * (1.0 + rng.normal(scale=2e-3)),
            "left.friction": rng.uniform(0.05, 0.5),
            "right.friction": rng.uniform(0.05, 0.5),
        }
        found.append(
            misses(stepper, moving_row({}, motion, rng.uniform(-5e-3, 5e-3), rng.uniform(-5e-3, 5e-3)))
        )
    assert_kinks_alone(MOST[model], *np.hstack(found))
