"""The half-space on wheel and rail where the patch turns: the independent program, and what one mode says
about another; tests/normal/test_conformal.py has CONTACT's conformal answers."""

import math
from dataclasses import replace

import numpy as np
import pytest

import data
import wrcontact
from data import brute_force, conformal_reference
from data.hertz import MODULUS
from tests.helpers.cases import system
from tests.helpers.inside import tables_of
from wrcontact import Status
from wrcontact.halfspace.boxes import centres
from wrcontact.halfspace.one_grid import solve_grid
from wrcontact.halfspace.outputs import resultant
from wrcontact.halfspace.pressed_wheel import Settings, press
from wrcontact.halfspace.problem import Problem
from wrcontact.halfspace.turning_gap import middle_curve, turning_gap
from wrcontact.halfspace.wheel_on_rail import wheel_on_rail
from wrcontact.kernel import layout

ROWS = data.rows_of(data.CONFORMAL)


def halfspace(**parameters):
    return system(normal_model="halfspace", **parameters)


def stand_of(row):
    return {
        "lateral_shift": row["lateral_shift_mm"] * 1e-3,
        "yaw": math.radians(row["yaw_deg"]),
        "vertical_shift_input": row["vertical_shift_mm"] * 1e-3,
        "roll_input": row["roll_rad"],
    }


@pytest.mark.parametrize(
    "index",
    [
        9,
        pytest.param(0, marks=pytest.mark.full),
        pytest.param(6, marks=pytest.mark.full),
        pytest.param(7, marks=pytest.mark.full),
    ],
)
def test_the_independent_program_has_the_same_contact(index):
    """At the same height and roll, on its own grid of 110 cells or more: the same theory, from printed
    profiles and by root search. It finds the edge along x only."""
    row = ROWS[index]
    stand = stand_of(row)
    truth = conformal_reference.lowered_contact(
        brute_force.track(),
        brute_force.Pose(
            *(stand[name] for name in ("lateral_shift", "yaw", "roll_input", "vertical_shift_input"))
        ),
    )
    found = halfspace(contact_mode="compliant").evaluate(**stand).right
    assert found.normal_force == pytest.approx(truth.force, rel=1e-3)
    assert found.max_pressure == pytest.approx(truth.max_pressure, rel=2e-3)
    assert found.area == pytest.approx(truth.area, rel=0.012)


def test_rigid_contact_is_compliant_contact_at_the_height_it_sinks_to():
    """Lateral shift and roll stay; the height grows by the penetration over the cosine of the contact
    angle."""
    shift, yaw, force = 6.1e-3, 0.01, 9e4
    rigid_state = halfspace().evaluate(shift, yaw, force, side="right")
    side = rigid_state.right
    height = rigid_state.vertical_shift + side.penetration / math.cos(side.contact_angle)
    pressed = (
        halfspace(contact_mode="compliant")
        .evaluate(lateral_shift=shift, yaw=yaw, vertical_shift_input=height, roll_input=rigid_state.roll)
        .right
    )
    assert pressed.normal_force == pytest.approx(force, rel=1e-3)
    assert pressed.max_pressure == pytest.approx(side.max_pressure, rel=1e-3)
    assert pressed.area == pytest.approx(side.area, rel=5e-3)


@pytest.mark.parametrize(
    "shift, yaw, load",
    [
        (6.25e-3, 0.0, "normal"),
        pytest.param(5.5e-3, 0.5, "vertical", marks=pytest.mark.full),
        pytest.param(-6.15e-3, -0.5, "vertical", marks=pytest.mark.full),
    ],
)
def test_elastic_contact_is_compliant_contact_at_its_height_and_roll(shift, yaw, load):
    """Both wheels carry their loads there: to the equality of the heights, 2e-4 of the penetration."""
    loads, transfer = np.array([7e4, 7e4]), 0.1
    pose = {"lateral_shift": shift, "yaw": math.radians(yaw)}
    state = halfspace(contact_mode="elastic", load=load).evaluate(
        **pose, normal_force=7e4, load_transfer=transfer
    )
    assert state.status == Status.VALID
    back = halfspace(contact_mode="compliant").evaluate(
        **pose, vertical_shift_input=state.vertical_shift, roll_input=state.roll
    )
    carried = {"normal": lambda side: side.normal_force, "vertical": lambda side: -side.force.z}[load]
    loads = loads * [1.0 - transfer, 1.0 + transfer]
    np.testing.assert_allclose([carried(side) for side in (state.left, state.right)], loads, rtol=1e-6)
    np.testing.assert_allclose([carried(side) for side in (back.left, back.right)], loads, rtol=1e-3)
    for one, other in ((state.left, back.left), (state.right, back.right)):
        assert one.max_pressure == pytest.approx(other.max_pressure, rel=2e-3)
        assert one.penetration == pytest.approx(other.penetration, rel=2e-3)
        assert one.contact.y_rail == pytest.approx(other.contact.y_rail, abs=1e-9)


