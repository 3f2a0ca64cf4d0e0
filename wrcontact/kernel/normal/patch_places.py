"""Where the loads of patches act, and along which direction.

The rail pushes the wheel along the normal (0, -sin(angle), -cos(angle)): the rail's normal where the load
acts, or the mean over a region where that is known (``mean_normal``).  A patch that reaches over the bound
between two regions has two normals and two places, one for each.
"""

from math import sqrt

from ..contact.curves import abscissa_after, rail_way
from ..elementary.circle import atan
from ..layout import (
    LOAD_VERTICAL,
    REGION_LIMIT,
    ROLLING_STRIP_LIMIT,
    Contact,
    Frame,
    Nodes,
    Pair,
    Patch,
    Region,
    SideSearch,
)
from ..surface.rails import on_track, upright_share
from ..surface.tables import height_slope, read_cubic


def mean_normal(pair: Pair, frame: Frame, region: Region, nodes: Nodes, local_penetration: float):
    """Let the force of a region act along the mean of the rail's normals, weighted by the line load at a
    local penetration [m].

    The nodes lie along the rail.
    """
    arc = read_cubic(pair.rail_arc, region.rail)
    total = 0.0
    cosines = 0.0
    sines = 0.0
    for direction in range(-1, 2, 2):
        x = region.rail
        step = float(direction) * region.spacing
        last = region.last
        if direction < 0:
            last = -region.first
        for k in range(last + 1):
            height, slope = height_slope(pair.rail, x)
            cosine = 1.0 / sqrt(1.0 + slope * slope)
            weight = nodes.line[direction * k] * (local_penetration - nodes.rise[direction * k])
            if weight <= 0.0:
                break
            if k == 0:
                weight *= 0.5
            total += weight
            cosines += weight * cosine
            sines += weight * slope * cosine
            x = read_cubic(pair.rail_at_arc, arc + step * float(k + 1))
    if total > 0.0:
        region.cos = cosines / total
        region.sin = sines / total
        if pair.tables.load == LOAD_VERTICAL:
            region.share = upright_share(frame.place, region.cos, region.sin)


def place_patches(pair: Pair, contact: Contact, side: SideSearch):
    """Centres of load, normal forces and penetrations of the patches of a side whose regions are solved."""
    for index in range(side.patch_count):
        patch = side.patches[index]
        for number in range(REGION_LIMIT):
            if patch.loads[number] != 0.0:
                region = contact.regions[number]
                local = region.alignment * side.penetration - region.gap
                patch.penetration = max(patch.penetration, local)
                place_load(pair, contact.frame, region, patch, number)
        close_place(patch)


def place_load(pair: Pair, frame: Frame, region: Region, patch: Patch, number: int):
    """The load of a patch in a region, which is its ``number``: its force, its moment about the track's
    origin, and its place [m], weighted by the load until :func:`close_place`."""
    load = patch.loads[number]
    # from the region's smallest gap to the part's centre of load; a part that carries less than nothing
    # (patch/filling.py) has no such centre
    away = 0.0
    if load > 0.0:
        away = patch.moments[number] / load - region.offset - region.station
    abscissa = abscissa_at(pair, frame, region, away)
    height, slope = height_slope(pair.rail, abscissa)
    normal_cos = 1.0 / sqrt(1.0 + slope * slope)
    normal_sin = slope * normal_cos
    if frame.pressed or pair.tables.load == LOAD_VERTICAL:
        normal_cos = region.cos
        normal_sin = region.sin
    x = region.x_track + region.slant * away
    y, z = on_track(frame.place, pair.rail_y, pair.rail_y + abscissa, height)
    if frame.place.leaning:
        down = normal_cos
        normal_cos = frame.place.rail_cos * down - frame.place.rail_sin * normal_sin
        normal_sin = frame.place.rail_cos * normal_sin + frame.place.rail_sin * down
    force_y = normal_sin * load
    force_z = -normal_cos * load
    patch.normal_y += force_y
    patch.normal_z += force_z
    patch.normal_moment[0] += y * force_z - z * force_y
    patch.normal_moment[1] -= x * force_z
    patch.normal_moment[2] += x * force_y
    wheel_height, wheel_slope = height_slope(pair.wheel, region.wheel)
    wheel_height, wheel_slope = height_slope(
        pair.wheel, region.wheel + away / sqrt(1.0 + wheel_slope * wheel_slope)
    )
    patch.x_track += load * x
    patch.y_track += load * y
    patch.z_track += load * z
    patch.rolling_radius += load * (pair.radius + wheel_height)


def abscissa_at(pair: Pair, frame: Frame, region: Region, away: float):
    """The rail's abscissa [m] at stations ``away`` from a region's smallest gap [m]: stations of a wheel that
    just touches are those of its contact plane, all others run along the rail."""
    abscissa = region.rail + away * frame.plane.cos
    if frame.pressed and away != 0.0:
        abscissa = abscissa_after(pair, rail_way(pair, region.rail) + away)
    return abscissa


def close_place(patch: Patch):
    """The centre of load of a patch [m], and the angle of its force [rad]."""
    load = patch.totals.load
    if load > 0.0:
        patch.x_track /= load
        patch.y_track /= load
        patch.z_track /= load
        patch.rolling_radius /= load
        slope = patch.normal_y / -patch.normal_z
        patch.contact_angle = -atan(slope)
        patch.angle_cos = 1.0 / sqrt(1.0 + slope * slope)
        patch.angle_sin = -slope * patch.angle_cos


def place_strips(pair: Pair, contact: Contact, patch: Patch):
    """Where the strips of a patch are in the track, the rail's inclination, and the wheel's rolling radius
    there.  Wheel and rail lie on each other: from the point of the patch's first region on, both abscissae
    run alike."""
    number = 0
    while number < REGION_LIMIT - 1 and patch.loads[number] == 0.0:
        number += 1
    region = contact.regions[number]
    place = contact.frame.place
    for index in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[index]
        abscissa = abscissa_at(pair, contact.frame, region, strip.station - region.offset - region.station)
        height, slope = height_slope(pair.rail, abscissa)
        strip.cos = 1.0 / sqrt(1.0 + slope * slope)
        strip.sin = slope * strip.cos
        y, z = on_track(place, pair.rail_y, pair.rail_y + abscissa, height)
        strip.y_track = y
        strip.z_track = z
        height, slope = height_slope(pair.wheel, region.wheel + abscissa - region.rail)
        strip.rolling_radius = pair.radius + height
    if place.leaning:
        for index in range(ROLLING_STRIP_LIMIT):
            strip = patch.strips[index]
            down = strip.cos
            strip.cos = place.rail_cos * down - place.rail_sin * strip.sin
            strip.sin = place.rail_cos * strip.sin + place.rail_sin * down
