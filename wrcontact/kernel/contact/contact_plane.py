"""The geometry that a normal contact model needs, in the plane of the rigid contact point.

Station s runs along the contact plane to the field side, from the contact point; heights n are measured along the
plane's normal, from rail to wheel.  The outline of the wheel (:mod:`locus`) and the rail profile are both read as
n(s): the profile abscissa that projects on s is found by Newton's method from the previous station, and the last
residual is removed by the curve's own slope and bend, which leaves an error of third order in a small residual.
"""

from math import fabs, sqrt
from typing import Final

from ..surface.gap import FOLDED
from ..layout import LONGITUDINAL_BASIC, SET_LONGITUDINAL, SET_RAIL, SET_RAIL_Y, SET_WHEEL, STATE_NODE_COUNT, WORK_CONTACT
from ..surface.locus import (PLACE_ARM, PLACE_COS_ROLL, PLACE_COS_YAW, PLACE_RADIUS, PLACE_SIN_ROLL, PLACE_SIN_YAW, PLACE_YAWED,
                    around_wheel, outline_jet)
from ..surface.profile_table import START, STOP, height_slope, height_slope_bend

# the contact frame, at WORK_CONTACT
FRAME_ABSCISSA: Final[int] = WORK_CONTACT + 0    # rail abscissa of the contact point [m]
FRAME_HEIGHT: Final[int] = WORK_CONTACT + 1      # rail height there [m]
FRAME_Y: Final[int] = WORK_CONTACT + 2           # wheel abscissa [m]
FRAME_COS: Final[int] = WORK_CONTACT + 3         # of the plane's angle
FRAME_SIN: Final[int] = WORK_CONTACT + 4
FRAME_SHIFT: Final[int] = WORK_CONTACT + 5       # vertical shift of the wheelset [m]
FRAME_PLACE: Final[int] = WORK_CONTACT + 6       # offset of the placed wheel in the workspace
FRAME_Z: Final[int] = WORK_CONTACT + 7           # wheel height [m]
FRAME_WHEEL_COS: Final[int] = WORK_CONTACT + 8   # of the plane's angle in the wheelset's frame
FRAME_WHEEL_SIN: Final[int] = WORK_CONTACT + 9
FRAME_LIFT: Final[int] = WORK_CONTACT + 17       # of the wheel's point below the rail's [m]; zero but for rounding
FRAME_ASIDE: Final[int] = WORK_CONTACT + 18      # lateral shift that lets the wheel just touch [m]; zero for a rigid contact
FRAME_RAISE: Final[int] = WORK_CONTACT + 19      # what is added to the gap of a region with a plane of its own [m]
FRAME_POSE: Final[int] = WORK_CONTACT + 20       # vertical shift of the wheelset where it stands [m]
FRAME_DEPTH: Final[int] = WORK_CONTACT + 21      # how deep wheel and rail overlap there, along the normal [m]
FRAME_PRESSED: Final[int] = WORK_CONTACT + 22    # 1 if the wheel comes down, 0 if it comes along the normal
FRAME_BLUR: Final[int] = WORK_CONTACT + 23       # half the stretch of a pressed wheel that its bend is averaged over [m]
# the tracer: the last station and the profile abscissae that belong to it
TRACER_STATION: Final[int] = WORK_CONTACT + 10
TRACER_RAIL: Final[int] = WORK_CONTACT + 11
TRACER_RAIL_RATE: Final[int] = WORK_CONTACT + 12
TRACER_RAIL_BEND: Final[int] = WORK_CONTACT + 13
TRACER_WHEEL: Final[int] = WORK_CONTACT + 14
TRACER_WHEEL_RATE: Final[int] = WORK_CONTACT + 15
TRACER_WHEEL_BEND: Final[int] = WORK_CONTACT + 16

#: Where no wheel or rail is left at a station, the gap counts as this [m].
NO_GAP: Final[float] = 1.0
#: The tracer is extrapolated to second order over this distance at most [m].
NEAR: Final[float] = 1e-3
TRACE_ITERATIONS: Final[int] = 30
#: Smallest share of the wheel's own 1/r that is left for the longitudinal curvature of a strongly yawed flange root.
CURVATURE_FLOOR: Final[float] = 0.05


