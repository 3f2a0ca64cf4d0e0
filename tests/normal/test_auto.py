"""The model "auto": ANALYN or strips by the estimate of ANALYN's error."""

import warnings
from functools import cache

import numpy as np
import pytest

import data
import wrcontact
from tests.helpers.constant_curvatures import lay_constant_curvatures
from tests.helpers.strips import random_poses
from wrcontact import Status
from wrcontact.kernel import layout
from wrcontact.kernel.normal.auto_contact import FIRST, FULL, strips_share
from wrcontact.kernel.normal.model_error import LEAST, RATE, STRIPS_MISS, analyn_error

MODELS = ("analyn", "analyn_strip", "auto")
WORN = (data.FOLDER / "measured" / "worn.whl", "60E1", 1 / 40)
NEW = ("S1002", "UIC60", 1 / 40)
PLACES = [layout.IN_LATERAL_SHIFT, layout.IN_YAW, layout.IN_NORMAL_FORCE]
NODES = 15  # whose window of curvature is 4 nodes


@cache
def system(wheel, rail, inclination, **options):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what the reader remarks on a measured file
        return wrcontact.ContactSystem(wheel=wheel, rail=rail, rail_inclination=inclination, **options)


# --- the estimate -----------------------------------------------------------------------------------------


def estimate(change):
    """The estimate on nodes of constant curvature whose B is multiplied by ``change`` (k), and its loads (n,)
    at the nodes k (n,)."""
    tables, work, penetration = lay_constant_curvatures(1.0, 1.5, 80e3)
    tables.nodes = NODES
    region, nodes = work.contact.regions[0], work.contact.nodes[0]
    region.local_penetration = penetration
    places = np.arange(int(region.first), int(region.last) + 1)
    loads = np.array([nodes.line[k] * max(penetration - nodes.rise[k], 0.0) for k in places])
    for k in places:
        nodes.B[k] *= change(k)
    return analyn_error(tables, work.contact.regions, work.contact.nodes, 1), places, loads


def test_constant_curvatures_leave_the_least():
    """There ANALYN is exact."""
    found, *_ = estimate(lambda k: 1.0)
    assert found == pytest.approx(LEAST, rel=1e-12)


