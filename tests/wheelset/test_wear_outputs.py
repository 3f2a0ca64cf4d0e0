"""Outputs of wear: where a station or a strip lies on both profiles, and its part of the friction power."""

import itertools

import numpy as np
import pytest

from data import brute_force
from tests.helpers.cases import CREEP_MODELS, MODELS, system
from tests.helpers.kernel_runs import needs_library
from wrcontact import ContactSystem, WheelContact
from wrcontact.interface.outputs import STRIPS, WEAR
from wrcontact.kernel import layout
from wrcontact.kernel.wheelset.distributed_power import add_power

MOTION = {"speed": 20.0, "lateral_velocity": 0.05, "yaw_rate": 0.02}
TWO_PATCHES = {"lateral_shift": 6.2e-3, "yaw": 0.01, **MOTION}
#: Rounding of sums [relative].
EXACT = 1e-12
#: Locked, skidding and driven wheels, and with the rest of the motion.
SHIFTS, YAWS = np.random.default_rng(28).uniform((-6.6e-3, -0.02), (6.6e-3, 0.02), (12, 2)).T


def worn(**parameters):
    return system(wear_outputs=True, **parameters)


def weights(places):
    """Those of the trapezoidal rule (n,)."""
    cells = np.diff(places)
    return 0.5 * (np.append(cells, 0.0) + np.append(0.0, cells))


def wheels(state):
    return state.left, state.right


@pytest.mark.parametrize("stations", [3, 31, 200])
@pytest.mark.parametrize("normal, model", [*itertools.product(MODELS, ("none", *CREEP_MODELS))])
def test_stations_and_strips_have_all_the_power(normal, model, stations):
    """The trapezoidal sum over the stations is the power of the wheel, that over the stations of a patch the
    power of the patch, and so is the sum over its strips, which carry its load."""
    contact = worn(normal_model=normal, tangential_model=model, stations=stations)
    for shift, yaw in zip(SHIFTS[:4], YAWS):
        for wheel in wheels(contact.evaluate(shift, yaw, **MOTION)):
            line, size = wheel.outline, EXACT * wheel.friction_power
            assert abs(np.trapezoid(line.power, line.station) - wheel.friction_power) <= size, (shift, yaw)
            for k, (strips, patch) in enumerate(zip(wheel.strips, wheel.patches, strict=True)):
                assert abs(strips.power @ strips.width - patch.friction_power) <= size, (shift, yaw)
                assert strips.line_load @ strips.width == pytest.approx(patch.normal_force, rel=EXACT)
                assert strips.width.sum() == pytest.approx(patch.width, rel=EXACT)
                own = line.patch_of == k + 1
                if own.any():
                    found = (line.power * weights(line.station))[own].sum()
                    assert abs(found - patch.friction_power) <= size, (shift, yaw, k)
            assert (wheel.friction_power > 0.0) == (model != "none")


@pytest.mark.parametrize(
    "start, stop, wanted",
    [
        (-2e-3, 3e-3, None),
        (0.2e-3, 0.7e-3, None),
        (-10e-3, 10e-3, None),
        (10e-3 + 1e-12, 11e-3, {20: 1.0}),  # beside the outline, as by rounding
        (-11e-3, -10e-3 - 1e-12, {0: 1.0}),
    ],
)
def test_the_power_of_a_strip_has_its_place_among_the_stations(start, stop, wanted):
    """Stations are a millimetre apart: those around a strip have all of its power, about its middle."""
    work, stations = layout.Work.at(np.zeros(layout.WORK_SIZE)), 21
    side, strip = work.sides[0], work.patch.strips[0]
    places = np.linspace(-10e-3, 10e-3, stations)
    side.outline.numbers[:stations] = list(places)
    strip.start, strip.stop, strip.width = start, stop, stop - start
    add_power(side.wear, side.outline, stations, 1.0, strip, 7.0)
    found = np.array(side.wear.numbers[2 * stations : 3 * stations])
    power = 7.0 * strip.width
    if wanted is None:
        assert found.sum() == pytest.approx(power, rel=1e-12)
        assert found @ places == pytest.approx(power * 0.5 * (start + stop), abs=1e-15)
        near = (places > start - 1e-3) & (places < stop + 1e-3)
        assert np.all(found[~near] == 0.0) and np.all(found >= 0.0)
    else:
        assert {int(k): found[k] / power for k in np.flatnonzero(found)} == pytest.approx(wanted)


