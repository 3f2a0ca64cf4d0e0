"""Wheels and rails drawn at random that no designer would draw: corners, pieces of 1 um to 50 mm, steps of
printed numbers, and points that are rounded and very close to each other.

    for pair, poses in rough_pairs(seed=1, count=20, poses=100): ...

The same seed gives the same pairs, each independently of how many are drawn.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

import wrcontact
from tests.helpers.sampled_pair import SampledPair
from wrcontact.profiles import Profile, standard_profile
from wrcontact.profiles.zones import Polynomial

#: Slopes of a wheel and of half a rail's head over their abscissae [mm].
WHEEL = np.array(
    [
        (-52.0, -0.3),
        (-46.0, -2.6),
        (-38.5, -2.6),
        (-36.0, -1.4),
        (-33.0, -0.75),
        (-29.0, -0.33),
        (-24.0, -0.17),
        (-15.0, -0.08),
        (-5.0, -0.035),
        (5.0, -0.025),
        (30.0, -0.03),
        (55.0, -0.07),
    ]
).T
HEAD = np.array(
    [
        (0.0, 0.0),
        (10.25, 0.0342),
        (18.0, 0.133),
        (26.0, 0.245),
        (29.0, 0.5),
        (31.0, 0.75),
        (33.0, 1.16),
        (34.5, 1.8),
        (35.4, 2.9),
        (35.9, 5.0),
    ]
).T
RAILS = ("60E1", "54E1", "UIC60")
SHIFTS = (-9e-3, 9e-3)  # [m]
YAWS = (-0.04, 0.04)  # [rad]
SHORTEST, LONGEST = 1e-3, 50.0  # [mm]


def wheel_slope(y):
    return float(np.interp(y, *WHEEL))


def rail_slope(y):
    return float(np.sign(y) * np.interp(abs(y), *HEAD)) if y > -35.95 else -15.0


def turns(rng, steep):
    """A random change of slope where a profile is ``steep``; none in one of five."""
    return (rng.random() < 0.8) * rng.choice((-1, 1)) * 10 ** rng.uniform(-6.0, -0.75) * steep


def abscissae(rng, fixed, low, high):
    """Rising ends of zones [mm]: the ``fixed`` ones, some at random between, and behind some of all these
    another one, at a distance of SHORTEST or more."""
    y = np.append(fixed, rng.uniform(low, high, rng.integers(3, 10)))
    near = rng.uniform(low, high, rng.integers(0, 4))
    y = np.sort(np.concatenate([y, near, near + 10 ** rng.uniform(np.log10(SHORTEST), 0.0, len(near))]))
    return y[np.append(True, np.diff(y) >= SHORTEST)]


def chained(rng, y, slope, steep):
    """Parabolas between the abscissae ``y`` [mm], with corners; in half of all chains the numbers are printed
    with 4 to 8 digits, which leaves steps in height."""
    digits = rng.integers(4, 9) if rng.random() < 0.5 else 15
    zones, z = [], 0.0
    for low, high in zip(y[:-1], y[1:]):
        first, last = (slope(at) + turns(rng, steep(at)) for at in (low, high))
        c = np.array(
            [np.round(z, digits), np.round(first, digits + 1), (last - first) / (2.0 * (high - low))]
        )
        zones.append(Polynomial(low, high, tuple(map(float, c)), low))
        u = high - low
        z = c[0] + c[1] * u + c[2] * u * u
    return zones


def at_origin(zones, height):
    """The zones moved down by ``height`` [mm]."""
    return tuple(
        Polynomial(z.start, z.stop, (z.coefficients[0] - height, *z.coefficients[1:]), z.origin)
        for z in zones
    )


def heights(zones, y):
    """Heights [mm] of a chain at places ``y`` [mm]."""
    k = np.clip(np.searchsorted([zone.start for zone in zones], y, side="right") - 1, 0, None)
    return np.array([zones[i].coefficients @ (at - zones[i].origin) ** np.arange(3.0) for i, at in zip(k, y)])


def zoned_wheel(rng):
    y = abscissae(rng, [-52.0, -49.0, -46.0, -42.0, -38.5, 55.0], -38.0, 30.0)
    zones = chained(rng, y, wheel_slope, lambda at: 1.0 + abs(wheel_slope(at)))
    return Profile("w", "wheel", at_origin(zones, heights(zones, [0.0])[0]), smooth=False)


def zoned_rail(rng):
    fixed = [-36.6, -35.9, -35.5, -34.5, -32.0, -29.0, -26.0, 26.0, 29.0, 32.0, 34.5]
    y = abscissae(rng, fixed, -25.0, 25.0)
    zones = chained(
        rng, y, rail_slope, lambda at: 0.3 * np.hypot(1.0, rail_slope(at)) * float(abs(at) < 33.0)
    )
    top = heights(zones, np.linspace(y[0], y[-1] - 1e-9, 5001)).min()
    return Profile("r", "rail", at_origin(zones, top), smooth=False)


def pointed(rng, kind):
    """A standard profile as points: every quarter millimetre, and very close to each other in a stretch;
    heights with 3 to 8 digits."""
    whole = standard_profile("S1002" if kind == "wheel" else str(rng.choice(RAILS)))
    ends = (-60.0, 55.0) if kind == "wheel" else (-35.9, 35.9)
    middle, step = (
        rng.uniform(-40.0, 10.0) if kind == "wheel" else rng.uniform(-35.0, 10.0),
        10 ** rng.uniform(-3, -0.7),
    )
    fine = np.arange(max(middle - 200 * step, ends[0]), min(middle + 200 * step, ends[1]), step)
    y = np.sort(np.append(np.arange(*ends, 0.25), fine))
    y = y[np.append(True, np.diff(y) >= 0.9 * step)]
    z = np.round(whole.height(y * 1e-3) * 1e3, rng.integers(3, 9))
    return Profile.from_points(y, z, name="p", kind=kind)


@dataclass(frozen=True)
class RoughPair:
    """A wheel on a rail, in the product and sampled."""

    wheel: Profile
    rail: Profile
    inclination: float

    @cached_property
    def system(self):
        return wrcontact.ContactSystem(wheel=self.wheel, rail=self.rail, rail_inclination=self.inclination)

    @cached_property
    def sampled(self):
        return SampledPair(self.wheel.zones, self.rail.zones, self.inclination)


def draw_pair(rng):
    wheel = pointed(rng, "wheel") if rng.random() < 0.25 else zoned_wheel(rng)
    kind = rng.random()
    rail = (
        pointed(rng, "rail")
        if kind < 0.25
        else zoned_rail(rng)
        if kind < 0.75
        else standard_profile(str(rng.choice(RAILS)))
    )
    return RoughPair(wheel, rail, float(rng.choice([0.0, 1 / 40, 1 / 20])))


def rough_pairs(seed, count, poses, first=0):
    """``count`` pairs, from number ``first`` on, each with the lateral shifts of its ``poses`` [m] and yaws
    [rad]."""
    for number in range(first, first + count):
        rng = np.random.default_rng([seed, number])
        yield number, draw_pair(rng), rng.uniform(*SHIFTS, poses), rng.uniform(*YAWS, poses)
