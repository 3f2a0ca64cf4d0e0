"""Moves along the two curves of :mod:`curves`: by arc length, by chords, or to a lateral coordinate.

A move leaves the new abscissa in the frame's trace, and returns whether the curve reaches that far.
"""

from math import fabs, sqrt
from typing import Final

from ..layout import WHEEL, Frame, Origin, Tables, seldom
from .arc_length import arc_length
from .curves import curve_jet, curve_speed, within

#: Lengths and lateral coordinates are satisfied to this [m]; coordinates of a metre are rounded to 1e-16.
MOVE_SHARP: Final[float] = 1e-13
MOVE_ITERATIONS: Final[int] = 40


@seldom
def move_arc(tables: Tables, frame: Frame, origin: Origin, curve: int, length: float) -> bool:
    """Move a curve's abscissa by ``length`` [m] of arc, by Newton's method; whether the curve is
    that long."""
    u = frame.traces[curve].abscissa
    remainder = length
    for i in range(MOVE_ITERATIONS):
        if fabs(remainder) < MOVE_SHARP:
            frame.traces[curve].abscissa = u
            return True
        speed = curve_speed(tables, frame, origin, curve, u)
        if not speed > 0.0:
            return False
        following = within(tables, curve, u + remainder / speed)
        if following == u:
            return False
        remainder -= arc_length(tables, frame, origin, curve, u, following)
        u = following
    return False


@seldom
def move_chord(tables: Tables, frame: Frame, origin: Origin, curve: int, chord: float) -> bool:
    """Move a curve's abscissa to where a circle of radius abs(``chord``) [m] around the point cuts the curve,
    forward where ``chord`` is positive; whether it does."""
    start = frame.traces[curve].abscissa
    from_across, from_down, slope, stretch, bend = curve_jet(tables, frame, origin, curve, start)
    if not stretch > 0.0:
        return False
    u = within(tables, curve, start + chord / (stretch * sqrt(1.0 + slope * slope)))
    for i in range(MOVE_ITERATIONS):
        across, down, slope, stretch, bend = curve_jet(tables, frame, origin, curve, u)
        across -= from_across
        down -= from_down
        length = sqrt(across * across + down * down)
        if fabs(length - fabs(chord)) < MOVE_SHARP:
            frame.traces[curve].abscissa = u
            return True
        along = (across + slope * down) * stretch
        if not along * chord > 0.0:
            return False
        following = within(tables, curve, u - (length - fabs(chord)) * length / along)
        if following == u:
            return False
        u = following
    return False


@seldom
def move_to_station(tables: Tables, frame: Frame, origin: Origin, curve: int, station: float) -> bool:
    """Move a curve's abscissa from the station of the traces to ``station`` [m], by arc or by chords; whether
    there is one."""
    way = station - frame.station
    spacing = origin.spacing
    exists = True
    if spacing == 0.0:
        exists = move_arc(tables, frame, origin, curve, way)
    else:
        chord = spacing
        if way < 0.0:
            chord = -spacing
        for i in range(int(fabs(way) / spacing + 0.5)):
            if exists:
                exists = move_chord(tables, frame, origin, curve, chord)
    return exists


@seldom
def move_across(tables: Tables, frame: Frame, origin: Origin, lateral: float) -> bool:
    """Move the wheel's abscissa to where its outline is ``lateral`` [m] from the origin, by Newton's method;
    whether there is such a place."""
    u = within(tables, WHEEL, frame.traces[WHEEL].abscissa)
    for i in range(MOVE_ITERATIONS):
        across, down, slope, stretch, bend = curve_jet(tables, frame, origin, WHEEL, u)
        if not stretch > 0.0:
            return False
        if fabs(across - lateral) < MOVE_SHARP:
            frame.traces[WHEEL].abscissa = u
            return True
        following = within(tables, WHEEL, u - (across - lateral) / stretch)
        if following == u:
            return False
        u = following
    return False
