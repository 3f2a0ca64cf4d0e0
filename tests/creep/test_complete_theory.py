"""Creep forces by the complete theory, on the pressures of the half-space and on the outlines of the kernel's
patches; and the kernel's models on the patches of the half-space.

Errors are parts of the friction limit mu N.
"""

from types import SimpleNamespace

import numpy as np
import pytest

import wrcontact
from data.manchester import FRICTION, POISSON, SHEAR, error, rows
from tests.helpers.cases import system
from tests.helpers.inside import work_of
from wrcontact.conventions import SIDES
from wrcontact.halfspace import pressed_rolling, rolling_step
from wrcontact.halfspace.rolling.extrapolation import roll_ellipse
from wrcontact.halfspace.rolling.pressure import Outline
from wrcontact.halfspace.rolling_step import roll_strips

POSE = {
    "lateral_shift": 3e-3,
    "yaw": 4e-3,
    "speed": 20.0,
    "wheel_rate": 20.0 / 0.46,
    "lateral_velocity": 0.02,
}
#: Coarse and fast: creep forces are then within 0.2 % of those at a tolerance of 0.001.
COMPLETE = {"normal_model": "halfspace", "tangential_model": "halfspace", "tolerance": 0.02}
#: Both wheels of each position of the Manchester benchmark, {shift [mm]: {side: row}}.
PAIRS = {}
for each in rows():
    PAIRS.setdefault(each["lateral_shift_mm"], {})[each["side"]] = each


@pytest.fixture(scope="module")
def complete():
    return wrcontact.ContactSystem(**COMPLETE)


@pytest.fixture(scope="module")
def state(complete):
    return complete.evaluate(**POSE)


#: Of normal contact: the half-space, or a model of the kernel with its outlines.
NORMAL = {"halfspace": {"normal_model": "halfspace", "tolerance": 0.02}, "analyn": {}}


@pytest.fixture(scope="module", params=NORMAL)
def both(request):
    """The wheelset without friction and by the complete theory."""
    given = NORMAL[request.param]
    return system(**given).evaluate(**POSE), system(tangential_model="halfspace", **given).evaluate(**POSE)


def creep(side):
    """Creep force of a wheel's patches (x, y), over mu N."""
    return np.array([sum(getattr(patch.tangential, name) for patch in side.patches) for name in "xy"]) / (
        FRICTION * side.normal_force
    )


def apart(one, other):
    """The largest difference of the creep forces of both wheels."""
    return max(np.hypot(*(creep(getattr(one, side)) - creep(getattr(other, side)))) for side in SIDES)


@pytest.mark.full
# the models' pressures and their outlines of strips are good to some tenths of a per cent on the tread; the
# coupled strips are within 1 % of the complete theory (docs/theory)
@pytest.mark.parametrize(
    "normal, tangential, bound",
    [
        ("analyn_strip", "halfspace", 0.006),
        ("analyn_strip", "strips", 0.01),
        ("halfspace", "strips", 0.01),
        ("halfspace", "fastsim", 0.06),
    ],
)
def test_forces_are_near_those_of_the_models(state, normal, tangential, bound):
    tolerance = {"tolerance": 0.02} if normal == "halfspace" else {}
    other = system(normal_model=normal, tangential_model=tangential, **tolerance).evaluate(**POSE)
    assert 0.0 < apart(state, other) < bound
    for side in SIDES:
        one, two = getattr(state, side), getattr(other, side)
        # FASTSIM's own stick share is up to twice that of the complete theory
        near = 0.2 if tangential == "fastsim" else 0.03 + 2 * bound
        assert one.patches[0].stick_share == pytest.approx(two.patches[0].stick_share, abs=near)
        # shear is largest at one place, where the strips of a model are coarse
        assert one.patches[0].max_shear == pytest.approx(two.patches[0].max_shear, rel=0.05)
        assert one.friction_power == pytest.approx(two.friction_power, rel=2 * bound)


def test_cells_and_outlines_agree(monkeypatch, state):
    """The same patches without their cells, as outlines of sixteen strips."""
    monkeypatch.setattr(pressed_rolling, "patch_fields", lambda side, patch: None)
    assert 0.0 < apart(state, wrcontact.ContactSystem(**COMPLETE).evaluate(**POSE)) < 0.005


def test_contact_is_that_without_friction_and_near_fastsim(both):
    """FASTSIM is within some per cent of mu N of the complete theory; contact and creepages are the same."""
    plain, exact = both
    fast = system(tangential_model="fastsim").evaluate(**POSE)
    assert 0.0 < apart(exact, fast) < 0.06
    for side in SIDES:
        one, other = getattr(exact, side).patches[0], getattr(plain, side).patches[0]
        assert one.creepage.x == other.creepage.x and one.normal_force == other.normal_force