def open_frame(tables: 'float[:]', work: 'float[:]', at: int, y: float, aside: float, shift: float):
    """Place the contact plane at wheel abscissa ``y``; the slope is the rail's, which is the outline's there.

    aside, shift : lateral and vertical shift that let the wheel touch the rail there [m].

    Returns what describes the point: wheel height [m] and slope [-], lateral track coordinate [m], rail slope [-], and how
    much the slopes of rail and outline differ [-], FOLDED as in :mod:`gap`.
    """
    z, slope, bend = height_slope_bend(tables, int(tables[SET_WHEEL]), y)
    y_track, z_track, outline_slope, stretch, outline_rate = outline_jet(work, at, y, z, slope, bend)
    y_track += aside
    abscissa = y_track - tables[SET_RAIL_Y]
    height, rail_slope, rail_bend = height_slope_bend(tables, int(tables[SET_RAIL]), abscissa)
    cosine = 1.0 / sqrt(1.0 + rail_slope * rail_slope)
    sine = rail_slope * cosine
    work[FRAME_ABSCISSA] = abscissa
    work[FRAME_HEIGHT] = height
    work[FRAME_Y] = y
    work[FRAME_COS] = cosine
    work[FRAME_SIN] = sine
    work[FRAME_SHIFT] = shift
    work[FRAME_PLACE] = float(at)
    work[FRAME_Z] = z
    work[FRAME_WHEEL_COS] = work[at + PLACE_COS_ROLL] * cosine + work[at + PLACE_SIN_ROLL] * sine
    work[FRAME_WHEEL_SIN] = work[at + PLACE_COS_ROLL] * sine - work[at + PLACE_SIN_ROLL] * cosine
    work[FRAME_LIFT] = z_track + shift - height
    work[FRAME_ASIDE] = aside
    work[FRAME_RAISE] = 0.0
    work[FRAME_POSE] = shift
    work[FRAME_DEPTH] = 0.0
    work[FRAME_PRESSED] = 0.0
    work[FRAME_BLUR] = 0.0
    start_tracer(work, 0.0, abscissa, y)
    mismatch = rail_slope - outline_slope
    if not stretch > 0.0:
        mismatch = FOLDED
    return z, slope, y_track, rail_slope, mismatch


def start_tracer(work: 'float[:]', station: float, abscissa: float, y: float):
    """Let the tracer stand at ``station`` with rail abscissa ``abscissa`` and wheel abscissa ``y`` [m]."""
    work[TRACER_STATION] = station
    work[TRACER_RAIL] = abscissa
    work[TRACER_RAIL_RATE] = work[FRAME_COS]
    work[TRACER_RAIL_BEND] = 0.0
    work[TRACER_WHEEL] = y
    work[TRACER_WHEEL_RATE] = work[FRAME_COS]
    work[TRACER_WHEEL_BEND] = 0.0
    return 0


def longitudinal_curvature(tables: 'float[:]', place: 'float[:]', at: int, z: float, slope: float, bend: float):
    """Curvature 1/R_x of the wheel along the track at a locus point [1/m].

    effective: of the surface cut by the plane of the track's x and the contact normal.  With e the track's x in the
    wheelset frame, [(e1 cos(phi) - e3 sin(phi))^2 / r - r'' e2^2] / sqrt(1 + r'^2); without yaw cos(delta) / r, the
    source's eq. (6.1).
    basic: 1/r.
    """
    r = place[at + PLACE_RADIUS] + z
    curvature = 1.0 / r
    if int(tables[SET_LONGITUDINAL]) == LONGITUDINAL_BASIC:
        return curvature
    if place[at + PLACE_YAWED] == 0.0:
        curvature = 1.0 / (r * sqrt(1.0 + slope * slope))
    else:
        sin_phi, cos_phi = around_wheel(place, at, slope)
        e1 = place[at + PLACE_COS_YAW]
        e2 = place[at + PLACE_SIN_YAW] * place[at + PLACE_COS_ROLL]
        e3 = place[at + PLACE_SIN_YAW] * place[at + PLACE_SIN_ROLL]
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


def trace_profile(tables: 'float[:]', work: 'float[:]', base: int, tracer: int, frame: int, station: float,
                  tolerance: float, origin: float, height_there: float):
    """Height of a profile over the contact plane [m], its rate [-] and bend [1/m] at ``station``, its slope there [-], its
    height [m], and 1 if it exists.

    tracer : TRACER_RAIL or TRACER_WHEEL.
    frame : where cosine and sine of the plane's angle against the profile stand.
    origin, height_there : the profile's point at station zero [m].
    """
    cosine = work[frame]
    sine = work[frame + 1]
    start = tables[base + START]
    stop = tables[base + STOP]
    u = first_abscissa(work, tracer, station - work[TRACER_STATION])
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
        height, slope, bend = height_slope_bend(tables, base, u)
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


