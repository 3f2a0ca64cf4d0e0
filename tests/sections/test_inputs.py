"""Every input on rails and wheels that change along the track or around, and on rollers: used as on the constant rail, or refused."""

from functools import cache

import pytest

from tests.helpers.sections import moved, stepped
from wrcontact import ContactSystem, WheelSections
from wrcontact.interface.inputs import INPUTS
from wrcontact.profiles import standard_profile

#: A large roller is a rail: its curvature is 2e-3 of the wheel's relative one.
LARGE = 1000.0
KINDS = {
    "rail": lambda: {"rail": moved([0.0, 0.5])},
    "wheel": lambda: {"wheel": WheelSections.polygon(standard_profile("S1002"), 3, 0.0)},
    "roller": lambda: {"roller_radius": LARGE},
}
#: Inputs that are refused, and those that are on rollers; along a roller its height changes.
REFUSED = {f"{side}.rail_{part}" for side in ("left", "right") for part in ("roll", "roll_velocity")}
OF_A_TRACK, HEIGHT_CHANGES = {"track_curvature"}, {"track_position"}
#: Values where a tenth of the nominal one, beside that of the pose, would change little, or lift a wheel.
VALUES = {"free_rolling": 0.0, "left.friction": 0.12, "right.friction": 0.2, "track_position": 0.1}
VALUES |= {name: 43.0 for name in ("wheel_rate", "left.wheel_rate", "right.wheel_rate")}
VALUES |= {f"{side}.rail_vertical": -1e-4 for side in ("left", "right")}
#: Of loads near 80 kN [N], and of their moments about the track's centre [N m], one in a million.
FORCE = 0.08
POSES = {2e-3: 5e-3, -5.3e-3: -4e-3}


@cache
def systems(kind, mode):
    """Steppers of constant wheels and rails, and of the kind."""
    given = dict(
        contact_mode=mode,
        contact_damping=0.3 if mode == "compliant" else 0.0,
        rail_inclination=0.0,
        tangential_model="strips",
        fatigue_outputs=True,
    )
    return ContactSystem(**given).stepper(), ContactSystem(**given, **KINDS[kind]()).stepper()


@cache
def pose(shift, mode):
    """A pose by its inputs; in compliant contact both wheels are pressed by 90 um."""
    inputs = dict(lateral_shift=shift, yaw=POSES[shift], speed=20.0, lateral_velocity=0.02, yaw_rate=0.02)
    if mode == "compliant":
        touching = ContactSystem(rail_inclination=0.0).evaluate(lateral_shift=shift, yaw=POSES[shift])
        inputs |= {"vertical_shift_input": touching.vertical_shift + 9e-5, "roll_input": touching.roll}
    return inputs


def nearness(name, value, kind):
    """How near an output of a kind has to be to that of constant wheels and rails; None: it is not compared."""
    loaded = any(part in name for part in ("force", "moment", "torque"))
    if kind == "roller":
        return 2e-3 * (abs(value) + 80e3) if loaded else None
    if "station" in name or "curvature_y" in name:  # follow second derivatives of a profile to 1e-7
        return None
    if name.endswith("]") or name.endswith("power"):
        return 1e-5 * (abs(value) + 1.0)
    return 1e-6 * abs(value) + (FORCE if loaded else 1e-8)


@pytest.mark.parametrize(
    "kind, mode",
    [
        ("rail", "rigid"),
        *(
            pytest.param(kind, mode, marks=pytest.mark.full)
            for kind in KINDS
            for mode in ("rigid", "compliant", "elastic")
            if (kind, mode) != ("rail", "rigid")
        ),
    ],
)
@pytest.mark.parametrize("shift", POSES)
def test_every_input_is_used_as_on_the_constant_rail_or_refused(kind, mode, shift):
    """One input after the other is changed at a pose."""
    constant, own = systems(kind, mode)
    at = pose(shift, mode)
    for row in INPUTS:
        value = VALUES.get(row.name, at.get(row.name, row.start) + 0.1 * row.nominal)
        inputs = at | {row.name: value}
        status, wanted = stepped(constant, **inputs)
        assert status == 0, inputs
        status, found = stepped(own, **inputs)
        if row.name in REFUSED or (kind == "roller" and row.name in OF_A_TRACK):
            assert status == 4, inputs
            continue
        assert status == 0, inputs
        for name, value in wanted.items():
            near = nearness(name, value, kind)
            if near is not None and not (kind == "roller" and row.name in HEIGHT_CHANGES):
                assert abs(found[name] - value) < near, (name, found[name], value, inputs)
