"""ANALYN as the source describes it, and what it is given."""

import math

import numpy as np
import pytest
from scipy.special import ellipe, ellipk

from data.hertz import MODULUS
from tests.helpers.inside import lateral_curvatures
from tests.helpers.source_study import STUDY
from wrcontact import ContactSystem
from wrcontact.study.sections import circle_curvature, corrected, rough_curvature, solve_analyn


@pytest.mark.parametrize("A, B", [(1.0, 1.0), (1.0, 8.0), (6.0, 1.0)])
def test_analyn_of_the_study_is_hertz_for_constant_curvatures(A, B):
    """Semi-axes, approach and pressure from the elliptic integrals (Johnson 1985, section 4.2)."""
    force, s = 20e3, np.linspace(-20e-3, 20e-3, 8001)
    patch = solve_analyn(s, B * s**2, np.full_like(s, A), np.full_like(s, B), force=force, modulus=MODULUS)
    a, b = patch.length / 2, patch.width / 2
    short, long, q = min(a, b), max(a, b), min(a, b) / max(a, b)
    K, E = ellipk(1 - q * q), ellipe(1 - q * q)
    assert min(A, B) / max(A, B) == pytest.approx((K - E) / (E / q**2 - K), rel=5e-3)
    assert patch.penetration == pytest.approx(3 * force * K / (2 * math.pi * MODULUS * long), rel=2e-3)
    assert patch.pressure.max() == pytest.approx(3 * force / (2 * math.pi * long * short), rel=3e-3)
    assert patch.normal_force == pytest.approx(force, rel=1e-9)


def test_nodes_with_no_curvature_drop_out_unless_corrected():
    s = np.linspace(-5e-3, 5e-3, 401)
    B = np.where(np.abs(s - 1e-3) < 0.5e-3, -0.5, 2.0)
    columns = s, 2.0 * s**2, np.ones_like(s), B
    bare, mended = (
        solve_analyn(*columns, force=2e4, modulus=MODULUS, correction=degree) for degree in (None, 2)
    )
    assert not bare.loaded[np.abs(s - 1e-3) < 0.4e-3].any() and bare.regions == 2
    assert mended.regions == 1 and mended.penetration < bare.penetration
    assert np.isnan(corrected(B, np.abs(s) < 3e-3, None)[np.abs(s - 1e-3) < 0.4e-3]).all()


@pytest.mark.parametrize("shift", [1.0, 6.0, 6.5])
def test_separations_near_the_contact_are_what_the_curvature_says(shift):
    """B s^2 along the normal and between equal arcs, and 1 / cos(contact angle) more
    vertically at the same place."""
    section = STUDY.section(shift)
    near = 5e-6  # [m]
    B = float(section.exact_lateral(section.normal(near, 1))[1])
    for nodes in (
        section.normal(near, 8),
        section.equidistant(near, 8),
        section.equidistant(near, 8, chords=True),
    ):
        assert nodes.gap == pytest.approx(B * nodes.station**2, rel=0.02, abs=1e-13)
    vertical, cosine = section.vertical(near, 8), math.cos(section.angle)
    assert vertical.gap == pytest.approx(B * (vertical.station / cosine) ** 2 / cosine, rel=0.04, abs=1e-13)


def test_chords_are_arcs_in_the_limit():
    section, errors = STUDY.section(6.0), []
    for ds in (0.8e-3, 0.4e-3, 0.2e-3):
        count = round(8e-3 / ds)
        chords, arcs = section.equidistant(ds, count, chords=True), section.equidistant(ds, count)
        errors.append(abs(chords.rail[0] - arcs.rail[0]))
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.3)
    assert errors[1] / errors[2] == pytest.approx(4, rel=0.3)


def test_arc_lengths_on_a_circle():
    """The rail's gauge corner is an arc of 13 mm: an arc length s turns the tangent by s / R."""
    rail = STUDY.section(6.5).rail
    t = rail.at_arc(np.array([-0.5e-3, 0.5e-3]))
    assert np.diff(rail.direction(t)) == pytest.approx(1e-3 / 13e-3, rel=1e-6)


@pytest.mark.parametrize("shift", [1.0, 6.0])
def test_curvatures_are_those_of_the_kernels_tables(shift):
    """Circle fit and three nodes written twice, by two people."""
    section = STUDY.section(shift)
    nodes = section.equidistant(0.2e-3, 60)
    smooth, rough = (ContactSystem(lateral_curvature=kind) for kind in ("smooth", "rough"))
    for body, curve, t, sign in (
        ("rail", section.rail, nodes.rail, 1),
        ("wheel", section.wheel, nodes.wheel, -1),
    ):
        own = rough_curvature(curve.point(t))
        # 31 points along the chord, 61 along the tangent
        wanted = sign * np.interp(t, *lateral_curvatures(smooth, body))
        assert circle_curvature(curve, t, 3e-3) == pytest.approx(wanted, rel=0.02, abs=0.05)
        # [1/m], not beside a step of the heights
        even = np.abs(np.diff(own, 2, prepend=own[0], append=own[-1])) < 1.0
        assert np.median(np.abs(own - sign * np.interp(t, *lateral_curvatures(rough, body)))[even]) < 0.01


@pytest.mark.parametrize("shift", [6.0, 6.5])
@pytest.mark.parametrize("separation", ["normal", "equidistant", "equidistant_chord"])
def test_patches_of_the_study_are_those_of_the_kernel(shift, separation):
    """Where one B for all hardly matters: the numpy ANALYN on its own nodes against the kernel with the same
    options. The source's gap is that of a wheel that just touches; the kernel's wheel sinks, by 0.04 % of
    the radius of the flange root under this load (by 0.8 % under 78.5 kN)."""
    force = 1e3
    section = STUDY.section(shift)
    nodes = {
        "normal": section.normal,
        "equidistant": section.equidistant,
        "equidistant_chord": lambda ds, count: section.equidistant(ds, count, chords=True),
    }[separation](0.01e-3, 400)
    patch = solve_analyn(
        nodes.station,
        np.maximum(nodes.gap, 0.0),
        section.longitudinal(nodes.wheel, True),
        section.smooth_lateral(nodes, 3e-3),
        force=force,
        modulus=MODULUS,
    )
    side = (
        ContactSystem(separation=separation, lateral_curvature="smooth")
        .evaluate(lateral_shift=shift / 1e3, normal_force=force)
        .right
    )
    assert patch.penetration == pytest.approx(side.penetration, rel=0.005)
    assert patch.pressure.max() == pytest.approx(side.max_pressure, rel=0.005)
    assert patch.length == pytest.approx(side.patch_length, rel=0.003)
    assert patch.width == pytest.approx(side.patch_width, rel=0.02, abs=0.01e-3)  # in whole nodes
