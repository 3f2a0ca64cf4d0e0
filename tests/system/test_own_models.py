"""Models of contact that are functions of Python."""

import pickle
from math import pi, sqrt

import numpy as np
import pytest

import wrcontact
from tests.helpers.paths import ROOT
from wrcontact import ContactSystem
from wrcontact.kernel.creep.polach import solve_polach
from wrcontact.kernel.normal.hertz_contact import hertz_contact

ROLLING = {"lateral_shift": 2e-3, "yaw": 1e-3, "speed": 20.0, "wheel_rate": 43.5}
MODULUS = 210e9 / (2 * (1 - 0.28**2))  # [Pa] contact modulus E*


@pytest.fixture(scope="module")
def page():
    """The functions of own_model.md."""
    text = (ROOT / "docs/guides/own_model.md").read_text(encoding="utf-8").partition("## Into the kernel")[0]
    found = {}
    for block in text.split("```python\n")[1:]:
        exec(block.partition("```")[0], found)
    return found


def hertz(*arguments):
    return hertz_contact(*arguments)


def polach(*arguments):
    return solve_polach(*arguments)


@pytest.mark.parametrize("mode", ["rigid", "elastic"])
def test_functions_that_are_the_kernel_s_models_give_their_bits(mode):
    kernel = ContactSystem(normal_model="hertz", tangential_model="polach", contact_mode=mode)
    own = ContactSystem(normal_model=hertz, tangential_model=polach, contact_mode=mode)
    np.testing.assert_array_equal(own.evaluate(**ROLLING).values, kernel.evaluate(**ROLLING).values)


def test_a_function_is_called_for_its_system_alone():
    """... also where it evaluates another one, and after an error in it."""
    calls = []

    def force(tables, patch):
        calls.append(1)
        assert plain.evaluate(**ROLLING).values.tobytes() == before.values.tobytes()
        return -1e5 * patch.creepage_x, -1e5 * patch.creepage_y, -7.0 * patch.spin

    plain = ContactSystem(normal_model="hertz", tangential_model="polach")
    before = plain.evaluate(**ROLLING)
    state = ContactSystem(tangential_model=force).evaluate(**ROLLING)
    assert len(calls) == 2  # wheels
    for side in (state.left, state.right):
        found, slip = side.patches[0].tangential, side.patches[0].creepage
        assert found.x == pytest.approx(-1e5 * slip.x, rel=1e-12) != 0.0
        assert abs(found.y) == pytest.approx(1e5 * abs(slip.y), rel=1e-12) != 0.0
        assert abs(found.moment) == pytest.approx(7.0 * abs(slip.spin), rel=1e-12) != 0.0

    def wrong(tables, patch):
        raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine"):
        ContactSystem(tangential_model=wrong).evaluate(**ROLLING)
    assert plain.evaluate(**ROLLING).values.tobytes() == before.values.tobytes()


def test_the_creep_force_of_the_page(page):
    """Linear theory at small creepages, as Polach's formula has it; friction times load at large ones."""
    patch = wrcontact.elliptic_patch(half_length=6e-3, half_width=4e-3, normal_force=80e3)
    small, large = (
        wrcontact.creep_forces(patch, creepage, tangential_model=page["johnson_vermeulen"])
        for creepage in (1e-7, 0.5)
    )
    linear = wrcontact.creep_forces(patch, 1e-7, tangential_model="polach")
    assert small.x == pytest.approx(linear.x, rel=1e-3) and small.y == 0.0
    assert (large.x, large.y) == (pytest.approx(-24e3), 0.0)


@pytest.mark.parametrize("mode", ["rigid", "elastic"])
def test_the_circle_of_the_page_is_the_closed_form(page, mode):
    system = ContactSystem(normal_model=page["equivalent_circle"], contact_mode=mode)
    side = system.evaluate(lateral_shift=2e-3, normal_force=90e3).right
    radius = 1 / sqrt(side.curvature_x * side.curvature_y)
    half = (0.75 * side.normal_force * radius / MODULUS) ** (1 / 3)
    assert side.normal_force == pytest.approx(90e3, rel=1e-6)
    assert side.penetration == pytest.approx(half**2 / radius, rel=1e-6)
    assert side.patches[0].width == pytest.approx(2 * half, rel=1e-6) == side.patches[0].length
    assert side.max_pressure == pytest.approx(1.5 * 90e3 / (pi * half**2), rel=1e-5)


def test_what_a_function_cannot_do_is_reported():
    own = ContactSystem(tangential_model=polach)
    with pytest.raises(RuntimeError, match="no derivatives, since the kernel runs uncompiled"):
        own.derivatives(["force.y"], ["yaw"])
    with pytest.raises(ValueError, match="tangential_model is the function 'polach'; permitted in a sweep"):
        wrcontact.sweep(own, {"yaw": [0.0, 1e-3]})
    with pytest.raises(ValueError, match="normal_model is 'halfspace', but tangential_model is a function"):
        ContactSystem(normal_model="halfspace", tangential_model=polach)
    with pytest.raises(ValueError, match="tangential_model is 'halfspace', but normal_model is a function"):
        ContactSystem(normal_model=hertz, tangential_model=wrcontact.HalfspaceRolling())
    with pytest.raises(ValueError, match="normal_model is <class .*; permitted are 'analyn'"):
        ContactSystem(normal_model=wrcontact.Hertz)
    with pytest.raises(ValueError, match="tangential_model returned 1 numbers; permitted are None"):
        ContactSystem(tangential_model=lambda tables, patch: (1.0,)).evaluate(**ROLLING)


def test_a_system_with_a_function_survives_pickling():
    own = ContactSystem(normal_model=hertz, tangential_model=polach)
    again = pickle.loads(pickle.dumps(own))
    assert again.evaluate(**ROLLING).values.tobytes() == own.evaluate(**ROLLING).values.tobytes()
    stepper = pickle.loads(pickle.dumps(own.stepper()))
    assert stepper.step() == 0 and not stepper.compiled
