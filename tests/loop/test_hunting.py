"""Hunting of the closed loop: Klingel's wave, and linear theory from Kalker's coefficients."""

import numpy as np
import pytest

from examples.hunting_wheelset.coupling import CONES, Loop
from examples.hunting_wheelset.hunting import KLINGEL, SOFT, SUSPENSION, cycle, elastic, growth, klingel
from examples.hunting_wheelset.stability import Linear
from tests.helpers import hunting_theory as theory

#: Kalker's table with Hertz's patch; friction far from its limit, so that creep forces are linear.
LINEAR = CONES | {"normal_model": "hertz", "contact_damping": 0.0}
FRICTION = 2.0
#: Kalker (1990), table E3, at nu 0.28 and a/b 1.330: C11, C22, C23, by parabolas in nu and linear in b/a;
#: C33 by CONTACT for a/b = 1, which hardly counts.
COEFFICIENTS = (4.555, 4.145, 1.870, 1.14)


def theory_of_cones():
    """The same wheelset in the theory, with the rail where the package's gauge puts it."""
    touched = elastic(CONES).evaluate(0.0).right.contact.y_track
    across = 2 * SUSPENSION["lateral_stiffness"]
    return theory.Wheelset(slope=0.05, rail_y=touched + 0.3 * np.sin(np.arctan(0.05)),
                           coefficients=COEFFICIENTS,
                           springs=(across, 0.0, 0.0, 2 * SUSPENSION["longitudinal_stiffness"]))


@pytest.fixture(scope="module")
def model():
    return theory_of_cones()


@pytest.fixture(scope="module")
def linear(archives):
    with Linear(archives, SUSPENSION, LINEAR, FRICTION) as found:
        yield found


def test_axis_ratio_of_the_coefficients(model):
    _, a, b = theory.patch(model)
    assert a / b == pytest.approx(1.330, abs=1e-3)


def test_klingel_on_cones(archives):
    """Half a millimetre at 10 m/s: Klingel's wave with the package's own conicity under load, to what inertia
    and creepage leave (0.3 %)."""
    contact, start = KLINGEL["cone 1:20"]
    wave, amplitude, rolled, plain, run = klingel(archives, contact, start, waves=1.8)
    assert run.worst_status == 0
    assert wave == pytest.approx(rolled, rel=3e-3)
    assert wave == pytest.approx(plain, rel=0.02)
    assert amplitude == pytest.approx(start, rel=0.05)


@pytest.mark.slow
def test_klingel_of_archives(archives):
    """Three millimetres: the conicity changes with the amplitude, which changes along the run."""
    wave, _, rolled, _, run = klingel(archives, *KLINGEL["S1002"])
    assert run.worst_status == 0
    assert wave == pytest.approx(rolled, rel=0.02)


@pytest.mark.parametrize("speed", [10.0, 40.0, 80.0])
def test_roots_are_those_of_linear_theory(linear, model, speed):
    """Eigenvalues from the contact FMU's derivatives against those of cones, Hertz and Kalker's table. The
    patch's own shape differs by 1e-4, Kalker's coefficients by their interpolation, 0.3 %."""
    found, wanted = linear.root(speed), theory.hunting_root(theory.state_matrix(model, speed))
    assert found.imag == pytest.approx(wanted.imag, rel=1e-3)
    assert found.real == pytest.approx(wanted.real, abs=1e-3 * wanted.imag)


def test_critical_speed(linear, model):
    wanted = theory.critical_speed(model, 30.0, 100.0)
    assert linear.critical_speed(30.0, 100.0) == pytest.approx(wanted, rel=5e-3)


def test_a_run_grows_as_the_eigenvalue_says(archives, linear):
    """Past the critical speed; at 20 um the swing is linear, and steps of 0.5 ms with derivatives change the
    growth by less than 1 %."""
    speed = 80.0
    start = SUSPENSION | {"frame_speed": speed, "start_lateral_shift": 2e-5}
    with Loop(archives, start, LINEAR, FRICTION) as loop:
        loop.run(0.1, 5e-4, derivatives=True)
        run = loop.run(0.6, 5e-4, derivatives=True)
    assert run.worst_status == 0
    assert growth(run) == pytest.approx(linear.root(speed).real, rel=0.02)


@pytest.mark.slow
@pytest.mark.parametrize("start", [0.3e-3, 5e-3], ids=["small", "large"])
def test_limit_cycle(archives, start):
    """Beyond the critical speed of S1002 (40 m/s) a small and a large swing end in the same cycle between
    the flanges, which have 6.3 mm of play; below it the small one dies, while the large one does not."""
    run, amplitude = cycle(archives, 45.0, start, 4.0)
    assert amplitude == pytest.approx(6.34e-3, abs=0.05e-3)
    run, amplitude = cycle(archives, 36.0, start, 4.0)
    assert (amplitude < start / 2) if start < 1e-3 else (amplitude == pytest.approx(6.2e-3, abs=0.1e-3))
    with Linear(archives, SOFT) as found:
        assert 36.0 < found.critical_speed(20.0, 80.0) < 45.0
