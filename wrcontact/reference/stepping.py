"""A wheelset's steps with the half-space model: the kernel finds roll and rigid contacts, each loaded wheel
is then solved on its true gap. A step takes a few hundredths of a second."""

import math
from functools import partial

import numpy as np

from ..kernel import layout
from ..kernel.binding.library import default_kernel
from ..progress import tracked
from ..state import outline_of
from ..status import Status
from . import halfspace
from .outputs import write_side
from .true_gap import REACH_S, REACH_X, contact_plane


def halfspace_solver(tolerance=None):
    """What :class:`~wrcontact.Stepper` binds its arrays with; ``tolerance`` as for
    :class:`~wrcontact.ContactSystem`."""
    return partial(HalfspaceSolver, halfspace.TOLERANCE if tolerance is None else tolerance)


class HalfspaceSolver:
    """The half-space model on the arrays of one wheelset.

    A step in which a wheel does not converge has status 3 and leaves the outputs as they are.

    Parameters
    ----------
    tolerance : permitted relative error, as for :func:`~wrcontact.reference.halfspace.solve_contact`.
    tables, state, workspace, inputs, outputs : arrays as for the kernel, used where they are.
    """

    def __init__(self, tolerance, tables, state, workspace, inputs, outputs):
        self.tolerance, self._tables, self._workspace = tolerance, tables, workspace
        self._inputs, self._outputs, self._rigid = inputs, outputs, np.zeros_like(outputs)
        self._kernel = default_kernel().bind(tables, state, workspace, inputs, self._rigid)
        self.compiled = self._kernel.compiled
        self._answer, self._status = None, None

    def step(self):
        """One step; the status."""
        if self._is_known():
            self._outputs[:] = self._answer
            return self._status
        self._answer = None
        status = self._kernel.step()
        if status > Status.UNLOADED:
            return status
        answer, total = self._rigid.copy(), np.zeros(6)
        sides = (layout.OUT_LEFT, layout.OUT_RIGHT)
        try:
            for index, first in enumerate(tracked(sides, "half-space of one pose", alone=True)):
                side = answer[first:first + layout.SIDE_SIZE]
                if side[layout.SIDE_NORMAL_FORCE] > 0.0:
                    total += self._solve(index, side, outline_of(answer, first))
        except ArithmeticError:
            return int(Status.NOT_CONVERGED)
        if math.isfinite(answer[layout.OUT_FORCE]):     # both sides are wanted
            answer[layout.OUT_FORCE:layout.OUT_FORCE + len(total)] = total
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

    def _solve(self, index, side, outline):
        """Replace the normal contact and outline of one loaded side by the half-space's; its
        part of the resultant (6,)."""
        plane = contact_plane(self._tables, self._rigid, self._inputs, index)
        penetration = self._tables[layout.SET_PENETRATION_LEFT + index]
        load = ({"penetration": penetration} if math.isfinite(penetration)
                else {"force": side[layout.SIDE_NORMAL_FORCE]})
        contact = halfspace.solve_contact(plane.gap, (-REACH_X, REACH_X, -REACH_S, REACH_S),
                                          tolerance=self.tolerance,
                                          contact_modulus=self._tables[layout.SET_CONTACT_MODULUS], **load)
        side[layout.SIDE_PENETRATION:layout.SIDE_STATION] = 0.0
        return write_side(side, plane, contact, index,
                          outline if self._tables[layout.SET_DEPTH] == layout.DEPTH_ALL else None)