def test_power_is_friction_times_pressure_times_slip():
    """Of a locked wheel; and the mean place of the power is that of the strips."""
    contact = worn(tangential_model="strips")
    state = contact.evaluate(2e-3, speed=20.0, free_rolling=False)
    for wheel in wheels(state):
        (strips,), line = wheel.strips, wheel.outline
        np.testing.assert_allclose(strips.power, 0.3 * strips.line_load * strips.slip, rtol=2e-3)
        np.testing.assert_allclose(strips.slip, 20.0, rtol=2e-3)
        middle = 0.5 * (np.cumsum(strips.width) + np.cumsum(np.append(0.0, strips.width[:-1])))
        place = line.station[0] + middle
        wanted = (strips.power * strips.width) @ place / wheel.friction_power
        found = (line.power * weights(line.station)) @ line.station / wheel.friction_power
        assert found == pytest.approx(wanted, abs=1e-12)


def test_polach_spreads_power_like_the_pressure():
    wheel = worn(tangential_model="polach").evaluate(3e-3, **MOTION).right
    (strips,) = wheel.strips
    np.testing.assert_allclose(
        strips.power, strips.line_load * wheel.friction_power / wheel.normal_force, rtol=1e-12
    )
    assert not strips.slip.any()


# --- places ---------------------------------------------------------------------------------------------


def distances(state, side, yaw, wheel_places, rail_places):
    """How far the circles of the wheel at ``wheel_places`` are from the rail's lines at ``rail_places`` (n,)
    [m], by points of the circles in the track frame."""
    sign = 1.0 if side == "right" else -1.0
    track = brute_force.track("UIC60", 0.025)
    pose = brute_force.Pose(
        sign * state["lateral_shift"], sign * yaw, sign * state.roll, state.vertical_shift
    )
    angle = np.linspace(-0.08, 0.08, 3201)
    radius = track.nominal_radius + track.wheel(wheel_places)[0]
    points = np.stack(
        [
            radius[:, None] * np.sin(angle),
            np.broadcast_to((track.half_distance + wheel_places)[:, None], (len(radius), len(angle))),
            radius[:, None] * np.cos(angle),
        ],
        axis=-1,
    ) @ pose.rotation().T + pose.centre(track)
    away = np.hypot(
        points[..., 1] - (track.rail_origin + rail_places)[:, None],
        points[..., 2] - track.rail(rail_places)[0][:, None],
    )
    return away.min(axis=1)


@pytest.mark.parametrize("mode, normal", [*itertools.product(("rigid", "elastic", "compliant"), MODELS)])
def test_places_lie_on_both_surfaces(mode, normal):
    """No farther from each other than the wheel is pressed: the overlap of a pressed wheel, or the gap of a
    wheel that just touches, where it is loaded.  0.3 um are the points of the circles.  Hertz's ellipse knows
    the curvatures at the contact point alone, and in the flange root reaches to where both are farther."""
    reach = 1.3 if normal == "hertz" else 1.02
    contact = worn(contact_mode=mode, normal_model=normal)
    for shift, yaw in zip(SHIFTS, YAWS):
        given = {}
        if mode == "compliant":
            stand = system(contact_mode="elastic", normal_model=normal).evaluate(shift, yaw)
            given = {"vertical_shift_input": stand.vertical_shift, "roll_input": stand.roll}
        state = contact.evaluate(shift, yaw, **given)
        for side in ("left", "right"):
            wheel = getattr(state, side)
            line = wheel.outline
            loaded = line.pressure > 0.0
            away = distances(state, side, yaw, line.wheel_place[loaded], line.rail_place[loaded])
            assert (away < reach * wheel.penetration + 3e-7).all(), (shift, yaw, side, away.max())
            for strips in wheel.strips:
                away = distances(state, side, yaw, strips.wheel_place, strips.rail_place)
                assert (away < reach * wheel.penetration + 3e-7).all(), (shift, yaw, side, away.max())


