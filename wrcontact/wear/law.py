"""What a law of wear is: how it is declared, what it may read, and a user's own function as one."""

import inspect
from dataclasses import fields

import numpy as np

from ..methods.numbers import Checked, number
from ..methods.words import did_you_mean

#: Density of steel [kg/m3], by which laws of volume and laws of mass agree.
STEEL = 7850.0
#: What a law, or a user's function, may read, by these names.
READ = {
    "power_density": "friction power over the strip's area [W/m2]",
    "pressure": "mean pressure of the strip [Pa]",
    "slip": "sliding velocity where the strip slides [m/s]",
    "friction": "coefficient of friction [1]",
    "speed": "rolling speed [m/s]",
    "wear_number": "T gamma of the strip's patch, without spin [N]",
    "patch_power": "friction power of the strip's patch [W]",
}


def calibration():
    """The field that every law has."""
    return number(1.0, 1e-9, 1e3, "1", "Factor on the rate, such as a share of dry running")


def required(low, high, unit, meaning):
    """A field without a default: no source of its number was read."""
    return number(None, low, high, unit, meaning)


class Law(Checked):
    """Base of the laws; ``regimes`` are the names of what ``regime`` numbers."""

    regimes: tuple = ("wear",)

    def __post_init__(self):
        missing = [one.name for one in fields(self) if getattr(self, one.name) is None]
        if missing:
            words = f"{', '.join(missing[:-1])} and {missing[-1]}" if missing[1:] else missing[0]
            raise ValueError(
                f"{type(self).__name__} needs {words}; {'they have' if missing[1:] else 'it has'} "
                "no default, since no source of them was read"
            )
        super().__post_init__()


class OwnLaw:
    """A user's function of some of the arrays in READ, by their names."""

    regimes = ("wear",)

    def __init__(self, function):
        names = inspect.signature(function).parameters
        known = [
            name for name, one in names.items() if one.kind in (one.POSITIONAL_OR_KEYWORD, one.KEYWORD_ONLY)
        ]
        for name in known:
            if name not in READ and names[name].default is inspect.Parameter.empty:
                raise ValueError(
                    f"the law reads {name!r}; permitted are {', '.join(READ)}{did_you_mean(name, READ)}"
                )
        self.function, self.names = function, [name for name in known if name in READ]
        self.takes_all = any(one.kind is one.VAR_KEYWORD for one in names.values())

    def __repr__(self):
        return getattr(self.function, "__name__", repr(self.function))

    def regime(self, *, power_density, **_):
        """All the same."""
        return np.zeros(np.shape(power_density), dtype=int)

    def rate(self, **given):
        """What the function returns."""
        return self.function(**(given if self.takes_all else {name: given[name] for name in self.names}))
