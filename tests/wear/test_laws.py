"""Laws of wear: values at their boundaries, closed forms of a locked wheel, and a march along a strip."""

import numpy as np
import pytest

import wrcontact
from tests.helpers.paths import ROOT
from tests.helpers.wear_cases import ARCHARD, BRITISH_RAIL, ZOBORY
from wrcontact.wear.cells import sliding
from wrcontact.wear.law import STEEL
from wrcontact.wear.laws import LAWS, law_of

EXACT = 1e-12
PRINTED = np.genfromtxt(
    ROOT / "data" / "wear_laws.csv", delimiter=",", dtype=None, names=True, encoding="utf-8"
)
#: A locked wheel slides everywhere: load [N], friction, speed [m/s], patch [m].
LOAD, FRICTION, SPEED, LENGTH, WIDTH = 70e3, 0.35, 0.15, 12e-3, 8e-3


@pytest.mark.parametrize("row", PRINTED[PRINTED["law"] == "Usfd"], ids=lambda row: f"{row['x']:g}")
def test_usfd_has_the_printed_values(row):
    """1 ug/m/mm2 is 1e-3 kg/m3, 1 N/mm2 is 1e6 N/m2."""
    for speed in (0.3, 20.0):
        rate = wrcontact.Usfd().rate(power_density=row["x"] * 1e6 * speed, speed=speed)
        assert rate / speed == pytest.approx(row["y"] * 1e-3, rel=EXACT)


def test_usfd_jumps_by_two_thousandths_at_its_first_boundary_and_nowhere_else():
    law = wrcontact.Usfd()
    first, second = (np.array([edge * (1 - 1e-13), edge]) for edge in (law.first, law.second))
    below, beyond = law.rate(power_density=first, speed=1.0)
    assert beyond / below == pytest.approx(55.0 / (5.3 * 10.4), rel=1e-9)
    below, beyond = law.rate(power_density=second, speed=1.0)
    assert beyond == pytest.approx(below, rel=1e-9)


@pytest.mark.parametrize("row", PRINTED[PRINTED["law"] == "BritishRail"], ids=lambda row: f"{row['x']:g}")
def test_british_rail_takes_the_printed_area_off_a_wheel_of_920_mm(row):
    speed, power = 25.0, row["x"] * 25.0 * 1.3  # spin gives more power than T gamma
    rate = wrcontact.BritishRail(**BRITISH_RAIL).rate(
        power_density=power / (LENGTH * WIDTH), speed=speed, wear_number=row["x"], patch_power=power
    )
    around, per_metre = np.pi * 0.92, rate * LENGTH * WIDTH / (speed * STEEL)  # [m], [m3/m]
    assert per_metre / around / 1e-9 == pytest.approx(row["y"], abs=1e-9)  # printed with nine digits
    exact = {50.0: 0.25 * 50, 150.0: 25.0, 400.0: 1.19 * 400 - 154}
    if row["x"] in exact:
        assert per_metre / around / 1e-9 == pytest.approx(exact[row["x"]] / 920.0, rel=EXACT)


def locked():
    """What a law reads of a wheel that slides on its rail without turning."""
    pressure = LOAD / (LENGTH * WIDTH)
    return {
        "power_density": FRICTION * pressure * SPEED,
        "pressure": pressure,
        "slip": SPEED,
        "friction": FRICTION,
        "speed": SPEED,
    }


def test_a_locked_wheel_loses_archard_s_volume():
    """k N s / H for each metre that slides."""
    rate = wrcontact.ArchardMap(**ARCHARD).rate(**locked())
    volume = rate * LENGTH * WIDTH / SPEED / STEEL
    assert volume == pytest.approx(5e-4 * LOAD / 3e9, rel=EXACT)


def test_a_locked_wheel_loses_the_mass_of_mild_wear():
    """5.3e-9 kg/J times friction N s."""
    slow = {**locked(), "power_density": locked()["power_density"] * 0.03}  # T gamma / A below 10.4 N/mm2
    rate = wrcontact.Usfd().rate(**slow)
    assert rate * LENGTH * WIDTH / SPEED == pytest.approx(5.3e-9 * FRICTION * LOAD * 0.03, rel=EXACT)


@pytest.mark.parametrize(
    "slip, pressure, k",
    [
        (0.0, 1e9, 5e-4),
        (0.2 * (1 - 1e-12), 1e9, 5e-4),
        (0.2, 1e9, 35e-4),
        (0.7 * (1 - 1e-12), 1e9, 35e-4),
        (0.7, 1e9, 5e-4),
        (0.1, 2.4e9, 5e-4),
        (0.1, 2.4e9 * (1 + 1e-12), 350e-4),
    ],
)
def test_the_map_has_sharp_edges(slip, pressure, k):
    law = wrcontact.ArchardMap(**ARCHARD)
    assert law.coefficient(pressure, slip) == pytest.approx(k, rel=EXACT)
    rate = law.rate(power_density=1e6, pressure=pressure, slip=slip, friction=0.3)
    assert rate == pytest.approx(STEEL * k * 1e6 / (0.3 * 3e9), rel=EXACT)


