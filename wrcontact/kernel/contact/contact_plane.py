"""The geometry that a normal contact model needs, in the plane of the rigid contact point.

Station s runs along the contact plane to the field side, from the contact point; heights n are measured along the
plane's normal, from rail to wheel.  The outline of the wheel (:mod:`locus`) and the rail profile are both read as
n(s): the profile abscissa that projects on s is found by Newton's method from the previous station, and the last
residual is removed by the curve's own slope and bend, which leaves an error of third order in a small residual.
"""

from math import fabs, sqrt
from typing import Final

from ..layout import LONGITUDINAL_BASIC, offset, WORK_CONTACT, Place, Profile, State, Tables, Work
from ..surface.gap import FOLDED
from ..surface.locus import around_wheel, outline_jet
from ..surface.profile_table import height_slope, height_slope_bend

AT_PLANE: Final[int] = WORK_CONTACT + 3
AT_WHEEL_PLANE: Final[int] = WORK_CONTACT + 8
TRACER_RAIL: Final[int] = WORK_CONTACT + 11
TRACER_WHEEL: Final[int] = WORK_CONTACT + 14
# the contact frame, at WORK_CONTACT
# the tracer: the last station and the profile abscissae that belong to it

#: Where no wheel or rail is left at a station, the gap counts as this [m].
NO_GAP: Final[float] = 1.0
#: The tracer is extrapolated to second order over this distance at most [m].
NEAR: Final[float] = 1e-3
TRACE_ITERATIONS: Final[int] = 30
#: Smallest share of the wheel's own 1/r that is left for the longitudinal curvature of a strongly yawed flange root.
CURVATURE_FLOOR: Final[float] = 0.05


def open_frame(tables: Tables, work: Work, at: Place, y: float, aside: float, shift: float):
    """Place the contact plane at wheel abscissa ``y``; the slope is the rail's, which is the outline's there.

    aside, shift : lateral and vertical shift that let the wheel touch the rail there [m].

    Returns what describes the point: wheel height [m] and slope [-], lateral track coordinate [m], rail slope [-], and how
    much the slopes of rail and outline differ [-], FOLDED as in :mod:`gap`.
    """
    z, slope, bend = height_slope_bend(tables.wheel, y)
    y_track, z_track, outline_slope, stretch, outline_rate = outline_jet(at, y, z, slope, bend)
    y_track += aside
    abscissa = y_track - tables.rail_y
    height, rail_slope, rail_bend = height_slope_bend(tables.rail, abscissa)
    cosine = 1.0 / sqrt(1.0 + rail_slope * rail_slope)
    sine = rail_slope * cosine
    work.frame.abscissa = abscissa
    work.frame.height = height
    work.frame.y = y
    work.frame.cos = cosine
    work.frame.sin = sine
    work.frame.shift = shift
    work.frame.place = float(offset(at, work))
    work.frame.z = z
    work.frame.wheel_cos = at.cos_roll * cosine + at.sin_roll * sine
    work.frame.wheel_sin = at.cos_roll * sine - at.sin_roll * cosine
    work.frame.lift = z_track + shift - height
    work.frame.aside = aside
    work.frame.raised = 0.0
    work.frame.pose = shift
    work.frame.depth = 0.0
    work.frame.pressed = False
    work.frame.blur = 0.0
    start_tracer(work, 0.0, abscissa, y)
    mismatch = rail_slope - outline_slope
    if not stretch > 0.0:
        mismatch = FOLDED
    return z, slope, y_track, rail_slope, mismatch


def start_tracer(work: Work, station: float, abscissa: float, y: float):
    """Let the tracer stand at ``station`` with rail abscissa ``abscissa`` and wheel abscissa ``y`` [m]."""
    work.frame.tracer_station = station
    work.frame.tracer_rail = abscissa
    work.frame.tracer_rail_rate = work.frame.cos
    work.frame.tracer_rail_bend = 0.0
    work.frame.tracer_wheel = y
    work.frame.tracer_wheel_rate = work.frame.cos
    work.frame.tracer_wheel_bend = 0.0
    return 0


