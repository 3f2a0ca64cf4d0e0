"""Command line options, made from the table of variables, in display units: ``lateral_shift`` [m] becomes
``--lateral-shift-mm``, and the command receives the value in SI.  An option that is not given leaves the
package's default.
"""

import re
from functools import wraps
from inspect import Parameter, Signature, signature
from math import radians
from typing import Annotated

import typer

from ..interface.parameters import GEOMETRY as GEOMETRY_NAMES
from ..interface.parameters import LEFT, PARAMETERS
from ..interface.variables import BOOLEAN, INPUT, PARAMETER, REAL, UNITS, VARIABLES
from ..methods.words import did_you_mean
from ..results.words import unit_name
from ..status import distinct
from .door import Refused
from .groups import USUAL, WORDS, group_of, words_of

#: From display units to SI.  Division by a power of ten is correctly rounded; multiplication by 0.001 is not.
TO_SI = {
    "mm": lambda value: value / 1e3,
    "deg": radians,
    "kN": lambda value: value * 1e3,
    "MPa": lambda value: value * 1e6,
}
RATIO = "rail_inclination"


def number(text):
    """``text`` as a float; typer's BadParameter if it is not a number."""
    try:
        return float(text)
    except ValueError:
        comma = ", permitted is a point before the decimals" if re.fullmatch(r"\s*-?\d+,\d*\s*", text) else ""
        raise typer.BadParameter(f"{text!r} is not a number{comma}") from None


def ratio(text):
    """The slope of ``1:40``, ``1/40`` or ``0.025``."""
    try:
        rise, _, run = str(text).replace("/", ":").partition(":")
        return float(rise) / float(run or 1)
    except (ValueError, ZeroDivisionError):
        raise typer.BadParameter(
            f"{text!r} is neither a ratio such as 1:40 nor a slope such as 0.025"
        ) from None


#: Without roll_guess, which changes the cost of a result but never the result, and without switches.
POSE = [v for v in VARIABLES if v.causality == INPUT and v.type == REAL and v.name != "roll_guess"]
LOAD = [v for v in POSE if v.name != "lateral_shift"]
SYSTEM = [v for v in VARIABLES if v.causality == PARAMETER]
#: Profiles, track and wheelset, without materials and methods.
GEOMETRY = [
    v for v in SYSTEM if (v.keyword or v.name).removeprefix(LEFT) in ("wheel", "rail", *GEOMETRY_NAMES)
]


def takes(**groups):
    """Decorator that adds options for groups of variables to a command.

    ``@takes(pose=POSE, system=SYSTEM)`` calls the command with ``pose`` and ``system``, dicts of the SI
    values given, with the names of the arguments of :class:`~wrcontact.ContactSystem` and its ``evaluate``.
    """

    def decorate(command):
        @wraps(command)
        def with_options(**given):
            taken = {group: _values(variables, given) for group, variables in groups.items()}
            return command(**taken, **given)

        options = [_option(variable) for variables in groups.values() for variable in variables]
        own = [
            p.replace(kind=Parameter.KEYWORD_ONLY)
            for p in signature(command).parameters.values()
            if p.name not in groups
        ]
        with_options.__signature__ = Signature(options + own)
        with_options.__annotations__ = {p.name: p.annotation for p in options + own}
        return with_options

    return decorate


def name_of(variable):
    """The Python name of a variable: ``wheel`` for the FMU's ``wheel_profile``."""
    return variable.keyword or variable.name.replace(".", "_")


def option_of(variable):
    """The option of a variable, such as ``--nominal-radius-mm``; ``--roll-deg`` for ``roll_input``."""
    words = [
        name_of(variable).removesuffix("_input").replace("_", "-"),
        _display(variable).lower().replace(".", ""),
    ]
    return "--" + "-".join(word for word in words if word)


def _display(variable):
    """The display unit of a variable, which its option's name has; "" for names and other numbers."""
    return UNITS[variable.unit].display if variable.type == REAL else ""


def _unit(variable):
    """The unit of an option's value, which may be an SI unit; "" without one."""
    return unit_name(variable.unit) if variable.type == REAL else ""


def _option(variable):
    """The command's parameter for a variable; its default None means the package's default."""
    name, unit = name_of(variable), _unit(variable)
    row = PARAMETERS[name] if variable.causality == PARAMETER else None
    start = (
        f"{variable.start * UNITS[variable.unit].display_factor:g}"
        if variable.type == REAL
        else variable.start
    )
    if row and row.right:
        words, start = (
            f"{WORDS.get(row.right, row.right.replace('_', ' ').capitalize())}, on the left side",
            "as right",
        )
    else:
        words = words_of(name, variable, row and row.family)
    words += (f" [{unit}]" if unit else "") + f" (default: {start})"
    kind, reading = str, {"metavar": "|".join(row.family.names()) if row and row.family else "NAME"}
    if variable.type == REAL:
        kind, reading = float, {"metavar": "NUMBER", "parser": ratio if name.endswith(RATIO) else number}
    if variable.type == BOOLEAN:
        kind, reading, start = bool, {}, "no"
    option = typer.Option(
        option_of(variable),
        help=words,
        show_default=False,
        hidden=name not in USUAL,
        rich_help_panel=group_of(name),
        **reading,
    )
    return Parameter(name, Parameter.KEYWORD_ONLY, default=None, annotation=Annotated[kind | None, option])


def _values(variables, given):
    """Remove the options of ``variables`` from ``given``; return those that were given, by Python name, in
    SI."""
    typed = {variable: given.pop(name_of(variable)) for variable in variables}
    return {
        name_of(variable): _checked(variable, value) for variable, value in typed.items() if value is not None
    }


def _checked(variable, value):
    """The value of an option in SI; Refused, in the option's name and unit, if it is not permitted."""
    found, option = _in_si(variable, value), option_of(variable)
    if variable.causality != PARAMETER:  # an input's limits are those of a status
        return found
    family = PARAMETERS[name_of(variable)].family
    if family and value not in family.names():
        raise Refused(
            f"{option} is {value!r}; permitted are {', '.join(map(repr, family.names()))}"
            f"{did_you_mean(value, family.names())}"
        )
    known = PARAMETERS[PARAMETERS[name_of(variable)].right or name_of(variable)].number
    if known is not None and not known.low <= found <= known.high:
        unit = UNITS[variable.unit]
        low, high = (limit * unit.display_factor for limit in (known.low, known.high))
        text = distinct(value, high if value > high else low)
        words = f"{option} is {text}; permitted is {low:g} ... {high:g} {_unit(variable)}".rstrip()
        raise Refused(words + known.meant(value, unit.display_factor, _unit(variable)))
    return found


def _in_si(variable, value):
    return TO_SI.get(_display(variable), lambda same: same)(value)
