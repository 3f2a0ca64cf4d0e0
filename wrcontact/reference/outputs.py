"""A pressed wheel as solved patches, its outputs, and its resultant."""

import math

import numpy as np
from scipy import ndimage

from ..kernel import layout
from ..kernel.patch.totals import write_patches
from .edge import chords, edge_area, edge_field, extent, peak_pressure

#: Components of the loaded cells with less than this share of the load are no patches.
STRAY_SHARE = 1e-6


def write_side(side, wheel, index, centre, outline=None):
    """Normal contact of the :class:`PressedWheel` of side ``index`` into its outputs: totals, patches by
    falling load, force and moment about the wheelset's ``centre`` (3,) in the frame of a right wheel, without
    friction; and into ``outline`` (5, stations), if that is wanted.  The solved patches, and force and moment
    (6,)."""
    contact = wheel.contact
    lengths, low, high = extents(contact)
    mirror = 2.0 * index - 1.0
    solved = solved_patches(wheel, mirror)
    record = layout.SideOutputs.at(side)
    write_patches(solved, record)
    if outline is not None:
        write_outline(outline, contact, lengths, low, high)
    total = resultant(wheel, centre) * [1.0, mirror, 1.0, mirror, 1.0, mirror]
    record.force[:] = record.normal_part[:] = total[:3]
    record.moment[:] = record.normal_moment[:] = total[3:]
    return solved, total


def extents(contact):
    """Loaded length of each column (m,), first and last loaded station of all patches together [m]."""
    edge = edge_field(contact.pressure)
    low, high = (_station(contact, place) for place in extent(edge))
    return chords(edge) * (contact.x[1] - contact.x[0]), low, high


def solved_patches(wheel, mirror=1.0):
    """The record that the kernel's models fill too, :class:`~wrcontact.kernel.layout.SolvedPatches`;
    ``mirror`` is -1 for a left wheel, whose forces are the mirrored ones.

    A strip is a column of loaded cells.  What the half-space does not know is not a number: the curvature of
    the strips, and the wheel's abscissa and the slant of a patch.
    """
    contact = wheel.contact
    solved = layout.SolvedPatches()
    found = [describe_patch(layout.SolvedPatch(), wheel, pressure, mirror)
             for pressure in split_patches(contact)[:layout.SOLVED_PATCH_LIMIT]]
    solved.count = len(found)
    lengths, low, high = extents(contact)
    line = contact.pressure.sum(axis=0)
    fill_totals(solved.totals, contact.force, contact.area, line @ contact.s / line.sum(),
                contact.max_pressure, lengths.max(), (low, high), high - low)
    for rank, (patch, _) in enumerate(found, 1):
        patch.rank = rank
    first = 0
    for index, (patch, strips) in enumerate(sorted(found, key=lambda pair: pair[0].totals.start)):
        strips = strips[:layout.SOLVED_STRIP_LIMIT - first]
        patch.first, patch.last = first, first + len(strips) - 1
        np.ctypeslib.as_array(solved.strips)[first:first + len(strips)] = strips
        solved.patches[index] = patch
        first += len(strips)
    return solved


def describe_patch(patch, wheel, pressure, mirror):
    """The record ``patch`` of the patch with these pressures (n, m), and its strips, an array of the record
    SolvedStrip."""
    contact, surfaces = wheel.contact, wheel.surfaces
    dx, ds = contact.x[1] - contact.x[0], contact.s[1] - contact.s[0]
    edge, line = edge_field(pressure), pressure.sum(axis=0)
    low, high = extent(edge)
    lengths = chords(edge) * dx
    centroid = float(line @ contact.s / line.sum())
    fill_totals(patch.totals, line.sum() * dx * ds, edge_area(edge) * dx * ds, centroid,
                peak_pressure(pressure), lengths.max(), (_station(contact, low), _station(contact, high)),
                (high - low) * ds)
    patch.station, patch.x = centroid, pressure.sum(axis=1) @ contact.x / pressure.sum()
    patch.rail = float(surfaces.curve.at("rail_y", centroid)) - surfaces.pair.rail_y
    patch.wheel = patch.slant = math.nan
    patch.rule = layout.RULE_STRAIGHT
    loaded = np.flatnonzero(line > 0.0)
    patch.local_penetration = surfaces.overlap(contact.s[loaded]).max()
    fill_force(patch, wheel, line * dx * ds, mirror)
    strips = np.zeros(len(loaded), layout.SolvedStrip)
    strips["station"], strips["width"] = contact.s[loaded], ds
    strips["x"] = contact.x @ pressure[:, loaded] / line[loaded]
    strips["curvature"] = math.nan
    strips["line_load"] = line[loaded] * dx
    strips["half_length_square"] = (0.5 * lengths[loaded]) ** 2
    strips["pressure_square"] = pressure[:, loaded].max(axis=0) ** 2
    return patch, strips


