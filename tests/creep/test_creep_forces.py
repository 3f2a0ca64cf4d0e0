"""``wrcontact.creep_forces`` and the patches that it takes."""

import numpy as np
import pytest

import wrcontact
from data.creep_cases import Model, all_shapes, full_slip, vector
from tests.helpers.cases import CREEP_MODELS, STRIP_MODELS
from wrcontact.creep.results import own_outline

PATCH = wrcontact.elliptic_patch(half_length=6e-3, half_width=4e-3, normal_force=80e3)
BOUND = 0.3 * 80e3


def numbers(found):
    return np.array([found.x, found.y, found.moment])


def test_a_driven_wheel_is_pushed_forwards():
    """Signs: a wheel that turns too fast has xi < 0 and is pushed forwards; one that slides to the field side
    is pushed back."""
    driven = wrcontact.creep_forces(PATCH, creepage_x=-1e-3)
    assert driven.x > 0.2 * BOUND and driven.y == 0.0 and abs(driven.moment) < 1e-9 * BOUND
    assert 0.0 < driven.stick_share < 1.0 and driven.max_shear > 0.0
    assert wrcontact.creep_forces(PATCH, creepage_y=1e-3).y < -0.2 * BOUND


@pytest.mark.parametrize("model", wrcontact.methods.TangentialModel.family.names()[1:])
def test_models_agree_within_their_errors(model):
    """Against the strips: of moderate creepages nobody is more than 15 % of mu N away."""
    motion = {"creepage_x": -1e-3, "creepage_y": 5e-4, "spin": 0.2}
    found = wrcontact.creep_forces(PATCH, **motion, tangential_model=model)
    strips = wrcontact.creep_forces(PATCH, **motion)
    allowed = {"strips": 0.0, "halfspace": 0.02}.get(model, 0.15)
    assert np.hypot(found.x - strips.x, found.y - strips.y) <= allowed * BOUND
    assert found.x > 0.0


def test_it_is_the_kernels_model():
    """The same bits as the kernel on the same patch."""
    for patch in all_shapes()[::2]:
        motion = np.array([0.4, -0.8, 0.9]) * full_slip(patch, 0.25)[0]
        for name in CREEP_MODELS:
            found = wrcontact.creep_forces(patch, *motion, 0.25, name)
            np.testing.assert_array_equal(numbers(found), vector(Model(name).solve(patch, *motion, 0.25)))


def test_methods_bring_their_numbers():
    motion = {"creepage_y": 1e-3, "spin": 0.5}
    plain = wrcontact.creep_forces(PATCH, **motion, tangential_model="fastsim")
    ours = wrcontact.creep_forces(PATCH, **motion, tangential_model=wrcontact.Fastsim())
    published = wrcontact.creep_forces(PATCH, **motion, tangential_model=wrcontact.Fastsim(published_spin=1))
    assert plain == ours and plain != published


def test_none_is_no_force():
    assert wrcontact.creep_forces(PATCH, 1e-3, tangential_model="none") == wrcontact.CreepForces(*[0.0] * 5)


def test_an_outlined_ellipse_is_the_ellipse():
    """With 61 stations, between which squares of half-length and line load follow straight lines: 0.5 %."""
    station = np.linspace(-4e-3, 4e-3, 61)
    shape = np.sqrt(np.clip(1.0 - (station / 4e-3) ** 2, 0.0, None))
    peak = 1.5 * 80e3 / (np.pi * 6e-3 * 4e-3)
    outlined = wrcontact.outlined_patch(station, 6e-3 * shape, peak * shape)
    assert outlined.normal_force == pytest.approx(80e3, rel=2e-3)
    for motion in ((-1e-3, 0.0, 0.0), (0.0, 1e-3, 0.3), (2e-3, -1e-3, -1.0)):
        one, other = (numbers(wrcontact.creep_forces(patch, *motion)) for patch in (PATCH, outlined))
        np.testing.assert_allclose(other, one, atol=5e-3 * BOUND * np.array([1.0, 1.0, 5e-3]).max())
        assert np.hypot(*(other - one)[:2]) < 5e-3 * BOUND


