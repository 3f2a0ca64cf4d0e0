"""Outlines with other numbers of stations than 31: the kernel's own evaluation at each, everything
else to the last bit."""

import math

import numpy as np
import pytest

from tests.helpers.cases import MODELS
from tests.helpers.inside import rates_along
from wrcontact import ContactSystem, Status
from wrcontact.kernel import layout
from wrcontact.kernel.binding.library import default_kernel
from wrcontact.results.layout import Layout
from wrcontact.state import WheelsetState

METHODS = {**{model: {"normal_model": model} for model in MODELS}, "elastic": {"contact_mode": "elastic"}}
NUMBERS = (3, 7, 61, 201)
RUNS = ("station", "half_length", "pressure")
SAME = 1e-12  # [relative to the largest]: where a station lies is rounded
TWO_PATCHES = {"lateral_shift": 6.2e-3, "yaw": 0.01}  # root and flange on the right
ONE_PATCH = {"lateral_shift": 2e-3}
SCALARS = np.ones(layout.OUTPUT_COUNT, dtype=bool)
for side in (layout.OUT_LEFT, layout.OUT_RIGHT):
    SCALARS[side + layout.SIDE_STATION : side + layout.SIDE_SIZE] = False


def sides(state):
    return state.left, state.right


def common_places(number):
    """Places of the stations that an outline of ``number`` and one of 31 have in common."""
    cells = math.gcd(number - 1, layout.STATION_COUNT - 1)
    return tuple(np.arange(cells + 1) * ((count - 1) // cells) for count in (number, layout.STATION_COUNT))


@pytest.mark.parametrize("pose", [ONE_PATCH, TWO_PATCHES], ids=["one patch", "two patches"])
@pytest.mark.parametrize("name", METHODS)
def test_common_stations_and_all_else_are_equal(name, pose):
    usual = ContactSystem(**METHODS[name]).evaluate(**pose)
    for number in NUMBERS:
        state = ContactSystem(stations=number, **METHODS[name]).evaluate(**pose)
        assert (state.values[: layout.OUTPUT_COUNT][SCALARS] == usual.values[SCALARS]).all()
        ours, theirs = common_places(number)
        for side, other in zip(sides(state), sides(usual)):
            for run in RUNS:
                found, wanted = getattr(side.outline, run), getattr(other.outline, run)
                assert found.shape == (number,)
                same = SAME * np.abs(wanted).max()
                np.testing.assert_allclose(found[ours], wanted[theirs], rtol=0.0, atol=same, err_msg=run)
            assert np.ptp(side.outline.station) == pytest.approx(side.patch_width, rel=SAME)
            assert (side.outline.half_length[[0, -1]] == 0.0).all()
            assert (side.outline.pressure[[0, -1]] == 0.0).all()


@pytest.mark.skipif(not default_kernel().compiled, reason="no compiled library here")
@pytest.mark.parametrize("pose", [ONE_PATCH, TWO_PATCHES], ids=["one patch", "two patches"])
@pytest.mark.parametrize("name", ("analyn", "analyn_strip", "hertz"))
def test_rates_of_common_stations_and_of_all_else_are_equal(name, pose):
    """An outline's edge, where half-length and pressure begin as a root, has no rate worth comparing."""

    def along_the_shift(number):
        stepper = ContactSystem(stations=number, **METHODS[name]).stepper()
        stepper.inputs[:] = 0.0
        stepper.inputs[[layout.IN_LATERAL_SHIFT, layout.IN_NORMAL_FORCE]] = pose["lateral_shift"], 78.5e3
        stepper.inputs[layout.IN_YAW] = pose.get("yaw", 0.0)
        stepper.step()
        return rates_along(stepper, np.eye(layout.INPUT_COUNT)[layout.IN_LATERAL_SHIFT])

    usual = along_the_shift(31)
    for number in NUMBERS:
        rates = along_the_shift(number)
        assert (rates[: layout.OUTPUT_COUNT][SCALARS] == usual[SCALARS]).all()
        ours, theirs = (places[1:-1] for places in common_places(number))
        ours_of = sides(WheelsetState(rates, 0, None, Layout(number)))
        for side, other in zip(ours_of, sides(WheelsetState(usual, 0, None))):
            for run in RUNS:
                found, wanted = getattr(side.outline, run), getattr(other.outline, run)
                np.testing.assert_allclose(
                    found[ours], wanted[theirs], rtol=0.0, atol=1e-9 * np.abs(wanted).max(), err_msg=run
                )


def test_stations_31_is_the_default_to_the_last_bit():
    usual, chosen = (
        ContactSystem().evaluate(**TWO_PATCHES),
        ContactSystem(stations=31).evaluate(**TWO_PATCHES),
    )
    assert usual.values.shape == chosen.values.shape and (usual.values == chosen.values).all()


def test_an_ellipse_at_every_station():
    state = ContactSystem(normal_model="hertz", stations=61).evaluate(**ONE_PATCH)
    for side in sides(state):
        height = np.sqrt(np.maximum(1.0 - (2.0 * side.outline.station / side.patch_width) ** 2, 0.0))
        np.testing.assert_allclose(
            side.outline.half_length, 0.5 * side.patch_length * height, atol=1e-7 * side.patch_length
        )
        np.testing.assert_allclose(
            side.outline.pressure, side.max_pressure * height, atol=1e-7 * side.max_pressure
        )


def trapezoid(values, stations):
    return float(np.sum(0.5 * (values[1:] + values[:-1]) * np.diff(stations)))


def misses(number, model="analyn", **pose):
    """By how much the outline's area and load fall short of each side's own [relative]."""
    missed = []
    for side in sides(ContactSystem(stations=number, normal_model=model).evaluate(**pose)):
        outline = side.outline
        area = trapezoid(2.0 * outline.half_length, outline.station)
        load = trapezoid(0.5 * np.pi * outline.half_length * outline.pressure, outline.station)
        missed.append((1.0 - area / side.area, 1.0 - load / side.normal_force))
    return np.array(missed)


def test_area_and_load_of_the_outline_tend_to_those_of_the_patch():
    """The trapezoidal rule over n cells misses n^-1.5 of a half-ellipse's area, whose edge is a root, and
    n^-2 of its load; the line load is the product of two interpolated roots, with an error of its own."""
    coarse, fine = misses(51, **ONE_PATCH), misses(201, **ONE_PATCH)
    assert (np.abs(fine) < 5e-4).all()
    np.testing.assert_allclose(coarse[:, 0] / fine[:, 0], 4.0**1.5, rtol=0.15)
    assert (np.abs(misses(201, **TWO_PATCHES)) < 2e-3).all()  # the inner edges lie between stations


@pytest.mark.parametrize("pose", [ONE_PATCH, TWO_PATCHES], ids=["one", "two"])
def test_the_outline_of_strips_has_nearly_their_area_and_load(pose):
    """Between the stations of strips squares follow straight lines, which miss 0.2 % of a patch."""
    assert (np.abs(misses(201, "analyn_strip", **pose)) < 3e-3).all()


def test_tables_of_poses():
    system = ContactSystem(stations=61)
    shift = np.array([0.0, 1e-3, math.nan, 6.2e-3])
    table = system.evaluate_many(lateral_shift=shift)
    assert table.right.outline.pressure.shape == (4, 61)
    assert np.isnan(table.right.outline.pressure[2]).all()
    assert np.isfinite(table.right.outline.pressure[[0, 1, 3]]).all()
    for row in (0, 1, 3):
        state = system.evaluate(lateral_shift=shift[row])
        for found, wanted in zip(sides(table), sides(state)):
            np.testing.assert_array_equal(found.outline.half_length[row], wanted.outline.half_length)


@pytest.mark.parametrize("model", [*MODELS, "halfspace"])
def test_what_is_not_wanted_is_not_a_number(model):
    system = ContactSystem(
        normal_model=model, stations=7, **({"tolerance": 0.03} if model == "halfspace" else {})
    )
    patches = system.evaluate(outputs="patches")
    assert all(np.isnan(side.outline.station).all() and side.area > 0.0 for side in sides(patches))
    left = system.evaluate(side="left")
    assert np.isfinite(left.left.outline.pressure).all() and np.isnan(left.right.outline.pressure).all()


def test_an_unloaded_wheel_has_an_empty_outline_and_an_invalid_step_keeps_the_last_one():
    stepper = ContactSystem(stations=61).stepper()
    stepper.inputs[:7] = 2e-3, 0.0, 0.0, 78.5e3, 0.0, 0.0, 0.0
    assert stepper.step() == Status.VALID
    valid = stepper.outputs.copy()
    runs = layout.RUN_COUNT * 61
    assert valid[-runs:].any() and valid.shape == (layout.OUTPUT_COUNT + 2 * runs,)
    stepper.inputs[0] = 0.02
    assert stepper.step() == Status.OFF_PROFILE and (stepper.outputs == valid).all()
    stepper.inputs[0], stepper.inputs[4] = 2e-3, -1.0
    assert stepper.step() == Status.UNLOADED
    left, right = stepper.outputs[-2 * runs : -runs], stepper.outputs[-runs:]
    assert left.any() and not right.any()


def test_halfspace_at_other_stations():
    usual, fine = (
        ContactSystem(normal_model="halfspace", tolerance=0.03, stations=number).evaluate()
        for number in (31, 61)
    )
    for side, other in zip(sides(fine), sides(usual)):
        assert side.area == other.area
        for run in RUNS:
            wanted = getattr(other.outline, run)
            np.testing.assert_allclose(
                getattr(side.outline, run)[::2], wanted, rtol=0.0, atol=SAME * np.abs(wanted).max()
            )


@pytest.mark.parametrize("wrong", [2, 0, 202, -31, 31.5, math.nan, "31", None, True])
def test_wrong_numbers_are_refused(wrong):
    with pytest.raises(ValueError, match=r"^stations is .+; permitted are whole numbers 3 \.\.\. 201$"):
        ContactSystem(stations=wrong)


def test_numpy_integers_are_numbers():
    system = ContactSystem(stations=np.int64(7))
    assert repr(system) == "ContactSystem(stations=7)"
    assert len(system.evaluate().left.outline.station) == 7
