"""Laws of wear: what a rubbing surface loses per area and time.

A law has one method, ``rate``, whose arguments are arrays in SI, and returns mass per area and time
[kg/(m2 s)], the mean over the length of a strip.  Every law has a ``calibration``, a factor on its rate:
laboratory numbers of dry discs wear much faster than wheels in service (docs/guides/wear.md).

Only a constant that was read in a source has a default.  The others have to be given.

>>> round(float(Usfd().rate(power_density=5e6 * 20.0, speed=20.0)), 6)      # 20 m/s, T gamma / A = 5 N/mm2
0.53
>>> Zobory()
Traceback (most recent call last):
ValueError: Zobory needs mild, severe and limit; they have no default, since no source of them was read
"""

import inspect
from dataclasses import fields
from numbers import Real

import numpy as np

from ..methods.numbers import frozen, number
from .law import READ, STEEL, Law, OwnLaw, calibration, required

#: Where a user's law is tried to tell it from others: decades of each of its arrays, and how many places.
PROBED = {
    "power_density": (2.0, 11.0),
    "pressure": (6.0, 10.0),
    "slip": (-5.0, 1.5),
    "friction": (-2.0, 0.0),
    "speed": (-1.0, 2.0),
    "wear_number": (-2.0, 4.0),
    "patch_power": (-2.0, 6.0),
}
PROBES = 1000


@frozen
class Usfd(Law):
    """T gamma / A law of the University of Sheffield for R8T wheels on 900A rails, dry twin discs.

    With x = power_density / speed, that is T gamma / A with spin [N/m2], a rolled metre takes

        K = mild x               for x < first
            plateau              for first <= x < second
            steep (x - second) + plateau    beyond          [kg/m/m2]

    Source: Lewis, Dwyer-Joyce, Proc. IMechE J 218 (2004) 467-478, and Braghin, Lewis, Dwyer-Joyce, Bruni,
    Wear 261 (2006) 1253-1264; the numbers were read in a public implementation of both: 5.3 x below
    10.4 N/mm2, 55.0, and 61.9 x - 4778.7 beyond 77.2 N/mm2, in ug/m/mm2.

    Errata: the last branch as printed is 61.9 (x - 77.2), which is zero at 77.2; the plateau is added here.
    5.3 x 10.4 is 55.1 and not 55.0; that jump of 0.2 % stays.
    """

    calibration: float = calibration()
    mild: float = number(5.3e-9, 0.0, 1e-3, "kg/J", "Mass per friction work in mild wear")
    plateau: float = number(55e-3, 0.0, 1e3, "kg/m3", "Mass per rolled metre and area in severe wear")
    steep: float = number(61.9e-9, 0.0, 1e-3, "kg/J", "Mass per further friction work in catastrophic wear")
    first: float = number(10.4e6, 0.0, 1e12, "N/m2", "T gamma over area at which severe wear begins")
    second: float = number(77.2e6, 0.0, 1e12, "N/m2", "T gamma over area at which catastrophic wear begins")
    regimes = ("mild", "severe", "catastrophic")

    def regime(self, *, power_density, speed, **_):
        """0, 1 or 2 for each strip."""
        x = power_density / speed
        return np.where(x < self.first, 0, np.where(x < self.second, 1, 2))

    def rate(self, power_density, pressure=None, slip=None, friction=None, *, speed, **_):
        """Mass per area and time [kg/(m2 s)]."""
        x = power_density / speed
        beyond = self.steep * (x - self.second) + self.plateau
        loss = np.where(x < self.first, self.mild * x, np.where(x < self.second, self.plateau, beyond))
        return (self.calibration * speed * loss)[()]


