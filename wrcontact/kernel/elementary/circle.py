"""Sine, cosine and arc tangent with an error of at most one unit in the last place.

    sin x = x + x^3 S(x^2),   cos x = 1 - x^2/2 + x^4 C(x^2),     |x| <= pi/4                        (E1)
    atan x = x + x^3 A(x^2),                                      |x| <= 7/16                        (E2)

Larger angles are taken back by whole quarter turns; pi/2 stands in three parts, so that products are exact.
Larger tangents are taken back by atan x = atan c + atan((x - c)/(1 + c x)).  What is lost in a difference or
a quotient goes along as its ``rest``.  tools/make_elementary.py makes the numbers.
"""

from math import copysign, fabs, inf, nan
from typing import Final

from ..layout import inlined, seldom
from .whole import nearest_whole

#: The square of pi/4; squares below TINY count as nothing beside 1.
QUARTER_SQUARE: Final[float] = 0.6168502750680849
TINY: Final[float] = 1e-20
#: Angles beyond this [rad] have no sine here: TURN_0 and TURN_1 leave room for 2^20 quarter turns.
LARGEST_ANGLE: Final[float] = 1e6
PER_QUARTER: Final[float] = 0.6366197723675814  # 2/pi
#: pi/2 in three parts.
TURN_0: Final[float] = 1.5707963267341256
TURN_1: Final[float] = 6.077100506303966e-11
TURN_2: Final[float] = 2.0222662487959506e-21
SINE_0: Final[float] = -0.16666666666666666
SINE_1: Final[float] = 0.00833333333333131
SINE_2: Final[float] = -0.00019841269837086805
SINE_3: Final[float] = 2.7557316223987385e-06
SINE_4: Final[float] = -2.5051151497621314e-08
SINE_5: Final[float] = 1.5919285713487644e-10
COSINE_0: Final[float] = 0.041666666666666664
COSINE_1: Final[float] = -0.0013888888888887061
COSINE_2: Final[float] = 2.480158729846062e-05
COSINE_3: Final[float] = -2.755731715858484e-07
COSINE_4: Final[float] = 2.0876127907563258e-09
COSINE_5: Final[float] = -1.1381548878317389e-11
#: The square of 7/16, and 7/16, 11/16, 19/16, 39/16: where the next c of the arc tangent begins.
ARC_SQUARE: Final[float] = 0.19140625
FIRST_ARC: Final[float] = 0.4375
SECOND_ARC: Final[float] = 0.6875
THIRD_ARC: Final[float] = 1.1875
LAST_ARC: Final[float] = 2.4375
ARC_0: Final[float] = -0.33333333333333326
ARC_1: Final[float] = 0.19999999999988882
ARC_2: Final[float] = -0.1428571428329719
ARC_3: Final[float] = 0.11111110909235003
ARC_4: Final[float] = -0.09090900466146987
ARC_5: Final[float] = 0.07692092325855508
ARC_6: Final[float] = -0.0666329590228781
ARC_7: Final[float] = 0.058481271263610225
ARC_8: Final[float] = -0.05035683380995465
ARC_9: Final[float] = 0.03786710540916739
ARC_10: Final[float] = -0.01759022960111542
#: atan c for c = 1/2, 1, 3/2, infinity, and pi, each with what a float lacks of it.
HALF_ARC: Final[float] = 0.4636476090008061
HALF_ARC_REST: Final[float] = 2.2698777452961687e-17
ONE_ARC: Final[float] = 0.7853981633974483
ONE_ARC_REST: Final[float] = 3.061616997868383e-17
MORE_ARC: Final[float] = 0.982793723247329
MORE_ARC_REST: Final[float] = 1.3903311031230998e-17
ALL_ARC: Final[float] = 1.5707963267948966
ALL_ARC_REST: Final[float] = 6.123233995736766e-17
STRAIGHT: Final[float] = 3.141592653589793
STRAIGHT_REST: Final[float] = 1.2246467991473532e-16
#: Splits a float into halves: 2^27 + 1; what is within these sizes has products that neither overflow nor
#: lose bits.
HALVES: Final[float] = 134217729.0
SMALL: Final[float] = 1e-140
LARGE: Final[float] = 1e140


@inlined
def sine_cosine(x: float):
    """Sine and cosine of ``x`` [rad]; not a number beyond LARGEST_ANGLE."""
    z = x * x
    sine = 0.0
    cosine = 0.0
    if z >= TINY and z <= QUARTER_SQUARE:
        odd, even = circle_series(z)
        half = 0.5 * z
        near = 1.0 - half
        sine = x + x * z * odd
        cosine = near + (((1.0 - near) - half) + z * z * even)
    else:
        sine, cosine = turned_sine_cosine(x)
    return sine, cosine


@inlined
def circle_series(z: float):
    """S(z) and C(z) of eq. (E1)."""
    w = z * z
    odd = SINE_0 + w * (SINE_2 + w * SINE_4) + z * (SINE_1 + w * (SINE_3 + w * SINE_5))
    even = COSINE_0 + w * (COSINE_2 + w * COSINE_4) + z * (COSINE_1 + w * (COSINE_3 + w * COSINE_5))
    return odd, even