def fill_totals(totals, load, area, centroid, max_pressure, length, edges, width):
    """The record PatchTotals, in N, m and Pa."""
    totals.load, totals.area, totals.centroid, totals.moment = load, area, centroid, load * centroid
    totals.max_pressure, totals.max_half_length = max_pressure, 0.5 * length
    (totals.start, totals.stop), totals.width = edges, width


def split_patches(contact):
    """Pressures (n, m) of each connected run of loaded cells, corners included, by falling load."""
    labels, count = ndimage.label(contact.pressure > 0.0, np.ones((3, 3)))
    loads = ndimage.sum_labels(contact.pressure, labels, np.arange(1, count + 1))
    ranked = [int(k) + 1 for k in np.argsort(-loads, kind="stable") if loads[k] >= STRAY_SHARE * loads.sum()]
    return [np.where(labels == number, contact.pressure, 0.0) for number in ranked]


def write_outline(outline, contact, lengths, low, high):
    """Stations from ``low`` to ``high`` [m], half the loaded length and the largest pressure there, into
    ``outline``, and neither shear nor slip."""
    station = np.linspace(low, high, outline.shape[1])
    # both are roots at the ends of a Hertzian patch: their squares are straight there
    half = np.sqrt(np.interp(station, contact.s, (0.5 * lengths) ** 2))
    pressure = np.sqrt(np.interp(station, contact.s, contact.pressure.max(axis=0) ** 2))
    half[[0, -1]] = pressure[[0, -1]] = 0.0
    outline[:3] = station, half, pressure
    outline[3:] = 0.0


def _station(contact, place):
    """s [m] at ``place``, counted in cells: columns of grids far from each other follow with a jump."""
    ds, near = contact.s[1] - contact.s[0], min(max(round(place), 0), len(contact.s) - 1)
    return contact.s[near] + (place - near) * ds


def fill_force(patch, wheel, loads, mirror):
    """The force on the wheel of a patch, the sum of the ``loads`` (m,) [N] of its columns along their
    normals, its angle, and its centre of load."""
    surfaces, angle = wheel.surfaces, wheel.contact.angle
    across, down = -loads @ np.sin(angle), -loads @ np.cos(angle)
    force = patch.force
    force.y, force.z = mirror * across, down
    patch.contact_angle = math.atan2(-across, -down)
    patch.cos, patch.sin = math.cos(patch.contact_angle), -math.sin(patch.contact_angle)
    place = surfaces.place(patch.x, patch.station)
    force.x_track, force.y_track, force.z_track = place[0], mirror * place[1], place[2]
    force.rolling_radius = surfaces.pair.lowered(surfaces.at).rolling_radius(place)


def resultant(wheel, centre):
    """Force on a right wheel [N] and its moment about ``centre`` (3,) in the track frame [N m], (6,): each
    column of pressures acts along its own normal."""
    contact, curve = wheel.contact, wheel.surfaces.curve
    cell = (contact.x[1] - contact.x[0]) * (contact.s[1] - contact.s[0])
    loads, levers = contact.pressure.sum(axis=0) * cell, contact.x @ contact.pressure * cell
    y, z = curve.at("y", contact.s) - centre[1], curve.at("z", contact.s) - centre[2]
    along, down = -np.sin(contact.angle), -np.cos(contact.angle)
    levers = levers - centre[0] * loads
    return np.array([0.0, loads @ along, loads @ down,
                     loads @ (y * down - z * along), -levers @ down, levers @ along])
