"""Words and sentences of the package in the names and units that the user typed: options in place of
keywords."""

import re

from ..interface.parameters import PARAMETERS
from ..interface.variables import INPUT_VARIABLES, REAL, UNITS, VARIABLES
from ..methods.numbers import UnusualValueWarning
from ..profiles.options import ENDINGS
from ..results.words import unit_name
from ..status import Terms, distinct


def name_of(variable):
    """The Python name of a variable: ``wheel`` for the FMU's ``wheel_profile``."""
    return variable.keyword or variable.name.replace(".", "_")


def option_of(variable):
    """The option of a variable, such as ``--nominal-radius-mm``; ``--roll-deg`` for ``roll_input``."""
    name, unit = name_of(variable).removesuffix("_input"), display_of(variable).lower().replace(".", "")
    return f"--{name.replace('_', '-')}{'-' if unit else ''}{unit}"


def display_of(variable):
    """The display unit of a variable, which its option's name has; "" for names and other numbers."""
    return UNITS[variable.unit].display if variable.type == REAL else ""


OPTIONS = {v.keyword: option_of(v) for v in VARIABLES if v.keyword in PARAMETERS} | {
    "smoothing": "--smoothing-um"
}
#: The same with inputs, for descriptions: of names that are no ordinary words.
DESCRIBED = {
    name: option
    for name, option in (OPTIONS | {v.name: option_of(v) for v in INPUT_VARIABLES.values()}).items()
    if "_" in name
}
#: Keywords that are ordinary words, too; they are keywords at the beginning of a sentence.
ORDINARY = ("wheel", "rail", "left_wheel", "left_rail", "load", "smoothing")
#: How sentences on a profile begin.
OF_PROFILE = re.compile("(?:left )?(wheel|rail) profile ")
#: Endings of sentences on what only Python has.
PYTHON = ", the path of a profile file, or a Profile"


class Typed(Terms):
    """Options such as ``--lateral-shift-mm``, and values in display units; ``aside`` has other names for
    inputs that the command has no option for."""

    def __init__(self, **aside):
        self.aside = aside

    def name(self, name):
        return self.aside.get(name) or option_of(INPUT_VARIABLES[name])

    def value(self, name, value, limit=float("nan")):
        unit, factor = INPUT_VARIABLES[name].unit, UNITS[INPUT_VARIABLES[name].unit].display_factor
        return f"{distinct(value * factor, limit * factor)} {unit_name(unit)}".rstrip()

    def length(self, value):
        return f"{value * 1e3:g} mm"


#: In a sweep the lateral shift is not an option of its own.
SWEEP = Typed(lateral_shift="lateral shift")


def typed(sentence):
    """A sentence of :class:`~wrcontact.ContactSystem` with options in place of its keywords."""
    sentence = sentence.replace("swap wheel and rail?", "swap --wheel and --rail?")
    of_profile = OF_PROFILE.match(sentence)
    if of_profile:
        return of_file(sentence, of_profile[1])
    for keyword, option in OPTIONS.items():
        first = "^" if keyword in ORDINARY else r"\b(?<![-'])"
        sentence = re.sub(rf"{first}{keyword}\b(?= is |[^\w'-]|$)", option, sentence)
    return sentence.replace(PYTHON, " and the path of a profile file")


def described(words):
    """The description of a variable or a method with options in place of the names of others."""
    words = re.sub(r"\bparameter (\w+)", lambda found: OPTIONS[found[1]], words)
    return re.sub(r"[\w.]*\w", lambda found: DESCRIBED.get(found[0], found[0]), words)


def of_file(sentence, kind):
    """A sentence on a file of this ``kind``, "wheel" or "rail", with the options that say how it is read."""
    for name, ending in ENDINGS.items():
        option = f"--{kind}-{ending}"
        for value, said in (("True", option), ("False", f"--no-{option[2:]}")):
            sentence = sentence.replace(f"{name} = {value}", said)
        sentence = sentence.replace(f"{name} is None", f"{option} is not given")
        sentence = re.sub(rf"(?<![\w-]){name} = ", f"{option} ", sentence)
        sentence = re.sub(rf"(?<![\w-]){name} is ", f"{option} is ", sentence)
    sentence = re.sub(r"\bsmoothing is\b", "--smoothing-um is", sentence)
    return re.sub(r"\b(rail_inclination|nominal_radius)\b", lambda found: OPTIONS[found[0]], sentence)


def remark_lines(remark):
    """The sentences of a warning, with options and display units in place of keywords and SI."""
    if not isinstance(remark, UnusualValueWarning):
        return [f"{remark.kind} profile {remark.name}: {of_file(one, remark.kind)}" for one in remark.remarks]
    factor, unit = UNITS[remark.unit].display_factor, unit_name(remark.unit)
    value, low, high = (f"{number * factor:g}" for number in (remark.value, *remark.usual))
    option, behind = (
        OPTIONS.get(remark.name) or option_of(INPUT_VARIABLES[remark.name]),
        f" {unit}" if unit else "",
    )
    return [f"{option} is {value}{behind}; usual is {low} ... {high}{behind}. It is used as it is."]
