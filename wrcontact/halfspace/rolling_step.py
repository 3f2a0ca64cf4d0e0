"""A wheelset's steps with creep forces by the complete theory: the kernel finds contact, patches and
creepages, and each patch then rolls on the half-space (wrcontact/halfspace/rolling).  A step takes some
seconds."""

import numpy as np

from ..kernel import layout
from ..kernel.binding.library import default_kernel
from ..kernel.creep.creep_force import mirror_rolling
from ..kernel.creep.rolling_strips import clear_creep
from ..kernel.creep.tractions import add_strip
from ..kernel.wheelset.forces import sum_forces
from ..kernel.wheelset.input_checks import has_creep_forces
from ..kernel.wheelset.report import report
from ..status import Status
from .free_rolling import BeyondAdhesion, rub_wheels
from .rolling.extrapolation import roll_outline
from .rolling.pressure import Outline

#: Stations of the outline that the strips of a patch are interpolated to, closer together at both ends.
STATIONS = 201


class Solver:
    """What makes steps in Python on the arrays of one wheelset; ``step`` makes one.

    A step that does not converge has status 3 and leaves the outputs as they are.
    """

    _answer = None  # the outputs of the last step; None where they do not hold any more

    def _is_known(self):
        """Whether the inputs are those of the last answer, and nothing else has changed."""
        work = layout.Work.at(self._workspace)
        return self._answer is not None and work.known and np.array_equal(work.inputs.numbers(), self._inputs)

    def _keep_answer(self):
        """Write the outputs in the workspace to those of the step, and keep them."""
        first = layout.Work.outputs.offset // 8
        self._answer = self._workspace[first:][: len(self._outputs)].copy()
        self._outputs[:] = self._answer

    def step_many(self, count, inputs, outputs, statuses):
        """``count`` steps in a row: rows of ``inputs`` to rows of ``outputs`` and one float in ``statuses``
        each."""
        for row in range(count):
            self._inputs[:] = inputs[row]
            statuses[row] = self.step()
            if statuses[row] <= Status.UNLOADED:
                outputs[row] = self._outputs


class RollingSolver(Solver):
    """The kernel with the half-space's creep forces.

    Parameters
    ----------
    poisson_ratio : of wheel and rail.
    tables, state, workspace, inputs, outputs, left : arrays as for the kernel, used where they are.
    """

    def __init__(self, poisson_ratio, tables, state, workspace, inputs, outputs):
        self._tables = layout.Tables.at(tables)
        self._material = {"shear_modulus": self._tables.shear_modulus, "poisson_ratio": poisson_ratio}
        self._workspace, self._inputs, self._outputs = workspace, inputs, outputs
        self._kernel = default_kernel().bind(tables, state, workspace, inputs, outputs)
        self.compiled = self._kernel.compiled

    def step(self):
        """One step; the status."""
        known, before = self._is_known(), self._outputs.copy()
        status = self._kernel.step()
        if status <= Status.UNLOADED:
            work = layout.Work.at(self._workspace)
            try:
                if not known and has_creep_forces(self._tables, work):
                    rub_wheels(self._tables, work, lambda index, patch: roll_strips(patch, **self._material))
                    report_forces(self._tables, work)
            except ArithmeticError as error:
                work.known = False
                self._outputs[:], self._answer = before, None
                return status_of(error)
            self._keep_answer()
        return status


def status_of(error):
    """The status of a step that has ended with this ArithmeticError."""
    beyond = isinstance(error, BeyondAdhesion)
    return int(Status.BEYOND_ADHESION if beyond else Status.NOT_CONVERGED)


def report_forces(tables, work):
    """The sum of all forces, and all outputs, in the workspace."""
    sum_forces(tables, work)
    report(tables, work)


def roll_strips(patch, **material):
    """Creep force of a patch of the kernel that rolls, a :class:`~wrcontact.kernel.layout.Patch`, by the
    complete theory, into its record."""

    def solved():
        outline, creepages = outline_of_strips(patch)
        return roll_outline(outline, **creepages, **friction_of(patch), **material)

    roll_patch_forwards(patch, solved)


def friction_of(patch):
    """Friction of a ``patch`` and how it falls, as keywords of
    :func:`~wrcontact.halfspace.rolling.contact.rolling_contact`."""
    fall = (patch.fall_floor, patch.fall_rate) if patch.fall_rate > 0.0 else None
    return {"friction": patch.friction, "fall": fall}


def roll_patch_forwards(patch, solved):
    """Write what ``solved()`` finds of a patch that rolls forwards, a
    :class:`~wrcontact.halfspace.rolling.extrapolation.RollingForces`, into its record.  A patch that rolls
    backwards is meanwhile the mirror image of one that rolls forwards."""
    clear_creep(patch)
    if patch.totals.load <= 0.0 or patch.friction <= 0.0:
        return
    if patch.backwards:
        mirror_rolling(patch)
    found = solved()
    share_rows(patch, found)
    patch.creep_x, patch.creep_y, patch.creep_moment = found.force_x, found.force_y, found.moment
    patch.stick_share, patch.max_shear = found.stick_share, found.max_shear
    if patch.fall_rate > 0.0:
        patch.friction = found.mean_friction
    if patch.backwards:
        mirror_rolling(patch)


def outline_of_strips(patch):
    """The patch as an :class:`~wrcontact.halfspace.rolling.pressure.Outline`, and by name its spin and its
    creepages beside those of spin at the stations (n,).

    Over the ellipse that has the patch's ends, square of the half-length and line load follow straight lines
    between the strips: an ellipse is met exactly.
    """
    strips = list(patch.strips)
    start, stop = (strip.y + way * 0.5 * strip.width for strip, way in ((strips[0], -1), (strips[-1], 1)))
    y, square, load, x = np.array(
        [(strip.y, strip.half_length**2, strip.line_load, strip.x) for strip in strips]
    ).T
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
    outline = Outline.of_stations(station, half_length, pressure, np.interp(station, y, x))
    outline = outline.scaled(patch.totals.load)
    return outline, {name: np.interp(station, y, values) for name, values in beside_spin(strips).items()}


def beside_spin(strips):
    """By name, the spin of strips and their creepages beside those of spin, (n,) each."""
    y, x, slip, lateral, spin = np.array(
        [(strip.y, strip.x, strip.slip, strip.lateral, strip.spin) for strip in strips]
    ).T
    return {"creepage_x": slip + spin * y, "creepage_y": lateral - spin * x, "spin": spin}


def share_rows(patch, found):
    """Each strip's part of the tractions on the fine grid, per width [N/m]."""
    field, tractions = found.fine.field, found.fine.tractions
    along, across = found.fine.line_loads()
    turning = (tractions[1] * field.x).sum(axis=1) * field.steps[1]
    for strip in patch.strips:
        force_x, force_y, moment = (np.interp(strip.y, field.y, each) for each in (along, across, turning))
        add_strip(patch, strip, force_x, force_y, moment - strip.x * force_y)
