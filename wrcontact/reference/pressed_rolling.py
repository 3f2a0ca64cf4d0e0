"""Creep forces of a pressed wheel: its patches roll with the pressures that the half-space has found.

Patches are cut into strips as those of the kernel's models are.  Either a model of the kernel finds their creep
forces, or the complete theory does (wrcontact/reference/rolling), on the cells of the normal contact.
"""

from dataclasses import dataclass

import numpy as np

from ..kernel import layout
from ..kernel.binding.library import default_kernel
from ..kernel.motion.creepage import STANDSTILL, patch_speed, rolling_velocity, velocity_along
from ..kernel.tangential.sections import cut_patch
from ..kernel.wheelset.creep_forces import open_rolling, write_side_wear
from .outputs import split_patches
from .pressed_wheel import PressedWheel
from .rolling.contact import rolling_contact
from .rolling.extrapolation import extrapolated
from .rolling.pressure import PressureField
from .rolling_step import roll_patch_forwards, roll_strips, write_force

#: A patch with fewer cells than this in either direction rolls as an outline of strips instead: half as many
#: cells would not show its edge.
LEAST_CELLS = 20
#: As many are enough in either direction: the error that is left behind the extrapolation is below 0.2 % of the
#: friction limit with 48 (docs/rolling.md).
MOST_CELLS = 60


@dataclass(frozen=True)
class SolvedSide:
    """A pressed wheel of a wheelset.

    Attributes
    ----------
    wheel : its stations are counted from the contact point.
    solved : the record :class:`~wrcontact.kernel.layout.SolvedPatches` of its patches.
    mirror : 1 on the right, -1 on the left.
    moved : displacement of the rail to the right and down [m].
    """

    wheel: PressedWheel
    solved: layout.SolvedPatches
    mirror: float
    moved: np.ndarray

    def place(self, x, station):
        """Track coordinates y, z [m] of the place x, ``station`` [m], and the wheel's rolling radius there
        [m]."""
        surfaces = self.wheel.surfaces
        place = surfaces.place(x, station)
        radius = surfaces.pair.lowered(surfaces.at).rolling_radius(place)
        return self.mirror * place[1] + self.moved[0], place[2] + self.moved[1], radius

    def slip(self, motion, speed, x, station):
        """Longitudinal creepage [1] at x, ``station`` [m], with the rolling ``speed`` [m/s]."""
        y, z, radius = self.place(x, station)
        y, z = y - motion.centre_y, z - motion.centre_z
        return velocity_along(motion, y, z, rolling_velocity(motion, x, y, z, radius)[0]) / speed


def write_pressed_creep(tables, work, side, find):
    """Creep forces of the patches of a pressed wheel, whose creepages are known, into the outputs in the
    workspace, as :func:`~wrcontact.kernel.wheelset.creep_forces.write_side_creep` does.

    Parameters
    ----------
    tables, work : records of the kernel.
    side : :class:`SolvedSide`.
    find : called with the side, the number of a patch by falling load and its
        :class:`~wrcontact.kernel.layout.RollingPatch`, into which it writes what it finds.
    """
    index = 0 if side.mirror < 0.0 else 1
    rolling, outputs = work.rolling_sides[index], work.outputs.left[index]
    cut_patches(side, rolling)
    friction = work.inputs.left_friction if index == 0 else work.inputs.right_friction
    for number in range(rolling.count):
        patch, to = rolling.patches[number], outputs.patch[number]
        if patch_speed(work.motion, to) > STANDSTILL:
            open_rolling(tables, work.motion, patch, to, side.mirror, friction)
            find(side, number, patch)
            write_force(work, index, patch, to)
    write_side_wear(tables, work, index)


def cut_patches(side, rolling):
    """Cut the heaviest patches into the strips of ``rolling``, a
    :class:`~wrcontact.kernel.layout.RollingSide`."""
    rolling.count = min(side.solved.count, layout.PATCH_LIMIT)
    for index in range(side.solved.count):
        solved = side.solved.patches[index]
        if solved.rank <= layout.PATCH_LIMIT:
            patch = rolling.patches[solved.rank - 1]
            cut_patch(side.solved, index, patch)
            nodes = [side.solved.strips[k] for k in range(solved.first, solved.last + 1)]
            station, x = np.array([(node.station, node.x) for node in nodes]).T
            for strip in patch.strips[:patch.count]:
                middle = float(np.interp(strip.station, station, x))
                strip.x = middle - solved.x
                strip.y_track, strip.z_track, strip.rolling_radius = side.place(middle, strip.station)


class KernelRolling:
    """Creep forces of pressed wheels by the kernel's model.

    Parameters
    ----------
    sides : tables of the left and the right side.
    workspace : whose patch by itself is used.
    """

    def __init__(self, sides, workspace):
        self._sides, self._workspace = sides, workspace

    def __call__(self, side, number, patch):
        work = layout.Work.at(self._workspace)
        work.rolling = patch
        default_kernel().solve_tangential(self._sides[0 if side.mirror < 0.0 else 1], self._workspace)
        found = layout.RollingPatch.from_buffer_copy(work.rolling)
        for name in ("force_x", "force_y", "moment", "stick_share", "max_shear", "strips"):
            setattr(patch, name, getattr(found, name))


