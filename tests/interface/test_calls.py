"""What a call says on unknown names and on values that are no numbers, and where its warnings point."""

import inspect
import pickle
import sys
import warnings
from fractions import Fraction

import numpy as np
import pytest

import wrcontact
from tests.helpers.profile_points import columns, noisy
from wrcontact import ContactSystem
from wrcontact.interface.inputs import INPUTS
from wrcontact.interface.parameters import checked_parameters

SYSTEM = ContactSystem(normal_model="hertz")


# --- names ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("door", ["evaluate", "evaluate_many", "evaluate_parts"])
@pytest.mark.parametrize(
    "name, end",
    [
        ("friction", "did you mean left_friction or right_friction?"),
        ("velocity", "did you mean lateral_velocity or vertical_velocity or left_rail_lateral_velocity?"),
        ("laterl_shift", "did you mean lateral_shift?"),
        ("left.friction", "did you mean left_friction?"),
        ("contact_mode", "contact_mode is a parameter of ContactSystem"),
        ("xyz", "inputs are lateral_shift, yaw, "),
    ],
)
def test_an_unknown_input_is_refused_with_known_ones(door, name, end):
    with pytest.raises(TypeError) as refusal:
        getattr(SYSTEM, door)(**{name: 0.3})
    assert str(refusal.value).startswith(f"there is no input {name!r}; {end}")


@pytest.mark.parametrize(
    "name, end",
    [
        ("inclination", "did you mean rail_inclination or left_rail_inclination?"),
        ("speed", "speed is an input of evaluate"),
        ("wheel_profile", "in Python it is wheel"),
        ("left_rail_profile", "in Python it is left_rail"),
    ],
)
def test_an_unknown_parameter_is_refused_with_known_ones(name, end):
    with pytest.raises(TypeError) as refusal:
        ContactSystem(**{name: 0.3})
    assert str(refusal.value) == f"ContactSystem has no parameter {name!r}; {end}"


@pytest.mark.parametrize(
    "places, name, words",
    [
        ((0.0, 0.0), "yaw", "^the input yaw is given twice, by its place and by its name"),
        ((0.0, 0.0, 1e4, 0.0, 0.1), "speed", "^5 inputs have no name; permitted are lateral_shift, yaw, "),
    ],
)
def test_inputs_by_place_are_the_main_ones_each_once(places, name, words):
    with pytest.raises(TypeError, match=words):
        SYSTEM.evaluate(*places, **{name: 0.0})


def test_inputs_by_place_are_those_by_name():
    names = ("lateral_shift", "yaw", "normal_force", "load_transfer")
    values = (1e-3, 2e-3, 5e4, 0.1)
    system = wrcontact.ContactSystem()
    by_place, by_name = system.evaluate(*values), system.evaluate(**dict(zip(names, values)))
    assert [by_place.inputs[name] for name in names] == list(values)
    np.testing.assert_array_equal(by_place.values, by_name.values)
    many = system.evaluate_many(*(np.array([value]) for value in values))
    np.testing.assert_array_equal(many.values[0], by_name.values)


def test_an_input_that_is_not_given_is_not_that_of_the_call_before():
    options = {"tangential_model": "polach", "contact_mode": "compliant"}
    system = wrcontact.ContactSystem(**options)
    given = {
        row.keyword: row.start + 0.1 * (row.start or 1e-3)
        for row in INPUTS
        if not row.switch and row.keyword != "normal_force"
    }
    before = system.evaluate(**given)
    again, new = system.evaluate(), wrcontact.ContactSystem(**options).evaluate()
    assert before.status <= 1 and not np.array_equal(before.values, again.values)
    np.testing.assert_array_equal(again.values, new.values)
    assert again.inputs.to_dict() == new.inputs.to_dict()


def test_a_number_names_no_outputs():
    with pytest.raises(ValueError, match="outputs is 3; permitted are 'all', 'patches', 'geometry'"):
        SYSTEM.evaluate_many([0.0], outputs=3)


def test_a_coefficient_for_the_record_of_friction_is_led_to_its_inputs():
    with pytest.raises(ValueError, match="^friction is 0.3; permitted is a Friction; .* left_friction and"):
        ContactSystem(friction=0.3)


# --- values -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("value", ["3", True, None, np.True_, b"3", 1j])
def test_what_is_no_number_is_refused(value):
    """Numpy takes the first four for 3, 1, not a number and 1."""
    for door in (SYSTEM.evaluate, SYSTEM.evaluate_many):
        for name, words in (
            ("lateral_shift", "a number, in m"),
            ("load_transfer", "a number"),
            ("normal_force", "a number, in N"),
            ("left_friction", "a number"),
        ):
            with pytest.raises(ValueError) as refusal:
                door(**{name: value})
            shown = True if value is np.True_ else value
            assert str(refusal.value) == f"{name} is {shown!r}; permitted is {words}"
    with pytest.raises(ValueError, match="^lateral_shift is "):
        SYSTEM.evaluate(value)


