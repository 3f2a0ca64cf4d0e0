"""The status of a step, and the sentence that explains it."""

import math
from enum import IntEnum

from .interface.inputs import INPUT_NAMES, INPUT_UNITS, LATERAL_LIMIT, ROLL_LIMIT, YAW_LIMIT
from .kernel import layout
from .kernel.wheelset.trial import DEEPEST
from .methods.numbers import unit_behind


class Status(IntEnum):
    """Outcome of a step; the FMU's ``status``."""

    VALID = layout.VALID
    UNLOADED = layout.UNLOADED            #: a wheel carries no load; geometry valid, its patch empty
    OFF_PROFILE = layout.OFF_PROFILE      #: contact beyond the profiles; outputs keep the last valid values
    NOT_CONVERGED = layout.NOT_CONVERGED  #: likewise
    INVALID_INPUT = layout.INVALID_INPUT  #: likewise

    def __str__(self):
        return str(int(self))  # as from Python 3.11 on


def explain(status, inputs, compliant=False):
    """One sentence on a non-zero ``status`` that names the variable, its value and the limit; "" for VALID.

    ``inputs`` are those of the step, in the order of wrcontact/interface/inputs.py; ``compliant`` says
    whether the contact mode is compliant.
    """
    shift, yaw, _, force, transfer, height, roll = (float(value) for value in inputs)
    kept = "the outputs keep their last valid values"
    if status == Status.VALID:
        return ""
    if status == Status.INVALID_INPUT:
        return f"{_invalid_input(inputs)}; {kept}"
    if status == Status.UNLOADED and compliant:
        return (f"vertical_shift_input is {height:g} m at roll_input {roll:g} rad, so a wheel is lifted and "
                "carries no load; its patch is empty (a larger vertical_shift_input lowers the wheelset)")
    if status == Status.UNLOADED:
        name, value = ("normal_force", f"{force:g} N") if force == 0.0 else ("load_transfer", f"{transfer:g}")
        return (f"{name} is {value}, so a wheel carries no load; its patch is empty (a load needs "
                "normal_force > 0 N and |load_transfer| < 1)")
    if status == Status.OFF_PROFILE:
        if abs(shift) <= LATERAL_LIMIT and abs(yaw) > YAW_LIMIT:
            return f"yaw is {yaw:g} rad, beyond the profiles; permitted is |yaw| <= {YAW_LIMIT:g} rad; {kept}"
        if abs(shift) > LATERAL_LIMIT:
            return (f"lateral_shift is {shift:g} m, beyond the profiles; permitted is |lateral_shift| <= "
                    f"{LATERAL_LIMIT:g} m; {kept}")
        if compliant and abs(roll) > ROLL_LIMIT:
            return f"roll_input is {roll:g} rad; permitted is |roll_input| <= {ROLL_LIMIT:g} rad; {kept}"
        if compliant:
            return (f"vertical_shift_input is {height:g} m and roll_input {roll:g} rad at lateral_shift "
                    f"{shift:g} m: the contact leaves a profile, or a wheel is deeper in its rail than "
                    f"{DEEPEST:g} m; {kept}")
        return (f"lateral_shift is {shift:g} m at yaw {yaw:g} rad: the smallest gap lies at the end of a "
                f"profile, so there is no contact; or, in elastic contact, normal_force {force:g} N with "
                f"load_transfer {transfer:g} presses a wheel deeper into its rail than {DEEPEST:g} m; "
                f"permitted are poses with the contact inside both profiles; {kept}")
    return (f"no solution at lateral_shift {shift:g} m, yaw {yaw:g} rad, normal_force {force:g} N, "
            f"load_transfer {transfer:g} within the iteration limit; {kept}")


def _invalid_input(inputs):
    """A clause on the first input that is not permitted."""
    for name, unit, value in zip(INPUT_NAMES, INPUT_UNITS, inputs):
        if not math.isfinite(value):
            return f"{name} is {value}{unit_behind(unit)}; permitted are finite numbers"
    if inputs[layout.IN_NORMAL_FORCE] < 0.0:
        return f"normal_force is {inputs[layout.IN_NORMAL_FORCE]:g} N; permitted is normal_force >= 0 N"
    return f"load_transfer is {inputs[layout.IN_LOAD_TRANSFER]:g}; permitted is -1 <= load_transfer <= 1"
