"""Creep forces of a pressed wheel: its patches roll with the pressures that the half-space has found.

Patches are cut into strips as those of the kernel's models are.  Either a model of the kernel finds their
creep forces, or the complete theory does (wrcontact/halfspace/rolling), with the pressures of the cells.
"""

import ctypes
import math
from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from ..kernel import layout
from ..kernel.binding.library import default_kernel
from ..kernel.creep.creepage import move_strip
from ..kernel.creep.rolling_strips import divide_into_strips
from ..kernel.normal.wear_places import nearest_patch
from .edge import EDGE_PAD, edge_field, extent
from .outputs import split_patches
from .pressed_wheel import PressedWheel
from .rolling.contact import rolling_contact
from .rolling.extrapolation import COARSE_CELLS, extrapolated
from .rolling.pressure import PressureField
from .rolling_step import friction_of, roll_patch_forwards, roll_strips

#: A patch with fewer cells than this in either direction rolls as an outline of strips instead: the edge
#: within its cells is not known well.
LEAST_CELLS = 12
#: Points of each cell, each way, at which its pressure is taken.
POINTS = 8


@dataclass(frozen=True)
class SolvedSide:
    """A pressed wheel of a wheelset.

    Attributes
    ----------
    wheel : its stations are counted from the contact point.
    moved : displacement of the rail to the field side and down [m].
    """

    wheel: PressedWheel
    moved: np.ndarray

    def set_place(self, strip, x, station):
        """Write where x, ``station`` [m] is into a strip, record RollingStrip: track coordinates, inclination
        of the normal, and the wheel's rolling radius; in the frame of a right wheel."""
        surfaces = self.wheel.surfaces
        place = surfaces.place(x, station)
        angle = float(surfaces.curve.at("angle", station))
        strip.y_track, strip.z_track = place[1:] + self.moved
        strip.cos, strip.sin = math.cos(angle), -math.sin(angle)
        strip.rolling_radius = surfaces.pair.lowered(surfaces.at).rolling_radius(place)

    def profile_places(self, x, station):
        """Abscissae of the wheel's and of the rail's profile at x, ``station`` [m]."""
        surfaces = self.wheel.surfaces
        lowered = surfaces.pair.lowered(surfaces.at)
        return (
            lowered.abscissa(surfaces.place(x, station)),
            float(surfaces.curve.at("rail_y", station)) - surfaces.pair.rail_y,
        )

    def slips(self, motion, speed, x, station):
        """Creepages [1] and spin [1/m] (3,) at x, ``station`` [m], with the rolling ``speed`` [m/s]."""
        strip = layout.RollingStrip()
        self.set_place(strip, x, station)
        move_strip(motion, strip, x, 1.0 / speed)
        return strip.slip, strip.lateral, strip.spin


def cut_patches(side, record, strips):
    """Cut the patches of a side, record SideSearch, which lie on ``strips``, record SolvedStrips, along the
    rolling direction; ``side`` is its :class:`SolvedSide`."""
    for patch in record.patches[: record.patch_count]:
        divide_into_strips(patch, strips)
        nodes = [strips[k] for k in range(patch.first, patch.last + 1)]
        station, x = np.array([(node.station, node.x) for node in nodes]).T
        for strip in patch.strips:
            middle = float(np.interp(strip.station, station, x))
            strip.x = middle - patch.x
            side.set_place(strip, middle, strip.station)


def place_wear(side, record, stations):
    """The places of so many ``stations`` of a side, record SideSearch, on both profiles, and the patch that
    each belongs to, and the places of its strips; ``side`` is its :class:`SolvedSide`."""
    nearest = 0
    for j in range(stations):
        station = record.outline.numbers[j]
        nearest = nearest_patch(record, nearest, station)
        x = float(side.wheel.surfaces.curve.at("x", station))
        for run, value in zip((0, 1, 3), (*side.profile_places(x, station), record.patches[nearest].rank)):
            record.wear.numbers[run * stations + j] = value
    for patch, worn in zip(record.patches[: record.patch_count], record.worn):
        for i, strip in enumerate(patch.strips):
            worn.wheel_place[i], worn.rail_place[i] = side.profile_places(patch.x + strip.x, strip.station)


class KernelRolling:
    """Creep forces of pressed wheels by the kernel's model.

    Parameters
    ----------
    tables : of the kernel.
    workspace : whose patch by itself is used.
    """

    def __init__(self, tables, workspace):
        self._tables, self._workspace = tables, workspace

    def __call__(self, side, index, patch, motion):
        work = layout.Work.at(self._workspace)
        work.patch = patch
        default_kernel().solve_creep_force(self._tables, self._workspace)
        ctypes.pointer(patch)[0] = work.patch


