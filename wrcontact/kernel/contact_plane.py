"""The geometry that a normal contact model needs, in the plane of the rigid contact point.

Station s runs along the contact plane to the field side, from the contact point; heights n are measured along the
plane's normal, from rail to wheel.  The outline of the wheel (:mod:`locus`) and the rail profile are both read as
n(s): the profile abscissa that projects on s is found by Newton's method from the previous station, and the last
residual is removed by the curve's own slope, which leaves an error of second order in a small residual.
"""

from math import fabs, sqrt
from typing import Final

from .layout import (LONGITUDINAL_BASIC, SET_LONGITUDINAL, SET_RAIL, SET_RAIL_Y, SET_WHEEL, STATE_NODE_COUNT,
                     WORK_CONTACT)
from .locus import (PLACE_COS_ROLL, PLACE_COS_YAW, PLACE_RADIUS, PLACE_SIN_ROLL, PLACE_SIN_YAW, PLACE_YAWED,
                    around_wheel, outline_jet, outline_point)
from .profile_table import START, STOP, height_slope_bend

# the contact frame, at WORK_CONTACT
FRAME_ABSCISSA: Final[int] = WORK_CONTACT + 0    # rail abscissa of the contact point [m]
FRAME_HEIGHT: Final[int] = WORK_CONTACT + 1      # rail height there [m]
FRAME_Y: Final[int] = WORK_CONTACT + 2           # wheel abscissa [m]
FRAME_COS: Final[int] = WORK_CONTACT + 3         # of the plane's angle
FRAME_SIN: Final[int] = WORK_CONTACT + 4
FRAME_SHIFT: Final[int] = WORK_CONTACT + 5       # vertical shift of the wheelset [m]
FRAME_PLACE: Final[int] = WORK_CONTACT + 6       # offset of the placed wheel in the workspace
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


def open_frame(tables: 'float[:]', work: 'float[:]', at: int, y: float, shift: float):
    """Place the contact plane at wheel abscissa ``y``; the slope is the rail's, which is the outline's there."""
    z, slope, bend = height_slope_bend(tables, int(tables[SET_WHEEL]), y)
    y_track, z_track, outline_slope = outline_point(work, at, y, z, slope)
    abscissa = y_track - tables[SET_RAIL_Y]
    height, rail_slope, rail_bend = height_slope_bend(tables, int(tables[SET_RAIL]), abscissa)
    cosine = 1.0 / sqrt(1.0 + rail_slope * rail_slope)
    work[FRAME_ABSCISSA] = abscissa
    work[FRAME_HEIGHT] = height
    work[FRAME_Y] = y
    work[FRAME_COS] = cosine
    work[FRAME_SIN] = rail_slope * cosine
    work[FRAME_SHIFT] = shift
    work[FRAME_PLACE] = float(at)
    start_tracer(work, 0.0, abscissa, y)
    return 0


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


def trace_rail(tables: 'float[:]', work: 'float[:]', station: float, tolerance: float):
    """Height of the rail over the contact plane [m], its rate [-] and bend [1/m] at ``station``; and 1 if it exists."""
    rail = int(tables[SET_RAIL])
    cosine = work[FRAME_COS]
    sine = work[FRAME_SIN]
    away = station - work[TRACER_STATION]
    u = work[TRACER_RAIL] + away * work[TRACER_RAIL_RATE]
    if fabs(away) < NEAR:
        u += 0.5 * away * away * work[TRACER_RAIL_BEND]
    exists = 1
    offset = 0.0
    forward = 1.0
    height = 0.0
    slope = 0.0
    bend = 0.0
    for i in range(TRACE_ITERATIONS):
        if u < tables[rail + START]:
            u = tables[rail + START]
        if u > tables[rail + STOP]:
            u = tables[rail + STOP]
        height, slope, bend = height_slope_bend(tables, rail, u)
        forward = cosine + slope * sine
        offset = (u - work[FRAME_ABSCISSA]) * cosine + (height - work[FRAME_HEIGHT]) * sine - station
        if fabs(offset) < tolerance:
            break
        u -= offset / forward
    if not (fabs(offset) < tolerance and forward > 0.0):
        exists = 0
    rate = (sine - slope * cosine) / forward
    ordinate = (u - work[FRAME_ABSCISSA]) * sine - (height - work[FRAME_HEIGHT]) * cosine - offset * rate
    work[TRACER_RAIL] = u - offset / forward
    work[TRACER_RAIL_RATE] = 1.0 / forward
    work[TRACER_RAIL_BEND] = -bend * sine / (forward * forward * forward)
    return ordinate, rate, -bend / (forward * forward * forward), exists