def trace_rail(tables: 'float[:]', work: 'float[:]', station: float, tolerance: float):
    """Height of the rail over the contact plane [m], its rate [-] and bend [1/m] at ``station``; and 1 if it exists."""
    ordinate, rate, bend, slope, height, exists = trace_profile(tables, work, int(tables[SET_RAIL]), TRACER_RAIL, FRAME_COS,
                                                                station, tolerance, work[FRAME_ABSCISSA],
                                                                work[FRAME_HEIGHT])
    return ordinate, rate, bend, exists


def trace_wheel(tables: 'float[:]', work: 'float[:]', station: float, tolerance: float):
    """Height of the wheel over the contact plane [m], its rate [-], bend [1/m] and the wheel's 1/R_x [1/m] at
    ``station``; and 1 if it exists.

    Without yaw the outline is the profile, turned by the roll.
    """
    at = int(work[FRAME_PLACE])
    if work[at + PLACE_YAWED] == 0.0:
        lift = work[FRAME_LIFT]
        ordinate, rate, bend, slope, z, exists = trace_profile(tables, work, int(tables[SET_WHEEL]), TRACER_WHEEL,
                                                               FRAME_WHEEL_COS, station - lift * work[FRAME_SIN], tolerance,
                                                               work[FRAME_Y], work[FRAME_Z])
        ordinate -= lift * work[FRAME_COS]
        curvature = longitudinal_curvature(tables, work, at, z, slope, bend)
    else:
        ordinate, rate, bend, curvature, exists = trace_outline(tables, work, at, station, tolerance)
    return ordinate, rate, bend, curvature, exists


def trace_outline(tables: 'float[:]', work: 'float[:]', at: int, station: float, tolerance: float):
    """``trace_wheel`` with yaw."""
    wheel = int(tables[SET_WHEEL])
    cosine = work[FRAME_COS]
    sine = work[FRAME_SIN]
    start = tables[wheel + START]
    stop = tables[wheel + STOP]
    left = tables[SET_RAIL_Y] + work[FRAME_ABSCISSA] - work[FRAME_ASIDE]
    above = work[FRAME_SHIFT] - work[FRAME_HEIGHT]
    y = first_abscissa(work, TRACER_WHEEL, station - work[TRACER_STATION])
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
        z, slope, bend = height_slope_bend(tables, wheel, y)
        y_track, z_track, outline_slope, stretch, outline_rate = outline_jet(work, at, y, z, slope, bend)
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
    work[TRACER_WHEEL] = y - offset * per_along * per_stretch
    work[TRACER_WHEEL_RATE] = per_along * per_stretch
    work[TRACER_WHEEL_BEND] = turn * sine * per_stretch
    curvature = longitudinal_curvature(tables, work, at, z, slope, bend)
    return across * sine - up * cosine - offset * (rate - 0.5 * offset * turn), rate - offset * turn, turn, curvature, exists


def normal_gap(tables: 'float[:]', work: 'float[:]', state: 'float[:]', station: float, tolerance: float):
    """Gap g along the contact normal [m], dg/ds [-], d2g/ds2 [1/m] and the wheel's 1/R_x [1/m] at ``station`` [m].

    NO_GAP where a profile has ended.
    """
    state[STATE_NODE_COUNT] += 1.0
    rail_height, rail_rate, rail_bend, on_rail = trace_rail(tables, work, station, tolerance)
    wheel_height, wheel_rate, wheel_bend, curvature, on_wheel = trace_wheel(tables, work, station, tolerance)
    work[TRACER_STATION] = station
    gap = wheel_height - rail_height + work[FRAME_RAISE]
    if on_rail == 0 or on_wheel == 0:
        gap = NO_GAP
    return gap, wheel_rate - rail_rate, wheel_bend - rail_bend, curvature


def is_yawed(work: 'float[:]'):
    """1 if the wheel of the open frame is yawed, else 0."""
    return int(work[int(work[FRAME_PLACE]) + PLACE_YAWED])


def ridge_place(tables: 'float[:]', work: 'float[:]', y: float):
    """Track coordinate x [m] of the wheel's outline at wheel abscissa ``y`` [m]."""
    at = int(work[FRAME_PLACE])
    z, slope = height_slope(tables, int(tables[SET_WHEEL]), y)
    sin_phi, cos_phi = around_wheel(work, at, slope)
    r = work[at + PLACE_RADIUS] + z
    lateral = (work[at + PLACE_ARM] + y) * work[at + PLACE_COS_ROLL] - r * cos_phi * work[at + PLACE_SIN_ROLL]
    return work[at + PLACE_COS_YAW] * r * sin_phi - work[at + PLACE_SIN_YAW] * lateral