def test_a_curvature_that_jumps_to_and_fro():
    """B is b and 3 b in turns of a window: c is |b - 6 b + b| / 8 b or |3 b - 2 b + 3 b| / 8 b, 1/2 each, but
    where the ends of the nodes cut a window off."""
    found, places, loads = estimate(lambda k: 3.0 if (k // 4) % 2 else 1.0)
    inner = (places - 4 >= places[0]) & (places + 4 <= places[-1])
    assert loads[~inner].sum() < 0.05 * loads.sum()
    assert found == pytest.approx(LEAST + 0.5 * RATE, rel=0.05)


def test_one_place_where_the_curvature_jumps():
    """B is doubled from node 3 on: within a window of it, c is 1/5 below and 1/7 above."""
    found, places, loads = estimate(lambda k: 2.0 if k >= 3 else 1.0)
    below, above = (places >= -1) & (places < 3), (places >= 3) & (places < 7)
    changes = (loads[below].sum() / 5 + loads[above].sum() / 7) / loads.sum()
    assert found == pytest.approx(LEAST + RATE * changes, rel=1e-9)


# --- the switch -------------------------------------------------------------------------------------------


def test_the_share_of_the_strips():
    assert [strips_share(e) for e in (0.0, FIRST, FULL, 1.0)] == [0.0, 0.0, 1.0, 1.0]
    assert strips_share(0.5 * (FIRST + FULL)) == pytest.approx(0.5)
    shares = [strips_share(e) for e in np.linspace(FIRST, FULL, 101)]
    assert np.all(np.diff(shares) > 0) and np.max(np.diff(shares)) < 0.0151  # 3/2 of a straight line


def tables_of_models(pair, rows, **options):
    """Outputs of all models at the same poses, and ANALYN's estimate with its left and right wheel."""
    found = {
        name: system(*pair, normal_model=name, **options).evaluate_many(*rows[:, PLACES].T) for name in MODELS
    }
    asked = system(*pair, error_outputs=True, **options).evaluate_many(*rows[:, PLACES].T)
    return found, asked


@pytest.mark.parametrize("pair", [NEW, WORN], ids=["new", "worn"])
def test_either_model_to_the_last_bit_and_both_between(pair):
    """In rigid contact, where the load is given."""
    found, asked = tables_of_models(pair, random_poses(400, 5, low=2e4))
    counts = np.zeros(3, int)
    for side in ("left", "right"):
        plain, strips, auto = (getattr(found[name], side) for name in MODELS)
        error = getattr(asked, side).model_error
        for kind, here, like in ((0, error <= FIRST, plain), (2, error >= FULL, strips)):
            counts[kind] += here.sum()
            for name in ("penetration", "area", "max_pressure", "patch_centroid", "patch_count"):
                np.testing.assert_array_equal(getattr(auto, name)[here], getattr(like, name)[here])
        between = (error > FIRST) & (error < FULL)
        counts[1] += between.sum()
        share = np.array([strips_share(e) for e in error])
        wanted = (1 - share) * plain.penetration + share * strips.penetration
        np.testing.assert_allclose(auto.penetration[between], wanted[between], rtol=1e-12)
        np.testing.assert_array_equal(auto.area[between], strips.area[between])
        np.testing.assert_allclose(auto.model_error, error * ((1 - share) + STRIPS_MISS * share), rtol=1e-12)
    assert np.all(counts > 20), counts


def test_loads_of_a_wheel_that_is_given_its_height():
    """Loads, pressures and forces of the patches are blended; with yaw and damping none of it is lost."""
    rows = random_poses(300, 6, low=4e4)
    stands = system(*WORN, contact_mode="elastic").evaluate_many(*rows[:, PLACES].T)
    inputs = dict(
        lateral_shift=rows[:, PLACES[0]],
        yaw=rows[:, PLACES[1]],
        vertical_shift_input=stands.vertical_shift,
        roll_input=stands.roll,
    )
    found = {
        name: system(*WORN, contact_mode="compliant", normal_model=name).evaluate_many(**inputs)
        for name in MODELS
    }
    asked = system(*WORN, contact_mode="compliant", error_outputs=True).evaluate_many(**inputs)
    seen = 0
    for side in ("left", "right"):
        plain, strips, auto = (getattr(found[name], side) for name in MODELS)
        error = getattr(asked, side).model_error
        share = np.array([strips_share(e) for e in error])
        load = (1 - share) * plain.normal_force + share * strips.normal_force
        np.testing.assert_allclose(auto.normal_force, load, rtol=1e-9)
        between = (share > 0) & (share < 1) & (auto.normal_force > 0)
        seen += between.sum()
        factor = load[between] / strips.normal_force[between]
        for name in ("max_pressure",):
            np.testing.assert_allclose(
                getattr(auto, name)[between], factor * getattr(strips, name)[between], rtol=1e-9
            )
        np.testing.assert_allclose(
            auto.normal.force.z[between], factor * strips.normal.force.z[between], rtol=1e-9
        )
        parts = sum(np.array(patch.normal_force) for patch in auto.patches)
        np.testing.assert_allclose(parts[between], auto.normal_force[between], rtol=1e-9)
        one = between & (auto.patch_count == 1)
        outline = np.asarray(auto.outline.pressure)[one].max(axis=1)
        assert np.all(outline <= auto.max_pressure[one] * (1 + 1e-9))
        assert np.all(outline > 0.9 * auto.max_pressure[one])
    assert seen > 15


@pytest.mark.parametrize("mode", ["rigid", "elastic"])
def test_penetration_and_height_do_not_step_at_the_switch(mode):
    """Poses 2 um apart: where ANALYN and strips are 1 ... 3 um apart, no step is longer than it is for them
    beside a tenth of that."""
    shift = np.arange(2.0e-3, 5.5e-3, 2e-6)
    found = {
        name: system(*WORN, contact_mode=mode, normal_model=name).evaluate_many(shift, 0.005, 80e3)
        for name in MODELS
    }
    auto = found["auto"]
    assert np.all(auto.status == Status.VALID)
    steps = {name: np.abs(np.diff(table.right.penetration)) for name, table in found.items()}
    apart = np.abs(found["analyn"].right.penetration - found["analyn_strip"].right.penetration)
    asked = system(*WORN, contact_mode=mode, error_outputs=True).evaluate_many(shift, 0.005, 80e3)
    error = asked.right.model_error
    crossing = np.flatnonzero((error[:-1] <= FIRST) != (error[1:] <= FIRST))
    assert len(crossing) > 0
    for k in crossing:
        moved = abs(strips_share(error[k + 1]) - strips_share(error[k]))
        least = max(steps["analyn"][k], steps["analyn_strip"][k])
        assert steps["auto"][k] <= least + (moved + 0.02) * apart[k : k + 2].max(), shift[k]


def test_nothing_is_kept_from_the_step_before():
    """Poses in another order have the same bits."""
    rows = random_poses(60, 7, low=2e4)
    model = system(*WORN, normal_model="auto", contact_mode="elastic")
    there = model.evaluate_many(*rows[:, PLACES].T)
    back = model.evaluate_many(*rows[::-1, PLACES].T)
    for side in ("left", "right"):
        for name in ("penetration", "area", "max_pressure", "model_error"):
            np.testing.assert_array_equal(
                getattr(getattr(there, side), name), getattr(getattr(back, side), name)[::-1]
            )


@pytest.mark.parametrize("model", ["analyn", "auto"])
def test_an_elastic_wheelset_that_moves_has_the_estimate_of_one_at_rest(model):
    """The same bits, as of the peak pressure: how the depth changes is sought with wheels displaced, whose estimates are not
    wanted."""
    wheelset = system(*WORN, contact_mode="elastic", normal_model=model, error_outputs=True)
    shift = np.array([-5e-3, 0.0, 2e-3, 4.5e-3])
    rest = wheelset.evaluate_many(shift, 0.005, 80e3)
    for motion in ({"lateral_velocity": 0.02}, {"yaw_rate": 0.02}, {"right_rail_vertical_velocity": 0.01}):
        moving = wheelset.evaluate_many(shift, 0.005, 80e3, speed=20.0, **motion)
        assert np.all(moving.status == Status.VALID)
        for side in ("left", "right"):
            for name in ("model_error", "max_pressure"):
                np.testing.assert_array_equal(
                    getattr(getattr(moving, side), name), getattr(getattr(rest, side), name), repr(motion)
                )
            assert np.all(getattr(moving, side).model_error >= LEAST)


def test_without_the_parameter_there_is_no_estimate():
    """And everything else keeps its bits."""
    rows = random_poses(40, 8)
    plain, asked = (
        system(*NEW, error_outputs=given).evaluate_many(*rows[:, PLACES].T) for given in (False, True)
    )
    for side in ("left", "right"):
        assert not getattr(plain, side).model_error.any() and np.all(
            getattr(asked, side).model_error >= LEAST
        )
        np.testing.assert_array_equal(getattr(plain, side).max_pressure, getattr(asked, side).max_pressure)


@pytest.mark.full
def test_derivatives_between_both_models_are_differences():
    """Where ANALYN and strips share the load at a height, the rate of a wheel's load is its difference over 2 nm.
    Over 20 nm differences are up to 1 % off beside jumps of ANALYN's load, of a newton in 3 kN."""
    random = np.random.default_rng(9)
    inputs = {
        "lateral_shift": random.uniform(-6.6e-3, 6.6e-3, 3000),
        "yaw": random.uniform(-0.03, 0.03, 3000),
    }
    stands = wrcontact.ContactSystem(contact_mode="elastic").evaluate_many(
        **inputs, normal_force=10 ** random.uniform(3.5, 5.3, 3000)
    )
    inputs |= {"vertical_shift_input": stands.vertical_shift, "roll_input": stands.roll}
    error = (
        wrcontact.ContactSystem(contact_mode="compliant", error_outputs=True)
        .evaluate_many(**inputs)
        .left.model_error
    )
    blended = np.flatnonzero((error > 0.041) & (error < 0.049))[:30]
    assert len(blended) == 30
    system = wrcontact.ContactSystem(contact_mode="compliant", normal_model="auto")
    inputs = {name: values[blended] for name, values in inputs.items()}

    def load(away):
        lower = inputs | {"vertical_shift_input": inputs["vertical_shift_input"] + away}
        return system.evaluate_many(**lower).left.normal_force

    slopes = (load(1e-9) - load(-1e-9)) / 2e-9
    for number, slope in enumerate(slopes):
        pose = {name: values[number] for name, values in inputs.items()}
        rate = system.derivatives(of=["left.normal_force"], by=["vertical_shift_input"], **pose)[0, 0]
        assert abs(rate / slope - 1) < 1e-4, pose
