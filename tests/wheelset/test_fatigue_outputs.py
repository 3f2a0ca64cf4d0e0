"""Outputs of rolling contact fatigue: those of wrcontact.fatigue, in a step; tests/wear has the published
values, tests/interface their witnesses."""

import numpy as np
import pytest

import wrcontact
from wrcontact import ContactSystem, WheelContact
from wrcontact.kernel.wheelset.fatigue import wear_number_damage
from wrcontact.wear.fatigue import wear_number_damage as damage_of_tables

#: Output of a patch, and what wrcontact.fatigue calls it.
NAMES = {
    "wear_number": "wear_number",
    "fatigue_damage": "damage",
    "shakedown_ratio": "shakedown_ratio",
    "surface_fatigue_index": "surface_fatigue_index",
}
MODEL = {"contact_mode": "elastic", "tangential_model": "strips"}


def poses(count=60):
    rng = np.random.default_rng(3)
    return {
        "lateral_shift": rng.uniform(-7e-3, 7e-3, count),
        "yaw": rng.uniform(-6e-3, 6e-3, count),
        "normal_force": rng.uniform(30e3, 110e3, count),
        "speed": 20.0,
    }


@pytest.mark.parametrize("yielding", [300e6, 250e6])
def test_a_step_has_what_tables_have(yielding):
    """Up to rounding: 1e-12 of each."""
    table = ContactSystem(**MODEL, fatigue_outputs=True, yield_shear=yielding).evaluate_many(**poses())
    found = wrcontact.fatigue(table, yield_shear=yielding)
    for name, known in NAMES.items():
        for k, side in enumerate(("left", "right")):
            for patch in range(3):
                wanted = np.nan_to_num(getattr(found, known)[:, k, patch])
                np.testing.assert_allclose(
                    table[f"{side}.patch[{patch + 1}].{name}"],
                    wanted,
                    rtol=1e-12,
                    atol=1e-17,
                    err_msg=f"{side} {patch} {name}",
                )
    used = found.damage[np.isfinite(found.damage)]
    assert np.sum(used > 0.0) > 20 and np.sum(found.surface_fatigue_index > 0.0) > 5
    assert np.sum(np.isfinite(found.damage)) > 120  # some wheels have two patches


def test_one_and_the_same_damage():
    numbers = np.linspace(0.0, 200.0, 401)
    assert [wear_number_damage(number) for number in numbers] == damage_of_tables(numbers).tolist()


def test_everything_else_keeps_its_bits():
    """And without the parameter these are zero."""
    plain, more = (
        ContactSystem(**MODEL, fatigue_outputs=asked).evaluate_many(**poses()) for asked in (False, True)
    )
    for name in plain.names:
        if name.rpartition(".")[2] in NAMES and ".patch[" in name:
            assert not plain[name].any()
        else:
            np.testing.assert_array_equal(more[name], plain[name], err_msg=name)


def test_patches_without_creep_forces_have_a_shakedown_ratio():
    """An ellipse with an index of -k / p0, and no wear number; what is not there is zero."""
    state = ContactSystem(normal_model="hertz", fatigue_outputs=True).evaluate(1e-3, load_transfer=1.0)
    patch = state.right.patches[0]
    assert patch.shakedown_ratio == pytest.approx(patch.max_pressure / 300e6, rel=1e-6)
    assert patch.surface_fatigue_index == pytest.approx(-1.0 / patch.shakedown_ratio, rel=1e-15)
    assert patch.wear_number == patch.fatigue_damage == 0.0
    assert [state[f"left.patch[1].{name}"] for name in NAMES] == [0.0] * 4


@pytest.mark.full
def test_the_half_space_has_them():
    """As tables have: 1e-12."""
    model = {"normal_model": "halfspace", "tolerance": 0.1, "tangential_model": "strips"}
    table = ContactSystem(**model, fatigue_outputs=True).evaluate_many([1e-3, 6.2e-3], yaw=3e-3, speed=20.0)
    found = wrcontact.fatigue(table)
    for name, known in NAMES.items():
        for k, side in enumerate(("left", "right")):
            np.testing.assert_allclose(
                table[f"{side}.patch[1].{name}"],
                getattr(found, known)[:, k, 0],
                rtol=1e-12,
                atol=1e-17,
                err_msg=f"{side} {name}",
            )
    assert (found.wear_number[:, :, 0] > 0.0).all() and (found.shakedown_ratio[:, :, 0] > 1.0).all()


def test_one_wheel_has_them():
    model = {"tangential_model": "strips", "fatigue_outputs": True, "yield_shear": 280e6}
    pose = {"lateral_shift": 3e-3, "vertical_shift_input": 1.2e-4, "yaw": 3e-3, "speed": 20.0}
    wheel = WheelContact(**model).evaluate(**pose).patches[0]
    whole = ContactSystem(**model, contact_mode="compliant").evaluate(**pose).right.patches[0]
    assert all(getattr(wheel, name) == getattr(whole, name) != 0.0 for name in NAMES)


def test_derivatives_are_differences():
    contact = ContactSystem(**MODEL, fatigue_outputs=True)
    pose = {"lateral_shift": 2e-3, "yaw": 1.5e-3, "speed": 20.0}
    outputs = [f"right.patch[1].{name}" for name in NAMES]
    found = contact.derivatives(of=outputs, by=["yaw", "normal_force"], **pose)
    for column, (name, step) in enumerate((("yaw", 1e-7), ("normal_force", 1.0))):
        middle = {"normal_force": 78.5e3, **pose}[name]
        low, high = (
            [contact.evaluate(**{**pose, name: middle + way * step})[output] for output in outputs]
            for way in (-1.0, 1.0)
        )
        wanted = (np.array(high) - low) / (2.0 * step)
        assert wanted.all()
        np.testing.assert_allclose(found[:, column], wanted, rtol=2e-4)


@pytest.mark.parametrize(
    "given, words",
    [
        ({"fatigue_outputs": 1}, "fatigue_outputs is 1; permitted is True or False"),
        ({"yield_shear": 0.0}, "yield_shear is 0.0; permitted is 1e\\+07 ... 1e\\+10 Pa"),
        ({"yield_shear": float("nan")}, "yield_shear is nan"),
    ],
)
def test_wrong_values_are_refused(given, words):
    with pytest.raises(ValueError, match=words):
        ContactSystem(**given)