@frozen
class ArchardMap(Law):
    """Archard's law with a coefficient k from a map over sliding velocity and pressure, as at KTH.

        rate = density k power_density / (friction hardness)

    Where a strip slides, q = friction p, so that this is the integral of k p s / H along the strip, whatever
    the pressure's distribution is.  k is ``slow`` below the sliding velocity ``first``, ``middle`` below
    ``second``, ``fast`` beyond; ``pressed`` where the pressure is above ``share`` times the hardness.
    ``blend`` replaces each step by a straight line over this share of the edge on either side.

    Source: the form is Jendel, Wear 253 (2002) 90-99, and Enblom, Berg, Proc. IMechE F 219 (2005); neither
    was read, so that no number has a default.
    """

    calibration: float = calibration()
    hardness: float = required(1e6, 1e12, "Pa", "Hardness of the softer body")
    slow: float = required(0.0, 1.0, "1", "Coefficient k at small sliding velocities")
    middle: float = required(0.0, 1.0, "1", "Coefficient k at middle sliding velocities")
    fast: float = required(0.0, 1.0, "1", "Coefficient k at large sliding velocities")
    pressed: float = required(0.0, 1.0, "1", "Coefficient k at high pressure")
    first: float = required(0.0, 100.0, "m/s", "Sliding velocity between slow and middle")
    second: float = required(0.0, 100.0, "m/s", "Sliding velocity between middle and fast")
    share: float = required(0.0, 10.0, "1", "Pressure over hardness at which high pressure begins")
    blend: float = number(0.0, 0.0, 0.9, "1", "Share of an edge over which k changes, to either side")
    regimes = ("slow", "middle", "fast", "pressed")

    def regime(self, *, pressure, slip, **_):
        """0 ... 3 for each strip, as without ``blend``."""
        sliding = np.where(slip < self.first, 0, np.where(slip < self.second, 1, 2))
        return np.where(pressure > self.share * self.hardness, 3, sliding)

    def coefficient(self, pressure, slip):
        """k for each strip."""
        k = (
            self.slow
            + (self.middle - self.slow) * self._behind(slip, self.first)
            + (self.fast - self.middle) * self._behind(slip, self.second)
        )
        edge = self.share * self.hardness
        high = np.where(pressure > edge, 1.0, 0.0) if self.blend == 0.0 else self._behind(pressure, edge)
        return k + (self.pressed - k) * high

    def _behind(self, values, edge):
        """0 before an ``edge``, 1 from it on, or a straight line in between."""
        if self.blend == 0.0:
            return np.where(values >= edge, 1.0, 0.0)
        return np.clip((values / edge - 1.0 + self.blend) / (2.0 * self.blend), 0.0, 1.0)

    def rate(self, power_density, pressure, slip, friction, **_):
        """Mass per area and time [kg/(m2 s)]."""
        if np.any(np.isnan(friction) & (np.asarray(power_density) > 0.0)):
            raise ValueError("friction is not known; ArchardMap needs left.friction and right.friction")
        k = self.coefficient(pressure, slip)
        return self.calibration * STEEL * k * power_density / (friction * self.hardness)


@frozen
class BritishRail(Law):
    """T gamma law of British Rail Research: cross-section that a wheel loses per distance, for each patch.

    With T gamma without spin, a wheel of the diameter D loses, per metre run,

        mild Tg / D              for Tg < first
        plateau / D              for first <= Tg < second
        (steep Tg - offset) / D  beyond                  [m2/m]

    D cancels: the mass per metre is density pi times the numerator.  It is spread over a patch like the
    friction power.  1 mm2/km times mm over N is 1e-12 m2/N.

    Source: the form is Pearce, Sherratt, Wear 144 (1991) 343-351, which was not read, so that no number has a
    default.
    """

    calibration: float = calibration()
    mild: float = required(0.0, 1e-6, "m2/N", "Loss times diameter per T gamma in mild wear")
    plateau: float = required(0.0, 1e-3, "m2", "Loss times diameter in between")
    steep: float = required(0.0, 1e-6, "m2/N", "Loss times diameter per T gamma in severe wear")
    offset: float = required(0.0, 1e-3, "m2", "What is taken off that")
    first: float = required(0.0, 1e6, "N", "T gamma at which mild wear ends")
    second: float = required(0.0, 1e6, "N", "T gamma at which severe wear begins")
    regimes = ("mild", "plateau", "severe")

    def regime(self, *, wear_number, **_):
        """0, 1 or 2 for each strip, that of its patch."""
        return np.where(wear_number < self.first, 0, np.where(wear_number < self.second, 1, 2))

    def loss(self, wear_number):
        """Loss of cross-section per distance, times the diameter [m2]."""
        beyond = self.steep * wear_number - self.offset
        return np.where(
            wear_number < self.first,
            self.mild * wear_number,
            np.where(wear_number < self.second, self.plateau, beyond),
        )[()]

    def rate(
        self, power_density, pressure=None, slip=None, friction=None, *, speed, wear_number, patch_power, **_
    ):
        """Mass per area and time [kg/(m2 s)]."""
        if np.any(np.isnan(wear_number) & (np.asarray(power_density) > 0.0)):
            raise ValueError(
                "T gamma is not known; BritishRail needs creepage.x, creepage.y, tangential.x "
                "and tangential.y of each patch"
            )
        each = np.pi * STEEL * self.loss(wear_number) * speed / np.where(patch_power > 0.0, patch_power, 1.0)
        return self.calibration * each * power_density