def longitudinal_curvature(tables: Tables, place: Work, at: Place, z: float, slope: float, bend: float):
    """Curvature 1/R_x of the wheel along the track at a locus point [1/m].

    effective: of the surface cut by the plane of the track's x and the contact normal.  With e the track's x in the
    wheelset frame, [(e1 cos(phi) - e3 sin(phi))^2 / r - r'' e2^2] / sqrt(1 + r'^2); without yaw cos(delta) / r, the
    source's eq. (6.1).
    basic: 1/r.
    """
    r = at.radius + z
    curvature = 1.0 / r
    if int(tables.longitudinal) == LONGITUDINAL_BASIC:
        return curvature
    if not at.yawed:
        curvature = 1.0 / (r * sqrt(1.0 + slope * slope))
    else:
        sin_phi, cos_phi = around_wheel(at, slope)
        e1 = at.cos_yaw
        e2 = at.sin_yaw * at.cos_roll
        e3 = at.sin_yaw * at.sin_roll
        around = e1 * cos_phi - e3 * sin_phi
        steep = sqrt(1.0 + slope * slope)
        curvature = (around * around / r - bend * e2 * e2) / steep
        if curvature < CURVATURE_FLOOR / (r * steep):
            curvature = CURVATURE_FLOOR / (r * steep)
    return curvature


def first_abscissa(work: 'float[:]', tracer: int, away: float):
    """Profile abscissa ``away`` from the tracer's station [m]; ``tracer`` is TRACER_RAIL or TRACER_WHEEL."""
    u = work[tracer] + away * work[tracer + 1]
    if fabs(away) < NEAR:
        u += 0.5 * away * away * work[tracer + 2]
    return u


def trace_profile(work: Work, profile: Profile, tracer: int, frame: int, station: float,
                  tolerance: float, origin: float, height_there: float):
    """Height of a profile over the contact plane [m], its rate [-] and bend [1/m] at ``station``, its slope there [-], its
    height [m], and 1 if it exists.

    tracer : TRACER_RAIL or TRACER_WHEEL.
    frame : where cosine and sine of the plane's angle against the profile stand.
    origin, height_there : the profile's point at station zero [m].
    """
    cosine = work[frame]
    sine = work[frame + 1]
    start = profile.start
    stop = profile.stop
    u = first_abscissa(work.raw, tracer, station - work.frame.tracer_station)
    exists = 0
    offset = 0.0
    forward = 1.0
    height = 0.0
    slope = 0.0
    bend = 0.0
    for i in range(TRACE_ITERATIONS):
        if u < start:
            u = start
        if u > stop:
            u = stop
        height, slope, bend = height_slope_bend(profile, u)
        forward = cosine + slope * sine
        offset = (u - origin) * cosine + (height - height_there) * sine - station
        if fabs(offset) < tolerance:
            if forward > 0.0:
                exists = 1
            break
        u -= offset / forward
    along = 1.0 / forward
    rate = (sine - slope * cosine) * along
    turn = -bend * along * along * along
    work[tracer] = u - offset * along
    work[tracer + 1] = along
    work[tracer + 2] = turn * sine
    ordinate = (u - origin) * sine - (height - height_there) * cosine
    return ordinate - offset * (rate - 0.5 * offset * turn), rate - offset * turn, turn, slope, height, exists


def trace_rail(tables: Tables, work: Work, station: float, tolerance: float):
    """Height of the rail over the contact plane [m], its rate [-] and bend [1/m] at ``station``; and 1 if it exists."""
    ordinate, rate, bend, slope, height, exists = trace_profile(work, tables.rail, TRACER_RAIL, AT_PLANE,
                                                                station, tolerance, work.frame.abscissa,
                                                                work.frame.height)
    return ordinate, rate, bend, exists


