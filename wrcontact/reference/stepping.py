"""A wheelset's steps with the half-space model: the kernel finds roll and rigid contacts, each loaded wheel
is then pressed into its rail (:mod:`pressed_wheel`), and its patches roll there (:mod:`pressed_rolling`).  A
step takes some tenths of a second, and some seconds with creep forces by the complete theory."""

import math
from functools import partial

import numpy as np

from ..kernel import layout
from ..kernel.binding.library import default_kernel
from ..kernel.wheelset.creep_forces import has_creep_forces
from ..kernel.wheelset.moving import is_rolling, write_creepages
from ..progress import tracked
from ..state import outline_of
from ..status import Status
from .equilibrium import find_equilibrium, stand_of
from .halfspace import TOLERANCE
from .outputs import write_side
from .pressed_rolling import CompleteRolling, KernelRolling, SolvedSide, write_pressed_creep
from .pressed_wheel import Settings, press
from .wheel_on_rail import wheel_on_rail

SIDES = layout.OUT_LEFT, layout.OUT_RIGHT
#: How far above its rail an unloaded wheel of an elastic wheelset is counted [m].
CLEAR = 1e-9


def halfspace_solver(tolerance=None, poisson_ratio=None):
    """What :class:`~wrcontact.Stepper` binds its arrays with; ``tolerance`` as for
    :class:`~wrcontact.ContactSystem`, ``poisson_ratio`` as for :class:`HalfspaceSolver`."""
    return partial(HalfspaceSolver, TOLERANCE if tolerance is None else tolerance, poisson_ratio)


