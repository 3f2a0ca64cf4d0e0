"""The FMU of the wheelset alone: closed forms of its motion, and what fmpy finds in its description."""

import math

import numpy as np
import pytest
from fmpy import read_model_description
from fmpy.validation import validate_fmu

from examples.hunting_wheelset.coupling import Unit
from examples.hunting_wheelset.wheelset import FORCES, MOTION, PARAMETERS

LOAD = PARAMETERS["load"][0]


def moved(archive, duration, step, forces=None, derivative=None, **parameters):
    """Motion (9,) by name after ``duration`` [s] under constant forces, which carry the load besides."""
    unit = Unit(archive, "wheelset", **parameters)
    unit.start()
    given = dict.fromkeys(FORCES, 0.0) | {"force.y": 0.0, "force.z": -LOAD} | (forces or {})
    unit.ports(given).write(list(given.values()))
    for place, value in (derivative or {}).items():
        unit.ports([place]).write([value])
    ports = unit.ports(MOTION)
    for k in range(round(duration / step)):
        unit.step(k * step, step)
    values = dict(zip(MOTION, ports.read()))
    unit.close()
    return values


def test_description(archives):
    """Units have the SI exponents of the contact FMU's, so that masters see them fit."""
    assert validate_fmu(str(archives[1])) == []
    contact, wheelset = (
        {unit.name: str(unit.baseUnit) for unit in described.unitDefinitions}
        for described in map(read_model_description, map(str, archives))
    )
    assert {"m", "rad", "N", "N.m", "m/s", "rad/s", "1/m", "W"} <= set(contact) & set(wheelset)
    assert {name: wheelset[name] for name in set(contact) & set(wheelset)} == {
        name: contact[name] for name in set(contact) & set(wheelset)
    }


def test_outputs_depend_on_no_input(archives):
    """As declared, so that a master finds no loop: inputs change no output before a step."""
    described = read_model_description(str(archives[1]))
    assert [unknown.dependencies for unknown in described.outputs] == [[]] * 14
    known = [v for unknown in described.initialUnknowns for v in unknown.dependencies]
    assert {v.causality for v in known} == {"parameter"}
    unit = Unit(archives[1], "wheelset", lateral_stiffness=1e5, lateral_damping=1e3, start_lateral_shift=1e-3)
    unit.start()
    inputs = [v.name for v in described.modelVariables if v.causality == "input"]
    outputs = unit.ports([unknown.variable.name for unknown in described.outputs])
    before = outputs.read()
    unit.ports(inputs).write([1e3 + k for k in range(len(inputs))])
    assert outputs.read() == before
    unit.step(0.0, 1e-4)
    assert outputs.read() != before
    unit.close()


@pytest.mark.parametrize("linear, order", [(False, 1), (True, 2)])
def test_swings_on_its_springs(archives, linear, order):
    """y = y0 cos(w t) of an undamped spring, by both methods and with their orders. A derivative of the
    torque by a yaw that stays zero changes nothing but the method."""
    boxes, mass, start = 4e5, 1500.0, 1e-3
    frequency = math.sqrt(2 * boxes / mass)
    errors = []
    for step in (1e-3, 5e-4):
        found = moved(
            archives[1],
            0.2,
            step,
            lateral_stiffness=boxes,
            start_lateral_shift=start,
            derivative={"derivative[6,4]": 1.0} if linear else None,
        )
        errors.append(abs(found["lateral_shift"] - start * math.cos(0.2 * frequency)))
    assert math.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.1)
    assert errors[1] < (1e-2 if not linear else 1e-4) * start


def test_a_given_derivative_acts_like_a_spring(archives):
    """A contact whose lateral force falls with the shift is a spring of this stiffness; its force is that at
    the beginning of the step, which here stays zero though the wheelset is aside."""
    stiffness, speed, mass = 8e5, 0.01, 1500.0
    found = moved(
        archives[1], 1e-2, 1e-2, start_lateral_velocity=speed, derivative={"derivative[1,1]": -stiffness}
    )
    # one step of the trapezoidal rule, from y = 0: v1 (1 + h^2 k / 4m) = v0 (1 - h^2 k / 4m)
    share = 1e-4 * stiffness / (4 * mass)
    assert found["lateral_velocity"] == pytest.approx(speed * (1 - share) / (1 + share), rel=1e-12)


def test_a_spinning_wheelset_nutates(archives):
    """Roll and yaw of a free gyroscope turn into each other with I_y w / I."""
    speed, radius, pitch, inertia = 46.0, 0.46, 120.0, 900.0
    rate = pitch * speed / radius / inertia
    push = 10.0
    found = moved(archives[1], 0.1, 1e-4, {"moment.x": push}, frame_speed=speed)
    # roll rate = (M / I rate) sin(rate t), yaw rate = (M / I rate) (1 - cos(rate t))
    assert found["roll_rate"] == pytest.approx(push / inertia / rate * math.sin(0.1 * rate), rel=2e-3)
    assert found["yaw_rate"] == pytest.approx(push / inertia / rate * (1 - math.cos(0.1 * rate)), rel=2e-3)


def test_curve(archives):
    """Half-way through the transition the curvature is half of the curve's; nothing canted, and nothing else
    acting, the load leaves the curve with the square of the speed times the curvature."""
    given = dict(frame_speed=10.0, curve_curvature=0.01, curve_start=1.0, transition_length=2.0, canted=0.0)
    unit = Unit(archives[1], "wheelset", **given)
    unit.start()
    unit.ports(["force.z"]).write([-LOAD])
    ports, seen = unit.ports(["distance", "track_curvature", "lateral_velocity"]), []
    for k in range(500):
        unit.step(k * 1e-3, 1e-3)
        seen.append(ports.read())
    unit.close()
    way, curvature, velocity = np.array(seen).T
    np.testing.assert_allclose(curvature, 0.01 * np.clip((way - 1.0) / 2.0, 0.0, 1.0), rtol=0, atol=1e-12)
    # the integral of V^2 k: 0.1 s of the mean, and then 0.2 s of the full curvature
    assert velocity[-1] == pytest.approx(-100.0 * 0.01 * (0.1 + 0.2) * LOAD / 9.81 / 1500.0, rel=5e-3)
