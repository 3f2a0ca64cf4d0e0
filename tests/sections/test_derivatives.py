"""Derivatives on rails that change along the track, wheels that are not round and rollers: against exact ones, and closed forms."""

import numpy as np
import pytest

from tests.helpers.changing import CROWN, RAIL, head, on_its_own
from tests.helpers.sections import moved
from wrcontact import ContactSystem, Profile, RailSections, WheelSections
from wrcontact.profiles import standard_profile
from wrcontact.profiles.zones import Polynomial

OF = ["roll", "force.y", "right.penetration", "right.patch[1].tangential.y"]
BY = ["lateral_shift", "yaw", "normal_force", "speed", "yaw_rate", "right.friction", "right.rail_lateral"]
POSE = dict(lateral_shift=2e-3, yaw=4e-3, speed=20.0, yaw_rate=0.02, lateral_velocity=0.02)


@pytest.mark.parametrize("mode", ["rigid", pytest.param("elastic", marks=pytest.mark.full)])
def test_on_equal_sections_they_are_the_exact_ones_of_the_constant_rail(mode):
    """Within 2e-4 of each, and 1e-7 of the largest of an output; nothing changes with the position along the track."""
    given = dict(contact_mode=mode, tangential_model="strips", rail_inclination=0.0)
    exact = ContactSystem(**given).derivatives(OF, BY, **POSE)
    found = ContactSystem(**given, rail=moved([0.0, 0.5])).derivatives(OF, [*BY, "track_position"], **POSE)
    for k, name in enumerate(OF):
        for m, by in enumerate(BY):
            near = pytest.approx(exact[k, m], rel=2e-4, abs=1e-7 * np.abs(exact[k]).max())
            assert found[k, m] == near, (name, by)
    assert np.abs(found[:, -1]).max() < 1e-3 * np.abs(exact).max()


@pytest.mark.full
def test_a_ramp_lifts_the_wheelset_as_it_goes_on():
    """By its slope, and it does not roll."""
    rise = 0.05
    u = np.linspace(-0.4, 0.4, 9)
    ramp = RailSections(u, [RAIL] * 9, places=np.column_stack([0.0 * u, -rise * u]))
    system = ContactSystem(rail=ramp, rail_inclination=0.0)
    found = system.derivatives(["vertical_shift", "roll"], ["track_position"])
    assert found[:, 0] == pytest.approx([-rise, 0.0], abs=1e-7)


@pytest.mark.full
def test_an_eccentric_wheel_falls_and_rises_as_it_turns():
    """The drop of the centre of a circle with the eccentricity e is -e cos(chi)."""
    cylinder = Profile("cylinder", "wheel", (Polynomial(-60.0, 60.0, (0.0,)),))
    eccentric = WheelSections.eccentric(cylinder, 2e-4)
    system = on_its_own(eccentric, RailSections([-1.0, 1.0], [head()] * 2), normal_model="hertz")
    for chi in (0.4, 2.0):
        pose = {"vertical_shift_input": 3e-4, "wheel_rotation": chi, "track_position": 0.0}
        by = ["wheel_rotation", "vertical_shift_input"]
        found = system.derivatives(["right.penetration"], by, **pose)[0]
        assert found[0] / found[1] == pytest.approx(-2e-4 * np.sin(chi), rel=1e-3), chi
    assert system.parameters["rail_origin_y"] == CROWN


def test_they_are_none_where_a_step_fails_or_they_jump():
    """A lifted wheel comes down: the force's derivative jumps; far ahead of a roller nothing is solved."""
    system = ContactSystem(rail=moved([0.0, 0.5]), rail_inclination=0.0, contact_mode="compliant")
    touching = ContactSystem(rail_inclination=0.0).evaluate().vertical_shift
    jump = system.derivatives(["right.penetration"], ["vertical_shift_input"], vertical_shift_input=touching)
    assert np.isnan(jump).all()
    away = ContactSystem(wheel=standard_profile("S1002"), roller_radius=0.5)
    assert np.isnan(away.derivatives(["roll"], ["yaw"], track_position=0.5)).all()
