"""Half-lengths and middles of the strips from what they displace near their ends; eqs. (S6)-(S8)."""

from math import pi, sqrt
from typing import Final

from ..layout import InfluenceTable, Strip, StripProblem, Strips, Tables
from .strip_pressures import end_displacement

#: Displacement and gap are compared in the middle of a strip and at this share of its half-length.
TESTED: Final[float] = 0.9
#: Power of their ratio by which a half-length is corrected: first, and then.
FIRST_POWER: Final[float] = 0.6
POWER: Final[float] = 0.53
#: Share of the move of the middle that is taken, and the longest one, as a share of the half-length.
MOVED: Final[float] = 0.6
FARTHEST_MOVE: Final[float] = 0.3
#: Smallest rise of the gap towards the ends, as a share of that of a parabola.
FLATTEST: Final[float] = 0.1
#: A strip with less than this share of the largest pressure follows its neighbours more the less it has.
LIGHT: Final[float] = 0.02
#: Smallest half-length as a share of the longest one, and of the width of the strip: below that the strip's
#: own pressure grows without limit.
SHORTEST: Final[float] = 0.1
SQUARE: Final[float] = 0.5


def gap_beside(strip: Strip, x: float):
    """Rise of the gap [m] at a distance ``x`` from the ridge."""
    return x * x * (strip.A + strip.skew * x)


def corrected(ratio: float, power: float):
    """``ratio`` to a ``power`` near it, without ends: Pade's quotient, (1 + power) / (1 - power) at most."""
    more = 1.0 + power
    less = 1.0 - power
    return (less + more * ratio) / (more + less * ratio)


def correct_strip(table: InfluenceTable, problem: StripProblem, i: int, penetration: float, power: float,
                  yawed: bool):
    """Half-length [m] of the loaded strip ``i`` by how much less the surfaces are displaced towards its ends
    than the gap rises; its middle moves to where both ends are alike."""
    strip = problem.strips[i]
    half = strip.half_length
    away = TESTED * half
    own = gap_beside(strip, strip.lead)
    needed = strip.share * penetration - strip.gap
    front = end_displacement(table, problem, i, away)
    back = front
    front_gap = gap_beside(strip, strip.lead + away) - own
    back_gap = front_gap
    if yawed:
        back = end_displacement(table, problem, i, -away)
        back_gap = gap_beside(strip, strip.lead - away) - own
        move = -MOVED * (front + front_gap - back - back_gap) / (4.0 * strip.A * away)
        move = max(min(move, FARTHEST_MOVE * half), -FARTHEST_MOVE * half)
        strip.next_lead = strip.lead + move
    rise = max(0.5 * (front_gap + back_gap), FLATTEST * strip.A * away * away)
    ratio = max(0.0, (needed - 0.5 * (front + back)) / rise)
    return half * corrected(ratio, power)


def correct_lengths(tables: Tables, problem: StripProblem, penetration: float, power: float, yawed: bool):
    """Line load, square of the corrected half-length, pressure and lead of every strip.

    The line load stays, and the pressure follows from the corrected half-length.
    """
    strips = problem.strips
    count = problem.count
    scale = 0.5 * pi * pi * tables.contact_modulus
    largest = 0.0
    for i in range(count):
        strip = strips[i]
        strip.line_load = 0.0
        strip.half_length_square = 0.0
        strip.pressure = 0.0
        strip.next_lead = strip.lead
        if strip.y > 0.0:
            half = correct_strip(tables.influence, problem, i, penetration, power, yawed)
            strip.line_load = scale * strip.half_length * strip.y / strip.width
            strip.half_length_square = half * half
            strip.pressure = strip.y / strip.breadth
            largest = max(largest, strip.pressure)
    for i in range(count):
        strip = strips[i]
        share = strip.pressure / (LIGHT * largest)
        if share < 1.0:
            beside = neighbouring_length(strips, count, i)
            half = share * sqrt(strip.half_length_square) + (1.0 - share) * beside
            strip.half_length_square = half * half
    for i in range(count):
        strip = strips[i]
        if strip.y > 0.0:
            strip.pressure = 2.0 / pi * strip.line_load * strip.width / (strip.breadth
                                                                         * sqrt(strip.half_length_square))


def neighbouring_length(strips: Strips, count: int, i: int):
    """Half-length [m] of the strips beside ``i``, weighted by their pressures; its own where they have
    none."""
    total = 0.0
    weight = 0.0
    if i > 0:
        before = strips[i - 1]
        weight += before.pressure
        total += before.pressure * sqrt(before.half_length_square)
    if i < count - 1:
        after = strips[i + 1]
        weight += after.pressure
        total += after.pressure * sqrt(after.half_length_square)
    half = strips[i].half_length
    if weight > 0.0:
        half = total / weight
    return half


def adopt_lengths(problem: StripProblem):
    """Give the strips their corrected half-lengths and leads, for the next sweep."""
    strips = problem.strips
    for i in range(problem.count):
        strip = strips[i]
        strip.half_length = sqrt(strip.half_length_square)
        strip.lead = strip.next_lead
    limit_lengths(strips, problem.count)


def limit_lengths(strips: Strips, count: int):
    """Raise half-lengths to their smallest."""
    longest = 0.0
    for i in range(count):
        longest = max(longest, strips[i].half_length)
    for i in range(count):
        strip = strips[i]
        strip.half_length = max(max(strip.half_length, SHORTEST * longest), SQUARE * strip.width)
