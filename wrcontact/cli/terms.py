"""Sentences in the names and units that the user typed: options and display units."""

import re

from ..interface.parameters import PARAMETERS
from ..interface.units import UNITS
from ..interface.variables import INPUT, VARIABLES
from ..methods.numbers import UnusualValueWarning
from ..status import Terms, distinct
from .options import option_of

INPUTS = {v.name: v for v in VARIABLES if v.causality == INPUT}
OPTIONS = {v.keyword: option_of(v) for v in VARIABLES if v.keyword}


class Typed(Terms):
    """Options such as ``--lateral-shift-mm``, and values in display units; ``aside`` has other names for
    inputs that the command has no option for."""

    def __init__(self, **aside):
        self.aside = aside

    def name(self, name):
        return self.aside.get(name) or option_of(INPUTS[name])

    def value(self, name, value, limit=float("nan")):
        unit = UNITS[INPUTS[name].unit]
        text = distinct(value * unit.display_factor, limit * unit.display_factor)
        return f"{text} {unit.display}" if unit.display else text

    def length(self, value):
        return f"{value * 1e3:g} mm"


#: In a sweep the lateral shift is not an option of its own.
SWEEP = Typed(lateral_shift="lateral shift")


def typed(sentence):
    """A sentence of :class:`~wrcontact.ContactSystem` with options in place of its keywords."""
    for keyword, option in OPTIONS.items():
        first = "^" if keyword in ("wheel", "rail", "left_wheel", "left_rail", "load") else r"\b(?<![-'])"
        if keyword in PARAMETERS:
            sentence = re.sub(rf"{first}{keyword}\b(?= is |[^\w'-]|$)", option, sentence)
    return sentence


def remark_words(remark):
    """The text of a warning, with options and display units in place of keywords and SI."""
    if not isinstance(remark, UnusualValueWarning):
        return str(remark)
    unit = UNITS[remark.unit]
    value, low, high = (f"{number * unit.display_factor:g}" for number in (remark.value, *remark.usual))
    behind = f" {unit.display}" if unit.display else ""
    option = OPTIONS.get(remark.name) or option_of(INPUTS[remark.name])
    return f"{option} is {value}{behind}; usual is {low} ... {high}{behind}. It is used as it is."
