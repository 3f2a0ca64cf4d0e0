"""A wheelset's steps with creep forces by the complete theory: the kernel finds contact, patches and
creepages, and each patch then rolls on the half-space (wrcontact/reference/rolling).  A step takes some
seconds."""

import numpy as np

from ..kernel import layout
from ..kernel.binding.library import default_kernel
from ..kernel.tangential.tangential_contact import clear_found, mirror_rolling
from ..kernel.tangential.tractions import add_strip
from ..kernel.wheelset.creep_forces import add_creep, write_creep, write_side_wear
from ..kernel.wheelset.moving import is_rolling
from ..status import Status
from .rolling.extrapolation import roll_outline
from .rolling.pressure import Outline

#: Stations of the outline that the strips of a patch are interpolated to, closer together at both ends.
STATIONS = 201


class RollingSolver:
    """The kernel with the half-space's creep forces, on the arrays of one wheelset.

    A step in which a patch does not converge has status 3 and leaves the outputs as they are.

    Parameters
    ----------
    poisson_ratio : of wheel and rail.
    tables, state, workspace, inputs, outputs, left : arrays as for the kernel, used where they are.
    """

    def __init__(self, poisson_ratio, tables, state, workspace, inputs, outputs, left=None):
        self._material = {"shear_modulus": layout.Tables.at(tables).shear_modulus,
                          "poisson_ratio": poisson_ratio}
        self._sides = tables if left is None else left, tables
        self._workspace, self._inputs, self._outputs = workspace, inputs, outputs
        self._kernel = default_kernel().bind(tables, state, workspace, inputs, outputs, left)
        self.compiled = self._kernel.compiled
        self._rolled = None

    def step(self):
        """One step; the status."""
        known = (self._workspace[layout.WORK_KNOWN] == 1.0 and self._rolled is not None
                 and np.array_equal(self._workspace[layout.WORK_INPUTS:][:layout.INPUT_COUNT], self._inputs))
        before = self._outputs.copy()
        status = self._kernel.step()
        if status <= Status.UNLOADED:
            work = layout.Work.at(self._workspace)
            try:
                if not known and is_rolling(work.inputs):
                    self._roll(work)
            except ArithmeticError:
                self._workspace[layout.WORK_KNOWN] = 0.0
                self._outputs[:], self._rolled = before, None
                return int(Status.NOT_CONVERGED)
            self._rolled = self._workspace[layout.WORK_OUTPUTS:][:len(self._outputs)].copy()
            self._outputs[:] = self._rolled
        return status

    def step_many(self, count, inputs, outputs, statuses):
        """``count`` steps in a row: rows of ``inputs`` to rows of ``outputs`` and one float
        in ``statuses`` each."""
        for row in range(count):
            self._inputs[:] = inputs[row]
            statuses[row] = self.step()
            if statuses[row] <= Status.UNLOADED:
                outputs[row] = self._outputs

    def _roll(self, work):
        """The creep forces of all patches, in the place of those of the kernel's model."""
        outputs = work.outputs
        restore(outputs, outputs.normal_part, outputs.normal_moment)
        absent = not np.isfinite(outputs.driving_torque)
        for index, mirror in enumerate((-1.0, 1.0)):
            side, rolling = outputs.left[index], work.rolling_sides[index]
            restore(side, side.normal_part, side.normal_moment)
            side.friction_power = side.wear_number = 0.0
            for number in range(rolling.count):
                patch, to = rolling.patches[number], side.patch[number]
                if to.creepage_x or to.creepage_y or to.spin:
                    take_back(to, mirror)
                    roll_strips(patch, **self._material)
                    write_force(work, index, patch, to)
            write_side_wear(layout.Tables.at(self._sides[index]), work, index)
        if absent:
            outputs.driving_torque = np.nan


def write_force(work, index, patch, to):
    """What has been found of a rolling ``patch`` into its outputs ``to`` on side ``index``, and into the
    resultants."""
    mirror = 2.0 * index - 1.0
    write_creep(patch, to, mirror, patch.friction * patch.load)
    add_creep(work.motion, work.outputs, work.outputs.left[index], to, mirror)


