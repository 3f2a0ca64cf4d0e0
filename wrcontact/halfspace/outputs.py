"""A pressed wheel as patches of the kernel, and its resultant."""

import math

import numpy as np
from scipy import ndimage

from ..kernel import layout
from .edge import chords, edge_area, edge_field, extent, peak_pressure

#: Components of the loaded cells with less than this share of the load are no patches.
STRAY_SHARE = 1e-6


def fill_side(side, strips, wheel, moved, stations):
    """Fill the patches of a side of the kernel's workspace, and the outline at so many ``stations``, from its
    :class:`PressedWheel`.

    Parameters
    ----------
    side : record SideSearch, in the frame of a right wheel.
    strips : record SolvedStrips, where the strips of its patches are kept.
    wheel : its stations are counted from the contact point.
    moved : displacement of the rail to the field side and down [m].

    A strip is a column of loaded cells.  What the half-space does not know is not a number: the curvature of
    the strips, and the wheel's abscissa and the slant of a patch.
    """
    contact = wheel.contact
    lengths, low, high = extents(contact)
    line = contact.pressure.sum(axis=0)
    fill_totals(
        side.totals,
        contact.force,
        contact.area,
        line @ contact.s / line.sum(),
        contact.max_pressure,
        lengths.max(),
        (low, high),
        high - low,
    )
    pressures = split_patches(contact)[: layout.SOLVED_PATCH_LIMIT]
    found = [describe_patch(wheel, pressure, moved) for pressure in pressures]
    side.patch_count = len(found)
    origin = np.array([0.0, *-moved])
    forces = [resultant(wheel, origin, pressure) for pressure in pressures]
    # what strays carry counts for the heaviest patch
    forces[0] += resultant(wheel, origin) - sum(forces)
    for rank, ((patch, _), force) in enumerate(zip(found, forces), 1):
        patch.rank = rank
        fill_force(patch, force)
    first = 0
    for index, (patch, columns) in enumerate(sorted(found, key=lambda pair: pair[0].totals.start)):
        columns = columns[: layout.SOLVED_STRIP_LIMIT - first]
        patch.first, patch.last = first, first + len(columns) - 1
        np.ctypeslib.as_array(strips)[first : first + len(columns)] = columns
        side.patches[index] = patch
        first += len(columns)
    numbers = np.ctypeslib.as_array(side.outline.numbers)[: layout.RUN_COUNT * stations]
    write_outline(numbers.reshape(layout.RUN_COUNT, stations), contact, lengths, low, high)


def extents(contact):
    """Loaded length of each column (m,), first and last loaded station of all patches together [m]."""
    edge = edge_field(contact.pressure)
    low, high = (_station(contact, place) for place in extent(edge))
    return chords(edge) * (contact.x[1] - contact.x[0]), low, high


def describe_patch(wheel, pressure, moved):
    """The record Patch of the patch with these pressures (n, m), and its strips, an array of the record
    SolvedStrip."""
    patch = layout.Patch()
    contact, surfaces = wheel.contact, wheel.surfaces
    dx, ds = contact.x[1] - contact.x[0], contact.s[1] - contact.s[0]
    edge, line = edge_field(pressure), pressure.sum(axis=0)
    low, high = extent(edge)
    lengths = chords(edge) * dx
    centroid = float(line @ contact.s / line.sum())
    fill_totals(
        patch.totals,
        line.sum() * dx * ds,
        edge_area(edge) * dx * ds,
        centroid,
        peak_pressure(pressure),
        lengths.max(),
        (_station(contact, low), _station(contact, high)),
        (high - low) * ds,
    )
    patch.station, patch.x = centroid, pressure.sum(axis=1) @ contact.x / pressure.sum()
    patch.rail = float(surfaces.curve.at("rail_y", centroid)) - surfaces.pair.rail_y
    patch.wheel = patch.slant = math.nan
    patch.rule = layout.RULE_STRAIGHT
    loaded = np.flatnonzero(line > 0.0)
    patch.penetration = surfaces.overlap(contact.s[loaded]).max()
    place = surfaces.place(patch.x, patch.station)
    patch.x_track, patch.y_track, patch.z_track = place[0], place[1] + moved[0], place[2] + moved[1]
    patch.rolling_radius = surfaces.pair.lowered(surfaces.at).rolling_radius(place)
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


def fill_force(patch, total):
    """The force on the wheel of a patch and its angle, from force and moment (6,)."""
    patch.normal_y, patch.normal_z = total[1:3]
    patch.normal_moment[:] = total[3:]
    patch.contact_angle = math.atan2(-total[1], -total[2])
    patch.angle_sin, patch.angle_cos = math.sin(patch.contact_angle), math.cos(patch.contact_angle)


def resultant(wheel, centre, pressure=None):
    """Force on a right wheel [N] and its moment about ``centre`` (3,) in the track frame [N m], (6,), of all
    pressures or of ``pressure`` (n, m): each column acts along its own normal."""
    contact, curve = wheel.contact, wheel.surfaces.curve
    pressure = contact.pressure if pressure is None else pressure
    cell = (contact.x[1] - contact.x[0]) * (contact.s[1] - contact.s[0])
    loads, levers = pressure.sum(axis=0) * cell, contact.x @ pressure * cell
    y, z = curve.at("y", contact.s) - centre[1], curve.at("z", contact.s) - centre[2]
    along, down = -np.sin(contact.angle), -np.cos(contact.angle)
    levers = levers - centre[0] * loads
    return np.array(
        [0.0, loads @ along, loads @ down, loads @ (y * down - z * along), -levers @ down, levers @ along]
    )