@pytest.mark.parametrize("normal", MODELS)
def test_places_rise_along_the_stations_through_the_contact_point(normal):
    """And pass through the contact point where the station is zero."""
    for shift, yaw in zip(SHIFTS, YAWS):
        state = worn(normal_model=normal, contact_mode="elastic").evaluate(shift, yaw)
        for wheel in wheels(state):
            line = wheel.outline
            if len(wheel.patches) == 1:
                assert (np.diff(line.wheel_place) > 0.0).all() and (np.diff(line.rail_place) > 0.0).all()
                # a chord over a station of an arc of 13 mm radius
                for place, point in (
                    (line.wheel_place, wheel.contact.y_wheel),
                    (line.rail_place, wheel.contact.y_rail),
                ):
                    assert np.interp(0.0, line.station, place) == pytest.approx(point, abs=2e-5)


def test_rolled_rails_carry_their_profile_with_them():
    """Wheelset and rails that roll together about the track's origin leave the places where they are, but for
    what the wheel's own roll differs by."""
    still = worn().evaluate(2e-3)
    moved = worn().evaluate(2e-3, left_rail_lateral=1e-3, right_rail_lateral=1e-3)
    shifted = worn().evaluate(1e-3)
    for one, other in zip(wheels(moved), wheels(shifted)):
        np.testing.assert_allclose(one.outline.rail_place, other.outline.rail_place, atol=1e-9)
        np.testing.assert_allclose(one.outline.wheel_place, other.outline.wheel_place, atol=1e-9)
    rolled = worn(contact_mode="elastic").evaluate(2e-3, right_rail_roll=5e-3)
    line = rolled.right.outline
    place = np.interp(0.0, line.station, line.rail_place)
    assert place == pytest.approx(rolled.right.contact.y_rail, abs=1e-5)
    assert abs(place - still.right.contact.y_rail) > 1e-4


@needs_library
def test_rates_of_places_and_power():
    """Those of the differentiated kernel, against differences."""
    contact = worn(tangential_model="strips")
    names = [f"right.{name}[{j}]" for name in ("wheel_place", "rail_place", "power") for j in (8, 16, 24)]
    rates = contact.derivatives(
        names, ["lateral_shift", "right.friction"], lateral_shift=2e-3, yaw=2e-3, **MOTION
    )
    for column, (name, step) in enumerate((("lateral_shift", 1e-7), ("right_friction", 1e-5))):
        start = {"lateral_shift": 2e-3, "right_friction": 0.3}
        high, low = (
            contact.evaluate(yaw=2e-3, **MOTION, **{**start, name: start[name] + way * step})
            for way in (1, -1)
        )
        wanted = np.array([(high[one] - low[one]) / (2 * step) for one in names])
        size = np.repeat(np.abs(wanted).reshape(3, 3).max(axis=1), 3)
        found = rates[:, column]
        assert (np.abs(found - wanted) <= 2e-5 * size + 1e-9).all(), (name, found, wanted)


# --- what is there, and what is not ---------------------------------------------------------------------


