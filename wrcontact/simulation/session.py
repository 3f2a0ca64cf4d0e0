"""The life cycle of one simulated wheelset, independent of FMI.

Set values, initialise, step, read. Values are addressed by value reference, as in FMI 2.0;
:mod:`.fmi_state_machine` says which call is permitted when::

    session = Session()
    session.set_reals([REFERENCE["rail_inclination"]], [1 / 20])
    session.start()
    session.set_reals([REFERENCE["lateral_shift"]], [5e-3])
    session.step()
    session.get_reals([REFERENCE["right.area"]])
"""

import hashlib
import json
import math

import numpy as np

from .. import status as outcomes
from ..interface.index import PROFILES
from ..interface.inputs import USUAL_LOAD
from ..interface.parameters import LEFT, RIGID_RAILS, SIDED
from ..interface.variables import (
    BOOLEAN,
    EQUILIBRIUM,
    FIRST_OUTPUT,
    FIRST_WEAR,
    INTEGER,
    OUTPUT,
    PARAMETER,
    PLACE,
    REAL,
    REFERENCE,
    STATUS,
    STRING,
    VARIABLES,
)
from ..kernel import layout
from ..methods.numbers import ALSO_RATIO, UnusualValueWarning, check_choice
from ..methods.words import PROPOSAL
from ..profiles.changing import is_sections, where_it_changes
from ..system import ContactSystem
from .fmi_state_machine import (
    INITIALISING,
    INSTANTIATED,
    RUNNING,
    TERMINATED,
    FmiStateMachine,
    Refused,
    refused,
)
from .resources import packed_profile

LOAD = layout.IN_NORMAL_FORCE
PARAMETERS = {v.name: v for v in VARIABLES if v.causality == PARAMETER}
BY_REFERENCE = {REFERENCE[v.name]: v for v in VARIABLES}
STATUS_REFERENCE = REFERENCE["status"]
#: Value references of what is computed only when it is read.
BALANCE = frozenset(REFERENCE[v.name] for v in VARIABLES[EQUILIBRIUM:FIRST_OUTPUT])
START = np.array(
    [v.start if v.type in (REAL, BOOLEAN) and v.start is not None else 0.0 for v in VARIABLES], dtype=float
)

#: First bytes of every saved state; the number changes with the format.
STATE_FORMAT = b"wrcontact state 3\n"
STATE_BODY = len(STATE_FORMAT) + hashlib.sha256().digest_size
#: A saved state belongs to one build: inside an FMU the package's name contains a hash of its contents.
BUILD = __name__.split(".")[0]