@pytest.mark.parametrize(
    "values, word",
    [
        (["1", "2"], "'1'"),
        ([0.0, None], "None"),
        ([True, False], "True"),
        (np.array([1.0, None]), "None"),
        (["", 1.0], "''"),
    ],
)
def test_arrays_with_other_things_than_numbers_are_refused(values, word):
    with pytest.raises(ValueError) as refusal:
        SYSTEM.evaluate_many(0.0, yaw=values)
    assert str(refusal.value) == f"yaw has {word}; permitted are numbers, in rad"


def test_a_switch_takes_truth_values_and_numbers_only():
    locked = SYSTEM.evaluate(speed=20.0, free_rolling=False)
    assert locked.right.patches[0].creepage.x == pytest.approx(2.0, rel=1e-3)
    for value in (0, 0.0, np.False_, np.array([False])[0]):
        np.testing.assert_array_equal(SYSTEM.evaluate(speed=20.0, free_rolling=value).values, locked.values)
    table = SYSTEM.evaluate_many(speed=20.0, free_rolling=[True, False])
    assert abs(table.right.patches[0].creepage.x[0]) < 0.1 < table.right.patches[0].creepage.x[1]
    for value in ("yes", None):
        with pytest.raises(ValueError, match="^free_rolling is .*; permitted is True or False$"):
            SYSTEM.evaluate(free_rolling=value)


@pytest.mark.parametrize("value", [1, np.float32(1.0), np.int64(1), np.array(1.0), Fraction(1)])
def test_numbers_of_every_kind_are_numbers(value):
    """One micrometre, and one of a million."""
    expected = SYSTEM.evaluate(1e-6)
    np.testing.assert_array_equal(
        SYSTEM.evaluate(
            value * Fraction(1, 10**6) if isinstance(value, Fraction) else float(value) * 1e-6
        ).values,
        expected.values,
    )
    assert SYSTEM.evaluate(yaw=value, lateral_shift=0.0).inputs.yaw == 1.0
    assert SYSTEM.evaluate_many([0.0], yaw=value).inputs.yaw.tolist() == [1.0]


@pytest.mark.parametrize("value", ["0.0001", True, (True, 1e-5)])
def test_a_penetration_is_a_number(value):
    with pytest.raises(ValueError, match="^penetration"):
        SYSTEM.evaluate(0.0, penetration=value)


@pytest.mark.parametrize("value", ["1.435", True, b"1.435", np.True_, None])
def test_a_parameter_is_a_number(value):
    with pytest.raises(ValueError, match=r"^gauge is .*; permitted is 0.5 ... 2 m$"):
        ContactSystem(gauge=value)
    with pytest.raises(ValueError, match=r"^gauge is "):
        wrcontact.Track(gauge=value)


# --- inclinations -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "text, value", [("1:40", 1 / 40), ("1/20", 1 / 20), (" 1 : 30 ", 1 / 30), ("0.05", 0.05), ("0", 0.0)]
)
def test_an_inclination_may_be_a_ratio(text, value):
    assert wrcontact.Track(rail_inclination=text).rail_inclination == value
    assert wrcontact.ProfileFile("rail.csv", file_inclination=text).file_inclination == value
    given = {"rail_inclination": (text, "1:25")}
    found, _ = checked_parameters(given, {"track": wrcontact.Track(rail_inclination=1 / 25)})
    assert (found["left_rail_inclination"], found["rail_inclination"]) == (value, 1 / 25)


def test_an_inclination_as_a_ratio_is_that_of_the_rail():
    states = [
        ContactSystem(normal_model="hertz", rail_inclination=value).evaluate(1e-3) for value in ("1:20", 0.05)
    ]
    np.testing.assert_array_equal(states[0].values, states[1].values)


@pytest.mark.parametrize("value", ["1:0", "one in forty", "40", 40, "1:40:2", ""])
def test_another_inclination_is_refused(value):
    with pytest.raises(ValueError) as refusal:
        ContactSystem(rail_inclination=value)
    hint = "; did you mean 1:40?" if value in (40, "40") else ""
    assert str(refusal.value) == (
        f"rail_inclination is {value!r}; permitted is 0 ... 0.1, or a ratio such as '1:40'{hint}"
    )