@pytest.mark.parametrize("stations", [7, 31])
@pytest.mark.parametrize("model", ("none", "strips"))
def test_everything_else_keeps_its_bits(model, stations):
    """Outputs of wear follow all others, which are as without them; without them nothing follows."""
    plain = ContactSystem(tangential_model=model, stations=stations)
    more = ContactSystem(tangential_model=model, stations=stations, wear_outputs=True)
    one, other = plain.evaluate(**TWO_PATCHES), more.evaluate(**TWO_PATCHES)
    size = len(one.values)
    np.testing.assert_array_equal(other.values[:size], one.values)
    assert other.names[: len(one.names)] == one.names
    assert len(other.names) == len(one.names) + 2 * len(WEAR) * stations
    assert other["right.power[3]"] == other.right.outline.power[2]
    for name in (row.name for row in WEAR):
        with pytest.raises(AttributeError, match=f"{name} is not computed; it needs .*wear_outputs=True"):
            getattr(one.right.outline, name)
    with pytest.raises(AttributeError, match="strips are not computed; they need .*wear_outputs=True"):
        _ = one.right.strips
    assert "wheel_place" in other.to_dict()["right"]["outline"] and "strips" not in one.to_dict()["right"]
    assert len(other.to_dict()["right"]["strips"]) == 2


@pytest.mark.parametrize("stations", [7, 31])
def test_tables_hold_what_single_poses_have(stations):
    contact = worn(tangential_model="strips", stations=stations)
    shifts = [0.0, 6.2e-3, np.nan]
    given = {**TWO_PATCHES, "lateral_shift": shifts}
    table, right = contact.evaluate_many(**given), contact.evaluate_many(**given, side="right")
    some = contact.evaluate_many(**given, outputs=["right.power"])
    for row in (0, 1):
        state = contact.evaluate(**{**given, "lateral_shift": shifts[row]})
        for name in (one.name for one in WEAR):
            wanted = getattr(state.right.outline, name)
            np.testing.assert_array_equal(getattr(table.right.outline, name)[row], wanted)
            np.testing.assert_array_equal(getattr(right.right.outline, name)[row], wanted)
        np.testing.assert_array_equal(some.right.outline.power[row], state.right.outline.power)
        for k, strips in enumerate(state.right.strips):
            for name in (one.name for one in STRIPS):
                wanted = getattr(strips, name)
                assert wanted.shape == (16,)
                np.testing.assert_array_equal(getattr(table.right.strips[k], name)[row], wanted)
                np.testing.assert_array_equal(getattr(right.right.strips[k], name)[row], wanted)
                np.testing.assert_array_equal(getattr(table[row].right.strips[k], name), wanted)
    assert np.isnan(table.right.strips[0].power[2]).all() and np.isnan(table.right.outline.power[2]).all()
    assert not table.right.strips[1].width[0].any()
    assert np.isnan(right.left.outline.power).all() and np.isnan(some.right.outline.rail_place).all()


def test_without_load_all_is_zero_and_what_is_not_wanted_is_not_a_number():
    state = worn(tangential_model="strips").evaluate(1e-3, load_transfer=1.0, **MOTION)
    for name in (row.name for row in WEAR):
        assert not getattr(state.left.outline, name).any()
    assert state.left.strips == () and len(state.right.strips) == 1
    patches = worn(tangential_model="strips").evaluate(1e-3, outputs="patches", **MOTION)
    assert np.isnan(patches.right.outline.power).all() and np.isnan(patches.right.strips[0].width).all()
    assert patches.right.friction_power > 0.0


def test_one_wheel_has_them():
    pose = {"lateral_shift": 3e-3, "vertical_shift_input": 1.2e-4, **MOTION}
    wheel = WheelContact(tangential_model="strips", wear_outputs=True).evaluate(**pose)
    whole = worn(contact_mode="compliant", tangential_model="strips").evaluate(**pose).right
    np.testing.assert_array_equal(wheel.outline.wheel_place, whole.outline.wheel_place)
    np.testing.assert_array_equal(wheel.strips[0].power, whole.strips[0].power)
    assert wheel["power[5]"] == whole.outline.power[4] > 0.0


@pytest.mark.parametrize("wrong", [1, "yes", None])
def test_wrong_values_are_refused(wrong):
    with pytest.raises(ValueError, match="wear_outputs is .*; permitted is True or False"):
        ContactSystem(wear_outputs=wrong)
