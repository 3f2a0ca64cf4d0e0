"""The status of a step, and the sentence that explains it."""

import math
from enum import IntEnum

from .interface.friction import FRICTION, FRICTION_LIMIT
from .interface.inputs import INPUT_NAMES, INPUT_UNITS, INPUTS, LATERAL_LIMIT, ROLL_LIMIT, YAW_LIMIT
from .interface.rails import RAIL_LIMIT, RAIL_ROLL_LIMIT, RAILS
from .kernel import layout
from .kernel.wheelset.trial import DEEPEST
from .methods.numbers import unit_behind


class Status(IntEnum):
    """Outcome of a step; the FMU's ``status``."""

    VALID = layout.VALID
    UNLOADED = layout.UNLOADED            #: a wheel carries no load; geometry valid, its patch empty
    OFF_PROFILE = layout.OFF_PROFILE      #: contact beyond the profiles; no results
    NOT_CONVERGED = layout.NOT_CONVERGED  #: likewise
    INVALID_INPUT = layout.INVALID_INPUT  #: likewise

    def __str__(self):
        return str(int(self))  # as from Python 3.11 on


class Terms:
    """How a sentence names inputs and shows their values: names of Python and the FMUs, SI units."""

    def name(self, name):
        """The name of an input."""
        return name

    def value(self, name, value, limit=math.nan):
        """A value of an input with its unit, with as many digits as tell it from ``limit``."""
        return f"{distinct(value, limit)}{unit_behind(UNITS_BY_NAME[name])}"

    def length(self, value):
        """A length [m] with its unit."""
        return f"{value:g} m"


#: The end of sentences on steps that leave the outputs as they are.
KEPT = "; the outputs keep their last valid values"
RAIL_NAMES = tuple(row.name for row in RAILS)
UNITS_BY_NAME = dict(zip(INPUT_NAMES, INPUT_UNITS))


def distinct(value, limit):
    """``value`` as text with six digits, or with as many as it needs to differ from ``limit``."""
    texts = (f"{value:.{digits}g}" for digits in range(6, 18))
    return next((text for text in texts if abs(float(text)) != abs(limit) or value == limit), repr(value))


def explain(status, inputs, compliant=False, terms=None, held=False):
    """One sentence on a non-zero ``status`` that names the variable, its value and the limit; "" for VALID.

    ``inputs`` are those of the step, in the order of wrcontact/interface/inputs.py; ``compliant`` says
    whether the contact mode is compliant, ``terms`` how names and values are written, ``held`` whether to add
    that outputs of a failed step keep their values, as those of a stepper and an FMU do.
    """
    if status == Status.VALID:
        return ""
    kept = KEPT if held else ""
    said = _Sentence(terms or Terms(), dict(zip(INPUT_NAMES, map(float, inputs))))
    if status == Status.INVALID_INPUT:
        return f"{_invalid_input(said)}{kept}"
    if status == Status.UNLOADED:
        return _unloaded(said, compliant)
    if status == Status.OFF_PROFILE:
        return f"{_off_profile(said, compliant)}{kept}"
    pose = ", ".join(f"{said.name(name)} {said.value(name)}"
                     for name in ("lateral_shift", "yaw", "normal_force", "load_transfer"))
    return f"no solution at {pose} within the iteration limit{kept}"


class _Sentence:
    """Parts of a sentence on the ``inputs``, {name: value}."""

    def __init__(self, terms, inputs):
        self.terms, self.inputs, self.name = terms, inputs, terms.name

    def value(self, name, limit=math.nan):
        return self.terms.value(name, self.inputs[name], limit)

    def equals(self, name, limit=math.nan):
        return f"{self.name(name)} is {self.value(name, limit)}"

    def beyond(self, name, limit, why=""):
        """That an input exceeds the limit of its size."""
        return (f"{self.equals(name, limit)}{why}; permitted is |{self.name(name)}| <= "
                f"{self.terms.value(name, limit)}")


def _unloaded(said, compliant):
    if compliant:
        return (f"{said.equals('vertical_shift_input')} at {said.name('roll_input')} "
                f"{said.value('roll_input')}, so a wheel is lifted and carries no load; its patch is empty "
                f"(a larger {said.name('vertical_shift_input')} lowers the wheelset)")
    name = "normal_force" if said.inputs["normal_force"] == 0.0 else "load_transfer"
    return (f"{said.equals(name)}, so a wheel carries no load; its patch is empty (a load needs "
            f"{said.name('normal_force')} > {said.terms.value('normal_force', 0.0)} and "
            f"|{said.name('load_transfer')}| < 1)")


def _off_profile(said, compliant):
    shift, yaw, roll = (abs(said.inputs[name]) for name in ("lateral_shift", "yaw", "roll_input"))
    if shift > LATERAL_LIMIT:
        return said.beyond("lateral_shift", LATERAL_LIMIT, ", beyond the profiles")
    if yaw > YAW_LIMIT:
        return said.beyond("yaw", YAW_LIMIT, ", beyond the profiles")
    for name in RAIL_NAMES:
        limit = RAIL_ROLL_LIMIT if name.endswith("rail_roll") else RAIL_LIMIT
        if abs(said.inputs[name]) > limit:
            return said.beyond(name, limit)
    deepest = said.terms.length(DEEPEST)
    if compliant and roll > ROLL_LIMIT:
        return said.beyond("roll_input", ROLL_LIMIT)
    if compliant:
        return (f"{said.equals('vertical_shift_input')} and {said.name('roll_input')} "
                f"{said.value('roll_input')} at {said.name('lateral_shift')} {said.value('lateral_shift')}: "
                f"the contact leaves a profile, or a wheel is deeper in its rail than {deepest}")
    return (f"{said.equals('lateral_shift')} at {said.name('yaw')} {said.value('yaw')}: the smallest gap "
            "lies at the end of a profile, so there is no contact; or, in elastic contact, "
            f"{said.name('normal_force')} {said.value('normal_force')} with {said.name('load_transfer')} "
            f"{said.value('load_transfer')} presses a wheel deeper into its rail than {deepest}; permitted "
            "are poses with the contact inside both profiles")


def _invalid_input(said):
    """A clause on the first input that is not permitted."""
    for name in INPUT_NAMES:
        if not math.isfinite(said.inputs[name]):
            return f"{said.equals(name)}; permitted are finite numbers"
    for row in INPUTS:
        if row.limited and abs(said.inputs[row.name]) > row.maximum:
            return said.beyond(row.name, row.maximum)
    for row in FRICTION:
        if not 0.0 <= said.inputs[row.name] <= FRICTION_LIMIT:
            return (f"{said.equals(row.name, FRICTION_LIMIT)}; permitted is 0 <= {said.name(row.name)} <= "
                    f"{said.terms.value(row.name, FRICTION_LIMIT)}")
    if said.inputs["normal_force"] < 0.0:
        return (f"{said.equals('normal_force', 0.0)}; permitted is {said.name('normal_force')} >= "
                f"{said.terms.value('normal_force', 0.0)}")
    return (f"{said.equals('load_transfer', 1.0)}; permitted is -1 <= {said.name('load_transfer')} "
            "<= 1")
