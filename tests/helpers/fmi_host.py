"""What an instance of an FMU does alike in FMI 2 and 3."""

from fmpy.fmi1 import FMICallException


class Stepping:
    """Steps and log lines of an instance; it has set(), slave, time and log."""

    def step(self, size=1e-3, **inputs):
        self.set(**inputs)
        self.slave.doStep(self.time, size)
        self.time += size

    def told(self):
        """The log lines since the last call."""
        lines, self.log[:] = list(self.log), []
        return lines


def refused(call, *arguments):
    """Whether a call fails with an FMI error."""
    try:
        call(*arguments)
    except FMICallException:
        return True
    return False


def first_instant(fmu, start=None):
    """Outputs before any step, at the default inputs and at others."""
    plain = fmu.running().get()
    instance = fmu.instance()
    instance.slave.enterInitializationMode()
    instance.set(**(start or {}))
    inside = instance.get()
    instance.slave.exitInitializationMode()
    return {"default": plain, "in_initialisation": inside, "after_initialisation": instance.get()}
