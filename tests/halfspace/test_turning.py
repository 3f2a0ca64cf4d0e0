"""The half-space solver where normals turn: its influence against point forces, sums and waves, limits of one
plane and of equal materials, and a contact that is known beforehand."""

import math

import numpy as np
import pytest

from data.hertz import MODULUS
from tests.helpers.halfspace import WIDE, paraboloid
from wrcontact.halfspace import contact
from wrcontact.halfspace.deflection import Deflection, coupling_of, influence
from wrcontact.halfspace.flat_gap import FlatGap
from wrcontact.halfspace.one_grid import solve_grid
from wrcontact.halfspace.problem import Problem

STEEL, RUBBER = (210e9, 0.28), (5e9, 0.47)
SHAPE, DX, DS = (7, 5), 2e-4, 1e-4
ANGLES = np.linspace(1.2, 0.1, SHAPE[1])


def deflection(coupling=0.0, angle=ANGLES):
    return Deflection(SHAPE, DX, DS, MODULUS, angle=angle, coupling=coupling)


def columns_of(operator):
    """The operator's matrix."""
    cells = SHAPE[0] * SHAPE[1]
    return np.array([operator(unit.reshape(SHAPE)).ravel() for unit in np.eye(cells)]).T


# --- influence ------------------------------------------------------------------------------------


def moved(body, normal, force, away):
    """Displacement (3,) of the surface of a half-space ``away`` (3,) from a force that presses it against its
    outward ``normal``: Johnson (1985), eqs. (3.22a, b)."""
    modulus, ratio = body
    shear, r = modulus / (2.0 * (1.0 + ratio)), np.linalg.norm(away)
    inwards = -normal * (1.0 - ratio) / (2.0 * math.pi * shear * r)
    # the surface is drawn towards the force
    drawn = -away / r * (1.0 - 2.0 * ratio) / (4.0 * math.pi * shear * r)
    return force * (inwards + drawn)


@pytest.mark.parametrize("wheel, rail", [(STEEL, STEEL), (STEEL, RUBBER), (RUBBER, STEEL)])
def test_influence_is_that_of_forces_on_two_half_spaces(wheel, rail):
    """Each body by itself and in three dimensions: the half-space tangent at the loaded place, on which the
    other place lies at its distance; what counts is the part along the other place's normal."""
    contact_modulus = 1.0 / sum((1.0 - ratio**2) / modulus for modulus, ratio in (wheel, rail))
    operator = Deflection(SHAPE, DX, DS, contact_modulus, angle=ANGLES, coupling=coupling_of(wheel, rail))
    pressure = np.zeros(SHAPE)
    pressure[0, 4] = 3e8
    bent = operator(pressure)
    normal, tangent = (
        np.stack([0.0 * ANGLES, first, second], axis=-1)
        for first, second in ((-np.sin(ANGLES), -np.cos(ANGLES)), (np.cos(ANGLES), -np.sin(ANGLES)))
    )
    for i, j in ((6, 0), (5, 1), (6, 4)):
        away = np.array([i * DX, 0.0, 0.0]) + (j - 4) * DS * tangent[4]
        force = 3e8 * DX * DS
        apart = moved(wheel, -normal[4], force, away) - moved(rail, normal[4], force, away)
        # a cell as a point: (DX / r)^2 / 24
        assert bent[i, j] == pytest.approx(normal[j] @ apart, rel=3e-3)


def test_coupling_of_materials():
    """None between equal bodies; the other sign for exchanged ones; -(1 - 2 nu) / 2 (1 - nu) where the wheel
    is rigid, and 1/2 for a compressible wheel on a rigid rail."""
    assert coupling_of(STEEL, STEEL) == 0.0
    assert coupling_of(STEEL, RUBBER) == pytest.approx(-coupling_of(RUBBER, STEEL), rel=1e-12)
    assert coupling_of((1e30, 0.3), (1e9, 0.25)) == pytest.approx(-0.5 / 1.5, rel=1e-9)
    assert coupling_of((1e9, 0.0), (1e30, 0.3)) == pytest.approx(0.5, rel=1e-9)


@pytest.mark.parametrize("coupling", [0.0, 0.45, -0.3])
def test_convolution_is_the_sum(coupling):
    """Cell by cell: K times the cosine and the coupled part times the sine of the angle between normals."""
    matrix = columns_of(deflection(coupling))
    both = influence(DX * np.arange(-6, 7), DS * np.arange(-4, 5), contact_modulus=MODULUS, coupling=coupling)
    row, column = (k.ravel() for k in np.indices(SHAPE))
    apart = both[6 + row[:, None] - row, 4 + column[:, None] - column]
    turn = ANGLES[column][:, None] - ANGLES[column]
    np.testing.assert_allclose(
        matrix, np.cos(turn) * apart.real + np.sin(turn) * np.imag(apart), atol=1e-13 * matrix.max()
    )


@pytest.mark.parametrize("coupling", [0.0, 0.5, -0.5])
def test_influence_is_symmetric_and_positive(coupling):
    """What a pressure at j does at i, one at i does at j; every pressure takes work."""
    matrix = columns_of(deflection(coupling))
    np.testing.assert_allclose(matrix, matrix.T, atol=1e-14 * matrix.max())
    assert np.linalg.eigvalsh(matrix).min() > 0.0