def trace_wheel(tables: 'float[:]', work: 'float[:]', station: float, tolerance: float):
    """Height of the wheel over the contact plane [m], its rate [-], bend [1/m] and the wheel's 1/R_x [1/m] at
    ``station``; and 1 if it exists."""
    wheel = int(tables[SET_WHEEL])
    at = int(work[FRAME_PLACE])
    cosine = work[FRAME_COS]
    sine = work[FRAME_SIN]
    away = station - work[TRACER_STATION]
    y = work[TRACER_WHEEL] + away * work[TRACER_WHEEL_RATE]
    if fabs(away) < NEAR:
        y += 0.5 * away * away * work[TRACER_WHEEL_BEND]
    exists = 1
    offset = 0.0
    forward = 1.0
    across = 0.0
    up = 0.0
    stretch = 1.0
    z = 0.0
    slope = 0.0
    bend = 0.0
    outline_slope = 0.0
    outline_rate = 0.0
    for i in range(TRACE_ITERATIONS):
        if y < tables[wheel + START]:
            y = tables[wheel + START]
        if y > tables[wheel + STOP]:
            y = tables[wheel + STOP]
        z, slope, bend = height_slope_bend(tables, wheel, y)
        y_track, z_track, outline_slope, stretch, outline_rate = outline_jet(work, at, y, z, slope, bend)
        across = y_track - tables[SET_RAIL_Y] - work[FRAME_ABSCISSA]
        up = z_track + work[FRAME_SHIFT] - work[FRAME_HEIGHT]
        forward = stretch * (cosine + outline_slope * sine)
        offset = across * cosine + up * sine - station
        if fabs(offset) < tolerance:
            break
        y -= offset / forward
    if not (fabs(offset) < tolerance and forward > 0.0):
        exists = 0
    along = cosine + outline_slope * sine
    rate = (sine - outline_slope * cosine) / along
    ordinate = across * sine - up * cosine - offset * rate
    outline_bend = outline_rate / (stretch * along * along * along)
    work[TRACER_WHEEL] = y - offset / forward
    work[TRACER_WHEEL_RATE] = 1.0 / forward
    work[TRACER_WHEEL_BEND] = -outline_bend * sine / stretch
    return ordinate, rate, -outline_bend, longitudinal_curvature(tables, work, at, z, slope, bend), exists


def normal_gap(tables: 'float[:]', work: 'float[:]', state: 'float[:]', station: float, tolerance: float):
    """Gap g along the contact normal [m], dg/ds [-], d2g/ds2 [1/m] and the wheel's 1/R_x [1/m] at ``station`` [m].

    NO_GAP where a profile has ended.
    """
    state[STATE_NODE_COUNT] += 1.0
    rail_height, rail_rate, rail_bend, on_rail = trace_rail(tables, work, station, tolerance)
    wheel_height, wheel_rate, wheel_bend, curvature, on_wheel = trace_wheel(tables, work, station, tolerance)
    work[TRACER_STATION] = station
    gap = wheel_height - rail_height
    if on_rail == 0 or on_wheel == 0:
        gap = NO_GAP
    return gap, wheel_rate - rail_rate, wheel_bend - rail_bend, curvature
