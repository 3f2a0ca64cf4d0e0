"""Which call is permitted when: the phases of a simulation as FMI has them, its time and its stopTime.

The native FMUs check the same in ``fmu_src/native/wheelset*.c``, and refuse with the same sentences.
"""

import math

INSTANTIATED, INITIALISING, RUNNING, TERMINATED = "instantiated", "initialising", "running", "terminated"

#: Rounding of a time that a host has added up over many steps, relative to stopTime and to the step.
ROUNDING, OF_A_STEP = 1e-9, 1e-6


class Refused(ValueError):
    """A value or a call is not accepted; the sentence names it and says what is permitted."""


class Life:
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
            raise Refused(
                "initialisation is permitted once, with startTime and stopTime, after "
                "instantiation or a reset"
            )
        stop = math.inf if stop is None else stop
        if not math.isfinite(start) or not stop >= start:
            raise Refused(
                f"startTime is {start!r} s and stopTime {stop!r} s; permitted are a finite "
                "startTime and a stopTime not before it"
            )
        self.time, self.stop = start, stop

    def check_enter(self):
        """Whether initialisation mode can be entered."""
        if self.phase != INSTANTIATED:
            raise Refused("initialisation mode can be entered once, after instantiation or a reset")

    def check_leave(self):
        """Whether initialisation mode can be left."""
        if self.phase != INITIALISING:
            raise Refused("initialisation mode can be left only after it was entered")

    def terminate(self):
        """End the simulation: values can be read, and nothing else."""
        if self.phase != RUNNING:
            raise Refused("only a running simulation can be terminated")
        self.phase = TERMINATED

    def check_step(self, time, size):
        """Whether a step of ``size`` [s] can begin at ``time`` [s]."""
        if self.phase == RUNNING and size >= 0.0 and time + size <= self.stop and abs(time) + size < math.inf:
            return  # the usual step, at the least cost; a comparison with nan is false
        if self.phase != RUNNING:
            raise Refused(
                "the wheelset cannot step: it has "
                + ("been terminated" if self.phase == TERMINATED else "not been initialised")
            )
        if not math.isfinite(time) or not math.isfinite(time + size) or size < 0.0:
            raise Refused(
                f"a step of {size!r} s at {time!r} s is not possible; permitted are finite times "
                "and sizes of 0 s or more"
            )
        if time + size > self.stop + OF_A_STEP * size + ROUNDING * abs(self.stop):
            raise Refused(
                f"a step of {size!r} s at {time!r} s ends after the stopTime {self.stop!r} s; "
                "permitted are steps up to it"
            )