def test_strips_find_the_same_elastic_equilibrium():
    """Where the patch hardly turns: heights within 1 % of the penetration."""
    pose = {"lateral_shift": 2e-3, "yaw": 0.005, "normal_force": 8e4, "load_transfer": -0.2}
    found = halfspace(contact_mode="elastic").evaluate(**pose)
    near = wrcontact.ContactSystem(normal_model="analyn_strip", contact_mode="elastic").evaluate(**pose)
    assert found.vertical_shift == pytest.approx(near.vertical_shift, abs=8e-7)
    assert found.roll == pytest.approx(near.roll, abs=1e-6)


def test_unloaded_wheels_of_elastic_and_compliant_wheelsets():
    lifted = halfspace(contact_mode="compliant").evaluate(lateral_shift=1e-3, vertical_shift_input=-1e-3)
    assert lifted.status == Status.UNLOADED and lifted.left.area == lifted.right.area == 0.0
    none = halfspace(contact_mode="elastic").evaluate(lateral_shift=2e-3, normal_force=0.0)
    assert none.status == Status.UNLOADED and none.right.area == 0.0 and not np.any(none.force)
    one = halfspace(contact_mode="elastic").evaluate(lateral_shift=2e-3, normal_force=5e4, load_transfer=1.0)
    assert one.status == Status.UNLOADED and one.left.normal_force == 0.0
    assert one.right.normal_force == pytest.approx(1e5, rel=1e-6)
    # the left wheel just touches: under a newton the roll is nearly the same
    both = halfspace(contact_mode="elastic").evaluate(
        lateral_shift=2e-3, normal_force=5e4, load_transfer=1.0 - 2e-5
    )
    assert one.roll == pytest.approx(both.roll, abs=1e-7)


# --- curve and gap --------------------------------------------------------------------------------


def pair_of(index, system=None):
    """Wheel and rail of a row of conformal.csv."""
    tables = tables_of(system or halfspace())
    stand = stand_of(ROWS[index])
    return wheel_on_rail(
        tables,
        1,
        lateral_shift=stand["lateral_shift"],
        yaw=stand["yaw"],
        roll=stand["roll_input"],
        vertical_shift=stand["vertical_shift_input"],
    )


@pytest.mark.parametrize("index", (0, 6, 7))
def test_outline_has_no_normals_along_the_track(index):
    """Each of its points lies on the wheel, and a step along the track leaves the wheel on both sides."""
    pair = pair_of(index)
    outline = pair.outline
    some = slice(1500, 3300, 60)
    y, z, angle = outline.y[some], outline.z[some], outline.angle[some]
    start = np.zeros((3, len(y)))
    t = pair.wheel_along(outline.x[some] + np.array([[-1e-3], [0.0], [1e-3]]), y, z, angle, start)
    assert np.max(np.abs(t[1])) < 1e-13
    # 1e-3^2 / 2 R with 1 / R about cos(angle) / 0.46
    np.testing.assert_allclose(t[[0, 2]], 0.5e-6 * np.cos(angle) / 0.46 * np.ones((2, 1)), rtol=0.5)
    assert np.all(t[[0, 2]] > 0.0)


@pytest.mark.parametrize("index", (0, 6, 7))
def test_the_curve_lies_between_the_bodies(index):
    """Where they are close: the same distance to both, normals that are the mean of theirs (by differences
    along the bodies), stations that are its length."""
    pair = pair_of(index)
    curve = middle_curve(pair)
    near = np.flatnonzero(np.abs(curve.ridge - curve.rail) < 1.5e-4)[5:-5]
    np.testing.assert_allclose(curve.ridge[near], -curve.rail[near], atol=2e-7)
    s = curve.s[near]
    gap = turning_gap(pair, 0.0)
    y, z, angle = (curve.at(name, s) for name in ("y", "z", "angle"))
    wheel = pair.wheel_along(curve.at("x", s)[None], y, z, angle, curve.ridge[near][None])[0]
    rail = pair.rail_along(y, z, angle, curve.rail[near])
    points = [np.stack([y - t * np.sin(angle), z - t * np.cos(angle)]) for t in (wheel, rail)]
    slopes = [np.arctan2(-np.diff(p[1]), np.diff(p[0])) for p in points]
    inside = np.flatnonzero(np.diff(near) == 1)
    mean = 0.5 * (angle[1:] + angle[:-1])
    away = np.abs(0.5 * (slopes[0] + slopes[1]) - mean)[inside]
    # beside a joint of a yawed wheel the outline runs millimetres ahead within a step
    assert np.quantile(away, 0.98) < 5e-4 and np.max(away) < 6e-3
    lengths = np.hypot(np.diff(y), np.diff(z))
    np.testing.assert_allclose(lengths[inside], np.diff(s)[inside], rtol=1e-9)
    np.testing.assert_allclose(gap.overlap(s), rail - wheel, atol=1e-12)


