"""One rule for all contact modes, models and doors on what is NaN with one side or a part of the outputs, and
on what the status is that of (docs/reference/conventions.md)."""

import math
import pickle
from functools import cache

import numpy as np
import pytest

from tests.helpers.inside import counts_of
from wrcontact import ContactSystem, Status, WheelContact
from wrcontact.interface.inputs import INPUT_NAMES, INPUTS
from wrcontact.interface.variables import REFERENCE
from wrcontact.kernel import layout
from wrcontact.methods import CHOICES
from wrcontact.simulation.session import Session

MODES = ("rigid", "elastic", "compliant")
GEOMETRY = ("contact.", "contact_angle", "rolling_radius", "curvature_")
OUTLINE = ("station", "half_length", "pressure", "shear", "slip")
#: A flange contact that rolls.
POSE = {
    "lateral_shift": 5e-3,
    "yaw": 4e-3,
    "normal_force": 80e3,
    "load_transfer": 0.2,
    "speed": 20.0,
    "lateral_velocity": 0.01,
}
MODELS = [
    (normal, tangential)
    for normal in ("hertz", "analyn", "analyn_strip")
    for tangential in CHOICES["tangential_model"]
    if normal == "analyn" or tangential == "strips"
]


def is_wanted(name, side, outputs):
    """The rule, by the name of an output."""
    owner, _, rest = name.partition(".")
    if name in ("roll", "vertical_shift"):
        return True
    if owner not in ("left", "right"):
        return side == "both" and outputs != "geometry"
    if side not in ("both", owner):
        return False
    if rest.startswith(GEOMETRY):
        return True
    return outputs == "all" if rest.startswith(OUTLINE) else outputs != "geometry"


@cache
def system_of(mode, normal="analyn", tangential="strips", **more):
    return ContactSystem(contact_mode=mode, normal_model=normal, tangential_model=tangential, **more)


@cache
def pose_of(mode):
    """The inputs; a compliant wheelset stands where an elastic one carries the load."""
    if mode != "compliant":
        return POSE
    balanced = system_of("elastic", "hertz", "none").evaluate(**POSE)
    return POSE | {"vertical_shift_input": balanced.vertical_shift, "roll_input": balanced.roll}


def check_rule(found, full, side, outputs):
    """``found`` is that of the ``full`` state where it is wanted, bit by bit, and NaN elsewhere."""
    expected = np.array([full[name] if is_wanted(name, side, outputs) else math.nan for name in full.names])
    np.testing.assert_array_equal([found[name] for name in full.names], expected)
    for wheel in (found.left, found.right):
        assert math.isnan(wheel.patch_count) or isinstance(wheel.patch_count, int)
        assert len(wheel.patches) == (0 if math.isnan(wheel.patch_count) else wheel.patch_count)


@pytest.mark.parametrize("outputs", ["all", "patches", "geometry"])
@pytest.mark.parametrize("side", ["both", "left", "right"])
@pytest.mark.parametrize("normal, tangential", MODELS)
@pytest.mark.parametrize("mode", MODES)
def test_the_rule_holds_at_every_door(mode, normal, tangential, side, outputs):
    system, pose = system_of(mode, normal, tangential), pose_of(mode)
    full = system.evaluate_many(**pose)[0]
    assert full.status == Status.VALID and np.all(np.isfinite(full.values))
    single = system.evaluate(**pose, side=side, outputs=outputs)
    table = system.evaluate_many(**pose, side=side, outputs=outputs)
    parts = list(system.evaluate_parts(**pose, side=side, outputs=outputs))
    stepper = system.stepper(side, outputs)
    stepper.inputs[:] = single.inputs
    restored = pickle.loads(pickle.dumps(stepper))
    assert stepper.step() == restored.step() == Status.VALID
    for found in (single, table[0], parts[0][0]):
        assert found.status == Status.VALID
        check_rule(found, full, side, outputs)
    for one in (stepper, restored):
        np.testing.assert_array_equal(one.outputs, single.values)


