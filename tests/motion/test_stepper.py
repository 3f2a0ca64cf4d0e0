"""A stepper for people who write solvers: names, defaults, the resultant, the reaction on a rail, a start."""

import copy

import numpy as np
import pytest

import wrcontact
from wrcontact.interface.inputs import INPUTS

COMPLIANT = {"contact_mode": "compliant", "contact_damping": 1.0, "tangential_model": "strips"}


def test_a_stepper_begins_with_the_defaults_of_evaluate():
    for parameters in ({}, {"tangential_model": "strips", "contact_mode": "elastic"}):
        system = wrcontact.ContactSystem(**parameters)
        stepper = system.stepper()
        assert stepper.input_names == tuple(row.name for row in INPUTS)
        assert stepper.inputs.tolist() == [float(row.start) for row in INPUTS]
        stepper.inputs[stepper.place("speed")] = 20.0
        assert stepper.step() == 0
        assert np.array_equal(stepper.outputs, system.evaluate(speed=20.0).values)


@pytest.mark.parametrize("stations", [31, 12])
def test_every_name_has_its_place(stations):
    system = wrcontact.ContactSystem(stations=stations)
    stepper = system.stepper()
    for name, value in {"lateral_shift": 2e-3, "yaw": 4e-3, "right.rail_lateral": 1e-4}.items():
        stepper.inputs[stepper.place(name)] = value
    stepper.step()
    state = system.evaluate(2e-3, 4e-3, right_rail_lateral=1e-4)
    assert stepper.output_names == state.names and len(stepper.input_names) == len(stepper.inputs)
    assert all(stepper.outputs[stepper.place(name)] == state[name] for name in stepper.output_names)
    assert [stepper.place(name) for name in stepper.input_names] == list(range(len(stepper.inputs)))
    if stations == 31:
        assert [stepper.place(name) for name in stepper.output_names] == list(range(len(stepper.outputs)))


@pytest.mark.parametrize(
    "name, meant",
    [("force.yy", "force.y"), ("lateral_shft", "lateral_shift"), (None, "list them"), (["yaw"], "list them")],
)
def test_a_wrong_name_gets_a_proposal(name, meant):
    with pytest.raises(ValueError, match=f"no input or output.*{meant}"):
        wrcontact.ContactSystem().stepper().place(name)


def test_the_resultant_is_that_of_evaluate():
    system = wrcontact.ContactSystem(**COMPLIANT)
    stands = system.evaluate(2e-3).equilibrium
    turned = np.array(
        [
            [1, 0, 0],
            [0, np.cos(stands.roll), -np.sin(stands.roll)],
            [0, np.sin(stands.roll), np.cos(stands.roll)],
        ]
    )
    motion = wrcontact.motion_of(
        [0, 2e-3, stands.vertical_shift - 0.46], turned, [20, 0.01, 0], [0, -43.6, 0.02]
    )
    state = system.evaluate(**motion)
    stepper = system.stepper(outputs="patches")
    for one in (stepper, copy.deepcopy(stepper)):
        force, moment = one.resultant(motion)
        assert np.array_equal(force, np.asarray(state.force))
        assert np.array_equal(moment, np.asarray(state.moment))
        assert np.array_equal(one.force, force) and np.array_equal(one.moment, moment)
    kept = force.copy()
    assert np.isnan(stepper.resultant({"lateral_shift": 0.02})).all()  # off the profile
    assert np.array_equal(force, kept)
    with pytest.raises(TypeError, match="did you mean lateral_shift"):
        stepper.resultant({"lateral_shft": 0.0})


@pytest.mark.parametrize("side", ["left", "right"])
def test_the_reaction_on_a_rail(side):
    """Opposite to the forces of the patches at their centres of load, about the highest point of a displaced
    rail."""
    system = wrcontact.ContactSystem(contact_mode="compliant")
    pose = {"lateral_shift": 5e-3, "yaw": 5e-3, f"{side}_rail_lateral": 1e-3, f"{side}_rail_vertical": -5e-4}
    stands = system.evaluate(**pose).equilibrium
    pose |= {"vertical_shift_input": stands.vertical_shift, "roll_input": stands.roll}
    state = system.evaluate(**pose)
    force, moment = system.rail_reaction(state, side)
    wheel = getattr(state, side)
    y = np.sign(wheel.contact.y_track) * system.profile_tables(side)[2] + 1e-3
    point = np.array([0.0, y, -5e-4])
    of_patches = sum(
        (
            np.cross(np.array([patch.x_track, patch.y_track, patch.z_track]) - point, np.asarray(patch.force))
            for patch in wheel.patches
        ),
        np.zeros(3),
    )
    assert np.array_equal(force, -np.asarray(wheel.force))
    assert moment[0] == pytest.approx(-of_patches[0], rel=2e-3)  # of forces at the centres of load
    stepper = system.stepper()
    for name, value in pose.items():
        stepper.resultant({name: value})
    assert np.array_equal(stepper.rail_reaction(side), (force, moment))
    with pytest.raises(ValueError, match="side is 'middle'"):
        stepper.rail_reaction("middle")


def test_a_reaction_about_a_known_point():
    """Without yaw, by hand: the lever of the vertical force is the patch's distance from the highest point,
    that of the lateral one its depth below it."""
    system = wrcontact.ContactSystem(normal_model="hertz")
    state = system.evaluate(2e-3)
    (patch,) = state.right.patches
    force, moment = system.rail_reaction(state, "right")
    y = system.profile_tables("right")[2]
    by_hand = (patch.y_track - y) * force[2] - patch.z_track * force[1]
    assert moment[0] == pytest.approx(by_hand, abs=1e-6 * 78.5e3)


@pytest.mark.parametrize("shift, yaw", [(0.0, 0.0), (4e-3, 0.0), (-6e-3, 6e-3)])
def test_a_height_to_start_from(shift, yaw):
    """At the roll of the equilibrium it is that of the equilibrium; at any other the load is carried too."""
    system = wrcontact.ContactSystem(contact_mode="compliant", load="vertical")
    pose = {"lateral_shift": shift, "yaw": yaw, "normal_force": 5e4}
    stands = system.evaluate(**pose).equilibrium
    found = system.stand_at(stands.roll, **pose)
    assert found.vertical_shift == pytest.approx(stands.vertical_shift, abs=1e-9)
    assert found.roll == stands.roll
    for roll in (stands.roll - 3e-5, stands.roll + 0.01, -0.02):
        found = system.stand_at(roll, **pose)
        state = system.evaluate(**pose, vertical_shift_input=found.vertical_shift, roll_input=roll)
        assert state.status == found.status <= wrcontact.Status.UNLOADED
        assert state.force.z == pytest.approx(-1e5, rel=1e-8), (shift, yaw, roll)
    with pytest.raises(ValueError, match="'elastic'.*'compliant'"):
        wrcontact.ContactSystem(contact_mode="elastic").stand_at(0.0)
