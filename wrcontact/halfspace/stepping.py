"""A wheelset's steps with the half-space model: the kernel finds roll and rigid contacts, each loaded wheel
is then pressed into its rail (:mod:`pressed_wheel`), and its patches roll there (:mod:`pressed_rolling`).  A
step takes some tenths of a second, and some seconds with creep forces by the complete theory; so several
processes may share many poses."""

import math
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from ..kernel import layout
from ..kernel.binding.library import default_kernel
from ..kernel.wheelset.input_checks import has_creep_forces, has_wear, requested_status
from ..kernel.wheelset.rolling_contact import move_patches, move_wheelset
from ..progress import tracked
from ..status import Status
from ..stepper import Stepper
from ..workers import process_pool
from .contact import TOLERANCE
from .free_rolling import rub_wheels
from .outputs import fill_side
from .pressed_rolling import CompleteRolling, KernelRolling, SolvedSide, cut_patches, place_wear
from .pressed_wheel import Settings, find_equilibrium, press, stand_of
from .rolling_step import Solver, report_forces, status_of
from .wheel_on_rail import wheel_on_rail

#: How far above its rail an unloaded wheel of an elastic wheelset is counted [m].
CLEAR = 1e-9
CHUNK = 2  # rows that a process takes at a time

_worker = None  # in a worker: its stepper, and the places of the outputs that are wanted


def halfspace_solver(tolerance=None, poisson_ratio=None):
    """What :class:`~wrcontact.Stepper` binds its arrays with; ``tolerance`` as for
    :class:`~wrcontact.ContactSystem`, ``poisson_ratio`` as for :class:`HalfspaceSolver`."""
    return partial(HalfspaceSolver, TOLERANCE if tolerance is None else tolerance, poisson_ratio)