def test_the_load_of_an_outline_can_be_given():
    station, half_length = [0.0, 1e-3, 3e-3, 4e-3], [0.0, 2e-3, 3e-3, 0.0]
    patch = wrcontact.outlined_patch(station, half_length, [0.0, 8e8, 9e8, 0.0], normal_force=1e4)
    assert patch.normal_force == 1e4
    slides = wrcontact.creep_forces(patch, creepage_x=1.0)
    assert slides.x == pytest.approx(-0.3 * 1e4, rel=1e-3)


@pytest.mark.parametrize("side", ["left", "right"])
@pytest.mark.parametrize(
    "pose", [{"lateral_shift": 2e-3}, {"lateral_shift": -3e-3, "yaw": 2e-3}, {"lateral_shift": 5.6e-3}]
)
def test_a_patch_of_a_result_has_its_force(side, pose):
    """Against the force in the result, which knows more strips and the rolling radius of each: the outline's
    31 stations, one straight line of creepage and no slant leave 4 % of mu N."""
    state = wrcontact.ContactSystem(tangential_model="strips").evaluate(**pose, speed=20.0)
    for number, patch in enumerate(getattr(state, side).patches):
        if patch.normal_force > 2e4:
            rolling, creepages = wrcontact.patch_of(state, side, number)
            assert rolling.normal_force == patch.normal_force
            assert np.ptp(rolling.station) == pytest.approx(patch.width, rel=1e-9)
            found = wrcontact.creep_forces(rolling, **creepages)
            assert wrcontact.creep_forces(patch, **creepages) == found
            off = np.hypot(found.x - patch.tangential.x, found.y - patch.tangential.y)
            assert off < 0.04 * 0.3 * patch.normal_force, (number, found, patch.tangential)
            to_field = -1.0 if side == "right" else 1.0
            assert found.moment == pytest.approx(
                to_field * patch.tangential.moment, abs=0.1 * 0.3 * patch.normal_force * patch.width
            )


def test_edges_of_one_of_several_patches():
    """The outer ones end with the outline, one between others has its width around its middle."""
    station = np.linspace(-0.01, 0.02, 31)
    pressure = np.where(np.isin(np.arange(31), [*range(1, 8), *range(12, 16), *range(22, 30)]), 1e9, 0.0)
    half_length = 1e-3 * (pressure > 0.0)

    class Patch:
        """What is read of a patch."""

        def __init__(self, centroid, width):
            self.centroid, self.width = centroid, width

    for centroid, width, wanted in (
        (-0.006, 8e-3, (-0.01, -0.002)),
        (0.016, 9e-3, (0.011, 0.02)),
        (0.0037, 4e-3, (0.0015, 0.0055)),
    ):
        found, length, top = own_outline(Patch(centroid, width), station, half_length, pressure)
        np.testing.assert_allclose(found[[0, -1]], wanted, atol=1e-12)
        assert (np.diff(found) > 0.0).all() and (top[1:-1] > 0.0).all() and len(length) == len(found)


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: wrcontact.elliptic_patch(6.0, 4e-3, 8e4), "half_length is 6 m; permitted are 1e-09 to 1 m"),
        (lambda: wrcontact.elliptic_patch(6e-3, float("nan"), 8e4), "half_width is nan m; permitted are"),
        (lambda: wrcontact.elliptic_patch(6e-3, 4e-3, -1.0), "normal_force is -1 N; permitted are 0 to 1e"),
        (lambda: wrcontact.elliptic_patch(6e-3, 4e-3, 8e4, 210.0), "youngs_modulus is 210 Pa; permitted are"),
        (
            lambda: wrcontact.elliptic_patch(6e-3, 4e-3, 8e4, poisson_ratio=0.6),
            "poisson_ratio is 0.6; permitted",
        ),
        (
            lambda: wrcontact.outlined_patch([0, 1e-3], [0, 0], [0, 0]),
            "station has 2 values; permitted are 3",
        ),
        (lambda: wrcontact.outlined_patch([0, 2e-3, 1e-3], [0] * 3, [0] * 3), "station must rise"),
        (
            lambda: wrcontact.outlined_patch([0, 1e-3, 2e-3], [0, 1], [0] * 3),
            "half_length has 2 values, station",
        ),
        (lambda: wrcontact.outlined_patch([0, 1e-3, 2e-3], [0, 1e-3, 0], [0] * 3), "carries no load"),
        (
            lambda: wrcontact.outlined_patch([0, 1e-3, 2e-3], [0, -1e-3, 0], [1] * 3),
            "half_length has the value",
        ),
        (lambda: wrcontact.creep_forces(PATCH, creepage_x=float("inf")), "creepage_x is inf; permitted are"),
        (lambda: wrcontact.creep_forces(PATCH, friction=-0.1), "friction is -0.1; permitted are 0 to 10"),
        (lambda: wrcontact.creep_forces(PATCH, tangential_model="usetab"), "tangential_model is 'usetab'"),
    ],
)
def test_what_cannot_be_used_is_refused_in_a_sentence(call, sentence):
    with pytest.raises(ValueError, match=sentence):
        call()


