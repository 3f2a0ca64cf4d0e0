"""Exponential, logarithm and cube root with an error of at most one unit in the last place.

    e^x = 2^n (1 + r + r^2 G(r)),          n = round(x / ln 2),  r = x - n ln 2                      (E3)
    ln x = n ln 2 + f - f^2/2 + s (f^2/2 + s^2 L(s^2)),   x = 2^n (1 + f),  s = f / (2 + f)          (E4)

A cube root begins with a cubic and comes nearer by Halley's iteration, t (t^3 + 2 x) / (2 t^3 + x); the last
turn starts from a t of few bits, whose square is exact.  tools/make_elementary.py makes the numbers.
"""

from math import inf, nan
from typing import Final

from ..layout import inlined, seldom
from .binary import exponent, power_of_two
from .whole import nearest_whole

#: Beyond these e^x is subnormal or infinite, and 0.
LEAST_GROWTH: Final[float] = -708.0
MOST_GROWTH: Final[float] = 709.0
NO_GROWTH: Final[float] = -746.0
ALL_GROWTH: Final[float] = 710.0
#: ln 2 in two parts, and 1 / ln 2.
LN2: Final[float] = 0.6931471806019545
LN2_REST: Final[float] = -4.2009150726810846e-11
PER_LN2: Final[float] = 1.4426950408889634
GROWTH_0: Final[float] = 0.5000000000000001
GROWTH_1: Final[float] = 0.1666666666666667
GROWTH_2: Final[float] = 0.04166666666662294
GROWTH_3: Final[float] = 0.008333333333325874
GROWTH_4: Final[float] = 0.00138888889176305
GROWTH_5: Final[float] = 0.00019841269875523209
GROWTH_6: Final[float] = 2.4801520765487575e-05
GROWTH_7: Final[float] = 2.7557254657337665e-06
GROWTH_8: Final[float] = 2.7620309709504743e-07
GROWTH_9: Final[float] = 2.5105486917609143e-08
ROOT_OF_2: Final[float] = 1.4142135623730951
LOGARITHM_0: Final[float] = 0.666666666666667
LOGARITHM_1: Final[float] = 0.3999999999989972
LOGARITHM_2: Final[float] = 0.28571428625989764
LOGARITHM_3: Final[float] = 0.22222211126190308
LOGARITHM_4: Final[float] = 0.1818288994222302
LOGARITHM_5: Final[float] = 0.1533169169143632
LOGARITHM_6: Final[float] = 0.14616832997057724
#: What is within these sizes has a power of two for each of its own; FAR takes what is not there.
SMALL: Final[float] = 1e-300
LARGE: Final[float] = 1e300
FAR: Final[float] = 1.2379400392853803e27  # 2^90
LN_FAR: Final[int] = 90
ROOT_FAR: Final[float] = 1073741824.0  # 2^30
ROOT_0: Final[float] = 0.7041619948802007
ROOT_1: Final[float] = 0.34060036405019106
ROOT_2: Final[float] = -0.03689713030393742
ROOT_3: Final[float] = 0.001830224552473244
#: Splits a float into halves: 2^27 + 1.
HALVES: Final[float] = 134217729.0


def exp(x: float):
    """e^x."""
    if x >= LEAST_GROWTH and x <= MOST_GROWTH:
        n = nearest_whole(x * PER_LN2)
        return grown(x, n) * power_of_two(int(n))
    return far_exp(x)


@inlined
def grown(x: float, n: float):
    """e^x / 2^n, for the n next to x / ln 2."""
    high = x - n * LN2
    low = n * LN2_REST
    r = high - low
    rest = (high - r) - low
    z = r * r
    even = GROWTH_0 + z * (GROWTH_2 + z * (GROWTH_4 + z * (GROWTH_6 + z * GROWTH_8)))
    odd = GROWTH_1 + z * (GROWTH_3 + z * (GROWTH_5 + z * (GROWTH_7 + z * GROWTH_9)))
    return 1.0 + (r + (rest + z * (even + r * odd)))


@seldom
def far_exp(x: float):
    """The same where 2^n has no float of its own."""
    if x != x:
        return x
    if x < NO_GROWTH:
        return 0.0
    if x > ALL_GROWTH:
        return inf
    n = nearest_whole(x * PER_LN2)
    half = int(n) // 2
    return grown(x, n) * power_of_two(half) * power_of_two(int(n) - half)


def log(x: float):
    """Natural logarithm of ``x``; that of 0 is minus infinity."""
    if x >= SMALL and x <= LARGE:
        return shifted_log(x, 0)
    return far_log(x)


@inlined
def shifted_log(x: float, shift: int):
    """ln (2^shift x) of an x for which there are all powers of two."""
    k = exponent(x)
    m = x * power_of_two(-k)
    if m > ROOT_OF_2:
        m = 0.5 * m
        k += 1
    n = float(k + shift)
    f = m - 1.0
    s = f / (2.0 + f)
    z = s * s
    w = z * z
    series = z * (
        (LOGARITHM_0 + w * (LOGARITHM_2 + w * (LOGARITHM_4 + w * LOGARITHM_6)))
        + z * (LOGARITHM_1 + w * (LOGARITHM_3 + w * LOGARITHM_5))
    )
    half = 0.5 * f * f
    return n * LN2 - ((half - (s * (half + series) + n * LN2_REST)) - f)


@seldom
def far_log(x: float):
    """The same of what is not a usual number."""
    if x == 0.0:
        return -inf
    if not x > 0.0:
        return nan
    if x == inf:
        return x
    if x > LARGE:
        return shifted_log(x / FAR, LN_FAR)
    return shifted_log(x * FAR, -LN_FAR)


def cube_root(x: float):
    """Cube root of ``x``."""
    if x >= SMALL and x <= LARGE:
        return usual_cube_root(x)
    return far_cube_root(x)


@inlined
def usual_cube_root(x: float):
    """The same for a positive x for which there are all powers of two."""
    third = (exponent(x) + 3072) // 3 - 1024
    m = x * power_of_two(-3 * third)
    t = ROOT_0 + m * (ROOT_1 + m * (ROOT_2 + m * ROOT_3))
    cube = t * t * t
    t = t * ((cube + 2.0 * m) / (2.0 * cube + m))
    whole = t * HALVES
    t = whole - (whole - t)
    side = m / (t * t)
    t = t + t * ((side - t) / (2.0 * t + side))
    return t * power_of_two(third)


@seldom
def far_cube_root(x: float):
    """The same of what is not a usual number."""
    if x < 0.0:
        return -far_cube_root_size(-x)
    return far_cube_root_size(x)


def far_cube_root_size(x: float):
    """The same of what is not negative."""
    if not (x > 0.0 and x < inf):
        return x
    if x > LARGE:
        return usual_cube_root(x / FAR) * ROOT_FAR
    if x < SMALL:
        return usual_cube_root(x * FAR) / ROOT_FAR
    return usual_cube_root(x)