@pytest.mark.full
@pytest.mark.parametrize(
    "mode, normal, tangential",
    [
        *((mode, "halfspace", "strips") for mode in MODES),
        ("elastic", "halfspace", "none"),
        ("rigid", "analyn", "halfspace"),
    ],
)
def test_the_rule_holds_for_the_half_space(mode, normal, tangential):
    more = {"tolerance": 0.02} if normal == "halfspace" else {}
    system, pose = system_of(mode, normal, tangential, **more), pose_of(mode)
    full = system.evaluate(**pose)
    assert full.status == Status.VALID and np.all(np.isfinite(full.values))
    for side, outputs in (("right", "all"), ("both", "patches"), ("both", "geometry"), ("left", "geometry")):
        check_rule(system.evaluate(**pose, side=side, outputs=outputs), full, side, outputs)


@pytest.mark.parametrize("mode", MODES)
def test_the_rule_holds_for_every_output_by_name(mode):
    """One output alone has the value that it has among all others."""
    system, pose = system_of(mode, "hertz"), pose_of(mode)
    full = system.evaluate_many(**pose)[0]
    for name, value in zip(full.names, full.values):
        some = system.evaluate_many(**pose, outputs=[name])
        assert some.names == (name,) and some[name][0] == value == full[name], name
        np.testing.assert_array_equal(some[0].values, np.where(np.isin(full.names, name), value, np.nan))


@pytest.mark.parametrize("mode", MODES)
def test_a_named_output_of_another_side_is_not_there(mode):
    table = system_of(mode, "hertz").evaluate_many(
        **pose_of(mode), side="left", outputs=["right.area", "force", "left.area", "roll"]
    )
    assert np.isnan(table.right.area[0]) and np.all(np.isnan(np.asarray(table.force)))
    assert table.left.area[0] > 0.0 and np.isfinite(table.roll[0])


@pytest.mark.parametrize("side", ["left", "right"])
def test_a_row_of_one_wheel_has_no_number_of_the_other_side(side):
    stepper = WheelContact(side=side).stepper()
    stepper.outputs[:] = 7.0  # what stood there before
    assert stepper.step() == Status.UNLOADED
    left = layout.OUT_LEFT + np.arange(layout.size(layout.SideOutputs))
    right = layout.OUT_RIGHT + np.arange(layout.size(layout.SideOutputs))
    here, there = (left, right) if side == "left" else (right, left)
    row = np.array(stepper.outputs)
    assert np.all(np.isnan(row[there])) and np.all(np.isfinite(row[here]))


@pytest.mark.parametrize("mode", MODES)
def test_without_a_solution_everything_is_nan(mode):
    for side in ("both", "right"):
        found = system_of(mode, "hertz").evaluate(20e-3, side=side)
        assert found.status == Status.OFF_PROFILE and np.all(np.isnan(found.values))
        assert math.isnan(found.right.patch_count) and found.right.patches == ()


@pytest.mark.parametrize("mode", MODES)
def test_an_fmu_has_all_outputs(mode):
    """It has no choice of sides and outputs."""
    session = Session()
    session.set_strings([REFERENCE["contact_mode"], REFERENCE["tangential_model"]], [mode, "strips"])
    pose = pose_of(mode)
    names = {row.keyword: name for name, row in zip(INPUT_NAMES, INPUTS)}
    session.set_reals([REFERENCE[names[name]] for name in pose], list(pose.values()))
    session.start()
    full = system_of(mode).evaluate(**pose)
    names = [name for name in full.names if not name.endswith("patch_count")]
    assert np.all(np.isfinite(session.get_reals([REFERENCE[name] for name in names])))


# --- statuses ---------------------------------------------------------------------------------------------


def lifted(mode):
    """Inputs whose right wheel carries no load."""
    if mode == "compliant":
        return {"vertical_shift_input": 1e-4, "roll_input": -2e-3}
    return {"load_transfer": -1.0}


