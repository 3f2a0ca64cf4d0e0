"""Hunting of the closed loop: Klingel's wave, and linear theory from Kalker's coefficients."""

import pytest

from data import hunting_theory as theory
from examples.hunting_wheelset.coupling import CONES, Loop
from examples.hunting_wheelset.hunting import KLINGEL, SOFT, SUSPENSION, cycle, elastic, growth, klingel
from examples.hunting_wheelset.stability import LINEAR, LINEAR_FRICTION, Linear


@pytest.fixture(scope="module")
def model():
    touched = elastic(CONES).evaluate(0.0).right.contact.y_track
    return theory.cones(touched, SUSPENSION)


@pytest.fixture(scope="module")
def linear(archives):
    with Linear(archives, SUSPENSION, LINEAR, LINEAR_FRICTION) as found:
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


@pytest.mark.full
def test_klingel_of_archives(archives):
    """Three millimetres: the conicity changes with the amplitude, which changes along the run."""
    wave, _, rolled, _, run = klingel(archives, *KLINGEL["S1002"])
    assert run.worst_status == 0
    assert wave == pytest.approx(rolled, rel=0.02)


@pytest.mark.parametrize("speed", [10.0, 40.0, 80.0])
def test_roots_are_those_of_linear_theory(archives, linear, model, speed):
    """Eigenvalues from the contact FMU's derivatives against those of cones, Hertz and Kalker's table. The
    patch's own shape differs by 1e-4, Kalker's coefficients by their interpolation, 0.3 %.

    Linear theory has no limit of friction, while the slopes are those that spin of the cones leaves: at
    10 m/s the damping is off by 0.0296 1/s at a friction of 0.3 and by 0.0050 1/s at 2, the largest permitted,
    with its inverse. Two frictions give the roots without a limit.
    """
    with Linear(archives, SUSPENSION, LINEAR, 0.5 * LINEAR_FRICTION) as half:
        found = 2.0 * linear.root(speed) - half.root(speed)
    wanted = theory.hunting_root(theory.state_matrix(model, speed))
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
    with Loop(archives, start, LINEAR, LINEAR_FRICTION) as loop:
        loop.run(0.1, 5e-4, derivatives=True)
        run = loop.run(0.6, 5e-4, derivatives=True)
    assert run.worst_status == 0
    assert growth(run) == pytest.approx(linear.root(speed).real, rel=0.02)


@pytest.mark.full
@pytest.mark.parametrize("beyond, start", [(0.3e-3, 0.1e-3), (5e-3, 5e-3)], ids=["small", "large"])
@pytest.mark.turns(2)
def test_limit_cycle(archives, beyond, start):
    """Beyond the critical speed of S1002 (45 m/s) a small and a large swing end in the same cycle between
    the flanges, which have 6.3 mm of play; below it the small one dies, while the large one does not.  0.3 mm
    are not small at 36 m/s: that swing grows."""
    run, amplitude = cycle(archives, 50.0, beyond, 4.0)
    assert amplitude == pytest.approx(6.38e-3, abs=0.05e-3)
    run, amplitude = cycle(archives, 36.0, start, 4.0)
    assert (amplitude < start / 2) if start < 1e-3 else (amplitude == pytest.approx(6.2e-3, abs=0.1e-3))
    with Linear(archives, SOFT) as found:
        assert 36.0 < found.critical_speed(20.0, 80.0) < 50.0


@pytest.mark.parametrize("tangential", ["polach", "fastsim", "fastrip", "strips"])
def test_each_model_of_creep_forces_has_roots(archives, model, tangential):
    """From derivatives at no lateral creepage: a model whose slope was none there had a singular matrix."""
    contact = LINEAR | {"tangential_model": tangential}
    wanted = theory.hunting_root(theory.state_matrix(model, 40.0))
    with Linear(archives, SUSPENSION, contact, LINEAR_FRICTION) as linear:
        found = linear.root(40.0)
    assert found.imag == pytest.approx(wanted.imag, rel=1e-3)
    assert found.real == pytest.approx(wanted.real, abs=5e-3 * wanted.imag)
