"""ContactSystem, its states and steppers: names, shapes, wrong input, memory."""

import copy
import math
import pickle
import warnings

import numpy as np
import pytest

import wrcontact
from wrcontact import Status, UnusualValueWarning
from wrcontact.kernel import layout
from wrcontact.methods import NormalModel
from wrcontact.status import explain


@pytest.fixture(scope="module")
def system():
    return wrcontact.ContactSystem()


def test_the_interface_of_the_readme(system):
    state = system.evaluate(lateral_shift=1e-3, yaw=0.0, normal_force=78.5e3)
    assert state.status == 0 and state.status is Status.VALID
    assert state.roll == pytest.approx(-5.4104e-5, abs=1e-9)
    right = state.right
    assert right.contact.y_wheel == pytest.approx(-9.3567e-3, abs=1e-6)
    assert right.penetration == pytest.approx(7.952e-5, rel=0.006)  # complete theory; measured 0.45 %
    assert right.patches[0].area == pytest.approx(right.area)
    assert right.patches[0].normal_force == pytest.approx(78.5e3)
    assert (
        right.outline.station.shape
        == right.outline.half_length.shape
        == right.outline.pressure.shape
        == (31,)
    )
    assert right.outline.half_length[0] == right.outline.half_length[-1] == 0.0
    assert isinstance(right.penetration, float) and isinstance(right.patch_count, int)
    assert "VALID" in repr(state) and "y_wheel" in repr(right.contact)


def test_a_table_holds_what_single_evaluations_hold(system):
    shift = np.linspace(-6e-3, 6e-3, 25)
    table = system.evaluate_many(
        lateral_shift=shift, yaw=0.01, normal_force=np.linspace(1e3, 1e5, 25), load_transfer=0.1
    )
    assert len(table) == 25 and table.right.outline.pressure.shape == (25, 31)
    assert table.right.patches[2].area.shape == (25,)
    for k in (0, 7, 24):
        one = system.evaluate(shift[k], 0.01, np.linspace(1e3, 1e5, 25)[k], 0.1)
        assert one.roll == pytest.approx(table.roll[k], abs=1e-13)
        assert one.left.penetration == pytest.approx(table.left.penetration[k], rel=1e-9)
        assert one.right.contact.x_track == pytest.approx(table.right.contact.x_track[k], abs=1e-11)


def test_rows_that_cannot_be_are_nan_and_say_why(system):
    table = system.evaluate_many(
        lateral_shift=[0.0, np.nan, 0.5, 1e-3, 2e-3], normal_force=[1e4, 1e4, 1e4, -5.0, 0.0]
    )
    np.testing.assert_array_equal(table.status, [0, 4, 2, 4, 1])
    np.testing.assert_array_equal(np.isnan(table.roll), [False, True, True, True, False])
    assert table.right.area[0] == pytest.approx(system.evaluate(normal_force=1e4).right.area, rel=1e-9)
    with pytest.raises(ValueError, match="lateral_shift has the shape .2, 2."):
        system.evaluate_many(lateral_shift=np.zeros((2, 2)))


