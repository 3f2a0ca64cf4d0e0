"""The worn profile: depth smoothed over the arc, points moved along the normal, new pieces where it is worn.

A point moves into the material by the depth d,

    wheel: (y, z) + d (z', -1) / sqrt(1 + z'^2)        rail: (y, z) + d (-z', 1) / sqrt(1 + z'^2)

with z down.  On a flank of 70 degrees that is mostly sideways.  Where nothing is worn the pieces of the
profile stay as they are.
"""

import math
from dataclasses import replace

import numpy as np

from ..conventions import MILLIMETRE as MM
from ..kernel.prepare import zones as placement
from ..profiles.profile import Profile
from ..profiles.remarks import Reading
from ..profiles.zones import Arc as Circle
from ..profiles.zones import Polynomial
from .bins import evaluate

#: Largest depth in one step, and largest smoothing [m].
DEEPEST, SMOOTHEST = 2e-3, 5e-3
#: Distance between the points of the worn part along the arc [m].
SPACING = 0.2e-3
#: Depth below which nothing is worn [m].
NOTHING = 1e-12
#: Steepest part that is a height over y; behind the flange a wheel may be vertical.
STEEPEST = 50.0
#: A piece that is narrower is none [mm].
SLIVER = 1e-10


def smoothed(depth, arc, smoothing):
    """``depth`` (bins,) under a bell curve with this standard deviation [m]; mirrored at the ends, so that
    its integral stays.

    Raises
    ------
    ValueError
        if ``smoothing`` is not permitted.
    """
    if not 0.0 <= smoothing <= SMOOTHEST:
        raise ValueError(f"smoothing is {smoothing!r} m; permitted is 0 ... {SMOOTHEST:g} m")
    if smoothing == 0.0:
        return np.array(depth, dtype=float)
    from scipy.ndimage import gaussian_filter1d  # not needed before

    return gaussian_filter1d(np.asarray(depth, dtype=float), smoothing / arc.width, mode="reflect")


def worn_profile(arc, depth, remarks=()):
    """The profile of an ``arc`` with ``depth`` (bins,) [m] taken off along its normal.

    A rail is shifted so that its highest point is the origin, and notes how far its inner face has worn, so that
    it keeps its place on the track.  ``remarks`` are sentences for the profile's
    ``reading``.

    Raises
    ------
    ValueError
        if the worn curve folds.
    """
    profile, zones = arc.profile, arc.profile.zones
    worn, face = np.flatnonzero(depth > NOTHING), profile.worn_face
    if len(worn):
        start, stop = arc.edges[max(worn[0] - 1, 0)], arc.edges[min(worn[-1] + 2, len(depth))]
        zones = tuple(_zones(arc, depth, *_not_steep(arc, start, stop)))
        if profile.kind == "rail":
            face += _inner_face(arc, zones) - _inner_face(arc, profile.zones)
            top = _top(zones)
            zones = tuple(_shifted(zone, *top) for zone in zones)
    reading = Reading(len(zones), SPACING, SPACING, 0.0, 0.0, tuple(remarks))
    return Profile(profile.name, profile.kind, zones, profile.smooth, reading=reading, worn_face=face)


def _inner_face(arc, zones):
    """Place [m] of the inner face of a rail of these ``zones`` at the depth of the gauge, across the track; 0 where
    the zones end above it, as no track can be laid with them."""
    angle, rail = -math.atan(arc.inclination), Profile(arc.profile.name, "rail", zones, arc.profile.smooth)
    numbers = rail.definition().tolist()
    _, top = placement.highest_point(numbers, 0, angle)
    depth = top + arc.gauge_depth / MM
    place, reached = placement.inner_face(numbers, 0, angle, depth)
    return place * MM if reached >= depth else 0.0


def moved_places(arc, depth, worn):
    """Places (bins,) [m] on the ``worn`` profile of what lies in the middles of the bins, see
    :func:`worn_profile`."""
    y = np.append(arc.y[0], arc.own_places)
    d = np.append(depth[0], depth)
    _, slope = evaluate(arc.profile, y)
    across = y + (1.0 if arc.profile.kind == "wheel" else -1.0) * d * slope / np.hypot(1.0, slope)
    shift = across[0] - arc.y[0] + arc.profile.start - worn.start if arc.profile.kind == "rail" else 0.0
    return across[1:] - shift


