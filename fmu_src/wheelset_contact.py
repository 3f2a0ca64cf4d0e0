import math
import sys

from pythonfmu import Fmi2Slave
from pythonfmu.enums import Fmi2Status

from wrcontact.simulation.session import STATUS_REFERENCE, Refused, Session


class WheelsetContact(Fmi2Slave):
    """Wheelset on track as an FMI 2.0 co-simulation slave: passes values to a Session and back.

    PythonFMU executes this file for every instance, so it contains only one class and its imports.

    No exception reaches PythonFMU: it would return fmi2Fatal, and write to the log without a category, which
    ends some hosts.  A call that is refused changes nothing and gives one line in logStatusError.  PythonFMU
    knows no fmi2Error: such a call returns fmi2OK, and a step fmi2Discard with the wish to terminate.
    """

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.session = Session(resources=self.resources, log=self._warn)
        self.shown = None  # the sentence that the console shows last

    def setup_experiment(self, start_time, stop_time=None, tolerance=None):
        self._do(self.session.set_up, start_time, stop_time)

    def enter_initialization_mode(self):
        self._do(self.session.enter)

    def exit_initialization_mode(self):
        self._do(self.session.leave)

    def do_step(self, current_time, step_size):
        return self._do(self.session.step, current_time, step_size) is None

    def terminate(self):
        self._do(self.session.terminate)

    def get_real(self, vrs):
        return self._do(self.session.get_reals, vrs) or [math.nan] * len(vrs)

    def set_real(self, vrs, values):
        self._do(self.session.set_reals, vrs, values)

    def get_integer(self, vrs):
        return self._do(self.session.get_integers, vrs) or [4 if vr == STATUS_REFERENCE else 0 for vr in vrs]

    def set_integer(self, vrs, values):
        self._do(self.session.set_integers, vrs, values)

    def get_string(self, vrs):
        return self._do(self.session.get_strings, vrs) or [""] * len(vrs)

    def set_string(self, vrs, values):
        self._do(self.session.set_strings, vrs, values)

    def get_boolean(self, vrs):
        return self._do(self.session.get_booleans, vrs) or [False] * len(vrs)

    def set_boolean(self, vrs, values):
        self._do(self.session.set_booleans, vrs, values)

    def _get_fmu_state(self):
        return self._do(self.session.snapshot) or b""

    def _set_fmu_state(self, state):
        self._do(self.session.restore, state)

    @staticmethod
    def _fmu_state_to_bytes(state):
        return state

    @staticmethod
    def _fmu_state_from_bytes(state):
        return state

    def _do(self, action, *arguments):
        """What an action returns; False if it is refused, with the reason in the log and on the console.

        A host gets the log only with debug logging on, so the console has the sentence too; not again and
        again.
        """
        try:
            return action(*arguments)
        except Refused as refusal:
            sentence = str(refusal)
        except Exception as bug:
            sentence = f"internal error, please report it: {bug!r}"
        self._note(sentence, Fmi2Status.error, "logStatusError")
        if sys.stderr and sentence != self.shown:
            print(f"{self.instance_name}: {sentence}", file=sys.stderr)
            self.shown = sentence
        return False

    def _warn(self, sentence):
        self._note(sentence, Fmi2Status.warning, "logStatusWarning")

    def _note(self, sentence, status, category):
        """One line in the log, which is a format and has value references between number signs."""
        self.log(sentence.replace("%", "%%").replace("#", "##"), status, category)
