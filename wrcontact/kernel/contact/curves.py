"""Rail and wheel as two curves across the track, each over its profile's abscissa, for separations measured
along them.

The wheel's curve is its outline (:mod:`locus`); without yaw that is the profile, turned by the roll.
``curve`` is RAIL or WHEEL, and its present abscissa is that of the frame's trace.  Coordinates are those from
the origin of the region.
"""

from math import sqrt

from ..layout import (RAIL, SEPARATION_EQUIDISTANT_CHORD, SEPARATION_NORMAL, WHEEL, Frame, Origin, Profile,
                      Region, Tables, seldom)
from ..surface.locus import outline_jet
from ..surface.profile_table import height_slope, height_slope_bend


@seldom
def curve_profile(tables: Tables, curve: int) -> Profile:
    """The profile of a curve."""
    profile = tables.wheel
    if curve == RAIL:
        profile = tables.rail
    return profile


@seldom
def curve_jet(tables: Tables, frame: Frame, origin: Origin, curve: int, u: float):
    """Point of a curve from its origin, across and down [m], its slope [-], and along the profile abscissa
    ``u`` the derivatives of the lateral coordinate [-] and of the slope [1/m]."""
    z, slope, bend = height_slope_bend(curve_profile(tables, curve), u)
    across = u - origin.points[RAIL].y
    down = z - origin.points[RAIL].z
    stretch = 1.0
    if curve == WHEEL:
        y_track, z_track, slope, stretch, bend = outline_jet(frame.place, u, z, slope, bend)
        across = y_track - origin.points[WHEEL].y
        down = z_track - origin.points[WHEEL].z
    return across, down, slope, stretch, bend


@seldom
def curve_speed(tables: Tables, frame: Frame, origin: Origin, curve: int, u: float):
    """Arc length per profile abscissa [-]; of an outline that folds back it is negative.  A roll does not
    change it."""
    speed = 1.0
    if curve == RAIL or not frame.place.yawed:
        z, slope = height_slope(curve_profile(tables, curve), u)
        speed = sqrt(1.0 + slope * slope)
    else:
        across, down, slope, stretch, bend = curve_jet(tables, frame, origin, curve, u)
        speed = stretch * sqrt(1.0 + slope * slope)
    return speed


@seldom
def within(tables: Tables, curve: int, u: float):
    """``u``, or the end of the profile that it lies beyond [m]."""
    profile = curve_profile(tables, curve)
    if u < profile.start:
        u = profile.start
    if u > profile.stop:
        u = profile.stop
    return u


@seldom
def open_origin(tables: Tables, frame: Frame, origin: Origin, region: Region, spacing: float):
    """Measure from the minimum of ``region``; chords, if any, are as long as ``spacing`` [m], or arcs where
    that is 0."""
    if tables.separation != SEPARATION_NORMAL:
        origin.station = region.station
        origin.gap = region.gap
        origin.spacing = 0.0
        if tables.separation == SEPARATION_EQUIDISTANT_CHORD:
            origin.spacing = spacing
        open_curve(tables, frame, origin, RAIL, region.rail)
        open_curve(tables, frame, origin, WHEEL, region.wheel)


@seldom
def open_curve(tables: Tables, frame: Frame, origin: Origin, curve: int, u: float):
    """Let the origin of a curve be its point at abscissa ``u`` [m]."""
    point = origin.points[curve]
    point.y = 0.0
    point.z = 0.0
    across, down, slope, stretch, bend = curve_jet(tables, frame, origin, curve, u)
    point.y = across
    point.z = down
