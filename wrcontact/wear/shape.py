"""What a workshop measures on a wheel, from its profile.

Heights of the flange count from the running circle, y = 0.  The flange's back is where the end of the profile
on the flange side is vertical, or becomes so along the circle of its rounding; a profile that ends before has
no thickness.  Flange height, thickness (10 mm above the running circle) and qR (from there to 2 mm below
the tip) are those of EN 15313; S1002 has a height of 28 mm and a thickness of 32.5 mm.
"""

import math
import warnings
from dataclasses import dataclass

import numpy as np

from ..results.words import ShortText

#: Height above the running circle at which the flange is measured, and depth below its tip for qR [m].
ABOVE, BELOW_TIP = 10e-3, 2e-3
#: A wheel without a flange is lower than this [m].
FLANGE = 15e-3
#: The end of a profile is the flange's back, or on its rounding, if the rounding is at least as steep [1]; its
#: circle goes through the directions at the end and ROUNDING [m] before it.
STEEP, ROUNDING = 5.0, 2e-3
#: Where the tread begins on the flange side, for the hollow [m].
TREAD = -15e-3
#: Amplitude of the equivalent conicity [m], and lateral shifts by which it is found [m].
AMPLITUDE = 3e-3
SHIFTS = np.linspace(-8e-3, 8e-3, 321)
#: Spacing of points [m]; that of curvatures, and the range in which they count [m].
STEP = 0.02e-3
BENT = (-40e-3, 40e-3)


@dataclass(frozen=True, repr=False)
class WheelShape(ShortText):
    """Dimensions of a wheel [m], NaN without a flange.

    flange_height, flange_thickness, flange_steepness : Sh, Sd and qR.
    hollow : how much higher the tread's outer part is than a place nearer to the flange, in radius.
    radius_loss : at the running circle, against the new profile.
    curvature : largest absolute curvature between y = -40 and 40 mm [1/m].
    worn_area : cross-section that was taken off.
    """

    flange_height: float
    flange_thickness: float
    flange_steepness: float
    hollow: float
    radius_loss: float
    curvature: float
    worn_area: float


def wheel_shape(profile, new=None, worn_area=0.0):
    """The :class:`WheelShape` of a wheel ``profile``, against the ``new`` one.

    >>> from ..profiles.catalogue import standard_profile
    >>> shape = wheel_shape(standard_profile("S1002"))
    >>> round(1e3 * shape.flange_height, 2), round(1e3 * shape.flange_thickness, 2), shape.hollow
    (28.0, 32.5, 0.0)
    """
    y = np.arange(profile.start + 1e-6, profile.stop, STEP)
    z = profile.height(y)
    level = float(profile.height(0.0))
    height, thickness, steepness = _flange(y, z - level, flange_back(profile))
    tread = z[y > TREAD]
    behind = np.maximum.accumulate(tread[::-1])[::-1]  # highest radius from here outwards
    inner = np.minimum.accumulate(tread)
    hollow = max(float(np.max(behind - inner)), 0.0)
    lost = float(new.height(0.0)) - level if new is not None else 0.0
    bent = y[(y >= BENT[0]) & (y <= BENT[1])]
    return WheelShape(
        height,
        thickness,
        steepness,
        hollow if hollow > 1e-9 else 0.0,
        lost,
        float(np.max(np.abs(profile.curvature(bent)))),
        float(worn_area),
    )


def flange_back(profile):
    """Place y [m] of the flange's vertical back, NaN for a profile that ends before its rounding is steep.

    On a circle of radius R that becomes vertical at the back, a point with the slope tan(a) is R (1 - sin a)
    before it.
    """
    end = profile.start + 1e-6
    sines = [slope / math.hypot(1.0, slope) for slope in map(float, profile.slope([end, end + ROUNDING]))]
    if not sines[0] >= STEEP / math.hypot(1.0, STEEP):
        return math.nan
    beyond = ROUNDING * (1.0 - sines[0]) / max(sines[0] - sines[1], 1e-9)
    return end - min(beyond, ROUNDING)


def _flange(y, z, back):
    """Sh, Sd and qR [m] of heights ``z`` (n,) from the running circle; NaN without a flange."""
    tip = int(np.argmax(np.where(y < 0.0, z, -np.inf)))
    if not z[tip] > FLANGE:
        return math.nan, math.nan, math.nan
    front = slice(tip, int(np.argmin(np.abs(y))) + 1)  # from the tip to the running circle z falls
    at = [float(np.interp(-level, -z[front], y[front])) for level in (ABOVE, z[tip] - BELOW_TIP)]
    return float(z[tip]), at[0] - back, at[0] - at[1]


def rolling_conicity(system):
    """Equivalent conicity at 3 mm [1] of a wheelset that rolls about its x axis with its profiles, under its
    usual load; NaN without an oscillation."""
    from ..conditioning.conicity import equivalent_conicity  # needs scipy

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        rigid = type(system)(
            (system.left_wheel, system.wheel),
            (system.left_rail, system.rail),
            **geometry_of(system),
            contact_mode="rigid",
            normal_model="hertz",
        )
        table = rigid.evaluate_many(SHIFTS, outputs="geometry")
    difference = table.right.rolling_radius - table.left.rolling_radius
    there = np.isfinite(difference)
    if np.count_nonzero(there) < 2:
        return math.nan
    return float(equivalent_conicity(SHIFTS[there], difference[there], AMPLITUDE)[0])


def geometry_of(system):
    """Track and wheelset of a system, for another one with other methods."""
    names = (
        "rail_inclination",
        "gauge",
        "gauge_depth",
        "running_circle_distance",
        "nominal_radius",
        "left_rail_inclination",
        "left_nominal_radius",
    )
    return {name: system.parameters[name] for name in names}