class HalfspaceSolver:
    """The half-space model on the arrays of one wheelset.

    A step in which a wheel does not converge has status 3 and leaves the outputs as they are.

    Parameters
    ----------
    tolerance : permitted relative error, as for :func:`~wrcontact.reference.halfspace.solve_contact`.
    poisson_ratio : of wheel and rail, for creep forces by the complete theory; None: those by the kernel's
        model, if the tables have one.
    tables, state, workspace, inputs, outputs, left : arrays as for the kernel, used where they are.
    """

    def __init__(self, tolerance, poisson_ratio, tables, state, workspace, inputs, outputs, left=None):
        self.tolerance, self._tables, self._state, self._workspace = tolerance, tables, state, workspace
        self._sides = tables if left is None else left, tables
        self._inputs, self._outputs, self._geometry = inputs, outputs, np.zeros_like(outputs)
        self._kernel = default_kernel().bind(tables, state, workspace, inputs, self._geometry, left)
        self.compiled = self._kernel.compiled
        self._creep = (KernelRolling(self._sides, workspace) if poisson_ratio is None else
                       CompleteRolling(workspace, layout.Tables.at(tables).shear_modulus, poisson_ratio))
        self._pressed = None
        self._answer, self._status = None, None

    def step(self):
        """One step; the status."""
        if self._is_known():
            self._outputs[:] = self._answer
            return self._status
        self._answer = None
        self._refuse_rolled_rails()
        status = self._kernel.step()
        if status > Status.UNLOADED:
            return status
        try:
            answer, status = self._solve(status)
        except ArithmeticError:
            return int(Status.NOT_CONVERGED)
        if status <= Status.UNLOADED:
            self._outputs[:] = answer
            self._answer, self._status = answer, status
        return status

    def step_many(self, count, inputs, outputs, statuses):
        """``count`` steps in a row: rows of ``inputs`` to rows of ``outputs`` and one float
        in ``statuses`` each."""
        for row in range(count):
            self._inputs[:] = inputs[row]
            statuses[row] = self.step()
            if statuses[row] <= Status.UNLOADED:
                outputs[row] = self._outputs

    def _is_known(self):
        """Whether the inputs are those of the last answer, and nothing else has changed."""
        return (self._answer is not None and self._workspace[layout.WORK_KNOWN] == 1.0
                and np.array_equal(self._workspace[layout.WORK_INPUTS:][:layout.INPUT_COUNT], self._inputs))

    @property
    def _settings(self):
        return Settings(self._tables[layout.SET_CONTACT_MODULUS], 0.0,
                        self._tables[layout.SET_LOAD] == layout.LOAD_VERTICAL, self.tolerance)

    def _solve(self, status):
        """Outputs and status of a step whose geometry the kernel has found."""
        if self._tables[layout.SET_MODE] == layout.MODE_ELASTIC and (self._force(0) > 0.0
                                                                      or self._force(1) > 0.0):
            geometry, wheels, status = self._balanced()
        else:
            geometry = self._geometry
            wheels = [partial(self._pressed_side, index) for index in range(2)]
        answer, total, solved = geometry.copy(), np.zeros(6), []
        for index, first in enumerate(tracked(SIDES, "half-space of one pose", alone=True)):
            side = answer[first:first + layout.SIDE_SIZE]
            if side[layout.SIDE_NORMAL_FORCE] > 0.0:
                found, force = self._write(answer, index, side, wheels[index]())
                total += force
                solved.append(found)
            elif not math.isfinite(side[layout.SIDE_NORMAL_FORCE]):      # this side is not wanted
                total[:] = math.nan
        for first in (layout.OUT_FORCE, layout.OUT_NORMAL_PART):
            answer[first:first + len(total)] = total
        answer[layout.OUT_DRIVING_TORQUE] = 0.0 * total[0]
        self._move(answer, solved)
        return answer, status

    def _move(self, answer, solved):
        """Creepages at the patches' own centres of load, and their creep forces, by the kernel's source, in
        whose workspace the outputs stand for a moment."""
        work = layout.Work.at(self._workspace)
        if is_rolling(work.inputs):
            outputs = self._workspace[layout.WORK_OUTPUTS:layout.WORK_OUTPUTS + len(answer)]
            kept = outputs.copy()
            outputs[:] = answer
            tables = [layout.Tables.at(each) for each in self._sides]
            try:
                write_creepages(*tables, work, layout.State.at(self._state))
                if has_creep_forces(tables[1], work):
                    for side in solved:
                        write_pressed_creep(tables[side.index], work, side, self._creep)
                answer[:] = outputs
            finally:
                outputs[:] = kept

    def _write(self, answer, index, side, wheel):
        """The outputs of a pressed wheel instead of the kernel's; the :class:`SolvedSide`, and its part of
        the resultant (6,)."""
        depth = side[layout.SIDE_PENETRATION]
        if self._tables[layout.SET_MODE] == layout.MODE_RIGID:
            depth = wheel.contact.penetration * math.cos(side[layout.SIDE_CONTACT_ANGLE])
        outline = outline_of(answer, SIDES[index])
        side[layout.SIDE_PENETRATION:layout.SIDE_STATION] = 0.0
        centre = self._pair(index, answer[layout.OUT_ROLL], answer[layout.OUT_VERTICAL_SHIFT]).centre
        wheel = wheel.counted_from(self._contact(index, side)[0])
        solved, total = write_side(side, wheel, index, centre,
                                   outline if self._tables[layout.SET_DEPTH] == layout.DEPTH_ALL else None)
        side[layout.SIDE_PENETRATION] = depth
        record, (lateral, vertical) = layout.SideOutputs.at(side), self._moved(index)
        for patch in record.patch:
            if patch.normal_force > 0.0:
                patch.y_track += lateral
                patch.z_track += vertical
        return SolvedSide(wheel, solved, 2.0 * index - 1.0, self._moved(index)), total

    def _pair(self, index, roll, height):
        """The wheel of a side and its rail, for this roll [rad] and vertical shift [m]."""
        return wheel_on_rail(self._sides[index], index, lateral_shift=self._inputs[layout.IN_LATERAL_SHIFT],
                             yaw=self._inputs[layout.IN_YAW], roll=roll, vertical_shift=height,
                             rail=self._moved(index))

    def _refuse_rolled_rails(self):
        for side, place in (("left", layout.IN_LEFT_RAIL_ROLL), ("right", layout.IN_RIGHT_RAIL_ROLL)):
            if self._inputs[place] != 0.0:
                raise ValueError(f"{side}.rail_roll is {self._inputs[place]:g} rad; permitted with the "
                                 "normal_model 'halfspace' is 0")

    def _moved(self, index):
        """Displacement of a side's rail to the right and down [m]."""
        first = layout.IN_LEFT_RAIL_LATERAL if index == 0 else layout.IN_RIGHT_RAIL_LATERAL
        return self._inputs[first:first + 2]

    def _contact(self, index, side):
        """Place of the contact point across and down, in the frame of a right wheel on a rail that is not
        moved."""
        lateral, vertical = self._moved(index)
        return ((2.0 * index - 1.0) * (side[layout.SIDE_Y_TRACK] - lateral),
                side[layout.SIDE_Z_TRACK] - vertical)

    def _force(self, index):
        """The force that is prescribed for a side [N]."""
        transfer = (2.0 * index - 1.0) * self._inputs[layout.IN_LOAD_TRANSFER]
        return self._inputs[layout.IN_NORMAL_FORCE] * (1.0 + transfer)

    def _pressed_side(self, index):
        """The pressed wheel of a side where the kernel has found its contact: rigid or compliant."""
        side = self._geometry[SIDES[index]:]
        pair = self._pair(index, self._geometry[layout.OUT_ROLL], self._geometry[layout.OUT_VERTICAL_SHIFT])
        steep = math.cos(side[layout.SIDE_CONTACT_ANGLE])
        depth = side[layout.SIDE_PENETRATION] / steep
        if self._tables[layout.SET_MODE] == layout.MODE_COMPLIANT:
            return press(pair.lowered(-depth), self._settings, penetration=depth)
        # the kernel's contact is one to its tolerance
        apart = pair.distance(side[layout.SIDE_X_TRACK], *self._contact(index, side),
                              side[layout.SIDE_CONTACT_ANGLE])
        prescribed = self._tables[layout.SET_PENETRATION_LEFT + index]
        load = ({"penetration": prescribed / steep} if math.isfinite(prescribed)
                else {"force": self._force(index), "estimate": depth})
        return press(pair.lowered(apart / steep), self._settings, **load)

    def _balanced(self):
        """Geometry, functions that return both pressed wheels, and status of an elastic wheelset."""
        roll, height = self._geometry[layout.OUT_ROLL], self._geometry[layout.OUT_VERTICAL_SHIFT]
        settings, arm = self._settings, self._tables[layout.SET_ARM]
        heights = {0: height, 1: height}

        def stand(index, roll, tolerance, last):
            found = stand_of(self._pair(index, roll, heights[index]), index, settings.at(tolerance),
                             self._force(index), last)
            heights[index] = found.height
            return found

        roll, stands = find_equilibrium(stand, roll, arm, settings.tolerance)
        height = 0.5 * (stands[0].height + stands[1].height)
        for each in stands:
            if each.wheel is None:      # heights are equal to a tolerance only: it must not overlap its rail
                height = each.height - CLEAR
        geometry, status = self._geometry_at(roll, height)
        return geometry, [lambda wheel=each.wheel: wheel for each in stands], status

    def _geometry_at(self, roll, height):
        """The kernel's outputs and status for a wheelset with this roll [rad] and vertical shift [m]."""
        if self._pressed is None:
            tables = self._tables.copy()
            left = tables if self._sides[0] is self._tables else self._sides[0].copy()
            arrays = (tables, np.zeros(layout.STATE_SIZE), np.zeros(layout.WORK_SIZE),
                      np.zeros(layout.INPUT_COUNT), np.zeros_like(self._outputs), left)
            for each in (tables, left):
                each[layout.SET_MODE] = layout.MODE_COMPLIANT
            self._pressed = default_kernel().bind(*arrays), *arrays
        kernel, tables, _, workspace, inputs, outputs, left = self._pressed
        for place in (layout.SET_SIDES, layout.SET_DEPTH):
            tables[place] = left[place] = self._tables[place]
        workspace[layout.WORK_KNOWN] = 0.0
        inputs[:] = self._inputs
        inputs[layout.IN_ROLL], inputs[layout.IN_VERTICAL_SHIFT] = roll, height
        status = kernel.step()
        return outputs, status