class CompleteRolling:
    """Creep forces of pressed wheels by the complete theory.

    Parameters
    ----------
    workspace : with the motion.
    shear_modulus, poisson_ratio : of wheel and rail [Pa], [1].
    """

    def __init__(self, workspace, shear_modulus, poisson_ratio):
        self._workspace = workspace
        self._material = {"shear_modulus": shear_modulus, "poisson_ratio": poisson_ratio}

    def __call__(self, side, number, patch):
        cells = cells_of_patch(side.wheel.contact, number)
        if cells is None:
            roll_strips(patch, **self._material)
            return
        slip = row_slips(layout.Work.at(self._workspace).motion, side, number, patch, cells)
        roll_patch_forwards(patch, lambda: roll_cells(patch, cells, slip, **self._material))


def cells_of_patch(contact, number):
    """Pressures of the patch ``number`` by falling load, in track coordinates x and stations, on an even number
    of cells each way, at most MOST_CELLS and one; None where they are few, or not even.  Small cells of the
    normal contact are joined to larger ones."""
    pressure = split_patches(contact)[number]
    rows, columns = (_joining(middles, loaded) for middles, loaded in
                     ((contact.s, pressure.any(axis=0)), (contact.x, pressure.any(axis=1))))
    if rows is None or columns is None:
        return None
    (at, y, per_row), (along, x, per_column) = rows, columns
    padded = np.zeros((len(y) * per_row, len(x) * per_column))
    loaded = pressure[along, at].T
    padded[:loaded.shape[0], :loaded.shape[1]] = loaded
    share = (padded > 0.0).astype(float)
    return PressureField(x, y, *(joined(each, per_row, per_column) for each in (padded, share)))


def _joining(middles, loaded):
    """Slice of the loaded cells of one direction, middles of the joined ones [m], and how many each joins."""
    places = np.flatnonzero(loaded)
    first, count = places[0], places[-1] - places[0] + 1
    steps = np.diff(middles[first:first + count])
    if count < LEAST_CELLS or np.ptp(steps) > 1e-6 * steps[0]:
        return None
    size = -(-count // MOST_CELLS)
    pairs = -(-count // (2 * size))
    start = middles[first] + 0.5 * (size - 1) * steps[0]
    return slice(first, first + count), start + size * steps[0] * np.arange(2 * pairs), size


def joined(values, rows, columns):
    """Means of ``values`` over blocks of so many rows and columns, which divide its shape."""
    height, width = values.shape
    return values.reshape(height // rows, rows, width // columns, columns).mean(axis=(1, 3))


def row_slips(motion, side, number, patch, cells):
    """Longitudinal creepage of each row of ``cells``, whose rolling radius is its own, (ny,); reduced as the
    other creepages of the patch are on wet rails."""
    load = cells.pressure.sum(axis=1)
    centre = float(cells.pressure.sum(axis=0) @ cells.x / load.sum())
    x = np.divide(cells.pressure @ cells.x, load, out=np.full(len(load), centre), where=load > 0.0)
    slip = np.array([side.slip(motion, patch.speed, *place) for place in zip(x, cells.y)])
    strips = np.array([(strip.station, side.slip(motion, patch.speed, centre + strip.x, strip.station),
                        strip.slip) for strip in patch.strips])
    return slip * np.abs(strips[:, 2]).sum() / np.abs(strips[:, 1]).sum()


def roll_cells(patch, cells, slip, **material):
    """:class:`~wrcontact.reference.rolling.extrapolation.RollingForces` of a patch that rolls forwards, on its
    cells and on half as many each way, about its centre of load."""
    load = cells.pressure.sum()
    x, y = (middles - cells.pressure.sum(axis=axis) @ middles / load
            for axis, middles in enumerate((cells.x, cells.y)))
    pressure, cover = cells.pressure, cells.cover
    if patch.backwards:
        x, pressure, cover, slip = -x[::-1], pressure[:, ::-1], cover[:, ::-1], -slip
    fine = PressureField(x, y, pressure, cover).scaled(patch.load)
    along = slip + patch.spin * y
    motion = {"creepage_y": patch.creepage_y, "spin": patch.spin, "friction": patch.friction, **material}
    coarse = rolling_contact(halved(fine), creepage_x=along.reshape(-1, 2).mean(axis=1), **motion)
    return extrapolated(coarse, rolling_contact(fine, creepage_x=along, start=coarse, **motion))


def halved(field):
    """The same pressures on half as many cells each way, which are even numbers."""
    x, y = (middles.reshape(-1, 2).mean(axis=1) for middles in (field.x, field.y))
    return PressureField(x, y, joined(field.pressure, 2, 2), joined(field.cover, 2, 2))