class Session:
    """One wheelset from its parameters to its outputs.

    Outputs are computed when they are first read after a change of the inputs, and then kept: a step with
    unchanged inputs costs nothing.  A physical situation is reported by ``status`` and by one call of
    ``log``.  A wrong call or value raises :class:`Refused`; then nothing has changed.

    Parameters
    ----------
    resources : folder with profile files, or None.
    log : called with one sentence for every step whose status is not 0.
    """

    def __init__(self, resources=None, log=print):
        self.resources = resources
        self.log = log
        self.evaluations = 0
        self.reset()

    def reset(self):
        """Back to the start values, before initialisation."""
        self.parameters = {name: variable.start for name, variable in PARAMETERS.items()}
        self.machine = FmiStateMachine()
        self._built_with = None  # the parameters that the stepper was built with
        self._stepper = None
        self._values = START.copy()  # by place in the table; strings live in ``parameters``
        self._stale = True  # an input has changed since the last evaluation
        self._balanced = False  # the equilibrium is that of the inputs
        self._balance = None  # a stepper that finds it
        self._logged = False  # this step's status has been logged
        self._remarked = False  # an unusual load has been logged
        self._asked = self._places = None  # the references of the last request for Reals, and their indices
        self._inputs = self._input_places = None  # the last list that was set, if all are inputs
        self._asked_integers = self._integer_places = None  # the same for Integers

    # --- parameters ------------------------------------------------------------------------------

    def set_strings(self, references, values):
        """Set the names of profiles and methods, all of them or none."""
        variables = self._settable(references, values, STRING)
        for variable, value in zip(variables, values, strict=True):
            self._set_parameter(variable, value)

    def get_strings(self, references):
        """The names of profiles and methods."""
        return [self.parameters[_variable(reference, STRING).name] for reference in references]

    def _settable(self, references, values, type):
        """The variables of a list, if every one of them can be set to its value."""
        variables = [_variable(reference, type) for reference in references]
        for variable, value in zip(variables, values, strict=True):
            if self.machine.phase == TERMINATED:
                raise refused("terminated", variable.name)
            if variable.causality == OUTPUT:
                raise refused("output", variable.name)
            if value is None:
                raise refused("null", variable.name)
            present = self.parameters.get(variable.name)
            if self.machine.locked and variable.causality == PARAMETER and value != present:
                raise refused("fixed", variable.name, repr(present), repr(value))
        return variables

    def _set_parameter(self, variable, value):
        """Store a parameter that can be set."""
        if value != self.parameters[variable.name]:
            self.parameters[variable.name] = value
            self._stale = True

    def set_up(self, start, stop=None):
        """Times of the first and of the last instant [s]; without ``stop`` there is no last one."""
        self.machine.set_up(start, stop)

    def initialise(self):
        """Build the contact system for the present parameters; :class:`Refused` if one is wrong."""
        if self._built_with != self.parameters:
            self._stepper, self._balance = self._build(self.parameters), None
            self._built_with = dict(self.parameters)
            self._values[FIRST_WEAR:STATUS] = 0.0
            self._stale = True

    def enter(self):
        """Enter initialisation mode, where outputs can be read and parameters can still be set."""
        self.machine.check_enter()
        self.initialise()
        self.machine.phase = INITIALISING

    def leave(self):
        """Leave it: compute the outputs of the first instant, and fix the parameters."""
        self.machine.check_leave()
        self.initialise()
        self.machine.phase = RUNNING
        self._refresh()
        self._logged = False

    def start(self):
        """Enter initialisation mode and leave it."""
        self.enter()
        self.leave()

    def terminate(self):
        """End the simulation: values can be read, and nothing else."""
        self.machine.terminate()

    def _build(self, parameters):
        """The kernel, prepared for these parameters."""
        arguments = {PARAMETERS[name].keyword: value for name, value in parameters.items()}
        for name in SIDED:
            arguments[LEFT + name] = arguments[LEFT + name] or None  # "" and 0 are as on the right
        try:
            for profile in PROFILES:
                if arguments[profile]:
                    if is_sections(arguments[profile]):
                        raise ValueError(
                            f"{profile}_profile is {arguments[profile]!r}, which changes {where_it_changes(arguments[profile])}; "
                            "permitted in an FMU are profiles that do not"
                        )
                    arguments[profile] = packed_profile(self.resources, profile, arguments[profile])
            for name, value in parameters.items():
                if PARAMETERS[name].choices:  # Python has more of them than an FMU
                    check_choice(name, value, PARAMETERS[name].choices)
            return ContactSystem(**arguments).stepper()
        except ValueError as wrong:  # as native FMUs have it: no proposals, and no texts for numbers
            raise Refused(str(wrong).partition(PROPOSAL)[0].removesuffix(ALSO_RATIO)) from None

    # --- inputs, outputs, steps ------------------------------------------------------------------

    def set_reals(self, references, values):
        """Set inputs and, before initialisation, parameters, all of them or none."""
        present = self._values
        if references != self._inputs or self.machine.phase == TERMINATED:
            self._settable(references, values, REAL)
            self._input_places = [_place(reference, REAL) for reference in references]
            only_inputs = all(place < layout.INPUT_COUNT for place in self._input_places)
            self._inputs = list(references) if only_inputs else None
        for place, value in zip(self._input_places, values, strict=True):
            if place >= layout.INPUT_COUNT:
                self._set_parameter(VARIABLES[place], value)
            if present[place] != value:
                present[place] = value
                self._stale = True

    def get_reals(self, references):
        """Real values, up to date with the inputs."""
        if references != self._asked:
            self._places = _as_slice([_place(reference, REAL) for reference in references])
            self._asked = list(references)
        if self.machine.phase == INSTANTIATED:
            _check_readable(references)
        self._refresh()
        if not self._balanced and any(reference in BALANCE for reference in references):
            self._find_equilibrium()
        return self._values[self._places].tolist()

    def set_integers(self, references, values):
        """Always :class:`Refused`: no Integer can be set."""
        self._settable(references, values, INTEGER)

    def get_integers(self, references):
        """Integer values, up to date with the inputs."""
        if references != self._asked_integers:
            self._integer_places = [_place(reference, INTEGER) for reference in references]
            self._asked_integers = list(references)
        if self.machine.phase == INSTANTIATED:
            _check_readable(references)
        self._refresh()
        values = self._values
        return [int(values[place]) for place in self._integer_places]

    def set_booleans(self, references, values):
        """Set switches, all of them or none."""
        variables = self._settable(references, values, BOOLEAN)
        for variable, reference, value in zip(variables, references, values, strict=True):
            place = _place(reference, BOOLEAN)
            if variable.causality == PARAMETER:
                self._set_parameter(variable, bool(value))
            if self._values[place] != bool(value):
                self._values[place] = bool(value)
                self._stale = True

    def get_booleans(self, references):
        """Values of switches."""
        return [bool(self._values[_place(reference, BOOLEAN)]) for reference in references]

    def step(self, time=None, size=0.0):
        """Update the outputs for a step of ``size`` [s] that begins at ``time`` [s], by default at the end of
        the last one; a status other than 0 is reported once per step."""
        time = self.machine.time if time is None else time
        self.machine.check_step(time, size)
        self._refresh()
        if self.status and not self._logged:
            self._log_status()
        self._logged = False
        self.machine.time = time + size

    @property
    def status(self):
        """Outcome of the last evaluation, 0 to 4."""
        return int(self._values[STATUS])

    def _refresh(self):
        """Evaluate if an input has changed since the last time; before initialisation there is nothing to
        evaluate."""
        if self._stale and self._stepper is not None:
            if not self.machine.locked:
                self.initialise()
            self._evaluate()

    def _evaluate(self):
        """One step of the kernel, and its outcome."""
        stepper, values = self._stepper, self._values
        stepper.inputs[:] = values[: layout.INPUT_COUNT]
        outcome = stepper.step()
        count = min(len(stepper.outputs), STATUS - FIRST_OUTPUT)  # strips are no variables
        values[FIRST_OUTPUT : FIRST_OUTPUT + count] = stepper.outputs[:count]
        values[STATUS] = outcome
        self._stale = self._balanced = False
        self.evaluations += 1
        self._remark_load()
        if self.parameters["contact_mode"] != "compliant":
            self._find_equilibrium()  # which costs nothing
        if outcome:
            self._log_status()

    def _remark_load(self):
        """Log once a load that is permitted but not usual, as after an error in its unit."""
        load = float(self._values[LOAD])
        if self._remarked or not 0.0 < load < math.inf or USUAL_LOAD[0] <= load <= USUAL_LOAD[1]:
            return
        if self.parameters["contact_mode"] != "compliant":
            self._remarked = True
            self.log(str(UnusualValueWarning("normal_force", load, "N", USUAL_LOAD)))

    def _find_equilibrium(self):
        """Height and roll at which the load is carried; where there are none the last ones stay."""
        if self._stepper is None:
            return
        values, found, outcome = self._values, self._stepper.outputs, 0
        if self.parameters["contact_mode"] == "compliant":
            if self._balance is None:
                self._balance = self._build({**self.parameters, **RIGID_RAILS, "contact_mode": "elastic"})
            self._balance.state[:] = 0.0
            self._balance.inputs[:] = values[: layout.INPUT_COUNT]
            outcome, found = self._balance.step(), self._balance.outputs
        if outcome <= outcomes.Status.UNLOADED:
            values[EQUILIBRIUM:FIRST_OUTPUT] = found[layout.OUT_VERTICAL_SHIFT], found[layout.OUT_ROLL]
        elif self.status <= outcomes.Status.UNLOADED:  # otherwise the step has logged why
            self.log("equilibrium: " + outcomes.explain(outcome, values[: layout.INPUT_COUNT], held=True))
        self._balanced = True

    def _log_status(self):
        self.log(
            outcomes.explain(
                self.status,
                self._values[: layout.INPUT_COUNT],
                self.parameters["contact_mode"] == "compliant",
                held=True,
            )
        )
        self._logged = True

    # --- saved states ----------------------------------------------------------------------------

    def snapshot(self):
        """The complete state of the simulation as bytes."""
        stepper = self._stepper
        header = {
            "build": BUILD,
            "parameters": self.parameters,
            "built": stepper is not None,
            "machine": self.machine.saved(),
            "stale": self._stale,
            "balanced": self._balanced,
            "logged": self._logged,
        }
        arrays = self._arrays(stepper)
        body = json.dumps(header).encode() + b"\n" + np.concatenate(arrays).astype("<f8").tobytes()
        return STATE_FORMAT + hashlib.sha256(body).digest() + body

    def restore(self, saved):
        """Restore a snapshot; :class:`Refused`, without any change, if ``saved`` is not one."""
        header, numbers = _read_snapshot(saved)
        stepper = self._stepper_for(header)
        arrays = self._arrays(stepper)
        expected = sum(array.size for array in arrays)
        if numbers.size != expected:
            raise Refused(
                f"the saved state holds {numbers.size} numbers, expected are {expected}; the "
                "present state is kept"
            )
        for array in arrays:
            array[:], numbers = numbers[: array.size], numbers[array.size :]
        if stepper is not self._stepper:
            self._balance = None
        self.parameters, self._stepper = header["parameters"], stepper
        self._built_with = dict(self.parameters) if stepper is not None else None
        self.machine = FmiStateMachine(*header["machine"])
        self._stale, self._logged, self._balanced = header["stale"], header["logged"], header["balanced"]

    def _arrays(self, stepper):
        """What a saved state holds of the session and its ``stepper``, which may be None."""
        return [self._values, *([] if stepper is None else [stepper.inputs, stepper.outputs, stepper.state])]

    def _stepper_for(self, header):
        """The stepper for a snapshot: the present one if the parameters are equal, otherwise a new one."""
        if not header["built"]:
            return None
        if header["parameters"] == self._built_with:
            return self._stepper
        return self._build(header["parameters"])