class HalfspaceSolver(Solver):
    """The half-space model.

    Parameters
    ----------
    tolerance : permitted relative error, as for :func:`~wrcontact.halfspace.contact.solve_contact`.
    poisson_ratio : of wheel and rail, for creep forces by the complete theory; None: those by the kernel's
        model, if the tables have one.
    tables, state, workspace, inputs, outputs : arrays as for the kernel, used where they are.
    """

    def __init__(self, tolerance, poisson_ratio, tables, state, workspace, inputs, outputs):
        self.tolerance, self._array, self._state, self._workspace = tolerance, tables, state, workspace
        self._tables = layout.Tables.at(tables)
        self._inputs, self._outputs, self._geometry = inputs, outputs, np.zeros_like(outputs)
        self._kernel = default_kernel().bind(tables, state, workspace, inputs, self._geometry)
        self.compiled = self._kernel.compiled
        self._creep = (
            KernelRolling(tables, workspace)
            if poisson_ratio is None
            else CompleteRolling(self._tables.shear_modulus, poisson_ratio)
        )
        self._pressed = self._status = None

    @property
    def _work(self):
        return layout.Work.at(self._workspace)

    def step(self):
        """One step; the status."""
        if self._is_known():
            self._outputs[:] = self._answer
            return self._status
        self._answer = None
        self._refuse_rolled_rails()
        self._work.known = False
        status = self._kernel.step()
        if status > Status.UNLOADED:
            return status
        try:
            status = self._solve(status)
        except ArithmeticError as error:
            return status_of(error)
        if status <= Status.UNLOADED:
            self._keep_answer()
            self._status = status
        return status

    @property
    def _settings(self):
        return Settings(
            self._tables.contact_modulus, 0.0, self._tables.load == layout.LOAD_VERTICAL, self.tolerance
        )

    def _solve(self, status):
        """The patches of a wheelset whose geometry the kernel has found, and all outputs, in the workspace;
        the status."""
        work, tables = self._work, self._tables
        wheels = [partial(self._pressed_side, index) for index in range(2)]
        if tables.mode == layout.MODE_ELASTIC and (self._force(0) > 0.0 or self._force(1) > 0.0):
            wheels, status = self._balanced()
            status = requested_status(tables, work, status)
        solved = [
            self._press(index, wheels[index])
            for index in tracked(range(2), "half-space of one pose", alone=True)
        ]
        move_wheelset(tables, work)
        move_patches(tables, work)
        if has_creep_forces(tables, work):
            rub_wheels(tables, work, partial(self._rub, solved))
        report_forces(tables, work)
        return status

    def _rub(self, solved, index, patch):
        """The creep force of a patch of the :class:`SolvedSide` ``index``."""
        self._creep(solved[index], index, patch, self._work.sides[index].motion)

    def _press(self, index, wheel):
        """Fill a side's patches with those of its pressed wheel; the :class:`SolvedSide`, None for a wheel
        without load, and for one that is not wanted."""
        tables, side = self._tables, self._work.sides[index]
        if side.patch_count == 0:
            return None
        wheel, (across, _) = wheel(), self._contact(index)
        if tables.mode == layout.MODE_RIGID:
            side.penetration = wheel.contact.penetration * math.cos(side.point.contact_angle)
        found = SolvedSide(wheel.counted_from(across), self._moved(index) * [2.0 * index - 1.0, 1.0])
        strips = self._work.contact.strips
        fill_side(side, strips, found.wheel, found.moved, int(tables.stations))
        if tables.tangential != layout.TANGENTIAL_NONE or has_wear(tables):
            cut_patches(found, side, strips)
        if has_wear(tables):
            place_wear(found, side, int(tables.stations))
        return found

    def _pair(self, index, roll, height):
        """The wheel of a side and its rail, for this roll [rad] and vertical shift [m]."""
        return wheel_on_rail(
            self._array,
            index,
            lateral_shift=self._inputs[layout.IN_LATERAL_SHIFT],
            yaw=self._inputs[layout.IN_YAW],
            roll=roll,
            vertical_shift=height,
            rail=self._moved(index),
        )

    def _refuse_rolled_rails(self):
        for side, place in (("left", layout.IN_LEFT_RAIL_ROLL), ("right", layout.IN_RIGHT_RAIL_ROLL)):
            if self._inputs[place] != 0.0:
                raise ValueError(
                    f"{side}.rail_roll is {self._inputs[place]:g} rad; permitted with the "
                    "normal_model 'halfspace' is 0"
                )

    def _moved(self, index):
        """Displacement of a side's rail to the right and down [m]."""
        first = layout.IN_LEFT_RAIL_LATERAL if index == 0 else layout.IN_RIGHT_RAIL_LATERAL
        return self._inputs[first : first + 2]

    def _contact(self, index):
        """Place of the contact point across and down, in the frame of a right wheel on a rail that is not
        moved."""
        lateral, vertical = self._moved(index)
        point = self._work.sides[index].point
        return point.y_track - (2.0 * index - 1.0) * lateral, point.z_track - vertical

    def _force(self, index):
        """The force that is prescribed for a side [N]."""
        transfer = (2.0 * index - 1.0) * self._inputs[layout.IN_LOAD_TRANSFER]
        return self._inputs[layout.IN_NORMAL_FORCE] * (1.0 + transfer)

    def _pressed_side(self, index):
        """The pressed wheel of a side where the kernel has found its contact: rigid or compliant."""
        work = self._work
        side, point = work.sides[index], work.sides[index].point
        pair = self._pair(index, work.wheelset.roll, work.wheelset.vertical_shift)
        steep = math.cos(point.contact_angle)
        depth = side.penetration / steep
        if self._tables.mode == layout.MODE_COMPLIANT:
            return press(pair.lowered(-depth), self._settings, penetration=depth)
        # the kernel's contact is one to its tolerance
        apart = pair.distance(point.x_track, *self._contact(index), point.contact_angle)
        prescribed = self._tables.penetration[index]
        load = (
            {"penetration": prescribed / steep}
            if math.isfinite(prescribed)
            else {"force": self._force(index), "estimate": depth}
        )
        return press(pair.lowered(apart / steep), self._settings, **load)

    def _balanced(self):
        """Functions that return both pressed wheels of an elastic wheelset, which the workspace then
        describes, and its status."""
        roll, height = self._work.wheelset.roll, self._work.wheelset.vertical_shift
        settings, arm = self._settings, self._tables.arm
        heights = {0: height, 1: height}

        def stand(index, roll, tolerance, last):
            found = stand_of(
                self._pair(index, roll, heights[index]),
                index,
                settings.at(tolerance),
                self._force(index),
                last,
            )
            heights[index] = found.height
            return found

        roll, stands = find_equilibrium(stand, roll, arm, settings.tolerance)
        height = 0.5 * (stands[0].height + stands[1].height)
        for each in stands:
            if each.wheel is None:  # heights are equal to a tolerance only: it must not overlap its rail
                height = each.height - CLEAR
        status = self._stand_at(roll, height)
        return [lambda wheel=each.wheel: wheel for each in stands], status

    def _stand_at(self, roll, height):
        """Let the kernel's workspace be that of a wheelset with this roll [rad] and vertical shift [m]; its
        status."""
        if self._pressed is None:
            arrays = (
                self._array.copy(),
                np.zeros(layout.STATE_SIZE),
                np.zeros(layout.WORK_SIZE),
                np.zeros(layout.INPUT_COUNT),
                np.zeros_like(self._outputs),
            )
            self._pressed = default_kernel().bind(*arrays), *arrays
        kernel, array, _, workspace, inputs, _ = self._pressed
        tables = layout.Tables.at(array)
        tables.mode = layout.MODE_COMPLIANT
        tables.sides, tables.depth = layout.SIDES_BOTH, layout.DEPTH_PATCHES
        pressed = layout.Work.at(workspace)
        pressed.known = False
        inputs[:] = self._inputs
        inputs[layout.IN_ROLL], inputs[layout.IN_VERTICAL_SHIFT] = roll, height
        status = kernel.step()
        self._work.sides, self._work.wheelset = pressed.sides, pressed.wheelset
        return status


def shared_parts(tables, solver, rows, places, processes):
    """Evaluate ``rows`` of inputs (n, inputs) in ``processes``; yields what
    :meth:`~wrcontact.stepper.Stepper.parts` yields, in the order of the rows and with the same numbers.

    Parameters
    ----------
    tables : of a stepper, with what is wanted and prescribed.
    solver : arguments of :func:`~wrcontact.halfspace.stepping.halfspace_solver`.
    places : of the wanted outputs, None for all.

    Raises
    ------
    RuntimeError
        where the processes cannot start or end early.
    """
    parts = [slice(start, min(start + CHUNK, len(rows))) for start in range(0, len(rows), CHUNK)]
    with TemporaryDirectory() as folder:
        path = Path(folder, "tables.npy")
        np.save(path, tables)
        count = min(processes, len(parts))
        with process_pool(count, _begin, (path, solver, places)) as pool:
            for part, (found, status) in zip(parts, pool.map(_evaluated, [rows[part] for part in parts])):
                yield part, found, status


def _begin(path, solver, places):
    global _worker
    _worker = Stepper(np.load(path), halfspace_solver(*solver)), places


def _evaluated(rows):
    """Outputs and status of some rows."""
    stepper, places = _worker
    outputs, status = np.full((len(rows), len(stepper.outputs)), math.nan), np.empty(len(rows))
    stepper.step_many(rows, outputs, status)
    return outputs if places is None else outputs[:, places], status.astype(int)
