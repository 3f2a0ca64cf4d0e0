"""A crossing, where nose and wing carry a wheel at once: against complete theory on each of them, and continuity."""

from functools import cache
from math import pi

import numpy as np
import pytest

from data.hertz import MODULUS
from tests.helpers.changing import CROWN, on_its_own, over_plane
from tests.helpers.sections import crossing
from wrcontact import ContactSystem
from wrcontact.halfspace.contact import solve_contact
from wrcontact.profiles import standard_profile

WHEEL = standard_profile("S1002")
#: The wheel touches the wing at this height without lateral shift, and the nose 5 um deeper [m].
TOUCHING = -0.5215e-3


@cache
def system(**parameters):
    return on_its_own(WHEEL, crossing(), **{"normal_model": "analyn_strip", **parameters})


def both(shift, sunk):
    state = system().evaluate(lateral_shift=shift, vertical_shift_input=sunk, side="right")
    assert state.status == 0, (shift, sunk)
    return state.right.patches


@pytest.mark.full
@pytest.mark.parametrize("shift, sunk", [(-1e-4, -0.4649e-3), (-5e-5, -0.4682e-3), (0.0, -0.4715e-3)])
def test_both_carry_what_the_half_space_does(shift, sunk):
    """Loads within 2 %, areas 3 %, pressures 2.5 %: each is complete theory on its own, less what the other load presses it away,
    F / (pi E* d). The frame lies between both directions, which costs 1 %."""
    rail = crossing()
    patches = both(shift, sunk)
    assert len(patches) == 2
    for own, other in (patches, patches[::-1]):
        place = own.x_track, own.y_track - shift
        gap, approach = over_plane(lambda u, y: rail.height(u, y + shift - CROWN), WHEEL, 0.0, sunk, place)
        distance = np.hypot(own.x_track - other.x_track, own.y_track - other.y_track)
        pressed = approach - other.normal_force / (pi * MODULUS * distance)
        box = -0.012, 0.012, -0.008, 0.008
        complete = solve_contact(gap, box, contact_modulus=MODULUS, penetration=pressed, tolerance=0.01)
        assert own.normal_force == pytest.approx(complete.force, rel=0.02)
        assert own.area == pytest.approx(complete.area, rel=0.03)
        assert own.max_pressure == pytest.approx(complete.max_pressure, rel=0.025)


def test_the_load_goes_over_to_the_nose_without_a_jump():
    """As the wheelset comes nearer to the nose in steps of 5 um, by which the nose's overlap grows by 1.2 um: no load changes by
    more than 6 % of both, of which the overlap itself is 4 %."""
    shifts = np.arange(-3.5e-4, 2e-5, 5e-6)
    table = system().evaluate_many(
        lateral_shift=shifts, vertical_shift_input=TOUCHING + 5e-5, side="right", outputs="patches"
    )
    assert (table.status == 0).all()
    field = table.right.contact.y_track
    wing = sum(np.where(p.y_track > CROWN, np.nan_to_num(p.normal_force), 0.0) for p in table.right.patches)
    nose = sum(np.where(p.y_track < CROWN, np.nan_to_num(p.normal_force), 0.0) for p in table.right.patches)
    assert field[0] > CROWN and nose[0] == 0.0 < nose[-1] and wing.min() > 5e3
    assert np.abs(np.diff(wing)).max() < 0.06 * (wing + nose).max()
    assert np.abs(np.diff(nose)).max() < 0.06 * (wing + nose).max()


@pytest.mark.full
@pytest.mark.parametrize("mode", ["rigid", "elastic"])
def test_a_wheelset_that_carries_its_load_on_both_is_a_compliant_one(mode):
    """At its height and roll: the loads of nose and wing, which are together that of the wheel."""
    loaded = ContactSystem(
        wheel=WHEEL,
        rail=("UIC60", crossing()),
        left_rail_inclination=0.0,
        rail_origin_y=CROWN,
        contact_mode=mode,
        normal_model="analyn",
    )
    pressed = system(normal_model="analyn")
    pose = {"lateral_shift": -2e-5}
    state = loaded.evaluate(**pose, normal_force=40e3)
    assert state.status == 0 and state.right.patch_count == 2
    assert sum(patch.normal_force for patch in state.right.patches) == pytest.approx(40e3, rel=0.02)
    if mode == "elastic":
        same = pressed.evaluate(**pose, vertical_shift_input=state.vertical_shift, roll_input=state.roll)
        for found, expected in zip(state.right.patches, same.right.patches):
            assert found.normal_force == pytest.approx(expected.normal_force, rel=1e-3)


def test_what_runs_too_obliquely_is_not_solved():
    """Where the directions of nose and wing differ by more, a patch would be cut askew: status 3, or the loads of the ones solved."""
    apart = on_its_own(WHEEL, crossing(-0.03, 0.14), normal_model="analyn_strip")
    table = apart.evaluate_many(
        lateral_shift=np.linspace(-4e-4, 1e-4, 21), vertical_shift_input=TOUCHING + 5e-5, side="right"
    )
    assert set(table.status) <= {0, 3} and (table.status == 3).any()
    assert np.nanmax(table.right.max_pressure) < 5e9