def _variable(reference, type):
    """The variable with this value reference, which must be of this type."""
    if reference not in BY_REFERENCE:
        raise refused("unknown", reference, 0, max(BY_REFERENCE))
    variable = BY_REFERENCE[reference]
    if variable.type != type:
        raise refused("type", variable.name, variable.type, type)
    return variable


def _place(reference, type):
    """The place in the table of the variable with this value reference, which must be of this type."""
    return PLACE[_variable(reference, type).name]


def _check_readable(references):
    """Whether the list, read before the initialisation, holds no output."""
    for reference in references:
        if BY_REFERENCE[reference].causality == OUTPUT:
            raise refused("unread", BY_REFERENCE[reference].name)


def _as_slice(places):
    """``places`` as an index of an array; consecutive places become a slice, which is faster."""
    if places and places == list(range(places[0], places[0] + len(places))):
        return slice(places[0], places[0] + len(places))
    return np.array(places, dtype=np.intp)


def _read_snapshot(saved):
    """Header and numbers of a snapshot, or :class:`Refused` with the reason."""
    if not saved.startswith(STATE_FORMAT):
        raise refused("other_state")
    if hashlib.sha256(saved[STATE_BODY:]).digest() != saved[len(STATE_FORMAT) : STATE_BODY]:
        raise refused("damaged_state")
    line, _, numbers = saved[STATE_BODY:].partition(b"\n")
    header = json.loads(line)
    if header["build"] != BUILD:
        raise Refused(
            f"the saved state comes from {header['build']}, this is {BUILD}; the present state is kept"
        )
    return header, np.frombuffer(numbers, dtype="<f8")