@pytest.mark.parametrize("coupling", [0.0, 0.4])
def test_influence_of_a_wave_on_a_cylinder(coupling):
    """On a circle of curvature c a pressure cos(k s), even along x, gives way by ((1 + coupling) / (k + c) +
    (1 - coupling) / (k - c)) / E* of itself: both neighbouring waves of the plane, each by 2 / (E* k).  Here
    within a smooth envelope of a dozen waves, which adds 0.4 %."""
    count, step, curvature, wave = 600, 1e-4, 300.0, 1500.0
    s = step * (np.arange(count) - count / 2 + 0.5)
    x = 4.0 * step * (np.arange(151) - 75)
    envelope = np.exp(-0.5 * (x[:, None] / 0.01) ** 2 - 0.5 * (s / 0.01) ** 2)
    operator = Deflection(envelope.shape, 4.0 * step, step, MODULUS, angle=curvature * s, coupling=coupling)
    bent = operator(envelope * np.cos(wave * s))
    expected = ((1.0 + coupling) / (wave + curvature) + (1.0 - coupling) / (wave - curvature)) / MODULUS
    middle = slice(count // 2 - 8, count // 2 + 8)
    np.testing.assert_allclose(
        bent[75, middle], expected * (envelope[75] * np.cos(wave * s))[middle], atol=5e-3 * expected
    )
    # without the turn: the difference is what is tested
    flat = 2.0 / (wave * MODULUS)
    assert abs(expected / flat - 1.0) > 0.03


def test_turning_all_normals_changes_nothing():
    pressure = np.random.default_rng(4).random(SHAPE)
    one, other = (deflection(0.3, ANGLES + turn)(pressure) for turn in (0.0, 0.7))
    np.testing.assert_allclose(one, other, rtol=1e-12)


def test_parallel_normals_have_no_coupling():
    pressure = np.random.default_rng(5).random(SHAPE)
    plain = Deflection(SHAPE, DX, DS, MODULUS)(pressure)
    np.testing.assert_allclose(deflection(0.4, np.full(SHAPE[1], 0.8))(pressure), plain, rtol=1e-12)
    nearly = deflection(0.4, np.linspace(0.8, 0.8 + 1e-9, SHAPE[1]))(pressure)
    np.testing.assert_allclose(nearly, plain, rtol=1e-8)


# --- contact --------------------------------------------------------------------------------------


class Turned(FlatGap):
    """A gap over a curve, or a plane, whose normals have given angles; what is pressed moves along angle
    zero."""

    def __init__(self, gap, angle):
        super().__init__(gap)
        self.angle = angle

    def share(self, s):
        return np.cos(self.angle(s))


def test_a_plane_is_a_constant_angle():
    """Moved straight down, an inclined plane is pressed by the cosine, and carries as a level one does."""
    gap, slope = paraboloid(1.0, 3.0), 0.9
    level = contact.solve_contact(gap, WIDE, contact_modulus=MODULUS, force=1e4)
    inclined = Turned(gap, lambda s: np.full(len(s), slope))
    for load in (
        {"force": 1e4, "penetration": None},
        {"force": None, "penetration": level.penetration / math.cos(slope)},
        {"force": 1e4 * math.cos(slope), "penetration": None, "vertical": True},
    ):
        found = contact.solve_problem(Problem(inclined, WIDE, MODULUS, precision=5e-6, **load))
        assert found.penetration * math.cos(slope) == pytest.approx(level.penetration, rel=1e-4)
        assert found.force == pytest.approx(1e4, rel=2e-4)
        assert found.max_pressure == pytest.approx(level.max_pressure, rel=5e-4)
        assert found.area == pytest.approx(level.area, rel=3e-3)


@pytest.mark.parametrize("coupling", [0.0, 0.3])
@pytest.mark.parametrize("prescribed", ["penetration", "force", "vertical"])
def test_a_contact_that_is_known_beforehand(prescribed, coupling):
    """A pressure is chosen on a patch that turns by a radian, and the gap made such that it touches there and
    nowhere else; the solver finds it, to the residual that it leaves."""
    x, s = np.linspace(-4e-3, 4e-3, 41), np.linspace(-6e-3, 6e-3, 51)
    pressure = 1e9 * np.sqrt(np.maximum(1.0 - (x[:, None] / 3e-3) ** 2 - (s / 4.5e-3) ** 2, 0.0))
    angle = 0.6 - 120.0 * s
    depth, share = 7e-5, np.cos(angle)
    bent = Deflection(pressure.shape, x[1] - x[0], s[1] - s[0], MODULUS, angle=angle, coupling=coupling)(
        pressure
    )
    gap = depth * share - bent + np.where(pressure > 0.0, 0.0, 2e-6)
    cell = (x[1] - x[0]) * (s[1] - s[0])
    load = {
        "penetration": {"penetration": depth, "force": None},
        "force": {"penetration": None, "force": pressure.sum() * cell},
        "vertical": {"penetration": None, "force": (pressure @ share).sum() * cell, "vertical": True},
    }
    found = solve_grid(
        Problem(
            Turned(lambda *_: gap, lambda _: angle),
            None,
            MODULUS,
            precision=1e-8,
            coupling=coupling,
            **load[prescribed],
        ),
        x,
        s,
    )
    np.testing.assert_allclose(found.pressure, pressure, atol=1e3)
    assert found.penetration == pytest.approx(depth, rel=1e-7)
    assert found.iterations < 40