def test_resultants_take_them_up(both):
    normal, state = both
    # the same pressures, with and without friction
    np.testing.assert_array_equal(normal.normal.force, normal.force)
    np.testing.assert_array_equal(state.normal.force, normal.force)
    np.testing.assert_array_equal(state.normal.moment, normal.moment)
    for name in SIDES:
        side = getattr(state, name)
        np.testing.assert_array_equal(side.normal.force, getattr(normal, name).force)
        patch, mirror = side.patches[0], 1.0 if name == "right" else -1.0
        limit = FRICTION * side.normal_force
        assert patch.saturation == pytest.approx(np.hypot(patch.tangential.x, patch.tangential.y) / limit)
        assert side.force.x == pytest.approx(patch.tangential.x, rel=1e-12)
        across = side.force.y - side.normal.force.y
        # each strip pushes in its own plane: on the tread they turn by a few degrees
        assert across == pytest.approx(mirror * np.cos(patch.contact_angle) * patch.tangential.y, rel=3e-3)
        outline = side.outline
        power = np.trapezoid(outline.shear * outline.slip * 2 * outline.half_length, outline.station)
        # strips and stations are coarse, and their elastic power is left out
        assert power == pytest.approx(side.friction_power, rel=0.05)
    # each force goes round the axle at its own rolling radius, within a millimetre of penetration and yaw
    torque = -sum(
        getattr(state, name).force.x * getattr(state, name).patches[0].rolling_radius for name in SIDES
    )
    levers = sum(abs(getattr(state, name).force.x) for name in SIDES)
    lateral = sum(abs(getattr(state, name).force.y) for name in SIDES) * np.sin(POSE["yaw"])
    assert state.driving_torque == pytest.approx(torque, abs=1e-3 * levers + lateral)


def test_outlines_apart_and_one_side():
    """Another number of stations follows behind the outputs; the torque needs both wheels."""
    found = wrcontact.ContactSystem(**COMPLETE, stations=101).evaluate(**POSE, side="right")
    outline = found.right.outline
    assert outline.shear.shape == (101,) and np.isnan(found.driving_torque)
    power = np.trapezoid(outline.shear * outline.slip * 2 * outline.half_length, outline.station)
    # sixteen strips, whose elastic power is left out
    assert power == pytest.approx(found.right.friction_power, rel=0.03)


@pytest.mark.full
def test_mirrored_poses_swap_the_wheels(complete, state):
    """To what the iterations of the pressures leave, whose sums run the other way for a mirrored pose."""
    turned = {name: -POSE[name] for name in ("lateral_shift", "yaw", "lateral_velocity")}
    other = complete.evaluate(**POSE | turned)
    for one, two in ((state.left, other.right), (state.right, other.left)):
        np.testing.assert_allclose(creep(two), creep(one), rtol=0, atol=1e-6)
        assert two.patches[0].tangential.moment == pytest.approx(-one.patches[0].tangential.moment, rel=1e-4)


@pytest.mark.parametrize("normal", ["analyn", pytest.param("halfspace", marks=pytest.mark.full)])
def test_backwards_is_the_mirror_image(normal):
    """On the way back without yaw the forces along the track are reversed."""
    one = system(tangential_model="halfspace", **NORMAL[normal])
    there, back = (
        one.evaluate(2e-3, speed=speed, wheel_rate=speed / 0.46, lateral_velocity=0.02, side="right").right
        for speed in (20.0, -20.0)
    )
    # a patch without yaw is the same from front and back, as its cells are to the iterations' precision
    near = 1e-6 if normal == "analyn" else 1e-5
    np.testing.assert_allclose(creep(back), creep(there) * [-1.0, 1.0], rtol=0, atol=near)


@pytest.mark.full
def test_rails_that_are_displaced_with_the_wheelset(complete, state):
    """The same contact elsewhere on the track."""
    away = 5e-3
    moved = complete.evaluate(
        **POSE | {"lateral_shift": POSE["lateral_shift"] + away},
        left_rail_lateral=away,
        right_rail_lateral=away,
    )
    # the cells lie otherwise
    assert apart(state, moved) < 1e-3
    np.testing.assert_allclose([moved.force.y, moved.moment.z], [state.force.y, state.moment.z], rtol=1e-3)


