"""The zones that a profile is defined with, as numbers: polynomials and circular arcs,
upright or turned; in millimetres.

A definition is one array: how many zones, the length of their rows, the wear of a rail's inner face, then the rows.
wrcontact/profiles/zones.py has the same zones as objects, and
wrcontact/profiles/definition.py turns one into the other.

The rail on the track, and the part of a wheel that can be read, are definitions that are turned, shifted and
cut from these.
"""

from math import fabs, sqrt
from typing import Final

from ..elementary.circle import atan, sine_cosine

DEFINITION_COUNT: Final[int] = 0
DEFINITION_ROW: Final[int] = 1
DEFINITION_WORN: Final[int] = 2  # how far the inner face of a rail has worn since it was laid
DEFINITION_ZONES: Final[int] = 3

# a row
ZONE_FAMILY: Final[int] = 0  # one of FAMILY_...
ZONE_START: Final[int] = 1  # abscissae of its ends
ZONE_STOP: Final[int] = 2
ZONE_ORIGIN: Final[int] = 3  # of a polynomial; lateral centre of an arc
ZONE_Z_CENTRE: Final[int] = 4  # of an arc
ZONE_RADIUS: Final[int] = 5
ZONE_SIDE: Final[int] = 6  # +1 lower half, -1 upper half
ZONE_TERMS: Final[int] = 7  # how many coefficients a polynomial has
ZONE_TURNED: Final[int] = 8  # 1 for a polynomial that is turned and shifted:
ZONE_COS: Final[int] = 9
ZONE_SIN: Final[int] = 10
ZONE_Y_SHIFT: Final[int] = 11
ZONE_Z_SHIFT: Final[int] = 12
ZONE_FIRST: Final[int] = 13  # its ends before that
ZONE_LAST: Final[int] = 14
ZONE_COEFFICIENTS: Final[int] = 15

FAMILY_POLYNOMIAL: Final[int] = 0
FAMILY_ARC: Final[int] = 1

TURNED_ITERATIONS: Final[int] = 60
TURNED_SHARP: Final[float] = 1e-15  # last Newton step to a place on a turned zone, relative
VERTICAL: Final[float] = 1e-90  # where an arc is as steep as that it ends [mm]
#: A profile is read as a function of y where it is not steeper than this [rad], 80 degrees. Flanges of wheels
#: in use are less steep, 75 degrees at most, so no contact lies beyond.
STEEPEST: Final[float] = 1.3962634015954636
#: Less of an arc than this is nothing [mm].
SLIVER: Final[float] = 1e-6
#: Zones this close meet [mm]: where the height steps by up to 2e-4 mm, the ends of turned zones are apart by
#: that times the angle. Ends that differ by more than rounding become one.
MEETING: Final[float] = 1e-4
SAME_END: Final[float] = 1e-9
NO_FACE: Final[float] = -1e300  # in place of a depth: the inner face does not reach it


def polynomial_jet(zones: "float[:]", row: int, t: float):
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


def arc_jet(zones: "float[:]", row: int, y: float):
    """The same of an arc at ``y`` [mm]."""
    u = y - zones[row + ZONE_ORIGIN]
    radius = zones[row + ZONE_RADIUS]
    side = zones[row + ZONE_SIDE]
    root = sqrt(max(radius * radius - u * u, 0.0))
    z = zones[row + ZONE_Z_CENTRE] + side * root
    root = max(root, VERTICAL)
    return z, -side * u / root, -side * (radius * radius) / (root * root * root)


def upright_jet(zones: "float[:]", row: int, t: float):
    """The same of a zone before it is turned."""
    z, slope, bend = 0.0, 0.0, 0.0
    if int(zones[row + ZONE_FAMILY]) == FAMILY_ARC:
        z, slope, bend = arc_jet(zones, row, t)
    else:
        z, slope, bend = polynomial_jet(zones, row, t)
    return z, slope, bend


def turned_point(zones: "float[:]", row: int, t: float, cosine: float, sine: float):
    """Point (y, z) [mm] at ``t`` of a zone that is turned about the origin."""
    z, slope, bend = upright_jet(zones, row, t)
    return cosine * t - sine * z, sine * t + cosine * z


def clamped(x: float, low: float, high: float):
    """``x``, or the end that it lies beyond."""
    return min(max(x, low), high)


