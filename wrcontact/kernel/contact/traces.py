"""Wheel and rail as heights over the contact plane, traced from station to station.

Station s runs along the contact plane to the field side, from the contact point; heights n are measured along
the plane's normal, from rail to wheel.  The outline of the wheel (:mod:`locus`) and the rail profile are both
read as n(s): the profile abscissa that projects on s is found by Newton's method from the previous station,
and the last residual is removed by the curve's own slope and bend, which leaves an error of third order in a
small residual.
"""

from math import fabs
from typing import Final

from ..layout import RAIL, WHEEL, Direction, Frame, Meeting, Pair, Point, Profile, Trace
from ..surface.locus import outline_jet
from ..surface.tables import height_slope_bend

#: A trace is extrapolated to second order over this distance at most [m].
EXTRAPOLATED: Final[float] = 4e-3
TRACE_ITERATIONS: Final[int] = 30


def start_traces(frame: Frame, station: float, abscissa: float, y: float):
    """Let the traces begin at ``station`` with rail abscissa ``abscissa`` and wheel abscissa ``y`` [m]."""
    frame.station = station
    frame.traces[RAIL].abscissa = abscissa
    frame.traces[RAIL].rate = frame.plane.cos
    frame.traces[RAIL].bend = 0.0
    frame.traces[WHEEL].abscissa = y
    frame.traces[WHEEL].rate = frame.plane.cos
    frame.traces[WHEEL].bend = 0.0


def first_abscissa(trace: Trace, away: float):
    """Estimated profile abscissa [m] at a distance ``away`` from the station of the trace [m]."""
    u = trace.abscissa + away * trace.rate
    if fabs(away) < EXTRAPOLATED:
        u += 0.5 * away * away * trace.bend
    return u


def trace_profile(
    frame: Frame,
    profile: Profile,
    point: Point,
    plane: Direction,
    trace: Trace,
    station: float,
    tolerance: float,
):
    """Height of a profile over the contact plane [m], its rate [-] and bend [1/m] at ``station``, its slope
    there [-], its height [m], its second derivative [1/m], and whether it exists.

    point : the profile's point at station zero.
    plane : inclination of the contact plane in the profile's coordinates.
    """
    u = first_abscissa(trace, station - frame.station)
    exists = False
    excess = 0.0
    forward = 1.0
    height = 0.0
    slope = 0.0
    bend = 0.0
    for i in range(TRACE_ITERATIONS):
        u = min(max(u, profile.start), profile.stop)
        height, slope, bend = height_slope_bend(profile, u)
        forward = plane.cos + slope * plane.sin
        excess = (u - point.y) * plane.cos + (height - point.z) * plane.sin - station
        if fabs(excess) < tolerance:
            if forward > 0.0:
                exists = True
            break
        u -= excess / forward
    along = 1.0 / forward
    rate = (plane.sin - slope * plane.cos) * along
    ordinate_bend = -bend * along * along * along
    trace.abscissa = u - excess * along
    trace.rate = along
    trace.bend = ordinate_bend * plane.sin
    ordinate = (u - point.y) * plane.sin - (height - point.z) * plane.cos
    move = -excess * along
    return (
        ordinate - excess * (rate - 0.5 * excess * ordinate_bend),
        rate - excess * ordinate_bend,
        ordinate_bend,
        slope + move * bend,
        height + move * slope,
        bend,
        exists,
    )


def trace_rail(pair: Pair, frame: Frame, station: float, tolerance: float):
    """Height of the rail over the contact plane [m], its rate [-] and bend [1/m] at ``station``; and whether
    it exists."""
    ordinate, rate, bend, slope, height, second, exists = trace_profile(
        frame, pair.rail, frame.rail, frame.plane, frame.traces[RAIL], station, tolerance
    )
    return ordinate, rate, bend, exists


def trace_wheel(pair: Pair, frame: Frame, station: float, tolerance: float):
    """Height of the wheel over the contact plane [m], its rate [-] and bend [1/m] at ``station``; and whether
    it exists.  The profile's point is the place's ``meeting``.

    Without yaw the outline is the profile, turned by the roll.
    """
    place = frame.place
    if not place.yawed:
        lifted = station - frame.lift * frame.plane.sin
        ordinate, rate, bend, slope, z, second, exists = trace_profile(
            frame, pair.wheel, frame.wheel, frame.wheel_plane, frame.traces[WHEEL], lifted, tolerance
        )
        ordinate -= frame.lift * frame.plane.cos
        note_point(place.meeting, frame.traces[WHEEL].abscissa, z, slope, second)
    else:
        ordinate, rate, bend, exists = trace_outline(pair, frame, station, tolerance)
    return ordinate, rate, bend, exists


def note_point(meeting: Meeting, y: float, z: float, slope: float, bend: float):
    """Note a point of the wheel's profile [m], with its slope [-] and second derivative [1/m]."""
    meeting.wheel = y
    meeting.z = z
    meeting.slope = slope
    meeting.bend = bend


def trace_outline(pair: Pair, frame: Frame, station: float, tolerance: float):
    """``trace_wheel`` with yaw."""
    wheel = pair.wheel
    place = frame.place
    trace = frame.traces[WHEEL]
    cosine = frame.plane.cos
    sine = frame.plane.sin
    left = pair.rail_y + frame.rail.y - frame.aside
    above = frame.shift - frame.rail.z
    y = first_abscissa(trace, station - frame.station)
    exists = False
    excess = 0.0
    along = 1.0
    across = 0.0
    up = 0.0
    stretch = 1.0
    z = 0.0
    slope = 0.0
    bend = 0.0
    outline_slope = 0.0
    outline_rate = 0.0
    for i in range(TRACE_ITERATIONS):
        y = min(max(y, wheel.start), wheel.stop)
        z, slope, bend = height_slope_bend(wheel, y)
        y_track, z_track, outline_slope, stretch, outline_rate = outline_jet(place, y, z, slope, bend)
        across = y_track - left
        up = z_track + above
        along = cosine + outline_slope * sine
        excess = across * cosine + up * sine - station
        if fabs(excess) < tolerance:
            if stretch * along > 0.0:
                exists = True
            break
        y -= excess / (stretch * along)
    per_along = 1.0 / along
    per_stretch = 1.0 / stretch
    rate = (sine - outline_slope * cosine) * per_along
    ordinate_bend = -outline_rate * per_stretch * per_along * per_along * per_along
    move = -excess * per_along * per_stretch
    trace.abscissa = y + move
    trace.rate = per_along * per_stretch
    trace.bend = ordinate_bend * sine * per_stretch
    note_point(place.meeting, y + move, z + move * slope, slope + move * bend, bend)
    ordinate = across * sine - up * cosine - excess * (rate - 0.5 * excess * ordinate_bend)
    return ordinate, rate - excess * ordinate_bend, ordinate_bend, exists