def trace_wheel(tables: Tables, work: Work, station: float, tolerance: float):
    """Height of the wheel over the contact plane [m], its rate [-], bend [1/m] and the wheel's 1/R_x [1/m] at
    ``station``; and 1 if it exists.

    Without yaw the outline is the profile, turned by the roll.
    """
    at = Place.at(work, int(work.frame.place))
    if not at.yawed:
        lift = work.frame.lift
        ordinate, rate, bend, slope, z, exists = trace_profile(work, tables.wheel, TRACER_WHEEL,
                                                               AT_WHEEL_PLANE, station - lift * work.frame.sin, tolerance,
                                                               work.frame.y, work.frame.z)
        ordinate -= lift * work.frame.cos
        curvature = longitudinal_curvature(tables, work, at, z, slope, bend)
    else:
        ordinate, rate, bend, curvature, exists = trace_outline(tables, work, at, station, tolerance)
    return ordinate, rate, bend, curvature, exists


def trace_outline(tables: Tables, work: Work, at: Place, station: float, tolerance: float):
    """``trace_wheel`` with yaw."""
    wheel = tables.wheel
    cosine = work.frame.cos
    sine = work.frame.sin
    start = wheel.start
    stop = wheel.stop
    left = tables.rail_y + work.frame.abscissa - work.frame.aside
    above = work.frame.shift - work.frame.height
    y = first_abscissa(work.raw, TRACER_WHEEL, station - work.frame.tracer_station)
    exists = 0
    offset = 0.0
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
        if y < start:
            y = start
        if y > stop:
            y = stop
        z, slope, bend = height_slope_bend(wheel, y)
        y_track, z_track, outline_slope, stretch, outline_rate = outline_jet(at, y, z, slope, bend)
        across = y_track - left
        up = z_track + above
        along = cosine + outline_slope * sine
        offset = across * cosine + up * sine - station
        if fabs(offset) < tolerance:
            if stretch * along > 0.0:
                exists = 1
            break
        y -= offset / (stretch * along)
    per_along = 1.0 / along
    per_stretch = 1.0 / stretch
    rate = (sine - outline_slope * cosine) * per_along
    turn = -outline_rate * per_stretch * per_along * per_along * per_along
    work.frame.tracer_wheel = y - offset * per_along * per_stretch
    work.frame.tracer_wheel_rate = per_along * per_stretch
    work.frame.tracer_wheel_bend = turn * sine * per_stretch
    curvature = longitudinal_curvature(tables, work, at, z, slope, bend)
    return across * sine - up * cosine - offset * (rate - 0.5 * offset * turn), rate - offset * turn, turn, curvature, exists


def normal_gap(tables: Tables, work: Work, state: State, station: float, tolerance: float):
    """Gap g along the contact normal [m], dg/ds [-], d2g/ds2 [1/m] and the wheel's 1/R_x [1/m] at ``station`` [m].

    NO_GAP where a profile has ended.
    """
    state.node_count += 1.0
    rail_height, rail_rate, rail_bend, on_rail = trace_rail(tables, work, station, tolerance)
    wheel_height, wheel_rate, wheel_bend, curvature, on_wheel = trace_wheel(tables, work, station, tolerance)
    work.frame.tracer_station = station
    gap = wheel_height - rail_height + work.frame.raised
    if on_rail == 0 or on_wheel == 0:
        gap = NO_GAP
    return gap, wheel_rate - rail_rate, wheel_bend - rail_bend, curvature


def is_yawed(work: Work):
    """1 if the wheel of the open frame is yawed, else 0."""
    at = Place.at(work, int(work.frame.place))
    yawed = 0
    if at.yawed:
        yawed = 1
    return yawed


def ridge_place(tables: Tables, work: Work, y: float):
    """Track coordinate x [m] of the wheel's outline at wheel abscissa ``y`` [m]."""
    at = Place.at(work, int(work.frame.place))
    z, slope = height_slope(tables.wheel, y)
    sin_phi, cos_phi = around_wheel(at, slope)
    r = at.radius + z
    lateral = (at.arm + y) * at.cos_roll - r * cos_phi * at.sin_roll
    return at.cos_yaw * r * sin_phi - at.sin_yaw * lateral