@pytest.mark.parametrize(
    "arguments, words",
    [
        (dict(lateral_shift=math.nan), ["lateral_shift", "nan", "finite"]),
        (dict(yaw=math.inf), ["yaw", "inf", "finite"]),
        (dict(normal_force=-1.0), ["normal_force", "-1 N", ">= 0"]),
        (dict(load_transfer=1.5), ["load_transfer", "1.5", "<= 1"]),
        (dict(roll_guess=math.nan), ["roll_guess", "nan"]),
    ],
)
def test_invalid_input_is_a_status_with_a_sentence(system, arguments, words):
    good = system.evaluate(lateral_shift=2e-3)
    state = system.evaluate(**{"lateral_shift": 2e-3, **arguments})
    assert state.status == Status.INVALID_INPUT
    assert np.isnan(state.values).all() and state.right.patches == ()
    sentence = explain(state.status, state.inputs)
    assert all(word in sentence for word in words) and "keep" not in sentence, sentence
    assert system.evaluate(lateral_shift=2e-3).values == pytest.approx(good.values, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("shift, status", [(0.02, Status.OFF_PROFILE), (math.nan, Status.INVALID_INPUT)])
def test_no_results_of_another_pose(system, shift, status):
    """A pose out of range has no results, and the sentence on a step says that a stepper holds them."""
    good, bad = system.evaluate(lateral_shift=2e-3), system.evaluate(lateral_shift=shift)
    assert bad.status == status and np.isnan(bad.values).all()
    np.testing.assert_array_equal(system.evaluate(lateral_shift=2e-3).values, good.values)
    assert explain(status, bad.inputs, held=True) == (
        explain(status, bad.inputs) + "; the outputs keep their last valid values"
    )


@pytest.mark.parametrize("force", [78.5e6, np.array([1e3, math.nan, 78.5e6])], ids=["one", "many"])
def test_a_force_in_wrong_units_is_remarked(force):
    """78500 kN for 78.5 kN: a warning has the numbers. There is no result: the wheel would sink by 8 mm."""
    system = wrcontact.ContactSystem()
    call = system.evaluate if np.ndim(force) == 0 else system.evaluate_many
    with pytest.warns(UnusualValueWarning, match=r"normal_force is 7.85e\+07 N; usual is 500 ... 1e\+06 N"):
        status = np.max(call(normal_force=force).status)
    assert status == (Status.OFF_PROFILE if np.ndim(force) == 0 else Status.INVALID_INPUT)
    words = explain(Status.OFF_PROFILE, system.evaluate(normal_force=78.5e6).inputs)
    assert words.startswith("normal_force is 7.85e+07 N; usual is at most 1e+06 N")  # not the profile


@pytest.mark.parametrize("force", [78.5, np.array([0.0, 78.5])], ids=["one", "many"])
def test_a_force_in_kn_is_remarked_once(force):
    """78.5 N for 78.5 kN, once for a system; not a load of zero, nor a table that has usual ones."""
    system = wrcontact.ContactSystem()
    call = system.evaluate if np.ndim(force) == 0 else system.evaluate_many
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        system.evaluate(normal_force=0.0)
        system.evaluate_many(normal_force=[0.0, 78.5, 78.5e3])
    with pytest.warns(UnusualValueWarning, match="normal_force is 78.5 N; usual is 500 ... 1e"):
        call(normal_force=force)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        call(normal_force=1.1 * force)


def test_unusual_parameters_are_remarked():
    """A diameter for a radius, and a modulus in kPa."""
    with pytest.warns(UnusualValueWarning, match="nominal_radius is 0.92 m; usual is 0.125 ... 0.7 m"):
        wrcontact.ContactSystem(nominal_radius=0.92)
    with pytest.warns(UnusualValueWarning, match=r"youngs_modulus is 2.1e\+08 Pa"):
        wrcontact.ContactSystem(youngs_modulus=210e6)


def test_usual_values_give_no_warning(system):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        wrcontact.ContactSystem()
        system.evaluate_many(normal_force=[0.0, 1e6, math.nan, math.inf, -1.0])
        system.evaluate(normal_force=math.nan)


@pytest.mark.parametrize(
    "inputs, status, words",
    [  # height and roll are zero
        ((0.1, 0, 0, 1e4, 0), 2, ["lateral_shift is 0.1 m", "0.015 m"]),
        ((0.0, 0.3, 0, 1e4, 0), 2, ["yaw is 0.3 rad", "0.12 rad"]),
        ((0.0, 0, 0, 0.0, 0), 1, ["normal_force is 0 N", ">= 1e-10 N"]),
        ((0.0, 0, 0, 1e4, -1.0), 1, ["load_transfer is -1,", ">= 1e-10 N"]),
        ((0.0, 0, 0, 1e4, 0), 3, ["iteration limit"]),
    ],
)
def test_every_status_has_its_sentence(inputs, status, words):
    inputs = (*inputs, 0.0, 0.0)
    assert all(word in explain(status, inputs) for word in words), explain(status, inputs)
    assert explain(0, inputs) == ""


@pytest.mark.parametrize(
    "arguments, status, words",
    [
        (
            dict(vertical_shift_input=-1e-3),
            1,
            ["vertical_shift_input is -0.001 m", "roll_input 0 rad", "lifted"],
        ),
        # the left wheel
        (dict(vertical_shift_input=0.5e-3, roll_input=1e-3), 1, ["roll_input 0.001 rad", "lifted"]),
        (
            dict(vertical_shift_input=1e-3, roll_input=2e-3),
            2,
            ["roll_input 0.002 rad", "deeper in its rail than 0.002 m"],
        ),
        (
            dict(vertical_shift_input=4e-3),
            2,
            ["vertical_shift_input is 0.004 m", "deeper in its rail than 0.002 m"],
        ),
        (dict(roll_input=-0.2), 2, ["roll_input is -0.2 rad", "|roll_input| <= 0.12 rad"]),
        (dict(lateral_shift=0.1), 2, ["lateral_shift is 0.1 m", "0.015 m"]),
        (dict(vertical_shift_input=math.nan), 4, ["vertical_shift_input is nan m", "finite"]),
        (dict(roll_input=math.inf), 4, ["roll_input is inf rad", "finite"]),
    ],
)
def test_compliant_contact_has_its_sentences(arguments, status, words):
    state = wrcontact.ContactSystem(contact_mode="compliant").evaluate(**arguments)
    sentence = explain(state.status, state.inputs, compliant=True)
    assert state.status == status and all(word in sentence for word in words), sentence


@pytest.mark.parametrize(
    "arguments, sentence",
    [
        (dict(wheel="S1003"), "wheel is 'S1003'; permitted are S1002"),
        (dict(rail="S1002"), "rail is 'S1002'"),
        (dict(rail_inclination=0.5), "rail_inclination is 0.5; permitted is 0 ... 0.1"),
        (dict(gauge=1435.0), "gauge is 1435.0; permitted is 0.5 ... 2 m"),
        (dict(nominal_radius="big"), "nominal_radius is 'big'; permitted is 0.1 ... 1 m"),
        (dict(youngs_modulus=math.nan), "youngs_modulus is nan; permitted is"),
        (dict(poisson_ratio=0.5), "poisson_ratio is 0.5"),
        (
            dict(normal_model="kalker"),
            f"normal_model is 'kalker'; permitted are {str(NormalModel.family.names())[1:-1]}",
        ),
        (
            dict(contact_mode="plastic"),
            "contact_mode is 'plastic'; permitted are 'rigid', 'elastic', 'compliant'",
        ),
        (dict(load="lateral"), "load is 'lateral'; permitted are 'normal', 'vertical'"),
        (
            dict(normal_model="halfspace", longitudinal_curvature="basic"),
            "longitudinal_curvature is 'basic'; permitted with the normal_model 'halfspace', which knows the whole "
            "surface, is 'effective'",
        ),
        (dict(lateral_curvature=3), "lateral_curvature is 3; permitted are 'adaptive', 'smooth', 'rough'"),
        (
            dict(separation="lateral"),
            "separation is 'lateral'; permitted are 'normal', 'vertical', 'equidistant', 'equidistant_chord'",
        ),
        (dict(curvature_step=1e-5), "curvature_step is 1e-05; permitted is 2e-05 ... 0.005 m"),
        (dict(curvature_reach=3.0), "curvature_reach is 3.0; permitted is 0.0001 ... 0.01 m"),
    ],
)
def test_wrong_parameters_are_refused_in_a_sentence(arguments, sentence):
    with pytest.raises(ValueError) as refusal:
        wrcontact.ContactSystem(**arguments)
    assert str(refusal.value).startswith(sentence) and "\n" not in str(refusal.value)


def test_every_parameter_changes_what_it_should(system):
    plain = system.evaluate(3e-3)
    for name, value in (
        ("rail_inclination", 1 / 20),
        ("gauge", 1.44),
        ("gauge_depth", 0.0138),
        ("running_circle_distance", 1.51),
        ("nominal_radius", 0.5),
    ):
        changed = wrcontact.ContactSystem(**{name: value}).evaluate(3e-3)
        assert changed.status == 0 and changed.roll != pytest.approx(plain.roll, rel=1e-6), name
    softer = wrcontact.ContactSystem(youngs_modulus=100e9).evaluate(3e-3)
    assert softer.roll == pytest.approx(plain.roll, abs=1e-13) and softer.right.area > 1.3 * plain.right.area
    assert wrcontact.ContactSystem(poisson_ratio=0.0).evaluate(3e-3).right.area > plain.right.area


@pytest.mark.parametrize("mode", ["rigid", "elastic", "compliant"])
def test_numbers_from_hell_never_leave_the_statuses(mode):
    rng = np.random.default_rng(13)
    special = np.array(
        [
            0.0,
            -0.0,
            5e-324,
            1e-300,
            1e-30,
            1e-9,
            1e-3,
            6.25e-3,
            0.0149999,
            0.015,
            1.0,
            1e30,
            1e308,
            np.inf,
            np.nan,
        ]
    )
    stepper, count = wrcontact.ContactSystem(contact_mode=mode).stepper(), layout.INPUT_COUNT
    for _ in range(3000):
        stepper.inputs[:] = rng.choice(special, count) * rng.choice([-1.0, 1.0], count)
        pose = tuple(stepper.inputs)
        status = stepper.step()
        assert 0 <= status <= 4, pose
        assert np.all(np.isfinite(stepper.outputs)), pose


def test_pickled_and_copied_systems_agree(system):
    other = pickle.loads(pickle.dumps(wrcontact.ContactSystem(rail="60E1", gauge=1.437)))
    assert other.parameters["gauge"] == 1.437 and repr(other) == "ContactSystem(rail='60E1', gauge=1.437)"
    assert other.evaluate(1e-3).roll == wrcontact.ContactSystem(rail="60E1", gauge=1.437).evaluate(1e-3).roll


@pytest.mark.full
def test_memory_stays_flat(system):
    """100 000 evaluations; resident memory read from the system where it says it."""
    resident = pytest.importorskip("resource")
    stepper = system.stepper()
    shift = 6.6e-3 * np.sin(np.linspace(0, 50, 100_000))

    def run():
        for value in shift[::2]:
            stepper.inputs[0], stepper.inputs[3] = value, 78.5e3
            stepper.step()

    run()
    before = resident.getrusage(resident.RUSAGE_SELF).ru_maxrss
    run()
    assert resident.getrusage(resident.RUSAGE_SELF).ru_maxrss - before < 1024  # [KiB]


@pytest.mark.parametrize("copied", [lambda one: pickle.loads(pickle.dumps(one)), copy.deepcopy])
@pytest.mark.parametrize(
    "more",
    [
        {},
        {"stations": 7, "contact_mode": "elastic"},
        {"left_nominal_radius": 0.461, "tangential_model": "strips"},
    ],
)
def test_a_stepper_survives_pickling(more, copied):
    """With what is wanted and prescribed, its inputs and outputs; both go on with the same bits."""
    system = wrcontact.ContactSystem(normal_model="hertz", **more)
    stepper = system.stepper("right", "patches")
    if "contact_mode" not in more:
        stepper.prescribe((4e-5, 5e-5))
    stepper.inputs[:] = system.evaluate(2e-3, 0.01, speed=20.0).inputs
    stepper.step()
    other = copied(stepper)
    for name in ("inputs", "outputs", "state"):
        np.testing.assert_array_equal(getattr(other, name), getattr(stepper, name))
    for shift in (3e-3, 3.1e-3, 0.1, -5e-3):
        stepper.inputs[0] = other.inputs[0] = shift
        assert other.step() == stepper.step()
        np.testing.assert_array_equal(other.outputs, stepper.outputs)
    other.inputs[0] = 1e-3
    other.step()
    assert other.outputs[0] != stepper.outputs[0]  # it has arrays of its own
    if "contact_mode" not in more:
        assert other.outputs[layout.OUT_RIGHT + layout.SIDE_PENETRATION] == 5e-5