def test_standstill_and_no_friction(complete, state):
    """Nothing but the pressures, with creepages where it rolls."""
    still = complete.evaluate(3e-3, 4e-3)
    smooth = complete.evaluate(**POSE, left_friction=0.0, right_friction=0.0)
    assert still.right.patches[0].creepage.x == 0.0
    assert smooth.right.patches[0].creepage.x == state.right.patches[0].creepage.x != 0.0
    for each in (still, smooth):
        np.testing.assert_array_equal(each.force, each.normal.force)
        np.testing.assert_array_equal(each.normal.force, state.normal.force)
        assert each.driving_torque == each.right.friction_power == each.left.wear_number == 0.0
        patch = each.right.patches[0]
        assert patch.tangential.x == patch.tangential.y == patch.stick_share == patch.max_shear == 0.0
        assert not each.right.outline.shear.any()


@pytest.mark.full
def test_wet_rails(complete):
    """Creepages count half, those of the rows too: as on the outlines of the kernel's patches."""
    wet = {"slope_reduction": 0.5}
    found = wrcontact.ContactSystem(**COMPLETE, **wet).evaluate(**POSE)
    other = system(normal_model="analyn_strip", tangential_model="halfspace", **wet).evaluate(**POSE)
    assert apart(found, other) < 0.006
    assert apart(found, complete.evaluate(**POSE)) > 0.05


def test_an_ellipse_of_strips_is_that_ellipse():
    """Strips of a Hertz patch, put together again, have the force of the ellipse itself."""
    one = system(normal_model="hertz", tangential_model="polach")
    stepper = one.stepper()
    stepper.inputs[:] = one.evaluate(1e-3, speed=20.0, lateral_velocity=0.03).inputs
    assert stepper.step() == 0
    work = work_of(stepper)
    patch = work.sides[1].patches[0]
    for strip in patch.strips:
        strip.slip = patch.creepage_x - patch.spin * strip.y
        strip.lateral, strip.spin, strip.x = patch.creepage_y, patch.spin, 0.0
    material = {"shear_modulus": 210e9 / 2.56, "poisson_ratio": 0.28}
    exact = roll_ellipse(
        patch.half_length,
        patch.half_width,
        patch.totals.load,
        creepage_x=patch.creepage_x,
        creepage_y=patch.creepage_y,
        spin=patch.spin,
        friction=patch.friction,
        **material,
    )
    roll_strips(patch, **material)
    found = np.array([patch.creep_x, patch.creep_y])
    # both are extrapolated from the same numbers of cells
    np.testing.assert_allclose(
        found, [exact.force_x, exact.force_y], atol=2e-3 * patch.friction * patch.totals.load, rtol=0
    )


def test_a_step_that_does_not_converge_keeps_the_last_outputs(monkeypatch):
    stepper = wrcontact.ContactSystem(tangential_model="halfspace").stepper()
    stepper.inputs[:] = wrcontact.ContactSystem().evaluate(**POSE).inputs
    assert stepper.step() == 0
    good = stepper.outputs.copy()
    with monkeypatch.context() as broken:
        broken.setattr(rolling_step, "roll_strips", fail)
        stepper.inputs[0] = 2e-3
        assert stepper.step() == wrcontact.Status.NOT_CONVERGED
    np.testing.assert_array_equal(stepper.outputs, good)
    assert stepper.step() == 0
    assert np.any(stepper.outputs != good)
    stepper.inputs[0] = POSE["lateral_shift"]
    assert stepper.step() == 0
    # a start elsewhere leaves the contact's last digits, and the solver's tolerance
    np.testing.assert_allclose(stepper.outputs, good, rtol=1e-3, atol=30.0)


def fail(*_, **__):
    raise ArithmeticError("no convergence")


def ellipse_side(length=3e-3, width=5e-3, cells=40, gap=0.0):
    """A solved side with Hertz's pressure of an elliptic patch on so many cells each way, the columns beyond
    its middle ``gap`` [m] farther away; and the patch, and the ellipse itself on the fine grid."""
    x, s = (
        centre + half * (2 * np.arange(cells + 4) - cells - 2.7) / cells
        for centre, half in ((1e-3, length), (-4e-3, width))
    )
    square = 1.0 - ((x[:, None] - 1e-3) / length) ** 2 - ((s + 4e-3) / width) ** 2
    contact = SimpleNamespace(x=x, s=s + gap * (s > -4e-3), pressure=1e9 * np.sqrt(np.maximum(square, 0.0)))
    patch = SimpleNamespace(x=1e-3, rank=1, totals=SimpleNamespace(centroid=-4e-3))
    side = SimpleNamespace(wheel=SimpleNamespace(contact=contact))
    outline = Outline.of_ellipse(length, width, 1e9 * 2 / 3 * np.pi * length * width)
    return side, patch, outline.on_grid(48, 48)