@frozen
class Zobory(Law):
    """Mass in proportion to friction work, with another factor where the friction power is dense.

    rate = k power_density, with k ``mild`` below ``limit`` and ``severe`` from there on.

    Source: the form is Zobory, Vehicle System Dynamics 28 (1997) 221-259, which was not read, so that no
    number has a default.
    """

    calibration: float = calibration()
    mild: float = required(0.0, 1e-3, "kg/J", "Mass per friction work below the limit")
    severe: float = required(0.0, 1e-3, "kg/J", "Mass per friction work from the limit on")
    limit: float = required(0.0, 1e12, "W/m2", "Friction power per area between the two")
    regimes = ("mild", "severe")

    def regime(self, *, power_density, **_):
        """0 or 1 for each strip."""
        return np.where(power_density < self.limit, 0, 1)

    def rate(self, power_density, pressure=None, slip=None, friction=None, **_):
        """Mass per area and time [kg/(m2 s)]."""
        k = np.where(power_density < self.limit, self.mild, self.severe)
        return self.calibration * k * power_density


def law_mark(law):
    """What a ``law`` is, as text that is the same for the same law in another process: its class and numbers, and
    of a user's function what it returns at PROBES places and the numbers that it reads."""
    if type(law) in LAWS.values():
        return repr((type(law).__name__, *((one.name, getattr(law, one.name)) for one in fields(law))))
    draw = np.random.default_rng(0)
    places = {name: 10.0 ** draw.uniform(low, high, PROBES) for name, (low, high) in PROBED.items()}
    with np.errstate(all="ignore"):
        try:
            rates = np.broadcast_to(np.asarray(law.rate(**places), dtype=float), PROBES).round(15).tolist()
        except Exception as refused:  # a user's function may refuse what never occurs
            rates = type(refused).__name__
    function = getattr(law, "function", law)
    return repr((type(law).__name__, rates, sorted(map(repr, _numbers_of(function)))))


def _numbers_of(function):
    """The numbers in a user's ``function``: constants, defaults, those of its closure, its globals and its object."""
    inside = inspect.unwrap(getattr(function, "__func__", function))
    code = getattr(inside, "__code__", None)
    found = [*vars(getattr(function, "__self__", function)).values()] if hasattr(function, "__dict__") else []
    found += [
        *getattr(function, "args", ()),
        *getattr(function, "keywords", {}).values(),
    ]  # functools.partial
    if code is not None:
        reads = inspect.getclosurevars(inside)
        found += [*code.co_consts, *(inside.__defaults__ or ()), *(inside.__kwdefaults__ or {}).values()]
        found += [*reads.nonlocals.values(), *reads.globals.values()]
    words = getattr(inside, "__doc__", None)
    return [
        one for one in found if isinstance(one, (Real, np.ndarray)) or isinstance(one, str) and one != words
    ]


LAWS = {"usfd": Usfd, "archard": ArchardMap, "british-rail": BritishRail, "zobory": Zobory}


def law_of(law):
    """``law`` as an object with ``rate`` and ``regime``; ValueError if it is none.

    >>> law_of(lambda power_density: 1e-9 * power_density).rate(power_density=3.0, slip=0.1)
    3.0000000000000004e-09
    """
    if isinstance(law, (type, str)) or not (hasattr(law, "rate") or callable(law)):
        raise ValueError(
            f"law is {law!r}; permitted are Usfd(), ArchardMap(...), BritishRail(...), "
            f"Zobory(...), and a function of {', '.join(READ)}"
        )
    if hasattr(law, "rate"):
        return law if hasattr(law, "regime") else OwnLaw(law.rate)
    return OwnLaw(law)
