"""Units of all that crosses the border, each with the unit that people want to see."""

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Unit:
    """A unit as a product of SI base units.

    ``base`` holds the exponents of kg, m, s, rad; a value shown in ``display`` is ``display_factor`` times
    the value.
    """

    name: str
    base: dict
    quantity: str = ""
    display: str = ""
    display_factor: float = 1.0


def by_name(*rows):
    """Units, or rows of another kind, by their names; ValueError for a name that two of them have."""
    found = {row.name: row for row in rows}
    if len(found) < len(rows):
        names = [row.name for row in rows]
        kind = type(rows[0]).__name__.lower()
        raise ValueError(f"{kind} {max(names, key=names.count)!r} is declared twice")
    return found


UNITS = by_name(
    Unit("m", {"m": 1}, "Length", "mm", 1e3),
    Unit("rad", {"rad": 1}, "Angle", "deg", 180.0 / math.pi),
    Unit("N", {"kg": 1, "m": 1, "s": -2}, "Force", "kN", 1e-3),
    Unit("N/m", {"kg": 1, "s": -2}, "TranslationalSpringConstant"),
    Unit("N.m", {"kg": 1, "m": 2, "s": -2}, "Moment", "kN.m", 1e-3),
    Unit("W", {"kg": 1, "m": 2, "s": -3}, "Power", "kW", 1e-3),
    Unit("W/m", {"kg": 1, "m": 1, "s": -3}),
    Unit("Pa", {"kg": 1, "m": -1, "s": -2}, "Pressure", "MPa", 1e-6),
    Unit("m2", {"m": 2}, "Area", "mm2", 1e6),
    Unit("1/m", {"m": -1}, "Curvature"),
    Unit("s", {"s": 1}, "Time"),
    Unit("N.s/m", {"kg": 1, "s": -1}, "TranslationalDampingConstant"),
    Unit("m/s", {"m": 1, "s": -1}, "Velocity"),
    Unit("s/m", {"m": -1, "s": 1}),
    Unit("rad/s", {"s": -1, "rad": 1}, "AngularVelocity"),
    Unit("1", {}),
)
