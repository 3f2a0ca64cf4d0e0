"""Start values of parameters and inputs that a build fixes, by their names in the FMU, for tools that cannot
set them."""

from ..interface import index
from ..interface.one_wheel import wheel_inputs
from ..interface.parameters import PARAMETERS
from ..interface.variables import PLACE, VARIABLES
from ..methods.numbers import check_choice
from ..methods.words import did_you_mean

#: Parameters by their names in the FMU.
ROWS = {row.fmu_name: row for row in PARAMETERS.values() if row.fmu_name}
#: Profiles are chosen, and packed, by arguments of their own.
SETTABLE = [name for name in ROWS if not name.endswith("_profile")]


def settings_of(words, side=None):
    """Values by name of texts such as "contact_mode=compliant"; ``side`` is that of one wheel, whose inputs
    have names of their own, or None.

    >>> settings_of(["contact_mode=compliant", "gauge=1.43", "speed=20"])
    {'contact_mode': 'compliant', 'gauge': 1.43, 'speed': 20.0}
    """
    inputs, found = inputs_of(side), {}
    for word in words:
        name, equals, value = (part.strip() for part in word.partition("="))
        if not equals:
            raise ValueError(f"{word!r} has no =; permitted is NAME=VALUE, such as contact_mode=compliant")
        if name in found:
            raise ValueError(f"{name} is set twice; permitted is once")
        found[name] = _value(name, value, inputs)
    return checked(found, side)


def inputs_of(side=None):
    """Rows of the inputs by the names that the FMU of a wheelset, or of one wheel on this ``side``, has for
    them."""
    return wheel_inputs(side) if side else index.ROWS


def _value(name, value, inputs):
    """A text as what the parameter or input of this name takes; as it is where there is none."""
    number = inputs.get(name) or (name in ROWS and ROWS[name].number)
    if not number:
        return value
    if number.switch:
        if value.lower() not in ("true", "false"):
            raise ValueError(f"{name} is {value!r}; permitted is true or false")
        return value.lower() == "true"
    try:
        return float(value)
    except ValueError:
        raise ValueError(f"{name} is {value!r}; permitted is a number, in SI units") from None


def checked(settings, side=None):
    """The ``settings``, each of which is permitted by itself; ValueError in a sentence where one is not."""
    inputs = inputs_of(side)
    for name, value in settings.items():
        if name in inputs:
            _check_input(name, value, inputs[name])
            continue
        if name in ROWS and name not in SETTABLE:
            raise ValueError(
                f"{name} is chosen by its own argument {ROWS[name].name}, which takes built-in names too"
            )
        if name not in ROWS:
            known = [*SETTABLE, *inputs]
            raise ValueError(
                f"{name} is not a parameter or input of the FMU; permitted are {', '.join(known)}"
                f"{did_you_mean(name, known)}"
            )
        if ROWS[name].family is not None:
            check_choice(name, value, VARIABLES[PLACE[name]].choices)
    keywords_of(settings)
    return dict(settings)


def _check_input(name, value, row):
    """ValueError where an input cannot start with this value."""
    if row.switch:
        if not isinstance(value, bool):
            raise ValueError(f"{name} is {value!r}; permitted is true or false")
        return
    if not (isinstance(value, (int, float)) and row.minimum <= value <= row.maximum):
        unit = "" if row.unit == "1" else f" {row.unit}"
        raise ValueError(f"{name} is {value!r}; permitted is {row.minimum:g} ... {row.maximum:g}{unit}")


def keywords_of(settings):
    """The keywords of :class:`~wrcontact.ContactSystem` for the parameters in ``settings``; those of the left
    side with 0 are as on the right."""
    return {
        ROWS[name].name: ROWS[name].checked(value)
        for name, value in settings.items()
        if name in ROWS and not (ROWS[name].right and value == 0)
    }