@pytest.mark.parametrize("normal", ["analyn", pytest.param("halfspace", marks=pytest.mark.full)])
@pytest.mark.parametrize("mode", MODES)
def test_a_wheel_without_load_counts_where_it_is_wanted(mode, normal):
    system = system_of(mode, normal, "none")
    found = {side: system.evaluate(**lifted(mode), side=side).status for side in ("both", "left", "right")}
    assert found == {"both": Status.UNLOADED, "left": Status.VALID, "right": Status.UNLOADED}


def test_a_compliant_wheel_that_is_too_deep_counts_where_it_is_wanted():
    """Each side of a compliant wheelset stands for itself."""
    system = system_of("compliant", "hertz")
    inputs = {"vertical_shift_input": 5.5e-3, "roll_input": 8e-3}
    found = {side: system.evaluate(**inputs, side=side).status for side in ("both", "left", "right")}
    assert found == {"both": Status.OFF_PROFILE, "left": Status.UNLOADED, "right": Status.OFF_PROFILE}


@pytest.mark.parametrize("normal, counter", [("analyn", "node"), ("analyn_strip", "strip")])
def test_one_side_of_a_compliant_wheelset_costs_half(normal, counter):
    """What is not wanted is not computed: the counts of both sides add up, and geometry needs no normal
    contact but the curvatures. Only the rotation of a wheelset that rolls freely needs both wheels."""

    def cost(*wanted, rate=20.0 / 0.46):
        stepper = system_of("compliant", normal).stepper(*wanted)
        pose = pose_of("compliant") | {"wheel_rate": rate}
        stepper.inputs[:] = ContactSystem(normal_model="hertz").evaluate(**pose).inputs
        assert stepper.step() == Status.VALID
        return counts_of(stepper)[counter]

    left, right = cost("left"), cost("right")
    assert left + right == cost() and min(left, right) > 2.0 and cost("both", "geometry") <= 2.0
    assert cost("left", rate=0.0) == cost("both", rate=0.0) == cost()


# --- outputs by name --------------------------------------------------------------------------------------


def test_the_status_is_an_output_by_name():
    """It is that of the whole contact: of both sides, patches included."""
    system = system_of("rigid", "hertz")
    load = {"load_transfer": [0.0, 1.0, -1.0], "lateral_shift": [0.0, 0.0, 20e-3]}
    expected = system.evaluate_many(**load).status
    assert expected.tolist() == [0, 1, 2]
    for outputs in ("status", ["status"], ["roll", "status"], ["status", "right.area"]):
        table = system.evaluate_many(**load, outputs=outputs)
        np.testing.assert_array_equal(table.status, expected)
        np.testing.assert_array_equal(table["status"], expected)
        parts = list(system.evaluate_parts(**load, outputs=outputs))
        np.testing.assert_array_equal(np.concatenate([part.status for part in parts]), expected)
        assert system.evaluate(0.0, load_transfer=1.0, outputs=outputs).status == Status.UNLOADED
    alone = system.evaluate_many(**load, outputs=["status"])
    assert alone.names == () and alone.values.shape == (3, 0) and np.all(np.isnan(alone.right.area))
    assert np.all(np.isnan(alone[0].values)) and "3 poses" in alone._repr_html_()
    assert list(alone.to_dict()["status"]) == [0, 1, 2]


def test_evaluate_takes_names_of_outputs():
    system = system_of("rigid", "hertz")
    full, some = system.evaluate(**POSE), system.evaluate(**POSE, outputs=["right.area", "roll"])
    assert (some.right.area, some.roll) == (full.right.area, full.roll)
    assert math.isnan(some.right.max_pressure)
    np.testing.assert_array_equal(some.inputs, full.inputs)
    with pytest.raises(ValueError, match="lateral_shift has the shape .2,.; permitted is one number"):
        system.evaluate([0.0, 1.0], outputs=["roll"])
