"""A step on rails whose section changes: against constant rails, turned ones, and closed forms."""

from functools import cache
from math import atan, cos, hypot, sin, sqrt

import numpy as np
import pytest

from tests.helpers.sections import moved, stepped, stepper_on
from wrcontact import ContactSystem, Profile, RailSections
from wrcontact.profiles.zones import Polynomial

MODELS = "hertz", "analyn", "analyn_strip"


@cache
def system(model="analyn", mode="rigid", **more):
    return ContactSystem(rail_inclination=0.0, normal_model=model, contact_mode=mode, **more)


def assert_alike(found, wanted, share, length, side=""):
    """All outputs of a ``side`` within a ``share`` of them, lengths within ``length`` [m], but for the outline and the slope."""
    force = max(abs(wanted["right.normal_force"]), 1.0)
    for name, value in wanted.items():
        if not name.startswith(side) or "station" in name or name.endswith("]") or name.endswith("slope"):
            continue
        least = force if "force" in name or "moment" in name else length / share
        assert found[name] == pytest.approx(value, rel=share, abs=share * least), name


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize(
    "pose",
    [(0.0, 0.0), (2e-3, 0.01), (-4e-3, -0.004), (5.5e-3, -0.02)],
    ids=lambda pose: f"{1e3 * pose[0]:g}mm",
)
def test_equal_slices_are_the_constant_rail(pose, model):
    inputs = dict(lateral_shift=pose[0], yaw=pose[1])
    status, wanted = stepped(system(model).stepper(), **inputs)
    found = stepped(stepper_on(system(model), moved([0.0, 0.5])), track_position=0.2, **inputs)
    assert (found[0], status) == (0, 0)
    assert_alike(found[1], wanted, 5e-9 if model != "hertz" else 2e-6, 1e-10)


@pytest.mark.parametrize("model", MODELS)
def test_equal_slices_are_the_constant_rail_under_a_compliant_wheelset(model):
    inputs = dict(lateral_shift=1.5e-3, yaw=6e-3, vertical_shift_input=-4.2e-4 + 1e-4, roll_input=-3e-4)
    compliant = system(model, "compliant")
    inputs["vertical_shift_input"] = compliant.evaluate(
        **inputs | {"vertical_shift_input": 0.0}
    ).vertical_shift
    rigid = system(model).evaluate(lateral_shift=1.5e-3, yaw=6e-3)
    inputs |= {"vertical_shift_input": rigid.vertical_shift + 1.1e-4, "roll_input": rigid.roll}
    status, wanted = stepped(compliant.stepper(), **inputs)
    found = stepped(stepper_on(compliant, moved([0.0, 0.5])), track_position=0.2, **inputs)
    assert (found[0], status) == (0, 0)
    assert_alike(found[1], wanted, 5e-8, 1e-10)


def head(across=1.0, down=1.0):
    """A head that is a polynomial, scaled across and down [mm]."""
    return Profile(
        "own",
        "rail",
        (
            Polynomial(
                -36.0 * across,
                36.0 * across,
                (0.0, 0.0, 4e-3 * down / across**2, 0.0, 2e-5 * down / across**4),
            ),
        ),
    )


def same_contact(one, other, factor_y=1.0):
    """Load, area and pressure of the right wheel."""
    for name in ("normal_force", "area", "max_pressure", "patch_length", "penetration"):
        yield one[f"right.{name}"], other[f"right.{name}"], name


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("rate", [0.02, -0.1])
def test_a_rail_that_moves_is_a_narrower_one_under_a_turned_wheelset(rate, model):
    """By the angle a of its way: the section times cos(a), yaw less by a."""
    turn, u, shift, yaw, roll = atan(rate), 0.07, 2e-3, 0.01, 1e-3
    narrow = cos(turn)
    at = np.linspace(-0.3, 0.3, 7)
    straight = ContactSystem(
        rail=head(narrow), rail_inclination=0.0, normal_model=model, contact_mode="compliant"
    )
    lateral = straight.profile_tables()[2] / narrow - rate * u
    moving = RailSections(at, [head()] * 7, places=np.column_stack([rate * at, 0.0 * at]))
    stepper = stepper_on(straight, moving, lateral=lateral)
    height = straight.evaluate(
        side="right",
        lateral_shift=narrow * shift,
        yaw=yaw - turn,
        roll_input=roll,
        vertical_shift_input=-1e-2,
    )
    wanted = None
    for depth in np.arange(-4e-3, 4e-3, 5e-5):
        inputs = dict(roll_input=roll, vertical_shift_input=depth)
        status, wanted = stepped(
            straight.stepper("right"), lateral_shift=narrow * shift, yaw=yaw - turn, **inputs
        )
        if status == 0 and wanted["right.normal_force"] > 4e4:
            break
    found = stepped(stepper, track_position=u, lateral_shift=shift, yaw=yaw, **inputs)
    assert found[1]["right.normal_force"] > 4e4
    for one, other, name in same_contact(found[1], wanted):
        assert one == pytest.approx(other, rel=1e-6), name
    force = [found[1][f"right.force.{axis}"] for axis in "xyz"]
    plain = [wanted[f"right.force.{axis}"] for axis in "xyz"]
    # turned by a about the vertical
    assert force[0] == pytest.approx(-sin(turn) * plain[1], rel=1e-6)
    assert force[1] == pytest.approx(cos(turn) * plain[1], rel=1e-6)
    assert force[2] == pytest.approx(plain[2], rel=1e-6)
    moment = [found[1][f"right.moment.{axis}"] for axis in "xyz"]
    turned = [wanted[f"right.moment.{axis}"] for axis in "xyz"]
    assert height.status is not None
    size = hypot(*turned)
    assert moment[0] == pytest.approx(cos(turn) * turned[0] - sin(turn) * turned[1], abs=1e-6 * size)
    assert moment[1] == pytest.approx(sin(turn) * turned[0] + cos(turn) * turned[1], abs=1e-6 * size)
    assert moment[2] == pytest.approx(turned[2], abs=1e-6 * size)