def _not_steep(arc, start, stop):
    """The stretch from ``start`` to ``stop`` [m of arc], without an end that is nearly vertical."""
    inside = np.flatnonzero((arc.s >= start) & (arc.s <= stop))
    steep = np.abs(np.gradient(arc.height, arc.y)[inside]) > STEEPEST
    if np.any(steep):
        middle = len(inside) // 2
        steep_at = np.flatnonzero(steep)
        low = np.max(steep_at[steep_at < middle], initial=-1) + 1
        high = np.min(steep_at[steep_at >= middle], initial=len(inside)) - 1
        start, stop = arc.s[inside[low]], arc.s[inside[high]]
    return start, stop


def _zones(arc, depth, start, stop):
    """Zones of the worn profile: new ones from ``start`` to ``stop`` [m of arc], between the old ones."""
    from scipy.interpolate import CubicSpline  # not needed before

    profile = arc.profile
    low, high = np.interp([start, stop], arc.s, arc.y)
    low = profile.start if start <= 0.0 else low
    high = profile.stop if stop >= arc.s[-1] else high
    s = np.linspace(start, stop, max(int(round((stop - start) / SPACING)), 4) + 1)
    y = np.interp(s, arc.s, arc.y)
    y[0], y[-1] = low, high
    z, slope = evaluate(profile, y)
    d = np.interp(s, arc.middles, depth)
    ends = [low == profile.start, high == profile.stop]
    d[0], d[-1] = d[0] if ends[0] else 0.0, d[-1] if ends[1] else 0.0
    into = (1.0 if profile.kind == "wheel" else -1.0) * d / np.hypot(1.0, slope)
    y_new, z_new = (y + into * slope) / MM, (z - into) / MM
    if not np.all(np.diff(y_new) > 0.0):
        at = int(np.argmin(np.diff(y_new)))
        raise ValueError(
            f"the worn profile {profile.name} folds at y = {y_new[at]:.4g} mm, where the depth is "
            f"{1e3 * d[at]:.3g} mm; permitted are smaller steps or more smoothing"
        )
    tangent = [(1, float(slope[k])) if not free else "not-a-knot" for k, free in zip((0, -1), ends)]
    spline = CubicSpline(y_new, z_new, bc_type=tuple(tangent))
    new = [
        Polynomial(float(a), float(b), tuple(map(float, piece[::-1])), float(a))
        for a, b, piece in zip(y_new[:-1], y_new[1:], spline.c.T)
    ]
    return [
        *_cut(profile.zones, None, y_new[0] if not ends[0] else None),
        *new,
        *_cut(profile.zones, y_new[-1] if not ends[1] else None, None, behind=True),
    ]


def _cut(zones, low, high, behind=False):
    """The old zones up to ``high``, or from ``low`` on if ``behind`` [mm]; none where that is None."""
    limit = low if behind else high
    if limit is None:
        return []
    if behind:
        return [replace(zone, start=max(zone.start, limit)) for zone in zones if zone.stop > limit + SLIVER]
    return [replace(zone, stop=min(zone.stop, limit)) for zone in zones if zone.start < limit - SLIVER]


def _top(zones):
    """Highest point (y, z) [mm] of the zones of a rail."""
    heights = [float(zone(zone.start)[0]) for zone in zones]
    k = int(np.argmin(heights))
    best = (heights[k], zones[k].start)
    for zone in zones[max(k - 1, 0) : k + 2]:
        at = 0.5 * (zone.start + zone.stop)
        for _ in range(6):
            _, slope, bend = (float(part) for part in zone(at))
            if not bend > 0.0:
                break
            at = float(np.clip(at - slope / bend, zone.start, zone.stop))
        best = min(best, (float(zone(at)[0]), at))
    return best[1], best[0]


def _shifted(zone, across, down):
    """``zone`` moved by (-across, -down) [mm]."""
    moved = replace(zone, start=zone.start - across, stop=zone.stop - across)
    if isinstance(zone, Circle):
        return replace(moved, y_centre=zone.y_centre - across, z_centre=zone.z_centre - down)
    first, *rest = zone.coefficients
    return replace(moved, coefficients=(first - down, *rest), origin=zone.origin - across)