def test_a_value_in_another_unit_is_guessed():
    """Of lengths alone, and only where the guess is permitted."""
    for given, words in (
        ({"nominal_radius": 460}, "permitted is 0.1 ... 1 m; did you mean 460 mm, which is 0.46 m?"),
        ({"gauge": 1435}, "did you mean 1435 mm, which is 1.435 m?"),
        ({"gauge": 20.0}, "permitted is 0.5 ... 2 m"),
        ({"poisson_ratio": 28}, "permitted is 0 ... 0.499"),
    ):
        with pytest.raises(ValueError) as refusal:
            ContactSystem(**given)
        assert str(refusal.value).endswith(words), given


def test_a_pair_says_both_sides():
    """None would be the default on one side and the value of the other one on the other side."""
    for given in ({"rail": (None, "60E1")}, {"nominal_radius": (0.46, None)}):
        with pytest.raises(
            ValueError, match="which says nothing of one side; permitted is a value for each side"
        ):
            ContactSystem(**given)


# --- warnings ---------------------------------------------------------------------------------------------


def line():
    """The number of the caller's line."""
    return sys._getframe(1).f_lineno


HEAVY = {"normal_force": 78.5e6}


def noisy_wheel(folder):
    """The path of a file that is smoothed, with a remark."""
    path = folder / "noisy.txt"
    path.write_text(columns(*noisy("wheel", 0.02, 5)), encoding="utf-8")
    return path


@pytest.mark.parametrize("normal_force", [78.5e6, 0.785])
def test_an_unusual_load_is_warned_of_by_keyword_and_by_place(normal_force):
    for arguments, inputs in (((), {"normal_force": normal_force}), ((0.0, 0.0, normal_force), {})):
        with pytest.warns(wrcontact.UnusualValueWarning, match="normal_force is"):
            ContactSystem(normal_model="hertz").evaluate(*arguments, **inputs)


def test_warnings_point_to_the_line_of_the_user():
    """At every door, and never into the package; a system warns once of an input."""
    compliant = ContactSystem(contact_mode="compliant", normal_model="hertz")
    high = {"vertical_shift_input": 1e-4, **HEAVY}
    with warnings.catch_warnings(record=True) as given:
        warnings.simplefilter("always")
        lines = [line() + 1]
        system = ContactSystem(nominal_radius=0.9)
        lines.append(line() + 1)
        ContactSystem().evaluate(0.0, **HEAVY)
        lines.append(line() + 1)
        ContactSystem().evaluate(0.0, outputs=["roll"], **HEAVY)
        lines.append(line() + 1)
        ContactSystem().evaluate_many([0.0], **HEAVY)
        lines.append(line() + 1)
        parts = ContactSystem().evaluate_parts([0.0], **HEAVY)
        lines.append(line() + 1)
        state = compliant.evaluate(0.0, **high)
        lines.append(line() + 1)
        assert state.equilibrium.status == wrcontact.Status.OFF_PROFILE
    assert [(one.filename, one.lineno) for one in given] == [(__file__, number) for number in lines]
    assert {one.category for one in given} == {wrcontact.UnusualValueWarning}
    assert len(list(parts)) == 1 and system.centre_height == 0.9


def test_a_repaired_profile_is_warned_of_at_the_line_of_the_user(tmp_path):
    path = noisy_wheel(tmp_path)
    for door in (lambda: ContactSystem(wheel=str(path)), lambda: wrcontact.Profile.from_file(path, "wheel")):
        with pytest.warns(wrcontact.ProfileWarning) as given:
            door()
        assert {one.filename for one in given} == {__file__}


def test_a_system_that_is_made_again_does_not_warn_again(tmp_path):
    """Neither in another process nor for its equilibrium is a file read again; it may be gone."""
    path = noisy_wheel(tmp_path)
    with pytest.warns(wrcontact.ProfileWarning):
        system = ContactSystem(wheel=str(path), contact_mode="compliant", nominal_radius=0.46)
    path.unlink()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        again = pickle.loads(pickle.dumps(system))
        state = again.evaluate(1e-3, vertical_shift_input=2e-4)
        assert np.isfinite(state.equilibrium.vertical_shift)
    assert repr(again) == repr(system)
    np.testing.assert_array_equal(state.values, system.evaluate(1e-3, vertical_shift_input=2e-4).values)


# --- the package ------------------------------------------------------------------------------------------


def test_the_package_shows_what_is_meant_for_users():
    shown = [name for name in dir(wrcontact) if not name.startswith("__")]
    rooms = {"conditioning", "export", "fleet", "halfspace", "plots", "study", "track", "wear"}
    assert set(shown) == set(wrcontact.__all__) | rooms
    assert all(getattr(wrcontact, name) is not None for name in shown)
    modules = {name for name in shown if inspect.ismodule(getattr(wrcontact, name))}
    assert modules == rooms