def turned(pair, turn):
    """Wheel and rail turned together about the track's x axis; the rail, whose profile a table cannot turn,
    by another inclination, moved to where it comes to lie."""
    inclination = math.tan(math.atan(1 / 40) - turn)
    tables = tables_of(halfspace(rail_inclination=inclination))
    cos, sin = math.cos(turn), math.sin(turn)
    about = np.array([[1.0, 0.0, 0.0], [0.0, cos, -sin], [0.0, sin, cos]])
    other = wheel_on_rail(tables, 1, lateral_shift=0.0, yaw=0.0, roll=0.0, vertical_shift=0.0)
    # the point of the gauge corner with a normal of 0.7 rad, before and after
    y, z, angle = pair.rail_points(1e-5)
    before = about @ [0.0, np.interp(-0.7, -angle, y), np.interp(-0.7, -angle, z)]
    y, z, angle = other.rail_points(1e-5)
    after = np.array([0.0, np.interp(turn - 0.7, -angle, y), np.interp(turn - 0.7, -angle, z)])
    return replace(other, centre=about @ pair.centre - before + after, attitude=about @ pair.attitude)


@pytest.mark.parametrize("turn", (0.02, -0.015))
def test_turning_wheel_and_rail_together_changes_nothing(turn):
    """Force, peak and area at the same place; the force turns with them."""
    pair = pair_of(9)
    settings = Settings(layout.Tables.at(tables_of(halfspace())).contact_modulus, 0.2, False, 5e-3)
    one, other = (
        press(each.lowered(-2e-4), settings, penetration=2e-4) for each in (pair, turned(pair, turn))
    )
    assert other.contact.force == pytest.approx(one.contact.force, rel=2e-4)
    assert other.contact.max_pressure == pytest.approx(one.contact.max_pressure, rel=1e-3)
    assert other.contact.area == pytest.approx(one.contact.area, rel=5e-3)
    forces = [resultant(wheel, wheel.surfaces.pair.centre)[1:3] for wheel in (one, other)]
    angles = [math.atan2(-across, -down) for across, down in forces]
    assert angles[1] - angles[0] == pytest.approx(-turn, abs=1e-4)


def test_unequal_materials_change_the_energy_of_a_turning_patch():
    """A patch that turns by half a radian takes a little less work one way and a little more the other: the
    stored energy p A p / 2 of a given overlap is the least there is, so to first order it changes by
    -p T p / 2, here by the sum over all pairs of cells; by 1.3 % for a coupling of 0.3."""
    pair = pair_of(9)
    modulus, coupling = layout.Tables.at(tables_of(halfspace())).contact_modulus, 0.3

    def pressed(coupling):
        """Cells with their forces, and the work p A p = -p h."""
        wheel = press(pair.lowered(-2e-4), Settings(modulus, coupling, False, 5e-3), penetration=2e-4)
        contact = wheel.contact
        cell = (contact.x[1] - contact.x[0]) * (contact.s[1] - contact.s[0])
        i, j = np.nonzero(contact.pressure)
        overlap = (2e-4 * wheel.surfaces.share(contact.s) - wheel.surfaces.gap(contact.x, contact.s))[i, j]
        forces = contact.pressure[i, j] * cell
        return contact.x[i], contact.s[j], contact.angle[j], forces, forces @ overlap

    x, s, angle, forces, work = pressed(0.0)
    away, turn = s[:, None] - s, angle[:, None] - angle
    apart = np.hypot(x[:, None] - x, away) + np.diag(np.full(len(s), np.inf))
    coupled = forces @ (np.sin(turn) * coupling * away / apart**2) @ forces / (math.pi * modulus)
    works = [pressed(each)[-1] for each in (-coupling, coupling)]
    assert abs(coupled / work) > 0.005
    assert 0.5 * (works[1] - works[0]) == pytest.approx(-coupled, rel=0.02)


def test_error_falls_with_the_cells():
    """A patch that turns by half a radian, on the same box: with the square of the cells' size in force and
    peak pressure."""
    pair = pair_of(9)
    gap = turning_gap(pair.lowered(-2e-4), 2e-4)
    fine = press(pair.lowered(-2e-4), Settings(MODULUS, 0.0, False, 1e-3), penetration=2e-4).contact
    box = fine.x[0], fine.x[-1], fine.s[0], fine.s[-1]
    problem = Problem(gap, gap.domain, MODULUS, None, 2e-4, 1e-7)
    errors = []
    for count in (12, 24, 48):
        found = solve_grid(problem, *centres(box, (count, count)))
        errors.append(
            [abs(getattr(found, name) / getattr(fine, name) - 1.0) for name in ("force", "max_pressure")]
        )
    rates = np.log2(np.divide(errors[0], errors[2])) / 2
    assert np.all(rates > 1.3), errors