@seldom
def turned_sine_cosine(x: float):
    """The same for an angle that is tiny, or larger than a quarter."""
    if fabs(x) < QUARTER_SQUARE:
        return x, 1.0 - 0.5 * x * x
    if not fabs(x) <= LARGEST_ANGLE:
        return nan, nan
    quarters = nearest_whole(x * PER_QUARTER)
    near = x - quarters * TURN_0
    small = quarters * TURN_1
    high = near - small
    least = quarters * TURN_2
    angle = high - least
    rest = ((near - high) - small) + ((high - angle) - least)
    sine, cosine = rest_sine_cosine(angle, rest)
    turn = int(quarters) % 4
    if turn == 1:
        return cosine, -sine
    if turn == 2:
        return -sine, -cosine
    if turn == 3:
        return -cosine, sine
    return sine, cosine


def rest_sine_cosine(x: float, rest: float):
    """Sine and cosine of ``x`` + ``rest``, which is below the last place of x; |x| <= pi/4."""
    z = x * x
    odd, even = circle_series(z)
    half = 0.5 * z
    near = 1.0 - half
    return (x + (x * z * odd + rest * near), near + (((1.0 - near) - half) + (z * z * even - x * rest)))


@inlined
def atan(x: float):
    """Angle [rad], -pi/2 ... pi/2, whose tangent is ``x``."""
    z = x * x
    angle = 0.0
    if z >= TINY and z <= ARC_SQUARE:
        angle = x + x * z * arc_series(z)
    else:
        angle = steep_atan(x)
    return angle


@inlined
def arc_series(z: float):
    """A(z) of eq. (E2)."""
    w = z * z
    even = ARC_0 + w * (ARC_2 + w * (ARC_4 + w * (ARC_6 + w * (ARC_8 + w * ARC_10))))
    odd = ARC_1 + w * (ARC_3 + w * (ARC_5 + w * (ARC_7 + w * ARC_9)))
    return even + z * odd


@seldom
def steep_atan(x: float):
    """The same for a tangent that is tiny, or larger than 7/16."""
    size = fabs(x)
    if not size >= FIRST_ARC:
        return x
    if size <= THIRD_ARC:
        base, part = arc_parts(size, 0.0)
    elif size <= LAST_ARC:
        base = MORE_ARC
        t = (size - 1.5) / (1.0 + 1.5 * size)
        part = t + (MORE_ARC_REST + t * (t * t) * arc_series(t * t))
    else:
        base = ALL_ARC
        t = -1.0 / size
        part = t + (ALL_ARC_REST + t * (t * t) * arc_series(t * t))
    angle = base + part
    if x < 0.0:
        angle = -angle
    return angle


def arc_parts(x: float, rest: float):
    """Two angles whose sum has the tangent ``x`` + ``rest``; 0 <= x <= THIRD_ARC."""
    base = 0.0
    base_rest = 0.0
    t = x
    if x > SECOND_ARC:
        base = ONE_ARC
        base_rest = ONE_ARC_REST
        t = (x - 1.0) / (x + 1.0)
    elif x > FIRST_ARC:
        base = HALF_ARC
        base_rest = HALF_ARC_REST
        t = (2.0 * x - 1.0) / (2.0 + x)
    lost = base_rest + rest / (1.0 + x * x)
    return base, t + (lost + t * (t * t) * arc_series(t * t))


def atan2(up: float, along: float):
    """Angle [rad], -pi ... pi, of the direction (along, up)."""
    rise = fabs(up)
    run = fabs(along)
    if not (rise <= inf and run <= inf):
        return nan
    low = min(rise, run)
    high = max(rise, run)
    tangent = 0.0
    rest = 0.0
    if low == inf:
        tangent = 1.0
    elif low > 0.0:
        tangent = low / high
        rest = quotient_rest(low, tangent, high)
    base, part = arc_parts(tangent, rest)
    angle = base + part
    if rise > run:
        # pi/2 -+ (base + part)
        away = -1.0
        if along < 0.0:
            away = 1.0
        turned = ALL_ARC + away * base
        lost = (ALL_ARC - turned) + away * base
        angle = turned + (away * part + (lost + ALL_ARC_REST))
    elif copysign(1.0, along) < 0.0:
        turned = STRAIGHT - base
        lost = (STRAIGHT - turned) - base
        angle = turned - (part - (lost + STRAIGHT_REST))
    return copysign(angle, up)


def quotient_rest(up: float, quotient: float, along: float):
    """What ``quotient`` lacks of ``up`` / ``along``."""
    if up < SMALL or along > LARGE:
        return 0.0
    q = quotient * HALVES
    q = q - (q - quotient)
    a = along * HALVES
    a = a - (a - along)
    q_rest = quotient - q
    a_rest = along - a
    return ((((up - q * a) - q * a_rest) - q_rest * a) - q_rest * a_rest) / along