def restore(record, force, moment):
    """Force and moment without friction, and no torque, in the outputs of a wheel or the wheelset."""
    record.force[:] = force[:]
    record.moment[:] = moment[:]
    if isinstance(record, layout.Outputs):
        record.driving_torque = 0.0


def take_back(to, mirror):
    """Take the creep force of a patch out of its force."""
    sine, cosine = np.sin(to.contact_angle), np.cos(to.contact_angle)
    to.force[0] -= to.creep_force_x
    to.force[1] -= mirror * cosine * to.creep_force_y
    to.force[2] += sine * to.creep_force_y


def roll_strips(patch, **material):
    """Creep force of a rolling patch of the kernel, a :class:`~wrcontact.kernel.layout.RollingPatch`, by the
    complete theory, into its record."""
    def solved():
        outline, creepage_x = outline_of_strips(patch)
        return roll_outline(outline, creepage_x=creepage_x, creepage_y=patch.creepage_y, spin=patch.spin,
                            friction=patch.friction, **material)

    roll_patch_forwards(patch, solved)


def roll_patch_forwards(patch, solved):
    """Write what ``solved()`` finds of a patch that rolls forwards, a
    :class:`~wrcontact.reference.rolling.extrapolation.RollingForces`, into its record.  A patch that rolls
    backwards is meanwhile the mirror image of one that rolls forwards."""
    clear_found(patch)
    if patch.load <= 0.0 or patch.friction <= 0.0:
        return
    if patch.backwards:
        mirror_rolling(patch)
    found = solved()
    share_rows(patch, found)
    patch.force_x, patch.force_y, patch.moment = found.force_x, found.force_y, found.moment
    patch.stick_share, patch.max_shear = found.stick_share, found.max_shear
    if patch.backwards:
        mirror_rolling(patch)


def outline_of_strips(patch):
    """The patch as an :class:`~wrcontact.reference.rolling.pressure.Outline`, and the longitudinal creepage
    beside that of spin at its stations (n,).

    Over the ellipse that has the patch's ends, square of the half-length and line load follow straight lines
    between the strips: an ellipse is met exactly.
    """
    strips = [patch.strips[k] for k in range(patch.count)]
    start, stop = (strip.y + way * 0.5 * strip.width for strip, way in ((strips[0], -1), (strips[-1], 1)))
    y, square, load, slip, x = np.array([(strip.y, strip.half_length**2, strip.line_load, strip.slip, strip.x)
                                         for strip in strips]).T
    middle, half = 0.5 * (start + stop), 0.5 * (stop - start)
    low, high = np.array([(strip.y - 0.5 * strip.width, strip.y + 0.5 * strip.width) for strip in strips]).T

    def ellipse(t):
        return t - t**3 / 3.0

    mean = (ellipse((high - middle) / half) - ellipse((low - middle) / half)) * half / (high - low)
    station = middle + half * np.sin(np.linspace(-0.5, 0.5, STATIONS) * np.pi)
    share = np.clip(1.0 - ((station - middle) / half) ** 2, 0.0, None)
    half_length = np.sqrt(share * np.interp(station, y, square / mean))
    line = share * np.interp(station, y, load / mean)
    pressure = np.divide(line, 0.5 * np.pi * half_length, out=np.zeros(STATIONS), where=half_length > 0.0)
    outline = Outline.of_stations(station, half_length, pressure, np.interp(station, y, x)).scaled(patch.load)
    return outline, np.interp(station, y, slip + patch.spin * y)


def share_rows(patch, found):
    """Each strip's part of the tractions on the fine grid, per width [N/m]."""
    field, tractions = found.fine.field, found.fine.tractions
    along, across = tractions.sum(axis=2) * field.steps[1]
    turning = (tractions[1] * field.x).sum(axis=1) * field.steps[1]
    for number in range(patch.count):
        strip = patch.strips[number]
        force_x, force_y, moment = (np.interp(strip.y, field.y, each) for each in (along, across, turning))
        add_strip(patch, strip, force_x, force_y, moment - strip.x * force_y)
