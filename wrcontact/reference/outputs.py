"""A half-space contact as the outputs of a wheel, and its resultant."""

import math

import numpy as np
from scipy import ndimage

from ..kernel import layout
from .edge import chords, edge_area, edge_field, extent, peak_pressure

#: Components of the loaded cells with less than this share of the load are no patches.
STRAY_SHARE = 1e-6
#: The mirror of a force and of a moment, which is an axial vector.
MIRRORED_RESULTANT = np.array([1.0, -1.0, 1.0, -1.0, 1.0, -1.0])


def write_side(side, plane, contact, outline=None):
    """Normal contact of one wheel into its outputs (134,): totals, patches by falling load; and into ``outline``
    (3, stations), if that is wanted."""
    dx = contact.x[1] - contact.x[0]
    patches = split_patches(contact)
    line = contact.pressure.sum(axis=0)
    edge = edge_field(contact.pressure)
    lengths, (low, high) = chords(edge) * dx, extent(edge)
    side[layout.SIDE_PATCH_COUNT] = len(patches)
    side[layout.SIDE_PENETRATION] = contact.penetration
    side[layout.SIDE_NORMAL_FORCE] = contact.force
    side[layout.SIDE_AREA] = contact.area
    side[layout.SIDE_MAX_PRESSURE] = contact.max_pressure
    side[layout.SIDE_PATCH_LENGTH] = lengths.max()
    low, high = (_station(contact, place) for place in (low, high))
    side[layout.SIDE_PATCH_WIDTH] = high - low
    side[layout.SIDE_PATCH_CENTROID] = line @ contact.s / line.sum()
    for number, pressure in enumerate(patches[:layout.PATCH_LIMIT]):
        start = layout.SIDE_PATCH + number * layout.PATCH_SIZE
        write_patch(side[start:start + layout.PATCH_SIZE], plane, contact, pressure)
    if outline is not None:
        write_outline(outline, contact, lengths, low, high)


def split_patches(contact):
    """Pressures (n, m) of each connected run of loaded cells, corners included, by falling load."""
    labels, count = ndimage.label(contact.pressure > 0.0, np.ones((3, 3)))
    loads = ndimage.sum_labels(contact.pressure, labels, np.arange(1, count + 1))
    ranked = [int(k) + 1 for k in np.argsort(-loads, kind="stable") if loads[k] >= STRAY_SHARE * loads.sum()]
    return [np.where(labels == number, contact.pressure, 0.0) for number in ranked]


def write_patch(patch, plane, contact, pressure):
    """One patch into its outputs (7,); its contact angle is the rail's at its centroid."""
    dx, ds = contact.x[1] - contact.x[0], contact.s[1] - contact.s[0]
    edge, line = edge_field(pressure), pressure.sum(axis=0)
    low, high = extent(edge)
    centroid = float(line @ contact.s / line.sum())
    patch[layout.PATCH_NORMAL_FORCE] = line.sum() * dx * ds
    patch[layout.PATCH_AREA] = edge_area(edge) * dx * ds
    patch[layout.PATCH_MAX_PRESSURE] = peak_pressure(pressure)
    patch[layout.PATCH_LENGTH] = chords(edge).max() * dx
    patch[layout.PATCH_WIDTH] = (high - low) * ds
    patch[layout.PATCH_CENTROID] = centroid
    patch[layout.PATCH_CONTACT_ANGLE] = plane.rail_angle(centroid)


def write_outline(outline, contact, lengths, low, high):
    """Stations from ``low`` to ``high`` [m], half the loaded length and the largest pressure there, into ``outline``."""
    station = np.linspace(low, high, outline.shape[1])
    # both are roots at the ends of a Hertzian patch: their squares are straight there
    half = np.sqrt(np.interp(station, contact.s, (0.5 * lengths) ** 2))
    pressure = np.sqrt(np.interp(station, contact.s, contact.pressure.max(axis=0) ** 2))
    half[[0, -1]] = pressure[[0, -1]] = 0.0
    outline[:] = station, half, pressure


def _station(contact, place):
    """s [m] at ``place``, counted in cells: columns of grids far from each other follow with a jump."""
    ds, near = contact.s[1] - contact.s[0], min(max(round(place), 0), len(contact.s) - 1)
    return contact.s[near] + (place - near) * ds


def resultant(plane, contact, index):
    """Force on the wheel of side ``index`` [N] and its moment about the wheelset's centre [N m], (6,) in the track's axes.

    Each patch pushes along the normal of the rail at its centre of load, which is the mean normal of its pressure.
    """
    total = np.zeros(6)
    for pressure in split_patches(contact):
        load = pressure.sum() * (contact.x[1] - contact.x[0]) * (contact.s[1] - contact.s[0])
        x, s = pressure.sum(axis=1) @ contact.x / pressure.sum(), pressure.sum(axis=0) @ contact.s / pressure.sum()
        height, angle = plane.rail_height(np.array([s]))[0], plane.rail_angle(s)
        place = plane.origin - plane.centre + [x, 0.0, 0.0] + s * plane.lateral + height * plane.normal
        force = load * np.array([0.0, -math.sin(angle), -math.cos(angle)])
        total += np.concatenate([force, np.cross(place, force)])
    return total if index == 1 else total * MIRRORED_RESULTANT
