"""The vehicle of docs/guides/vehicle.md in exudyn: weight, hunting against linear theory, bulge, curve."""

import re
from importlib.util import find_spec

import numpy as np
import pytest

from examples.vehicle import hunting, runs, theory
from examples.vehicle import manchester as vehicle
from examples.vehicle.contact import NEAR, Contact, Nearby, contact_system
from examples.vehicle.track import Track, bulge, irregular
from tests.helpers.paths import ROOT
from wrcontact.kernel.binding.library import default_kernel

exudyn = pytest.mark.skipif(not find_spec("exudyn"), reason="exudyn is not installed")
compiled = pytest.mark.skipif(
    not default_kernel().compiled,
    reason="the derivatives are those of the compiled library, and none is here",
)
PAGE = (ROOT / "docs" / "guides" / "vehicle.md").read_text(encoding="utf-8")


def test_places_on_a_circle():
    """Closed form: a curve without transition is a circle about a point to the right."""
    track = Track(displacement=lambda distance: 1e-3, radius=300.0, begin=10.0, transition=1e-9)
    for angle, shift in ((0.05, 0.0), (0.2, 5e-3), (0.4, -8e-3)):
        out = 300.0 - shift
        place = 10.0 + out * np.sin(angle), 300.0 - out * np.cos(angle)
        distance, found, heading, curvature = track.at(*place)
        assert distance == pytest.approx(10.0 + 300.0 * angle, abs=1e-5)
        assert found == pytest.approx(shift - 1e-3, abs=2e-6)
        assert heading == pytest.approx(angle, abs=1e-7) and curvature == pytest.approx(1 / 300.0)
    assert Track(bulge).at(30.0, 5e-3) == pytest.approx((30.0, 1e-3, 0.0, 0.0))


@pytest.mark.full
def test_irregular_track_has_its_spectrum():
    """Its variance is the integral of the spectrum, in the mean of several seeds."""
    way = np.arange(100.0, 5000.0, 1.0)
    found = np.mean([np.var([irregular(seed)(s) for s in way]) for seed in range(3)])
    wave = np.linspace(2 * np.pi / 50, 2 * np.pi / 3, 100_000)
    density = 2.119e-7 * 0.8246**2 / ((0.0206**2 + wave**2) * (0.8246**2 + wave**2))
    assert found == pytest.approx(np.trapezoid(density, wave), rel=0.03)


@compiled
def test_near_motions_are_answered_by_derivatives():
    system = contact_system()
    stands = system.evaluate(1e-3, normal_force=vehicle.LOAD / 2).equilibrium
    motion = dict.fromkeys(NEAR, 0.0) | {
        "lateral_shift": 1e-3,
        "vertical_shift_input": stands.vertical_shift,
        "roll_input": stands.roll,
        "yaw": 1e-3,
        "speed": 30.0,
        "wheel_rate": 30.0 / vehicle.WHEEL_RADIUS,
    }
    near, exact = Nearby(system, vehicle.LOAD / 2), Contact(system, vehicle.LOAD / 2)
    near.resultant(motion)
    for name, size in NEAR.items():
        moved = motion | {name: motion[name] + 0.5 * size}
        wanted = exact.resultant(moved)
        np.testing.assert_allclose(near.resultant(moved), wanted, rtol=1e-6, atol=0.05)  # [N]
    assert (near.steps, near.derivatives) == (1, 1)
    far = motion | {"yaw": motion["yaw"] + 3e-7}
    assert np.array_equal(near.resultant(far), exact.resultant(far)) and near.steps == 2


@exudyn
def test_weight():
    run = runs.vehicle(40.0).run(0.05, 0.5e-3)
    for side in ("left", "right"):
        assert run[f"{side}_load"] == pytest.approx(vehicle.LOAD / 2, rel=3e-4)  # [N]; 2.2e-4
    assert run.failed == 0 and run.calls == 20.0  # four stages and a start of RK44, four wheelsets


@exudyn
@pytest.mark.full
@pytest.mark.parametrize("model", ["strips", "fastsim"])
def test_critical_speed(model):
    half, speeds = hunting.touching(), (77.0, 82.0)
    growths = [hunting.grown(speed, theory.root(speed, half).imag, model, 1.4)[0] for speed in speeds]
    # strips 0.6 %, fastsim 0.1 %
    assert hunting.critical_speed(speeds, growths) == pytest.approx(theory.critical_speed(half), rel=0.01)


@exudyn
@compiled
@pytest.mark.full
def test_implicit_and_explicit_solvers_agree_over_the_bulge():
    """And what the page says of their cost holds."""
    explicit = runs.over_bulge("`RK44`")
    implicit = runs.over_bulge("full Newton, near motions by derivatives")
    largest = [np.abs(run.places[:, :4, 1]).max() for run in (explicit, implicit)]
    assert largest[1] == pytest.approx(largest[0], rel=1e-3) and not explicit.failed and not implicit.failed
    assert implicit.calls < 30
    assert f"| {1e3 * largest[0]:.3f} |" in re.search(r"^\| `RK44` .*$", PAGE, re.MULTILINE)[0]


@exudyn
@pytest.mark.full
def test_forces_in_the_curve():
    """Newton's law for all bodies together."""
    pushed, needed = runs.needed_in_curve(runs.through_curve(3.0))
    assert needed > 25e3 and pushed == pytest.approx(needed, rel=1e-3)  # [N]; 1.2e-4
