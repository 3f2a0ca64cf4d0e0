"""The zones that a profile is defined with, as numbers: polynomials and circular arcs,
upright or turned; in millimetres.

A definition is one array: how many zones, the length of their rows, then the rows.
wrcontact/profiles/zones.py has the same zones as objects, and
wrcontact/profiles/definition.py turns one into the other.
"""

from math import fabs, sqrt
from typing import Final

DEFINITION_COUNT: Final[int] = 0
DEFINITION_ROW: Final[int] = 1
DEFINITION_ZONES: Final[int] = 2

# a row
ZONE_FAMILY: Final[int] = 0          # one of FAMILY_...
ZONE_START: Final[int] = 1           # abscissae of its ends
ZONE_STOP: Final[int] = 2
ZONE_ORIGIN: Final[int] = 3          # of a polynomial; lateral centre of an arc
ZONE_Z_CENTRE: Final[int] = 4        # of an arc
ZONE_RADIUS: Final[int] = 5
ZONE_SIDE: Final[int] = 6            # +1 lower half, -1 upper half
ZONE_TERMS: Final[int] = 7           # how many coefficients a polynomial has
ZONE_TURNED: Final[int] = 8          # 1 for a polynomial that is turned and shifted:
ZONE_COS: Final[int] = 9
ZONE_SIN: Final[int] = 10
ZONE_Y_SHIFT: Final[int] = 11
ZONE_Z_SHIFT: Final[int] = 12
ZONE_FIRST: Final[int] = 13          # its ends before that
ZONE_LAST: Final[int] = 14
ZONE_COEFFICIENTS: Final[int] = 15

FAMILY_POLYNOMIAL: Final[int] = 0
FAMILY_ARC: Final[int] = 1

TURNED_ITERATIONS: Final[int] = 60
TURNED_SHARP: Final[float] = 1e-15   # last Newton step to a place on a turned zone, relative
VERTICAL: Final[float] = 1e-90       # where an arc is as steep as that it ends [mm]


def polynomial_jet(zones: 'float[:]', row: int, t: float):
    """Height [mm], slope and second derivative [1/mm] of an upright polynomial at ``t`` [mm],
    each by Horner's scheme."""
    u = t - zones[row + ZONE_ORIGIN]
    z = 0.0
    slope = 0.0
    bend = 0.0
    terms = int(zones[row + ZONE_TERMS])
    for i in range(terms):
        k = terms - 1 - i
        c = zones[row + ZONE_COEFFICIENTS + k]
        z = z * u + c
        if k > 0:
            slope = slope * u + c * float(k)
        if k > 1:
            bend = bend * u + c * float(k) * float(k - 1)
    return z, slope, bend


def arc_jet(zones: 'float[:]', row: int, y: float):
    """The same of an arc at ``y`` [mm]."""
    u = y - zones[row + ZONE_ORIGIN]
    radius = zones[row + ZONE_RADIUS]
    side = zones[row + ZONE_SIDE]
    root = sqrt(max(radius * radius - u * u, 0.0))
    z = zones[row + ZONE_Z_CENTRE] + side * root
    if root < VERTICAL:
        root = VERTICAL
    return z, -side * u / root, -side * (radius * radius) / (root * root * root)


def upright_jet(zones: 'float[:]', row: int, t: float):
    """The same of a zone before it is turned."""
    z, slope, bend = 0.0, 0.0, 0.0
    if int(zones[row + ZONE_FAMILY]) == FAMILY_ARC:
        z, slope, bend = arc_jet(zones, row, t)
    else:
        z, slope, bend = polynomial_jet(zones, row, t)
    return z, slope, bend


def turned_point(zones: 'float[:]', row: int, t: float, cosine: float, sine: float):
    """Point (y, z) [mm] at ``t`` of a zone that is turned about the origin."""
    z, slope, bend = upright_jet(zones, row, t)
    return cosine * t - sine * z, sine * t + cosine * z


def within(x: float, low: float, high: float):
    """``x``, or the end that it lies beyond."""
    return min(max(x, low), high)


def turned_jet(zones: 'float[:]', row: int, y: float):
    """Height, slope and second derivative of a turned polynomial at its own abscissa ``y``
    [mm], by Newton's method."""
    c = zones[row + ZONE_COS]
    s = zones[row + ZONE_SIN]
    first = zones[row + ZONE_FIRST]
    last = zones[row + ZONE_LAST]
    along = y - zones[row + ZONE_Y_SHIFT]
    t = within(c * along, first, last)
    i = 0
    while i < TURNED_ITERATIONS:
        z, slope, bend = polynomial_jet(zones, row, t)
        newton = (c * t - s * z - along) / (c - s * slope)
        t = within(t - newton, first, last)
        i += 1
        if fabs(newton) <= TURNED_SHARP * (1.0 + fabs(along)):
            i = TURNED_ITERATIONS
    z, slope, bend = polynomial_jet(zones, row, t)
    stretch = c - s * slope
    return (s * t + c * z + zones[row + ZONE_Z_SHIFT], (s + c * slope) / stretch,
            bend / (stretch * stretch * stretch))


def zone_jet(zones: 'float[:]', row: int, y: float):
    """Height [mm], slope and second derivative [1/mm] of any zone at ``y`` [mm]."""
    z, slope, bend = 0.0, 0.0, 0.0
    if zones[row + ZONE_TURNED] == 1.0:
        z, slope, bend = turned_jet(zones, row, y)
    else:
        z, slope, bend = upright_jet(zones, row, y)
    return z, slope, bend