class CompleteRolling:
    """Creep forces of pressed wheels by the complete theory.

    Parameters
    ----------
    shear_modulus, poisson_ratio : of wheel and rail [Pa], [1].
    """

    def __init__(self, shear_modulus, poisson_ratio):
        self._material = {"shear_modulus": shear_modulus, "poisson_ratio": poisson_ratio}

    def __call__(self, side, index, patch, motion):
        fields = patch_fields(side, patch)
        if fields is None:
            roll_strips(patch, **self._material)
            return
        slips = [row_slips(motion, side, patch, field) for field in fields]
        roll_patch_forwards(patch, lambda: roll_fields(patch, fields, slips, **self._material))


def patch_fields(side, patch):
    """Pressures of a ``patch`` of a :class:`SolvedSide` on 24 and on 48 cells each way that just hold it,
    about its centre of load: two :class:`~wrcontact.halfspace.rolling.pressure.PressureField`; None where the
    cells of its normal contact are few, or not even.

    Squares of pressures follow straight lines between the cells, to zero at the edge found within them.
    """
    contact = side.wheel.contact
    pressure = split_patches(contact)[patch.rank - 1]
    loaded = [np.flatnonzero(pressure.any(axis=axis)) for axis in (1, 0)]
    if min(len(places) for places in loaded) < LEAST_CELLS:
        return None
    middles = [each[places[0] : places[-1] + 1] for each, places in zip((contact.x, contact.s), loaded)]
    if any(np.ptp(np.diff(each)) > 1e-6 * (each[1] - each[0]) for each in middles):
        return None
    edge = edge_field(pressure[np.ix_(*(np.arange(places[0], places[-1] + 1) for places in loaded))])
    origin = patch.x, patch.totals.centroid
    return [
        sampled(edge, [each - start for each, start in zip(middles, origin)], cells)
        for cells in (COARSE_CELLS, 2 * COARSE_CELLS)
    ]


def sampled(edge, middles, cells):
    """A :class:`~wrcontact.halfspace.rolling.pressure.PressureField` of so many ``cells`` each way that just
    holds a patch, from its :func:`~wrcontact.halfspace.edge.edge_field` and the ``middles`` of the cells that
    this is made from, along x and across [m]."""
    places, found = [], []
    for one, field in zip(middles, (edge.T, edge)):
        low, high = extent(field)
        size = (high - low) / cells
        places.append(EDGE_PAD + low + size / POINTS * (np.arange(cells * POINTS) + 0.5))
        found.append(one[0] + (one[1] - one[0]) * (low + size * (np.arange(cells) + 0.5)))
    square = ndimage.map_coordinates(edge, np.meshgrid(*places, indexing="ij"), order=1).T
    shares = [np.sqrt(np.maximum(square, 0.0)), (square > 0.0).astype(float)]
    return PressureField(
        *found, *(each.reshape(cells, POINTS, cells, POINTS).mean(axis=(1, 3)) for each in shares)
    )


def row_slips(motion, side, patch, field):
    """Creepages, those of spin left out, and spin of each row of a ``field`` about the centre of load, with
    the rolling radius and the normal of its own place, (3, ny); reduced as the other creepages of the patch
    are on wet rails."""
    load = field.pressure.sum(axis=1)
    x = np.divide(field.pressure @ field.x, load, out=np.zeros(len(load)), where=load > 0.0)
    along, across, spin = np.transpose(
        [
            side.slips(motion, patch.speed, patch.x + ahead, patch.totals.centroid + y)
            for ahead, y in zip(x, field.y)
        ]
    )
    strips = np.array(
        [
            (side.slips(motion, patch.speed, patch.x + strip.x, strip.station)[0], strip.slip)
            for strip in patch.strips
        ]
    )
    whole, reduced = np.abs(strips).sum(axis=0)
    factor = reduced / whole if whole > 0.0 else 1.0
    return factor * np.array([along, across - spin * x, spin])


def roll_fields(patch, fields, slips, **material):
    """:class:`~wrcontact.halfspace.rolling.extrapolation.RollingForces` of a patch that rolls forwards, on
    the pressures of a coarse and a fine grid with the ``slips`` of their rows."""
    found, solution = [], None
    for field, slip in zip(fields, slips):
        if patch.backwards:
            field = PressureField(-field.x[::-1], field.y, field.pressure[:, ::-1], field.cover[:, ::-1])
            slip = slip * [[-1.0], [1.0], [-1.0]]
        along, across, spin = slip
        solution = rolling_contact(
            field.scaled(patch.totals.load),
            creepage_x=along + spin * field.y,
            creepage_y=across,
            spin=spin,
            start=solution,
            **friction_of(patch),
            **material,
        )
        found.append(solution)
    return extrapolated(*found)