def turned_jet(zones: "float[:]", row: int, y: float):
    """Height, slope and second derivative of a turned polynomial at its own abscissa ``y``
    [mm], by Newton's method."""
    c = zones[row + ZONE_COS]
    s = zones[row + ZONE_SIN]
    first = zones[row + ZONE_FIRST]
    last = zones[row + ZONE_LAST]
    along = y - zones[row + ZONE_Y_SHIFT]
    t = clamped(c * along, first, last)
    i = 0
    while i < TURNED_ITERATIONS:
        z, slope, bend = polynomial_jet(zones, row, t)
        newton = (c * t - s * z - along) / (c - s * slope)
        t = clamped(t - newton, first, last)
        i += 1
        if fabs(newton) <= TURNED_SHARP * (1.0 + fabs(along)):
            i = TURNED_ITERATIONS
    z, slope, bend = polynomial_jet(zones, row, t)
    stretch = c - s * slope
    return (
        s * t + c * z + zones[row + ZONE_Z_SHIFT],
        (s + c * slope) / stretch,
        bend / (stretch * stretch * stretch),
    )


def zone_jet(zones: "float[:]", row: int, y: float):
    """Height [mm], slope and second derivative [1/mm] of any zone at ``y`` [mm]."""
    z, slope, bend = 0.0, 0.0, 0.0
    if zones[row + ZONE_TURNED] == 1.0:
        z, slope, bend = turned_jet(zones, row, y)
    else:
        z, slope, bend = upright_jet(zones, row, y)
    return z, slope, bend


def turned_slope(zones: "float[:]", row: int, t: float, cosine: float, sine: float):
    """What has the sign of the slope of a turned zone at ``t`` [mm]."""
    z, slope, bend = upright_jet(zones, row, t)
    return sine + cosine * slope


def level_place(zones: "float[:]", row: int, cosine: float, sine: float):
    """Where in a zone the turned slope rises through zero [mm], to the last bit; its
    start if that is nowhere."""
    low = zones[row + ZONE_START]
    high = zones[row + ZONE_STOP]
    if not (
        turned_slope(zones, row, low, cosine, sine) < 0.0
        and 0.0 <= turned_slope(zones, row, high, cosine, sine)
    ):
        return low
    middle = 0.5 * (low + high)
    while low < middle and middle < high:
        if turned_slope(zones, row, middle, cosine, sine) < 0.0:
            low = middle
        else:
            high = middle
        middle = 0.5 * (low + high)
    return middle


def highest_point(zones: "float[:]", base: int, angle: float):
    """Point (y, z) [mm] of the turned head where it is level and highest."""
    y_top = 0.0
    z_top = 0.0
    sine, cosine = sine_cosine(angle)
    for i in range(int(zones[base + DEFINITION_COUNT])):
        row = base + DEFINITION_ZONES + i * int(zones[base + DEFINITION_ROW])
        y, z = turned_point(zones, row, level_place(zones, row, cosine, sine), cosine, sine)
        if i == 0 or z < z_top:
            y_top = y
            z_top = z
    return y_top, z_top


def place_at_depth(zones: "float[:]", row: int, cosine: float, sine: float, depth: float):
    """Lateral coordinate [mm] at which the turned zone's inner part is ``depth`` [mm]
    deep, to the last bit."""
    low = zones[row + ZONE_START]
    high = min(zones[row + ZONE_STOP], 0.0)
    middle = 0.5 * (low + high)
    while low < middle and middle < high:
        y, z = turned_point(zones, row, middle, cosine, sine)
        if depth - z < 0.0:
            low = middle
        else:
            high = middle
        middle = 0.5 * (low + high)
    y, z = turned_point(zones, row, middle, cosine, sine)
    return y


def inner_face(zones: "float[:]", base: int, angle: float, depth: float):
    """Lateral coordinate [mm] of the turned head's inner side at the height ``depth`` [mm], and the height
    reached, which is less where the side ends before."""
    deepest = NO_FACE
    sine, cosine = sine_cosine(angle)
    i = int(zones[base + DEFINITION_COUNT]) - 1
    while i >= 0:
        row = base + DEFINITION_ZONES + i * int(zones[base + DEFINITION_ROW])
        if zones[row + ZONE_START] < 0.0:
            y, z = turned_point(zones, row, zones[row + ZONE_START], cosine, sine)
            if z >= depth:
                return place_at_depth(zones, row, cosine, sine, depth), depth
            deepest = max(deepest, z)
        i -= 1
    return 0.0, deepest