def test_the_map_can_have_blunt_edges():
    law = wrcontact.ArchardMap(**ARCHARD, blend=0.1)
    slip = np.array([0.1799, 0.19, 0.2, 0.21, 0.2201])
    assert law.coefficient(1e9, slip) == pytest.approx([5e-4, 12.5e-4, 20e-4, 27.5e-4, 35e-4], rel=1e-9)


def test_zobory_s_factor_depends_on_the_density():
    law = wrcontact.Zobory(**ZOBORY)
    density = np.array([4e6 * (1 - 1e-13), 4e6])
    assert law.rate(power_density=density) == pytest.approx([7e-10 * 4e6, 2.1e-9 * 4e6], rel=EXACT)


@pytest.mark.parametrize("name", LAWS)
def test_calibration_is_a_factor(name):
    constants = {"usfd": {}, "archard": ARCHARD, "british-rail": BRITISH_RAIL, "zobory": ZOBORY}[name]
    read = {**locked(), "wear_number": 150.0, "patch_power": 5e3}
    whole, part = (LAWS[name](**constants, calibration=factor).rate(**read) for factor in (1.0, 0.04))
    assert part == pytest.approx(0.04 * whole, rel=EXACT) and whole > 0.0


def march(half, peak, creepage, flexibility, points, friction=0.35, speed=20.0):
    """FASTSIM's march along a strip under an elliptic pressure: friction power per width [W/m], the integral
    of p s where it slides, and the force per width [N/m].  ``flexibility`` is L [m/Pa]."""
    x = half * np.linspace(1.0, -1.0, points + 1)
    x = 0.5 * (x[1:] + x[:-1])
    step, traction, power, rubbed, force, load = 2 * half / points, 0.0, 0.0, 0.0, 0.0, 0.0
    for at in x:
        limit = friction * peak * np.sqrt(max(1.0 - (at / half) ** 2, 0.0))
        trial = traction + creepage * step / flexibility
        new = min(trial, limit)
        sliding_speed = speed * flexibility * (trial - new) / step
        power, rubbed = power + new * sliding_speed * step, rubbed + limit / friction * sliding_speed * step
        traction, force = new, force + new * step
        load += limit * step if trial > limit else 0.0
    return power, rubbed, force, load / friction


def strips(count=30):
    """Half-length [m], peak pressure [Pa], creepage and flexibility [m/Pa] of random strips."""
    draw = np.random.default_rng(5)
    for _ in range(count):
        half = draw.uniform(2e-3, 9e-3)
        yield (
            half,
            draw.uniform(3e8, 1.5e9),
            10 ** draw.uniform(-3.3, -1.8),
            draw.uniform(0.5, 2.0) * 8 * half / (3 * 8.2e10 * 4.3),
        )


def test_archard_needs_no_distribution_along_the_strip():
    """k P' / (friction H V) against the integral of k p s / H along 30 strips of 200 points."""
    law = wrcontact.ArchardMap(**ARCHARD)
    for strip in strips():
        power, rubbed, *_ = march(*strip, points=200)
        rate = law.rate(power_density=power / (2 * strip[0]), pressure=1e8, slip=0.01, friction=0.35)
        assert rate * 2 * strip[0] / STEEL == pytest.approx(5e-4 * rubbed / 3e9, rel=1e-2), strip


def test_the_sliding_velocity_is_that_of_the_part_that_slides():
    """Power over friction times the load that slides, which follows from the saturation."""
    for strip in strips():
        power, _, force, load = march(*strip, points=4000)
        found = sliding(power, 0.5 * np.pi * strip[0] * strip[1], power / force, 0.35)
        assert found == pytest.approx(power / (0.35 * load), rel=0.02), strip


@pytest.mark.parametrize(
    "wrong, words",
    [
        (lambda: law_of("usfd"), "law is 'usfd'; permitted are Usfd()"),
        (lambda: law_of(wrcontact.Usfd), "permitted are Usfd()"),
        (
            lambda: law_of(lambda powerdensity: 0.0),
            "the law reads 'powerdensity'; permitted are power_density",
        ),
        (lambda: wrcontact.Usfd(calibration=0.0), "calibration is 0.0; permitted is 1e-09"),
        (
            lambda: wrcontact.ArchardMap(hardness=3e9),
            "ArchardMap needs slow, middle, fast, pressed, first, second and share; they have no default",
        ),
        (lambda: wrcontact.BritishRail(), "BritishRail needs mild, plateau"),
        (lambda: wrcontact.Zobory(mild=1e-9, severe=2e-9), "Zobory needs limit; it has no default"),
    ],
)
def test_wrong_laws_are_refused_in_a_sentence(wrong, words):
    with pytest.raises(ValueError) as refused:
        wrong()
    assert words in str(refused.value) and "\n" not in str(refused.value)