def test_sampled_pressures_are_those_of_an_ellipse():
    """Hertz's patch on cells that do not fit it, at their middles, against the ellipse in closed form."""
    side, patch, exact = ellipse_side()
    coarse, fine = pressed_rolling.patch_fields(side, patch)
    assert coarse.pressure.shape == (24, 24)
    # an edge within cells is known to 0.06 of a cell, 0.3 % of the half-axes
    for found, given, half in ((fine.x, exact.x, 3e-3), (fine.y, exact.y, 5e-3)):
        np.testing.assert_allclose(found, given, rtol=0, atol=4e-3 * half)
    assert fine.normal_force == pytest.approx(exact.normal_force, rel=2e-3)
    inner = exact.pressure > 0.3e9
    np.testing.assert_allclose(fine.pressure[inner], exact.pressure[inner], rtol=0, atol=0.01e9)
    assert fine.cover.sum() == pytest.approx(exact.cover.sum(), rel=5e-3)


def test_cells_that_do_not_show_the_edge_are_not_sampled():
    """Where they are few, or where the grids of two patches meet."""
    assert pressed_rolling.patch_fields(*ellipse_side(cells=pressed_rolling.LEAST_CELLS - 3)[:2]) is None
    assert pressed_rolling.patch_fields(*ellipse_side(gap=1e-4)[:2]) is None


def test_a_prescribed_vertical_load_is_refused():
    for normal, model in (("halfspace", "halfspace"), ("halfspace", "strips"), ("analyn", "halfspace")):
        with pytest.raises(ValueError, match="load is 'vertical'; permitted with the .*model 'halfspace'"):
            wrcontact.ContactSystem(normal_model=normal, tangential_model=model, load="vertical")
    assert wrcontact.ContactSystem(normal_model="halfspace", load="vertical").parameters["load"] == "vertical"


def manchester_wheelset(pair, **methods):
    """The wheelset of the benchmark, whose wheels have the normal forces of the reference output."""
    left, right = pair["left"]["FN_N"], pair["right"]["FN_N"]
    given = pair["right"]
    wheelset = wrcontact.ContactSystem(
        youngs_modulus=2 * SHEAR * (1 + POISSON), poisson_ratio=POISSON, contact_mode="elastic", **methods
    )
    return wheelset.evaluate(
        1e-3 * given["lateral_shift_mm"],
        given["yaw_rad"],
        0.5 * (left + right),
        load_transfer=(right - left) / (right + left),
        speed=2.0,
        wheel_rate=-given["pitch_rate_rad_s"],
        left_friction=FRICTION,
        right_friction=FRICTION,
    )


@pytest.mark.parametrize(
    "shift",
    [
        pytest.param(shift, marks=() if shift in (3.0, 7.0) else pytest.mark.full)
        for shift in PAIRS
        if shift > 0.0
    ],
)
def test_manchester_benchmark(shift):
    """CONTACT's complete theory, its own normal contact in one plane for each patch.  Measured: 0.28 % at
    most; on the right at 5 mm it has one plane patch for two with normals of their own, 2.9 %."""
    pair = PAIRS[shift]
    state = manchester_wheelset(pair, normal_model="halfspace", tangential_model="halfspace")
    for side, row in pair.items():
        found = getattr(state, side)
        assert error(row, found) < (0.035 if (side, shift) == ("right", 5.0) else 0.004), (side, shift)
        # its power is that of the tractions in its cells, up to 0.52 W below that of its forces
        assert found.friction_power == pytest.approx(-row["friction_power"], rel=3e-3, abs=0.7)


@pytest.mark.full
def test_centred_manchester_wheelset(monkeypatch):
    """Centred, a patch of 27 mm is conformal.  Its rows have rolling radii of their own; without them, as in
    CONTACT's plane patch, the forces agree."""
    pair = PAIRS[0.0]
    methods = {"normal_model": "halfspace", "tangential_model": "halfspace"}
    state = manchester_wheelset(pair, **methods)

    def plane(motion, side, patch, field):
        rows = np.ones(len(field.y))
        return np.array([patch.creepage_x - patch.spin * field.y, patch.creepage_y * rows, patch.spin * rows])

    monkeypatch.setattr(pressed_rolling, "row_slips", plane)
    flat = manchester_wheelset(pair, **methods)
    for side, row in pair.items():
        assert error(row, getattr(flat, side)) < 0.004
        assert 0.03 < error(row, getattr(state, side)) < 0.05
