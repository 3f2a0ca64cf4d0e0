import ctypes
import sys

from pythonfmu import Fmi2Slave
from pythonfmu.enums import Fmi2Status

from wrcontact.simulation.session import Session


class WheelsetContact(Fmi2Slave):
    """Wheelset on track as an FMI 2.0 co-simulation slave: passes values to a Session and back.

    PythonFMU executes this file for every instance, so it contains only one class and its imports.  A step
    always succeeds: problems are reported by the output ``status`` and by one line in the log.
    """

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.session = Session(resources=self.resources, tell=self._warn)

    def enter_initialization_mode(self):
        self._do(self.session.initialise)

    def exit_initialization_mode(self):
        self._do(self.session.start)

    def do_step(self, current_time, step_size):
        try:
            self.session.step()
        except Exception as bug:
            self.log(f"internal error, please report it: {bug!r}", Fmi2Status.error, "logStatusError")
        return True

    def get_real(self, vrs):
        return self._do(self.session.get_reals, vrs)

    def set_real(self, vrs, values):
        self._do(self.session.set_reals, vrs, values)

    def get_integer(self, vrs):
        return self._do(self.session.get_integers, vrs)

    def set_integer(self, vrs, values):
        self._do(self.session.set_integers, vrs, values)

    def get_string(self, vrs):
        return self._do(self.session.get_strings, vrs)

    def set_string(self, vrs, values):
        self._do(self.session.set_strings, vrs, values)

    def _get_fmu_state(self):
        return self.session.snapshot()

    def _set_fmu_state(self, state):
        self._do(self.session.restore, state)

    @staticmethod
    def _fmu_state_to_bytes(state):
        return state

    @staticmethod
    def _fmu_state_from_bytes(state):
        return state

    def _warn(self, sentence):
        self.log(sentence, Fmi2Status.warning, "logStatusWarning")

    def _do(self, action, *arguments):
        """Run an action; if it is refused, report the reason in the log and on the console, and let the FMI
        call fail.

        PythonFMU releases its references to the class, the instance and its log when a call fails, and again
        when the instance is freed.  An additional reference to each keeps the instance alive.
        """
        try:
            return action(*arguments)
        except Exception as refusal:
            for held in (type(self), self, self.log_queue):
                ctypes.pythonapi.Py_IncRef(ctypes.py_object(held))
            self.log(str(refusal), Fmi2Status.error, "logStatusError")
            if sys.stderr:  # a host with logging off would show nothing
                print(f"{self.instance_name}: {refusal}", file=sys.stderr)
            raise