def test_what_is_no_number_is_refused():
    with pytest.raises(TypeError, match="friction must be a number, not str"):
        wrcontact.creep_forces(PATCH, friction="0.3")
    with pytest.raises(TypeError, match="creepage_x must be a number, not bool"):
        wrcontact.creep_forces(PATCH, creepage_x=True)
    for station in (["a", "b", "c"], ["1", "2", "3"], [False, True, True]):
        with pytest.raises(TypeError, match="station must be numbers"):
            wrcontact.outlined_patch(station, [0] * 3, [0] * 3)
    with pytest.raises(TypeError, match="patch is a float"):
        wrcontact.creep_forces(1.0)
    table = wrcontact.ContactSystem().evaluate_many([0.0, 1e-3])
    with pytest.raises(ValueError, match="patch has many poses"):
        wrcontact.creep_forces(table.right.patches[0])


def test_a_result_without_that_patch_is_refused():
    state = wrcontact.ContactSystem().evaluate(0.0)
    with pytest.raises(ValueError, match="side is 'up'; permitted are 'left' and 'right'"):
        wrcontact.patch_of(state, "up")
    with pytest.raises(ValueError, match="number is 2; the right wheel has 1 patches"):
        wrcontact.patch_of(state, "right", 2)


@pytest.mark.parametrize("normal, most", [("hertz", 1.0), ("analyn_strip", 1.05)])
@pytest.mark.parametrize("model", STRIP_MODELS)
def test_no_traction_is_above_friction_times_the_largest_pressure(model, normal, most):
    """Of an ellipse; other patches have their largest pressure between two strips."""
    low, high = (-7e-3, -0.03, 3.0, -0.1, -0.02), (7e-3, 0.03, 5.3, 0.1, 0.02)
    shift, yaw, power, lateral, turn = np.random.default_rng(5).uniform(low, high, (100, 5)).T
    table = wrcontact.ContactSystem(normal_model=normal, tangential_model=model).evaluate_many(
        shift, yaw, normal_force=10.0**power, speed=20.0, lateral_velocity=lateral, yaw_rate=turn
    )
    for wheel in (table.left, table.right):
        for patch in wheel.patches:
            above = patch.max_shear - most * 0.3 * patch.max_pressure
            worst = np.argmax(above)
            assert above[worst] <= 1e-9 * patch.max_pressure[worst], (shift[worst], yaw[worst])
