"""Where a compliant wheelset stands on rails that change along the track, on wheels that are not round and on rollers: against
constant rails, a ramp in closed form, and the loads of the compliant step at that place."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.sections import moved
from wrcontact import ContactSystem, WheelSections

KIND = {"contact_mode": "compliant", "gauge": 1.437}
LOAD, ROLL = 7e4, 1e-4
#: The elastic step meets its load to about 1e-11 of it; a change of 1 N moves a wheel by about 1e-9 m.
HEIGHT, SHARE = 1e-12, 1e-9


def test_it_stands_on_equal_sections_as_on_the_constant_rail():
    system = ContactSystem(rail=(moved([0.0, 0.5]), "UIC60"), rail_inclination=(0.0, 1 / 20), **KIND)
    constant = ContactSystem(rail_inclination=(0.0, 1 / 20), **KIND)
    for pose in ({}, {"lateral_shift": 2e-3, "yaw": 5e-3, "normal_force": LOAD}):
        found = system.evaluate(track_position=0.2, **pose).equilibrium
        expected = constant.evaluate(**pose).equilibrium
        assert found.status == expected.status
        assert found.vertical_shift == pytest.approx(expected.vertical_shift, abs=HEIGHT), pose
        assert found.roll == pytest.approx(expected.roll, abs=HEIGHT), pose
        found = system.stand_at(ROLL, track_position=0.2, **pose)
        expected = constant.stand_at(ROLL, **pose)
        assert found.status == expected.status
        assert found.vertical_shift == pytest.approx(expected.vertical_shift, abs=HEIGHT), pose


@pytest.mark.full
def test_it_rises_with_a_ramp_and_its_loads_are_carried():
    rise = 0.05
    system = ContactSystem(rail=moved(np.linspace(-0.3, 0.3, 7), rise=rise), **KIND)
    low, high = (system.evaluate(track_position=u, normal_force=LOAD).equilibrium for u in (-0.05, 0.05))
    assert (high.vertical_shift - low.vertical_shift) / 0.1 == pytest.approx(-rise, abs=1e-10)
    state = system.evaluate(
        track_position=0.05,
        normal_force=LOAD,
        vertical_shift_input=high.vertical_shift,
        roll_input=high.roll,
    )
    for side in (state.left, state.right):
        assert side.normal_force == pytest.approx(LOAD, rel=SHARE)
    height = system.stand_at(0.0, track_position=0.05, normal_force=LOAD).vertical_shift
    state = system.evaluate(
        track_position=0.05, normal_force=LOAD, vertical_shift_input=height, roll_input=0.0
    )
    # the load of `stand_at` is vertical: the rail also pushes back, by its slope
    assert state.force.z == pytest.approx(-2 * LOAD, rel=SHARE)
    assert state.force.x == pytest.approx(-2 * LOAD * rise, rel=1e-6)


@pytest.mark.full
def test_it_stands_where_a_wheel_or_a_roller_is():
    wheel = WheelSections.eccentric("S1002", 2e-4)
    turned = ContactSystem(wheel=wheel, **KIND)
    places = [turned.evaluate(wheel_rotation=angle).equilibrium for angle in (0.0, np.pi)]
    # the circle's centre goes down and up by the eccentricity; the axle is as much above and below it
    assert places[1].vertical_shift - places[0].vertical_shift == pytest.approx(4e-4, abs=1e-9)
    for system, place in (
        (turned, places[0]),
        (roller := ContactSystem(roller_radius=0.5, **KIND), roller.evaluate().equilibrium),
    ):
        state = system.evaluate(vertical_shift_input=place.vertical_shift, roll_input=place.roll)
        assert state.right.normal_force == pytest.approx(state.inputs.normal_force, rel=SHARE)
        assert state.left.normal_force == pytest.approx(state.inputs.normal_force, rel=SHARE)


def test_where_a_wheel_may_touch_twice_it_stands_nowhere():
    u = np.linspace(-0.1, 0.1, 21)
    down = 3e-4 * np.cos(np.pi * u / 0.02)  # more hollow than the wheel is round
    rail = wrcontact.profiles.standard_profile("UIC60")
    wavy = wrcontact.RailSections(u, [rail] * len(u), places=np.column_stack([0.0 * u, down]))
    system = ContactSystem(rail=wavy, **KIND)
    for place in (system.evaluate().equilibrium, system.stand_at(0.0)):
        assert place.status == 3 and np.isnan(place.vertical_shift)


def test_a_roller_beside_a_rail_that_changes_has_no_elastic_wheelset():
    system = ContactSystem(rail=("UIC60", moved([0.0, 0.5])), left_roller_radius=0.5, **KIND)
    for call in (lambda: system.evaluate().equilibrium, lambda: system.stand_at(0.0)):
        with pytest.raises(
            ValueError, match="elastic' on a roller beside a rail that changes along the track"
        ):
            call()
