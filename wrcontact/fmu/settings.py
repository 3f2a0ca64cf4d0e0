"""Start values of parameters that a build fixes, by their names in the FMU, for tools that cannot set
them."""

from ..interface.parameters import PARAMETERS
from ..interface.variables import PLACE, VARIABLES
from ..methods.numbers import check_choice
from ..methods.words import did_you_mean

ROWS = {row.fmu_name: row for row in PARAMETERS.values() if row.fmu_name}
#: Profiles are chosen, and packed, by arguments of their own.
SETTABLE = [name for name in ROWS if not name.endswith("_profile")]


def settings_of(words):
    """Values by name of texts such as "contact_mode=compliant".

    >>> settings_of(["contact_mode=compliant", "gauge=1.43"])
    {'contact_mode': 'compliant', 'gauge': 1.43}
    """
    found = {}
    for word in words:
        name, equals, value = (part.strip() for part in word.partition("="))
        if not equals:
            raise ValueError(f"{word!r} has no =; permitted is NAME=VALUE, such as contact_mode=compliant")
        if name in found:
            raise ValueError(f"{name} is set twice; permitted is once")
        found[name] = _number(name, value) if name in ROWS and ROWS[name].number is not None else value
    return checked(found)


def _number(name, value):
    if ROWS[name].number.switch:
        if value.lower() not in ("true", "false"):
            raise ValueError(f"{name} is {value!r}; permitted is true or false")
        return value.lower() == "true"
    try:
        return float(value)
    except ValueError:
        raise ValueError(f"{name} is {value!r}; permitted is a number, in SI units") from None


def checked(settings):
    """The ``settings``, each of which is permitted by itself; ValueError in a sentence where one is not."""
    for name, value in settings.items():
        if name in ROWS and name not in SETTABLE:
            raise ValueError(
                f"{name} is chosen by its own argument {ROWS[name].name}, which takes built-in names too"
            )
        if name not in ROWS:
            raise ValueError(
                f"{name} is not a parameter of the FMU; permitted are {', '.join(SETTABLE)}"
                f"{did_you_mean(name, SETTABLE)}"
            )
        if ROWS[name].family is not None:
            check_choice(name, value, VARIABLES[PLACE[name]].choices)
    keywords_of(settings)
    return dict(settings)


def keywords_of(settings):
    """The keywords of :class:`~wrcontact.ContactSystem` for ``settings``; those of the left side with 0 are
    as on the right."""
    return {
        ROWS[name].name: ROWS[name].checked(value)
        for name, value in settings.items()
        if not (ROWS[name].right and value == 0)
    }
