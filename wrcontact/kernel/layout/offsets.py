"""Places of the records' fields as numbers, for what still reads the arrays by index;
computed from the records."""

from .interface import Inputs, Outputs, Parameters, PatchOutputs, SideOutputs
from .record import size
from .tables import Setup, Tables
from .wheelset import State
from .work import Work


def _offsets(prefix, kind):
    """{constant: place} of the fields of a record class."""
    return {f"{prefix}_{name.lstrip('_').upper()}": getattr(kind, name).offset // 8
            for name, _ in kind._fields_}


globals().update(_offsets("IN", Inputs))
globals().update(_offsets("OUT", Outputs))
globals().update(_offsets("SIDE", SideOutputs))
globals().update(_offsets("PATCH_OUTPUTS", PatchOutputs))
globals().update(_offsets("SET", Tables))
globals().update(_offsets("SETUP", Setup))
globals().update(_offsets("PARAMETERS", Parameters))
globals().update(_offsets("STATE", State))
globals().update(_offsets("WORK", Work))
OUT_RIGHT = OUT_LEFT + size(SideOutputs)  # noqa: F821
SIDE_SIZE, PATCH_OUTPUTS_SIZE = size(SideOutputs), size(PatchOutputs)
SET_PENETRATION_LEFT, SET_PENETRATION_RIGHT = SET_PENETRATION, SET_PENETRATION + 1  # noqa: F821
