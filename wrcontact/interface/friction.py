"""Friction between wheel and rail: its inputs, rows of the table in inputs.py, and the numbers by which it
depends on the contact angle, the sliding and the creepage."""

from ..methods.numbers import Checked, frozen, number
from .rows import Input

#: Largest coefficient of friction [1]; beyond it a value is rather an error.
FRICTION_LIMIT = 2.0

FRICTION = tuple(
    Input(
        f"{side}.friction",
        "1",
        0.3,
        "coefficient of friction, read with a tangential_model",
        0.0,
        FRICTION_LIMIT,
        start=0.3,
        field=f"{side}_friction",
        place=f"{side.capitalize()} wheel",
    )
    for side in ("left", "right")
)


@frozen
class Friction(Checked):
    """What becomes of the coefficient of friction in a patch; with the defaults it is that of the input
    (Coulomb).

    ``flange_friction_ratio`` times the input on the flange, about ``flange_friction_angle`` [rad];
    ``friction_fall`` [1] and ``friction_fall_rate`` [s/m]: falling friction (Polach 2005);
    ``slope_reduction``, ``slope_reduction_floor``, ``slope_reduction_rate`` [1]: wet and dirty rails
    (Spiryagin, Polach, Cole 2013).
    """

    flange_friction_ratio: float = number(
        1.0, 0.0, 10.0, "1", "Friction on a lubricated flange over that on the tread; 1: the same everywhere"
    )
    flange_friction_angle: float = number(
        0.6,
        0.2,
        1.2,
        "rad",
        "Contact angle half-way between the friction of the tread and that of the flange; it changes over "
        "0.2 rad (11.5 deg) to either side",
    )
    friction_fall: float = number(
        1.0,
        0.0,
        1.0,
        "1",
        "Friction at infinite sliding velocity over that without sliding; 1: no fall (A of Polach 2005)",
    )
    friction_fall_rate: float = number(
        0.0,
        0.0,
        100.0,
        "s/m",
        "How fast friction falls with the sliding velocity (B of Polach 2005)",
        nominal=1.0,
    )
    slope_reduction: float = number(
        1.0,
        0.01,
        1.0,
        "1",
        "Initial slope of the creep force over that of clean rails; 1: clean (k0 of "
        "Spiryagin, Polach, Cole 2013)",
    )
    slope_reduction_floor: float = number(
        0.02,
        0.0,
        1.0,
        "1",
        "Share of the slope that is left at large creepage where slope_reduction_rate is above 0 (alpha)",
        nominal=0.1,
    )
    slope_reduction_rate: float = number(
        0.0, 0.0, 10.0, "1", "How fast the slope falls with creepage; 0: it does not (beta)", nominal=1.0
    )
