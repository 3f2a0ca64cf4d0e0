"""Hertz's ellipse is no wider than wheel and rail.

In the flange root of S1002 (a radius of 13 mm) the corner of UIC60 (13 mm) rolls: the lateral curvature at
the contact point is zero, and the ellipse of its least value would be 102 mm wide.
"""

from math import radians

import numpy as np
import pytest
from scipy.optimize import brentq

import wrcontact
from data.hertz import hertz
from tests.helpers.cases import CREEP_MODELS
from tests.helpers.derivatives import AGREE, CONTINUOUS, derivative, differences, scale
from wrcontact.interface.inputs import INPUTS
from wrcontact.kernel import layout

FORCE = 78.5e3
#: Radius of the rail's corner [m], and the inclination at which the kernel lets the profile end [rad]
#: (STEEPEST in kernel/prepare/zones.py).
CORNER, END = 13e-3, radians(80.0)
#: Lateral shifts at which the wheel's root lies on the rail's corner [m].
ROOT = (6.29e-3, 6.295e-3, 6.30e-3)


def compliant(state, **parameters):
    """A compliant wheelset that stands as an elastic one, and its inputs."""
    system = wrcontact.ContactSystem(contact_mode="compliant", normal_model="hertz", **parameters)
    return system, {
        "lateral_shift": state.inputs[0],
        "vertical_shift_input": state.vertical_shift,
        "roll_input": state.roll,
    }


@pytest.mark.parametrize("shift", ROOT)
def test_an_ellipse_ends_where_the_rail_does(shift):
    """With penetration, length and pressure of Hertz's ellipse of this width, by scipy; elastic, and at the
    same penetration compliant."""
    elastic = wrcontact.ContactSystem(contact_mode="elastic", normal_model="hertz").evaluate(shift)
    system, given = compliant(elastic)
    for wheel in (elastic.right, system.evaluate(**given).right):
        patch, A = wheel.patches[0], 0.5 * wheel.curvature_x
        # 1e-8 m is the error of the table of arcs
        half_width = CORNER * (END - patch.contact_angle)
        assert patch.width == pytest.approx(2.0 * half_width, abs=1e-7)
        B = np.exp(
            brentq(
                lambda B: np.log(hertz(A, np.exp(B), FORCE)[2] / half_width),
                np.log(1e-3 * A),
                np.log(1e2 * A),
                xtol=1e-13,
            )
        )
        penetration, half_length, _, pressure = hertz(A, B, FORCE)
        assert B > 2.0 * 0.5 * wheel.curvature_y
        # d penetration / d half_width = -penetration / half_width: 1e-5 of both
        assert wheel.normal_force == pytest.approx(FORCE, rel=1e-5)
        assert wheel.penetration == pytest.approx(penetration, rel=1e-5)
        assert patch.length == pytest.approx(2.0 * half_length, rel=1e-5)
        assert patch.max_pressure == pytest.approx(pressure, rel=1e-5)


@pytest.mark.parametrize("mode", ("elastic", "compliant"))
def test_derivatives_follow_the_end_of_the_rail(mode):
    shift = ROOT[0]
    elastic = wrcontact.ContactSystem(contact_mode="elastic", normal_model="hertz")
    system, given = elastic, {"lateral_shift": shift}
    if mode == "compliant":
        system, given = compliant(elastic.evaluate(shift))
    stepper = system.stepper()
    row = np.array([given.get(variable.keyword, variable.start) for variable in INPUTS], float)
    for number in (layout.IN_LATERAL_SHIFT, layout.IN_YAW, layout.IN_VERTICAL_SHIFT, layout.IN_ROLL):
        status, rates = derivative(stepper, row, number)
        wanted, apart, near = differences(stepper, row, number)
        size = scale(rates, number)
        clear = (apart / size < AGREE)[CONTINUOUS]
        assert status == 0 and clear.mean() > 0.9
        assert (np.abs(rates - wanted) / size)[CONTINUOUS][clear].max() < AGREE


#: A flange over a rolled rail under a usual load: an ellipse of 127 mm, with -15 kW and then 13 GW of
#: friction.
FLANGE = {
    "lateral_shift": 6.5715e-3,
    "speed": 20.0,
    "normal_force": 90.2e3,
    "load_transfer": 0.688,
    "lateral_velocity": -0.017,
    "yaw_rate": 0.062,
    "left_friction": 0.3,
    "right_friction": 0.3,
    "right_rail_roll": 0.0026,
    "right_rail_vertical": 0.002,
    "left_rail_roll": -0.0012,
    "left_rail_vertical": 0.0011,
}


@pytest.mark.parametrize("model", CREEP_MODELS)
def test_friction_takes_no_more_than_it_can(model):
    """At a contact angle of 0.8 rad places 6 mm apart differ by 1 % in rolling radius."""
    state = wrcontact.ContactSystem(
        contact_mode="elastic", normal_model="hertz", tangential_model=model
    ).evaluate(**FLANGE)
    patch = state.right.patches[0]
    assert state.status == 0 and patch.width < 20e-3
    assert 0.0 < patch.friction_power < 0.05 * 0.3 * patch.normal_force * FLANGE["speed"]