def turn_arc(zones: "float[:]", row: int, angle: float, y_shift: float, z_shift: float):
    """Turn and shift an arc in place, without what is steeper than STEEPEST; 0 if nothing is left, else 1."""
    tilt = -zones[row + ZONE_SIDE] * angle
    y_centre = zones[row + ZONE_ORIGIN]
    z_centre = zones[row + ZONE_Z_CENTRE]
    radius = zones[row + ZONE_RADIUS]
    first, unused = sine_cosine(STEEPEST + tilt)
    last, unused = sine_cosine(STEEPEST - tilt)
    start = max(zones[row + ZONE_START], y_centre - radius * first)
    stop = min(zones[row + ZONE_STOP], y_centre + radius * last)
    if stop - start <= SLIVER:
        return 0
    s, c = sine_cosine(angle)
    y_start, z_start = turned_point(zones, row, start, c, s)
    y_stop, z_stop = turned_point(zones, row, stop, c, s)
    zones[row + ZONE_START] = y_start + y_shift
    zones[row + ZONE_STOP] = y_stop + y_shift
    zones[row + ZONE_ORIGIN] = c * y_centre - s * z_centre + y_shift
    zones[row + ZONE_Z_CENTRE] = s * y_centre + c * z_centre + z_shift
    return 1


def turn_polynomial(zones: "float[:]", row: int, angle: float, y_shift: float, z_shift: float):
    """Turn and shift a polynomial in place; 0 if it is steeper than STEEPEST at an end, else 1."""
    if angle == 0.0 and y_shift == 0.0 and z_shift == 0.0:
        return 1
    first = zones[row + ZONE_START]
    last = zones[row + ZONE_STOP]
    z, at_first, bend = upright_jet(zones, row, first)
    z, at_last, bend = upright_jet(zones, row, last)
    if fabs(atan(at_first) + angle) > STEEPEST or fabs(atan(at_last) + angle) > STEEPEST:
        return 0
    s, c = sine_cosine(angle)
    y_first, z = turned_point(zones, row, first, c, s)
    y_last, z = turned_point(zones, row, last, c, s)
    zones[row + ZONE_TURNED] = 1.0
    zones[row + ZONE_COS] = c
    zones[row + ZONE_SIN] = s
    zones[row + ZONE_Y_SHIFT] = y_shift
    zones[row + ZONE_Z_SHIFT] = z_shift
    zones[row + ZONE_FIRST] = first
    zones[row + ZONE_LAST] = last
    zones[row + ZONE_START] = y_first + y_shift
    zones[row + ZONE_STOP] = y_last + y_shift
    return 1


def turn_zones(zones: "float[:]", base: int, angle: float, y_shift: float, z_shift: float):
    """Turn [rad] and shift [mm] a whole definition in place, without its steep parts;
    how many zones are left."""
    size = int(zones[base + DEFINITION_ROW])
    kept = 0
    for i in range(int(zones[base + DEFINITION_COUNT])):
        row = base + DEFINITION_ZONES + kept * size
        for k in range(size):
            zones[row + k] = zones[base + DEFINITION_ZONES + i * size + k]
        left = 0
        if int(zones[row + ZONE_FAMILY]) == FAMILY_ARC:
            left = turn_arc(zones, row, angle, y_shift, z_shift)
        else:
            left = turn_polynomial(zones, row, angle, y_shift, z_shift)
        kept += left
    zones[base + DEFINITION_COUNT] = float(kept)
    return kept


def keep_around_top(zones: "float[:]", base: int):
    """Keep the unbroken run of zones that holds y = 0; how many that are."""
    size = int(zones[base + DEFINITION_ROW])
    count = int(zones[base + DEFINITION_COUNT])
    first = 0
    found = False
    while not found and first < count:
        row = base + DEFINITION_ZONES + first * size
        if zones[row + ZONE_START] <= 0.0 and 0.0 <= zones[row + ZONE_STOP]:
            found = True
        else:
            first += 1
    last = first
    while found and first > 0 and meets_next(zones, base + DEFINITION_ZONES + (first - 1) * size, size):
        first -= 1
    while found and last + 1 < count and meets_next(zones, base + DEFINITION_ZONES + last * size, size):
        last += 1
    kept = 0
    if found:
        kept = last + 1 - first
    for k in range(kept * size):
        zones[base + DEFINITION_ZONES + k] = zones[base + DEFINITION_ZONES + first * size + k]
    zones[base + DEFINITION_COUNT] = float(kept)
    close_joints(zones, base)
    return kept


def close_joints(zones: "float[:]", base: int):
    """Let every zone end where the next one starts."""
    size = int(zones[base + DEFINITION_ROW])
    for i in range(int(zones[base + DEFINITION_COUNT]) - 1):
        row = base + DEFINITION_ZONES + i * size
        if fabs(zones[row + ZONE_STOP] - zones[row + size + ZONE_START]) > SAME_END:
            zones[row + ZONE_STOP] = zones[row + size + ZONE_START]


def meets_next(zones: "float[:]", row: int, size: int) -> bool:
    """Whether the zone ends where the one after it starts."""
    return fabs(zones[row + ZONE_STOP] - zones[row + size + ZONE_START]) < MEETING
