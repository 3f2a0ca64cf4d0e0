"""Which call is permitted when: the phases of a simulation as FMI has them, its time and its stopTime.

The native FMUs check the same in ``fmu_src/native/wheelset*.c``, and refuse with the same sentences of
:data:`~wrcontact.status.REFUSALS`.
"""

import math

from ..status import REFUSALS

INSTANTIATED, INITIALISING, RUNNING, TERMINATED = "instantiated", "initialising", "running", "terminated"

#: Rounding of a time that a host has added up over many steps, relative to stopTime and to the step.
ROUNDING, OF_A_STEP = 1e-9, 1e-6


class Refused(ValueError):
    """A value or a call is not accepted; the sentence names it and says what is permitted."""


def refused(reason, *values):
    """The :class:`Refused` for a ``reason`` in REFUSALS, with the ``values`` that its sentence names."""
    return Refused(REFUSALS[reason] % values)


class FmiStateMachine:
    """Phase, time [s] and stopTime [s] of a simulation; what is refused changes nothing."""

    def __init__(self, phase=INSTANTIATED, time=0.0, stop=math.inf):
        self.phase, self.time, self.stop = phase, time, stop

    def saved(self):
        """What a saved state has of it: the arguments of another one that is equal."""
        return [self.phase, self.time, self.stop]

    @property
    def locked(self):
        """Whether the parameters are fixed."""
        return self.phase in (RUNNING, TERMINATED)

    def set_up(self, start, stop=None):
        """Times of the first and of the last instant [s]; without ``stop`` there is no last one."""
        if self.phase != INSTANTIATED:
            raise refused("started")
        stop = math.inf if stop is None else stop
        if not math.isfinite(start) or not stop >= start:
            raise refused("times", repr(start), repr(stop))
        self.time, self.stop = start, stop

    def check_enter(self):
        """Whether initialisation mode can be entered."""
        if self.phase != INSTANTIATED:
            raise refused("entered")

    def check_leave(self):
        """Whether initialisation mode can be left."""
        if self.phase != INITIALISING:
            raise refused("not_entered")

    def terminate(self):
        """End the simulation: values can be read, and nothing else."""
        if self.phase != RUNNING:
            raise refused("not_running")
        self.phase = TERMINATED

    def check_step(self, time, size):
        """Whether a step of ``size`` [s] can begin at ``time`` [s]."""
        if self.phase == RUNNING and size >= 0.0 and time + size <= self.stop and abs(time) + size < math.inf:
            return  # the usual step, at the least cost; a comparison with nan is false
        if self.phase != RUNNING:
            raise refused("no_step_after" if self.phase == TERMINATED else "no_step_before")
        if not math.isfinite(time) or not math.isfinite(time + size) or size < 0.0:
            raise refused("step", repr(size), repr(time))
        if time + size > self.stop + OF_A_STEP * size + ROUNDING * abs(self.stop):
            raise refused("past_stop", repr(size), repr(time), repr(self.stop))
